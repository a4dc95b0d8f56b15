(* SPDX-License-Identifier: MIT *)
(** What is read of a grasp file is what stands there: the numbers of contacts and of wrenches.
    `read_grasp_says` is the theorem; what the definitions before it say is FORMAT.md sections 1 and 6.  Nothing is
    said of loads, and of contacts that are stated by [on]. *)
From Coq Require Import Bool List QArith String ZArith.
From Proved Require Import Grammar Json Numeral Question ReadBodies ReadGrasp.
Import ListNotations.
Local Open Scope string_scope.
Local Open Scope list_scope.

Definition members_are : Type := list (string * json).

(** A number or an INTERVAL. *)
Definition is_interval (value : json) (i : interval) : Prop :=
  (exists x, is_number value x /\ i = exactly x) \/
  (exists them least most, value = Object them /\ find_member "min" them = Some least /\
     find_member "max" them = Some most /\ is_number least (low i) /\ is_number most (high i) /\ (low i <= high i)%Q).

Definition is_vector (value : json) (v : list Q) : Prop :=
  exists items, value = Array items /\ Forall2 is_number items v.

Definition is_box (value : json) (v : list interval) : Prop :=
  exists items, value = Array items /\ Forall2 is_interval items v.

(** A vector, or one with a slope. *)
Definition is_normal (value : json) (n : list Q) (e : Q) : Prop :=
  (is_vector value n /\ e = 0%Q) \/
  (exists them direction slope, value = Object them /\ find_member "direction" them = Some direction /\
     find_member "slope" them = Some slope /\ is_vector direction n /\ is_number slope e).

(** Of a contact, else of [defaults], else a number or an error. *)
Definition is_property (name : string) (otherwise : option Q) (own defaults : members_are) (i : interval) : Prop :=
  match find_member name own, find_member name defaults, otherwise with
  | Some value, _, _ | None, Some value, _ => is_interval value i
  | None, None, Some x => i = exactly x
  | None, None, None => False
  end.

Definition is_contact (defaults : members_are) (value : json) (c : contact) : Prop :=
  exists own, value = Object own /\
    (find_member "on" own = None -> exists p n, find_member "position" own = Some p /\ find_member "normal" own = Some n /\
       is_box p (position c) /\ is_normal n (normal c) (slope c)) /\
    is_property "friction" None own defaults (friction c) /\
    is_property "stiffness" (Some 1%Q) own defaults (stiffness c) /\
    is_property "preload" (Some 0%Q) own defaults (preload c).

Definition no_members : members_are := [].
Definition defaults_of (file : members_are) : members_are :=
  match find_member "defaults" file with Some (Object them) => them | _ => no_members end.

(** With loads nothing is said. *)
Definition is_case (common : list interval) (value : json) (named : string * list interval) : Prop :=
  exists own, value = Object own /\ find_member "name" own = Some (Text (fst named)) /\
    forall w, find_member "wrench" own = Some w ->
      exists v, is_box w v /\ snd named = add_wrench v common.

(** A number for each coordinate, or one for all lengths and one for all angles. *)
Definition is_bound (in_space : bool) (count : nat) (value : json) (bound : list Q) : Prop :=
  is_vector value bound \/
  (exists them l a length angle, value = Object them /\ find_member "length" them = Some l /\
     find_member "angle" them = Some a /\ is_number l length /\ is_number a angle /\
     bound = bound_of in_space count length angle).

Definition is_grasp (value : json) (g : grasp) : Prop :=
  exists file, value = Object file /\
    (exists items, find_member "contacts" file = Some (Array items) /\
       Forall2 (is_contact (defaults_of file)) items (all_contacts g)) /\
    (forall w, find_member "wrench" file = Some w -> is_box w (common_wrench g)) /\
    (find_member "wrench" file = None -> find_member "loads" file = None ->
       common_wrench g = repeat (exactly 0) (if in_space g then 6 else 3)) /\
    (forall them, find_member "cases" file = Some them ->
       exists items, them = Array items /\ Forall2 (is_case (common_wrench g)) items (cases g)) /\
    (find_member "cases" file = None -> cases g = []) /\
    match find_member "max_motion" file with
    | Some it => exists bound, bound_read g = Some bound /\ is_bound (in_space g) (if in_space g then 6 else 3) it bound
    | None => bound_read g = None
    end.

(** ---- Proofs ---- *)

Lemma bind_fine {A B} (first : result A) (next : A -> result B) b : bind first next = Fine b ->
  exists a, first = Fine a /\ next a = Fine b.
Proof. destruct first; cbn; [eauto|discriminate]. Qed.

Ltac step hyp name what := apply bind_fine in hyp; destruct hyp as (name & what & hyp).

Lemma each_says {A B} (read : path -> A -> result B) (says : A -> B -> Prop) :
  (forall at_path item it, read at_path item = Fine it -> says item it) ->
  forall at_path items them, each read at_path items = Fine them -> Forall2 says items them.
Proof.
  intros R at_path items them. unfold each.
  assert (G : forall items index done them, each_from read index at_path items done = Fine them ->
    exists rest, them = rev done ++ rest /\ Forall2 says items rest).
  { clear items them. induction items as [|item items IH]; intros index done them H; cbn in H.
    - injection H as <-. exists []. rewrite rev_append_rev. split; [reflexivity|constructor].
    - destruct (read _ item) as [it|] eqn:E; [|discriminate]. destruct (IH _ _ _ H) as (rest & -> & F).
      exists (it :: rest). split; [cbn; now rewrite <- app_assoc|]. constructor; [|exact F]. eapply R, E. }
  intros H. destruct (G _ _ _ _ H) as (rest & -> & F). exact F.
Qed.

Lemma sized_says {B} size what (read : path -> json -> result B) (says : json -> B -> Prop) at_path value them :
  (forall at_path item it, read at_path item = Fine it -> says item it) ->
  read_sized size what read at_path value = Fine them ->
  exists items, value = Array items /\ Forall2 says items them.
Proof.
  intros R H. unfold read_sized in H. destruct value as [| | | |items|]; try discriminate.
  destruct (has_length size items); [|discriminate]. exists items. split; [reflexivity|]. eapply each_says; eassumption.
Qed.

Lemma array_says {B} what (read : path -> json -> result B) (says : json -> B -> Prop) at_path value them :
  (forall at_path item it, read at_path item = Fine it -> says item it) ->
  read_array what read at_path value = Fine them ->
  exists items, value = Array items /\ Forall2 says items them.
Proof.
  intros R H. unfold read_array in H. destruct value as [| | | |items|]; try discriminate.
  exists items. split; [reflexivity|]. eapply each_says; eassumption.
Qed.

Lemma members_say names at_path value them : members_of names at_path value = Fine them -> value = Object them.
Proof.
  unfold members_of. destruct value; try discriminate. intros H. step H u U. injection H as <-. reflexivity.
Qed.

Lemma member_says {A} name (read : path -> json -> result A) at_path them it : member name read at_path them = Fine it ->
  exists value, find_member name them = Some value /\ read (Member name :: at_path) value = Fine it.
Proof. unfold member. destruct (find_member name them); [eauto|discriminate]. Qed.

Lemma optional_says {A} name (read : path -> json -> result A) at_path them it :
  optional_member name read at_path them = Fine it ->
  match find_member name them with
  | Some value => exists a, it = Some a /\ read (Member name :: at_path) value = Fine a
  | None => it = None
  end.
Proof.
  unfold optional_member. destruct (find_member name them); [|congruence].
  intros H. step H a E. injection H as <-. eauto.
Qed.

Lemma interval_says v at_path value i : read_interval v at_path value = Fine i -> is_interval value i.
Proof.
  unfold read_interval. intros H.
  assert (G : (let* x := read_decimal at_path value in Fine (exactly x)) = Fine i -> is_interval value i).
  { intros E. step E x X. injection E as <-. left. exists x. split; [eapply read_decimal_is, X|reflexivity]. }
  destruct value as [| | | | |them]; try (exact (G H)). clear G. step H u U. step H ms M. apply members_say in M.
  step H a A. step H b B. step H c C. injection H as <-.
  apply member_says in A as (va & Fa & A), B as (vb & Fb & B). right. exists ms, va, vb.
  repeat split; try assumption; [eapply read_decimal_is, A|eapply read_decimal_is, B|].
  unfold check_that in C. cbn. destruct (Qle_bool a b) eqn:Le; [now apply Qle_bool_iff|discriminate].
Qed.

Lemma point_says v at_path value p : read_point v at_path value = Fine p -> is_vector value p.
Proof. intros H. eapply sized_says; [|exact H]. intros. eapply read_decimal_is; eassumption. Qed.

Lemma normal_says v at_path value n e : read_normal v at_path value = Fine (n, e) -> is_normal value n e.
Proof.
  unfold read_normal. intros H. step H ne Ne. destruct ne as [n0 e0]. step H u U. injection H as -> ->.
  assert (G : (let* n := read_point v at_path value in Fine (n, 0%Q)) = Fine (n, e) -> is_normal value n e).
  { intros E. step E m M. injection E as -> <-. left. split; [eapply point_says, M|reflexivity]. }
  destruct value as [| | | | |them]; try (exact (G Ne)). clear G. step Ne u' U'. step Ne ms M. apply members_say in M.
  step Ne d Dd. step Ne s Ss. step Ne c C. injection Ne as -> ->.
  apply member_says in Dd as (vd & Fd & Dd), Ss as (vs & Fs & Ss). right. exists ms, vd, vs.
  repeat split; try assumption; [eapply point_says, Dd|eapply read_decimal_is, Ss].
Qed.

Lemma property_reads v positive at_path value i : read_property v positive at_path value = Fine i -> is_interval value i.
Proof.
  unfold read_property. intros H. step H j J. destruct (if positive then _ else _); [|discriminate].
  injection H as <-. eapply interval_says, J.
Qed.

(** What an object says of the three properties. *)
Definition says_property (name : string) (them : members_are) (it : option interval) : Prop :=
  match find_member name them with
  | Some value => exists i, it = Some i /\ is_interval value i
  | None => it = None
  end.

Lemma properties_say v at_path them it : read_properties v at_path them = Fine it ->
  says_property "friction" them (own_friction it) /\ says_property "stiffness" them (own_stiffness it) /\
  says_property "preload" them (own_preload it).
Proof.
  unfold read_properties. intros H. step H mu M. step H k K. step H p P. injection H as <-. cbn.
  apply optional_says in M, K, P. unfold says_property.
  repeat split.
  - destruct (find_member "friction" them); [|exact M]. destruct M as (a & -> & A). eauto using property_reads.
  - destruct (find_member "stiffness" them); [|exact K]. destruct K as (a & -> & A). eauto using property_reads.
  - destruct (find_member "preload" them); [|exact P]. destruct P as (a & -> & A). eauto using property_reads.
Qed.

Lemma property_says name otherwise own defaults mine theirs i :
  says_property name own mine -> says_property name defaults theirs ->
  match match mine with Some _ => mine | None => theirs end with
  | Some it => i = it
  | None => match otherwise with Some x => i = exactly x | None => False end
  end -> is_property name otherwise own defaults i.
Proof.
  unfold says_property, is_property. intros M T H.
  destruct (find_member name own) as [value|].
  - destruct M as (j & -> & J). now subst i.
  - subst mine. destruct (find_member name defaults) as [value|].
    + destruct T as (j & -> & J). now subst i.
    + subst theirs. exact H.
Qed.

Lemma contact_says v outline defaults given at_path value c :
  says_property "friction" defaults (own_friction given) -> says_property "stiffness" defaults (own_stiffness given) ->
  says_property "preload" defaults (own_preload given) ->
  read_contact v outline given at_path value = Fine c -> is_contact defaults value c.
Proof.
  intros D1 D2 D3. unfold read_contact. intros H. step H own M. apply members_say in M. subst value.
  step H pne P. destruct pne as [[p n] e]. step H props R. apply properties_say in R as (R1 & R2 & R3).
  destruct (match own_friction props with Some _ => _ | None => _ end) as [mu|] eqn:F; [|discriminate].
  injection H as <-. exists own. split; [reflexivity|]. cbn. split; [|split; [|split]].
  - intros On. rewrite On in P. step P p' P'. step P ne Ne. destruct ne as [n' e']. injection P as -> -> ->.
    apply member_says in P' as (vp & Fp & P'), Ne as (vn & Fn & Ne). exists vp, vn. repeat split; try assumption.
    + eapply sized_says; [|exact P']. intros. eapply interval_says; eassumption.
    + eapply normal_says, Ne.
  - eapply property_says; [exact R1|exact D1|]. now rewrite F.
  - eapply property_says; [exact R2|exact D2|]. destruct (match own_stiffness props with Some _ => _ | None => _ end); reflexivity.
  - eapply property_says; [exact R3|exact D3|]. destruct (match own_preload props with Some _ => _ | None => _ end); reflexivity.
Qed.

Lemma wrench_says v at_path value w : read_wrench v at_path value = Fine w -> is_box value w.
Proof. intros H. eapply sized_says; [|exact H]. intros. eapply interval_says; eassumption. Qed.

(** Before what all cases have in common is added. *)
Definition is_own_case (value : json) (named : string * list interval) : Prop :=
  exists own, value = Object own /\ find_member "name" own = Some (Text (fst named)) /\
    forall w, find_member "wrench" own = Some w -> is_box w (snd named).

Lemma case_says v at_path value it : read_case v at_path value = Fine it -> is_own_case value it.
Proof.
  unfold read_case. intros H. step H own M. apply members_say in M. subst value. step H name Nm. step H w W. step H l L.
  apply member_says in Nm as (vn & Fn & Nm). apply optional_says in W. exists own. split; [reflexivity|].
  assert (T : vn = Text name).
  { unfold read_name in Nm. destruct vn as [| | |content| |]; try discriminate. destruct content; [discriminate|].
    now injection Nm as <-. }
  subst vn. destruct w as [w|], l as [l|]; try discriminate; injection H as <-; cbn [fst snd].
  - split; [exact Fn|]. intros u U. rewrite U in W. destruct W as (a & E & A). injection E as <-. eapply wrench_says, A.
  - split; [exact Fn|]. intros u U. rewrite U in W. destruct W as (a & E & _). discriminate.
Qed.

Lemma above_0_says at_path value x : read_above_0 at_path value = Fine x -> is_number value x.
Proof. unfold read_above_0. intros H. step H y Y. step H u U. injection H as <-. eapply read_decimal_is, Y. Qed.

Lemma bound_says in_space joints count at_path value bound : read_bound in_space joints count at_path value = Fine bound ->
  is_bound in_space count value bound.
Proof.
  unfold read_bound. intros H.
  assert (G : forall what, read_sized (Z.of_nat count) what read_above_0 at_path value = Fine bound ->
    is_bound in_space count value bound).
  { intros what E. left. eapply sized_says; [|exact E]. intros. eapply above_0_says; eassumption. }
  destruct value as [| | | | |them]; try (exact (G _ H)). clear G. step H u U. step H ms M. apply members_say in M.
  step H l L. step H a A. injection H as <-.
  apply member_says in L as (vl & Fl & L), A as (va & Fa & A). right. exists ms, vl, va, l, a.
  repeat split; try assumption; [eapply above_0_says, L|eapply above_0_says, A].
Qed.

Theorem read_grasp_says value g : read_grasp value = Fine g -> is_grasp value g.
Proof.
  unfold read_grasp. intros H. step H file M. apply members_say in M. step H v V. step H u1 U1. step H u2 U2.
  step H outline Oo. step H u3 U3. step H given D. step H them C. step H own W. step H loads L. step H named Nm.
  step H bound Bo. step H u4 U4. step H u5 U5. injection H as <-.
  apply member_says in C as (vc & Fc & C). apply optional_says in D, W, L, Nm, Bo.
  exists file. split; [exact M|]. cbn. split; [|split; [|split; [|split; [|split]]]].
  - destruct vc as [| | | |items|]; try discriminate. step C u6 U6. exists items. split; [exact Fc|].
    eapply each_says; [|exact C]. intros at_path item it. cbv beta.
    set (props := match given with Some it => it | None => _ end).
    assert (S : says_property "friction" (defaults_of file) (own_friction props) /\
      says_property "stiffness" (defaults_of file) (own_stiffness props) /\
      says_property "preload" (defaults_of file) (own_preload props)).
    { unfold defaults_of, props. destruct (find_member "defaults" file) as [vd|].
      - destruct D as (a & -> & A). unfold read_defaults in A. step A ms Ms. apply members_say in Ms. subst vd.
        now apply properties_say in A.
      - subst given. repeat split. }
    destruct S as (S1 & S2 & S3). now apply contact_says.
  - intros w Fw. rewrite Fw in W. destruct W as (a & -> & A). eapply wrench_says, A.
  - intros Fw Fl. rewrite Fw in W. rewrite Fl in L. subst own loads. unfold no_wrench. reflexivity.
  - intros vs Fs. rewrite Fs in Nm. destruct Nm as (a & -> & A). unfold read_list_of_cases in A. step A raw R. step A u7 U7.
    step A u8 U8. injection A as <-.
    destruct (array_says _ _ is_own_case _ _ _ (case_says v) R) as (items & -> & F). exists items.
    split; [reflexivity|]. set (common := match own with Some _ => _ | None => _ end).
    clear - F. induction F as [|item it items raw I F IH]; cbn; constructor; [|exact IH].
    destruct it as [name w]. destruct I as (them & -> & Fn & Ss). exists them. split; [reflexivity|]. split; [exact Fn|].
    intros u U. exists w. split; [exact (Ss u U)|reflexivity].
  - intros Fs. rewrite Fs in Nm. now subst named.
  - destruct (find_member "max_motion" file); [|exact Bo]. destruct Bo as (b & -> & B). exists b. split; [reflexivity|].
    eapply bound_says, B.
Qed.

Lemma bodies_are_read value g : read_grasp_of_bodies value = Fine g -> bodies_read g <> None.
Proof.
  unfold read_grasp_of_bodies. intros H. step H ms M. step H u1 U1. step H u2 U2. step H bs B. step H js J. step H u3 U3.
  step H u4 U4. step H rs R. step H ss Sp. step H ts T. step H ds D. destruct (match ds with Some it => it | None => _ end).
  step H cs C. step H w W. step H l L. step H u5 U5. step H ns Ns. step H bound Bo. injection H as <-.
  discriminate.
Qed.

(** Of a file of several bodies nothing is said. *)
Theorem read_file_says value g : read_file value = Fine g -> bodies_read g = None -> is_grasp value g.
Proof.
  unfold read_file. intros H B.
  assert (One : read_grasp value = Fine g -> is_grasp value g) by apply read_grasp_says.
  destruct value as [| | | | |them]; try (exact (One H)). destruct (find_member "format" them); [|exact (One H)].
  destruct (is_text _ _); [|exact (One H)]. now apply bodies_are_read in H.
Qed.
