(* SPDX-License-Identifier: MIT *)
(* stickslip-proved: the command line. See [help]. *)

module Integer = Z  (* Zarith's; Checker has one of its own *)

open Checker

let help =
  {|stickslip-proved GRASP CERTIFICATE [options]

Checks a proof that a frictional grasp is stable, or unstable, under a wrench; or, with a
direction, a proof of which multiples of the direction it resists, or with a plane, of which
wrenches of the plane. It does what
stickslip-check does, and that its answers are true is a theorem, check_correct of
certificate/proved/Correct.v, proved in Coq. What it relies on: certificate/FORMAT.md, section 9.
GRASP is the grasp file, CERTIFICATE the proof; one of them may be - for standard input.

The question is that of the grasp file unless replaced here. Give the same options as to
the program that produced the certificate:
  --wrench WX,WY,T         wrench applied to the object: force x, force y, torque
  --torque T               short for --wrench 0,0,T
  --case NAME              the wrench of this case of the grasp file
  --preload P              one preload for all contacts
  --normal-law LAW         unilateral (contacts may open; the default) or bilateral
  --direction WX,WY,T      ask for the margin: all factors f >= 0 for which the grasp is
                           stable under wrench + f direction, where the wrench is 0 unless
                           given by --wrench or --case
  --preload-direction D    ask for the margin along preloads: D is P0,P1,..., one number for
                           each contact, which f times is added to its preload; or the word
                           scale: f times the preloads, that is, which multiples of them hold
  --max-motion LENGTH,ANGLE
                           ask for equilibria with motions up to this: no translation beyond LENGTH,
                           no rotation beyond ANGLE; or one number for each coordinate; or the word
                           none, which takes away that of the grasp file
  --plane UX,UY,UT,VX,VY,VT
                           ask for the region: which wrenches wrench + s U + t V of this
                           plane it resists; wrench is 0 unless given by --wrench or --case
  --inertia X,Y,G2         ask for the class of rigid contacts: must move, must hold or open; the
                           centre of mass and the squared radius of gyration, in space
                           X,Y,Z,XX,YY,ZZ[,XY,XZ,YZ], the centre and the tensor of inertia about it
  --statics FACTOR         ask whether bodies may stand or must move, with any stiffness and preloads, and
                           all friction multiplied by FACTOR; with --direction which multiples
                           may, with --plane (of as many numbers as two wrenches) which loads
  --uncertain LIST         ask about every grasp in a box: how far numbers of each kind may be
                           off, such as friction=10%,stiffness=10%,preload=5%,
                           position=0.001,normal=0.0175,wrench=2%;
                           wrench=ball:R[:length=L][:about=X:Y[:Z]][:body=NAME] is every load that
                           differs from the wrench by a force f and a torque t at that point with
                           |f|^2 + |t|^2/L^2 <= R^2, of several bodies on the one named

  --json                   answer as one JSON object
  --batch                  answer many: each line of standard input is a JSON object
                           {"grasp": TEXT, "certificate": TEXT, "options": [WORD, ...]}, whose
                           TEXTs have a character for each byte of a file; one line each
  -h, --help               this text, if it comes before GRASP
  --                       no options follow

Numbers are exact: 1, -0.25, 1e-3, 3/5.

Answers and exit codes:
  accepted    0   the certificate proves the verdict about the question that is printed; of a
                  margin in the plane, that exactly the factors printed as "resisted" are, in
                  space, that those are, those printed as "refuted" are not, and nothing of
                  others; of a plane, that exactly the wrenches of the pieces are resisted;
                  of statics with a direction or a plane, that those printed as "may stand"
                  may, that those printed as "must move" must, and nothing of others
  rejected    1   it does not; the rule (named as in certificate/FORMAT.md) and the place
  (error)     2   a file or the command line cannot be understood, on standard error
  not judged  3   it takes more work than the files' length allows

Example:
  stickslip decide grasp.json --certificate proof.json
  stickslip-proved grasp.json proof.json
|}

exception Unreadable of { file : string; problem : string }

let shown name = if name = "-" then "<stdin>" else name

(* All of a file, or so much of it that it is too long. *)
let content name limit =
  let file = shown name in
  try
    if name <> "-" && Sys.is_directory name then
      raise (Unreadable { file; problem = "it is a directory; name a file, or - for standard input" });
    let channel = if name = "-" then stdin else open_in_bin name in
    set_binary_mode_in channel true;
    let text = Buffer.create 65536 in
    (try
       while Buffer.length text <= limit do
         Buffer.add_channel text channel (min 65536 (limit + 1 - Buffer.length text))
       done
     with End_of_file -> ());
    if name <> "-" then close_in channel;
    Buffer.contents text
  with Sys_error problem ->
    (* "NAME: No such file or directory" *)
    let named = String.length name + 2 in
    let reason =
      if Arguments.starts_with (name ^ ": ") problem then
        String.sub problem named (String.length problem - named)
      else problem in
    raise (Unreadable { file; problem = reason ^ "; name a file, or - for standard input" })

(* From the outside in: contacts[3].friction *)
let text_of_path path =
  let add text = function
    | Member name -> (if text = "" then "" else text ^ ".") ^ name
    | Element index -> text ^ "[" ^ Integer.to_string index ^ "]" in
  List.fold_left add "" path

let describe = function
  | Null -> "null"
  | Boolean value -> string_of_bool value
  | Number characters -> "the number " ^ Print.quote characters
  | Text content -> "the string " ^ Print.quote content
  | Array items -> "an array of " ^ string_of_int (List.length items)
  | Object _ -> "an object"

exception Illegible of { file : string; place : string; problem : string }

(* Masses, gravity, angles and frictions by name are not read here. *)
let remedy_for path found problem =
  let is_of_notation = match path, found with
    | Member ("mass" | "gravity" | "angle" | "friction") :: _, None ->
      Arguments.starts_with "unknown member" problem
    | Member "friction" :: _, Some (Text _) -> true
    | _ -> false in
  if is_of_notation then
    "; stickslip snap GRASP -o FILE writes a file without masses, gravity, angles and frictions by name"
  else ""

(* What a reader of Gallina gave, about this file; or about the question: Pose.v. *)
let or_illegible file = function
  | Fine value -> value
  | Malformed (path, found, problem) ->
    let remedy = remedy_for path found problem in
    let file, path = match List.rev path with
      | Member "the question" :: inside -> ("the question", inside)
      | from_outside -> (file, from_outside) in
    let problem = match found with
      | Some value -> "found " ^ describe value ^ ", expected " ^ problem
      | None -> problem in
    raise (Illegible { file; problem = problem ^ remedy;
                       place = if path = [] then "top level" else text_of_path path })

let tokens file limits text =
  try Tokenise.read limits text
  with Tokenise.Not_json { line; column; problem } ->
    raise (Illegible { file; place = Printf.sprintf "line %d, column %d" line column; problem })

let answer_to (arguments : Arguments.arguments) (grasp_name, grasp) (certificate_name, certificate) =
  let options = arguments.options in
  Work.begin_question ();
  let read name limits text =
    Work.bytes := !Work.bytes + String.length text;
    tokens name limits text in
  try
    let file = read grasp_name Tokenise.of_grasp (grasp ()) in
    let asked = or_illegible grasp_name (ask options file) in
    let answer, certificate =
      or_illegible certificate_name
        (judge Oracle.oracle asked (read certificate_name Tokenise.of_certificate (certificate ()))) in
    Print.Judged { asked; answer; certificate }
  with
  | Illegible { file; place; problem } -> Print.Illegible { file; place; problem }
  | Unreadable { file; problem } -> Print.Illegible { file; place = "opening"; problem }
  | Work.Too_much why -> Print.Not_judged why

(* The bytes that characters below 256 stand for, in UTF-8. *)
let bytes_of text =
  let result = Buffer.create (String.length text) in
  let rec go at =
    if at < String.length text then begin
      let code = Char.code text.[at] in
      if code < 0x80 then begin
        Buffer.add_char result text.[at];
        go (at + 1)
      end else begin
        Buffer.add_char result (Char.chr (((code land 3) lsl 6) lor (Char.code text.[at + 1] land 63)));
        go (at + 2)
      end
    end in
  go 0;
  Buffer.contents result

let no_limits =
  { Tokenise.of_certificate with bytes = max_int; string = max_int; values = max_int; lists = [] }

let batch_line line =
  match Tokenise.read no_limits line with
  | Object members ->
    let text name = match List.assoc name members with
      | Text content -> bytes_of content
      | _ -> raise Not_found in
    let words = match List.assoc "options" members with
      | Array items -> List.map (function Text word -> bytes_of word | _ -> raise Not_found) items
      | _ -> raise Not_found in
    answer_to
      (Arguments.parse ("grasp" :: "certificate" :: words))
      ("grasp", fun () -> text "grasp") ("certificate", fun () -> text "certificate")
  | _ -> raise Not_found

let rec batch () =
  match input_line stdin with
  | exception End_of_file -> ()
  | line ->
    (* Whoever asks may wait for each answer. *)
    print_string (Print.as_json (batch_line line));
    flush stdout;
    batch ()

(* What cannot be written, with standard output or standard error, is dropped: OCaml tries again at the end, and would die
   of a second exception. *)
let drop channel descriptor =
  (try Unix.dup2 (Unix.openfile "/dev/null" [Unix.O_WRONLY] 0) descriptor with Unix.Unix_error _ -> ());
  try flush channel with Sys_error _ -> ()

let complain text =
  try prerr_string ("stickslip-proved: " ^ text); flush stderr
  with Sys_error _ -> drop stderr Unix.stderr

let run (arguments : Arguments.arguments) =
  if arguments.help then (print_string help; 0)
  else if arguments.batch then (batch (); 0)
  else begin
    let file k (limits : Tokenise.limits) =
      let name = List.nth arguments.files k in
      (shown name, fun () -> content name limits.bytes) in
    let report =
      answer_to arguments (file 0 Tokenise.of_grasp) (file 1 Tokenise.of_certificate) in
    let code = Print.exit_code report in
    if code = 2 then complain (Print.as_text report);
    if arguments.json then print_string (Print.as_json report)
    else if code <> 2 then print_string (Print.as_text report);
    code
  end

let () =
  (* Most of what is made is dropped at once; a small heap for it would be searched again and again. *)
  Gc.set { (Gc.get ()) with minor_heap_size = 1 lsl 20; space_overhead = 200 };
  Work.watch ();
  let code =
    try
      let code = run (Arguments.parse (List.tl (Array.to_list Sys.argv))) in
      flush stdout;
      code
    with
    | Arguments.Usage problem -> complain (problem ^ "; try stickslip-proved --help\n"); 2
    | Sys_error problem ->
      drop stdout Unix.stdout;
      complain ("standard output cannot be written: " ^ problem ^ "\n");
      2
    | Stack_overflow | Out_of_memory -> complain "not enough memory\n"; 2
    | Not_found | Failure _ | Invalid_argument _ -> complain "a line of the batch is not a question\n"; 2 in
  exit code
