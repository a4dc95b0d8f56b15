(* SPDX-License-Identifier: MIT *)
(** The spellings of numbers: those of grasp files (FORMAT.md section 1, docs/grasp_file.md) and
    those of certificates (section 2). *)
From Coq Require Import Ascii Bool List QArith String ZArith.
From Proved Require Import Json.
Import ListNotations.
Local Open Scope Z_scope.

Definition digit (c : ascii) : option Z :=
  (if c =? "0" then Some 0 else if c =? "1" then Some 1 else if c =? "2" then Some 2
   else if c =? "3" then Some 3 else if c =? "4" then Some 4 else if c =? "5" then Some 5
   else if c =? "6" then Some 6 else if c =? "7" then Some 7 else if c =? "8" then Some 8
   else if c =? "9" then Some 9 else None)%char.

(** The digits at the front of a text: the number that they spell behind those read before, how many
    they are with those, and the rest of the text. *)
Fixpoint digits_after (value count : Z) (text : list ascii) : Z * Z * list ascii :=
  match text with
  | [] => (value, count, text)
  | c :: rest =>
      match digit c with
      | Some d => digits_after (10 * value + d) (count + 1) rest
      | None => (value, count, text)
      end
  end.
Definition digits : list ascii -> Z * Z * list ascii := digits_after 0 0.

(** Whether the text begins with [c], and what follows. *)
Definition take (c : ascii) (text : list ascii) : bool * list ascii :=
  match text with
  | first :: rest => if Ascii.eqb first c then (true, rest) else (false, text)
  | [] => (false, text)
  end.

Fixpoint is_longer_than {A : Type} (limit : Z) (text : list A) : bool :=
  match text with
  | [] => false
  | _ :: rest => (limit <=? 0) || is_longer_than (limit - 1) rest
  end.

(** A fraction; none if its denominator is 0. *)
Definition fraction (negative : bool) (num den : Z) : option Q :=
  match den with
  | Zpos p => Some (Qmake (if negative then - num else num) p)
  | _ => None
  end.

(** [digits] or [digits/digits], all of the text. *)
Definition fraction_of_digits (negative : bool) (text : list ascii) : option Q :=
  let '(num, count, rest) := digits text in
  let '(slash, rest) := take "/" rest in
  let '(den, den_count, rest) := if slash then digits rest else (1, 1, rest) in
  match rest with
  | [] => if (count =? 0) || (den_count =? 0) then None else fraction negative num den
  | _ => None
  end.

(** NUMBER of a certificate, of at most so many characters: [[-]digits] or [[-]digits/digits]. *)
Definition parse_fraction (limit : Z) (spelled : string) : option Q :=
  let text := list_ascii_of_string spelled in
  if is_longer_than limit text then None
  else let '(negative, text) := take "-" text in fraction_of_digits negative text.

Definition longest_decimal : Z := 16384.
Definition largest_exponent : Z := 4096.

(** [e] or [E], a sign and digits: the exponent, which is 0 if none is there, and the rest. *)
Definition exponent (text : list ascii) : option (Z * list ascii) :=
  let '(small, text) := take "e" text in
  let '(large, text) := if small then (true, text) else take "E" text in
  if negb large then Some (0, text)
  else
    let '(down, text) := take "-" text in
    let '(_, text) := if down then (true, text) else take "+" text in
    let '(size, count, text) := digits text in
    if (count =? 0) || (largest_exponent <? size) then None
    else Some (if down then - size else size, text).

(** A number of a grasp file or of the command line: [[+-] digits [. digits] [(e|E) [+-] digits]],
    or [[+-] digits / digits]. *)
Definition parse_decimal (spelled : string) : option Q :=
  let text := list_ascii_of_string spelled in
  if is_longer_than longest_decimal text then None
  else
    let '(negative, text) := take "-" text in
    let '(_, text) := if negative then (true, text) else take "+" text in
    let '(value, count, rest) := digits text in
    if count =? 0 then None
    else if fst (take "/" rest) then fraction_of_digits negative text
    else
      let '(point, rest) := take "." rest in
      let '(value, decimals, rest) := if point then digits_after value 0 rest else (value, 0, rest) in
      if point && (decimals =? 0) then None
      else
        match exponent rest with
        | Some (power, []) =>
            let shift := power - decimals in
            if 0 <=? shift then fraction negative (value * 10 ^ shift) 1
            else fraction negative value (10 ^ (- shift))
        | _ => None
        end.

(** A JSON number of a grasp file must be below what rounds to 2^16384 with a mantissa of 64 bits
    (docs/grasp_file.md): 2^16384 - 2^16319. *)
Definition too_large : Z :=
  let square x := x * x in
  let power := Nat.iter 14 square 2 in
  power - power / 2 ^ 65.
Definition is_not_too_large (x : Q) : bool := Z.abs (Qnum x) <? too_large * Zpos (Qden x).

(** A number of a grasp file. *)
Definition read_decimal (at_path : path) (value : json) : result Q :=
  let what := "a number such as 0.25 or 1e-3, or a string as ""3/5"""%string in
  let checked (spelled : string) (good : Q -> bool) :=
    match parse_decimal spelled with
    | Some x => if good x then Fine x
                else refuse at_path "a number below 2^16384 is expected; a string spells larger ones"
    | None => expected what at_path value
    end in
  match value with
  | Number characters => checked characters is_not_too_large
  | Text content => checked content (fun _ => true)
  | _ => expected what at_path value
  end.

Definition longest_fraction : Z := 65536.
Definition longest_json_integer : Z := 4000.

(** NUMBER. *)
Definition read_fraction (at_path : path) (value : json) : result Q :=
  let read :=
    match value with
    | Number characters => parse_fraction longest_json_integer characters
    | Text content => parse_fraction longest_fraction content
    | _ => None
    end in
  match read with
  | Some x => Fine x
  | None => expected "an integer, or a string such as ""-3/5""" at_path value
  end.

(** CONTACT, and other JSON integers of 0 or more. *)
Definition read_index (at_path : path) (value : json) : result Z :=
  let what := "an integer of 0 or more"%string in
  match value with
  | Number characters =>
      match parse_fraction longest_json_integer characters with
      | Some x => if 0 <=? Qnum x then Fine (Qnum x) else expected what at_path value
      | None => expected what at_path value
      end
  | _ => expected what at_path value
  end.
