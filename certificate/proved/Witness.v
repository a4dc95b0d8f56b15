(* SPDX-License-Identifier: MIT *)
(* Witnesses (FORMAT.md section 3), at points x = (h, l, d) in integers, and pairs of them that share a
   mode.  `point_is_equilibrium`: a point that is accepted is an equilibrium for the wrench h w + l u and the
   preloads h P + l P^u.  `mixture`: so is every mixture of two points of one mode. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Slips Leaf Tree.
From Proved Require Rows Model.
Import ListNotations.

(* ---- Checking ---- *)

(* Every parameter of the contact is one number. *)
Definition exact_box (b : cbox) : bool :=
  negb (box_turns b) && forallb certain (box_geometry b) && certain (box_friction b) && certain (box_preload b) &&
  certain (box_growth b) && certain (box_stiffness b).

Definition exact_rows (rows : list row) : bool := forallb (fun r => exact_box (box r)) rows.

(* A contact at a point: v and the slip up to positive factors; its friction over mu a, in the space of slips;
   and whether that is against the slip. *)
Record state := State {
  state_row : row; state_v : Z; state_slip : form; state_share : list Q; is_against : bool
}.

Section Checker.
Open Scope Z_scope.

Definition exact_pull (r : row) : form :=
  match pulls r with p :: _ => first_tip p | [] => [] end.

Definition slip_of_row (r : row) (x : form) : form :=
  if box_signed (box r) then [dot (first_tip (tau r)) x]
  else slip_at (first_tip (forms r)) (tl (tl x)).

Fixpoint product_q (ws s t : list Q) : Q :=
  match ws, s, t with
  | w :: ws', x :: s', y :: t' => (w * x * y + product_q ws' s' t')%Q
  | _, _, _ => 0%Q
  end.

Definition mu_of (b : cbox) : Q := low (box_friction b).

(* The cone. *)
Definition in_friction_cone (b : cbox) (g : list Q) : bool :=
  Qle_bool (product_q (box_weights b) g g) (box_square b).

(* Against e, and as large as the cone allows. *)
Definition against (b : cbox) (g : list Q) (e : form) : bool :=
  let s := map inject_Z e in
  let p := product_q (box_weights b) g s in
  Qle_bool p 0 && Qeq_bool (p * p) (box_square b * product_q (box_weights b) s s).

(* A share of the file is a force f; it has g with f = g*. *)
Definition share_of_force (b : cbox) (f : list Q) : list Q :=
  map (fun wf => snd wf / fst wf)%Q (List.combine (box_weights b) f).

Fixpoint sum_of_products (a b : list Q) : Q :=
  match a, b with
  | x :: a', y :: b' => (x * y + sum_of_products a' b')%Q
  | _, _ => 0%Q
  end.

(* Of so many numbers, and across the normal. *)
Definition is_share_of (b : cbox) (f : list Q) : bool :=
  Nat.eqb (List.length f) (List.length (box_weights b)) &&
  (box_signed b || Qeq_bool (sum_of_products f (box_normal b)) 0).

Definition presses (b : cbox) (v : Z) : bool := box_spring b || (0 <? v).

(* Friction of a contact that slips: - L s / |s|, if L / |s| is rational. *)
Definition sliding (b : cbox) (slip : form) : list Q :=
  if box_signed b then map (fun t => if 0 <? t then -1 else 1)%Q slip
  else
    let s := map inject_Z slip in
    let root := low (root_between 64 (reduced (box_square b / product_q (box_weights b) s s)%Q)) in
    map (fun t => reduced (- root * t)%Q) s.

Definition state_of (r : row) (x : form) (given : option (list Q)) : option state :=
  let b := box r in
  let v := dot (exact_pull r) x in
  let slip := slip_of_row r x in
  match given with
  | Some f =>
      let g := share_of_force b f in
      if has_friction b && all_zero slip && is_share_of b f && in_friction_cone b g
      then Some (State r v slip g true) else None
  | None =>
      if all_zero slip || negb (presses b v) || Qeq_bool (mu_of b) 0 then Some (State r v slip [] true)
      else
        let g := sliding b slip in
        if in_friction_cone b g && against b g slip then Some (State r v slip g true)
        else Some (State r v slip [] false)
  end.

(* In reverse order, after those before. *)
Fixpoint states (rows : list row) (x : form) (shares : list (Z * list Q)) (number : Z)
    (before : list state) : option (list state) :=
  match rows with
  | [] => match shares with [] => Some before | _ => None end
  | r :: rows' =>
      let '(given, shares') :=
        match shares with
        | (i, s) :: rest => if i =? number then (Some s, rest) else (None, shares)
        | [] => (None, [])
        end in
      match state_of r x given with
      | Some s => states rows' x shares' (number + 1) (s :: before)
      | None => None
      end
  end.

Definition exact_forms (b : cbox) : list (list Q) := box_forms b (map low (box_geometry b)).

Fixpoint add_friction (c : Q) (ws g : list Q) (forms : list (list Q)) (sum : list Q) : list Q :=
  match ws, g, forms with
  | w :: ws', q :: g', f :: forms' => add_friction c ws' g' forms' (add_multiple sum (c * w * q)%Q f)
  | _, _, _ => sum
  end.

(* a (N + mu S* share), with a = max(0, v), or v of a spring; none where a = 0. *)
Definition wrench_of (s : state) : list Q :=
  let r := state_row s in
  let b := box r in
  if presses b (state_v s) then
    let a := Qmake (state_v s * times (pull_scale r)) (Z.to_pos (over (pull_scale r))) in
    let fs := exact_forms b in
    map (fun c => reduced (a * c)%Q)
      (add_friction (mu_of b) (box_weights b) (state_share s) (tl fs) (nth 0 fs []))
  else [].

Definition load_at (ld : load) (h l : Z) : list Q :=
  map (fun p => reduced (inject_Z h * low (fst p) + inject_Z l * snd p)%Q)
    (List.combine (load_box ld) (load_growth ld)).

Definition common_of (wrenches : list (list Q)) : Z :=
  fold_left (fun d w => fold_left (fun d q => Z.lcm (Zpos (Qden q)) d) w d) wrenches 1.

Definition adds_up_to_zero (wrenches : list (list Q)) : bool :=
  let d := common_of wrenches in
  all_zero (fold_left (fun s w => combine 1 s 1 (map (numerator d) w)) wrenches []).

(* The states at x = (h, l, d), or the rule that fails. *)
Definition check_point (bilateral : bool) (dim : nat) (rows : list row) (ld : load) (x : form)
    (shares : list (Z * list Q)) : list state + string :=
  match x with
  | h :: l :: d =>
      match states rows x shares 0 [] with
      | None => inr "witness-share"%string
      | Some ss =>
          if bilateral && negb (forallb (fun s => box_spring (box (state_row s)) || (0 <=? state_v s)) ss)
          then inr "witness-normal"%string
          else if negb (forallb is_against ss) then inr "witness-root"%string
          else if Nat.eqb (List.length d) dim && adds_up_to_zero (load_at ld h l :: map_all wrench_of ss)
          then inl ss
          else inr "witness-balance"%string
      end
  | _ => inr "witness-balance"%string
  end.

Definition opposite (x y : Z) : bool := x * y <? 0.

(* Multiples >= 0 of one direction. *)
Definition aligned (ms s t : form) : bool :=
  let p := inner_of ms s t in
  all_zero s || all_zero t ||
  ((0 <? p) && (p * p =? inner_of ms s s * inner_of ms t t)).

(* The first that is not 0. *)
Definition first_slip (them : list state) : form :=
  match find (fun s => negb (all_zero (state_slip s))) them with Some s => state_slip s | None => [] end.

(* Whether states of one contact share a mode. *)
Definition contact_mode (them : list state) : bool :=
  match them with
  | [] => true
  | s :: _ =>
      let r := state_row s in
      let b := box r in
      let e := first_slip them in
      (box_spring b || forallb (fun s => 0 <=? state_v s) them || forallb (fun s => state_v s <=? 0) them) &&
      (Qeq_bool (mu_of b) 0 ||
       forallb (fun s => state_v s <=? 0) them ||
       all_zero e ||
       forallb (fun s => aligned (metric r) e (state_slip s) &&
                         ((state_v s <=? 0) || against b (state_share s) e)) them)
  end.

Fixpoint same_mode (ss ts : list state) : bool :=
  match ss, ts with
  | s :: ss', t :: ts' => contact_mode [s; t] && same_mode ss' ts'
  | _, _ => true
  end.

End Checker.

(* ---- Mixtures ---- *)

Section Mixtures.
Open Scope R_scope.

Definition mix (p : R) (a : list R) (q : R) (b : list R) : list R := Rows.plus (Rows.scaled p a) (Rows.scaled q b).

Definition mix_force (p : R) (f : Rows.force) (q : R) (g : Rows.force) : Rows.force :=
  (p * fst f + q * fst g, mix p (snd f) q (snd g)).

Lemma dot_mix a p d q e : List.length d = List.length e -> Rows.dot a (mix p d q e) = p * Rows.dot a d + q * Rows.dot a e.
Proof.
  unfold mix. revert d e. induction a as [|x a IH]; intros [|y d] [|z e] L; cbn in *; try discriminate; try ring.
  injection L as L. unfold Rows.scaled in IH. rewrite IH by exact L. ring.
Qed.

Lemma mix_length p d q e : List.length d = List.length e -> List.length (mix p d q e) = List.length d.
Proof.
  unfold mix. revert e. induction d as [|y d IH]; intros [|z e] L; cbn in *; try discriminate; [reflexivity|].
  injection L as L. unfold Rows.scaled in IH. now rewrite IH.
Qed.

Lemma product_mix ws p a q b t : Rows.product ws (mix p a q b) t = p * Rows.product ws a t + q * Rows.product ws b t.
Proof. unfold mix. now rewrite Rows.product_plus, !Rows.product_scaled. Qed.

(* Slips that are alike for all products. *)
Definition acts_as (ws s : list R) (c : R) (e : list R) := forall t, Rows.product ws s t = c * Rows.product ws e t.

Lemma acts_size ws s c e : Rows.positive ws -> 0 <= c -> acts_as ws s c e -> Rows.size ws s = c * Rows.size ws e.
Proof.
  intros P C A. rewrite <- (Rows.size_scaled ws c e P C). unfold Rows.size. f_equal.
  rewrite (A s), (Rows.product_sym ws e s), (A e), Rows.product_scaled.
  now rewrite (Rows.product_sym ws e (Rows.scaled c e)), Rows.product_scaled.
Qed.

(* FORMAT.md `segment-mode`, over the reals: e is the direction of slips. *)
Definition shares_mode (r : Rows.row) (d : list R) (h l : R) (f : Rows.force)
    (d' : list R) (h' l' : R) (f' : Rows.force) :=
  let ws := Rows.weights r in
  (Rows.spring r = true \/ 0 <= Rows.v r d h l * Rows.v r d' h' l') /\
  (Rows.rho r = 0 \/ fst f + fst f' <= 0 /\ Rows.spring r = false \/
   exists e c c', 0 <= c /\ 0 <= c' /\
     acts_as ws (Rows.slip r d) c e /\ acts_as ws (Rows.slip r d') c' e /\
     (c + c' = 0 \/
      Rows.product ws (snd f) e = - (Rows.rho r * fst f) * Rows.size ws e /\
      Rows.product ws (snd f') e = - (Rows.rho r * fst f') * Rows.size ws e)).

Lemma Rmax_mix p q v v' : 0 <= p -> 0 <= q -> 0 <= v * v' ->
  Rmax 0 (p * v + q * v') = p * Rmax 0 v + q * Rmax 0 v'.
Proof.
  intros P Q H. destruct (Rle_dec 0 v) as [V|V], (Rle_dec 0 v') as [V'|V'].
  - rewrite !Rmax_right; nra.
  - assert (v = 0) by nra. subst v. rewrite (Rmax_right 0 0), (Rmax_left 0 v'), Rmax_left; nra.
  - assert (v' = 0) by nra. subst v'. rewrite (Rmax_right 0 0), (Rmax_left 0 v), Rmax_left; nra.
  - rewrite !Rmax_left; nra.
Qed.

Lemma slip_mix r p d q d' t : List.length d = List.length d' ->
  Rows.product (Rows.weights r) (Rows.slip r (mix p d q d')) t =
  p * Rows.product (Rows.weights r) (Rows.slip r d) t + q * Rows.product (Rows.weights r) (Rows.slip r d') t.
Proof.
  intros L. unfold Rows.slip. revert t. generalize (Rows.weights r) as ws.
  induction (Rows.slips r) as [|f fs IH]; intros [|w ws] [|y t]; cbn; try ring.
  rewrite IH, dot_mix by exact L. ring.
Qed.

Lemma obeys_mix w r d h l f d' h' l' f' p q : 0 <= p -> 0 <= q -> List.length d = List.length d' ->
  Rows.positive (Rows.weights r) -> 0 <= Rows.rho r ->
  Rows.obeys w d h l r f -> Rows.obeys w d' h' l' r f' -> shares_mode r d h l f d' h' l' f' ->
  Rows.obeys w (mix p d q d') (p * h + q * h') (p * l + q * l') r (mix_force p f q f').
Proof.
  intros P Q Len WP Rh. destruct f as [a g], f' as [a' g'].
  intros (L & C & S) (L' & C' & S') (V & M). cbn [fst snd] in M.
  set (ws := Rows.weights r) in *. set (rho := Rows.rho r) in *.
  unfold Rows.obeys, mix_force. cbn [fst snd]. fold ws rho.
  assert (VM : Rows.v r (mix p d q d') (p * h + q * h') (p * l + q * l') = p * Rows.v r d h l + q * Rows.v r d' h' l')
    by (unfold Rows.v; rewrite dot_mix by exact Len; ring).
  rewrite VM. clear VM. set (v := Rows.v r d h l) in *. set (v' := Rows.v r d' h' l') in *.
  set (s := Rows.slip r d) in *. set (s' := Rows.slip r d') in *.
  split; [|split].
  - unfold Rows.normal_law in *. destruct (Rows.spring r); [now rewrite L, L'|].
    destruct V as [V|V]; [discriminate|].
    destruct w; cbn in *; [rewrite L, L'; now rewrite Rmax_mix|].
    destruct L as [-> L], L' as [-> L']. split; [reflexivity|].
    assert (0 <= p * v) by now apply Rmult_le_pos. assert (0 <= q * v') by now apply Rmult_le_pos. lra.
  - unfold mix. eapply Rle_trans; [apply Rows.size_plus; exact WP|].
    rewrite !Rows.size_scaled by assumption.
    assert (p * Rows.size ws g <= p * (rho * a)) by now apply Rmult_le_compat_l.
    assert (q * Rows.size ws g' <= q * (rho * a')) by now apply Rmult_le_compat_l. lra.
  - rewrite product_mix.
    (* Where all friction is 0. *)
    assert (None : Rows.size ws g = 0 -> Rows.size ws g' = 0 -> rho * (p * a + q * a') = 0 ->
      p * Rows.product ws g (Rows.slip r (mix p d q d')) + q * Rows.product ws g' (Rows.slip r (mix p d q d')) =
      - (rho * (p * a + q * a')) * Rows.size ws (Rows.slip r (mix p d q d'))).
    { intros Z Z' Z0. rewrite !Rows.size_zero by assumption. rewrite Z0. ring. }
    pose proof (Rows.size_nonneg ws g) as G0. pose proof (Rows.size_nonneg ws g') as G0'.
    destruct M as [M|[[M Sp]|(e & c & c' & C0 & C0' & A & A' & M)]].
    + rewrite M, Rmult_0_l in *. apply None; lra.
    + assert (A0 : 0 <= a /\ 0 <= a').
      { unfold Rows.normal_law in *. rewrite Sp in *.
        destruct w; cbn in *; [rewrite L, L'; split; apply Rmax_l|lra]. }
      assert (a = 0) by lra. assert (a' = 0) by lra. subst a a'. rewrite Rmult_0_r in *.
      apply None; [lra|lra|ring].
    + assert (AM : acts_as ws (Rows.slip r (mix p d q d')) (p * c + q * c') e).
      { intros t. pose proof (slip_mix r p d q d' t Len) as X. fold ws s s' in X. rewrite X, (A t), (A' t). ring. }
      assert (K : 0 <= p * c + q * c').
      { assert (0 <= p * c) by now apply Rmult_le_pos. assert (0 <= q * c') by now apply Rmult_le_pos. lra. }
      rewrite (acts_size ws _ _ e WP K AM), !(Rows.product_sym ws _ (Rows.slip r _)), !AM.
      rewrite !(Rows.product_sym ws e). destruct M as [M|[M M']].
      * assert (c = 0) by lra. assert (c' = 0) by lra. subst c c'. ring.
      * rewrite M, M'. ring.
Qed.

(* A mode of a contact: which sign v has, and how friction is. *)
Inductive rubbing := Smooth | Apart | Sticks | Slides (e : list R).
Record mode := Mode { v_sign : R; rubs_by : rubbing }.

Definition rubs_so (r : Rows.row) (k : rubbing) (d : list R) (f : Rows.force) : Prop :=
  let ws := Rows.weights r in
  match k with
  | Smooth => Rows.rho r = 0
  | Apart => fst f <= 0 /\ Rows.spring r = false
  | Sticks => acts_as ws (Rows.slip r d) 0 []
  | Slides e => exists c, 0 <= c /\ acts_as ws (Rows.slip r d) c e /\
      Rows.product ws (snd f) e = - (Rows.rho r * fst f) * Rows.size ws e
  end.

Definition in_mode (m : mode) (r : Rows.row) (d : list R) (h l : R) (f : Rows.force) : Prop :=
  (Rows.spring r = true \/ 0 <= v_sign m * Rows.v r d h l) /\ rubs_so r (rubs_by m) d f.

Lemma in_mode_shares m r d h l f d' h' l' f' : v_sign m * v_sign m = 1 ->
  in_mode m r d h l f -> in_mode m r d' h' l' f' -> shares_mode r d h l f d' h' l' f'.
Proof.
  intros S [V M] [V' M']. split.
  - destruct V as [V|V]; [now left|]. destruct V' as [V'|V']; [now left|]. right.
    set (v := Rows.v r d h l) in *. set (v' := Rows.v r d' h' l') in *.
    replace (v * v') with (v_sign m * v * (v_sign m * v')); [now apply Rmult_le_pos|].
    transitivity (v_sign m * v_sign m * (v * v')); [ring|]. rewrite S. ring.
  - destruct (rubs_by m) as [| | |e]; cbn in M, M'.
    + now left.
    + right; left. split; [lra|tauto].
    + right; right. exists [], 0, 0. split; [lra|]. split; [lra|]. split; [exact M|]. split; [exact M'|]. left. ring.
    + destruct M as (c & C & A & P), M' as (c' & C' & A' & P'). right; right. exists e, c, c'. repeat split; auto.
Qed.

Lemma in_mode_mix m r d h l f d' h' l' f' p q : 0 <= p -> 0 <= q -> List.length d = List.length d' ->
  in_mode m r d h l f -> in_mode m r d' h' l' f' ->
  in_mode m r (mix p d q d') (p * h + q * h') (p * l + q * l') (mix_force p f q f').
Proof.
  intros P Q L [V M] [V' M']. split.
  - destruct V as [V|V]; [now left|]. destruct V' as [V'|V']; [now left|]. right.
    replace (v_sign m * Rows.v r (mix p d q d') (p * h + q * h') (p * l + q * l'))
      with (p * (v_sign m * Rows.v r d h l) + q * (v_sign m * Rows.v r d' h' l')).
    + assert (0 <= p * (v_sign m * Rows.v r d h l)) by now apply Rmult_le_pos.
      assert (0 <= q * (v_sign m * Rows.v r d' h' l')) by now apply Rmult_le_pos. lra.
    + unfold Rows.v. rewrite dot_mix by exact L. ring.
  - destruct (rubs_by m) as [| | |e]; cbn [rubs_so] in *.
    + exact M.
    + destruct M as [M Sp], M' as [M' _]. split; [|exact Sp]. unfold mix_force; cbn [fst]. nra.
    + intros t. rewrite slip_mix, (M t), (M' t) by exact L. ring.
    + destruct M as (c & C & A & F), M' as (c' & C' & A' & F'). exists (p * c + q * c'). split; [|split].
      * assert (0 <= p * c) by now apply Rmult_le_pos. assert (0 <= q * c') by now apply Rmult_le_pos. lra.
      * intros t. rewrite slip_mix, (A t), (A' t) by exact L. ring.
      * unfold mix_force; cbn [fst snd]. rewrite product_mix, F, F'. ring.
Qed.

Inductive share_modes (d : list R) (h l : R) (d' : list R) (h' l' : R)
    : list Rows.row -> list Rows.force -> list Rows.force -> Prop :=
  | modes_nil : share_modes d h l d' h' l' [] [] []
  | modes_cons r f f' rs fs fs' : Rows.positive (Rows.weights r) -> 0 <= Rows.rho r ->
      shares_mode r d h l f d' h' l' f' -> share_modes d h l d' h' l' rs fs fs' ->
      share_modes d h l d' h' l' (r :: rs) (f :: fs) (f' :: fs').

Theorem mixture s d h l fs d' h' l' fs' p q : 0 <= p -> 0 <= q ->
  Rows.equilibrium s d h l fs -> Rows.equilibrium s d' h' l' fs' ->
  share_modes d h l d' h' l' (Rows.rows s) fs fs' ->
  exists gs, Rows.equilibrium s (mix p d q d') (p * h + q * h') (p * l + q * l') gs.
Proof.
  intros P Q (Ld & O & B) (Ld' & O' & B') M. assert (Len : List.length d = List.length d') by congruence.
  assert (A : exists gs,
    Forall2 (Rows.obeys (Rows.normal s) (mix p d q d') (p * h + q * h') (p * l + q * l')) (Rows.rows s) gs /\
    forall y, Rows.works (Rows.rows s) gs y = p * Rows.works (Rows.rows s) fs y + q * Rows.works (Rows.rows s) fs' y).
  { clear B B'. induction M as [|r f f' rs fs fs' Wp Rh Mr M IH].
    - exists []. split; [constructor|]. intros y; cbn; ring.
    - inversion O; inversion O'; subst. destruct (IH ltac:(assumption) ltac:(assumption)) as (gs & Og & Wg).
      exists (mix_force p f q f' :: gs). split; [constructor; [now apply obeys_mix|exact Og]|].
      intros y. cbn [Rows.works]. rewrite Wg. unfold Rows.work, mix_force. cbn [fst snd].
      rewrite product_mix. ring. }
  destruct A as (gs & Og & Wg). exists gs. split; [now rewrite mix_length|]. split; [exact Og|].
  intros y. rewrite Wg. specialize (B y). specialize (B' y). unfold Rows.load in *. nra.
Qed.

End Mixtures.

(* ---- What is accepted is an equilibrium ---- *)

Section Exact.
Open Scope R_scope.

Notation real := (map IZR).
Notation reals := (map Q2R).

Lemma product_q_is ws s t : Q2R (product_q ws s t) = Rows.product (reals ws) (reals s) (reals t).
Proof.
  revert s t. induction ws as [|w ws IH]; intros [|x s] [|y t]; cbn; try apply Q2R_0.
  now rewrite Q2R_plus, !Q2R_mult, IH.
Qed.

Lemma reals_integers e : reals (map inject_Z e) = real e.
Proof. rewrite map_map. apply map_ext. intros z. unfold Q2R; cbn. field. Qed.

Lemma certain_all is p : forallb certain is = true -> Forall2 within is p ->
  box_shares is p = [] /\ p = reals (map low is).
Proof.
  intros C F. induction F as [|i x is p W F IH]; [now split|]. cbn in C. apply andb_true_iff in C as [Ci C].
  destruct (IH C) as [E1 E2]. cbn. unfold Numbers.share. rewrite Ci, E1. split; [reflexivity|].
  f_equal; [now apply certain_within|exact E2].
Qed.

(* |t|^2 |s|^2 = <s, t>^2 *)
Lemma parallel ws s t : Rows.positive ws -> 0 < Rows.product ws s s ->
  Rows.product ws s t * Rows.product ws s t = Rows.product ws s s * Rows.product ws t t ->
  acts_as ws t (Rows.product ws s t / Rows.product ws s s) s.
Proof.
  intros P S E. set (ss := Rows.product ws s s) in *. set (st := Rows.product ws s t) in *.
  set (k := st / ss). set (z := Rows.plus t (Rows.scaled (- k) s)).
  assert (K : k * ss = st) by (unfold k; field; lra).
  assert (Z : Rows.product ws z z = 0).
  { unfold z. rewrite Rows.product_plus, !(Rows.product_sym ws _ (Rows.plus t _)), !Rows.product_plus.
    rewrite !Rows.product_scaled, !(Rows.product_sym ws _ (Rows.scaled _ s)), !Rows.product_scaled.
    fold ss st. apply Rmult_eq_reg_l with ss; [|lra]. rewrite Rmult_0_r.
    transitivity (ss * Rows.product ws t t - 2 * (k * ss) * st + (k * ss) * (k * ss)); [ring|].
    rewrite K, <- E. ring. }
  intros e. assert (SZ : Rows.size ws z = 0) by (unfold Rows.size; rewrite Z; apply sqrt_0).
  pose proof (Rows.size_zero ws z e P SZ) as X. unfold z in X. rewrite Rows.product_plus, Rows.product_scaled in X.
  fold k. lra.
Qed.

Variable row : row.
Variable r : Rows.row.
Hypothesis Ft : fits row r.
Hypothesis X : exact_box (box row) = true.
Let b := box row.
Let ws := Rows.weights r.

Lemma exact_parts : forallb certain (box_geometry b) = true /\ certain (box_friction b) = true /\
  certain (box_preload b) = true /\ certain (box_growth b) = true /\ certain (box_stiffness b) = true.
Proof. unfold exact_box in X. fold b in X. rewrite !andb_true_iff in X. tauto. Qed.

Lemma weights_real : ws = reals (box_weights b).
Proof. destruct Ft as [_ (p & F & mu & t & I)]. apply (is_weights _ _ _ _ _ _ I). Qed.

Lemma positive_weights : Rows.positive ws.
Proof. destruct Ft as [_ (p & F & mu & t & I)]. apply (weights_positive _ _ _ _ _ _ I). Qed.

Definition mu_real : R := Q2R (mu_of b).

Lemma exact_friction : 0 <= mu_real /\ Rows.rho r = mu_real * sqrt (Q2R (box_square b)) /\
  (box_spring b = true -> mu_real = 0) /\ 0 <= Q2R (box_square b).
Proof.
  destruct Ft as [_ (p & F & mu & t & I)]. destruct exact_parts as (_ & C & _).
  pose proof (certain_within _ _ C (in_friction _ _ _ _ _ _ I)) as E. unfold mu_real, mu_of. rewrite <- E.
  split; [apply (friction_nonneg _ _ _ _ _ _ I)|]. split; [apply (is_rho _ _ _ _ _ _ I)|].
  split; [apply (spring_smooth _ _ _ _ _ _ I)|apply (square_nonneg _ _ _ _ _ _ I)].
Qed.

Lemma exact_v h l d : Rows.v r d h l = unit (pull_scale row) * rdot (exact_pull row) (h :: l :: d).
Proof.
  destruct Ft as [E (p & F & mu & t & I)]. destruct exact_parts as (Cg & _ & Cp & Cu & Ck).
  destruct (certain_all _ _ Cg (in_geometry _ _ _ _ _ _ I)) as [SS _].
  assert (PE : pull_ends b = [(low (box_preload b), low (box_growth b), low (box_stiffness b))]).
  { unfold pull_ends, preload_ends, ends. now rewrite Cp, Cu, Ck. }
  assert (XE : exact_pull row = first_tip (integer_tree (pull_scaling b)
    (pull_tree b (low (box_preload b), low (box_growth b), low (box_stiffness b))))).
  { unfold exact_pull. rewrite E. cbn [pulls make_row]. fold b. rewrite PE. reflexivity. }
  assert (SE : pull_scale row = pull_scaling b) by (rewrite E; reflexivity).
  rewrite XE, SE.
  assert (A : forall factor, factor * Rows.v r d h l <= factor * (unit (pull_scaling b) * rdot
    (first_tip (integer_tree (pull_scaling b)
      (pull_tree b (low (box_preload b), low (box_growth b), low (box_stiffness b))))) (h :: l :: d))).
  { intros f. apply (v_by_trees d h l b r p F mu t I). intros e He. rewrite PE in He.
    destruct He as [<-|[]]. unfold shares_in. fold b in SS. rewrite SS, eval_first. lra. }
  pose proof (A 1). pose proof (A (-1)). lra.
Qed.

Lemma exact_slip : exists u, 0 < u /\ forall h l d : Z, forall ds : form,
  acts_as ws (Rows.slip r (real ds)) u (real (slip_of_row row (h :: l :: ds))).
Proof.
  destruct Ft as [E (p & F & mu & t & I)]. destruct exact_parts as (Cg & _).
  destruct (certain_all _ _ Cg (in_geometry _ _ _ _ _ _ I)) as [SS _]. fold b in SS, I.
  unfold slip_of_row. fold b. destruct (box_signed b) eqn:Sg.
  - exists (unit (scaling_of_trees [tau_tree b])). split; [apply trees_unit_positive|]. intros h l _ ds e.
    unfold ws, Rows.slip. destruct (is_signed _ _ _ _ _ _ I Sg) as ([Sl|(T & Sl)] & We & _);
      rewrite We, Sl; cbn [map]; [cbn; ring|].
    assert (TE : Rows.dot T (real ds) = unit (scaling_of_trees [tau_tree b]) *
      IZR (dot (first_tip (tau row)) (h :: l :: ds))).
    { pose proof (tau_corners b r p F mu t I (IZR h) (IZR l) (real ds) Sg) as TC.
      unfold Box.T in TC. rewrite Sl in TC. cbn [nth] in TC. rewrite TC. unfold shares_in.
      rewrite SS, eval_first. f_equal. rewrite E. fold b.
      change (IZR h :: IZR l :: real ds) with (real (h :: l :: ds)). apply rdot_integers. }
    rewrite TE. destruct e; cbn [Rows.product]; ring.
  - exists (unit (forms_scaling b)). split; [apply unit_positive|]. intros h l _ ds e.
    unfold ws. rewrite !(product_is b r p F mu t I).
    rewrite (slip_corners b r p F mu t I e (real ds)), <- (forms_are b Sg). unfold shares_in. rewrite SS, eval_first.
    rewrite slip_of_integers. cbn [tl]. rewrite E. fold b. ring.
Qed.

Lemma exact_rows_are : Rows.N r = reals (nth 0 (exact_forms b) []) /\
  Rows.slips r = map reals (tl (exact_forms b)).
Proof.
  destruct Ft as [E (p & F & mu & t & I)]. destruct exact_parts as (Cg & _).
  destruct (certain_all _ _ Cg (in_geometry _ _ _ _ _ _ I)) as [_ PE].
  pose proof (is_forms _ _ _ _ _ _ I) as FE. rewrite PE, (forms_rational _ _ _ _ _ _ I) in FE.
  unfold exact_forms. fold b in FE. destruct (box_forms b _) as [|f fs]; [discriminate|].
  injection FE as -> ->. now split.
Qed.

Definition a_of (s : state) : R :=
  if presses b (state_v s) then unit (pull_scale row) * IZR (state_v s) else 0.

Definition force_of (s : state) : Rows.force := (a_of s, Rows.scaled (mu_real * a_of s) (reals (state_share s))).

Record is_state (x : form) (s : state) : Prop := IsState {
  its_row : state_row s = row;
  its_v : state_v s = dot (exact_pull row) x;
  its_slip : state_slip s = slip_of_row row x;
  its_cone : Rows.product ws (reals (state_share s)) (reals (state_share s)) <= Q2R (box_square b);
  its_against : is_against s = true ->
    all_zero (state_slip s) = true \/ presses b (state_v s) = false \/ mu_real = 0 \/
    against b (state_share s) (state_slip s) = true
}.

Lemma state_of_is x given s : state_of row x given = Some s -> is_state x s.
Proof.
  unfold state_of. fold b.
  assert (Cone : forall g, in_friction_cone b g = true -> Rows.product ws (reals g) (reals g) <= Q2R (box_square b)).
  { intros g H. apply Qle_bool_R in H. now rewrite product_q_is, <- weights_real in H. }
  destruct exact_friction as (_ & _ & _ & Sq).
  assert (Nil : Rows.product ws (reals []) (reals []) <= Q2R (box_square b)) by (destruct ws; exact Sq).
  destruct given as [f|].
  - destruct (_ && _) eqn:C; [|discriminate]. intros E. injection E as <-.
    rewrite !andb_true_iff in C. destruct C as [[[_ Z] _] C].
    constructor; cbn; auto.
  - destruct (_ || _ || _) eqn:C.
    + intros E. injection E as <-. constructor; cbn; auto. intros _.
      rewrite !orb_true_iff, negb_true_iff in C. destruct C as [[C|C]|C]; auto.
      right; right; left. apply Qeq_bool_eq, Qeq_eqR in C. unfold mu_real. now rewrite C, Q2R_0.
    + destruct (_ && _) eqn:D; intros E; injection E as <-; constructor; cbn; auto; try (intros H; discriminate H).
      * apply andb_true_iff in D as [D _]. auto.
      * intros _. apply andb_true_iff in D as [_ D]. auto.
Qed.

Lemma pull_unit_row : 0 < unit (pull_scale row) /\ (0 < over (pull_scale row))%Z.
Proof.
  destruct Ft as [E _]. rewrite E. cbn [pull_scale make_row]. split; [apply trees_unit_positive|].
  apply lt_IZR, over_positive.
Qed.

(* Friction against e, at a force (a, mu a g). *)
Lemma against_is g e a : against b g e = true ->
  Rows.product ws (Rows.scaled (mu_real * a) (reals g)) (real e) = - (Rows.rho r * a) * Rows.size ws (real e).
Proof.
  unfold against. intros H. apply andb_true_iff in H as [H1 H2].
  apply Qle_bool_R in H1. apply Qeq_bool_eq, Qeq_eqR in H2. rewrite !Q2R_mult in H2.
  rewrite Q2R_0 in H1. rewrite !product_q_is, reals_integers, <- weights_real in *.
  destruct exact_friction as (_ & RE & _ & Sq).
  rewrite Rows.product_scaled, RE.
  set (p := Rows.product ws (reals g) (real e)) in *. set (ee := Rows.product ws (real e) (real e)) in *.
  assert (E : - p = sqrt (Q2R (box_square b)) * Rows.size ws (real e)).
  { unfold Rows.size. fold ee. rewrite <- sqrt_mult_alt by exact Sq. rewrite <- H2.
    replace (p * p) with (- p * - p) by ring. rewrite sqrt_square; lra. }
  replace p with (- (sqrt (Q2R (box_square b)) * Rows.size ws (real e))) by lra. ring.
Qed.

Lemma zero_product e t : all_zero e = true -> Rows.product ws (real e) t = 0.
Proof.
  clear. revert e t. induction ws as [|w ws' IH]; intros [|z e] [|y t]; cbn -[Z.eqb]; try reflexivity.
  intros H. apply andb_true_iff in H as [Z H]. apply Z.eqb_eq in Z. subst z. rewrite IH by exact H. ring.
Qed.

Lemma zero_size e : all_zero e = true -> Rows.size ws (real e) = 0.
Proof. intros H. unfold Rows.size. rewrite zero_product by exact H. apply sqrt_0. Qed.

Lemma a_is (two_sided : bool) h l ds s : is_state (h :: l :: ds) s ->
  (two_sided = true -> box_spring b || (0 <=? state_v s)%Z = true) ->
  Rows.normal_law (if two_sided then Model.bilateral else Model.unilateral) r
    (Rows.v r (real ds) (IZR h) (IZR l)) (a_of s).
Proof.
  intros [_ V _ _ _] B. pose proof (exact_v (IZR h) (IZR l) (real ds)) as EV.
  change (IZR h :: IZR l :: real ds) with (real (h :: l :: ds)) in EV.
  rewrite rdot_integers, <- V in EV. rewrite EV. unfold a_of, presses.
  destruct pull_unit_row as [U _].
  assert (Sp : Rows.spring r = box_spring b).
  { destruct Ft as [_ (p & F & mu & t & I)]. apply (is_spring _ _ _ _ _ _ I). }
  unfold Rows.normal_law. rewrite Sp. destruct (box_spring b); [reflexivity|]. cbn [orb] in *.
  assert (A : (if (0 <? state_v s)%Z then unit (pull_scale row) * IZR (state_v s) else 0)
              = Rmax 0 (unit (pull_scale row) * IZR (state_v s))).
  { destruct (Z.ltb_spec 0 (state_v s)) as [H|H].
    - apply IZR_lt in H. rewrite Rmax_right; nra.
    - apply IZR_le in H. rewrite Rmax_left; nra. }
  rewrite A. destruct two_sided; cbn; [|reflexivity]. specialize (B eq_refl). apply Z.leb_le, IZR_le in B.
  assert (0 <= unit (pull_scale row) * IZR (state_v s)) by nra.
  rewrite Rmax_right by assumption. now split.
Qed.

Lemma spring_or_presses s : box_spring b = true \/ 0 <= a_of s.
Proof.
  unfold a_of, presses. destruct (box_spring b); [now left|right]. cbn [orb].
  destruct pull_unit_row as [U _]. destruct (Z.ltb_spec 0 (state_v s)) as [H|H]; [|lra].
  apply IZR_lt in H. nra.
Qed.

Lemma mu_a_nonneg s : 0 <= mu_real * a_of s.
Proof.
  destruct exact_friction as (M0 & _ & Sm & _). destruct (spring_or_presses s) as [Sp|A]; [|now apply Rmult_le_pos].
  rewrite (Sm Sp). lra.
Qed.

Lemma state_obeys (two_sided : bool) h l ds s : is_state (h :: l :: ds) s -> is_against s = true ->
  (two_sided = true -> box_spring b || (0 <=? state_v s)%Z = true) ->
  Rows.obeys (if two_sided then Model.bilateral else Model.unilateral) (real ds) (IZR h) (IZR l) r (force_of s).
Proof.
  intros S G B. pose proof (a_is two_sided h l ds s S B) as Law.
  destruct S as [_ V Sl Co Ag]. specialize (Ag G).
  destruct exact_friction as (M0 & RE & _ & Sq). pose proof positive_weights as WP. fold ws in WP.
  pose proof (mu_a_nonneg s) as MA. unfold force_of, Rows.obeys. fold ws.
  split; [exact Law|]. split.
  - rewrite Rows.size_scaled by assumption. rewrite RE.
    replace (mu_real * sqrt (Q2R (box_square b)) * a_of s) with (mu_real * a_of s * sqrt (Q2R (box_square b))) by ring.
    apply Rmult_le_compat_l; [exact MA|]. unfold Rows.size. now apply sqrt_le_1_alt.
  - destruct exact_slip as (u & U & Acts). specialize (Acts h l 0%Z ds). rewrite <- Sl in Acts.
    rewrite (acts_size ws _ u _ WP (Rlt_le _ _ U) Acts), (Rows.product_sym ws _ (Rows.slip r _)), Acts.
    rewrite (Rows.product_sym ws (real _)).
    assert (None : mu_real * a_of s = 0 ->
      u * Rows.product ws (Rows.scaled (mu_real * a_of s) (reals (state_share s))) (real (state_slip s)) =
      - (Rows.rho r * a_of s) * (u * Rows.size ws (real (state_slip s)))).
    { intros Z. rewrite Rows.product_scaled, RE.
      replace (- (mu_real * sqrt (Q2R (box_square b)) * a_of s)) with (- (mu_real * a_of s) * sqrt (Q2R (box_square b)))
        by ring. rewrite Z. ring. }
    destruct Ag as [Z|[Z|[Z|Z]]].
    + rewrite (Rows.product_sym ws _ (real _)), zero_product, zero_size by exact Z. ring.
    + apply None. unfold a_of. rewrite Z. ring.
    + apply None. rewrite Z. ring.
    + rewrite (against_is _ _ _ Z). ring.
Qed.

Lemma wrench_is x s y : is_state x s -> qdot (wrench_of s) y = Rows.work r (force_of s) y.
Proof.
  intros [Er V Sl Co Ag]. unfold wrench_of, force_of, Rows.work. rewrite Er. fold b. cbn [fst snd].
  unfold a_of. destruct (presses b (state_v s)).
  2:{ cbn [qdot]. rewrite Rmult_0_r, Rows.product_scaled. ring. }
  destruct pull_unit_row as [_ OP]. set (a := unit (pull_scale row) * IZR (state_v s)).
  set (aq := (state_v s * times (pull_scale row) # Z.to_pos (over (pull_scale row)))%Q).
  assert (A : Q2R aq = a).
  { unfold aq, a, Q2R, unit; cbn [Qnum Qden]. rewrite Z2Pos.id, mult_IZR by exact OP. field.
    apply IZR_lt in OP. lra. }
  assert (M : forall v, qdot (map (fun c => reduced (aq * c)%Q) v) y = a * qdot v y).
  { induction v as [|q v IH] in y |- *; destruct y as [|z y]; cbn; try ring.
    rewrite IH, reduced_same, Q2R_mult, A. ring. }
  rewrite M. destruct exact_rows_are as [NE SE].
  assert (Fr : forall ws0 g fs sum, qdot (add_friction (mu_of b) ws0 g fs sum) y =
    qdot sum y + mu_real * Rows.product (reals ws0) (reals g) (map (fun f => Rows.dot f y) (map reals fs))).
  { induction ws0 as [|w ws0 IH]; intros [|q g] [|f fs] sum; cbn [add_friction map Rows.product]; try ring.
    rewrite IH, qdot_add_multiple, !Q2R_mult, (qdot_is f y). unfold mu_real. ring. }
  rewrite Fr, <- SE, <- weights_real, qdot_is, <- NE, Rows.product_scaled. unfold Rows.slip. fold ws. ring.
Qed.

(* States of one mode. *)
Lemma contact_mode_is them : contact_mode them = true -> Forall (fun s => state_row s = row) them ->
  exists m, v_sign m * v_sign m = 1 /\ forall h l ds s, In s them -> is_state (h :: l :: ds) s ->
    in_mode m r (real ds) (IZR h) (IZR l) (force_of s).
Proof.
  intros M Rw. destruct them as [|s0 them']; [exists (Mode 1 Smooth); split; [cbn; ring|contradiction]|].
  remember (s0 :: them') as them eqn:Eq. assert (R0 : state_row s0 = row) by (subst them; apply (Forall_inv Rw)).
  unfold contact_mode in M. rewrite Eq in M. rewrite R0 in M. rewrite <- Eq in M. clear Eq. fold b in M.
  destruct pull_unit_row as [U _].
  destruct exact_friction as (M0 & RE & Sm & _). pose proof positive_weights as WP. fold ws in WP.
  assert (Sp : Rows.spring r = box_spring b).
  { destruct Ft as [_ (p & F & mu & t & I)]. apply (is_spring _ _ _ _ _ _ I). }
  assert (EV : forall h l ds s, is_state (h :: l :: ds) s ->
    Rows.v r (real ds) (IZR h) (IZR l) = unit (pull_scale row) * IZR (state_v s)).
  { intros h l ds s [_ V _ _ _]. pose proof (exact_v (IZR h) (IZR l) (real ds)) as E.
    change (IZR h :: IZR l :: real ds) with (real (h :: l :: ds)) in E. now rewrite rdot_integers, <- V in E. }
  apply andb_true_iff in M as [MV M].
  (* the sign of v *)
  assert (Sign : exists sg, sg * sg = 1 /\ forall h l ds s, In s them -> is_state (h :: l :: ds) s ->
    Rows.spring r = true \/ 0 <= sg * Rows.v r (real ds) (IZR h) (IZR l)).
  { rewrite !orb_true_iff in MV. destruct MV as [[MV|MV]|MV].
    - exists 1. split; [ring|]. intros. left. congruence.
    - exists 1. split; [ring|]. intros h l ds s Hs Is. right. rewrite (EV _ _ _ _ Is). rewrite forallb_forall in MV.
      apply MV, Z.leb_le, IZR_le in Hs. nra.
    - exists (-1). split; [ring|]. intros h l ds s Hs Is. right. rewrite (EV _ _ _ _ Is). rewrite forallb_forall in MV.
      apply MV, Z.leb_le, IZR_le in Hs. nra. }
  destruct Sign as (sg & Sg & SV).
  destruct (box_spring b) eqn:Spb.
  { exists (Mode sg Smooth). split; [exact Sg|]. intros h l ds s Hs Is. split; [eauto|]. cbn. rewrite RE, (Sm eq_refl). ring. }
  destruct exact_slip as (u & PU & Acts).
  assert (As : forall h l ds s, is_state (h :: l :: ds) s -> acts_as ws (Rows.slip r (real ds)) u (real (state_slip s))).
  { intros h l ds s [_ _ Sl _ _]. rewrite Sl. exact (Acts h l 0%Z ds). }
  destruct (all_zero (first_slip them)) eqn:Z.
  { exists (Mode sg Sticks). split; [exact Sg|]. intros h l ds s Hs Is. split; [eauto|]. cbn.
    assert (Z' : all_zero (state_slip s) = true).
    { unfold first_slip in Z. destruct (find _ them) as [s'|] eqn:Fi.
      - apply find_some in Fi as [_ Fi]. rewrite Z in Fi. discriminate.
      - pose proof (find_none _ _ Fi s Hs) as N. now apply negb_false_iff in N. }
    intros t. rewrite (As _ _ _ _ Is), zero_product by exact Z'. now rewrite Rmult_0_r, Rmult_0_l. }
  rewrite orb_false_r, !orb_true_iff in M. destruct M as [[M|M]|M].
  - exists (Mode sg Smooth). split; [exact Sg|]. intros h l ds s Hs Is. split; [eauto|]. cbn.
    apply Qeq_bool_eq, Qeq_eqR in M. rewrite Q2R_0 in M. unfold mu_real in RE. rewrite RE, M. ring.
  - exists (Mode sg Apart). split; [exact Sg|]. intros h l ds s Hs Is. split; [eauto|]. cbn. split; [|congruence].
    rewrite forallb_forall in M. apply M, Z.leb_le in Hs. unfold a_of, presses. rewrite Spb. cbn [orb].
    destruct (Z.ltb_spec 0 (state_v s)); [lia|lra].
  - set (e := first_slip them) in *. exists (Mode sg (Slides (real e))). split; [exact Sg|].
    intros h l ds s Hs Is. split; [eauto|]. cbn [rubs_by rubs_so]. fold ws.
    rewrite forallb_forall in M. apply M in Hs. apply andb_true_iff in Hs as [Al Ag].
    assert (Dir : exists c, 0 <= c /\ acts_as ws (real (state_slip s)) c (real e)).
    { unfold aligned in Al. rewrite Z in Al. destruct (all_zero (state_slip s)) eqn:Z'.
      { exists 0. split; [lra|]. intros t. rewrite zero_product by exact Z'. now rewrite Rmult_0_l. }
      cbn [orb] in Al. apply andb_true_iff in Al as [P Q].
      apply Z.ltb_lt, IZR_lt in P. apply Z.eqb_eq, (f_equal IZR) in Q. rewrite !mult_IZR in Q.
      destruct Ft as [E (p & F & mu & t & I)].
      assert (MS : metric row = metric (make_row b)) by (rewrite E at 1; reflexivity).
      rewrite MS in P, Q. rewrite inner_is in P. rewrite !inner_is in Q.
      pose proof (product_is b r p F mu t I) as PI. pose proof (mu_unit_positive b) as MU.
      set (k := unit (metric_scale (make_row b))) in *. set (G := map IZR (metric (make_row b))) in *.
      set (v := real e) in *. set (v' := real (state_slip s)) in *.
      assert (Q' : Rows.product ws v v' * Rows.product ws v v' = Rows.product ws v v * Rows.product ws v' v').
      { unfold ws. rewrite !PI.
        transitivity (k * k * (Rows.product G v v' * Rows.product G v v')); [ring|]. rewrite Q. ring. }
      assert (P' : 0 < Rows.product ws v v') by (unfold ws; rewrite PI; now apply Rmult_lt_0_compat).
      assert (VV : 0 < Rows.product ws v v).
      { destruct (Rle_lt_or_eq_dec 0 _ (Rows.product_nonneg ws v WP)) as [L|L]; [exact L|].
        rewrite <- L in Q'. nra. }
      exists (Rows.product ws v v' / Rows.product ws v v). split; [left; now apply Rdiv_lt_0_compat|]. now apply parallel. }
    destruct Dir as (c & C0 & D). exists (u * c). split; [apply Rmult_le_pos; lra|]. split.
    + intros t. now rewrite (As _ _ _ _ Is), (D t), Rmult_assoc.
    + unfold force_of. cbn [fst snd]. apply orb_true_iff in Ag as [Ag|Ag]; [|now apply against_is].
      apply Z.leb_le in Ag. unfold a_of, presses. rewrite Spb. cbn [orb].
      destruct (Z.ltb_spec 0 (state_v s)); [lia|]. rewrite Rmult_0_r, Rows.product_scaled. ring.
Qed.

(* Two of them. *)
Lemma two_share_mode h l ds s h' l' ds' s' :
  is_state (h :: l :: ds) s -> is_state (h' :: l' :: ds') s' -> contact_mode [s; s'] = true ->
  shares_mode r (real ds) (IZR h) (IZR l) (force_of s) (real ds') (IZR h') (IZR l') (force_of s').
Proof.
  intros I I' M. destruct (contact_mode_is _ M) as (m & S & H).
  { constructor; [apply I|constructor; [apply I'|constructor]]. }
  apply (in_mode_shares m); [exact S|apply H; [now left|exact I]|apply H; [right; now left|exact I']].
Qed.

End Exact.

Section AllContacts.
Open Scope R_scope.

Notation real := (map IZR).

(* The rows, the rows of the choice, and their states. *)
Inductive all_states (x : form) : list row -> list Rows.row -> list state -> Prop :=
  | no_states : all_states x [] [] []
  | more_states row r s rows rs ss : fits row r -> exact_box (box row) = true -> is_state row r x s ->
      all_states x rows rs ss -> all_states x (row :: rows) (r :: rs) (s :: ss).

Lemma states_are x rows rs shares n before ss : Forall2 fits rows rs -> exact_rows rows = true ->
  states rows x shares n before = Some ss ->
  exists ss', ss = rev ss' ++ before /\ all_states x rows rs ss'.
Proof.
  intros F. revert shares n before. induction F as [|row r rows rs Fr F IH]; intros shares n before E H.
  - cbn in H. destruct shares; [|discriminate]. injection H as <-. exists []. split; [reflexivity|constructor].
  - cbn in E. apply andb_true_iff in E as [Er E]. cbn [states] in H.
    destruct (match shares with [] => _ | _ => _ end) as [given shares'].
    destruct (state_of row x given) as [s|] eqn:St; [|discriminate].
    destruct (IH _ _ _ E H) as (ss' & -> & A). exists (s :: ss'). split.
    + cbn. now rewrite <- app_assoc.
    + constructor; try assumption. eapply state_of_is; eassumption.
Qed.

Definition forces (rows : list row) (ss : list state) : list Rows.force :=
  map (fun rs => force_of (fst rs) (snd rs)) (List.combine rows ss).

Fixpoint works_of (ws : list (list Q)) (y : list R) : R :=
  match ws with [] => 0 | w :: ws' => qdot w y + works_of ws' y end.

Lemma works_of_app a b y : works_of (a ++ b) y = works_of a y + works_of b y.
Proof. induction a as [|w a IH]; cbn; [ring|]. rewrite IH. ring. Qed.

Lemma works_of_rev a y : works_of (rev a) y = works_of a y.
Proof. induction a as [|w a IH]; cbn; [reflexivity|]. rewrite works_of_app, IH. cbn. ring. Qed.

Lemma works_are x rows rs ss y : all_states x rows rs ss ->
  works_of (map wrench_of ss) y = Rows.works rs (forces rows ss) y.
Proof.
  intros A. induction A as [|row r s rows rs ss Fr Er Is A IH]; [reflexivity|].
  cbn [map works_of]. unfold forces. cbn [List.combine map Rows.works fst snd]. fold (forces rows ss).
  rewrite IH. now rewrite (wrench_is row r Fr Er x s y Is).
Qed.

Lemma common_of_divided ws w q : In w ws -> In q w -> (Zpos (Qden q) | common_of ws)%Z.
Proof.
  assert (In1 : forall w d,
    (forall e, (e | d)%Z -> (e | fold_left (fun d q => Z.lcm (Zpos (Qden q)) d) w d)%Z) /\
    (forall q, In q w -> (Zpos (Qden q) | fold_left (fun d q => Z.lcm (Zpos (Qden q)) d) w d)%Z)).
  { induction w0 as [|q0 w0 IH]; intros d; cbn; [split; [auto|contradiction]|].
    destruct (IH (Z.lcm (Zpos (Qden q0)) d)) as [A B]. split.
    - intros e D. apply A. eapply Z.divide_trans; [exact D|apply Z.divide_lcm_r].
    - intros q' [->|H]; [|exact (B _ H)]. apply A. apply Z.divide_lcm_l. }
  unfold common_of. generalize 1%Z.
  induction ws as [|w0 ws IH]; intros d Hw Hq; [contradiction|]. cbn [fold_left]. destruct Hw as [->|Hw].
  - destruct (In1 w d) as [_ B]. specialize (B q Hq).
    revert B. generalize (fold_left (fun d q => Z.lcm (Zpos (Qden q)) d) w d) as d'. clear IH.
    induction ws as [|w0 ws IH]; intros d' B; cbn [fold_left]; [exact B|]. apply IH.
    destruct (In1 w0 d') as [A _]. now apply A.
  - now apply IH.
Qed.

Lemma common_of_positive ws : (0 < common_of ws)%Z.
Proof.
  unfold common_of. assert (In1 : forall w d, (0 < d)%Z -> (0 < fold_left (fun d q => Z.lcm (Zpos (Qden q)) d) w d)%Z).
  { induction w as [|q w IH]; intros d D; cbn; [exact D|]. apply IH.
    pose proof (Z.lcm_nonneg (Zpos (Qden q)) d). assert (Z.lcm (Zpos (Qden q)) d <> 0)%Z; [|lia].
    rewrite Z.lcm_eq_0. lia. }
  generalize 1%Z (eq_refl : (0 < 1)%Z). induction ws as [|w ws IH]; intros d D; cbn; [exact D|].
  apply IH. now apply In1.
Qed.

Lemma adds_up ws y : adds_up_to_zero ws = true -> works_of ws y = 0.
Proof.
  unfold adds_up_to_zero. set (D := common_of ws). intros Z.
  assert (DP : 0 < IZR D) by (apply IZR_lt; apply common_of_positive).
  assert (Num : forall w, (forall q, In q w -> (Zpos (Qden q) | D)%Z) ->
    forall y, rdot (map (numerator D) w) y = IZR D * qdot w y).
  { clear. induction w as [|q w IH]; intros H [|z y]; cbn; try ring.
    rewrite IH by (intros; apply H; now right). destruct (H q (or_introl eq_refl)) as [k Hk].
    assert (NE : IZR (numerator D q) = IZR D * Q2R q).
    { unfold numerator. rewrite Hk, Z.div_mul by lia. rewrite !mult_IZR. unfold Q2R.
      assert (0 < IZR (Zpos (Qden q))) by (apply IZR_lt; lia). field. lra. }
    rewrite NE. ring. }
  assert (G : forall s, rdot (fold_left (fun s w => combine 1 s 1 (map (numerator D) w)) ws s) y
              = rdot s y + IZR D * works_of ws y).
  { assert (All : forall w, In w ws -> forall q, In q w -> (Zpos (Qden q) | D)%Z)
      by (intros; eapply common_of_divided; eassumption).
    clear Z. clearbody D. induction ws as [|w ws' IH]; intros s; cbn [fold_left works_of]; [ring|].
    rewrite IH by (intros; eapply All; eauto; now right). rewrite rdot_combine, Num by (apply All; now left). ring. }
  specialize (G []). rewrite (rdot_all_zero _ y Z) in G. cbn in G. nra.
Qed.

(* The question is one grasp: what its load is. *)
Record exact_load (ld : load) (s : Rows.system) : Prop := ExactLoad {
  load_certain : one_load ld = true;
  load_fits : is_load ld (Rows.wrench s);
  growth_is : map Q2R (load_growth ld) = Rows.direction s;
  growth_length : List.length (Rows.direction s) = List.length (Rows.wrench s)
}.

Lemma load_at_is ld s h l y : exact_load ld s -> qdot (load_at ld h l) y = Rows.load s (IZR h) (IZR l) y.
Proof.
  intros [C W G L]. apply (one_load_is _ _ C) in W. unfold load_at, Rows.load. rewrite W, <- G in *. clear C W G.
  unfold Matrix.real in *. rewrite !map_length in L. revert y L. generalize (load_growth ld) as us.
  assert (J : forall z, Q2R (inject_Z z) = IZR z) by (intros; unfold Q2R; cbn; field).
  induction (load_box ld) as [|i box IH]; intros us y L; destruct us as [|u us]; try discriminate; cbn; [ring|].
  destruct y as [|z y]; cbn; [ring|]. rewrite IH by now injection L. rewrite reduced_same, Q2R_plus, !Q2R_mult, !J. ring.
Qed.

Theorem point_is_equilibrium (two_sided : bool) rows ld s h l ds shares ss :
  Forall2 fits rows (Rows.rows s) -> exact_rows rows = true -> exact_load ld s ->
  Rows.normal s = (if two_sided then Model.bilateral else Model.unilateral) ->
  check_point two_sided (Rows.dimension s) rows ld (h :: l :: ds) shares = inl ss ->
  exists ss', ss = rev ss' /\ all_states (h :: l :: ds) rows (Rows.rows s) ss' /\
    Rows.equilibrium s (real ds) (IZR h) (IZR l) (forces rows ss').
Proof.
  intros F E L Law C. unfold check_point in C.
  destruct (states rows (h :: l :: ds) shares 0 []) as [them|] eqn:S; [|discriminate].
  destruct (two_sided && _) eqn:B; [discriminate|].
  destruct (negb (forallb is_against them)) eqn:G; [discriminate|]. apply negb_false_iff in G.
  destruct (Nat.eqb _ _ && _) eqn:A; [|discriminate]. injection C as <-. apply andb_true_iff in A as [Dim A].
  destruct (states_are _ _ _ _ _ _ _ F E S) as (ss' & -> & All). rewrite app_nil_r in *.
  exists ss'. split; [reflexivity|]. split; [exact All|]. split; [|split].
  - rewrite map_length. now apply Nat.eqb_eq.
  - assert (NB : two_sided = true ->
      Forall (fun s => box_spring (box (state_row s)) || (0 <=? state_v s)%Z = true) ss').
    { intros ->. cbn in B. apply negb_false_iff in B. rewrite forallb_forall in B.
      apply Forall_forall. intros st Hs. apply B. now apply -> in_rev. }
    assert (AG : Forall (fun s => is_against s = true) ss').
    { rewrite forallb_forall in G. apply Forall_forall. intros st Hs. apply G. now apply -> in_rev. }
    rewrite Law. clear - All NB AG.
    induction All as [|row r st rows rs ss Fr Er Is All IH]; [constructor|].
    inversion AG; subst. unfold forces; cbn [List.combine map fst snd]. fold (forces rows ss). constructor.
    + apply (state_obeys row r Fr Er two_sided h l ds st Is); [assumption|]. intros T. specialize (NB T).
      inversion NB; subst. rewrite (its_row _ _ _ _ Is) in *. assumption.
    + apply IH; [|assumption]. intros T. specialize (NB T). now inversion NB.
  - intros y. rewrite map_all_is in A. apply (adds_up _ y) in A. cbn [works_of] in A.
    rewrite map_rev, works_of_rev, (works_are _ _ _ _ y All), (load_at_is _ _ _ _ _ L) in A. exact A.
Qed.

Lemma same_mode_each ss ts : List.length ss = List.length ts -> same_mode ss ts = true ->
  Forall2 (fun s t => contact_mode [s; t] = true) ss ts.
Proof.
  revert ts. induction ss as [|s ss IH]; intros [|t ts] L H; try discriminate; constructor;
    cbn in H; apply andb_true_iff in H as [H1 H2]; [exact H1|]. apply IH; [now injection L|exact H2].
Qed.

Lemma Forall2_rev {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' -> Forall2 P (rev l) (rev l').
Proof. induction 1; cbn; [constructor|]. apply Forall2_app; [assumption|]. now constructor. Qed.

Lemma all_states_length x rows rs ss : all_states x rows rs ss -> List.length ss = List.length rows.
Proof. induction 1; cbn; congruence. Qed.

Lemma same_mode_shares rows rs h l ds ss h' l' ds' ss' :
  all_states (h :: l :: ds) rows rs ss -> all_states (h' :: l' :: ds') rows rs ss' ->
  same_mode (rev ss) (rev ss') = true ->
  share_modes (real ds) (IZR h) (IZR l) (real ds') (IZR h') (IZR l') rs (forces rows ss) (forces rows ss').
Proof.
  intros A A' M. apply same_mode_each in M.
  2:{ rewrite !rev_length, (all_states_length _ _ _ _ A), (all_states_length _ _ _ _ A'). reflexivity. }
  apply Forall2_rev in M. rewrite !rev_involutive in M. revert ss' A' M.
  induction A as [|row r s rows rs ss Fr Er Is A IH]; intros ss' A' M; inversion A'; subst; [constructor|].
  inversion M; subst. unfold forces; cbn [List.combine map fst snd]. fold (forces rows ss) (forces rows ss0).
  destruct (exact_friction row r Fr Er) as (M0 & RE & _).
  constructor; [apply (positive_weights row r Fr)| | |now apply IH].
  - rewrite RE. apply Rmult_le_pos; [exact M0|apply sqrt_pos].
  - now apply two_share_mode.
Qed.

(* A state shares a mode with itself. *)
Lemma self_modes s d h l fs : Rows.equilibrium s d h l fs ->
  Forall (fun r => Rows.positive (Rows.weights r) /\ 0 <= Rows.rho r) (Rows.rows s) ->
  share_modes d h l d h l (Rows.rows s) fs fs.
Proof.
  intros (_ & O & _) P. revert O. generalize (Rows.normal s) as w. intros w O.
  induction O as [|r [a g] rs fs Or O IH]; [constructor|]. inversion P as [|? ? [Wp Rh] P']; subst.
  constructor; [exact Wp|exact Rh| |now apply IH]. destruct Or as (_ & _ & D).
  split; [right; apply Rle_0_sqr|]. right; right. exists (Rows.slip r d), 1, 1. cbn [fst snd].
  split; [lra|]. split; [lra|]. split; [intros t; ring|]. split; [intros t; ring|]. right. now split.
Qed.

End AllContacts.
