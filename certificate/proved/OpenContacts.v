(* SPDX-License-Identifier: MIT *)
(* Stable by degree (FORMAT.md section 6), where contacts are open on all of K, and the proof is about the grasp without
   them: the rule degree-open.  `stable_with_open_contacts`: where the rules hold, every system in the box is stable at
   every multiple. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Walk Tree.
From Proved Require Import Brouwer RowLimits Degree Matrix Frame Between Load Bound ByDegree.
From Proved Require Rows Model.
Import ListNotations.

Section Rules.
Open Scope Z_scope.

Definition is_open (open : list Z) (number : nat) : bool := existsb (Z.eqb (Z.of_nat number)) open.

(* Those of a list that are not open, from the number of its first one on. *)
Fixpoint others {A : Type} (open : list Z) (number : nat) (them : list A) : list A :=
  match them with
  | [] => []
  | it :: rest => if is_open open number then others open (S number) rest else it :: others open (S number) rest
  end.

(* The grasp without what is open. *)
Definition without_open (open : list Z) (s : setting) : setting :=
  make_setting (dimension_of s) (others open 0 (rows s)) (the_load s) (pushes s) (the_bound s).

(* The number of a row among the others; of one that is open a number that there is not. *)
Fixpoint places_before (open : list Z) (i : Z) : Z :=
  match open with
  | [] => 0
  | k :: rest => if k <? i then 1 + places_before rest i else 0
  end.

Definition number_of (count : Z) (open : list Z) (i : Z) : Z :=
  if existsb (Z.eqb i) open then count else i - places_before open i.

Definition renumbered (count : Z) (open : list Z) (it : node) : node :=
  match it with
  | Slip i => Slip (number_of count open i)
  | Separation i => Separation (number_of count open i)
  | Cut PWrench _ _ => it
  | Cut name i c => Cut name (number_of count open i) c
  | Moving y c brakes => Moving y c (map (fun b => (number_of count open (fst b), snd b)) brakes)
  | _ => it
  end.

(* The numbers increase, and are of rows. *)
Fixpoint numbers_of (count last : Z) (open : list Z) : bool :=
  match open with
  | [] => true
  | i :: rest => (last <? i) && (i <? count) && numbers_of count i rest
  end.

Fixpoint open_on (rays : list ray) (open : list Z) (number : nat) (them : list row) : bool :=
  match them with
  | [] => true
  | it :: rest =>
      (negb (is_open open number) ||
       negb (box_spring (box it)) && forallb (nowhere_positive rays) (pull_tips it)) &&
      open_on rays open (S number) rest
  end.

Variable advisor : oracle.

(* z.e = 0 for all free motions. *)
Definition across (g : degree_proof) (free : matrix) : list (form * bool) :=
  map (fun z => (to_form (relative g z), true)) free.

(* degree-open *)
Definition open_holds (two_sided : bool) (open : list Z) (s : setting) (g : degree_proof) : bool :=
  match free_motions (dimension_of s) (is_a_simplex g) (wall_rows g) with
  | Some free =>
      negb two_sided && numbers_of (Z.of_nat (List.length (rows s))) (-1) open &&
      open_on (rays setting (k_region advisor g s (across g free))) open 0 (rows s)
  | None => true                                                                 (* degree-walls says so *)
  end.

Definition degree_with_open_fails (two_sided : bool) (most_depth : Z) (open : list Z) (s : setting) (g : degree_proof)
    (nodes : list node) : option (string * option nat) :=
  match open with
  | [] => degree_fails advisor two_sided most_depth s g nodes
  | _ =>
      let less := without_open open s in
      let count := Z.of_nat (List.length (rows less)) in
      if open_holds two_sided open s g
      then degree_fails advisor two_sided (most_depth - 2 * Z.of_nat (List.length open)) less g
             (map (renumbered count open) nodes)
      else Some ("degree-open"%string, None)
  end.

End Rules.

Section Proofs.
Open Scope R_scope.

Lemma others_of_both {A B} (P : A -> B -> Prop) open number l l' : Forall2 P l l' ->
  Forall2 P (others open number l) (others open number l').
Proof.
  intros F. revert number. induction F as [|a b l l' H F IH]; intros number; cbn; [constructor|].
  destruct (is_open open number); [apply IH|constructor; [exact H|apply IH]].
Qed.

Lemma others_of_all {A} (P : A -> Prop) open number l : Forall P l -> Forall P (others open number l).
Proof.
  intros F. revert number. induction F as [|a l H F IH]; intros number; cbn; [constructor|].
  destruct (is_open open number); [apply IH|constructor; [exact H|apply IH]].
Qed.

Lemma product_nil ws t : Rows.product ws [] t = 0.
Proof. destruct ws; reflexivity. Qed.

Section Added.
Variable rs : list ray.
Variable ws : list (R * form).
Variable d : list R.
Variable h l : R.
Hypothesis W : weights (map coordinates rs) ws.
Hypothesis spanned : forall a, rdot a (h :: l :: d) = Cone.total a ws.

(* What is open is without a force, *)
Lemma open_obeys row r : suits row r -> box_spring (box row) = false ->
  forallb (nowhere_positive rs) (pull_tips row) = true -> Rows.obeys Model.unilateral d h l r (0, []).
Proof.
  intros [E Se] Sp H. destruct (seen_stands _ _ Se) as (r' & k & p & G & mu & t & I & St & _).
  assert (V : Rows.v r d h l <= 0).
  { rewrite E in H. rewrite <- (same_pull _ _ _ d h l St). exact (v_nonpos _ d h l ws W spanned (box row) r' p G mu t I H). }
  cbn. rewrite !product_nil. unfold Rows.size at 1. rewrite product_nil, sqrt_0. repeat split; [|lra|ring].
  unfold Rows.normal_law. rewrite <- (Leaf.same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I), Sp. cbn.
  rewrite Rmax_left; lra.
Qed.

(* and may be there beside forces of the others. *)
Lemma forces_with_open open number rows xs fs : Forall2 suits rows xs -> open_on rs open number rows = true ->
  Forall2 (Rows.obeys Model.unilateral d h l) (others open number xs) fs ->
  exists fs', Forall2 (Rows.obeys Model.unilateral d h l) xs fs' /\
    forall y, Rows.works xs fs' y = Rows.works (others open number xs) fs y.
Proof.
  intros F. revert number fs. induction F as [|row r rows xs Fr F IH]; intros number fs H O; cbn in *.
  - inversion O; subst. exists []. split; [constructor|reflexivity].
  - apply andb_true_iff in H as [H1 H]. destruct (is_open open number).
    + cbn in H1. apply andb_true_iff in H1 as [Sp H1]. apply negb_true_iff in Sp.
      destruct (IH _ _ H O) as (fs' & O' & B). exists ((0, []) :: fs').
      split; [constructor; [now apply (open_obeys row)|exact O']|].
      intros y. cbn. rewrite B. unfold Rows.work. cbn. rewrite product_nil. ring.
    + inversion O as [|? f ? fs0 Of Os]; subst. destruct (IH _ _ H Os) as (fs' & O' & B). exists (f :: fs').
      split; [constructor; assumption|]. intros y. cbn. now rewrite B.
Qed.

End Added.

Lemma what_does_not_fail advisor two_sided most open s g nodes :
  degree_with_open_fails advisor two_sided most open s g nodes = None ->
  degree_fails advisor two_sided most s g nodes = None \/
  open_holds advisor two_sided open s g = true /\
  exists most' nodes', degree_fails advisor two_sided most' (without_open open s) g nodes' = None.
Proof.
  unfold degree_with_open_fails. destruct open as [|i open']; [now left|]. intros H. right.
  destruct (open_holds _ _ _ _ _); [|discriminate]. split; [reflexivity|]. eauto.
Qed.

Variable advisor : oracle.
Variable two_sided : bool.
Variable most : Z.
Variable open : list Z.
Variable s : setting.
Variable g : degree_proof.
Variable nodes : list node.
Variable sys : Rows.system.
Hypothesis fit : in_setting s sys.
Let D := dimension_of s.

Let less := Rows.System (Rows.dimension sys) (others open 0 (Rows.rows sys)) (Rows.wrench sys) (Rows.direction sys)
  (Rows.normal sys).

Lemma fits_without_open : in_setting (without_open open s) less.
Proof.
  destruct fit as [(Fr & Fw & Fg) Fd Fp Fl Fs Fn Fb]. constructor; try assumption.
  - split; [now apply others_of_both|]. now split.
  - now apply others_of_all.
  - reflexivity.
Qed.

Theorem stable_with_open_contacts lambda :
  degree_with_open_fails advisor two_sided most open s g nodes = None ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  Q2R (low_multiple g) <= lambda -> match high_multiple g with Some b => lambda <= Q2R b | None => True end ->
  Rows.stable_at (Rows.bounded (real_bound (the_bound s)) 1) sys lambda.
Proof.
  intros H Law Lo Hi. apply what_does_not_fail in H as [H|(OH & most' & nodes' & H)].
  { exact (stable_by_degree_in_box advisor g s nodes most sys fit two_sided lambda H Law Lo Hi). }
  destruct (equilibrium_by_degree advisor g (without_open open s) nodes' most' less fits_without_open two_sided lambda H Law Lo Hi)
    as (free & t & e & fs & Eq).
  cbv zeta in Eq. cbn [dimension_of without_open make_setting] in Eq. fold D in Eq.
  unfold open_holds in OH. fold D in OH. destruct Eq as (FM & (Range & L1 & L2) & (T & H1 & E1) & K & Zf & (Ld & O & Bal) & Bd). rewrite FM, !andb_true_iff in OH. destruct OH as [[TS _] OH]. apply negb_true_iff in TS.
  set (d := listed D (fun i => nth i (twist_at g t) 0 + e i)) in *.
  destruct (free_lengths _ _ _ _ FM) as [FL EL].
  assert (Home : at_home setting (fun _ _ => True) (k_region advisor g s (across g free)) (h_at g t :: l_at g t :: d)).
  { apply (k_home g D L1 L2 Range); [exact T|reflexivity|now apply walls_real_length|exact Logic.I| |exact K].
    unfold across. apply Forall_map. rewrite Forall_forall in *. intros z Hz. unfold meets; cbn [fst snd].
    apply to_form_zero. unfold d. rewrite relative_at by auto. exact (Zf z Hz). }
  destruct (home_spanned _ _ _ _ (root_good _ _ _ _) Home) as (ws & Wt & Sp).
  destruct (its_box _ _ fit) as (Fr & _). unfold less in O. cbn [Rows.rows Rows.normal] in O.
  rewrite Law, TS in O.
  destruct (forces_with_open _ ws d (h_at g t) (l_at g t) Wt Sp open 0 (rows s) (Rows.rows sys) fs Fr OH O) as (fs' & O' & B).
  replace lambda with (l_at g t / h_at g t) by (rewrite E1; field; lra).
  apply (stable_by_multiple _ sys d (h_at g t) (l_at g t) fs' H1).
  - eapply Forall_impl; [|exact (its_proper _ _ fit)]. intros r P. apply (RowLimits.weights_positive _ _ P).
  - split; [exact Ld|]. split; [now rewrite Law, TS|]. intros y. rewrite B. exact (Bal y).
  - exact Bd.
Qed.

End Proofs.
