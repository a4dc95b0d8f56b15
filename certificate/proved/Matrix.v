(* SPDX-License-Identifier: MIT *)
(* Matrices of rationals, by their rows.  Elimination finds inverses and kernels; nothing is proved about it, as
   what it finds is multiplied out: `is_inverse_times`. *)
From Coq Require Import List Arith ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Root Box RowLimits Degree.
From Proved Require Rows.
Import ListNotations.

Section Computing.
Open Scope Q_scope.

Definition vector := list Q.
Definition matrix := list vector.

Fixpoint inner (a b : vector) : Q :=
  match a, b with x :: a', y :: b' => reduced (x * y + inner a' b') | _, _ => 0 end.

(* a + s b *)
Fixpoint plus_times (a : vector) (s : Q) (b : vector) : vector :=
  match a, b with
  | x :: a', y :: b' => reduced (x + s * y) :: plus_times a' s b'
  | _, [] => a
  | [], _ => map (fun y => reduced (s * y)) b
  end.

Definition is_zero (q : Q) : bool := Qeq_bool q 0.

(* Of n numbers, 1 at i. *)
Definition unit_vector (n i : nat) : vector := map (fun j => if Nat.eqb i j then 1 else 0) (seq 0 n).

Definition identity (n : nat) : matrix := map (unit_vector n) (seq 0 n).

(* The sum of the rows, each times a number. *)
Fixpoint of_rows (a : vector) (m : matrix) : vector :=
  match a, m with x :: a', r :: m' => plus_times (of_rows a' m') x r | _, _ => [] end.

(* A row that is not 0 in this column, and the others. *)
Fixpoint pivot (column : nat) (m : matrix) : option (vector * matrix) :=
  match m with
  | [] => None
  | r :: m' =>
      if is_zero (nth column r 0) then
        match pivot column m' with Some (found, others) => Some (found, r :: others) | None => None end
      else Some (r, m')
  end.

(* From this column on; the rows that have a pivot, and its column. *)
Fixpoint eliminate (columns column : nat) (m : matrix) (done : list (nat * vector)) : list (nat * vector) :=
  match columns with
  | O => done
  | S columns' =>
      match pivot column m with
      | None => eliminate columns' (S column) m done
      | Some (r, others) =>
          let r := plus_times [] (/ nth column r 0) r in
          let without (a : vector) := plus_times a (- nth column a 0) r in
          eliminate columns' (S column) (map without others)
            (map (fun p => (fst p, without (snd p))) done ++ [(column, r)])
      end
  end.

(* Vectors on which all rows are 0. *)
Definition kernel (n : nat) (m : matrix) : matrix :=
  let done := eliminate n 0 m [] in
  flat_map (fun j =>
    if existsb (fun p => Nat.eqb (fst p) j) done then []
    else [fold_right (fun p a => plus_times a (- nth j (snd p) 0) (unit_vector n (fst p))) (unit_vector n j) done])
    (seq 0 n).

(* The inverse, if there is one: what elimination makes of 1 beside the matrix. *)
Definition inverse_of (n : nat) (m : matrix) : matrix :=
  map (fun p => skipn n (snd p)) (eliminate n 0 (map (fun p => fst p ++ snd p) (combine m (identity n))) []).

Fixpoint same_vectors (a b : vector) : bool :=
  match a, b with
  | [], [] => true
  | x :: a', y :: b' => Qeq_bool x y && same_vectors a' b'
  | _, _ => false
  end.

Fixpoint same_matrices (a b : matrix) : bool :=
  match a, b with
  | [], [] => true
  | x :: a', y :: b' => same_vectors x y && same_matrices a' b'
  | _, _ => false
  end.

(* left m = 1 *)
Definition is_inverse (n : nat) (left m : matrix) : bool :=
  same_matrices (map (fun a => of_rows a m) left) (identity n).

Definition all_of_length {A} (n : nat) (m : list (list A)) : bool := forallb (fun r => Nat.eqb (List.length r) n) m.

End Computing.

Section Proofs.
Open Scope R_scope.

(* As real numbers. *)
Definition real (a : vector) : list R := map Q2R a.

Lemma inner_is a b : Q2R (inner a b) = Rows.dot (real a) (real b).
Proof.
  revert b. induction a as [|x a IH]; intros [|y b]; cbn [inner real map Rows.dot]; try apply Q2R_0.
  rewrite reduced_same, Q2R_plus, Q2R_mult, IH. reflexivity.
Qed.

Lemma dot_plus_times a s b d : Rows.dot (real (plus_times a s b)) d = Rows.dot (real a) d + Q2R s * Rows.dot
  (real b) d.
Proof.
  assert (Sc : forall b d, Rows.dot (real (map (fun y => reduced (s * y)) b)) d = Q2R s * Rows.dot (real b) d).
  { clear. induction b as [|y b IH]; intros [|z d]; cbn [real map Rows.dot]; try ring. rewrite reduced_same,
      Q2R_mult.
    unfold real in IH. rewrite IH. ring. }
  revert b d. induction a as [|x a IH]; intros [|y b] [|z d]; cbn [plus_times real map Rows.dot]; try ring.
  - fold (real (map (fun y => reduced (s * y)) b)). rewrite reduced_same, Q2R_mult, Sc. unfold real. ring.
  - rewrite reduced_same, Q2R_plus, Q2R_mult. fold (real (plus_times a s b)). rewrite IH. unfold real. ring.
Qed.

(* A sum of multiples of rows, applied to e, is that of what the rows give. *)
Lemma dot_of_rows a m e : Rows.dot (real (of_rows a m)) e = Rows.dot (real a) (times (map real m) e).
Proof.
  revert m. induction a as [|x a IH]; intros [|r m]; try reflexivity.
  cbn [of_rows]. rewrite dot_plus_times, IH. unfold times, real. cbn. ring.
Qed.

Lemma same_vectors_real a b : same_vectors a b = true -> real a = real b.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b]; cbn; try discriminate; [reflexivity|].
  intros H. apply andb_true_iff in H as [E H]. apply Qeq_bool_eq, Qeq_eqR in E.
  specialize (IH b H). unfold real in *. now rewrite E, IH.
Qed.

Lemma same_matrices_real a b : same_matrices a b = true -> map real a = map real b.
Proof.
  revert b. induction a as [|x a IH]; intros [|y b]; cbn; try discriminate; [reflexivity|].
  intros H. apply andb_true_iff in H as [E H].
  now rewrite (same_vectors_real _ _ E), (IH b H).
Qed.

Lemma unit_vector_is n i : (i < n)%nat -> real (unit_vector n i) = basis_vector n i.
Proof.
  unfold unit_vector, real. rewrite map_map. revert i.
  assert (Z : forall n i s, (i < s)%nat -> map (fun j => Q2R (if Nat.eqb i j then 1 else 0)) (seq s n) = repeat
    0 n).
  { clear. induction n as [|n IH]; intros i s L; cbn [seq map repeat]; [reflexivity|].
    destruct (Nat.eqb_spec i s); [lia|]. now rewrite Q2R_0, IH by lia. }
  assert (G : forall i s, (i < n)%nat -> map (fun j => Q2R (if Nat.eqb (s + i) j then 1 else 0)) (seq s n) =
    basis_vector n i).
  { induction n as [|n' IH]; intros i s L; [lia|]. cbn [seq map basis_vector]. destruct i as [|i].
    - rewrite Nat.add_0_r, Nat.eqb_refl, Z by lia. f_equal. unfold Q2R; cbn; lra.
    - destruct (Nat.eqb_spec (s + S i) s); [lia|]. rewrite Q2R_0. f_equal.
      rewrite <- (IH i (S s)) by lia. now rewrite Nat.add_succ_r. }
  intros i L. apply (G i O L).
Qed.

(* What was multiplied out to be 1 undoes the matrix. *)
Theorem is_inverse_times n left m e : is_inverse n left m = true -> List.length e = n ->
  times (map real left) (times (map real m) e) = e.
Proof.
  intros H L. apply same_matrices_real in H. rewrite map_map in H.
  unfold times at 1. rewrite map_map.
  transitivity (map (fun r => Rows.dot r e) (map (fun a => real (of_rows a m)) left)).
  - rewrite map_map. apply map_ext. intros a. symmetry. apply dot_of_rows.
  - rewrite H. unfold identity. rewrite !map_map. apply (nth_ext _ _ 0 0).
    + now rewrite map_length, seq_length.
    + intros i I. rewrite map_length, seq_length in I.
      rewrite nth_indep with (d' := Rows.dot (real (unit_vector n 0)) e) by (now rewrite map_length, seq_length).
      rewrite (map_nth (fun i => Rows.dot (real (unit_vector n i)) e)), seq_nth by exact I. cbn.
      now rewrite unit_vector_is, dot_sym, dot_unit by exact I.
Qed.

Lemma all_of_length_is {A} n (m : list (list A)) : all_of_length n m = true -> Forall (fun r => List.length r =
  n) m.
Proof. intros H. apply Forall_forall. intros r Hr. unfold all_of_length in H. rewrite forallb_forall in H. now
  apply Nat.eqb_eq, H. Qed.

End Proofs.
