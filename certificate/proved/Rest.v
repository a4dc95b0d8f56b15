(* SPDX-License-Identifier: MIT *)
(* Stable at rest (FORMAT.md section 6): friction forces at the motion 0, and how they answer to what is left of
   the load.  `stable_at_rest`: where the rules hold, every system in the box is stable at every multiple. *)
From Coq Require Import List Arith String ZArith QArith Qreals Qminmax Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Tree.
From Proved Require Import Brouwer Homotopy RowLimits Degree Matrix Frame Between Ways Load Bound ByDegree Energy.
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

(* A friction force of this contact, across its normal. *)
Definition good_force (b : cbox) (f : vector) : bool :=
  has_friction b && Nat.eqb (List.length f) (List.length (box_weights b)) &&
  (box_signed b || is_zero (inner f (box_normal b))).

(* The first of a list, if it is about this contact, and the others. *)
Definition taken {A} (none : A) (i : Z) (them : list (Z * A)) : A * list (Z * A) :=
  match them with
  | (j, a) :: others => if Z.eqb j i then (a, others) else (none, them)
  | [] => (none, [])
  end.

(* The lists, put beside the contacts; None if rest-share does not hold. *)
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

(* The least interval with these numbers in it. *)
Definition range_of (qs : vector) : interval :=
  match qs with
  | [] => exactly 0
  | q :: qs' => fold_left (fun i q => Interval (Qmin (low i) q) (Qmax (high i) q)) qs' (exactly q)
  end.

Definition plus_interval (a b : interval) : interval :=
  Interval (reduced (low a + low b)) (reduced (high a + high b)).
Definition shifted (a : interval) (c : Q) : interval := Interval (reduced (low a + c)) (reduced (high a + c)).

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

(* w + lambda u *)
Definition loads_at (s : setting) (lambda : Q) : list interval :=
  let n := dimension_of s in
  map (fun k => shifted (work_of (the_load s) (unit_vector n k)) (lambda * nth k (load_growth (the_load s)) 0)) (seq 0 n).

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

(* rest-reach *)
Definition reach_holds (n : nat) (left : list interval) (columns : list (list interval)) (reach : vector) : bool :=
  Nat.eqb (List.length reach) n &&
  forallb (fun k =>
    let z := nth k reach 0 in
    Qle_bool 0 z &&
    Qle_bool
      (fold_left (fun sum l =>
         let d := nth k (nth l columns []) (exactly 0) in
         reduced (sum + most_of (shifted d (if Nat.eqb k l then -(1) else 0)) * nth l reach 0))
         (seq 0 n) (most_of (nth k left (exactly 0)))) z)
    (seq 0 n).

(* |f|^2, where f = g*. *)
Fixpoint square_of (weights f : vector) : Q :=
  match weights, f with w :: ws, x :: f' => reduced (x * x / w + square_of ws f') | _, _ => 0 end.

Definition length_bound (b : cbox) (f : vector) : Q := root_above (square_of (box_weights b) f).

Definition least_pressure (b : cbox) (lambda : Q) : Q :=
  match pressures b lambda with [p; q] => Qmin p q | _ => 0 end.

Fixpoint answers_bound (b : cbox) (g : matrix) (reach : vector) : Q :=
  match g, reach with
  | f :: g', z :: reach' => reduced (length_bound b f * z + answers_bound b g' reach')
  | _, _ => 0
  end.

(* rest-cone, of one contact. *)
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

(* Both rules at one multiple. *)
Definition rest_fails_at (n : nat) (s : setting) (them : list resting) (columns : list (list interval)) (reach
  : vector)
    (lambda : Q) : option string :=
  if negb (reach_holds n (left_over n s them lambda) columns reach) then Some "rest-reach"%string
  else if negb (forallb (cone_holds reach lambda) them && forallb (resting_sound lambda) them) then Some
    "rest-cone"%string
  else None.

(* From alpha to beta. *)
Definition rest_fails (s : setting) (alpha beta : Q) (p : rest_proof) : option string :=
  let n := dimension_of s in
  match resting_contacts n (rows s) 0 (rest_forces p) (rest_answers p) [] with
  | None => Some "rest-share"%string
  | Some them =>
      let holds := rest_fails_at n s them (map (column n them) (seq 0 n)) (rest_reach p) in
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
Proof. unfold within, plus_interval; cbn [low high]. rewrite !reduced_same, !Q2R_plus. lra. Qed.

Lemma shifted_within a c x : within a x -> within (shifted a c) (x + Q2R c).
Proof. unfold within, shifted; cbn [low high]. rewrite !reduced_same, !Q2R_plus. lra. Qed.

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
  intros [La Wa] [Lb Wb]. revert n b x y La Lb Wa Wb. induction a as [|i a IH]; intros n [|j b] x y La Lb Wa
    Wb; cbn in *;
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
        Rows.dot (x :: cs) (times (skipn j m) d) = x * Rows.dot (nth j m []) d + Rows.dot cs (times (skipn (S
          j) m) d)).
      { clear. intros m. induction m as [|a m IH]; intros [|j] x cs d; cbn [skipn times map Rows.dot nth].
        - rewrite dot_nil. ring.
        - rewrite dot_nil. ring.
        - reflexivity.
        - apply IH. }
      assert (G : forall c j, Rows.dot (real c) (times (skipn j (Rows.N r :: Rows.slips r)) (basis_vector n k)) =
        eval (fun fs => Rows.dot (real c) (times (skipn j (map real fs)) (basis_vector n k))) (geometry_tree b)
          (shares_in b p)).
      { clear c Hc. induction c as [|q c IH]; intros j.
        - symmetry. exact (eval_constant 0 _ _).
        - change (real (q :: c)) with (Q2R q :: real c). rewrite Skip, IH.
          transitivity (eval (fun fs => Q2R q * qdot (nth j fs []) (basis_vector n k) +
            Rows.dot (real c) (times (skipn (S j) (map real fs)) (basis_vector n k))) (geometry_tree b)
              (shares_in b p)).
          + now rewrite eval_sum, eval_multiple, <- (rational_corners b r p F mu t' I).
          + apply eval_same. intros fs _. rewrite Skip, qdot_is. f_equal. f_equal. f_equal. symmetry.
            exact (map_nth real fs [] j). }
      specialize (G c O). cbn [skipn] in G. rewrite G. apply eval_same. intros fs _. now rewrite dot_of_rows. }
    rewrite E.
    assert (Tip : forall fs, In fs (tips (geometry_tree b)) ->
      within (range_of (map (fun v => nth k v 0%Q) (flat_map (fun c => map (of_rows c) (tips (geometry_tree
        b))) sums)))
        (Rows.dot (real (of_rows c fs)) (basis_vector n k))).
    { intros fs Hfs. rewrite dot_unit by exact K.
      replace (nth k (real (of_rows c fs)) 0) with (Q2R (nth k (of_rows c fs) 0%Q)).
      - apply range_of_within. apply (in_map (fun v => nth k v 0%Q)). apply in_flat_map. exists c. split;
          [exact Hc|].
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
  rewrite Rows.product_plus, Rows.product_scaled, IH, product_star by (try exact P; unfold real; now rewrite
    map_length).
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
  apply negb_true_iff in H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in
    L. congruence.
Qed.

Lemma square_of_is ws f : Forall (fun w => 0 < Q2R w) ws ->
  Rows.product (real ws) (star (real ws) (real f)) (star (real ws) (real f)) = Q2R (square_of ws f).
Proof.
  intros P. revert f. induction P as [|w ws Pw P IH]; intros [|x f]; cbn [square_of real map star Rows.product];
    try (now rewrite Q2R_0).
  rewrite reduced_same, Q2R_plus, Q2R_div, Q2R_mult. 2: { intros E. apply Qeq_eqR in E. rewrite Q2R_0 in E. lra. }
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
  cbn [answered answers_bound]. rewrite reduced_same, Q2R_plus, Q2R_mult.
  eapply Rle_trans; [apply Rows.size_plus, Pw|]. rewrite size_scaled_any by exact Pw.
  specialize (IH g ltac:(lia)). pose proof (size_star b a P) as S. fold ws in S.
  assert (Rabs x * Rows.size ws (star ws (real a)) <= Q2R (length_bound b a) * Q2R m).
  { rewrite Rmult_comm. apply Rmult_le_compat; try assumption; [apply Rows.size_nonneg|apply Rabs_pos]. }
  lra.
Qed.

Lemma dot_listed_map n z (f : vector -> R) g : List.length g = n ->
  Rows.dot (listed n z) (map f g) = sum_to n (fun l => z l * f (nth l g [])).
Proof.
  revert z g. induction n as [|n IH]; intros z [|a g] L; try discriminate; cbn; [reflexivity|].
  rewrite (IH (fun i => z (S i)) g) by now injection L. reflexivity.
Qed.


End Forces.

(* ---- The theorem ---- *)

Lemma within_reach n reach z : List.length reach = n -> in_box n (fun k => Q2R (nth k reach 0%Q)) z ->
  Forall2 (fun x m => (Rabs x <= Q2R m)%R) (listed n z) reach.
Proof.
  revert z reach. induction n as [|m IHm]; intros z [|q reach] Le In_box; try discriminate; cbn; constructor.
  - apply Rabs_le. apply (In_box O). lia.
  - apply IHm; [now injection Le|]. intros k K. apply (In_box (S k)). lia.
Qed.

Section AtRest.
Open Scope R_scope.

Variable n : nat.

Record shaped (r : resting) (rr : Rows.row) : Prop := Shaped {
  shaped_inside : inside (resting_box r) rr;
  shaped_proper : proper n rr;
  shaped_force : (List.length (force_at_rest r) <= List.length (box_weights (resting_box r)))%nat;
  shaped_answers : answers r = [] \/ List.length (answers r) = n;
  shaped_each : Forall (fun a => List.length a <= List.length (box_weights (resting_box r)))%nat (answers r)
}.

Lemma resting_shaped rows rs i forces all before them :
  resting_contacts n rows i forces all before = Some them -> Forall2 fits rows rs -> Forall (proper n) rs ->
  exists rest, them = rev before ++ rest /\ Forall2 shaped rest rs.
Proof.
  intros H F. revert i forces all before H. induction F as [|row rr rows rs [_ I] F IH]; intros i forces all
    before H P.
  - cbn in H. destruct forces, all; try discriminate. injection H as <-. rewrite rev_append_rev. exists [].
    split; [reflexivity|constructor].
  - cbn [resting_contacts] in H. destruct (taken [] i forces) as [f forces'] eqn:Tf. destruct (taken [] i all)
      as [g all'] eqn:Tg.
    destruct (_ && _) eqn:C in H; [|discriminate]. apply andb_true_iff in C as [Cf Cg].
    assert (Good : forall f, good_force (box row) f = true -> List.length f = List.length (box_weights (box row))).
    { intros a Ha. unfold good_force in Ha. rewrite !andb_true_iff in Ha. now apply Nat.eqb_eq. }
    destruct (IH _ _ _ _ H (Forall_inv_tail P)) as (rest & E & S). exists (Resting (box row) f g :: rest). split.
    + rewrite E. cbn. now rewrite <- app_assoc.
    + constructor; [|exact S]. constructor; cbn; [exact I|exact (Forall_inv P)| | |].
      * destruct f; [cbn; lia|]. rewrite (Good _ Cf). lia.
      * destruct g; [now left|]. apply andb_true_iff in Cg as [Cg _]. apply Nat.eqb_eq in Cg. now right.
      * destruct g as [|a g]; [constructor|]. apply andb_true_iff in Cg as [_ Cg]. rewrite forallb_forall in Cg.
        apply Forall_forall. intros b Hb. rewrite (Good _ (Cg b Hb)). lia.
Qed.

Variable s : setting.
Variable sys : Rows.system.
Hypothesis fit : in_setting s sys.
Hypothesis n_is : dimension_of s = n.
Variable them : list resting.
Hypothesis them_shaped : Forall2 shaped them (Rows.rows sys).
Variable reach : vector.

Definition pressure (lambda : R) (rr : Rows.row) : R := Rows.preload rr + lambda * Rows.growth rr.

(* What is done on y: by forces that do not answer, and by the answers to the component l. *)
Fixpoint still (lambda : R) (ts : list resting) (rs : list Rows.row) (y : list R) : R :=
  match ts, rs with
  | r :: ts', rr :: rs' =>
      pressure lambda rr * Rows.dot (Rows.N rr) y + Rows.dot (real (force_at_rest r)) (Rows.slip rr y) +
      still lambda ts' rs' y
  | _, _ => 0
  end.

Fixpoint answer (l : nat) (ts : list resting) (rs : list Rows.row) (y : list R) : R :=
  match ts, rs with
  | r :: ts', rr :: rs' => Rows.dot (real (nth l (answers r) [])) (Rows.slip rr y) + answer l ts' rs' y
  | _, _ => 0
  end.

Definition forces_at (lambda : R) (z : vec) (ts : list resting) (rs : list Rows.row) : list Rows.force :=
  map (fun p => (pressure lambda (snd p), answered (Rows.weights (snd p)) (force_at_rest (fst p)) (answers (fst
    p)) (listed n z)))
    (List.combine ts rs).

Lemma weights_real r rr : shaped r rr -> Rows.weights rr = real (box_weights (resting_box r)).
Proof. intros S. destruct (shaped_inside _ _ S) as (p & F & mu & t & I). apply (is_weights _ _ _ _ _ _ I). Qed.

Lemma works_at lambda z ts rs y : Forall2 shaped ts rs ->
  Rows.works rs (forces_at lambda z ts rs) y = still lambda ts rs y + sum_to n (fun l => z l * answer l ts rs y).
Proof.
  intros F. induction F as [|r rr ts rs S F IH]; cbn [forces_at List.combine map Rows.works still answer].
  - rewrite sum_zero by (intros; cbn; ring). ring.
  - unfold forces_at in IH. rewrite IH. unfold Rows.work. cbn [fst snd].
    pose proof (weights_real _ _ S) as Wr. pose proof (RowLimits.weights_positive _ _ (shaped_proper _ _ S)) as P.
    assert (Lw : List.length (Rows.weights rr) = List.length (box_weights (resting_box r))) by (rewrite Wr;
      apply map_length).
    rewrite product_answered; [|exact P|rewrite Lw; apply S|rewrite Lw; apply S].
    assert (E : Rows.dot (listed n z) (map (fun a => Rows.dot (real a) (Rows.slip rr y)) (answers r)) =
      sum_to n (fun l => z l * Rows.dot (real (nth l (answers r) [])) (Rows.slip rr y))).
    { destruct (shaped_answers _ _ S) as [E|L]; [|now apply (dot_listed_map n z (fun a => Rows.dot (real a)
        (Rows.slip rr y)))].
      rewrite E. cbn. rewrite dot_nil, sum_zero; [reflexivity|]. intros [|l] _; cbn; ring. }
    assert (E2 : sum_to n (fun l => z l * (Rows.dot (real (nth l (answers r) [])) (Rows.slip rr y) + answer l
      ts rs y)) =
      sum_to n (fun l => z l * Rows.dot (real (nth l (answers r) [])) (Rows.slip rr y)) +
      sum_to n (fun l => z l * answer l ts rs y)) by (rewrite <- sum_plus; apply sum_same; intros; ring).
    rewrite E, E2. ring.
Qed.

(* What has to hold at a multiple. *)
Definition Wr (lambda : R) (k : nat) : R :=
  Rows.load sys 1 lambda (basis_vector n k) + still lambda them (Rows.rows sys) (basis_vector n k).

Definition off (k l : nat) : R := answer l them (Rows.rows sys) (basis_vector n k) - (if Nat.eqb k l then 1 else 0).

Definition held (lambda : R) (r : resting) (rr : Rows.row) : Prop :=
  ((force_at_rest r = [] /\ answers r = []) \/
   Q2R (length_bound (resting_box r) (force_at_rest r)) + Q2R (answers_bound (resting_box r) (answers r) reach) <=
     Rows.rho rr * pressure lambda rr) /\
  (Rows.spring rr = false -> 0 <= pressure lambda rr).

Definition rests (lambda : R) : Prop :=
  (forall k, (k < n)%nat -> 0 <= Q2R (nth k reach 0%Q) /\
     Rabs (Wr lambda k) + sum_to n (fun l => Rabs (off k l) * Q2R (nth l reach 0%Q)) <= Q2R (nth k reach 0%Q)) /\
  Forall2 (held lambda) them (Rows.rows sys).

Lemma pressure_mix t a b rr : pressure (mix t a b) rr = mix t (pressure a rr) (pressure b rr).
Proof. unfold pressure, mix. ring. Qed.

Lemma still_mix t a b ts rs y : still (mix t a b) ts rs y = mix t (still a ts rs y) (still b ts rs y).
Proof.
  revert rs. induction ts as [|r ts IH]; intros [|rr rs]; cbn; try (unfold mix; ring). rewrite IH,
    pressure_mix. unfold mix. ring.
Qed.

Lemma rests_between t a b : 0 <= t <= 1 -> rests a -> rests b -> rests (mix t a b).
Proof.
  intros T [A1 A2] [B1 B2]. split.
  - intros k K. destruct (A1 k K) as [Z A]. destruct (B1 k K) as [_ B]. split; [exact Z|].
    assert (E : Wr (mix t a b) k = mix t (Wr a k) (Wr b k)).
    { unfold Wr. rewrite still_mix. unfold Rows.load, mix. ring. }
    rewrite E. set (x := sum_to _ _) in *. unfold mix.
    pose proof (Rabs_triang ((1 - t) * Wr a k) (t * Wr b k)) as Tr. rewrite !Rabs_mult in Tr.
    rewrite (Rabs_right (1 - t)), (Rabs_right t) in Tr by lra. nra.
  - clear A1 B1 fit them_shaped. revert B2. induction A2 as [|r rr ts rs [H1 H2] A2 IH]; intros B2; [constructor|].
    inversion B2 as [|? ? ? ? [G1 G2] B3]; subst. constructor; [|now apply IH]. unfold held. rewrite
      pressure_mix. split.
    + destruct H1 as [H1|H1]; [now left|]. destruct G1 as [G1|G1]; [now left|]. right. unfold mix. nra.
    + intros Sp. specialize (H2 Sp). specialize (G2 Sp). unfold mix. nra.
Qed.

Lemma answered_nothing ws z : Rows.size ws (answered ws [] [] z) = 0.
Proof. cbn. unfold Rows.size. destruct ws; cbn; apply sqrt_0. Qed.

Lemma slip_at_rest rr : Rows.size (Rows.weights rr) (Rows.slip rr (listed n (fun _ => 0))) = 0 /\
  forall g, Rows.product (Rows.weights rr) g (Rows.slip rr (listed n (fun _ => 0))) = 0.
Proof.
  assert (G : forall ws g, Rows.product ws g (Rows.slip rr (listed n (fun _ => 0))) = 0).
  { unfold Rows.slip. induction (Rows.slips rr) as [|f fs IH]; intros ws g; destruct ws, g; cbn; try reflexivity.
    rewrite dot_listed_zero, IH. ring. }
  split; [|intros g; apply G]. unfold Rows.size. rewrite G. apply sqrt_0.
Qed.

(* Friction that is held. *)
Lemma held_obeys w lambda z r rr : shaped r rr -> friction_sound (resting_box r) = true ->
  Forall (fun q => 0 < Q2R q) (box_weights (resting_box r)) -> held lambda r rr ->
  (List.length (answers r) <= List.length reach)%nat -> Forall2 (fun x m => Rabs x <= Q2R m) (listed n z) reach ->
  Rows.obeys w (listed n (fun _ => 0)) 1 lambda rr
    (pressure lambda rr, answered (Rows.weights rr) (force_at_rest r) (answers r) (listed n z)).
Proof.
  intros S FS Pw [H Pr] L Z. destruct (slip_at_rest rr) as [S0 S1]. unfold Rows.obeys. rewrite S0, S1.
  assert (V : Rows.v rr (listed n (fun _ => 0)) 1 lambda = pressure lambda rr).
  { unfold Rows.v, pressure. rewrite dot_listed_zero. ring. }
  rewrite V. split; [|split; [|ring]].
  - unfold Rows.normal_law. destruct (Rows.spring rr); [reflexivity|]. specialize (Pr eq_refl). destruct w; cbn.
    + now rewrite Rmax_right.
    + now split.
  - destruct H as [[E1 E2]|H].
    + rewrite E1, E2, answered_nothing. destruct (Rows.spring rr) eqn:Sp.
      * rewrite (spring_has_no_friction _ _ (shaped_proper _ _ S) Sp). lra.
      * specialize (Pr eq_refl). apply Rmult_le_pos; [apply (rho_nonneg _ _ (shaped_proper _ _ S))|exact Pr].
    + rewrite (weights_real _ _ S). eapply Rle_trans; [|exact H]. now apply size_answered.
Qed.

Hypothesis reach_length : List.length reach = n.
Hypothesis all_sound : Forall (fun r => friction_sound (resting_box r) = true /\
  Forall (fun q => 0 < Q2R q) (box_weights (resting_box r))) them.

Theorem stable_where_it_rests lambda : rests lambda ->
  exists fs, Rows.equilibrium sys (listed n (fun _ => 0)) 1 lambda fs.
Proof.
  intros [Re He]. destruct fit as [_ Fd Fp [Fl1 Fl2] _ _ _]. rewrite n_is in *.
  destruct (answered_exactly n (Wr lambda) (fun k l => answer l them (Rows.rows sys) (basis_vector n k))
    (fun k => Q2R (nth k reach 0%Q))) as (z & In_box & Zero); [exact Re|].
  exists (forces_at lambda z them (Rows.rows sys)). split; [now rewrite length_listed|]. split.
  - pose proof (within_reach n reach z reach_length In_box) as Zr.
    unfold forces_at. clear - them_shaped all_sound He Zr reach_length.
    revert all_sound He. induction them_shaped as [|r rr ts rs S F IH]; intros A He; cbn; constructor.
    + destruct (Forall_inv A) as [A1 A2]. inversion He; subst. apply held_obeys; try assumption.
      destruct (shaped_answers _ _ S) as [E|E]; [rewrite E; cbn; lia|]. rewrite E, reach_length. lia.
    + inversion He; subst. apply IH; [exact F|exact (Forall_inv_tail A)|assumption].
  - assert (Known : known_by_units n (fun y => Rows.load sys 1 lambda y + Rows.works (Rows.rows sys)
        (forces_at lambda z them (Rows.rows sys)) y)).
    { apply known_plus; [unfold Rows.load; apply known_plus; now apply known_multiple, dot_known|].
      clear - Fp. generalize (forces_at lambda z them (Rows.rows sys)). induction Fp as [|r rs Pr Fp IH];
        intros fs; [apply known_zero|].
      destruct fs as [|f fs]; [apply known_zero|]. cbn. apply (known_plus n (Rows.work r f)); [now apply
        work_known|apply IH]. }
    intros y. rewrite (Known y). apply sum_zero. intros k K. rewrite works_at by exact them_shaped.
    specialize (Zero k K). unfold Wr in Zero. rewrite <- Rplus_assoc, Zero. ring.
Qed.

(* ---- What the rules say of W, M and the cones ---- *)

Lemma times_forms rr y : times (Rows.N rr :: Rows.slips rr) y = Rows.dot (Rows.N rr) y :: Rows.slip rr y.
Proof. reflexivity. Qed.

(* P' of a choice is between its ends. *)
Lemma pressure_between q r rr : shaped r rr -> exists t, 0 <= t <= 1 /\
  pressure (Q2R q) rr = mix t (Q2R (low (box_preload (resting_box r)) + q * low (box_growth (resting_box r))))
                              (Q2R (high (box_preload (resting_box r)) + q * high (box_growth (resting_box r)))).
Proof.
  intros S. destruct (shaped_inside _ _ S) as (p & G & mu & t & I). exists t. split; [apply (in_step _ _ _ _ _
    _ I)|].
  unfold pressure, mix. rewrite (in_preload _ _ _ _ _ _ I), (in_growth _ _ _ _ _ _ I), !Q2R_plus, !Q2R_mult. ring.
Qed.

Lemma contact_within q r rr : shaped r rr ->
  all_within n (ranges n (resting_box r) (map (fun p => p :: force_at_rest r) (pressures (resting_box r) q)))
    (fun k => pressure (Q2R q) rr * Rows.dot (Rows.N rr) (basis_vector n k) +
              Rows.dot (real (force_at_rest r)) (Rows.slip rr (basis_vector n k))).
Proof.
  intros S. destruct (pressure_between q r rr S) as (t & T & E).
  eapply all_within_same; [|apply (ranges_within n (resting_box r) rr _
    ((low (box_preload (resting_box r)) + q * low (box_growth (resting_box r)))%Q :: force_at_rest r)
    ((high (box_preload (resting_box r)) + q * high (box_growth (resting_box r)))%Q :: force_at_rest r) t);
    [apply S|apply S|now left|right; now left|exact T]].
  intros k _. cbn beta. rewrite !times_forms, E. unfold real. cbn [map Rows.dot]. unfold mix. ring.
Qed.

Lemma still_within q ts rs acc x : Forall2 shaped ts rs -> all_within n acc x ->
  all_within n (fold_left (fun sum r => plus_intervals sum
      (ranges n (resting_box r) (map (fun p => p :: force_at_rest r) (pressures (resting_box r) q)))) ts acc)
    (fun k => x k + still (Q2R q) ts rs (basis_vector n k)).
Proof.
  intros F. revert acc x. induction F as [|r rr ts rs S F IH]; intros acc x A; cbn [fold_left still].
  - apply (all_within_same n acc x); [|exact A]. intros; cbn; ring.
  - eapply all_within_same; [|apply IH; apply plus_intervals_within; [exact A|apply (contact_within q r rr S)]].
    intros k _. cbn beta. ring.
Qed.

Lemma answer_within l ts rs acc x : Forall2 shaped ts rs -> all_within n acc x ->
  all_within n (fold_left (fun sum r => match answers r with
      | [] => sum
      | g => plus_intervals sum (ranges n (resting_box r) [0%Q :: nth l g []])
      end) ts acc)
    (fun k => x k + answer l ts rs (basis_vector n k)).
Proof.
  intros F. revert acc x. induction F as [|r rr ts rs S F IH]; intros acc x A; cbn [fold_left answer].
  - apply (all_within_same n acc x); [|exact A]. intros; cbn; ring.
  - destruct (answers r) as [|a g] eqn:E.
    + eapply all_within_same; [|apply IH; exact A]. intros k _. cbn beta. destruct l; cbn; ring.
    + rewrite <- E. eapply all_within_same; [|apply IH; apply plus_intervals_within; [exact A|
        apply (ranges_within n (resting_box r) rr _ (0%Q :: nth l (answers r) []) (0%Q :: nth l (answers r) []) 0);
        [apply S|apply S|now left|now left|lra]]].
      intros k _. cbn beta. rewrite times_forms. unfold real, mix. cbn [map Rows.dot]. rewrite Q2R_0. ring.
Qed.

Lemma loads_within q : all_within n (loads_at s q) (fun k => Rows.load sys 1 (Q2R q) (basis_vector n k)).
Proof.
  destruct fit as [(_ & Fw & Fg) _ _ [L1 L2] _ _]. unfold loads_at, Rows.load. rewrite n_is in *. split.
  - now rewrite map_length, seq_length.
  - intros k K. rewrite nth_indep with (d' := shifted (work_of (the_load s) (unit_vector n 0))
      (q * nth 0 (load_growth (the_load s)) 0%Q)) by (now rewrite map_length, seq_length).
    rewrite (map_nth (fun k => shifted (work_of (the_load s) (unit_vector n k)) (q * nth k (load_growth (the_load s)) 0%Q))).
    rewrite seq_nth by exact K. cbn [Nat.add].
    pose proof (load_within _ _ (unit_vector n k) Fw) as W. rewrite (unit_vector_is n k K) in W.
    apply (shifted_within _ (q * nth k (load_growth (the_load s)) 0%Q)) in W.
    rewrite Q2R_mult in W. replace (Q2R (nth k (load_growth (the_load s)) 0%Q)) with
      (Rows.dot (Rows.direction sys) (basis_vector n k)) in W.
    + now rewrite Rmult_1_l.
    + rewrite dot_unit by exact K. rewrite <- Fg. rewrite <- Q2R_0 at 1. apply map_nth.
Qed.

Lemma nth_exactly k : nth k (repeat (exactly 0) n) (exactly 0) = exactly 0.
Proof.
  destruct (nth_in_or_default k (repeat (exactly 0) n) (exactly 0)) as [H|H]; [|exact H]. now apply repeat_spec
    in H.
Qed.

Lemma column_within l : all_within n (column n them l) (fun k => answer l them (Rows.rows sys) (basis_vector n k)).
Proof.
  apply (all_within_same n _ (fun k => 0 + answer l them (Rows.rows sys) (basis_vector n k))); [intros; ring|].
  apply answer_within; [exact them_shaped|]. split; [apply repeat_length|].
  intros k _. rewrite nth_exactly. unfold within; cbn. rewrite Q2R_0. lra.
Qed.

Lemma sum_by_fold f g init m0 m : Q2R (fold_left (fun sum l => reduced (sum + f l * g l)) (seq m0 m) init) =
  Q2R init + sum_to m (fun l => Q2R (f (m0 + l)%nat) * Q2R (g (m0 + l)%nat)).
Proof.
  revert m0 init. induction m as [|m IH]; intros m0 init; cbn [seq fold_left sum_to]; [ring|].
  rewrite IH, reduced_same, Q2R_plus, Q2R_mult, Nat.add_0_r.
  rewrite (sum_same m (fun l => Q2R (f (S m0 + l)%nat) * Q2R (g (S m0 + l)%nat))
    (fun l => Q2R (f (m0 + S l)%nat) * Q2R (g (m0 + S l)%nat))) by (intros; now rewrite Nat.add_succ_r). ring.
Qed.

Lemma root_below_nonneg q : 0 <= Q2R (root_below q).
Proof.
  unfold root_below. destruct (_ && _) eqn:H; [|rewrite Q2R_0; lra].
  apply andb_true_iff in H as [H _]. apply Qle_bool_R in H. now rewrite Q2R_0 in H.
Qed.

Lemma held_by_rules q r rr : shaped r rr -> cone_holds reach q r = true -> resting_sound q r = true -> held
  (Q2R q) r rr.
Proof.
  intros S C Sd. unfold resting_sound in Sd. rewrite !andb_true_iff in Sd. destruct Sd as [[[Fs _] Sq] Pn].
  destruct (pressure_between q r rr S) as (t & T & E). destruct (shaped_inside _ _ S) as (p & G & mu & t' & I).
  set (a := (low (box_preload (resting_box r)) + q * low (box_growth (resting_box r)))%Q) in *.
  set (b := (high (box_preload (resting_box r)) + q * high (box_growth (resting_box r)))%Q) in *.
  assert (Least : Q2R (least_pressure (resting_box r) q) <= pressure (Q2R q) rr).
  { rewrite E. unfold least_pressure, pressures. fold a b. destruct (min_R a b). unfold mix. nra. }
  split.
  - unfold cone_holds in C. destruct (force_at_rest r) as [|x f] eqn:Ef; [destruct (answers r) as [|y g]
      eqn:Eg; [now left|]|];
      right; rewrite <- ?Ef, <- ?Eg in *; apply Qle_bool_R in C; rewrite Q2R_plus, !Q2R_mult in C;
      (eapply Rle_trans; [exact C|]); rewrite (is_rho _ _ _ _ _ _ I);
      pose proof (in_friction _ _ _ _ _ _ I) as [M1 M2]; pose proof (friction_nonneg _ _ _ _ _ _ I) as M0;
      pose proof (root_below_nonneg (box_square (resting_box r))) as R0;
      pose proof (root_below_is _ (square_nonneg _ _ _ _ _ _ I)) as R1;
      unfold friction_sound in Fs; apply andb_true_iff in Fs as [F0 Fs]; apply Qle_bool_R in F0; rewrite Q2R_0
        in F0;
      set (m := Q2R (low (box_friction (resting_box r)))) in *; set (l := Q2R (root_below _)) in *;
      set (v := Q2R (least_pressure _ _)) in *;
      (destruct (box_spring (resting_box r)) eqn:Sp;
        [pose proof (spring_smooth _ _ _ _ _ _ I Sp) as Z; replace m with 0 by lra; rewrite Z; lra|]);
      rewrite orb_false_l in Pn; apply Qle_bool_R in Pn; rewrite Q2R_0 in Pn; fold v in Pn;
      apply Rmult_le_compat; try lra; try (apply Rmult_le_pos; assumption); apply Rmult_le_compat; lra.
  - intros Sp. rewrite (is_spring _ _ _ _ _ _ I) in Sp. rewrite Sp, orb_false_l in Pn. apply Qle_bool_R in Pn.
    rewrite Q2R_0 in Pn. lra.
Qed.

Lemma rests_by_rules q :
  reach_holds n (left_over n s them q) (map (column n them) (seq 0 n)) reach = true ->
  forallb (cone_holds reach q) them = true -> forallb (resting_sound q) them = true -> rests (Q2R q).
Proof.
  intros H C Sd.
  assert (All : forall k, (k < n)%nat -> 0 <= Q2R (nth k reach 0%Q)).
  { intros k K. unfold reach_holds in H. apply andb_true_iff in H as [_ H]. rewrite forallb_forall in H.
    specialize (H k). rewrite in_seq in H. specialize (H ltac:(lia)). apply andb_true_iff in H as [H _].
    apply Qle_bool_R in H. now rewrite Q2R_0 in H. }
  split.
  - intros k K. unfold reach_holds in H. apply andb_true_iff in H as [_ H]. rewrite forallb_forall in H.
    specialize (H k). rewrite in_seq in H. specialize (H ltac:(lia)). apply andb_true_iff in H as [H0 H].
    apply Qle_bool_R in H0, H. rewrite Q2R_0 in H0. split; [exact H0|]. rewrite sum_by_fold in H. cbn [Nat.add]
      in H.
    eapply Rle_trans; [|exact H]. apply Rplus_le_compat.
    + apply most_of_bound. destruct (still_within q them (Rows.rows sys) _ _ them_shaped (loads_within q)) as [_ W].
      exact (W k K).
    + assert (G : forall m a b, (forall i, (i < m)%nat -> a i <= b i) -> sum_to m a <= sum_to m b).
      { clear. induction m as [|m IH]; intros a b H; cbn; [lra|].
        apply Rplus_le_compat; [apply H; lia|]. apply IH. intros; apply H; lia. }
      apply G. intros l L. apply Rmult_le_compat_r; [apply (All l L)|].
      apply most_of_bound. unfold off. destruct (column_within l) as [_ W]. specialize (W k K).
      rewrite (nth_indep _ [] (column n them 0)) by (now rewrite map_length, seq_length).
      rewrite map_nth, seq_nth by exact L. cbn [Nat.add].
      pose proof (shifted_within _ (if Nat.eqb k l then -(1) else 0)%Q _ W) as Sh.
      replace (Q2R (if Nat.eqb k l then -(1) else 0)) with (- (if Nat.eqb k l then 1 else 0)) in Sh; [exact Sh|].
      destruct (Nat.eqb k l); unfold Q2R; cbn; lra.
  - clear - C Sd them_shaped. revert C Sd. induction them_shaped as [|r rr ts rs S F IH]; intros C Sd; constructor;
      cbn in C, Sd; apply andb_true_iff in C as [C1 C2]; apply andb_true_iff in Sd as [S1 S2];
      [now apply held_by_rules|now apply IH].
Qed.

End AtRest.

(* A system of rows in the box rests. *)
Theorem rests_in_box s sys alpha beta p lambda : in_setting s sys -> Forall2 fits (rows s) (Rows.rows sys) ->
  rest_fails s alpha beta p = None -> (Q2R alpha <= lambda <= Q2R beta)%R ->
  exists fs, Rows.equilibrium sys (listed (dimension_of s) (fun _ => 0%R)) 1 lambda fs.
Proof.
  intros Fit Fi H L. unfold rest_fails in H. set (n := dimension_of s) in *.
  destruct (resting_contacts n _ _ _ _ _) as [them|] eqn:E; [|discriminate].
  destruct (resting_shaped n (rows s) (Rows.rows sys) _ _ _ _ _ E Fi (its_proper _ _ Fit))
    as (rest & E' & S). cbn in E'. subst rest.
  set (fails := rest_fails_at n s them (map (column n them) (seq 0 n)) (rest_reach p)) in H.
  assert (Rules : forall q, fails q = None ->
    reach_holds n (left_over n s them q) (map (column n them) (seq 0 n)) (rest_reach p) = true /\
    forallb (cone_holds (rest_reach p) q) them = true /\ forallb (resting_sound q) them = true).
  { intros q F. unfold fails, rest_fails_at in F. destruct (reach_holds _ _ _ _); [|discriminate]. cbn [negb] in F.
    destruct (forallb (cone_holds _ q) them && _) eqn:C; [|discriminate]. apply andb_true_iff in C. tauto. }
  assert (Rests : forall q, fails q = None -> rests n sys them (rest_reach p) (Q2R q)).
  { intros q F. destruct (Rules q F) as (A & B & C). apply (rests_by_rules n s sys Fit eq_refl them S); try
      assumption.
    unfold reach_holds in A. apply andb_true_iff in A as [A _]. now apply Nat.eqb_eq. }
  destruct (fails alpha) eqn:Fa; [discriminate|]. destruct (Rules alpha Fa) as (A & _ & C).
  apply (stable_where_it_rests n s sys Fit eq_refl them S (rest_reach p)).
  - unfold reach_holds in A. apply andb_true_iff in A as [A _]. now apply Nat.eqb_eq.
  - rewrite forallb_forall in C. apply Forall_forall. intros r Hr. specialize (C r Hr). unfold resting_sound in C.
    rewrite !andb_true_iff in C. split; [apply C|]. now apply positive_weights.
  - pose proof (Rests alpha Fa) as Ra. destruct (Qeq_bool alpha beta) eqn:Q.
    + apply Qeq_bool_eq, Qeq_eqR in Q. replace lambda with (Q2R alpha) by lra. exact Ra.
    + pose proof (Rests beta H) as Rb. set (a := Q2R alpha) in *. set (b := Q2R beta) in *.
      assert (NE : (a < b)%R).
      { destruct (Req_dec a b) as [Eq|Ne]; [|lra]. apply eqR_Qeq, Qeq_eq_bool in Eq. congruence. }
      replace lambda with (mix ((lambda - a) / (b - a)) a b) by (unfold mix; field; lra).
      apply rests_between; try assumption.
      assert (0 < / (b - a))%R by (apply Rinv_0_lt_compat; lra). split.
      * apply Rmult_le_pos; lra.
      * apply Rmult_le_reg_r with (b - a)%R; [lra|]. field_simplify; lra.
Qed.

(* ---- Where normals in space are uncertain ---- *)

Section Standing.
Open Scope R_scope.

Definition stand_for (rs' rs : list Rows.row) : Prop := Forall2 (fun r r' => exists k, stands k r r') rs rs'.

(* Of every choice there are rows in the box that stand for its own. *)
Lemma standing_rows n rows rs : Forall2 suits rows rs -> Forall (proper n) rs ->
  exists rs', Forall2 fits rows rs' /\ stand_for rs' rs /\ Forall (proper n) rs'.
Proof.
  intros F. induction F as [|row r rows rs [E Se] F IH]; intros P.
  - exists []. repeat constructor.
  - destruct (IH (Forall_inv_tail P)) as (rs' & F' & S' & P').
    destruct (seen_stands _ _ Se) as (r' & k & p & G & mu & t & I & St & _).
    exists (r' :: rs'). split; [|split]; constructor; try assumption.
    + split; [exact E|]. now exists p, G, mu, t.
    + now exists k.
    + exact (stands_proper n _ _ _ _ _ _ _ _ St I (Forall_inv P)).
Qed.

(* What these can hold at rest, it can. *)
Lemma holds_at_rest n w lambda rs rs' fs' : stand_for rs' rs ->
  Forall2 (Rows.obeys w (listed n (fun _ => 0)) 1 lambda) rs' fs' ->
  exists fs, Forall2 (Rows.obeys w (listed n (fun _ => 0)) 1 lambda) rs fs /\
    forall y, Rows.works rs fs y = Rows.works rs' fs' y.
Proof.
  intros F. revert fs'. induction F as [|r r' rs rs' [k St] F IH]; intros fs' O;
    inversion O as [|? [a g'] ? fs'' (L & C & _) Os]; subst.
  - exists []. split; [constructor|reflexivity].
  - destruct (IH _ Os) as (fs & Of & Wf). destruct (holds _ _ _ St a g' C) as (g & Cg & Wg).
    destruct (slip_at_rest n r) as [S0 S1]. exists ((a, g) :: fs). split.
    + constructor; [|exact Of]. unfold Rows.obeys. rewrite S0, S1.
      rewrite (same_pull _ _ _ _ _ _ St) in L. unfold Rows.normal_law in *. rewrite (Leaf.same_spring _ _ _ St) in L.
      split; [exact L|]. split; [exact Cg|ring].
    + intros y. cbn. rewrite Wf. unfold Rows.work; cbn [fst snd]. now rewrite Wg, (same_N _ _ _ St).
Qed.

End Standing.

Theorem stable_at_rest s sys alpha beta p lambda : in_setting s sys -> rest_fails s alpha beta p = None ->
  (Q2R alpha <= lambda <= Q2R beta)%R -> Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros [(Su & LW & LU) D P Le Sl Pu Bd] H L.
  destruct (standing_rows _ _ _ Su P) as (rs' & Fi & St & P').
  set (sys' := Rows.System (Rows.dimension sys) rs' (Rows.wrench sys) (Rows.direction sys) (Rows.normal sys)).
  assert (Fit : in_setting s sys').
  { constructor; try assumption. split; [now apply all_suit|now repeat split]. }
  destruct (rests_in_box s sys' alpha beta p lambda Fit Fi H L) as (fs' & Ld & O & B).
  destruct (holds_at_rest _ _ _ _ _ _ St O) as (fs & Of & Wf).
  exists (listed (dimension_of s) (fun _ => 0%R)), fs. split; [now apply bounded_at_rest|].
  split; [exact Ld|]. split; [exact Of|].
  intros y. rewrite Wf. apply B.
Qed.
