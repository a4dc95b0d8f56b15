(* SPDX-License-Identifier: MIT *)
(* The limits of work for one question (FORMAT.md section 8): a short file can ask for more than any
   machine has. Counted are products of words, as all checkers count them, before they are made
   (counted.ml); combinations of rays, which the oracle hears of before Cutting.v makes them; and what is
   allocated, which is what all else costs here; no time is measured. Where a limit is passed an exception
   ends the proof: nothing is answered, so no theorem is touched. *)

exception Too_much of string

let bytes = ref 0
let products = ref 0
let combinations = ref 0
let words_before = ref 0.

let begin_question () =
  bytes := 0;
  products := 0;
  combinations := 0;
  words_before := Gc.minor_words ()

(* All grow with the square of the files' length. *)
let most_products () = 500_000_000 + (5 * !bytes * !bytes)
let most_combinations () = 800_000 + (!bytes * !bytes / 150)
let most_words () = 5e8 +. (5. *. float_of_int !bytes *. float_of_int !bytes)

let refuse most what =
  raise (Too_much (Printf.sprintf "it takes more than %.0f %s, the most for %d bytes" most what !bytes))

let spend count =
  combinations := !combinations + count;
  let most = most_combinations () in
  if !combinations > most then refuse (float_of_int most) "combinations of rays"

let spend_products count =
  products := !products + count;
  if !products > most_products () then refuse (float_of_int (most_products ())) "products of words"

(* Numbers that fit into a machine's word cost what is allocated for them. *)
let is_short (x : Z.t) = Obj.is_int (Obj.repr x)

(* Of numbers of so many words: n m, or 8 n sqrt m where the shorter has more than 64. *)
let products_of n m =
  let n, m = if n < m then m, n else n, m in
  if m <= 64 then n * m else int_of_float (8. *. float_of_int n *. sqrt (float_of_int m))

(* Where one of them is long; a sum of words costs about as much as four products. *)
let product a b = if not (is_short a && is_short b) then spend_products (products_of (Z.size a) (Z.size b))
let divisor a b = if not (is_short a && is_short b) then spend_products (4 * products_of (Z.size a) (Z.size b))
let sum a b = if not (is_short a && is_short b) then spend_products (4 * max (Z.size a) (Z.size b))

(* Now and then while memory is allocated, wherever that is. *)
let watch () =
  let look _ =
    if Gc.minor_words () -. !words_before > most_words () then refuse (most_words ()) "words of memory";
    None in
  Gc.Memprof.start ~sampling_rate:1e-6
    { Gc.Memprof.null_tracker with alloc_minor = look; alloc_major = look }
