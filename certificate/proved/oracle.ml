(* SPDX-License-Identifier: MIT *)
(* Advice for the checker (Question.v, oracle), which nobody has to believe. *)

module Integer = Z  (* Zarith's; Checker has one of its own *)

open Checker

let permits combinations =
  Work.spend (if Integer.fits_int combinations then Integer.to_int combinations else max_int);
  true

(* In doubles, of length 1. *)
let unit x =
  let v = Array.of_list (List.map Integer.to_float x) in
  let size = sqrt (Array.fold_left (fun s c -> s +. (c *. c)) 0. v) in
  if size > 0. && size < infinity then Array.map (fun c -> c /. size) v else Array.map (fun _ -> 0.) v

let product a b =
  let sum = ref 0. in
  for k = 0 to min (Array.length a) (Array.length b) - 1 do sum := !sum +. (a.(k) *. b.(k)) done;
  !sum

(* Those of the conditions that were asked about last. *)
let units = ref ([], [||])

let units_of conditions =
  if fst !units != conditions then
    units := (conditions,
              Array.map (fun (form, equality) -> if equality then [||] else unit form)
                (Array.of_list conditions));
  snd !units

(* Where many forms cut, as those of the bilateral law do at a root, those first that cut deepest: with few of them the
   region is what it is with all. *)
let foremost rays conditions =
  if List.compare_length_with conditions 20 < 0 then None
  else begin
    let forms = units_of conditions and rays = List.map unit rays in
    let depth form = List.fold_left (fun least r -> Float.min least (product form r)) 0. rays in
    let deepest = ref (-1) and most = ref (-1e-12) in
    Array.iteri
      (fun k form ->
        let it = depth form in
        if it < !most then begin deepest := k; most := it end)
      forms;
    if !deepest < 0 then None
    else begin
      let k = !deepest in
      forms.(k) <- [||];  (* once is enough *)
      Some (Integer.of_int k)
    end
  end

let oracle = { permits; foremost }
