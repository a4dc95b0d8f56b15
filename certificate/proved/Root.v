(* SPDX-License-Identifier: MIT *)
(** Square roots of rationals: where they are rational, and between rationals where not. *)
From Coq Require Import Bool Lia Lra QArith Qreals Reals ZArith.
From Proved Require Import Question.
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

(** Lowest terms, and neighbours of so many bits. What is computed here is checked where it is used. *)
Definition is_square (z : Z) : bool := let r := Z.sqrt z in r * r =? z.

Definition reduced (q : Q) : Q :=
  let g := Z.gcd (Qnum q) (Zpos (Qden q)) in
  Qmake (Qnum q / g) (Z.to_pos (Zpos (Qden q) / g)).

(* j/2^s <= sqrt q < (j+1)/2^s with 2^(bits-1) <= j < 2^bits; q > 0 in lowest terms. *)
Definition root_between (bits : Z) (q : Q) : interval :=
  let n := Qnum q in
  let d := Zpos (Qden q) in
  if is_square n && is_square d then
    exactly (Qmake (Z.sqrt n) (Z.to_pos (Z.sqrt d)))
  else
    let root (s : Z) :=       (* floor (2^s sqrt q) *)
      if 0 <=? s then Z.sqrt (Z.shiftl n (2 * s) / d) else Z.sqrt (n / Z.shiftl d (-2 * s)) in
    (* 2^(log2 q / 2) is sqrt q up to a factor of 2. *)
    let s := bits - (Z.log2 n - Z.log2 d) / 2 in
    let s := if root s <? Z.shiftl 1 bits then s else s - 1 in
    let s := if root s <? Z.shiftl 1 bits then s else s - 1 in
    let j := root s in
    let over (j : Z) :=
      if 0 <=? s then reduced (Qmake j (Z.to_pos (Z.shiftl 1 s)))
      else Qmake (Z.shiftl j (- s)) 1 in
    Interval (over j) (over (j + 1)).

Definition root_above (q : Q) : Q :=
  let u := high (root_between 64 (reduced q)) in
  if Qle_bool 0 u && Qle_bool q (u * u) then u else (q + 1)%Q.

Definition root_below (q : Q) : Q :=
  let l := low (root_between 64 (reduced q)) in
  if Qle_bool 0 l && Qle_bool (l * l) q then l else 0%Q.

Lemma reduced_same q : (Q2R (reduced q) = Q2R q)%R.
Proof.
  destruct q as [n d]. unfold reduced; cbn [Qnum Qden].
  set (g := Z.gcd n (Zpos d)).
  assert (G : (0 < g)%Z).
  { assert (g <> 0)%Z by (unfold g; rewrite Z.gcd_eq_0; lia).
    pose proof (Z.gcd_nonneg n (Zpos d)). fold g in H0. lia. }
  assert (En : (n = g * (n / g))%Z).
  { apply Z_div_exact_full_2; [lia|]. apply Z.mod_divide; [lia|]. apply Z.gcd_divide_l. }
  assert (Ed : (Zpos d = g * (Zpos d / g))%Z).
  { apply Z_div_exact_full_2; [lia|]. apply Z.mod_divide; [lia|]. apply Z.gcd_divide_r. }
  assert (P : (0 < Zpos d / g)%Z) by (apply Z.mul_pos_cancel_l with (n := g); lia).
  unfold Q2R; cbn [Qnum Qden]. rewrite Z2Pos.id by exact P.
  rewrite En at 2. rewrite Ed at 2. rewrite !mult_IZR.
  apply IZR_lt in G, P. field. lra.
Qed.

(** So that the kernel does not compute roots. *)
#[global] Opaque root_between reduced.

Section Roots.
Open Scope R_scope.

Lemma Qle_bool_R p q : Qle_bool p q = true -> Q2R p <= Q2R q.
Proof. intros H. apply Qle_Rle. now apply Qle_bool_iff. Qed.

Lemma Q2R_half q : Q2R (q / (2#1))%Q = Q2R q / 2.
Proof. rewrite Q2R_div by discriminate. unfold Q2R at 2. cbn. field. Qed.

Lemma Q2R_1 : Q2R 1 = 1.
Proof. unfold Q2R; cbn. field. Qed.

Lemma Q2R_0 : Q2R 0 = 0.
Proof. unfold Q2R; cbn. field. Qed.

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

End Roots.
