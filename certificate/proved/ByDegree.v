(* SPDX-License-Identifier: MIT *)
(* Stable by degree (FORMAT.md section 6): the rules, for the box of a setting and a range of multiples.
   `stable_by_degree_in_box`: where they hold, every system in the box is stable at every multiple. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Walk Tree.
From Proved Require Import Brouwer RowLimits Degree Matrix Frame Between Ways Load Bound.
From Proved Require Rows Model.
Import ListNotations.

(* All but the trees: from alpha to beta, or to infinity. *)
Record degree_proof := DegreeProof {
  low_multiple : Q; high_multiple : option Q;
  first_twist : vector; last_twist : vector;        (* d', d'' *)
  is_a_simplex : bool; wall_rows : matrix;          (* E *)
  direction_rows : matrix                           (* A *)
}.

Section Rules.
Open Scope Q_scope.

Variable g : degree_proof.

Definition one_multiple : bool :=
  match high_multiple g with Some b => Qeq_bool (low_multiple g) b | None => false end.

(* s and t, by their numbers of h and l. *)
Definition s_and_t : vector * vector :=
  let a := low_multiple g in
  if one_multiple then ([1; 0], [0; 0])
  else
    match high_multiple g with
    | Some b => ([b / (b - a); - / (b - a)], [- a / (b - a); / (b - a)])
    | None => ([1; 0], [-1; / a])
    end.

(* f.e at the point (h, l, d), where e = d - s d' - t d''. *)
Definition relative (f : vector) : vector :=
  plus_times (plus_times [] (- inner f (first_twist g)) (fst s_and_t)) (- inner f (last_twist g)) (snd s_and_t)
    ++ f.

(* s + t - f.e *)
Definition room (f : vector) : vector :=
  plus_times (plus_times (fst s_and_t) 1 (snd s_and_t)) (-1) (relative f).

(* In integers, by a factor above 0. *)
Definition to_form (a : vector) : form := map (to_integer (scaling_of a)) a.

(* s >= 0 and t >= 0; if there is one multiple, it is l / h. *)
Definition base_conditions : list (form * bool) :=
  (to_form (fst s_and_t), false) :: (to_form (snd s_and_t), false) ::
  if one_multiple then [(to_form [- low_multiple g; 1], true)] else [].

Definition walls : matrix := walls_of (is_a_simplex g) (wall_rows g).

(* s + t >= F_j.e for all walls. *)
Definition in_K_conditions : list (form * bool) := map (fun f => (to_form (room f), false)) walls.

(* s + t is not 0 *)
Definition strict_form : form := to_form (plus_times (fst s_and_t) 1 (snd s_and_t)).

(* The middle of the box, pushed by multiples of A e. *)
Definition middle_setting (s : setting) : setting :=
  make_setting (dimension_of s) (map_all (fun r => make_row (middle_box (box r))) (rows s))
    (middle_load (the_load s))
    (Pushing (map relative (direction_rows g)) []) None.

(* s = t. *)
Definition middle_conditions : list (form * bool) :=
  if one_multiple then [] else [(to_form (plus_times (fst s_and_t) (-1) (snd s_and_t)), true)].

(* Whether a box is one point. *)
Definition point_box (b : cbox) : bool :=
  forallb certain (box_geometry b) && certain (box_friction b) && certain (box_preload b) && certain
    (box_growth b) &&
  certain (box_stiffness b).

Definition is_point (s : setting) : bool :=
  forallb (fun r => point_box (box r)) (rows s) && one_load (the_load s).

(* No force of a contact depends on z, or does work on it. *)
Definition row_free (z : vector) (b : cbox) : bool :=
  forallb (fun fs =>
    is_zero (inner (N_of fs) z) &&
    (Qle_bool (high (box_friction b)) 0 || forallb (fun f => is_zero (inner f z)) (tl fs)))
    (tips (geometry_tree b)).

(* No load does work on z. *)
Definition load_free (z : vector) (ld : load) : bool :=
  is_zero (low (work_of ld z)) && is_zero (high (work_of ld z)) && is_zero (inner (load_growth ld) z).

(* degree-free; and what a question guarantees of friction. *)
Definition all_free (free : matrix) (s : setting) : bool :=
  forallb (fun r => friction_sound (box r)) (rows s) &&
  forallb (fun z =>
    forallb (fun r => row_free z (box r)) (rows s) && load_free z (the_load s)) free.

(* degree-bound *)
Definition bound_holds (free : matrix) (s : setting) : bool :=
  match the_bound s, high_multiple g with
  | None, _ => true
  | Some _, None => false
  | Some most, Some _ =>
      K_within (dimension_of s) (is_a_simplex g) (wall_rows g) free most [first_twist g; last_twist g]
  end.

(* Beginnings and ends that are there. *)
Definition range_sound (s : setting) : bool :=
  let n := dimension_of s in
  Nat.eqb (List.length (first_twist g)) n && Nat.eqb (List.length (last_twist g)) n &&
  Qle_bool 0 (low_multiple g) &&
  match high_multiple g with
  | Some b => Qle_bool (low_multiple g) b
  | None => negb (Qle_bool (low_multiple g) 0)
  end.

End Rules.

Section Checking.
Variable advisor : oracle.

(* K, with further conditions; and its walls. *)
Definition k_region (g : degree_proof) (s : setting) (more : list (form * bool)) : region setting :=
  root advisor setting (2 + dimension_of s) (Branch (base_conditions g ++ more ++ in_K_conditions g) []
    [] s).

Definition wall_regions (g : degree_proof) (s : setting) (more : list (form * bool)) : list (region setting) :=
  let k := k_region g s more in
  map (fun f => child advisor setting k (Branch [(to_form (room g f), true)] [strict_form g] [] s))
    (walls g).

(* List 1 and list 2. *)
Definition root_regions (g : degree_proof) (s : setting) : list (region setting) :=
  (if is_point s && one_multiple g then [] else wall_regions g (without_bound s) []) ++
  wall_regions g (middle_setting g s) (middle_conditions g).

(* Under the bilateral law: no contact but a spring pulls in K. *)
Definition law_holds (g : degree_proof) (s : setting) : bool :=
  let r := k_region g s [] in
  forallb (fun row => box_spring (box row) || forallb (nowhere_negative (rays setting r)) (pull_tips
    row)) (rows s).

(* The rule that fails; and at which node, if it is about one. *)
Definition degree_fails (two_sided : bool) (most_depth : Z) (s : setting) (g : degree_proof) (nodes : list node)
    : option (string * option nat) :=
  let n := dimension_of s in
  match free_motions n (is_a_simplex g) (wall_rows g) with
  | None => Some ("degree-walls"%string, None)
  | Some free =>
      if negb (range_sound g s && all_free free s) then Some ("degree-free"%string, None)
      else
        match inverted n free (direction_rows g) with
        | None => Some ("degree-direction"%string, None)
        | Some _ =>
            if negb (bound_holds g free s) then Some ("degree-bound"%string, None)
            else if two_sided && negb (law_holds g s) then Some ("degree-law"%string, None)
            else
              match walk advisor setting split (end_fails no_pieces) most_depth nodes
                      (root_regions g s) 0 with
              | None => None
              | Some (rule, number) => Some (rule, Some number)
              end
        end
  end.

End Checking.

(* ---- Proofs ---- *)

Section Forms.
Open Scope R_scope.

Lemma qdot_real a x : qdot a x = Rows.dot (real a) x.
Proof. apply qdot_is. Qed.

Lemma to_form_is a x : Rows.dot (real a) x = unit (scaling_of a) * rdot (to_form a) x.
Proof. rewrite <- qdot_real. apply qdot_to_integers. auto. Qed.

Lemma to_form_nonneg a x : 0 <= Rows.dot (real a) x -> 0 <= rdot (to_form a) x.
Proof. rewrite to_form_is. pose proof (unit_positive a) as U. intros H. apply Rnot_lt_le. intros L. nra. Qed.

Lemma to_form_zero a x : Rows.dot (real a) x = 0 -> rdot (to_form a) x = 0.
Proof. rewrite to_form_is. pose proof (unit_positive a) as U. intros H. apply Rmult_integral in H as [H|H];
  lra. Qed.

Lemma to_form_not_zero a x : Rows.dot (real a) x <> 0 -> rdot (to_form a) x <> 0.
Proof. rewrite to_form_is. intros H E. rewrite E in H. apply H. ring. Qed.

Variable g : degree_proof.

(* At the part t of the range, with h and l, and e from the motion there. *)
Definition h_at (t : R) : R := match high_multiple g with Some _ => 1 | None => 1 - t end.
Definition l_at (t : R) : R :=
  match high_multiple g with Some b => mix t (Q2R (low_multiple g)) (Q2R b) | None => Q2R (low_multiple g) end.
Definition twist_at (t : R) : list R := mixed t (real (first_twist g)) (real (last_twist g)).

Definition s_at (h l : R) : R := Rows.dot (real (fst (s_and_t g))) [h; l].
Definition t_at (h l : R) : R := Rows.dot (real (snd (s_and_t g))) [h; l].

(* The beginning and the end are as they should be, and t is 0 where they are one. *)
Definition good_range := 0 <= Q2R (low_multiple g) /\
  match high_multiple g with Some b => Q2R (low_multiple g) <= Q2R b | None => 0 < Q2R (low_multiple g) end.
Definition good_part (t : R) := 0 <= t <= 1 /\ (one_multiple g = true -> t = 0).

(* s and t are the shares of the beginning and the end. *)
Lemma parts_at t : good_range -> good_part t ->
  s_at (h_at t) (l_at t) = 1 - t /\ t_at (h_at t) (l_at t) = t /\
  (one_multiple g = true -> l_at t = Q2R (low_multiple g) * h_at t).
Proof.
  intros [A0 R] [T Z]. unfold s_at, t_at, s_and_t, h_at, l_at, one_multiple in *.
  destruct (high_multiple g) as [b|].
  - destruct (Qeq_bool (low_multiple g) b) eqn:E.
    + rewrite (Z eq_refl). cbn. rewrite Q2R_0, Q2R_1. unfold mix. repeat split; intros; ring.
    + assert (NE : Q2R b - Q2R (low_multiple g) <> 0).
      { intros H. assert (Q2R (low_multiple g) = Q2R b) by lra. apply eqR_Qeq, Qeq_eq_bool in H0. congruence. }
      assert (NQ : ~ (b - low_multiple g == 0)%Q).
      { intros H. apply Qeq_eqR in H. rewrite Q2R_minus, Q2R_0 in H. lra. }
      cbn -[Q2R]. rewrite !Q2R_div, !Q2R_opp, !Q2R_inv, !Q2R_minus by exact NQ. unfold mix.
      repeat split; try discriminate; field; exact NE.
  - cbn -[Q2R]. rewrite Q2R_1, Q2R_0. assert (NQ : ~ (low_multiple g == 0)%Q).
    { intros H. apply Qeq_eqR in H. rewrite Q2R_0 in H. lra. }
    rewrite Q2R_inv by exact NQ. replace (Q2R (-1)) with (-1) by (unfold Q2R; cbn; lra).
    repeat split; try discriminate; field; lra.
Qed.

Lemma s_and_t_length : List.length (fst (s_and_t g)) = 2%nat /\ List.length (snd (s_and_t g)) = 2%nat.
Proof. unfold s_and_t. destruct (one_multiple g); [|destruct (high_multiple g)]; auto. Qed.

Lemma dot_two a h l d : List.length a = 2%nat -> Rows.dot (real a) (h :: l :: d) = Rows.dot (real a) [h; l].
Proof. destruct a as [|x [|y [|? ?]]]; try discriminate. intros _. reflexivity. Qed.

Lemma plus_times_length a s b : List.length (plus_times a s b) = max (List.length a) (List.length b).
Proof.
  revert b. induction a as [|x a IH]; intros [|y b]; cbn; try reflexivity; [now rewrite map_length|]. now
    rewrite IH.
Qed.

Lemma dot_app a b x y : List.length a = List.length x -> Rows.dot (a ++ b) (x ++ y) = Rows.dot a x + Rows.dot b y.
Proof.
  revert x. induction a as [|p a IH]; intros [|q x] L; try discriminate; cbn; [ring|]. rewrite IH by now
    injection L. ring.
Qed.

(* What `relative` says. *)
Lemma relative_is f h l d :
  Rows.dot (real (relative g f)) (h :: l :: d) =
  Rows.dot (real f) d - s_at h l * Rows.dot (real f) (real (first_twist g)) -
    t_at h l * Rows.dot (real f) (real (last_twist g)).
Proof.
  unfold relative. destruct s_and_t_length as [L1 L2]. set (a := plus_times _ _ _).
  assert (La : List.length a = 2%nat) by (unfold a; rewrite !plus_times_length, L1, L2; reflexivity).
  unfold real at 1. rewrite map_app. change (h :: l :: d) with ([h; l] ++ d).
  rewrite dot_app by (rewrite map_length, La; reflexivity). fold (real a). fold (real f).
  unfold a. rewrite !dot_plus_times, !Q2R_opp, !inner_is. fold (s_at h l) (t_at h l). cbn [real map Rows.dot]. ring.
Qed.

(* e as a motion *)
Lemma relative_at t e f n : good_range -> good_part t -> List.length f = n ->
  List.length (first_twist g) = n -> List.length (last_twist g) = n ->
  Rows.dot (real (relative g f)) (h_at t :: l_at t :: listed n (fun i => nth i (twist_at t) 0 + e i)) =
  Rows.dot (real f) (listed n e).
Proof.
  intros R T Lf L1 L2. destruct (parts_at t R T) as (E1 & E2 & _). rewrite relative_is, E1, E2. unfold twist_at.
  assert (G : forall n a b c e, List.length a = n -> List.length b = n -> List.length c = n ->
    Rows.dot c (listed n (fun i => nth i (mixed t a b) 0 + e i)) =
    (1 - t) * Rows.dot c a + t * Rows.dot c b + Rows.dot c (listed n e)).
  { clear. induction n as [|n IH]; intros [|x a] [|y b] [|z c] e La Lb Lc; try discriminate; cbn; [ring|].
    injection La as La. injection Lb as Lb. injection Lc as Lc.
    rewrite (IH a b c (fun i => e (S i)) La Lb Lc). unfold mix. ring. }
  rewrite G by (unfold real; rewrite map_length; assumption). ring.
Qed.

(* What `room` says: how far e is from a wall. *)
Lemma room_at t e f n : good_range -> good_part t -> List.length f = n ->
  List.length (first_twist g) = n -> List.length (last_twist g) = n ->
  Rows.dot (real (room g f)) (h_at t :: l_at t :: listed n (fun i => nth i (twist_at t) 0 + e i)) =
  1 - Rows.dot (real f) (listed n e).
Proof.
  intros R T Lf L1 L2. unfold room. destruct s_and_t_length as [S1 S2]. destruct (parts_at t R T) as (E1 & E2 & _).
  rewrite !dot_plus_times, relative_at by assumption. rewrite (dot_two (fst (s_and_t g))), (dot_two (snd
    (s_and_t g))) by assumption.
  unfold s_at, t_at in E1, E2. rewrite E1, E2, Q2R_1. replace (Q2R (-1)) with (-1) by (unfold Q2R; cbn; lra). ring.
Qed.

End Forms.

(* ---- The trees ---- *)

Section Trees.
Open Scope R_scope.

Variable g : degree_proof.
Variable n : nat.
Hypothesis first_length : List.length (first_twist g) = n.
Hypothesis last_length : List.length (last_twist g) = n.
Hypothesis range_good : good_range g.

Notation point t e := (h_at g t :: l_at g t :: listed n (fun i => nth i (twist_at g t) 0 + e i)).

(* All points of the range meet the conditions of roots, *)
Lemma base_met t e : good_part g t -> Forall (meets (point t e)) (base_conditions g).
Proof.
  intros T. destruct (parts_at g t range_good T) as (E1 & E2 & E3). destruct (s_and_t_length g) as [S1 S2].
  destruct T as [T Z]. unfold base_conditions.
  constructor; [|constructor].
  - unfold meets; cbn [fst snd]. apply to_form_nonneg. rewrite dot_two by exact S1. unfold s_at in E1. rewrite
      E1. lra.
  - unfold meets; cbn [fst snd]. apply to_form_nonneg. rewrite dot_two by exact S2. unfold t_at in E2. rewrite
      E2. lra.
  - destruct (one_multiple g); constructor; [|constructor]. unfold meets; cbn [fst snd]. apply to_form_zero.
    cbn [real map Rows.dot]. rewrite Q2R_opp, Q2R_1, (E3 eq_refl). ring.
Qed.

(* those in K the conditions of K, *)
Lemma in_K_met t e fs : good_part g t -> Forall (fun f => List.length f = n) fs ->
  Forall (fun f => Rows.dot (real f) (listed n e) <= 1) fs ->
  Forall (meets (point t e)) (map (fun f => (to_form (room g f), false)) fs).
Proof.
  intros T L K. apply Forall_map. rewrite Forall_forall in *. intros f Hf. unfold meets; cbn [fst snd].
  apply to_form_nonneg. rewrite room_at by auto. specialize (K f Hf). cbn in K. lra.
Qed.

Variable advisor : oracle.

(* and so are at home in its region; *)
Lemma k_home (solves : setting -> list R -> Prop) more s t e : good_part g t -> dimension_of s = n ->
  Forall (fun f => List.length f = n) (walls g) ->
  solves s (point t e) -> Forall (meets (point t e)) more ->
  Forall (fun f => Rows.dot (real f) (listed n e) <= 1) (walls g) ->
  at_home setting solves (k_region advisor g s more) (point t e).
Proof.
  intros T D L S M K. unfold k_region. rewrite D. apply root_home; [cbn; now rewrite length_listed|].
  constructor; cbn [branch_setting conditions new_strict new_moving]; [exact S| |constructor|constructor].
  apply Forall_app. split; [now apply base_met|]. apply Forall_app. split; [exact M|]. now apply in_K_met.
Qed.

(* and a point on a wall is at home in the region of a wall. *)
Lemma wall_home (solves : setting -> list R -> Prop) more s t e : good_part g t -> dimension_of s = n ->
  Forall (fun f => List.length f = n) (walls g) ->
  solves s (point t e) -> Forall (meets (point t e)) more ->
  Forall (fun f => Rows.dot (real f) (listed n e) <= 1) (walls g) ->
  Exists (fun f => Rows.dot (real f) (listed n e) = 1) (walls g) ->
  exists r, In r (wall_regions advisor g s more) /\ at_home setting solves r (point t e).
Proof.
  intros T D L S M K Ex. apply Exists_exists in Ex as (f & Hf & E). rewrite Forall_forall in L.
  eexists. split; [apply in_map, Hf|]. apply child_home; [apply k_home; try assumption; now apply Forall_forall|].
  constructor; cbn [branch_setting conditions new_strict new_moving]; [exact S| | |constructor].
  - constructor; [|constructor]. unfold meets; cbn [fst snd]. apply to_form_zero. rewrite room_at by auto. lra.
  - constructor; [|constructor]. unfold strict_form. apply to_form_not_zero.
    destruct (parts_at g t range_good T) as (E1 & E2 & _). destruct (s_and_t_length g) as [S1 S2].
    rewrite dot_plus_times, (dot_two (fst (s_and_t g))), (dot_two (snd (s_and_t g))) by assumption.
    unfold s_at, t_at in E1, E2. rewrite E1, E2, Q2R_1. lra.
Qed.

Lemma walls_good more s : Forall (good setting) (wall_regions advisor g s more).
Proof. apply Forall_map, Forall_forall. intros f _. apply child_good, root_good. Qed.

End Trees.

(* ---- The ways of rows ---- *)

Section Ways.
Open Scope R_scope.

Variable D : nat.

(* A way of one row of the setting. *)
Record is_way (row : row) (way : R -> Rows.row) : Prop := IsWay {
  from_middle : seen_in (middle_box (box row)) (way 0);
  way_inside : forall s, 0 <= s <= 1 -> seen_in (box row) (way s);
  way_proper : forall s, 0 <= s <= 1 -> proper D (way s);
  way_continuous : forall s s', Un_cv s s' -> cv_row (fun k => way (s k)) (way s')
}.

(* To every choice of all contacts there is a way for each. *)
Lemma ways_to rows rs : Forall2 suits rows rs -> Forall (proper D) rs ->
  forallb (fun r => friction_sound (box r)) rows = true ->
  exists ways, map (fun w => w 1) ways = rs /\ Forall2 is_way rows ways.
Proof.
  intros F. induction F as [|row r rows rs [E I] F IH]; intros P S.
  - exists []. split; [reflexivity|constructor].
  - cbn in S. apply andb_true_iff in S as [S1 S2].
    destruct (IH (Forall_inv_tail P) S2) as (ways & E' & W).
    destruct (way_to D (box row) r I (Forall_inv P) S1) as (way & W1 & W2 & W3 & W4).
    exists (way :: ways). split; [cbn; congruence|]. constructor; [|exact W].
    constructor; [exact W2| | |exact W4]; intros s Hs; now apply W3.
Qed.

(* All rows at the time s. *)
Definition rows_at (ways : list (R -> Rows.row)) (s : R) : list Rows.row := map (fun w => w s) ways.

Lemma rows_continuous rows ways s s' : Forall2 is_way rows ways -> Un_cv s s' ->
  cv_rows (fun k => rows_at ways (s k)) (rows_at ways s').
Proof.
  intros F C. induction F as [|row w rows ways H F IH]; cbn; [constructor|].
  apply (cv_rows_cons (fun k => w (s k))); [now apply (way_continuous _ _ H)|exact IH].
Qed.

Lemma rows_proper rows ways s : Forall2 is_way rows ways -> 0 <= s <= 1 -> Forall (proper D) (rows_at ways s).
Proof. intros F S. induction F as [|row w rows ways H F IH]; cbn; constructor; [now apply (way_proper _ _
  H)|exact IH]. Qed.

Lemma rows_fit_box rows ways s : Forall2 is_way rows ways -> 0 <= s <= 1 ->
  Forall (fun r => r = make_row (box r)) rows -> Forall2 suits rows (rows_at ways s).
Proof.
  intros F S M. induction F as [|row w rows ways H F IH]; cbn; constructor.
  - split; [exact (Forall_inv M)|now apply (way_inside _ _ H)].
  - apply IH. exact (Forall_inv_tail M).
Qed.

Lemma rows_in_middle rows ways : Forall2 is_way rows ways ->
  Forall2 suits (map (fun r => make_row (middle_box (box r))) rows) (rows_at ways 0).
Proof.
  intros F. induction F as [|row w rows ways H F IH]; cbn; constructor; [|exact IH].
  split; [reflexivity|]. apply (from_middle _ _ H).
Qed.

(* A box of one point is its middle. *)
Lemma certain_middle i x : certain i = true -> within i x -> within (only_middle i) x.
Proof.
  intros C W. pose proof (certain_within i x C W) as E. unfold certain in C. apply Qeq_bool_eq, Qeq_eqR in C.
  unfold within, only_middle, exactly; cbn. rewrite middle_is. lra.
Qed.

Lemma point_inside b r p F mu t : point_box b = true -> inside_at b r p F mu t -> inside_at (middle_box b) r p F mu t.
Proof.
  intros P I. unfold point_box in P. rewrite !andb_true_iff in P. destruct P as [[[[P1 P2] P3] P4] P5].
  constructor; try apply I; cbn [middle_box box_geometry box_forms box_friction box_preload box_growth
    box_stiffness].
  - pose proof (in_geometry _ _ _ _ _ _ I) as G. clear - G P1. induction G as [|i x is p W G IH]; cbn in *;
      constructor.
    + apply andb_true_iff in P1 as [P1 _]. now apply certain_middle.
    + apply andb_true_iff in P1 as [_ P1]. now apply IH.
  - intros j d. rewrite map_length. apply (forms_affine _ _ _ _ _ _ I).
  - intros q q'. rewrite map_length. apply (forms_shape _ _ _ _ _ _ I).
  - apply certain_middle; [exact P2|apply I].
  - rewrite (in_preload _ _ _ _ _ _ I). unfold certain in P3. apply Qeq_bool_eq, Qeq_eqR in P3.
    cbn. rewrite middle_is, P3. lra.
  - rewrite (in_growth _ _ _ _ _ _ I). unfold certain in P4. apply Qeq_bool_eq, Qeq_eqR in P4.
    cbn. rewrite middle_is, P4. lra.
  - apply certain_middle; [exact P5|apply I].
Qed.

Lemma point_suits rows rs : forallb (fun r => point_box (box r)) rows = true -> Forall2 suits rows rs ->
  Forall2 suits (map (fun r => make_row (middle_box (box r))) rows) rs.
Proof.
  intros P F. induction F as [|row r rows rs [_ Se] F IH]; cbn in *; constructor;
    apply andb_true_iff in P as [P1 P2]; [|now apply IH]. split; [reflexivity|].
  destruct Se as (r' & p & G & mu & t & H & len & k & I & Se & ->). cbn [box make_row].
  exists r', p, G, mu, t, H, len, k. split; [now apply point_inside|]. split; [now apply middle_seen_as|reflexivity].
Qed.

End Ways.

(* ---- Free motions ---- *)

Section Free.
Open Scope R_scope.

Lemma is_zero_real q : is_zero q = true -> Q2R q = 0.
Proof. intros H. apply Qeq_bool_eq, Qeq_eqR in H. now rewrite H, Q2R_0. Qed.

Lemma row_is_free D z b r : row_free z b = true -> seen_in b r -> proper D r ->
  Rows.dot (Rows.N r) (real z) = 0 /\ (Rows.rho r = 0 \/ Forall (fun s => Rows.dot s (real z) = 0) (Rows.slips r)).
Proof.
  intros H Se P. destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & St & _).
  enough (Free : Rows.dot (Rows.N r') (real z) = 0 /\
      (Rows.rho r' = 0 \/ Forall (fun s => Rows.dot s (real z) = 0) (Rows.slips r'))).
  { destruct Free as [N S]. rewrite (same_N _ _ _ St) in N. split; [exact N|].
    destruct S as [S|S]; [left; now apply (no_rubbing _ _ _ St)|right]. apply (stands_free k r r' (real z) St); [apply (RowLimits.weights_length _ _ P)|exact S]. }
  clear Se St P r k. rename r' into r. unfold row_free in H. rewrite forallb_forall in H.
  assert (Z : forall j, (j = O \/ Qle_bool (high (box_friction b)) 0 = false) ->
    Rows.dot (nth j (Rows.N r :: Rows.slips r) []) (real z) = 0).
  { intros j J. rewrite (rational_corners b r p F mu t I).
    rewrite (eval_same _ (fun _ => 0)); [apply eval_constant|]. intros fs Hfs. specialize (H fs Hfs).
    apply andb_true_iff in H as [H1 H2]. rewrite qdot_is. fold (real (nth j fs [])). rewrite <- inner_is.
    apply is_zero_real. destruct J as [->|J]; [exact H1|]. rewrite J in H2. cbn in H2. rewrite forallb_forall in H2.
    destruct fs as [|f fs]; [now destruct j|]. destruct j as [|j]; [exact H1|]. cbn [nth tl] in *.
    destruct (nth_in_or_default j fs []) as [Hj|E]; [now apply H2|]. rewrite E. reflexivity. }
  split; [exact (Z O (or_introl eq_refl))|].
  destruct (Qle_bool (high (box_friction b)) 0) eqn:Q.
  - left. apply Qle_bool_R in Q. rewrite Q2R_0 in Q. rewrite (is_rho _ _ _ _ _ _ I).
    pose proof (friction_nonneg _ _ _ _ _ _ I). pose proof (in_friction _ _ _ _ _ _ I) as [_ W].
    replace mu with 0 by lra. ring.
  - right. apply Forall_forall. intros s Hs. apply In_nth with (d := []) in Hs as (j & _ & <-).
    exact (Z (S j) (or_intror eq_refl)).
Qed.

Lemma rows_are_free D z rows rs : forallb (fun r => row_free z (box r)) rows = true -> Forall2 suits rows rs ->
  Forall (proper D) rs ->
  Forall (fun r => Rows.dot (Rows.N r) (real z) = 0 /\
    (Rows.rho r = 0 \/ Forall (fun s => Rows.dot s (real z) = 0) (Rows.slips r))) rs.
Proof.
  intros H F P. induction F as [|row r rows rs [_ I] F IH]; cbn in H; constructor;
    apply andb_true_iff in H as [H1 H2]; [|exact (IH H2 (Forall_inv_tail P))].
  apply row_is_free with D (box row); [exact H1|exact I|exact (Forall_inv P)].
Qed.

Lemma load_is_free z ld w : load_free z ld = true -> is_load ld w ->
  Rows.dot w (real z) = 0 /\ Rows.dot (real (load_growth ld)) (real z) = 0.
Proof.
  unfold load_free. rewrite !andb_true_iff. intros [[Z1 Z2] Z3] L. apply is_zero_real in Z1, Z2, Z3.
  rewrite inner_is in Z3. destruct (load_within ld w z L). split; [lra|exact Z3].
Qed.

End Free.

(* ---- Multiples of solutions ---- *)

Section Multiples.
Open Scope R_scope.

Lemma v_multiple r d h l c : Rows.v r (Rows.scaled c d) (c * h) (c * l) = c * Rows.v r d h l.
Proof. unfold Rows.v. rewrite dot_sym, Rows.dot_scaled, (dot_sym d). ring. Qed.

Lemma slip_multiple r d c : Rows.slip r (Rows.scaled c d) = Rows.scaled c (Rows.slip r d).
Proof.
  unfold Rows.slip, Rows.scaled at 2. rewrite map_map. apply map_ext. intros f.
  now rewrite dot_sym, Rows.dot_scaled, dot_sym.
Qed.

Lemma obeys_multiple w d h l r f c : 0 <= c -> Rows.positive (Rows.weights r) -> Rows.obeys w d h l r f ->
  Rows.obeys w (Rows.scaled c d) (c * h) (c * l) r (c * fst f, Rows.scaled c (snd f)).
Proof.
  intros C P. destruct f as [a y]. intros (L & Co & Di). cbn [fst snd Rows.obeys].
  rewrite v_multiple, slip_multiple, !Rows.size_scaled by (assumption || lra). repeat split.
  - unfold Rows.normal_law in *. destruct (Rows.spring r); [congruence|]. destruct w; cbn in *.
    + rewrite L. unfold Rmax. destruct (Rle_dec 0 (Rows.v r d h l)), (Rle_dec 0 (c * Rows.v r d h l)); nra.
    + destruct L as [-> L]. split; [reflexivity|]. nra.
  - nra.
  - rewrite Rows.product_scaled, Rows.product_sym, Rows.product_scaled, Rows.product_sym, Di. ring.
Qed.

Lemma works_multiple c rs fs y :
  Rows.works rs (map (fun f => (c * fst f, Rows.scaled c (snd f))) fs) y = c * Rows.works rs fs y.
Proof.
  revert fs. induction rs as [|r rs IH]; intros [|f fs]; cbn; try ring. rewrite IH. unfold Rows.work. cbn [fst snd].
  rewrite Rows.product_scaled. ring.
Qed.

(* What balances at h > 0 does so at 1. *)
Lemma stable_by_multiple bound sys d h l fs : 0 < h -> Forall (fun r => Rows.positive (Rows.weights r)) (Rows.rows sys) ->
  Rows.equilibrium sys d h l fs -> Rows.bounded bound h d -> Rows.stable_at (Rows.bounded bound 1) sys (l / h).
Proof.
  intros H P (L & O & Bal) Bd. exists (Rows.scaled (/ h) d), (map (fun f => (/ h * fst f, Rows.scaled (/ h) (snd
    f))) fs).
  assert (C : 0 < / h) by now apply Rinv_0_lt_compat.
  split; [replace 1 with (/ h * h) by (field; lra); apply bounded_multiple; [lra|exact Bd]|].
  split; [unfold Rows.scaled; now rewrite map_length|]. split.
  - replace 1 with (/ h * h) by (field; lra). replace (l / h) with (/ h * l) by (unfold Rdiv; ring).
    clear Bal. revert P. induction O as [|r f rs fs Of O IH]; intros P; cbn; constructor; [|exact (IH
      (Forall_inv_tail P))].
    apply obeys_multiple; [lra|exact (Forall_inv P)|exact Of].
  - intros y. rewrite works_multiple. specialize (Bal y). unfold Rows.load in *.
    apply Rmult_eq_reg_l with h; [|lra]. field_simplify; [|lra]. lra.
Qed.

End Multiples.

Section Laws.
Open Scope R_scope.

(* Where no contact but a spring pulls, the bilateral law asks no more than the unilateral one. *)
Lemma both_laws d h l rows rs fs : Forall2 suits rows rs -> Forall2 (Rows.obeys Model.unilateral d h l) rs fs ->
  (forall row r, In row rows -> suits row r -> box_spring (box row) = false -> 0 <= Rows.v r d h l) ->
  Forall2 (Rows.obeys Model.bilateral d h l) rs fs.
Proof.
  intros F. revert fs. induction F as [|row r rows rs Fr F IH]; intros fs O V; inversion O as [|? [a y] ? fs'
    Oc Os]; subst;
    constructor.
  - destruct Oc as (L & C & D). repeat split; try assumption. specialize (V row r (or_introl eq_refl) Fr).
    destruct (seen_stands _ _ (proj2 Fr)) as (r' & k & p & G & mu & t & I & St & _).
    unfold Rows.normal_law in *. rewrite <- (Leaf.same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I) in L |- *.
    destruct (box_spring (box row)); [exact L|]. specialize (V eq_refl). cbn in *. rewrite Rmax_right in L by
      exact V. now split.
  - apply IH; [exact Os|]. intros row' r' H. apply V. now right.
Qed.

End Laws.

(* ---- The theorem ---- *)

Section Sound.
Open Scope R_scope.

Variable advisor : oracle.
Variable g : degree_proof.
Variable s : setting.
Variable nodes : list node.
Variable most : Z.
Variable sys : Rows.system.
Let D := dimension_of s.

Record in_setting : Prop := InSetting {
  its_box : contains (rows s) (the_load s) sys;
  its_dimension : Rows.dimension sys = D;
  its_proper : Forall (proper D) (Rows.rows sys);
  its_lengths : List.length (Rows.wrench sys) = D /\ List.length (Rows.direction sys) = D;
  nothing_slips : slipping s = [];
  nothing_pushes : pushes s = no_push;
  its_bound : good_bound D (the_bound s) = true
}.
Hypothesis fit : in_setting.

(* The part of the range at which a multiple is. *)
Lemma part_of lambda : good_range g -> Q2R (low_multiple g) <= lambda ->
  match high_multiple g with Some b => lambda <= Q2R b | None => True end ->
  exists t, good_part g t /\ 0 < h_at g t /\ l_at g t = lambda * h_at g t.
Proof.
  intros [A0 R] Lo Hi. unfold good_part, h_at, l_at, one_multiple. destruct (high_multiple g) as [b|].
  - destruct (Qeq_bool (low_multiple g) b) eqn:E.
    + apply Qeq_bool_eq, Qeq_eqR in E. exists 0. unfold mix. repeat split; intros; lra.
    + assert (NE : Q2R (low_multiple g) < Q2R b).
      { destruct R as [R|R]; [exact R|]. apply eqR_Qeq, Qeq_eq_bool in R. congruence. }
      set (a := Q2R (low_multiple g)) in *. set (q := Q2R b) in *. exists ((lambda - a) / (q - a)).
      assert (P : 0 < / (q - a)) by (apply Rinv_0_lt_compat; lra).
      repeat split; try discriminate; try lra.
      * apply Rmult_le_pos; lra.
      * apply Rmult_le_reg_r with (q - a); [lra|]. field_simplify; lra.
      * unfold mix. field. lra.
  - set (a := Q2R (low_multiple g)) in *. exists (1 - a / lambda). assert (P : 0 < / lambda) by (apply
      Rinv_0_lt_compat; lra).
    assert (0 < a / lambda) by (apply Rmult_lt_0_compat; lra).
    assert (a / lambda <= 1) by (apply Rmult_le_reg_r with lambda; [lra|]; field_simplify; lra).
    repeat split; try discriminate; try lra. field. lra.
Qed.

Definition middle_part : R := if one_multiple g then 0 else 1 / 2.

Lemma middle_part_good : good_part g middle_part.
Proof. unfold good_part, middle_part. destruct (one_multiple g); split; try discriminate; lra. Qed.

Lemma part_on_the_way t q : good_part g t -> 0 <= q <= 1 -> good_part g (mix q middle_part t).
Proof.
  intros [T Z] Q. destruct middle_part_good as [M Zm]. split; [unfold mix; nra|]. intros O.
  rewrite (Z O), (Zm O). unfold mix. ring.
Qed.

Lemma cv_h ts t : Un_cv ts t -> Un_cv (fun k => h_at g (ts k)) (h_at g t).
Proof.
  intros C. unfold h_at. destruct (high_multiple g); [apply cv_constant|].
  apply (CV_minus (fun _ => 1)); [apply cv_constant|exact C].
Qed.

Lemma cv_l ts t : Un_cv ts t -> Un_cv (fun k => l_at g (ts k)) (l_at g t).
Proof. intros C. unfold l_at. destruct (high_multiple g); [now apply cv_mix|apply cv_constant]. Qed.

Lemma range_sound_is : range_sound g s = true -> good_range g /\ List.length (first_twist g) = D /\ List.length
  (last_twist g) = D.
Proof.
  unfold range_sound. rewrite !andb_true_iff. intros [[[L1 L2] A] R]. apply Nat.eqb_eq in L1, L2.
  apply Qle_bool_R in A. rewrite Q2R_0 in A. repeat split; try assumption.
  destruct (high_multiple g) as [b|]; [now apply Qle_bool_R|].
  apply negb_true_iff in R. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in
    L. congruence.
Qed.

Lemma walls_real_length simplex e : Forall (fun a => List.length a = D) e ->
  Forall (fun a => List.length a = D) (walls_of simplex e).
Proof.
  intros F. unfold walls_of. destruct simplex; [exact F|]. apply Forall_flat_map. eapply Forall_impl; [|exact F].
  cbn. intros a L. repeat constructor; [exact L|]. unfold opposite. now rewrite map_length.
Qed.

(* In K, without a part along free motions, there is an equilibrium. *)
Theorem equilibrium_by_degree (two_sided : bool) (lambda : R) :
  degree_fails advisor two_sided most s g nodes = None ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  Q2R (low_multiple g) <= lambda -> match high_multiple g with Some b => lambda <= Q2R b | None => True end ->
  exists free t e fs,
    let d := listed D (fun i => nth i (twist_at g t) 0 + e i) in
    free_motions D (is_a_simplex g) (wall_rows g) = Some free /\
    (good_range g /\ List.length (first_twist g) = D /\ List.length (last_twist g) = D) /\
    (good_part g t /\ 0 < h_at g t /\ l_at g t = lambda * h_at g t) /\
    Forall (fun f => Rows.dot (real f) (listed D e) <= 1) (walls g) /\
    Forall (fun z => Rows.dot (real z) (listed D e) = 0) free /\
    Rows.equilibrium sys d (h_at g t) (l_at g t) fs /\ Rows.bounded (real_bound (the_bound s)) (h_at g t) d.
Proof.
  intros H Law Lo Hi. unfold degree_fails in H. fold D in H.
  destruct (free_motions D (is_a_simplex g) (wall_rows g)) as [free|] eqn:FM; [|discriminate].
  destruct (range_sound g s && all_free free s) eqn:RA; [|discriminate]. cbn [negb] in H.
  apply andb_true_iff in RA as [RS AF].
  destruct (inverted D free (direction_rows g)) as [[m inv]|] eqn:INV; [|discriminate].
  destruct (bound_holds g free s) eqn:BH; [cbn [negb] in H|discriminate].
  destruct (two_sided && negb (law_holds advisor g s)) eqn:LH; [discriminate|].
  destruct (walk _ _ _ _ _ _ _ _) as [[? ?]|] eqn:W in H; [discriminate|]. clear H.
  destruct (range_sound_is RS) as (Range & L1 & L2).
  destruct (walls_bound _ _ _ _ FM) as (B & HB). destruct (free_lengths _ _ _ _ FM) as [FL EL].
  destruct (direction_inverse _ _ _ _ _ INV FL) as (LA & AL & Lm & HM & I1 & I2 & HA).
  unfold all_free in AF. apply andb_true_iff in AF as [FS AF]. rewrite forallb_forall in AF.
  destruct fit as [(Fr & Fw & Fg) Fd Fp [Fl1 Fl2] Fs Fn Fb].
  destruct (ways_to D _ _ Fr Fp FS) as (ways & WE & WW).
  destruct (part_of lambda Range Lo Hi) as (t1 & T1 & H1 & E1).
  destruct (middle_load_is _ _ Fw) as (w0 & Mw & W0 & Lw).
  set (system_at := fun q => Rows.System D (rows_at ways (clamp q)) (mixed (clamp q) w0 (Rows.wrench sys))
    (Rows.direction sys) Model.unilateral).
  set (part := fun q => mix (clamp q) middle_part t1).
  assert (Part : forall q, good_part g (part q)) by (intros q; apply part_on_the_way; [exact T1|apply clamp_range]).
  assert (Made : Forall (fun r => r = make_row (box r)) (rows s)).
  { clear - Fr. induction Fr as [|row r rws rs [E _] F IH]; constructor; assumption. }
  assert (Ww : forall q, is_load (the_load s) (mixed (clamp q) w0 (Rows.wrench sys))).
  { intros q. apply mixed_load; [apply clamp_range|exact W0|exact Fw]. }
  assert (Wd : Forall (fun f => List.length f = D) (walls g)) by now apply walls_real_length.
  assert (K_real : forall e, on_wall D (map real (walls g)) e ->
    Forall (fun f => Rows.dot (real f) (listed D e) <= 1) (walls g) /\
    Exists (fun f => Rows.dot (real f) (listed D e) = 1) (walls g)).
  { intros e [K X]. unfold in_K in K. rewrite Forall_map in K. rewrite Exists_map in X. split; assumption. }
  (* A point at home in a root does not exist. *)
  apply (walk_refutes advisor setting split (end_fails no_pieces) solves (fun _ => False)) in W;
    [|intros s' n bs x; apply split_covers|intros s' st rs n x; apply end_without_pieces
     |unfold root_regions; apply Forall_app; split; [destruct (is_point s && one_multiple g); [constructor|]|];
       apply walls_good].
  rewrite Forall_forall in W.
  assert (Point : forall q e, solves (without_bound s) (h_at g (part q) :: l_at g (part q) :: listed D (fun i => nth i
    (twist_at g (part q)) 0 + e i)) ->
    is_point s && one_multiple g = false -> on_wall D (map real (walls g)) e -> False).
  { intros q e S NP OW. destruct (K_real e OW) as [K X].
    destruct (wall_home g D L1 L2 Range advisor solves [] (without_bound s) (part q) e) as (r & Hr & Home); try assumption.
    - apply Part.
    - reflexivity.
    - constructor.
    - refine (W r _ _ Home). unfold root_regions. rewrite NP. apply in_or_app. now left. }
  assert (Middle : forall t e, good_part g t -> (one_multiple g = false -> t = 1 / 2) ->
    solves (middle_setting g s) (h_at g t :: l_at g t :: listed D (fun i => nth i (twist_at g t) 0 + e i)) ->
    on_wall D (map real (walls g)) e -> False).
  { intros t e T Th S OW. destruct (K_real e OW) as [K X].
    destruct (wall_home g D L1 L2 Range advisor solves (middle_conditions g) (middle_setting g s) t e)
      as (r & Hr & Home); try assumption.
    - reflexivity.
    - unfold middle_conditions. destruct (one_multiple g) eqn:O; constructor; [|constructor].
      unfold meets; cbn [fst snd]. apply to_form_zero. destruct (parts_at g t Range T) as (P1 & P2 & _).
      destruct (s_and_t_length g) as [S1 S2].
      rewrite dot_plus_times, (dot_two (fst (s_and_t g))), (dot_two (snd (s_and_t g))) by assumption.
      unfold s_at, t_at in P1, P2. rewrite P1, P2, (Th eq_refl). unfold Q2R; cbn. lra.
    - refine (W r _ _ Home). unfold root_regions. apply in_or_app. now right. }
  assert (Nonneg : forall t, good_part g t -> 0 <= h_at g t /\ 0 <= l_at g t).
  { intros t [T _]. destruct Range as [A0 R]. unfold h_at, l_at, mix. destruct (high_multiple g); split; nra. }
  assert (Pushed : forall t e, good_part g t -> forall y c,
    pushed (pushes (middle_setting g s)) c (h_at g t :: l_at g t :: listed D (fun i => nth i (twist_at g t) 0 +
      e i)) y =
    c * Rows.dot y (times (map real (direction_rows g)) (listed D e))).
  { intros t e T y c. unfold pushed. cbn [pushes middle_setting make_setting a_multiple known_push map times].
    rewrite dot_nil, Rminus_0_r. do 2 f_equal. unfold times.
    rewrite !map_map. apply map_ext_in. intros f Hf. apply relative_at; try assumption.
    rewrite Forall_forall in AL. now apply AL. }
  assert (InMiddle : forall q e fs c, (clamp q = 0 \/ is_point s = true) -> 0 <= c ->
    forces_obey D system_at (fun q => h_at g (part q)) (fun q => l_at g (part q)) (fun q => twist_at g (part
      q)) q e fs ->
    (forall y, total_work system_at (fun q => h_at g (part q)) (fun q => l_at g (part q)) q fs y =
       c * Rows.dot y (times (map real (direction_rows g)) (listed D e))) ->
    solves (middle_setting g s)
      (h_at g (part q) :: l_at g (part q) :: listed D (fun i => nth i (twist_at g (part q)) 0 + e i))).
  { intros q e fs c Q C F Bal. destruct (Nonneg _ (Part q)) as [H0 L0].
    exists (system_at q), (listed D (fun i => nth i (twist_at g (part q)) 0 + e i)), (h_at g (part q)),
      (l_at g (part q)), fs, c.
    split; [reflexivity|]. split; [exact C|]. split; [|split; [intros k r Hk; discriminate|exact Logic.I]].
    constructor; cbn [middle_setting make_setting rows the_load middle_load load_growth]; try assumption.
    - rewrite map_all_is. destruct Q as [Q|Q].
      + cbn [system_at Rows.rows]. rewrite Q. now apply rows_in_middle with D.
      + unfold is_point in Q. apply andb_true_iff in Q as [Q _]. apply point_suits; [exact Q|].
        apply rows_fit_box with D; [exact WW|apply clamp_range|exact Made].
    - cbn [system_at Rows.wrench]. destruct Q as [Q|Q].
      + rewrite Q, mixed_start by congruence. exact Mw.
      + unfold is_point in Q. apply andb_true_iff in Q as [_ Q]. exact (one_load_middle _ _ Q (Ww q)).
    - intros y. rewrite Pushed by apply Part. apply Bal. }
  assert (C0 : clamp 0 = 0) by (apply clamp_same; lra). assert (C1 : clamp 1 = 1) by (apply clamp_same; lra).
  assert (P0 : part 0 = middle_part) by (unfold part; rewrite C0; unfold mix; ring).
  assert (P1 : part 1 = t1) by (unfold part; rewrite C1; unfold mix; ring).
  destruct (stable_by_degree D system_at (fun q => h_at g (part q)) (fun q => l_at g (part q))
    (fun q => twist_at g (part q))) with (walls := map real (walls g)) (free := map real free) (B := B)
    (A := map real (direction_rows g)) (M := map real m) (inverse := map real inv) as (e & fs & K & Zf & F & Bal).
  - intros q. apply rows_proper with (rows s); [exact WW|apply clamp_range].
  - intros q. cbn. rewrite mixed_length, Lw by exact Lw. now split.
  - intros q q' Q C. apply cv_clamp in C. repeat split; cbn.
    + now apply rows_continuous with D (rows s).
    + now apply cv_mixed.
    + apply cv_list_constant.
    + apply cv_h. now apply cv_mix.
    + apply cv_l. now apply cv_mix.
    + intros i _. apply cv_nth. unfold twist_at. apply cv_mixed; [unfold real; rewrite !map_length; congruence|].
      now apply cv_mix.
  - intros e K Z i I. unfold in_K in K. rewrite Forall_map in K, Z.
    specialize (HB (listed D e) (length_listed D e) K Z i I). now rewrite nth_listed in HB.
  - now rewrite map_length.
  - apply Forall_map. eapply Forall_impl; [|exact FL]. cbn. intros z Hz. unfold real. now rewrite map_length.
  - intros e y _. apply HM.
  - now rewrite map_length.
  - pose proof (f_equal (@List.length R) (I1 _ (length_listed D (fun _ => 0)))) as E.
    now rewrite times_length, length_listed in E.
  - exact I1.
  - exact I2.
  - intros q z Hz. apply in_map_iff in Hz as (z' & <- & Hz). specialize (AF z' Hz). rewrite !andb_true_iff in AF.
    destruct AF as [_ A2]. unfold Rows.load. cbn [system_at Rows.wrench Rows.direction].
    destruct (load_is_free z' _ _ A2 (Ww q)) as [Z1 Z2]. unfold real in Z2 at 1. rewrite Fg in Z2. rewrite Z1, Z2. ring.
  - intros q z Hz. apply in_map_iff in Hz as (z' & <- & Hz). specialize (AF z' Hz). rewrite !andb_true_iff in AF.
    destruct AF as [A1 _]. apply rows_are_free with D (rows s); [exact A1| |].
    + apply rows_fit_box with D; [exact WW|apply clamp_range|exact Made].
    + apply rows_proper with (rows s); [exact WW|apply clamp_range].
  - intros z e Hz. apply in_map_iff in Hz as (z' & <- & Hz). now apply HA.
  - intros e fs c OW F C Bal. apply (Middle (part 0) e (Part 0)); [|eapply InMiddle; eauto|exact OW].
    intros O. rewrite P0. unfold middle_part. now rewrite O.
  - intros q e fs Q OW F Bal. destruct (is_point s && one_multiple g) eqn:PO.
    + apply andb_true_iff in PO as [PO O]. apply (Middle (part q) e (Part q)); [congruence| |exact OW].
      apply (InMiddle q e fs 0); [now right|lra|exact F|]. intros y. rewrite Bal. ring.
    + apply (Point q e); [|reflexivity|exact OW]. destruct (Nonneg _ (Part q)) as [H0 L0].
      exists (system_at q), (listed D (fun i => nth i (twist_at g (part q)) 0 + e i)), (h_at g (part q)),
        (l_at g (part q)), fs, 0.
      split; [reflexivity|]. split; [lra|].
      split; [|split; [intros k r Hk; cbn [without_bound slipping] in Hk; rewrite Fs in Hk; discriminate|exact Logic.I]].
      constructor; cbn [without_bound rows the_load]; try assumption.
      * apply rows_fit_box with D; [exact WW|apply clamp_range|exact Made].
      * apply Ww.
      * intros y. cbn [without_bound pushes]. rewrite Fn, not_pushed. apply Bal.
  - (* an equilibrium *)
    set (d := motion D (fun q => twist_at g (part q)) 1 e) in *.
    unfold forces_obey in F. fold d in F. cbn [system_at Rows.rows] in F. rewrite C1, P1 in F.
    unfold rows_at in F. rewrite WE in F.
    assert (Bd : Rows.bounded (real_bound (the_bound s)) (h_at g t1) d).
    { apply bounded_real. unfold bound_holds in BH. unfold good_bound in Fb. unfold h_at.
      destruct (the_bound s) as [bs|]; [|exact Logic.I]. destruct (high_multiple g); [|discriminate].
      apply andb_true_iff in Fb as [Lb _]. apply Nat.eqb_eq in Lb. rewrite Forall_map in Zf, K.
      unfold d, motion. rewrite P1. eapply Forall2_weaker; [apply (K_within_is _ _ _ _ _ _ _ t1 e BH Lb)| ].
      - congruence.
      - apply T1.
      - eapply Forall_impl; [|exact K]. intros f Hf; cbv beta in *; left; exact Hf.
      - exact Zf.
      - cbn. intros b z Hz. lra. }
    assert (Ed : d = listed D (fun i => nth i (twist_at g t1) 0 + e i)) by (unfold d, motion; now rewrite P1).
    exists free, t1, e, fs. cbv zeta. rewrite <- Ed.
    split; [reflexivity|]. split; [exact (conj Range (conj L1 L2))|]. split; [exact (conj T1 (conj H1 E1))|].
    split; [rewrite Forall_map in K; eapply Forall_impl; [|exact K]; cbn; intros; lra|]. split; [now rewrite Forall_map in Zf|]. split; [|exact Bd].
    split; [unfold d, motion; now rewrite length_listed, Fd|]. split.
    + rewrite Law. destruct two_sided; [|exact F]. cbn in LH. apply negb_false_iff in LH.
      apply both_laws with (rows s); [exact Fr|exact F|]. intros row r Hr [Er Se] Sp.
      destruct (seen_stands _ _ Se) as (r' & k & p & G & mu & t & I & St & _).
      unfold law_holds in LH. rewrite forallb_forall in LH. specialize (LH row Hr). rewrite Sp in LH. cbn in LH.
      assert (Home : at_home setting (fun _ _ => True) (k_region advisor g s [])
        (h_at g t1 :: l_at g t1 :: d)).
      { rewrite Ed. apply (k_home g D L1 L2 Range); [exact T1|reflexivity|exact Wd|exact Logic.I|constructor|].
        rewrite Forall_map in K. eapply Forall_impl; [|exact K]. cbn. intros; lra. }
      destruct (home_spanned _ _ _ _ (root_good _ _ _ _) Home) as (ws & Wt & Sp').
      rewrite Er in LH. rewrite <- (same_pull _ _ _ d (h_at g t1) (l_at g t1) St).
      exact (v_nonneg _ d (h_at g t1) (l_at g t1) ws Wt Sp' (box row) r' p G mu t I LH).
    + intros y. specialize (Bal y). unfold total_work, Rows.load in Bal.
      cbn [system_at Rows.rows Rows.wrench Rows.direction] in Bal. rewrite C1, P1, mixed_end in Bal by exact Lw.
      unfold rows_at in Bal. rewrite WE in Bal. exact Bal.
Qed.

Theorem stable_by_degree_in_box (two_sided : bool) (lambda : R) :
  degree_fails advisor two_sided most s g nodes = None ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  Q2R (low_multiple g) <= lambda -> match high_multiple g with Some b => lambda <= Q2R b | None => True end ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros H Law Lo Hi. destruct (equilibrium_by_degree two_sided lambda H Law Lo Hi) as (free & t & e & fs & Eq).
  cbv zeta in Eq. destruct Eq as (_ & _ & (_ & H1 & E1) & _ & _ & Eq & Bd).
  replace lambda with (l_at g t / h_at g t) by (rewrite E1; field; lra).
  refine (stable_by_multiple _ sys _ (h_at g t) (l_at g t) fs H1 _ Eq Bd).
  eapply Forall_impl; [|exact (its_proper fit)]. intros r P. apply (RowLimits.weights_positive _ _ P).
Qed.

End Sound.
