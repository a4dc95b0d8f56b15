(* SPDX-License-Identifier: MIT *)
(* Statics (FORMAT.md section 16): where the rules hold (StaticsRules.v), forces balance the load of a load point, and
   none balance a load that does work on a twist (StaticsModel.v). *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Meaning Numbers Root Box RowsOfModels Matrix Bodies StaticsModel StaticsRules.
From Proved Require Rows Model SpaceModel BodiesModel RigidClass Rigid ByDegree Fingers Turned.
Import ListNotations.
Open Scope R_scope.

Notation real := (map Q2R).
Notation "u .* v" := (Rows.dot u v) (at level 40).

Lemma inner_real a b : Q2R (inner a b) = real a .* real b.
Proof. apply inner_is. Qed.

Lemma plus_times_real a s b d : real (plus_times a s b) .* d = real a .* d + Q2R s * (real b .* d).
Proof. apply dot_plus_times. Qed.

Lemma at_real d j : BodiesModel.at_ (real d) j = Q2R (at_q d j).
Proof. unfold BodiesModel.at_, at_q. rewrite <- Q2R_0 at 1. apply map_nth. Qed.

Ltac to_reals := rewrite ?reduced_same, ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp, ?reduced_same, ?Q2R_plus, ?Q2R_minus,
  ?Q2R_mult, ?Q2R_opp, ?reduced_same, ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp, ?reduced_same, ?Q2R_plus, ?Q2R_minus,
  ?Q2R_mult, ?Q2R_opp, ?reduced_same, ?Q2R_0, ?Q2R_1.

Lemma nonneg_real q : Qle_bool 0 q = true -> 0 <= Q2R q.
Proof. intros H. apply Qle_bool_R in H. now rewrite Q2R_0 in H. Qed.

Lemma zero_real q : is_zero q = true -> Q2R q = 0.
Proof. apply ByDegree.is_zero_real. Qed.

Lemma not_nonneg_real q : Qle_bool 0 q = false -> Q2R q < 0.
Proof.
  intros H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence.
Qed.

Lemma not_zero_real q : is_zero q = false -> Q2R q <> 0.
Proof.
  intros H E. rewrite <- Q2R_0 in E. apply eqR_Qeq, Qeq_eq_bool in E. unfold is_zero in H. congruence.
Qed.

(* x^2 <= y^2 *)
Lemma squares_order x y : 0 <= y -> x * x <= y * y -> Rabs x <= y.
Proof. intros Y H. rewrite <- (Rabs_right y) by lra. apply Rsqr_le_abs_0. exact H. Qed.

(* Of a b + f t with |f| <= r a, and r |t| <= b. *)
Lemma cone_works a b f t size slips r : 0 <= a -> 0 <= r -> Rabs f <= size * slips -> 0 <= slips ->
  size <= r * a -> r * slips <= b -> t = f -> 0 <= a * b + t.
Proof.
  intros A R0 F S0 Sz B ->. assert (H : - f <= Rabs f) by (rewrite <- Rabs_Ropp; apply Rle_abs).
  assert (size * slips <= r * a * slips) by (apply Rmult_le_compat_r; assumption).
  assert (a * (r * slips) <= a * b) by (apply Rmult_le_compat_l; assumption). lra.
Qed.

(* ---- One contact in the plane ---- *)

Section Plane.
Variable phi : R.

Record is_held (h : held) (c : Model.contact) : Prop := {
  plane_point : exists x y, h_point h = [x; y] /\ Model.px c = Q2R x /\ Model.py c = Q2R y;
  plane_normal : exists x y, h_normal h = [x; y] /\ Model.nx c = Q2R x /\ Model.ny c = Q2R y;
  plane_rough : 0 <= Q2R (h_friction h) /\ phi * Model.friction c = Q2R (h_friction h)
}.

Definition plane_force (force : Q * list Q) : R * R := (Q2R (fst force), Q2R (at_q (snd force) 0)).

Lemma plane_wrench_works h c force d : is_held h c ->
  Model.work (Model.contact_wrench c (plane_force force)) (motion_of d) = real (wrench_of h force) .* d.
Proof.
  intros [(px & py & Ep & Px & Py) (nx & ny & En & Nx & Ny) _]. destruct force as [a f]. unfold wrench_of, plane_force.
  rewrite Ep, En. rewrite <- dot_motion. f_equal. unfold motion_list, Model.contact_wrench, Model.N, Model.T, Model.add,
    Model.scale, Model.force_at. cbn [map fst snd Model.along_x Model.along_y Model.about_z]. rewrite Px, Py, Nx, Ny.
  to_reals. repeat (f_equal; try ring).
Qed.

Lemma plane_lawful h c force : is_held h c -> is_lawful h force = true -> in_cone phi c (plane_force force).
Proof.
  intros [_ (nx & ny & En & _) [R0 Er]]. destruct force as [a f]. unfold is_lawful, plane_force, in_cone. rewrite En, Er.
  destruct f as [|b [|? ?]]; rewrite ?andb_false_r; try discriminate. intros H. apply andb_true_iff in H as [A H].
  apply nonneg_real in A. apply Qle_bool_R in H. cbn [fst snd at_q nth]. split; [exact A|]. apply squares_order.
  - now apply Rmult_le_pos.
  - revert H. to_reals. lra.
Qed.

Lemma plane_unopposed h c d force : is_held h c -> unopposed_by h d = true -> in_cone phi c force ->
  0 <= Model.work (Model.contact_wrench c force) (motion_of (real d)).
Proof.
  intros [(px & py & Ep & Px & Py) (nx & ny & En & Nx & Ny) [R0 Er]] H. destruct force as [a b]. intros [A B].
  unfold unopposed_by, press_and_rub in H. rewrite Ep, En in H. apply andb_true_iff in H as [P Q].
  apply nonneg_real in P. apply Qle_bool_R in Q. revert P Q. to_reals. rewrite Er in B.
  assert (W : Model.work (Model.contact_wrench c (a, b)) (motion_of (real d)) =
    a * Model.work (Model.N c) (motion_of (real d)) + b * Model.work (Model.T c) (motion_of (real d)))
    by (unfold Model.work, Model.contact_wrench, Model.add, Model.scale; cbn; ring).
  rewrite W. unfold Model.work, Model.N, Model.T, Model.force_at, motion_of.
  cbn [Model.along_x Model.along_y Model.about_z]. rewrite !at_real, Px, Py, Nx, Ny.
  set (r := Q2R (h_friction h)) in *. intros P Q.
  match goal with |- 0 <= a * ?p + b * ?s => set (press := p) in *; set (slip := s) in * end.
  apply (cone_works a press (b * slip) _ (Rabs b) (Rabs slip) r); try assumption; try reflexivity.
  - rewrite Rabs_mult. lra.
  - apply Rabs_pos.
  - assert (E : Rabs (r * slip) <= press); [|now rewrite Rabs_mult, (Rabs_right r) in E by lra].
    match type of P with 0 <= ?p => replace p with press in * by (unfold press; ring) end.
    apply squares_order; [exact P|]. eapply Rle_trans; [|exact Q]. right. unfold slip. ring.
Qed.

Lemma plane_mixed c f f' s t : 0 <= s -> 0 <= t -> in_cone phi c f -> in_cone phi c f' ->
  exists g, in_cone phi c g /\ forall d, Model.work (Model.contact_wrench c g) d =
    s * Model.work (Model.contact_wrench c f) d + t * Model.work (Model.contact_wrench c f') d.
Proof.
  destruct f as [a b], f' as [a' b']. intros S0 T0 [A B] [A' B']. exists (s * a + t * a', s * b + t * b').
  split; [split|].
  - apply Rplus_le_le_0_compat; now apply Rmult_le_pos.
  - eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, (Rabs_right s), (Rabs_right t) by lra.
    assert (s * Rabs b <= s * (phi * Model.friction c * a)) by (now apply Rmult_le_compat_l).
    assert (t * Rabs b' <= t * (phi * Model.friction c * a')) by (now apply Rmult_le_compat_l). lra.
  - intros d. unfold Model.work, Model.contact_wrench, Model.add, Model.scale; cbn. ring.
Qed.

End Plane.

(* ---- One contact in space ---- *)

Section Space.
Import SpaceModel.
Variable phi : R.

Notation finger := BodiesModel.finger.
Notation hard := BodiesModel.hard.
Notation gamma := BodiesModel.gamma.
Notation turn := BodiesModel.turn.

Record is_held_finger (h : held) (t : finger) : Prop := {
  space_point : exists p q r, h_point h = [p; q; r] /\ position (hard t) = Vector (Q2R p) (Q2R q) (Q2R r);
  space_normal : exists p q r, h_normal h = [p; q; r] /\ normal (hard t) = Vector (Q2R p) (Q2R q) (Q2R r);
  space_normal_is : 0 < dot (normal (hard t)) (normal (hard t));
  space_rough : 0 <= Q2R (h_friction h) /\ phi * friction (hard t) = Q2R (h_friction h);
  space_torsion : BodiesModel.torsion t = Q2R (h_torsion h)
}.

Definition space_force (force : Q * list Q) : R * vector * R :=
  let f := snd force in
  (Q2R (fst force), Vector (Q2R (at_q f 0)) (Q2R (at_q f 1)) (Q2R (at_q f 2)), Q2R (at_q f 3)).

Lemma square_is h t : is_held_finger h t -> Q2R (square_of_normal h) = dot (normal (hard t)) (normal (hard t)).
Proof.
  intros [_ (p & q & r & En & E) _ _ _]. unfold square_of_normal. rewrite inner_real, En, E. unfold dot; cbn. ring.
Qed.

Lemma length_square t : 0 < dot (normal (hard t)) (normal (hard t)) ->
  length (hard t) * length (hard t) = dot (normal (hard t)) (normal (hard t)).
Proof. intros H. apply sqrt_sqrt. lra. Qed.

Lemma gamma_times t : 0 < dot (normal (hard t)) (normal (hard t)) ->
  gamma t * dot (normal (hard t)) (normal (hard t)) = BodiesModel.torsion t * BodiesModel.torsion t.
Proof. intros H. unfold gamma. field. lra. Qed.

Lemma space_wrench_works h t force d : is_held_finger h t ->
  BodiesModel.finger_works t (space_force force) (screw_of d) = real (wrench_of h force) .* d.
Proof.
  intros [(px & py & pz & Ep & P) (nx & ny & nz & En & N) _ _ _]. destruct force as [a f].
  unfold wrench_of, space_force, BodiesModel.finger_works. rewrite Ep, En. cbn [fst snd].
  set (m := Q2R (at_q f 3)).
  transitivity (work (add_screw (contact_wrench (hard t) (Q2R a, Vector (Q2R (at_q f 0)) (Q2R (at_q f 1)) (Q2R (at_q f 2))))
    (Screw zero (scale m (normal (hard t))))) (screw_of d)).
  - unfold turn, work, add_screw, add, dot, scale, zero; cbn. ring.
  - rewrite <- dot_screw. f_equal. unfold screw_list, contact_wrench, force_at, add_screw, add, scale, cross.
    rewrite P, N. unfold m. cbn [map fst snd linear angular x y z zero]. to_reals. repeat (f_equal; try ring).
Qed.

Lemma space_lawful h t force : is_held_finger h t -> is_lawful h force = true ->
  in_cone_of_finger phi t (space_force force).
Proof.
  intros Hd. pose proof (square_is h t Hd) as Sq. destruct Hd as [_ (nx & ny & nz & En & N) Pos [R0 Er] Et].
  destruct force as [a f]. unfold is_lawful. rewrite En. intros H. apply andb_true_iff in H as [A H].
  destruct f as [|fx [|fy [|fz mom]]]; try discriminate. rewrite !andb_true_iff in H. destruct H as [[Ac Si] M].
  apply nonneg_real in A. apply zero_real in Ac. apply Qle_bool_R in Si.
  unfold space_force, in_cone_of_finger, in_cone_in_space. cbn [fst snd]. rewrite Er.
  pose proof (length_square t Pos) as LL. pose proof (gamma_times t Pos) as GG. rewrite <- Sq in LL, GG. rewrite Et in GG.
  assert (L0 : 0 <= length (hard t)) by apply sqrt_pos.
  assert (S0 : 0 < Q2R (square_of_normal h)) by (now rewrite Sq).
  change (at_q (fx :: fy :: fz :: mom) 0) with fx. change (at_q (fx :: fy :: fz :: mom) 1) with fy.
  change (at_q (fx :: fy :: fz :: mom) 2) with fz. change (at_q (fx :: fy :: fz :: mom) 3) with (at_q mom 0).
  set (f := Vector (Q2R fx) (Q2R fy) (Q2R fz)).
  set (L := length (hard t)) in *. set (g := gamma t) in *. set (sq := Q2R (square_of_normal h)) in *.
  set (r := Q2R (h_friction h)) in *. set (e := Q2R (h_torsion h)) in *.
  assert (Si' : dot f f <= r * L * Q2R a * (r * L * Q2R a)).
  { revert Si. to_reals. fold sq r. unfold dot, f; cbn.
    replace (r * L * Q2R a * (r * L * Q2R a)) with (L * L * (r * r * (Q2R a * Q2R a))) by ring. rewrite LL. lra. }
  assert (M0 : 0 <= r * L * Q2R a) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; assumption).
  split; [split; [exact A|split]|].
  - revert Ac. rewrite N. to_reals. unfold dot, f; cbn. lra.
  - unfold norm. rewrite <- (sqrt_square _ M0). now apply sqrt_le_1_alt.
  - destruct mom as [|m [|? ?]]; try discriminate.
    + apply zero_real in M. fold e in M. cbn [at_q nth]. rewrite Q2R_0.
      assert (g0 : g = 0) by (apply Rmult_eq_reg_r with sq; [rewrite GG, M; ring|lra]). rewrite g0. lra.
    + apply andb_true_iff in M as [_ M]. apply Qle_bool_R in M. cbn [at_q nth]. revert M. to_reals. fold sq r e. intros M.
      apply Rmult_le_reg_l with sq; [exact S0|].
      replace (sq * (g * dot f f + Q2R m * Q2R m)) with (g * sq * dot f f + sq * (Q2R m * Q2R m)) by ring.
      replace (sq * (g * (r * L * Q2R a * (r * L * Q2R a)))) with (g * sq * (L * L * (r * r * (Q2R a * Q2R a)))) by ring.
      rewrite GG, LL. unfold dot, f; cbn. lra.
Qed.

(* Where lengths of forces and slips are with the moment and the turn. *)
Lemma finger_bound t f m s x most : 0 < dot (normal (hard t)) (normal (hard t)) -> 0 <= most ->
  norm f <= most -> gamma t * dot f f + m * m <= gamma t * (most * most) ->
  Rabs (dot f s + m * x) <= most * sqrt (dot s s + gamma t * (x * x)).
Proof.
  intros Pos M0 F E.
  assert (G0 : 0 <= gamma t).
  { unfold gamma. apply Rmult_le_pos; [apply Rle_0_sqr|]. left. now apply Rinv_0_lt_compat. }
  assert (B : forall g x, 0 < g -> g * dot f f + m * m <= g * (most * most) ->
    Rabs (dot f s + m * x) <= most * sqrt (dot s s + g * (x * x))).
  { clear x. intros g x Gp H. pose proof (Fingers.four_positive g Gp) as Ps.
    assert (P : forall s' x', Rows.product ([1; 1; 1] ++ [g]) (vector_list f ++ [m / g]) (vector_list s' ++ [x']) = dot f s' + m * x').
    { intros s' x'. rewrite Fingers.product_four. unfold dot, vector_of, vector_list, BodiesModel.at_; cbn. field. lra. }
    assert (Sf : Rows.size ([1; 1; 1] ++ [g]) (vector_list f ++ [m / g]) <= most).
    { rewrite <- (sqrt_square most M0). unfold Rows.size. apply sqrt_le_1_alt. rewrite P.
      apply Rmult_le_reg_l with g; [exact Gp|]. replace (g * (dot f f + m * (m / g))) with (g * dot f f + m * m) by (field; lra).
      exact H. }
    assert (One : forall s' x', dot f s' + m * x' <= most * sqrt (dot s' s' + g * (x' * x'))).
    { intros s' x'. pose proof (Rows.product_bound _ (vector_list f ++ [m / g]) (vector_list s' ++ [x']) Ps) as Cs.
      rewrite P in Cs. rewrite <- Fingers.size_four. eapply Rle_trans; [exact Cs|]. apply Rmult_le_compat_r; [apply sqrt_pos|exact Sf]. }
    apply Rabs_le. pose proof (One s x) as U. pose proof (One (scale (-1) s) (- x)) as V.
    replace (dot (scale (-1) s) (scale (-1) s) + g * (- x * - x)) with (dot s s + g * (x * x)) in V
      by (unfold dot, scale; cbn; ring).
    replace (dot f (scale (-1) s) + m * - x) with (- (dot f s + m * x)) in V by (unfold dot, scale; cbn; ring). lra. }
  destruct (Rle_lt_or_eq_dec 0 (gamma t) G0) as [G|G]; [now apply B|].
  rewrite <- G in *. assert (m0 : m = 0) by nra. rewrite m0 in *.
  assert (H : dot f f <= most * most) by (rewrite <- Turned.norm_square; apply Rmult_le_compat; try apply Turned.norm_nonneg; assumption).
  specialize (B 1 0 Rlt_0_1 ltac:(lra)). replace (0 * x) with (0 * 0) by ring.
  now replace (dot s s + 0 * (x * x)) with (dot s s + 1 * (0 * 0)) by ring.
Qed.

Lemma space_unopposed h t d force : is_held_finger h t -> unopposed_by h d = true -> in_cone_of_finger phi t force ->
  0 <= BodiesModel.finger_works t force (screw_of (real d)).
Proof.
  intros Hd H. pose proof (square_is h t Hd) as Sq.
  destruct Hd as [(px & py & pz & Ep & P) (nx & ny & nz & En & Nn) Pos [R0 Er] Et]. destruct force as [[a f] m].
  intros [(A & Ac & Fn) Ell]. rewrite Er in *.
  pose proof (length_square t Pos) as LL. pose proof (gamma_times t Pos) as GG. rewrite Et in GG.
  unfold unopposed_by, press_and_rub in H. rewrite Ep, En in H. apply andb_true_iff in H as [Pr Q].
  apply nonneg_real in Pr. apply Qle_bool_R in Q. revert Pr Q. to_reals. rewrite Sq.
  unfold BodiesModel.finger_works. rewrite contact_work by exact Ac. intros Pr Q.
  set (r := Q2R (h_friction h)) in *. set (e := Q2R (h_torsion h)) in *. set (n2 := dot (normal (hard t)) (normal (hard t))) in *.
  set (press := work (SpaceModel.N (hard t)) (screw_of (real d))). set (s := slip (hard t) (screw_of (real d))).
  set (x := turn (hard t) (screw_of (real d))).
  assert (L0 : 0 <= length (hard t)) by apply sqrt_pos. set (L := length (hard t)) in *.
  assert (M0 : 0 <= r * L * a) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; assumption).
  pose proof (finger_bound t f m s x (r * L * a) Pos M0 Fn Ell) as B.
  set (slips := sqrt (dot s s + gamma t * (x * x))) in *.
  rewrite Rplus_assoc. apply (cone_works a press (dot f s + m * x) _ (r * L * a) slips (r * L)); try assumption; try reflexivity.
  - now apply Rmult_le_pos.
  - apply sqrt_pos.
  - lra.
  - (* press, in numbers *)
    match type of Pr with 0 <= ?p => assert (Ep' : p = press) end.
    { unfold press, work, SpaceModel.N, force_at, screw_of, dot, cross. cbn [linear angular SpaceModel.x SpaceModel.y SpaceModel.z].
      rewrite !at_real, P, Nn. cbn [SpaceModel.x SpaceModel.y SpaceModel.z]. ring. }
    rewrite Ep' in *.
    assert (G0 : 0 <= dot s s + gamma t * (x * x)).
    { assert (0 <= gamma t) by (unfold gamma; apply Rmult_le_pos; [apply Rle_0_sqr|left; now apply Rinv_0_lt_compat]).
      pose proof (Turned.dot_nonneg s). pose proof (Rle_0_sqr x) as X. unfold Rsqr in X.
      assert (0 <= gamma t * (x * x)) by (now apply Rmult_le_pos). lra. }
    assert (E : Rabs (r * L * slips) <= press); [|eapply Rle_trans; [apply Rle_abs|exact E]].
    apply squares_order; [exact Pr|].
    replace (r * L * slips * (r * L * slips)) with (r * r * (L * L * (slips * slips))) by ring.
    unfold slips. rewrite LL, sqrt_sqrt by exact G0. eapply Rle_trans; [|exact Q]. right. apply (f_equal (Rmult (r * r))).
    replace (n2 * (dot s s + gamma t * (x * x))) with (n2 * dot s s + gamma t * n2 * (x * x)) by ring. rewrite GG.
    (* n2 s.s is n2 u.u less the square of n.u *)
    assert (Ss : n2 * dot s s = n2 * dot (moved (hard t) (screw_of (real d))) (moved (hard t) (screw_of (real d))) - press * press).
    { assert (Pu : press = dot (normal (hard t)) (moved (hard t) (screw_of (real d)))).
      { unfold press, work, SpaceModel.N, force_at, moved, dot, cross, add; cbn. ring. }
      rewrite Pu. unfold s, slip. set (u := moved (hard t) (screw_of (real d))). set (k := dot (normal (hard t)) u / n2).
      assert (K : k * n2 = dot (normal (hard t)) u) by (unfold k; field; unfold n2 in *; lra).
      rewrite <- K at 3 4. fold n2. fold k. transitivity (n2 * (dot u u - 2 * k * dot (normal (hard t)) u + k * k * n2)).
      - unfold n2, dot, add, scale; cbn. ring.
      - rewrite <- K. ring. }
    rewrite Ss. unfold moved, x, turn, dot, add, cross, screw_of. cbn [linear angular SpaceModel.x SpaceModel.y SpaceModel.z].
    rewrite !at_real, P, Nn. cbn [SpaceModel.x SpaceModel.y SpaceModel.z]. fold e. ring.
Qed.

Lemma norm_triangle u v : norm (add u v) <= norm u + norm v.
Proof.
  pose proof (Rows.size_plus [1; 1; 1] (vector_list u) (vector_list v) three_positive) as S.
  change (Rows.plus (vector_list u) (vector_list v)) with (vector_list (add u v)) in S. now rewrite !size_is in S.
Qed.

Lemma norm_scale s u : 0 <= s -> norm (scale s u) = s * norm u.
Proof.
  intros S. unfold norm. replace (dot (scale s u) (scale s u)) with (s * s * dot u u) by (unfold dot, scale; cbn; ring).
  rewrite sqrt_mult_alt by apply Rle_0_sqr. now rewrite sqrt_square.
Qed.

Lemma space_mixed t f f' s r : 0 <= s -> 0 <= r -> in_cone_of_finger phi t f -> in_cone_of_finger phi t f' ->
  exists g, in_cone_of_finger phi t g /\ forall d, BodiesModel.finger_works t g d =
    s * BodiesModel.finger_works t f d + r * BodiesModel.finger_works t f' d.
Proof.
  destruct f as [[a f] m], f' as [[a' f'] m']. intros S0 R0 [(A & Ac & Fn) E] [(A' & Ac' & Fn') E'].
  exists (s * a + r * a', add (scale s f) (scale r f'), s * m + r * m'). split.
  - set (k := phi * friction (hard t) * length (hard t)) in *. split; [split; [|split]|].
    + apply Rplus_le_le_0_compat; now apply Rmult_le_pos.
    + replace 0 with (s * dot f (normal (hard t)) + r * dot f' (normal (hard t))) by (rewrite Ac, Ac'; ring).
      unfold dot, add, scale; cbn. ring.
    + eapply Rle_trans; [apply norm_triangle|]. rewrite !norm_scale by assumption.
      assert (s * norm f <= s * (k * a)) by (now apply Rmult_le_compat_l).
      assert (r * norm f' <= r * (k * a')) by (now apply Rmult_le_compat_l). fold k. lra.
    + fold k.
      assert (G0 : 0 <= gamma t).
      { unfold gamma. destruct (Req_dec (dot (normal (hard t)) (normal (hard t))) 0) as [Z|Z].
        - unfold Rdiv. rewrite Z, Rinv_0. lra.
        - apply Rmult_le_pos; [apply Rle_0_sqr|]. left. apply Rinv_0_lt_compat.
          pose proof (Turned.dot_nonneg (normal (hard t))). lra. }
      pose proof (Turned.norm_nonneg f) as N1. pose proof (Turned.norm_nonneg f') as N2.
      destruct (Rle_lt_or_eq_dec 0 (gamma t) G0) as [G|G].
      * (* the size of (f, m / gamma) with the weights of a finger *)
        pose proof (Fingers.four_positive _ G) as Ps.
        assert (Sz : forall f m, Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list f ++ [m / gamma t]) =
          sqrt (dot f f + gamma t * (m / gamma t * (m / gamma t)))) by (intros; apply Fingers.size_four).
        assert (One : forall f m q, 0 <= q -> gamma t * dot f f + m * m <= gamma t * (q * q) <->
          Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list f ++ [m / gamma t]) <= q).
        { intros f0 m0 q Q. rewrite Sz.
          replace (gamma t * dot f0 f0 + m0 * m0) with (gamma t * (dot f0 f0 + gamma t * (m0 / gamma t * (m0 / gamma t)))) by (field; lra).
          split; intros H.
          - rewrite <- (sqrt_square q Q). apply sqrt_le_1_alt. now apply Rmult_le_reg_l in H.
          - apply Rmult_le_compat_l; [exact G0|].
            assert (D : 0 <= dot f0 f0 + gamma t * (m0 / gamma t * (m0 / gamma t))).
            { pose proof (Turned.dot_nonneg f0). pose proof (Rle_0_sqr (m0 / gamma t)) as X. unfold Rsqr in X.
              assert (0 <= gamma t * (m0 / gamma t * (m0 / gamma t))) by (now apply Rmult_le_pos). lra. }
            rewrite <- (sqrt_sqrt _ D). apply Rmult_le_compat; try assumption; apply sqrt_pos. }
        assert (K1 : 0 <= k * a) by lra. assert (K2 : 0 <= k * a') by lra.
        apply One in E; [|exact K1]. apply One in E'; [|exact K2].
        apply One; [replace (k * (s * a + r * a')) with (s * (k * a) + r * (k * a')) by ring;
          apply Rplus_le_le_0_compat; now apply Rmult_le_pos|].
        replace (vector_list (add (scale s f) (scale r f')) ++ [(s * m + r * m') / gamma t]) with
          (Rows.plus (Rows.scaled s (vector_list f ++ [m / gamma t])) (Rows.scaled r (vector_list f' ++ [m' / gamma t])))
          by (unfold vector_list, add, scale; cbn; do 3 (f_equal; try ring); f_equal; field; lra).
        eapply Rle_trans; [apply Rows.size_plus, Ps|]. rewrite !Rows.size_scaled by assumption.
        assert (s * Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list f ++ [m / gamma t]) <= s * (k * a)) by (now apply Rmult_le_compat_l).
        assert (r * Rows.size ([1; 1; 1] ++ [gamma t]) (vector_list f' ++ [m' / gamma t]) <= r * (k * a')) by (now apply Rmult_le_compat_l).
        lra.
      * rewrite <- G in *. assert (m0 : m = 0) by nra. assert (m0' : m' = 0) by nra. rewrite m0, m0'. lra.
  - intros d. unfold BodiesModel.finger_works, work, contact_wrench, force_at, add, scale, dot, cross; cbn. ring.
Qed.

End Space.
