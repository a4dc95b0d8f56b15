(* SPDX-License-Identifier: MIT *)
(** Lists can have a million elements, so what goes through them uses constant stack. *)
From Coq Require Import List Lia ZArith.
Import ListNotations.

Definition map_all {A B : Type} (f : A -> B) (items : list A) : list B :=
  rev_append (fold_left (fun done item => f item :: done) items []) [].

Lemma map_all_is {A B} (f : A -> B) items : map_all f items = map f items.
Proof.
  unfold map_all. rewrite rev_append_rev, app_nil_r, <- fold_left_rev_right.
  rewrite <- (rev_involutive (map f items)). f_equal. rewrite <- map_rev.
  induction (rev items) as [|a l IH]; cbn; [reflexivity|]. now rewrite IH.
Qed.

Section AllSome.
  Context {A B : Type}.
  Variable f : A -> option B.

  Fixpoint all_some_after (items : list A) (before : list B) : option (list B) :=
    match items with
    | [] => Some (rev_append before [])
    | item :: rest =>
        match f item with
        | Some it => all_some_after rest (it :: before)
        | None => None
        end
    end.

  (** What [f] makes of all items, if it makes something of each. *)
  Definition all_some (items : list A) : option (list B) := all_some_after items [].

  Lemma all_some_is items them : all_some items = Some them ->
    Forall2 (fun item it => f item = Some it) items them.
  Proof.
    unfold all_some. assert (G : forall items before them, all_some_after items before = Some them ->
      exists rest, them = rev before ++ rest /\ Forall2 (fun item it => f item = Some it) items rest).
    { induction items0 as [|item items0 IH]; intros before them0; cbn.
      - intros E. injection E as <-. exists []. rewrite rev_append_rev. split; [reflexivity|constructor].
      - destruct (f item) as [it|] eqn:E; [|discriminate]. intros H.
        destruct (IH _ _ H) as (rest & -> & F). exists (it :: rest). split.
        + cbn. now rewrite <- app_assoc.
        + now constructor. }
    intros H. destruct (G _ _ _ H) as (rest & -> & F). exact F.
  Qed.
End AllSome.

(** By its number, from 0. *)
Fixpoint numbered {A} (l : list A) (i : Z) : option A :=
  match l with
  | [] => None
  | a :: l' => if (i =? 0)%Z then Some a else numbered l' (i - 1)%Z
  end.

Lemma numbered_is {A} (l : list A) i a : numbered l i = Some a ->
  exists k, i = Z.of_nat k /\ nth_error l k = Some a.
Proof.
  revert i. induction l as [|b l IH]; intros i H; cbn in H; [discriminate|].
  destruct (Z.eqb_spec i 0) as [Z|Z].
  - exists O. split; [lia|exact H].
  - destruct (IH _ H) as (k & E & N). exists (S k). split; [lia|exact N].
Qed.

Lemma Forall2_weaken {A B} (P P' : A -> B -> Prop) l l' :
  (forall a b, P a b -> P' a b) -> Forall2 P l l' -> Forall2 P' l l'.
Proof. intros H. induction 1; constructor; auto. Qed.
