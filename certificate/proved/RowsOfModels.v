(* SPDX-License-Identifier: MIT *)
(* The rows (Rows.v) of a grasp in the plane (Model.v) and in space (SpaceModel.v): a grasp is stable if and
   only if its rows are. *)
From Coq Require Import Reals List Lra.
From Proved Require Import Rows.
From Proved Require Model SpaceModel BodiesModel.
Import ListNotations.
Open Scope R_scope.

(* Of lists of any length: what is not there is 0. *)
Notation at_ := BodiesModel.at_.
Notation motion_of := BodiesModel.motion_of.
Notation screw_of := BodiesModel.screw_of.

Lemma at_cons a y k : at_ (a :: y) (S k) = at_ y k.
Proof. reflexivity. Qed.

Lemma dot_cons a s y : dot (a :: s) y = a * at_ y 0 + dot s (tl y).
Proof. destruct y; cbn; [|reflexivity]. unfold at_; cbn. destruct s; cbn; ring. Qed.

Lemma at_tl y k : at_ (tl y) k = at_ y (S k).
Proof. destruct y, k; reflexivity. Qed.

Ltac dots := repeat rewrite ?dot_cons, ?at_tl; cbn [dot].

(* A slip and its friction, where they are not 0. *)
Lemma sqrt_positive x : 0 < sqrt x <-> 0 < x.
Proof.
  split; [|apply sqrt_lt_R0]. intros H. apply Rnot_le_lt. intros L.
  rewrite (sqrt_neg_0 x L) in H. lra.
Qed.

(* ---- The plane ---- *)

Section Plane.
Import Model.

Definition motion_list (d : vector) : list R := [along_x d; along_y d; about_z d].

Definition contact_row (c : contact) : row :=
  Row (motion_list (N c)) [motion_list (T c)] [1] (friction c)
    (preload c / length c) (growth c / length c) (stiffness c / (length c * length c)) false.

Definition grasp_rows (g : grasp) : system :=
  System 3 (map contact_row (contacts g)) (motion_list (wrench g)) (motion_list (direction g)) (normal g).

Definition row_force (f : R * R) : force := (fst f, [snd f]).

Lemma dot_motion a y : dot (motion_list a) y = work a (motion_of y).
Proof. unfold motion_list, work, motion_of. dots. cbn. ring. Qed.

Lemma of_list d : motion_of (motion_list d) = d.
Proof. now destruct d. Qed.

Lemma slip_is c y : slip (contact_row c) y = [work (T c) (motion_of y)].
Proof. unfold slip. cbn [slips contact_row map]. now rewrite dot_motion. Qed.

Lemma size_one t : size [1] [t] = Rabs t.
Proof. unfold size; cbn. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring. Qed.

Lemma v_is c d lambda : Rows.v (contact_row c) d 1 lambda = v c lambda (motion_of d).
Proof. unfold Rows.v, v, contact_row; cbn [preload growth stiffness Rows.N Rows.preload Rows.growth Rows.stiffness].
  rewrite dot_motion. unfold Rdiv. ring. Qed.

Lemma obeys_is l d lambda c a g :
  Rows.obeys l d 1 lambda (contact_row c) (a, g) -> obeys l lambda (motion_of d) c (a, at_ g 0).
Proof.
  intros (L & C & S). rewrite v_is in L. rewrite slip_is, size_one in S. cbn [rho weights contact_row] in *.
  assert (C' : Rabs (at_ g 0) <= friction c * a).
  { rewrite <- size_one. eapply Rle_trans; [|exact C]. right. unfold size. f_equal.
    destruct g; unfold at_; cbn; ring. }
  set (t := work (T c) (motion_of d)) in *.
  replace (product [1] g [t]) with (at_ g 0 * t) in S by (destruct g; unfold at_; cbn; ring).
  unfold obeys. fold t. split; [exact L|]. split; [exact C'|]. split; intros H.
  - rewrite Rabs_right in S by lra. apply Rmult_eq_reg_r with t; lra.
  - rewrite Rabs_left in S by lra. apply Rmult_eq_reg_r with t; lra.
Qed.

Lemma obeys_as_row l d lambda c f : obeys l lambda (motion_of d) c f ->
  Rows.obeys l d 1 lambda (contact_row c) (row_force f).
Proof.
  destruct f as [a b]. intros (L & C & P & M). unfold row_force; cbn [fst snd Rows.obeys].
  rewrite v_is, slip_is. cbn [rho weights contact_row]. rewrite !size_one.
  split; [exact L|]. split; [exact C|]. set (t := work (T c) (motion_of d)) in *. cbn.
  destruct (Rtotal_order t 0) as [H|[H|H]].
  - rewrite M, Rabs_left by exact H. ring.
  - rewrite H, Rabs_R0. ring.
  - rewrite P, Rabs_right by lra. ring.
Qed.

Lemma work_is c a g y : Rows.work (contact_row c) (a, g) y = work (contact_wrench c (a, at_ g 0)) (motion_of y).
Proof.
  unfold Rows.work. rewrite slip_is. cbn [fst snd Rows.N weights contact_row]. rewrite dot_motion.
  replace (product [1] g [work (T c) (motion_of y)]) with (at_ g 0 * work (T c) (motion_of y))
    by (destruct g; unfold at_; cbn; ring).
  unfold work, contact_wrench, add, scale; cbn. ring.
Qed.

Lemma works_are cs fs y :
  works (map contact_row cs) fs y = work (sum (contact_wrenches cs (map (fun f => (fst f, at_ (snd f) 0)) fs)))
                                      (motion_of y).
Proof.
  revert fs. induction cs as [|c cs IH]; intros [|[a g] fs]; try (unfold work; cbn; ring).
  cbn [map works]. rewrite IH, work_is. unfold sum, contact_wrenches, work, contact_wrench, add, scale, at_; cbn. ring.
Qed.

Lemma load_is g l y : load (grasp_rows g) 1 l y = work (add (wrench g) (scale l (direction g))) (motion_of y).
Proof. unfold load, grasp_rows; cbn [Rows.wrench Rows.direction]. rewrite !dot_motion. unfold work, add, scale; cbn. ring. Qed.

Theorem rows_of_equilibrium g lambda d fs : equilibrium g lambda d fs ->
  Rows.equilibrium (grasp_rows g) (motion_list d) 1 lambda (map row_force fs).
Proof.
  intros [O B]. split; [reflexivity|]. split.
  - cbn [rows normal grasp_rows]. clear B. induction O as [|c f cs fs Oc O IH]; cbn; constructor; auto.
    apply obeys_as_row. now rewrite of_list.
  - intros y. rewrite load_is. cbn [rows grasp_rows]. rewrite works_are, map_map.
    rewrite (map_ext _ (fun f => f)) by (now intros [a b]). rewrite map_id.
    transitivity (work zero (motion_of y)); [|unfold work; cbn; ring].
    rewrite <- B. unfold work, add; cbn. ring.
Qed.

Theorem equilibrium_of_rows g lambda d fs : Rows.equilibrium (grasp_rows g) d 1 lambda fs ->
  equilibrium g lambda (motion_of d) (map (fun f => (fst f, at_ (snd f) 0)) fs).
Proof.
  intros (_ & O & B). cbn [rows normal grasp_rows] in *. split.
  - clear B. revert fs O. induction (contacts g) as [|c cs IH]; intros fs O; inversion O as [|? [a b] ? fs' Oc Os];
      subst; cbn; constructor; [now apply obeys_is|now apply IH].
  - assert (E : forall y, work (add (add (wrench g) (scale lambda (direction g)))
        (sum (contact_wrenches (contacts g) (map (fun f => (fst f, at_ (snd f) 0)) fs)))) (motion_of y) = 0).
    { intros y. specialize (B y). rewrite load_is, works_are in B. rewrite <- B. unfold work, add; cbn. ring. }
    pose proof (E [1; 0; 0]) as X. pose proof (E [0; 1; 0]) as Y. pose proof (E [0; 0; 1]) as Z.
    destruct (add _ _) as [a b c]. unfold work, motion_of, at_ in *; cbn in *. unfold zero. f_equal; lra.
Qed.

Theorem stable_as_rows (allowed : list R -> Prop) g lambda :
  stable_at (fun d => allowed (motion_list d)) g lambda <-> Rows.stable_at allowed (grasp_rows g) lambda.
Proof.
  split; intros (d & fs & A & E).
  - exists (motion_list d). eexists. split; [exact A|]. apply rows_of_equilibrium, E.
  - exists (motion_of d). eexists. split; [|apply equilibrium_of_rows, E]. destruct E as (L & _).
    destruct d as [|x [|y [|z [|? ?]]]]; try discriminate L. exact A.
Qed.

End Plane.

(* ---- Space ---- *)

Section Space.
Import SpaceModel.

Definition screw_list (d : screw) : list R :=
  [x (linear d); y (linear d); z (linear d); x (angular d); y (angular d); z (angular d)].

(* The direction e - (e.n / n.n) n across the normal n. *)
Definition across (n e : vector) : vector := add e (scale (- (dot e n / dot n n)) n).

Definition slip_rows (c : contact) : list (list R) :=
  map (fun e => screw_list (force_at (position c) (across (normal c) e)))
    [Vector 1 0 0; Vector 0 1 0; Vector 0 0 1].

Definition space_contact_row (c : contact) : row :=
  Row (screw_list (N c)) (slip_rows c) [1; 1; 1] (friction c * length c)
    (preload c / length c) (growth c / length c) (stiffness c / (length c * length c)) false.

Definition space_grasp_rows (g : grasp) : system :=
  System 6 (map space_contact_row (contacts g)) (screw_list (wrench g)) (screw_list (direction g)) (normal_law g).

Definition vector_list (a : vector) : list R := [x a; y a; z a].
Definition vector_of (g : list R) : vector := Vector (at_ g 0) (at_ g 1) (at_ g 2).

Lemma dot_screw a d : Rows.dot (screw_list a) d = work a (screw_of d).
Proof. unfold screw_list, work, screw_of, dot. dots. cbn. ring. Qed.

Lemma screw_of_list d : screw_of (screw_list d) = d.
Proof. now destruct d as [[] []]. Qed.

Lemma space_slip_is c d : Rows.slip (space_contact_row c) d = vector_list (slip c (screw_of d)).
Proof.
  unfold Rows.slip. cbn [slips space_contact_row slip_rows map]. rewrite !dot_screw.
  unfold vector_list. f_equal; [|f_equal; [|f_equal]];
    unfold work, force_at, across, slip, moved, add, scale, dot, cross; cbn; unfold Rdiv; ring.
Qed.

Lemma size_is s : size [1; 1; 1] (vector_list s) = norm s.
Proof. unfold size, norm, dot, vector_list; cbn. f_equal. ring. Qed.

Lemma space_v_is c d lambda : Rows.v (space_contact_row c) d 1 lambda = v c lambda (screw_of d).
Proof. unfold Rows.v, v. cbn [Rows.N Rows.preload Rows.growth Rows.stiffness space_contact_row].
  rewrite dot_screw. unfold Rdiv. ring. Qed.

Lemma norm_positive s : s <> zero <-> 0 < norm s.
Proof.
  unfold norm. rewrite sqrt_positive. destruct s as [a b c]. unfold dot, zero; cbn.
  pose proof (Rle_0_sqr a) as A. pose proof (Rle_0_sqr b) as B. pose proof (Rle_0_sqr c) as C.
  unfold Rsqr in *. split; intros H.
  - apply Rnot_le_lt. intros L. apply H. f_equal; apply Rsqr_0_uniq; unfold Rsqr; lra.
  - intros E. injection E as -> -> ->. lra.
Qed.

Lemma no_length n : dot n n = 0 -> n = zero.
Proof.
  intros Z. destruct n as [p q r]. unfold dot in Z; cbn in Z. pose proof (Rle_0_sqr p) as A.
  pose proof (Rle_0_sqr q) as B. pose proof (Rle_0_sqr r) as C.
  unfold Rsqr in *. unfold zero. f_equal; apply Rsqr_0_uniq; unfold Rsqr; lra.
Qed.

(* What is along the normal of a friction does no work on slips, which are across it. *)
Lemma friction_across c (g e : vector) :
  dot (across (normal c) g) (across (normal c) e) = dot g (across (normal c) e).
Proof.
  unfold across. set (n := normal c). destruct (Req_dec (dot n n) 0) as [Z|Z].
  - rewrite (no_length n Z). unfold dot, add, scale, zero; cbn. ring.
  - unfold dot, add, scale in *; cbn in *. field. exact Z.
Qed.

Lemma slip_across c d : slip c d = across (normal c) (moved c d).
Proof. unfold slip, across. do 2 f_equal. unfold dot, Rdiv. ring. Qed.

Lemma across_idle n g : dot g n = 0 -> across n g = g.
Proof.
  intros Z. unfold across. rewrite Z. destruct g. unfold add, scale; cbn. unfold Rdiv.
  f_equal; ring.
Qed.

Lemma dot_across n g : dot (across n g) n = 0.
Proof.
  unfold across. destruct (Req_dec (dot n n) 0) as [Z|Z].
  - rewrite (no_length n Z). unfold dot, zero; cbn. ring.
  - unfold dot, add, scale in *; cbn in *. field. exact Z.
Qed.

Lemma norm_across n g : norm (across n g) <= norm g.
Proof.
  unfold norm. apply sqrt_le_1_alt. unfold across. set (k := dot g n / dot n n).
  assert (E : dot (add g (scale (- k) n)) (add g (scale (- k) n)) =
              dot g g - 2 * k * dot g n + k * k * dot n n)
    by (unfold dot, add, scale; cbn; ring).
  rewrite E. destruct (Req_dec (dot n n) 0) as [Z|Z].
  - unfold k, Rdiv. rewrite Z. rewrite Rinv_0. lra.
  - assert (P : 0 < dot n n).
    { assert (0 <= dot n n); [|lra]. unfold dot.
      pose proof (Rle_0_sqr (x n)) as A. pose proof (Rle_0_sqr (y n)) as B. pose proof (Rle_0_sqr (z n)) as C.
      unfold Rsqr in *. lra. }
    assert (K : dot g n = k * dot n n) by (unfold k; field; exact Z). rewrite K.
    assert (0 <= k * k * dot n n) by (apply Rmult_le_pos; [apply Rle_0_sqr|lra]). lra.
Qed.

Definition space_row_force (f : R * vector) : force := (fst f, vector_list (snd f)).
Definition space_force (c : contact) (f : force) : R * vector :=
  (fst f, across (normal c) (vector_of (snd f))).

Lemma product_three g s : product [1; 1; 1] g (vector_list s) = dot (vector_of g) s.
Proof.
  unfold dot, vector_of, vector_list, at_. destruct g as [|a [|b [|c g]]]; cbn; ring.
Qed.

Lemma size_of_list g : norm (vector_of g) = size [1; 1; 1] g.
Proof.
  unfold size, norm, dot, vector_of, at_. f_equal. destruct g as [|a [|b [|c g]]]; cbn; ring.
Qed.

Lemma three_positive : positive [1; 1; 1].
Proof. repeat constructor; lra. Qed.

Lemma space_obeys_is l d lambda c f : Rows.obeys l d 1 lambda (space_contact_row c) f ->
  obeys l lambda (screw_of d) c (space_force c f).
Proof.
  destruct f as [a g]. intros (L & C & S). rewrite space_v_is in L. rewrite space_slip_is in S.
  cbn [rho weights space_contact_row] in *.
  unfold obeys, space_force; cbn [fst snd].
  split; [exact L|]. split; [apply dot_across|]. split.
  - rewrite <- size_of_list in C. eapply Rle_trans; [apply norm_across|exact C].
  - intros NZ. apply norm_positive in NZ. rewrite <- size_is in NZ.
    pose proof (against_slip _ _ _ _ three_positive C S NZ) as G. rewrite size_is in G.
    set (s := slip c (screw_of d)) in *. set (k := friction c * length c * a / norm s) in *.
    pose proof (G [1]) as G1. pose proof (G [0; 1]) as G2. pose proof (G [0; 0; 1]) as G3.
    assert (E : vector_of g = scale (- k) s).
    { unfold vector_of, scale, at_. destruct g as [|g1 [|g2 [|g3 g]]]; cbn in *; f_equal; lra. }
    rewrite E. apply across_idle. unfold s. rewrite slip_across.
    transitivity (- k * dot (across (normal c) (moved c (screw_of d))) (normal c));
      [unfold dot, scale; cbn; ring|]. rewrite dot_across. ring.
Qed.

Lemma space_obeys_as_row l d lambda c f : obeys l lambda (screw_of d) c f ->
  Rows.obeys l d 1 lambda (space_contact_row c) (space_row_force f).
Proof.
  destruct f as [a f]. intros (L & _ & C & S). unfold space_row_force; cbn [fst snd Rows.obeys].
  rewrite space_v_is, space_slip_is. cbn [rho weights space_contact_row].
  rewrite !size_is. split; [exact L|]. split; [exact C|].
  rewrite product_three. change (vector_of (vector_list f)) with (Vector (x f) (y f) (z f)).
  set (s := slip c (screw_of d)) in *. pose proof (sqrt_pos (dot s s)) as NN. fold (norm s) in NN.
  assert (SQ : norm s * norm s = dot s s).
  { apply sqrt_sqrt. unfold dot. pose proof (Rle_0_sqr (x s)) as A. pose proof (Rle_0_sqr (y s)) as B.
    pose proof (Rle_0_sqr (z s)) as D. unfold Rsqr in *. lra. }
  destruct (Rle_lt_or_eq_dec 0 (norm s) NN) as [P|Z].
  - rewrite S by now apply norm_positive. set (m := friction c * length c * a).
    replace (dot (Vector (x (scale (- (m / norm s)) s)) (y (scale (- (m / norm s)) s))
                    (z (scale (- (m / norm s)) s))) s) with (- (m / norm s) * dot s s)
      by (unfold dot, scale; cbn; ring).
    rewrite <- SQ. field. lra.
  - rewrite <- Z in *. rewrite (no_length s) by lra. unfold dot, zero; cbn. ring.
Qed.

Lemma contact_work c a f d : dot f (normal c) = 0 ->
  work (contact_wrench c (a, f)) d = a * work (N c) d + dot f (slip c d).
Proof.
  intros Z. unfold slip.
  set (k := - (dot (normal c) (moved c d) / dot (normal c) (normal c))).
  unfold work, contact_wrench, N, force_at, moved, add, scale, dot, cross in *; cbn in *.
  assert (k * (x f * x (normal c) + y f * y (normal c) + z f * z (normal c)) = 0) by (rewrite Z; ring).
  lra.
Qed.

Lemma space_work_is c f d :
  Rows.work (space_contact_row c) f d = work (contact_wrench c (space_force c f)) (screw_of d).
Proof.
  destruct f as [a g]. unfold Rows.work. rewrite space_slip_is.
  cbn [fst snd Rows.N weights space_contact_row]. rewrite dot_screw, product_three.
  unfold space_force; cbn [fst snd]. rewrite contact_work by apply dot_across.
  rewrite slip_across, friction_across. reflexivity.
Qed.

Lemma space_works_are cs fs d :
  works (map space_contact_row cs) fs d =
  work (sum (contact_wrenches cs (map (fun cf => space_force (fst cf) (snd cf)) (combine cs fs)))) (screw_of d).
Proof.
  revert fs. induction cs as [|c cs IH]; intros [|f fs]; try (unfold work, dot; cbn; ring).
  cbn [map works combine]. rewrite IH, space_work_is.
  unfold sum, contact_wrenches, work, add_screw, add, dot; cbn. ring.
Qed.

Lemma space_load_is g l d :
  load (space_grasp_rows g) 1 l d = work (add_screw (wrench g) (scale_screw l (direction g))) (screw_of d).
Proof.
  unfold load, space_grasp_rows; cbn [Rows.wrench Rows.direction]. rewrite !dot_screw.
  unfold work, add_screw, scale_screw, add, scale, dot; cbn. ring.
Qed.

Theorem rows_of_space_equilibrium g lambda d fs : equilibrium g lambda d fs ->
  Rows.equilibrium (space_grasp_rows g) (screw_list d) 1 lambda (map space_row_force fs).
Proof.
  intros [O B]. split; [reflexivity|]. split.
  - cbn [rows normal space_grasp_rows]. clear B. induction O as [|c f cs fs Oc O IH]; cbn; constructor; auto.
    apply space_obeys_as_row. now rewrite screw_of_list.
  - intros e. rewrite space_load_is. cbn [rows space_grasp_rows]. rewrite space_works_are.
    assert (E : map (fun cf => space_force (fst cf) (snd cf)) (combine (contacts g) (map space_row_force fs)) = fs).
    { clear B. induction O as [|c [a f] cs fs Oc O IH]; cbn; [reflexivity|]. rewrite IH. f_equal.
      unfold space_force, space_row_force; cbn. f_equal.
      destruct Oc as (_ & Z & _). destruct f as [p q r]. exact (across_idle _ _ Z). }
    rewrite E. transitivity (work no_screw (screw_of e)); [|unfold work, dot; cbn; ring].
    rewrite <- B. unfold work, add_screw, add, dot; cbn. ring.
Qed.

Theorem space_equilibrium_of_rows g lambda d fs : Rows.equilibrium (space_grasp_rows g) d 1 lambda fs ->
  exists fs', equilibrium g lambda (screw_of d) fs'.
Proof.
  intros (_ & O & B). cbn [rows normal space_grasp_rows] in *.
  exists (map (fun cf => space_force (fst cf) (snd cf)) (combine (contacts g) fs)). split.
  - clear B. revert fs O. induction (contacts g) as [|c cs IH]; intros fs O; inversion O; subst; cbn;
      constructor; [now apply space_obeys_is|now apply IH].
  - assert (E : forall e, work (add_screw (add_screw (wrench g) (scale_screw lambda (direction g)))
        (sum (contact_wrenches (contacts g)
           (map (fun cf => space_force (fst cf) (snd cf)) (combine (contacts g) fs))))) (screw_of e) = 0).
    { intros e. specialize (B e). rewrite space_load_is, space_works_are in B. rewrite <- B.
      unfold work, add_screw, add, dot; cbn. ring. }
    pose proof (E [1]) as E1. pose proof (E [0; 1]) as E2. pose proof (E [0; 0; 1]) as E3.
    pose proof (E [0; 0; 0; 1]) as E4. pose proof (E [0; 0; 0; 0; 1]) as E5.
    pose proof (E [0; 0; 0; 0; 0; 1]) as E6.
    destruct (add_screw _ _) as [[a1 a2 a3] [a4 a5 a6]]. unfold work, screw_of, at_, dot in *; cbn in *.
    unfold no_screw, zero. f_equal; f_equal; lra.
Qed.

Theorem space_stable_as_rows (allowed : list R -> Prop) g lambda :
  stable_at (fun d => allowed (screw_list d)) g lambda <-> Rows.stable_at allowed (space_grasp_rows g) lambda.
Proof.
  split; intros (d & fs & A & E).
  - exists (screw_list d). eexists. split; [exact A|]. apply rows_of_space_equilibrium. exact E.
  - destruct (space_equilibrium_of_rows _ _ _ _ E) as (fs' & E'). exists (screw_of d), fs'. split; [|exact E'].
    destruct E as (L & _). destruct d as [|x [|y [|z [|p [|q [|r [|? ?]]]]]]]; try discriminate L. exact A.
Qed.

End Space.
