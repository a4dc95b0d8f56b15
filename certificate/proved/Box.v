(* SPDX-License-Identifier: MIT *)
(* The enlarged box of a contact's parameters (FORMAT.md section 6), which for a question without
   uncertainty is one point; and its row: in integers, everything that trees need to know of it.
   `forms_corners`, `edge_corners` and `pull_corners`: what the integers of a row mean.  Contacts.v says that
   every choice of a question is a point of its box. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Root.
From Proved Require Rows.
Import ListNotations.

(* ---- The box of a contact ---- *)

(* Its geometry is whatever N and slips depend on, multilinearly. *)
Record cbox := CBox {
  box_names : list parameter;
  box_geometry : list interval;
  box_forms : list Q -> list (list Q);    (* N, and a form for each component of a slip *)
  box_friction : interval;                (* mu *)
  box_preload : interval;                 (* P' *)
  box_growth : interval;                  (* what P' grows by, in step with P' in its interval *)
  box_stiffness : interval;               (* k' *)
  box_square : Q;                         (* rho is mu times its root *)
  box_normal : list Q;                    (* friction is across it *)
  box_weights : list Q;                   (* of the product of slips *)
  box_signed : bool;                      (* slips have one component, or none, and so a sign *)
  box_spring : bool;
  box_turns : bool;                       (* the normal is uncertain, in space *)
  box_slack : list interval -> Q          (* the largest |n|^2 / |n0|^2 - 1 of a geometry *)
}.

(* Ratchets and springs have none. *)
Definition has_friction (b : cbox) : bool := match box_normal b with [] => false | _ => true end.

Section Inside.
Open Scope R_scope.

(* A row whose parameters are a point of the box. *)
Record inside_at (b : cbox) (r : Rows.row) (p : list R) (F : list R -> list (list R)) (mu t : R)
    : Prop := Inside {
  in_geometry : Forall2 within (box_geometry b) p;
  is_forms : Rows.N r :: Rows.slips r = F p;
  forms_rational : forall qs, F (map Q2R qs) = map (map Q2R) (box_forms b qs);
  forms_affine : forall j d,
    multiaffine (List.length (box_geometry b)) (fun p => Rows.dot (nth j (F p) []) d);
  forms_shape : forall p p', List.length p = List.length (box_geometry b) ->
    List.length p' = List.length (box_geometry b) -> map (@List.length R) (F p) = map (@List.length R) (F p');
  in_friction : within (box_friction b) mu;
  friction_nonneg : 0 <= mu;
  is_rho : Rows.rho r = mu * sqrt (Q2R (box_square b));
  square_nonneg : 0 <= Q2R (box_square b);
  is_weights : Rows.weights r = map Q2R (box_weights b);
  weights_positive : Rows.positive (Rows.weights r);
  in_step : 0 <= t <= 1;
  in_preload : Rows.preload r = (1 - t) * Q2R (low (box_preload b)) + t * Q2R (high (box_preload b));
  in_growth : Rows.growth r = (1 - t) * Q2R (low (box_growth b)) + t * Q2R (high (box_growth b));
  in_stiffness : within (box_stiffness b) (Rows.stiffness r);
  is_spring : Rows.spring r = box_spring b;
  spring_smooth : box_spring b = true -> mu = 0;
  spring_alone : box_spring b = true -> Rows.slips r = [];
  spring_signed : box_signed b = false -> box_spring b = false;
  slack_nonneg : forall is, 0 <= Q2R (box_slack b is);
  signed_straight : box_signed b = true -> box_turns b = false;
  is_signed : box_signed b = true ->
    (Rows.slips r = [] \/ exists T, Rows.slips r = [T]) /\ Rows.weights r = map (fun _ => 1) (Rows.slips r) /\
    Q2R (box_square b) = 1
}.

Definition inside (b : cbox) (r : Rows.row) := exists p F mu t, inside_at b r p F mu t.

End Inside.

(* ---- The row of a contact ---- *)

(* Forms are of points (h, l, d); shorter ones do not see the last coordinates. *)
Record row := Row {
  box : cbox;
  forms : multi (list form);        (* N and the slip's forms at the corners, times a factor *)
  forms_scale : scaling;
  metric : list Z;                  (* the weights of the product of slips, times a factor *)
  metric_scale : scaling;
  slip_certain : bool;
  (* of slips with a sign: they, and minus they *)
  tau : multi form;
  minus_tau : multi form;
  (* N + s T, times a factor, for the s between which friction may be, by the sign of slip *)
  edges_plus : list (multi form);
  edges_minus : list (multi form);
  edges_none : list (multi form);
  (* v, times a factor, for the ends of P' and k' *)
  pulls : list (multi form);
  pull_scale : scaling;
  separates : option form;          (* v up to a positive factor, if it is certain *)
  slack : Q;
  parameters : nat;                 (* how many of the geometry are uncertain *)
  weight : Z; over_weight : Z       (* edge times pull times 2^parameters times this quotient is exact *)
}.

Definition geometry_tree (b : cbox) : multi (list (list Q)) := corners (box_geometry b) (box_forms b).

Fixpoint add_multiple (a : list Q) (s : Q) (b : list Q) : list Q :=
  match a, b with
  | x :: a', y :: b' => (x + s * y)%Q :: add_multiple a' s b'
  | _, [] => a
  | [], _ => map (Qmult s) b
  end.

(* Friction by d alone: with nothing for h and l. *)
Definition N_of (t : list (list Q)) : list Q := nth 0 t [].
Definition edge_tree (b : cbox) (s : Q) : multi (list Q) :=
  mmap (fun t => add_multiple (N_of t) s (nth 1 t [])) (geometry_tree b).

(* P' h + P^u' l - k' N.d *)
Definition pull_tree (b : cbox) (end_ : Q * Q * Q) : multi (list Q) :=
  let '(p, u, k) := end_ in
  mmap (fun t => p :: u :: map (Qmult (- k)) (N_of t)) (geometry_tree b).

(* All by one factor. *)
Definition scaling_of_trees (trees : list (multi (list Q))) : scaling :=
  scaling_of (concat (concat (map tips trees))).

Definition integer_tree (s : scaling) (t : multi (list Q)) : multi form :=
  mmap (map (to_integer s)) t.

Definition same_forms (fs : list form) : bool :=
  match fs with
  | [] => true
  | f :: fs' => forallb (fun g => all_zero (combine 1 f (-1) g)) fs'
  end.

Definition negative (f : form) : form := map Z.opp f.

(* FORMAT.md section 6.  Functions that differ by a positive factor are not the same, but v without preloads. *)
Definition same_at_corners (t : multi (list Q)) : bool := same_forms (tips (integer_tree (scaling_of_trees [t]) t)).

Definition vanishes (i : interval) : bool := Qeq_bool (low i) 0 && Qeq_bool (high i) 0.

Definition pull_certain (b : cbox) : bool :=
  same_at_corners (mmap N_of (geometry_tree b)) &&
  ((certain (box_preload b) && certain (box_growth b) && certain (box_stiffness b)) ||
   (vanishes (box_preload b) && vanishes (box_growth b))).

Definition count (box : list interval) : nat :=
  List.length (filter (fun i => negb (certain i)) box).

(* A form of d, as one of (h, l, d). *)
Definition of_motion (f : form) : form := 0%Z :: 0%Z :: f.

Definition minus_ends (i : interval) : list Q := map Qopp (ends i).

(* From -mu to mu, for the largest mu. *)
Definition full_range (i : interval) : list Q :=
  if Qeq_bool (high i) 0 then [0%Q] else [(- high i)%Q; high i].

Definition preload_ends (b : cbox) : list (Q * Q) :=
  let p := box_preload b in
  let u := box_growth b in
  if certain p && certain u then [(low p, low u)] else [(low p, low u); (high p, high u)].

Definition pull_ends (b : cbox) : list (Q * Q * Q) :=
  flat_map (fun pu => map (fun k => (pu, k)) (ends (box_stiffness b))) (preload_ends b).

Definition forms_scaling (b : cbox) : scaling := scaling_of (concat (concat (tips (geometry_tree b)))).
Definition tau_tree (b : cbox) : multi (list Q) := mmap (fun t => nth 1 t []) (geometry_tree b).
Definition pull_scaling (b : cbox) : scaling := scaling_of_trees (map (pull_tree b) (pull_ends b)).
Definition edge_scaling (b : cbox) : scaling :=
  scaling_of_trees (map (edge_tree b)
    (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b))).

(* N and the slip's forms at the corners, in integers. *)
Definition corner_forms (b : cbox) : multi (list form) :=
  let s := forms_scaling b in mmap (map (map (to_integer s))) (geometry_tree b).

Definition make_row (b : cbox) : row :=
  let none := Scaling 1 1 in
  let fs := if box_signed b then none else forms_scaling b in
  let tau := if box_signed b then mmap of_motion (integer_tree (scaling_of_trees [tau_tree b]) (tau_tree b))
             else Tip [] in
  let es := if box_signed b then edge_scaling b else none in
  let edges ss := if box_signed b then map (fun s => integer_tree es (edge_tree b s)) ss else [] in
  let ms := scaling_of (box_weights b) in
  let ps := pull_scaling b in
  let pulls := map (fun e => integer_tree ps (pull_tree b e)) (pull_ends b) in
  let vs := map primitive (concat (map tips pulls)) in
  let n := count (box_geometry b) in
  let numerator := if box_signed b then (times es * times ps)%Z else 1%Z in
  let denominator := if box_signed b then (over es * over ps * power n)%Z else 1%Z in
  let g := content [numerator; denominator] in
  Row b (if box_signed b then Tip [] else corner_forms b) fs
    (map (to_integer ms) (box_weights b)) ms
    (if box_signed b then same_at_corners (tau_tree b) else Nat.eqb n 0)
    tau (mmap negative tau)
    (edges (minus_ends (box_friction b))) (edges (ends (box_friction b))) (edges (full_range (box_friction b)))
    pulls ps
    (match vs with f :: _ => if same_forms vs && pull_certain b then Some f else None | [] => None end)
    (box_slack b (box_geometry b)) n (numerator / g) (denominator / g).

Section RowMeaning.
Open Scope R_scope.

Lemma integer_tree_exact trees t x ss : In t trees ->
  eval (fun a => qdot a x) t ss
  = unit (scaling_of_trees trees) * eval (fun f => rdot f x) (integer_tree (scaling_of_trees trees) t) ss.
Proof.
  intros H. unfold integer_tree. rewrite eval_mmap, <- eval_multiple. apply eval_same.
  intros a Ha. apply qdot_to_integers. intros q Hq. apply in_concat. exists a. split; [|exact Hq].
  apply in_concat. exists (tips t). split; [now apply in_map | exact Ha].
Qed.

Lemma trees_unit_positive trees : 0 < unit (scaling_of_trees trees).
Proof. apply unit_positive. Qed.

Lemma qdot_is a x : qdot a x = Rows.dot (map Q2R a) x.
Proof. revert x. induction a as [|q a IH]; intros [|y x]; cbn; try reflexivity. now rewrite IH. Qed.

Lemma qdot_add_multiple a s b x : qdot (add_multiple a s b) x = qdot a x + Q2R s * qdot b x.
Proof.
  assert (S : forall b x, qdot (map (Qmult s) b) x = Q2R s * qdot b x).
  { induction b0 as [|y b0 IH]; intros [|z x0]; cbn; try ring. rewrite IH, Q2R_mult. ring. }
  revert b x. induction a as [|y a IH]; intros [|z b] [|w x]; cbn [add_multiple map qdot]; try ring.
  - rewrite S, Q2R_mult. ring.
  - rewrite IH, Q2R_plus, Q2R_mult. ring.
Qed.

Lemma qdot_scaled s b x : qdot (map (Qmult s) b) x = Q2R s * qdot b x.
Proof. revert x. induction b as [|y b IH]; intros [|z x]; cbn; try ring. rewrite IH, Q2R_mult. ring. Qed.

Lemma shares_count is p : Forall2 within is p -> List.length (box_shares is p) = count is.
Proof.
  unfold count. induction 1 as [|i x is p W F IH]; cbn; [reflexivity|].
  rewrite app_length, IH. unfold share. now destruct (certain i).
Qed.

Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.

Definition shares_in : list R := box_shares (box_geometry b) p.

Lemma shares_valid : Forall is_share shares_in.
Proof. apply shares_good. apply I. Qed.

Lemma shares_length : List.length shares_in = parameters (make_row b).
Proof. unfold shares_in. apply shares_count. apply I. Qed.

(* N, S_1, S_2, ... on d, by their values at the corners. *)
Lemma rational_corners j d :
  Rows.dot (nth j (Rows.N r :: Rows.slips r) []) d =
  eval (fun t => qdot (nth j t []) d) (geometry_tree b) shares_in.
Proof.
  rewrite (is_forms _ _ _ _ _ _ I). symmetry.
  apply (eval_corners _ _ _ (fun p => Rows.dot (nth j (F p) []) d)); [apply I|apply I|].
  intros qs. rewrite (forms_rational _ _ _ _ _ _ I), qdot_is. f_equal.
  change [] with (map Q2R []) at 2. now rewrite map_nth.
Qed.

Lemma forms_corners j d :
  Rows.dot (nth j (Rows.N r :: Rows.slips r) []) d =
  unit (forms_scaling b) * eval (fun t => rdot (nth j t []) d) (corner_forms b) shares_in.
Proof.
  unfold corner_forms. rewrite rational_corners, eval_mmap, <- eval_multiple. apply eval_same.
  intros a Ha. pose proof (map_nth (map (to_integer (forms_scaling b))) a [] j) as E.
  cbn [map] in E. rewrite E. unfold forms_scaling. apply qdot_to_integers. intros q Hq.
  apply in_concat. exists (nth j a []). split; [|exact Hq].
  apply in_concat. exists a. split; [exact Ha|].
  destruct (nth_in_or_default j a []) as [?|E0]; [assumption|]. rewrite E0 in Hq. destruct Hq.
Qed.

(* Of slips with a sign. *)
Definition T : list R := nth 0 (Rows.slips r) [].

Lemma rdot_of_motion f h l d : rdot (of_motion f) (h :: l :: d) = rdot f d.
Proof. unfold of_motion. cbn. ring. Qed.

Lemma tau_corners h l d : box_signed b = true ->
  Rows.dot T d =
  unit (scaling_of_trees [tau_tree b]) * eval (fun f => rdot f (h :: l :: d)) (tau (make_row b)) shares_in.
Proof.
  intros Sg. cbn [tau make_row]. rewrite Sg, eval_mmap.
  rewrite (eval_same _ (fun f => rdot f d)) by (intros; apply rdot_of_motion).
  rewrite <- integer_tree_exact by now left.
  unfold tau_tree. rewrite eval_mmap. exact (rational_corners 1 d).
Qed.

Notation s_list := (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)).

Lemma edge_corners s y : In s s_list ->
  Rows.dot (Rows.N r) y + Q2R s * Rows.dot T y =
  unit (edge_scaling b) *
  eval (fun f => rdot f y) (integer_tree (edge_scaling b) (edge_tree b s)) shares_in.
Proof.
  intros H. unfold edge_scaling. rewrite <- integer_tree_exact by now apply in_map.
  unfold edge_tree. rewrite eval_mmap.
  rewrite (eval_same _ (fun t => qdot (nth 0 t []) y + Q2R s * qdot (nth 1 t []) y))
    by (intros; apply qdot_add_multiple).
  rewrite eval_sum, eval_multiple. f_equal; [exact (rational_corners 0 y)|].
  f_equal. exact (rational_corners 1 y).
Qed.

Lemma pull_corners q u k h l d : In (q, u, k) (pull_ends b) ->
  Q2R q * h + Q2R u * l - Q2R k * Rows.dot (Rows.N r) d =
  unit (pull_scaling b) *
  eval (fun f => rdot f (h :: l :: d)) (integer_tree (pull_scaling b) (pull_tree b (q, u, k))) shares_in.
Proof.
  intros H. unfold pull_scaling. rewrite <- integer_tree_exact by now apply in_map.
  unfold pull_tree. rewrite eval_mmap.
  rewrite (eval_same _ (fun t => (Q2R q * h + Q2R u * l) + - Q2R k * qdot (nth 0 t []) d)).
  - rewrite eval_sum, eval_constant, eval_multiple.
    change (Rows.N r) with (nth 0 (Rows.N r :: Rows.slips r) []). rewrite rational_corners. ring.
  - intros a _. cbn [qdot]. rewrite qdot_scaled, Q2R_opp. unfold N_of. ring.
Qed.

(* v, at any point of the box, is linear in P' with its growth, and in k'. *)
Lemma v_at_ends d h l factor U :
  (forall q u k, In (q, u, k) (pull_ends b) ->
     factor * (Q2R q * h + Q2R u * l - Q2R k * Rows.dot (Rows.N r) d) <= U) ->
  factor * Rows.v r d h l <= U.
Proof.
  intros H. unfold Rows.v. set (nd := Rows.dot (Rows.N r) d) in *.
  assert (K : forall q u, In (q, u) (preload_ends b) ->
    factor * (Q2R q * h + Q2R u * l - Rows.stiffness r * nd) <= U).
  { intros q u Hq.
    replace (factor * (Q2R q * h + Q2R u * l - Rows.stiffness r * nd))
      with (factor * (Q2R q * h + Q2R u * l) + - factor * nd * Rows.stiffness r) by ring.
    apply at_ends with (box_stiffness b); [apply I|]. intros k Hk.
    replace (factor * (Q2R q * h + Q2R u * l) + - factor * nd * Q2R k)
      with (factor * (Q2R q * h + Q2R u * l - Q2R k * nd)) by ring.
    apply H. unfold pull_ends. apply in_flat_map. exists (q, u). split; [exact Hq|]. apply in_map_iff. now exists k. }
  rewrite (in_preload _ _ _ _ _ _ I), (in_growth _ _ _ _ _ _ I).
  destruct (in_step _ _ _ _ _ _ I) as [T0 T1]. unfold preload_ends in K.
  destruct (certain (box_preload b) && certain (box_growth b)) eqn:C.
  - apply andb_true_iff in C as [C1 C2]. unfold certain in C1, C2.
    apply Qeq_bool_eq, Qeq_eqR in C1, C2. rewrite <- C1, <- C2.
    specialize (K _ _ (or_introl eq_refl)).
    match goal with |- ?L <= _ => match type of K with ?M <= _ => replace L with M by ring end end. exact K.
  - pose proof (K _ _ (or_introl eq_refl)) as A. pose proof (K _ _ (or_intror (or_introl eq_refl))) as B.
    set (q0 := Q2R (low (box_preload b))) in *. set (q1 := Q2R (high (box_preload b))) in *.
    set (u0 := Q2R (low (box_growth b))) in *. set (u1 := Q2R (high (box_growth b))) in *.
    set (k := Rows.stiffness r) in *.
    match goal with |- ?L <= _ =>
      replace L with ((1 - t) * (factor * (q0 * h + u0 * l - k * nd)) + t * (factor * (q1 * h + u1 * l - k * nd)))
        by ring end.
    assert ((1 - t) * (factor * (q0 * h + u0 * l - k * nd)) <= (1 - t) * U) by (apply Rmult_le_compat_l; lra).
    assert (t * (factor * (q1 * h + u1 * l - k * nd)) <= t * U) by (apply Rmult_le_compat_l; lra).
    lra.
Qed.

Lemma row_weight : box_signed b = true -> (0 < over_weight (make_row b))%Z /\
  IZR (weight (make_row b)) / IZR (over_weight (make_row b)) =
  unit (edge_scaling b) * unit (pull_scaling b) / IZR (power (parameters (make_row b))).
Proof.
  intros Sg. cbn -[edge_scaling pull_scaling content power count]. rewrite Sg.
  set (n := count (box_geometry b)). set (es := edge_scaling b). set (ps := pull_scaling b).
  set (num := (times es * times ps)%Z). set (den := (over es * over ps * power n)%Z).
  pose proof (content_positive [num; den]) as G.
  assert (EN : num = (content [num; den] * (num / content [num; den]))%Z)
    by (apply content_divides; cbn; auto).
  assert (ED : den = (content [num; den] * (den / content [num; den]))%Z)
    by (apply content_divides; cbn; auto).
  set (g := content [num; den]) in *. set (nn := (num / g)%Z) in *. set (dd := (den / g)%Z) in *.
  clearbody g nn dd.
  assert (OE : 0 < IZR (over es)) by apply over_positive.
  assert (OP : 0 < IZR (over ps)) by apply over_positive.
  pose proof (power_positive n) as PN.
  assert (DP : 0 < IZR den).
  { unfold den. rewrite !mult_IZR. repeat apply Rmult_lt_0_compat; assumption. }
  assert (DD : (0 < dd)%Z).
  { apply lt_IZR in DP. apply Z.mul_pos_cancel_l with (n := g); [exact G|]. now rewrite <- ED. }
  split; [exact DD|].
  unfold unit. apply IZR_lt in G, DD.
  assert (A : IZR num = IZR g * IZR nn) by now rewrite <- mult_IZR, <- EN.
  assert (B : IZR den = IZR g * IZR dd) by now rewrite <- mult_IZR, <- ED.
  replace (IZR nn / IZR dd) with (IZR num / IZR den) by (rewrite A, B; field; lra).
  unfold num, den. rewrite !mult_IZR. field. repeat split; lra.
Qed.

End RowMeaning.
