(* SPDX-License-Identifier: MIT *)
(* The enlarged box of a contact's parameters (FORMAT.md section 6), which for a question without
   uncertainty is one point; and its row: in integers, everything that trees need to know of
   it.  `enlarge_inside`: every choice of the question is a point of the box.  `tau_corners`,
   `edge_corners` and `pull_corners`: what the integers of a row mean. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers.
From Proved Require Model.
Import ListNotations.

(* ---- The box of a contact ---- *)

Record cbox := CBox {
  box_x : interval; box_y : interval;     (* p *)
  box_turn : interval;                    (* e *)
  box_friction : interval;
  box_preload : interval;                 (* P' *)
  box_stiffness : interval;               (* k' *)
  box_nx : Q; box_ny : Q;                 (* n0 *)
  box_growth : Q                          (* P^u' *)
}.

(* 1/L of a normal with L^2 = `square`: exactly, or between two neighbours of so many bits. *)
Section Enclosure.
Open Scope Z_scope.

Definition is_square (z : Z) : bool := let r := Z.sqrt z in r * r =? z.

Definition reduced (q : Q) : Q :=
  let g := Z.gcd (Qnum q) (Zpos (Qden q)) in
  Qmake (Qnum q / g) (Z.to_pos (Zpos (Qden q) / g)).

(* j/2^s <= sqrt q < (j+1)/2^s with 2^(bits-1) <= j < 2^bits; q > 0 in lowest terms. *)
Definition root_between (bits : Z) (q : Q) : interval :=
  let n := Qnum q in
  let d := Zpos (Qden q) in
  if is_square n && is_square d then
    exactly (Qmake (Z.sqrt n) (Z.to_pos (Z.sqrt d)))
  else
    let root (s : Z) :=       (* floor (2^s sqrt q) *)
      if 0 <=? s then Z.sqrt (Z.shiftl n (2 * s) / d) else Z.sqrt (n / Z.shiftl d (-2 * s)) in
    (* 2^(log2 q / 2) is sqrt q up to a factor of 2. *)
    let s := bits - (Z.log2 n - Z.log2 d) / 2 in
    let s := if root s <? Z.shiftl 1 bits then s else s - 1 in
    let s := if root s <? Z.shiftl 1 bits then s else s - 1 in
    let j := root s in
    let over (j : Z) :=
      if 0 <=? s then reduced (Qmake j (Z.to_pos (Z.shiftl 1 s)))
      else Qmake (Z.shiftl j (- s)) 1 in
    Interval (over j) (over (j + 1)).

(* Checked rather than proved. *)
Definition is_enclosure (i : interval) (square : Q) : bool :=
  Qle_bool 0 (low i) && Qle_bool (low i * low i * square) 1 &&
  Qle_bool 0 (high i) && Qle_bool 1 (high i * high i * square).

End Enclosure.

Definition inverse_length (bits : Z) (loaded : bool) (square : Q) : option interval :=
  let i := if loaded then root_between bits (reduced (/ square)%Q) else exactly 1 in
  if negb loaded || is_enclosure i square then Some i else None.

Definition is_loaded (q : contact) : bool :=
  negb (Qeq_bool (high (preload q)) 0) || negb (Qeq_bool (preload_growth q) 0).

(* None if there is nothing here that this checker can judge. *)
Definition enlarge (bits : Z) (q : contact) : option cbox :=
  match position q, normal q with
  | [x; y], [nx; ny] =>
      let square := (nx * nx + ny * ny)%Q in
      let e2 := (slope q * slope q)%Q in
      match inverse_length bits (is_loaded q) square with
      | Some l =>
          if negb (Qle_bool square 0) &&
             Qle_bool 0%Q (low (friction q)) && Qle_bool 0 (low (preload q)) &&
             Qle_bool 0 (low (stiffness q)) &&
             Qle_bool 0 (slope q) && Qle_bool (slope q) 1 &&
             (Qeq_bool (preload_growth q) 0 || (certain l && Qeq_bool (slope q) 0))
          then Some (CBox x y (Interval (- slope q)%Q (slope q)) (friction q)
                       (Interval (low (preload q) * (1 - e2 / (2#1)) * low l)%Q
                                 (high (preload q) * high l)%Q)
                       (Interval (low (stiffness q) * (1 - e2) / square)%Q
                                 (high (stiffness q) / square)%Q)
                       nx ny
                       (if Qeq_bool (preload_growth q) 0 then 0%Q else (preload_growth q * low l)%Q))
          else None
      | None => None
      end
  | _, _ => None
  end.

Lemma reduced_same q : (Q2R (reduced q) = Q2R q)%R.
Proof.
  destruct q as [n d]. unfold reduced; cbn [Qnum Qden].
  set (g := Z.gcd n (Zpos d)).
  assert (G : (0 < g)%Z).
  { assert (g <> 0)%Z by (unfold g; rewrite Z.gcd_eq_0; lia).
    pose proof (Z.gcd_nonneg n (Zpos d)). fold g in H0. lia. }
  assert (En : (n = g * (n / g))%Z).
  { apply Z_div_exact_full_2; [lia|]. apply Z.mod_divide; [lia|]. apply Z.gcd_divide_l. }
  assert (Ed : (Zpos d = g * (Zpos d / g))%Z).
  { apply Z_div_exact_full_2; [lia|]. apply Z.mod_divide; [lia|]. apply Z.gcd_divide_r. }
  assert (P : (0 < Zpos d / g)%Z) by (apply Z.mul_pos_cancel_l with (n := g); lia).
  unfold Q2R; cbn [Qnum Qden]. rewrite Z2Pos.id by exact P.
  rewrite En at 2. rewrite Ed at 2. rewrite !mult_IZR.
  apply IZR_lt in G, P. field. lra.
Qed.

(* So that the kernel does not compute roots. *)
Local Opaque root_between reduced.

Section Inside.
Open Scope R_scope.

(* A contact whose parameters are a point of the box; e is the turn of its normal. *)
Record inside (b : cbox) (e : R) (c : Model.contact) : Prop := Inside {
  in_x : within (box_x b) (Model.px c);
  in_y : within (box_y b) (Model.py c);
  in_turn : within (box_turn b) e;
  in_friction : within (box_friction b) (Model.friction c);
  in_preload : within (box_preload b) (Model.preload c / Model.length c);
  in_stiffness :
    within (box_stiffness b) (Model.stiffness c / (Model.length c * Model.length c));
  is_nx : Model.nx c = Q2R (box_nx b) - e * Q2R (box_ny b);
  is_ny : Model.ny c = Q2R (box_ny b) + e * Q2R (box_nx b);
  is_growth : Model.growth c / Model.length c = Q2R (box_growth b);
  friction_nonneg : 0 <= Model.friction c
}.

Lemma Qle_bool_R p q : Qle_bool p q = true -> Q2R p <= Q2R q.
Proof. intros H. apply Qle_Rle. now apply Qle_bool_iff. Qed.

Lemma Q2R_half q : Q2R (q / (2#1))%Q = Q2R q / 2.
Proof. rewrite Q2R_div by discriminate. unfold Q2R at 2. cbn. field. Qed.

Lemma Q2R_1 : Q2R 1 = 1.
Proof. unfold Q2R; cbn. field. Qed.

Lemma Q2R_0 : Q2R 0 = 0.
Proof. unfold Q2R; cbn. field. Qed.

(* With n = n0 + e t0 the length is |n0| sqrt (1 + e^2). *)
Lemma turned_length c nx ny e : Model.nx c = nx - e * ny -> Model.ny c = ny + e * nx ->
  Model.length c = sqrt (nx * nx + ny * ny) * sqrt (1 + e * e).
Proof.
  intros Hx Hy. unfold Model.length. rewrite Hx, Hy, <- sqrt_mult by nra. f_equal. ring.
Qed.

Lemma root_bounds_1 e : 0 < sqrt (1 + e * e) /\ sqrt (1 + e * e) * sqrt (1 + e * e) = 1 + e * e.
Proof. split; [apply sqrt_lt_R0; nra | apply sqrt_sqrt; nra]. Qed.

Lemma enclosure_R i square l : is_enclosure i square = true -> 0 < l -> l * l = Q2R square ->
  0 <= Q2R (low i) /\ Q2R (low i) * l <= 1 /\ 1 <= Q2R (high i) * l.
Proof.
  unfold is_enclosure. rewrite !andb_true_iff. intros [[[H0 H1] H2] H3] L S.
  apply Qle_bool_R in H0, H1, H2, H3. rewrite !Q2R_mult, Q2R_1 in *. rewrite Q2R_0 in *.
  rewrite <- S in *. split; [lra|].
  assert (0 <= Q2R (low i) * l) by (apply Rmult_le_pos; lra).
  assert (0 <= Q2R (high i) * l) by (apply Rmult_le_pos; lra).
  split; nra.
Qed.

Theorem enlarge_inside bits q b c :
  enlarge bits q = Some b -> chosen_contact q c -> exists e, inside b e c.
Proof.
  unfold enlarge. intros H ((x & y & nx & ny & e & EP & Wx & Wy & EN & We & Hx & Hy)
                            & Wf & Wk & Wp & G).
  rewrite EP, EN in H. set (square := (nx * nx + ny * ny)%Q) in *.
  destruct (inverse_length bits (is_loaded q) square) as [l|] eqn:IL; [|discriminate].
  destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <-.
  rewrite !andb_true_iff, negb_true_iff in C.
  destruct C as [[[[[[Sq F0] P0] K0] E0] E1] GC].
  apply Qle_bool_R in F0, P0, K0, E0, E1. rewrite ?Q2R_0, ?Q2R_1 in *.
  assert (SqP : 0 < Q2R square).
  { apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle in L.
    apply Qle_bool_iff in L. congruence. }
  assert (SqE : Q2R square = Q2R nx * Q2R nx + Q2R ny * Q2R ny)
    by (unfold square; now rewrite Q2R_plus, !Q2R_mult).
  set (l0 := sqrt (Q2R square)). set (s := sqrt (1 + e * e)).
  assert (L0 : 0 < l0) by (apply sqrt_lt_R0; exact SqP).
  assert (L0E : l0 * l0 = Q2R square) by (apply sqrt_sqrt; lra).
  destruct (root_bounds_1 e) as [S0 SE]. fold s in S0, SE.
  assert (LE : Model.length c = l0 * s)
    by (rewrite (turned_length c _ _ e Hx Hy), <- SqE; reflexivity).
  assert (e2 : e * e <= Q2R (slope q) * Q2R (slope q)) by nra.
  assert (s1 : 1 <= s) by nra.
  (* 1 - e^2/2 <= 1/s <= 1 *)
  assert (s2 : (1 - Q2R (slope q) * Q2R (slope q) / 2) * s <= 1).
  { assert ((1 - e * e / 2) * s <= 1); [|nra].
    assert (s <= 1 + e * e / 2) by nra. assert (0 <= e * e <= 1) by nra. nra. }
  unfold within in *.
  (* P' *)
  assert (PP : (Q2R (low (preload q)) * (1 - Q2R (slope q) * Q2R (slope q) / 2) * Q2R (low l)
                <= Model.preload c / Model.length c <= Q2R (high (preload q)) * Q2R (high l))).
  { rewrite LE. unfold inverse_length in IL. destruct (is_loaded q) eqn:Ld.
    - cbn in IL. destruct (is_enclosure _ square) eqn:En in IL; [|discriminate].
      injection IL as IL. rewrite IL in En.
      destruct (enclosure_R l square l0 En L0 L0E) as (A & B & D).
      assert (X : Model.preload c = Model.preload c / (l0 * s) * (l0 * s)) by (field; lra).
      set (p := Model.preload c / (l0 * s)) in *.
      assert (Pos : 0 < l0 * s) by nra.
      assert (P1 : 0 <= Model.preload c) by lra.
      assert (0 <= p) by (apply Rnot_lt_le; intros ?; nra).
      split.
      + apply Rmult_le_reg_r with (l0 * s); [exact Pos|]. rewrite <- X.
        apply Rle_trans with (Q2R (low (preload q))); [|lra].
        set (t := 1 - Q2R (slope q) * Q2R (slope q) / 2) in *.
        replace (Q2R (low (preload q)) * t * Q2R (low l) * (l0 * s))
          with (Q2R (low (preload q)) * ((Q2R (low l) * l0) * (t * s))) by ring.
        assert (0 <= Q2R (low l) * l0) by (apply Rmult_le_pos; lra).
        assert (t0 : 0 <= t) by (unfold t; nra).
        assert (0 <= t * s) by (apply Rmult_le_pos; lra).
        assert ((Q2R (low l) * l0) * (t * s) <= 1) by nra. nra.
      + apply Rmult_le_reg_r with (l0 * s); [exact Pos|]. rewrite <- X.
        assert (1 <= Q2R (high l) * (l0 * s)) by nra. nra.
    - cbn in IL. injection IL as <-. unfold is_loaded in Ld.
      apply orb_false_iff in Ld as [Ld _]. apply negb_false_iff, Qeq_bool_eq, Qeq_eqR in Ld.
      rewrite Q2R_0 in Ld. assert (Z : Model.preload c = 0) by lra.
      assert (Z' : Q2R (low (preload q)) = 0) by lra. rewrite Z, Z', Ld. unfold Rdiv. lra. }
  exists e. constructor; cbn; try assumption; unfold within; cbn.
  - rewrite Q2R_opp. exact We.
  - rewrite !Q2R_mult, Q2R_minus, Q2R_1, Q2R_half, Q2R_mult. exact PP.
  - rewrite !Q2R_div, Q2R_mult, Q2R_minus, Q2R_1, Q2R_mult
      by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; lra).
    rewrite LE. replace (l0 * s * (l0 * s)) with (Q2R square * (1 + e * e))
      by (rewrite <- L0E, <- SE; ring).
    set (k := Model.stiffness c) in *. set (E2 := Q2R (slope q) * Q2R (slope q)) in *.
    assert (D : 0 < 1 + e * e) by nra. assert (K : 0 <= k) by lra. split.
    + apply Rmult_le_reg_r with (Q2R square * (1 + e * e)); [nra|]. field_simplify; [|lra|lra].
      replace (- Q2R (low (stiffness q)) * E2 * e ^ 2 - Q2R (low (stiffness q)) * E2 +
               Q2R (low (stiffness q)) * e ^ 2 + Q2R (low (stiffness q)))
        with (Q2R (low (stiffness q)) * ((1 - E2) * (1 + e * e))) by ring.
      assert ((1 - E2) * (1 + e * e) <= 1) by nra. nra.
    + apply Rmult_le_reg_r with (Q2R square * (1 + e * e)); [nra|]. field_simplify; [|lra|lra].
      nra.
  - rewrite G. destruct (Qeq_bool (preload_growth q) 0) eqn:Z.
    + apply Qeq_bool_eq, Qeq_eqR in Z. rewrite Q2R_0 in *. rewrite Z. unfold Rdiv. ring.
    + cbn in GC. apply andb_true_iff in GC as [GC GE].
      apply Qeq_bool_eq, Qeq_eqR in GC, GE. rewrite Q2R_0 in GE.
      unfold inverse_length in IL.
      assert (Ld : is_loaded q = true) by (unfold is_loaded; rewrite Z; apply orb_true_r).
      rewrite Ld in IL. cbn in IL. destruct (is_enclosure _ square) eqn:En in IL; [|discriminate].
      injection IL as IL. rewrite IL in En.
      destruct (enclosure_R l square l0 En L0 L0E) as (A & B & D).
      rewrite <- GC in D. rewrite Q2R_mult, LE.
      assert (e0 : e = 0) by lra. assert (s = 1) by (unfold s; rewrite e0;
        replace (1 + 0 * 0) with 1 by ring; apply sqrt_1).
      assert (I : Q2R (low l) = / l0) by (apply Rmult_eq_reg_r with l0; [|lra]; field_simplify; lra).
      rewrite I, H. field. lra.
  - lra.
Qed.

End Inside.

(* ---- The row of a contact ---- *)

(* Forms are of points (d, h, l); shorter ones do not see the last coordinates. *)
Record row := Row {
  box : cbox;
  tau : multi form;                 (* T.d at the corners of (x, y, turn), times a factor *)
  minus_tau : multi form;
  tau_certain : bool;
  (* N + s T, times a factor, for the s between which friction may be, by the sign of slip *)
  edges_plus : list (multi form);
  edges_minus : list (multi form);
  edges_none : list (multi form);
  (* v, times a factor, for the ends of P' and k' *)
  pulls : list (multi form);
  separates : option form;          (* v up to a positive factor, if it is certain *)
  parameters : nat;                 (* of x, y and turn, that are uncertain *)
  weight : Z; over_weight : Z;      (* edge times pull times 2^parameters times this quotient is
                                       exact *)
  pull_scale : scaling              (* that of pulls *)
}.

Definition corners {A} (b : cbox) (f : Q -> Q -> Q -> A) : multi A :=
  spread (box_x b) (fun x => spread (box_y b) (fun y => spread (box_turn b) (fun e =>
    Tip (f x y e)))).

(* N and T in rationals, at a corner. *)
Definition at_point (x y fx fy : Q) : list Q := [fx; fy; (x * fy - y * fx)%Q].
Definition turned_x (b : cbox) (e : Q) : Q := (box_nx b - e * box_ny b)%Q.
Definition turned_y (b : cbox) (e : Q) : Q := (box_ny b + e * box_nx b)%Q.

Definition T_at (b : cbox) (x y e : Q) : list Q :=
  at_point x y (- turned_y b e)%Q (turned_x b e).

(* N + s T *)
Definition edge_at (b : cbox) (s x y e : Q) : list Q :=
  at_point x y (turned_x b e - s * turned_y b e)%Q (turned_y b e + s * turned_x b e)%Q.

(* P' h + P^u' l - k' N.d *)
Definition pull_at (b : cbox) (p k x y e : Q) : list Q :=
  at_point x y (- k * turned_x b e)%Q (- k * turned_y b e)%Q ++ [p; box_growth b].

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

Definition count (i : interval) : nat := if certain i then 0 else 1.

Definition minus_ends (i : interval) : list Q := map Qopp (ends i).

(* From -mu to mu, for the largest mu. *)
Definition full_range (i : interval) : list Q :=
  if Qeq_bool (high i) 0 then [0%Q] else [(- high i)%Q; high i].

Definition pull_ends (b : cbox) : list (Q * Q) :=
  flat_map (fun p => map (fun k => (p, k)) (ends (box_stiffness b))) (ends (box_preload b)).

Definition make_row (b : cbox) : row :=
  let t := corners b (T_at b) in
  let ts := scaling_of_trees [t] in
  let tau := integer_tree ts t in
  let edge s := corners b (edge_at b s) in
  let plus := map edge (minus_ends (box_friction b)) in
  let minus := map edge (ends (box_friction b)) in
  let none := map edge (full_range (box_friction b)) in
  let es := scaling_of_trees (plus ++ minus ++ none) in
  let pull pk := corners b (pull_at b (fst pk) (snd pk)) in
  let all := map pull (pull_ends b) in
  let ps := scaling_of_trees all in
  let pulls := map (integer_tree ps) all in
  let vs := map primitive (concat (map tips pulls)) in
  let n := (count (box_x b) + (count (box_y b) + count (box_turn b)))%nat in
  let numerator := (times es * times ps)%Z in
  let denominator := (over es * over ps * power n)%Z in
  let g := content [numerator; denominator] in
  Row b tau (mmap negative tau) (same_forms (map primitive (tips tau)))
    (map (integer_tree es) plus) (map (integer_tree es) minus) (map (integer_tree es) none)
    pulls (match vs with f :: _ => if same_forms vs then Some f else None | [] => None end)
    n (numerator / g) (denominator / g) ps.

Section RowMeaning.
Open Scope R_scope.

Lemma eval_corners {A} b c e (f : Q -> Q -> Q -> A) g (G : R -> R -> R -> R) :
  inside b e c ->
  (forall y e, affine (fun x => G x y e)) -> (forall x e, affine (fun y => G x y e)) ->
  (forall x y, affine (fun e => G x y e)) ->
  (forall x y e, g (f x y e) = G (Q2R x) (Q2R y) (Q2R e)) ->
  eval g (corners b f)
    (share (box_x b) (Model.px c) ++ share (box_y b) (Model.py c) ++ share (box_turn b) e)
  = G (Model.px c) (Model.py c) e.
Proof.
  intros I Ax Ay Ae E. unfold corners.
  apply (eval_spread _ _ _ (fun x => G x (Model.py c) e)); [apply I|apply Ax|]. intros x.
  apply (eval_spread _ _ _ (fun y => G (Q2R x) y e)); [apply I|apply Ay|]. intros y.
  rewrite <- (app_nil_r (share (box_turn b) e)).
  apply (eval_spread _ _ _ (fun e => G (Q2R x) (Q2R y) e)); [apply I|apply Ae|]. intros e'.
  cbn. apply E.
Qed.

Definition shares_in (b : cbox) (e : R) (c : Model.contact) : list R :=
  share (box_x b) (Model.px c) ++ share (box_y b) (Model.py c) ++ share (box_turn b) e.

Lemma shares_valid b e c : inside b e c -> Forall is_share (shares_in b e c).
Proof.
  intros I. unfold shares_in. rewrite !Forall_app.
  repeat split; apply share_in; apply I.
Qed.

Lemma share_count i x : List.length (share i x) = count i.
Proof. unfold share, count. now destruct (certain i). Qed.

Lemma shares_count b e c : List.length (shares_in b e c) = parameters (make_row b).
Proof. unfold shares_in. now rewrite !app_length, !share_count. Qed.

(* d as a list, with h and l. *)
Definition located (d : Model.vector) (h l : R) : list R :=
  [Model.along_x d; Model.along_y d; Model.about_z d; h; l].

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

Ltac rationals := rewrite ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp,
  ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp, ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp.

Ltac find_affine :=
  intros; match goal with |- affine ?F =>
    let a := eval cbv beta zeta in (F 0) in let b := eval cbv beta zeta in (F 1 - F 0) in
    exists a, b; intros; cbv beta zeta; ring end.

Variable b : cbox.
Variable e : R.
Variable c : Model.contact.
Hypothesis I : inside b e c.

Lemma tau_corners d h l :
  Model.work (Model.T c) d =
  unit (scaling_of_trees [corners b (T_at b)]) *
  eval (fun f => rdot f (located d h l)) (tau (make_row b)) (shares_in b e c).
Proof.
  cbn [tau make_row].
  rewrite <- (integer_tree_exact [corners b (T_at b)] _ (located d h l)) by now left.
  unfold shares_in.
  rewrite (eval_corners b c e (T_at b) _
    (fun x y e =>
       - (Q2R (box_ny b) + e * Q2R (box_nx b)) * Model.along_x d
       + (Q2R (box_nx b) - e * Q2R (box_ny b)) * Model.along_y d
       + (x * (Q2R (box_nx b) - e * Q2R (box_ny b))
          - y * - (Q2R (box_ny b) + e * Q2R (box_nx b))) * Model.about_z d) I);
    try find_affine.
  - unfold Model.work, Model.T, Model.force_at; cbn. rewrite (is_nx _ _ _ I), (is_ny _ _ _ I).
    ring.
  - intros. unfold T_at, at_point, turned_x, turned_y; cbn. rationals. ring.
Qed.

Definition edge_scaling :=
  scaling_of_trees (map (fun s => corners b (edge_at b s))
    (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b))).

Lemma edge_scaling_is :
  scaling_of_trees
    (map (fun s => corners b (edge_at b s)) (minus_ends (box_friction b)) ++
     map (fun s => corners b (edge_at b s)) (ends (box_friction b)) ++
     map (fun s => corners b (edge_at b s)) (full_range (box_friction b))) = edge_scaling.
Proof. unfold edge_scaling. now rewrite !map_app. Qed.

Lemma edge_corners s y :
  In s (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)) ->
  Model.work (Model.N c) y + Q2R s * Model.work (Model.T c) y =
  unit edge_scaling *
  eval (fun f => rdot f (located y 0 0)) (integer_tree edge_scaling (corners b (edge_at b s)))
    (shares_in b e c).
Proof.
  intros H. unfold edge_scaling.
  rewrite <- integer_tree_exact by (apply in_map_iff; now exists s).
  unfold shares_in.
  rewrite (eval_corners b c e (edge_at b s) _
    (fun px py e =>
       let nx := Q2R (box_nx b) - e * Q2R (box_ny b) in
       let ny := Q2R (box_ny b) + e * Q2R (box_nx b) in
       let fx := nx - Q2R s * ny in let fy := ny + Q2R s * nx in
       fx * Model.along_x y + fy * Model.along_y y + (px * fy - py * fx) * Model.about_z y) I);
    try find_affine.
  - unfold Model.work, Model.N, Model.T, Model.force_at; cbn.
    rewrite (is_nx _ _ _ I), (is_ny _ _ _ I). ring.
  - intros. unfold edge_at, at_point, turned_x, turned_y; cbn. rationals. ring.
Qed.

Definition pull_scaling :=
  scaling_of_trees (map (fun pk => corners b (pull_at b (fst pk) (snd pk))) (pull_ends b)).

Lemma pull_corners p k d h l : In (p, k) (pull_ends b) ->
  Q2R p * h + Q2R (box_growth b) * l - Q2R k * Model.work (Model.N c) d =
  unit pull_scaling *
  eval (fun f => rdot f (located d h l)) (integer_tree pull_scaling (corners b (pull_at b p k)))
    (shares_in b e c).
Proof.
  intros H. unfold pull_scaling.
  rewrite <- integer_tree_exact by (apply in_map_iff; now exists (p, k)).
  unfold shares_in.
  rewrite (eval_corners b c e (pull_at b p k) _
    (fun px py e =>
       let nx := Q2R (box_nx b) - e * Q2R (box_ny b) in
       let ny := Q2R (box_ny b) + e * Q2R (box_nx b) in
       - Q2R k * (nx * Model.along_x d + ny * Model.along_y d +
                  (px * ny - py * nx) * Model.about_z d) + Q2R p * h + Q2R (box_growth b) * l) I);
    try find_affine.
  - unfold Model.work, Model.N, Model.force_at; cbn.
    rewrite (is_nx _ _ _ I), (is_ny _ _ _ I). ring.
  - intros. unfold pull_at, at_point, turned_x, turned_y; cbn. rationals. ring.
Qed.

(* v, at any point of the box, is linear in P' and in k'. *)
Lemma v_at_ends d h l factor U :
  (forall p k, In (p, k) (pull_ends b) ->
     factor * (Q2R p * h + Q2R (box_growth b) * l - Q2R k * Model.work (Model.N c) d) <= U) ->
  factor * (Model.preload c / Model.length c * h + Model.growth c / Model.length c * l
            - Model.stiffness c / (Model.length c * Model.length c) * Model.work (Model.N c) d)
  <= U.
Proof.
  intros H. rewrite (is_growth _ _ _ I).
  set (P := Model.preload c / Model.length c).
  set (k := Model.stiffness c / (Model.length c * Model.length c)).
  set (nd := Model.work (Model.N c) d) in *.
  replace (factor * (P * h + Q2R (box_growth b) * l - k * nd))
    with (factor * (Q2R (box_growth b) * l - k * nd) + factor * h * P) by ring.
  apply at_ends with (box_preload b); [apply I|]. intros p Hp.
  replace (factor * (Q2R (box_growth b) * l - k * nd) + factor * h * Q2R p)
    with (factor * (Q2R p * h + Q2R (box_growth b) * l) + - factor * nd * k) by ring.
  apply at_ends with (box_stiffness b); [apply I|]. intros k' Hk.
  replace (factor * (Q2R p * h + Q2R (box_growth b) * l) + - factor * nd * Q2R k')
    with (factor * (Q2R p * h + Q2R (box_growth b) * l - Q2R k' * nd)) by ring.
  apply H. unfold pull_ends. apply in_flat_map. exists p. split; [exact Hp|].
  apply in_map_iff. now exists k'.
Qed.

Lemma row_weight : (0 < over_weight (make_row b))%Z /\
  IZR (weight (make_row b)) / IZR (over_weight (make_row b)) =
  unit edge_scaling * unit pull_scaling / IZR (power (parameters (make_row b))).
Proof.
  cbn -[scaling_of_trees content power count]. rewrite edge_scaling_is. fold pull_scaling.
  set (n := (count (box_x b) + (count (box_y b) + count (box_turn b)))%nat).
  set (num := (times edge_scaling * times pull_scaling)%Z).
  set (den := (over edge_scaling * over pull_scaling * power n)%Z).
  pose proof (content_positive [num; den]) as G.
  assert (EN : num = (content [num; den] * (num / content [num; den]))%Z)
    by (apply content_divides; cbn; auto).
  assert (ED : den = (content [num; den] * (den / content [num; den]))%Z)
    by (apply content_divides; cbn; auto).
  set (g := content [num; den]) in *. set (nn := (num / g)%Z) in *. set (dd := (den / g)%Z) in *.
  clearbody g nn dd.
  pose proof (over_positive (concat (concat (map tips (map (fun s => corners b (edge_at b s))
    (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)))))))
    as OE.
  pose proof (over_positive (concat (concat (map tips (map (fun pk =>
    corners b (pull_at b (fst pk) (snd pk))) (pull_ends b)))))) as OP.
  fold (scaling_of_trees (map (fun s => corners b (edge_at b s))
    (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)))) in OE.
  fold edge_scaling in OE.
  fold (scaling_of_trees (map (fun pk => corners b (pull_at b (fst pk) (snd pk))) (pull_ends b)))
    in OP.
  fold pull_scaling in OP.
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
