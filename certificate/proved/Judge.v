(* SPDX-License-Identifier: MIT *)
(** From the texts of both files to the answer. What is malformed anywhere is malformed, so all is read
    before any rule is looked at. *)
From Coq Require Import Bool List QArith String ZArith.
From Proved Require Import Checker Correct Json Meaning Pose Question ReadBodies ReadCertificate ReadGrasp.
Local Open Scope string_scope.

(** The question that the options ask of a grasp file. *)
Definition ask (asked : options) (file : json) : result posed :=
  let* it := read_file file in pose it asked.

(** What a certificate proves about it. *)
Definition judge (memory : Type) (advisor : oracle memory) (asked : posed) (text : json)
  : result (answer * certificate) :=
  let q := the_question asked in
  let* '(stated, it) := read_certificate q text in
  match broken_question_rule stated asked with
  | Some rule => Fine (Rejected rule Nowhere, it)
  | None => Fine (check memory advisor q it, it)
  end.

(** The answer is true of the question, whatever the text and the advice. *)
Theorem judge_correct : forall memory advisor asked text found it,
  judge memory advisor asked text = Fine (found, it) -> true_answer (the_question asked) found.
Proof.
  intros memory advisor asked text found it. unfold judge, bind.
  destruct (read_certificate _ text) as [[stated read] |]; [| discriminate].
  destruct (broken_question_rule stated asked); intros [= <- <-].
  - exact I.
  - apply check_correct.
Qed.

Check judge_correct.
Print Assumptions judge_correct.
