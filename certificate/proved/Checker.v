(* SPDX-License-Identifier: MIT *)
(* The checker: from a question and a certificate to the answer, with an oracle that nobody has to
   believe.  Correct.v proves that its answers are true. *)
From Coq Require Import List String ZArith QArith Bool.
From Proved Require Import Lists Question Cone Numbers Bound Box Contacts Bodies Load Leaf Tree Witness Margin Parts Matrix Rigid RigidClass Plane StaticsRules.
Import ListNotations.
Open Scope string_scope.

Definition enlarge_all (bits : Z) (qs : list contact) : option (list row) :=
  all_some (fun q => match enlarge bits q with Some b => Some (make_row b) | None => None end) qs.

Definition most_depth {A : Type} (rows : list A) : Z := (fold_left (fun n _ => n + 2) rows 256)%Z.

Definition rows_of (bits : Z) (q : question) : option (list row) :=
  match several q with
  | None => enlarge_all bits (contacts q)
  | Some its =>
      match mechanism_boxes bits (dimension q) its (contacts q) with
      | Some boxes => Some (map_all make_row boxes)
      | None => None
      end
  end.

(* The wrenches of unit forces at a point, and of unit torques. *)
Definition unit_loads (point : list Q) : option matrix :=
  match point with
  | [x; y] => Some [[1; 0; - y]; [0; 1; x]; [0; 0; 1]]%Q
  | [x; y; z] => Some [[1; 0; 0; 0; z; - y]; [0; 1; 0; - z; 0; x]; [0; 0; 1; y; - x; 0];
                       [0; 0; 0; 1; 0; 0]; [0; 0; 0; 0; 1; 0]; [0; 0; 0; 0; 0; 1]]%Q
  | _ => None
  end.

Definition addition_of (b : ball) : option addition :=
  let forces := List.length (about b) in
  match unit_loads (about b) with
  | Some ways =>
      if Qle_bool (radius b) 0 || Qle_bool (torque_length b) 0 then None
      else
        let most := (repeat (radius b) forces ++ repeat (radius b * torque_length b)%Q (List.length ways - forces))%list in
        Some (Addition (map (fun m => Interval (- m) m) most) ways (map (fun m => m * m)%Q most))
  | None => None
  end.

(* On a body that moves so in a unit of each coordinate. *)
Definition addition_on (motions : list (list Q)) (it : addition) : addition :=
  Addition (ball_numbers it) (map (fun way => map (inner way) motions) (ball_ways it)) (ball_squares it).

Definition load_of (q : question) : option load :=
  match load_ball q with
  | None => Some (Load (wrench q) (direction q) nothing_added)
  | Some b =>
      match addition_of b with
      | Some it =>
          Some (Load (wrench q) (direction q)
                  match several q with
                  | None => it
                  | Some its => addition_on (map (fun ms => of_number_q ms (on_body b)) (unit_motions (dimension q) its)) it
                  end)
      | None => None
      end
  end.

(* The box that the question is about. *)
Definition setting_of (bits : Z) (q : question) : option setting :=
  match rows_of bits q, load_of q with
  | Some rows, Some ld =>
      if good_bound (dimension q) (max_motion q) then Some (make_setting (dimension q) rows ld no_push (max_motion q))
      else None
  | _, _ => None
  end.

(* Whether it is one point. *)
Definition is_one_grasp (s : setting) : bool :=
  exact_rows (rows s) && one_load (the_load s).

(* No normal in space is uncertain. *)
Definition straight (s : setting) : bool := forallb (fun r => negb (box_turns (box r))) (rows s).

Section Check.
Variable advisor : oracle.

Definition refute (q : question) (s : setting) (ranges : list range) (nodes : list node)
    : option (string * nat) :=
  walk_ranges advisor no_pieces (most_depth (rows s)) (bilateral q) s ranges nodes.

Definition check_witness (q : question) (s : setting) (w : witness) : answer :=
  if is_one_grasp s then
    match check_at (bilateral q) (dimension q) (rows s) (the_load s) (the_bound s) (Point (Some 0%Q) w) with
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
  match parts_fail advisor (bilateral q) (most_depth (rows s)) parts [(s, 0%Z)] 0 with
  | None => Stable
  | Some (rule, found_at) => Rejected rule found_at
  end.

Definition check_margin (q : question) (s : setting) (resisted : list (Q * option Q))
    (segments : list segment) (nodes : list node) : answer :=
  if is_one_grasp s then
    match order_fails (Some 0%Q) true resisted 0 with
    | Some number => Rejected "resisted-order" (AtInterval number)
    | None =>
        match segments_fail (bilateral q) (dimension q) (rows s) (the_load s) (the_bound s)
                (segment_by_degree_fails advisor (bilateral q) (most_depth (rows s)) s) (unloaded s)
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

(* ---- Claims ---- *)

Definition is_bounded (s : setting) : bool := match the_bound s with Some _ => true | None => false end.

(* Of the interval after one that ended with `before`. *)
Definition in_order (stable : bool) (before : option Q) (lo : Q) (hi : option Q) : bool :=
  match before with
  | None => false
  | Some b =>
      Qle_bool b lo &&
      match hi with Some h => if stable then Qle_bool lo h else Qlt_bool lo h | None => true end
  end.

(* Nothing, if a part or points hold all from lo to hi; without end, what holds 1 does. *)
Definition holding_fails (q : question) (s : setting) (number : nat) (lo : Q) (hi : option Q)
    (evidence : part + list witness) : option answer :=
  let at_ l w := check_at (bilateral q) (dimension q) (rows s) (the_load s) (the_bound s) (Point (Some l) w) in
  let low := match hi with None => 1%Q | Some _ => lo end in
  let high := match hi with None => 1%Q | Some h => h end in
  let failing rule second := Some (Rejected rule (AtPointOf number second)) in
  match evidence with
  | inl p =>
      match part_fails advisor (bilateral q) (most_depth (rows s)) low high s p with
      | Some (rule, node) => Some (Rejected rule (AtProofOf number node))
      | None => None
      end
  | inr points =>
      if negb (is_one_grasp s) then failing "witness-box" false
      else
        match points with
        | [] => Some (NotProvedHere "no points")
        | w :: more =>
            match at_ low w with
            | inr rule => failing rule false
            | inl ss =>
                match more with
                | [] => if Qeq_bool low high then None else Some (NotProvedHere "one point of two")
                | w' :: _ =>
                    match at_ high w' with
                    | inr rule => failing rule true
                    | inl ss' =>
                        if same_mode ss ss' then None else Some (Rejected "segment-mode" (AtInterval number))
                    end
                end
            end
        end
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
  | ClaimStable lo hi evidence :: rest =>
      if negb (in_order true before lo hi) then Rejected "interval-order" (AtInterval number)
      else if match hi with None => negb (Qeq_bool lo 0 && unloaded s && negb (is_bounded s)) | Some _ => false end
      then Rejected "interval-whole" (AtInterval number)
      else
        match holding_fails q s number lo hi evidence with
        | Some failure => failure
        | None => check_claims q s rest hi (S number) (joined resisted lo hi) refuted
        end
  | ClaimUnstable lo hi nodes :: rest =>
      if negb (in_order false before lo hi) then Rejected "interval-order" (AtInterval number)
      else
        let with_low := match number with O => Qeq_bool lo 0 && negb (unloaded s) | _ => false end in
        match refute q s [Range lo hi (negb with_low) true] nodes with
        | Some (rule, node) => Rejected rule (AtProofOf number (Some node))
        | None => check_claims q s rest hi (S number) resisted ((lo, hi, with_low) :: refuted)
        end
  end.

(* Of rigid contacts: nothing may be uncertain. *)
Definition check_class (q : question) (s : setting) (p : class_proof) : answer :=
  match masses (inertia q), all_some rigid_of (rows s) with
  | Some mass, Some xs =>
      if Nat.eqb (List.length mass) (dimension q) && straight s && one_load (the_load s) then
        match class_fails (most_depth (rows s)) mass (map low (load_box (the_load s))) xs p with
        | None => Class (class_of p)
        | Some (rule, Some number) => Rejected rule (AtNode number)
        | Some (rule, None) => Rejected rule Nowhere
        end
      else NotProvedHere "rigid contacts that are uncertain"
  | _, _ => NotProvedHere "rigid contacts that are uncertain"
  end.

(* Of a plane of loads. *)
Definition check_region (q : question) (s : setting) (pieces : list (list load_point)) (nodes : list node) : answer :=
  match load_plane q with
  | Some (u, v) =>
      let n := dimension q in
      let w := load_box (the_load s) in
      if Nat.eqb n 3 && is_one_grasp s && negb (is_bounded s) && Nat.eqb (List.length w) n && Nat.eqb (List.length u) n &&
         Nat.eqb (List.length v) n && forallb (fun r => does_not_grow (box r)) (rows s) then
        match pieces_fail (bilateral q) n (rows s) w u v pieces 0 with
        | Some (rule, found_at) => Rejected rule found_at
        | None =>
            let parts := map (map load_part) pieces in
            match plane_fails advisor (most_depth (rows s)) (bilateral q) n (rows s) w u v parts nodes with
            | None => Region parts
            | Some (rule, number) => Rejected rule (AtNode number)
            end
        end
      else NotProvedHere "a plane of loads of a box"
  | None => NotProvedHere "a proof of something else than was asked"
  end.

(* Of all questions but those of statics. *)
Definition check_motions (q : question) (c : certificate) : answer :=
  match setting_of (bits c) q with
  | None => NotProvedHere "numbers of the question"
  | Some s =>
      match body c, is_margin q with
      | RegionBy pieces nodes, _ => check_region q s pieces nodes
      | OfClass p, _ =>
          match inertia q with
          | [] => NotProvedHere "a proof of something else than was asked"
          | _ => check_class q s p
          end
      | StableByWitness w, false => check_witness q s w
      | UnstableByTree nodes, false => check_tree q s nodes
      | StableByParts parts, false => check_parts q s parts
      | MarginBy resisted segments nodes, true => check_margin q s resisted segments nodes
      | MarginInSpace claims, true => check_claims q s claims (Some 0%Q) 0 [] []
      | _, _ => NotProvedHere "a proof of something else than was asked"
      end
  end.

Definition check (q : question) (c : certificate) : answer :=
  match body c with OfStatics p => check_statics q p | _ => check_motions q c end.

End Check.
