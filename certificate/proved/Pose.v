(* SPDX-License-Identifier: MIT *)
(** The question that is asked of a grasp file with the options of the command line: FORMAT.md
    section 1, the table and what follows it, and section 6. The certificate plays no part here. *)
From Coq Require Import Bool List QArith Qabs String ZArith.
From Proved Require Import Json Question ReadBodies ReadGrasp RigidClass Root.
Import ListNotations.
Local Open Scope string_scope.

(** A tolerance t, or t%. *)
Record tolerance : Set := { amount : Q; percent : bool }.

(** How preloads grow: in proportion to themselves, or by these numbers, one for each contact. *)
Inductive growth : Set := Scale | By (numbers : list Q).

(** A ball of loads, in place of the tolerance of the wrench; no point stands for 0. *)
Record stated_ball : Set := {
  stated_radius : Q;
  stated_length : Q;
  stated_point : list Q;
  stated_body : option string }.

(** The bound of motions: none, or D numbers, or a length and an angle. *)
Inductive bound_option : Set := Unbounded | Bounded (numbers : list Q).

(** What is not given is that of the grasp file, or none. *)
Record options : Set := {
  asked_wrench : option (list Q);
  asked_case : option string;
  asked_preload : option Q;
  asked_bilateral : bool;
  asked_direction : option (list Q);
  asked_growth : option growth;
  asked_plane : option (list Q * list Q);
  asked_inertia : option (list Q);  (** in full *)
  asked_statics : option Q;
  asked_uncertain : list (string * tolerance);  (** by kind *)
  asked_ball : option stated_ball;
  asked_bound : option bound_option }.

Definition uncertain_kinds : list string :=
  ["friction"; "stiffness"; "preload"; "position"; "normal"; "wrench"].

Definition asks_margin (asked : options) : bool :=
  match asked_direction asked, asked_growth asked with None, None => false | _, _ => true end.

Definition asks_plane (asked : options) : bool :=
  match asked_plane asked with Some _ => true | None => false end.

Definition asks_class (asked : options) : bool :=
  match asked_inertia asked with Some _ => true | None => false end.

Definition asks_statics (asked : options) : bool :=
  match asked_statics asked with Some _ => true | None => false end.

(** Whatever is about one grasp. *)
Definition asks_one (asked : options) : bool :=
  asks_margin asked || asks_class asked || asks_plane asked || asks_statics asked.

(** With xy, xz and yz, which may be left out. *)
Definition in_full (numbers : list Q) : list Q :=
  match numbers with [_; _; _; _; _; _] => (numbers ++ [0; 0; 0])%list%Q | _ => numbers end.

(** The question as it is judged, and as it is printed. *)
Record posed : Set := {
  the_question : question;
  free_coordinates : list string;  (** of several bodies, to be printed *)
  joint_coordinates : list (option string);
  stated_wrench : list interval;  (** before it was widened *)
  the_options : options;  (** a ball with its point, and the bound in full, also that of the file *)
  is_box : bool }.

(** Places that are about the question and not about the file begin so. *)
Definition of_question (part : string) : path := [Member part; Member "the question"].

Definition find_tolerance (kind : string) (asked : options) : option tolerance :=
  match find (fun '(name, _) => String.eqb name kind) (asked_uncertain asked) with
  | Some (_, it) => Some it
  | None => None
  end.

Definition check_dimension (file : grasp) (part : string) (numbers : option (list Q)) : result unit :=
  match numbers with
  | None => Fine tt
  | Some v =>
      check_that (Nat.eqb (List.length v) (coordinates_read file)) (of_question part)
        (match bodies_read file with
         | Some _ => "expected a number for each coordinate of the bodies and joints"
         | None => if in_space file then "expected 6 numbers, as the grasp is in space"
                   else "expected 3 numbers, as the grasp is planar"
         end)
  end.

Definition wrench_asked (file : grasp) (asked : options) : result (list interval) :=
  let here := of_question "case" in
  match asked_wrench asked, asked_case asked with
  | Some _, Some _ => refuse here "a wrench is given as well; expected one of them"
  | Some w, None => Fine (map exactly w)
  | None, Some name =>
      match find (fun '(other, _) => String.eqb other name) (cases file) with
      | Some (_, w) => Fine w
      | None => refuse here ("the grasp has no case """ ++ name ++ """")
      end
  | None, None =>
      match asked_direction asked, asked_plane asked, has_loads file, cases file with
      | Some d, _, _, _ | None, Some (d, _), _, _ => Fine (map (fun _ => exactly 0) d)
      | None, None, true, _ | None, None, _, [] => Fine (common_wrench file)
      | None, None, false, (name, _) :: _ =>
          refuse here ("the grasp has cases, and none is chosen; expected the name of one, such as """
                       ++ name ++ """")
      end
  end.

Definition widen (by_ : option tolerance) (it : interval) : interval :=
  match by_ with
  | None => it
  | Some t =>
      let off x := if percent t then amount t * Qabs x / 100 else amount t in
      Interval (low it - off (low it)) (high it + off (high it))
  end.

(** The options applied to a contact, before its preload grows. *)
Definition asked_contact (asked : options) (it : contact) : contact :=
  let by_ kind := find_tolerance kind asked in
  let given := match asked_preload asked with Some p => exactly p | None => preload it end in
  {| position := map (widen (by_ "position")) (position it);
     normal := normal it;
     slope := match by_ "normal" with Some t => slope it + amount t | None => slope it end;
     friction := widen (by_ "friction") (friction it);
     stiffness := widen (by_ "stiffness") (stiffness it);
     preload := widen (by_ "preload") given;
     preload_growth := preload_growth it;
     of_body := of_body it; by_body := by_body it; torsion := torsion it |}.

Definition asked_element (asked : options) (it : element) : element :=
  {| lever := lever it; element_spring := element_spring it;
     element_stiffness := widen (find_tolerance "stiffness" asked) (element_stiffness it);
     element_preload := widen (find_tolerance "preload" asked) (element_preload it);
     element_growth := element_growth it |}.

(** The ball, with its point, and as it is judged. *)
Definition ball_asked (file : grasp) (asked : options) (stated : list interval) : result (option (stated_ball * ball)) :=
  match asked_ball asked with
  | None => Fine None
  | Some b =>
      let here := of_question "uncertain" in
      let point := match stated_point b with
                   | [] => repeat 0%Q (if in_space file then 3 else 2)
                   | p => p
                   end in
      let* _ := check_that (negb (asks_one asked)) here
                  "a margin, a region, a class or statics is about one grasp; expected no uncertainty" in
      let* _ := check_that (is_below 0 (stated_radius b)) here "expected a radius above 0" in
      let* _ := check_that (is_below 0 (stated_length b)) here "expected a length above 0" in
      let* _ := check_that (has_length (if in_space file then 3 else 2) point) here
                  (if in_space file then "expected a point of three coordinates, as the grasp is in space"
                   else "expected a point of two coordinates, as the grasp is planar") in
      let* _ := check_that (forallb (fun it => Qeq_bool (low it) (high it)) stated) here
                  "expected a load without intervals" in
      let* body :=
        match bodies_read file, stated_body b with
        | None, None => Fine None
        | None, Some _ => refuse here "expected no body, as the grasp has one only"
        | Some _, None => refuse here "expected the name of one of ""bodies"""
        | Some _, Some name =>
            match number_from name (body_names file) 0 with
            | Some number => Fine (Some number)
            | None => refuse here "expected the name of one of ""bodies"""
            end
        end in
      Fine (Some ({| stated_radius := stated_radius b; stated_length := stated_length b; stated_point := point;
                     stated_body := stated_body b |},
                  Ball (stated_radius b) (stated_length b) point body))
  end.

(** The bound of motions, which no question has about a plane of loads, rigid contacts or statics; that of the file plays
    no part in statics. *)
Definition bound_asked (file : grasp) (asked : options) : result (option (list Q)) :=
  let here := of_question "max motion" in
  let* bound :=
    match asked_bound asked with
    | None => Fine (if asks_statics asked then None else bound_read file)
    | Some Unbounded => Fine None
    | Some (Bounded numbers) =>
        let* _ := check_that (forallb (is_below 0) numbers) here "expected numbers above 0" in
        if Nat.eqb (List.length numbers) (coordinates_read file) then Fine (Some numbers)
        else
          match numbers, names_of_joints file with
          | [length; angle], [] => Fine (Some (bound_of (in_space file) (coordinates_read file) length angle))
          | _, [] => refuse here "expected a number for each coordinate of motions, or a length and an angle"
          | _, _ :: _ => refuse here "expected a number for each coordinate of the bodies and joints"
          end
    end in
  let* _ := check_that (match bound with Some _ => negb (asks_plane asked || asks_class asked || asks_statics asked)
                          | None => true end) here
              "motions are bounded, and a plane, an inertia or statics is given as well; expected one of them" in
  Fine bound.

Fixpoint check_tolerances (asked : options) (them : list (string * tolerance)) : result unit :=
  match them with
  | [] => Fine tt
  | (kind, t) :: rest =>
      let here := of_question "uncertain" in
      let* _ := check_that (negb (asks_one asked)) here
                  "a margin, a region, a class or statics is about one grasp; expected no uncertainty" in
      let* _ := check_that (Qle_bool 0 (amount t)) here "expected tolerances of 0 or more" in
      let* _ := check_that (negb (String.eqb kind "normal" && percent t)) here
                  "of normals a slope is expected, such as 0.01" in
      check_tolerances asked rest
  end.

Definition is_exact (it : interval) : bool := Qeq_bool (low it) (high it).
Definition is_one_point (it : contact) : bool :=
  forallb is_exact (position it) && is_0 (slope it) && is_exact (friction it)
  && is_exact (stiffness it) && is_exact (preload it).

(** Whether there is a preload along a normal of irrational length. *)
Definition has_irrational_preload (it : contact) : bool :=
  (negb (is_0 (high (preload it))) || negb (is_0 (preload_growth it)))
  && match exact_root (sum_of_squares (normal it)) with Some _ => false | None => true end.

(** What FORMAT.md section 6 does not allow, and whether the contact makes the question a box. [exact]: that does not
    allow lengths that are irrational. *)
Definition check_contact (margin exact statics : bool) (at_path : path) (it : contact)
  : result bool :=
  let here name := (Member name :: at_path)%list in
  let* _ := check_that (Qle_bool 0 (low (friction it))) (here "friction")
              "it may be below 0; expected 0 or more" in
  let* _ := check_that (Qle_bool 0 (low (preload it))) (here "preload")
              "it may be below 0; expected 0 or more" in
  let* _ := check_that (is_below 0 (low (stiffness it))) (here "stiffness")
              "it may be 0 or less; expected above 0" in
  let* _ := check_that (is_below (slope it) 1) (here "normal") "expected a slope below 1" in
  let* _ := check_that (is_0 (slope it) || is_0 (torsion it)) (here "normal")
              "expected no slope, as the contact has torsion" in
  let* _ := check_that (negb margin || is_one_point it) at_path
              "found an interval, but the question is about one grasp; expected numbers" in
  let irrational := negb statics && has_irrational_preload it in
  let* _ := check_that (negb (irrational && exact)) (here "normal")
              ("the contact has a preload and a normal of irrational length, so there is no exact "
               ++ "question; run stickslip snap GRASP -o FILE, and ask about FILE") in
  Fine (irrational || negb (is_one_point it)).

(** Whether it makes the question a box. *)
Definition check_element (margin : bool) (at_path : path) (it : element) : result bool :=
  let spring := element_spring it in
  let k := low (element_stiffness it) in
  let* _ := check_that (spring || Qle_bool 0 (low (element_preload it))) at_path
              "the preload may be below 0; expected 0 or more" in
  let* _ := check_that (if spring then Qle_bool 0 k else is_below 0 k) at_path
              "the stiffness may be too small; expected above 0, of a spring 0 or more" in
  let certain := is_exact (element_stiffness it) && is_exact (element_preload it) in
  let* _ := check_that (negb margin || certain) at_path
              "found an interval, but the question is about one grasp; expected numbers" in
  Fine (negb certain).

(** P^u, and under [Scale] none of the file's preloads. *)
Definition with_growth (p : interval) (u : Q) (it : contact) : contact :=
  {| position := position it; normal := normal it; slope := slope it; friction := friction it;
     stiffness := stiffness it; preload := p; preload_growth := u;
     of_body := of_body it; by_body := by_body it; torsion := torsion it |}.

Definition element_with_growth (p : interval) (u : Q) (it : element) : element :=
  {| lever := lever it; element_spring := element_spring it; element_stiffness := element_stiffness it;
     element_preload := p; element_growth := u |}.

(** By so many numbers; and those that are left. *)
Fixpoint with_growths {A : Type} (grown : A -> Q -> A) (items : list A) (numbers : list Q) (done : list A)
  : option (list A * list Q) :=
  match items, numbers with
  | [], _ => Some (rev_append done [], numbers)
  | it :: others, p :: rest => with_growths grown others rest (grown it p :: done)
  | _ :: _, [] => None
  end.

Definition are_multiples (u v : list Q) : bool :=
  match find (fun '(a, _) => negb (is_0 a)) (combine u v) with
  | Some (a, b) => forallb (fun '(x, y) => is_0 (a * y - x * b)) (combine u v)
  | None => true
  end.

(** The plane has two directions that differ, and nothing else grows. *)
Definition check_plane (file : grasp) (asked : options) : result unit :=
  let here := of_question "plane" in
  match asked_plane asked with
  | None => Fine tt
  | Some (u, v) =>
      let* _ := check_dimension file "plane" (Some u) in
      let* _ := check_dimension file "plane" (Some v) in
      let* _ := check_that (asks_statics asked || match bodies_read file with Some _ => false | None => true end) here
                  "the grasp is of several bodies; expected a question about a wrench or a direction" in
      let* _ := check_that (asks_statics asked || negb (in_space file)) here
                  "the grasp is in space; a region is about a planar grasp" in
      let* _ := check_that (negb (asks_margin asked)) here "a direction is given as well; expected one of them" in
      check_that (negb (are_multiples u v)) here "its directions are multiples of one another; expected a plane"
  end.

(** Statics have a factor of 0 or more, and neither growing preloads nor an inertia; all other questions have few
    coordinates. *)
Definition check_statics (file : grasp) (asked : options) : result unit :=
  let here := of_question "statics" in
  match asked_statics asked with
  | None => check_that (Z.of_nat (coordinates_read file) <=? 30)%Z (of_question "bodies")
              "more than 30 coordinates of bodies and joints; expected as many at most, but in a question of statics"
  | Some factor =>
      let* _ := check_that (Qle_bool 0 factor) here "expected a factor of 0 or more" in
      let* _ := check_that (negb (asks_class asked)) here "an inertia is given as well; expected one of them" in
      check_that (match asked_growth asked with None => true | Some _ => false end) here
        "a preload direction is given as well, but preloads play no part"
  end.

Definition pose (file : grasp) (asked : options) : result posed :=
  let* _ := check_dimension file "wrench" (asked_wrench asked) in
  let* _ := check_dimension file "direction" (asked_direction asked) in
  let* _ := check_that (match asked_preload asked with Some p => Qle_bool 0 p | None => true end)
              (of_question "preload") "expected 0 or more" in
  let* _ := check_plane file asked in
  let* _ := check_statics file asked in
  let* stated := wrench_asked file asked in
  let* _ := check_tolerances asked (asked_uncertain asked) in
  let* ball := ball_asked file asked stated in
  let* bound := bound_asked file asked in
  let them := map_all (asked_contact asked) (all_contacts file) in
  let others := match bodies_read file with Some its => map_all (asked_element asked) (elements its) | None => [] end in
  let* '(them, others) :=
    match asked_growth asked with
    | Some (By numbers) =>
        let problem := "expected numbers of 0 or more, one for each contact, then ratchet, then spring, of which any" in
        let wrong := refuse (of_question "preload direction") problem in
        match with_growths (fun it p => with_growth (preload it) p it) them numbers [] with
        | None => wrong
        | Some (them, rest) =>
            match with_growths (fun it p => element_with_growth (element_preload it) p it) others rest [] with
            | Some (others, []) =>
                let* _ := check_that (forallb (fun it => Qle_bool 0 (preload_growth it)) them
                                      && forallb (fun it => element_spring it || Qle_bool 0 (element_growth it)) others)
                            (of_question "preload direction") problem in
                Fine (them, others)
            | _ => wrong
            end
        end
    | _ => Fine (them, others)
    end in
  let* _ :=
    match asked_inertia asked with
    | None => Fine tt
    | Some numbers =>
        let here := of_question "inertia" in
        let* _ := check_that (match bodies_read file with Some _ => false | None => true end) here
                    "the grasp is of several bodies; expected a question about a wrench or a direction" in
        let* _ := check_that (negb (asks_margin asked || asks_plane asked)) here
                    "a direction or a plane is given as well; expected one of them" in
        let* _ := check_that (has_length (if in_space file then 9 else 3) numbers) here
                    (if in_space file then "expected 6 or 9 numbers" else "expected 3 numbers") in
        check_that (match masses numbers with Some _ => true | None => false end) here
          (if in_space file then "the tensor is not positive definite"
           else "the squared radius of gyration must be > 0")
    end in
  let margin := asks_one asked in
  let statics := asks_statics asked in
  let exact := negb (in_space file) && (asks_class asked || asks_plane asked) in
  let* boxes := each (check_contact margin exact statics) [Member "contacts"] them in
  let* other_boxes := each (check_element margin) [Member "ratchets and springs"] others in
  let widened := map (widen (find_tolerance "wrench" asked)) stated in
  let certain := forallb is_exact widened in
  let* _ := check_that (negb margin || certain) [Member "wrench"]
              "found an interval, but the question is about one grasp; expected numbers" in
  let scales := match asked_growth asked with Some Scale => true | _ => false end in
  let them := if scales then map_all (fun it => with_growth (exactly 0) (low (preload it)) it) them else them in
  let others := if scales then map_all (fun it => element_with_growth (exactly 0) (low (element_preload it)) it) others
                else others in
  let u := match asked_direction asked with Some u => u | None => map (fun _ => 0%Q) stated end in
  let* _ := check_that (negb (asks_margin asked) || negb (forallb is_0 u)
                        || existsb (fun it => negb (is_0 (preload_growth it))) them
                        || existsb (fun it => negb (is_0 (element_growth it))) others)
              (of_question "direction")
              ("neither the wrench nor a preload changes; expected a direction other than 0, or to "
               ++ "scale preloads some of which are not 0") in
  Fine {| the_question :=
            {| dimension := coordinates_read file;
               bilateral := asked_bilateral asked;
               is_margin := asks_margin asked;
               contacts := them;
               wrench := widened;
               load_ball := match ball with Some (_, b) => Some b | None => None end;
               direction := u;
               load_plane := asked_plane asked;
               inertia := match asked_inertia asked with Some numbers => numbers | None => [] end;
               statics := asked_statics asked;
               several := match bodies_read file with
                          | Some its => Some {| bodies_in_space := bodies_in_space its; bodies := bodies its;
                                                elements := others |}
                          | None => None
                          end;
               max_motion := bound |};
          free_coordinates := names_of_bodies file;
          joint_coordinates := names_of_joints file;
          stated_wrench := stated;
          the_options :=
            {| asked_wrench := asked_wrench asked; asked_case := asked_case asked;
               asked_preload := asked_preload asked; asked_bilateral := asked_bilateral asked;
               asked_direction := asked_direction asked; asked_growth := asked_growth asked;
               asked_plane := asked_plane asked; asked_inertia := asked_inertia asked; asked_statics := asked_statics asked;
               asked_uncertain := asked_uncertain asked;
               asked_ball := match ball with Some (b, _) => Some b | None => None end;
               asked_bound := match bound with Some numbers => Some (Bounded numbers) | None => None end |};
          is_box := negb certain || (match ball with Some _ => true | None => false end)
                    || existsb (fun box => box) (boxes ++ other_boxes)%list |}.
