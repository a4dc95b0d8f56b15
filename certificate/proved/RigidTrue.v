(* SPDX-License-Identifier: MIT *)
(* What the rules of a class say of rows (RigidClass.v), said of grasps (RigidModel.v). *)
From Coq Require Import List Arith ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Meaning Root RowsOfModels Degree Matrix RigidModel Rigid RigidRows RigidClass.
From Proved Require Rows Model SpaceModel.
Import ListNotations.
Open Scope R_scope.

Notation "u .* v" := (Rows.dot u v) (at level 40).

Lemma is_positive_real q : is_positive q = true -> 0 < Q2R q.
Proof. intros H. apply positive_real. now apply negb_true_iff. Qed.

(* M is symmetric, and a.M a above 0 where a is not 0. *)
Definition good_mass (D : nat) (m : list (list R)) : Prop :=
  List.length m = D /\ (forall u v, u .* times m v = v .* times m u) /\
  forall a, List.length a = D -> a <> repeat 0 D -> 0 < a .* times m a.

Ltac rationals := rewrite ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp, ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp,
  ?Q2R_0, ?Q2R_1.

Lemma plane_mass numbers m : masses numbers = Some m -> List.length m = 3%nat ->
  exists i, inertia_of numbers i /\ map real m = mass_rows i /\ 0 < gyration_squared i.
Proof.
  intros H L. unfold masses in H.
  destruct numbers as [|x [|y [|g [|xx [|yy [|zz [|xy [|xz [|yz [|? ?]]]]]]]]]]; try discriminate.
  - destruct (is_positive g) eqn:P; [|discriminate]. injection H as <-.
    exists (InertiaInPlane (Q2R x) (Q2R y) (Q2R g)). split; [reflexivity|]. split; [|now apply is_positive_real].
    unfold mass_rows, real. cbn [map center_x center_y gyration_squared]. rationals. reflexivity.
  - destruct (_ && _ && _); [|discriminate]. injection H as <-. discriminate.
Qed.

Lemma plane_mass_good i : 0 < gyration_squared i -> good_mass 3 (mass_rows i).
Proof.
  intros G. split; [reflexivity|]. split.
  - intros u v. rewrite !mass_rows_are. unfold accelerates, Model.work, Model.add, Model.force_at; cbn. ring.
  - intros a L N. destruct a as [|a1 [|a2 [|a3 [|? ?]]]]; try discriminate. rewrite mass_rows_are.
    unfold accelerates, Model.work, Model.add, Model.force_at, motion_of, at_; cbn.
    set (p := a1 - a3 * center_y i). set (q := a2 + a3 * center_x i). set (s := gyration_squared i) in *.
    match goal with |- 0 < ?X => replace X with (p * p + q * q + s * (a3 * a3)) by (unfold p, q; ring) end.
    pose proof (Rle_0_sqr p) as P1. pose proof (Rle_0_sqr q) as P2. pose proof (Rle_0_sqr a3) as P3. unfold
      Rsqr in *.
    destruct (Req_dec a3 0) as [Z|Z].
    + unfold p, q in *. rewrite Z in *. rewrite !Rmult_0_l, Rmult_0_r, Rplus_0_r, Rminus_0_r in *.
      destruct (Req_dec a1 0) as [Z1|Z1]; [destruct (Req_dec a2 0) as [Z2|Z2]|].
      * exfalso. apply N. cbn. congruence.
      * pose proof (Rsqr_pos_lt a2 Z2). unfold Rsqr in *. lra.
      * pose proof (Rsqr_pos_lt a1 Z1). unfold Rsqr in *. lra.
    + pose proof (Rsqr_pos_lt a3 Z). unfold Rsqr in *. pose proof (Rmult_lt_0_compat _ _ G H). lra.
Qed.

Lemma space_mass numbers m : masses numbers = Some m -> List.length m = 6%nat ->
  exists i, inertia_of_space numbers i /\ map real m = space_mass_rows i /\ (let t := about_center i in
    0 < xx t /\ 0 < xx t * yy t - xy t * xy t /\
    0 < zz t * (xx t * yy t - xy t * xy t) - xx t * (yz t * yz t) - yy t * (xz t * xz t) + 2 * xy t * xz t * yz t).
Proof.
  intros H L. unfold masses in H.
  destruct numbers as [|x [|y [|g [|xx [|yy [|zz [|xy [|xz [|yz [|? ?]]]]]]]]]]; try discriminate.
  - destruct (is_positive g); [|discriminate]. injection H as <-. discriminate.
  - destruct (is_positive xx && _ && _) eqn:P; [|discriminate]. injection H as <-. rewrite !andb_true_iff in P.
    destruct P as [[P1 P2] P3]. apply is_positive_real in P1, P2, P3.
    exists (InertiaInSpace (SpaceModel.Vector (Q2R x) (Q2R y) (Q2R g))
      (Tensor (Q2R xx) (Q2R yy) (Q2R zz) (Q2R xy) (Q2R xz) (Q2R yz))).
    split; [reflexivity|]. split.
    + unfold space_mass_rows, real. cbn [map center about_center SpaceModel.x SpaceModel.y SpaceModel.z
        RigidModel.xx RigidModel.yy RigidModel.zz RigidModel.xy RigidModel.xz RigidModel.yz]. rationals.
          reflexivity.
    + cbn. revert P2 P3. rationals. replace (Q2R 2) with 2 by (unfold Q2R; cbn; lra). intros. split; [exact
        P1|]. split; lra.
Qed.

(* A symmetric matrix of 3 rows with leading minors above 0. *)
Lemma tensor_positive a b c d e f x y z : 0 < a -> 0 < a * b - d * d ->
  0 < c * (a * b - d * d) - a * (f * f) - b * (e * e) + 2 * d * e * f ->
  0 <= a * x * x + b * y * y + c * z * z + 2 * d * x * y + 2 * e * x * z + 2 * f * y * z /\
  (a * x * x + b * y * y + c * z * z + 2 * d * x * y + 2 * e * x * z + 2 * f * y * z = 0 -> x = 0 /\ y = 0 /\ z
    = 0).
Proof.
  intros A M Dt. set (m := a * b - d * d) in *. set (det := c * m - a * (f * f) - b * (e * e) + 2 * d * e * f) in *.
  set (q := a * x * x + b * y * y + c * z * z + 2 * d * x * y + 2 * e * x * z + 2 * f * y * z).
  set (l := a * x + d * y + e * z). set (k := m * y + (a * f - d * e) * z).
  assert (E : a * m * q = m * (l * l) + k * k + a * det * (z * z)) by (unfold q, l, k, det, m; ring).
  pose proof (Rle_0_sqr l) as L2. pose proof (Rle_0_sqr k) as K2. pose proof (Rle_0_sqr z) as Z2. unfold Rsqr in *.
  assert (AM : 0 < a * m) by (apply Rmult_lt_0_compat; assumption).
  assert (AD : 0 < a * det) by (apply Rmult_lt_0_compat; assumption).
  assert (T1 : 0 <= m * (l * l)) by (apply Rmult_le_pos; lra).
  assert (T3 : 0 <= a * det * (z * z)) by (apply Rmult_le_pos; lra).
  split.
  - apply Rmult_le_reg_l with (a * m); [exact AM|]. lra.
  - intros Q0. rewrite Q0, Rmult_0_r in E.
    assert (Zz : z = 0).
    { apply Rsqr_0_uniq. unfold Rsqr. apply Rmult_eq_reg_l with (a * det); lra. }
    assert (Zk : k = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    assert (Zl : l = 0) by (apply Rsqr_0_uniq; unfold Rsqr; apply Rmult_eq_reg_l with m; lra).
    unfold k in Zk. rewrite Zz in Zk. assert (Zy : y = 0) by (apply Rmult_eq_reg_l with m; lra).
    unfold l in Zl. rewrite Zz, Zy in Zl. assert (Zx : x = 0) by (apply Rmult_eq_reg_l with a; lra). auto.
Qed.

Lemma space_mass_good i : (let t := about_center i in
    0 < xx t /\ 0 < xx t * yy t - xy t * xy t /\
    0 < zz t * (xx t * yy t - xy t * xy t) - xx t * (yz t * yz t) - yy t * (xz t * xz t) + 2 * xy t * xz t * yz
      t) ->
  good_mass 6 (space_mass_rows i).
Proof.
  intros (P1 & P2 & P3). split; [reflexivity|]. split.
  - intros u v. rewrite !space_mass_rows_are.
    unfold accelerates_in_space, SpaceModel.work, SpaceModel.add_screw, SpaceModel.force_at, SpaceModel.add,
      SpaceModel.cross,
      turned_by, SpaceModel.dot, SpaceModel.zero; cbn. ring.
  - intros a L N. destruct a as [|a1 [|a2 [|a3 [|a4 [|a5 [|a6 [|? ?]]]]]]]; try discriminate. rewrite
      space_mass_rows_are.
    set (c := center i). set (t := about_center i) in *.
    set (p := a1 + (a5 * SpaceModel.z c - a6 * SpaceModel.y c)). set (q := a2 + (a6 * SpaceModel.x c - a4 *
      SpaceModel.z c)).
    set (r := a3 + (a4 * SpaceModel.y c - a5 * SpaceModel.x c)).
    destruct (tensor_positive _ _ _ _ _ _ a4 a5 a6 P1 P2 P3) as [Q0 Q1].
    set (w := xx t * a4 * a4 + yy t * a5 * a5 + zz t * a6 * a6 + 2 * xy t * a4 * a5 + 2 * xz t * a4 * a6 + 2 *
      yz t * a5 * a6) in *.
    match goal with |- 0 < ?X => replace X with (p * p + q * q + r * r + w) by
      (unfold accelerates_in_space, SpaceModel.work, SpaceModel.add_screw, SpaceModel.force_at, SpaceModel.add,
         SpaceModel.cross, turned_by, SpaceModel.dot, SpaceModel.zero, screw_of, at_, p, q, r, w, c, t; cbn;
           ring) end.
    pose proof (Rle_0_sqr p) as S1. pose proof (Rle_0_sqr q) as S2. pose proof (Rle_0_sqr r) as S3. unfold Rsqr
      in *.
    destruct (Req_dec (p * p + q * q + r * r + w) 0) as [Z|Z]; [|lra]. exfalso. apply N.
    destruct Q1 as (Z4 & Z5 & Z6); [lra|].
    assert (Zp : p = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). assert (Zq : q = 0) by (apply Rsqr_0_uniq;
      unfold Rsqr; lra).
    assert (Zr : r = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). unfold p in Zp. unfold q in Zq. unfold r in Zr.
    rewrite Z4, Z5, Z6 in *. cbn. replace a1 with 0 by lra. replace a2 with 0 by lra. replace a3 with 0 by lra.
      reflexivity.
Qed.

(* ---- From rows to grasps ---- *)

Lemma plane_class c g i m : map real m = mass_rows i ->
  is_of_class c (repeat 0 3) (can_rows m (grasp_rows g)) -> is_of_class c Model.zero (can g i).
Proof.
  intros E H.
  assert (To : forall a, can g i a -> can_rows m (grasp_rows g) (motion_list a)).
  { intros a (fs & S). eexists. rewrite E. apply rows_of_rigid, S. }
  assert (From : forall a, can_rows m (grasp_rows g) a -> List.length a = 3%nat /\ can g i (motion_of a)).
  { intros a (fs & S). rewrite E in S. split; [apply S|]. eexists. apply rigid_of_rows, S. }
  assert (Z : motion_list Model.zero = repeat 0 3) by reflexivity.
  assert (Back : forall a, motion_list a = repeat 0 3 -> a = Model.zero).
  { intros [p q r] X. injection X as -> -> ->. reflexivity. }
  destruct c; unfold is_of_class, must_move, must_hold, is_open in *.
  - intros C. apply H. rewrite <- Z. now apply To.
  - destruct H as [H1 H2]. split; [apply (From _ H1)|]. intros a C. apply Back, H2, To, C.
  - destruct H as [H1 (a & N & C)]. split; [apply (From _ H1)|]. destruct (From a C) as [L C']. exists
      (motion_of a).
    split; [|exact C']. intros X. apply N. destruct a as [|a1 [|a2 [|a3 [|? ?]]]]; try discriminate.
    unfold motion_of, at_, Model.zero in X. cbn in X. injection X as -> -> ->. reflexivity.
Qed.

Lemma space_class c g i m : map real m = space_mass_rows i ->
  is_of_class c (repeat 0 6) (can_rows m (space_grasp_rows g)) -> is_of_class c SpaceModel.no_screw
    (can_in_space g i).
Proof.
  intros E H.
  assert (To : forall a, can_in_space g i a -> can_rows m (space_grasp_rows g) (screw_list a)).
  { intros a (fs & S). eexists. rewrite E. apply space_rows_of_rigid, S. }
  assert (From : forall a, can_rows m (space_grasp_rows g) a -> List.length a = 6%nat /\ can_in_space g i
    (screw_of a)).
  { intros a (fs & S). rewrite E in S. split; [apply S|]. apply space_rigid_of_rows in S. exact S. }
  assert (Z : screw_list SpaceModel.no_screw = repeat 0 6) by reflexivity.
  assert (Back : forall a, screw_list a = repeat 0 6 -> a = SpaceModel.no_screw).
  { intros [[p q r] [s t u]] X. injection X as -> -> -> -> -> ->. reflexivity. }
  destruct c; unfold is_of_class, must_move, must_hold, is_open in *.
  - intros C. apply H. rewrite <- Z. now apply To.
  - destruct H as [H1 H2]. split; [apply (From _ H1)|]. intros a C. apply Back, H2, To, C.
  - destruct H as [H1 (a & N & C)]. split; [apply (From _ H1)|]. destruct (From a C) as [L C']. exists (screw_of a).
    split; [|exact C']. intros X. apply N. destruct a as [|a1 [|a2 [|a3 [|a4 [|a5 [|a6 [|? ?]]]]]]]; try
      discriminate.
    unfold screw_of, at_, SpaceModel.no_screw, SpaceModel.zero in X. cbn in X. injection X as -> -> -> -> ->
      ->. reflexivity.
Qed.
