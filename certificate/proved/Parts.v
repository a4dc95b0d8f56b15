(* SPDX-License-Identifier: MIT *)
(* The parts of a stable verdict (FORMAT.md section 6): a tree of boxes, each of which is proved stable at rest or
   by degree.  `parts_stable`: where all parts hold, every system in the box is stable. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Leaf Walk Tree Matrix RowLimits ByDegree Rest.
From Proved Require Rows Model.
Import ListNotations.

Section Checker.
Variable memory : Type.
Variable advisor : oracle memory.
Variable two_sided : bool.
Variable most_depth : Z.

(* A part that is not cut, for all multiples from alpha to beta; and the node, if a rule about one fails. *)
Definition part_fails (alpha beta : Q) (s : setting) (p : part) : option (string * option nat) :=
  match p with
  | PartProof d0 simplex walls direction tree =>
      degree_fails memory advisor two_sided most_depth s (DegreeProof alpha (Some beta) d0 d0 simplex walls direction) tree
  | PartAtRest forces answers reach =>
      match rest_fails s alpha beta (RestProof forces answers reach) with
      | Some rule => Some (rule, None)
      | None => None
      end
  | PartCut _ _ _ => Some ("part-inside"%string, None)
  end.

(* The boxes that parts still have to be about, with their depth, the next one first. *)
Fixpoint parts_fail (parts : list part) (todo : list (setting * Z)) (number : nat) : option (string * place) :=
  match parts, todo with
  | [], [] => None
  | [], _ :: _ => Some ("tree-short"%string, AtPart number None)
  | _ :: _, [] => Some ("tree-long"%string, AtPart number None)
  | p :: parts', (s, depth) :: todo' =>
      if Z.ltb most_depth depth then Some ("node-depth"%string, AtPart number None)
      else
        match p with
        | PartCut name i c =>
            match halves s name i c with
            | inl (lo, hi) => parts_fail parts' ((lo, (depth + 1)%Z) :: (hi, (depth + 1)%Z) :: todo') (S number)
            | inr rule => Some (rule, AtPart number None)
            end
        | _ =>
            match part_fails 0 0 s p with
            | Some (rule, node) => Some (rule, AtPart number node)
            | None => parts_fail parts' todo' (S number)
            end
        end
  end.

End Checker.

Section Proofs.
Open Scope R_scope.

Variable memory : Type.
Variable advisor : oracle memory.
Variable two_sided : bool.
Variable most_depth : Z.
Variable sys : Rows.system.
Hypothesis law : Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral).

Theorem part_stable alpha beta s p lambda : part_fails memory advisor two_sided most_depth alpha beta s p = None ->
  in_setting s sys -> Q2R alpha <= lambda <= Q2R beta -> Rows.stable_at sys lambda.
Proof.
  intros H I L. destruct p as [name i c|d0 simplex walls direction tree|forces answers reach]; cbn in H; [discriminate| |].
  - eapply (stable_by_degree_in_box memory advisor); [exact I|exact H|exact law| |]; cbn; apply L.
  - destruct (rest_fails _ _ _ _) eqn:E; [discriminate|]. eapply stable_at_rest; eassumption.
Qed.

Theorem parts_stable parts todo number : parts_fail memory advisor two_sided most_depth parts todo number = None ->
  Forall (fun sd => in_setting (fst sd) sys -> Rows.stable_at sys 0) todo.
Proof.
  revert todo number. induction parts as [|p parts IH]; intros [|[s depth] todo] number H; cbn [parts_fail] in H;
    try discriminate; [constructor|].
  destruct (Z.ltb most_depth depth); [discriminate|].
  assert (Q0 : Q2R 0 <= 0 <= Q2R 0) by (rewrite Q2R_0; lra).
  assert (Whole : match part_fails memory advisor two_sided most_depth 0 0 s p with
      | Some (rule, node) => Some (rule, AtPart number node)
      | None => parts_fail memory advisor two_sided most_depth parts todo (S number)
      end = None -> Forall (fun sd => in_setting (fst sd) sys -> Rows.stable_at sys 0) ((s, depth) :: todo)).
  { destruct (part_fails _ _ _ _ _ _ s p) as [[rule node]|] eqn:E; [discriminate|]. intros H'.
    constructor; [|now apply (IH todo (S number))]. cbn. intros I. exact (part_stable 0 0 s p 0 E I Q0). }
  destruct p as [name i c|d0 simplex walls direction tree|forces answers reach]; try (now apply Whole).
  clear Whole. destruct (halves s name i c) as [[lo hi]|] eqn:E; [|discriminate].
  pose proof (IH _ _ H) as A. pose proof (Forall_inv A) as A1. pose proof (Forall_inv (Forall_inv_tail A)) as A2.
  constructor; [|exact (Forall_inv_tail (Forall_inv_tail A))]. cbn in *. intros [Bx Di Pr Le Sl Pu].
  destruct (halves_contain s name i c lo hi sys E Bx) as [Same C].
  destruct (Same lo (or_introl eq_refl)) as (D1 & S1 & P1), (Same hi (or_intror eq_refl)) as (D2 & S2 & P2).
  destruct C as [C|C]; [apply A1|apply A2]; constructor; congruence.
Qed.

End Proofs.
