(* SPDX-License-Identifier: MIT *)
(* Witnesses (FORMAT.md section 3), at points x = (d, h, l) in integers, and pairs of them that share a
   mode.  `point_is_equilibrium`: a point that is accepted is an equilibrium for the
   wrench h w + l u and the preloads h P + l P^u.  `mixture`: so is every mixture of two points of one
   mode. *)
From Coq Require Import List String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box Leaf.
From Proved Require Model.
Import ListNotations.

(* ---- Checking ---- *)

(* Every parameter of the contact is one number. *)
Definition exact_box (b : cbox) : bool :=
  certain (box_x b) && certain (box_y b) && certain (box_turn b) && certain (box_friction b) &&
  certain (box_preload b) && certain (box_stiffness b).

(* A contact at a point: v and tau up to positive factors, and the share of its friction, which is
   -1 or 1 if it slips. *)
Record state := State { state_v : Z; state_tau : Z; state_share : Q }.

Section Checker.
Open Scope Z_scope.

Definition exact_pull (r : row) : form :=
  match pulls r with p :: _ => first_tip p | [] => [] end.

Definition share_of_slip (tau : Z) : Q :=
  if 0 <? tau then (-1)%Q else if tau <? 0 then 1%Q else 0%Q.

(* Or the contact of which a share is wrong. *)
Fixpoint states (rows : list row) (x : form) (shares : list (Z * list Q)) (number : Z)
    : list state + Z :=
  match rows with
  | [] => match shares with [] => inl [] | (i, _) :: _ => inr i end
  | r :: rows' =>
      let tau := dot (first_tip (tau r)) x in
      let with_share share shares' :=
        match states rows' x shares' (number + 1) with
        | inl rest => inl (State (dot (exact_pull r) x) tau share :: rest)
        | inr i => inr i
        end in
      match shares with
      | (i, s) :: shares' =>
          if i =? number then
            match s with
            | [q] => if (tau =? 0) && Qle_bool (-1) q && Qle_bool q 1 then with_share q shares'
                     else inr i
            | _ => inr i
            end
          else with_share (share_of_slip tau) shares
      | [] => with_share (share_of_slip tau) []
      end
  end.

(* a (N + share mu T), with a = max(0, v); none where a = 0. *)
Definition contact_wrench (r : row) (s : state) : list Q :=
  if state_v s <=? 0 then []
  else
    let b := box r in
    let a := Qmake (state_v s * times (pull_scale r)) (Z.to_pos (over (pull_scale r))) in
    map (fun c => reduced (a * c)%Q)
      (edge_at b (state_share s * low (box_friction b))%Q (low (box_x b)) (low (box_y b))
         (low (box_turn b))).

Definition load_at (ld : load) (h l : Z) : list Q :=
  map (fun p => reduced (inject_Z h * low (fst p) + inject_Z l * snd p)%Q)
    (List.combine (load_box ld) (load_growth ld)).

Definition adds_up_to_zero (wrenches : list (list Q)) : bool :=
  let d := common_denominator (List.concat wrenches) in
  all_zero (fold_left (fun s w => combine 1 s 1 (map (numerator d) w)) wrenches []).

Fixpoint contact_wrenches (rows : list row) (ss : list state) (others : list (list Q))
    : list (list Q) :=
  match rows, ss with
  | r :: rows', s :: ss' => contact_wrenches rows' ss' (contact_wrench r s :: others)
  | _, _ => others
  end.

(* The states at x = (d, h, l), or the rule that fails. *)
Definition check_point (bilateral : bool) (rows : list row) (ld : load) (x : form)
    (shares : list (Z * list Q)) : list state + string :=
  match x with
  | [_; _; _; h; l] =>
      match states rows x shares 0 with
      | inr _ => inr "witness-share"%string
      | inl ss =>
          if bilateral && negb (forallb (fun s => 0 <=? state_v s) ss)
          then inr "witness-normal"%string
          else if adds_up_to_zero (contact_wrenches rows ss [load_at ld h l]) then inl ss
          else inr "witness-balance"%string
      end
  | _ => inr "witness-balance"%string
  end.

Definition opposite (x y : Z) : bool := x * y <? 0.

(* `segment-mode`, of one contact. *)
Definition one_mode (r : row) (s s' : state) : bool :=
  negb (opposite (state_v s) (state_v s')) &&
  (Qeq_bool (low (box_friction (box r))) 0 ||
   ((state_v s <=? 0) && (state_v s' <=? 0)) ||
   (negb (opposite (state_tau s) (state_tau s')) &&
    (let slip := share_of_slip (state_tau s + state_tau s') in
     Qeq_bool slip 0 ||
     (((state_v s <=? 0) || Qeq_bool (state_share s) slip) &&
      ((state_v s' <=? 0) || Qeq_bool (state_share s') slip))))).

Fixpoint same_mode (rows : list row) (ss ss' : list state) : bool :=
  match rows, ss, ss' with
  | r :: rows', s :: ss1, s' :: ss1' => one_mode r s s' && same_mode rows' ss1 ss1'
  | _, _, _ => true
  end.

End Checker.

(* ---- Equilibria at points (d, h, l) ---- *)

Section Points.
Open Scope R_scope.

Definition v_at (c : Model.contact) (d : Model.vector) (h l : R) :=
  Model.preload c / Model.length c * h + Model.growth c / Model.length c * l
  - Model.stiffness c / (Model.length c * Model.length c) * Model.work (Model.N c) d.

Definition obeys_at (w : Model.law) (d : Model.vector) (h l : R) (c : Model.contact)
    (force : R * R) :=
  let (a, b) := force in
  Model.normal_law w (v_at c d h l) a /\
  Rabs b <= Model.friction c * a /\
  (0 < Model.work (Model.T c) d -> b = - (Model.friction c * a)) /\
  (Model.work (Model.T c) d < 0 -> b = Model.friction c * a).

Definition load_of (g : Model.grasp) (h l : R) :=
  Model.add (Model.scale h (Model.wrench g)) (Model.scale l (Model.direction g)).

Definition equilibrium_at (g : Model.grasp) (d : Model.vector) (h l : R) (forces : list (R * R)) :=
  Forall2 (obeys_at (Model.normal g) d h l) (Model.contacts g) forces /\
  Model.add (load_of g h l) (Model.sum (Model.contact_wrenches (Model.contacts g) forces))
  = Model.zero.

Lemma v_at_one c d lambda : v_at c d 1 lambda = Model.v c lambda d.
Proof. unfold v_at, Model.v, Rdiv. ring. Qed.

Lemma equilibrium_at_one g d lambda forces :
  equilibrium_at g d 1 lambda forces -> Model.equilibrium g lambda d forces.
Proof.
  intros [O B]. split.
  - clear B. induction O as [|c [a b] cs fs Oc O IH]; constructor; [|exact IH].
    unfold obeys_at in Oc. now rewrite v_at_one in Oc.
  - rewrite <- B. f_equal. unfold load_of, Model.add, Model.scale; cbn. f_equal; ring.
Qed.

(* ---- Mixtures ---- *)

Definition mix_vector (p : R) (d : Model.vector) (q : R) (d' : Model.vector) :=
  Model.add (Model.scale p d) (Model.scale q d').

Definition mix_force (p : R) (f : R * R) (q : R) (f' : R * R) : R * R :=
  (p * fst f + q * fst f', p * snd f + q * snd f').

Fixpoint mix_forces (p : R) (fs : list (R * R)) (q : R) (fs' : list (R * R)) :=
  match fs, fs' with
  | f :: fs1, f' :: fs1' => mix_force p f q f' :: mix_forces p fs1 q fs1'
  | _, _ => []
  end.

(* FORMAT.md `segment-mode`, over the reals. *)
Definition shares_mode (c : Model.contact) (d : Model.vector) (h l : R) (f : R * R)
    (d' : Model.vector) (h' l' : R) (f' : R * R) :=
  0 <= v_at c d h l * v_at c d' h' l' /\
  (Model.friction c = 0 \/ fst f + fst f' <= 0 \/
   (0 <= Model.work (Model.T c) d * Model.work (Model.T c) d' /\
    (0 < Model.work (Model.T c) d + Model.work (Model.T c) d' ->
       snd f = - (Model.friction c * fst f) /\ snd f' = - (Model.friction c * fst f')) /\
    (Model.work (Model.T c) d + Model.work (Model.T c) d' < 0 ->
       snd f = Model.friction c * fst f /\ snd f' = Model.friction c * fst f'))).

Lemma v_at_mix c d h l d' h' l' p q :
  v_at c (mix_vector p d q d') (p * h + q * h') (p * l + q * l')
  = p * v_at c d h l + q * v_at c d' h' l'.
Proof. unfold v_at, Model.work, mix_vector, Model.add, Model.scale; cbn. ring. Qed.

Lemma work_mix a d d' p q :
  Model.work a (mix_vector p d q d') = p * Model.work a d + q * Model.work a d'.
Proof. unfold Model.work, mix_vector, Model.add, Model.scale; cbn. ring. Qed.

Lemma Rmax_mix p q v v' : 0 <= p -> 0 <= q -> 0 <= v * v' ->
  Rmax 0 (p * v + q * v') = p * Rmax 0 v + q * Rmax 0 v'.
Proof.
  intros P Q H. destruct (Rle_dec 0 v) as [V|V], (Rle_dec 0 v') as [V'|V'].
  - rewrite !Rmax_right; nra.
  - assert (v = 0) by nra. subst v. rewrite (Rmax_right 0 0), (Rmax_left 0 v'), Rmax_left; nra.
  - assert (v' = 0) by nra. subst v'. rewrite (Rmax_right 0 0), (Rmax_left 0 v), Rmax_left; nra.
  - rewrite !Rmax_left; nra.
Qed.

Lemma obeys_mix w c d h l f d' h' l' f' p q : 0 <= p -> 0 <= q -> 0 <= Model.friction c ->
  obeys_at w d h l c f -> obeys_at w d' h' l' c f' -> shares_mode c d h l f d' h' l' f' ->
  obeys_at w (mix_vector p d q d') (p * h + q * h') (p * l + q * l') c (mix_force p f q f').
Proof.
  intros P Q Mu. destruct f as [a b], f' as [a' b'].
  intros (L & C & S1 & S2) (L' & C' & S1' & S2') (V & M). cbn [fst snd] in M.
  unfold obeys_at, mix_force. cbn [fst snd]. rewrite v_at_mix, work_mix.
  set (v := v_at c d h l) in *. set (v' := v_at c d' h' l') in *.
  set (t := Model.work (Model.T c) d) in *. set (t' := Model.work (Model.T c) d') in *.
  set (mu := Model.friction c) in *.
  assert (A0 : 0 <= a) by (destruct w; cbn in L; [rewrite L; apply Rmax_l|lra]).
  assert (A0' : 0 <= a') by (destruct w; cbn in L'; [rewrite L'; apply Rmax_l|lra]).
  apply Rabs_within in C. apply Rabs_within in C'.
  split; [|split; [|split]].
  - destruct w; cbn in *; [|nra]. subst a a'. now rewrite Rmax_mix.
  - apply Rabs_le. split; nra.
  - intros Slip. destruct M as [M|[M|(T0 & M & _)]].
    + rewrite M in *. nra.
    + assert (a = 0) by lra. assert (a' = 0) by lra. subst a a'. nra.
    + assert (0 < t + t').
      { destruct (Rle_dec t 0), (Rle_dec t' 0); nra. }
      destruct (M H) as [-> ->]. ring.
  - intros Slip. destruct M as [M|[M|(T0 & _ & M)]].
    + rewrite M in *. nra.
    + assert (a = 0) by lra. assert (a' = 0) by lra. subst a a'. nra.
    + assert (t + t' < 0).
      { destruct (Rle_dec 0 t), (Rle_dec 0 t'); nra. }
      destruct (M H) as [-> ->]. ring.
Qed.

Inductive share_modes (d : Model.vector) (h l : R) (d' : Model.vector) (h' l' : R)
    : list Model.contact -> list (R * R) -> list (R * R) -> Prop :=
  | modes_nil : share_modes d h l d' h' l' [] [] []
  | modes_cons c f f' cs fs fs' : 0 <= Model.friction c ->
      shares_mode c d h l f d' h' l' f' -> share_modes d h l d' h' l' cs fs fs' ->
      share_modes d h l d' h' l' (c :: cs) (f :: fs) (f' :: fs').

Theorem mixture g d h l forces d' h' l' forces' p q : 0 <= p -> 0 <= q ->
  equilibrium_at g d h l forces -> equilibrium_at g d' h' l' forces' ->
  share_modes d h l d' h' l' (Model.contacts g) forces forces' ->
  equilibrium_at g (mix_vector p d q d') (p * h + q * h') (p * l + q * l')
    (mix_forces p forces q forces').
Proof.
  intros P Q [O B] [O' B'] M. split.
  - clear B B'. induction M as [|c f f' cs fs fs' Mu Mc M IH]; [constructor|].
    inversion O; inversion O'; subst. constructor; [now apply obeys_mix | now apply IH].
  - assert (E : Model.sum (Model.contact_wrenches (Model.contacts g) (mix_forces p forces q forces'))
      = mix_vector p (Model.sum (Model.contact_wrenches (Model.contacts g) forces))
          q (Model.sum (Model.contact_wrenches (Model.contacts g) forces'))).
    { clear - M. induction M as [|c f f' cs fs fs' Mu Mc M IH].
      - unfold mix_vector, Model.add, Model.scale, Model.sum; cbn. unfold Model.zero. f_equal; ring.
      - unfold Model.sum, Model.contact_wrenches in *. cbn. rewrite IH.
        unfold mix_vector, Model.add, Model.scale, Model.contact_wrench; cbn. f_equal; ring. }
    rewrite E. clear E M O O'.
    set (S := Model.sum _) in *. set (S' := Model.sum _) in *.
    unfold Model.add, load_of, Model.scale, Model.zero in *. cbn in *.
    injection B as B1 B2 B3. injection B' as B1' B2' B3'.
    unfold mix_vector, Model.add, Model.scale; cbn. f_equal; nra.
Qed.

End Points.

(* ---- What is accepted is an equilibrium ---- *)

Section Exact.
Open Scope R_scope.

Variable row : row.
Variable c : Model.contact.
Hypothesis F : fits row c.
Hypothesis X : exact_box (box row) = true.

Lemma exact_shares e : parameters row = O /\ shares_in (box row) e c = [].
Proof.
  destruct F as [E _]. unfold exact_box in X. rewrite !andb_true_iff in X.
  destruct X as [[[[[Hx Hy] Ht] _] _] _]. split.
  - rewrite E. cbn -[Nat.add]. unfold count. now rewrite Hx, Hy, Ht.
  - unfold shares_in, share. now rewrite Hx, Hy, Ht.
Qed.

Lemma exact_ends : pull_ends (box row) = [(low (box_preload (box row)), low (box_stiffness (box row)))].
Proof.
  unfold exact_box in X. rewrite !andb_true_iff in X. destruct X as [[[[[_ _] _] _] Hp] Hk].
  unfold pull_ends, ends. now rewrite Hp, Hk.
Qed.

Lemma exact_v d h l : v_at c d h l = unit (pull_scale row) * rdot (exact_pull row) (located d h l).
Proof.
  pose proof F as [E (e & I)]. destruct (exact_shares e) as [_ SS].
  assert (PE : exact_pull row = first_tip (integer_tree (pull_scaling (box row))
    (corners (box row) (pull_at (box row) (low (box_preload (box row))) (low (box_stiffness (box row))))))).
  { unfold exact_pull, pull_scaling. rewrite E at 1. cbn [pulls make_row]. rewrite exact_ends.
    reflexivity. }
  assert (SE : pull_scale row = pull_scaling (box row)) by (rewrite E at 1; reflexivity).
  rewrite PE, SE.
  assert (A : forall factor, factor * v_at c d h l <= factor * (unit (pull_scaling (box row)) *
    rdot (first_tip (integer_tree (pull_scaling (box row))
      (corners (box row) (pull_at (box row) (low (box_preload (box row)))
         (low (box_stiffness (box row))))))) (located d h l))).
  { intros f. unfold v_at. apply (v_at_ends (box row) e c I). intros p k Hpk.
    assert (Hpk' := Hpk). rewrite exact_ends in Hpk'. destruct Hpk' as [Hpk'|[]].
    injection Hpk' as <- <-. rewrite (pull_corners (box row) e c I _ _ d h l Hpk), SS, eval_first.
    lra. }
  pose proof (A 1). pose proof (A (-1)). lra.
Qed.

Lemma exact_tau d h l : exists u, 0 < u /\
  Model.work (Model.T c) d = u * rdot (first_tip (tau row)) (located d h l).
Proof.
  pose proof F as [E (e & I)]. destruct (exact_shares e) as [_ SS].
  exists (unit (scaling_of_trees [corners (box row) (T_at (box row))])).
  split; [apply trees_unit_positive|].
  rewrite (tau_corners (box row) e c I d h l), SS, eval_first, <- E. reflexivity.
Qed.

Lemma exact_friction : Model.friction c = Q2R (low (box_friction (box row))) /\ 0 <= Model.friction c.
Proof.
  destruct F as [_ (e & I)]. unfold exact_box in X. rewrite !andb_true_iff in X.
  destruct X as [[[[[_ _] _] Hf] _] _]. split; [|apply I].
  apply certain_within; [exact Hf | apply I].
Qed.

Definition vector_of (w : list Q) : Model.vector :=
  match w with
  | [a; b; d] => Model.Vector (Q2R a) (Q2R b) (Q2R d)
  | _ => Model.zero
  end.

Definition forces_of (s : state) : R * R :=
  let a := if (state_v s <=? 0)%Z then 0 else unit (pull_scale row) * IZR (state_v s) in
  (a, Q2R (state_share s) * (Model.friction c * a)).

Lemma pull_scale_positive : (0 < over (pull_scale row))%Z /\ 0 < unit (pull_scale row).
Proof.
  destruct F as [E _]. rewrite E. cbn [pull_scale make_row]. split.
  - apply lt_IZR. apply over_positive.
  - apply trees_unit_positive.
Qed.

Lemma contact_wrench_is s :
  vector_of (contact_wrench row s) = Model.contact_wrench c (forces_of s) /\
  (List.length (contact_wrench row s) = 0 \/ List.length (contact_wrench row s) = 3)%nat.
Proof.
  unfold contact_wrench, forces_of. destruct (Z.leb_spec (state_v s) 0) as [V|V].
  - split; [|now left]. cbn. unfold Model.contact_wrench, Model.add, Model.scale, Model.zero; cbn.
    f_equal; ring.
  - split; [|right; reflexivity]. destruct exact_friction as [Mu _].
    destruct pull_scale_positive as [OP _].
    pose proof F as [_ (e & I)]. assert (X' := X). unfold exact_box in X'.
    rewrite !andb_true_iff in X'. destruct X' as [[[[[Hx Hy] Ht] _] _] _].
    pose proof (certain_within _ _ Hx (in_x _ _ _ I)) as Ex.
    pose proof (certain_within _ _ Hy (in_y _ _ _ I)) as Ey.
    pose proof (certain_within _ _ Ht (in_turn _ _ _ I)) as Et.
    assert (A : Q2R (state_v s * times (pull_scale row) # Z.to_pos (over (pull_scale row)))
                = unit (pull_scale row) * IZR (state_v s)).
    { unfold Q2R, unit; cbn [Qnum Qden]. rewrite Z2Pos.id, mult_IZR by exact OP. field.
      apply IZR_lt in OP. lra. }
    unfold edge_at, at_point, turned_x, turned_y. cbn [map vector_of].
    rewrite !reduced_same.
    repeat rewrite ?Q2R_mult, ?Q2R_plus, ?Q2R_minus. rewrite A, <- Mu.
    unfold Model.contact_wrench, Model.add, Model.scale, Model.N, Model.T, Model.force_at; cbn.
    rewrite (is_nx _ _ _ I), (is_ny _ _ _ I), Ex, Ey, Et. f_equal; ring.
Qed.

(* The states that `states` computes. *)
Definition is_state (x : form) (s : state) : Prop :=
  state_v s = dot (exact_pull row) x /\ state_tau s = dot (first_tip (tau row)) x /\
  -1 <= Q2R (state_share s) <= 1 /\
  ((0 < state_tau s)%Z -> Q2R (state_share s) = -1) /\
  ((state_tau s < 0)%Z -> Q2R (state_share s) = 1).

Definition vector_at (x y z : Z) := Model.Vector (IZR x) (IZR y) (IZR z).

Lemma at_integers x y z h l :
  located (vector_at x y z) (IZR h) (IZR l) = map IZR [x; y; z; h; l].
Proof. reflexivity. Qed.

Lemma state_obeys (two_sided : bool) x y z h l s : is_state [x; y; z; h; l] s ->
  (two_sided = true -> 0 <= state_v s)%Z ->
  obeys_at (if two_sided then Model.bilateral else Model.unilateral) (vector_at x y z) (IZR h) (IZR l)
    c (forces_of s).
Proof.
  intros (V & T & [S0 S1] & Plus & Minus) B. destruct exact_friction as [_ Mu].
  destruct pull_scale_positive as [_ U].
  pose proof (exact_v (vector_at x y z) (IZR h) (IZR l)) as EV.
  destruct (exact_tau (vector_at x y z) (IZR h) (IZR l)) as (u & Pu & ET).
  rewrite at_integers, rdot_integers in EV, ET. rewrite <- V in EV. rewrite <- T in ET.
  unfold obeys_at, forces_of. rewrite EV, ET.
  assert (A : (if (state_v s <=? 0)%Z then 0 else unit (pull_scale row) * IZR (state_v s))
              = Rmax 0 (unit (pull_scale row) * IZR (state_v s))).
  { destruct (Z.leb_spec (state_v s) 0) as [H|H].
    - apply IZR_le in H. rewrite Rmax_left; nra.
    - apply IZR_lt in H. rewrite Rmax_right; nra. }
  rewrite A. set (a := Rmax 0 _). assert (A0 : 0 <= a) by apply Rmax_l.
  split; [|split; [|split]].
  - destruct two_sided; cbn; [|reflexivity]. specialize (B eq_refl). apply IZR_le in B.
    assert (0 <= unit (pull_scale row) * IZR (state_v s)) by nra. unfold a.
    rewrite Rmax_right by assumption. split; [reflexivity|assumption].
  - assert (0 <= Model.friction c * a) by nra. apply Rabs_le. split; nra.
  - intros H. rewrite Plus; [ring|]. apply lt_IZR. nra.
  - intros H. rewrite Minus; [ring|]. apply lt_IZR. nra.
Qed.

(* Two states of one mode. *)
Lemma one_mode_shares x y z h l s x' y' z' h' l' s' :
  is_state [x; y; z; h; l] s -> is_state [x'; y'; z'; h'; l'] s' -> one_mode row s s' = true ->
  shares_mode c (vector_at x y z) (IZR h) (IZR l) (forces_of s)
    (vector_at x' y' z') (IZR h') (IZR l') (forces_of s').
Proof.
  intros (V & T & _) (V' & T' & _) M. destruct pull_scale_positive as [_ U].
  destruct exact_friction as [Mu Mu0].
  pose proof (exact_v (vector_at x y z) (IZR h) (IZR l)) as EV.
  pose proof (exact_v (vector_at x' y' z') (IZR h') (IZR l')) as EV'.
  assert (ET : exists u, 0 < u /\
    Model.work (Model.T c) (vector_at x y z) = u * IZR (state_tau s) /\
    Model.work (Model.T c) (vector_at x' y' z') = u * IZR (state_tau s')).
  { pose proof F as [E (e & I)]. destruct (exact_shares e) as [_ SS].
    exists (unit (scaling_of_trees [corners (box row) (T_at (box row))])).
    split; [apply trees_unit_positive|].
    rewrite (tau_corners (box row) e c I (vector_at x y z) (IZR h) (IZR l)).
    rewrite (tau_corners (box row) e c I (vector_at x' y' z') (IZR h') (IZR l')).
    rewrite SS, !eval_first, <- E, !at_integers, !rdot_integers, T, T'. now split. }
  destruct ET as (u & Pu & ET & ET').
  rewrite at_integers, rdot_integers, <- V in EV.
  rewrite at_integers, rdot_integers, <- V' in EV'.
  unfold one_mode in M. apply andb_true_iff in M as [MV M]. apply negb_true_iff in MV.
  unfold opposite in *. apply Z.ltb_ge in MV. apply IZR_le in MV. rewrite mult_IZR in MV.
  unfold shares_mode. rewrite EV, EV', ET, ET'. split.
  { replace (unit (pull_scale row) * IZR (state_v s) * (unit (pull_scale row) * IZR (state_v s')))
      with (unit (pull_scale row) * unit (pull_scale row) * (IZR (state_v s) * IZR (state_v s')))
      by ring. apply Rmult_le_pos; nra. }
  apply orb_true_iff in M as [M|M]; [apply orb_true_iff in M as [M|M]|].
  - left. apply Qeq_bool_eq, Qeq_eqR in M. rewrite Q2R_0 in M. lra.
  - right; left. apply andb_true_iff in M as [M1 M2]. unfold forces_of. cbn [fst].
    rewrite M1, M2. lra.
  - right; right. apply andb_true_iff in M as [MT M]. apply negb_true_iff, Z.ltb_ge, IZR_le in MT.
    rewrite mult_IZR in MT.
    assert (SignFull : forall q : Q, Q2R q <> 0 ->
      Qeq_bool (share_of_slip (state_tau s + state_tau s')) 0
       || ((state_v s <=? 0)%Z || Qeq_bool (state_share s) (share_of_slip (state_tau s + state_tau s'))) &&
          ((state_v s' <=? 0)%Z || Qeq_bool (state_share s') (share_of_slip (state_tau s + state_tau s'))) = true ->
      share_of_slip (state_tau s + state_tau s') = q ->
      snd (forces_of s) = Q2R q * (Model.friction c * fst (forces_of s)) /\
      snd (forces_of s') = Q2R q * (Model.friction c * fst (forces_of s'))).
    { intros q NZ H E. rewrite E in H. apply orb_true_iff in H as [H|H].
      - apply Qeq_bool_eq, Qeq_eqR in H. rewrite Q2R_0 in H. contradiction.
      - apply andb_true_iff in H as [H1 H2]. unfold forces_of. cbn [fst snd]. split.
        + apply orb_true_iff in H1 as [H1|H1]; [rewrite H1; ring|].
          apply Qeq_bool_eq, Qeq_eqR in H1. now rewrite H1.
        + apply orb_true_iff in H2 as [H2|H2]; [rewrite H2; ring|].
          apply Qeq_bool_eq, Qeq_eqR in H2. now rewrite H2. }
    split; [|split].
    + replace (u * IZR (state_tau s) * (u * IZR (state_tau s')))
        with (u * u * (IZR (state_tau s) * IZR (state_tau s'))) by ring. apply Rmult_le_pos; nra.
    + intros H. assert (P : (0 < state_tau s + state_tau s')%Z).
      { apply lt_IZR. rewrite plus_IZR. nra. }
      destruct (SignFull (-1)%Q) as [A B].
      * unfold Q2R; cbn. lra.
      * exact M.
      * unfold share_of_slip. apply Z.ltb_lt in P. now rewrite P.
      * rewrite A, B. replace (Q2R (-1)) with (-1) by (unfold Q2R; cbn; field). split; ring.
    + intros H. assert (P : (state_tau s + state_tau s' < 0)%Z).
      { apply lt_IZR. rewrite plus_IZR. nra. }
      destruct (SignFull 1%Q) as [A B].
      * unfold Q2R; cbn. lra.
      * exact M.
      * unfold share_of_slip. destruct (Z.ltb_spec 0 (state_tau s + state_tau s')); [lia|].
        apply Z.ltb_lt in P. now rewrite P.
      * rewrite A, B, Q2R_1. split; ring.
Qed.

End Exact.

Section AllContacts.
Open Scope R_scope.

Definition exact_rows (rows : list row) := forallb (fun r => exact_box (box r)) rows.

Inductive are_states (x : form) : list row -> list state -> Prop :=
  | are_nil : are_states x [] []
  | are_cons r s rows ss : is_state r x s -> are_states x rows ss ->
      are_states x (r :: rows) (s :: ss).

Lemma share_of_slip_is t : -1 <= Q2R (share_of_slip t) <= 1 /\
  ((0 < t)%Z -> Q2R (share_of_slip t) = -1) /\ ((t < 0)%Z -> Q2R (share_of_slip t) = 1).
Proof.
  unfold share_of_slip. destruct (Z.ltb_spec 0 t); [|destruct (Z.ltb_spec t 0)];
    unfold Q2R; cbn; repeat split; intros; try lia; lra.
Qed.

Lemma states_are rows x shares n ss : states rows x shares n = inl ss -> are_states x rows ss.
Proof.
  revert shares n ss. induction rows as [|r rows IH]; intros shares n ss; cbn [states].
  - destruct shares as [|[i s] shares]; [|discriminate]. intros E. injection E as <-. constructor.
  - set (t := dot (first_tip (tau r)) x).
    assert (Slip : forall shares' n',
      match states rows x shares' n' with
      | inl rest => inl (State (dot (exact_pull r) x) t (share_of_slip t) :: rest)
      | inr i => inr i end = inl ss -> are_states x (r :: rows) ss).
    { intros shares' n' H. destruct (states rows x shares' n') as [rest|] eqn:E; [|discriminate].
      injection H as <-. constructor; [|eapply IH; eassumption].
      unfold is_state; cbn. destruct (share_of_slip_is t) as (A & B & C). repeat split; try tauto. }
    destruct shares as [|[i s] shares]; [apply Slip|].
    destruct (Z.eqb i n); [|apply Slip].
    destruct s as [|q [|? ?]]; try discriminate.
    destruct (_ && _) eqn:C; [|discriminate]. rewrite !andb_true_iff in C. destruct C as [[T0 C1] C2].
    apply Z.eqb_eq in T0. apply Qle_bool_R in C1, C2. rewrite Q2R_1 in C2.
    replace (Q2R (-1)) with (-1) in C1 by (unfold Q2R; cbn; field).
    destruct (states rows x shares (n + 1)) as [rest|] eqn:E; [|discriminate].
    intros H. injection H as <-. constructor; [|eapply IH; eassumption].
    unfold is_state; cbn. fold t. rewrite T0. repeat split; try assumption; lia.
Qed.

Fixpoint all_forces (rows : list row) (cs : list Model.contact) (ss : list state) : list (R * R) :=
  match rows, cs, ss with
  | r :: rows', c :: cs', s :: ss' => forces_of r c s :: all_forces rows' cs' ss'
  | _, _, _ => []
  end.

Lemma vector_add_assoc a b c : Model.add a (Model.add b c) = Model.add (Model.add a b) c.
Proof. unfold Model.add; cbn. f_equal; ring. Qed.

Lemma vector_add_comm a b : Model.add a b = Model.add b a.
Proof. unfold Model.add; cbn. f_equal; ring. Qed.

Definition short_list (w : list Q) := (List.length w = 0 \/ List.length w = 3)%nat.

Lemma contact_wrenches_are rows cs ss x others :
  Forall2 fits rows cs -> exact_rows rows = true -> are_states x rows ss ->
  Model.sum (map vector_of (contact_wrenches rows ss others)) =
  Model.add (Model.sum (Model.contact_wrenches cs (all_forces rows cs ss)))
    (Model.sum (map vector_of others)) /\
  (Forall short_list others -> Forall short_list (contact_wrenches rows ss others)).
Proof.
  intros F. revert ss others. induction F as [|r c rows cs Fr F IH]; intros ss others E A;
    inversion A; subst.
  - split; [|cbn; auto]. cbn. unfold Model.add, Model.sum; cbn.
    destruct (fold_right _ _ _); cbn. f_equal; ring.
  - cbn in E. apply andb_true_iff in E as [Er E].
    destruct (contact_wrench_is r c Fr Er s) as [W L]. cbn [contact_wrenches].
    destruct (IH ss0 (contact_wrench r s :: others) E H3) as [S L']. split.
    + rewrite S. cbn [map]. unfold Model.sum, Model.contact_wrenches. cbn. rewrite W.
      rewrite !vector_add_assoc. f_equal. apply vector_add_comm.
    + intros O. apply L'. constructor; [exact L|exact O].
Qed.

Lemma numerator_exact qs q : In q qs ->
  IZR (numerator (common_denominator qs) q) = IZR (common_denominator qs) * Q2R q.
Proof.
  intros H. pose proof (common_denominator_divided qs q H) as [k Hk]. unfold numerator.
  rewrite Hk, Z.div_mul by lia. rewrite !mult_IZR. unfold Q2R.
  assert (0 < IZR (Zpos (Qden q))) by (apply IZR_lt; lia). field. lra.
Qed.

(* In the plane and in space: what the wrenches' entries of one place add up to. *)
Lemma entry_adds_up {T} (add : T -> T -> T) (zero : T) (of : list Q -> T) (pick : T -> R) k ws :
  adds_up_to_zero ws = true ->
  (forall a b, pick (add a b) = pick a + pick b) -> pick zero = 0 ->
  (forall w, In w ws -> pick (of w) = Q2R (nth k w 0%Q)) ->
  pick (fold_right add zero (map of ws)) = 0.
Proof.
  unfold adds_up_to_zero. set (D := common_denominator (List.concat ws)). intros Z Add Zero Of.
  assert (DP : 0 < IZR D) by (apply IZR_lt; apply common_denominator_positive).
  set (e := repeat 0%Z k ++ [1%Z]).
  assert (Entry : forall w, In w ws -> IZR (dot e (map (numerator D) w)) = IZR D * pick (of w)).
  { intros w Hw. rewrite (Of w Hw).
    replace (dot e (map (numerator D) w)) with (numerator D (nth k w 0%Q)).
    - destruct (nth_in_or_default k w 0%Q) as [H|H]; [|rewrite H; unfold numerator, Q2R; cbn; ring].
      apply numerator_exact, in_concat. now exists w.
    - clear. unfold e. clear e. clearbody D. revert k. induction w as [|q w IH]; intros [|k]; cbn [repeat app map dot nth].
      1, 2: reflexivity. + destruct (map (numerator D) w); cbn [dot]; lia. + rewrite IH. lia. }
  assert (G : forall s, IZR (dot e (fold_left (fun s w => combine 1 s 1 (map (numerator D) w)) ws s))
              = IZR (dot e s) + IZR D * pick (fold_right add zero (map of ws))).
  { clear Z Of. clearbody D. induction ws as [|w ws' IH]; intros s; cbn [fold_left fold_right map].
    - rewrite Zero. ring.
    - rewrite IH by (intros; apply Entry; now right). rewrite dot_combine, plus_IZR, !mult_IZR.
      rewrite (Entry w) by now left. rewrite Add. ring. }
  specialize (G []). rewrite (dot_all_zero e _ Z), dot_nil_r in G. nra.
Qed.

Lemma adds_up ws : Forall short_list ws -> adds_up_to_zero ws = true ->
  Model.sum (map vector_of ws) = Model.zero.
Proof.
  intros L Z. rewrite Forall_forall in L.
  assert (E : forall w, In w ws -> vector_of w =
    Model.Vector (Q2R (nth 0 w 0%Q)) (Q2R (nth 1 w 0%Q)) (Q2R (nth 2 w 0%Q))).
  { intros w Hw. destruct w as [|a [|b [|c [|? ?]]]]; destruct (L _ Hw); try discriminate; [|reflexivity].
    cbn. now rewrite RMicromega.Q2R_0. }
  assert (Entry := fun k pick => entry_adds_up Model.add Model.zero vector_of pick k ws Z).
  assert (X := Entry 0%nat Model.along_x ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (Y := Entry 1%nat Model.along_y ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  assert (T := Entry 2%nat Model.about_z ltac:(reflexivity) eq_refl ltac:(intros w Hw; now rewrite E)).
  unfold Model.sum. destruct (fold_right _ _ _). cbn in *. unfold Model.zero. congruence.
Qed.

(* The question is one grasp: what its load is. *)
Record exact_load (ld : load) (g : Model.grasp) : Prop := ExactLoad {
  wrench_is : Forall2 within (load_box ld)
    [Model.along_x (Model.wrench g); Model.along_y (Model.wrench g);
     Model.about_z (Model.wrench g)];
  wrench_exact : forallb certain (load_box ld) = true;
  growth_is : map Q2R (load_growth ld) =
    [Model.along_x (Model.direction g); Model.along_y (Model.direction g);
     Model.about_z (Model.direction g)]
}.

Lemma load_at_is ld g h l : exact_load ld g ->
  vector_of (load_at ld h l) = load_of g (IZR h) (IZR l) /\ short_list (load_at ld h l).
Proof.
  intros [W E G]. unfold load_at.
  destruct (load_box ld) as [|i1 [|i2 [|i3 [|? ?]]]];
    try (exfalso; inversion W; subst; repeat match goal with H : Forall2 _ _ _ |- _ => inversion H; subst; clear H end; fail).
  destruct (load_growth ld) as [|u1 [|u2 [|u3 [|? ?]]]]; try discriminate.
  injection G as G1 G2 G3. inversion W as [|? ? ? ? W1 W']; subst.
  inversion W' as [|? ? ? ? W2 W'']; subst. inversion W'' as [|? ? ? ? W3 _]; subst.
  cbn in E. rewrite !andb_true_iff in E. destruct E as (E1 & E2 & E3 & _).
  apply (certain_within _ _ E1) in W1. apply (certain_within _ _ E2) in W2.
  apply (certain_within _ _ E3) in W3. split; [|right; reflexivity].
  cbn [List.combine map vector_of fst snd]. rewrite !reduced_same.
  assert (J : forall z, Q2R (inject_Z z) = IZR z) by (intros; unfold Q2R; cbn; field).
  repeat rewrite ?Q2R_plus, ?Q2R_mult, ?J. unfold load_of, Model.add, Model.scale; cbn.
  rewrite W1, W2, W3, <- G1, <- G2, <- G3. reflexivity.
Qed.

Theorem point_is_equilibrium (two_sided : bool) rows ld g x y z h l shares ss :
  Forall2 fits rows (Model.contacts g) -> exact_rows rows = true -> exact_load ld g ->
  Model.normal g = (if two_sided then Model.bilateral else Model.unilateral) ->
  check_point two_sided rows ld [x; y; z; h; l] shares = inl ss ->
  are_states [x; y; z; h; l] rows ss /\
  equilibrium_at g (vector_at x y z) (IZR h) (IZR l) (all_forces rows (Model.contacts g) ss).
Proof.
  intros F E L Law C. unfold check_point in C.
  destruct (states rows [x; y; z; h; l] shares 0) as [ss'|] eqn:S; [|discriminate].
  destruct (two_sided && _) eqn:B; [discriminate|].
  destruct (adds_up_to_zero _) eqn:A; [|discriminate]. injection C as ->.
  apply states_are in S. split; [exact S|].
  assert (NB : two_sided = true -> Forall (fun s => 0 <= state_v s)%Z ss).
  { intros ->. cbn in B. apply negb_false_iff in B. rewrite forallb_forall in B.
    apply Forall_forall. intros s Hs. apply Z.leb_le. auto. }
  destruct (load_at_is ld g h l L) as [LA LS].
  destruct (contact_wrenches_are rows _ ss _ [load_at ld h l] F E S) as [SUM SHORT].
  split.
  - rewrite Law. clear A SUM SHORT B Law. revert ss S NB.
    induction F as [|r c rows cs Fr F IH]; intros ss S NB; inversion S; subst; cbn [all_forces];
      [constructor|].
    cbn in E. apply andb_true_iff in E as [Er E]. constructor.
    + apply state_obeys; try assumption. intros T. specialize (NB T). now inversion NB.
    + apply IH; try assumption. intros T. specialize (NB T). now inversion NB.
  - apply adds_up in A; [|apply SHORT; constructor; [exact LS|constructor]].
    rewrite SUM in A. rewrite <- A. rewrite vector_add_comm. f_equal.
    cbn [map Model.sum fold_right]. rewrite LA. destruct (load_of g (IZR h) (IZR l)).
    unfold Model.sum, Model.add, Model.zero; cbn. f_equal; ring.
Qed.

Lemma same_mode_shares rows cs x y z h l ss x' y' z' h' l' ss' :
  Forall2 fits rows cs -> exact_rows rows = true ->
  are_states [x; y; z; h; l] rows ss -> are_states [x'; y'; z'; h'; l'] rows ss' ->
  same_mode rows ss ss' = true ->
  share_modes (vector_at x y z) (IZR h) (IZR l) (vector_at x' y' z') (IZR h') (IZR l')
    cs (all_forces rows cs ss) (all_forces rows cs ss').
Proof.
  intros F. revert ss ss'. induction F as [|r c rows cs Fr F IH]; intros ss ss' E S S' M;
    inversion S; inversion S'; subst; cbn [all_forces]; [constructor|].
  cbn in E, M. apply andb_true_iff in E as [Er E]. apply andb_true_iff in M as [Mr M].
  constructor.
  - apply (exact_friction r c Fr Er).
  - now apply one_mode_shares.
  - now apply IH.
Qed.

End AllContacts.
