(* SPDX-License-Identifier: MIT *)
(* The solutions of RigidModel.v are those of rows (Rigid.v). *)
From Coq Require Import Reals List Lra Lia.
From Proved Require Import Rows RowsOfModels RigidModel Degree.
From Proved Require Rigid Model SpaceModel.
Import ListNotations.
Open Scope R_scope.

(* ---- The plane ---- *)

Definition mass_rows (m : inertia_in_plane) : list (list R) :=
  let x := center_x m in let y := center_y m in
  [[1; 0; - y]; [0; 1; x]; [- y; x; x * x + y * y + gyration_squared m]].

Lemma mass_rows_are m a y :
  Rows.dot y (times (mass_rows m) a) = Model.work (accelerates m (motion_of a)) (motion_of y).
Proof.
  assert (D : forall p q r a, dot [p; q; r] a = p * at_ a 0 + q * at_ a 1 + r * at_ a 2) by (intros; dots; cbn;
    ring).
  rewrite dot_sym. unfold mass_rows, times. cbn [map]. rewrite !D.
  unfold accelerates, Model.work, Model.add, Model.force_at, motion_of; cbn. ring.
Qed.

Lemma rigid_obeys_is a c n g : Rigid.rigid_obeys a (contact_row c) (n, g) ->
  rigid_obeys (motion_of a) c (n, at_ g 0).
Proof.
  intros ((N0 & Na & NN) & C & D). cbn [Rows.N contact_row] in *. rewrite dot_motion in *.
  rewrite slip_is, size_one in D. cbn [weights rho contact_row] in *.
  replace (product [1] g [Model.work (Model.T c) (motion_of a)]) with (at_ g 0 * Model.work (Model.T c)
    (motion_of a)) in D
    by (destruct g; unfold at_; cbn; ring).
  repeat split; try assumption; [|lra].
  rewrite <- size_one. eapply Rle_trans; [|exact C]. right. unfold size. f_equal. destruct g; unfold at_; cbn; ring.
Qed.

Lemma rigid_obeys_as_row a c f : rigid_obeys a c f -> Rigid.rigid_obeys (motion_list a) (contact_row c)
  (row_force f).
Proof.
  destruct f as [n b]. intros (N0 & Na & NN & C & D). unfold row_force, Rigid.rigid_obeys; cbn [fst snd].
  cbn [Rows.N contact_row]. rewrite dot_motion, of_list, slip_is, of_list, !size_one. cbn [weights rho contact_row].
  repeat split; try assumption. cbn. lra.
Qed.

Theorem rows_of_rigid g m a fs : rigid_solution g m a fs ->
  Rigid.rigid_solution (grasp_rows g) (mass_rows m) (motion_list a) (map row_force fs).
Proof.
  intros [O B]. split; [reflexivity|]. split.
  - cbn [rows grasp_rows]. clear B. induction O; cbn; constructor; auto. now apply rigid_obeys_as_row.
  - intros y. rewrite mass_rows_are, of_list, B. cbn [rows wrench grasp_rows]. rewrite dot_motion, works_are,
      map_map.
    rewrite (map_ext _ (fun f => f)) by (now intros [n b]). rewrite map_id. unfold Model.work, Model.add; cbn. ring.
Qed.

Theorem rigid_of_rows g m a fs : Rigid.rigid_solution (grasp_rows g) (mass_rows m) a fs ->
  rigid_solution g m (motion_of a) (map (fun f => (fst f, at_ (snd f) 0)) fs).
Proof.
  intros (_ & O & B). cbn [rows wrench grasp_rows] in *. split.
  - clear B. revert fs O. induction (Model.contacts g) as [|c cs IH]; intros fs O; inversion O as [|? [n b] ?
      fs' Oc Os];
      subst; cbn; constructor; [now apply rigid_obeys_is|now apply IH].
  - assert (E : forall y, Model.work (accelerates m (motion_of a)) (motion_of y) =
      Model.work (Model.add (Model.wrench g) (Model.sum (Model.contact_wrenches (Model.contacts g)
        (map (fun f => (fst f, at_ (snd f) 0)) fs)))) (motion_of y)).
    { intros y. specialize (B y). rewrite mass_rows_are, dot_motion, works_are in B. rewrite B.
      unfold Model.work, Model.add; cbn. ring. }
    pose proof (E [1; 0; 0]) as X. pose proof (E [0; 1; 0]) as Y. pose proof (E [0; 0; 1]) as Z.
    destruct (accelerates m (motion_of a)) as [p q r]. destruct (Model.add (Model.wrench g) _) as [p' q' r'].
    unfold Model.work, motion_of, at_ in *; cbn in *. f_equal; lra.
Qed.

(* ---- Space ---- *)

Section Space.
Import SpaceModel.

Definition space_mass_rows (m : inertia_in_space) : list (list R) :=
  let p := x (center m) in let q := y (center m) in let r := z (center m) in let t := about_center m in
  [[1; 0; 0; 0; r; - q]; [0; 1; 0; - r; 0; p]; [0; 0; 1; q; - p; 0];
   [0; - r; q; q * q + r * r + xx t; - (p * q) + xy t; - (p * r) + xz t];
   [r; 0; - p; - (p * q) + xy t; p * p + r * r + yy t; - (q * r) + yz t];
   [- q; p; 0; - (p * r) + xz t; - (q * r) + yz t; p * p + q * q + zz t]].

Lemma space_mass_rows_are m a y :
  Rows.dot y (times (space_mass_rows m) a) = work (accelerates_in_space m (screw_of a)) (screw_of y).
Proof.
  assert (D : forall p q r s t u a, Rows.dot [p; q; r; s; t; u] a = p * at_ a 0 + q * at_ a 1 + r * at_ a 2 + s
    * at_ a 3 +
    t * at_ a 4 + u * at_ a 5) by (intros; dots; cbn; ring).
  rewrite dot_sym. unfold space_mass_rows, times. cbn [map]. rewrite !D.
  unfold accelerates_in_space, work, add_screw, force_at, add, cross, turned_by, screw_of, dot, zero. cbn. ring.
Qed.

Lemma space_rigid_obeys_is a c f : Rigid.rigid_obeys a (space_contact_row c) f ->
  rigid_obeys_in_space (screw_of a) c (space_force c f).
Proof.
  destruct f as [n g]. intros ((N0 & Na & NN) & C & D). cbn [Rows.N space_contact_row] in *. rewrite dot_screw in *.
  rewrite space_slip_is, size_is in D. cbn [weights rho space_contact_row] in *. rewrite product_three in D.
  unfold rigid_obeys_in_space, space_force; cbn [fst snd]. repeat split; try assumption.
  - apply dot_across.
  - rewrite <- size_of_list in C. eapply Rle_trans; [apply norm_across|exact C].
  - rewrite slip_across, friction_across, <- slip_across. lra.
Qed.

Lemma space_rigid_obeys_as_row a c f : rigid_obeys_in_space a c f ->
  Rigid.rigid_obeys (screw_list a) (space_contact_row c) (space_row_force f).
Proof.
  destruct f as [n f]. intros (N0 & Na & NN & _ & C & D). unfold space_row_force, Rigid.rigid_obeys; cbn [fst snd].
  cbn [Rows.N space_contact_row]. rewrite dot_screw, screw_of_list, space_slip_is, screw_of_list, !size_is.
  cbn [weights rho space_contact_row]. rewrite product_three. change (vector_of (vector_list f)) with (Vector
    (x f) (y f) (z f)).
  replace (Vector (x f) (y f) (z f)) with f by now destruct f. repeat split; try assumption. lra.
Qed.

Theorem space_rows_of_rigid g m a fs : rigid_solution_in_space g m a fs ->
  Rigid.rigid_solution (space_grasp_rows g) (space_mass_rows m) (screw_list a) (map space_row_force fs).
Proof.
  intros [O B]. split; [reflexivity|]. split.
  - cbn [rows space_grasp_rows]. clear B. induction O; cbn; constructor; auto. now apply space_rigid_obeys_as_row.
  - intros e. rewrite space_mass_rows_are, screw_of_list, B. cbn [rows Rows.wrench space_grasp_rows]. rewrite
      dot_screw, space_works_are.
    assert (E : map (fun cf => space_force (fst cf) (snd cf)) (combine (contacts g) (map space_row_force fs)) = fs).
    { clear B. induction O as [|c [n f] cs fs Oc O IH]; cbn; [reflexivity|]. rewrite IH. f_equal.
      unfold space_force, space_row_force; cbn. f_equal.
      destruct Oc as (_ & _ & _ & Z & _). destruct f as [p q r]. exact (across_idle _ _ Z). }
    rewrite E. unfold work, add_screw, add, dot; cbn. ring.
Qed.

Theorem space_rigid_of_rows g m a fs : Rigid.rigid_solution (space_grasp_rows g) (space_mass_rows m) a fs ->
  exists fs', rigid_solution_in_space g m (screw_of a) fs'.
Proof.
  intros (_ & O & B). cbn [rows Rows.wrench space_grasp_rows] in *.
  set (fs' := map (fun cf => space_force (fst cf) (snd cf)) (combine (contacts g) fs)). exists fs'. split.
  - unfold fs'. clear B fs'. revert fs O. induction (contacts g) as [|c cs IH]; intros fs O; inversion O;
      subst; cbn;
      constructor; [now apply space_rigid_obeys_is|now apply IH].
  - assert (E : forall e, work (accelerates_in_space m (screw_of a)) (screw_of e) =
      work (add_screw (wrench g) (sum (contact_wrenches (contacts g) fs'))) (screw_of e)).
    { intros e. specialize (B e). rewrite space_mass_rows_are, dot_screw, space_works_are in B. rewrite B.
        unfold fs'.
      unfold work, add_screw, add, dot; cbn. ring. }
    pose proof (E [1]) as E1. pose proof (E [0; 1]) as E2. pose proof (E [0; 0; 1]) as E3. pose proof (E [0; 0;
      0; 1]) as E4.
    pose proof (E [0; 0; 0; 0; 1]) as E5. pose proof (E [0; 0; 0; 0; 0; 1]) as E6.
    destruct (accelerates_in_space m (screw_of a)) as [[p1 p2 p3] [p4 p5 p6]].
    destruct (add_screw (wrench g) _) as [[q1 q2 q3] [q4 q5 q6]].
    unfold work, dot, screw_of, at_ in *; cbn in *. f_equal; f_equal; lra.
Qed.

End Space.
