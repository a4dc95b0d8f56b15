(* SPDX-License-Identifier: MIT *)
(** JSON as the tokeniser hands it over (tokenise.ml), and answers of readers.

    The tokeniser has no proof. It knows the syntax of RFC 8259 and UTF-8 and the limits of
    FORMAT.md section 2, and nothing of what a text means: numbers are still characters, objects may
    repeat members, and all else is read and refused here and in Read*.v. *)
From Coq Require Import Bool List String ZArith.
From Proved Require Export Lists.
Import ListNotations.
Local Open Scope string_scope.

Inductive json : Set :=
| Null
| Boolean (value : bool)
| Number (characters : string)
| Text (content : string)
| Array (items : list json)
| Object (members : list (string * json)).

(** A place in a text, from the inside out. *)
Inductive step : Set := Member (name : string) | Element (index : Z).
Definition path : Set := list step.

(** What is wrong: the value that was found, if the message is to show it, and what was expected. *)
Inductive result (A : Type) : Type :=
| Fine (value : A)
| Malformed (at_path : path) (found : option json) (problem : string).
Arguments Fine {A}.
Arguments Malformed {A}.

Definition bind {A B : Type} (first : result A) (next : A -> result B) : result B :=
  match first with
  | Fine value => next value
  | Malformed at_path found problem => Malformed at_path found problem
  end.
Notation "'let*' x := first 'in' next" := (bind first (fun x => next))
  (at level 200, x name, first at level 100, next at level 200, right associativity).
Notation "'let*' ' x := first 'in' next" := (bind first (fun x => next))
  (at level 200, x pattern, first at level 100, next at level 200, right associativity).

Definition refuse {A : Type} (at_path : path) (problem : string) : result A :=
  Malformed at_path None problem.

Definition expected {A : Type} (what : string) (at_path : path) (found : json) : result A :=
  Malformed at_path (Some found) what.

(** [check good problem at_path]: nothing, if [good]. *)
Definition check_that (good : bool) (at_path : path) (problem : string) : result unit :=
  if good then Fine tt else refuse at_path problem.

Definition is_text (wanted : string) (value : json) : bool :=
  match value with Text content => String.eqb content wanted | _ => false end.

(** Of lists of any length, as in Lists.v. *)
Section Each.
  Context {A B : Type}.
  Variable read : path -> A -> result B.

  Fixpoint each_from (index : Z) (at_path : path) (items : list A) (done : list B)
    : result (list B) :=
    match items with
    | [] => Fine (rev_append done [])
    | item :: rest =>
        match read (Element index :: at_path) item with
        | Fine value => each_from (index + 1)%Z at_path rest (value :: done)
        | Malformed where_ found problem => Malformed where_ found problem
        end
    end.

  Definition each (at_path : path) (items : list A) : result (list B) :=
    each_from 0 at_path items [].
End Each.

Definition read_array {B : Type} (what : string) (read : path -> json -> result B)
  (at_path : path) (value : json) : result (list B) :=
  match value with
  | Array items => each read at_path items
  | _ => expected what at_path value
  end.

(** Objects. *)
Fixpoint find_member (name : string) (members : list (string * json)) : option json :=
  match members with
  | [] => None
  | (key, value) :: rest => if String.eqb key name then Some value else find_member name rest
  end.

Definition has_member (name : string) (members : list (string * json)) : bool :=
  match find_member name members with Some _ => true | None => false end.

Definition is_among (name : string) (names : list string) : bool := existsb (String.eqb name) names.

Definition listed (names : list string) : string := String.concat ", " names.

(** Every member is one of [names], and none is there twice. *)
Fixpoint check_members (names : list string) (at_path : path) (members : list (string * json))
  : result unit :=
  match members with
  | [] => Fine tt
  | (key, _) :: rest =>
      if negb (is_among key names)
      then refuse (Member key :: at_path) ("unknown member; known here are " ++ listed names)
      else if has_member key rest
      then refuse (Member key :: at_path) "the member appears twice; keep one of them"
      else check_members names at_path rest
  end.

(** The members of an object that has no others than [names], none twice. *)
Definition members_of (names : list string) (at_path : path) (value : json)
  : result (list (string * json)) :=
  match value with
  | Object members => let* _ := check_members names at_path members in Fine members
  | _ => expected "an object {...}" at_path value
  end.

(** Every member is one of [names], in their order, and so none is there twice. *)
Fixpoint after (key : string) (names : list string) : option (list string) :=
  match names with
  | [] => None
  | name :: rest => if String.eqb key name then Some rest else after key rest
  end.

Fixpoint check_order (names : list string) (at_path : path) (members : list (string * json))
  : result unit :=
  match members with
  | [] => Fine tt
  | (key, _) :: rest =>
      match after key names with
      | None => refuse (Member key :: at_path) "the member is unknown or out of order"
      | Some names_left => check_order names_left at_path rest
      end
  end.

Definition members_in_order (names : list string) (at_path : path) (value : json)
  : result (list (string * json)) :=
  match value with
  | Object members => let* _ := check_order names at_path members in Fine members
  | _ => expected "an object {...}" at_path value
  end.

Definition member {A : Type} (name : string) (read : path -> json -> result A) (at_path : path)
  (members : list (string * json)) : result A :=
  match find_member name members with
  | Some value => read (Member name :: at_path) value
  | None => refuse at_path ("the member """ ++ name ++ """ is missing")
  end.

Definition optional_member {A : Type} (name : string) (read : path -> json -> result A)
  (at_path : path) (members : list (string * json)) : result (option A) :=
  match find_member name members with
  | Some value => let* it := read (Member name :: at_path) value in Fine (Some it)
  | None => Fine None
  end.
