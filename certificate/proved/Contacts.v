(* SPDX-License-Identifier: MIT *)
(* The contacts of a question as boxes (FORMAT.md sections 1 and 6), in the plane and in space.
   `enlarge_plane`: every choice of the question has its row in the box; `enlarge_space`: or is seen in it. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root Box Slips Leaf RowsOfModels RowLimits Turned Ways.
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

(* The turns of a normal n0 in space (FORMAT.md section 6): U, across it and the coordinate in which it is least, and
   V = n0 x U. *)
Definition first_turn (nx ny nz : Q) : Q * Q * Q :=
  let x2 := (nx * nx)%Q in
  let y2 := (ny * ny)%Q in
  let z2 := (nz * nz)%Q in
  if Qle_bool x2 y2 && Qle_bool x2 z2 then (0, nz, - ny)%Q
  else if Qle_bool y2 z2 then (- nz, 0, nx)%Q else (ny, - nx, 0)%Q.

Definition cross_q (a b : Q * Q * Q) : Q * Q * Q :=
  let '(a1, a2, a3) := a in
  let '(b1, b2, b3) := b in
  (a2 * b3 - a3 * b2, a3 * b1 - a1 * b3, a1 * b2 - a2 * b1)%Q.

Definition square_of (a : Q * Q * Q) : Q := let '(a1, a2, a3) := a in (a1 * a1 + a2 * a2 + a3 * a3)%Q.

(* N of n = n0 + e U + f V, and the directions e_j - (n_j / n0.n0) n0. *)
Definition space_forms (n0 turn_u turn_v : Q * Q * Q) (square : Q) (geometry : list Q) : list (list Q) :=
  match geometry, n0, turn_u, turn_v with
  | [x; y; z; e; f], (nx, ny, nz), (ux, uy, uz), (vx, vy, vz) =>
      let tx := (nx + e * ux + f * vx)%Q in
      let ty := (ny + e * uy + f * vy)%Q in
      let tz := (nz + e * uz + f * vz)%Q in
      let across nj ex ey ez :=
        at_point x y z (ex - nj * nx / square)%Q (ey - nj * ny / square)%Q (ez - nj * nz / square)%Q in
      [at_point x y z tx ty tz; across tx 1 0 0; across ty 0 1 0; across tz 0 0 1]%Q
  | _, _, _, _ => []
  end.

Definition greatest_square (i : interval) : Q :=
  let a := (low i * low i)%Q in
  let b := (high i * high i)%Q in
  if Qle_bool a b then b else a.

(* |n|^2 / |n0|^2 - 1 at the worst corner. *)
Definition turned_slack (u_square square : Q) (geometry : list interval) : Q :=
  match geometry with
  | [_; _; _; e; f] => (u_square * (greatest_square e + square * greatest_square f) / square)%Q
  | _ => 0%Q
  end.

Definition turn_within (q : Q) : interval := let b := root_above q in Interval (- b)%Q b.

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
                  (friction q) p u k 1 [nx; ny] [1%Q] true false false (fun _ => 0%Q))
      | None => None
      end
  | [x; y; z], [nx; ny; nz] =>
      let n0 := (nx, ny, nz) in
      let square := square_of n0 in
      let turn_u := first_turn nx ny nz in
      let turn_v := cross_q n0 turn_u in
      let u_square := square_of turn_u in
      let e2 := (slope q * slope q)%Q in
      let turns := negb (Qeq_bool (slope q) 0) in
      match numbers bits q square with
      | Some (p, u, k) =>
          if turns && Qle_bool u_square 0 then None
          else
            Some (CBox [PX; PY; PZ; PTurn; PTurnV]
                    [x; y; z; (if turns then turn_within (e2 * square / u_square) else exactly 0);
                     (if turns then turn_within (e2 / u_square) else exactly 0)]
                    (space_forms n0 turn_u turn_v square) (friction q) p u k square [nx; ny; nz]
                    [1%Q; 1%Q; 1%Q] false false turns
                    (if turns then turned_slack u_square square else fun _ => 0%Q))
      | None => None
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
  - intros is. cbn. rewrite Q2R_0. lra.
  - intros _. reflexivity.
  - intros _. split; [right; now exists (motion_list (Model.T c))|]. split; [reflexivity|apply Q2R_1].
Qed.

Definition triple := (R * R * R)%type.

Definition at_point_reals (x y z fx fy fz : R) : list R :=
  [fx; fy; fz; y * fz - z * fy; z * fx - x * fz; x * fy - y * fx].

Definition space_reals (n0 turn_u turn_v : triple) (square : R) (p : list R) : list (list R) :=
  match p, n0, turn_u, turn_v with
  | [x; y; z; e; f], (nx, ny, nz), (ux, uy, uz), (vx, vy, vz) =>
      let tx := nx + e * ux + f * vx in
      let ty := ny + e * uy + f * vy in
      let tz := nz + e * uz + f * vz in
      let across nj ex ey ez :=
        at_point_reals x y z (ex - nj * nx / square) (ey - nj * ny / square) (ez - nj * nz / square) in
      [at_point_reals x y z tx ty tz; across tx 1 0 0; across ty 0 1 0; across tz 0 0 1]
  | _, _, _, _ => []
  end.

Lemma space_affine n0 tu tv square j d :
  multiaffine 5 (fun p => Rows.dot (nth j (space_reals n0 tu tv square p) []) d).
Proof.
  destruct n0 as [[nx ny] nz], tu as [[ux uy] uz], tv as [[vx vy] vz].
  set (F := space_reals (nx, ny, nz) (ux, uy, uz) (vx, vy, vz) square).
  assert (One : forall f : R -> list (list R), (forall x, exists a b c e, f x = [a; b; c; e] /\
      List.length a = 6%nat /\ List.length b = 6%nat /\ List.length c = 6%nat /\ List.length e = 6%nat) ->
    (forall j k, affine (fun x => nth k (nth j (f x) []) 0)) -> affine (fun x => Rows.dot (nth j (f x) []) d)).
  { intros f L A. destruct j as [|[|[|[|j]]]].
    1, 2, 3, 4: apply affine_dot with 6%nat; [intros x; destruct (L x) as (a & b & c & e & -> & La & Lb & Lc & Le); assumption|].
    - apply (A 0%nat). - apply (A 1%nat). - apply (A 2%nat). - apply (A 3%nat).
    - exists 0, 0. intros x. destruct (L x) as (a & b & c & e & -> & _). cbn. destruct j; cbn; ring. }
  assert (Go : forall x y z e f, affine (fun x => Rows.dot (nth j (F [x; y; z; e; f]) []) d) /\
    affine (fun y => Rows.dot (nth j (F [x; y; z; e; f]) []) d) /\
    affine (fun z => Rows.dot (nth j (F [x; y; z; e; f]) []) d) /\
    affine (fun e => Rows.dot (nth j (F [x; y; z; e; f]) []) d) /\
    affine (fun f => Rows.dot (nth j (F [x; y; z; e; f]) []) d)).
  { intros x y z e f. repeat split; (apply One; [intros; do 4 eexists; repeat split|]);
      intros [|[|[|[|j']]]] [|[|[|[|[|[|k]]]]]]; cbn; find_affine; unfold Rdiv; try ring; destruct k; ring. }
  split; [intros p L|intros x; split; [intros p L|intros y; split; [intros p L|intros z; split;
    [intros p L|intros e; split; [intros p L|intros f; exact Logic.I]]]]].
  - destruct p as [|y [|z [|e [|f [|? ?]]]]]; try discriminate. apply (Go 0 y z e f).
  - destruct p as [|z [|e [|f [|? ?]]]]; try discriminate. apply (Go x 0 z e f).
  - destruct p as [|e [|f [|? ?]]]; try discriminate. apply (Go x y 0 e f).
  - destruct p as [|f [|? ?]]; try discriminate. apply (Go x y z 0 f).
  - destruct p as [|? ?]; [|discriminate]. apply (Go x y z e 0).
Qed.

Definition real_triple (q : Q * Q * Q) : triple := let '(a, b, c) := q in (Q2R a, Q2R b, Q2R c).

Lemma space_rational n0 tu tv square : ~ (square == 0)%Q -> forall qs,
  space_reals (real_triple n0) (real_triple tu) (real_triple tv) (Q2R square) (map Q2R qs) =
  map (map Q2R) (space_forms n0 tu tv square qs).
Proof.
  intros NZ qs. destruct n0 as [[nx ny] nz], tu as [[ux uy] uz], tv as [[vx vy] vz].
  destruct qs as [|x' [|y' [|z' [|e' [|f' [|? ?]]]]]]; try reflexivity.
  cbn [real_triple space_reals space_forms map]. unfold at_point, at_point_reals. cbn [map].
  rationals. rewrite !Q2R_div by exact NZ. rationals. rewrite Q2R_1, Q2R_0. reflexivity.
Qed.

Lemma space_shape n0 tu tv square p p' : List.length p = 5%nat -> List.length p' = 5%nat ->
  map (@List.length R) (space_reals n0 tu tv square p) = map (@List.length R) (space_reals n0 tu tv square p').
Proof.
  intros P P'. destruct n0 as [[nx ny] nz], tu as [[ux uy] uz], tv as [[vx vy] vz].
  destruct p as [|? [|? [|? [|? [|? [|? ?]]]]]]; try discriminate P.
  destruct p' as [|? [|? [|? [|? [|? [|? ?]]]]]]; try discriminate P'. reflexivity.
Qed.

Lemma first_turn_is nx ny nz : first_turn nx ny nz = (0, nz, - ny)%Q \/
  first_turn nx ny nz = (- nz, 0, nx)%Q \/ first_turn nx ny nz = (ny, - nx, 0)%Q.
Proof. unfold first_turn. destruct (_ && _); [auto|]. destruct (Qle_bool _ _); auto. Qed.

(* A vector across n0, by U and V. *)
Lemma turn_parts a1 a2 a3 u1 u2 u3 m1 m2 m3 :
  (u1, u2, u3) = (0, a3, - a2) \/ (u1, u2, u3) = (- a3, 0, a1) \/ (u1, u2, u3) = (a2, - a1, 0) ->
  let aa := a1 * a1 + a2 * a2 + a3 * a3 in
  let uu := u1 * u1 + u2 * u2 + u3 * u3 in
  let v1 := a2 * u3 - a3 * u2 in
  let v2 := a3 * u1 - a1 * u3 in
  let v3 := a1 * u2 - a2 * u1 in
  0 < aa -> 0 < uu -> a1 * m1 + a2 * m2 + a3 * m3 = 0 ->
  let e := (m1 * u1 + m2 * u2 + m3 * u3) / uu in
  let f := (m1 * v1 + m2 * v2 + m3 * v3) / (aa * uu) in
  m1 = e * u1 + f * v1 /\ m2 = e * u2 + f * v2 /\ m3 = e * u3 + f * v3 /\
  m1 * m1 + m2 * m2 + m3 * m3 = uu * (e * e + aa * (f * f)).
Proof.
  intros U aa uu v1 v2 v3 A UU Flat e f.
  assert (P : 0 < aa * uu) by now apply Rmult_lt_0_compat.
  assert (E : forall m v u a, aa * uu * m = uu * (a1 * m1 + a2 * m2 + a3 * m3) * a +
      aa * (m1 * u1 + m2 * u2 + m3 * u3) * u + (m1 * v1 + m2 * v2 + m3 * v3) * v -> m = e * u + f * v).
  { intros m v u a H. rewrite Flat in H. apply Rmult_eq_reg_l with (aa * uu); [|lra]. rewrite H.
    unfold e, f. field. lra. }
  assert (M1 : m1 = e * u1 + f * v1).
  { apply E with a1. destruct U as [U|[U|U]]; injection U as -> -> ->; unfold aa, uu, v1, v2, v3; ring. }
  assert (M2 : m2 = e * u2 + f * v2).
  { apply E with a2. destruct U as [U|[U|U]]; injection U as -> -> ->; unfold aa, uu, v1, v2, v3; ring. }
  assert (M3 : m3 = e * u3 + f * v3).
  { apply E with a3. destruct U as [U|[U|U]]; injection U as -> -> ->; unfold aa, uu, v1, v2, v3; ring. }
  repeat split; try assumption. clearbody e f. rewrite M1, M2, M3.
  destruct U as [U|[U|U]]; injection U as -> -> ->; unfold aa, uu, v1, v2, v3; ring.
Qed.

Lemma within_turn q e : 0 <= Q2R q -> e * e <= Q2R q -> within (turn_within q) e.
Proof.
  intros Q0 E. pose proof (root_above_is q Q0) as R. unfold within, turn_within. cbn [low high]. rewrite Q2R_opp.
  assert (A : Rabs e <= sqrt (Q2R q)).
  { rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. exact E. }
  pose proof (Rle_abs e). pose proof (Rle_abs (- e)) as N. rewrite Rabs_Ropp in N. lra.
Qed.

Lemma greatest_square_nonneg i : 0 <= Q2R (greatest_square i).
Proof.
  unfold greatest_square. cbv zeta. set (a := low i). set (b := high i). clearbody a b.
  destruct (Qle_bool (a * a) (b * b)); rewrite Q2R_mult; apply Rle_0_sqr.
Qed.

Lemma greatest_square_above i e : within i e -> e * e <= Q2R (greatest_square i).
Proof.
  intros [L H]. unfold greatest_square. cbv zeta.
  assert (S : e * e <= Q2R (low i) * Q2R (low i) \/ e * e <= Q2R (high i) * Q2R (high i)).
  { destruct (Rle_dec 0 e); [right|left]; nra. }
  destruct (Qle_bool _ _) eqn:C.
  - apply Qle_bool_R in C. rewrite !Q2R_mult in *. destruct S; lra.
  - assert (Q2R (high i * high i) <= Q2R (low i * low i)).
    { apply Rnot_lt_le. intros Lt. apply Rlt_le, Rle_Qle, Qle_bool_iff in Lt. congruence. }
    rewrite !Q2R_mult in *. destruct S; lra.
Qed.

Lemma turned_is_row n0 c : S.normal c = n0 -> turned_row n0 c = space_contact_row c.
Proof.
  intros E. unfold turned_row, space_contact_row, seen_rows, slip_rows, across. cbn [map]. rewrite E.
  assert (D : forall e nj, S.dot e n0 = nj -> nj = S.dot e n0) by (intros; congruence).
  f_equal.
  - unfold S.add, S.scale, S.dot, screw_list, S.force_at, S.cross; cbn. each; unfold Rdiv; ring.
  - unfold S.length. now rewrite E.
Qed.

(* ---- A contact in space as its geometry changes ---- *)

Section Turning.

Variables a1 a2 a3 u1 u2 u3 : R.
Let n0 := S.Vector a1 a2 a3.
Let U := S.Vector u1 u2 u3.
Let V := S.cross n0 U.
Let aa := S.dot n0 n0.
Let uu := S.dot U U.
Hypothesis cases : (u1, u2, u3) = (0, a3, - a2) \/ (u1, u2, u3) = (- a3, 0, a1) \/ (u1, u2, u3) = (a2, - a1, 0).
Hypothesis long : 0 < aa.

(* Where it is, and its normal, by its geometry: x, y, z, e and f. *)
Definition place_at (p : list R) : S.vector :=
  match p with [x; y; z; _; _] => S.Vector x y z | _ => S.zero end.

Definition turn_at (p : list R) : S.vector :=
  match p with [_; _; _; e; f] => S.add (S.scale e U) (S.scale f V) | _ => S.zero end.

Definition normal_at (p : list R) : S.vector := S.add n0 (turn_at p).

(* The forms of the row that is seen along n0. *)
Lemma seen_forms c p : List.length p = 5%nat -> S.position c = place_at p -> S.normal c = normal_at p ->
  screw_list (S.N c) :: seen_rows n0 c =
  space_reals (a1, a2, a3) (u1, u2, u3) (S.x V, S.y V, S.z V) aa p.
Proof.
  intros L Ep En. destruct p as [|x [|y [|z [|e [|f [|? ?]]]]]]; try discriminate L.
  unfold seen_rows, S.N, aa. rewrite Ep, En. set (q := S.dot n0 n0). unfold normal_at.
  cbn [place_at turn_at space_reals map]. unfold V, U, n0, at_point_reals, screw_list, S.force_at, S.cross, S.add, S.scale.
  cbn [S.x S.y S.z S.linear S.angular]. each; unfold Rdiv; ring.
Qed.

Lemma turn_is_flat p : S.dot n0 (turn_at p) = 0.
Proof.
  assert (Z : S.dot n0 S.zero = 0) by (unfold S.dot, S.zero; cbn; ring).
  destruct p as [|x [|y [|z [|e [|f [|? ?]]]]]]; try exact Z. cbn [turn_at]. unfold V, U, n0.
  destruct cases as [E|[E|E]]; injection E as -> -> ->; unfold S.dot, S.add, S.scale, S.cross; cbn; ring.
Qed.

Lemma turn_length x y z e f : S.dot (turn_at [x; y; z; e; f]) (turn_at [x; y; z; e; f]) = uu * (e * e + aa * (f * f)).
Proof.
  cbn [turn_at]. unfold uu, aa, V, U, n0.
  destruct cases as [E|[E|E]]; injection E as -> -> ->; unfold S.dot, S.add, S.scale, S.cross; cbn; ring.
Qed.

Lemma normal_long p : 0 < S.dot (normal_at p) (normal_at p).
Proof.
  assert (E : S.dot (normal_at p) (normal_at p) = aa + 2 * S.dot n0 (turn_at p) + S.dot (turn_at p) (turn_at p))
    by (unfold aa, normal_at, S.dot, S.add; cbn; ring).
  rewrite E, turn_is_flat. pose proof (dot_nonneg (turn_at p)). lra.
Qed.

Lemma geometry_continuous ps p : List.length p = 5%nat -> cv_list ps p ->
  cv_vector (fun i => place_at (ps i)) (place_at p) /\ cv_vector (fun i => normal_at (ps i)) (normal_at p).
Proof.
  intros L C. destruct C as [|s0 x ss xs C0 C]; [discriminate|]. destruct C as [|s1 y ss xs C1 C]; [discriminate|].
  destruct C as [|s2 z ss xs C2 C]; [discriminate|]. destruct C as [|s3 e ss xs C3 C]; [discriminate|].
  destruct C as [|s4 f ss xs C4 C]; [discriminate|]. destruct C; [|discriminate].
  unfold normal_at, cv_vector; cbn [place_at turn_at S.add S.scale S.x S.y S.z]. repeat split; converge.
Qed.

(* In a box with these forms rows stand for the contact's own. *)
Lemma turned_seen_as b u_square square : box_turns b = true -> Q2R square = aa -> Q2R u_square = uu -> 0 < uu ->
  List.length (box_geometry b) = 5%nat -> box_weights b = [1%Q; 1%Q; 1%Q] -> box_spring b = false ->
  box_square b = square -> box_slack b = turned_slack u_square square ->
  seen_as b (space_reals (a1, a2, a3) (u1, u2, u3) (S.x V, S.y V, S.z V) aa)
    (fun p => own_forms (place_at p) (normal_at p)) (fun p => S.norm (normal_at p))
    (fun p => S.dot (turn_at p) (turn_at p) / aa).
Proof.
  intros T Sq Uq UP L W Sp Bs Sl.
  assert (W' : map Q2R (box_weights b) = [1; 1; 1]) by (rewrite W; cbn; now rewrite Q2R_1).
  constructor; rewrite ?L.
  - intros q mu p u k Lq Mu. set (c := contact_with (place_at q) (normal_at q) mu p u k).
    pose proof (contact_with_row (place_at q) (normal_at q) mu p u k (normal_long q)) as E. fold c in E.
    unfold row_of at 1. rewrite W', Sp, <- E.
    assert (E' : row_of b (space_reals (a1, a2, a3) (u1, u2, u3) (S.x V, S.y V, S.z V) aa q)
        (mu * sqrt (Q2R (box_square b))) p u k = turned_row n0 c).
    { rewrite <- (seen_forms c q Lq eq_refl eq_refl). unfold row_of, turned_row. rewrite W', Sp, Bs, Sq. cbn [hd tl].
      assert (N0 : 0 < S.norm (normal_at q)) by (apply sqrt_lt_R0, normal_long).
      unfold c, contact_with, S.length. cbn [S.normal S.friction S.preload S.growth S.stiffness].
      f_equal; field; lra. }
    rewrite E'. unfold aa. apply (turned_stands c n0 (turn_at q)); [reflexivity|apply turn_is_flat|exact long|exact Mu].
  - intros q. apply norm_nonneg.
  - intros is q Wi Lq. rewrite Sl.
    inversion Wi as [|? x ? q1 _ W1]; subst; [discriminate|]. inversion W1 as [|? y ? q2 _ W2]; subst; [discriminate|].
    inversion W2 as [|? z ? q3 _ W3]; subst; [discriminate|]. inversion W3 as [|i1 e ? q4 H1 W4]; subst; [discriminate|].
    inversion W4 as [|i2 f ? q5 H2 W5]; subst; [discriminate|]. inversion W5; subst; [|discriminate].
    cbn [turned_slack]. rewrite turn_length, Q2R_div, Q2R_mult, Q2R_plus, Q2R_mult, Uq, Sq
      by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
    apply greatest_square_above in H1, H2.
    unfold Rdiv. apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|]. apply Rmult_le_compat_l; [lra|].
    apply Rplus_le_compat; [exact H1|]. apply Rmult_le_compat_l; lra.
  - intros qs q Lq C. destruct (geometry_continuous qs q Lq C) as [P N].
    apply turning_continuous; [apply normal_long|exact P|exact N].
  - intros T'. congruence.
Qed.

End Turning.

Theorem enlarge_space bits q b c : enlarge bits q = Some b -> chosen_contact_in_space q c ->
  seen_in b (space_contact_row c).
Proof.
  unfold enlarge. intros H ((x & y & z & nx & ny & nz & m & EP & EN & Wx & Wy & Wz & Flat & TT & NT)
                            & Wf & Wk & Wp & G).
  rewrite EP, EN in H. cbv zeta in H. set (n0 := vector_of_three nx ny nz) in *.
  set (square := square_of (nx, ny, nz)) in *. set (tu := first_turn nx ny nz) in *.
  set (tv := cross_q (nx, ny, nz) tu) in *. set (uq := square_of tu) in *.
  destruct (numbers bits q square) as [[[p u] k]|] eqn:Nu; [|discriminate].
  set (turns := negb (Qeq_bool (slope q) 0)) in *.
  destruct (turns && Qle_bool uq 0) eqn:Flatness; [discriminate|]. injection H as <-.
  assert (SqE : Q2R square = S.dot n0 n0).
  { unfold square, square_of, n0, S.dot, vector_of_three; cbn. now rewrite !Q2R_plus, !Q2R_mult. }
  assert (Sq0 : 0 <= Q2R square) by (rewrite SqE; apply dot_nonneg).
  (* the turn, and its square over that of n0 *)
  set (delta := S.dot m m / S.dot n0 n0).
  assert (SqP : 0 < Q2R square).
  { unfold numbers in Nu. destruct (inverse_length _ _ _); [|discriminate].
    destruct (_ && _) eqn:C in Nu; [|discriminate]. rewrite !andb_true_iff, negb_true_iff in C.
    destruct C as [[C _] _]. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence. }
  assert (D0 : 0 <= delta).
  { unfold delta. apply Rmult_le_pos; [apply dot_nonneg|]. left. apply Rinv_0_lt_compat. lra. }
  assert (D1 : delta <= Q2R (slope q) * Q2R (slope q)).
  { unfold delta. apply Rmult_le_reg_r with (S.dot n0 n0); [lra|]. field_simplify; [|lra]. lra. }
  assert (DD : sqrt delta * sqrt delta = delta) by now apply sqrt_sqrt.
  assert (e2 : sqrt delta * sqrt delta <= Q2R (slope q) * Q2R (slope q)) by lra.
  destruct (numbers_inside bits q square p u k (sqrt (Q2R square)) (sqrt delta) _ _ Nu (sqrt_pos _) (sqrt_sqrt _ Sq0)
    e2 Wp Wk) as (L & K & st & T & EPr & EG).
  assert (LE : sqrt (Q2R square) * sqrt (1 + sqrt delta * sqrt delta) = S.length c).
  { rewrite <- sqrt_mult by lra. rewrite DD. unfold S.length, S.norm. f_equal. rewrite NT.
    transitivity (S.dot n0 n0 + 2 * S.dot n0 m + S.dot m m).
    - rewrite Flat, SqE. unfold delta. field. lra.
    - unfold S.dot, S.add; cbn. ring. }
  rewrite LE in *.
  assert (NZ : ~ (square == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
  assert (F0 : 0 <= S.friction c).
  { unfold numbers in Nu. destruct (inverse_length _ _ _); [|discriminate].
    destruct (_ && _) eqn:C in Nu; [|discriminate]. rewrite !andb_true_iff in C.
    unfold is_nonnegative in C. rewrite !andb_true_iff in C. destruct C as [[_ [[[[F0 _] _] _] _]] _].
    apply Qle_bool_R in F0. rewrite Q2R_0 in F0. destruct Wf. lra. }
  (* m by U and V *)
  destruct (real_triple tu) as [[u1 u2] u3] eqn:Eu.
  assert (Cases : (u1, u2, u3) = (0, Q2R nz, - Q2R ny) \/ (u1, u2, u3) = (- Q2R nz, 0, Q2R nx) \/
                  (u1, u2, u3) = (Q2R ny, - Q2R nx, 0)).
  { rewrite <- Eu. unfold tu. destruct (first_turn_is nx ny nz) as [E|[E|E]]; rewrite E; cbn [real_triple];
      rewrite ?Q2R_opp, ?Q2R_0; auto. }
  assert (Ev : real_triple tv = (Q2R ny * u3 - Q2R nz * u2, Q2R nz * u1 - Q2R nx * u3, Q2R nx * u2 - Q2R ny * u1)).
  { unfold tv. destruct tu as [[t1 t2] t3]. cbn [real_triple cross_q] in *. injection Eu as <- <- <-.
    now rewrite !Q2R_minus, !Q2R_mult. }
  assert (Uq : Q2R uq = u1 * u1 + u2 * u2 + u3 * u3).
  { unfold uq. destruct tu as [[t1 t2] t3]. cbn [real_triple square_of] in *. injection Eu as <- <- <-.
    now rewrite !Q2R_plus, !Q2R_mult. }
  assert (Turn : exists e f,
    within (if turns then turn_within (slope q * slope q * square / uq) else exactly 0) e /\
    within (if turns then turn_within (slope q * slope q / uq) else exactly 0) f /\
    S.x m = e * u1 + f * (Q2R ny * u3 - Q2R nz * u2) /\
    S.y m = e * u2 + f * (Q2R nz * u1 - Q2R nx * u3) /\
    S.z m = e * u3 + f * (Q2R nx * u2 - Q2R ny * u1) /\
    (turns = true -> 0 < Q2R uq) /\
    (turns = false -> m = S.zero)).
  { destruct turns eqn:Tn.
    - cbn [andb] in Flatness.
      assert (UP : 0 < Q2R uq).
      { apply Rnot_le_lt. intros Le. rewrite <- Q2R_0 in Le. apply Rle_Qle, Qle_bool_iff in Le. congruence. }
      assert (UZ : ~ (uq == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
      pose proof (turn_parts (Q2R nx) (Q2R ny) (Q2R nz) u1 u2 u3 (S.x m) (S.y m) (S.z m) Cases) as Parts.
      cbv zeta in Parts. rewrite <- Uq in Parts.
      assert (AA : Q2R nx * Q2R nx + Q2R ny * Q2R ny + Q2R nz * Q2R nz = Q2R square)
        by (rewrite SqE; unfold S.dot, n0, vector_of_three; cbn; ring).
      rewrite AA in Parts. specialize (Parts SqP UP Flat).
      set (e := (S.x m * u1 + S.y m * u2 + S.z m * u3) / Q2R uq) in *.
      set (f := (S.x m * (Q2R ny * u3 - Q2R nz * u2) + S.y m * (Q2R nz * u1 - Q2R nx * u3) +
        S.z m * (Q2R nx * u2 - Q2R ny * u1)) / (Q2R square * Q2R uq)) in *.
      destruct Parts as (M1 & M2 & M3 & MM).
      assert (Mm : S.dot m m = Q2R uq * (e * e + Q2R square * (f * f))) by exact MM.
      assert (Bound : Q2R uq * (e * e + Q2R square * (f * f)) <= Q2R (slope q) * Q2R (slope q) * Q2R square)
        by (rewrite <- Mm, SqE; exact TT).
      assert (E0 : 0 <= e * e) by apply Rle_0_sqr. assert (F00 : 0 <= f * f) by apply Rle_0_sqr.
      assert (SF : 0 <= Q2R square * (f * f)) by (apply Rmult_le_pos; lra).
      assert (SS0 : 0 <= Q2R (slope q) * Q2R (slope q)) by apply Rle_0_sqr.
      exists e, f. split; [|split].
      + apply within_turn; rewrite Q2R_div, !Q2R_mult by exact UZ.
        * apply Rmult_le_pos; [apply Rmult_le_pos; lra|]. left. now apply Rinv_0_lt_compat.
        * apply Rmult_le_reg_r with (Q2R uq); [exact UP|]. unfold Rdiv. rewrite (Rmult_assoc _ (/ Q2R uq)), Rinv_l by lra.
          assert (0 <= Q2R uq * (Q2R square * (f * f))) by (apply Rmult_le_pos; lra). lra.
      + apply within_turn; rewrite Q2R_div, !Q2R_mult by exact UZ.
        * apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
        * apply Rmult_le_reg_r with (Q2R uq); [exact UP|]. unfold Rdiv. rewrite (Rmult_assoc _ (/ Q2R uq)), Rinv_l by lra.
          apply Rmult_le_reg_r with (Q2R square); [exact SqP|].
          assert (0 <= Q2R uq * (e * e)) by (apply Rmult_le_pos; lra). lra.
      + repeat split; auto. discriminate.
    - assert (Sl : Q2R (slope q) = 0).
      { unfold turns in Tn. apply negb_false_iff, Qeq_bool_eq, Qeq_eqR in Tn. now rewrite Q2R_0 in Tn. }
      assert (M0 : m = S.zero).
      { apply no_length. apply Rle_antisym; [|apply dot_nonneg]. rewrite Sl in TT. lra. }
      assert (Z0 : within (exactly 0) 0) by (unfold within, exactly; cbn; rewrite Q2R_0; lra).
      exists 0, 0. split; [exact Z0|]. split; [exact Z0|]. rewrite M0. unfold S.zero; cbn.
      repeat split; try ring; discriminate. }
  destruct Turn as (e & f & We & Wff & M1 & M2 & M3 & MT & MF).
  set (p0 := [S.x (S.position c); S.y (S.position c); S.z (S.position c); e; f]).
  assert (Place : S.position c = place_at p0) by now destruct (S.position c).
  assert (Normal : S.normal c = normal_at (Q2R nx) (Q2R ny) (Q2R nz) u1 u2 u3 p0).
  { rewrite NT. unfold normal_at, S.add at 1. cbn [turn_at p0].
    unfold S.add, n0, vector_of_three. cbn [S.x S.y S.z S.scale S.cross]. rewrite M1, M2, M3. reflexivity. }
  match goal with |- seen_in ?box _ => set (b := box) end.
  assert (I : inside_at b (turned_row n0 c) p0
    (space_reals (real_triple (nx, ny, nz)) (real_triple tu) (real_triple tv) (Q2R square)) (S.friction c) st).
  { constructor; cbn [b box_geometry box_forms box_friction box_square box_weights box_preload box_growth
      box_stiffness box_spring box_signed box_turns box_slack turned_row Rows.N Rows.slips Rows.rho Rows.weights
      Rows.preload Rows.growth Rows.stiffness Rows.spring]; try assumption; try discriminate.
    + constructor; [exact Wx|]. constructor; [exact Wy|]. constructor; [exact Wz|].
      constructor; [exact We|]. constructor; [exact Wff|constructor].
    + rewrite Eu, Ev, SqE. exact (seen_forms (Q2R nx) (Q2R ny) (Q2R nz) u1 u2 u3 c p0 eq_refl Place Normal).
    + now apply space_rational.
    + intros j d. apply space_affine.
    + intros p1 p2 P1 P2. now apply space_shape.
    + unfold S.norm. now rewrite SqE.
    + cbn. now rewrite Q2R_1.
    + apply three_positive.
    + now rewrite G.
    + reflexivity.
    + intros _. reflexivity.
    + intros is. destruct turns; [|unfold Q2R; cbn; lra]. pose proof (MT eq_refl) as UP.
      destruct is as [|? [|? [|? [|i1 [|i2 [|? ?]]]]]]; try (cbn [turned_slack]; rewrite Q2R_0; lra).
      cbn [turned_slack]. rewrite Q2R_div, Q2R_mult, Q2R_plus, Q2R_mult by exact NZ.
      apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat]. apply Rmult_le_pos; [lra|].
      pose proof (greatest_square_nonneg i1). pose proof (greatest_square_nonneg i2). assert (0 <= Q2R square * Q2R (greatest_square i2)) by (apply Rmult_le_pos; lra).
      lra. }
  destruct turns eqn:Tn.
  - pose proof (MT eq_refl) as UP. eexists (turned_row n0 c), p0, _, (S.friction c), st, _, _, _.
    split; [exact I|]. rewrite Eu, Ev, SqE. split.
    + apply (turned_seen_as (Q2R nx) (Q2R ny) (Q2R nz) u1 u2 u3 Cases) with (square := square) (u_square := uq);
        try reflexivity.
      * rewrite SqE in SqP. exact SqP.
      * exact SqE.
      * exact Uq.
      * rewrite Uq in UP. exact UP.
    + cbn beta. rewrite <- Normal, <- Place. unfold row_of. cbn [b box_weights box_spring map]. rewrite Q2R_1.
      reflexivity.
  - apply inside_seen. rewrite <- (turned_is_row n0 c) by
      (rewrite NT, (MF eq_refl); unfold S.add, S.zero, n0, vector_of_three; cbn; now rewrite !Rplus_0_r).
    eexists p0, _, (S.friction c), st. exact I.
Qed.

End Proofs.
