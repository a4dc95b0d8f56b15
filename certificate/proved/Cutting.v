(* SPDX-License-Identifier: MIT *)
(* Cutting a cone by a plane: the double description method.  A region is known by its sides, the forms that
   cut it, and by its rays.  The theorem, `cut_described`, is that no point on the right side of the plane is
   lost.  That no ray is superfluous is not proved, and not needed. *)
From Coq Require Import List ZArith Reals Lra Lia Bool.
From Proved Require Import Cone.
Import ListNotations.

Section Cut.
Open Scope Z_scope.

(* Whether all bits of b are in a. *)
Definition contains (a b : Z) : bool := Z.land a b =? b.

(* Rays with the values of the form that cuts. *)
Definition height : Type := Z * ray.
Definition heights (a : form) (rays : list ray) : list height :=
  map (fun r => (dot a (coordinates r), r)) rays.

(* Of p, on which the form is above 0, and another: their combination on which it is 0.  `bit` is that of the form. *)
Definition join_form (p n : form) (at_p at_n : Z) : form := combine at_p n (- at_n) p.

Definition join (bit : Z) (p n : height) : ray :=
  Ray (primitive (join_form (coordinates (snd p)) (coordinates (snd n)) (fst p) (fst n)))
    (both (zeros (snd p)) (zeros (snd n))) (Z.lor (Z.land (tight (snd p)) (tight (snd n))) bit).

(* Whether a ray that is like neither is in the smallest face of both. *)
Definition parted (rays : list ray) (p n : ray) : bool :=
  let common := Z.land (tight p) (tight n) in
  existsb (fun g => contains (tight g) common && negb (tight g =? tight p) && negb (tight g =? tight n)) rays.

(* Whether each ray is by itself in its smallest face, with those like it. *)
Definition distinct (hs : list height) : bool :=
  forallb (fun g => forallb (fun h => negb (contains (tight (snd h)) (tight (snd g))) ||
                                      (tight (snd g) =? tight (snd h))) hs) hs.

Definition stay (bit : Z) (h : height) : ray :=
  let r := snd h in
  if fst h =? 0 then Ray (coordinates r) (zeros r) (Z.lor (tight r) bit) else r.

(* A line is two rays, on which all sides are 0.  One that leaves the plane stays on its side of it, and all else
   is moved along it into the plane. *)
Definition cut_line (bit : Z) (line : height) (hs : list height) : list ray :=
  stay bit line :: filter (fun r => negb (all_zero (coordinates r))) (map (join bit line) hs).

Definition on_side (positive : bool) (hs : list height) : list height :=
  filter (fun h => if positive then 0 <? fst h else fst h <? 0) hs.

Definition cut_rays (bit : Z) (solid : list ray) (hs : list height) : list ray :=
  let below := on_side false hs in
  map (stay bit) (filter (fun h => 0 <=? fst h) hs) ++
  flat_map (fun p => flat_map (fun n => if parted solid (snd p) (snd n) then [] else [join bit p n]) below)
    (on_side true hs).

(* How many combinations a cut may have to make. *)
Definition most_combinations (hs : list height) : Z :=
  let count (l : list height) := fold_left (fun n _ => n + 1) l 0 in
  count hs + count (on_side true hs) * count (on_side false hs).

(* The rays of a region with so many sides; and if they are not as they should be, nothing. *)
Definition cut (count : nat) (hs : list height) : option (list ray) :=
  let bit := Z.shiftl 1 (Z.of_nat count) in
  let is_line (r : ray) := contains (tight r) (bit - 1) in
  match find (fun h => is_line (snd h) && (0 <? fst h)) hs with
  | Some line => Some (cut_line bit line hs)
  | None =>
      if existsb (fun h => is_line (snd h) && (fst h <? 0)) hs then None
      else if distinct (on_side true hs) && distinct (on_side false hs)
      then Some (cut_rays bit (filter (fun r => negb (is_line r)) (map snd hs)) hs)
      else None
  end.

End Cut.

(* Points whose values are at least 0 for some forms F are spanned by `olds`; those of them with at least 0 for
   `a`, too, are spanned by `news`, if these have what is on the right side, and of two rays of both sides the
   combination, unless another ray parts them. *)
Section Description.
Open Scope R_scope.

Variables (F : list form) (a : form) (olds news : list form).
Notation point := (form -> R).
Variable is_point : point -> Prop.
Hypothesis point_sum : forall s x t y, is_point x -> is_point y -> is_point (fun f => s * x f + t * y f).

Definition inside (x : point) := is_point x /\ forall f, In f F -> 0 <= x f.
Definition at_ (r : form) : point := fun f => IZR (dot f r).
Definition solid (x : point) := exists f, In f F /\ 0 < x f.
(* y is in the smallest face of x *)
Definition in_face (x y : point) := forall f, In f F -> x f = 0 -> y f = 0.

Hypothesis olds_span : forall x, inside x -> spans olds x.
Hypothesis olds_inside : forall r, In r olds -> inside (at_ r).
Hypothesis olds_solid : forall r, In r olds -> dot a r <> 0%Z -> solid (at_ r).
Hypothesis some_stay : forall r, In r olds -> (0 <= dot a r)%Z -> spans news (at_ r).

Definition unlike (r g : form) := ~ in_face (at_ r) (at_ g) /\ ~ in_face (at_ g) (at_ r).
Definition joined (p n : form) : point := fun f => at_ p a * at_ n f + - at_ n a * at_ p f.

Hypothesis pairs : forall p n, In p olds -> In n olds -> (0 < dot a p)%Z -> (dot a n < 0)%Z ->
  spans news (joined p n) \/
  exists g, In g olds /\ solid (at_ g) /\ in_face (joined p n) (at_ g) /\
    ((0 < dot a g)%Z -> unlike p g) /\ ((dot a g < 0)%Z -> unlike n g).

Definition is_above (x : point) (f : form) : bool := if Rlt_dec 0 (x f) then true else false.
Definition loose (x : point) : nat := List.length (filter (is_above x) F).

Lemma filter_less (P Q : form -> bool) l : (forall f, In f l -> Q f = true -> P f = true) ->
  (List.length (filter Q l) <= List.length (filter P l))%nat /\
  ((exists f, In f l /\ P f = true /\ Q f = false) ->
   List.length (filter Q l) < List.length (filter P l))%nat.
Proof.
  induction l as [|f l IH]; intros H; cbn; [split; [lia|intros (? & [] & _)]|].
  destruct IH as [I1 I2]; [intros; apply H; [now right|assumption]|].
  pose proof (H f (or_introl eq_refl)) as Hf. destruct (Q f) eqn:Qf.
  - rewrite Hf by reflexivity. cbn. split; [lia|]. intros (g & [<-|G] & Pg & Qg); [congruence|].
    assert (exists f, In f l /\ P f = true /\ Q f = false) by eauto. specialize (I2 H0). lia.
  - destruct (P f) eqn:Pf; cbn.
    + split; intros; lia.
    + split; [exact I1|]. intros (g & [<-|G] & Pg & Qg); [congruence|]. apply I2. eauto.
Qed.

Lemma loose_le x y : inside x -> in_face x y -> (loose y <= loose x)%nat.
Proof.
  intros [_ X] T. apply filter_less. unfold is_above. intros f Hf.
  destruct (Rlt_dec 0 (y f)) as [Y|]; [|discriminate]. intros _.
  destruct (Rlt_dec 0 (x f)) as [|N]; [reflexivity|]. specialize (X f Hf). rewrite (T f Hf) in Y by lra. lra.
Qed.

Lemma loose_lt x y : inside x -> in_face x y -> (exists f, In f F /\ 0 < x f /\ y f = 0) -> (loose y < loose x)%nat.
Proof.
  intros [_ X] T (f & Hf & P & Z). unfold loose. apply filter_less.
  - unfold is_above. intros g Hg. destruct (Rlt_dec 0 (y g)) as [Y|]; [|discriminate]. intros _.
    destruct (Rlt_dec 0 (x g)) as [|N]; [reflexivity|]. specialize (X g Hg). rewrite (T g Hg) in Y by lra. lra.
  - exists f. split; [exact Hf|]. unfold is_above. destruct (Rlt_dec 0 (x f)); [|lra].
    destruct (Rlt_dec 0 (y f)); [lra|]. auto.
Qed.

Lemma least_ratio (x y : point) l : (exists f, In f l /\ 0 < y f) ->
  exists f, In f l /\ 0 < y f /\ forall g, In g l -> 0 < y g -> x f / y f <= x g / y g.
Proof.
  induction l as [|f l IH]; intros (f0 & H & P); [destruct H|].
  destruct (Exists_dec (fun f => 0 < y f) l (fun f => Rlt_dec 0 (y f))) as [E|E].
  - apply Exists_exists in E. destruct (IH E) as (g & Hg & Pg & L).
    destruct (Rlt_dec 0 (y f)) as [Pf|Nf].
    + destruct (Rle_dec (x f / y f) (x g / y g)) as [Le|Gt].
      * exists f. split; [now left|]. split; [exact Pf|]. intros h [<-|Hh] Ph; [lra|]. specialize (L h Hh Ph). lra.
      * exists g. split; [now right|]. split; [exact Pg|]. intros h [<-|Hh] Ph; [lra|auto].
    + exists g. split; [now right|]. split; [exact Pg|]. intros h [<-|Hh] Ph; [lra|auto].
  - assert (N : forall g, In g l -> 0 < y g -> False).
    { intros g Hg Pg. apply E, Exists_exists. eauto. }
    destruct H as [<-|H]; [|now destruct (N f0 H P)].
    exists f. split; [now left|]. split; [exact P|]. intros h [<-|Hh] Ph; [lra|now destruct (N h Hh Ph)].
Qed.

Definition minus (x : point) (e : R) (y : point) : point := fun f => 1 * x f + - e * y f.

(* From x against y until one more form is 0. *)
Lemma recede x y : inside x -> inside y -> in_face x y -> solid y -> exists e, 0 < e /\
  inside (minus x e y) /\ (loose (minus x e y) < loose x)%nat.
Proof.
  intros X Y T S. destruct (least_ratio x y F S) as (f & Hf & Pf & L).
  assert (Xf : 0 < x f).
  { destruct X as [_ X]. specialize (X f Hf). destruct (Req_dec (x f) 0) as [Z|]; [|lra].
    rewrite (T f Hf Z) in Pf. lra. }
  exists (x f / y f). set (e := x f / y f) in *. assert (E : 0 < e) by now apply Rdiv_lt_0_compat.
  split; [exact E|]. split.
  - split; [apply point_sum; [apply X|apply Y]|]. intros g Hg. unfold minus.
    destruct X as [_ X], Y as [_ Y]. specialize (X g Hg). specialize (Y g Hg).
    destruct (Req_dec (y g) 0) as [Z|N]; [rewrite Z; lra|].
    assert (Pg : 0 < y g) by lra. specialize (L g Hg Pg). fold e in L.
    apply (Rmult_le_compat_r (y g)) in L; [|lra]. unfold Rdiv in L. rewrite Rmult_assoc, Rinv_l in L by lra. lra.
  - apply loose_lt; [exact X| |].
    + intros g Hg Z. unfold minus. rewrite Z, (T g Hg Z). ring.
    + exists f. split; [exact Hf|]. split; [exact Xf|]. unfold minus, e. field. lra.
Qed.

Lemma spans_parts (x y : point) s t : 0 <= s -> 0 <= t -> spans news x -> spans news y ->
  spans news (fun f => s * x f + t * y f).
Proof. intros S T X Y. apply spans_sum; now apply spans_multiple. Qed.

Lemma joined_inside p n : inside (at_ p) -> inside (at_ n) -> (0 < dot a p)%Z -> (dot a n < 0)%Z ->
  inside (joined p n) /\ joined p n a = 0.
Proof.
  intros [P1 P2] [N1 N2] A B. apply IZR_lt in A, B. split; [split; [now apply point_sum|]|].
  - intros f Hf. specialize (P2 f Hf). specialize (N2 f Hf). unfold joined, at_ in *.
    apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra.
  - unfold joined, at_. ring.
Qed.

Lemma joined_zero p n f : (0 < dot a p)%Z -> (dot a n < 0)%Z -> 0 <= at_ p f -> 0 <= at_ n f ->
  joined p n f = 0 -> at_ p f = 0 /\ at_ n f = 0.
Proof.
  intros A B P N. apply IZR_lt in A, B. unfold joined, at_ in *. intros Z.
  assert (0 <= IZR (dot a p) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
  assert (0 <= - IZR (dot a n) * IZR (dot f p)) by (apply Rmult_le_pos; lra).
  split; apply Rmult_eq_reg_l with (IZR (dot a p) * - IZR (dot a n)); nra.
Qed.

(* All points that have fewer loose forms are spanned. *)
Section Step.
Variable m : nat.
Hypothesis smaller : forall x, inside x -> 0 <= x a -> (loose x < m)%nat -> spans news x.

(* A point of the plane is spanned, if another in its smallest face is not a multiple. *)
Lemma beside x y : inside x -> x a = 0 -> (loose x <= m)%nat -> solid x ->
  inside y -> y a = 0 -> solid y -> in_face x y ->
  (forall c, 0 < c -> (forall f, In f F -> x f = c * y f) -> False) -> spans news x.
Proof.
  intros X Xa Lx Sx Y Ya Sy T No.
  destruct (recede x y X Y T Sy) as (e & E & I & L).
  assert (G : spans news (minus x e y)).
  { apply smaller; [exact I| |lia]. unfold minus. rewrite Xa, Ya. lra. }
  destruct (Exists_dec (fun f => 0 < x f /\ y f = 0) F) as [Ex|NEx].
  { intros f. destruct (Rlt_dec 0 (x f)) as [P|P]; [|right; tauto].
    destruct (Req_EM_T (y f) 0) as [Z|Z]; [left; tauto|right; tauto]. }
  - assert (Gy : spans news y).
    { apply smaller; [exact Y|lra|]. apply Nat.lt_le_trans with (loose x); [|exact Lx].
      apply loose_lt; [exact X|exact T|]. apply Exists_exists in Ex as (f & Hf & P). eauto. }
    apply spans_same with (fun f => 1 * minus x e y f + e * y f); [unfold minus; intros; ring|].
    apply spans_parts; lra || assumption.
  - assert (T' : in_face y x).
    { intros f Hf Z. destruct (Req_dec (x f) 0) as [|N]; [assumption|]. exfalso. apply NEx, Exists_exists.
      exists f. split; [exact Hf|]. split; [|exact Z]. destruct X as [_ X]. specialize (X f Hf). lra. }
    destruct (recede y x Y X T' Sx) as (e' & E' & I' & L').
    assert (G' : spans news (minus y e' x)).
    { apply smaller; [exact I'| |].
      - unfold minus. rewrite Xa, Ya. lra.
      - pose proof (loose_le x y X T). lia. }
    assert (EE : e * e' < 1).
    { destruct (Rlt_dec (e * e') 1) as [|N]; [assumption|]. exfalso. apply (No e E). intros f Hf.
      destruct I as [_ I], I' as [_ I'], X as [_ X]. specialize (I f Hf). specialize (I' f Hf). specialize (X f Hf).
      unfold minus in *. assert (e * (1 * y f + - e' * x f) >= 0) by (apply Rle_ge, Rmult_le_pos; lra).
      assert ((e * e' - 1) * x f >= 0) by (apply Rle_ge, Rmult_le_pos; lra). lra. }
    apply spans_same with (fun f => / (1 - e * e') * minus x e y f + e / (1 - e * e') * minus y e' x f).
    + intros f. unfold minus. field. lra.
    + assert (0 < / (1 - e * e')) by (apply Rinv_0_lt_compat; lra).
      apply spans_parts; try assumption; [lra|]. unfold Rdiv. apply Rmult_le_pos; lra.
Qed.

Lemma joined_spanned p n : In p olds -> In n olds -> (0 < dot a p)%Z -> (dot a n < 0)%Z ->
  (loose (joined p n) <= m)%nat -> spans news (joined p n).
Proof.
  intros Hp Hn A B L. destruct (pairs p n Hp Hn A B) as [G|(g & Hg & Sg & T & U1 & U2)]; [exact G|].
  pose proof (olds_inside p Hp) as Ip. pose proof (olds_inside n Hn) as In_. pose proof (olds_inside g Hg) as Ig.
  destruct (joined_inside p n Ip In_ A B) as [J Ja]. set (j := joined p n) in *.
  assert (A' := A). assert (B' := B). apply IZR_lt in A', B'.
  assert (Sj : solid j).
  { destruct (olds_solid p Hp ltac:(lia)) as (f & Hf & P). exists f. split; [exact Hf|].
    destruct In_ as [_ N]. specialize (N f Hf). unfold j, joined, at_ in *.
    assert (0 <= IZR (dot a p) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
    assert (0 < - IZR (dot a n) * IZR (dot f p)) by (apply Rmult_lt_0_compat; lra). lra. }
  assert (Nonneg : forall r f, inside (at_ r) -> In f F -> 0 <= IZR (dot f r)) by (intros r f [_ I] Hf; exact (I f Hf)).
  destruct (Z.lt_trichotomy (dot a g) 0) as [G|[G|G]].
  - (* p and g *)
    destruct (U2 G) as [U3 U4]. destruct (joined_inside p g Ip Ig A G) as [K Ka]. assert (G' := G). apply IZR_lt in G'.
    apply (beside j (joined p g)); try assumption.
    + destruct Sg as (f & Hf & P). exists f. split; [exact Hf|]. pose proof (Nonneg p f Ip Hf). unfold joined, at_ in *.
      assert (0 <= - IZR (dot a g) * IZR (dot f p)) by (apply Rmult_le_pos; lra).
      assert (0 < IZR (dot a p) * IZR (dot f g)) by (apply Rmult_lt_0_compat; lra). lra.
    + intros f Hf Z. pose proof (T f Hf Z) as Zg.
      destruct (joined_zero p n f A B (Nonneg p f Ip Hf) (Nonneg n f In_ Hf) Z) as [Zp _].
      unfold joined. rewrite Zp, Zg. ring.
    + intros c C E.
      assert (E' : forall f, In f F -> IZR (dot a p) * IZR (dot f n) + (- IZR (dot a n) - c * - IZR (dot a g)) * IZR (dot f p)
        = c * IZR (dot a p) * IZR (dot f g)).
      { intros f Hf. specialize (E f Hf). unfold j, joined, at_ in E. lra. }
      assert (CA : 0 < c * IZR (dot a p)) by now apply Rmult_lt_0_compat.
      destruct (Rle_dec 0 (- IZR (dot a n) - c * - IZR (dot a g))) as [D|D].
      * apply U4. intros f Hf Z. specialize (E' f Hf). unfold at_ in *. rewrite Z, Rmult_0_r in E'.
        pose proof (Nonneg n f In_ Hf). pose proof (Nonneg p f Ip Hf).
        assert (0 <= (- IZR (dot a n) - c * - IZR (dot a g)) * IZR (dot f p)) by now apply Rmult_le_pos.
        assert (0 <= IZR (dot a p) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
        apply Rmult_eq_reg_l with (IZR (dot a p)); lra.
      * apply U3. intros f Hf Z. specialize (E' f Hf). unfold at_ in *. rewrite Z, Rmult_0_r in E'.
        pose proof (Nonneg g f Ig Hf). pose proof (Nonneg p f Ip Hf).
        assert (0 <= - (- IZR (dot a n) - c * - IZR (dot a g)) * IZR (dot f p)) by (apply Rmult_le_pos; lra).
        assert (0 <= c * IZR (dot a p) * IZR (dot f g)) by (apply Rmult_le_pos; lra).
        apply Rmult_eq_reg_l with (c * IZR (dot a p)); lra.
  - (* g itself *)
    destruct (recede j (at_ g) J Ig T Sg) as (e & E & I & Le).
    apply spans_same with (fun f => 1 * minus j e (at_ g) f + e * at_ g f); [unfold minus; intros; ring|].
    apply spans_parts; try lra.
    + apply smaller; [exact I| |lia]. unfold minus. rewrite Ja. unfold at_. rewrite G. lra.
    + apply some_stay; [exact Hg|lia].
  - (* g and n *)
    destruct (U1 G) as [U3 U4]. destruct (joined_inside g n Ig In_ G B) as [K Ka]. assert (G' := G). apply IZR_lt in G'.
    apply (beside j (joined g n)); try assumption.
    + destruct Sg as (f & Hf & P). exists f. split; [exact Hf|]. pose proof (Nonneg n f In_ Hf). unfold joined, at_ in *.
      assert (0 <= IZR (dot a g) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
      assert (0 < - IZR (dot a n) * IZR (dot f g)) by (apply Rmult_lt_0_compat; lra). lra.
    + intros f Hf Z. pose proof (T f Hf Z) as Zg.
      destruct (joined_zero p n f A B (Nonneg p f Ip Hf) (Nonneg n f In_ Hf) Z) as [_ Zn].
      unfold joined. rewrite Zn, Zg. ring.
    + intros c C E. set (b := - IZR (dot a n)) in *. assert (Bp : 0 < b) by (unfold b; lra).
      assert (E' : forall f, In f F -> (IZR (dot a p) - c * IZR (dot a g)) * IZR (dot f n) + b * IZR (dot f p)
        = c * b * IZR (dot f g)).
      { intros f Hf. specialize (E f Hf). unfold j, joined, at_ in E. fold b in E. lra. }
      assert (CB : 0 < c * b) by now apply Rmult_lt_0_compat.
      destruct (Rle_dec 0 (IZR (dot a p) - c * IZR (dot a g))) as [D|D].
      * apply U4. intros f Hf Z. specialize (E' f Hf). unfold at_ in *. rewrite Z, Rmult_0_r in E'.
        pose proof (Nonneg n f In_ Hf). pose proof (Nonneg p f Ip Hf).
        assert (0 <= (IZR (dot a p) - c * IZR (dot a g)) * IZR (dot f n)) by now apply Rmult_le_pos.
        assert (0 <= b * IZR (dot f p)) by (apply Rmult_le_pos; lra).
        apply Rmult_eq_reg_l with b; lra.
      * apply U3. intros f Hf Z. specialize (E' f Hf). unfold at_ in *. rewrite Z, Rmult_0_r in E'.
        pose proof (Nonneg n f In_ Hf). pose proof (Nonneg g f Ig Hf).
        assert (0 <= - (IZR (dot a p) - c * IZR (dot a g)) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
        assert (0 <= c * b * IZR (dot f g)) by (apply Rmult_le_pos; lra).
        apply Rmult_eq_reg_l with (c * b); lra.
Qed.

Lemma weight_zero ws f w r : weights olds ws -> (forall r, In r olds -> 0 <= at_ r f) -> total f ws = 0 ->
  In (w, r) ws -> 0 < w -> at_ r f = 0.
Proof.
  intros W N. induction W as [|[w' r'] ws [Hw Hr] W IH]; cbn; [intros _ []|]. cbn in Hw, Hr. intros Z.
  assert (T : 0 <= total f ws).
  { clear -W N. induction W as [|[w r] ws [Hw Hr] W IH]; cbn; [lra|]. cbn in *. pose proof (N r Hr).
    assert (0 <= w * IZR (dot f r)) by now apply Rmult_le_pos. lra. }
  pose proof (N r' Hr) as N'. unfold at_ in *. assert (0 <= w' * IZR (dot f r')) by now apply Rmult_le_pos.
  intros [E|In_] P; [|apply IH; [lra|exact In_|exact P]]. injection E as -> ->.
  apply Rmult_eq_reg_l with w; lra.
Qed.

Lemma step x : inside x -> 0 <= x a -> (loose x <= m)%nat -> spans news x.
Proof.
  intros X Xa L. destruct (olds_span x X) as (ws & W & E).
  assert (Dec : forall sign, {Exists (fun p => 0 < fst p /\ (0 < sign * dot a (snd p))%Z) ws} +
                             {~ Exists (fun p => 0 < fst p /\ (0 < sign * dot a (snd p))%Z) ws}).
  { intros sign. apply Exists_dec. intros [w r]; cbn. destruct (Rlt_dec 0 w); [|right; tauto].
    destruct (Z_lt_dec 0 (sign * dot a r)); [left; tauto|right; tauto]. }
  destruct (Dec (-1)%Z) as [Ex|NEx].
  - destruct (Dec 1%Z) as [Ep|NEp].
    + apply Exists_exists in Ex as ([w n] & Hn & Wn & Sn). apply Exists_exists in Ep as ([w' p] & Hp & Wp & Sp).
      cbn [fst snd] in Wn, Sn, Wp, Sp. assert (A : (0 < dot a p)%Z) by lia. assert (B : (dot a n < 0)%Z) by lia.
      assert (W' := W). unfold weights in W'. rewrite Forall_forall in W'.
      assert (In_n : In n olds) by apply (W' _ Hn). assert (In_p : In p olds) by apply (W' _ Hp).
      destruct (joined_inside p n (olds_inside p In_p) (olds_inside n In_n) A B) as [J Ja].
      assert (T : in_face x (joined p n)).
      { intros f Hf Z. rewrite E in Z.
        assert (N : forall r, In r olds -> 0 <= at_ r f) by (intros r Hr; now apply olds_inside).
        unfold joined. rewrite (weight_zero ws f w n W N Z Hn Wn), (weight_zero ws f w' p W N Z Hp Wp). ring. }
      assert (Lj : (loose (joined p n) <= m)%nat) by (pose proof (loose_le x _ X T); lia).
      assert (Sj : solid (joined p n)).
      { destruct (olds_solid p In_p ltac:(lia)) as (f & Hf & P). exists f. split; [exact Hf|].
        pose proof (proj2 (olds_inside n In_n) f Hf). apply IZR_lt in A, B. unfold joined, at_ in *.
        assert (0 <= IZR (dot a p) * IZR (dot f n)) by (apply Rmult_le_pos; lra).
        assert (0 < - IZR (dot a n) * IZR (dot f p)) by (apply Rmult_lt_0_compat; lra). lra. }
      destruct (recede x (joined p n) X J T Sj) as (e & E0 & I & Le).
      apply spans_same with (fun f => 1 * minus x e (joined p n) f + e * joined p n f);
        [unfold minus; intros; ring|].
      apply spans_parts; try lra.
      * apply smaller; [exact I| |lia]. unfold minus. rewrite Ja. lra.
      * now apply joined_spanned.
    + exfalso. assert (T : total a ws < 0); [|rewrite E in Xa; lra]. clear E Xa L X.
      assert (NP : forall p, In p ws -> fst p * IZR (dot a (snd p)) <= 0).
      { intros [w r] H. cbn. unfold weights in W. rewrite Forall_forall in W. destruct (W _ H) as [Hw _]. cbn in Hw.
        destruct (Rle_dec w 0) as [Z|P]; [replace w with 0 by lra; lra|].
        destruct (Z.le_gt_cases (dot a r) 0) as [Z|Z].
        - apply IZR_le in Z. nra.
        - destruct NEp. apply Exists_exists. exists (w, r). cbn [fst snd]. split; [exact H|]. split; [lra|lia]. }
      clear NEp W Dec. induction Ex as [[w r] ws [Hw Hs]|[w r] ws Ex IH]; cbn [fst snd total] in *.
      * assert (B : (dot a r < 0)%Z) by lia. apply IZR_lt in B.
        assert (T : total a ws <= 0).
        { clear -NP. induction ws as [|[w' r'] ws IH]; cbn; [lra|]. pose proof (NP (w', r') ltac:(cbn; auto)) as N1.
          cbn [fst snd] in N1. enough (total a ws <= 0) by lra. apply IH. intros q [<-|Hq]; apply NP; [now left|right; now right]. }
        assert (w * - IZR (dot a r) > 0) by (apply Rmult_lt_0_compat; lra). lra.
      * assert (T : total a ws < 0) by (apply IH; intros q Hq; apply NP; now right). pose proof (NP (w, r) (or_introl eq_refl)). cbn in *. lra.
  - apply spans_same with (fun f => total f ws); [intros; now rewrite E|]. clear E Xa L X.
    induction W as [|[w r] ws [Hw Hr] W IH]; [apply spans_zero|]. cbn. cbn in Hw, Hr. apply spans_sum.
    + destruct (Rle_dec w 0) as [Z|P].
      * apply spans_same with (fun _ => 0); [|apply spans_zero]. intros f. replace w with 0 by lra. ring.
      * apply spans_multiple; [exact Hw|]. apply some_stay; [exact Hr|].
        destruct (Z.le_gt_cases 0 (dot a r)) as [|N]; [assumption|]. destruct NEx. apply Exists_cons_hd. cbn [fst snd].
        split; [lra|lia].
    + apply IH; [|intros N; apply NEx; now apply Exists_cons_tl].
      intros sign. apply Exists_dec. intros [w' r']; cbn. destruct (Rlt_dec 0 w'); [|right; tauto].
      destruct (Z_lt_dec 0 (sign * dot a r')); [left; tauto|right; tauto].
Qed.

End Step.

Theorem news_span x : inside x -> 0 <= x a -> spans news x.
Proof.
  assert (G : forall m x, inside x -> 0 <= x a -> (loose x < m)%nat -> spans news x).
  { induction m as [|m IH]; intros y Y Ya L; [lia|]. apply (step m IH y Y Ya). lia. }
  intros X Xa. apply (G (S (loose x))); [exact X|exact Xa|lia].
Qed.

End Description.

(* ---- Regions by sides and by rays ---- *)

(* s x + t y; the shorter is continued by zeros. *)
Fixpoint mix (s : R) (x : list R) (t : R) (y : list R) : list R :=
  match x, y with
  | u :: x', v :: y' => (s * u + t * v)%R :: mix s x' t y'
  | [], _ => map (Rmult t) y
  | _, [] => map (Rmult s) x
  end.

Lemma rdot_nil a : rdot a [] = 0%R.
Proof. now destruct a. Qed.

Lemma rdot_multiple a t x : rdot a (map (Rmult t) x) = (t * rdot a x)%R.
Proof. revert a. induction x as [|u x IH]; intros [|c a]; cbn; try ring. rewrite IH. ring. Qed.

Lemma rdot_mix a s x t y : rdot a (mix s x t y) = (s * rdot a x + t * rdot a y)%R.
Proof.
  revert a y. induction x as [|u x IH]; intros a [|v y].
  - cbn. rewrite !rdot_nil. ring.
  - change (mix s [] t (v :: y)) with (map (Rmult t) (v :: y)). rewrite rdot_multiple, rdot_nil. ring.
  - change (mix s (u :: x) t []) with (map (Rmult s) (u :: x)). rewrite rdot_multiple, rdot_nil. ring.
  - destruct a as [|c a]; cbn; [ring|]. rewrite IH. ring.
Qed.

Lemma mix_length s x t y n : List.length x <= n -> List.length y <= n -> List.length (mix s x t y) <= n.
Proof.
  revert y n. induction x as [|u x IH]; intros [|v y] n X Y; cbn in *; rewrite ?map_length; try lia.
  destruct n; [lia|]. specialize (IH y n). lia.
Qed.

Lemma combine_length p a q b n : List.length a <= n -> List.length b <= n -> List.length (combine p a q b) <= n.
Proof.
  revert b n. induction a as [|u a IH]; intros [|v b] n X Y; cbn in *; rewrite ?map_length; try lia.
  destruct n; [lia|]. specialize (IH b n). lia.
Qed.

Lemma primitive_length x : List.length (primitive x) = List.length x.
Proof. unfold primitive. destruct (_ =? _)%Z; [reflexivity|]. now rewrite map_length. Qed.

(* Of vectors of at most n numbers. *)
Definition is_point (n : nat) (p : form -> R) := exists x, List.length x <= n /\ forall a, p a = rdot a x.

Lemma is_point_sum n s x t y : is_point n x -> is_point n y -> is_point n (fun f => s * x f + t * y f)%R.
Proof.
  intros (u & U & EU) (v & V & EV). exists (mix s u t v). split; [now apply mix_length|].
  intros a. now rewrite rdot_mix, EU, EV.
Qed.

Lemma rdot_of_integers a r : rdot a (map IZR r) = IZR (dot a r).
Proof. revert a. induction r as [|y r IH]; intros [|c a]; cbn; try reflexivity. now rewrite IH, plus_IZR, mult_IZR. Qed.

(* What the bits of a ray say. *)
Definition marks (sides : list form) (t : Z) (x : form) := forall i,
  Z.testbit t (Z.of_nat i) = match nth_error sides i with Some f => (dot f x =? 0)%Z | None => false end.

Record fits (n : nat) (sides : list form) (r : ray) : Prop := Fits {
  fits_length : List.length (coordinates r) <= n;
  on_sides : forall f, In f sides -> (0 <= dot f (coordinates r))%Z;
  marked : marks sides (tight r) (coordinates r)
}.

(* The rays are where all sides are 0 or more, and span it. *)
Record described (n : nat) (sides : list form) (rays : list ray) : Prop := Described {
  all_fit : Forall (fits n sides) rays;
  all_spanned : forall x, List.length x <= n -> (forall f, In f sides -> (0 <= rdot f x)%R) ->
    spans (map coordinates rays) (fun a => rdot a x)
}.

Section Bits.
Open Scope Z_scope.
Variable sides : list form.
Let k := List.length sides.

Lemma same_bits s t : (forall i, Z.testbit s (Z.of_nat i) = Z.testbit t (Z.of_nat i)) -> s = t.
Proof. intros H. apply Z.bits_inj'. intros i I. rewrite <- (Z2Nat.id i I). apply H. Qed.

Lemma contains_bit a b i : contains a b = true -> Z.testbit b i = true -> Z.testbit a i = true.
Proof.
  unfold contains. intros C B. apply Z.eqb_eq in C. rewrite <- C, Z.land_spec in B. now apply andb_true_iff in B.
Qed.

(* Bits of faces. *)
Lemma contains_zero s t x y f : marks sides s x -> marks sides t y -> contains t s = true -> In f sides ->
  dot f x = 0 -> dot f y = 0.
Proof.
  intros S T C H Z. apply In_nth_error in H as (i & H). pose proof (S i) as Si. pose proof (T i) as Ti.
  rewrite H in Si, Ti. rewrite Z in Si. cbn in Si. apply (contains_bit t s (Z.of_nat i) C) in Si. rewrite Si in Ti.
  now apply Z.eqb_eq.
Qed.

Lemma zero_contains s t x y : marks sides s x -> marks sides t y ->
  (forall f, In f sides -> dot f x = 0 -> dot f y = 0) -> contains t s = true.
Proof.
  intros S T H. unfold contains. apply Z.eqb_eq, same_bits. intros i. rewrite Z.land_spec, S, T.
  destruct (nth_error sides i) as [f|] eqn:E; [|reflexivity]. apply nth_error_In in E. specialize (H f E).
  destruct (Z.eqb_spec (dot f x) 0) as [Z|Z]; [|apply andb_false_r]. rewrite (H Z). reflexivity.
Qed.

Lemma both_marks s t x y : marks sides s x -> marks sides t y ->
  forall f i, nth_error sides i = Some f -> Z.testbit (Z.land s t) (Z.of_nat i) = (dot f x =? 0) && (dot f y =? 0).
Proof. intros S T f i E. rewrite Z.land_spec, S, T, E. reflexivity. Qed.

Lemma line_bits : Z.shiftl 1 (Z.of_nat k) - 1 = Z.ones (Z.of_nat k).
Proof. rewrite Z.shiftl_1_l, Z.ones_equiv. lia. Qed.

Lemma line_zero t x : marks sides t x -> contains t (Z.shiftl 1 (Z.of_nat k) - 1) = true ->
  forall f, In f sides -> dot f x = 0.
Proof.
  rewrite line_bits. intros T C f H. apply In_nth_error in H as (i & H).
  assert (I : (i < k)%nat) by (apply nth_error_Some; congruence).
  assert (B : Z.testbit t (Z.of_nat i) = true).
  { apply (contains_bit _ _ _ C). apply Z.ones_spec_low. lia. }
  pose proof (T i) as Ti. rewrite H, B in Ti. symmetry in Ti. now apply Z.eqb_eq.
Qed.

Lemma zero_line t x : marks sides t x -> (forall f, In f sides -> dot f x = 0) ->
  contains t (Z.shiftl 1 (Z.of_nat k) - 1) = true.
Proof.
  rewrite line_bits. intros T H. unfold contains. apply Z.eqb_eq, same_bits. intros i. rewrite Z.land_spec, T.
  destruct (nth_error sides i) as [f|] eqn:E.
  - rewrite (H f) by (eapply nth_error_In; exact E). reflexivity.
  - apply nth_error_None in E. rewrite Z.ones_spec_high by (fold k in E; lia). reflexivity.
Qed.

(* One side more. *)
Lemma new_marks a t x : (forall i f, nth_error sides i = Some f -> Z.testbit t (Z.of_nat i) = (dot f x =? 0)) ->
  (forall i, (k < i)%nat -> Z.testbit t (Z.of_nat i) = false) -> Z.testbit t (Z.of_nat k) = (dot a x =? 0) ->
  marks (sides ++ [a]) t x.
Proof.
  intros H High Last i. destruct (Nat.lt_trichotomy i k) as [L|[->|L]].
  - rewrite nth_error_app1 by exact L. destruct (nth_error sides i) as [f|] eqn:E; [now apply H|].
    apply nth_error_None in E. fold k in E. lia.
  - rewrite nth_error_app2 by apply Nat.le_refl. unfold k at 2. rewrite Nat.sub_diag. exact Last.
  - rewrite nth_error_app2 by (unfold k in L; lia). destruct (i - List.length sides)%nat as [|[|j]] eqn:E;
      try (unfold k in L; lia); now apply High.
Qed.

Lemma beyond t x i : marks sides t x -> (k <= i)%nat -> Z.testbit t (Z.of_nat i) = false.
Proof. intros T L. rewrite T. apply nth_error_None in L. now rewrite L. Qed.

Lemma bit_at i : Z.testbit (Z.shiftl 1 (Z.of_nat k)) (Z.of_nat i) = Nat.eqb i k.
Proof.
  rewrite Z.shiftl_1_l, Z.pow2_bits_eqb by lia. destruct (Nat.eqb_spec i k) as [->|N]; [apply Z.eqb_refl|].
  apply Z.eqb_neq. lia.
Qed.
End Bits.

Section CutProof.
Variables (n : nat) (sides : list form) (rays : list ray) (a : form).
Hypothesis D : described n sides rays.
Let k := List.length sides.
Let bit := Z.shiftl 1 (Z.of_nat k).
Let hs := heights a rays.
Let more := sides ++ [a].

Lemma in_heights h : In h hs -> In (snd h) rays /\ fst h = dot a (coordinates (snd h)).
Proof. intros H. apply in_map_iff in H as (r & <- & H). now split. Qed.

Lemma fit_of r : In r rays -> fits n sides r.
Proof. pose proof (all_fit _ _ _ D) as S. rewrite Forall_forall in S. auto. Qed.

Lemma in_more f : In f more <-> In f sides \/ f = a.
Proof. unfold more. rewrite in_app_iff. cbn. intuition. Qed.

Lemma stay_fits h : In h hs -> (0 <= fst h)%Z -> fits n more (stay bit h).
Proof.
  intros H P. destruct (in_heights _ H) as [Hr E]. destruct (fit_of _ Hr) as [L I M].
  assert (C : coordinates (stay bit h) = coordinates (snd h)) by (unfold stay; now destruct (fst h =? 0)%Z).
  constructor; rewrite ?C.
  - exact L.
  - intros f Hf. apply in_more in Hf as [Hf| ->]; [auto|lia].
  - unfold stay. rewrite E. apply new_marks; fold k.
    + intros i f Hi. destruct (_ =? 0)%Z; cbn [tight]; rewrite ?Z.lor_spec, M, Hi; [|reflexivity].
      unfold bit, k. rewrite bit_at. assert (i < k) by (apply nth_error_Some; congruence).
      replace (Nat.eqb i (List.length sides)) with false by (symmetry; apply Nat.eqb_neq; unfold k in *; lia).
      apply orb_false_r.
    + intros i Hi. destruct (_ =? 0)%Z; cbn [tight]; rewrite ?Z.lor_spec, (beyond _ _ _ i M) by (unfold k in *; lia);
        [|reflexivity]. unfold bit, k. rewrite bit_at. apply Nat.eqb_neq. unfold k in *. lia.
    + destruct (Z.eqb_spec (dot a (coordinates (snd h))) 0); cbn [tight];
        rewrite ?Z.lor_spec, (beyond _ _ _ k M) by apply Nat.le_refl; [|reflexivity].
      unfold bit, k. rewrite bit_at. apply Nat.eqb_refl.
Qed.

Lemma join_value f p q : (content (join_form p q (dot a p) (dot a q)) * dot f (primitive (join_form p q (dot a p) (dot a q)))
  = dot a p * dot f q - dot a q * dot f p)%Z.
Proof. rewrite <- dot_primitive. unfold join_form. rewrite dot_combine. ring. Qed.

Lemma join_fits p q : In p hs -> In q hs -> (0 < fst p)%Z ->
  (fst q < 0)%Z \/ (forall f, In f sides -> dot f (coordinates (snd p)) = 0%Z) ->
  fits n more (join bit p q).
Proof.
  intros Hp Hq P Q. destruct (in_heights _ Hp) as [Rp Ep], (in_heights _ Hq) as [Rq Eq].
  destruct (fit_of _ Rp) as [Lp Ip Mp], (fit_of _ Rq) as [Lq Iq Mq].
  unfold join. rewrite Ep, Eq in *. set (cp := coordinates (snd p)) in *. set (cq := coordinates (snd q)) in *.
  set (x := join_form cp cq (dot a cp) (dot a cq)). pose proof (content_positive x) as CP.
  assert (V : forall f, (content x * dot f (primitive x) = dot a cp * dot f cq - dot a cq * dot f cp)%Z)
    by (intros; apply join_value).
  assert (On : dot a (primitive x) = 0%Z) by (specialize (V a); nia).
  assert (S : forall f, In f sides -> (0 <= dot f (primitive x) /\
    (dot f (primitive x) = 0 <-> dot f cp = 0 /\ dot f cq = 0))%Z).
  { intros f Hf. specialize (V f). specialize (Ip f Hf). specialize (Iq f Hf).
    destruct Q as [Q|Q]; [|specialize (Q f Hf); fold cp in Q]; split; try split; nia. }
  constructor; cbn [coordinates tight]; fold x.
  - rewrite primitive_length. unfold x, join_form. now apply combine_length.
  - intros f Hf. apply in_more in Hf as [Hf| ->]; [now apply S|lia].
  - apply new_marks; fold k.
    + intros i f Hi. rewrite Z.lor_spec, (both_marks sides _ _ cp cq Mp Mq f i Hi).
      unfold bit, k. rewrite bit_at. assert (i < k) by (apply nth_error_Some; congruence).
      replace (Nat.eqb i (List.length sides)) with false by (symmetry; apply Nat.eqb_neq; unfold k in *; lia).
      rewrite orb_false_r. apply nth_error_In in Hi. destruct (S f Hi) as [_ S'].
      destruct (Z.eqb_spec (dot f cp) 0), (Z.eqb_spec (dot f cq) 0), (Z.eqb_spec (dot f (primitive x)) 0); tauto.
    + intros i Hi. rewrite Z.lor_spec, Z.land_spec, (beyond _ _ _ i Mp) by (unfold k in *; lia).
      unfold bit, k. rewrite bit_at. apply Nat.eqb_neq. unfold k in *. lia.
    + rewrite Z.lor_spec, On. unfold bit, k. rewrite bit_at, Nat.eqb_refl. apply orb_true_r.
Qed.

Lemma inside_of r : In r rays -> inside sides (is_point n) (at_ (coordinates r)).
Proof.
  intros H. destruct (fit_of r H) as [L I M]. split.
  - exists (map IZR (coordinates r)). rewrite map_length. split; [exact L|]. intros f. now rewrite rdot_of_integers.
  - intros f Hf. apply IZR_le. auto.
Qed.

Lemma spans_multiple_of news r c : (0 < c)%Z -> In (primitive r) news -> c = content r -> spans news (at_ r).
Proof.
  intros P H ->. apply spans_same with (fun f => IZR (content r) * IZR (dot f (primitive r)))%R.
  - intros f. unfold at_. now rewrite <- mult_IZR, <- dot_primitive.
  - apply spans_multiple; [apply IZR_le; lia|]. now apply spans_ray.
Qed.

Lemma joins_span news p q : In (join bit p q) news -> In p hs -> In q hs ->
  spans (map coordinates news) (joined a (coordinates (snd p)) (coordinates (snd q))).
Proof.
  intros H Hp Hq. destruct (in_heights _ Hp) as [_ Ep], (in_heights _ Hq) as [_ Eq].
  apply in_map with (f := coordinates) in H. unfold join in H. cbn [coordinates] in H. rewrite Ep, Eq in H.
  eapply spans_same; [|exact (spans_multiple_of _ _ _ (content_positive _) H eq_refl)].
  intros f. unfold at_, joined, join_form, at_. rewrite dot_combine, plus_IZR, !mult_IZR, opp_IZR. ring.
Qed.

(* Along a line. *)
Section Line.
Variable line : height.
Hypothesis In_line : In line hs.
Hypothesis positive : (0 < fst line)%Z.
Hypothesis flat : forall f, In f sides -> dot f (coordinates (snd line)) = 0%Z.
Let l := coordinates (snd line).

Lemma line_moves ws : weights (map coordinates rays) ws ->
  spans (map coordinates (cut_line bit line hs)) (fun f => total f ws - total a ws / IZR (fst line) * IZR (dot f l))%R.
Proof.
  destruct (in_heights _ In_line) as [_ El]. pose proof (IZR_lt _ _ positive) as P.
  intros W. induction W as [|[w r] ws [Hw Hr] W IH]; cbn [total].
  - apply spans_same with (fun _ => 0%R); [intros f; field; lra|apply spans_zero].
  - cbn in Hw, Hr. apply in_map_iff in Hr as (r' & <- & Hr).
    assert (Hh : In (dot a (coordinates r'), r') hs) by (apply in_map_iff; now exists r').
    apply spans_same with (fun f => w / IZR (fst line) * joined a l (coordinates r') f
      + (total f ws - total a ws / IZR (fst line) * IZR (dot f l)))%R.
    { intros f. unfold joined, at_. fold l in El. rewrite <- El. field. lra. }
    apply spans_sum; [|exact IH]. apply spans_multiple.
    { unfold Rdiv. apply Rmult_le_pos; [exact Hw|]. left. now apply Rinv_0_lt_compat. }
    set (j := join bit line (dot a (coordinates r'), r')).
    destruct (all_zero (coordinates j)) eqn:Z.
    + apply spans_same with (fun _ => 0%R); [|apply spans_zero]. intros f.
      pose proof (join_value f l (coordinates r')) as V. unfold j, join in Z. cbn [coordinates fst snd] in Z.
      rewrite El in Z. fold l in Z. rewrite (dot_all_zero f _ Z), Z.mul_0_r in V.
      unfold joined, at_. rewrite <- mult_IZR. replace (- IZR (dot a (coordinates r')) * IZR (dot f l))%R
        with (- IZR (dot a (coordinates r') * dot f l))%R by (rewrite mult_IZR; ring).
      replace (dot a l * dot f (coordinates r'))%Z with (dot a (coordinates r') * dot f l)%Z by lia. ring.
    + apply (joins_span (cut_line bit line hs) line (dot a (coordinates r'), r')); [|exact In_line|exact Hh].
      right. apply filter_In. split; [|fold j; now rewrite Z]. apply in_map_iff. now exists (dot a (coordinates r'), r').
Qed.

Lemma line_described : described n more (cut_line bit line hs).
Proof.
  constructor.
  - constructor; [apply stay_fits; [exact In_line|lia]|]. apply Forall_forall. intros r Hr.
    apply filter_In in Hr as [Hr _]. apply in_map_iff in Hr as (h & <- & Hh).
    apply join_fits; [exact In_line|exact Hh|exact positive|right; exact flat].
  - intros x L H. destruct (all_spanned _ _ _ D x L) as (ws & W & E).
    { intros f Hf. apply H, in_more. now left. }
    pose proof (line_moves ws W) as M. pose proof (IZR_lt _ _ positive) as P.
    apply spans_same with (fun f => (total f ws - total a ws / IZR (fst line) * IZR (dot f l))
      + total a ws / IZR (fst line) * IZR (dot f l))%R; [intros f; rewrite E; ring|].
    apply spans_sum; [exact M|]. apply spans_multiple.
    + rewrite <- E. unfold Rdiv. apply Rmult_le_pos; [|left; now apply Rinv_0_lt_compat].
      apply H, in_more. now right.
    + apply spans_ray. left. unfold l, stay. now destruct (fst line =? 0)%Z.
Qed.
End Line.

(* No line leaves the plane. *)
Let is_line (r : ray) := contains (tight r) (bit - 1).
Hypothesis none_above : forall h, In h hs -> (0 < fst h)%Z -> is_line (snd h) = false.
Hypothesis none_below : forall h, In h hs -> (fst h < 0)%Z -> is_line (snd h) = false.
Hypothesis above_distinct : distinct (on_side true hs) = true.
Hypothesis below_distinct : distinct (on_side false hs) = true.
Let solids := filter (fun r => negb (is_line r)) rays.

Lemma not_line_solid r : In r rays -> is_line r = false -> solid sides (at_ (coordinates r)).
Proof.
  intros H N. destruct (fit_of r H) as [_ I M].
  destruct (Exists_dec (fun f => 0 < dot f (coordinates r))%Z sides (fun f => Z_lt_dec 0 _)) as [E|E].
  - apply Exists_exists in E as (f & Hf & P). exists f. split; [exact Hf|]. now apply IZR_lt.
  - exfalso. enough (is_line r = true) by congruence. apply (zero_line sides _ (coordinates r) M).
    intros f Hf. specialize (I f Hf). destruct (Z.le_gt_cases (dot f (coordinates r)) 0); [lia|].
    destruct E. apply Exists_exists. exists f. split; [exact Hf|lia].
Qed.

Lemma distinct_unlike (side : list height) g h : distinct side = true -> In g side -> In h side ->
  In (snd g) rays -> In (snd h) rays ->
  (tight (snd g) =? tight (snd h))%Z = false -> unlike sides (coordinates (snd g)) (coordinates (snd h)).
Proof.
  intros Ds Hg Hh Rg Rh N. unfold distinct in Ds. rewrite forallb_forall in Ds.
  assert (A : forall g h, In g side -> In h side -> (tight (snd g) =? tight (snd h))%Z = false ->
    contains (tight (snd h)) (tight (snd g)) = false).
  { intros g' h' Hg' Hh' E. pose proof (Ds g' Hg') as X. rewrite forallb_forall in X. specialize (X h' Hh').
    rewrite E, orb_false_r in X. now apply negb_true_iff. }
  destruct (fit_of _ Rg) as [_ _ Mg], (fit_of _ Rh) as [_ _ Mh]. split; intros F.
  - enough (contains (tight (snd h)) (tight (snd g)) = true) by (rewrite (A g h) in *; congruence).
    apply (zero_contains sides _ _ _ _ Mg Mh). intros f Hf Z. apply eq_IZR. apply F; [exact Hf|].
    unfold at_. now rewrite Z.
  - enough (contains (tight (snd g)) (tight (snd h)) = true)
      by (rewrite (A h g) in *; congruence || (rewrite Z.eqb_sym; congruence)).
    apply (zero_contains sides _ _ _ _ Mh Mg). intros f Hf Z. apply eq_IZR. apply F; [exact Hf|].
    unfold at_. now rewrite Z.
Qed.

Lemma rays_described : described n more (cut_rays bit solids hs).
Proof.
  constructor.
  - apply Forall_app. split; apply Forall_forall; intros r Hr.
    + apply in_map_iff in Hr as (h & <- & Hh). apply filter_In in Hh as [Hh P]. apply Z.leb_le in P.
      now apply stay_fits.
    + apply in_flat_map in Hr as (p & Hp & Hr). apply in_flat_map in Hr as (q & Hq & Hr).
      apply filter_In in Hp as [Hp P]. apply filter_In in Hq as [Hq Q]. apply Z.ltb_lt in P, Q.
      destruct (parted _ _ _); [destruct Hr|destruct Hr as [<-|[]]]. apply join_fits; auto.
  - intros x L H. set (news := cut_rays bit solids hs).
    apply (news_span sides a (map coordinates rays) (map coordinates news) (is_point n) (is_point_sum n)).
    + intros p [(y & Ly & E) Hp]. apply spans_same with (fun f => rdot f y); [intros; now rewrite E|].
      apply (all_spanned _ _ _ D); [exact Ly|]. intros f Hf. rewrite <- E. auto.
    + intros r Hr. apply in_map_iff in Hr as (r' & <- & Hr). now apply inside_of.
    + intros r Hr N. apply in_map_iff in Hr as (r' & <- & Hr). apply not_line_solid; [exact Hr|].
      assert (Hh : In (dot a (coordinates r'), r') hs) by (apply in_map_iff; now exists r').
      destruct (Z.lt_trichotomy (dot a (coordinates r')) 0) as [S|[S|S]]; [|lia|].
      * now apply (none_below _ Hh).
      * now apply (none_above _ Hh).
    + intros r Hr S. apply in_map_iff in Hr as (r' & <- & Hr).
      apply (spans_ray (map coordinates news)). apply in_map_iff. exists (stay bit (dot a (coordinates r'), r')). split.
      * unfold stay. now destruct (_ =? _)%Z.
      * unfold news, cut_rays. apply in_or_app. left. apply in_map. apply filter_In. split; [|now apply Z.leb_le].
        apply in_map_iff. now exists r'.
    + intros p q Hp Hq P Q. apply in_map_iff in Hp as (rp & <- & Hp). apply in_map_iff in Hq as (rq & <- & Hq).
      set (hp := (dot a (coordinates rp), rp)). set (hq := (dot a (coordinates rq), rq)).
      assert (Hhp : In hp hs) by (apply in_map_iff; now exists rp).
      assert (Hhq : In hq hs) by (apply in_map_iff; now exists rq).
      assert (Sp : In hp (on_side true hs)) by (apply filter_In; split; [exact Hhp|now apply Z.ltb_lt]).
      assert (Sq : In hq (on_side false hs)) by (apply filter_In; split; [exact Hhq|now apply Z.ltb_lt]).
      destruct (parted solids rp rq) eqn:Pa.
      * right. unfold parted in Pa. apply existsb_exists in Pa as (g & Hg & C).
        apply filter_In in Hg as [Hg NL]. apply negb_true_iff in NL.
        apply andb_true_iff in C as [C Nq]. apply andb_true_iff in C as [C Np].
        apply negb_true_iff in Np, Nq. exists (coordinates g).
        destruct (fit_of g Hg) as [_ Ig Mg], (fit_of rp Hp) as [_ Ip Mp], (fit_of rq Hq) as [_ Iq Mq].
        assert (Hhg : In (dot a (coordinates g), g) hs) by (apply in_map_iff; now exists g).
        split; [now apply in_map|]. split; [now apply not_line_solid|]. split; [|split].
        -- intros f Hf Z. destruct (joined_zero a (coordinates rp) (coordinates rq) f P Q)
             as [Z1 Z2]; [apply IZR_le; auto|apply IZR_le; auto|exact Z|].
           apply eq_IZR in Z1, Z2. unfold at_. apply IZR_eq.
           apply In_nth_error in Hf as (i & Hf).
           assert (B : Z.testbit (Z.land (tight rp) (tight rq)) (Z.of_nat i) = true).
           { rewrite (both_marks sides _ _ _ _ Mp Mq f i Hf), Z1, Z2. reflexivity. }
           apply (contains_bit _ _ _ C) in B. pose proof (Mg i) as Gi. rewrite Hf, B in Gi. symmetry in Gi.
           now apply Z.eqb_eq.
        -- intros G. apply (distinct_unlike (on_side true hs) hp (dot a (coordinates g), g)); try assumption.
           ++ apply filter_In. split; [exact Hhg|now apply Z.ltb_lt].
           ++ cbn [snd]. now rewrite Z.eqb_sym.
        -- intros G. apply (distinct_unlike (on_side false hs) hq (dot a (coordinates g), g)); try assumption.
           ++ apply filter_In. split; [exact Hhg|now apply Z.ltb_lt].
           ++ cbn [snd]. now rewrite Z.eqb_sym.
      * left. apply (joins_span news hp hq); try assumption. unfold news, cut_rays. apply in_or_app. right.
        apply in_flat_map. exists hp. split; [exact Sp|]. apply in_flat_map. exists hq. split; [exact Sq|].
        cbn [snd hp hq]. rewrite Pa. now left.
    + split; [exists x; auto|]. intros f Hf. apply H, in_more. now left.
    + apply H, in_more. now right.
Qed.
End CutProof.

(* What is in the region and on the right side of the plane is in the region that is cut. *)
Theorem cut_described n sides rays a news : described n sides rays ->
  cut (List.length sides) (heights a rays) = Some news -> described n (sides ++ [a]) news.
Proof.
  intros D. unfold cut. replace (map snd (heights a rays)) with rays by (unfold heights; now rewrite map_map, map_id).
  set (bit := Z.shiftl 1 _). set (hs := heights a rays).
  match goal with |- context [find ?p hs] => destruct (find p hs) as [line|] eqn:F end.
  - apply find_some in F as [Hl F]. apply andb_true_iff in F as [F P]. apply Z.ltb_lt in P. intros [= <-].
    apply line_described; [exact D|exact Hl|exact P|].
    destruct (in_heights rays a line Hl) as [Hr _]. destruct (fit_of n sides rays D _ Hr) as [_ _ M].
    exact (line_zero sides _ _ M F).
  - match goal with |- context [existsb ?p hs] => destruct (existsb p hs) eqn:X; [discriminate|] end. destruct (_ && _) eqn:Ds; [|discriminate].
    apply andb_true_iff in Ds as [D1 D2]. intros [= <-].
    apply rays_described; try assumption.
    + intros h Hh P. pose proof (find_none _ _ F h Hh) as N. cbv beta in N.
      apply andb_false_iff in N as [N|N]; [exact N|]. apply Z.ltb_ge in N. lia.
    + intros h Hh P. destruct (contains (tight (snd h)) _) eqn:C; [|reflexivity].
      enough (existsb (fun h => contains (tight (snd h)) (bit - 1) && (fst h <? 0)%Z) hs = true) by congruence.
      apply existsb_exists. exists h. split; [exact Hh|]. apply andb_true_iff. split; [exact C|now apply Z.ltb_lt].
Qed.

(* The new rays know which strict functions are zero on them. *)
Lemma join_knows strict a bit p q : fst p = dot a (coordinates (snd p)) -> fst q = dot a (coordinates (snd q)) ->
  knows strict (snd p) -> knows strict (snd q) -> knows strict (join bit p q).
Proof.
  intros Ep Eq Kp Kq. unfold knows, join. cbn [zeros coordinates].
  eapply both_implies; [|exact Kp|exact Kq]. cbn. intros fs Fp Fq f Hf.
  specialize (Fp f Hf). specialize (Fq f Hf). set (x := join_form _ _ _ _).
  assert (X : dot f x = 0%Z) by (unfold x, join_form; rewrite dot_combine, Fp, Fq; lia).
  rewrite dot_primitive in X. pose proof (content_positive x).
  apply Z.mul_eq_0 in X as [X|X]; [lia | exact X].
Qed.

Theorem cut_knows strict count rays a news : Forall (knows strict) rays -> cut count (heights a rays) = Some news ->
  Forall (knows strict) news.
Proof.
  intros K. rewrite Forall_forall in K. unfold cut. set (bit := Z.shiftl 1 _). set (hs := heights a rays).
  assert (H : forall h, In h hs -> knows strict (snd h) /\ fst h = dot a (coordinates (snd h))).
  { intros h Hh. apply in_map_iff in Hh as (r & <- & Hr). auto. }
  assert (S : forall h, In h hs -> knows strict (stay bit h)).
  { intros h Hh. unfold stay. destruct (fst h =? 0)%Z; apply (H h Hh). }
  assert (J : forall p q, In p hs -> In q hs -> knows strict (join bit p q)).
  { intros p q Hp Hq. destruct (H p Hp), (H q Hq). now apply (join_knows strict a). }
  match goal with |- context [find ?p hs] => destruct (find p hs) as [line|] eqn:F end.
  - apply find_some in F as [Hl _]. intros [= <-]. constructor; [auto|]. apply Forall_forall. intros r Hr.
    apply filter_In in Hr as [Hr _]. apply in_map_iff in Hr as (h & <- & Hh). auto.
  - match goal with |- context [existsb ?p hs] => destruct (existsb p hs); [discriminate|] end. destruct (_ && _); [|discriminate]. intros [= <-].
    apply Forall_app. split; apply Forall_forall; intros r Hr.
    + apply in_map_iff in Hr as (h & <- & Hh). apply filter_In in Hh as [Hh _]. auto.
    + apply in_flat_map in Hr as (p & Hp & Hr). apply in_flat_map in Hr as (q & Hq & Hr).
      apply filter_In in Hp as [Hp _]. apply filter_In in Hq as [Hq _].
      destruct (parted _ _ _); [destruct Hr|destruct Hr as [<-|[]]]. auto.
Qed.
