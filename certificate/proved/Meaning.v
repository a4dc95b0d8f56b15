(* SPDX-License-Identifier: MIT *)
(* Which grasps (Model.v, SpaceModel.v, BodiesModel.v) a question (Question.v) is about: one, or if numbers are uncertain a
   box of them (FORMAT.md section 6); and what an answer claims about them. *)
From Coq Require Import Reals List QArith Qreals.
From Proved Require Import Question RigidModel StaticsModel.
From Proved Require Rows Model SpaceModel BodiesModel.
Import ListNotations.
Open Scope R_scope.

Definition within (i : interval) (x : R) := Q2R (low i) <= x <= Q2R (high i).

(* n = n0 + e t0 with |e| <= slope, where n0 is the normal of the file and t0 is n0 turned
   left. *)
Definition chosen_contact (q : contact) (c : Model.contact) :=
  (exists x y nx ny e,
     position q = [x; y] /\ within x (Model.px c) /\ within y (Model.py c) /\
     normal q = [nx; ny] /\ - Q2R (slope q) <= e <= Q2R (slope q) /\
     Model.nx c = Q2R nx - e * Q2R ny /\ Model.ny c = Q2R ny + e * Q2R nx) /\
  within (friction q) (Model.friction c) /\
  within (stiffness q) (Model.stiffness c) /\
  within (preload q) (Model.preload c) /\
  Model.growth c = Q2R (preload_growth q).

Definition law_of (q : question) : Model.law := if bilateral q then Model.bilateral else Model.unilateral.

Definition three_numbers (w : Model.vector) : list R := [Model.along_x w; Model.along_y w; Model.about_z w].

(* A ball has the forces and torques of these squares. *)
Definition in_ball (b : ball) (force torque : R) :=
  force + torque / (Q2R (torque_length b) * Q2R (torque_length b)) <= Q2R (radius b) * Q2R (radius b).

(* What a ball adds to w: a force and a torque at its point; without one, nothing. *)
Definition added (b : option ball) (w : Model.vector) : Prop :=
  match b with
  | None => w = Model.zero
  | Some b => exists x y fx fy t, map Q2R (about b) = [x; y] /\ in_ball b (fx * fx + fy * fy) (t * t) /\
      w = Model.add (Model.force_at x y fx fy) (Model.Vector 0 0 t)
  end.

Definition chosen (q : question) (g : Model.grasp) :=
  several q = None /\
  dimension q = 3%nat /\
  Forall2 chosen_contact (contacts q) (Model.contacts g) /\
  (exists w0 w1, Forall2 within (wrench q) (three_numbers w0) /\ added (load_ball q) w1 /\
     Model.wrench g = Model.add w0 w1) /\
  map Q2R (direction q) = three_numbers (Model.direction g) /\
  Model.normal g = law_of q.

(* The same in space, where n0 may turn every way: n = n0 + t with t across n0, and the tangent of
   the angle, |t| / |n0|, at most the slope. *)
Definition vector_of_three (q1 q2 q3 : Q) := SpaceModel.Vector (Q2R q1) (Q2R q2) (Q2R q3).

Definition chosen_contact_in_space (q : contact) (c : SpaceModel.contact) :=
  (exists x y z nx ny nz t,
     position q = [x; y; z] /\ normal q = [nx; ny; nz] /\
     within x (SpaceModel.x (SpaceModel.position c)) /\
     within y (SpaceModel.y (SpaceModel.position c)) /\
     within z (SpaceModel.z (SpaceModel.position c)) /\
     let n0 := vector_of_three nx ny nz in
     SpaceModel.dot n0 t = 0 /\
     SpaceModel.dot t t <= Q2R (slope q) * Q2R (slope q) * SpaceModel.dot n0 n0 /\
     SpaceModel.normal c = SpaceModel.add n0 t) /\
  within (friction q) (SpaceModel.friction c) /\
  within (stiffness q) (SpaceModel.stiffness c) /\
  within (preload q) (SpaceModel.preload c) /\
  SpaceModel.growth c = Q2R (preload_growth q).

Definition six_numbers (w : SpaceModel.screw) : list R :=
  let f := SpaceModel.linear w in
  let t := SpaceModel.angular w in
  [SpaceModel.x f; SpaceModel.y f; SpaceModel.z f; SpaceModel.x t; SpaceModel.y t; SpaceModel.z t].

Definition added_in_space (b : option ball) (w : SpaceModel.screw) : Prop :=
  match b with
  | None => w = SpaceModel.no_screw
  | Some b => exists p f t, map Q2R (about b) = [SpaceModel.x p; SpaceModel.y p; SpaceModel.z p] /\
      in_ball b (SpaceModel.dot f f) (SpaceModel.dot t t) /\
      w = SpaceModel.add_screw (SpaceModel.force_at p f) (SpaceModel.Screw SpaceModel.zero t)
  end.

Definition chosen_in_space (q : question) (g : SpaceModel.grasp) :=
  several q = None /\
  dimension q = 6%nat /\
  Forall2 chosen_contact_in_space (contacts q) (SpaceModel.contacts g) /\
  (exists w0 w1, Forall2 within (wrench q) (six_numbers w0) /\ added_in_space (load_ball q) w1 /\
     SpaceModel.wrench g = SpaceModel.add_screw w0 w1) /\
  map Q2R (direction q) = six_numbers (SpaceModel.direction g) /\
  SpaceModel.normal_law g = law_of q.

(* Of several bodies, which meet in contacts chosen so.  Hinges, slides and levers are not uncertain. *)
Definition real_body (b : rigid_body) : BodiesModel.rigid_body :=
  match b with
  | Free first => BodiesModel.Free first
  | Link on eta turns => BodiesModel.Link on (map Q2R eta) (map Q2R turns)
  end.

Definition chosen_element (q : element) (e : BodiesModel.element) :=
  BodiesModel.lever e = map Q2R (lever q) /\
  BodiesModel.is_spring e = element_spring q /\
  within (element_stiffness q) (BodiesModel.stiffness e) /\
  within (element_preload q) (BodiesModel.preload e) /\
  BodiesModel.growth e = Q2R (element_growth q).

(* A wrench of a ball, as the numbers of which one body's motions have as many. *)
Definition wrench_of_ball (in_space : bool) (b : ball) (numbers : list R) : Prop :=
  if in_space then exists w, added_in_space (Some b) w /\ numbers = six_numbers w
  else exists w, added (Some b) w /\ numbers = three_numbers w.

(* The work that a wrench on a body does in a unit of each coordinate. *)
Definition work_on_body {k : BodiesModel.kind} (m : BodiesModel.mechanism k) (b : option nat) (numbers : list R) : list R :=
  map (fun j => Rows.dot numbers (BodiesModel.of_number
                  (BodiesModel.motions (BodiesModel.numbers k) (repeat 0 j ++ [1]) (BodiesModel.bodies m) []) b))
    (seq 0 (BodiesModel.coordinates m)).

Definition loaded_by_ball {k : BodiesModel.kind} (q : question) (its : mechanism) (m : BodiesModel.mechanism k) : Prop :=
  match load_ball q with
  | None => Forall2 within (wrench q) (BodiesModel.wrench m)
  | Some b => exists w0 w1, Forall2 within (wrench q) w0 /\ List.length w0 = BodiesModel.coordinates m /\
      wrench_of_ball (bodies_in_space its) b w1 /\
      BodiesModel.wrench m = Rows.plus w0 (work_on_body m (on_body b) w1)
  end.

Definition chosen_bodies {k : BodiesModel.kind} (chosen_contact : contact -> BodiesModel.contact k -> Prop)
    (q : question) (its : mechanism) (m : BodiesModel.mechanism k) :=
  several q = Some its /\
  BodiesModel.coordinates m = dimension q /\
  BodiesModel.has_all_numbers m /\
  BodiesModel.bodies m = map real_body (bodies its) /\
  Forall2 (fun c t => chosen_contact c (BodiesModel.touching t) /\
             BodiesModel.of_body t = of_body c /\ BodiesModel.by_body t = by_body c)
    (contacts q) (BodiesModel.touches m) /\
  Forall2 chosen_element (elements its) (BodiesModel.elements m) /\
  loaded_by_ball q its m /\
  map Q2R (direction q) = BodiesModel.direction m /\
  BodiesModel.normal m = law_of q.

Definition chosen_bodies_in_plane (q : question) (m : BodiesModel.mechanism BodiesModel.in_plane) :=
  exists its, bodies_in_space its = false /\ chosen_bodies (k := BodiesModel.in_plane) chosen_contact q its m.

Definition chosen_finger (q : contact) (t : BodiesModel.finger) :=
  chosen_contact_in_space q (BodiesModel.hard t) /\
  BodiesModel.torsion t = Q2R (torsion q) /\
  SpaceModel.normal (BodiesModel.hard t) <> SpaceModel.zero.

Definition chosen_bodies_in_space (q : question) (m : BodiesModel.mechanism BodiesModel.in_space) :=
  exists its, bodies_in_space its = true /\ chosen_bodies (k := BodiesModel.in_space) chosen_finger q its m.

(* Motions of equilibria are within the bound of the question, if it has one. *)
Definition within_bound (q : question) (d : list R) : Prop :=
  match max_motion q with None => True | Some most => Forall2 (fun b x => Rabs x <= Q2R b) most d end.

(* What is true of all that a question is about, of the multiples at which each is stable. *)
Definition of_all (q : question) (P : (R -> Prop) -> Prop) : Prop :=
  (forall g, chosen q g -> P (Model.stable_at (fun d => within_bound q (three_numbers d)) g)) /\
  (forall g, chosen_in_space q g -> P (SpaceModel.stable_at (fun d => within_bound q (six_numbers d)) g)) /\
  (forall m, chosen_bodies_in_plane q m -> P (BodiesModel.stable_at (within_bound q) m)) /\
  (forall m, chosen_bodies_in_space q m -> P (BodiesModel.stable_at (within_bound q) m)).

Definition among (l : R) (i : Q * option Q) :=
  Q2R (fst i) <= l /\ match snd i with Some h => l <= Q2R h | None => True end.

Definition refuted_by (l : R) (r : Q * option Q * bool) :=
  let '(lo, hi, with_low) := r in
  (Q2R lo < l \/ with_low = true /\ l = Q2R lo) /\ match hi with Some h => l < Q2R h | None => True end.

(* The inertia of a question about rigid contacts: its numbers. *)
Definition inertia_of (numbers : list Q) (m : inertia_in_plane) : Prop :=
  map Q2R numbers = [center_x m; center_y m; gyration_squared m].

Definition inertia_of_space (numbers : list Q) (m : inertia_in_space) : Prop :=
  let c := center m in
  let t := about_center m in
  map Q2R numbers = [SpaceModel.x c; SpaceModel.y c; SpaceModel.z c; xx t; yy t; zz t; xy t; xz t; yz t].

Definition is_of_class {A : Type} (c : class) (at_rest : A) (can : A -> Prop) : Prop :=
  match c with
  | MustMove => must_move at_rest can
  | MustHold => must_hold at_rest can
  | Open => is_open at_rest can
  end.

(* The grasp under the load of s and t in the plane of a question. *)
Definition in_plane (q : question) (g : Model.grasp) (s t : R) (g' : Model.grasp) : Prop :=
  exists u v, load_plane q = Some (u, v) /\ exists u' v', map Q2R u = three_numbers u' /\ map Q2R v = three_numbers v' /\
    g' = Model.Grasp (Model.contacts g)
           (Model.add (Model.wrench g) (Model.add (Model.scale s u') (Model.scale t v'))) (Model.direction g) (Model.normal g).

(* Sums of multiples >= 0 of points; a piece of the plane is where (1, s, t) is such a sum. *)
Inductive sum_of (points : list (Q * Q * Q)) : R -> R -> R -> Prop :=
  | nothing : sum_of points 0 0 0
  | one_more c a b e h s t : 0 <= c -> In (a, b, e) points -> sum_of points h s t ->
      sum_of points (c * Q2R a + h) (c * Q2R b + s) (c * Q2R e + t).

Definition in_piece (s t : R) (points : list (Q * Q * Q)) := sum_of points 1 s t.

(* Of statics, the same of all that a question is about: which loads may stand, and its load. *)
Definition of_statics (q : question) (P : (list R -> Prop) -> list R -> Prop) : Prop :=
  forall factor, statics q = Some factor -> let phi := Q2R factor in
  (forall g, chosen q g ->
     P (fun w => may_stand_in_plane phi g (BodiesModel.motion_of w)) (three_numbers (Model.wrench g))) /\
  (forall g, chosen_in_space q g ->
     P (fun w => may_stand_in_space phi g (BodiesModel.screw_of w)) (six_numbers (SpaceModel.wrench g))) /\
  (forall m, chosen_bodies_in_plane q m ->
     P (may_stand (k := BodiesModel.in_plane) (in_cone phi) m) (BodiesModel.wrench m)) /\
  (forall m, chosen_bodies_in_space q m ->
     P (may_stand (k := BodiesModel.in_space) (in_cone_of_finger phi) m) (BodiesModel.wrench m)).

Definition between (l : R) (ends : option Q * option Q) : Prop :=
  match fst ends with Some a => Q2R a <= l | None => True end /\
  match snd ends with Some b => l <= Q2R b | None => True end.

Definition beyond (l : R) (moves : option Q * option Q * bool) : Prop :=
  let '(below, above, all) := moves in
  match below with Some b => l < Q2R b | None => False end \/
  match above with Some a => Q2R a < l | None => False end \/ all = true.

Definition above_0 (s t : R) (form : Q * Q * Q) : Prop :=
  let '(a, b, c) := form in 0 < Q2R a + s * Q2R b + t * Q2R c.

(* What an answer says about a question.  That a certificate is rejected says nothing. *)
Definition true_answer (q : question) (a : answer) : Prop :=
  match a with
  | Stable => of_all q (fun stable_at => stable_at 0)
  | Unstable => of_all q (fun stable_at => ~ stable_at 0)
  | Margin intervals => of_all q (fun stable_at => forall l, 0 <= l -> (stable_at l <-> Exists (among l) intervals))
  | Claims resisted refuted => of_all q (fun stable_at => forall l, 0 <= l ->
      (Exists (among l) resisted -> stable_at l) /\ (Exists (refuted_by l) refuted -> ~ stable_at l))
  | Class c =>
      (forall g, chosen q g -> exists m, inertia_of (inertia q) m /\ is_of_class c Model.zero (can g m)) /\
      (forall g, chosen_in_space q g -> exists m, inertia_of_space (inertia q) m /\
         is_of_class c SpaceModel.no_screw (can_in_space g m))
  | Region pieces =>
      forall g, chosen q g -> forall s t g', in_plane q g s t g' ->
        (Model.stable_at (fun d => within_bound q (three_numbers d)) g' 0 <-> Exists (in_piece s t) pieces)
  | MayStand => of_statics q (fun may_stand w => may_stand w)
  | CannotStand => of_statics q (fun may_stand w => ~ may_stand w)
  | StandsAmong multiples moves => of_statics q (fun may_stand w => forall l,
      let load := Rows.plus w (Rows.scaled l (map Q2R (direction q))) in
      (forall ends, multiples = Some ends -> between l ends -> may_stand load) /\
      (beyond l moves -> ~ may_stand load))
  | StandsWithin points forms => of_statics q (fun may_stand w => forall u v, load_plane q = Some (u, v) -> forall s t,
      let load := Rows.plus w (Rows.plus (Rows.scaled s (map Q2R u)) (Rows.scaled t (map Q2R v))) in
      (in_piece s t points -> may_stand load) /\
      (Exists (above_0 s t) forms -> ~ may_stand load))
  | Rejected _ _ => True
  | NotProvedHere _ => True
  end.
