(* SPDX-License-Identifier: MIT *)
(* The leaf of a tree (FORMAT.md sections 4 and 6): contacts by the signs that they have on the rays of
   a region, the bound of each contact's work, their sum g.  `leaf_refutes`: where a leaf
   holds, no equilibrium is at home.

   g is computed times a number M > 0, each term rounded up.  It is exact if M is a multiple of all
   denominators, and what is proved holds for every M. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box.
From Proved Require Model.
Import ListNotations.

(* ---- Functions on rays ---- *)

Section Checker.
Open Scope Z_scope.

Definition nowhere_negative (rays : list ray) (f : form) : bool :=
  forallb (fun r => 0 <=? dot f (coordinates r)) rays.

Definition nowhere_positive (rays : list ray) (f : form) : bool :=
  forallb (fun r => dot f (coordinates r) <=? 0) rays.

(* The rays on which a function is 0, unless it is negative on some. *)
Fixpoint zeros_unless_negative (value : form -> Z) (rays : list ray) : option (list ray) :=
  match rays with
  | [] => Some []
  | r :: rays' =>
      let y := value (coordinates r) in
      if y <? 0 then None
      else match zeros_unless_negative value rays' with
           | Some zs => Some (if y =? 0 then r :: zs else zs)
           | None => None
           end
  end.

(* Nowhere negative, and barred where it is 0. *)
Definition positive_at_home (strict : list (list form)) (rays : list ray) (value : form -> Z) : bool :=
  match zeros_unless_negative value rays with
  | Some zs => barred strict zs
  | None => false
  end.

Definition has_sign (strict : list (list form)) (rays : list ray) (t : multi form) : bool :=
  forallb (fun f => positive_at_home strict rays (dot f)) (tips t).

(* ---- The bound of a contact ---- *)

Definition largest (zs : list Z) : Z :=
  match zs with [] => 0 | z :: zs' => fold_left Z.max zs' z end.

(* What a contact adds to M g. *)
Inductive term :=
  | Nothing
  | Line (factor : Z) (f : form)
  (* numerator/denominator times the largest of some forms, or if it is larger and the contact is
     mixed, 0; rounded up *)
  | Bend (numerator denominator : Z) (forms : list form) (mixed : bool).

Definition value (t : term) (x : form) : Z :=
  match t with
  | Nothing => 0
  | Line factor f => factor * dot f x
  | Bend n d forms mixed =>
      let most := largest (map (fun f => dot f x) forms) in
      up (n * (if mixed then Z.max 0 most else most)) d
  end.

Definition edges (strict : list (list form)) (rays : list ray) (row : row) : list (multi form) :=
  match edges_none row with
  | [_] => edges_none row
  | _ => if has_sign strict rays (tau row) then edges_plus row
         else if has_sign strict rays (minus_tau row) then edges_minus row
         else edges_none row
  end.

Definition work_tree (y : form) (edge : multi form) : multi Z := mmap (fun f => dot f y) edge.

Definition pull_tips (row : row) : list form := concat (map tips (pulls row)).

Definition products_with (row : row) (a : multi Z) : list form :=
  flat_map (fun p => bernstein (parameters row) [(a, p)]) (pulls row).

(* Of one s, for a contact that is mixed. *)
Definition mixed_forms (row : row) (a : multi Z) : list form :=
  if forallb (fun z => z <=? 0) (tips a) then []
  else if forallb (fun z => 0 <=? z) (tips a) then products_with row a
  else map (map (Z.mul (power (parameters row) * largest (tips a)))) (pull_tips row).

Definition term_of (m : Z) (y : form) (es : list (multi form)) (mixed : bool) (row : row)
    : term :=
  match parameters row, pulls row with
  | O, [p] =>
      let c := largest (map (fun e =>
                 up (m * weight row * dot (first_tip e) y) (over_weight row)) es) in
      let v := first_tip p in
      if mixed then (if c <=? 0 then Nothing else Bend c 1 [v] true) else Line c v
  | _, _ =>
      let forms :=
        flat_map (fun e => (if mixed then mixed_forms row else products_with row)
                             (work_tree y e)) es in
      match forms with
      | [] => Nothing
      | _ => Bend (m * weight row) (over_weight row) forms mixed
      end
  end.

Definition contact_term (m : Z) (y : form) (strict : list (list form)) (rays : list ray) (row : row)
    : term :=
  let vs := pull_tips row in
  if forallb (nowhere_negative rays) vs then term_of m y (edges strict rays row) false row
  else if forallb (nowhere_positive rays) vs then Nothing
  else term_of m y (edges strict rays row) true row.

(* ---- The load ---- *)

(* w and u, in integers by one factor. *)
Record load := Load {
  load_box : list interval; load_growth : list Q;
  lows_of_w : form; highs_of_w : form; form_of_u : form;
  load_scaling : scaling
}.

Definition make_load (w : list interval) (u : list Q) : load :=
  let s := scaling_of (map low w ++ map high w ++ u) in
  let z := map (to_integer s) in
  Load w u (z (map low w)) (z (map high w)) (z u) s.

(* The largest y.w. *)
Fixpoint most_work (y lows highs : form) : Z :=
  match y, lows, highs with
  | c :: y', l :: lows', h :: highs' => c * (if 0 <? c then h else l) + most_work y' lows' highs'
  | _, _, _ => 0
  end.

Definition load_term (m : Z) (y : form) (ld : load) : form :=
  let t := m * times (load_scaling ld) in
  [0; 0; 0; up (t * most_work y (lows_of_w ld) (highs_of_w ld)) (over (load_scaling ld));
   up (t * dot (form_of_u ld) y) (over (load_scaling ld))].

(* ---- The leaf ---- *)

(* The linear terms are summed into one form. *)
Fixpoint collect {A : Type} (term_of_row : A -> term) (rows : list A) (linear : form)
    (bends : list term) : form * list term :=
  match rows with
  | [] => (linear, bends)
  | row :: rows' =>
      match term_of_row row with
      | Nothing => collect term_of_row rows' linear bends
      | Line c f => collect term_of_row rows' (combine 1 linear c f) bends
      | bend => collect term_of_row rows' linear (bend :: bends)
      end
  end.

Definition leaf_holds_by (m : Z) (rows : list row) (ld : load) (strict : list (list form))
    (rays : list ray) (y : form) : bool :=
  match y with
  | [_; _; _] =>
      (0 <? m) &&
      let (linear, bends) :=
        collect (contact_term m y strict rays) rows (load_term m y ld) [] in
      positive_at_home strict rays (fun x =>
        - fold_left (fun s t => s + value t x) bends (dot linear x))
  | _ => false
  end.

End Checker.

(* ---- Proofs ---- *)

Section Sums.
Open Scope R_scope.

(* The sum of a function of the rays of a point. *)
Fixpoint over_rays (G : form -> Z) (ws : list (R * form)) : R :=
  match ws with
  | [] => 0
  | (w, r) :: ws' => w * IZR (G r) + over_rays G ws'
  end.

Lemma over_rays_dot f ws : over_rays (dot f) ws = total f ws.
Proof. induction ws as [|[w r] ws IH]; cbn; [reflexivity|]. now rewrite IH. Qed.

Lemma over_rays_plus G H ws :
  over_rays (fun r => G r + H r)%Z ws = over_rays G ws + over_rays H ws.
Proof. induction ws as [|[w r] ws IH]; cbn; [lra|]. rewrite IH, plus_IZR. lra. Qed.

Lemma over_rays_opp G ws : over_rays (fun r => - G r)%Z ws = - over_rays G ws.
Proof. induction ws as [|[w r] ws IH]; cbn; [lra|]. rewrite IH, opp_IZR. lra. Qed.

Lemma over_rays_same G H ws : (forall r, G r = H r) -> over_rays G ws = over_rays H ws.
Proof. intros E. induction ws as [|[w r] ws IH]; cbn; [lra|]. now rewrite IH, E. Qed.

Variable rays : list form.
Variable ws : list (R * form).
Hypothesis W : weights rays ws.

Lemma over_rays_nonneg G : (forall r, In r rays -> 0 <= G r)%Z -> 0 <= over_rays G ws.
Proof.
  intros H. induction W as [|[w r] ws' [Hw Hr] W' IH]; cbn; [lra|]. cbn in *.
  specialize (H _ Hr). apply IZR_le in H. pose proof (Rmult_le_pos _ _ Hw H). auto.
  specialize (IH W'). lra.
Qed.

Lemma over_rays_le (G H : form -> Z) c :
  (forall r, In r rays -> c * IZR (G r) <= IZR (H r)) ->
  c * over_rays G ws <= over_rays H ws.
Proof.
  intros E. induction W as [|[w r] ws' [Hw Hr] W' IH]; cbn; [lra|]. cbn in *.
  specialize (E _ Hr). specialize (IH W').
  assert (w * (c * IZR (G r)) <= w * IZR (H r)) by now apply Rmult_le_compat_l. lra.
Qed.

Lemma over_rays_zero G : (forall r, In r rays -> 0 <= G r)%Z -> over_rays G ws = 0 ->
  Forall (fun p => fst p = 0 \/ In (snd p) rays /\ G (snd p) = 0%Z) ws.
Proof.
  intros H. induction W as [|[w r] ws' [Hw Hr] W' IH]; cbn; [constructor|]. intros E. cbn in *.
  assert (P : 0 <= over_rays G ws').
  { clear - H W'. induction W' as [|[w r] ws' [Hw Hr] W' IH]; cbn; [lra|]. cbn in *.
    specialize (H _ Hr). apply IZR_le in H. pose proof (Rmult_le_pos _ _ Hw H). lra. }
  pose proof (H _ Hr) as G0. apply IZR_le in G0. pose proof (Rmult_le_pos _ _ Hw G0).
  constructor; [|apply IH; [exact W'|lra]]. cbn.
  assert (Z : w * IZR (G r) = 0) by lra. apply Rmult_integral in Z as [Z|Z]; [now left|right].
  split; [exact Hr|]. now apply eq_IZR.
Qed.

End Sums.

Lemma zeros_unless_negative_spec value rays zs : zeros_unless_negative value rays = Some zs ->
  (forall r, In r rays -> 0 <= value (coordinates r))%Z /\
  (forall r, In r rays -> value (coordinates r) = 0%Z -> In r zs) /\
  (forall r, In r zs -> In r rays).
Proof.
  revert zs; induction rays as [|r rays IH]; intros zs; cbn.
  - intros E. injection E as <-. repeat split; intros ? [].
  - destruct (Z.ltb_spec (value (coordinates r)) 0); [discriminate|].
    destruct (zeros_unless_negative value rays) as [zs'|] eqn:E; [|discriminate].
    destruct (IH _ eq_refl) as (A & B & C).
    destruct (Z.eqb_spec (value (coordinates r)) 0); intros E'; injection E' as <-;
      repeat split; intros r' Hr'; cbn in *.
    + destruct Hr' as [<-|]; auto.
    + intros; destruct Hr' as [<-|]; auto.
    + destruct Hr' as [<-|]; auto.
    + destruct Hr' as [<-|]; auto.
    + intros; destruct Hr' as [<-|]; auto. contradiction.
    + auto.
Qed.

Lemma largest_above zs z : In z zs -> (z <= largest zs)%Z.
Proof.
  destruct zs as [|z0 zs]; [intros []|]. cbn.
  assert (A : forall zs m, (m <= fold_left Z.max zs m)%Z).
  { clear. intros zs. induction zs as [|a zs IH]; intros m; cbn; [lia|].
    specialize (IH (Z.max m a)). lia. }
  assert (B : forall zs m, In z zs -> (z <= fold_left Z.max zs m)%Z).
  { clear -A. intros zs. induction zs as [|a zs IH]; intros m; [intros []|]. cbn.
    intros [->|H]; [|auto]. pose proof (A zs (Z.max m z)). lia. }
  intros [->|H]; auto.
Qed.

Section AtHome.
Open Scope R_scope.

(* A point at home in a region: spanned by its rays, and no strict function is 0 there. *)
Variable strict : list (list form).
Variable rays : list ray.
Variable x : list R.
Hypothesis rays_know : Forall (knows strict) rays.
Hypothesis strict_at_x : Forall (Exists (fun f => rdot f x <> 0)) strict.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.

Lemma not_barred zs : (forall r, In r zs -> In r rays) -> barred strict zs = true ->
  Forall (fun p => fst p = 0 \/ exists r, In r zs /\ coordinates r = snd p) ws -> False.
Proof.
  intros Z B F. destruct (barred_by strict zs) as (fs & Hfs & H); [|exact B|].
  { apply Forall_forall. intros r Hr. rewrite Forall_forall in rays_know. auto. }
  rewrite Forall_forall in strict_at_x. specialize (strict_at_x fs Hfs).
  apply Exists_exists in strict_at_x as (f & Hf & NZ). apply NZ. rewrite spanned. clear - F H Hf.
  induction F as [|[w r] ws' Hp F IH]; cbn; [reflexivity|]. rewrite IH. cbn in Hp.
  destruct Hp as [->|(r' & Hr & <-)]; [lra|]. rewrite (H _ Hr _ Hf). lra.
Qed.

Lemma positive_at_home_positive value : positive_at_home strict rays value = true ->
  0 < over_rays value ws.
Proof.
  unfold positive_at_home. destruct (zeros_unless_negative value rays) as [zs|] eqn:E;
    [|discriminate]. intros B.
  destruct (zeros_unless_negative_spec _ _ _ E) as (N & Z & S).
  assert (N' : forall r, In r (map coordinates rays) -> (0 <= value r)%Z).
  { intros r Hr. apply in_map_iff in Hr as (r' & <- & Hr). auto. }
  destruct (Rle_lt_or_eq_dec 0 (over_rays value ws)) as [H|H];
    [now apply over_rays_nonneg with (map coordinates rays)|exact H|].
  exfalso. apply (not_barred zs S B). symmetry in H.
  pose proof (over_rays_zero _ _ W _ N' H) as F. eapply Forall_impl; [|exact F].
  intros [w r]; cbn. intros [->|[Hr Hz]]; [now left|right].
  apply in_map_iff in Hr as (r' & <- & Hr). exists r'. auto.
Qed.

Lemma has_sign_positive t ss : Forall is_share ss -> has_sign strict rays t = true ->
  0 < eval (fun f => rdot f x) t ss.
Proof.
  intros S H. unfold has_sign in H. rewrite forallb_forall in H.
  assert (P : forall f, In f (tips t) -> 0 < rdot f x).
  { intros f Hf. rewrite spanned, <- over_rays_dot. apply positive_at_home_positive. auto. }
  destruct (Rle_lt_or_eq_dec 0 (eval (fun f => rdot f x) t ss)) as [L|L]; [|exact L|].
  - apply eval_least; [exact S|]. intros f Hf. left. auto.
  - exfalso. destruct (eval_zero (fun f => rdot f x) t ss S) as (f & Hf & Z).
    + intros f Hf. left. auto.
    + now symmetry.
    + specialize (P f Hf). lra.
Qed.

Lemma nowhere_negative_nonneg f : nowhere_negative rays f = true -> 0 <= rdot f x.
Proof.
  intros H. rewrite spanned, <- over_rays_dot. apply over_rays_nonneg with (map coordinates rays);
    [exact W|]. intros r Hr. apply in_map_iff in Hr as (r' & <- & Hr).
  unfold nowhere_negative in H. rewrite forallb_forall in H. apply Z.leb_le. auto.
Qed.

Lemma nowhere_positive_nonpos f : nowhere_positive rays f = true -> rdot f x <= 0.
Proof.
  intros H. assert (0 <= over_rays (fun r => - dot f r)%Z ws).
  { apply over_rays_nonneg with (map coordinates rays); [exact W|].
    intros r Hr. apply in_map_iff in Hr as (r' & <- & Hr).
    unfold nowhere_positive in H. rewrite forallb_forall in H. specialize (H _ Hr).
    apply Z.leb_le in H. lia. }
  rewrite over_rays_opp, over_rays_dot, <- spanned in H0. lra.
Qed.

(* The bound that a term gives. *)
Notation bound t := (over_rays (value t) ws).

Lemma line_bound c f : bound (Line c f) = IZR c * rdot f x.
Proof.
  rewrite spanned. cbn. clear. induction ws as [|[w r] ws' IH]; cbn; [ring|].
  rewrite IH, mult_IZR. ring.
Qed.

Lemma bend_bound n d forms mixed f : (0 <= n)%Z -> (0 < d)%Z -> In f forms ->
  IZR n / IZR d * rdot f x <= bound (Bend n d forms mixed).
Proof.
  intros N D H. rewrite spanned, <- over_rays_dot.
  apply over_rays_le with (map coordinates rays); [exact W|]. intros r _. cbn.
  set (most := largest (map (fun f => dot f r) forms)).
  assert (L : (dot f r <= if mixed then Z.max 0 most else most)%Z).
  { assert (dot f r <= most)%Z by (apply largest_above; apply in_map_iff; now exists f).
    destruct mixed; lia. }
  eapply Rle_trans; [|apply up_above; exact D]. rewrite mult_IZR. apply IZR_le in L, N.
  apply IZR_lt in D. assert (0 <= / IZR d) by (left; now apply Rinv_0_lt_compat).
  unfold Rdiv. rewrite Rmult_assoc, (Rmult_comm (/ _)), <- Rmult_assoc.
  apply Rmult_le_compat_r; [assumption|]. now apply Rmult_le_compat_l.
Qed.

Lemma mixed_bound_nonneg n d forms : (0 <= n)%Z -> (0 < d)%Z -> 0 <= bound (Bend n d forms true).
Proof.
  intros N D. apply over_rays_nonneg with (map coordinates rays); [exact W|]. intros r _. cbn.
  apply le_IZR. eapply Rle_trans; [|apply up_above; exact D].
  apply Rmult_le_pos; [apply IZR_le; nia|]. left. apply Rinv_0_lt_compat. now apply IZR_lt.
Qed.

Fixpoint bounds (ts : list term) : R :=
  match ts with [] => 0 | t :: ts' => bound t + bounds ts' end.

Lemma collect_sum {A : Type} (f : A -> term) rows linear bends linear' bends' :
  collect f rows linear bends = (linear', bends') ->
  rdot linear' x + bounds bends' = rdot linear x + bounds bends + bounds (map f rows).
Proof.
  revert linear bends. induction rows as [|row rows IH]; intros linear bends; cbn.
  - intros E. injection E as <- <-. lra.
  - destruct (f row) as [|c g|n den forms mixed] eqn:F; intros E; rewrite (IH _ _ E).
    + assert (B : bound Nothing = 0).
      { clear. induction ws as [|[w z] ws' IH]; cbn; [reflexivity|]. rewrite IH. lra. }
      rewrite B. lra.
    + rewrite rdot_combine, line_bound. lra.
    + cbn [bounds]. lra.
Qed.

Lemma sum_of_values bends linear :
  over_rays (fun r => - fold_left (fun s t => s + value t r) bends (dot linear r))%Z ws
  = - (rdot linear x + bounds bends).
Proof.
  rewrite over_rays_opp. f_equal. rewrite spanned, <- over_rays_dot.
  generalize (dot linear) as G. induction bends as [|t bends IH]; intros G; cbn.
  - now rewrite Rplus_0_r.
  - rewrite (IH (fun r => G r + value t r)%Z), over_rays_plus. apply Rplus_assoc.
Qed.

End AtHome.

(* ---- A contact's force does at most the bound of work ---- *)

Lemma Rabs_within (x a : R) : (Rabs x <= a -> - a <= x <= a)%R.
Proof.
  intros H. pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra.
Qed.

Section Leaf.
Open Scope R_scope.

Variable strict : list (list form).
Variable rays : list ray.
Variable d : Model.vector.
Variable lambda : R.
Let x := located d 1 lambda.
Hypothesis rays_know : Forall (knows strict) rays.
Hypothesis strict_at_x : Forall (Exists (fun f => rdot f x <> 0)) strict.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.
Notation bound t := (over_rays (value t) ws).

Variables y1 y2 y3 : Z.
Let y := [y1; y2; y3].
Let yv := Model.Vector (IZR y1) (IZR y2) (IZR y3).
Variable m : Z.
Hypothesis m_positive : (0 < m)%Z.

Section Contact.

Variable b : cbox.
Variable e : R.
Variable c : Model.contact.
Hypothesis I : inside b e c.
Let r := make_row b.
Let ss := shares_in b e c.

(* y.(N + s T) *)
Notation alpha s := (Model.work (Model.N c) yv + s * Model.work (Model.T c) yv).

Let v := Model.v c lambda d.

Lemma v_as_pull : v = Model.preload c / Model.length c * 1
  + Model.growth c / Model.length c * lambda
  - Model.stiffness c / (Model.length c * Model.length c) * Model.work (Model.N c) d.
Proof. unfold v, Model.v, Rdiv. ring. Qed.

Lemma v_bound factor U :
  (forall p k, In (p, k) (pull_ends b) ->
     factor * (unit (pull_scaling b) *
       eval (fun f => rdot f x) (integer_tree (pull_scaling b) (corners b (pull_at b p k))) ss)
     <= U) -> factor * v <= U.
Proof.
  intros H. rewrite v_as_pull. apply (v_at_ends b e c I). intros p k Hpk.
  rewrite (pull_corners b e c I p k d 1 lambda Hpk). apply H. exact Hpk.
Qed.

Lemma pull_in p k : In (p, k) (pull_ends b) ->
  In (integer_tree (pull_scaling b) (corners b (pull_at b p k))) (pulls r).
Proof.
  intros H. cbn [r pulls make_row]. apply in_map_iff.
  exists (corners b (pull_at b p k)). split; [reflexivity|].
  apply in_map_iff. now exists (p, k).
Qed.

Lemma pull_tip_in t f : In t (pulls r) -> In f (tips t) -> In f (pull_tips r).
Proof. intros. apply in_concat. exists (tips t). split; [now apply in_map | assumption]. Qed.

Lemma shares_good : Forall is_share ss.
Proof. apply (shares_valid b e c I). Qed.

Lemma pull_unit : 0 < unit (pull_scaling b).
Proof. apply trees_unit_positive. Qed.

Lemma edge_unit : 0 < unit (edge_scaling b).
Proof. apply trees_unit_positive. Qed.

Lemma v_nonneg : forallb (nowhere_negative rays) (pull_tips r) = true -> 0 <= v.
Proof.
  intros H. rewrite forallb_forall in H. assert (-1 * v <= 0); [|lra].
  apply v_bound. intros p k Hpk. pose proof pull_unit.
  assert (0 <= eval (fun f => rdot f x)
            (integer_tree (pull_scaling b) (corners b (pull_at b p k))) ss); [|nra].
  apply eval_least; [exact shares_good|]. intros f Hf.
  apply (nowhere_negative_nonneg rays x ws W spanned). apply H.
  eapply pull_tip_in; [apply pull_in; eassumption | exact Hf].
Qed.

Lemma v_nonpos : forallb (nowhere_positive rays) (pull_tips r) = true -> v <= 0.
Proof.
  intros H. rewrite forallb_forall in H. rewrite <- (Rmult_1_l v).
  apply v_bound. intros p k Hpk. pose proof pull_unit.
  assert (eval (fun f => rdot f x)
            (integer_tree (pull_scaling b) (corners b (pull_at b p k))) ss <= 0); [|nra].
  apply eval_most; [exact shares_good|]. intros f Hf.
  apply (nowhere_positive_nonpos rays x ws W spanned). apply H.
  eapply pull_tip_in; [apply pull_in; eassumption | exact Hf].
Qed.

(* alpha of an edge, in integers. *)
Lemma alpha_is s : In s (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)) ->
  alpha (Q2R s) = unit (edge_scaling b) *
    eval IZR (work_tree y (integer_tree (edge_scaling b) (corners b (edge_at b s)))) ss.
Proof.
  intros H. rewrite (edge_corners b e c I s yv H). f_equal. unfold work_tree.
  rewrite eval_mmap. apply eval_same. intros f _. rewrite <- rdot_integers.
  unfold located, y, yv. cbn [map Model.along_x Model.along_y Model.about_z]. clear.
  destruct f as [|? [|? [|? [|? [|? [|? ?]]]]]]; cbn; rewrite ?plus_IZR, ?mult_IZR; ring.
Qed.

Lemma weight_is : (0 < over_weight r)%Z /\ (0 < m * weight r)%Z /\
  unit (edge_scaling b) * unit (pull_scaling b) =
  IZR (weight r) / IZR (over_weight r) * IZR (power (parameters r)).
Proof.
  destruct (row_weight b) as [O E]. fold r in O, E. pose proof (power_positive (parameters r)).
  pose proof pull_unit. pose proof edge_unit. split; [exact O|]. split.
  - assert (0 < weight r)%Z; [|nia]. apply lt_IZR. apply IZR_lt in O.
    assert (0 < IZR (weight r) / IZR (over_weight r)).
    { rewrite E. apply Rdiv_lt_0_compat; [|assumption]. apply Rmult_lt_0_compat; assumption. }
    replace (IZR (weight r)) with (IZR (weight r) / IZR (over_weight r) * IZR (over_weight r))
      by (field; lra). apply Rmult_lt_0_compat; assumption.
  - rewrite E. field. lra.
Qed.

(* Some s of which the bound is taken, as its edge. *)
Definition edge_of (s : Q) : multi form :=
  integer_tree (edge_scaling b) (corners b (edge_at b s)).

Notation s_list :=
  (minus_ends (box_friction b) ++ ends (box_friction b) ++ full_range (box_friction b)).

(* The bound of alpha v of a contact that is closed, or that is mixed and presses. *)
Lemma products_bound s U : In s s_list ->
  (forall f, In f (products_with r (work_tree y (edge_of s))) ->
     IZR (m * weight r) / IZR (over_weight r) * rdot f x <= U) ->
  IZR m * alpha (Q2R s) * v <= U.
Proof.
  intros Hs H. destruct weight_is as (O & N & E). apply v_bound. intros p k Hpk.
  rewrite (alpha_is s Hs). fold (edge_of s).
  set (A := work_tree y (edge_of s)) in *.
  set (P := integer_tree (pull_scaling b) (corners b (pull_at b p k))).
  replace (IZR m * (unit (edge_scaling b) * eval IZR A ss) *
           (unit (pull_scaling b) * eval (fun f => rdot f x) P ss))
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) *
          (products [(A, P)] x ss)) by (cbn; ring).
  rewrite E. set (q := IZR (m * weight r) / IZR (over_weight r)) in *.
  replace (IZR m * (IZR (weight r) / IZR (over_weight r) * IZR (power (parameters r))) *
           products [(A, P)] x ss)
    with (q * (IZR (power (parameters r)) * products [(A, P)] x ss))
    by (unfold q, Rdiv; rewrite mult_IZR; ring).
  assert (Q : 0 < q) by (apply Rdiv_lt_0_compat; now apply IZR_lt).
  assert (IZR (power (parameters r)) * products [(A, P)] x ss <= U / q).
  { apply bernstein_bound; [apply (shares_count b e c)|exact shares_good|]. intros f Hf.
    apply Rmult_le_reg_l with q; [exact Q|]. replace (q * (U / q)) with U by (field; lra).
    apply H. apply in_flat_map. exists P. split; [now apply pull_in | exact Hf]. }
  replace U with (q * (U / q)) by (field; lra). apply Rmult_le_compat_l; lra.
Qed.

(* The same with the products of the largest alpha and all v. *)
Lemma largest_bound s U : In s s_list -> 0 <= v ->
  (forall f, In f (map (map (Z.mul (power (parameters r) * largest (tips (work_tree y (edge_of s))))))
                     (pull_tips r)) ->
     IZR (m * weight r) / IZR (over_weight r) * rdot f x <= U) ->
  IZR m * alpha (Q2R s) * v <= U.
Proof.
  intros Hs V H. destruct weight_is as (O & N & E).
  set (A := work_tree y (edge_of s)) in *. set (top := largest (tips A)) in *.
  pose proof edge_unit as EU. pose proof pull_unit as PU.
  apply IZR_lt in m_positive as MP.
  assert (L : alpha (Q2R s) <= unit (edge_scaling b) * IZR top).
  { rewrite (alpha_is s Hs). fold (edge_of s). fold A. apply Rmult_le_compat_l; [lra|].
    apply eval_most; [exact shares_good|]. intros z Hz. apply IZR_le. now apply largest_above. }
  apply Rle_trans with (IZR m * (unit (edge_scaling b) * IZR top) * v).
  { apply Rmult_le_compat_r; [exact V|]. apply Rmult_le_compat_l; lra. }
  apply v_bound. intros p k Hpk.
  set (P := integer_tree (pull_scaling b) (corners b (pull_at b p k))).
  replace (IZR m * (unit (edge_scaling b) * IZR top) *
           (unit (pull_scaling b) * eval (fun f => rdot f x) P ss))
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) * IZR top *
          eval (fun f => rdot f x) P ss) by ring.
  rewrite E, <- eval_multiple. apply eval_most; [exact shares_good|]. intros f Hf.
  specialize (H (map (Z.mul (power (parameters r) * top)) f)).
  rewrite rdot_scaled, !mult_IZR in H. eapply Rle_trans; [|apply H].
  - right. unfold Rdiv. ring.
  - apply in_map. eapply pull_tip_in; [apply pull_in; eassumption | exact Hf].
Qed.

(* If there are no corners, and one form v. *)
Lemma single_bound s p factor : In s s_list -> parameters r = O -> pulls r = [p] ->
  (up (m * weight r * dot (first_tip (edge_of s)) y) (over_weight r) <= factor)%Z -> 0 <= v ->
  IZR m * alpha (Q2R s) * v <= IZR factor * rdot (first_tip p) x.
Proof.
  intros Hs Z Hp F V. destruct weight_is as (O & N & E).
  assert (SS : ss = []).
  { pose proof (shares_count b e c) as L. fold r in L. rewrite Z in L.
    now apply length_zero_iff_nil in L. }
  pose proof pull_unit as PU. pose proof edge_unit as EU.
  assert (VE : v = unit (pull_scaling b) * rdot (first_tip p) x).
  { assert (A : forall factor, factor * v <= factor * (unit (pull_scaling b) * rdot (first_tip p) x)).
    { intros f. apply v_bound. intros p' k Hpk. apply pull_in in Hpk. rewrite Hp in Hpk.
      destruct Hpk as [<-|[]]. rewrite SS, eval_first. lra. }
    pose proof (A 1). pose proof (A (-1)). lra. }
  assert (R0 : 0 <= rdot (first_tip p) x) by nra.
  rewrite (alpha_is s Hs). fold (edge_of s). rewrite SS, VE. unfold work_tree.
  rewrite eval_mmap, eval_first. set (z := dot (first_tip (edge_of s)) y) in *.
  replace (IZR m * (unit (edge_scaling b) * IZR z) * (unit (pull_scaling b) * rdot (first_tip p) x))
    with (IZR m * (unit (edge_scaling b) * unit (pull_scaling b)) * IZR z * rdot (first_tip p) x)
    by ring.
  rewrite E, Z. cbn [power]. apply Rmult_le_compat_r; [exact R0|].
  apply IZR_le in F. eapply Rle_trans; [|exact F].
  eapply Rle_trans; [|apply up_above; exact O]. rewrite !mult_IZR. right. unfold Rdiv. ring.
Qed.

(* What friction may be, by the sign of slip. *)
Lemma work_at_ends (force : R * R) l es :
  Model.obeys l lambda d c force -> es = edges strict rays r ->
  exists s_of, es = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
  forall U, (forall s, In s s_of -> IZR m * alpha (Q2R s) * fst force <= U) ->
    IZR m * Model.work (Model.contact_wrench c force) yv <= U.
Proof.
  destruct force as [a f]. intros (Law & Cone & Plus & Minus) ->. cbn [fst].
  assert (A0 : 0 <= a).
  { destruct l; cbn in Law; [rewrite Law; apply Rmax_l|lra]. }
  assert (WE : Model.work (Model.contact_wrench c (a, f)) yv =
               a * Model.work (Model.N c) yv + f * Model.work (Model.T c) yv).
  { unfold Model.work, Model.contact_wrench, Model.add, Model.scale; cbn. ring. }
  pose proof (in_friction _ _ _ I) as Wf. pose proof (friction_nonneg _ _ _ I) as F0.
  set (mu := Model.friction c) in *.
  set (yN := Model.work (Model.N c) yv) in *. set (yT := Model.work (Model.T c) yv) in *.
  assert (None : exists s_of, edges_none r = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
    forall U, (forall s, In s s_of -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * Model.work (Model.contact_wrench c (a, f)) yv <= U).
  { exists (full_range (box_friction b)). repeat split.
    - cbn [r edges_none make_row]. rewrite edge_scaling_is, map_map. reflexivity.
    - intros s H. apply in_or_app. right. apply in_or_app. now right.
    - intros U H. rewrite WE. unfold full_range in H.
      assert (Cone' : Rabs f <= Q2R (high (box_friction b)) * a) by (destruct Wf; nra).
      apply Rabs_within in Cone' as [C1 C2].
      destruct (Qeq_bool (high (box_friction b)) 0) eqn:Z.
      + apply Qeq_bool_eq, Qeq_eqR in Z. rewrite Q2R_0 in Z. rewrite Z in *.
        assert (f = 0) by lra. subst f. specialize (H _ (or_introl eq_refl)).
        rewrite Q2R_0 in H. nra.
      + pose proof (H _ (or_introl eq_refl)) as H1.
        pose proof (H _ (or_intror (or_introl eq_refl))) as H2. rewrite Q2R_opp in H1.
        set (t := Q2R (high (box_friction b))) in *. apply IZR_lt in m_positive as MP.
        set (M := IZR m) in *.
        assert (X : f * yT <= t * a * Rabs yT).
        { apply Rle_trans with (Rabs f * Rabs yT).
          - rewrite <- Rabs_mult. apply Rle_abs.
          - apply Rmult_le_compat_r; [apply Rabs_pos|]. apply Rabs_le. lra. }
        destruct (Rcase_abs yT) as [Ny|Py].
        * rewrite Rabs_left in X by exact Ny. nra.
        * rewrite Rabs_right in X by exact Py. nra. }
  assert (Ends : forall sgn : Q -> Q, (forall q, Q2R (sgn q) = Q2R (sgn 1%Q) * Q2R q) ->
    f = Q2R (sgn 1%Q) * (mu * a) ->
    forall U, (forall s, In s (map sgn (ends (box_friction b))) -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * Model.work (Model.contact_wrench c (a, f)) yv <= U).
  { intros sgn S Hf U H. rewrite WE, Hf.
    replace (IZR m * (a * yN + Q2R (sgn 1%Q) * (mu * a) * yT))
      with (IZR m * a * yN + IZR m * Q2R (sgn 1%Q) * a * yT * mu) by ring.
    apply at_ends with (box_friction b); [exact Wf|]. intros q Hq.
    replace (IZR m * a * yN + IZR m * Q2R (sgn 1%Q) * a * yT * Q2R q)
      with (IZR m * (yN + Q2R (sgn q) * yT) * a) by (rewrite S; ring).
    apply H. now apply in_map. }
  assert (General :
    exists s_of, (if has_sign strict rays (tau r) then edges_plus r
                  else if has_sign strict rays (minus_tau r) then edges_minus r
                  else edges_none r) = map edge_of s_of /\ (forall s, In s s_of -> In s s_list) /\
    forall U, (forall s, In s s_of -> IZR m * (yN + Q2R s * yT) * a <= U) ->
      IZR m * Model.work (Model.contact_wrench c (a, f)) yv <= U).
  { pose proof (tau_corners b e c I d 1 lambda) as TC. fold x in TC.
    pose proof (trees_unit_positive [corners b (T_at b)]) as TU.
    destruct (has_sign strict rays (tau r)) eqn:SP; [|destruct (has_sign strict rays (minus_tau r)) eqn:SM];
      [| |exact None].
    - apply (has_sign_positive strict rays x rays_know strict_at_x ws W spanned _ ss shares_good) in SP.
      exists (minus_ends (box_friction b)). repeat split.
      + cbn [r edges_plus make_row]. rewrite edge_scaling_is, map_map. reflexivity.
      + intros s H. apply in_or_app. now left.
      + apply Ends.
        * intros q. rewrite !Q2R_opp, Q2R_1. ring.
        * rewrite Q2R_opp, Q2R_1, Plus; [ring|]. rewrite TC. fold r. fold ss. nra.
    - apply (has_sign_positive strict rays x rays_know strict_at_x ws W spanned _ ss shares_good) in SM.
      exists (ends (box_friction b)). repeat split.
      + cbn [r edges_minus make_row]. rewrite edge_scaling_is, map_map. reflexivity.
      + intros s H. apply in_or_app. right. apply in_or_app. now left.
      + rewrite <- (map_id (ends (box_friction b))). apply Ends.
        * intros q. rewrite Q2R_1. ring.
        * rewrite Q2R_1, Minus; [ring|]. rewrite TC. fold r. fold ss.
          cbn [r minus_tau make_row] in SM. rewrite eval_mmap in SM.
          assert (NG : forall f x, rdot (negative f) x = -1 * rdot f x).
          { clear. induction f as [|z f IH]; intros [|t x]; cbn; try ring.
            rewrite opp_IZR. unfold negative in IH. rewrite IH. ring. }
          rewrite (eval_same _ (fun f => -1 * rdot f x)) in SM by (intros; apply NG).
          rewrite eval_multiple in SM. cbn [r tau make_row]. nra. }
  unfold edges. destruct (edges_none r) as [|z1 [|z2 l']] eqn:EN; try exact General.
  rewrite <- EN. destruct None as (s_of & E1 & R1). exists s_of. rewrite EN. split; [exact E1|exact R1].
Qed.

Theorem contact_bound l force : Model.obeys l lambda d c force ->
  IZR m * Model.work (Model.contact_wrench c force) yv <= bound (contact_term m y strict rays r).
Proof.
  intros Ob. destruct (work_at_ends force l (edges strict rays r) Ob eq_refl) as (s_of & ES & SL & Ends).
  destruct force as [a f]. destruct weight_is as (O & N & _).
  assert (Law : a = Rmax 0 v).
  { destruct Ob as [Law _]. destruct l; cbn in Law; [exact Law|]. fold v in Law.
    rewrite Rmax_right; lra. }
  unfold contact_term. destruct (forallb (nowhere_negative rays) (pull_tips r)) eqn:Closed;
    [|destruct (forallb (nowhere_positive rays) (pull_tips r)) eqn:Open].
  - (* closed *)
    pose proof (v_nonneg Closed) as V. rewrite Rmax_right in Law by exact V. subst a.
    apply Ends. intros s Hs. cbn [fst]. rewrite ES. specialize (SL s Hs).
    assert (G : forall forms t,
      t = match forms with [] => Nothing | _ => Bend (m * weight r) (over_weight r) forms false end ->
      forms = flat_map (fun e => products_with r (work_tree y e)) (map edge_of s_of) ->
      IZR m * alpha (Q2R s) * v <= bound t).
    { intros forms t -> EF. apply products_bound; [exact SL|]. intros g Hg.
      assert (In g forms).
      { rewrite EF. apply in_flat_map. exists (edge_of s). split; [now apply in_map|exact Hg]. }
      destruct forms as [|g0 forms]; [contradiction|].
      apply (bend_bound rays x ws W spanned); [lia|exact O|assumption]. }
    unfold term_of. destruct (parameters r) eqn:EP; [|eapply G; reflexivity].
    destruct (pulls r) as [|p [|p' ps]] eqn:EPl; try (eapply G; reflexivity).
    rewrite (line_bound x ws spanned). apply single_bound; try assumption.
    apply largest_above. rewrite map_map. apply in_map_iff. now exists s.
  - (* open *)
    pose proof (v_nonpos Open) as V. rewrite Rmax_left in Law by exact V. subst a.
    destruct Ob as (_ & Cone & _). rewrite Rmult_0_r in Cone.
    assert (f = 0) by (apply Rabs_within in Cone; lra). subst f.
    assert (B0 : bound Nothing = 0).
    { clear. induction ws as [|[w z] ws' IH]; cbn; [reflexivity|]. rewrite IH. lra. }
    rewrite B0. right. unfold Model.work, Model.contact_wrench, Model.add, Model.scale; cbn. ring.
  - (* mixed *)
    assert (B0 : 0 <= bound (term_of m y (edges strict rays r) true r)).
    { assert (Z0 : bound Nothing = 0).
      { clear. induction ws as [|[w z] ws' IH]; cbn; [reflexivity|]. rewrite IH. lra. }
      assert (G : forall forms,
        0 <= bound (match forms with [] => Nothing
                    | _ => Bend (m * weight r) (over_weight r) forms true end)).
      { intros [|g forms]; [lra|]. apply (mixed_bound_nonneg rays ws W); [lia|exact O]. }
      unfold term_of. destruct (parameters r); [|apply G].
      destruct (pulls r) as [|p [|p' ps]]; try apply G.
      destruct (Z.leb_spec (largest (map (fun e => up (m * weight r * dot (first_tip e) y)
        (over_weight r)) (edges strict rays r))) 0); [lra|].
      apply (mixed_bound_nonneg rays ws W); lia. }
    destruct (Rle_dec v 0) as [V|V].
    { rewrite Rmax_left in Law by exact V. apply Ends. intros s _. cbn [fst]. rewrite Law. lra. }
    rewrite Rmax_right in Law by lra. subst a.
    apply Ends. intros s Hs. cbn [fst]. rewrite ES in *. specialize (SL s Hs).
    assert (G : forall forms t,
      t = match forms with [] => Nothing | _ => Bend (m * weight r) (over_weight r) forms true end ->
      forms = flat_map (fun e => mixed_forms r (work_tree y e)) (map edge_of s_of) ->
      0 <= bound t ->
      IZR m * alpha (Q2R s) * v <= bound t).
    { intros forms t -> EF P.
      assert (In_forms : forall g, In g (mixed_forms r (work_tree y (edge_of s))) ->
        IZR (m * weight r) / IZR (over_weight r) * rdot g x <=
        bound (match forms with [] => Nothing | _ => Bend (m * weight r) (over_weight r) forms true end)).
      { intros g Hg. assert (In g forms).
        { rewrite EF. apply in_flat_map. exists (edge_of s). split; [now apply in_map|exact Hg]. }
        destruct forms as [|g0 forms]; [contradiction|].
        apply (bend_bound rays x ws W spanned); [lia|exact O|assumption]. }
      unfold mixed_forms in In_forms.
      destruct (forallb (fun z => z <=? 0)%Z (tips (work_tree y (edge_of s)))) eqn:Neg.
      - eapply Rle_trans; [|exact P]. rewrite (alpha_is s SL). fold (edge_of s).
        assert (L : eval IZR (work_tree y (edge_of s)) ss <= 0).
        { apply eval_most; [exact shares_good|]. intros z Hz. rewrite forallb_forall in Neg.
          apply IZR_le. apply Z.leb_le. auto. }
        pose proof edge_unit. apply IZR_lt in m_positive as MP.
        assert (unit (edge_scaling b) * eval IZR (work_tree y (edge_of s)) ss <= 0) by nra.
        assert (IZR m * (unit (edge_scaling b) * eval IZR (work_tree y (edge_of s)) ss) <= 0) by nra.
        nra.
      - destruct (forallb (fun z => 0 <=? z)%Z (tips (work_tree y (edge_of s)))).
        + apply products_bound; assumption.
        + apply largest_bound; [assumption|lra|assumption]. }
    unfold term_of in *. destruct (parameters r) eqn:EP; [|eapply G; [reflexivity|reflexivity|exact B0]].
    destruct (pulls r) as [|p [|p' ps]] eqn:EPl;
      try (eapply G; [reflexivity|reflexivity|exact B0]).
    set (factor := largest _) in *.
    assert (F : (up (m * weight r * dot (first_tip (edge_of s)) y) (over_weight r) <= factor)%Z).
    { apply largest_above. rewrite map_map. apply in_map_iff. now exists s. }
    pose proof (single_bound s p factor SL EP EPl F) as SB.
    assert (V0 : 0 <= v) by lra. specialize (SB V0).
    assert (R0 : 0 <= rdot (first_tip p) x).
    { apply Rnot_lt_le. intros L. pose proof pull_unit.
      assert (1 * v <= 1 * (unit (pull_scaling b) * rdot (first_tip p) x)); [|nra].
      apply v_bound. intros p' k Hpk. apply pull_in in Hpk. rewrite EPl in Hpk.
      destruct Hpk as [<-|[]].
      assert (SS : ss = []).
      { pose proof (shares_count b e c) as Len. fold r in Len. rewrite EP in Len.
        now apply length_zero_iff_nil in Len. }
      rewrite SS, eval_first. lra. }
    destruct (Z.leb_spec factor 0) as [L|L].
    + eapply Rle_trans; [exact SB|]. apply IZR_le in L. eapply Rle_trans; [|exact B0]. nra.
    + eapply Rle_trans; [exact SB|].
      replace (IZR factor) with (IZR factor / IZR 1) by (field; lra).
      apply (bend_bound rays x ws W spanned); [lia|lia|now left].
Qed.

End Contact.

(* ---- The leaf ---- *)

Definition fits (row : row) (c : Model.contact) :=
  row = make_row (box row) /\ exists e, inside (box row) e c.

(* A real motion and forces for a multiple lambda >= 0 that are an equilibrium of a grasp in the box
   of these rows and this load. *)
Record solution (rows : list row) (ld : load) (g : Model.grasp) (lambda : R)
    (d : Model.vector) (forces : list (R * R)) : Prop := Solution {
  contacts_fit : Forall2 fits rows (Model.contacts g);
  load_fits : ld = make_load (load_box ld) (load_growth ld);
  wrench_fits : Forall2 within (load_box ld)
    [Model.along_x (Model.wrench g); Model.along_y (Model.wrench g);
     Model.about_z (Model.wrench g)];
  growth_fits : map Q2R (load_growth ld) =
    [Model.along_x (Model.direction g); Model.along_y (Model.direction g);
     Model.about_z (Model.direction g)];
  lambda_nonneg : 0 <= lambda;
  is_equilibrium : Model.equilibrium g lambda d forces
}.

Lemma forces_bound rows law cs forces :
  Forall2 fits rows cs -> Forall2 (Model.obeys law lambda d) cs forces ->
  IZR m * Model.work (Model.sum (Model.contact_wrenches cs forces)) yv
  <= bounds ws (map (contact_term m y strict rays) rows).
Proof.
  intros F. revert forces. induction F as [|row c rows cs [Fr [e In_e]] F IH]; intros forces O.
  - inversion O; subst. cbn. unfold Model.work; cbn. lra.
  - inversion O as [|c' f cs' fs Oc Os]; subst. cbn [map bounds]. specialize (IH fs Os).
    pose proof (contact_bound (box row) e c In_e law f Oc) as B. rewrite <- Fr in B.
    assert (E : Model.work (Model.sum (Model.contact_wrenches (c :: cs) (f :: fs))) yv =
                Model.work (Model.contact_wrench c f) yv +
                Model.work (Model.sum (Model.contact_wrenches cs fs)) yv).
    { unfold Model.work, Model.sum, Model.contact_wrenches, Model.add; cbn. ring. }
    rewrite E. lra.
Qed.

Lemma load_bound ld g :
  ld = make_load (load_box ld) (load_growth ld) ->
  Forall2 within (load_box ld)
    [Model.along_x (Model.wrench g); Model.along_y (Model.wrench g);
     Model.about_z (Model.wrench g)] ->
  map Q2R (load_growth ld) =
    [Model.along_x (Model.direction g); Model.along_y (Model.direction g);
     Model.about_z (Model.direction g)] ->
  0 <= lambda ->
  IZR m * Model.work (Model.add (Model.wrench g) (Model.scale lambda (Model.direction g))) yv
  <= rdot (load_term m y ld) x.
Proof.
  intros E Hw Hu L. rewrite E. clear E. set (bx := load_box ld) in *.
  set (u := load_growth ld) in *. clearbody bx u. clear ld.
  inversion Hw as [|i1 z1 bx1 t1 W1 Hw1]; subst. inversion Hw1 as [|i2 z2 bx2 t2 W2 Hw2]; subst.
  inversion Hw2 as [|i3 z3 bx3 t3 W3 Hw3]; subst. inversion Hw3; subst. clear Hw Hw1 Hw2 Hw3.
  destruct u as [|u1 [|u2 [|u3 [|? ?]]]]; try discriminate. injection Hu as U1 U2 U3.
  unfold load_term, make_load. cbn [lows_of_w highs_of_w form_of_u load_scaling map].
  set (qs := [low i1; low i2; low i3] ++ [high i1; high i2; high i3] ++ [u1; u2; u3]).
  set (sc := scaling_of qs).
  assert (X : forall q, In q qs -> Q2R q = unit sc * IZR (to_integer sc q))
    by (intros; now apply to_integer_exact).
  pose proof (over_positive qs) as OP. pose proof (times_positive qs) as TP.
  fold sc in OP, TP. apply lt_IZR in OP as OP'.
  assert (UP : 0 < unit sc) by apply unit_positive. apply IZR_lt in m_positive as MP.
  assert (Step : forall z, IZR m * (unit sc * IZR z) <= IZR (up (m * times sc * z) (over sc))).
  { intros z. eapply Rle_trans; [|apply up_above; exact OP']. rewrite !mult_IZR. right.
    unfold unit, Rdiv. ring. }
  assert (One : forall c i z, within i z -> In (low i) qs -> In (high i) qs ->
    IZR c * z <= unit sc * IZR (c * (if (0 <? c)%Z then to_integer sc (high i) else to_integer sc (low i)))).
  { intros c i z [L1 L2] I1 I2. rewrite (X _ I1) in L1. rewrite (X _ I2) in L2. rewrite mult_IZR.
    destruct (Z.ltb_spec 0 c) as [P|P].
    - apply IZR_lt in P. nra.
    - apply IZR_le in P. nra. }
  pose proof (Step (most_work y [to_integer sc (low i1); to_integer sc (low i2); to_integer sc (low i3)]
    [to_integer sc (high i1); to_integer sc (high i2); to_integer sc (high i3)])) as Sw.
  pose proof (Step (dot [to_integer sc u1; to_integer sc u2; to_integer sc u3] y)) as Su.
  set (cw := up _ _) in Sw. set (cu := up _ _) in Su.
  match goal with |- _ <= rdot [0%Z; 0%Z; 0%Z; ?A; ?B] _ => change A with cw; change B with cu end.
  unfold x, located; cbn [rdot]. unfold y in *. cbn [most_work dot] in Sw, Su.
  rewrite !plus_IZR in Sw, Su.
  assert (O1 := One y1 i1 (Model.along_x (Model.wrench g)) W1 ltac:(cbn; tauto) ltac:(cbn; tauto)).
  assert (O2 := One y2 i2 (Model.along_y (Model.wrench g)) W2 ltac:(cbn; tauto) ltac:(cbn; tauto)).
  assert (O3 := One y3 i3 (Model.about_z (Model.wrench g)) W3 ltac:(cbn; tauto) ltac:(cbn; tauto)).
  set (q1 := IZR (y1 * _)) in *. set (q2 := IZR (y2 * _)) in *. set (q3 := IZR (y3 * _)) in *.
  rewrite (X u1) in U1 by (cbn; tauto). rewrite (X u2) in U2 by (cbn; tauto).
  rewrite (X u3) in U3 by (cbn; tauto). rewrite !mult_IZR in Su.
  unfold Model.work, Model.add, Model.scale, yv; cbn. rewrite <- U1, <- U2, <- U3.
  clearbody q1 q2 q3 cw cu.
  set (n1 := IZR (to_integer sc u1)) in *. set (n2 := IZR (to_integer sc u2)) in *.
  set (n3 := IZR (to_integer sc u3)) in *.
  assert (S1 : IZR m * (Model.along_x (Model.wrench g) * IZR y1 + Model.along_y (Model.wrench g) * IZR y2 +
               Model.about_z (Model.wrench g) * IZR y3) <= IZR cw).
  { eapply Rle_trans; [|exact Sw]. apply Rmult_le_compat_l; [lra|]. cbn. lra. }
  assert (S2 : lambda * (IZR m * (unit sc * (n1 * IZR y1 + (n2 * IZR y2 + (n3 * IZR y3))))) <= lambda * IZR cu).
  { apply Rmult_le_compat_l; [exact L|]. cbn in Su. lra. }
  lra.
Qed.

Theorem leaf_refutes rows ld g forces : solution rows ld g lambda d forces ->
  leaf_holds_by m rows ld strict rays y = false.
Proof.
  intros [F LE LW LU L [Ob Bal]]. apply not_true_is_false. intros H. unfold leaf_holds_by in H.
  cbn [y] in H. apply andb_true_iff in H as [_ H]. fold y in H.
  destruct (collect (contact_term m y strict rays) rows (load_term m y ld) []) as [linear bends] eqn:C.
  apply (positive_at_home_positive strict rays x rays_know strict_at_x ws W spanned) in H.
  rewrite (sum_of_values x ws spanned) in H. pose proof (collect_sum x ws spanned _ _ _ _ _ _ C) as S. cbn [bounds] in S.
  pose proof (forces_bound rows _ _ _ F Ob) as FB.
  pose proof (load_bound ld g LE LW LU L) as LB.
  assert (Z : Model.work (Model.add (Model.add (Model.wrench g) (Model.scale lambda (Model.direction g)))
     (Model.sum (Model.contact_wrenches (Model.contacts g) forces))) yv = 0).
  { rewrite Bal. unfold Model.work; cbn. ring. }
  assert (E : forall a b, Model.work (Model.add a b) yv = Model.work a yv + Model.work b yv)
    by (intros; unfold Model.work, Model.add; cbn; ring).
  rewrite E in Z. nra.
Qed.

End Leaf.
