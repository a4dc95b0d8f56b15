(* SPDX-License-Identifier: MIT *)
(* The parts of a stable verdict (FORMAT.md section 6): a tree of boxes, each of which is proved stable at rest, by
   sticking or by degree.  `parts_stable`: where all parts hold, every system in the box is stable. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Leaf Walk Tree Matrix RowLimits
  Load Bound Frame ByDegree OpenContacts Rest Sticking.
From Proved Require Rows Model.
Import ListNotations.

Section Checker.
Variable advisor : oracle.
Variable two_sided : bool.
Variable most_depth : Z.

(* A part that is not cut, for all multiples from alpha to beta; and the node, if a rule about one fails. *)
Definition part_fails (alpha beta : Q) (s : setting) (p : part) : option (string * option nat) :=
  match p with
  | PartProof d0 open simplex walls direction tree =>
      degree_with_open_fails advisor two_sided most_depth open s
        (DegreeProof alpha (Some beta) d0 d0 simplex walls direction) tree
  | PartAtRest forces answers reach =>
      match rest_fails s alpha beta (RestProof forces answers reach) with
      | Some rule => Some (rule, None)
      | None => None
      end
  | PartSticking d0 friction presses answers reach energy =>
      match sticking_fails two_sided s alpha beta (StickingProof d0 friction presses answers reach energy) with
      | Some rule => Some (rule, None)
      | None => None
      end
  | PartCut _ _ _ => Some ("part-inside"%string, None)
  end.

(* A segment by degree of a margin, from a multiple to another or without end; where w and P are 0, what holds
   from 1 on holds from 0 on. *)
Definition unloaded (s : setting) : bool :=
  one_load (the_load s) && forallb is_zero (map low (load_box (the_load s))) &&
  forallb (fun r => is_zero (low (box_preload (box r))) && is_zero (high (box_preload (box r)))) (rows s).

Definition segment_by_degree_fails (s : setting) (alpha : Q) (beta : option Q) (d1 d2 : list Q)
    (walls direction : list (list Q)) (tree : list node) : option (string * option nat) :=
  let alpha := match beta with None => if is_zero alpha then 1%Q else alpha | Some _ => alpha end in
  degree_fails advisor two_sided most_depth s (DegreeProof alpha beta d1 d2 false walls direction) tree.

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

Variable advisor : oracle.
Variable two_sided : bool.
Variable most_depth : Z.
Variable sys : Rows.system.
Hypothesis law : Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral).

(* A part that is not cut makes every system in its box stable. *)
Theorem part_stable alpha beta s p lambda : part_fails advisor two_sided most_depth alpha beta s p = None ->
  in_setting s sys -> Q2R alpha <= lambda <= Q2R beta -> Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros H I L. destruct p as [name i c|d0 open simplex walls direction tree|forces answers reach|d0 friction presses answers reach energy]; cbn in H;
    [discriminate| | |].
  - eapply (stable_with_open_contacts advisor); [exact I|exact H|exact law| |]; cbn; apply L.
  - destruct (rest_fails _ _ _ _) eqn:E; [discriminate|]. eapply stable_at_rest; eassumption.
  - destruct (sticking_fails _ _ _ _ _) eqn:E; [discriminate|]. eapply stable_by_sticking; eassumption.
Qed.

(* Without load and preload but what grows, solutions can be multiplied, if motions are not bounded. *)
Lemma unloaded_stable s lambda : in_setting s sys -> unloaded s = true -> 0 <= lambda -> the_bound s = None ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys 1 ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros I U L -> (d & fs & _ & Ld & O & B). unfold unloaded in U. rewrite !andb_true_iff in U. destruct U as [[Uo Uw] Up].
  destruct (its_box _ _ I) as (Fr & Fw & _). apply (one_load_is _ _ Uo) in Fw.
  assert (W : forall y, Rows.dot (Rows.wrench sys) y = 0).
  { rewrite Fw. clear - Uw. induction (map low _) as [|q w IH]; intros [|t y]; cbn in *; try reflexivity.
    apply andb_true_iff in Uw as [U Uw]. apply is_zero_real in U. unfold real in IH. rewrite U, IH by exact Uw. ring. }
  assert (P : Forall (fun r => Rows.preload r = 0) (Rows.rows sys)).
  { clear - Fr Up. revert Up. induction Fr as [|row r rows rs [_ Se] Fr IH]; intros Up; constructor;
      cbn in Up; rewrite !andb_true_iff in Up; destruct Up as [[U1 U2] Up]; [|now apply IH].
    destruct (seen_stands _ _ Se) as (r' & k & p & F & mu & t & I & St & _). apply is_zero_real in U1, U2.
    rewrite <- (Leaf.same_preload _ _ _ St), (in_preload _ _ _ _ _ _ I), U1, U2. ring. }
  pose proof (its_proper _ _ I) as Pr.
  exists (Rows.scaled lambda d), (map (fun f => (lambda * fst f, Rows.scaled lambda (snd f))) fs).
  split; [exact Logic.I|]. split; [unfold Rows.scaled; now rewrite map_length|]. split.
  - clear - O P Pr L. revert P Pr. induction O as [|r f rs fs Of O IH]; intros P Pr; cbn; constructor;
      [|exact (IH (Forall_inv_tail P) (Forall_inv_tail Pr))].
    pose proof (obeys_multiple (Rows.normal sys) d 1 1 r f lambda L
      (RowLimits.weights_positive _ _ (Forall_inv Pr)) Of) as M.
    unfold Rows.obeys in *. cbn [fst snd] in *.
    assert (E : Rows.v r (Rows.scaled lambda d) (lambda * 1) (lambda * 1) = Rows.v r (Rows.scaled lambda d) 1
      lambda).
    { unfold Rows.v. rewrite (Forall_inv P). ring. }
    now rewrite <- E.
  - intros y. rewrite works_multiple. specialize (B y). unfold Rows.load in *. rewrite W in *.
    transitivity (lambda * (1 * 0 + 1 * Rows.dot (Rows.direction sys) y + Rows.works (Rows.rows sys) fs y));
      [ring|].
    rewrite B. ring.
Qed.

(* What goes on without end has no bound. *)
Lemma without_end s g tree : degree_fails advisor two_sided most_depth s g tree = None -> high_multiple g = None ->
  the_bound s = None.
Proof.
  unfold degree_fails. intros H E. destruct (free_motions _ _ _) as [free|]; [|discriminate].
  destruct (negb _); [discriminate|]. destruct (inverted _ _ _); [|discriminate].
  unfold bound_holds in H. rewrite E in H. destruct (the_bound s); [discriminate|reflexivity].
Qed.

(* A segment by degree proves what it spans. *)
Theorem segment_by_degree_resists s alpha beta d1 d2 walls direction tree lambda :
  segment_by_degree_fails advisor two_sided most_depth s alpha beta d1 d2 walls direction tree = None ->
  in_setting s sys -> match beta with Some _ => True | None => Q2R alpha <> 0 \/ unloaded s = true end ->
  Q2R alpha <= lambda -> match beta with Some b => lambda <= Q2R b | None => True end ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  unfold segment_by_degree_fails. intros H I Z L B. destruct beta as [b|].
  - eapply (stable_by_degree_in_box advisor); [exact I|exact H|exact law|exact L|exact B].
  - destruct (is_zero alpha) eqn:A.
    + apply is_zero_real in A. destruct Z as [Z|Z]; [contradiction|].
      apply (unloaded_stable s lambda I Z); [lra|now apply (without_end s _ _ H)|].
      eapply (stable_by_degree_in_box advisor); [exact I|exact H|exact law| |exact Logic.I].
      cbn. rewrite Q2R_1. lra.
    + eapply (stable_by_degree_in_box advisor); [exact I|exact H|exact law|exact L|exact Logic.I].
Qed.

(* Of boxes that are cut, one half or the other has the system. *)
Theorem parts_stable parts todo number : parts_fail advisor two_sided most_depth parts todo number = None ->
  Forall (fun sd => in_setting (fst sd) sys ->
    Rows.stable_at (Rows.bounded (real_bound (the_bound (fst sd))) 1) sys 0) todo.
Proof.
  revert todo number. induction parts as [|p parts IH]; intros [|[s depth] todo] number H; cbn [parts_fail] in H;
    try discriminate; [constructor|].
  destruct (Z.ltb most_depth depth); [discriminate|].
  assert (Q0 : Q2R 0 <= 0 <= Q2R 0) by (rewrite Q2R_0; lra).
  assert (Whole : match part_fails advisor two_sided most_depth 0 0 s p with
      | Some (rule, node) => Some (rule, AtPart number node)
      | None => parts_fail advisor two_sided most_depth parts todo (S number)
      end = None -> Forall (fun sd => in_setting (fst sd) sys ->
        Rows.stable_at (Rows.bounded (real_bound (the_bound (fst sd))) 1) sys 0) ((s, depth) :: todo)).
  { destruct (part_fails _ _ _ _ _ s p) as [[rule node]|] eqn:E; [discriminate|]. intros H'.
    constructor; [|now apply (IH todo (S number))]. cbn. intros I. exact (part_stable 0 0 s p 0 E I Q0). }
  destruct p as [name i c|d0 open simplex walls direction tree|forces answers reach|]; try (now apply Whole).
  clear Whole. destruct (halves s name i c) as [[lo hi]|] eqn:E; [|discriminate].
  pose proof (IH _ _ H) as A. pose proof (Forall_inv A) as A1. pose proof (Forall_inv (Forall_inv_tail A)) as A2.
  constructor; [|exact (Forall_inv_tail (Forall_inv_tail A))]. cbn in *. intros [Bx Di Pr Le Sl Pu Bd].
  destruct (halves_contain s name i c lo hi sys E Bx) as [Same C].
  destruct (Same lo (or_introl eq_refl)) as (D1 & S1 & P1 & B1), (Same hi (or_intror eq_refl)) as (D2 & S2 & P2 & B2).
  rewrite B1 in A1. rewrite B2 in A2. destruct C as [C|C]; [apply A1|apply A2]; constructor; congruence.
Qed.

End Proofs.
