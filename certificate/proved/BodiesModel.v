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

Definition in_space : kind := Kind SpaceModel.contact (R * SpaceModel.vector) 6
  (fun l lambda d => SpaceModel.obeys l lambda (screw_of d))
  (fun c f d => SpaceModel.work (SpaceModel.contact_wrench c f) (screw_of d)).

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

Definition stable_at {k : kind} (m : mechanism k) (lambda : R) : Prop :=
  exists d forces pulls, equilibrium m lambda d forces pulls.
