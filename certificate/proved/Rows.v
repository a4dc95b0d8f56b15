(* SPDX-License-Identifier: MIT *)
(* The law of FORMAT.md section 1 for rows in R^D, over the real numbers: what the plane (Model.v), space
   (SpaceModel.v) and all else that can be written in rows have in common, and what proofs about checking are
   about.  RowsOfModels.v says that the equilibria of the models are those of their rows.

   Vectors are lists, which end in zeros: a dot product goes to the end of the shorter one. *)
From Coq Require Import Reals List Lra Lia.
From Proved Require Model.
Import ListNotations.
Open Scope R_scope.

Fixpoint dot (a b : list R) : R :=
  match a, b with x :: a', y :: b' => x * y + dot a' b' | _, _ => 0 end.

Definition scaled (s : R) (a : list R) : list R := map (Rmult s) a.

(* The product of slips, <s, t>: a sum with positive weights. *)
Fixpoint product (weights s t : list R) : R :=
  match weights, s, t with
  | c :: weights', x :: s', y :: t' => c * x * y + product weights' s' t'
  | _, _, _ => 0
  end.

Definition size (weights s : list R) : R := sqrt (product weights s s).

Record row := Row {
  N : list R;
  slips : list (list R);        (* S, a linear form for each component of a slip; none of a spring *)
  weights : list R;             (* of their product; so many, and all above 0 *)
  rho : R;
  preload : R;                  (* P' *)
  growth : R;                   (* what P' grows by in a margin *)
  stiffness : R;                (* k' *)
  spring : bool
}.

Definition slip (r : row) (d : list R) : list R := map (fun form => dot form d) (slips r).

(* The law of the normal spring without its corner, at the point (d, h, l). *)
Definition v (r : row) (d : list R) (h l : R) : R :=
  preload r * h + growth r * l - stiffness r * dot (N r) d.

(* A force is a, along N, and g in the space of slips: of friction f it is the g with f = g*, so that
   |f| = |g| and the work on y is <g, S y>. *)
Definition force := (R * list R)%type.

Definition work (r : row) (f : force) (y : list R) : R :=
  fst f * dot (N r) y + product (weights r) (snd f) (slip r y).

Definition normal_law (l : Model.law) (r : row) (v a : R) : Prop :=
  if spring r then a = v else Model.normal_law l v a.

(* What a force has to be at the point (d, h, l): the normal law, Coulomb's cone, and that friction takes up as
   much work as the cone allows, which `against_slip` shows to be the law of FORMAT.md. *)
Definition obeys (w : Model.law) (d : list R) (h l : R) (r : row) (f : force) : Prop :=
  let (a, g) := f in
  normal_law w r (v r d h l) a /\
  size (weights r) g <= rho r * a /\
  product (weights r) g (slip r d) = - (rho r * a) * size (weights r) (slip r d).

Record system := System {
  dimension : nat;              (* D *)
  rows : list row;
  wrench : list R;              (* w *)
  direction : list R;           (* u *)
  normal : Model.law
}.

Definition load (s : system) (h l : R) (y : list R) : R :=
  h * dot (wrench s) y + l * dot (direction s) y.

Fixpoint works (rs : list row) (fs : list force) (y : list R) : R :=
  match rs, fs with
  | r :: rs', f :: fs' => work r f y + works rs' fs' y
  | _, _ => 0
  end.

(* The point (d, h, l), with forces; balance is that on every virtual twist y no work is done. *)
Definition equilibrium (s : system) (d : list R) (h l : R) (fs : list force) : Prop :=
  List.length d = dimension s /\
  Forall2 (obeys (normal s) d h l) (rows s) fs /\
  forall y, load s h l y + works (rows s) fs y = 0.

(* With a motion that is allowed. *)
Definition stable_at (allowed : list R -> Prop) (s : system) (lambda : R) : Prop :=
  exists d fs, allowed d /\ equilibrium s d 1 lambda fs.

(* |d_j| <= B_j h for all j, where motions are bounded. *)
Definition bounded (bound : option (list R)) (h : R) (d : list R) : Prop :=
  match bound with None => True | Some most => Forall2 (fun b x => Rabs x <= b * h) most d end.

(* ---- Products ---- *)

Lemma dot_scaled c a b : dot (scaled c a) b = c * dot a b.
Proof. revert b. induction a as [|x a IH]; intros [|y b]; cbn; try ring. unfold scaled in IH. rewrite IH. ring. Qed.

Lemma product_scaled ws c s t : product ws (scaled c s) t = c * product ws s t.
Proof.
  revert s t. induction ws as [|w ws IH]; intros [|x s] [|y t]; cbn; try ring.
  unfold scaled in IH. rewrite IH. ring.
Qed.

Lemma product_sym ws s t : product ws s t = product ws t s.
Proof.
  revert s t. induction ws as [|w ws IH]; intros [|x s] [|y t]; cbn; try ring. rewrite IH. ring.
Qed.

Definition positive (ws : list R) := Forall (fun w => 0 < w) ws.

Lemma product_nonneg ws s : positive ws -> 0 <= product ws s s.
Proof.
  intros P. revert s. induction P as [|w ws Pw P IH]; intros [|x s]; cbn; try lra.
  specialize (IH s). pose proof (Rle_0_sqr x) as Q. unfold Rsqr in Q.
  assert (0 <= w * (x * x)) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma size_nonneg ws s : 0 <= size ws s.
Proof. apply sqrt_pos. Qed.

Lemma size_square ws s : positive ws -> size ws s * size ws s = product ws s s.
Proof. intros P. apply sqrt_sqrt. now apply product_nonneg. Qed.

Lemma size_scaled ws c s : positive ws -> 0 <= c -> size ws (scaled c s) = c * size ws s.
Proof.
  intros P C. unfold size. rewrite product_scaled, product_sym, product_scaled, <- Rmult_assoc.
  rewrite sqrt_mult_alt by apply Rle_0_sqr. now rewrite sqrt_square.
Qed.

(* Cauchy and Schwarz. *)
Lemma product_bound ws s t : positive ws -> product ws s t <= size ws s * size ws t.
Proof.
  intros P.
  assert (Q : product ws s t * product ws s t <= product ws s s * product ws t t).
  { revert s t. induction P as [|w ws Pw P IH]; intros [|x s] [|y t]; cbn; try lra.
    specialize (IH s t). pose proof (product_nonneg ws s P) as A. pose proof (product_nonneg ws t P) as B.
      set (ss := product ws s s) in *. set (tt := product ws t t) in *. set (st := product ws s t) in *.
      (* 2 x y st <= x^2 tt + y^2 ss *)
      assert (M : 2 * (x * y * st) <= x * x * tt + y * y * ss).
      { destruct (Rlt_dec 0 ss) as [Ps|Ns].
        - assert (E : ss * (x * x * tt + y * y * ss - 2 * (x * y * st)) =
                      (y * ss - x * st) * (y * ss - x * st) + x * x * (ss * tt - st * st)) by ring.
          assert (0 <= (y * ss - x * st) * (y * ss - x * st)) by apply Rle_0_sqr.
          assert (0 <= x * x) by apply Rle_0_sqr.
          assert (0 <= x * x * (ss * tt - st * st)) by (apply Rmult_le_pos; lra).
          assert (0 <= ss * (x * x * tt + y * y * ss - 2 * (x * y * st))) by lra.
          apply Rnot_lt_le. intros L.
          assert (ss * (x * x * tt + y * y * ss - 2 * (x * y * st)) < 0); [|lra].
          replace 0 with (ss * 0) by ring. apply Rmult_lt_compat_l; lra.
        - assert (Z : ss = 0) by lra. rewrite Z in *. rewrite Rmult_0_l in IH.
          assert (st = 0).
          { apply Rsqr_0_uniq. pose proof (Rle_0_sqr st). unfold Rsqr in *. lra. }
          rewrite H. assert (0 <= x * x) by apply Rle_0_sqr.
          assert (0 <= x * x * tt) by (apply Rmult_le_pos; lra). lra. }
      assert (0 <= w) by lra.
      assert (w * (2 * (x * y * st)) <= w * (x * x * tt + y * y * ss)) by (now apply Rmult_le_compat_l).
      lra. }
  pose proof (size_nonneg ws s) as A. pose proof (size_nonneg ws t) as B.
  pose proof (Rmult_le_pos _ _ A B) as AB. apply Rnot_lt_le. intros L.
  assert (size ws s * size ws t * (size ws s * size ws t) < product ws s t * product ws s t)
    by (apply Rmult_le_0_lt_compat; assumption).
  replace (size ws s * size ws t * (size ws s * size ws t))
    with (size ws s * size ws s * (size ws t * size ws t)) in H by ring.
  rewrite !size_square in H by exact P. lra.
Qed.

Fixpoint plus (a b : list R) : list R :=
  match a, b with
  | x :: a', y :: b' => (x + y) :: plus a' b'
  | [], _ => b
  | _, [] => a
  end.

Lemma product_plus ws a b t : product ws (plus a b) t = product ws a t + product ws b t.
Proof.
  revert a b t. induction ws as [|w ws IH]; intros [|x a] [|y b] [|z t]; cbn; try ring. rewrite IH. ring.
Qed.

Lemma dot_plus a b d : dot (plus a b) d = dot a d + dot b d.
Proof. revert b d. induction a as [|x a IH]; intros [|y b] [|z d]; cbn; try ring. rewrite IH. ring. Qed.

Lemma size_plus ws s t : positive ws -> size ws (plus s t) <= size ws s + size ws t.
Proof.
  intros P. pose proof (size_nonneg ws s) as A. pose proof (size_nonneg ws t) as B.
  apply Rnot_lt_le. intros L. pose proof (product_bound ws s t P) as C.
  assert ((size ws s + size ws t) * (size ws s + size ws t) < size ws (plus s t) * size ws (plus s t))
    by (apply Rmult_le_0_lt_compat; lra).
  rewrite size_square, product_plus, !(product_sym ws _ (plus s t)), !product_plus in H by exact P.
  rewrite (product_sym ws t s) in H.
  pose proof (size_square ws s P). pose proof (size_square ws t P). lra.
Qed.

Lemma size_zero ws s t : positive ws -> size ws s = 0 -> product ws s t = 0.
Proof.
  intros P Z. pose proof (product_bound ws s t P) as A.
  pose proof (product_bound ws (scaled (-1) s) t P) as B. rewrite product_scaled in B.
  assert (size ws (scaled (-1) s) = 0).
  { unfold size in *. rewrite product_scaled, product_sym, product_scaled, <- Rmult_assoc.
    now replace (-1 * -1 * product ws s s) with (product ws s s) by ring. }
  rewrite H in B. rewrite Z in A. lra.
Qed.

Lemma size_zero_nth ws s k : positive ws -> size ws s = 0 -> (k < List.length ws)%nat -> nth k s 0 = 0.
Proof.
  intros P Z L. pose proof (size_zero ws s (repeat 0 k ++ [1]) P Z) as E. clear Z.
  revert k s L E. induction P as [|w ws Pw P IH]; intros [|k] [|x s] L E; cbn in *; try lia; try reflexivity.
  - assert (product ws s [] = 0) by (destruct ws, s; reflexivity). nra.
  - apply IH; [lia|]. lra.
Qed.

(* Where something slips, friction is against it. *)
Theorem against_slip ws g s most : positive ws -> size ws g <= most ->
  product ws g s = - most * size ws s -> 0 < size ws s ->
  forall t, product ws g t = - (most / size ws s) * product ws s t.
Proof.
  intros P C D S t. set (k := most / size ws s). set (z := plus g (scaled k s)).
  assert (K : k * size ws s = most) by (unfold k; field; lra).
  assert (Z : product ws z z <= 0).
  { unfold z. rewrite product_plus, !(product_sym ws _ (plus g (scaled k s))), !product_plus.
    rewrite !product_scaled, !(product_sym ws _ (scaled k s)), !product_scaled, (product_sym ws s g), D.
    rewrite <- (size_square ws g P), <- (size_square ws s P).
    pose proof (size_nonneg ws g).
    assert (size ws g * size ws g <= most * most) by (apply Rmult_le_compat; lra).
    replace (size ws g * size ws g + k * (- most * size ws s) +
      (k * (- most * size ws s) + k * (k * (size ws s * size ws s))))
      with (size ws g * size ws g - 2 * most * (k * size ws s) + (k * size ws s) * (k * size ws s)) by ring.
    rewrite K. lra. }
  assert (size ws z = 0).
  { unfold size. pose proof (product_nonneg ws z P). replace (product ws z z) with 0 by lra. apply sqrt_0. }
  pose proof (size_zero ws z t P H) as E. unfold z in E. rewrite product_plus, product_scaled in E. lra.
Qed.
