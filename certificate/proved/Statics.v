(* SPDX-License-Identifier: MIT *)
(* Statics (FORMAT.md section 16): where the rules hold (StaticsRules.v), forces balance the load of a load point
   (`point_bears`), and none balance one that does work on a twist (`none_bears`). *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Meaning Numbers Root Box RowsOfModels Matrix Bodies StaticsModel StaticsRules StaticsCones.
From Proved Require Rows BodiesModel RigidClass.
Import ListNotations.
Open Scope R_scope.

(* ---- Wrenches on bodies ---- *)

Fixpoint pairs (ws : list (list Q)) (all : list (list R)) : R :=
  match ws, all with w :: ws', d :: all' => real w .* d + pairs ws' all' | _, _ => 0 end.

Lemma add_on_length b s w ws : List.length (add_on b s w ws) = List.length ws.
Proof. revert b. induction ws as [|v ws IH]; intros [|b]; cbn; try reflexivity. now rewrite IH. Qed.

Lemma add_on_body_length b s w ws : List.length (add_on_body b s w ws) = List.length ws.
Proof. destruct b; [apply add_on_length|reflexivity]. Qed.

Lemma pairs_add_on b s w ws all : (List.length all <= List.length ws)%nat ->
  pairs (add_on b s w ws) all = pairs ws all + Q2R s * (real w .* nth b all []).
Proof.
  revert b all. induction ws as [|v ws IH]; intros [|b] [|d all] L; cbn [add_on pairs nth]; try (cbn in L; lia);
    rewrite ?dot_nil; try ring.
  - rewrite plus_times_real. ring.
  - rewrite IH by (cbn in L; lia). ring.
Qed.

Lemma pairs_add_on_body b s w ws all : (List.length all <= List.length ws)%nat ->
  pairs (add_on_body b s w ws) all = pairs ws all + Q2R s * (real w .* BodiesModel.of_number all b).
Proof.
  intros L. destruct b as [b|]; cbn [add_on_body BodiesModel.of_number]; [now apply pairs_add_on|]. rewrite dot_nil. ring.
Qed.

Lemma pairs_app ws all d : pairs ws (all ++ [d]) = pairs ws all + real (nth (List.length all) ws []) .* d.
Proof.
  revert all. induction ws as [|w ws IH]; intros [|e all]; cbn [app pairs List.length nth]; try (cbn; ring).
  - destruct ws; cbn; ring.
  - rewrite IH. ring.
Qed.

Lemma motions_last n y bs b before : BodiesModel.motions n y (bs ++ [b]) before =
  BodiesModel.motions n y bs before ++ [BodiesModel.motion_of_body n y (BodiesModel.motions n y bs before) b].
Proof. revert before. induction bs as [|c bs IH]; intros before; cbn; [reflexivity|apply IH]. Qed.

Lemma motions_length n y bs before :
  List.length (BodiesModel.motions n y bs before) = (List.length before + List.length bs)%nat.
Proof. revert before. induction bs as [|b bs IH]; intros before; cbn; [lia|]. rewrite IH, app_length. cbn. lia. Qed.

Lemma add_from_is first w total y : real (add_from first w total) .* y = real total .* y + real w .* skipn first y.
Proof.
  revert total y. induction first as [|first IH]; intros total y.
  - destruct total as [|x total]; (cbn [add_from skipn]; rewrite plus_times_real, Q2R_1; ring).
  - destruct total as [|x total]; destruct y as [|z y]; cbn [add_from skipn map Rows.dot]; rewrite ?dot_nil; try ring;
      rewrite IH, ?Q2R_0; cbn; ring.
Qed.

Lemma pull_back_is n bs ws total y : (List.length bs <= List.length ws)%nat ->
  real (pull_back n bs ws total) .* y =
  real total .* y + pairs ws (BodiesModel.motions n y (map real_body (rev bs)) []).
Proof.
  revert ws total. induction bs as [|b bs IH]; intros ws total L.
  - cbn. destruct ws; cbn; ring.
  - cbn [rev]. rewrite map_app. cbn [map]. rewrite motions_last, pairs_app, motions_length, map_length, rev_length.
    cbn [List.length Nat.add] in *.
    set (all := BodiesModel.motions n y (map real_body (rev bs)) []) in *.
    assert (La : List.length all = List.length bs)
      by (unfold all; rewrite motions_length, map_length, rev_length; reflexivity).
    set (w := nth (List.length bs) ws []). cbn [pull_back]. fold w. destruct b as [first|on eta turns].
    + rewrite IH, add_from_is by lia. fold all. cbn [real_body BodiesModel.motion_of_body].
      rewrite <- firstn_map, dot_firstn. ring.
    + rewrite IH by (rewrite add_on_body_length; lia). fold all.
      rewrite pairs_add_on_body, plus_times_real, inner_real by lia.
      cbn [real_body BodiesModel.motion_of_body]. rewrite dot_plus_right, dot_scaled_right, Q2R_1. ring.
Qed.

(* ---- Forces of a list ---- *)

Definition is_good {A} (good : A -> Q * list Q -> bool) (p : A * option (Q * list Q)) : Prop :=
  match snd p with Some f => good (fst p) f = true | None => True end.

Lemma take_is {A} (good : A -> Q * list Q -> bool) xs i them before ps i' rest :
  take good xs i them before = Some (ps, i', rest) ->
  exists more, ps = rev before ++ more /\ map fst more = xs /\ Forall (is_good good) more.
Proof.
  revert i them before. induction xs as [|x xs IH]; intros i them before H; cbn in H.
  - injection H as <- <- <-. rewrite rev_append_rev. exists []. now repeat split.
  - assert (Go : forall o them', is_good good (x, o) -> take good xs (i + 1) them' ((x, o) :: before) = Some (ps, i', rest) ->
      exists more, ps = rev before ++ more /\ map fst more = x :: xs /\ Forall (is_good good) more).
    { intros o them' G E. destruct (IH _ _ _ E) as (more & -> & M & F). exists ((x, o) :: more). split.
      - cbn. now rewrite <- app_assoc.
      - split; [cbn; congruence|now constructor]. }
    destruct them as [|[j f] them']; [now apply (Go None []) in H|].
    destruct (Z.eqb i j); [|now apply (Go None _ I) in H].
    destruct (good x f) eqn:G; [|discriminate]. now apply (Go (Some f) them').
Qed.

Lemma all_zero total y : forallb is_zero total = true -> real total .* y = 0.
Proof. apply RigidClass.zero_dot. Qed.

Section Bodies.
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

Variable s : standing.
Variable m : BodiesModel.mechanism k.

Definition touch_is (h : held) (t : BodiesModel.touch k) : Prop :=
  held_is h (BodiesModel.touching t) /\ h_of h = BodiesModel.of_body t /\ h_by h = BodiesModel.by_body t.

Definition element_is (e : element) (e' : BodiesModel.element) : Prop :=
  BodiesModel.lever e' = real (lever e) /\ BodiesModel.is_spring e' = element_spring e /\
  BodiesModel.stiffness e' = Q2R (low (element_stiffness e)) /\
  (is_loose e = true -> BodiesModel.preload e' = Q2R (low (element_preload e))).

Hypothesis contacts_are : Forall2 touch_is (s_contacts s) (BodiesModel.touches m).
Hypothesis elements_are : Forall2 element_is (s_elements s) (BodiesModel.elements m).
Hypothesis bodies_are : BodiesModel.bodies m = map real_body (s_bodies s).
Hypothesis numbers_are : BodiesModel.numbers k = s_numbers s.
Hypothesis dimension_is : BodiesModel.coordinates m = s_dimension s.

(* With h times the preloads of springs without stiffness. *)
Definition can_pull_times (h : R) (e : BodiesModel.element) (a : R) : Prop :=
  if BodiesModel.is_spring e then BodiesModel.stiffness e = 0 -> a = h * BodiesModel.preload e else 0 <= a.

Definition touches_work (ts : list (BodiesModel.touch k)) (forces : list (BodiesModel.force k)) (y : list R) : R :=
  BodiesModel.sum (map (fun tf => BodiesModel.works k (BodiesModel.touching (fst tf)) (snd tf) (BodiesModel.relative m y (fst tf)))
    (List.combine ts forces)).

Definition elements_work (es : list BodiesModel.element) (pulls : list R) (y : list R) : R :=
  BodiesModel.sum (map (fun ea => snd ea * (BodiesModel.lever (fst ea) .* y)) (List.combine es pulls)).

(* Some forces balance the load, which is known by its work. *)
Definition bears (h : R) (load : list R -> R) : Prop := exists forces pulls,
  Forall2 (fun t f => in_cone (BodiesModel.touching t) f) (BodiesModel.touches m) forces /\
  Forall2 (can_pull_times h) (BodiesModel.elements m) pulls /\
  forall y, List.length y = BodiesModel.coordinates m ->
    load y + touches_work (BodiesModel.touches m) forces y + elements_work (BodiesModel.elements m) pulls y = 0.

Lemma bears_stands w : bears 1 (fun y => w .* y) <-> may_stand in_cone m w.
Proof.
  split; intros (forces & pulls & F & P & B); exists forces, pulls; (split; [exact F|]); (split; [|exact B]);
    (eapply Forall2_weaken; [|exact P]); unfold can_pull, can_pull_times; intros e a H;
    destruct (BodiesModel.is_spring e); try exact H; intros Z; specialize (H Z); lra.
Qed.

Lemma bears_same h load h' load' : bears h load -> h = h' -> (forall y, load y = load' y) -> bears h' load'.
Proof.
  intros (forces & pulls & F & P & B) <- E. exists forces, pulls. split; [exact F|]. split; [exact P|].
  intros y L. rewrite <- E. now apply B.
Qed.

(* Forces of a mixture. *)
Lemma bears_mixed h load h' load' a b : 0 <= a -> 0 <= b -> bears h load -> bears h' load' ->
  bears (a * h + b * h') (fun y => a * load y + b * load' y).
Proof.
  intros A0 B0 (f1 & p1 & F1 & P1 & B1) (f2 & p2 & F2 & P2 & B2).
  assert (F : exists fs, Forall2 (fun t f => in_cone (BodiesModel.touching t) f) (BodiesModel.touches m) fs /\
    forall y, touches_work (BodiesModel.touches m) fs y =
      a * touches_work (BodiesModel.touches m) f1 y + b * touches_work (BodiesModel.touches m) f2 y).
  { clear - A0 B0 mixed F1 F2. unfold touches_work. revert f1 f2 F1 F2. induction (BodiesModel.touches m) as [|t ts IH];
      intros f1 f2 F1 F2; inversion F1 as [|? g1 ? r1 G1 R1]; inversion F2 as [|? g2 ? r2 G2 R2]; subst.
    - exists []. split; [constructor|]. intros y. cbn. ring.
    - destruct (IH _ _ R1 R2) as (fs & F & W). destruct (mixed _ _ _ a b A0 B0 G1 G2) as (g & G & Wg).
      exists (g :: fs). split; [now constructor|]. intros y. specialize (W y). cbn [List.combine map] in *.
      unfold BodiesModel.sum in *. cbn [fold_right fst snd] in *. rewrite W, Wg. ring. }
  destruct F as (fs & F & Wf).
  assert (P : exists ps, Forall2 (can_pull_times (a * h + b * h')) (BodiesModel.elements m) ps /\
    forall y, elements_work (BodiesModel.elements m) ps y =
      a * elements_work (BodiesModel.elements m) p1 y + b * elements_work (BodiesModel.elements m) p2 y).
  { clear - A0 B0 P1 P2. unfold elements_work. revert p1 p2 P1 P2. induction (BodiesModel.elements m) as [|e es IH];
      intros p1 p2 P1 P2; inversion P1 as [|? g1 ? r1 G1 R1]; inversion P2 as [|? g2 ? r2 G2 R2]; subst.
    - exists []. split; [constructor|]. intros y. cbn. ring.
    - destruct (IH _ _ R1 R2) as (ps & P & W). exists (a * g1 + b * g2 :: ps). split.
      + constructor; [|exact P]. unfold can_pull_times in *. destruct (BodiesModel.is_spring e).
        * intros Z. rewrite (G1 Z), (G2 Z). ring.
        * apply Rplus_le_le_0_compat; now apply Rmult_le_pos.
      + intros y. specialize (W y). cbn [List.combine map] in *. unfold BodiesModel.sum in *.
        cbn [fold_right fst snd] in *. rewrite W. ring. }
  destruct P as (ps & P & Wp). exists fs, ps. split; [exact F|]. split; [exact P|]. intros y L.
  specialize (B1 y L). specialize (B2 y L). rewrite Wf, Wp.
  replace (a * load y + b * load' y) with (a * (load y + touches_work (BodiesModel.touches m) f1 y +
    elements_work (BodiesModel.elements m) p1 y) + b * (load' y + touches_work (BodiesModel.touches m) f2 y +
    elements_work (BodiesModel.elements m) p2 y) - (a * touches_work (BodiesModel.touches m) f1 y + b *
    touches_work (BodiesModel.touches m) f2 y) - (a * elements_work (BodiesModel.elements m) p1 y + b *
    elements_work (BodiesModel.elements m) p2 y)) by ring.
  rewrite B1, B2. ring.
Qed.

(* The work of all preloads of loose springs. *)
Definition loose_work (y : list R) : R :=
  fold_right (fun e sum => (if is_loose e then Q2R (low (element_preload e)) * (real (lever e) .* y) else 0) + sum) 0
    (s_elements s).

Lemma is_loose_is e e' : element_is e e' ->
  (BodiesModel.is_spring e' = true /\ BodiesModel.stiffness e' = 0) <-> is_loose e = true.
Proof.
  intros (_ & Sp & St & _). unfold is_loose. rewrite Sp, St, andb_true_iff. split; intros [A B]; (split; [exact A|]).
  - destruct (is_zero _) eqn:Z; [reflexivity|]. apply not_zero_real in Z. contradiction.
  - now apply zero_real.
Qed.

(* static-force and static-balance *)
Theorem point_bears x them load : point_fails s x them = None ->
  (forall y, real (load_of_point x (s_loads s)) .* y = load y + Q2R (at_q x 0) * loose_work y) ->
  bears (Q2R (at_q x 0)) load.
Proof.
  intros H Load. unfold point_fails in H. destruct (Qle_bool 0 (at_q x 0)) eqn:H0; [cbn [negb] in H|discriminate].
  destruct (take is_lawful _ _ _ _) as [[[cs i] them']|] eqn:Tc; [|discriminate].
  destruct (take is_lawful_pull _ _ _ _) as [[[es i'] [|]]|] eqn:Te; try discriminate.
  destruct (forallb is_zero _) eqn:Z; [|discriminate]. clear H.
  apply take_is in Tc as (cs' & E & Mc & Gc). cbn in E. subst cs'. apply take_is in Te as (es' & E & Me & Ge). cbn in E. subst es'.
  set (h := Q2R (at_q x 0)) in *.
  set (value := fun p : held * option (Q * list Q) => match snd p with Some f => f | None => (0%Q, []) end).
  set (pull := fun p : element * option (Q * list Q) =>
    match snd p with Some (a, _) => Q2R a | None => if is_loose (fst p) then h * Q2R (low (element_preload (fst p))) else 0 end).
  exists (map (fun p => to_force (value p)) cs), (map pull es). split; [|split].
  - clear - contacts_are Mc Gc lawful_is idle. revert contacts_are. rewrite <- Mc. clear Mc. generalize (BodiesModel.touches m).
    induction Gc as [|[c o] cs G Gs IH]; intros ts F; inversion F as [|? t ? ts' (T & _) F']; subst; cbn; constructor; [|now apply IH].
    destruct o as [f|]; [|apply idle]. now apply lawful_is with c.
  - clear - elements_are Me Ge. revert elements_are. rewrite <- Me. clear Me. generalize (BodiesModel.elements m).
    induction Ge as [|[e o] es G Gs IH]; intros es' F; inversion F as [|? e' ? es'' Ee F']; subst; cbn; constructor; [|now apply IH].
    pose proof (is_loose_is e e' Ee) as Lo. destruct Ee as (_ & Sp & _ & Pr). unfold can_pull_times, pull. cbn [fst snd].
    unfold is_good in G. cbn [fst snd] in *. destruct o as [[a f]|].
    + unfold is_lawful_pull in G. apply andb_true_iff in G as [_ G]. rewrite Sp in *. destruct (element_spring e).
      * intros St. exfalso. apply negb_true_iff in G. rewrite (proj1 Lo (conj eq_refl St)) in G. discriminate.
      * now apply nonneg_real.
    + destruct (BodiesModel.is_spring e').
      * intros St. pose proof (proj1 Lo (conj eq_refl St)) as T. cbn [fst] in T. rewrite T, Pr by exact T. reflexivity.
      * destruct (is_loose e) eqn:T; [|lra]. destruct (proj2 Lo eq_refl) as [X _]. discriminate.
  - intros y _. set (all := BodiesModel.motions (BodiesModel.numbers k) y (BodiesModel.bodies m) []).
    set (total := fold_left add_element es (load_of_point x (s_loads s))) in *.
    set (ws := fold_left add_contact cs (map (fun _ => []) (s_bodies s))) in *.
    assert (La : List.length all = List.length (s_bodies s)) by (unfold all; rewrite motions_length, bodies_are, map_length; reflexivity).
    assert (Wc : forall cs ts ws, Forall2 touch_is (map fst cs) ts -> (List.length all <= List.length ws)%nat ->
      (List.length all <= List.length (fold_left add_contact cs ws))%nat /\
      pairs (fold_left add_contact cs ws) all = pairs ws all + touches_work ts (map (fun p => to_force (value p)) cs) y).
    { clear cs Mc Gc ws Z. induction cs as [|[c o] cs IH]; intros ts ws F L; inversion F as [|? t ? ts' T F']; subst.
      - split; [exact L|]. cbn. unfold touches_work; cbn. ring.
      - cbn [fold_left map]. destruct (IH ts' (add_contact ws (c, o)) F') as [L' W].
        + unfold add_contact. destruct o; [|exact L]. now rewrite !add_on_body_length.
        + split; [exact L'|]. rewrite W. unfold touches_work at 2. cbn [List.combine map]. unfold BodiesModel.sum. cbn [fold_right fst snd].
          fold (BodiesModel.sum (map (fun tf => BodiesModel.works k (BodiesModel.touching (fst tf)) (snd tf) (BodiesModel.relative m y (fst tf)))
            (List.combine ts' (map (fun p => to_force (value p)) cs)))).
          fold (touches_work ts' (map (fun p => to_force (value p)) cs) y).
          destruct T as (Hc & Eo & Ey). cbn [fst] in *. destruct o as [f|].
          * change (value (c, Some f)) with f. rewrite (wrench_works c) by exact Hc. unfold BodiesModel.relative. fold all. cbn [add_contact].
            rewrite !pairs_add_on_body by (rewrite ?add_on_body_length; exact L).
            rewrite dot_plus_right, dot_scaled_right, Eo, Ey, Q2R_1, Q2R_opp, Q2R_1. ring.
          * change (value (c, None)) with (0%Q, @nil Q). rewrite (proj2 (idle _)). cbn [add_contact]. ring. }
    pose proof (all_zero _ y Z) as Bal. rewrite rev_append_rev, app_nil_r in Bal.
    rewrite <- Mc in contacts_are. destruct (Wc cs _ (map (fun _ => []) (s_bodies s)) contacts_are) as [Lw Ww];
      [rewrite map_length; lia|]. fold ws in Lw, Ww.
    rewrite pull_back_is in Bal by (rewrite rev_length; lia). rewrite rev_involutive, <- numbers_are, <- bodies_are in Bal. fold all in Bal.
    rewrite Ww in Bal.
    assert (None_ : forall (bs : list rigid_body) all, pairs (map (fun _ => []) bs) all = 0).
    { induction bs as [|b bs IH]; intros [|d all']; cbn; try reflexivity. rewrite IH. ring. }
    rewrite None_ in Bal.
    assert (We : forall es es' total, Forall2 element_is (map fst es) es' -> Forall (is_good is_lawful_pull) es ->
      real (fold_left add_element es total) .* y + h * fold_right (fun e sum => (if is_loose e then Q2R (low (element_preload e)) * (real (lever e) .* y) else 0) + sum) 0
        (map fst es) =
      real total .* y + elements_work es' (map pull es) y).
    { clear es Me Ge total Z Bal. induction es as [|[e o] es IH]; intros es' total F G; inversion F as [|? e' ? es'' Ee F']; subst.
      - cbn. unfold elements_work; cbn. ring.
      - specialize (IH es'' (add_element total (e, o)) F' (Forall_inv_tail G)). cbn [fold_left map fst fold_right].
        unfold elements_work in *. cbn [List.combine map]. unfold BodiesModel.sum in *. cbn [fold_right fst snd].
        rewrite Rmult_plus_distr_l, (Rplus_comm (h * _)), <- Rplus_assoc, IH.
        destruct Ee as (El & _). cbn [fst] in El. rewrite El. unfold pull at 2. cbn [snd fst].
        pose proof (Forall_inv G) as Ge. unfold is_good in Ge. cbn [fst snd] in Ge. destruct o as [[a f]|]; cbn [add_element].
        + unfold is_lawful_pull in Ge. apply andb_true_iff in Ge as [_ Ge]. rewrite plus_times_real.
          destruct (is_loose e) eqn:T; [|ring]. unfold is_loose in T. apply andb_true_iff in T as [T1 T2].
          rewrite T1 in Ge. discriminate.
        + destruct (is_loose e); ring. }
    rewrite <- Me in elements_are. specialize (We es _ (load_of_point x (s_loads s)) elements_are Ge). fold total in We.
    rewrite Me in We. fold (loose_work y) in We. rewrite Load in We. lra.
Qed.

(* static-motion *)
Theorem none_bears y load : unopposed s y = true -> bears 1 load -> load (real y) + loose_work (real y) <= 0.
Proof.
  intros H (forces & pulls & F & P & B). unfold unopposed in H. rewrite !andb_true_iff in H. destruct H as [[L Uc] Ue].
  apply Nat.eqb_eq in L. specialize (B (real y)). rewrite map_length, L, dimension_is in B. specialize (B eq_refl).
  set (all := motions_q (s_numbers s) y (s_bodies s) []) in *.
  assert (Wc : 0 <= touches_work (BodiesModel.touches m) forces (real y)).
  { clear - Uc F contacts_are unopposed_works numbers_are bodies_are all. revert Uc forces F. unfold touches_work. induction contacts_are as [|c t cs ts T Ts IH];
      intros Uc forces F; inversion F as [|? f ? fs Cf F']; subst; [cbn; lra|].
    cbn in Uc. apply andb_true_iff in Uc as [U Us]. specialize (IH Ts Us _ F').
    cbn [List.combine map]. unfold BodiesModel.sum in *. cbn [fold_right fst snd].
    assert (E : BodiesModel.relative m (real y) t = real (relative_q all c)).
    { unfold BodiesModel.relative, relative_q. destruct T as (_ & <- & <-). rewrite numbers_are, bodies_are.
      pose proof (motions_real (s_numbers s) y (s_bodies s) []) as M. cbn [map] in M. rewrite <- M. fold all.
      rewrite <- !of_number_real. destruct (h_by c) as [b|].
      - rewrite map_map, (map_ext (fun x => Q2R (reduced x)) Q2R) by apply reduced_same.
        rewrite add_multiple_real. do 2 f_equal. rewrite Q2R_opp, Q2R_1. reflexivity.
      - cbn. destruct (real (of_number_q all (h_of c))); reflexivity. }
    rewrite E. pose proof (unopposed_works c (BodiesModel.touching t) (relative_q all c) f (proj1 T) U Cf). lra. }
  assert (We : loose_work (real y) <= elements_work (BodiesModel.elements m) pulls (real y)).
  { clear - Ue P elements_are. unfold loose_work, elements_work. revert pulls P Ue. induction elements_are as [|e e' es es' Ee Es IH];
      intros pulls P Ue; inversion P as [|? a ? ps Ca P']; subst; [cbn; lra|].
    cbn in Ue. apply andb_true_iff in Ue as [U Us]. specialize (IH Es _ P' Us).
    cbn [List.combine map]. unfold BodiesModel.sum in *. cbn [fold_right fst snd].
    pose proof (is_loose_is e e' Ee) as Lo. destruct Ee as (El & Sp & _ & Pr). unfold unopposed_by_element in U. rewrite El.
    unfold can_pull_times in Ca. rewrite Sp in *. destruct (element_spring e) eqn:S.
    - destruct (is_loose e) eqn:T.
      + destruct (proj2 Lo eq_refl) as [_ St]. rewrite (Ca St), Pr by reflexivity. lra.
      + cbn in U. apply zero_real in U. rewrite inner_real in U. rewrite U. lra.
    - assert (T : is_loose e = false) by (unfold is_loose; now rewrite S). rewrite T. apply nonneg_real in U. rewrite inner_real in U.
      assert (0 <= a * (real (lever e) .* real y)) by (now apply Rmult_le_pos). lra. }
  lra.
Qed.

End Bodies.
