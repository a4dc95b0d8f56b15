(* SPDX-License-Identifier: MIT *)
(* What is proved, and what the proof assumes: axioms of Coq's real numbers, and nothing else. *)
From Proved Require Import Meaning Checker Correct.

About check_correct.
Check check_correct.
Print true_answer.
Print Assumptions check_correct.
