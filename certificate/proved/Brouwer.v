(* SPDX-License-Identifier: MIT *)
(* Continuous functions on a box in R^n have zeros (the theorem of Poincare and Miranda), and continuous
   maps of a box into itself have fixed points (Brouwer).  The proof counts paths through the cells of
   a grid along which one function after another changes its sign: their number is odd, so there is one.
   Cells become smaller, and a limit is a zero. *)
From Coq Require Import List Bool Arith Lia Reals Lra FunctionalExtensionality.
Import ListNotations.

(* ---- Parity ---- *)

(* Whether the number of elements with f is odd. *)
Fixpoint parity {A : Type} (f : A -> bool) (l : list A) : bool :=
  match l with [] => false | a :: l' => xorb (f a) (parity f l') end.

Lemma parity_same {A} (f g : A -> bool) l : (forall a, In a l -> f a = g a) ->
  parity f l = parity g l.
Proof.
  induction l as [|a l IH]; intros H; cbn; [reflexivity|].
  rewrite (H a) by now left. rewrite IH; [reflexivity|]. intros; apply H; now right.
Qed.

Lemma parity_none {A} (f : A -> bool) l : (forall a, In a l -> f a = false) -> parity f l = false.
Proof.
  intros H. rewrite (parity_same f (fun _ => false)) by exact H.
  clear H. induction l as [|a l IH]; cbn; [reflexivity|]. now rewrite IH.
Qed.

Lemma parity_map {A B} (g : A -> B) f l : parity f (map g l) = parity (fun a => f (g a)) l.
Proof. induction l as [|a l IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Lemma parity_sum {A} (f g : A -> bool) l :
  parity (fun a => xorb (f a) (g a)) l = xorb (parity f l) (parity g l).
Proof.
  induction l as [|a l IH]; cbn; [reflexivity|]. rewrite IH.
  now destruct (f a), (g a), (parity f l), (parity g l).
Qed.

Lemma parity_and {A} b (f : A -> bool) l : parity (fun a => b && f a) l = b && parity f l.
Proof.
  induction l as [|a l IH]; cbn; [now rewrite andb_false_r|]. rewrite IH. now destruct b.
Qed.

Lemma parity_swap {A B} (f : A -> B -> bool) l m :
  parity (fun a => parity (f a) m) l = parity (fun b => parity (fun a => f a b) l) m.
Proof.
  induction l as [|a l IH]; cbn; [now rewrite parity_none|]. now rewrite IH, parity_sum.
Qed.

(* What is odd is not 0. *)
Lemma parity_found {A} (f : A -> bool) l : parity f l = true -> {a | In a l & f a = true}.
Proof.
  induction l as [|a l IH]; cbn; [discriminate|]. destruct (f a) eqn:F.
  - intros _. exists a; auto.
  - rewrite xorb_false_l. intros H. destruct IH as [b]; [exact H|]. exists b; auto.
Qed.

Lemma parity_telescope (h : nat -> bool) k :
  parity (fun i => xorb (h i) (h (S i))) (seq 0 k) = xorb (h 0) (h k).
Proof.
  assert (G : forall m, parity (fun i => xorb (h i) (h (S i))) (seq m k) = xorb (h m) (h (m + k))).
  { induction k as [|k IH]; intros m; cbn.
    - rewrite Nat.add_0_r. now destruct (h m).
    - rewrite IH, Nat.add_succ_r. cbn. now destruct (h m), (h (S m)), (h (S (m + k))). }
  apply G.
Qed.

(* ---- Points of a grid, and steps ---- *)

Definition point := nat -> nat.

Definition put (j i : nat) (x : point) : point := fun l => if l =? j then i else x l.

Definition up (j : nat) (x : point) : point := put j (S (x j)) x.

Ltac by_coordinates :=
  intros; unfold up, put; try (apply functional_extensionality; intros ?);
  repeat match goal with |- context [?a =? ?b] => destruct (Nat.eqb_spec a b); subst end;
  try congruence; try lia.

Lemma put_same j i x : put j i x j = i.
Proof. by_coordinates. Qed.

Lemma put_other j i x l : l <> j -> put j i x l = x l.
Proof. by_coordinates. Qed.

Lemma up_other j x l : l <> j -> up j x l = x l.
Proof. by_coordinates. Qed.

Lemma put_put j l a b x : j <> l -> put j a (put l b x) = put l b (put j a x).
Proof. by_coordinates. Qed.

Lemma up_up j l x : up j (up l x) = up l (up j x).
Proof. by_coordinates. Qed.

Lemma up_put j i x : up j (put j i x) = put j (S i) x.
Proof. by_coordinates. Qed.

(* Each element, with the others. *)
Fixpoint picks (l : list nat) : list (nat * list nat) :=
  match l with
  | [] => []
  | a :: l' => (a, l') :: map (fun p => (fst p, a :: snd p)) (picks l')
  end.

Lemma picks_in p l : In p (picks l) -> In (fst p) l /\ incl (snd p) l.
Proof.
  revert p. induction l as [|a l IH]; intros p; cbn; [intros []|]. intros [<-|H].
  - cbn. split; [now left|]. intros x; now right.
  - apply in_map_iff in H as (q & <- & H). apply IH in H as [H1 H2]. cbn. split; [now right|].
    intros x [<-|Hx]; [now left|right; auto].
Qed.

Lemma picks_not_in p l : NoDup l -> In p (picks l) -> ~ In (fst p) (snd p).
Proof.
  intros D. revert p. induction D as [|a l Ha D IH]; intros p; cbn; [intros []|]. intros [<-|H].
  - exact Ha.
  - apply in_map_iff in H as (q & <- & H). cbn. intros [E|E].
    + apply picks_in in H as [H _]. congruence.
    + now apply IH in H.
Qed.

(* Of two steps in either order, an even number. *)
Lemma two_picks_cancel (g : nat -> nat -> list nat -> bool) l :
  (forall i j r, g i j r = g j i r) ->
  parity (fun p => parity (fun q => g (fst p) (fst q) (snd q)) (picks (snd p))) (picks l) = false.
Proof.
  revert g. induction l as [|a l IH]; intros g S; [reflexivity|].
  cbn [picks parity fst snd]. rewrite parity_map. cbn [picks parity fst snd].
  rewrite parity_sum.
  rewrite (parity_same (fun p => parity _ (map _ (picks (snd p))))
             (fun p => parity (fun q => g (fst p) (fst q) (a :: snd q)) (picks (snd p))))
    by (intros; apply parity_map).
  rewrite (IH (fun i j r => g i j (a :: r))) by auto.
  rewrite (parity_same (fun p => g (fst p) a (snd p)) (fun p => g a (fst p) (snd p))) by auto.
  now rewrite xorb_false_r, xorb_nilpotent.
Qed.

(* ---- Cubes ---- *)

(* A function of the cubes that begin at a point and have the sides of a list. *)
Definition cochain := list nat -> point -> bool.

(* The sum of its values on the faces of a cube. *)
Definition coboundary (c : cochain) : cochain := fun ds x =>
  parity (fun p => xorb (c (snd p) x) (c (snd p) (up (fst p) x))) (picks ds).

(* Paths that go up once along each side; those are counted along which at each step the next
   function of the list changes. *)
Fixpoint changes (bs : list (point -> bool)) : cochain := fun ds x =>
  match bs with
  | [] => true
  | b :: bs' =>
      parity (fun p => xorb (b x) (b (up (fst p) x)) && changes bs' (snd p) (up (fst p) x)) (picks ds)
  end.

Lemma coboundary_twice c ds x : coboundary (coboundary c) ds x = false.
Proof.
  unfold coboundary.
  rewrite (parity_same _ (fun p => parity (fun q =>
      xorb (xorb (c (snd q) x) (c (snd q) (up (fst q) x)))
           (xorb (c (snd q) (up (fst p) x)) (c (snd q) (up (fst q) (up (fst p) x)))))
      (picks (snd p)))) by (intros; now rewrite <- parity_sum).
  apply (two_picks_cancel (fun j l r =>
      xorb (xorb (c r x) (c r (up l x))) (xorb (c r (up j x)) (c r (up l (up j x)))))).
  intros i j r. rewrite (up_up j i).
  now destruct (c r x), (c r (up i x)), (c r (up j x)), (c r (up i (up j x))).
Qed.

(* The rule of a product. *)
Lemma changes_step b bs ds x :
  changes (b :: bs) ds x =
  xorb (coboundary (fun ds x => b x && changes bs ds x) ds x) (b x && coboundary (changes bs) ds x).
Proof.
  cbn [changes]. unfold coboundary. rewrite <- parity_and, <- parity_sum. apply parity_same. intros p _.
  now destruct (b x), (b (up (fst p) x)), (changes bs (snd p) x), (changes bs (snd p) (up (fst p) x)).
Qed.

Lemma changes_closed bs ds x : coboundary (changes bs) ds x = false.
Proof.
  revert ds x. induction bs as [|b bs IH]; intros ds x; [now apply parity_none|].
  unfold coboundary. erewrite parity_same;
    [exact (coboundary_twice (fun ds x => b x && changes bs ds x) ds x)|].
  intros p _. now rewrite !changes_step, !IH, !andb_false_r, !xorb_false_r.
Qed.

(* ---- The grid of all cubes between 0 and k ---- *)

Section Grid.
Variable k : nat.

(* The sum over all points with 0, ..., k - 1 at the places of the list. *)
Fixpoint total (ds : list nat) (f : point -> bool) (x : point) : bool :=
  match ds with
  | [] => f x
  | j :: ds' => parity (fun i => total ds' f (put j i x)) (seq 0 k)
  end.

Lemma total_same ds f g x : (forall y, (forall l, ~ In l ds -> y l = x l) -> f y = g y) ->
  total ds f x = total ds g x.
Proof.
  revert x. induction ds as [|j ds IH]; intros x H; cbn; [now apply H|].
  apply parity_same. intros i _. apply IH. intros y Hy. apply H. intros l Hl. cbn in Hl.
  rewrite Hy by tauto. apply put_other. intros ->. tauto.
Qed.

Lemma total_parity {A} ds (f : A -> point -> bool) l x :
  total ds (fun y => parity (fun a => f a y) l) x = parity (fun a => total ds (f a) x) l.
Proof.
  revert x. induction ds as [|j ds IH]; intros x; cbn; [reflexivity|].
  rewrite parity_swap. apply parity_same. intros i _. apply IH.
Qed.

Lemma total_sum ds f g x :
  total ds (fun y => xorb (f y) (g y)) x = xorb (total ds f x) (total ds g x).
Proof.
  revert x. induction ds as [|j ds IH]; intros x; cbn; [reflexivity|].
  rewrite <- parity_sum. apply parity_same. intros i _. apply IH.
Qed.

Lemma total_none ds f x : (forall y, (forall l, ~ In l ds -> y l = x l) -> f y = false) ->
  total ds f x = false.
Proof.
  intros H. rewrite (total_same ds f (fun _ => false)) by exact H. clear H. revert x.
  induction ds as [|j ds IH]; intros x; cbn; [reflexivity|]. apply parity_none. auto.
Qed.

(* Any place may be summed last. *)
Lemma total_pick ds f x p : NoDup ds -> In p (picks ds) ->
  total ds f x = parity (fun i => total (snd p) f (put (fst p) i x)) (seq 0 k).
Proof.
  intros D. revert x p. induction D as [|a ds Ha D IH]; intros x p; cbn; [intros []|].
  intros [<-|H]; [reflexivity|]. apply in_map_iff in H as (q & <- & H). cbn.
  rewrite parity_swap. apply parity_same. intros i _. rewrite (IH _ q H).
  apply parity_same. intros i' _. apply f_equal. apply put_put. apply picks_in in H as [H _].
  congruence.
Qed.

Lemma total_up ds f x j i : ~ In j ds ->
  total ds (fun y => f (up j y)) (put j i x) = total ds f (put j (S i) x).
Proof.
  revert x. induction ds as [|l ds IH]; intros x H; cbn in *; [now rewrite up_put|].
  apply parity_same. intros i' _. rewrite !(put_put l j) by tauto. apply IH. tauto.
Qed.

(* Stokes: the faces between two cubes cancel. *)
Lemma stokes ds c x : NoDup ds ->
  total ds (coboundary c ds) x =
  parity (fun p => xorb (total (snd p) (c (snd p)) (put (fst p) 0 x))
                        (total (snd p) (c (snd p)) (put (fst p) k x))) (picks ds).
Proof.
  intros D. unfold coboundary.
  rewrite (total_parity ds (fun p y => xorb (c (snd p) y) (c (snd p) (up (fst p) y)))).
  apply parity_same. intros p H.
  rewrite (total_pick ds _ x p D H).
  rewrite <- (parity_telescope (fun i => total (snd p) (c (snd p)) (put (fst p) i x))).
  apply parity_same. intros i _. rewrite total_sum. f_equal. apply total_up. now apply picks_not_in with ds.
Qed.

(* Where a function does not change along any side, no path is counted. *)
Lemma changes_constant b bs ds x l : In b bs -> ~ In l ds ->
  (forall y, y l = x l -> b y = b x) -> changes bs ds x = false.
Proof.
  revert ds x. induction bs as [|b' bs IH]; intros ds x; cbn; [intros []|]. intros H L C.
  apply parity_none. intros p P. apply picks_in in P as [P1 P2].
  assert (U : up (fst p) x l = x l) by (apply up_other; intros ->; auto).
  destruct H as [->|H].
  - rewrite (C (up (fst p) x)) by exact U. now rewrite xorb_nilpotent.
  - rewrite (IH _ _ H), andb_false_r; [reflexivity| |].
    + intros I. apply L. now apply P2.
    + intros y Hy. transitivity (b x); [apply C; congruence|symmetry; now apply C].
Qed.

Lemma odd_number_of_paths (b : nat -> point -> bool) ds x : NoDup ds ->
  (forall j y, In j ds -> y j = 0 -> b j y = false) ->
  (forall j y, In j ds -> y j = k -> b j y = true) ->
  total ds (changes (map b ds) ds) x = true.
Proof.
  intros D. revert x. induction D as [|j ds Hj D IH]; intros x Low High; [reflexivity|].
  cbn [map]. rewrite (total_same _ _
    (coboundary (fun ds' y => b j y && changes (map b ds) ds' y) (j :: ds)))
    by (intros; now rewrite changes_step, changes_closed, andb_false_r, xorb_false_r).
  rewrite stokes by now constructor. cbn [picks parity fst snd]. rewrite parity_map.
  rewrite (total_none ds _ (put j 0 x)).
  2: { intros y Hy. rewrite Low; [reflexivity|now left|]. rewrite Hy by exact Hj. apply put_same. }
  rewrite (total_same ds _ (changes (map b ds) ds) (put j k x)).
  2: { intros y Hy. rewrite High; [reflexivity|now left|]. rewrite Hy by exact Hj. apply put_same. }
  rewrite IH by (intros; (apply Low || apply High); cbn; auto).
  rewrite parity_none; [reflexivity|]. intros p P. cbn [fst snd].
  destruct (picks_in _ _ P) as [I _]. pose proof (picks_not_in _ _ D P) as N.
  assert (NJ : ~ In (fst p) (j :: snd p)) by (intros [E|E]; [congruence|contradiction]).
  assert (Z : forall i, (i = 0 \/ i = k) ->
    total (j :: snd p) (fun y => b j y && changes (map b ds) (j :: snd p) y) (put (fst p) i x) = false).
  { intros i Hi. apply total_none. intros y Hy. specialize (Hy _ NJ). rewrite put_same in Hy.
    rewrite (changes_constant (b (fst p)) _ _ _ (fst p)); [apply andb_false_r| |exact NJ|].
    - now apply in_map.
    - intros z Hz. rewrite Hy in Hz. destruct Hi as [-> | ->].
      + now rewrite !Low by (auto; now right).
      + now rewrite !High by (auto; now right). }
  rewrite !Z by auto. reflexivity.
Qed.

Lemma total_found ds f x : total ds f x = true -> {y | (forall l, In l ds -> y l < k) & f y = true}.
Proof.
  intros H. assert (G : {y | (forall l, In l ds -> y l < k) /\ (forall l, ~ In l ds -> y l = x l)
                             & f y = true}).
  { revert x H. induction ds as [|j ds IH]; intros x H; cbn in H.
    - exists x; [|exact H]. split; [intros l []|reflexivity].
    - apply parity_found in H as [i Hi H]. apply in_seq in Hi.
      destruct (IH _ H) as [y [L E] F]. exists y; [|exact F]. split.
      + intros l [->|Hl]; [|auto]. destruct (in_dec Nat.eq_dec l ds) as [I|I]; [auto|].
        rewrite (E l I), put_same. lia.
      + intros l Hl. cbn in Hl. rewrite E by tauto. apply put_other. intros ->. tauto. }
  destruct G as [y [L _] F]. now exists y.
Qed.

End Grid.

(* The cube that begins at x. *)
Definition corner_of (x y : point) := forall l, y l = x l \/ y l = S (x l).

Lemma picks_distinct p l : NoDup l -> In p (picks l) -> NoDup (snd p).
Proof.
  intros D. revert p. induction D as [|a l Ha D IH]; intros p; cbn; [intros []|]. intros [<-|H].
  - exact D.
  - apply in_map_iff in H as (q & <- & H). cbn. constructor; [|now apply IH].
    intros I. apply Ha. now apply (picks_in q l).
Qed.

(* If paths from x are counted, each of the functions differs at two corners of the cube. *)
Lemma changes_found x bs i ds y : NoDup ds -> corner_of x y -> (forall l, In l ds -> y l = x l) ->
  changes bs ds y = true -> i < length bs ->
  {st | corner_of x (fst st) /\ corner_of x (snd st) &
        nth i bs (fun _ => true) (fst st) <> nth i bs (fun _ => true) (snd st)}.
Proof.
  revert ds y i. induction bs as [|b bs IH]; intros ds y i D C E H L; cbn in L; [lia|].
  cbn in H. apply parity_found in H as [p P H]. apply andb_true_iff in H as [H1 H2].
  destruct (picks_in _ _ P) as [P1 P2]. pose proof (picks_not_in _ _ D P) as N.
  assert (U : corner_of x (up (fst p) y)).
  { intros l. unfold up, put. destruct (Nat.eqb_spec l (fst p)); [subst; rewrite E; auto|apply C]. }
  destruct i as [|i].
  - exists (y, up (fst p) y); [auto|]. cbn. intros X. rewrite X, xorb_nilpotent in H1. discriminate.
  - cbn [nth]. apply (IH (snd p) (up (fst p) y)); [|exact U| |exact H2|lia].
    + eapply picks_distinct; eassumption.
    + intros l Hl. rewrite up_other by congruence. apply E. auto.
Qed.

(* A cube, and for each function of grid points two of its corners. *)
Record cube := Cube { start : point; ones : nat -> point; others : nat -> point }.

(* The j-th function is false where coordinate j is 0, and true where it is k: in some cube each of
   them takes both values. *)
Theorem cube_found n k (b : nat -> point -> bool) :
  (forall j y, j < n -> y j = 0 -> b j y = false) ->
  (forall j y, j < n -> y j = k -> b j y = true) ->
  {c | (forall l, l < n -> start c l < k) &
       forall j, j < n ->
         (corner_of (start c) (ones c j) /\ b j (ones c j) = false) /\
         (corner_of (start c) (others c j) /\ b j (others c j) = true)}.
Proof.
  intros Low High. set (ds := seq 0 n).
  assert (D : NoDup ds) by apply seq_NoDup.
  destruct (total_found k ds (changes (map b ds) ds) (fun _ => 0)) as [x L H].
  { apply odd_number_of_paths; [exact D| |]; intros j y J; apply in_seq in J; [apply Low|apply High]; lia. }
  assert (Pairs : forall j, {st | j < n ->
    (corner_of x (fst st) /\ b j (fst st) = false) /\ (corner_of x (snd st) /\ b j (snd st) = true)}).
  { intros j. destruct (lt_dec j n) as [J|J]; [|now exists (x, x)].
    destruct (changes_found x (map b ds) j ds x D) as [[y z] [Y Z] N]; try exact H; try reflexivity.
    - intros l. now left.
    - unfold ds. now rewrite map_length, seq_length.
    - assert (E : forall y, nth j (map b ds) (fun _ => true) y = b j y).
      { intros y'. rewrite nth_indep with (d' := b 0) by (unfold ds; now rewrite map_length, seq_length).
        rewrite map_nth. unfold ds. now rewrite seq_nth. }
      rewrite !E in N. cbn in Y, Z, N. destruct (b j y) eqn:By, (b j z) eqn:Bz; try congruence.
      + now exists (z, y).
      + now exists (y, z). }
  exists (Cube x (fun j => fst (proj1_sig (Pairs j))) (fun j => snd (proj1_sig (Pairs j)))); cbn.
  - intros l Hl. apply L, in_seq. lia.
  - intros j J. now apply (proj2_sig (Pairs j)).
Qed.

(* ---- Sequences ---- *)

Open Scope R_scope.

(* Of which the first n numbers count. *)
Definition vec := nat -> R.

Definition converges (n : nat) (u : nat -> vec) (x : vec) :=
  forall i, (i < n)%nat -> Un_cv (fun k => u k i) (x i).

Definition continuous (n : nat) (f : vec -> R) :=
  forall u x, converges n u x -> Un_cv (fun k => f (u k)) (f x).

(* A subsequence, perhaps with repetitions. *)
Definition onward (phi : nat -> nat) := forall k, (k <= phi k)%nat.

Definition nth_part (k : nat) : R := / (INR k + 1).

Lemma nth_part_positive k : 0 < nth_part k.
Proof. apply Rinv_0_lt_compat. pose proof (pos_INR k). lra. Qed.

Lemma nth_part_small eps : 0 < eps -> exists N, forall k, (N <= k)%nat -> nth_part k < eps.
Proof.
  intros E. destruct (archimed_cor1 eps E) as (N & H & P). exists N. intros k K.
  apply Rle_lt_trans with (/ INR N); [|exact H]. apply Rinv_le_contravar.
  - now apply lt_0_INR.
  - apply le_INR in K. lra.
Qed.

Lemma cv_nth_part : Un_cv nth_part 0.
Proof.
  intros eps E. destruct (nth_part_small eps E) as (N & H). exists N. intros k K.
  unfold R_dist. rewrite Rminus_0_r, Rabs_right; [auto|]. pose proof (nth_part_positive k). lra.
Qed.

Lemma cv_constant c : Un_cv (fun _ => c) c.
Proof. intros eps E. exists 0%nat. intros k _. rewrite R_dist_eq. exact E. Qed.

Lemma cv_onward phi u x : onward phi -> Un_cv u x -> Un_cv (fun k => u (phi k)) x.
Proof.
  intros O H eps E. destruct (H eps E) as (N & HN). exists N. intros k K. apply HN.
  specialize (O k). lia.
Qed.

(* What is close to a sequence has its limit. *)
Lemma cv_close u v x c : Un_cv u x -> (forall k, Rabs (v k - u k) <= c * nth_part k) -> Un_cv v x.
Proof.
  intros U V.
  assert (Z : Un_cv (fun k => v k - u k) 0).
  { intros eps E. destruct (nth_part_small (eps / (Rabs c + 1))) as (N & HN).
    { apply Rdiv_lt_0_compat; [exact E|]. pose proof (Rabs_pos c). lra. }
    exists N. intros k K. specialize (HN k K). pose proof (V k). pose proof (Rabs_pos c).
    pose proof (Rle_abs c). pose proof (nth_part_positive k). unfold R_dist. rewrite Rminus_0_r.
    apply Rle_lt_trans with ((Rabs c + 1) * nth_part k); [nra|].
    apply Rmult_lt_reg_r with (/ (Rabs c + 1)); [apply Rinv_0_lt_compat; lra|].
    replace ((Rabs c + 1) * nth_part k * / (Rabs c + 1)) with (nth_part k) by (field; lra). exact HN. }
  assert (S := CV_plus _ _ _ _ U Z). rewrite Rplus_0_r in S.
  intros eps E. destruct (S eps E) as (N & HN). exists N. intros k K. specialize (HN k K).
  now replace (v k) with (u k + (v k - u k)) by ring.
Qed.

Lemma cv_at_most u x c : (forall k, u k <= c) -> Un_cv u x -> x <= c.
Proof. intros H U. eapply Rle_cv_lim; [exact H|exact U|apply cv_constant]. Qed.

Lemma cv_at_least u x c : (forall k, c <= u k) -> Un_cv u x -> c <= x.
Proof. intros H U. eapply Rle_cv_lim; [exact H|apply cv_constant|exact U]. Qed.

(* Bolzano and Weierstrass, for numbers: the limit is the largest that infinitely many reach. *)
Lemma cluster_number u B : (forall k, - B <= u k <= B) ->
  {phi & onward phi & {x | Un_cv (fun k => u (phi k)) x}}.
Proof.
  intros Bd. set (reached := fun x => forall N, exists n, (N <= n)%nat /\ x <= u n).
  destruct (completeness reached) as [x [Up Least]].
  - exists B. intros x H. destruct (H 0%nat) as (m & _ & L). specialize (Bd m). lra.
  - exists (- B). intros N. exists N. split; [lia|apply Bd].
  - assert (Near : forall k eps, 0 < eps -> {n | (k <= n)%nat /\ Rabs (u n - x) < eps}).
    { intros k eps E. set (far := fun n => (n < k)%nat \/ eps <= Rabs (u n - x)).
      destruct (ClassicalDedekindReals.sig_forall_dec far) as [[n Hn]|All].
      - intros n. unfold far. destruct (le_lt_dec k n) as [K|K]; [|left; auto].
        destruct (Rle_lt_dec eps (Rabs (u n - x))); [left; auto|right; intros [|]; [lia|lra]].
      - exists n. unfold far in Hn. split.
        + destruct (le_lt_dec k n); tauto.
        + destruct (Rle_lt_dec eps (Rabs (u n - x))); tauto.
      - exfalso. assert (A : ~ is_upper_bound reached (x - eps)).
        { intros H. apply Least in H. lra. }
        apply A. intros y Y. apply Rnot_lt_le. intros L.
        assert (R : reached (x + eps)).
        { intros N. destruct (Y (max N k)) as (n & Hn & Hy). exists n. split; [lia|].
          destruct (All n) as [|F]; [lia|]. unfold Rabs in F. destruct (Rcase_abs (u n - x)); lra. }
        apply Up in R. lra. }
    set (phi := fun k => Near k (nth_part k) (nth_part_positive k)).
    exists (fun k => proj1_sig (phi k)); [intros k; apply (proj2_sig (phi k))|].
    exists x. apply (cv_close (fun _ => x) _ _ 1); [apply cv_constant|]. intros k.
    pose proof (proj2_sig (phi k)) as [_ H]. lra.
Qed.

Theorem cluster_point n (u : nat -> vec) (B : vec) :
  (forall k i, (i < n)%nat -> - B i <= u k i <= B i) ->
  {phi & onward phi & {x | converges n (fun k => u (phi k)) x}}.
Proof.
  induction n as [|n IH]; intros Bd.
  - exists (fun k => k); [intros k; auto|]. exists (fun _ => 0). intros i I. lia.
  - destruct IH as [phi P [x X]]; [intros; apply Bd; lia|].
    destruct (cluster_number (fun k => u (phi k) n) (B n)) as [psi Q [t T]]; [intros; apply Bd; lia|].
    exists (fun k => phi (psi k)); [intros k; specialize (P (psi k)); specialize (Q k); lia|].
    exists (fun i => if Nat.eqb i n then t else x i). intros i I. destruct (Nat.eqb_spec i n) as [->|E].
    + exact T.
    + apply (cv_onward psi (fun k => u (phi k) i)); [exact Q|]. apply X. lia.
Qed.

(* ---- Zeros ---- *)

Definition in_box (n : nat) (B e : vec) := forall i, (i < n)%nat -> - B i <= e i <= B i.

(* Poincare and Miranda. *)
Theorem zero_in_box n (B : vec) (F : vec -> vec) :
  (forall i, (i < n)%nat -> 0 <= B i) ->
  (forall j, (j < n)%nat -> continuous n (fun e => F e j)) ->
  (forall e j, (j < n)%nat -> in_box n B e -> e j = - B j -> 0 <= F e j) ->
  (forall e j, (j < n)%nat -> in_box n B e -> e j = B j -> F e j <= 0) ->
  {e | in_box n B e & forall j, (j < n)%nat -> F e j = 0}.
Proof.
  intros B0 Cont Low High.
  set (place := fun k (x : point) (l : nat) => - B l + 2 * B l * INR (x l) * nth_part k).
  set (b := fun k j (x : point) =>
    if Nat.eqb (x j) 0 then false else if Nat.eqb (x j) (S k) then true
    else if Rlt_dec (F (place k x) j) 0 then true else false).
  assert (Full : forall k, INR (S k) * nth_part k = 1).
  { intros k. unfold nth_part. rewrite S_INR. field. pose proof (pos_INR k). lra. }
  assert (Inside : forall k x, (forall l, (l < n)%nat -> (x l <= S k)%nat) -> in_box n B (place k x)).
  { intros k x H l Hl. specialize (H l Hl). apply le_INR in H. specialize (B0 l Hl).
    pose proof (pos_INR (x l)). pose proof (nth_part_positive k). specialize (Full k). unfold place.
    assert (0 <= INR (x l) * nth_part k <= 1) by nra. nra. }
  assert (Cells : forall k, {c | (forall l, (l < n)%nat -> (start c l < S k)%nat) &
     forall j, (j < n)%nat ->
       (corner_of (start c) (ones c j) /\ 0 <= F (place k (ones c j)) j) /\
       (corner_of (start c) (others c j) /\ F (place k (others c j)) j <= 0)}).
  { intros k. destruct (cube_found n (S k) (b k)) as [c X H].
    - intros j y _ E. unfold b. now rewrite E.
    - intros j y _ E. unfold b. rewrite E. cbn. now rewrite Nat.eqb_refl.
    - exists c; [exact X|]. intros j J. destruct (H j J) as [[Y By] [Z Bz]].
      assert (In_grid : forall y, corner_of (start c) y -> in_box n B (place k y)).
      { intros y' Y'. apply Inside. intros l Hl. specialize (X l Hl). destruct (Y' l); lia. }
      set (y := ones c j) in *. set (z := others c j) in *. unfold b in By, Bz. repeat split; try assumption.
      + destruct (Nat.eqb_spec (y j) 0) as [E|_].
        { apply Low; auto. unfold place. rewrite E. cbn. ring. }
        destruct (Nat.eqb (y j) (S k)); [discriminate|].
        destruct (Rlt_dec (F (place k y) j) 0); [discriminate|lra].
      + destruct (Nat.eqb (z j) 0); [discriminate|].
        destruct (Nat.eqb_spec (z j) (S k)) as [E|_].
        { apply High; auto. unfold place. rewrite E, Rmult_assoc, Full. ring. }
        destruct (Rlt_dec (F (place k z) j) 0); [lra|discriminate]. }
  set (cell := fun k => proj1_sig (sig_of_sig2 (Cells k))).
  assert (In_cell : forall k, in_box n B (place k (start (cell k)))).
  { intros k. apply Inside. intros l Hl. apply Nat.lt_le_incl. unfold cell. now destruct (Cells k) as [c X];
      apply X. }
  assert (Signs : forall k j, (j < n)%nat ->
     (corner_of (start (cell k)) (ones (cell k) j) /\ 0 <= F (place k (ones (cell k) j)) j) /\
     (corner_of (start (cell k)) (others (cell k) j) /\ F (place k (others (cell k) j)) j <= 0)).
  { intros k. unfold cell. now destruct (Cells k). }
  destruct (cluster_point n (fun k => place k (start (cell k))) B) as [phi P [x X]].
  { intros k i I. now apply In_cell. }
  exists x.
  - intros i I. specialize (X i I). split.
    + eapply cv_at_least; [|exact X]. intros k. now apply In_cell.
    + eapply cv_at_most; [|exact X]. intros k. now apply In_cell.
  - intros j J.
    (* Corners of cells are as close as the cells are small. *)
    assert (Corners : forall y : nat -> point, (forall k, corner_of (start (cell k)) (y k)) ->
      Un_cv (fun k => F (place (phi k) (y (phi k))) j) (F x j)).
    { intros y Y. apply (Cont j J (fun k => place (phi k) (y (phi k)))). intros i I.
      apply (cv_close (fun k => place (phi k) (start (cell (phi k))) i) _ _ (2 * B i)); [now apply X|].
      intros k. specialize (Y (phi k) i). specialize (B0 i I). unfold place.
      pose proof (nth_part_positive (phi k)). pose proof (nth_part_positive k).
      assert (nth_part (phi k) <= nth_part k).
      { apply Rinv_le_contravar; [pose proof (pos_INR k); lra|]. pose proof (le_INR _ _ (P k)). lra. }
      destruct Y as [-> | ->].
      - replace (_ - _) with 0 by ring. rewrite Rabs_R0. nra.
      - rewrite S_INR. replace (_ - _) with (2 * B i * nth_part (phi k)) by ring.
        rewrite Rabs_right by nra. nra. }
    apply Rle_antisym.
    + eapply cv_at_most; [|apply (Corners (fun k => others (cell k) j))]; intros k; apply Signs, J.
    + eapply cv_at_least; [|apply (Corners (fun k => ones (cell k) j))]; intros k; apply Signs, J.
Qed.

(* Brouwer. *)
Theorem fixed_point n (B : vec) (f : vec -> vec) :
  (forall i, (i < n)%nat -> 0 <= B i) ->
  (forall j, (j < n)%nat -> continuous n (fun e => f e j)) ->
  (forall e, in_box n B e -> in_box n B (f e)) ->
  {e | in_box n B e & forall j, (j < n)%nat -> f e j = e j}.
Proof.
  intros B0 Cont Into. destruct (zero_in_box n B (fun e j => f e j - e j)) as [e H Z]; try assumption.
  - intros j J u x U. apply CV_minus; [now apply Cont|now apply U].
  - intros e j J H E. pose proof (Into e H j J). lra.
  - intros e j J H E. pose proof (Into e H j J). lra.
  - exists e; [exact H|]. intros j J. specialize (Z j J). cbn in Z. lra.
Qed.
