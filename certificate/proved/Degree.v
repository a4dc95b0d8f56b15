(* SPDX-License-Identifier: MIT *)
(* Stable by degree (FORMAT.md section 6), for rows in R^D over the reals: `stable_by_degree`.  Systems change
   continuously from a middle one, at the time 0, to the one in question, at the time 1, and so does the motion
   about which there is a bounded set K of motions.  If on the walls of K no system on the way has an
   equilibrium, and the forces of the middle one are never a multiple of A e, then the system in question has an
   equilibrium in K. *)
From Coq Require Import List Arith Lia Reals Lra FunctionalExtensionality.
From Proved Require Import Rows Brouwer Homotopy RowLimits.
From Proved Require Model.
Import ListNotations.
Open Scope R_scope.

(* ---- Sums and unit vectors ---- *)

Fixpoint sum_to (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S n' => f O + sum_to n' (fun i => f (S i)) end.

(* 1 at i, of n numbers. *)
Fixpoint basis_vector (n i : nat) : list R :=
  match n with
  | O => []
  | S n' => match i with O => 1 :: repeat 0 n' | S i' => 0 :: basis_vector n' i' end
  end.

Lemma sum_same n f g : (forall i, (i < n)%nat -> f i = g i) -> sum_to n f = sum_to n g.
Proof.
  revert f g. induction n as [|n IH]; intros f g H; cbn; [reflexivity|].
  rewrite (H O) by lia. f_equal. apply IH. intros i I. apply H. lia.
Qed.

Lemma sum_plus n f g : sum_to n (fun i => f i + g i) = sum_to n f + sum_to n g.
Proof. revert f g. induction n as [|n IH]; intros f g; cbn; [ring|]. rewrite (IH (fun i => f (S i))). ring. Qed.

Lemma sum_multiple n c f : sum_to n (fun i => c * f i) = c * sum_to n f.
Proof. revert f. induction n as [|n IH]; intros f; cbn; [ring|]. rewrite (IH (fun i => f (S i))). ring. Qed.

Lemma sum_zero n f : (forall i, (i < n)%nat -> f i = 0) -> sum_to n f = 0.
Proof.
  intros H. rewrite (sum_same n f (fun _ => 0 * 0)) by (intros; rewrite H by assumption; ring).
  rewrite sum_multiple. ring.
Qed.

Lemma dot_nil a : dot a [] = 0.
Proof. now destruct a. Qed.

Lemma dot_zeros a n : dot a (repeat 0 n) = 0.
Proof. revert n. induction a as [|x a IH]; intros [|n]; cbn; try ring. rewrite IH. ring. Qed.

Lemma dot_unit a n i : (i < n)%nat -> dot a (basis_vector n i) = nth i a 0.
Proof.
  revert n i. induction a as [|x a IH]; intros [|n] [|i] I; cbn; try lia; try reflexivity.
  - rewrite dot_zeros. ring.
  - rewrite IH by lia. ring.
Qed.

(* The same product, number by number. *)
Lemma dot_by_numbers n a y : List.length a = n -> dot a y = sum_to n (fun i => nth i y 0 * nth i a 0).
Proof.
  revert a y. induction n as [|n IH]; intros [|x a] y L; try discriminate; cbn; [reflexivity|].
  injection L as L. destruct y as [|z y]; cbn.
  - rewrite sum_zero; [ring|]. intros; ring.
  - rewrite (IH a y L). ring.
Qed.

Lemma nth_listed n e i : (i < n)%nat -> nth i (listed n e) 0 = e i.
Proof.
  revert e i. induction n as [|n IH]; intros e [|i] I; cbn; try lia; [reflexivity|].
  now rewrite (IH (fun j => e (S j))) by lia.
Qed.

Lemma dot_sym a b : dot a b = dot b a.
Proof. revert b. induction a as [|x a IH]; intros [|y b]; cbn; try reflexivity. rewrite IH. ring. Qed.

(* Works are known by those on the n unit vectors. *)
Definition known_by_units (n : nat) (f : list R -> R) := forall y, f y = sum_to n (fun i => nth i y 0 * f
  (basis_vector n i)).

Lemma dot_known n a : List.length a = n -> known_by_units n (dot a).
Proof.
  intros L y. rewrite (dot_by_numbers n a y L). apply sum_same. intros i I. now rewrite dot_unit.
Qed.

Lemma known_plus n f g : known_by_units n f -> known_by_units n g -> known_by_units n (fun y => f y + g y).
Proof.
  intros F G y. rewrite (F y), (G y), <- sum_plus. apply sum_same. intros; ring.
Qed.

Lemma known_multiple n c f : known_by_units n f -> known_by_units n (fun y => c * f y).
Proof. intros F y. rewrite (F y), <- sum_multiple. apply sum_same. intros; ring. Qed.

Lemma known_zero n : known_by_units n (fun _ => 0).
Proof. intros y. rewrite sum_zero; [reflexivity|]. intros; ring. Qed.

(* What a force of a contact does, is. *)
Lemma work_known n r f : proper n r -> known_by_units n (work r f).
Proof.
  intros P. unfold work. apply known_plus.
  - apply known_multiple, dot_known, (N_length _ _ P).
  - unfold slip. pose proof (slips_length _ _ P) as L. generalize (weights r) (snd f).
    induction L as [|s ss Ls L IH]; intros ws g; cbn.
    + intros y. rewrite sum_zero; [now destruct ws, g|]. intros i _. destruct ws, g; cbn; ring.
    + destruct ws as [|w ws], g as [|x g]; try apply known_zero.
      apply (known_plus n (fun y => w * x * dot s y)); [|apply IH]. apply known_multiple, dot_known, Ls.
Qed.

(* And so is the work of all. *)
Lemma smooth_works_known n eps d h l rs : Forall (proper n) rs -> known_by_units n (smooth_works eps d h l rs).
Proof.
  intros P. induction P as [|r rs Pr P IH]; cbn; [apply known_zero|].
  apply known_plus; [now apply work_known|exact IH].
Qed.

(* ---- Matrices, by their rows ---- *)

Definition times (m : list (list R)) (e : list R) : list R := map (fun r => dot r e) m.

(* y.(sum of z z^T) e *)
Definition spread (zs : list (list R)) (y e : list R) : R := fold_right (fun z s => dot z y * dot z e + s) 0 zs.

Lemma times_length m e : List.length (times m e) = List.length m.
Proof. apply map_length. Qed.

Lemma times_scaled m c e : times m (scaled c e) = scaled c (times m e).
Proof.
  unfold times, scaled. rewrite map_map. apply map_ext. intros r. rewrite dot_sym.
  change (map (Rmult c) e) with (scaled c e). now rewrite dot_scaled, dot_sym.
Qed.

Lemma spread_known D zs e : Forall (fun z => List.length z = D) zs -> known_by_units D (fun y => spread zs y e).
Proof.
  intros F. unfold spread. induction F as [|z zs L F IH]; cbn; [apply known_zero|].
  apply (known_plus D (fun y => dot z y * dot z e)); [|exact IH].
  intros y. rewrite (dot_known D z L y), Rmult_comm, <- sum_multiple. apply sum_same. intros; ring.
Qed.

(* What has no length has no product with anything. *)
Lemma dot_self_zero a y : dot a a = 0 -> dot a y = 0.
Proof.
  revert y. induction a as [|x a IH]; intros [|t y]; cbn; try reflexivity. intros H.
  assert (P : 0 <= dot a a).
  { clear. induction a as [|x a IH]; cbn; [lra|]. pose proof (Rle_0_sqr x). unfold Rsqr in *. lra. }
  pose proof (Rle_0_sqr x) as Q. unfold Rsqr in Q.
  assert (x = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). rewrite IH by lra. subst x. ring.
Qed.

(* A sum of multiples of vectors that is across all of them is 0. *)
Lemma spread_zero zs e : (forall z, In z zs -> spread zs z e = 0) ->
  Forall (fun z => dot z e = 0) zs /\ forall y, spread zs y e = 0.
Proof.
  intros H. set (sum := fold_right (fun z s => plus (scaled (dot z e) z) s) [] zs).
  assert (E : forall y, spread zs y e = dot sum y).
  { intros y. unfold sum, spread. clear H sum. induction zs as [|z zs' IH]; cbn; [reflexivity|].
    rewrite dot_plus, dot_scaled, IH. ring. }
  assert (Z : forall y, spread zs y e = 0).
  { intros y. rewrite E. apply dot_self_zero. rewrite <- E.
    assert (G : Forall (fun z => dot z sum = 0) zs).
    { apply Forall_forall. intros z Hz. rewrite dot_sym, <- E. auto. }
    unfold spread. generalize sum G. clear. intros f G. induction G as [|z zs Hz G IH]; cbn; [reflexivity|].
      rewrite Hz, IH. ring. }
  split; [|exact Z]. specialize (Z e). unfold spread in Z. clear H sum E.
  assert (P : forall ws, 0 <= fold_right (fun z s => dot z e * dot z e + s) 0 ws).
  { clear. induction ws as [|z ws IH]; cbn; [lra|]. pose proof (Rle_0_sqr (dot z e)). unfold Rsqr in *. lra. }
  induction zs as [|z zs' IH]; constructor; cbn in Z; specialize (P zs'); pose proof (Rle_0_sqr (dot z e)) as Q;
    unfold Rsqr in Q.
  - apply Rsqr_0_uniq. unfold Rsqr. lra.
  - apply IH. lra.
Qed.

Lemma nth_scaled c a i : nth i (scaled c a) 0 = c * nth i a 0.
Proof. rewrite <- (map_nth (Rmult c)). unfold scaled. now rewrite Rmult_0_r. Qed.

Lemma dot_listed_zero f n : dot f (listed n (fun _ => 0)) = 0.
Proof. revert n. induction f as [|x f IH]; intros [|n]; cbn; try reflexivity. rewrite IH. ring. Qed.

Lemma times_zero m n j : nth j (times m (listed n (fun _ => 0))) 0 = 0.
Proof.
  revert j. induction m as [|r m IH]; intros [|j]; cbn; try reflexivity; [apply dot_listed_zero|apply IH].
Qed.

Lemma cv_nth u x i : cv_list u x -> Un_cv (fun k => nth i (u k) 0) (nth i x 0).
Proof.
  intros C. revert i. induction C as [|u x us xs U C IH]; intros [|i]; cbn; try apply cv_constant; auto.
Qed.

Lemma cv_times m u x : cv_list u x -> cv_list (fun k => times m (u k)) (times m x).
Proof.
  intros C. unfold times. induction m as [|r m IH]; cbn; [constructor|].
  apply (cv_cons (fun k => dot r (u k))); [|exact IH].
  apply (cv_dot (fun _ => r)); [apply cv_list_constant|exact C].
Qed.

Lemma cv_spread zs y u x : cv_list u x -> Un_cv (fun k => spread zs y (u k)) (spread zs y x).
Proof.
  intros C. unfold spread. induction zs as [|z zs IH]; cbn; [apply cv_constant|].
  apply (CV_plus (fun k => dot z y * dot z (u k))); [|exact IH]. apply cv_multiple.
  apply (cv_dot (fun _ => z)); [apply cv_list_constant|exact C].
Qed.

(* ---- The homotopy of the law ---- *)

Section Degree.
Variable D : nat.

(* At the time t: a system under a law of both sides or one, here taken for unilateral, at the point
   (middle + e, h, l). *)
Variable system_at : R -> system.
Variable h l : R -> R.
Variable middle : R -> list R.

Definition motion (t : R) (e : vec) : list R := listed D (fun i => nth i (middle t) 0 + e i).

Hypothesis all_proper : forall t, Forall (proper D) (rows (system_at t)).
Hypothesis loads_length : forall t, List.length (wrench (system_at t)) = D /\ List.length (direction (system_at
  t)) = D.
Hypothesis systems_continuous : forall s s', (forall k, 0 <= s k <= 1) -> Un_cv s s' ->
  cv_rows (fun k => rows (system_at (s k))) (rows (system_at s')) /\
  cv_list (fun k => wrench (system_at (s k))) (wrench (system_at s')) /\
  cv_list (fun k => direction (system_at (s k))) (direction (system_at s')) /\
  Un_cv (fun k => h (s k)) (h s') /\ Un_cv (fun k => l (s k)) (l s') /\
  (forall i, (i < D)%nat -> Un_cv (fun k => nth i (middle (s k)) 0) (nth i (middle s') 0)).

(* K, and the free motions, along which it has no end. *)
Variable walls : list (list R).
Variable free : list (list R).
Definition in_K (e : list R) := Forall (fun f => dot f e <= 1) walls.

Variable B : vec.
Hypothesis K_bounded : forall e, in_K (listed D e) -> Forall (fun z => -1 <= dot z (listed D e) <= 1) free ->
  in_box D B e.

(* A by its rows; and M, which is A with z z^T for each free motion added, has an inverse. *)
Variable A : list (list R).
Hypothesis A_rows : List.length A = D.
Hypothesis free_length : Forall (fun z => List.length z = D) free.

Variable M inverse : list (list R).
Hypothesis M_is : forall e y, List.length e = D -> dot y (times M e) = dot y (times A e) + spread free y e.
Hypothesis M_rows : List.length M = D.
Hypothesis inverse_rows : List.length inverse = D.
Hypothesis inverse_left : forall e, List.length e = D -> times inverse (times M e) = e.
Hypothesis inverse_right : forall f, List.length f = D -> times M (times inverse f) = f.

(* No force and no load does work on a free motion. *)
Hypothesis load_free : forall t z, In z free -> load (system_at t) (h t) (l t) z = 0.
Hypothesis rows_free : forall t z, In z free -> Forall (fun r => dot (N r) z = 0 /\
  (rho r = 0 \/ Forall (fun s => dot s z = 0) (slips r))) (rows (system_at t)).
Hypothesis A_free : forall z e, In z free -> dot z (times A (listed D e)) = 0.

Definition total_work (t : R) (fs : list force) (y : list R) : R :=
  load (system_at t) (h t) (l t) y + works (rows (system_at t)) fs y.

Definition forces_obey (t : R) (e : vec) (fs : list force) :=
  Forall2 (obeys Model.unilateral (motion t e) (h t) (l t)) (rows (system_at t)) fs.

(* On one wall or more, and not beyond any. *)
Definition on_wall (e : vec) := in_K (listed D e) /\ Exists (fun f => dot f (listed D e) = 1) walls.

Hypothesis middle_holds : forall e fs c, on_wall e -> forces_obey 0 e fs -> 0 <= c ->
  (forall y, total_work 0 fs y = c * dot y (times A (listed D e))) -> False.
Hypothesis way_holds : forall t e fs, 0 < t <= 1 -> on_wall e -> forces_obey t e fs ->
  (forall y, total_work t fs y = 0) -> False.

(* The walls of K, and those that make it bounded. *)
Definition all_walls : list (list R) := walls ++ free ++ map (scaled (-1)) free.

(* How far e is from the walls, at most 1; below 0 beyond one of them. *)
Definition gap (e : vec) : R := fold_right (fun f m => Rmin (1 - dot f (listed D e)) m) 1 all_walls.

(* What it says of each wall. *)
Lemma gap_least e c : c <= gap e <-> c <= 1 /\ Forall (fun f => dot f (listed D e) <= 1 - c) all_walls.
Proof.
  unfold gap. induction all_walls as [|f fs IH]; cbn.
  - split; [auto|tauto].
  - split.
    + intros H. pose proof (Rmin_l (1 - dot f (listed D e)) (fold_right (fun f m => Rmin (1 - dot f (listed D
        e)) m) 1 fs)).
      pose proof (Rmin_r (1 - dot f (listed D e)) (fold_right (fun f m => Rmin (1 - dot f (listed D e)) m) 1 fs)).
      destruct IH as [IH _]. destruct IH as [I1 I2]; [lra|]. split; [exact I1|]. constructor; [lra|exact I2].
    + intros [C F]. inversion F; subst. apply Rmin_glb; [lra|]. now apply IH.
Qed.

Lemma gap_zero e : gap e = 0 -> Exists (fun f => dot f (listed D e) = 1) all_walls.
Proof.
  unfold gap. induction all_walls as [|f fs IH]; cbn; [lra|]. intros H.
  unfold Rmin in H. destruct (Rle_dec _ _) in H; [left; lra|right; auto].
Qed.

Lemma gap_in_K e c : 0 <= c -> c <= gap e ->
  in_K (listed D e) /\ Forall (fun z => -1 <= dot z (listed D e) <= 1) free.
Proof.
  intros C H. apply gap_least in H as [_ H]. unfold all_walls in H. rewrite !Forall_app in H.
  destruct H as (H1 & H2 & H3). split.
  - eapply Forall_impl; [|exact H1]. cbn. intros; lra.
  - rewrite Forall_map in H3. rewrite Forall_forall in *. intros z Hz. specialize (H2 z Hz). specialize (H3 z Hz).
    rewrite dot_scaled in H3. lra.
Qed.

Lemma gap_cv u x : converges D u x -> Un_cv (fun k => gap (u k)) (gap x).
Proof.
  intros C. apply cv_listed in C. unfold gap. induction all_walls as [|f fs IH]; cbn; [apply cv_constant|].
  apply (cv_min (fun k => 1 - dot f (listed D (u k)))); [|exact IH].
  apply (CV_minus (fun _ => 1)); [apply cv_constant|]. apply (cv_dot (fun _ => f)); [apply
    cv_list_constant|exact C].
Qed.

(* Times from 0 to 1 turn -A e into the forces of the middle system; those from 1 to 2 are one later. *)
Definition portion (s : R) : R := Rmin 1 s.
(* The time of the systems that is meant. *)
Definition later (s : R) : R := Rmax 0 (s - 1).

(* What all forces together do of work on y, and what was added to A takes. *)
Definition net (k : nat) (s : R) (e : vec) (y : list R) : R :=
  portion s * (load (system_at (later s)) (h (later s)) (l (later s)) y +
               smooth_works (nth_part k) (motion (later s) e) (h (later s)) (l (later s)) (rows (system_at
                 (later s))) y) -
  ((1 - portion s) * dot y (times A (listed D e)) + spread free y (listed D e)).

(* Forces that obey the law at this time do no work in sum, with these. *)
Definition balance (s : R) (e : vec) : Prop := exists fs, forces_obey (later s) e fs /\
  forall y, portion s * total_work (later s) fs y -
    ((1 - portion s) * dot y (times A (listed D e)) + spread free y (listed D e)) = 0.

Lemma later_range s : 0 <= s <= 2 -> 0 <= later s <= 1.
Proof. intros H. unfold later, Rmax. destruct (Rle_dec 0 (s - 1)); lra. Qed.

Lemma net_known k s e : known_by_units D (net k s e).
Proof.
  intros y. unfold net. destruct (loads_length (later s)) as [L1 L2].
  assert (K1 : known_by_units D (fun y => portion s * (load (system_at (later s)) (h (later s)) (l (later s)) y +
     smooth_works (nth_part k) (motion (later s) e) (h (later s)) (l (later s)) (rows (system_at (later s))) y))).
  { apply known_multiple, known_plus; [|now apply smooth_works_known].
    unfold load. apply known_plus; now apply known_multiple, dot_known. }
  assert (K2 : known_by_units D (fun y => (1 - portion s) * dot (times A (listed D e)) y + spread free y
    (listed D e))).
  { apply known_plus; [|now apply spread_known]. apply known_multiple, dot_known. now rewrite times_length. }
  pose proof (known_plus D _ _ K1 (known_multiple D (-1) _ K2) y) as E. cbn beta in E.
  eapply eq_trans; [|eapply eq_trans; [exact E|]].
  - rewrite (dot_sym y). ring.
  - apply sum_same. intros i _. rewrite (dot_sym (basis_vector D i)). ring.
Qed.

Lemma cv_portion s s' : Un_cv s s' -> Un_cv (fun k => portion (s k)) (portion s').
Proof. intros S. apply cv_min; [apply cv_constant|exact S]. Qed.

Lemma cv_later s s' : Un_cv s s' -> Un_cv (fun k => later (s k)) (later s').
Proof.
  intros S. apply cv_max; [apply cv_constant|]. apply (CV_minus s); [exact S|apply cv_constant].
Qed.

(* If the work of contacts converges, so does what is left with the rest. *)
Lemma cv_net s s' e e' w w' y : (forall k, 0 <= s k <= 2) -> Un_cv s s' -> converges D e e' -> Un_cv w w' ->
  Un_cv (fun k => portion (s k) * (load (system_at (later (s k))) (h (later (s k))) (l (later (s k))) y + w k) -
      ((1 - portion (s k)) * dot y (times A (listed D (e k))) + spread free y (listed D (e k))))
    (portion s' * (load (system_at (later s')) (h (later s')) (l (later s')) y + w') -
      ((1 - portion s') * dot y (times A (listed D e')) + spread free y (listed D e'))).
Proof.
  intros Rg S E W. pose proof (cv_portion _ _ S) as P. apply cv_listed in E.
  destruct (systems_continuous (fun k => later (s k)) (later s')) as (_ & Cw & Cu & Ch & Cl & _).
  { intros k. now apply later_range. }
  { now apply cv_later. }
  apply CV_minus.
  - apply (CV_mult (fun k => portion (s k))); [exact P|]. apply CV_plus; [|exact W]. unfold load.
    apply CV_plus; apply CV_mult; try assumption;
      (apply (cv_dot (fun k => _ (system_at (later (s k)))) _ (fun _ => y)); [assumption|apply cv_list_constant]).
  - apply CV_plus; [|now apply cv_spread]. apply CV_mult.
    + apply (CV_minus (fun _ => 1)); [apply cv_constant|exact P].
    + apply (cv_dot (fun _ => y)); [apply cv_list_constant|now apply cv_times].
Qed.

Lemma cv_motion s s' e e' : (forall k, 0 <= s k <= 2) -> Un_cv s s' -> converges D e e' ->
  cv_list (fun k => motion (later (s k)) (e k)) (motion (later s') e').
Proof.
  intros Rg S E. destruct (systems_continuous (fun k => later (s k)) (later s')) as (_ & _ & _ & _ & _ & Cm).
  { intros k. now apply later_range. }
  { now apply cv_later. }
  unfold motion. apply (cv_listed D (fun k i => nth i (middle (later (s k))) 0 + e k i)).
  intros i I. apply CV_plus; [now apply Cm|now apply E].
Qed.

(* The work is continuous in time and motion. *)
Lemma net_continuous k y s s' e e' : (forall m, 0 <= s m <= 2) -> Un_cv s s' -> converges D e e' ->
  Un_cv (fun m => net k (s m) (e m) y) (net k s' e' y).
Proof.
  intros Rg S E. unfold net. apply cv_net; try assumption.
  destruct (systems_continuous (fun k => later (s k)) (later s')) as (Cr & _ & _ & Ch & Cl & _).
  { intros m. now apply later_range. }
  { now apply cv_later. }
  apply (works_continuous (nth_part k) D (fun m => rows (system_at (later (s m))))); try assumption.
  - apply nth_part_positive.
  - apply all_proper.
  - now apply cv_motion.
Qed.

(* Where smooth forces balance for smaller and smaller eps, in the limit forces of the law do. *)
Lemma balance_closed phi s s' e e' : onward phi -> Un_cv s s' -> converges D e e' -> (forall k, 0 <= s k <= 2) ->
  (forall k j, (j < D)%nat -> net (phi k) (s k) (e k) (basis_vector D j) = 0) -> balance s' e'.
Proof.
  intros P S E Rg Z.
  destruct (systems_continuous (fun k => later (s k)) (later s')) as (Cr & _ & _ & Ch & Cl & _).
  { intros m. now apply later_range. }
  { now apply cv_later. }
  destruct (works_limit D (fun k => nth_part (phi k)) (fun k => rows (system_at (later (s k))))
    (rows (system_at (later s'))) (fun k => motion (later (s k)) (e k)) (motion (later s') e')
    (fun k => h (later (s k))) (h (later s')) (fun k => l (later (s k))) (l (later s')))
    as (psi & fs & O & F & W); try assumption.
  - intros k. apply nth_part_positive.
  - apply (cv_onward phi nth_part); [exact P|apply cv_nth_part].
  - apply all_proper.
  - now apply cv_motion.
  - exists fs. split; [exact F|]. intros y. unfold total_work.
    pose proof (cv_net (fun k => s (psi k)) s' (fun k => e (psi k)) e' _ _ y (fun k => Rg (psi k))
      (cv_onward psi s s' O S) (converges_onward D psi e e' O E) (W y)) as L.
    eapply cv_unique; [exact L|].
    replace (fun k => _) with (fun _ : nat => 0); [apply cv_constant|].
    apply functional_extensionality. intros k.
    change (0 = net (phi (psi k)) (s (psi k)) (e (psi k)) y).
    rewrite (net_known _ _ _ y). symmetry. apply sum_zero. intros i I. rewrite Z by exact I. ring.
Qed.

(* Nothing does work on a free motion. *)
Lemma work_free t e fs z : In z free -> forces_obey t e fs -> total_work t fs z = 0.
Proof.
  intros Hz F. unfold total_work. rewrite (load_free t z Hz), Rplus_0_l.
  pose proof (rows_free t z Hz) as Z. pose proof (all_proper t) as P. unfold forces_obey in F.
  induction F as [|r [a g] rs fs O F IH]; cbn; [reflexivity|].
  inversion Z as [|? ? [Zn Zs] Zr]; subst. inversion P as [|? ? Pr Ps]; subst. rewrite IH by assumption.
  unfold work; cbn [fst snd]. rewrite Zn. destruct O as (_ & C & _).
  enough (product (weights r) g (slip r z) = 0) by lra. destruct Zs as [Zr0|Zs].
  - apply size_zero; [apply (weights_positive _ _ Pr)|]. pose proof (size_nonneg (weights r) g). rewrite Zr0 in
      C. lra.
  - unfold slip. clear C. revert g. generalize (weights r).
    induction Zs as [|s ss Hs Zs IHs]; intros ws g; destruct ws, g; cbn; try reflexivity.
    rewrite Hs, IHs. ring.
Qed.

(* What balances up to what was added to A has no part along the free motions, and balances. *)
Lemma no_free_part t e fs p c : forces_obey t e fs ->
  (forall y, p * total_work t fs y - (c * dot y (times A (listed D e)) + spread free y (listed D e)) = 0) ->
  Forall (fun z => dot z (listed D e) = 0) free /\ forall y, spread free y (listed D e) = 0.
Proof.
  intros F H. apply spread_zero. intros z Hz. specialize (H z).
  rewrite (work_free t e fs z Hz F), (A_free z e Hz) in H. lra.
Qed.

(* Without a part along free motions, the wall that e is on is one of K. *)
Lemma on_a_wall e : gap e = 0 -> Forall (fun z => dot z (listed D e) = 0) free -> on_wall e.
Proof.
  intros H Z. split.
  - apply (gap_in_K e 0); lra.
  - apply gap_zero in H. unfold all_walls in H. rewrite !Exists_app, Exists_map in H.
    rewrite Forall_forall in Z. destruct H as [H|[H|H]]; [exact H| |]; exfalso;
      apply Exists_exists in H as (z & Hz & E); specialize (Z z Hz); rewrite ?dot_scaled in E; lra.
Qed.

(* A e is not 0 on a wall. *)
Lemma M_not_zero e : on_wall e -> (forall y, dot y (times A (listed D e)) + spread free y (listed D e) = 0) ->
  False.
Proof.
  intros [_ W] H.
  assert (Z : forall i, (i < D)%nat -> nth i (times M (listed D e)) 0 = 0).
  { intros i I. rewrite <- (dot_unit _ D i I), dot_sym, M_is by apply length_listed. apply H. }
  assert (E : listed D e = scaled 0 (listed D e)).
  { rewrite <- (inverse_left (listed D e)) at 1 by apply length_listed.
    rewrite <- (inverse_left (scaled 0 (listed D e))) by (unfold scaled; now rewrite map_length, length_listed).
    f_equal. rewrite times_scaled. apply (nth_ext _ _ 0 0).
    - unfold scaled. now rewrite map_length.
    - rewrite times_length, M_rows. intros i I. rewrite (Z i I). unfold scaled.
      rewrite (nth_indep _ 0 (0 * 0)) by (now rewrite map_length, times_length, M_rows).
      rewrite (map_nth (Rmult 0)). ring. }
  apply Exists_exists in W as (f & _ & Hf). rewrite E, dot_sym, dot_scaled in Hf. lra.
Qed.

(* Whatever the time, nothing balances on a wall: at first A e does not, then the middle, then what is on the
   way. *)
Lemma no_balance_on_walls s e : 0 <= s <= 2 -> gap e = 0 -> ~ balance s e.
Proof.
  intros Rg I (fs & F & H). destruct (no_free_part _ _ _ _ _ F H) as [Z Sp]. pose proof (on_a_wall e I Z) as W.
  destruct (Req_dec s 0) as [->|S0].
  { apply (M_not_zero e W). intros y. specialize (H y). unfold portion in H. rewrite Rmin_right in H by lra. lra. }
  destruct (Rle_dec s 1) as [S1|S1].
  - unfold later in *. rewrite Rmax_left in * by lra. unfold portion in H. rewrite Rmin_right in H by lra.
    apply (middle_holds e fs ((1 - s) / s) W F).
    + apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
    + intros y. specialize (H y). specialize (Sp y). rewrite Sp in H.
      apply Rmult_eq_reg_l with s; [|exact S0]. field_simplify; [lra|exact S0].
  - assert (L : later s = s - 1) by (apply Rmax_right; lra). rewrite L in *.
    apply (way_holds (s - 1) e fs); try assumption; [lra|].
    intros y. specialize (H y). specialize (Sp y). rewrite Sp in H. unfold portion in H.
    rewrite Rmin_left in H by lra. lra.
Qed.

(* The system in question has an equilibrium inside of K. *)
Theorem stable_by_degree : exists e fs, Forall (fun f => dot f (listed D e) < 1) walls /\
  Forall (fun z => dot z (listed D e) = 0) free /\ forces_obey 1 e fs /\ forall y, total_work 1 fs y = 0.
Proof.
  assert (Unit : forall e j, (j < D)%nat -> dot (basis_vector D j) (times A (listed D e)) + spread free
    (basis_vector D j) (listed D e) =
    nth j (times M (listed D e)) 0).
  { intros e j J. rewrite <- M_is by apply length_listed. now rewrite dot_sym, dot_unit. }
  destruct (homotopy D gap B) with (pull := fun e j => - nth j (times M (listed D e)) 0)
    (inverse := fun f j => nth j (times inverse (listed D f)) 0) (forces := fun k s e j => net k s e
      (basis_vector D j))
    (balance := balance) as (e & I & fs & F & H).
  - intros u x U. now apply gap_cv.
  - apply Rlt_le_trans with (1 / 2); [lra|]. apply gap_least. split; [lra|].
    apply Forall_forall. intros f _. rewrite dot_listed_zero. lra.
  - intros e He. destruct (gap_in_K e 0 (Rle_refl 0) He) as [K1 K2]. now apply K_bounded.
  - intros j J u x U. apply cv_nth, cv_times, cv_listed, U.
  - intros f e E j J.
    assert (X : listed D f = scaled (-1) (times M (listed D e))).
    { apply (nth_ext _ _ 0 0); [unfold scaled; now rewrite map_length, times_length, M_rows, length_listed|].
      rewrite length_listed. intros i Hi. rewrite nth_listed, E, nth_scaled by exact Hi. ring. }
    rewrite X, times_scaled, inverse_left by apply length_listed. rewrite nth_scaled, nth_listed by exact J. ring.
  - intros f Z j J. rewrite <- (nth_listed D f j J).
    rewrite <- (inverse_right (listed D f)) by apply length_listed.
    replace (times inverse (listed D f)) with (listed D (fun _ => 0)); [apply times_zero|].
    apply (nth_ext _ _ 0 0); [now rewrite times_length, length_listed|].
    rewrite length_listed. intros i I. now rewrite nth_listed, Z.
  - intros k j J s s' e e' Rg S E. now apply net_continuous.
  - intros k e j J. unfold net, portion. rewrite Rmin_right by lra. rewrite <- Unit by exact J. ring.
  - intros phi s s' e e' P S E Rg Z. now apply (balance_closed phi s s' e e').
  - apply no_balance_on_walls.
  - destruct (no_free_part _ _ _ _ _ F H) as [Z Sp].
    assert (L : later 2 = 1) by (unfold later; rewrite Rmax_right; lra).
    assert (P : portion 2 = 1) by (unfold portion; rewrite Rmin_left; lra). rewrite L in *.
    exists e, fs. split; [|split; [exact Z|split; [exact F|]]].
    + destruct (proj1 (gap_least e (gap e)) (Rle_refl _)) as [_ X]. unfold all_walls in X.
      rewrite Forall_app in X. eapply Forall_impl; [|apply X]. cbn. intros; lra.
    + intros y. specialize (H y). rewrite Sp, P in H. lra.
Qed.

End Degree.
