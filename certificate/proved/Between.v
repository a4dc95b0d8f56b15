(* SPDX-License-Identifier: MIT *)
(* From the middle of a contact's box (Box.v) to a choice in it there is a straight way, on which its row
   changes continuously and stays in the box: `row_at_inside`, `row_at_continuous`. *)
From Coq Require Import List Arith ZArith QArith Qreals Reals Lra Lia Bool FunctionalExtensionality.
From Proved Require Import Question Meaning Numbers Root Box Brouwer Homotopy RowLimits Degree.
From Proved Require Rows.
Import ListNotations.
Open Scope R_scope.

(* ---- Limits of lists, and of functions that are affine in each of several parameters ---- *)

Lemma cv_list_by_numbers n us x : (forall k, List.length (us k) = n) -> List.length x = n ->
  (forall i, (i < n)%nat -> Un_cv (fun k => nth i (us k) 0) (nth i x 0)) -> cv_list us x.
Proof.
  revert us x. induction n as [|n IH]; intros us x L Lx C.
  - destruct x; [|discriminate]. replace us with (fun _ : nat => @nil R); [constructor|].
    apply functional_extensionality. intros k. specialize (L k). now destruct (us k).
  - destruct x as [|y x]; [discriminate|].
    replace us with (fun k => hd 0 (us k) :: tl (us k)).
    + apply (cv_cons (fun k => hd 0 (us k))).
      * replace (fun k => hd 0 (us k)) with (fun k => nth 0 (us k) 0); [apply (C O); lia|].
        apply functional_extensionality. intros k. now destruct (us k).
      * apply IH; [|now injection Lx|].
        -- intros k. specialize (L k). destruct (us k); cbn in *; lia.
        -- intros i I. replace (fun k => nth i (tl (us k)) 0) with (fun k => nth (S i) (us k) 0); [apply (C (S
          i)); lia|].
           apply functional_extensionality. intros k. specialize (L k). destruct (us k); [discriminate|reflexivity].
    + apply functional_extensionality. intros k. specialize (L k). destruct (us k); [discriminate|reflexivity].
Qed.

Lemma cv_lists_by_members n us x : (forall k, List.length (us k) = n) -> List.length x = n ->
  (forall j, (j < n)%nat -> cv_list (fun k => nth j (us k) []) (nth j x [])) -> cv_lists us x.
Proof.
  revert us x. induction n as [|n IH]; intros us x L Lx C.
  - destruct x; [|discriminate]. replace us with (fun _ : nat => @nil (list R)); [constructor|].
    apply functional_extensionality. intros k. specialize (L k). now destruct (us k).
  - destruct x as [|y x]; [discriminate|].
    replace us with (fun k => hd [] (us k) :: tl (us k)).
    + apply (cv_lists_cons (fun k => hd [] (us k))).
      * replace (fun k => hd [] (us k)) with (fun k => nth 0 (us k) []); [apply (C O); lia|].
        apply functional_extensionality. intros k. now destruct (us k).
      * apply IH; [|now injection Lx|].
        -- intros k. specialize (L k). destruct (us k); cbn in *; lia.
        -- intros i I. replace (fun k => nth i (tl (us k)) []) with (fun k => nth (S i) (us k) []); [apply (C
          (S i)); lia|].
           apply functional_extensionality. intros k. specialize (L k). destruct (us k); [discriminate|reflexivity].
    + apply functional_extensionality. intros k. specialize (L k). destruct (us k); [discriminate|reflexivity].
Qed.

(* A function that is affine in each of several numbers is continuous. *)
Lemma multiaffine_cv ps p G : multiaffine (List.length p) G -> cv_list ps p -> Un_cv (fun k => G (ps k)) (G p).
Proof.
  intros M C. revert G M. induction C as [|u x us xs U C IH]; intros G M; [apply cv_constant|].
  cbn in M. destruct M as [A M].
  assert (E : forall y p', List.length p' = List.length xs ->
    G (y :: p') = G (0 :: p') + y * (G (1 :: p') - G (0 :: p'))).
  { intros y p' L. destruct (A p' L) as (a & b & H). rewrite !H. ring. }
  rewrite (E x xs eq_refl).
  replace (fun k => G (u k :: us k)) with (fun k => G (0 :: us k) + u k * (G (1 :: us k) - G (0 :: us k)))
    by (apply functional_extensionality; intros k; rewrite (E (u k) (us k)); [reflexivity|now apply
      cv_list_length]).
  pose proof (IH (fun p => G (0 :: p)) (M 0)) as C0. pose proof (IH (fun p => G (1 :: p)) (M 1)) as C1. cbn in
    C0, C1.
  apply (CV_plus (fun k => G (0 :: us k))); [exact C0|]. apply (CV_mult u); [exact U|]. now apply CV_minus.
Qed.

(* ---- Straight ways ---- *)

Definition mix (t a b : R) : R := (1 - t) * a + t * b.

(* The same for lists. *)
Fixpoint mixed (t : R) (a b : list R) : list R :=
  match a, b with x :: a', y :: b' => mix t x y :: mixed t a' b' | _, _ => [] end.

(* From 0 to 1, whatever the time. *)
Definition clamp (t : R) : R := Rmax 0 (Rmin 1 t).

Lemma clamp_range t : 0 <= clamp t <= 1.
Proof. unfold clamp, Rmax, Rmin. destruct (Rle_dec 1 t); destruct Rle_dec; lra. Qed.

Lemma clamp_same t : 0 <= t <= 1 -> clamp t = t.
Proof. intros H. unfold clamp. rewrite Rmin_right, Rmax_right by lra. reflexivity. Qed.

Lemma cv_clamp s s' : Un_cv s s' -> Un_cv (fun k => clamp (s k)) (clamp s').
Proof. intros S. apply cv_max; [apply cv_constant|]. apply cv_min; [apply cv_constant|exact S]. Qed.

Lemma cv_mix s s' a b : Un_cv s s' -> Un_cv (fun k => mix (s k) a b) (mix s' a b).
Proof.
  intros S. apply (CV_plus (fun k => (1 - s k) * a)); apply CV_mult; try apply cv_constant; [|exact S].
  apply (CV_minus (fun _ => 1)); [apply cv_constant|exact S].
Qed.

Lemma cv_mixed s s' a b : List.length a = List.length b -> Un_cv s s' ->
  cv_list (fun k => mixed (s k) a b) (mixed s' a b).
Proof.
  intros L S. revert b L. induction a as [|x a IH]; intros [|y b] L; try discriminate; cbn; [constructor|].
  apply (cv_cons (fun k => mix (s k) x y)); [now apply cv_mix|]. apply IH. now injection L.
Qed.

Lemma mixed_end a b : List.length a = List.length b -> mixed 1 a b = b.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b] L; try discriminate; cbn; [reflexivity|].
  rewrite IH by now injection L. f_equal. unfold mix. ring.
Qed.

Lemma mixed_start a b : List.length a = List.length b -> mixed 0 a b = a.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b] L; try discriminate; cbn; [reflexivity|].
  rewrite IH by now injection L. f_equal. unfold mix. ring.
Qed.

Lemma mixed_length t a b : List.length a = List.length b -> List.length (mixed t a b) = List.length a.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b] L; try discriminate; cbn; [reflexivity|].
  now rewrite IH by now injection L.
Qed.

Lemma mix_within i t a b : 0 <= t <= 1 -> within i a -> within i b -> within i (mix t a b).
Proof. unfold within, mix. intros. split; nra. Qed.

Lemma mixed_within is t a b : 0 <= t <= 1 -> Forall2 within is a -> Forall2 within is b ->
  Forall2 within is (mixed t a b).
Proof.
  intros T A. revert b. induction A as [|i x is a Wx A IH]; intros b Bw; inversion Bw; subst; cbn; constructor.
  - now apply mix_within.
  - now apply IH.
Qed.

(* ---- The middle of a box ---- *)

Definition middle (i : interval) : Q := ((low i + high i) * (1 # 2))%Q.

(* An interval of one number. *)
Definition only_middle (i : interval) : interval := exactly (middle i).

Definition middle_box (b : cbox) : cbox :=
  CBox (box_names b) (map only_middle (box_geometry b)) (box_forms b) (only_middle (box_friction b))
    (only_middle (box_preload b)) (only_middle (box_growth b)) (only_middle (box_stiffness b)) (box_square b)
    (box_normal b) (box_weights b) (box_signed b) (box_spring b) (box_turns b) (box_slack b).

Lemma middle_is i : Q2R (middle i) = (Q2R (low i) + Q2R (high i)) / 2.
Proof. unfold middle. rewrite Q2R_mult, Q2R_plus. unfold Q2R at 3. cbn. field. Qed.

Lemma middle_within i x : within i x -> within i (Q2R (middle i)).
Proof. unfold within. rewrite middle_is. lra. Qed.

Lemma exactly_within q : within (exactly q) (Q2R q).
Proof. unfold within; cbn. lra. Qed.

(* Friction is nowhere below 0, and 0 of springs. *)
Definition friction_sound (b : cbox) : bool :=
  Qle_bool 0 (low (box_friction b)) && (negb (box_spring b) || Qle_bool (high (box_friction b)) 0).

(* The forms of rows in a box are continuous. *)
Lemma forms_continuous b r p F mu t qs q : inside_at b r p F mu t -> List.length q = List.length (box_geometry b) ->
  cv_list qs q -> cv_lists (fun i => F (qs i)) (F q).
Proof.
  intros I L C.
  assert (Shape : forall i, map (@List.length R) (F (qs i)) = map (@List.length R) (F q)).
  { intros i. apply (forms_shape _ _ _ _ _ _ I); [|exact L]. now rewrite (cv_list_length _ _ i C). }
  apply (cv_lists_by_members (List.length (F q))).
  - intros i. specialize (Shape i). apply (f_equal (@List.length nat)) in Shape. now rewrite !map_length in Shape.
  - reflexivity.
  - intros j _. set (n := List.length (nth j (F q) [])).
    assert (Len : forall i, List.length (nth j (F (qs i)) []) = n).
    { intros i. unfold n. rewrite <- !(map_nth (@List.length R)). cbn [List.length]. now rewrite Shape. }
    apply (cv_list_by_numbers n); [exact Len|reflexivity|]. intros i Hi.
    rewrite <- (dot_unit _ n i Hi).
    apply cv_same with (fun k => Rows.dot (nth j (F (qs k)) []) (basis_vector n i)).
    + intros k. now rewrite dot_unit.
    + apply (multiaffine_cv _ _ (fun q => Rows.dot (nth j (F q) []) (basis_vector n i))); [|exact C].
      rewrite L. apply (forms_affine _ _ _ _ _ _ I).
Qed.

Lemma cv_lists_head us x : cv_lists us x -> cv_list (fun i => hd [] (us i)) (hd [] x).
Proof. intros C. destruct C; [constructor|assumption]. Qed.

Lemma cv_lists_tail us x : cv_lists us x -> cv_lists (fun i => tl (us i)) (tl x).
Proof. intros C. destruct C; [constructor|assumption]. Qed.

Section Way.
Variable D : nat.
Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.
Hypothesis r_proper : proper D r.

Hypothesis sound : friction_sound b = true.

Definition center : list R := map (fun i => Q2R (middle i)) (box_geometry b).

(* The row at the time s. *)
Definition row_at (s : R) : Rows.row :=
  let fs := F (mixed s center p) in
  let u := mix s (1 / 2) t in
  Rows.Row (hd [] fs) (tl fs) (Rows.weights r) (mix s (Q2R (middle (box_friction b))) mu * sqrt (Q2R
    (box_square b)))
    (mix u (Q2R (low (box_preload b))) (Q2R (high (box_preload b))))
    (mix u (Q2R (low (box_growth b))) (Q2R (high (box_growth b))))
    (mix s (Q2R (middle (box_stiffness b))) (Rows.stiffness r)) (Rows.spring r).

Lemma p_length : List.length p = List.length (box_geometry b).
Proof. symmetry. apply (same_length within). apply I. Qed.

Lemma center_length : List.length center = List.length p.
Proof. unfold center. now rewrite map_length, p_length. Qed.

Lemma mixed_geometry s : List.length (mixed s center p) = List.length (box_geometry b).
Proof. rewrite mixed_length, center_length; [apply p_length|apply center_length]. Qed.

(* Rows on the way have the shape of the last. *)
Lemma shape_at s : map (@List.length R) (F (mixed s center p)) = D :: map (@List.length R) (Rows.slips r).
Proof.
  rewrite (forms_shape _ _ _ _ _ _ I _ p); [|rewrite mixed_length, center_length; [apply p_length|apply
    center_length]|apply p_length].
  rewrite <- (is_forms _ _ _ _ _ _ I). cbn. now rewrite (N_length _ _ r_proper).
Qed.

Lemma forms_at s : exists n ss, F (mixed s center p) = n :: ss /\ List.length n = D /\
  map (@List.length R) ss = map (@List.length R) (Rows.slips r).
Proof.
  pose proof (shape_at s) as E. destruct (F (mixed s center p)) as [|n ss]; [discriminate|]. injection E as E1 E2.
  now exists n, ss.
Qed.

(* At the end it is the choice. *)
Lemma row_at_end : row_at 1 = r.
Proof.
  unfold row_at. rewrite mixed_end by apply center_length. rewrite <- (is_forms _ _ _ _ _ _ I). cbn [hd tl].
  unfold mix. replace (1 - 1) with 0 by ring. rewrite !Rmult_0_l, !Rplus_0_l, !Rmult_1_l.
  rewrite <- (in_preload _ _ _ _ _ _ I), <- (in_growth _ _ _ _ _ _ I), <- (is_rho _ _ _ _ _ _ I). now destruct r.
Qed.

(* Its friction coefficient. *)
Definition friction_at (s : R) : R := mix s (Q2R (middle (box_friction b))) mu.

Lemma friction_at_nonneg s : 0 <= s <= 1 -> 0 <= friction_at s.
Proof.
  intros S. apply andb_true_iff in sound as [L _]. apply Qle_bool_R in L. rewrite Q2R_0 in L.
  pose proof (friction_nonneg _ _ _ _ _ _ I) as M. pose proof (in_friction _ _ _ _ _ _ I) as Wf.
  apply middle_within in Wf as [W1 _]. unfold friction_at, mix. nra.
Qed.

Lemma friction_at_spring s : 0 <= s <= 1 -> box_spring b = true -> friction_at s = 0.
Proof.
  intros S Sp. apply andb_true_iff in sound as [L H]. rewrite Sp in H. cbn in H. apply Qle_bool_R in L, H.
  rewrite Q2R_0 in L, H. pose proof (in_friction _ _ _ _ _ _ I) as Wf. unfold friction_at, mix. rewrite middle_is.
  destruct Wf. nra.
Qed.

Lemma row_at_proper s : 0 <= s <= 1 -> proper D (row_at s).
Proof.
  intros S. destruct (forms_at s) as (n & ss & E & L & Ls). unfold row_at. rewrite E. cbn [hd tl].
  constructor; cbn.
  - exact L.
  - pose proof (slips_length _ _ r_proper) as P. clear - Ls P. revert ss Ls.
    induction P as [|x xs Hx P IH]; intros [|s ss] Ls; try discriminate; constructor; injection Ls as L1 L2;
      [congruence|auto].
  - apply I.
  - rewrite (RowLimits.weights_length _ _ r_proper). apply (f_equal (@List.length nat)) in Ls.
    now rewrite !map_length in Ls.
  - apply Rmult_le_pos; [now apply friction_at_nonneg|apply sqrt_pos].
  - intros Sp. rewrite (is_spring _ _ _ _ _ _ I) in Sp. fold (friction_at s). rewrite friction_at_spring by
      assumption. ring.
Qed.

Lemma center_within : Forall2 within (box_geometry b) center.
Proof.
  pose proof (in_geometry _ _ _ _ _ _ I) as G. unfold center. clear - G.
  induction G as [|i x is p Wx G IH]; cbn; constructor; [now apply middle_within in Wx|exact IH].
Qed.

(* On the way it stays in the box. *)
Lemma row_at_inside s : 0 <= s <= 1 ->
  inside_at b (row_at s) (mixed s center p) F (friction_at s) (mix s (1 / 2) t).
Proof.
  intros S. destruct (forms_at s) as (n & ss & E & L & Ls).
  assert (U : 0 <= mix s (1 / 2) t <= 1) by (pose proof (in_step _ _ _ _ _ _ I); unfold mix; nra).
  assert (NoSlips : Rows.slips r = [] -> tl (F (mixed s center p)) = []).
  { rewrite E. cbn. intros Z. rewrite Z in Ls. now destruct ss. }
  constructor; try reflexivity; try assumption; try apply I.
  - apply mixed_within; [exact S|apply center_within|apply I].
  - unfold row_at. cbn. rewrite E. reflexivity.
  - apply mix_within; [exact S| |apply I]. apply middle_within with mu, I.
  - now apply friction_at_nonneg.
  - apply mix_within; [exact S| |apply I]. apply middle_within with (Rows.stiffness r), I.
  - intros Sp. now apply friction_at_spring.
  - intros Sp. apply NoSlips, (spring_alone _ _ _ _ _ _ I Sp).
  - intros Sg. destruct (is_signed _ _ _ _ _ _ I Sg) as (Sl & We & Sq). split; [|split; [|exact Sq]].
    + destruct Sl as [Z|(T0 & Z)]; [left; now apply NoSlips|right].
      unfold row_at. cbn. rewrite E. cbn. rewrite Z in Ls. destruct ss as [|T1 [|? ?]]; try discriminate. now
        exists T1.
    + unfold row_at. cbn. rewrite We, E. cbn. clear - Ls. revert ss Ls.
      induction (Rows.slips r) as [|x xs IH]; intros [|y ss] Ls; try discriminate; cbn; [reflexivity|].
      f_equal. apply IH. now injection Ls.
Qed.

(* The beginning is in the middle of the box. *)
Lemma row_at_middle : inside_at (middle_box b) (row_at 0) (mixed 0 center p) F (friction_at 0) (mix 0 (1 / 2) t).
Proof.
  pose proof (row_at_inside 0 ltac:(lra)) as I0.
  assert (M : forall x y, mix 0 x y = x) by (intros; unfold mix; ring).
  constructor; try apply I0; cbn [middle_box box_geometry box_forms box_friction box_preload box_growth
    box_stiffness].
  - rewrite mixed_start by apply center_length. unfold center. clear.
    induction (box_geometry b) as [|i is IH]; cbn; constructor; [apply exactly_within|exact IH].
  - intros j d. rewrite map_length. apply (forms_affine _ _ _ _ _ _ I).
  - intros q q'. rewrite map_length. apply (forms_shape _ _ _ _ _ _ I).
  - unfold friction_at. rewrite M. apply exactly_within.
  - unfold row_at. cbn. rewrite M. rewrite middle_is. unfold mix. lra.
  - unfold row_at. cbn. rewrite M. rewrite middle_is. unfold mix. lra.
  - unfold row_at. cbn. rewrite M. apply exactly_within.
Qed.

(* And it moves continuously. *)
Lemma row_at_continuous s s' : Un_cv s s' -> cv_row (fun k => row_at (s k)) (row_at s').
Proof.
  intros Cs. assert (Cp : cv_list (fun k => mixed (s k) center p) (mixed s' center p))
    by (apply cv_mixed; [apply center_length|exact Cs]).
  assert (Forms : cv_lists (fun k => F (mixed (s k) center p)) (F (mixed s' center p))).
  { apply (forms_continuous b r p F mu t); [exact I| |exact Cp].
    rewrite mixed_length, center_length; [apply p_length|apply center_length]. }
  constructor; cbn.
  - now apply cv_lists_head.
  - now apply cv_lists_tail.
  - reflexivity.
  - apply CV_mult; [now apply cv_mix|apply cv_constant].
  - apply (cv_mix (fun k => mix (s k) (1 / 2) t)). now apply cv_mix.
  - apply (cv_mix (fun k => mix (s k) (1 / 2) t)). now apply cv_mix.
  - now apply cv_mix.
  - reflexivity.
Qed.

End Way.
