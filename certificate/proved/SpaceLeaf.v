(* SPDX-License-Identifier: MIT *)
(* The leaf of a tree in space (FORMAT.md section 7).  The slips of a contact at the rays of a region
   generate a cone; whether the contact moves, and how much of its friction can work on y, are
   decided by planes that have all of that cone on one side.  `leaf_refutes`: where a leaf holds, no
   equilibrium is at home. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf SpaceBox.
From Proved Require Model SpaceModel.
Import ListNotations.

Module S := SpaceModel.

(* ---- Cones of slips ---- *)

Section Slips.
Open Scope Z_scope.

Definition slip_at (t : list form) (x : form) : form :=
  [dot (nth 1 t []) x; dot (nth 2 t []) x; dot (nth 3 t []) x].

Definition slips (g : multi (list form)) (rays : list ray) : list form :=
  flat_map (fun t => map (fun r => slip_at t (coordinates r)) rays) (tips g).

(* Whether w.s / |s| is less than w.t / |t|. *)
Definition less_along (w s t : form) : bool :=
  dot w s * Z.abs (dot w s) * dot t t <? dot w t * Z.abs (dot w t) * dot s s.

(* The generator that is nearest to w. *)
Definition nearest (w : form) (gens : list form) : option form :=
  fold_left (fun best s =>
    if all_zero s then best
    else match best with
         | None => Some s
         | Some b => if less_along w b s then Some s else best
         end) gens None.

(* |s|^2 times the part of w across s. *)
Definition part_across (w s : form) : form := combine (dot s s) w (- dot w s) s.

Definition nowhere_along (gens : list form) (e : form) : bool :=
  forallb (fun s => dot s e <=? 0) gens.

(* If w is outside of the cone, an e with e.w > 0 and e.s <= 0 for all generators: its
   distance from the cone. *)
Definition separator (gens : list form) (w : form) : option form :=
  let e := match nearest w gens with
           | Some s => if 0 <? dot w s then part_across w s else w
           | None => w
           end in
  if nowhere_along gens e && (0 <? dot w e) then Some e else None.

(* The rays with -s in the cone. `separators` are those that were found. *)
Fixpoint opposed (gens separators : list form) (rays : list (form * ray)) : list ray :=
  match rays with
  | [] => []
  | (s, r) :: rays' =>
      let w := negative s in
      if existsb (fun e => 0 <? dot w e) separators then opposed gens separators rays'
      else match separator gens w with
           | Some e => opposed gens (e :: separators) rays'
           | None => r :: opposed gens separators rays'
           end
  end.

Definition must_move (strict : list (list form)) (g : multi (list form)) (gens : list form)
    (rays : list ray) : bool :=
  forallb (fun t =>
    barred strict (opposed gens [] (map (fun r => (slip_at t (coordinates r), r)) rays))) (tips g).

(* The largest w.s / |s| in the cone, for w = -z: its sign, and its square as a fraction. If w is in the
   cone, |z|. *)
Definition most_along (gens : list form) (z : form) : bool * Z * Z :=
  let w := negative z in
  let whole := (false, dot z z, 1) in
  match nearest w gens with
  | None => whole
  | Some s =>
      let a := dot w s in
      if 0 <=? a then
        if nowhere_along gens (part_across w s) && (0 <? dot s s) then (false, a * a, dot s s)
        else whole
      else if forallb (fun g => (dot w g <=? 0) && (a * a * dot g g <=? dot w g * dot w g * dot s s))
                gens && (0 <? dot s s)
           then (true, a * a, dot s s)
           else whole
  end.

(* ---- Roots ---- *)

Definition root_above (q : Q) : Q :=
  let u := high (root_between 64 (reduced q)) in
  if Qle_bool 0 u && Qle_bool q (u * u) then u else (q + 1)%Q.

Definition root_below (q : Q) : Q :=
  let l := low (root_between 64 (reduced q)) in
  if Qle_bool 0 l && Qle_bool (l * l) q then l else 0%Q.

(* ---- Contacts ---- *)

Definition unit_of (s : scaling) : Q := Qmake (times s) (Z.to_pos (over s)).

(* At a corner; `size` is the factor of y. *)
Definition corner_alpha (row : row) (size : Q) (y : form) (gens : list form) (moves : bool)
    (t : list form) : Q :=
  let z := slip_at t y in
  let '(below, n, d) := if moves then most_along gens z else (false, dot z z, 1) in
  let mu := if below then low (box_friction (box row)) else high (box_friction (box row)) in
  let u := (unit_of (geometry_scale row) * size)%Q in
  let q := (mu * mu * square (box row) * (u * u) * Qmake n (Z.to_pos d))%Q in
  reduced (u * inject_Z (dot (nth 0 t []) y) + (if below then if Qle_bool 0 mu then - root_below q else 0 else root_above q))%Q.

Fixpoint largest_q (qs : list Q) : Q :=
  match qs with
  | [] => 0%Q
  | [q] => q
  | q :: qs' => let m := largest_q qs' in if Qle_bool q m then m else q
  end.

Definition alpha (strict : list (list form)) (rays : list ray) (slipping : bool) (row : row)
    (size : Q) (y : form) : Q :=
  let frictionless := Qeq_bool (high (box_friction (box row))) 0 in
  let gens := if frictionless then [] else slips (geometry row) rays in
  let moves := negb frictionless && (slipping || must_move strict (geometry row) gens rays) in
  largest_q (map (corner_alpha row size y gens moves) (tips (geometry row))).

Definition pull_tips (row : row) : list form := concat (map tips (pulls row)).

Definition term_of (m : Z) (a : Q) (mixed : bool) (row : row) : term :=
  let n := m * Qnum a * times (pull_scale row) in
  let d := Zpos (Qden a) * over (pull_scale row) in
  match pull_tips row with
  | [v] =>
      let c := up n d in
      if mixed then (if c <=? 0 then Nothing else Bend c 1 [v] true) else Line c v
  | vs =>
      if mixed && (Qnum a <=? 0) then Nothing
      else Bend (m * times (pull_scale row)) d (map (map (Z.mul (Qnum a))) vs) mixed
  end.

(* Contacts that press, and whether they may also not: with their alpha. *)
Fixpoint pressing (strict : list (list form)) (rays : list ray) (slipping : list Z) (size : Q)
    (y : form) (rows : list row) (number : Z) : list (row * Q * bool) :=
  match rows with
  | [] => []
  | row :: rows' =>
      let rest := pressing strict rays slipping size y rows' (number + 1) in
      let vs := pull_tips row in
      let it (mixed : bool) :=
        (row, alpha strict rays (existsb (Z.eqb number) slipping) row size y, mixed) in
      if forallb (nowhere_negative rays) vs then it false :: rest
      else if forallb (nowhere_positive rays) vs then rest
      else it true :: rest
  end.

Definition load_term (m : Z) (size : Q) (y : form) (ld : load) : form :=
  let t := m * Qnum size * times (load_scaling ld) in
  let d := Zpos (Qden size) * over (load_scaling ld) in
  [0; 0; 0; 0; 0; 0; up (t * most_work y (lows_of_w ld) (highs_of_w ld)) d;
   up (t * dot (form_of_u ld) y) d].

Definition leaf_holds (rows : list row) (ld : load) (slipping : list Z)
    (strict : list (list form)) (rays : list ray) (y : list Q) : bool :=
  let sc := scaling_of y in
  let size := unit_of sc in
  match map (to_integer sc) y with
  | [y1; y2; y3; y4; y5; y6] =>
      let y := [y1; y2; y3; y4; y5; y6] in
      let them := pressing strict rays slipping size y rows 0 in
      let m := fold_left (fun m it => Z.lcm m (Zpos (Qden (snd (fst it))) *
                                               over (pull_scale (fst (fst it)))))
                 them (Zpos (Qden size) * over (load_scaling ld)) in
      (0 <? m) &&
      let (linear, bends) :=
        collect (fun it => term_of m (snd (fst it)) (snd it) (fst (fst it))) them
          (load_term m size y ld) [] in
      positive_at_home strict rays (fun x =>
        - fold_left (fun s t => s + value t x) bends (dot linear x))
  | _ => false
  end.

End Slips.

(* ---- Proofs: vectors of three numbers ---- *)

Section Three.
Open Scope R_scope.

Definition len3 (a b c : R) := sqrt (a * a + b * b + c * c).

Lemma len3_nonneg a b c : 0 <= len3 a b c.
Proof. apply sqrt_pos. Qed.

Lemma len3_square a b c : len3 a b c * len3 a b c = a * a + b * b + c * c.
Proof. apply sqrt_sqrt. nra. Qed.

Lemma cauchy a b c x y z : a * x + b * y + c * z <= len3 a b c * len3 x y z.
Proof.
  apply Rnot_lt_le. intros H.
  pose proof (len3_nonneg a b c) as A. pose proof (len3_nonneg x y z) as X.
  pose proof (len3_square a b c) as A2. pose proof (len3_square x y z) as X2.
  set (p := len3 a b c) in *. set (q := len3 x y z) in *.
  assert (P0 : 0 <= p * q) by (apply Rmult_le_pos; assumption).
  assert (Sq : (p * q) * (p * q) < (a * x + b * y + c * z) * (a * x + b * y + c * z))
    by (apply Rmult_le_0_lt_compat; assumption).
  assert (E : (p * q) * (p * q) = (a * a + b * b + c * c) * (x * x + y * y + z * z))
    by (rewrite <- A2, <- X2; ring).
  assert (L : (a * a + b * b + c * c) * (x * x + y * y + z * z) -
    (a * x + b * y + c * z) * (a * x + b * y + c * z) =
    (a * y - b * x) * (a * y - b * x) + (a * z - c * x) * (a * z - c * x) +
    (b * z - c * y) * (b * z - c * y)) by ring.
  assert (0 <= (a * y - b * x) * (a * y - b * x)) by apply Rle_0_sqr.
  assert (0 <= (a * z - c * x) * (a * z - c * x)) by apply Rle_0_sqr.
  assert (0 <= (b * z - c * y) * (b * z - c * y)) by apply Rle_0_sqr. lra.
Qed.

Definition three (g : form) := exists a b c, g = [a; b; c].

Lemma nearest_in w gens s : nearest w gens = Some s -> In s gens.
Proof.
  unfold nearest. assert (A : forall l best, (forall b, best = Some b -> In b gens) ->
    (forall g, In g l -> In g gens) ->
    fold_left (fun best s => if all_zero s then best
      else match best with None => Some s
           | Some b => if less_along w b s then Some s else best end) l best = Some s -> In s gens).
  { induction l as [|g l IH]; intros best B G H; cbn in H; [now apply B|].
    eapply IH; [|intros; apply G; now right|exact H].
    intros b Eb. destruct (all_zero g); [now apply B|]. destruct best as [b0|].
    - destruct (less_along w b0 g); [|now apply B]. injection Eb as <-. apply G. now left.
    - injection Eb as <-. apply G. now left. }
  intros H. eapply A; [| |exact H]; [discriminate|auto].
Qed.

(* A cone of slips is known by the vectors e with e.s <= 0 for all its generators s. *)
Definition in_dual (gens : list form) (e1 e2 e3 : R) :=
  forall g, In g gens -> rdot g [e1; e2; e3] <= 0.

Definition in_cone (gens : list form) (s1 s2 s3 : R) :=
  forall e1 e2 e3, in_dual gens e1 e2 e3 -> e1 * s1 + e2 * s2 + e3 * s3 <= 0.

Lemma nowhere_along_dual gens e1 e2 e3 : nowhere_along gens [e1; e2; e3] = true ->
  in_dual gens (IZR e1) (IZR e2) (IZR e3).
Proof.
  unfold nowhere_along. rewrite forallb_forall. intros H g Hg. specialize (H g Hg).
  apply Z.leb_le, IZR_le in H. rewrite <- rdot_integers in H. exact H.
Qed.

Lemma sqrt_of_square a d : 0 <= a -> 0 < d -> sqrt (a * a / d) = a / sqrt d.
Proof.
  intros A D. unfold Rdiv. rewrite sqrt_mult_alt by nra. rewrite sqrt_square by exact A.
  f_equal. now apply sqrt_inv.
Qed.

Theorem most_along_bound gens z1 z2 z3 s1 s2 s3 : (forall g, In g gens -> three g) ->
  in_cone gens s1 s2 s3 ->
  let '(below, n, d) := most_along gens [z1; z2; z3] in
  (0 <= n)%Z /\ (0 < d)%Z /\
  - IZR z1 * s1 + - IZR z2 * s2 + - IZR z3 * s3
  <= (if below then -1 else 1) * sqrt (IZR n / IZR d) * len3 s1 s2 s3.
Proof.
  intros T C. set (w := [(- z1)%Z; (- z2)%Z; (- z3)%Z]).
  assert (Whole : (0 <= dot [z1; z2; z3] [z1; z2; z3])%Z /\ (0 < 1)%Z /\
    - IZR z1 * s1 + - IZR z2 * s2 + - IZR z3 * s3
    <= 1 * sqrt (IZR (dot [z1; z2; z3] [z1; z2; z3]) / IZR 1) * len3 s1 s2 s3).
  { split; [cbn; nia|]. split; [lia|]. rewrite Rmult_1_l.
    replace (IZR (dot [z1; z2; z3] [z1; z2; z3]) / IZR 1)
      with (- IZR z1 * - IZR z1 + - IZR z2 * - IZR z2 + - IZR z3 * - IZR z3).
    - apply cauchy.
    - cbn [dot]. rewrite !plus_IZR, !mult_IZR. field. }
  unfold most_along. change (negative [z1; z2; z3]) with w.
  destruct (nearest w gens) as [s|] eqn:Near; [|exact Whole].
  apply nearest_in in Near. destruct (T s Near) as (t1 & t2 & t3 & ->).
  set (a := dot w [t1; t2; t3]). set (ss := dot [t1; t2; t3] [t1; t2; t3]).
  assert (SS : IZR ss = IZR t1 * IZR t1 + IZR t2 * IZR t2 + IZR t3 * IZR t3)
    by (unfold ss; cbn [dot]; rewrite !plus_IZR, !mult_IZR; ring).
  assert (AA : IZR a = - IZR z1 * IZR t1 + - IZR z2 * IZR t2 + - IZR z3 * IZR t3)
    by (unfold a, w; cbn [dot]; rewrite !plus_IZR, !mult_IZR, !opp_IZR; ring).
  destruct (Z.leb_spec 0 a) as [A0|A0].
  - destruct (nowhere_along gens (part_across w [t1; t2; t3]) && (0 <? ss)%Z) eqn:H; [|exact Whole].
    apply andb_true_iff in H as [H P]. apply Z.ltb_lt in P. split; [nia|]. split; [exact P|].
    assert (E : part_across w [t1; t2; t3] =
      [(ss * - z1 + - a * t1)%Z; (ss * - z2 + - a * t2)%Z; (ss * - z3 + - a * t3)%Z]) by reflexivity.
    rewrite E in H. apply nowhere_along_dual in H. specialize (C _ _ _ H).
    rewrite !plus_IZR, !mult_IZR, !opp_IZR in C.
    apply IZR_lt in P. apply IZR_le in A0. rewrite Rmult_1_l, mult_IZR, sqrt_of_square by lra.
    pose proof (sqrt_lt_R0 _ P) as R0. pose proof (sqrt_sqrt (IZR ss) ltac:(lra)) as R2.
    pose proof (cauchy (IZR t1) (IZR t2) (IZR t3) s1 s2 s3) as Cy.
    assert (LT : len3 (IZR t1) (IZR t2) (IZR t3) = sqrt (IZR ss)) by (unfold len3; now rewrite SS).
    rewrite LT in Cy. set (root := sqrt (IZR ss)) in *. set (L := len3 s1 s2 s3) in *.
    apply Rmult_le_reg_l with (IZR ss); [exact P|].
    replace (IZR ss * (IZR a / root * L)) with (IZR a * (root * L))
      by (rewrite <- R2 at 1; field; lra).
    apply Rle_trans with (IZR a * (IZR t1 * s1 + IZR t2 * s2 + IZR t3 * s3)); [lra|].
    apply Rmult_le_compat_l; lra.
  - destruct (forallb _ gens && (0 <? ss)%Z) eqn:H; [|exact Whole].
    apply andb_true_iff in H as [H P]. apply Z.ltb_lt in P. split; [nia|]. split; [exact P|].
    rewrite forallb_forall in H. apply IZR_lt in P, A0.
    replace (IZR (a * a)) with (- IZR a * - IZR a) by (rewrite mult_IZR; ring).
    rewrite sqrt_of_square by lra.
    pose proof (sqrt_lt_R0 _ P) as R0. pose proof (sqrt_sqrt (IZR ss) ltac:(lra)) as R2.
    set (root := sqrt (IZR ss)) in *.
    pose proof (len3_nonneg s1 s2 s3) as L0. pose proof (len3_square s1 s2 s3) as L2.
    set (L := len3 s1 s2 s3) in *. set (M := IZR a / root).
    assert (M0 : M < 0).
    { unfold M. assert (0 < - IZR a / root) by (apply Rdiv_lt_0_compat; lra).
      unfold Rdiv in *. lra. }
    assert (MR : M * root = IZR a) by (unfold M; field; lra).
    replace (-1 * (- IZR a / root) * L) with (M * L) by (unfold M; field; lra).
    destruct (Req_dec L 0) as [LZ|LZ].
    + rewrite LZ in *. assert (s1 = 0) by nra. assert (s2 = 0) by nra. assert (s3 = 0) by nra.
      subst s1 s2 s3. lra.
    + assert (D : in_dual gens (- IZR z1 - M * (s1 / L)) (- IZR z2 - M * (s2 / L))
                    (- IZR z3 - M * (s3 / L))).
      { intros g Hg. specialize (H g Hg). destruct (T g Hg) as (g1 & g2 & g3 & ->).
        apply andb_true_iff in H as [H1 H2]. apply Z.leb_le, IZR_le in H1.
        apply Z.leb_le, IZR_le in H2. rewrite !mult_IZR in H2.
        set (gg := dot [g1; g2; g3] [g1; g2; g3]) in *. set (wg := dot w [g1; g2; g3]) in *.
        assert (GG : IZR gg = IZR g1 * IZR g1 + IZR g2 * IZR g2 + IZR g3 * IZR g3)
          by (unfold gg; cbn [dot]; rewrite !plus_IZR, !mult_IZR; ring).
        assert (WG : IZR wg = - IZR z1 * IZR g1 + - IZR z2 * IZR g2 + - IZR z3 * IZR g3)
          by (unfold wg, w; cbn [dot]; rewrite !plus_IZR, !mult_IZR, !opp_IZR; ring).
        pose proof (len3_nonneg (IZR g1) (IZR g2) (IZR g3)) as G0.
        pose proof (len3_square (IZR g1) (IZR g2) (IZR g3)) as G2.
        pose proof (cauchy (IZR g1) (IZR g2) (IZR g3) s1 s2 s3) as Cy. fold L in Cy.
        set (G := len3 (IZR g1) (IZR g2) (IZR g3)) in *. rewrite <- GG in G2.
        (* w.g <= M |g| *)
        assert (B : IZR wg <= M * G).
        { apply Rnot_lt_le. intros Lt.
          assert (X : IZR a * G < IZR wg * root).
          { replace (IZR a * G) with (M * G * root) by (rewrite <- MR; ring).
            apply Rmult_lt_compat_r; assumption. }
          assert (Y : (- (IZR wg * root)) * (- (IZR wg * root)) < (- (IZR a * G)) * (- (IZR a * G))).
          { apply Rmult_le_0_lt_compat; try lra; nra. }
          assert (Z : IZR a * IZR a * IZR gg <= IZR wg * IZR wg * IZR ss) by lra.
          rewrite <- G2, <- R2 in Z. lra. }
        cbn [rdot].
        assert (F : IZR g1 * (- IZR z1 - M * (s1 / L)) +
          (IZR g2 * (- IZR z2 - M * (s2 / L)) + (IZR g3 * (- IZR z3 - M * (s3 / L)) + 0))
          = IZR wg - M * ((IZR g1 * s1 + IZR g2 * s2 + IZR g3 * s3) / L))
          by (rewrite WG; field; exact LZ).
        rewrite F.
        assert (U : (IZR g1 * s1 + IZR g2 * s2 + IZR g3 * s3) / L <= G).
        { apply Rmult_le_reg_r with L; [lra|]. unfold Rdiv.
          rewrite Rmult_assoc, Rinv_l by exact LZ. lra. }
        nra. }
      specialize (C _ _ _ D).
      assert (F : (- IZR z1 - M * (s1 / L)) * s1 + (- IZR z2 - M * (s2 / L)) * s2 +
        (- IZR z3 - M * (s3 / L)) * s3 =
        - IZR z1 * s1 + - IZR z2 * s2 + - IZR z3 * s3 - M * ((s1 * s1 + s2 * s2 + s3 * s3) / L))
        by (field; exact LZ).
      rewrite F, <- L2 in C. replace (L * L / L) with L in C by (field; exact LZ). lra.
Qed.

Lemma root_above_is q : 0 <= Q2R q -> sqrt (Q2R q) <= Q2R (root_above q).
Proof.
  intros P. unfold root_above. set (u := high _). destruct (_ && _) eqn:H.
  - apply andb_true_iff in H as [U H]. apply Qle_bool_R in U, H. rewrite Q2R_0, Q2R_mult in *.
    rewrite <- (sqrt_square (Q2R u)) by exact U. now apply sqrt_le_1_alt.
  - rewrite Q2R_plus, Q2R_1.
    rewrite <- (sqrt_square (Q2R q + 1)) by lra. apply sqrt_le_1_alt. nra.
Qed.

Lemma root_below_is q : 0 <= Q2R q -> Q2R (root_below q) <= sqrt (Q2R q).
Proof.
  intros P. unfold root_below. set (l := low _). destruct (_ && _) eqn:H.
  - apply andb_true_iff in H as [U H]. apply Qle_bool_R in U, H. rewrite Q2R_0, Q2R_mult in *.
    rewrite <- (sqrt_square (Q2R l)) by exact U. now apply sqrt_le_1_alt.
  - rewrite Q2R_0. apply sqrt_pos.
Qed.

(* The corner that a choice in the box is not far from: a sum over corners that is 0, of terms that are not
   positive, has the term 0 there. *)
Lemma heavy_tip {A} (t : multi A) ss : Forall is_share ss ->
  exists c, In c (tips t) /\
    forall f, (forall a, In a (tips t) -> f a <= 0) -> eval f t ss = 0 -> f c = 0.
Proof.
  revert ss. induction t as [a|l IHl h IHh]; intros ss S.
  - exists a. split; [now left|]. intros f _ E. exact E.
  - destruct S as [|s ss Hs S].
    + destruct (IHl [] (Forall_nil _)) as (c & Hc & H). exists c. split; [cbn; apply in_or_app; auto|].
      intros f N E. apply H; [|exact E]. intros; apply N; cbn; apply in_or_app; auto.
    + destruct Hs as [S0 S1]. destruct (Rlt_dec s 1) as [L|L].
      * destruct (IHl ss S) as (c & Hc & H). exists c. split; [cbn; apply in_or_app; auto|].
        intros f N E. cbn in E.
        assert (Nl : eval f l ss <= 0) by (apply eval_most; [exact S|]; intros; apply N; cbn; apply in_or_app; auto).
        assert (Nh : eval f h ss <= 0) by (apply eval_most; [exact S|]; intros; apply N; cbn; apply in_or_app; auto).
        apply H; [intros; apply N; cbn; apply in_or_app; auto|]. nra.
      * assert (s = 1) by lra. subst s.
        destruct (IHh ss S) as (c & Hc & H). exists c. split; [cbn; apply in_or_app; auto|].
        intros f N E. cbn in E. apply H; [intros; apply N; cbn; apply in_or_app; auto|]. lra.
Qed.

End Three.

(* ---- A contact's force does at most alpha max(0, v) of work ---- *)

Section Leaf.
Open Scope R_scope.

Lemma eval_sum {A} (f g : A -> R) t ss :
  eval (fun a => f a + g a) t ss = eval f t ss + eval g t ss.
Proof.
  revert ss. induction t as [a|l IHl h IHh]; intros ss; cbn; [reflexivity|].
  destruct ss; rewrite ?IHl, ?IHh; ring.
Qed.

(* y.w of lists *)
Fixpoint works (y : form) (w : list R) : R :=
  match y, w with c :: y', t :: w' => IZR c * t + works y' w' | _, _ => 0 end.

Lemma most_work_bound sc y box w : 0 < unit sc ->
  (forall i, In i box -> Q2R (low i) = unit sc * IZR (to_integer sc (low i)) /\
                         Q2R (high i) = unit sc * IZR (to_integer sc (high i))) ->
  Forall2 within box w ->
  works y w <= unit sc * IZR (most_work y (map (to_integer sc) (map low box))
                                (map (to_integer sc) (map high box))).
Proof.
  intros U H F. revert y. induction F as [|i t box w [L1 L2] F IH]; intros y.
  - destruct y; cbn; lra.
  - destruct y as [|c y]; [cbn; lra|]. cbn [works map most_work].
    assert (IH' := IH ltac:(intros; apply H; now right) y).
    destruct (H i (or_introl eq_refl)) as [E1 E2]. rewrite E1 in L1. rewrite E2 in L2.
    rewrite plus_IZR, Rmult_plus_distr_l. apply Rplus_le_compat; [|exact IH']. rewrite mult_IZR.
    destruct (Z.ltb_spec 0 c) as [P|P].
    + apply IZR_lt in P. nra.
    + apply IZR_le in P. nra.
Qed.

Lemma works_growth sc y us : (forall q, In q us -> Q2R q = unit sc * IZR (to_integer sc q)) ->
  works y (map Q2R us) = unit sc * IZR (dot (map (to_integer sc) us) y).
Proof.
  revert y. induction us as [|q us IH]; intros y H; destruct y as [|c y]; cbn; try ring.
  rewrite IH by (intros; apply H; now right). rewrite (H q) by now left.
  rewrite plus_IZR, mult_IZR. ring.
Qed.

Variable strict : list (list form).
Variable rays : list ray.
Variable d : S.screw.
Variable lambda : R.
Let x := located d 1 lambda.
Hypothesis rays_know : Forall (knows strict) rays.
Hypothesis strict_at_x : Forall (Exists (fun f => rdot f x <> 0)) strict.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.

Variables y1 y2 y3 y4 y5 y6 : Z.
Let y := [y1; y2; y3; y4; y5; y6].
Let yv := S.Screw (S.Vector (IZR y1) (IZR y2) (IZR y3)) (S.Vector (IZR y4) (IZR y5) (IZR y6)).
Variable size : Q.
Hypothesis size_positive : 0 < Q2R size.

Section Contact.

Variable b : cbox.
Variable c : S.contact.
Hypothesis I : inside b c.
Let r := make_row b.
Let ss := shares_in b c.
Let u := unit (scaling_of_geometry b).

Let gens := slips (geometry r) rays.

Lemma u_positive : 0 < u.
Proof. apply unit_positive. Qed.

Lemma rdot_y f : rdot f (located yv 0 0) = IZR (dot f y).
Proof.
  rewrite <- rdot_integers. unfold located, y, yv. cbn [map S.x S.y S.z S.linear S.angular].
  destruct f as [|? [|? [|? [|? [|? [|? [|? [|? [|? [|? ?]]]]]]]]]]; cbn; ring.
Qed.

(* e.s at a corner, of the point. *)
Definition along (e1 e2 e3 : R) (x : list R) (t : list form) : R :=
  e1 * rdot (nth 1 t []) x + e2 * rdot (nth 2 t []) x + e3 * rdot (nth 3 t []) x.

Lemma slip_along e1 e2 e3 m h l :
  e1 * S.x (S.slip c m) + e2 * S.y (S.slip c m) + e3 * S.z (S.slip c m) =
  u * eval (along e1 e2 e3 (located m h l)) (geometry r) ss.
Proof.
  pose proof (slip_corners b c I 0 m h l ltac:(lia)) as X.
  pose proof (slip_corners b c I 1 m h l ltac:(lia)) as Y.
  pose proof (slip_corners b c I 2 m h l ltac:(lia)) as Z.
  cbn [component] in X, Y, Z. rewrite X, Y, Z. unfold along.
  rewrite (eval_sum (fun t => e1 * rdot (nth 1 t []) (located m h l) +
                              e2 * rdot (nth 2 t []) (located m h l))), eval_sum.
  rewrite !eval_multiple. fold r ss u.
  match goal with |- e1 * (u * ?A) + e2 * (u * ?B) + e3 * (u * ?C) = _ =>
    transitivity (u * (e1 * A + e2 * B + e3 * C)); [ring|reflexivity] end.
Qed.

(* A sum over the rays of the point. *)
Fixpoint sum_over (G : form -> R) (ws : list (R * form)) : R :=
  match ws with [] => 0 | (w, p) :: ws' => w * G p + sum_over G ws' end.

Lemma along_rays e1 e2 e3 t :
  along e1 e2 e3 x t = sum_over (fun p => rdot (slip_at t p) [e1; e2; e3]) ws.
Proof.
  unfold along. rewrite !spanned. clear. induction ws as [|[w p] ws' IH]; cbn; [ring|].
  cbn in IH. rewrite <- IH. unfold slip_at. ring.
Qed.

Lemma sums_nonpos G l : weights (map coordinates rays) l ->
  (forall p, In p (map coordinates rays) -> G p <= 0) -> sum_over G l <= 0.
Proof.
  intros Wl H. induction Wl as [|[w p] l [Hw Hp] Wl IH]; cbn; [lra|]. cbn in Hw, Hp.
  specialize (H _ Hp). assert (0 <= w * - G p) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma sum_over_nonpos G : (forall p, In p (map coordinates rays) -> G p <= 0) ->
  sum_over G ws <= 0.
Proof. now apply sums_nonpos. Qed.

Lemma sum_over_zero G : (forall p, In p (map coordinates rays) -> G p <= 0) ->
  sum_over G ws = 0 -> Forall (fun wp => fst wp = 0 \/ G (snd wp) = 0) ws.
Proof.
  intros H. clear spanned. revert W. generalize ws as l. intros l Wl.
  induction Wl as [|[w p] l [Hw Hp] Wl IH]; cbn; [constructor|]. intros E. cbn in Hw, Hp.
  pose proof (sums_nonpos G l Wl H) as N. pose proof (H _ Hp) as N'.
  assert (0 <= w * - G p) by (apply Rmult_le_pos; lra).
  constructor; [|apply IH; lra]. cbn.
  assert (Z : w * G p = 0) by lra. now apply Rmult_integral in Z.
Qed.

Lemma ray_slip t p : In t (tips (geometry r)) -> In p (map coordinates rays) ->
  In (slip_at t p) gens.
Proof.
  intros Ht Hp. apply in_map_iff in Hp as (q & <- & Hq). unfold gens, slips.
  apply in_flat_map. exists t. split; [exact Ht|]. apply in_map_iff. now exists q.
Qed.

Lemma gens_three g : In g gens -> three g.
Proof.
  unfold gens, slips. intros H. apply in_flat_map in H as (t & _ & H).
  apply in_map_iff in H as (q & <- & _). unfold slip_at, three. eauto.
Qed.

Lemma slip_in_cone : in_cone gens (S.x (S.slip c d)) (S.y (S.slip c d)) (S.z (S.slip c d)).
Proof.
  intros e1 e2 e3 D. rewrite (slip_along e1 e2 e3 d 1 lambda). fold x.
  assert (eval (along e1 e2 e3 x) (geometry r) ss <= 0).
  { apply eval_most; [apply (shares_valid b c I)|]. intros t Ht. rewrite along_rays.
    apply (sum_over_nonpos (fun p => rdot (slip_at _ p) [e1; e2; e3])). intros p Hp. apply D. now apply ray_slip. }
  pose proof u_positive. nra.
Qed.

Definition separates_cone (gens : list form) (e : form) := three e /\ nowhere_along gens e = true.

Lemma separator_is gs w e : (forall g, In g gs -> three g) -> three w ->
  separator gs w = Some e -> separates_cone gs e /\ (0 < dot w e)%Z.
Proof.
  intros T Tw H. unfold separator in H.
  set (e0 := match nearest w gs with Some s => if (0 <? dot w s)%Z then part_across w s else w
             | None => w end) in *.
  assert (T0 : three e0).
  { subst e0. destruct (nearest w gs) as [s|] eqn:N; [|exact Tw].
    destruct (0 <? dot w s)%Z; [|exact Tw]. apply nearest_in in N.
    destruct (T s N) as (s1 & s2 & s3 & ->). destruct Tw as (w1 & w2 & w3 & ->).
    unfold part_across, three. cbn [combine]. eauto. }
  destruct (nowhere_along gs e0 && (0 <? dot w e0)%Z) eqn:C; [|discriminate].
  injection H as <-. apply andb_true_iff in C as [C1 C2]. apply Z.ltb_lt in C2.
  repeat split; assumption.
Qed.

Lemma opposed_is gs seps rs : (forall g, In g gs -> three g) ->
  (forall s q, In (s, q) rs -> three s) -> Forall (separates_cone gs) seps ->
  (forall q, In q (opposed gs seps rs) -> exists s, In (s, q) rs) /\
  forall s q, In (s, q) rs -> In q (opposed gs seps rs) \/
    exists e, separates_cone gs e /\ (0 < dot (negative s) e)%Z.
Proof.
  intros T. revert seps. induction rs as [|[s q] rs IH]; intros seps Ts V; [split; [intros ? []|intros ? ? []]|].
  assert (Ts' : forall s q, In (s, q) rs -> three s) by (intros; eapply Ts; right; eassumption).
  cbn [opposed].
  destruct (existsb (fun e => (0 <? dot (negative s) e)%Z) seps) eqn:Ex.
  - destruct (IH seps Ts' V) as [A B]. split.
    + intros q' Hq. destruct (A q' Hq) as (s' & H). exists s'. now right.
    + intros s' q' [E|H]; [|exact (B s' q' H)]. injection E as <- <-. right.
      apply existsb_exists in Ex as (e & He & P). rewrite Forall_forall in V.
      exists e. split; [auto|now apply Z.ltb_lt].
  - destruct (separator gs (negative s)) as [e|] eqn:Sep.
    + assert (Tw : three (negative s)).
      { destruct (Ts s q (or_introl eq_refl)) as (a & b' & c' & ->). unfold three; cbn. eauto. }
      destruct (separator_is _ _ _ T Tw Sep) as [V1 P].
      destruct (IH (e :: seps) Ts' (Forall_cons _ V1 V)) as [A B]. split.
      * intros q' Hq. destruct (A q' Hq) as (s' & H). exists s'. now right.
      * intros s' q' [E|H]; [|exact (B s' q' H)]. injection E as <- <-. right. now exists e.
    + destruct (IH seps Ts' V) as [A B]. split.
      * intros q' [<-|Hq]; [exists s; now left|]. destruct (A q' Hq) as (s' & H). exists s'. now right.
      * intros s' q' [E|H]; [injection E as <- <-; left; now left|].
        destruct (B s' q' H); [left; now right|now right].
Qed.

Lemma must_move_moves : must_move strict (geometry r) gens rays = true -> S.slip c d <> S.zero.
Proof.
  intros M Zero. unfold must_move in M. rewrite forallb_forall in M.
  destruct (heavy_tip (geometry r) ss (shares_valid b c I)) as (t & Ht & Heavy).
  specialize (M t Ht).
  set (rs := map (fun q => (slip_at t (coordinates q), q)) rays) in *.
  destruct (opposed_is gens [] rs gens_three) as [Sub Out].
  { intros s q H. unfold rs in H. apply in_map_iff in H as (q' & E & _). injection E as <- _.
    unfold three, slip_at. eauto. }
  { constructor. }
  refine (not_barred strict rays x rays_know strict_at_x ws spanned (opposed gens [] rs) _ M _).
  - intros q Hq. destruct (Sub q Hq) as (s & H). unfold rs in H.
    apply in_map_iff in H as (q' & E & H). injection E as _ <-. exact H.
  - assert (Z0 : forall e1 e2 e3, in_dual gens e1 e2 e3 ->
      Forall (fun wp => fst wp = 0 \/ rdot (slip_at t (snd wp)) [e1; e2; e3] = 0) ws).
    { intros e1 e2 e3 D. apply (sum_over_zero (fun p => rdot (slip_at t p) [e1; e2; e3])).
      - intros p Hp. apply D. now apply ray_slip.
      - rewrite <- along_rays. apply Heavy.
        + intros t' Ht'. rewrite along_rays. apply (sum_over_nonpos (fun p => rdot (slip_at _ p) [e1; e2; e3])). intros p Hp. apply D.
          now apply ray_slip.
        + pose proof (slip_along e1 e2 e3 d 1 lambda) as E. rewrite Zero in E.
          unfold S.zero in E. cbn [S.x S.y S.z] in E. fold x in E. pose proof u_positive.
          apply Rmult_eq_reg_l with u; [|lra]. rewrite <- E. ring. }
    apply Forall_forall. intros [w p] Hwp. cbn.
    pose proof W as W0. unfold weights in W0. rewrite Forall_forall in W0. destruct (W0 _ Hwp) as [_ Hp].
    cbn in Hp. apply in_map_iff in Hp as (q & <- & Hq).
    destruct (Out (slip_at t (coordinates q)) q) as [H|(e & SC & P)].
    { unfold rs. apply in_map_iff. now exists q. }
    + right. now exists q.
    + left. destruct SC as [T V]. destruct T as (e1 & e2 & e3 & ->).
      pose proof (Z0 _ _ _ (nowhere_along_dual _ _ _ _ V)) as F. rewrite Forall_forall in F.
      destruct (F _ Hwp) as [E|E]; [exact E|]. exfalso. cbn [snd] in E.
      change [IZR e1; IZR e2; IZR e3] with (map IZR [e1; e2; e3]) in E.
      rewrite rdot_integers in E. apply eq_IZR in E.
      unfold slip_at in P, E. cbn [negative map dot] in P. cbn [dot] in E. lia.
Qed.

Lemma unit_of_is sc : (0 < over sc)%Z -> Q2R (unit_of sc) = unit sc.
Proof. intros O. unfold unit_of, Q2R, unit; cbn. rewrite Z2Pos.id by exact O. reflexivity. Qed.

(* What friction can do on y, at a corner: u size f.z, with |f| <= mu L a, and if the contact moves
   f = -(mu L a / |s|) s. *)
Lemma corner_bound (moves : bool) a f1 f2 f3 t : 0 <= a ->
  let F := S.friction c * S.length c * a in
  let s := S.slip c d in
  len3 f1 f2 f3 <= F ->
  (moves = true -> exists k, 0 <= k /\ k * len3 (S.x s) (S.y s) (S.z s) = F /\
     f1 = - k * S.x s /\ f2 = - k * S.y s /\ f3 = - k * S.z s) ->
  let z := slip_at t y in
  a * (u * Q2R size * IZR (dot (nth 0 t []) y)) +
  u * Q2R size * (f1 * IZR (nth 0 z 0%Z) + f2 * IZR (nth 1 z 0%Z) + f3 * IZR (nth 2 z 0%Z))
  <= a * Q2R (corner_alpha r size y gens moves t).
Proof.
  intros A0 F s Hf Hm z. unfold corner_alpha. fold z.
  assert (Tz : three z) by (unfold z, slip_at, three; eauto). clearbody z.
  destruct Tz as (z1 & z2 & z3 & ->). cbn [nth]. cbv zeta. set (z := [z1; z2; z3]).
  set (res := if moves then most_along gens z else (false, dot z z, 1%Z)).
  destruct res as [[below n] den] eqn:Res.
  pose proof u_positive as UP. pose proof (length_positive _ _ I) as LP.
  pose proof (length_square _ _ I) as LS. pose proof (friction_nonneg _ _ I) as M0.
  pose proof (in_friction _ _ I) as [Wl Wh].
  (* the work of friction, by its sign *)
  assert (B : (0 <= n)%Z /\ (0 < den)%Z /\
    f1 * IZR z1 + f2 * IZR z2 + f3 * IZR z3 <= (if below then -1 else 1) * sqrt (IZR n / IZR den) * F).
  { destruct moves.
    - destruct (Hm eq_refl) as (k & K0 & KF & -> & -> & ->).
      pose proof (most_along_bound gens z1 z2 z3 _ _ _ gens_three slip_in_cone) as Mo.
      unfold res, z in Res. rewrite Res in Mo. destruct Mo as (N0 & D0 & Mo).
      fold s in Mo. split; [exact N0|]. split; [exact D0|]. rewrite <- KF.
      apply (Rmult_le_compat_l k) in Mo; [|exact K0].
      replace (- k * S.x s * IZR z1 + - k * S.y s * IZR z2 + - k * S.z s * IZR z3)
        with (k * (- IZR z1 * S.x s + - IZR z2 * S.y s + - IZR z3 * S.z s)) by ring. lra.
    - unfold res in Res. injection Res as <- <- <-. split; [unfold z; cbn; nia|]. split; [lia|].
      eapply Rle_trans; [apply cauchy|].
      assert (E : sqrt (IZR (dot z z) / IZR 1) = len3 (IZR z1) (IZR z2) (IZR z3)).
      { unfold len3. f_equal. unfold z. cbn [dot]. rewrite !plus_IZR, !mult_IZR. field. }
      apply Rle_trans with (1 * sqrt (IZR (dot z z) / IZR 1) * F); [|apply Rle_refl].
      rewrite E, Rmult_1_l, Rmult_comm. apply Rmult_le_compat_l; [apply len3_nonneg|exact Hf]. }
  destruct B as (N0 & D0 & B).
  set (U := u * Q2R size). assert (UP' : 0 < U) by (apply Rmult_lt_0_compat; assumption).
  set (mu := if below then low (box_friction (box r)) else high (box_friction (box r))).
  set (uq := (unit_of (geometry_scale r) * size)%Q).
  assert (UQ : Q2R uq = U).
  { unfold uq. rewrite Q2R_mult, unit_of_is; [reflexivity|]. apply common_denominator_positive. }
  set (q := (mu * mu * square (box r) * (uq * uq) * (n # Z.to_pos den))%Q).
  apply IZR_le in N0 as N0'. apply IZR_lt in D0 as D0'.
  assert (FR : Q2R (n # Z.to_pos den) = IZR n / IZR den).
  { unfold Q2R; cbn. now rewrite Z2Pos.id. }
  assert (QE : Q2R q = (Q2R mu * S.length c * U) * (Q2R mu * S.length c * U) * (IZR n / IZR den)).
  { unfold q. rewrite !Q2R_mult, UQ, FR. change (box r) with b. rewrite <- LS. ring. }
  assert (FN : 0 <= IZR n / IZR den).
  { apply Rmult_le_pos; [exact N0'|]. left. now apply Rinv_0_lt_compat. }
  set (root := sqrt (IZR n / IZR den)) in *. assert (R0 : 0 <= root) by apply sqrt_pos.
  rewrite reduced_same, Q2R_plus, Q2R_mult, UQ.
  replace (Q2R (inject_Z (dot (nth 0 t []) y))) with (IZR (dot (nth 0 t []) y))
    by (unfold Q2R; cbn; field).
  set (Ny := IZR (dot (nth 0 t []) y)).
  rewrite (Rmult_plus_distr_l a). apply Rplus_le_compat_l.
  apply Rle_trans with (U * ((if below then -1 else 1) * root * F)).
  { apply Rmult_le_compat_l; lra. }
  change (low (box_friction (box r))) with (low (box_friction b)) in mu.
  change (high (box_friction (box r))) with (high (box_friction b)) in mu.
  destruct below.
  - destruct (Qle_bool 0 mu) eqn:MP.
    + apply Qle_bool_R in MP. rewrite Q2R_0 in MP. rewrite Q2R_opp.
      assert (SQ : sqrt (Q2R q) = Q2R mu * S.length c * U * root).
      { rewrite QE, sqrt_mult_alt by apply Rle_0_sqr. rewrite sqrt_square; [reflexivity|].
        apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]. }
      pose proof (root_below_is q) as RB. rewrite SQ in RB.
      assert (QP : 0 <= Q2R q) by (rewrite QE; apply Rmult_le_pos; [apply Rle_0_sqr|exact FN]).
      specialize (RB QP). unfold F.
      assert (G : Q2R mu * S.length c * U * root <= S.friction c * S.length c * U * root).
      { repeat apply Rmult_le_compat_r; try lra. exact Wl. }
      assert (a * Q2R (root_below q) <= a * (S.friction c * S.length c * U * root))
        by (apply Rmult_le_compat_l; lra). lra.
    + rewrite Q2R_0, Rmult_0_r. unfold F.
      assert (0 <= U * (root * (S.friction c * S.length c * a))).
      { apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; [exact R0|].
        apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact A0]. }
      lra.
  - assert (MP : 0 <= Q2R mu) by (unfold mu; lra).
    assert (SQ : sqrt (Q2R q) = Q2R mu * S.length c * U * root).
    { rewrite QE, sqrt_mult_alt by apply Rle_0_sqr. rewrite sqrt_square; [reflexivity|].
      apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra]. }
    pose proof (root_above_is q) as RA. rewrite SQ in RA.
    assert (QP : 0 <= Q2R q) by (rewrite QE; apply Rmult_le_pos; [apply Rle_0_sqr|exact FN]).
    specialize (RA QP). unfold F.
    assert (G : S.friction c * S.length c * U * root <= Q2R mu * S.length c * U * root).
    { repeat apply Rmult_le_compat_r; try lra. exact Wh. }
    assert (a * (S.friction c * S.length c * U * root) <= a * Q2R (root_above q))
      by (apply Rmult_le_compat_l; lra). lra.
Qed.

Lemma largest_q_above qs q : In q qs -> Q2R q <= Q2R (largest_q qs).
Proof.
  induction qs as [|q0 qs IH]; [intros []|]. intros H.
  assert (E : largest_q (q0 :: qs) = match qs with [] => q0 | _ =>
    let m := largest_q qs in if Qle_bool q0 m then m else q0 end) by now destruct qs.
  rewrite E. destruct qs as [|q1 qs].
  - destruct H as [<-|[]]. lra.
  - cbv zeta. set (m := largest_q (q1 :: qs)) in *. destruct (Qle_bool q0 m) eqn:C.
    + apply Qle_bool_R in C. destruct H as [<-|H]; [exact C|auto].
    + assert (Q2R m <= Q2R q0).
      { apply Rnot_lt_le. intros L. apply Rlt_le, Rle_Qle, Qle_bool_iff in L. congruence. }
      destruct H as [<-|H]; [lra|]. specialize (IH H). lra.
Qed.

Lemma zero_or_not (s : S.vector) : s <> S.zero -> 0 < len3 (S.x s) (S.y s) (S.z s).
Proof.
  intros NZ. destruct (Rle_lt_or_eq_dec _ _ (len3_nonneg (S.x s) (S.y s) (S.z s))) as [H|H];
    [exact H|]. exfalso. apply NZ. pose proof (len3_square (S.x s) (S.y s) (S.z s)) as L.
  rewrite <- H in L. destruct s as [a b' e]; cbn in *. unfold S.zero. f_equal; nra.
Qed.

(* The work of a contact's force, on the motion size * yv. *)
Lemma work_bound l (slipping : bool) a f : S.obeys l lambda d c (a, f) -> 0 <= a ->
  (slipping = true -> S.slip c d <> S.zero) ->
  Q2R size * S.work (S.contact_wrench c (a, f)) yv
  <= a * Q2R (alpha strict rays slipping r size y).
Proof.
  intros (_ & Across & Cone & Slip) A0 HS.
  assert (WE : S.work (S.contact_wrench c (a, f)) yv =
    a * S.work (S.N c) yv +
    (S.x f * S.x (S.slip c yv) + S.y f * S.y (S.slip c yv) + S.z f * S.z (S.slip c yv))).
  { unfold S.slip. set (k := - (S.dot (S.normal c) (S.moved c yv) / S.dot (S.normal c) (S.normal c))).
    unfold S.work, S.contact_wrench, S.N, S.force_at, S.moved, S.add, S.scale, S.dot, S.cross in *.
    cbn [S.linear S.angular S.x S.y S.z fst snd] in *.
    assert (Z : k * (S.x f * S.x (S.normal c) + S.y f * S.y (S.normal c) + S.z f * S.z (S.normal c)) = 0)
      by (rewrite Across; ring).
    match goal with |- ?L = ?R => assert (D : R - L =
      k * (S.x f * S.x (S.normal c) + S.y f * S.y (S.normal c) + S.z f * S.z (S.normal c))) by ring end.
    lra. }
  rewrite WE, (slip_along (S.x f) (S.y f) (S.z f) yv 0 0), (N_corners b c I yv 0 0).
  fold u r ss.
  set (frictionless := Qeq_bool (high (box_friction (box r))) 0).
  set (moves := negb frictionless && (slipping || must_move strict (geometry r) gens rays)).
  assert (AL : forall t, In t (tips (geometry r)) ->
    Q2R (corner_alpha r size y gens moves t) <= Q2R (alpha strict rays slipping r size y)).
  { intros t Ht. unfold alpha. fold frictionless. fold gens.
    replace (negb frictionless && (slipping || must_move strict (geometry r)
      (if frictionless then [] else gens) rays)) with moves
      by (unfold moves; destruct frictionless; reflexivity).
    apply largest_q_above. apply in_map_iff. exists t. split; [|exact Ht].
    unfold moves. destruct frictionless; reflexivity. }
  assert (MV : moves = true -> S.slip c d <> S.zero).
  { unfold moves. intros M. apply andb_true_iff in M as [_ M]. apply orb_true_iff in M as [M|M].
    - auto.
    - now apply must_move_moves. }
  replace (Q2R size * (a * (u * eval (fun t => rdot (nth 0 t []) (located yv 0 0)) (geometry r) ss) +
      u * eval (along (S.x f) (S.y f) (S.z f) (located yv 0 0)) (geometry r) ss))
    with (eval (fun t => (a * (u * Q2R size)) * rdot (nth 0 t []) (located yv 0 0) +
      (u * Q2R size) * along (S.x f) (S.y f) (S.z f) (located yv 0 0) t) (geometry r) ss).
  2:{ rewrite eval_sum, !eval_multiple.
      match goal with |- _ * ?A + _ * ?B = _ =>
        transitivity (Q2R size * (a * (u * A) + u * B)); [ring|reflexivity] end. }
  apply eval_most; [apply (shares_valid b c I)|]. intros t Ht.
  eapply Rle_trans; [|apply Rmult_le_compat_l; [exact A0|apply (AL t Ht)]].
  eapply Rle_trans; [|apply (corner_bound moves a (S.x f) (S.y f) (S.z f) t A0)].
  - right. unfold along, slip_at. cbn [nth]. rewrite !rdot_y.
    match goal with |- _ * IZR ?n0 + _ * (_ * IZR ?n1 + _ * IZR ?n2 + _ * IZR ?n3) = _ =>
      transitivity (a * (u * Q2R size * IZR n0) +
        u * Q2R size * (S.x f * IZR n1 + S.y f * IZR n2 + S.z f * IZR n3)); [ring|reflexivity] end.
  - exact Cone.
  - intros M. specialize (MV M). specialize (Slip MV).
    pose proof (zero_or_not _ MV) as P.
    exists (S.friction c * S.length c * a / len3 (S.x (S.slip c d)) (S.y (S.slip c d)) (S.z (S.slip c d))).
    split; [|split].
    + apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
      pose proof (friction_nonneg _ _ I). pose proof (length_positive _ _ I).
      apply Rmult_le_pos; [apply Rmult_le_pos; lra|exact A0].
    + field. lra.
    + rewrite Slip. unfold S.scale. cbn [S.x S.y S.z]. auto.
Qed.

Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.
Notation bound t := (over_rays (value t) ws).

Let v := S.v c lambda d.
Let p_unit := unit (pull_scaling b).

Lemma v_bound factor U :
  (forall f, In f (pull_tips r) -> factor * p_unit * rdot f x <= U) -> factor * v <= U.
Proof.
  intros H. apply (v_at_ends b c I lambda d). intros p k Hpk.
  pose proof (pull_corners b c I p k d 1 lambda Hpk) as E. rewrite Rmult_1_r in E. rewrite E.
  fold x. fold p_unit. rewrite <- Rmult_assoc, <- eval_multiple.
  apply eval_most; [apply (shares_valid b c I)|]. intros f Hf. apply H.
  unfold pull_tips. apply in_concat. exists (tips (integer_tree (pull_scaling b) (pull_tree b (p, k)))).
  split; [|exact Hf]. apply in_map. cbn [r pulls make_row]. apply in_map_iff. exists (p, k). now split.
Qed.

Lemma p_unit_positive : 0 < p_unit.
Proof. apply unit_positive. Qed.

Lemma v_nonneg : forallb (nowhere_negative rays) (pull_tips r) = true -> 0 <= v.
Proof.
  intros H. rewrite forallb_forall in H. assert (-1 * v <= 0); [|lra]. apply v_bound.
  intros f Hf. pose proof (nowhere_negative_nonneg rays x ws W spanned f (H f Hf)).
  pose proof p_unit_positive. nra.
Qed.

Lemma v_nonpos : forallb (nowhere_positive rays) (pull_tips r) = true -> v <= 0.
Proof.
  intros H. rewrite forallb_forall in H. rewrite <- (Rmult_1_l v). apply v_bound.
  intros f Hf. pose proof (nowhere_positive_nonpos rays x ws W spanned f (H f Hf)).
  pose proof p_unit_positive. nra.
Qed.

(* m alpha max(0, v) is at most the term. *)
Lemma term_bound al (mixed : bool) a : a = Rmax 0 v ->
  (mixed = false -> 0 <= v /\ forall f, In f (pull_tips r) -> 0 <= rdot f x) ->
  IZR m * (a * Q2R al) <= bound (term_of m al mixed r).
Proof.
  intros Ha Closed. pose proof p_unit_positive as PU. apply IZR_lt in m_positive as MP.
  assert (OP : (0 < over (pull_scale r))%Z) by apply common_denominator_positive.
  assert (TP : (0 < times (pull_scale r))%Z) by apply content_positive.
  set (n := (m * Qnum al * times (pull_scale r))%Z).
  set (den := (Zpos (Qden al) * over (pull_scale r))%Z).
  assert (DP : (0 < den)%Z) by (unfold den; lia).
  apply IZR_lt in DP as DP'. apply IZR_lt in OP as OP'.
  assert (QD : 0 < IZR (Zpos (Qden al))) by (apply IZR_lt; lia).
  assert (FE : IZR n / IZR den = IZR m * Q2R al * p_unit).
  { unfold n, den, p_unit, unit, Q2R. rewrite !mult_IZR. change (pull_scale r) with (pull_scaling b).
    field. change (pull_scale r) with (pull_scaling b) in OP'. lra. }
  assert (B0 : bound Nothing = 0).
  { clear. induction ws as [|[w z] ws' IH]; cbn; [reflexivity|]. rewrite IH. lra. }
  assert (A0 : 0 <= a) by (rewrite Ha; apply Rmax_l).
  assert (Sign : Q2R al <= 0 -> IZR m * (a * Q2R al) <= 0).
  { intros N. assert (a * Q2R al <= 0) by nra. nra. }
  (* If it presses, a = v. *)
  assert (Press : forall U, 0 <= U \/ mixed = false -> (0 <= v -> IZR m * Q2R al * v <= U) ->
    IZR m * (a * Q2R al) <= U).
  { intros U U0 H. destruct (Rle_dec 0 v) as [V|V].
    - rewrite Ha, Rmax_right by exact V. replace (IZR m * (v * Q2R al)) with (IZR m * Q2R al * v) by ring.
      auto.
    - destruct U0 as [U0|E]; [|destruct (Closed E); lra].
      rewrite Ha, Rmax_left by lra. lra. }
  assert (General : forall vs, vs = pull_tips r ->
    IZR m * (a * Q2R al) <= bound (if mixed && (Qnum al <=? 0)%Z then Nothing
      else Bend (m * times (pull_scale r)) den (map (map (Z.mul (Qnum al))) vs) mixed)).
  { intros vs ->. destruct (mixed && (Qnum al <=? 0)%Z) eqn:C.
    - apply andb_true_iff in C as [_ C]. apply Z.leb_le, IZR_le in C. rewrite B0. apply Sign.
      unfold Q2R. assert (0 < / IZR (Zpos (Qden al))) by now apply Rinv_0_lt_compat. nra.
    - apply Press.
      + destruct mixed; [left|now right]. apply (mixed_bound_nonneg rays ws W); [nia|exact DP].
      + intros V. apply v_bound. intros f Hf.
        eapply Rle_trans; [|apply (bend_bound rays x ws W spanned _ _ _ _ (map (Z.mul (Qnum al)) f));
          [nia|exact DP|now apply in_map]].
        right. rewrite <- FE, rdot_scaled. unfold n. rewrite !mult_IZR. unfold Rdiv. ring. }
  unfold term_of. fold n den. destruct (pull_tips r) as [|v0 [|v1 vs]] eqn:PT;
    try (apply General; reflexivity).
  pose proof (up_above n den DP) as UA. rewrite FE in UA. set (k := up n den) in *.
  assert (R0 : 0 <= v -> v <> 0 \/ mixed = false -> 0 <= rdot v0 x).
  { intros V NZ. destruct mixed.
    - destruct NZ as [NZ|]; [|discriminate]. apply Rnot_lt_le. intros L.
      assert (1 * v <= p_unit * rdot v0 x); [|nra].
      apply v_bound. rewrite PT. intros f [<-|[]]. lra.
    - destruct (Closed eq_refl) as [_ H]. apply H. now left. }
  assert (Line' : 0 <= v -> 0 <= rdot v0 x -> IZR m * Q2R al * v <= IZR k * rdot v0 x).
  { intros V P. apply v_bound. rewrite PT. intros f [<-|[]]. apply Rmult_le_compat_r; assumption. }
  destruct mixed.
  - destruct (Z.leb_spec k 0) as [K|K].
    + apply IZR_le in K. rewrite B0. apply Sign. apply Rnot_lt_le. intros P.
      assert (0 < IZR m * Q2R al * p_unit) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; assumption). lra.
    + apply Press; [left; apply (mixed_bound_nonneg rays ws W); lia|]. intros V.
      destruct (Req_dec v 0) as [VZ|VZ].
      * rewrite VZ, Rmult_0_r. apply (mixed_bound_nonneg rays ws W); lia.
      * eapply Rle_trans; [apply Line'; [exact V|apply R0; auto]|].
        replace (IZR k) with (IZR k / IZR 1) by (field; lra).
        apply (bend_bound rays x ws W spanned); [lia|lia|now left].
  - rewrite (line_bound x ws spanned). apply Press; [now right|]. intros V. apply Line'; [exact V|].
    apply R0; auto.
Qed.

End Contact.

(* ---- The leaf ---- *)

Definition fits (row : row) (c : S.contact) := row = make_row (box row) /\ inside (box row) c.

(* The coordinates of a wrench. *)
Definition six (w : S.screw) : list R :=
  [S.x (S.linear w); S.y (S.linear w); S.z (S.linear w);
   S.x (S.angular w); S.y (S.angular w); S.z (S.angular w)].

Record solution (rows : list row) (ld : load) (g : S.grasp) (lambda : R)
    (d : S.screw) (forces : list (R * S.vector)) : Prop := Solution {
  contacts_fit : Forall2 fits rows (S.contacts g);
  load_fits : ld = make_load (load_box ld) (load_growth ld);
  wrench_fits : Forall2 within (load_box ld) (six (S.wrench g));
  growth_fits : map Q2R (load_growth ld) = six (S.direction g);
  lambda_nonneg : 0 <= lambda;
  is_equilibrium : S.equilibrium g lambda d forces
}.

Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.

Lemma load_bound ld g :
  ld = make_load (load_box ld) (load_growth ld) ->
  Forall2 within (load_box ld) (six (S.wrench g)) ->
  map Q2R (load_growth ld) = six (S.direction g) -> 0 <= lambda ->
  IZR m * (Q2R size * S.work (S.add_screw (S.wrench g) (S.scale_screw lambda (S.direction g))) yv)
  <= rdot (load_term m size y ld) x.
Proof.
  intros E Hw Hu L. rewrite E. set (bx := load_box ld) in *. set (us := load_growth ld) in *.
  clearbody bx us. clear E ld. unfold load_term, make_load.
  cbn [lows_of_w highs_of_w form_of_u load_scaling].
  set (qs := map low bx ++ map high bx ++ us). set (sc := scaling_of qs).
  assert (X : forall q, In q qs -> Q2R q = unit sc * IZR (to_integer sc q))
    by (intros; now apply to_integer_exact).
  assert (UP : 0 < unit sc) by apply unit_positive.
  assert (OP : (0 < over sc)%Z) by apply common_denominator_positive.
  assert (DP : (0 < Zpos (Qden size) * over sc)%Z) by lia.
  apply IZR_lt in m_positive as MP.
  assert (Step : forall z, IZR m * (Q2R size * (unit sc * IZR z)) <=
    IZR (up (m * Qnum size * times sc * z) (Zpos (Qden size) * over sc))).
  { intros z. eapply Rle_trans; [|apply up_above; exact DP]. rewrite !mult_IZR. right.
    unfold unit, Q2R. apply IZR_lt in OP. assert (0 < IZR (Zpos (Qden size))) by (apply IZR_lt; lia).
    field. lra. }
  assert (Bw : works y (six (S.wrench g)) <= unit sc * IZR (most_work y
    (map (to_integer sc) (map low bx)) (map (to_integer sc) (map high bx)))).
  { apply most_work_bound; [exact UP| |exact Hw]. intros i Hi. split; apply X; unfold qs.
    - apply in_or_app; left. now apply in_map.
    - apply in_or_app; right. apply in_or_app; left. now apply in_map. }
  assert (Bu : works y (six (S.direction g)) = unit sc * IZR (dot (map (to_integer sc) us) y)).
  { rewrite <- Hu. apply works_growth. intros q Hq. apply X. unfold qs.
    apply in_or_app; right. apply in_or_app; now right. }
  pose proof (Step (most_work y (map (to_integer sc) (map low bx)) (map (to_integer sc) (map high bx)))) as Sw.
  pose proof (Step (dot (map (to_integer sc) us) y)) as Su. rewrite <- Bu in Su.
  set (cw := up _ _) in Sw. set (cu := up _ _) in Su.
  match goal with |- _ <= rdot [_; _; _; _; _; _; ?A; ?B] _ => change A with cw; change B with cu end.
  clearbody cw cu.
  assert (WE : S.work (S.add_screw (S.wrench g) (S.scale_screw lambda (S.direction g))) yv =
    works y (six (S.wrench g)) + lambda * works y (six (S.direction g))).
  { unfold S.work, S.add_screw, S.scale_screw, S.add, S.scale, S.dot, six, y, yv; cbn. ring. }
  rewrite WE. unfold x, located; cbn [rdot].
  assert (A : IZR m * (Q2R size * works y (six (S.wrench g))) <= IZR cw).
  { eapply Rle_trans; [|exact Sw]. apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; lra. }
  assert (B : lambda * (IZR m * (Q2R size * works y (six (S.direction g)))) <= lambda * IZR cu)
    by (apply Rmult_le_compat_l; assumption).
  lra.
Qed.

Lemma forces_bound l slipping rows cs forces number :
  Forall2 fits rows cs -> Forall2 (S.obeys l lambda d) cs forces ->
  (forall k i row c, existsb (Z.eqb (number + Z.of_nat k)) slipping = true ->
     nth_error rows k = Some row -> nth_error cs k = Some c -> i = k -> S.slip c d <> S.zero) ->
  IZR m * (Q2R size * S.work (S.sum (S.contact_wrenches cs forces)) yv)
  <= bounds ws (map (fun it => term_of m (snd (fst it)) (snd it) (fst (fst it)))
       (pressing strict rays slipping size y rows number)).
Proof.
  intros F. revert forces number. induction F as [|row c rows cs [Fr I] F IH]; intros forces number O SL.
  - inversion O; subst. cbn. unfold S.work, S.sum, S.dot; cbn. lra.
  - inversion O as [|c' [a f] cs' fs Oc Os]; subst.
    assert (SL' : forall k i row0 c0, existsb (Z.eqb (number + 1 + Z.of_nat k)) slipping = true ->
      nth_error rows k = Some row0 -> nth_error cs k = Some c0 -> i = k -> S.slip c0 d <> S.zero).
    { intros k i row0 c0 H1 H2 H3 _. apply (SL (Datatypes.S k) (Datatypes.S k) row0 c0); try assumption; [|reflexivity].
      replace (number + Z.of_nat (Datatypes.S k))%Z with (number + 1 + Z.of_nat k)%Z by lia. exact H1. }
    specialize (IH fs (number + 1)%Z Os SL').
    assert (HS : existsb (Z.eqb number) slipping = true -> S.slip c d <> S.zero).
    { intros H. apply (SL 0%nat 0%nat row c); try reflexivity. now rewrite Z.add_0_r. }
    assert (E : S.work (S.sum (S.contact_wrenches (c :: cs) ((a, f) :: fs))) yv =
                S.work (S.contact_wrench c (a, f)) yv + S.work (S.sum (S.contact_wrenches cs fs)) yv).
    { unfold S.work, S.sum, S.contact_wrenches, S.add_screw, S.add, S.dot; cbn. ring. }
    rewrite E. cbn [pressing].
    set (rest := pressing strict rays slipping size y rows (number + 1)) in *.
    set (sl := existsb (Z.eqb number) slipping) in *.
    set (b := box row) in *.
    assert (Law : a = Rmax 0 (S.v c lambda d)).
    { destruct Oc as [Law _]. destruct l; cbn in Law; [exact Law|]. rewrite Rmax_right; lra. }
    assert (A0 : 0 <= a) by (rewrite Law; apply Rmax_l).
    pose proof (work_bound b c I l sl a f Oc A0 HS) as WB. rewrite <- Fr in WB.
    apply IZR_lt in m_positive as MP.
    assert (WB' : IZR m * (Q2R size * S.work (S.contact_wrench c (a, f)) yv) <=
                  IZR m * (a * Q2R (alpha strict rays sl row size y)))
      by (apply Rmult_le_compat_l; lra).
    destruct (forallb (nowhere_negative rays) (pull_tips row)) eqn:Closed;
      [|destruct (forallb (nowhere_positive rays) (pull_tips row)) eqn:Open].
    + cbn [map bounds fst snd].
      assert (TB := term_bound b c I m m_positive
        (alpha strict rays sl row size y) false a Law).
      rewrite <- Fr in TB. rewrite !Rmult_plus_distr_l. apply Rplus_le_compat; [|exact IH].
      eapply Rle_trans; [exact WB'|]. apply TB. intros _. split.
      * apply (v_nonneg b c I). rewrite <- Fr. exact Closed.
      * intros g Hg. rewrite forallb_forall in Closed.
        apply (nowhere_negative_nonneg rays _ ws W spanned). auto.
    + assert (V : S.v c lambda d <= 0).
      { apply (v_nonpos b c I). rewrite <- Fr. exact Open. }
      assert (a = 0) by (rewrite Law; apply Rmax_left; exact V). subst a.
      rewrite H in *. rewrite Rmult_0_l, Rmult_0_r in WB'. lra.
    + cbn [map bounds fst snd].
      assert (TB := term_bound b c I m m_positive
        (alpha strict rays sl row size y) true a Law).
      rewrite <- Fr in TB. rewrite !Rmult_plus_distr_l. apply Rplus_le_compat; [|exact IH].
      eapply Rle_trans; [exact WB'|]. apply TB. discriminate.
Qed.

End Leaf.

Section Refutes.
Open Scope R_scope.

(* The contacts of these numbers slip. *)
Definition slips_at (slipping : list Z) (cs : list S.contact) (d : S.screw) :=
  forall k c, existsb (Z.eqb (Z.of_nat k)) slipping = true -> nth_error cs k = Some c ->
  S.slip c d <> S.zero.

Theorem leaf_refutes strict rays rows ld slipping y g lambda d forces :
  Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a (located d 1 lambda)) ->
  Forall (Exists (fun f => rdot f (located d 1 lambda) <> 0)) strict ->
  solution rows ld g lambda d forces -> slips_at slipping (S.contacts g) d ->
  leaf_holds rows ld slipping strict rays y = false.
Proof.
  intros K (ws & W & Sp) T [F LE LW LU L [Ob Bal]] SL. apply not_true_is_false. intros H.
  unfold leaf_holds in H. set (sc := scaling_of y) in *.
  destruct (map (to_integer sc) y) as [|y1 [|y2 [|y3 [|y4 [|y5 [|y6 [|? ?]]]]]]]; try discriminate.
  cbv zeta in H. set (m := fold_left _ _ _) in H. apply andb_true_iff in H as [M H]. apply Z.ltb_lt in M.
  assert (SP : 0 < Q2R (unit_of sc)).
  { rewrite unit_of_is by apply common_denominator_positive. apply unit_positive. }
  destruct (collect _ _ _ []) as [linear bends] eqn:C in H.
  apply (positive_at_home_positive strict rays _ K T ws W Sp) in H.
  rewrite (sum_of_values _ ws Sp) in H.
  pose proof (collect_sum _ ws Sp _ _ _ _ _ _ C) as Sum. cbn [bounds] in Sum.
  pose proof (forces_bound strict rays d lambda K T ws W Sp y1 y2 y3 y4 y5 y6 _ SP m M
    (S.normal_law g) slipping rows (S.contacts g) forces 0%Z F Ob) as FB.
  pose proof (load_bound d lambda y1 y2 y3 y4 y5 y6 _ SP m M ld g LE LW LU L) as LB.
  set (yv := S.Screw _ _) in *.
  assert (Z : S.work (S.add_screw (S.add_screw (S.wrench g) (S.scale_screw lambda (S.direction g)))
     (S.sum (S.contact_wrenches (S.contacts g) forces))) yv = 0).
  { rewrite Bal. unfold S.work, S.no_screw, S.dot; cbn. ring. }
  assert (E : forall a b, S.work (S.add_screw a b) yv = S.work a yv + S.work b yv)
    by (intros; unfold S.work, S.add_screw, S.add, S.dot; cbn; ring).
  rewrite E in Z.
  assert (FB' := FB (fun k i row c H1 _ H3 _ => SL k c H1 H3)).
  set (A := S.work (S.add_screw (S.wrench g) (S.scale_screw lambda (S.direction g))) yv) in *.
  set (B := S.work (S.sum (S.contact_wrenches (S.contacts g) forces)) yv) in *.
  assert (A = - B) by lra. rewrite H0 in LB.
  replace (IZR m * (Q2R (unit_of sc) * - B)) with (- (IZR m * (Q2R (unit_of sc) * B))) in LB by ring.
  lra.
Qed.

End Refutes.
