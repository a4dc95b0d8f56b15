(* SPDX-License-Identifier: MIT *)
(* Witnesses in space (FORMAT.md section 3).  `witness_stable`: what is accepted is an equilibrium. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf Witness Margin.
From Proved Require Import SpaceBox SpaceLeaf.
From Proved Require Model SpaceModel.
Import ListNotations.

Module S := SpaceModel.

(* ---- Checking ---- *)

Definition exact_box (b : cbox) : bool :=
  certain (box_x b) && certain (box_y b) && certain (box_z b) && certain (box_friction b) &&
  certain (box_preload b) && certain (box_stiffness b).

(* A contact at a point: v and the slip up to positive factors; and its friction over mu a. *)
Record state := State { state_v : Z; state_slip : form; share : Q * Q * Q }.

Definition no_share : Q * Q * Q := (0, 0, 0)%Q.

Section Checker.
Open Scope Z_scope.

Definition exact_pull (r : row) : form := nth 0 (pull_tips r) [].
Definition exact_slip (r : row) (x : form) : form := slip_at (first_tip (geometry r)) x.

(* Across the normal, and not longer. *)
Definition share_fits (b : cbox) (s : Q * Q * Q) : bool :=
  let '(s1, s2, s3) := s in
  Qeq_bool (s1 * box_nx b + s2 * box_ny b + s3 * box_nz b) 0 &&
  Qle_bool (s1 * s1 + s2 * s2 + s3 * s3) (square b).

Fixpoint states (rows : list row) (x : form) (shares : list (Z * list Q)) (number : Z)
    : option (list state) :=
  match rows with
  | [] => match shares with [] => Some [] | _ => None end
  | r :: rows' =>
      let slip := exact_slip r x in
      let with_share s shares' :=
        match states rows' x shares' (number + 1) with
        | Some rest => Some (State (dot (exact_pull r) x) slip s :: rest)
        | None => None
        end in
      match shares with
      | (i, s) :: shares' =>
          if i =? number then
            match s with
            | [s1; s2; s3] =>
                if all_zero slip && share_fits (box r) (s1, s2, s3)
                then with_share (s1, s2, s3) shares' else None
            | _ => None
            end
          else with_share no_share shares
      | [] => with_share no_share []
      end
  end.

(* Of a contact that slips, the share -L s / |s|, if L / |s| is rational. *)
Definition sliding_share (b : cbox) (slip : form) : option (Q * Q * Q) :=
  match slip with
  | [s1; s2; s3] =>
      let ss := dot slip slip in
      let root := low (root_between 64 (reduced (square b / inject_Z ss)%Q)) in
      let of_slip s := reduced (- root * inject_Z s)%Q in
      let s := (of_slip s1, of_slip s2, of_slip s3) in
      if (0 <? ss) && Qle_bool 0 root && Qeq_bool (root * root * inject_Z ss) (square b) &&
         share_fits b s
      then Some s else None
  | _ => None
  end.

Fixpoint with_roots (rows : list row) (ss : list state) : option (list state) :=
  match rows, ss with
  | r :: rows', s :: ss' =>
      match with_roots rows' ss' with
      | None => None
      | Some rest =>
          if all_zero (state_slip s) then Some (s :: rest)
          else if (state_v s <=? 0) || Qeq_bool (low (box_friction (box r))) 0
          then Some (State (state_v s) (state_slip s) no_share :: rest)
          else match sliding_share (box r) (state_slip s) with
               | Some sh => Some (State (state_v s) (state_slip s) sh :: rest)
               | None => None
               end
      end
  | [], [] => Some []
  | _, _ => None
  end.

(* That of the force a (n + mu share). *)
Definition contact_wrench (r : row) (s : state) : list Q :=
  if state_v s <=? 0 then []
  else
    let b := box r in
    let a := Qmake (state_v s * times (pull_scale r)) (Z.to_pos (over (pull_scale r))) in
    let mu := low (box_friction b) in
    let '(s1, s2, s3) := share s in
    map (fun c => reduced (a * c)%Q)
      (at_point (low (box_x b)) (low (box_y b)) (low (box_z b)) (box_nx b + mu * s1)%Q
         (box_ny b + mu * s2)%Q (box_nz b + mu * s3)%Q).

Fixpoint contact_wrenches (rows : list row) (ss : list state) : list (list Q) :=
  match rows, ss with
  | r :: rows', s :: ss' => contact_wrench r s :: contact_wrenches rows' ss'
  | _, _ => []
  end.

(* So they do; checked again rather than proved. *)
Fixpoint shares_fit (rows : list row) (ss : list state) : bool :=
  match rows, ss with
  | r :: rows', s :: ss' => share_fits (box r) (share s) && shares_fit rows' ss'
  | _, _ => true
  end.

(* The rule that fails. *)
Definition witness_fails (two_sided : bool) (rows : list row) (ld : load) (w : witness)
    : option string :=
  let x := integer_point (Point (Some 0%Q) w) in
  match x with
  | [_; _; _; _; _; _; h; l] =>
      match states rows x (shares w) 0 with
      | None => Some "witness-share"%string
      | Some ss =>
          if two_sided && negb (forallb (fun s => 0 <=? state_v s) ss)
          then Some "witness-normal"%string
          else match with_roots rows ss with
               | None => Some "witness-root"%string
               | Some ss =>
                   if shares_fit rows ss &&
                      adds_up_to_zero (load_at ld h l :: contact_wrenches rows ss) then None
                   else Some "witness-balance"%string
               end
      end
  | _ => Some "witness-balance"%string
  end.

Definition is_one_grasp (rows : list row) (ld : load) : bool :=
  forallb (fun r => exact_box (box r)) rows && forallb certain (load_box ld).

End Checker.

(* ---- Proofs ---- *)

Section Motion.
Open Scope R_scope.

(* The motion t (x1, ..., x6) of a point in integers. *)
Variables x1 x2 x3 x4 x5 x6 h l : Z.
Let xz := [x1; x2; x3; x4; x5; x6; h; l].
Variable t : R.
Hypothesis t_positive : 0 < t.
Hypothesis h_is : t * IZR h = 1.
Hypothesis l_is : t * IZR l = 0.
Let d := S.Screw (S.Vector (t * IZR x1) (t * IZR x2) (t * IZR x3))
                 (S.Vector (t * IZR x4) (t * IZR x5) (t * IZR x6)).

Lemma rdot_d f : rdot f (located d 1 0) = t * IZR (dot f xz).
Proof.
  assert (G : forall f (y : list Z), rdot f (map (fun z => t * IZR z) y) = t * IZR (dot f y)).
  { clear. induction f as [|z f IH]; intros [|w y]; cbn; try ring.
    rewrite IH, plus_IZR, mult_IZR. ring. }
  rewrite <- G. unfold located, xz, d. cbn [map S.x S.y S.z S.linear S.angular].
  now rewrite h_is, l_is.
Qed.

Section Exact.

Variable row : row.
Variable c : S.contact.
Hypothesis F : fits row c.
Hypothesis X : exact_box (box row) = true.

Lemma inside_it : inside (box row) c.
Proof. apply F. Qed.

Lemma exact_shares : shares_in (box row) c = [].
Proof.
  unfold exact_box in X. rewrite !andb_true_iff in X. destruct X as [[[[[Hx Hy] Hz] _] _] _].
  unfold shares_in, share. unfold Numbers.share. now rewrite Hx, Hy, Hz.
Qed.

Lemma exact_tips : exists f, pull_tips row = [f].
Proof.
  destruct F as [E _]. rewrite E. unfold exact_box in X. rewrite !andb_true_iff in X.
  destruct X as [[[[[Hx Hy] Hz] _] Hp] Hk].
  unfold pull_tips. cbn [pulls make_row]. unfold pull_ends, ends. rewrite Hp, Hk.
  cbn [flat_map map app]. unfold pull_tree, corners, spread. rewrite Hx, Hy, Hz. cbn. eauto.
Qed.

Lemma exact_v lambda m :
  S.v c lambda m = unit (pull_scale row) * rdot (exact_pull row) (located m 1 lambda).
Proof.
  destruct exact_tips as (f & Ef). pose proof F as [E I].
  assert (PS : pull_scale row = pull_scaling (box row)) by (rewrite E at 1; reflexivity).
  rewrite PS. unfold exact_pull. rewrite Ef. cbn [nth].
  assert (A : forall factor, factor * S.v c lambda m <=
    factor * (unit (pull_scaling (box row)) * rdot f (located m 1 lambda))).
  { intros k. apply (v_bound m lambda (box row) c I). intros g Hg. rewrite <- E, Ef in Hg.
    destruct Hg as [<-|[]]. lra. }
  pose proof (A 1). pose proof (A (-1)). lra.
Qed.

Lemma exact_slip_is m h1 l1 j : (j < 3)%nat ->
  component j (S.slip c m) = unit (scaling_of_geometry (box row)) *
    rdot (nth (Datatypes.S j) (first_tip (geometry row)) []) (located m h1 l1).
Proof.
  intros J. pose proof F as [E I]. rewrite (slip_corners (box row) c I j m h1 l1 J).
  rewrite exact_shares, eval_first, <- E. reflexivity.
Qed.

Lemma exact_friction : S.friction c = Q2R (low (box_friction (box row))).
Proof.
  unfold exact_box in X. rewrite !andb_true_iff in X. destruct X as [[[[[_ _] _] Hf] _] _].
  apply certain_within; [exact Hf | apply inside_it].
Qed.

Definition share_vector (s : Q * Q * Q) : S.vector :=
  let '(s1, s2, s3) := s in vector_of_three s1 s2 s3.

Definition force_of (s : state) : R * S.vector :=
  let a := if (state_v s <=? 0)%Z then 0 else t * (unit (pull_scale row) * IZR (state_v s)) in
  (a, S.scale (S.friction c * a) (share_vector (share s))).

Definition is_state (s : state) : Prop :=
  state_v s = dot (exact_pull row) xz /\ state_slip s = exact_slip row xz /\
  share_fits (box row) (share s) = true.

Definition has_root (s : state) : Prop :=
  all_zero (state_slip s) = true \/ (state_v s <= 0)%Z \/ S.friction c = 0 \/
  exists root s1 s2 s3, 0 <= root /\ state_slip s = [s1; s2; s3] /\
    root * root * IZR (dot [s1; s2; s3] [s1; s2; s3]) = Q2R (square (box row)) /\
    (0 < dot [s1; s2; s3] [s1; s2; s3])%Z /\
    share_vector (share s) = S.Vector (- root * IZR s1) (- root * IZR s2) (- root * IZR s3).

Lemma state_obeys (two_sided : bool) s : is_state s -> has_root s ->
  (two_sided = true -> 0 <= state_v s)%Z ->
  S.obeys (if two_sided then Model.bilateral else Model.unilateral) 0 d c (force_of s).
Proof.
  intros (V & SL & Fit) Root B. pose proof inside_it as I.
  assert (U : 0 < unit (pull_scale row)).
  { destruct F as [E _]. rewrite E. apply unit_positive. }
  assert (EV : S.v c 0 d = t * (unit (pull_scale row) * IZR (state_v s)))
    by (rewrite exact_v, rdot_d, V; ring).
  assert (A : (if (state_v s <=? 0)%Z then 0 else t * (unit (pull_scale row) * IZR (state_v s)))
              = Rmax 0 (S.v c 0 d)).
  { rewrite EV. destruct (Z.leb_spec (state_v s) 0) as [H|H].
    - apply IZR_le in H. rewrite Rmax_left; [reflexivity|].
      assert (0 <= t * (unit (pull_scale row) * - IZR (state_v s))).
      { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. } lra.
    - apply IZR_lt in H. rewrite Rmax_right; [reflexivity|].
      apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. }
  unfold S.obeys, force_of. rewrite A. set (a := Rmax 0 (S.v c 0 d)).
  assert (A0 : 0 <= a) by apply Rmax_l.
  pose proof (friction_nonneg _ _ I) as M0. pose proof (length_positive _ _ I) as LP.
  pose proof (length_square _ _ I) as LS. set (mu := S.friction c) in *.
  unfold share_fits in Fit. destruct (share s) as [[q1 q2] q3] eqn:Sh.
  apply andb_true_iff in Fit as [F1 F2]. apply Qeq_bool_eq, Qeq_eqR in F1. apply Qle_bool_R in F2.
  rewrite !Q2R_plus, !Q2R_mult in F1, F2. rewrite Q2R_0 in F1.
  split; [|split; [|split]].
  - destruct two_sided; cbn; [|reflexivity]. specialize (B eq_refl). apply IZR_le in B.
    assert (0 <= S.v c 0 d).
    { rewrite EV. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; lra. }
    unfold a. rewrite Rmax_right by assumption. split; [reflexivity|assumption].
  - rewrite (is_normal _ _ I). unfold S.dot, S.scale, share_vector, vector_of_three; cbn.
    transitivity (mu * a * (Q2R q1 * Q2R (box_nx (box row)) + Q2R q2 * Q2R (box_ny (box row)) +
                            Q2R q3 * Q2R (box_nz (box row)))); [ring|]. rewrite F1. ring.
  - assert (P : 0 <= mu * a) by (apply Rmult_le_pos; assumption).
    unfold S.norm. rewrite <- (sqrt_square (mu * S.length c * a)).
    2:{ apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact A0]. }
    apply sqrt_le_1_alt. unfold S.dot, S.scale, share_vector, vector_of_three; cbn.
    replace (mu * S.length c * a * (mu * S.length c * a))
      with (mu * a * (mu * a) * (S.length c * S.length c)) by ring. rewrite LS.
    replace (mu * a * Q2R q1 * (mu * a * Q2R q1) + mu * a * Q2R q2 * (mu * a * Q2R q2) +
             mu * a * Q2R q3 * (mu * a * Q2R q3))
      with (mu * a * (mu * a) * (Q2R q1 * Q2R q1 + Q2R q2 * Q2R q2 + Q2R q3 * Q2R q3)) by ring.
    apply Rmult_le_compat_l; [apply Rmult_le_pos; assumption|exact F2].
  - intros NZ.
    assert (Zero : mu * a = 0 ->
      S.scale (mu * a) (share_vector (q1, q2, q3)) =
      S.scale (- (mu * S.length c * a / S.norm (S.slip c d))) (S.slip c d)).
    { intros Z. replace (mu * S.length c * a) with (S.length c * (mu * a)) by ring. rewrite Z.
      unfold S.scale, Rdiv; f_equal; ring. }
    destruct Root as [Z|[Z|[Z|(root & s1 & s2 & s3 & R0 & SE & RE & SP & ShE)]]].
    + exfalso. apply NZ. rewrite SL in Z. unfold exact_slip, slip_at in Z.
      unfold all_zero in Z. cbn [forallb] in Z. rewrite !andb_true_iff in Z.
      destruct Z as (Z1 & Z2 & Z3 & _). apply Z.eqb_eq in Z1, Z2, Z3.
      pose proof (exact_slip_is d 1 0 0 ltac:(lia)) as C1.
      pose proof (exact_slip_is d 1 0 1 ltac:(lia)) as C2.
      pose proof (exact_slip_is d 1 0 2 ltac:(lia)) as C3.
      rewrite rdot_d in C1, C2, C3. rewrite <- Z1 in C1. rewrite <- Z2 in C2. rewrite <- Z3 in C3.
      cbn [component] in *. rewrite Rmult_0_r, Rmult_0_r in C1, C2, C3.
      destruct (S.slip c d). cbn in *. unfold S.zero. congruence.
    + apply Zero. assert (a = 0); [|subst; rewrite H; ring].
      unfold a. rewrite <- A. apply Z.leb_le in Z. now rewrite Z.
    + apply Zero. fold mu in Z. rewrite Z. ring.
    + rewrite Sh in ShE. rewrite ShE. clear Zero.
      set (g := unit (scaling_of_geometry (box row))).
      assert (G : 0 < g) by apply unit_positive.
      pose proof (exact_slip_is d 1 0 0 ltac:(lia)) as C1.
      pose proof (exact_slip_is d 1 0 1 ltac:(lia)) as C2.
      pose proof (exact_slip_is d 1 0 2 ltac:(lia)) as C3.
      rewrite rdot_d in C1, C2, C3. cbn [component] in *. fold g in C1, C2, C3.
      rewrite SL in SE. unfold exact_slip, slip_at in SE. injection SE as E1 E2 E3.
      assert (D1 : S.x (S.slip c d) = g * t * IZR s1) by (rewrite C1, <- E1; cbn; ring).
      assert (D2 : S.y (S.slip c d) = g * t * IZR s2) by (rewrite C2, <- E2; cbn; ring).
      assert (D3 : S.z (S.slip c d) = g * t * IZR s3) by (rewrite C3, <- E3; cbn; ring).
      apply IZR_lt in SP. set (ss := IZR (dot [s1; s2; s3] [s1; s2; s3])) in *.
      assert (SSE : ss = IZR s1 * IZR s1 + IZR s2 * IZR s2 + IZR s3 * IZR s3)
        by (unfold ss; cbn [dot]; rewrite !plus_IZR, !mult_IZR; ring).
      assert (GT : 0 < g * t) by (apply Rmult_lt_0_compat; assumption).
      assert (NE : S.norm (S.slip c d) = g * t * sqrt ss).
      { unfold S.norm, S.dot. rewrite D1, D2, D3.
        replace (g * t * IZR s1 * (g * t * IZR s1) + g * t * IZR s2 * (g * t * IZR s2) +
                 g * t * IZR s3 * (g * t * IZR s3)) with (g * t * (g * t) * ss) by (rewrite SSE; ring).
        rewrite sqrt_mult_alt by (apply Rmult_le_pos; lra). rewrite sqrt_square by lra. reflexivity. }
      assert (SQ : 0 < sqrt ss) by now apply sqrt_lt_R0.
      assert (LE : S.length c = root * sqrt ss).
      { rewrite <- (sqrt_square (S.length c)), LS, <- RE by lra.
        rewrite sqrt_mult_alt by (apply Rmult_le_pos; lra). now rewrite sqrt_square by exact R0. }
      rewrite NE, LE. unfold S.scale; cbn [S.x S.y S.z]. rewrite D1, D2, D3. f_equal; field; lra.
Qed.

Definition six_of (w : list Q) : S.screw :=
  match w with
  | [a; b; e; f; g; k] => S.Screw (vector_of_three a b e) (vector_of_three f g k)
  | _ => S.no_screw
  end.

Lemma contact_wrench_is s :
  S.scale_screw t (six_of (contact_wrench row s)) = S.contact_wrench c (force_of s) /\
  (List.length (contact_wrench row s) = 0 \/ List.length (contact_wrench row s) = 6)%nat.
Proof.
  pose proof inside_it as I. unfold contact_wrench, force_of.
  destruct (share s) as [[q1 q2] q3]. destruct (Z.leb_spec (state_v s) 0) as [V|V].
  - split; [|now left].
    unfold S.scale_screw, S.contact_wrench, S.force_at, S.cross, S.add, S.scale, S.no_screw, S.zero; cbn.
    f_equal; f_equal; ring.
  - split; [|right; reflexivity]. pose proof exact_friction as Mu.
    assert (OP : (0 < over (pull_scale row))%Z).
    { destruct F as [E _]. rewrite E. apply common_denominator_positive. }
    assert (X' := X). unfold exact_box in X'.
    rewrite !andb_true_iff in X'. destruct X' as [[[[[Hx Hy] Hz] _] _] _].
    pose proof (certain_within _ _ Hx (in_x _ _ I)) as Ex.
    pose proof (certain_within _ _ Hy (in_y _ _ I)) as Ey.
    pose proof (certain_within _ _ Hz (in_z _ _ I)) as Ez.
    assert (A : Q2R (state_v s * times (pull_scale row) # Z.to_pos (over (pull_scale row)))
                = unit (pull_scale row) * IZR (state_v s)).
    { unfold Q2R, unit; cbn [Qnum Qden]. rewrite Z2Pos.id, mult_IZR by exact OP. field.
      apply IZR_lt in OP. lra. }
    unfold at_point. cbn [map six_of]. unfold vector_of_three. rewrite !reduced_same.
    repeat rewrite ?Q2R_mult, ?Q2R_plus, ?Q2R_minus. rewrite A, <- Mu.
    unfold S.scale_screw, S.contact_wrench, S.force_at, S.cross, S.add, S.scale; cbn.
    rewrite (is_normal _ _ I), Ex, Ey, Ez. unfold vector_of_three; cbn. f_equal; f_equal; ring.
Qed.

End Exact.

Definition short_list (w : list Q) := (List.length w = 0 \/ List.length w = 6)%nat.

Lemma adds_up ws : Forall short_list ws -> adds_up_to_zero ws = true ->
  S.sum (map six_of ws) = S.no_screw.
Proof.
  intros L Z. rewrite Forall_forall in L. set (q w k := Q2R (nth k w 0%Q)).
  assert (E : forall w, In w ws ->
    six_of w = S.Screw (S.Vector (q w 0%nat) (q w 1%nat) (q w 2%nat)) (S.Vector (q w 3%nat) (q w 4%nat) (q w 5%nat))).
  { intros w Hw. destruct w as [|? [|? [|? [|? [|? [|? [|? ?]]]]]]]; destruct (L _ Hw); try discriminate;
      [|reflexivity]. unfold q; cbn. now rewrite RMicromega.Q2R_0. }
  assert (Entry := fun k pick => entry_adds_up S.add_screw S.no_screw six_of pick k ws Z).
  assert (X1 := Entry 0%nat (fun s => S.x (S.linear s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (X2 := Entry 1%nat (fun s => S.y (S.linear s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (X3 := Entry 2%nat (fun s => S.z (S.linear s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (X4 := Entry 3%nat (fun s => S.x (S.angular s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (X5 := Entry 4%nat (fun s => S.y (S.angular s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (X6 := Entry 5%nat (fun s => S.z (S.angular s)) ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  unfold S.sum. destruct (fold_right _ _ _) as [[? ? ?] [? ? ?]]. cbn in *.
  unfold S.no_screw, S.zero. congruence.
Qed.

Inductive all_good : list row -> list S.contact -> list state -> Prop :=
  | good_nil : all_good [] [] []
  | good_cons r c s rows cs ss : fits r c -> exact_box (box r) = true ->
      is_state r s -> has_root r c s -> all_good rows cs ss ->
      all_good (r :: rows) (c :: cs) (s :: ss).

Lemma states_good rows cs shares n ss ss' : Forall2 fits rows cs ->
  forallb (fun r => exact_box (box r)) rows = true ->
  states rows xz shares n = Some ss -> with_roots rows ss = Some ss' ->
  shares_fit rows ss' = true ->
  all_good rows cs ss' /\ map state_v ss' = map state_v ss.
Proof.
  intros F. revert shares n ss ss'.
  induction F as [|r c rows cs Fr F IH]; intros shares n ss ss' X St Ro Fi.
  - cbn in St. destruct shares; [|discriminate]. injection St as <-. cbn in Ro.
    injection Ro as <-. split; [constructor|reflexivity].
  - cbn in X. apply andb_true_iff in X as [Xr X]. cbn [states] in St.
    assert (Rest : exists s0 shares' n' rest, ss = s0 :: rest /\ states rows xz shares' n' = Some rest /\
      state_v s0 = dot (exact_pull r) xz /\ state_slip s0 = exact_slip r xz).
    { assert (W : forall q sh, match states rows xz sh (n + 1) with
          | Some rest => Some (State (dot (exact_pull r) xz) (exact_slip r xz) q :: rest)
          | None => None end = Some ss ->
        exists s0 shares' n' rest, ss = s0 :: rest /\ states rows xz shares' n' = Some rest /\
          state_v s0 = dot (exact_pull r) xz /\ state_slip s0 = exact_slip r xz).
      { intros q sh H. destruct (states rows xz sh (n + 1)) as [rest|] eqn:E; [|discriminate].
        injection H as <-. eexists _, sh, (n + 1)%Z, rest. repeat split. exact E. }
      destruct shares as [|[i q] shares]; [now apply (W no_share [])|].
      destruct (Z.eqb i n); [|now eapply W; exact St].
      destruct q as [|q1 [|q2 [|q3 [|? ?]]]]; try discriminate.
      destruct (_ && _) in St; [|discriminate]. now eapply W; exact St. }
    destruct Rest as (s0 & shares' & n' & rest & -> & St' & V & SL).
    cbn [with_roots] in Ro. destruct (with_roots rows rest) as [rest'|] eqn:Ro'; [|discriminate].
    assert (New : forall s', Some (s' :: rest') = Some ss' -> state_v s' = state_v s0 ->
      state_slip s' = state_slip s0 -> has_root r c s' ->
      all_good (r :: rows) (c :: cs) ss' /\ map state_v ss' = map state_v (s0 :: rest)).
    { intros s' E EV ES HR. injection E as <-. cbn [shares_fit] in Fi.
      apply andb_true_iff in Fi as [Fi1 Fi2].
      destruct (IH shares' n' rest rest' X St' Ro' Fi2) as [G M]. split.
      - constructor; try assumption. split; [now rewrite EV|]. split; [now rewrite ES|exact Fi1].
      - cbn. now rewrite EV, M. }
    destruct (all_zero (state_slip s0)) eqn:AZ.
    + apply (New s0 Ro); try reflexivity. now left.
    + destruct (_ || _) eqn:C in Ro.
      * apply (New _ Ro); try reflexivity. apply orb_true_iff in C as [C|C].
        -- right; left. cbn. now apply Z.leb_le.
        -- right; right; left. apply Qeq_bool_eq, Qeq_eqR in C. rewrite Q2R_0 in C.
           now rewrite (exact_friction r c Fr Xr).
      * unfold sliding_share in Ro.
        destruct (state_slip s0) as [|s1 [|s2 [|s3 [|? ?]]]] eqn:ES; try discriminate.
        set (dd := dot [s1; s2; s3] [s1; s2; s3]) in *.
        set (root := low _) in Ro.
        destruct (_ && _) eqn:C2 in Ro; [|discriminate].
        rewrite !andb_true_iff in C2. destruct C2 as [[[P R0] RE] _].
        apply Z.ltb_lt in P. apply Qle_bool_R in R0. apply Qeq_bool_eq, Qeq_eqR in RE.
        rewrite !Q2R_mult in RE. rewrite Q2R_0 in R0.
        assert (J : forall z, Q2R (inject_Z z) = IZR z) by (intros; unfold Q2R; cbn; field).
        rewrite J in RE.
        apply (New _ Ro); try reflexivity.
        right; right; right. exists (Q2R root), s1, s2, s3. split; [exact R0|]. split; [reflexivity|].
        split; [exact RE|]. split; [exact P|]. cbn [share share_vector]. unfold vector_of_three.
        rewrite !reduced_same, !Q2R_mult, !Q2R_opp, !J. reflexivity.
Qed.

Fixpoint all_forces (rows : list row) (cs : list S.contact) (ss : list state) :=
  match rows, cs, ss with
  | r :: rows', c :: cs', s :: ss' => force_of r c s :: all_forces rows' cs' ss'
  | _, _, _ => []
  end.

Lemma all_obey (two_sided : bool) rows cs ss : all_good rows cs ss ->
  (two_sided = true -> Forall (fun z => 0 <= z)%Z (map state_v ss)) ->
  Forall2 (S.obeys (if two_sided then Model.bilateral else Model.unilateral) 0 d) cs
    (all_forces rows cs ss).
Proof.
  intros G. induction G as [|r c s rows cs ss Fr Xr Is Hr G IH]; intros B; cbn [all_forces]; constructor.
  - apply (state_obeys r c Fr Xr two_sided s Is Hr).
    intros T. specialize (B T). now inversion B.
  - apply IH. intros T. specialize (B T). now inversion B.
Qed.

Lemma wrenches_sum rows cs ss : all_good rows cs ss ->
  S.scale_screw t (S.sum (map six_of (contact_wrenches rows ss))) =
  S.sum (S.contact_wrenches cs (all_forces rows cs ss)) /\
  Forall short_list (contact_wrenches rows ss).
Proof.
  intros G. induction G as [|r c s rows cs ss Fr Xr Is Hr G [IH1 IH2]].
  - split; [|constructor]. unfold S.sum, S.scale_screw, S.no_screw, S.zero, S.scale; cbn.
    f_equal; f_equal; ring.
  - destruct (contact_wrench_is r c Fr Xr s) as [W L]. cbn [contact_wrenches all_forces].
    split; [|constructor; assumption].
    change (S.sum (S.contact_wrenches (c :: cs) (force_of r c s :: all_forces rows cs ss)))
      with (S.add_screw (S.contact_wrench c (force_of r c s))
              (S.sum (S.contact_wrenches cs (all_forces rows cs ss)))).
    rewrite <- IH1, <- W. cbn [map].
    change (S.sum (six_of (contact_wrench r s) :: map six_of (contact_wrenches rows ss)))
      with (S.add_screw (six_of (contact_wrench r s)) (S.sum (map six_of (contact_wrenches rows ss)))).
    unfold S.scale_screw, S.add_screw, S.scale, S.add; cbn. f_equal; f_equal; ring.
Qed.

End Motion.

Section Stable.
Open Scope R_scope.

Theorem witness_stable (two_sided : bool) rows ld w g :
  Forall2 fits rows (S.contacts g) ->
  Forall2 within (load_box ld) (six (S.wrench g)) ->
  map Q2R (load_growth ld) = six (S.direction g) ->
  S.normal_law g = (if two_sided then Model.bilateral else Model.unilateral) ->
  is_one_grasp rows ld = true -> witness_fails two_sided rows ld w = None -> S.stable g.
Proof.
  intros F Hw Hu Law One H. unfold is_one_grasp in One. apply andb_true_iff in One as [X1 X2].
  unfold witness_fails, integer_point in H. set (qs := coordinates_of _) in *.
  set (sc := scaling_of qs) in *.
  destruct (map (to_integer sc) qs) as [|x1 [|x2 [|x3 [|x4 [|x5 [|x6 [|h [|l [|? ?]]]]]]]]] eqn:M;
    try discriminate.
  destruct (states rows _ (shares w) 0) as [ss|] eqn:St; [|discriminate].
  destruct (two_sided && _) eqn:B; [discriminate|].
  destruct (with_roots rows ss) as [ss'|] eqn:Ro; [|discriminate].
  destruct (shares_fit rows ss' && _) eqn:C; [|discriminate]. apply andb_true_iff in C as [Fi A].
  assert (T : forall q, In q qs -> unit sc * IZR (to_integer sc q) = Q2R q)
    by (intros; symmetry; now apply to_integer_exact).
  assert (TP : 0 < unit sc) by apply unit_positive. clearbody sc.
  assert (HL : unit sc * IZR h = 1 /\ unit sc * IZR l = 0).
  { unfold qs, coordinates_of in *. cbn [multiple point_witness] in *.
    destruct (twist w) as [|t1 [|t2 [|t3 [|t4 [|t5 [|t6 [|? ?]]]]]]]; cbn [app map] in M;
      try discriminate;
      try (exfalso; apply (f_equal (@List.length Z)) in M; cbn in M;
           rewrite ?map_length, ?app_length in M; cbn in M; lia).
    injection M as _ _ _ _ _ _ <- <-. split.
    - rewrite (T 1%Q) by (cbn; tauto). apply Q2R_1.
    - rewrite (T 0%Q) by (cbn; tauto). apply Q2R_0. }
  destruct HL as [H1 H0]. set (t := unit sc) in *. clearbody t.
  destruct (states_good x1 x2 x3 x4 x5 x6 h l rows _ (shares w) 0%Z ss ss' F X1 St Ro Fi) as [G MV].
  exists (S.Screw (S.Vector (t * IZR x1) (t * IZR x2) (t * IZR x3))
                 (S.Vector (t * IZR x4) (t * IZR x5) (t * IZR x6))).
  exists (all_forces t rows (S.contacts g) ss'). split.
  - rewrite Law. apply (all_obey x1 x2 x3 x4 x5 x6 h l t TP H1 H0 two_sided rows _ ss' G).
    intros ->. cbn in B. apply negb_false_iff in B. rewrite forallb_forall in B. rewrite MV.
    apply Forall_map, Forall_forall. intros s Hs. apply Z.leb_le. auto.
  - destruct (wrenches_sum x1 x2 x3 x4 x5 x6 h l t rows _ ss' G) as [SUM SHORT].
    rewrite <- SUM.
    assert (LA : S.scale_screw t (six_of (load_at ld h l)) =
                 S.add_screw (S.wrench g) (S.scale_screw 0 (S.direction g)) /\
                 short_list (load_at ld h l)).
    { unfold load_at. clear - Hw Hu X2 H1 H0.
      destruct (load_growth ld) as [|u1 [|u2 [|u3 [|u4 [|u5 [|u6 [|? ?]]]]]]]; try discriminate.
      inversion Hw as [|i1 ? ? ? W1 Hw1]; subst. inversion Hw1 as [|i2 ? ? ? W2 Hw2]; subst.
      inversion Hw2 as [|i3 ? ? ? W3 Hw3]; subst. inversion Hw3 as [|i4 ? ? ? W4 Hw4]; subst.
      inversion Hw4 as [|i5 ? ? ? W5 Hw5]; subst. inversion Hw5 as [|i6 ? ? ? W6 Hw6]; subst.
      inversion Hw6; subst.
      repeat match goal with E : _ = load_box ld |- _ => rewrite <- E in * end.
      cbn in X2. rewrite !andb_true_iff in X2. destruct X2 as (C1 & C2 & C3 & C4 & C5 & C6 & _).
      apply (certain_within _ _ C1) in W1. apply (certain_within _ _ C2) in W2.
      apply (certain_within _ _ C3) in W3. apply (certain_within _ _ C4) in W4.
      apply (certain_within _ _ C5) in W5. apply (certain_within _ _ C6) in W6.
      split; [|right; reflexivity].
      cbn [List.combine map six_of fst snd]. unfold vector_of_three. rewrite !reduced_same.
      assert (J : forall z, Q2R (inject_Z z) = IZR z) by (intros; unfold Q2R; cbn; field).
      assert (One : forall (i : interval) (u : Q), t * Q2R (inject_Z h * low i + inject_Z l * u) = Q2R (low i)).
      { intros i u. rewrite Q2R_plus, !Q2R_mult, !J.
        replace (t * (IZR h * Q2R (low i) + IZR l * Q2R u))
          with ((t * IZR h) * Q2R (low i) + (t * IZR l) * Q2R u) by ring. rewrite H1, H0. ring. }
      unfold S.scale_screw, S.add_screw, S.scale, S.add; cbn. rewrite !One.
      rewrite W1, W2, W3, W4, W5, W6. f_equal; f_equal; ring. }
    destruct LA as [LA LS]. rewrite <- LA.
    apply adds_up in A; [|constructor; assumption]. cbn [map] in A.
    assert (E : S.add_screw (S.scale_screw t (six_of (load_at ld h l)))
      (S.scale_screw t (S.sum (map six_of (contact_wrenches rows ss')))) =
      S.scale_screw t (S.sum (six_of (load_at ld h l) :: map six_of (contact_wrenches rows ss')))).
    { unfold S.sum. cbn [fold_right]. unfold S.scale_screw, S.add_screw, S.scale, S.add; cbn.
      f_equal; f_equal; ring. }
    rewrite E, A. unfold S.scale_screw, S.no_screw, S.zero, S.scale; cbn. f_equal; f_equal; ring.
Qed.

End Stable.
