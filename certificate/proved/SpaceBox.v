(* SPDX-License-Identifier: MIT *)
(* The box of a contact in space, and its row in integers: Box.v for slips of three values. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box.
From Proved Require Model SpaceModel.
Import ListNotations.

Module S := SpaceModel.

(* ---- The box ---- *)

Record cbox := CBox {
  box_x : interval; box_y : interval; box_z : interval;
  box_friction : interval;
  box_preload : interval;                 (* P' *)
  box_stiffness : interval;               (* k' *)
  box_nx : Q; box_ny : Q; box_nz : Q
}.

Definition square (b : cbox) : Q :=
  (box_nx b * box_nx b + box_ny b * box_ny b + box_nz b * box_nz b)%Q.

(* Only of questions whose normals are certain and whose preloads do not grow. *)
Definition enlarge (bits : Z) (q : contact) : option cbox :=
  match position q, normal q with
  | [x; y; z], [nx; ny; nz] =>
      let sq := (nx * nx + ny * ny + nz * nz)%Q in
      match inverse_length bits (is_loaded q) sq with
      | Some l =>
          if negb (Qle_bool sq 0) &&
             Qle_bool 0%Q (low (friction q)) && Qle_bool 0 (low (preload q)) &&
             Qle_bool 0 (low (stiffness q)) && Qeq_bool (preload_growth q) 0 &&
             Qeq_bool (slope q) 0
          then Some (CBox x y z (friction q)
                       (Interval (low (preload q) * low l)%Q (high (preload q) * high l)%Q)
                       (Interval (low (stiffness q) / sq)%Q (high (stiffness q) / sq)%Q)
                       nx ny nz)
          else None
      | None => None
      end
  | _, _ => None
  end.

Lemma inverse_length_is bits loaded sq : inverse_length bits loaded sq =
  if loaded then
    let i := root_between bits (reduced (/ sq)%Q) in if is_enclosure i sq then Some i else None
  else Some (exactly 1).
Proof. now destruct loaded. Qed.

(* So that the kernel does not compute roots. *)
Local Opaque root_between reduced inverse_length.

Section Inside.
Open Scope R_scope.

Record inside (b : cbox) (c : S.contact) : Prop := Inside {
  in_x : within (box_x b) (S.x (S.position c));
  in_y : within (box_y b) (S.y (S.position c));
  in_z : within (box_z b) (S.z (S.position c));
  in_friction : within (box_friction b) (S.friction c);
  in_preload : within (box_preload b) (S.preload c / S.length c);
  in_stiffness : within (box_stiffness b) (S.stiffness c / (S.length c * S.length c));
  is_normal : S.normal c = vector_of_three (box_nx b) (box_ny b) (box_nz b);
  no_growth : S.growth c = 0;
  friction_nonneg : 0 <= S.friction c;
  square_positive : 0 < Q2R (square b);
  length_square : S.length c * S.length c = Q2R (square b);
  length_positive : 0 < S.length c
}.

Theorem enlarge_inside bits q b c :
  enlarge bits q = Some b -> chosen_contact_in_space q c -> inside b c.
Proof.
  unfold enlarge. intros H ((x & y & z & nx & ny & nz & t & EP & EN & Wx & Wy & Wz & _ & TT & NT)
                            & Wf & Wk & Wp & G).
  rewrite EP, EN in H. set (sq := (nx * nx + ny * ny + nz * nz)%Q) in *.
  destruct (inverse_length bits (is_loaded q) sq) as [l|] eqn:IL; [|discriminate].
  destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <-.
  rewrite !andb_true_iff, negb_true_iff in C. destruct C as [[[[[Sq F0] P0] K0] GC] SC].
  apply Qle_bool_R in F0, P0, K0. apply Qeq_bool_eq, Qeq_eqR in GC, SC. rewrite Q2R_0 in *.
  assert (NE : S.normal c = vector_of_three nx ny nz).
  { rewrite NT. rewrite SC, !Rmult_0_l in TT. destruct t as [tx ty tz]. unfold S.dot in TT; cbn in TT.
    pose proof (Rle_0_sqr tx) as X. pose proof (Rle_0_sqr ty) as Y. pose proof (Rle_0_sqr tz) as Z0.
    unfold Rsqr in X, Y, Z0.
    assert (EX : tx = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    assert (EY : ty = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    assert (EZ : tz = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    subst. unfold S.add, vector_of_three; cbn. now rewrite !Rplus_0_r. }
  assert (SqP : 0 < Q2R sq).
  { apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle in L.
    apply Qle_bool_iff in L. congruence. }
  assert (SqE : Q2R sq = S.dot (S.normal c) (S.normal c)).
  { rewrite NE. unfold sq, S.dot, vector_of_three; cbn. now rewrite !Q2R_plus, !Q2R_mult. }
  assert (L0 : 0 < S.length c) by (unfold S.length, S.norm; rewrite <- SqE; now apply sqrt_lt_R0).
  assert (L0E : S.length c * S.length c = Q2R sq).
  { unfold S.length, S.norm. rewrite <- SqE. apply sqrt_sqrt. lra. }
  set (len := S.length c) in *. unfold within in *.
  assert (PP : Q2R (low (preload q)) * Q2R (low l) <= S.preload c / len
               <= Q2R (high (preload q)) * Q2R (high l)).
  { assert (X : S.preload c = S.preload c / len * len) by (field; lra).
    rewrite inverse_length_is in IL. destruct (is_loaded q) eqn:Ld.
    - cbn in IL. destruct (is_enclosure _ sq) eqn:En in IL; [|discriminate].
      injection IL as IL. rewrite IL in En.
      destruct (enclosure_R l sq len En L0 L0E) as (A & B & D).
      set (p := S.preload c / len) in *. assert (0 <= p) by (apply Rnot_lt_le; intros ?; nra).
      split; apply Rmult_le_reg_r with len; try exact L0; rewrite <- X.
      + apply Rle_trans with (Q2R (low (preload q))); [|lra]. rewrite Rmult_assoc. nra.
      + rewrite Rmult_assoc. nra.
    - cbn in IL. injection IL as <-. unfold is_loaded in Ld.
      apply orb_false_iff in Ld as [Ld _]. apply negb_false_iff, Qeq_bool_eq, Qeq_eqR in Ld.
      rewrite Q2R_0 in Ld. assert (Z : S.preload c = 0) by lra.
      assert (Z' : Q2R (low (preload q)) = 0) by lra. rewrite Z, Z', Ld. unfold Rdiv. lra. }
  constructor; cbn; try assumption; unfold within; cbn; fold len; try lra.
  - rewrite !Q2R_mult. exact PP.
  - rewrite !Q2R_div by (intros Z; apply Qeq_eqR in Z; rewrite Q2R_0 in Z; fold sq in Z; lra).
    fold sq. rewrite L0E. unfold Rdiv. assert (0 <= / Q2R sq) by (left; now apply Rinv_0_lt_compat).
    split; apply Rmult_le_compat_r; lra.
Qed.

End Inside.

(* ---- The row ---- *)

Record row := Row {
  box : cbox;
  geometry : multi (list form);   (* N and the three rows of the slip, at the corners of p *)
  geometry_scale : scaling;
  slip_certain : bool;
  pulls : list (multi form);      (* v, for the ends of P' and k' *)
  pull_scale : scaling;
  separates : option form
}.

Definition corners {A} (b : cbox) (f : Q -> Q -> Q -> A) : multi A :=
  spread (box_x b) (fun x => spread (box_y b) (fun y => spread (box_z b) (fun z =>
    Tip (f x y z)))).

(* The row f.u of the force f at a point, and of the wrench. *)
Definition at_point (x y z fx fy fz : Q) : list Q :=
  [fx; fy; fz; (y * fz - z * fy)%Q; (z * fx - x * fz)%Q; (x * fy - y * fx)%Q].

(* The directions across n: e_j - n_j n / n.n. *)
Definition across (b : cbox) (nj ex ey ez : Q) : Q * Q * Q :=
  ((ex - nj * box_nx b / square b)%Q, (ey - nj * box_ny b / square b)%Q,
   (ez - nj * box_nz b / square b)%Q).

Definition at_point3 (x y z : Q) (f : Q * Q * Q) : list Q :=
  match f with (fx, fy, fz) => at_point x y z fx fy fz end.

Definition geometry_at (b : cbox) (x y z : Q) : list (list Q) :=
  [at_point x y z (box_nx b) (box_ny b) (box_nz b);
   at_point3 x y z (across b (box_nx b) 1 0 0);
   at_point3 x y z (across b (box_ny b) 0 1 0);
   at_point3 x y z (across b (box_nz b) 0 0 1)].

Definition pull_at (b : cbox) (p k x y z : Q) : list Q :=
  at_point x y z (- k * box_nx b)%Q (- k * box_ny b)%Q (- k * box_nz b)%Q ++ [p; 0%Q].

Definition pull_ends (b : cbox) : list (Q * Q) :=
  flat_map (fun p => map (fun k => (p, k)) (ends (box_stiffness b))) (ends (box_preload b)).

Definition geometry_tree (b : cbox) : multi (list (list Q)) := corners b (geometry_at b).

Definition scaling_of_geometry (b : cbox) : scaling :=
  scaling_of (concat (concat (tips (geometry_tree b)))).

Definition pull_tree (b : cbox) (pk : Q * Q) : multi (list Q) :=
  corners b (pull_at b (fst pk) (snd pk)).

Definition pull_scaling (b : cbox) : scaling :=
  scaling_of_trees (map (pull_tree b) (pull_ends b)).

Definition make_row (b : cbox) : row :=
  let gs := scaling_of_geometry b in
  let ps := pull_scaling b in
  let pulls := map (fun pk => integer_tree ps (pull_tree b pk)) (pull_ends b) in
  let vs := map primitive (concat (map tips pulls)) in
  Row b (mmap (map (map (to_integer gs))) (geometry_tree b)) gs
    (certain (box_x b) && certain (box_y b) && certain (box_z b))
    pulls ps
    (match vs with f :: _ => if same_forms vs then Some f else None | [] => None end).

Section RowMeaning.
Open Scope R_scope.

Variable b : cbox.
Variable c : S.contact.
Hypothesis I : inside b c.

Definition shares_in : list R :=
  share (box_x b) (S.x (S.position c)) ++ share (box_y b) (S.y (S.position c)) ++
  share (box_z b) (S.z (S.position c)).

Lemma shares_valid : Forall is_share shares_in.
Proof. unfold shares_in. rewrite !Forall_app. repeat split; apply share_in; apply I. Qed.

Lemma eval_corners {A} (f : Q -> Q -> Q -> A) g (G : R -> R -> R -> R) :
  (forall y z, affine (fun x => G x y z)) -> (forall x z, affine (fun y => G x y z)) ->
  (forall x y, affine (fun z => G x y z)) ->
  (forall x y z, g (f x y z) = G (Q2R x) (Q2R y) (Q2R z)) ->
  eval g (corners b f) shares_in
  = G (S.x (S.position c)) (S.y (S.position c)) (S.z (S.position c)).
Proof.
  intros Ax Ay Az E. unfold corners, shares_in.
  apply (eval_spread _ _ _ (fun x => G x (S.y (S.position c)) (S.z (S.position c))));
    [apply I|apply Ax|]. intros x.
  apply (eval_spread _ _ _ (fun y => G (Q2R x) y (S.z (S.position c)))); [apply I|apply Ay|]. intros y.
  rewrite <- (app_nil_r (share (box_z b) _)).
  apply (eval_spread _ _ _ (fun z => G (Q2R x) (Q2R y) z)); [apply I|apply Az|]. intros z.
  cbn. apply E.
Qed.

Definition located (d : S.screw) (h l : R) : list R :=
  [S.x (S.linear d); S.y (S.linear d); S.z (S.linear d);
   S.x (S.angular d); S.y (S.angular d); S.z (S.angular d); h; l].

Ltac rationals := repeat rewrite ?Q2R_plus, ?Q2R_minus, ?Q2R_mult, ?Q2R_opp.

Ltac find_affine :=
  intros; match goal with |- affine ?F =>
    let a := eval cbv beta zeta in (F 0) in let b := eval cbv beta zeta in (F 1 - F 0) in
    exists a, b; intros; cbv beta zeta; ring end.

Lemma geometry_exact j d h l :
  eval (fun t => qdot (nth j t []) (located d h l)) (geometry_tree b) shares_in =
  unit (scaling_of_geometry b) *
  eval (fun t => rdot (nth j t []) (located d h l)) (geometry (make_row b)) shares_in.
Proof.
  cbn [geometry make_row]. rewrite eval_mmap, <- eval_multiple. apply eval_same.
  intros t Ht. pose proof (map_nth (map (to_integer (scaling_of_geometry b))) t [] j) as E.
  cbn [map] in E. rewrite E.
  unfold scaling_of_geometry. apply qdot_to_integers. intros q Hq.
  apply in_concat. exists (nth j t []). split; [|exact Hq].
  apply in_concat. exists t. split; [exact Ht|].
  destruct (nth_in_or_default j t []) as [?|E0]; [assumption|]. rewrite E0 in Hq. destruct Hq.
Qed.

(* The work of a force at the contact's point. *)
Definition force_row (px py pz fx fy fz : R) (d : S.screw) : R :=
  fx * S.x (S.linear d) + fy * S.y (S.linear d) + fz * S.z (S.linear d) +
  (py * fz - pz * fy) * S.x (S.angular d) + (pz * fx - px * fz) * S.y (S.angular d) +
  (px * fy - py * fx) * S.z (S.angular d).

Lemma qdot_at_point x y z fx fy fz d h l :
  qdot (at_point x y z fx fy fz) (located d h l) =
  force_row (Q2R x) (Q2R y) (Q2R z) (Q2R fx) (Q2R fy) (Q2R fz) d.
Proof. unfold at_point, force_row; cbn. rationals. ring. Qed.

Lemma N_corners d h l : S.work (S.N c) d =
  unit (scaling_of_geometry b) *
  eval (fun t => rdot (nth 0 t []) (located d h l)) (geometry (make_row b)) shares_in.
Proof.
  rewrite <- geometry_exact.
  rewrite (eval_corners (geometry_at b) _
    (fun x y z => force_row x y z (Q2R (box_nx b)) (Q2R (box_ny b)) (Q2R (box_nz b)) d));
    try (unfold force_row; find_affine).
  - unfold S.work, S.N, S.force_at, S.cross, S.dot, force_row. rewrite (is_normal _ _ I).
    unfold vector_of_three; cbn. ring.
  - intros. cbn [geometry_at nth]. apply qdot_at_point.
Qed.

Definition component (j : nat) (a : S.vector) : R :=
  match j with 0%nat => S.x a | 1%nat => S.y a | _ => S.z a end.

Lemma slip_corners j d h l : (j < 3)%nat ->
  component j (S.slip c d) =
  unit (scaling_of_geometry b) *
  eval (fun t => rdot (nth (S j) t []) (located d h l)) (geometry (make_row b)) shares_in.
Proof.
  intros J. rewrite <- geometry_exact.
  assert (NZ : ~ (square b == 0)%Q).
  { intros Z. apply Qeq_eqR in Z. rewrite Q2R_0 in Z. pose proof (square_positive _ _ I). lra. }
  assert (SE : Q2R (square b) = S.dot (S.normal c) (S.normal c)).
  { rewrite (is_normal _ _ I). unfold square, S.dot, vector_of_three; cbn. rationals. ring. }
  assert (SP := square_positive _ _ I).
  assert (Case : forall nj ex ey ez tj,
    (forall x y z, nth tj (geometry_at b x y z) [] = at_point3 x y z (across b nj ex ey ez)) ->
    eval (fun t => qdot (nth tj t []) (located d h l)) (geometry_tree b) shares_in =
    force_row (S.x (S.position c)) (S.y (S.position c)) (S.z (S.position c))
      (Q2R ex - Q2R nj * Q2R (box_nx b) / Q2R (square b))
      (Q2R ey - Q2R nj * Q2R (box_ny b) / Q2R (square b))
      (Q2R ez - Q2R nj * Q2R (box_nz b) / Q2R (square b)) d).
  { intros nj ex ey ez tj E.
    apply (eval_corners (geometry_at b) _ (fun x y z => force_row x y z
      (Q2R ex - Q2R nj * Q2R (box_nx b) / Q2R (square b))
      (Q2R ey - Q2R nj * Q2R (box_ny b) / Q2R (square b))
      (Q2R ez - Q2R nj * Q2R (box_nz b) / Q2R (square b)) d)); try (unfold force_row; find_affine).
    intros. rewrite E. unfold at_point3, across. rewrite qdot_at_point.
    rewrite !Q2R_minus, !Q2R_div, !Q2R_mult by exact NZ. reflexivity. }
  destruct j as [|[|[|j]]]; [| | |lia].
  - rewrite (Case (box_nx b) 1%Q 0%Q 0%Q 1%nat) by reflexivity. rewrite Q2R_1, Q2R_0, SE.
    unfold S.slip, S.moved, S.add, S.scale, S.cross, force_row, component. rewrite (is_normal _ _ I) in *.
    rewrite SE in SP. unfold S.dot, vector_of_three in *; cbn in *. field. lra.
  - rewrite (Case (box_ny b) 0%Q 1%Q 0%Q 2%nat) by reflexivity. rewrite Q2R_1, Q2R_0, SE.
    unfold S.slip, S.moved, S.add, S.scale, S.cross, force_row, component. rewrite (is_normal _ _ I) in *.
    rewrite SE in SP. unfold S.dot, vector_of_three in *; cbn in *. field. lra.
  - rewrite (Case (box_nz b) 0%Q 0%Q 1%Q 3%nat) by reflexivity. rewrite Q2R_1, Q2R_0, SE.
    unfold S.slip, S.moved, S.add, S.scale, S.cross, force_row, component. rewrite (is_normal _ _ I) in *.
    rewrite SE in SP. unfold S.dot, vector_of_three in *; cbn in *. field. lra.
Qed.

Lemma pull_corners p k d h l : In (p, k) (pull_ends b) ->
  Q2R p * h - Q2R k * S.work (S.N c) d =
  unit (pull_scaling b) *
  eval (fun f => rdot f (located d h l)) (integer_tree (pull_scaling b) (pull_tree b (p, k)))
    shares_in.
Proof.
  intros H. unfold pull_scaling.
  rewrite <- integer_tree_exact by (apply in_map_iff; now exists (p, k)).
  unfold pull_tree; cbn [fst snd].
  rewrite (eval_corners (pull_at b p k) _
    (fun x y z => - Q2R k * force_row x y z (Q2R (box_nx b)) (Q2R (box_ny b)) (Q2R (box_nz b)) d
                  + Q2R p * h)); try (unfold force_row; find_affine).
  - unfold S.work, S.N, S.force_at, S.cross, S.dot, force_row. rewrite (is_normal _ _ I).
    unfold vector_of_three; cbn. ring.
  - intros. unfold pull_at, at_point, force_row; cbn. rationals. rewrite ?Q2R_0. ring.
Qed.

Lemma v_at_ends lambda d factor U :
  (forall p k, In (p, k) (pull_ends b) ->
     factor * (Q2R p - Q2R k * S.work (S.N c) d) <= U) ->
  factor * S.v c lambda d <= U.
Proof.
  intros H. unfold S.v. rewrite (no_growth _ _ I).
  set (P := S.preload c / S.length c).
  set (k := S.stiffness c / (S.length c * S.length c)).
  set (nd := S.work (S.N c) d) in *.
  replace ((S.preload c + lambda * 0) / S.length c) with P by (unfold P, Rdiv; ring).
  replace (factor * (P - k * nd)) with (- factor * k * nd + factor * P) by ring.
  apply at_ends with (box_preload b); [apply I|]. intros p Hp.
  replace (- factor * k * nd + factor * Q2R p) with (factor * Q2R p + - factor * nd * k) by ring.
  apply at_ends with (box_stiffness b); [apply I|]. intros k' Hk.
  replace (factor * Q2R p + - factor * nd * Q2R k') with (factor * (Q2R p - Q2R k' * nd)) by ring.
  apply H. unfold pull_ends. apply in_flat_map. exists p. split; [exact Hp|].
  apply in_map_iff. now exists k'.
Qed.

End RowMeaning.
