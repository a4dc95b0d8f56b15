(* SPDX-License-Identifier: MIT *)
(** The grasp file, `stickslip-grasp/1` or `/2`: FORMAT.md sections 1, 6 and 7, and
    docs/grasp_file.md. *)
From Coq Require Import Bool List QArith String ZArith.
From Proved Require Import Json Numeral Question Root.
Import ListNotations.
Local Open Scope string_scope.
Local Open Scope Z_scope.

Definition add_intervals (a b : interval) : interval :=
  Interval (low a + low b) (high a + high b).

(** As the file gives it: positions have 2 coordinates in the plane and 3 in space, and no preload
    grows. *)
Record grasp : Set := {
  in_space : bool;
  coordinates_read : nat;  (** D *)
  bodies_read : option mechanism;  (** of several bodies: ReadBodies.v *)
  body_names : list string;
  names_of_bodies : list string;  (** of their coordinates *)
  names_of_joints : list (option string);
  all_contacts : list contact;
  common_wrench : list interval;  (** with cases, what is added to each *)
  has_loads : bool;  (** so that no case has to be chosen *)
  bound_read : option (list Q);  (** of motions, D numbers *)
  cases : list (string * list interval) }.

Definition most_contacts : Z := 1000000.

(** What is known of a file before its numbers are read. *)
Record version : Set := { is_second : bool; is_in_space : bool }.
Definition coordinates (v : version) : Z := if is_in_space v then 3 else 2.
Definition components (v : version) : Z := if is_in_space v then 6 else 3.

Definition needs_second : string := "it needs ""format"": ""stickslip-grasp/2""".

Fixpoint has_length {A : Type} (size : Z) (items : list A) : bool :=
  match items with
  | [] => size =? 0
  | _ :: rest => (0 <? size) && has_length (size - 1) rest
  end.

Definition read_sized {A : Type} (size : Z) (what : string) (read : path -> json -> result A)
  (at_path : path) (value : json) : result (list A) :=
  match value with
  | Array items => if has_length size items then each read at_path items
                   else expected what at_path value
  | _ => expected what at_path value
  end.

Definition read_point (v : version) : path -> json -> result (list Q) :=
  read_sized (coordinates v)
    (if is_in_space v then "3 coordinates [x, y, z]" else "2 coordinates [x, y]") read_decimal.

Definition is_0 (x : Q) : bool := Qnum x =? 0.
Definition is_below (x y : Q) : bool := negb (Qle_bool y x).
Definition sum_of_squares (v : list Q) : Q := fold_right (fun x sum => x * x + sum)%Q 0%Q v.

(** A number or an INTERVAL. *)
Definition read_interval (v : version) (at_path : path) (value : json) : result interval :=
  match value with
  | Object _ =>
      let* _ := check_that (is_second v) at_path needs_second in
      let* members := members_of ["min"; "max"] at_path value in
      let* least := member "min" read_decimal at_path members in
      let* most := member "max" read_decimal at_path members in
      let* _ := check_that (Qle_bool least most) at_path "expected min <= max" in
      Fine (Interval least most)
  | _ => let* x := read_decimal at_path value in Fine (exactly x)
  end.

Definition read_wrench (v : version) : path -> json -> result (list interval) :=
  read_sized (components v)
    (if is_in_space v then "an array [force x, force y, force z, torque x, torque y, torque z]"
     else "an array [force x, force y, torque]") (read_interval v).

(** Friction, stiffness and preload, of a contact or in the defaults. *)
Record properties : Set := {
  own_friction : option interval; own_stiffness : option interval; own_preload : option interval }.

Definition read_property (v : version) (positive : bool) (at_path : path) (value : json)
  : result interval :=
  let* it := read_interval v at_path value in
  if if positive then is_below 0 (low it) else Qle_bool 0 (low it) then Fine it
  else expected (if positive then "a number above 0" else "a number of 0 or more") at_path value.

Definition read_properties (v : version) (at_path : path) (members : list (string * json))
  : result properties :=
  let* mu := optional_member "friction" (read_property v false) at_path members in
  let* k := optional_member "stiffness" (read_property v true) at_path members in
  let* p := optional_member "preload" (read_property v false) at_path members in
  Fine {| own_friction := mu; own_stiffness := k; own_preload := p |}.

Definition read_defaults (v : version) (at_path : path) (value : json) : result properties :=
  let* members := members_of ["friction"; "stiffness"; "preload"] at_path value in
  read_properties v at_path members.

(** The outline: its edges, and on which side of them the body is. *)
Record edge : Set := { from : list Q; to : list Q; inwards : list Q }.

(** Of arrays, first elements within first elements. *)
Fixpoint depth_of (value : json) : Z :=
  match value with
  | Array (first :: _) => 1 + depth_of first
  | Array [] => 1
  | _ => 0
  end.

Definition same (a b : list Q) : bool := forallb (fun '(x, y) => Qeq_bool x y) (combine a b).

(** Each element with the next, and the last with the first. *)
Fixpoint pairs_to {A : Type} (last : A) (items : list A) (done : list (A * A)) : list (A * A) :=
  match items with
  | [] => rev_append done []
  | [item] => rev_append ((item, last) :: done) []
  | item :: (next :: _) as rest => pairs_to last rest ((item, next) :: done)
  end.
Definition pairs {A : Type} (items : list A) : list (A * A) :=
  match items with [] => [] | first :: _ => pairs_to first items [] end.

Definition cross (a b : list Q) : Q :=
  match a, b with
  | [ax; ay], [bx; by_] => ax * by_ - ay * bx
  | _, _ => 0
  end.

(** [n] with the length 1 if its length is rational. *)
Definition with_length_1 (n : list Q) : list Q :=
  match exact_root (sum_of_squares n) with
  | Some length => map (fun x => x / length)%Q n
  | None => n
  end.

Definition make_edge (side : Q) (ends : list Q * list Q) : edge :=
  let n :=
    match ends with
    | ([ax; ay], [bx; by_]) => [side * (ay - by_); side * (bx - ax)]%Q
    | _ => []
    end in
  {| from := fst ends; to := snd ends; inwards := with_length_1 n |}.

Definition read_ring (v : version) (hole : bool) (at_path : path) (value : json)
  : result (list edge) :=
  let what := "a ring of three vertices [x, y] or more"%string in
  let* ring := read_array what (read_point v) at_path value in
  let* _ := match ring with
            | _ :: _ :: _ :: _ => Fine tt
            | _ => expected what at_path value
            end in
  let sides := pairs ring in
  let* _ := check_that (negb (existsb (fun '(a, b) => same a b) sides)) at_path
              "a vertex is the same as the next" in
  let area := fold_left (fun sum '(a, b) => sum + cross a b)%Q sides 0%Q in
  let* _ := check_that (negb (is_0 area)) at_path "the ring has no area" in
  let side := inject_Z (if hole then - Z.sgn (Qnum area) else Z.sgn (Qnum area)) in
  Fine (map (make_edge side) sides).

(** The edges of a polygon, those of one ring after another. *)
Definition read_polygon (v : version) (at_path : path) (value : json) : result (list edge) :=
  let what := "a list of rings, of one or more"%string in
  match value with
  | Array (outer :: holes) =>
      let* first := read_ring v false (Element 0 :: at_path) outer in
      let* others := each_from (read_ring v true) 1 at_path holes [] in
      Fine (first ++ List.concat others)%list
  | _ => expected what at_path value
  end.

(** A list of polygons, a list of rings, or a ring. *)
Definition read_outline (v : version) (at_path : path) (value : json)
  : result (list (list edge)) :=
  let* _ := check_that (negb (is_in_space v)) at_path "expected none, as the grasp is in space" in
  let what := "a list of polygons [[[[x, y], ...]]]"%string in
  let depth := depth_of value in
  if depth <=? 1 then expected what at_path value
  else
    read_array what (read_polygon v) at_path
      (if depth =? 2 then Array [Array [value]] else if depth =? 3 then Array [value] else value).

(** The body in space, which has no meaning here: [count] vertices, of which faces name three or
    more each. *)
Definition read_vertex_number (count : Z) (at_path : path) (value : json) : result unit :=
  let* index := read_decimal at_path value in
  let whole := Qnum index / Zpos (Qden index) in
  check_that (Qeq_bool index (inject_Z whole) && (0 <=? whole) && (whole <? count)) at_path
    "there is no such vertex".

Definition read_face (count : Z) (at_path : path) (value : json) : result unit :=
  let what := "a face of three vertices or more"%string in
  let* face := read_array what (read_vertex_number count) at_path value in
  match face with
  | _ :: _ :: _ :: _ => Fine tt
  | _ => expected what at_path value
  end.

Definition read_body (v : version) (at_path : path) (value : json) : result unit :=
  let* _ := check_that (is_in_space v) at_path "expected none, as the grasp is in the plane" in
  let* members := members_of ["vertices"; "faces"]%string at_path value in
  let* vertices := member "vertices" (read_array "a list of vertices" (read_point v)) at_path
                     members in
  let count := fold_left (fun sum _ => sum + 1) vertices 0 in
  let what := "a list of faces, of one or more"%string in
  let* faces := member "faces" (read_array what (read_face count)) at_path members in
  match faces with
  | [] => expected what (Member "faces"%string :: at_path) value
  | _ => Fine tt
  end.

(** Loads. *)
Definition at_point (p f : list Q) : list Q :=
  match p, f with
  | [x; y], [fx; fy] => [fx; fy; x * fy - y * fx]%Q
  | [x; y; z], [fx; fy; fz] => [fx; fy; fz; y * fz - z * fy; z * fx - x * fz; x * fy - y * fx]%Q
  | _, _ => []
  end.

(** The force of a weight. *)
Definition read_pull (v : version) (at_path : path) (members : list (string * json))
  : result (list Q) :=
  let* size := member "weight" read_decimal at_path members in
  let* _ := check_that (Qle_bool 0 size) (Member "weight" :: at_path)
              "expected a number of 0 or more" in
  let* direction := optional_member "direction" (read_point v) at_path members in
  match direction with
  | None => Fine (if is_in_space v then [0; 0; - size] else [0; - size])%Q
  | Some d =>
      match exact_root (sum_of_squares d) with
      | Some length =>
          let* _ := check_that (negb (is_0 length)) (Member "direction" :: at_path)
                      "expected a vector other than 0" in
          Fine (map (fun x => size * x / length)%Q d)
      | None => refuse (Member "direction" :: at_path)
                  "expected a vector of rational length, such as [3, -4]"
      end
  end.

Definition read_torque (v : version) (at_path : path) (value : json) : result (list Q) :=
  if is_in_space v then
    let* t := read_point v at_path value in Fine ([0%Q; 0%Q; 0%Q] ++ t)%list
  else let* t := read_decimal at_path value in Fine [0; 0; t]%Q.

Definition read_load (v : version) (at_path : path) (value : json) : result (list Q) :=
  let has name := match value with Object members => has_member name members | _ => false end in
  if has "torque"%string then
    let* members := members_of ["torque"] at_path value in
    member "torque" (read_torque v) at_path members
  else
    let* members := members_of (if has "weight"%string then ["weight"; "at"; "direction"]
                                else ["force"; "at"])%string at_path value in
    let* force := if has "weight"%string then read_pull v at_path members
                  else member "force" (read_point v) at_path members in
    let* p := member "at" (read_point v) at_path members in
    Fine (at_point p force).

Definition no_wrench (v : version) : list interval :=
  repeat (exactly 0) (if is_in_space v then 6 else 3)%nat.

Definition add_wrench (a b : list interval) : list interval :=
  map (fun '(x, y) => add_intervals x y) (combine a b).

Definition read_loads (v : version) (at_path : path) (value : json) : result (list interval) :=
  let* loads := read_array "an array of loads" (read_load v) at_path value in
  Fine (fold_left (fun sum load => add_wrench sum (map exactly load)) loads (no_wrench v)).

Definition read_name (at_path : path) (value : json) : result string :=
  match value with
  | Text "" => expected "a string that is not empty" at_path value
  | Text name => Fine name
  | _ => expected "a string that is not empty" at_path value
  end.

Definition read_case (v : version) (at_path : path) (value : json)
  : result (string * list interval) :=
  let* members := members_of ["name"; "wrench"; "loads"] at_path value in
  let* name := member "name" read_name at_path members in
  let* own := optional_member "wrench" (read_wrench v) at_path members in
  let* loads := optional_member "loads" (read_loads v) at_path members in
  match own, loads with
  | Some w, None | None, Some w => Fine (name, w)
  | _, _ => refuse at_path "expected one of the members ""wrench"" and ""loads"""
  end.

Fixpoint check_names (at_path : path) (names : list string) : result unit :=
  match names with
  | [] => Fine tt
  | name :: rest =>
      let* _ := check_that (negb (is_among name rest)) at_path
                  ("the name """ ++ name ++ """ appears twice") in
      check_names at_path rest
  end.

Definition read_list_of_cases (read : path -> json -> result (string * list interval)) (at_path : path) (value : json)
  : result (list (string * list interval)) :=
  let what := "an array of one case or more"%string in
  let* them := read_array what read at_path value in
  let* _ := match them with [] => expected what at_path value | _ => Fine tt end in
  let* _ := check_names at_path (map fst them) in
  Fine them.

(** The bound of motions: of each coordinate, or where there are no joints of all lengths and of all angles. *)
Definition bound_of (in_space : bool) (count : nat) (length angle : Q) : list Q :=
  let '(size, lengths) := if in_space then (6, 3)%nat else (3, 2)%nat in
  map (fun j => if Nat.ltb (Nat.modulo j size) lengths then length else angle) (seq 0 count).

Definition read_above_0 (at_path : path) (value : json) : result Q :=
  let* x := read_decimal at_path value in
  let* _ := check_that (is_below 0 x) at_path "expected a number above 0" in
  Fine x.

Definition read_bound (in_space joints : bool) (count : nat) (at_path : path) (value : json) : result (list Q) :=
  match value with
  | Object _ =>
      let* _ := check_that (negb joints) at_path "expected an array of a number for each coordinate, as there are joints" in
      let* members := members_of ["length"; "angle"] at_path value in
      let* length := member "length" read_above_0 at_path members in
      let* angle := member "angle" read_above_0 at_path members in
      Fine (bound_of in_space count length angle)
  | _ => read_sized (Z.of_nat count) "an array of a number for each coordinate, or an object of length and angle"
           read_above_0 at_path value
  end.

(** Contacts. *)
Fixpoint nth_from {A : Type} (index : Z) (items : list A) : option A :=
  match items with
  | [] => None
  | item :: rest => if index =? 0 then Some item else nth_from (index - 1) rest
  end.

(** The element that a whole number counted from 0 names. *)
Definition choose {A : Type} (index : Q) (items : list A) : option A :=
  let whole := Qnum index / Zpos (Qden index) in
  if Qle_bool 0 index && Qeq_bool index (inject_Z whole) then nth_from whole items else None.

Definition read_on (outline : list (list edge)) (at_path : path) (value : json)
  : result (list interval * list Q) :=
  let* '(polygon, number, share) :=
    match value with
    | Array [number; share] =>
        let* number := read_decimal (Element 0 :: at_path) number in
        let* share := read_decimal (Element 1 :: at_path) share in
        Fine (0%Q, number, share)
    | Array _ => expected "[edge, share], or an object" at_path value
    | _ =>
        let* members := members_of ["polygon"; "edge"; "share"] at_path value in
        let* polygon := optional_member "polygon" read_decimal at_path members in
        let* number := member "edge" read_decimal at_path members in
        let* share := member "share" read_decimal at_path members in
        Fine (match polygon with Some it => it | None => 0%Q end, number, share)
    end in
  let* _ := check_that (Qle_bool 0 share && Qle_bool share 1) at_path "expected a share from 0 to 1" in
  match choose polygon outline with
  | None => refuse at_path "there is no such polygon"
  | Some edges =>
      match choose number edges with
      | None => refuse at_path "there is no such edge"
      | Some it =>
          let p := map (fun '(a, b) => exactly (a + share * (b - a)))%Q
                     (combine (from it) (to it)) in
          Fine (p, inwards it)
      end
  end.

(** A vector, or one with a slope. *)
Definition read_normal (v : version) (at_path : path) (value : json) : result (list Q * Q) :=
  let* '(n, slope) :=
    match value with
    | Object _ =>
        let* _ := check_that (is_second v) at_path needs_second in
        let* members := members_of ["direction"; "slope"] at_path value in
        let* n := member "direction" (read_point v) at_path members in
        let* slope := member "slope" read_decimal at_path members in
        let* _ := check_that (Qle_bool 0 slope && is_below slope 1) (Member "slope" :: at_path)
                    "expected a number of 0 or more and below 1" in
        Fine (n, slope)
    | _ => let* n := read_point v at_path value in Fine (n, 0%Q)
    end in
  let* _ := check_that (negb (forallb is_0 n)) at_path
              "the normal is 0; give a vector into the object" in
  Fine (n, slope).

(** What a contact does not say itself, [defaults] say, and else 1 and 0. *)
Definition read_contact (v : version) (outline : list (list edge)) (defaults : properties)
  (at_path : path) (value : json) : result contact :=
  let* members :=
    members_of ["position"; "normal"; "on"; "friction"; "stiffness"; "preload"] at_path value in
  let* '(p, n, e) :=
    match find_member "on" members with
    | Some on =>
        let here := Member "on" :: at_path in
        let* _ := check_that (is_second v) here needs_second in
        let* _ := check_that (negb (is_in_space v)) here
                    "expected a position and a normal, as the grasp is in space" in
        let* _ := check_that (negb (has_member "position" members || has_member "normal" members))
                    here "it stands in place of ""position"" and ""normal""" in
        let* '(p, n) := read_on outline here on in
        Fine (p, n, 0%Q)
    | None =>
        let* p := member "position" (read_sized (coordinates v)
                    (if is_in_space v then "3 coordinates [x, y, z], as the first contact has"
                     else "2 coordinates [x, y], as the first contact has") (read_interval v))
                    at_path members in
        let* '(n, e) := member "normal" (read_normal v) at_path members in
        Fine (p, n, e)
    end in
  let* own := read_properties v at_path members in
  let or (mine default : option interval) : option interval :=
    match mine with Some _ => mine | None => default end in
  let or_number (mine : option interval) (number : Q) : interval :=
    match mine with Some it => it | None => exactly number end in
  match or (own_friction own) (own_friction defaults) with
  | None => refuse at_path "the member ""friction"" is missing, and ""defaults"" has none"
  | Some mu =>
      Fine {| position := p; normal := n; slope := e; friction := mu;
              stiffness := or_number (or (own_stiffness own) (own_stiffness defaults)) 1%Q;
              preload := or_number (or (own_preload own) (own_preload defaults)) 0%Q;
              preload_growth := 0%Q; of_body := None; by_body := None; torsion := 0%Q |}
  end.

(** The whole file. *)
Definition read_format (at_path : path) (value : json) : result bool :=
  if is_text "stickslip-grasp/2" value then Fine true
  else if is_text "stickslip-grasp/1" value then Fine false
  else expected """stickslip-grasp/1"", ""stickslip-grasp/2"" or ""stickslip-grasp/3""" at_path value.

Definition read_any_text (at_path : path) (value : json) : result unit :=
  match value with Text _ => Fine tt | _ => expected "a string" at_path value end.

(** [String.length] counts in unary numbers. *)
Definition is_unit (name : string) : bool :=
  match name with
  | "" => false
  | _ => negb (is_longer_than 16 (list_ascii_of_string name))
  end%string.

Definition read_unit (at_path : path) (value : json) : result unit :=
  match value with
  | Text name => if is_unit name then Fine tt else expected "a string of 1 to 16 bytes" at_path value
  | _ => expected "a string of 1 to 16 bytes" at_path value
  end.

Definition read_units (at_path : path) (value : json) : result unit :=
  let* members := members_of ["length"; "force"] at_path value in
  let* _ := member "length" read_unit at_path members in
  member "force" read_unit at_path members.

Definition is_array (size : Z) (value : option json) : bool :=
  match value with Some (Array items) => has_length size items | _ => false end.

(** Whether the first contact has three coordinates, or the wrench six where there are no contacts. *)
Definition begins_in_space (members : list (string * json)) : bool :=
  match find_member "contacts" members with
  | Some (Array []) => is_array 6 (find_member "wrench" members)
  | Some (Array (Object first :: _)) => is_array 3 (find_member "position" first)
  | _ => false
  end.

Definition version_of (members : list (string * json)) : result version :=
  let* second := member "format" read_format [] members in
  let only_second name :=
    check_that (second || negb (has_member name members)) [Member name] needs_second in
  let* _ := only_second "units"%string in
  let* _ := only_second "outline"%string in
  let* _ := only_second "body"%string in
  let* _ := only_second "loads"%string in
  let* _ := only_second "cases"%string in
  let* _ := only_second "max_motion"%string in
  Fine {| is_second := second; is_in_space := second && begins_in_space members |}.

Definition read_grasp (value : json) : result grasp :=
  let* members :=
    members_of ["format"; "name"; "units"; "outline"; "body"; "defaults"; "contacts"; "wrench";
                "loads"; "cases"; "max_motion"] [] value in
  let* v := version_of members in
  let* _ := optional_member "name" read_any_text [] members in
  let* _ := optional_member "units" read_units [] members in
  let* outline := optional_member "outline" (read_outline v) [] members in
  let* _ := optional_member "body" (read_body v) [] members in
  let* defaults := optional_member "defaults" (read_defaults v) [] members in
  let outline := match outline with Some it => it | None => [] end in
  let defaults :=
    match defaults with
    | Some it => it
    | None => {| own_friction := None; own_stiffness := None; own_preload := None |}
    end in
  let read_contacts at_path value :=
    match value with
    | Array items =>
        let* _ := check_that (negb (is_longer_than most_contacts items)) at_path "too many contacts" in
        each (read_contact v outline defaults) at_path items
    | _ => expected "an array of contacts" at_path value
    end in
  let* them := member "contacts" read_contacts [] members in
  let* own := optional_member "wrench" (read_wrench v) [] members in
  let* loads := optional_member "loads" (read_loads v) [] members in
  let* named := optional_member "cases" (read_list_of_cases (read_case v)) [] members in
  let count := if is_in_space v then 6%nat else 3%nat in
  let* bound := optional_member "max_motion" (read_bound (is_in_space v) false count) [] members in
  let* _ := check_that (negb (has_member "wrench" members && has_member "loads" members)) []
              "both ""wrench"" and ""loads""; give one of them" in
  let* _ := check_that (has_member "wrench" members || has_member "loads" members
                        || has_member "cases" members) []
              "the member ""wrench"" is missing" in
  let common :=
    match own, loads with Some w, _ | None, Some w => w | None, None => no_wrench v end in
  let named := match named with Some it => it | None => [] end in
  Fine {| in_space := is_in_space v;
          coordinates_read := count;
          bodies_read := None;
          body_names := [];
          names_of_bodies := [];
          names_of_joints := [];
          all_contacts := them;
          common_wrench := common;
          has_loads := false;
          bound_read := bound;
          cases := map (fun '(name, w) => (name, add_wrench w common)) named |}.
