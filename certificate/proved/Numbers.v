(* SPDX-License-Identifier: MIT *)
(* From rationals to integers: common denominators, division that rounds up, square roots between
   rationals; and multilinear functions, by their values at the corners of a box. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning.
Import ListNotations.

(* ---- Common denominators ---- *)

Section Denominators.
Open Scope Z_scope.

Definition common_denominator (qs : list Q) : Z :=
  fold_right (fun q d => Z.lcm (Zpos (Qden q)) d) 1 qs.

Lemma common_denominator_positive qs : 0 < common_denominator qs.
Proof.
  induction qs as [|q qs IH]; cbn [common_denominator fold_right]; [lia|].
  fold (common_denominator qs). pose proof (Z.lcm_nonneg (Zpos (Qden q)) (common_denominator qs)).
  assert (Z.lcm (Zpos (Qden q)) (common_denominator qs) <> 0); [|lia].
  rewrite Z.lcm_eq_0. lia.
Qed.

Lemma common_denominator_divided qs q :
  In q qs -> (Zpos (Qden q) | common_denominator qs).
Proof.
  induction qs as [|q' qs IH]; [intros []|]. cbn [common_denominator fold_right].
  fold (common_denominator qs). intros [<-|H].
  - apply Z.divide_lcm_l.
  - eapply Z.divide_trans; [apply IH, H | apply Z.divide_lcm_r].
Qed.

(* The rationals are times / over times integers. *)
Record scaling := Scaling { over : Z; times : Z }.

Definition numerator (d : Z) (q : Q) : Z := Qnum q * (d / Zpos (Qden q)).

Definition scaling_of (qs : list Q) : scaling :=
  let d := common_denominator qs in Scaling d (content (map (numerator d) qs)).

Definition to_integer (s : scaling) (q : Q) : Z := numerator (over s) q / times s.

End Denominators.

Section DenominatorsProof.
Open Scope R_scope.

Definition unit (s : scaling) : R := IZR (times s) / IZR (over s).

Lemma over_positive qs : 0 < IZR (over (scaling_of qs)).
Proof. apply IZR_lt. apply common_denominator_positive. Qed.

Lemma times_positive qs : 0 < IZR (times (scaling_of qs)).
Proof. apply IZR_lt. apply content_positive. Qed.

Lemma unit_positive qs : 0 < unit (scaling_of qs).
Proof. apply Rdiv_lt_0_compat; [apply times_positive | apply over_positive]. Qed.

Lemma to_integer_exact qs q : In q qs ->
  Q2R q = unit (scaling_of qs) * IZR (to_integer (scaling_of qs) q).
Proof.
  intros H. pose proof (over_positive qs) as PO. unfold unit.
  assert (E : numerator (over (scaling_of qs)) q
              = (times (scaling_of qs) * to_integer (scaling_of qs) q)%Z).
  { apply content_divides with (a := map (numerator (common_denominator qs)) qs).
    now apply in_map with (f := numerator (common_denominator qs)). }
  assert (D : (over (scaling_of qs) = Zpos (Qden q) * (over (scaling_of qs) / Zpos (Qden q)))%Z).
  { apply Z_div_exact_full_2; [lia|]. apply Z.mod_divide; [lia|].
    now apply common_denominator_divided. }
  apply (f_equal IZR) in E, D. unfold numerator in E. rewrite !mult_IZR in *.
  set (o := IZR (over (scaling_of qs))) in *.
  set (c := IZR (over (scaling_of qs) / Zpos (Qden q))) in *.
  assert (PD : 0 < IZR (Zpos (Qden q))) by (apply IZR_lt; lia).
  unfold Q2R. apply Rmult_eq_reg_l with o; [|lra].
  replace (o * (IZR (times (scaling_of qs)) / o * IZR (to_integer (scaling_of qs) q)))
    with (IZR (times (scaling_of qs)) * IZR (to_integer (scaling_of qs) q)) by (field; lra).
  rewrite <- E, D at 1. field. lra.
Qed.

(* A vector of rationals at a real point. *)
Fixpoint qdot (a : list Q) (x : list R) : R :=
  match a, x with
  | q :: a', y :: x' => Q2R q * y + qdot a' x'
  | _, _ => 0
  end.

Lemma qdot_to_integers qs a x : (forall q, In q a -> In q qs) ->
  qdot a x = unit (scaling_of qs) * rdot (map (to_integer (scaling_of qs)) a) x.
Proof.
  revert x; induction a as [|q a IH]; intros x H; [cbn; ring|].
  destruct x as [|y x]; [cbn; ring|]. cbn.
  rewrite (to_integer_exact qs q), IH; [ring| |]; intros; apply H; cbn; auto.
Qed.

Lemma rdot_integers a b : rdot a (map IZR b) = IZR (dot a b).
Proof.
  revert b; induction a as [|x a IH]; intros [|y b]; cbn; try reflexivity.
  now rewrite plus_IZR, mult_IZR, IH.
Qed.

Lemma rdot_combine p a q b x :
  rdot (combine p a q b) x = IZR p * rdot a x + IZR q * rdot b x.
Proof.
  assert (S : forall c a x, rdot (map (Z.mul c) a) x = IZR c * rdot a x).
  { intros c. induction a0 as [|z a0 IH]; intros [|y x0]; cbn; try ring.
    rewrite IH, mult_IZR. ring. }
  revert b x; induction a as [|z a IH]; intros [|z' b] [|y x]; cbn; try ring.
  - rewrite S, mult_IZR. ring.
  - rewrite S, mult_IZR. ring.
  - rewrite IH, plus_IZR, !mult_IZR. ring.
Qed.

Lemma rdot_scaled c a x : rdot (map (Z.mul c) a) x = IZR c * rdot a x.
Proof.
  revert x. induction a as [|z a IH]; intros [|y x]; cbn; try ring.
  rewrite IH, mult_IZR. ring.
Qed.

(* a / b, rounded up. *)
Definition up (a b : Z) : Z := (- (- a / b))%Z.

Lemma up_above a b : (0 < b)%Z -> IZR a / IZR b <= IZR (up a b).
Proof.
  intros B. assert (H : (a <= b * up a b)%Z).
  { unfold up. pose proof (Z_mult_div_ge (- a) b). lia. }
  apply IZR_le in H. rewrite mult_IZR in H. apply IZR_lt in B.
  apply Rmult_le_reg_l with (IZR b); [exact B|]. field_simplify; lra.
Qed.

End DenominatorsProof.

(* ---- Intervals ---- *)

Definition certain (i : interval) : bool := Qeq_bool (low i) (high i).

Definition ends (i : interval) : list Q := if certain i then [low i] else [low i; high i].

Section Ends.
Open Scope R_scope.

Lemma certain_within i x : certain i = true -> within i x -> x = Q2R (low i).
Proof.
  unfold certain, within. intros E H. apply Qeq_bool_eq, Qeq_eqR in E. lra.
Qed.

(* A function that is linear in a parameter is largest at an end. *)
Lemma at_ends i x A B U : within i x ->
  (forall q, In q (ends i) -> A + B * Q2R q <= U) -> A + B * x <= U.
Proof.
  intros W H. unfold ends in H. destruct (certain i) eqn:E.
  - rewrite (certain_within _ _ E W). apply H. now left.
  - pose proof (H _ (or_introl eq_refl)). pose proof (H _ (or_intror (or_introl eq_refl))).
    destruct W. destruct (Rle_dec 0 B); nra.
Qed.

(* Where a number is in its interval: 0 at the low, 1 at the high end. *)
Definition share (i : interval) (x : R) : list R :=
  if certain i then [] else [(x - Q2R (low i)) / (Q2R (high i) - Q2R (low i))].

Definition is_share (t : R) := 0 <= t <= 1.

Lemma uncertain_positive i x :
  certain i = false -> within i x -> 0 < Q2R (high i) - Q2R (low i).
Proof.
  intros E [H H']. destruct (Req_dec (Q2R (low i)) (Q2R (high i))) as [Q|]; [|lra].
  apply eqR_Qeq in Q. apply Qeq_eq_bool in Q. unfold certain in E. congruence.
Qed.

Lemma share_in i x : within i x -> Forall is_share (share i x).
Proof.
  intros W. unfold share. destruct (certain i) eqn:E; constructor; [|constructor].
  pose proof (uncertain_positive _ _ E W) as P. destruct W. split.
  - apply Rmult_le_pos; [lra|]. left. now apply Rinv_0_lt_compat.
  - apply Rmult_le_reg_r with (Q2R (high i) - Q2R (low i)); [exact P|]. field_simplify; lra.
Qed.

End Ends.

(* ---- Multilinear functions ---- *)

(* Values at the corners of a box of up to three uncertain parameters; where the first is low, and
   where it is high. *)
Inductive multi (A : Type) := Tip (a : A) | Fork (lows highs : multi A).
Arguments Tip {A}.
Arguments Fork {A}.

Fixpoint mmap {A B : Type} (f : A -> B) (t : multi A) : multi B :=
  match t with Tip a => Tip (f a) | Fork l h => Fork (mmap f l) (mmap f h) end.

Fixpoint tips {A : Type} (t : multi A) : list A :=
  match t with Tip a => [a] | Fork l h => tips l ++ tips h end.

Definition lows {A : Type} (t : multi A) := match t with Tip a => t | Fork l _ => l end.
Definition highs {A : Type} (t : multi A) := match t with Tip a => t | Fork _ h => h end.

Fixpoint first_tip {A : Type} (t : multi A) : A :=
  match t with Tip a => a | Fork l _ => first_tip l end.

(* f at the ends of a parameter. *)
Definition spread {A : Type} (i : interval) (f : Q -> multi A) : multi A :=
  if certain i then f (low i) else Fork (f (low i)) (f (high i)).

Section Multilinear.
Open Scope R_scope.

(* The function of which `f` of the tips are the values at corners. *)
Fixpoint eval {A : Type} (f : A -> R) (t : multi A) (shares : list R) : R :=
  match t with
  | Tip a => f a
  | Fork l h =>
      match shares with
      | [] => eval f l []
      | s :: shares' => (1 - s) * eval f l shares' + s * eval f h shares'
      end
  end.

Lemma eval_mmap {A B} (g : A -> B) f t ss : eval f (mmap g t) ss = eval (fun a => f (g a)) t ss.
Proof.
  revert ss; induction t as [a|l IHl h IHh]; intros ss; cbn; [reflexivity|].
  destruct ss; now rewrite ?IHl, ?IHh.
Qed.

Lemma eval_same {A} (f g : A -> R) t ss :
  (forall a, In a (tips t) -> f a = g a) -> eval f t ss = eval g t ss.
Proof.
  revert ss; induction t as [a|l IHl h IHh]; intros ss H; cbn in *; [apply H; now left|].
  assert (Hl : forall ss, eval f l ss = eval g l ss)
    by (intros; apply IHl; intros; apply H; apply in_or_app; auto).
  assert (Hh : forall ss, eval f h ss = eval g h ss)
    by (intros; apply IHh; intros; apply H; apply in_or_app; auto).
  destruct ss; now rewrite ?Hl, ?Hh.
Qed.

Lemma eval_multiple {A} c (f : A -> R) t ss : eval (fun a => c * f a) t ss = c * eval f t ss.
Proof.
  revert ss; induction t as [a|l IHl h IHh]; intros ss; cbn; [reflexivity|].
  destruct ss; rewrite ?IHl, ?IHh; ring.
Qed.

Lemma eval_least {A} (f : A -> R) t ss c : Forall is_share ss ->
  (forall a, In a (tips t) -> c <= f a) -> c <= eval f t ss.
Proof.
  revert ss; induction t as [a|l IHl h IHh]; intros ss S H; cbn in *; [apply H; now left|].
  assert (Hl : forall ss, Forall is_share ss -> c <= eval f l ss)
    by (intros; apply IHl; [assumption|]; intros; apply H; apply in_or_app; auto).
  assert (Hh : forall ss, Forall is_share ss -> c <= eval f h ss)
    by (intros; apply IHh; [assumption|]; intros; apply H; apply in_or_app; auto).
  destruct S as [|s ss Hs S]; [apply Hl; constructor|].
  specialize (Hl ss S). specialize (Hh ss S). destruct Hs. nra.
Qed.

Lemma eval_most {A} (f : A -> R) t ss c : Forall is_share ss ->
  (forall a, In a (tips t) -> f a <= c) -> eval f t ss <= c.
Proof.
  intros S H. assert (- c <= eval (fun a => -1 * f a) t ss).
  { apply eval_least; [exact S|]. intros a Ha. specialize (H a Ha). lra. }
  rewrite eval_multiple in H0. lra.
Qed.

(* A value of 0 that is the least has a corner where it is 0. *)
Lemma eval_zero {A} (f : A -> R) t ss : Forall is_share ss ->
  (forall a, In a (tips t) -> 0 <= f a) -> eval f t ss = 0 ->
  exists a, In a (tips t) /\ f a = 0.
Proof.
  revert ss; induction t as [a|l IHl h IHh]; intros ss S H E; cbn in *; [exists a; auto|].
  assert (Hl : forall ss, Forall is_share ss -> 0 <= eval f l ss)
    by (intros; apply eval_least; [assumption|]; intros; apply H; apply in_or_app; auto).
  assert (Hh : forall ss, Forall is_share ss -> 0 <= eval f h ss)
    by (intros; apply eval_least; [assumption|]; intros; apply H; apply in_or_app; auto).
  assert (L : forall ss, Forall is_share ss -> eval f l ss = 0 ->
             exists a, In a (tips l ++ tips h) /\ f a = 0).
  { intros ss' S' E'. destruct (IHl ss' S') as (a & Ha & Fa); [|exact E'|].
    - intros; apply H; apply in_or_app; auto.
    - exists a. split; [apply in_or_app; auto|exact Fa]. }
  destruct S as [|s ss Hs S]; [apply (L []); [constructor|exact E]|].
  specialize (Hl ss S). specialize (Hh ss S). destruct Hs.
  destruct (Req_dec (eval f l ss) 0) as [El|El]; [now apply (L ss)|].
  destruct (IHh ss S) as (a & Ha & Fa); [| |exists a; split; [apply in_or_app; auto|exact Fa]].
  - intros; apply H; apply in_or_app; auto.
  - assert (s = 1) by nra. subst s. lra.
Qed.

Lemma eval_lows_highs {A} (f : A -> R) t s ss :
  eval f t (s :: ss) = (1 - s) * eval f (lows t) ss + s * eval f (highs t) ss.
Proof. destruct t; cbn; [ring|reflexivity]. Qed.

Lemma eval_first {A} (f : A -> R) t : eval f t [] = f (first_tip t).
Proof. induction t; cbn; auto. Qed.

Definition affine (F : R -> R) := exists A B, forall x, F x = A + B * x.

Lemma eval_spread {A} i (f : Q -> multi A) g (F : R -> R) x ss : within i x -> affine F ->
  (forall q, eval g (f q) ss = F (Q2R q)) -> eval g (spread i f) (share i x ++ ss) = F x.
Proof.
  intros W (A' & B & E) H. unfold spread, share. destruct (certain i) eqn:C.
  - cbn. rewrite H, (certain_within _ _ C W). reflexivity.
  - cbn. rewrite !H, !E. pose proof (uncertain_positive _ _ C W). field. lra.
Qed.

Lemma eval_sum {A} (f g : A -> R) t ss :
  eval (fun a => f a + g a) t ss = eval f t ss + eval g t ss.
Proof.
  revert ss. induction t as [a|l IHl h IHh]; intros ss; cbn; [reflexivity|].
  destruct ss; rewrite ?IHl, ?IHh; ring.
Qed.

Lemma eval_constant {A} c (t : multi A) ss : eval (fun _ => c) t ss = c.
Proof.
  revert ss. induction t as [a|l IHl h IHh]; intros ss; cbn; [reflexivity|].
  destruct ss; rewrite ?IHl, ?IHh; ring.
Qed.

(* A function of several parameters, at the corners of their box. *)
Fixpoint corners {A : Type} (box : list interval) (f : list Q -> A) : multi A :=
  match box with
  | [] => Tip (f [])
  | i :: box' => spread i (fun q => corners box' (fun qs => f (q :: qs)))
  end.

Fixpoint box_shares (box : list interval) (p : list R) : list R :=
  match box, p with
  | i :: box', x :: p' => share i x ++ box_shares box' p'
  | _, _ => []
  end.

Lemma shares_good box p : Forall2 within box p -> Forall is_share (box_shares box p).
Proof.
  intros F. induction F as [|i x box p W F IH]; cbn; [constructor|]. apply Forall_app. split; [|exact IH].
  now apply share_in.
Qed.

Fixpoint multiaffine (n : nat) (F : list R -> R) : Prop :=
  match n with
  | O => True
  | S n' => (forall p, List.length p = n' -> affine (fun x => F (x :: p))) /\
            (forall x, multiaffine n' (fun p => F (x :: p)))
  end.

Lemma same_length {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' -> List.length l = List.length l'.
Proof. induction 1; cbn; congruence. Qed.

Lemma eval_corners {A} box (f : list Q -> A) g F p : Forall2 within box p ->
  multiaffine (List.length box) F -> (forall qs, g (f qs) = F (map Q2R qs)) ->
  eval g (corners box f) (box_shares box p) = F p.
Proof.
  intros W. revert f F. induction W as [|i x box p Wx W IH]; intros f F M E; cbn [corners box_shares].
  - exact (E []).
  - destruct M as [Mx M]. apply (eval_spread i _ g (fun x => F (x :: p))); [exact Wx| |].
    + apply Mx. symmetry. now apply same_length in W.
    + intros q. apply (IH _ (fun p => F (Q2R q :: p))); [apply M|]. intros qs. apply E.
Qed.

(* ---- A bound of a sum of products of multilinear functions ---- *)

(* Each product is a polynomial of degree at most 2 in each parameter: its Bernstein coefficients,
   times 2 for each parameter, are linear forms of the point at which the second factors are
   evaluated. *)
Definition product (pairs : list (multi Z * multi form)) : form :=
  fold_right (fun p s => combine (first_tip (fst p)) (first_tip (snd p)) 1 s) [] pairs.

Fixpoint bernstein (parameters : nat) (pairs : list (multi Z * multi form)) : list form :=
  match parameters with
  | O => [product pairs]
  | S n =>
      map (map (Z.mul 2)) (bernstein n (map (fun p => (lows (fst p), lows (snd p))) pairs)) ++
      bernstein n (flat_map (fun p => [(lows (fst p), highs (snd p));
                                       (highs (fst p), lows (snd p))]) pairs) ++
      map (map (Z.mul 2)) (bernstein n (map (fun p => (highs (fst p), highs (snd p))) pairs))
  end.

Fixpoint products (pairs : list (multi Z * multi form)) (x ss : list R) : R :=
  match pairs with
  | [] => 0
  | (a, v) :: pairs' =>
      eval IZR a ss * eval (fun f => rdot f x) v ss + products pairs' x ss
  end.

Fixpoint power (n : nat) : Z := match n with O => 1 | S n' => 2 * power n' end.

Lemma power_positive n : 0 < IZR (power n).
Proof. induction n; cbn [power]; [lra|]. rewrite mult_IZR. lra. Qed.

Theorem bernstein_bound n pairs x ss U : List.length ss = n -> Forall is_share ss ->
  (forall f, In f (bernstein n pairs) -> rdot f x <= U) ->
  IZR (power n) * products pairs x ss <= U.
Proof.
  revert pairs ss U. induction n as [|n IH]; intros pairs ss U L S H.
  - destruct ss; [|discriminate]. cbn [power bernstein] in *.
    specialize (H _ (or_introl eq_refl)). rewrite Rmult_1_l.
    replace (products pairs x []) with (rdot (product pairs) x); [exact H|].
    clear. induction pairs as [|[a v] pairs IH]; cbn; [reflexivity|].
    fold (product pairs). rewrite rdot_combine, IH, !eval_first. ring.
  - destruct ss as [|s ss]; [discriminate|]. inversion L. inversion S as [|? ? [S0 S1] S']; subst.
    set (lo := map (fun p => (lows (fst p), lows (snd p))) pairs) in *.
    set (hi := map (fun p => (highs (fst p), highs (snd p))) pairs) in *.
    set (mid := flat_map (fun p => [(lows (fst p), highs (snd p));
                                    (highs (fst p), lows (snd p))]) pairs) in *.
    assert (Lo : IZR (power (List.length ss)) * products lo x ss <= U / 2).
    { apply IH; [reflexivity|exact S'|]. intros f Hf.
      assert (rdot (map (Z.mul 2) f) x <= U); [|rewrite rdot_scaled in *; lra].
      apply H. cbn [bernstein]. apply in_or_app. left. apply in_map. exact Hf. }
    assert (Hi : IZR (power (List.length ss)) * products hi x ss <= U / 2).
    { apply IH; [reflexivity|exact S'|]. intros f Hf.
      assert (rdot (map (Z.mul 2) f) x <= U); [|rewrite rdot_scaled in *; lra].
      apply H. cbn [bernstein]. apply in_or_app. right. apply in_or_app. right.
      apply in_map. exact Hf. }
    assert (Mid : IZR (power (List.length ss)) * products mid x ss <= U).
    { apply IH; [reflexivity|exact S'|]. intros f Hf. apply H. cbn [bernstein].
      apply in_or_app. right. apply in_or_app. left. exact Hf. }
    assert (E : products pairs x (s :: ss) = (1 - s) * (1 - s) * products lo x ss
                + (1 - s) * s * products mid x ss + s * s * products hi x ss).
    { subst lo hi mid. clear. induction pairs as [|[a v] pairs IH]; cbn -[eval]; [ring|].
      rewrite IH, !eval_lows_highs. ring. }
    cbn [power]. rewrite mult_IZR, E. set (p := IZR (power (List.length ss))) in *.
    assert (0 <= (1 - s) * (1 - s)) by nra. assert (0 <= (1 - s) * s) by nra.
    assert (0 <= s * s) by nra. nra.
Qed.

End Multilinear.
