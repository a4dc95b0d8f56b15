(* SPDX-License-Identifier: MIT *)
(* The checker: from a question and a certificate to the answer, with an oracle that nobody has to
   believe.  Correct.v proves that its answers are true. *)
From Coq Require Import List String ZArith QArith Bool.
From Proved Require Import Lists Question Cone Numbers Box Contacts Leaf Tree Witness Margin Parts.
Import ListNotations.
Open Scope string_scope.

Definition enlarge_all (bits : Z) (qs : list contact) : option (list row) :=
  all_some (fun q => match enlarge bits q with Some b => Some (make_row b) | None => None end) qs.

Definition most_depth {A : Type} (rows : list A) : Z := (fold_left (fun n _ => n + 2) rows 256)%Z.

(* The box that the question is about. *)
Definition setting_of (bits : Z) (q : question) : option setting :=
  match enlarge_all bits (contacts q) with
  | None => None
  | Some rows => Some (make_setting (dimension q) rows (make_load (wrench q) (direction q)) [])
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

Definition check_parts (q : question) (s : setting) (parts : list part) : answer :=
  match parts_fail memory advisor (bilateral q) (most_depth (rows s)) parts [(s, 0%Z)] 0 with
  | None => Stable
  | Some (rule, found_at) => Rejected rule found_at
  end.

Definition check_margin (q : question) (s : setting) (resisted : list (Q * option Q))
    (segments : list segment) (nodes : list node) : answer :=
  if is_one_grasp s then
    match order_fails (Some 0%Q) true resisted 0 with
    | Some number => Rejected "resisted-order" (AtInterval number)
    | None =>
        match segments_fail (bilateral q) (dimension q) (rows s) (the_load s)
                (segment_by_degree_fails memory advisor (bilateral q) (most_depth (rows s)) s) (unloaded s)
                segments resisted None None 0 with
        | Some (rule, found_at) => Rejected rule found_at
        | None =>
            match refute q s (gaps resisted) nodes with
            | None => Margin resisted
            | Some (rule, number) => Rejected rule (AtNode number)
            end
        end
    end
  else NotProvedHere "a margin of a box".

Definition check (q : question) (c : certificate) : answer :=
  match setting_of (bits c) q with
  | None => NotProvedHere "normals that are uncertain, or numbers of the question"
  | Some s =>
      match body c, is_margin q with
      | StableByWitness w, false => check_witness q s w
      | UnstableByTree nodes, false => check_tree q s nodes
      | StableByParts parts, false => check_parts q s parts
      | MarginBy resisted segments nodes, true => check_margin q s resisted segments nodes
      | MarginInSpace _, true => NotProvedHere "a margin in space"
      | _, _ => NotProvedHere "a proof of something else than was asked"
      end
  end.

End Check.
