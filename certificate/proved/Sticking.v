(* SPDX-License-Identifier: MIT *)
(* Stable by sticking (FORMAT.md section 6): contacts that stick, near a motion d0, and press a little more or less than
   the law says there.  `stable_by_sticking`: where the rules hold, every system in the box is stable at every multiple. *)
From Coq Require Import List Arith String ZArith QArith Qreals Qminmax Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Tree.
From Proved Require Import Brouwer Homotopy RowLimits Degree Matrix Frame Between Ways Load Bound ByDegree Margin Rest Energy.
From Proved Require Rows Model.
Import ListNotations.

Record sticking_proof := StickingProof {
  stuck_twist : vector;                       (* d0 *)
  stuck_friction : list (Z * vector);         (* f0 *)
  stuck_presses : list (Z * vector);          (* H_i1, ..., H_iD *)
  stuck_answers : list (Z * matrix);          (* G_i1, ..., G_iD *)
  stuck_reach : vector;                       (* Z *)
  stuck_energy : Q                            (* c *)
}.

(* A contact: its box, f0 and G; and H. *)
Record sticker := Sticker { as_resting : resting; presses : vector }.
Definition sticker_box (t : sticker) : cbox := resting_box (as_resting t).

Section Rules.
Open Scope Q_scope.

Definition is_nothing {A} (them : list A) : bool := match them with [] => true | _ => false end.

Definition does_rub (t : sticker) : bool := negb (is_nothing (force_at_rest (as_resting t)) && is_nothing (answers (as_resting t))).
Definition on_list (t : sticker) : bool := does_rub t || negb (is_nothing (presses t)).

(* ---- sticking-share ---- *)

Fixpoint with_presses (them : list resting) (i : Z) (all_presses : list (Z * vector)) (before : list sticker)
    : option (list sticker) :=
  match them with
  | [] => match all_presses with [] => Some (rev_append before []) | _ => None end
  | r :: them' =>
      let (h, others) := taken [] i all_presses in
      if is_nothing h || Qlt_bool 0 (low (box_stiffness (resting_box r)))
      then with_presses them' (i + 1) others (Sticker r h :: before)
      else None
  end.

Definition stickers (n : nat) (rows : list row) (p : sticking_proof) : option (list sticker) :=
  if Nat.eqb (List.length (stuck_twist p)) n && Nat.eqb (List.length (stuck_reach p)) n &&
     forallb (Qlt_bool 0) (stuck_reach p) && Qlt_bool 0 (stuck_energy p)
  then match resting_contacts n rows 0 (stuck_friction p) (stuck_answers p) [] with
       | Some them => with_presses them 0 (stuck_presses p) []
       | None => None
       end
  else None.

(* ---- sticking-motion ---- *)

Definition no_motion (d : vector) : bool := forallb is_zero d.

Definition motion_holds (two_sided one_multiple : bool) (d : vector) (them : list sticker) : bool :=
  (no_motion d || (one_multiple && forallb (fun t => negb (box_turns (sticker_box t))) them)) &&
  (negb two_sided || forallb (fun t => box_spring (sticker_box t) || on_list t) them).

(* ---- What contacts do at d0 ---- *)

Definition N_range (b : cbox) (d : vector) : interval := range_of (map (fun c => inner (N_of c) d) (tips (geometry_tree b))).

Definition minus_products (a b : interval) : interval :=
  range_of [- (low a * low b); - (low a * high b); - (high a * low b); - (high a * high b)].

(* v *)
Definition pull_range (b : cbox) (d : vector) (lambda : Q) : interval :=
  plus_interval (range_of (pressures b lambda))
    (if no_motion d then exactly 0 else minus_products (box_stiffness b) (N_range b d)).

(* a0 *)
Definition push_range (b : cbox) (d : vector) (lambda : Q) : interval :=
  let v := pull_range b d lambda in
  if box_spring b then v else Interval (Qmax 0 (low v)) (Qmax 0 (high v)).

(* sigma *)
Definition slip_bound (b : cbox) (d : vector) : Q :=
  if no_motion d then 0
  else fold_left Qmax (map (fun c => root_above (sum_of_squares (box_weights b) (map (fun f => inner f d) (tl c))))
                         (tips (geometry_tree b))) 0.

Definition absolute (q : Q) : Q := most_of (exactly q).

(* ---- The rules at one multiple ---- *)

Section AtOne.
Variable n : nat.
Variable s : setting.
Variable d : vector.
Variable reach : vector.
Variable c : Q.
Variable them : list sticker.
Variable columns : list (list interval).
Variable lambda : Q.

(* W *)
Definition stuck_left : list interval :=
  fold_left (fun sum t =>
      let a := push_range (sticker_box t) d lambda in
      plus_intervals sum (ranges n (sticker_box t) [low a :: force_at_rest (as_resting t); high a :: force_at_rest (as_resting t)]))
    them (loads_at s lambda).

(* The most of |M_kl - 1 or 0|. *)
Definition off_most (k l : nat) : Q :=
  most_of (shifted (nth k (nth l columns []) (exactly 0)) (if Nat.eqb k l then -(1) else 0)).

(* sticking-reach *)
Definition stuck_reach_holds (left : list interval) : bool :=
  forallb (fun k =>
    Qlt_bool (fold_left (fun sum l => reduced (sum + off_most k l * nth l reach 0)) (seq 0 n)
                (most_of (nth k left (exactly 0))))
      (nth k reach 0)) (seq 0 n).

(* delta, phi, r *)
Definition more_bound (t : sticker) : Q :=
  fold_left (fun sum l => reduced (sum + absolute (nth l (presses t) 0) * nth l reach 0)) (seq 0 n) 0.
Definition friction_bound (t : sticker) : Q :=
  reduced (length_bound (sticker_box t) (force_at_rest (as_resting t)) + answers_bound (sticker_box t) (answers (as_resting t)) reach).
Definition swing_bound (t : sticker) : Q := root_above (2 * c * high (box_stiffness (sticker_box t))).

Definition least_rho (b : cbox) : Q := low (box_friction b) * root_below (box_square b).
Definition most_rho (b : cbox) : Q := high (box_friction b) * root_above (box_square b).

(* s *)
Definition spare_least (t : sticker) : Q :=
  reduced (least_rho (sticker_box t) * (low (pull_range (sticker_box t) d lambda) - swing_bound t) - friction_bound t).

(* What a question guarantees. *)
Definition sticker_sound (t : sticker) : bool :=
  let b := sticker_box t in
  resting_sound lambda (as_resting t) &&
  Qle_bool 0 (low (box_stiffness b)) && (box_spring b || Qlt_bool 0 (low (box_stiffness b))).

(* sticking-press *)
Definition press_holds (t : sticker) : bool :=
  sticker_sound t &&
  (negb (on_list t) || box_spring (sticker_box t) ||
   Qle_bool (swing_bound t) (low (pull_range (sticker_box t) d lambda))) &&
  (negb (does_rub t) || (negb (box_spring (sticker_box t)) && Qlt_bool 0 (spare_least t))).

(* gamma, at one end of k'. *)
Definition share_at (t : sticker) (k : Q) : Q :=
  if Qle_bool k 0 then 0
  else
    let b := sticker_box t in
    let sigma := slip_bound b d in
    let both := reduced (more_bound t + most_rho b * k * sigma) in
    reduced (both * both / (2 * k) + (most_rho b * high (push_range b d lambda) + friction_bound t) * sigma).

Definition share_most (t : sticker) : Q :=
  if is_nothing (presses t) && no_motion d then 0
  else
    let k := box_stiffness (sticker_box t) in
    Qmax 0 (Qmax (share_at t (low k)) (share_at t (high k))).

(* sticking-energy *)
Definition energy_holds : bool := Qlt_bool (fold_left (fun sum t => reduced (sum + share_most t)) them 0) c.

(* sticking-bound *)
Definition far_most (t : sticker) (l : nat) : Q :=
  reduced (absolute (nth l (presses t) 0) * root_above (2 * c / low (box_stiffness (sticker_box t))) +
    (if does_rub t
     then length_bound (sticker_box t) (nth l (answers (as_resting t)) []) * (c / spare_least t + slip_bound (sticker_box t) d)
     else 0)).

Definition room (most : vector) (l : nat) : Q := nth l most 0 - absolute (nth l d 0).

Definition stuck_bound_holds (bound : option (list Q)) : bool :=
  match bound with
  | None => true
  | Some most =>
      forallb (fun l =>
        Qlt_bool 0 (room most l) &&
        Qle_bool
          (fold_left (fun sum k => reduced (sum + off_most k l * room most k)) (seq 0 n)
             (fold_left (fun sum t => reduced (sum + far_most t l)) them 0))
          (room most l))
        (seq 0 n)
  end.

Definition sticking_fails_at : option string :=
  if negb (stuck_reach_holds stuck_left) then Some "sticking-reach"%string
  else if negb (forallb press_holds them) then Some "sticking-press"%string
  else if negb energy_holds then Some "sticking-energy"%string
  else if negb (stuck_bound_holds (the_bound s)) then Some "sticking-bound"%string
  else None.

End AtOne.

(* The column l of M, without those contacts that do not answer. *)
Definition stuck_column (n : nat) (them : list sticker) (l : nat) : list interval :=
  fold_left (fun sum t =>
      if on_list t
      then plus_intervals sum (ranges n (sticker_box t) [nth l (presses t) 0 :: nth l (answers (as_resting t)) []])
      else sum) them (repeat (exactly 0) n).

(* From alpha to beta. *)
Definition sticking_fails (two_sided : bool) (s : setting) (alpha beta : Q) (p : sticking_proof) : option string :=
  let n := dimension_of s in
  match stickers n (rows s) p with
  | None => Some "sticking-share"%string
  | Some them =>
      if negb (motion_holds two_sided (Qeq_bool alpha beta) (stuck_twist p) them) then Some "sticking-motion"%string
      else
        let holds := sticking_fails_at n s (stuck_twist p) (stuck_reach p) (stuck_energy p) them
                       (map (stuck_column n them) (seq 0 n)) in
        match holds alpha with
        | Some rule => Some rule
        | None => if Qeq_bool alpha beta then None else holds beta
        end
  end.

End Rules.

(* ---- Proofs: numbers at d0 ---- *)

Open Scope R_scope.

Lemma lt_bool_R a b : Qlt_bool a b = true -> Q2R a < Q2R b.
Proof.
  unfold Qlt_bool. intros H. apply negb_true_iff in H. apply Rnot_le_lt. intros L. apply Rle_Qle, Qle_bool_iff in L.
  congruence.
Qed.

Lemma absolute_bound q : Rabs (Q2R q) <= Q2R (absolute q).
Proof. apply most_of_bound, exactly_within. Qed.

Lemma product_of_within a b x y : within a x -> within b y -> within (minus_products a b) (- (x * y)).
Proof.
  intros [A1 A2] [B1 B2]. unfold minus_products. set (qs := [_; _; _; _]).
  assert (C : forall q, In q qs -> within (range_of qs) (Q2R q)) by (intros; now apply range_of_within).
  pose proof (C _ (or_introl eq_refl)) as C1. pose proof (C _ (or_intror (or_introl eq_refl))) as C2.
  pose proof (C _ (or_intror (or_intror (or_introl eq_refl)))) as C3.
  pose proof (C _ (or_intror (or_intror (or_intror (or_introl eq_refl))))) as C4.
  clear C. unfold within in *. rewrite Q2R_opp, Q2R_mult in C1, C2, C3, C4.
  set (l := Q2R (low (range_of qs))) in *. set (h := Q2R (high (range_of qs))) in *.
  set (a1 := Q2R (low a)) in *. set (a2 := Q2R (high a)) in *. set (b1 := Q2R (low b)) in *. set (b2 := Q2R (high b)) in *.
  assert (Mid : forall p q r z, p <= r <= q -> l <= - (z * p) <= h -> l <= - (z * q) <= h -> l <= - (z * r) <= h).
  { intros p q r z Hr Hp Hq. destruct (Rle_dec 0 z) as [Hz|Hz].
    - assert (z * p <= z * r) by (apply Rmult_le_compat_l; lra). assert (z * r <= z * q) by (apply Rmult_le_compat_l; lra). lra.
    - assert (z * p >= z * r) by nra. assert (z * r >= z * q) by nra. lra. }
  apply (Mid b1 b2); [lra| |]; rewrite (Rmult_comm x).
  - apply (Mid a1 a2); [lra| |]; rewrite (Rmult_comm b1); assumption.
  - apply (Mid a1 a2); [lra| |]; rewrite (Rmult_comm b2); assumption.
Qed.

Lemma no_motion_is d : no_motion d = true -> real d = listed (List.length d) (fun _ => 0).
Proof.
  induction d as [|q d IH]; cbn; [reflexivity|]. intros H. apply andb_true_iff in H as [Z H].
  rewrite (is_zero_real _ Z). f_equal. exact (IH H).
Qed.

Lemma nth_nothing {A} l (a : A) : nth l [] a = a.
Proof. now destruct l. Qed.

Lemma nothing_moves r d : no_motion d = true -> Rows.dot r (real d) = 0.
Proof. intros H. rewrite (no_motion_is d H). apply dot_listed_zero. Qed.

Section OfBox.
Variables (b : cbox) (r : Rows.row) (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.

Lemma N_within d : within (N_range b d) (Rows.dot (Rows.N r) (real d)).
Proof.
  change (Rows.N r) with (nth 0 (Rows.N r :: Rows.slips r) []).
  rewrite (rational_corners b r p F mu t I 0 (real d)). unfold N_range.
  assert (Tip : forall c, In c (tips (geometry_tree b)) -> within (N_range b d) (qdot (nth 0 c []) (real d))).
  { intros c Hc. rewrite qdot_real, <- inner_is. apply range_of_within. apply (in_map (fun c => inner (N_of c) d) _ c Hc). }
  split.
  - apply eval_least; [apply (shares_valid b r p F mu t I)|]. intros c Hc. now apply Tip.
  - apply eval_most; [apply (shares_valid b r p F mu t I)|]. intros c Hc. now apply Tip.
Qed.

Lemma slips_at_corners ws g d : Rows.product ws g (Rows.slip r d) =
  eval (fun c => Rows.product ws g (map (fun f => qdot f d) (tl c))) (geometry_tree b) (shares_in b p).
Proof.
  assert (Skip : forall A (F : A -> R) (none : A) m j w ws x g, F none = 0 ->
    Rows.product (w :: ws) (x :: g) (map F (skipn j m)) = w * x * F (nth j m none) + Rows.product ws g (map F (skipn (S j) m))).
  { clear. intros A F none m. induction m as [|a m IH]; intros [|j] w ws x g Z.
    - cbn. rewrite Z. destruct ws, g; cbn; ring.
    - cbn. rewrite Z. destruct ws, g; cbn; ring.
    - reflexivity.
    - cbn [skipn nth]. apply (IH j). exact Z. }
  assert (G : forall ws g j, Rows.product ws g (map (fun f => Rows.dot f d) (skipn j (Rows.N r :: Rows.slips r))) =
    eval (fun c => Rows.product ws g (map (fun f => qdot f d) (skipn j c))) (geometry_tree b) (shares_in b p)).
  { clear ws g. induction ws as [|w ws IH]; intros [|x g] j; try (symmetry; exact (eval_constant 0 _ _)).
    rewrite (Skip _ (fun f => Rows.dot f d) []), IH by reflexivity.
    transitivity (eval (fun c => w * x * qdot (nth j c []) d +
      Rows.product ws g (map (fun f => qdot f d) (skipn (S j) c))) (geometry_tree b) (shares_in b p)).
    - now rewrite eval_sum, eval_multiple, <- (rational_corners b r p F mu t I).
    - apply eval_same. intros c _. symmetry. now apply (Skip _ (fun f => qdot f d) []). }
  specialize (G ws g 1%nat). cbn [skipn] in G. unfold Rows.slip. rewrite G. apply eval_same. intros c _. now destruct c.
Qed.

Lemma most_in qs q0 q : In q qs -> Q2R q <= Q2R (fold_left Qmax qs q0).
Proof.
  revert q0. induction qs as [|a qs IH]; intros q0; [intros []|]. intros [->|H]; cbn; [|now apply IH].
  assert (G : forall qs q0, Q2R q0 <= Q2R (fold_left Qmax qs q0)).
  { clear. induction qs as [|a qs IH]; intros q0; cbn; [lra|]. eapply Rle_trans; [|apply IH]. apply max_R. }
  eapply Rle_trans; [|apply G]. apply max_R.
Qed.

Lemma slip_bound_nonneg d : 0 <= Q2R (slip_bound b d).
Proof.
  unfold slip_bound. destruct (no_motion d); [rewrite Q2R_0; lra|].
  assert (G : forall qs q0, Q2R q0 <= Q2R (fold_left Qmax qs q0)).
  { clear. induction qs as [|a qs IH]; intros q0; cbn; [lra|]. eapply Rle_trans; [|apply IH]. apply max_R. }
  eapply Rle_trans; [|apply G]. rewrite Q2R_0. lra.
Qed.

Lemma slip_within d : Rows.size (Rows.weights r) (Rows.slip r (real d)) <= Q2R (slip_bound b d).
Proof.
  pose proof (Box.weights_positive _ _ _ _ _ _ I) as W. set (ws := Rows.weights r) in *.
  pose proof (slip_bound_nonneg d) as Sn. unfold slip_bound in *. destruct (no_motion d) eqn:Z.
  - rewrite Q2R_0. right. unfold Rows.size. replace (Rows.product _ _ _) with 0; [apply sqrt_0|].
    assert (E : forall ws g, 0 = Rows.product ws g (Rows.slip r (real d))); [|apply E].
    intros ws' g. unfold Rows.slip. revert ws' g. induction (Rows.slips r) as [|f fs IH]; intros ws' g; destruct ws', g; cbn;
      try reflexivity. rewrite <- IH, (nothing_moves f d Z). ring.
  - set (most := fold_left _ _ _) in *. set (z := Rows.slip r (real d)). pose proof (Rows.size_nonneg ws z) as Zn.
    assert (H : Rows.product ws z z <= Rows.size ws z * Q2R most).
    { unfold z at 2. rewrite slips_at_corners. apply eval_most; [apply (shares_valid b r p F mu t I)|]. intros c Hc.
      eapply Rle_trans; [apply Rows.product_bound; exact W|]. apply Rmult_le_compat_l; [exact Zn|].
      assert (E : map (fun f => qdot f (real d)) (tl c) = real (map (fun f => inner f d) (tl c))).
      { unfold real. rewrite map_map. apply map_ext. intros f. rewrite qdot_real. symmetry. apply inner_is. }
      rewrite E. unfold Rows.size, ws. rewrite (Box.is_weights _ _ _ _ _ _ I).
      change (map Q2R (box_weights b)) with (real (box_weights b)). rewrite <- sum_of_squares_is.
      eapply Rle_trans; [apply root_above_is|].
      - rewrite sum_of_squares_is. apply Rows.product_nonneg. unfold real. rewrite <- (Box.is_weights _ _ _ _ _ _ I). exact W.
      - apply most_in.
        apply (in_map (fun c => root_above (sum_of_squares (box_weights b) (map (fun f => inner f d) (tl c)))) _ c Hc). }
    rewrite <- (Rows.size_square ws z W) in H. apply Rnot_lt_le. intros L. nra.
Qed.

Lemma pressures_within q : within (range_of (pressures b q)) (Rows.preload r + Q2R q * Rows.growth r).
Proof.
  set (p1 := (low (box_preload b) + q * low (box_growth b))%Q). set (p2 := (high (box_preload b) + q * high (box_growth b))%Q).
  replace (Rows.preload r + Q2R q * Rows.growth r) with (mix t (Q2R p1) (Q2R p2)).
  - unfold pressures. fold p1 p2. apply mix_within; [apply (in_step _ _ _ _ _ _ I)| |]; apply range_of_within; cbn; tauto.
  - unfold p1, p2, mix. rewrite (in_preload _ _ _ _ _ _ I), (in_growth _ _ _ _ _ _ I), !Q2R_plus, !Q2R_mult. ring.
Qed.

Lemma pull_within d q : within (pull_range b d q) (Rows.v r (real d) 1 (Q2R q)).
Proof.
  unfold pull_range, Rows.v.
  replace (Rows.preload r * 1 + Rows.growth r * Q2R q - Rows.stiffness r * Rows.dot (Rows.N r) (real d))
    with ((Rows.preload r + Q2R q * Rows.growth r) + - (Rows.stiffness r * Rows.dot (Rows.N r) (real d))) by ring.
  apply plus_interval_within; [apply pressures_within|]. destruct (no_motion d) eqn:Z.
  - rewrite (nothing_moves _ d Z), Rmult_0_r, Ropp_0, <- Q2R_0. apply exactly_within.
  - apply product_of_within; [apply (in_stiffness _ _ _ _ _ _ I)|apply N_within].
Qed.

Lemma push_within d q : within (push_range b d q) (RowLimits.pressed r (real d) 1 (Q2R q)).
Proof.
  pose proof (pull_within d q) as [L H]. unfold push_range, RowLimits.pressed. rewrite (is_spring _ _ _ _ _ _ I).
  destruct (box_spring b); [now split|]. unfold within; cbn [low high].
  destruct (max_R 0 (high (pull_range b d q))) as [M1 M2]. rewrite Q2R_0 in M1. split.
  - destruct (Q.max_spec 0 (low (pull_range b d q))) as [[_ E]|[_ E]]; rewrite E.
    + eapply Rle_trans; [exact L|apply Rmax_r].
    + rewrite Q2R_0. apply Rmax_l.
  - apply Rmax_lub; lra.
Qed.

End OfBox.

(* ---- Proofs: contacts, and the rows that stand for them ---- *)

Record linked := Linked { sticks : sticker; own_row : Rows.row; box_row : Rows.row }.
Definition link_box (x : linked) : cbox := sticker_box (sticks x).

Section Links.
Variable n : nat.

Record links (x : linked) : Prop := Links {
  link_shaped : shaped n (as_resting (sticks x)) (box_row x);
  link_proper : proper n (own_row x);
  link_stands : exists k, stands k (own_row x) (box_row x);
  link_straight : box_turns (link_box x) = false -> box_row x = own_row x;
  link_presses : presses (sticks x) = [] \/ 0 < Q2R (low (box_stiffness (link_box x)))
}.

Lemma is_nothing_is {A} (l : list A) : is_nothing l = true -> l = [].
Proof. now destruct l. Qed.

Lemma with_presses_is them i all before found : with_presses them i all before = Some found ->
  exists rest, found = rev before ++ rest /\ map as_resting rest = them /\
    Forall (fun t => presses t = [] \/ 0 < Q2R (low (box_stiffness (sticker_box t)))) rest.
Proof.
  revert i all before. induction them as [|r them IH]; intros i all before H; cbn [with_presses] in H.
  - destruct all; [|discriminate]. injection H as <-. exists []. rewrite rev_append_rev, app_nil_r. repeat constructor.
  - destruct (taken [] i all) as [h others]. destruct (_ || _) eqn:C in H; [|discriminate].
    destruct (IH _ _ _ H) as (rest & -> & E & F). exists (Sticker r h :: rest). split; [|split].
    + cbn. now rewrite <- app_assoc.
    + cbn. now rewrite E.
    + constructor; [|exact F]. cbn. apply orb_true_iff in C as [C|C].
      * left. now apply is_nothing_is.
      * right. apply lt_bool_R in C. now rewrite Q2R_0 in C.
Qed.

(* Contacts of the file, with their rows and those that stand for them. *)
Lemma linked_all rows rs them found i forces all j all_presses :
  Forall2 suits rows rs -> Forall (proper n) rs ->
  resting_contacts n rows i forces all [] = Some them -> with_presses them j all_presses [] = Some found ->
  exists xs, Forall links xs /\ map own_row xs = rs /\ map sticks xs = found.
Proof.
  intros F P H1 H2.
  assert (St : exists rs', Forall2 fits rows rs' /\ Forall2 (fun r r' => exists k, stands k r r') rs rs' /\ Forall (proper n) rs' /\
    Forall2 (fun row rr => box_turns (box row) = false -> snd rr = fst rr) rows (List.combine rs rs')).
  { clear H1 H2. induction F as [|row r rows rs [E Se] F IH].
    - exists []. repeat constructor.
    - destruct (IH (Forall_inv_tail P)) as (rs' & F' & S' & P' & T').
      destruct (seen_stands _ _ Se) as (r' & k & p & G & mu & t & I & St & _ & Same).
      exists (r' :: rs'). split; [|split; [|split]]; cbn; constructor; try assumption.
      + split; [exact E|]. now exists p, G, mu, t.
      + now exists k.
      + exact (stands_proper n _ _ _ _ _ _ _ _ St I (Forall_inv P)). }
  destruct St as (rs' & Fi & St & P' & Tu).
  destruct (resting_shaped n rows rs' _ _ _ _ _ H1 Fi P') as (rest & E & Sh). cbn in E. subst rest.
  destruct (with_presses_is _ _ _ _ _ H2) as (rest & E & Hd & Pr). cbn in E. subst rest.
  assert (Bx : Forall2 (fun r row => resting_box r = box row) them rows).
  { clear - H1. assert (G : forall rows i forces all before them, resting_contacts n rows i forces all before = Some them ->
      exists rest, them = rev before ++ rest /\ Forall2 (fun r row => resting_box r = box row) rest rows).
    { clear. induction rows as [|row rows IH]; intros i forces all before them H; cbn [resting_contacts] in H.
      - destruct forces, all; try discriminate. injection H as <-. rewrite rev_append_rev. exists []. repeat constructor.
      - destruct (taken [] i forces) as [f forces']. destruct (taken [] i all) as [g all']. destruct (_ && _) in H; [|discriminate].
        destruct (IH _ _ _ _ _ H) as (rest & -> & Fr). exists (Resting (box row) f g :: rest). split.
        + cbn. now rewrite <- app_assoc.
        + now constructor. }
    destruct (G _ _ _ _ _ _ H1) as (rest & E & Fr). cbn in E. now subst rest. }
  clear H1 H2 Fi F. subst them. revert found Sh Pr Bx P. revert rows Tu P'.
  induction St as [|r r' rs rs' S St IH]; intros rows Tu P' found Sh Pr Bx P.
  - inversion Sh as [E|]. destruct found; [|discriminate]. now exists [].
  - destruct found as [|t found]; [inversion Sh|]. cbn in Sh, Bx, Tu. inversion Sh as [|? ? ? ? Sh1 Sh2]; subst.
    inversion Bx as [|? row ? rows' Bx1 Bx2]; subst. inversion Tu as [|? ? ? ? Tu1 Tu2]; subst.
    destruct (IH rows' Tu2 (Forall_inv_tail P') found Sh2 (Forall_inv_tail Pr) Bx2 (Forall_inv_tail P)) as (xs & L & E1 & E2).
    exists (Linked t r r' :: xs). split; [|cbn; now rewrite E1, E2]. constructor; [|exact L].
    constructor; cbn; try assumption; [exact (Forall_inv P)| |exact (Forall_inv Pr)].
    intros T. unfold link_box, sticker_box in T. cbn in T. rewrite Bx1 in T. exact (Tu1 T).
Qed.

(* Friction of the row in the box, as a force of its own: rho, and all that friction does, is so many times as much. *)
Lemma own_force x g most : links x -> 0 <= most -> Rows.size (Rows.weights (box_row x)) g <= most ->
  (Rows.rho (box_row x) = 0 -> most = 0) ->
  exists u f, 0 <= u /\ Rows.rho (own_row x) = u * Rows.rho (box_row x) /\
    Rows.size (Rows.weights (own_row x)) f <= u * most /\
    (forall y, Rows.product (Rows.weights (own_row x)) f (Rows.slip (own_row x) y) =
               Rows.product (Rows.weights (box_row x)) g (Rows.slip (box_row x) y)) /\
    (0 < Rows.rho (box_row x) -> forall y, Rows.size (Rows.weights (box_row x)) (Rows.slip (box_row x) y) <=
                                           u * Rows.size (Rows.weights (own_row x)) (Rows.slip (own_row x) y)) /\
    (own_row x = box_row x -> u = 1).
Proof.
  intros L M S Z. destruct (link_stands x L) as [k St]. pose proof (shaped_proper _ _ _ (link_shaped x L)) as Pb.
  set (r := own_row x) in *. set (r' := box_row x) in *. pose proof (RowLimits.weights_positive _ _ Pb) as Wb.
  pose proof (RowLimits.weights_positive _ _ (link_proper x L)) as Wo. fold r in Wo.
  pose proof (rho_nonneg _ _ Pb) as R0. destruct (Req_dec (Rows.rho r') 0) as [E|E].
  - destruct (holds _ _ _ St 0 g) as (f & C & W).
    { rewrite E, Rmult_0_l. now rewrite <- (Z E). }
    exists 1, f. split; [lra|]. rewrite (no_rubbing _ _ _ St E), E in *. rewrite (Z eq_refl).
    split; [ring|]. split; [lra|]. split; [exact W|]. split; [lra|reflexivity].
  - assert (R : 0 < Rows.rho r') by lra.
    assert (I : Rows.rho r' * / Rows.rho r' = 1) by (apply Rinv_r; lra).
    assert (Ip : 0 < / Rows.rho r') by now apply Rinv_0_lt_compat.
    exists (Rows.rho r * / Rows.rho r').
    destruct (holds _ _ _ St (most * / Rows.rho r') g) as (f & C & W).
    { replace (Rows.rho r' * (most * / Rows.rho r')) with (most * (Rows.rho r' * / Rows.rho r')) by ring. rewrite I. lra. }
    exists f. split; [|split; [|split; [|split; [|split]]]].
    + apply Rmult_le_pos; [apply (rho_nonneg _ _ (link_proper x L))|lra].
    + rewrite Rmult_assoc, (Rmult_comm (/ _)), I. ring.
    + replace (Rows.rho r * / Rows.rho r' * most) with (Rows.rho r * (most * / Rows.rho r')) by ring. exact C.
    + exact W.
    + intros _ y. set (z := Rows.size (Rows.weights r') (Rows.slip r' y)).
      pose proof (Rows.size_nonneg (Rows.weights r') (Rows.slip r' y)) as Zn. fold z in Zn.
      pose proof (Rows.size_nonneg (Rows.weights r) (Rows.slip r y)) as On.
      pose proof (rho_nonneg _ _ (link_proper x L)) as Ro. fold r in Ro.
      destruct (Req_dec z 0) as [Z0|Z0].
      { rewrite Z0. apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact On]. }
      assert (Zp : 0 < z) by lra. pose proof (Rinv_0_lt_compat z Zp) as Iz.
      assert (Iz1 : / z * z = 1) by (apply Rinv_l; lra).
      destruct (holds _ _ _ St (/ Rows.rho r') (Rows.scaled (/ z) (Rows.slip r' y))) as (h & Ch & Wh).
      { rewrite Rows.size_scaled by (assumption || lra). fold z. rewrite Iz1, I. lra. }
      specialize (Wh y). rewrite Rows.product_scaled, <- (Rows.size_square _ _ Wb) in Wh. fold z in Wh.
      rewrite <- Rmult_assoc, Iz1, Rmult_1_l in Wh. rewrite <- Wh.
      eapply Rle_trans; [apply Rows.product_bound; exact Wo|]. now apply Rmult_le_compat_r.
    + intros Same. rewrite Same. exact I.
Qed.

End Links.

(* ---- Proofs: an equilibrium at one multiple ---- *)

Lemma each_exists {A B} (P : A -> B -> Prop) them : Forall (fun a => exists b, P a b) them -> exists bs, Forall2 P them bs.
Proof.
  induction 1 as [|a them [b H] F [bs IH]]; [now exists []|]. exists (b :: bs). now constructor.
Qed.

Section AtSticking.
Variable n : nat.
Variable sys : Rows.system.
Variable d : vector.
Variable reach : vector.
Variable c : Q.
Variable xs : list linked.
Hypothesis d_length : List.length d = n.
Hypothesis reach_length : List.length reach = n.
Hypothesis c_positive : 0 < Q2R c.
Hypothesis all_linked : Forall (links n) xs.
Hypothesis own_rows : Rows.rows sys = map own_row xs.
Hypothesis loads_length : List.length (Rows.wrench sys) = n /\ List.length (Rows.direction sys) = n.

Let d0 : list R := real d.
Let Z (k : nat) : R := Q2R (nth k reach 0%Q).

Record sound (x : linked) : Prop := Sound {
  sound_weights : Forall (fun w => 0 < Q2R w) (box_weights (link_box x));
  sound_stiffness : 0 <= Q2R (low (box_stiffness (link_box x)));
  sound_spring : box_spring (link_box x) = false -> 0 < Q2R (low (box_stiffness (link_box x)));
  sound_friction : box_spring (link_box x) = true -> Q2R (high (box_friction (link_box x))) = 0
}.
Hypothesis all_sound : Forall sound xs.

Definition H_of (l : nat) (x : linked) : R := Q2R (nth l (presses (sticks x)) 0%Q).
Definition G_of (l : nat) (x : linked) : vector := nth l (answers (as_resting (sticks x))) [].
Definition as_force (x : linked) (f : vector) : list R := star (Rows.weights (box_row x)) (real f).
Definition base_at (lambda : R) (x : linked) : R := RowLimits.pressed (box_row x) d0 1 lambda.
Definition v_at (lambda : R) (x : linked) : R := Rows.v (box_row x) d0 1 lambda.

Definition stuck_answer (l : nat) (y : list R) : R :=
  over (fun x => Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) y) xs.
Definition stuck_still (lambda : R) (y : list R) : R :=
  Rows.load sys 1 lambda y +
  over (fun x => Rows.work (box_row x) (base_at lambda x, as_force x (force_at_rest (as_resting (sticks x)))) y) xs.

Definition swing_of (x : linked) : R := Q2R (swing_bound c (sticks x)).
Definition phi_of (x : linked) : R := if does_rub (sticks x) then Q2R (friction_bound reach (sticks x)) else 0.
Definition delta_of (x : linked) : R := Q2R (more_bound n reach (sticks x)).
Definition sigma_of (x : linked) : R := Q2R (slip_bound (link_box x) d).
Definition spare_at (lambda : R) (x : linked) : R := Rows.rho (box_row x) * (v_at lambda x - swing_of x) - phi_of x.

(* What has to hold of a contact at a multiple, and of its gamma. *)
Definition fine (lambda : R) (x : linked) : Prop :=
  (on_list (sticks x) = true -> Rows.spring (box_row x) = false -> swing_of x <= v_at lambda x) /\
  (does_rub (sticks x) = true -> Rows.spring (box_row x) = false /\ 0 < spare_at lambda x).

Definition has_share (lambda : R) (x : linked) (g : R) : Prop :=
  let k := Rows.stiffness (box_row x) in
  let both := delta_of x + Rows.rho (box_row x) * k * sigma_of x in
  0 <= g /\ (0 < k -> both * both <= 2 * k * (g - (Rows.rho (box_row x) * base_at lambda x + phi_of x) * sigma_of x)).

(* How far answers can be from e. *)
Definition far (lambda : R) (l : nat) (x : linked) : R :=
  Rabs (H_of l x) * Q2R (root_above (2 * c / low (box_stiffness (link_box x)))) +
  (if does_rub (sticks x)
   then Q2R (length_bound (link_box x) (G_of l x)) * (Q2R c / spare_at lambda x + sigma_of x)
   else 0).

(* Forces that balance, for some z. *)
Definition more_of (z : vec) (x : linked) : R := sum_to n (fun l => z l * H_of l x).
Definition friction_of (z : vec) (x : linked) : list R :=
  answered (Rows.weights (box_row x)) (force_at_rest (as_resting (sticks x))) (answers (as_resting (sticks x))) (listed n z).

Lemma weights_are x : links n x -> Rows.weights (box_row x) = real (box_weights (link_box x)).
Proof. intros L. apply (weights_real n), link_shaped, L. Qed.

Lemma G_short l x : links n x -> (List.length (real (G_of l x)) <= List.length (Rows.weights (box_row x)))%nat.
Proof.
  intros L. rewrite (weights_are x L). unfold real. rewrite !map_length. unfold G_of.
  destruct (nth_in_or_default l (answers (as_resting (sticks x))) []) as [H|H]; [|rewrite H; cbn; lia].
  pose proof (shaped_each _ _ _ (link_shaped n x L)) as F. rewrite Forall_forall in F. now apply F.
Qed.

Lemma counter_work lambda z x y : links n x ->
  Rows.work (box_row x) (base_at lambda x + more_of z x, friction_of z x) y =
  Rows.work (box_row x) (base_at lambda x, as_force x (force_at_rest (as_resting (sticks x)))) y +
  sum_to n (fun l => z l * Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) y).
Proof.
  intros L. pose proof (link_shaped n x L) as S. pose proof (RowLimits.weights_positive _ _ (shaped_proper _ _ _ S)) as P.
  pose proof (weights_are x L) as Wr. unfold Rows.work, friction_of, more_of, as_force. cbn [fst snd].
  assert (Lw : List.length (Rows.weights (box_row x)) = List.length (box_weights (link_box x))) by (rewrite Wr; apply map_length).
  rewrite product_answered; [|exact P|rewrite Lw; apply S|rewrite Lw; apply S].
  rewrite product_star; [|exact P|unfold real; rewrite map_length, Lw; apply S].
  assert (E : Rows.dot (listed n z) (map (fun a => Rows.dot (real a) (Rows.slip (box_row x) y)) (answers (as_resting (sticks x)))) =
    sum_to n (fun l => z l * Rows.product (Rows.weights (box_row x)) (star (Rows.weights (box_row x)) (real (G_of l x)))
      (Rows.slip (box_row x) y))).
  { rewrite (sum_same n _ (fun l => z l * Rows.dot (real (G_of l x)) (Rows.slip (box_row x) y))).
    - destruct (shaped_answers _ _ _ S) as [E|Le]; [|now apply (dot_listed_map n z (fun a => Rows.dot (real a) (Rows.slip (box_row x) y)))].
      unfold G_of. rewrite E. cbn. rewrite dot_nil, sum_zero; [reflexivity|]. intros [|l] _; cbn; ring.
    - intros l _. f_equal. apply product_star; [exact P|]. now apply G_short. }
  rewrite E. rewrite (sum_same n (fun l => z l * (H_of l x * _ + _))
    (fun l => Rows.dot (Rows.N (box_row x)) y * (z l * H_of l x) +
      z l * Rows.product (Rows.weights (box_row x)) (star (Rows.weights (box_row x)) (real (G_of l x))) (Rows.slip (box_row x) y)))
    by (intros; ring).
  rewrite sum_plus, sum_multiple. ring.
Qed.

Lemma counter_works lambda z y :
  Rows.load sys 1 lambda y + over (fun x => Rows.work (box_row x) (base_at lambda x + more_of z x, friction_of z x) y) xs =
  stuck_still lambda y + sum_to n (fun l => z l * stuck_answer l y).
Proof.
  unfold stuck_still, stuck_answer.
  assert (E : over (fun x => Rows.work (box_row x) (base_at lambda x + more_of z x, friction_of z x) y) xs =
    over (fun x => Rows.work (box_row x) (base_at lambda x, as_force x (force_at_rest (as_resting (sticks x)))) y) xs +
    sum_to n (fun l => z l * over (fun x => Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) y) xs)); [|rewrite E; ring].
  clear own_rows all_sound. induction all_linked as [|x xs' L _ IH]; cbn [over].
  - rewrite sum_zero by (intros; ring). ring.
  - rewrite (IH (Forall_inv_tail all_linked)), counter_work by exact L.
    rewrite (sum_same n (fun l => z l * (Rows.work _ _ _ + _))
      (fun l => z l * Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) y +
        z l * over (fun x => Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) y) xs')) by (intros; ring).
    rewrite sum_plus. ring.
Qed.

Lemma over_known (f : linked -> list R -> R) : (forall x, links n x -> known_by_units n (f x)) ->
  known_by_units n (fun y => over (fun x => f x y) xs).
Proof.
  intros H. clear own_rows all_sound. induction all_linked as [|x xs' L _ IH]; cbn [over]; [apply known_zero|].
  apply (known_plus n (f x)); [now apply H|exact (IH (Forall_inv_tail all_linked))].
Qed.

Lemma answer_is_known l : known_by_units n (stuck_answer l).
Proof. apply over_known. intros x L. apply work_known, (shaped_proper _ _ _ (link_shaped n x L)). Qed.

Lemma still_is_known lambda : known_by_units n (stuck_still lambda).
Proof.
  apply known_plus.
  - destruct loads_length as [L1 L2]. unfold Rows.load. apply known_plus; now apply known_multiple, dot_known.
  - apply over_known. intros x L. apply work_known, (shaped_proper _ _ _ (link_shaped n x L)).
Qed.

(* What is known of the contact in Energy.v. *)
Definition gripped (lambda : R) (z : vec) (g : linked -> R) (x : linked) (t : grip) : Prop :=
  grips n lambda d0 (Q2R c) t /\ own t = own_row x /\ gamma t = g x /\ is_listed t = on_list (sticks x) /\
  (forall y, Rows.work (own t) (counter t) y = Rows.work (box_row x) (base_at lambda x + more_of z x, friction_of z x) y) /\
  (forall e l, energy n d0 t e <= Q2R c ->
     Rabs (Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) (listed n e)) <= far lambda l x).

Lemma list_of_rub t : does_rub t = true -> on_list t = true.
Proof. unfold on_list. now intros ->. Qed.

Lemma contact_grips lambda z g x : links n x -> sound x -> in_box n Z z -> fine lambda x -> has_share lambda x (g x) ->
  (own_row x = box_row x \/ no_motion d = true) -> exists t, gripped lambda z g x t.
Proof.
  intros L So In_box [Pr Rb] [G0 G1] Still. pose proof (link_shaped n x L) as S.
  destruct (shaped_inside _ _ _ S) as (p & F & mu & tt & I). fold (sticker_box (sticks x)) in I. fold (link_box x) in I.
  pose proof (shaped_proper _ _ _ S) as Pb. pose proof (RowLimits.weights_positive _ _ Pb) as Wb.
  pose proof (rho_nonneg _ _ Pb) as R0. destruct (link_stands n x L) as [k0 St].
  pose proof (in_stiffness _ _ _ _ _ _ I) as [K1 K2]. pose proof (sound_stiffness x So) as K0.
  pose proof (slip_within _ _ _ _ _ _ I d) as Sl. fold (sigma_of x) in Sl.
  pose proof (slip_bound_nonneg (link_box x) d) as Sn. fold (sigma_of x) in Sn.
  (* Friction of what balances. *)
  assert (Zr : Forall2 (fun x m => Rabs x <= Q2R m) (listed n z) reach).
  { apply within_reach; [exact reach_length|exact In_box]. }
  assert (Sg : Rows.size (Rows.weights (box_row x)) (friction_of z x) <= phi_of x /\ 0 <= phi_of x).
  { unfold friction_of, phi_of. destruct (does_rub (sticks x)) eqn:Ru.
    - assert (A : Rows.size (real (box_weights (link_box x))) (answered (real (box_weights (link_box x)))
        (force_at_rest (as_resting (sticks x))) (answers (as_resting (sticks x))) (listed n z)) <= Q2R (friction_bound reach (sticks x))).
      { unfold friction_bound. rewrite reduced_same, Q2R_plus. apply size_answered; [apply (sound_weights x So)| |exact Zr].
        destruct (shaped_answers _ _ _ S) as [E|E]; rewrite E; [cbn; lia|lia]. }
      rewrite (weights_are x L). split; [exact A|]. eapply Rle_trans; [apply Rows.size_nonneg|exact A].
    - unfold does_rub in Ru. apply negb_false_iff, andb_true_iff in Ru as [E1 E2]. apply is_nothing_is in E1, E2.
      rewrite E1, E2, answered_nothing. lra. }
  destruct Sg as [Sg P0].
  assert (Ze : Rows.rho (box_row x) = 0 -> phi_of x = 0).
  { intros E. unfold phi_of in *. destruct (does_rub (sticks x)) eqn:Ru; [|reflexivity].
    destruct (Rb eq_refl) as [_ Sp]. unfold spare_at, phi_of in Sp. rewrite Ru, E in Sp. lra. }
  destruct (own_force n x (friction_of z x) (phi_of x) L P0 Sg Ze) as (u & f & U0 & Ur & Uf & Uw & Us & U1).
  assert (Spring : Rows.spring (own_row x) = Rows.spring (box_row x)) by (symmetry; apply (Leaf.same_spring _ _ _ St)).
  assert (Stiff : Rows.stiffness (own_row x) = Rows.stiffness (box_row x)) by (symmetry; apply (Leaf.same_stiffness _ _ _ St)).
  assert (Nn : Rows.N (own_row x) = Rows.N (box_row x)) by (symmetry; apply (Leaf.same_N _ _ _ St)).
  assert (V : forall e l, Rows.v (own_row x) e 1 l = Rows.v (box_row x) e 1 l) by (intros; symmetry; apply (same_pull _ _ _ _ _ _ St)).
  assert (Sigma : u * Rows.size (Rows.weights (own_row x)) (Rows.slip (own_row x) d0) <= sigma_of x).
  { destruct Still as [E|E].
    - rewrite (U1 E), E. unfold d0. lra.
    - replace (Rows.size (Rows.weights (own_row x)) (Rows.slip (own_row x) d0)) with 0; [lra|].
      unfold d0. rewrite (no_motion_is d E). symmetry. apply (slip_at_rest (List.length d)). }
  assert (Sq : 0 <= swing_of x /\ 2 * Q2R c * Rows.stiffness (box_row x) <= swing_of x * swing_of x).
  { unfold swing_of, swing_bound. set (q := (2 * c * high (box_stiffness (sticker_box (sticks x))))%Q).
    assert (Eq : Q2R q = 2 * Q2R c * Q2R (high (box_stiffness (link_box x)))).
    { unfold q, link_box. rewrite !Q2R_mult. replace (Q2R 2) with 2 by (unfold Q2R; cbn; lra). reflexivity. }
    assert (Q0 : 0 <= Q2R q) by (rewrite Eq; apply Rmult_le_pos; lra).
    pose proof (root_above_is q Q0) as A. pose proof (sqrt_pos (Q2R q)) as B. split; [lra|].
    assert (Q2R q <= Q2R (root_above q) * Q2R (root_above q)).
    { rewrite <- (sqrt_sqrt _ Q0) at 1. now apply Rmult_le_compat. }
    rewrite Eq in H. assert (2 * Q2R c * Rows.stiffness (box_row x) <= 2 * Q2R c * Q2R (high (box_stiffness (link_box x)))).
    { apply Rmult_le_compat_l; lra. } lra. }
  assert (Hz : Rabs (more_of z x) <= delta_of x).
  { unfold more_of, delta_of, more_bound.
    rewrite (sum_by_fold (fun l => absolute (nth l (presses (sticks x)) 0%Q)) (fun l => nth l reach 0%Q)), Q2R_0, Rplus_0_l.
    eapply Rle_trans; [apply sum_absolute|]. apply sum_below. intros l Hl. cbn [Nat.add]. rewrite Rabs_mult, Rmult_comm.
    apply Rmult_le_compat; try apply Rabs_pos; [apply absolute_bound|]. apply Rabs_le. now apply In_box. }
  exists (Grip (own_row x) (base_at lambda x + more_of z x, f) (base_at lambda x) (more_of z x) (Rows.rho (box_row x)) u
    (delta_of x) (phi_of x) (sigma_of x) (g x) (swing_of x) (spare_at lambda x) (on_list (sticks x)) (does_rub (sticks x))).
  set (t := Grip _ _ _ _ _ _ _ _ _ _ _ _ _ _).
  assert (Gr : grips n lambda d0 (Q2R c) t).
  { constructor; unfold t; cbn [own counter base more rough turned delta phi sigma gamma swing spare is_listed rubs fst snd];
      try assumption; try reflexivity.
    - apply (link_proper n x L).
    - rewrite Stiff. lra.
    - unfold base_at, RowLimits.pressed. now rewrite Spring, V.
    - rewrite Spring. intros Sp. apply (spring_has_no_friction _ _ Pb Sp).
    - rewrite Stiff, Spring. intros E. assert (Sp : Rows.spring (box_row x) = true).
      { rewrite (is_spring _ _ _ _ _ _ I). destruct (box_spring (link_box x)) eqn:Sp; [reflexivity|].
        pose proof (sound_spring x So Sp). lra. }
      split; [exact Sp|]. split; [|exact G0]. destruct (link_presses n x L) as [E2|E2]; [|lra].
      unfold more_of, H_of. rewrite E2. rewrite sum_zero; [reflexivity|]. intros [|l] _; cbn; rewrite Q2R_0; ring.
    - now rewrite Stiff.
    - intros E. unfold on_list in E. apply orb_false_iff in E as [E1 E2]. split; [|exact E1].
      apply negb_false_iff, is_nothing_is in E2. unfold more_of, H_of. rewrite E2. rewrite sum_zero; [reflexivity|].
      intros [|l] _; cbn; rewrite Q2R_0; ring.
    - rewrite Spring, Stiff, V. intros E1 E2. destruct Sq. split; [assumption|]. split; [assumption|]. now apply Pr.
    - rewrite Spring, V. intros E. destruct (Rb E) as [E1 E2]. split; [now apply list_of_rub|].
      split; [exact E1|]. split; [exact E2|]. right. reflexivity.
    - intros E. unfold phi_of. now rewrite E. }
  split; [exact Gr|]. split; [reflexivity|]. split; [reflexivity|]. split; [reflexivity|]. split.
  { intros y. unfold t, Rows.work. cbn [own counter fst snd]. now rewrite Nn, Uw. }
  intros e l En. unfold energy in En.
  pose proof (press_nonneg n lambda d0 (Q2R c) t e Gr) as E1. pose proof (rub_nonneg n lambda d0 (Q2R c) t e Gr) as E2.
  assert (Pe : press_energy n t e <= Q2R c) by lra. assert (Re : rub_energy n d0 t e <= Q2R c) by lra. clear En.
  unfold Rows.work, far. cbn [fst snd]. eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat.
  - rewrite Rabs_mult. destruct (is_nothing (presses (sticks x))) eqn:No.
    + assert (H_of l x = 0) as ->; [|rewrite Rabs_R0; lra].
      unfold H_of. rewrite (is_nothing_is _ No). destruct l; cbn; apply Q2R_0.
    + destruct (link_presses n x L) as [E|E]; [rewrite E in No; discriminate|].
      apply Rmult_le_compat_l; [apply Rabs_pos|].
      set (k := low (box_stiffness (link_box x))) in *. set (q := (2 * c / k)%Q).
      assert (Eq : Q2R q = 2 * Q2R c / Q2R k).
      { unfold q. rewrite Q2R_div, Q2R_mult by (intros X; apply Qeq_eqR in X; rewrite Q2R_0 in X; lra).
        replace (Q2R 2) with 2 by (unfold Q2R; cbn; lra). reflexivity. }
      unfold press_energy in Pe. cbn [own is_listed t] in Pe. unfold t in Pe. cbn [own is_listed] in Pe.
      unfold on_list in Pe. rewrite No, orb_true_r, Stiff, Nn in Pe.
      set (m := Rows.dot (Rows.N (box_row x)) (listed n e)) in *. set (kr := Rows.stiffness (box_row x)) in *.
      assert (Ik : 0 < / Q2R k) by now apply Rinv_0_lt_compat.
      assert (M : m * m <= Q2R q).
      { rewrite Eq. apply Rmult_le_reg_l with (Q2R k); [exact E|].
        replace (Q2R k * (2 * Q2R c / Q2R k)) with (2 * Q2R c) by (field; lra).
        pose proof (Rle_0_sqr m) as Sm. unfold Rsqr in Sm.
        assert (Q2R k * (m * m) <= kr * (m * m)) by now apply Rmult_le_compat_r. lra. }
      assert (Q0 : 0 <= Q2R q) by (pose proof (Rle_0_sqr m) as Sm; unfold Rsqr in Sm; lra).
      eapply Rle_trans; [|apply (root_above_is q Q0)]. rewrite <- sqrt_Rsqr_abs. now apply sqrt_le_1_alt.
  - unfold as_force. destruct (does_rub (sticks x)) eqn:Ru.
    + destruct (Rb eq_refl) as [_ Sp]. unfold rub_energy in Re. unfold t in Re. cbn [rubs spare turned own] in Re.
      cbv iota in Re.
      assert (Rp : 0 < Rows.rho (box_row x)).
      { destruct (Req_dec (Rows.rho (box_row x)) 0) as [E|E]; [|lra]. unfold spare_at in Sp. rewrite E, (Ze E) in Sp. lra. }
      set (ws := Rows.weights (box_row x)) in *. set (y := Rows.slip (box_row x) (listed n e)).
      assert (Lb : Rows.size ws (star ws (real (G_of l x))) <= Q2R (length_bound (link_box x) (G_of l x))).
      { unfold ws. rewrite (weights_are x L). apply size_star, (sound_weights x So). }
      assert (Ys : Rows.size ws y <= Q2R c / spare_at lambda x + sigma_of x).
      { specialize (Us Rp (moved n d0 e)). fold ws in Us.
        assert (Md : Rows.slip (box_row x) (moved n d0 e) = Rows.plus (Rows.slip (box_row x) d0) y).
        { unfold y. rewrite (moved_is n d0) by (unfold d0, real; now rewrite map_length). apply slip_plus. }
        set (mv := Rows.slip (box_row x) (moved n d0 e)) in *.
        assert (Opp : forall f, Rows.size ws (Rows.scaled (-1) f) = Rows.size ws f).
        { intros f0. rewrite size_scaled_any, Rabs_left by (assumption || lra). ring. }
        assert (Tri : Rows.size ws y <= Rows.size ws mv + Rows.size ws (Rows.slip (box_row x) d0)).
        { assert (Ey : Rows.size ws y = Rows.size ws (Rows.plus mv (Rows.scaled (-1) (Rows.slip (box_row x) d0)))).
          { unfold Rows.size. f_equal.
            assert (Same : forall p, Rows.product ws (Rows.plus mv (Rows.scaled (-1) (Rows.slip (box_row x) d0))) p = Rows.product ws y p).
            { intros p0. rewrite Md, !Rows.product_plus, Rows.product_scaled. ring. }
            now rewrite Same, (Rows.product_sym ws y (Rows.plus _ _)), Same. }
          rewrite Ey, <- (Opp (Rows.slip (box_row x) d0)). now apply Rows.size_plus. }
        fold d0 in Sl. fold ws in Sl.
        assert (Mv : u * Rows.size (Rows.weights (own_row x)) (Rows.slip (own_row x) (moved n d0 e)) <= Q2R c / spare_at lambda x).
        { apply Rmult_le_reg_l with (spare_at lambda x); [exact Sp|].
          replace (spare_at lambda x * (Q2R c / spare_at lambda x)) with (Q2R c) by (field; lra). exact Re. }
        lra. }
      set (g' := star ws (real (G_of l x))) in *.
      assert (Ab : Rabs (Rows.product ws g' y) <= Rows.size ws g' * Rows.size ws y).
      { apply Rabs_le. pose proof (Rows.product_bound ws g' y Wb) as B1.
        pose proof (Rows.product_bound ws (Rows.scaled (-1) g') y Wb) as B2. rewrite Rows.product_scaled in B2.
        rewrite size_scaled_any, Rabs_left in B2 by (assumption || lra). lra. }
      eapply Rle_trans; [exact Ab|]. apply Rmult_le_compat; try apply Rows.size_nonneg; assumption.
    + assert (No : G_of l x = []).
      { unfold does_rub in Ru. apply negb_false_iff, andb_true_iff in Ru as [_ E]. apply is_nothing_is in E.
        unfold G_of. rewrite E. now destruct l. }
      rewrite No. replace (Rows.product _ _ _) with 0; [rewrite Rabs_R0; lra|].
      destruct (Rows.weights (box_row x)); reflexivity.
Qed.

(* What has to hold at a multiple. *)
Definition reaches (lambda : R) : Prop := forall k, (k < n)%nat ->
  0 < Z k /\ Rabs (stuck_still lambda (basis_vector n k)) + sum_to n (fun l => Rabs (off n stuck_answer k l) * Z l) < Z k.

Variable bound : option (list Q).
Hypothesis bound_good : good_bound n bound = true.

Definition stays (lambda : R) : Prop :=
  match bound with
  | None => True
  | Some most => forall l, (l < n)%nat ->
      over (far lambda l) xs + sum_to n (fun k => Rabs (off n stuck_answer k l) * Q2R (room d most k)) <= Q2R (room d most l)
  end.

Variable two_sided : bool.
Hypothesis law : Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral).
Hypothesis all_pressing : two_sided = true -> Forall (fun x => box_spring (link_box x) = true \/ on_list (sticks x) = true) xs.
Hypothesis still : Forall (fun x => own_row x = box_row x \/ no_motion d = true) xs.
Hypothesis its_dimension : Rows.dimension sys = n.

Theorem stable_where_it_sticks lambda g : reaches lambda -> Forall (fine lambda) xs ->
  Forall (fun x => has_share lambda x (g x)) xs -> over g xs < Q2R c -> stays lambda ->
  Rows.stable_at (Rows.bounded (real_bound bound) 1) sys lambda.
Proof.
  intros Re Fi Sh Li Fa.
  assert (Zp : forall k, (k < n)%nat -> 0 < Z k) by (intros k K; now apply Re).
  destruct (answered_exactly n (fun k => stuck_still lambda (basis_vector n k))
    (fun k l => stuck_answer l (basis_vector n k)) Z) as (z & In_box & Zero).
  { intros k K. destruct (Re k K) as [Z0 R]. split; [lra|]. left. exact R. }
  destruct (each_exists (gripped lambda z g) xs) as (ts & G).
  { rewrite Forall_forall in *. intros x Hx. apply contact_grips; auto. }
  assert (Gr : Forall (grips n lambda d0 (Q2R c)) ts).
  { clear - G. induction G as [|x t xs' ts' (G1 & _) G IH]; constructor; assumption. }
  assert (Own : Rows.rows sys = map own ts).
  { rewrite own_rows. clear - G. induction G as [|x t xs' ts' (_ & E & _) G IH]; cbn; [reflexivity|]. now rewrite E, IH. }
  assert (Ga : over gamma ts = over g xs).
  { clear - G. induction G as [|x t xs' ts' (_ & _ & E & _) G IH]; cbn; [reflexivity|]. now rewrite E, IH. }
  assert (Co : forall y, Rows.works (map own ts) (map counter ts) y =
    over (fun x => Rows.work (box_row x) (base_at lambda x + more_of z x, friction_of z x) y) xs).
  { intros y. clear - G. induction G as [|x t xs' ts' (_ & _ & _ & _ & E & _) G IH]; cbn [map Rows.works over]; [reflexivity|].
    now rewrite E, IH. }
  assert (Far : forall e, Forall (fun t => energy n d0 t e <= Q2R c) ts -> forall l, (l < n)%nat ->
    Rabs (stuck_answer l (listed n e)) <= over (far lambda l) xs).
  { intros e En l _. unfold stuck_answer. eapply Rle_trans; [apply over_absolute|]. apply over_below.
    clear - G En. induction G as [|x t xs' ts' (_ & _ & _ & _ & _ & E) G IH]; constructor.
    - apply E. exact (Forall_inv En).
    - apply IH. exact (Forall_inv_tail En). }
  assert (Room : forall k, (k < n)%nat -> 0 < Z k /\ sum_to n (fun l => Rabs (off n stuck_answer k l) * Z l) < Z k).
  { intros k K. destruct (Re k K) as [Z0 R]. split; [exact Z0|]. pose proof (Rabs_pos (stuck_still lambda (basis_vector n k))). lra. }
  destruct (forces_found n lambda d0 (Q2R c)) with (sys := sys) (ts := ts)
    (B := fun k => sum_to n (fun l => Z l * over (far lambda l) xs) / (Z k - sum_to n (fun l => Rabs (off n stuck_answer k l) * Z l)))
    as (e & fs & En & Ob & Ba); try assumption.
  { unfold d0, real. now rewrite map_length. }
  { intros y. rewrite Co, counter_works.
    assert (Known : known_by_units n (fun y => stuck_still lambda y + sum_to n (fun l => z l * stuck_answer l y))).
    { apply known_plus; [apply still_is_known|].
      intros y'. rewrite (sum_same n (fun l => z l * stuck_answer l y')
        (fun l => sum_to n (fun i => nth i y' 0 * (z l * stuck_answer l (basis_vector n i))))).
      - rewrite sum_swapped. apply sum_same. intros i _. apply sum_multiple.
      - intros l _. rewrite (answer_is_known l y'), <- sum_multiple. apply sum_same. intros; ring. }
    rewrite (Known y). apply sum_zero. intros k K. rewrite (Zero k K). ring. }
  { rewrite Ga. exact Li. }
  { intros e En. apply (far_at_most n stuck_answer (fun l _ => answer_is_known l) Z Room). intros l Hl. now apply Far. }
  exists (moved n d0 e), fs. split; [|split; [|split]].
  - unfold stays in Fa. apply bounded_real. destruct bound as [most|]; [|exact Logic.I]. cbn in bound_good.
    apply andb_true_iff in bound_good as [Bl _].
    apply Nat.eqb_eq in Bl. apply Forall2_listed; [exact Bl|]. intros j J.
    pose proof (far_within n stuck_answer (fun l _ => answer_is_known l) Z Room (fun l => over (far lambda l) xs)
      (fun k => Q2R (room d most k)) e (Far e En) Fa j J) as W.
    unfold room in W. rewrite Q2R_minus in W. pose proof (absolute_bound (nth j d 0%Q)) as A.
    unfold d0. rewrite nth_real. rewrite Rmult_1_r. eapply Rle_trans; [apply Rabs_triang|]. lra.
  - unfold moved. now rewrite length_listed.
  - rewrite law. destruct two_sided; [|exact Ob]. specialize (all_pressing eq_refl). rewrite Own in Ob |- *.
    clear - d_length G Gr Ob En all_pressing all_linked. revert fs Ob all_pressing all_linked.
    induction G as [|x t xs' ts' (G1 & G2 & _ & G3 & _) G IH]; intros fs Ob Al Ll; inversion Ob as [|? [a f] ? fs' O1 O2]; subst;
      constructor.
    + destruct O1 as (L & C & D). split; [|now split]. unfold Rows.normal_law in *.
      destruct (Rows.spring (own t)) eqn:Sp; [exact L|].
      destruct (Forall_inv Al) as [X|X].
      * exfalso. destruct (link_stands n x (Forall_inv Ll)) as [k St].
        destruct (shaped_inside _ _ _ (link_shaped n x (Forall_inv Ll))) as (p & F & mu & tt & I).
        rewrite G2, <- (Leaf.same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I) in Sp. unfold link_box, sticker_box in X. congruence.
      * rewrite <- G3 in X. assert (Ld : List.length d0 = n) by (unfold d0, real; now rewrite map_length).
        pose proof (still_presses n lambda d0 (Q2R c) Ld t e G1 (Forall_inv En) X Sp) as Sps.
        assert (P : 0 <= Rows.v (own t) (moved n d0 e) 1 lambda) by lra.
        cbn in *. rewrite Rmax_right in L by exact P. now split.
    + apply IH; try assumption; eapply Forall_inv_tail; eassumption.
  - intros y. apply Ba.
Qed.

(* ---- Multiples between two ---- *)

Lemma v_mixed t a b x : v_at (mix t a b) x = mix t (v_at a x) (v_at b x).
Proof. unfold v_at, Rows.v, mix. ring. Qed.

Lemma spare_mixed t a b x : spare_at (mix t a b) x = mix t (spare_at a x) (spare_at b x).
Proof. unfold spare_at. rewrite v_mixed. unfold mix. ring. Qed.

(* Where nothing moves, nothing pulls. *)
Definition calm (lambda : R) : Prop := Forall (fun x => Rows.spring (box_row x) = false -> 0 <= v_at lambda x) xs.

Lemma base_mixed t a b x : 0 <= t <= 1 -> (Rows.spring (box_row x) = false -> 0 <= v_at a x) ->
  (Rows.spring (box_row x) = false -> 0 <= v_at b x) -> base_at (mix t a b) x = mix t (base_at a x) (base_at b x).
Proof.
  intros T A B. unfold base_at, RowLimits.pressed. pose proof (v_mixed t a b x) as E. unfold v_at in *.
  destruct (Rows.spring (box_row x)); [exact E|]. specialize (A eq_refl). specialize (B eq_refl).
  rewrite E, !Rmax_right; try assumption; [reflexivity|]. unfold mix. nra.
Qed.

Lemma still_mixed t a b y : 0 <= t <= 1 -> calm a -> calm b ->
  stuck_still (mix t a b) y = mix t (stuck_still a y) (stuck_still b y).
Proof.
  intros T A B. unfold stuck_still.
  assert (E : over (fun x => Rows.work (box_row x) (base_at (mix t a b) x, as_force x (force_at_rest (as_resting (sticks x)))) y) xs =
    mix t (over (fun x => Rows.work (box_row x) (base_at a x, as_force x (force_at_rest (as_resting (sticks x)))) y) xs)
          (over (fun x => Rows.work (box_row x) (base_at b x, as_force x (force_at_rest (as_resting (sticks x)))) y) xs)).
  { unfold calm in *. clear - T A B. induction A as [|x xs' A1 A IH]; cbn [over]; [unfold mix; ring|].
    rewrite (IH (Forall_inv_tail B)), (base_mixed t a b x T A1 (Forall_inv B)). unfold Rows.work, mix. cbn [fst snd]. ring. }
  rewrite E. unfold Rows.load, mix. ring.
Qed.

Lemma inverse_mixed t p q m : 0 <= t <= 1 -> 0 < p -> 0 < q -> 0 <= m -> m / mix t p q <= mix t (m / p) (m / q).
Proof.
  intros T P Q M. assert (Mp : 0 < mix t p q) by (unfold mix; destruct (Req_dec t 0); nra).
  unfold Rdiv. set (i := / p). set (j := / q). assert (I : p * i = 1) by (apply Rinv_r; lra). assert (J : q * j = 1) by (apply Rinv_r; lra).
  assert (Ip : 0 < i) by now apply Rinv_0_lt_compat. assert (Jp : 0 < j) by now apply Rinv_0_lt_compat.
  replace (mix t (m * i) (m * j)) with (m * ((1 - t) * i + t * j)) by (unfold mix; ring).
  apply Rmult_le_compat_l; [exact M|]. apply Rmult_le_reg_l with (mix t p q); [exact Mp|]. rewrite Rinv_r by lra. unfold mix.
  replace (((1 - t) * p + t * q) * ((1 - t) * i + t * j))
    with ((1 - t) * (1 - t) * (p * i) + t * t * (q * j) + t * (1 - t) * (p * j + q * i)) by ring.
  rewrite I, J.
  assert (Two : 2 <= p * j + q * i).
  { assert (E : p * j * ((1 - q * i) * (1 - q * i)) = p * j - 2 * ((p * i) * (q * j)) + (p * i) * (q * j) * (q * i)) by ring.
    rewrite I, J in E. assert (0 <= p * j * ((1 - q * i) * (1 - q * i))).
    { apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]. } lra. }
  assert (0 <= t * (1 - t) * (p * j + q * i - 2)) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]). lra.
Qed.

Lemma reaches_mixed t a b : 0 <= t <= 1 -> calm a -> calm b -> reaches a -> reaches b -> reaches (mix t a b).
Proof.
  intros T Ca Cb A B k K. destruct (A k K) as [Z0 A1]. destruct (B k K) as [_ B1]. split; [exact Z0|].
  rewrite still_mixed by assumption. set (x := sum_to _ _) in *. set (p := stuck_still a _) in *. set (q := stuck_still b _) in *.
  unfold mix. pose proof (Rabs_triang ((1 - t) * p) (t * q)) as Tr. rewrite !Rabs_mult in Tr.
  rewrite (Rabs_right (1 - t)), (Rabs_right t) in Tr by lra. destruct (Req_dec t 0) as [E|E]; [subst t; lra|]. nra.
Qed.

Lemma fine_mixed t a b x : 0 <= t <= 1 -> fine a x -> fine b x -> fine (mix t a b) x.
Proof.
  intros T [A1 A2] [B1 B2]. split.
  - intros L S. specialize (A1 L S). specialize (B1 L S). rewrite v_mixed. unfold mix. nra.
  - intros Ru. destruct (A2 Ru) as [S A]. destruct (B2 Ru) as [_ B]. split; [exact S|]. rewrite spare_mixed. unfold mix.
    destruct (Req_dec t 0) as [E|E]; [subst t; lra|]. nra.
Qed.

Lemma far_mixed t a b l x : 0 <= t <= 1 -> links n x -> sound x -> fine a x -> fine b x ->
  far (mix t a b) l x <= mix t (far a l x) (far b l x).
Proof.
  intros T L So [_ A] [_ B]. unfold far. set (h := Rabs _ * _).
  destruct (does_rub (sticks x)) eqn:Ru; [|unfold mix; lra].
  destruct (A eq_refl) as [_ Sa]. destruct (B eq_refl) as [_ Sb].
  pose proof (inverse_mixed t _ _ (Q2R c) T Sa Sb ltac:(lra)) as I. rewrite <- spare_mixed in I.
  assert (Lb : 0 <= Q2R (length_bound (link_box x) (G_of l x))).
  { eapply Rle_trans; [apply Rows.size_nonneg|apply (size_star (link_box x) (G_of l x)), (sound_weights x So)]. }
  set (lb := Q2R (length_bound _ _)) in *. unfold mix in *.
  assert (lb * (Q2R c / spare_at ((1 - t) * a + t * b) x) <= lb * ((1 - t) * (Q2R c / spare_at a x) + t * (Q2R c / spare_at b x)))
    by now apply Rmult_le_compat_l.
  lra.
Qed.

Lemma stays_mixed t a b : 0 <= t <= 1 -> Forall (fine a) xs -> Forall (fine b) xs -> stays a -> stays b -> stays (mix t a b).
Proof.
  intros T Fa Fb A B. unfold stays in *. destruct bound as [most|]; [|exact Logic.I]. intros l Hl.
  specialize (A l Hl). specialize (B l Hl).
  assert (O : over (far (mix t a b) l) xs <= mix t (over (far a l) xs) (over (far b l) xs)).
  { clear - T Fa Fb all_linked all_sound c_positive. induction all_linked as [|x xs' L _ IH]; cbn [over]; [unfold mix; lra|].
    specialize (IH (Forall_inv_tail all_linked) (Forall_inv_tail all_sound) (Forall_inv_tail Fa) (Forall_inv_tail Fb)).
    pose proof (far_mixed t a b l x T L (Forall_inv all_sound) (Forall_inv Fa) (Forall_inv Fb)). unfold mix in *. lra. }
  set (w := sum_to _ _) in *. unfold mix in *. nra.
Qed.

Lemma share_anywhere a b x g : no_motion d = true -> has_share a x g -> has_share b x g.
Proof.
  intros N [G0 G1]. split; [exact G0|]. intros K. specialize (G1 K).
  assert (S : sigma_of x = 0) by (unfold sigma_of, slip_bound; rewrite N; apply Q2R_0).
  rewrite S, !Rmult_0_r in *. exact G1.
Qed.

(* ---- What the rules say ---- *)

Variable s : setting.
Hypothesis fit : in_setting s sys.
Hypothesis n_is : dimension_of s = n.

Lemma in_between i x : within i x -> exists t, 0 <= t <= 1 /\ x = mix t (Q2R (low i)) (Q2R (high i)).
Proof.
  intros [L H]. set (a := Q2R (low i)) in *. set (b := Q2R (high i)) in *. destruct (Req_dec a b) as [E|E].
  - exists 0. split; [lra|]. unfold mix. lra.
  - assert (P : 0 < / (b - a)) by (apply Rinv_0_lt_compat; lra). exists ((x - a) / (b - a)). split; [split|].
    + apply Rmult_le_pos; lra.
    + apply Rmult_le_reg_r with (b - a); [lra|]. field_simplify; lra.
    + unfold mix. field. lra.
Qed.

Lemma work_as_sum x (a : Q) f y : links n x -> (List.length f <= List.length (box_weights (link_box x)))%nat ->
  Rows.dot (real (a :: f)) (times (Rows.N (box_row x) :: Rows.slips (box_row x)) y) =
  Rows.work (box_row x) (Q2R a, as_force x f) y.
Proof.
  intros L Le. rewrite times_forms. unfold Rows.work, as_force. cbn [fst snd].
  rewrite product_star; [reflexivity|apply (RowLimits.weights_positive _ _ (shaped_proper _ _ _ (link_shaped n x L)))|].
  rewrite (weights_are x L). unfold real. now rewrite !map_length.
Qed.

Lemma box_inside x : links n x -> inside (link_box x) (box_row x).
Proof. intros L. apply (link_shaped n x L). Qed.

Lemma left_of_contact q x : links n x ->
  all_within n (let a := push_range (link_box x) d q in
      ranges n (link_box x) [low a :: force_at_rest (as_resting (sticks x)); high a :: force_at_rest (as_resting (sticks x))])
    (fun k => Rows.work (box_row x) (base_at (Q2R q) x, as_force x (force_at_rest (as_resting (sticks x)))) (basis_vector n k)).
Proof.
  intros L. destruct (box_inside x L) as (p & F & mu & tt & I).
  destruct (in_between _ _ (push_within _ _ _ _ _ _ I d q)) as (t & T & E). cbv zeta.
  eapply all_within_same; [|apply (ranges_within n (link_box x) (box_row x) _
    (low (push_range (link_box x) d q) :: force_at_rest (as_resting (sticks x)))
    (high (push_range (link_box x) d q) :: force_at_rest (as_resting (sticks x))) t);
    [exact (box_inside x L)|apply (link_shaped n x L)|now left|right; now left|exact T]].
  intros k _. cbn beta. rewrite !work_as_sum by (exact L || apply (link_shaped n x L)).
  unfold base_at, d0. rewrite E. unfold Rows.work, mix. cbn [fst snd]. ring.
Qed.

Lemma left_within q : all_within n (stuck_left n s d (map sticks xs) q) (fun k => stuck_still (Q2R q) (basis_vector n k)).
Proof.
  unfold stuck_left, stuck_still.
  assert (G : forall acc f, all_within n acc f -> all_within n (fold_left (fun sum t =>
      let a := push_range (sticker_box t) d q in
      plus_intervals sum (ranges n (sticker_box t) [low a :: force_at_rest (as_resting t); high a :: force_at_rest (as_resting t)]))
    (map sticks xs) acc) (fun k => f k +
      over (fun x => Rows.work (box_row x) (base_at (Q2R q) x, as_force x (force_at_rest (as_resting (sticks x)))) (basis_vector n k)) xs)).
  { clear own_rows all_sound all_pressing still. induction all_linked as [|x xs' L _ IH]; intros acc f A; cbn [map fold_left over].
    - eapply all_within_same; [|exact A]. intros; cbn; ring.
    - eapply all_within_same; [|apply (IH (Forall_inv_tail all_linked)), plus_intervals_within; [exact A|exact (left_of_contact q x L)]].
      intros k _. cbn beta. ring. }
  apply G. exact (loads_within n s sys fit n_is q).
Qed.

Lemma column_of_contact l x : links n x ->
  all_within n (ranges n (link_box x) [nth l (presses (sticks x)) 0%Q :: nth l (answers (as_resting (sticks x))) []])
    (fun k => Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) (basis_vector n k)).
Proof.
  intros L. pose proof (G_short l x L) as Gs. rewrite (weights_are x L) in Gs. unfold real in Gs. rewrite !map_length in Gs.
  eapply all_within_same; [|apply (ranges_within n (link_box x) (box_row x) _
    (nth l (presses (sticks x)) 0%Q :: nth l (answers (as_resting (sticks x))) [])
    (nth l (presses (sticks x)) 0%Q :: nth l (answers (as_resting (sticks x))) []) 0);
    [exact (box_inside x L)|apply (link_shaped n x L)|now left|now left|lra]].
  intros k _. cbn beta. rewrite !work_as_sum by (exact L || exact Gs). unfold mix, H_of, G_of. ring.
Qed.

Lemma column_within l : all_within n (stuck_column n (map sticks xs) l) (fun k => stuck_answer l (basis_vector n k)).
Proof.
  unfold stuck_column, stuck_answer.
  assert (G : forall acc f, all_within n acc f -> all_within n (fold_left (fun sum t =>
      if on_list t
      then plus_intervals sum (ranges n (sticker_box t) [nth l (presses t) 0%Q :: nth l (answers (as_resting t)) []])
      else sum) (map sticks xs) acc) (fun k => f k +
      over (fun x => Rows.work (box_row x) (H_of l x, as_force x (G_of l x)) (basis_vector n k)) xs)).
  { clear own_rows all_sound all_pressing still. induction all_linked as [|x xs' L _ IH]; intros acc f A; cbn [map fold_left over].
    - eapply all_within_same; [|exact A]. intros; cbn; ring.
    - destruct (on_list (sticks x)) eqn:On.
      + eapply all_within_same;
          [|apply (IH (Forall_inv_tail all_linked)), plus_intervals_within; [exact A|exact (column_of_contact l x L)]].
        intros k _. cbn beta. ring.
      + eapply all_within_same; [|apply (IH (Forall_inv_tail all_linked)); exact A]. intros k _. cbn beta.
        unfold on_list, does_rub in On. apply orb_false_iff in On as [O1 O2].
        apply negb_false_iff in O1, O2. apply andb_true_iff in O1 as [_ O1]. apply is_nothing_is in O1, O2.
        unfold Rows.work, H_of, G_of, as_force. rewrite O1, O2. cbn [fst snd].
        rewrite !nth_nothing, Q2R_0. replace (Rows.product _ _ _) with 0; [ring|].
        destruct (Rows.weights (box_row x)); reflexivity. }
  eapply all_within_same; [|apply G]. 2: { instantiate (1 := fun _ => 0). split; [apply repeat_length|].
    intros k _. rewrite nth_exactly. unfold within; cbn. rewrite Q2R_0. lra. }
  intros k _. cbn beta. ring.
Qed.

Let columns : list (list interval) := map (stuck_column n (map sticks xs)) (seq 0 n).

Lemma off_most_is k l : (k < n)%nat -> (l < n)%nat -> Rabs (off n stuck_answer k l) <= Q2R (off_most columns k l).
Proof.
  intros K L. unfold off_most, off. apply most_of_bound. destruct (column_within l) as [_ W]. specialize (W k K).
  unfold columns. rewrite (nth_indep _ [] (stuck_column n (map sticks xs) 0)) by (now rewrite map_length, seq_length).
  rewrite map_nth, seq_nth by exact L. cbn [Nat.add].
  pose proof (shifted_within _ (if Nat.eqb k l then -(1) else 0)%Q _ W) as Sh.
  replace (Q2R (if Nat.eqb k l then -(1) else 0)) with (- (if Nat.eqb k l then 1 else 0)) in Sh; [exact Sh|].
  destruct (Nat.eqb k l); unfold Q2R; cbn; lra.
Qed.

Hypothesis reach_positive : forallb (Qlt_bool 0) reach = true.

Lemma Z_positive k : (k < n)%nat -> 0 < Z k.
Proof.
  intros K. unfold Z. rewrite forallb_forall in reach_positive. rewrite <- Q2R_0.
  apply lt_bool_R, reach_positive, nth_In. now rewrite reach_length.
Qed.

Lemma reaches_is q : stuck_reach_holds n reach columns (stuck_left n s d (map sticks xs) q) = true -> reaches (Q2R q).
Proof.
  intros H k K. split; [now apply Z_positive|]. unfold stuck_reach_holds in H. rewrite forallb_forall in H.
  specialize (H k). rewrite in_seq in H. specialize (H ltac:(lia)). apply lt_bool_R in H.
  rewrite (sum_by_fold (fun l => off_most columns k l) (fun l => nth l reach 0%Q)) in H. cbn [Nat.add] in H.
  eapply Rle_lt_trans; [|exact H]. apply Rplus_le_compat.
  - apply most_of_bound. destruct (left_within q) as [_ W]. exact (W k K).
  - apply sum_below. intros l Hl. apply Rmult_le_compat_r; [left; now apply Z_positive|now apply off_most_is].
Qed.

Lemma rho_between x : links n x ->
  Q2R (least_rho (link_box x)) <= Rows.rho (box_row x) <= Q2R (most_rho (link_box x)).
Proof.
  intros L. destruct (box_inside x L) as (p & F & mu & tt & I). rewrite (is_rho _ _ _ _ _ _ I).
  unfold least_rho, most_rho. rewrite !Q2R_mult. pose proof (in_friction _ _ _ _ _ _ I) as [M1 M2].
  pose proof (friction_nonneg _ _ _ _ _ _ I) as M0. pose proof (square_nonneg _ _ _ _ _ _ I) as Sq.
  pose proof (root_below_nonneg (box_square (link_box x))) as R0. pose proof (root_below_is _ Sq) as R1.
  pose proof (root_above_is _ Sq) as R2. pose proof (sqrt_pos (Q2R (box_square (link_box x)))) as R3.
  set (rb := Q2R (root_below _)) in *. set (ra := Q2R (root_above _)) in *. set (sq := sqrt _) in *. split.
  - apply Rle_trans with (mu * rb); [now apply Rmult_le_compat_r|now apply Rmult_le_compat_l].
  - apply Rle_trans with (mu * ra); [now apply Rmult_le_compat_l|apply Rmult_le_compat_r; lra].
Qed.

Lemma length_bound_nonneg x f : sound x -> 0 <= Q2R (length_bound (link_box x) f).
Proof. intros So. eapply Rle_trans; [apply Rows.size_nonneg|apply (size_star (link_box x) f), (sound_weights x So)]. Qed.

Lemma phi_below x : sound x -> phi_of x <= Q2R (friction_bound reach (sticks x)).
Proof.
  intros So. unfold phi_of. destruct (does_rub (sticks x)) eqn:Ru; [lra|].
  unfold does_rub in Ru. apply negb_false_iff, andb_true_iff in Ru as [_ E]. apply is_nothing_is in E.
  unfold friction_bound. rewrite reduced_same, Q2R_plus, E.
  replace (answers_bound _ [] reach) with 0%Q by now destruct reach. rewrite Q2R_0.
  pose proof (length_bound_nonneg x (force_at_rest (as_resting (sticks x))) So). unfold link_box in *. lra.
Qed.

Lemma v_within q x : links n x -> within (pull_range (link_box x) d q) (v_at (Q2R q) x).
Proof. intros L. destruct (box_inside x L) as (p & F & mu & tt & I). exact (pull_within _ _ _ _ _ _ I d q). Qed.

Lemma its_spring x : links n x -> Rows.spring (box_row x) = box_spring (link_box x).
Proof. intros L. destruct (box_inside x L) as (p & F & mu & tt & I). apply (is_spring _ _ _ _ _ _ I). Qed.

Lemma spare_below q x : links n x -> sound x -> press_holds d reach c q (sticks x) = true -> does_rub (sticks x) = true ->
  box_spring (link_box x) = false /\ 0 < Q2R (spare_least d reach c q (sticks x)) <= spare_at (Q2R q) x.
Proof.
  intros L So H Ru. unfold press_holds in H. rewrite !andb_true_iff in H. destruct H as [[_ H1] H2].
  rewrite Ru in H2. cbn [negb orb] in H2. apply andb_true_iff in H2 as [Sp H2]. apply negb_true_iff in Sp.
  rewrite (list_of_rub _ Ru), Sp in H1. cbn [negb orb] in H1. apply Qle_bool_R in H1.
  apply lt_bool_R in H2. rewrite Q2R_0 in H2. split; [exact Sp|]. split; [exact H2|].
  unfold spare_least, spare_at, phi_of, swing_of. rewrite Ru, reduced_same, !Q2R_minus, Q2R_mult, Q2R_minus.
  pose proof (rho_between x L) as [R1 _]. pose proof (v_within q x L) as [V1 _]. unfold link_box in *.
  pose proof (rho_nonneg _ _ (shaped_proper _ _ _ (link_shaped n x L))) as R0.
  set (lr := Q2R (least_rho _)) in *. set (lv := Q2R (low (pull_range _ _ _))) in *. set (sw := Q2R (swing_bound _ _)) in *.
  assert (lr * (lv - sw) <= Rows.rho (box_row x) * (lv - sw)) by (apply Rmult_le_compat_r; lra).
  assert (Rows.rho (box_row x) * (lv - sw) <= Rows.rho (box_row x) * (v_at (Q2R q) x - sw)) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Lemma fine_is q x : links n x -> sound x -> press_holds d reach c q (sticks x) = true -> fine (Q2R q) x.
Proof.
  intros L So H. split.
  - intros On Sp. rewrite (its_spring x L) in Sp. unfold press_holds in H. rewrite !andb_true_iff in H. destruct H as [[_ H] _].
    unfold link_box in Sp. rewrite On, Sp in H. cbn [negb orb] in H. apply Qle_bool_R in H.
    pose proof (v_within q x L) as [V _]. unfold link_box in V. unfold swing_of. lra.
  - intros Ru. destruct (spare_below q x L So H Ru) as [Sp P]. rewrite (its_spring x L). split; [exact Sp|lra].
Qed.

Lemma absolute_0 : Q2R (absolute 0%Q) = 0.
Proof. unfold Q2R. cbn. lra. Qed.

Lemma delta_nonneg x : 0 <= delta_of x.
Proof.
  unfold delta_of, more_bound.
  rewrite (sum_by_fold (fun l => absolute (nth l (presses (sticks x)) 0%Q)) (fun l => nth l reach 0%Q)), Q2R_0, Rplus_0_l.
  apply sum_nonneg. intros l Hl. cbn [Nat.add]. apply Rmult_le_pos; [|left; now apply Z_positive].
  eapply Rle_trans; [apply Rabs_pos|apply absolute_bound].
Qed.

Lemma no_delta x : presses (sticks x) = [] -> delta_of x = 0.
Proof.
  intros E. unfold delta_of, more_bound.
  rewrite (sum_by_fold (fun l => absolute (nth l (presses (sticks x)) 0%Q)) (fun l => nth l reach 0%Q)), Q2R_0, Rplus_0_l.
  apply sum_zero. intros l _. cbn [Nat.add]. rewrite E, nth_nothing, absolute_0. ring.
Qed.

(* gamma is convex in k'. *)
Lemma convex_share t a a' b p m : 0 <= t <= 1 ->
  (p + m * a) * (p + m * a) <= 2 * a * b -> (p + m * a') * (p + m * a') <= 2 * a' * b ->
  (p + m * mix t a a') * (p + m * mix t a a') <= 2 * mix t a a' * b.
Proof.
  intros T A B. set (x := p + m * a) in *. set (y := p + m * a') in *.
  replace (p + m * mix t a a') with ((1 - t) * x + t * y) by (unfold x, y, mix; ring).
  assert (E : ((1 - t) * x + t * y) * ((1 - t) * x + t * y) = (1 - t) * (x * x) + t * (y * y) - t * (1 - t) * ((x - y) * (x - y))) by ring.
  assert (0 <= t * (1 - t) * ((x - y) * (x - y))) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply Rle_0_sqr]).
  assert (S1 : (1 - t) * (x * x) <= (1 - t) * (2 * a * b)) by (apply Rmult_le_compat_l; lra).
  assert (S2 : t * (y * y) <= t * (2 * a' * b)) by (apply Rmult_le_compat_l; lra).
  unfold mix. lra.
Qed.

Lemma share_is q x : links n x -> sound x -> fine (Q2R q) x -> has_share (Q2R q) x (Q2R (share_most n d reach q (sticks x))).
Proof.
  intros L So [_ Fi]. destruct (box_inside x L) as (p & F & mu & tt & I).
  pose proof (in_stiffness _ _ _ _ _ _ I) as Kw. pose proof (delta_nonneg x) as Dn. pose proof (phi_below x So) as Pb.
  pose proof (rho_between x L) as [_ R1]. pose proof (rho_nonneg _ _ (shaped_proper _ _ _ (link_shaped n x L))) as R0.
  pose proof (slip_bound_nonneg (link_box x) d) as Sn. fold (sigma_of x) in Sn.
  pose proof (push_within _ _ _ _ _ _ I d q) as [_ Aw]. fold d0 in Aw. fold (base_at (Q2R q) x) in Aw.
  unfold share_most. destruct (is_nothing (presses (sticks x)) && no_motion d) eqn:No.
  { apply andb_true_iff in No as [N1 N2]. apply is_nothing_is in N1. unfold has_share. rewrite Q2R_0.
    assert (S0 : sigma_of x = 0) by (unfold sigma_of, slip_bound; rewrite N2; apply Q2R_0).
    rewrite (no_delta x N1), S0. split; [lra|]. intros _. lra. }
  fold (sticker_box (sticks x)). fold (link_box x). set (k := box_stiffness (link_box x)) in *.
  set (g := Qmax 0 _). set (kr := Rows.stiffness (box_row x)) in *.
  assert (G0 : 0 <= Q2R g) by (rewrite <- Q2R_0; apply max_R).
  assert (Gl : Q2R (share_at n d reach q (sticks x) (low k)) <= Q2R g).
  { eapply Rle_trans; [|apply max_R]. apply max_R. }
  assert (Gh : Q2R (share_at n d reach q (sticks x) (high k)) <= Q2R g).
  { eapply Rle_trans; [|apply max_R]. apply max_R. }
  split; [exact G0|]. intros Kp. fold kr in Kp |- *.
  pose proof (sound_stiffness x So) as K0. fold k in K0.
  destruct (Req_dec (Q2R (low k)) 0) as [Kz|Kz].
  { assert (Sp : box_spring (link_box x) = true).
    { destruct (box_spring (link_box x)) eqn:Sp; [reflexivity|]. pose proof (sound_spring x So Sp) as X. fold k in X. lra. }
    assert (Rz : Rows.rho (box_row x) = 0).
    { apply (spring_has_no_friction _ _ (shaped_proper _ _ _ (link_shaped n x L))). now rewrite (its_spring x L). }
    assert (Ru : does_rub (sticks x) = false).
    { destruct (does_rub (sticks x)) eqn:Ru; [|reflexivity]. destruct (Fi eq_refl) as [X _]. rewrite (its_spring x L) in X. congruence. }
    assert (Pz : phi_of x = 0) by (unfold phi_of; now rewrite Ru).
    destruct (link_presses n x L) as [E|E]; [|fold k in E; lra].
    rewrite (no_delta x E), Rz, Pz. assert (0 <= 2 * kr * Q2R g) by (apply Rmult_le_pos; lra). lra. }
  (* Above 0. *)
  set (m := (Q2R (most_rho (link_box x)) * Q2R (high (push_range (link_box x) d q)) + Q2R (friction_bound reach (sticks x))) * sigma_of x).
  assert (End : forall e, 0 < Q2R e -> Q2R (share_at n d reach q (sticks x) e) <= Q2R g ->
    (delta_of x + Q2R (most_rho (link_box x)) * sigma_of x * Q2R e) * (delta_of x + Q2R (most_rho (link_box x)) * sigma_of x * Q2R e)
    <= 2 * Q2R e * (Q2R g - m)).
  { intros e Ep H. unfold share_at in H. destruct (Qle_bool e 0) eqn:Le; [apply Qle_bool_R in Le; rewrite Q2R_0 in Le; lra|].
    fold (link_box x) in H. rewrite reduced_same, Q2R_plus, Q2R_div, !Q2R_mult in H.
    2: { intros X. apply Qeq_eqR in X. rewrite Q2R_mult, Q2R_0 in X. replace (Q2R 2) with 2 in X by (unfold Q2R; cbn; lra). lra. }
    rewrite Q2R_plus, Q2R_mult, reduced_same, Q2R_plus, !Q2R_mult in H. replace (Q2R 2) with 2 in H by (unfold Q2R; cbn; lra).
    fold (delta_of x) in H. fold (sigma_of x) in H. fold m in H.
    set (y := delta_of x + Q2R (most_rho (link_box x)) * sigma_of x * Q2R e).
    replace (delta_of x + Q2R (most_rho (link_box x)) * Q2R e * sigma_of x) with y in H by (unfold y; ring).
    assert (Y : y * y / (2 * Q2R e) <= Q2R g - m) by lra.
    apply (Rmult_le_compat_l (2 * Q2R e)) in Y; [|lra]. replace (2 * Q2R e * (y * y / (2 * Q2R e))) with (y * y) in Y by (field; lra).
    exact Y. }
  assert (Kl : 0 < Q2R (low k)) by lra. assert (Kh : 0 < Q2R (high k)) by (destruct Kw; lra).
  pose proof (End _ Kl Gl) as E1. pose proof (End _ Kh Gh) as E2. destruct (in_between _ _ Kw) as (t & T & Et).
  pose proof (convex_share t _ _ _ _ _ T E1 E2) as Cv. rewrite <- Et in Cv. fold kr in Cv.
  set (R_ := Q2R (most_rho (link_box x))) in *.
  assert (Small : delta_of x + Rows.rho (box_row x) * kr * sigma_of x <= delta_of x + R_ * sigma_of x * kr).
  { replace (R_ * sigma_of x * kr) with (R_ * (kr * sigma_of x)) by ring. rewrite Rmult_assoc. apply Rplus_le_compat_l.
    apply Rmult_le_compat_r; [|exact R1]. apply Rmult_le_pos; lra. }
  assert (Pos : 0 <= delta_of x + Rows.rho (box_row x) * kr * sigma_of x).
  { assert (0 <= Rows.rho (box_row x) * kr * sigma_of x) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact Sn]). lra. }
  assert (Sqs : (delta_of x + Rows.rho (box_row x) * kr * sigma_of x) * (delta_of x + Rows.rho (box_row x) * kr * sigma_of x) <=
    (delta_of x + R_ * sigma_of x * kr) * (delta_of x + R_ * sigma_of x * kr)) by now apply Rmult_le_compat.
  assert (Ms : (Rows.rho (box_row x) * base_at (Q2R q) x + phi_of x) * sigma_of x <= m).
  { unfold m. apply Rmult_le_compat_r; [exact Sn|]. apply Rplus_le_compat; [|exact Pb].
    destruct (box_spring (link_box x)) eqn:Sp.
    - assert (Rows.rho (box_row x) = 0) as ->.
      { apply (spring_has_no_friction _ _ (shaped_proper _ _ _ (link_shaped n x L))). now rewrite (its_spring x L). }
      unfold R_, most_rho. rewrite Q2R_mult, (sound_friction x So Sp). lra.
    - assert (B0 : 0 <= base_at (Q2R q) x).
      { unfold base_at, RowLimits.pressed. rewrite (its_spring x L), Sp. apply Rmax_l. }
      apply Rmult_le_compat; assumption. }
  assert (2 * kr * (Q2R g - m) <= 2 * kr * (Q2R g - (Rows.rho (box_row x) * base_at (Q2R q) x + phi_of x) * sigma_of x)).
  { apply Rmult_le_compat_l; lra. }
  lra.
Qed.

Lemma sum_over_stickers (f : sticker -> Q) init ys : Q2R (fold_left (fun sum t => reduced (sum + f t)%Q) (map sticks ys) init) =
  Q2R init + over (fun x => Q2R (f (sticks x))) ys.
Proof.
  revert init. induction ys as [|y ys IH]; intros init; cbn [map fold_left over]; [ring|].
  rewrite IH, reduced_same, Q2R_plus. ring.
Qed.

Lemma energy_is q : energy_holds n d reach c (map sticks xs) q = true ->
  over (fun x => Q2R (share_most n d reach q (sticks x))) xs < Q2R c.
Proof.
  intros H. apply lt_bool_R in H. rewrite (sum_over_stickers (share_most n d reach q)), Q2R_0 in H. lra.
Qed.

Lemma far_is q l x : links n x -> sound x -> press_holds d reach c q (sticks x) = true ->
  far (Q2R q) l x <= Q2R (far_most d reach c q (sticks x) l).
Proof.
  intros L So H. unfold far, far_most. fold (link_box x). rewrite reduced_same, Q2R_plus, Q2R_mult. apply Rplus_le_compat.
  - unfold H_of. destruct (link_presses n x L) as [E|E].
    + rewrite E, nth_nothing, absolute_0, Q2R_0, Rabs_R0. lra.
    + apply Rmult_le_compat_r; [|apply absolute_bound].
      assert (Q0 : 0 <= Q2R (2 * c / low (box_stiffness (link_box x)))).
      { rewrite Q2R_div, Q2R_mult by (intros X; apply Qeq_eqR in X; rewrite Q2R_0 in X; lra).
        replace (Q2R 2) with 2 by (unfold Q2R; cbn; lra). apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat. }
      eapply Rle_trans; [apply sqrt_pos|now apply root_above_is].
  - destruct (does_rub (sticks x)) eqn:Ru; [|rewrite Q2R_0; lra].
    destruct (spare_below q x L So H Ru) as [_ [P S]]. rewrite Q2R_mult, Q2R_plus.
    rewrite Q2R_div by (intros X; apply Qeq_eqR in X; rewrite Q2R_0 in X; lra). fold (sigma_of x).
    apply Rmult_le_compat_l; [now apply length_bound_nonneg|]. apply Rplus_le_compat_r.
    apply Rmult_le_compat_l; [lra|]. now apply Rinv_le_contravar.
Qed.

Lemma stays_is q : Forall (fun x => press_holds d reach c q (sticks x) = true) xs ->
  stuck_bound_holds n d reach c (map sticks xs) columns q bound = true -> stays (Q2R q).
Proof.
  intros Pr H. unfold stays, stuck_bound_holds in *. destruct bound as [most|]; [|exact Logic.I]. intros l Hl.
  rewrite forallb_forall in H.
  assert (Each : forall k, (k < n)%nat -> 0 < Q2R (room d most k)).
  { intros k K. specialize (H k). rewrite in_seq in H. specialize (H ltac:(lia)). apply andb_true_iff in H as [H _].
    apply lt_bool_R in H. now rewrite Q2R_0 in H. }
  specialize (H l). rewrite in_seq in H. specialize (H ltac:(lia)). apply andb_true_iff in H as [_ H].
  apply Qle_bool_R in H. rewrite (sum_by_fold (fun k => off_most columns k l) (room d most)) in H.
  rewrite (sum_over_stickers (fun t => far_most d reach c q t l)), Q2R_0, Rplus_0_l in H. cbn [Nat.add] in H.
  eapply Rle_trans; [|exact H]. apply Rplus_le_compat.
  - apply over_below. clear - Pr all_linked all_sound c_positive reach_positive. rewrite Forall_forall in *.
    intros x Hx. apply far_is; auto.
  - apply sum_below. intros k K. apply Rmult_le_compat_r; [left; now apply Each|now apply off_most_is].
Qed.

End AtSticking.

(* ---- The theorem ---- *)

(* What the rules at one multiple say. *)
Lemma rules_at n s d reach c them columns q : sticking_fails_at n s d reach c them columns q = None ->
  stuck_reach_holds n reach columns (stuck_left n s d them q) = true /\
  Forall (fun t => press_holds d reach c q t = true) them /\
  energy_holds n d reach c them q = true /\ stuck_bound_holds n d reach c them columns q (the_bound s) = true.
Proof.
  unfold sticking_fails_at. intros H. destruct (stuck_reach_holds _ _ _ _); [|discriminate]. cbn [negb] in H.
  destruct (forallb _ them) eqn:P; [|discriminate]. cbn [negb] in H.
  destruct (energy_holds _ _ _ _ _ _); [|discriminate]. cbn [negb] in H.
  destruct (stuck_bound_holds _ _ _ _ _ _ _ _); [|discriminate]. repeat split.
  rewrite forallb_forall in P. now apply Forall_forall.
Qed.

Lemma sound_by_rule n d reach c q x : links n x -> press_holds d reach c q (sticks x) = true ->
  sound x /\ (no_motion d = true -> Rows.spring (box_row x) = false -> 0 <= v_at d (Q2R q) x).
Proof.
  intros L H. unfold press_holds in H. rewrite !andb_true_iff in H. destruct H as [[So _] _].
  unfold sticker_sound in So. rewrite !andb_true_iff in So. destruct So as [[Re K0] K1].
  unfold resting_sound in Re. rewrite !andb_true_iff in Re. destruct Re as [[[Fs W] Sq] Pr].
  fold (sticker_box (sticks x)) in *. fold (link_box x) in *.
  destruct (shaped_inside _ _ _ (link_shaped n x L)) as (p & F & mu & tt & I). fold (sticker_box (sticks x)) in I. fold (link_box x) in I.
  unfold friction_sound in Fs. apply andb_true_iff in Fs as [F0 Fs]. split.
  - constructor.
    + now apply positive_weights.
    + apply Qle_bool_R in K0. now rewrite Q2R_0 in K0.
    + intros Sp. rewrite Sp, orb_false_l in K1. apply lt_bool_R in K1. now rewrite Q2R_0 in K1.
    + intros Sp. rewrite Sp in Fs. cbn in Fs. apply Qle_bool_R in F0, Fs. rewrite Q2R_0 in F0, Fs.
      pose proof (in_friction _ _ _ _ _ _ I) as [M1 M2]. lra.
  - intros N Sp. rewrite (is_spring _ _ _ _ _ _ I) in Sp. rewrite Sp, orb_false_l in Pr. apply Qle_bool_R in Pr. rewrite Q2R_0 in Pr.
    destruct (pressure_between n q _ _ (link_shaped n x L)) as (t & T & E). fold (sticker_box (sticks x)) in E. fold (link_box x) in E.
    unfold v_at, Rows.v. rewrite (nothing_moves _ d N).
    replace (Rows.preload (box_row x) * 1 + Rows.growth (box_row x) * Q2R q - Rows.stiffness (box_row x) * 0)
      with (pressure (Q2R q) (box_row x)) by (unfold pressure; ring).
    rewrite E. unfold least_pressure, pressures in Pr.
    set (a := (low (box_preload (link_box x)) + q * low (box_growth (link_box x)))%Q) in *.
    set (b := (high (box_preload (link_box x)) + q * high (box_growth (link_box x)))%Q) in *.
    destruct (min_R a b). unfold mix. nra.
Qed.

Theorem stable_by_sticking (two_sided : bool) s sys alpha beta p lambda : in_setting s sys ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  sticking_fails two_sided s alpha beta p = None -> Q2R alpha <= lambda <= Q2R beta ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros Fit Law H Between. pose proof Fit as [(Su & _) Di Pr Le _ _ Bd]. unfold sticking_fails in H.
  set (n := dimension_of s) in *. destruct (stickers n (rows s) p) as [them|] eqn:St; [|discriminate].
  destruct (motion_holds two_sided (Qeq_bool alpha beta) (stuck_twist p) them) eqn:Mo; [|discriminate]. cbn [negb] in H.
  unfold stickers in St. destruct (_ && _) eqn:C in St; [|discriminate]. rewrite !andb_true_iff in C.
  destruct C as [[[C1 C2] C3] C4]. apply Nat.eqb_eq in C1, C2. apply lt_bool_R in C4. rewrite Q2R_0 in C4.
  destruct (resting_contacts n (rows s) 0 _ _ []) as [found|] eqn:Rc; [|discriminate].
  destruct (linked_all n (rows s) (Rows.rows sys) found them 0 (stuck_friction p) (stuck_answers p) 0 (stuck_presses p) Su Pr Rc St)
    as (xs & Li & Own & Sti).
  set (d := stuck_twist p) in *. set (reach := stuck_reach p) in *. set (c := stuck_energy p) in *.
  subst them. set (holds := sticking_fails_at n s d reach c (map sticks xs) (map (stuck_column n (map sticks xs)) (seq 0 n))) in H.
  destruct (holds alpha) eqn:Ha; [discriminate|].
  (* What holds at a multiple of which the rules hold. *)
  assert (Rules : forall q, holds q = None ->
    Forall sound xs /\ reaches n sys d reach xs (Q2R q) /\ Forall (fine d reach c (Q2R q)) xs /\
    Forall (fun x => has_share n d reach (Q2R q) x (Q2R (share_most n d reach q (sticks x)))) xs /\
    over (fun x => Q2R (share_most n d reach q (sticks x))) xs < Q2R c /\ stays n d reach c xs (the_bound s) (Q2R q) /\
    (no_motion d = true -> calm d xs (Q2R q))).
  { intros q Hq. destruct (rules_at _ _ _ _ _ _ _ _ Hq) as (R1 & R2 & R3 & R4). rewrite Forall_map in R2.
    assert (So : Forall sound xs).
    { rewrite Forall_forall in *. intros x Hx. exact (proj1 (sound_by_rule n d reach c q x (Li x Hx) (R2 x Hx))). }
    assert (Fi : Forall (fine d reach c (Q2R q)) xs).
    { rewrite Forall_forall in *. intros x Hx. apply (fine_is n); auto. }
    split; [exact So|]. split; [now apply (reaches_is n sys d reach xs C1 C2 Li Le Di s Fit eq_refl C3)|].
    split; [exact Fi|]. split; [|split; [|split]].
    - rewrite Forall_forall in *. intros x Hx. apply (share_is n d reach c); auto.
    - now apply (energy_is n d reach c).
    - now apply (stays_is n sys d reach c xs C1 C2 C4 Li Le So (the_bound s) Bd Di s eq_refl).
    - intros N. unfold calm. rewrite Forall_forall in *. intros x Hx.
      exact (proj2 (sound_by_rule n d reach c q x (Li x Hx) (R2 x Hx)) N). }
  destruct (Rules alpha Ha) as (So & Re & Fi & Sh & En & Sy & Ca).
  unfold motion_holds in Mo. apply andb_true_iff in Mo as [Mo1 Mo2].
  assert (Still : Forall (fun x => own_row x = box_row x \/ no_motion d = true) xs).
  { destruct (no_motion d) eqn:N; [apply Forall_forall; now right|]. cbn in Mo1. apply andb_true_iff in Mo1 as [_ Mo1].
    rewrite forallb_forall in Mo1. rewrite Forall_forall in *. intros x Hx. left. symmetry. apply (link_straight n x (Li x Hx)).
    apply negb_true_iff, (Mo1 (sticks x)). now apply in_map. }
  assert (All : two_sided = true -> Forall (fun x => box_spring (link_box x) = true \/ on_list (sticks x) = true) xs).
  { intros E. rewrite E in Mo2. cbn in Mo2. rewrite forallb_forall in Mo2. apply Forall_forall. intros x Hx.
    apply orb_true_iff, (Mo2 (sticks x)). now apply in_map. }
  assert (End : forall g, reaches n sys d reach xs lambda -> Forall (fine d reach c lambda) xs ->
    Forall (fun x => has_share n d reach lambda x (g x)) xs -> over g xs < Q2R c -> stays n d reach c xs (the_bound s) lambda ->
    Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda).
  { intros g. exact (stable_where_it_sticks n sys d reach c xs C1 C2 C4 Li (eq_sym Own) Le So (the_bound s) Bd two_sided Law All
      Still Di lambda g). }
  destruct (Qeq_bool alpha beta) eqn:Q.
  - apply Qeq_bool_eq, Qeq_eqR in Q. assert (lambda = Q2R alpha) as -> by lra.
    now apply (End (fun x => Q2R (share_most n d reach alpha (sticks x)))).
  - assert (N : no_motion d = true) by (rewrite orb_false_r in Mo1; exact Mo1).
    destruct (Rules beta H) as (_ & Re' & Fi' & _ & _ & Sy' & Ca'). specialize (Ca N). specialize (Ca' N).
    set (a := Q2R alpha) in *. set (b := Q2R beta) in *.
    assert (NE : a < b).
    { destruct (Req_dec a b) as [Eq|Ne]; [|lra]. apply eqR_Qeq, Qeq_eq_bool in Eq. congruence. }
    assert (Ip : 0 < / (b - a)) by (apply Rinv_0_lt_compat; lra).
    set (t := (lambda - a) / (b - a)). assert (T : 0 <= t <= 1).
    { unfold t. split; [apply Rmult_le_pos; lra|]. apply Rmult_le_reg_r with (b - a); [lra|]. field_simplify; lra. }
    assert (Lm : lambda = mix t a b) by (unfold t, mix; field; lra). rewrite Lm in End |- *.
    apply (End (fun x => Q2R (share_most n d reach alpha (sticks x)))).
    + now apply reaches_mixed.
    + rewrite Forall_forall in *. intros x Hx. apply fine_mixed; auto.
    + rewrite Forall_forall in *. intros x Hx. apply (share_anywhere n d reach a); auto.
    + exact En.
    + apply (stays_mixed n d reach c xs C4 Li So (the_bound s) Bd); assumption.
Qed.
