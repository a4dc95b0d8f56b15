(* SPDX-License-Identifier: MIT *)
(* Rows (Rows.v) that change continuously, with friction that grows continuously from none to what the law asks
   for: -rho a s / max(|s|, eps).  `works_continuous`: the work of such forces is continuous.  `works_limit`:
   where eps goes to 0, limits of such forces obey the law. *)
From Coq Require Import List Arith Lia Reals Lra FunctionalExtensionality.
From Proved Require Import Rows Brouwer Homotopy.
From Proved Require Model.
Import ListNotations.
Open Scope R_scope.

(* ---- Lists ---- *)

(* Lists of one length, the numbers of which converge. *)
Inductive cv_list : (nat -> list R) -> list R -> Prop :=
  | cv_nil : cv_list (fun _ => []) []
  | cv_cons u x us xs : Un_cv u x -> cv_list us xs -> cv_list (fun k => u k :: us k) (x :: xs).

Lemma cv_list_constant xs : cv_list (fun _ => xs) xs.
Proof.
  induction xs as [|x xs IH]; [constructor|]. apply (cv_cons (fun _ => x)); [apply cv_constant|exact IH].
Qed.

Lemma cv_list_onward phi us xs : onward phi -> cv_list us xs -> cv_list (fun k => us (phi k)) xs.
Proof.
  intros P C. induction C as [|u x us xs U C IH]; [constructor|].
  apply (cv_cons (fun k => u (phi k))); [now apply cv_onward|exact IH].
Qed.

Lemma cv_list_length us xs k : cv_list us xs -> List.length (us k) = List.length xs.
Proof. intros C. induction C; cbn; auto. Qed.

Lemma cv_dot us xs vs ys : cv_list us xs -> cv_list vs ys -> Un_cv (fun k => dot (us k) (vs k)) (dot xs ys).
Proof.
  intros C. revert vs ys. induction C as [|u x us xs U C IH]; intros vs ys D; cbn; [apply cv_constant|].
  destruct D as [|v y vs ys V D]; cbn; [apply cv_constant|].
  apply (CV_plus (fun k => u k * v k)); [now apply CV_mult|now apply IH].
Qed.

Lemma cv_scaled c z us xs : Un_cv c z -> cv_list us xs -> cv_list (fun k => scaled (c k) (us k)) (scaled z xs).
Proof.
  intros Z C. induction C as [|u x us xs U C IH]; cbn; [constructor|].
  apply (cv_cons (fun k => c k * u k)); [now apply CV_mult|exact IH].
Qed.

Lemma cv_product ws us xs vs ys : cv_list us xs -> cv_list vs ys ->
  Un_cv (fun k => product ws (us k) (vs k)) (product ws xs ys).
Proof.
  intros C. revert ws vs ys. induction C as [|u x us xs U C IH]; intros ws vs ys D; destruct ws as [|w ws]; cbn;
    try apply cv_constant.
  destruct D as [|v y vs ys V D]; cbn; [apply cv_constant|].
  apply (CV_plus (fun k => w * u k * v k)); [|now apply IH].
  apply CV_mult; [now apply cv_multiple|exact V].
Qed.

Lemma cv_size ws us xs : positive ws -> cv_list us xs -> Un_cv (fun k => size ws (us k)) (size ws xs).
Proof. intros P C. apply cv_root; [intros k; now apply product_nonneg|now apply cv_product]. Qed.

(* Bolzano and Weierstrass. *)
Lemma cluster_list n us M : (forall k, List.length (us k) = n) ->
  (forall k, Forall (fun x => Rabs x <= M) (us k)) ->
  exists phi xs, onward phi /\ cv_list (fun k => us (phi k)) xs.
Proof.
  revert us. induction n as [|n IH]; intros us L B.
  - exists (fun k => k), []. split; [intros k; auto|].
    replace (fun k => us k) with (fun _ : nat => @nil R); [constructor|].
    apply functional_extensionality. intros k. specialize (L k). now destruct (us k).
  - destruct (cluster_number (fun k => hd 0 (us k)) M) as [phi P [x X]].
    { intros k. specialize (L k). specialize (B k). destruct (us k) as [|y ys]; [discriminate|].
      inversion B as [|? ? By _]; subst. cbn. unfold Rabs in By. destruct (Rcase_abs y); lra. }
    destruct (IH (fun k => tl (us (phi k)))) as (psi & xs & Q & C).
    + intros k. specialize (L (phi k)). destruct (us (phi k)); cbn in *; lia.
    + intros k. specialize (B (phi k)). destruct B; cbn; auto.
    + exists (fun k => phi (psi k)), (x :: xs). split.
      { intros k. specialize (P (psi k)). specialize (Q k). cbn. lia. }
      replace (fun k => us (phi (psi k))) with (fun k => hd 0 (us (phi (psi k))) :: tl (us (phi (psi k)))).
      * apply (cv_cons (fun k => hd 0 (us (phi (psi k))))); [|exact C].
        now apply (cv_onward psi (fun k => hd 0 (us (phi k)))).
      * apply functional_extensionality. intros k. specialize (L (phi (psi k))).
        destruct (us (phi (psi k))); [discriminate|reflexivity].
Qed.

(* The first n numbers of a vector. *)
Fixpoint listed (n : nat) (e : vec) : list R :=
  match n with O => [] | S n' => e O :: listed n' (fun i => e (S i)) end.

Lemma cv_listed n u x : converges n u x -> cv_list (fun k => listed n (u k)) (listed n x).
Proof.
  revert u x. induction n as [|n IH]; intros u x C; cbn; [constructor|].
  apply (cv_cons (fun k => u k O)); [apply C; lia|].
  apply (IH (fun k i => u k (S i))). intros i I. apply C. lia.
Qed.

Lemma length_listed n e : List.length (listed n e) = n.
Proof. revert e. induction n as [|n IH]; intros e; cbn; [reflexivity|]. now rewrite IH. Qed.

(* ---- Rows ---- *)

Record proper (D : nat) (r : row) : Prop := Proper {
  N_length : List.length (N r) = D;
  slips_length : Forall (fun s => List.length s = D) (slips r);
  weights_positive : positive (weights r);
  weights_length : List.length (weights r) = List.length (slips r);
  rho_nonneg : 0 <= rho r;
  spring_has_no_friction : spring r = true -> rho r = 0
}.

Inductive cv_lists : (nat -> list (list R)) -> list (list R) -> Prop :=
  | cv_lists_nil : cv_lists (fun _ => []) []
  | cv_lists_cons u x us xs : cv_list u x -> cv_lists us xs -> cv_lists (fun k => u k :: us k) (x :: xs).

(* Rows of one shape, the numbers of which converge. *)
Record cv_row (rs : nat -> row) (r : row) : Prop := CvRow {
  cv_N : cv_list (fun k => N (rs k)) (N r);
  cv_slips : cv_lists (fun k => slips (rs k)) (slips r);
  same_weights : forall k, weights (rs k) = weights r;
  cv_rho : Un_cv (fun k => rho (rs k)) (rho r);
  cv_preload : Un_cv (fun k => preload (rs k)) (preload r);
  cv_growth : Un_cv (fun k => growth (rs k)) (growth r);
  cv_stiffness : Un_cv (fun k => stiffness (rs k)) (stiffness r);
  same_spring : forall k, spring (rs k) = spring r
}.

Inductive cv_rows : (nat -> list row) -> list row -> Prop :=
  | cv_rows_nil : cv_rows (fun _ => []) []
  | cv_rows_cons u x us xs : cv_row u x -> cv_rows us xs -> cv_rows (fun k => u k :: us k) (x :: xs).

Lemma cv_lists_onward phi us xs : onward phi -> cv_lists us xs -> cv_lists (fun k => us (phi k)) xs.
Proof.
  intros P C. induction C as [|u x us xs U C IH]; [constructor|].
  apply (cv_lists_cons (fun k => u (phi k))); [now apply cv_list_onward|exact IH].
Qed.

Lemma cv_row_onward phi rs r : onward phi -> cv_row rs r -> cv_row (fun k => rs (phi k)) r.
Proof.
  intros P [C1 C2 C3 C4 C5 C6 C7 C8]. constructor; auto.
  - now apply (cv_list_onward phi (fun k => N (rs k))).
  - now apply (cv_lists_onward phi (fun k => slips (rs k))).
  - now apply (cv_onward phi (fun k => rho (rs k))).
  - now apply (cv_onward phi (fun k => preload (rs k))).
  - now apply (cv_onward phi (fun k => growth (rs k))).
  - now apply (cv_onward phi (fun k => stiffness (rs k))).
Qed.

Lemma cv_slip rs r ds d : cv_row rs r -> cv_list ds d -> cv_list (fun k => slip (rs k) (ds k)) (slip r d).
Proof.
  intros [_ C _ _ _ _ _ _] D. unfold slip.
  set (ss := fun k => slips (rs k)) in *. change (cv_list (fun k => map (fun f => dot f (ds k)) (ss k))
    (map (fun f => dot f d) (slips r))).
  induction C as [|u x us xs U C IH]; cbn; [constructor|].
  apply (cv_cons (fun k => dot (u k) (ds k))); [now apply cv_dot|exact IH].
Qed.

Lemma cv_v rs r ds d hs h ls l : cv_row rs r -> cv_list ds d -> Un_cv hs h -> Un_cv ls l ->
  Un_cv (fun k => v (rs k) (ds k) (hs k) (ls k)) (v r d h l).
Proof.
  intros C D H L. destruct C. unfold v.
  apply (CV_minus (fun k => preload (rs k) * hs k + growth (rs k) * ls k)).
  - apply (CV_plus (fun k => preload (rs k) * hs k)); now apply CV_mult.
  - apply (CV_mult (fun k => stiffness (rs k))); [assumption|now apply cv_dot].
Qed.

(* ---- Forces ---- *)

Definition pressed (r : row) (d : list R) (h l : R) : R :=
  if spring r then v r d h l else Rmax 0 (v r d h l).

(* Shorter than 1 where the slip is shorter than eps, and else of the length 1. *)
Definition way (eps : R) (r : row) (d : list R) : list R :=
  scaled (/ Rmax (size (weights r) (slip r d)) eps) (slip r d).

(* Friction of the size rho a against the slip, and less where the slip is shorter than eps. *)
Definition smooth_force (eps : R) (d : list R) (h l : R) (r : row) : force :=
  (pressed r d h l, scaled (- (rho r * pressed r d h l)) (way eps r d)).

Lemma cv_pressed rs r ds d hs h ls l : cv_row rs r -> cv_list ds d -> Un_cv hs h -> Un_cv ls l ->
  Un_cv (fun k => pressed (rs k) (ds k) (hs k) (ls k)) (pressed r d h l).
Proof.
  intros C D H L. unfold pressed. pose proof (cv_v _ _ _ _ _ _ _ _ C D H L) as V.
  replace (fun k => if spring (rs k) then _ else _) with
    (fun k => if spring r then v (rs k) (ds k) (hs k) (ls k) else Rmax 0 (v (rs k) (ds k) (hs k) (ls k)))
    by (apply functional_extensionality; intros k; now rewrite (same_spring _ _ C)).
  destruct (spring r); [exact V|]. apply cv_max; [apply cv_constant|exact V].
Qed.

(* What the cone allows is never below 0. *)
Lemma pressed_nonneg D r d h l : proper D r -> 0 <= rho r * pressed r d h l.
Proof.
  intros P. unfold pressed. destruct (spring r) eqn:S.
  - rewrite (spring_has_no_friction _ _ P S). lra.
  - apply Rmult_le_pos; [apply (rho_nonneg _ _ P)|apply Rmax_l].
Qed.

Lemma cv_work rs r gs g as_ a y : cv_row rs r -> Un_cv as_ a -> cv_list gs g ->
  Un_cv (fun k => work (rs k) (as_ k, gs k) y) (work r (a, g) y).
Proof.
  intros C A G. unfold work; cbn [fst snd].
  apply (CV_plus (fun k => as_ k * dot (N (rs k)) y)).
  - apply CV_mult; [exact A|]. apply cv_dot; [apply (cv_N _ _ C)|apply cv_list_constant].
  - replace (fun k => product (weights (rs k)) (gs k) (slip (rs k) y))
      with (fun k => product (weights r) (gs k) (slip (rs k) y))
      by (apply functional_extensionality; intros k; now rewrite (same_weights _ _ C)).
    apply cv_product; [exact G|]. apply (cv_slip _ _ (fun _ => y)); [exact C|apply cv_list_constant].
Qed.

(* The work of all such forces on y. *)
Fixpoint smooth_works (eps : R) (d : list R) (h l : R) (rs : list row) (y : list R) : R :=
  match rs with
  | [] => 0
  | r :: rs' => work r (smooth_force eps d h l r) y + smooth_works eps d h l rs' y
  end.

(* At a given eps this work is continuous. *)
Theorem works_continuous eps D us rs ds d hs h ls l y : 0 < eps -> cv_rows us rs -> Forall (proper D) rs ->
  cv_list ds d -> Un_cv hs h -> Un_cv ls l ->
  Un_cv (fun k => smooth_works eps (ds k) (hs k) (ls k) (us k) y) (smooth_works eps d h l rs y).
Proof.
  intros E C P Dd H L. induction C as [|u r us rs U C IH]; cbn [smooth_works]; [apply cv_constant|].
  inversion P as [|? ? Pr Ps]; subst.
  apply (CV_plus (fun k => work (u k) (smooth_force eps (ds k) (hs k) (ls k) (u k)) y)); [|now apply IH].
  pose proof (cv_pressed _ _ _ _ _ _ _ _ U Dd H L) as A.
  apply (cv_work _ _ (fun k => scaled _ (way eps (u k) (ds k)))); [exact U|exact A|].
  pose proof (cv_slip _ _ _ _ U Dd) as S. apply cv_scaled.
  - apply (cv_lipschitz Ropp (fun k => rho (u k) * pressed (u k) (ds k) (hs k) (ls k))).
    + intros a b. right. rewrite <- Rabs_Ropp. f_equal. ring.
    + apply CV_mult; [apply (cv_rho _ _ U)|exact A].
  - unfold way. apply cv_scaled; [|exact S].
    apply (cv_inverse (fun k => Rmax (size (weights (u k)) (slip (u k) (ds k))) eps)).
    + pose proof (Rmax_r (size (weights r) (slip r d)) eps). lra.
    + apply cv_max; [|apply cv_constant].
      replace (fun k => size (weights (u k)) (slip (u k) (ds k))) with (fun k => size (weights r) (slip (u k)
        (ds k)))
        by (apply functional_extensionality; intros k; now rewrite (same_weights _ _ U)).
      apply cv_size; [apply (weights_positive _ _ Pr)|exact S].
Qed.

(* ---- Limits of forces ---- *)

Lemma bounded_by_size ws : positive ws -> exists M, forall s, List.length s = List.length ws ->
  product ws s s <= 1 -> Forall (fun x => Rabs x <= M) s.
Proof.
  intros P. induction P as [|w ws Pw P IH].
  - exists 0. intros [|x s] L; [constructor|discriminate].
  - destruct IH as (M & HM). exists (Rmax (1 + / w) M). intros [|x s] L Q; [discriminate|]. cbn in Q.
    injection L as L. pose proof (product_nonneg ws s P) as Nn.
    assert (X : 0 <= w * x * x) by (replace (w * x * x) with (w * (x * x)) by ring; pose proof (Rle_0_sqr x);
      unfold Rsqr in *; apply Rmult_le_pos; lra).
    constructor.
    + eapply Rle_trans; [|apply Rmax_l]. pose proof (Rinv_0_lt_compat w Pw) as I.
      assert (W : w * / w = 1) by (apply Rinv_r; lra).
      apply Rabs_le. split; apply Rnot_lt_le; intros Lt; nra.
    + apply Forall_impl with (fun y => Rabs y <= M).
      * intros y Hy. eapply Rle_trans; [exact Hy|apply Rmax_r].
      * apply HM; [exact L|lra].
Qed.

Lemma way_short eps r d : positive (weights r) -> 0 < eps -> product (weights r) (way eps r d) (way eps r d) <= 1.
Proof.
  intros P E. unfold way. set (s := slip r d). set (m := Rmax (size (weights r) s) eps).
  rewrite product_scaled, product_sym, product_scaled. rewrite <- (size_square _ _ P). fold s.
  pose proof (Rmax_l (size (weights r) s) eps) as M1. pose proof (Rmax_r (size (weights r) s) eps) as M2. fold
    m in M1, M2.
  pose proof (size_nonneg (weights r) s) as Z.
  assert (I : / m * m = 1) by (apply Rinv_l; lra). pose proof (Rinv_0_lt_compat m ltac:(lra)) as Ip.
  set (z := size (weights r) s) in *. set (i := / m) in *.
  assert (0 <= i * z <= 1) by nra. nra.
Qed.

Lemma way_along eps r d : 0 < eps -> scaled (Rmax (size (weights r) (slip r d)) eps) (way eps r d) = slip r d.
Proof.
  intros E. unfold way. pose proof (Rmax_r (size (weights r) (slip r d)) eps). unfold scaled. rewrite map_map.
  transitivity (map (fun x => x) (slip r d)); [|apply map_id]. apply map_ext. intros x. field. lra.
Qed.

(* As eps goes to 0, forces of a contact have a limit, perhaps of a subsequence, that obeys the law. *)
Lemma row_limit D eps rs r ds d hs h ls l : (forall k, 0 < eps k) -> Un_cv eps 0 ->
  cv_row rs r -> proper D r -> cv_list ds d -> Un_cv hs h -> Un_cv ls l ->
  exists phi f, onward phi /\ obeys Model.unilateral d h l r f /\
    forall y, Un_cv (fun k => work (rs (phi k)) (smooth_force (eps (phi k)) (ds (phi k)) (hs (phi k)) (ls (phi k))
      (rs (phi k))) y) (work r f y).
Proof.
  intros E E0 C P Dd H L. set (ways := fun k => way (eps k) (rs k) (ds k)).
  pose proof (weights_positive _ _ P) as W.
  destruct (bounded_by_size (weights r) W) as (M & HM).
  pose proof (cv_slip _ _ _ _ C Dd) as S.
  destruct (cluster_list (List.length (slips r)) ways M) as (phi & w & O & Cw).
  { intros k. pose proof (cv_list_length _ _ k S) as Len. unfold ways, way, scaled. rewrite map_length, Len.
    unfold slip. now rewrite map_length. }
  { intros k. apply HM.
    - pose proof (cv_list_length _ _ k S) as Len. unfold ways, way, scaled. rewrite map_length, Len.
      unfold slip. rewrite map_length. symmetry. apply (weights_length _ _ P).
    - rewrite <- (same_weights _ _ C k). apply way_short; [|apply E]. now rewrite (same_weights _ _ C). }
  set (a := pressed r d h l). exists phi, (a, scaled (- (rho r * a)) w).
  pose proof (cv_pressed _ _ _ _ _ _ _ _ C Dd H L) as A.
  pose proof (pressed_nonneg D r d h l P) as Rn. fold a in Rn.
  assert (Short : product (weights r) w w <= 1).
  { apply (cv_at_most (fun k => product (weights r) (ways (phi k)) (ways (phi k)))); [|now apply cv_product].
    intros k. rewrite <- (same_weights _ _ C (phi k)). apply way_short; [|apply E]. now rewrite (same_weights _
      _ C). }
  assert (Sw : size (weights r) w <= 1).
  { rewrite <- sqrt_1. now apply sqrt_le_1_alt. }
  (* In the limit |s| w = s. *)
  set (s := slip r d) in *. set (z := size (weights r) s).
  assert (Along : z * product (weights r) w s = z * z).
  { transitivity (product (weights r) s s); [|symmetry; now apply size_square].
    assert (G : Un_cv (fun k => Rmax (size (weights r) (slip (rs (phi k)) (ds (phi k)))) (eps (phi k)) *
        product (weights r) (ways (phi k)) (slip (rs (phi k)) (ds (phi k)))) (z * product (weights r) w s)).
    { pose proof (cv_list_onward phi _ _ O S) as So. apply CV_mult; [|now apply cv_product].
      replace z with (Rmax z 0) by (apply Rmax_left, size_nonneg).
      apply cv_max; [now apply cv_size|now apply cv_onward]. }
    eapply cv_unique; [exact G|].
    replace (fun k => _) with (fun k => product (weights r) (slip (rs (phi k)) (ds (phi k))) (slip (rs (phi k))
      (ds (phi k)))).
    - pose proof (cv_list_onward phi _ _ O S) as So. now apply cv_product.
    - apply functional_extensionality. intros k. rewrite <- product_scaled. f_equal.
      rewrite <- (same_weights _ _ C (phi k)). symmetry. apply way_along, E. }
  split; [exact O|]. split.
  - unfold obeys. split; [|split].
    + unfold normal_law, a, pressed. destruct (spring r); reflexivity.
    + replace (- (rho r * a)) with ((rho r * a) * -1) by ring.
      assert (Eq : size (weights r) (scaled (rho r * a * -1) w) = rho r * a * size (weights r) w).
      { rewrite <- size_scaled by assumption. unfold size. f_equal.
        rewrite !product_scaled, (product_sym _ w), (product_sym _ w (scaled _ _)), !product_scaled. ring. }
      rewrite Eq. nra.
    + rewrite product_scaled. f_equal. fold s. fold z.
      destruct (Req_dec z 0) as [Z|Z]; [rewrite Z; rewrite product_sym; now apply size_zero|].
      now apply Rmult_eq_reg_l with z.
  - intros y. apply (cv_work (fun k => rs (phi k)) r
      (fun k => scaled (- (rho (rs (phi k)) * pressed (rs (phi k)) (ds (phi k)) (hs (phi k)) (ls (phi k))))
        (ways (phi k)))
      _ (fun k => pressed (rs (phi k)) (ds (phi k)) (hs (phi k)) (ls (phi k)))).
    + now apply cv_row_onward.
    + now apply (cv_onward phi (fun k => pressed (rs k) (ds k) (hs k) (ls k))).
    + apply cv_scaled; [|exact Cw].
      apply (cv_lipschitz Ropp (fun k => rho (rs (phi k)) * pressed (rs (phi k)) (ds (phi k)) (hs (phi k)) (ls
        (phi k)))).
      * intros p q. right. rewrite <- Rabs_Ropp. f_equal. ring.
      * apply (cv_onward phi (fun k => rho (rs k) * pressed (rs k) (ds k) (hs k) (ls k))); [exact O|].
        apply CV_mult; [apply (cv_rho _ _ C)|exact A].
Qed.

(* So have those of all contacts together. *)
Theorem works_limit D eps us rs ds d hs h ls l : (forall k, 0 < eps k) -> Un_cv eps 0 ->
  cv_rows us rs -> Forall (proper D) rs -> cv_list ds d -> Un_cv hs h -> Un_cv ls l ->
  exists phi fs, onward phi /\ Forall2 (obeys Model.unilateral d h l) rs fs /\
    forall y, Un_cv (fun k => smooth_works (eps (phi k)) (ds (phi k)) (hs (phi k)) (ls (phi k)) (us (phi k)) y)
      (works rs fs y).
Proof.
  intros E E0 C. revert eps ds hs ls E E0. induction C as [|u r us rs U C IH]; intros eps ds hs ls E E0 P Dd H L.
  - exists (fun k => k), []. split; [intros k; auto|]. split; [constructor|]. intros y. exact (cv_constant 0).
  - inversion P as [|? ? Pr Ps]; subst.
    destruct (IH eps ds hs ls E E0 Ps Dd H L) as (psi & fs & Q & F & Wf).
    destruct (row_limit D (fun k => eps (psi k)) (fun k => u (psi k)) r (fun k => ds (psi k)) d
      (fun k => hs (psi k)) h (fun k => ls (psi k)) l) as (phi & f & O & Ob & Wr); try assumption.
    + intros k. apply E.
    + now apply cv_onward.
    + now apply cv_row_onward.
    + now apply cv_list_onward.
    + now apply cv_onward.
    + now apply cv_onward.
    + exists (fun k => psi (phi k)), (f :: fs). split.
      { intros k. specialize (Q (phi k)). specialize (O k). cbn. lia. }
      split; [now constructor|]. intros y. cbn [smooth_works works].
      apply (CV_plus (fun k => work (u (psi (phi k))) _ y)); [apply Wr|].
      apply (cv_onward phi (fun k => smooth_works (eps (psi k)) (ds (psi k)) (hs (psi k)) (ls (psi k)) (us (psi
        k)) y));
        [exact O|apply Wf].
Qed.
