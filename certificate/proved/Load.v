(* SPDX-License-Identifier: MIT *)
(* The loads of a box (FORMAT.md section 6): each component of w in an interval, to which those of a ball may be
   added.  `load_within`: how much work they do on a virtual twist. *)
From Coq Require Import List Arith ZArith QArith Qreals Qminmax Reals Lra Lia Bool.
From Proved Require Import Question Meaning Numbers Root Between Degree Matrix.
From Proved Require Rows.
Import ListNotations.

Section Checker.
Open Scope Q_scope.

(* What is added: sum z_j B_j, with each number z_j in its interval, and all in the ball: the sum of
   z_j^2 / m_j^2 is at most 1.  Without a ball there are no numbers. *)
Record addition := Addition {
  ball_numbers : list interval;
  ball_ways : matrix;                (* B *)
  ball_squares : list Q              (* m_j^2 *)
}.

Definition nothing_added : addition := Addition [] [] [].

(* w, in its box; and u. *)
Record load := Load { load_box : list interval; load_growth : list Q; load_added : addition }.

(* The smallest and the largest work on y: of components, and of numbers whose ways do these works. *)
Fixpoint work_of_box (box : list interval) (y : vector) : interval :=
  match box, y with
  | i :: box', q :: y' =>
      let (least, most) := work_of_box box' y' in
      let (a, b) := if Qle_bool 0 q then (low i, high i) else (high i, low i) in
      Interval (reduced (q * a + least)) (reduced (q * b + most))
  | _, _ => exactly 0
  end.

Fixpoint sum_of_squares (weights a : vector) : Q :=
  match weights, a with w :: ws, x :: a' => reduced (w * (x * x) + sum_of_squares ws a') | _, _ => 0 end.

Definition work_of_addition (it : addition) (y : vector) : interval :=
  match ball_ways it with
  | [] => exactly 0
  | _ =>
      let along := map (fun b => inner b y) (ball_ways it) in
      let in_box := work_of_box (ball_numbers it) along in
      let root := root_above (sum_of_squares (ball_squares it) along) in
      Interval (Qmax (low in_box) (- root)) (Qmin (high in_box) root)
  end.

(* From - Lambda(-y) to Lambda(y). *)
Definition work_of (ld : load) (y : vector) : interval :=
  let a := work_of_box (load_box ld) y in
  let b := work_of_addition (load_added ld) y in
  Interval (reduced (low a + low b)) (reduced (high a + high b)).

(* Whether it is one. *)
Definition one_load (ld : load) : bool :=
  forallb certain (load_box ld) && match ball_numbers (load_added ld) with [] => true | _ => false end.

(* The one in the middle, of a ball that with the least numbers. *)
Definition nearest_to_zero (i : interval) : Q :=
  if Qle_bool 0 (low i) then low i else if Qle_bool (high i) 0 then high i else 0.

Definition middle_load (ld : load) : load :=
  let a := load_added ld in
  Load (map only_middle (load_box ld)) (load_growth ld)
    (Addition (map (fun i => exactly (nearest_to_zero i)) (ball_numbers a)) (ball_ways a) (ball_squares a)).

End Checker.

Section Proofs.
Open Scope R_scope.

Fixpoint weighted (ws e : list R) : list R :=
  match ws, e with w :: ws', x :: e' => w * x :: weighted ws' e' | _, _ => [] end.

(* The numbers of a ball are m_j^2 e_j. *)
Record is_addition (it : addition) (n : nat) (e : list R) : Prop := IsAddition {
  squares_positive : Rows.positive (real (ball_squares it));
  ways_length : Forall (fun b => List.length b = n) (ball_ways it);
  as_many_numbers : List.length e = List.length (ball_squares it);
  numbers_within : Forall2 within (ball_numbers it) (weighted (real (ball_squares it)) e);
  numbers_in_ball : Rows.product (real (ball_squares it)) e e <= 1
}.

Definition work_added (it : addition) (e y : list R) : R :=
  Rows.product (real (ball_squares it)) e (times (map real (ball_ways it)) y).

Definition is_load (ld : load) (w : list R) : Prop := exists w0 e,
  Forall2 within (load_box ld) w0 /\ List.length w = List.length w0 /\
  is_addition (load_added ld) (List.length w0) e /\
  forall y, Rows.dot w y = Rows.dot w0 y + work_added (load_added ld) e y.

Lemma nothing_is_added n : is_addition nothing_added n [].
Proof. constructor; cbn; try constructor. lra. Qed.

Lemma box_is_load box u w : Forall2 within box w -> is_load (Load box u nothing_added) w.
Proof.
  intros F. exists w, []. split; [exact F|]. split; [reflexivity|]. split; [apply nothing_is_added|].
  intros y. unfold work_added. cbn. ring.
Qed.

(* ---- The work of loads ---- *)

Lemma work_of_box_within box w y : Forall2 within box w -> within (work_of_box box y) (Rows.dot w (real y)).
Proof.
  intros F. revert y. induction F as [|i x box w [L H] F IH]; intros [|q y]; cbn [work_of_box real map Rows.dot];
    try (unfold within, exactly; cbn; rewrite Q2R_0; lra).
  specialize (IH y). destruct (work_of_box box y) as [least most]. destruct IH as [A B]. cbn [low high] in A, B.
  fold (real y). destruct (Qle_bool 0 q) eqn:S; unfold within; cbn [low high];
    rewrite !reduced_same, !Q2R_plus, !Q2R_mult.
  - apply Qle_bool_R in S. rewrite Q2R_0 in S. split; nra.
  - assert (Q2R q < 0).
    { apply Rnot_le_lt. intros N. rewrite <- Q2R_0 in N. apply Rle_Qle, Qle_bool_iff in N. congruence. }
    split; nra.
Qed.

Lemma product_is_dot ws e t : Rows.product ws e t = Rows.dot (weighted ws e) t.
Proof. revert e t. induction ws as [|w ws IH]; intros [|x e] [|y t]; cbn; try reflexivity. now rewrite IH. Qed.

Lemma sum_of_squares_is ws a : Q2R (sum_of_squares ws a) = Rows.product (real ws) (real a) (real a).
Proof.
  revert a. induction ws as [|w ws IH]; intros [|x a]; cbn [sum_of_squares real map Rows.product]; try apply Q2R_0.
  rewrite reduced_same, Q2R_plus, !Q2R_mult, IH. unfold real. ring.
Qed.

Lemma along_is ways y : real (map (fun b => inner b y) ways) = times (map real ways) (real y).
Proof. unfold real at 1, times. rewrite !map_map. apply map_ext. intros b. apply inner_is. Qed.

Lemma work_of_addition_within it n e y : is_addition it n e ->
  within (work_of_addition it y) (work_added it e (real y)).
Proof.
  intros [P _ _ W B]. unfold work_of_addition, work_added. destruct (ball_ways it) as [|b ways].
  { unfold within, exactly; cbn. rewrite Q2R_0. destruct (real (ball_squares it)), e; cbn; lra. }
  remember (b :: ways) as all eqn:E. clear E b ways. cbv zeta. rewrite <- along_is.
  set (along := map _ all). set (ws := real (ball_squares it)) in *.
  pose proof (work_of_box_within _ _ along W) as [A1 A2]. rewrite <- product_is_dot in A1, A2.
  set (box := work_of_box _ _) in *.
  assert (S : Rows.size ws (real along) <= Q2R (root_above (sum_of_squares (ball_squares it) along))).
  { unfold Rows.size, ws. rewrite <- sum_of_squares_is. apply root_above_is. rewrite sum_of_squares_is.
    now apply Rows.product_nonneg. }
  assert (E1 : Rows.size ws e <= 1) by (unfold Rows.size; rewrite <- sqrt_1; now apply sqrt_le_1_alt).
  pose proof (Rows.size_nonneg ws e) as E0. pose proof (Rows.size_nonneg ws (real along)) as S0.
  assert (Most : forall e', Rows.size ws e' <= 1 -> Rows.size ws e' >= 0 -> Rows.product ws e' (real along) <=
    Q2R (root_above (sum_of_squares (ball_squares it) along))).
  { intros e' U U0. eapply Rle_trans; [apply Rows.product_bound; exact P|]. nra. }
  pose proof (Most e E1 (Rle_ge _ _ E0)) as M1. set (root := root_above _) in *.
  assert (M2 : - Rows.product ws e (real along) <= Q2R root).
  { replace (- Rows.product ws e (real along)) with (Rows.product ws (Rows.scaled (-1) e) (real along))
      by (rewrite Rows.product_scaled; ring).
    assert (Z : Rows.size ws (Rows.scaled (-1) e) = Rows.size ws e).
    { unfold Rows.size. f_equal. rewrite Rows.product_scaled, Rows.product_sym, Rows.product_scaled. ring. }
    apply Most; rewrite Z; [exact E1|now apply Rle_ge]. }
  unfold within; cbn [low high].
  split.
  - destruct (Q.max_spec (low box) (- root)) as [[_ ->]|[_ ->]]; [rewrite Q2R_opp; lra|exact A1].
  - destruct (Q.min_spec (high box) root) as [[_ ->]|[_ ->]]; [exact A2|exact M1].
Qed.

Theorem load_within ld w y : is_load ld w -> within (work_of ld y) (Rows.dot w (real y)).
Proof.
  intros (w0 & e & B & _ & A & E). rewrite E. pose proof (work_of_box_within _ _ y B) as [B1 B2].
  pose proof (work_of_addition_within _ _ _ y A) as [A1 A2]. unfold work_of, within. cbn [low high].
  rewrite !reduced_same, !Q2R_plus. lra.
Qed.

(* ---- One load, and the middle one ---- *)

Lemma certain_box box w : forallb certain box = true -> Forall2 within box w -> w = real (map low box).
Proof.
  intros C F. induction F as [|i x box w W F IH]; [reflexivity|]. cbn in *. apply andb_true_iff in C as [C1 C2].
  f_equal; [now apply certain_within|now apply IH].
Qed.

Lemma same_products a b : List.length a = List.length b -> (forall y, Rows.dot a y = Rows.dot b y) -> a = b.
Proof.
  intros L H. apply (nth_ext _ _ 0 0 L). intros k K.
  rewrite <- (dot_unit a (List.length a) k K), H. apply dot_unit. exact K.
Qed.

Lemma no_addition it n e y : ball_numbers it = [] -> is_addition it n e -> work_added it e y = 0.
Proof.
  intros N [_ _ _ W _]. rewrite N in W. apply same_length in W. cbn in W. unfold work_added. rewrite product_is_dot.
  now destruct (weighted _ e).
Qed.

Lemma one_load_is ld w : one_load ld = true -> is_load ld w -> w = real (map low (load_box ld)).
Proof.
  intros C (w0 & e & B & L & A & E). unfold one_load in C. apply andb_true_iff in C as [C N].
  destruct (ball_numbers (load_added ld)) eqn:Nu; [|discriminate].
  rewrite <- (certain_box _ _ C B). apply same_products; [exact L|]. intros y.
  rewrite E, (no_addition _ _ _ _ Nu A). ring.
Qed.

Lemma one_load_box ld w : one_load ld = true -> is_load ld w -> Forall2 within (load_box ld) w.
Proof.
  intros C I. pose proof (one_load_is ld w C I) as E. destruct I as (w0 & e & B & _).
  unfold one_load in C. apply andb_true_iff in C as [C _]. now rewrite E, <- (certain_box _ _ C B).
Qed.

Lemma nearest_within i x : within i x -> within i (Q2R (nearest_to_zero i)) /\
  Q2R (nearest_to_zero i) * Q2R (nearest_to_zero i) <= x * x.
Proof.
  intros [L H]. unfold within, nearest_to_zero. destruct (Qle_bool 0 (low i)) eqn:A.
  - apply Qle_bool_R in A. rewrite Q2R_0 in A. split; [lra|]. nra.
  - destruct (Qle_bool (high i) 0) eqn:B.
    + apply Qle_bool_R in B. rewrite Q2R_0 in B. split; [lra|]. nra.
    + assert (Q2R (low i) < 0).
      { apply Rnot_le_lt. intros N. rewrite <- Q2R_0 in N. apply Rle_Qle, Qle_bool_iff in N. congruence. }
      assert (0 < Q2R (high i)).
      { apply Rnot_le_lt. intros N. rewrite <- Q2R_0 in N. apply Rle_Qle, Qle_bool_iff in N. congruence. }
      rewrite Q2R_0. split; [lra|]. nra.
Qed.

(* The numbers over m_j^2. *)
Fixpoint over_squares (ws : list R) (z : list R) : list R :=
  match ws, z with w :: ws', x :: z' => x / w :: over_squares ws' z' | _, _ => [] end.

Lemma nearest_addition ws numbers e : Rows.positive ws -> List.length e = List.length ws ->
  Forall2 within numbers (weighted ws e) ->
  let e0 := over_squares ws (map (fun i => Q2R (nearest_to_zero i)) numbers) in
  weighted ws e0 = map (fun i => Q2R (nearest_to_zero i)) numbers /\ List.length e0 = List.length ws /\
  Rows.product ws e0 e0 <= Rows.product ws e e.
Proof.
  intros P. revert numbers e. induction P as [|w ws Pw P IH]; intros numbers [|x e] L F; try discriminate.
  - cbn in F. inversion F; subst. cbn. repeat split; lra.
  - cbn [weighted] in F. inversion F as [|i ? numbers' ? W F']; subst. injection L as L.
    destruct (IH numbers' e L F') as (A & B & C). cbn [map over_squares weighted Rows.product List.length] in *.
    destruct (nearest_within _ _ W) as [_ Sq]. set (z := Q2R (nearest_to_zero i)) in *.
    split; [f_equal; [field; lra|exact A]|]. split; [now f_equal|].
    assert (w * (z / w) * (z / w) <= w * x * x); [|lra].
    replace (w * (z / w) * (z / w)) with (/ w * (z * z)) by (field; lra).
    replace (w * x * x) with (/ w * (w * x * (w * x))) by (field; lra).
    apply Rmult_le_compat_l; [|exact Sq]. left. now apply Rinv_0_lt_compat.
Qed.

Fixpoint sum_of_ways (ws e : list R) (ways : list (list R)) : list R :=
  match ws, e, ways with
  | w :: ws', x :: e', b :: ways' => Rows.plus (Rows.scaled (w * x) b) (sum_of_ways ws' e' ways')
  | _, _, _ => []
  end.

Lemma sum_of_ways_is ws e ways y : Rows.dot (sum_of_ways ws e ways) y = Rows.product ws e (times ways y).
Proof.
  revert e ways. induction ws as [|w ws IH]; intros [|x e] [|b ways]; cbn; try reflexivity.
  rewrite Rows.dot_plus, Rows.dot_scaled, IH. unfold times. ring.
Qed.

Lemma plus_length a b : (List.length b <= List.length a)%nat -> List.length (Rows.plus a b) = List.length a.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b] L; cbn in *; try lia. now rewrite IH by lia.
Qed.

Lemma sum_of_ways_length ws e ways n : Forall (fun b => List.length b = n) ways ->
  (List.length (sum_of_ways ws e ways) <= n)%nat.
Proof.
  intros F. revert ws e. induction F as [|b ways L F IH]; intros [|w ws] [|x e]; cbn; try lia.
  rewrite plus_length; unfold Rows.scaled; rewrite map_length; [lia|]. rewrite L. apply IH.
Qed.

Lemma all_exactly qs : Forall2 within (map exactly qs) (real qs).
Proof. induction qs as [|q qs IH]; cbn; constructor; [apply exactly_within|exact IH]. Qed.

(* The middle load is one of the box, and of its own. *)
Lemma middle_load_is ld w : is_load ld w ->
  exists m, is_load (middle_load ld) m /\ is_load ld m /\ List.length m = List.length w.
Proof.
  intros (w0 & e & B & L & A & _). destruct A as [P Wl Le N In_ball].
  set (it := load_added ld) in *. set (ws := real (ball_squares it)) in *.
  assert (Le' : List.length e = List.length ws) by (unfold ws, real; now rewrite map_length).
  destruct (nearest_addition ws _ e P Le' N) as (E1 & E2 & E3).
  set (e0 := over_squares ws _) in *.
  set (m0 := map (fun i => Q2R (middle i)) (load_box ld)).
  assert (Lm : List.length m0 = List.length w0) by (unfold m0; rewrite map_length; exact (same_length _ _ _ B)).
  set (ways := map real (ball_ways it)).
  assert (Wl' : Forall (fun b => List.length b = List.length m0) ways).
  { unfold ways. apply Forall_map. eapply Forall_impl; [|exact Wl]. cbn. intros b Hb. unfold real.
    rewrite map_length. congruence. }
  exists (Rows.plus m0 (sum_of_ways ws e0 ways)).
  assert (Len : List.length (Rows.plus m0 (sum_of_ways ws e0 ways)) = List.length m0)
    by now apply plus_length, sum_of_ways_length.
  assert (Y : forall y, Rows.dot (Rows.plus m0 (sum_of_ways ws e0 ways)) y =
    Rows.dot m0 y + Rows.product ws e0 (times ways y)) by (intros y; now rewrite Rows.dot_plus, sum_of_ways_is).
  assert (Wm : Forall (fun b => List.length b = List.length m0) (ball_ways it)) by (rewrite Lm; exact Wl).
  assert (Lq : List.length e0 = List.length (ball_squares it)) by (rewrite E2; unfold ws, real; now rewrite map_length).
  split; [|split; [|congruence]].
  - exists m0, e0. cbn [middle_load load_box load_added ball_numbers ball_ways ball_squares]. split; [|split; [exact Len|split]].
    + unfold m0. replace (map only_middle (load_box ld)) with (map exactly (map middle (load_box ld))) by apply map_map.
      replace (map (fun i => Q2R (middle i)) (load_box ld)) with (real (map middle (load_box ld))) by apply map_map.
      apply all_exactly.
    + constructor; cbn [ball_numbers ball_ways ball_squares]; fold it; fold ws; try assumption; [|lra].
      rewrite E1. replace (map (fun i => exactly (nearest_to_zero i)) (ball_numbers it))
        with (map exactly (map nearest_to_zero (ball_numbers it))) by apply map_map.
      replace (map (fun i => Q2R (nearest_to_zero i)) (ball_numbers it)) with (real (map nearest_to_zero (ball_numbers it)))
        by apply map_map. apply all_exactly.
    + intros y. apply Y.
  - exists m0, e0. split; [|split; [exact Len|split]].
    + unfold m0. clear - B. induction B as [|i x box w0 W B IH]; cbn; constructor; [now apply middle_within with x|exact IH].
    + constructor; fold it; fold ws; try assumption; [|lra]. rewrite E1. clear - N.
      induction N as [|i x numbers z W N IH]; cbn; constructor; [now apply (nearest_within _ _ W)|exact IH].
    + intros y. apply Y.
Qed.

Lemma dot_mixed t a b y : List.length a = List.length b -> Rows.dot (mixed t a b) y = mix t (Rows.dot a y) (Rows.dot b y).
Proof.
  revert b y. induction a as [|x a IH]; intros [|z b] [|c y] L; try discriminate; cbn; try (unfold mix; ring).
  rewrite IH by now injection L. unfold mix. ring.
Qed.

Lemma weighted_mixed ws t e e' : List.length e = List.length e' ->
  weighted ws (Rows.plus (Rows.scaled (1 - t) e) (Rows.scaled t e')) = mixed t (weighted ws e) (weighted ws e').
Proof.
  revert e e'. induction ws as [|w ws IH]; intros [|x e] [|y e'] L; try discriminate; cbn; try reflexivity.
  unfold Rows.scaled in IH. rewrite IH by now injection L. f_equal. unfold mix. ring.
Qed.

(* Loads between two are loads. *)
Lemma mixed_load ld t a b : 0 <= t <= 1 -> is_load ld a -> is_load ld b -> is_load ld (mixed t a b).
Proof.
  intros T (a0 & e & A & La & Aa & Ea) (b0 & f & B & Lb & Ab & Eb).
  assert (L0 : List.length a0 = List.length b0).
  { rewrite <- (same_length _ _ _ A). exact (same_length _ _ _ B). }
  assert (L : List.length a = List.length b) by congruence.
  destruct Aa as [P W Le N I], Ab as [_ _ Lf Nf If].
  set (ws := real (ball_squares (load_added ld))) in *.
  set (g := Rows.plus (Rows.scaled (1 - t) e) (Rows.scaled t f)).
  exists (mixed t a0 b0), g.
  split; [now apply mixed_within|]. split; [now rewrite !mixed_length by assumption|]. split.
  - constructor; rewrite ?mixed_length by assumption; try assumption.
    + unfold g. rewrite plus_length; unfold Rows.scaled; rewrite !map_length; [exact Le|lia].
    + fold ws. unfold g. rewrite weighted_mixed by congruence. now apply mixed_within.
    + fold ws. assert (U : forall e', Rows.product ws e' e' <= 1 -> Rows.size ws e' <= 1).
      { intros e' H. unfold Rows.size. rewrite <- sqrt_1. now apply sqrt_le_1_alt. }
      assert (S : Rows.size ws g <= 1).
      { unfold g. eapply Rle_trans; [apply Rows.size_plus; exact P|]. rewrite !Rows.size_scaled by (assumption || lra).
        specialize (U _ I) as U1. specialize (U _ If) as U2. nra. }
      rewrite <- (Rows.size_square ws g P). pose proof (Rows.size_nonneg ws g). nra.
  - intros y. rewrite !dot_mixed, Ea, Eb by assumption. unfold work_added. fold ws. unfold g.
    rewrite Rows.product_plus, !Rows.product_scaled. unfold mix. ring.
Qed.

Lemma one_load_middle ld w : one_load ld = true -> is_load ld w -> is_load (middle_load ld) w.
Proof.
  intros C I. destruct (middle_load_is ld w I) as (m & M & I' & _).
  now rewrite (one_load_is ld w C I), <- (one_load_is ld m C I').
Qed.

End Proofs.
