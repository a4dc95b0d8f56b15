(* SPDX-License-Identifier: MIT *)
(* The theorem: whatever the oracle says, the answers of the checker are true. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf Tree Witness Margin Checker.
From Proved Require SpaceBox SpaceLeaf SpaceTree SpaceWitness.
From Proved Require Model SpaceModel.
Import ListNotations.
Open Scope R_scope.

Lemma enlarge_all_fits bits qs rows cs : enlarge_all bits qs = Some rows ->
  Forall2 chosen_contact qs cs -> Forall2 fits rows cs.
Proof.
  intros H F. revert rows H. induction F as [|q c qs cs Fq F IH]; intros rows; cbn.
  - intros E. injection E as <-. constructor.
  - destruct (enlarge bits q) as [b|] eqn:B; [|discriminate].
    destruct (enlarge_all bits qs) as [rows'|]; [|discriminate]. intros E. injection E as <-.
    constructor; [|now apply IH]. split; [reflexivity|]. cbn.
    eapply enlarge_inside; eassumption.
Qed.

Lemma chosen_solution bits q s g lambda d forces : setting_of bits q = Some s -> chosen q g ->
  0 <= lambda -> Model.equilibrium g lambda d forces ->
  solution (rows s) (the_load s) g lambda d forces.
Proof.
  intros H (_ & F & W & U & _) L E. unfold setting_of in H.
  destruct (enlarge_all bits (contacts q)) as [rws|] eqn:A; [|discriminate]. injection H as <-.
  cbn [rows the_load]. constructor; try assumption.
  - eapply enlarge_all_fits; eassumption.
  - reflexivity.
Qed.

Lemma chosen_exact bits q s g : setting_of bits q = Some s -> chosen q g ->
  is_one_grasp s = true ->
  Forall2 fits (rows s) (Model.contacts g) /\ exact_rows (rows s) = true /\
  exact_load (the_load s) g /\
  Model.normal g = (if bilateral q then Model.bilateral else Model.unilateral).
Proof.
  intros H (_ & F & W & U & N) X. unfold setting_of in H.
  destruct (enlarge_all bits (contacts q)) as [rws|] eqn:A; [|discriminate]. injection H as <-.
  unfold is_one_grasp in X. apply andb_true_iff in X as [X1 X2].
  cbn [rows the_load] in *. repeat split; try assumption. eapply enlarge_all_fits; eassumption.
Qed.

Lemma enlarge_all_fits_in_space bits qs rows cs : enlarge_all_in_space bits qs = Some rows ->
  Forall2 chosen_contact_in_space qs cs -> Forall2 SpaceLeaf.fits rows cs.
Proof.
  intros H F. revert rows H. induction F as [|q c qs cs Fq F IH]; intros rows; cbn.
  - intros E. injection E as <-. constructor.
  - destruct (SpaceBox.enlarge bits q) as [b|] eqn:B; [|discriminate].
    destruct (enlarge_all_in_space bits qs) as [rows'|]; [|discriminate]. intros E.
    injection E as <-. constructor; [|now apply IH]. split; [reflexivity|].
    eapply SpaceBox.enlarge_inside; eassumption.
Qed.

Section Correct.
Variable memory : Type.
Variable advisor : oracle memory.

(* Where trees about ranges are accepted, no multiple in these ranges has an equilibrium. *)
Theorem refute_correct q bits s ranges nodes g lambda :
  setting_of bits q = Some s -> chosen q g ->
  refute memory advisor q s ranges nodes = None -> 0 <= lambda ->
  Exists (fun r => in_range r lambda) ranges -> ~ Model.stable_at g lambda.
Proof.
  intros S C R L X (d & forces & E).
  apply (refuted_multiple memory advisor _ _ s ranges nodes g lambda d forces R).
  - now apply (chosen_solution bits q).
  - apply C.
  - exact X.
Qed.

Theorem plane_correct q c : dimension q = 3%nat ->
  true_answer q (check_in_plane memory advisor q c).
Proof.
  intros D. assert (NS : forall (P : SpaceModel.grasp -> Prop) g, chosen_in_space q g -> P g).
  { intros P g (D6 & _). rewrite D in D6. discriminate. }
  unfold check_in_plane. destruct (setting_of (bits c) q) as [s|] eqn:S; [|exact I].
  destruct (body c) as [w|parts|nodes|resisted segments nodes| |claims];
    destruct (is_margin q); try exact I.
  - (* a witness *)
    destruct (is_one_grasp s) eqn:X; [|exact I].
    destruct (check_at (bilateral q) (rows s) (the_load s) (Point (Some 0%Q) w)) as [ss|] eqn:W;
      [|exact I].
    split; [|apply NS]. intros g C. destruct (chosen_exact _ _ _ _ S C X) as (F & E & L & N).
    eapply witness_stable; eassumption.
  - (* a tree *)
    destruct (refute memory advisor q s [at_zero] nodes) as [[rule number]|] eqn:R; [exact I|].
    split; [|apply NS]. intros g C.
    apply (refute_correct q _ s [at_zero] nodes g 0 S C R (Rle_refl 0)).
    constructor. unfold in_range, at_zero; cbn. rewrite Q2R_0.
    repeat split; try discriminate; lra.
  - (* a margin *)
    destruct (is_one_grasp s) eqn:X; [|exact I].
    destruct (order_fails _ _ resisted 0); [exact I|].
    destruct (segments_fail _ _ _ segments resisted None None 0) as [[rule at_]|] eqn:SF; [exact I|].
    destruct (refute memory advisor q s (gaps resisted) nodes) as [[rule number]|] eqn:R; [exact I|].
    split; [exact D|].
    intros g C lambda L0. destruct (chosen_exact _ _ _ _ S C X) as (F & E & L & N). split.
    + intros St. destruct (gaps_cover resisted lambda L0) as [A|G]; [exact A|].
      exfalso. exact (refute_correct q _ s _ nodes g lambda S C R L0 G St).
    + intros A. eapply segments_resist; try eassumption; [discriminate|].
      destruct resisted as [|[lo hi] resisted']; inversion A; subst; [left|right]; assumption.
Qed.

Theorem space_correct q c : dimension q = 6%nat ->
  true_answer q (check_in_space memory advisor q c).
Proof.
  intros D. assert (NP : forall (P : Model.grasp -> Prop) g, chosen q g -> P g).
  { intros P g (D3 & _). rewrite D in D3. discriminate. }
  unfold check_in_space.
  destruct (body c) as [w|parts|nodes|resisted segments nodes| |claims];
    destruct (is_margin q); try exact I;
    (destruct (setting_in_space (bits c) q) as [s|] eqn:S; [|exact I]).
  { (* a witness *)
    destruct (SpaceWitness.is_one_grasp (SpaceTree.rows s) (SpaceTree.the_load s)) eqn:X; [|exact I].
    destruct (SpaceWitness.witness_fails _ _ _ w) eqn:Wf; [exact I|].
    split; [apply NP|]. intros g (_ & F & W & U & N). unfold setting_in_space in S.
    destruct (enlarge_all_in_space (bits c) (contacts q)) as [rws|] eqn:A; [|discriminate].
    injection S as <-. cbn [SpaceTree.rows SpaceTree.the_load] in *.
    apply (SpaceWitness.witness_stable (bilateral q) rws (make_load (wrench q) (direction q)) w g);
      try assumption.
    eapply enlarge_all_fits_in_space; eassumption. }
  (* a tree *)
  destruct (SpaceTree.walk_ranges _ _ _ _ s [at_zero] nodes) as [[rule number]|] eqn:R; [exact I|].
  split; [apply NP|]. intros g (_ & F & W & U & N) (d & forces & E).
  unfold setting_in_space in S.
  destruct (enlarge_all_in_space (bits c) (contacts q)) as [rws|] eqn:A; [|discriminate].
  injection S as <-.
  refine (SpaceTree.refuted_multiple memory advisor _ _ _ [at_zero] nodes g 0 d forces _ R _ _ _).
  - reflexivity.
  - constructor; cbn; try assumption; [|reflexivity|lra].
    eapply enlarge_all_fits_in_space; eassumption.
  - exact N.
  - constructor. unfold in_range, at_zero; cbn. rewrite Q2R_0.
    repeat split; try discriminate; lra.
Qed.

(* Whatever the certificate and the oracle's advice are, the answer is true. *)
Theorem check_correct q c : true_answer q (check memory advisor q c).
Proof.
  unfold check. destruct (Nat.eqb_spec (dimension q) 3) as [D|_]; [now apply plane_correct|].
  destruct (Nat.eqb_spec (dimension q) 6) as [D|_]; [now apply space_correct|exact I].
Qed.

End Correct.
