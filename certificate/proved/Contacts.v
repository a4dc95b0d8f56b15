(* SPDX-License-Identifier: MIT *)
(* The contacts of a question as boxes (FORMAT.md sections 1 and 6), in the plane and in space.
   `enlarge_plane`, `enlarge_space`: every choice of the question has its row in the box. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root Box RowsOfModels.
From Proved Require Rows Model SpaceModel.
Import ListNotations.

Module S := SpaceModel.

(* 1/L of a normal with L^2 = `square`: exactly, or between two neighbours of so many bits; checked rather than
   proved. *)
Definition is_enclosure (i : interval) (square : Q) : bool :=
  Qle_bool 0 (low i) && Qle_bool (low i * low i * square) 1 &&
  Qle_bool 0 (high i) && Qle_bool 1 (high i * high i * square).

Definition inverse_length (bits : Z) (loaded : bool) (square : Q) : option interval :=
  let i := if loaded then root_between bits (reduced (/ square)%Q) else exactly 1 in
  if negb loaded || is_enclosure i square then Some i else None.

Definition is_loaded (q : contact) : bool :=
  negb (Qeq_bool (high (preload q)) 0) || negb (Qeq_bool (preload_growth q) 0).

(* N = (n, p x n), T = (t, p x t) with t = (-n_y, n_x), for n = n0 + e t0. *)
Definition plane_forms (nx ny : Q) (geometry : list Q) : list (list Q) :=
  match geometry with
  | [x; y; e] =>
      let fx := (nx - e * ny)%Q in
      let fy := (ny + e * nx)%Q in
      [[fx; fy; (x * fy - y * fx)%Q]; [(- fy)%Q; fx; (x * fx + y * fy)%Q]]
  | _ => []
  end.

Definition at_point (x y z fx fy fz : Q) : list Q :=
  [fx; fy; fz; (y * fz - z * fy)%Q; (z * fx - x * fz)%Q; (x * fy - y * fx)%Q].

(* N, and the directions e - (e.n / n.n) n across n. *)
Definition space_forms (nx ny nz square : Q) (geometry : list Q) : list (list Q) :=
  match geometry with
  | [x; y; z; _; _] =>
      let across nj ex ey ez :=
        at_point x y z (ex - nj * nx / square)%Q (ey - nj * ny / square)%Q (ez - nj * nz / square)%Q in
      [at_point x y z nx ny nz; across nx 1 0 0; across ny 0 1 0; across nz 0 0 1]%Q
  | _ => []
  end.

Definition is_nonnegative (q : contact) : bool :=
  Qle_bool 0 (low (friction q)) && Qle_bool 0 (low (preload q)) && Qle_bool 0 (low (stiffness q)) &&
  Qle_bool 0 (slope q) && Qle_bool (slope q) 1.

(* P', what it grows by, and k'. *)
Definition numbers (bits : Z) (q : contact) (square : Q) : option (interval * interval * interval) :=
  match inverse_length bits (is_loaded q) square with
  | None => None
  | Some l =>
      let grows := negb (Qeq_bool (preload_growth q) 0) in
      let e2 := (slope q * slope q)%Q in
      if negb (Qle_bool square 0) && is_nonnegative q &&
         (negb grows || (certain (preload q) && Qeq_bool (slope q) 0))
      then Some (Interval (low (preload q) * (1 - e2 / (2#1)) * low l)%Q (high (preload q) * high l)%Q,
                 (if grows then Interval (preload_growth q * low l)%Q (preload_growth q * high l)%Q
                  else exactly 0),
                 Interval (low (stiffness q) * (1 - e2) / square)%Q (high (stiffness q) / square)%Q)
      else None
  end.

(* None if there is nothing here that this checker can judge. *)
Definition enlarge (bits : Z) (q : contact) : option cbox :=
  match position q, normal q with
  | [x; y], [nx; ny] =>
      match numbers bits q (nx * nx + ny * ny)%Q with
      | Some (p, u, k) =>
          Some (CBox [PX; PY; PTurn] [x; y; Interval (- slope q)%Q (slope q)] (plane_forms nx ny)
                  (friction q) p u k 1 [nx; ny] [1%Q] true false)
      | None => None
      end
  | [x; y; z], [nx; ny; nz] =>
      let square := (nx * nx + ny * ny + nz * nz)%Q in
      match numbers bits q square, Qeq_bool (slope q) 0 with
      | Some (p, u, k), true =>
          Some (CBox [PX; PY; PZ; PTurn; PTurnV] [x; y; z; exactly 0; exactly 0] (space_forms nx ny nz square)
                  (friction q) p u k square [nx; ny; nz] [1%Q; 1%Q; 1%Q] false false)
      | _, _ => None
      end
  | _, _ => None
  end.

Section Proofs.
Open Scope R_scope.

Lemma root_bounds_1 e : 0 < sqrt (1 + e * e) /\ sqrt (1 + e * e) * sqrt (1 + e * e) = 1 + e * e.
Proof. split; [apply sqrt_lt_R0; nra | apply sqrt_sqrt; nra]. Qed.

Lemma enclosure_R i square l : is_enclosure i square = true -> 0 < l -> l * l = Q2R square ->
  0 <= Q2R (low i) /\ Q2R (low i) * l <= 1 /\ 1 <= Q2R (high i) * l.
Proof.
  unfold is_enclosure. rewrite !andb_true_iff. intros [[[H0 H1] H2] H3] L S.
  apply Qle_bool_R in H0, H1, H2, H3. rewrite !Q2R_mult, Q2R_1 in *. rewrite Q2R_0 in *.
  rewrite <- S in *. split; [lra|].
  assert (0 <= Q2R (low i) * l) by (apply Rmult_le_pos; lra).
  assert (0 <= Q2R (high i) * l) by (apply Rmult_le_pos; lra).
  split; nra.
Qed.

(* Where a number is between two. *)
Lemma step_between low high x : low <= x <= high -> exists t, 0 <= t <= 1 /\ x = (1 - t) * low + t * high.
Proof.
  intros [L H]. destruct (Req_dec low high) as [E|E].
  - exists 0. split; lra.
  - exists ((x - low) / (high - low)). split; [|field; lra]. split.
    + apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
    + apply Rmult_le_reg_r with (high - low); [lra|]. field_simplify; lra.
Qed.

(* The numbers of a contact with a normal of the length |n0| sqrt (1 + e^2). *)
Lemma numbers_inside bits q square p u k l0 e P K : numbers bits q square = Some (p, u, k) ->
  0 <= l0 -> l0 * l0 = Q2R square -> e * e <= Q2R (slope q) * Q2R (slope q) ->
  within (preload q) P -> within (stiffness q) K ->
  let length := l0 * sqrt (1 + e * e) in
  0 < length /\ within k (K / (length * length)) /\
  exists t, 0 <= t <= 1 /\ P / length = (1 - t) * Q2R (low p) + t * Q2R (high p) /\
    Q2R (preload_growth q) / length = (1 - t) * Q2R (low u) + t * Q2R (high u).
Proof.
  intros H L00 L0E e2 Wp Wk. unfold numbers in H.
  destruct (inverse_length bits (is_loaded q) square) as [l|] eqn:IL; [|discriminate].
  destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <- <- <-.
  rewrite !andb_true_iff, negb_true_iff in C. destruct C as [[Sq NN] GC].
  unfold is_nonnegative in NN. rewrite !andb_true_iff in NN. destruct NN as [[[[F0 P0] K0] E0] E1].
  apply Qle_bool_R in F0, P0, K0, E0, E1. rewrite ?Q2R_0, ?Q2R_1 in *.
  assert (SqP : 0 < Q2R square).
  { apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle in L.
    apply Qle_bool_iff in L. congruence. }
  assert (L0 : 0 < l0) by nra.
  destruct (root_bounds_1 e) as [S0 SE]. set (s := sqrt (1 + e * e)) in *. cbv zeta.
  assert (s1 : 1 <= s) by nra.
  (* 1 - e^2/2 <= 1/s <= 1 *)
  assert (s2 : (1 - Q2R (slope q) * Q2R (slope q) / 2) * s <= 1).
  { assert ((1 - e * e / 2) * s <= 1); [|nra].
    assert (s <= 1 + e * e / 2) by nra. assert (0 <= e * e <= 1) by nra. nra. }
  assert (Pos : 0 < l0 * s) by nra. unfold within in *. split; [exact Pos|]. split.
  { cbn [low high]. rewrite !Q2R_div, Q2R_mult, Q2R_minus, Q2R_1, Q2R_mult
      by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
    replace (l0 * s * (l0 * s)) with (Q2R square * (1 + e * e)) by (rewrite <- L0E, <- SE; ring).
    set (E2 := Q2R (slope q) * Q2R (slope q)) in *.
    assert (D : 0 < 1 + e * e) by nra. assert (K0' : 0 <= K) by lra. split.
    - apply Rmult_le_reg_r with (Q2R square * (1 + e * e)); [nra|]. field_simplify; [|lra|lra].
      replace (- Q2R (low (stiffness q)) * E2 * e ^ 2 - Q2R (low (stiffness q)) * E2 +
               Q2R (low (stiffness q)) * e ^ 2 + Q2R (low (stiffness q)))
        with (Q2R (low (stiffness q)) * ((1 - E2) * (1 + e * e))) by ring.
      assert ((1 - E2) * (1 + e * e) <= 1) by nra. nra.
    - apply Rmult_le_reg_r with (Q2R square * (1 + e * e)); [nra|]. field_simplify; [|lra|lra].
      nra. }
  assert (En : is_loaded q = true -> is_enclosure l square = true).
  { intros Ld. unfold inverse_length in IL. rewrite Ld in IL. cbn in IL.
    destruct (is_enclosure _ square) eqn:En in IL; [|discriminate]. injection IL as <-. exact En. }
  destruct (Qeq_bool (preload_growth q) 0) eqn:G; cbn [negb orb low high exactly] in *.
  - apply Qeq_bool_eq, Qeq_eqR in G. rewrite Q2R_0 in G. rewrite G, Q2R_0.
    assert (PP : Q2R (low (preload q)) * (1 - Q2R (slope q) * Q2R (slope q) / 2) * Q2R (low l)
                 <= P / (l0 * s) <= Q2R (high (preload q)) * Q2R (high l)).
    { destruct (is_loaded q) eqn:Ld.
      - destruct (enclosure_R l square l0 (En eq_refl) L0 L0E) as (A & B & D).
        assert (X : P = P / (l0 * s) * (l0 * s)) by (field; lra).
        set (pq := P / (l0 * s)) in *. assert (P1 : 0 <= P) by lra.
        assert (0 <= pq) by (apply Rnot_lt_le; intros ?; nra).
        split.
        + apply Rmult_le_reg_r with (l0 * s); [exact Pos|]. rewrite <- X.
          apply Rle_trans with (Q2R (low (preload q))); [|lra].
          set (t := 1 - Q2R (slope q) * Q2R (slope q) / 2) in *.
          replace (Q2R (low (preload q)) * t * Q2R (low l) * (l0 * s))
            with (Q2R (low (preload q)) * ((Q2R (low l) * l0) * (t * s))) by ring.
          assert (0 <= Q2R (low l) * l0) by (apply Rmult_le_pos; lra).
          assert (t0 : 0 <= t) by (unfold t; nra).
          assert (0 <= t * s) by (apply Rmult_le_pos; lra).
          assert ((Q2R (low l) * l0) * (t * s) <= 1) by nra. nra.
        + apply Rmult_le_reg_r with (l0 * s); [exact Pos|]. rewrite <- X.
          assert (1 <= Q2R (high l) * (l0 * s)) by nra. nra.
      - unfold is_loaded in Ld.
        apply orb_false_iff in Ld as [Ld _]. apply negb_false_iff, Qeq_bool_eq, Qeq_eqR in Ld.
        rewrite Q2R_0 in Ld. assert (Z : P = 0) by lra.
        assert (Z' : Q2R (low (preload q)) = 0) by lra. rewrite Z, Z', Ld. unfold Rdiv. lra. }
    rewrite !Q2R_mult, Q2R_minus, Q2R_half, Q2R_mult, Q2R_1.
    destruct (step_between _ _ _ PP) as (t & T & E). exists t. split; [exact T|]. split; [exact E|].
    unfold Rdiv. ring.
  - apply andb_true_iff in GC as [PC SC]. apply Qeq_bool_eq, Qeq_eqR in SC. rewrite Q2R_0 in SC.
    rewrite SC in *. assert (e0 : e = 0).
    { apply Rsqr_0_uniq. pose proof (Rle_0_sqr e). unfold Rsqr in *. lra. }
    assert (S1 : s = 1).
    { unfold s. rewrite e0. replace (1 + 0 * 0) with 1 by ring. apply sqrt_1. }
    assert (Ld : is_loaded q = true) by (unfold is_loaded; rewrite G; apply orb_true_r).
    destruct (enclosure_R l square l0 (En Ld) L0 L0E) as (A & B & D).
    assert (CI : Q2R (low l) <= / l0 <= Q2R (high l)).
    { split; apply Rmult_le_reg_r with l0; try lra; rewrite Rinv_l by lra; lra. }
    destruct (step_between _ _ _ CI) as (t & T & E). exists t. split; [exact T|].
    assert (PE : P = Q2R (low (preload q)) /\ Q2R (high (preload q)) = Q2R (low (preload q))).
    { unfold certain in PC. apply Qeq_bool_eq, Qeq_eqR in PC. lra. }
    destruct PE as [PE PH]. rewrite S1, Rmult_1_r. unfold Rdiv. rewrite E.
    rewrite !Q2R_mult, Q2R_minus, Q2R_half, Q2R_mult, Q2R_1, SC, PH, PE. split; field.
Qed.

Ltac rationals := repeat rewrite ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp.

(* Lists that are equal if their elements are. *)
Ltac each :=
  match goal with
  | |- _ :: _ = _ :: _ => apply (f_equal2 cons); each
  | |- [] = [] => reflexivity
  | _ => idtac
  end.

Ltac find_affine :=
  match goal with |- affine ?F =>
    let a := eval cbv beta zeta in (F 0) in let b := eval cbv beta zeta in (F 1 - F 0) in
    exists a, b; intros; cbv beta zeta end.

(* A form of three or of six numbers, as a function of one of the parameters. *)
Lemma affine_dot (f : R -> list R) d n : (forall x, List.length (f x) = n) ->
  (forall k, affine (fun x => nth k (f x) 0)) -> affine (fun x => Rows.dot (f x) d).
Proof.
  revert f d. induction n as [|n IH]; intros f d L A.
  - exists 0, 0. intros x. specialize (L x). destruct (f x); [|discriminate]. destruct d; cbn; ring.
  - destruct d as [|y d].
    { exists 0, 0. intros x. destruct (f x); cbn; ring. }
    destruct (A O) as (a0 & b0 & E0). destruct (IH (fun x => tl (f x)) d) as (a1 & b1 & E1).
    + intros x. specialize (L x). destruct (f x); [discriminate|]. now injection L.
    + intros k. destruct (A (S k)) as (a & b & E). exists a, b. intros x. rewrite <- E.
      destruct (f x); [now destruct k|reflexivity].
    + exists (a0 * y + a1), (b0 * y + b1). intros x. specialize (E0 x). specialize (E1 x). specialize (L x).
      destruct (f x) as [|z fs]; [discriminate|]. cbn in *. rewrite E0, E1. ring.
Qed.

Definition plane_reals (nx ny : R) (p : list R) : list (list R) :=
  match p with
  | [x; y; e] =>
      let fx := nx - e * ny in
      let fy := ny + e * nx in
      [[fx; fy; x * fy - y * fx]; [- fy; fx; x * fx + y * fy]]
  | _ => []
  end.

Lemma plane_affine nx ny j d : multiaffine 3 (fun p => Rows.dot (nth j (plane_reals nx ny p) []) d).
Proof.
  assert (Two : forall f : R -> list (list R), (forall x, exists a b, f x = [a; b] /\ List.length a = 3%nat /\ List.length b = 3%nat) ->
    (forall j k, affine (fun x => nth k (nth j (f x) []) 0)) -> affine (fun x => Rows.dot (nth j (f x) []) d)).
  { intros f L A. destruct j as [|[|j]].
    - apply affine_dot with 3%nat; [|intros; apply (A 0%nat)]. intros x. destruct (L x) as (a & b & -> & La & _). exact La.
    - apply affine_dot with 3%nat; [|intros; apply (A 1%nat)]. intros x. destruct (L x) as (a & b & -> & _ & Lb). exact Lb.
    - exists 0, 0. intros x. destruct (L x) as (a & b & -> & _). cbn. destruct j; cbn; ring. }
  assert (Go : forall x y e, affine (fun x => Rows.dot (nth j (plane_reals nx ny [x; y; e]) []) d) /\
    affine (fun y => Rows.dot (nth j (plane_reals nx ny [x; y; e]) []) d) /\
    affine (fun e => Rows.dot (nth j (plane_reals nx ny [x; y; e]) []) d)).
  { intros x y e. repeat split; (apply Two; [intros; do 2 eexists; repeat split|]);
      intros [|[|j']] [|[|[|k]]]; cbn; find_affine; try ring; destruct k; ring. }
  split; [intros p L|intros x; split; [intros p L|intros y; split; [intros p L|intros e; exact Logic.I]]].
  - destruct p as [|y [|e [|? ?]]]; try discriminate. apply (Go 0 y e).
  - destruct p as [|e [|? ?]]; try discriminate. apply (Go x 0 e).
  - destruct p as [|? ?]; [|discriminate]. apply (Go x y 0).
Qed.

Theorem enlarge_plane bits q b c : enlarge bits q = Some b -> chosen_contact q c -> inside b (contact_row c).
Proof.
  unfold enlarge. intros H ((x & y & nx & ny & e & EP & Wx & Wy & EN & We & Hx & Hy) & Wf & Wk & Wp & G).
  rewrite EP, EN in H. set (square := (nx * nx + ny * ny)%Q) in *.
  destruct (numbers bits q square) as [[[p u] k]|] eqn:Nu; [|discriminate]. injection H as <-.
  assert (e2 : e * e <= Q2R (slope q) * Q2R (slope q)) by nra.
  assert (SqE : Q2R square = Q2R nx * Q2R nx + Q2R ny * Q2R ny)
    by (unfold square; now rewrite Q2R_plus, !Q2R_mult).
  assert (Sq0 : 0 <= Q2R square) by (rewrite SqE; nra).
  destruct (numbers_inside bits q square p u k (sqrt (Q2R square)) e _ _ Nu (sqrt_pos _) (sqrt_sqrt _ Sq0) e2 Wp Wk)
    as (L & K & t & T & EPr & EG).
  assert (LE : sqrt (Q2R square) * sqrt (1 + e * e) = Model.length c).
  { unfold Model.length. rewrite Hx, Hy, <- sqrt_mult by nra. f_equal. rewrite SqE. ring. }
  rewrite LE in *.
  assert (F0 : 0 <= Model.friction c).
  { unfold numbers in Nu. destruct (inverse_length _ _ _); [|discriminate].
    destruct (_ && _) eqn:C in Nu; [|discriminate]. rewrite !andb_true_iff in C.
    unfold is_nonnegative in C. rewrite !andb_true_iff in C. destruct C as [[_ [[[[F0 _] _] _] _]] _].
    apply Qle_bool_R in F0. rewrite Q2R_0 in F0. destruct Wf. lra. }
  exists [Model.px c; Model.py c; e], (plane_reals (Q2R nx) (Q2R ny)), (Model.friction c), t.
  constructor; cbn [box_geometry box_forms box_friction box_square box_weights box_preload box_growth
    box_stiffness box_spring box_signed contact_row Rows.N Rows.slips Rows.rho Rows.weights Rows.preload
    Rows.growth Rows.stiffness Rows.spring]; try assumption; try discriminate.
  - constructor; [exact Wx|]. constructor; [exact Wy|]. constructor; [|constructor].
    unfold within. cbn [low high]. rewrite Q2R_opp. exact We.
  - unfold plane_reals, motion_list, Model.N, Model.T, Model.force_at; cbn. rewrite Hx, Hy.
    each; ring.
  - intros qs. destruct qs as [|x' [|y' [|e' [|? ?]]]]; try reflexivity.
    cbn. rationals. each; ring.
  - intros j d. apply plane_affine.
  - intros [|? [|? [|? [|? ?]]]] [|? [|? [|? [|? ?]]]] P P'; try discriminate P; try discriminate P'; reflexivity.
  - rewrite Q2R_1, sqrt_1. ring.
  - rewrite Q2R_1. lra.
  - cbn. now rewrite Q2R_1.
  - repeat constructor. lra.
  - now rewrite G.
  - reflexivity.
  - intros _. split; [right; now exists (motion_list (Model.T c))|]. split; [reflexivity|apply Q2R_1].
Qed.

Definition at_point_reals (x y z fx fy fz : R) : list R :=
  [fx; fy; fz; y * fz - z * fy; z * fx - x * fz; x * fy - y * fx].

Definition space_reals (nx ny nz square : R) (p : list R) : list (list R) :=
  match p with
  | [x; y; z; _; _] =>
      let across nj ex ey ez :=
        at_point_reals x y z (ex - nj * nx / square) (ey - nj * ny / square) (ez - nj * nz / square) in
      [at_point_reals x y z nx ny nz; across nx 1 0 0; across ny 0 1 0; across nz 0 0 1]
  | _ => []
  end.

Lemma at_point_affine fx fy fz d :
  (forall y z, affine (fun x => Rows.dot (at_point_reals x y z fx fy fz) d)) /\
  (forall x z, affine (fun y => Rows.dot (at_point_reals x y z fx fy fz) d)) /\
  (forall x y, affine (fun z => Rows.dot (at_point_reals x y z fx fy fz) d)).
Proof.
  repeat split; intros; apply affine_dot with 6%nat; try reflexivity;
    intros [|[|[|[|[|[|k]]]]]]; cbn; find_affine; try ring; destruct k; ring.
Qed.

Lemma space_affine nx ny nz square j d : multiaffine 5 (fun p => Rows.dot (nth j (space_reals nx ny nz square p) []) d).
Proof.
  assert (Nil : forall f : R -> list R, (forall x, f x = []) -> affine (fun x => Rows.dot (f x) d))
    by (intros f E; exists 0, 0; intros x; rewrite E; cbn; ring).
  assert (Const : forall a, affine (fun _ => a)) by (intros a; exists a, 0; intros; ring).
  assert (Go : forall x y z u v, affine (fun x => Rows.dot (nth j (space_reals nx ny nz square [x; y; z; u; v]) []) d) /\
    affine (fun y => Rows.dot (nth j (space_reals nx ny nz square [x; y; z; u; v]) []) d) /\
    affine (fun z => Rows.dot (nth j (space_reals nx ny nz square [x; y; z; u; v]) []) d)).
  { intros x y z u v. cbn [space_reals].
    destruct j as [|[|[|[|j]]]]; cbn [nth]; try (repeat split; apply at_point_affine).
    repeat split; apply Nil; intros; destruct j; reflexivity. }
  split; [intros p L|intros x; split; [intros p L|intros y; split; [intros p L|intros z; split;
    [intros p L|intros u; split; [intros p L|intros v; exact Logic.I]]]]].
  - destruct p as [|y [|z [|u [|v [|? ?]]]]]; try discriminate. apply (Go 0 y z u v).
  - destruct p as [|z [|u [|v [|? ?]]]]; try discriminate. apply (Go x 0 z u v).
  - destruct p as [|u [|v [|? ?]]]; try discriminate. apply (Go x y 0 u v).
  - destruct p as [|v [|? ?]]; try discriminate. apply (Const (Rows.dot (nth j (space_reals nx ny nz square [x; y; z; 0; v]) []) d)).
  - destruct p as [|? ?]; [|discriminate].
    apply (Const (Rows.dot (nth j (space_reals nx ny nz square [x; y; z; u; 0]) []) d)).
Qed.

Theorem enlarge_space bits q b c : enlarge bits q = Some b -> chosen_contact_in_space q c ->
  inside b (space_contact_row c).
Proof.
  unfold enlarge. intros H ((x & y & z & nx & ny & nz & t & EP & EN & Wx & Wy & Wz & _ & TT & NT)
                            & Wf & Wk & Wp & G).
  rewrite EP, EN in H. set (square := (nx * nx + ny * ny + nz * nz)%Q) in *.
  destruct (numbers bits q square) as [[[p u] k]|] eqn:Nu; [|discriminate].
  destruct (Qeq_bool (slope q) 0) eqn:SC; [|discriminate]. injection H as <-.
  apply Qeq_bool_eq, Qeq_eqR in SC. rewrite Q2R_0 in SC.
  assert (NE : S.normal c = vector_of_three nx ny nz).
  { rewrite NT. rewrite SC, !Rmult_0_l in TT. assert (Z : S.dot t t = 0).
    { apply Rle_antisym; [exact TT|]. unfold S.dot. pose proof (Rle_0_sqr (S.x t)) as A.
      pose proof (Rle_0_sqr (S.y t)) as B. pose proof (Rle_0_sqr (S.z t)) as C. unfold Rsqr in *. lra. }
    rewrite (no_length t Z). unfold S.add, vector_of_three, S.zero; cbn. now rewrite !Rplus_0_r. }
  assert (SqE : Q2R square = S.dot (S.normal c) (S.normal c)).
  { rewrite NE. unfold square, S.dot, vector_of_three; cbn. now rewrite !Q2R_plus, !Q2R_mult. }
  assert (Sq0 : 0 <= Q2R square).
  { rewrite SqE. unfold S.dot. pose proof (Rle_0_sqr (S.x (S.normal c))) as A.
    pose proof (Rle_0_sqr (S.y (S.normal c))) as B. pose proof (Rle_0_sqr (S.z (S.normal c))) as C.
    unfold Rsqr in *. lra. }
  assert (e2 : 0 * 0 <= Q2R (slope q) * Q2R (slope q)) by (rewrite SC; lra).
  destruct (numbers_inside bits q square p u k (sqrt (Q2R square)) 0 _ _ Nu (sqrt_pos _) (sqrt_sqrt _ Sq0) e2 Wp Wk)
    as (L & K & st & T & EPr & EG).
  assert (LE : sqrt (Q2R square) * sqrt (1 + 0 * 0) = S.length c).
  { replace (1 + 0 * 0) with 1 by ring. rewrite sqrt_1, Rmult_1_r, SqE. reflexivity. }
  rewrite LE in *.
  assert (SqP : 0 < Q2R square).
  { destruct (Rle_lt_or_eq_dec _ _ Sq0) as [P|P]; [exact P|]. rewrite <- P, sqrt_0 in LE. lra. }
  assert (NZ : ~ (square == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
  assert (F0 : 0 <= S.friction c).
  { unfold numbers in Nu. destruct (inverse_length _ _ _); [|discriminate].
    destruct (_ && _) eqn:C in Nu; [|discriminate]. rewrite !andb_true_iff in C.
    unfold is_nonnegative in C. rewrite !andb_true_iff in C. destruct C as [[_ [[[[F0 _] _] _] _]] _].
    apply Qle_bool_R in F0. rewrite Q2R_0 in F0. destruct Wf. lra. }
  assert (Z0 : within (exactly 0) 0) by (unfold within, exactly; cbn; rewrite Q2R_0; lra).
  exists [S.x (S.position c); S.y (S.position c); S.z (S.position c); 0; 0],
    (space_reals (Q2R nx) (Q2R ny) (Q2R nz) (Q2R square)), (S.friction c), st.
  constructor; cbn [box_geometry box_forms box_friction box_square box_weights box_preload box_growth
    box_stiffness box_spring box_signed space_contact_row Rows.N Rows.slips Rows.rho Rows.weights Rows.preload
    Rows.growth Rows.stiffness Rows.spring]; try assumption; try discriminate.
  - constructor; [exact Wx|]. constructor; [exact Wy|]. constructor; [exact Wz|].
    constructor; [exact Z0|]. constructor; [exact Z0|constructor].
  - unfold slip_rows, space_reals, at_point_reals, screw_list, S.N, S.force_at, across, S.cross, S.add, S.scale.
    cbn [map]. rewrite SqE, NE. unfold S.dot, vector_of_three; cbn [S.x S.y S.z S.linear S.angular].
    each; unfold Rdiv; ring.
  - intros qs. destruct qs as [|x' [|y' [|z' [|u' [|v' [|? ?]]]]]]; try reflexivity.
    cbn [space_reals space_forms map at_point at_point_reals]. unfold at_point, at_point_reals.
    cbn [map]. rationals. rewrite !Q2R_div by exact NZ. rationals. rewrite Q2R_1, Q2R_0. reflexivity.
  - intros j d. apply space_affine.
  - intros [|? [|? [|? [|? [|? [|? ?]]]]]] [|? [|? [|? [|? [|? [|? ?]]]]]] P P'; try discriminate P; try discriminate P';
      reflexivity.
  - rewrite <- LE. replace (1 + 0 * 0) with 1 by ring. rewrite sqrt_1. ring.
  - cbn. now rewrite Q2R_1.
  - apply three_positive.
  - now rewrite G.
  - reflexivity.
  - intros _. reflexivity.
Qed.

End Proofs.
