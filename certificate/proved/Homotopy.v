(* SPDX-License-Identifier: MIT *)
(* Limits of sequences of numbers under the functions that forces are made of; and `homotopy`, the argument of
   proofs by degree (FORMAT.md section 6): what has a zero at the beginning of a homotopy, and none on the
   walls of a bounded set on the way, has one at the end. *)
From Coq Require Import Arith Lia Reals Lra.
From Proved Require Import Brouwer.
Open Scope R_scope.

(* ---- Limits ---- *)

Lemma cv_lipschitz f u x : (forall a b, Rabs (f a - f b) <= Rabs (a - b)) -> Un_cv u x ->
  Un_cv (fun k => f (u k)) (f x).
Proof.
  intros L U eps E. destruct (U eps E) as (N & H). exists N. intros k K.
  eapply Rle_lt_trans; [apply L|apply H, K].
Qed.

Lemma cv_max u v x y : Un_cv u x -> Un_cv v y -> Un_cv (fun k => Rmax (u k) (v k)) (Rmax x y).
Proof.
  intros U V eps E. destruct (U eps E) as (N & HN), (V eps E) as (M & HM). exists (max N M). intros k K.
  specialize (HN k ltac:(lia)). specialize (HM k ltac:(lia)). unfold R_dist in *.
  apply Rabs_def2 in HN, HM. apply Rabs_def1; unfold Rmax; repeat destruct Rle_dec; lra.
Qed.

Lemma cv_min u v x y : Un_cv u x -> Un_cv v y -> Un_cv (fun k => Rmin (u k) (v k)) (Rmin x y).
Proof.
  intros U V eps E. destruct (U eps E) as (N & HN), (V eps E) as (M & HM). exists (max N M). intros k K.
  specialize (HN k ltac:(lia)). specialize (HM k ltac:(lia)). unfold R_dist in *.
  apply Rabs_def2 in HN, HM. apply Rabs_def1; unfold Rmin; repeat destruct Rle_dec; lra.
Qed.

Lemma cv_multiple c u x : Un_cv u x -> Un_cv (fun k => c * u k) (c * x).
Proof. intros U. apply CV_mult; [apply cv_constant|exact U]. Qed.

Lemma cv_inverse u x : x <> 0 -> Un_cv u x -> Un_cv (fun k => / u k) (/ x).
Proof.
  intros X U. apply (continuity_seq Rinv); [|exact U].
  apply (continuity_pt_inv id); [apply derivable_continuous_pt, derivable_pt_id|exact X].
Qed.

Lemma cv_root u x : (forall k, 0 <= u k) -> Un_cv u x -> Un_cv (fun k => sqrt (u k)) (sqrt x).
Proof.
  intros P U eps E. pose proof (cv_at_least _ _ _ P U) as X.
  destruct (U (eps * eps)) as (N & H); [nra|]. exists N. intros k K. specialize (H k K).
  unfold R_dist in *. specialize (P k). apply Rabs_def2 in H.
  pose proof (sqrt_pos (u k)). pose proof (sqrt_pos x).
  pose proof (sqrt_sqrt _ P). pose proof (sqrt_sqrt _ X).
  apply Rabs_def1; apply Rnot_le_lt; intros L; nra.
Qed.

Lemma cv_same u v x : (forall k, u k = v k) -> Un_cv v x -> Un_cv u x.
Proof. intros E V eps Eps. destruct (V eps Eps) as (N & H). exists N. intros k K. rewrite E. auto. Qed.

Lemma cv_unique u x y : Un_cv u x -> Un_cv u y -> x = y.
Proof. apply UL_sequence. Qed.

Lemma converges_onward n phi u x : onward phi -> converges n u x -> converges n (fun k => u (phi k)) x.
Proof. intros P U i I. apply (cv_onward phi (fun k => u k i)); auto. Qed.

(* Nothing but the first n numbers counts. *)
Lemma continuous_same n f x y : continuous n f -> (forall i, (i < n)%nat -> x i = y i) -> f x = f y.
Proof.
  intros C E. eapply cv_unique; [apply cv_constant|]. apply (C (fun _ => x) y).
  intros i I. rewrite (E i I). apply cv_constant.
Qed.

(* ---- The homotopy ---- *)

Section Homotopy.
Variable n : nat.

(* K is where inside >= 0; where it is 0 are the walls of K. *)
Variable inside : vec -> R.
Variable B : vec.
Hypothesis inside_continuous : continuous n inside.
Hypothesis middle_inside : 0 < inside (fun _ => 0).
Hypothesis inside_bounded : forall e, 0 <= inside e -> in_box n B e.

(* A force that depends on e as -A e, and the inverse of A. *)
Variable pull : vec -> vec.
Variable inverse : vec -> vec.
Hypothesis inverse_continuous : forall j, (j < n)%nat -> continuous n (fun f => inverse f j).
Hypothesis inverse_of_pull : forall f e, (forall j, (j < n)%nat -> f j = pull e j) ->
  forall j, (j < n)%nat -> inverse f j = - e j.
Hypothesis inverse_not_zero : forall f, (forall j, (j < n)%nat -> inverse f j = 0) ->
  forall j, (j < n)%nat -> f j = 0.

(* Forces at e, at the time s from 0 to 2; the larger k, the better they approach the law, *)
Variable forces : nat -> R -> vec -> vec.
Hypothesis forces_continuous : forall k j, (j < n)%nat -> forall s s' e e',
  (forall m, 0 <= s m <= 2) -> Un_cv s s' -> converges n e e' -> Un_cv (fun m => forces k (s m) (e m) j)
    (forces k s' e' j).
Hypothesis forces_at_0 : forall k e j, (j < n)%nat -> forces k 0 e j = pull e j.

(* by which there is balance at the time s and e. *)
Variable balance : R -> vec -> Prop.
Hypothesis balance_closed : forall phi s s' e e', onward phi -> Un_cv s s' -> converges n e e' ->
  (forall k, 0 <= s k <= 2) -> (forall k j, (j < n)%nat -> forces (phi k) (s k) (e k) j = 0) -> balance s' e'.
Hypothesis no_balance_on_walls : forall s e, 0 <= s <= 2 -> inside e = 0 -> ~ balance s e.

(* The time at which forces are taken at e: 0 on the walls and outside, 2 well inside. *)
Definition time (k : nat) (e : vec) : R := 2 * Rmin 1 (Rmax 0 (inside e / nth_part k)).

Lemma time_range k e : 0 <= time k e <= 2.
Proof.
  unfold time, Rmin. pose proof (Rmax_l 0 (inside e / nth_part k)). destruct Rle_dec; lra.
Qed.

Lemma time_outside k e : inside e <= 0 -> time k e = 0.
Proof.
  intros H. unfold time. rewrite Rmax_left.
  - rewrite Rmin_right; lra.
  - pose proof (Rinv_0_lt_compat _ (nth_part_positive k)). unfold Rdiv. nra.
Qed.

Lemma time_inside k e : nth_part k <= inside e -> time k e = 2.
Proof.
  intros H. pose proof (nth_part_positive k). assert (1 <= inside e / nth_part k).
  { apply Rmult_le_reg_r with (nth_part k); [lra|]. unfold Rdiv.
    rewrite Rmult_assoc, Rinv_l by lra. lra. }
  unfold time. rewrite Rmax_right, Rmin_left by lra. lra.
Qed.

Lemma zero_found k : {e | 0 <= inside e & forall j, (j < n)%nat -> forces k (time k e) e j = 0}.
Proof.
  assert (Outside : forall e j, (j < n)%nat -> inside e <= 0 ->
    inverse (forces k (time k e) e) j = - e j).
  { intros e j J H. apply inverse_of_pull; [|exact J]. intros i I. rewrite time_outside by exact H.
    now apply forces_at_0. }
  assert (B0 : forall i, (i < n)%nat -> 0 <= B i + 1).
  { intros i I. pose proof (inside_bounded _ (Rlt_le _ _ middle_inside) i I). lra. }
  assert (Face : forall e j, (j < n)%nat -> B j < Rabs (e j) -> inside e <= 0).
  { intros e j J L. apply Rnot_lt_le. intros P. apply Rlt_le in P. destruct (inside_bounded e P j J).
    unfold Rabs in L. destruct (Rcase_abs (e j)); lra. }
  destruct (zero_in_box n (fun i => B i + 1) (fun e => inverse (forces k (time k e) e))) as [e _ Z].
  - exact B0.
  - intros j J u x U. apply (inverse_continuous j J (fun m => forces k (time k (u m)) (u m))).
    intros i I. apply forces_continuous; [exact I|intros m; apply time_range| |exact U].
    apply cv_multiple, cv_min; [apply cv_constant|]. apply cv_max; [apply cv_constant|].
    apply CV_mult; [|apply cv_constant]. now apply inside_continuous.
  - intros e j J _ E. specialize (B0 j J). rewrite Outside; [lra|exact J|]. apply (Face e j J).
    rewrite E, Rabs_Ropp, Rabs_right; lra.
  - intros e j J _ E. specialize (B0 j J). rewrite Outside; [lra|exact J|]. apply (Face e j J).
    rewrite E, Rabs_right; lra.
  - exists e.
    + apply Rnot_lt_le. intros L. apply Rlt_le in L.
      assert (E : inside e = inside (fun _ => 0)); [|lra].
      apply (continuous_same n); [exact inside_continuous|]. intros j J. specialize (Z j J).
      cbn in Z. rewrite (Outside e j J L) in Z. lra.
    + now apply inverse_not_zero.
Qed.

Theorem homotopy : exists e, 0 < inside e /\ balance 2 e.
Proof.
  set (e := fun k => proj1_sig (sig_of_sig2 (zero_found k))).
  assert (In_K : forall k, 0 <= inside (e k)).
  { intros k. unfold e. now destruct (zero_found k). }
  assert (Zero : forall k j, (j < n)%nat -> forces k (time k (e k)) (e k) j = 0).
  { intros k. unfold e. now destruct (zero_found k). }
  clearbody e. destruct (cluster_point n e B) as [phi P [e' E]]; [intros; now apply inside_bounded|].
  destruct (cluster_number (fun k => time (phi k) (e (phi k))) 2) as [psi Q [s S]].
  { intros k. pose proof (time_range (phi k) (e (phi k))). lra. }
  assert (E' : converges n (fun k => e (phi (psi k))) e') by now apply (converges_onward n psi (fun k => e (phi
    k))).
  assert (PQ : onward (fun k => phi (psi k))) by (intros k; specialize (P (psi k)); specialize (Q k); cbn; lia).
  assert (Bal : balance s e').
  { eapply (balance_closed (fun k => phi (psi k))); [exact PQ|exact S|exact E'| |].
    - intros k. apply time_range.
    - intros k j J. now apply Zero. }
  assert (I : 0 <= inside e').
  { eapply cv_at_least; [|apply (inside_continuous _ _ E')]. intros k. apply In_K. }
  assert (Range : 0 <= s <= 2).
  { split; [eapply cv_at_least|eapply cv_at_most]; try exact S; intros k; apply time_range. }
  destruct (Req_dec (inside e') 0) as [Z|NZ]; [now destruct (no_balance_on_walls s e')|].
  exists e'. split; [lra|].
  (* Well inside in the end. *)
  assert (S2 : s = 2).
  { destruct (nth_part_small (inside e' / 2)) as (N & HN); [lra|].
    destruct (inside_continuous _ _ E' (inside e' / 2)) as (M & HM); [lra|].
    eapply cv_unique; [apply (cv_onward (fun k => k + max N M)%nat _ s) in S; [exact S|intros k; lia]|].
    intros eps Eps. exists 0%nat. intros k _. cbn.
    rewrite time_inside; [now rewrite R_dist_eq|].
    specialize (HM (k + max N M)%nat ltac:(lia)). unfold R_dist in HM. apply Rabs_def2 in HM.
    specialize (PQ (k + max N M)%nat). cbn in PQ. specialize (HN (phi (psi (k + max N M)%nat)) ltac:(lia)). lra. }
  now rewrite <- S2.
Qed.

End Homotopy.
