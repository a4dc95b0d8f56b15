(* SPDX-License-Identifier: MIT *)
(** The certificate, `stickslip-certificate/2`, in the order of its text: FORMAT.md sections 2, 6
    and 7. And the rules `question-...` of section 3. *)
From Coq Require Import Ascii Bool List QArith String ZArith.
From Proved Require Import Json Numeral Pose Question ReadBodies ReadGrasp.
Import ListNotations.
Local Open Scope string_scope.

(** The member `question`: what whoever made the certificate was asked. *)
Record statement : Set := {
  stated_contacts : Z;
  wrench_stated : list interval;
  options_stated : options  (** without wrench and case *) }.

(** What the numbers of a certificate depend on. *)
Record shape : Set := {
  spatial : bool;
  of_bodies : bool;
  size_of_twist : Z;      (** D *)
  soft : list bool;       (** whether each contact has torsion *)
  of_claims : bool;       (** whether margins are lists of claims *)
  of_margin : bool;
  of_plane : bool;
  of_class : bool;
  of_statics : bool }.

(** Not of one body in the plane whose motions are not bounded, and whose lengths of normals that matter are rational. *)
Definition has_claims (q : question) : bool :=
  match several q with Some _ => true | None => Nat.eqb (dimension q) 6 end
  || match max_motion q with Some _ => true | None => false end
  || existsb has_irrational_preload (contacts q).

Definition read_numbers (count : Z) : path -> json -> result (list Q) :=
  read_sized count (if count =? 6 then "an array of 6 numbers"
                    else if count =? 3 then "an array of 3 numbers"
                    else "an array of so many numbers as the dimension asks for")%Z read_fraction.
Definition read_twist (s : shape) : path -> json -> result (list Q) := read_numbers (size_of_twist s).

Definition read_or_null (at_path : path) (value : json) : result (option Q) :=
  match value with
  | Null => Fine None
  | _ => let* x := read_fraction at_path value in Fine (Some x)
  end.

(** A NUMBER, or an interval of the grasp file. *)
Definition read_stated_component (at_path : path) (value : json) : result interval :=
  match value with
  | Array [least; most] =>
      let* a := read_fraction at_path least in
      let* b := read_fraction at_path most in
      Fine (Interval a b)
  | Array _ => expected "a number, or [min, max]" at_path value
  | _ => let* x := read_fraction at_path value in Fine (exactly x)
  end.

Definition read_law (at_path : path) (value : json) : result bool :=
  if is_text "bilateral" value then Fine true
  else if is_text "unilateral" value then Fine false
  else expected """unilateral"" or ""bilateral""" at_path value.

Definition read_growth (at_path : path) (value : json) : result growth :=
  if is_text "scale" value then Fine Scale
  else
    let* numbers := read_array """scale"" or an array of numbers" read_fraction at_path value in
    Fine (By numbers).

(** The characters before the last one, if that is %. *)
Definition before_percent (content : string) : option string :=
  match rev_append (list_ascii_of_string content) [] with
  | last :: others =>
      if Ascii.eqb last "%" then Some (string_of_list_ascii (rev_append others [])) else None
  | [] => None
  end.

Definition read_tolerance (at_path : path) (value : json) : result tolerance :=
  let percentage := match value with Text content => before_percent content | _ => None end in
  match percentage with
  | Some spelled =>
      let* x := read_fraction at_path (Text spelled) in Fine {| amount := x; percent := true |}
  | None => let* x := read_fraction at_path value in Fine {| amount := x; percent := false |}
  end.

(** BALL. *)
Definition read_ball (s : shape) (at_path : path) (value : json) : result stated_ball :=
  let coordinates := if spatial s then 3%Z else 2%Z in
  let* members :=
    members_in_order (["ball"; "length"; "about"] ++ if of_bodies s then ["body"] else [])%list at_path value in
  let* r := member "ball" read_fraction at_path members in
  let* l := member "length" read_fraction at_path members in
  let* c := optional_member "about" (read_sized coordinates "an array of the coordinates of a point" read_fraction)
              at_path members in
  let* b := if of_bodies s then let* name := member "body" read_text at_path members in Fine (Some name) else Fine None in
  Fine {| stated_radius := r; stated_length := l; stated_body := b;
          stated_point := match c with Some c => c | None => repeat 0%Q (Z.to_nat coordinates) end |}.

(** Tolerances, and the ball that may stand in place of that of the wrench. *)
Fixpoint read_all_tolerances (s : shape) (at_path : path) (members : list (string * json))
  : result (list (string * tolerance) * option stated_ball) :=
  match members with
  | [] => Fine ([], None)
  | (kind, value) :: rest =>
      if (kind =? "wrench") && (match value with Object _ => true | _ => false end) then
        let* b := read_ball s (Member kind :: at_path) value in
        let* '(others, _) := read_all_tolerances s at_path rest in
        Fine (others, Some b)
      else
        let* t := read_tolerance (Member kind :: at_path) value in
        let* '(others, b) := read_all_tolerances s at_path rest in
        Fine ((kind, t) :: others, b)
  end.

Definition read_tolerances (s : shape) (at_path : path) (value : json)
  : result (list (string * tolerance) * option stated_ball) :=
  let* members := members_in_order uncertain_kinds at_path value in
  match members with
  | [] => expected "an object of one tolerance or more" at_path value
  | _ => read_all_tolerances s at_path members
  end.

Definition read_inertia (in_space : bool) (at_path : path) (value : json) : result (list Q) :=
  let* numbers := read_array "an array of numbers, as --inertia has them" read_fraction at_path value in
  let* _ := check_that (if in_space then has_length 6 numbers || has_length 9 numbers else has_length 3 numbers) at_path
              (if in_space then "expected 6 or 9 numbers" else "expected 3 numbers") in
  Fine (in_full numbers).

(** The directions of a plane. *)
Definition read_plane (count : Z) (at_path : path) (value : json) : result (list Q * list Q) :=
  let* them := read_sized 2 "two directions" (read_numbers count) at_path value in
  Fine (nth 0 them [], nth 1 them []).

Definition names_member (name : string) (value : json) : bool :=
  match value with Object members => has_member name members | _ => false end.

Definition read_statement (s : shape) (at_path : path) (value : json) : result statement :=
  let* members :=
    members_in_order (["contacts"; "wrench"; "preload"; "normal_law"; "direction"; "preload_direction"]
                      ++ (if (spatial s || of_bodies s) && negb (names_member "statics" value) then [] else ["plane"])
                      ++ (if of_bodies s then [] else ["inertia"]) ++ ["statics"; "uncertain"; "max_motion"])%list
      at_path value in
  let count := size_of_twist s in
  let* m := member "contacts" read_index at_path members in
  let* w := member "wrench" (read_sized count "an array of the components" read_stated_component)
              at_path members in
  let* p := optional_member "preload" read_fraction at_path members in
  let* law := member "normal_law" read_law at_path members in
  let* u := optional_member "direction" (read_numbers count) at_path members in
  let* growing := optional_member "preload_direction" read_growth at_path members in
  let* plane := optional_member "plane" (read_plane count) at_path members in
  let* i := optional_member "inertia" (read_inertia (spatial s)) at_path members in
  let* factor := optional_member "statics" read_fraction at_path members in
  let* uncertain := optional_member "uncertain" (read_tolerances s) at_path members in
  let* bound := optional_member "max_motion" (read_numbers count) at_path members in
  Fine {| stated_contacts := m;
          wrench_stated := w;
          options_stated :=
            {| asked_wrench := None; asked_case := None; asked_preload := p; asked_bilateral := law;
               asked_direction := u; asked_growth := growing; asked_plane := plane;
               asked_inertia := i; asked_statics := factor;
               asked_uncertain := match uncertain with Some (it, _) => it | None => [] end;
               asked_ball := match uncertain with Some (_, b) => b | None => None end;
               asked_bound := match bound with Some numbers => Some (Bounded numbers) | None => None end |} |}.

(** F; and FORCES, or a number and a slip of each contact. *)
Definition read_friction (s : shape) (contact : Z) (at_path : path) (value : json) : result (list Q) :=
  if spatial s then
    read_numbers (match numbered (soft s) contact with Some true => 4 | _ => 3 end) at_path value
  else let* x := read_fraction at_path value in Fine [x].

Definition read_force (s : shape) (at_path : path) (value : json) : result (Z * (Q * list Q)) :=
  match value with
  | Array [contact; along; across] =>
      let* i := read_index at_path contact in
      let* a := read_fraction at_path along in
      let* f := read_friction s i at_path across in
      Fine (i, (a, f))
  | _ => expected "[contact, number, force or slip]" at_path value
  end.

Definition read_forces (s : shape) : path -> json -> result stated_forces :=
  read_array "an array [[contact, number, force or slip], ...]" (read_force s).

(** Nodes. *)
Definition read_parameter (s : shape) (at_path : path) (value : json) : result parameter :=
  let is name := is_text name value in
  if is "x" then Fine PX else if is "y" then Fine PY
  else if spatial s && is "z" then Fine PZ else if negb (spatial s) && is "turn" then Fine PTurn
  else if spatial s && is "turn_u" then Fine PTurn else if spatial s && is "turn_v" then Fine PTurnV
  else if is "friction" then Fine PFriction else if is "preload" then Fine PPreload
  else if is "stiffness" then Fine PStiffness else if is "wrench" then Fine PWrench
  else expected (if spatial s then "x, y, z, turn_u, turn_v, friction, preload, stiffness or wrench"
                 else "x, y, turn, friction, preload, stiffness or wrench") at_path value.

Definition read_cut (s : shape) (at_path : path) (items : list json) (whole : json)
  : result (parameter * Z * Q) :=
  match items with
  | [name; index; at_number] =>
      let* p := read_parameter s at_path name in
      let* i := read_index at_path index in
      let* c := read_fraction at_path at_number in
      Fine (p, i, c)
  | _ => expected "part, a name, an index and a number" at_path whole
  end.

Definition read_node (s : shape) (at_path : path) (value : json) : result node :=
  let contact_of (items : list json) : result Z :=
    match items with
    | [index] => read_index at_path index
    | _ => expected "a kind and a contact" at_path value
    end in
  let twist := size_of_twist s in
  match value with
  | Array (Text kind :: items) =>
      if kind =? "leaf" then
        if has_length twist items
        then let* y := each read_fraction at_path items in Fine (Leaf y)
        else expected "leaf, and a number for each component of a twist" at_path value
      else if kind =? "slip" then let* i := contact_of items in Fine (Slip i)
      else if kind =? "separation" then let* i := contact_of items in Fine (Separation i)
      else if kind =? "plane" then
        if has_length (twist + (if of_plane s then 3 else if of_margin s then 2 else 1)) items
        then let* a := each read_fraction at_path items in Fine (Plane a)
        else expected "plane, and a number for each coordinate of a point" at_path value
      else if (kind =? "moving") && negb (of_margin s || of_plane s) then
        if has_length (twist + 2) items
        then
          let n := Z.to_nat twist in
          let* y := each read_fraction at_path (firstn n items) in
          let* c := read_fraction at_path (nth n items Null) in
          let* them := read_forces s at_path (nth (S n) items Null) in
          Fine (Moving y c them)
        else expected "moving, a number for each component of a twist, one more, and an array" at_path value
      else if (kind =? "held") && of_plane s then let* k := contact_of items in Fine (Held k)
      else if (kind =? "part") && negb (of_margin s || of_plane s) then
        let* '(p, i, c) := read_cut s at_path items value in Fine (Cut p i c)
      else expected "slip, separation, plane, leaf or, without a direction, moving or part" at_path value
  | _ => expected "an array that begins with the kind of the node" at_path value
  end.

Definition read_nodes (s : shape) : path -> json -> result (list node) :=
  read_array "an array of nodes" (read_node s).

(** Witnesses and points. *)
Definition read_share (s : shape) (at_path : path) (value : json) : result (Z * list Q) :=
  match value with
  | Array [index; share] =>
      let* i := read_index at_path index in
      let* numbers := read_friction s i at_path share in
      Fine (i, numbers)
  | _ => expected "[contact, share]" at_path value
  end.

Definition read_shares (s : shape) : path -> json -> result (list (Z * list Q)) :=
  read_array "an array [[contact, share], ...]" (read_share s).

Definition read_point (s : shape) (may_be_ray : bool) (at_path : path) (value : json)
  : result point :=
  match value with
  | Array [lambda; motion; list] =>
      let* lambda := if may_be_ray then read_or_null at_path lambda
                     else let* x := read_fraction at_path lambda in Fine (Some x) in
      let* d := read_twist s at_path motion in
      let* them := read_shares s at_path list in
      Fine (Point lambda (Witness d them))
  | _ => expected "a point [lambda, twist, shares]" at_path value
  end.

(** [goes_on]: there is a segment before, and it ended with a number. *)
Definition read_segment (s : shape) (goes_on : bool) (at_path : path) (value : json)
  : result segment :=
  match value with
  | Array [begin; last] =>
      let* a := read_point s false at_path begin in
      let* b := read_point s true at_path last in
      Fine (Segment (Some a) b)
  | Array [last] =>
      if goes_on then let* b := read_point s true at_path last in Fine (Segment None b)
      else expected "two points, as no segment before ended with a number" at_path value
  | _ => expected "two points, or one where the segment before ended with a number" at_path value
  end.

Definition read_resisted (at_path : path) (value : json) : result (Q * option Q) :=
  match value with
  | Array [a; b] =>
      let* a := read_fraction at_path a in
      let* b := read_or_null at_path b in
      Fine (a, b)
  | _ => expected "[low, high] or [low, null]" at_path value
  end.

(** Proofs by degree. *)
Definition read_matrix (s : shape) : path -> json -> result (list (list Q)) :=
  read_sized (size_of_twist s) "a matrix with a row for each component of a twist" (read_twist s).

Fixpoint has_at_most {A : Type} (size : Z) (items : list A) : bool :=
  match items with
  | [] => true
  | _ :: rest => (0 <? size)%Z && has_at_most (size - 1) rest
  end.

(** E, of 0 to D rows; of a simplex of 2 to D + 1. *)
Definition read_walls (s : shape) (more : Z) (at_path : path) (value : json)
  : result (list (list Q)) :=
  let what := "rows, of a simplex two or more, and no more than it can have" in
  match value with
  | Array items =>
      if has_at_most (size_of_twist s + more) items && ((more =? 0)%Z || negb (has_at_most more items))
      then each (read_twist s) at_path items
      else expected what at_path value
  | _ => expected what at_path value
  end.

(** Friction forces of a contact, one for each component of a wrench. *)
Definition read_answers (s : shape) (at_path : path) (value : json) : result (Z * list (list Q)) :=
  match value with
  | Array [contact; forces] =>
      let* i := read_index at_path contact in
      let* them := read_sized (size_of_twist s) "a force for each component of a wrench"
                     (read_friction s i) at_path forces in
      Fine (i, them)
  | _ => expected "[contact, forces]" at_path value
  end.

Definition read_at_rest (s : shape) (at_path : path) (value : json) : result part :=
  let* members := members_in_order ["rest"; "answers"; "reach"] at_path value in
  let* f := member "rest" (read_shares s) at_path members in
  let* g := member "answers" (read_array "an array [[contact, forces], ...]" (read_answers s))
              at_path members in
  let* z := member "reach" (read_twist s) at_path members in
  Fine (PartAtRest f g z).

(** How much more a contact presses, for each component of a wrench. *)
Definition read_presses (s : shape) (at_path : path) (value : json) : result (Z * list Q) :=
  match value with
  | Array [contact; numbers] =>
      let* i := read_index at_path contact in
      let* them := read_twist s at_path numbers in
      Fine (i, them)
  | _ => expected "[contact, numbers]" at_path value
  end.

Definition read_sticking (s : shape) (at_path : path) (value : json) : result part :=
  let* members := members_in_order ["sticking"; "friction"; "presses"; "answers"; "reach"; "energy"] at_path value in
  let* d := member "sticking" (read_twist s) at_path members in
  let* f := member "friction" (read_shares s) at_path members in
  let* h := member "presses" (read_array "an array [[contact, numbers], ...]" (read_presses s)) at_path members in
  let* g := member "answers" (read_array "an array [[contact, forces], ...]" (read_answers s))
              at_path members in
  let* z := member "reach" (read_twist s) at_path members in
  let* c := member "energy" read_fraction at_path members in
  Fine (PartSticking d f h g z c).

Definition read_part (s : shape) (at_path : path) (value : json) : result part :=
  if names_member "rest" value then read_at_rest s at_path value else
  if names_member "sticking" value then read_sticking s at_path value else
  match value with
  | Array _ =>
      let* it := read_node s at_path value in
      match it with
      | Cut p i c => Fine (PartCut p i c)
      | _ => expected "a part" at_path value
      end
  | _ =>
      let has (name : string) := match value with Object members => has_member name members | _ => false end in
      let simplex := has "simplex" in
      let walls := if simplex then "simplex" else "walls" in
      let opens := has "open" in
      let* members := members_in_order ("twist" :: (if opens then ["open"] else []) ++ [walls; "direction"; "tree"])
                        at_path value in
      let* d := member "twist" (read_twist s) at_path members in
      let* o := if opens then member "open" (read_array "an array of contacts" read_index) at_path members else Fine [] in
      let* e := member walls (read_walls s (if simplex then 1 else 0)%Z) at_path members in
      let* a := member "direction" (read_matrix s) at_path members in
      let* tree := member "tree" (read_nodes s) at_path members in
      Fine (PartProof d o simplex e a tree)
  end.

(** BY_DEGREE. *)
Definition read_segment_by_degree (s : shape) (at_path : path) (value : json) : result segment :=
  let* members :=
    members_in_order ["to"; "twists"; "walls"; "direction"; "tree"] at_path value in
  let* b := member "to" read_or_null at_path members in
  let* twists := member "twists" (read_sized 2 "two twists" (read_twist s)) at_path members in
  let* e := member "walls" (read_matrix s) at_path members in
  let* a := member "direction" (read_matrix s) at_path members in
  let* tree := member "tree" (read_nodes s) at_path members in
  Fine (SegmentByDegree b (nth 0 twists []) (nth 1 twists []) e a tree).

Fixpoint read_segments_from (s : shape) (goes_on : bool) (index : Z) (at_path : path)
  (items : list json) (done : list segment) : result (list segment) :=
  match items with
  | [] => Fine (rev_append done [])
  | Object members :: rest =>
      match read_segment_by_degree s (Element index :: at_path) (Object members) with
      | Fine it => read_segments_from s false (index + 1) at_path rest (it :: done)
      | Malformed where_ found problem => Malformed where_ found problem
      end
  | item :: rest =>
      match read_segment s goes_on (Element index :: at_path) item with
      | Fine it =>
          let ends := match it with Segment _ (Point (Some _) _) => true | _ => false end in
          read_segments_from s ends (index + 1) at_path rest (it :: done)
      | Malformed where_ found problem => Malformed where_ found problem
      end
  end.

Definition read_segments (s : shape) (at_path : path) (value : json)
  : result (list segment) :=
  match value with
  | Array items => read_segments_from s false 0 at_path items []
  | _ => expected "an array of segments" at_path value
  end.

(** POINT of a claim. *)
Definition read_spatial_point (s : shape) (at_path : path) (value : json) : result witness :=
  let* members := members_in_order ["twist"; "shares"] at_path value in
  let* d := member "twist" (read_twist s) at_path members in
  let* them := member "shares" (read_shares s) at_path members in
  Fine (Witness d them).

Definition is_point (value : json) : bool :=
  match value with Object members => has_member "shares" members | _ => false end.

(** CLAIM. *)
Definition read_claim (s : shape) (at_path : path) (value : json) : result claim :=
  let what := "[""stable"", low, high, part], [""stable"", low, high, point, point] or "
              ++ "[""unstable"", low, high, tree]" in
  let one_or_two := "one point where low = high or high is null, else two" in
  match value with
  | Array (kind :: a :: b :: evidence) =>
      let* a := read_fraction at_path a in
      let* b := read_or_null at_path b in
      let two := match b with Some b => negb (Qeq_bool a b) | None => false end in
      if is_text "stable" kind then
        match evidence with
        | [first; second] =>
            let* _ := check_that two at_path one_or_two in
            let* p := read_spatial_point s at_path first in
            let* q := read_spatial_point s at_path second in
            Fine (ClaimStable a b (inr [p; q]))
        | [only] =>
            if is_point only then
              let* _ := check_that (negb two) at_path one_or_two in
              let* p := read_spatial_point s at_path only in
              Fine (ClaimStable a b (inr [p]))
            else let* it := read_part s at_path only in Fine (ClaimStable a b (inl it))
        | _ => expected what at_path value
        end
      else
        match is_text "unstable" kind, evidence with
        | true, [tree] => let* it := read_nodes s at_path tree in Fine (ClaimUnstable a b it)
        | _, _ => expected what at_path value
        end
  | _ => expected what at_path value
  end.

(** Rigid contacts: nodes. *)
Definition read_multiplier (at_path : path) (value : json) : result (Z * Q) :=
  match value with
  | Array [contact; number] =>
      let* i := read_index at_path contact in
      let* x := read_fraction at_path number in
      Fine (i, x)
  | _ => expected "[contact, number]" at_path value
  end.

Definition read_rigid_node (s : shape) (at_path : path) (value : json) : result rigid_node :=
  let problem := if spatial s then "touch and a contact, slip, a contact and a vector, or leaf, t, y and two lists"
                 else "touch or slip and a contact, or leaf, t, y and two lists" in
  match value with
  | Array [Text kind; index] =>
      if kind =? "touch" then let* i := read_index at_path index in Fine (RTouch i)
      else if (kind =? "slip") && negb (spatial s) then let* i := read_index at_path index in Fine (RSlip i [])
      else expected problem at_path value
  | Array [Text kind; index; side] =>
      if (kind =? "slip") && spatial s then
        let* i := read_index at_path index in
        let* d := read_numbers 3 at_path side in
        Fine (RSlip i d)
      else expected problem at_path value
  | Array [Text kind; t; y; along; across] =>
      if kind =? "leaf" then
        let* t := read_fraction at_path t in
        let* y := read_twist s at_path y in
        let* g := read_array "an array [[contact, number], ...]" read_multiplier at_path along in
        let* h := read_shares s at_path across in
        Fine (RLeaf t y g h)
      else expected problem at_path value
  | _ => expected problem at_path value
  end.

(** The text, member by member. *)
Definition next (name : string) (members : list (string * json))
  : result (json * list (string * json)) :=
  match members with
  | (key, value) :: rest =>
      if key =? name then Fine (value, rest)
      else refuse [Member key] ("expected the member """ ++ name ++ """ here")
  | [] => refuse [] ("the object ends, expected """ ++ name ++ """")
  end.

Definition next_read {A : Type} (name : string) (read : path -> json -> result A)
  (members : list (string * json)) : result (A * list (string * json)) :=
  let* '(value, rest) := next name members in
  let* it := read [Member name] value in
  Fine (it, rest).

Definition begins_with (name : string) (members : list (string * json)) : bool :=
  match members with (key, _) :: _ => key =? name | [] => false end.

Definition finish {A : Type} (it : A * list (string * json)) : result A :=
  match it with
  | (value, []) => Fine value
  | (_, (key, _) :: _) => refuse [Member key] "a member too many"
  end.

Definition default_bits : Z := 128.

Definition read_bits (at_path : path) (value : json) : result Z :=
  let* b := read_index at_path value in
  if (64 <=? b)%Z && (b <=? 4096)%Z then Fine b
  else expected "an integer from 64 to 4096" at_path value.

Definition read_verdict (s : shape) (at_path : path) (value : json) : result bool :=
  if of_margin s then
    if is_text "margin" value then Fine true
    else expected """margin"", as the question has a direction" at_path value
  else if is_text "stable" value then Fine true
  else if is_text "unstable" value then Fine false
  else expected """stable"" or ""unstable"", as the question has no direction" at_path value.

Definition read_body (s : shape) (good : bool) (members : list (string * json)) : result proof :=
  if of_margin s then
    if of_claims s then
      let* it := next_read "intervals" (read_array "an array of claims" (read_claim s)) members in
      let* claims := finish it in
      Fine (MarginInSpace claims)
    else
      let* '(resisted, rest) :=
        next_read "resisted" (read_array "an array of intervals" read_resisted) members in
      let* '(segments, rest) := next_read "segments" (read_segments s) rest in
      let* it := next_read "tree" (read_nodes s) rest in
      let* tree := finish it in
      Fine (MarginBy resisted segments tree)
  else if good then
    if begins_with "parts" members then
      let* it := next_read "parts" (read_array "an array of parts" (read_part s)) members in
      let* parts := finish it in
      Fine (StableByParts parts)
    else
      let* '(d, rest) := next_read "twist" (read_twist s) members in
      let* it := next_read "shares" (read_shares s) rest in
      let* them := finish it in
      Fine (StableByWitness (Witness d them))
  else
    let* it := next_read "tree" (read_nodes s) members in
    let* tree := finish it in
    Fine (UnstableByTree tree).

(** POINT of a piece of a plane of loads. *)
Definition read_load_point (s : shape) (at_path : path) (value : json) : result load_point :=
  let what := "[""at"", s, t, twist, shares] or [""towards"", s, t, twist, shares]" in
  match value with
  | Array [kind; a; b; motion; list] =>
      if is_text "at" kind || is_text "towards" kind then
        let* a := read_fraction at_path a in
        let* b := read_fraction at_path b in
        let* d := read_twist s at_path motion in
        let* them := read_shares s at_path list in
        Fine (LoadPoint (is_text "at" kind) a b (Witness d them))
      else expected what at_path value
  | _ => expected what at_path value
  end.

Definition read_region (s : shape) (members : list (string * json)) : result proof :=
  let* '(verdict, rest) := next "verdict" members in
  if is_text "region" verdict then
    let* '(pieces, rest) :=
      next_read "pieces" (read_array "an array of pieces" (read_array "an array of points" (read_load_point s))) rest in
    let* it := next_read "tree" (read_nodes s) rest in
    let* tree := finish it in
    Fine (RegionBy pieces tree)
  else expected """region"", as the question has a plane" [Member "verdict"] verdict.

(** The verdict about rigid contacts, and what proves it. *)
Definition read_class (s : shape) (members : list (string * json)) : result proof :=
  let* '(verdict, rest) := next "verdict" members in
  if is_text "must move" verdict then
    let* it := next_read "twist" (read_twist s) rest in
    let* y := finish it in
    Fine (OfClass (ByTwist y))
  else if is_text "must hold" verdict then
    let* '(f, rest) := next_read "rest" (read_forces s) rest in
    let* it := next_read "tree" (read_array "an array of nodes" (read_rigid_node s)) rest in
    let* tree := finish it in
    Fine (OfClass (ByTree f tree))
  else if is_text "open" verdict then
    let* '(f, rest) := next_read "rest" (read_forces s) rest in
    let* '(a, rest) := next_read "acceleration" (read_twist s) rest in
    let* it := next_read "forces" (read_forces s) rest in
    let* g := finish it in
    Fine (OfClass (ByMotion f a g))
  else expected "must move, must hold or open, as the question has an inertia" [Member "verdict"] verdict.

(** Statics: a load point with forces, and what proves a verdict. *)
Definition read_stand (s : shape) (at_path : path) (value : json) : result (list Q * stated_forces) :=
  match value with
  | Array [point; forces] =>
      let* x := read_sized (if of_plane s then 3 else 2) "an array of the numbers of a load point" read_fraction at_path point in
      let* f := read_forces s at_path forces in
      Fine (x, f)
  | _ => expected "[load point, forces]" at_path value
  end.

Definition read_statics (s : shape) (members : list (string * json)) : result proof :=
  let* '(verdict, rest) := next "verdict" members in
  if of_plane s || of_margin s then
    if is_text (if of_plane s then "region" else "margin") verdict then
      let* '(stand, rest) := next_read "stand" (read_array "an array of load points with forces" (read_stand s)) rest in
      let* it := next_read "move" (read_array "an array of twists" (read_twist s)) rest in
      let* move := finish it in
      Fine (OfStatics (ByPoints stand move))
    else expected (if of_plane s then """region"", as the question has a plane" else """margin"", as the question has a direction")
           [Member "verdict"] verdict
  else if is_text "may stand" verdict then
    let* it := next_read "forces" (read_forces s) rest in
    let* f := finish it in
    Fine (OfStatics (ByForces f))
  else if is_text "must move" verdict then
    let* it := next_read "twist" (read_twist s) rest in
    let* y := finish it in
    Fine (OfStatics (ByMove y))
  else expected """may stand"" or ""must move"", as the question is of statics" [Member "verdict"] verdict.

Definition read_known_format (at_path : path) (value : json) : result unit :=
  if is_text "stickslip-certificate/2" value then Fine tt
  else expected """stickslip-certificate/2"", the only one that this program knows" at_path value.

Definition read_certificate (q : question) (value : json) : result (statement * certificate) :=
  let asked (margin plane class statics : bool) : shape :=
    {| spatial := match several q with Some its => bodies_in_space its | None => Nat.eqb (dimension q) 6 end;
       of_bodies := match several q with Some _ => true | None => false end;
       size_of_twist := Z.of_nat (dimension q);
       soft := map_all (fun it => negb (is_0 (torsion it))) (contacts q);
       of_claims := has_claims q;
       of_margin := margin;
       of_plane := plane;
       of_class := class;
       of_statics := statics |} in
  match value with
  | Object members =>
      let* '(_, rest) := next_read "format" read_known_format members in
      let* rest :=
        if begins_with "producer" rest
        then let* '(_, rest) := next_read "producer" read_any_text rest in Fine rest
        else Fine rest in
      let* '(stated, rest) := next_read "question" (read_statement (asked false false false false)) rest in
      let o := options_stated stated in
      let s := asked (asks_margin o) (asks_plane o) (asks_class o && negb (asks_margin o || asks_plane o || asks_statics o))
                 (asks_statics o) in
      let* '(b, rest) :=
        if begins_with "bits" rest && (negb (of_margin s) || of_claims s) && negb (of_class s || of_plane s || of_statics s)
        then next_read "bits" read_bits rest
        else Fine (default_bits, rest) in
      if of_statics s then let* it := read_statics s rest in Fine (stated, Certificate b it)
      else if of_plane s then let* it := read_region s rest in Fine (stated, Certificate b it)
      else if of_class s then let* it := read_class s rest in Fine (stated, Certificate b it)
      else
        let* '(good, rest) := next_read "verdict" (read_verdict s) rest in
        let* it := read_body s good rest in
        Fine (stated, Certificate b it)
  | _ => expected "an object {...}" [] value
  end.

(** The rules `question-...`: the first that fails, if one does. *)
Fixpoint same_list {A : Type} (same : A -> A -> bool) (a b : list A) : bool :=
  match a, b with
  | [], [] => true
  | x :: others, y :: rest => same x y && same_list same others rest
  | _, _ => false
  end.

Definition same_option {A : Type} (same : A -> A -> bool) (a b : option A) : bool :=
  match a, b with
  | None, None => true
  | Some x, Some y => same x y
  | _, _ => false
  end.

Definition same_interval (a b : interval) : bool :=
  Qeq_bool (low a) (low b) && Qeq_bool (high a) (high b).

Definition same_growth (a b : growth) : bool :=
  match a, b with
  | Scale, Scale => true
  | By x, By y => same_list Qeq_bool x y
  | _, _ => false
  end.

Definition same_tolerance (a b : tolerance) : bool :=
  Qeq_bool (amount a) (amount b) && Bool.eqb (percent a) (percent b).

Definition same_ball (a b : stated_ball) : bool :=
  Qeq_bool (stated_radius a) (stated_radius b) && Qeq_bool (stated_length a) (stated_length b)
  && same_list Qeq_bool (stated_point a) (stated_point b)
  && same_option String.eqb (stated_body a) (stated_body b).

Definition same_bound (a b : bound_option) : bool :=
  match a, b with
  | Unbounded, Unbounded => true
  | Bounded x, Bounded y => same_list Qeq_bool x y
  | _, _ => false
  end.

Definition broken_question_rule (stated : statement) (asked : posed) : option string :=
  let said := options_stated stated in
  let options := the_options asked in
  let count {A : Type} (items : list A) := fold_left (fun count _ => count + 1)%Z items 0%Z in
  let q := the_question asked in
  let m := (count (contacts q) + match several q with Some its => count (elements its) | None => 0 end)%Z in
  if negb (stated_contacts stated =? m)%Z then Some "question-contacts"
  else if negb (same_list same_interval (wrench_stated stated) (stated_wrench asked))
  then Some "question-wrench"
  else if negb (same_option Qeq_bool (asked_preload said) (asked_preload options))
  then Some "question-preload"
  else if negb (Bool.eqb (asked_bilateral said) (asked_bilateral options)) then Some "question-law"
  else if negb (same_option (same_list Qeq_bool) (asked_direction said) (asked_direction options))
  then Some "question-direction"
  else if negb (same_option same_growth (asked_growth said) (asked_growth options))
  then Some "question-preload-direction"
  else if negb (same_option (fun a b => same_list Qeq_bool (fst a) (fst b) && same_list Qeq_bool (snd a) (snd b))
                  (asked_plane said) (asked_plane options))
  then Some "question-plane"
  else if negb (same_option (same_list Qeq_bool) (asked_inertia said) (asked_inertia options))
  then Some "question-inertia"
  else if negb (same_option Qeq_bool (asked_statics said) (asked_statics options)) then Some "question-statics"
  else if negb (forallb (fun kind => same_option same_tolerance (find_tolerance kind said)
                                       (find_tolerance kind options)) uncertain_kinds
                  && same_option same_ball (asked_ball said) (asked_ball options))
  then Some "question-uncertain"
  else if negb (same_option same_bound (asked_bound said) (asked_bound options)) then Some "question-max-motion"
  else None.
