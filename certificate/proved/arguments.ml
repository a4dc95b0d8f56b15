(* SPDX-License-Identifier: MIT *)
(* The words of the command line, as stickslip-check takes them. What numbers mean is read by
   Numeral.v. *)

open Checker

exception Usage of string

type arguments = {
  files : string list;  (* GRASP and CERTIFICATE, unless there is help or a batch *)
  options : options;
  json : bool;
  help : bool;
  batch : bool;
}

let nothing_asked =
  { asked_wrench = None; asked_case = None; asked_preload = None; asked_bilateral = false;
    asked_direction = None; asked_growth = None; asked_plane = None; asked_inertia = None;
    asked_statics = None; asked_uncertain = []; asked_ball = None;
    asked_bound = None }

let starts_with prefix word =
  String.length word >= String.length prefix
  && String.sub word 0 (String.length prefix) = prefix

let usage option text problem = raise (Usage (option ^ ": " ^ Print.quote text ^ problem))

let number option text =
  match parse_decimal text with
  | Some x -> x
  | None -> usage option text " is not a number such as 2, -0.25, 1e-3 or 3/5"

let list option text = List.map (number option) (String.split_on_char ',' text)

(* How many numbers it has to have is known with the grasp; with statics it may have many coordinates. *)
let wrench most option text =
  let numbers = list option text in
  if List.length numbers <= most then numbers
  else usage option text (" has more than " ^ string_of_int most ^ " numbers")

let most_of_statics = 65536

(* Two wrenches. *)
let plane option text =
  let numbers = list option text in
  let count = List.length numbers in
  if count < 2 || count mod 2 <> 0 || count > 2 * most_of_statics then
    usage option text " is not UX,UY,UT,VX,VY,VT, two wrenches, such as 1,0,0,0,1,0";
  List.filteri (fun k _ -> k < count / 2) numbers, List.filteri (fun k _ -> k >= count / 2) numbers

(* What stands behind "ball:". *)
let ball option text =
  let wrong () =
    usage option ("ball:" ^ text)
      " is not ball:R[:length=L][:about=X:Y[:Z]][:body=NAME], such as ball:1/10:length=2" in
  let named part =
    match String.index_opt part '=' with
    | Some at -> Some (String.sub part 0 at), String.sub part (at + 1) (String.length part - at - 1)
    | None -> None, part in
  let rec go length point goes_on = function
    | [] -> length, List.rev point, None
    | part :: rest as all ->
      match named part with
      | Some "body", _ ->
        let all = String.concat ":" all in
        length, List.rev point, Some (String.sub all 5 (String.length all - 5))
      | Some "length", value when length = None -> go (Some (number option value)) point false rest
      | Some "about", value when point = [] -> go length [ number option value ] true rest
      | None, value when goes_on -> go length (number option value :: point) true rest
      | _ -> wrong () in
  match String.split_on_char ':' text with
  | [] -> wrong ()
  | first :: rest ->
    let stated_radius = number option first in
    let length, stated_point, stated_body = go None [] false rest in
    { stated_radius; stated_length = Option.value length ~default:(number option "1"); stated_point; stated_body }

(* Tolerances by their kinds, and a ball in place of that of the wrench. *)
let tolerances option text =
  let add (found, given_ball) part =
    let wrong () =
      usage option part
        (" is not KIND=TOLERANCE, such as friction=10%, where KIND is friction, stiffness, "
         ^ "preload, position, normal or wrench, each at most once") in
    match String.index_opt part '=' with
    | None -> wrong ()
    | Some equals ->
      let kind = String.sub part 0 equals in
      let spelled = String.sub part (equals + 1) (String.length part - equals - 1) in
      if not (List.mem kind uncertain_kinds) || List.mem_assoc kind found
         || (kind = "wrench" && given_ball <> None) then wrong ();
      if starts_with "ball:" spelled then begin
        if kind <> "wrench" then usage option part ": only the wrench may have a ball";
        found, Some (ball option (String.sub spelled 5 (String.length spelled - 5)))
      end else
      let last = String.length spelled - 1 in
      let percent = last >= 0 && spelled.[last] = '%' in
      let digits = if percent then String.sub spelled 0 last else spelled in
      (kind, { amount = number option digits; percent }) :: found, given_ball in
  let found, given_ball = List.fold_left add ([], None) (String.split_on_char ',' text) in
  List.rev found, given_ball

(* --help is a question only before the first file, and after -- nothing is an option, so that no
   file's name makes the program end with success. *)
let parse words =
  let most = if List.exists (starts_with "--statics") words then most_of_statics else 30 in
  let rec go a ended = function
    | [] -> a
    | word :: rest ->
      let asks_help = word = "--help" || word = "-h" in
      let help = asks_help && a.files = [] in
      if ended || String.length word < 2 || word.[0] <> '-' || (asks_help && not help) then
        go { a with files = a.files @ [ word ] } ended rest
      else
        let name, attached =
          match String.index_opt word '=' with
          | Some at when starts_with "--" word ->
            (String.sub word 0 at, Some (String.sub word (at + 1) (String.length word - at - 1)))
          | _ -> (word, None) in
        let valued set =
          let use value = { a with options = set value } in
          match attached, rest with
          | Some value, _ -> go (use value) ended rest
          | None, value :: others -> go (use value) ended others
          | None, [] -> raise (Usage (name ^ " needs a value")) in
        let o = a.options in
        match name, attached with
        | "--wrench", _ -> valued (fun v -> { o with asked_wrench = Some (wrench most name v) })
        | "--torque", _ ->
          valued (fun v -> { o with asked_wrench = Some (List.map (number name) [ "0"; "0"; v ]) })
        | "--plane", _ -> valued (fun v -> { o with asked_plane = Some (plane name v) })
        | "--statics", _ -> valued (fun v -> { o with asked_statics = Some (number name v) })
        | "--inertia", _ ->
          valued (fun v ->
              let numbers = list name v in
              if not (List.mem (List.length numbers) [ 3; 6; 9 ]) then
                usage name v " is not X,Y,G2, such as 0,0,1";
              { o with asked_inertia = Some (in_full numbers) })
        | "--case", _ -> valued (fun v -> { o with asked_case = Some v })
        | "--preload", _ -> valued (fun v -> { o with asked_preload = Some (number name v) })
        | "--normal-law", _ ->
          valued (fun v ->
              if v <> "unilateral" && v <> "bilateral" then
                usage name v " is not unilateral or bilateral";
              { o with asked_bilateral = v = "bilateral" })
        | "--max-motion", _ ->
          valued (fun v ->
              { o with asked_bound = Some (if v = "none" then Unbounded else Bounded (list name v)) })
        | "--direction", _ -> valued (fun v -> { o with asked_direction = Some (wrench most name v) })
        | "--preload-direction", _ ->
          valued (fun v ->
              { o with asked_growth = Some (if v = "scale" then Scale else By (list name v)) })
        | "--uncertain", _ ->
          valued (fun v ->
              let asked_uncertain, asked_ball = tolerances name v in
              { o with asked_uncertain; asked_ball })
        | "--json", None -> go { a with json = true } ended rest
        | "--batch", None -> go { a with batch = true } ended rest
        | "--", None -> go a true rest
        | _ when help && attached = None -> { a with help = true }
        | _ -> raise (Usage ("unknown option " ^ Print.quote word)) in
  let a =
    go { files = []; options = nothing_asked; json = false; help = false; batch = false } false words
  in
  let count = List.length a.files in
  if (not a.help) && (not a.batch) && count <> 2 then
    raise (Usage ("expected two files, GRASP and CERTIFICATE, found " ^ string_of_int count));
  if a.files = [ "-"; "-" ] then
    raise (Usage "only one of GRASP and CERTIFICATE can be standard input");
  a
