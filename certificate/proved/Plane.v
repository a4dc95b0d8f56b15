(* SPDX-License-Identifier: MIT *)
(* Planes of loads (FORMAT.md section 12): pieces, by points of one mode, and leaves that a piece holds.
   `piece_resisted`: what lies in a piece that is accepted is resisted; `plane_covered`: what is resisted lies in a
   piece.

   In trees s and t are two coordinates more of the motion, which no contact sees, and the load s u + t v is a wrench
   that is pushed with. *)
From Coq Require Import List Arith String ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Matrix Load Lists Question Cone Meaning Numbers Root Box Terms Leaf Walk Tree Witness.
From Proved Require Rows Degree Ways ByDegree Model.
Import ListNotations.

Section Checker.
Open Scope Z_scope.

(* ---- Which sums of multiples >= 0 of rays in R^3 a point is ---- *)

Definition cross_product (a b : form) : form :=
  match a, b with
  | [x; y; z], [x'; y'; z'] => [y * z' - z * y'; z * x' - x * z'; x * y' - y * x']
  | _, _ => []
  end.

Definition det (a b c : form) : Z := dot a (cross_product b c).

Fixpoint first_some {A B} (f : A -> option B) (l : list A) : option B :=
  match l with
  | [] => None
  | a :: l' => match f a with Some b => Some b | None => first_some f l' end
  end.

(* If the numbers are of the right signs. *)
Definition if_positive (factor : Z) (terms : list (nat * Z)) : option (Z * list (nat * Z)) :=
  if (0 <? factor) && forallb (fun t => 0 <=? snd t) terms then Some (factor, terms) else None.

(* By three rays, by two, and by one; they are given with their numbers. *)
Definition by_three (q : form) (a b c : nat * form) : option (Z * list (nat * Z)) :=
  let d := det (snd a) (snd b) (snd c) in
  let s := Z.sgn d in
  if_positive (s * d) [(fst a, s * det q (snd b) (snd c)); (fst b, s * det (snd a) q (snd c));
                     (fst c, s * det (snd a) (snd b) q)].

Definition by_two (q : form) (a b : nat * form) : option (Z * list (nat * Z)) :=
  let n := cross_product (snd a) (snd b) in
  if dot q n =? 0 then if_positive (dot n n) [(fst a, det n q (snd b)); (fst b, det n (snd a) q)] else None.

Definition by_one (q : form) (a : nat * form) : option (Z * list (nat * Z)) :=
  if all_zero (cross_product (snd a) q) then if_positive (dot (snd a) (snd a)) [(fst a, dot q (snd a))] else None.

Definition or_else {A} (a : option A) (b : Datatypes.unit -> option A) : option A := match a with Some _ => a | None => b tt end.

(* A ray with h > 0 may be in every sum of three: as much of it can be taken away as leaves a sum of two others. *)
Definition sum_found (rays : list ray) (q : form) : option (Z * list (nat * Z)) :=
  let them := List.combine (seq 0 (List.length rays)) (map coordinates rays) in
  let all_of {B} (f : nat * form -> option B) := first_some f them in
  if all_zero q then Some (1, [])
  else
    or_else (match find (fun a => match snd a with h :: _ => 0 <? h | [] => false end) them with
             | Some a => all_of (fun b => all_of (by_three q a b))
             | None => None
             end)
      (fun _ => or_else (all_of (fun a => all_of (by_two q a))) (fun _ => all_of (by_one q))).

(* The factor times q is a sum of multiples of rays, which are known by their numbers. *)
Definition sum_of_rays (rays : list ray) (terms : list (nat * Z)) : form :=
  fold_right (fun t s => match nth_error rays (fst t) with
                         | Some r => combine (snd t) (coordinates r) 1 s
                         | None => s
                         end) [] terms.

Definition reason_holds (rays : list ray) (x : form) (factor : Z) (terms : list (nat * Z)) :=
  (0 <? factor) && forallb (fun t => 0 <=? snd t) terms &&
  all_zero (combine factor x (-1) (sum_of_rays rays terms)).

Definition is_sum_of (rays : list ray) (q : form) : bool :=
  match sum_found rays q with Some (factor, terms) => reason_holds rays q factor terms | None => false end.

(* ---- Pieces ---- *)

(* h, s and t. *)
Definition homogeneous := (Q * Q * Q)%type.

(* (h, s, t) of a point. *)
Definition load_part (p : load_point) : homogeneous := ((if is_at p then 1 else 0)%Q, along_u p, along_v p).

Definition part_list (a : homogeneous) : list Q := let '(h, s, t) := a in [h; s; t].

Definition ray_of_part (a : homogeneous) : ray := Ray (map (to_integer (scaling_of (part_list a))) (part_list a)) [] 0.

(* (h, s, t) of a ray of a tree, where motions have so many coordinates without s and t. *)
Definition part_of_ray (n : nat) (x : form) : form := [nth 0 x 0; nth (2 + n) x 0; nth (3 + n) x 0].

Definition held_by (n : nat) (pieces : list (list ray)) (k : Z) (rays : list ray) : option string :=
  match numbered pieces k with
  | None => Some "held-piece"%string
  | Some piece =>
      if forallb (fun r => is_sum_of piece (part_of_ray n (coordinates r))) rays then None
      else Some "held-inside"%string
  end.

(* A contact whose preload does not grow. *)
Definition does_not_grow (b : cbox) : bool := is_zero (low (box_growth b)) && is_zero (high (box_growth b)).

(* The load s u + t v. *)
Definition load_in_plane (u v : vector) (s t : Q) : vector := plus_times (plus_times [] s u) t v.

Variable two_sided : bool.
Variable n : nat.
Variable rows : list row.
Variable w : list interval.
Variables u v : vector.

Definition point_of_plane (p : load_point) : list Q :=
  (if is_at p then 1 else 0)%Q :: 1%Q :: twist (load_witness p).

(* A witness under h w + s u + t v. *)
Definition check_load_point (p : load_point) : list state + string :=
  let x := point_of_plane p in
  check_point two_sided n rows (Load w (load_in_plane u v (along_u p) (along_v p)) nothing_added)
    (map (to_integer (scaling_of x)) x) (shares (load_witness p)).

(* The states of all points, in the order of contacts, or the rule that fails at a point. *)
Fixpoint point_states (points : list load_point) (number : nat) : list (list state) + string * nat :=
  match points with
  | [] => inl []
  | p :: points' =>
      match check_load_point p with
      | inr rule => inr (rule, number)
      | inl ss =>
          match point_states points' (S number) with
          | inl others => inl (rev_append ss [] :: others)
          | inr failure => inr failure
          end
      end
  end.

Fixpoint share_one_mode (rows : list row) (states : list (list state)) : bool :=
  match rows with
  | [] => true
  | _ :: rows' =>
      contact_mode (flat_map (fun ss => match ss with s :: _ => [s] | [] => [] end) states) &&
      share_one_mode rows' (map (@tl state) states)
  end.

Fixpoint pieces_fail (pieces : list (list load_point)) (number : nat) : option (string * place) :=
  match pieces with
  | [] => None
  | points :: pieces' =>
      match point_states points 0 with
      | inr (rule, k) => Some (rule, AtPiece number (Some k))
      | inl states =>
          if share_one_mode rows states then pieces_fail pieces' (S number)
          else Some ("piece-mode"%string, AtPiece number None)
      end
  end.

(* ---- The tree ---- *)

(* s and t are the last coordinates of motions. *)
Definition plane_node (a : node) : node :=
  match a with
  | Plane q => Plane (firstn n q ++ skipn (S n) q ++ [nth n q 0%Q])
  | _ => a
  end.

Definition plane_setting : setting :=
  make_setting (2 + n) rows (Load w (map (fun _ => 0%Q) u) nothing_added)
    (Pushing [] (map (fun p => repeat 0%Q (2 + n) ++ [fst p; snd p]) (List.combine u v))) None.

End Checker.

Section Sums.
Open Scope R_scope.

Notation real := (map Q2R).

(* What integer rays span, their parts do. *)
Lemma spanned_parts (points : list homogeneous) (h s t : R) :
  spans (map coordinates (map ray_of_part points)) (fun b => rdot b [h; s; t]) -> sum_of points h s t.
Proof.
  intros (ws & W & E).
  assert (G : forall h s t, (forall b, rdot b [h; s; t] = total b ws) -> sum_of points h s t).
  2:{ now apply G. }
  clear h s t E. induction W as [|[c r] ws [C In_r] W IH]; intros h s t E; cbn [fst snd] in *.
  - assert (Eh := E [1%Z]). assert (Es := E [0%Z; 1%Z]). assert (Et := E [0%Z; 0%Z; 1%Z]). cbn in Eh, Es, Et.
    replace h with 0 by lra. replace s with 0 by lra. replace t with 0 by lra. constructor.
  - rewrite map_map in In_r. apply in_map_iff in In_r as (((a & b) & e) & <- & In_p). cbn [ray_of_part coordinates part_list] in *.
    set (sc := scaling_of [a; b; e]) in *.
    assert (X : forall q, In q [a; b; e] -> Q2R q = Numbers.unit sc * IZR (to_integer sc q))
      by (intros; now apply to_integer_exact).
    pose proof (unit_positive [a; b; e]) as U. fold sc in U.
    set (k := c / Numbers.unit sc).
    assert (K : 0 <= k) by (apply Rmult_le_pos; [exact C|left; now apply Rinv_0_lt_compat]).
    assert (One : forall q, In q [a; b; e] -> k * Q2R q = c * IZR (to_integer sc q)).
    { intros q Hq. rewrite (X q Hq). unfold k. field. lra. }
    assert (Ea := One a ltac:(cbn; auto)). assert (Eb := One b ltac:(cbn; auto)). assert (Ee := One e ltac:(cbn; auto)).
    replace h with (k * Q2R a + (h - k * Q2R a)) by ring. replace s with (k * Q2R b + (s - k * Q2R b)) by ring.
    replace t with (k * Q2R e + (t - k * Q2R e)) by ring.
    apply one_more; [exact K|exact In_p|]. apply IH. intros f. specialize (E f). cbn [total map] in E.
    rewrite Ea, Eb, Ee. destruct f as [|x [|y [|z [|? f]]]]; cbn [rdot dot] in *; rewrite ?plus_IZR, ?mult_IZR in E; lra.
Qed.

Lemma sum_spanned rays terms :
  forallb (fun t => 0 <=? snd t)%Z terms = true ->
  spans (map coordinates rays) (fun f => IZR (dot f (sum_of_rays rays terms))).
Proof.
  induction terms as [|[i c] terms IH]; cbn.
  - intros _. eapply spans_same; [|apply spans_zero]. intros f; cbn. now rewrite dot_nil_r.
  - rewrite andb_true_iff. intros [Hc Ht]. specialize (IH Ht).
    destruct (nth_error rays i) as [r|] eqn:Hr; [|exact IH].
    eapply spans_same; [|apply spans_sum; [|exact IH]; apply spans_multiple with (s := IZR c);
      [apply IZR_le; now apply Z.leb_le|]; apply spans_ray; apply in_map;
      eapply nth_error_In; exact Hr].
    intros f; cbn. rewrite dot_combine, plus_IZR, !mult_IZR. fold (sum_of_rays rays terms). lra.
Qed.

Lemma reason_spans rays x factor terms : reason_holds rays x factor terms = true ->
  spans (map coordinates rays) (fun f => IZR (dot f x)).
Proof.
  unfold reason_holds. rewrite !andb_true_iff. intros [[Hf Ht] Hz].
  apply Z.ltb_lt in Hf. apply IZR_lt in Hf.
  apply spans_same with (fun f => / IZR factor * IZR (dot f (sum_of_rays rays terms)))%R.
  - intros f. pose proof (dot_all_zero f _ Hz) as E. rewrite dot_combine in E.
    assert (E' : (dot f (sum_of_rays rays terms) = factor * dot f x)%Z) by lia.
    rewrite E', mult_IZR. field. lra.
  - apply spans_multiple; [left; now apply Rinv_0_lt_compat|]. now apply sum_spanned.
Qed.

Lemma is_sum_of_spans rays q : is_sum_of rays q = true -> spans (map coordinates rays) (fun b => IZR (dot b q)).
Proof.
  unfold is_sum_of. destruct (sum_found rays q) as [[factor terms]|]; [|discriminate]. apply reason_spans.
Qed.

(* A form of (h, s, t), of points of a tree. *)
Definition lifted (n : nat) (b : form) : form := (nth 0 b 0 :: repeat 0 (S n) ++ [nth 1 b 0; nth 2 b 0])%Z.

Lemma dot_lifted n b x : dot (lifted n b) x = dot b (part_of_ray n x).
Proof.
  assert (G : forall m a c (x : form), dot (repeat 0 m ++ [a; c])%Z x = (a * nth m x 0 + c * nth (S m) x 0)%Z).
  { induction m as [|m IH]; intros a c y; cbn [repeat app].
    - destruct y as [|y0 [|y1 y]]; cbn; lia.
    - destruct y as [|y0 y]; [cbn; destruct m; cbn; lia|]. cbn [dot]. rewrite IH. cbn [nth]. lia. }
  unfold lifted, part_of_ray. destruct x as [|x0 x].
  - assert (Z : forall k, nth k (@nil Z) 0%Z = 0%Z) by (intros []; reflexivity). rewrite !Z.
    destruct b as [|? [|? [|? ?]]]; cbn; rewrite ?Cone.dot_nil_r; lia.
  - cbn [dot]. rewrite G. cbn [nth Nat.add]. destruct b as [|b0 [|b1 [|b2 b]]]; cbn; try lia;
      rewrite ?Cone.dot_nil_r; lia.
Qed.

Lemma rdot_lifted n b h l d s t : List.length d = n -> rdot (lifted n b) (h :: l :: d ++ [s; t]) = rdot b [h; s; t].
Proof.
  intros <-. assert (G : forall d a c, rdot (repeat 0 (List.length d) ++ [a; c])%Z (d ++ [s; t]) = IZR a * s + IZR c * t).
  { induction d0 as [|y d0 IH]; intros a c; cbn; [ring|]. rewrite IH. ring. }
  unfold lifted. cbn [rdot repeat app]. rewrite G. destruct b as [|b0 [|b1 [|b2 [|? b]]]]; cbn; ring.
Qed.

(* A solution whose leaf is held lies in the piece. *)
Lemma held_is n pieces k rays h l d s t : List.length d = n ->
  held_by n (map (map ray_of_part) pieces) k rays = None ->
  spans (map coordinates rays) (fun a => rdot a (h :: l :: d ++ [s; t])) -> Exists (fun p => sum_of p h s t) pieces.
Proof.
  intros L H Sp. unfold held_by in H. destruct (numbered _ k) as [piece|] eqn:N; [|discriminate].
  destruct (forallb _ rays) eqn:A; [|discriminate]. apply numbered_is in N as (j & -> & N).
  rewrite nth_error_map in N. destruct (nth_error pieces j) as [points|] eqn:P; [|discriminate]. injection N as <-.
  apply Exists_exists. exists points. split; [now apply nth_error_In with j|]. apply spanned_parts.
  apply spans_trans with (map (fun r => part_of_ray n (coordinates r)) rays).
  - intros q Hq. apply in_map_iff in Hq as (r & <- & Hr). rewrite forallb_forall in A. now apply is_sum_of_spans, A.
  - destruct Sp as (ws & W & E). exists (map (fun p => (fst p, part_of_ray n (snd p))) ws). split.
    + apply Forall_map. eapply Forall_impl; [|exact W]. intros [c r] [C In_r]. cbn in *. split; [exact C|].
      apply in_map_iff in In_r as (r' & <- & In_r). apply in_map_iff. now exists r'.
    + intros b. rewrite <- (rdot_lifted n b h l d s t L), E. clear. induction ws as [|[c r] ws IH]; [reflexivity|].
      cbn [total map fst snd]. now rewrite IH, dot_lifted.
Qed.

End Sums.

(* ---- Pieces are resisted ---- *)

Section Pieces.
Open Scope R_scope.

Notation real := (map Q2R).

Variable sys : Rows.system.
Variable ms : list mode.
Variables u v : list R.
Let n := Rows.dimension sys.

(* The modes of all contacts, at a point. *)
Inductive in_modes (d : list R) (h l : R) : list mode -> list Rows.row -> list Rows.force -> Prop :=
  | no_modes : in_modes d h l [] [] []
  | more_modes m r f ms rs fs : Rows.positive (Rows.weights r) -> 0 <= Rows.rho r -> v_sign m * v_sign m = 1 ->
      in_mode m r d h l f -> in_modes d h l ms rs fs -> in_modes d h l (m :: ms) (r :: rs) (f :: fs).

(* A point of these modes with the load part (h, s, t). *)
Definition balances (h s t : R) : Prop := exists d l fs,
  List.length d = n /\ Forall2 (Rows.obeys (Rows.normal sys) d h l) (Rows.rows sys) fs /\
  in_modes d h l ms (Rows.rows sys) fs /\
  forall y, h * Rows.dot (Rows.wrench sys) y + s * Rows.dot u y + t * Rows.dot v y + Rows.works (Rows.rows sys) fs y = 0.

Lemma balances_mix p h s t q h' s' t' : 0 <= p -> 0 <= q -> balances h s t -> balances h' s' t' ->
  balances (p * h + q * h') (p * s + q * s') (p * t + q * t').
Proof.
  intros P Q (d & l & fs & L & O & M & B) (d' & l' & fs' & L' & O' & M' & B').
  assert (Len : List.length d = List.length d') by congruence.
  assert (A : forall rs ms fs fs', Forall2 (Rows.obeys (Rows.normal sys) d h l) rs fs ->
    Forall2 (Rows.obeys (Rows.normal sys) d' h' l') rs fs' -> in_modes d h l ms rs fs -> in_modes d' h' l' ms rs fs' ->
    exists gs, Forall2 (Rows.obeys (Rows.normal sys) (mix p d q d') (p * h + q * h') (p * l + q * l')) rs gs /\
      in_modes (mix p d q d') (p * h + q * h') (p * l + q * l') ms rs gs /\
      forall y, Rows.works rs gs y = p * Rows.works rs fs y + q * Rows.works rs fs' y).
  { clear - P Q Len. intros rs ms fs fs' O O' M. revert fs' O'.
    induction M as [|m r f ms rs fs Wp Rh Sg I M IH]; intros fs' O' M'.
    - exists []. split; [constructor|]. split; [constructor|]. intros y. inversion O'; subst. cbn. ring.
    - inversion M' as [|? ? f' ? ? fs'' _ _ _ I' M'']; subst. inversion O; subst. inversion O'; subst.
      destruct (IH ltac:(assumption) fs'' ltac:(assumption) M'') as (gs & Og & Mg & Wg).
      exists (mix_force p f q f' :: gs). split; [|split].
      + constructor; [|exact Og]. apply obeys_mix; try assumption. now apply (in_mode_shares m).
      + constructor; try assumption. now apply in_mode_mix.
      + intros y. cbn [Rows.works]. rewrite Wg. unfold Rows.work, mix_force. cbn [fst snd]. rewrite product_mix. ring. }
  destruct (A _ _ _ _ O O' M M') as (gs & Og & Mg & Wg).
  exists (mix p d q d'), (p * l + q * l'), gs. split; [now rewrite mix_length|]. split; [exact Og|]. split; [exact Mg|].
  intros y. rewrite Wg. specialize (B y). specialize (B' y).
  set (a := Rows.dot (Rows.wrench sys) y) in *. set (b := Rows.dot u y) in *. set (c := Rows.dot v y) in *.
  set (k := Rows.works (Rows.rows sys) fs y) in *. set (k' := Rows.works (Rows.rows sys) fs' y) in *.
  replace ((p * h + q * h') * a + (p * s + q * s') * b + (p * t + q * t') * c + (p * k + q * k'))
    with (p * (h * a + s * b + t * c + k) + q * (h' * a + s' * b + t' * c + k')) by ring.
  rewrite B, B'. ring.
Qed.

Lemma sum_balances points h s t :
  (forall a b e, In (a, b, e) points -> balances (Q2R a) (Q2R b) (Q2R e)) ->
  sum_of points h s t -> balances h s t \/ (h = 0 /\ s = 0 /\ t = 0).
Proof.
  intros P S. induction S as [|c a b e h s t C I S [IH|(-> & -> & ->)]]; [right; auto| |].
  - left. pose proof (balances_mix c _ _ _ 1 _ _ _ C Rle_0_1 (P a b e I) IH) as B. now rewrite !Rmult_1_l in B.
  - left. pose proof (balances_mix c _ _ _ 0 _ _ _ C (Rle_refl 0) (P a b e I) (P a b e I)) as B.
    now rewrite !Rmult_0_l in B.
Qed.

(* The system under the load of s and t. *)
Definition loaded (w : list R) : Rows.system :=
  Rows.System (Rows.dimension sys) (Rows.rows sys) w (Rows.direction sys) (Rows.normal sys).

Lemma obeys_without_growth w d h l l' r f : Rows.growth r = 0 -> Rows.obeys w d h l r f -> Rows.obeys w d h l' r f.
Proof.
  intros G. unfold Rows.obeys. replace (Rows.v r d h l') with (Rows.v r d h l); [auto|].
  unfold Rows.v. rewrite G. ring.
Qed.

Lemma balances_resisted s t w : Forall (fun r => Rows.growth r = 0) (Rows.rows sys) ->
  (forall y, Rows.dot w y = Rows.dot (Rows.wrench sys) y + s * Rows.dot u y + t * Rows.dot v y) ->
  balances 1 s t -> Rows.stable_at (Rows.bounded None 1) (loaded w) 0.
Proof.
  intros G E (d & l & fs & L & O & _ & B). exists d, fs. split; [exact Logic.I|]. split; [exact L|]. split.
  - cbn [loaded Rows.normal Rows.rows]. clear - G O. induction O as [|r f rs fs Of O IH]; constructor.
    + apply obeys_without_growth with l; [exact (Forall_inv G)|exact Of].
    + exact (IH (Forall_inv_tail G)).
  - intros y. specialize (B y). unfold Rows.load. cbn [loaded Rows.wrench Rows.direction Rows.rows]. rewrite E. lra.
Qed.

End Pieces.

Section Points.
Open Scope R_scope.

Notation reals := (map IZR).

Variable two_sided : bool.
Variable rows : list row.
Variable w : list interval.
Variables u v : vector.
Variable sys : Rows.system.
Let n := Rows.dimension sys.
Hypothesis F : Forall2 fits rows (Rows.rows sys).
Hypothesis E : exact_rows rows = true.
Hypothesis certain_w : forallb certain w = true.
Hypothesis w_is : Rows.wrench sys = real (map low w).
Hypothesis w_within : Forall2 within w (Rows.wrench sys).
Hypothesis u_length : List.length u = List.length w.
Hypothesis v_length : List.length v = List.length w.
Hypothesis Law : Rows.normal sys = if two_sided then Model.bilateral else Model.unilateral.

Lemma load_in_plane_is s t y : Rows.dot (real (load_in_plane u v s t)) y =
  Q2R s * Rows.dot (real u) y + Q2R t * Rows.dot (real v) y.
Proof. unfold load_in_plane. rewrite !dot_plus_times. cbn. ring. Qed.

Lemma load_in_plane_length s t : List.length (load_in_plane u v s t) = List.length w.
Proof.
  unfold load_in_plane. rewrite !ByDegree.plus_times_length. cbn. lia.
Qed.

(* A point that is accepted: what it says in integers, times a factor. *)
Lemma accepted_load_point p ss : check_load_point two_sided n rows w u v p = inl ss ->
  exists h l ds ss' k, 0 < k /\ ss = rev ss' /\ all_states (h :: l :: ds) rows (Rows.rows sys) ss' /\
    List.length ds = n /\ k * IZR h = Q2R (fst (fst (load_part p))) /\ k * IZR l = 1 /\
    Forall2 (Rows.obeys (Rows.normal sys) (reals ds) (IZR h) (IZR l)) (Rows.rows sys) (forces rows ss') /\
    forall y, IZR h * Rows.dot (Rows.wrench sys) y + IZR l * (Q2R (along_u p) * Rows.dot (real u) y +
      Q2R (along_v p) * Rows.dot (real v) y) + Rows.works (Rows.rows sys) (forces rows ss') y = 0.
Proof.
  unfold check_load_point. intros C. set (qs := point_of_plane p) in *. set (sc := scaling_of qs) in *.
  assert (X : forall q, In q qs -> Numbers.unit sc * IZR (to_integer sc q) = Q2R q)
    by (intros; symmetry; now apply to_integer_exact).
  set (g := load_in_plane u v (along_u p) (along_v p)) in *.
  set (its := Rows.System n (Rows.rows sys) (Rows.wrench sys) (real g) (Rows.normal sys)).
  assert (Lo : exact_load (Load w g nothing_added) its).
  { constructor; cbn [load_box load_growth its Rows.wrench Rows.direction].
    - unfold one_load. cbn. now rewrite certain_w.
    - now apply box_is_load.
    - reflexivity.
    - unfold real. rewrite map_length. unfold g. rewrite load_in_plane_length. rewrite w_is. unfold real.
      now rewrite !map_length. }
  unfold qs, point_of_plane in C. cbn [map] in C.
  destruct (point_is_equilibrium two_sided rows _ its _ _ _ _ ss F E Lo Law C) as (ss' & Er & A & (L & O & B)).
  eexists _, _, _, ss', (Numbers.unit sc). split; [apply unit_positive|]. split; [exact Er|]. split; [exact A|].
  split; [|split; [|split; [|split; [exact O|]]]].
  - rewrite map_length in L. exact L.
  - rewrite X by (cbn; auto). reflexivity.
  - rewrite X by (cbn; auto). apply Q2R_1.
  - intros y. specialize (B y). unfold Rows.load in B. cbn [its Rows.wrench Rows.direction Rows.rows] in B.
    unfold g in B. rewrite load_in_plane_is in B. exact B.
Qed.

(* States that share a mode: it, and that all are in it. *)
Lemma one_mode_of states rws rs : Forall2 fits rws rs -> exact_rows rws = true -> share_one_mode rws states = true ->
  Forall (fun ss => exists h l ds, all_states (h :: l :: ds) rws rs ss) states ->
  exists ms, forall h l ds ss, In ss states -> all_states (h :: l :: ds) rws rs ss ->
    in_modes (reals ds) (IZR h) (IZR l) ms rs (forces rws ss).
Proof.
  intros Fs. revert states. induction Fs as [|row r rws rs Fr Fs IH]; intros states Ex S A.
  - exists []. intros h l ds ss _ All. inversion All; subst. constructor.
  - cbn in Ex. apply andb_true_iff in Ex as [Er Ex]. cbn [share_one_mode] in S. apply andb_true_iff in S as [S1 S2].
    destruct (contact_mode_is row r Fr Er _ S1) as (m & Sg & M).
    { apply Forall_forall. intros s Hs. apply in_flat_map in Hs as (ss & Hss & Hs).
      rewrite Forall_forall in A. destruct (A ss Hss) as (h & l & ds & All). inversion All as [|? ? s' ? ? ? _ _ Is _]; subst.
      destruct Hs as [<-|[]]. apply Is. }
    destruct (IH (map (@tl state) states) Ex S2) as (ms & Ms).
    { apply Forall_map. eapply Forall_impl; [|exact A]. intros ss (h & l & ds & All). inversion All; subst.
      exists h, l, ds. assumption. }
    exists (m :: ms). intros h l ds ss Hss All. inversion All as [|? ? s ? ? ss' _ _ Is All']; subst.
    unfold forces. cbn [List.combine map fst snd]. fold (forces rws ss'). constructor; try assumption.
    + now apply (positive_weights row).
    + destruct (exact_friction row r Fr Er) as (M0 & -> & _). apply Rmult_le_pos; [exact M0|apply sqrt_pos].
    + apply (M h l ds s); [|exact Is]. apply in_flat_map. exists (s :: ss'). split; [exact Hss|now left].
    + apply Ms; [|exact All']. apply in_map_iff. now exists (s :: ss').
Qed.

Lemma point_states_are points number states : point_states two_sided n rows w u v points number = inl states ->
  Forall2 (fun p ss => exists ss0, check_load_point two_sided n rows w u v p = inl ss0 /\ ss = rev ss0) points states.
Proof.
  revert number states. induction points as [|p points IH]; intros number states H; cbn [point_states] in H.
  - injection H as <-. constructor.
  - destruct (check_load_point _ _ _ _ _ _ p) as [ss0|] eqn:C; [|discriminate].
    destruct (point_states _ _ _ _ _ _ points (S number)) as [others|] eqn:O; [|discriminate]. injection H as <-.
    constructor; [exists ss0; split; [exact C|now rewrite rev_append_rev, app_nil_r]|]. now apply (IH (S number)).
Qed.

Lemma nothing_grows : forallb (fun r => does_not_grow (box r)) rows = true ->
  Forall (fun r => Rows.growth r = 0) (Rows.rows sys).
Proof.
  clear - F. induction F as [|row r rows rs [_ (p & G & mu & t & I)] F' IH]; intros H; constructor; cbn in H;
    apply andb_true_iff in H as [H1 H2]; [|now apply IH].
  unfold does_not_grow in H1. apply andb_true_iff in H1 as [Z1 Z2]. apply ByDegree.is_zero_real in Z1, Z2.
  rewrite (in_growth _ _ _ _ _ _ I), Z1, Z2. ring.
Qed.

Theorem piece_resisted pieces number s t wst : pieces_fail two_sided n rows w u v pieces number = None ->
  Forall (fun r => Rows.growth r = 0) (Rows.rows sys) ->
  (forall y, Rows.dot wst y = Rows.dot (Rows.wrench sys) y + s * Rows.dot (real u) y + t * Rows.dot (real v) y) ->
  Exists (in_piece s t) (map (map load_part) pieces) -> Rows.stable_at (Rows.bounded None 1) (loaded sys wst) 0.
Proof.
  intros H G Ew X. revert number H. induction pieces as [|points pieces IH]; intros number H; [inversion X|].
  cbn [pieces_fail] in H. destruct (point_states _ _ _ _ _ _ points 0) as [states|[rule k]] eqn:St; [|discriminate].
  destruct (share_one_mode rows states) eqn:Sh; [|discriminate].
  cbn [map] in X. apply Exists_cons in X as [X|X]; [|now apply (IH X (S number))].
  pose proof (point_states_are _ _ _ St) as Ps.
  destruct (one_mode_of states rows (Rows.rows sys) F E Sh) as (ms & Ms).
  { clear - Ps F E certain_w w_is w_within u_length v_length Law. induction Ps as [|p ss points states (ss0 & C & ->) Ps IH]; constructor; [|exact IH].
    destruct (accepted_load_point p ss0 C) as (h & l & ds & ss' & k & _ & -> & A & _).
    exists h, l, ds. now rewrite rev_involutive. }
  destruct (sum_balances sys ms (real u) (real v) (map load_part points) 1 s t) as [B|(B & _)]; [|exact X| |lra].
  - intros a b e In_p. apply in_map_iff in In_p as (p & Ep & In_p).
    assert (exists ss, In ss states /\ exists ss0, check_load_point two_sided n rows w u v p = inl ss0 /\ ss = rev ss0)
      as (ss & Hss & ss0 & C & Er).
    { clear - Ps In_p. induction Ps as [|p' ss points states Hp Ps IH]; [contradiction|]. destruct In_p as [<-|In_p].
      - exists ss. split; [now left|exact Hp].
      - destruct (IH In_p) as (ss1 & H1 & H2). exists ss1. split; [now right|exact H2]. }
    destruct (accepted_load_point p ss0 C) as (h & l & ds & ss' & k & K & -> & A & L & Eh & El & O & B).
    rewrite rev_involutive in Er. subst ss.
    assert (Here : balances sys ms (real u) (real v) (IZR h) (IZR l * Q2R (along_u p)) (IZR l * Q2R (along_v p))).
    { exists (reals ds), (IZR l), (forces rows ss'). split; [now rewrite map_length|]. split; [exact O|].
      split; [now apply Ms|]. intros y. specialize (B y). lra. }
    pose proof (balances_mix sys ms _ _ k _ _ _ 0 _ _ _ (Rlt_le _ _ K) (Rle_refl 0) Here Here) as Scaled.
    unfold load_part in Ep. injection Ep as Ea Eb Ee. cbn [fst load_part] in Eh. rewrite Ea in Eh. subst b e.
    replace (Q2R a) with (k * IZR h + 0 * IZR h) by lra.
    replace (Q2R (along_u p)) with (k * (IZR l * Q2R (along_u p)) + 0 * (IZR l * Q2R (along_u p)))
      by (rewrite <- Rmult_assoc, El; ring).
    replace (Q2R (along_v p)) with (k * (IZR l * Q2R (along_v p)) + 0 * (IZR l * Q2R (along_v p)))
      by (rewrite <- Rmult_assoc, El; ring).
    exact Scaled.
  - exact (balances_resisted sys ms (real u) (real v) s t wst G Ew B).
Qed.

End Points.

(* ---- All else is not resisted ---- *)

Section Covered.
Open Scope R_scope.

Variable advisor : oracle.

Definition at_zero : range := Range 0 (Some 0%Q) false false.

Definition plane_fails (most : Z) (two_sided : bool) (n : nat) (rows : list row) (w : list interval) (u v : vector)
    (pieces : list (list homogeneous)) (nodes : list node) : option (string * nat) :=
  walk_ranges advisor (held_by n (map (map ray_of_part) pieces)) most two_sided (plane_setting n rows w u v)
    [at_zero] (map (plane_node n) nodes).

Lemma at_zero_in : in_range at_zero 0.
Proof. unfold in_range, at_zero; cbn. rewrite Q2R_0. repeat split; try discriminate; lra. Qed.

Lemma dot_beyond a d e : List.length a = List.length d -> Rows.dot a (d ++ e) = Rows.dot a d.
Proof.
  revert d. induction a as [|x a IH]; intros [|y d] L; try discriminate; cbn; [reflexivity|].
  rewrite IH by now injection L. reflexivity.
Qed.

(* No contact sees what is beyond its motion. *)
Lemma obeys_beyond w d e h l r f : List.length (Rows.N r) = List.length d ->
  Forall (fun a => List.length a = List.length d) (Rows.slips r) ->
  Rows.obeys w d h l r f -> Rows.obeys w (d ++ e) h l r f.
Proof.
  intros N S. unfold Rows.obeys. replace (Rows.v r (d ++ e) h l) with (Rows.v r d h l).
  - replace (Rows.slip r (d ++ e)) with (Rows.slip r d); [auto|]. unfold Rows.slip. apply map_ext_in.
    intros a Ha. rewrite Forall_forall in S. symmetry. now apply dot_beyond, S.
  - unfold Rows.v. now rewrite dot_beyond.
Qed.

Lemma pushed_in_plane n (u v : vector) h l d s t y : List.length d = n -> List.length u = List.length v ->
  Rows.dot y (Degree.times (map real (map (fun p => repeat 0%Q (2 + n) ++ [fst p; snd p]) (List.combine u v)))
    (h :: l :: d ++ [s; t])) = s * Rows.dot (real u) y + t * Rows.dot (real v) y.
Proof.
  intros <- L. assert (G : forall a c d, Rows.dot (real (repeat 0%Q (List.length d) ++ [a; c])) (d ++ [s; t]) =
    Q2R a * s + Q2R c * t).
  { intros a c d0. induction d0 as [|z d0 IH]; cbn [List.length repeat app real map Rows.dot]; [ring|].
    unfold real in IH. rewrite IH, Q2R_0. ring. }
  revert v y L. induction u as [|a u IH]; intros [|c v] y L; try discriminate.
  - cbn. rewrite Degree.dot_nil. ring.
  - destruct y as [|z y]; [cbn; ring|]. injection L as L. specialize (IH v y L).
    cbn [List.combine map Degree.times Rows.dot real fst snd] in *.
    unfold Degree.times, real in *. cbn [map Rows.dot repeat app Nat.add] in *. rewrite Q2R_0 in *. rewrite IH, G. ring.
Qed.

Theorem plane_covered most (two_sided : bool) rows w (u v : vector) sys pieces nodes s t wst :
  let n := Rows.dimension sys in
  Forall2 fits rows (Rows.rows sys) -> Forall2 within w (Rows.wrench sys) ->
  Forall (fun r => List.length (Rows.N r) = n /\ Forall (fun a => List.length a = n) (Rows.slips r)) (Rows.rows sys) ->
  List.length u = List.length v ->
  Rows.normal sys = (if two_sided then Model.bilateral else Model.unilateral) ->
  plane_fails most two_sided n rows w u v pieces nodes = None ->
  (forall y, Rows.dot wst y = Rows.dot (Rows.wrench sys) y + s * Rows.dot (real u) y + t * Rows.dot (real v) y) ->
  Rows.stable_at (Rows.bounded None 1) (loaded sys wst) 0 -> Exists (in_piece s t) pieces.
Proof.
  intros n F W Sh L Law H Ew (d & fs & _ & Ld & O & B). cbn [loaded Rows.dimension Rows.rows Rows.normal] in *.
  set (its := Rows.System n (Rows.rows sys) (Rows.wrench sys) (real (map (fun _ => 0%Q) u)) (Rows.normal sys)).
  refine (ranges_shown advisor (held_by n (map (map ray_of_part) pieces))
    (fun x => forall l (d : list R) s t, List.length d = n -> x = 1 :: l :: d ++ [s; t] -> Exists (in_piece s t) pieces)
    most two_sided (plane_setting n rows w u v) [at_zero] _ its 0 (d ++ [s; t]) fs _ eq_refl eq_refl _ H _ Law Logic.I
    (Exists_cons_hd (fun r => in_range r 0) at_zero [] at_zero_in) 0 d s t Ld eq_refl).
  - intros k rays x He Sp l d' s' t' Ld' ->. exact (held_is n pieces k rays 1 l d' s' t' Ld' He Sp).
  - rewrite app_length, Ld. cbn. fold n. lia.
  - constructor; cbn [plane_setting make_setting Tree.rows the_load pushes its Rows.rows Rows.wrench Rows.direction Rows.normal load_growth].
    + clear - F. induction F; constructor; [now apply Ways.fits_suits|assumption].
    + now apply box_is_load.
    + reflexivity.
    + lra.
    + lra.
    + clear - O Sh Ld. fold n in Ld. rewrite <- Ld in Sh. revert Sh.
      induction O as [|r f rs fs Of O IH]; intros Sh; constructor.
      * destruct (Forall_inv Sh) as [N S]. now apply obeys_beyond.
      * exact (IH (Forall_inv_tail Sh)).
    + intros y. specialize (B y). unfold pushed. cbn [a_multiple known_push map].
      rewrite pushed_in_plane by (assumption || exact Ld). unfold Rows.load in *.
      cbn [loaded Rows.wrench Rows.direction its] in *. rewrite Ew in B. lra.
Qed.

End Covered.
