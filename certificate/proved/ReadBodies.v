(* SPDX-License-Identifier: MIT *)
(** The grasp file of several bodies, `stickslip-grasp/3`: FORMAT.md sections 14 and 15. *)
From Coq Require Import Bool List QArith String ZArith.
From Proved Require Import Bodies Json Numeral Question ReadGrasp StaticsRules.
Import ListNotations.
Local Open Scope string_scope.
Local Open Scope Z_scope.

(** Bodies by name, in their order; the motion of one unit is that of a link, eta. *)
Record named_body : Set := { name_of : string; link : option (option nat * list Q) }.

Definition ground : string := "ground".

Fixpoint number_from (name : string) (names : list string) (number : nat) : option nat :=
  match names with
  | [] => None
  | other :: rest => if (other =? name)%string then Some number else number_from name rest (S number)
  end.
Definition number_of (name : string) (bodies : list named_body) : option nat := number_from name (map name_of bodies) 0.

(** All members but these. *)
Definition without (names : list string) (members : list (string * json)) : json :=
  Object (filter (fun '(name, _) => negb (is_among name names)) members).

(** Links. *)
Definition read_axis (v : version) (at_path : path) (value : json) : result (list Q) :=
  let* g := read_point v at_path value in
  let* _ := check_that (negb (forallb is_0 g)) at_path "expected a vector other than 0" in
  Fine g.

Definition read_slide (v : version) (at_path : path) (value : json) : result (list Q) :=
  let* g := read_axis v at_path value in
  Fine (g ++ (if is_in_space v then [0; 0; 0] else [0]))%list%Q.

(** The motion that turns about a line, or in the plane about a point. *)
Definition read_hinge (v : version) (at_path : path) (value : json) : result (list Q) :=
  if is_in_space v then
    let* members := members_of ["at"; "axis"] at_path value in
    let* c := member "at" (read_point v) at_path members in
    let* g := member "axis" (read_axis v) at_path members in
    match c, g with
    | [cx; cy; cz], [gx; gy; gz] =>
        Fine [cy * gz - cz * gy; cz * gx - cx * gz; cx * gy - cy * gx; gx; gy; gz]%Q
    | _, _ => expected "a hinge" at_path value
    end
  else
    let* c := read_point v at_path value in
    match c with [x; y] => Fine [y; - x; 1]%Q | _ => expected "a hinge" at_path value end.

Definition read_on_body (before : list named_body) (at_path : path) (value : json) : result (option nat) :=
  let what := "the name of a body that stands before this one, or ""ground"""%string in
  match value with
  | Text name =>
      match number_of name before with
      | Some number => Fine (Some number)
      | None => if (name =? ground)%string then Fine None else expected what at_path value
      end
  | _ => expected what at_path value
  end.

Definition read_named_body (v : version) (before : list named_body) (at_path : path) (value : json)
  : result named_body :=
  let* members := members_of ["name"; "hinge"; "slide"; "on"; "outline"; "mesh"] at_path value in
  let* name := member "name" read_name at_path members in
  let* _ := check_that (negb (name =? ground)%string) (Member "name" :: at_path) "expected another name than ""ground""" in
  let* hinge := optional_member "hinge" (read_hinge v) at_path members in
  let* slide := optional_member "slide" (read_slide v) at_path members in
  let* on := optional_member "on" (read_on_body before) at_path members in
  let* _ := optional_member "outline" (read_outline v) at_path members in
  let* _ := optional_member "mesh" (read_body v) at_path members in
  let* _ := check_that (match number_of name before with None => true | Some _ => false end) at_path
              ("the name """ ++ name ++ """ appears twice") in
  let linked eta := Fine {| name_of := name; link := Some (match on with Some it => it | None => None end, eta) |} in
  match hinge, slide with
  | Some _, Some _ => refuse at_path "both ""hinge"" and ""slide""; give one of them"
  | Some eta, None | None, Some eta => linked eta
  | None, None =>
      let* _ := check_that (match on with None => true | Some _ => false end) (Member "on" :: at_path)
                  "expected none, as there is neither a ""hinge"" nor a ""slide""" in
      Fine {| name_of := name; link := None |}
  end.

Fixpoint read_bodies_after (v : version) (index : Z) (at_path : path) (items : list json) (before : list named_body)
  : result (list named_body) :=
  match items with
  | [] => Fine before
  | item :: rest =>
      match read_named_body v before (Element index :: at_path) item with
      | Fine it => read_bodies_after v (index + 1) at_path rest (before ++ [it])
      | Malformed where_ found problem => Malformed where_ found problem
      end
  end.

Definition read_bodies (v : version) (at_path : path) (value : json) : result (list named_body) :=
  match value with
  | Array ((_ :: _) as items) => read_bodies_after v 0 at_path items []
  | _ => expected "a list of bodies, of one or more" at_path value
  end.

(** [turns] and [over]: a number for each link that is named. *)
Definition turns_of_links : Set := list (string * Q).

Fixpoint read_all_turns (bodies : list named_body) (at_path : path) (members : list (string * json))
  : result turns_of_links :=
  match members with
  | [] => Fine []
  | (name, value) :: rest =>
      let here := (Member name :: at_path)%list in
      let* _ := check_that (existsb (fun b => (name_of b =? name)%string && match link b with Some _ => true | None => false end)
                              bodies) here "expected a link, which is a body with a ""hinge"" or a ""slide""" in
      let* _ := check_that (negb (has_member name rest)) here "the member appears twice; keep one of them" in
      let* c := read_decimal here value in
      let* _ := check_that (negb (is_0 c)) here "expected a number other than 0" in
      let* others := read_all_turns bodies at_path rest in
      Fine ((name, c) :: others)
  end.

Definition read_turns (bodies : list named_body) (at_path : path) (value : json) : result turns_of_links :=
  match value with
  | Object ((_ :: _) as members) => read_all_turns bodies at_path members
  | _ => expected "an object of one number or more, each by the name of a link" at_path value
  end.

Definition find_turn (name : string) (turns : turns_of_links) : Q :=
  match find (fun '(other, _) => (other =? name)%string) turns with Some (_, c) => c | None => 0%Q end.

(** An element, whose lever is known already. *)
Definition read_element (v : version) (spring : bool) (preload_name : string) (row : list Q) (at_path : path)
  (members : list (string * json)) : result element :=
  let or_0 (it : option interval) : interval := match it with Some i => i | None => exactly 0 end in
  let* k := if spring then optional_member "stiffness" (read_property v false) at_path members
            else let* k := member "stiffness" (read_property v true) at_path members in Fine (Some k) in
  let* p := optional_member preload_name (if spring then read_interval v else read_property v false) at_path members in
  Fine {| lever := row; element_spring := spring; element_stiffness := or_0 k; element_preload := or_0 p;
          element_growth := 0%Q |}.

Definition read_text (at_path : path) (value : json) : result string :=
  match value with Text it => Fine it | _ => expected "a string" at_path value end.

(** A joint: what it turns, and its spring, if it has one, by its lever. *)
Definition read_joint (v : version) (bodies : list named_body) (at_path : path) (value : json)
  : result (turns_of_links * option string * option (list Q -> result element)) :=
  let* members := members_of ["turns"; "name"; "stiffness"; "torque"] at_path value in
  let* name := optional_member "name" read_text at_path members in
  let* turns := member "turns" (read_turns bodies) at_path members in
  Fine (turns, name,
        if has_member "stiffness" members || has_member "torque" members
        then Some (fun row => read_element v true "torque" row at_path members) else None).

Definition sum_of (rows : list (list Q)) (count : nat) : list Q :=
  fold_left (fun sum row => map (fun '(a, b) => (a + b)%Q) (combine sum row)) rows (repeat 0%Q count).

(** A ratchet or a tendon. [turned] is how each link turns, by coordinate. *)
Definition read_over (v : version) (bodies : list named_body) (turned : string -> list Q) (count : nat) (spring : bool)
  (preload_name : string) (at_path : path) (value : json) : result element :=
  let* members := members_of ["over"; "name"; "stiffness"; preload_name] at_path value in
  let* _ := optional_member "name" read_any_text at_path members in
  let* over := member "over" (read_turns bodies) at_path members in
  let row := sum_of (map (fun '(name, r) => map (Qmult r) (turned name)) over) count in
  let* _ := check_that (negb (forallb (fun x => Qeq_bool x 0) row)) (Member "over" :: at_path)
              "expected links that some joint turns, so that its length changes" in
  read_element v spring preload_name row at_path members.

(** A load on a body: its number, and the wrench. *)
Definition read_load_on_body (v : version) (bodies : list named_body) (at_path : path) (value : json)
  : result (nat * list interval) :=
  match value with
  | Object members =>
      let* _ := check_members ["body"; "wrench"; "force"; "at"; "weight"; "direction"; "torque"] at_path members in
      let read_known at_path value :=
        match value with
        | Text name =>
            match number_of name bodies with
            | Some number => Fine number
            | None => expected "the name of one of ""bodies""" at_path value
            end
        | _ => expected "the name of one of ""bodies""" at_path value
        end in
      let* b := member "body" read_known at_path members in
      if has_member "wrench" members then
        let* members := members_of ["body"; "wrench"] at_path value in
        let is_link := match nth_error bodies b with Some it => match link it with Some _ => true | None => false end
                       | None => true end in
        let* _ := check_that (negb is_link) at_path
                    "the body is a link, which takes a force, a weight or a torque, but no wrench" in
        let* w := member "wrench" (read_wrench v) at_path members in
        Fine (b, w)
      else
        let* w := read_load v at_path (without ["body"%string] members) in
        Fine (b, map exactly w)
  | _ => expected "an object {...}" at_path value
  end.

(** The work that loads do in a unit of each coordinate. Uncertain ones are on bodies that are no links, which a
    unit of one coordinate moves by a unit. *)
Definition work_of_loads (its : mechanism) (count : nat) (loads : list (nat * list interval)) : list interval :=
  let work (end_of : interval -> Q) :=
    let ws := fold_left (fun ws '(b, w) => add_on b 1 (map end_of w) ws) loads (map (fun _ => []) (Question.bodies its)) in
    pull_back (numbers_of its) (rev_append (Question.bodies its) []) ws (repeat 0%Q count) in
  map (fun '(a, b) => Interval a b) (combine (work low) (work high)).

Definition no_load (count : nat) : list interval := repeat (exactly 0) count.

Definition read_state_wrench (v : version) (count : nat) (at_path : path) (value : json) : result (list interval) :=
  read_sized (Z.of_nat count) "an array of a number for each coordinate" (read_interval v) at_path value.

Definition read_loads_on_bodies (its : mechanism) (count : nat) (read_one : path -> json -> result (nat * list interval))
  (at_path : path) (value : json) : result (list interval) :=
  let* loads := read_array "an array of loads" read_one at_path value in
  Fine (work_of_loads its count loads).

Definition read_case_of_bodies (read_w read_l : path -> json -> result (list interval)) (at_path : path) (value : json)
  : result (string * list interval) :=
  let* members := members_of ["name"; "wrench"; "loads"] at_path value in
  let* name := member "name" read_name at_path members in
  let* own := optional_member "wrench" read_w at_path members in
  let* loads := optional_member "loads" read_l at_path members in
  match own, loads with
  | Some w, None | None, Some w => Fine (name, w)
  | _, _ => refuse at_path "expected one of the members ""wrench"" and ""loads"""
  end.

(** Contacts: those of one body, and between which bodies they are. *)
Definition read_torsion (v : version) (at_path : path) (value : json) : result Q :=
  let* _ := check_that (is_in_space v) at_path "expected none, as the grasp is in the plane" in
  let* e := read_decimal at_path value in
  let* _ := check_that (Qle_bool 0 e) at_path "expected a number of 0 or more" in
  Fine e.

Definition read_contact_of_bodies (v : version) (bodies : list named_body) (defaults : properties) (soft : Q)
  (at_path : path) (value : json) : result contact :=
  let* members := members_of ["of"; "by"; "torsion"; "position"; "normal"; "friction"; "stiffness"; "preload"] at_path value in
  let known at_path value :=
    match value with
    | Text name => match number_of name bodies with Some number => Fine (Some number)
                   | None => expected "the name of one of ""bodies""" at_path value end
    | _ => expected "the name of one of ""bodies""" at_path value
    end in
  let other at_path value :=
    match value with
    | Text name => if (name =? ground)%string then Fine None else known at_path value
    | _ => known at_path value
    end in
  let* of_ := member "of" known at_path members in
  let* by_ := optional_member "by" other at_path members in
  let by_ := match by_ with Some it => it | None => None end in
  let* _ := check_that (match of_, by_ with Some a, Some b => negb (Nat.eqb a b) | _, _ => true end)
              (Member "by" :: at_path) "expected another body than ""of""" in
  let* e := optional_member "torsion" (read_torsion v) at_path members in
  let* it := read_contact v [] defaults at_path (without ["of"; "by"; "torsion"]%string members) in
  Fine {| position := position it; normal := normal it; slope := slope it; friction := friction it;
          stiffness := stiffness it; preload := preload it; preload_growth := preload_growth it;
          of_body := of_; by_body := by_; torsion := match e with Some e => e | None => soft end |}.

Definition read_defaults_of_bodies (v : version) (at_path : path) (value : json) : result (properties * Q) :=
  let* members := members_of ["friction"; "stiffness"; "preload"; "torsion"] at_path value in
  let* e := optional_member "torsion" (read_torsion v) at_path members in
  let* them := read_properties v at_path members in
  Fine (them, match e with Some e => e | None => 0%Q end).

(** The number of the first coordinate of each free body; coordinates of joints are last. *)
Fixpoint number_bodies (size next : nat) (bodies : list named_body) (turned : string -> list Q) : list rigid_body :=
  match bodies with
  | [] => []
  | b :: rest =>
      match link b with
      | None => Free next :: number_bodies size (next + size) rest turned
      | Some (on, eta) => Link on eta (turned (name_of b)) :: number_bodies size next rest turned
      end
  end.

Definition names_of_body (v : version) (b : named_body) : list string :=
  match link b with
  | Some _ => []
  | None => map (fun way => name_of b ++ way)%string
              (if is_in_space v then [" x"; " y"; " z"; " turn x"; " turn y"; " turn z"] else [" x"; " y"; " turn"])%string
  end.

(** With more than 30 only statics can be asked about (Pose.v). *)
Definition most_coordinates : Z := 65536.

(** An array, or none. *)
Definition listed_member {A : Type} (name : string) (read : path -> json -> result A) (members : list (string * json))
  : result (list A) :=
  let* them := optional_member name (read_array "an array" read) [] members in
  Fine match them with Some it => it | None => [] end.

Fixpoint read_springs (levers : list (list Q)) (joints : list (option (list Q -> result element))) : result (list element) :=
  match levers, joints with
  | row :: levers, Some read :: joints =>
      let* it := read row in
      let* others := read_springs levers joints in
      Fine (it :: others)
  | _ :: levers, None :: joints => read_springs levers joints
  | _, _ => Fine []
  end.

Definition read_grasp_of_bodies (value : json) : result grasp :=
  let* members :=
    members_of ["format"; "bodies"; "contacts"; "name"; "units"; "defaults"; "joints"; "tendons"; "ratchets"; "wrench";
                "loads"; "cases"; "max_motion"] [] value in
  let v := {| is_second := true;
              is_in_space := match find_member "contacts" members with
                             | Some (Array (Object first :: _)) => is_array 3 (find_member "position" first)
                             | _ => false
                             end |} in
  let size := if is_in_space v then 6%nat else 3%nat in
  let* _ := optional_member "name" read_any_text [] members in
  let* _ := optional_member "units" read_units [] members in
  let* bodies := member "bodies" (read_bodies v) [] members in
  let* joints := listed_member "joints" (read_joint v bodies) members in
  let* _ := check_that (forallb (fun b => match link b with
                          | None => true
                          | Some _ => existsb (fun '(turns, _, _) => existsb (fun '(name, _) => (name =? name_of b)%string) turns)
                                        joints
                          end) bodies) [Member "bodies"%string]
              "a link that no joint turns; expected its name in ""turns"" of one of ""joints""" in
  let own := (size * List.length (filter (fun b => match link b with None => true | Some _ => false end) bodies))%nat in
  let count := (own + List.length joints)%nat in
  let* _ := check_that (Z.of_nat count <=? most_coordinates) [Member "bodies"%string] "more than 65536 coordinates" in
  let turned name := (repeat 0%Q own ++ map (fun '(turns, _, _) => find_turn name turns) joints)%list in
  let levers := map (fun q => repeat 0%Q (own + q) ++ 1%Q :: repeat 0%Q (count - own - q - 1))%list
                  (seq 0 (List.length joints)) in
  let* ratchets := listed_member "ratchets" (read_over v bodies turned count false "preload") members in
  let* springs := read_springs levers (map (fun '(_, _, spring) => spring) joints) in
  let* tendons := listed_member "tendons" (read_over v bodies turned count true "tension") members in
  let its := {| bodies_in_space := is_in_space v; Question.bodies := number_bodies size 0 bodies turned;
                elements := (ratchets ++ springs ++ tendons)%list |} in
  let* defaults := optional_member "defaults" (read_defaults_of_bodies v) [] members in
  let '(defaults, soft) :=
    match defaults with
    | Some it => it
    | None => ({| own_friction := None; own_stiffness := None; own_preload := None |}, 0%Q)
    end in
  let read_contacts at_path value :=
    match value with
    | Array items =>
        let* _ := check_that (negb (is_longer_than most_contacts items)) at_path "too many contacts" in
        each (read_contact_of_bodies v bodies defaults soft) at_path items
    | _ => expected "an array of contacts" at_path value
    end in
  let* them := member "contacts" read_contacts [] members in
  let read_w := read_state_wrench v count in
  let read_l := read_loads_on_bodies its count (read_load_on_body v bodies) in
  let* own_wrench := optional_member "wrench" read_w [] members in
  let* loads := optional_member "loads" read_l [] members in
  let* _ := check_that (negb (has_member "wrench" members && has_member "loads" members)) []
              "both ""wrench"" and ""loads""; give one of them" in
  let common := match own_wrench, loads with Some w, _ | None, Some w => w | None, None => no_load count end in
  let* named := optional_member "cases" (read_list_of_cases (read_case_of_bodies read_w read_l)) [] members in
  let named := match named with Some it => it | None => [] end in
  let* bound := optional_member "max_motion"
                  (read_bound (is_in_space v) (match joints with [] => false | _ => true end) count) [] members in
  Fine {| in_space := is_in_space v;
          coordinates_read := count;
          bodies_read := Some its;
          body_names := map name_of bodies;
          names_of_bodies := List.concat (map (names_of_body v) bodies);
          names_of_joints := map (fun '(_, name, _) => name) joints;
          all_contacts := them;
          common_wrench := common;
          has_loads := has_member "wrench" members || has_member "loads" members;
          bound_read := bound;
          cases := map (fun '(name, w) => (name, add_wrench w common)) named |}.

(** The grasp file of any version. *)
Definition read_file (value : json) : result grasp :=
  match value with
  | Object members =>
      match find_member "format" members with
      | Some format => if is_text "stickslip-grasp/3" format then read_grasp_of_bodies value else read_grasp value
      | None => read_grasp value
      end
  | _ => read_grasp value
  end.
