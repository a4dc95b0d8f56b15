(* SPDX-License-Identifier: MIT *)
(* The class of rigid contacts (FORMAT.md section 13): the rules, but those of trees (Rigid.v).  `class_holds`:
   where they hold, the class is what the certificate says. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Lists Question Cone Meaning Numbers Root Box Terms Leaf Tree RowLimits Degree Matrix
  Frame.
From Proved Require Import ByDegree RigidModel Rigid RigidRows.
From Proved Require Rows Model SpaceModel.
Import ListNotations.

Section Rules.
Open Scope Q_scope.

Definition is_positive (q : Q) : bool := negb (Qle_bool q 0).

(* M by its rows; None if the numbers are no inertia. *)
Definition masses (numbers : list Q) : option matrix :=
  match numbers with
  | [x; y; g] =>
      if is_positive g then Some [[1; 0; - y]; [0; 1; x]; [- y; x; x * x + y * y + g]] else None
  | [p; q; r; xx; yy; zz; xy; xz; yz] =>
      if is_positive xx && is_positive (xx * yy - xy * xy) &&
         is_positive (zz * (xx * yy - xy * xy) - xx * (yz * yz) - yy * (xz * xz) + (2 # 1) * xy * xz * yz)
      then Some [[1; 0; 0; 0; r; - q]; [0; 1; 0; - r; 0; p]; [0; 0; 1; q; - p; 0];
                 [0; - r; q; q * q + r * r + xx; - (p * q) + xy; - (p * r) + xz];
                 [r; 0; - p; - (p * q) + xy; p * p + r * r + yy; - (q * r) + yz];
                 [- q; p; 0; - (p * r) + xz; - (q * r) + yz; p * p + q * q + zz]]
      else None
  | _ => None
  end.

(* A contact without uncertainty, as it is to rigid contacts. *)
Definition rigid_of (row : row) : option rigid :=
  let b := box row in
  match box_forms b (map low (box_geometry b)) with
  | n :: ss =>
      if forallb certain (box_geometry b) && certain (box_friction b) && Qle_bool 0 (low (box_friction b)) &&
         Qle_bool 0 (box_square b) && same_vectors (box_weights b) (map (fun _ => 1) ss)
      then Some (Rigid n ss (low (box_friction b)) (box_square b) (box_normal b)) else None
  | [] => None
  end.

(* class-force, and the force of each contact; None if it does not hold. *)
Definition force_right (x : rigid) (n : Q) (f : vector) : bool :=
  Qle_bool 0 n && Nat.eqb (List.length f) (List.length (r_slips x)) &&
  (match r_slips x with [_] => true | _ => is_zero (inner f (r_normal x)) end) &&
  Qle_bool (inner f f) (r_friction x * r_friction x * r_square x * (n * n)).

Definition pressing := (rigid * (Q * vector))%type.

Fixpoint pressing_contacts (xs : list rigid) (i : Z) (them : stated_forces) (before : list pressing)
    : option (list pressing) :=
  match xs with
  | [] => match them with [] => Some (rev_append before []) | _ => None end
  | x :: xs' =>
      match them with
      | (j, (n, f)) :: rest =>
          if Z.eqb i j then
            if force_right x n f then pressing_contacts xs' (i + 1) rest ((x, (n, f)) :: before) else None
          else pressing_contacts xs' (i + 1) them ((x, (0, [])) :: before)
      | [] => pressing_contacts xs' (i + 1) [] ((x, (0, [])) :: before)
      end
  end.

(* class-balance *)
Definition force_total (w : vector) (ps : list pressing) : vector :=
  fold_left (fun sum p =>
    let '(x, (n, f)) := p in plus_times (plus_times sum n (r_N x)) 1 (of_rows f (r_slips x))) ps w.

Definition balanced (mass : matrix) (w a : vector) (ps : list pressing) : bool :=
  forallb is_zero (plus_times (force_total w ps) (-(1)) (map (fun r => inner r a) mass)).

(* class-motion *)
Definition moves_right (a : vector) (p : pressing) : bool :=
  let '(x, (n, f)) := p in
  let slip := slip_of x a in
  let power := inner f slip in
  Qle_bool 0 (inner (r_N x) a) && is_zero (n * inner (r_N x) a) && Qle_bool power 0 &&
  Qeq_bool (power * power) (r_friction x * r_friction x * r_square x * (n * n) * inner slip slip).

Definition forces_fail (mass : matrix) (w a : vector) (xs : list rigid) (them : stated_forces)
    : list pressing + string :=
  match pressing_contacts xs 0 them [] with
  | None => inr "class-force"%string
  | Some ps => if balanced mass w a ps then inl ps else inr "class-balance"%string
  end.

(* The rule that fails, and the node. *)
Definition class_fails (most_depth : Z) (mass : matrix) (w : vector) (xs : list rigid) (p : class_proof)
    : option (string * option nat) :=
  let still := map (fun _ => 0) mass in
  match p with
  | ByTwist y =>
      if is_positive (inner y w) && forallb (fun x => resists_all x y) xs then None else Some
        ("class-twist"%string, None)
  | ByTree rest nodes =>
      match forces_fail mass w still xs rest with
      | inr rule => Some (rule, None)
      | inl _ =>
          match rigid_walk most_depth mass w nodes [(map_all (fun x => (x, Knowledge None None)) xs, 0%Z)] 0 with
          | Some (rule, number) => Some (rule, Some number)
          | None => None
          end
      end
  | ByMotion rest a forces =>
      match forces_fail mass w still xs rest with
      | inr rule => Some (rule, None)
      | inl _ =>
          match forces_fail mass w a xs forces with
          | inr rule => Some (rule, None)
          | inl ps =>
              if negb (forallb is_zero a) && Nat.eqb (List.length a) (List.length mass) && forallb (moves_right
                a) ps
              then None else Some ("class-motion"%string, None)
          end
      end
  end.

End Rules.

(* ---- Proofs ---- *)

Section Proofs.
Open Scope R_scope.

Notation "u .* v" := (Rows.dot u v) (at level 40).

(* It is what its row is. *)
Lemma rigid_of_is row r x : fits row r -> rigid_of row = Some x -> is_rigid x r.
Proof.
  intros [_ (p & F & mu & t & I)] H. unfold rigid_of in H. set (b := box row) in *.
  destruct (box_forms b (map low (box_geometry b))) as [|n ss] eqn:Fo; [discriminate|].
  destruct (_ && _) eqn:C in H; [|discriminate]. injection H as <-. rewrite !andb_true_iff in C.
  destruct C as [[[[Cg Cf] Mu] Sq] We].
  assert (P : p = map Q2R (map low (box_geometry b))).
  { pose proof (in_geometry _ _ _ _ _ _ I) as G. clear - G Cg. induction G as [|i q is p W G IH]; cbn in *;
      [reflexivity|].
    apply andb_true_iff in Cg as [C1 C2]. f_equal; [now apply certain_within|now apply IH]. }
  pose proof (is_forms _ _ _ _ _ _ I) as E. rewrite P, (forms_rational _ _ _ _ _ _ I), Fo in E. cbn in E.
  injection E as EN ES. apply Qle_bool_R in Mu, Sq. rewrite Q2R_0 in Mu, Sq.
  constructor; cbn [r_N r_slips r_friction r_square]; try assumption.
  - intros y. now rewrite EN.
  - intros y. unfold Rows.slip. now rewrite ES, map_map.
  - rewrite (is_rho _ _ _ _ _ _ I). f_equal. now apply certain_within, I.
  - rewrite (is_weights _ _ _ _ _ _ I). apply same_vectors_real in We. unfold real in We. rewrite We, map_map.
    apply map_ext. intros _. apply Q2R_1.
Qed.

Lemma all_rigid rows rs xs : all_some rigid_of rows = Some xs -> Forall2 fits rows rs -> Forall2 is_rigid xs rs.
Proof.
  intros H F. apply all_some_is in H. revert rs F. induction H as [|row x rows xs E H IH]; intros rs F;
    inversion F; subst;
    constructor; [now apply rigid_of_is with row|now apply IH].
Qed.

Definition force_of (p : pressing) : Rows.force := (Q2R (fst (snd p)), real (snd (snd p))).

Definition right (p : pressing) : Prop :=
  0 <= Q2R (fst (snd p)) /\ (List.length (snd (snd p)) <= List.length (r_slips (fst p)))%nat /\
  real (snd (snd p)) .* real (snd (snd p)) <=
    Q2R (r_friction (fst p)) * Q2R (r_friction (fst p)) * Q2R (r_square (fst p)) * (Q2R (fst (snd p)) * Q2R
      (fst (snd p))).

(* Forces that are in their cones. *)
Lemma pressing_right xs i them before ps : pressing_contacts xs i them before = Some ps ->
  exists rest, ps = rev before ++ rest /\ map fst rest = xs /\ Forall right rest.
Proof.
  revert i them before. induction xs as [|x xs IH]; intros i them before H; cbn in H.
  - destruct them; [|discriminate]. injection H as <-. rewrite rev_append_rev. exists []. now repeat split.
  - assert (Go : forall n f rest', right (x, (n, f)) -> pressing_contacts xs (i + 1) rest' ((x, (n, f)) ::
      before) = Some ps ->
      exists rest, ps = rev before ++ rest /\ map fst rest = x :: xs /\ Forall right rest).
    { intros n f rest' R E. destruct (IH _ _ _ E) as (rest & -> & M & A). exists ((x, (n, f)) :: rest). split.
      - cbn. now rewrite <- app_assoc.
      - split; [cbn; congruence|now constructor]. }
    assert (None_ : right (x, (0%Q, []))).
    { unfold right; cbn. rewrite Q2R_0. repeat split; [lra|lia|lra]. }
    destruct them as [|[j [n f]] rest']; [now apply (Go _ _ _ None_) in H|].
    destruct (Z.eqb i j); [|now apply (Go _ _ _ None_) in H].
    destruct (force_right x n f) eqn:Fr; [|discriminate]. apply (Go n f rest'); [|exact H].
    unfold force_right in Fr. rewrite !andb_true_iff in Fr. destruct Fr as [[[N L] _] C]. apply Qle_bool_R in N, C.
    apply Nat.eqb_eq in L. rewrite Q2R_0 in N. rewrite !Q2R_mult, inner_is in C. unfold right; cbn [fst snd].
      repeat split; [exact N|lia|exact C].
Qed.

(* The sum is that of works, *)
Lemma total_is w ps rs y : Forall2 is_rigid (map fst ps) rs -> Forall right ps ->
  real (force_total w ps) .* y = real w .* y + Rows.works rs (map force_of ps) y.
Proof.
  intros F. revert w. remember (map fst ps) as xs eqn:E. revert ps E. induction F as [|x r xs rs X F IH];
    intros ps E w R.
  - destruct ps; [|discriminate]. cbn. unfold real. ring.
  - destruct ps as [|[x' [n f]] ps]; [discriminate|]. injection E as -> E. cbn [force_total fold_left].
    change (fold_left _ ps ?v) with (force_total v ps). rewrite (IH ps E _ (Forall_inv_tail R)).
    rewrite !dot_plus_times, Q2R_1, dot_of_rows. cbn [map Rows.works]. unfold Rows.work, force_of. cbn [fst snd].
    rewrite (is_r_N _ _ X). destruct (Forall_inv R) as (_ & L & _). cbn [fst snd] in L.
    rewrite (is_r_weights _ _ X), product_ones by (unfold real; now rewrite map_length).
    rewrite (is_r_slips _ _ X). unfold times. rewrite map_map. ring.
Qed.

Lemma zero_dot v s : forallb is_zero v = true -> real v .* s = 0.
Proof.
  revert s. induction v as [|q v IH]; intros [|t s] H; cbn in *; try reflexivity. apply andb_true_iff in H as
    [H1 H2].
  apply is_zero_real in H1. unfold real in IH. rewrite H1, IH by exact H2. ring.
Qed.

(* and so is Newton's law. *)
Lemma balance_is mass w a ps rs y : balanced mass w a ps = true -> Forall2 is_rigid (map fst ps) rs -> Forall
  right ps ->
  y .* times (map real mass) (real a) = real w .* y + Rows.works rs (map force_of ps) y.
Proof.
  intros H F R. pose proof (zero_dot _ y H) as Z. rewrite dot_plus_times, (total_is w ps rs y F R) in Z.
  assert (E : real (map (fun r => inner r a) mass) .* y = y .* times (map real mass) (real a)).
  { rewrite dot_sym. f_equal. unfold times, real. rewrite !map_map. apply map_ext. intros r. apply inner_is. }
  rewrite E in Z. replace (Q2R (-(1))) with (-1) in Z by (unfold Q2R; cbn; lra). lra.
Qed.

(* The cone. *)
Lemma cone_is x r p : is_rigid x r -> fst p = x -> right p ->
  Rows.size (Rows.weights r) (real (snd (snd p))) <= Rows.rho r * Q2R (fst (snd p)).
Proof.
  intros X E (N & L & C). rewrite E in *. unfold Rows.size. rewrite (is_r_weights _ _ X), product_ones
    by (unfold real; now rewrite map_length). rewrite (is_r_rho _ _ X).
  eapply Rle_trans; [apply sqrt_le_1_alt; exact C|].
  set (m := Q2R (r_friction x)) in *. set (q := Q2R (r_square x)) in *. set (n := Q2R (fst (snd p))) in *.
  pose proof (r_friction_nonneg _ _ X) as M. pose proof (r_square_nonneg _ _ X) as Q. fold m in M. fold q in Q.
  replace (m * m * q * (n * n)) with (m * n * (m * n) * q) by ring.
  rewrite sqrt_mult_alt by apply Rle_0_sqr. rewrite sqrt_square by (apply Rmult_le_pos; assumption). right. ring.
Qed.

(* At rest nothing slips. *)
Lemma slip_still r n :
  Rows.N r .* repeat 0 n = 0 /\ (forall g, Rows.product (Rows.weights r) g (Rows.slip r (repeat 0 n)) = 0) /\
  Rows.size (Rows.weights r) (Rows.slip r (repeat 0 n)) = 0.
Proof.
  split; [apply dot_zeros|].
  assert (G : forall ws g, Rows.product ws g (Rows.slip r (repeat 0 n)) = 0).
  { unfold Rows.slip. induction (Rows.slips r) as [|f fs IH]; intros ws g; destruct ws, g; cbn; try reflexivity.
    rewrite dot_zeros, IH. ring. }
  split; [intros; apply G|]. unfold Rows.size. rewrite G. apply sqrt_0.
Qed.

(* Forces in their cones are a solution at rest, *)
Lemma rest_obeys ps rs n : Forall2 is_rigid (map fst ps) rs -> Forall right ps ->
  Forall2 (rigid_obeys (repeat 0 n)) rs (map force_of ps).
Proof.
  intros F. remember (map fst ps) as xs eqn:E. revert ps E. induction F as [|x r xs rs X F IH]; intros ps E R.
  - destruct ps; [constructor|discriminate].
  - destruct ps as [|p ps]; [discriminate|]. injection E as E1 E2. cbn. constructor; [|exact (IH ps E2
      (Forall_inv_tail R))].
    destruct (slip_still r n) as (Z1 & Z2 & Z3).
    unfold force_of, rigid_obeys. rewrite Z1, Z2, Z3. pose proof (Forall_inv R) as Rp.
    split; [split; [apply Rp|split; lra]|]. split; [now apply (cone_is x r p X)|ring].
Qed.

(* and with class-motion one of an acceleration. *)
Lemma motion_obeys a ps rs : Forall2 is_rigid (map fst ps) rs -> Forall right ps -> forallb (moves_right a) ps
  = true ->
  Forall2 (rigid_obeys (real a)) rs (map force_of ps).
Proof.
  intros F. remember (map fst ps) as xs eqn:E. revert ps E. induction F as [|x r xs rs X F IH]; intros ps E R M.
  - destruct ps; [constructor|discriminate].
  - destruct ps as [|[x' [n f]] ps]; [discriminate|]. injection E as -> E2. cbn in M. apply andb_true_iff in M
      as [M1 M2].
    cbn. constructor; [|exact (IH ps E2 (Forall_inv_tail R) M2)].
    rewrite !andb_true_iff in M1. destruct M1 as [[[Na NN] Po] Sq]. apply Qle_bool_R in Na, Po. apply
      is_zero_real in NN.
    apply Qeq_bool_eq, Qeq_eqR in Sq. rewrite !Q2R_mult in *. rewrite !inner_is, <- !(slip_of_is x' r X) in *.
    rewrite Q2R_0 in *. pose proof (Forall_inv R) as Rp.
    unfold force_of, rigid_obeys. cbn [fst snd]. rewrite (is_r_N _ _ X).
    split; [split; [apply Rp|split; assumption]|]. split; [now apply (cone_is x' r (x', (n, f)) X)|].
    destruct Rp as (N & L & _). cbn [fst snd] in N, L.
    rewrite (is_r_weights _ _ X), product_ones by (unfold real; now rewrite map_length).
    rewrite <- (is_r_weights _ _ X), (size_is x' r X), (is_r_rho _ _ X).
    set (s := Rows.slip r (real a)) in *. set (m := Q2R (r_friction x')) in *. set (q := Q2R (r_square x')) in *.
    pose proof (r_friction_nonneg _ _ X) as M. pose proof (r_square_nonneg _ _ X) as Q. fold m in M. fold q in Q.
    pose proof (dot_nonneg s) as S0. set (w := real f .* s) in *. set (n' := Q2R n) in *.
    (* w <= 0 and w^2 is the square of the other side *)
    assert (P : - w = m * sqrt q * n' * sqrt (s .* s)); [|lra].
    assert (P1 : 0 <= m * sqrt q * n' * sqrt (s .* s)).
    { apply Rmult_le_pos; [|apply sqrt_pos]. apply Rmult_le_pos; [|exact N]. apply Rmult_le_pos; [exact M|apply
        sqrt_pos]. }
    apply Rsqr_inj; [lra|exact P1|]. unfold Rsqr.
    replace (m * sqrt q * n' * sqrt (s .* s) * (m * sqrt q * n' * sqrt (s .* s)))
      with (m * m * (sqrt q * sqrt q) * (n' * n') * (sqrt (s .* s) * sqrt (s .* s))) by ring.
    rewrite !sqrt_sqrt by assumption. lra.
Qed.

(* What is known at first: nothing. *)
Lemma nothing_known a xs rs fs : Forall2 is_rigid xs rs -> Forall2 (rigid_obeys a) rs fs ->
  Forall2 (true_of a) (map_all (fun x => (x, Knowledge None None)) xs) (List.combine rs fs).
Proof.
  intros F. rewrite map_all_is. revert fs. induction F as [|x r xs rs X F IH]; intros fs O; inversion O; subst; cbn;
    constructor; [|now apply IH]. split; [exact X|]. split; [assumption|]. cbn. repeat split; discriminate.
Qed.

Lemma combined {A B} (P : A -> B -> Prop) l l' : Forall2 P l l' ->
  map fst (List.combine l l') = l /\ map snd (List.combine l l') = l'.
Proof. induction 1 as [|x y l l' _ _ [IH1 IH2]]; cbn; [auto|]. now rewrite IH1, IH2. Qed.

Variable mass : matrix.
Variable w : vector.
Variable sys : Rows.system.
Variable xs : list rigid.
Hypothesis xs_are : Forall2 is_rigid xs (Rows.rows sys).
Hypothesis w_is : Rows.wrench sys = real w.
Hypothesis mass_length : List.length mass = Rows.dimension sys.
Hypothesis mass_symmetric : forall u v, u .* times (map real mass) v = v .* times (map real mass) u.
Hypothesis mass_positive : forall a, List.length a = Rows.dimension sys -> a <> repeat 0 (Rows.dimension sys) ->
  0 < a .* times (map real mass) a.

Definition can_rows (a : list R) : Prop := exists fs, rigid_solution sys (map real mass) a fs.

Lemma still_is : real (map (fun _ => 0%Q) mass) = repeat 0 (Rows.dimension sys).
Proof. rewrite <- mass_length. clear. induction mass as [|r m IH]; cbn; [reflexivity|]. unfold real in IH. now
  rewrite IH, Q2R_0. Qed.

Lemma forces_can a them ps : forces_fail mass w a xs them = inl ps ->
  map fst ps = xs /\ Forall right ps /\ balanced mass w a ps = true.
Proof.
  unfold forces_fail. destruct (pressing_contacts xs 0 them []) as [ps'|] eqn:E; [|discriminate].
  destruct (balanced mass w a ps') eqn:B; [|discriminate]. intros H. injection H as <-.
  destruct (pressing_right _ _ _ _ _ E) as (rest & Er & M & R). cbn in Er. subst ps'. auto.
Qed.

Lemma rest_can them ps : forces_fail mass w (map (fun _ => 0%Q) mass) xs them = inl ps ->
  can_rows (repeat 0 (Rows.dimension sys)).
Proof.
  intros H. apply forces_can in H as (M & R & B). pose proof xs_are as F. rewrite <- M in F.
  exists (map force_of ps). split; [apply repeat_length|]. split; [now apply rest_obeys|].
  intros y. rewrite w_is, <- still_is. now apply balance_is.
Qed.

(* What an acceleration needs: the load does work along it. *)
Lemma load_works a fs : rigid_solution sys (map real mass) a fs -> a <> repeat 0 (Rows.dimension sys) -> 0 <
  real w .* a.
Proof.
  intros (L & O & B) N. pose proof (mass_positive a L N) as P. rewrite (B a), w_is in P.
  assert (W : Rows.works (Rows.rows sys) fs a <= 0); [|lra]. clear - O xs_are. revert fs O.
  induction xs_are as [|x r xs rs X F IH]; intros fs O; inversion O as [|? [n g] ? fs' Oc Os]; subst; cbn; [lra|].
  specialize (IH F fs' Os). destruct Oc as ((N0 & Na & NN) & C & D). unfold Rows.work. cbn [fst snd]. rewrite NN, D.
  pose proof (Rows.size_nonneg (Rows.weights r) (Rows.slip r a)). pose proof (rho_nonneg' x r X).
  assert (0 <= Rows.rho r * n * Rows.size (Rows.weights r) (Rows.slip r a))
    by (apply Rmult_le_pos; [apply Rmult_le_pos; assumption|assumption]). lra.
Qed.

Theorem class_holds most p : class_fails most mass w xs p = None ->
  is_of_class (class_of p) (repeat 0 (Rows.dimension sys)) can_rows.
Proof.
  intros H. unfold class_fails in H. destruct p as [y|rest nodes|rest a forces]; cbn [class_of is_of_class];
    unfold must_move, must_hold, is_open.
  - destruct (is_positive (inner y w) && _) eqn:C in H; [|discriminate]. apply andb_true_iff in C as [P A].
    unfold is_positive in P. apply negb_true_iff, positive_real in P. rewrite inner_is, dot_sym in P.
    intros (fs & _ & O & B). specialize (B (real y)).
    assert (Z : real y .* times (map real mass) (repeat 0 (Rows.dimension sys)) = 0).
    { rewrite dot_sym. unfold times. clear. generalize (real y). induction (map real mass) as [|r m IH]; intros
        [|t ys]; cbn;
        try reflexivity. rewrite dot_zeros, IH. ring. }
    rewrite Z, w_is in B. assert (W : 0 <= Rows.works (Rows.rows sys) fs (real y)); [|lra].
    clear - O A xs_are. revert fs O A. induction xs_are as [|x r xs rs X F IH]; intros fs O A;
      inversion O as [|? [n g] ? fs' Oc Os]; subst; cbn; [lra|]. cbn in A. apply andb_true_iff in A as [A1 A2].
    specialize (IH F fs' Os A2). pose proof (all_do_work x r X _ n g Oc y A1). lra.
  - destruct (forces_fail _ _ _ _ rest) as [ps|] eqn:Fr; [|discriminate].
    destruct (rigid_walk _ _ _ _ _ _) as [[? ?]|] eqn:W in H; [discriminate|].
    split; [now apply rest_can with rest ps|]. intros a (fs & S).
    destruct (list_eq_dec Req_EM_T a (repeat 0 (Rows.dimension sys))) as [E|N]; [exact E|]. exfalso.
    pose proof (load_works a fs S N) as Lw. destruct S as (L & O & B).
    pose proof (Forall_inv (tree_holds mass w mass_symmetric _ _ _ _ W)) as Hc. cbn in Hc.
    apply (Hc a (List.combine (Rows.rows sys) fs)); [now apply nothing_known| |exact Lw].
    destruct (combined _ _ _ O) as [E1 E2]. intros y. unfold works_of. rewrite E1, E2, <- w_is. apply B.
  - destruct (forces_fail _ _ _ _ rest) as [ps|] eqn:Fr; [|discriminate].
    destruct (forces_fail _ _ a _ forces) as [ps'|] eqn:Ff; [|discriminate].
    destruct (_ && _ && _) eqn:C in H; [|discriminate]. rewrite !andb_true_iff, negb_true_iff in C. destruct C
      as [[Na La] Mo].
    split; [now apply rest_can with rest ps|]. exists (real a). apply Nat.eqb_eq in La. split.
    + intros E. rewrite <- E in *. assert (Z : forallb is_zero a = true); [|congruence]. clear - E.
      revert E. generalize (Rows.dimension sys). induction a as [|q a IH]; intros [|k] E; cbn in *; try
        discriminate; [reflexivity|].
      injection E as E1 E2. apply andb_true_iff. split; [|now apply (IH k)].
      rewrite <- Q2R_0 in E1. now apply eqR_Qeq, Qeq_eq_bool in E1.
    + apply forces_can in Ff as (M & R & B). pose proof xs_are as F. rewrite <- M in F.
      exists (map force_of ps'). split; [unfold real; rewrite map_length; congruence|]. split; [now apply
        motion_obeys|].
      intros y. rewrite w_is. now apply balance_is.
Qed.

End Proofs.
