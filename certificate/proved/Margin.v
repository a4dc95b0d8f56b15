(* SPDX-License-Identifier: MIT *)
(* Margins (FORMAT.md section 5): points prove which multiples are resisted, and trees that others are not.
   In the plane points are segments, and the trees are about the gaps between them (`segments_resist`,
   `gaps_cover`); else they are claims (Correct.v, `claims_true`). *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load Bound Lists Question Cone Meaning Numbers Root Box Leaf Tree Witness.
From Proved Require Rows Model.
Import ListNotations.

(* ---- Points with rational coordinates ---- *)

Section Checker.

Definition coordinates_of (p : point) : list Q :=
  match multiple p with Some l => [1%Q; l] | None => [0%Q; 1%Q] end ++ twist (point_witness p).

Definition integer_point (p : point) : form :=
  map (to_integer (scaling_of (coordinates_of p))) (coordinates_of p).

Variable two_sided : bool.
Variable dim : nat.
Variable rows : list row.
Variable ld : load.
Variable bound : option (list Q).
(* The rules of a segment by degree, from a multiple to another or without end: the one that fails, and the node. *)
Variable degree : Q -> option Q -> list Q -> list Q -> list (list Q) -> list (list Q) -> list node ->
  option (string * option nat).
(* Whether there is no load and no preload but what grows. *)
Variable unloaded : bool.

Definition check_at (p : point) : list state + string :=
  if point_within bound (integer_point p) then
    check_point two_sided dim rows ld (integer_point p) (shares (point_witness p))
  else inr "witness-bound"%string.

Definition Qlt_bool (a b : Q) : bool := negb (Qle_bool b a).

(* Whether an interval's end is passed; reached. *)
Definition beyond (high to : option Q) : bool :=
  match high, to with
  | None, _ => false
  | Some _, None => true
  | Some h, Some t => Qlt_bool h t
  end.

Definition reaches (high to : option Q) : bool :=
  match high, to with
  | None, None => true
  | Some h, Some t => Qeq_bool h t
  | _, _ => false
  end.

(* `segment-chain`, and the rules of points.  `from`: where the segment before ended, unless that was
   the end of an interval; `last`: its last point. *)
Fixpoint segments_fail (segments : list segment) (resisted : list (Q * option Q))
    (from : option Q) (last : option (point * list state)) (number : nat)
    : option (string * place) :=
  let out_of_chain := Some ("segment-chain"%string, AtSegment number None) in
  match segments, resisted with
  | [], [] => None
  | [], _ :: _ => out_of_chain
  | _ :: _, [] => out_of_chain
  | SegmentByDegree to d1 d2 walls direction tree :: segments', (lo, hi) :: resisted' =>
      let start := match from with Some e => e | None => lo end in
      let goes_up := match to with Some t => Qlt_bool start t | None => Qlt_bool 0 start || (Qeq_bool start 0 && unloaded) end in
      if negb goes_up || beyond hi to then out_of_chain
      else
        match degree start to d1 d2 walls direction tree with
        | Some (rule, node) => Some (rule, AtSegment number node)
        | None =>
            if reaches hi to then segments_fail segments' resisted' None None (S number)
            else segments_fail segments' resisted to None (S number)
        end
  | Segment first_point second :: segments', (lo, hi) :: resisted' =>
      let first := match first_point with
                   | Some p => Some (p, check_at p)
                   | None => match last with
                             | Some (p, ss) => Some (p, inl ss)
                             | None => None
                             end
                   end in
      match first with
      | None => out_of_chain
      | Some (p, checked) =>
          match multiple p with
          | None => out_of_chain
          | Some l1 =>
              let start := match from with Some e => e | None => lo end in
              if negb (Qeq_bool l1 start) || beyond hi (multiple second) ||
                 match multiple second with Some l2 => Qlt_bool l2 l1 | None => false end
              then out_of_chain
              else
                match checked with
                | inr rule => Some (rule, AtPoint number false)
                | inl ss1 =>
                    match check_at second with
                    | inr rule => Some (rule, AtPoint number true)
                    | inl ss2 =>
                        if same_mode ss1 ss2 then
                          if reaches hi (multiple second) then
                            segments_fail segments' resisted' None (Some (second, ss2)) (S number)
                          else
                            segments_fail segments' resisted (multiple second)
                              (Some (second, ss2)) (S number)
                        else Some ("segment-mode"%string, AtSegment number None)
                    end
                end
          end
      end
  end.

End Checker.

(* `resisted-order`: the number of the interval that is out of order. *)
Fixpoint order_fails (least : option Q) (first : bool) (resisted : list (Q * option Q))
    (number : nat) : option nat :=
  match resisted with
  | [] => None
  | (lo, hi) :: resisted' =>
      let starts := match least with
                    | Some q => if first then Qle_bool q lo else Qlt_bool q lo
                    | None => false
                    end in
      let ends := match hi with Some h => Qle_bool lo h | None => true end in
      if starts && ends then order_fails hi false resisted' (S number) else Some number
  end.

(* What the intervals leave, from some number on; after the ranges before, which are in reverse order. *)
Fixpoint gaps_from (from : Q) (open : bool) (resisted : list (Q * option Q)) (before : list range) : list range :=
  match resisted with
  | [] => rev_append (Range from None open true :: before) []
  | (lo, hi) :: resisted' =>
      let now := if Qlt_bool from lo then Range from (Some lo) open true :: before else before in
      match hi with
      | Some h => gaps_from h true resisted' now
      | None => rev_append now []
      end
  end.

Definition gaps (resisted : list (Q * option Q)) : list range := gaps_from 0 false resisted [].

(* ---- Proofs ---- *)

Section Proofs.
Open Scope R_scope.

Lemma Qlt_bool_R a b : Qlt_bool a b = true -> Q2R a < Q2R b.
Proof.
  unfold Qlt_bool. intros H. apply negb_true_iff in H. apply Rnot_le_lt. intros L.
  apply Rle_Qle, Qle_bool_iff in L. congruence.
Qed.

Lemma Qlt_bool_false_R a b : Qlt_bool a b = false -> Q2R b <= Q2R a.
Proof. unfold Qlt_bool. intros H. apply negb_false_iff in H. now apply Qle_bool_R. Qed.

Lemma Qeq_bool_R a b : Qeq_bool a b = true -> Q2R a = Q2R b.
Proof. intros H. now apply Qeq_eqR, Qeq_bool_eq. Qed.

Lemma gaps_keep (P : range -> Prop) from open resisted before : Exists P before ->
  Exists P (gaps_from from open resisted before).
Proof.
  revert from open before. induction resisted as [|[lo hi] resisted IH]; intros from open before B; cbn [gaps_from].
  - rewrite rev_append_rev, app_nil_r. apply Exists_rev. now apply Exists_cons_tl.
  - set (now := if Qlt_bool from lo then _ else before).
    assert (N : Exists P now) by (unfold now; destruct (Qlt_bool from lo); [now apply Exists_cons_tl|exact B]).
    destruct hi as [h|]; [now apply IH|]. rewrite rev_append_rev, app_nil_r. now apply Exists_rev.
Qed.

(* Every multiple from `from` on is in an interval or in a gap. *)
Lemma gaps_from_cover from open resisted before lambda :
  Q2R from <= lambda -> (open = true -> Q2R from < lambda) ->
  Exists (among lambda) resisted \/ Exists (fun g => in_range g lambda) (gaps_from from open resisted before).
Proof.
  revert from open before. induction resisted as [|[lo hi] resisted IH]; intros from open before L O; cbn [gaps_from].
  - right. rewrite rev_append_rev, app_nil_r. apply Exists_rev. constructor. unfold in_range; cbn. auto.
  - destruct (Rlt_dec lambda (Q2R lo)) as [B|B].
    + right. assert (H : Qlt_bool from lo = true).
      { unfold Qlt_bool. apply negb_true_iff. apply not_true_is_false. intros H.
        apply Qle_bool_R in H. lra. }
      rewrite H. set (now := _ :: before).
      assert (N : Exists (fun g => in_range g lambda) now).
      { apply Exists_cons_hd. unfold in_range; cbn. repeat split; auto; lra. }
      destruct hi as [h|]; [now apply gaps_keep|]. rewrite rev_append_rev, app_nil_r. now apply Exists_rev.
    + destruct hi as [h|].
      * destruct (Rle_dec lambda (Q2R h)) as [A|A].
        -- left. apply Exists_cons_hd. unfold among; cbn. lra.
        -- destruct (IH h true (if Qlt_bool from lo then Range from (Some lo) open true :: before else before))
             as [E|E]; [lra|intros; lra| |right; exact E]. left. now apply Exists_cons_tl.
      * left. apply Exists_cons_hd. unfold among; cbn. split; [lra|trivial].
Qed.

Theorem gaps_cover resisted lambda : 0 <= lambda ->
  Exists (among lambda) resisted \/ Exists (fun g => in_range g lambda) (gaps resisted).
Proof. intros H. apply gaps_from_cover; rewrite Q2R_0; [exact H|discriminate]. Qed.

Variable two_sided : bool.
Variable rows : list row.
Variable ld : load.
Variable bound : option (list Q).
Variable s : Rows.system.
Hypothesis F : Forall2 fits rows (Rows.rows s).
Hypothesis E : exact_rows rows = true.
Hypothesis L : exact_load ld s.
Hypothesis Law : Rows.normal s = if two_sided then Model.bilateral else Model.unilateral.
Let dim := Rows.dimension s.
Notation real := (map IZR).

(* A point that is accepted, as it is in integers. *)
Lemma accepted_point p ss : check_at two_sided dim rows ld bound p = inl ss ->
  exists h l ds ss' u, 0 < u /\ ss = rev ss' /\
    all_states (h :: l :: ds) rows (Rows.rows s) ss' /\
    Rows.equilibrium s (real ds) (IZR h) (IZR l) (forces rows ss') /\
    Rows.bounded (real_bound bound) (IZR h) (real ds) /\
    match multiple p with
    | Some lambda => u * IZR h = 1 /\ u * IZR l = Q2R lambda
    | None => u * IZR h = 0 /\ u * IZR l = 1
    end.
Proof.
  unfold check_at. destruct (point_within bound (integer_point p)) eqn:Within; [|discriminate].
  unfold integer_point in *. intros C. set (qs := coordinates_of p) in *. set (sc := scaling_of qs) in *.
  assert (X : forall q, In q qs -> unit sc * IZR (to_integer sc q) = Q2R q)
    by (intros; symmetry; now apply to_integer_exact).
  assert (P : exists h l, qs = h :: l :: twist (point_witness p) /\
    match multiple p with Some lambda => h = 1%Q /\ l = lambda | None => h = 0%Q /\ l = 1%Q end).
  { unfold qs, coordinates_of. destruct (multiple p) as [lambda|]; [exists 1%Q, lambda|exists 0%Q, 1%Q]; auto. }
  destruct P as (h & l & Eq & HL). rewrite Eq in C, Within. cbn [map] in C, Within.
  set (ds := map (to_integer sc) (twist (point_witness p))) in *.
  destruct (point_is_equilibrium two_sided rows ld s _ _ ds _ ss F E L Law C) as (ss' & Er & A & B).
  exists (to_integer sc h), (to_integer sc l), ds, ss', (unit sc).
  split; [apply unit_positive|]. split; [exact Er|]. split; [exact A|]. split; [exact B|].
  split; [now apply (point_within_is bound _ (to_integer sc l))|].
  assert (Xh := X h ltac:(rewrite Eq; cbn; auto)). assert (Xl := X l ltac:(rewrite Eq; cbn; auto)).
  destruct (multiple p); destruct HL as [-> ->]; rewrite Xh, Xl; rewrite ?Q2R_1, ?Q2R_0; now split.
Qed.

Lemma at_multiple d h l fs lambda : Rows.equilibrium s d h l fs -> Rows.bounded (real_bound bound) h d ->
  h = 1 -> l = lambda ->
  Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda.
Proof. intros H B -> ->. now exists d, fs. Qed.

(* FORMAT.md section 3, "Modes", and section 5, "Why" of segments. *)
Lemma segment_resists p ss p' ss' l1 lambda :
  check_at two_sided dim rows ld bound p = inl ss -> check_at two_sided dim rows ld bound p' = inl ss' ->
  same_mode ss ss' = true -> multiple p = Some l1 -> Q2R l1 <= lambda ->
  match multiple p' with Some l2 => lambda <= Q2R l2 | None => True end ->
  Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda.
Proof.
  intros C C' M M1 L1 L2.
  destruct (accepted_point p ss C) as (h & l & ds & st & u & U & -> & A & B & Bd & H).
  destruct (accepted_point p' ss' C') as (h' & l' & ds' & st' & u' & U' & -> & A' & B' & Bd' & H').
  pose proof (same_mode_shares _ _ _ _ _ _ _ _ _ _ A A' M) as SM.
  rewrite M1 in H. destruct H as [H1 H2].
  assert (Mix : forall P Q, 0 <= P -> 0 <= Q ->
    P * IZR h + Q * IZR h' = 1 -> P * IZR l + Q * IZR l' = lambda -> Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda).
  { intros P Q P0 Q0 Eh El. destruct (mixture s _ _ _ _ _ _ _ _ _ _ P0 Q0 B B' SM) as (gs & Eg).
    eapply at_multiple; [exact Eg|exact (bounded_mix _ P _ _ Q _ _ P0 Q0 Bd Bd')| |]; assumption. }
  destruct (multiple p') as [l2|]; destruct H' as [H1' H2'].
  - assert (T : exists t, 0 <= t <= 1 /\ (1 - t) * Q2R l1 + t * Q2R l2 = lambda).
    { destruct (Req_dec (Q2R l1) (Q2R l2)) as [Q|Q].
      - exists 0. lra.
      - exists ((lambda - Q2R l1) / (Q2R l2 - Q2R l1)). split; [|field; lra]. split.
        + apply Rmult_le_pos; [lra|]. left. apply Rinv_0_lt_compat. lra.
        + apply Rmult_le_reg_r with (Q2R l2 - Q2R l1); [lra|]. field_simplify; lra. }
    destruct T as (t & T & TE).
    apply (Mix ((1 - t) * u) (t * u')); try (apply Rmult_le_pos; lra).
    + replace ((1 - t) * u * IZR h + t * u' * IZR h')
        with ((1 - t) * (u * IZR h) + t * (u' * IZR h')) by ring. rewrite H1, H1'. ring.
    + replace ((1 - t) * u * IZR l + t * u' * IZR l')
        with ((1 - t) * (u * IZR l) + t * (u' * IZR l')) by ring. now rewrite H2, H2'.
  - apply (Mix u ((lambda - Q2R l1) * u')); [lra|apply Rmult_le_pos; lra| |].
    + replace (u * IZR h + (lambda - Q2R l1) * u' * IZR h')
        with (u * IZR h + (lambda - Q2R l1) * (u' * IZR h')) by ring. rewrite H1, H1'. ring.
    + replace (u * IZR l + (lambda - Q2R l1) * u' * IZR l')
        with (u * IZR l + (lambda - Q2R l1) * (u' * IZR l')) by ring. rewrite H2, H2'. ring.
Qed.

Lemma rows_positive : Forall (fun r => Rows.positive (Rows.weights r) /\ 0 <= Rows.rho r) (Rows.rows s).
Proof.
  clear - F E. induction F as [|row r rows rs Fr F' IH]; constructor; cbn in E; apply andb_true_iff in E as [Er E].
  - split; [now apply (positive_weights row)|]. destruct (exact_friction row r Fr Er) as (M0 & -> & _).
    apply Rmult_le_pos; [exact M0|apply sqrt_pos].
  - now apply IH.
Qed.

(* A point alone. *)
Lemma point_resists p ss lambda : check_at two_sided dim rows ld bound p = inl ss -> multiple p = Some lambda ->
  Rows.stable_at (Rows.bounded (real_bound bound) 1) s (Q2R lambda).
Proof.
  intros C M. destruct (accepted_point p ss C) as (h & l & ds & st & u & U & _ & _ & B & Bd & H).
  rewrite M in H. destruct H as [H1 H2].
  pose proof rows_positive as P.
  pose proof (self_modes s _ _ _ _ B P) as SM.
  destruct (mixture s _ _ _ _ _ _ _ _ u 0 (Rlt_le _ _ U) (Rle_refl 0) B B SM) as (gs & Eg).
  eapply at_multiple; [exact Eg|exact (bounded_mix _ u _ _ 0 _ _ (Rlt_le _ _ U) (Rle_refl 0) Bd Bd)| |];
    [rewrite H1; ring|rewrite H2; ring].
Qed.

(* Of segments by degree this is known. *)
Variable degree : Q -> option Q -> list Q -> list Q -> list (list Q) -> list (list Q) -> list node ->
  option (string * option nat).
Variable unloaded : bool.
Hypothesis degree_resists : forall a b d1 d2 walls direction tree lambda,
  degree a b d1 d2 walls direction tree = None ->
  match b with Some _ => True | None => Q2R a <> 0 \/ unloaded = true end ->
  Q2R a <= lambda -> match b with Some t => lambda <= Q2R t | None => True end -> Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda.

Theorem segments_resist segments resisted from last number lambda :
  segments_fail two_sided dim rows ld bound degree unloaded segments resisted from last number = None ->
  (forall p ss, last = Some (p, ss) -> check_at two_sided dim rows ld bound p = inl ss) ->
  match resisted with
  | [] => False
  | (lo, hi) :: resisted' =>
      among lambda (match from with Some e => e | None => lo end, hi) \/
      Exists (among lambda) resisted'
  end ->
  Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda.
Proof.
  revert resisted from last number.
  induction segments as [|seg segments IH]; intros resisted from last number H K A.
  - destruct resisted as [|[lo hi] resisted]; [contradiction|discriminate].
  - destruct resisted as [|[lo hi] resisted]; [contradiction|]. cbn [segments_fail] in H.
    set (start := match from with Some e => e | None => lo end) in *.
    (* What is left of the interval after a segment. *)
    assert (Rest : forall to next, (Q2R start <= lambda -> match to with Some t => lambda <= Q2R t | None => True end ->
        Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda) -> beyond hi to = false ->
      (if reaches hi to then segments_fail two_sided dim rows ld bound degree unloaded segments resisted None next (S number)
       else segments_fail two_sided dim rows ld bound degree unloaded segments ((lo, hi) :: resisted) to next (S number)) = None ->
      (forall p ss, next = Some (p, ss) -> check_at two_sided dim rows ld bound p = inl ss) -> Rows.stable_at (Rows.bounded (real_bound bound) 1) s lambda).
    { intros to next Seg Beyond H' K'. destruct (reaches hi to) eqn:R.
      - destruct A as [[A1 A2]|A].
        + apply Seg; [exact A1|]. cbn in A2. unfold reaches in R.
          destruct hi as [h|], to as [t|]; try discriminate; auto. apply Qeq_bool_R in R. lra.
        + eapply IH; [exact H'|exact K'|]. destruct resisted as [|[lo' hi'] resisted]; [inversion A|].
          inversion A; subst; [left|right]; assumption.
      - destruct A as [[A1 A2]|A]; [|eapply IH; [exact H'|exact K'|right; exact A]].
        destruct to as [t|]; [|unfold beyond, reaches in *; destruct hi; discriminate].
        destruct (Rle_dec lambda (Q2R t)) as [B|B]; [now apply Seg|].
        eapply IH; [exact H'|exact K'|]. left. unfold among in *; cbn in *. split; [lra|exact A2]. }
    destruct seg as [first_point second|to d1 d2 walls direction tree].
    2:{ destruct (negb _ || beyond hi to) eqn:Chain in H; [discriminate|]. apply orb_false_iff in Chain as [Up Beyond].
        apply negb_false_iff in Up. fold start in H.
        destruct (degree start to d1 d2 walls direction tree) as [[rule node]|] eqn:Dg; [discriminate|].
        apply (Rest to None); [|exact Beyond|exact H|discriminate]. intros S1 S2.
        apply (degree_resists start to d1 d2 walls direction tree lambda Dg); try assumption.
        destruct to as [t|]; [exact I|]. fold start in Up. apply orb_true_iff in Up as [Up|Up].
        - left. apply Qlt_bool_R in Up. rewrite Q2R_0 in Up. lra.
        - right. now apply andb_true_iff in Up. }
    destruct (match first_point with
              | Some p => Some (p, check_at two_sided dim rows ld bound p)
              | None => match last with Some (p, ss) => Some (p, inl ss) | None => None end
              end) as [[p checked]|] eqn:First; [|discriminate].
    assert (Checked : check_at two_sided dim rows ld bound p = checked).
    { destruct first_point as [p0|].
      - injection First as <- <-. reflexivity.
      - destruct last as [[p0 ss0]|]; [|discriminate]. injection First as <- <-. now apply K. }
    destruct (multiple p) as [l1|] eqn:M1; [|discriminate].
    destruct (_ || _) eqn:Chain in H; [discriminate|].
    apply orb_false_iff in Chain as [Chain Down]. apply orb_false_iff in Chain as [Start Beyond].
    apply negb_false_iff, Qeq_bool_R in Start.
    destruct checked as [ss1|]; [|discriminate].
    destruct (check_at two_sided dim rows ld bound second) as [ss2|] eqn:C2; [|discriminate].
    destruct (same_mode ss1 ss2) eqn:SM; [|discriminate].
    apply (Rest (multiple second) (Some (second, ss2))); [|exact Beyond|exact H|].
    + intros S1 S2. apply (segment_resists p ss1 second ss2 l1 lambda Checked C2 SM M1); [lra|exact S2].
    + intros p0 ss0 Eq. injection Eq as <- <-. exact C2.
Qed.

End Proofs.
