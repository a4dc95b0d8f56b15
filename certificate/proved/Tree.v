(* SPDX-License-Identifier: MIT *)
(* Trees (FORMAT.md sections 4 and 6): the children of nodes, leaves, and the roots of ranges of multiples.
   `refuted_multiple`: where trees about ranges are accepted, no multiple in a range has an
   equilibrium. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load Bound.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Slips Leaf Moving Walk.
From Proved Require Rows Model.
Import ListNotations.

(* ---- Contacts by their number ---- *)

Section Numbered.
Open Scope Z_scope.

Fixpoint replace_after {A} (before l : list A) (i : Z) (new : A) : list A :=
  match l with
  | [] => rev_append before []
  | a :: l' => if i =? 0 then rev_append before (new :: l') else replace_after (a :: before) l' (i - 1) new
  end.

Definition replace {A} (l : list A) (i : Z) (new : A) : list A := replace_after [] l i new.

End Numbered.

(* Values of lambda: from low to high, or from low on; and which ends are not among them. *)
Record range := Range {
  range_low : Q; range_high : option Q; open_low : bool; open_high : bool
}.

(* Wrenches in addition, as forms of the point: some multiple >= 0 of one (in proofs by degree), and another (of a plane
   of loads). *)
Record pushing := Pushing { a_multiple : matrix; known_push : matrix }.

Definition no_push : pushing := Pushing [] [].

(* The box that a tree is about: the dimension of motions, rows, load, the contacts whose slip is strict; and
   two numbers M for leaves, a short one and one that makes them exact but for what with_all adds.  Solutions
   may be pushed, and their motions may be bounded. *)
Record setting := Setting {
  dimension_of : nat; rows : list row; the_load : load; pushes : pushing; slipping : list Z; short : Z; exact : Z;
  the_bound : option (list Q)
}.

Section Numbers.
Open Scope Z_scope.

(* A multiple of all denominators of leaves, but for those of loads and of alphas; and a power of two with which
   every term of a leaf keeps about 64 bits, if that is shorter, or if there are alphas. *)
Definition common_multiple (rows : list row) : Z := fold_left (fun m r => Z.lcm m (over_weight r)) rows 1.

Definition short_multiple (rows : list row) (multiple : Z) : Z :=
  let size (r : row) := if box_signed (box r) then over_weight r / weight r
                        else over (pull_scale r) / times (pull_scale r) in
  let most := fold_left (fun b r => Z.max b (size r)) rows 1 in
  let short := Z.shiftl 1 (Z.log2 most + 65) in
  if (short <? multiple) || negb (forallb (fun r => box_signed (box r)) rows) then short else multiple.

End Numbers.

Definition make_setting (dimension : nat) (rows : list row) (ld : load) (pushes : pushing)
    (bound : option (list Q)) : setting :=
  let m := common_multiple rows in
  Setting dimension rows ld pushes [] (short_multiple rows m) m bound.

Definition without_bound (s : setting) : setting :=
  Setting (dimension_of s) (rows s) (the_load s) (pushes s) (slipping s) (short s) (exact s) None.

(* ---- Nodes ---- *)

Definition leaf_fails (s : setting) (strict : list (list form)) (rays : list ray) (y : list Q)
    : option string :=
  let sc := scaling_of y in
  let y' := map (to_integer sc) y in
  if barred strict rays || beyond_bound (the_bound s) strict rays then None
  else
    let them := pressers strict rays (slipping s) (unit_of sc) y' (rows s) 0 [] in
    let works := load_works (the_load s) (unit_of sc) y' in
    let more := map (fun q => reduced (q / unit_of sc)%Q) (of_rows y (known_push (pushes s))) in
    let holds m := leaf_holds_by m them works more strict rays y' in
    if (negb (Z.eqb (short s) (exact s)) && holds (short s)) || holds (with_all (exact s) works more them) then
      let along := of_rows y (a_multiple (pushes s)) in
      if nowhere_negative rays (map (to_integer (scaling_of along)) along) then None
      else Some "leaf-direction"%string
    else Some "leaf-bound"%string.

(* Nothing pushes and no load grows where twists move, but what a proof by degree asks about. *)
Definition moving_fails (s : setting) (strict : list (list form)) (rays : list ray) (y : list Q) (along_motion : Q)
    (brakes : list (Z * (Q * list Q))) : option string :=
  let sc := scaling_of (along_motion :: y ++ List.concat (map (fun f => fst (snd f) :: snd (snd f)) brakes)) in
  let c := to_integer sc along_motion in
  let y := map (to_integer sc) y in
  let them := map (fun f => (fst f, (to_integer sc (fst (snd f)), map (to_integer sc) (snd (snd f))))) brakes in
  let of_contacts (exact : bool) := carriers exact (unit_of sc) rays them (rows s) 0 [] in
  let holds := moving_holds strict rays (the_load s) c y (unit_of sc) in
  match of_contacts false with
  | None => Some "moving-list"%string
  | Some cs =>
      if barred strict rays || beyond_bound (the_bound s) strict rays then None
      else if Nat.eqb (List.length (known_push (pushes s))) 0 && forallb is_zero (load_growth (the_load s)) &&
              (holds cs || match of_contacts true with Some cs => holds cs | None => false end) then
        if direction_holds rays c y (a_multiple (pushes s)) then None else Some "leaf-direction"%string
      else Some "leaf-bound"%string
  end.

(* What a leaf that is held says; without pieces there are none. *)
Definition end_fails (held : Z -> list ray -> option string) (s : setting) (strict : list (list form)) (rays : list ray)
    (n : node) : option string :=
  match n with
  | Leaf y => leaf_fails s strict rays y
  | Moving y c brakes => moving_fails s strict rays y c brakes
  | Held k => held k rays
  | _ => Some "node-contact"%string
  end.

Definition no_pieces (k : Z) (rays : list ray) : option string := Some "held-piece"%string.

Definition is_inside (i : interval) (c : Q) : bool :=
  negb (Qle_bool c (low i)) && negb (Qle_bool (high i) c).

Definition low_half (i : interval) (c : Q) := Interval (low i) c.
Definition high_half (i : interval) (c : Q) := Interval c (high i).

Definition same_parameter (a b : parameter) : bool :=
  match a, b with
  | PX, PX | PY, PY | PZ, PZ | PTurn, PTurn | PTurnV, PTurnV
  | PFriction, PFriction | PPreload, PPreload | PStiffness, PStiffness | PWrench, PWrench => true
  | _, _ => false
  end.

Fixpoint get_named (name : parameter) (names : list parameter) (is : list interval) : option interval :=
  match names, is with
  | n :: names', i :: is' => if same_parameter n name then Some i else get_named name names' is'
  | _, _ => None
  end.

Fixpoint set_named (name : parameter) (new : interval) (names : list parameter) (is : list interval)
    : list interval :=
  match names, is with
  | n :: names', i :: is' => if same_parameter n name then new :: is' else i :: set_named name new names' is'
  | _, _ => is
  end.

Definition get (b : cbox) (name : parameter) : option interval :=
  match name with
  | PFriction => if has_friction b then Some (box_friction b) else None
  | PPreload => Some (box_preload b)
  | PStiffness => Some (box_stiffness b)
  | PWrench => None
  | _ => get_named name (box_names b) (box_geometry b)
  end.

Definition set (b : cbox) (name : parameter) (i : interval) : cbox :=
  match b with
  | CBox names g f m p u k sq n w sg sp tu sl =>
      match name with
      | PFriction => CBox names g f i p u k sq n w sg sp tu sl
      | PPreload => CBox names g f m i u k sq n w sg sp tu sl
      | PStiffness => CBox names g f m p u i sq n w sg sp tu sl
      | PWrench => b
      | _ => CBox names (set_named name i names g) f m p u k sq n w sg sp tu sl
      end
  end.

Definition set_row (s : setting) (index : Z) (b : cbox) : setting :=
  let row := make_row b in
  Setting (dimension_of s) (replace (rows s) index row) (the_load s) (pushes s) (slipping s) (short s)
    (Z.lcm (exact s) (over_weight row)) (the_bound s).

Definition set_load (s : setting) (ld : load) : setting :=
  Setting (dimension_of s) (rows s) ld (pushes s) (slipping s) (short s) (exact s) (the_bound s).

(* What is uncertain of the load: numbers of a ball if there are any, else components. *)
Definition numbers_of (ld : load) : list interval :=
  match ball_numbers (load_added ld) with [] => load_box ld | zs => zs end.

Definition with_numbers (ld : load) (is : list interval) : load :=
  let a := load_added ld in
  match ball_numbers a with
  | [] => Load is (load_growth ld) a
  | _ => Load (load_box ld) (load_growth ld) (Addition is (ball_ways a) (ball_squares a))
  end.

(* The two halves of a box, or the rule that fails. *)
Definition halves (s : setting) (name : parameter) (index : Z) (c : Q)
    : (setting * setting) + string :=
  match name with
  | PWrench =>
      let ld := the_load s in
      match numbered (numbers_of ld) index with
      | None => inr "part-contact"%string
      | Some i =>
          if is_inside i c then
            inl (set_load s (with_numbers ld (replace (numbers_of ld) index (low_half i c))),
                 set_load s (with_numbers ld (replace (numbers_of ld) index (high_half i c))))
          else inr "part-inside"%string
      end
  | _ =>
      match numbered (rows s) index with
      | None => inr "part-contact"%string
      | Some row =>
          match get (box row) name with
          | None => inr "part-contact"%string
          | Some i =>
              (* Preloads that grow are in margins, which have no parts. *)
              if is_inside i c && (negb (same_parameter name PPreload) || certain (box_growth (box row))) then
                inl (set_row s index (set (box row) name (low_half i c)),
                     set_row s index (set (box row) name (high_half i c)))
              else inr "part-inside"%string
          end
      end
  end.

(* f > 0 *)
Definition above (s : setting) (f : form) : branch setting := Branch [(f, false)] [f] [] s.
(* f >= 0 *)
Definition not_below (s : setting) (f : form) : branch setting := Branch [(f, false)] [] [] s.
(* f = 0 *)
Definition on_plane (s : setting) (f : form) : branch setting := Branch [(f, true)] [] [] s.

(* The numbers of a node `plane`, which end with those of h and l. *)
Definition plane_numbers (d : nat) (a : list Q) : list Q := nth d a 0%Q :: nth (S d) a 0%Q :: firstn d a.

Definition slip_forms (row : row) : list form := map of_motion (firstn (List.length (metric row)) (tl (first_tip (forms row)))).

(* The children of a node, or the rule that fails. *)
Definition split (s : setting) (n : node) : list (branch setting) + string :=
  match n with
  | Leaf _ | Moving _ _ _ | Held _ => inl []
  | Plane a =>
      let a := plane_numbers (dimension_of s) a in
      let f := map (to_integer (scaling_of a)) a in
      inl [not_below s f; above s (negative f)]
  | Slip i =>
      match numbered (rows s) i with
      | None => inr "node-contact"%string
      | Some row =>
          if negb (has_friction (box row)) then inr "node-contact"%string
          else if negb (slip_certain row) then inr "node-certain"%string
          else if box_signed (box row) then
            let f := first_tip (tau row) in
            inl [above s f; on_plane s f; above s (negative f)]
          else
            let fs := slip_forms row in
            inl [Branch (map (fun f => (f, true)) fs) [] [] s;
                 Branch [] [] [fs] (Setting (dimension_of s) (rows s) (the_load s) (pushes s) (i :: slipping s)
                                      (short s) (exact s) (the_bound s))]
      end
  | Separation i =>
      match numbered (rows s) i with
      | None => inr "node-contact"%string
      | Some row =>
          if box_spring (box row) then inr "node-contact"%string
          else
            match separates row with
            | Some f => inl [not_below s f; above s (negative f)]
            | None => inr "node-certain"%string
            end
      end
  | Cut name i c =>
      match halves s name i c with
      | inl (l, h) => inl [Branch [] [] [] l; Branch [] [] [] h]
      | inr rule => inr rule
      end
  end.

(* ---- Roots ---- *)

Section Root.
Open Scope Z_scope.

(* l - a h *)
Definition l_above (a : Q) : form := [- Qnum a; Zpos (Qden a)].
Definition h_form : form := [1].

Definition range_conditions (g : range) : list form :=
  h_form :: l_above (range_low g) ::
  match range_high g with Some b => [negative (l_above b)] | None => [] end.

Definition range_strict (g : range) : list form :=
  h_form :: (if open_low g then [l_above (range_low g)] else []) ++
  match range_high g with
  | Some b => if open_high g then [negative (l_above b)] else []
  | None => []
  end.

(* After the conditions `before`, those of the bilateral law. *)
Definition separating (rows : list row) (before : list form) : list form :=
  rev_append
    (fold_left (fun fs r => match separates r with
                            | Some f => if box_spring (box r) then fs else f :: fs
                            | None => fs
                            end) rows (rev_append before [])) [].

Definition root_branch (two_sided : bool) (s : setting) (g : range) : branch setting :=
  let fs := range_conditions g ++ bound_conditions (the_bound s) in
  Branch
    (map_all (fun f => (f, false)) (if two_sided then separating (rows s) fs else fs))
    (range_strict g) [] s.

End Root.

(* ---- Proofs ---- *)

Section Proofs.
Open Scope R_scope.

Lemma replace_cons {A} (a : A) l i new : (i =? 0)%Z = false ->
  replace (a :: l) i new = a :: replace l (i - 1) new.
Proof.
  assert (G : forall l before i new, @replace_after A before l i new = rev before ++ replace l i new).
  { unfold replace. induction l0 as [|b l0 IH]; intros before j n; cbn [replace_after].
    - rewrite rev_append_rev. reflexivity.
    - destruct (Z.eqb j 0); [now rewrite rev_append_rev|]. rewrite IH, (IH [b]). cbn. now rewrite <- app_assoc. }
  intros E. unfold replace at 1. cbn [replace_after]. rewrite E, G. reflexivity.
Qed.

(* A part: which half may depend on the point, here on the contact of that number. *)
Lemma numbered_replace_either {A B} (P : A -> B -> Prop) l l' i a new new' :
  Forall2 P l l' -> numbered l i = Some a -> (forall b, P a b -> P new b \/ P new' b) ->
  Forall2 P (replace l i new) l' \/ Forall2 P (replace l i new') l'.
Proof.
  intros F. revert i. induction F as [|x y l l' Hxy F IH]; intros i; cbn [numbered]; [discriminate|].
  destruct (Z.eqb i 0) eqn:Z.
  - intros E H. injection E as ->. unfold replace; cbn [replace_after]. rewrite Z. cbn [rev_append].
    destruct (H _ Hxy); [left|right]; now constructor.
  - intros E H. rewrite !replace_cons by exact Z. destruct (IH _ E H); [left|right]; now constructor.
Qed.

Lemma fits_at {A B} (P : A -> B -> Prop) l l' k a : Forall2 P l l' -> nth_error l k = Some a ->
  exists b, nth_error l' k = Some b /\ P a b.
Proof.
  intros F. revert k. induction F as [|x y l l' H F IH]; intros [|k]; cbn; try discriminate.
  - intros E. injection E as <-. now exists y.
  - apply IH.
Qed.

Lemma within_halves i c x : within i x -> within (low_half i c) x \/ within (high_half i c) x.
Proof. unfold within; cbn. intros [L H]. destruct (Rle_dec x (Q2R c)); [left|right]; lra. Qed.

Lemma set_named_within name names is p i c : Forall2 within is p -> get_named name names is = Some i ->
  Forall2 within (set_named name (low_half i c) names is) p \/
  Forall2 within (set_named name (high_half i c) names is) p.
Proof.
  intros F. revert names. induction F as [|j x is p W F IH]; intros [|n names]; cbn; try discriminate.
  destruct (same_parameter n name).
  - intros E. injection E as ->. destruct (within_halves i c x W); [left|right]; now constructor.
  - intros E. destruct (IH names E); [left|right]; now constructor.
Qed.

Lemma set_named_length name i names is : List.length (set_named name i names is) = List.length is.
Proof.
  revert is. induction names as [|n names IH]; intros [|j is]; cbn; try reflexivity.
  destruct (same_parameter n name); cbn; [reflexivity|]. now rewrite IH.
Qed.

Lemma set_inside_at b name c i r p F mu t : inside_at b r p F mu t -> get b name = Some i -> is_inside i c = true ->
  negb (same_parameter name PPreload) || certain (box_growth b) = true ->
  (exists t', inside_at (set b name (low_half i c)) r p F mu t') \/
  (exists t', inside_at (set b name (high_half i c)) r p F mu t').
Proof.
  intros [Ge Fo Ra Af Sh Fr F0 Rh Sq We Wp St Pr Gr K Sp Sm Sa Ss Sn Sst Si] E C G.
  destruct b as [names g f m pl u k sq n w sg sp tu sl]. cbn in *.
  assert (Geometry : forall name', get_named name' names g = Some i ->
    (exists t', inside_at (CBox names (set_named name' (low_half i c) names g) f m pl u k sq n w sg sp tu sl) r p F mu t') \/
    (exists t', inside_at (CBox names (set_named name' (high_half i c) names g) f m pl u k sq n w sg sp tu sl) r p F mu t')).
  { intros name' E'. destruct (set_named_within name' names g p i c Ge E') as [H|H]; [left|right];
      exists t; constructor; cbn; try assumption; intros; rewrite set_named_length in *; auto. }
  destruct name; cbn in *; try discriminate; try (now apply Geometry).
  - destruct (has_friction _); [|discriminate]. injection E as <-.
    destruct (within_halves _ c _ Fr); [left|right]; exists t; constructor; cbn; assumption.
  - injection E as <-. unfold certain in G. apply Qeq_bool_eq, Qeq_eqR in G.
    apply andb_true_iff in C as [C1 C2]. apply negb_true_iff in C1, C2.
    assert (L : Q2R (low pl) < Q2R c).
    { apply Rnot_le_lt. intros L. apply Rle_Qle, Qle_bool_iff in L. congruence. }
    assert (H : Q2R c < Q2R (high pl)).
    { apply Rnot_le_lt. intros L'. apply Rle_Qle, Qle_bool_iff in L'. congruence. }
    rewrite <- G in *. destruct St as [T0 T1].
    destruct (Rle_dec (Rows.preload r) (Q2R c)) as [D|D]; [left|right].
    + set (t' := (Rows.preload r - Q2R (low pl)) / (Q2R c - Q2R (low pl))).
      assert (E : Rows.preload r = (1 - t') * Q2R (low pl) + t' * Q2R c) by (unfold t'; field; lra).
      assert (0 <= t' <= 1).
      { assert (Q2R (low pl) <= Rows.preload r).
        { rewrite Pr. assert (0 <= t * (Q2R (high pl) - Q2R (low pl))) by (apply Rmult_le_pos; lra). lra. }
        split.
        - apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
        - apply Rmult_le_reg_r with (Q2R c - Q2R (low pl)); [lra|]. unfold t'. field_simplify; lra. }
      exists t'. constructor; cbn; try assumption. rewrite <- G. lra.
    + set (t' := (Rows.preload r - Q2R c) / (Q2R (high pl) - Q2R c)).
      assert (E : Rows.preload r = (1 - t') * Q2R c + t' * Q2R (high pl)) by (unfold t'; field; lra).
      assert (0 <= t' <= 1).
      { assert (Rows.preload r <= Q2R (high pl)).
        { rewrite Pr. assert (0 <= (1 - t) * (Q2R (high pl) - Q2R (low pl))) by (apply Rmult_le_pos; lra). lra. }
        split.
        - apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
        - apply Rmult_le_reg_r with (Q2R (high pl) - Q2R c); [lra|]. unfold t'. field_simplify; lra. }
      exists t'. constructor; cbn; try assumption. rewrite <- G. lra.
  - injection E as <-.
    destruct (within_halves _ c _ K); [left|right]; exists t; constructor; cbn; assumption.
Qed.

Lemma set_seen b name c i r : seen_in b r -> get b name = Some i -> is_inside i c = true ->
  negb (same_parameter name PPreload) || certain (box_growth b) = true ->
  seen_in (set b name (low_half i c)) r \/ seen_in (set b name (high_half i c)) r.
Proof.
  intros (r' & p & F & mu & t & G & len & k & I & Se & ->) E C Gr.
  assert (Keep : forall i', seen_as (set b name i') F G len k /\ forall fs rho p u s,
      row_of (set b name i') fs rho p u s = row_of b fs rho p u s).
  { intros i'. destruct Se. split; [|now destruct b, name]. constructor; destruct b, name; cbn in *;
      rewrite ?set_named_length; assumption. }
  destruct (set_inside_at b name c i r' p F mu t I E C Gr) as [(t' & H)|(t' & H)]; [left|right];
    exists r', p, F, mu, t', G, len, k; (split; [exact H|]).
  - destruct (Keep (low_half i c)) as [K ->]. now split.
  - destruct (Keep (high_half i c)) as [K ->]. now split.
Qed.

Lemma with_numbers_either ld w i iv c : is_load ld w -> numbered (numbers_of ld) i = Some iv ->
  is_load (with_numbers ld (replace (numbers_of ld) i (low_half iv c))) w \/
  is_load (with_numbers ld (replace (numbers_of ld) i (high_half iv c))) w.
Proof.
  intros (w0 & e & B & L & A & E) N. unfold with_numbers, numbers_of in *.
  assert (Ends : forall x, within iv x -> within (low_half iv c) x \/ within (high_half iv c) x)
    by (intros; now apply within_halves).
  destruct (ball_numbers (load_added ld)) as [|z zs] eqn:Z.
  - destruct (numbered_replace_either within _ _ _ _ _ _ B N Ends) as [F|F]; [left|right]; now exists w0, e.
  - rewrite <- Z in *. destruct A as [P W Le Nu I].
    destruct (numbered_replace_either within _ _ _ _ _ _ Nu N Ends) as [F|F]; [left|right];
      (exists w0, e; split; [exact B|split; [exact L|split; [constructor; assumption|exact E]]]).
Qed.

(* A system in the box. *)
Definition contains (rows : list row) (ld : load) (sys : Rows.system) : Prop :=
  Forall2 suits rows (Rows.rows sys) /\ is_load ld (Rows.wrench sys) /\ map Q2R (load_growth ld) = Rows.direction sys.

Lemma halves_contain s name i c lo hi sys : halves s name i c = inl (lo, hi) ->
  contains (rows s) (the_load s) sys ->
  (forall t, t = lo \/ t = hi ->
     dimension_of t = dimension_of s /\ slipping t = slipping s /\ pushes t = pushes s /\ the_bound t = the_bound s) /\
  (contains (rows lo) (the_load lo) sys \/ contains (rows hi) (the_load hi) sys).
Proof.
  intros H (F & LW & LU).
  assert (Row : match numbered (rows s) i with
      | None => inr "part-contact"%string
      | Some row => match get (box row) name with
          | None => inr "part-contact"%string
          | Some iv =>
              if is_inside iv c && (negb (same_parameter name PPreload) || certain (box_growth (box row))) then
                inl (set_row s i (set (box row) name (low_half iv c)),
                     set_row s i (set (box row) name (high_half iv c)))
              else inr "part-inside"%string
          end
      end = inl (lo, hi) ->
    (forall t, t = lo \/ t = hi ->
       dimension_of t = dimension_of s /\ slipping t = slipping s /\ pushes t = pushes s /\ the_bound t = the_bound s) /\
    (contains (rows lo) (the_load lo) sys \/ contains (rows hi) (the_load hi) sys)).
  { intros R. destruct (numbered (rows s) i) as [row|] eqn:N; [|discriminate].
    destruct (get (box row) name) as [iv|] eqn:Ge; [|discriminate].
    destruct (is_inside iv c && _) eqn:C; [|discriminate]. apply andb_true_iff in C as [C G].
    injection R as <- <-. split; [intros t [-> | ->]; auto|].
    destruct (numbered_replace_either suits (rows s) (Rows.rows sys) i row
      (make_row (set (box row) name (low_half iv c))) (make_row (set (box row) name (high_half iv c))) F N)
      as [F'|F']; [|left; now repeat split|right; now repeat split].
    intros k [_ Ik]. destruct (set_seen _ name c iv k Ik Ge C G); [left|right]; (split; [reflexivity|assumption]). }
  destruct name; cbn [halves] in H; try (apply Row; exact H).
  destruct (numbered (numbers_of (the_load s)) i) as [iv|] eqn:N; [|discriminate].
  destruct (is_inside iv c); [|discriminate]. injection H as <- <-. split; [intros t [-> | ->]; auto|].
  destruct (with_numbers_either (the_load s) (Rows.wrench sys) i iv c LW N) as [F'|F']; [left|right]; repeat split;
    try assumption; cbn [set_load the_load]; unfold with_numbers; destruct (ball_numbers _); exact LU.
Qed.

Lemma halves_cover s name i c lo hi push sys d h l fs : halves s name i c = inl (lo, hi) ->
  solution (rows s) (the_load s) push sys d h l fs ->
  (slipping lo = slipping s /\ slipping hi = slipping s /\ pushes lo = pushes s /\ pushes hi = pushes s /\
   the_bound lo = the_bound s /\ the_bound hi = the_bound s) /\
  (solution (rows lo) (the_load lo) push sys d h l fs \/ solution (rows hi) (the_load hi) push sys d h l fs).
Proof.
  intros H [F LW LU H0 L0 E Bal].
  destruct (halves_contain s name i c lo hi sys H) as [S C]; [now repeat split|].
  destruct (S lo (or_introl eq_refl)) as (_ & S1 & S2 & S3), (S hi (or_intror eq_refl)) as (_ & S4 & S5 & S6).
  split; [auto 7|]. destruct C as [(F' & LW' & LU')|(F' & LW' & LU')]; [left|right]; constructor; assumption.
Qed.

Definition in_range (g : range) (lambda : R) :=
  Q2R (range_low g) <= lambda /\ (open_low g = true -> Q2R (range_low g) < lambda) /\
  match range_high g with
  | Some b => lambda <= Q2R b /\ (open_high g = true -> lambda < Q2R b)
  | None => True
  end.

Lemma l_above_at d q lambda : rdot (l_above q) (1 :: lambda :: d) = IZR (Zpos (Qden q)) * (lambda - Q2R q).
Proof.
  unfold l_above, Q2R. cbn -[IZR]. rewrite opp_IZR. field. apply not_0_IZR. discriminate.
Qed.

Lemma range_conditions_met d g lambda : in_range g lambda ->
  Forall (fun f => 0 <= rdot f (1 :: lambda :: d)) (range_conditions g) /\
  Forall (fun f => rdot f (1 :: lambda :: d) <> 0) (range_strict g).
Proof.
  intros (Lo & OLo & Hi). assert (PD : forall q : Q, 0 < IZR (Zpos (Qden q))) by (intros; apply IZR_lt; lia).
  set (x := 1 :: lambda :: d).
  assert (H1 : rdot h_form x = 1) by (unfold h_form, x; cbn; lra).
  pose proof (PD (range_low g)). pose proof (l_above_at d (range_low g) lambda) as EL. fold x in EL.
  split.
  - constructor; [lra|]. constructor; [rewrite EL; nra|].
    destruct (range_high g) as [b|]; [|constructor]. constructor; [|constructor].
    pose proof (l_above_at d b lambda) as EB. fold x in EB.
    rewrite rdot_negative, EB. pose proof (PD b). destruct Hi. nra.
  - constructor; [lra|]. apply Forall_app. split.
    + destruct (open_low g); constructor; [|constructor]. rewrite EL. specialize (OLo eq_refl). nra.
    + destruct (range_high g) as [b|]; [|constructor]. destruct Hi as [Hi OHi].
      destruct (open_high g); constructor; [|constructor]. pose proof (l_above_at d b lambda) as EB. fold x in EB.
      rewrite rdot_negative, EB. specialize (OHi eq_refl). pose proof (PD b). nra.
Qed.

(* ---- Solutions ---- *)

Definition pushed (pushes : pushing) (c : R) (x y : list R) : R :=
  c * Rows.dot y (Degree.times (map real (a_multiple pushes)) x) -
  Rows.dot y (Degree.times (map real (known_push pushes)) x).

Lemma not_pushed c x y : pushed no_push c x y = 0.
Proof. unfold pushed. cbn. rewrite Degree.dot_nil. ring. Qed.

Definition solves (s : setting) (x : list R) :=
  exists sys d h l fs c, x = h :: l :: d /\ 0 <= c /\
    solution (rows s) (the_load s) (pushed (pushes s) c x) sys d h l fs /\ slips_at (slipping s) (Rows.rows sys) d /\
    Rows.bounded (real_bound (the_bound s)) h d.

(* Where the geometry is certain, the slip is zero where its forms are. *)
Lemma slip_forms_zero row r d h l : suits row r -> slip_certain row = true -> box_signed (box row) = false ->
  Forall (fun f => rdot f (h :: l :: d) = 0) (slip_forms row) \/
  (0 < Rows.size (Rows.weights r) (Rows.slip r d) /\ not_zero (h :: l :: d) (slip_forms row)).
Proof.
  intros [E Se] C Sg. destruct (seen_stands _ _ Se) as (r' & k0 & p & F & mu & t & I & St & _ & _).
  assert (C' : count (box_geometry (box row)) = O).
  { rewrite E in C. cbn [slip_certain make_row] in C. rewrite Sg in C. now apply Nat.eqb_eq. }
  assert (SS : shares_in (box row) p = []).
  { clear C. rename C' into C.
    unfold shares_in. apply length_zero_iff_nil. rewrite (shares_count _ _ (in_geometry _ _ _ _ _ _ I)). exact C. }
  set (u := unit (forms_scaling (box row))). assert (U : 0 < u) by apply unit_positive.
  set (T := first_tip (forms row)).
  assert (Nth : forall j, nth j (Rows.slip r' d) 0 = u * rdot (nth (S j) T []) d).
  { intros j. pose proof (forms_corners (box row) r' p F mu t I (S j) d) as X. rewrite <- (forms_are (box row) Sg) in X.
    rewrite SS, eval_first, <- E in X. transitivity (Rows.dot (nth j (Rows.slips r') []) d); [|exact X].
    unfold Rows.slip. change 0 with (Rows.dot [] d) at 1. apply (map_nth (fun f => Rows.dot f d)). }
  assert (Of : forall f, rdot (of_motion f) (h :: l :: d) = rdot f d) by (intros; apply rdot_of_motion).
  unfold slip_forms. fold T. set (k := List.length (metric row)).
  assert (Cases : Forall (fun f => rdot f d = 0) (firstn k (tl T)) \/
                  Exists (fun f => rdot f d <> 0) (firstn k (tl T))).
  { induction (firstn k (tl T)) as [|f fs [IH|IH]]; [now left| |right; now right].
    destruct (Req_dec (rdot f d) 0); [left; now constructor|right; now left]. }
  destruct Cases as [Z|NZ].
  - left. apply Forall_map. eapply Forall_impl; [|exact Z]. intros f. cbv beta. now rewrite Of.
  - right. split.
    + apply (slides _ _ _ St).
      destruct (Rle_lt_or_eq_dec 0 _ (Rows.size_nonneg (Rows.weights r') (Rows.slip r' d))) as [P|P]; [exact P|].
      exfalso. apply Exists_exists in NZ as (f & Hf & NZ). apply NZ.
      apply In_nth with (d := []) in Hf as (j & Lj & <-). rewrite firstn_length in Lj.
      assert (NT : nth j (firstn k (tl T)) [] = nth (S j) T []).
      { transitivity (nth j (tl T) []); [|destruct T; [destruct j; reflexivity|reflexivity]].
        rewrite <- (firstn_skipn k (tl T)) at 2. rewrite app_nth1; [reflexivity|]. rewrite firstn_length. lia. }
      rewrite NT. symmetry in P.
      assert (LW : (j < List.length (Rows.weights r'))%nat).
      { rewrite (is_weights _ _ _ _ _ _ I), map_length. unfold k in Lj. rewrite E in Lj.
        cbn [metric make_row] in Lj. rewrite map_length in Lj. lia. }
      apply Rmult_eq_reg_l with u; [|lra]. rewrite Rmult_0_r. rewrite <- Nth.
      apply (Rows.size_zero_nth (Rows.weights r')); [apply (weights_positive _ _ _ _ _ _ I)|exact P|exact LW].
    + apply Exists_exists in NZ as (f & Hf & NZ). apply Exists_exists. exists (of_motion f).
      split; [now apply in_map|]. now rewrite Of.
Qed.

Lemma split_covers s n bs x : is_leaf n = false -> split s n = inl bs -> solves s x ->
  exists b, In b bs /\ takes solves b x.
Proof.
  intros NL H S.
  destruct n as [i|i|a|name i c|y|y c fs|k]; cbn [split] in H; try discriminate NL.
  - destruct (numbered (rows s) i) as [row|] eqn:N; [|discriminate].
    destruct (negb (has_friction (box row))); [discriminate|].
    destruct (slip_certain row) eqn:SC; [|discriminate]. cbn [negb] in H.
    destruct (box_signed (box row)) eqn:Sg; injection H as <-.
    + set (f := first_tip (tau row)) in *. destruct (Rtotal_order (rdot f x) 0) as [P|[P|P]].
      * exists (above s (negative f)). split; [cbn; auto|]. apply takes_above; [exact S|].
        rewrite rdot_negative. lra.
      * exists (on_plane s f). split; [cbn; auto|]. constructor; cbn; [exact S| |constructor|constructor].
        constructor; [exact P|constructor].
      * exists (above s f). split; [cbn; auto|]. now apply takes_above.
    + destruct S as (sys & d & h & l & fs & t & -> & T0 & S & SL & Bd).
      destruct (numbered_is _ _ _ N) as (k & -> & NR).
      destruct (fits_at _ _ _ _ _ (rows_suit _ _ _ _ _ _ _ _ S) NR) as (r & Nr & Fr).
      destruct (slip_forms_zero row r d h l Fr SC Sg) as [Z|[NZ Z]].
      * eexists. split; [now left|]. constructor; cbn [branch_setting conditions new_strict new_moving];
          [now exists sys, d, h, l, fs, t| |constructor|constructor].
        apply Forall_map. eapply Forall_impl; [|exact Z]. intros f E. exact E.
      * eexists. split; [right; now left|].
        constructor; cbn [branch_setting conditions new_strict new_moving];
          [|constructor|constructor|constructor; [exact Z|constructor]].
        exists sys, d, h, l, fs, t. split; [reflexivity|]. split; [exact T0|]. split; [exact S|]. split; [|exact Bd].
        intros k' r' H Nr'. cbn in H. apply orb_true_iff in H as [H|H]; [|now apply (SL k' r')].
        apply Z.eqb_eq, Nat2Z.inj in H. subst k'. rewrite Nr in Nr'. injection Nr' as <-. exact NZ.
  - destruct (numbered (rows s) i) as [row|]; [|discriminate].
    destruct (box_spring (box row)); [discriminate|].
    destruct (separates row) as [f|]; [|discriminate]. injection H as <-. now apply (takes_side f).
  - injection H as <-. now apply takes_side.
  - destruct (halves s name i c) as [[lo hi]|] eqn:E; [|discriminate]. injection H as <-.
    destruct S as (sys & d & h & l & fs & t & X & T0 & S & SL & Bd).
    destruct (halves_cover _ _ _ _ _ _ _ sys d h l fs E S) as [(El & Eh & Pl & Ph & Bl & Bh) [S'|S']].
    + exists (Branch [] [] [] lo). split; [cbn; auto|]. constructor; cbn; try constructor.
      exists sys, d, h, l, fs, t. rewrite El, Pl, Bl. auto 6.
    + exists (Branch [] [] [] hi). split; [cbn; auto|]. constructor; cbn; try constructor.
      exists sys, d, h, l, fs, t. rewrite Eh, Ph, Bh. auto 6.
Qed.

Lemma leaf_refuted s strict rays y x :
  leaf_fails s strict rays y = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict ->
  solves s x -> False.
Proof.
  unfold leaf_fails. intros H G (ws & W & Sp) T (sys & d & h & l & fs & c & -> & C0 & S & SL & Bd).
  destruct (beyond_bound (the_bound s) strict rays) eqn:Be.
  { exact (nothing_beyond strict rays h l d ws (the_bound s) G T W Sp Bd Be). }
  rewrite orb_false_r in H. destruct (barred strict rays) eqn:B.
  { apply (not_barred strict rays (h :: l :: d) G T ws Sp rays); auto.
    eapply Forall_impl; [|exact W]. intros p [_ Hp]. right.
    apply in_map_iff in Hp as (q & Hq & Hin). exists q. auto. }
  set (y' := map _ y) in *. set (them := pressers _ _ _ _ _ _ _ _) in *.
  assert (FP : 0 < Q2R (unit_of (scaling_of y))).
  { rewrite unit_of_is by apply common_denominator_positive. apply unit_positive. }
  destruct ((_ && _) || _) eqn:C in H; [|discriminate].
  destruct (nowhere_negative rays _) eqn:N in H; [|discriminate]. clear H.
  assert (Yr : real y = Rows.scaled (unit (scaling_of y)) (map IZR y')).
  { unfold y', real, Rows.scaled. rewrite !map_map. apply map_ext_in. intros q Hq. now apply to_integer_exact. }
  set (more := map _ (of_rows y (known_push (pushes s)))) in *.
  assert (More : Rows.dot (real more) (h :: l :: d) =
    Rows.dot (map IZR y') (Degree.times (map real (known_push (pushes s))) (h :: l :: d))).
  { assert (Di : forall qs z, Rows.dot (real (map (fun q => reduced (q / unit_of (scaling_of y))%Q) qs)) z =
      / unit (scaling_of y) * Rows.dot (real qs) z).
    { assert (NZ : ~ (unit_of (scaling_of y) == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
      induction qs as [|q qs IH]; intros [|t z]; cbn; try ring. unfold real in IH. rewrite IH, reduced_same, Q2R_div by exact NZ.
      rewrite unit_of_is by apply common_denominator_positive. unfold Rdiv. ring. }
    unfold more. rewrite Di, Matrix.dot_of_rows, Yr, Rows.dot_scaled. pose proof (unit_positive y). field. lra. }
  assert (P : 0 <= pushed (pushes s) c (h :: l :: d) (map IZR y') + Rows.dot (real more) (h :: l :: d)).
  { rewrite More. unfold pushed. match goal with |- 0 <= ?a - ?b + ?b => replace (a - b + b) with a by ring end.
    apply (nowhere_negative_nonneg rays (h :: l :: d) ws W Sp) in N. set (along := of_rows y (a_multiple (pushes s))) in *.
    apply Rmult_le_pos; [exact C0|]. pose proof (unit_positive y) as Uy. pose proof (unit_positive along) as Ua.
    apply Rmult_le_reg_l with (unit (scaling_of y)); [exact Uy|]. rewrite Rmult_0_r, <- Rows.dot_scaled.
    rewrite <- Yr, <- Matrix.dot_of_rows. fold along. unfold real. rewrite <- qdot_is, (qdot_to_integers along) by auto.
    apply Rmult_le_pos; lra. }
  assert (L : forall m, leaf_holds_by m them (load_works (the_load s) (unit_of (scaling_of y)) y') more strict rays y' = true -> False).
  { intros m Hm. assert (Hm' := Hm). unfold leaf_holds_by in Hm'.
    apply andb_true_iff in Hm' as [M _]. apply andb_true_iff in M as [M _]. apply Z.ltb_lt in M. unfold them in Hm.
    rewrite (leaf_refutes strict rays d h l G T ws W Sp y' _ FP m M (rows s) (the_load s) _ (slipping s) sys fs more S SL P)
      in Hm. discriminate. }
  apply orb_true_iff in C as [C|C]; [|exact (L _ C)]. apply andb_true_iff in C as [_ C]. exact (L _ C).
Qed.

Lemma moving_refuted s strict rays y along brakes x :
  moving_fails s strict rays y along brakes = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict ->
  solves s x -> False.
Proof.
  unfold moving_fails. intros H G (ws & W & Sp) T (sys & d & h & l & fs & c & -> & C0 & S & SL & Bd).
  set (sc := scaling_of _) in *. set (c' := to_integer sc along) in *. set (y' := map (to_integer sc) y) in *.
  assert (FP : 0 < Q2R (unit_of sc)).
  { rewrite unit_of_is by apply common_denominator_positive. apply unit_positive. }
  destruct (carriers false _ _ _ _ _ _) as [cs|] eqn:C in H; [|discriminate].
  destruct (beyond_bound (the_bound s) strict rays) eqn:Be.
  { exact (nothing_beyond strict rays h l d ws (the_bound s) G T W Sp Bd Be). }
  rewrite orb_false_r in H. destruct (barred strict rays) eqn:B.
  { apply (not_barred strict rays (h :: l :: d) G T ws Sp rays); auto.
    eapply Forall_impl; [|exact W]. intros p [_ Hp]. right.
    apply in_map_iff in Hp as (q & Hq & Hin). exists q. auto. }
  destruct (_ && (_ || _)) eqn:M in H; [|discriminate].
  apply andb_true_iff in M as [M Ho]. apply andb_true_iff in M as [Kp Gr]. apply Nat.eqb_eq, length_zero_iff_nil in Kp.
  destruct (direction_holds _ _ _ _) eqn:D in H; [|discriminate].
  assert (Refuted : forall exact them cs', carriers exact (unit_of sc) rays them (rows s) 0 [] = Some cs' ->
    moving_holds strict rays (the_load s) c' y' (unit_of sc) cs' = false).
  { intros exact them cs' C'.
    apply (moving_refutes strict rays d h l G T ws W Sp c' y' (unit_of sc) FP exact (rows s) (the_load s)
      _ sys fs them cs' S); [|exact C'|exact Gr].
    unfold pushed. rewrite Kp. cbn [map]. unfold Degree.times at 2. cbn [map]. rewrite Degree.dot_nil, Rminus_0_r.
    apply Rmult_le_pos; [exact C0|]. exact (moves_along rays d h l ws W Sp c' y' _ D). }
  rewrite (Refuted false _ cs C) in Ho. destruct (carriers true _ _ _ _ _ _) as [cs'|] eqn:C' in Ho; [|discriminate].
  now rewrite (Refuted true _ cs' C') in Ho.
Qed.

Lemma Forall_separating (P : form -> Prop) rows before : Forall P before ->
  (forall r f, In r rows -> separates r = Some f -> box_spring (box r) = false -> P f) ->
  Forall P (separating rows before).
Proof.
  intros B H. unfold separating. rewrite rev_append_rev, app_nil_r, rev_append_rev, app_nil_r.
  apply Forall_rev. assert (B' : Forall P (rev before)) by now apply Forall_rev.
  revert B'. generalize (rev before). clear B.
  induction rows as [|r rows IH]; intros done D; cbn [fold_left]; [exact D|].
  apply IH; [intros; eapply H; eauto; now right|].
  destruct (separates r) as [f|] eqn:E; [|exact D]. destruct (box_spring (box r)) eqn:Sp; [exact D|].
  constructor; [|exact D]. apply (H r f); [now left|exact E|exact Sp].
Qed.

Lemma root_takes (two_sided : bool) s rng sys d lambda fs :
  solution (rows s) (the_load s) (pushed (pushes s) 0 (1 :: lambda :: d)) sys d 1 lambda fs ->
  slips_at (slipping s) (Rows.rows sys) d -> Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  good_bound (dimension_of s) (the_bound s) = true -> Rows.bounded (real_bound (the_bound s)) 1 d ->
  in_range rng lambda -> takes solves (root_branch two_sided s rng) (1 :: lambda :: d).
Proof.
  intros S SL Law Gb Bd R. set (x := 1 :: lambda :: d).
  destruct (range_conditions_met d rng lambda R) as [C T].
  assert (C' : Forall (fun f => meets x (f, false)) (range_conditions rng ++ bound_conditions (the_bound s))).
  { apply Forall_app. split; [exact C|]. apply (bound_conditions_met _ _ _ _ _ Gb Rle_0_1 Bd). }
  clear C. rename C' into C.
  constructor; cbn [branch_setting conditions new_strict new_moving root_branch];
    [| |exact T|constructor].
  { exists sys, d, 1, lambda, fs, 0. split; [reflexivity|]. split; [lra|]. split; [exact S|now split]. }
  rewrite map_all_is. apply Forall_map.
  destruct two_sided; [|exact C].
  apply (Forall_separating (fun f => meets x (f, false))); [exact C|].
  intros row f Hr E Sp. destruct S as [F _ _ _ _ Ob _]. rewrite Law in Ob.
  apply In_nth_error in Hr as (k & Hr).
  destruct (fits_at _ _ _ _ _ F Hr) as (r & Nr & [Er Se]).
  destruct (seen_stands _ _ Se) as (r' & j & p & G & mu & t & I & St & _).
  destruct (fits_at _ _ _ _ _ Ob Nr) as ([a g] & _ & (La & _)).
  unfold Rows.normal_law in La. rewrite <- (same_spring _ _ _ St), (is_spring _ _ _ _ _ _ I), Sp in La.
  destruct La as [_ V]. rewrite <- (same_pull j r r' d 1 lambda St) in V.
  unfold meets; cbn [snd fst]. rewrite Er in E.
  exact (separates_nonneg d 1 lambda (box row) r' p G mu t I f E V).
Qed.

(* What a leaf shows of a solution: nothing, as there is none, or what one that is held does. *)
Lemma end_shows held (shown : list R -> Prop) s strict rays n x :
  (forall k, held k rays = None -> spans (map coordinates rays) (fun a => rdot a x) -> shown x) ->
  is_leaf n = true -> end_fails held s strict rays n = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict ->
  solves s x -> shown x.
Proof.
  intros He Le H K Sp T S. destruct n; try discriminate Le; cbn in H.
  - exfalso. eapply leaf_refuted; eassumption.
  - exfalso. eapply moving_refuted; eassumption.
  - now apply (He piece).
Qed.

Lemma end_without_pieces s strict rays n x :
  is_leaf n = true -> end_fails no_pieces s strict rays n = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict -> solves s x -> False.
Proof. apply (end_shows no_pieces (fun _ => False)). discriminate. Qed.

End Proofs.

Section Refuting.
Variable advisor : oracle.

Definition walk_ranges (held : Z -> list ray -> option string) (most_depth : Z) (two_sided : bool) (s : setting)
    (ranges : list range) (nodes : list node) : option (string * nat) :=
  walk advisor setting split (end_fails held) most_depth nodes
    (map_all (fun g => root advisor setting (2 + dimension_of s) (root_branch two_sided s g)) ranges) 0.

Theorem ranges_shown held (shown : list R -> Prop) most (two_sided : bool) s ranges nodes sys lambda d fs :
  (forall k rays x, held k rays = None -> spans (map coordinates rays) (fun a => rdot a x) -> shown x) ->
  slipping s = [] -> good_bound (dimension_of s) (the_bound s) = true -> List.length d = dimension_of s ->
  walk_ranges held most two_sided s ranges nodes = None ->
  solution (rows s) (the_load s) (pushed (pushes s) 0 (1 :: lambda :: d)) sys d 1 lambda fs ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  Rows.bounded (real_bound (the_bound s)) 1 d ->
  Exists (fun r => in_range r lambda) ranges -> shown (1 :: lambda :: d).
Proof.
  intros He SE G D W S Law Bd X. apply Exists_exists in X as (rng & Hr & In_r).
  unfold walk_ranges in W. rewrite map_all_is in W.
  apply (walk_refutes advisor setting split (end_fails held) solves shown) in W.
  - rewrite Forall_forall in W. eapply W.
    + apply in_map_iff. now exists rng.
    + apply (root_home _ _ _ _ _ (1 :: lambda :: d)).
      * cbn. now rewrite D.
      * eapply root_takes; try eassumption. intros k r H. rewrite SE in H. discriminate.
  - intros s' n bs x. apply split_covers.
  - intros s' st rs n x. apply end_shows. intros k. apply He.
  - apply Forall_map, Forall_forall. intros r _. apply root_good.
Qed.

Theorem refuted_multiple most (two_sided : bool) s ranges nodes sys lambda d fs :
  slipping s = [] -> pushes s = no_push -> good_bound (dimension_of s) (the_bound s) = true ->
  List.length d = dimension_of s ->
  walk_ranges no_pieces most two_sided s ranges nodes = None ->
  solution (rows s) (the_load s) (fun _ => 0) sys d 1 lambda fs ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  Rows.bounded (real_bound (the_bound s)) 1 d ->
  Exists (fun r => in_range r lambda) ranges -> False.
Proof.
  intros SE PE G D W S Law Bd X. apply (ranges_shown no_pieces (fun _ => False) most two_sided s ranges nodes sys lambda d fs);
    try assumption; [discriminate|].
  destruct S as [S1 S2 S3 S4 S5 S6 S7]. constructor; try assumption. intros y. rewrite PE, not_pushed. apply S7.
Qed.

End Refuting.
