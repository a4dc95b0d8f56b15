(* SPDX-License-Identifier: MIT *)
(* Soft fingers (FORMAT.md section 15): a contact in space that may have torsion, as a row whose slips have the turn about
   the normal as one number more.  `finger_seen`: every choice of a question has its row in the box. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root Box Slips Leaf RowsOfModels Ways Contacts Turned.
From Proved Require Rows Model SpaceModel BodiesModel.
Import ListNotations.

(* ---- The box ---- *)

Definition with_turn (fs : list (list Q)) : list (list Q) := fs ++ [(0 :: 0 :: 0 :: firstn 3 (N_of fs))%Q].

Definition soften (e : Q) (b : cbox) : cbox :=
  CBox (box_names b) (box_geometry b) (fun geometry => with_turn (box_forms b geometry)) (box_friction b)
    (box_preload b) (box_growth b) (box_stiffness b) (box_square b) (box_normal b)
    (box_weights b ++ [(e * e / box_square b)%Q]) (box_signed b) (box_spring b) (box_turns b) (box_slack b).

Definition enlarge_finger (bits : Z) (c : contact) : option cbox :=
  match enlarge bits c with
  | Some b =>
      if Qeq_bool (torsion c) 0 then Some b
      else if box_signed b || box_turns b then None else Some (soften (torsion c) b)
  | None => None
  end.

Section Proofs.
Open Scope R_scope.

Notation real := (map Q2R).
Notation finger := BodiesModel.finger.
Notation hard := BodiesModel.hard.
Notation gamma := BodiesModel.gamma.
Notation turn := BodiesModel.turn.

(* ---- The row ---- *)

Definition soft_row (c : R) (r : Rows.row) : Rows.row :=
  Rows.Row (Rows.N r) (Rows.slips r ++ [0 :: 0 :: 0 :: firstn 3 (Rows.N r)]) (Rows.weights r ++ [c]) (Rows.rho r)
    (Rows.preload r) (Rows.growth r) (Rows.stiffness r) (Rows.spring r).

Definition finger_row (t : finger) : Rows.row :=
  let r := space_contact_row (hard t) in
  if Req_EM_T (BodiesModel.torsion t) 0 then r else soft_row (gamma t) r.

Definition finger_to_row (t : finger) (force : R * S.vector * R) : Rows.force :=
  let '(a, f, m) := force in
  if Req_EM_T (BodiesModel.torsion t) 0 then (a, vector_list f) else (a, vector_list f ++ [m / gamma t]).

Definition finger_of_row (t : finger) (f : Rows.force) : R * S.vector * R :=
  (space_force (hard t) f, if Req_EM_T (BodiesModel.torsion t) 0 then 0 else gamma t * at_ (snd f) 3).

(* Its normal is not 0. *)
Definition is_finger (t : finger) : Prop := S.normal (hard t) <> S.zero.

Lemma soft_gamma t : is_finger t -> BodiesModel.torsion t <> 0 -> 0 < gamma t.
Proof.
  intros N E. unfold gamma. apply norm_positive in N. unfold S.norm in N. apply (proj1 (sqrt_positive _)) in N.
  apply Rmult_lt_0_compat; [|now apply Rinv_0_lt_compat].
  destruct (Rtotal_order (BodiesModel.torsion t) 0) as [H|[H|H]]; [nra|contradiction|nra].
Qed.

Lemma hard_gamma t : BodiesModel.torsion t = 0 -> gamma t = 0.
Proof. intros E. unfold gamma. rewrite E. unfold Rdiv. ring. Qed.

Lemma turn_is c d : Rows.dot (0 :: 0 :: 0 :: firstn 3 (screw_list (S.N c))) d = turn c (screw_of d).
Proof. unfold screw_list, S.N, S.force_at, turn, S.dot, screw_of. cbn [firstn S.linear]. dots. cbn. ring. Qed.

Lemma soft_slip t d : Rows.slip (soft_row (gamma t) (space_contact_row (hard t))) d =
  vector_list (S.slip (hard t) (screw_of d)) ++ [turn (hard t) (screw_of d)].
Proof.
  unfold Rows.slip. cbn [Rows.slips soft_row]. rewrite map_app. fold (Rows.slip (space_contact_row (hard t)) d).
  rewrite space_slip_is. cbn [map]. do 2 f_equal. apply turn_is.
Qed.

Lemma product_four c g s x : Rows.product ([1; 1; 1] ++ [c]) g (vector_list s ++ [x]) =
  S.dot (vector_of g) s + c * at_ g 3 * x.
Proof.
  unfold S.dot, vector_of, vector_list, at_. destruct g as [|g1 [|g2 [|g3 [|g4 g]]]]; cbn; ring.
Qed.

Lemma size_four c s x : Rows.size ([1; 1; 1] ++ [c]) (vector_list s ++ [x]) = sqrt (S.dot s s + c * (x * x)).
Proof. unfold Rows.size. rewrite product_four. f_equal. unfold vector_of, vector_list, S.dot, at_; cbn. ring. Qed.

Lemma four_positive c : 0 < c -> Rows.positive ([1; 1; 1] ++ [c]).
Proof. intros C. apply Forall_app. split; [apply three_positive|now repeat constructor]. Qed.

Lemma finger_works_as t f d :
  Rows.work (finger_row t) f d = BodiesModel.finger_works t (finger_of_row t f) (screw_of d).
Proof.
  unfold finger_row, finger_of_row, BodiesModel.finger_works. destruct f as [a g].
  unfold space_force at 1; cbn [fst snd].
  pose proof (space_work_is (hard t) (a, g) d) as E. unfold space_force in E; cbn [fst snd] in E. rewrite <- E.
  destruct (Req_EM_T _ 0) as [Z|Z]; [ring|].
  unfold Rows.work. rewrite soft_slip, space_slip_is. cbn [fst snd Rows.N Rows.weights soft_row space_contact_row].
  rewrite product_four, product_three. ring.
Qed.

Lemma sum_zero s c x : 0 < c -> S.dot s s + c * (x * x) <= 0 -> s = S.zero /\ x = 0.
Proof.
  intros C H. pose proof (dot_nonneg s). pose proof (Rle_0_sqr x) as X. unfold Rsqr in X.
  assert (0 <= c * (x * x)) by (apply Rmult_le_pos; lra).
  split; [apply no_length; lra|]. apply Rsqr_0_uniq. unfold Rsqr.
  apply Rmult_eq_reg_l with c; [lra|lra].
Qed.

Lemma finger_to l lambda d t f : is_finger t -> BodiesModel.finger_obeys l lambda (screw_of d) t f ->
  Rows.obeys l d 1 lambda (finger_row t) (finger_to_row t f) /\ finger_of_row t (finger_to_row t f) = f.
Proof.
  destruct f as [[a f] m]. intros Fi. unfold BodiesModel.finger_obeys.
  set (c := hard t). set (most := S.friction c * S.length c * a). set (s := S.slip c (screw_of d)).
  set (x := turn c (screw_of d)). set (slips := sqrt (S.dot s s + gamma t * (x * x))).
  intros (L & Fl & Fn & Cone & Diss). unfold finger_row, finger_to_row, finger_of_row. fold c.
  assert (M0 : 0 <= most) by (eapply Rle_trans; [apply norm_nonneg|exact Fn]).
  destruct (Req_EM_T (BodiesModel.torsion t) 0) as [Z|Z].
  - pose proof (hard_gamma t Z) as G. rewrite G in *.
    assert (m0 : m = 0) by nra. subst m. split.
    + change (a, vector_list f) with (space_row_force (a, f)). apply space_obeys_as_row.
      split; [exact L|]. split; [exact Fl|]. split; [exact Fn|]. intros NZ. apply norm_positive in NZ.
      assert (E : slips = S.norm s) by (unfold slips, S.norm; rewrite G; f_equal; ring).
      rewrite E in Diss. now destruct (Diss NZ).
    + unfold space_force; cbn. do 2 f_equal. destruct f. exact (across_idle _ _ Fl).
  - pose proof (soft_gamma t Fi Z) as G. split.
    + unfold Rows.obeys. rewrite soft_slip. fold c s x.
      cbn [Rows.weights Rows.rho soft_row space_contact_row]. rewrite !size_four. fold c most slips.
      split.
      * pose proof (space_v_is c d lambda) as V. unfold Rows.v in *.
        cbn [Rows.N Rows.preload Rows.growth Rows.stiffness soft_row space_contact_row] in *. rewrite V. exact L.
      * split.
        -- rewrite <- (sqrt_square most) by exact M0. apply sqrt_le_1_alt.
           apply Rmult_le_reg_l with (gamma t); [exact G|].
           replace (gamma t * (S.dot f f + gamma t * (m / gamma t * (m / gamma t)))) with (gamma t * S.dot f f + m * m)
             by (field; lra). exact Cone.
        -- rewrite product_four. change (vector_of (vector_list f ++ [m / gamma t])) with (S.Vector (S.x f) (S.y f) (S.z f)).
           change (at_ (vector_list f ++ [m / gamma t]) 3) with (m / gamma t).
           destruct (Rle_lt_or_eq_dec 0 slips (sqrt_pos _)) as [P|Z0].
           ++ destruct (Diss P) as [-> ->].
              assert (SQ : slips * slips = S.dot s s + gamma t * (x * x)).
              { apply sqrt_sqrt. pose proof (dot_nonneg s). pose proof (Rle_0_sqr x) as X. unfold Rsqr in X.
                assert (0 <= gamma t * (x * x)) by (apply Rmult_le_pos; lra). lra. }
              replace (S.dot (S.Vector (S.x (S.scale (- (most / slips)) s)) (S.y (S.scale (- (most / slips)) s))
                    (S.z (S.scale (- (most / slips)) s))) s + gamma t * (- (most / slips) * (gamma t * x) / gamma t) * x)
                with (- (most / slips) * (S.dot s s + gamma t * (x * x)))
                by (unfold S.dot, S.scale; cbn [S.x S.y S.z]; field; repeat split; lra).
              rewrite <- SQ. field. lra.
           ++ destruct (sum_zero s (gamma t) x G) as [-> ->].
              { apply Rnot_lt_le. intros Lt. apply sqrt_lt_R0 in Lt. fold slips in Lt. lra. }
              rewrite <- Z0. unfold S.dot, S.zero; cbn. ring.
    + cbn [snd]. unfold space_force; cbn [fst snd]. f_equal.
      * f_equal. change (vector_of (vector_list f ++ [m / gamma t])) with (S.Vector (S.x f) (S.y f) (S.z f)).
        destruct f. exact (across_idle _ _ Fl).
      * change (at_ (vector_list f ++ [m / gamma t]) 3) with (m / gamma t). field. lra.
Qed.

Lemma finger_of l lambda d t f : is_finger t -> Rows.obeys l d 1 lambda (finger_row t) f ->
  BodiesModel.finger_obeys l lambda (screw_of d) t (finger_of_row t f).
Proof.
  intros Fi. unfold finger_row, finger_of_row, BodiesModel.finger_obeys. set (c := hard t).
  destruct (Req_EM_T (BodiesModel.torsion t) 0) as [Z|Z].
  - intros O. apply space_obeys_is in O. pose proof (hard_gamma t Z) as G. rewrite G.
    destruct f as [a g]. unfold space_force in *; cbn [fst snd] in *. destruct O as (L & Fl & Fn & Diss).
    split; [exact L|]. split; [exact Fl|]. split; [exact Fn|]. split; [lra|]. intros P.
    assert (E : sqrt (S.dot (S.slip c (screw_of d)) (S.slip c (screw_of d)) + 0 * (turn c (screw_of d) * turn c (screw_of d))) =
      S.norm (S.slip c (screw_of d))) by (unfold S.norm; f_equal; ring).
    rewrite E in *. split; [|ring]. apply Diss. now apply norm_positive.
  - pose proof (soft_gamma t Fi Z) as G. destruct f as [a g].
    unfold space_force; cbn [fst snd]; cbv zeta. unfold Rows.obeys. rewrite soft_slip. fold c.
    set (s := S.slip c (screw_of d)). set (x := turn c (screw_of d)).
    cbn [Rows.weights Rows.rho soft_row space_contact_row]. rewrite size_four. fold c.
    set (most := S.friction c * S.length c * a). set (slips := sqrt (S.dot s s + gamma t * (x * x))).
    intros (L & Cone & Diss).
    pose proof (four_positive _ G) as W4.
    assert (M0 : 0 <= most) by (eapply Rle_trans; [apply Rows.size_nonneg|exact Cone]).
    assert (Sq : S.dot (vector_of g) (vector_of g) + gamma t * (at_ g 3 * at_ g 3) <= most * most).
    { pose proof (Rows.size_square _ g W4) as E. pose proof (Rows.size_nonneg ([1; 1; 1] ++ [gamma t]) g).
      assert (Rows.product ([1; 1; 1] ++ [gamma t]) g g = S.dot (vector_of g) (vector_of g) + gamma t * (at_ g 3 * at_ g 3)).
      { unfold S.dot, vector_of, at_. destruct g as [|g1 [|g2 [|g3 [|g4 g]]]]; cbn; ring. }
      rewrite <- H0, <- E. apply Rmult_le_compat; assumption. }
    assert (Sm : S.norm (across (S.normal c) (vector_of g)) * S.norm (across (S.normal c) (vector_of g)) <=
      S.dot (vector_of g) (vector_of g)).
    { rewrite <- norm_square. apply Rmult_le_compat; try apply norm_nonneg; apply norm_across. }
    assert (G0 : 0 <= gamma t * (at_ g 3 * at_ g 3)) by (apply Rmult_le_pos; [lra|apply Rle_0_sqr]).
    split; [|split; [|split; [|split]]].
    + pose proof (space_v_is c d lambda) as V. unfold Rows.v in *.
      cbn [Rows.N Rows.preload Rows.growth Rows.stiffness soft_row space_contact_row] in *. rewrite V in L. exact L.
    + apply dot_across.
    + apply Rnot_lt_le. intros Lt. assert (most * most < S.norm (across (S.normal c) (vector_of g)) *
        S.norm (across (S.normal c) (vector_of g))) by (apply Rmult_le_0_lt_compat; assumption). lra.
    + rewrite norm_square in Sm.
      replace (gamma t * at_ g 3 * (gamma t * at_ g 3)) with (gamma t * (gamma t * (at_ g 3 * at_ g 3))) by ring.
      assert (In_cone : gamma t * (S.dot (across (S.normal c) (vector_of g)) (across (S.normal c) (vector_of g)) +
        gamma t * (at_ g 3 * at_ g 3)) <= gamma t * (most * most)) by (apply Rmult_le_compat_l; lra).
      rewrite Rmult_plus_distr_l in In_cone. exact In_cone.
    + intros P.
      assert (P' : 0 < Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list s ++ [x])) by now rewrite size_four.
      assert (D' : Rows.product ([1; 1; 1] ++ [gamma t]) g (vector_list s ++ [x]) =
        - most * Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list s ++ [x])) by (rewrite size_four; exact Diss).
      pose proof (Rows.against_slip _ _ _ _ W4 Cone D' P') as A. rewrite size_four in A. fold slips in A.
      assert (Fs : S.dot s (S.normal c) = 0) by (unfold s; rewrite slip_across; apply dot_across).
      clear D' P' P Diss Cone Sq. clearbody slips. clearbody s x most.
      pose proof (A [1]) as A1. pose proof (A [0; 1]) as A2. pose proof (A [0; 0; 1]) as A3. pose proof (A [0; 0; 0; 1]) as A4.
      assert (E : vector_of g = S.scale (- (most / slips)) s).
      { unfold vector_of, S.scale, at_. destruct g as [|g1 [|g2 [|g3 [|g4 g]]]]; cbn in A1, A2, A3 |- *; f_equal; lra. }
      split.
      * rewrite E. apply across_idle.
        transitivity (- (most / slips) * S.dot s (S.normal c)); [unfold S.dot, S.scale; cbn [S.x S.y S.z]; ring|]. rewrite Fs. ring.
      * unfold at_. destruct g as [|g1 [|g2 [|g3 [|g4 g]]]]; cbn in A4 |- *; lra.
Qed.

(* ---- In boxes ---- *)

Lemma multiaffine_same n F F' : (forall p, List.length p = n -> F p = F' p) -> multiaffine n F -> multiaffine n F'.
Proof.
  revert F F'. induction n as [|n IH]; intros F F' E; cbn; [trivial|]. intros [A M]. split.
  - intros p L. destruct (A p L) as (a & b & H). exists a, b. intros x. rewrite <- E by (cbn; congruence). apply H.
  - intros x. apply (IH (fun p => F (x :: p))); [intros p L; apply E; cbn; congruence|apply M].
Qed.

Definition with_turn_real (fs : list (list R)) : list (list R) := fs ++ [0 :: 0 :: 0 :: firstn 3 (nth 0 fs [])].

Lemma dot_turn_form N d : Rows.dot (0 :: 0 :: 0 :: firstn 3 N) d = Rows.dot N (firstn 3 (skipn 3 d)).
Proof.
  assert (D : forall n f d, Rows.dot (firstn n f) d = Rows.dot f (firstn n d)).
  { induction n as [|n IH]; intros [|y f] [|x e]; cbn; try reflexivity. now rewrite IH. }
  destruct d as [|d1 [|d2 [|d3 d]]]; cbn [skipn]; try (cbn [Rows.dot firstn]; destruct N; cbn; ring).
  rewrite <- D. cbn [Rows.dot]. ring.
Qed.

Lemma soften_inside e c b r p F mu t : inside_at b r p F mu t -> box_signed b = false ->
  0 < c -> c = Q2R (e * e / box_square b) -> inside_at (soften e b) (soft_row c r) p (fun p => with_turn_real (F p)) mu t.
Proof.
  intros I Sg C E. pose proof (in_geometry _ _ _ _ _ _ I) as Geo. apply same_length in Geo.
  constructor; cbn [box_geometry box_forms box_friction box_square box_weights box_preload box_growth
      box_stiffness box_spring box_signed box_turns box_slack soften Rows.N Rows.slips Rows.rho Rows.weights
      Rows.preload Rows.growth Rows.stiffness Rows.spring soft_row]; try apply I; try congruence.
  - unfold with_turn_real. rewrite <- (is_forms _ _ _ _ _ _ I). reflexivity.
  - intros qs. unfold with_turn_real, with_turn, N_of. rewrite (forms_rational _ _ _ _ _ _ I), map_app. cbn [map].
    rewrite Q2R_0, <- firstn_map. do 6 f_equal. apply (map_nth real _ [] 0%nat).
  - intros j d. pose proof (forms_affine _ _ _ _ _ _ I) as Af.
    assert (Len : forall p', List.length p' = List.length (box_geometry b) -> List.length (F p') = List.length (F p)).
    { intros p' L. pose proof (forms_shape _ _ _ _ _ _ I p' p L (eq_sym Geo)) as Sh.
      apply (f_equal (@List.length _)) in Sh. now rewrite !map_length in Sh. }
    destruct (Nat.lt_ge_cases j (List.length (F p))) as [Lt|Ge].
    + eapply multiaffine_same; [|apply (Af j d)]. intros p' L. cbv beta. unfold with_turn_real.
      rewrite app_nth1; [reflexivity|]. now rewrite Len.
    + destruct (Nat.eq_dec j (List.length (F p))) as [->|Ne].
      * eapply multiaffine_same; [|apply (Af 0%nat (firstn 3 (skipn 3 d)))]. intros p' L. cbv beta. unfold with_turn_real.
        specialize (Len p' L). rewrite app_nth2 by lia. rewrite Len, Nat.sub_diag. cbn [nth]. symmetry. apply dot_turn_form.
      * eapply multiaffine_same; [|apply (Af j d)]. intros p' L. cbv beta. unfold with_turn_real.
        specialize (Len p' L). rewrite !nth_overflow; [reflexivity| |]; rewrite ?app_length; cbn; lia.
  - intros p1 p2 L1 L2. pose proof (forms_shape _ _ _ _ _ _ I p1 p2 L1 L2) as Sh. unfold with_turn_real.
    rewrite !map_app, Sh. cbn [map List.length]. do 5 f_equal. rewrite !firstn_length.
    apply (f_equal (fun l => nth 0 l 0%nat)) in Sh.
    change 0%nat with (List.length (@nil R)) in Sh at 2 4. rewrite !map_nth in Sh. now rewrite Sh.
  - rewrite map_app, (is_weights _ _ _ _ _ _ I). cbn [map]. now rewrite E.
  - apply Forall_app. split; [apply I|]. now constructor.
  - intros Sp. pose proof (spring_signed _ _ _ _ _ _ I Sg). congruence.
Qed.

Lemma space_square bits q b c : enlarge bits q = Some b -> chosen_contact_in_space q c -> box_turns b = false ->
  Q2R (box_square b) = S.dot (S.normal c) (S.normal c).
Proof.
  unfold enlarge. intros H ((x & y & z & nx & ny & nz & m & EP & EN & _ & _ & _ & Flat & TT & NT) & _) T.
  rewrite EP, EN in H. cbv zeta in H. set (n0 := vector_of_three nx ny nz) in *.
  destruct (numbers bits q _) as [[[p u] k]|]; [|discriminate].
  destruct (_ && _) in H; [discriminate|]. injection H as <-. cbn [box_turns box_square] in *.
  apply negb_false_iff, Qeq_bool_eq, Qeq_eqR in T. rewrite Q2R_0 in T. rewrite T in TT.
  assert (M : m = S.zero) by (apply no_length, Rle_antisym; [lra|apply dot_nonneg]).
  rewrite NT, M. unfold square_of, n0, vector_of_three, S.dot, S.add, S.zero; cbn.
  rewrite !Q2R_plus, !Q2R_mult. ring.
Qed.

Theorem finger_seen bits q t b : chosen_finger q t -> enlarge_finger bits q = Some b -> seen_in b (finger_row t).
Proof.
  intros (Ch & Et & NZ) H. unfold enlarge_finger in H. destruct (enlarge bits q) as [b'|] eqn:B; [|discriminate].
  pose proof (enlarge_space bits q b' (hard t) B Ch) as Se. unfold finger_row.
  destruct (Qeq_bool (torsion q) 0) eqn:Z.
  - injection H as <-. apply Qeq_bool_eq, Qeq_eqR in Z. rewrite Q2R_0 in Z.
    destruct (Req_EM_T _ 0) as [_|N]; [exact Se|]. exfalso. apply N. congruence.
  - destruct (box_signed b' || box_turns b') eqn:St; [discriminate|]. injection H as <-.
    apply orb_false_iff in St as [Sg Tn].
    assert (N : BodiesModel.torsion t <> 0).
    { intros E. rewrite E in Et. rewrite <- Q2R_0 in Et. apply eqR_Qeq in Et. symmetry in Et.
      apply Qeq_bool_iff in Et. congruence. }
    destruct (Req_EM_T _ 0) as [E|_]; [contradiction|].
    destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & st & I & _ & _ & Same). rewrite (Same Tn) in I.
    pose proof (soft_gamma t NZ N) as G. pose proof (space_square bits q b' (hard t) B Ch Tn) as Sq.
    assert (D0 : 0 < S.dot (S.normal (hard t)) (S.normal (hard t))).
    { apply norm_positive in NZ. unfold S.norm in NZ. now apply (proj1 (sqrt_positive _)) in NZ. }
    assert (E : gamma t = Q2R (torsion q * torsion q / box_square b')).
    { unfold gamma. rewrite <- Sq, Et, Q2R_div, Q2R_mult; [reflexivity|].
      intros Q. apply Qeq_eqR in Q. rewrite Q2R_0 in Q. lra. }
    apply inside_seen. eexists _, _, _, _. exact (soften_inside _ _ _ _ _ _ _ _ I Sg G E).
Qed.

End Proofs.
