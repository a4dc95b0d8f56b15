(* SPDX-License-Identifier: MIT *)
(* What the reader hands to the checker, and what the checker answers.  Data only: integers,
   rationals, lists and strings.  What a question means is said in Model.v (over the reals) and
   Meaning.v (which real grasps a question is about); the rules are in Checker.v.

   Rationals (Q) need not be in lowest terms anywhere; compare them by Qeq_bool, never by =.

   The reader has already done all of FORMAT.md that makes a file malformed or a question
   impossible to ask, and the rules `question-...` of section 3.  The checker does every other
   rule, from `witness-box` on. *)
From Coq Require Import List String ZArith QArith.

(* [low, high], low <= high; a number is the interval from itself to itself. *)
Record interval := Interval { low : Q; high : Q }.

Definition exactly (q : Q) : interval := Interval q q.

(* A contact of the question, after what the options replaced and widened (FORMAT.md 1, 6). *)
Record contact := Contact {
  position : list interval;  (* two coordinates in the plane, three in space *)
  normal : list Q;           (* n0, not 0; so many *)
  slope : Q;                 (* the largest tangent of the angle of the normal to n0 *)
  friction : interval;
  stiffness : interval;
  preload : interval;        (* P; of a margin with the preload direction `scale`, 0 *)
  preload_growth : Q;        (* P^u; 0 without a preload direction *)
  of_body : option nat;      (* of several bodies those that meet, as their numbers; None is the ground *)
  by_body : option nat;
  torsion : Q                (* of a soft finger in space, else 0 *)
}.

(* Of several bodies (FORMAT.md section 14).  A body that is no link moves by coordinates of its own, from this one on.
   A link moves as the body that it is on, and besides by so many times its `eta` as it turns: the sum of all
   coordinates times `turns`. *)
Inductive rigid_body :=
  | Free (first : nat)
  | Link (on : option nat) (eta turns : list Q).

(* A ratchet or a spring. *)
Record element := Elastic {
  lever : list Q;            (* its row: how far it gives way, by coordinate *)
  element_spring : bool;
  element_stiffness : interval;
  element_preload : interval;
  element_growth : Q
}.

Record mechanism := Mechanism {
  bodies_in_space : bool;
  bodies : list rigid_body;  (* each after the one that it is on *)
  elements : list element
}.

(* A ball of loads: those of a force and a torque at a point whose size, with torques divided by a length, is at most
   its radius; of several bodies on one of them, as its number. *)
Record ball := Ball { radius : Q; torque_length : Q; about : list Q; on_body : option nat }.

Record question := Question {
  dimension : nat;           (* of motions: 3 in the plane, 6 in space, of several bodies as many as coordinates *)
  bilateral : bool;          (* the normal law *)
  is_margin : bool;          (* a direction of either kind was given *)
  contacts : list contact;
  wrench : list interval;    (* w, after the table of FORMAT.md 1, widened *)
  load_ball : option ball;   (* of which any load is added to w *)
  direction : list Q;        (* u; as many zeros without a direction of wrenches *)
  load_plane : option (list Q * list Q);   (* u and v, if it is about w + s u + t v *)
  inertia : list Q;          (* of rigid contacts, 3 numbers or in space 9; none if their class is not asked for *)
  statics : option Q;        (* what all friction is multiplied by, if it is about statics *)
  several : option mechanism; (* of several bodies *)
  max_motion : option (list Q)  (* B, above 0 for each coordinate of motions, if these are bounded *)
}.

(* The certificate, in the order of its text.  INDEX and CONTACT are whole numbers >= 0 of any
   size. *)
Inductive parameter := PX | PY | PZ | PTurn | PTurnV | PFriction | PPreload | PStiffness | PWrench.

Inductive node :=
  | Slip (contact_index : Z)
  | Separation (contact_index : Z)
  | Plane (numbers : list Q)          (* without the number of l in a verdict: as in the file *)
  | Cut (name : parameter) (index : Z) (at_number : Q)             (* `part` *)
  | Leaf (y : list Q)
  | Moving (y : list Q) (along_motion : Q) (brakes : list (Z * (Q * list Q)))   (* a leaf; a number and a slip of contacts *)
  | Held (piece : Z).                 (* a leaf, of a plane of loads *)

Record witness := Witness {
  twist : list Q;
  shares : list (Z * list Q)          (* a share is one number in the plane, three in space *)
}.

(* POINT of a segment: lambda, or None for null. *)
Record point := Point { multiple : option Q; point_witness : witness }.

Inductive segment :=
  | Segment (first : option point) (second : point)    (* None: begins with the last point of the segment before it *)
  | SegmentByDegree (to : option Q) (first_twist last_twist : list Q) (walls direction : list (list Q))
      (tree : list node).

(* PART of a stable verdict. *)
Inductive part :=
  | PartCut (name : parameter) (index : Z) (at_number : Q)
  | PartProof (d0 : list Q) (open : list Z) (simplex : bool) (walls : list (list Q)) (direction : list (list Q))
      (tree : list node)
  | PartAtRest (forces : list (Z * list Q)) (answers : list (Z * list (list Q))) (reach : list Q)
  | PartSticking (d0 : list Q) (friction : list (Z * list Q)) (presses : list (Z * list Q))
      (answers : list (Z * list (list Q))) (reach : list Q) (energy : Q).

(* CLAIM: a part, or points. *)
Inductive claim :=
  | ClaimStable (low : Q) (high : option Q) (evidence : part + list witness)
  | ClaimUnstable (low : Q) (high : option Q) (tree : list node).

(* POINT of a piece of a plane of loads: `at` or `towards` s, t. *)
Record load_point := LoadPoint { is_at : bool; along_u : Q; along_v : Q; load_witness : witness }.

(* Nodes of a tree about rigid contacts. *)
Inductive rigid_node :=
  | RTouch (contact_index : Z)
  | RSlip (contact_index : Z) (side : list Q)              (* in the plane without a side *)
  | RLeaf (t : Q) (y : list Q) (along_N : list (Z * Q)) (along_slips : list (Z * list Q)).

(* [i, a_i, f_i] *)
Definition stated_forces := list (Z * (Q * list Q)).

Inductive class_proof :=
  | ByTwist (y : list Q)                                                              (* must move *)
  | ByTree (rest : stated_forces) (tree : list rigid_node)                            (* must hold *)
  | ByMotion (rest : stated_forces) (acceleration : list Q) (forces : stated_forces). (* open *)

Inductive class := MustMove | MustHold | Open.

Definition class_of (p : class_proof) : class :=
  match p with ByTwist _ => MustMove | ByTree _ _ => MustHold | ByMotion _ _ _ => Open end.

(* Statics: forces, a twist, or load points with forces and twists. *)
Inductive statics_proof :=
  | ByForces (forces : stated_forces)                                                 (* may stand *)
  | ByMove (y : list Q)                                                               (* must move *)
  | ByPoints (stand : list (list Q * stated_forces)) (move : list (list Q)).          (* of many loads *)

(* All after the member `question`. *)
Inductive proof :=
  | StableByWitness (w : witness)
  | StableByParts (parts : list part)
  | UnstableByTree (tree : list node)
  | MarginBy (resisted : list (Q * option Q)) (segments : list segment) (tree : list node)
  | MarginInSpace (claims : list claim)
  | OfClass (p : class_proof)
  | OfStatics (p : statics_proof)
  | RegionBy (pieces : list (list load_point)) (tree : list node).

Record certificate := Certificate {
  bits : Z;                           (* 128 if left out *)
  body : proof
}.

(* Where a rule failed; numbers from 0. *)
Inductive place :=
  | Nowhere
  | AtNode (number : nat)
  | AtContact (number : Z)            (* of a witness *)
  | AtInterval (number : nat)
  | AtSegment (number : nat) (node : option nat)
  | AtPoint (segment : nat) (second : bool)
  | AtPart (number : nat) (node : option nat)    (* and the number in the part's own tree *)
  | AtPointOf (interval : nat) (second : bool)
  | AtProofOf (interval : nat) (node : option nat)
  | AtPiece (number : nat) (point : option nat)
  | AtMember (name : string)                     (* of a certificate *)
  | AtStand (number : nat)                       (* a load point *)
  | AtMove (number : nat).

Inductive answer :=
  | Stable                                         (* for every choice in the question *)
  | Unstable                                       (* likewise *)
  | Margin (resisted : list (Q * option Q))        (* exactly these multiples; None: no end *)
  (* These multiples, and not those between the numbers of these; where the flag is set, not at the low one
     either.  Nothing is claimed of others. *)
  | Claims (resisted : list (Q * option Q)) (refuted : list (Q * option Q * bool))
  | Class (found : class)                          (* of rigid contacts *)
  (* Exactly the (s, t) in these pieces, of which each is known by points (1, s, t), or towards (0, s, t). *)
  | Region (pieces : list (list (Q * Q * Q)))
  (* Statics: whether some forces balance the load, or none do. *)
  | MayStand
  | CannotStand
  (* Multiples from one to the other may stand; and those below the first, and above the second, cannot, and if the flag
     is set none can.  Nothing is claimed of others. *)
  | StandsAmong (multiples : option (option Q * option Q)) (moves : option Q * option Q * bool)
  (* Sums of these points (h, s, t) with h = 1 may stand, and (s, t) where one of these forms of (1, s, t) is above 0
     cannot. *)
  | StandsWithin (points forms : list (Q * Q * Q))
  | Rejected (rule : string) (found_at : place)
  | NotProvedHere (why : string).                  (* this checker cannot judge it *)

(* Advice, which nobody has to believe: theorems hold for every oracle.  `permits` hears how many combinations of
   rays a cut may have to make, and may forbid it: a region that is not cut is only larger.  `foremost` hears of the
   rays of a region and of forms f >= 0, or f = 0 if the flag is set, and says by which, as its number from 0,
   it is best to cut next, if many others then change nothing. *)
Record oracle := Oracle {
  permits : Z -> bool;
  foremost : list (list Z) -> list (list Z * bool) -> option Z
}.

(* The checker (Checker.v) is
     check : oracle -> question -> certificate -> answer. *)
Definition checker := oracle -> question -> certificate -> answer.
