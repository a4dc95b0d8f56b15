(* SPDX-License-Identifier: MIT *)
(* The limit of work for one question (FORMAT.md section 8): a short file can ask for more than any
   machine has. Counted are combinations of rays, which the oracle hears of before Cutting.v makes
   them, and what is allocated, which is what all else costs here; no time is measured. Where the limit
   is passed an exception ends the proof: nothing is answered, so no theorem is touched. *)

exception Too_much of string

let bytes = ref 0
let combinations = ref 0
let words_before = ref 0.

let begin_question () =
  bytes := 0;
  combinations := 0;
  words_before := Gc.minor_words ()

(* Both grow with the square of the files' length. *)
let most_combinations () = 800_000 + (!bytes * !bytes / 150)
let most_words () = 5e8 +. (5. *. float_of_int !bytes *. float_of_int !bytes)

let refuse most what =
  raise (Too_much (Printf.sprintf "it takes more than %.0f %s, the most for %d bytes" most what !bytes))

let spend count =
  combinations := !combinations + count;
  let most = most_combinations () in
  if !combinations > most then refuse (float_of_int most) "combinations of rays"

(* Now and then while memory is allocated, wherever that is. *)
let watch () =
  let look _ =
    if Gc.minor_words () -. !words_before > most_words () then refuse (most_words ()) "words of memory";
    None in
  Gc.Memprof.start ~sampling_rate:1e-6
    { Gc.Memprof.null_tracker with alloc_minor = look; alloc_major = look }
