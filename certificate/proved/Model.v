(* SPDX-License-Identifier: MIT *)
(* The mechanics, over the real numbers (FORMAT.md section 1): what a grasp in the plane, a motion,
   contact forces and an equilibrium are.  Nothing here is about certificates or rationals.
   Whoever believes this page and Meaning.v, and Coq, can believe the answers of the checker. *)
From Coq Require Import Reals List.
Import ListNotations.
Open Scope R_scope.

(* A wrench (force x, force y, torque about the origin), or a motion (translation x and y, and a
   small rotation). *)
Record vector := Vector { along_x : R; along_y : R; about_z : R }.

Definition zero := Vector 0 0 0.

Definition add (a b : vector) :=
  Vector (along_x a + along_x b) (along_y a + along_y b) (about_z a + about_z b).

Definition scale (s : R) (a : vector) :=
  Vector (s * along_x a) (s * along_y a) (s * about_z a).

(* The work of a wrench on a motion. *)
Definition work (a d : vector) :=
  along_x a * along_x d + along_y a * along_y d + about_z a * about_z d.

(* The wrench of the force f at the point p. *)
Definition force_at (px py fx fy : R) := Vector fx fy (px * fy - py * fx).

(* A contact: position p, normal n (not 0, of any length, into the object), friction coefficient,
   stiffness, preload, and what the preload grows by in a margin. *)
Record contact := Contact {
  px : R; py : R; nx : R; ny : R;
  friction : R; stiffness : R; preload : R; growth : R
}.

Definition length (c : contact) := sqrt (nx c * nx c + ny c * ny c).

(* Unit force along the normal n and along t = (-n_y, n_x), times the length of n. *)
Definition N (c : contact) := force_at (px c) (py c) (nx c) (ny c).
Definition T (c : contact) := force_at (px c) (py c) (- ny c) (nx c).

(* The law of the normal spring without its corner: P' - k' N.d, in the preload P + lambda P^u. *)
Definition v (c : contact) (lambda : R) (d : vector) :=
  (preload c + lambda * growth c) / length c
  - stiffness c / (length c * length c) * work (N c) d.

Inductive law := unilateral | bilateral.

(* The forces (a, b) stand for the contact wrench a N + b T. *)
Definition contact_wrench (c : contact) (force : R * R) :=
  add (scale (fst force) (N c)) (scale (snd force) (T c)).

Definition normal_law (l : law) (v a : R) :=
  match l with
  | unilateral => a = Rmax 0 v
  | bilateral => a = v /\ 0 <= v
  end.

(* What a contact's force has to be at the motion d. *)
Definition obeys (l : law) (lambda : R) (d : vector) (c : contact) (force : R * R) :=
  let (a, b) := force in
  normal_law l (v c lambda d) a /\
  Rabs b <= friction c * a /\
  (0 < work (T c) d -> b = - (friction c * a)) /\
  (work (T c) d < 0 -> b = friction c * a).

Record grasp := Grasp {
  contacts : list contact;
  wrench : vector;              (* w *)
  direction : vector;           (* u *)
  normal : law
}.

Definition sum (vs : list vector) := fold_right add zero vs.

Definition contact_wrenches (cs : list contact) (forces : list (R * R)) :=
  map (fun cf => contact_wrench (fst cf) (snd cf)) (combine cs forces).

(* For the multiple lambda: under the wrench w + lambda u and the preloads P + lambda P^u. *)
Definition equilibrium (g : grasp) (lambda : R) (d : vector) (forces : list (R * R)) :=
  Forall2 (obeys (normal g) lambda d) (contacts g) forces /\
  add (add (wrench g) (scale lambda (direction g)))
      (sum (contact_wrenches (contacts g) forces)) = zero.

(* With a motion that is allowed. *)
Definition stable_at (allowed : vector -> Prop) (g : grasp) (lambda : R) :=
  exists d forces, allowed d /\ equilibrium g lambda d forces.
