(* SPDX-License-Identifier: MIT *)
(* Statics, over the real numbers (FORMAT.md section 16): may bodies stand under a load at all, whatever stiffness and
   preloads are?  If not, they must move.  All friction is multiplied by phi. *)
From Coq Require Import Reals List.
From Proved Require Model SpaceModel.
From Proved Require Import Rows BodiesModel.
Import ListNotations.
Open Scope R_scope.

(* A contact does not pull, and friction is in Coulomb's cone. *)
Definition in_cone (phi : R) (c : Model.contact) (force : R * R) : Prop :=
  let (a, b) := force in 0 <= a /\ Rabs b <= phi * Model.friction c * a.

Definition in_cone_in_space (phi : R) (c : SpaceModel.contact) (force : R * SpaceModel.vector) : Prop :=
  let (a, f) := force in
  0 <= a /\ SpaceModel.dot f (SpaceModel.normal c) = 0 /\
  SpaceModel.norm f <= phi * SpaceModel.friction c * SpaceModel.length c * a.

(* Some forces balance the load w on one body. *)
Definition may_stand_in_plane (phi : R) (g : Model.grasp) (w : Model.vector) : Prop :=
  exists forces, Forall2 (in_cone phi) (Model.contacts g) forces /\
    Model.add w (Model.sum (Model.contact_wrenches (Model.contacts g) forces)) = Model.zero.

Definition may_stand_in_space (phi : R) (g : SpaceModel.grasp) (w : SpaceModel.screw) : Prop :=
  exists forces, Forall2 (in_cone_in_space phi) (SpaceModel.contacts g) forces /\
    SpaceModel.add_screw w (SpaceModel.sum (SpaceModel.contact_wrenches (SpaceModel.contacts g) forces)) =
    SpaceModel.no_screw.

(* Of several bodies.  The cone of a soft finger is an ellipsoid, as it is where it stands. *)
Definition in_cone_of_finger (phi : R) (t : finger) (force : R * SpaceModel.vector * R) : Prop :=
  let '(a, f, m) := force in
  let most := phi * SpaceModel.friction (hard t) * SpaceModel.length (hard t) * a in
  in_cone_in_space phi (hard t) (a, f) /\
  gamma t * SpaceModel.dot f f + m * m <= gamma t * (most * most).

(* A ratchet pulls, or does nothing.  A spring with stiffness is locked, and holds with any force; one without exerts its
   preload. *)
Definition can_pull (e : element) (a : R) : Prop :=
  if is_spring e then stiffness e = 0 -> a = preload e else 0 <= a.

(* Some forces balance the load w, the work that loads do by coordinate, in all states that joints allow. *)
Definition may_stand {k : kind} (in_cone : contact k -> force k -> Prop) (m : mechanism k) (w : list R) : Prop :=
  exists forces pulls,
    Forall2 (fun t f => in_cone (touching t) f) (touches m) forces /\
    Forall2 can_pull (elements m) pulls /\
    forall y, List.length y = coordinates m ->
      dot w y +
      sum (map (fun tf => works k (touching (fst tf)) (snd tf) (relative m y (fst tf))) (combine (touches m) forces)) +
      sum (map (fun ea => snd ea * dot (lever (fst ea)) y) (combine (elements m) pulls)) = 0.
