(* SPDX-License-Identifier: MIT *)
(** What the numbers of grasp files and of the command line mean: FORMAT.md sections 1 and 2, docs/grasp_file.md.
    Numeral.v is proved to read this, and nothing else, as these values. *)
From Coq Require Import Ascii List QArith String ZArith.
From Proved Require Import Json.
Import ListNotations.
Local Open Scope Z_scope.

Definition text : Set := list ascii.

Inductive digit_is : ascii -> Z -> Prop :=
| zero : digit_is "0" 0 | one : digit_is "1" 1 | two : digit_is "2" 2 | three : digit_is "3" 3
| four : digit_is "4" 4 | five : digit_is "5" 5 | six : digit_is "6" 6 | seven : digit_is "7" 7
| eight : digit_is "8" 8 | nine : digit_is "9" 9.

(** Digits, one or more. *)
Inductive natural : text -> Z -> Prop :=
| one_digit c d : digit_is c d -> natural [c] d
| one_more ds n c d : natural ds n -> digit_is c d -> natural (ds ++ [c]) (10 * n + d).

Inductive sign : text -> Z -> Prop :=
| no_sign : sign [] 1
| plus : sign ["+"%char] 1
| minus : sign ["-"%char] (-1).

Inductive decimals : text -> Q -> Prop :=
| no_decimals : decimals [] 0
| after_point ds n : natural ds n ->
    decimals ("."%char :: ds) (inject_Z n / inject_Z (10 ^ Z.of_nat (List.length ds))).

Definition largest_exponent : Z := 4096.

Inductive power_of_ten : text -> Z -> Prop :=
| no_power : power_of_ten [] 0
| to_the e s f ds n : e = "e"%char \/ e = "E"%char -> sign s f -> natural ds n -> n <= largest_exponent ->
    power_of_ten (e :: s ++ ds) (f * n).

Inductive number : text -> Q -> Prop :=
| a_decimal s f whole n part x e p :
    sign s f -> natural whole n -> decimals part x -> power_of_ten e p ->
    number (s ++ whole ++ part ++ e) (inject_Z f * (inject_Z n + x) * inject_Z 10 ^ p)
| a_fraction s f num n den d :
    sign s f -> natural num n -> natural den d -> d <> 0 ->
    number (s ++ num ++ "/"%char :: den) (inject_Z f * (inject_Z n / inject_Z d)).

Definition longest_number : Z := 16384.

(** So many characters, which spell a number that is equal to [x]. *)
Definition spells (characters : string) (x : Q) : Prop :=
  let it := list_ascii_of_string characters in
  Z.of_nat (List.length it) <= longest_number /\ exists y, number it y /\ (x == y)%Q.

(** A JSON number must be below what rounds to 2^16384 with a mantissa of 64 bits: 2^16384 - 2^16319. *)
Definition too_large : Z :=
  let square x := x * x in
  let power := Nat.iter 14 square 2 in
  power - power / 2 ^ 65.
Definition is_not_too_large (x : Q) : bool := Z.abs (Qnum x) <? too_large * Zpos (Qden x).

(** A value of a grasp file that is a number. *)
Definition is_number (value : json) (x : Q) : Prop :=
  match value with
  | Number characters => spells characters x /\ is_not_too_large x = true
  | Text content => spells content x
  | _ => False
  end.
