(* SPDX-License-Identifier: MIT *)
(* The rules of statics (FORMAT.md section 16), computed: with the motion of one body at a time, and with forces added
   on the body where they act.  Statics.v proves what follows where they hold. *)
From Coq Require Import List Arith String ZArith QArith Bool.
From Proved Require Import Lists Question Numbers Root Cone Box Matrix Bodies.
Import ListNotations.
Local Open Scope Q_scope.
Local Open Scope string_scope.

(* A contact without uncertainty, with friction as it is multiplied, and between bodies. *)
Record held := Held {
  h_point : list Q; h_normal : list Q; h_friction : Q; h_torsion : Q; h_of : option nat; h_by : option nat
}.

Definition at_q (d : list Q) (j : nat) : Q := nth j d 0.

(* `alone`: it is of the only body, and by the ground. *)
Definition held_of (alone : bool) (factor : Q) (c : contact) : option held :=
  if forallb certain (position c) && certain (friction c) && is_zero (slope c) &&
     Qle_bool 0 factor && Qle_bool 0 (low (friction c)) && negb (forallb is_zero (normal c))
  then Some (Held (map low (position c)) (normal c) (factor * low (friction c)) (if alone then 0 else torsion c)
               (if alone then Some O else of_body c) (if alone then None else by_body c))
  else None.

(* L^2 *)
Definition square_of_normal (c : held) : Q := inner (h_normal c) (h_normal c).

(* ---- Twists ---- *)

(* N.d of the motion d as it is seen from the other body, and L^2 |S d|^2. *)
Definition press_and_rub (c : held) (d : list Q) : Q * Q :=
  match h_point c, h_normal c with
  | [px; py], [nx; ny] =>
      let ux := reduced (at_q d 0 - at_q d 2 * py) in
      let uy := reduced (at_q d 1 + at_q d 2 * px) in
      let slip := reduced (nx * uy - ny * ux) in
      (reduced (nx * ux + ny * uy), slip * slip)
  | [px; py; pz], [nx; ny; nz] =>
      let rx := at_q d 3 in let ry := at_q d 4 in let rz := at_q d 5 in
      let ux := reduced (at_q d 0 + (ry * pz - rz * py)) in
      let uy := reduced (at_q d 1 + (rz * px - rx * pz)) in
      let uz := reduced (at_q d 2 + (rx * py - ry * px)) in
      let press := reduced (nx * ux + ny * uy + nz * uz) in
      let turn := h_torsion c * reduced (nx * rx + ny * ry + nz * rz) in
      (press, square_of_normal c * reduced (ux * ux + uy * uy + uz * uz) - press * press + turn * turn)
  | _, _ => (-(1), 0)
  end.

(* No force in the cone does work below 0. *)
Definition unopposed_by (c : held) (d : list Q) : bool :=
  let (press, rub) := press_and_rub c d in
  Qle_bool 0 press && Qle_bool (h_friction c * h_friction c * rub) (press * press).

(* A spring whose preload is all that it exerts. *)
Definition is_loose (e : element) : bool := element_spring e && is_zero (low (element_stiffness e)).

Definition unopposed_by_element (y : list Q) (e : element) : bool :=
  let work := inner (lever e) y in
  if element_spring e then is_loose e || is_zero work else Qle_bool 0 work.

Definition relative_q (all : list (list Q)) (c : held) : list Q :=
  match h_by c with
  | None => of_number_q all (h_of c)
  | by_ => map reduced (add_multiple (of_number_q all (h_of c)) (-(1)) (of_number_q all by_))
  end.

(* What is asked about: bodies and their contacts, ratchets and springs; and the load, with the preloads of loose springs,
   then its directions. *)
Record standing := Standing {
  s_numbers : nat;           (* of a motion of one body *)
  s_dimension : nat;
  s_bodies : list rigid_body;
  s_contacts : list held;
  s_elements : list element;
  s_loads : list (list Q)
}.

(* static-motion, but for the load *)
Definition unopposed (s : standing) (y : list Q) : bool :=
  let all := motions_q (s_numbers s) y (s_bodies s) [] in
  Nat.eqb (List.length y) (s_dimension s) &&
  forallb (fun c => unopposed_by c (relative_q all c)) (s_contacts s) &&
  forallb (unopposed_by_element y) (s_elements s).

(* ---- Forces ---- *)

(* static-force of a contact, and of a ratchet or a spring *)
Definition is_lawful (c : held) (force : Q * list Q) : bool :=
  let (a, f) := force in
  let most := h_friction c * h_friction c * (a * a) in
  Qle_bool 0 a &&
  match h_normal c, f with
  | [nx; ny], [b] => Qle_bool (b * b) most
  | [nx; ny; nz], x :: y :: z :: moment =>
      let square := square_of_normal c in
      let e2 := h_torsion c * h_torsion c in
      let size := x * x + y * y + z * z in
      is_zero (nx * x + ny * y + nz * z) && Qle_bool size (square * most) &&
      match moment with
      | [] => is_zero (h_torsion c)
      | [m] => negb (is_zero (h_torsion c)) && Qle_bool (e2 * size + square * (m * m)) (e2 * (square * most))
      | _ => false
      end
  | _, _ => false
  end.

Definition is_lawful_pull (e : element) (force : Q * list Q) : bool :=
  let (a, f) := force in
  forallb is_zero f && if element_spring e then negb (is_loose e) else Qle_bool 0 a.

(* The force of each; None if the rule is broken.  And what is left of the list. *)
Fixpoint take {A} (good : A -> Q * list Q -> bool) (xs : list A) (i : Z) (them : stated_forces)
    (before : list (A * option (Q * list Q))) : option (list (A * option (Q * list Q)) * Z * stated_forces) :=
  match xs with
  | [] => Some (rev_append before [], i, them)
  | x :: xs' =>
      match them with
      | (j, force) :: rest =>
          if Z.eqb i j then
            if good x force then take good xs' (i + 1) rest ((x, Some force) :: before) else None
          else take good xs' (i + 1) them ((x, None) :: before)
      | [] => take good xs' (i + 1) [] ((x, None) :: before)
      end
  end.

(* On the body that the normal points into. *)
Definition wrench_of (c : held) (force : Q * list Q) : list Q :=
  let (a, f) := force in
  match h_point c, h_normal c with
  | [px; py], [nx; ny] =>
      let b := at_q f 0 in
      let fx := reduced (a * nx - b * ny) in
      let fy := reduced (a * ny + b * nx) in
      [fx; fy; reduced (px * fy - py * fx)]
  | [px; py; pz], [nx; ny; nz] =>
      let m := at_q f 3 in
      let fx := reduced (a * nx + at_q f 0) in
      let fy := reduced (a * ny + at_q f 1) in
      let fz := reduced (a * nz + at_q f 2) in
      [fx; fy; fz; reduced (py * fz - pz * fy + m * nx); reduced (pz * fx - px * fz + m * ny);
       reduced (px * fy - py * fx + m * nz)]
  | _, _ => []
  end.

(* Wrenches by the numbers of bodies. *)
Fixpoint add_on (number : nat) (s : Q) (w : list Q) (ws : list (list Q)) : list (list Q) :=
  match ws, number with
  | [], _ => []
  | v :: ws', O => plus_times v s w :: ws'
  | v :: ws', S number' => v :: add_on number' s w ws'
  end.

Definition add_on_body (b : option nat) (s : Q) (w : list Q) (ws : list (list Q)) : list (list Q) :=
  match b with Some number => add_on number s w ws | None => ws end.

Definition add_contact (ws : list (list Q)) (p : held * option (Q * list Q)) : list (list Q) :=
  match p with
  | (c, Some force) => let w := wrench_of c force in add_on_body (h_by c) (-(1)) w (add_on_body (h_of c) 1 w ws)
  | (_, None) => ws
  end.

Definition add_element (total : list Q) (p : element * option (Q * list Q)) : list Q :=
  match p with
  | (e, Some (a, _)) => plus_times total a (lever e)
  | (_, None) => total
  end.

(* To numbers from the first one on. *)
Fixpoint add_from (first : nat) (w total : list Q) : list Q :=
  match first, total with
  | O, _ => plus_times total 1 w
  | S first', [] => 0 :: add_from first' w []
  | S first', x :: total' => x :: add_from first' w total'
  end.

(* The work of wrenches on bodies by coordinate, from the last body to the first: that of a link is done on what it turns
   by, and on the body that it is on. *)
Fixpoint pull_back (n : nat) (last_first : list rigid_body) (ws : list (list Q)) (total : list Q) : list Q :=
  match last_first with
  | [] => total
  | b :: rest =>
      let w := nth (List.length rest) ws [] in
      match b with
      | Free first => pull_back n rest ws (add_from first (firstn n w) total)
      | Link on eta turns => pull_back n rest (add_on_body on 1 w ws) (plus_times total (inner w eta) turns)
      end
  end.

(* load(h, lambda), with h times the preloads of loose springs *)
Definition load_of_point (x : list Q) (loads : list (list Q)) : list Q :=
  fold_left (fun sum p => plus_times sum (fst p) (snd p)) (List.combine x loads) [].

(* static-point, static-force, static-balance; the first that fails *)
Definition point_fails (s : standing) (x : list Q) (them : stated_forces) : option string :=
  if negb (Qle_bool 0 (at_q x 0)) then Some "static-point"
  else
    match take is_lawful (s_contacts s) 0 them [] with
    | None => Some "static-force"
    | Some (contacts, i, them) =>
        match take is_lawful_pull (s_elements s) i them [] with
        | Some (pulls, _, []) =>
            let total := fold_left add_element pulls (load_of_point x (s_loads s)) in
            let ws := fold_left add_contact contacts (map (fun _ => []) (s_bodies s)) in
            if forallb is_zero (pull_back (s_numbers s) (rev_append (s_bodies s) []) ws total) then None
            else Some "static-balance"
        | _ => Some "static-force"
        end
    end.

(* ---- What a list of points and twists proves ---- *)

(* The multiples that may stand, from the first to the second, or without end: the points for h > 0, and how far they
   go. *)
Record hull := Hull { some : option (Q * Q); goes_down : bool; goes_up : bool }.

Definition more_of_hull (it : hull) (x : list Q) : hull :=
  match x with
  | [h; l] =>
      if is_zero h then
        Hull (some it) (goes_down it || negb (Qle_bool 0 l)) (goes_up it || negb (Qle_bool l 0))
      else
        let at_ := reduced (l / h) in
        Hull (Some match some it with
                   | None => (at_, at_)
                   | Some (a, b) => (if Qle_bool a at_ then a else at_, if Qle_bool at_ b then b else at_)
                   end) (goes_down it) (goes_up it)
  | _ => it
  end.

Definition multiples_of (points : list (list Q)) : option (option Q * option Q) :=
  let it := fold_left more_of_hull points (Hull None false false) in
  match some it with
  | Some (a, b) => Some (if goes_down it then None else Some a, if goes_up it then None else Some b)
  | None => None
  end.

(* Multiples below the first and above the second must move, and if the flag is set all. *)
Definition more_of_moves (it : option Q * option Q * bool) (form : list Q) : option Q * option Q * bool :=
  let '(below, above, all) := it in
  match form with
  | [work; growth] =>
      if is_zero growth then (below, above, all || negb (Qle_bool work 0))
      else
        let border := reduced (- work / growth) in
        if Qle_bool 0 growth then
          (below, Some match above with Some a => if Qle_bool a border then a else border | None => border end, all)
        else
          (Some match below with Some b => if Qle_bool border b then b else border | None => border end, above, all)
  | _ => it
  end.

Definition moves_of (forms : list (list Q)) : option Q * option Q * bool :=
  fold_left more_of_moves forms (None, None, false).

(* ---- The answer ---- *)

(* None if something is uncertain. *)
Definition standing_of (q : question) (factor : Q) : option standing :=
  let alone := match several q with Some _ => false | None => true end in
  let its := match several q with Some its => its | None => Mechanism (Nat.eqb (dimension q) 6) [Free 0] [] end in
  let es := elements its in
  match all_some (held_of alone factor) (contacts q), load_ball q with
  | Some cs, None =>
      if forallb certain (wrench q) && forallb (fun e => certain (element_stiffness e) && certain (element_preload e)) es
      then
        let w := fold_left (fun w e => if is_loose e then plus_times w (low (element_preload e)) (lever e) else w) es
                   (map low (wrench q)) in
        Some (Standing (numbers_of its) (dimension q) (bodies its) cs es
                (w :: match load_plane q with
                      | Some (u, v) => [u; v]
                      | None => if is_margin q then [direction q] else []
                      end))
      else None
  | _, _ => None
  end.

Fixpoint stands_fail (s : standing) (stand : list (list Q * stated_forces)) (number : nat) : option (string * nat) :=
  match stand with
  | [] => None
  | (x, them) :: rest =>
      match point_fails s x them with
      | Some rule => Some (rule, number)
      | None => stands_fail s rest (S number)
      end
  end.

Fixpoint moves_fail (s : standing) (move : list (list Q)) (number : nat) : option nat :=
  match move with
  | [] => None
  | y :: rest => if unopposed s y then moves_fail s rest (S number) else Some number
  end.

Definition triple (x : list Q) : Q * Q * Q := (at_q x 0, at_q x 1, at_q x 2).

(* The work of the load and its directions. *)
Definition form_of (s : standing) (y : list Q) : list Q := map_all (inner y) (s_loads s).

Definition check_statics (q : question) (p : statics_proof) : answer :=
  match statics q with
  | None => NotProvedHere "a proof of something else than was asked"
  | Some factor =>
      match standing_of q factor with
      | None => NotProvedHere "statics that are uncertain"
      | Some s =>
          match p with
          | ByForces them =>
              match point_fails s [1] them with
              | None => MayStand
              | Some rule => Rejected rule (AtMember "forces")
              end
          | ByMove y =>
              if unopposed s y && negb (Qle_bool (at_q (form_of s y) 0) 0) then CannotStand
              else Rejected "static-motion" (AtMember "twist")
          | ByPoints stand move =>
              match stands_fail s stand 0 with
              | Some (rule, number) => Rejected rule (AtStand number)
              | None =>
                  match moves_fail s move 0 with
                  | Some number => Rejected "static-motion" (AtMove number)
                  | None =>
                      let points := map_all fst stand in
                      let forms := map_all (form_of s) move in
                      match s_loads s with
                      | [_; _] => StandsAmong (multiples_of points) (moves_of forms)
                      | [_; _; _] => StandsWithin (map_all triple points) (map_all triple forms)
                      | _ => NotProvedHere "a proof of something else than was asked"
                      end
                  end
              end
          end
      end
  end.
