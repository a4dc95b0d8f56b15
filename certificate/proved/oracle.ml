(* SPDX-License-Identifier: MIT *)
(* Advice on which rays of a region to keep (Question.v, oracle), by the double description method:
   a region is known by its rays and by the forms that are nowhere negative on it. Nobody has to
   believe any of this: Cone.v checks each reason to drop a ray, and keeps the ray if it is wrong. *)

module Integer = Z  (* Zarith's; Checker has one of its own *)

open Checker

let rec dot a b = match a, b with
  | x :: a, y :: b -> Integer.add (Integer.mul x y) (dot a b)
  | _ -> Integer.zero

(* p a + q b *)
let rec combination p a q b = match a, b with
  | x :: a, y :: b -> Integer.add (Integer.mul p x) (Integer.mul q y) :: combination p a q b
  | a, [] -> List.map (Integer.mul p) a
  | [], b -> List.map (Integer.mul q) b

let content = List.fold_left Integer.gcd Integer.zero
let is_zero = List.for_all (fun x -> Integer.sign x = 0)

(* A ray, with the numbers of the forms that are zero on it as bits; or one of the two, r and -r,
   that stand for a line, without bits, as all forms are zero on lines. *)
type generator = { x : Integer.t list; tight : Integer.t; is_line : bool }

type form = { at : Integer.t list; number : int }

(* The region of the generators, which are in the order of the rays of Cone.v, is where all forms are 0
   or more, and some others, that are not listed, are 0. *)
type region = { generators : generator list; forms : form list }

let begin_region dimension =
  let axis k = List.init dimension (fun j -> if j = k then Integer.one else Integer.zero) in
  let line x = { x; tight = Integer.zero; is_line = true } in
  let both k = [ line (axis k); line (List.map Integer.neg (axis k)) ] in
  { generators = List.concat_map both (List.init dimension Fun.id); forms = [] }

let contains a b = Integer.equal (Integer.logand a b) b
let bit k = Integer.shift_left Integer.one k
let with_bit bits g = if g.is_line then g else { g with tight = Integer.logor g.tight bits }

(* What Cone.v takes for candidates, in its order: with the values of the form. *)
type candidate =
  | Staying of generator * Integer.t
  | Joined of (generator * Integer.t) * (generator * Integer.t)

let candidates equality valued =
  let where good = List.filter (fun (_, v) -> good (Integer.sign v)) valued in
  let below = where (fun s -> s < 0) in
  List.map (fun (g, v) -> Staying (g, v)) (where (fun s -> if equality then s = 0 else s >= 0))
  @ List.concat_map (fun p -> List.map (fun n -> Joined (p, n)) below) (where (fun s -> s > 0))

(* Above and below the plane as [join] of Cone.v has it, without a common factor; and the factor. *)
let join (p, vp) (n, vn) =
  let x = combination vp n.x (Integer.neg vn) p.x in
  let factor = content x in
  let factor = if Integer.sign factor = 0 then Integer.one else factor in
  ((if Integer.equal factor Integer.one then x else List.map (fun c -> Integer.divexact c factor) x),
   factor)

(* What becomes of a candidate. A reason to drop it is a positive multiple of it as a sum of multiples of
   generators that are kept, each known by its identity. *)
type fate = Kept of generator | Dropped of Integer.t * (generator * Integer.t) list

(* The line through [up] leaves the plane: all others are moved along it into the plane, and of itself
   the half above remains. *)
let cut_line form_bit forms (up, v_up) valued =
  let is_opposite (g, _) = List.for_all2 (fun a b -> Integer.equal a (Integer.neg b)) g.x up.x in
  let down, v_down = List.find is_opposite valued in
  let all = List.fold_left (fun bits f -> Integer.logor bits (bit f.number)) Integer.zero forms in
  let half = { up with is_line = false; tight = all } in
  let moved = ref [] in
  let move (g, v) =
    match List.assq_opt g !moved with
    | Some found -> found
    | None ->
      let x, factor =
        if Integer.sign v > 0 then join (g, v) (down, v_down) else join (up, v_up) (g, v) in
      let found = (with_bit form_bit { g with x }, factor) in
      moved := (g, found) :: !moved;
      found in
  function
  | Staying (g, v) when Integer.sign v = 0 -> Kept (with_bit form_bit g)
  | Staying (g, _) when g == up -> Kept half
  | Staying (g, v) ->
    let m, factor = move (g, v) in
    Dropped (v_up, [ (m, factor); (half, v) ])
  | Joined ((p, _), (n, _)) when p == up && n == down -> Dropped (Integer.one, [])
  | Joined ((p, _), (n, v)) when p == up -> Kept (fst (move (n, v)))
  | Joined ((p, v), (n, _)) when n == down -> Kept (fst (move (p, v)))
  | Joined ((p, vp), (n, vn)) ->
    let mp, fp = move (p, vp) and mn, fn = move (n, vn) in
    Dropped (v_up, [ (mn, Integer.mul vp fn); (mp, Integer.mul (Integer.neg vn) fp) ])

(* Multiples >= 0 of lines that add up to a positive multiple of [x], and that; by elimination. *)
let on_lines lines x =
  (* Each row: a combination of lines, and which. *)
  let rec reduce rows x multiples factor =
    match rows with
    | [] -> if is_zero x then Some (factor, multiples) else None
    | (pivot, row, of_lines) :: rows ->
      let c = List.nth x pivot and d = List.nth row pivot in
      if Integer.sign c = 0 then reduce rows x multiples factor
      else
        let s = Integer.of_int (Integer.sign d) in
        let d = Integer.abs d and c = Integer.mul s c in
        reduce rows
          (combination d x (Integer.neg c) row)
          (combination d multiples c of_lines)
          (Integer.mul d factor) in
  let count = List.length lines in
  let unit k = List.init count (fun j -> if j = k then Integer.one else Integer.zero) in
  let rec echelon k rows = function
    | [] -> rows
    | l :: lines ->
      let row, of_lines =
        List.fold_left
          (fun (row, of_lines) (pivot, other, others) ->
            let c = List.nth row pivot and d = List.nth other pivot in
            (combination d row (Integer.neg c) other, combination d of_lines (Integer.neg c) others))
          (l.x, unit k) rows in
      let rec first j = function
        | [] -> None
        | c :: rest -> if Integer.sign c <> 0 then Some j else first (j + 1) rest in
      (match first 0 row with
       | None -> echelon (k + 1) rows lines
       | Some pivot -> echelon (k + 1) (rows @ [ (pivot, row, of_lines) ]) lines) in
  let zeros = List.init count (fun _ -> Integer.zero) in
  reduce (echelon 0 [] lines) x zeros Integer.one

(* The bits of the forms whose values are 0. *)
let bits_of_zeros forms values =
  let add bits f v = if Integer.sign v = 0 then Integer.logor bits (bit f.number) else bits in
  List.fold_left2 add Integer.zero forms values

(* Adds to the terms what [x], a sum of lines, is of them: a line with a negative multiple is its other
   half. *)
let with_lines lines x factor terms =
  if is_zero x then Some (factor, terms)
  else
    match on_lines lines x with
    | None -> None
    | Some (by_, multiples) ->
      let half l c =
        let opposite o = is_zero (combination Integer.one o.x Integer.one l.x) in
        if Integer.sign c > 0 then l else List.find opposite lines in
      let add terms l c = if Integer.sign c = 0 then terms else (half l c, Integer.abs c) :: terms in
      let scaled = List.map (fun (g, c) -> (g, Integer.mul by_ c)) terms in
      Some (Integer.mul by_ factor, List.fold_left2 add scaled lines multiples)

(* A face of the region: its rays, its sides, which are forms that are zero on some of the rays and not
   on all, and the values of these on each ray. *)
type face = { sides : form list; rays : (generator * Integer.t list Lazy.t) list }

(* That where the forms of the bits are zero. *)
let make_face forms generators bits =
  let rays = List.filter (fun g -> (not g.is_line) && contains g.tight bits) generators in
  let sides = match rays with
    | [ _ ] -> forms
    | _ ->
      let some = List.fold_left (fun some g -> Integer.logor some g.tight) bits rays in
      let sides = Integer.logxor some bits in
      List.filter (fun f -> Integer.testbit sides f.number) forms in
  { sides; rays = List.map (fun g -> (g, lazy (List.map (fun f -> dot f.at g.x) sides))) rays }

(* A positive multiple of [x] as a sum of multiples of generators. They are those of the smallest face
   that x lies in, and are subtracted one after another, each until x leaves the face. *)
let reason face lines x =
  let rec go factor terms x values =
    if is_zero values then with_lines lines x factor terms
    else
      let zeros = bits_of_zeros face.sides values in
      match List.find_opt (fun (g, _) -> contains g.tight zeros) face.rays with
      | None -> None
      | Some (g, lazy slopes) ->
        (* The least v / s over sides with s > 0. *)
        let least best v s =
          match best with
          | _ when Integer.sign s <= 0 -> best
          | Some (v', s') when Integer.compare (Integer.mul v s') (Integer.mul v' s) >= 0 -> best
          | _ -> Some (v, s) in
        (match List.fold_left2 least None values slopes with
         | None -> None
         | Some (v, s) ->
           let without y z = combination s y (Integer.neg v) z in
           let terms = (g, v) :: List.map (fun (h, c) -> (h, Integer.mul s c)) terms in
           go (Integer.mul s factor) terms (without x g.x) (without values slopes)) in
  match go Integer.one [] x (List.map (fun f -> dot f.at x) face.sides) with
  | None -> None
  | Some (factor, terms) ->
    let divisor = List.fold_left (fun d (_, c) -> Integer.gcd d c) factor terms in
    let short c = Integer.divexact c divisor in
    Some (short factor, List.map (fun (g, c) -> (g, short c)) terms)

(* All lines are in the plane. Combinations of rays that are not neighbours are not needed. *)
let cut_rays form_bit forms generators all =
  let rays = List.filter (fun g -> not g.is_line) generators in
  let neighbours p n =
    let common = Integer.logand p.tight n.tight in
    not (List.exists (fun g -> g != p && g != n && contains g.tight common) rays) in
  let combined (p, vp) (n, vn) =
    { x = fst (join (p, vp) (n, vn)); is_line = false;
      tight = Integer.logor (Integer.logand p.tight n.tight) form_bit } in
  let needed = function
    | Staying (g, v) -> Some (if Integer.sign v = 0 then with_bit form_bit g else g)
    | Joined (p, n) -> if neighbours (fst p) (fst n) then Some (combined p n) else None in
  let found = List.map needed all in
  let kept = List.filter_map Fun.id found in
  let lines = List.filter (fun g -> g.is_line) kept in
  let faces = ref [] in
  let face_of bits =
    match List.find_opt (fun (known, _) -> Integer.equal known bits) !faces with
    | Some (_, face) -> face
    | None ->
      let face = make_face forms kept bits in
      faces := (bits, face) :: !faces;
      face in
  let fate candidate = function
    | Some g -> Kept g
    | None ->
      (match candidate with
       | Staying (g, _) -> Kept g
       | Joined ((p, vp), (n, vn)) ->
         let face = face_of (Integer.logor (Integer.logand p.tight n.tight) form_bit) in
         (match reason face lines (combination vp n.x (Integer.neg vn) p.x) with
          | Some (factor, terms) -> Dropped (factor, terms)
          | None -> Kept (combined (p, vp) (n, vn)))) in
  List.map2 fate all found

let rec nat_of_int n = if n = 0 then O else S (nat_of_int (n - 1))

let advice kept = function
  | Kept _ -> Keep
  | Dropped (factor, terms) ->
    let rec place k g = function
      | h :: others -> if h == g then k else place (k + 1) g others
      | [] -> k in
    Drop (factor, List.map (fun (g, c) -> (nat_of_int (place 0 g kept), c)) terms)

(* A form that is zero on none of several rays is positive wherever it matters, and stays so. *)
let needed_forms generators forms =
  let rays = List.filter (fun g -> not g.is_line) generators in
  match rays with
  | [] | [ _ ] -> forms
  | _ ->
    let used = List.fold_left (fun bits g -> Integer.logor bits g.tight) Integer.zero rays in
    List.filter (fun f -> Integer.testbit used f.number) forms

(* The least number that no form has. *)
let free_number forms =
  let rec from k = if List.exists (fun f -> f.number = k) forms then from (k + 1) else k in
  from 0

let answer region form equality =
  let valued = List.map (fun g -> (g, dot form g.x)) region.generators in
  let count good = List.length (List.filter (fun (_, v) -> good (Integer.sign v)) valued) in
  Work.spend (List.length valued + (count (fun s -> s > 0) * count (fun s -> s < 0)));
  let all = candidates equality valued in
  let number = free_number region.forms in
  let form_bit = if equality then Integer.zero else bit number in
  let forms = if equality then region.forms else { at = form; number } :: region.forms in
  let fates =
    match List.find_opt (fun (g, v) -> g.is_line && Integer.sign v > 0) valued with
    | Some line -> List.map (cut_line form_bit region.forms line valued) all
    | None -> cut_rays form_bit forms region.generators all in
  let kept = List.filter_map (function Kept g -> Some g | Dropped _ -> None) fates in
  ({ generators = kept; forms = needed_forms kept forms }, List.map (advice kept) fates)

(* What was just answered in advance, for the region and the form: of `foremost`. *)
let answered = ref []

let advise region form equality =
  match List.find_opt (fun (r, f, _) -> r == region && not equality && List.equal Integer.equal f form) !answered with
  | Some (_, _, found) -> found
  | None -> answer region form equality

(* Where many forms cut, as those of the bilateral law do at a root, those first that cut deepest, in doubles: with few
   of them the region is what it is with all. *)
let foremost region conditions =
  answered := [];
  if List.compare_length_with conditions 20 < 0 then []
  else begin
    let unit x =
      let v = Array.of_list (List.map Integer.to_float x) in
      let size = sqrt (Array.fold_left (fun s c -> s +. (c *. c)) 0. v) in
      if size > 0. && size < infinity then Array.map (fun c -> c /. size) v else Array.map (fun _ -> 0.) v in
    let forms = Array.of_list conditions in
    let units = Array.map (fun (form, _) -> unit form) forms in
    let product a b =
      let sum = ref 0. in
      for k = 0 to min (Array.length a) (Array.length b) - 1 do sum := !sum +. (a.(k) *. b.(k)) done;
      !sum in
    let rec go region numbers =
      let rays = List.map (fun g -> unit g.x) region.generators in
      let depth k = List.fold_left (fun least r -> Float.min least (product units.(k) r)) 0. rays in
      let deepest = ref (-1) and most = ref (-1e-12) in
      Array.iteri
        (fun k (_, equality) ->
          if not equality then
            let it = depth k in
            if it < !most then begin deepest := k; most := it end)
        forms;
      if !deepest < 0 then List.rev numbers
      else begin
        let form = fst forms.(!deepest) in
        let found = answer region form false in
        answered := (region, form, found) :: !answered;
        units.(!deepest) <- [||];
        go (fst found) (Integer.of_int !deepest :: numbers)
      end in
    go region []
  end

let oracle = { begin0 = (fun n -> begin_region (Print.int_of_nat n)); advise; foremost }
