(* SPDX-License-Identifier: MIT *)
(* Polyhedral cones by rays in integers: cutting them by a plane, with advice about which rays may
   be dropped.  The theorem, `cut_keeps_region`, is that no point of the cone on the right
   side of the plane is lost.  That no ray is superfluous is not proved, and not needed. *)
From Coq Require Import List ZArith Reals Lra Lia Bool.
From Proved Require Import Question.
Import ListNotations.

(* ---- Integer vectors: linear forms, and rays ---- *)

Definition form := list Z.

Section Integers.
Open Scope Z_scope.

Fixpoint dot (a b : form) : Z :=
  match a, b with
  | x :: a', y :: b' => x * y + dot a' b'
  | _, _ => 0
  end.

(* p a + q b; the shorter is continued by zeros. *)
Fixpoint combine (p : Z) (a : form) (q : Z) (b : form) : form :=
  match a, b with
  | x :: a', y :: b' => p * x + q * y :: combine p a' q b'
  | [], _ => map (Z.mul q) b
  | _, [] => map (Z.mul p) a
  end.

Lemma dot_nil_r a : dot a [] = 0.
Proof. now destruct a. Qed.

Lemma dot_scaled a p b : dot a (map (Z.mul p) b) = p * dot a b.
Proof.
  revert b; induction a as [|x a IH]; intros [|y b]; cbn; try lia.
  rewrite IH. lia.
Qed.

Lemma dot_combine f p a q b : dot f (combine p a q b) = p * dot f a + q * dot f b.
Proof.
  revert a b; induction f as [|x f IH]; intros [|y a] [|z b]; cbn; try lia.
  - rewrite dot_scaled. lia.
  - rewrite dot_scaled. lia.
  - rewrite IH. lia.
Qed.

Definition all_zero (a : form) : bool := forallb (Z.eqb 0) a.

Lemma dot_all_zero f a : all_zero a = true -> dot f a = 0.
Proof.
  revert a; induction f as [|x f IH]; intros [|y a]; try (cbn; lia).
  unfold all_zero. cbn [forallb dot]. rewrite andb_true_iff. intros [Hy Ha].
  apply Z.eqb_eq in Hy. subst y. rewrite IH by exact Ha. lia.
Qed.

(* The greatest common divisor, or 1 if all are 0. *)
Definition content (a : form) : Z :=
  let g := fold_right Z.gcd 0 a in if g =? 0 then 1 else g.

Lemma content_positive a : 0 < content a.
Proof.
  unfold content. destruct (Z.eqb_spec (fold_right Z.gcd 0 a) 0); [lia|].
  assert (0 <= fold_right Z.gcd 0 a); [|lia].
  destruct a; cbn; [lia | apply Z.gcd_nonneg].
Qed.

Lemma gcd_divides a x : In x a -> (fold_right Z.gcd 0 a | x).
Proof.
  induction a as [|y a IH]; cbn; [tauto|]. intros [<-|H].
  - apply Z.gcd_divide_l.
  - eapply Z.divide_trans; [apply Z.gcd_divide_r | auto].
Qed.

Lemma content_divides a x : In x a -> x = content a * (x / content a).
Proof.
  intros H. pose proof (content_positive a). apply Z_div_exact_full_2; [lia|].
  apply Z.mod_divide; [lia|]. pose proof (gcd_divides _ _ H) as D. unfold content in *.
  destruct (Z.eqb_spec (fold_right Z.gcd 0 a) 0) as [E|]; [|exact D].
  exists x. lia.
Qed.

Definition primitive (a : form) : form :=
  let g := content a in if g =? 1 then a else map (fun x => x / g) a.

Lemma map_content a c : (forall x, In x a -> x = c * (x / c)) ->
  forall f, dot f a = c * dot f (map (fun x => x / c) a).
Proof.
  induction a as [|x a IH]; intros H f.
  - cbn. rewrite dot_nil_r. lia.
  - destruct f as [|y f]; [cbn; lia|]. cbn.
    rewrite IH by (intros; apply H; right; assumption).
    rewrite (H x) at 1 by (left; reflexivity). ring.
Qed.

Lemma dot_primitive f a : dot f a = content a * dot f (primitive a).
Proof.
  unfold primitive. destruct (Z.eqb_spec (content a) 1) as [E|_].
  - rewrite E. lia.
  - apply map_content. apply content_divides.
Qed.

End Integers.

(* A form at a real point. *)
Fixpoint rdot (a : form) (x : list R) : R :=
  match a, x with
  | c :: a', y :: x' => (IZR c * y + rdot a' x')%R
  | _, _ => 0%R
  end.

(* ---- What rays span ---- *)

(* A point is known by the values of all forms at it.  It is spanned by rays if it is a sum of
   nonnegative multiples of them. *)
Section Spans.
Open Scope R_scope.

Fixpoint total (a : form) (ws : list (R * form)) : R :=
  match ws with
  | [] => 0
  | (w, r) :: ws' => w * IZR (dot a r) + total a ws'
  end.

Definition weights (rays : list form) (ws : list (R * form)) :=
  Forall (fun p => 0 <= fst p /\ In (snd p) rays) ws.

Definition spans (rays : list form) (point : form -> R) :=
  exists ws, weights rays ws /\ forall a, point a = total a ws.

Lemma total_app a ws ws' : total a (ws ++ ws') = total a ws + total a ws'.
Proof. induction ws as [|[w r] ws IH]; cbn; [lra|]. rewrite IH. lra. Qed.

Lemma total_scaled a s ws :
  total a (map (fun p => (s * fst p, snd p)) ws) = s * total a ws.
Proof. induction ws as [|[w r] ws IH]; cbn; [lra|]. rewrite IH. lra. Qed.

Lemma spans_zero rays : spans rays (fun _ => 0).
Proof. exists []. split; [constructor | reflexivity]. Qed.

Lemma spans_same rays p p' : (forall a, p a = p' a) -> spans rays p -> spans rays p'.
Proof. intros E (ws & W & H). exists ws. split; [exact W|]. intros a. now rewrite <- E. Qed.

Lemma spans_sum rays p p' : spans rays p -> spans rays p' -> spans rays (fun a => p a + p' a).
Proof.
  intros (ws & W & H) (ws' & W' & H'). exists (ws ++ ws'). split.
  - now apply Forall_app.
  - intros a. rewrite total_app, H, H'. reflexivity.
Qed.

Lemma spans_multiple rays s p : 0 <= s -> spans rays p -> spans rays (fun a => s * p a).
Proof.
  intros S (ws & W & H). exists (map (fun p => (s * fst p, snd p)) ws). split.
  - apply Forall_map. eapply Forall_impl; [|exact W]. intros [w r] [Hw Hr]; cbn in *.
    split; [apply Rmult_le_pos; assumption | assumption].
  - intros a. now rewrite total_scaled, H.
Qed.

Lemma spans_ray rays r : In r rays -> spans rays (fun a => IZR (dot a r)).
Proof.
  intros H. exists [(1, r)]. split.
  - constructor; [|constructor]. cbn. split; [lra | exact H].
  - intros a. cbn. lra.
Qed.

Lemma spans_weights rays ws : weights rays ws -> spans rays (fun a => total a ws).
Proof. intros W. exists ws. now split. Qed.

(* Rays that are themselves spanned by others may be replaced by these. *)
Lemma spans_trans rays rays' p :
  (forall r, In r rays -> spans rays' (fun a => IZR (dot a r))) ->
  spans rays p -> spans rays' p.
Proof.
  intros R (ws & W & H).
  apply spans_same with (fun a => total a ws); [now intros a; rewrite H|].
  clear H p. induction W as [|[w r] ws [Hw Hr] W IH]; [apply spans_zero|].
  cbn. apply spans_sum; [|exact IH]. apply spans_multiple; [exact Hw|]. now apply R.
Qed.

End Spans.

(* ---- Rays, and the strict functions that are zero on them ---- *)

(* A strict function has one value, or in space three: forms, not all of which are zero at the solutions.
   `zeros` goes with a list of them: whether each is known to be zero on the ray. *)
Record ray := Ray { coordinates : form; zeros : list bool }.

Fixpoint both (a b : list bool) : list bool :=
  match a, b with
  | x :: a', y :: b' => (x && y) :: both a' b'
  | _, _ => []
  end.

Definition knows (strict : list (list form)) (r : ray) :=
  Forall2 (fun fs z => z = true -> forall f, In f fs -> dot f (coordinates r) = 0%Z)
    strict (zeros r).

Definition add_strict (fs : list form) (r : ray) : ray :=
  Ray (coordinates r) (forallb (fun f => Z.eqb (dot f (coordinates r)) 0) fs :: zeros r).

Lemma add_strict_knows fs strict r : knows strict r -> knows (fs :: strict) (add_strict fs r).
Proof.
  intros K. constructor; [|exact K]. cbn. rewrite forallb_forall. intros H f Hf.
  apply Z.eqb_eq. auto.
Qed.

Lemma both_implies (A : Type) (P Q S : A -> Prop) fs a b :
  (forall f, P f -> Q f -> S f) ->
  Forall2 (fun f z => z = true -> P f) fs a -> Forall2 (fun f z => z = true -> Q f) fs b ->
  Forall2 (fun f z => z = true -> S f) fs (both a b).
Proof.
  intros H HA. revert b. induction HA as [|f x fs a Hx HA IH]; intros b HB; inversion HB; subst.
  - constructor.
  - cbn. constructor; [|now apply IH].
    intros E. apply andb_true_iff in E as [E1 E2]. auto.
Qed.

(* A set of rays is barred if some strict function is zero on all of them. *)
Definition common_zeros (strict : list (list form)) (rays : list ray) : list bool :=
  fold_right (fun r z => both (zeros r) z) (map (fun _ => true) strict) rays.

Definition barred (strict : list (list form)) (rays : list ray) : bool :=
  existsb (fun z => z) (common_zeros strict rays).

Lemma barred_by strict rays :
  Forall (knows strict) rays -> barred strict rays = true ->
  exists fs, In fs strict /\ forall r, In r rays -> forall f, In f fs -> dot f (coordinates r) = 0%Z.
Proof.
  intros K. unfold barred.
  assert (F : Forall2 (fun fs z => z = true -> forall r, In r rays ->
                         forall f, In f fs -> dot f (coordinates r) = 0%Z)
                strict (common_zeros strict rays)).
  { induction K as [|r rays Kr K IH].
    - cbn. induction strict; constructor; [intros _ r []|assumption].
    - cbn. eapply both_implies; [|exact Kr|exact IH]. cbn.
      intros f H1 H2 r' [<-|H]; auto. }
  revert F. generalize (common_zeros strict rays) as zs. clear K. intros zs F.
  induction F as [|f z fs zs Hz F IH]; cbn; [discriminate|].
  destruct z; cbn.
  - intros _. exists f. split; [now left | now apply Hz].
  - intros E. destruct (IH E) as (g & Hg & H). exists g. split; [now right | exact H].
Qed.

(* ---- Cutting ---- *)

(* What may be a ray of the part: a ray on the right side, or the combination of one on each side
   that lies on the plane. *)
Inductive candidate :=
  | Stays (r : ray)
  | Joins (x : form) (zeros1 zeros2 : list bool).

Definition form_of (c : candidate) : form :=
  match c with Stays r => coordinates r | Joins x _ _ => x end.

Definition ray_of (c : candidate) : ray :=
  match c with
  | Stays r => r
  | Joins x z1 z2 => Ray (primitive x) (both z1 z2)
  end.

Section Cut.
Open Scope Z_scope.

(* Rays with the values of the form that cuts. *)
Definition heights (a : form) (rays : list ray) : list (Z * ray) :=
  map (fun r => (dot a (coordinates r), r)) rays.

Definition join (p n : Z * ray) : candidate :=
  Joins (combine (fst p) (coordinates (snd n)) (- fst n) (coordinates (snd p)))
    (zeros (snd p)) (zeros (snd n)).

(* In this order: the rays that stay, in theirs; then for each ray above the plane, in their
   order, its combinations with all rays below, in theirs. *)
Definition candidates (equality : bool) (hs : list (Z * ray)) : list candidate :=
  let below := filter (fun p => fst p <? 0) hs in
  map (fun p => Stays (snd p))
    (filter (fun p => if equality then fst p =? 0 else 0 <=? fst p) hs) ++
  flat_map (fun p => map (join p) below) (filter (fun p => 0 <? fst p) hs).

(* The candidates that are kept; and those whose reason to be dropped does not hold. *)
Fixpoint kept (cs : list candidate) (advices : list advice) : list ray :=
  match cs, advices with
  | [], _ => []
  | c :: cs', Drop _ _ :: advices' => kept cs' advices'
  | c :: cs', Keep :: advices' => ray_of c :: kept cs' advices'
  | c :: cs', [] => ray_of c :: kept cs' []
  end.

Definition sum_of_rays (rays : list ray) (terms : list (nat * Z)) : form :=
  fold_right (fun t s => match nth_error rays (fst t) with
                         | Some r => combine (snd t) (coordinates r) 1 s
                         | None => s
                         end) [] terms.

Definition reason_holds (rays : list ray) (x : form) (factor : Z) (terms : list (nat * Z)) :=
  (0 <? factor) && forallb (fun t => 0 <=? snd t) terms &&
  all_zero (combine factor x (-1) (sum_of_rays rays terms)).

Fixpoint unjustified (rays : list ray) (cs : list candidate) (advices : list advice)
    : list ray :=
  match cs, advices with
  | c :: cs', Drop factor terms :: advices' =>
      if reason_holds rays (form_of c) factor terms then unjustified rays cs' advices'
      else ray_of c :: unjustified rays cs' advices'
  | c :: cs', Keep :: advices' => unjustified rays cs' advices'
  | _, _ => []
  end.

Definition cut (rays : list ray) (a : form) (equality : bool) (advices : list advice)
    : list ray :=
  let cs := candidates equality (heights a rays) in
  let rest := kept cs advices in
  rest ++ unjustified rest cs advices.

End Cut.

Section CutProof.
Open Scope R_scope.

(* The point of some weights. *)
Notation at_weights ws := (fun f => total f ws).

Lemma total_nonneg a rays ws :
  weights rays ws -> Forall (fun p => (0 <= dot a (snd p))%Z) ws -> 0 <= total a ws.
Proof.
  intros W A. induction W as [|[w r] ws [Hw Hr] W IH]; cbn; [lra|].
  inversion A; subst; cbn in *. apply IZR_le in H1.
  pose proof (Rmult_le_pos _ _ Hw H1). specialize (IH H2). lra.
Qed.

(* Of rays strictly on one side, a sum on the plane is zero. *)
Lemma total_flat a sign rays ws :
  weights rays ws -> Forall (fun p => (0 < sign * dot a (snd p))%Z) ws -> total a ws = 0 ->
  forall f, total f ws = 0.
Proof.
  intros W A. induction W as [|[w r] ws [Hw Hr] W IH]; cbn; [reflexivity|].
  inversion A as [|? ? A1 A2]; subst; cbn in *. intros E f.
  assert (S : 0 <= IZR sign * total a ws).
  { clear -W A2. induction W as [|[w r] ws [Hw Hr] W IH]; cbn; [lra|].
    inversion A2; subst; cbn in *. apply IZR_lt in H1. rewrite mult_IZR in H1.
    assert (0 <= w * (IZR sign * IZR (dot a r))) by (apply Rmult_le_pos; lra).
    specialize (IH H2). nra. }
  apply IZR_lt in A1. rewrite mult_IZR in A1.
  assert (P : 0 <= w * (IZR sign * IZR (dot a r))) by (apply Rmult_le_pos; lra).
  assert (Z : w * (IZR sign * IZR (dot a r)) = 0) by nra.
  apply Rmult_integral in Z. destruct Z as [Z|Z]; [|lra]. subst w.
  rewrite IH; [lra|exact A2|lra].
Qed.

Variable a : form.
Variable cs : list form.  (* the forms of the candidates *)

(* Rays above and below the plane whose combinations are all there. *)
Variables above below : list form.
Hypothesis above_side : forall p, In p above -> (0 < dot a p)%Z.
Hypothesis below_side : forall n, In n below -> (dot a n < 0)%Z.
Hypothesis combined : forall p n, In p above -> In n below ->
  In (combine (dot a p) n (- dot a n) p) cs.

Lemma pairs_with_one ps n : In n below -> weights above ps ->
  spans cs (fun f => total a ps * IZR (dot f n) - IZR (dot a n) * total f ps).
Proof.
  intros Hn W. induction W as [|[w p] ps [Hw Hp] W IH]; cbn.
  - eapply spans_same; [|apply spans_zero]. intros f; cbn. lra.
  - cbn in *.
    eapply spans_same; [|apply spans_sum; [exact IH|]];
      [|apply spans_multiple; [exact Hw|]; apply spans_ray; apply combined; [exact Hp|exact Hn]].
    intros f; cbn. rewrite dot_combine, plus_IZR, !mult_IZR, opp_IZR. ring.
Qed.

Lemma pairs ps ns : weights above ps -> weights below ns ->
  spans cs (fun f => total a ps * total f ns - total a ns * total f ps).
Proof.
  intros WP WN. induction WN as [|[w n] ns [Hw Hn] WN IH]; cbn.
  - eapply spans_same; [|apply spans_zero]. intros f; cbn. lra.
  - cbn in *. eapply spans_same; [|apply spans_sum; [exact IH|]];
      [|apply spans_multiple; [exact Hw|]; apply (pairs_with_one ps n Hn WP)].
    intros f; cbn. ring.
Qed.

(* A point above the plane, or on it: parts above, on and below it. *)
Lemma spans_part ps zs ns :
  weights above ps -> weights below ns -> spans cs (at_weights zs) -> total a zs = 0 ->
  (0 < total a ps + total a ns -> spans cs (at_weights ps)) ->
  0 <= total a ps + total a ns ->
  spans cs (fun f => total f ps + total f zs + total f ns).
Proof.
  intros WP WN SZ Z SP H.
  assert (P0 : 0 <= total a ps).
  { apply total_nonneg with above; [exact WP|]. eapply Forall_impl; [|exact WP].
    intros p [_ Hp]. apply above_side in Hp. lia. }
  assert (N0 : total a ns <= 0).
  { clear - WN below_side. induction WN as [|[w n] ns [Hw Hn] WN IH]; cbn in *; [lra|].
    apply below_side, IZR_lt in Hn.
    assert (0 <= w * - IZR (dot a n)) by (apply Rmult_le_pos; lra). lra. }
  destruct (Req_dec (total a ps) 0) as [E|NE].
  - assert (FP : forall f, total f ps = 0).
    { apply total_flat with a 1%Z above; [exact WP| |exact E]. eapply Forall_impl; [|exact WP].
      intros p [_ Hp]. apply above_side in Hp. lia. }
    assert (FN : forall f, total f ns = 0).
    { apply total_flat with a (-1)%Z below; [exact WN| |lra]. eapply Forall_impl; [|exact WN].
      intros p [_ Hp]. apply below_side in Hp. lia. }
    eapply spans_same; [|exact SZ]. intros f; cbn. rewrite FP, FN. lra.
  - assert (SPs : spans cs (fun f => (total a ps + total a ns) * total f ps)).
    { destruct (Req_dec (total a ps + total a ns) 0) as [E|NE'].
      - eapply spans_same; [|apply spans_zero]. intros f; cbn. rewrite E. lra.
      - apply spans_multiple; [lra|]. apply SP. lra. }
    eapply spans_same; [|apply spans_multiple with (s := / total a ps);
      [|apply spans_sum; [apply spans_sum; [exact SPs |
          apply spans_multiple with (s := total a ps); [exact P0|exact SZ]] |
        exact (pairs ps ns WP WN)]]].
    + intros f; cbn. field. exact NE.
    + left. apply Rinv_0_lt_compat. lra.
Qed.

End CutProof.

(* The weights, by side. *)
Lemma split_weights a (rays : list form) ws : weights rays ws ->
  exists ps zs ns,
    weights (filter (fun r => 0 <? dot a r)%Z rays) ps /\
    weights (filter (fun r => dot a r =? 0)%Z rays) zs /\
    weights (filter (fun r => dot a r <? 0)%Z rays) ns /\
    forall f, total f ws = (total f ps + total f zs + total f ns)%R.
Proof.
  intros W. induction W as [|[w r] ws [Hw Hr] W IH].
  - exists [], [], []. repeat split; try constructor. intros; cbn; lra.
  - destruct IH as (ps & zs & ns & WP & WZ & WN & E). cbn in Hw, Hr.
    destruct (Z.lt_trichotomy (dot a r) 0) as [H|[H|H]].
    + exists ps, zs, ((w, r) :: ns). repeat split; try assumption.
      * constructor; [|assumption]. split; [exact Hw|]. apply filter_In. split; [exact Hr|].
        cbn. now apply Z.ltb_lt.
      * intros f; cbn. rewrite E. lra.
    + exists ps, ((w, r) :: zs), ns. repeat split; try assumption.
      * constructor; [|assumption]. split; [exact Hw|]. apply filter_In. split; [exact Hr|].
        cbn. now apply Z.eqb_eq.
      * intros f; cbn. rewrite E. lra.
    + exists ((w, r) :: ps), zs, ns. repeat split; try assumption.
      * constructor; [|assumption]. split; [exact Hw|]. apply filter_In. split; [exact Hr|].
        cbn. now apply Z.ltb_lt.
      * intros f; cbn. rewrite E. lra.
Qed.

Lemma weights_on_plane a rays ws :
  weights (filter (fun r => dot a r =? 0)%Z rays) ws -> total a ws = 0%R.
Proof.
  intros W. induction W as [|[w r] ws [Hw Hr] W IH]; cbn in *; [lra|].
  apply filter_In in Hr as [_ Hr]. apply Z.eqb_eq in Hr. rewrite IH, Hr. lra.
Qed.

Lemma weights_mono rays rays' ws :
  (forall r, In r rays -> In r rays') -> weights rays ws -> weights rays' ws.
Proof. intros H W. eapply Forall_impl; [|exact W]. intros p [Hp Hr]. auto. Qed.

Lemma candidates_span rays a (equality : bool) point :
  spans (map coordinates rays) point ->
  (if equality then point a = 0 else 0 <= point a)%R ->
  spans (map form_of (candidates equality (heights a rays))) point.
Proof.
  intros (ws & W & E) S. set (cs := map form_of _).
  destruct (split_weights a _ _ W) as (ps & zs & ns & WP & WZ & WN & EQ).
  assert (In_stays : forall r, In r (map coordinates rays) ->
      (if equality then dot a r = 0 else 0 <= dot a r)%Z -> In r cs).
  { intros r Hr Hs. apply in_map_iff in Hr as (r' & <- & Hr). unfold cs, candidates.
    rewrite map_app. apply in_or_app. left. rewrite map_map. apply in_map_iff.
    exists (dot a (coordinates r'), r'). split; [reflexivity|]. apply filter_In. split.
    - unfold heights. apply in_map_iff. now exists r'.
    - cbn. destruct equality; [now apply Z.eqb_eq | now apply Z.leb_le]. }
  assert (In_joins : forall p n, In p (filter (fun r => 0 <? dot a r)%Z (map coordinates rays)) ->
      In n (filter (fun r => dot a r <? 0)%Z (map coordinates rays)) ->
      In (combine (dot a p) n (- dot a n) p) cs).
  { intros p n Hp Hn. apply filter_In in Hp as [Hp Sp]. apply filter_In in Hn as [Hn Sn].
    apply in_map_iff in Hp as (p' & <- & Hp). apply in_map_iff in Hn as (n' & <- & Hn).
    unfold cs, candidates. rewrite map_app. apply in_or_app. right.
    apply in_map_iff. exists (join (dot a (coordinates p'), p') (dot a (coordinates n'), n')).
    split; [reflexivity|]. apply in_flat_map.
    exists (dot a (coordinates p'), p'). split.
    - apply filter_In. split; [|exact Sp]. unfold heights. apply in_map_iff. now exists p'.
    - apply in_map_iff. exists (dot a (coordinates n'), n'). split; [reflexivity|].
      apply filter_In. split; [|exact Sn]. unfold heights. apply in_map_iff. now exists n'. }
  assert (H : point a = (total a ps + total a ns)%R).
  { rewrite E, EQ, (weights_on_plane _ _ _ WZ). lra. }
  apply spans_same with (fun f => total f ps + total f zs + total f ns)%R.
  { intros f. now rewrite E, EQ. }
  eapply spans_part with (a := a); try eassumption.
  - intros p Hp. apply filter_In in Hp as [_ Hp]. now apply Z.ltb_lt.
  - intros p Hp. apply filter_In in Hp as [_ Hp]. now apply Z.ltb_lt.
  - apply spans_weights. eapply weights_mono; [|exact WZ]. intros r Hr.
    apply filter_In in Hr as [Hr Sr]. apply Z.eqb_eq in Sr. apply In_stays; [exact Hr|].
    destruct equality; lia.
  - apply (weights_on_plane _ _ _ WZ).
  - intros Pos. destruct equality; [lra|]. apply spans_weights.
    eapply weights_mono; [|exact WP]. intros r Hr.
    apply filter_In in Hr as [Hr Sr]. apply Z.ltb_lt in Sr. apply In_stays; [exact Hr|]. lia.
  - destruct equality; lra.
Qed.

Lemma candidate_spanned rays c : In (ray_of c) rays ->
  spans (map coordinates rays) (fun f => IZR (dot f (form_of c))).
Proof.
  intros H. destruct c as [r|x z1 z2]; cbn in *.
  - apply spans_ray. now apply in_map.
  - apply spans_same with (fun f => IZR (content x) * IZR (dot f (primitive x)))%R.
    { intros f. now rewrite <- mult_IZR, <- dot_primitive. }
    apply spans_multiple.
    + apply IZR_le. pose proof (content_positive x). lia.
    + apply spans_ray. apply in_map_iff. exists (Ray (primitive x) (both z1 z2)). now split.
Qed.

Lemma sum_spanned rays terms :
  forallb (fun t => 0 <=? snd t)%Z terms = true ->
  spans (map coordinates rays) (fun f => IZR (dot f (sum_of_rays rays terms))).
Proof.
  induction terms as [|[i c] terms IH]; cbn.
  - intros _. eapply spans_same; [|apply spans_zero]. intros f; cbn. now rewrite dot_nil_r.
  - rewrite andb_true_iff. intros [Hc Ht]. specialize (IH Ht).
    destruct (nth_error rays i) as [r|] eqn:Hr; [|exact IH].
    eapply spans_same; [|apply spans_sum; [|exact IH]; apply spans_multiple with (s := IZR c);
      [apply IZR_le; now apply Z.leb_le|]; apply spans_ray; apply in_map;
      eapply nth_error_In; exact Hr].
    intros f; cbn. rewrite dot_combine, plus_IZR, !mult_IZR. fold (sum_of_rays rays terms). lra.
Qed.

Lemma reason_spans rays x factor terms : reason_holds rays x factor terms = true ->
  spans (map coordinates rays) (fun f => IZR (dot f x)).
Proof.
  unfold reason_holds. rewrite !andb_true_iff. intros [[Hf Ht] Hz].
  apply Z.ltb_lt in Hf. apply IZR_lt in Hf.
  apply spans_same with (fun f => / IZR factor * IZR (dot f (sum_of_rays rays terms)))%R.
  - intros f. pose proof (dot_all_zero f _ Hz) as E. rewrite dot_combine in E.
    assert (E' : (dot f (sum_of_rays rays terms) = factor * dot f x)%Z) by lia.
    rewrite E', mult_IZR. field. lra.
  - apply spans_multiple; [left; now apply Rinv_0_lt_compat|]. now apply sum_spanned.
Qed.

Lemma spans_mono rays rays' point :
  (forall r, In r rays -> In r rays') -> spans rays point -> spans rays' point.
Proof. intros H (ws & W & E). exists ws. split; [|exact E]. eapply weights_mono; eassumption. Qed.

Lemma candidates_justified cs advices rest c :
  (forall r, In r (kept cs advices) -> In r rest) -> In c cs ->
  spans (map coordinates (rest ++ unjustified rest cs advices))
    (fun f => IZR (dot f (form_of c))).
Proof.
  set (all := rest ++ unjustified rest cs advices).
  assert (A : forall r, In r (unjustified rest cs advices) -> In r all)
    by (intros; apply in_or_app; now right).
  assert (B : forall r, In r rest -> In r all) by (intros; apply in_or_app; now left).
  clearbody all. revert advices A. induction cs as [|c' cs IH]; [intros ? ? ? []|].
  intros advices A K [->|Hc].
  - destruct advices as [|[|factor terms] advices]; cbn in *.
    + apply candidate_spanned. auto.
    + apply candidate_spanned. auto.
    + destruct (reason_holds rest (form_of c) factor terms) eqn:E.
      * apply reason_spans in E. eapply spans_mono; [|exact E]. intros r Hr.
        apply in_map_iff in Hr as (r' & <- & Hr). apply in_map. auto.
      * apply candidate_spanned. apply A. now left.
  - destruct advices as [|[|factor terms] advices]; cbn in *.
    + apply (IH []); auto. now destruct cs.
    + apply (IH advices); auto.
    + apply (IH advices); auto. intros r Hr. apply A.
      destruct (reason_holds rest (form_of c') factor terms); [exact Hr | now right].
Qed.

(* What lies in the cone and on the right side of the plane is in the cut cone. *)
Theorem cut_keeps_region rays a (equality : bool) advices point :
  spans (map coordinates rays) point ->
  (if equality then point a = 0 else 0 <= point a)%R ->
  spans (map coordinates (cut rays a equality advices)) point.
Proof.
  intros S H. pose proof (candidates_span rays a equality point S H) as C.
  eapply spans_trans; [|exact C]. intros r Hr. apply in_map_iff in Hr as (c & <- & Hc).
  unfold cut. apply candidates_justified; auto.
Qed.

(* The new rays know which strict functions are zero on them. *)
Lemma candidate_knows strict rays a equality c :
  Forall (knows strict) rays -> In c (candidates equality (heights a rays)) ->
  knows strict (ray_of c).
Proof.
  intros K H. rewrite Forall_forall in K. unfold candidates in H.
  apply in_app_or in H as [H|H].
  - apply in_map_iff in H as ([h r] & <- & H). apply filter_In in H as [H _].
    apply in_map_iff in H as (r' & E & H). inversion E; subst. cbn. auto.
  - apply in_flat_map in H as ([h p] & Hp & H). apply in_map_iff in H as ([h' n] & <- & Hn).
    apply filter_In in Hp as [Hp _]. apply filter_In in Hn as [Hn _].
    apply in_map_iff in Hp as (p' & E & Hp). apply in_map_iff in Hn as (n' & E' & Hn).
    inversion E; subst. inversion E'; subst. cbn. unfold knows; cbn.
    eapply both_implies; [|exact (K _ Hp)|exact (K _ Hn)]. cbn. intros fs Fp Fn f Hf.
    specialize (Fp f Hf). specialize (Fn f Hf). set (x := combine _ _ _ _).
    assert (X : dot f x = 0%Z) by (unfold x; rewrite dot_combine, Fp, Fn; lia).
    rewrite dot_primitive in X. pose proof (content_positive x).
    apply Z.mul_eq_0 in X as [X|X]; [lia | exact X].
Qed.

Theorem cut_knows strict rays a equality advices :
  Forall (knows strict) rays -> Forall (knows strict) (cut rays a equality advices).
Proof.
  intros K. unfold cut. set (cs := candidates equality (heights a rays)).
  assert (C : forall c, In c cs -> knows strict (ray_of c))
    by (intros c Hc; eapply candidate_knows; eassumption).
  clearbody cs. apply Forall_app. split.
  - revert advices. induction cs as [|c cs IH]; intros [|[|]]; cbn; try constructor;
      try (apply C; now left); apply IH; intros; apply C; now right.
  - generalize (kept cs advices) as rest. intros rest. revert advices.
    induction cs as [|c cs IH]; intros [|[|factor terms] advices]; cbn; try constructor.
    + apply IH. intros; apply C; now right.
    + destruct (reason_holds rest (form_of c) factor terms); [|constructor];
        try (apply C; now left); apply IH; intros; apply C; now right.
Qed.
