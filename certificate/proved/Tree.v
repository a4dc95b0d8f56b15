(* SPDX-License-Identifier: MIT *)
(* Trees in the plane (FORMAT.md sections 4 and 6): the children of nodes, leaves, and the roots of
   ranges of multiples.  `refuted_multiple`: where trees about ranges are accepted, no multiple
   in a range has an equilibrium. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf Walk.
From Proved Require Model.
Import ListNotations.

(* ---- Contacts by their number ---- *)

Section Numbered.
Open Scope Z_scope.

Fixpoint numbered {A} (l : list A) (i : Z) : option A :=
  match l with
  | [] => None
  | a :: l' => if i =? 0 then Some a else numbered l' (i - 1)
  end.

Fixpoint replace {A} (l : list A) (i : Z) (new : A) : list A :=
  match l with
  | [] => []
  | a :: l' => if i =? 0 then new :: l' else a :: replace l' (i - 1) new
  end.

End Numbered.

(* Values of lambda: from low to high, or from low on; and which ends are not among them. *)
Record range := Range {
  range_low : Q; range_high : option Q; open_low : bool; open_high : bool
}.

(* The box that a tree is about: rows, load, and two numbers M for leaves, a short one and one
   that makes them exact. *)
Record setting := Setting { rows : list row; the_load : load; short : Z; exact : Z }.

(* ---- Nodes ---- *)

Definition leaf_fails (s : setting) (strict : list (list form)) (rays : list ray) (y : list Q)
    : option string :=
  let y' := map (to_integer (scaling_of y)) y in
  let holds m := leaf_holds_by m (rows s) (the_load s) strict rays y' in
  if barred strict rays || holds (short s) || (negb (Z.eqb (short s) (exact s)) && holds (exact s))
  then None
  else Some "leaf-bound"%string.

Definition get (b : cbox) (name : parameter) : interval :=
  match name with
  | PX => box_x b
  | PY => box_y b
  | PTurn => box_turn b
  | PFriction => box_friction b
  | PPreload => box_preload b
  | _ => box_stiffness b
  end.

Definition set (b : cbox) (name : parameter) (i : interval) : cbox :=
  match b with
  | CBox x y t f p k nx ny g =>
      match name with
      | PX => CBox i y t f p k nx ny g
      | PY => CBox x i t f p k nx ny g
      | PTurn => CBox x y i f p k nx ny g
      | PFriction => CBox x y t i p k nx ny g
      | PPreload => CBox x y t f i k nx ny g
      | _ => CBox x y t f p i nx ny g
      end
  end.

Definition is_inside (i : interval) (c : Q) : bool :=
  negb (Qle_bool c (low i)) && negb (Qle_bool (high i) c).

Definition low_half (i : interval) (c : Q) := Interval (low i) c.
Definition high_half (i : interval) (c : Q) := Interval c (high i).

Definition set_row (s : setting) (index : Z) (b : cbox) : setting :=
  let row := make_row b in
  Setting (replace (rows s) index row) (the_load s) (short s)
    (Z.lcm (exact s) (over_weight row)).

Definition set_load (s : setting) (w : list interval) : setting :=
  let ld := make_load w (load_growth (the_load s)) in
  Setting (rows s) ld (short s) (Z.lcm (exact s) (over (load_scaling ld))).

(* The two halves of a box, or the rule that fails. *)
Definition halves (s : setting) (name : parameter) (index : Z) (c : Q)
    : (setting * setting) + string :=
  match name with
  | PZ => inr "part-contact"%string
  | PWrench =>
      match numbered (load_box (the_load s)) index with
      | None => inr "part-contact"%string
      | Some i =>
          if is_inside i c then
            inl (set_load s (replace (load_box (the_load s)) index (low_half i c)),
                 set_load s (replace (load_box (the_load s)) index (high_half i c)))
          else inr "part-inside"%string
      end
  | _ =>
      match numbered (rows s) index with
      | None => inr "part-contact"%string
      | Some row =>
          let i := get (box row) name in
          if is_inside i c then
            inl (set_row s index (set (box row) name (low_half i c)),
                 set_row s index (set (box row) name (high_half i c)))
          else inr "part-inside"%string
      end
  end.

(* f > 0 *)
Definition above (s : setting) (f : form) : branch setting := Branch [(f, false)] [f] [] s.
(* f >= 0 *)
Definition not_below (s : setting) (f : form) : branch setting := Branch [(f, false)] [] [] s.
(* f = 0 *)
Definition on_plane (s : setting) (f : form) : branch setting := Branch [(f, true)] [] [] s.

(* The children of a node, or the rule that fails. *)
Definition split (s : setting) (n : node) : list (branch setting) + string :=
  match n with
  | Leaf _ => inl []
  | Plane a =>
      let f := map (to_integer (scaling_of a)) a in
      inl [not_below s f; above s (negative f)]
  | Slip i =>
      match numbered (rows s) i with
      | None => inr "node-contact"%string
      | Some row =>
          if tau_certain row then
            let f := first_tip (tau row) in
            inl [above s f; on_plane s f; above s (negative f)]
          else inr "node-certain"%string
      end
  | Separation i =>
      match numbered (rows s) i with
      | None => inr "node-contact"%string
      | Some row =>
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

(* l - a h, after the coordinates of d *)
Definition l_above (d : nat) (a : Q) : form := repeat 0 d ++ [- Qnum a; Zpos (Qden a)].
Definition h_form (d : nat) : form := repeat 0 d ++ [1].

Definition range_conditions (d : nat) (g : range) : list form :=
  h_form d :: l_above d (range_low g) ::
  match range_high g with Some b => [negative (l_above d b)] | None => [] end.

Definition range_strict (d : nat) (g : range) : list form :=
  h_form d :: (if open_low g then [l_above d (range_low g)] else []) ++
  match range_high g with
  | Some b => if open_high g then [negative (l_above d b)] else []
  | None => []
  end.

Definition separating (rows : list row) : list form :=
  flat_map (fun r => match separates r with Some f => [f] | None => [] end) rows.

Definition root_branch (two_sided : bool) (s : setting) (g : range) : branch setting :=
  Branch
    (map (fun f => (f, false))
      (range_conditions 3 g ++ if two_sided then separating (rows s) else []))
    (range_strict 3 g) [] s.

End Root.

(* ---- Proofs ---- *)

Section Proofs.
Open Scope R_scope.

(* A part: which half may depend on the point, here on the contact of that number. *)
Lemma numbered_replace_either {A B} (P : A -> B -> Prop) l l' i a new new' :
  Forall2 P l l' -> numbered l i = Some a -> (forall b, P a b -> P new b \/ P new' b) ->
  Forall2 P (replace l i new) l' \/ Forall2 P (replace l i new') l'.
Proof.
  intros F. revert i. induction F as [|x y l l' Hxy F IH]; intros i; cbn; [discriminate|].
  destruct (Z.eqb i 0); intros E H.
  - injection E as ->. destruct (H _ Hxy); [left|right]; now constructor.
  - destruct (IH _ E H); [left|right]; now constructor.
Qed.

Lemma within_halves i c x : within i x -> within (low_half i c) x \/ within (high_half i c) x.
Proof. unfold within; cbn. intros [L H]. destruct (Rle_dec x (Q2R c)); [left|right]; lra. Qed.

Lemma set_inside b name c e k : inside b e k ->
  inside (set b name (low_half (get b name) c)) e k \/
  inside (set b name (high_half (get b name) c)) e k.
Proof.
  intros [X Y T F P K NX NY G F0]. destruct b as [bx by_ bt bf bp bk nx ny g].
  assert (K' := within_halves _ c _ K).
  destruct name; cbn in *;
    [ destruct (within_halves _ c _ X) as [H|H]
    | destruct (within_halves _ c _ Y) as [H|H]
    | destruct K' as [H|H]
    | destruct (within_halves _ c _ T) as [H|H]
    | destruct (within_halves _ c _ F) as [H|H]
    | destruct (within_halves _ c _ P) as [H|H]
    | destruct K' as [H|H]
    | destruct K' as [H|H] ]; [left|right|..]; try (left; constructor; cbn; assumption);
    try (right; constructor; cbn; assumption); constructor; cbn; assumption.
Qed.

Lemma halves_cover s name i c l h g lambda d forces : halves s name i c = inl (l, h) ->
  solution (rows s) (the_load s) g lambda d forces ->
  solution (rows l) (the_load l) g lambda d forces \/
  solution (rows h) (the_load h) g lambda d forces.
Proof.
  intros H [F LE LW LU L E].
  destruct name; cbn [halves] in H; try discriminate.
  7: {
    destruct (numbered (load_box (the_load s)) i) as [iv|] eqn:N; [|discriminate].
    destruct (is_inside iv c); [|discriminate]. injection H as <- <-. cbn.
    destruct (numbered_replace_either within (load_box (the_load s)) _ i iv (low_half iv c)
      (high_half iv c) LW N) as [F'|F']; [intros x; apply within_halves|left|right];
      constructor; cbn; try assumption; reflexivity. }
  all: destruct (numbered (rows s) i) as [row|] eqn:N; [|discriminate];
    destruct (is_inside _ c); [|discriminate]; injection H as <- <-; cbn;
    match goal with |- context [set _ ?name (low_half _ _)] =>
      destruct (numbered_replace_either fits (rows s) (Model.contacts g) i row
        (make_row (set (box row) name (low_half (get (box row) name) c)))
        (make_row (set (box row) name (high_half (get (box row) name) c))) F N) as [F'|F'];
      [intros k [_ (e & Ie)]; destruct (set_inside _ name c e k Ie); [left|right];
         (split; [reflexivity|now exists e])
      |left; constructor; assumption|right; constructor; assumption]
    end.
Qed.


Definition in_range (g : range) (lambda : R) :=
  Q2R (range_low g) <= lambda /\ (open_low g = true -> Q2R (range_low g) < lambda) /\
  match range_high g with
  | Some b => lambda <= Q2R b /\ (open_high g = true -> lambda < Q2R b)
  | None => True
  end.

Lemma rdot_zeros (x : list R) (a : form) d : (d <= List.length x)%nat ->
  rdot (repeat 0%Z d ++ a) x = rdot a (skipn d x).
Proof.
  revert x. induction d as [|d IH]; intros x L; cbn; [reflexivity|].
  destruct x as [|t x]; cbn in L; [lia|]. cbn. rewrite IH by lia. lra.
Qed.

(* x = (d, 1, lambda) *)
Definition ends_in (x : list R) (d : nat) (lambda : R) := skipn d x = [1; lambda].

Lemma ends_length x d lambda : ends_in x d lambda -> (d <= List.length x)%nat.
Proof.
  unfold ends_in. intros E. destruct (le_lt_dec d (List.length x)); [assumption|].
  rewrite skipn_all2 in E by lia. discriminate.
Qed.

Lemma l_above_at x d q lambda : ends_in x d lambda ->
  rdot (l_above d q) x = IZR (Zpos (Qden q)) * (lambda - Q2R q).
Proof.
  intros E. unfold l_above. rewrite rdot_zeros by (eapply ends_length; eassumption).
  rewrite E. unfold Q2R. cbn -[IZR]. rewrite opp_IZR. field.
  apply not_0_IZR. discriminate.
Qed.

Lemma range_conditions_met x d g lambda : ends_in x d lambda -> in_range g lambda ->
  Forall (fun f => 0 <= rdot f x) (range_conditions d g) /\
  Forall (fun f => rdot f x <> 0) (range_strict d g).
Proof.
  intros E (Lo & OLo & Hi). assert (PD : forall q : Q, 0 < IZR (Zpos (Qden q))) by (intros; apply IZR_lt; lia).
  assert (H1 : rdot (h_form d) x = 1).
  { unfold h_form. rewrite rdot_zeros by (eapply ends_length; eassumption). rewrite E. cbn. lra. }
  pose proof (PD (range_low g)). pose proof (l_above_at x d (range_low g) lambda E) as EL.
  split.
  - constructor; [lra|]. constructor; [rewrite EL; nra|].
    destruct (range_high g) as [b|]; [|constructor]. constructor; [|constructor].
    rewrite rdot_negative, (l_above_at x d b lambda E). pose proof (PD b). destruct Hi. nra.
  - constructor; [lra|]. apply Forall_app. split.
    + destruct (open_low g); constructor; [|constructor]. rewrite EL. specialize (OLo eq_refl). nra.
    + destruct (range_high g) as [b|]; [|constructor]. destruct Hi as [Hi OHi].
      destruct (open_high g); constructor; [|constructor].
      rewrite rdot_negative, (l_above_at x d b lambda E). specialize (OHi eq_refl).
      pose proof (PD b). nra.
Qed.

Lemma rdot_all_zero a x : all_zero a = true -> rdot a x = 0.
Proof.
  revert x; induction a as [|z a IH]; intros [|t x]; cbn -[Z.eqb]; try reflexivity.
  intros H. apply andb_true_iff in H as [Hz H]. apply Z.eqb_eq in Hz. subst z.
  rewrite IH by exact H. lra.
Qed.

Lemma rdot_primitive f x : rdot f x = IZR (content f) * rdot (primitive f) x.
Proof.
  unfold primitive. pose proof (content_divides f) as D. destruct (Z.eqb_spec (content f) 1) as [E|_].
  - rewrite E. lra.
  - revert D. generalize (content f) as c. intros c. revert x.
    induction f as [|z f IH]; intros [|t x] D; cbn; try lra.
    rewrite IH by (intros; apply D; now right).
    rewrite (D z) at 1 by now left. rewrite mult_IZR. ring.
Qed.

(* Where v is certain, the form that stands for it is not negative if v is not. *)
Lemma separates_nonneg row c d lambda f : fits row c -> separates row = Some f ->
  0 <= Model.v c lambda d -> 0 <= rdot f (located d 1 lambda).
Proof.
  intros [E (e & In_e)] S V. apply Rnot_lt_le. intros L.
  set (b := box row) in *. set (x := located d 1 lambda) in *.
  assert (Same : forall g, In g (pull_tips row) -> rdot (primitive g) x = rdot f x).
  { rewrite E in S. cbn [separates make_row] in S. unfold pull_tips. rewrite E.
    cbn [pulls make_row]. set (tips0 := List.concat _) in *.
    destruct (map primitive tips0) as [|f0 fs] eqn:M; [discriminate|].
    destruct (same_forms (f0 :: fs)) eqn:SF; [|discriminate]. injection S as ->.
    cbn in SF. rewrite forallb_forall in SF. intros g Hg. apply (in_map primitive) in Hg.
    rewrite M in Hg. destruct Hg as [<-|Hg]; [reflexivity|].
    specialize (SF _ Hg). pose proof (rdot_all_zero _ x SF) as Z. rewrite rdot_combine in Z. lra. }
  pose proof (v_as_pull d lambda c) as VP.
  assert (B : 1 * Model.v c lambda d <= unit (pull_scaling b) * rdot f x).
  { apply (v_bound d lambda b e c In_e). intros p k Hpk.
    rewrite Rmult_1_l. apply Rmult_le_compat_l; [left; apply pull_unit|].
    apply eval_most; [apply (shares_good b e c In_e)|]. intros g Hg.
    rewrite rdot_primitive, Same.
    - pose proof (content_positive g) as C. apply IZR_le with (n := 1%Z) in C || idtac.
      assert (1 <= IZR (content g)) by (apply IZR_le; lia). fold x. nra.
    - rewrite E. fold b. eapply pull_tip_in; [apply pull_in; eassumption | exact Hg]. }
  pose proof (pull_unit b). fold x in L. nra.
Qed.


(* ---- Solutions in the plane ---- *)

Definition solves (s : setting) (x : list R) :=
  exists g lambda d forces, x = located d 1 lambda /\
    solution (rows s) (the_load s) g lambda d forces.

Lemma split_covers s n bs x : (forall y, n <> Leaf y) -> split s n = inl bs -> solves s x ->
  exists b, In b bs /\ takes solves b x.
Proof.
  intros NL H S.
  destruct n as [i|i|a|name i c|y]; cbn in H.
  - destruct (numbered (rows s) i) as [row|]; [|discriminate].
    destruct (tau_certain row); [|discriminate]. set (f := first_tip (tau row)) in *.
    injection H as <-. destruct (Rtotal_order (rdot f x) 0) as [P|[P|P]].
    + exists (above s (negative f)). split; [cbn; auto|]. apply takes_above; [exact S|]. rewrite rdot_negative. lra.
    + exists (on_plane s f). split; [cbn; auto|]. constructor; cbn; [exact S| |constructor|constructor].
      constructor; [exact P|constructor].
    + exists (above s f). split; [cbn; auto|]. now apply takes_above.
  - destruct (numbered (rows s) i) as [row|]; [|discriminate].
    destruct (separates row) as [f|]; [|discriminate]. injection H as <-. now apply (takes_side f).
  - injection H as <-. now apply takes_side.
  - destruct (halves s name i c) as [[l h]|] eqn:E; [|discriminate]. injection H as <-.
    destruct S as (g & lambda & d & forces & X & S).
    destruct (halves_cover _ _ _ _ _ _ g lambda d forces E S) as [S'|S'].
    + exists (Branch [] [] [] l). split; [cbn; auto|]. constructor; cbn; try constructor.
      now exists g, lambda, d, forces.
    + exists (Branch [] [] [] h). split; [cbn; auto|]. constructor; cbn; try constructor.
      now exists g, lambda, d, forces.
  - now destruct (NL y).
Qed.

Lemma leaf_refuted s strict rays y x :
  leaf_fails s strict rays y = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict ->
  solves s x -> False.
Proof.
  unfold leaf_fails. intros H G (ws & W & Sp) T (g & lambda & d & forces & -> & S).
  destruct (_ || _ || _) eqn:C in H; [|discriminate]. clear H.
  assert (L : forall m, leaf_holds_by m (rows s) (the_load s) strict rays
                (map (to_integer (scaling_of y)) y) = true -> False).
  { intros m Hm. assert (Hm' := Hm). unfold leaf_holds_by in Hm'.
    set (z := map _ y) in *. destruct z as [|y1 [|y2 [|y3 [|? ?]]]]; try discriminate.
    apply andb_true_iff in Hm' as [M _]. apply Z.ltb_lt in M.
    rewrite (leaf_refutes strict rays d lambda G T ws W Sp y1 y2 y3 m M _ _ g forces S) in Hm.
    discriminate. }
  apply orb_true_iff in C as [C|C]; [apply orb_true_iff in C as [C|C]|].
  - apply (not_barred strict rays (located d 1 lambda) G T ws Sp rays); auto.
    eapply Forall_impl; [|exact W]. intros p [_ Hp]. right.
    apply in_map_iff in Hp as (q & Hq & Hin). exists q. auto.
  - exact (L _ C).
  - apply andb_true_iff in C as [_ C]. exact (L _ C).
Qed.

Lemma root_takes (two_sided : bool) s rng g lambda d forces :
  solution (rows s) (the_load s) g lambda d forces ->
  Model.normal g = (if two_sided then Model.bilateral else Model.unilateral) ->
  in_range rng lambda -> takes solves (root_branch two_sided s rng) (located d 1 lambda).
Proof.
  intros S Law R. set (x := located d 1 lambda).
  destruct (range_conditions_met x 3 rng lambda eq_refl R) as [C T].
  constructor; cbn [branch_setting conditions new_strict new_moving root_branch];
    [now exists g, lambda, d, forces| |exact T|constructor].
  apply Forall_map. apply Forall_app. split; [exact C|].
  destruct two_sided; [|constructor]. destruct S as [F _ _ _ _ [Ob _]]. rewrite Law in Ob.
  clear - F Ob. unfold separating. revert forces Ob. generalize (rows s) (Model.contacts g) F.
  clear F. intros rws cs F. induction F as [|row c rws cs Fc F IH]; intros fs Ob; [constructor|].
  inversion Ob as [|? [a b] ? fs' O1 O2]; subst. cbn [flat_map]. apply Forall_app.
  split; [|eapply IH; eassumption]. destruct (separates row) as [f|] eqn:E; constructor; [|constructor].
  unfold meets; cbn. eapply separates_nonneg; [exact Fc|exact E|]. apply O1.
Qed.

End Proofs.

Section Refuting.
Variable memory : Type.
Variable advisor : oracle memory.

Definition walk_ranges (most_depth : Z) (two_sided : bool) (s : setting) (ranges : list range)
    (nodes : list node) : option (string * nat) :=
  walk memory advisor setting split leaf_fails most_depth nodes
    (map (fun g => root memory advisor setting 5 (root_branch two_sided s g)) ranges) 0.

Theorem refuted_multiple most (two_sided : bool) s ranges nodes g lambda d forces :
  walk_ranges most two_sided s ranges nodes = None ->
  solution (rows s) (the_load s) g lambda d forces ->
  Model.normal g = (if two_sided then Model.bilateral else Model.unilateral) ->
  Exists (fun r => in_range r lambda) ranges -> False.
Proof.
  intros W S Law X. apply Exists_exists in X as (rng & Hr & In_r).
  apply (walk_refutes memory advisor setting split leaf_fails solves) in W.
  - rewrite Forall_forall in W. eapply W.
    + apply in_map_iff. now exists rng.
    + apply (root_home _ _ _ _ 5 _ (located d 1 lambda)); [reflexivity|].
      eapply root_takes; eassumption.
  - intros s' n bs x. apply split_covers.
  - intros s' st rs y x. apply leaf_refuted.
  - apply Forall_map, Forall_forall. intros r _. apply root_good.
Qed.

End Refuting.
