(* SPDX-License-Identifier: MIT *)
(* Rigid contacts (FORMAT.md section 13), for rows in R^D: what accelerations and forces obey, and trees that
   prove that nothing moves.  `tree_holds`: where a tree is accepted, no solution has an acceleration along which
   the load does work. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Tree RowLimits Degree Matrix
  Frame ByDegree.
From Proved Require Rows Model.
Import ListNotations.

(* ---- The law ---- *)

Section Law.
Open Scope R_scope.

(* At the acceleration a: no contact pulls or is penetrated, one that parts does not press, and friction is
  Coulomb's. *)
Definition rigid_obeys (a : list R) (r : Rows.row) (f : Rows.force) : Prop :=
  let (n, g) := f in
  (0 <= n /\ 0 <= Rows.dot (Rows.N r) a /\ n * Rows.dot (Rows.N r) a = 0) /\
  Rows.size (Rows.weights r) g <= Rows.rho r * n /\
  Rows.product (Rows.weights r) g (Rows.slip r a) = - (Rows.rho r * n) * Rows.size (Rows.weights r) (Rows.slip r a).

(* M a, by its rows, is the load and all forces together: on every virtual twist. *)
Definition rigid_solution (sys : Rows.system) (mass : list (list R)) (a : list R) (fs : list Rows.force) : Prop :=
  List.length a = Rows.dimension sys /\ Forall2 (rigid_obeys a) (Rows.rows sys) fs /\
  forall y, Rows.dot y (times mass a) = Rows.dot (Rows.wrench sys) y + Rows.works (Rows.rows sys) fs y.

End Law.

(* ---- Rules ---- *)

(* A contact: its forms, mu and L^2, and its normal. *)
Record rigid := Rigid {
  r_N : vector; r_slips : matrix; r_friction : Q; r_square : Q; r_normal : vector
}.

(* What is known of a contact: whether it touches; and that its slip is 0, or a sum of multiples >= 0 of these sides
   and not 0. *)
Record knowledge := Knowledge { touches : option bool; sides : option matrix }.

Section Rules.
Open Scope Q_scope.

Definition slip_of (x : rigid) (y : vector) : vector := map (fun f => inner f y) (r_slips x).

Definition cross (a b : vector) : vector :=
  match a, b with
  | [a1; a2; a3], [b1; b2; b3] => [a2 * b3 - a3 * b2; a3 * b1 - a1 * b3; a1 * b2 - a2 * b1]
  | _, _ => []
  end.

(* a sqrt b >= c sqrt d, for b, d >= 0 *)
Definition root_at_least (a b c d : Q) : bool :=
  if Qle_bool 0 a then Qle_bool c 0 || Qle_bool (c * c * d) (a * a * b)
  else negb (Qle_bool 0 c) && Qle_bool (a * a * b) (c * c * d).

(* y.N >= rho |S y|; and (y.N) |s| >= rho s.S y *)
Definition resists_all (x : rigid) (y : vector) : bool :=
  root_at_least (inner (r_N x) y) 1 (r_friction x) (r_square x * inner (slip_of x y) (slip_of x y)).

Definition resists (x : rigid) (y side : vector) : bool :=
  root_at_least (inner (r_N x) y) (inner side side) (r_friction x * inner side (slip_of x y)) (r_square x).

(* Two sides, across the normal and up to a right angle. *)
Definition good_sides (x : rigid) (u v : vector) : bool :=
  Nat.eqb (List.length (r_normal x)) 3 && Nat.eqb (List.length (r_slips x)) 3 &&
  forallb is_zero (of_rows (r_normal x) (r_slips x)) &&
  is_zero (inner (r_normal x) u) && is_zero (inner (r_normal x) v) && Qle_bool 0 (inner u v) &&
  negb (Qle_bool (inner (r_normal x) (cross u v)) 0).

Definition resists_against (x : rigid) (y : vector) (known : option matrix) : bool :=
  match known with
  | None | Some [] => resists_all x y
  | Some [s] => resists x y s
  | Some [u; v] =>
      let z := slip_of x y in
      if Qle_bool 0 (inner (r_normal x) (cross u z)) && Qle_bool 0 (inner (r_normal x) (cross z v))
      then resists_all x y
      else good_sides x u v && resists x y u && resists x y v
  | Some _ => false
  end.

(* The c with v = c u, if there is one that is not 0. *)
Definition factor (u v : vector) : option Q :=
  let c := inner u v / inner u u in
  if negb (is_zero c) && same_vectors v (map (Qmult c) u) then Some c else None.

Definition is_positive_multiple (u v : vector) : bool :=
  match factor u v with Some c => Qle_bool 0 c | None => false end.

(* The c with S_j = c S_i: in the plane any but 0, in space 1, if the normals are alike. *)
Definition slip_factor (x y : rigid) : option Q :=
  match r_slips x, r_slips y with
  | [s], [t] => factor s t
  | _, _ => if same_matrices (r_slips x) (r_slips y) && is_positive_multiple (r_normal x) (r_normal y) then
    Some 1 else None
  end.

Definition turned (c : Q) (ss : matrix) : matrix := if Qle_bool 0 c then ss else map opposite ss.

Definition cell := list (rigid * knowledge).

Definition with_touch (x : rigid) (it : bool) (p : rigid * knowledge) : rigid * knowledge :=
  if is_positive_multiple (r_N x) (r_N (fst p)) then (fst p, Knowledge (Some it) (sides (snd p))) else p.

Definition with_sides (x : rigid) (ss : matrix) (p : rigid * knowledge) : rigid * knowledge :=
  match slip_factor x (fst p) with
  | Some c => (fst p, Knowledge (touches (snd p)) (Some (turned c ss)))
  | None => p
  end.

(* The sides of the children of a slip, or the rule that fails. *)
Definition slip_children (x : rigid) (known : option matrix) (d : vector) : list matrix + string :=
  match r_slips x with
  | [_] => inl [[[1]]; []; [[-(1)]]]
  | _ =>
      let n := r_normal x in
      if forallb is_zero d || negb (is_zero (inner n d)) || negb (good_sides x d (cross n d)) then inr
        "class-slip"%string
      else
        match known with
        | Some [u; v] =>
            if negb (Qle_bool (inner n (cross u d)) 0) && negb (Qle_bool (inner n (cross d v)) 0) &&
               good_sides x u v
            then inl [[u; d]; [d; v]] else inr "class-slip"%string
        | _ =>
            let e := cross n d in
            inl [[]; [d; e]; [e; opposite d]; [opposite d; opposite e]; [opposite e; d]]
        end
  end.

(* In a list of [i, ...]: i increases, and is of a contact. *)
Fixpoint ascending {A} (count : Z) (last : Z) (them : list (Z * A)) : bool :=
  match them with
  | [] => true
  | (i, _) :: rest => Z.ltb last i && Z.ltb i count && ascending count i rest
  end.

Definition count_of {A} (l : list A) : Z := fold_left (fun n _ => n + 1)%Z l 0%Z.

(* The sum of g N and S^T h; and whether their signs are right. *)
Definition normal_sum (c : cell) (gs : list (Z * Q)) : vector :=
  fold_left (fun sum ig => match numbered c (fst ig) with
                           | Some (x, _) => plus_times sum (snd ig) (r_N x)
                           | None => sum
                           end) gs [].

Definition normal_right (c : cell) (ig : Z * Q) : bool :=
  match numbered c (fst ig) with
  | Some (_, Knowledge (Some true) _) => true
  | Some _ => Qle_bool 0 (snd ig)
  | None => false
  end.

Definition slip_sum (c : cell) (hs : list (Z * vector)) : vector :=
  fold_left (fun sum ih => match numbered c (fst ih) with
                           | Some (x, _) => plus_times sum 1 (of_rows (snd ih) (r_slips x))
                           | None => sum
                           end) hs [].

Definition slip_right (c : cell) (ih : Z * vector) : bool :=
  match numbered c (fst ih) with
  | Some (x, Knowledge _ (Some ss)) =>
      (match r_slips x with [_] => true | _ => is_zero (inner (snd ih) (r_normal x)) end) &&
      forallb (fun s => Qle_bool 0 (inner (snd ih) s)) ss
  | _ => false
  end.

Definition rigid_leaf (mass : matrix) (w : vector) (c : cell) (t : Q) (y : vector) (gs : list (Z * Q))
    (hs : list (Z * vector)) : bool :=
  let yw := inner y w in
  Qle_bool 0 t && Qle_bool 0 yw && negb (is_zero t && is_zero yw) &&
  ascending (count_of c) (-1) gs && ascending (count_of c) (-1) hs &&
  forallb (normal_right c) gs && forallb (slip_right c) hs &&
  forallb (fun p => match touches (snd p) with Some false => true | _ => resists_against (fst p) y (sides (snd
    p)) end) c &&
  forallb is_zero
    (plus_times (plus_times (plus_times (plus_times [] t w) 1 (map (fun r => inner r y) mass)) 1 (normal_sum c
      gs)) 1
       (slip_sum c hs)).

(* The children of a node, or the rule that fails. *)
Definition rigid_split (mass : matrix) (w : vector) (c : cell) (n : rigid_node) : list cell + string :=
  match n with
  | RTouch i =>
      match numbered c i with
      | Some (x, _) => inl [map_all (with_touch x true) c; map_all (with_touch x false) c]
      | None => inr "node-contact"%string
      end
  | RSlip i d =>
      match numbered c i with
      | Some (x, k) =>
          match slip_children x (sides k) d with
          | inl them => inl (map (fun ss => map_all (with_sides x ss) c) them)
          | inr rule => inr rule
          end
      | None => inr "node-contact"%string
      end
  | RLeaf t y gs hs => if rigid_leaf mass w c t y gs hs then inl [] else inr "class-leaf"%string
  end.

Fixpoint rigid_walk (most_depth : Z) (mass : matrix) (w : vector) (nodes : list rigid_node) (todo : list (cell * Z))
    (number : nat) : option (string * nat) :=
  match nodes, todo with
  | [], [] => None
  | [], _ :: _ => Some ("tree-short"%string, number)
  | _ :: _, [] => Some ("tree-long"%string, number)
  | n :: nodes', (c, depth) :: todo' =>
      if Z.ltb most_depth depth then Some ("node-depth"%string, number)
      else
        match rigid_split mass w c n with
        | inl children => rigid_walk most_depth mass w nodes' (map (fun c => (c, depth + 1)%Z) children ++
          todo') (S number)
        | inr rule => Some (rule, number)
        end
  end.

End Rules.

(* ---- Proofs: vectors ---- *)

Section Vectors.
Open Scope R_scope.

Lemma root_at_least_is a b c d : 0 <= Q2R b -> 0 <= Q2R d -> root_at_least a b c d = true ->
  Q2R c * sqrt (Q2R d) <= Q2R a * sqrt (Q2R b).
Proof.
  intros B D H. unfold root_at_least in H. pose proof (sqrt_pos (Q2R b)) as Sb. pose proof (sqrt_pos (Q2R d)) as Sd.
  pose proof (sqrt_sqrt _ B) as Bb. pose proof (sqrt_sqrt _ D) as Dd.
  set (p := sqrt (Q2R b)) in *. set (q := sqrt (Q2R d)) in *.
  destruct (Qle_bool 0 a) eqn:A.
  - apply Qle_bool_R in A. rewrite Q2R_0 in A. apply orb_true_iff in H as [H|H].
    + apply Qle_bool_R in H. rewrite Q2R_0 in H. pose proof (Rmult_le_pos _ _ A Sb). nra.
    + apply Qle_bool_R in H. rewrite !Q2R_mult, <- Bb, <- Dd in H. pose proof (Rmult_le_pos _ _ A Sb) as P.
      apply Rnot_lt_le. intros L. assert (Q2R a * p * (Q2R a * p) < Q2R c * q * (Q2R c * q)); [|nra].
      apply Rmult_le_0_lt_compat; assumption.
  - apply andb_true_iff in H as [C H]. apply negb_true_iff in C.
    assert (Neg : forall x, Qle_bool 0 x = false -> Q2R x < 0).
    { intros x X. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L. congruence. }
    apply Neg in A, C. apply Qle_bool_R in H. rewrite !Q2R_mult, <- Bb, <- Dd in H.
    apply Rnot_lt_le. intros L. assert (- (Q2R c * q) * - (Q2R c * q) < - (Q2R a * p) * - (Q2R a * p)); [|nra].
    apply Rmult_le_0_lt_compat; nra.
Qed.

(* Of the products with the weights 1 those of lists. *)
Lemma product_ones {A} (l : list A) s t : (List.length s <= List.length l)%nat ->
  Rows.product (map (fun _ => 1) l) s t = Rows.dot s t.
Proof.
  revert s t. induction l as [|x l IH]; intros [|p s] [|q t] L; cbn in *; try lia; try reflexivity.
  rewrite IH by lia. ring.
Qed.

Lemma ones_positive {A} (l : list A) : Rows.positive (map (fun _ => 1) l).
Proof. apply Forall_map, Forall_forall. intros; lra. Qed.

Notation "u .* v" := (Rows.dot u v) (at level 40).

Lemma dot_nonneg u : 0 <= u .* u.
Proof. induction u as [|x u IH]; cbn; [lra|]. pose proof (Rle_0_sqr x). unfold Rsqr in *. lra. Qed.

Lemma cauchy u v : u .* v <= sqrt (u .* u) * sqrt (v .* v).
Proof.
  pose proof (Rows.product_bound (map (fun _ => 1) u) u v (ones_positive u)) as B.
  unfold Rows.size in B. rewrite !product_ones in B by lia. destruct (le_lt_dec (List.length v) (List.length u)).
  - now rewrite product_ones in B by lia.
  - pose proof (Rows.product_bound (map (fun _ => 1) v) u v (ones_positive v)) as B'.
    unfold Rows.size in B'. now rewrite !product_ones in B' by lia.
Qed.

(* A sum of multiples >= 0 of sides. *)
Definition cone_of (ss : matrix) (s : list R) : Prop :=
  exists cs, List.length cs = List.length ss /\ Forall (fun c => 0 <= c) cs /\
    forall t, s .* t = cs .* map (fun side => real side .* t) ss.

Lemma cone_turned c ss s : cone_of ss s -> cone_of (turned c ss) (Rows.scaled (Q2R c) s).
Proof.
  intros (cs & L & P & E). unfold turned. destruct (Qle_bool 0 c) eqn:C.
  - apply Qle_bool_R in C. rewrite Q2R_0 in C. exists (Rows.scaled (Q2R c) cs).
    split; [unfold Rows.scaled; now rewrite map_length|]. split.
    + apply Forall_map. eapply Forall_impl; [|exact P]. cbn. intros; nra.
    + intros t. now rewrite !Rows.dot_scaled, E.
  - assert (N : Q2R c < 0).
    { apply Rnot_le_lt. intros Le. rewrite <- Q2R_0 in Le. apply Rle_Qle, Qle_bool_iff in Le. congruence. }
    exists (Rows.scaled (- Q2R c) cs). split; [unfold Rows.scaled; now rewrite !map_length|]. split.
    + apply Forall_map. eapply Forall_impl; [|exact P]. cbn. intros; nra.
    + intros t. rewrite !Rows.dot_scaled, E, map_map.
      assert (G : forall cs ss, cs .* map (fun x => real (opposite x) .* t) ss = - (cs .* map (fun side => real
        side .* t) ss)).
      { clear. induction cs as [|x cs IH]; intros [|s ss]; cbn; try ring. rewrite IH.
        fold (real (opposite s)). rewrite dot_opposite. ring. }
      rewrite G. ring.
Qed.

(* What one side allows all slips along it allow. *)
Lemma along_one_side rho A side s z : cone_of [side] s -> 0 < s .* s ->
  rho * (real side .* z) <= A * sqrt (real side .* real side) -> rho * (s .* z) <= A * sqrt (s .* s).
Proof.
  intros (cs & L & P & E) S H. destruct cs as [|c [|? ?]]; try discriminate. pose proof (Forall_inv P) as C.
    cbn in C, E.
  assert (Sz : s .* z = c * (real side .* z)) by (rewrite E; ring).
  assert (Ss : s .* s = c * c * (real side .* real side)).
  { rewrite (E s), dot_sym, (E (real side)). ring. }
  rewrite Sz, Ss, sqrt_mult_alt, sqrt_square by nra. nra.
Qed.

(* Between two sides at most a right angle apart, what both allow all allow, if z is not between them. *)
Lemma between_sides rho A (u v s z : list R) al be : 0 <= rho -> 0 <= al -> 0 <= be -> (forall t, s .* t = al *
  (u .* t) + be * (v .* t)) ->
  0 <= u .* v -> 0 < u .* u ->
  (s .* z) * (u .* u) <= (s .* u) * (u .* z) ->
  rho * (u .* z) <= A * sqrt (u .* u) -> 0 <= A -> rho * (s .* z) <= A * sqrt (s .* s).
Proof.
  intros R0 Al Be E UV UU K H A0.
  assert (Su : 0 <= s .* u) by (rewrite E, (dot_sym v u); nra).
  pose proof (sqrt_pos (s .* s)) as Ss. pose proof (sqrt_lt_R0 _ UU) as Pu. pose proof (sqrt_sqrt (u .* u)
    (Rlt_le _ _ UU)) as Qu.
  destruct (Rle_dec (u .* z) 0) as [N|N].
  - assert (s .* z <= 0).
    { apply Rnot_lt_le. intros Lt. pose proof (Rmult_lt_0_compat _ _ Lt UU).
      assert (0 <= (s .* u) * - (u .* z)) by (apply Rmult_le_pos; lra). lra. }
    assert (0 <= A * sqrt (s .* s)) by (apply Rmult_le_pos; assumption).
    assert (0 <= rho * - (s .* z)) by (apply Rmult_le_pos; lra). lra.
  - pose proof (cauchy s u) as C. set (p := sqrt (u .* u)) in *. set (q := sqrt (s .* s)) in *.
    (* (s.z) p^2 <= q p (u.z) *)
    assert (T : s .* z * p <= q * (u .* z)).
    { apply Rmult_le_reg_r with p; [exact Pu|]. rewrite Rmult_assoc, Qu.
      assert ((s .* u) * (u .* z) <= q * p * (u .* z)) by (apply Rmult_le_compat_r; lra). lra. }
    apply Rmult_le_reg_r with p; [exact Pu|].
    assert (rho * (s .* z * p) <= rho * (q * (u .* z))) by (apply Rmult_le_compat_l; assumption).
    assert (q * (rho * (u .* z)) <= q * (A * p)) by (apply Rmult_le_compat_l; assumption). lra.
Qed.

(* Where y.N is below 0 both sides are enough. *)
Lemma below_both rho A (u v s z : list R) al be : 0 <= al -> 0 <= be ->
  (forall t, s .* t = al * (u .* t) + be * (v .* t)) -> A < 0 ->
  rho * (u .* z) <= A * sqrt (u .* u) -> rho * (v .* z) <= A * sqrt (v .* v) -> rho * (s .* z) <= A * sqrt (s .* s).
Proof.
  intros Al Be E An Hu Hv. rewrite (E z).
  assert (T : sqrt (s .* s) <= al * sqrt (u .* u) + be * sqrt (v .* v)).
  { pose proof (sqrt_pos (s .* s)) as P. destruct P as [P|P].
    - apply Rmult_le_reg_l with (sqrt (s .* s)); [exact P|]. rewrite sqrt_sqrt by apply dot_nonneg.
      pose proof (E s). pose proof (cauchy u s). pose proof (cauchy v s).
      assert (al * (u .* s) <= al * (sqrt (u .* u) * sqrt (s .* s))) by (apply Rmult_le_compat_l; assumption).
      assert (be * (v .* s) <= be * (sqrt (v .* v) * sqrt (s .* s))) by (apply Rmult_le_compat_l; assumption). lra.
    - rewrite <- P. pose proof (sqrt_pos (u .* u)). pose proof (sqrt_pos (v .* v)). nra. }
  assert (al * (rho * (u .* z)) <= al * (A * sqrt (u .* u))) by (apply Rmult_le_compat_l; assumption).
  assert (be * (rho * (v .* z)) <= be * (A * sqrt (v .* v))) by (apply Rmult_le_compat_l; assumption). nra.
Qed.

(* In space: for u, v and z across n, |n|^2 (u x v).(u x z) is the product of n.(u x v) and n.(u x z). *)
Lemma sides_of_plane n1 n2 n3 u1 u2 u3 v1 v2 v3 z1 z2 z3 :
  n1 * u1 + n2 * u2 + n3 * u3 = 0 -> n1 * v1 + n2 * v2 + n3 * v3 = 0 ->
  (n1 * n1 + n2 * n2 + n3 * n3) * ((u1 * u1 + u2 * u2 + u3 * u3) * (v1 * z1 + v2 * z2 + v3 * z3) -
     (u1 * v1 + u2 * v2 + u3 * v3) * (u1 * z1 + u2 * z2 + u3 * z3)) =
  (n1 * (u2 * v3 - u3 * v2) + n2 * (u3 * v1 - u1 * v3) + n3 * (u1 * v2 - u2 * v1)) *
  (n1 * (u2 * z3 - u3 * z2) + n2 * (u3 * z1 - u1 * z3) + n3 * (u1 * z2 - u2 * z1)).
Proof.
  intros U V.
  set (nu := n1 * u1 + n2 * u2 + n3 * u3) in U. set (nv := n1 * v1 + n2 * v2 + n3 * v3) in V.
  (* Lagrange: n x (u x v) = u (n.v) - v (n.u) *)
  transitivity
    ((n1 * (u2 * v3 - u3 * v2) + n2 * (u3 * v1 - u1 * v3) + n3 * (u1 * v2 - u2 * v1)) *
     (n1 * (u2 * z3 - u3 * z2) + n2 * (u3 * z1 - u1 * z3) + n3 * (u1 * z2 - u2 * z1)) +
     ((u1 * nv - v1 * nu) * (n2 * (u1 * z2 - u2 * z1) - n3 * (u3 * z1 - u1 * z3)) +
      (u2 * nv - v2 * nu) * (n3 * (u2 * z3 - u3 * z2) - n1 * (u1 * z2 - u2 * z1)) +
      (u3 * nv - v3 * nu) * (n1 * (u3 * z1 - u1 * z3) - n2 * (u2 * z3 - u3 * z2)))).
  - unfold nu, nv. ring.
  - rewrite U, V. ring.
Qed.

End Vectors.

(* ---- Proofs: what is known of a contact ---- *)

Section Contacts.
Open Scope R_scope.

Notation "u .* v" := (Rows.dot u v) (at level 40).

(* A contact as its row has it. *)
Record is_rigid (x : rigid) (r : Rows.row) : Prop := IsRigid {
  is_r_N : forall y, Rows.N r .* y = real (r_N x) .* y;
  is_r_slips : forall y, Rows.slip r y = map (fun f => real f .* y) (r_slips x);
  is_r_rho : Rows.rho r = Q2R (r_friction x) * sqrt (Q2R (r_square x));
  r_friction_nonneg : 0 <= Q2R (r_friction x);
  r_square_nonneg : 0 <= Q2R (r_square x);
  is_r_weights : Rows.weights r = map (fun _ => 1) (r_slips x)
}.

(* What is known is so. *)
Definition known (a : list R) (k : knowledge) (r : Rows.row) (f : Rows.force) : Prop :=
  (touches k = Some true -> Rows.N r .* a = 0) /\ (touches k = Some false -> fst f = 0) /\
  match sides k with
  | None => True
  | Some [] => Rows.size (Rows.weights r) (Rows.slip r a) = 0
  | Some ss => 0 < Rows.size (Rows.weights r) (Rows.slip r a) /\ cone_of ss (Rows.slip r a)
  end.

Variable x : rigid.
Variable r : Rows.row.
Hypothesis X : is_rigid x r.

Lemma slip_length y : List.length (Rows.slip r y) = List.length (r_slips x).
Proof. rewrite (is_r_slips _ _ X). apply map_length. Qed.

Lemma weights_are : Rows.positive (Rows.weights r).
Proof. rewrite (is_r_weights _ _ X). apply ones_positive. Qed.

Lemma product_is g y : Rows.product (Rows.weights r) (Rows.slip r g) y = Rows.slip r g .* y.
Proof. rewrite (is_r_weights _ _ X). apply product_ones. now rewrite slip_length. Qed.

Lemma size_is y : Rows.size (Rows.weights r) (Rows.slip r y) = sqrt (Rows.slip r y .* Rows.slip r y).
Proof. unfold Rows.size. now rewrite product_is. Qed.

Lemma slip_of_is y : Rows.slip r (real y) = real (slip_of x y).
Proof.
  rewrite (is_r_slips _ _ X). unfold slip_of, real. rewrite map_map. apply map_ext. intros f. symmetry. apply
    inner_is.
Qed.

Lemma N_is y : Rows.N r .* real y = Q2R (inner (r_N x) y).
Proof. now rewrite (is_r_N _ _ X), inner_is. Qed.

Lemma rho_nonneg' : 0 <= Rows.rho r.
Proof. rewrite (is_r_rho _ _ X). apply Rmult_le_pos; [apply X|apply sqrt_pos]. Qed.

(* y.N >= rho |S y| *)
Lemma resists_all_is y : resists_all x y = true ->
  Rows.rho r * Rows.size (Rows.weights r) (Rows.slip r (real y)) <= Rows.N r .* real y.
Proof.
  intros H. unfold resists_all in H. apply root_at_least_is in H.
  - rewrite N_is, size_is, slip_of_is, (is_r_rho _ _ X), <- inner_is, Rmult_assoc, <- sqrt_mult_alt by apply X.
    rewrite Q2R_mult, Q2R_1, sqrt_1, Rmult_1_r in H. exact H.
  - rewrite Q2R_1. lra.
  - rewrite Q2R_mult, inner_is. apply Rmult_le_pos; [apply X|apply dot_nonneg].
Qed.

Lemma resists_is y side : resists x y side = true ->
  Rows.rho r * (real side .* Rows.slip r (real y)) <= (Rows.N r .* real y) * sqrt (real side .* real side).
Proof.
  intros H. unfold resists in H. apply root_at_least_is in H; [|rewrite inner_is; apply dot_nonneg|apply X].
  rewrite Q2R_mult, !inner_is, <- slip_of_is in H. rewrite N_is, (is_r_rho _ _ X).
  rewrite inner_is in *. rewrite Rmult_assoc, (Rmult_comm (sqrt _)), <- Rmult_assoc. exact H.
Qed.

Variables (a : list R) (n : R) (g : list R).
Hypothesis Ob : rigid_obeys a r (n, g).

(* Any force in the cone. *)
Lemma all_do_work y : resists_all x y = true -> 0 <= Rows.work r (n, g) (real y).
Proof.
  intros H. apply resists_all_is in H. destruct Ob as ((N0 & _) & C & _). unfold Rows.work. cbn [fst snd].
  pose proof (Rows.product_bound (Rows.weights r) (Rows.scaled (-1) g) (Rows.slip r (real y)) weights_are) as B.
  rewrite Rows.product_scaled in B.
  assert (E : Rows.size (Rows.weights r) (Rows.scaled (-1) g) = Rows.size (Rows.weights r) g).
  { unfold Rows.size. f_equal. rewrite Rows.product_scaled, Rows.product_sym, Rows.product_scaled. ring. }
  rewrite E in B. pose proof (Rows.size_nonneg (Rows.weights r) (Rows.slip r (real y))) as Z.
  set (z := Rows.size (Rows.weights r) (Rows.slip r (real y))) in *. set (w := Rows.product _ _ _) in *.
  assert (Rows.size (Rows.weights r) g * z <= Rows.rho r * n * z) by (apply Rmult_le_compat_r; assumption).
  assert (n * (Rows.rho r * z) <= n * (Rows.N r .* real y)) by (apply Rmult_le_compat_l; assumption). lra.
Qed.

(* Friction against a slip that the sides allow. *)
Lemma against_does_work y s : 0 < Rows.size (Rows.weights r) (Rows.slip r a) -> s = Rows.slip r a ->
  Rows.rho r * (s .* Rows.slip r (real y)) <= (Rows.N r .* real y) * sqrt (s .* s) ->
  0 <= Rows.work r (n, g) (real y).
Proof.
  intros S -> H. destruct Ob as ((N0 & _) & C & D). unfold Rows.work. cbn [fst snd].
  rewrite (Rows.against_slip _ g (Rows.slip r a) (Rows.rho r * n) weights_are C D S).
  rewrite product_is, size_is in *. set (q := sqrt _) in *. set (z := Rows.slip r a .* Rows.slip r (real y)) in *.
  assert (0 < / q) by now apply Rinv_0_lt_compat.
  replace (n * (Rows.N r .* real y) + - (Rows.rho r * n / q) * z)
    with (n * (/ q * (Rows.N r .* real y * q - Rows.rho r * z))) by (field; lra).
  apply Rmult_le_pos; [exact N0|]. apply Rmult_le_pos; lra.
Qed.

Lemma positive_real q : Qle_bool q 0 = false -> 0 < Q2R q.
Proof. intros H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L.
  congruence. Qed.

Lemma negative_real q : Qle_bool 0 q = false -> Q2R q < 0.
Proof. intros H. apply Rnot_le_lt. intros L. rewrite <- Q2R_0 in L. apply Rle_Qle, Qle_bool_iff in L.
  congruence. Qed.

Lemma cross_3 p u v : inner p (cross u v) = 0%Q \/ exists p1 p' u1 u2 u3 v1 v2 v3,
  p = p1 :: p' /\ u = [u1; u2; u3] /\ v = [v1; v2; v3].
Proof.
  destruct u as [|u1 [|u2 [|u3 [|? ?]]]]; try (left; cbn [cross]; now destruct p).
  destruct v as [|v1 [|v2 [|v3 [|? ?]]]]; try (left; cbn [cross]; now destruct p).
  destruct p as [|p1 p']; [now left|]. right. now exists p1, p', u1, u2, u3, v1, v2, v3.
Qed.

Lemma crossed p1 p2 p3 u1 u2 u3 v1 v2 v3 :
  Q2R (inner [p1; p2; p3] (cross [u1; u2; u3] [v1; v2; v3])) =
  Q2R p1 * (Q2R u2 * Q2R v3 - Q2R u3 * Q2R v2) + Q2R p2 * (Q2R u3 * Q2R v1 - Q2R u1 * Q2R v3) +
  Q2R p3 * (Q2R u1 * Q2R v2 - Q2R u2 * Q2R v1).
Proof. rewrite inner_is. unfold cross, real. cbn [map Rows.dot]. rewrite !Q2R_minus, !Q2R_mult. ring. Qed.

(* Two sides across the normal, and z beyond one of them. *)
Lemma beyond_a_side (u v z : vector) s al be : List.length (r_normal x) = 3%nat ->
  real (r_normal x) .* real u = 0 -> real (r_normal x) .* real v = 0 ->
  Q2R (inner (r_normal x) (cross u v)) * Q2R (inner (r_normal x) (cross u z)) < 0 ->
  0 <= al -> 0 <= be -> (forall t, s .* t = al * (real u .* t) + be * (real v .* t)) ->
  (s .* real z) * (real u .* real u) <= (s .* real u) * (real u .* real z) /\ 0 < real u .* real u.
Proof.
  intros L3 Nu Nv BC Al Be E.
  destruct (cross_3 (r_normal x) u v) as [Z|(p1 & p' & u1 & u2 & u3 & v1 & v2 & v3 & Ep & -> & ->)];
    [rewrite Z, Q2R_0 in BC; lra|].
  destruct (cross_3 (r_normal x) [u1; u2; u3] z) as [Z|(_ & _ & _ & _ & _ & z1 & z2 & z3 & _ & _ & ->)];
    [rewrite Z, Q2R_0 in BC; lra|]. clear Ep.
  destruct (r_normal x) as [|n1 [|n2 [|n3 [|? ?]]]]; try discriminate. rewrite !crossed in BC.
  rewrite !E. unfold real in *. cbn [map Rows.dot] in *.
  set (N1 := Q2R n1) in *. set (N2 := Q2R n2) in *. set (N3 := Q2R n3) in *.
  set (U1 := Q2R u1) in *. set (U2 := Q2R u2) in *. set (U3 := Q2R u3) in *.
  set (V1 := Q2R v1) in *. set (V2 := Q2R v2) in *. set (V3 := Q2R v3) in *.
  set (Z1 := Q2R z1) in *. set (Z2 := Q2R z2) in *. set (Z3 := Q2R z3) in *.
  pose proof (sides_of_plane N1 N2 N3 U1 U2 U3 V1 V2 V3 Z1 Z2 Z3 ltac:(lra) ltac:(lra)) as S.
  set (c := N1 * (U2 * V3 - U3 * V2) + N2 * (U3 * V1 - U1 * V3) + N3 * (U1 * V2 - U2 * V1)) in *.
  set (b := N1 * (U2 * Z3 - U3 * Z2) + N2 * (U3 * Z1 - U1 * Z3) + N3 * (U1 * Z2 - U2 * Z1)) in *.
  set (m := (U1 * U1 + U2 * U2 + U3 * U3) * (V1 * Z1 + V2 * Z2 + V3 * Z3) -
     (U1 * V1 + U2 * V2 + U3 * V3) * (U1 * Z1 + U2 * Z2 + U3 * Z3)) in *.
  pose proof (Rle_0_sqr N1) as Q1. pose proof (Rle_0_sqr N2) as Q2. pose proof (Rle_0_sqr N3) as Q3. unfold
    Rsqr in *.
  assert (M : m <= 0).
  { apply Rnot_lt_le. intros Lt. assert (0 <= (N1 * N1 + N2 * N2 + N3 * N3) * m) by (apply Rmult_le_pos; lra).
      lra. }
  split.
  - assert (0 <= be * - m) by (apply Rmult_le_pos; lra). unfold m in H. lra.
  - pose proof (Rle_0_sqr U1) as P1. pose proof (Rle_0_sqr U2) as P2. pose proof (Rle_0_sqr U3) as P3. unfold
      Rsqr in *.
    destruct (Req_dec (U1 * U1 + U2 * U2 + U3 * U3) 0) as [Z|Z]; [|lra]. exfalso.
    assert (U1 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). assert (U2 = 0) by (apply Rsqr_0_uniq; unfold
      Rsqr; lra).
    assert (U3 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). unfold c in BC. rewrite H, H0, H1 in BC. lra.
Qed.

Lemma cross_opposite p u v : List.length p = 3%nat -> Q2R (inner p (cross v u)) = - Q2R (inner p (cross u v)).
Proof.
  intros L. destruct p as [|p1 [|p2 [|p3 [|? ?]]]]; try discriminate.
  destruct u as [|u1 [|u2 [|u3 [|? ?]]]], v as [|v1 [|v2 [|v3 [|? ?]]]]; try (cbn [cross inner]; rewrite Q2R_0;
    ring).
  rewrite !crossed. ring.
Qed.

(* The force of a contact of which this is known does work on y. *)
Lemma known_does_work k y : known a k r (n, g) -> touches k = Some false \/ resists_against x y (sides k) = true ->
  0 <= Rows.work r (n, g) (real y).
Proof.
  intros (_ & Apart & S) [H|H].
  { specialize (Apart H). cbn in Apart. subst n. destruct Ob as (_ & C & _). rewrite Rmult_0_r in C.
    unfold Rows.work. cbn [fst snd]. rewrite (Rows.size_zero _ g _ weights_are); [lra|].
    pose proof (Rows.size_nonneg (Rows.weights r) g). lra. }
  pose proof (all_do_work y) as All. unfold resists_against in H.
  destruct (sides k) as [[|u [|v [|? ?]]]|]; try (now apply All); try discriminate.
  - destruct S as [P S]. apply (against_does_work y (Rows.slip r a) P eq_refl).
    apply (along_one_side _ _ u); [exact S| |now apply resists_is].
    rewrite size_is in P. destruct (Req_dec (Rows.slip r a .* Rows.slip r a) 0) as [Z|Z].
    + rewrite Z, sqrt_0 in P. lra.
    + pose proof (dot_nonneg (Rows.slip r a)). lra.
  - destruct S as [P (cs & L & Pos & E)]. destruct cs as [|al [|be [|? ?]]]; try discriminate.
    pose proof (Forall_inv Pos) as Al. pose proof (Forall_inv (Forall_inv_tail Pos)) as Be. cbn in Al, Be, E.
    assert (E' : forall t, Rows.slip r a .* t = al * (real u .* t) + be * (real v .* t)) by (intros t; rewrite
      E; ring).
    destruct (Qle_bool 0 _ && Qle_bool 0 _) eqn:B; [now apply All|].
    rewrite !andb_true_iff in H. destruct H as [[G Ru] Rv]. apply resists_is in Ru, Rv.
    apply (against_does_work y (Rows.slip r a) P eq_refl).
    pose proof rho_nonneg' as R0. rewrite slip_of_is in *.
    destruct (Rlt_le_dec (Rows.N r .* real y) 0) as [An|A0].
    { exact (below_both _ _ (real u) (real v) _ _ al be Al Be E' An Ru Rv). }
    unfold good_sides in G. rewrite !andb_true_iff in G. destruct G as [[[[[[L3 S3] Sl] Nu] Nv] UV] C].
    apply Nat.eqb_eq in L3. apply is_zero_real in Nu, Nv. rewrite inner_is in Nu, Nv.
    apply Qle_bool_R in UV. rewrite Q2R_0, inner_is in UV. apply negb_true_iff, positive_real in C.
    apply andb_false_iff in B as [B|B]; apply negative_real in B.
    + destruct (beyond_a_side u v (slip_of x y) (Rows.slip r a) al be L3 Nu Nv ltac:(nra) Al Be E') as [K UU].
      exact (between_sides _ _ (real u) (real v) _ _ al be R0 Al Be E' UV UU K Ru A0).
    + assert (E2 : forall t, Rows.slip r a .* t = be * (real v .* t) + al * (real u .* t)) by (intros t;
        rewrite E'; ring).
      rewrite (cross_opposite _ v (slip_of x y) L3) in B.
      assert (BC : Q2R (inner (r_normal x) (cross v u)) * Q2R (inner (r_normal x) (cross v (slip_of x y))) < 0).
      { rewrite (cross_opposite _ u v L3). nra. }
      destruct (beyond_a_side v u (slip_of x y) (Rows.slip r a) be al L3 Nv Nu BC Be Al E2) as [K VV].
      rewrite dot_sym in UV.
      exact (between_sides _ _ (real v) (real u) _ _ be al R0 Be Al E2 UV VV K Rv A0).
Qed.

End Contacts.

(* ---- Proofs: slips in space ---- *)

Section Slips.
Open Scope R_scope.

(* d and n x d, across n, are a basis of what is across n. *)
Lemma in_basis n1 n2 n3 d1 d2 d3 s1 s2 s3 :
  n1 * d1 + n2 * d2 + n3 * d3 = 0 -> n1 * s1 + n2 * s2 + n3 * s3 = 0 ->
  let e1 := n2 * d3 - n3 * d2 in let e2 := n3 * d1 - n1 * d3 in let e3 := n1 * d2 - n2 * d1 in
  let nn := n1 * n1 + n2 * n2 + n3 * n3 in let dd := d1 * d1 + d2 * d2 + d3 * d3 in
  let sd := s1 * d1 + s2 * d2 + s3 * d3 in let se := s1 * e1 + s2 * e2 + s3 * e3 in
  nn * dd * s1 = nn * sd * d1 + se * e1 /\ nn * dd * s2 = nn * sd * d2 + se * e2 /\ nn * dd * s3 = nn * sd * d3
    + se * e3.
Proof.
  intros D S e1 e2 e3 nn dd sd se.
  set (nd := n1 * d1 + n2 * d2 + n3 * d3) in D. set (ns := n1 * s1 + n2 * s2 + n3 * s3) in S.
  assert (G : forall ni di si ei, se * ei = nn * dd * si - dd * ns * ni - nn * sd * di ->
    nn * dd * si = nn * sd * di + se * ei) by (intros ni di si ei E; rewrite E, S; ring).
  assert (C : forall x, nd * x = 0) by (intros; rewrite D; ring).
  repeat split.
  - apply (G n1). transitivity (nn * dd * s1 - dd * ns * n1 - nn * sd * d1 + nd * (sd * n1 + ns * d1 - nd *
      s1)); [|rewrite C; ring].
    unfold se, e1, e2, e3, nn, dd, sd, ns, nd. ring.
  - apply (G n2). transitivity (nn * dd * s2 - dd * ns * n2 - nn * sd * d2 + nd * (sd * n2 + ns * d2 - nd *
      s2)); [|rewrite C; ring].
    unfold se, e1, e2, e3, nn, dd, sd, ns, nd. ring.
  - apply (G n3). transitivity (nn * dd * s3 - dd * ns * n3 - nn * sd * d3 + nd * (sd * n3 + ns * d3 - nd *
      s3)); [|rewrite C; ring].
    unfold se, e1, e2, e3, nn, dd, sd, ns, nd. ring.
Qed.

(* Of three vectors across n, one by the two others. *)
Lemma by_others n1 n2 n3 u1 u2 u3 v1 v2 v3 d1 d2 d3 :
  n1 * u1 + n2 * u2 + n3 * u3 = 0 -> n1 * v1 + n2 * v2 + n3 * v3 = 0 -> n1 * d1 + n2 * d2 + n3 * d3 = 0 ->
  0 < n1 * n1 + n2 * n2 + n3 * n3 ->
  let c p1 p2 p3 q1 q2 q3 := n1 * (p2 * q3 - p3 * q2) + n2 * (p3 * q1 - p1 * q3) + n3 * (p1 * q2 - p2 * q1) in
  c u1 u2 u3 v1 v2 v3 * d1 = c d1 d2 d3 v1 v2 v3 * u1 + c u1 u2 u3 d1 d2 d3 * v1 /\
  c u1 u2 u3 v1 v2 v3 * d2 = c d1 d2 d3 v1 v2 v3 * u2 + c u1 u2 u3 d1 d2 d3 * v2 /\
  c u1 u2 u3 v1 v2 v3 * d3 = c d1 d2 d3 v1 v2 v3 * u3 + c u1 u2 u3 d1 d2 d3 * v3.
Proof.
  intros U V D P c.
  set (t := u1 * (v2 * d3 - v3 * d2) + u2 * (v3 * d1 - v1 * d3) + u3 * (v1 * d2 - v2 * d1)).
  assert (T : t = 0).
  { apply Rmult_eq_reg_l with (n1 * n1 + n2 * n2 + n3 * n3); [|lra]. rewrite Rmult_0_r.
    set (nu := n1 * u1 + n2 * u2 + n3 * u3) in U. set (nv := n1 * v1 + n2 * v2 + n3 * v3) in V.
    set (nd := n1 * d1 + n2 * d2 + n3 * d3) in D.
    transitivity ((n1 * (v2 * d3 - v3 * d2) + n2 * (v3 * d1 - v1 * d3) + n3 * (v1 * d2 - v2 * d1)) * nu +
      ((v1 * nd - d1 * nv) * (n2 * u3 - n3 * u2) + (v2 * nd - d2 * nv) * (n3 * u1 - n1 * u3) +
       (v3 * nd - d3 * nv) * (n1 * u2 - n2 * u1))); [unfold t, nu, nv, nd; ring|]. rewrite U, V, D. ring. }
  assert (G : forall x, t * x = 0) by (intros; rewrite T; ring).
  repeat split.
  - transitivity (c d1 d2 d3 v1 v2 v3 * u1 + c u1 u2 u3 d1 d2 d3 * v1 + t * n1); [unfold c, t; ring|rewrite G;
      ring].
  - transitivity (c d1 d2 d3 v1 v2 v3 * u2 + c u1 u2 u3 d1 d2 d3 * v2 + t * n2); [unfold c, t; ring|rewrite G;
      ring].
  - transitivity (c d1 d2 d3 v1 v2 v3 * u3 + c u1 u2 u3 d1 d2 d3 * v3 + t * n3); [unfold c, t; ring|rewrite G;
      ring].
Qed.

Notation "u .* v" := (Rows.dot u v) (at level 40).

(* Sums of two vectors of three numbers, number by number. *)
Lemma dot_three s1 s2 s3 al (u : list R) be (v : list R) u1 u2 u3 v1 v2 v3 : u = [u1; u2; u3] -> v = [v1; v2; v3] ->
  s1 = al * u1 + be * v1 -> s2 = al * u2 + be * v2 -> s3 = al * u3 + be * v3 ->
  forall t, [s1; s2; s3] .* t = al * (u .* t) + be * (v .* t).
Proof. intros -> -> -> -> -> [|t1 [|t2 [|t3 t]]]; cbn; ring. Qed.

Lemma two_sides al be u v s : 0 <= al -> 0 <= be -> (forall t, s .* t = al * (real u .* t) + be * (real v .* t)) ->
  cone_of [u; v] s.
Proof.
  intros A B E. exists [al; be]. split; [reflexivity|]. split; [constructor; [exact A|constructor; [exact
    B|constructor]]|].
  intros t. rewrite E. cbn. ring.
Qed.

End Slips.

(* ---- Proofs: the children of a slip ---- *)

Section Children.
Open Scope R_scope.

Notation "u .* v" := (Rows.dot u v) (at level 40).

(* A slip is 0, or in the cone of sides and not 0. *)
Definition sides_true (ss : matrix) (r : Rows.row) (a : list R) : Prop :=
  match ss with
  | [] => Rows.size (Rows.weights r) (Rows.slip r a) = 0
  | _ => 0 < Rows.size (Rows.weights r) (Rows.slip r a) /\ cone_of ss (Rows.slip r a)
  end.

Lemma one_side c (side : Q) : 0 <= c -> cone_of [[side]] [c * Q2R side].
Proof.
  intros C. exists [c]. split; [reflexivity|]. split; [constructor; [exact C|constructor]|].
  intros t. destruct t as [|t1 t]; cbn; ring.
Qed.

(* In the plane. *)
Lemma plane_children x r a f : is_rigid x r -> r_slips x = [f] ->
  exists ss, In ss [[[1%Q]]; []; [[(-(1))%Q]]] /\ sides_true ss r a.
Proof.
  intros X E. pose proof (size_is x r X a) as Z. pose proof (is_r_slips _ _ X a) as Sl. rewrite E in Sl. cbn in Sl.
  set (t := real f .* a) in *. rewrite Sl in Z. cbn in Z. rewrite Rmult_0_r in Z || idtac.
  assert (Pos : t <> 0 -> 0 < Rows.size (Rows.weights r) (Rows.slip r a)).
  { intros N. rewrite Sl, Z. apply sqrt_lt_R0. pose proof (Rsqr_pos_lt t N). unfold Rsqr in *. lra. }
  destruct (Rtotal_order t 0) as [N|[N|N]].
  - exists [[(-(1))%Q]]. split; [cbn; auto|]. split; [apply Pos; lra|]. rewrite Sl.
    replace t with (- t * Q2R (-(1))) by (unfold Q2R; cbn; field). apply one_side. lra.
  - exists []. split; [cbn; auto|]. cbn. rewrite Sl, Z, N. replace (0 * 0 + 0) with 0 by ring. apply sqrt_0.
  - exists [[1%Q]]. split; [cbn; auto|]. split; [apply Pos; lra|]. rewrite Sl.
    replace t with (t * Q2R 1) by (rewrite Q2R_1; ring). apply one_side. lra.
Qed.

(* What good sides say. *)
Lemma good_sides_are x r u v : is_rigid x r -> good_sides x u v = true ->
  exists n1 n2 n3 u1 u2 u3 v1 v2 v3, r_normal x = [n1; n2; n3] /\ u = [u1; u2; u3] /\ v = [v1; v2; v3] /\
    Q2R n1 * Q2R u1 + Q2R n2 * Q2R u2 + Q2R n3 * Q2R u3 = 0 /\
    Q2R n1 * Q2R v1 + Q2R n2 * Q2R v2 + Q2R n3 * Q2R v3 = 0 /\
    0 < Q2R n1 * (Q2R u2 * Q2R v3 - Q2R u3 * Q2R v2) + Q2R n2 * (Q2R u3 * Q2R v1 - Q2R u1 * Q2R v3) +
        Q2R n3 * (Q2R u1 * Q2R v2 - Q2R u2 * Q2R v1) /\
    (forall a, exists s1 s2 s3, Rows.slip r a = [s1; s2; s3] /\ Q2R n1 * s1 + Q2R n2 * s2 + Q2R n3 * s3 = 0).
Proof.
  intros X G. unfold good_sides in G. rewrite !andb_true_iff in G. destruct G as [[[[[[L3 S3] Sl] Nu] Nv] _] C].
  apply Nat.eqb_eq in L3, S3. apply is_zero_real in Nu, Nv. rewrite inner_is in Nu, Nv.
  apply negb_true_iff, positive_real in C.
  destruct (cross_3 (r_normal x) u v) as [Z|(p1 & p' & u1 & u2 & u3 & v1 & v2 & v3 & Ep & -> & ->)];
    [rewrite Z, Q2R_0 in C; lra|].
  destruct (r_normal x) as [|n1 [|n2 [|n3 [|? ?]]]] eqn:En; try discriminate. rewrite crossed in C.
  exists n1, n2, n3, u1, u2, u3, v1, v2, v3. unfold real in Nu, Nv. cbn [map Rows.dot] in Nu, Nv.
  repeat split; try reflexivity; try lra. intros a. pose proof (slip_length x r X a) as L. rewrite S3 in L.
  destruct (Rows.slip r a) as [|s1 [|s2 [|s3 [|? ?]]]] eqn:Es; try discriminate. exists s1, s2, s3. split;
    [reflexivity|].
  pose proof (dot_of_rows [n1; n2; n3] (r_slips x) a) as D. unfold times in D. rewrite map_map in D.
  pose proof (is_r_slips _ _ X a) as E. unfold real in D at 3. rewrite Es in E. unfold real in E. rewrite <- E in D.
  assert (Z : forall v, forallb is_zero v = true -> forall t, real v .* t = 0).
  { clear. induction v as [|q v IH]; intros H [|t1 t]; cbn in *; try reflexivity. apply andb_true_iff in H as
      [H1 H2].
    apply is_zero_real in H1. unfold real in IH. rewrite H1, IH by exact H2. ring. }
  rewrite (Z _ Sl) in D. unfold real in D. cbn [map Rows.dot] in D. lra.
Qed.

Lemma size_zero_or r a :
  Rows.size (Rows.weights r) (Rows.slip r a) = 0 \/ 0 < Rows.size (Rows.weights r) (Rows.slip r a).
Proof. pose proof (Rows.size_nonneg (Rows.weights r) (Rows.slip r a)) as [P|P]; auto. Qed.

(* A slip in space of which nothing is known is 0 or in a quarter of the plane across the normal; *)
Lemma first_children x r a d : is_rigid x r -> good_sides x d (cross (r_normal x) d) = true ->
  let e := cross (r_normal x) d in
  exists ss, In ss [[]; [d; e]; [e; opposite d]; [opposite d; opposite e]; [opposite e; d]] /\ sides_true ss r a.
Proof.
  intros X G e. destruct (size_zero_or r a) as [Z|P]; [exists []; split; [now left|exact Z]|].
  destruct (good_sides_are x r d _ X G) as (n1 & n2 & n3 & d1 & d2 & d3 & e1 & e2 & e3 & En & Ed & Ee & Nd & _
    & C & Sl).
  destruct (Sl a) as (s1 & s2 & s3 & Es & Ns). unfold e. rewrite Ee.
  assert (Ce : real (cross (r_normal x) d) = [Q2R n2 * Q2R d3 - Q2R n3 * Q2R d2; Q2R n3 * Q2R d1 - Q2R n1 * Q2R d3;
    Q2R n1 * Q2R d2 - Q2R n2 * Q2R d1]).
  { rewrite En, Ed. unfold cross, real. cbn [map]. now rewrite !Q2R_minus, !Q2R_mult. }
  rewrite Ee in Ce. unfold real in Ce. cbn [map] in Ce. injection Ce as E1 E2 E3.
  pose proof (in_basis _ _ _ _ _ _ _ _ _ Nd Ns) as B. cbv zeta in B.
  rewrite E1, E2, E3 in C.
  set (N1 := Q2R n1) in *. set (N2 := Q2R n2) in *. set (N3 := Q2R n3) in *.
  set (D1 := Q2R d1) in *. set (D2 := Q2R d2) in *. set (D3 := Q2R d3) in *.
  set (nn := N1 * N1 + N2 * N2 + N3 * N3) in *. set (dd := D1 * D1 + D2 * D2 + D3 * D3) in *.
  assert (ND : 0 < nn * dd).
  { replace (nn * dd) with (N1 * (D2 * (N1 * D2 - N2 * D1) - D3 * (N3 * D1 - N1 * D3)) +
      N2 * (D3 * (N2 * D3 - N3 * D2) - D1 * (N1 * D2 - N2 * D1)) + N3 * (D1 * (N3 * D1 - N1 * D3) - D2 * (N2 *
        D3 - N3 * D2)) +
      (N1 * D1 + N2 * D2 + N3 * D3) * (N1 * D1 + N2 * D2 + N3 * D3)) by (unfold nn, dd; ring).
    rewrite Nd. lra. }
  assert (NN : 0 <= nn).
  { unfold nn. pose proof (Rle_0_sqr N1). pose proof (Rle_0_sqr N2). pose proof (Rle_0_sqr N3). unfold Rsqr in
      *. lra. }
  assert (NN' : 0 < nn) by (destruct NN as [NN|NN]; [exact NN|rewrite <- NN in ND; lra]).
  assert (DD : 0 < dd) by (apply Rmult_lt_reg_l with nn; lra).
  rewrite <- E1, <- E2, <- E3 in B.
  set (F1 := Q2R e1) in *. set (F2 := Q2R e2) in *. set (F3 := Q2R e3) in *.
  set (sd := s1 * D1 + s2 * D2 + s3 * D3) in *. set (se := s1 * F1 + s2 * F2 + s3 * F3) in *.
  set (al := sd / dd). set (be := se / (nn * dd)). destruct B as (B1 & B2 & B3).
  assert (Solve : forall si di fi, nn * dd * si = nn * sd * di + se * fi -> si = al * di + be * fi).
  { intros si di fi E. apply Rmult_eq_reg_l with (nn * dd); [|lra]. rewrite E. unfold al, be. field. lra. }
  pose proof (dot_three s1 s2 s3 al (real d) be (real [e1; e2; e3]) D1 D2 D3 F1 F2 F3 ltac:(now rewrite Ed) eq_refl
    (Solve _ _ _ B1) (Solve _ _ _ B2) (Solve _ _ _ B3)) as E. rewrite <- Es in E.
  assert (Op : forall w t, real (opposite w) .* t = - (real w .* t)) by (intros; apply dot_opposite).
  destruct (Rle_dec 0 al) as [A|A], (Rle_dec 0 be) as [Bp|Bp].
  - exists [d; [e1; e2; e3]]. split; [cbn; auto|]. split; [exact P|]. now apply (two_sides al be).
  - exists [opposite [e1; e2; e3]; d]. split; [cbn; auto 6|]. split; [exact P|].
    apply (two_sides (- be) al); [lra|exact A|]. intros t. rewrite E, Op. ring.
  - exists [[e1; e2; e3]; opposite d]. split; [cbn; auto|]. split; [exact P|].
    apply (two_sides be (- al)); [exact Bp|lra|]. intros t. rewrite E, Op. ring.
  - exists [opposite d; opposite [e1; e2; e3]]. split; [cbn; auto 6|]. split; [exact P|].
    apply (two_sides (- al) (- be)); [lra|lra|]. intros t. rewrite E, !Op. ring.
Qed.

(* one between two sides is on one side of a vector between them. *)
Lemma next_children x r a u v d : is_rigid x r -> good_sides x u v = true -> sides_true [u; v] r a ->
  is_zero (inner (r_normal x) d) = true -> Qle_bool (inner (r_normal x) (cross u d)) 0 = false ->
  Qle_bool (inner (r_normal x) (cross d v)) 0 = false ->
  exists ss, In ss [[u; d]; [d; v]] /\ sides_true ss r a.
Proof.
  intros X G [P (cs & L & Pos & E)] Nd Cu Cv. destruct cs as [|al [|be [|? ?]]]; try discriminate.
  pose proof (Forall_inv Pos) as Al. pose proof (Forall_inv (Forall_inv_tail Pos)) as Be. cbn in Al, Be, E.
  destruct (good_sides_are x r u v X G) as (n1 & n2 & n3 & u1 & u2 & u3 & v1 & v2 & v3 & En & -> & -> & Nu & Nv
    & C & _).
  apply positive_real in Cu, Cv. apply is_zero_real in Nd. rewrite inner_is in Nd.
  destruct (cross_3 (r_normal x) [u1; u2; u3] d) as [Z|(_ & _ & _ & _ & _ & d1 & d2 & d3 & _ & _ & ->)];
    [rewrite Z, Q2R_0 in Cu; lra|].
  rewrite En in *. rewrite crossed in Cu, Cv. unfold real in Nd. cbn [map Rows.dot] in Nd.
  assert (NN : 0 < Q2R n1 * Q2R n1 + Q2R n2 * Q2R n2 + Q2R n3 * Q2R n3).
  { pose proof (Rle_0_sqr (Q2R n1)) as Q1. pose proof (Rle_0_sqr (Q2R n2)) as Q2. pose proof (Rle_0_sqr (Q2R
      n3)) as Q3.
    unfold Rsqr in *. destruct (Req_dec (Q2R n1 * Q2R n1 + Q2R n2 * Q2R n2 + Q2R n3 * Q2R n3) 0) as [Z|Z]; [|lra].
    assert (Z1 : Q2R n1 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    assert (Z2 : Q2R n2 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra).
    assert (Z3 : Q2R n3 = 0) by (apply Rsqr_0_uniq; unfold Rsqr; lra). rewrite Z1, Z2, Z3 in C. lra. }
  pose proof (by_others _ _ _ _ _ _ _ _ _ (Q2R d1) (Q2R d2) (Q2R d3) Nu Nv ltac:(lra) NN) as B. cbv beta zeta in B.
  set (c := Q2R n1 * (Q2R u2 * Q2R v3 - Q2R u3 * Q2R v2) + _ + _) in B, C.
  set (cu := Q2R n1 * (Q2R u2 * Q2R d3 - Q2R u3 * Q2R d2) + _ + _) in B, Cu.
  set (cv := Q2R n1 * (Q2R d2 * Q2R v3 - Q2R d3 * Q2R v2) + _ + _) in B, Cv. destruct B as (B1 & B2 & B3).
  (* c d = cv u + cu v *)
  assert (D : forall t, c * (real [d1; d2; d3] .* t) = cv * (real [u1; u2; u3] .* t) + cu * (real [v1; v2; v3]
    .* t)).
  { unfold real. intros [|t1 [|t2 [|t3 t]]]; cbn [map Rows.dot]; rewrite ?Rmult_0_r.
    - ring.
    - transitivity (c * Q2R d1 * t1); [ring|]. rewrite B1. ring.
    - transitivity (c * Q2R d1 * t1 + c * Q2R d2 * t2); [ring|]. rewrite B1, B2. ring.
    - transitivity (c * Q2R d1 * t1 + c * Q2R d2 * t2 + c * Q2R d3 * t3); [ring|]. rewrite B1, B2, B3. ring. }
  destruct (Rle_dec (al * cu) (be * cv)) as [H|H].
  - exists [[d1; d2; d3]; [v1; v2; v3]]. split; [cbn; auto|]. split; [exact P|].
    apply (two_sides (al * c / cv) (be - al * cu / cv)).
    + apply Rmult_le_pos; [nra|]. left. now apply Rinv_0_lt_compat.
    + apply Rmult_le_reg_r with cv; [exact Cv|]. field_simplify; lra.
    + intros t. rewrite E. apply Rmult_eq_reg_r with cv; [|lra]. field_simplify; [|lra].
      specialize (D t). replace (al * c * (real [d1; d2; d3] .* t)) with (al * (c * (real [d1; d2; d3] .* t)))
        by ring.
      rewrite D. ring.
  - exists [[u1; u2; u3]; [d1; d2; d3]]. split; [cbn; auto|]. split; [exact P|].
    apply (two_sides (al - be * cv / cu) (be * c / cu)).
    + apply Rmult_le_reg_r with cu; [exact Cu|]. field_simplify; lra.
    + apply Rmult_le_pos; [nra|]. left. now apply Rinv_0_lt_compat.
    + intros t. rewrite E. apply Rmult_eq_reg_r with cu; [|lra]. field_simplify; [|lra].
      specialize (D t). replace (be * c * (real [d1; d2; d3] .* t)) with (be * (c * (real [d1; d2; d3] .* t)))
        by ring.
      rewrite D. ring.
Qed.

(* One of the children is about the slip, whatever it is. *)
Lemma children_cover x r a k f d them : is_rigid x r -> known a k r f -> slip_children x (sides k) d = inl them ->
  exists ss, In ss them /\ sides_true ss r a.
Proof.
  intros X (_ & _ & K) H. unfold slip_children in H.
  assert (Space : (if forallb is_zero d || negb (is_zero (inner (r_normal x) d)) || negb (good_sides x d (cross
    (r_normal x) d))
      then inr "class-slip"%string
      else match sides k with
        | Some [u; v] =>
            if negb (Qle_bool (inner (r_normal x) (cross u d)) 0) && negb (Qle_bool (inner (r_normal x) (cross
              d v)) 0) &&
               good_sides x u v
            then inl [[u; d]; [d; v]] else inr "class-slip"%string
        | _ =>
            let e := cross (r_normal x) d in
            inl [[]; [d; e]; [e; opposite d]; [opposite d; opposite e]; [opposite e; d]]
        end) = inl them -> exists ss, In ss them /\ sides_true ss r a).
  { clear H. intros H. destruct (_ || _ || _) eqn:B in H; [discriminate|]. apply orb_false_iff in B as [B Gd].
    apply orb_false_iff in B as [_ Nd]. apply negb_false_iff in Nd, Gd.
    assert (First : inl [[]; [d; cross (r_normal x) d]; [cross (r_normal x) d; opposite d];
        [opposite d; opposite (cross (r_normal x) d)]; [opposite (cross (r_normal x) d); d]] = @inl _ string them ->
      exists ss, In ss them /\ sides_true ss r a) by (intros E; injection E as <-; now apply (first_children x)).
    destruct (sides k) as [[|u [|v [|? ?]]]|]; try (now apply First).
    destruct (_ && _ && _) eqn:C in H; [|discriminate]. injection H as <-. rewrite !andb_true_iff,
      !negb_true_iff in C.
    destruct C as [[Cu Cv] G]. now apply (next_children x). }
  destruct (r_slips x) as [|f0 [|? ?]] eqn:E; try (now apply Space).
  injection H as <-. now apply (plane_children x r a f0).
Qed.

End Children.

(* ---- Proofs: trees ---- *)

Section Walk.
Open Scope R_scope.

Notation "u .* v" := (Rows.dot u v) (at level 40).

Variable mass : matrix.
Variable w : vector.
Hypothesis mass_symmetric : forall u v, u .* times (map real mass) v = v .* times (map real mass) u.

(* A row with its force. *)
Definition pressed := (Rows.row * Rows.force)%type.

Definition true_of (a : list R) (p : rigid * knowledge) (q : pressed) : Prop :=
  is_rigid (fst p) (fst q) /\ rigid_obeys a (fst q) (snd q) /\ known a (snd p) (fst q) (snd q).

Definition works_of (qs : list pressed) (y : list R) : R := Rows.works (map fst qs) (map snd qs) y.

(* No acceleration along which the load does work is at home in a cell. *)
Definition holds_in (c : cell) : Prop := forall a qs, Forall2 (true_of a) c qs ->
  (forall y, y .* times (map real mass) a = real w .* y + works_of qs y) -> 0 < real w .* a -> False.

Lemma factor_is u v c : factor u v = Some c -> Q2R c <> 0 /\ real v = Rows.scaled (Q2R c) (real u).
Proof.
  unfold factor. set (q := (inner u v / inner u u)%Q). destruct (negb (is_zero q) && _) eqn:H; [|discriminate].
  intros E. injection E as <-. apply andb_true_iff in H as [Z S]. apply negb_true_iff in Z. split.
  - intros E. rewrite <- Q2R_0 in E. apply eqR_Qeq, Qeq_eq_bool in E. unfold is_zero in Z. congruence.
  - apply same_vectors_real in S. rewrite S. unfold real, Rows.scaled. rewrite !map_map. apply map_ext. intros
      x. apply Q2R_mult.
Qed.

Lemma positive_multiple_is u v : is_positive_multiple u v = true ->
  exists c, 0 < c /\ forall t, real v .* t = c * (real u .* t).
Proof.
  unfold is_positive_multiple. destruct (factor u v) as [c|] eqn:F; [|discriminate]. intros P.
  apply factor_is in F as [Z E]. apply Qle_bool_R in P. rewrite Q2R_0 in P. exists (Q2R c). split; [lra|].
  intros t. now rewrite E, Rows.dot_scaled.
Qed.

(* What is said of a contact is true of all that it is said of. *)
Lemma touch_true a x it p q : true_of a p q ->
  (forall c, 0 < c -> (forall t, real (r_N (fst p)) .* t = c * (real (r_N x) .* t)) ->
     if (it : bool) then Rows.N (fst q) .* a = 0 else fst (snd q) = 0) ->
  true_of a (with_touch x it p) q.
Proof.
  intros Tr H. assert (Tr' := Tr). destruct Tr' as (X & O & T & A & S). unfold with_touch.
  destruct (is_positive_multiple _ _) eqn:M; [|exact Tr].
  apply positive_multiple_is in M as (c & C & E). specialize (H c C E). split; [exact X|]. split; [exact O|].
  cbn [fst snd]. unfold known. cbn [touches sides]. split; [|split; [|exact S]]; intros Eq; injection Eq as ->;
    exact H.
Qed.

Lemma slip_factor_is x y r r' c a : is_rigid x r -> is_rigid y r' -> slip_factor x y = Some c ->
  Q2R c <> 0 /\ Rows.slip r' a = Rows.scaled (Q2R c) (Rows.slip r a).
Proof.
  intros X Y H. unfold slip_factor in H. rewrite (is_r_slips _ _ X), (is_r_slips _ _ Y).
  assert (Same : (if same_matrices (r_slips x) (r_slips y) && is_positive_multiple (r_normal x) (r_normal y)
    then Some 1%Q
    else None) = Some c -> Q2R c <> 0 /\ map (fun f => real f .* a) (r_slips y) =
      Rows.scaled (Q2R c) (map (fun f => real f .* a) (r_slips x))).
  { clear H. destruct (_ && _) eqn:S; [|discriminate]. intros H. injection H as <-. apply andb_true_iff in S as
      [S _].
    apply same_matrices_real in S. split; [rewrite Q2R_1; lra|].
    transitivity (map (fun f => f .* a) (map real (r_slips y))); [now rewrite map_map|]. rewrite <- S, map_map.
    unfold Rows.scaled. rewrite map_map. apply map_ext. intros f. rewrite Q2R_1. ring. }
  destruct (r_slips x) as [|s [|? ?]]; try (now apply Same). destruct (r_slips y) as [|t [|? ?]]; try (now
    apply Same).
  apply factor_is in H as [Z E]. split; [exact Z|]. cbn. now rewrite E, Rows.dot_scaled.
Qed.

Lemma sides_turned x y r r' c ss a : is_rigid x r -> is_rigid y r' -> slip_factor x y = Some c ->
  sides_true ss r a -> sides_true (turned c ss) r' a.
Proof.
  intros X Y F S. destruct (slip_factor_is x y r r' c a X Y F) as [Z E].
  assert (Sz : Rows.size (Rows.weights r') (Rows.slip r' a) = Rabs (Q2R c) * Rows.size (Rows.weights r)
    (Rows.slip r a)).
  { rewrite (size_is y r' Y), (size_is x r X), E. rewrite Rows.dot_scaled, dot_sym, Rows.dot_scaled, <- Rmult_assoc.
    rewrite sqrt_mult_alt by apply Rle_0_sqr. f_equal. apply sqrt_Rsqr_abs. }
  unfold sides_true in *. destruct ss as [|s ss].
  - replace (turned c []) with (@nil vector) by (unfold turned; now destruct (Qle_bool 0 c)). rewrite Sz, S. ring.
  - destruct S as [P Co].
    assert (G : 0 < Rows.size (Rows.weights r') (Rows.slip r' a) /\ cone_of (turned c (s :: ss)) (Rows.slip r' a)).
    { split; [rewrite Sz; apply Rmult_lt_0_compat; [now apply Rabs_pos_lt|exact P]|]. rewrite E. now apply
        cone_turned. }
    unfold turned in *. destruct (Qle_bool 0 c); exact G.
Qed.

Lemma sides_known a x r ss p q : is_rigid x r -> sides_true ss r a -> true_of a p q -> true_of a (with_sides x
  ss p) q.
Proof.
  intros X S Tr. assert (Tr' := Tr). destruct Tr' as (Y & O & T & A & K). unfold with_sides.
  destruct (slip_factor x (fst p)) as [c|] eqn:F; [|exact Tr].
  split; [exact Y|]. split; [exact O|]. cbn [fst snd]. unfold known. cbn [touches sides]. split; [exact T|].
    split; [exact A|].
  pose proof (sides_turned x (fst p) r (fst q) c ss a X Y F S) as G. unfold sides_true in G.
  destruct (turned c ss); exact G.
Qed.

Lemma true_everywhere a c qs (f : rigid * knowledge -> rigid * knowledge) : Forall2 (true_of a) c qs ->
  (forall p q, true_of a p q -> true_of a (f p) q) -> Forall2 (true_of a) (map_all f c) qs.
Proof. intros F H. rewrite map_all_is. induction F; cbn; constructor; auto. Qed.

Lemma found_in {A} (l : list A) i x : numbered l i = Some x -> exists k, nth_error l k = Some x.
Proof. intros H. apply numbered_is in H as (k & _ & H). now exists k. Qed.

Lemma truth_at a c qs i p : Forall2 (true_of a) c qs -> numbered c i = Some p -> exists q, true_of a p q.
Proof. intros F H. apply found_in in H as (k & H). destruct (fits_at _ _ _ _ _ F H) as (q & _ & T). now exists
  q. Qed.

(* The multipliers do work on a that is not below 0. *)
Lemma normal_sum_is a c qs gs : Forall2 (true_of a) c qs -> forallb (normal_right c) gs = true ->
  forall before, 0 <= real before .* a -> 0 <= real (fold_left (fun sum ig => match numbered c (fst ig) with
    | Some (x, _) => plus_times sum (snd ig) (r_N x) | None => sum end) gs before) .* a.
Proof.
  intros F. induction gs as [|[i g] gs IH]; intros H before B; [exact B|]. cbn in H. apply andb_true_iff in H
    as [H1 H2].
  cbn [fold_left]. apply IH; [exact H2|]. unfold normal_right in H1. cbn [fst snd] in *.
  destruct (numbered c i) as [[x k]|] eqn:N; [|exact B]. rewrite dot_plus_times.
  destruct (truth_at a c qs i _ F N) as (q & X & O & T & _). cbn [fst snd] in *. rewrite <- (is_r_N _ _ X).
  destruct q as [r [n f]]. destruct O as ((_ & Na & _) & _). cbn [fst snd] in *.
  assert (G : 0 <= Q2R g * (Rows.N r .* a)).
  { destruct k as [[[|]|] ss]; cbn [touches] in *; try (apply Qle_bool_R in H1; rewrite Q2R_0 in H1; now apply
      Rmult_le_pos).
    rewrite (T eq_refl). lra. }
  lra.
Qed.

Lemma slip_sum_is a c qs hs : Forall2 (true_of a) c qs -> forallb (slip_right c) hs = true ->
  forall before, 0 <= real before .* a -> 0 <= real (fold_left (fun sum ih => match numbered c (fst ih) with
    | Some (x, _) => plus_times sum 1 (of_rows (snd ih) (r_slips x)) | None => sum end) hs before) .* a.
Proof.
  intros F. induction hs as [|[i h] hs IH]; intros H before B; [exact B|]. cbn in H. apply andb_true_iff in H
    as [H1 H2].
  cbn [fold_left]. apply IH; [exact H2|]. unfold slip_right in H1. cbn [fst snd] in *.
  destruct (numbered c i) as [[x k]|] eqn:N; [|exact B]. rewrite dot_plus_times, Q2R_1, dot_of_rows.
  destruct (truth_at a c qs i _ F N) as (q & X & _ & _ & _ & K). cbn [fst snd] in *.
  assert (Sl : times (map real (r_slips x)) a = Rows.slip (fst q) a).
  { rewrite (is_r_slips _ _ X). unfold times. now rewrite map_map. }
  rewrite Sl. destruct k as [t [ss|]]; [|discriminate]. apply andb_true_iff in H1 as [_ H1]. cbn [sides] in K.
  assert (G : 0 <= real h .* Rows.slip (fst q) a); [|lra]. rewrite dot_sym.
  destruct ss as [|s0 ss0].
  - rewrite (size_is x _ X) in K. rewrite dot_self_zero; [lra|].
    apply sqrt_eq_0; [apply dot_nonneg|exact K].
  - set (ss := s0 :: ss0) in *. destruct K as [_ (cs & L & P & E)]. rewrite E. clear E N. clearbody ss. rewrite
      forallb_forall in H1.
    revert cs L P. induction ss as [|s ss IHs]; intros [|z cs] L P; try discriminate; cbn; [lra|].
    assert (0 <= z * (real s .* real h)).
    { apply Rmult_le_pos; [exact (Forall_inv P)|]. specialize (H1 s (or_introl eq_refl)). apply Qle_bool_R in H1.
      rewrite Q2R_0, inner_is, dot_sym in H1. exact H1. }
    specialize (IHs (fun x0 Hx => H1 x0 (or_intror Hx)) cs ltac:(now injection L) (Forall_inv_tail P)). lra.
Qed.

(* All forces together do work on y. *)
Lemma works_nonneg a c qs y : Forall2 (true_of a) c qs ->
  forallb (fun p => match touches (snd p) with Some false => true | _ => resists_against (fst p) y (sides (snd
    p)) end) c = true ->
  0 <= works_of qs (real y).
Proof.
  intros F. unfold works_of. induction F as [|p [r [n g]] c qs (X & O & K) F IH]; intros H; cbn; [lra|].
  cbn in H. apply andb_true_iff in H as [H1 H2]. specialize (IH H2). cbn [fst snd] in *.
  assert (0 <= Rows.work r (n, g) (real y)); [|lra].
  apply (known_does_work (fst p) r X a n g O (snd p)); [exact K|].
  destruct (touches (snd p)) as [[|]|]; auto.
Qed.

(* In a leaf that holds nothing is at home, *)
Lemma leaf_holds c t y gs hs : rigid_leaf mass w c t y gs hs = true -> holds_in c.
Proof.
  unfold rigid_leaf. rewrite !andb_true_iff. intros [[[[[[[[T Yw] NZ] _] _] Gr] Hr] Re] Sum] a qs F Newton W.
  apply Qle_bool_R in T, Yw. rewrite Q2R_0 in T, Yw.
  pose proof (works_nonneg a c qs y F Re) as Wo.
  assert (Zero : forall v, forallb is_zero v = true -> forall s, real v .* s = 0).
  { clear. induction v as [|q v IH]; intros H [|t1 s]; cbn in *; try reflexivity. apply andb_true_iff in H as
      [H1 H2].
    apply is_zero_real in H1. unfold real in IH. rewrite H1, IH by exact H2. ring. }
  pose proof (Zero _ Sum a) as Z. rewrite !dot_plus_times, Q2R_1 in Z. cbn [real map Rows.dot] in Z.
  assert (My : real (map (fun r => inner r y) mass) .* a = real w .* real y + works_of qs (real y)).
  { rewrite <- Newton, mass_symmetric, dot_sym. f_equal. unfold times, real. rewrite !map_map. apply map_ext.
    intros r. apply inner_is. }
  unfold real in Z, My at 1. unfold real in My at 1.
  pose proof (normal_sum_is a c qs gs F Gr [] (Rle_refl 0)) as Ng. pose proof (slip_sum_is a c qs hs F Hr []
    (Rle_refl 0)) as Nh.
  fold (normal_sum c gs) in Ng. fold (slip_sum c hs) in Nh.
  rewrite inner_is, dot_sym in Yw. unfold real in *.
  assert (TW : 0 <= Q2R t * (map Q2R w .* a)) by (apply Rmult_le_pos; lra).
  apply negb_true_iff, andb_false_iff in NZ as [NZ|NZ].
  - assert (Q2R t <> 0).
    { intros E. rewrite <- Q2R_0 in E. apply eqR_Qeq, Qeq_eq_bool in E. unfold is_zero in NZ. congruence. }
    assert (0 < Q2R t * (map Q2R w .* a)) by (apply Rmult_lt_0_compat; lra). lra.
  - assert (map Q2R w .* map Q2R y <> 0).
    { intros E. pose proof (inner_is y w) as I. unfold real in I. rewrite dot_sym, E, <- Q2R_0 in I.
      apply eqR_Qeq, Qeq_eq_bool in I. unfold is_zero in NZ. congruence. }
    lra.
Qed.

(* and what is at home in a cell is so in a child. *)
Lemma split_holds c n children : rigid_split mass w c n = inl children -> Forall holds_in children -> holds_in c.
Proof.
  intros H All a qs F Newton W. rewrite Forall_forall in All. destruct n as [i|i d|t y gs hs]; cbn
    [rigid_split] in H.
  - destruct (numbered c i) as [[x k]|] eqn:N; [|discriminate]. injection H as <-.
    destruct (truth_at a c qs i _ F N) as ([r [n f]] & X & ((N0 & Na & NN) & _) & _). cbn [fst snd] in *.
    destruct (Req_dec (Rows.N r .* a) 0) as [Z|Z].
    + refine (All _ (or_introl eq_refl) a qs _ Newton W). apply true_everywhere; [exact F|]. intros p q T.
      apply touch_true; [exact T|]. intros c0 C E. destruct T as (Y & _).
      rewrite (is_r_N _ _ Y), E, <- (is_r_N _ _ X), Z. ring.
    + refine (All _ (or_intror (or_introl eq_refl)) a qs _ Newton W). apply true_everywhere; [exact F|]. intros
        p q T.
      apply touch_true; [exact T|]. intros c0 C E. destruct T as (Y & O & _).
      destruct q as [r' [n' f']]. destruct O as ((_ & _ & NN') & _). cbn [fst snd] in *.
      rewrite (is_r_N _ _ Y), E, <- (is_r_N _ _ X) in NN'.
      assert (c0 * (Rows.N r .* a) <> 0) by (apply Rmult_integral_contrapositive_currified; lra).
      apply Rmult_integral in NN' as [NN'|NN']; [exact NN'|contradiction].
  - destruct (numbered c i) as [[x k]|] eqn:N; [|discriminate].
    destruct (slip_children x (sides k) d) as [them|] eqn:Sc; [|discriminate]. injection H as <-.
    destruct (truth_at a c qs i _ F N) as (q & X & _ & K). cbn [fst snd] in *.
    destruct (children_cover x (fst q) a k (snd q) d them X K Sc) as (ss & Hs & S).
    refine (All _ (in_map _ _ _ Hs) a qs _ Newton W). apply true_everywhere; [exact F|]. intros p q' T.
    now apply sides_known with (fst q).
  - destruct (rigid_leaf mass w c t y gs hs) eqn:L; [|discriminate]. now apply (leaf_holds c t y gs hs L a qs).
Qed.

Theorem tree_holds most nodes todo number : rigid_walk most mass w nodes todo number = None ->
  Forall (fun cd => holds_in (fst cd)) todo.
Proof.
  revert todo number. induction nodes as [|n nodes IH]; intros [|[c depth] todo] number H; cbn [rigid_walk] in H;
    try discriminate; [constructor|].
  destruct (Z.ltb most depth); [discriminate|]. destruct (rigid_split mass w c n) as [children|] eqn:S;
    [|discriminate].
  apply IH, Forall_app in H as [H1 H2]. constructor; [|exact H2]. cbn.
  apply (split_holds c n children S). now rewrite Forall_map in H1.
Qed.

End Walk.
