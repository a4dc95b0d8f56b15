(* SPDX-License-Identifier: MIT *)
(* A contact in space whose normal n is not the n0 of the file (FORMAT.md section 7, "Why, where n is not n0").  Its
   motion seen along n is multilinear in n, where the motion across n is not.  `turned_stands`: a row of the motion seen
   along n stands for the contact.  `turning_continuous`: the contact's own row changes continuously. *)
From Coq Require Import Reals List Lra Lia.
From Proved Require Import Brouwer Homotopy RowLimits RowsOfModels Slips Leaf.
From Proved Require Rows SpaceModel.
Import ListNotations.
Open Scope R_scope.

Module S := SpaceModel.
Import SpaceModel.

(* The motion u of a point, seen along n: u - (n0.u / n0.n0) n. *)
Definition seen (n0 n u : vector) : vector := add u (scale (- (dot n0 u / dot n0 n0)) n).

Definition seen_rows (n0 : vector) (c : contact) : list (list R) :=
  let direction nj e := add e (scale (- (nj / dot n0 n0)) n0) in
  map (fun d => screw_list (force_at (position c) d))
    [direction (x (normal c)) (Vector 1 0 0); direction (y (normal c)) (Vector 0 1 0);
     direction (z (normal c)) (Vector 0 0 1)].

Definition turned_row (n0 : vector) (c : contact) : Rows.row :=
  Rows.Row (screw_list (N c)) (seen_rows n0 c) [1; 1; 1] (friction c * norm n0)
    (preload c / length c) (growth c / length c) (stiffness c / (length c * length c)) false.

Lemma seen_slip n0 c d : Rows.slip (turned_row n0 c) d = vector_list (seen n0 (normal c) (moved c (screw_of d))).
Proof.
  unfold Rows.slip. cbn [Rows.slips turned_row seen_rows map]. rewrite !dot_screw. unfold vector_list.
  f_equal; [|f_equal; [|f_equal]];
    unfold work, force_at, seen, moved, add, scale, dot, cross; cbn; unfold Rdiv; ring.
Qed.

Lemma dot_square a b : dot a b * dot a b <= dot a a * dot b b.
Proof.
  assert (E : dot a a * dot b b - dot a b * dot a b = dot (cross a b) (cross a b))
    by (unfold dot, cross; cbn; ring).
  assert (0 <= dot (cross a b) (cross a b)); [|lra]. unfold dot.
  pose proof (Rle_0_sqr (x (cross a b))) as A. pose proof (Rle_0_sqr (y (cross a b))) as B.
  pose proof (Rle_0_sqr (z (cross a b))) as C. unfold Rsqr in *. lra.
Qed.

Lemma dot_nonneg a : 0 <= dot a a.
Proof.
  unfold dot. pose proof (Rle_0_sqr (x a)) as A. pose proof (Rle_0_sqr (y a)) as B. pose proof (Rle_0_sqr (z a)) as C.
  unfold Rsqr in *. lra.
Qed.

Lemma norm_square a : norm a * norm a = dot a a.
Proof. apply sqrt_sqrt, dot_nonneg. Qed.

Lemma norm_nonneg a : 0 <= norm a.
Proof. apply sqrt_pos. Qed.

Lemma dot_norms a b : - (norm a * norm b) <= dot a b <= norm a * norm b.
Proof.
  pose proof (norm_nonneg a) as A. pose proof (norm_nonneg b) as B.
  assert (P : 0 <= norm a * norm b) by now apply Rmult_le_pos.
  assert (Q : dot a b * dot a b <= (norm a * norm b) * (norm a * norm b)).
  { replace ((norm a * norm b) * (norm a * norm b)) with ((norm a * norm a) * (norm b * norm b)) by ring.
    rewrite !norm_square. apply dot_square. }
  split; apply Rnot_lt_le; intros L.
  - assert ((norm a * norm b) * (norm a * norm b) < (- dot a b) * (- dot a b))
      by (apply Rmult_le_0_lt_compat; lra). lra.
  - assert ((norm a * norm b) * (norm a * norm b) < dot a b * dot a b)
      by (apply Rmult_le_0_lt_compat; lra). lra.
Qed.

(* -A / D, where A is nearly L^2 s.z and D nearly L |s|. *)
Lemma nearly_along L s zl k sz B D : 0 < L -> 0 < s -> 0 <= zl -> 0 <= k -> - (s * zl) <= sz -> - (L * L * k * s * zl) <= B ->
  sz <= s * zl -> L * s <= D <= L * s * (1 + k / 2) ->
  - ((L * L * sz + B) / D) <= L * (- sz / s + 3 / 2 * k * zl).
Proof.
  intros L0 S0 Z0 K0 Lo HB Hi [D1 D2]. assert (LS : 0 < L * s) by now apply Rmult_lt_0_compat.
  assert (D0 : 0 < D) by lra.
  apply Rmult_le_reg_l with (D * s); [now apply Rmult_lt_0_compat|].
  replace (D * s * - ((L * L * sz + B) / D)) with (- s * (L * L * sz + B)) by (field; lra).
  replace (D * s * (L * (- sz / s + 3 / 2 * k * zl))) with (L * (- D * sz + 3 / 2 * k * zl * D * s)) by (field; lra).
  (* sz (D - L s) <= s zl L s k / 2, and -B <= L^2 k s zl *)
  assert (E1 : (D - L * s) * sz <= L * s * (k / 2) * (s * zl)).
  { apply Rle_trans with ((D - L * s) * (s * zl)); [apply Rmult_le_compat_l; lra|].
    apply Rmult_le_compat_r; [apply Rmult_le_pos; lra|]. lra. }
  assert (E2 : - s * B <= s * (L * L * k * s * zl)).
  { replace (- s * B) with (s * - B) by ring. apply Rmult_le_compat_l; lra. }
  assert (E3 : L * (k * zl) * (L * s) * s <= L * (k * zl) * D * s).
  { assert (0 <= L * (k * zl)) by (apply Rmult_le_pos; [lra|now apply Rmult_le_pos]).
    apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (E1' : L * ((D - L * s) * sz) <= L * (L * s * (k / 2) * (s * zl))) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Section Turned.

Variable c : contact.
Variables n0 m : vector.
Let n := normal c.
Hypothesis n_is : n = add n0 m.
Hypothesis flat : dot n0 m = 0.
Hypothesis long : 0 < dot n0 n0.
Hypothesis friction_nonneg : 0 <= friction c.

Let L := norm n0.
Let k := dot m m / dot n0 n0.

Lemma L_positive : 0 < L.
Proof. now apply sqrt_lt_R0. Qed.

Lemma LL : L * L = dot n0 n0.
Proof. apply norm_square. Qed.

Lemma k_nonneg : 0 <= k.
Proof. apply Rmult_le_pos; [apply dot_nonneg|]. left. now apply Rinv_0_lt_compat. Qed.

Lemma mm : dot m m = L * L * k.
Proof. rewrite LL. unfold k. field. lra. Qed.

Lemma nn : dot n n = L * L * (1 + k).
Proof.
  transitivity (dot n0 n0 + 2 * dot n0 m + dot m m).
  - rewrite n_is. unfold dot, add; cbn. ring.
  - rewrite flat, mm, LL. ring.
Qed.

Lemma nn_positive : 0 < dot n n.
Proof.
  rewrite nn. pose proof L_positive. pose proof k_nonneg. apply Rmult_lt_0_compat; [|lra].
  now apply Rmult_lt_0_compat.
Qed.

Lemma n0n : dot n0 n = dot n0 n0.
Proof. rewrite n_is. transitivity (dot n0 n0 + dot n0 m); [unfold dot, add; cbn; ring|]. rewrite flat. ring. Qed.

Lemma seen_flat u : dot n0 (seen n0 n u) = 0.
Proof.
  transitivity (dot n0 u - dot n0 u / dot n0 n0 * dot n0 n); [unfold seen, dot, add, scale; cbn; ring|].
  rewrite n0n. field. lra.
Qed.

Lemma across_seen u : across n (seen n0 n u) = across n u.
Proof.
  pose proof nn_positive as P. unfold across, seen. set (q := - (dot n0 u / dot n0 n0)).
  assert (E : dot (add u (scale q n)) n / dot n n = dot u n / dot n n + q).
  { replace (dot (add u (scale q n)) n) with (dot u n + q * dot n n) by (unfold dot, add, scale; cbn; ring). field. lra. }
  rewrite E. unfold add, scale; cbn. f_equal; ring.
Qed.

(* The products of motions across n, of what is seen of them. *)
Lemma across_products s t : dot n0 s = 0 -> dot n0 t = 0 ->
  dot n n * dot (across n s) (across n t) = L * L * (1 + k) * dot s t - dot s m * dot t m.
Proof.
  intros Fs Ft. pose proof nn_positive as P.
  assert (Sn : dot s n = dot s m).
  { rewrite n_is. transitivity (dot n0 s + dot s m); [unfold dot, add; cbn; ring|]. rewrite Fs. ring. }
  assert (Tn : dot t n = dot t m).
  { rewrite n_is. transitivity (dot n0 t + dot t m); [unfold dot, add; cbn; ring|]. rewrite Ft. ring. }
  assert (E : dot (across n s) (across n t) = dot s t - dot s n * dot t n / dot n n).
  { unfold across. set (p := dot s n / dot n n). set (q := dot t n / dot n n).
    transitivity (dot s t - q * dot s n - p * dot t n + p * q * dot n n); [unfold dot, add, scale; cbn; ring|].
    unfold p, q. field. lra. }
  rewrite E, Sn, Tn. replace (dot n n * (dot s t - dot s m * dot t m / dot n n))
    with (dot n n * dot s t - dot s m * dot t m) by (field; lra). now rewrite nn.
Qed.

(* |n| times the length of a motion across n. *)
Lemma across_length s : dot n0 s = 0 -> L * norm s <= norm n * norm (across n s) <= L * norm s * (1 + k / 2).
Proof.
  intros Fs. pose proof (across_products s s Fs Fs) as E. pose proof L_positive as LP. pose proof k_nonneg as K.
  pose proof (norm_nonneg s) as S0. pose proof (norm_nonneg n) as N0. pose proof (norm_nonneg (across n s)) as A0.
  pose proof (dot_square s m) as Q. rewrite mm in Q.
  pose proof (Rle_0_sqr (dot s m)) as Q0. unfold Rsqr in Q0.
  assert (Sq : (norm n * norm (across n s)) * (norm n * norm (across n s)) = L * L * (1 + k) * dot s s - dot s m * dot s m).
  { rewrite <- E, <- !norm_square. ring. }
  assert (P : 0 <= norm n * norm (across n s)) by now apply Rmult_le_pos.
  assert (LS : 0 <= L * norm s) by (apply Rmult_le_pos; lra).
  pose proof (norm_square s) as SS.
  split; apply Rnot_lt_le; intros Lt.
  - assert ((norm n * norm (across n s)) * (norm n * norm (across n s)) < (L * norm s) * (L * norm s))
      by (apply Rmult_le_0_lt_compat; lra).
    replace ((L * norm s) * (L * norm s)) with (L * L * dot s s) in H by (rewrite <- SS; ring). lra.
  - assert (U : 0 <= L * norm s * (1 + k / 2)) by (apply Rmult_le_pos; lra).
    assert ((L * norm s * (1 + k / 2)) * (L * norm s * (1 + k / 2)) <
      (norm n * norm (across n s)) * (norm n * norm (across n s))) by (apply Rmult_le_0_lt_compat; lra).
    replace ((L * norm s * (1 + k / 2)) * (L * norm s * (1 + k / 2)))
      with (L * L * dot s s * (1 + k + k * k / 4)) in H by (rewrite <- SS; field).
    assert (0 <= L * L * dot s s * (k * k / 4)).
    { apply Rmult_le_pos; [|apply Rmult_le_pos; [apply Rle_0_sqr|lra]].
      apply Rmult_le_pos; [apply Rle_0_sqr|apply dot_nonneg]. }
    lra.
Qed.

Lemma size_three s : Rows.size [1; 1; 1] (vector_list s) = norm s.
Proof. apply RowsOfModels.size_is. Qed.

Lemma product_vectors s t : Rows.product [1; 1; 1] (vector_list s) (vector_list t) = dot s t.
Proof. rewrite product_three. reflexivity. Qed.

(* A force across n that does the work of F on what is seen; it is F, if F is across n0, turned with n. *)
Definition turned_force (f : vector) : vector := add f (scale (- (dot f n / dot n0 n0)) n0).

Lemma turned_force_work f u : dot (turned_force f) (across n u) = dot f (seen n0 n u).
Proof.
  set (q := dot f n / dot n0 n0).
  assert (Fn : dot (turned_force f) n = 0).
  { transitivity (dot f n - q * dot n0 n); [unfold turned_force, q, dot, add, scale; cbn; ring|].
    rewrite n0n. unfold q. field. lra. }
  transitivity (dot (turned_force f) u - dot u n / dot n n * dot (turned_force f) n);
    [unfold across, dot, add, scale; cbn; ring|]. rewrite Fn.
  transitivity (dot f u - q * dot n0 u); [unfold turned_force, q, dot, add, scale; cbn; ring|].
  transitivity (dot f u - dot n0 u / dot n0 n0 * dot f n); [unfold q; field; lra|].
  unfold seen, dot, add, scale; cbn. ring.
Qed.

Lemma turned_force_length f : L * norm (turned_force f) <= norm f * norm n.
Proof.
  pose proof L_positive as LP. pose proof (norm_nonneg f) as F0. pose proof (norm_nonneg n) as N0.
  pose proof (norm_nonneg (turned_force f)) as T0.
  assert (E : L * L * dot (turned_force f) (turned_force f) = dot f f * (L * L) + dot f m * dot f m - dot f n0 * dot f n0).
  { rewrite LL. set (q := dot f n / dot n0 n0).
    transitivity (dot n0 n0 * dot f f - 2 * (q * dot n0 n0) * dot f n0 + (q * dot n0 n0) * (q * dot n0 n0));
      [unfold turned_force, q, dot, add, scale; cbn; ring|].
    replace (q * dot n0 n0) with (dot f n) by (unfold q; field; lra).
    replace (dot f n) with (dot f n0 + dot f m) by (rewrite n_is; unfold dot, add; cbn; ring). ring. }
  apply Rnot_lt_le. intros Lt.
  assert (P : 0 <= norm f * norm n) by now apply Rmult_le_pos.
  assert (H : (norm f * norm n) * (norm f * norm n) < (L * norm (turned_force f)) * (L * norm (turned_force f)))
    by (apply Rmult_le_0_lt_compat; assumption).
  replace ((L * norm (turned_force f)) * (L * norm (turned_force f))) with (L * L * dot (turned_force f) (turned_force f))
    in H by (rewrite <- norm_square; ring).
  replace ((norm f * norm n) * (norm f * norm n)) with (dot f f * dot n n) in H by (rewrite <- !norm_square; ring).
  rewrite E, nn in H. pose proof (dot_square f m) as Q. rewrite mm in Q.
  pose proof (Rle_0_sqr (dot f n0)) as Q0. unfold Rsqr in Q0. lra.
Qed.

Theorem turned_stands : stands k (space_contact_row c) (turned_row n0 c).
Proof.
  pose proof L_positive as LP. pose proof k_nonneg as K.
  assert (Slip : forall d, Rows.slip (space_contact_row c) d =
    vector_list (across n (seen n0 n (moved c (screw_of d))))).
  { intros d. rewrite space_slip_is, slip_across. fold n. now rewrite across_seen. }
  constructor; try reflexivity; [apply three_positive|exact K| | | | |].
  - cbn [Rows.rho turned_row space_contact_row]. intros Z.
    assert (friction c = 0) as ->; [|ring]. apply Rmult_integral in Z as [Z|Z]; [exact Z|]. fold L in Z. lra.
  - intros w d h l a g y (_ & Cone & Diss) A0. unfold work_within.
    rewrite !seen_slip, !Slip in *. cbn [Rows.weights Rows.rho turned_row space_contact_row] in *.
    rewrite !size_three in *. rewrite product_vectors, !product_three in *. fold n in Cone, Diss |- *.
    set (s := seen n0 n (moved c (screw_of d))) in *. set (t := seen n0 n (moved c (screw_of y))) in *.
    assert (Fs : dot n0 s = 0) by apply seen_flat. assert (Ftt : dot n0 t = 0) by apply seen_flat.
    change (length c) with (norm n) in *. fold L.
    assert (MA : 0 <= friction c * a) by now apply Rmult_le_pos.
    pose proof (norm_nonneg t) as T0.
    set (tau := across n t).
    split.
    + assert (G : dot (vector_of g) tau <= friction c * norm n * a * norm tau).
      { eapply Rle_trans; [apply dot_norms|]. rewrite size_of_list. apply Rmult_le_compat_r; [apply norm_nonneg|exact Cone]. }
      destruct (across_length t Ftt) as [_ Hi]. fold tau in Hi.
      eapply Rle_trans; [exact G|].
      replace (friction c * norm n * a * norm tau) with (friction c * a * (norm n * norm tau)) by ring.
      replace (friction c * L * a * ((1 + k / 2) * norm t)) with (friction c * a * (L * norm t * (1 + k / 2))) by ring.
      apply Rmult_le_compat_l; [exact MA|exact Hi].
    + intros S0. set (sigma := across n s) in *.
      destruct (across_length s Fs) as [Lo Hi]. fold sigma in Lo, Hi.
      assert (N0 : 0 < norm n) by (apply sqrt_lt_R0; apply nn_positive).
      assert (Sg : 0 < norm sigma).
      { assert (0 < L * norm s) by now apply Rmult_lt_0_compat.
        apply Rnot_le_lt. intros N. assert (0 <= norm n * - norm sigma) by (apply Rmult_le_pos; lra). lra. }
      assert (Ag : dot (vector_of g) tau = - (friction c * norm n * a / norm sigma) * dot sigma tau).
      { assert (D' : Rows.product [1; 1; 1] g (vector_list sigma) =
          - (friction c * norm n * a) * Rows.size [1; 1; 1] (vector_list sigma))
          by (rewrite product_three, size_three; exact Diss).
        assert (S' : 0 < Rows.size [1; 1; 1] (vector_list sigma)) by now rewrite size_three.
        pose proof (Rows.against_slip _ _ _ _ three_positive Cone D' S' (vector_list tau)) as H.
        now rewrite size_three, product_vectors, product_three in H. }
      rewrite Ag. pose proof (across_products s t Fs Ftt) as A. fold sigma tau in A.
      set (B := L * L * k * dot s t - dot s m * dot t m).
      assert (AE : norm n * norm n * dot sigma tau = L * L * dot s t + B).
      { rewrite norm_square, A. unfold B. ring. }
      replace (- (friction c * norm n * a / norm sigma) * dot sigma tau)
        with (friction c * a * - ((norm n * norm n * dot sigma tau) / (norm n * norm sigma))) by (field; lra).
      rewrite AE.
      replace (friction c * L * a * (- dot s t / norm s + 3 / 2 * k * norm t))
        with (friction c * a * (L * (- dot s t / norm s + 3 / 2 * k * norm t))) by ring.
      apply Rmult_le_compat_l; [exact MA|].
      destruct (dot_norms s t) as [D1 D2].
      apply nearly_along; try assumption; try lra.
      (* B = (m x s).(m x t) *)
      assert (BE : B = dot (cross m s) (cross m t)).
      { transitivity (dot m m * dot s t - dot s m * dot t m); [unfold B; rewrite mm; ring|].
        unfold dot, cross; cbn. ring. }
      destruct (dot_norms (cross m s) (cross m t)) as [D3 _]. rewrite BE.
      assert (Cr : forall v, norm (cross m v) <= norm m * norm v).
      { intros v. pose proof (norm_nonneg m) as M0. pose proof (norm_nonneg v) as V0.
        apply Rnot_lt_le. intros Lt.
        assert ((norm m * norm v) * (norm m * norm v) < norm (cross m v) * norm (cross m v))
          by (apply Rmult_le_0_lt_compat; try lra; now apply Rmult_le_pos).
        rewrite norm_square in H.
        assert (E : dot (cross m v) (cross m v) = dot m m * dot v v - dot m v * dot m v)
          by (unfold dot, cross; cbn; ring).
        pose proof (Rle_0_sqr (dot m v)) as Q. unfold Rsqr in Q.
        replace ((norm m * norm v) * (norm m * norm v)) with (dot m m * dot v v) in H
          by (rewrite <- !norm_square; ring). lra. }
      pose proof (Cr s) as C1. pose proof (Cr t) as C2.
      assert (norm (cross m s) * norm (cross m t) <= (norm m * norm s) * (norm m * norm t))
        by (apply Rmult_le_compat; try apply norm_nonneg; assumption).
      replace ((norm m * norm s) * (norm m * norm t)) with (L * L * k * norm s * norm t) in H
        by (rewrite <- mm, <- norm_square; ring). lra.
  - intros w d h l a g (_ & _ & Diss) A0. rewrite seen_slip, !Slip in *.
    cbn [Rows.weights Rows.rho turned_row space_contact_row] in *. rewrite !size_three in *. fold n in Diss |- *. rewrite Diss.
    set (s := seen n0 n (moved c (screw_of d))) in *. change (length c) with (norm n). fold L.
    destruct (across_length s (seen_flat _)) as [Lo _].
    replace (- (friction c * norm n * a) * norm (across n s)) with (- (friction c * a) * (norm n * norm (across n s))) by ring.
    replace (- (friction c * L * a) * norm s) with (- (friction c * a) * (L * norm s)) by ring.
    assert (MA : 0 <= friction c * a) by now apply Rmult_le_pos.
    apply (Rmult_le_compat_l _ _ _ MA) in Lo. lra.
  - intros a g' C. cbn [Rows.weights Rows.rho turned_row space_contact_row] in *. fold L in C.
    rewrite <- size_of_list in C. change (length c) with (norm n). set (f := vector_of g') in *.
    exists (vector_list (turned_force f)). rewrite size_three. split.
    + apply Rmult_le_reg_l with L; [exact LP|]. eapply Rle_trans; [apply turned_force_length|].
      replace (L * (friction c * norm n * a)) with (friction c * L * a * norm n) by ring.
      apply Rmult_le_compat_r; [apply norm_nonneg|exact C].
    + intros y. rewrite seen_slip, space_slip_is, slip_across, product_vectors, product_three. fold n f.
      apply turned_force_work.
  - intros d. rewrite seen_slip, Slip. cbn [Rows.weights turned_row space_contact_row]. rewrite !size_three. fold n.
    set (s := seen n0 n (moved c (screw_of d))) in *.
    pose proof (seen_flat (moved c (screw_of d))) as Fs. fold s in Fs.
    destruct (across_length s Fs) as [Lo Hi]. pose proof (norm_nonneg s) as N0.
    pose proof (norm_nonneg (across n s)) as A0.
    assert (0 < norm n) by (apply sqrt_lt_R0; apply nn_positive).
    split; intros P.
    + destruct (Rle_lt_or_eq_dec _ _ N0) as [Q|Z]; [exact Q|]. rewrite <- Z in Hi. exfalso.
      assert (0 < norm n * norm (across n s)) by now apply Rmult_lt_0_compat. lra.
    + destruct (Rle_lt_or_eq_dec _ _ A0) as [Q|Z]; [exact Q|]. rewrite <- Z in Lo. exfalso.
      assert (0 < L * norm s) by now apply Rmult_lt_0_compat. lra.
Qed.

End Turned.

(* ---- As the normal turns ---- *)

Definition cv_vector (vs : nat -> vector) (v : vector) : Prop :=
  Un_cv (fun i => x (vs i)) (x v) /\ Un_cv (fun i => y (vs i)) (y v) /\ Un_cv (fun i => z (vs i)) (z v).

(* Sums, differences and products of what converges. *)
Ltac converge :=
  lazymatch goal with
  | |- Un_cv (fun _ => ?c) ?c => apply cv_constant
  | |- Un_cv (fun i => @?f i + @?g i) (?a + ?b) => apply (CV_plus f g a b); converge
  | |- Un_cv (fun i => @?f i - @?g i) (?a - ?b) => apply (CV_minus f g a b); converge
  | |- Un_cv (fun i => @?f i * @?g i) (?a * ?b) => apply (CV_mult f g a b); converge
  | |- Un_cv (fun i => - @?f i) (- ?a) => apply (CV_opp f a); converge
  | |- _ => assumption
  end.

Lemma cv_dots us u vs v : cv_vector us u -> cv_vector vs v -> Un_cv (fun i => dot (us i) (vs i)) (dot u v).
Proof. intros (U1 & U2 & U3) (V1 & V2 & V3). unfold dot. converge. Qed.

Lemma cv_across ns n e : 0 < dot n n -> cv_vector ns n -> cv_vector (fun i => across (ns i) e) (across n e).
Proof.
  intros P N. assert (E : cv_vector (fun _ => e) e) by (repeat split; apply cv_constant).
  pose proof (cv_dots _ _ _ _ E N) as D. pose proof (cv_dots _ _ _ _ N N) as Q.
  apply cv_inverse in Q; [|lra]. destruct N as (N1 & N2 & N3).
  unfold across, cv_vector, add, scale, Rdiv; cbn [x y z]. repeat split; converge.
Qed.

Lemma cv_force ps p fs f : cv_vector ps p -> cv_vector fs f ->
  cv_list (fun i => screw_list (force_at (ps i) (fs i))) (screw_list (force_at p f)).
Proof.
  intros (P1 & P2 & P3) (F1 & F2 & F3). unfold screw_list, force_at, cross; cbn [linear angular x y z].
  apply (cv_cons (fun i => x (fs i))); [assumption|]. apply (cv_cons (fun i => y (fs i))); [assumption|].
  apply (cv_cons (fun i => z (fs i))); [assumption|].
  apply (cv_cons (fun i => y (ps i) * z (fs i) - z (ps i) * y (fs i))); [converge|].
  apply (cv_cons (fun i => z (ps i) * x (fs i) - x (ps i) * z (fs i))); [converge|].
  apply (cv_cons (fun i => x (ps i) * y (fs i) - y (ps i) * x (fs i))); [converge|constructor].
Qed.

(* The contact at p with the normal n that has these numbers in its row. *)
Definition contact_with (p n : vector) (mu preload growth stiffness : R) : contact :=
  Contact p n mu (stiffness * (norm n * norm n)) (preload * norm n) (growth * norm n).

(* N, and the slip's forms: nothing else of a contact's row depends on p and n but rho. *)
Definition own_forms (p n : vector) : list (list R) :=
  let c := contact_with p n 0 0 0 0 in screw_list (N c) :: slip_rows c.

Lemma turning_continuous ps p ns n : 0 < dot n n -> cv_vector ps p -> cv_vector ns n ->
  cv_lists (fun i => own_forms (ps i) (ns i)) (own_forms p n) /\ Un_cv (fun i => norm (ns i)) (norm n).
Proof.
  intros Pn P Ns. split.
  - unfold own_forms, contact_with, N, slip_rows. cbn [position normal map].
    apply (cv_lists_cons (fun i => screw_list (force_at (ps i) (ns i)))); [now apply cv_force|].
    apply (cv_lists_cons (fun i => screw_list (force_at (ps i) (across (ns i) (Vector 1 0 0)))));
      [apply cv_force; [exact P|now apply cv_across]|].
    apply (cv_lists_cons (fun i => screw_list (force_at (ps i) (across (ns i) (Vector 0 1 0)))));
      [apply cv_force; [exact P|now apply cv_across]|].
    apply (cv_lists_cons (fun i => screw_list (force_at (ps i) (across (ns i) (Vector 0 0 1)))));
      [apply cv_force; [exact P|now apply cv_across]|constructor].
  - apply cv_root; [intros i; apply dot_nonneg|now apply cv_dots].
Qed.

Lemma contact_with_row p n mu pr u k : 0 < dot n n ->
  space_contact_row (contact_with p n mu pr u k) =
  Rows.Row (hd [] (own_forms p n)) (tl (own_forms p n)) [1; 1; 1] (mu * norm n) pr u k false.
Proof.
  intros P. assert (0 < norm n) by now apply sqrt_lt_R0.
  unfold space_contact_row, own_forms, contact_with, length, N, slip_rows. cbn [position normal friction preload growth
    stiffness hd tl]. f_equal; field; lra.
Qed.
