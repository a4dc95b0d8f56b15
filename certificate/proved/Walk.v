(* SPDX-License-Identifier: MIT *)
(* Trees (FORMAT.md section 4): regions, and the walk over a list of nodes.  What a node's children are and when a
   leaf holds are arguments here, given by Tree.v; so is which points are solutions.  `walk_refutes`: if a
   list of nodes is accepted for some roots, no solution is at home in any of them, unless a leaf holds it. *)
From Coq Require Import List String ZArith QArith Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Cutting Box Terms.
Import ListNotations.

Section Walk.
Variable advisor : oracle.
Variable setting : Type.     (* the box that a tree is about *)

(* Points have [size] numbers; those with values of 0 or more of all [sides] are those that the rays span. *)
Record region := Region {
  size : nat;
  sides : list form;
  rays : list ray;
  strict : list (list form);      (* those that rays keep account of: conditions of the region *)
  moving : list (list form);      (* slips in space, which are not *)
  around : setting;
  depth : Z
}.

(* What a child has more than its parent: conditions f >= 0, or f = 0 if the flag is set; strict
   functions of one value among these; slips that are strict; and its box. *)
Record branch := Branch {
  conditions : list (form * bool);
  new_strict : list form;
  new_moving : list (list form);
  branch_setting : setting
}.

(* A condition that holds on all rays changes nothing. *)
Definition cut_above (r : region) (f : form) : region :=
  let hs := heights f (rays r) in
  if forallb (fun h => Z.leb 0 (fst h)) hs || negb (permits advisor (most_combinations hs)) then r
  else
    match cut (List.length (sides r)) hs with
    | Some them => Region (size r) (sides r ++ [f]) them (strict r) (moving r) (around r) (depth r)
    | None => r
    end.

Definition cut_region (r : region) (c : form * bool) : region :=
  let r' := cut_above r (fst c) in
  if snd c then cut_above r' (negative (fst c)) else r'.

Definition strictly (r : region) (f : form) : region :=
  Region (size r) (sides r) (map (add_strict [f]) (rays r)) ([f] :: strict r) (moving r) (around r) (depth r).

(* As long as there is advice, and not more often than there are conditions. *)
Fixpoint cut_foremost (times : list (form * bool)) (r : region) (cs : list (form * bool)) : region :=
  match times with
  | [] => r
  | _ :: times' =>
      match foremost advisor (map coordinates (rays r)) cs with
      | Some k => match numbered cs k with
                  | Some c => cut_foremost times' (cut_region r c) cs
                  | None => r
                  end
      | None => r
      end
  end.

Definition cut_by (r : region) (cs : list (form * bool)) : region :=
  fold_left cut_region cs (cut_foremost cs r cs).

Definition child (r : region) (b : branch) : region :=
  let r := fold_left strictly (new_strict b) (cut_by r (conditions b)) in
  Region (size r) (sides r) (rays r) (strict r) (new_moving b ++ moving r) (branch_setting b) (depth r + 1).

(* The children's branches, or the rule that fails. *)
Variable split : setting -> node -> list branch + string.
(* The rule that fails, at a leaf with these strict functions and rays. *)
Variable leaf_fails : setting -> list (list form) -> list ray -> node -> option string.

Definition is_leaf (n : node) : bool := match n with Leaf _ | Moving _ _ _ | Held _ => true | _ => false end.

Definition at_leaf (r : region) : list (list form) * list ray :=
  fold_left (fun sr fs => (fs :: fst sr, map (add_strict fs) (snd sr))) (moving r)
    (strict r, rays r).

Definition visit (most_depth : Z) (n : node) (r : region) : list region + string :=
  if Z.ltb most_depth (depth r) then inr "node-depth"%string
  else
    if is_leaf n then
      let (strict', rays') := at_leaf r in
      match leaf_fails (around r) strict' rays' n with
      | None => inl []
      | Some rule => inr rule
      end
    else
      match split (around r) n with
      | inl bs => inl (map (child r) bs)
      | inr rule => inr rule
      end.

(* The regions that nodes still have to be about, the next one first. *)
Fixpoint walk (most_depth : Z) (nodes : list node) (todo : list region) (number : nat)
    : option (string * nat) :=
  match nodes, todo with
  | [], [] => None
  | [], _ :: _ => Some ("tree-short"%string, number)
  | _ :: _, [] => Some ("tree-long"%string, number)
  | n :: nodes', r :: todo' =>
      match visit most_depth n r with
      | inl children => walk most_depth nodes' (children ++ todo') (S number)
      | inr rule => Some (rule, number)
      end
  end.

Section Roots.
Open Scope Z_scope.

Fixpoint basis (before n : nat) : list form :=
  match n with
  | O => []
  | S n' => (repeat 0 before ++ 1 :: repeat 0 n') :: basis (S before) n'
  end.

(* All of R^n: each line is two rays. *)
Definition everywhere (n : nat) (s : setting) : region :=
  Region n [] (flat_map (fun e => [Ray e [] 0; Ray (map Z.opp e) [] 0]) (basis 0 n)) [] [] s (-1).

(* With one branch after another; its depth is then 0. *)
Definition root (n : nat) (b : branch) : region := child (everywhere n (branch_setting b)) b.

End Roots.

(* ---- Proofs ---- *)

Open Scope R_scope.

(* Which points are solutions of a choice in a box; and what leaves show of these, False where they only refute. *)
Variable solves : setting -> list R -> Prop.
Variable shown : list R -> Prop.

Definition meets (x : list R) (c : form * bool) :=
  if snd c then rdot (fst c) x = 0 else 0 <= rdot (fst c) x.

Definition not_zero (x : list R) (fs : list form) := Exists (fun f => rdot f x <> 0) fs.

Record takes (b : branch) (x : list R) : Prop := Takes {
  takes_solves : solves (branch_setting b) x;
  takes_conditions : Forall (meets x) (conditions b);
  takes_strict : Forall (fun f => rdot f x <> 0) (new_strict b);
  takes_moving : Forall (not_zero x) (new_moving b)
}.

(* f > 0; and the two sides of a form. *)
Lemma takes_above s f x : solves s x -> 0 < rdot f x -> takes (Branch [(f, false)] [f] [] s) x.
Proof.
  intros S P. constructor; cbn; [exact S| | |constructor]; constructor; try constructor;
    unfold meets; cbn; lra.
Qed.

Lemma takes_side s f x : solves s x -> exists b,
  In b [Branch [(f, false)] [] [] s; Branch [(negative f, false)] [negative f] [] s] /\ takes b x.
Proof.
  intros S. destruct (Rle_dec 0 (rdot f x)) as [P|P]; eexists.
  - split; [now left|]. constructor; cbn; [exact S| |constructor|constructor].
    constructor; [exact P|constructor].
  - split; [right; now left|]. apply takes_above; [exact S|]. rewrite rdot_negative. lra.
Qed.

Hypothesis split_covers : forall s n bs x, is_leaf n = false ->
  split s n = inl bs -> solves s x -> exists b, In b bs /\ takes b x.

Hypothesis leaf_refutes : forall s strict' rays' n x, is_leaf n = true ->
  leaf_fails s strict' rays' n = None -> Forall (knows strict') rays' ->
  spans (map coordinates rays') (fun a => rdot a x) -> Forall (not_zero x) strict' ->
  solves s x -> shown x.

Record at_home (r : region) (x : list R) : Prop := AtHome {
  home_solves : solves (around r) x;
  home_size : (List.length x <= size r)%nat;
  home_inside : Forall (fun f => 0 <= rdot f x) (sides r);
  home_strict : Forall (not_zero x) (strict r);
  home_moving : Forall (not_zero x) (moving r)
}.

Record good (r : region) : Prop := Good {
  all_know : Forall (knows (strict r)) (rays r);
  is_described : described (size r) (sides r) (rays r)
}.

Lemma home_spanned r x : good r -> at_home r x -> spans (map coordinates (rays r)) (fun a => rdot a x).
Proof.
  intros [_ D] [_ L I _ _]. rewrite Forall_forall in I. now apply (all_spanned _ _ _ D).
Qed.

Definition refuted (r : region) := forall x, at_home r x -> shown x.

Lemma cut_above_good r f : good r -> good (cut_above r f).
Proof.
  intros G. unfold cut_above. destruct (_ || _); [exact G|].
  destruct (cut _ _) as [them|] eqn:E; [|exact G]. destruct G as [K D]. constructor; cbn.
  - exact (cut_knows _ _ _ _ _ K E).
  - exact (cut_described _ _ _ _ _ D E).
Qed.

Lemma cut_above_home r f x : at_home r x -> 0 <= rdot f x -> at_home (cut_above r f) x.
Proof.
  intros [S L I T M] P. unfold cut_above. destruct (_ || _); [now constructor|].
  destruct (cut _ _); [|now constructor]. constructor; cbn; try assumption.
  apply Forall_app. split; [exact I|]. now constructor.
Qed.

Lemma cut_good r c : good r -> good (cut_region r c).
Proof. intros G. unfold cut_region. destruct (snd c); now repeat apply cut_above_good. Qed.

Lemma cut_home r c x : at_home r x -> meets x c -> at_home (cut_region r c) x.
Proof.
  intros Home H. unfold cut_region, meets in *. destruct (snd c); [|now apply cut_above_home].
  apply cut_above_home; [apply cut_above_home; [exact Home|lra]|]. rewrite rdot_negative. lra.
Qed.

Lemma foremost_good times cs : forall r, good r -> good (cut_foremost times r cs).
Proof.
  induction times as [|t times IH]; intros r G; cbn; [exact G|].
  destruct (foremost _ _ _) as [k|]; [|exact G]. destruct (numbered cs k) as [c|]; [|exact G]. now apply IH, cut_good.
Qed.

Lemma foremost_home times cs x : Forall (meets x) cs -> forall r, at_home r x -> at_home (cut_foremost times r cs) x.
Proof.
  intros M. rewrite Forall_forall in M. induction times as [|t times IH]; intros r H; cbn; [exact H|].
  destruct (foremost _ _ _) as [k|]; [|exact H]. destruct (numbered cs k) as [c|] eqn:N; [|exact H].
  apply IH, cut_home; [exact H|]. apply numbered_is in N as (j & _ & N). apply M. eapply nth_error_In; exact N.
Qed.

Lemma add_strict_all fs strict' rays' :
  Forall (knows strict') rays' -> Forall (knows (fs :: strict')) (map (add_strict fs) rays').
Proof.
  intros H. apply Forall_map. eapply Forall_impl; [|exact H]. intros a. apply add_strict_knows.
Qed.

Lemma strictly_good r f : good r -> good (strictly r f).
Proof.
  intros [K [A S]]. constructor; cbn; [now apply add_strict_all|]. constructor.
  - apply Forall_map. eapply Forall_impl; [|exact A]. intros q [L I M]. now constructor.
  - rewrite map_map. exact S.
Qed.

Lemma child_good r b : good r -> good (child r b).
Proof.
  intros G. unfold child. set (r1 := cut_by r (conditions b)).
  assert (G1 : good r1).
  { assert (All : forall cs r, good r -> good (fold_left cut_region cs r)).
    { induction cs as [|c cs IH]; intros r' G'; cbn; auto. apply IH. now apply cut_good. }
    unfold r1, cut_by. now apply All, foremost_good. }
  assert (G2 : good (fold_left strictly (new_strict b) r1)).
  { clearbody r1. clear r G. revert r1 G1. induction (new_strict b) as [|f fs IH]; intros r G; cbn; auto.
    apply IH. now apply strictly_good. }
  destruct G2. now constructor.
Qed.

Lemma strictly_home r f x : at_home r x -> rdot f x <> 0 -> at_home (strictly r f) x.
Proof.
  intros [S L P T M] H. constructor; cbn; try assumption. constructor; [|exact T]. now constructor.
Qed.

Lemma child_home r b x : at_home r x -> takes b x -> at_home (child r b) x.
Proof.
  intros H [S C T M]. unfold child.
  assert (H1 : at_home (cut_by r (conditions b)) x).
  { assert (All : forall cs, Forall (meets x) cs -> forall r, at_home r x -> at_home (fold_left cut_region cs r) x).
    { intros cs Cs. induction Cs as [|c cs Hc Cs IH]; intros r' H'; cbn; [exact H'|].
      apply IH. now apply cut_home. }
    unfold cut_by. apply All; [exact C|]. now apply foremost_home. }
  set (r1 := cut_by r (conditions b)) in *. clearbody r1.
  assert (H2 : at_home (fold_left strictly (new_strict b) r1) x).
  { clear H C M. revert r1 H1. induction T as [|f fs Hf T IH]; intros r1 H1; cbn; [exact H1|].
    apply IH. now apply strictly_home. }
  destruct H2 as [_ L P T' M']. constructor; cbn; try assumption. now apply Forall_app.
Qed.

Lemma at_leaf_good r x strict' rays' : good r -> at_home r x -> at_leaf r = (strict', rays') ->
  Forall (knows strict') rays' /\ spans (map coordinates rays') (fun a => rdot a x) /\
  Forall (not_zero x) strict'.
Proof.
  intros G H E. pose proof (home_spanned r x G H) as P. destruct H as [_ _ _ T M]. destruct G as [G _]. unfold at_leaf in E.
  assert (A : forall ms st rs, Forall (not_zero x) ms -> Forall (knows st) rs ->
    spans (map coordinates rs) (fun a => rdot a x) -> Forall (not_zero x) st ->
    forall st' rs', fold_left (fun sr fs => (fs :: fst sr, map (add_strict fs) (snd sr))) ms (st, rs)
      = (st', rs') ->
    Forall (knows st') rs' /\ spans (map coordinates rs') (fun a => rdot a x) /\
    Forall (not_zero x) st').
  { induction ms as [|m ms IH]; intros st rs HM K Sp S st' rs' F; cbn in F.
    - injection F as <- <-. auto.
    - inversion HM; subst. eapply IH; [assumption| | | |exact F].
      + now apply add_strict_all.
      + rewrite map_map. cbn. exact Sp.
      + now constructor. }
  eapply A; eassumption.
Qed.

Lemma visit_good most n r children : good r -> visit most n r = inl children ->
  Forall good children.
Proof.
  intros G H. unfold visit in H. destruct (Z.ltb most (depth r)); [discriminate|].
  assert (C : forall bs, Forall good (map (child r) bs)).
  { intros bs. apply Forall_map, Forall_forall. intros b _. now apply child_good. }
  destruct (is_leaf n); [|destruct (split (around r) _) as [bs|]; [|discriminate]; injection H as <-; apply C].
  destruct (at_leaf r). destruct (leaf_fails _ _ _ _); [discriminate|]. injection H as <-. constructor.
Qed.

Lemma visit_refutes most n r children : good r -> visit most n r = inl children ->
  Forall refuted children -> refuted r.
Proof.
  intros G H RF x Home. unfold visit in H. destruct (Z.ltb most (depth r)); [discriminate|].
  rewrite Forall_forall in RF.
  destruct (is_leaf n) eqn:NL.
  2:{ destruct (split (around r) n) as [bs|] eqn:E; [|discriminate]. injection H as <-.
      destruct (split_covers _ _ _ x NL E (home_solves _ _ Home)) as (b & Hb & T).
      apply (RF (child r b) (in_map _ _ _ Hb) x). now apply child_home. }
  destruct (at_leaf r) as [strict' rays'] eqn:AL.
  destruct (leaf_fails _ _ _ _) eqn:L; [discriminate|].
  destruct (at_leaf_good r x _ _ G Home AL) as (K & Sp & T).
  eapply leaf_refutes; try eassumption. apply Home.
Qed.

Theorem walk_refutes most nodes todo number : Forall good todo ->
  walk most nodes todo number = None -> Forall refuted todo.
Proof.
  revert todo number. induction nodes as [|n nodes IH]; intros [|r todo] number G H; cbn in H;
    try discriminate; [constructor|].
  destruct (visit most n r) as [children|rule] eqn:V; [|discriminate].
  inversion G as [|? ? Gr Gt]; subst.
  assert (A : Forall refuted (children ++ todo)).
  { eapply IH; [|exact H]. apply Forall_app. split; [eapply visit_good; eassumption|exact Gt]. }
  apply Forall_app in A as [A B]. constructor; [|exact B].
  eapply visit_refutes; eassumption.
Qed.

Lemma dot_opp a e : (dot a (map Z.opp e) = - dot a e)%Z.
Proof. revert e. induction a as [|z a IH]; intros [|y e]; cbn; try lia. rewrite IH. lia. Qed.

Lemma line_spans rs t (e : form) : In e rs -> In (map Z.opp e) rs ->
  spans rs (fun a => t * IZR (dot a e)).
Proof.
  intros P N. destruct (Rle_dec 0 t) as [H|H].
  - apply spans_multiple; [exact H|]. now apply spans_ray.
  - apply spans_same with (fun a => - t * IZR (dot a (map Z.opp e))).
    + intros a. rewrite dot_opp, opp_IZR. ring.
    + apply spans_multiple; [lra|]. now apply spans_ray.
Qed.

Lemma dot_basis a k n : dot a (repeat 0 k ++ 1 :: repeat 0 n)%Z = nth k a 0%Z.
Proof.
  assert (Z0 : forall a n, dot a (repeat 0 n)%Z = 0%Z).
  { induction a0 as [|z a0 IH]; intros [|n0]; cbn; try reflexivity. rewrite IH. lia. }
  revert k. induction a as [|z a IH]; intros [|k]; cbn; try reflexivity.
  - rewrite Z0. lia.
  - rewrite IH. lia.
Qed.

Lemma basis_spans rs x k :
  (forall e, In e (basis k (List.length x)) -> In e rs /\ In (map Z.opp e) rs) ->
  spans rs (fun a => rdot (skipn k a) x).
Proof.
  revert k. induction x as [|t x IH]; intros k H.
  - eapply spans_same; [|apply spans_zero]. intros a. cbn. now destruct (skipn k a).
  - cbn [List.length basis] in H.
    apply spans_same with (fun a => t * IZR (dot a (repeat 0 k ++ 1 :: repeat 0 (List.length x))%Z)
                                    + rdot (skipn (S k) a) x).
    + intros a. rewrite dot_basis. clear. revert k. induction a as [|z a IH]; intros k.
      * cbn. destruct k; cbn; ring.
      * destruct k as [|k]; [cbn; ring|]. exact (IH k).
    + apply spans_sum.
      * apply line_spans; apply (H _ (or_introl eq_refl)).
      * apply IH. intros e He. apply H. now right.
Qed.

Lemma padded a x k : rdot a (x ++ repeat 0 k) = rdot a x.
Proof.
  revert a. induction x as [|t x IH]; intros a.
  - cbn [app]. replace (rdot a []) with 0 by now destruct a. revert a.
    induction k as [|k IHk]; intros [|c a]; cbn; try reflexivity. rewrite IHk. ring.
  - destruct a as [|c a]; cbn; [reflexivity|]. now rewrite IH.
Qed.

Lemma basis_length before n e : In e (basis before n) -> List.length e = (before + n)%nat.
Proof.
  revert before. induction n as [|n IH]; intros before; cbn; [intros []|]. intros [<-|H].
  - rewrite app_length. cbn. rewrite !repeat_length. lia.
  - apply IH in H. lia.
Qed.

Lemma everywhere_good n s : good (everywhere n s).
Proof.
  assert (In_rays : forall r, In r (rays (everywhere n s)) -> exists e, In e (basis 0 n) /\
    (r = Ray e [] 0%Z \/ r = Ray (map Z.opp e) [] 0%Z)).
  { intros r Hr. cbn in Hr. apply in_flat_map in Hr as (e & He & [<-|[<-|[]]]); eauto. }
  constructor; cbn [strict size sides]; [|constructor].
  - apply Forall_forall. intros r Hr. destruct (In_rays r Hr) as (e & _ & [-> | ->]); constructor.
  - apply Forall_forall. intros r Hr. destruct (In_rays r Hr) as (e & He & E). apply basis_length in He.
    constructor; [destruct E as [-> | ->]; cbn [coordinates size everywhere]; rewrite ?map_length; lia|intros f []|].
    intros i. destruct E as [-> | ->]; cbn [tight]; rewrite Z.bits_0; now destruct i.
  - intros x L _. cbn [size everywhere] in L. apply spans_same with (fun a => rdot a (x ++ repeat 0 (n - List.length x))).
    { intros a. apply padded. }
    set (y := x ++ _). assert (Ly : List.length y = n) by (unfold y; rewrite app_length, repeat_length; lia).
    cbn [rays everywhere]. rewrite <- Ly. apply (basis_spans _ y 0). intros e He.
    split; apply in_map_iff.
    + exists (Ray e [] 0%Z). split; [reflexivity|]. apply in_flat_map. exists e. split; [exact He|now left].
    + exists (Ray (map Z.opp e) [] 0%Z). split; [reflexivity|]. apply in_flat_map. exists e.
      split; [exact He|right; now left].
Qed.

Lemma root_good n b : good (root n b).
Proof. apply child_good, everywhere_good. Qed.

Theorem root_home n b x : List.length x = n -> takes b x -> at_home (root n b) x.
Proof.
  intros L T. apply child_home; [|exact T]. constructor; cbn; try constructor; [apply T|]. now rewrite L.
Qed.

End Walk.

Arguments Branch {setting}.
Arguments conditions {setting}.
Arguments new_strict {setting}.
Arguments new_moving {setting}.
Arguments branch_setting {setting}.
Arguments takes {setting}.
Arguments Takes {setting}.
Arguments takes_above {setting solves s f x}.
Arguments takes_side {setting solves s} f {x}.
