(* SPDX-License-Identifier: MIT *)
(* What a leaf sums up (FORMAT.md section 4): functions on the rays of a region, and terms, of each contact
   one, whose values at a ray bound the work of its force.  What holds of the rays holds of the points that
   they span (`positive_at_home_positive`, `v_nonneg`, `bend_bound`).

   g is computed times a number M > 0, each term rounded up.  It is exact if M is a multiple of all
   denominators, and what is proved holds for every M. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Question Cone Meaning Numbers Box.
From Proved Require Rows.
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

(* ---- Terms ---- *)

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

Definition pull_tips (row : row) : list form := concat (map tips (pulls row)).

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

Lemma nothing_bound : bound Nothing = 0.
Proof. clear. induction ws as [|[w r] ws' IH]; cbn; [reflexivity|]. rewrite IH. lra. Qed.

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
    + cbn [bounds]. rewrite nothing_bound. lra.
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

Section Forms.
Open Scope R_scope.

Lemma rdot_negative f x : rdot (negative f) x = - rdot f x.
Proof.
  revert x. induction f as [|z f IH]; intros [|t x]; cbn; try ring.
  rewrite opp_IZR. unfold negative in IH. rewrite IH. ring.
Qed.

Lemma rdot_all_zero a x : all_zero a = true -> rdot a x = 0.
Proof.
  revert x; induction a as [|z a IH]; intros [|t x]; cbn -[Z.eqb]; try reflexivity.
  intros H. apply andb_true_iff in H as [Hz H]. apply Z.eqb_eq in Hz. subst z.
  rewrite IH by exact H. lra.
Qed.

Lemma rdot_primitive f x : rdot f x = IZR (content f) * rdot (primitive f) x.
Proof.
  unfold primitive. pose proof (content_divides f) as D. destruct (Z.eqb_spec (content f) 1) as [E|_].
  - rewrite E. lra.
  - revert D. generalize (content f) as c. intros c. revert x.
    induction f as [|z f IH]; intros [|t x] D; cbn; try lra.
    rewrite IH by (intros; apply D; now right).
    rewrite (D z) at 1 by now left. rewrite mult_IZR. ring.
Qed.

End Forms.

(* The law of the normal spring at a point at home, by the rays of its region. *)
Section Pull.
Open Scope R_scope.

Variable rays : list ray.
Variables (d : list R) (h l : R).
Let x := h :: l :: d.
Variable ws : list (R * form).
Hypothesis W : weights (map coordinates rays) ws.
Hypothesis spanned : forall a, rdot a x = total a ws.

Variable b : cbox.
Variable r : Rows.row.
Variables (p : list R) (F : list R -> list (list R)) (mu t : R).
Hypothesis I : inside_at b r p F mu t.
Let it := make_row b.
Let v := Rows.v r d h l.

Lemma pull_in e : In e (pull_ends b) -> In (integer_tree (pull_scaling b) (pull_tree b e)) (pulls it).
Proof. intros H. cbn [it pulls make_row]. now apply (in_map (fun e => integer_tree _ (pull_tree b e))). Qed.

Lemma pull_tip_in tree f : In tree (pulls it) -> In f (tips tree) -> In f (pull_tips it).
Proof. intros. apply in_concat. exists (tips tree). split; [now apply in_map | assumption]. Qed.

Lemma pull_unit : 0 < unit (pull_scaling b).
Proof. apply trees_unit_positive. Qed.

(* By the trees, and by their tips alone. *)
Lemma v_by_trees factor U :
  (forall e, In e (pull_ends b) ->
     factor * (unit (pull_scaling b) *
       eval (fun f => rdot f x) (integer_tree (pull_scaling b) (pull_tree b e)) (shares_in b p))
     <= U) -> factor * v <= U.
Proof.
  intros H. apply (v_at_ends b r p F mu t I). intros q u k He.
  rewrite (pull_corners b r p F mu t I q u k h l d He). apply H. exact He.
Qed.

Lemma v_bound factor U :
  (forall f, In f (pull_tips it) -> factor * unit (pull_scaling b) * rdot f x <= U) -> factor * v <= U.
Proof.
  intros H. apply v_by_trees. intros e He. rewrite <- Rmult_assoc, <- eval_multiple.
  apply eval_most; [apply (shares_valid b r p F mu t I)|]. intros f Hf. apply H.
  eapply pull_tip_in; [apply pull_in; eassumption|exact Hf].
Qed.

Lemma v_nonneg : forallb (nowhere_negative rays) (pull_tips it) = true -> 0 <= v.
Proof.
  intros H. rewrite forallb_forall in H. assert (-1 * v <= 0); [|lra]. apply v_bound.
  intros f Hf. pose proof (nowhere_negative_nonneg rays x ws W spanned f (H f Hf)).
  pose proof pull_unit. nra.
Qed.

Lemma v_nonpos : forallb (nowhere_positive rays) (pull_tips it) = true -> v <= 0.
Proof.
  intros H. rewrite forallb_forall in H. rewrite <- (Rmult_1_l v). apply v_bound.
  intros f Hf. pose proof (nowhere_positive_nonpos rays x ws W spanned f (H f Hf)).
  pose proof pull_unit. nra.
Qed.

(* Of one form v. *)
Lemma v_of_one f : pull_tips it = [f] -> v = unit (pull_scaling b) * rdot f x.
Proof.
  intros E. assert (A : forall factor, factor * v <= factor * (unit (pull_scaling b) * rdot f x)).
  { intros c. apply v_bound. rewrite E. intros g [<-|[]]. lra. }
  pose proof (A 1). pose proof (A (-1)). lra.
Qed.

(* Where v is certain, the form that stands for it is not negative if v is not. *)
Lemma separates_nonneg f : separates it = Some f -> 0 <= v -> 0 <= rdot f x.
Proof.
  intros S V. apply Rnot_lt_le. intros L.
  assert (Same : forall g, In g (pull_tips it) -> rdot (primitive g) x = rdot f x).
  { unfold it in S. cbn [separates make_row] in S. unfold pull_tips, it.
    cbn [pulls make_row]. set (tips0 := List.concat _) in *.
    destruct (map primitive tips0) as [|f0 fs] eqn:M; [discriminate|].
    destruct (same_forms (f0 :: fs) && _) eqn:SF; [|discriminate]. apply andb_true_iff in SF as [SF _]. injection S as ->.
    cbn in SF. rewrite forallb_forall in SF. intros g Hg. apply (in_map primitive) in Hg.
    rewrite M in Hg. destruct Hg as [<-|Hg]; [reflexivity|].
    specialize (SF _ Hg). pose proof (rdot_all_zero _ x SF) as Z. rewrite rdot_combine in Z. lra. }
  assert (B : 1 * v <= unit (pull_scaling b) * rdot f x).
  { apply v_bound. intros g Hg. rewrite Rmult_1_l, rdot_primitive, (Same g Hg).
    apply Rmult_le_compat_l; [left; apply pull_unit|].
    pose proof (content_positive g). assert (1 <= IZR (content g)) by (apply IZR_le; lia). nra. }
  pose proof pull_unit. nra.
Qed.

End Pull.
