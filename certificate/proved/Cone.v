(* SPDX-License-Identifier: MIT *)
(* Polyhedral cones by rays in integers: what they span, and which strict functions are zero on them. *)
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
   `zeros` goes with a list of them: whether each is known to be zero on the ray.  The bits of `tight` go with
   the sides of the region, the forms that cut it: which are zero on the ray. *)
Record ray := Ray { coordinates : form; zeros : list bool; tight : Z }.

Fixpoint both (a b : list bool) : list bool :=
  match a, b with
  | x :: a', y :: b' => (x && y) :: both a' b'
  | _, _ => []
  end.

Definition knows (strict : list (list form)) (r : ray) :=
  Forall2 (fun fs z => z = true -> forall f, In f fs -> dot f (coordinates r) = 0%Z)
    strict (zeros r).

Definition add_strict (fs : list form) (r : ray) : ray :=
  Ray (coordinates r) (forallb (fun f => Z.eqb (dot f (coordinates r)) 0) fs :: zeros r) (tight r).

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
