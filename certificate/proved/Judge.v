(* SPDX-License-Identifier: MIT *)
(** From the texts of both files to the answer. What is malformed anywhere is malformed, so all is read
    before any rule is looked at. *)
From Coq Require Import Bool List QArith String ZArith.
From Proved Require Import Checker Correct GraspFile Json Meaning Pose Question ReadBodies ReadCertificate ReadGrasp.
Local Open Scope string_scope.

(** The question that the options ask of a grasp file. *)
Definition ask (asked : options) (file : json) : result posed :=
  let* it := read_file file in pose it asked.

(** It is about the numbers that the file of one body states. *)
Theorem ask_says : forall asked file it, ask asked file = Fine it ->
  exists g, (bodies_read g = None -> is_grasp file g) /\ pose g asked = Fine it.
Proof.
  intros asked file it H. apply bind_fine in H as (g & G & P). exists g. split; [now apply read_file_says|exact P].
Qed.

(** What a certificate proves about it. *)
Definition judge (advisor : oracle) (asked : posed) (text : json)
  : result (answer * certificate) :=
  let q := the_question asked in
  let* '(stated, it) := read_certificate q text in
  match broken_question_rule stated asked with
  | Some rule => Fine (Rejected rule Nowhere, it)
  | None => Fine (check advisor q it, it)
  end.

(** The answer is true of the question, whatever the text and the advice. *)
Theorem judge_correct : forall advisor asked text found it,
  judge advisor asked text = Fine (found, it) -> true_answer (the_question asked) found.
Proof.
  intros advisor asked text found it. unfold judge, bind.
  destruct (read_certificate _ text) as [[stated read] |]; [| discriminate].
  destruct (broken_question_rule stated asked); intros [= <- <-].
  - exact I.
  - apply check_correct.
Qed.

Check ask_says.
Check judge_correct.
Definition both_theorems := (ask_says, judge_correct).
Print Assumptions both_theorems.
