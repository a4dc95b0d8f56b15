(* SPDX-License-Identifier: MIT *)
(* What is printed: the question as it was understood, and the answer, in the words of
   stickslip-check. *)

module Integer = Z  (* Zarith's; Checker has one of its own *)

open Checker

(* The text with every byte that is not printable ASCII as \xNN. *)
let printable text =
  let shown = Buffer.create (String.length text) in
  let add c =
    if c >= ' ' && c <= '~' then Buffer.add_char shown c
    else Buffer.add_string shown (Printf.sprintf "\\x%02x" (Char.code c)) in
  String.iter add text;
  Buffer.contents shown

let quote text =
  let most = 40 in
  if String.length text <= most then "\"" ^ printable text ^ "\""
  else "\"" ^ printable (String.sub text 0 most) ^ "...\""

let json_string text =
  let result = Buffer.create (String.length text + 2) in
  Buffer.add_char result '"';
  let add c =
    if c = '"' || c = '\\' then Buffer.add_char result '\\';
    Buffer.add_char result c in
  String.iter add (printable text);
  Buffer.add_char result '"';
  Buffer.contents result

let int_of_nat =
  let rec count so_far = function O -> so_far | S n -> count (so_far + 1) n in
  count 0

(* In lowest terms. *)
let number { qnum; qden } =
  let divisor = Integer.gcd qnum qden in
  let num = Integer.div qnum divisor and den = Integer.div qden divisor in
  if Integer.equal den Integer.one then Integer.to_string num else Integer.to_string num ^ "/" ^ Integer.to_string den

(* Lists of files are long, and List.map is not tail recursive. *)
let separated show items = String.concat ", " (List.rev (List.rev_map show items))
let vector items = "(" ^ separated number items ^ ")"
let json_number x = json_string (number x)
let json_vector items = "[" ^ separated json_number items ^ "]"

let interval between { low; high } =
  if qeq_bool low high then between low
  else "[" ^ between low ^ ", " ^ between high ^ "]"

let tolerance { amount; percent } = number amount ^ if percent then "%" else ""

let ball { stated_radius; stated_length; stated_point; stated_body } =
  "ball:" ^ number stated_radius ^ ", length " ^ number stated_length ^ ", about " ^ vector stated_point
  ^ match stated_body with Some name -> ", on the body \"" ^ printable name ^ "\"" | None -> ""

let json_ball { stated_radius; stated_length; stated_point; stated_body } =
  "{\"ball\": " ^ json_number stated_radius ^ ", \"length\": " ^ json_number stated_length
  ^ ", \"about\": " ^ json_vector stated_point
  ^ (match stated_body with Some name -> ", \"body\": " ^ json_string name | None -> "") ^ "}"

(* Those given, in the order of kinds, a ball last; as they are shown. *)
let tolerances show show_ball asked =
  List.filter_map
    (fun kind -> Option.map (fun t -> (kind, show t)) (find_tolerance kind asked))
    uncertain_kinds
  @ match asked.asked_ball with Some b -> [ ("wrench", show_ball b) ] | None -> []

let law asked = if asked.asked_bilateral then "bilateral" else "unilateral"

let resisted_in_words = function
  | [] -> "no multiple"
  | intervals ->
    separated
      (fun (low, high) ->
        "[" ^ number low ^ ", "
        ^ match high with Some x -> number x ^ "]" | None -> "oo)")
      intervals

let refuted_in_words =
  separated (fun ((low, high), with_low) ->
    (if with_low then "[" else "(") ^ number low ^ ", "
    ^ match high with Some x -> number x ^ ")" | None -> "oo)")

let json_refuted ranges =
  let one ((low, high), with_low) =
    "[" ^ json_number low ^ ", "
    ^ (match high with Some x -> json_number x | None -> "null")
    ^ ", " ^ string_of_bool with_low ^ "]" in
  "[" ^ separated one ranges ^ "]"

let json_resisted intervals =
  let one (low, high) =
    "[" ^ json_number low ^ ", "
    ^ (match high with Some x -> json_number x | None -> "null") ^ "]" in
  "[" ^ separated one intervals ^ "]"

let standing_in_words multiples ((below, above), all) =
  let moves = function
    | [] -> "none claimed"
    | ends -> String.concat ", " ends in
  let end_ word = function Some x -> [ word ^ number x ] | None -> [] in
  "may stand   "
  ^ (match multiples with
     | Some (low, high) ->
       (match low with Some a -> "[" ^ number a | None -> "(-oo") ^ ", "
       ^ (match high with Some b -> number b ^ "]" | None -> "oo)")
     | None -> "none claimed")
  ^ "\nmust move   "
  ^ if all then "all" else moves (end_ "below " below @ end_ "above " above)

let json_standing multiples ((below, above), all) =
  let ends (a, b) =
    let one = function Some x -> json_number x | None -> "null" in
    "[" ^ one a ^ ", " ^ one b ^ "]" in
  "{\"stand\": " ^ (match multiples with Some them -> ends them | None -> "null")
  ^ ", \"move\": " ^ (if all then "\"all\"" else ends (below, above)) ^ "}"

(* How long the proof is. *)
type size =
  { nodes : int; leaves : int; parts : int; rests : int; stickings : int; segments : int; trees : int; pieces : int;
    points : int; twists : int }

let size_of_tree size tree =
  let leaves = List.length (List.filter (function Leaf _ | Moving _ | Held _ -> true | _ -> false) tree) in
  { size with nodes = size.nodes + List.length tree; leaves = size.leaves + leaves }

(* The parts of [0, oo) that the intervals of a margin leave. *)
let gaps = function
  | [] -> 1
  | (low, _) :: _ as intervals ->
    let count = List.length intervals in
    let ends = match snd (List.nth intervals (count - 1)) with Some _ -> 0 | None -> 1 in
    count + 1 - ends - if Integer.sign low.qnum = 0 then 1 else 0

let size_of certificate =
  let none = { nodes = 0; leaves = 0; parts = 0; rests = 0; stickings = 0; segments = 0; trees = 0; pieces = 0;
    points = 0; twists = 0 } in
  let add_part size = function
    | PartProof (_, _, _, _, _, tree) -> size_of_tree { size with parts = size.parts + 1 } tree
    | PartAtRest _ -> { size with rests = size.rests + 1 }
    | PartSticking _ -> { size with stickings = size.stickings + 1 }
    | PartCut _ -> size in
  match certificate.body with
  | StableByWitness _ -> none
  | StableByParts parts -> List.fold_left add_part none parts
  | UnstableByTree tree -> size_of_tree none tree
  | MarginBy (resisted, segments, tree) ->
    let add size = function
      | Segment _ -> { size with segments = size.segments + 1 }
      | SegmentByDegree (_, _, _, _, _, tree) ->
        size_of_tree { size with segments = size.segments + 1; parts = size.parts + 1 } tree in
    size_of_tree (List.fold_left add { none with trees = gaps resisted } segments) tree
  | MarginInSpace claims ->
    let add size = function
      | ClaimStable (_, _, Inl part) -> add_part size part
      | ClaimStable (_, _, Inr _) -> size
      | ClaimUnstable (_, _, tree) -> size_of_tree { size with trees = size.trees + 1 } tree in
    List.fold_left add none claims
  | OfClass (ByTree (_, tree)) ->
    let leaves = List.length (List.filter (function RLeaf _ -> true | _ -> false) tree) in
    { none with nodes = List.length tree; leaves }
  | OfClass _ -> none
  | OfStatics (ByPoints (stand, move)) -> { none with points = List.length stand; twists = List.length move }
  | OfStatics _ -> none
  | RegionBy (pieces, tree) -> size_of_tree { none with pieces = List.length pieces } tree

let class_in_words = function MustMove -> "must move" | MustHold -> "must hold" | Open -> "open"

let in_words place =
  match place with
  | Nowhere -> None
  | AtNode _ -> None
  | AtContact i -> Some ("contact " ^ Integer.to_string i)
  | AtInterval n -> Some ("interval " ^ string_of_int (int_of_nat n))
  | AtSegment (n, _) -> Some ("segment " ^ string_of_int (int_of_nat n))
  | AtPoint (n, second) ->
    Some ("segment " ^ string_of_int (int_of_nat n)
          ^ if second then ", second point" else ", first point")
  | AtPart (n, _) -> Some ("part " ^ string_of_int (int_of_nat n))
  | AtPointOf (n, second) ->
    Some ("interval " ^ string_of_int (int_of_nat n)
          ^ if second then ", second point" else ", first point")
  | AtProofOf (n, _) -> Some ("interval " ^ string_of_int (int_of_nat n))
  | AtPiece (n, point) ->
    Some ("piece " ^ string_of_int (int_of_nat n)
          ^ match point with Some k -> ", point " ^ string_of_int (int_of_nat k) | None -> "")
  | AtMember name -> Some name
  | AtStand n -> Some ("stand " ^ string_of_int (int_of_nat n))
  | AtMove n -> Some ("move " ^ string_of_int (int_of_nat n))

let node_of = function
  | AtNode n | AtPart (_, Some n) | AtSegment (_, Some n) | AtProofOf (_, Some n) -> Some (int_of_nat n)
  | _ -> None

(* How many there are; of several bodies, which elements, and the coordinates of their motion. *)
let contacts_of asked =
  let count items = string_of_int (List.length items) in
  let contacts = count asked.the_question.contacts in
  match asked.the_question.several with
  | None -> contacts
  | Some its ->
    let springs, ratchets = List.partition (fun it -> it.element_spring) its.elements in
    contacts ^ "; ratchets: " ^ count ratchets ^ "; springs: " ^ count springs
    ^ "\ncoordinates "
    ^ separated printable
        (asked.free_coordinates
         @ List.mapi
             (fun q name -> match name with Some it -> it | None -> "joint " ^ string_of_int q)
             asked.joint_coordinates)

let question asked =
  let o = asked.the_options in
  let given name show = function Some it -> "\n" ^ name ^ show it | None -> "" in
  let numbers = function Some (By numbers) -> " + f " ^ vector numbers | _ -> "" in
  "\ncontacts    " ^ contacts_of asked
  ^ "\nwrench      (" ^ separated (interval number) asked.stated_wrench ^ ")"
  ^ given "direction   " vector o.asked_direction
  ^ given "plane       wrench + s " (fun (u, v) -> vector u ^ " + t " ^ vector v) o.asked_plane
  ^ given "inertia     " vector o.asked_inertia
  ^ given "statics     friction times " number o.asked_statics
  ^ "\npreload     "
  ^ (match o.asked_growth with Some Scale -> "f times " | _ -> "")
  ^ (match o.asked_preload with
     | Some p -> number p ^ " at all contacts"
     | None -> "as in the grasp file")
  ^ numbers o.asked_growth
  ^ "\nnormal law  " ^ law o
  ^ (match tolerances tolerance ball o with
     | [] -> ""
     | them -> "\nuncertain   " ^ separated (fun (kind, t) -> kind ^ " " ^ t) them)
  ^ match o.asked_bound with Some (Bounded it) -> "\nmax motion  " ^ vector it | _ -> ""

let json_question asked =
  let o = asked.the_options in
  let or_null show = function Some it -> show it | None -> "null" in
  let uncertain = match tolerances (fun t -> json_string (tolerance t)) json_ball o with
    | [] -> "null"
    | them ->
      let one (kind, t) = json_string kind ^ ": " ^ t in
      "{" ^ separated one them ^ "}" in
  let others = match asked.the_question.several with None -> [] | Some its -> its.elements in
  "{\"contacts\": " ^ string_of_int (List.length asked.the_question.contacts + List.length others)
  ^ ", \"wrench\": [" ^ separated (interval json_number) asked.stated_wrench ^ "]"
  ^ ", \"preload\": " ^ or_null json_number o.asked_preload
  ^ ", \"normal_law\": " ^ json_string (law o)
  ^ ", \"direction\": " ^ or_null json_vector o.asked_direction
  ^ ", \"preload_direction\": "
  ^ or_null (function Scale -> "\"scale\"" | By numbers -> json_vector numbers) o.asked_growth
  ^ (match o.asked_plane with
     | Some (u, v) -> ", \"plane\": [" ^ json_vector u ^ ", " ^ json_vector v ^ "]"
     | None -> "")
  ^ (match o.asked_inertia with Some it -> ", \"inertia\": " ^ json_vector it | None -> "")
  ^ (match o.asked_statics with Some it -> ", \"statics\": " ^ json_number it | None -> "")
  ^ ", \"uncertain\": " ^ uncertain
  ^ (match o.asked_bound with Some (Bounded it) -> ", \"max_motion\": " ^ json_vector it | _ -> "") ^ "}"

type report =
  | Judged of { asked : posed; answer : answer; certificate : certificate }
  | Illegible of { file : string; place : string; problem : string }
  | Not_judged of string

let proof answer size =
  let tree = Printf.sprintf "%d nodes: %d leaves" size.nodes size.leaves in
  match answer with
  | Claims _ ->
    let few text number = if number > 0 then Printf.sprintf text number else "" in
    Printf.sprintf "intervals by degree: %d%s, refuted: %d; trees of %s" size.parts
      (few ", at rest: %d" size.rests ^ few ", sticking: %d" size.stickings) size.trees tree
  | Margin _ ->
    let by_degree = if size.parts > 0 then Printf.sprintf ", by degree: %d" size.parts else "" in
    Printf.sprintf "segments: %d%s; trees: %d, of %s" size.segments by_degree size.trees tree
  | Stable when size.parts + size.rests + size.stickings > 0 ->
    let some number text = if number > 0 then [text] else [] in
    String.concat "; "
      (some size.rests (Printf.sprintf "at rest, parts: %d" size.rests)
       @ some size.stickings (Printf.sprintf "sticking, parts: %d" size.stickings)
       @ some size.parts (Printf.sprintf "by degree, parts: %d; trees of %s" size.parts tree))
  | Stable -> "an equilibrium"
  | Region _ -> Printf.sprintf "pieces: %d; a tree of %s" size.pieces tree
  | Class MustMove | CannotStand -> "a twist"
  | MayStand -> "forces"
  | StandsAmong _ | StandsWithin _ -> Printf.sprintf "load points: %d, twists: %d" size.points size.twists
  | Class MustHold -> "forces at rest, and a tree of " ^ tree
  | Class Open -> "forces at rest, and others with an acceleration"
  | _ -> "a tree of " ^ tree

let accepted asked answer certificate =
  let verdict = match answer with
    | Margin resisted -> "resisted    " ^ resisted_in_words resisted
    | Claims (resisted, refuted) ->
      let or_none listed = function [] -> "none claimed" | them -> listed them in
      "resisted    " ^ or_none resisted_in_words resisted
      ^ "\nrefuted     " ^ or_none refuted_in_words refuted ^ "\nelsewhere   nothing is claimed"
    | Region [] -> "resisted    no load of the plane"
    | Region pieces -> Printf.sprintf "resisted    of the plane exactly the pieces: %d" (List.length pieces)
    | Stable -> "verdict     stable"
    | Class found -> "verdict     " ^ class_in_words found
    | MayStand -> "verdict     may stand"
    | CannotStand -> "verdict     must move"
    | StandsAmong (multiples, moves) -> standing_in_words multiples moves ^ "\nelsewhere   nothing is claimed"
    | StandsWithin (points, forms) ->
      Printf.sprintf "may stand   the sums of load points: %d\nmust move   where a load does work on a twist: %d"
        (List.length points) (List.length forms)
    | _ -> "verdict     unstable" in
  let box = match answer with
    | (Stable | Unstable | Class _) when asked.is_box -> ", for every grasp in the box"
    | _ -> "" in
  "accepted\n" ^ verdict ^ box ^ question asked
  ^ "\nproof       " ^ proof answer (size_of certificate) ^ "\n"

let as_text = function
  | Illegible { file; place; problem } ->
    printable (file ^ ": " ^ place ^ ": " ^ problem) ^ "\n"
  | Judged { answer = Rejected (rule, at); _ } ->
    let line name = function Some text -> name ^ text ^ "\n" | None -> "" in
    "rejected\nrule   " ^ rule ^ "\n"
    ^ line "node   " (Option.map string_of_int (node_of at))
    ^ line "path   " (in_words at)
  | Judged { answer = NotProvedHere why; _ } | Not_judged why -> "not judged\nwhy    " ^ printable why ^ "\n"
  | Judged { asked; answer; certificate } -> accepted asked answer certificate

let as_json report =
  let text it = match it with Some text -> json_string text | None -> "null" in
  let line ?rule ?node ?path ?found ?verdict ?box ?size ?resisted ?refuted ?asked ?pieces ?stands ?standing result =
    let number_of part = match size with Some s -> string_of_int (part s) | None -> "null" in
    "{\"result\": " ^ json_string result ^ ", \"rule\": " ^ text rule ^ ", \"node\": "
    ^ (match node with Some n -> string_of_int n | None -> "null")
    ^ ", \"path\": " ^ text path ^ ", \"found\": " ^ text found ^ ", \"verdict\": " ^ text verdict
    ^ ", \"box\": " ^ (match box with Some b -> string_of_bool b | None -> "null")
    ^ ", \"nodes\": " ^ number_of (fun s -> s.nodes)
    ^ ", \"leaves\": " ^ number_of (fun s -> s.leaves)
    ^ ", \"resisted\": " ^ (match resisted with Some r -> json_resisted r | None -> "null")
    ^ ", \"refuted\": " ^ (match refuted with Some r -> json_refuted r | None -> "null")
    ^ ", \"question\": "
    ^ (match asked with Some a -> json_question a | None -> "null")
    ^ (match pieces with Some n -> ", \"pieces\": " ^ string_of_int n | None -> "")
    ^ (match stands with
       | Some s -> Printf.sprintf ", \"points\": %d, \"twists\": %d" s.points s.twists
       | None -> "")
    ^ (match standing with
       | Some (multiples, moves) -> ", \"standing\": " ^ json_standing multiples moves
       | None -> "") ^ "}\n" in
  match report with
  | Illegible { place; problem; _ } -> line "malformed" ~path:place ~found:problem
  | Judged { answer = Rejected (rule, at); _ } ->
    line "rejected" ~rule ?node:(node_of at) ?path:(in_words at) ~found:"see FORMAT.md"
  | Judged { answer = NotProvedHere why; _ } | Not_judged why -> line "not judged" ~found:why
  | Judged { asked; answer; certificate } ->
    let size = size_of certificate in
    let tree = match certificate.body with StableByWitness _ | OfStatics _ -> false | _ -> true in
    line "accepted" ~box:asked.is_box ~asked
      ~verdict:(match answer with Margin _ | Claims _ -> "margin" | Stable -> "stable"
                             | StandsAmong _ -> "margin"
                             | Region _ | StandsWithin _ -> "region"
                             | MayStand -> "may stand"
                             | CannotStand -> "must move"
                             | Class found -> class_in_words found | _ -> "unstable")
      ?size:(if tree then Some size else None)
      ?resisted:(match answer with Margin r | Claims (r, _) -> Some r | _ -> None)
      ?refuted:(match answer with Claims (_, r) -> Some r | _ -> None)
      ?pieces:(match answer with Region pieces -> Some (List.length pieces) | _ -> None)
      ?stands:(match answer with StandsAmong _ | StandsWithin _ -> Some size | _ -> None)
      ?standing:(match answer with StandsAmong (multiples, moves) -> Some (multiples, moves) | _ -> None)

let exit_code = function
  | Illegible _ -> 2
  | Judged { answer = Rejected _; _ } -> 1
  | Judged { answer = NotProvedHere _; _ } | Not_judged _ -> 3
  | Judged _ -> 0
