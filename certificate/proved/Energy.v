(* SPDX-License-Identifier: MIT *)
(* Stable by sticking (FORMAT.md section 6), for rows in R^D over the reals.  `zero_inside`: forces that do less than no
   work on e wherever e is on the border of a bounded set have a zero in it.  `forces_found`: they do so on the border of
   the set of an energy, if forces that balance differ less from those at the motion d0 than friction has to spare. *)
From Coq Require Import List Arith Lia Reals Lra.
From Proved Require Import Rows Brouwer Homotopy RowLimits Degree Matrix.
From Proved Require Model.
Import ListNotations.
Open Scope R_scope.

(* ---- Sums ---- *)

Lemma sum_below n a b : (forall i, (i < n)%nat -> a i <= b i) -> sum_to n a <= sum_to n b.
Proof.
  revert a b. induction n as [|n IH]; intros a b H; cbn; [lra|].
  apply Rplus_le_compat; [apply H; lia|]. apply IH. intros; apply H; lia.
Qed.

Lemma sum_nonneg n a : (forall i, (i < n)%nat -> 0 <= a i) -> 0 <= sum_to n a.
Proof. intros H. rewrite <- (sum_zero n (fun _ => 0)) by reflexivity. now apply sum_below. Qed.

Lemma sum_one_below n a i : (i < n)%nat -> (forall i, (i < n)%nat -> 0 <= a i) -> a i <= sum_to n a.
Proof.
  revert a i. induction n as [|n IH]; intros a i I H; [lia|]. cbn.
  assert (Rest : 0 <= sum_to n (fun j => a (S j))) by (apply sum_nonneg; intros; apply H; lia).
  destruct i as [|i]; [lra|]. pose proof (H O ltac:(lia)).
  pose proof (IH (fun j => a (S j)) i ltac:(lia) ltac:(intros; apply H; lia)). cbn in *. lra.
Qed.

Lemma sum_swapped n m f : sum_to n (fun i => sum_to m (fun j => f i j)) = sum_to m (fun j => sum_to n (fun i => f i j)).
Proof.
  revert f. induction n as [|n IH]; intros f; cbn.
  - now rewrite sum_zero.
  - now rewrite (IH (fun i => f (S i))), <- sum_plus.
Qed.

Lemma sum_one n k z : (k < n)%nat -> sum_to n (fun l => (if Nat.eqb k l then 1 else 0) * z l) = z k.
Proof.
  revert k z. induction n as [|m IH]; intros [|k] z K; cbn; try lia.
  - rewrite sum_zero; [ring|]. intros; cbn; ring.
  - rewrite (IH k (fun i => z (S i))) by lia. ring.
Qed.

Lemma sum_absolute n a : Rabs (sum_to n a) <= sum_to n (fun i => Rabs (a i)).
Proof.
  revert a. induction n as [|n IH]; intros a; cbn; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat_l, (IH (fun i => a (S i))).
Qed.

Lemma cv_sum n (u : nat -> nat -> R) x : (forall i, (i < n)%nat -> Un_cv (fun k => u k i) (x i)) ->
  Un_cv (fun k => sum_to n (u k)) (sum_to n x).
Proof.
  revert u x. induction n as [|n IH]; intros u x H; cbn; [apply cv_constant|].
  apply (CV_plus (fun k => u k O)); [apply H; lia|].
  apply (IH (fun k i => u k (S i))). intros i I. apply (H (S i)). lia.
Qed.

(* Over a list. *)
Fixpoint over {A} (f : A -> R) (them : list A) : R := match them with [] => 0 | a :: them' => f a + over f them' end.

Lemma over_below {A} (f g : A -> R) them : Forall (fun a => f a <= g a) them -> over f them <= over g them.
Proof. induction 1; cbn; lra. Qed.

Lemma over_same {A} (f g : A -> R) them : (forall a, f a = g a) -> over f them = over g them.
Proof. intros H. induction them as [|a them IH]; cbn; [reflexivity|]. now rewrite H, IH. Qed.

Lemma over_nonneg {A} (f : A -> R) them : Forall (fun a => 0 <= f a) them -> 0 <= over f them.
Proof. induction 1; cbn; lra. Qed.

Lemma over_one {A} (f : A -> R) them a : Forall (fun a => 0 <= f a) them -> In a them -> f a <= over f them.
Proof.
  induction 1 as [|b them Hb F IH]; intros []; cbn; [subst; pose proof (over_nonneg _ _ F); lra|].
  specialize (IH H). lra.
Qed.

Lemma over_minus {A} (f g : A -> R) them : over (fun a => f a - g a) them = over f them - over g them.
Proof. induction them as [|a them IH]; cbn; [ring|]. rewrite IH. ring. Qed.

Lemma over_absolute {A} (f : A -> R) them : Rabs (over f them) <= over (fun a => Rabs (f a)) them.
Proof.
  induction them as [|a them IH]; cbn; [rewrite Rabs_R0; lra|].
  eapply Rle_trans; [apply Rabs_triang|]. now apply Rplus_le_compat_l.
Qed.

(* ---- Matrices near 1 ---- *)

(* z with M z = -W, where W and M - 1 are small for it. *)
Lemma answered_exactly n (W : nat -> R) (M : nat -> nat -> R) (Z : nat -> R) :
  (forall k, (k < n)%nat -> 0 <= Z k /\
     Rabs (W k) + sum_to n (fun l => Rabs (M k l - (if Nat.eqb k l then 1 else 0)) * Z l) <= Z k) ->
  exists z : vec, in_box n Z z /\ forall k, (k < n)%nat -> W k + sum_to n (fun l => z l * M k l) = 0.
Proof.
  intros H. destruct (fixed_point n Z (fun z k => z k - (W k + sum_to n (fun l => z l * M k l)))) as [z In_box Fix].
  - intros k K. now apply H.
  - intros k K u x U. apply CV_minus; [now apply U|]. apply (CV_plus (fun _ => W k)); [apply cv_constant|].
    apply (cv_sum n (fun i l => u i l * M k l)). intros l L. apply CV_mult; [now apply U|apply cv_constant].
  - intros z In_box k K. destruct (H k K) as [_ B].
    assert (E : z k - (W k + sum_to n (fun l => z l * M k l)) =
      - W k - sum_to n (fun l => (M k l - (if Nat.eqb k l then 1 else 0)) * z l)).
    { rewrite <- (sum_one n k z K) at 1.
      rewrite (sum_same n (fun l => (M k l - (if Nat.eqb k l then 1 else 0)) * z l)
        (fun l => z l * M k l + -1 * ((if Nat.eqb k l then 1 else 0) * z l))) by (intros; ring).
      rewrite sum_plus, sum_multiple. ring. }
    rewrite E.
    pose proof (sum_absolute n (fun l => (M k l - (if Nat.eqb k l then 1 else 0)) * z l)) as Ab.
    assert (Le : sum_to n (fun l => Rabs ((M k l - (if Nat.eqb k l then 1 else 0)) * z l)) <=
      sum_to n (fun l => Rabs (M k l - (if Nat.eqb k l then 1 else 0)) * Z l)).
    { apply sum_below. intros l L. rewrite Rabs_mult. apply Rmult_le_compat_l; [apply Rabs_pos|].
      apply Rabs_le. now apply In_box. }
    set (o := sum_to n (fun l => _ * z l)) in *.
    assert (F : Rabs (W k) + Rabs o <= Z k) by lra. clear - F.
    unfold Rabs in F. destruct (Rcase_abs (W k)), (Rcase_abs o); lra.
  - exists z. split; [exact In_box|]. intros k K. specialize (Fix k K). cbn in Fix. lra.
Qed.

(* How large y is of which so much less than itself is left. *)
Lemma room_left n (R_ : nat -> nat -> R) (Z P y : nat -> R) : (forall l, (l < n)%nat -> 0 <= Z l) ->
  (forall l, (l < n)%nat -> y l <= P l + sum_to n (fun k => R_ k l * y k)) ->
  sum_to n (fun k => (Z k - sum_to n (fun l => R_ k l * Z l)) * y k) <= sum_to n (fun l => Z l * P l).
Proof.
  intros Zn H.
  assert (L : sum_to n (fun l => Z l * y l) <= sum_to n (fun l => Z l * (P l + sum_to n (fun k => R_ k l * y k)))).
  { apply sum_below. intros l I. apply Rmult_le_compat_l; auto. }
  assert (E : sum_to n (fun l => Z l * (P l + sum_to n (fun k => R_ k l * y k))) =
    sum_to n (fun l => Z l * P l) + sum_to n (fun k => sum_to n (fun l => R_ k l * Z l) * y k)).
  { rewrite (sum_same n (fun l => Z l * (P l + sum_to n (fun k => R_ k l * y k)))
      (fun l => Z l * P l + sum_to n (fun k => Z l * (R_ k l * y k)))).
    - rewrite sum_plus, sum_swapped. f_equal. apply sum_same. intros k K. rewrite (Rmult_comm _ (y k)), <- sum_multiple.
      apply sum_same. intros; ring.
    - intros l I. rewrite sum_multiple. ring. }
  rewrite E in L.
  rewrite (sum_same n (fun k => (Z k - sum_to n (fun l => R_ k l * Z l)) * y k)
    (fun k => Z k * y k + -1 * (sum_to n (fun l => R_ k l * Z l) * y k))) by (intros; ring).
  rewrite sum_plus, sum_multiple. lra.
Qed.

(* ---- Zeros ---- *)

Lemma cv_row_constant r : cv_row (fun _ => r) r.
Proof.
  constructor; try apply cv_constant; try reflexivity; [apply cv_list_constant|].
  induction (slips r) as [|f fs IH]; [constructor|].
  apply (cv_lists_cons (fun _ => f) f (fun _ => fs)); [apply cv_list_constant|exact IH].
Qed.

Lemma cv_rows_constant rs : cv_rows (fun _ => rs) rs.
Proof.
  induction rs as [|r rs IH]; [constructor|]. apply (cv_rows_cons (fun _ => r) r (fun _ => rs)); [apply cv_row_constant|exact IH].
Qed.

Section Zeros.
Variable D : nat.
Variable sys : system.
Variable lambda : R.
Variable d0 : list R.
Hypothesis all_proper : Forall (proper D) (rows sys).
Hypothesis loads_length : List.length (wrench sys) = D /\ List.length (direction sys) = D.

Definition moved (e : vec) : list R := listed D (fun i => nth i d0 0 + e i).

Definition pushing_at (e : vec) (fs : list force) := Forall2 (obeys Model.unilateral (moved e) 1 lambda) (rows sys) fs.

Definition in_sum (fs : list force) (y : list R) : R := load sys 1 lambda y + works (rows sys) fs y.

Variable inside : vec -> R.
Variable B : vec.
Hypothesis inside_continuous : continuous D inside.
Hypothesis middle_inside : 0 < inside (fun _ => 0).
Hypothesis inside_bounded : forall e, 0 <= inside e -> in_box D B e.
Hypothesis pushed_back : forall e fs, inside e = 0 -> pushing_at e fs -> in_sum fs (listed D e) < 0.

Let one : list (list R) := map real (identity D).

Lemma times_one e : List.length e = D -> times one e = e.
Proof.
  intros L. unfold times, one, identity. rewrite !map_map. apply (nth_ext _ _ 0 0).
  - now rewrite map_length, seq_length.
  - intros i I. rewrite map_length, seq_length in I.
    rewrite nth_indep with (d' := dot (real (unit_vector D 0)) e) by (now rewrite map_length, seq_length).
    rewrite (map_nth (fun i => dot (real (unit_vector D i)) e)), seq_nth by exact I. cbn.
    now rewrite unit_vector_is, dot_sym, dot_unit by exact I.
Qed.

Lemma one_rows : List.length one = D.
Proof. unfold one, identity. now rewrite !map_length, seq_length. Qed.

Let at_all (_ : R) : system := sys.
Let always (x : R) (_ : R) : R := x.
Let there (_ : R) : list R := d0.

Lemma nothing_changes s s' : (forall k, 0 <= s k <= 1) -> Un_cv s s' ->
  cv_rows (fun k => rows (at_all (s k))) (rows (at_all s')) /\
  cv_list (fun k => wrench (at_all (s k))) (wrench (at_all s')) /\
  cv_list (fun k => direction (at_all (s k))) (direction (at_all s')) /\
  Un_cv (fun k => always 1 (s k)) (always 1 s') /\ Un_cv (fun k => always lambda (s k)) (always lambda s') /\
  (forall i, (i < D)%nat -> Un_cv (fun k => nth i (there (s k)) 0) (nth i (there s') 0)).
Proof.
  intros _ _. unfold at_all, always, there. split; [|split; [|split; [|split; [|split]]]];
    try apply cv_constant; try apply cv_list_constant; [|intros; apply cv_constant].
  apply cv_rows_constant.
Qed.

Theorem zero_inside : exists e fs, 0 < inside e /\ pushing_at e fs /\ forall y, in_sum fs y = 0.
Proof.
  assert (Self : forall e, 0 <= dot (listed D e) (listed D e)).
  { intros e. generalize (listed D e). intros a. induction a as [|x a IH]; cbn; [lra|].
    pose proof (Rle_0_sqr x). unfold Rsqr in *. lra. }
  destruct (homotopy D inside B) with (pull := fun (e : vec) j => - e j) (inverse := fun (f : vec) j => f j)
    (forces := fun k s e j => net D at_all (always 1) (always lambda) there [] one k s e (basis_vector D j))
    (balance := balance D at_all (always 1) (always lambda) there [] one) as (e & I & fs & F & H).
  - exact inside_continuous.
  - exact middle_inside.
  - exact inside_bounded.
  - intros j J u x U. now apply U.
  - intros f e E j J. exact (E j J).
  - intros f Z j J. now apply Z.
  - intros k j J s s' e e' Rg S E. apply net_continuous; try assumption; [intros; exact all_proper|exact nothing_changes].
  - intros k e j J. unfold net, portion. rewrite Rmin_right by lra. cbn [spread fold_right].
    rewrite times_one by apply length_listed. rewrite dot_sym, dot_unit, nth_listed by exact J. ring.
  - intros phi s s' e e' P S E Rg Z.
    apply (balance_closed D at_all (always 1) (always lambda) there (fun _ => all_proper) (fun _ => loads_length)
      nothing_changes [] one one_rows (Forall_nil _) phi s s' e e'); assumption.
  - intros s e Rg I (fs & F & H). specialize (H (listed D e)). cbn [spread fold_right] in H.
    rewrite times_one in H by apply length_listed.
    pose proof (pushed_back e fs I F) as N. unfold in_sum in N. unfold total_work, at_all, always in H.
    specialize (Self e). set (w := load _ _ _ _ + works _ _ _) in *.
    assert (Pr : 0 <= portion s <= 1) by (unfold portion, Rmin; destruct (Rle_dec 1 s); lra).
    destruct (Req_dec (portion s) 0) as [P0|P0]; [|nra].
    rewrite P0 in H. assert (Z : dot (listed D e) (listed D e) = 0) by lra.
    assert (E : inside e = inside (fun _ => 0)); [|lra].
    apply (continuous_same D); [exact inside_continuous|]. intros j J.
    rewrite <- (nth_listed D e j J), <- dot_unit with (n := D) by exact J. now apply dot_self_zero.
  - exists e, fs. split; [exact I|].
    assert (L : later 2 = 1) by (unfold later; rewrite Rmax_right; lra).
    assert (P : portion 2 = 1) by (unfold portion; rewrite Rmin_left; lra). rewrite L, P in *.
    split; [exact F|]. intros y. specialize (H y). cbn [spread fold_right] in H. unfold total_work, at_all, always in H.
    unfold in_sum. lra.
Qed.

End Zeros.

(* ---- Contacts that stick ---- *)

(* What is known of a contact, in the letters of FORMAT.md. *)
Record grip := Grip {
  own : row;
  counter : force;       (* a0 + h, and F: those of all contacts balance the load *)
  base : R;              (* a0 *)
  more : R;              (* h *)
  rough : R;             (* rho of the row in the box that stands for its own *)
  turned : R;            (* which has so many times as much *)
  delta : R;
  phi : R;
  sigma : R;
  gamma : R;
  swing : R;             (* r *)
  spare : R;             (* s *)
  is_listed : bool;
  rubs : bool
}.

Lemma slip_plus r a b : slip r (plus a b) = plus (slip r a) (slip r b).
Proof.
  unfold slip. induction (slips r) as [|f fs IH]; cbn; [reflexivity|]. rewrite IH. f_equal.
  now rewrite dot_sym, dot_plus, (dot_sym a), (dot_sym b).
Qed.

Lemma product_plus_right ws g a b : product ws g (plus a b) = product ws g a + product ws g b.
Proof. now rewrite product_sym, product_plus, (product_sym _ a), (product_sym _ b). Qed.

Section Energy.
Variable D : nat.
Variable lambda : R.
Variable d0 : list R.
Variable c : R.
Hypothesis d0_length : List.length d0 = D.

Record grips (t : grip) : Prop := Grips {
  grips_proper : proper D (own t);
  stiffness_nonneg : 0 <= stiffness (own t);
  base_is : base t = pressed (own t) d0 1 lambda;
  counter_is : fst (counter t) = base t + more t;
  turned_nonneg : 0 <= turned t;
  rho_is : rho (own t) = turned t * rough t;
  rough_nonneg : 0 <= rough t;
  springs_smooth : spring (own t) = true -> rough t = 0;
  phi_nonneg : 0 <= phi t;
  counter_within : size (weights (own t)) (snd (counter t)) <= turned t * phi t;
  sigma_nonneg : 0 <= sigma t;
  slip_at_d0 : turned t * size (weights (own t)) (slip (own t) d0) <= sigma t;
  more_within : Rabs (more t) <= delta t;
  of_no_stiffness : stiffness (own t) = 0 -> spring (own t) = true /\ more t = 0 /\ 0 <= gamma t;
  gamma_is : 0 < stiffness (own t) ->
    (delta t + rough t * stiffness (own t) * sigma t) * (delta t + rough t * stiffness (own t) * sigma t) <=
    2 * stiffness (own t) * (gamma t - (rough t * base t + phi t) * sigma t);
  unlisted : is_listed t = false -> more t = 0 /\ rubs t = false;
  pressing : is_listed t = true -> spring (own t) = false ->
    0 <= swing t /\ 2 * c * stiffness (own t) <= swing t * swing t /\ swing t <= v (own t) d0 1 lambda;
  rubbing : rubs t = true -> is_listed t = true /\ spring (own t) = false /\ 0 < spare t /\
    spare t <= rough t * (v (own t) d0 1 lambda - swing t) - phi t;
  not_rubbing : rubs t = false -> phi t = 0
}.

Notation moved := (moved D d0).

(* The terms of the energy Q. *)
Definition press_energy (t : grip) (e : vec) : R :=
  if is_listed t then stiffness (own t) / 2 * (dot (N (own t)) (listed D e) * dot (N (own t)) (listed D e)) else 0.
Definition rub_energy (t : grip) (e : vec) : R :=
  if rubs t then spare t * (turned t * size (weights (own t)) (slip (own t) (moved e))) else 0.
Definition energy (t : grip) (e : vec) : R := press_energy t e + rub_energy t e.

Lemma moved_is e : moved e = plus d0 (listed D e).
Proof.
  unfold Energy.moved. subst D. clear. revert e. induction d0 as [|x d IH]; intros e; cbn; [reflexivity|].
  f_equal. now rewrite IH.
Qed.

Lemma v_moved r e : v r (moved e) 1 lambda = v r d0 1 lambda - stiffness r * dot (N r) (listed D e).
Proof. rewrite moved_is. unfold v. rewrite (dot_sym (N r) (plus _ _)), dot_plus, !(dot_sym _ (N r)). ring. Qed.

Lemma press_nonneg t e : grips t -> 0 <= press_energy t e.
Proof.
  intros G. unfold press_energy. destruct (is_listed t); [|lra]. pose proof (stiffness_nonneg t G).
  pose proof (Rle_0_sqr (dot (N (own t)) (listed D e))) as Sq. unfold Rsqr in Sq.
  apply Rmult_le_pos; lra.
Qed.

Lemma rub_nonneg t e : grips t -> 0 <= rub_energy t e.
Proof.
  intros G. unfold rub_energy. destruct (rubs t) eqn:E; [|lra]. destruct (rubbing t G E) as (_ & _ & P & _).
  pose proof (turned_nonneg t G). pose proof (size_nonneg (weights (own t)) (slip (own t) (moved e))).
  apply Rmult_le_pos; [lra|]. now apply Rmult_le_pos.
Qed.

Lemma energy_nonneg t e : grips t -> 0 <= energy t e.
Proof. intros G. pose proof (press_nonneg t e G). pose proof (rub_nonneg t e G). unfold energy. lra. Qed.

(* A contact that is listed presses. *)
Lemma still_presses t e : grips t -> energy t e <= c -> is_listed t = true -> spring (own t) = false ->
  0 <= v (own t) d0 1 lambda - swing t <= v (own t) (moved e) 1 lambda.
Proof.
  intros G Le L S. destruct (pressing t G L S) as (R0 & R1 & R2). split; [lra|].
  pose proof (rub_nonneg t e G). unfold energy, press_energy in Le. rewrite L in Le. rewrite v_moved.
  pose proof (stiffness_nonneg t G) as K. set (k := stiffness (own t)) in *. set (n := dot _ _) in *.
  assert (k * n <= swing t); [|lra]. apply Rnot_lt_le. intros Lt.
  assert (swing t * swing t < k * n * (k * n)) by (apply Rmult_le_0_lt_compat; lra).
  assert (k * (k / 2 * (n * n)) <= k * c) by (apply Rmult_le_compat_l; lra). lra.
Qed.

(* What the law says of a normal force near d0. *)
Lemma normal_part t e a : grips t -> energy t e <= c -> 0 < stiffness (own t) ->
  normal_law Model.unilateral (own t) (v (own t) (moved e) 1 lambda) a ->
  let x := a - base t in
  let n := dot (N (own t)) (listed D e) in
  x * n <= - (x * x) / stiffness (own t) /\
  (is_listed t = true -> x = - stiffness (own t) * n) /\ 0 <= rough t * a.
Proof.
  intros G Le K Law x n. unfold x. rewrite (base_is t G). unfold normal_law, pressed in *. rewrite v_moved in Law.
  fold n in Law. set (k := stiffness (own t)) in *. set (v0 := v (own t) d0 1 lambda) in *.
  assert (P : forall y, y * (- k * n) >= y * y -> y * n <= - (y * y) / k).
  { intros y Hy. apply Rmult_le_reg_l with k; [exact K|]. field_simplify; nra. }
  pose proof (rough_nonneg t G) as Rn.
  destruct (spring (own t)) eqn:S.
  - rewrite (springs_smooth t G S). split; [apply P; nra|]. split; [intros _; lra|lra].
  - cbn in Law. assert (A0 : 0 <= a) by (rewrite Law; apply Rmax_l). split; [|split].
    + apply P. rewrite Law. unfold Rmax. destruct (Rle_dec 0 (v0 - k * n)), (Rle_dec 0 v0); nra.
    + intros L. pose proof (still_presses t e G Le L S) as Pr. rewrite v_moved in Pr. fold k n v0 in Pr.
      destruct (pressing t G L S) as (S0 & _ & S1). fold v0 in S1. rewrite Law, !Rmax_right by lra. ring.
    + now apply Rmult_le_pos.
Qed.

(* What friction does of work on e, and what would balance does not. *)
Lemma friction_part t e a f : grips t -> 0 <= rough t * a -> size (weights (own t)) f <= rho (own t) * a ->
  product (weights (own t)) f (slip (own t) (moved e)) = - (rho (own t) * a) * size (weights (own t)) (slip (own t) (moved e)) ->
  let l := turned t * size (weights (own t)) (slip (own t) (moved e)) in
  product (weights (own t)) f (slip (own t) (listed D e)) - product (weights (own t)) (snd (counter t)) (slip (own t) (listed D e))
  <= - (rough t * a - phi t) * l + (rough t * a + phi t) * sigma t.
Proof.
  intros G A Cone Diss l. rewrite (rho_is t G) in Cone, Diss.
  pose proof (RowLimits.weights_positive _ _ (grips_proper t G)) as W. set (ws := weights (own t)) in *.
  set (s := slip (own t) (moved e)) in *. set (s0 := slip (own t) d0).
  assert (Split : forall g, product ws g (slip (own t) (listed D e)) = product ws g s - product ws g s0).
  { intros g. unfold s. rewrite moved_is, slip_plus, product_plus_right. fold s0. ring. }
  rewrite !Split, Diss. set (F := snd (counter t)).
  assert (Opp : forall g, size ws (scaled (-1) g) = size ws g).
  { intros g. unfold size. f_equal. rewrite product_scaled, product_sym, product_scaled. ring. }
  assert (Least : forall g y, - product ws g y <= size ws g * size ws y).
  { intros g y. pose proof (product_bound ws (scaled (-1) g) y W) as B. rewrite product_scaled, Opp in B. lra. }
  pose proof (Least f s0) as B1. pose proof (Least F s) as B2. pose proof (product_bound ws F s0 W) as B3.
  pose proof (counter_within t G) as Cw. fold ws F in Cw. pose proof (slip_at_d0 t G) as S0. fold ws s0 in S0.
  pose proof (turned_nonneg t G) as T0. pose proof (phi_nonneg t G) as P0.
  pose proof (size_nonneg ws s) as Z. pose proof (size_nonneg ws s0) as Z0. unfold l.
  set (z := size ws s) in *. set (z0 := size ws s0) in *. set (u := turned t) in *.
  assert (M1 : size ws f * z0 <= u * rough t * a * z0) by now apply Rmult_le_compat_r.
  assert (M2 : size ws F * z <= u * phi t * z) by now apply Rmult_le_compat_r.
  assert (M3 : size ws F * z0 <= u * phi t * z0) by now apply Rmult_le_compat_r.
  pose proof (product_bound ws (scaled (-1) F) s W) as B4. rewrite product_scaled, Opp in B4. fold z in B4.
  assert ((rough t * a + phi t) * (u * z0) <= (rough t * a + phi t) * sigma t) by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

Theorem term_below t e a f : grips t -> energy t e <= c -> obeys Model.unilateral (moved e) 1 lambda (own t) (a, f) ->
  work (own t) (a, f) (listed D e) - work (own t) (counter t) (listed D e) <= gamma t - energy t e.
Proof.
  intros G Le (Law & Cone & Diss). unfold work. cbn [fst snd]. rewrite (counter_is t G).
  pose proof (more_within t G) as Mw. pose proof (Rabs_pos (more t)) as M0.
  pose proof (sigma_nonneg t G) as Sn. pose proof (phi_nonneg t G) as Pn. pose proof (rough_nonneg t G) as Rn.
  pose proof (size_nonneg (weights (own t)) (slip (own t) (moved e))) as Zn. pose proof (turned_nonneg t G) as Tn.
  destruct (Req_dec (stiffness (own t)) 0) as [K0|K0].
  - destruct (of_no_stiffness t G K0) as (Sp & Mo & Ga). pose proof (springs_smooth t G Sp) as R0.
    assert (Ru : rubs t = false).
    { destruct (rubs t) eqn:E; [|reflexivity]. destruct (rubbing t G E) as (_ & X & _). congruence. }
    pose proof (not_rubbing t G Ru) as P0.
    assert (A : 0 <= rough t * a) by (rewrite R0; lra).
    pose proof (friction_part t e a f G A Cone Diss) as Fp. cbn zeta in Fp. rewrite R0, P0 in Fp.
    unfold normal_law in Law. rewrite Sp, v_moved, K0 in Law.
    rewrite (base_is t G). unfold pressed. rewrite Sp, Mo, Law.
    unfold energy, press_energy, rub_energy. rewrite Ru, K0. destruct (is_listed t); lra.
  - assert (K : 0 < stiffness (own t)) by (pose proof (stiffness_nonneg t G); lra).
    destruct (normal_part t e a G Le K Law) as (X1 & X2 & A). cbn zeta in X1, X2.
    pose proof (friction_part t e a f G A Cone Diss) as Fp. cbn zeta in Fp.
    pose proof (gamma_is t G K) as Ga. pose proof (unlisted t G) as Un. pose proof (rubbing t G) as Rb.
    pose proof (not_rubbing t G) as Nr. pose proof (still_presses t e G Le) as Sp.
    unfold energy, press_energy, rub_energy. unfold normal_law in Law.
    set (n := dot (N (own t)) (listed D e)) in *. set (k := stiffness (own t)) in *.
    set (l := turned t * size (weights (own t)) (slip (own t) (moved e))) in *.
    assert (Ln : 0 <= l) by (unfold l; now apply Rmult_le_pos).
    set (p := product (weights (own t)) f (slip (own t) (listed D e))) in *.
    set (q := product (weights (own t)) (snd (counter t)) (slip (own t) (listed D e))) in *.
    set (x := a - base t) in *.
    assert (Ax : a <= base t + Rabs x) by (unfold x; pose proof (Rle_abs (a - base t)); lra).
    assert (Xx : Rabs x * Rabs x = x * x) by (rewrite <- Rabs_mult; apply Rabs_right, Rle_ge, Rle_0_sqr).
    pose proof (Rabs_pos x) as X0. set (X := Rabs x) in *.
    (* The normal part. *)
    assert (T1 : (a - (base t + more t)) * n <= - (X * X) / k + delta t * X / k).
    { replace ((a - (base t + more t)) * n) with (x * n - more t * n) by (unfold x; ring).
      rewrite Xx. destruct (is_listed t) eqn:L.
      - assert (En : n = - x / k) by (rewrite (X2 eq_refl); field; lra).
        assert (- more t * n <= delta t * X / k); [|lra].
        rewrite En. replace (- more t * (- x / k)) with (more t * x / k) by (field; lra).
        apply Rmult_le_compat_r; [left; now apply Rinv_0_lt_compat|].
        eapply Rle_trans; [apply Rle_abs|]. rewrite Rabs_mult. fold X. now apply Rmult_le_compat_r.
      - destruct (Un eq_refl) as [-> _]. assert (0 <= delta t * X / k); [|lra].
        apply Rmult_le_pos; [apply Rmult_le_pos; lra|]. left. now apply Rinv_0_lt_compat. }
    (* The friction part. *)
    assert (T2 : p - q <= - (if rubs t then spare t * l else 0) + (rough t * (base t + X) + phi t) * sigma t).
    { assert (More : (rough t * a + phi t) * sigma t <= (rough t * (base t + X) + phi t) * sigma t).
      { apply Rmult_le_compat_r; [exact Sn|]. apply Rplus_le_compat_r. now apply Rmult_le_compat_l. }
      destruct (rubs t) eqn:Ru.
      - destruct (Rb eq_refl) as (L & S & S0 & S1). destruct (Sp L S) as [V0 V1]. rewrite S in Law. cbn in Law.
        rewrite Rmax_right in Law by lra.
        assert (spare t <= rough t * a - phi t).
        { eapply Rle_trans; [exact S1|]. apply Rplus_le_compat_r. apply Rmult_le_compat_l; [exact Rn|]. lra. }
        assert (spare t * l <= (rough t * a - phi t) * l) by now apply Rmult_le_compat_r. lra.
      - pose proof (Nr eq_refl) as Z. rewrite Z in Fp, More |- *. assert (0 <= rough t * a * l) by now apply Rmult_le_pos. lra. }
    assert (En : (if is_listed t then k / 2 * (n * n) else 0) <= X * X / (2 * k)).
    { destruct (is_listed t) eqn:L.
      - rewrite Xx, (X2 eq_refl). right. field. lra.
      - rewrite Xx. apply Rmult_le_pos; [apply Rle_0_sqr|]. left. apply Rinv_0_lt_compat. lra. }
    (* The sum. *)
    set (m := delta t + rough t * k * sigma t) in *.
    assert (Sq : - (X * X) / k + delta t * X / k + (rough t * (base t + X) + phi t) * sigma t + X * X / (2 * k) <= gamma t).
    { apply Rmult_le_reg_l with (2 * k); [lra|].
      replace (2 * k * (- (X * X) / k + delta t * X / k + (rough t * (base t + X) + phi t) * sigma t + X * X / (2 * k)))
        with (- (X * X) + 2 * X * m + 2 * k * ((rough t * base t + phi t) * sigma t)) by (unfold m; field; lra).
      pose proof (Rle_0_sqr (X - m)) as Q. unfold Rsqr in Q. lra. }
    lra.
Qed.

(* At d0 itself. *)
Lemma moved_nowhere : moved (fun _ => 0) = d0.
Proof.
  unfold Energy.moved. subst D. induction d0 as [|x d IH]; cbn; [reflexivity|]. rewrite IH. f_equal. ring.
Qed.

Lemma energy_at_d0 t : grips t -> energy t (fun _ => 0) <= gamma t.
Proof.
  intros G. unfold energy, press_energy, rub_energy. rewrite dot_listed_zero, moved_nowhere.
  pose proof (slip_at_d0 t G) as S0. pose proof (sigma_nonneg t G) as Sn. pose proof (phi_nonneg t G) as Pn.
  assert (Rb : 0 <= rough t * base t).
  { rewrite (base_is t G). unfold pressed. destruct (spring (own t)) eqn:S; [rewrite (springs_smooth t G S); lra|].
    apply Rmult_le_pos; [apply (rough_nonneg t G)|apply Rmax_l]. }
  assert (Ga : (rough t * base t + phi t) * sigma t <= gamma t \/ stiffness (own t) = 0).
  { destruct (Req_dec (stiffness (own t)) 0) as [K|K]; [now right|left].
    assert (K0 : 0 < stiffness (own t)) by (pose proof (stiffness_nonneg t G); lra).
    pose proof (gamma_is t G K0) as Ga. set (m := delta t + _) in *. pose proof (Rle_0_sqr m) as Sq. unfold Rsqr in Sq.
    apply Rnot_lt_le. intros Lt. assert (0 < 2 * stiffness (own t) * ((rough t * base t + phi t) * sigma t - gamma t)).
    { apply Rmult_lt_0_compat; lra. } lra. }
  assert (Pr : (if is_listed t then stiffness (own t) / 2 * (0 * 0) else 0) = 0) by (destruct (is_listed t); ring).
  rewrite Pr. destruct (rubs t) eqn:Ru.
  - destruct (rubbing t G Ru) as (L & S & S0' & S1). destruct (pressing t G L S) as (R0 & _ & R1).
    destruct Ga as [Ga|K]; [|destruct (of_no_stiffness t G K); congruence].
    assert (B : base t = v (own t) d0 1 lambda).
    { rewrite (base_is t G). unfold pressed. rewrite S. apply Rmax_right. lra. }
    assert (spare t <= rough t * base t + phi t).
    { rewrite B. assert (rough t * (v (own t) d0 1 lambda - swing t) <= rough t * v (own t) d0 1 lambda).
      { apply Rmult_le_compat_l; [apply (rough_nonneg t G)|lra]. } lra. }
    assert (spare t * (turned t * size (weights (own t)) (slip (own t) d0)) <= spare t * sigma t)
      by (apply Rmult_le_compat_l; lra).
    assert (spare t * sigma t <= (rough t * base t + phi t) * sigma t) by now apply Rmult_le_compat_r. lra.
  - destruct Ga as [Ga|K]; [|destruct (of_no_stiffness t G K) as (_ & _ & ?); lra].
    assert (0 <= (rough t * base t + phi t) * sigma t) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma cv_energy t u x : grips t -> converges D u x -> Un_cv (fun k => energy t (u k)) (energy t x).
Proof.
  intros G U. unfold energy. apply (CV_plus (fun k => press_energy t (u k))); unfold press_energy, rub_energy.
  - destruct (is_listed t); [|apply cv_constant]. apply cv_multiple.
    assert (N : Un_cv (fun k => dot (N (own t)) (listed D (u k))) (dot (N (own t)) (listed D x))).
    { apply (cv_dot (fun _ => N (own t))); [apply cv_list_constant|now apply cv_listed]. }
    now apply CV_mult.
  - destruct (rubs t); [|apply cv_constant]. apply cv_multiple, cv_multiple.
    apply cv_size; [apply (RowLimits.weights_positive _ _ (grips_proper t G))|].
    apply (cv_slip (fun _ => own t)); [apply cv_row_constant|].
    apply (cv_listed D (fun k i => nth i d0 0 + u k i)). intros i I. apply (CV_plus (fun _ => nth i d0 0)); [apply cv_constant|].
    now apply U.
Qed.

(* All together. *)
Variable sys : system.
Variable ts : list grip.
Hypothesis all_grip : Forall grips ts.
Hypothesis own_rows : rows sys = map own ts.
Hypothesis loads_length : List.length (wrench sys) = D /\ List.length (direction sys) = D.
Hypothesis counters_balance : forall y, load sys 1 lambda y + works (map own ts) (map counter ts) y = 0.
Hypothesis little : over gamma ts < c.
Variable B : vec.
Hypothesis bounded_energy : forall e, Forall (fun t => energy t e <= c) ts -> in_box D B e.

Definition all_energy (e : vec) : R := over (fun t => energy t e) ts.

Lemma each_energy e : all_energy e <= c -> Forall (fun t => energy t e <= c) ts.
Proof.
  intros H. apply Forall_forall. intros t Ht. eapply Rle_trans; [|exact H].
  apply (over_one (fun t => energy t e)); [|exact Ht]. eapply Forall_impl; [|exact all_grip].
  intros. now apply energy_nonneg.
Qed.

Lemma works_below e fs : Forall (fun t => energy t e <= c) ts ->
  Forall2 (obeys Model.unilateral (moved e) 1 lambda) (map own ts) fs ->
  works (map own ts) fs (listed D e) - works (map own ts) (map counter ts) (listed D e) <=
  over gamma ts - over (fun t => energy t e) ts.
Proof.
  intros E. clear counters_balance little own_rows bounded_energy. revert fs.
  induction all_grip as [|t ts' G _ IH]; intros fs O; inversion O as [|? [a f] ? fs' Ob Os]; subst; cbn; [lra|].
  specialize (IH (Forall_inv_tail all_grip) (Forall_inv_tail E) fs' Os).
  pose proof (term_below t e a f G (Forall_inv E) Ob). lra.
Qed.

Theorem forces_found : exists e fs, Forall (fun t => energy t e <= c) ts /\
  Forall2 (obeys Model.unilateral (moved e) 1 lambda) (rows sys) fs /\
  forall y, load sys 1 lambda y + works (rows sys) fs y = 0.
Proof.
  assert (Pr : Forall (proper D) (rows sys)).
  { rewrite own_rows, Forall_map. eapply Forall_impl; [|exact all_grip]. intros t G. apply (grips_proper t G). }
  destruct (zero_inside D sys lambda d0 Pr loads_length (fun e => c - all_energy e) B) as (e & fs & I & O & Bal).
  - intros u x U. apply (CV_minus (fun _ => c)); [apply cv_constant|]. unfold all_energy.
    clear - U all_grip. induction all_grip as [|t ts' G _ IH]; cbn; [apply cv_constant|].
    apply (CV_plus (fun k => energy t (u k))); [now apply cv_energy|exact (IH (Forall_inv_tail all_grip))].
  - assert (L : all_energy (fun _ => 0) <= over gamma ts); [|lra].
    apply over_below. eapply Forall_impl; [|exact all_grip]. intros t G. now apply energy_at_d0.
  - intros e H. apply bounded_energy, each_energy. lra.
  - intros e fs H O. unfold pushing_at in O. unfold in_sum. rewrite own_rows in O |- *.
    assert (El : all_energy e = c) by lra.
    pose proof (works_below e fs (each_energy e ltac:(lra)) O) as W. unfold all_energy in El. rewrite El in W.
    specialize (counters_balance (listed D e)). lra.
  - exists e, fs. split; [apply each_energy; lra|]. split; [exact O|exact Bal].
Qed.

End Energy.

(* ---- How far that is ---- *)

Section Far.
Variable n : nat.
Variable answer : nat -> list R -> R.       (* the columns of M, as forms *)
Hypothesis answer_known : forall l, (l < n)%nat -> known_by_units n (answer l).
Variable Z : nat -> R.
Definition off (k l : nat) : R := answer l (basis_vector n k) - (if Nat.eqb k l then 1 else 0).
Hypothesis reached : forall k, (k < n)%nat -> 0 < Z k /\ sum_to n (fun l => Rabs (off k l) * Z l) < Z k.
Variable P : nat -> R.

Lemma by_answers e l : (l < n)%nat -> Rabs (answer l (listed n e)) <= P l ->
  Rabs (e l) <= P l + sum_to n (fun k => Rabs (off k l) * Rabs (e k)).
Proof.
  intros L H.
  assert (E : e l = answer l (listed n e) - sum_to n (fun k => off k l * e k)).
  { rewrite (answer_known l L (listed n e)).
    rewrite (sum_same n (fun i => nth i (listed n e) 0 * answer l (basis_vector n i))
      (fun k => off k l * e k + (if Nat.eqb l k then 1 else 0) * e k)).
    - rewrite sum_plus, (sum_one n l e L). ring.
    - intros k K. rewrite nth_listed by exact K. unfold off. rewrite (Nat.eqb_sym l k). ring. }
  rewrite E at 1. eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_Ropp. apply Rplus_le_compat; [exact H|].
  eapply Rle_trans; [apply sum_absolute|]. right. apply sum_same. intros. apply Rabs_mult.
Qed.

Lemma far_at_most e : (forall l, (l < n)%nat -> Rabs (answer l (listed n e)) <= P l) ->
  in_box n (fun k => sum_to n (fun l => Z l * P l) / (Z k - sum_to n (fun l => Rabs (off k l) * Z l))) e.
Proof.
  intros H k K.
  pose proof (room_left n (fun k l => Rabs (off k l)) Z P (fun k => Rabs (e k))) as T.
  specialize (T ltac:(intros l L; destruct (reached l L); lra) ltac:(intros l L; now apply by_answers; auto)).
  cbn beta in T.
  assert (One : (Z k - sum_to n (fun l => Rabs (off k l) * Z l)) * Rabs (e k) <= sum_to n (fun l => Z l * P l)).
  { eapply Rle_trans; [|exact T].
    apply (sum_one_below n (fun k => (Z k - sum_to n (fun l => Rabs (off k l) * Z l)) * Rabs (e k))); [exact K|].
    intros i I. destruct (reached i I). apply Rmult_le_pos; [lra|apply Rabs_pos]. }
  destruct (reached k K) as [_ R]. set (s := Z k - _) in *. set (t := sum_to n (fun l => Z l * P l)) in *.
  assert (Small : Rabs (e k) <= t / s).
  { apply Rmult_le_reg_l with s; [unfold s; lra|]. replace (s * (t / s)) with t by (field; unfold s; lra). exact One. }
  unfold Rabs in Small. destruct (Rcase_abs (e k)); lra.
Qed.

Lemma far_within E e : (forall l, (l < n)%nat -> Rabs (answer l (listed n e)) <= P l) ->
  (forall l, (l < n)%nat -> P l + sum_to n (fun k => Rabs (off k l) * E k) <= E l) ->
  forall k, (k < n)%nat -> Rabs (e k) <= E k.
Proof.
  intros H He k K. set (y := fun l => Rmax 0 (Rabs (e l) - E l)).
  assert (Y : forall l, 0 <= y l /\ Rabs (e l) - E l <= y l) by (intros l; unfold y; split; [apply Rmax_l|apply Rmax_r]).
  pose proof (room_left n (fun k l => Rabs (off k l)) Z (fun _ => 0) y) as T.
  specialize (T ltac:(intros l L; destruct (reached l L); lra)).
  assert (T' : sum_to n (fun k => (Z k - sum_to n (fun l => Rabs (off k l) * Z l)) * y k) <= sum_to n (fun l => Z l * 0)).
  { apply T. intros l L. rewrite Rplus_0_l.
    assert (S : sum_to n (fun k => Rabs (off k l) * Rabs (e k)) <=
      sum_to n (fun k => Rabs (off k l) * y k) + sum_to n (fun k => Rabs (off k l) * E k)).
    { rewrite <- sum_plus. apply sum_below. intros i _. destruct (Y i). rewrite <- Rmult_plus_distr_l.
      apply Rmult_le_compat_l; [apply Rabs_pos|lra]. }
    pose proof (by_answers e l L (H l L)). specialize (He l L).
    assert (0 <= sum_to n (fun k => Rabs (off k l) * y k)).
    { apply sum_nonneg. intros i _. apply Rmult_le_pos; [apply Rabs_pos|apply Y]. }
    unfold y at 1. apply Rmax_lub; lra. }
  rewrite (sum_zero n (fun l => Z l * 0)) in T' by (intros; ring).
  pose proof (sum_one_below n (fun k => (Z k - sum_to n (fun l => Rabs (off k l) * Z l)) * y k) k K) as One. cbn beta in One.
  assert (Pos : forall i, (i < n)%nat -> 0 <= (Z i - sum_to n (fun l => Rabs (off i l) * Z l)) * y i).
  { intros i I. destruct (reached i I). apply Rmult_le_pos; [lra|apply Y]. }
  specialize (One Pos). destruct (reached k K) as [_ R]. destruct (Y k) as [Y0 Y1].
  assert (y k <= 0); [|lra]. apply Rnot_lt_le. intros Lt.
  assert (0 < (Z k - sum_to n (fun l => Rabs (off k l) * Z l)) * y k) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

End Far.
