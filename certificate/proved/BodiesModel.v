(* SPDX-License-Identifier: MIT *)
(* Several bodies, over the real numbers (FORMAT.md section 14), which meet in contacts of Model.v or SpaceModel.v.

   A motion of a body is a list of numbers, a translation and a small rotation about the common origin: 3 in the plane,
   6 in space.  A state, a motion of all bodies, is a list of D coordinates.  (dot, plus and scaled are those of Rows.v:
   lists end in zeros.)  Hinges and slides are ideal: balance is that in no state that they allow work is done. *)
From Coq Require Import Reals List.
From Proved Require Model SpaceModel.
From Proved Require Import Rows.
Import ListNotations.
Open Scope R_scope.

(* What a body in the plane and one in space are to what follows.  Motions are those of the point's body, as it is
   seen from the other. *)
Record kind := Kind {
  contact : Type;
  force : Type;
  numbers : nat;                                                            (* of a motion *)
  obeys : Model.law -> R -> list R -> contact -> force -> Prop;
  works : contact -> force -> list R -> R
}.

Definition at_ (d : list R) (k : nat) : R := nth k d 0.
Definition motion_of (d : list R) : Model.vector := Model.Vector (at_ d 0) (at_ d 1) (at_ d 2).
Definition screw_of (d : list R) : SpaceModel.screw :=
  SpaceModel.Screw (SpaceModel.Vector (at_ d 0) (at_ d 1) (at_ d 2)) (SpaceModel.Vector (at_ d 3) (at_ d 4) (at_ d 5)).

Definition in_plane : kind := Kind Model.contact (R * R) 3
  (fun l lambda d => Model.obeys l lambda (motion_of d))
  (fun c f d => Model.work (Model.contact_wrench c f) (motion_of d)).

(* In space a contact may resist turning about its normal (FORMAT.md section 15): it has a length e >= 0, of a soft
   finger above 0.  A force is then a, f, and the moment m n about the normal; its cone is an ellipsoid: where e > 0,
   |f|^2 + (|m n| / e)^2 is at most (mu times the normal force)^2.  It is against slip and turn. *)
Record finger := Finger { hard : SpaceModel.contact; torsion : R }.

Definition turn (c : SpaceModel.contact) (d : SpaceModel.screw) : R :=
  SpaceModel.dot (SpaceModel.normal c) (SpaceModel.angular d).

(* e^2 / L^2 *)
Definition gamma (t : finger) : R :=
  torsion t * torsion t / SpaceModel.dot (SpaceModel.normal (hard t)) (SpaceModel.normal (hard t)).

Definition finger_obeys (l : Model.law) (lambda : R) (d : SpaceModel.screw) (t : finger) (force : R * SpaceModel.vector * R) :=
  let '(a, f, m) := force in
  let c := hard t in
  let most := SpaceModel.friction c * SpaceModel.length c * a in
  let s := SpaceModel.slip c d in
  let slips := sqrt (SpaceModel.dot s s + gamma t * (turn c d * turn c d)) in
  Model.normal_law l (SpaceModel.v c lambda d) a /\
  SpaceModel.dot f (SpaceModel.normal c) = 0 /\
  SpaceModel.norm f <= most /\
  gamma t * SpaceModel.dot f f + m * m <= gamma t * (most * most) /\
  (0 < slips -> f = SpaceModel.scale (- (most / slips)) s /\ m = - (most / slips) * (gamma t * turn c d)).

Definition finger_works (t : finger) (force : R * SpaceModel.vector * R) (d : SpaceModel.screw) : R :=
  let '(a, f, m) := force in
  SpaceModel.work (SpaceModel.contact_wrench (hard t) (a, f)) d + m * turn (hard t) d.

Definition in_space : kind := Kind finger (R * SpaceModel.vector * R) 6
  (fun l lambda d => finger_obeys l lambda (screw_of d))
  (fun t f d => finger_works t f (screw_of d)).

(* A body is free: its motion is the coordinates from the first one on.  Or it is a link on a body, as its number, or on
   the ground, None: it moves as that does, and by eta, of its hinge or slide, times the sum of turns times coordinates. *)
Inductive rigid_body :=
  | Free (first : nat)
  | Link (on : option nat) (eta turns : list R).

Definition of_number (motions : list (list R)) (b : option nat) : list R :=
  match b with Some number => nth number motions [] | None => [] end.

Definition motion_of_body (n : nat) (d : list R) (before : list (list R)) (b : rigid_body) : list R :=
  match b with
  | Free first => firstn n (skipn first d)
  | Link on eta turns => plus (of_number before on) (scaled (dot turns d) eta)
  end.

Fixpoint motions (n : nat) (d : list R) (bodies : list rigid_body) (before : list (list R)) : list (list R) :=
  match bodies with
  | [] => before
  | b :: rest => motions n d rest (before ++ [motion_of_body n d before b])
  end.

(* A ratchet or a spring, which gives way by lever.d, and pulls back. *)
Record element := Element { lever : list R; is_spring : bool; stiffness : R; preload : R; growth : R }.

Definition pull_obeys (l : Model.law) (lambda : R) (d : list R) (e : element) (a : R) : Prop :=
  let v := preload e + lambda * growth e - stiffness e * dot (lever e) d in
  if is_spring e then a = v else Model.normal_law l v a.

(* A contact, of a body that its normal points into, by another. *)
Record touch (k : kind) := Touch { touching : contact k; of_body : option nat; by_body : option nat }.

Record mechanism (k : kind) := Mechanism {
  coordinates : nat;            (* D *)
  bodies : list rigid_body;           (* each after the one that it is on *)
  touches : list (touch k);
  elements : list element;
  wrench : list R;              (* the work that loads do, by coordinate *)
  direction : list R;
  normal : Model.law
}.
Arguments touching {k}.
Arguments of_body {k}.
Arguments by_body {k}.
Arguments coordinates {k}.
Arguments bodies {k}.
Arguments touches {k}.
Arguments elements {k}.
Arguments wrench {k}.
Arguments direction {k}.
Arguments normal {k}.

Definition has_all_numbers {k : kind} (m : mechanism k) : Prop :=
  List.length (wrench m) = coordinates m /\ List.length (direction m) = coordinates m /\
  Forall (fun e => List.length (lever e) = coordinates m) (elements m).

Definition relative {k : kind} (m : mechanism k) (d : list R) (t : touch k) : list R :=
  let all := motions (numbers k) d (bodies m) [] in
  plus (of_number all (of_body t)) (scaled (-1) (of_number all (by_body t))).

Definition sum (numbers : list R) : R := fold_right Rplus 0 numbers.

Definition equilibrium {k : kind} (m : mechanism k) (lambda : R) (d : list R) (forces : list (force k)) (pulls : list R)
    : Prop :=
  List.length d = coordinates m /\
  Forall2 (fun t f => obeys k (normal m) lambda (relative m d t) (touching t) f) (touches m) forces /\
  Forall2 (pull_obeys (normal m) lambda d) (elements m) pulls /\
  forall y, List.length y = coordinates m ->
    dot (wrench m) y + lambda * dot (direction m) y +
    sum (map (fun tf => works k (touching (fst tf)) (snd tf) (relative m y (fst tf))) (combine (touches m) forces)) +
    sum (map (fun ea => snd ea * dot (lever (fst ea)) y) (combine (elements m) pulls)) = 0.

(* With a motion that is allowed. *)
Definition stable_at {k : kind} (allowed : list R -> Prop) (m : mechanism k) (lambda : R) : Prop :=
  exists d forces pulls, allowed d /\ equilibrium m lambda d forces pulls.
