(* SPDX-License-Identifier: MIT *)
(* Slips of more than one component (FORMAT.md section 7).  The slips of a contact at the rays of a region
   generate a cone; whether the contact moves, and how much of its friction can work on y, are decided by
   planes that have all of that cone on one side.  `force_bound`: no force does more work on y than alpha
   times its a. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root Box Terms.
From Proved Require Rows.
Import ListNotations.

(* ---- Cones of slips ---- *)

Section Checker.
Open Scope Z_scope.

Variable ms : list Z.   (* the weights of the product *)

Fixpoint inner_of (ms s t : form) : Z :=
  match ms, s, t with
  | m :: ms', x :: s', y :: t' => m * x * y + inner_of ms' s' t'
  | _, _, _ => 0
  end.

Notation inner := (inner_of ms).

Definition slip_at (t : list form) (d : form) : form := map (fun f => dot f d) (tl t).

Definition motion_of (r : ray) : form := match coordinates r with _ :: _ :: d => d | _ => [] end.

Definition slips (g : multi (list form)) (rays : list ray) : list form :=
  flat_map (fun t => map (fun r => slip_at t (motion_of r)) rays) (tips g).

(* Whether w.s / |s| is less than w.t / |t|. *)
Definition less_along (w s t : form) : bool :=
  inner w s * Z.abs (inner w s) * inner t t <? inner w t * Z.abs (inner w t) * inner s s.

(* The generator that is nearest to w. *)
Definition nearest (w : form) (gens : list form) : option form :=
  fold_left (fun best s =>
    if all_zero s then best
    else match best with
         | None => Some s
         | Some b => if less_along w b s then Some s else best
         end) gens None.

(* A point k / m of the cone, from which w - k / m = e / m leads on to w, and its squared length n / d. *)
Record foot := Foot { of_gens : list form; foot_m : Z; foot_e : form; foot_n : Z; foot_d : Z }.

(* The nearest to w on the line of a generator, and on the plane of two, where these are between them. *)
Definition foot_on (w s : form) : list foot :=
  let a := inner w s in
  let ss := inner s s in
  if 0 <? a then [Foot [s] ss (combine ss w (- a) s) (a * a) ss] else [].

Definition foot_between (w s t : form) : list foot :=
  let ws := inner w s in
  let wt := inner w t in
  let ss := inner s s in
  let tt := inner t t in
  let st := inner s t in
  let det := ss * tt - st * st in
  let cs := ws * tt - wt * st in
  let ct := wt * ss - ws * st in
  if (0 <? det) && (0 <? cs) && (0 <? ct)
  then [Foot [s; t] det (combine 1 (combine det w (- cs) s) (- ct) t) (cs * ws + ct * wt) det] else [].

Definition longer (best f : foot) : foot :=
  if foot_n best * foot_d f <? foot_n f * foot_d best then f else best.

(* Of all points of the cone the one that is nearest to w, if that is on its border: as long as a generator leads on, on
   from it towards that.  Nothing is proved of it: what it finds is looked at. *)
Fixpoint foot_from (steps : nat) (w : form) (gens : list form) (f : foot) : option foot :=
  match nearest (foot_e f) gens, steps with
  | None, _ => Some f
  | Some g, steps =>
      if inner (foot_e f) g <=? 0 then Some f
      else match steps with
           | O => None
           | S steps' =>
               let next := fold_left longer (foot_on w g ++ flat_map (fun s => foot_between w s g) (of_gens f)) f in
               if foot_n f * foot_d next <? foot_n next * foot_d f then foot_from steps' w gens next else None
           end
  end.

Definition foot_of (w : form) (gens : list form) : option foot :=
  foot_from (List.length gens) w gens (Foot [] 1 w 0 1).

Definition nowhere_along (gens : list form) (e : form) : bool :=
  forallb (fun s => inner s e <=? 0) gens.

(* If w is outside of the cone, an e with e.w > 0 and e.s <= 0 for all generators: its
   distance from the cone. *)
Definition separator (gens : list form) (w : form) : option form :=
  match foot_of w gens with
  | Some f =>
      let e := primitive (foot_e f) in
      if nowhere_along gens e && (0 <? inner w e) then Some e else None
  | None => None
  end.

(* Whether -s is shown to be outside of the cone, by one of the separators or one more. *)
Definition outside (gens separators : list form) (s : form) : option (list form) :=
  let w := negative s in
  if existsb (fun e => 0 <? inner w e) separators then Some separators
  else if all_zero s then None
  else match separator gens w with
       | Some e => Some (e :: separators)
       | None => None
       end.

(* The rays with -s in the cone. `separators` are those that were found. *)
Fixpoint opposed (gens separators : list form) (rays : list (form * ray)) : list ray :=
  match rays with
  | [] => []
  | (s, r) :: rays' =>
      match outside gens separators s with
      | Some more => opposed gens more rays'
      | None => r :: opposed gens separators rays'
      end
  end.

(* Whether some strict function is zero on all of them, of those that are marked; as soon as none is, the others are
   not looked at. *)
Fixpoint opposed_barred (gens separators : list form) (marks : list bool) (rays : list (form * ray)) : bool :=
  existsb (fun z => z) marks &&
  match rays with
  | [] => true
  | (s, r) :: rays' =>
      match outside gens separators s with
      | Some more => opposed_barred gens more marks rays'
      | None => opposed_barred gens separators (both (zeros r) marks) rays'
      end
  end.

Definition must_move (strict : list (list form)) (g : multi (list form)) (gens : list form)
    (rays : list ray) : bool :=
  forallb (fun t =>
    opposed_barred gens [] (map (fun _ => true) strict) (map (fun r => (slip_at t (motion_of r), r)) rays)) (tips g).

(* The largest w.s / |s| in the cone, for w = -z: its sign, and its square as a fraction. If w is in the
   cone, |z|. *)
Definition most_along (gens : list form) (z : form) : bool * Z * Z :=
  let w := negative z in
  let whole := (false, inner z z, 1) in
  match nearest w gens with
  | None => whole
  | Some s =>
      let a := inner w s in
      if 0 <=? a then
        match foot_of w gens with
        | Some f =>
            let k := combine (foot_m f) w (-1) (foot_e f) in
            if nowhere_along gens (foot_e f) && (0 <? foot_m f) then (false, inner k k, foot_m f * foot_m f) else whole
        | None => whole
        end
      else if forallb (fun g => (inner w g <=? 0) && (a * a * inner g g <=? inner w g * inner w g * inner s s))
                gens && (0 <? inner s s)
           then (true, a * a, inner s s)
           else whole
  end.

End Checker.

Section Contacts.
Open Scope Z_scope.

Definition unit_of (s : scaling) : Q := Qmake (times s) (Z.to_pos (over s)).

Fixpoint largest_q (qs : list Q) : Q :=
  match qs with
  | [] => 0%Q
  | [q] => q
  | q :: qs' => let m := largest_q qs' in if Qle_bool q m then m else q
  end.

(* What friction can do at this mu: mu L times the work along the cone, whose square is a fraction of two numbers, and
   where the normal is uncertain, as much of |z| more as it can turn.  `scale` is the square of what is left out. *)
Definition friction_work (row : row) (scale : Q) (along : bool * Z * Z) (zz : Z) (mu : Q) : Q :=
  let '(below, n, d) := along in
  let c := (mu * mu * scale)%Q in
  let q := (c * Qmake n (Z.to_pos d))%Q in
  let it := if below && Qle_bool 0 mu then (- root_below q)%Q else root_above q in
  if Qle_bool (slack row) 0 then it
  else (it + (3 # 2) * slack row * root_above (c * inject_Z zz))%Q.

(* At a corner; `factor` is that of y. *)
Definition corner_alpha (row : row) (factor : Q) (y : form) (gens : list form) (moves : bool)
    (t : list form) : Q :=
  let z := slip_at t y in
  let zz := inner_of (metric row) z z in
  let along := if moves then most_along (metric row) gens z else (false, zz, 1) in
  let u := (unit_of (forms_scale row) * factor)%Q in
  let scale := (box_square (box row) * unit_of (metric_scale row) * (u * u))%Q in
  reduced (u * inject_Z (dot (nth 0 t []) y) +
    largest_q (map (friction_work row scale along zz) (ends (box_friction (box row)))))%Q.

(* Of y in integers: alpha is that of factor * y, over the factor. *)
Definition alpha (strict : list (list form)) (rays : list ray) (slipping : bool) (row : row)
    (factor : Q) (y : form) : Q :=
  let frictionless := Qeq_bool (high (box_friction (box row))) 0 in
  let gens := if frictionless then [] else slips (forms row) rays in
  let moves := negb frictionless &&
    (slipping || must_move (metric row) strict (forms row) gens rays) in
  reduced (largest_q (map (corner_alpha row factor y gens moves) (tips (forms row))) / factor)%Q.

Definition alpha_term (m : Z) (a : Q) (mixed : bool) (row : row) : term :=
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

(* A multiple of the denominators. *)
Definition alpha_over (a : Q) (row : row) : Z := Zpos (Qden a) * over (pull_scale row).

End Contacts.

(* ---- Proofs: cones ---- *)

Section Cones.
Open Scope R_scope.

Variable ms : list Z.
Let W := map IZR ms.
Hypothesis positive : Rows.positive W.

Notation inner := (inner_of ms).
Notation product := (Rows.product W).
Notation size := (Rows.size W).
Notation real := (map IZR).

Lemma inner_is s t : IZR (inner s t) = product (real s) (real t).
Proof.
  unfold W. clear. revert s t. induction ms as [|m ms' IH]; intros [|x s] [|y t]; cbn; try reflexivity.
  now rewrite plus_IZR, !mult_IZR, IH.
Qed.

Lemma product_negative s e : product (real (negative s)) e = - product (real s) e.
Proof.
  unfold W. clear. revert s e. induction ms as [|m ms' IH]; intros [|x s] [|y e]; cbn; try ring.
  unfold negative in IH. rewrite IH, opp_IZR. ring.
Qed.

Lemma product_combine p a q c e :
  product (real (combine p a q c)) e = IZR p * product (real a) e + IZR q * product (real c) e.
Proof.
  assert (S : forall ms' k a e, Rows.product (map IZR ms') (real (map (Z.mul k) a)) e =
    IZR k * Rows.product (map IZR ms') (real a) e).
  { clear. induction ms' as [|m ms' IH]; intros k [|x a] [|y e]; cbn; try ring.
    rewrite IH, mult_IZR. ring. }
  unfold W. clear W positive. revert a c e.
  induction ms as [|m ms' IH]; intros [|x a] [|z c] [|y e]; cbn; try ring.
  - rewrite S, mult_IZR. ring.
  - rewrite S, mult_IZR. ring.
  - rewrite IH, plus_IZR, !mult_IZR. ring.
Qed.

Lemma nearest_in w gens s : nearest ms w gens = Some s -> In s gens.
Proof.
  unfold nearest. assert (A : forall l best, (forall b, best = Some b -> In b gens) ->
    (forall g, In g l -> In g gens) ->
    fold_left (fun best s => if all_zero s then best
      else match best with None => Some s
           | Some b => if less_along ms w b s then Some s else best end) l best = Some s -> In s gens).
  { induction l as [|g l IH]; intros best B G H; cbn in H; [now apply B|].
    eapply IH; [|intros; apply G; now right|exact H].
    intros b Eb. destruct (all_zero g); [now apply B|]. destruct best as [b0|].
    - destruct (less_along ms w b0 g); [|now apply B]. injection Eb as <-. apply G. now left.
    - injection Eb as <-. apply G. now left. }
  intros H. eapply A; [| |exact H]; [discriminate|auto].
Qed.

(* A cone of slips is known by the vectors e with e.s <= 0 for all its generators s. *)
Definition in_dual (gens : list form) (e : list R) := forall g, In g gens -> product (real g) e <= 0.

Definition in_cone (gens : list form) (s : list R) := forall e, in_dual gens e -> product s e <= 0.

Lemma nowhere_along_dual gens e : nowhere_along ms gens e = true -> in_dual gens (real e).
Proof.
  unfold nowhere_along. rewrite forallb_forall. intros H g Hg. specialize (H g Hg).
  apply Z.leb_le, IZR_le in H. rewrite inner_is in H. exact H.
Qed.

Lemma sqrt_of_square a d : 0 <= a -> 0 < d -> sqrt (a * a / d) = a / sqrt d.
Proof.
  intros A D. unfold Rdiv. rewrite sqrt_mult_alt by nra. rewrite sqrt_square by exact A.
  f_equal. now apply sqrt_inv.
Qed.

Theorem most_along_bound gens z s : in_cone gens s ->
  let '(below, n, d) := most_along ms gens z in
  (0 <= n)%Z /\ (0 < d)%Z /\
  - product (real z) s <= (if below then -1 else 1) * sqrt (IZR n / IZR d) * size s.
Proof.
  intros C. set (w := negative z).
  assert (WE : forall s, product (real w) s = - product (real z) s) by (intros; apply product_negative).
  assert (Whole : (0 <= inner z z)%Z /\ (0 < 1)%Z /\
    - product (real z) s <= 1 * sqrt (IZR (inner z z) / IZR 1) * size s).
  { split; [|split; [lia|]].
    - apply le_IZR. rewrite inner_is. now apply Rows.product_nonneg.
    - rewrite Rmult_1_l. replace (IZR (inner z z) / IZR 1) with (product (real w) (real w)).
      + rewrite <- WE. now apply Rows.product_bound.
      + rewrite WE, Rows.product_sym, WE, inner_is. field. }
  unfold most_along. fold w.
  destruct (nearest ms w gens) as [g|] eqn:Near; [|exact Whole].
  apply nearest_in in Near. set (a := inner w g). set (gg := inner g g).
  assert (GG : IZR gg = product (real g) (real g)) by apply inner_is.
  assert (AA : IZR a = product (real w) (real g)) by apply inner_is.
  destruct (Z.leb_spec 0 a) as [A0|A0].
  - destruct (foot_of ms w gens) as [f|]; [|exact Whole]. set (m := foot_m f). set (e := foot_e f).
    set (k := combine m w (-1) e).
    destruct (nowhere_along ms gens e && (0 <? m)%Z) eqn:H; [|exact Whole].
    apply andb_true_iff in H as [H P]. apply Z.ltb_lt in P.
    assert (KK : IZR (inner k k) = product (real k) (real k)) by apply inner_is.
    assert (K0 : 0 <= IZR (inner k k)) by (rewrite KK; now apply Rows.product_nonneg).
    split; [now apply le_IZR|]. split; [nia|].
    apply nowhere_along_dual, C in H. rewrite Rows.product_sym in H. apply IZR_lt in P. rewrite Rmult_1_l.
    pose proof (Rows.product_bound W (real k) s positive) as Cy. unfold k in Cy at 1.
    rewrite product_combine in Cy. rewrite <- WE.
    assert (LT : sqrt (IZR (inner k k) / IZR (m * m)) = size (real k) / IZR m).
    { unfold Rdiv. rewrite sqrt_mult_alt, mult_IZR by exact K0. unfold Rows.size. rewrite KK. f_equal.
      rewrite sqrt_inv, sqrt_square by lra. reflexivity. }
    rewrite LT. apply Rmult_le_reg_l with (IZR m); [exact P|].
    replace (IZR m * (size (real k) / IZR m * size s)) with (size (real k) * size s) by (field; lra). lra.
  - destruct (forallb _ gens && (0 <? gg)%Z) eqn:H; [|exact Whole].
    apply andb_true_iff in H as [H P]. apply Z.ltb_lt in P. split; [nia|]. split; [exact P|].
    rewrite forallb_forall in H. apply IZR_lt in P, A0.
    replace (IZR (a * a)) with (- IZR a * - IZR a) by (rewrite mult_IZR; ring).
    rewrite sqrt_of_square by lra.
    pose proof (sqrt_lt_R0 _ P) as R0. pose proof (sqrt_sqrt (IZR gg) ltac:(lra)) as R2.
    set (root := sqrt (IZR gg)) in *.
    pose proof (Rows.size_nonneg W s) as L0. pose proof (Rows.size_square W s positive) as L2.
    set (L := size s) in *. set (M := IZR a / root).
    assert (M0 : M < 0).
    { unfold M. assert (0 < - IZR a / root) by (apply Rdiv_lt_0_compat; lra).
      unfold Rdiv in *. lra. }
    assert (MR : M * root = IZR a) by (unfold M; field; lra).
    replace (-1 * (- IZR a / root) * L) with (M * L) by (unfold M; field; lra).
    rewrite <- WE. destruct (Req_dec L 0) as [LZ|LZ].
    + rewrite Rows.product_sym, (Rows.size_zero W s (real w) positive LZ), LZ. lra.
    + (* w - M s / |s| has no generator along it *)
      set (e := Rows.plus (real w) (Rows.scaled (- M / L) s)).
      assert (PE : forall v, product v e = product (real w) v - M / L * product s v).
      { intros v. unfold e. rewrite Rows.product_sym, Rows.product_plus, Rows.product_scaled. field. exact LZ. }
      assert (D : in_dual gens e).
      { intros h Hh. specialize (H h Hh). apply andb_true_iff in H as [H1 H2].
        apply Z.leb_le, IZR_le in H1. apply Z.leb_le, IZR_le in H2. rewrite !mult_IZR in H2.
        fold gg in H2. rewrite PE.
        set (hh := inner h h) in *. set (wh := inner w h) in *.
        assert (HH : IZR hh = product (real h) (real h)) by apply inner_is.
        assert (WH : IZR wh = product (real w) (real h)) by apply inner_is.
        pose proof (Rows.size_nonneg W (real h)) as G0. pose proof (Rows.size_square W (real h) positive) as G2.
        pose proof (Rows.product_bound W s (real h) positive) as Cy. fold L in Cy.
        set (G := size (real h)) in *. rewrite <- HH in G2. rewrite <- WH.
        (* w.h <= M |h| *)
        assert (B : IZR wh <= M * G).
        { apply Rnot_lt_le. intros Lt.
          assert (X : IZR a * G < IZR wh * root).
          { replace (IZR a * G) with (M * G * root) by (rewrite <- MR; ring).
            apply Rmult_lt_compat_r; assumption. }
          assert (Y : (- (IZR wh * root)) * (- (IZR wh * root)) < (- (IZR a * G)) * (- (IZR a * G))).
          { apply Rmult_le_0_lt_compat; try lra; nra. }
          assert (Z : IZR a * IZR a * IZR hh <= IZR wh * IZR wh * IZR gg) by lra.
          rewrite <- G2, <- R2 in Z. lra. }
        assert (U : product s (real h) / L <= G).
        { apply Rmult_le_reg_r with L; [lra|]. unfold Rdiv.
          rewrite Rmult_assoc, Rinv_l by exact LZ. lra. }
        unfold Rdiv in *. nra. }
      specialize (C _ D). rewrite PE in C. rewrite <- L2 in C.
      replace (M / L * (L * L)) with (M * L) in C by (field; exact LZ). lra.
Qed.

Definition separates_cone (gens : list form) (e : form) := nowhere_along ms gens e = true.

Lemma separator_is gs w e : separator ms gs w = Some e ->
  separates_cone gs e /\ (0 < inner w e)%Z.
Proof.
  unfold separator. destruct (foot_of ms w gs) as [f|]; [|discriminate]. set (e0 := primitive (foot_e f)).
  intros H. destruct (nowhere_along ms gs e0 && (0 <? inner w e0)%Z) eqn:C; [|discriminate].
  injection H as <-. apply andb_true_iff in C as [C1 C2]. apply Z.ltb_lt in C2. now split.
Qed.

Lemma opposed_is gs seps rs : Forall (separates_cone gs) seps ->
  (forall q, In q (opposed ms gs seps rs) -> exists s, In (s, q) rs) /\
  forall s q, In (s, q) rs -> In q (opposed ms gs seps rs) \/
    exists e, separates_cone gs e /\ (0 < inner (negative s) e)%Z.
Proof.
  revert seps. induction rs as [|[s q] rs IH]; intros seps V; [split; [intros ? []|intros ? ? []]|].
  cbn [opposed]. unfold outside.
  destruct (existsb (fun e => (0 <? inner (negative s) e)%Z) seps) eqn:Ex.
  - destruct (IH seps V) as [A B]. split.
    + intros q' Hq. destruct (A q' Hq) as (s' & H). exists s'. now right.
    + intros s' q' [E|H]; [|exact (B s' q' H)]. injection E as <- <-. right.
      apply existsb_exists in Ex as (e & He & P). rewrite Forall_forall in V.
      exists e. split; [auto|now apply Z.ltb_lt].
  - assert (None_ : (forall q', In q' (q :: opposed ms gs seps rs) -> exists s', In (s', q') ((s, q) :: rs)) /\
      forall s' q', In (s', q') ((s, q) :: rs) -> In q' (q :: opposed ms gs seps rs) \/
        exists e, separates_cone gs e /\ (0 < inner (negative s') e)%Z).
    { destruct (IH seps V) as [A B]. split.
      * intros q' [<-|Hq]; [exists s; now left|]. destruct (A q' Hq) as (s' & H). exists s'. now right.
      * intros s' q' [E|H]; [injection E as <- <-; left; now left|].
        destruct (B s' q' H); [left; now right|now right]. }
    destruct (all_zero s); [exact None_|].
    destruct (separator ms gs (negative s)) as [e|] eqn:Sep; [|exact None_].
    destruct (separator_is _ _ _ Sep) as [V1 P].
    destruct (IH (e :: seps) (Forall_cons _ V1 V)) as [A B]. split.
    + intros q' Hq. destruct (A q' Hq) as (s' & H). exists s'. now right.
    + intros s' q' [E|H]; [|exact (B s' q' H)]. injection E as <- <-. right. now exists e.
Qed.

Lemma both_swap a b z : both a (both b z) = both b (both a z).
Proof.
  revert b z. induction a as [|x a IH]; intros [|y b] [|t z]; cbn; try reflexivity.
  rewrite IH, !andb_assoc, (andb_comm x y). reflexivity.
Qed.

Lemma opposed_barred_is gs rs : forall seps marks, opposed_barred ms gs seps marks rs = true ->
  existsb (fun z => z) (fold_right (fun r z => both (zeros r) z) marks (opposed ms gs seps rs)) = true.
Proof.
  induction rs as [|[s q] rs IH]; intros seps marks H; cbn [opposed_barred opposed] in *;
    apply andb_true_iff in H as [M H]; [exact M|].
  destruct (outside ms gs seps s) as [more|]; [now apply IH|]. apply IH in H. cbn [fold_right].
  replace (both (zeros q) (fold_right (fun r z => both (zeros r) z) marks (opposed ms gs seps rs)))
    with (fold_right (fun r z => both (zeros r) z) (both (zeros q) marks) (opposed ms gs seps rs)); [exact H|].
  clear. induction (opposed ms gs seps rs) as [|r rays IH]; [reflexivity|]. cbn [fold_right]. now rewrite IH, both_swap.
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

End Cones.

(* ---- A contact's force does at most alpha max(0, v) of work ---- *)

(* What is used of friction that does the work phi on y, of a force with the normal coefficient a at d: that of the cone,
   and against the slip.  k is 0, or what FORMAT.md section 7 calls delta where the normal is not the row's. *)
Definition work_within (r : Rows.row) (k a : R) (d y : list R) (phi : R) : Prop :=
  let s := Rows.slip r d in
  let t := Rows.slip r y in
  (phi <= Rows.rho r * a * ((1 + k / 2) * Rows.size (Rows.weights r) t) /\
   (0 < Rows.size (Rows.weights r) s ->
    phi <= Rows.rho r * a * (- Rows.product (Rows.weights r) s t / Rows.size (Rows.weights r) s +
                             3 / 2 * k * Rows.size (Rows.weights r) t)))%R.

Lemma obeys_within w d h l r a g y : Rows.positive (Rows.weights r) -> Rows.obeys w d h l r (a, g) ->
  work_within r 0 a d y (Rows.product (Rows.weights r) g (Rows.slip r y)).
Proof.
  intros P (_ & Cone & Diss). unfold work_within. set (ws := Rows.weights r) in *.
  pose proof (Rows.size_nonneg ws (Rows.slip r y)). split.
  - eapply Rle_trans; [apply (Rows.product_bound _ _ _ P)|].
    replace (Rows.rho r * a * ((1 + 0 / 2) * Rows.size ws (Rows.slip r y)))%R
      with (Rows.rho r * a * Rows.size ws (Rows.slip r y))%R by lra.
    now apply Rmult_le_compat_r.
  - intros S. rewrite (Rows.against_slip _ _ _ _ P Cone Diss S). right. field. lra.
Qed.

Section Contact.
Open Scope R_scope.

Variable strict : list (list form).
Variable rays : list ray.
Variables (d : list R) (h l : R).
Let x := h :: l :: d.
Hypothesis rays_know : Forall (knows strict) rays.
Hypothesis strict_at_x : Forall (Exists (fun f => rdot f x <> 0)) strict.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.

Variable y : form.
Let yv := map IZR y.
Variable factor : Q.
Hypothesis factor_positive : 0 < Q2R factor.

Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu st : R).
Hypothesis I : inside_at b r p F mu st.
Hypothesis unsigned : box_signed b = false.
Let it := make_row b.
Let ss := shares_in b p.
Let u := unit (forms_scaling b).
Let ms := metric it.
Let mu_unit := unit (metric_scale it).
Let G := map IZR ms.
Notation product := (Rows.product G).
Notation real := (map IZR).

Let gens := slips (forms it) rays.

Lemma u_positive : 0 < u.
Proof. apply unit_positive. Qed.

Lemma mu_unit_positive : 0 < mu_unit.
Proof. apply unit_positive. Qed.

Lemma weights_are : Rows.weights r = map (Rmult mu_unit) G.
Proof.
  rewrite (is_weights _ _ _ _ _ _ I). unfold G, ms, mu_unit, it. cbn [metric metric_scale make_row].
  rewrite !map_map. apply map_ext_in. intros q Hq. now apply to_integer_exact.
Qed.

Lemma metric_positive : Rows.positive G.
Proof.
  pose proof (weights_positive _ _ _ _ _ _ I) as P. rewrite weights_are in P. unfold Rows.positive in *.
  rewrite Forall_map in P. eapply Forall_impl; [|exact P]. cbn. intros z Z. pose proof mu_unit_positive.
  apply Rnot_le_lt. intros N. assert (0 <= mu_unit * - z) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma product_is s e : Rows.product (Rows.weights r) s e = mu_unit * product s e.
Proof.
  rewrite weights_are. clear. revert s e. induction G as [|g G' IH]; intros [|z s] [|w e]; cbn; try ring.
  rewrite IH. ring.
Qed.

Lemma size_is s : Rows.size (Rows.weights r) s = sqrt mu_unit * Rows.size G s.
Proof.
  unfold Rows.size. rewrite product_is. apply sqrt_mult_alt. left. apply mu_unit_positive.
Qed.

(* A slip at a corner, and the whole slip. *)
Definition slip_of (t : list form) (d' : list R) : list R := map (fun f => rdot f d') (tl t).

Lemma slip_of_integers t z : slip_of t (real z) = real (slip_at t z).
Proof. unfold slip_of, slip_at. rewrite map_map. apply map_ext. intros f. apply rdot_integers. Qed.

Lemma nth_slip_of t d' j : nth j (slip_of t d') 0 = rdot (nth (S j) t []) d'.
Proof.
  unfold slip_of. change 0 with (rdot [] d') at 1. rewrite (map_nth (fun f => rdot f d')).
  destruct t as [|n t]; [destruct j; reflexivity|reflexivity].
Qed.

Lemma product_skipn ws0 (w : R) s z e j :
  Rows.product (w :: ws0) (skipn j s) (z :: e) =
  w * z * nth j s 0 + Rows.product ws0 (skipn (S j) s) e.
Proof.
  revert j. induction s as [|a s IH]; intros [|j].
  - cbn. destruct ws0; cbn; ring.
  - cbn. destruct ws0; cbn; ring.
  - cbn. ring.
  - exact (IH j).
Qed.

Lemma forms_are : forms it = corner_forms b.
Proof. unfold it. cbn [forms make_row]. now rewrite unsigned. Qed.

Lemma slip_corners e d' :
  product (Rows.slip r d') e = u * eval (fun t => product (slip_of t d') e) (corner_forms b) ss.
Proof.
  assert (A : forall ws0 j e, Rows.product ws0 (skipn j (Rows.slip r d')) e =
    u * eval (fun t => Rows.product ws0 (skipn j (slip_of t d')) e) (corner_forms b) ss).
  { induction ws0 as [|w ws0 IH]; intros j [|z e0].
    1, 2: cbn; rewrite eval_constant; ring.
    - rewrite (eval_same _ (fun _ => 0)), eval_constant by (intros a _; cbv beta; destruct (skipn j (slip_of a d')); reflexivity).
      destruct (skipn j (Rows.slip r d')); cbn; ring.
    - rewrite product_skipn.
      rewrite (eval_same _ (fun t => w * z * rdot (nth (S j) t []) d' +
        Rows.product ws0 (skipn (S j) (slip_of t d')) e0))
        by (intros a _; cbv beta; now rewrite product_skipn, nth_slip_of).
      rewrite eval_sum, eval_multiple, IH.
      pose proof (forms_corners b r p F mu st I (S j) d') as E. cbn [nth] in E.
      assert (N : nth j (Rows.slip r d') 0 = Rows.dot (nth j (Rows.slips r) []) d').
      { unfold Rows.slip. change 0 with (Rows.dot [] d') at 1. apply (map_nth (fun f => Rows.dot f d')). }
      rewrite N, E. fold u ss.
      match goal with |- w * z * (u * ?A) + u * ?B = u * (w * z * ?A' + ?B') =>
        change A' with A; change B' with B end. ring. }
  exact (A G 0%nat e).
Qed.

Lemma N_corners d' : Rows.dot (Rows.N r) d' = u * eval (fun t => rdot (nth 0 t []) d') (corner_forms b) ss.
Proof. exact (forms_corners b r p F mu st I 0 d'). Qed.

(* A sum over the rays of the point. *)
Fixpoint sum_over (H : form -> R) (ws : list (R * form)) : R :=
  match ws with [] => 0 | (w, q) :: ws' => w * H q + sum_over H ws' end.

Definition ray_motion (q : form) : form := match q with _ :: _ :: d' => d' | _ => [] end.

Lemma dot_motion f q : dot (of_motion f) q = dot f (ray_motion q).
Proof. destruct q as [|a [|c q]]; unfold of_motion, ray_motion; cbn; destruct f; reflexivity || lia. Qed.

Lemma rdot_rays f : rdot f d = sum_over (fun q => IZR (dot f (ray_motion q))) ws.
Proof.
  rewrite <- (rdot_of_motion f h l d). fold x. rewrite spanned. clear.
  induction ws as [|[w q] ws' IH]; cbn -[of_motion]; [reflexivity|]. now rewrite IH, dot_motion.
Qed.

Lemma product_rays t0 e : product (slip_of t0 d) e =
  sum_over (fun q => product (real (slip_at t0 (ray_motion q))) e) ws.
Proof.
  assert (A : forall ws0 fs e, Rows.product ws0 (map (fun f => rdot f d) fs) e =
    sum_over (fun q => Rows.product ws0 (real (map (fun f => dot f (ray_motion q)) fs)) e) ws).
  { assert (Z : sum_over (fun _ => 0) ws = 0) by (clear; induction ws as [|[w q] ws' IH]; cbn; lra).
    induction ws0 as [|w ws0 IH]; intros [|f fs] [|z e0]; cbn; try (now rewrite Z).
    rewrite IH, rdot_rays. clear. induction ws as [|[w0 q] ws' IH]; cbn; [ring|]. rewrite <- IH. ring. }
  apply A.
Qed.

Lemma sums_nonpos H ws' : weights (map coordinates rays) ws' ->
  (forall q, In q (map coordinates rays) -> H q <= 0) -> sum_over H ws' <= 0.
Proof.
  intros Wl N. induction Wl as [|[w q] l' [Hw Hq] Wl IH]; cbn; [lra|]. cbn in Hw, Hq.
  specialize (N _ Hq). assert (0 <= w * - H q) by (apply Rmult_le_pos; lra). lra.
Qed.

Lemma sum_over_zero H : (forall q, In q (map coordinates rays) -> H q <= 0) ->
  sum_over H ws = 0 -> Forall (fun wq => fst wq = 0 \/ H (snd wq) = 0) ws.
Proof.
  intros N. clear spanned. revert W. generalize ws as l'. intros l' Wl.
  induction Wl as [|[w q] l' [Hw Hq] Wl IH]; cbn; [constructor|]. intros E. cbn in Hw, Hq.
  pose proof (sums_nonpos H l' Wl N) as N0. pose proof (N _ Hq) as N'.
  assert (0 <= w * - H q) by (apply Rmult_le_pos; lra).
  constructor; [|apply IH; lra]. cbn.
  assert (Z : w * H q = 0) by lra. now apply Rmult_integral in Z.
Qed.

Lemma ray_slip t0 q : In t0 (tips (forms it)) -> In q (map coordinates rays) ->
  In (slip_at t0 (ray_motion q)) gens.
Proof.
  intros Ht Hq. apply in_map_iff in Hq as (q' & <- & Hq). unfold gens, slips.
  apply in_flat_map. exists t0. split; [exact Ht|]. apply in_map_iff. now exists q'.
Qed.

Lemma slip_in_cone : in_cone ms gens (Rows.slip r d).
Proof.
  intros e D. rewrite slip_corners, <- forms_are.
  assert (eval (fun t => product (slip_of t d) e) (forms it) ss <= 0).
  { apply eval_most; [apply (shares_valid b r p F mu st I)|]. intros t0 Ht. rewrite product_rays.
    apply sums_nonpos; [exact W|]. intros q Hq. apply D. now apply ray_slip. }
  pose proof u_positive. nra.
Qed.

Lemma must_move_moves : must_move ms strict (forms it) gens rays = true ->
  0 < Rows.size (Rows.weights r) (Rows.slip r d).
Proof.
  intros M. rewrite size_is. pose proof (sqrt_lt_R0 _ mu_unit_positive) as U.
  destruct (Rle_lt_or_eq_dec 0 _ (Rows.size_nonneg G (Rows.slip r d))) as [H|Zero];
    [now apply Rmult_lt_0_compat|]. exfalso. symmetry in Zero.
  unfold must_move in M. rewrite forallb_forall in M.
  destruct (heavy_tip (forms it) ss (shares_valid b r p F mu st I)) as (t0 & Ht & Heavy).
  specialize (M t0 Ht). apply opposed_barred_is in M.
  set (rs := map (fun q => (slip_at t0 (motion_of q), q)) rays) in *.
  destruct (opposed_is ms gens [] rs (Forall_nil _)) as [Sub Out].
  refine (not_barred strict rays x rays_know strict_at_x ws spanned (opposed ms gens [] rs) _ M _).
  - intros q Hq. destruct (Sub q Hq) as (s & H). unfold rs in H.
    apply in_map_iff in H as (q' & E & H). injection E as _ <-. exact H.
  - assert (Z0 : forall e, in_dual ms gens e ->
      Forall (fun wq => fst wq = 0 \/ product (real (slip_at t0 (ray_motion (snd wq)))) e = 0) ws).
    { intros e D. apply (sum_over_zero (fun q => product (real (slip_at t0 (ray_motion q))) e)).
      - intros q Hq. apply D. now apply ray_slip.
      - rewrite <- product_rays. apply (Heavy (fun t => product (slip_of t d) e)).
        + intros t1 Ht1. rewrite product_rays. apply sums_nonpos; [exact W|]. intros q Hq. apply D.
          now apply ray_slip.
        + pose proof (slip_corners e d) as E. rewrite <- forms_are in E.
          rewrite (Rows.size_zero G _ e metric_positive Zero) in E. pose proof u_positive.
          apply Rmult_eq_reg_l with u; [|lra]. rewrite <- E. ring. }
    apply Forall_forall. intros [w q] Hwq. cbn.
    pose proof W as W0. unfold weights in W0. rewrite Forall_forall in W0. destruct (W0 _ Hwq) as [_ Hq].
    cbn in Hq. apply in_map_iff in Hq as (q' & <- & Hq).
    destruct (Out (slip_at t0 (motion_of q')) q') as [H|(e & SC & P)].
    { unfold rs. apply in_map_iff. now exists q'. }
    + right. now exists q'.
    + left. pose proof (Z0 _ (nowhere_along_dual ms _ _ SC)) as Fz. rewrite Forall_forall in Fz.
      destruct (Fz _ Hwq) as [E|E]; [exact E|]. exfalso. cbn [snd] in E.
      apply IZR_lt in P. rewrite inner_is, product_negative in P.
      change (motion_of q') with (ray_motion (coordinates q')) in P. fold G in P. lra.
Qed.

Lemma unit_of_is sc : (0 < over sc)%Z -> Q2R (unit_of sc) = unit sc.
Proof. intros O. unfold unit_of, Q2R, unit; cbn. rewrite Z2Pos.id by exact O. reflexivity. Qed.

Lemma size_integers z : Rows.size (Rows.weights r) (real z) = sqrt mu_unit * sqrt (IZR (inner_of ms z z)).
Proof. rewrite size_is. unfold Rows.size. now rewrite (inner_is ms). Qed.

(* A length is at most the mean of those at the corners. *)
Lemma size_corners d' : Rows.size (Rows.weights r) (Rows.slip r d') <=
  u * eval (fun t0 => Rows.size (Rows.weights r) (slip_of t0 d')) (corner_forms b) ss.
Proof.
  pose proof (weights_positive _ _ _ _ _ _ I) as WP. pose proof u_positive as UP.
  pose proof (shares_valid b r p F mu st I) as SV.
  set (t := Rows.slip r d'). pose proof (Rows.size_nonneg (Rows.weights r) t) as T0.
  assert (E0 : 0 <= eval (fun t0 => Rows.size (Rows.weights r) (slip_of t0 d')) (corner_forms b) ss)
    by (apply eval_least; [exact SV|]; intros; apply Rows.size_nonneg).
  destruct (Rle_lt_or_eq_dec 0 _ T0) as [P|Z]; [|rewrite <- Z; apply Rmult_le_pos; lra].
  apply Rmult_le_reg_r with (Rows.size (Rows.weights r) t); [exact P|].
  rewrite Rows.size_square by exact WP. rewrite product_is. unfold t at 1. rewrite slip_corners. fold t.
  replace (mu_unit * (u * eval (fun t0 => product (slip_of t0 d') t) (corner_forms b) ss))
    with (u * eval (fun t0 => mu_unit * product (slip_of t0 d') t) (corner_forms b) ss) by (rewrite eval_multiple; ring).
  rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. rewrite Rmult_comm, <- eval_multiple.
  assert (D : 0 <= eval (fun t0 => Rows.size (Rows.weights r) t * Rows.size (Rows.weights r) (slip_of t0 d') +
    -1 * (mu_unit * product (slip_of t0 d') t)) (corner_forms b) ss).
  { apply eval_least; [exact SV|]. intros t0 _. rewrite <- product_is.
    pose proof (Rows.product_bound _ (slip_of t0 d') t WP). lra. }
  rewrite eval_sum, eval_multiple with (c := -1) in D. lra.
Qed.

(* What friction can do at a mu, in reals: C is what is left out. *)
Lemma friction_work_above scale (along : bool * Z * Z) zz C mq : 0 <= C -> C * C = Q2R scale -> (0 <= zz)%Z ->
  let '(below, n, den) := along in
  (0 <= n)%Z -> (0 < den)%Z ->
  Q2R mq * (C * ((if below then -1 else 1) * sqrt (IZR n / IZR den) + 3 / 2 * Q2R (slack it) * sqrt (IZR zz)))
  <= Q2R (friction_work it scale along zz mq).
Proof.
  destruct along as [[below n] den]. intros C0 CE Z0 N0 D0. unfold friction_work.
  set (c := (mq * mq * scale)%Q). set (q := (c * (n # Z.to_pos den))%Q).
  apply IZR_le in N0, Z0. apply IZR_lt in D0 as D0'.
  assert (FR : Q2R (n # Z.to_pos den) = IZR n / IZR den) by (unfold Q2R; cbn; now rewrite Z2Pos.id).
  assert (FN : 0 <= IZR n / IZR den).
  { apply Rmult_le_pos; [exact N0|]. left. now apply Rinv_0_lt_compat. }
  set (root := sqrt (IZR n / IZR den)) in *. assert (R0 : 0 <= root) by apply sqrt_pos.
  assert (CQ : Q2R c = (Rabs (Q2R mq) * C) * (Rabs (Q2R mq) * C)).
  { unfold c. rewrite !Q2R_mult, <- CE. transitivity (Rabs (Q2R mq) * Rabs (Q2R mq) * (C * C)); [|ring].
    rewrite <- Rabs_mult, Rabs_right by (apply Rle_ge, Rle_0_sqr). reflexivity. }
  assert (MC : 0 <= Rabs (Q2R mq) * C) by (apply Rmult_le_pos; [apply Rabs_pos|exact C0]).
  assert (Sq : forall e, 0 <= e -> sqrt (Q2R c * e) = Rabs (Q2R mq) * C * sqrt e).
  { intros e E. rewrite CQ, sqrt_mult_alt by apply Rle_0_sqr. now rewrite sqrt_square. }
  assert (QE : Q2R q = Q2R c * (IZR n / IZR den)) by (unfold q; now rewrite Q2R_mult, FR).
  assert (QP : 0 <= Q2R q) by (rewrite QE, CQ; apply Rmult_le_pos; [apply Rle_0_sqr|exact FN]).
  pose proof (root_above_is q QP) as RA. pose proof (root_below_is q QP) as RB.
  rewrite QE, Sq in RA, RB by exact FN. fold root in RA, RB.
  assert (Abs : - (Rabs (Q2R mq) * C * root) <= Q2R mq * (C * root) <= Rabs (Q2R mq) * C * root).
  { pose proof (Rle_abs (Q2R mq)). pose proof (Rle_abs (- Q2R mq)) as A2. rewrite Rabs_Ropp in A2.
    assert (0 <= C * root) by (apply Rmult_le_pos; assumption).
    split; [apply Rle_trans with (- Rabs (Q2R mq) * (C * root)); [lra|]|apply Rle_trans with (Rabs (Q2R mq) * (C * root)); [|lra]];
      apply Rmult_le_compat_r; lra. }
  set (along := if below && Qle_bool 0 mq then (- root_below q)%Q else root_above q).
  assert (A : Q2R mq * (C * ((if below then -1 else 1) * root)) <= Q2R along).
  { unfold along. destruct below; cbn [andb].
    - destruct (Qle_bool 0 mq) eqn:MP; [|lra]. apply Qle_bool_R in MP. rewrite Q2R_0 in MP.
      rewrite Q2R_opp. rewrite (Rabs_right (Q2R mq)) in RB by lra. lra.
    - lra. }
  assert (K0 : 0 <= Q2R (slack it)) by apply (slack_nonneg _ _ _ _ _ _ I).
  destruct (Qle_bool (slack it) 0) eqn:Sk.
  - apply Qle_bool_R in Sk. rewrite Q2R_0 in Sk. replace (Q2R (slack it)) with 0 by lra. lra.
  - rewrite Q2R_plus, !Q2R_mult. replace (Q2R (3 # 2)) with (3 / 2) by (unfold Q2R; cbn; lra).
    assert (J : Q2R (inject_Z zz) = IZR zz) by (unfold Q2R; cbn; field).
    assert (ZP : 0 <= Q2R (c * inject_Z zz)).
    { rewrite Q2R_mult, J, CQ. apply Rmult_le_pos; [apply Rle_0_sqr|exact Z0]. }
    pose proof (root_above_is _ ZP) as RZ. rewrite Q2R_mult, J, Sq in RZ by exact Z0.
    pose proof (sqrt_pos (IZR zz)) as S0. set (len := sqrt (IZR zz)) in *.
    assert (M : Q2R mq * (C * len) <= Q2R (root_above (c * inject_Z zz))).
    { eapply Rle_trans; [|exact RZ]. rewrite Rmult_assoc. apply Rmult_le_compat_r; [now apply Rmult_le_pos|apply Rle_abs]. }
    apply Rle_trans with (Q2R along + 3 / 2 * Q2R (slack it) * (Q2R mq * (C * len))); [lra|].
    apply Rplus_le_compat_l. apply Rmult_le_compat_l; lra.
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

(* What friction can do on y, at a corner; e is the work over rho a, on slips in reals. *)
Lemma corner_bound (moves : bool) k t0 (e : R) : 0 <= k <= Q2R (slack it) ->
  let s := Rows.slip r d in
  let z := slip_at t0 y in
  let len := Rows.size (Rows.weights r) (real z) in
  (moves = true -> 0 < Rows.size (Rows.weights r) s) ->
  e <= (if moves then - Rows.product (Rows.weights r) s (real z) / Rows.size (Rows.weights r) s else len) + 3 / 2 * k * len ->
  u * Q2R factor * IZR (dot (nth 0 t0 []) y) + Rows.rho r * (u * Q2R factor * e)
  <= Q2R (corner_alpha it factor y gens moves t0).
Proof.
  intros K s z len Hm He. unfold corner_alpha. fold z ms.
  set (zz := inner_of ms z z).
  set (along := if moves then most_along ms gens z else (false, zz, 1%Z)).
  pose proof u_positive as UP. pose proof mu_unit_positive as MU. pose proof metric_positive as MP0.
  set (um := sqrt mu_unit). assert (UM : 0 < um) by now apply sqrt_lt_R0.
  assert (UM2 : um * um = mu_unit) by (apply sqrt_sqrt; lra).
  assert (ZZ : IZR zz = product (real z) (real z)) by apply inner_is.
  assert (Z0 : (0 <= zz)%Z) by (apply le_IZR; rewrite ZZ; now apply Rows.product_nonneg).
  assert (LE : len = um * sqrt (IZR zz)) by apply size_integers.
  (* the work along the cone, by its sign *)
  assert (B : let '(below, n, den) := along in (0 <= n)%Z /\ (0 < den)%Z /\
    (if moves then - Rows.product (Rows.weights r) s (real z) / Rows.size (Rows.weights r) s else len)
    <= um * ((if below then -1 else 1) * sqrt (IZR n / IZR den))).
  { unfold along. destruct moves.
    - specialize (Hm eq_refl). pose proof (most_along_bound ms MP0 gens z _ slip_in_cone) as Mo.
      destruct (most_along ms gens z) as [[below n] den]. destruct Mo as (N0 & D0 & Mo).
      split; [exact N0|]. split; [exact D0|]. fold s in Mo.
      rewrite size_is in *. rewrite product_is, Rows.product_sym. fold um. change (sqrt mu_unit) with um in Hm.
      set (S := Rows.size G s) in *.
      assert (SP : 0 < S) by (apply Rnot_le_lt; intros N; assert (0 <= um * - S) by (apply Rmult_le_pos; lra); lra).
      rewrite <- UM2. replace (- (um * um * product (real z) s) / (um * S)) with (um / S * - product (real z) s)
        by (field; lra).
      apply Rle_trans with (um / S * ((if below then -1 else 1) * sqrt (IZR n / IZR den) * S)).
      + apply Rmult_le_compat_l; [|exact Mo]. apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
      + right. field. lra.
    - split; [exact Z0|]. split; [lia|]. rewrite LE. right. replace (IZR zz / IZR 1) with (IZR zz) by field. ring. }
  destruct along as [[below n] den] eqn:Al. destruct B as (N0 & D0 & B).
  set (U := u * Q2R factor) in *. assert (UP' : 0 < U) by (apply Rmult_lt_0_compat; assumption).
  change (box it) with b. set (uq := (unit_of (forms_scale it) * factor)%Q).
  assert (UQ : Q2R uq = U).
  { unfold uq, it. cbn [forms_scale make_row]. rewrite unsigned.
    rewrite Q2R_mult, unit_of_is; [reflexivity|]. apply common_denominator_positive. }
  assert (MQ : Q2R (unit_of (metric_scale it)) = mu_unit)
    by (apply unit_of_is; apply common_denominator_positive).
  set (scale := (box_square b * unit_of (metric_scale it) * (uq * uq))%Q).
  set (lb := sqrt (Q2R (box_square b))). assert (L0 : 0 <= lb) by apply sqrt_pos.
  assert (LL : lb * lb = Q2R (box_square b)) by (apply sqrt_sqrt; apply (square_nonneg _ _ _ _ _ _ I)).
  set (C := lb * um * U). assert (C0 : 0 <= C) by (unfold C; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
  assert (CE : C * C = Q2R scale).
  { unfold scale, C. rewrite !Q2R_mult, UQ, MQ, <- LL, <- UM2. ring. }
  pose proof (in_friction _ _ _ _ _ _ I) as Wf. pose proof (friction_nonneg _ _ _ _ _ _ I) as M0.
  rewrite reduced_same, Q2R_plus, Q2R_mult, UQ.
  replace (Q2R (inject_Z (dot (nth 0 t0 []) y))) with (IZR (dot (nth 0 t0 []) y))
    by (unfold Q2R; cbn; field).
  apply Rplus_le_compat_l. rewrite (is_rho _ _ _ _ _ _ I). fold lb.
  set (top := (C * ((if below then -1 else 1) * sqrt (IZR n / IZR den) + 3 / 2 * Q2R (slack it) * sqrt (IZR zz)))).
  assert (Top : mu * top <= Q2R (largest_q (map (friction_work it scale (below, n, den) zz) (ends (box_friction b))))).
  { replace (mu * top) with (0 + top * mu) by ring. apply at_ends with (box_friction b); [exact Wf|].
    intros q Hq. replace (0 + top * Q2R q) with (Q2R q * top) by ring.
    eapply Rle_trans; [apply (friction_work_above scale (below, n, den) zz C q C0 CE Z0 N0 D0)|].
    apply largest_q_above. now apply in_map. }
  eapply Rle_trans; [|exact Top]. replace (mu * lb * (U * e)) with (mu * (lb * U * e)) by ring.
  apply Rmult_le_compat_l; [exact M0|]. unfold top, C.
  replace (lb * um * U * ((if below then -1 else 1) * sqrt (IZR n / IZR den) + 3 / 2 * Q2R (slack it) * sqrt (IZR zz)))
    with (lb * U * (um * ((if below then -1 else 1) * sqrt (IZR n / IZR den)) + 3 / 2 * Q2R (slack it) * (um * sqrt (IZR zz))))
    by ring.
  apply Rmult_le_compat_l; [apply Rmult_le_pos; lra|]. rewrite <- LE.
  assert (0 <= len) by (rewrite LE; apply Rmult_le_pos; [lra|apply sqrt_pos]).
  assert (3 / 2 * k * len <= 3 / 2 * Q2R (slack it) * len) by (apply Rmult_le_compat_r; lra). lra.
Qed.

Theorem force_bound (slipping : bool) k a phi : work_within r k a d yv phi -> 0 <= a -> 0 <= k <= Q2R (slack it) ->
  (slipping = true -> 0 < Rows.size (Rows.weights r) (Rows.slip r d)) ->
  a * Rows.dot (Rows.N r) yv + phi <= a * Q2R (alpha strict rays slipping it factor y).
Proof.
  intros [Cone Against] A0 K HS.
  set (s := Rows.slip r d) in *. set (t := Rows.slip r yv) in *. set (W' := Rows.weights r) in *.
  set (frictionless := Qeq_bool (high (box_friction (box it))) 0).
  set (moves := negb frictionless && (slipping || must_move ms strict (forms it) gens rays)).
  set (top := largest_q (map (corner_alpha it factor y gens moves) (tips (forms it)))).
  assert (AE : Q2R (alpha strict rays slipping it factor y) = Q2R top / Q2R factor).
  { assert (E : alpha strict rays slipping it factor y = reduced (top / factor)).
    { unfold alpha. fold frictionless. fold gens. fold ms. unfold top, moves.
      destruct frictionless; reflexivity. }
    rewrite E, reduced_same, Q2R_div; [reflexivity|].
    intros Z. apply Qeq_eqR in Z. rewrite Q2R_0 in Z. lra. }
  assert (MV : moves = true -> 0 < Rows.size W' s).
  { unfold moves. intros M. apply andb_true_iff in M as [_ M]. apply orb_true_iff in M as [M|M].
    - auto.
    - now apply must_move_moves. }
  rewrite AE. apply Rmult_le_reg_l with (Q2R factor); [exact factor_positive|].
  replace (Q2R factor * (a * (Q2R top / Q2R factor))) with (a * Q2R top) by (field; lra).
  pose proof (shares_valid b r p F mu st I) as SV. pose proof u_positive as UP.
  assert (RP : 0 <= Rows.rho r).
  { rewrite (is_rho _ _ _ _ _ _ I). apply Rmult_le_pos; [apply (friction_nonneg _ _ _ _ _ _ I)|apply sqrt_pos]. }
  (* over rho a, at a corner *)
  set (e := fun t0 => let z := real (slip_at t0 y) in
    (if moves then - Rows.product W' s z / Rows.size W' s else Rows.size W' z) + 3 / 2 * k * Rows.size W' z).
  assert (LE := size_corners yv). rewrite <- forms_are in LE. fold W' t in LE.
  assert (Len : Rows.size W' t <= u * eval (fun t0 => Rows.size W' (real (slip_at t0 y))) (forms it) ss).
  { eapply Rle_trans; [exact LE|]. right. f_equal. apply eval_same. intros t0 _. unfold yv. now rewrite slip_of_integers. }
  assert (Phi : phi <= Rows.rho r * a * (u * eval e (forms it) ss)).
  { assert (Ev : u * eval e (forms it) ss =
      (if moves then - Rows.product W' s t / Rows.size W' s
       else u * eval (fun t0 => Rows.size W' (real (slip_at t0 y))) (forms it) ss) +
      3 / 2 * k * (u * eval (fun t0 => Rows.size W' (real (slip_at t0 y))) (forms it) ss)).
    { unfold e. cbv zeta. rewrite eval_sum, eval_multiple. destruct moves; [|ring].
      rewrite (eval_same (fun t0 => - Rows.product W' s (real (slip_at t0 y)) / Rows.size W' s)
        (fun t0 => - / Rows.size W' s * (mu_unit * product (slip_of t0 yv) s))).
      - rewrite !eval_multiple. rewrite (Rows.product_sym W' s t). unfold W' at 1, t. rewrite product_is, slip_corners, <- forms_are.
        fold W'. unfold Rdiv. ring.
      - intros t0 _. unfold yv. rewrite slip_of_integers. unfold W' at 1. rewrite product_is, Rows.product_sym.
        fold W'. unfold Rdiv. ring. }
    rewrite Ev. assert (RA : 0 <= Rows.rho r * a) by now apply Rmult_le_pos.
    set (E := u * eval (fun t0 => Rows.size W' (real (slip_at t0 y))) (forms it) ss) in *.
    destruct moves.
    - eapply Rle_trans; [apply Against, MV; reflexivity|]. apply Rmult_le_compat_l; [exact RA|].
      apply Rplus_le_compat_l. apply Rmult_le_compat_l; [lra|exact Len].
    - eapply Rle_trans; [exact Cone|]. apply Rmult_le_compat_l; [exact RA|].
      replace (E + 3 / 2 * k * E) with ((1 + 3 / 2 * k) * E) by ring. apply Rmult_le_compat; [lra|apply Rows.size_nonneg|lra|exact Len]. }
  rewrite N_corners, <- forms_are.
  apply Rle_trans with (a * eval (fun t0 => u * Q2R factor * IZR (dot (nth 0 t0 []) y) + Rows.rho r * (u * Q2R factor * e t0))
    (forms it) ss).
  - rewrite eval_sum, !eval_multiple.
    rewrite (eval_same (fun t0 => IZR (dot (nth 0 t0 []) y)) (fun t0 => rdot (nth 0 t0 []) yv))
      by (intros; unfold yv; now rewrite rdot_integers).
    apply (Rmult_le_compat_l (Q2R factor)) in Phi; [|lra]. rewrite Rmult_plus_distr_l.
    match goal with |- Q2R factor * (a * (u * ?A)) + _ <= _ => set (NN := A) in * end.
    eapply Rle_trans; [apply Rplus_le_compat_l; exact Phi|]. right.
    match goal with |- _ + _ * (_ * (_ * ?A0)) = _ * (_ + _ * (_ * ?B0)) => change B0 with A0; generalize A0 end.
    generalize NN (Rows.rho r) u (Q2R factor). intros. ring.
  - apply Rmult_le_compat_l; [exact A0|]. apply eval_most; [exact SV|]. intros t0 Ht.
    eapply Rle_trans; [apply (corner_bound moves k t0 (e t0) K MV); apply Rle_refl|].
    apply largest_q_above. now apply in_map.
Qed.

(* ---- The term of alpha ---- *)

Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.
Notation bound t := (over_rays (value t) ws).
Let v := Rows.v r d h l.
Let p_unit := unit (pull_scaling b).

(* m alpha max(0, v) is at most the term. *)
Lemma alpha_term_bound al (mixed : bool) a : a = Rmax 0 v ->
  (mixed = false -> 0 <= v) ->
  IZR m * (a * Q2R al) <= bound (alpha_term m al mixed it).
Proof.
  intros Ha Closed. assert (PU : 0 < p_unit) by apply pull_unit. apply IZR_lt in m_positive as MP.
  assert (OP : (0 < over (pull_scale it))%Z) by apply common_denominator_positive.
  assert (TP : (0 < times (pull_scale it))%Z) by apply content_positive.
  set (n := (m * Qnum al * times (pull_scale it))%Z).
  set (den := (Zpos (Qden al) * over (pull_scale it))%Z).
  assert (DP : (0 < den)%Z) by (unfold den; lia).
  apply IZR_lt in DP as DP'. apply IZR_lt in OP as OP'.
  assert (QD : 0 < IZR (Zpos (Qden al))) by (apply IZR_lt; lia).
  assert (FE : IZR n / IZR den = IZR m * Q2R al * p_unit).
  { unfold n, den, p_unit, unit, Q2R. rewrite !mult_IZR. change (pull_scale it) with (pull_scaling b).
    field. change (pull_scale it) with (pull_scaling b) in OP'. lra. }
  pose proof (nothing_bound ws) as B0.
  assert (A0 : 0 <= a) by (rewrite Ha; apply Rmax_l).
  assert (Sign : Q2R al <= 0 -> IZR m * (a * Q2R al) <= 0).
  { intros N. assert (a * Q2R al <= 0) by nra. nra. }
  (* If it presses, a = v. *)
  assert (Press : forall U, 0 <= U \/ mixed = false -> (0 <= v -> IZR m * Q2R al * v <= U) ->
    IZR m * (a * Q2R al) <= U).
  { intros U U0 H. destruct (Rle_dec 0 v) as [V|V].
    - rewrite Ha, Rmax_right by exact V. replace (IZR m * (v * Q2R al)) with (IZR m * Q2R al * v) by ring.
      auto.
    - destruct U0 as [U0|E]; [|specialize (Closed E); lra].
      rewrite Ha, Rmax_left by lra. lra. }
  assert (General : forall vs, vs = pull_tips it ->
    IZR m * (a * Q2R al) <= bound (if mixed && (Qnum al <=? 0)%Z then Nothing
      else Bend (m * times (pull_scale it)) den (map (map (Z.mul (Qnum al))) vs) mixed)).
  { intros vs ->. destruct (mixed && (Qnum al <=? 0)%Z) eqn:C.
    - apply andb_true_iff in C as [_ C]. apply Z.leb_le, IZR_le in C. rewrite B0. apply Sign.
      unfold Q2R. assert (0 < / IZR (Zpos (Qden al))) by now apply Rinv_0_lt_compat. nra.
    - apply Press.
      + destruct mixed; [left|now right]. apply (mixed_bound_nonneg rays ws W); [nia|exact DP].
      + intros V. apply (v_bound d h l b r p F mu st I). intros f Hf. fold p_unit x.
        eapply Rle_trans; [|apply (bend_bound rays x ws W spanned _ _ _ _ (map (Z.mul (Qnum al)) f));
          [nia|exact DP|now apply in_map]].
        right. rewrite <- FE, rdot_scaled. unfold n. rewrite !mult_IZR. unfold Rdiv. ring. }
  unfold alpha_term. fold n den. destruct (pull_tips it) as [|v0 [|v1 vs]] eqn:PT;
    try (apply General; reflexivity).
  pose proof (up_above n den DP) as UA. rewrite FE in UA. set (k := up n den) in *.
  assert (VE : v = p_unit * rdot v0 x) by (apply (v_of_one d h l b r p F mu st I); exact PT).
  assert (One : 0 <= v -> IZR m * Q2R al * v <= IZR k * rdot v0 x).
  { intros V. assert (0 <= rdot v0 x) by nra. rewrite VE, <- Rmult_assoc. now apply Rmult_le_compat_r. }
  destruct mixed.
  - destruct (Z.leb_spec k 0) as [K|K].
    + apply IZR_le in K. rewrite B0. apply Sign. apply Rnot_lt_le. intros P.
      assert (0 < IZR m * Q2R al * p_unit) by (apply Rmult_lt_0_compat; [apply Rmult_lt_0_compat|]; assumption). lra.
    + apply Press; [left; apply (mixed_bound_nonneg rays ws W); lia|]. intros V.
      eapply Rle_trans; [exact (One V)|].
      replace (IZR k) with (IZR k / IZR 1) by (field; lra).
      apply (bend_bound rays x ws W spanned); [lia|lia|now left].
  - rewrite (line_bound x ws spanned). apply Press; [now right|]. exact One.
Qed.

End Contact.
