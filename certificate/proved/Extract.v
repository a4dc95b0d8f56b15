(* SPDX-License-Identifier: MIT *)
(* The program of reader and checker: extracted/.  Integers become Zarith's, and so do the operations
   that are named here and in ExtrOcamlZBigInt; with the OCaml compiler, these are trusted. *)
From Coq Require Import Extraction ExtrOcamlBasic ExtrOcamlNativeString ExtrOcamlZBigInt.
From Coq Require Import ZArith.
From Proved Require Import Json Judge Numeral Pose Question Checker.

Extract Constant Z.ltb => "Big_int_Z.lt_big_int".
Extract Constant Z.leb => "Big_int_Z.le_big_int".
Extract Constant Z.land => "Big_int_Z.and_big_int".
Extract Constant Z.lor => "Big_int_Z.or_big_int".
Extract Constant Z.gcd => "Big_int_Z.gcd_big_int".
(* Coq's halves its argument once for each bit, which takes the square of its length. *)
Extract Constant Z.log2 =>
  "(fun n -> if Big_int_Z.sign_big_int n <= 0 then Big_int_Z.zero_big_int
  else Big_int_Z.big_int_of_int (Big_int_Z.num_bits_big_int n - 1))".
Extract Constant Z.sqrt =>
  "(fun n -> Big_int_Z.sqrt_big_int (Big_int_Z.max_big_int n Big_int_Z.zero_big_int))".

Extraction "extracted/checker.ml" ask judge check parse_decimal.
