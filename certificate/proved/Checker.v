(* SPDX-License-Identifier: MIT *)
(* The checker: from a question and a certificate to the answer, with an oracle that nobody has to
   believe.  Correct.v proves that its answers are true. *)
From Coq Require Import List String ZArith QArith Bool.
From Proved Require Import Lists Question Cone Numbers Box Contacts Leaf Tree Witness Margin.
Import ListNotations.
Open Scope string_scope.

Definition enlarge_all (bits : Z) (qs : list contact) : option (list row) :=
  all_some (fun q => match enlarge bits q with Some b => Some (make_row b) | None => None end) qs.

Section Numbers.
Open Scope Z_scope.

(* A multiple of all denominators of leaves, but for those of alphas; and a power of two with which every term
   of a leaf keeps about 64 bits, if that is shorter and there are no alphas. *)
Definition common_multiple (rows : list row) (ld : load) : Z :=
  fold_left (fun m r => Z.lcm m (over_weight r)) rows (over (load_scaling ld)).

Definition short_multiple (rows : list row) (multiple : Z) : Z :=
  let most := fold_left (fun b r => Z.max b (over_weight r / weight r)) rows 1 in
  let short := Z.shiftl 1 (Z.log2 most + 65) in
  if (short <? multiple) && forallb (fun r => box_signed (box r)) rows then short else multiple.

Definition most_depth {A : Type} (rows : list A) : Z :=
  fold_left (fun n _ => n + 2) rows 256.

End Numbers.

(* The box that the question is about. *)
Definition setting_of (bits : Z) (q : question) : option setting :=
  match enlarge_all bits (contacts q) with
  | None => None
  | Some rows =>
      let ld := make_load (wrench q) (direction q) in
      let m := common_multiple rows ld in
      Some (Setting (dimension q) rows ld [] (short_multiple rows m) m)
  end.

(* Whether it is one point. *)
Definition is_one_grasp (s : setting) : bool :=
  exact_rows (rows s) && forallb certain (load_box (the_load s)).

Section Check.
Variable memory : Type.
Variable advisor : oracle memory.

Definition refute (q : question) (s : setting) (ranges : list range) (nodes : list node)
    : option (string * nat) :=
  walk_ranges memory advisor (most_depth (rows s)) (bilateral q) s ranges nodes.

Definition at_zero : range := Range 0 (Some 0%Q) false false.

Definition check_witness (q : question) (s : setting) (w : witness) : answer :=
  if is_one_grasp s then
    match check_at (bilateral q) (dimension q) (rows s) (the_load s) (Point (Some 0%Q) w) with
    | inl _ => Stable
    | inr rule => Rejected rule Nowhere
    end
  else Rejected "witness-box" Nowhere.

Definition check_tree (q : question) (s : setting) (nodes : list node) : answer :=
  match refute q s [at_zero] nodes with
  | None => Unstable
  | Some (rule, number) => Rejected rule (AtNode number)
  end.

Definition check_margin (q : question) (s : setting) (resisted : list (Q * option Q))
    (segments : list segment) (nodes : list node) : answer :=
  if is_one_grasp s then
    match order_fails (Some 0%Q) true resisted 0 with
    | Some number => Rejected "resisted-order" (AtInterval number)
    | None =>
        match segments_fail (bilateral q) (dimension q) (rows s) (the_load s) segments resisted None None 0 with
        | Some (rule, found_at) => Rejected rule found_at
        | None =>
            match refute q s (gaps resisted) nodes with
            | None => Margin resisted
            | Some (rule, number) => Rejected rule (AtNode number)
            end
        end
    end
  else NotProvedHere "a margin of a box".

(* ---- Claims ---- *)

(* w and P are 0. *)
Definition at_rest (q : question) : bool :=
  let is_0 i := Qeq_bool (low i) 0 && Qeq_bool (high i) 0 in
  forallb is_0 (wrench q) && forallb (fun c => is_0 (preload c)) (contacts q).

(* Of the interval after one that ended with `before`. *)
Definition in_order (stable : bool) (before : option Q) (lo : Q) (hi : option Q) : bool :=
  match before with
  | None => false
  | Some b =>
      Qle_bool b lo &&
      match hi with Some h => if stable then Qle_bool lo h else Qlt_bool lo h | None => true end
  end.

(* Nothing, if the points hold all from lo to hi. *)
Definition points_fail (q : question) (s : setting) (number : nat) (lo : Q) (hi : option Q)
    (points : list witness) : option answer :=
  let at_ l w := check_at (bilateral q) (dimension q) (rows s) (the_load s) (Point (Some l) w) in
  let low := match hi with None => 1%Q | Some _ => lo end in
  let failing rule second := Some (Rejected rule (AtPointOf number second)) in
  if negb (is_one_grasp s) then failing "witness-box" false
  else
    match points, hi with
    | [w], _ =>
        match at_ low w with
        | inr rule => failing rule false
        | inl _ => if match hi with Some h => Qeq_bool lo h | None => true end then None
                   else Some (NotProvedHere "one point of two")
        end
    | [w; w'], Some h =>
        match at_ low w with
        | inr rule => failing rule false
        | inl ss =>
            match at_ h w' with
            | inr rule => failing rule true
            | inl ss' =>
                if same_mode ss ss' then None else Some (Rejected "segment-mode" (AtInterval number))
            end
        end
    | _, _ => Some (NotProvedHere "points of another number")
    end.

(* With the claim, and as one with that before if they touch. *)
Definition joined (resisted : list (Q * option Q)) (lo : Q) (hi : option Q) : list (Q * option Q) :=
  match resisted with
  | (lo', Some hi') :: rest => if Qeq_bool hi' lo then (lo', hi) :: rest else (lo, hi) :: resisted
  | _ => (lo, hi) :: resisted
  end.

(* `resisted` and `refuted` are in reverse order. *)
Fixpoint check_claims (q : question) (s : setting) (claims : list claim) (before : option Q) (number : nat)
    (resisted : list (Q * option Q)) (refuted : list (Q * option Q * bool)) : answer :=
  match claims with
  | [] => Claims (rev_append resisted []) (rev_append refuted [])
  | ClaimPart _ _ _ :: _ => NotProvedHere "a proof by degree or at rest"
  | ClaimPoints lo hi points :: rest =>
      if negb (in_order true before lo hi) then Rejected "interval-order" (AtInterval number)
      else if match hi with None => negb (Qeq_bool lo 0 && at_rest q) | Some _ => false end
      then Rejected "interval-whole" (AtInterval number)
      else
        match points_fail q s number lo hi points with
        | Some failure => failure
        | None => check_claims q s rest hi (S number) (joined resisted lo hi) refuted
        end
  | ClaimUnstable lo hi nodes :: rest =>
      if negb (in_order false before lo hi) then Rejected "interval-order" (AtInterval number)
      else
        let with_low := match number with O => Qeq_bool lo 0 && negb (at_rest q) | _ => false end in
        match refute q s [Range lo hi (negb with_low) true] nodes with
        | Some (rule, node) => Rejected rule (AtNodeOf number node)
        | None => check_claims q s rest hi (S number) resisted ((lo, hi, with_low) :: refuted)
        end
  end.

Definition check (q : question) (c : certificate) : answer :=
  match setting_of (bits c) q with
  | None => NotProvedHere "normals that are uncertain, or numbers of the question"
  | Some s =>
      match body c, is_margin q with
      | StableByWitness w, false => check_witness q s w
      | UnstableByTree nodes, false => check_tree q s nodes
      | StableByParts _, false => NotProvedHere "a proof by degree or at rest"
      | MarginBy resisted segments nodes, true => check_margin q s resisted segments nodes
      | MarginByDegree, true => NotProvedHere "segments by degree"
      | MarginInSpace claims, true =>
          if forallb (fun c => match c with ClaimPart _ _ _ => false | _ => true end) claims
          then check_claims q s claims (Some 0%Q) 0 [] []
          else NotProvedHere "a proof by degree or at rest"
      | _, _ => NotProvedHere "a proof of something else than was asked"
      end
  end.

End Check.
