(* SPDX-License-Identifier: MIT *)
(* Stable at rest (FORMAT.md section 6): friction forces at the motion 0, and how they answer to what is left of
   the load.  `stable_at_rest`: where the rules hold, every system in the box is stable at every multiple. *)
From Coq Require Import List Arith String ZArith QArith Qreals Qminmax Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Tree.
From Proved Require Import Brouwer Homotopy RowLimits Degree Matrix Frame Between ByDegree.
From Proved Require Rows Model.
Import ListNotations.

Record rest_proof := RestProof {
  rest_forces : list (Z * vector);           (* f0 *)
  rest_answers : list (Z * matrix);          (* G_i1, ..., G_iD *)
  rest_reach : vector                        (* Z *)
}.

(* A contact at rest: its box, f0, and G by its columns. *)
Record resting := Resting { resting_box : cbox; force_at_rest : vector; answers : matrix }.

Section Rules.
Open Scope Q_scope.

(* ---- rest-share ---- *)

Definition good_force (b : cbox) (f : vector) : bool :=
  has_friction b && Nat.eqb (List.length f) (List.length (box_weights b)) &&
  (box_signed b || is_zero (inner f (box_normal b))).

(* The first of a list, if it is about this contact, and the others. *)
Definition taken {A} (none : A) (i : Z) (them : list (Z * A)) : A * list (Z * A) :=
  match them with
  | (j, a) :: others => if Z.eqb j i then (a, others) else (none, them)
  | [] => (none, [])
  end.

Fixpoint resting_contacts (n : nat) (rows : list row) (i : Z) (forces : list (Z * vector))
    (all_answers : list (Z * matrix)) (before : list resting) : option (list resting) :=
  match rows with
  | [] => match forces, all_answers with [], [] => Some (rev_append before []) | _, _ => None end
  | row :: rows' =>
      let b := box row in
      let (f, forces') := taken [] i forces in
      let (g, answers') := taken [] i all_answers in
      let fine (f : vector) := match f with [] => true | _ => good_force b f end in
      if fine f && (match g with [] => true | _ => Nat.eqb (List.length g) n && forallb (good_force b) g end)
      then resting_contacts n rows' (i + 1) forces' answers' (Resting b f g :: before)
      else None
  end.

(* ---- Intervals ---- *)

Definition range_of (qs : vector) : interval :=
  match qs with
  | [] => exactly 0
  | q :: qs' => fold_left (fun i q => Interval (Qmin (low i) q) (Qmax (high i) q)) qs' (exactly q)
  end.

Definition plus_interval (a b : interval) : interval := Interval (Qred (low a + low b)) (Qred (high a + high b)).
Definition times_interval (c : Q) (a : interval) : interval := Interval (Qred (c * low a)) (Qred (c * high a)).   (* c >= 0 *)
Definition shifted (a : interval) (c : Q) : interval := Interval (Qred (low a + c)) (Qred (high a + c)).

Fixpoint plus_intervals (a b : list interval) : list interval :=
  match a, b with x :: a', y :: b' => plus_interval x y :: plus_intervals a' b' | _, _ => [] end.

(* The largest absolute value. *)
Definition most_of (a : interval) : Q := Qmax (high a) (- low a).

(* What some sums of multiples of N and the slip's forms can be, by components. *)
Definition ranges (n : nat) (b : cbox) (sums : list vector) : list interval :=
  let vs := flat_map (fun c => map (of_rows c) (tips (geometry_tree b))) sums in
  map (fun k => range_of (map (fun v => nth k v 0) vs)) (seq 0 n).

(* ---- rest-reach and rest-cone ---- *)

(* The ends of P' at the multiple. *)
Definition pressures (b : cbox) (lambda : Q) : list Q :=
  [low (box_preload b) + lambda * low (box_growth b); high (box_preload b) + lambda * high (box_growth b)].

Definition loads_at (s : setting) (lambda : Q) : list interval :=
  map (fun p => shifted (fst p) (lambda * snd p)) (List.combine (load_box (the_load s)) (load_growth (the_load s))).

(* W *)
Definition left_over (n : nat) (s : setting) (them : list resting) (lambda : Q) : list interval :=
  fold_left (fun sum r => plus_intervals sum
               (ranges n (resting_box r) (map (fun p => p :: force_at_rest r) (pressures (resting_box r) lambda))))
    them (loads_at s lambda).

(* The column l of M, without those contacts that do not answer. *)
Definition column (n : nat) (them : list resting) (l : nat) : list interval :=
  fold_left (fun sum r => match answers r with
                          | [] => sum
                          | g => plus_intervals sum (ranges n (resting_box r) [0 :: nth l g []])
                          end) them (repeat (exactly 0) n).

Definition reach_holds (n : nat) (left : list interval) (columns : list (list interval)) (reach : vector) : bool :=
  Nat.eqb (List.length reach) n &&
  forallb (fun k =>
    let z := nth k reach 0 in
    Qle_bool 0 z &&
    Qle_bool
      (fold_left (fun sum l =>
         let d := nth k (nth l columns []) (exactly 0) in
         Qred (sum + most_of (shifted d (if Nat.eqb k l then -(1) else 0)) * nth l reach 0))
         (seq 0 n) (most_of (nth k left (exactly 0)))) z)
    (seq 0 n).

(* |f|^2, where f = g*. *)
Fixpoint square_of (weights f : vector) : Q :=
  match weights, f with w :: ws, x :: f' => Qred (x * x / w + square_of ws f') | _, _ => 0 end.

Definition length_bound (b : cbox) (f : vector) : Q := root_above (square_of (box_weights b) f).

Definition least_pressure (b : cbox) (lambda : Q) : Q :=
  match pressures b lambda with [p; q] => Qmin p q | _ => 0 end.

Fixpoint answers_bound (b : cbox) (g : matrix) (reach : vector) : Q :=
  match g, reach with
  | f :: g', z :: reach' => Qred (length_bound b f * z + answers_bound b g' reach')
  | _, _ => 0
  end.

Definition cone_holds (reach : vector) (lambda : Q) (r : resting) : bool :=
  let b := resting_box r in
  match force_at_rest r, answers r with
  | [], [] => true
  | f, g =>
      Qle_bool (length_bound b f + answers_bound b g reach)
        (low (box_friction b) * root_below (box_square b) * least_pressure b lambda)
  end.

(* What a question guarantees: weights are above 0, friction is nowhere below 0, and 0 of springs; of all
   others, preloads are not below 0. *)
Definition resting_sound (lambda : Q) (r : resting) : bool :=
  let b := resting_box r in
  friction_sound b && forallb (fun w => negb (Qle_bool w 0)) (box_weights b) && Qle_bool 0 (box_square b) &&
  (box_spring b || Qle_bool 0 (least_pressure b lambda)).

(* From alpha to beta. *)
Definition rest_fails (s : setting) (alpha beta : Q) (p : rest_proof) : option string :=
  let n := dimension_of s in
  match resting_contacts n (rows s) 0 (rest_forces p) (rest_answers p) [] with
  | None => Some "rest-share"%string
  | Some them =>
      let columns := map (column n them) (seq 0 n) in
      let holds lambda :=
        if negb (reach_holds n (left_over n s them lambda) columns (rest_reach p)) then Some "rest-reach"%string
        else if negb (forallb (cone_holds (rest_reach p) lambda) them && forallb (resting_sound lambda) them)
        then Some "rest-cone"%string
        else None in
      match holds alpha with
      | Some rule => Some rule
      | None => if Qeq_bool alpha beta then None else holds beta
      end
  end.

End Rules.

(* ---- Proofs: intervals ---- *)

Section Intervals.
Open Scope R_scope.

Lemma min_R a b : Q2R (Qmin a b) <= Q2R a /\ Q2R (Qmin a b) <= Q2R b.
Proof. split; apply Qle_Rle; [apply Q.le_min_l|apply Q.le_min_r]. Qed.

Lemma max_R a b : Q2R a <= Q2R (Qmax a b) /\ Q2R b <= Q2R (Qmax a b).
Proof. split; apply Qle_Rle; [apply Q.le_max_l|apply Q.le_max_r]. Qed.

Lemma range_of_within qs q : In q qs -> within (range_of qs) (Q2R q).
Proof.
  assert (G : forall qs i x, within i x ->
    within (fold_left (fun i q => Interval (Qmin (low i) q) (Qmax (high i) q)) qs i) x).
  { clear. induction qs as [|p qs IH]; intros i x W; [exact W|]. cbn. apply IH. unfold within in *; cbn.
    destruct (min_R (low i) p), (max_R (high i) p). lra. }
  assert (E : forall qs i q, In q qs ->
    within (fold_left (fun i q => Interval (Qmin (low i) q) (Qmax (high i) q)) qs i) (Q2R q)).
  { clear qs q. induction qs as [|p qs IH]; intros i q; [intros []|]. intros [->|H]; cbn; [|now apply IH].
    apply G. unfold within; cbn. destruct (min_R (low i) q), (max_R (high i) q). lra. }
  destruct qs as [|p qs]; [intros []|]. intros [->|H]; cbn; [|now apply E]. apply G. unfold within; cbn. lra.
Qed.

Lemma plus_interval_within a b x y : within a x -> within b y -> within (plus_interval a b) (x + y).
Proof. unfold within, plus_interval; cbn [low high]. rewrite !Qred_R, !Q2R_plus. lra. Qed.

Lemma shifted_within a c x : within a x -> within (shifted a c) (x + Q2R c).
Proof. unfold within, shifted; cbn [low high]. rewrite !Qred_R, !Q2R_plus. lra. Qed.

Lemma most_of_bound a x : within a x -> Rabs x <= Q2R (most_of a).
Proof.
  unfold within, most_of. destruct (max_R (high a) (- low a)) as [M1 M2]. rewrite Q2R_opp in M2.
  intros [L H]. apply Rabs_le. lra.
Qed.

(* The first n numbers are in these intervals. *)
Definition all_within (n : nat) (is : list interval) (x : nat -> R) :=
  List.length is = n /\ forall k, (k < n)%nat -> within (nth k is (exactly 0)) (x k).

Lemma plus_intervals_within n a b x y : all_within n a x -> all_within n b y ->
  all_within n (plus_intervals a b) (fun k => x k + y k).
Proof.
  intros [La Wa] [Lb Wb]. revert n b x y La Lb Wa Wb. induction a as [|i a IH]; intros n [|j b] x y La Lb Wa Wb; cbn in *;
    try lia.
  - split; [exact La|]. intros k K. lia.
  - destruct n as [|n]; [discriminate|].
    destruct (IH n b (fun k => x (S k)) (fun k => y (S k))) as [L W]; try lia.
    + intros k K. apply (Wa (S k)). lia.
    + intros k K. apply (Wb (S k)). lia.
    + split; [cbn; lia|]. intros [|k] K; cbn.
      * apply plus_interval_within; [apply (Wa O)|apply (Wb O)]; lia.
      * apply W. lia.
Qed.

Lemma all_within_same n is x y : (forall k, (k < n)%nat -> x k = y k) -> all_within n is x -> all_within n is y.
Proof. intros E [L W]. split; [exact L|]. intros k K. rewrite <- (E k K). auto. Qed.

(* A mean of two sums of multiples of a row's forms. *)
Lemma ranges_within n b r sums c1 c2 t : inside b r -> proper n r -> In c1 sums -> In c2 sums -> 0 <= t <= 1 ->
  all_within n (ranges n b sums) (fun k =>
    mix t (Rows.dot (real c1) (times (Rows.N r :: Rows.slips r) (basis_vector n k)))
          (Rows.dot (real c2) (times (Rows.N r :: Rows.slips r) (basis_vector n k)))).
Proof.
  intros (p & F & mu & t' & I) Pr H1 H2 T. split; [unfold ranges; now rewrite map_length, seq_length|].
  intros k K. unfold ranges. rewrite nth_indep with (d' := range_of (map (fun v => nth 0 v 0%Q)
    (flat_map (fun c => map (of_rows c) (tips (geometry_tree b))) sums))) by (now rewrite map_length, seq_length).
  rewrite (map_nth (fun k => range_of (map (fun v => nth k v 0%Q) _))), seq_nth by exact K. cbn [Nat.add].
  assert (One : forall c, In c sums -> within (range_of (map (fun v => nth k v 0%Q)
      (flat_map (fun c => map (of_rows c) (tips (geometry_tree b))) sums)))
      (Rows.dot (real c) (times (Rows.N r :: Rows.slips r) (basis_vector n k)))).
  { intros c Hc.
    assert (E : Rows.dot (real c) (times (Rows.N r :: Rows.slips r) (basis_vector n k)) =
      eval (fun fs => Rows.dot (real (of_rows c fs)) (basis_vector n k)) (geometry_tree b) (shares_in b p)).
    { assert (Skip : forall (m : list (list R)) j x cs d,
        Rows.dot (x :: cs) (times (skipn j m) d) = x * Rows.dot (nth j m []) d + Rows.dot cs (times (skipn (S j) m) d)).
      { clear. intros m. induction m as [|a m IH]; intros [|j] x cs d; cbn [skipn times map Rows.dot nth].
        - rewrite dot_nil. ring.
        - rewrite dot_nil. ring.
        - reflexivity.
        - apply IH. }
      assert (G : forall c j, Rows.dot (real c) (times (skipn j (Rows.N r :: Rows.slips r)) (basis_vector n k)) =
        eval (fun fs => Rows.dot (real c) (times (skipn j (map real fs)) (basis_vector n k))) (geometry_tree b) (shares_in b p)).
      { clear c Hc. induction c as [|q c IH]; intros j.
        - symmetry. exact (eval_constant 0 _ _).
        - change (real (q :: c)) with (Q2R q :: real c). rewrite Skip, IH.
          transitivity (eval (fun fs => Q2R q * qdot (nth j fs []) (basis_vector n k) +
            Rows.dot (real c) (times (skipn (S j) (map real fs)) (basis_vector n k))) (geometry_tree b) (shares_in b p)).
          + now rewrite eval_sum, eval_multiple, <- (rational_corners b r p F mu t' I).
          + apply eval_same. intros fs _. rewrite Skip, qdot_is. f_equal. f_equal. f_equal. symmetry.
            exact (map_nth real fs [] j). }
      specialize (G c O). cbn [skipn] in G. rewrite G. apply eval_same. intros fs _. now rewrite dot_of_rows. }
    rewrite E.
    assert (Tip : forall fs, In fs (tips (geometry_tree b)) ->
      within (range_of (map (fun v => nth k v 0%Q) (flat_map (fun c => map (of_rows c) (tips (geometry_tree b))) sums)))
        (Rows.dot (real (of_rows c fs)) (basis_vector n k))).
    { intros fs Hfs. rewrite dot_unit by exact K.
      replace (nth k (real (of_rows c fs)) 0) with (Q2R (nth k (of_rows c fs) 0%Q)).
      - apply range_of_within. apply (in_map (fun v => nth k v 0%Q)). apply in_flat_map. exists c. split; [exact Hc|].
        now apply in_map.
      - rewrite <- Q2R_0. symmetry. unfold real. apply map_nth. }
    split.
    - apply eval_least; [apply (shares_valid b r p F mu t' I)|]. intros fs Hfs. now apply Tip.
    - apply eval_most; [apply (shares_valid b r p F mu t' I)|]. intros fs Hfs. now apply Tip. }
  now apply mix_within; auto.
Qed.

End Intervals.

(* ---- Proofs: forces ---- *)

Section Forces.
Open Scope R_scope.

(* The g with g* = f. *)
Fixpoint star (ws f : list R) : list R :=
  match ws, f with w :: ws', x :: f' => x / w :: star ws' f' | _, _ => [] end.

Lemma product_star ws f s : Rows.positive ws -> (List.length f <= List.length ws)%nat ->
  Rows.product ws (star ws f) s = Rows.dot f s.
Proof.
  intros P. revert f s. induction P as [|w ws Pw P IH]; intros [|x f] [|y s] L; cbn in *; try lia; try reflexivity.
  rewrite IH by lia. field. lra.
Qed.

(* f0 and multiples of the answers. *)
Fixpoint answered (ws : list R) (f : vector) (g : matrix) (z : list R) : list R :=
  match g, z with
  | a :: g', x :: z' => Rows.plus (Rows.scaled x (star ws (real a))) (answered ws f g' z')
  | _, _ => star ws (real f)
  end.

Lemma product_answered ws f g z s : Rows.positive ws -> (List.length f <= List.length ws)%nat ->
  Forall (fun a => List.length a <= List.length ws)%nat g ->
  Rows.product ws (answered ws f g z) s =
  Rows.dot (real f) s + Rows.dot z (map (fun a => Rows.dot (real a) s) g).
Proof.
  intros P Lf Lg. revert z. induction Lg as [|a g La Lg IH]; intros [|x z]; cbn [answered map Rows.dot];
    try (rewrite product_star by (try exact P; unfold real; now rewrite map_length); try rewrite dot_nil; ring).
  rewrite Rows.product_plus, Rows.product_scaled, IH, product_star by (try exact P; unfold real; now rewrite map_length).
  ring.
Qed.

Lemma size_scaled_any ws c s : Rows.positive ws -> Rows.size ws (Rows.scaled c s) = Rabs c * Rows.size ws s.
Proof.
  intros P. unfold Rows.size. rewrite Rows.product_scaled, Rows.product_sym, Rows.product_scaled, <- Rmult_assoc.
  rewrite sqrt_mult_alt by apply Rle_0_sqr. f_equal. apply sqrt_Rsqr_abs.
Qed.

Lemma positive_weights ws : forallb (fun w => negb (Qle_bool w 0)) ws = true -> Forall (fun w => 0 < Q2R w) ws.
Proof.
  intros H. rewrite forallb_forall in H. apply Forall_forall. intros w Hw. specialize (H w Hw).
  apply negb_true_iff in H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence.
Qed.

Lemma square_of_is ws f : Forall (fun w => 0 < Q2R w) ws ->
  Rows.product (real ws) (star (real ws) (real f)) (star (real ws) (real f)) = Q2R (square_of ws f).
Proof.
  intros P. revert f. induction P as [|w ws Pw P IH]; intros [|x f]; cbn [square_of real map star Rows.product];
    try (now rewrite Q2R_0).
  rewrite Qred_R, Q2R_plus, Q2R_div, Q2R_mult. 2: { intros E. apply Qeq_eqR in E. rewrite Q2R_0 in E. lra. }
  unfold real in *. rewrite IH. field. lra.
Qed.

Lemma size_star b f : Forall (fun w => 0 < Q2R w) (box_weights b) ->
  Rows.size (real (box_weights b)) (star (real (box_weights b)) (real f)) <= Q2R (length_bound b f).
Proof.
  intros P. unfold length_bound, Rows.size. rewrite square_of_is by exact P. apply root_above_is.
  rewrite <- square_of_is by exact P. apply Rows.product_nonneg. unfold Rows.positive, real. now rewrite Forall_map.
Qed.

Lemma size_answered b f g z reach : Forall (fun w => 0 < Q2R w) (box_weights b) ->
  (List.length g <= List.length reach)%nat -> Forall2 (fun x m => Rabs x <= Q2R m) z reach ->
  Rows.size (real (box_weights b)) (answered (real (box_weights b)) f g z) <=
  Q2R (length_bound b f) + Q2R (answers_bound b g reach).
Proof.
  intros P L F. set (ws := real (box_weights b)).
  assert (Pw : Rows.positive ws) by (unfold ws, Rows.positive, real; now rewrite Forall_map).
  revert g L. induction F as [|x m z reach Hx F IH]; intros [|a g] L; cbn in L; try lia.
  1-2: cbn [answered answers_bound]; rewrite Q2R_0; pose proof (size_star b f P) as S; fold ws in S; lra.
  cbn [answered answers_bound]. rewrite Qred_R, Q2R_plus, Q2R_mult.
  eapply Rle_trans; [apply Rows.size_plus, Pw|]. rewrite size_scaled_any by exact Pw.
  specialize (IH g ltac:(lia)). pose proof (size_star b a P) as S. fold ws in S.
  assert (Rabs x * Rows.size ws (star ws (real a)) <= Q2R (length_bound b a) * Q2R m).
  { rewrite Rmult_comm. apply Rmult_le_compat; try assumption; [apply Rows.size_nonneg|apply Rabs_pos]. }
  lra.
Qed.

End Forces.
