(* SPDX-License-Identifier: MIT *)
(** Square roots of rationals, where they are rational. *)
From Coq Require Import Lia QArith ZArith.
Local Open Scope Z_scope.

(** The root of [x] >= 0, if it is rational: the root of p/q is that of pq, over q. *)
Definition exact_root (x : Q) : option Q :=
  let square := Qnum x * Zpos (Qden x) in
  let root := Z.sqrt square in
  if root * root =? square then Some (Qmake root (Qden x)) else None.

Lemma exact_root_is_root : forall x root,
  exact_root x = Some root -> (root * root == x /\ 0 <= root)%Q.
Proof.
  intros [p q] root. unfold exact_root. simpl.
  destruct (_ =? _) eqn:equal; intros [= <-]. apply Z.eqb_eq in equal. split.
  - unfold Qeq. simpl. rewrite equal. lia.
  - unfold Qle. simpl. pose proof (Z.sqrt_nonneg (p * Zpos q)). lia.
Qed.
