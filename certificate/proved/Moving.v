(* SPDX-License-Identifier: MIT *)
(* The leaf whose twist moves (FORMAT.md section 4): y(x) = c d + h y, with a number kappa and a slip psi of each
   contact.  `moving_refutes`: where such a leaf holds, no equilibrium is at home.  At most what all forces do of
   work on y(x) is a sum over pairs of rays, as a force and y(x) both are sums over rays.

   y, c, kappa and psi are integers here, all divided by one factor. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Slips Leaf.
From Proved Require Rows Degree.
Import ListNotations.

Section Checker.
Open Scope Z_scope.

Definition h_of (q : form) : Z := nth 0 q 0.

(* y at a ray. *)
Definition twist_at (c : Z) (y : form) (q : form) : form := combine c (ray_motion q) (h_of q) y.

(* ---- The contacts of the list ---- *)

(* How much friction can do, over mu a and over u: as FORMAT.md says, by bounds of roots of u^2 L^2 times a square; or,
   which is tried first, by short numbers that are not smaller than these, which are less than a part in 2^62 from the
   roots. *)
Inductive measure := Exactly (u scale aside stretch : Q) | Shortly (most least length : Z).

Definition exact_measure (row : row) (u : Q) : measure :=
  let unit := unit_of (metric_scale row) in
  let scale := reduced (box_square (box row) * unit * (u * u))%Q in
  Exactly u scale (reduced (scale * unit)%Q) (reduced (1 + (1 # 2) * slack row)%Q).

(* Times 2^bits, rounded up. *)
Definition shifted (bits : Z) (q : Q) : Z := up (Z.shiftl (Qnum q) bits) (Zpos (Qden q)).

Definition short_measure (row : row) : measure :=
  let unit := unit_of (metric_scale row) in
  let scale := reduced (box_square (box row) * unit)%Q in
  let aside := reduced (scale * unit)%Q in
  let part := Qmake 1 (Z.to_pos (Z.shiftl 1 60)) in
  Shortly (shifted 96 ((1 + part) * root_above aside)%Q) (- shifted 96 (- ((1 - part) * root_below aside))%Q)
    (shifted 64 ((1 + part) * (1 + (1 # 2) * slack row) * root_above scale)%Q).

(* Of <psi, s> and |t|^2, in integers. *)
Definition friction_within (m : measure) (p square : Z) : Q :=
  match m with
  | Exactly u scale aside stretch =>
      let along := (aside * inject_Z (p * p))%Q in
      (((if p <? 0 then - root_below along else root_above along) + stretch * root_above (scale * inject_Z square)) / u)%Q
  | Shortly most least length =>
      Qmake (p * (if p <? 0 then least else most) + length * (Z.sqrt (Z.shiftl square 64) + 1))
        (Z.to_pos (Z.shiftl 1 96))
  end.

(* A contact that presses, or that may (`may_open`): its forms at the corners, kappa and psi. *)
Record carrier := Carrier {
  carried : row; forms_scaled : scaling; at_corners : list (list form); measured : measure; kappa : Z; psi : form;
  may_open : bool
}.

Definition carrier_of (exact : bool) (factor : Q) (row : row) (kappa : Z) (psi : form) (may_open : bool) : carrier :=
  let (s, them) := if box_signed (box row) then (forms_scaling (box row), corner_forms (box row))
                   else (forms_scale row, forms row) in
  Carrier row s (tips them)
    (if exact then exact_measure row (reduced (unit_of s * factor)%Q) else short_measure row) kappa psi may_open.

(* |psi| <= kappa *)
Definition psi_within (row : row) (kappa : Z) (psi : form) : bool :=
  (0 <=? kappa) &&
  (times (metric_scale row) * inner_of (metric row) psi psi <=? over (metric_scale row) * (kappa * kappa)).

(* What the list has for the contact of a number, the rest of it, and whether that is as it should be. *)
Definition stated (row : row) (number : Z) (them : list (Z * (Z * form))) : Z * form * list (Z * (Z * form)) * bool :=
  match them with
  | (i, (kappa, psi)) :: them' =>
      if i =? number then (kappa, psi, them', has_friction (box row) && psi_within row kappa psi)
      else (0, [], them, true)
  | [] => (0, [], [], true)
  end.

(* None if the list is not as it should be.  A spring's geometry is certain. *)
Fixpoint carriers (exact : bool) (factor : Q) (rays : list ray) (them : list (Z * (Z * form))) (rows : list row) (number : Z)
    (before : list carrier) : option (list carrier) :=
  match rows with
  | [] => match them with [] => Some before | _ => None end
  | row :: rows' =>
      let '(kappa, psi, others, good) := stated row number them in
      if good && (negb (box_spring (box row)) || Nat.eqb (parameters row) 0) then
        let vs := pull_tips row in
        let it := carrier_of exact factor row kappa psi in
        carriers exact factor rays others rows' (number + 1)
          (if box_spring (box row) || forallb (nowhere_negative rays) vs then it false :: before
           else if forallb (nowhere_positive rays) vs then before
           else it true :: before)
      else None
  end.

(* ---- Work at a ray ---- *)

(* At a corner: the most that a contact's force does on y at a ray, over its a and over u. *)
Definition corner_work (it : carrier) (yq d : form) (t : list form) : Q :=
  let row := carried it in
  let along := inject_Z (dot (nth 0 t []) yq) in
  if box_spring (box row) then along
  else
    let z := slip_at t (combine 1 yq (- kappa it) d) in
    let friction := friction_within (measured it) (inner_of (metric row) (psi it) (slip_at t d)) (inner_of (metric row) z z) in
    (along + largest_q (map (fun mu => mu * friction) (ends (box_friction (box row)))))%Q.

(* A of FORMAT.md. *)
Definition most_work (it : carrier) (factor : Q) (yq d : form) : Q :=
  let u := reduced (unit_of (forms_scaled it) * factor)%Q in
  reduced (u * largest_q (map (corner_work it yq d) (at_corners it)))%Q.

(* Times the factor of the numbers by which v is known. *)
Definition scaled_work (c : Z) (y : form) (factor : Q) (q : form) (it : carrier) : Q :=
  reduced (unit_of (pull_scale (carried it)) * most_work it factor (twist_at c y q) (ray_motion q))%Q.

Definition load_work (ld : load) (c : Z) (y : form) (factor : Q) (q : form) : Q :=
  reduced (high (work_of ld (map (fun z => factor * inject_Z z)%Q (twist_at c y q)))).

Definition all_works (ld : load) (c : Z) (y : form) (factor : Q) (cs : list carrier) (q : form) : list Q :=
  load_work ld c y factor q :: map_all (scaled_work c y factor q) cs.

(* ---- Pairs of rays ---- *)

(* A contact at a ray: the least and the largest v, and A. *)
Record press := Press { opens : bool; least_pull : Z; most_pull : Z; effort : Z }.

Definition press_of (q : form) (it : carrier) (work : Z) : press :=
  let vs := map (fun f => dot f q) (pull_tips (carried it)) in
  Press (may_open it) (- largest (map Z.opp vs)) (largest vs) work.

(* v at the one ray times A at the other. *)
Definition pressed (a b : press) : Z :=
  if opens a then Z.max 0 (most_pull a) * Z.max 0 (effort b)
  else (if 0 <? effort b then most_pull a else least_pull a) * effort b.

Fixpoint presses_of (q : form) (cs : list carrier) (works : list Z) : list press :=
  match cs, works with it :: cs', w :: works' => press_of q it w :: presses_of q cs' works' | _, _ => [] end.

Fixpoint pressed_all (a b : list press) (sum : Z) : Z :=
  match a, b with x :: a', y :: b' => pressed_all a' b' (sum + pressed x y) | _, _ => sum end.

Record at_ray := AtRay { the_ray : ray; at_h : Z; load_effort : Z; presses : list press }.

Definition at_ray_of (cs : list carrier) (r : ray) (works : list Z) : at_ray :=
  match works with
  | load :: works' => AtRay r (h_of (coordinates r)) load (presses_of (coordinates r) cs works')
  | [] => AtRay r 0 0 []
  end.

Definition work_between (a b : at_ray) : Z := pressed_all (presses a) (presses b) (at_h a * load_effort b).

(* B of FORMAT.md, twice, and times a factor. *)
Definition bound_of (a b : at_ray) : Z := work_between a b + work_between b a.

Fixpoint all_pairs {A : Type} (test : A -> A -> bool) (l : list A) : bool :=
  match l with [] => true | a :: l' => forallb (test a) l && all_pairs test l' end.

Definition moving_holds (strict : list (list form)) (rays : list ray) (ld : load) (c : Z) (y : form) (factor : Q)
    (cs : list carrier) : bool :=
  let works := map (fun r => (r, all_works ld c y factor cs (coordinates r))) rays in
  let s := scaling_of (concat (map snd works)) in
  let them := map (fun p => at_ray_of cs (fst p) (map_all (to_integer s) (snd p))) works in
  all_pairs (fun a b => bound_of a b <=? 0) them &&
  barred strict (map the_ray (filter (fun a => bound_of a a =? 0) them)).

(* ---- The direction of a proof by degree ---- *)

(* y(r) . A e(r') + y(r') . A e(r) >= 0 *)
Definition direction_holds (rays : list ray) (c : Z) (y : form) (a : matrix) : bool :=
  let rows := map (map (to_integer (scaling_of (concat a)))) a in
  all_pairs (fun p q => 0 <=? dot (fst p) (snd q) + dot (fst q) (snd p))
    (map (fun r => (twist_at c y (coordinates r), map (fun f => dot f (coordinates r)) rows)) rays).

End Checker.

(* ---- Proofs ---- *)

Section Sums.
Open Scope R_scope.

Variable ws : list (R * form).

Lemma sum_same H K : (forall q, H q = K q) -> sum_over H ws = sum_over K ws.
Proof. intros E. induction ws as [|[w q] l IH]; cbn; [reflexivity|]. now rewrite IH, E. Qed.

Lemma sum_plus H K : sum_over (fun q => H q + K q) ws = sum_over H ws + sum_over K ws.
Proof. induction ws as [|[w q] l IH]; cbn; [ring|]. rewrite IH. ring. Qed.

Lemma sum_times c H : sum_over (fun q => c * H q) ws = c * sum_over H ws.
Proof. induction ws as [|[w q] l IH]; cbn; [ring|]. rewrite IH. ring. Qed.

Lemma sum_zero : sum_over (fun _ => 0) ws = 0.
Proof. induction ws as [|[w q] l IH]; cbn; [reflexivity|]. rewrite IH. ring. Qed.

Variable rays : list form.
Hypothesis W : weights rays ws.

Lemma sum_le H K : (forall q, In q rays -> H q <= K q) -> sum_over H ws <= sum_over K ws.
Proof.
  intros L. induction W as [|[w q] l [Hw Hq] Wl IH]; cbn; [lra|]. cbn in Hw, Hq.
  specialize (IH Wl). pose proof (Rmult_le_compat_l _ _ _ Hw (L q Hq)). lra.
Qed.

Lemma sum_nonneg H : (forall q, In q rays -> 0 <= H q) -> 0 <= sum_over H ws.
Proof. intros L. rewrite <- sum_zero. now apply sum_le. Qed.

Lemma sum_total f : sum_over (fun q => IZR (dot f q)) ws = total f ws.
Proof. clear. induction ws as [|[w q] l IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

(* Of pairs. *)
Definition pairs (B : form -> form -> R) : R := sum_over (fun q => sum_over (B q) ws) ws.

Lemma pairs_plus B C : pairs (fun q q' => B q q' + C q q') = pairs B + pairs C.
Proof. unfold pairs. rewrite <- sum_plus. apply sum_same. intros q. apply sum_plus. Qed.

Lemma pairs_times c B : pairs (fun q q' => c * B q q') = c * pairs B.
Proof. unfold pairs. rewrite <- sum_times. apply sum_same. intros q. apply sum_times. Qed.

Lemma pairs_product H K : pairs (fun q q' => H q * K q') = sum_over H ws * sum_over K ws.
Proof.
  unfold pairs. rewrite Rmult_comm, <- sum_times. apply sum_same. intros q. rewrite sum_times. ring.
Qed.

Lemma pairs_le B C : (forall q q', In q rays -> In q' rays -> B q q' <= C q q') -> pairs B <= pairs C.
Proof. intros L. apply sum_le. intros q Hq. apply sum_le. intros q' Hq'. now apply L. Qed.

Lemma pairs_swap B : pairs (fun q q' => B q' q) = pairs B.
Proof.
  assert (S : forall l l', sum_over (fun q => sum_over (fun q' => B q' q) l') l =
    sum_over (fun q' => sum_over (B q') l) l').
  { intros l l'. induction l as [|[w q] l IH]; cbn [sum_over].
    - induction l' as [|[w' q'] l' IH']; cbn; [reflexivity|]. rewrite <- IH'. ring.
    - rewrite IH. clear. induction l' as [|[w' q'] l' IH']; cbn [sum_over]; [ring|]. rewrite <- IH'. ring. }
  apply S.
Qed.

(* A sum over pairs of what is not above 0 that is not below it is 0 at each ray with itself. *)
Lemma nonpos_zero H : (forall q, In q rays -> H q <= 0) -> 0 <= sum_over H ws ->
  Forall (fun wq => fst wq = 0 \/ H (snd wq) = 0) ws.
Proof.
  intros N. induction W as [|[w q] l [Hw Hq] Wl IH]; cbn; [constructor|]. intros Z. cbn in Hw, Hq.
  pose proof (N q Hq) as Nq.
  assert (S : sum_over H l <= 0).
  { clear - N Wl. induction Wl as [|[w q] l [Hw Hq] Wl IH]; cbn; [lra|]. cbn in *. specialize (N q Hq).
    pose proof (Rmult_le_pos w (- H q) Hw). lra. }
  pose proof (Rmult_le_pos w (- H q) Hw) as P. constructor; [|apply IH; [exact Wl|lra]]. cbn.
  assert (E : w * H q = 0) by lra. now apply Rmult_integral in E.
Qed.

Lemma pairs_zero B : (forall q q', In q rays -> In q' rays -> B q q' <= 0) -> 0 <= pairs B ->
  Forall (fun wq => fst wq = 0 \/ B (snd wq) (snd wq) = 0) ws.
Proof.
  intros N P.
  assert (I : forall q, In q rays -> sum_over (B q) ws <= 0).
  { intros q Hq. rewrite <- sum_zero. apply sum_le. intros q' Hq'. now apply N. }
  pose proof (nonpos_zero _ I P) as F. apply Forall_forall. intros [w q] Hin. cbn.
  assert (Hq : In q rays).
  { pose proof W as W0. unfold weights in W0. rewrite Forall_forall in W0. apply (W0 _ Hin). }
  rewrite Forall_forall in F. destruct (F _ Hin) as [E|E]; [now left|]. cbn in E.
  assert (F' : Forall (fun wq => fst wq = 0 \/ B q (snd wq) = 0) ws)
    by (apply nonpos_zero; [intros; now apply N|lra]).
  rewrite Forall_forall in F'. exact (F' _ Hin).
Qed.

End Sums.

Section Vectors.
Open Scope R_scope.

Lemma inject_real z : Q2R (inject_Z z) = IZR z.
Proof. unfold Q2R; cbn. field. Qed.

Lemma rdot_real f x : rdot f x = Rows.dot (map IZR f) x.
Proof. revert x. induction f as [|c f IH]; intros [|t x]; cbn; try reflexivity. now rewrite IH. Qed.

Lemma real_combine p a q b :
  map IZR (combine p a q b) = Rows.plus (Rows.scaled (IZR p) (map IZR a)) (Rows.scaled (IZR q) (map IZR b)).
Proof.
  assert (S : forall k l, map IZR (map (Z.mul k) l) = Rows.scaled (IZR k) (map IZR l)).
  { intros k l. unfold Rows.scaled. rewrite !map_map. apply map_ext. intros z. apply mult_IZR. }
  revert b. induction a as [|x a IH]; intros [|y b]; [reflexivity|exact (S q (y :: b))|exact (S p (x :: a))|].
  cbn [combine map]. rewrite IH, plus_IZR, !mult_IZR. reflexivity.
Qed.

Lemma dot_skipn t f k z : Rows.dot (t :: f) (skipn k z) = t * nth k z 0 + Rows.dot f (skipn (S k) z).
Proof.
  revert k. induction z as [|w z IH]; intros [|k].
  - cbn. destruct f; cbn; ring.
  - cbn. destruct f; cbn; ring.
  - cbn. ring.
  - exact (IH k).
Qed.

Lemma rdot_unit k z : rdot (repeat 0%Z k ++ [1%Z]) z = nth k z 0.
Proof.
  revert z. induction k as [|k IH]; intros [|w z]; cbn [repeat app rdot nth]; try reflexivity.
  - destruct z; ring.
  - rewrite IH. ring.
Qed.

Lemma dot_plus_right f a b : Rows.dot f (Rows.plus a b) = Rows.dot f a + Rows.dot f b.
Proof. now rewrite Degree.dot_sym, Rows.dot_plus, (Degree.dot_sym a), (Degree.dot_sym b). Qed.

Lemma dot_scaled_right f c a : Rows.dot f (Rows.scaled c a) = c * Rows.dot f a.
Proof. now rewrite Degree.dot_sym, Rows.dot_scaled, Degree.dot_sym. Qed.

(* A slip is linear. *)
Lemma product_slips W g fs a c b :
  Rows.product W g (map (fun f => Rows.dot f (Rows.plus a (Rows.scaled c b))) fs) =
  Rows.product W g (map (fun f => Rows.dot f a) fs) + c * Rows.product W g (map (fun f => Rows.dot f b) fs).
Proof.
  revert g fs. induction W as [|w W IH]; intros [|z g] [|f fs]; cbn; try ring.
  rewrite IH, dot_plus_right, dot_scaled_right. ring.
Qed.

End Vectors.

Section Moving.
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

Variables (c : Z) (y : form).
Variable factor : Q.
Hypothesis factor_positive : 0 < Q2R factor.
Let F0 := Q2R factor.

(* ---- What is linear in x ---- *)

(* A ray as a point. *)
Definition point_of (q : form) : list R := IZR (nth 0 q 0%Z) :: IZR (nth 1 q 0%Z) :: map IZR (ray_motion q).

Lemma rdot_point f q : rdot f (point_of q) = IZR (dot f q).
Proof.
  unfold point_of, ray_motion. destruct q as [|a [|b q]].
  - rewrite dot_nil_r. destruct f as [|u [|v [|w f]]]; cbn; ring.
  - destruct f as [|u [|v [|w f]]]; cbn; rewrite ?plus_IZR, ?mult_IZR; try ring.
  - cbn [nth map]. change (rdot f (map IZR (a :: b :: q)) = IZR (dot f (a :: b :: q))). apply rdot_integers.
Qed.

(* A vector is the sum of those at rays. *)
Definition summed (D : list R) (at_q : form -> list R) :=
  forall f, Rows.dot f D = sum_over (fun q => Rows.dot f (at_q q)) ws.

Lemma x_summed : summed x point_of.
Proof.
  assert (G : forall f k, Rows.dot f (skipn k x) = sum_over (fun q => Rows.dot f (skipn k (point_of q))) ws).
  { induction f as [|t f IH]; intros k.
    - cbn. now rewrite sum_zero.
    - rewrite (sum_same ws (fun q => Rows.dot (t :: f) (skipn k (point_of q))) (fun q => t * nth k (point_of q) 0 +
        Rows.dot f (skipn (S k) (point_of q)))) by (intros; apply dot_skipn).
      rewrite dot_skipn, IH, sum_plus, sum_times. f_equal. f_equal. rewrite <- rdot_unit, spanned, <- sum_total.
      apply sum_same. intros q. now rewrite <- rdot_unit, rdot_point. }
  intros f. exact (G f 0%nat).
Qed.

Lemma d_summed : summed d (fun q => map IZR (ray_motion q)).
Proof.
  intros f. transitivity (Rows.dot (0 :: 0 :: f) x); [unfold x; cbn; ring|]. rewrite x_summed.
  apply sum_same. intros q. unfold point_of. cbn. ring.
Qed.

Lemma h_summed : h = sum_over (fun q => IZR (h_of q)) ws.
Proof.
  transitivity (Rows.dot [1] x); [unfold x; cbn; ring|]. rewrite x_summed.
  apply sum_same. intros q. unfold point_of, h_of. cbn. ring.
Qed.

Definition twist : list R := Rows.plus (Rows.scaled (IZR c) d) (Rows.scaled h (map IZR y)).

Lemma twist_summed : summed twist (fun q => map IZR (twist_at c y q)).
Proof.
  intros f. unfold twist. rewrite dot_plus_right, !dot_scaled_right, d_summed, h_summed, <- sum_times.
  rewrite (Rmult_comm (sum_over _ _)), <- sum_times, <- sum_plus. apply sum_same. intros q. unfold twist_at.
  rewrite real_combine, dot_plus_right, !dot_scaled_right. ring.
Qed.

(* y(x) - kappa d *)
Definition relative_twist (k : Z) : list R := Rows.plus twist (Rows.scaled (- IZR k) d).
Definition relative_at (k : Z) (q : form) : form := combine 1 (twist_at c y q) (- k) (ray_motion q).

Lemma relative_summed k : summed (relative_twist k) (fun q => map IZR (relative_at k q)).
Proof.
  intros f. unfold relative_twist. rewrite dot_plus_right, dot_scaled_right, twist_summed, d_summed, <- sum_times, <- sum_plus.
  apply sum_same. intros q. unfold relative_at. rewrite real_combine, dot_plus_right, !dot_scaled_right, opp_IZR. ring.
Qed.

Lemma slip_summed Wt D at_q fs e : summed D at_q ->
  Rows.product Wt (map (fun f => rdot f D) fs) e = sum_over (fun q => Rows.product Wt (map (fun f => rdot f (at_q q)) fs) e) ws.
Proof.
  intros S. revert fs e. induction Wt as [|w Wt IH]; intros [|f fs] [|z e]; cbn; try (now rewrite sum_zero).
  rewrite sum_plus, IH, rdot_real, S. f_equal.
  transitivity (sum_over (fun q => w * z * Rows.dot (map IZR f) (at_q q)) ws); [rewrite sum_times; ring|].
  apply sum_same. intros q. rewrite rdot_real. ring.
Qed.

(* A length is at most the sum of those at rays. *)
Lemma size_summed Wt D at_q fs : Rows.positive Wt -> summed D at_q ->
  Rows.size Wt (map (fun f => rdot f D) fs) <= sum_over (fun q => Rows.size Wt (map (fun f => rdot f (at_q q)) fs)) ws.
Proof.
  intros P S. set (s := map _ fs). pose proof (Rows.size_nonneg Wt s) as S0.
  destruct (Rle_lt_or_eq_dec 0 _ S0) as [Q|Z].
  - apply Rmult_le_reg_r with (Rows.size Wt s); [exact Q|]. rewrite Rows.size_square by exact P.
    unfold s at 1. rewrite (slip_summed Wt D at_q fs s S), (Rmult_comm (sum_over _ _)), <- sum_times.
    apply (sum_le ws (map coordinates rays) W). intros q _. rewrite Rmult_comm. now apply Rows.product_bound.
  - rewrite <- Z. apply (sum_nonneg ws (map coordinates rays) W). intros q _. apply Rows.size_nonneg.
Qed.

(* ---- How much friction can do ---- *)

Section Measures.

Variable b : cbox.
Hypothesis square_good : 0 <= Q2R (box_square b).
Variable k : R.
Hypothesis k_nonneg : 0 <= k.
Hypothesis slack_above : k <= Q2R (slack (make_row b)).
Let row := make_row b.
Let mu_unit := unit (metric_scale row).
Let lb := sqrt (Q2R (box_square b)).

Lemma unit_real : 0 < mu_unit /\ Q2R (unit_of (metric_scale row)) = mu_unit.
Proof. split; [apply unit_positive|]. apply unit_of_is. apply common_denominator_positive. Qed.

Lemma stretch_real : 1 + k / 2 <= Q2R (1 + (1 # 2) * slack row).
Proof.
  rewrite Q2R_plus, Q2R_mult, Q2R_1. replace (Q2R (1 # 2)) with (1 / 2) by (unfold Q2R; cbn; lra). unfold row. lra.
Qed.

Notation sound m := (forall n zz, (0 <= zz)%Z ->
  lb * (mu_unit * IZR n + (1 + k / 2) * (sqrt mu_unit * sqrt (IZR zz))) <= Q2R (friction_within m n zz)).

Lemma exact_sound uq : 0 < Q2R uq -> sound (exact_measure row uq).
Proof.
  intros U0 n zz Z0. apply IZR_le in Z0. cbn [exact_measure friction_within].
  destruct unit_real as [MU ME]. change (box row) with b. set (U := Q2R uq) in *.
  set (scale := reduced (box_square b * unit_of (metric_scale row) * (uq * uq))).
  assert (L0 : 0 <= lb) by apply sqrt_pos. assert (LL : lb * lb = Q2R (box_square b)) by (apply sqrt_sqrt; exact square_good).
  assert (SE : Q2R scale = lb * lb * mu_unit * (U * U)).
  { unfold scale. now rewrite reduced_same, !Q2R_mult, ME, LL. }
  set (square := (reduced (scale * unit_of (metric_scale row)) * inject_Z (n * n))%Q).
  set (aside := if (n <? 0)%Z then (- root_below square)%Q else root_above square).
  assert (A : lb * (U * (mu_unit * IZR n)) <= Q2R aside).
  { set (C := lb * U * mu_unit). assert (C0 : 0 <= C) by (unfold C; apply Rmult_le_pos; [apply Rmult_le_pos|]; lra).
    assert (QE : Q2R square = (C * IZR n) * (C * IZR n)).
    { unfold square. rewrite Q2R_mult, reduced_same, Q2R_mult, SE, ME, inject_real, mult_IZR. unfold C. ring. }
    assert (Q0 : 0 <= Q2R square) by (rewrite QE; apply Rle_0_sqr).
    replace (lb * (U * (mu_unit * IZR n))) with (C * IZR n) by (unfold C; ring). unfold aside.
    destruct (Z.ltb_spec n 0) as [N|N].
    - pose proof (root_below_is _ Q0) as RB. apply IZR_lt in N.
      replace (Q2R square) with ((C * - IZR n) * (C * - IZR n)) in RB by (rewrite QE; ring).
      rewrite sqrt_square in RB by (apply Rmult_le_pos; lra). rewrite Q2R_opp. lra.
    - pose proof (root_above_is _ Q0) as RA. apply IZR_le in N. rewrite QE in RA.
      rewrite sqrt_square in RA by (apply Rmult_le_pos; lra). exact RA. }
  assert (B : lb * (U * (sqrt mu_unit * sqrt (IZR zz))) <= Q2R (root_above (scale * inject_Z zz))).
  { assert (QE : Q2R (scale * inject_Z zz) = (lb * U) * (lb * U) * (mu_unit * IZR zz))
      by (rewrite Q2R_mult, SE, inject_real; ring).
    assert (Q0 : 0 <= mu_unit * IZR zz) by (apply Rmult_le_pos; lra).
    assert (P0 : 0 <= Q2R (scale * inject_Z zz)) by (rewrite QE; apply Rmult_le_pos; [apply Rle_0_sqr|exact Q0]).
    pose proof (root_above_is _ P0) as RA. rewrite QE, sqrt_mult_alt, sqrt_square, sqrt_mult_alt in RA;
      [|lra|apply Rmult_le_pos; lra|apply Rle_0_sqr]. eapply Rle_trans; [|exact RA]. right. ring. }
  set (beyond := root_above (scale * inject_Z zz)) in *.
  assert (T0 : 0 <= lb * (U * (sqrt mu_unit * sqrt (IZR zz)))).
  { apply Rmult_le_pos; [exact L0|]. apply Rmult_le_pos; [lra|]. apply Rmult_le_pos; apply sqrt_pos. }
  assert (S1 : (1 + k / 2) * (lb * (U * (sqrt mu_unit * sqrt (IZR zz)))) <=
    Q2R (reduced (1 + (1 # 2) * slack row)) * Q2R beyond).
  { rewrite reduced_same. apply Rmult_le_compat; [lra|exact T0|exact stretch_real|exact B]. }
  rewrite Q2R_div, Q2R_plus, Q2R_mult by (intros Z; apply Qeq_eqR in Z; fold U in Z; rewrite Q2R_0 in Z; lra). fold U.
  apply Rmult_le_reg_l with U; [exact U0|]. unfold Rdiv. rewrite (Rmult_comm U (_ * / U)), Rmult_assoc, Rinv_l by lra. lra.
Qed.

Lemma shifted_above bits q : (0 <= bits)%Z -> Q2R q * IZR (2 ^ bits) <= IZR (shifted bits q).
Proof.
  intros B. unfold shifted. eapply Rle_trans; [|apply up_above; reflexivity]. rewrite Z.shiftl_mul_pow2 by exact B.
  rewrite mult_IZR. unfold Q2R, Rdiv. right. ring.
Qed.

Lemma short_sound : sound (short_measure row).
Proof.
  intros n zz Z0. cbn [short_measure friction_within]. destruct unit_real as [MU ME]. change (box row) with b.
  set (scale := reduced (box_square b * unit_of (metric_scale row))).
  set (aside := reduced (scale * unit_of (metric_scale row))).
  assert (L0 : 0 <= lb) by apply sqrt_pos. assert (LL : lb * lb = Q2R (box_square b)) by (apply sqrt_sqrt; exact square_good).
  assert (SE : Q2R scale = lb * lb * mu_unit) by (unfold scale; now rewrite reduced_same, Q2R_mult, ME, LL).
  assert (AE : Q2R aside = (lb * mu_unit) * (lb * mu_unit))
    by (unfold aside; rewrite reduced_same, Q2R_mult, SE, ME; ring).
  assert (LM : 0 <= lb * mu_unit) by (apply Rmult_le_pos; lra).
  assert (A0 : 0 <= Q2R aside) by (rewrite AE; apply Rle_0_sqr).
  pose proof (root_above_is _ A0) as RA. pose proof (root_below_is _ A0) as RB. rewrite AE, sqrt_square in RA, RB by exact LM.
  assert (S0 : 0 <= Q2R scale) by (rewrite SE; apply Rmult_le_pos; [apply Rle_0_sqr|lra]).
  pose proof (root_above_is _ S0) as RS. rewrite SE, sqrt_mult_alt, sqrt_square in RS by (apply Rle_0_sqr || exact L0).
  set (W96 := IZR (2 ^ 96)). set (W64 := IZR (2 ^ 64)). set (W32 := IZR (2 ^ 32)).
  assert (P96 : 0 < W96) by (apply IZR_lt; reflexivity). assert (P64 : 0 < W64) by (apply IZR_lt; reflexivity).
  assert (P32 : 0 < W32) by (apply IZR_lt; reflexivity).
  assert (E96 : W96 = W64 * W32) by (unfold W96, W64, W32; rewrite <- mult_IZR; reflexivity).
  assert (E64 : W64 = W32 * W32) by (unfold W64, W32; rewrite <- mult_IZR; reflexivity).
  set (part := (1 # Z.to_pos (Z.shiftl 1 60))). set (stretch := (1 + (1 # 2) * slack row)%Q).
  assert (PP : 0 < Q2R part < 1) by (unfold part, Q2R; cbn; lra).
  assert (RB' : Q2R ((1 - part) * root_below aside) <= lb * mu_unit).
  { rewrite Q2R_mult, Q2R_minus, Q2R_1. apply Rle_trans with ((1 - Q2R part) * (lb * mu_unit)).
    - apply Rmult_le_compat_l; lra.
    - assert (0 <= Q2R part * (lb * mu_unit)) by (apply Rmult_le_pos; lra). lra. }
  assert (RA' : lb * mu_unit <= Q2R ((1 + part) * root_above aside)).
  { rewrite Q2R_mult, Q2R_plus, Q2R_1. assert (0 <= Q2R part * Q2R (root_above aside)) by (apply Rmult_le_pos; lra). lra. }
  assert (Wide : 1 + k / 2 <= Q2R ((1 + part) * stretch)).
  { rewrite Q2R_mult, Q2R_plus, Q2R_1. pose proof stretch_real as Sr. fold stretch in Sr.
    assert (0 <= Q2R part * Q2R stretch) by (apply Rmult_le_pos; lra). lra. }
  pose proof (shifted_above 96 ((1 + part) * root_above aside) ltac:(lia)) as Up. fold W96 in Up.
  pose proof (shifted_above 96 (- ((1 - part) * root_below aside)) ltac:(lia)) as Lo. fold W96 in Lo. rewrite Q2R_opp in Lo.
  set (most := shifted 96 ((1 + part) * root_above aside)) in *. set (least := shifted 96 (- ((1 - part) * root_below aside))) in *.
  pose proof (shifted_above 64 ((1 + part) * stretch * root_above scale) ltac:(lia)) as Le. fold W64 in Le. rewrite Q2R_mult in Le.
  set (len := shifted 64 ((1 + part) * stretch * root_above scale)) in *.
  (* the part along psi *)
  assert (Along : lb * mu_unit * IZR n * W96 <= IZR (n * (if (n <? 0)%Z then - least else most))).
  { rewrite mult_IZR. destruct (Z.ltb_spec n 0) as [N|N].
    - apply IZR_lt in N. rewrite opp_IZR. assert (Q : - IZR n * - (lb * mu_unit * W96) <= - IZR n * IZR least).
      { apply Rmult_le_compat_l; [lra|]. apply (Rmult_le_compat_r W96) in RB'; lra. }
      lra.
    - apply IZR_le in N. assert (Q : IZR n * (lb * mu_unit * W96) <= IZR n * IZR most).
      { apply Rmult_le_compat_l; [lra|]. apply (Rmult_le_compat_r W96) in RA'; lra. }
      lra. }
  (* and the rest *)
  set (root := (Z.sqrt (Z.shiftl zz 64) + 1)%Z).
  assert (Ro : sqrt (IZR zz) * W32 <= IZR root).
  { assert (Z1 : (0 <= zz * 2 ^ 64)%Z) by nia. pose proof (Z.sqrt_spec _ Z1) as [_ Sq]. pose proof (Z.sqrt_nonneg (zz * 2 ^ 64)) as Sn.
    unfold root. rewrite Z.shiftl_mul_pow2 by lia. set (r := Z.sqrt (zz * 2 ^ 64)) in *.
    apply IZR_lt in Sq. rewrite !mult_IZR in Sq. fold W64 in Sq. unfold Z.succ in Sq. apply IZR_le in Z0.
    assert (R0 : 0 <= IZR (r + 1)) by (apply IZR_le; lia).
    rewrite <- (sqrt_square (IZR (r + 1))) by exact R0. rewrite <- (sqrt_square W32) by lra.
    rewrite <- sqrt_mult_alt by exact Z0. apply sqrt_le_1_alt. rewrite <- E64. lra. }
  assert (Rest : (1 + k / 2) * (lb * sqrt mu_unit * sqrt (IZR zz)) * W96 <= IZR (len * root)).
  { rewrite mult_IZR, E96.
    replace ((1 + k / 2) * (lb * sqrt mu_unit * sqrt (IZR zz)) * (W64 * W32))
      with ((1 + k / 2) * (lb * sqrt mu_unit) * W64 * (sqrt (IZR zz) * W32)) by ring.
    assert (M0 : 0 <= lb * sqrt mu_unit) by (apply Rmult_le_pos; [exact L0|apply sqrt_pos]).
    apply Rmult_le_compat; [| |eapply Rle_trans; [|exact Le]|exact Ro].
    - apply Rmult_le_pos; [apply Rmult_le_pos; lra|lra].
    - apply Rmult_le_pos; [apply sqrt_pos|lra].
    - apply Rmult_le_compat_r; [lra|]. apply Rmult_le_compat; [lra|exact M0|exact Wide|exact RS]. }
  unfold Q2R. cbn [Qnum Qden]. change (IZR (Zpos (Z.to_pos (Z.shiftl 1 96)))) with W96.
  apply Rmult_le_reg_r with W96; [exact P96|]. unfold Rdiv. rewrite (Rmult_assoc (IZR _)), Rinv_l, Rmult_1_r, plus_IZR by lra. lra.
Qed.

End Measures.

(* ---- A contact's work ---- *)

Section Contact.

Variable b : cbox.
Variables r r' : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu st : R).
Hypothesis I : inside_at b r' p F mu st.
Variable k : R.
Hypothesis St : stands k r r'.
Let row := make_row b.
Let Wt := Rows.weights r'.
Let u := unit (forms_scaling b).
Let mu_unit := unit (metric_scale row).
Let pu := unit (pull_scaling b).

Variable it : carrier.
Hypothesis its_row : carried it = row.
Hypothesis its_scale : forms_scaled it = forms_scaling b.
Hypothesis its_forms : at_corners it = tips (corner_forms b).
Hypothesis its_measure : forall n zz, (0 <= zz)%Z ->
  sqrt (Q2R (box_square b)) * (mu_unit * IZR n + (1 + k / 2) * (sqrt mu_unit * sqrt (IZR zz))) <=
  Q2R (friction_within (measured it) n zz).
Hypothesis psi_good : (0 <= kappa it)%Z /\
  (times (metric_scale row) * inner_of (metric row) (psi it) (psi it) <= over (metric_scale row) * (kappa it * kappa it))%Z.

Variables (w : Model.law) (a : R) (g : list R).
Hypothesis obeyed : Rows.obeys w d h l r (a, g).

Let slip_d := Rows.slip r' d.
Let psi_r := map IZR (psi it).

Lemma rho_nonneg : 0 <= Rows.rho r'.
Proof.
  rewrite (is_rho _ _ _ _ _ _ I). apply Rmult_le_pos; [apply (friction_nonneg _ _ _ _ _ _ I)|apply sqrt_pos].
Qed.

Lemma psi_length : Rows.size Wt psi_r <= IZR (kappa it).
Proof.
  destruct psi_good as [K0 K]. apply IZR_le in K0, K. rewrite !mult_IZR in K.
  unfold Wt, psi_r. rewrite (size_integers b r' p F mu st I). fold row.
  set (n := inner_of (metric row) (psi it) (psi it)) in *.
  assert (N0 : 0 <= IZR n).
  { unfold n, row. rewrite inner_is. apply Rows.product_nonneg, (metric_positive b r' p F mu st I). }
  assert (O : 0 < IZR (over (metric_scale row))) by apply over_positive.
  fold mu_unit. rewrite <- sqrt_mult_alt by (left; apply unit_positive).
  rewrite <- (sqrt_square (IZR (kappa it))) by exact K0. apply sqrt_le_1_alt. unfold mu_unit, unit.
  apply Rmult_le_reg_l with (IZR (over (metric_scale row))); [exact O|].
  replace (IZR (over (metric_scale row)) * (IZR (times (metric_scale row)) / IZR (over (metric_scale row)) * IZR n))
    with (IZR (times (metric_scale row)) * IZR n) by (field; lra). exact K.
Qed.

(* The bound of work over a, at x. *)
Definition effort_at_x : R :=
  Rows.dot (Rows.N r') twist + Rows.rho r' *
    (Rows.product Wt psi_r slip_d + (1 + k / 2) * Rows.size Wt (Rows.slip r' (relative_twist (kappa it)))).

Lemma work_at_x : 0 <= a -> Rows.work r (a, g) twist <= a * effort_at_x.
Proof.
  intros A0. pose proof rho_nonneg as R0. destruct psi_good as [K0 _]. apply IZR_le in K0.
  pose proof (weights_positive _ _ _ _ _ _ I) as P. fold Wt in P.
  set (K := IZR (kappa it)) in *. set (rel := relative_twist (kappa it)).
  assert (E : Rows.product (Rows.weights r) g (Rows.slip r rel) =
    Rows.product (Rows.weights r) g (Rows.slip r twist) + - K * Rows.product (Rows.weights r) g (Rows.slip r d))
    by apply product_slips.
  destruct (rubs _ _ _ St w d h l a g rel obeyed A0) as [Cone _].
  pose proof (brakes _ _ _ St w d h l a g obeyed A0) as Br.
  fold Wt slip_d in Br. fold Wt in Cone. rewrite E in Cone.
  assert (Sd : - (K * Rows.size Wt slip_d) <= Rows.product Wt psi_r slip_d).
  { pose proof (Rows.product_bound Wt (Rows.scaled (-1) psi_r) slip_d P) as B.
    assert (Z : Rows.size Wt (Rows.scaled (-1) psi_r) = Rows.size Wt psi_r).
    { unfold Rows.size. f_equal. rewrite Rows.product_scaled, Rows.product_sym, Rows.product_scaled. ring. }
    rewrite Z, Rows.product_scaled in B. pose proof psi_length as L. fold K in L.
    pose proof (Rmult_le_compat_r _ _ _ (Rows.size_nonneg Wt slip_d) L). lra. }
  unfold Rows.work. cbn [fst snd]. unfold effort_at_x. fold rel. rewrite (same_N _ _ _ St).
  assert (RA : 0 <= Rows.rho r' * a) by now apply Rmult_le_pos.
  apply (Rmult_le_compat_l _ _ _ K0) in Br. apply (Rmult_le_compat_l _ _ _ RA) in Sd.
  set (X := Rows.product (Rows.weights r) g (Rows.slip r twist)) in *.
  set (Y := Rows.product (Rows.weights r) g (Rows.slip r d)) in *.
  set (Z := Rows.size Wt (Rows.slip r' rel)) in *. set (V := Rows.product Wt psi_r slip_d) in *.
  set (s := Rows.size Wt slip_d) in *.
  replace (a * (Rows.dot (Rows.N r) twist + Rows.rho r' * (V + (1 + k / 2) * Z)))
    with (a * Rows.dot (Rows.N r) twist + (Rows.rho r' * a * V + Rows.rho r' * a * ((1 + k / 2) * Z))) by ring.
  lra.
Qed.

(* At a corner and a ray, and what the checker has for it. *)
Definition corner_at (t : list form) (q : form) : R :=
  F0 * u * IZR (dot (nth 0 t []) (twist_at c y q)) + Rows.rho r' *
    (F0 * u * Rows.product Wt psi_r (map IZR (slip_at t (ray_motion q))) +
     (1 + k / 2) * (F0 * u * Rows.size Wt (map IZR (slip_at t (relative_at (kappa it) q))))).

Lemma u_pos : 0 < u.
Proof. apply unit_positive. Qed.

Let uq := reduced (unit_of (forms_scaled it) * factor)%Q.

Lemma uq_is : Q2R uq = F0 * u.
Proof.
  unfold uq. rewrite reduced_same, Q2R_mult, its_scale, unit_of_is by apply common_denominator_positive.
  unfold F0, u. ring.
Qed.

Lemma corner_bound t q : box_spring b = false ->
  corner_at t q <= F0 * u * Q2R (corner_work it (twist_at c y q) (ray_motion q) t).
Proof.
  intros Sp. unfold corner_work. rewrite its_row. change (box row) with b. rewrite Sp.
  pose proof u_pos as UP. fold (relative_at (kappa it) q).
  set (n := inner_of (metric row) (psi it) (slip_at t (ray_motion q))).
  set (z := slip_at t (relative_at (kappa it) q)). set (zz := inner_of (metric row) z z).
  set (lb := sqrt (Q2R (box_square b))).
  set (U := F0 * u) in *. assert (U0 : 0 < U) by (apply Rmult_lt_0_compat; [exact factor_positive|exact UP]).
  assert (PE : Rows.product Wt psi_r (map IZR (slip_at t (ray_motion q))) = mu_unit * IZR n).
  { unfold Wt, psi_r. rewrite (product_is b r' p F mu st I). fold row mu_unit. f_equal. unfold n, row. now rewrite inner_is. }
  assert (ZZ : (0 <= zz)%Z).
  { apply le_IZR. unfold zz, row. rewrite inner_is. apply Rows.product_nonneg, (metric_positive b r' p F mu st I). }
  assert (ZE : Rows.size Wt (map IZR z) = sqrt mu_unit * sqrt (IZR zz)).
  { unfold Wt. rewrite (size_integers b r' p F mu st I). reflexivity. }
  pose proof (its_measure n zz ZZ) as Fr. fold lb in Fr. set (friction := friction_within (measured it) n zz) in *.
  rewrite Q2R_plus, inject_real. unfold corner_at. fold U z. rewrite PE, ZE, (is_rho _ _ _ _ _ _ I). fold lb.
  pose proof (in_friction _ _ _ _ _ _ I) as Wf. pose proof (friction_nonneg _ _ _ _ _ _ I) as M0.
  set (top := largest_q _).
  assert (Top : mu * Q2R friction <= Q2R top).
  { replace (mu * Q2R friction) with (0 + Q2R friction * mu) by ring.
    apply at_ends with (box_friction b); [exact Wf|]. intros e He.
    replace (0 + Q2R friction * Q2R e) with (Q2R (e * friction)) by (rewrite Q2R_mult; ring).
    apply largest_q_above. now apply (in_map (fun e => (e * friction)%Q)). }
  apply (Rmult_le_compat_l _ _ _ M0) in Fr.
  assert (Both : U * (mu * (lb * (mu_unit * IZR n + (1 + k / 2) * (sqrt mu_unit * sqrt (IZR zz))))) <= U * Q2R top)
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(* The bound at x is at most the sum of A over rays. *)
Definition most_at (q : form) : R := Q2R (most_work it factor (twist_at c y q) (ray_motion q)).

Lemma most_at_corners t q : In t (tips (corner_forms b)) ->
  F0 * u * Q2R (corner_work it (twist_at c y q) (ray_motion q) t) <= most_at q.
Proof.
  intros Ht. unfold most_at, most_work. rewrite reduced_same, Q2R_mult, its_forms. fold uq. rewrite uq_is.
  apply Rmult_le_compat_l; [left; apply Rmult_lt_0_compat; [exact factor_positive|exact u_pos]|].
  apply largest_q_above. now apply in_map.
Qed.

Lemma effort_summed : box_spring b = false -> F0 * effort_at_x <= sum_over most_at ws.
Proof.
  intros Sp. pose proof u_pos as UP. pose proof (shares_valid b r' p F mu st I) as SV. pose proof rho_nonneg as R0.
  assert (K0 : 0 <= k) by apply (own_slack _ _ _ St).
  pose proof (weights_positive _ _ _ _ _ _ I) as P. fold Wt in P.
  set (ss := shares_in b p) in *. set (rel := relative_twist (kappa it)).
  pose proof (N_corners b r' p F mu st I twist) as NE. fold ss u in NE.
  pose proof (size_corners b r' p F mu st I rel) as SE. fold ss u Wt in SE.
  assert (PE : Rows.product Wt psi_r slip_d = u * eval (fun t => Rows.product Wt psi_r (slip_of t d)) (corner_forms b) ss).
  { unfold Wt, slip_d. rewrite Rows.product_sym, (product_is b r' p F mu st I), (slip_corners b r' p F mu st I).
    fold ss u row mu_unit. rewrite <- Rmult_assoc, (Rmult_comm _ u), Rmult_assoc, <- eval_multiple. f_equal.
    apply eval_same. intros t _. rewrite (Rows.product_sym (Rows.weights r')), (product_is b r' p F mu st I). reflexivity. }
  set (E := fun t => F0 * u * rdot (nth 0 t []) twist + Rows.rho r' *
    (F0 * u * Rows.product Wt psi_r (slip_of t d) + (1 + k / 2) * (F0 * u * Rows.size Wt (slip_of t rel)))).
  apply Rle_trans with (eval E (corner_forms b) ss).
  - unfold E. rewrite eval_sum, !eval_multiple, eval_sum, !eval_multiple. unfold effort_at_x. fold rel. rewrite NE, PE.
    match type of NE with _ = u * ?e => set (e1 := e) end. match type of PE with _ = u * ?e => set (e2 := e) end.
    match type of SE with _ <= u * ?e => set (e3 := e) in SE end.
    apply Rle_trans with (F0 * u * e1 + Rows.rho r' * (F0 * u * e2 + (1 + k / 2) * (F0 * u * e3))); [|right; reflexivity].
    assert (X : Rows.rho r' * ((1 + k / 2) * (F0 * Rows.size Wt (Rows.slip r' rel))) <=
      Rows.rho r' * ((1 + k / 2) * (F0 * (u * e3)))).
    { apply Rmult_le_compat_l; [exact R0|]. apply Rmult_le_compat_l; [lra|].
      apply Rmult_le_compat_l; [apply Rlt_le, factor_positive|exact SE]. }
    lra.
  - apply eval_most; [exact SV|]. intros t Ht.
    apply Rle_trans with (sum_over (corner_at t) ws).
    + unfold E, corner_at. rewrite sum_plus, !sum_times, sum_plus, !sum_times.
      assert (N1 : rdot (nth 0 t []) twist = sum_over (fun q => IZR (dot (nth 0 t []) (twist_at c y q))) ws).
      { rewrite rdot_real, twist_summed. apply sum_same. intros q. now rewrite <- rdot_real, rdot_integers. }
      assert (N2 : Rows.product Wt psi_r (slip_of t d) =
        sum_over (fun q => Rows.product Wt psi_r (map IZR (slip_at t (ray_motion q)))) ws).
      { rewrite Rows.product_sym. etransitivity; [apply (slip_summed Wt d _ (tl t) psi_r d_summed)|].
        apply sum_same. intros q. rewrite Rows.product_sym. f_equal. exact (slip_of_integers t (ray_motion q)). }
      assert (N3 : Rows.size Wt (slip_of t rel) <=
        sum_over (fun q => Rows.size Wt (map IZR (slip_at t (relative_at (kappa it) q)))) ws).
      { unfold slip_of. eapply Rle_trans; [apply (size_summed Wt rel _ (tl t) P (relative_summed (kappa it)))|]. right.
        apply sum_same. intros q. f_equal. exact (slip_of_integers t (relative_at (kappa it) q)). }
      rewrite N1, N2. apply Rplus_le_compat_l. apply Rmult_le_compat_l; [exact R0|]. apply Rplus_le_compat_l.
      apply Rmult_le_compat_l; [lra|]. apply Rmult_le_compat_l; [|exact N3].
      left. apply Rmult_lt_0_compat; [exact factor_positive|exact UP].
    + apply (sum_le ws (map coordinates rays) W). intros q _.
      eapply Rle_trans; [now apply corner_bound|now apply most_at_corners].
Qed.

(* A spring has no corners and no friction. *)
Lemma spring_effort : box_spring b = true -> parameters row = O ->
  F0 * Rows.dot (Rows.N r') twist = sum_over most_at ws.
Proof.
  intros Sp Pa.
  assert (SS : shares_in b p = []).
  { apply length_zero_iff_nil. rewrite (shares_length b r' p F mu st I). exact Pa. }
  pose proof (N_corners b r' p F mu st I twist) as NE. rewrite SS, eval_first in NE. fold u in NE.
  assert (One : tips (corner_forms b) = [first_tip (corner_forms b)]).
  { assert (Pc : count (box_geometry b) = O) by exact Pa. unfold corner_forms, geometry_tree. clear - Pc.
    revert Pc. generalize (map (map (to_integer (forms_scaling b)))) as f. generalize (box_forms b) as G.
    generalize (box_geometry b) as is. unfold count.
    induction is as [|i is IH]; intros G f Pc; cbn in *; [reflexivity|]. unfold spread.
    destruct (certain i); cbn in *; [|discriminate]. exact (IH _ _ Pc). }
  rewrite NE, rdot_real, twist_summed, <- Rmult_assoc, <- sum_times. apply sum_same. intros q.
  unfold most_at, most_work. rewrite reduced_same, Q2R_mult, its_forms, One. cbn [map largest_q]. fold uq.
  unfold corner_work. rewrite its_row. change (box row) with b. rewrite Sp, uq_is, inject_real.
  now rewrite <- rdot_real, rdot_integers.
Qed.

(* ---- v at rays ---- *)

Let v := Rows.v r' d h l.
Definition v_at (q : form) : R := Rows.v r' (map IZR (ray_motion q)) (IZR (nth 0 q 0%Z)) (IZR (nth 1 q 0%Z)).

Lemma v_summed : v = sum_over v_at ws.
Proof.
  set (f := Rows.preload r' :: Rows.growth r' :: Rows.scaled (- Rows.stiffness r') (Rows.N r')).
  assert (E : forall d' h' l', Rows.v r' d' h' l' = Rows.dot f (h' :: l' :: d')).
  { intros. unfold Rows.v, f. cbn [Rows.dot]. rewrite Rows.dot_scaled. ring. }
  unfold v. rewrite E. fold x. rewrite x_summed. apply sum_same. intros q. unfold v_at. now rewrite E.
Qed.

Lemma v_at_within q wk : pu * IZR (least_pull (press_of q it wk)) <= v_at q <= pu * IZR (most_pull (press_of q it wk)).
Proof.
  unfold press_of. rewrite its_row. cbn [least_pull most_pull].
  assert (PU : 0 < pu) by apply pull_unit. set (vs := map (fun f => dot f q) (pull_tips row)).
  split.
  - assert (B : -1 * v_at q <= pu * IZR (largest (map Z.opp vs))).
    { apply (v_bound _ _ _ b r' p F mu st I). intros f Hf. fold pu. fold (point_of q). rewrite rdot_point.
      assert (L : (- dot f q <= largest (map Z.opp vs))%Z).
      { apply largest_above. apply in_map. unfold vs. apply in_map_iff. now exists f. }
      apply IZR_le in L. rewrite opp_IZR in L. apply (Rmult_le_compat_l pu) in L; lra. }
    rewrite opp_IZR. lra.
  - assert (B : 1 * v_at q <= pu * IZR (largest vs)).
    { apply (v_bound _ _ _ b r' p F mu st I). intros f Hf. fold pu. fold (point_of q). rewrite rdot_point.
      assert (L : (dot f q <= largest vs)%Z).
      { apply largest_above. unfold vs. apply in_map_iff. now exists f. }
      apply IZR_le in L. apply (Rmult_le_compat_l pu) in L; lra. }
    lra.
Qed.

(* What the checker has for a pair of rays, in reals: the work at the second is P. *)
Definition pressed_real (it : carrier) (q : form) (P : R) : R :=
  let at_q := press_of q it 0 in
  if may_open it then Rmax 0 (IZR (most_pull at_q)) * Rmax 0 P
  else (if Rlt_dec 0 P then IZR (most_pull at_q) else IZR (least_pull at_q)) * P.

Lemma scaled_is q : Q2R (scaled_work c y factor q it) = pu * most_at q.
Proof.
  unfold scaled_work. rewrite reduced_same, Q2R_mult, its_row. unfold row. cbn [pull_scale make_row].
  rewrite unit_of_is by apply common_denominator_positive. reflexivity.
Qed.

(* A contact that is closed, or a spring. *)
Lemma closed_pairs : may_open it = false ->
  v * sum_over most_at ws <= pairs ws (fun q q' => pressed_real it q (Q2R (scaled_work c y factor q' it))).
Proof.
  intros Mo. rewrite v_summed, <- pairs_product. apply (pairs_le ws (map coordinates rays) W). intros q q' _ _.
  unfold pressed_real. rewrite Mo, scaled_is. destruct (v_at_within q 0) as [Lo Hi]. cbv zeta.
  assert (PU : 0 < pu) by apply pull_unit. set (A := most_at q').
  destruct (Rlt_dec 0 (pu * A)) as [P|P].
  - assert (A0 : 0 <= A) by (apply Rnot_lt_le; intros N; assert (0 <= pu * - A) by (apply Rmult_le_pos; lra); lra).
    apply (Rmult_le_compat_r _ _ _ A0) in Hi. lra.
  - assert (A0 : 0 <= - A) by (apply Rnot_lt_le; intros N; apply P; apply Rmult_lt_0_compat; lra).
    apply (Rmult_le_compat_r _ _ _ A0) in Lo. lra.
Qed.

Lemma mixed_pairs : may_open it = true -> a = Rmax 0 v ->
  a * sum_over most_at ws <= pairs ws (fun q q' => pressed_real it q (Q2R (scaled_work c y factor q' it))).
Proof.
  intros Mo Ha. assert (PU : 0 < pu) by apply pull_unit.
  set (top := fun q => Rmax 0 (IZR (most_pull (press_of q it 0)))).
  assert (T0 : forall q, 0 <= top q) by (intros; apply Rmax_l).
  assert (A1 : a <= sum_over (fun q => pu * top q) ws).
  { rewrite Ha. apply Rmax_lub.
    - apply (sum_nonneg ws (map coordinates rays) W). intros q _. apply Rmult_le_pos; [lra|apply T0].
    - rewrite v_summed. apply (sum_le ws (map coordinates rays) W). intros q _. destruct (v_at_within q 0) as [_ Hi].
      eapply Rle_trans; [exact Hi|]. apply Rmult_le_compat_l; [lra|apply Rmax_r]. }
  assert (A0 : 0 <= a) by (rewrite Ha; apply Rmax_l).
  set (pos := fun q => Rmax 0 (most_at q)).
  apply Rle_trans with (sum_over (fun q => pu * top q) ws * sum_over pos ws).
  - apply Rle_trans with (a * sum_over pos ws).
    + apply Rmult_le_compat_l; [exact A0|]. apply (sum_le ws (map coordinates rays) W). intros q _. apply Rmax_r.
    + apply Rmult_le_compat_r; [|exact A1]. apply (sum_nonneg ws (map coordinates rays) W). intros q _. apply Rmax_l.
  - rewrite <- pairs_product. apply (pairs_le ws (map coordinates rays) W). intros q q' _ _. right.
    unfold pressed_real. rewrite Mo, scaled_is. cbv zeta. fold (top q). unfold pos.
    replace (Rmax 0 (pu * most_at q')) with (pu * Rmax 0 (most_at q')); [ring|].
    rewrite <- RmaxRmult by lra. f_equal. ring.
Qed.

End Contact.

(* ---- All contacts ---- *)

Lemma carrier_of_is exact b ks ps mixed : carrier_of exact factor (make_row b) ks ps mixed =
  Carrier (make_row b) (forms_scaling b) (tips (corner_forms b))
    (if exact then exact_measure (make_row b) (reduced (unit_of (forms_scaling b) * factor)%Q) else short_measure (make_row b))
    ks ps mixed.
Proof.
  unfold carrier_of. change (box (make_row b)) with b. destruct (box_signed b) eqn:Sg; [reflexivity|].
  assert (E1 : forms_scale (make_row b) = forms_scaling b) by (cbn [forms_scale make_row]; now rewrite Sg).
  assert (E2 : forms (make_row b) = corner_forms b) by (cbn [forms make_row]; now rewrite Sg).
  now rewrite E1, E2.
Qed.

Definition pair_work (it : carrier) : R :=
  pairs ws (fun q q' => pressed_real it q (Q2R (scaled_work c y factor q' it))).

Lemma carrier_bound exact w b r a g ks ps (mixed : bool) :
  seen_in b r -> Rows.obeys w d h l r (a, g) ->
  psi_within (make_row b) ks ps = true ->
  negb (box_spring b) || Nat.eqb (parameters (make_row b)) 0 = true ->
  (if mixed then box_spring b = false else
     box_spring b || forallb (nowhere_negative rays) (pull_tips (make_row b)) = true) ->
  F0 * Rows.work r (a, g) twist <= pair_work (carrier_of exact factor (make_row b) ks ps mixed).
Proof.
  intros Se Ob Pw Spa Closed. destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & St & Sk & _).
  pose proof (carrier_of_is exact b ks ps mixed) as Is. set (it := carrier_of exact factor (make_row b) ks ps mixed) in *.
  assert (C1 : carried it = make_row b) by now rewrite Is. assert (C2 : forms_scaled it = forms_scaling b) by now rewrite Is.
  assert (C3 : at_corners it = tips (corner_forms b)) by now rewrite Is. assert (Ck : kappa it = ks) by now rewrite Is.
  assert (Cp : psi it = ps) by now rewrite Is. assert (Cm : may_open it = mixed) by now rewrite Is.
  assert (Good : (0 <= kappa it)%Z /\ (times (metric_scale (make_row b)) * inner_of (metric (make_row b)) (psi it) (psi it) <=
      over (metric_scale (make_row b)) * (kappa it * kappa it))%Z).
  { rewrite Ck, Cp. unfold psi_within in Pw. apply andb_true_iff in Pw as [P1 P2]. split; now apply Z.leb_le. }
  assert (Slk : k <= Q2R (slack (make_row b))) by (cbn [slack make_row]; apply Sk, I).
  assert (Me : forall n zz, (0 <= zz)%Z -> sqrt (Q2R (box_square b)) * (unit (metric_scale (make_row b)) * IZR n +
      (1 + k / 2) * (sqrt (unit (metric_scale (make_row b))) * sqrt (IZR zz))) <= Q2R (friction_within (measured it) n zz)).
  { rewrite Is. cbn [measured]. destruct exact.
    - apply exact_sound; [apply I|apply (own_slack _ _ _ St)|exact Slk|].
      rewrite reduced_same, Q2R_mult, unit_of_is by apply common_denominator_positive.
      apply Rmult_lt_0_compat; [apply unit_positive|exact factor_positive].
    - apply short_sound; [apply I|apply (own_slack _ _ _ St)|exact Slk]. }
  pose proof (same_pull k r r' d h l St) as Pull. set (v := Rows.v r' d h l) in *.
  assert (Law : (box_spring b = true -> a = v) /\ (box_spring b = false -> a = Rmax 0 v)).
  { destruct Ob as [Law _]. unfold Rows.normal_law in Law.
    rewrite <- (same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I), <- Pull in Law.
    split; intros E; rewrite E in Law; [exact Law|]. destruct w; cbn in Law; [exact Law|].
    rewrite Rmax_right; lra. }
  unfold pair_work. destruct (box_spring b) eqn:Sp.
  - (* a spring *)
    destruct mixed; [discriminate|]. cbn in Spa. apply Nat.eqb_eq in Spa.
    destruct Law as [Law _]. rewrite (Law eq_refl) in *.
    assert (E : F0 * Rows.work r (v, g) twist = v * sum_over (most_at it) ws).
    { rewrite <- (spring_effort b r' p F mu t I it C1 C2 C3 Sp Spa).
      destruct Ob as (_ & Cone & _). unfold Rows.work. cbn [fst snd].
      assert (Z : Rows.product (Rows.weights r) g (Rows.slip r twist) = 0).
      { apply Rows.size_zero; [exact (own_weights _ _ _ St)|].
        assert (R0 : Rows.rho r = 0).
        { apply (no_rubbing _ _ _ St). rewrite (is_rho _ _ _ _ _ _ I), (spring_smooth _ _ _ _ _ _ I Sp). ring. }
        rewrite R0, Rmult_0_l in Cone. pose proof (Rows.size_nonneg (Rows.weights r) g). lra. }
      rewrite Z, (same_N _ _ _ St). ring. }
    rewrite E. exact (closed_pairs b r' p F mu t I it C1 Good Cm).
  - destruct Law as [_ Law]. specialize (Law eq_refl).
    assert (A0 : 0 <= a) by (rewrite Law; apply Rmax_l).
    assert (B : F0 * Rows.work r (a, g) twist <= a * sum_over (most_at it) ws).
    { pose proof (work_at_x b r r' p F mu t I k St it Good w a g Ob A0) as W1.
      pose proof (effort_summed b r r' p F mu t I k St it C1 C2 C3 Me Sp) as W2.
      apply (Rmult_le_compat_l F0) in W1; [|apply Rlt_le, factor_positive].
      apply (Rmult_le_compat_l a) in W2; [|exact A0]. lra. }
    eapply Rle_trans; [exact B|]. destruct mixed.
    + exact (mixed_pairs b r' p F mu t I it C1 Good a Cm Law).
    + assert (V : 0 <= v) by (exact (v_nonneg rays d h l ws W spanned b r' p F mu t I Closed)).
      rewrite Law, Rmax_right by exact V. exact (closed_pairs b r' p F mu t I it C1 Good Cm).
Qed.

Fixpoint sum_of (H : carrier -> R) (cs : list carrier) : R :=
  match cs with [] => 0 | it :: cs' => H it + sum_of H cs' end.

Lemma stated_within row number them :
  let '(k, ps, _, good) := stated row number them in good = true -> psi_within row k ps = true.
Proof.
  assert (Zero : psi_within row 0 [] = true).
  { unfold psi_within. replace (inner_of (metric row) [] []) with 0%Z by (now destruct (metric row)).
    apply andb_true_iff. split; [reflexivity|]. apply Z.leb_le. lia. }
  unfold stated. destruct them as [|[i [k ps]] them]; [now intros _|]. destruct (Z.eqb i number); [|now intros _].
  intros H. now apply andb_true_iff in H.
Qed.

Lemma carriers_bound exact w them rows rs fs number before cs :
  carriers exact factor rays them rows number before = Some cs ->
  Forall2 suits rows rs -> Forall2 (Rows.obeys w d h l) rs fs ->
  F0 * Rows.works rs fs twist + sum_of pair_work before <= sum_of pair_work cs.
Proof.
  intros C S. revert them fs number before C. induction S as [|row r rows rs [Er Se] S IH]; intros them fs number before C O.
  - inversion O; subst. cbn in C. destruct them; [|discriminate]. injection C as <-. cbn. lra.
  - inversion O as [|r0 [a g] rs0 fs' Oc Os]; subst. cbn [carriers Rows.works] in *.
    pose proof (stated_within row number them) as Ps. destruct (stated row number them) as [[[k0 p0] o0] g0].
    destruct (g0 && _) eqn:G in C; [|discriminate]. apply andb_true_iff in G as [G Spa]. specialize (Ps G).
    specialize (IH _ fs' _ _ C Os). rewrite Er in Spa, Ps, IH.
    change (box (make_row (box row))) with (box row) in Spa, IH.
    rewrite Rmult_plus_distr_l.
    assert (Add : forall mixed : bool, (if mixed then box_spring (box row) = false else
        box_spring (box row) || forallb (nowhere_negative rays) (pull_tips (make_row (box row))) = true) ->
      F0 * Rows.works rs fs' twist + sum_of pair_work (carrier_of exact factor (make_row (box row)) k0 p0 mixed :: before) <=
        sum_of pair_work cs ->
      F0 * Rows.work r (a, g) twist + F0 * Rows.works rs fs' twist + sum_of pair_work before <= sum_of pair_work cs).
    { intros mixed Cl H. pose proof (carrier_bound exact w (box row) r a g k0 p0 mixed Se Oc Ps Spa Cl). cbn [sum_of] in H. lra. }
    destruct (box_spring (box row) || _) eqn:Closed in IH; [exact (Add false Closed IH)|].
    apply orb_false_iff in Closed as [Sp _].
    destruct (forallb (nowhere_positive rays) _) eqn:Op in IH; [|exact (Add true Sp IH)].
    rewrite (open_works rays d h l ws W spanned w (box row) r a g twist Se Oc Sp Op). lra.
Qed.

Lemma load_bound ld s : is_load ld (Rows.wrench s) -> map Q2R (load_growth ld) = Rows.direction s ->
  forallb is_zero (load_growth ld) = true -> 0 <= h ->
  F0 * Rows.load s h l twist <= pairs ws (fun q q' => IZR (h_of q) * Q2R (load_work ld c y factor q')).
Proof.
  intros Hw Hu Z H0. rewrite pairs_product, <- h_summed.
  assert (U : forall z, Rows.dot (Rows.direction s) z = 0).
  { rewrite <- Hu. clear - Z. induction (load_growth ld) as [|q qs IH]; intros [|t z]; cbn in *; try reflexivity.
    apply andb_true_iff in Z as [Z1 Z2]. apply Qeq_bool_eq, Qeq_eqR in Z1. rewrite Z1, Q2R_0, (IH Z2). ring. }
  unfold Rows.load. rewrite U, Rmult_0_r, Rplus_0_r, <- Rmult_assoc, (Rmult_comm F0), Rmult_assoc.
  apply Rmult_le_compat_l; [exact H0|]. rewrite twist_summed, <- sum_times.
  apply (sum_le ws (map coordinates rays) W). intros q _. unfold load_work. rewrite reduced_same.
  destruct (load_within ld _ (map (fun z => (factor * inject_Z z)%Q) (twist_at c y q)) Hw) as [_ B].
  eapply Rle_trans; [|exact B]. right. rewrite <- dot_scaled_right. f_equal. unfold real, Rows.scaled. rewrite !map_map.
  apply map_ext. intros z. now rewrite Q2R_mult, inject_real.
Qed.

(* ---- The leaf ---- *)

Lemma all_pairs_is {A} (test : A -> A -> bool) them : (forall a b, test a b = test b a) -> all_pairs test them = true ->
  forall a b, In a them -> In b them -> test a b = true.
Proof.
  intros Sym. induction them as [|a0 them IH]; intros H a b; [intros []|]. cbn [all_pairs] in H.
  apply andb_true_iff in H as [H1 H2]. rewrite forallb_forall in H1.
  intros [<-|Ha] [<-|Hb]; [apply H1; now left|apply H1; now right|rewrite Sym; apply H1; now right|].
  now apply IH.
Qed.

Section Scaled.

Variable qs : list Q.
Let s := scaling_of qs.
Let U := unit s.

Lemma presses_are q (f : carrier -> Q) cs : presses_of q cs (map (to_integer s) (map f cs)) =
  map (fun it => press_of q it (to_integer s (f it))) cs.
Proof. induction cs as [|it cs IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Fixpoint pressed_sum (q q' : form) (cs : list carrier) : Z :=
  match cs with
  | [] => 0%Z
  | it :: cs' => (pressed (press_of q it 0) (press_of q' it (to_integer s (scaled_work c y factor q' it))) +
                  pressed_sum q q' cs')%Z
  end.

Lemma pressed_all_is q q' n cs sum :
  pressed_all (map (fun it => press_of q it (n it)) cs)
    (map (fun it => press_of q' it (to_integer s (scaled_work c y factor q' it))) cs) sum = (sum + pressed_sum q q' cs)%Z.
Proof.
  revert sum. induction cs as [|it cs IH]; intros sum; cbn [map pressed_all pressed_sum]; [lia|]. rewrite IH.
  change (pressed (press_of q it (n it))) with (pressed (press_of q it 0)). lia.
Qed.

Definition datum ld cs (r : ray) : at_ray :=
  at_ray_of cs r (map (to_integer s) (all_works ld c y factor cs (coordinates r))).

Definition total_between ld cs (q q' : form) : Z :=
  (h_of q * to_integer s (load_work ld c y factor q') + pressed_sum q q' cs)%Z.

Lemma work_between_is ld cs a b :
  work_between (datum ld cs a) (datum ld cs b) = total_between ld cs (coordinates a) (coordinates b).
Proof.
  unfold work_between, datum, all_works. rewrite !map_all_is. cbn [map at_ray_of presses at_h load_effort].
  rewrite !presses_are. apply pressed_all_is.
Qed.

Lemma unit_above : 0 < U.
Proof. apply unit_positive. Qed.

Lemma pressed_real_scaled it q n P : P = U * IZR n ->
  pressed_real it q P = U * IZR (pressed (press_of q it 0) (press_of q it n)).
Proof.
  intros ->. pose proof unit_above as HU. unfold pressed_real, pressed, press_of. cbn [opens effort most_pull least_pull].
  destruct (may_open it).
  - assert (M : forall z, Rmax 0 (IZR z) = IZR (Z.max 0 z)).
    { intros z. destruct (Z.max_spec 0 z) as [[L ->]|[L ->]].
      - apply Rmax_right, IZR_le. lia.
      - apply Rmax_left, IZR_le. lia. }
    rewrite mult_IZR, <- !M. replace (Rmax 0 (U * IZR n)) with (U * Rmax 0 (IZR n)); [ring|].
    rewrite <- RmaxRmult by lra. f_equal. ring.
  - rewrite mult_IZR. destruct (Rlt_dec 0 (U * IZR n)) as [Q|Q], (Z.ltb_spec 0 n) as [N|N]; try ring; exfalso.
    + apply IZR_le in N. assert (0 <= U * - IZR n) by (apply Rmult_le_pos; lra). lra.
    + apply IZR_lt in N. apply Q. now apply Rmult_lt_0_compat.
Qed.

Lemma pairs_same B C : (forall q r, In r rays -> B q (coordinates r) = C q (coordinates r)) -> pairs ws B = pairs ws C.
Proof.
  intros E. apply Rle_antisym; apply (pairs_le ws (map coordinates rays) W); intros q q' _ Hq';
    apply in_map_iff in Hq' as (r & <- & Hr); right; [|symmetry]; now apply E.
Qed.

Lemma pair_works cs :
  (forall it r, In it cs -> In r rays -> In (scaled_work c y factor (coordinates r) it) qs) ->
  sum_of pair_work cs = U * pairs ws (fun q q' => IZR (pressed_sum q q' cs)).
Proof.
  induction cs as [|it cs IH]; intros Sub; cbn [sum_of pressed_sum].
  - rewrite <- pairs_times. rewrite (pairs_same _ (fun _ _ => 0 * 0)) by (intros; ring). rewrite pairs_times. ring.
  - rewrite IH by (intros it' r Hit Hr; apply Sub; [now right|exact Hr]). unfold pair_work.
    rewrite <- !pairs_times, <- pairs_plus. apply pairs_same. intros q r Hr. rewrite plus_IZR.
    rewrite (pressed_real_scaled it q _ _ (to_integer_exact qs _ (Sub it r (or_introl eq_refl) Hr))).
    fold s. unfold pressed, press_of; cbn [opens effort most_pull least_pull]. ring.
Qed.

End Scaled.

Theorem moving_refutes exact rows ld push sys fs them cs :
  solution rows ld push sys d h l fs -> 0 <= push twist ->
  carriers exact factor rays them rows 0 [] = Some cs -> forallb is_zero (load_growth ld) = true ->
  moving_holds strict rays ld c y factor cs = false.
Proof.
  intros [F LW LU H0 L0 Ob Bal] Pu C Gr. apply not_true_is_false. intros H. unfold moving_holds in H.
  set (works := map _ rays) in H. set (qs := concat (map snd works)) in H.
  assert (E : map (fun p => at_ray_of cs (fst p) (map_all (to_integer (scaling_of qs)) (snd p))) works =
    map (datum qs ld cs) rays).
  { unfold works. rewrite map_map. apply map_ext. intros r. cbn [fst snd]. now rewrite map_all_is. }
  rewrite E in H. apply andb_true_iff in H as [H B].
  assert (In_works : forall r q, In r rays -> In q (all_works ld c y factor cs (coordinates r)) -> In q qs).
  { intros r q Hr Hq. apply in_concat. exists (all_works ld c y factor cs (coordinates r)). split; [|exact Hq].
    unfold works. rewrite map_map. cbn [snd]. now apply (in_map (fun r => all_works ld c y factor cs (coordinates r))). }
  clearbody qs. clear works E. set (D := fun q q' => IZR (total_between qs ld cs q q')).
  pose proof (unit_above qs) as U0.
  (* the whole work is not below 0 *)
  assert (Total : 0 <= pairs ws D).
  { pose proof (carriers_bound exact _ them rows (Rows.rows sys) fs 0%Z [] cs C F Ob) as CB. cbn [sum_of] in CB.
    pose proof (load_bound ld sys LW LU Gr H0) as LB. specialize (Bal twist).
    assert (Eq : unit (scaling_of qs) * pairs ws D =
      pairs ws (fun q q' => IZR (h_of q) * Q2R (load_work ld c y factor q')) + sum_of pair_work cs).
    { rewrite (pair_works qs) by (intros it r Hit Hr; apply (In_works r _ Hr); right; rewrite map_all_is; now apply in_map).
      rewrite <- !pairs_times, <- pairs_plus. apply pairs_same. intros q r Hr. unfold D, total_between.
      rewrite plus_IZR, mult_IZR, (to_integer_exact qs (load_work ld c y factor (coordinates r)))
        by (apply (In_works r _ Hr); now left). ring. }
    assert (P : 0 <= F0 * (Rows.load sys h l twist + Rows.works (Rows.rows sys) fs twist))
      by (rewrite Bal; apply Rmult_le_pos; [apply Rlt_le, factor_positive|exact Pu]).
    apply Rmult_le_reg_l with (unit (scaling_of qs)); [exact U0|]. rewrite Rmult_0_r, Eq. lra. }
  (* but nowhere above it *)
  set (them' := map (datum qs ld cs) rays) in *.
  assert (Value : forall a b, IZR (bound_of (datum qs ld cs a) (datum qs ld cs b)) =
    D (coordinates a) (coordinates b) + D (coordinates b) (coordinates a)).
  { intros a b. unfold bound_of, D. now rewrite !work_between_is, plus_IZR. }
  set (B2 := fun q q' => D q q' + D q' q).
  assert (Zeros : Forall (fun wq => fst wq = 0 \/ B2 (snd wq) (snd wq) = 0) ws).
  { apply (pairs_zero ws (map coordinates rays) W).
    - intros q q' Hq Hq'. apply in_map_iff in Hq as (r & <- & Hr). apply in_map_iff in Hq' as (r' & <- & Hr').
      unfold B2. rewrite <- Value. apply IZR_le, Z.leb_le.
      apply (all_pairs_is (fun a b => (bound_of a b <=? 0)%Z) them'); [|exact H| |]; try (now apply in_map).
      intros a b. unfold bound_of. now rewrite Z.add_comm.
    - unfold B2. rewrite pairs_plus, (pairs_swap ws D). lra. }
  refine (not_barred strict rays x rays_know strict_at_x ws spanned _ _ B _).
  - intros r Hr. apply in_map_iff in Hr as (a & <- & Ha). apply filter_In in Ha as [Ha _].
    apply in_map_iff in Ha as (r & <- & Hr). exact Hr.
  - pose proof W as W0. unfold weights in W0. apply Forall_forall. intros [w q] Hin. cbn.
    rewrite Forall_forall in W0, Zeros. destruct (W0 _ Hin) as [_ Hq]. cbn in Hq. apply in_map_iff in Hq as (r & <- & Hr).
    destruct (Zeros _ Hin) as [Z|Z]; [now left|right]. cbn [snd] in Z. exists r. split; [|reflexivity].
    apply in_map_iff. exists (datum qs ld cs r). split; [reflexivity|]. apply filter_In. split; [now apply in_map|].
    apply Z.eqb_eq, eq_IZR. rewrite Value. exact Z.
Qed.

(* ---- The direction ---- *)

Lemma dot_form_columns a fs X at_q : summed X at_q ->
  Rows.dot a (map (fun f => rdot f X) fs) = sum_over (fun q => Rows.dot a (map (fun f => rdot f (at_q q)) fs)) ws.
Proof.
  intros S. revert fs. induction a as [|t a IH]; intros [|f fs]; cbn; try (now rewrite sum_zero).
  rewrite IH, rdot_real, S, <- sum_times, <- sum_plus. apply sum_same. intros q. now rewrite <- rdot_real.
Qed.

Theorem moves_along a : direction_holds rays c y a = true -> 0 <= Rows.dot twist (Degree.times (map real a) x).
Proof.
  intros H. unfold direction_holds in H. set (rows := map (map (to_integer (scaling_of (concat a)))) a) in H. set (s := scaling_of (concat a)) in *.
  pose proof (unit_positive (concat a)) as U0. fold s in U0.
  assert (E : Degree.times (map real a) x = Rows.scaled (unit s) (map (fun f => rdot f x) rows)).
  { unfold Degree.times, Rows.scaled, rows. rewrite !map_map. apply map_ext_in. intros f Hf.
    unfold real. rewrite <- qdot_is. apply qdot_to_integers. intros q Hq. apply in_concat. now exists f. }
  rewrite E, dot_scaled_right. apply Rmult_le_pos; [lra|].
  set (V := fun q q' => IZR (dot (twist_at c y q) (map (fun f => dot f q') rows))).
  assert (T : Rows.dot twist (map (fun f => rdot f x) rows) = pairs ws V).
  { rewrite Degree.dot_sym, twist_summed. unfold pairs. apply sum_same. intros q.
    rewrite Degree.dot_sym, (dot_form_columns _ rows x point_of x_summed). apply sum_same. intros q'. unfold V.
    rewrite <- rdot_integers, rdot_real. f_equal. rewrite map_map. apply map_ext. intros f. apply rdot_point. }
  rewrite T. assert (S : 0 <= pairs ws (fun q q' => V q q' + V q' q)).
  { apply (sum_nonneg ws (map coordinates rays) W). intros q Hq. apply (sum_nonneg ws (map coordinates rays) W). intros q' Hq'.
    apply in_map_iff in Hq as (r & <- & Hr). apply in_map_iff in Hq' as (r' & <- & Hr').
    unfold V. rewrite <- plus_IZR. apply IZR_le, Z.leb_le.
    set (g := fun r => (twist_at c y (coordinates r), map (fun f => dot f (coordinates r)) rows)) in H.
    apply (all_pairs_is (fun p q => (0 <=? dot (fst p) (snd q) + dot (fst q) (snd p))%Z)) with (a := g r) (b := g r') in H;
      try (now apply in_map); [exact H|].
    intros p q. now rewrite Z.add_comm. }
  rewrite pairs_plus, (pairs_swap ws V) in S. lra.
Qed.

End Moving.
