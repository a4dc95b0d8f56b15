(* SPDX-License-Identifier: MIT *)
(* Bounds of motions, |d_j| <= B_j h (FORMAT.md sections 1, 3 and 4): the simplex around one, to which roots are cut;
   regions beyond it; and points within it, which mixtures of such points are as well. *)
From Coq Require Import List ZArith QArith Qreals Reals Lra Lia Bool.
From Proved Require Import Root Cone Numbers Terms RowLimits.
From Proved Require Rows.
Import ListNotations.

Section Checker.
Open Scope Z_scope.

(* A number above 0 for each coordinate. *)
Definition good_bound (n : nat) (bound : option (list Q)) : bool :=
  match bound with
  | None => true
  | Some most => Nat.eqb (List.length most) n && forallb (fun b => 0 <? Qnum b) most
  end.

(* c B_j h + s d_j up to a factor above 0, for each j and each of these s; as many zeros come first. *)
Fixpoint bound_forms (c : Z) (signs : list Z) (zeros : form) (most : list Q) : list form :=
  match most with
  | [] => []
  | b :: rest =>
      map (fun s => c * Qnum b :: 0 :: zeros ++ [s * Zpos (Qden b)]) signs ++ bound_forms c signs (0 :: zeros) rest
  end.

(* D h - sum d_j / B_j *)
Definition sum_form (most : list Q) : form :=
  let a := inject_Z (Z.of_nat (List.length most)) :: 0%Q :: map (fun b => (- / b)%Q) most in
  map (to_integer (scaling_of a)) a.

(* The simplex. *)
Definition bound_conditions (bound : option (list Q)) : list form :=
  match bound with None => [] | Some most => bound_forms 1 [1] [] most ++ [sum_form most] end.

(* Whether a region is beyond the bound. *)
Definition beyond_bound (bound : option (list Q)) (strict : list (list form)) (rays : list ray) : bool :=
  match bound with
  | None => false
  | Some most => existsb (fun f => positive_at_home strict rays (dot f)) (bound_forms (-1) [1; -1] [] most)
  end.

Fixpoint all_within (h : Z) (most : list Q) (d : form) : bool :=
  match most, d with
  | [], [] => true
  | b :: most', z :: d' => (Z.abs z * Zpos (Qden b) <=? Qnum b * h) && all_within h most' d'
  | _, _ => false
  end.

(* Of a point (h, l, d) in integers. *)
Definition point_within (bound : option (list Q)) (x : form) : bool :=
  match bound, x with
  | None, _ => true
  | Some most, h :: _ :: d => all_within h most d
  | Some _, _ => false
  end.

End Checker.

(* ---- Proofs ---- *)

Open Scope R_scope.

Definition real_bound (bound : option (list Q)) : option (list R) :=
  match bound with None => None | Some most => Some (map Q2R most) end.

Lemma bounded_real bound h d : Rows.bounded (real_bound bound) h d <->
  match bound with None => True | Some most => Forall2 (fun b x => Rabs x <= Q2R b * h) most d end.
Proof.
  destruct bound as [most|]; cbn; [|tauto]. split.
  - revert d. induction most as [|b most IH]; intros d F; inversion F; subst; constructor; auto.
  - induction 1; constructor; assumption.
Qed.

Lemma num_over_den b : IZR (Qnum b) = Q2R b * IZR (Zpos (Qden b)).
Proof. unfold Q2R. field. apply not_0_IZR. discriminate. Qed.

Lemma bound_forms_at c signs h l most d : Forall2 (fun b x => Rabs x <= Q2R b * h) most d ->
  forall e f, In f (bound_forms c signs (repeat 0%Z (List.length e)) most) ->
  exists s b x, In s signs /\ Rabs x <= Q2R b * h /\
    rdot f (h :: l :: e ++ d) = IZR (Zpos (Qden b)) * (IZR c * (Q2R b * h) + IZR s * x).
Proof.
  induction 1 as [|b x most d Hx F IH]; intros e f Hf; cbn [bound_forms] in Hf; [destruct Hf|].
  apply in_app_or in Hf as [Hf|Hf].
  - apply in_map_iff in Hf as (s & <- & Hs). exists s, b, x. split; [exact Hs|]. split; [exact Hx|].
    assert (Z : rdot (repeat 0%Z (List.length e) ++ [(s * Zpos (Qden b))%Z]) (e ++ x :: d) = IZR (s * Zpos (Qden b)) * x).
    { clear. induction e as [|y e IH]; cbn [List.length repeat app rdot]; [ring|]. rewrite IH. ring. }
    cbn [rdot]. rewrite Z, !mult_IZR, num_over_den. ring.
  - change (0%Z :: repeat 0%Z (List.length e)) with (repeat 0%Z (S (List.length e))) in Hf.
    replace (S (List.length e)) with (List.length (e ++ [x])) in Hf by (rewrite app_length; cbn; lia).
    destruct (IH _ _ Hf) as (s & b' & x' & Hs & Hx' & E). exists s, b', x'. split; [exact Hs|]. split; [exact Hx'|].
    rewrite <- E. now rewrite <- app_assoc.
Qed.

Lemma sum_form_nonneg h l most d : 0 <= h -> forallb (fun b => 0 <? Qnum b)%Z most = true ->
  Forall2 (fun b x => Rabs x <= Q2R b * h) most d -> 0 <= rdot (sum_form most) (h :: l :: d).
Proof.
  intros H P F. unfold sum_form. set (a := inject_Z _ :: _).
  pose proof (qdot_to_integers a a (h :: l :: d) (fun q Hq => Hq)) as E.
  pose proof (unit_positive a) as U. apply Rnot_lt_le. intros L.
  assert (S : 0 <= qdot a (h :: l :: d)); [|rewrite E in S; nra].
  clear E U L. unfold a. cbn [qdot].
  replace (Q2R (inject_Z (Z.of_nat (List.length most)))) with (INR (List.length most))
    by (rewrite INR_IZR_INZ; unfold Q2R; cbn; field).
  rewrite Root.Q2R_0. clear a. revert P. induction F as [|b x most d Hx F IH]; intros P; [cbn; lra|].
  cbn [forallb] in P. apply andb_true_iff in P as [Pb P]. apply Z.ltb_lt in Pb. specialize (IH P).
  change (List.length (b :: most)) with (S (List.length most)). rewrite S_INR. cbn [map qdot] in *.
  assert (B : 0 < Q2R b).
  { unfold Q2R. apply Rmult_lt_0_compat; [now apply IZR_lt|]. apply Rinv_0_lt_compat. now apply IZR_lt. }
  assert (NZ : ~ (b == 0)%Q) by (intros Z; apply Qeq_eqR in Z; rewrite Root.Q2R_0 in Z; lra).
  rewrite Q2R_opp, Q2R_inv by exact NZ.
  assert (/ Q2R b * x <= h); [|lra]. apply Rmult_le_reg_l with (Q2R b); [exact B|].
  replace (Q2R b * (/ Q2R b * x)) with x by (field; lra). pose proof (Rle_abs x). lra.
Qed.

(* Points within the bound are in the simplex; *)
Lemma bound_conditions_met bound h l d n : good_bound n bound = true -> 0 <= h -> Rows.bounded (real_bound bound) h d ->
  Forall (fun f => 0 <= rdot f (h :: l :: d)) (bound_conditions bound).
Proof.
  intros G H B. apply bounded_real in B. destruct bound as [most|]; [|constructor]. cbn in G. apply andb_true_iff in G as [_ G].
  apply Forall_app. split; [|constructor; [now apply sum_form_nonneg|constructor]].
  apply Forall_forall. intros f Hf.
  destruct (bound_forms_at 1 [1%Z] h l most d B [] f Hf) as (s & b & x & [<-|[]] & Hx & E). cbn [app] in E. rewrite E.
  assert (0 < IZR (Zpos (Qden b))) by now apply IZR_lt. apply Rmult_le_pos; [lra|].
  pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. lra.
Qed.

(* and no region beyond it has one at home. *)
Lemma nothing_beyond strict rays h l d ws bound : Forall (knows strict) rays ->
  Forall (Exists (fun f => rdot f (h :: l :: d) <> 0)) strict -> weights (map coordinates rays) ws ->
  (forall a, rdot a (h :: l :: d) = total a ws) -> Rows.bounded (real_bound bound) h d ->
  beyond_bound bound strict rays = true -> False.
Proof.
  intros K T W Sp B H. apply bounded_real in B. destruct bound as [most|]; [|discriminate]. cbn in H.
  apply existsb_exists in H as (f & Hf & H).
  apply (positive_at_home_positive strict rays (h :: l :: d) K T ws W Sp) in H.
  rewrite over_rays_dot, <- Sp in H.
  destruct (bound_forms_at (-1) [1%Z; (-1)%Z] h l most d B [] f Hf) as (s & b & x & Hs & Hx & E). cbn [app] in E. rewrite E in H.
  assert (P : 0 < IZR (Zpos (Qden b))) by now apply IZR_lt.
  assert (IZR (-1) * (Q2R b * h) + IZR s * x <= 0).
  { pose proof (Rle_abs x). pose proof (Rle_abs (- x)). rewrite Rabs_Ropp in *. destruct Hs as [<-|[<-|[]]]; lra. }
  nra.
Qed.

Lemma point_within_is bound h l ds : point_within bound (h :: l :: ds) = true ->
  Rows.bounded (real_bound bound) (IZR h) (map IZR ds).
Proof.
  intros H. apply bounded_real. destruct bound as [most|]; [|exact I]. cbn in H. revert ds H.
  induction most as [|b most IH]; intros [|z ds] H; try discriminate; [constructor|].
  cbn in H. apply andb_true_iff in H as [Z H]. cbn [map]. constructor; [|now apply IH].
  apply Z.leb_le, IZR_le in Z. rewrite !mult_IZR, abs_IZR, num_over_den in Z.
  assert (P : 0 < IZR (Zpos (Qden b))) by now apply IZR_lt.
  apply Rmult_le_reg_r with (IZR (Zpos (Qden b))); [exact P|]. lra.
Qed.

(* The bound is convex, and homogeneous. *)
Lemma bounded_mix bound p h d q h' d' : 0 <= p -> 0 <= q -> Rows.bounded bound h d -> Rows.bounded bound h' d' ->
  Rows.bounded bound (p * h + q * h') (Rows.plus (Rows.scaled p d) (Rows.scaled q d')).
Proof.
  intros P Q. destruct bound as [most|]; cbn; [|trivial]. intros F. revert d'.
  induction F as [|b x most d Hx F IH]; intros d' F'; inversion F'; subst; [constructor|]. cbn. constructor; [|now apply IH].
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult, !(Rabs_pos_eq p), !(Rabs_pos_eq q) by assumption. nra.
Qed.

Lemma bounded_multiple bound c h d : 0 <= c -> Rows.bounded bound h d -> Rows.bounded bound (c * h) (Rows.scaled c d).
Proof.
  intros C. destruct bound as [most|]; cbn; [|trivial]. induction 1 as [|b x most d Hx F IH]; cbn; constructor; [|exact IH].
  rewrite Rabs_mult, Rabs_pos_eq by exact C. nra.
Qed.

(* Rest is within it. *)
Lemma bounded_at_rest n bound : good_bound n bound = true -> Rows.bounded (real_bound bound) 1 (listed n (fun _ => 0)).
Proof.
  intros G. apply bounded_real. destruct bound as [most|]; [|exact I]. cbn in G. apply andb_true_iff in G as [L G].
  apply Nat.eqb_eq in L. subst n. induction most as [|b most IH]; cbn in *; [constructor|].
  apply andb_true_iff in G as [Gb G]. constructor; [|now apply IH]. rewrite Rabs_R0, Rmult_1_r.
  apply Z.ltb_lt, IZR_lt in Gb. rewrite num_over_den in Gb.
  assert (P : 0 < IZR (Zpos (Qden b))) by now apply IZR_lt. nra.
Qed.
