(* SPDX-License-Identifier: MIT *)
(* What the rules of statics prove (Statics.v), said of all that a question is about (Meaning.v): `statics_true`. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Meaning Numbers Root Box RowsOfModels Matrix Bodies StaticsModel StaticsRules StaticsCones
  Statics.
From Proved Require Rows Model SpaceModel BodiesModel.
Import ListNotations.
Open Scope R_scope.

(* ---- Multiples ---- *)

(* What is true of points, and with two of them of all their sums with multiples >= 0. *)
Section Multiples.
Variable P : R -> R -> Prop.
Hypothesis P_mixed : forall h l h' l' a b, 0 <= a -> 0 <= b -> P h l -> P h' l' -> P (a * h + b * h') (a * l + b * l').

Lemma mixed_to h l h' l' a b H L : 0 <= a -> 0 <= b -> P h l -> P h' l' -> a * h + b * h' = H -> a * l + b * l' = L -> P H L.
Proof. intros A B P1 P2 <- <-. now apply P_mixed. Qed.

Definition point_holds (x : list Q) : Prop := 0 <= Q2R (at_q x 0) /\ P (Q2R (at_q x 0)) (Q2R (at_q x 1)).

Record hull_holds (it : hull) : Prop := {
  ends_hold : forall a b, some it = Some (a, b) -> P 1 (Q2R a) /\ P 1 (Q2R b);
  down_holds : goes_down it = true -> exists r, 0 < r /\ P 0 (- r);
  up_holds : goes_up it = true -> exists r, 0 < r /\ P 0 r
}.

Lemma positive_of q : Qle_bool q 0 = false -> 0 < Q2R q.
Proof. intros H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence. Qed.

Lemma more_holds it x : hull_holds it -> point_holds x -> hull_holds (more_of_hull it x).
Proof.
  intros [E D U] [H0 H]. destruct x as [|h [|l [|? ?]]]; try (constructor; assumption). cbn [at_q nth] in *.
  cbn [more_of_hull]. destruct (is_zero h) eqn:Z.
  - apply zero_real in Z. rewrite Z in H. constructor; cbn [some goes_down goes_up]; [exact E| |]; intros G;
      apply orb_true_iff in G as [G|G]; [now apply D| |now apply U|]; apply negb_true_iff in G.
    + exists (- Q2R l). apply not_nonneg_real in G. split; [lra|]. now rewrite Ropp_involutive.
    + exists (Q2R l). apply positive_of in G. now split.
  - apply not_zero_real in Z. constructor; cbn [some goes_down goes_up]; [|exact D|exact U].
    assert (Here : P 1 (Q2R (reduced (l / h)))).
    { rewrite reduced_same, Q2R_div by (intros Q; apply Z; apply Qeq_eqR in Q; now rewrite Q2R_0 in Q).
      apply (mixed_to (Q2R h) (Q2R l) (Q2R h) (Q2R l) (/ Q2R h) 0); try assumption; try (field; exact Z); [|lra].
      left. apply Rinv_0_lt_compat. lra. }
    intros a b. destruct (some it) as [[a' b']|]; intros [= <- <-]; [|now split].
    destruct (E a' b' eq_refl) as [Ea Eb]. split; [destruct (Qle_bool a' _)|destruct (Qle_bool _ b')]; assumption.
Qed.

Lemma multiples_hold points ends : Forall point_holds points -> multiples_of points = Some ends ->
  forall l, between l ends -> P 1 l.
Proof.
  intros F. unfold multiples_of.
  assert (G : hull_holds (fold_left more_of_hull points (Hull None false false))).
  { assert (G : forall it, hull_holds it -> hull_holds (fold_left more_of_hull points it)).
    { induction F as [|x xs X F IH]; intros it I; cbn; [exact I|]. apply IH. now apply more_holds. }
    apply G. constructor; cbn; discriminate. }
  destruct (fold_left _ _ _) as [[[a b]|] down up]; destruct G as [E D U]; cbn [some goes_down goes_up] in *; [|discriminate].
  intros [= <-] l [A B]. cbn [fst snd] in A, B. destruct (E a b eq_refl) as [Ea Eb].
  destruct (Rlt_dec l (Q2R a)) as [La|La].
  - destruct down; [|lra]. destruct (D eq_refl) as (r & R0 & Pr).
    apply (mixed_to 1 (Q2R a) 0 (- r) 1 ((Q2R a - l) / r)); try assumption; try (field; lra); [lra|]. apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
  - destruct (Rlt_dec (Q2R b) l) as [Lb|Lb].
    + destruct up; [|lra]. destruct (U eq_refl) as (r & R0 & Pr).
      apply (mixed_to 1 (Q2R b) 0 r 1 ((l - Q2R b) / r)); try assumption; try (field; lra); [lra|]. apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
    + destruct (Req_dec (Q2R a) (Q2R b)) as [S|S].
      * now replace l with (Q2R a) by lra.
      * set (t := (l - Q2R a) / (Q2R b - Q2R a)).
        assert (T : 0 <= t <= 1).
        { unfold t. split; [apply Rmult_le_pos; [lra|left; apply Rinv_0_lt_compat; lra]|].
          apply Rmult_le_reg_r with (Q2R b - Q2R a); [lra|]. field_simplify; lra. }
        apply (mixed_to 1 (Q2R a) 1 (Q2R b) (1 - t) t); try assumption; try lra. unfold t. field. lra.
Qed.

End Multiples.

Section Moves.
Variable M : R -> Prop.

Definition form_holds (f : list Q) : Prop := forall l, 0 < Q2R (at_q f 0) + l * Q2R (at_q f 1) -> M l.

Lemma moves_hold forms : Forall form_holds forms -> forall l, beyond l (moves_of forms) -> M l.
Proof.
  intros F. unfold moves_of.
  assert (G : forall it, (forall l, beyond l it -> M l) -> forall l, beyond l (fold_left more_of_moves forms it) -> M l).
  { induction F as [|f fs H F IH]; intros it I; cbn [fold_left]; [exact I|]. apply IH. clear IH F fs.
    destruct it as [[below above] all]. destruct f as [|w [|g [|? ?]]]; try exact I. unfold form_holds in H. cbn [at_q nth] in H.
    cbn [more_of_moves]. unfold beyond in *. destruct (is_zero g) eqn:Z.
    - apply zero_real in Z. intros l [B|[A|W]]; [apply I; tauto|apply I; tauto|]. apply orb_true_iff in W as [W|W]; [apply I; tauto|].
      apply negb_true_iff in W. apply positive_of in W. apply H. rewrite Z. lra.
    - apply not_zero_real in Z.
      assert (E : Q2R (reduced (- w / g)) = - Q2R w / Q2R g).
      { rewrite reduced_same, Q2R_div, Q2R_opp by (intros Q; apply Z; apply Qeq_eqR in Q; now rewrite Q2R_0 in Q). reflexivity. }
      destruct (Qle_bool 0 g) eqn:G.
      + assert (Up : forall l, Q2R (reduced (- w / g)) < l -> M l).
        { intros l L. apply H. apply nonneg_real in G. rewrite E in L. assert (Gp : 0 < Q2R g) by lra.
          apply (Rmult_lt_compat_r (Q2R g)) in L; [|exact Gp]. replace (- Q2R w / Q2R g * Q2R g) with (- Q2R w) in L by (field; lra). lra. }
        intros l [B|[A|W]]; [apply I; tauto| |apply I; tauto]. destruct above as [a|]; [|now apply Up].
        destruct (Qle_bool a _); [apply I; tauto|now apply Up].
      + assert (Down : forall l, l < Q2R (reduced (- w / g)) -> M l).
        { intros l L. apply H. apply not_nonneg_real in G. rewrite E in L.
          apply (Rmult_lt_compat_l (- Q2R g)) in L; [|lra]. replace (- Q2R g * (- Q2R w / Q2R g)) with (Q2R w) in L by (field; lra). lra. }
        intros l [B|[A|W]]; [|apply I; tauto|apply I; tauto]. destruct below as [b|]; [|now apply Down].
        destruct (Qle_bool _ b); [apply I; tauto|now apply Down]. }
  apply G. intros l [[]|[[]|?]]; discriminate.
Qed.

End Moves.

(* ---- Questions ---- *)

Lemma held_of_is alone factor c h : held_of alone factor c = Some h ->
  h = Held (map low (position c)) (normal c) (factor * low (friction c)) (if alone then 0 else torsion c)%Q
        (if alone then Some O else of_body c) (if alone then None else by_body c) /\
  (forallb certain (position c) = true /\ certain (friction c) = true /\ Q2R (slope c) = 0) /\
  0 <= Q2R factor /\ 0 <= Q2R (low (friction c)) /\ forallb is_zero (normal c) = false.
Proof.
  unfold held_of. destruct (_ && _) eqn:C; [|discriminate]. intros [= <-]. rewrite !andb_true_iff in C.
  destruct C as [[[[[C1 C2] C3] C4] C5] C6]. apply zero_real in C3. apply nonneg_real in C4, C5. apply negb_true_iff in C6.
  repeat split; assumption.
Qed.

Lemma plane_held alone factor c h c' : held_of alone factor c = Some h -> chosen_contact c c' -> is_held (Q2R factor) h c'.
Proof.
  intros H ((x & y & nx & ny & e & EP & Wx & Wy & EN & Se & Nx & Ny) & Wf & _).
  apply held_of_is in H as (-> & (C1 & C2 & C3) & F0 & M0 & _). rewrite EP in C1. cbn in C1. rewrite !andb_true_iff in C1.
  destruct C1 as (C1x & C1y & _). assert (e0 : e = 0) by lra. rewrite e0 in *.
  constructor; cbn [h_point h_normal h_friction].
  - exists (low x), (low y). rewrite EP. split; [reflexivity|]. split; now apply certain_within.
  - exists nx, ny. split; [exact EN|]. rewrite Nx, Ny. split; ring.
  - rewrite Q2R_mult, (certain_within _ _ C2 Wf). split; [now apply Rmult_le_pos|reflexivity].
Qed.

Lemma space_held alone factor c h t : held_of alone factor c = Some h -> chosen_contact_in_space c (BodiesModel.hard t) ->
  BodiesModel.torsion t = (if alone then 0 else Q2R (torsion c)) -> is_held_finger (Q2R factor) h t.
Proof.
  intros H ((x & y & z & nx & ny & nz & u & EP & EN & Wx & Wy & Wz & Flat & Small & Nt) & Wf & _) Et.
  apply held_of_is in H as (-> & (C1 & C2 & C3) & F0 & M0 & NZ). rewrite EP in C1. cbn in C1. rewrite !andb_true_iff in C1.
  destruct C1 as (C1x & C1y & C1z & _). rewrite C3 in Small.
  assert (u0 : u = SpaceModel.zero) by (apply no_length, Rle_antisym; [lra|apply Turned.dot_nonneg]).
  assert (En : SpaceModel.normal (BodiesModel.hard t) = SpaceModel.Vector (Q2R nx) (Q2R ny) (Q2R nz))
    by (rewrite Nt, u0; unfold vector_of_three, SpaceModel.add, SpaceModel.zero; cbn; f_equal; ring).
  constructor; cbn [h_point h_normal h_friction h_torsion].
  - exists (low x), (low y), (low z). rewrite EP. split; [reflexivity|].
    destruct (SpaceModel.position (BodiesModel.hard t)) as [p q r]. cbn in Wx, Wy, Wz. f_equal; now apply certain_within.
  - exists nx, ny, nz. split; [exact EN|exact En].
  - rewrite En. pose proof (Turned.dot_nonneg (SpaceModel.Vector (Q2R nx) (Q2R ny) (Q2R nz))) as D.
    destruct (Rle_lt_or_eq_dec _ _ D) as [L|E]; [exact L|]. exfalso. symmetry in E. apply no_length in E. injection E as X Y Z.
    rewrite EN in NZ. cbn in NZ. unfold is_zero in NZ.
    assert (T : forall q, Q2R q = 0 -> Qeq_bool q 0 = true).
    { intros q E. apply Qeq_eq_bool. apply eqR_Qeq. now rewrite Q2R_0. }
    rewrite !T in NZ by assumption. discriminate.
  - rewrite Q2R_mult, (certain_within _ _ C2 Wf). split; [now apply Rmult_le_pos|reflexivity].
  - rewrite Et. destruct alone; [symmetry; apply Q2R_0|reflexivity].
Qed.

(* What an answer claims of loads that may stand, and the load w. *)
Definition claims (q : question) (a : answer) (may_stand : list R -> Prop) (w : list R) : Prop :=
  match a with
  | MayStand => may_stand w
  | CannotStand => ~ may_stand w
  | StandsAmong multiples moves => forall l, let load := Rows.plus w (Rows.scaled l (real (direction q))) in
      (forall ends, multiples = Some ends -> between l ends -> may_stand load) /\ (beyond l moves -> ~ may_stand load)
  | StandsWithin points forms => forall u v, load_plane q = Some (u, v) -> forall s t,
      let load := Rows.plus w (Rows.plus (Rows.scaled s (real u)) (Rows.scaled t (real v))) in
      (in_piece s t points -> may_stand load) /\ (Exists (above_0 s t) forms -> ~ may_stand load)
  | _ => True
  end.

Lemma claims_same q a may may' w : (forall load, may load <-> may' load) -> claims q a may w -> claims q a may' w.
Proof.
  intros E. destruct a; cbn; try tauto.
  - apply E.
  - now rewrite E.
  - intros H l. destruct (H l) as [A B]. split; [intros ends En Be; apply E; now apply (A ends)|]. rewrite <- E. exact B.
  - intros H u v Pl s t. destruct (H u v Pl s t) as [A B]. split; [intros I; now apply E, A|]. rewrite <- E. exact B.
Qed.

(* What Statics.v says of forces that balance loads. *)
Record good_forces (s : standing) (B : R -> (list R -> R) -> Prop) : Prop := {
  forces_same : forall h load h' load', B h load -> h = h' -> (forall y, load y = load' y) -> B h' load';
  forces_mixed : forall h load h' load' a b, 0 <= a -> 0 <= b -> B h load -> B h' load' ->
    B (a * h + b * h') (fun y => a * load y + b * load' y);
  forces_point : forall x them load, point_fails s x them = None ->
    (forall y, real (load_of_point x (s_loads s)) .* y = load y + Q2R (at_q x 0) * loose_work s y) -> B (Q2R (at_q x 0)) load;
  forces_none : forall y load, unopposed s y = true -> B 1 load -> load (real y) + loose_work s (real y) <= 0
}.

Section Answer.
Variable q : question.
Variable factor : Q.
Variable s : standing.
Hypothesis s_is : standing_of q factor = Some s.
Hypothesis factor_is : statics q = Some factor.
Variable B : R -> (list R -> R) -> Prop.
Hypothesis good : good_forces s B.
Variable w : list R.
Hypothesis load_is : forall y, real (hd [] (s_loads s)) .* y = w .* y + loose_work s y.

Notation may := (fun load => B 1 (fun y => load .* y)).

Lemma loads_are : exists w', s_loads s = w' :: match load_plane q with
  | Some (u, v) => [u; v]
  | None => if is_margin q then [direction q] else []
  end.
Proof.
  revert s_is. unfold standing_of. destruct (all_some _ _); [|discriminate]. destruct (load_ball q); [discriminate|].
  destruct (_ && _); [|discriminate]. intros [= <-]. cbn [s_loads]. eexists. reflexivity.
Qed.

Lemma stands_are stand number : stands_fail s stand number = None -> Forall (fun p => point_fails s (fst p) (snd p) = None) stand.
Proof.
  revert number. induction stand as [|[x them] stand IH]; intros number H; cbn in H; constructor.
  - cbn. destruct (point_fails s x them); [discriminate|reflexivity].
  - destruct (point_fails s x them); [discriminate|]. now apply IH with (S number).
Qed.

Lemma moves_are move number : moves_fail s move number = None -> Forall (fun y => unopposed s y = true) move.
Proof.
  revert number. induction move as [|y move IH]; intros number H; cbn in H; constructor.
  - destruct (unopposed s y); [reflexivity|discriminate].
  - destruct (unopposed s y); [|discriminate]. now apply IH with (S number).
Qed.

Lemma point_starts x them : point_fails s x them = None -> 0 <= Q2R (at_q x 0).
Proof. unfold point_fails. destruct (Qle_bool 0 _) eqn:H; [|discriminate]. intros _. now apply nonneg_real. Qed.

Lemma answer_holds p : claims q (check_statics q p) may w.
Proof.
  unfold check_statics. rewrite factor_is, s_is. destruct loads_are as (w' & Lo). rewrite Lo in load_is. cbn [hd] in load_is.
  destruct p as [them|y|stand move].
  - destruct (point_fails s [1%Q] them) as [rule|] eqn:F; [exact I|]. cbn [claims].
    assert (H : B (Q2R (at_q [1%Q] 0)) (fun y => w .* y)).
    { apply (forces_point _ _ good _ them); [exact F|]. intros y. rewrite Lo. unfold load_of_point. cbn [combine fold_left fst snd at_q nth].
      rewrite plus_times_real, load_is, Q2R_1. cbn. ring. }
    eapply (forces_same _ _ good); [exact H|apply Q2R_1|reflexivity].
  - destruct (unopposed s y && _) eqn:C; [|exact I]. apply andb_true_iff in C as [U W]. apply negb_true_iff, positive_of in W.
    cbn [claims]. intros H. pose proof (forces_none _ _ good _ _ U H) as N. unfold form_of in W. rewrite map_all_is, Lo in W.
    cbn [map at_q nth] in W. rewrite inner_real, dot_sym, load_is in W. lra.
  - destruct (stands_fail s stand 0) as [[? ?]|] eqn:Sf; [exact I|]. destruct (moves_fail s move 0) eqn:Mf; [exact I|].
    apply stands_are in Sf. apply moves_are in Mf. rewrite !map_all_is. rewrite Lo. clear s_is.
    destruct (load_plane q) as [[u v]|] eqn:Pl; [|destruct (is_margin q); [|exact I]].
    + cbn [claims]. intros u' v' Pl' a b. rewrite Pl in Pl'. injection Pl' as <- <-.
      set (load := Rows.plus w (Rows.plus (Rows.scaled a (real u)) (Rows.scaled b (real v)))).
      assert (Ld : forall y, load .* y = w .* y + a * (real u .* y) + b * (real v .* y))
        by (intros y; unfold load; rewrite !Rows.dot_plus, !Rows.dot_scaled; ring).
      split.
      * assert (G : forall h e f, sum_of (map triple (map fst stand)) h e f ->
          (h = 0 /\ e = 0 /\ f = 0) \/ B h (fun y => h * (w .* y) + e * (real u .* y) + f * (real v .* y))).
        { intros h e f S. induction S as [|c x1 x2 x3 h e f C In_ S IH]; [now left|]. right.
          apply in_map_iff in In_ as (x & Ex & In_). apply in_map_iff in In_ as ([x' them] & Ex' & In_). cbn in Ex'. subst x'.
          rewrite Forall_forall in Sf. specialize (Sf _ In_). cbn [fst snd] in Sf. unfold triple in Ex. injection Ex as <- <- <-.
          assert (H : B (Q2R (at_q x 0)) (fun y => Q2R (at_q x 0) * (w .* y) + Q2R (at_q x 1) * (real u .* y) + Q2R (at_q x 2) * (real v .* y))).
          { apply (forces_point _ _ good _ them); [exact Sf|]. intros y. rewrite Lo. unfold load_of_point.
            destruct x as [|x1 [|x2 [|x3 [|x4 x]]]]; cbn [combine fold_left fst snd at_q nth]; rewrite ?plus_times_real, ?load_is, ?Q2R_0; cbn [map Rows.dot]; ring. }
          destruct IH as [(-> & -> & ->)|IH].
          - eapply (forces_same _ _ good); [exact (forces_mixed _ _ good _ _ _ _ c 0 C (Rle_refl 0) H H)|ring|]. intros y. cbv beta. ring.
          - eapply (forces_same _ _ good); [exact (forces_mixed _ _ good _ _ _ _ c 1 C Rle_0_1 H IH)|ring|]. intros y. cbv beta. ring. }
        intros S. destruct (G 1 a b S) as [(Z & _)|H]; [lra|]. eapply (forces_same _ _ good); [exact H|reflexivity|].
        intros y. cbv beta. rewrite Ld. ring.
      * intros Ex H. apply Exists_exists in Ex as (f & In_ & Ab). apply in_map_iff in In_ as (f' & <- & In_).
        apply in_map_iff in In_ as (y & <- & In_). rewrite Forall_forall in Mf. specialize (Mf _ In_).
        pose proof (forces_none _ _ good _ _ Mf H) as N. cbv beta in N. rewrite Ld in N.
        unfold form_of, triple in Ab. rewrite map_all_is, Lo in Ab. cbn [map at_q nth above_0] in Ab.
        rewrite !inner_real, !(dot_sym (real y)), load_is in Ab. lra.
    + cbn [claims]. intros l.
      set (load := Rows.plus w (Rows.scaled l (real (direction q)))).
      assert (Ld : forall y, load .* y = w .* y + l * (real (direction q) .* y))
        by (intros y; unfold load; rewrite Rows.dot_plus, Rows.dot_scaled; reflexivity).
      split.
      * intros ends En Be.
        assert (H : B 1 (fun y => 1 * (w .* y) + l * (real (direction q) .* y))).
        { apply (multiples_hold (fun h l => B h (fun y => h * (w .* y) + l * (real (direction q) .* y)))) with (map fst stand) ends;
            try assumption.
          - intros h1 l1 h2 l2 a b A0 B0 H1 H2. eapply (forces_same _ _ good); [exact (forces_mixed _ _ good _ _ _ _ a b A0 B0 H1 H2)|reflexivity|].
            intros y. cbv beta. ring.
          - apply Forall_map. eapply Forall_impl; [|exact Sf]. intros [x them] F. cbn [fst snd] in *.
            split; [now apply point_starts with them|]. apply (forces_point _ _ good _ them); [exact F|]. intros y. rewrite Lo. unfold load_of_point.
            destruct x as [|x1 [|x2 [|x3 x]]]; cbn [combine fold_left fst snd at_q nth]; rewrite ?plus_times_real, ?load_is, ?Q2R_0; cbn [map Rows.dot]; ring. }
        eapply (forces_same _ _ good); [exact H|reflexivity|]. intros y. cbv beta. rewrite Ld. ring.
      * apply (moves_hold (fun l => ~ B 1 (fun y => Rows.plus w (Rows.scaled l (real (direction q))) .* y))).
        apply Forall_map. eapply Forall_impl; [|exact Mf]. intros y U l' Ab H.
        pose proof (forces_none _ _ good _ _ U H) as N. cbv beta in N. rewrite Rows.dot_plus, Rows.dot_scaled in N.
        unfold form_of in Ab. rewrite map_all_is, Lo in Ab. cbn [map at_q nth] in Ab.
        rewrite !inner_real, !(dot_sym (real y)), load_is in Ab. lra.
Qed.

End Answer.

(* ---- Of what the question is about ---- *)

Lemma certain_numbers is xs : forallb certain is = true -> Forall2 within is xs -> real (map low is) = xs.
Proof.
  intros C F. revert C. induction F as [|i x is xs W F IH]; intros C; [reflexivity|]. cbn in C. apply andb_true_iff in C as [C1 C2].
  cbn. rewrite IH by exact C2. f_equal. symmetry. now apply certain_within.
Qed.

(* What is known of a standing. *)
Lemma standing_is q factor s : standing_of q factor = Some s ->
  let alone := match several q with Some _ => false | None => true end in
  let its := match several q with Some its => its | None => Mechanism (Nat.eqb (dimension q) 6) [Free 0] [] end in
  Forall2 (fun c h => held_of alone factor c = Some h) (contacts q) (s_contacts s) /\ load_ball q = None /\
  s_numbers s = numbers_of its /\ s_dimension s = dimension q /\ s_bodies s = bodies its /\ s_elements s = elements its /\
  forallb certain (wrench q) = true /\
  (forall y, real (hd [] (s_loads s)) .* y = real (map low (wrench q)) .* y + loose_work s y) /\
  Forall (fun e => certain (element_stiffness e) = true /\ certain (element_preload e) = true) (elements its).
Proof.
  intros H alone its. unfold standing_of in H. fold alone its in H. destruct (all_some _ _) as [cs|] eqn:A; [|discriminate].
  destruct (load_ball q); [discriminate|]. destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <-.
  apply andb_true_iff in C as [C1 C2]. cbn [s_contacts s_numbers s_dimension s_bodies s_elements s_loads hd].
  split; [now apply all_some_is|]. repeat (split; [reflexivity || exact C1|]). split.
  - intros y. unfold loose_work. cbn [s_elements]. generalize (map low (wrench q)). clear. induction (elements its) as [|e es IH];
      intros l; cbn [fold_left fold_right]; [ring|]. rewrite IH. destruct (is_loose e); [rewrite plus_times_real|]; ring.
  - apply Forall_forall. intros e In_. rewrite forallb_forall in C2. specialize (C2 e In_). now apply andb_true_iff in C2.
Qed.

Lemma elements_as es es' : Forall (fun e => certain (element_stiffness e) = true /\ certain (element_preload e) = true) es ->
  Forall2 chosen_element es es' -> Forall2 element_is es es'.
Proof.
  intros C F. induction F as [|e e' es es' (Lv & Sp & Wk & Wp & _) F IH]; constructor.
  - destruct (Forall_inv C) as [C1 C2]. split; [exact Lv|]. split; [exact Sp|]. split; [|intros _]; now apply certain_within.
  - apply IH. exact (Forall_inv_tail C).
Qed.

Section Several.
Variable k : BodiesModel.kind.
Variable in_cone : BodiesModel.contact k -> BodiesModel.force k -> Prop.
Variable held_is : held -> BodiesModel.contact k -> Prop.
Variable to_force : Q * list Q -> BodiesModel.force k.
Hypothesis wrench_works : forall h c f d, held_is h c -> BodiesModel.works k c (to_force f) d = real (wrench_of h f) .* d.
Hypothesis lawful_is : forall h c f, held_is h c -> is_lawful h f = true -> in_cone c (to_force f).
Hypothesis idle : forall c, in_cone c (to_force (0%Q, [])) /\ forall d, BodiesModel.works k c (to_force (0%Q, [])) d = 0.
Hypothesis unopposed_works : forall h c d f, held_is h c -> unopposed_by h d = true -> in_cone c f ->
  0 <= BodiesModel.works k c f (real d).
Hypothesis mixed : forall c f f' s t, 0 <= s -> 0 <= t -> in_cone c f -> in_cone c f' ->
  exists g, in_cone c g /\ forall d, BodiesModel.works k c g d = s * BodiesModel.works k c f d + t * BodiesModel.works k c f' d.

Theorem several_true q factor s p (m : BodiesModel.mechanism k) : statics q = Some factor -> standing_of q factor = Some s ->
  Forall2 (touch_is k held_is) (s_contacts s) (BodiesModel.touches m) ->
  Forall2 element_is (s_elements s) (BodiesModel.elements m) ->
  BodiesModel.bodies m = map real_body (s_bodies s) -> BodiesModel.numbers k = s_numbers s ->
  BodiesModel.coordinates m = s_dimension s -> Forall2 within (wrench q) (BodiesModel.wrench m) ->
  claims q (check_statics q p) (may_stand in_cone m) (BodiesModel.wrench m).
Proof.
  intros Fq Sq Ct El Bo Nu Di W. pose proof (standing_is q factor s Sq) as (_ & _ & _ & _ & _ & _ & Cw & Ld & _).
  rewrite (certain_numbers _ _ Cw W) in Ld.
  apply claims_same with (fun load => bears k in_cone m 1 (fun y => load .* y)); [intros load; apply bears_stands|].
  apply (answer_holds q factor s Sq Fq); [|exact Ld]. constructor.
  - intros. eapply bears_same; eassumption.
  - intros. now apply bears_mixed.
  - intros x them load F E. now apply (point_bears k in_cone held_is to_force) with s them.
  - intros y load U H. now apply (none_bears k in_cone held_is) with m.
Qed.

End Several.

(* One body as several. *)
Definition alone_in_plane (g : Model.grasp) : BodiesModel.mechanism BodiesModel.in_plane :=
  BodiesModel.Mechanism BodiesModel.in_plane 3 [BodiesModel.Free 0]
    (map (fun c => BodiesModel.Touch BodiesModel.in_plane c (Some O) None) (Model.contacts g)) []
    (three_numbers (Model.wrench g)) [] (Model.normal g).

Definition alone_in_space (g : SpaceModel.grasp) : BodiesModel.mechanism BodiesModel.in_space :=
  BodiesModel.Mechanism BodiesModel.in_space 6 [BodiesModel.Free 0]
    (map (fun c => BodiesModel.Touch BodiesModel.in_space (BodiesModel.Finger c 0) (Some O) None) (SpaceModel.contacts g)) []
    (six_numbers (SpaceModel.wrench g)) [] (SpaceModel.normal_law g).

Lemma work_of_two a b d : Model.work (Model.add a b) d = Model.work a d + Model.work b d.
Proof. unfold Model.work, Model.add; cbn. ring. Qed.

Lemma work_of_two_screws a b d : SpaceModel.work (SpaceModel.add_screw a b) d = SpaceModel.work a d + SpaceModel.work b d.
Proof. unfold SpaceModel.work, SpaceModel.add_screw, SpaceModel.add, SpaceModel.dot; cbn. ring. Qed.

Lemma alone_moves_in_plane g y c : List.length y = 3%nat ->
  BodiesModel.relative (alone_in_plane g) y (BodiesModel.Touch BodiesModel.in_plane c (Some O) None) = y.
Proof. destruct y as [|a [|b [|e [|? ?]]]]; try discriminate. reflexivity. Qed.

Lemma alone_moves_in_space g y c : List.length y = 6%nat ->
  BodiesModel.relative (alone_in_space g) y (BodiesModel.Touch BodiesModel.in_space c (Some O) None) = y.
Proof. destruct y as [|a [|b [|e [|a' [|b' [|e' [|? ?]]]]]]]; try discriminate. reflexivity. Qed.

Lemma alone_in_plane_stands phi g w : may_stand (k := BodiesModel.in_plane) (in_cone phi) (alone_in_plane g) w <->
  may_stand_in_plane phi g (motion_of w).
Proof.
  assert (W : forall y, List.length y = 3%nat -> w .* y = Model.work (motion_of w) (motion_of y)).
  { intros y L. destruct y as [|a [|b [|e [|? ?]]]]; try discriminate. unfold Model.work, motion_of, BodiesModel.at_.
    destruct w as [|x1 [|x2 [|x3 w]]]; cbn; try ring. destruct w; cbn; ring. }
  assert (S : forall y cs forces, List.length y = 3%nat -> BodiesModel.sum (map (fun tf => BodiesModel.works BodiesModel.in_plane
      (BodiesModel.touching (fst tf)) (snd tf) (BodiesModel.relative (alone_in_plane g) y (fst tf)))
      (combine (map (fun c => BodiesModel.Touch BodiesModel.in_plane c (Some O) None) cs) forces)) =
    Model.work (Model.sum (Model.contact_wrenches cs forces)) (motion_of y)).
  { intros y cs forces L. revert forces. induction cs as [|c cs IH]; intros [|f forces]; try (unfold Model.work; cbn; ring).
    cbn [map combine]. unfold BodiesModel.sum in *. cbn [fold_right fst snd]. rewrite IH, alone_moves_in_plane by exact L.
    change (Model.sum (Model.contact_wrenches (c :: cs) (f :: forces))) with
      (Model.add (Model.contact_wrench c f) (Model.sum (Model.contact_wrenches cs forces))).
    rewrite work_of_two. reflexivity. }
  split.
  - intros (forces & pulls & F & P & Bal). exists forces. cbn [BodiesModel.touches BodiesModel.elements alone_in_plane] in *.
    split.
    + clear - F. remember (Model.contacts g) as cs eqn:E. clear E. revert forces F. induction cs as [|c cs IH]; intros forces F;
        inversion F; subst; constructor; [assumption|now apply IH].
    + assert (E : forall y, List.length y = 3%nat ->
        Model.work (Model.add (motion_of w) (Model.sum (Model.contact_wrenches (Model.contacts g) forces))) (motion_of y) = 0).
      { intros y L. specialize (Bal y L). rewrite S in Bal by exact L. rewrite W in Bal by exact L. inversion P; subst pulls. cbn [combine map BodiesModel.sum fold_right] in Bal.
        rewrite work_of_two. lra. }
      pose proof (E [1; 0; 0] eq_refl) as X. pose proof (E [0; 1; 0] eq_refl) as Y. pose proof (E [0; 0; 1] eq_refl) as Z.
      destruct (Model.add _ _) as [a b e]. unfold Model.work, motion_of, BodiesModel.at_ in X, Y, Z; cbn in X, Y, Z.
      unfold Model.zero. f_equal; lra.
  - intros (forces & F & Bal). exists forces, []. cbn [BodiesModel.touches BodiesModel.elements alone_in_plane]. split; [|split].
    + clear - F. induction F; cbn; constructor; assumption.
    + constructor.
    + intros y L. rewrite S, W by exact L.
      assert (E : Model.work (Model.add (motion_of w) (Model.sum (Model.contact_wrenches (Model.contacts g) forces))) (motion_of y) = 0)
        by (rewrite Bal; unfold Model.work, Model.zero; cbn; ring).
      rewrite work_of_two in E. cbn [combine map BodiesModel.sum fold_right]. lra.
Qed.

Lemma alone_in_space_stands phi g w : may_stand (k := BodiesModel.in_space) (in_cone_of_finger phi) (alone_in_space g) w <->
  may_stand_in_space phi g (screw_of w).
Proof.
  assert (W : forall y, List.length y = 6%nat -> w .* y = SpaceModel.work (screw_of w) (screw_of y)).
  { intros y L. destruct y as [|a [|b [|e [|a' [|b' [|e' [|? ?]]]]]]]; try discriminate.
    unfold SpaceModel.work, SpaceModel.dot, screw_of, BodiesModel.at_.
    destruct w as [|x1 [|x2 [|x3 [|x4 [|x5 [|x6 w]]]]]]; cbn; try ring. destruct w; cbn; ring. }
  assert (G0 : forall c, BodiesModel.gamma (BodiesModel.Finger c 0) = 0) by (intros c; now apply Fingers.hard_gamma).
  assert (S : forall y cs forces, List.length y = 6%nat -> Forall (fun f => snd f = 0) forces ->
    BodiesModel.sum (map (fun tf => BodiesModel.works BodiesModel.in_space
      (BodiesModel.touching (fst tf)) (snd tf) (BodiesModel.relative (alone_in_space g) y (fst tf)))
      (combine (map (fun c => BodiesModel.Touch BodiesModel.in_space (BodiesModel.Finger c 0) (Some O) None) cs) forces)) =
    SpaceModel.work (SpaceModel.sum (SpaceModel.contact_wrenches cs (map fst forces))) (screw_of y)).
  { intros y cs forces L. revert forces. induction cs as [|c cs IH]; intros [|[f m] forces] Z;
      try (unfold SpaceModel.work, SpaceModel.dot; cbn; ring).
    pose proof (Forall_inv Z) as m0. cbn [snd] in m0. rewrite m0. specialize (IH forces (Forall_inv_tail Z)).
    cbn [map combine fst snd]. unfold BodiesModel.sum in *. cbn [fold_right fst snd]. rewrite IH, alone_moves_in_space by exact L.
    change (SpaceModel.sum (SpaceModel.contact_wrenches (c :: cs) (f :: map fst forces))) with
      (SpaceModel.add_screw (SpaceModel.contact_wrench c f) (SpaceModel.sum (SpaceModel.contact_wrenches cs (map fst forces)))).
    rewrite work_of_two_screws. f_equal. cbn [BodiesModel.works BodiesModel.in_space BodiesModel.touching]. destruct f as [a f].
    unfold BodiesModel.finger_works. cbn [BodiesModel.hard]. ring. }
  split.
  - intros (forces & pulls & F & P & Bal). exists (map fst forces). cbn [BodiesModel.touches BodiesModel.elements alone_in_space] in *.
    assert (Z : Forall (fun f => snd f = 0) forces /\ Forall2 (in_cone_in_space phi) (SpaceModel.contacts g) (map fst forces)).
    { clear - F G0. remember (SpaceModel.contacts g) as cs eqn:E. clear E. revert forces F. induction cs as [|c cs IH]; intros forces F;
        inversion F as [|? [[a f] m] ? fs (C & El) F']; subst; [split; constructor|]. destruct (IH _ F') as [Z C'].
      cbn [BodiesModel.touching BodiesModel.hard] in C, El. rewrite G0 in El. split; constructor; try assumption.
      cbn [snd]. apply Rsqr_0_uniq. pose proof (Rle_0_sqr m). unfold Rsqr in *. lra. }
    destruct Z as [Z C]. split; [exact C|].
    assert (E : forall y, List.length y = 6%nat -> SpaceModel.work (SpaceModel.add_screw (screw_of w)
        (SpaceModel.sum (SpaceModel.contact_wrenches (SpaceModel.contacts g) (map fst forces)))) (screw_of y) = 0).
    { intros y L. specialize (Bal y L). rewrite S in Bal by assumption. rewrite W in Bal by exact L. inversion P; subst pulls. cbn [combine map BodiesModel.sum fold_right] in Bal.
      rewrite work_of_two_screws. lra. }
    pose proof (E [1; 0; 0; 0; 0; 0] eq_refl) as E1. pose proof (E [0; 1; 0; 0; 0; 0] eq_refl) as E2.
    pose proof (E [0; 0; 1; 0; 0; 0] eq_refl) as E3. pose proof (E [0; 0; 0; 1; 0; 0] eq_refl) as E4.
    pose proof (E [0; 0; 0; 0; 1; 0] eq_refl) as E5. pose proof (E [0; 0; 0; 0; 0; 1] eq_refl) as E6.
    destruct (SpaceModel.add_screw _ _) as [[a b e] [a' b' e']].
    unfold SpaceModel.work, SpaceModel.dot, screw_of, BodiesModel.at_ in E1, E2, E3, E4, E5, E6; cbn in E1, E2, E3, E4, E5, E6.
    unfold SpaceModel.no_screw, SpaceModel.zero. f_equal; f_equal; lra.
  - intros (forces & F & Bal). exists (map (fun f => (f, 0)) forces), [].
    cbn [BodiesModel.touches BodiesModel.elements alone_in_space]. split; [|split].
    + clear - F G0. induction F as [|c [a f] cs fs C F IH]; cbn; constructor; [|exact IH]. split; [exact C|].
      cbn [BodiesModel.touching BodiesModel.hard]. rewrite G0. lra.
    + constructor.
    + intros y L. rewrite S by (try exact L; apply Forall_map, Forall_forall; reflexivity). rewrite map_map, map_id, W by exact L.
      assert (E : SpaceModel.work (SpaceModel.add_screw (screw_of w) (SpaceModel.sum (SpaceModel.contact_wrenches (SpaceModel.contacts g) forces)))
        (screw_of y) = 0) by (rewrite Bal; unfold SpaceModel.work, SpaceModel.dot, SpaceModel.no_screw, SpaceModel.zero; cbn; ring).
      rewrite work_of_two_screws in E. cbn [combine map BodiesModel.sum fold_right]. lra.
Qed.

Lemma idle_in_plane phi c : in_cone phi c (plane_force (0%Q, [])) /\
  forall d, BodiesModel.works BodiesModel.in_plane c (plane_force (0%Q, [])) d = 0.
Proof.
  unfold plane_force, in_cone. cbn [fst snd at_q nth]. rewrite Q2R_0, Rabs_R0. split; [lra|]. intros d. cbn [BodiesModel.works BodiesModel.in_plane].
  unfold Model.work, Model.contact_wrench, Model.add, Model.scale; cbn. ring.
Qed.

Lemma idle_in_space phi t : in_cone_of_finger phi t (StaticsCones.space_force (0%Q, [])) /\
  forall d, BodiesModel.works BodiesModel.in_space t (StaticsCones.space_force (0%Q, [])) d = 0.
Proof.
  unfold StaticsCones.space_force, in_cone_of_finger, in_cone_in_space. cbn [fst snd at_q nth]. rewrite Q2R_0.
  set (o := SpaceModel.Vector 0 0 0).
  assert (D : forall v, SpaceModel.dot o v = 0) by (intros v; unfold SpaceModel.dot, o; cbn; ring).
  assert (N : SpaceModel.norm o = 0) by (unfold SpaceModel.norm; rewrite D; apply sqrt_0).
  rewrite N, !D. split; [repeat split; lra|].
  intros d. cbn [BodiesModel.works BodiesModel.in_space]. unfold BodiesModel.finger_works, SpaceModel.work, SpaceModel.contact_wrench,
    SpaceModel.force_at, SpaceModel.add, SpaceModel.scale, SpaceModel.dot, SpaceModel.cross, o; cbn. ring.
Qed.

Theorem statics_true q p : true_answer q (check_statics q p).
Proof.
  assert (G : of_statics q (claims q (check_statics q p))).
  { intros factor Fq phi.
    destruct (standing_of q factor) as [s|] eqn:Sq;
      [|unfold check_statics; rewrite Fq, Sq; repeat split; intros; exact I].
    pose proof (standing_is q factor s Sq) as (Ct & Lb & Nu & Di & Bo & El & _ & _ & Ce).
    assert (Several_plane : forall m : BodiesModel.mechanism BodiesModel.in_plane,
      Forall2 (touch_is BodiesModel.in_plane (is_held phi)) (s_contacts s) (BodiesModel.touches m) ->
      Forall2 element_is (s_elements s) (BodiesModel.elements m) -> BodiesModel.bodies m = map real_body (s_bodies s) ->
      BodiesModel.numbers BodiesModel.in_plane = s_numbers s -> BodiesModel.coordinates m = s_dimension s ->
      Forall2 within (wrench q) (BodiesModel.wrench m) ->
      claims q (check_statics q p) (may_stand (k := BodiesModel.in_plane) (in_cone phi) m) (BodiesModel.wrench m)).
    { intros m. apply (several_true BodiesModel.in_plane (in_cone phi) (is_held phi) plane_force) with factor; try assumption.
      - intros h c f d H. now apply (plane_wrench_works phi).
      - intros h c f. apply plane_lawful.
      - apply idle_in_plane.
      - intros h c d f. apply plane_unopposed.
      - intros c f f' a b A0 B0 H1 H2. destruct (plane_mixed phi c f f' a b A0 B0 H1 H2) as (g & Hg & W). exists g. split; [exact Hg|].
        intros d. apply W. }
    assert (Several_space : forall m : BodiesModel.mechanism BodiesModel.in_space,
      Forall2 (touch_is BodiesModel.in_space (is_held_finger phi)) (s_contacts s) (BodiesModel.touches m) ->
      Forall2 element_is (s_elements s) (BodiesModel.elements m) -> BodiesModel.bodies m = map real_body (s_bodies s) ->
      BodiesModel.numbers BodiesModel.in_space = s_numbers s -> BodiesModel.coordinates m = s_dimension s ->
      Forall2 within (wrench q) (BodiesModel.wrench m) ->
      claims q (check_statics q p) (may_stand (k := BodiesModel.in_space) (in_cone_of_finger phi) m) (BodiesModel.wrench m)).
    { intros m. apply (several_true BodiesModel.in_space (in_cone_of_finger phi) (is_held_finger phi) StaticsCones.space_force) with factor; try assumption.
      - intros h c f d H. now apply (space_wrench_works phi).
      - intros h c f. apply space_lawful.
      - apply idle_in_space.
      - intros h c d f. apply space_unopposed.
      - intros c f f' a b A0 B0 H1 H2. destruct (space_mixed phi c f f' a b A0 B0 H1 H2) as (g & Hg & W). exists g. split; [exact Hg|].
        intros d. apply W. }
    split; [|split; [|split]].
    - intros g (Sv & D & F & (w0 & w1 & W & A & Ew) & _). rewrite Sv in *. cbn [bodies elements numbers_of bodies_in_space] in *.
      rewrite D in *. cbn in Nu. rewrite Lb in A. cbn in A. subst w1.
      apply claims_same with (may_stand (k := BodiesModel.in_plane) (in_cone phi) (alone_in_plane g));
        [intros load; apply alone_in_plane_stands|].
      apply (Several_plane (alone_in_plane g)); cbn [BodiesModel.touches BodiesModel.elements BodiesModel.bodies BodiesModel.numbers
        BodiesModel.in_plane BodiesModel.coordinates BodiesModel.wrench alone_in_plane]; try congruence.
      + clear - Ct F. revert F. generalize (Model.contacts g). induction Ct as [|c h cs hs Hh Ct IH]; intros gs F;
          inversion F as [|? c' ? gs' Ch F']; subst; cbn; constructor; [|now apply IH].
        split; [|apply held_of_is in Hh as (-> & _); now split]. cbn. now apply plane_held with true c.
      + rewrite El. constructor.
      + now rewrite Bo.
      + rewrite Ew. replace (Model.add w0 Model.zero) with w0; [exact W|]. destruct w0. unfold Model.add, Model.zero; cbn. f_equal; ring.
    - intros g (Sv & D & F & (w0 & w1 & W & A & Ew) & _). rewrite Sv in *. cbn [bodies elements numbers_of bodies_in_space] in *.
      rewrite D in *. cbn in Nu. rewrite Lb in A. cbn in A. subst w1.
      apply claims_same with (may_stand (k := BodiesModel.in_space) (in_cone_of_finger phi) (alone_in_space g));
        [intros load; apply alone_in_space_stands|].
      apply (Several_space (alone_in_space g)); cbn [BodiesModel.touches BodiesModel.elements BodiesModel.bodies BodiesModel.numbers
        BodiesModel.in_space BodiesModel.coordinates BodiesModel.wrench alone_in_space]; try congruence.
      + clear - Ct F. revert F. generalize (SpaceModel.contacts g). induction Ct as [|c h cs hs Hh Ct IH]; intros gs F;
          inversion F as [|? c' ? gs' Ch F']; subst; cbn; constructor; [|now apply IH].
        split; [|apply held_of_is in Hh as (-> & _); now split]. cbn. now apply space_held with true c.
      + rewrite El. constructor.
      + now rewrite Bo.
      + rewrite Ew. replace (SpaceModel.add_screw w0 SpaceModel.no_screw) with w0; [exact W|]. destruct w0 as [[] []].
        unfold SpaceModel.add_screw, SpaceModel.add, SpaceModel.no_screw, SpaceModel.zero; cbn. f_equal; f_equal; ring.
    - intros m (its & Sp & Sv & D & _ & Eb & T & E & L & _). rewrite Sv in *. unfold numbers_of in Nu. rewrite Sp in Nu.
      unfold loaded_by_ball in L. rewrite Lb in L. apply Several_plane; [| |congruence|now rewrite Nu|congruence|exact L].
      + clear - Ct T. revert T. generalize (BodiesModel.touches m). induction Ct as [|c h cs hs Hh Ct IH]; intros ts T;
          inversion T as [|? t ? ts' (Ch & Eo & Ey) T']; subst; constructor; [|now apply IH].
        split; [now apply plane_held with false c|]. apply held_of_is in Hh as (-> & _). now split.
      + rewrite El. now apply elements_as.
    - intros m (its & Sp & Sv & D & _ & Eb & T & E & L & _). rewrite Sv in *. unfold numbers_of in Nu. rewrite Sp in Nu.
      unfold loaded_by_ball in L. rewrite Lb in L. apply Several_space; [| |congruence|now rewrite Nu|congruence|exact L].
      + clear - Ct T. revert T. generalize (BodiesModel.touches m). induction Ct as [|c h cs hs Hh Ct IH]; intros ts T;
          inversion T as [|? t ? ts' ((Ch & Et & _) & Eo & Ey) T']; subst; constructor; [|now apply IH].
        split; [now apply space_held with false c|]. apply held_of_is in Hh as (-> & _). now split.
      + rewrite El. now apply elements_as. }
  revert G. unfold of_statics. unfold claims, true_answer, of_statics.
  assert (Only : match check_statics q p with
    | MayStand | CannotStand | StandsAmong _ _ | StandsWithin _ _ | Rejected _ _ | NotProvedHere _ => True | _ => False end).
  { unfold check_statics. destruct (statics q); [|exact I]. destruct (standing_of q _) as [s|]; [|exact I].
    destruct p as [them|y|stand move].
    - destruct (point_fails _ _ _); exact I.
    - destruct (_ && _); exact I.
    - destruct (stands_fail _ _ _) as [[? ?]|]; [exact I|]. destruct (moves_fail _ _ _); [exact I|].
      destruct (s_loads s) as [|? [|? [|? [|? ?]]]]; exact I. }
  destruct (check_statics q p); try contradiction; intros G; try exact I; exact G.
Qed.
