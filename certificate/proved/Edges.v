(* SPDX-License-Identifier: MIT *)
(* Slips with a sign, those of one component (FORMAT.md section 4, "Leaf"): the bound of a contact's work, by
   the edges N + s T of its friction, where s is at an end of what the sign of slip leaves; and of a spring,
   which has no slip and one edge, N.  `edges_bound`: no force does more work. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root Box Terms.
From Proved Require Rows Model.
Import ListNotations.

Section Checker.
Open Scope Z_scope.

Definition edges (strict : list (list form)) (rays : list ray) (row : row) : list (multi form) :=
  match edges_none row with
  | [_] => edges_none row
  | _ => if has_sign strict rays (tau row) then edges_plus row
         else if has_sign strict rays (minus_tau row) then edges_minus row
         else edges_none row
  end.

Definition work_tree (y : form) (edge : multi form) : multi Z := mmap (fun f => dot f y) edge.

Definition products_with (row : row) (a : multi Z) : list form :=
  flat_map (fun p => bernstein (parameters row) [(a, p)]) (pulls row).

(* Of one s, for a contact that is mixed. *)
Definition mixed_forms (row : row) (a : multi Z) : list form :=
  if forallb (fun z => z <=? 0) (tips a) then []
  else if forallb (fun z => 0 <=? z) (tips a) then products_with row a
  else map (map (Z.mul (power (parameters row) * largest (tips a)))) (pull_tips row).

Definition bent (m : Z) (row : row) (forms : list form) (mixed : bool) : term :=
  match forms with
  | [] => Nothing
  | _ => Bend (m * weight row) (over_weight row) forms mixed
  end.

(* A spring's v may be below 0, so that nothing else of it is rounded up. *)
Definition edges_term (m : Z) (y : form) (es : list (multi form)) (mixed : bool) (row : row) : term :=
  match parameters row, pulls row, box_spring (box row) with
  | O, [p], false =>
      let c := largest (map (fun e =>
                 up (m * weight row * dot (first_tip e) y) (over_weight row)) es) in
      let v := first_tip p in
      if mixed then (if c <=? 0 then Nothing else Bend c 1 [v] true) else Line c v
  | _, _, _ =>
      bent m row (flat_map (fun e => (if mixed then mixed_forms row else products_with row)
                                       (work_tree y e)) es) mixed
  end.

End Checker.

(* ---- Proofs ---- *)

Section Edges.
Open Scope R_scope.

Lemma Rabs_within (x a : R) : (Rabs x <= a -> - a <= x <= a)%R.
Proof.
  intros H. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra.
Qed.

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
Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.

Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.
Hypothesis signed : box_signed b = true.
Let it := make_row b.
Let ss := shares_in b p.
Let T := T r.

(* y.(N + s T) *)
Notation alpha s := (Rows.dot (Rows.N r) yv + s * Rows.dot T yv).
Let v := Rows.v r d h l.

Lemma shares_are : Forall is_share ss.
Proof. apply (shares_valid b r p F mu t I). Qed.

Lemma edge_unit : 0 < unit (edge_scaling b).
Proof. apply trees_unit_positive. Qed.

Notation s_list :=
  (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)).

(* Some s of which the bound is taken, as its edge. *)
Definition edge_of (s : Q) : multi form := integer_tree (edge_scaling b) (edge_tree b s).

(* alpha of an edge, in integers. *)
Lemma alpha_is s : In s s_list ->
  alpha (Q2R s) = unit (edge_scaling b) * eval IZR (work_tree y (edge_of s)) ss.
Proof.
  intros H. unfold T. rewrite (edge_corners b r p F mu t I s yv H). f_equal. unfold work_tree.
  rewrite eval_mmap. apply eval_same. intros f _. apply rdot_integers.
Qed.

Lemma weight_is : (0 < over_weight it)%Z /\ (0 < m * weight it)%Z /\
  unit (edge_scaling b) * unit (pull_scaling b) =
  IZR (weight it) / IZR (over_weight it) * IZR (power (parameters it)).
Proof.
  destruct (row_weight b signed) as [O E]. fold it in O, E. pose proof (power_positive (parameters it)).
  pose proof (pull_unit b). pose proof edge_unit. split; [exact O|]. split.
  - assert (0 < weight it)%Z; [|nia]. apply lt_IZR. apply IZR_lt in O.
    assert (0 < IZR (weight it) / IZR (over_weight it)).
    { rewrite E. apply Rdiv_lt_0_compat; [|assumption]. apply Rmult_lt_0_compat; assumption. }
    replace (IZR (weight it)) with (IZR (weight it) / IZR (over_weight it) * IZR (over_weight it))
      by (field; lra). apply Rmult_lt_0_compat; assumption.
  - rewrite E. field. lra.
Qed.

(* The bound of alpha v of a contact that is closed, or that is mixed and presses. *)
Lemma products_bound s U : In s s_list ->
  (forall f, In f (products_with it (work_tree y (edge_of s))) ->
     IZR (m * weight it) / IZR (over_weight it) * rdot f x <= U) ->
  IZR m * alpha (Q2R s) * v <= U.
Proof.
  intros Hs H. destruct weight_is as (O & N & E). apply (v_by_trees d h l b r p F mu t I). intros e He.
  rewrite (alpha_is s Hs). fold ss x.
  set (A := work_tree y (edge_of s)) in *.
  set (P := integer_tree (pull_scaling b) (pull_tree b e)).
  replace (IZR m * (unit (edge_scaling b) * eval IZR A ss) *
           (unit (pull_scaling b) * eval (fun f => rdot f x) P ss))
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) *
          (products [(A, P)] x ss)) by (cbn; ring).
  rewrite E. set (q := IZR (m * weight it) / IZR (over_weight it)) in *.
  replace (IZR m * (IZR (weight it) / IZR (over_weight it) * IZR (power (parameters it))) *
           products [(A, P)] x ss)
    with (q * (IZR (power (parameters it)) * products [(A, P)] x ss))
    by (unfold q, Rdiv; rewrite mult_IZR; ring).
  assert (Q : 0 < q) by (apply Rdiv_lt_0_compat; now apply IZR_lt).
  assert (IZR (power (parameters it)) * products [(A, P)] x ss <= U / q).
  { apply bernstein_bound; [apply (shares_length b r p F mu t I)|exact shares_are|]. intros f Hf.
    apply Rmult_le_reg_l with q; [exact Q|]. replace (q * (U / q)) with U by (field; lra).
    apply H. apply in_flat_map. exists P. split; [now apply pull_in | exact Hf]. }
  replace U with (q * (U / q)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(* The same with the products of the largest alpha and all v. *)
Lemma largest_bound s U : In s s_list -> 0 <= v ->
  (forall f, In f (map (map (Z.mul (power (parameters it) * largest (tips (work_tree y (edge_of s))))))
                     (pull_tips it)) ->
     IZR (m * weight it) / IZR (over_weight it) * rdot f x <= U) ->
  IZR m * alpha (Q2R s) * v <= U.
Proof.
  intros Hs V H. destruct weight_is as (O & N & E).
  set (A := work_tree y (edge_of s)) in *. set (top := largest (tips A)) in *.
  pose proof edge_unit as EU. pose proof (pull_unit b) as PU.
  apply IZR_lt in m_positive as MP.
  assert (L : alpha (Q2R s) <= unit (edge_scaling b) * IZR top).
  { rewrite (alpha_is s Hs). fold A. apply Rmult_le_compat_l; [lra|].
    apply eval_most; [exact shares_are|]. intros z Hz. apply IZR_le. now apply largest_above. }
  apply Rle_trans with (IZR m * (unit (edge_scaling b) * IZR top) * v).
  { apply Rmult_le_compat_r; [exact V|]. apply Rmult_le_compat_l; lra. }
  apply (v_bound d h l b r p F mu t I). intros f Hf.
  specialize (H (map (Z.mul (power (parameters it) * top)) f) (in_map _ _ _ Hf)).
  rewrite rdot_scaled, !mult_IZR in H. eapply Rle_trans; [|exact H]. fold x. right.
  replace (IZR m * (unit (edge_scaling b) * IZR top) * unit (pull_scaling b) * rdot f x)
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) * IZR top * rdot f x) by ring.
  rewrite E. unfold Rdiv. ring.
Qed.

Lemma no_parameters : parameters it = O -> ss = [].
Proof.
  intros Z. pose proof (shares_length b r p F mu t I) as L. fold it in L. rewrite Z in L.
  now apply length_zero_iff_nil in L.
Qed.

Lemma one_tip q : parameters it = O -> pulls it = [q] ->
  v = unit (pull_scaling b) * rdot (first_tip q) x.
Proof.
  intros Z Hp.
  assert (A : forall factor, factor * v <= factor * (unit (pull_scaling b) * rdot (first_tip q) x)).
  { intros c. apply (v_by_trees d h l b r p F mu t I). intros e He. apply pull_in in He. fold it in He.
    rewrite Hp in He. destruct He as [<-|[]]. fold ss. rewrite (no_parameters Z), eval_first. fold x. lra. }
  pose proof (A 1). pose proof (A (-1)). lra.
Qed.

(* If there are no corners, and one form v. *)
Lemma single_bound s q factor : In s s_list -> parameters it = O -> pulls it = [q] ->
  (up (m * weight it * dot (first_tip (edge_of s)) y) (over_weight it) <= factor)%Z -> 0 <= v ->
  IZR m * alpha (Q2R s) * v <= IZR factor * rdot (first_tip q) x.
Proof.
  intros Hs Z Hp A V. destruct weight_is as (O & N & E).
  pose proof (pull_unit b) as PU. pose proof edge_unit as EU.
  pose proof (one_tip q Z Hp) as VE.
  assert (R0 : 0 <= rdot (first_tip q) x) by nra.
  rewrite (alpha_is s Hs), (no_parameters Z), VE. unfold work_tree.
  rewrite eval_mmap, eval_first. set (z := dot (first_tip (edge_of s)) y) in *.
  replace (IZR m * (unit (edge_scaling b) * IZR z) * (unit (pull_scaling b) * rdot (first_tip q) x))
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) * IZR z * rdot (first_tip q) x)
    by ring.
  rewrite E, Z. cbn [power]. apply Rmult_le_compat_r; [exact R0|].
  apply IZR_le in A. eapply Rle_trans; [|exact A].
  eapply Rle_trans; [|apply up_above; exact O]. rewrite !mult_IZR. right. unfold Rdiv. ring.
Qed.

(* A force of such a contact: a N + f T. *)
Lemma force_with_sign w a g : Rows.obeys w d h l r (a, g) ->
  exists f, Rows.work r (a, g) yv = a * Rows.dot (Rows.N r) yv + f * Rows.dot T yv /\
    (Rabs f <= mu * a) /\ (0 < Rows.dot T d -> f = - (mu * a)) /\ (Rows.dot T d < 0 -> f = mu * a).
Proof.
  intros (_ & C & D). destruct (is_signed _ _ _ _ _ _ I signed) as (Sl & We & Sq).
  rewrite (is_rho _ _ _ _ _ _ I), Sq, sqrt_1, Rmult_1_r in *. unfold Rows.work, Rows.slip in *.
  rewrite We in *. unfold T, Box.T. cbn [fst snd].
  destruct Sl as [E|(T0 & E)]; rewrite E in *; cbn [map nth] in *.
  - exists 0. cbn. rewrite Rabs_R0. split; [ring|]. unfold Rows.size in C. cbn in C. rewrite sqrt_0 in C.
    repeat split; [lra|lra|lra].
  - exists (nth 0 g 0).
    assert (P : forall z, Rows.product [1] g [z] = nth 0 g 0 * z) by (intros; destruct g; cbn; ring).
    rewrite P in *. split; [reflexivity|].
    assert (One : forall z, Rows.size [1] [z] = Rabs z).
    { intros z. unfold Rows.size; cbn. rewrite <- sqrt_Rsqr_abs. f_equal. unfold Rsqr. ring. }
    rewrite One in D. assert (C' : Rabs (nth 0 g 0) <= mu * a).
    { rewrite <- One. eapply Rle_trans; [|exact C]. right. unfold Rows.size. f_equal. destruct g; cbn; ring. }
    split; [exact C'|]. set (tau := Rows.dot T0 d) in *. split; intros H.
    + rewrite Rabs_right in D by lra. apply Rmult_eq_reg_r with tau; lra.
    + rewrite Rabs_left in D by lra. apply Rmult_eq_reg_r with tau; lra.
Qed.

(* What friction may be, by the sign of slip. *)
Lemma work_at_ends w a g : 0 <= a \/ box_spring b = true -> Rows.obeys w d h l r (a, g) ->
  exists s_of, edges strict rays it = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
  forall U, (forall s, In s s_of -> IZR m * alpha (Q2R s) * a <= U) ->
    IZR m * Rows.work r (a, g) yv <= U.
Proof.
  intros A0 Ob. destruct (force_with_sign w a g Ob) as (f & WE & Cone & Plus & Minus).
  pose proof (in_friction _ _ _ _ _ _ I) as Wf. pose proof (friction_nonneg _ _ _ _ _ _ I) as F0.
  rewrite WE. clear WE.
  set (yN := Rows.dot (Rows.N r) yv) in *. set (yT := Rows.dot T yv) in *.
  assert (NoT : box_spring b = true -> yT = 0).
  { intros H. unfold yT, T, Box.T. rewrite (spring_alone _ _ _ _ _ _ I H). reflexivity. }
  assert (None : exists s_of, edges_none it = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
    forall U, (forall s, In s s_of -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * (a * yN + f * yT) <= U).
  { exists (full_range (box_friction b)). repeat split.
    - cbn [it edges_none make_row]. rewrite signed. reflexivity.
    - intros s H. apply in_or_app. right. apply in_or_app. now right.
    - intros U H. unfold full_range in H. destruct A0 as [A0|Sp].
      2:{ rewrite (NoT Sp) in *.
          destruct (Qeq_bool (high (box_friction b)) 0); specialize (H _ (or_introl eq_refl)); lra. }
      assert (Cone' : Rabs f <= Q2R (high (box_friction b)) * a) by (destruct Wf; nra).
      apply Rabs_within in Cone' as [C1 C2].
      destruct (Qeq_bool (high (box_friction b)) 0) eqn:Z.
      + apply Qeq_bool_eq, Qeq_eqR in Z. rewrite Q2R_0 in Z. rewrite Z in *.
        assert (f = 0) by lra. subst f. specialize (H _ (or_introl eq_refl)).
        rewrite Q2R_0 in H. nra.
      + pose proof (H _ (or_introl eq_refl)) as H1.
        pose proof (H _ (or_intror (or_introl eq_refl))) as H2. rewrite Q2R_opp in H1.
        set (top := Q2R (high (box_friction b))) in *. apply IZR_lt in m_positive as MP.
        set (M := IZR m) in *.
        assert (X : f * yT <= top * a * Rabs yT).
        { apply Rle_trans with (Rabs f * Rabs yT).
          - rewrite <- Rabs_mult. apply Rle_abs.
          - apply Rmult_le_compat_r; [apply Rabs_pos|]. apply Rabs_le. lra. }
        destruct (Rcase_abs yT) as [Ny|Py].
        * rewrite Rabs_left in X by exact Ny. nra.
        * rewrite Rabs_right in X by exact Py. nra. }
  assert (Ends : forall sgn : Q -> Q, (forall q, Q2R (sgn q) = Q2R (sgn 1%Q) * Q2R q) ->
    f = Q2R (sgn 1%Q) * (mu * a) ->
    forall U, (forall s, In s (map sgn (ends (box_friction b))) -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * (a * yN + f * yT) <= U).
  { intros sgn S Hf U H. rewrite Hf.
    replace (IZR m * (a * yN + Q2R (sgn 1%Q) * (mu * a) * yT))
      with (IZR m * a * yN + IZR m * Q2R (sgn 1%Q) * a * yT * mu) by ring.
    apply at_ends with (box_friction b); [exact Wf|]. intros q Hq.
    replace (IZR m * a * yN + IZR m * Q2R (sgn 1%Q) * a * yT * Q2R q)
      with (IZR m * (yN + Q2R (sgn q) * yT) * a) by (rewrite S; ring).
    apply H. now apply in_map. }
  assert (General :
    exists s_of, (if has_sign strict rays (tau it) then edges_plus it
                  else if has_sign strict rays (minus_tau it) then edges_minus it
                  else edges_none it) = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
    forall U, (forall s, In s s_of -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * (a * yN + f * yT) <= U).
  { pose proof (tau_corners b r p F mu t I h l d signed) as TC. fold x in TC.
    pose proof (trees_unit_positive [tau_tree b]) as TU.
    destruct (has_sign strict rays (tau it)) eqn:SP; [|destruct (has_sign strict rays (minus_tau it)) eqn:SM];
      [| |exact None].
    - apply (has_sign_positive strict rays x rays_know strict_at_x ws W spanned _ ss shares_are) in SP.
      exists (minus_ends (box_friction b)). repeat split.
      + cbn [it edges_plus make_row]. rewrite signed. reflexivity.
      + intros s H. apply in_or_app. now left.
      + apply Ends.
        * intros q. rewrite !Q2R_opp, Q2R_1. ring.
        * rewrite Q2R_opp, Q2R_1, Plus; [ring|]. unfold T. rewrite TC. fold it. fold ss. nra.
    - apply (has_sign_positive strict rays x rays_know strict_at_x ws W spanned _ ss shares_are) in SM.
      exists (ends (box_friction b)). repeat split.
      + cbn [it edges_minus make_row]. rewrite signed. reflexivity.
      + intros s H. apply in_or_app. right. apply in_or_app. now left.
      + rewrite <- (map_id (ends (box_friction b))). apply Ends.
        * intros q. rewrite Q2R_1. ring.
        * rewrite Q2R_1, Minus; [ring|]. unfold T. rewrite TC. fold it. fold ss.
          assert (M : minus_tau it = mmap negative (tau it)) by reflexivity.
          rewrite M, eval_mmap, (eval_same _ (fun f => -1 * rdot f x)) in SM
            by (intros; rewrite rdot_negative; ring).
          rewrite eval_multiple in SM. nra. }
  unfold edges. destruct (edges_none it) as [|z1 [|z2 l']] eqn:EN; try exact General.
  rewrite <- EN. destruct None as (s_of & E1 & R1). exists s_of. rewrite EN. split; [exact E1|exact R1].
Qed.

Lemma bent_above s s_of (forms_of : multi form -> list form) mixed g : In s s_of ->
  In g (forms_of (edge_of s)) ->
  IZR (m * weight it) / IZR (over_weight it) * rdot g x <=
  bound (bent m it (flat_map forms_of (map edge_of s_of)) mixed).
Proof.
  intros Hs Hg. destruct weight_is as (O & N & _).
  assert (In g (flat_map forms_of (map edge_of s_of))).
  { apply in_flat_map. exists (edge_of s). split; [now apply in_map|exact Hg]. }
  unfold bent. destruct (flat_map forms_of (map edge_of s_of)) as [|g0 forms]; [contradiction|].
  apply (bend_bound rays x ws W spanned); [lia|exact O|assumption].
Qed.

(* A contact that is closed, or a spring. *)
Lemma closed_bound w g : 0 <= v \/ box_spring b = true -> Rows.obeys w d h l r (v, g) ->
  IZR m * Rows.work r (v, g) yv <= bound (edges_term m y (edges strict rays it) false it).
Proof.
  intros V Ob. destruct (work_at_ends w v g V Ob) as (s_of & ES & SL & Ends).
  apply Ends. intros s Hs. rewrite ES. specialize (SL s Hs).
  assert (G : IZR m * alpha (Q2R s) * v <= bound (bent m it
    (flat_map (fun e => products_with it (work_tree y e)) (map edge_of s_of)) false)).
  { apply products_bound; [exact SL|]. intros f Hf.
    now apply (bent_above s s_of (fun e => products_with it (work_tree y e))). }
  unfold edges_term. destruct (parameters it) eqn:EP; [|exact G].
  destruct (pulls it) as [|q [|q' qs]] eqn:EPl; try exact G.
  destruct (box_spring (box it)) eqn:Sp; [exact G|].
  destruct V as [V|V]; [|change (box it) with b in Sp; congruence].
  rewrite (line_bound x ws spanned). apply single_bound; try assumption.
  apply largest_above. rewrite map_map. apply in_map_iff. now exists s.
Qed.

(* One that is mixed. *)
Lemma mixed_bound w g : Rows.obeys w d h l r (Rmax 0 v, g) ->
  IZR m * Rows.work r (Rmax 0 v, g) yv <= bound (edges_term m y (edges strict rays it) true it).
Proof.
  intros Ob. destruct weight_is as (O & N & _).
  destruct (work_at_ends w (Rmax 0 v) g (or_introl (Rmax_l 0 v)) Ob) as (s_of & ES & SL & Ends).
  assert (B0 : 0 <= bound (edges_term m y (edges strict rays it) true it)).
  { pose proof (nothing_bound ws) as Z0.
    assert (G : forall forms, 0 <= bound (bent m it forms true)).
    { intros [|f forms]; unfold bent; [lra|]. apply (mixed_bound_nonneg rays ws W); [lia|exact O]. }
    unfold edges_term. destruct (parameters it); [|apply G].
    destruct (pulls it) as [|q [|q' qs]]; try apply G. destruct (box_spring (box it)); [apply G|].
    destruct (Z.leb_spec (largest (map (fun e => up (m * weight it * dot (first_tip e) y)
      (over_weight it)) (edges strict rays it))) 0); [lra|].
    apply (mixed_bound_nonneg rays ws W); lia. }
  destruct (Rle_dec v 0) as [V|V].
  { rewrite Rmax_left in * by exact V. apply Ends. intros s _. lra. }
  rewrite Rmax_right in * by lra.
  apply Ends. intros s Hs. rewrite ES in *. specialize (SL s Hs).
  assert (G : 0 <= bound (bent m it (flat_map (fun e => mixed_forms it (work_tree y e)) (map edge_of s_of)) true) ->
    IZR m * alpha (Q2R s) * v <=
    bound (bent m it (flat_map (fun e => mixed_forms it (work_tree y e)) (map edge_of s_of)) true)).
  { intros P.
    assert (In_forms := fun g => bent_above s s_of (fun e => mixed_forms it (work_tree y e)) true g Hs).
    unfold mixed_forms in In_forms at 1.
    destruct (forallb (fun z => z <=? 0)%Z (tips (work_tree y (edge_of s)))) eqn:Neg.
    - eapply Rle_trans; [|exact P]. rewrite (alpha_is s SL).
      assert (L : eval IZR (work_tree y (edge_of s)) ss <= 0).
      { apply eval_most; [exact shares_are|]. intros z Hz. rewrite forallb_forall in Neg.
        apply IZR_le. apply Z.leb_le. auto. }
      pose proof edge_unit. apply IZR_lt in m_positive as MP.
      assert (unit (edge_scaling b) * eval IZR (work_tree y (edge_of s)) ss <= 0) by nra.
      assert (IZR m * (unit (edge_scaling b) * eval IZR (work_tree y (edge_of s)) ss) <= 0) by nra.
      nra.
    - destruct (forallb (fun z => 0 <=? z)%Z (tips (work_tree y (edge_of s)))).
      + apply products_bound; assumption.
      + apply largest_bound; [assumption|lra|assumption]. }
  unfold edges_term in *. destruct (parameters it) eqn:EP; [|exact (G B0)].
  destruct (pulls it) as [|q [|q' qs]] eqn:EPl; try exact (G B0).
  destruct (box_spring (box it)); [exact (G B0)|]. clear G.
  set (factor := largest _) in *.
  assert (A : (up (m * weight it * dot (first_tip (edge_of s)) y) (over_weight it) <= factor)%Z).
  { apply largest_above. rewrite map_map. apply in_map_iff. now exists s. }
  assert (V0 : 0 <= v) by lra. pose proof (single_bound s q factor SL EP EPl A V0) as SB.
  assert (R0 : 0 <= rdot (first_tip q) x).
  { pose proof (one_tip q EP EPl). pose proof (pull_unit b). nra. }
  destruct (Z.leb_spec factor 0) as [L|L].
  - eapply Rle_trans; [exact SB|]. apply IZR_le in L. eapply Rle_trans; [|exact B0]. nra.
  - eapply Rle_trans; [exact SB|].
    replace (IZR factor) with (IZR factor / IZR 1) by (field; lra).
    apply (bend_bound rays x ws W spanned); [lia|lia|now left].
Qed.

End Edges.
