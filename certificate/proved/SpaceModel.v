(* SPDX-License-Identifier: MIT *)
(* The mechanics in space, over the real numbers (FORMAT.md section 1), as Model.v has it in the plane. *)
From Coq Require Import Reals List.
From Proved Require Model.
Import ListNotations.
Open Scope R_scope.

Record vector := Vector { x : R; y : R; z : R }.

Definition zero := Vector 0 0 0.
Definition add (a b : vector) := Vector (x a + x b) (y a + y b) (z a + z b).
Definition scale (s : R) (a : vector) := Vector (s * x a) (s * y a) (s * z a).
Definition dot (a b : vector) := x a * x b + y a * y b + z a * z b.
Definition cross (a b : vector) :=
  Vector (y a * z b - z a * y b) (z a * x b - x a * z b) (x a * y b - y a * x b).
Definition norm (a : vector) := sqrt (dot a a).

(* A motion (translation and small rotation), or a wrench (force, and torque about the origin). *)
Record screw := Screw { linear : vector; angular : vector }.

Definition no_screw := Screw zero zero.
Definition add_screw (a b : screw) :=
  Screw (add (linear a) (linear b)) (add (angular a) (angular b)).
Definition scale_screw (s : R) (a : screw) := Screw (scale s (linear a)) (scale s (angular a)).
Definition work (w d : screw) := dot (linear w) (linear d) + dot (angular w) (angular d).

(* The wrench of the force f at the point p. *)
Definition force_at (p f : vector) := Screw f (cross p f).

(* Normal: not 0, of any length, into the object. *)
Record contact := Contact {
  position : vector; normal : vector;
  friction : R; stiffness : R; preload : R; growth : R
}.

Definition length (c : contact) := norm (normal c).
Definition N (c : contact) := force_at (position c) (normal c).

(* How the motion d moves the contact's point; and its slip, the part across the normal. *)
Definition moved (c : contact) (d : screw) := add (linear d) (cross (angular d) (position c)).
Definition slip (c : contact) (d : screw) :=
  add (moved c d)
    (scale (- (dot (normal c) (moved c d) / dot (normal c) (normal c))) (normal c)).

Definition v (c : contact) (lambda : R) (d : screw) :=
  (preload c + lambda * growth c) / length c
  - stiffness c / (length c * length c) * work (N c) d.

(* The forces (a, f) stand for the force a n + f at the contact's point. *)
Definition contact_wrench (c : contact) (force : R * vector) :=
  force_at (position c) (add (scale (fst force) (normal c)) (snd force)).

(* Coulomb's cone, and dissipation: friction is opposite to the slip. *)
Definition obeys (l : Model.law) (lambda : R) (d : screw) (c : contact) (force : R * vector) :=
  let (a, f) := force in
  Model.normal_law l (v c lambda d) a /\
  dot f (normal c) = 0 /\
  norm f <= friction c * length c * a /\
  (slip c d <> zero ->
     f = scale (- (friction c * length c * a / norm (slip c d))) (slip c d)).

Record grasp := Grasp {
  contacts : list contact;
  wrench : screw;
  direction : screw;
  normal_law : Model.law
}.

Definition sum (ws : list screw) := fold_right add_screw no_screw ws.

Definition contact_wrenches (cs : list contact) (forces : list (R * vector)) :=
  map (fun cf => contact_wrench (fst cf) (snd cf)) (combine cs forces).

Definition equilibrium (g : grasp) (lambda : R) (d : screw) (forces : list (R * vector)) :=
  Forall2 (obeys (normal_law g) lambda d) (contacts g) forces /\
  add_screw (add_screw (wrench g) (scale_screw lambda (direction g)))
    (sum (contact_wrenches (contacts g) forces)) = no_screw.

(* With a motion that is allowed. *)
Definition stable_at (allowed : screw -> Prop) (g : grasp) (lambda : R) :=
  exists d forces, allowed d /\ equilibrium g lambda d forces.
