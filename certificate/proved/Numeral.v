(* SPDX-License-Identifier: MIT *)
(** The spellings of numbers: those of grasp files, which are read as Grammar.v says
    (`parse_decimal_is`), and those of certificates (FORMAT.md section 2). *)
From Coq Require Import Ascii Bool Lia List QArith Qpower String ZArith.
From Proved Require Import Grammar Json.
Import ListNotations.
Local Open Scope Z_scope.

Definition digit (c : ascii) : option Z :=
  (if c =? "0" then Some 0 else if c =? "1" then Some 1 else if c =? "2" then Some 2
   else if c =? "3" then Some 3 else if c =? "4" then Some 4 else if c =? "5" then Some 5
   else if c =? "6" then Some 6 else if c =? "7" then Some 7 else if c =? "8" then Some 8
   else if c =? "9" then Some 9 else None)%char.

(** The digits at the front of a text: the number that they spell behind those read before, how many
    they are with those, and the rest of the text. *)
Fixpoint digits_after (value count : Z) (text : list ascii) : Z * Z * list ascii :=
  match text with
  | [] => (value, count, text)
  | c :: rest =>
      match digit c with
      | Some d => digits_after (10 * value + d) (count + 1) rest
      | None => (value, count, text)
      end
  end.
Definition digits : list ascii -> Z * Z * list ascii := digits_after 0 0.

(** Whether the text begins with [c], and what follows. *)
Definition take (c : ascii) (text : list ascii) : bool * list ascii :=
  match text with
  | first :: rest => if Ascii.eqb first c then (true, rest) else (false, text)
  | [] => (false, text)
  end.

(** [-] or [+] or neither: whether it is [-], and what follows. *)
Definition take_sign (text : list ascii) : bool * list ascii :=
  let '(negative, text) := take "-" text in
  let '(_, text) := if negative then (true, text) else take "+" text in
  (negative, text).

Fixpoint is_longer_than {A : Type} (limit : Z) (text : list A) : bool :=
  match text with
  | [] => false
  | _ :: rest => (limit <=? 0) || is_longer_than (limit - 1) rest
  end.

(** A fraction; none if its denominator is 0. *)
Definition fraction (negative : bool) (num den : Z) : option Q :=
  match den with
  | Zpos p => Some (Qmake (if negative then - num else num) p)
  | _ => None
  end.

(** [digits] or [digits/digits], all of the text. *)
Definition fraction_of_digits (negative : bool) (text : list ascii) : option Q :=
  let '(num, count, rest) := digits text in
  let '(slash, rest) := take "/" rest in
  let '(den, den_count, rest) := if slash then digits rest else (1, 1, rest) in
  match rest with
  | [] => if (count =? 0) || (den_count =? 0) then None else fraction negative num den
  | _ => None
  end.

(** NUMBER of a certificate, of at most so many characters: [[-]digits] or [[-]digits/digits]. *)
Definition parse_fraction (limit : Z) (spelled : string) : option Q :=
  let text := list_ascii_of_string spelled in
  if is_longer_than limit text then None
  else let '(negative, text) := take "-" text in fraction_of_digits negative text.

(** [e] or [E], a sign and digits: the exponent, which is 0 if none is there, and the rest. *)
Definition exponent (text : list ascii) : option (Z * list ascii) :=
  let '(small, text) := take "e" text in
  let '(large, text) := if small then (true, text) else take "E" text in
  if negb large then Some (0, text)
  else
    let '(down, text) := take_sign text in
    let '(size, count, text) := digits text in
    if (count =? 0) || (largest_exponent <? size) then None
    else Some (if down then - size else size, text).

(** A number of a grasp file or of the command line: [[+-] digits [. digits] [(e|E) [+-] digits]],
    or [[+-] digits / digits]. *)
Definition parse_decimal (spelled : string) : option Q :=
  let text := list_ascii_of_string spelled in
  if is_longer_than longest_number text then None
  else
    let '(negative, text) := take_sign text in
    let '(value, count, rest) := digits text in
    if count =? 0 then None
    else if fst (take "/" rest) then fraction_of_digits negative text
    else
      let '(point, rest) := take "." rest in
      let '(value, decimals, rest) := if point then digits_after value 0 rest else (value, 0, rest) in
      if point && (decimals =? 0) then None
      else
        match exponent rest with
        | Some (power, []) =>
            let shift := power - decimals in
            if 0 <=? shift then fraction negative (value * 10 ^ shift) 1
            else fraction negative value (10 ^ (- shift))
        | _ => None
        end.

(** A number of a grasp file. *)
Definition read_decimal (at_path : path) (value : json) : result Q :=
  let what := "a number such as 0.25 or 1e-3, or a string as ""3/5"""%string in
  let checked (spelled : string) (good : Q -> bool) :=
    match parse_decimal spelled with
    | Some x => if good x then Fine x
                else refuse at_path "a number below 2^16384 is expected; a string spells larger ones"
    | None => expected what at_path value
    end in
  match value with
  | Number characters => checked characters is_not_too_large
  | Text content => checked content (fun _ => true)
  | _ => expected what at_path value
  end.

Definition longest_fraction : Z := 65536.
Definition longest_json_integer : Z := 4000.

(** NUMBER. *)
Definition read_fraction (at_path : path) (value : json) : result Q :=
  let read :=
    match value with
    | Number characters => parse_fraction longest_json_integer characters
    | Text content => parse_fraction longest_fraction content
    | _ => None
    end in
  match read with
  | Some x => Fine x
  | None => expected "an integer, or a string such as ""-3/5""" at_path value
  end.

(** CONTACT, and other JSON integers of 0 or more. *)
Definition read_index (at_path : path) (value : json) : result Z :=
  let what := "an integer of 0 or more"%string in
  match value with
  | Number characters =>
      match parse_fraction longest_json_integer characters with
      | Some x => if 0 <=? Qnum x then Fine (Qnum x) else expected what at_path value
      | None => expected what at_path value
      end
  | _ => expected what at_path value
  end.

(** ---- What is read is what Grammar.v says ---- *)

Section Proofs.
Local Arguments Z.mul : simpl never.
Local Arguments Z.add : simpl never.
Local Arguments Z.pow : simpl never.

Lemma digit_spec c d : digit c = Some d <-> digit_is c d.
Proof.
  split.
  - destruct c as [[] [] [] [] [] [] [] []]; cbv; intros E; try discriminate; injection E as <-; constructor.
  - intros []; reflexivity.
Qed.

(** What follows the digits: no digit. *)
Definition ends (rest : text) : Prop := match rest with [] => True | c :: _ => digit c = None end.

(** Digits behind a number, and the number that they make of it. *)
Inductive run : Z -> text -> Z -> Prop :=
| nothing v : run v [] v
| another v c d ds n : digit c = Some d -> run (10 * v + d) ds n -> run v (c :: ds) n.

Lemma digits_after_runs text : forall v k n count rest, digits_after v k text = (n, count, rest) ->
  exists ds, text = ds ++ rest /\ run v ds n /\ count = k + Z.of_nat (List.length ds) /\ ends rest.
Proof.
  induction text as [|c text IH]; intros v k n count rest H; cbn in H.
  - injection H as <- <- <-. exists []. repeat split; try constructor. cbn. lia.
  - destruct (digit c) as [d|] eqn:D.
    + destruct (IH _ _ _ _ _ H) as (ds & -> & R & -> & E). exists (c :: ds).
      repeat split; [econstructor; eassumption| cbn [List.length]; lia | exact E].
    + injection H as <- <- <-. exists []. repeat split; [constructor|cbn; lia|exact D].
Qed.

Lemma runs_digits_after v ds n : run v ds n -> forall k rest, ends rest ->
  digits_after v k (ds ++ rest) = (n, k + Z.of_nat (List.length ds), rest).
Proof.
  induction 1 as [v|v c d ds n D R IH]; intros k rest E.
  - cbn [app List.length]. replace (k + Z.of_nat 0) with k by lia.
    destruct rest as [|c rest]; cbn; [reflexivity|]. cbn in E. now rewrite E.
  - cbn [app digits_after]. rewrite D, IH by exact E. f_equal. f_equal. cbn [List.length]. lia.
Qed.

Lemma run_snoc v ds n c d : run v ds n -> digit c = Some d -> run v (ds ++ [c]) (10 * n + d).
Proof.
  induction 1 as [v|v c' d' ds n D R IH]; intros E; cbn.
  - econstructor; [exact E|constructor].
  - econstructor; [exact D|auto].
Qed.

Lemma natural_runs ds n : natural ds n -> run 0 ds n /\ ds <> [].
Proof.
  induction 1 as [c d D|ds n c d N [R _] D]; apply digit_spec in D.
  - split; [|discriminate]. econstructor; [exact D|]. replace (10 * 0 + d) with d by lia. constructor.
  - split; [now apply run_snoc|]. now destruct ds.
Qed.

Lemma runs_natural ds n : run 0 ds n -> ds <> [] -> natural ds n.
Proof.
  assert (G : forall ds v n, run v ds n -> forall before, natural before v -> natural (before ++ ds) n).
  { intros ds0 v n0. induction 1 as [v|v c d ds' n' D R IH]; intros before B.
    - now rewrite app_nil_r.
    - change (c :: ds') with ([c] ++ ds'). rewrite app_assoc. apply IH. constructor; [exact B|now apply digit_spec]. }
  intros R N. inversion R as [|v c d ds' n' D R']; subst; [congruence|].
  apply (G ds' _ _ R' [c]). replace (10 * 0 + d) with d by lia. constructor. now apply digit_spec.
Qed.

(** Digits behind a number are worth what they are by themselves, and it so many places up. *)
Lemma run_from v ds n m : run v ds n -> run 0 ds m -> n = v * 10 ^ Z.of_nat (List.length ds) + m.
Proof.
  assert (G : forall ds v n, run v ds n -> forall u m, run u ds m ->
    n - m = (v - u) * 10 ^ Z.of_nat (List.length ds)).
  { intros ds0 v0 n0. induction 1 as [v'|v' c d ds' n' D R IH]; intros u m' R'; inversion R'; subst.
    - cbn. lia.
    - match goal with H : digit c = Some ?e, H' : run _ ds' m' |- _ =>
        rewrite D in H; injection H as <-; rewrite (IH _ _ H') end.
      cbn [List.length]. rewrite Nat2Z.inj_succ, Z.pow_succ_r by lia. ring. }
  intros R R0. pose proof (G _ _ _ R _ _ R0). lia.
Qed.

Lemma run_exists v ds n : run v ds n -> forall u, exists m, run u ds m.
Proof.
  induction 1 as [v|v c d ds n D R IH]; intros u; [eexists; constructor|].
  destruct (IH (10 * u + d)) as (m & M). exists m. econstructor; eassumption.
Qed.

Lemma run_nonneg v ds n : run v ds n -> 0 <= v -> 0 <= n.
Proof.
  induction 1 as [v|v c d ds n D R IH]; intros V; [exact V|]. apply IH.
  assert (0 <= d); [|lia]. apply digit_spec in D. destruct D; lia.
Qed.

Lemma take_is c text : take c text = (true, List.tl text) /\ text = c :: List.tl text \/
  take c text = (false, text) /\ (forall rest, text <> c :: rest).
Proof.
  destruct text as [|first rest]; cbn; [right; split; [reflexivity|discriminate]|].
  destruct (Ascii.eqb_spec first c) as [->|N]; [left; auto|right; split; [reflexivity|congruence]].
Qed.

Lemma take_not c text : (forall rest, text <> c :: rest) -> take c text = (false, text).
Proof. intros N. destruct (take_is c text) as [[_ E]|[E _]]; [now destruct (N _ E)|exact E]. Qed.

Lemma take_it c rest : take c (c :: rest) = (true, rest).
Proof. cbn. now rewrite Ascii.eqb_refl. Qed.

Lemma is_longer_spec {A} (items : list A) : forall limit, 0 <= limit ->
  is_longer_than limit items = false <-> Z.of_nat (List.length items) <= limit.
Proof.
  induction items as [|a items IH]; intros limit L; cbn [is_longer_than List.length]; [split; [lia|reflexivity]|].
  destruct (Z.leb_spec limit 0) as [H|H]; cbn [orb].
  - split; [discriminate|lia].
  - rewrite IH by lia. lia.
Qed.

Lemma starts_with_digit ds n c : run 0 ds n -> ds <> [] -> digit c = None ->
  forall more rest, ds ++ more <> c :: rest.
Proof.
  intros R N D more rest E. inversion R; subst; [congruence|]. cbn in E. congruence.
Qed.

Definition sign_of (negative : bool) : Z := if negative then -1 else 1.

Lemma take_sign_is text negative rest : take_sign text = (negative, rest) ->
  exists s, text = s ++ rest /\ sign s (sign_of negative).
Proof.
  unfold take_sign. destruct (take_is "-" text) as [[-> E]|[-> _]].
  - intros H. injection H as <- <-. exists ["-"%char]. split; [exact E|constructor].
  - destruct (take_is "+" text) as [[-> E]|[-> _]]; intros H; injection H as <- <-.
    + exists ["+"%char]. split; [exact E|constructor].
    + exists []. split; [reflexivity|constructor].
Qed.

Lemma sign_is_taken s f ds n more : sign s f -> run 0 ds n -> ds <> [] ->
  exists negative, take_sign (s ++ ds ++ more) = (negative, ds ++ more) /\ f = sign_of negative.
Proof.
  intros S R N. pose proof (fun c D => starts_with_digit ds n c R N D more) as No. unfold take_sign.
  destruct S; cbn [app].
  - exists false. rewrite !take_not by (apply No; reflexivity). auto.
  - exists false. rewrite (take_not "-") by discriminate. rewrite take_it. auto.
  - exists true. rewrite take_it. auto.
Qed.

Lemma fraction_is negative num den : 0 < den -> exists x, fraction negative num den = Some x /\
  (x == inject_Z (sign_of negative) * (inject_Z num / inject_Z den))%Q.
Proof.
  intros P. destruct den as [|den|]; try lia. eexists. split; [reflexivity|].
  unfold Qeq, Qmult, Qdiv, Qinv, inject_Z, sign_of. cbn. destruct negative; lia.
Qed.

Lemma power_is z : 0 <= z -> (inject_Z (10 ^ z) == inject_Z 10 ^ z)%Q.
Proof. apply Zpower_Qpower. Qed.

Lemma behind_point value k n m : 0 <= k -> value = n * 10 ^ k + m ->
  (inject_Z value / inject_Z (10 ^ k) == inject_Z n + inject_Z m / inject_Z (10 ^ k))%Q.
Proof.
  intros K ->. rewrite inject_Z_plus, inject_Z_mult. field. intros Z0.
  assert (0 < 10 ^ k) by (apply Z.pow_pos_nonneg; lia).
  change 0%Q with (inject_Z 0) in Z0. apply (proj1 (inject_Z_injective _ _)) in Z0. lia.
Qed.

(** Digits with so many behind the point, times a power of ten. *)
Lemma shifted_is negative value k p : 0 <= k -> exists x,
  (if 0 <=? p - k then fraction negative (value * 10 ^ (p - k)) 1
   else fraction negative value (10 ^ (- (p - k)))) = Some x /\
  (x == inject_Z (sign_of negative) * (inject_Z value / inject_Z (10 ^ k)) * inject_Z 10 ^ p)%Q.
Proof.
  intros K. assert (Ten : forall z, ~ (inject_Z 10 ^ z == 0)%Q) by (intros z; apply Qpower_not_0; discriminate).
  destruct (Z.leb_spec 0 (p - k)) as [S|S].
  - destruct (fraction_is negative (value * 10 ^ (p - k)) 1 eq_refl) as (x & -> & E). exists x. split; [reflexivity|].
    rewrite E, inject_Z_mult, !power_is by lia. replace p with ((p - k) + k) at 2 by lia.
    rewrite Qpower_plus by discriminate. change (inject_Z 1) with 1%Q. pose proof (Ten k) as Tk.
    generalize dependent (inject_Z 10 ^ k)%Q. generalize (inject_Z 10 ^ (p - k))%Q. intros a b B. now field.
  - assert (P : 0 < 10 ^ - (p - k)) by (apply Z.pow_pos_nonneg; lia).
    destruct (fraction_is negative value _ P) as (x & -> & E). exists x. split; [reflexivity|].
    rewrite E, !power_is by lia. replace p with (k + - - (p - k)) at 2 by lia.
    rewrite Qpower_plus by discriminate. rewrite (Qpower_opp _ (- (p - k))).
    pose proof (Ten k) as Tk. pose proof (Ten (- (p - k))) as Ts. generalize dependent (inject_Z 10 ^ k)%Q.
    generalize dependent (inject_Z 10 ^ - (p - k))%Q. intros a A b B. now field.
Qed.

(** What is behind the point, and a power of ten. *)
Lemma exponent_read text p rest : exponent text = Some (p, rest) ->
  exists e, text = e ++ rest /\ power_of_ten e p.
Proof.
  unfold exponent. assert (G : forall e more, e = "e"%char \/ e = "E"%char -> text = e :: more ->
    (let '(down, text) := take_sign more in
     let '(size, count, text) := digits text in
     if (count =? 0) || (largest_exponent <? size) then None else Some (if down then - size else size, text))
    = Some (p, rest) -> exists e, text = e ++ rest /\ power_of_ten e p).
  { intros e more Ee -> H. destruct (take_sign more) as [down text'] eqn:T.
    destruct (take_sign_is _ _ _ T) as (s & -> & Sg). destruct (digits text') as [[size count] rest'] eqn:D.
    destruct (digits_after_runs _ _ _ _ _ _ D) as (ds & -> & R & -> & _).
    destruct (Z.eqb_spec (0 + Z.of_nat (List.length ds)) 0) as [C|C]; [discriminate|].
    destruct (Z.ltb_spec largest_exponent size) as [B|B]; [discriminate|]. cbn [orb] in H.
    injection H as <- <-. exists (e :: s ++ ds). split; [cbn; now rewrite <- app_assoc|].
    replace (if down then - size else size) with (sign_of down * size) by (destruct down; cbn; lia).
    constructor; try assumption. apply runs_natural; [exact R|]. intros ->. cbn in C. lia. }
  destruct (take_is "e" text) as [[-> E]|[-> _]]; cbn [negb].
  - apply (G "e"%char); auto.
  - destruct (take_is "E" text) as [[-> E]|[-> _]]; cbn [negb].
    + apply (G "E"%char); auto.
    + intros H. injection H as <- <-. exists []. split; [reflexivity|constructor].
Qed.

Lemma exponent_accepted e p : power_of_ten e p -> exponent e = Some (p, []).
Proof.
  destruct 1 as [|e s f ds n Ee Sg N L]; [reflexivity|].
  destruct (natural_runs _ _ N) as [R NE]. destruct (sign_is_taken s f ds n [] Sg R NE) as (down & T & ->).
  rewrite app_nil_r in T. unfold exponent. replace (take "e" (e :: s ++ ds)) with
    (if Ascii.eqb e "e" then (true, s ++ ds) else (false, e :: s ++ ds)) by reflexivity.
  assert (G : (let '(down, text) := take_sign (s ++ ds) in
     let '(size, count, text) := digits text in
     if (count =? 0) || (largest_exponent <? size) then None else Some (if down then - size else size, text))
     = Some (sign_of down * n, [])).
  { rewrite T. unfold digits. rewrite <- (app_nil_r ds) at 1. rewrite (runs_digits_after _ _ _ R) by exact I.
    destruct ds as [|c ds]; [congruence|].
    destruct (Z.eqb_spec (0 + Z.of_nat (List.length (c :: ds))) 0) as [C|C]; [cbn [List.length] in C; lia|].
    destruct (Z.ltb_spec largest_exponent n) as [B|B]; [lia|]. cbn [orb].
    f_equal. f_equal. destruct down; cbn; lia. }
  destruct Ee as [-> | ->]; cbn [Ascii.eqb Bool.eqb take negb]; exact G.
Qed.

(** What `parse_decimal` reads is what it spells. *)
Theorem decimal_read spelled x : parse_decimal spelled = Some x -> spells spelled x.
Proof.
  unfold parse_decimal, spells. set (text := list_ascii_of_string spelled). cbv zeta.
  destruct (is_longer_than longest_number text) eqn:L; [discriminate|].
  apply is_longer_spec in L; [|discriminate]. intros H. split; [exact L|]. clear L.
  destruct (take_sign text) as [negative text'] eqn:T. destruct (take_sign_is _ _ _ T) as (s & -> & Sg).
  destruct (digits text') as [[n count] rest] eqn:D.
  destruct (digits_after_runs _ _ _ _ _ _ D) as (whole & E & R & EC & _).
  destruct (Z.eqb_spec count 0) as [C|C]; [discriminate|].
  assert (N : natural whole n).
  { apply runs_natural; [exact R|]. intros ->. cbn in EC. lia. }
  destruct (take_is "/" rest) as [[Sl Er]|[Sl _]]; rewrite Sl in H; cbn [fst] in H.
  - unfold fraction_of_digits in H. rewrite D, Sl in H.
    destruct (digits (List.tl rest)) as [[d den_count] more] eqn:D'.
    destruct (digits_after_runs _ _ _ _ _ _ D') as (den & E' & R' & -> & _).
    destruct more; [|discriminate].
    destruct ((count =? 0) || (0 + Z.of_nat (List.length den) =? 0)) eqn:Z0; [discriminate|].
    apply orb_false_iff in Z0 as [_ Z0]. apply Z.eqb_neq in Z0.
    assert (D0 : 0 < d).
    { pose proof (run_nonneg _ _ _ R' (Z.le_refl 0)). destruct d; cbn in H; try discriminate; lia. }
    destruct (fraction_is negative n d D0) as (y & Y & EY). rewrite Y in H. injection H as <-.
    eexists. split; [|exact EY]. rewrite E, Er, E', app_nil_r. econstructor; try eassumption; [|lia].
    apply runs_natural; [exact R'|]. intros ->. cbn in Z0. lia.
  - destruct (take "." rest) as [point rest'] eqn:P.
    set (after := if point then _ else _) in H. destruct after as [[value k] rest''] eqn:A. unfold after in A. clear after.
    assert (F : exists part x, rest = part ++ rest'' /\ (point && (k =? 0) = false -> decimals part x) /\ 0 <= k /\
      (inject_Z value / inject_Z (10 ^ k) == inject_Z n + x)%Q).
    { destruct (take_is "." rest) as [[P' Er]|[P' _]]; rewrite P' in P; injection P as <- <-.
      - destruct (digits_after_runs _ _ _ _ _ _ A) as (ds & Ed & Rd & -> & _).
        destruct (run_exists _ _ _ Rd 0) as (m & M). pose proof (run_from _ _ _ _ Rd M) as V.
        exists ("."%char :: ds), (inject_Z m / inject_Z (10 ^ Z.of_nat (List.length ds)))%Q.
        split; [rewrite Er, Ed; reflexivity|]. split; [|split; [lia|]].
        + intros K. constructor. apply runs_natural; [exact M|]. intros ->. discriminate.
        + rewrite Z.add_0_l. apply behind_point; [lia|exact V].
      - injection A as <- <- <-. exists [], 0%Q. split; [reflexivity|]. split; [constructor|]. split; [lia|].
        change (10 ^ 0) with 1. field. }
    destruct F as (part & y & Er & Dec & K & V).
    destruct (point && (k =? 0)); [discriminate|]. specialize (Dec eq_refl).
    destruct (exponent rest'') as [[p last]|] eqn:X; [|discriminate].
    destruct (exponent_read _ _ _ X) as (e & Ee & Pw). destruct last; [|discriminate].
    destruct (shifted_is negative value k p K) as (z & Z1 & EZ). rewrite Z1 in H. injection H as <-.
    eexists. split; [|rewrite EZ, V; reflexivity].
    rewrite E, Er, Ee, app_nil_r. econstructor; eassumption.
Qed.

Lemma decimals_end part x : decimals part x -> forall e p, power_of_ten e p -> ends (part ++ e).
Proof.
  destruct 1; intros e p Pw; [|exact eq_refl]. destruct Pw as [|e s f ds n [-> | ->] ]; cbn; auto.
Qed.

(** And what is within the limits is read. *)
Theorem decimal_accepted spelled x : spells spelled x -> exists y, parse_decimal spelled = Some y /\ (y == x)%Q.
Proof.
  unfold parse_decimal, spells. set (text := list_ascii_of_string spelled). cbv zeta. intros (L & y & N & E).
  apply (is_longer_spec text longest_number) in L; [|discriminate]. rewrite L. clear L.
  assert (G : exists z, (let '(negative, text) := take_sign text in
    let '(value, count, rest) := digits text in
    if count =? 0 then None
    else if fst (take "/" rest) then fraction_of_digits negative text
    else
      let '(point, rest) := take "." rest in
      let '(value, decimals, rest) := if point then digits_after value 0 rest else (value, 0, rest) in
      if point && (decimals =? 0) then None
      else
        match exponent rest with
        | Some (power, []) =>
            let shift := power - decimals in
            if 0 <=? shift then fraction negative (value * 10 ^ shift) 1
            else fraction negative value (10 ^ (- shift))
        | _ => None
        end) = Some z /\ (z == y)%Q).
  { destruct N as [s f whole n part q e p Sg Nw Dec Pw|s f num n den d Sg Nn Nd D0];
      [rename whole into ds; rename Nw into Nt; set (more := part ++ e)
      |rename num into ds; rename Nn into Nt; set (more := "/"%char :: den)];
      destruct (natural_runs _ _ Nt) as [R NE];
      destruct (sign_is_taken s f ds n more Sg R NE) as (negative & T & ->); rewrite T;
      assert (En : ends more) by (unfold more; first [reflexivity | exact (decimals_end _ _ Dec _ _ Pw)]);
      unfold digits at 1; rewrite (runs_digits_after _ _ _ R) by exact En;
      (destruct (Z.eqb_spec (0 + Z.of_nat (List.length ds)) 0) as [C|C];
        [destruct ds; [congruence|cbn [List.length] in C; lia]|]).
    - assert (NoSlash : take "/" more = (false, more)).
      { apply take_not. intros rest. unfold more. destruct Dec; [|discriminate].
        destruct Pw as [|e' s' f' ds' n' [-> | ->] ]; discriminate. }
      rewrite NoSlash. cbn [fst]. unfold more. destruct Dec as [|ds' m Nm].
      + assert (NoPoint : take "." e = (false, e)).
        { apply take_not. intros rest. destruct Pw as [|e' s' f' ds' n' [-> | ->] ]; discriminate. }
        cbn [app]. rewrite NoPoint. cbn [andb]. rewrite (exponent_accepted _ _ Pw).
        destruct (shifted_is negative n 0 p (Z.le_refl 0)) as (z & Z1 & EZ). exists z. split; [exact Z1|].
        rewrite EZ. change (10 ^ 0) with 1. field.
      + destruct (natural_runs _ _ Nm) as [Rm Nem]. change (("."%char :: ds') ++ e) with ("."%char :: ds' ++ e).
        rewrite take_it. assert (R' : exists value, run n ds' value) by (eapply run_exists; exact Rm).
        destruct R' as (value & R'). rewrite (runs_digits_after _ _ _ R') by exact (decimals_end _ _ no_decimals _ _ Pw).
        destruct (Z.eqb_spec (0 + Z.of_nat (List.length ds')) 0) as [C'|C'];
          [destruct ds'; [congruence|cbn [List.length] in C'; lia]|]. cbn [andb].
        rewrite (exponent_accepted _ _ Pw).
        destruct (shifted_is negative value (0 + Z.of_nat (List.length ds')) p) as (z & Z1 & EZ); [lia|].
        exists z. split; [exact Z1|]. rewrite EZ, Z.add_0_l. rewrite (behind_point value _ n m); [reflexivity|lia|].
        exact (run_from _ _ _ _ R' Rm).
    - unfold more at 1. rewrite take_it. cbn [fst]. unfold fraction_of_digits.
      destruct (natural_runs _ _ Nd) as [Rd NEd].
      unfold digits at 1. rewrite (runs_digits_after _ _ _ R) by exact En. unfold more. rewrite take_it.
      unfold digits. rewrite <- (app_nil_r den). rewrite (runs_digits_after _ _ _ Rd) by exact I.
      destruct (Z.eqb_spec (0 + Z.of_nat (List.length ds)) 0) as [C'|_]; [congruence|].
      destruct (Z.eqb_spec (0 + Z.of_nat (List.length den)) 0) as [C'|_];
        [destruct den; [congruence|cbn [List.length] in C'; lia]|]. cbn [orb].
      pose proof (run_nonneg _ _ _ Rd (Z.le_refl 0)).
      destruct (fraction_is negative n d) as (z & Z1 & EZ); [lia|]. exists z. split; [exact Z1|exact EZ]. }
  destruct G as (z & Z1 & EZ). exists z. split; [exact Z1|]. now rewrite EZ, E.
Qed.

(** The same of a value of the file. *)
Theorem read_decimal_is at_path value x : read_decimal at_path value = Fine x -> is_number value x.
Proof.
  unfold read_decimal, is_number. destruct value as [| |characters|content| |]; try discriminate.
  - destruct (parse_decimal characters) as [y|] eqn:E; [|discriminate].
    destruct (is_not_too_large y) eqn:B; [|discriminate]. intros H. injection H as <-. split; [|exact B].
    now apply decimal_read.
  - destruct (parse_decimal content) as [y|] eqn:E; [|discriminate]. intros H. injection H as <-. now apply decimal_read.
Qed.

Lemma not_too_large_same x y : (x == y)%Q -> is_not_too_large x = is_not_too_large y.
Proof.
  unfold is_not_too_large, Qeq. intros E. generalize too_large. intros L.
  assert (A : Z.abs (Qnum x) * Zpos (Qden y) = Z.abs (Qnum y) * Zpos (Qden x)).
  { rewrite <- (Z.abs_eq (Zpos (Qden y))), <- (Z.abs_eq (Zpos (Qden x))) by lia. now rewrite <- !Z.abs_mul, E. }
  apply eq_true_iff_eq. rewrite !Z.ltb_lt.
  rewrite (Z.mul_lt_mono_pos_r (Zpos (Qden y)) (Z.abs (Qnum x))), (Z.mul_lt_mono_pos_r (Zpos (Qden x)) (Z.abs (Qnum y)))
    by lia. rewrite A. replace (L * Zpos (Qden x) * Zpos (Qden y)) with (L * Zpos (Qden y) * Zpos (Qden x)) by ring.
  reflexivity.
Qed.

Theorem read_decimal_accepts at_path value x : is_number value x ->
  exists y, read_decimal at_path value = Fine y /\ (y == x)%Q.
Proof.
  unfold read_decimal, is_number. destruct value as [| |characters|content| |]; try contradiction.
  - intros [S L]. destruct (decimal_accepted _ _ S) as (y & -> & E). exists y.
    rewrite (not_too_large_same y x E), L. auto.
  - intros S. destruct (decimal_accepted _ _ S) as (y & -> & E). exists y. auto.
Qed.
End Proofs.
