(* SPDX-License-Identifier: MIT *)
(* Rigid contacts, over the real numbers (FORMAT.md section 13): what accelerations and contact forces a body of
   the mass 1 can have.  Stiffness and preloads play no part. *)
From Coq Require Import Reals List.
From Proved Require Model SpaceModel.
Import ListNotations.
Open Scope R_scope.

(* In the plane: the centre of mass, and the square of the radius of gyration about it. *)
Record inertia_in_plane := InertiaInPlane { center_x : R; center_y : R; gyration_squared : R }.

Section Plane.
Import Model.

(* The wrench of the force at the centre that is its acceleration, and of the torque. *)
Definition accelerates (m : inertia_in_plane) (a : vector) : vector :=
  add (force_at (center_x m) (center_y m) (along_x a - about_z a * center_y m) (along_y a + about_z a * center_x m))
      (Vector 0 0 (gyration_squared m * about_z a)).

(* A contact does not pull, and is not penetrated; one that parts does not press; friction is Coulomb's. *)
Definition rigid_obeys (a : vector) (c : contact) (force : R * R) :=
  let (n, b) := force in
  0 <= n /\ 0 <= work (N c) a /\ n * work (N c) a = 0 /\
  Rabs b <= friction c * n /\ b * work (T c) a = - (friction c * n * Rabs (work (T c) a)).

Definition rigid_solution (g : grasp) (m : inertia_in_plane) (a : vector) (forces : list (R * R)) :=
  Forall2 (rigid_obeys a) (contacts g) forces /\
  accelerates m a = add (wrench g) (sum (contact_wrenches (contacts g) forces)).

Definition can (g : grasp) (m : inertia_in_plane) (a : vector) := exists forces, rigid_solution g m a forces.

End Plane.

(* In space: the centre of mass, and the tensor of inertia about it, a symmetric matrix. *)
Record tensor := Tensor { xx : R; yy : R; zz : R; xy : R; xz : R; yz : R }.
Record inertia_in_space := InertiaInSpace { center : SpaceModel.vector; about_center : tensor }.

Section Space.
Import SpaceModel.

Definition turned_by (t : tensor) (a : vector) : vector :=
  Vector (xx t * x a + xy t * y a + xz t * z a) (xy t * x a + yy t * y a + yz t * z a)
    (xz t * x a + yz t * y a + zz t * z a).

Definition accelerates_in_space (m : inertia_in_space) (a : screw) : screw :=
  add_screw (force_at (center m) (add (linear a) (cross (angular a) (center m))))
            (Screw zero (turned_by (about_center m) (angular a))).

Definition rigid_obeys_in_space (a : screw) (c : contact) (force : R * vector) :=
  let (n, f) := force in
  0 <= n /\ 0 <= work (N c) a /\ n * work (N c) a = 0 /\
  dot f (normal c) = 0 /\ norm f <= friction c * length c * n /\
  dot f (slip c a) = - (friction c * length c * n * norm (slip c a)).

Definition rigid_solution_in_space (g : grasp) (m : inertia_in_space) (a : screw) (forces : list (R * vector)) :=
  Forall2 (rigid_obeys_in_space a) (contacts g) forces /\
  accelerates_in_space m a = add_screw (wrench g) (sum (contact_wrenches (contacts g) forces)).

Definition can_in_space (g : grasp) (m : inertia_in_space) (a : screw) :=
  exists forces, rigid_solution_in_space g m a forces.

End Space.

(* Which accelerations can be: not rest, rest alone, or rest and others. *)
Definition must_move {A : Type} (at_rest : A) (can : A -> Prop) : Prop := ~ can at_rest.
Definition must_hold {A : Type} (at_rest : A) (can : A -> Prop) : Prop :=
  can at_rest /\ forall a, can a -> a = at_rest.
Definition is_open {A : Type} (at_rest : A) (can : A -> Prop) : Prop :=
  can at_rest /\ exists a, a <> at_rest /\ can a.
