(* SPDX-License-Identifier: MIT *)
(* The integers of extracted/checker.ml, which is compiled with this open: Zarith's, and what long ones cost is
   counted before it is done. *)
module Big_int_Z = struct
  include Big_int_Z

  let add_big_int a b = Work.sum a b; add_big_int a b
  let sub_big_int a b = Work.sum a b; sub_big_int a b
  let succ_big_int a = Work.sum a a; succ_big_int a
  let minus_big_int a = Work.sum a a; minus_big_int a
  let mult_int_big_int k a = Work.sum a a; mult_int_big_int k a
  let shift_right_big_int a k = Work.sum a a; shift_right_big_int a k

  let shift_left_big_int a k =
    Work.spend_products (k / 16);  (* 64 bits of zeros are a word *)
    Work.sum a a;
    shift_left_big_int a k

  let mult_big_int a b = Work.product a b; mult_big_int a b
  let quomod_big_int a b = Work.product a b; quomod_big_int a b
  let div_big_int a b = Work.product a b; div_big_int a b
  let mod_big_int a b = Work.product a b; mod_big_int a b
  let sqrt_big_int a = Work.product a a; sqrt_big_int a
  let gcd_big_int a b = Work.divisor a b; gcd_big_int a b

  (* Extract.v; Zarith has it by another name. *)
  let num_bits_big_int = Z.numbits
end
