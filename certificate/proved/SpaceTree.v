(* SPDX-License-Identifier: MIT *)
(* Trees in space (FORMAT.md section 4): Tree.v for slips of three values, which have no sign, but are
   zero or not. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf Walk.
From Proved Require Tree.
From Proved Require Import SpaceBox SpaceLeaf.
From Proved Require Model SpaceModel.
Import ListNotations.

Module S := SpaceModel.

(* The box that a tree is about, and the contacts whose slip is strict. *)
Record setting := Setting { rows : list row; the_load : load; slipping : list Z }.

Definition leaf_fails (s : setting) (strict : list (list form)) (rays : list ray) (y : list Q)
    : option string :=
  if barred strict rays || leaf_holds (rows s) (the_load s) (slipping s) strict rays y then None
  else Some "leaf-bound"%string.

Definition get (b : cbox) (name : parameter) : interval :=
  match name with
  | PX => box_x b
  | PY => box_y b
  | PZ => box_z b
  | PFriction => box_friction b
  | PPreload => box_preload b
  | _ => box_stiffness b
  end.

Definition set (b : cbox) (name : parameter) (i : interval) : cbox :=
  match b with
  | CBox x y z f p k nx ny nz =>
      match name with
      | PX => CBox i y z f p k nx ny nz
      | PY => CBox x i z f p k nx ny nz
      | PZ => CBox x y i f p k nx ny nz
      | PFriction => CBox x y z i p k nx ny nz
      | PPreload => CBox x y z f i k nx ny nz
      | _ => CBox x y z f p i nx ny nz
      end
  end.

Definition set_row (s : setting) (index : Z) (b : cbox) : setting :=
  Setting (Tree.replace (rows s) index (make_row b)) (the_load s) (slipping s).

Definition set_load (s : setting) (w : list interval) : setting :=
  Setting (rows s) (make_load w (load_growth (the_load s))) (slipping s).

Definition halves (s : setting) (name : parameter) (index : Z) (c : Q)
    : (setting * setting) + string :=
  match name with
  | PTurn =>  (* normals are certain here *)
      match Tree.numbered (rows s) index with
      | None => inr "part-contact"%string
      | Some _ => inr "part-inside"%string
      end
  | PWrench =>
      match Tree.numbered (load_box (the_load s)) index with
      | None => inr "part-contact"%string
      | Some i =>
          if Tree.is_inside i c then
            inl (set_load s (Tree.replace (load_box (the_load s)) index (Tree.low_half i c)),
                 set_load s (Tree.replace (load_box (the_load s)) index (Tree.high_half i c)))
          else inr "part-inside"%string
      end
  | _ =>
      match Tree.numbered (rows s) index with
      | None => inr "part-contact"%string
      | Some row =>
          let i := get (box row) name in
          if Tree.is_inside i c then
            inl (set_row s index (set (box row) name (Tree.low_half i c)),
                 set_row s index (set (box row) name (Tree.high_half i c)))
          else inr "part-inside"%string
      end
  end.

Definition above (s : setting) (f : form) : branch setting := Branch [(f, false)] [f] [] s.
Definition not_below (s : setting) (f : form) : branch setting := Branch [(f, false)] [] [] s.

Definition slip_forms (row : row) : list form :=
  let t := first_tip (geometry row) in [nth 1 t []; nth 2 t []; nth 3 t []].

Definition split (s : setting) (n : node) : list (branch setting) + string :=
  match n with
  | Leaf _ => inl []
  | Plane a =>
      let f := map (to_integer (scaling_of a)) a in
      inl [not_below s f; above s (negative f)]
  | Slip i =>
      match Tree.numbered (rows s) i with
      | None => inr "node-contact"%string
      | Some row =>
          if slip_certain row then
            let fs := slip_forms row in
            inl [Branch (map (fun f => (f, true)) fs) [] [] s;
                 Branch [] [] [fs] (Setting (rows s) (the_load s) (i :: slipping s))]
          else inr "node-certain"%string
      end
  | Separation i =>
      match Tree.numbered (rows s) i with
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

Definition separating (rows : list row) : list form :=
  flat_map (fun r => match separates r with Some f => [f] | None => [] end) rows.

Definition root_branch (two_sided : bool) (s : setting) (g : Tree.range) : branch setting :=
  Branch
    (map (fun f => (f, false))
      (Tree.range_conditions 6 g ++ if two_sided then separating (rows s) else []))
    (Tree.range_strict 6 g) [] s.

(* ---- Proofs ---- *)

Section Proofs.
Open Scope R_scope.

Lemma set_inside b name c k : inside b k ->
  inside (set b name (Tree.low_half (get b name) c)) k \/
  inside (set b name (Tree.high_half (get b name) c)) k.
Proof.
  intros [X Y Z F P K NN G F0 SP LS LP]. destruct b as [bx by_ bz bf bp bk nx ny nz].
  assert (K' := Tree.within_halves _ c _ K).
  destruct name; cbn in *;
    [ destruct (Tree.within_halves _ c _ X) as [H|H]
    | destruct (Tree.within_halves _ c _ Y) as [H|H]
    | destruct (Tree.within_halves _ c _ Z) as [H|H]
    | destruct K' as [H|H]
    | destruct (Tree.within_halves _ c _ F) as [H|H]
    | destruct (Tree.within_halves _ c _ P) as [H|H]
    | destruct K' as [H|H]
    | destruct K' as [H|H] ]; try (left; constructor; cbn; assumption);
    try (right; constructor; cbn; assumption).
Qed.

Lemma halves_cover s name i c l h g lambda d forces : halves s name i c = inl (l, h) ->
  solution (rows s) (the_load s) g lambda d forces ->
  (slipping l = slipping s /\ slipping h = slipping s) /\
  (solution (rows l) (the_load l) g lambda d forces \/
   solution (rows h) (the_load h) g lambda d forces).
Proof.
  intros H [F LE LW LU L E].
  destruct name; cbn [halves] in H; try discriminate.
  4: destruct (Tree.numbered (rows s) i); discriminate.
  7: {
    destruct (Tree.numbered (load_box (the_load s)) i) as [iv|] eqn:N; [|discriminate].
    destruct (Tree.is_inside iv c); [|discriminate]. injection H as <- <-. cbn. split; [auto|].
    destruct (Tree.numbered_replace_either within (load_box (the_load s)) _ i iv (Tree.low_half iv c)
      (Tree.high_half iv c) LW N) as [F'|F']; [intros x; apply Tree.within_halves|left|right];
      constructor; cbn; try assumption; reflexivity. }
  all: destruct (Tree.numbered (rows s) i) as [row|] eqn:N; [|discriminate];
    destruct (Tree.is_inside _ c); [|discriminate]; injection H as <- <-; cbn; split; [auto|];
    match goal with |- context [set _ ?name (Tree.low_half _ _)] =>
      destruct (Tree.numbered_replace_either fits (rows s) (S.contacts g) i row
        (make_row (set (box row) name (Tree.low_half (get (box row) name) c)))
        (make_row (set (box row) name (Tree.high_half (get (box row) name) c))) F N) as [F'|F'];
      [intros k [_ Ie]; destruct (set_inside _ name c k Ie); [left|right];
         (split; [reflexivity|assumption])
      |left; constructor; assumption|right; constructor; assumption]
    end.
Qed.

Definition solves (s : setting) (x : list R) :=
  exists g lambda d forces, x = located d 1 lambda /\
    solution (rows s) (the_load s) g lambda d forces /\ slips_at (slipping s) (S.contacts g) d.

Lemma numbered_is {A} (l : list A) i a k : Tree.numbered l i = Some a -> i = Z.of_nat k ->
  nth_error l k = Some a.
Proof.
  revert i k. induction l as [|b l IH]; intros i k H E; cbn in H; [discriminate|].
  destruct (Z.eqb_spec i 0) as [Z|Z].
  - assert (k = 0%nat) by lia. subst k. exact H.
  - destruct k as [|k]; [lia|]. cbn. apply (IH (i - 1)%Z k H). lia.
Qed.

Lemma fits_at rws cs k row c : Forall2 fits rws cs -> nth_error rws k = Some row ->
  nth_error cs k = Some c -> fits row c.
Proof.
  intros F. revert k. induction F as [|r0 c0 rws cs H F IH]; intros [|k]; cbn; try discriminate.
  - intros E1 E2. injection E1 as <-. injection E2 as <-. exact H.
  - apply IH.
Qed.

Lemma same_length rws cs : Forall2 fits rws cs -> List.length rws = List.length cs.
Proof. induction 1; cbn; congruence. Qed.

(* Where p is certain, the slip is zero where its forms are. *)
Lemma slip_forms_zero row c d lambda : fits row c -> slip_certain row = true ->
  (S.slip c d = S.zero /\ Forall (fun f => rdot f (located d 1 lambda) = 0) (slip_forms row)) \/
  (S.slip c d <> S.zero /\ not_zero (located d 1 lambda) (slip_forms row)).
Proof.
  intros [E I] C. assert (SS : shares_in (box row) c = []).
  { rewrite E in C. cbn [slip_certain make_row] in C. rewrite !andb_true_iff in C.
    destruct C as [[C1 C2] C3]. unfold shares_in, share. now rewrite C1, C2, C3. }
  set (u := unit (scaling_of_geometry (box row))).
  assert (U : 0 < u) by apply unit_positive.
  pose proof (slip_corners (box row) c I 0 d 1 lambda ltac:(lia)) as X.
  pose proof (slip_corners (box row) c I 1 d 1 lambda ltac:(lia)) as Y.
  pose proof (slip_corners (box row) c I 2 d 1 lambda ltac:(lia)) as Z.
  rewrite SS, eval_first, <- E in X, Y, Z. cbn [component] in X, Y, Z. fold u in X, Y, Z.
  unfold slip_forms. set (t := first_tip (geometry row)) in *. set (x := located d 1 lambda) in *.
  destruct (S.slip c d) as [s1 s2 s3]. cbn [S.x S.y S.z] in *.
  assert (X' : s1 = u * rdot (nth 1 t []) x) by exact X.
  assert (Y' : s2 = u * rdot (nth 2 t []) x) by exact Y.
  assert (Z' : s3 = u * rdot (nth 3 t []) x) by exact Z. clear X Y Z.
  destruct (Req_dec (rdot (nth 1 t []) x) 0) as [Z1|Z1];
    [destruct (Req_dec (rdot (nth 2 t []) x) 0) as [Z2|Z2];
      [destruct (Req_dec (rdot (nth 3 t []) x) 0) as [Z3|Z3]|]|].
  - left. split; [|repeat constructor; assumption].
    rewrite Z1 in X'. rewrite Z2 in Y'. rewrite Z3 in Z'. rewrite Rmult_0_r in X', Y', Z'.
    now rewrite X', Y', Z'.
  - right. split; [|right; right; left; exact Z3]. intros H. injection H as _ _ H. rewrite Z' in H.
    apply Rmult_integral in H as [H|H]; [lra|contradiction].
  - right. split; [|right; left; exact Z2]. intros H. injection H as _ H _. rewrite Y' in H.
    apply Rmult_integral in H as [H|H]; [lra|contradiction].
  - right. split; [|left; exact Z1]. intros H. injection H as H _ _. rewrite X' in H.
    apply Rmult_integral in H as [H|H]; [lra|contradiction].
Qed.

Lemma split_covers s n bs x : (forall y, n <> Leaf y) -> split s n = inl bs -> solves s x ->
  exists b, In b bs /\ takes solves b x.
Proof.
  intros NL H S.
  destruct n as [i|i|a|name i c|y]; cbn in H.
  - destruct (Tree.numbered (rows s) i) as [row|] eqn:N; [|discriminate].
    destruct (slip_certain row) eqn:SC; [|discriminate]. injection H as <-.
    destruct S as (g & lambda & d & forces & -> & S & SL).
    assert (Row : exists k, i = Z.of_nat k).
    { clear - N. revert i N. induction (rows s) as [|b l IH]; intros i N; cbn in N; [discriminate|].
      destruct (Z.eqb_spec i 0) as [Z|Z]; [exists 0%nat; lia|].
      destruct (IH _ N) as (k & E). exists (Datatypes.S k). lia. }
    destruct Row as (k & ->). pose proof (numbered_is _ _ _ k N eq_refl) as NR.
    assert (Hc : exists c, nth_error (S.contacts g) k = Some c).
    { destruct (nth_error (S.contacts g) k) as [c|] eqn:NC; [now exists c|].
      apply nth_error_None in NC. pose proof (same_length _ _ (contacts_fit _ _ _ _ _ _ S)) as L.
      rewrite <- L in NC. apply nth_error_None in NC. congruence. }
    destruct Hc as (c & NC). pose proof (fits_at _ _ _ _ _ (contacts_fit _ _ _ _ _ _ S) NR NC) as Fc.
    destruct (slip_forms_zero row c d lambda Fc SC) as [[_ Z]|[NZ Z]].
    + eexists. split; [now left|]. constructor; cbn [branch_setting conditions new_strict new_moving];
        [now exists g, lambda, d, forces| |constructor|constructor].
      unfold slip_forms in Z. inversion Z as [|? ? Z1 Za]; subst. inversion Za as [|? ? Z2 Zb]; subst.
      inversion Zb as [|? ? Z3 _]; subst.
      constructor; [exact Z1|]. constructor; [exact Z2|]. constructor; [exact Z3|constructor].
    + eexists. split; [right; now left|].
      constructor; cbn [branch_setting conditions new_strict new_moving];
        [|constructor|constructor|constructor; [exact Z|constructor]].
      exists g, lambda, d, forces. split; [reflexivity|]. split; [exact S|].
      intros k' c' H NC'. cbn in H. apply orb_true_iff in H as [H|H]; [|now apply (SL k' c')].
      apply Z.eqb_eq, Nat2Z.inj in H. subst k'. rewrite NC in NC'. injection NC' as <-. exact NZ.
  - destruct (Tree.numbered (rows s) i) as [row|]; [|discriminate].
    destruct (separates row) as [f|]; [|discriminate]. injection H as <-. now apply (takes_side f).
  - injection H as <-. now apply takes_side.
  - destruct (halves s name i c) as [[l h]|] eqn:E; [|discriminate]. injection H as <-.
    destruct S as (g & lambda & d & forces & X & S & SL).
    destruct (halves_cover _ _ _ _ _ _ g lambda d forces E S) as [[El Eh] [S'|S']].
    + exists (Branch [] [] [] l). split; [cbn; auto|]. constructor; cbn; try constructor.
      exists g, lambda, d, forces. rewrite El. auto.
    + exists (Branch [] [] [] h). split; [cbn; auto|]. constructor; cbn; try constructor.
      exists g, lambda, d, forces. rewrite Eh. auto.
  - now destruct (NL y).
Qed.

Lemma leaf_refuted s strict rays y x :
  leaf_fails s strict rays y = None -> Forall (knows strict) rays ->
  spans (map coordinates rays) (fun a => rdot a x) -> Forall (not_zero x) strict ->
  solves s x -> False.
Proof.
  unfold leaf_fails. intros H G Sp T (g & lambda & d & forces & -> & S & SL).
  destruct (_ || _) eqn:C in H; [|discriminate]. clear H. apply orb_true_iff in C as [C|C].
  - destruct Sp as (ws & W & Sp). apply (not_barred strict rays (located d 1 lambda) G T ws Sp rays); auto.
    eapply Forall_impl; [|exact W]. intros p [_ Hp]. right.
    apply in_map_iff in Hp as (q & Hq & Hin). exists q. auto.
  - rewrite (leaf_refutes strict rays _ _ _ y g lambda d forces G Sp T S SL) in C. discriminate.
Qed.

Lemma separates_nonneg row c d lambda f : fits row c -> separates row = Some f ->
  0 <= S.v c lambda d -> 0 <= rdot f (located d 1 lambda).
Proof.
  intros [E I] S V. apply Rnot_lt_le. intros L. set (x := located d 1 lambda) in *.
  assert (Same : forall g, In g (pull_tips row) -> rdot (primitive g) x = rdot f x).
  { rewrite E in S. cbn [separates make_row] in S. unfold pull_tips. rewrite E.
    cbn [pulls make_row]. set (tips0 := List.concat _) in *.
    destruct (map primitive tips0) as [|f0 fs] eqn:M; [discriminate|].
    destruct (same_forms (f0 :: fs)) eqn:SF; [|discriminate]. injection S as ->.
    cbn in SF. rewrite forallb_forall in SF. intros g Hg. apply (in_map primitive) in Hg.
    rewrite M in Hg. destruct Hg as [<-|Hg]; [reflexivity|].
    specialize (SF _ Hg). pose proof (Tree.rdot_all_zero _ x SF) as Z. rewrite rdot_combine in Z. lra. }
  assert (B : 1 * S.v c lambda d <= unit (pull_scaling (box row)) * rdot f x).
  { apply (v_bound d lambda (box row) c I). intros g Hg. rewrite <- E in Hg.
    rewrite Rmult_1_l. apply Rmult_le_compat_l; [left; apply unit_positive|].
    fold x. rewrite Tree.rdot_primitive, (Same g Hg).
    pose proof (content_positive g). assert (1 <= IZR (content g)) by (apply IZR_le; lia). nra. }
  assert (0 < unit (pull_scaling (box row))) by apply unit_positive. nra.
Qed.

Lemma root_takes (two_sided : bool) s rng g lambda d forces : slipping s = [] ->
  solution (rows s) (the_load s) g lambda d forces ->
  S.normal_law g = (if two_sided then Model.bilateral else Model.unilateral) ->
  Tree.in_range rng lambda -> takes solves (root_branch two_sided s rng) (located d 1 lambda).
Proof.
  intros SE S Law R. set (x := located d 1 lambda).
  destruct (Tree.range_conditions_met x 6 rng lambda eq_refl R) as [C T].
  constructor; cbn [branch_setting conditions new_strict new_moving root_branch].
  - exists g, lambda, d, forces. split; [reflexivity|]. split; [exact S|]. rewrite SE. discriminate.
  - apply Forall_map. apply Forall_app. split; [exact C|].
    destruct two_sided; [|constructor]. destruct S as [F _ _ _ _ [Ob _]]. rewrite Law in Ob.
    clear - F Ob. unfold separating. revert forces Ob. generalize (rows s) (S.contacts g) F.
    clear F. intros rws cs F. induction F as [|row c rws cs Fc F IH]; intros fs Ob; [constructor|].
    inversion Ob as [|? [a b] ? fs' O1 O2]; subst. cbn [flat_map]. apply Forall_app.
    split; [|eapply IH; eassumption]. destruct (separates row) as [f|] eqn:E; constructor; [|constructor].
    unfold meets; cbn. eapply separates_nonneg; [exact Fc|exact E|]. apply O1.
  - exact T.
  - constructor.
Qed.

End Proofs.

Section Refuting.
Variable memory : Type.
Variable advisor : oracle memory.

Definition walk_ranges (most_depth : Z) (two_sided : bool) (s : setting) (ranges : list Tree.range)
    (nodes : list node) : option (string * nat) :=
  walk memory advisor setting split leaf_fails most_depth nodes
    (map (fun g => root memory advisor setting 8 (root_branch two_sided s g)) ranges) 0.

Theorem refuted_multiple most (two_sided : bool) s ranges nodes g lambda d forces :
  slipping s = [] -> walk_ranges most two_sided s ranges nodes = None ->
  solution (rows s) (the_load s) g lambda d forces ->
  S.normal_law g = (if two_sided then Model.bilateral else Model.unilateral) ->
  Exists (fun r => Tree.in_range r lambda) ranges -> False.
Proof.
  intros SE W S Law X. apply Exists_exists in X as (rng & Hr & In_r).
  apply (walk_refutes memory advisor setting split leaf_fails solves) in W.
  - rewrite Forall_forall in W. eapply W.
    + apply in_map_iff. now exists rng.
    + apply (root_home _ _ _ _ 8 _ (located d 1 lambda)); [reflexivity|].
      eapply root_takes; eassumption.
  - intros s' n bs x. apply split_covers.
  - intros s' st rs y x. apply leaf_refuted.
  - apply Forall_map, Forall_forall. intros r _. apply root_good.
Qed.

End Refuting.
