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

Record question := Question {
  dimension : nat;           (* of motions: 3 in the plane, 6 in space, of several bodies as many as coordinates *)
  bilateral : bool;          (* the normal law *)
  is_margin : bool;          (* a direction of either kind was given *)
  contacts : list contact;
  wrench : list interval;    (* w, after the table of FORMAT.md 1, widened *)
  direction : list Q;        (* u; as many zeros without a direction of wrenches *)
  inertia : list Q;          (* of rigid contacts, 3 numbers or in space 9; none if their class is not asked for *)
  several : option mechanism (* of several bodies *)
}.

(* The certificate, in the order of its text.  INDEX and CONTACT are whole numbers >= 0 of any
   size. *)
Inductive parameter := PX | PY | PZ | PTurn | PTurnV | PFriction | PPreload | PStiffness | PWrench.

Inductive node :=
  | Slip (contact_index : Z)
  | Separation (contact_index : Z)
  | Plane (numbers : list Q)          (* without the number of l in a verdict: as in the file *)
  | Cut (name : parameter) (index : Z) (at_number : Q)             (* `part` *)
  | Leaf (y : list Q).

Record witness := Witness {
  twist : list Q;
  shares : list (Z * list Q)          (* a share is one number in the plane, three in space *)
}.

(* POINT of a margin in the plane: lambda, or None for null. *)
Record point := Point { multiple : option Q; point_witness : witness }.

Inductive segment :=
  | Segment (first : option point) (second : point)    (* None: begins with the last point of the segment before it *)
  | SegmentByDegree (to : option Q) (first_twist last_twist : list Q) (walls direction : list (list Q))
      (tree : list node).

(* PART of a stable verdict. *)
Inductive part :=
  | PartCut (name : parameter) (index : Z) (at_number : Q)
  | PartProof (d0 : list Q) (simplex : bool) (walls : list (list Q)) (direction : list (list Q))
      (tree : list node)
  | PartAtRest (forces : list (Z * list Q)) (answers : list (Z * list (list Q))) (reach : list Q).

(* CLAIM of a margin in space: a part, or points. *)
Inductive claim :=
  | ClaimStable (low : Q) (high : option Q) (evidence : part + list witness)
  | ClaimUnstable (low : Q) (high : option Q) (tree : list node).

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

(* All after the member `question`. *)
Inductive proof :=
  | StableByWitness (w : witness)
  | StableByParts (parts : list part)
  | UnstableByTree (tree : list node)
  | MarginBy (resisted : list (Q * option Q)) (segments : list segment) (tree : list node)
  | MarginInSpace (claims : list claim)
  | OfClass (p : class_proof).

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
  | AtProofOf (interval : nat) (node : option nat).

Inductive answer :=
  | Stable                                         (* for every choice in the question *)
  | Unstable                                       (* likewise *)
  | Margin (resisted : list (Q * option Q))        (* exactly these multiples; None: no end *)
  (* These multiples, and not those between the numbers of these; where the flag is set, not at the low one
     either.  Nothing is claimed of others. *)
  | Claims (resisted : list (Q * option Q)) (refuted : list (Q * option Q * bool))
  | Class (found : class)                          (* of rigid contacts *)
  | Rejected (rule : string) (found_at : place)
  | NotProvedHere (why : string).                  (* this checker cannot judge it *)

(* Advice about one ray of a region, which nobody has to believe: to keep it, or to drop it as
   factor * ray = sum of coefficient * (the ray of that number among those kept). *)
Inductive advice :=
  | Keep
  | Drop (factor : Z) (terms : list (nat * Z)).

(* An oracle has a memory of any type for each region.  `advise` hears that a region is cut by
   form >= 0, or by form = 0 if the flag is set, and gives advice about each candidate ray in
   the order of Cone.v.  `foremost` says by which of many forms, as their numbers from 0, it is best to cut
   first, so that most others change nothing.  Theorems hold for every oracle. *)
Record oracle (memory : Type) := Oracle {
  begin : nat -> memory;              (* all of R^n *)
  advise : memory -> list Z -> bool -> memory * list advice;
  foremost : memory -> list (list Z * bool) -> list Z
}.
Arguments begin {memory}.
Arguments advise {memory}.
Arguments foremost {memory}.

(* The checker (Checker.v) is
     check : forall memory, oracle memory -> question -> certificate -> answer. *)
Definition checker := forall memory, oracle memory -> question -> certificate -> answer.
