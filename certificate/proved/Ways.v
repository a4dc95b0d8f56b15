(* SPDX-License-Identifier: MIT *)
(* What rows of a box stand for (Leaf.v): from the middle of the box to a choice that is seen in it there is a way of
   such rows, which changes continuously: `way_to`. *)
From Coq Require Import List Arith ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Meaning Numbers Root Box Leaf Brouwer Homotopy RowLimits Degree Between.
From Proved Require Rows.
Import ListNotations.
Open Scope R_scope.

(* A row in a box stands for itself. *)
Lemma inside_seen b r : inside b r -> seen_in b r.
Proof.
  intros (p & F & mu & t & I).
  exists r, p, F, mu, t, F, (fun _ => sqrt (Q2R (box_square b))), (fun _ => 0). split; [exact I|].
  split; [|exact (inside_row _ _ _ _ _ _ I)]. constructor.
  - intros. apply stands_for_itself. cbn. rewrite <- (is_weights _ _ _ _ _ _ I). apply I.
  - intros. apply sqrt_pos.
  - intros. apply (slack_nonneg _ _ _ _ _ _ I).
  - intros qs q L C. split; [now apply (forms_continuous b r p F mu t)|apply cv_constant].
  - intros; split; reflexivity.
Qed.

Lemma middle_seen_as b F G len k : seen_as b F G len k -> seen_as (middle_box b) F G len k.
Proof.
  intros [S L Sl C St]. constructor; cbn [middle_box box_geometry box_square box_slack box_turns];
    rewrite ?map_length; assumption.
Qed.

Lemma fits_suits row r : fits row r -> suits row r.
Proof. intros [E I]. split; [exact E|now apply inside_seen]. Qed.

Lemma all_suit rows rs : Forall2 fits rows rs -> Forall2 suits rows rs.
Proof. induction 1; constructor; [now apply fits_suits|assumption]. Qed.

(* Rows of one shape are proper together. *)
Lemma proper_alike D r r' : proper D r -> Rows.N r = Rows.N r' ->
  map (@List.length R) (Rows.slips r) = map (@List.length R) (Rows.slips r') -> Rows.weights r = Rows.weights r' ->
  0 <= Rows.rho r' -> (Rows.spring r' = true -> Rows.rho r' = 0) -> proper D r'.
Proof.
  intros [N S P L _ _] EN ES EW R0 Sp. constructor; try assumption; try (now rewrite <- ?EN, <- ?EW).
  - clear - S ES. revert ES. generalize (Rows.slips r'). induction S as [|x xs Hx S IH]; intros [|y ys] E;
      try discriminate; constructor; injection E as E1 E2; [congruence|auto].
  - rewrite <- EW, L. apply (f_equal (@List.length nat)) in ES. now rewrite !map_length in ES.
Qed.

(* So is the row of the box that stands for a proper row. *)
Lemma stands_proper D b k r r' p F mu t : stands k r r' -> inside_at b r' p F mu t -> proper D r -> proper D r'.
Proof.
  intros St I P. apply (proper_alike D r); [exact P|symmetry; apply St|symmetry; apply St|symmetry; apply St| |].
  - rewrite (is_rho _ _ _ _ _ _ I). apply Rmult_le_pos; [apply (friction_nonneg _ _ _ _ _ _ I)|apply sqrt_pos].
  - intros Sp. rewrite (is_spring _ _ _ _ _ _ I) in Sp.
    rewrite (is_rho _ _ _ _ _ _ I), (spring_smooth _ _ _ _ _ _ I Sp). ring.
Qed.

(* And a row of a box with forms of D numbers. *)
Lemma seen_proper D b r : seen_in b r -> List.length (Rows.N r) = D ->
  Forall (fun f => List.length f = D) (Rows.slips r) -> List.length (Rows.weights r) = List.length (Rows.slips r) ->
  proper D r.
Proof.
  intros (r' & p & F & mu & t & G & len & k & I & Se & ->) N S W.
  pose proof (true_row_stands _ _ _ _ _ _ _ _ _ I Se) as St.
  constructor; try assumption; [apply St| |]; cbn.
  - apply Rmult_le_pos; [apply (friction_nonneg _ _ _ _ _ _ I)|apply (len_nonneg _ _ _ _ _ Se)].
  - intros Sp. rewrite (spring_smooth _ _ _ _ _ _ I Sp). ring.
Qed.

(* What does not slip for one does not for the other. *)
Lemma stands_free k r r' z : stands k r r' -> List.length (Rows.weights r) = List.length (Rows.slips r) ->
  Forall (fun s => Rows.dot s z = 0) (Rows.slips r') -> Forall (fun s => Rows.dot s z = 0) (Rows.slips r).
Proof.
  intros St L F.
  assert (Z' : Rows.size (Rows.weights r') (Rows.slip r' z) = 0).
  { unfold Rows.size, Rows.slip. replace (Rows.product _ _ _) with 0; [apply sqrt_0|]. symmetry.
    generalize (Rows.weights r'). clear - F. induction F as [|s ss Hs F IH]; intros [|w ws]; cbn; try reflexivity.
    rewrite Hs, IH. ring. }
  assert (Z : Rows.size (Rows.weights r) (Rows.slip r z) = 0).
  { destruct (Rle_lt_or_eq_dec 0 _ (Rows.size_nonneg (Rows.weights r) (Rows.slip r z))) as [P|P]; [|now symmetry].
    apply (slides _ _ _ St) in P. lra. }
  apply Forall_forall. intros s Hs. apply In_nth with (d := []) in Hs as (j & Hj & <-).
  transitivity (nth j (Rows.slip r z) 0).
  - symmetry. unfold Rows.slip. exact (map_nth (fun f => Rows.dot f z) (Rows.slips r) [] j).
  - apply (Rows.size_zero_nth (Rows.weights r)); [apply St|exact Z|lia].
Qed.

Section Way.
Variable D : nat.
Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.
Hypothesis r_proper : proper D r.
Hypothesis sound : friction_sound b = true.

(* The rows that these stand for. *)
Variables (G : list R -> list (list R)) (len k : list R -> R).
Hypothesis seen : seen_as b F G len k.

Notation center := (center b).
Notation friction_at := (friction_at b mu).
Notation row_at := (row_at b r p F mu t).

Definition true_at (s : R) : Rows.row :=
  let q := mixed s center p in
  row_of b (G q) (friction_at s * len q) (Rows.preload (row_at s)) (Rows.growth (row_at s)) (Rows.stiffness (row_at s)).

Lemma true_at_end : true_at 1 = row_of b (G p) (mu * len p) (Rows.preload r) (Rows.growth r) (Rows.stiffness r).
Proof.
  unfold true_at. rewrite (row_at_end D b r p F mu t I r_proper), mixed_end by apply (center_length b r p F mu t I).
  unfold Between.friction_at, mix. f_equal. ring.
Qed.

Lemma true_at_seen s : 0 <= s <= 1 -> seen_in b (true_at s).
Proof.
  intros S. exists (row_at s), (mixed s center p), F, (friction_at s), (mix s (1 / 2) t), G, len, k.
  split; [now apply (row_at_inside D)|]. split; [exact seen|reflexivity].
Qed.

Lemma true_at_middle : seen_in (middle_box b) (true_at 0).
Proof.
  exists (row_at 0), (mixed 0 center p), F, (friction_at 0), (mix 0 (1 / 2) t), G, len, k.
  split; [now apply (row_at_middle D)|]. split; [now apply middle_seen_as|reflexivity].
Qed.

Lemma true_at_proper s : 0 <= s <= 1 -> proper D (true_at s).
Proof.
  intros S. pose proof (row_at_inside D b r p F mu t I r_proper sound s S) as I'.
  pose proof (true_row_stands _ _ _ _ _ _ _ _ _ I' seen) as St. fold (true_at s) in St.
  apply (proper_alike D (row_at s)); [now apply row_at_proper|apply St|apply St|apply St| |].
  - cbn. apply Rmult_le_pos; [now apply (friction_at_nonneg b r p F mu t)|apply (len_nonneg _ _ _ _ _ seen)].
  - intros Sp. change (box_spring b = true) in Sp. cbn. rewrite (friction_at_spring b r p F mu t) by assumption. ring.
Qed.

Lemma true_at_continuous s s' : Un_cv s s' -> cv_row (fun i => true_at (s i)) (true_at s').
Proof.
  intros Cs. destruct (true_continuous _ _ _ _ _ seen (fun i => mixed (s i) center p) (mixed s' center p)) as [CG CL].
  - apply (mixed_geometry b r p F mu t I).
  - apply cv_mixed; [apply (center_length b r p F mu t I)|exact Cs].
  - destruct (row_at_continuous b r p F mu t I s s' Cs) as [_ _ _ _ Cp Cu Ck _].
    constructor; cbn [true_at row_of Rows.N Rows.slips Rows.weights Rows.rho Rows.preload Rows.growth Rows.stiffness
      Rows.spring]; try assumption; try reflexivity.
    + now apply (cv_lists_head (fun i => G (mixed (s i) center p))).
    + now apply (cv_lists_tail (fun i => G (mixed (s i) center p))).
    + apply CV_mult; [|exact CL]. unfold Between.friction_at. now apply cv_mix.
Qed.

End Way.

(* The way, from the time 0 to the time 1. *)
Theorem way_to D b r : seen_in b r -> proper D r -> friction_sound b = true -> exists way : R -> Rows.row,
  way 1 = r /\ seen_in (middle_box b) (way 0) /\
  (forall s, 0 <= s <= 1 -> seen_in b (way s) /\ proper D (way s)) /\
  (forall s s', Un_cv s s' -> cv_row (fun k => way (s k)) (way s')).
Proof.
  intros Se P S. destruct Se as (r' & p & F & mu & t & G & len & k & I & Se & E).
  assert (P' : proper D r').
  { apply (stands_proper D b (k p) r r' p F mu t); [|exact I|exact P]. rewrite E. now apply true_row_stands with F t. }
  exists (true_at b r' p F mu t G len). split; [|split; [|split]].
  - rewrite E. apply true_at_end with D; assumption.
  - now apply (true_at_middle D) with k.
  - intros s Hs. split; [now apply (true_at_seen D) with k|now apply (true_at_proper D) with k].
  - intros s s' C. now apply true_at_continuous with k.
Qed.
