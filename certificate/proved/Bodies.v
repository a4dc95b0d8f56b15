(* SPDX-License-Identifier: MIT *)
(* Several bodies (FORMAT.md section 14): their rows are those of one body, on the motion of one body seen from the
   other, which is linear in the state; and rows of ratchets and springs.  `mechanism_rows_stable`: a mechanism is
   stable if and only if its rows are.  `lift_seen`, `element_seen`: every choice of a question has its rows in the
   boxes. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Slips Leaf RowsOfModels Between Ways Contacts Fingers.
From Proved Require Rows Model SpaceModel BodiesModel RowLimits Homotopy.
Import ListNotations.

(* ---- Rows of a motion that is linear in the state ---- *)

Fixpoint dot_q (a b : list Q) : Q :=
  match a, b with x :: a', y :: b' => (x * y + dot_q a' b')%Q | _, _ => 0%Q end.

(* The form of states, for one of motions whose columns are G. *)
Definition lift_q (G : list (list Q)) (f : list Q) : list Q := map (fun g => reduced (dot_q f g)) G.

(* Of N and of slips. *)
Definition lift_forms_q (G fs : list (list Q)) : list (list Q) := lift_q G (hd [] fs) :: map (lift_q G) (tl fs).

Definition lift_box (G : list (list Q)) (b : cbox) : cbox :=
  CBox (box_names b) (box_geometry b) (fun geometry => lift_forms_q G (box_forms b geometry)) (box_friction b)
    (box_preload b) (box_growth b) (box_stiffness b) (box_square b) (box_normal b) (box_weights b) (box_signed b)
    (box_spring b) (box_turns b) (box_slack b).

(* ---- How bodies move ---- *)

Definition of_number_q (motions : list (list Q)) (b : option nat) : list Q :=
  match b with Some number => nth number motions [] | None => [] end.

Definition motion_of_body_q (n : nat) (d : list Q) (before : list (list Q)) (b : rigid_body) : list Q :=
  match b with
  | Free first => firstn n (skipn first d)
  | Link on eta turns => add_multiple (of_number_q before on) (dot_q turns d) eta
  end.

Fixpoint motions_q (n : nat) (d : list Q) (bodies : list rigid_body) (before : list (list Q)) : list (list Q) :=
  match bodies with
  | [] => before
  | b :: rest => motions_q n d rest (before ++ [map reduced (motion_of_body_q n d before b)])
  end.

Definition numbers_of (its : mechanism) : nat := if bodies_in_space its then 6%nat else 3%nat.

Definition unit_q (k : nat) : list Q := repeat 0%Q k ++ [1%Q].

(* All motions, for a unit of each coordinate. *)
Definition unit_motions (D : nat) (its : mechanism) : list (list (list Q)) :=
  map (fun k => motions_q (numbers_of its) (unit_q k) (bodies its) []) (seq 0 D).

Definition columns (units : list (list (list Q))) (c : contact) : list (list Q) :=
  map (fun ms => add_multiple (of_number_q ms (of_body c)) (-1) (of_number_q ms (by_body c))) units.

Definition element_box (e : element) : cbox :=
  CBox [] [] (fun _ => [lever e]) (exactly 0) (element_preload e) (exactly (element_growth e)) (element_stiffness e) 1
    [] [] true (element_spring e) false (fun _ => 0%Q).

Definition mechanism_boxes (bits : Z) (D : nat) (its : mechanism) (contacts : list contact) : option (list cbox) :=
  let units := unit_motions D its in
  match all_some (fun c => match enlarge_finger bits c with
                           | Some b => Some (lift_box (columns units c) b)
                           | None => None
                           end) contacts with
  | Some boxes => Some (boxes ++ map element_box (elements its))
  | None => None
  end.

Section Proofs.
Open Scope R_scope.

Notation real := (map Q2R).

Definition combination (G : list (list R)) (d : list R) : list R :=
  fold_right (fun gx sum => Rows.plus (Rows.scaled (snd gx) (fst gx)) sum) [] (List.combine G d).

Definition lift (G : list (list R)) (f : list R) : list R := map (Rows.dot f) G.

Lemma dot_sym a b : Rows.dot a b = Rows.dot b a.
Proof. revert b. induction a as [|x a IH]; intros [|y b]; cbn; try reflexivity. rewrite IH. ring. Qed.

Lemma dot_nil a : Rows.dot a [] = 0.
Proof. now destruct a. Qed.

Lemma dot_plus_right f a b : Rows.dot f (Rows.plus a b) = Rows.dot f a + Rows.dot f b.
Proof. now rewrite dot_sym, Rows.dot_plus, !(dot_sym _ f). Qed.

Lemma dot_scaled_right f c a : Rows.dot f (Rows.scaled c a) = c * Rows.dot f a.
Proof. now rewrite dot_sym, Rows.dot_scaled, dot_sym. Qed.

Lemma dot_lift G f d : Rows.dot (lift G f) d = Rows.dot f (combination G d).
Proof.
  revert d. unfold lift, combination. induction G as [|g G IH]; intros [|x d];
    cbn [map List.combine fold_right fst snd]; try (symmetry; apply dot_nil). cbn [Rows.dot].
  rewrite IH, dot_plus_right, dot_scaled_right. ring.
Qed.

Definition lift_forms (G fs : list (list R)) : list (list R) := lift G (hd [] fs) :: map (lift G) (tl fs).

Lemma dot_nth_lift G fs j d : Rows.dot (nth j (lift_forms G fs) []) d = Rows.dot (nth j fs []) (combination G d).
Proof.
  assert (M : forall j fs, Rows.dot (nth j (map (lift G) fs) []) d = Rows.dot (nth j fs []) (combination G d)).
  { intros i l. revert i. induction l as [|f l IH]; intros [|i]; cbn [map nth]; try reflexivity; [apply dot_lift|apply IH]. }
  destruct j as [|j]; cbn [nth lift_forms]; [rewrite dot_lift; now destruct fs|].
  rewrite M. destruct fs; cbn [tl nth]; [now destruct j|reflexivity].
Qed.

Definition lift_row (G : list (list R)) (r : Rows.row) : Rows.row :=
  Rows.Row (lift G (Rows.N r)) (map (lift G) (Rows.slips r)) (Rows.weights r) (Rows.rho r) (Rows.preload r)
    (Rows.growth r) (Rows.stiffness r) (Rows.spring r).

Lemma slip_lift G r d : Rows.slip (lift_row G r) d = Rows.slip r (combination G d).
Proof. unfold Rows.slip. cbn [Rows.slips lift_row]. rewrite map_map. apply map_ext. intros f. apply dot_lift. Qed.

Lemma v_lift G r d h l : Rows.v (lift_row G r) d h l = Rows.v r (combination G d) h l.
Proof. unfold Rows.v. cbn [Rows.N Rows.preload Rows.growth Rows.stiffness lift_row]. now rewrite dot_lift. Qed.

Lemma obeys_lift w G r d h l f : Rows.obeys w d h l (lift_row G r) f <-> Rows.obeys w (combination G d) h l r f.
Proof. destruct f as [a g]. unfold Rows.obeys. rewrite v_lift, slip_lift. reflexivity. Qed.

Lemma work_lift G r f y : Rows.work (lift_row G r) f y = Rows.work r f (combination G y).
Proof. unfold Rows.work. rewrite slip_lift. cbn [Rows.N lift_row]. now rewrite dot_lift. Qed.

(* What obeys at a motion is known by its products with forms. *)
Lemma obeys_same w r d e h l f : (forall a, Rows.dot a d = Rows.dot a e) ->
  Rows.obeys w d h l r f -> Rows.obeys w e h l r f.
Proof.
  destruct f as [a g]. intros E. unfold Rows.obeys, Rows.v, Rows.slip. rewrite E.
  now rewrite (map_ext (fun form => Rows.dot form d) (fun form => Rows.dot form e)) by exact E.
Qed.

Lemma work_same r f d e : (forall a, Rows.dot a d = Rows.dot a e) -> Rows.work r f d = Rows.work r f e.
Proof.
  intros E. unfold Rows.work, Rows.slip. rewrite E.
  now rewrite (map_ext (fun form => Rows.dot form d) (fun form => Rows.dot form e)) by exact E.
Qed.

(* ---- Motions are linear in the state ---- *)

Definition is_form (g : list R -> R) : Prop := exists a, forall d, g d = Rows.dot a d.

Definition unit_state (k : nat) : list R := repeat 0 k ++ [1].

Lemma dot_unit a k : Rows.dot a (unit_state k) = nth k a 0.
Proof.
  unfold unit_state. revert a. induction k as [|k IH]; intros [|x a]; cbn; try reflexivity.
  - rewrite dot_nil. ring.
  - rewrite IH. ring.
Qed.

Lemma form_by_units g D d : is_form g -> List.length d = D ->
  g d = Rows.dot (map (fun k => g (unit_state k)) (seq 0 D)) d.
Proof.
  intros [a E] L. rewrite E. rewrite (map_ext _ (fun k => nth k a 0)).
  - subst D. clear E g. revert d. induction a as [|x a IH]; intros d.
    + cbn. enough (Z : forall n s, Rows.dot (map (fun k => nth k [] 0) (seq s n)) d = 0) by (symmetry; apply Z).
      clear. revert d. intros d n. revert d. induction n as [|n IH]; intros [|y d] s; cbn; try reflexivity.
      rewrite IH. destruct s; ring.
    + destruct d as [|y d]; cbn; [reflexivity|]. rewrite <- seq_shift, map_map. cbn. now rewrite <- IH.
  - intros k. rewrite E. apply dot_unit.
Qed.

Lemma form_plus g g' : is_form g -> is_form g' -> is_form (fun d => g d + g' d).
Proof. intros [a E] [a' E']. exists (Rows.plus a a'). intros d. now rewrite Rows.dot_plus, E, E'. Qed.

Lemma form_times g c : is_form g -> is_form (fun d => g d * c).
Proof. intros [a E]. exists (Rows.scaled c a). intros d. rewrite Rows.dot_scaled, E. ring. Qed.

Lemma form_zero : is_form (fun _ => 0).
Proof. exists []. reflexivity. Qed.

Lemma form_same g g' : (forall d, g d = g' d) -> is_form g -> is_form g'.
Proof. intros E [a A]. exists a. intros d. now rewrite <- E. Qed.

Lemma dot_skipn f k d : Rows.dot (repeat 0 k ++ f) d = Rows.dot f (skipn k d).
Proof.
  revert d. induction k as [|k IH]; intros [|x d]; cbn; try reflexivity; [symmetry; apply dot_nil|].
  rewrite IH. ring.
Qed.

Lemma dot_firstn f n d : Rows.dot (firstn n f) d = Rows.dot f (firstn n d).
Proof.
  revert f d. induction n as [|n IH]; intros [|y f] [|x d]; cbn; try reflexivity. now rewrite IH.
Qed.

Definition linear_motions (before : list R -> list (list R)) : Prop :=
  exists n, forall i f, (forall d, List.length (before d) = n) /\ is_form (fun d => Rows.dot f (nth i (before d) [])).

Lemma linear_of_number before b f : linear_motions before ->
  is_form (fun d => Rows.dot f (BodiesModel.of_number (before d) b)).
Proof.
  intros [n H]. destruct b as [i|]; [apply H|]. cbn [BodiesModel.of_number].
  apply form_same with (fun _ => 0); [|apply form_zero]. intros d. symmetry. apply dot_nil.
Qed.

Lemma linear_motion n before b f : linear_motions before ->
  is_form (fun d => Rows.dot f (BodiesModel.motion_of_body n d (before d) b)).
Proof.
  intros H. destruct b as [first|on eta turns]; cbn [BodiesModel.motion_of_body].
  - exists (repeat 0 first ++ firstn n f). intros d. now rewrite dot_skipn, dot_firstn.
  - apply form_same with (fun d => Rows.dot f (BodiesModel.of_number (before d) on) + Rows.dot turns d * Rows.dot f eta).
    + intros d. now rewrite dot_plus_right, dot_scaled_right.
    + apply form_plus; [now apply linear_of_number|]. apply form_times. now exists turns.
Qed.

Lemma linear_after n bodies before : linear_motions before ->
  linear_motions (fun d => BodiesModel.motions n d bodies (before d)).
Proof.
  revert before. induction bodies as [|b bodies IH]; intros before H; cbn [BodiesModel.motions]; [exact H|].
  apply (IH (fun d => before d ++ [BodiesModel.motion_of_body n d (before d) b])).
  pose proof (fun f => linear_motion n before b f H) as New. destruct H as [k H]. exists (S k). intros i f. split.
  - intros d. rewrite app_length. cbn. destruct (H O []) as [L _]. rewrite L. lia.
  - destruct (H i f) as [L F]. destruct (Nat.lt_ge_cases i k) as [Lt|Ge].
    + apply form_same with (fun d => Rows.dot f (nth i (before d) [])); [|exact F].
      intros d. rewrite app_nth1; [reflexivity|]. now rewrite L.
    + destruct (Nat.eq_dec i k) as [->|Ne].
      * apply form_same with (fun d => Rows.dot f (BodiesModel.motion_of_body n d (before d) b)); [|apply New].
        intros d. rewrite app_nth2 by (rewrite L; lia). now rewrite L, Nat.sub_diag.
      * apply form_same with (fun _ => 0); [|apply form_zero]. intros d. rewrite nth_overflow; [symmetry; apply dot_nil|].
        rewrite app_length, L. cbn. lia.
Qed.

(* ---- The rows of a mechanism ---- *)

Section Mechanism.

Variable k : BodiesModel.kind.

(* What the rows of one body are. *)
Variable row_of : BodiesModel.contact k -> Rows.row.
Variable to_row : BodiesModel.contact k -> BodiesModel.force k -> Rows.force.
Variable of_row : BodiesModel.contact k -> Rows.force -> BodiesModel.force k.
Variable is_good : BodiesModel.contact k -> Prop.
Hypothesis obeys_to : forall l lambda d c f, is_good c -> BodiesModel.obeys k l lambda d c f ->
  Rows.obeys l d 1 lambda (row_of c) (to_row c f) /\ of_row c (to_row c f) = f.
Hypothesis obeys_of : forall l lambda d c f, is_good c -> Rows.obeys l d 1 lambda (row_of c) f ->
  BodiesModel.obeys k l lambda d c (of_row c f).
Hypothesis works_as : forall c f d, Rows.work (row_of c) f d = BodiesModel.works k c (of_row c f) d.

Variable m : BodiesModel.mechanism k.

Definition touch_row (t : BodiesModel.touch k) : Rows.row :=
  lift_row (map (fun q => BodiesModel.relative m (unit_state q) t) (seq 0 (BodiesModel.coordinates m)))
    (row_of (BodiesModel.touching t)).

Definition element_row (e : BodiesModel.element) : Rows.row :=
  Rows.Row (BodiesModel.lever e) [] [] 0 (BodiesModel.preload e) (BodiesModel.growth e) (BodiesModel.stiffness e)
    (BodiesModel.is_spring e).

Definition mechanism_rows : Rows.system :=
  Rows.System (BodiesModel.coordinates m)
    (map touch_row (BodiesModel.touches m) ++ map element_row (BodiesModel.elements m))
    (BodiesModel.wrench m) (BodiesModel.direction m) (BodiesModel.normal m).

Lemma relative_by_units t d : List.length d = BodiesModel.coordinates m -> forall f,
  Rows.dot f (BodiesModel.relative m d t) =
  Rows.dot f (combination (map (fun q => BodiesModel.relative m (unit_state q) t) (seq 0 (BodiesModel.coordinates m))) d).
Proof.
  intros L f. rewrite <- dot_lift. unfold lift. rewrite map_map.
  apply (form_by_units (fun d => Rows.dot f (BodiesModel.relative m d t))); [|exact L].
  unfold BodiesModel.relative.
  assert (Lin : linear_motions (fun d => BodiesModel.motions (BodiesModel.numbers k) d (BodiesModel.bodies m) [])).
  { apply linear_after. exists 0%nat. intros i g. split; [reflexivity|].
    apply form_same with (fun _ => 0); [|apply form_zero]. intros e. destruct i; symmetry; apply dot_nil. }
  eapply form_same; [intros e; symmetry; rewrite dot_plus_right, dot_scaled_right; reflexivity|].
  apply form_plus; [now apply (linear_of_number _ _ f Lin)|].
  eapply form_same; [intros e; apply Rmult_comm|]. apply form_times. now apply (linear_of_number _ _ f Lin).
Qed.

Lemma touch_obeys l lambda d t f : List.length d = BodiesModel.coordinates m ->
  Rows.obeys l d 1 lambda (touch_row t) f <->
  Rows.obeys l (BodiesModel.relative m d t) 1 lambda (row_of (BodiesModel.touching t)) f.
Proof.
  intros L. unfold touch_row. rewrite obeys_lift. pose proof (relative_by_units t d L) as E.
  split; apply obeys_same; intros a; now rewrite E.
Qed.

Lemma touch_works t f y : List.length y = BodiesModel.coordinates m ->
  Rows.work (touch_row t) f y =
  BodiesModel.works k (BodiesModel.touching t) (of_row (BodiesModel.touching t) f) (BodiesModel.relative m y t).
Proof.
  intros L. unfold touch_row. rewrite work_lift, <- works_as. apply work_same. intros a. symmetry.
  now apply relative_by_units.
Qed.

Lemma element_obeys l lambda d e a g : Rows.obeys l d 1 lambda (element_row e) (a, g) <->
  BodiesModel.pull_obeys l lambda d e a.
Proof.
  unfold Rows.obeys, BodiesModel.pull_obeys, Rows.normal_law, Rows.v, Rows.slip.
  cbn [element_row Rows.preload Rows.growth Rows.stiffness Rows.N Rows.spring Rows.rho Rows.weights Rows.slips map].
  replace (BodiesModel.preload e * 1 + BodiesModel.growth e * lambda - BodiesModel.stiffness e * Rows.dot (BodiesModel.lever e) d)
    with (BodiesModel.preload e + lambda * BodiesModel.growth e - BodiesModel.stiffness e * Rows.dot (BodiesModel.lever e) d)
    by ring.
  split; [tauto|]. intros H. split; [exact H|]. unfold Rows.size; cbn. rewrite sqrt_0. split; [lra|]. destruct g; cbn; lra.
Qed.

Definition touch_forces (ts : list (BodiesModel.touch k)) (fs : list Rows.force) : list (BodiesModel.force k) :=
  map (fun tf => of_row (BodiesModel.touching (fst tf)) (snd tf)) (List.combine ts fs).

Lemma works_app rs fs rs' fs' y : List.length rs = List.length fs ->
  Rows.works (rs ++ rs') (fs ++ fs') y = Rows.works rs fs y + Rows.works rs' fs' y.
Proof.
  revert fs. induction rs as [|r rs IH]; intros [|f fs] L; try discriminate; cbn [app Rows.works]; [ring|].
  injection L as L. rewrite IH by exact L. ring.
Qed.

Lemma works_of_touches ts fs y : List.length y = BodiesModel.coordinates m ->
  Rows.works (map touch_row ts) fs y =
  BodiesModel.sum (map (fun tf => BodiesModel.works k (BodiesModel.touching (fst tf)) (snd tf) (BodiesModel.relative m y (fst tf)))
    (List.combine ts (touch_forces ts fs))).
Proof.
  intros L. revert fs. induction ts as [|t ts IH]; intros [|f fs]; cbn; try reflexivity.
  rewrite touch_works by exact L. f_equal. apply IH.
Qed.

Lemma works_of_elements es fs y :
  Rows.works (map element_row es) fs y =
  BodiesModel.sum (map (fun ea => snd ea * Rows.dot (BodiesModel.lever (fst ea)) y) (List.combine es (map fst fs))).
Proof.
  revert fs. induction es as [|e es IH]; intros [|[a g] fs]; try reflexivity.
  cbn [map Rows.works List.combine]. rewrite IH. unfold BodiesModel.sum. cbn [fold_right fst snd].
  unfold Rows.work; cbn. ring.
Qed.

(* Rows see no more of a state than its D numbers. *)
Lemma cut_to n (a y : list R) : List.length a = n -> Rows.dot a y = Rows.dot a (firstn n (y ++ repeat 0 n)).
Proof.
  intros <-. revert y. induction a as [|x a IH]; intros [|z y]; cbn; try reflexivity.
  - rewrite <- (app_nil_l (repeat 0 (List.length a))). rewrite <- IH, dot_nil. ring.
  - replace (firstn (List.length a) (y ++ 0 :: repeat 0 (List.length a))) with
      (firstn (List.length a) (y ++ repeat 0 (List.length a))); [now rewrite <- IH|].
    rewrite !firstn_app. f_equal. set (n := List.length a). 
    assert (E : forall j n, (j <= n)%nat -> firstn j (repeat 0 n) = firstn j (0 :: repeat 0 n)).
    { clear. induction j as [|j IH]; intros n L; [reflexivity|]. destruct n as [|n]; [lia|]. cbn. f_equal.
      apply IH. lia. }
    apply E. lia.
Qed.

Theorem mechanism_rows_stable (allowed : list R -> Prop) lambda : BodiesModel.has_all_numbers m ->
  Forall (fun t => is_good (BodiesModel.touching t)) (BodiesModel.touches m) ->
  BodiesModel.stable_at allowed m lambda <-> Rows.stable_at allowed mechanism_rows lambda.
Proof.
  intros (Lw & Lu & Le) Good. split.
  - intros (d & forces & pulls & A & L & O & P & B).
    set (fs := map (fun tf => to_row (BodiesModel.touching (fst tf)) (snd tf)) (List.combine (BodiesModel.touches m) forces)).
    assert (Rows_obey : Forall2 (Rows.obeys (BodiesModel.normal m) d 1 lambda) (map touch_row (BodiesModel.touches m)) fs /\
      touch_forces (BodiesModel.touches m) fs = forces).
    { unfold fs, touch_forces. clear B fs. induction O as [|t f ts fs Ot O IH]; [split; [constructor|reflexivity]|].
      inversion_clear Good as [|? ? G Gs]. destruct (IH Gs) as [I1 I2]. destruct (obeys_to _ _ _ _ _ G Ot) as [O1 O2].
      cbn [map List.combine fst snd]. split; [|now rewrite O2, I2].
      constructor; [|exact I1]. apply touch_obeys; [exact L|exact O1]. }
    destruct Rows_obey as [Or Back]. exists d, (fs ++ map (fun a => (a, [])) pulls).
    split; [exact A|]. split; [exact L|]. cbn [Rows.rows Rows.normal mechanism_rows]. split.
    + apply Forall2_app; [exact Or|].
      clear B Le. induction P as [|e a es pulls Oe P IH]; cbn; constructor; [|exact IH]. now apply element_obeys.
    + intros y'. set (y := firstn (BodiesModel.coordinates m) (y' ++ repeat 0 (BodiesModel.coordinates m))).
      assert (Ly : List.length y = BodiesModel.coordinates m).
      { unfold y. rewrite firstn_length, app_length, repeat_length. lia. }
      assert (Sees : forall a, List.length a = BodiesModel.coordinates m -> Rows.dot a y' = Rows.dot a y)
        by (intros a La; now apply cut_to).
      assert (Row_sees : forall rs fs, Forall (fun r => List.length (Rows.N r) = BodiesModel.coordinates m /\
          Forall (fun f => List.length f = BodiesModel.coordinates m) (Rows.slips r)) rs ->
          Rows.works rs fs y' = Rows.works rs fs y).
      { induction rs as [|r rs IH]; intros [|f fs'] H; cbn; try reflexivity. inversion_clear H as [|? ? [H1 H2] H3].
        rewrite IH by exact H3. f_equal. unfold Rows.work. rewrite Sees by exact H1. f_equal. f_equal. unfold Rows.slip.
        apply map_ext_in. intros a Ha. apply Sees. rewrite Forall_forall in H2. now apply H2. }
      specialize (B y Ly). rewrite Row_sees.
      * unfold Rows.load. cbn [Rows.wrench Rows.direction mechanism_rows]. rewrite !Sees by assumption.
        rewrite works_app by exact (same_length _ _ _ Or).
        rewrite works_of_touches, works_of_elements by exact Ly. rewrite map_map. cbn [fst]. rewrite map_id, Back. lra.
      * apply Forall_app. split; apply Forall_map.
        -- apply Forall_forall. intros t _. cbn. unfold lift. rewrite !map_length, seq_length. split; [reflexivity|].
           apply Forall_map, Forall_forall. intros f _. now rewrite !map_length, seq_length.
        -- eapply Forall_impl; [|exact Le]. intros e H. cbn. split; [exact H|constructor].
  - intros (d & fs & A & L & O & B). cbn [Rows.rows Rows.normal Rows.dimension mechanism_rows] in *.
    apply Forall2_app_inv_l in O as (f1 & f2 & O1 & O2 & ->).
    exists d, (touch_forces (BodiesModel.touches m) f1), (map fst f2). split; [exact A|]. split; [exact L|]. split; [|split].
    + clear B. revert f1 O1. induction Good as [|t ts G Gs IH]; intros f1 O1; inversion O1; subst; cbn;
        constructor; [|now apply IH]. apply obeys_of; [exact G|]. now apply touch_obeys.
    + clear B Le. revert f2 O2. induction (BodiesModel.elements m) as [|e es IH]; intros f2 O2; inversion O2 as [|? [a g]]; subst; cbn;
        constructor; [|now apply IH]. now apply element_obeys with g.
    + intros y Ly. specialize (B y). unfold Rows.load in B. cbn [Rows.wrench Rows.direction mechanism_rows] in B.
      rewrite works_app in B by exact (same_length _ _ _ O1).
      rewrite works_of_touches, works_of_elements in B by exact Ly. lra.
Qed.

End Mechanism.

(* ---- In the plane and in space ---- *)

Definition plane_mechanism (m : BodiesModel.mechanism BodiesModel.in_plane) : Rows.system :=
  mechanism_rows BodiesModel.in_plane contact_row m.
Definition space_mechanism (m : BodiesModel.mechanism BodiesModel.in_space) : Rows.system :=
  mechanism_rows BodiesModel.in_space finger_row m.

Theorem plane_mechanism_stable (allowed : list R -> Prop) (m : BodiesModel.mechanism BodiesModel.in_plane) lambda : BodiesModel.has_all_numbers m ->
  BodiesModel.stable_at allowed m lambda <-> Rows.stable_at allowed (plane_mechanism m) lambda.
Proof.
  intros Nu. apply (mechanism_rows_stable BodiesModel.in_plane contact_row (fun _ => row_force)
    (fun _ f => (fst f, at_ (snd f) 0)) (fun _ => True)); try assumption;
    cbn [BodiesModel.obeys BodiesModel.works BodiesModel.in_plane].
  - intros l la d c [a b] _ H. split; [now apply obeys_as_row|reflexivity].
  - intros l la d c [a g] _ H. now apply obeys_is.
  - intros c [a g] d. apply work_is.
  - now apply Forall_forall.
Qed.

Theorem space_mechanism_stable (allowed : list R -> Prop) (m : BodiesModel.mechanism BodiesModel.in_space) lambda : BodiesModel.has_all_numbers m ->
  Forall (fun t : BodiesModel.touch BodiesModel.in_space => is_finger (BodiesModel.touching t)) (BodiesModel.touches m) ->
  BodiesModel.stable_at allowed m lambda <-> Rows.stable_at allowed (space_mechanism m) lambda.
Proof.
  intros Nu Fi. apply (mechanism_rows_stable BodiesModel.in_space finger_row finger_to_row finger_of_row is_finger);
    try assumption; cbn [BodiesModel.obeys BodiesModel.works BodiesModel.in_space].
  - intros l la d t f G H. now apply finger_to.
  - intros l la d t f G H. now apply finger_of.
  - intros t f d. apply finger_works_as.
Qed.

(* ---- In boxes ---- *)

Lemma dot_q_real a b : Q2R (dot_q a b) = Rows.dot (real a) (real b).
Proof.
  revert b. induction a as [|x a IH]; intros [|y b]; cbn; try apply Q2R_0. now rewrite Q2R_plus, Q2R_mult, IH.
Qed.

Lemma lift_q_real G f : real (lift_q G f) = lift (map real G) (real f).
Proof.
  unfold lift_q, lift. rewrite !map_map. apply map_ext. intros g. now rewrite reduced_same, dot_q_real.
Qed.

Lemma lifted_lengths G (fs fs' : list (list R)) : List.length fs = List.length fs' ->
  map (@List.length R) (map (lift G) fs) = map (@List.length R) (map (lift G) fs').
Proof.
  revert fs'. induction fs as [|f fs IH]; intros [|f' fs'] L; try discriminate; cbn [map]; [reflexivity|].
  injection L as L. rewrite (IH _ L). unfold lift. now rewrite !map_length.
Qed.

Lemma lift_shape G (fs fs' : list (list R)) : List.length fs = List.length fs' ->
  map (@List.length R) (lift_forms G fs) = map (@List.length R) (lift_forms G fs').
Proof.
  intros L. unfold lift_forms. cbn [map]. f_equal; [unfold lift; now rewrite !map_length|].
  apply lifted_lengths. destruct fs, fs'; try discriminate; [reflexivity|]. now injection L.
Qed.

Lemma lift_forms_real G fs : map real (lift_forms_q G fs) = lift_forms (map real G) (map real fs).
Proof.
  unfold lift_forms_q, lift_forms. cbn [map]. rewrite lift_q_real. f_equal; [now destruct fs|].
  rewrite map_map. destruct fs as [|f fs]; [reflexivity|]. cbn [tl map]. rewrite map_map. apply map_ext. intros g. apply lift_q_real.
Qed.

Lemma lift_inside G b r p F mu t : inside_at b r p F mu t ->
  inside_at (lift_box G b) (lift_row (map real G) r) p (fun p => lift_forms (map real G) (F p)) mu t.
Proof.
  intros I. constructor; cbn [box_geometry box_forms box_friction box_square box_weights box_preload box_growth
      box_stiffness box_spring box_signed box_turns box_slack lift_box Rows.N Rows.slips Rows.rho Rows.weights
      Rows.preload Rows.growth Rows.stiffness Rows.spring lift_row]; try apply I.
  - rewrite <- (is_forms _ _ _ _ _ _ I). reflexivity.
  - intros qs. now rewrite (forms_rational _ _ _ _ _ _ I), lift_forms_real.
  - intros j d. eapply multiaffine_same; [|apply (forms_affine _ _ _ _ _ _ I j (combination (map real G) d))].
    intros q _. symmetry. apply dot_nth_lift.
  - intros q q' L L'. apply lift_shape. pose proof (forms_shape _ _ _ _ _ _ I q q' L L') as S.
    apply (f_equal (@List.length _)) in S. now rewrite !map_length in S.
  - intros Sp. now rewrite (spring_alone _ _ _ _ _ _ I Sp).
  - intros Sg. destruct (is_signed _ _ _ _ _ _ I Sg) as ([E|[T E]] & W & Q1); rewrite W, E; cbn;
      (split; [|split; [reflexivity|exact Q1]]); [now left|right; now eexists].
Qed.

Lemma lift_stands n r r' G : stands n r r' -> stands n (lift_row G r) (lift_row G r').
Proof.
  intros St. constructor; cbn [lift_row Rows.N Rows.slips Rows.rho Rows.preload Rows.growth Rows.stiffness Rows.spring
    Rows.weights]; try apply St.
  - now rewrite (same_N _ _ _ St).
  - apply lifted_lengths. pose proof (same_shape _ _ _ St) as S. apply (f_equal (@List.length _)) in S. now rewrite !map_length in S.
  - intros w d h l a g y Ob A. apply obeys_lift in Ob. pose proof (rubs _ _ _ St w _ h l a g (combination G y) Ob A) as Ru.
    unfold work_within in *. rewrite !slip_lift. exact Ru.
  - intros w d h l a g Ob A. apply obeys_lift in Ob. rewrite !slip_lift. exact (brakes _ _ _ St w _ h l a g Ob A).
  - intros a g' C. destruct (holds _ _ _ St a g' C) as (g & C' & E). exists g. split; [exact C'|].
    intros y. rewrite !slip_lift. apply E.
  - intros d. rewrite !slip_lift. apply (slides _ _ _ St).
Qed.

Lemma nth_lift G x j : nth j (lift G x) 0 = Rows.dot x (nth j G []).
Proof. unfold lift. rewrite <- (dot_nil x) at 1. apply map_nth. Qed.

Lemma cv_lift (G : list (list R)) us x : RowLimits.cv_list us x -> RowLimits.cv_list (fun i => lift G (us i)) (lift G x).
Proof.
  intros C. apply (cv_list_by_numbers (List.length G)); [intros i; unfold lift; apply map_length|apply map_length|].
  intros j L. rewrite nth_lift. eapply Homotopy.cv_same; [intros k; apply nth_lift|].
  apply RowLimits.cv_dot; [exact C|apply RowLimits.cv_list_constant].
Qed.

Lemma cv_lift_all (G : list (list R)) us x : RowLimits.cv_lists us x ->
  RowLimits.cv_lists (fun i => map (lift G) (us i)) (map (lift G) x).
Proof.
  induction 1 as [|u y us ys Cu C IH]; cbn [map]; [constructor|].
  apply (RowLimits.cv_lists_cons (fun i => lift G (u i))); [now apply cv_lift|exact IH].
Qed.

Lemma cv_lift_forms (G : list (list R)) us x : RowLimits.cv_lists us x ->
  RowLimits.cv_lists (fun i => lift_forms G (us i)) (lift_forms G x).
Proof.
  intros C. apply (RowLimits.cv_lists_cons (fun i => lift G (hd [] (us i)))).
  - apply cv_lift. now apply cv_lists_head.
  - apply cv_lift_all. now apply cv_lists_tail.
Qed.

Theorem lift_seen G b r : seen_in b r -> seen_in (lift_box G b) (lift_row (map real G) r).
Proof.
  intros (r' & p & F & mu & t & H & len & n & I & [Sd Ln Sl Ct St] & ->). set (Gr := map real G).
  exists (lift_row Gr r'), p, (fun p => lift_forms Gr (F p)), mu, t, (fun p => lift_forms Gr (H p)), len, n.
  split; [now apply lift_inside|]. split; [|reflexivity]. constructor; try assumption.
  - intros q m P u s L M. exact (lift_stands _ _ _ Gr (Sd q m P u s L M)).
  - intros qs q L C. destruct (Ct qs q L C) as [C1 C2]. split; [now apply cv_lift_forms|exact C2].
  - intros T q L. destruct (St T q L) as [E1 E2]. now rewrite E1.
Qed.

Lemma add_multiple_real a s b : real (add_multiple a s b) = Rows.plus (real a) (Rows.scaled (Q2R s) (real b)).
Proof.
  assert (S : forall b, real (map (Qmult s) b) = Rows.scaled (Q2R s) (real b)).
  { intros l. unfold Rows.scaled. rewrite !map_map. apply map_ext. intros x. apply Q2R_mult. }
  revert b. induction a as [|x a IH]; intros [|y b].
  - reflexivity.
  - exact (S (y :: b)).
  - reflexivity.
  - unfold Rows.scaled in *. cbn [add_multiple map Rows.plus]. now rewrite Q2R_plus, Q2R_mult, IH.
Qed.

Lemma of_number_real ms b : real (of_number_q ms b) = BodiesModel.of_number (map real ms) b.
Proof. destruct b as [i|]; cbn; [|reflexivity]. symmetry. apply (map_nth real ms [] i). Qed.

Lemma motions_real n d bs before : map real (motions_q n d bs before) =
  BodiesModel.motions n (real d) (map real_body bs) (map real before).
Proof.
  revert before. induction bs as [|b bs IH]; intros before; cbn [motions_q map BodiesModel.motions]; [reflexivity|].
  rewrite IH, map_app. cbn [map]. f_equal. f_equal. f_equal. rewrite map_map.
  rewrite (map_ext (fun x => Q2R (reduced x)) Q2R) by apply reduced_same.
  destruct b as [first|on eta turns]; cbn [motion_of_body_q real_body BodiesModel.motion_of_body].
  - now rewrite <- firstn_map, skipn_map.
  - now rewrite add_multiple_real, of_number_real, dot_q_real.
Qed.

Lemma unit_real k : real (unit_q k) = unit_state k.
Proof.
  unfold unit_q, unit_state. rewrite map_app. cbn. rewrite Q2R_1. f_equal.
  induction k as [|k IH]; cbn; [reflexivity|]. now rewrite IH, Q2R_0.
Qed.

Lemma element_seen e (e' : BodiesModel.element) : chosen_element e e' -> seen_in (element_box e) (element_row e').
Proof.
  intros (Lv & Sp & Wk & Wp & G). apply inside_seen.
  destruct (step_between _ _ _ Wp) as (t & T & EP).
  exists [], (fun _ => [BodiesModel.lever e']), 0, t.
  constructor; cbn [box_geometry box_forms box_friction box_square box_weights box_preload box_growth
      box_stiffness box_spring box_signed box_turns box_slack element_box Rows.N Rows.slips Rows.rho Rows.weights
      Rows.preload Rows.growth Rows.stiffness Rows.spring element_row map]; try assumption; try reflexivity; try discriminate.
  - constructor.
  - intros _. now rewrite Lv.
  - unfold within, exactly; cbn. rewrite Q2R_0. lra.
  - lra.
  - ring.
  - rewrite Q2R_1. lra.
  - constructor.
  - rewrite G. unfold exactly; cbn. ring.
  - intros _. cbn. rewrite Q2R_0. lra.
  - intros _. split; [now left|]. split; [reflexivity|apply Q2R_1].
Qed.

Lemma columns_real k (m : BodiesModel.mechanism k) D its c t : BodiesModel.numbers k = numbers_of its ->
  BodiesModel.bodies m = map real_body (bodies its) ->
  BodiesModel.of_body t = of_body c -> BodiesModel.by_body t = by_body c ->
  map real (columns (unit_motions D its) c) = map (fun q => BodiesModel.relative m (unit_state q) t) (seq 0 D).
Proof.
  intros En Eb Eo Ey. unfold columns, unit_motions. rewrite !map_map. apply map_ext. intros q.
  unfold BodiesModel.relative. rewrite add_multiple_real, !of_number_real, motions_real, unit_real, En, Eb, Eo, Ey.
  cbn [map]. do 2 f_equal. unfold Q2R; cbn. lra.
Qed.

Theorem touch_seen k (row_of : BodiesModel.contact k -> Rows.row) (m : BodiesModel.mechanism k) its c t b :
  BodiesModel.numbers k = numbers_of its -> BodiesModel.bodies m = map real_body (bodies its) ->
  BodiesModel.of_body t = of_body c -> BodiesModel.by_body t = by_body c ->
  seen_in b (row_of (BodiesModel.touching t)) ->
  seen_in (lift_box (columns (unit_motions (BodiesModel.coordinates m) its) c) b) (touch_row k row_of m t).
Proof. intros En Eb Eo Ey H. unfold touch_row. rewrite <- (columns_real k m _ its c t) by assumption. now apply lift_seen. Qed.

Theorem mechanism_seen k (row_of : BodiesModel.contact k -> Rows.row)
    (chosen_contact : contact -> BodiesModel.contact k -> Prop) bits q its m boxes :
  BodiesModel.numbers k = numbers_of its ->
  (forall c c' b, chosen_contact c c' -> enlarge_finger bits c = Some b -> seen_in b (row_of c')) ->
  chosen_bodies chosen_contact q its m -> mechanism_boxes bits (dimension q) its (contacts q) = Some boxes ->
  Forall2 seen_in boxes (Rows.rows (mechanism_rows k row_of m)).
Proof.
  intros En Seen (_ & D & _ & Eb & T & E & _) H. unfold mechanism_boxes in H. rewrite <- D in H.
  destruct (all_some _ (contacts q)) as [bs|] eqn:A; [|discriminate]. injection H as <-. cbn [Rows.rows mechanism_rows].
  apply Forall2_app.
  - apply all_some_is in A. revert T. generalize (BodiesModel.touches m). induction A as [|c b cs bs Ec A IH];
      intros ts T; inversion T as [|? t ? ts' (Ch & Eo & Ey) T']; subst; cbn; constructor; [|now apply IH].
    destruct (enlarge_finger bits c) as [b'|] eqn:B; [|discriminate]. injection Ec as <-.
    apply touch_seen; try assumption. now apply (Seen c).
  - clear - E. induction E as [|e e' es es' Ch E IH]; cbn; constructor; [now apply element_seen|exact IH].
Qed.

Lemma mechanism_shapes k row_of m : BodiesModel.has_all_numbers m ->
  (forall c, List.length (Rows.weights (row_of c)) = List.length (Rows.slips (row_of c))) ->
  Forall (fun r => List.length (Rows.N r) = BodiesModel.coordinates m /\
            Forall (fun f => List.length f = BodiesModel.coordinates m) (Rows.slips r) /\
            List.length (Rows.weights r) = List.length (Rows.slips r)) (Rows.rows (mechanism_rows k row_of m)).
Proof.
  intros (_ & _ & Le) W. apply Forall_app. split; apply Forall_map.
  - apply Forall_forall. intros t _. cbn. unfold lift. rewrite !map_length, seq_length. split; [reflexivity|].
    split; [|apply W]. apply Forall_map, Forall_forall. intros f _. now rewrite !map_length, seq_length.
  - eapply Forall_impl; [|exact Le]. intros e H. cbn. repeat split; [exact H|constructor].
Qed.

End Proofs.
