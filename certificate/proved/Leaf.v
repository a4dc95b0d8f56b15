(* SPDX-License-Identifier: MIT *)
(* The leaf of a tree (FORMAT.md sections 4, 6 and 7): the sum of what the load and all contacts can do of
   work on a virtual twist.  `leaf_refutes`: where a leaf holds, no equilibrium is at home. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load.
From Proved Require Import Question Cone Meaning Numbers Root Box Terms Edges Slips.
From Proved Require Rows Degree Model RowLimits.
Import ListNotations.

Section Checker.
Open Scope Z_scope.

(* ---- The load ---- *)

(* The most work that loads do on y, which is `factor` times these integers, over the factor: of w, and of u. *)
Definition load_works (ld : load) (factor : Q) (y : form) : Q * Q :=
  let y := map (fun c => (factor * inject_Z c)%Q) y in
  (reduced (high (work_of ld y) / factor), reduced (inner (load_growth ld) y / factor)).

Definition load_term (m : Z) (works : Q * Q) : form :=
  let (a, b) := works in [up (m * Qnum a) (Zpos (Qden a)); up (m * Qnum b) (Zpos (Qden b))].

(* ---- Contacts that press ---- *)

(* How their work is bounded: by edges, or by one number. *)
Inductive way := Along (es : list (multi form)) | Most (a : Q).

(* `mixed`: it may also not press. *)
Record presser := Presser { pressing : row; by_ : way; mixed : bool }.

Definition way_of (strict : list (list form)) (rays : list ray) (slipping : bool) (factor : Q)
    (y : form) (row : row) : way :=
  if box_signed (box row) then Along (edges strict rays row)
  else Most (alpha strict rays slipping row factor y).

(* `slipping`: the contacts whose slip is strict. *)
Fixpoint pressers (strict : list (list form)) (rays : list ray) (slipping : list Z) (factor : Q)
    (y : form) (rows : list row) (number : Z) (before : list presser) : list presser :=
  match rows with
  | [] => before
  | row :: rows' =>
      let vs := pull_tips row in
      let it (mixed : bool) :=
        Presser row (way_of strict rays (existsb (Z.eqb number) slipping) factor y row) mixed in
      let now :=
        if box_spring (box row) || forallb (nowhere_negative rays) vs then it false :: before
        else if forallb (nowhere_positive rays) vs then before
        else it true :: before in
      pressers strict rays slipping factor y rows' (number + 1) now
  end.

Definition term_of (m : Z) (y : form) (p : presser) : term :=
  match by_ p with
  | Along es => edges_term m y es (mixed p) (pressing p)
  | Most a => alpha_term m a (mixed p) (pressing p)
  end.

(* A multiple of a multiple of the denominators of edges, of the others too. *)
Definition with_all (m : Z) (works : Q * Q) (more : list Q) (them : list presser) : Z :=
  let m := fold_left (fun m q => Z.lcm m (Zpos (Qden q))) more m in
  fold_left (fun m p => match by_ p with
                        | Along _ => m
                        | Most a => Z.lcm m (alpha_over a (pressing p))
                        end) them (Z.lcm (Z.lcm m (Zpos (Qden (fst works)))) (Zpos (Qden (snd works)))).

(* ---- The leaf ---- *)

(* `more`: a form that is added to g, exactly. *)
Definition leaf_holds_by (m : Z) (them : list presser) (works : Q * Q) (more : list Q) (strict : list (list form))
    (rays : list ray) (y : form) : bool :=
  (0 <? m) && forallb (fun q => (m * Qnum q) mod Zpos (Qden q) =? 0) more &&
  let form := combine 1 (load_term m works) 1 (map (fun q => m * Qnum q / Zpos (Qden q)) more) in
  let (linear, bends) := collect (term_of m y) them form [] in
  positive_at_home strict rays (fun x => - fold_left (fun s t => s + value t x) bends (dot linear x)).

End Checker.

(* ---- Proofs ---- *)

Section Leaf.
Open Scope R_scope.

Definition fits (row : row) (r : Rows.row) := row = make_row (box row) /\ inside (box row) r.

(* A contact whose normal is uncertain in space is not in the box, as its slip is not multilinear in the normal, but
   a row that stands for it is; k is FORMAT.md's delta of its own normal. *)
Record stands (k : R) (r r' : Rows.row) : Prop := Stands {
  same_N : Rows.N r' = Rows.N r;
  same_shape : map (@List.length R) (Rows.slips r') = map (@List.length R) (Rows.slips r);
  same_weights : Rows.weights r' = Rows.weights r;
  same_preload : Rows.preload r' = Rows.preload r;
  same_growth : Rows.growth r' = Rows.growth r;
  same_stiffness : Rows.stiffness r' = Rows.stiffness r;
  same_spring : Rows.spring r' = Rows.spring r;
  own_weights : Rows.positive (Rows.weights r);
  own_slack : 0 <= k;
  no_rubbing : Rows.rho r' = 0 -> Rows.rho r = 0;
  rubs : forall w d h l a g y, Rows.obeys w d h l r (a, g) -> 0 <= a ->
    work_within r' k a d y (Rows.product (Rows.weights r) g (Rows.slip r y));
  (* on its own slip friction does work below 0, and no less than the one's *)
  brakes : forall w d h l a g, Rows.obeys w d h l r (a, g) -> 0 <= a ->
    Rows.product (Rows.weights r) g (Rows.slip r d) <= - (Rows.rho r' * a) * Rows.size (Rows.weights r') (Rows.slip r' d);
  (* friction that the one can hold, the other can *)
  holds : forall a g', Rows.size (Rows.weights r') g' <= Rows.rho r' * a ->
    exists g, Rows.size (Rows.weights r) g <= Rows.rho r * a /\
      forall y, Rows.product (Rows.weights r) g (Rows.slip r y) = Rows.product (Rows.weights r') g' (Rows.slip r' y);
  slides : forall d, 0 < Rows.size (Rows.weights r) (Rows.slip r d) <->
    0 < Rows.size (Rows.weights r') (Rows.slip r' d)
}.

(* A row of a box with these forms, of N and of slips. *)
Definition row_of (b : cbox) (forms : list (list R)) (rho p u k : R) : Rows.row :=
  Rows.Row (hd [] forms) (tl forms) (map Q2R (box_weights b)) rho p u k (box_spring b).

(* All rows with the forms G and rho = mu len, as the geometry and mu change: those with the forms F, which are in the
   box, stand for them. *)
Record seen_as (b : cbox) (F G : list R -> list (list R)) (len k : list R -> R) : Prop := SeenAs {
  each_stands : forall q mu p u s, List.length q = List.length (box_geometry b) -> 0 <= mu ->
    stands (k q) (row_of b (G q) (mu * len q) p u s) (row_of b (F q) (mu * sqrt (Q2R (box_square b))) p u s);
  len_nonneg : forall q, 0 <= len q;
  slack_above : forall is q, Forall2 within is q -> List.length q = List.length (box_geometry b) ->
    k q <= Q2R (box_slack b is);
  true_continuous : forall qs q, List.length q = List.length (box_geometry b) -> RowLimits.cv_list qs q ->
    RowLimits.cv_lists (fun i => G (qs i)) (G q) /\ Un_cv (fun i => len (qs i)) (len q);
  if_straight : box_turns b = false -> forall q, List.length q = List.length (box_geometry b) ->
    G q = F q /\ len q = sqrt (Q2R (box_square b))
}.

Definition seen_in (b : cbox) (r : Rows.row) : Prop :=
  exists r' p F mu t G len k, inside_at b r' p F mu t /\ seen_as b F G len k /\
    r = row_of b (G p) (mu * len p) (Rows.preload r') (Rows.growth r') (Rows.stiffness r').

Definition suits (row : row) (r : Rows.row) := row = make_row (box row) /\ seen_in (box row) r.

Lemma stands_for_itself r : Rows.positive (Rows.weights r) -> stands 0 r r.
Proof.
  intros P. constructor; try reflexivity; try assumption; try lra; try (intros; assumption).
  - intros w d h l a g y Ob _. eapply obeys_within; eassumption.
  - intros w d h l a g (_ & _ & D) _. now right.
  - intros a g H. now exists g.
Qed.

Lemma inside_row b r p F mu t : inside_at b r p F mu t ->
  r = row_of b (F p) (mu * sqrt (Q2R (box_square b))) (Rows.preload r) (Rows.growth r) (Rows.stiffness r).
Proof.
  intros I. unfold row_of. rewrite <- (is_forms _ _ _ _ _ _ I), <- (is_rho _ _ _ _ _ _ I),
    <- (is_weights _ _ _ _ _ _ I), <- (is_spring _ _ _ _ _ _ I). now destruct r.
Qed.

Lemma true_row_stands b r' p F mu t G len k : inside_at b r' p F mu t -> seen_as b F G len k ->
  stands (k p) (row_of b (G p) (mu * len p) (Rows.preload r') (Rows.growth r') (Rows.stiffness r')) r'.
Proof.
  intros I Se. rewrite (inside_row _ _ _ _ _ _ I) at 4. apply (each_stands _ _ _ _ _ Se).
  - symmetry. apply (same_length within), I.
  - apply (friction_nonneg _ _ _ _ _ _ I).
Qed.

(* What the proofs about leaves need of it. *)
Lemma seen_stands b r : seen_in b r -> exists r' k p F mu t, inside_at b r' p F mu t /\ stands k r r' /\
  (forall is, Forall2 within is p -> k <= Q2R (box_slack b is)) /\ (box_turns b = false -> r' = r).
Proof.
  intros (r' & p & F & mu & t & G & len & k & I & Se & ->). exists r', (k p), p, F, mu, t.
  assert (L : List.length p = List.length (box_geometry b))
    by (symmetry; apply (same_length within), I).
  split; [exact I|]. split; [now apply true_row_stands with F t|]. split.
  - intros is W. now apply (slack_above _ _ _ _ _ Se).
  - intros T. destruct (if_straight _ _ _ _ _ Se T p L) as [-> ->]. exact (inside_row _ _ _ _ _ _ I).
Qed.

Lemma suits_fits row r : suits row r -> box_turns (box row) = false -> fits row r.
Proof.
  intros [E Se] T. destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & _ & _ & Same). split; [exact E|]. rewrite <- (Same T).
  now exists p, F, mu, t.
Qed.

Lemma same_pull k r r' d h l : stands k r r' -> Rows.v r' d h l = Rows.v r d h l.
Proof.
  intros St. unfold Rows.v.
  now rewrite (same_N _ _ _ St), (same_preload _ _ _ St), (same_growth _ _ _ St), (same_stiffness _ _ _ St).
Qed.

(* A point (d, h, l) and forces that obey the law of a system in the box of these rows and this load; what they
   do of work, with the load, is that of `push`: nothing in an equilibrium. *)
Record solution (rows : list row) (ld : load) (push : list R -> R) (s : Rows.system) (d : list R) (h l : R)
    (fs : list Rows.force) : Prop := Solution {
  rows_suit : Forall2 suits rows (Rows.rows s);
  wrench_fits : is_load ld (Rows.wrench s);
  growth_fits : map Q2R (load_growth ld) = Rows.direction s;
  h_nonneg : 0 <= h;
  l_nonneg : 0 <= l;
  all_obey : Forall2 (Rows.obeys (Rows.normal s) d h l) (Rows.rows s) fs;
  is_balanced : forall y, Rows.load s h l y + Rows.works (Rows.rows s) fs y = push y
}.

(* The contacts of these numbers slip. *)
Definition slips_at (slipping : list Z) (rs : list Rows.row) (d : list R) :=
  forall k r, existsb (Z.eqb (Z.of_nat k)) slipping = true -> nth_error rs k = Some r ->
  0 < Rows.size (Rows.weights r) (Rows.slip r d).

Variable strict : list (list form).
Variable rays : list ray.
Variables (d : list R) (h l : R).
Let x := h :: l :: d.
Hypothesis rays_know : Forall (knows strict) rays.
Hypothesis strict_at_x : Forall (Exists (fun f => rdot f x <> 0)) strict.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.
Notation bound t := (over_rays (value t) ws).

Variable y : form.
Let yv := map IZR y.
Variable factor : Q.
Hypothesis factor_positive : 0 < Q2R factor.
Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.

Lemma load_bound ld s : is_load ld (Rows.wrench s) -> map Q2R (load_growth ld) = Rows.direction s ->
  0 <= h -> 0 <= l ->
  IZR m * Rows.load s h l yv <= rdot (load_term m (load_works ld factor y)) x.
Proof.
  intros Hw Hu H0 L0. unfold load_works, load_term. set (yq := map _ y).
  assert (NZ : ~ (factor == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
  assert (Yq : forall w, Rows.dot w (real yq) = Q2R factor * Rows.dot w yv).
  { intros w. rewrite Degree.dot_sym, (Degree.dot_sym w), <- Rows.dot_scaled. f_equal. unfold yq, yv, real, Rows.scaled.
    rewrite !map_map. apply map_ext. intros c. rewrite Q2R_mult. f_equal. unfold Q2R; cbn. field. }
  apply IZR_lt in m_positive as MP.
  assert (Step : forall q t, Q2R factor * t <= Q2R q -> IZR m * t <=
    IZR (up (m * Qnum (reduced (q / factor)%Q)) (Zpos (Qden (reduced (q / factor)%Q))))).
  { intros q t T. set (a := reduced (q / factor)%Q).
    eapply Rle_trans; [|apply up_above; reflexivity]. rewrite mult_IZR.
    replace (IZR m * IZR (Qnum a) / IZR (Zpos (Qden a))) with (IZR m * Q2R a) by (unfold Q2R, Rdiv; ring).
    apply Rmult_le_compat_l; [lra|]. unfold a. rewrite reduced_same, Q2R_div by exact NZ.
    apply Rmult_le_reg_l with (Q2R factor); [exact factor_positive|]. field_simplify; lra. }
  destruct (load_within ld _ yq Hw) as [_ Bw]. rewrite Yq in Bw. apply Step in Bw.
  assert (Bu : Q2R factor * Rows.dot (Rows.direction s) yv <= Q2R (inner (load_growth ld) yq))
    by (rewrite Matrix.inner_is, <- Yq, <- Hu; right; reflexivity).
  apply Step in Bu. unfold Rows.load, x; cbn [rdot].
  match type of Bw with _ <= IZR ?z => set (cw := z) in * end.
  match type of Bu with _ <= IZR ?z => set (cu := z) in * end.
  set (yw := Rows.dot (Rows.wrench s) yv) in *. set (yu := Rows.dot (Rows.direction s) yv) in *.
  assert (A : h * (IZR m * yw) <= h * IZR cw) by (apply Rmult_le_compat_l; assumption).
  assert (B : l * (IZR m * yu) <= l * IZR cu) by (apply Rmult_le_compat_l; assumption).
  lra.
Qed.

(* A contact's force does at most the bound of work. *)
Lemma presser_bound w (slipping may_open : bool) b r a g :
  seen_in b r -> Rows.obeys w d h l r (a, g) ->
  (slipping = true -> 0 < Rows.size (Rows.weights r) (Rows.slip r d)) ->
  (if may_open then box_spring b = false else
     box_spring b || forallb (nowhere_negative rays) (pull_tips (make_row b)) = true) ->
  IZR m * Rows.work r (a, g) yv <= bound (term_of m y
    (Presser (make_row b) (way_of strict rays slipping factor y (make_row b)) may_open)).
Proof.
  intros Se Ob HS Closed. destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & St & Sk & Same).
  pose proof (same_pull k r r' d h l St) as Pull. set (v := Rows.v r d h l) in *.
  assert (Law : (box_spring b = true -> a = v) /\ (box_spring b = false -> a = Rmax 0 v)).
  { destruct Ob as [Law _]. unfold Rows.normal_law in Law.
    rewrite <- (same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I) in Law.
    split; intros E; rewrite E in Law; [exact Law|]. fold v in Law. destruct w; cbn in Law; [exact Law|].
    rewrite Rmax_right; lra. }
  assert (Shut : may_open = false -> box_spring b = false -> 0 <= v).
  { intros -> E. rewrite E in Closed. cbn [orb] in Closed. rewrite <- Pull.
    exact (v_nonneg rays d h l ws W spanned b r' p F mu t I Closed). }
  unfold term_of, way_of. cbn [by_ mixed pressing]. change (box (make_row b)) with b.
  destruct (box_signed b) eqn:Sg; cbn [by_ mixed pressing].
  - specialize (Same (signed_straight _ _ _ _ _ _ I Sg)). subst r'. destruct may_open.
    + destruct Law as [_ Law]. rewrite (Law Closed) in *.
      exact (mixed_bound strict rays d h l rays_know strict_at_x ws W spanned y m m_positive b r p F mu t I Sg w g Ob).
    + assert (V : a = v /\ (0 <= v \/ box_spring b = true)).
      { destruct (box_spring b) eqn:E; [split; [now apply Law|now right]|].
        pose proof (Shut eq_refl eq_refl) as V. split; [|now left].
        destruct Law as [_ ->]; [|reflexivity]. now apply Rmax_right. }
      destruct V as [-> V].
      exact (closed_bound strict rays d h l rays_know strict_at_x ws W spanned y m m_positive b r p F mu t I Sg w g V Ob).
  - assert (E : box_spring b = false) by now apply (spring_signed _ _ _ _ _ _ I).
    destruct Law as [_ Law]. specialize (Law E).
    assert (A0 : 0 <= a) by (rewrite Law; apply Rmax_l).
    apply IZR_lt in m_positive as MP.
    apply Rle_trans with (IZR m * (a * Q2R (alpha strict rays slipping (make_row b) factor y))).
    + apply Rmult_le_compat_l; [lra|]. unfold Rows.work. cbn [fst snd]. rewrite <- (same_N _ _ _ St).
      assert (K : 0 <= k <= Q2R (slack (make_row b))).
      { split; [apply (own_slack _ _ _ St)|]. cbn [slack make_row]. apply Sk, I. }
      apply (force_bound strict rays d h l rays_know strict_at_x ws W spanned y factor factor_positive
        b r' p F mu t I Sg slipping k a _ (rubs _ _ _ St w d h l a g yv Ob A0) A0 K).
      intros S. apply (slides _ _ _ St). now apply HS.
    + rewrite <- Pull in Law.
      apply (alpha_term_bound rays d h l ws W spanned b r' p F mu t I m m_positive _ _ _ Law).
      intros M. rewrite Pull. now apply Shut.
Qed.

Lemma open_works w b r a g z : seen_in b r -> Rows.obeys w d h l r (a, g) -> box_spring b = false ->
  forallb (nowhere_positive rays) (pull_tips (make_row b)) = true -> Rows.work r (a, g) z = 0.
Proof.
  intros Se (Law & Cone & _) Sp Open. destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & St & _ & _).
  pose proof (v_nonpos rays d h l ws W spanned b r' p F mu t I Open) as V.
  rewrite (same_pull k r r' d h l St) in V.
  unfold Rows.normal_law in Law. rewrite <- (same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I), Sp in Law.
  assert (A : a = 0) by (destruct w; cbn in Law; [rewrite Law; now apply Rmax_left|lra]).
  subst a. rewrite Rmult_0_r in Cone. unfold Rows.work. cbn [fst snd].
  rewrite (Rows.size_zero _ g _ (own_weights _ _ _ St)); [ring|].
  pose proof (Rows.size_nonneg (Rows.weights r) g). lra.
Qed.

Lemma forces_bound w slipping rows rs fs number before :
  Forall2 suits rows rs -> Forall2 (Rows.obeys w d h l) rs fs ->
  (forall k r, existsb (Z.eqb (number + Z.of_nat k)) slipping = true -> nth_error rs k = Some r ->
     0 < Rows.size (Rows.weights r) (Rows.slip r d)) ->
  IZR m * Rows.works rs fs yv + bounds ws (map (term_of m y) before)
  <= bounds ws (map (term_of m y) (pressers strict rays slipping factor y rows number before)).
Proof.
  intros F. revert fs number before. induction F as [|row r rows rs [Fr I] F IH]; intros fs number before O SL.
  - inversion O; subst. cbn. lra.
  - inversion O as [|r' [a g] rs' fs' Oc Os]; subst. cbn [pressers Rows.works].
    assert (SL' : forall k r0, existsb (Z.eqb (number + 1 + Z.of_nat k)) slipping = true ->
      nth_error rs k = Some r0 -> 0 < Rows.size (Rows.weights r0) (Rows.slip r0 d)).
    { intros k r0 H1 H2. apply (SL (S k) r0); [|exact H2].
      replace (number + Z.of_nat (S k))%Z with (number + 1 + Z.of_nat k)%Z by lia. exact H1. }
    assert (HS : existsb (Z.eqb number) slipping = true -> 0 < Rows.size (Rows.weights r) (Rows.slip r d)).
    { intros H. apply (SL 0%nat r); [|reflexivity]. now rewrite Z.add_0_r. }
    eapply Rle_trans; [|apply (IH fs' (number + 1)%Z _ Os SL')].
    rewrite Fr. change (box (make_row (box row))) with (box row).
    assert (Add : forall mixed : bool, (if mixed then box_spring (box row) = false else
        box_spring (box row) || forallb (nowhere_negative rays) (pull_tips (make_row (box row))) = true) ->
      IZR m * (Rows.work r (a, g) yv + Rows.works rs fs' yv) + bounds ws (map (term_of m y) before) <=
      IZR m * Rows.works rs fs' yv + bounds ws (map (term_of m y) (Presser (make_row (box row))
        (way_of strict rays (existsb (Z.eqb number) slipping) factor y (make_row (box row))) mixed :: before))).
    { intros mixed C. pose proof (presser_bound w _ mixed (box row) r a g I Oc HS C) as B.
      cbn [map bounds]. lra. }
    destruct (box_spring (box row) || _) eqn:Closed; [exact (Add false eq_refl)|].
    apply orb_false_iff in Closed as [Sp _].
    destruct (forallb (nowhere_positive rays) _) eqn:Open; [|exact (Add true Sp)].
    rewrite (open_works w (box row) r a g yv I Oc Sp Open). lra.
Qed.

Lemma exact_form more : forallb (fun q => (m * Qnum q) mod Zpos (Qden q) =? 0)%Z more = true ->
  rdot (map (fun q => m * Qnum q / Zpos (Qden q))%Z more) x = IZR m * Rows.dot (real more) x.
Proof.
  generalize x. induction more as [|q more IH]; intros [|t z] H; cbn in *; try ring.
  apply andb_true_iff in H as [H1 H2]. unfold real in IH. rewrite IH by exact H2. apply Z.eqb_eq in H1.
  assert (E : (m * Qnum q = Zpos (Qden q) * (m * Qnum q / Zpos (Qden q)))%Z) by (apply Z_div_exact_full_2; lia).
  apply (f_equal IZR) in E. rewrite !mult_IZR in E. set (k := (_ / _)%Z) in *.
  replace (IZR k) with (IZR m * Q2R q); [ring|]. unfold Q2R.
  assert (P : 0 < IZR (Zpos (Qden q))) by (apply IZR_lt; lia).
  apply Rmult_eq_reg_l with (IZR (Zpos (Qden q))); [|lra]. rewrite <- E. field. lra.
Qed.

Theorem leaf_refutes rows ld push slipping s fs more :
  solution rows ld push s d h l fs -> slips_at slipping (Rows.rows s) d ->
  0 <= push yv + Rows.dot (real more) x ->
  leaf_holds_by m (pressers strict rays slipping factor y rows 0 []) (load_works ld factor y) more strict rays y = false.
Proof.
  intros [F LW LU H0 L0 Ob Bal] SL P. apply not_true_is_false. intros H.
  unfold leaf_holds_by in H. apply andb_true_iff in H as [Ex H]. apply andb_true_iff in Ex as [_ Ex].
  destruct (collect _ _ _ []) as [linear bends] eqn:C in H.
  apply (positive_at_home_positive strict rays _ rays_know strict_at_x ws W spanned) in H.
  rewrite (sum_of_values _ ws spanned) in H.
  pose proof (collect_sum _ ws spanned _ _ _ _ _ _ C) as Sum. cbn [bounds] in Sum.
  pose proof (forces_bound _ slipping rows (Rows.rows s) fs 0%Z [] F Ob SL) as FB. cbn [map bounds] in FB.
  pose proof (load_bound ld s LW LU H0 L0) as LB. specialize (Bal yv).
  set (A := Rows.load s h l yv) in *. set (B := Rows.works (Rows.rows s) fs yv) in *.
  rewrite rdot_combine, (exact_form more Ex) in Sum. set (C' := Rows.dot (real more) x) in *.
  apply IZR_lt in m_positive as MP. assert (0 <= IZR m * (A + B + C')) by (rewrite Bal; apply Rmult_le_pos; lra). lra.
Qed.

End Leaf.
