(* SPDX-License-Identifier: MIT *)
(* The theorem: whatever the oracle says, the answers of the checker are true. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Bound Root Box RowsOfModels Contacts Fingers Bodies Load Leaf Tree Witness Margin
  RowLimits Ways ByDegree Parts Checker Matrix RigidModel Rigid RigidRows
  RigidClass RigidTrue Plane StaticsRules StaticsTrue.
From Proved Require Rows Model SpaceModel BodiesModel.
Import ListNotations.
Open Scope R_scope.

(* The rows of a grasp that the question is about. *)
Definition choice_of (q : question) (s : Rows.system) : Prop :=
  (exists g, chosen q g /\ s = grasp_rows g) \/
  (exists g, chosen_in_space q g /\ s = space_grasp_rows g) \/
  (exists m, chosen_bodies_in_plane q m /\ s = plane_mechanism m) \/
  (exists m, chosen_bodies_in_space q m /\ s = space_mechanism m).

Lemma enlarge_all_suits bits qs rws rs (chosen_row : contact -> Rows.row -> Prop) :
  (forall q b r, enlarge bits q = Some b -> chosen_row q r -> seen_in b r) ->
  enlarge_all bits qs = Some rws -> Forall2 chosen_row qs rs -> Forall2 suits rws rs.
Proof.
  intros I H F. apply all_some_is in H. revert rs F.
  induction H as [|q row qs rws E H IH]; intros rs F; inversion F; subst; constructor; [|now apply IH].
  destruct (enlarge bits q) as [b|] eqn:B; [|discriminate]. injection E as <-. split; [reflexivity|].
  eapply I; eassumption.
Qed.

Lemma Forall2_map_right {A B C} (P : A -> C -> Prop) (f : B -> C) l l' :
  Forall2 (fun a b => P a (f b)) l l' -> Forall2 P l (map f l').
Proof. induction 1; cbn; constructor; assumption. Qed.

(* The lengths of a row's lists. *)
Definition shaped_row (D : nat) (r : Rows.row) : Prop :=
  List.length (Rows.N r) = D /\ Forall (fun f => List.length f = D) (Rows.slips r) /\
  List.length (Rows.weights r) = List.length (Rows.slips r).

(* All that the proofs need to know of a choice. *)
Record poses (q : question) (st : setting) (s : Rows.system) : Prop := Poses {
  posed_rows : Forall2 suits (rows st) (Rows.rows s);
  posed_slipping : slipping st = [] /\ pushes st = no_push;
  posed_dimension : dimension_of st = Rows.dimension s /\ dimension q = Rows.dimension s;
  posed_wrench : is_load (the_load st) (Rows.wrench s);
  posed_direction : map Q2R (load_growth (the_load st)) = Rows.direction s;
  posed_lengths : List.length (Rows.direction s) = List.length (Rows.wrench s);
  posed_shapes : List.length (Rows.wrench s) = Rows.dimension s /\ Forall (shaped_row (Rows.dimension s)) (Rows.rows s);
  posed_law : Rows.normal s = if bilateral q then Model.bilateral else Model.unilateral;
  posed_bound : the_bound st = max_motion q /\ good_bound (dimension_of st) (the_bound st) = true
}.

(* ---- Loads ---- *)

(* A number of a ball, over m^2. *)
Lemma number_in_ball m z : 0 < Q2R m -> z * z <= Q2R m * Q2R m ->
  within (Interval (- m) m) (Q2R (m * m) * (z / Q2R (m * m))) /\
  Q2R (m * m) * (z / Q2R (m * m)) = z /\
  Q2R (m * m) * (z / Q2R (m * m)) * (z / Q2R (m * m)) = z * z / (Q2R m * Q2R m).
Proof.
  intros M Z. rewrite Q2R_mult. assert (E : Q2R m * Q2R m * (z / (Q2R m * Q2R m)) = z) by (field; lra).
  split; [|split; [exact E|field; lra]]. rewrite E. unfold within; cbn. rewrite Q2R_opp. split; nra.
Qed.

Lemma ball_sizes b it : addition_of b = Some it ->
  0 < Q2R (radius b) /\ 0 < Q2R (torque_length b) /\ exists ways, unit_loads (about b) = Some ways /\
  let most := (repeat (radius b) (List.length (about b)) ++
    repeat (radius b * torque_length b)%Q (List.length ways - List.length (about b)))%list in
  it = Addition (map (fun m => Interval (- m) m) most) ways (map (fun m => m * m)%Q most).
Proof.
  unfold addition_of. destruct (unit_loads (about b)) as [ways|]; [|discriminate].
  destruct (_ || _) eqn:P; [discriminate|]. apply orb_false_iff in P as [P1 P2]. intros [= <-].
  assert (Pos : forall q, Qle_bool q 0 = false -> 0 < Q2R q).
  { intros q H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence. }
  split; [now apply Pos|]. split; [now apply Pos|]. now exists ways.
Qed.

(* Forces and torques of a ball, number by number. *)
Lemma in_ball_numbers b f t : 0 < Q2R (radius b) -> 0 < Q2R (torque_length b) -> 0 <= f -> 0 <= t -> in_ball b f t ->
  f <= Q2R (radius b) * Q2R (radius b) /\
  t <= Q2R (radius b * torque_length b) * Q2R (radius b * torque_length b) /\
  f / (Q2R (radius b) * Q2R (radius b)) + t / (Q2R (radius b * torque_length b) * Q2R (radius b * torque_length b)) <= 1.
Proof.
  intros R L F T H. unfold in_ball in H. rewrite Q2R_mult. set (r := Q2R (radius b)) in *. set (l := Q2R (torque_length b)) in *.
  assert (LL : 0 < l * l) by now apply Rmult_lt_0_compat. assert (RR : 0 < r * r) by now apply Rmult_lt_0_compat.
  assert (Tl : 0 <= t / (l * l)) by (apply Rmult_le_pos; [exact T|left; now apply Rinv_0_lt_compat]).
  assert (E : t = t / (l * l) * (l * l)) by (field; lra).
  split; [lra|]. split.
  - rewrite E. replace (r * l * (r * l)) with (r * r * (l * l)) by ring. apply Rmult_le_compat_r; lra.
  - apply Rmult_le_reg_r with (r * r); [exact RR|].
    replace ((f / (r * r) + t / (r * l * (r * l))) * (r * r)) with (f + t / (l * l)) by (field; lra). lra.
Qed.

Lemma load_grows q ld : load_of q = Some ld -> load_growth ld = direction q.
Proof.
  unfold load_of. destruct (load_ball q) as [b|]; [destruct (addition_of b); [|discriminate]|]; now intros [= <-].
Qed.

Lemma plane_ball b it w : addition_of b = Some it -> added (Some b) w ->
  exists e, is_addition it 3 e /\ forall z, Rows.dot (three_numbers w) z = work_added it e z.
Proof.
  intros Ad A.
  destruct A as (x & y & fx & fy & t & Ab & In_b & ->).
  destruct (ball_sizes b it Ad) as (R0 & L0 & ways & U & ->).
  destruct (about b) as [|cx [|cy [|? ?]]]; try discriminate Ab. injection Ab as <- <-. cbn in U. injection U as <-.
  pose proof (Rle_0_sqr fx) as X0. pose proof (Rle_0_sqr fy) as Y0. pose proof (Rle_0_sqr t) as T0. unfold Rsqr in *.
  destruct (in_ball_numbers b (fx * fx + fy * fy) (t * t) R0 L0 ltac:(lra) T0 In_b) as (F1 & T1 & S).
  set (r := radius b) in *. set (m := (r * torque_length b)%Q) in *.
  assert (M0 : 0 < Q2R m) by (unfold m; rewrite Q2R_mult; now apply Rmult_lt_0_compat).
  destruct (number_in_ball r fx R0 ltac:(lra)) as (Wx & Ex & Sx). destruct (number_in_ball r fy R0 ltac:(lra)) as (Wy & Ey & Sy).
  destruct (number_in_ball m t M0 T1) as (Wt & Et & St).
  exists [fx / Q2R (r * r); fy / Q2R (r * r); t / Q2R (m * m)].
  split.
  - constructor; cbn.
    + rewrite !Q2R_mult. repeat constructor; now apply Rmult_lt_0_compat.
    + repeat constructor.
    + reflexivity.
    + constructor; [exact Wx|constructor; [exact Wy|constructor; [exact Wt|constructor]]].
    + rewrite Sx, Sy, St. unfold Rdiv in *. rewrite !Rmult_plus_distr_r in S. lra.
  - intros z. unfold work_added. rewrite product_is_dot. cbn -[Q2R Qmult]. rewrite Ex, Ey, Et.
    destruct z as [|z1 [|z2 [|z3 z]]]; cbn -[Q2R]; rewrite ?Q2R_opp, ?Q2R_0, ?Q2R_1; try ring.
Qed.

Lemma space_ball b it w : addition_of b = Some it -> added_in_space (Some b) w ->
  exists e, is_addition it 6 e /\ forall z, Rows.dot (six_numbers w) z = work_added it e z.
Proof.
  intros Ad A.
  destruct A as ([px py pz] & [fx fy fz] & [tx ty tz] & Ab & In_b & ->).
  unfold SpaceModel.dot in In_b. cbn [SpaceModel.x SpaceModel.y SpaceModel.z] in *.
  destruct (ball_sizes b it Ad) as (R0 & L0 & ways & U & ->).
  destruct (about b) as [|cx [|cy [|cz [|? ?]]]]; try discriminate Ab. injection Ab as <- <- <-. cbn in U. injection U as <-.
  pose proof (Rle_0_sqr fx) as X0. pose proof (Rle_0_sqr fy) as Y0. pose proof (Rle_0_sqr fz) as Z0.
  pose proof (Rle_0_sqr tx) as X1. pose proof (Rle_0_sqr ty) as Y1. pose proof (Rle_0_sqr tz) as Z1. unfold Rsqr in *.
  destruct (in_ball_numbers b (fx * fx + fy * fy + fz * fz) (tx * tx + ty * ty + tz * tz) R0 L0
    ltac:(lra) ltac:(lra) In_b) as (F1 & T1 & S).
  set (r := radius b) in *. set (m := (r * torque_length b)%Q) in *.
  assert (M0 : 0 < Q2R m) by (unfold m; rewrite Q2R_mult; now apply Rmult_lt_0_compat).
  destruct (number_in_ball r fx R0 ltac:(lra)) as (Wx & Ex & Sx). destruct (number_in_ball r fy R0 ltac:(lra)) as (Wy & Ey & Sy).
  destruct (number_in_ball r fz R0 ltac:(lra)) as (Wz & Ez & Sz). destruct (number_in_ball m tx M0 ltac:(lra)) as (Wu & Eu & Su).
  destruct (number_in_ball m ty M0 ltac:(lra)) as (Wv & Ev & Sv). destruct (number_in_ball m tz M0 ltac:(lra)) as (Ww & Ew & Sw).
  exists [fx / Q2R (r * r); fy / Q2R (r * r); fz / Q2R (r * r);
                            tx / Q2R (m * m); ty / Q2R (m * m); tz / Q2R (m * m)].
  split.
  - constructor; cbn.
    + rewrite !Q2R_mult. repeat constructor; now apply Rmult_lt_0_compat.
    + repeat constructor.
    + reflexivity.
    + constructor; [exact Wx|constructor; [exact Wy|constructor; [exact Wz|constructor; [exact Wu|constructor; [exact Wv|constructor; [exact Ww|constructor]]]]]].
    + rewrite Sx, Sy, Sz, Su, Sv, Sw. unfold Rdiv in *. rewrite !Rmult_plus_distr_r in S. lra.
  - intros z. unfold work_added. rewrite product_is_dot. cbn -[Q2R Qmult]. rewrite Ex, Ey, Ez, Eu, Ev, Ew.
    destruct z as [|z1 [|z2 [|z3 [|z4 [|z5 [|z6 z]]]]]]; cbn -[Q2R]; rewrite ?Q2R_opp, ?Q2R_0, ?Q2R_1; try ring.
Qed.

Lemma plane_load q ld g : load_of q = Some ld -> several q = None ->
  (exists w0 w1, Forall2 within (wrench q) (three_numbers w0) /\ added (load_ball q) w1 /\ Model.wrench g = Model.add w0 w1) ->
  is_load ld (motion_list (Model.wrench g)).
Proof.
  unfold load_of. intros H One (w0 & w1 & W & A & ->). destruct (load_ball q) as [b|].
  - destruct (addition_of b) as [it|] eqn:Ad; [|discriminate]. rewrite One in H. injection H as <-.
    destruct (plane_ball b it w1 Ad A) as (e & Ie & We). exists (three_numbers w0), e.
    split; [exact W|]. split; [reflexivity|]. split; [exact Ie|]. intros y. cbn [load_added]. rewrite <- We.
    change (three_numbers w0) with (motion_list w0). change (three_numbers w1) with (motion_list w1). rewrite !dot_motion.
    unfold Model.work, Model.add; cbn. ring.
  - injection H as <-. cbn in A. subst w1. exists (three_numbers w0), []. split; [exact W|]. split; [reflexivity|].
    split; [apply nothing_is_added|]. intros y. change (three_numbers w0) with (motion_list w0). rewrite !dot_motion.
    unfold work_added, Model.work, Model.add, Model.zero; cbn. ring.
Qed.

Lemma space_load q ld g : load_of q = Some ld -> several q = None ->
  (exists w0 w1, Forall2 within (wrench q) (six_numbers w0) /\ added_in_space (load_ball q) w1 /\
     SpaceModel.wrench g = SpaceModel.add_screw w0 w1) ->
  is_load ld (screw_list (SpaceModel.wrench g)).
Proof.
  unfold load_of. intros H One (w0 & w1 & W & A & ->). destruct (load_ball q) as [b|].
  - destruct (addition_of b) as [it|] eqn:Ad; [|discriminate]. rewrite One in H. injection H as <-.
    destruct (space_ball b it w1 Ad A) as (e & Ie & We). exists (six_numbers w0), e.
    split; [exact W|]. split; [reflexivity|]. split; [exact Ie|]. intros y. cbn [load_added]. rewrite <- We.
    change (six_numbers w0) with (screw_list w0). change (six_numbers w1) with (screw_list w1). rewrite !dot_screw.
    unfold SpaceModel.work, SpaceModel.add_screw, SpaceModel.dot, SpaceModel.add; cbn. ring.
  - injection H as <-. cbn in A. subst w1. exists (six_numbers w0), []. split; [exact W|]. split; [reflexivity|].
    split; [apply nothing_is_added|]. intros y. change (six_numbers w0) with (screw_list w0). rewrite !dot_screw.
    unfold work_added, SpaceModel.work, SpaceModel.add_screw, SpaceModel.no_screw, SpaceModel.dot, SpaceModel.add, SpaceModel.zero;
      cbn. ring.
Qed.

(* On one of several bodies a ball does the work of its wrench on how that body moves. *)
Lemma addition_lifts it n e G : is_addition it n e -> is_addition (addition_on G it) (List.length G) e.
Proof.
  intros [Sq _ Nu Wi Ib]. constructor; try assumption. cbn [ball_ways addition_on].
  apply Forall_map, Forall_forall. intros way _. apply map_length.
Qed.

Lemma lifted_work it e G y : work_added (addition_on G it) e y = work_added it e (combination (map real G) y).
Proof.
  unfold work_added, Degree.times. cbn [addition_on ball_squares ball_ways]. f_equal. rewrite !map_map. apply map_ext.
  intros way. rewrite <- dot_lift. f_equal. unfold lift, real. rewrite !map_map. apply map_ext. intros g. apply inner_is.
Qed.

Lemma bodies_load k q its (m : BodiesModel.mechanism k) ld : load_of q = Some ld -> several q = Some its ->
  BodiesModel.numbers k = Bodies.numbers_of its -> BodiesModel.coordinates m = dimension q ->
  BodiesModel.bodies m = map real_body (bodies its) -> loaded_by_ball q its m -> is_load ld (BodiesModel.wrench m).
Proof.
  unfold load_of, loaded_by_ball. intros H Sv En D Eb L. destruct (load_ball q) as [b|];
    [|injection H as <-; now apply box_is_load].
  destruct (addition_of b) as [it|] eqn:Ad; [|discriminate]. rewrite Sv in H. injection H as <-.
  destruct L as (w0 & w1 & W & Lw & Wb & ->).
  assert (B : exists n e, is_addition it n e /\ forall z, Rows.dot w1 z = work_added it e z).
  { unfold wrench_of_ball in Wb. destruct (bodies_in_space its); destruct Wb as (w & A & ->);
      [destruct (space_ball b it w Ad A) as (e & Ie)|destruct (plane_ball b it w Ad A) as (e & Ie)]; eauto. }
  destruct B as (n & e & Ie & We). set (G := map (fun ms => of_number_q ms (on_body b)) (unit_motions (dimension q) its)).
  assert (EG : work_on_body m (on_body b) w1 = lift (map real G) w1).
  { unfold work_on_body, lift, G, unit_motions. rewrite !map_map, D. apply map_ext. intros j.
    unfold real. rewrite of_number_real, motions_real, unit_real, En, Eb. reflexivity. }
  assert (LG : List.length G = List.length w0) by (unfold G, unit_motions; rewrite !map_length, seq_length; congruence).
  clearbody G. exists w0, e. split; [exact W|]. split; [|split].
  - rewrite EG, plus_length; [reflexivity|]. unfold lift. rewrite !map_length. exact (PeanoNat.Nat.eq_le_incl _ _ LG).
  - cbn [load_added]. rewrite <- LG. eapply addition_lifts, Ie.
  - intros y. cbn [load_added]. rewrite lifted_work, <- We, EG, Rows.dot_plus, dot_lift. reflexivity.
Qed.

Lemma seen_suits boxes rs : Forall2 seen_in boxes rs -> Forall2 suits (map_all make_row boxes) rs.
Proof.
  rewrite map_all_is. induction 1 as [|b r bs rs S F IH]; cbn; constructor; [|exact IH]. now split.
Qed.

Lemma plane_seen bits c c' b : chosen_contact c c' -> enlarge bits c = Some b -> seen_in b (contact_row c').
Proof. intros Ch B. exact (proj2 (fits_suits (make_row b) _ (conj eq_refl (enlarge_plane _ _ _ _ B Ch)))). Qed.

Lemma plane_signed bits c b c' : enlarge bits c = Some b -> chosen_contact c c' -> box_signed b = true.
Proof.
  unfold enlarge. intros H ((x & y & nx & ny & e & EP & _ & _ & EN & _) & _). rewrite EP, EN in H.
  destruct (numbers bits c _) as [[[p u] k]|]; [|discriminate]. now injection H as <-.
Qed.

Lemma bodies_pose k (row_of : BodiesModel.contact k -> Rows.row)
    (chosen_contact : contact -> BodiesModel.contact k -> Prop) bits q st its m :
  BodiesModel.numbers k = Bodies.numbers_of its ->
  (forall c c' b, chosen_contact c c' -> enlarge_finger bits c = Some b -> seen_in b (row_of c')) ->
  (forall c, List.length (Rows.weights (row_of c)) = List.length (Rows.slips (row_of c))) ->
  setting_of bits q = Some st -> chosen_bodies chosen_contact q its m -> poses q st (mechanism_rows k row_of m).
Proof.
  intros En Seen Lr H Ch. unfold setting_of, rows_of in H. pose proof Ch as (Sv & D & Nu & Eb & _ & _ & W & U & Law).
  rewrite Sv in H. destruct (mechanism_boxes _ _ _ _) as [boxes|] eqn:B; [|discriminate].
  destruct (load_of q) as [ld|] eqn:Ld; [|discriminate]. pose proof (load_grows _ _ Ld) as Grows.
  destruct (good_bound _ _) eqn:Gb; [|discriminate]. injection H as <-. pose proof Nu as (Lw & Lu & _).
  constructor; cbn [rows the_load slipping dimension_of Rows.dimension Rows.wrench Rows.direction Rows.normal mechanism_rows
    pushes make_setting]; rewrite ?Grows; try assumption; try reflexivity; try (now split); try congruence.
  - apply seen_suits. eapply mechanism_seen; eassumption.
  - eapply bodies_load; eassumption.
  - split; [exact Lw|]. apply (mechanism_shapes k row_of m); [|exact Lr]. apply Ch.
Qed.

Lemma choice_poses bits q st s : setting_of bits q = Some st -> choice_of q s -> poses q st s.
Proof.
  intros H C. destruct C as [(g & (Sv & D & F & W & U & N) & ->)|[(g & (Sv & D & F & W & U & N) & ->)|[C|C]]].
  1, 2: unfold setting_of, rows_of in H; rewrite Sv in H;
    destruct (enlarge_all bits (contacts q)) as [rws|] eqn:E; [|discriminate];
    destruct (load_of q) as [ld|] eqn:Ld; [|discriminate]; pose proof (load_grows _ _ Ld) as Grows;
    destruct (good_bound _ _) eqn:Gb; [|discriminate]; injection H as <-;
    (constructor; cbn [make_setting rows the_load slipping dimension_of Rows.dimension Rows.rows Rows.wrench Rows.direction
       Rows.normal grasp_rows space_grasp_rows]; rewrite ?Grows; try assumption; try reflexivity; try (now split);
     try (now apply (plane_load q)); try (now apply (space_load q));
     try (split; [reflexivity|]; apply Forall_map, Forall_forall; intros c _; now repeat constructor)).
  - apply (enlarge_all_suits bits _ _ _ (fun q r => exists c, chosen_contact q c /\ r = contact_row c)) with (2 := E).
    + intros q0 b r B (c & Ch & ->). eapply plane_seen; eassumption.
    + apply Forall2_map_right. eapply Forall2_weaken; [|exact F]. cbv beta. eauto.
  - apply (enlarge_all_suits bits _ _ _ (fun q r => exists c, chosen_contact_in_space q c /\ r = space_contact_row c))
      with (2 := E).
    + intros q0 b r B (c & Ch & ->). eapply enlarge_space; eassumption.
    + apply Forall2_map_right. eapply Forall2_weaken; [|exact F]. cbv beta. eauto.
  - destruct C as (m & (its & Sp & Ch) & ->).
    eapply (bodies_pose BodiesModel.in_plane); try eassumption; [unfold Bodies.numbers_of; now rewrite Sp| |reflexivity].
    intros c c' b Cc B. apply (plane_seen bits c); [exact Cc|]. unfold enlarge_finger in B.
    destruct (enlarge bits c) as [b'|] eqn:E; [|discriminate]. destruct (Qeq_bool (torsion c) 0); [exact B|].
    rewrite (plane_signed bits c b' c') in B by assumption. discriminate.
  - destruct C as (m & (its & Sp & Ch) & ->).
    eapply (bodies_pose BodiesModel.in_space); try eassumption; [unfold Bodies.numbers_of; now rewrite Sp| |].
    + intros c c' b. apply finger_seen.
    + intros t. unfold finger_row. destruct (Req_EM_T _ _); reflexivity.
Qed.

(* Rows are stable with a motion within the bound of the question. *)
Notation stable_in q s := (Rows.stable_at (within_bound q) s).

Lemma within_bounded q d : within_bound q d <-> Rows.bounded (real_bound (max_motion q)) 1 d.
Proof.
  rewrite bounded_real. unfold within_bound. destruct (max_motion q) as [most|]; [|tauto].
  split; intros F; induction F; constructor; try assumption; lra.
Qed.

Lemma stable_bounded q st s l : poses q st s -> Rows.stable_at (Rows.bounded (real_bound (the_bound st)) 1) s l <-> stable_in q s l.
Proof.
  intros []. destruct posed_bound0 as [-> _]. split; intros (d & fs & B & E); exists d, fs; (split; [|exact E]);
    now apply within_bounded.
Qed.

(* What an answer says, of rows. *)
Definition true_of_rows (q : question) (a : answer) : Prop :=
  match a with
  | Stable => forall s, choice_of q s -> stable_in q s 0
  | Unstable => forall s, choice_of q s -> ~ stable_in q s 0
  | Margin intervals => forall s, choice_of q s -> forall l, 0 <= l ->
      (stable_in q s l <-> Exists (among l) intervals)
  | Claims resisted refuted => forall s, choice_of q s -> forall l, 0 <= l ->
      (Exists (among l) resisted -> stable_in q s l) /\
      (Exists (refuted_by l) refuted -> ~ stable_in q s l)
  | Class c => forall s, choice_of q s -> exists mass, masses (inertia q) = Some mass /\
      List.length mass = Rows.dimension s /\
      (good_mass (Rows.dimension s) (map real mass) -> is_of_class c (repeat 0 (Rows.dimension s)) (can_rows mass s))
  | Region pieces => forall s, choice_of q s -> forall u v, load_plane q = Some (u, v) -> Rows.dimension s = 3%nat ->
      forall a b w, (forall y, Rows.dot w y = Rows.dot (Rows.wrench s) y + a * Rows.dot (real u) y + b * Rows.dot (real v) y) ->
      (stable_in q (loaded s w) 0 <-> Exists (in_piece a b) pieces)
  | MayStand | CannotStand | StandsAmong _ _ | StandsWithin _ _ => true_answer q a
  | Rejected _ _ => True
  | NotProvedHere _ => True
  end.

(* What is said of all multiples is said of rows. *)
Lemma of_all_rows q (P : (R -> Prop) -> Prop) : (forall A B, (forall l, A l <-> B l) -> P B -> P A) ->
  (forall s, choice_of q s -> P (Rows.stable_at (within_bound q) s)) -> of_all q P.
Proof.
  intros Same H. unfold of_all. repeat split.
  - intros g C. apply Same with (2 := H (grasp_rows g) (or_introl (ex_intro _ g (conj C eq_refl)))). intros l.
    apply (stable_as_rows (within_bound q)).
  - intros g C. apply Same with (Rows.stable_at (within_bound q) (space_grasp_rows g));
      [intros l; apply (space_stable_as_rows (within_bound q))|].
    apply H. right; left. now exists g.
  - intros m C. apply Same with (Rows.stable_at (within_bound q) (plane_mechanism m)).
    + intros l. destruct C as (its & _ & Ch). apply plane_mechanism_stable. apply Ch.
    + apply H. right; right; left. now exists m.
  - intros m C. apply Same with (Rows.stable_at (within_bound q) (space_mechanism m)).
    + intros l. destruct C as (its & _ & Ch). apply space_mechanism_stable; [apply Ch|].
      destruct Ch as (_ & _ & _ & _ & T & _). clear - T.
      induction T as [|c t cs ts ((_ & _ & N) & _) T IH]; constructor; [exact N|exact IH].
    + apply H. right; right; right. now exists m.
Qed.

Lemma true_of_grasps q a : true_of_rows q a -> true_answer q a.
Proof.
  destruct a as [| |intervals|resisted refuted|c|pieces| | | | | |]; cbn; intros H; try exact I; try exact H.
  1-4: apply of_all_rows; [|exact H]; intros A B E S.
  - now apply E.
  - intros St. now apply S, E.
  - intros l L. rewrite E. now apply S.
  - intros l L. rewrite E. now apply S.
  - split; intros g C.
    + destruct (H (grasp_rows g)) as (m & M & Lm & Cl); [left; now exists g|].
      destruct (plane_mass _ _ M Lm) as (i & In_q & E & G). exists i. split; [exact In_q|].
      apply (plane_class _ g i m E). apply Cl. rewrite E. now apply plane_mass_good.
    + destruct (H (space_grasp_rows g)) as (m & M & Lm & Cl); [right; left; now exists g|].
      destruct (space_mass _ _ M Lm) as (i & In_q & E & G). exists i. split; [exact In_q|].
      apply (space_class _ g i m E). apply Cl. rewrite E. now apply space_mass_good.
  - intros g C a b g' (u & v & Pl & u' & v' & Eu & Ev & ->). rewrite (stable_as_rows (within_bound q)).
    apply (H (grasp_rows g) (or_introl (ex_intro _ g (conj C eq_refl))) u v Pl eq_refl a b
      (motion_list (Model.add (Model.wrench g) (Model.add (Model.scale a u') (Model.scale b v'))))).
    intros y. unfold real. rewrite Eu, Ev. change (three_numbers u') with (motion_list u').
    change (three_numbers v') with (motion_list v'). cbn [grasp_rows Rows.wrench]. rewrite !dot_motion.
    unfold Model.work, Model.add, Model.scale; cbn. ring.
Qed.

Section Correct.
Variable advisor : oracle.

(* Where trees about ranges are accepted, no multiple in these ranges has an equilibrium. *)
Theorem refute_correct q st s ranges nodes lambda : poses q st s ->
  refute advisor q st ranges nodes = None -> 0 <= lambda ->
  Exists (fun r => in_range r lambda) ranges -> ~ stable_in q s lambda.
Proof.
  intros P R L X St. apply (stable_bounded q st s lambda P) in St as (d & fs & Bd & Ld & O & B).
  destruct P. destruct posed_slipping0 as [NS NP], posed_dimension0 as [D _], posed_bound0 as [_ Gb].
  apply (refuted_multiple advisor (most_depth (rows st)) (bilateral q) st ranges nodes s lambda d fs NS NP Gb);
    try assumption.
  - congruence.
  - constructor; try assumption; lra.
Qed.

Lemma posed_fits q st s : poses q st s -> straight st = true -> Forall2 fits (rows st) (Rows.rows s).
Proof.
  intros [Su _ _ _ _ _ _ _ _] St. unfold straight in St. revert St.
  induction Su as [|row r rows rs H Su IH]; intros St; constructor; cbn in St; apply andb_true_iff in St as [Sr St].
  - apply suits_fits; [exact H|]. now apply negb_true_iff.
  - now apply IH.
Qed.

Lemma posed_in_setting q st s : poses q st s -> in_setting st s.
Proof.
  intros P. destruct P.
  destruct posed_slipping0 as [NS NP], posed_dimension0 as [D1 D2], posed_shapes0 as [Lw Sh].
  constructor; try congruence.
  - unfold contains. now repeat split.
  - rewrite D1. clear - posed_rows0 Sh. revert Sh.
    induction posed_rows0 as [|row r rows rs [_ Se] P IH]; intros Sh; constructor.
    + destruct (Forall_inv Sh) as (A & B & C). now apply (seen_proper _ (box row)).
    + apply IH. exact (Forall_inv_tail Sh).
  - split; congruence.
  - apply posed_bound0.
Qed.

Lemma one_grasp q st s : poses q st s -> is_one_grasp st = true ->
  exact_rows (rows st) = true /\ exact_load (the_load st) s /\ straight st = true.
Proof.
  intros [] X. unfold is_one_grasp in X. apply andb_true_iff in X as [X1 X2].
  split; [exact X1|]. split; [now constructor|].
  unfold straight, exact_rows in *. rewrite forallb_forall in *. intros r Hr. specialize (X1 r Hr).
  unfold exact_box in X1. rewrite !andb_true_iff in X1. tauto.
Qed.

Lemma joined_holds l resisted lo hi : Exists (among l) (joined resisted lo hi) ->
  among l (lo, hi) \/ Exists (among l) resisted.
Proof.
  unfold joined. assert (Plain : Exists (among l) ((lo, hi) :: resisted) -> among l (lo, hi) \/ Exists (among l) resisted)
    by (intros E; inversion E; subst; auto).
  destruct resisted as [|[lo' [hi'|]] rest]; [exact Plain| |exact Plain].
  destruct (Qeq_bool hi' lo) eqn:T; [|exact Plain].
  apply Qeq_bool_R in T. intros E. inversion E as [? ? [A B]|]; subst; [|right; now apply Exists_cons_tl].
  cbn [fst snd] in *. destruct (Rle_dec l (Q2R hi')) as [H|H].
  - right. apply Exists_cons_hd. now split.
  - left. split; cbn [fst snd]; [lra|exact B].
Qed.

Lemma in_order_from stable before lo hi b : in_order stable before lo hi = true -> before = Some b ->
  Q2R b <= Q2R lo /\ match hi with Some h => Q2R lo <= Q2R h | None => True end.
Proof.
  intros H ->. unfold in_order in H. apply andb_true_iff in H as [H1 H2]. split; [now apply Qle_bool_R|].
  destruct hi as [h|]; [|exact I]. destruct stable; [now apply Qle_bool_R|]. left. now apply Qlt_bool_R.
Qed.

Lemma evidence_holds q st number lo hi evidence s l : poses q st s ->
  holding_fails advisor q st number lo hi evidence = None ->
  (hi = None -> Qeq_bool lo 0 && unloaded st && negb (is_bounded st) = true) -> 0 <= l -> among l (lo, hi) -> stable_in q s l.
Proof.
  intros P H Whole L [A B]. apply (stable_bounded q st s l P). cbn [fst snd] in A, B. unfold holding_fails in H.
  set (low := match hi with None => 1%Q | Some _ => lo end) in *.
  set (high := match hi with None => 1%Q | Some h => h end) in *.
  pose proof (posed_in_setting _ _ _ P) as In_s.
  (* From low to high, or 1 alone. *)
  assert (Here : (forall l, Q2R low <= l <= Q2R high -> Rows.stable_at (Rows.bounded (real_bound (the_bound st)) 1) s l) ->
    Rows.stable_at (Rows.bounded (real_bound (the_bound st)) 1) s l).
  { intros St. destruct hi as [h|]; [apply St; unfold low, high; lra|].
    specialize (Whole eq_refl). rewrite !andb_true_iff in Whole. destruct Whole as [[_ U] NB].
    assert (None_ : the_bound st = None) by (unfold is_bounded in NB; destruct (the_bound st); [discriminate|reflexivity]).
    apply (unloaded_stable s st l In_s U L None_). apply St. unfold low, high. rewrite Q2R_1. lra. }
  destruct evidence as [p|points].
  - destruct (part_fails _ _ _ _ _ _ _) as [[rule node]|] eqn:K; [discriminate|]. apply Here. intros l' L'.
    exact (part_stable _ _ _ s (posed_law _ _ _ P) _ _ _ _ l' K In_s L').
  - destruct (is_one_grasp st) eqn:X; [cbn [negb] in H|discriminate].
    destruct (one_grasp _ _ _ P X) as (E & Lo & Sg). pose proof (posed_fits _ _ _ P Sg) as Fi.
    destruct P. destruct posed_dimension0 as [_ D]. rewrite D in H.
    apply Here. intros l' [L1 L2]. destruct points as [|w more]; [discriminate|].
    destruct (check_at _ _ _ _ _ (Point (Some low) w)) as [ss|] eqn:K; [|discriminate].
    destruct more as [|w' more].
    + destruct (Qeq_bool low high) eqn:T; [|discriminate]. apply Qeq_bool_R in T.
      replace l' with (Q2R low) by lra. eapply point_resists; try eassumption. reflexivity.
    + destruct (check_at _ _ _ _ _ (Point (Some high) w')) as [ss'|] eqn:K'; [|discriminate].
      destruct (same_mode ss ss') eqn:M; [|discriminate].
      exact (segment_resists _ _ _ _ _ Fi E Lo posed_law0 _ _ _ _ low l' K K' M eq_refl L1 L2).
Qed.

Theorem claims_true q st : (forall s, choice_of q s -> poses q st s) ->
  forall claims before number resisted refuted,
  match before with Some b => 0 <= Q2R b | None => True end ->
  true_of_rows q (Claims (rev_append resisted []) (rev_append refuted [])) ->
  true_of_rows q (check_claims advisor q st claims before number resisted refuted).
Proof.
  intros P. induction claims as [|cl claims IH]; intros before number resisted refuted B0 T; cbn [check_claims];
    [exact T|].
  assert (T' : forall s, choice_of q s -> forall l, 0 <= l ->
    (Exists (among l) resisted -> stable_in q s l) /\ (Exists (refuted_by l) refuted -> ~ stable_in q s l)).
  { intros s C l L. destruct (T s C l L) as [A B]. rewrite !rev_append_rev, !app_nil_r in *.
    split; intros E; [apply A|apply B]; now apply Exists_rev. }
  assert (Back : forall resisted' refuted',
    (forall s, choice_of q s -> forall l, 0 <= l ->
      (Exists (among l) resisted' -> stable_in q s l) /\ (Exists (refuted_by l) refuted' -> ~ stable_in q s l)) ->
    true_of_rows q (Claims (rev_append resisted' []) (rev_append refuted' []))).
  { intros r1 r2 H s C l L. rewrite !rev_append_rev, !app_nil_r. destruct (H s C l L) as [A B].
    split; intros E; apply Exists_rev in E; rewrite rev_involutive in E; [now apply A|now apply B]. }
  destruct cl as [lo hi evidence|lo hi nodes].
  - destruct (in_order true before lo hi) eqn:O; [cbn [negb]|exact I].
    destruct before as [b|]; [|discriminate]. destruct (in_order_from _ _ _ _ b O eq_refl) as [O1 O2].
    destruct (match hi with None => _ | Some _ => false end) eqn:Wh; [exact I|].
    destruct (holding_fails advisor q st number lo hi evidence) as [a|] eqn:K.
    { destruct a; try exact I; exfalso; revert K; clear; unfold holding_fails;
        repeat match goal with |- context [match ?x with _ => _ end] => destruct x end; discriminate. }
    apply IH; [destruct hi; [lra|exact I]|]. apply Back. intros s C l L. destruct (T' s C l L) as [A B].
    split; [|exact B]. intros E. apply joined_holds in E as [E|E]; [|now apply A].
    apply (evidence_holds q st number lo hi evidence s l (P s C) K); try assumption.
    intros ->. now apply negb_false_iff.
  - destruct (in_order false before lo hi) eqn:O; [cbn [negb]|exact I].
    destruct before as [b|]; [|discriminate]. destruct (in_order_from _ _ _ _ b O eq_refl) as [O1 O2].
    set (with_low := match number with O => _ | S _ => false end).
    destruct (refute _ _ _ _ _) as [[rule node]|] eqn:R; [exact I|].
    apply IH; [destruct hi; [lra|exact I]|]. apply Back. intros s C l L. destruct (T' s C l L) as [A B].
    split; [exact A|]. intros E. apply Exists_cons in E as [E|E]; [|now apply B].
    unfold refuted_by in E. destruct E as [Lo Hi].
    apply (refute_correct q st s _ _ l (P s C) R L). constructor. unfold in_range; cbn [range_low range_high open_low open_high].
    split; [destruct Lo as [Lo|[_ Lo]]; lra|]. split.
    + intros N. destruct Lo as [Lo|[Wl _]]; [exact Lo|]. fold with_low in Wl. rewrite Wl in N. discriminate.
    + destruct hi as [h|]; [|exact I]. split; [lra|auto].
Qed.

Theorem motions_of_rows q c : true_of_rows q (check_motions advisor q c).
Proof.
  unfold check_motions. destruct (setting_of (bits c) q) as [st|] eqn:S; [|exact I].
  assert (P := fun s => choice_poses _ _ _ s S).
  assert (Rigid_ : forall p, true_of_rows q (match inertia q with
      | [] => NotProvedHere "a proof of something else than was asked"
      | _ => check_class q st p
      end)).
  { intros p. assert (Go : true_of_rows q (check_class q st p)); [|destruct (inertia q); [exact I|exact Go]].
    unfold check_class. destruct (masses (inertia q)) as [mass|] eqn:M; [|exact I].
    destruct (all_some rigid_of (rows st)) as [xs|] eqn:X; [|exact I].
    destruct (_ && _ && _) eqn:Ch; [|exact I]. rewrite !andb_true_iff in Ch. destruct Ch as [[Lm St] Ce].
    destruct (class_fails _ _ _ _ p) as [[rule [k|]]|] eqn:Cf; try exact I.
    intros s C. specialize (P s C). pose proof (posed_fits q st s P St) as Fi. destruct P. destruct posed_dimension0 as [_ D].
    apply Nat.eqb_eq in Lm. exists mass. split; [exact M|]. split; [congruence|]. intros (_ & Sym & Pos).
    apply (class_holds mass (map low (load_box (the_load st))) s xs) with (most := most_depth (rows st)); try assumption.
    - now apply all_rigid with (rows st).
    - exact (one_load_is _ _ Ce posed_wrench0).
    - congruence. }
  assert (Region_ : forall pieces nodes, true_of_rows q (check_region advisor q st pieces nodes)).
  { intros pieces nodes. unfold check_region. destruct (load_plane q) as [[u v]|] eqn:Pl; [|exact I].
    destruct (_ && _) eqn:Ch; [|exact I]. rewrite !andb_true_iff in Ch. destruct Ch as [[[[[[D3 X] NB] Lw] Lu] Lv] G].
    destruct (pieces_fail _ _ _ _ _ _ _ _) as [[? ?]|] eqn:Pf; [exact I|].
    destruct (plane_fails _ _ _ _ _ _ _ _ _ _) as [[? ?]|] eqn:Tf; [exact I|].
    apply Nat.eqb_eq in D3, Lw, Lu, Lv.
    intros s C u' v' Pl' _ a b w Ew. rewrite Pl in Pl'. injection Pl' as <- <-. specialize (P s C).
    assert (St : stable_in q (loaded s w) 0 <-> Rows.stable_at (Rows.bounded None 1) (loaded s w) 0).
    { pose proof (proj1 (posed_bound _ _ _ P)) as Eb. unfold is_bounded in NB. rewrite Eb in NB.
      unfold within_bound. now destruct (max_motion q). }
    rewrite St. clear St.
    destruct (one_grasp _ _ _ P X) as (E & Lo & Sg). pose proof (posed_fits _ _ _ P Sg) as Fi. destruct P.
    destruct posed_dimension0 as [_ D]. rewrite D in *. destruct Lo as [L1 L2 _ _].
    pose proof (one_load_is _ _ L1 L2) as W. pose proof (one_load_box _ _ L1 L2) as Wb.
    unfold one_load in L1. apply andb_true_iff in L1 as [L1 _].
    split; intros H.
    - refine (plane_covered advisor (most_depth (rows st)) (bilateral q) (rows st) (load_box (the_load st)) u v s
        (map (map load_part) pieces) nodes a b w Fi Wb _ _ posed_law0 Tf Ew H); [|congruence].
      destruct posed_shapes0 as [_ Sh]. eapply Forall_impl; [|exact Sh]. intros r (A & B & _). now split.
    - refine (piece_resisted _ (rows st) (load_box (the_load st)) u v s Fi E L1 W Wb _ _ posed_law0 pieces 0 a b w Pf _ Ew H);
        [congruence|congruence|]. now apply (nothing_grows (rows st)). }
  destruct (body c) as [w|parts|nodes|resisted segments nodes|claims|p|p|pieces nodes];
    [| | | | |now apply Rigid_|destruct (is_margin q); exact I|now apply Region_]; destruct (is_margin q); try exact I.
  - (* a witness *)
    unfold check_witness. destruct (is_one_grasp st) eqn:X; [|exact I].
    destruct (check_at _ _ _ _ _ _) as [ss|] eqn:W; [|exact I]. intros s C. specialize (P s C). apply (stable_bounded q st s 0 P).
    destruct (one_grasp _ _ _ P X) as (E & L & Sg). pose proof (posed_fits _ _ _ P Sg) as Fi.
    destruct P. destruct posed_dimension0 as [_ D]. rewrite D in W.
    replace 0 with (Q2R 0) by apply Q2R_0.
    eapply point_resists; try eassumption. reflexivity.
  - (* parts *)
    unfold check_parts. destruct (parts_fail _ _ _ _ _ _) as [[rule at_]|] eqn:Pf; [exact I|].
    intros s C. specialize (P s C).
    pose proof (parts_stable advisor _ _ s (posed_law _ _ _ P) _ _ _ Pf) as A. apply (stable_bounded q st s 0 P).
    apply (Forall_inv A). cbn. now apply posed_in_setting with q.
  - (* a tree *)
    unfold check_tree. destruct (refute _ _ _ _ _) as [[rule number]|] eqn:R; [exact I|].
    intros s C. apply (refute_correct q st s _ _ 0 (P s C) R (Rle_refl 0)).
    constructor. unfold in_range, at_zero; cbn. rewrite Q2R_0.
    repeat split; try discriminate; lra.
  - (* a margin *)
    unfold check_margin. destruct (is_one_grasp st) eqn:X; [|exact I].
    destruct (order_fails _ _ resisted 0); [exact I|].
    destruct (segments_fail _ _ _ _ _ _ _ segments resisted None None 0) as [[rule at_]|] eqn:SF; [exact I|].
    destruct (refute _ _ _ _ _) as [[rule number]|] eqn:R; [exact I|].
    intros s C lambda L0. specialize (P s C). destruct (one_grasp _ _ _ P X) as (E & L & Sg). split.
    + intros St. destruct (gaps_cover resisted lambda L0) as [A|G]; [exact A|].
      exfalso. exact (refute_correct q st s _ nodes lambda P R L0 G St).
    + intros A. apply (stable_bounded q st s lambda P). pose proof (posed_in_setting q st s P) as In_s. pose proof (posed_fits _ _ _ P Sg) as Fi. destruct P. destruct posed_dimension0 as [_ D].
      rewrite D in SF. eapply segments_resist; try eassumption; [|discriminate|].
      { intros a b d1 d2 walls direction tree l Hd Z La Lb.
        eapply (segment_by_degree_resists advisor); eassumption. }
      destruct resisted as [|[lo hi] resisted']; inversion A; subst; [left|right]; assumption.
  - (* claims *)
    apply claims_true; [exact P|rewrite Q2R_0; lra|].
    intros s C l L. split; intros E; inversion E.
Qed.

(* Whatever the certificate and the oracle's advice are, the answer is true. *)
Theorem check_correct q c : true_answer q (check advisor q c).
Proof.
  unfold check. destruct (body c) eqn:B; try (apply true_of_grasps, motions_of_rows). apply statics_true.
Qed.

End Correct.
