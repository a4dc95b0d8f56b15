(* SPDX-License-Identifier: MIT *)
(** Lists can have a million elements, so what goes through them uses constant stack. *)
From Coq Require Import List.
Import ListNotations.

Definition map_all {A B : Type} (f : A -> B) (items : list A) : list B :=
  rev_append (fold_left (fun done item => f item :: done) items []) [].

Lemma map_all_is {A B} (f : A -> B) items : map_all f items = map f items.
Proof.
  unfold map_all. rewrite rev_append_rev, app_nil_r, <- fold_left_rev_right.
  rewrite <- (rev_involutive (map f items)). f_equal. rewrite <- map_rev.
  induction (rev items) as [|a l IH]; cbn; [reflexivity|]. now rewrite IH.
Qed.
