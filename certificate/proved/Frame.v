(* SPDX-License-Identifier: MIT *)
(* Proofs by degree (FORMAT.md section 6): the rules degree-walls, degree-direction and degree-bound, which are about
   the rows of E and A alone, and d' and d''.  `walls_bound`: with the free motions that it finds, K is bounded.
   `direction_inverse`: A has an inverse, once z z^T is added for each free motion.  `K_within`: K is within the bound
   of motions. *)
From Coq Require Import List Arith ZArith QArith Qreals Qminmax Reals Lra Lia Bool.
From Proved Require Import Question Root Box Brouwer RowLimits Degree Matrix Between.
From Proved Require Rows.
Import ListNotations.

Section Rules.
Open Scope Q_scope.

Definition opposite (a : vector) : vector := map Qopp a.

(* F_1, F_2, ... *)
Definition walls_of (simplex : bool) (e : matrix) : matrix :=
  if simplex then e else flat_map (fun a => [a; opposite a]) e.

Definition transpose (columns : nat) (m : matrix) : matrix :=
  map (fun j => map (fun a => nth j a 0) m) (seq 0 columns).

Definition all_positive (c : vector) : bool := forallb (fun q => negb (Qle_bool q 0)) c.

Definition zeros (n : nat) : vector := repeat 0 n.

(* Numbers above 0, one for each row, with which the sum of the rows is 0. *)
Definition balances (n : nat) (e : matrix) (c : vector) : bool :=
  all_positive c && Nat.eqb (List.length c) (List.length e) && same_vectors (of_rows c e) (zeros n).

(* Whether such numbers are found; up to a factor there is only one choice. *)
Definition is_simplex (n : nat) (e : matrix) : bool :=
  match kernel (List.length e) (transpose n e) with
  | [c] => balances n e c || balances n e (opposite c)
  | _ => false
  end.

(* D rows that are independent, if degree-walls holds. *)
Definition frame (simplex : bool) (e free : matrix) : matrix := (if simplex then removelast e else e) ++ free.

(* The free motions, or None if degree-walls does not hold. *)
Definition free_motions (n : nat) (simplex : bool) (e : matrix) : option matrix :=
  let free := kernel n e in
  let all := frame simplex e free in
  if all_of_length n e && all_of_length n free && is_inverse n (inverse_of n all) all &&
     (negb simplex || is_simplex n e)
  then Some free else None.

(* m + z z^T *)
Definition plus_square (z : vector) (m : matrix) : matrix := map (fun p => plus_times (snd p) (fst p) z)
  (combine z m).

(* A with all z z^T added, and the inverse; or None if degree-direction does not hold. *)
Definition inverted (n : nat) (free a : matrix) : option (matrix * matrix) :=
  let m := fold_right plus_square a free in
  let inverse := inverse_of n m in
  if all_of_length n a && Nat.eqb (List.length a) n &&
     forallb (fun z => forallb (fun r => is_zero (inner r z)) a && same_vectors (of_rows z a) (zeros n)) free &&
     is_inverse n inverse m && is_inverse n m inverse
  then Some (m, inverse) else None.

(* Numbers of walls, all of 0 or more, with which these are a sum that rows of E are with y; as small as can be. *)
Definition wall_numbers (n : nat) (simplex : bool) (e : matrix) (y : vector) : vector :=
  if simplex then
    let c := match kernel (List.length e) (transpose n e) with
             | [c] => if all_positive c then c else opposite c
             | _ => []
             end in
    let them := combine (y ++ [0]) c in
    let least := fold_right (fun p m => Qmin (fst p / snd p) m) 0 them in
    map (fun p => reduced (fst p - least * snd p)) them
  else flat_map (fun q => if Qle_bool 0 q then [q; 0] else [0; - q]) y.

(* The most that target.e is on K where no z.e is other than 0; y says what the target is a sum of. *)
Definition most_in_K (n : nat) (simplex : bool) (e free : matrix) (target y : vector) : option Q :=
  let rank := if simplex then pred (List.length e) else List.length e in
  let m := wall_numbers n simplex e (firstn rank y) in
  let walls := walls_of simplex e in
  if forallb (Qle_bool 0) m && Nat.eqb (List.length m) (List.length walls) &&
     same_vectors (of_rows (m ++ skipn rank y) (walls ++ free)) target
  then Some (fold_right (fun q s => reduced (q + s)) 0 m) else None.

(* Whether d + e is within the bound for these d, and all these e. *)
Definition K_within (n : nat) (simplex : bool) (e free : matrix) (most : vector) (ds : matrix) : bool :=
  let inverse := inverse_of n (frame simplex e free) in
  forallb (fun j =>
    let unit := unit_vector n j in
    let y := nth j inverse [] in
    let b := nth j most 0 in
    match most_in_K n simplex e free unit y, most_in_K n simplex e free (opposite unit) (opposite y) with
    | Some up, Some down => forallb (fun d => Qle_bool (nth j d 0 + up) b && Qle_bool (down - nth j d 0) b) ds
    | _, _ => false
    end) (seq 0 n).

End Rules.

Section Proofs.
Open Scope R_scope.

Lemma zeros_real n : real (zeros n) = repeat 0 n.
Proof. unfold zeros, real. induction n as [|n IH]; cbn [repeat map]; [reflexivity|]. now rewrite IH, Q2R_0. Qed.

Lemma dot_opposite a d : Rows.dot (real (opposite a)) d = - Rows.dot (real a) d.
Proof.
  revert d. induction a as [|x a IH]; intros [|y d]; cbn; try ring. unfold real, opposite in IH. rewrite IH,
    Q2R_opp. ring.
Qed.

Lemma Forall2_weaker {A B} (P Q : A -> B -> Prop) l l' : Forall2 P l l' -> (forall a b, P a b -> Q a b) ->
  Forall2 Q l l'.
Proof. intros F H. induction F; constructor; auto. Qed.

(* What is at most 1 everywhere, and sums up to 0 with numbers above 0, is bounded. *)
Lemma balanced_bound n e c : balances n e c = true -> exists C, forall d,
  Forall (fun a => Rows.dot (real a) d <= 1) e -> Forall (fun a => Rabs (Rows.dot (real a) d) <= C) e.
Proof.
  intros H. unfold balances in H. rewrite !andb_true_iff in H. destruct H as [[P L] S].
  apply Nat.eqb_eq in L. apply same_vectors_real in S. rewrite zeros_real in S.
  assert (Z : forall d, Rows.dot (real c) (map (fun a => Rows.dot (real a) d) e) = 0).
  { intros d. pose proof (dot_of_rows c e d) as E. unfold times in E. rewrite map_map in E. rewrite <- E, S.
    rewrite dot_sym. apply dot_zeros. }
  clear S. assert (Pos : Forall (fun q => 0 < Q2R q) c).
  { apply Forall_forall. intros q Hq. unfold all_positive in P. rewrite forallb_forall in P. specialize (P q Hq).
    apply negb_true_iff in P. apply Rnot_le_lt. intros Le. rewrite <- Q2R_0 in Le.
    apply Rle_Qle, Qle_bool_iff in Le. congruence. }
  clear P.
  (* The sum of the others is at least minus the sum of c. *)
  assert (Sum : exists T, forall d, Forall (fun a => Rows.dot (real a) d <= 1) e ->
    Rows.dot (real c) (map (fun a => Rows.dot (real a) d) e) <= T /\ 0 <= T /\
    Forall2 (fun q a => Rows.dot (real c) (map (fun a => Rows.dot (real a) d) e) <= T + Q2R q * Rows.dot (real
      a) d) c e).
  { clear Z n. revert e L. induction Pos as [|q c Pq Pos IH]; intros [|a e] L; try discriminate.
    - exists 0. intros d _. cbn. repeat split; try lra. constructor.
    - destruct (IH e) as (T & HT); [now injection L|]. exists (T + Q2R q). intros d F. inversion F as [|? ? Fa
        Fe]; subst.
      destruct (HT d Fe) as (A & B & C). cbn [real map Rows.dot]. fold (real c).
      set (s := Rows.dot (real c) (map (fun a => Rows.dot (real a) d) e)) in *.
      assert (Q2R q * Rows.dot (real a) d <= Q2R q) by nra. unfold real in *. repeat split; try lra.
      constructor; [lra|]. apply (Forall2_weaker _ _ _ _ C). cbn. intros; lra. }
  destruct Sum as (T & HT).
  assert (I : exists C, forall d, Forall2 (fun q a => 0 <= T + Q2R q * Rows.dot (real a) d) c e ->
    Forall (fun a => - C <= Rows.dot (real a) d) e).
  { clear HT Z. revert e L. induction Pos as [|q c Pq Pos IH]; intros [|a e] L; try discriminate.
    - exists 0. intros; constructor.
    - destruct (IH e) as (C & HC); [now injection L|]. exists (Rmax C (T / Q2R q)). intros d F.
      inversion F as [|? ? ? ? F1 F2]; subst. constructor.
      + pose proof (Rmax_r C (T / Q2R q)). apply Rle_trans with (- (T / Q2R q)); [lra|].
        apply Rmult_le_reg_l with (Q2R q); [exact Pq|]. field_simplify; lra.
      + eapply Forall_impl; [|exact (HC d F2)]. cbn. intros b Hb. pose proof (Rmax_l C (T / Q2R q)). lra. }
  destruct I as (C & HC). exists (Rmax C 1). intros d F. destruct (HT d F) as (_ & _ & G). rewrite (Z d) in G.
  specialize (HC d G). rewrite Forall_forall in *. intros a Ha. specialize (F a Ha). specialize (HC a Ha). cbn in *.
  pose proof (Rmax_l C 1). pose proof (Rmax_r C 1). apply Rabs_le. lra.
Qed.

(* Where all rows of a matrix are bounded on d, so is d. *)
Lemma inverse_bound n left m C d : is_inverse n left m = true -> List.length d = n ->
  Forall (fun a => Rabs (Rows.dot (real a) d) <= C) m -> 0 <= C ->
  Forall2 (fun a x => Rabs x <= C * fold_right (fun q s => Rabs (Q2R q) + s) 0 a) left d.
Proof.
  intros I L F P.
  assert (G : forall a, Rabs (Rows.dot (real a) (times (map real m) d)) <= C * fold_right (fun q s => Rabs (Q2R
    q) + s) 0 a).
  { unfold times. rewrite map_map. clear I. revert F. induction m as [|r m IH]; intros F a.
    - cbn. rewrite dot_nil, Rabs_R0. apply Rmult_le_pos; [exact P|]. clear. induction a; cbn; [lra|].
      pose proof (Rabs_pos (Q2R a)). lra.
    - destruct a as [|q a]; [cbn; rewrite Rabs_R0; lra|]. inversion F; subst. cbn [real map Rows.dot fold_right].
      specialize (IH H2 a). eapply Rle_trans; [apply Rabs_triang|]. rewrite Rabs_mult.
      pose proof (Rabs_pos (Q2R q)). unfold real in *. nra. }
  pose proof (is_inverse_times n left m d I L) as E. unfold times at 1 in E. rewrite map_map in E.
  assert (A : Forall2 (fun a x => Rabs x <= C * fold_right (fun q s => Rabs (Q2R q) + s) 0 a) left
    (map (fun a => Rows.dot (real a) (times (map real m) d)) left)).
  { clear E L I. induction left as [|a left IH]; cbn; constructor; [apply G|exact IH]. }
  now rewrite E in A.
Qed.

(* K is bounded, where free motions are. *)
Theorem walls_bound n simplex e free : free_motions n simplex e = Some free ->
  exists B : vec, forall d, List.length d = n ->
    Forall (fun a => Rows.dot (real a) d <= 1) (walls_of simplex e) ->
    Forall (fun z => -1 <= Rows.dot (real z) d <= 1) free ->
    forall i, (i < n)%nat -> - B i <= nth i d 0 <= B i.
Proof.
  unfold free_motions. set (all := frame _ _ _). destruct (_ && _) eqn:H; [|discriminate]. intros E. injection E as <-.
  rewrite !andb_true_iff in H. destruct H as [[[_ _] I] S].
  assert (W : exists C, forall d, Forall (fun a => Rows.dot (real a) d <= 1) (walls_of simplex e) ->
    Forall (fun a => Rabs (Rows.dot (real a) d) <= C) e).
  { destruct simplex; cbn in S.
    - unfold is_simplex in S. destruct (kernel (List.length e) (transpose n e)) as [|c [|? ?]]; try discriminate.
      apply orb_true_iff in S as [S|S]; exact (balanced_bound _ _ _ S).
    - exists 1. intros d F. unfold walls_of in F. rewrite Forall_flat_map in F. eapply Forall_impl; [|exact F].
      cbn. intros a Ha. inversion Ha as [|? ? A1 A2]; subst. inversion A2; subst. rewrite dot_opposite in *.
      apply Rabs_le. lra. }
  destruct W as (C & HC).
  exists (fun i => Rmax C 1 * fold_right (fun q s => Rabs (Q2R q) + s) 0 (nth i (inverse_of n all) [])).
  intros d L F Z i Hi. specialize (HC d F).
  assert (All : Forall (fun a => Rabs (Rows.dot (real a) d) <= Rmax C 1) all).
  { pose proof (Rmax_l C 1). pose proof (Rmax_r C 1). unfold all, frame. apply Forall_app. split.
    - assert (G : Forall (fun a => Rabs (Rows.dot (real a) d) <= Rmax C 1) e)
        by (eapply Forall_impl; [|exact HC]; cbn; intros; lra).
      destruct simplex; [|exact G]. rewrite Forall_forall in *. intros a Ha. apply G.
      clear - Ha. induction e as [|x e IH]; [destruct Ha|]. cbn in Ha. destruct e; [destruct Ha|].
      destruct Ha as [<-|Ha]; [now left|right; auto].
    - eapply Forall_impl; [|exact Z]. cbn. intros z Hz. apply Rabs_le. lra. }
  pose proof (inverse_bound n _ all (Rmax C 1) d I L All) as G.
  assert (P : 0 <= Rmax C 1) by (pose proof (Rmax_r C 1); lra). specialize (G P).
  assert (N : forall i, (i < List.length d)%nat ->
    Rabs (nth i d 0) <= Rmax C 1 * fold_right (fun q s => Rabs (Q2R q) + s) 0 (nth i (inverse_of n all) [])).
  { clear - G. induction G as [|a x l d Hx G IH]; intros [|i] I; cbn in *; try lia; [exact Hx|apply IH; lia]. }
  specialize (N i ltac:(lia)). cbv beta. set (v := _ * _) in *. unfold Rabs in N. destruct (Rcase_abs (nth i d
    0)); lra.
Qed.

(* All rows have n numbers. *)
Lemma free_lengths n simplex e free : free_motions n simplex e = Some free ->
  Forall (fun z => List.length z = n) free /\ Forall (fun a => List.length a = n) e.
Proof.
  unfold free_motions. destruct (_ && _) eqn:H; [|discriminate]. intros E. injection E as <-.
  rewrite !andb_true_iff in H. destruct H as [[[He Hz] _] _]. split; now apply all_of_length_is.
Qed.

Lemma plus_square_length z m : List.length z = List.length m -> List.length (plus_square z m) = List.length m.
Proof. intros L. unfold plus_square. rewrite map_length, combine_length. lia. Qed.

Lemma plus_square_is z m y e : List.length z = List.length m ->
  Rows.dot y (times (map real (plus_square z m)) e) =
  Rows.dot y (times (map real m) e) + Rows.dot (real z) y * Rows.dot (real z) e.
Proof.
  intros L. unfold plus_square, times. rewrite !map_map.
  assert (G : forall w m y, List.length w = List.length m ->
    Rows.dot y (map (fun x => Rows.dot (real (plus_times (snd x) (fst x) z)) e) (combine w m)) =
    Rows.dot y (map (fun r => Rows.dot (real r) e) m) + Rows.dot (real w) y * Rows.dot (real z) e).
  { clear. induction w as [|q w IH]; intros [|r m] [|t y] L; try discriminate; cbn [combine map Rows.dot real
      fst snd]; try ring.
    rewrite dot_plus_times. unfold real in *. rewrite IH by now injection L. ring. }
  now apply G.
Qed.

(* What degree-direction says of A. *)
Theorem direction_inverse n free a m inverse : inverted n free a = Some (m, inverse) ->
  Forall (fun z => List.length z = n) free ->
  List.length a = n /\ Forall (fun r => List.length r = n) a /\ List.length m = n /\
  (forall y e, Rows.dot y (times (map real m) e) = Rows.dot y (times (map real a) e) + spread (map real free) y
    e) /\
  (forall e, List.length e = n -> times (map real inverse) (times (map real m) e) = e) /\
  (forall e, List.length e = n -> times (map real m) (times (map real inverse) e) = e) /\
  (forall z e, In z free -> Rows.dot (real z) (times (map real a) e) = 0).
Proof.
  unfold inverted. set (m' := fold_right plus_square a free). destruct (_ && _) eqn:H; [|discriminate].
  intros E F. injection E as <- <-. rewrite !andb_true_iff in H. destruct H as [[[[Ha La] Z] I1] I2].
  apply Nat.eqb_eq in La.
  assert (G : List.length m' = n /\ forall y e, Rows.dot y (times (map real m') e) =
    Rows.dot y (times (map real a) e) + spread (map real free) y e).
  { unfold m'. clear - F La. induction F as [|z free Lz F [L IH]]; cbn [fold_right map].
    - split; [exact La|]. intros y e. unfold spread. cbn. ring.
    - split; [rewrite plus_square_length; congruence|]. intros y e. rewrite plus_square_is by congruence.
      rewrite IH. unfold spread. cbn. ring. }
  destruct G as [Lm G]. repeat split; try assumption.
  - now apply all_of_length_is.
  - intros e L. now apply (is_inverse_times n).
  - intros e L. now apply (is_inverse_times n).
  - intros z e Hz. rewrite forallb_forall in Z. specialize (Z z Hz). apply andb_true_iff in Z as [_ Z].
    apply same_vectors_real in Z. rewrite zeros_real in Z. rewrite <- dot_of_rows, Z, dot_sym. apply dot_zeros.
Qed.

Lemma most_in_K_is n simplex e free target y b d : most_in_K n simplex e free target y = Some b ->
  Forall (fun f => Rows.dot (real f) d <= 1) (walls_of simplex e) -> Forall (fun z => Rows.dot (real z) d = 0) free ->
  Rows.dot (real target) d <= Q2R b.
Proof.
  unfold most_in_K. set (rank := if simplex then _ else _). set (m := wall_numbers _ _ _ _). set (walls := walls_of _ _).
  destruct (_ && _) eqn:H; [|discriminate]. rewrite !andb_true_iff in H. destruct H as [[P L] S]. intros E F Z. injection E as <-.
  apply Nat.eqb_eq in L. apply same_vectors_real in S. rewrite <- S, dot_of_rows.
  clearbody m walls. generalize (skipn rank y). clear S rank y target. intros w.
  revert walls L F. induction m as [|q m IH]; intros [|f walls] L F; try discriminate; cbn [app map times real Rows.dot fold_right].
  - rewrite Q2R_0. right. revert w. clear F. induction Z as [|z free Hz Z IH]; intros [|q w]; cbn; try reflexivity.
    rewrite Hz. unfold times, real in *. rewrite IH. ring.
  - cbn [forallb] in P. apply andb_true_iff in P as [Pq P]. apply Qle_bool_R in Pq. rewrite Q2R_0 in Pq.
    rewrite reduced_same, Q2R_plus. inversion F as [|? ? F1 F2]; subst. specialize (IH P walls ltac:(now injection L) F2).
    unfold times, real in *. rewrite map_app, map_map in *. assert (Q2R q * Rows.dot (map Q2R f) d <= Q2R q) by nra. lra.
Qed.

Lemma Forall2_listed (P : Q -> R -> Prop) n most (f : vec) : List.length most = n ->
  (forall j, (j < n)%nat -> P (nth j most 0%Q) (f j)) -> Forall2 P most (listed n f).
Proof.
  revert n f. induction most as [|b most IH]; intros [|n] f L H; try discriminate; cbn; constructor.
  - exact (H O ltac:(lia)).
  - apply IH; [now injection L|]. intros j J. exact (H (S j) ltac:(lia)).
Qed.

Lemma nth_mixed t a b j : List.length a = List.length b -> nth j (mixed t a b) 0 = mix t (nth j a 0) (nth j b 0).
Proof.
  revert b j. induction a as [|x a IH]; intros [|y b] j L; try discriminate.
  - unfold mix. destruct j; cbn; ring.
  - destruct j as [|j]; cbn; [reflexivity|]. apply IH. now injection L.
Qed.

Lemma nth_real j d : nth j (real d) 0 = Q2R (nth j d 0%Q).
Proof. rewrite <- Q2R_0 at 1. unfold real. apply map_nth. Qed.

(* What degree-bound says. *)
Theorem K_within_is n simplex e free most d1 d2 t (x : vec) : K_within n simplex e free most [d1; d2] = true ->
  List.length most = n -> List.length d1 = List.length d2 -> 0 <= t <= 1 ->
  Forall (fun f => Rows.dot (real f) (listed n x) <= 1) (walls_of simplex e) ->
  Forall (fun z => Rows.dot (real z) (listed n x) = 0) free ->
  Forall2 (fun b x => Rabs x <= Q2R b) most (listed n (fun i => nth i (mixed t (real d1) (real d2)) 0 + x i)).
Proof.
  intros H Lm Ld T F Z. apply Forall2_listed; [exact Lm|]. intros j J. unfold K_within in H. rewrite forallb_forall in H.
  specialize (H j ltac:(apply in_seq; lia)). cbv zeta in H. set (y := nth j (inverse_of n (frame simplex e free)) []) in *.
  destruct (most_in_K n simplex e free (unit_vector n j) y) as [up|] eqn:U; [|discriminate].
  destruct (most_in_K n simplex e free (opposite (unit_vector n j)) (opposite y)) as [down|] eqn:Dn; [|discriminate].
  apply (most_in_K_is _ _ _ _ _ _ _ _ U F) in Z as Up. apply (most_in_K_is _ _ _ _ _ _ _ _ Dn F) in Z as Down.
  rewrite dot_opposite in Down. rewrite (unit_vector_is n j J), dot_sym, dot_unit, nth_listed in Up, Down by exact J.
  cbn [forallb] in H. rewrite !andb_true_iff in H. destruct H as [[A1 A2] [[B1 B2] _]]. apply Qle_bool_R in A1, A2, B1, B2.
  rewrite Q2R_plus in A1, B1. rewrite Q2R_minus in A2, B2.
  rewrite nth_mixed by (unfold real; rewrite !map_length; exact Ld). rewrite !nth_real. unfold mix.
  set (p := Q2R (nth j d1 0%Q)) in *. set (q := Q2R (nth j d2 0%Q)) in *. apply Rabs_le.
  assert (0 <= (1 - t) * (Q2R (nth j most 0%Q) - (p + Q2R up))) by (apply Rmult_le_pos; lra).
  assert (0 <= t * (Q2R (nth j most 0%Q) - (q + Q2R up))) by (apply Rmult_le_pos; lra).
  assert (0 <= (1 - t) * (Q2R (nth j most 0%Q) - (Q2R down - p))) by (apply Rmult_le_pos; lra).
  assert (0 <= t * (Q2R (nth j most 0%Q) - (Q2R down - q))) by (apply Rmult_le_pos; lra). lra.
Qed.

End Proofs.
