
(** val negb : bool -> bool **)

let negb = function
| true -> false
| false -> true

type nat =
| O
| S of nat

type ('a, 'b) sum =
| Inl of 'a
| Inr of 'b

(** val fst : ('a1 * 'a2) -> 'a1 **)

let fst = function
| (x, _) -> x

(** val snd : ('a1 * 'a2) -> 'a2 **)

let snd = function
| (_, y) -> y

(** val length : 'a1 list -> nat **)

let rec length = function
| [] -> O
| _ :: l' -> S (length l')

(** val app : 'a1 list -> 'a1 list -> 'a1 list **)

let rec app l m =
  match l with
  | [] -> m
  | a :: l1 -> a :: (app l1 m)

type comparison =
| Eq
| Lt
| Gt

(** val pred : nat -> nat **)

let pred n0 = match n0 with
| O -> n0
| S u -> u

module Coq__1 = struct
 (** val add : nat -> nat -> nat **)
 let rec add n0 m =
   match n0 with
   | O -> m
   | S p -> S (add p m)
end
include Coq__1

(** val mul : nat -> nat -> nat **)

let rec mul n0 m =
  match n0 with
  | O -> O
  | S p -> add m (mul p m)

(** val sub : nat -> nat -> nat **)

let rec sub n0 m =
  match n0 with
  | O -> n0
  | S k -> (match m with
            | O -> n0
            | S l -> sub k l)

(** val eqb : bool -> bool -> bool **)

let eqb b1 b2 =
  if b1 then b2 else if b2 then false else true

(** val gmax : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 -> 'a1 **)

let gmax cmp x y =
  match cmp x y with
  | Lt -> y
  | _ -> x

(** val gmin : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 -> 'a1 **)

let gmin cmp x y =
  match cmp x y with
  | Gt -> y
  | _ -> x

module Nat =
 struct
  (** val sub : nat -> nat -> nat **)

  let rec sub n0 m =
    match n0 with
    | O -> n0
    | S k -> (match m with
              | O -> n0
              | S l -> sub k l)

  (** val eqb : nat -> nat -> bool **)

  let rec eqb n0 m =
    match n0 with
    | O -> (match m with
            | O -> true
            | S _ -> false)
    | S n' -> (match m with
               | O -> false
               | S m' -> eqb n' m')

  (** val leb : nat -> nat -> bool **)

  let rec leb n0 m =
    match n0 with
    | O -> true
    | S n' -> (match m with
               | O -> false
               | S m' -> leb n' m')

  (** val ltb : nat -> nat -> bool **)

  let ltb n0 m =
    leb (S n0) m

  (** val divmod : nat -> nat -> nat -> nat -> nat * nat **)

  let rec divmod x y q0 u =
    match x with
    | O -> (q0, u)
    | S x' ->
      (match u with
       | O -> divmod x' y (S q0) y
       | S u' -> divmod x' y q0 u')

  (** val modulo : nat -> nat -> nat **)

  let modulo x = function
  | O -> x
  | S y' -> sub y' (snd (divmod x y' O y'))

  (** val iter : nat -> ('a1 -> 'a1) -> 'a1 -> 'a1 **)

  let rec iter n0 f x =
    match n0 with
    | O -> x
    | S n1 -> f (iter n1 f x)
 end

module Pos =
 struct
  type mask =
  | IsNul
  | IsPos of Big_int_Z.big_int
  | IsNeg
 end

module Coq_Pos =
 struct
  (** val succ : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec succ = Big_int_Z.succ_big_int

  (** val add :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec add = Big_int_Z.add_big_int

  (** val add_carry :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  and add_carry x y =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (add_carry p q0))
        (fun q0 -> Big_int_Z.mult_int_big_int 2 (add_carry p q0))
        (fun _ ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (succ p))
        y)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> Big_int_Z.mult_int_big_int 2 (add_carry p q0))
        (fun q0 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (add p q0))
        (fun _ -> Big_int_Z.mult_int_big_int 2 (succ p))
        y)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (succ q0))
        (fun q0 -> Big_int_Z.mult_int_big_int 2 (succ q0))
        (fun _ ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        Big_int_Z.unit_big_int)
        y)
      x

  (** val pred_double : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec pred_double x =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p ->
      (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
      (Big_int_Z.mult_int_big_int 2 p))
      (fun p ->
      (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
      (pred_double p))
      (fun _ -> Big_int_Z.unit_big_int)
      x

  (** val pred_N : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let pred_N x =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p -> (Big_int_Z.mult_int_big_int 2 p))
      (fun p -> (pred_double p))
      (fun _ -> Big_int_Z.zero_big_int)
      x

  type mask = Pos.mask =
  | IsNul
  | IsPos of Big_int_Z.big_int
  | IsNeg

  (** val succ_double_mask : mask -> mask **)

  let succ_double_mask = function
  | IsNul -> IsPos Big_int_Z.unit_big_int
  | IsPos p ->
    IsPos ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
      p)
  | IsNeg -> IsNeg

  (** val double_mask : mask -> mask **)

  let double_mask = function
  | IsPos p -> IsPos (Big_int_Z.mult_int_big_int 2 p)
  | x0 -> x0

  (** val double_pred_mask : Big_int_Z.big_int -> mask **)

  let double_pred_mask x =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p -> IsPos (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 p)))
      (fun p -> IsPos (Big_int_Z.mult_int_big_int 2
      (pred_double p)))
      (fun _ -> IsNul)
      x

  (** val sub_mask : Big_int_Z.big_int -> Big_int_Z.big_int -> mask **)

  let rec sub_mask x y =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> double_mask (sub_mask p q0))
        (fun q0 -> succ_double_mask (sub_mask p q0))
        (fun _ -> IsPos (Big_int_Z.mult_int_big_int 2 p))
        y)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun q0 -> double_mask (sub_mask p q0))
        (fun _ -> IsPos (pred_double p))
        y)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> IsNeg)
        (fun _ -> IsNeg)
        (fun _ -> IsNul)
        y)
      x

  (** val sub_mask_carry : Big_int_Z.big_int -> Big_int_Z.big_int -> mask **)

  and sub_mask_carry x y =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun q0 -> double_mask (sub_mask p q0))
        (fun _ -> IsPos (pred_double p))
        y)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> double_mask (sub_mask_carry p q0))
        (fun q0 -> succ_double_mask (sub_mask_carry p q0))
        (fun _ -> double_pred_mask p)
        y)
      (fun _ -> IsNeg)
      x

  (** val sub :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let sub = (fun n m -> Big_int_Z.max_big_int
  Big_int_Z.unit_big_int (Big_int_Z.sub_big_int n m))

  (** val mul :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec mul = Big_int_Z.mult_big_int

  (** val iter : ('a1 -> 'a1) -> 'a1 -> Big_int_Z.big_int -> 'a1 **)

  let rec iter f x n0 =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun n' -> f (iter f (iter f x n') n'))
      (fun n' -> iter f (iter f x n') n')
      (fun _ -> f x)
      n0

  (** val div2 : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let div2 p =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 -> p0)
      (fun p0 -> p0)
      (fun _ -> Big_int_Z.unit_big_int)
      p

  (** val div2_up : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let div2_up p =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 -> succ p0)
      (fun p0 -> p0)
      (fun _ -> Big_int_Z.unit_big_int)
      p

  (** val size_nat : Big_int_Z.big_int -> nat **)

  let rec size_nat p =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 -> S (size_nat p0))
      (fun p0 -> S (size_nat p0))
      (fun _ -> S O)
      p

  (** val size : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec size p =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 -> succ (size p0))
      (fun p0 -> succ (size p0))
      (fun _ -> Big_int_Z.unit_big_int)
      p

  (** val compare_cont :
      comparison -> Big_int_Z.big_int -> Big_int_Z.big_int -> comparison **)

  let rec compare_cont = (fun c x y -> let s = Big_int_Z.compare_big_int x y in
  if s = 0 then c else if s < 0 then Lt else Gt)

  (** val compare : Big_int_Z.big_int -> Big_int_Z.big_int -> comparison **)

  let compare = (fun x y -> let s = Big_int_Z.compare_big_int x y in
  if s = 0 then Eq else if s < 0 then Lt else Gt)

  (** val eqb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

  let rec eqb p q0 =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        (fun _ -> false)
        q0)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> false)
        (fun q1 -> eqb p0 q1)
        (fun _ -> false)
        q0)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> false)
        (fun _ -> false)
        (fun _ -> true)
        q0)
      p

  (** val leb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

  let leb x y =
    match compare x y with
    | Gt -> false
    | _ -> true

  (** val sqrtrem_step :
      (Big_int_Z.big_int -> Big_int_Z.big_int) -> (Big_int_Z.big_int ->
      Big_int_Z.big_int) -> (Big_int_Z.big_int * mask) ->
      Big_int_Z.big_int * mask **)

  let sqrtrem_step f g = function
  | (s, y) ->
    (match y with
     | IsPos r ->
       let s' =
         (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         (Big_int_Z.mult_int_big_int 2 s)
       in
       let r' = g (f r) in
       if leb s' r'
       then (((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
              s), (sub_mask r' s'))
       else ((Big_int_Z.mult_int_big_int 2 s), (IsPos r'))
     | _ ->
       ((Big_int_Z.mult_int_big_int 2 s),
         (sub_mask (g (f Big_int_Z.unit_big_int))
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           Big_int_Z.unit_big_int)))))

  (** val sqrtrem : Big_int_Z.big_int -> Big_int_Z.big_int * mask **)

  let rec sqrtrem p =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun p1 ->
        sqrtrem_step (fun x ->
          (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          x) (fun x ->
          (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          x) (sqrtrem p1))
        (fun p1 ->
        sqrtrem_step (fun x -> Big_int_Z.mult_int_big_int 2 x) (fun x ->
          (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          x) (sqrtrem p1))
        (fun _ -> (Big_int_Z.unit_big_int, (IsPos
        (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))))
        p0)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun p1 ->
        sqrtrem_step (fun x ->
          (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          x) (fun x -> Big_int_Z.mult_int_big_int 2 x) (sqrtrem p1))
        (fun p1 ->
        sqrtrem_step (fun x -> Big_int_Z.mult_int_big_int 2 x) (fun x ->
          Big_int_Z.mult_int_big_int 2 x) (sqrtrem p1))
        (fun _ -> (Big_int_Z.unit_big_int, (IsPos Big_int_Z.unit_big_int)))
        p0)
      (fun _ -> (Big_int_Z.unit_big_int, IsNul))
      p

  (** val sqrt : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let sqrt p =
    fst (sqrtrem p)

  (** val gcdn :
      nat -> Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec gcdn n0 a b =
    match n0 with
    | O -> Big_int_Z.unit_big_int
    | S n1 ->
      ((fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
         (fun a' ->
         (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
           (fun b' ->
           match compare a' b' with
           | Eq -> a
           | Lt -> gcdn n1 (sub b' a') a
           | Gt -> gcdn n1 (sub a' b') b)
           (fun b0 -> gcdn n1 a b0)
           (fun _ -> Big_int_Z.unit_big_int)
           b)
         (fun a0 ->
         (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
           (fun _ -> gcdn n1 a0 b)
           (fun b0 -> Big_int_Z.mult_int_big_int 2 (gcdn n1 a0 b0))
           (fun _ -> Big_int_Z.unit_big_int)
           b)
         (fun _ -> Big_int_Z.unit_big_int)
         a)

  (** val gcd :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let gcd a b =
    gcdn (Coq__1.add (size_nat a) (size_nat b)) a b

  (** val coq_Nsucc_double : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_Nsucc_double x =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> Big_int_Z.unit_big_int)
      (fun p ->
      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x)) p))
      x

  (** val coq_Ndouble : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_Ndouble n0 =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> Big_int_Z.zero_big_int)
      (fun p -> (Big_int_Z.mult_int_big_int 2 p))
      n0

  (** val coq_lor :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec coq_lor p q0 =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (coq_lor p0 q1))
        (fun q1 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (coq_lor p0 q1))
        (fun _ -> p)
        q0)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (coq_lor p0 q1))
        (fun q1 -> Big_int_Z.mult_int_big_int 2 (coq_lor p0 q1))
        (fun _ ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        p0)
        q0)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> q0)
        (fun q1 ->
        (fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        q1)
        (fun _ -> q0)
        q0)
      p

  (** val coq_land :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec coq_land p q0 =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 -> coq_Nsucc_double (coq_land p0 q1))
        (fun q1 -> coq_Ndouble (coq_land p0 q1))
        (fun _ -> Big_int_Z.unit_big_int)
        q0)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 -> coq_Ndouble (coq_land p0 q1))
        (fun q1 -> coq_Ndouble (coq_land p0 q1))
        (fun _ -> Big_int_Z.zero_big_int)
        q0)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> Big_int_Z.unit_big_int)
        (fun _ -> Big_int_Z.zero_big_int)
        (fun _ -> Big_int_Z.unit_big_int)
        q0)
      p

  (** val ldiff :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec ldiff p q0 =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 -> coq_Ndouble (ldiff p0 q1))
        (fun q1 -> coq_Nsucc_double (ldiff p0 q1))
        (fun _ -> (Big_int_Z.mult_int_big_int 2 p0))
        q0)
      (fun p0 ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q1 -> coq_Ndouble (ldiff p0 q1))
        (fun q1 -> coq_Ndouble (ldiff p0 q1))
        (fun _ -> p)
        q0)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> Big_int_Z.zero_big_int)
        (fun _ -> Big_int_Z.unit_big_int)
        (fun _ -> Big_int_Z.zero_big_int)
        q0)
      p

  (** val iter_op : ('a1 -> 'a1 -> 'a1) -> Big_int_Z.big_int -> 'a1 -> 'a1 **)

  let rec iter_op op p a =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p0 -> op a (iter_op op p0 (op a a)))
      (fun p0 -> iter_op op p0 (op a a))
      (fun _ -> a)
      p

  (** val to_nat : Big_int_Z.big_int -> nat **)

  let to_nat x =
    iter_op Coq__1.add x (S O)

  (** val of_succ_nat : nat -> Big_int_Z.big_int **)

  let rec of_succ_nat = function
  | O -> Big_int_Z.unit_big_int
  | S x -> succ (of_succ_nat x)
 end

module N =
 struct
  (** val succ_pos : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let succ_pos n0 =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> Big_int_Z.unit_big_int)
      (fun p -> Coq_Pos.succ p)
      n0

  (** val coq_lor :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_lor n0 m =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> m)
      (fun p ->
      (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
        (fun _ -> n0)
        (fun q0 -> (Coq_Pos.coq_lor p q0))
        m)
      n0

  (** val coq_land :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_land n0 m =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> Big_int_Z.zero_big_int)
      (fun p ->
      (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
        (fun _ -> Big_int_Z.zero_big_int)
        (fun q0 -> Coq_Pos.coq_land p q0)
        m)
      n0

  (** val ldiff :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let ldiff n0 m =
    (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
      (fun _ -> Big_int_Z.zero_big_int)
      (fun p ->
      (fun fO fp n -> if Big_int_Z.sign_big_int n <= 0 then fO () else fp n)
        (fun _ -> n0)
        (fun q0 -> Coq_Pos.ldiff p q0)
        m)
      n0
 end

(** val hd : 'a1 -> 'a1 list -> 'a1 **)

let hd default = function
| [] -> default
| x :: _ -> x

(** val tl : 'a1 list -> 'a1 list **)

let tl = function
| [] -> []
| _ :: m -> m

(** val nth : nat -> 'a1 list -> 'a1 -> 'a1 **)

let rec nth n0 l default =
  match n0 with
  | O -> (match l with
          | [] -> default
          | x :: _ -> x)
  | S m -> (match l with
            | [] -> default
            | _ :: t -> nth m t default)

(** val nth_error : 'a1 list -> nat -> 'a1 option **)

let rec nth_error l = function
| O -> (match l with
        | [] -> None
        | x :: _ -> Some x)
| S n1 -> (match l with
           | [] -> None
           | _ :: l0 -> nth_error l0 n1)

(** val removelast : 'a1 list -> 'a1 list **)

let rec removelast = function
| [] -> []
| a :: l0 -> (match l0 with
              | [] -> []
              | _ :: _ -> a :: (removelast l0))

(** val rev_append : 'a1 list -> 'a1 list -> 'a1 list **)

let rec rev_append l l' =
  match l with
  | [] -> l'
  | a :: l0 -> rev_append l0 (a :: l')

(** val concat : 'a1 list list -> 'a1 list **)

let rec concat = function
| [] -> []
| x :: l0 -> app x (concat l0)

(** val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let rec map f = function
| [] -> []
| a :: t -> (f a) :: (map f t)

(** val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list **)

let rec flat_map f = function
| [] -> []
| x :: t -> app (f x) (flat_map f t)

(** val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1 **)

let rec fold_left f l a0 =
  match l with
  | [] -> a0
  | b :: t -> fold_left f t (f a0 b)

(** val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1 **)

let rec fold_right f a0 = function
| [] -> a0
| b :: t -> f b (fold_right f a0 t)

(** val existsb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec existsb f = function
| [] -> false
| a :: l0 -> (||) (f a) (existsb f l0)

(** val forallb : ('a1 -> bool) -> 'a1 list -> bool **)

let rec forallb f = function
| [] -> true
| a :: l0 -> (&&) (f a) (forallb f l0)

(** val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list **)

let rec filter f = function
| [] -> []
| x :: l0 -> if f x then x :: (filter f l0) else filter f l0

(** val find : ('a1 -> bool) -> 'a1 list -> 'a1 option **)

let rec find f = function
| [] -> None
| x :: tl0 -> if f x then Some x else find f tl0

(** val combine : 'a1 list -> 'a2 list -> ('a1 * 'a2) list **)

let rec combine l l' =
  match l with
  | [] -> []
  | x :: tl0 ->
    (match l' with
     | [] -> []
     | y :: tl' -> (x, y) :: (combine tl0 tl'))

(** val firstn : nat -> 'a1 list -> 'a1 list **)

let rec firstn n0 l =
  match n0 with
  | O -> []
  | S n1 -> (match l with
             | [] -> []
             | a :: l0 -> a :: (firstn n1 l0))

(** val skipn : nat -> 'a1 list -> 'a1 list **)

let rec skipn n0 l =
  match n0 with
  | O -> l
  | S n1 -> (match l with
             | [] -> []
             | _ :: l0 -> skipn n1 l0)

(** val seq : nat -> nat -> nat list **)

let rec seq start = function
| O -> []
| S len0 -> start :: (seq (S start) len0)

(** val repeat : 'a1 -> nat -> 'a1 list **)

let rec repeat x = function
| O -> []
| S k -> x :: (repeat x k)

module Z =
 struct
  (** val double : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let double x =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.zero_big_int)
      (fun p -> (Big_int_Z.mult_int_big_int 2 p))
      (fun p -> Big_int_Z.minus_big_int (Big_int_Z.mult_int_big_int 2 p))
      x

  (** val succ_double : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let succ_double x =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.unit_big_int)
      (fun p ->
      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
      p))
      (fun p -> Big_int_Z.minus_big_int (Coq_Pos.pred_double p))
      x

  (** val pred_double : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let pred_double x =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.minus_big_int Big_int_Z.unit_big_int)
      (fun p -> (Coq_Pos.pred_double p))
      (fun p -> Big_int_Z.minus_big_int
      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x)) p))
      x

  (** val pos_sub :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let rec pos_sub x y =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> double (pos_sub p q0))
        (fun q0 -> succ_double (pos_sub p q0))
        (fun _ -> (Big_int_Z.mult_int_big_int 2 p))
        y)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> pred_double (pos_sub p q0))
        (fun q0 -> double (pos_sub p q0))
        (fun _ -> (Coq_Pos.pred_double p))
        y)
      (fun _ ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun q0 -> Big_int_Z.minus_big_int (Big_int_Z.mult_int_big_int 2
        q0))
        (fun q0 -> Big_int_Z.minus_big_int (Coq_Pos.pred_double q0))
        (fun _ -> Big_int_Z.zero_big_int)
        y)
      x

  (** val add :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let add = Big_int_Z.add_big_int

  (** val opp : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let opp = Big_int_Z.minus_big_int

  (** val sub :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let sub = Big_int_Z.sub_big_int

  (** val mul :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let mul = Big_int_Z.mult_big_int

  (** val pow_pos :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let pow_pos z0 =
    Coq_Pos.iter (mul z0) Big_int_Z.unit_big_int

  (** val pow :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let pow x y =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.unit_big_int)
      (fun p -> pow_pos x p)
      (fun _ -> Big_int_Z.zero_big_int)
      y

  (** val compare : Big_int_Z.big_int -> Big_int_Z.big_int -> comparison **)

  let compare = (fun x y -> let s = Big_int_Z.compare_big_int x y in
  if s = 0 then Eq else if s < 0 then Lt else Gt)

  (** val sgn : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let sgn z0 =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.zero_big_int)
      (fun _ -> Big_int_Z.unit_big_int)
      (fun _ -> Big_int_Z.minus_big_int Big_int_Z.unit_big_int)
      z0

  (** val leb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

  let leb = Big_int_Z.le_big_int

  (** val ltb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

  let ltb = Big_int_Z.lt_big_int

  (** val eqb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

  let eqb = Big_int_Z.eq_big_int

  (** val max :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let max = Big_int_Z.max_big_int

  (** val abs : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let abs = Big_int_Z.abs_big_int

  (** val to_nat : Big_int_Z.big_int -> nat **)

  let to_nat z0 =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> O)
      (fun p -> Coq_Pos.to_nat p)
      (fun _ -> O)
      z0

  (** val of_nat : nat -> Big_int_Z.big_int **)

  let of_nat = function
  | O -> Big_int_Z.zero_big_int
  | S n1 -> (Coq_Pos.of_succ_nat n1)

  (** val of_N : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let of_N = (fun p -> p)

  (** val to_pos : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let to_pos z0 =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.unit_big_int)
      (fun p -> p)
      (fun _ -> Big_int_Z.unit_big_int)
      z0

  (** val pos_div_eucl :
      Big_int_Z.big_int -> Big_int_Z.big_int ->
      Big_int_Z.big_int * Big_int_Z.big_int **)

  let rec pos_div_eucl a b =
    (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
      (fun a' ->
      let (q0, r) = pos_div_eucl a' b in
      let r' =
        add (mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) r)
          Big_int_Z.unit_big_int
      in
      if ltb r' b
      then ((mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) q0),
             r')
      else ((add
              (mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) q0)
              Big_int_Z.unit_big_int), (sub r' b)))
      (fun a' ->
      let (q0, r) = pos_div_eucl a' b in
      let r' = mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) r in
      if ltb r' b
      then ((mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) q0),
             r')
      else ((add
              (mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) q0)
              Big_int_Z.unit_big_int), (sub r' b)))
      (fun _ ->
      if leb (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) b
      then (Big_int_Z.zero_big_int, Big_int_Z.unit_big_int)
      else (Big_int_Z.unit_big_int, Big_int_Z.zero_big_int))
      a

  (** val div_eucl :
      Big_int_Z.big_int -> Big_int_Z.big_int ->
      Big_int_Z.big_int * Big_int_Z.big_int **)

  let div_eucl = Big_int_Z.(fun x y ->
  match sign_big_int y with
  | 0 -> (zero_big_int, x)
  | 1 -> quomod_big_int x y
  | _ -> let (q, r) = quomod_big_int (add_int_big_int (-1) x) y in
          (add_int_big_int (-1) q, add_big_int (add_int_big_int 1 y) r))

  (** val div :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let div = Big_int_Z.(fun x y ->
  match sign_big_int y with
  | 0 -> zero_big_int
  | 1 -> div_big_int x y
  | _ -> add_int_big_int (-1) (div_big_int (add_int_big_int (-1) x) y))

  (** val modulo :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let modulo = Big_int_Z.(fun x y ->
  match sign_big_int y with
  | 0 -> x
  | 1 -> mod_big_int x y
  | _ -> add_big_int y (add_int_big_int 1 (mod_big_int (add_int_big_int (-1) x) y)))

  (** val div2 : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let div2 z0 =
    (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
      (fun _ -> Big_int_Z.zero_big_int)
      (fun p ->
      (fun f2p1 f2p f1 p ->
  if Big_int_Z.le_big_int p Big_int_Z.unit_big_int then f1 () else
  let (q,r) = Big_int_Z.quomod_big_int p (Big_int_Z.big_int_of_int 2) in
  if Big_int_Z.eq_big_int r Big_int_Z.zero_big_int then f2p q else f2p1 q)
        (fun _ -> (Coq_Pos.div2 p))
        (fun _ -> (Coq_Pos.div2 p))
        (fun _ -> Big_int_Z.zero_big_int)
        p)
      (fun p -> Big_int_Z.minus_big_int (Coq_Pos.div2_up p))
      z0

  (** val log2 : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let log2 = (fun n -> if Big_int_Z.sign_big_int n <= 0 then Big_int_Z.zero_big_int
  else Big_int_Z.big_int_of_int (Big_int_Z.num_bits_big_int n - 1))

  (** val sqrt : Big_int_Z.big_int -> Big_int_Z.big_int **)

  let sqrt = (fun n -> Big_int_Z.sqrt_big_int (Big_int_Z.max_big_int n Big_int_Z.zero_big_int))

  (** val gcd :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let gcd = Big_int_Z.gcd_big_int

  (** val shiftl :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let shiftl = Big_int_Z.(fun x y ->
  let y = int_of_big_int y in
  if y < 0 then shift_right_big_int x (-y)
  else shift_left_big_int x y)

  (** val coq_lor :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_lor = Big_int_Z.or_big_int

  (** val coq_land :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let coq_land = Big_int_Z.and_big_int

  (** val lcm :
      Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

  let lcm a b =
    abs (mul a (div b (gcd a b)))
 end

(** val zeq_bool : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

let zeq_bool x y =
  match Z.compare x y with
  | Eq -> true
  | _ -> false

type q = { qnum : Big_int_Z.big_int; qden : Big_int_Z.big_int }

(** val inject_Z : Big_int_Z.big_int -> q **)

let inject_Z x =
  { qnum = x; qden = Big_int_Z.unit_big_int }

(** val qcompare : q -> q -> comparison **)

let qcompare p q0 =
  Z.compare (Z.mul p.qnum q0.qden) (Z.mul q0.qnum p.qden)

(** val qeq_bool : q -> q -> bool **)

let qeq_bool x y =
  zeq_bool (Z.mul x.qnum y.qden) (Z.mul y.qnum x.qden)

(** val qle_bool : q -> q -> bool **)

let qle_bool x y =
  Z.leb (Z.mul x.qnum y.qden) (Z.mul y.qnum x.qden)

(** val qplus : q -> q -> q **)

let qplus x y =
  { qnum = (Z.add (Z.mul x.qnum y.qden) (Z.mul y.qnum x.qden)); qden =
    (Coq_Pos.mul x.qden y.qden) }

(** val qmult : q -> q -> q **)

let qmult x y =
  { qnum = (Z.mul x.qnum y.qnum); qden = (Coq_Pos.mul x.qden y.qden) }

(** val qopp : q -> q **)

let qopp x =
  { qnum = (Z.opp x.qnum); qden = x.qden }

(** val qminus : q -> q -> q **)

let qminus x y =
  qplus x (qopp y)

(** val qinv : q -> q **)

let qinv x =
  (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
    (fun _ -> { qnum = Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int })
    (fun p -> { qnum = x.qden; qden = p })
    (fun p -> { qnum = (Big_int_Z.minus_big_int x.qden); qden = p })
    x.qnum

(** val qdiv : q -> q -> q **)

let qdiv x y =
  qmult x (qinv y)

(** val map_all : ('a1 -> 'a2) -> 'a1 list -> 'a2 list **)

let map_all f items =
  rev_append (fold_left (fun done0 item -> (f item) :: done0) items []) []

(** val all_some_after :
    ('a1 -> 'a2 option) -> 'a1 list -> 'a2 list -> 'a2 list option **)

let rec all_some_after f items before =
  match items with
  | [] -> Some (rev_append before [])
  | item :: rest ->
    (match f item with
     | Some it -> all_some_after f rest (it :: before)
     | None -> None)

(** val all_some : ('a1 -> 'a2 option) -> 'a1 list -> 'a2 list option **)

let all_some f items =
  all_some_after f items []

(** val numbered : 'a1 list -> Big_int_Z.big_int -> 'a1 option **)

let rec numbered l i =
  match l with
  | [] -> None
  | a :: l' ->
    if Z.eqb i Big_int_Z.zero_big_int
    then Some a
    else numbered l' (Z.sub i Big_int_Z.unit_big_int)

type json =
| Null
| Boolean of bool
| Number of string
| Text of string
| Array of json list
| Object of (string * json) list

type step =
| Member of string
| Element of Big_int_Z.big_int

type path = step list

type 'a result =
| Fine of 'a
| Malformed of path * json option * string

(** val bind : 'a1 result -> ('a1 -> 'a2 result) -> 'a2 result **)

let bind first next0 =
  match first with
  | Fine value0 -> next0 value0
  | Malformed (at_path, found, problem) -> Malformed (at_path, found, problem)

(** val refuse : path -> string -> 'a1 result **)

let refuse at_path problem =
  Malformed (at_path, None, problem)

(** val expected : string -> path -> json -> 'a1 result **)

let expected what at_path found =
  Malformed (at_path, (Some found), what)

(** val check_that : bool -> path -> string -> unit result **)

let check_that good at_path problem =
  if good then Fine () else refuse at_path problem

(** val is_text : string -> json -> bool **)

let is_text wanted = function
| Text content0 -> (=) content0 wanted
| _ -> false

(** val each_from :
    (path -> 'a1 -> 'a2 result) -> Big_int_Z.big_int -> path -> 'a1 list ->
    'a2 list -> 'a2 list result **)

let rec each_from read index at_path items done0 =
  match items with
  | [] -> Fine (rev_append done0 [])
  | item :: rest ->
    (match read ((Element index) :: at_path) item with
     | Fine value0 ->
       each_from read (Z.add index Big_int_Z.unit_big_int) at_path rest
         (value0 :: done0)
     | Malformed (where_, found, problem) ->
       Malformed (where_, found, problem))

(** val each :
    (path -> 'a1 -> 'a2 result) -> path -> 'a1 list -> 'a2 list result **)

let each read at_path items =
  each_from read Big_int_Z.zero_big_int at_path items []

(** val read_array :
    string -> (path -> json -> 'a1 result) -> path -> json -> 'a1 list result **)

let read_array what read at_path value0 = match value0 with
| Array items -> each read at_path items
| _ -> expected what at_path value0

(** val find_member : string -> (string * json) list -> json option **)

let rec find_member name = function
| [] -> None
| p :: rest ->
  let (key, value0) = p in
  if (=) key name then Some value0 else find_member name rest

(** val has_member : string -> (string * json) list -> bool **)

let has_member name members =
  match find_member name members with
  | Some _ -> true
  | None -> false

(** val is_among : string -> string list -> bool **)

let is_among name names =
  existsb ((=) name) names

(** val listed : string list -> string **)

let listed names =
  String.concat ", " names

(** val check_members :
    string list -> path -> (string * json) list -> unit result **)

let rec check_members names at_path = function
| [] -> Fine ()
| p :: rest ->
  let (key, _) = p in
  if negb (is_among key names)
  then refuse ((Member key) :: at_path)
         ((^) "unknown member; known here are " (listed names))
  else if has_member key rest
       then refuse ((Member key) :: at_path)
              "the member appears twice; keep one of them"
       else check_members names at_path rest

(** val members_of :
    string list -> path -> json -> (string * json) list result **)

let members_of names at_path value0 = match value0 with
| Object members ->
  bind (check_members names at_path members) (fun _ -> Fine members)
| _ -> expected "an object {...}" at_path value0

(** val after : string -> string list -> string list option **)

let rec after key = function
| [] -> None
| name :: rest -> if (=) key name then Some rest else after key rest

(** val check_order :
    string list -> path -> (string * json) list -> unit result **)

let rec check_order names at_path = function
| [] -> Fine ()
| p :: rest ->
  let (key, _) = p in
  (match after key names with
   | Some names_left -> check_order names_left at_path rest
   | None ->
     refuse ((Member key) :: at_path) "the member is unknown or out of order")

(** val members_in_order :
    string list -> path -> json -> (string * json) list result **)

let members_in_order names at_path value0 = match value0 with
| Object members ->
  bind (check_order names at_path members) (fun _ -> Fine members)
| _ -> expected "an object {...}" at_path value0

(** val member :
    string -> (path -> json -> 'a1 result) -> path -> (string * json) list ->
    'a1 result **)

let member name read at_path members =
  match find_member name members with
  | Some value0 -> read ((Member name) :: at_path) value0
  | None -> refuse at_path ((^) "the member \"" ((^) name "\" is missing"))

(** val optional_member :
    string -> (path -> json -> 'a1 result) -> path -> (string * json) list ->
    'a1 option result **)

let optional_member name read at_path members =
  match find_member name members with
  | Some value0 ->
    bind (read ((Member name) :: at_path) value0) (fun it -> Fine (Some it))
  | None -> Fine None

type interval = { low : q; high : q }

(** val exactly : q -> interval **)

let exactly q0 =
  { low = q0; high = q0 }

type contact = { position : interval list; normal : q list; slope : q;
                 friction : interval; stiffness : interval;
                 preload : interval; preload_growth : q;
                 of_body : nat option; by_body : nat option; torsion : 
                 q }

type rigid_body =
| Free of nat
| Link of nat option * q list * q list

type element = { lever : q list; element_spring : bool;
                 element_stiffness : interval; element_preload : interval;
                 element_growth : q }

type mechanism = { bodies_in_space : bool; bodies : rigid_body list;
                   elements : element list }

type ball = { radius : q; torque_length : q; about : q list;
              on_body : nat option }

type question = { dimension : nat; bilateral : bool; is_margin : bool;
                  contacts : contact list; wrench : interval list;
                  load_ball : ball option; direction : q list;
                  load_plane : (q list * q list) option; inertia : q list;
                  statics : q option; several : mechanism option;
                  max_motion : q list option }

type parameter =
| PX
| PY
| PZ
| PTurn
| PTurnV
| PFriction
| PPreload
| PStiffness
| PWrench

type node =
| Slip of Big_int_Z.big_int
| Separation of Big_int_Z.big_int
| Plane of q list
| Cut of parameter * Big_int_Z.big_int * q
| Leaf of q list
| Moving of q list * q * (Big_int_Z.big_int * (q * q list)) list
| Held of Big_int_Z.big_int

type witness = { twist : q list; shares : (Big_int_Z.big_int * q list) list }

type point = { multiple : q option; point_witness : witness }

type segment =
| Segment of point option * point
| SegmentByDegree of q option * q list * q list * q list list * q list list
   * node list

type part =
| PartCut of parameter * Big_int_Z.big_int * q
| PartProof of q list * Big_int_Z.big_int list * bool * q list list
   * q list list * node list
| PartAtRest of (Big_int_Z.big_int * q list) list
   * (Big_int_Z.big_int * q list list) list * q list
| PartSticking of q list * (Big_int_Z.big_int * q list) list
   * (Big_int_Z.big_int * q list) list
   * (Big_int_Z.big_int * q list list) list * q list * q

type claim =
| ClaimStable of q * q option * (part, witness list) sum
| ClaimUnstable of q * q option * node list

type load_point = { is_at : bool; along_u : q; along_v : q;
                    load_witness : witness }

type rigid_node =
| RTouch of Big_int_Z.big_int
| RSlip of Big_int_Z.big_int * q list
| RLeaf of q * q list * (Big_int_Z.big_int * q) list
   * (Big_int_Z.big_int * q list) list

type stated_forces = (Big_int_Z.big_int * (q * q list)) list

type class_proof =
| ByTwist of q list
| ByTree of stated_forces * rigid_node list
| ByMotion of stated_forces * q list * stated_forces

type class0 =
| MustMove
| MustHold
| Open

(** val class_of : class_proof -> class0 **)

let class_of = function
| ByTwist _ -> MustMove
| ByTree (_, _) -> MustHold
| ByMotion (_, _, _) -> Open

type statics_proof =
| ByForces of stated_forces
| ByMove of q list
| ByPoints of (q list * stated_forces) list * q list list

type proof =
| StableByWitness of witness
| StableByParts of part list
| UnstableByTree of node list
| MarginBy of (q * q option) list * segment list * node list
| MarginInSpace of claim list
| OfClass of class_proof
| OfStatics of statics_proof
| RegionBy of load_point list list * node list

type certificate = { bits : Big_int_Z.big_int; body : proof }

type place =
| Nowhere
| AtNode of nat
| AtContact of Big_int_Z.big_int
| AtInterval of nat
| AtSegment of nat * nat option
| AtPoint of nat * bool
| AtPart of nat * nat option
| AtPointOf of nat * bool
| AtProofOf of nat * nat option
| AtPiece of nat * nat option
| AtMember of string
| AtStand of nat
| AtMove of nat

type answer =
| Stable
| Unstable
| Margin of (q * q option) list
| Claims of (q * q option) list * ((q * q option) * bool) list
| Class of class0
| Region of ((q * q) * q) list list
| MayStand
| CannotStand
| StandsAmong of (q option * q option) option * ((q option * q option) * bool)
| StandsWithin of ((q * q) * q) list * ((q * q) * q) list
| Rejected of string * place
| NotProvedHere of string

type oracle = { permits : (Big_int_Z.big_int -> bool);
                foremost : (Big_int_Z.big_int list list -> (Big_int_Z.big_int
                           list * bool) list -> Big_int_Z.big_int option) }

(** val qabs : q -> q **)

let qabs x =
  let { qnum = n0; qden = d } = x in { qnum = (Z.abs n0); qden = d }

(** val qmax : q -> q -> q **)

let qmax =
  gmax qcompare

(** val qmin : q -> q -> q **)

let qmin =
  gmin qcompare

type form = Big_int_Z.big_int list

(** val dot : form -> form -> Big_int_Z.big_int **)

let rec dot a b =
  match a with
  | [] -> Big_int_Z.zero_big_int
  | x :: a' ->
    (match b with
     | [] -> Big_int_Z.zero_big_int
     | y :: b' -> Z.add (Z.mul x y) (dot a' b'))

(** val combine0 :
    Big_int_Z.big_int -> form -> Big_int_Z.big_int -> form -> form **)

let rec combine0 p a q0 b =
  match a with
  | [] -> map (Z.mul q0) b
  | x :: a' ->
    (match b with
     | [] -> map (Z.mul p) a
     | y :: b' -> (Z.add (Z.mul p x) (Z.mul q0 y)) :: (combine0 p a' q0 b'))

(** val all_zero : form -> bool **)

let all_zero a =
  forallb (Z.eqb Big_int_Z.zero_big_int) a

(** val content : form -> Big_int_Z.big_int **)

let content a =
  let g = fold_right Z.gcd Big_int_Z.zero_big_int a in
  if Z.eqb g Big_int_Z.zero_big_int then Big_int_Z.unit_big_int else g

(** val primitive : form -> form **)

let primitive a =
  let g = content a in
  if Z.eqb g Big_int_Z.unit_big_int then a else map (fun x -> Z.div x g) a

type ray = { coordinates : form; zeros : bool list; tight : Big_int_Z.big_int }

(** val both : bool list -> bool list -> bool list **)

let rec both a b =
  match a with
  | [] -> []
  | x :: a' -> (match b with
                | [] -> []
                | y :: b' -> ((&&) x y) :: (both a' b'))

(** val add_strict : form list -> ray -> ray **)

let add_strict fs r =
  { coordinates = r.coordinates; zeros =
    ((forallb (fun f -> Z.eqb (dot f r.coordinates) Big_int_Z.zero_big_int)
       fs) :: r.zeros); tight = r.tight }

(** val common_zeros : form list list -> ray list -> bool list **)

let common_zeros strict0 rays0 =
  fold_right (fun r z0 -> both r.zeros z0) (map (fun _ -> true) strict0) rays0

(** val barred : form list list -> ray list -> bool **)

let barred strict0 rays0 =
  existsb (fun z0 -> z0) (common_zeros strict0 rays0)

(** val common_denominator : q list -> Big_int_Z.big_int **)

let common_denominator qs =
  fold_right (fun q0 d -> Z.lcm q0.qden d) Big_int_Z.unit_big_int qs

type scaling = { over : Big_int_Z.big_int; times : Big_int_Z.big_int }

(** val numerator : Big_int_Z.big_int -> q -> Big_int_Z.big_int **)

let numerator d q0 =
  Z.mul q0.qnum (Z.div d q0.qden)

(** val scaling_of : q list -> scaling **)

let scaling_of qs =
  let d = common_denominator qs in
  { over = d; times = (content (map (numerator d) qs)) }

(** val to_integer : scaling -> q -> Big_int_Z.big_int **)

let to_integer s q0 =
  Z.div (numerator s.over q0) s.times

(** val up : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int **)

let up a b =
  Z.opp (Z.div (Z.opp a) b)

(** val certain : interval -> bool **)

let certain i =
  qeq_bool i.low i.high

(** val ends : interval -> q list **)

let ends i =
  if certain i then i.low :: [] else i.low :: (i.high :: [])

type 'a multi =
| Tip of 'a
| Fork of 'a multi * 'a multi

(** val mmap : ('a1 -> 'a2) -> 'a1 multi -> 'a2 multi **)

let rec mmap f = function
| Tip a -> Tip (f a)
| Fork (l, h) -> Fork ((mmap f l), (mmap f h))

(** val tips : 'a1 multi -> 'a1 list **)

let rec tips = function
| Tip a -> a :: []
| Fork (l, h) -> app (tips l) (tips h)

(** val lows : 'a1 multi -> 'a1 multi **)

let lows t = match t with
| Tip _ -> t
| Fork (l, _) -> l

(** val highs : 'a1 multi -> 'a1 multi **)

let highs t = match t with
| Tip _ -> t
| Fork (_, h) -> h

(** val first_tip : 'a1 multi -> 'a1 **)

let rec first_tip = function
| Tip a -> a
| Fork (l, _) -> first_tip l

(** val spread : interval -> (q -> 'a1 multi) -> 'a1 multi **)

let spread i f =
  if certain i then f i.low else Fork ((f i.low), (f i.high))

(** val corners : interval list -> (q list -> 'a1) -> 'a1 multi **)

let rec corners box0 f =
  match box0 with
  | [] -> Tip (f [])
  | i :: box' -> spread i (fun q0 -> corners box' (fun qs -> f (q0 :: qs)))

(** val product : (Big_int_Z.big_int multi * form multi) list -> form **)

let product pairs0 =
  fold_right (fun p s ->
    combine0 (first_tip (fst p)) (first_tip (snd p)) Big_int_Z.unit_big_int s)
    [] pairs0

(** val bernstein :
    nat -> (Big_int_Z.big_int multi * form multi) list -> form list **)

let rec bernstein parameters0 pairs0 =
  match parameters0 with
  | O -> (product pairs0) :: []
  | S n0 ->
    app
      (map
        (map (Z.mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)))
        (bernstein n0
          (map (fun p -> ((lows (fst p)), (lows (snd p)))) pairs0)))
      (app
        (bernstein n0
          (flat_map (fun p -> ((lows (fst p)),
            (highs (snd p))) :: (((highs (fst p)), (lows (snd p))) :: []))
            pairs0))
        (map
          (map (Z.mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)))
          (bernstein n0
            (map (fun p -> ((highs (fst p)), (highs (snd p)))) pairs0))))

(** val power : nat -> Big_int_Z.big_int **)

let rec power = function
| O -> Big_int_Z.unit_big_int
| S n' ->
  Z.mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) (power n')

(** val exact_root : q -> q option **)

let exact_root x =
  let square = Z.mul x.qnum x.qden in
  let root0 = Z.sqrt square in
  if Z.eqb (Z.mul root0 root0) square
  then Some { qnum = root0; qden = x.qden }
  else None

(** val is_square : Big_int_Z.big_int -> bool **)

let is_square z0 =
  let r = Z.sqrt z0 in Z.eqb (Z.mul r r) z0

(** val reduced : q -> q **)

let reduced q0 =
  let g = Z.gcd q0.qnum q0.qden in
  { qnum = (Z.div q0.qnum g); qden = (Z.to_pos (Z.div q0.qden g)) }

(** val root_between : Big_int_Z.big_int -> q -> interval **)

let root_between bits0 q0 =
  let n0 = q0.qnum in
  let d = q0.qden in
  if (&&) (is_square n0) (is_square d)
  then exactly { qnum = (Z.sqrt n0); qden = (Z.to_pos (Z.sqrt d)) }
  else let root0 = fun s ->
         if Z.leb Big_int_Z.zero_big_int s
         then Z.sqrt
                (Z.div
                  (Z.shiftl n0
                    (Z.mul (Big_int_Z.mult_int_big_int 2
                      Big_int_Z.unit_big_int) s)) d)
         else Z.sqrt
                (Z.div n0
                  (Z.shiftl d
                    (Z.mul (Big_int_Z.minus_big_int
                      (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))
                      s)))
       in
       let s =
         Z.sub bits0
           (Z.div (Z.sub (Z.log2 n0) (Z.log2 d))
             (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))
       in
       let s0 =
         if Z.ltb (root0 s) (Z.shiftl Big_int_Z.unit_big_int bits0)
         then s
         else Z.sub s Big_int_Z.unit_big_int
       in
       let s1 =
         if Z.ltb (root0 s0) (Z.shiftl Big_int_Z.unit_big_int bits0)
         then s0
         else Z.sub s0 Big_int_Z.unit_big_int
       in
       let j = root0 s1 in
       let over0 = fun j0 ->
         if Z.leb Big_int_Z.zero_big_int s1
         then reduced { qnum = j0; qden =
                (Z.to_pos (Z.shiftl Big_int_Z.unit_big_int s1)) }
         else { qnum = (Z.shiftl j0 (Z.opp s1)); qden =
                Big_int_Z.unit_big_int }
       in
       { low = (over0 j); high = (over0 (Z.add j Big_int_Z.unit_big_int)) }

(** val root_above : q -> q **)

let root_above q0 =
  let u =
    (root_between (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      Big_int_Z.unit_big_int)))))) (reduced q0)).high
  in
  if (&&)
       (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } u) (qle_bool q0 (qmult u u))
  then u
  else qplus q0 { qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int }

(** val root_below : q -> q **)

let root_below q0 =
  let l =
    (root_between (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      Big_int_Z.unit_big_int)))))) (reduced q0)).low
  in
  if (&&)
       (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } l) (qle_bool (qmult l l) q0)
  then l
  else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

type cbox = { box_names : parameter list; box_geometry : interval list;
              box_forms : (q list -> q list list); box_friction : interval;
              box_preload : interval; box_growth : interval;
              box_stiffness : interval; box_square : q; box_normal : 
              q list; box_weights : q list; box_signed : bool;
              box_spring : bool; box_turns : bool;
              box_slack : (interval list -> q) }

(** val has_friction : cbox -> bool **)

let has_friction b =
  match b.box_normal with
  | [] -> false
  | _ :: _ -> true

type row = { box : cbox; forms : form list multi; forms_scale : scaling;
             metric : Big_int_Z.big_int list; metric_scale : scaling;
             slip_certain : bool; tau : form multi; minus_tau : form multi;
             edges_plus : form multi list; edges_minus : form multi list;
             edges_none : form multi list; pulls : form multi list;
             pull_scale : scaling; separates : form option; slack : q;
             parameters : nat; weight : Big_int_Z.big_int;
             over_weight : Big_int_Z.big_int }

(** val geometry_tree : cbox -> q list list multi **)

let geometry_tree b =
  corners b.box_geometry b.box_forms

(** val add_multiple : q list -> q -> q list -> q list **)

let rec add_multiple a s b =
  match a with
  | [] -> (match b with
           | [] -> a
           | _ :: _ -> map (qmult s) b)
  | x :: a' ->
    (match b with
     | [] -> a
     | y :: b' -> (qplus x (qmult s y)) :: (add_multiple a' s b'))

(** val n_of : q list list -> q list **)

let n_of t =
  nth O t []

(** val edge_tree : cbox -> q -> q list multi **)

let edge_tree b s =
  mmap (fun t -> add_multiple (n_of t) s (nth (S O) t [])) (geometry_tree b)

(** val pull_tree : cbox -> ((q * q) * q) -> q list multi **)

let pull_tree b = function
| (p0, k) ->
  let (p, u) = p0 in
  mmap (fun t -> p :: (u :: (map (qmult (qopp k)) (n_of t))))
    (geometry_tree b)

(** val scaling_of_trees : q list multi list -> scaling **)

let scaling_of_trees trees =
  scaling_of (concat (concat (map tips trees)))

(** val integer_tree : scaling -> q list multi -> form multi **)

let integer_tree s t =
  mmap (map (to_integer s)) t

(** val same_forms : form list -> bool **)

let same_forms = function
| [] -> true
| f :: fs' ->
  forallb (fun g ->
    all_zero
      (combine0 Big_int_Z.unit_big_int f (Big_int_Z.minus_big_int
        Big_int_Z.unit_big_int) g)) fs'

(** val negative : form -> form **)

let negative f =
  map Z.opp f

(** val same_at_corners : q list multi -> bool **)

let same_at_corners t =
  same_forms (tips (integer_tree (scaling_of_trees (t :: [])) t))

(** val vanishes : interval -> bool **)

let vanishes i =
  (&&)
    (qeq_bool i.low { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int })
    (qeq_bool i.high { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int })

(** val pull_certain : cbox -> bool **)

let pull_certain b =
  (&&) (same_at_corners (mmap n_of (geometry_tree b)))
    ((||)
      ((&&) ((&&) (certain b.box_preload) (certain b.box_growth))
        (certain b.box_stiffness))
      ((&&) (vanishes b.box_preload) (vanishes b.box_growth)))

(** val count : interval list -> nat **)

let count box0 =
  length (filter (fun i -> negb (certain i)) box0)

(** val of_motion : form -> form **)

let of_motion f =
  Big_int_Z.zero_big_int :: (Big_int_Z.zero_big_int :: f)

(** val minus_ends : interval -> q list **)

let minus_ends i =
  map qopp (ends i)

(** val full_range : interval -> q list **)

let full_range i =
  if qeq_bool i.high { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int }
  then { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } :: []
  else (qopp i.high) :: (i.high :: [])

(** val preload_ends : cbox -> (q * q) list **)

let preload_ends b =
  let p = b.box_preload in
  let u = b.box_growth in
  if (&&) (certain p) (certain u)
  then (p.low, u.low) :: []
  else (p.low, u.low) :: ((p.high, u.high) :: [])

(** val pull_ends : cbox -> ((q * q) * q) list **)

let pull_ends b =
  flat_map (fun pu -> map (fun k -> (pu, k)) (ends b.box_stiffness))
    (preload_ends b)

(** val forms_scaling : cbox -> scaling **)

let forms_scaling b =
  scaling_of (concat (concat (tips (geometry_tree b))))

(** val tau_tree : cbox -> q list multi **)

let tau_tree b =
  mmap (fun t -> nth (S O) t []) (geometry_tree b)

(** val pull_scaling : cbox -> scaling **)

let pull_scaling b =
  scaling_of_trees (map (pull_tree b) (pull_ends b))

(** val edge_scaling : cbox -> scaling **)

let edge_scaling b =
  scaling_of_trees
    (map (edge_tree b)
      (app (minus_ends b.box_friction)
        (app (ends b.box_friction) (full_range b.box_friction))))

(** val corner_forms : cbox -> form list multi **)

let corner_forms b =
  let s = forms_scaling b in mmap (map (map (to_integer s))) (geometry_tree b)

(** val make_row : cbox -> row **)

let make_row b =
  let none = { over = Big_int_Z.unit_big_int; times = Big_int_Z.unit_big_int }
  in
  let fs = if b.box_signed then none else forms_scaling b in
  let tau0 =
    if b.box_signed
    then mmap of_motion
           (integer_tree (scaling_of_trees ((tau_tree b) :: [])) (tau_tree b))
    else Tip []
  in
  let es = if b.box_signed then edge_scaling b else none in
  let edges0 = fun ss ->
    if b.box_signed
    then map (fun s -> integer_tree es (edge_tree b s)) ss
    else []
  in
  let ms = scaling_of b.box_weights in
  let ps = pull_scaling b in
  let pulls0 = map (fun e -> integer_tree ps (pull_tree b e)) (pull_ends b) in
  let vs = map primitive (concat (map tips pulls0)) in
  let n0 = count b.box_geometry in
  let numerator0 =
    if b.box_signed then Z.mul es.times ps.times else Big_int_Z.unit_big_int
  in
  let denominator =
    if b.box_signed
    then Z.mul (Z.mul es.over ps.over) (power n0)
    else Big_int_Z.unit_big_int
  in
  let g = content (numerator0 :: (denominator :: [])) in
  { box = b; forms = (if b.box_signed then Tip [] else corner_forms b);
  forms_scale = fs; metric = (map (to_integer ms) b.box_weights);
  metric_scale = ms; slip_certain =
  (if b.box_signed then same_at_corners (tau_tree b) else Nat.eqb n0 O);
  tau = tau0; minus_tau = (mmap negative tau0); edges_plus =
  (edges0 (minus_ends b.box_friction)); edges_minus =
  (edges0 (ends b.box_friction)); edges_none =
  (edges0 (full_range b.box_friction)); pulls = pulls0; pull_scale = ps;
  separates =
  (match vs with
   | [] -> None
   | f :: _ -> if (&&) (same_forms vs) (pull_certain b) then Some f else None);
  slack = (b.box_slack b.box_geometry); parameters = n0; weight =
  (Z.div numerator0 g); over_weight = (Z.div denominator g) }

(** val nowhere_negative : ray list -> form -> bool **)

let nowhere_negative rays0 f =
  forallb (fun r -> Z.leb Big_int_Z.zero_big_int (dot f r.coordinates)) rays0

(** val nowhere_positive : ray list -> form -> bool **)

let nowhere_positive rays0 f =
  forallb (fun r -> Z.leb (dot f r.coordinates) Big_int_Z.zero_big_int) rays0

(** val zeros_unless_negative :
    (form -> Big_int_Z.big_int) -> ray list -> ray list option **)

let rec zeros_unless_negative value0 = function
| [] -> Some []
| r :: rays' ->
  let y = value0 r.coordinates in
  if Z.ltb y Big_int_Z.zero_big_int
  then None
  else (match zeros_unless_negative value0 rays' with
        | Some zs ->
          Some (if Z.eqb y Big_int_Z.zero_big_int then r :: zs else zs)
        | None -> None)

(** val positive_at_home :
    form list list -> ray list -> (form -> Big_int_Z.big_int) -> bool **)

let positive_at_home strict0 rays0 value0 =
  match zeros_unless_negative value0 rays0 with
  | Some zs -> barred strict0 zs
  | None -> false

(** val has_sign : form list list -> ray list -> form multi -> bool **)

let has_sign strict0 rays0 t =
  forallb (fun f -> positive_at_home strict0 rays0 (dot f)) (tips t)

(** val largest : Big_int_Z.big_int list -> Big_int_Z.big_int **)

let largest = function
| [] -> Big_int_Z.zero_big_int
| z0 :: zs' -> fold_left Z.max zs' z0

type term =
| Nothing
| Line of Big_int_Z.big_int * form
| Bend of Big_int_Z.big_int * Big_int_Z.big_int * form list * bool

(** val value : term -> form -> Big_int_Z.big_int **)

let value t x =
  match t with
  | Nothing -> Big_int_Z.zero_big_int
  | Line (factor0, f) -> Z.mul factor0 (dot f x)
  | Bend (n0, d, forms0, mixed0) ->
    let most = largest (map (fun f -> dot f x) forms0) in
    up
      (Z.mul n0 (if mixed0 then Z.max Big_int_Z.zero_big_int most else most))
      d

(** val pull_tips : row -> form list **)

let pull_tips row0 =
  concat (map tips row0.pulls)

(** val collect :
    ('a1 -> term) -> 'a1 list -> form -> term list -> form * term list **)

let rec collect term_of_row rows0 linear bends =
  match rows0 with
  | [] -> (linear, bends)
  | row0 :: rows' ->
    (match term_of_row row0 with
     | Nothing -> collect term_of_row rows' linear bends
     | Line (c, f) ->
       collect term_of_row rows' (combine0 Big_int_Z.unit_big_int linear c f)
         bends
     | Bend (numerator0, denominator, forms0, mixed0) ->
       collect term_of_row rows' linear ((Bend (numerator0, denominator,
         forms0, mixed0)) :: bends))

(** val good_bound : nat -> q list option -> bool **)

let good_bound n0 = function
| Some most ->
  (&&) (Nat.eqb (length most) n0)
    (forallb (fun b -> Z.ltb Big_int_Z.zero_big_int b.qnum) most)
| None -> true

(** val bound_forms :
    Big_int_Z.big_int -> Big_int_Z.big_int list -> form -> q list -> form list **)

let rec bound_forms c signs zeros1 = function
| [] -> []
| b :: rest ->
  app
    (map (fun s ->
      (Z.mul c b.qnum) :: (Big_int_Z.zero_big_int :: (app zeros1
                                                       ((Z.mul s b.qden) :: []))))
      signs) (bound_forms c signs (Big_int_Z.zero_big_int :: zeros1) rest)

(** val sum_form : q list -> form **)

let sum_form most =
  let a = (inject_Z (Z.of_nat (length most))) :: ({ qnum =
    Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int } :: (map (fun b -> qopp (qinv b)) most))
  in
  map (to_integer (scaling_of a)) a

(** val bound_conditions : q list option -> form list **)

let bound_conditions = function
| Some most ->
  app
    (bound_forms Big_int_Z.unit_big_int (Big_int_Z.unit_big_int :: []) []
      most) ((sum_form most) :: [])
| None -> []

(** val beyond_bound : q list option -> form list list -> ray list -> bool **)

let beyond_bound bound strict0 rays0 =
  match bound with
  | Some most ->
    existsb (fun f -> positive_at_home strict0 rays0 (dot f))
      (bound_forms (Big_int_Z.minus_big_int Big_int_Z.unit_big_int)
        (Big_int_Z.unit_big_int :: ((Big_int_Z.minus_big_int
        Big_int_Z.unit_big_int) :: [])) [] most)
  | None -> false

(** val all_within : Big_int_Z.big_int -> q list -> form -> bool **)

let rec all_within h most d =
  match most with
  | [] -> (match d with
           | [] -> true
           | _ :: _ -> false)
  | b :: most' ->
    (match d with
     | [] -> false
     | z0 :: d' ->
       (&&) (Z.leb (Z.mul (Z.abs z0) b.qden) (Z.mul b.qnum h))
         (all_within h most' d'))

(** val point_within : q list option -> form -> bool **)

let point_within bound x =
  match bound with
  | Some most ->
    (match x with
     | [] -> false
     | h :: l -> (match l with
                  | [] -> false
                  | _ :: d -> all_within h most d))
  | None -> true

(** val inner_of : form -> form -> form -> Big_int_Z.big_int **)

let rec inner_of ms s t =
  match ms with
  | [] -> Big_int_Z.zero_big_int
  | m :: ms' ->
    (match s with
     | [] -> Big_int_Z.zero_big_int
     | x :: s' ->
       (match t with
        | [] -> Big_int_Z.zero_big_int
        | y :: t' -> Z.add (Z.mul (Z.mul m x) y) (inner_of ms' s' t')))

(** val slip_at : form list -> form -> form **)

let slip_at t d =
  map (fun f -> dot f d) (tl t)

(** val motion_of : ray -> form **)

let motion_of r =
  match r.coordinates with
  | [] -> []
  | _ :: l -> (match l with
               | [] -> []
               | _ :: d -> d)

(** val slips : form list multi -> ray list -> form list **)

let slips g rays0 =
  flat_map (fun t -> map (fun r -> slip_at t (motion_of r)) rays0) (tips g)

(** val less_along :
    Big_int_Z.big_int list -> form -> form -> form -> bool **)

let less_along ms w s t =
  Z.ltb
    (Z.mul (Z.mul (inner_of ms w s) (Z.abs (inner_of ms w s)))
      (inner_of ms t t))
    (Z.mul (Z.mul (inner_of ms w t) (Z.abs (inner_of ms w t)))
      (inner_of ms s s))

(** val nearest :
    Big_int_Z.big_int list -> form -> form list -> form option **)

let nearest ms w gens =
  fold_left (fun best s ->
    if all_zero s
    then best
    else (match best with
          | Some b -> if less_along ms w b s then Some s else best
          | None -> Some s)) gens None

type foot = { of_gens : form list; foot_m : Big_int_Z.big_int; foot_e : 
              form; foot_n : Big_int_Z.big_int; foot_d : Big_int_Z.big_int }

(** val foot_on : Big_int_Z.big_int list -> form -> form -> foot list **)

let foot_on ms w s =
  let a = inner_of ms w s in
  let ss = inner_of ms s s in
  if Z.ltb Big_int_Z.zero_big_int a
  then { of_gens = (s :: []); foot_m = ss; foot_e =
         (combine0 ss w (Z.opp a) s); foot_n = (Z.mul a a); foot_d =
         ss } :: []
  else []

(** val foot_between :
    Big_int_Z.big_int list -> form -> form -> form -> foot list **)

let foot_between ms w s t =
  let ws = inner_of ms w s in
  let wt = inner_of ms w t in
  let ss = inner_of ms s s in
  let tt = inner_of ms t t in
  let st = inner_of ms s t in
  let det0 = Z.sub (Z.mul ss tt) (Z.mul st st) in
  let cs = Z.sub (Z.mul ws tt) (Z.mul wt st) in
  let ct = Z.sub (Z.mul wt ss) (Z.mul ws st) in
  if (&&)
       ((&&) (Z.ltb Big_int_Z.zero_big_int det0)
         (Z.ltb Big_int_Z.zero_big_int cs)) (Z.ltb Big_int_Z.zero_big_int ct)
  then { of_gens = (s :: (t :: [])); foot_m = det0; foot_e =
         (combine0 Big_int_Z.unit_big_int (combine0 det0 w (Z.opp cs) s)
           (Z.opp ct) t); foot_n = (Z.add (Z.mul cs ws) (Z.mul ct wt));
         foot_d = det0 } :: []
  else []

(** val longer : foot -> foot -> foot **)

let longer best f =
  if Z.ltb (Z.mul best.foot_n f.foot_d) (Z.mul f.foot_n best.foot_d)
  then f
  else best

(** val foot_from :
    Big_int_Z.big_int list -> nat -> form -> form list -> foot -> foot option **)

let rec foot_from ms steps w gens f =
  match nearest ms f.foot_e gens with
  | Some g ->
    if Z.leb (inner_of ms f.foot_e g) Big_int_Z.zero_big_int
    then Some f
    else (match steps with
          | O -> None
          | S steps' ->
            let next0 =
              fold_left longer
                (app (foot_on ms w g)
                  (flat_map (fun s -> foot_between ms w s g) f.of_gens)) f
            in
            if Z.ltb (Z.mul f.foot_n next0.foot_d)
                 (Z.mul next0.foot_n f.foot_d)
            then foot_from ms steps' w gens next0
            else None)
  | None -> Some f

(** val foot_of :
    Big_int_Z.big_int list -> form -> form list -> foot option **)

let foot_of ms w gens =
  foot_from ms (length gens) w gens { of_gens = []; foot_m =
    Big_int_Z.unit_big_int; foot_e = w; foot_n = Big_int_Z.zero_big_int;
    foot_d = Big_int_Z.unit_big_int }

(** val nowhere_along :
    Big_int_Z.big_int list -> form list -> form -> bool **)

let nowhere_along ms gens e =
  forallb (fun s -> Z.leb (inner_of ms s e) Big_int_Z.zero_big_int) gens

(** val separator :
    Big_int_Z.big_int list -> form list -> form -> form option **)

let separator ms gens w =
  match foot_of ms w gens with
  | Some f ->
    let e = primitive f.foot_e in
    if (&&) (nowhere_along ms gens e)
         (Z.ltb Big_int_Z.zero_big_int (inner_of ms w e))
    then Some e
    else None
  | None -> None

(** val outside :
    Big_int_Z.big_int list -> form list -> form list -> form -> form list
    option **)

let outside ms gens separators s =
  let w = negative s in
  if existsb (fun e -> Z.ltb Big_int_Z.zero_big_int (inner_of ms w e))
       separators
  then Some separators
  else if all_zero s
       then None
       else (match separator ms gens w with
             | Some e -> Some (e :: separators)
             | None -> None)

(** val opposed_barred :
    Big_int_Z.big_int list -> form list -> form list -> bool list ->
    (form * ray) list -> bool **)

let rec opposed_barred ms gens separators marks rays0 =
  (&&) (existsb (fun z0 -> z0) marks)
    (match rays0 with
     | [] -> true
     | p :: rays' ->
       let (s, r) = p in
       (match outside ms gens separators s with
        | Some more -> opposed_barred ms gens more marks rays'
        | None -> opposed_barred ms gens separators (both r.zeros marks) rays'))

(** val must_move :
    Big_int_Z.big_int list -> form list list -> form list multi -> form list
    -> ray list -> bool **)

let must_move ms strict0 g gens rays0 =
  forallb (fun t ->
    opposed_barred ms gens [] (map (fun _ -> true) strict0)
      (map (fun r -> ((slip_at t (motion_of r)), r)) rays0)) (tips g)

(** val most_along :
    Big_int_Z.big_int list -> form list -> form ->
    (bool * Big_int_Z.big_int) * Big_int_Z.big_int **)

let most_along ms gens z0 =
  let w = negative z0 in
  let whole = ((false, (inner_of ms z0 z0)), Big_int_Z.unit_big_int) in
  (match nearest ms w gens with
   | Some s ->
     let a = inner_of ms w s in
     if Z.leb Big_int_Z.zero_big_int a
     then (match foot_of ms w gens with
           | Some f ->
             let k =
               combine0 f.foot_m w (Big_int_Z.minus_big_int
                 Big_int_Z.unit_big_int) f.foot_e
             in
             if (&&) (nowhere_along ms gens f.foot_e)
                  (Z.ltb Big_int_Z.zero_big_int f.foot_m)
             then ((false, (inner_of ms k k)), (Z.mul f.foot_m f.foot_m))
             else whole
           | None -> whole)
     else if (&&)
               (forallb (fun g ->
                 (&&) (Z.leb (inner_of ms w g) Big_int_Z.zero_big_int)
                   (Z.leb (Z.mul (Z.mul a a) (inner_of ms g g))
                     (Z.mul (Z.mul (inner_of ms w g) (inner_of ms w g))
                       (inner_of ms s s)))) gens)
               (Z.ltb Big_int_Z.zero_big_int (inner_of ms s s))
          then ((true, (Z.mul a a)), (inner_of ms s s))
          else whole
   | None -> whole)

(** val unit_of : scaling -> q **)

let unit_of s =
  { qnum = s.times; qden = (Z.to_pos s.over) }

(** val largest_q : q list -> q **)

let rec largest_q = function
| [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
| q0 :: qs' ->
  (match qs' with
   | [] -> q0
   | _ :: _ -> let m = largest_q qs' in if qle_bool q0 m then m else q0)

(** val friction_work :
    row -> q -> ((bool * Big_int_Z.big_int) * Big_int_Z.big_int) ->
    Big_int_Z.big_int -> q -> q **)

let friction_work row0 scale along zz mu =
  let (p, d) = along in
  let (below, n0) = p in
  let c = qmult (qmult mu mu) scale in
  let q0 = qmult c { qnum = n0; qden = (Z.to_pos d) } in
  let it =
    if (&&) below
         (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } mu)
    then qopp (root_below q0)
    else root_above q0
  in
  if qle_bool row0.slack { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int }
  then it
  else qplus it
         (qmult
           (qmult { qnum =
             ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
             Big_int_Z.unit_big_int); qden = (Big_int_Z.mult_int_big_int 2
             Big_int_Z.unit_big_int) } row0.slack)
           (root_above (qmult c (inject_Z zz))))

(** val corner_alpha :
    row -> q -> form -> form list -> bool -> form list -> q **)

let corner_alpha row0 factor0 y gens moves t =
  let z0 = slip_at t y in
  let zz = inner_of row0.metric z0 z0 in
  let along =
    if moves
    then most_along row0.metric gens z0
    else ((false, zz), Big_int_Z.unit_big_int)
  in
  let u = qmult (unit_of row0.forms_scale) factor0 in
  let scale =
    qmult (qmult row0.box.box_square (unit_of row0.metric_scale)) (qmult u u)
  in
  reduced
    (qplus (qmult u (inject_Z (dot (nth O t []) y)))
      (largest_q
        (map (friction_work row0 scale along zz) (ends row0.box.box_friction))))

(** val alpha :
    form list list -> ray list -> bool -> row -> q -> form -> q **)

let alpha strict0 rays0 slipping0 row0 factor0 y =
  let frictionless =
    qeq_bool row0.box.box_friction.high { qnum = Big_int_Z.zero_big_int;
      qden = Big_int_Z.unit_big_int }
  in
  let gens = if frictionless then [] else slips row0.forms rays0 in
  let moves =
    (&&) (negb frictionless)
      ((||) slipping0 (must_move row0.metric strict0 row0.forms gens rays0))
  in
  reduced
    (qdiv
      (largest_q
        (map (corner_alpha row0 factor0 y gens moves) (tips row0.forms)))
      factor0)

(** val alpha_term : Big_int_Z.big_int -> q -> bool -> row -> term **)

let alpha_term m a mixed0 row0 =
  let n0 = Z.mul (Z.mul m a.qnum) row0.pull_scale.times in
  let d = Z.mul a.qden row0.pull_scale.over in
  (match pull_tips row0 with
   | [] ->
     if (&&) mixed0 (Z.leb a.qnum Big_int_Z.zero_big_int)
     then Nothing
     else Bend ((Z.mul m row0.pull_scale.times), d,
            (map (map (Z.mul a.qnum)) []), mixed0)
   | v :: l ->
     (match l with
      | [] ->
        let c = up n0 d in
        if mixed0
        then if Z.leb c Big_int_Z.zero_big_int
             then Nothing
             else Bend (c, Big_int_Z.unit_big_int, (v :: []), true)
        else Line (c, v)
      | f :: l0 ->
        if (&&) mixed0 (Z.leb a.qnum Big_int_Z.zero_big_int)
        then Nothing
        else Bend ((Z.mul m row0.pull_scale.times), d,
               (map (map (Z.mul a.qnum)) (v :: (f :: l0))), mixed0)))

(** val alpha_over : q -> row -> Big_int_Z.big_int **)

let alpha_over a row0 =
  Z.mul a.qden row0.pull_scale.over

(** val ray_motion : form -> form **)

let ray_motion = function
| [] -> []
| _ :: l0 -> (match l0 with
              | [] -> []
              | _ :: d' -> d')

type vector = q list

type matrix = vector list

(** val inner : vector -> vector -> q **)

let rec inner a b =
  match a with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | x :: a' ->
    (match b with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | y :: b' -> reduced (qplus (qmult x y) (inner a' b')))

(** val plus_times : vector -> q -> vector -> vector **)

let rec plus_times a s b =
  match a with
  | [] ->
    (match b with
     | [] -> a
     | _ :: _ -> map (fun y -> reduced (qmult s y)) b)
  | x :: a' ->
    (match b with
     | [] -> a
     | y :: b' -> (reduced (qplus x (qmult s y))) :: (plus_times a' s b'))

(** val is_zero : q -> bool **)

let is_zero q0 =
  qeq_bool q0 { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

(** val unit_vector : nat -> nat -> vector **)

let unit_vector n0 i =
  map (fun j ->
    if Nat.eqb i j
    then { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
    else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
    (seq O n0)

(** val identity : nat -> matrix **)

let identity n0 =
  map (unit_vector n0) (seq O n0)

(** val of_rows : vector -> matrix -> vector **)

let rec of_rows a m =
  match a with
  | [] -> []
  | x :: a' ->
    (match m with
     | [] -> []
     | r :: m' -> plus_times (of_rows a' m') x r)

(** val pivot : nat -> matrix -> (vector * matrix) option **)

let rec pivot column0 = function
| [] -> None
| r :: m' ->
  if is_zero
       (nth column0 r { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int })
  then (match pivot column0 m' with
        | Some p -> let (found, others0) = p in Some (found, (r :: others0))
        | None -> None)
  else Some (r, m')

(** val eliminate :
    nat -> nat -> matrix -> (nat * vector) list -> (nat * vector) list **)

let rec eliminate columns0 column0 m done0 =
  match columns0 with
  | O -> done0
  | S columns' ->
    (match pivot column0 m with
     | Some p ->
       let (r, others0) = p in
       let r0 =
         plus_times []
           (qinv
             (nth column0 r { qnum = Big_int_Z.zero_big_int; qden =
               Big_int_Z.unit_big_int })) r
       in
       let without0 = fun a ->
         plus_times a
           (qopp
             (nth column0 a { qnum = Big_int_Z.zero_big_int; qden =
               Big_int_Z.unit_big_int })) r0
       in
       eliminate columns' (S column0) (map without0 others0)
         (app (map (fun p0 -> ((fst p0), (without0 (snd p0)))) done0)
           ((column0, r0) :: []))
     | None -> eliminate columns' (S column0) m done0)

(** val kernel : nat -> matrix -> matrix **)

let kernel n0 m =
  let done0 = eliminate n0 O m [] in
  flat_map (fun j ->
    if existsb (fun p -> Nat.eqb (fst p) j) done0
    then []
    else (fold_right (fun p a ->
           plus_times a
             (qopp
               (nth j (snd p) { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int })) (unit_vector n0 (fst p)))
           (unit_vector n0 j) done0) :: []) (seq O n0)

(** val inverse_of : nat -> matrix -> matrix **)

let inverse_of n0 m =
  map (fun p -> skipn n0 (snd p))
    (eliminate n0 O
      (map (fun p -> app (fst p) (snd p)) (combine m (identity n0))) [])

(** val same_vectors : vector -> vector -> bool **)

let rec same_vectors a b =
  match a with
  | [] -> (match b with
           | [] -> true
           | _ :: _ -> false)
  | x :: a' ->
    (match b with
     | [] -> false
     | y :: b' -> (&&) (qeq_bool x y) (same_vectors a' b'))

(** val same_matrices : matrix -> matrix -> bool **)

let rec same_matrices a b =
  match a with
  | [] -> (match b with
           | [] -> true
           | _ :: _ -> false)
  | x :: a' ->
    (match b with
     | [] -> false
     | y :: b' -> (&&) (same_vectors x y) (same_matrices a' b'))

(** val is_inverse : nat -> matrix -> matrix -> bool **)

let is_inverse n0 left m =
  same_matrices (map (fun a -> of_rows a m) left) (identity n0)

(** val all_of_length : nat -> 'a1 list list -> bool **)

let all_of_length n0 m =
  forallb (fun r -> Nat.eqb (length r) n0) m

(** val middle : interval -> q **)

let middle i =
  qmult (qplus i.low i.high) { qnum = Big_int_Z.unit_big_int; qden =
    (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) }

(** val only_middle : interval -> interval **)

let only_middle i =
  exactly (middle i)

(** val middle_box : cbox -> cbox **)

let middle_box b =
  { box_names = b.box_names; box_geometry = (map only_middle b.box_geometry);
    box_forms = b.box_forms; box_friction = (only_middle b.box_friction);
    box_preload = (only_middle b.box_preload); box_growth =
    (only_middle b.box_growth); box_stiffness =
    (only_middle b.box_stiffness); box_square = b.box_square; box_normal =
    b.box_normal; box_weights = b.box_weights; box_signed = b.box_signed;
    box_spring = b.box_spring; box_turns = b.box_turns; box_slack =
    b.box_slack }

(** val friction_sound : cbox -> bool **)

let friction_sound b =
  (&&)
    (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int } b.box_friction.low)
    ((||) (negb b.box_spring)
      (qle_bool b.box_friction.high { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }))

type addition = { ball_numbers : interval list; ball_ways : matrix;
                  ball_squares : q list }

(** val nothing_added : addition **)

let nothing_added =
  { ball_numbers = []; ball_ways = []; ball_squares = [] }

type load = { load_box : interval list; load_growth : q list;
              load_added : addition }

(** val work_of_box : interval list -> vector -> interval **)

let rec work_of_box box0 y =
  match box0 with
  | [] ->
    exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | i :: box' ->
    (match y with
     | [] ->
       exactly { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int }
     | q0 :: y' ->
       let { low = least; high = most } = work_of_box box' y' in
       if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } q0
       then let a = i.low in
            let b = i.high in
            { low = (reduced (qplus (qmult q0 a) least)); high =
            (reduced (qplus (qmult q0 b) most)) }
       else let a = i.high in
            let b = i.low in
            { low = (reduced (qplus (qmult q0 a) least)); high =
            (reduced (qplus (qmult q0 b) most)) })

(** val sum_of_squares : vector -> vector -> q **)

let rec sum_of_squares weights a =
  match weights with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | w :: ws ->
    (match a with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | x :: a' -> reduced (qplus (qmult w (qmult x x)) (sum_of_squares ws a')))

(** val work_of_addition : addition -> vector -> interval **)

let work_of_addition it y =
  match it.ball_ways with
  | [] ->
    exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | _ :: _ ->
    let along = map (fun b -> inner b y) it.ball_ways in
    let in_box = work_of_box it.ball_numbers along in
    let root0 = root_above (sum_of_squares it.ball_squares along) in
    { low = (qmax in_box.low (qopp root0)); high = (qmin in_box.high root0) }

(** val work_of : load -> vector -> interval **)

let work_of ld y =
  let a = work_of_box ld.load_box y in
  let b = work_of_addition ld.load_added y in
  { low = (reduced (qplus a.low b.low)); high =
  (reduced (qplus a.high b.high)) }

(** val one_load : load -> bool **)

let one_load ld =
  (&&) (forallb certain ld.load_box)
    (match ld.load_added.ball_numbers with
     | [] -> true
     | _ :: _ -> false)

(** val nearest_to_zero : interval -> q **)

let nearest_to_zero i =
  if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int } i.low
  then i.low
  else if qle_bool i.high { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int }
       then i.high
       else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

(** val middle_load : load -> load **)

let middle_load ld =
  let a = ld.load_added in
  { load_box = (map only_middle ld.load_box); load_growth = ld.load_growth;
  load_added = { ball_numbers =
  (map (fun i -> exactly (nearest_to_zero i)) a.ball_numbers); ball_ways =
  a.ball_ways; ball_squares = a.ball_squares } }

(** val edges : form list list -> ray list -> row -> form multi list **)

let edges strict0 rays0 row0 =
  match row0.edges_none with
  | [] ->
    if has_sign strict0 rays0 row0.tau
    then row0.edges_plus
    else if has_sign strict0 rays0 row0.minus_tau
         then row0.edges_minus
         else row0.edges_none
  | _ :: l ->
    (match l with
     | [] -> row0.edges_none
     | _ :: _ ->
       if has_sign strict0 rays0 row0.tau
       then row0.edges_plus
       else if has_sign strict0 rays0 row0.minus_tau
            then row0.edges_minus
            else row0.edges_none)

(** val work_tree : form -> form multi -> Big_int_Z.big_int multi **)

let work_tree y edge0 =
  mmap (fun f -> dot f y) edge0

(** val products_with : row -> Big_int_Z.big_int multi -> form list **)

let products_with row0 a =
  flat_map (fun p -> bernstein row0.parameters ((a, p) :: [])) row0.pulls

(** val mixed_forms : row -> Big_int_Z.big_int multi -> form list **)

let mixed_forms row0 a =
  if forallb (fun z0 -> Z.leb z0 Big_int_Z.zero_big_int) (tips a)
  then []
  else if forallb (fun z0 -> Z.leb Big_int_Z.zero_big_int z0) (tips a)
       then products_with row0 a
       else map
              (map (Z.mul (Z.mul (power row0.parameters) (largest (tips a)))))
              (pull_tips row0)

(** val bent : Big_int_Z.big_int -> row -> form list -> bool -> term **)

let bent m row0 forms0 mixed0 =
  match forms0 with
  | [] -> Nothing
  | _ :: _ -> Bend ((Z.mul m row0.weight), row0.over_weight, forms0, mixed0)

(** val edges_term :
    Big_int_Z.big_int -> form -> form multi list -> bool -> row -> term **)

let edges_term m y es mixed0 row0 =
  match row0.parameters with
  | O ->
    (match row0.pulls with
     | [] ->
       bent m row0
         (flat_map (fun e ->
           if mixed0
           then mixed_forms row0 (work_tree y e)
           else products_with row0 (work_tree y e)) es) mixed0
     | p :: l ->
       (match l with
        | [] ->
          if row0.box.box_spring
          then bent m row0
                 (flat_map (fun e ->
                   if mixed0
                   then mixed_forms row0 (work_tree y e)
                   else products_with row0 (work_tree y e)) es) mixed0
          else let c =
                 largest
                   (map (fun e ->
                     up (Z.mul (Z.mul m row0.weight) (dot (first_tip e) y))
                       row0.over_weight) es)
               in
               let v = first_tip p in
               if mixed0
               then if Z.leb c Big_int_Z.zero_big_int
                    then Nothing
                    else Bend (c, Big_int_Z.unit_big_int, (v :: []), true)
               else Line (c, v)
        | _ :: _ ->
          bent m row0
            (flat_map (fun e ->
              if mixed0
              then mixed_forms row0 (work_tree y e)
              else products_with row0 (work_tree y e)) es) mixed0))
  | S _ ->
    bent m row0
      (flat_map (fun e ->
        if mixed0
        then mixed_forms row0 (work_tree y e)
        else products_with row0 (work_tree y e)) es) mixed0

(** val load_works : load -> q -> form -> q * q **)

let load_works ld factor0 y =
  let y0 = map (fun c -> qmult factor0 (inject_Z c)) y in
  ((reduced (qdiv (work_of ld y0).high factor0)),
  (reduced (qdiv (inner ld.load_growth y0) factor0)))

(** val load_term : Big_int_Z.big_int -> (q * q) -> form **)

let load_term m = function
| (a, b) ->
  (up (Z.mul m a.qnum) a.qden) :: ((up (Z.mul m b.qnum) b.qden) :: [])

type way =
| Along of form multi list
| Most of q

type presser = { pressing : row; by_ : way; mixed : bool }

(** val way_of :
    form list list -> ray list -> bool -> q -> form -> row -> way **)

let way_of strict0 rays0 slipping0 factor0 y row0 =
  if row0.box.box_signed
  then Along (edges strict0 rays0 row0)
  else Most (alpha strict0 rays0 slipping0 row0 factor0 y)

(** val pressers :
    form list list -> ray list -> Big_int_Z.big_int list -> q -> form -> row
    list -> Big_int_Z.big_int -> presser list -> presser list **)

let rec pressers strict0 rays0 slipping0 factor0 y rows0 number before =
  match rows0 with
  | [] -> before
  | row0 :: rows' ->
    let vs = pull_tips row0 in
    let it = fun mixed0 -> { pressing = row0; by_ =
      (way_of strict0 rays0 (existsb (Z.eqb number) slipping0) factor0 y row0);
      mixed = mixed0 }
    in
    let now =
      if (||) row0.box.box_spring (forallb (nowhere_negative rays0) vs)
      then (it false) :: before
      else if forallb (nowhere_positive rays0) vs
           then before
           else (it true) :: before
    in
    pressers strict0 rays0 slipping0 factor0 y rows'
      (Z.add number Big_int_Z.unit_big_int) now

(** val term_of : Big_int_Z.big_int -> form -> presser -> term **)

let term_of m y p =
  match p.by_ with
  | Along es -> edges_term m y es p.mixed p.pressing
  | Most a -> alpha_term m a p.mixed p.pressing

(** val with_all :
    Big_int_Z.big_int -> (q * q) -> q list -> presser list ->
    Big_int_Z.big_int **)

let with_all m works more them =
  let m0 = fold_left (fun m0 q0 -> Z.lcm m0 q0.qden) more m in
  fold_left (fun m1 p ->
    match p.by_ with
    | Along _ -> m1
    | Most a -> Z.lcm m1 (alpha_over a p.pressing)) them
    (Z.lcm (Z.lcm m0 (fst works).qden) (snd works).qden)

(** val leaf_holds_by :
    Big_int_Z.big_int -> presser list -> (q * q) -> q list -> form list list
    -> ray list -> form -> bool **)

let leaf_holds_by m them works more strict0 rays0 y =
  (&&)
    ((&&) (Z.ltb Big_int_Z.zero_big_int m)
      (forallb (fun q0 ->
        Z.eqb (Z.modulo (Z.mul m q0.qnum) q0.qden) Big_int_Z.zero_big_int)
        more))
    (let form0 =
       combine0 Big_int_Z.unit_big_int (load_term m works)
         Big_int_Z.unit_big_int
         (map (fun q0 -> Z.div (Z.mul m q0.qnum) q0.qden) more)
     in
     let (linear, bends) = collect (term_of m y) them form0 [] in
     positive_at_home strict0 rays0 (fun x ->
       Z.opp (fold_left (fun s t -> Z.add s (value t x)) bends (dot linear x))))

(** val is_enclosure : interval -> q -> bool **)

let is_enclosure i square =
  (&&)
    ((&&)
      ((&&)
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } i.low)
        (qle_bool (qmult (qmult i.low i.low) square) { qnum =
          Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }))
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } i.high))
    (qle_bool { qnum = Big_int_Z.unit_big_int; qden =
      Big_int_Z.unit_big_int } (qmult (qmult i.high i.high) square))

(** val inverse_length : Big_int_Z.big_int -> bool -> q -> interval option **)

let inverse_length bits0 loaded square =
  let i =
    if loaded
    then root_between bits0 (reduced (qinv square))
    else exactly { qnum = Big_int_Z.unit_big_int; qden =
           Big_int_Z.unit_big_int }
  in
  if (||) (negb loaded) (is_enclosure i square) then Some i else None

(** val is_loaded : contact -> bool **)

let is_loaded q0 =
  (||)
    (negb
      (qeq_bool q0.preload.high { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }))
    (negb
      (qeq_bool q0.preload_growth { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }))

(** val plane_forms : q -> q -> q list -> q list list **)

let plane_forms nx ny = function
| [] -> []
| x :: l ->
  (match l with
   | [] -> []
   | y :: l0 ->
     (match l0 with
      | [] -> []
      | e :: l1 ->
        (match l1 with
         | [] ->
           let fx = qminus nx (qmult e ny) in
           let fy = qplus ny (qmult e nx) in
           (fx :: (fy :: ((qminus (qmult x fy) (qmult y fx)) :: []))) :: ((
           (qopp fy) :: (fx :: ((qplus (qmult x fx) (qmult y fy)) :: []))) :: [])
         | _ :: _ -> [])))

(** val at_point : q -> q -> q -> q -> q -> q -> q list **)

let at_point x y z0 fx fy fz =
  fx :: (fy :: (fz :: ((qminus (qmult y fz) (qmult z0 fy)) :: ((qminus
                                                                 (qmult z0 fx)
                                                                 (qmult x fz)) :: (
    (qminus (qmult x fy) (qmult y fx)) :: [])))))

(** val first_turn : q -> q -> q -> (q * q) * q **)

let first_turn nx ny nz =
  let x2 = qmult nx nx in
  let y2 = qmult ny ny in
  let z2 = qmult nz nz in
  if (&&) (qle_bool x2 y2) (qle_bool x2 z2)
  then (({ qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int },
         nz), (qopp ny))
  else if qle_bool y2 z2
       then (((qopp nz), { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int }), nx)
       else ((ny, (qopp nx)), { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int })

(** val cross_q : ((q * q) * q) -> ((q * q) * q) -> (q * q) * q **)

let cross_q a b =
  let (p, a3) = a in
  let (a1, a2) = p in
  let (p0, b3) = b in
  let (b1, b2) = p0 in
  (((qminus (qmult a2 b3) (qmult a3 b2)),
  (qminus (qmult a3 b1) (qmult a1 b3))), (qminus (qmult a1 b2) (qmult a2 b1)))

(** val square_of : ((q * q) * q) -> q **)

let square_of = function
| (p, a3) ->
  let (a1, a2) = p in qplus (qplus (qmult a1 a1) (qmult a2 a2)) (qmult a3 a3)

(** val space_forms :
    ((q * q) * q) -> ((q * q) * q) -> ((q * q) * q) -> q -> q list -> q list
    list **)

let space_forms n0 turn_u turn_v square = function
| [] -> []
| x :: l ->
  (match l with
   | [] -> []
   | y :: l0 ->
     (match l0 with
      | [] -> []
      | z0 :: l1 ->
        (match l1 with
         | [] -> []
         | e :: l2 ->
           (match l2 with
            | [] -> []
            | f :: l3 ->
              (match l3 with
               | [] ->
                 let (p, nz) = n0 in
                 let (nx, ny) = p in
                 let (p0, uz) = turn_u in
                 let (ux, uy) = p0 in
                 let (p1, vz) = turn_v in
                 let (vx, vy) = p1 in
                 let tx = qplus (qplus nx (qmult e ux)) (qmult f vx) in
                 let ty = qplus (qplus ny (qmult e uy)) (qmult f vy) in
                 let tz = qplus (qplus nz (qmult e uz)) (qmult f vz) in
                 let across0 = fun nj ex ey ez ->
                   at_point x y z0 (qminus ex (qdiv (qmult nj nx) square))
                     (qminus ey (qdiv (qmult nj ny) square))
                     (qminus ez (qdiv (qmult nj nz) square))
                 in
                 (at_point x y z0 tx ty tz) :: ((across0 tx { qnum =
                                                  Big_int_Z.unit_big_int;
                                                  qden =
                                                  Big_int_Z.unit_big_int }
                                                  { qnum =
                                                  Big_int_Z.zero_big_int;
                                                  qden =
                                                  Big_int_Z.unit_big_int }
                                                  { qnum =
                                                  Big_int_Z.zero_big_int;
                                                  qden =
                                                  Big_int_Z.unit_big_int }) :: (
                 (across0 ty { qnum = Big_int_Z.zero_big_int; qden =
                   Big_int_Z.unit_big_int } { qnum = Big_int_Z.unit_big_int;
                   qden = Big_int_Z.unit_big_int } { qnum =
                   Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }) :: (
                 (across0 tz { qnum = Big_int_Z.zero_big_int; qden =
                   Big_int_Z.unit_big_int } { qnum = Big_int_Z.zero_big_int;
                   qden = Big_int_Z.unit_big_int } { qnum =
                   Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }) :: [])))
               | _ :: _ -> [])))))

(** val greatest_square : interval -> q **)

let greatest_square i =
  let a = qmult i.low i.low in
  let b = qmult i.high i.high in if qle_bool a b then b else a

(** val turned_slack : q -> q -> interval list -> q **)

let turned_slack u_square square = function
| [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
| _ :: l ->
  (match l with
   | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
   | _ :: l0 ->
     (match l0 with
      | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
      | _ :: l1 ->
        (match l1 with
         | [] ->
           { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
         | e :: l2 ->
           (match l2 with
            | [] ->
              { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
            | f :: l3 ->
              (match l3 with
               | [] ->
                 qdiv
                   (qmult u_square
                     (qplus (greatest_square e)
                       (qmult square (greatest_square f)))) square
               | _ :: _ ->
                 { qnum = Big_int_Z.zero_big_int; qden =
                   Big_int_Z.unit_big_int })))))

(** val turn_within : q -> interval **)

let turn_within q0 =
  let b = root_above q0 in { low = (qopp b); high = b }

(** val is_nonnegative : contact -> bool **)

let is_nonnegative q0 =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } q0.friction.low)
          (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } q0.preload.low))
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } q0.stiffness.low))
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } q0.slope))
    (qle_bool q0.slope { qnum = Big_int_Z.unit_big_int; qden =
      Big_int_Z.unit_big_int })

(** val numbers :
    Big_int_Z.big_int -> contact -> q -> ((interval * interval) * interval)
    option **)

let numbers bits0 q0 square =
  match inverse_length bits0 (is_loaded q0) square with
  | Some l ->
    let grows =
      negb
        (qeq_bool q0.preload_growth { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int })
    in
    let e2 = qmult q0.slope q0.slope in
    if (&&)
         ((&&)
           (negb
             (qle_bool square { qnum = Big_int_Z.zero_big_int; qden =
               Big_int_Z.unit_big_int })) (is_nonnegative q0))
         ((||) (negb grows)
           ((&&) (certain q0.preload)
             (qeq_bool q0.slope { qnum = Big_int_Z.zero_big_int; qden =
               Big_int_Z.unit_big_int })))
    then Some (({ low =
           (qmult
             (qmult q0.preload.low
               (qminus { qnum = Big_int_Z.unit_big_int; qden =
                 Big_int_Z.unit_big_int }
                 (qdiv e2 { qnum = (Big_int_Z.mult_int_big_int 2
                   Big_int_Z.unit_big_int); qden = Big_int_Z.unit_big_int })))
             l.low); high = (qmult q0.preload.high l.high) },
           (if grows
            then { low = (qmult q0.preload_growth l.low); high =
                   (qmult q0.preload_growth l.high) }
            else exactly { qnum = Big_int_Z.zero_big_int; qden =
                   Big_int_Z.unit_big_int })), { low =
           (qdiv
             (qmult q0.stiffness.low
               (qminus { qnum = Big_int_Z.unit_big_int; qden =
                 Big_int_Z.unit_big_int } e2)) square); high =
           (qdiv q0.stiffness.high square) })
    else None
  | None -> None

(** val enlarge : Big_int_Z.big_int -> contact -> cbox option **)

let enlarge bits0 q0 =
  match q0.position with
  | [] -> None
  | x :: l ->
    (match l with
     | [] -> None
     | y :: l0 ->
       (match l0 with
        | [] ->
          (match q0.normal with
           | [] -> None
           | nx :: l1 ->
             (match l1 with
              | [] -> None
              | ny :: l2 ->
                (match l2 with
                 | [] ->
                   (match numbers bits0 q0 (qplus (qmult nx nx) (qmult ny ny)) with
                    | Some p0 ->
                      let (p1, k) = p0 in
                      let (p, u) = p1 in
                      Some { box_names = (PX :: (PY :: (PTurn :: [])));
                      box_geometry = (x :: (y :: ({ low = (qopp q0.slope);
                      high = q0.slope } :: []))); box_forms =
                      (plane_forms nx ny); box_friction = q0.friction;
                      box_preload = p; box_growth = u; box_stiffness = k;
                      box_square = { qnum = Big_int_Z.unit_big_int; qden =
                      Big_int_Z.unit_big_int }; box_normal =
                      (nx :: (ny :: [])); box_weights = ({ qnum =
                      Big_int_Z.unit_big_int; qden =
                      Big_int_Z.unit_big_int } :: []); box_signed = true;
                      box_spring = false; box_turns = false; box_slack =
                      (fun _ -> { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }) }
                    | None -> None)
                 | _ :: _ -> None)))
        | z0 :: l1 ->
          (match l1 with
           | [] ->
             (match q0.normal with
              | [] -> None
              | nx :: l2 ->
                (match l2 with
                 | [] -> None
                 | ny :: l3 ->
                   (match l3 with
                    | [] -> None
                    | nz :: l4 ->
                      (match l4 with
                       | [] ->
                         let n0 = ((nx, ny), nz) in
                         let square = square_of n0 in
                         let turn_u = first_turn nx ny nz in
                         let turn_v = cross_q n0 turn_u in
                         let u_square = square_of turn_u in
                         let e2 = qmult q0.slope q0.slope in
                         let turns =
                           negb
                             (qeq_bool q0.slope { qnum =
                               Big_int_Z.zero_big_int; qden =
                               Big_int_Z.unit_big_int })
                         in
                         (match numbers bits0 q0 square with
                          | Some p0 ->
                            let (p1, k) = p0 in
                            let (p, u) = p1 in
                            if (&&) turns
                                 (qle_bool u_square { qnum =
                                   Big_int_Z.zero_big_int; qden =
                                   Big_int_Z.unit_big_int })
                            then None
                            else Some { box_names =
                                   (PX :: (PY :: (PZ :: (PTurn :: (PTurnV :: [])))));
                                   box_geometry =
                                   (x :: (y :: (z0 :: ((if turns
                                                        then turn_within
                                                               (qdiv
                                                                 (qmult e2
                                                                   square)
                                                                 u_square)
                                                        else exactly { qnum =
                                                               Big_int_Z.zero_big_int;
                                                               qden =
                                                               Big_int_Z.unit_big_int }) :: ((
                                   if turns
                                   then turn_within (qdiv e2 u_square)
                                   else exactly { qnum =
                                          Big_int_Z.zero_big_int; qden =
                                          Big_int_Z.unit_big_int }) :: [])))));
                                   box_forms =
                                   (space_forms n0 turn_u turn_v square);
                                   box_friction = q0.friction; box_preload =
                                   p; box_growth = u; box_stiffness = k;
                                   box_square = square; box_normal =
                                   (nx :: (ny :: (nz :: []))); box_weights =
                                   ({ qnum = Big_int_Z.unit_big_int; qden =
                                   Big_int_Z.unit_big_int } :: ({ qnum =
                                   Big_int_Z.unit_big_int; qden =
                                   Big_int_Z.unit_big_int } :: ({ qnum =
                                   Big_int_Z.unit_big_int; qden =
                                   Big_int_Z.unit_big_int } :: [])));
                                   box_signed = false; box_spring = false;
                                   box_turns = turns; box_slack =
                                   (if turns
                                    then turned_slack u_square square
                                    else (fun _ -> { qnum =
                                           Big_int_Z.zero_big_int; qden =
                                           Big_int_Z.unit_big_int })) }
                          | None -> None)
                       | _ :: _ -> None))))
           | _ :: _ -> None)))

(** val with_turn : q list list -> q list list **)

let with_turn fs =
  app fs (({ qnum = Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int } :: (firstn (S (S (S O))) (n_of fs))))) :: [])

(** val soften : q -> cbox -> cbox **)

let soften e b =
  { box_names = b.box_names; box_geometry = b.box_geometry; box_forms =
    (fun geometry -> with_turn (b.box_forms geometry)); box_friction =
    b.box_friction; box_preload = b.box_preload; box_growth = b.box_growth;
    box_stiffness = b.box_stiffness; box_square = b.box_square; box_normal =
    b.box_normal; box_weights =
    (app b.box_weights ((qdiv (qmult e e) b.box_square) :: [])); box_signed =
    b.box_signed; box_spring = b.box_spring; box_turns = b.box_turns;
    box_slack = b.box_slack }

(** val enlarge_finger : Big_int_Z.big_int -> contact -> cbox option **)

let enlarge_finger bits0 c =
  match enlarge bits0 c with
  | Some b ->
    if qeq_bool c.torsion { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int }
    then Some b
    else if (||) b.box_signed b.box_turns
         then None
         else Some (soften c.torsion b)
  | None -> None

(** val dot_q : q list -> q list -> q **)

let rec dot_q a b =
  match a with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | x :: a' ->
    (match b with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | y :: b' -> qplus (qmult x y) (dot_q a' b'))

(** val lift_q : q list list -> q list -> q list **)

let lift_q g f =
  map (fun g0 -> reduced (dot_q f g0)) g

(** val lift_forms_q : q list list -> q list list -> q list list **)

let lift_forms_q g fs =
  (lift_q g (hd [] fs)) :: (map (lift_q g) (tl fs))

(** val lift_box : q list list -> cbox -> cbox **)

let lift_box g b =
  { box_names = b.box_names; box_geometry = b.box_geometry; box_forms =
    (fun geometry -> lift_forms_q g (b.box_forms geometry)); box_friction =
    b.box_friction; box_preload = b.box_preload; box_growth = b.box_growth;
    box_stiffness = b.box_stiffness; box_square = b.box_square; box_normal =
    b.box_normal; box_weights = b.box_weights; box_signed = b.box_signed;
    box_spring = b.box_spring; box_turns = b.box_turns; box_slack =
    b.box_slack }

(** val of_number_q : q list list -> nat option -> q list **)

let of_number_q motions = function
| Some number -> nth number motions []
| None -> []

(** val motion_of_body_q :
    nat -> q list -> q list list -> rigid_body -> q list **)

let motion_of_body_q n0 d before = function
| Free first -> firstn n0 (skipn first d)
| Link (on, eta, turns) ->
  add_multiple (of_number_q before on) (dot_q turns d) eta

(** val motions_q :
    nat -> q list -> rigid_body list -> q list list -> q list list **)

let rec motions_q n0 d bodies0 before =
  match bodies0 with
  | [] -> before
  | b :: rest ->
    motions_q n0 d rest
      (app before ((map reduced (motion_of_body_q n0 d before b)) :: []))

(** val numbers_of : mechanism -> nat **)

let numbers_of its =
  if its.bodies_in_space then S (S (S (S (S (S O))))) else S (S (S O))

(** val unit_q : nat -> q list **)

let unit_q k =
  app
    (repeat { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
      k) ({ qnum = Big_int_Z.unit_big_int; qden =
    Big_int_Z.unit_big_int } :: [])

(** val unit_motions : nat -> mechanism -> q list list list **)

let unit_motions d its =
  map (fun k -> motions_q (numbers_of its) (unit_q k) its.bodies []) (seq O d)

(** val columns : q list list list -> contact -> q list list **)

let columns units c =
  map (fun ms ->
    add_multiple (of_number_q ms c.of_body) { qnum = (Big_int_Z.minus_big_int
      Big_int_Z.unit_big_int); qden = Big_int_Z.unit_big_int }
      (of_number_q ms c.by_body)) units

(** val element_box : element -> cbox **)

let element_box e =
  { box_names = []; box_geometry = []; box_forms = (fun _ -> e.lever :: []);
    box_friction =
    (exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int });
    box_preload = e.element_preload; box_growth = (exactly e.element_growth);
    box_stiffness = e.element_stiffness; box_square = { qnum =
    Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }; box_normal = [];
    box_weights = []; box_signed = true; box_spring = e.element_spring;
    box_turns = false; box_slack = (fun _ -> { qnum = Big_int_Z.zero_big_int;
    qden = Big_int_Z.unit_big_int }) }

(** val mechanism_boxes :
    Big_int_Z.big_int -> nat -> mechanism -> contact list -> cbox list option **)

let mechanism_boxes bits0 d its contacts0 =
  let units = unit_motions d its in
  (match all_some (fun c ->
           match enlarge_finger bits0 c with
           | Some b -> Some (lift_box (columns units c) b)
           | None -> None) contacts0 with
   | Some boxes -> Some (app boxes (map element_box its.elements))
   | None -> None)

(** val h_of : form -> Big_int_Z.big_int **)

let h_of q0 =
  nth O q0 Big_int_Z.zero_big_int

(** val twist_at : Big_int_Z.big_int -> form -> form -> form **)

let twist_at c y q0 =
  combine0 c (ray_motion q0) (h_of q0) y

type measure =
| Exactly of q * q * q * q
| Shortly of Big_int_Z.big_int * Big_int_Z.big_int * Big_int_Z.big_int

(** val exact_measure : row -> q -> measure **)

let exact_measure row0 u =
  let unit1 = unit_of row0.metric_scale in
  let scale = reduced (qmult (qmult row0.box.box_square unit1) (qmult u u)) in
  Exactly (u, scale, (reduced (qmult scale unit1)),
  (reduced
    (qplus { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
      (qmult { qnum = Big_int_Z.unit_big_int; qden =
        (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) } row0.slack))))

(** val shifted : Big_int_Z.big_int -> q -> Big_int_Z.big_int **)

let shifted bits0 q0 =
  up (Z.shiftl q0.qnum bits0) q0.qden

(** val short_measure : row -> measure **)

let short_measure row0 =
  let unit1 = unit_of row0.metric_scale in
  let scale = reduced (qmult row0.box.box_square unit1) in
  let aside = reduced (qmult scale unit1) in
  let part0 = { qnum = Big_int_Z.unit_big_int; qden =
    (Z.to_pos
      (Z.shiftl Big_int_Z.unit_big_int (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2
        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        Big_int_Z.unit_big_int))))))) }
  in
  Shortly
  ((shifted (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
     (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
     (Big_int_Z.mult_int_big_int 2
     ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
     Big_int_Z.unit_big_int))))))
     (qmult
       (qplus { qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } part0) (root_above aside))),
  (Z.opp
    (shifted (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
      (Big_int_Z.mult_int_big_int 2
      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
      Big_int_Z.unit_big_int))))))
      (qopp
        (qmult
          (qminus { qnum = Big_int_Z.unit_big_int; qden =
            Big_int_Z.unit_big_int } part0) (root_below aside))))),
  (shifted (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))
    (qmult
      (qmult
        (qplus { qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int } part0)
        (qplus { qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int }
          (qmult { qnum = Big_int_Z.unit_big_int; qden =
            (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int) }
            row0.slack))) (root_above scale))))

(** val friction_within :
    measure -> Big_int_Z.big_int -> Big_int_Z.big_int -> q **)

let friction_within m p square =
  match m with
  | Exactly (u, scale, aside, stretch) ->
    let along = qmult aside (inject_Z (Z.mul p p)) in
    qdiv
      (qplus
        (if Z.ltb p Big_int_Z.zero_big_int
         then qopp (root_below along)
         else root_above along)
        (qmult stretch (root_above (qmult scale (inject_Z square))))) u
  | Shortly (most, least, length0) ->
    { qnum =
      (Z.add
        (Z.mul p (if Z.ltb p Big_int_Z.zero_big_int then least else most))
        (Z.mul length0
          (Z.add
            (Z.sqrt
              (Z.shiftl square (Big_int_Z.mult_int_big_int 2
                (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
                (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
                (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))))))))
            Big_int_Z.unit_big_int))); qden =
      (Z.to_pos
        (Z.shiftl Big_int_Z.unit_big_int (Big_int_Z.mult_int_big_int 2
          (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
          (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
          ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          Big_int_Z.unit_big_int)))))))) }

type carrier = { carried : row; forms_scaled : scaling;
                 at_corners : form list list; measured : measure;
                 kappa : Big_int_Z.big_int; psi : form; may_open : bool }

(** val carrier_of :
    bool -> q -> row -> Big_int_Z.big_int -> form -> bool -> carrier **)

let carrier_of exact0 factor0 row0 kappa0 psi0 may_open0 =
  if row0.box.box_signed
  then let s = forms_scaling row0.box in
       let them = corner_forms row0.box in
       { carried = row0; forms_scaled = s; at_corners = (tips them);
       measured =
       (if exact0
        then exact_measure row0 (reduced (qmult (unit_of s) factor0))
        else short_measure row0); kappa = kappa0; psi = psi0; may_open =
       may_open0 }
  else let s = row0.forms_scale in
       let them = row0.forms in
       { carried = row0; forms_scaled = s; at_corners = (tips them);
       measured =
       (if exact0
        then exact_measure row0 (reduced (qmult (unit_of s) factor0))
        else short_measure row0); kappa = kappa0; psi = psi0; may_open =
       may_open0 }

(** val psi_within : row -> Big_int_Z.big_int -> form -> bool **)

let psi_within row0 kappa0 psi0 =
  (&&) (Z.leb Big_int_Z.zero_big_int kappa0)
    (Z.leb (Z.mul row0.metric_scale.times (inner_of row0.metric psi0 psi0))
      (Z.mul row0.metric_scale.over (Z.mul kappa0 kappa0)))

(** val stated :
    row -> Big_int_Z.big_int ->
    (Big_int_Z.big_int * (Big_int_Z.big_int * form)) list ->
    ((Big_int_Z.big_int * form) * (Big_int_Z.big_int * (Big_int_Z.big_int * form))
    list) * bool **)

let stated row0 number them = match them with
| [] -> (((Big_int_Z.zero_big_int, []), []), true)
| p :: them' ->
  let (i, p0) = p in
  let (kappa0, psi0) = p0 in
  if Z.eqb i number
  then (((kappa0, psi0), them'),
         ((&&) (has_friction row0.box) (psi_within row0 kappa0 psi0)))
  else (((Big_int_Z.zero_big_int, []), them), true)

(** val carriers :
    bool -> q -> ray list -> (Big_int_Z.big_int * (Big_int_Z.big_int * form))
    list -> row list -> Big_int_Z.big_int -> carrier list -> carrier list
    option **)

let rec carriers exact0 factor0 rays0 them rows0 number before =
  match rows0 with
  | [] -> (match them with
           | [] -> Some before
           | _ :: _ -> None)
  | row0 :: rows' ->
    let (p, good) = stated row0 number them in
    let (p0, others0) = p in
    let (kappa0, psi0) = p0 in
    if (&&) good ((||) (negb row0.box.box_spring) (Nat.eqb row0.parameters O))
    then let vs = pull_tips row0 in
         let it = carrier_of exact0 factor0 row0 kappa0 psi0 in
         carriers exact0 factor0 rays0 others0 rows'
           (Z.add number Big_int_Z.unit_big_int)
           (if (||) row0.box.box_spring (forallb (nowhere_negative rays0) vs)
            then (it false) :: before
            else if forallb (nowhere_positive rays0) vs
                 then before
                 else (it true) :: before)
    else None

(** val corner_work : carrier -> form -> form -> form list -> q **)

let corner_work it yq d t =
  let row0 = it.carried in
  let along = inject_Z (dot (nth O t []) yq) in
  if row0.box.box_spring
  then along
  else let z0 =
         slip_at t (combine0 Big_int_Z.unit_big_int yq (Z.opp it.kappa) d)
       in
       let friction0 =
         friction_within it.measured
           (inner_of row0.metric it.psi (slip_at t d))
           (inner_of row0.metric z0 z0)
       in
       qplus along
         (largest_q
           (map (fun mu -> qmult mu friction0) (ends row0.box.box_friction)))

(** val most_work : carrier -> q -> form -> form -> q **)

let most_work it factor0 yq d =
  let u = reduced (qmult (unit_of it.forms_scaled) factor0) in
  reduced (qmult u (largest_q (map (corner_work it yq d) it.at_corners)))

(** val scaled_work :
    Big_int_Z.big_int -> form -> q -> form -> carrier -> q **)

let scaled_work c y factor0 q0 it =
  reduced
    (qmult (unit_of it.carried.pull_scale)
      (most_work it factor0 (twist_at c y q0) (ray_motion q0)))

(** val load_work : load -> Big_int_Z.big_int -> form -> q -> form -> q **)

let load_work ld c y factor0 q0 =
  reduced
    (work_of ld
      (map (fun z0 -> qmult factor0 (inject_Z z0)) (twist_at c y q0))).high

(** val all_works :
    load -> Big_int_Z.big_int -> form -> q -> carrier list -> form -> q list **)

let all_works ld c y factor0 cs q0 =
  (load_work ld c y factor0 q0) :: (map_all (scaled_work c y factor0 q0) cs)

type press = { opens : bool; least_pull : Big_int_Z.big_int;
               most_pull : Big_int_Z.big_int; effort : Big_int_Z.big_int }

(** val press_of : form -> carrier -> Big_int_Z.big_int -> press **)

let press_of q0 it work =
  let vs = map (fun f -> dot f q0) (pull_tips it.carried) in
  { opens = it.may_open; least_pull = (Z.opp (largest (map Z.opp vs)));
  most_pull = (largest vs); effort = work }

(** val pressed : press -> press -> Big_int_Z.big_int **)

let pressed a b =
  if a.opens
  then Z.mul (Z.max Big_int_Z.zero_big_int a.most_pull)
         (Z.max Big_int_Z.zero_big_int b.effort)
  else Z.mul
         (if Z.ltb Big_int_Z.zero_big_int b.effort
          then a.most_pull
          else a.least_pull) b.effort

(** val presses_of :
    form -> carrier list -> Big_int_Z.big_int list -> press list **)

let rec presses_of q0 cs works =
  match cs with
  | [] -> []
  | it :: cs' ->
    (match works with
     | [] -> []
     | w :: works' -> (press_of q0 it w) :: (presses_of q0 cs' works'))

(** val pressed_all :
    press list -> press list -> Big_int_Z.big_int -> Big_int_Z.big_int **)

let rec pressed_all a b sum0 =
  match a with
  | [] -> sum0
  | x :: a' ->
    (match b with
     | [] -> sum0
     | y :: b' -> pressed_all a' b' (Z.add sum0 (pressed x y)))

type at_ray = { the_ray : ray; at_h : Big_int_Z.big_int;
                load_effort : Big_int_Z.big_int; presses : press list }

(** val at_ray_of :
    carrier list -> ray -> Big_int_Z.big_int list -> at_ray **)

let at_ray_of cs r = function
| [] ->
  { the_ray = r; at_h = Big_int_Z.zero_big_int; load_effort =
    Big_int_Z.zero_big_int; presses = [] }
| load0 :: works' ->
  { the_ray = r; at_h = (h_of r.coordinates); load_effort = load0; presses =
    (presses_of r.coordinates cs works') }

(** val work_between : at_ray -> at_ray -> Big_int_Z.big_int **)

let work_between a b =
  pressed_all a.presses b.presses (Z.mul a.at_h b.load_effort)

(** val bound_of : at_ray -> at_ray -> Big_int_Z.big_int **)

let bound_of a b =
  Z.add (work_between a b) (work_between b a)

(** val all_pairs : ('a1 -> 'a1 -> bool) -> 'a1 list -> bool **)

let rec all_pairs test l = match l with
| [] -> true
| a :: l' -> (&&) (forallb (test a) l) (all_pairs test l')

(** val moving_holds :
    form list list -> ray list -> load -> Big_int_Z.big_int -> form -> q ->
    carrier list -> bool **)

let moving_holds strict0 rays0 ld c y factor0 cs =
  let works =
    map (fun r -> (r, (all_works ld c y factor0 cs r.coordinates))) rays0
  in
  let s = scaling_of (concat (map snd works)) in
  let them =
    map (fun p -> at_ray_of cs (fst p) (map_all (to_integer s) (snd p))) works
  in
  (&&)
    (all_pairs (fun a b -> Z.leb (bound_of a b) Big_int_Z.zero_big_int) them)
    (barred strict0
      (map (fun a -> a.the_ray)
        (filter (fun a -> Z.eqb (bound_of a a) Big_int_Z.zero_big_int) them)))

(** val direction_holds :
    ray list -> Big_int_Z.big_int -> form -> matrix -> bool **)

let direction_holds rays0 c y a =
  let rows0 = map (map (to_integer (scaling_of (concat a)))) a in
  all_pairs (fun p q0 ->
    Z.leb Big_int_Z.zero_big_int
      (Z.add (dot (fst p) (snd q0)) (dot (fst q0) (snd p))))
    (map (fun r -> ((twist_at c y r.coordinates),
      (map (fun f -> dot f r.coordinates) rows0))) rays0)

(** val contains : Big_int_Z.big_int -> Big_int_Z.big_int -> bool **)

let contains a b =
  Z.eqb (Z.coq_land a b) b

type height = Big_int_Z.big_int * ray

(** val heights : form -> ray list -> height list **)

let heights a rays0 =
  map (fun r -> ((dot a r.coordinates), r)) rays0

(** val join_form :
    form -> form -> Big_int_Z.big_int -> Big_int_Z.big_int -> form **)

let join_form p n0 at_p at_n =
  combine0 at_p n0 (Z.opp at_n) p

(** val join : Big_int_Z.big_int -> height -> height -> ray **)

let join bit p n0 =
  { coordinates =
    (primitive
      (join_form (snd p).coordinates (snd n0).coordinates (fst p) (fst n0)));
    zeros = (both (snd p).zeros (snd n0).zeros); tight =
    (Z.coq_lor (Z.coq_land (snd p).tight (snd n0).tight) bit) }

(** val parted : ray list -> ray -> ray -> bool **)

let parted rays0 p n0 =
  let common = Z.coq_land p.tight n0.tight in
  existsb (fun g ->
    (&&) ((&&) (contains g.tight common) (negb (Z.eqb g.tight p.tight)))
      (negb (Z.eqb g.tight n0.tight))) rays0

(** val distinct : height list -> bool **)

let distinct hs =
  forallb (fun g ->
    forallb (fun h ->
      (||) (negb (contains (snd h).tight (snd g).tight))
        (Z.eqb (snd g).tight (snd h).tight)) hs) hs

(** val stay : Big_int_Z.big_int -> height -> ray **)

let stay bit h =
  let r = snd h in
  if Z.eqb (fst h) Big_int_Z.zero_big_int
  then { coordinates = r.coordinates; zeros = r.zeros; tight =
         (Z.coq_lor r.tight bit) }
  else r

(** val cut_line : Big_int_Z.big_int -> height -> height list -> ray list **)

let cut_line bit line hs =
  (stay bit line) :: (filter (fun r -> negb (all_zero r.coordinates))
                       (map (join bit line) hs))

(** val on_side : bool -> height list -> height list **)

let on_side positive0 hs =
  filter (fun h ->
    if positive0
    then Z.ltb Big_int_Z.zero_big_int (fst h)
    else Z.ltb (fst h) Big_int_Z.zero_big_int) hs

(** val cut_rays :
    Big_int_Z.big_int -> ray list -> height list -> ray list **)

let cut_rays bit solid hs =
  let below = on_side false hs in
  app
    (map (stay bit)
      (filter (fun h -> Z.leb Big_int_Z.zero_big_int (fst h)) hs))
    (flat_map (fun p ->
      flat_map (fun n0 ->
        if parted solid (snd p) (snd n0) then [] else (join bit p n0) :: [])
        below) (on_side true hs))

(** val most_combinations : height list -> Big_int_Z.big_int **)

let most_combinations hs =
  let count0 = fun l ->
    fold_left (fun n0 _ -> Z.add n0 Big_int_Z.unit_big_int) l
      Big_int_Z.zero_big_int
  in
  Z.add (count0 hs)
    (Z.mul (count0 (on_side true hs)) (count0 (on_side false hs)))

(** val cut : nat -> height list -> ray list option **)

let cut count0 hs =
  let bit = Z.shiftl Big_int_Z.unit_big_int (Z.of_nat count0) in
  let is_line = fun r -> contains r.tight (Z.sub bit Big_int_Z.unit_big_int)
  in
  (match find (fun h ->
           (&&) (is_line (snd h)) (Z.ltb Big_int_Z.zero_big_int (fst h))) hs with
   | Some line -> Some (cut_line bit line hs)
   | None ->
     if existsb (fun h ->
          (&&) (is_line (snd h)) (Z.ltb (fst h) Big_int_Z.zero_big_int)) hs
     then None
     else if (&&) (distinct (on_side true hs)) (distinct (on_side false hs))
          then Some
                 (cut_rays bit
                   (filter (fun r -> negb (is_line r)) (map snd hs)) hs)
          else None)

type 'setting region = { size0 : nat; sides : form list; rays : ray list;
                         strict : form list list; moving : form list list;
                         around : 'setting; depth : Big_int_Z.big_int }

type 'setting branch = { conditions : (form * bool) list;
                         new_strict : form list; new_moving : form list list;
                         branch_setting : 'setting }

(** val cut_above : oracle -> 'a1 region -> form -> 'a1 region **)

let cut_above advisor r f =
  let hs = heights f r.rays in
  if (||) (forallb (fun h -> Z.leb Big_int_Z.zero_big_int (fst h)) hs)
       (negb (advisor.permits (most_combinations hs)))
  then r
  else (match cut (length r.sides) hs with
        | Some them ->
          { size0 = r.size0; sides = (app r.sides (f :: [])); rays = them;
            strict = r.strict; moving = r.moving; around = r.around; depth =
            r.depth }
        | None -> r)

(** val cut_region : oracle -> 'a1 region -> (form * bool) -> 'a1 region **)

let cut_region advisor r c =
  let r' = cut_above advisor r (fst c) in
  if snd c then cut_above advisor r' (negative (fst c)) else r'

(** val strictly : 'a1 region -> form -> 'a1 region **)

let strictly r f =
  { size0 = r.size0; sides = r.sides; rays =
    (map (add_strict (f :: [])) r.rays); strict = ((f :: []) :: r.strict);
    moving = r.moving; around = r.around; depth = r.depth }

(** val cut_foremost :
    oracle -> (form * bool) list -> 'a1 region -> (form * bool) list -> 'a1
    region **)

let rec cut_foremost advisor times0 r cs =
  match times0 with
  | [] -> r
  | _ :: times' ->
    (match advisor.foremost (map (fun r0 -> r0.coordinates) r.rays) cs with
     | Some k ->
       (match numbered cs k with
        | Some c -> cut_foremost advisor times' (cut_region advisor r c) cs
        | None -> r)
     | None -> r)

(** val cut_by : oracle -> 'a1 region -> (form * bool) list -> 'a1 region **)

let cut_by advisor r cs =
  fold_left (cut_region advisor) cs (cut_foremost advisor cs r cs)

(** val child : oracle -> 'a1 region -> 'a1 branch -> 'a1 region **)

let child advisor r b =
  let r0 = fold_left strictly b.new_strict (cut_by advisor r b.conditions) in
  { size0 = r0.size0; sides = r0.sides; rays = r0.rays; strict = r0.strict;
  moving = (app b.new_moving r0.moving); around = b.branch_setting; depth =
  (Z.add r0.depth Big_int_Z.unit_big_int) }

(** val is_leaf : node -> bool **)

let is_leaf = function
| Leaf _ -> true
| Moving (_, _, _) -> true
| Held _ -> true
| _ -> false

(** val at_leaf : 'a1 region -> form list list * ray list **)

let at_leaf r =
  fold_left (fun sr fs -> ((fs :: (fst sr)), (map (add_strict fs) (snd sr))))
    r.moving (r.strict, r.rays)

(** val visit :
    oracle -> ('a1 -> node -> ('a1 branch list, string) sum) -> ('a1 -> form
    list list -> ray list -> node -> string option) -> Big_int_Z.big_int ->
    node -> 'a1 region -> ('a1 region list, string) sum **)

let visit advisor split0 leaf_fails0 most_depth0 n0 r =
  if Z.ltb most_depth0 r.depth
  then Inr "node-depth"
  else if is_leaf n0
       then let (strict', rays') = at_leaf r in
            (match leaf_fails0 r.around strict' rays' n0 with
             | Some rule -> Inr rule
             | None -> Inl [])
       else (match split0 r.around n0 with
             | Inl bs -> Inl (map (child advisor r) bs)
             | Inr rule -> Inr rule)

(** val walk :
    oracle -> ('a1 -> node -> ('a1 branch list, string) sum) -> ('a1 -> form
    list list -> ray list -> node -> string option) -> Big_int_Z.big_int ->
    node list -> 'a1 region list -> nat -> (string * nat) option **)

let rec walk advisor split0 leaf_fails0 most_depth0 nodes todo number =
  match nodes with
  | [] -> (match todo with
           | [] -> None
           | _ :: _ -> Some ("tree-short", number))
  | n0 :: nodes' ->
    (match todo with
     | [] -> Some ("tree-long", number)
     | r :: todo' ->
       (match visit advisor split0 leaf_fails0 most_depth0 n0 r with
        | Inl children ->
          walk advisor split0 leaf_fails0 most_depth0 nodes'
            (app children todo') (S number)
        | Inr rule -> Some (rule, number)))

(** val basis : nat -> nat -> form list **)

let rec basis before = function
| O -> []
| S n' ->
  (app (repeat Big_int_Z.zero_big_int before)
    (Big_int_Z.unit_big_int :: (repeat Big_int_Z.zero_big_int n'))) :: 
    (basis (S before) n')

(** val everywhere : nat -> 'a1 -> 'a1 region **)

let everywhere n0 s =
  { size0 = n0; sides = []; rays =
    (flat_map (fun e -> { coordinates = e; zeros = []; tight =
      Big_int_Z.zero_big_int } :: ({ coordinates = (map Z.opp e); zeros = [];
      tight = Big_int_Z.zero_big_int } :: [])) (basis O n0)); strict = [];
    moving = []; around = s; depth = (Big_int_Z.minus_big_int
    Big_int_Z.unit_big_int) }

(** val root : oracle -> nat -> 'a1 branch -> 'a1 region **)

let root advisor n0 b =
  child advisor (everywhere n0 b.branch_setting) b

(** val replace_after :
    'a1 list -> 'a1 list -> Big_int_Z.big_int -> 'a1 -> 'a1 list **)

let rec replace_after before l i new0 =
  match l with
  | [] -> rev_append before []
  | a :: l' ->
    if Z.eqb i Big_int_Z.zero_big_int
    then rev_append before (new0 :: l')
    else replace_after (a :: before) l' (Z.sub i Big_int_Z.unit_big_int) new0

(** val replace : 'a1 list -> Big_int_Z.big_int -> 'a1 -> 'a1 list **)

let replace l i new0 =
  replace_after [] l i new0

type range = { range_low : q; range_high : q option; open_low : bool;
               open_high : bool }

type pushing = { a_multiple : matrix; known_push : matrix }

(** val no_push : pushing **)

let no_push =
  { a_multiple = []; known_push = [] }

type setting = { dimension_of : nat; rows : row list; the_load : load;
                 pushes : pushing; slipping : Big_int_Z.big_int list;
                 short : Big_int_Z.big_int; exact : Big_int_Z.big_int;
                 the_bound : q list option }

(** val common_multiple : row list -> Big_int_Z.big_int **)

let common_multiple rows0 =
  fold_left (fun m r -> Z.lcm m r.over_weight) rows0 Big_int_Z.unit_big_int

(** val short_multiple :
    row list -> Big_int_Z.big_int -> Big_int_Z.big_int **)

let short_multiple rows0 multiple0 =
  let size1 = fun r ->
    if r.box.box_signed
    then Z.div r.over_weight r.weight
    else Z.div r.pull_scale.over r.pull_scale.times
  in
  let most =
    fold_left (fun b r -> Z.max b (size1 r)) rows0 Big_int_Z.unit_big_int
  in
  let short0 =
    Z.shiftl Big_int_Z.unit_big_int
      (Z.add (Z.log2 most)
        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)))))))
  in
  if (||) (Z.ltb short0 multiple0)
       (negb (forallb (fun r -> r.box.box_signed) rows0))
  then short0
  else multiple0

(** val make_setting :
    nat -> row list -> load -> pushing -> q list option -> setting **)

let make_setting dimension0 rows0 ld pushes0 bound =
  let m = common_multiple rows0 in
  { dimension_of = dimension0; rows = rows0; the_load = ld; pushes = pushes0;
  slipping = []; short = (short_multiple rows0 m); exact = m; the_bound =
  bound }

(** val without_bound : setting -> setting **)

let without_bound s =
  { dimension_of = s.dimension_of; rows = s.rows; the_load = s.the_load;
    pushes = s.pushes; slipping = s.slipping; short = s.short; exact =
    s.exact; the_bound = None }

(** val leaf_fails :
    setting -> form list list -> ray list -> q list -> string option **)

let leaf_fails s strict0 rays0 y =
  let sc = scaling_of y in
  let y' = map (to_integer sc) y in
  if (||) (barred strict0 rays0) (beyond_bound s.the_bound strict0 rays0)
  then None
  else let them =
         pressers strict0 rays0 s.slipping (unit_of sc) y' s.rows
           Big_int_Z.zero_big_int []
       in
       let works = load_works s.the_load (unit_of sc) y' in
       let more =
         map (fun q0 -> reduced (qdiv q0 (unit_of sc)))
           (of_rows y s.pushes.known_push)
       in
       let holds = fun m -> leaf_holds_by m them works more strict0 rays0 y'
       in
       if (||) ((&&) (negb (Z.eqb s.short s.exact)) (holds s.short))
            (holds (with_all s.exact works more them))
       then let along = of_rows y s.pushes.a_multiple in
            if nowhere_negative rays0
                 (map (to_integer (scaling_of along)) along)
            then None
            else Some "leaf-direction"
       else Some "leaf-bound"

(** val moving_fails :
    setting -> form list list -> ray list -> q list -> q ->
    (Big_int_Z.big_int * (q * q list)) list -> string option **)

let moving_fails s strict0 rays0 y along_motion brakes =
  let sc =
    scaling_of
      (along_motion :: (app y
                         (concat
                           (map (fun f -> (fst (snd f)) :: (snd (snd f)))
                             brakes))))
  in
  let c = to_integer sc along_motion in
  let y0 = map (to_integer sc) y in
  let them =
    map (fun f -> ((fst f), ((to_integer sc (fst (snd f))),
      (map (to_integer sc) (snd (snd f)))))) brakes
  in
  let of_contacts = fun exact0 ->
    carriers exact0 (unit_of sc) rays0 them s.rows Big_int_Z.zero_big_int []
  in
  let holds = moving_holds strict0 rays0 s.the_load c y0 (unit_of sc) in
  (match of_contacts false with
   | Some cs ->
     if (||) (barred strict0 rays0) (beyond_bound s.the_bound strict0 rays0)
     then None
     else if (&&)
               ((&&) (Nat.eqb (length s.pushes.known_push) O)
                 (forallb is_zero s.the_load.load_growth))
               ((||) (holds cs)
                 (match of_contacts true with
                  | Some cs0 -> holds cs0
                  | None -> false))
          then if direction_holds rays0 c y0 s.pushes.a_multiple
               then None
               else Some "leaf-direction"
          else Some "leaf-bound"
   | None -> Some "moving-list")

(** val end_fails :
    (Big_int_Z.big_int -> ray list -> string option) -> setting -> form list
    list -> ray list -> node -> string option **)

let end_fails held0 s strict0 rays0 = function
| Leaf y -> leaf_fails s strict0 rays0 y
| Moving (y, c, brakes) -> moving_fails s strict0 rays0 y c brakes
| Held k -> held0 k rays0
| _ -> Some "node-contact"

(** val no_pieces : Big_int_Z.big_int -> ray list -> string option **)

let no_pieces _ _ =
  Some "held-piece"

(** val is_inside : interval -> q -> bool **)

let is_inside i c =
  (&&) (negb (qle_bool c i.low)) (negb (qle_bool i.high c))

(** val low_half : interval -> q -> interval **)

let low_half i c =
  { low = i.low; high = c }

(** val high_half : interval -> q -> interval **)

let high_half i c =
  { low = c; high = i.high }

(** val same_parameter : parameter -> parameter -> bool **)

let same_parameter a b =
  match a with
  | PX -> (match b with
           | PX -> true
           | _ -> false)
  | PY -> (match b with
           | PY -> true
           | _ -> false)
  | PZ -> (match b with
           | PZ -> true
           | _ -> false)
  | PTurn -> (match b with
              | PTurn -> true
              | _ -> false)
  | PTurnV -> (match b with
               | PTurnV -> true
               | _ -> false)
  | PFriction -> (match b with
                  | PFriction -> true
                  | _ -> false)
  | PPreload -> (match b with
                 | PPreload -> true
                 | _ -> false)
  | PStiffness -> (match b with
                   | PStiffness -> true
                   | _ -> false)
  | PWrench -> (match b with
                | PWrench -> true
                | _ -> false)

(** val get_named :
    parameter -> parameter list -> interval list -> interval option **)

let rec get_named name names is =
  match names with
  | [] -> None
  | n0 :: names' ->
    (match is with
     | [] -> None
     | i :: is' ->
       if same_parameter n0 name then Some i else get_named name names' is')

(** val set_named :
    parameter -> interval -> parameter list -> interval list -> interval list **)

let rec set_named name new0 names is =
  match names with
  | [] -> is
  | n0 :: names' ->
    (match is with
     | [] -> is
     | i :: is' ->
       if same_parameter n0 name
       then new0 :: is'
       else i :: (set_named name new0 names' is'))

(** val get : cbox -> parameter -> interval option **)

let get b name = match name with
| PFriction -> if has_friction b then Some b.box_friction else None
| PPreload -> Some b.box_preload
| PStiffness -> Some b.box_stiffness
| PWrench -> None
| _ -> get_named name b.box_names b.box_geometry

(** val set : cbox -> parameter -> interval -> cbox **)

let set b name i =
  let { box_names = names; box_geometry = g; box_forms = f; box_friction = m;
    box_preload = p; box_growth = u; box_stiffness = k; box_square = sq;
    box_normal = n0; box_weights = w; box_signed = sg; box_spring = sp;
    box_turns = tu; box_slack = sl } = b
  in
  (match name with
   | PFriction ->
     { box_names = names; box_geometry = g; box_forms = f; box_friction = i;
       box_preload = p; box_growth = u; box_stiffness = k; box_square = sq;
       box_normal = n0; box_weights = w; box_signed = sg; box_spring = sp;
       box_turns = tu; box_slack = sl }
   | PPreload ->
     { box_names = names; box_geometry = g; box_forms = f; box_friction = m;
       box_preload = i; box_growth = u; box_stiffness = k; box_square = sq;
       box_normal = n0; box_weights = w; box_signed = sg; box_spring = sp;
       box_turns = tu; box_slack = sl }
   | PStiffness ->
     { box_names = names; box_geometry = g; box_forms = f; box_friction = m;
       box_preload = p; box_growth = u; box_stiffness = i; box_square = sq;
       box_normal = n0; box_weights = w; box_signed = sg; box_spring = sp;
       box_turns = tu; box_slack = sl }
   | PWrench -> b
   | _ ->
     { box_names = names; box_geometry = (set_named name i names g);
       box_forms = f; box_friction = m; box_preload = p; box_growth = u;
       box_stiffness = k; box_square = sq; box_normal = n0; box_weights = w;
       box_signed = sg; box_spring = sp; box_turns = tu; box_slack = sl })

(** val set_row : setting -> Big_int_Z.big_int -> cbox -> setting **)

let set_row s index b =
  let row0 = make_row b in
  { dimension_of = s.dimension_of; rows = (replace s.rows index row0);
  the_load = s.the_load; pushes = s.pushes; slipping = s.slipping; short =
  s.short; exact = (Z.lcm s.exact row0.over_weight); the_bound = s.the_bound }

(** val set_load : setting -> load -> setting **)

let set_load s ld =
  { dimension_of = s.dimension_of; rows = s.rows; the_load = ld; pushes =
    s.pushes; slipping = s.slipping; short = s.short; exact = s.exact;
    the_bound = s.the_bound }

(** val numbers_of0 : load -> interval list **)

let numbers_of0 ld =
  match ld.load_added.ball_numbers with
  | [] -> ld.load_box
  | i :: l -> i :: l

(** val with_numbers : load -> interval list -> load **)

let with_numbers ld is =
  let a = ld.load_added in
  (match a.ball_numbers with
   | [] -> { load_box = is; load_growth = ld.load_growth; load_added = a }
   | _ :: _ ->
     { load_box = ld.load_box; load_growth = ld.load_growth; load_added =
       { ball_numbers = is; ball_ways = a.ball_ways; ball_squares =
       a.ball_squares } })

(** val halves :
    setting -> parameter -> Big_int_Z.big_int -> q -> (setting * setting,
    string) sum **)

let halves s name index c =
  match name with
  | PWrench ->
    let ld = s.the_load in
    (match numbered (numbers_of0 ld) index with
     | Some i ->
       if is_inside i c
       then Inl
              ((set_load s
                 (with_numbers ld
                   (replace (numbers_of0 ld) index (low_half i c)))),
              (set_load s
                (with_numbers ld
                  (replace (numbers_of0 ld) index (high_half i c)))))
       else Inr "part-inside"
     | None -> Inr "part-contact")
  | _ ->
    (match numbered s.rows index with
     | Some row0 ->
       (match get row0.box name with
        | Some i ->
          if (&&) (is_inside i c)
               ((||) (negb (same_parameter name PPreload))
                 (certain row0.box.box_growth))
          then Inl ((set_row s index (set row0.box name (low_half i c))),
                 (set_row s index (set row0.box name (high_half i c))))
          else Inr "part-inside"
        | None -> Inr "part-contact")
     | None -> Inr "part-contact")

(** val above : setting -> form -> setting branch **)

let above s f =
  { conditions = ((f, false) :: []); new_strict = (f :: []); new_moving = [];
    branch_setting = s }

(** val not_below : setting -> form -> setting branch **)

let not_below s f =
  { conditions = ((f, false) :: []); new_strict = []; new_moving = [];
    branch_setting = s }

(** val on_plane : setting -> form -> setting branch **)

let on_plane s f =
  { conditions = ((f, true) :: []); new_strict = []; new_moving = [];
    branch_setting = s }

(** val plane_numbers : nat -> q list -> q list **)

let plane_numbers d a =
  (nth d a { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }) :: (
    (nth (S d) a { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int }) :: (firstn d a))

(** val slip_forms : row -> form list **)

let slip_forms row0 =
  map of_motion (firstn (length row0.metric) (tl (first_tip row0.forms)))

(** val split : setting -> node -> (setting branch list, string) sum **)

let split s = function
| Slip i ->
  (match numbered s.rows i with
   | Some row0 ->
     if negb (has_friction row0.box)
     then Inr "node-contact"
     else if negb row0.slip_certain
          then Inr "node-certain"
          else if row0.box.box_signed
               then let f = first_tip row0.tau in
                    Inl
                    ((above s f) :: ((on_plane s f) :: ((above s (negative f)) :: [])))
               else let fs = slip_forms row0 in
                    Inl ({ conditions = (map (fun f -> (f, true)) fs);
                    new_strict = []; new_moving = []; branch_setting =
                    s } :: ({ conditions = []; new_strict = []; new_moving =
                    (fs :: []); branch_setting = { dimension_of =
                    s.dimension_of; rows = s.rows; the_load = s.the_load;
                    pushes = s.pushes; slipping = (i :: s.slipping); short =
                    s.short; exact = s.exact; the_bound =
                    s.the_bound } } :: []))
   | None -> Inr "node-contact")
| Separation i ->
  (match numbered s.rows i with
   | Some row0 ->
     if row0.box.box_spring
     then Inr "node-contact"
     else (match row0.separates with
           | Some f -> Inl ((not_below s f) :: ((above s (negative f)) :: []))
           | None -> Inr "node-certain")
   | None -> Inr "node-contact")
| Plane a ->
  let a0 = plane_numbers s.dimension_of a in
  let f = map (to_integer (scaling_of a0)) a0 in
  Inl ((not_below s f) :: ((above s (negative f)) :: []))
| Cut (name, i, c) ->
  (match halves s name i c with
   | Inl p ->
     let (l, h) = p in
     Inl ({ conditions = []; new_strict = []; new_moving = [];
     branch_setting = l } :: ({ conditions = []; new_strict = [];
     new_moving = []; branch_setting = h } :: []))
   | Inr rule -> Inr rule)
| _ -> Inl []

(** val l_above : q -> form **)

let l_above a =
  (Z.opp a.qnum) :: (a.qden :: [])

(** val h_form : form **)

let h_form =
  Big_int_Z.unit_big_int :: []

(** val range_conditions : range -> form list **)

let range_conditions g =
  h_form :: ((l_above g.range_low) :: (match g.range_high with
                                       | Some b ->
                                         (negative (l_above b)) :: []
                                       | None -> []))

(** val range_strict : range -> form list **)

let range_strict g =
  h_form :: (app (if g.open_low then (l_above g.range_low) :: [] else [])
              (match g.range_high with
               | Some b ->
                 if g.open_high then (negative (l_above b)) :: [] else []
               | None -> []))

(** val separating : row list -> form list -> form list **)

let separating rows0 before =
  rev_append
    (fold_left (fun fs r ->
      match r.separates with
      | Some f -> if r.box.box_spring then fs else f :: fs
      | None -> fs) rows0 (rev_append before [])) []

(** val root_branch : bool -> setting -> range -> setting branch **)

let root_branch two_sided s g =
  let fs = app (range_conditions g) (bound_conditions s.the_bound) in
  { conditions =
  (map_all (fun f -> (f, false))
    (if two_sided then separating s.rows fs else fs)); new_strict =
  (range_strict g); new_moving = []; branch_setting = s }

(** val walk_ranges :
    oracle -> (Big_int_Z.big_int -> ray list -> string option) ->
    Big_int_Z.big_int -> bool -> setting -> range list -> node list ->
    (string * nat) option **)

let walk_ranges advisor held0 most_depth0 two_sided s ranges0 nodes =
  walk advisor split (end_fails held0) most_depth0 nodes
    (map_all (fun g ->
      root advisor (add (S (S O)) s.dimension_of) (root_branch two_sided s g))
      ranges0) O

(** val exact_box : cbox -> bool **)

let exact_box b =
  (&&)
    ((&&)
      ((&&)
        ((&&) ((&&) (negb b.box_turns) (forallb certain b.box_geometry))
          (certain b.box_friction)) (certain b.box_preload))
      (certain b.box_growth)) (certain b.box_stiffness)

(** val exact_rows : row list -> bool **)

let exact_rows rows0 =
  forallb (fun r -> exact_box r.box) rows0

type state = { state_row : row; state_v : Big_int_Z.big_int;
               state_slip : form; state_share : q list; is_against : 
               bool }

(** val exact_pull : row -> form **)

let exact_pull r =
  match r.pulls with
  | [] -> []
  | p :: _ -> first_tip p

(** val slip_of_row : row -> form -> form **)

let slip_of_row r x =
  if r.box.box_signed
  then (dot (first_tip r.tau) x) :: []
  else slip_at (first_tip r.forms) (tl (tl x))

(** val product_q : q list -> q list -> q list -> q **)

let rec product_q ws s t =
  match ws with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | w :: ws' ->
    (match s with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | x :: s' ->
       (match t with
        | [] ->
          { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
        | y :: t' -> qplus (qmult (qmult w x) y) (product_q ws' s' t')))

(** val mu_of : cbox -> q **)

let mu_of b =
  b.box_friction.low

(** val in_friction_cone : cbox -> q list -> bool **)

let in_friction_cone b g =
  qle_bool (product_q b.box_weights g g) b.box_square

(** val against : cbox -> q list -> form -> bool **)

let against b g e =
  let s = map inject_Z e in
  let p = product_q b.box_weights g s in
  (&&)
    (qle_bool p { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int })
    (qeq_bool (qmult p p) (qmult b.box_square (product_q b.box_weights s s)))

(** val share_of_force : cbox -> q list -> q list **)

let share_of_force b f =
  map (fun wf -> qdiv (snd wf) (fst wf)) (combine b.box_weights f)

(** val sum_of_products : q list -> q list -> q **)

let rec sum_of_products a b =
  match a with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | x :: a' ->
    (match b with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | y :: b' -> qplus (qmult x y) (sum_of_products a' b'))

(** val is_share_of : cbox -> q list -> bool **)

let is_share_of b f =
  (&&) (Nat.eqb (length f) (length b.box_weights))
    ((||) b.box_signed
      (qeq_bool (sum_of_products f b.box_normal) { qnum =
        Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val presses0 : cbox -> Big_int_Z.big_int -> bool **)

let presses0 b v =
  (||) b.box_spring (Z.ltb Big_int_Z.zero_big_int v)

(** val sliding : cbox -> form -> q list **)

let sliding b slip =
  if b.box_signed
  then map (fun t ->
         if Z.ltb Big_int_Z.zero_big_int t
         then { qnum = (Big_int_Z.minus_big_int Big_int_Z.unit_big_int);
                qden = Big_int_Z.unit_big_int }
         else { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int })
         slip
  else let s = map inject_Z slip in
       let root0 =
         (root_between (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))))))
           (reduced (qdiv b.box_square (product_q b.box_weights s s)))).low
       in
       map (fun t -> reduced (qmult (qopp root0) t)) s

(** val state_of : row -> form -> q list option -> state option **)

let state_of r x given =
  let b = r.box in
  let v = dot (exact_pull r) x in
  let slip = slip_of_row r x in
  (match given with
   | Some f ->
     let g = share_of_force b f in
     if (&&) ((&&) ((&&) (has_friction b) (all_zero slip)) (is_share_of b f))
          (in_friction_cone b g)
     then Some { state_row = r; state_v = v; state_slip = slip; state_share =
            g; is_against = true }
     else None
   | None ->
     if (||) ((||) (all_zero slip) (negb (presses0 b v)))
          (qeq_bool (mu_of b) { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int })
     then Some { state_row = r; state_v = v; state_slip = slip; state_share =
            []; is_against = true }
     else let g = sliding b slip in
          if (&&) (in_friction_cone b g) (against b g slip)
          then Some { state_row = r; state_v = v; state_slip = slip;
                 state_share = g; is_against = true }
          else Some { state_row = r; state_v = v; state_slip = slip;
                 state_share = []; is_against = false })

(** val states :
    row list -> form -> (Big_int_Z.big_int * q list) list ->
    Big_int_Z.big_int -> state list -> state list option **)

let rec states rows0 x shares0 number before =
  match rows0 with
  | [] -> (match shares0 with
           | [] -> Some before
           | _ :: _ -> None)
  | r :: rows' ->
    (match shares0 with
     | [] ->
       let given = None in
       let shares' = [] in
       (match state_of r x given with
        | Some s ->
          states rows' x shares' (Z.add number Big_int_Z.unit_big_int)
            (s :: before)
        | None -> None)
     | p :: rest ->
       let (i, s) = p in
       if Z.eqb i number
       then let given = Some s in
            (match state_of r x given with
             | Some s0 ->
               states rows' x rest (Z.add number Big_int_Z.unit_big_int)
                 (s0 :: before)
             | None -> None)
       else let given = None in
            (match state_of r x given with
             | Some s0 ->
               states rows' x shares0 (Z.add number Big_int_Z.unit_big_int)
                 (s0 :: before)
             | None -> None))

(** val exact_forms : cbox -> q list list **)

let exact_forms b =
  b.box_forms (map (fun i -> i.low) b.box_geometry)

(** val add_friction :
    q -> q list -> q list -> q list list -> q list -> q list **)

let rec add_friction c ws g forms0 sum0 =
  match ws with
  | [] -> sum0
  | w :: ws' ->
    (match g with
     | [] -> sum0
     | q0 :: g' ->
       (match forms0 with
        | [] -> sum0
        | f :: forms' ->
          add_friction c ws' g' forms'
            (add_multiple sum0 (qmult (qmult c w) q0) f)))

(** val wrench_of : state -> q list **)

let wrench_of s =
  let r = s.state_row in
  let b = r.box in
  if presses0 b s.state_v
  then let a = { qnum = (Z.mul s.state_v r.pull_scale.times); qden =
         (Z.to_pos r.pull_scale.over) }
       in
       let fs = exact_forms b in
       map (fun c -> reduced (qmult a c))
         (add_friction (mu_of b) b.box_weights s.state_share (tl fs)
           (nth O fs []))
  else []

(** val load_at : load -> Big_int_Z.big_int -> Big_int_Z.big_int -> q list **)

let load_at ld h l =
  map (fun p ->
    reduced
      (qplus (qmult (inject_Z h) (fst p).low) (qmult (inject_Z l) (snd p))))
    (combine ld.load_box ld.load_growth)

(** val common_of : q list list -> Big_int_Z.big_int **)

let common_of wrenches =
  fold_left (fun d w -> fold_left (fun d0 q0 -> Z.lcm q0.qden d0) w d)
    wrenches Big_int_Z.unit_big_int

(** val adds_up_to_zero : q list list -> bool **)

let adds_up_to_zero wrenches =
  let d = common_of wrenches in
  all_zero
    (fold_left (fun s w ->
      combine0 Big_int_Z.unit_big_int s Big_int_Z.unit_big_int
        (map (numerator d) w)) wrenches [])

(** val check_point :
    bool -> nat -> row list -> load -> form -> (Big_int_Z.big_int * q list)
    list -> (state list, string) sum **)

let check_point bilateral0 dim rows0 ld x shares0 =
  match x with
  | [] -> Inr "witness-balance"
  | h :: l0 ->
    (match l0 with
     | [] -> Inr "witness-balance"
     | l :: d ->
       (match states rows0 x shares0 Big_int_Z.zero_big_int [] with
        | Some ss ->
          if (&&) bilateral0
               (negb
                 (forallb (fun s ->
                   (||) s.state_row.box.box_spring
                     (Z.leb Big_int_Z.zero_big_int s.state_v)) ss))
          then Inr "witness-normal"
          else if negb (forallb (fun s -> s.is_against) ss)
               then Inr "witness-root"
               else if (&&) (Nat.eqb (length d) dim)
                         (adds_up_to_zero
                           ((load_at ld h l) :: (map_all wrench_of ss)))
                    then Inl ss
                    else Inr "witness-balance"
        | None -> Inr "witness-share"))

(** val aligned : form -> form -> form -> bool **)

let aligned ms s t =
  let p = inner_of ms s t in
  (||) ((||) (all_zero s) (all_zero t))
    ((&&) (Z.ltb Big_int_Z.zero_big_int p)
      (Z.eqb (Z.mul p p) (Z.mul (inner_of ms s s) (inner_of ms t t))))

(** val first_slip : state list -> form **)

let first_slip them =
  match find (fun s -> negb (all_zero s.state_slip)) them with
  | Some s -> s.state_slip
  | None -> []

(** val contact_mode : state list -> bool **)

let contact_mode them = match them with
| [] -> true
| s :: _ ->
  let r = s.state_row in
  let b = r.box in
  let e = first_slip them in
  (&&)
    ((||)
      ((||) b.box_spring
        (forallb (fun s0 -> Z.leb Big_int_Z.zero_big_int s0.state_v) them))
      (forallb (fun s0 -> Z.leb s0.state_v Big_int_Z.zero_big_int) them))
    ((||)
      ((||)
        ((||)
          (qeq_bool (mu_of b) { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int })
          (forallb (fun s0 -> Z.leb s0.state_v Big_int_Z.zero_big_int) them))
        (all_zero e))
      (forallb (fun s0 ->
        (&&) (aligned r.metric e s0.state_slip)
          ((||) (Z.leb s0.state_v Big_int_Z.zero_big_int)
            (against b s0.state_share e))) them))

(** val same_mode : state list -> state list -> bool **)

let rec same_mode ss ts =
  match ss with
  | [] -> true
  | s :: ss' ->
    (match ts with
     | [] -> true
     | t :: ts' -> (&&) (contact_mode (s :: (t :: []))) (same_mode ss' ts'))

(** val coordinates_of : point -> q list **)

let coordinates_of p =
  app
    (match p.multiple with
     | Some l ->
       { qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } :: (l :: [])
     | None ->
       { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } :: [])) p.point_witness.twist

(** val integer_point : point -> form **)

let integer_point p =
  map (to_integer (scaling_of (coordinates_of p))) (coordinates_of p)

(** val check_at :
    bool -> nat -> row list -> load -> q list option -> point -> (state list,
    string) sum **)

let check_at two_sided dim rows0 ld bound p =
  if point_within bound (integer_point p)
  then check_point two_sided dim rows0 ld (integer_point p)
         p.point_witness.shares
  else Inr "witness-bound"

(** val qlt_bool : q -> q -> bool **)

let qlt_bool a b =
  negb (qle_bool b a)

(** val beyond : q option -> q option -> bool **)

let beyond high0 to1 =
  match high0 with
  | Some h -> (match to1 with
               | Some t -> qlt_bool h t
               | None -> true)
  | None -> false

(** val reaches : q option -> q option -> bool **)

let reaches high0 to1 =
  match high0 with
  | Some h -> (match to1 with
               | Some t -> qeq_bool h t
               | None -> false)
  | None -> (match to1 with
             | Some _ -> false
             | None -> true)

(** val segments_fail :
    bool -> nat -> row list -> load -> q list option -> (q -> q option -> q
    list -> q list -> q list list -> q list list -> node list ->
    (string * nat option) option) -> bool -> segment list -> (q * q option)
    list -> q option -> (point * state list) option -> nat ->
    (string * place) option **)

let rec segments_fail two_sided dim rows0 ld bound degree unloaded0 segments resisted from0 last number =
  let out_of_chain = Some ("segment-chain", (AtSegment (number, None))) in
  (match segments with
   | [] -> (match resisted with
            | [] -> None
            | _ :: _ -> out_of_chain)
   | s :: segments' ->
     (match s with
      | Segment (first_point, second) ->
        (match resisted with
         | [] -> out_of_chain
         | p :: resisted' ->
           let (lo, hi) = p in
           let first =
             match first_point with
             | Some p0 ->
               Some (p0, (check_at two_sided dim rows0 ld bound p0))
             | None ->
               (match last with
                | Some p0 -> let (p1, ss) = p0 in Some (p1, (Inl ss))
                | None -> None)
           in
           (match first with
            | Some p0 ->
              let (p1, checked) = p0 in
              (match p1.multiple with
               | Some l1 ->
                 let start = match from0 with
                             | Some e -> e
                             | None -> lo in
                 if (||)
                      ((||) (negb (qeq_bool l1 start))
                        (beyond hi second.multiple))
                      (match second.multiple with
                       | Some l2 -> qlt_bool l2 l1
                       | None -> false)
                 then out_of_chain
                 else (match checked with
                       | Inl ss1 ->
                         (match check_at two_sided dim rows0 ld bound second with
                          | Inl ss2 ->
                            if same_mode ss1 ss2
                            then if reaches hi second.multiple
                                 then segments_fail two_sided dim rows0 ld
                                        bound degree unloaded0 segments'
                                        resisted' None (Some (second, ss2))
                                        (S number)
                                 else segments_fail two_sided dim rows0 ld
                                        bound degree unloaded0 segments'
                                        resisted second.multiple (Some
                                        (second, ss2)) (S number)
                            else Some ("segment-mode", (AtSegment (number,
                                   None)))
                          | Inr rule -> Some (rule, (AtPoint (number, true))))
                       | Inr rule -> Some (rule, (AtPoint (number, false))))
               | None -> out_of_chain)
            | None -> out_of_chain))
      | SegmentByDegree (to1, d1, d2, walls0, direction0, tree) ->
        (match resisted with
         | [] -> out_of_chain
         | p :: resisted' ->
           let (lo, hi) = p in
           let start = match from0 with
                       | Some e -> e
                       | None -> lo in
           let goes_up0 =
             match to1 with
             | Some t -> qlt_bool start t
             | None ->
               (||)
                 (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
                   Big_int_Z.unit_big_int } start)
                 ((&&)
                   (qeq_bool start { qnum = Big_int_Z.zero_big_int; qden =
                     Big_int_Z.unit_big_int }) unloaded0)
           in
           if (||) (negb goes_up0) (beyond hi to1)
           then out_of_chain
           else (match degree start to1 d1 d2 walls0 direction0 tree with
                 | Some p0 ->
                   let (rule, node0) = p0 in
                   Some (rule, (AtSegment (number, node0)))
                 | None ->
                   if reaches hi to1
                   then segments_fail two_sided dim rows0 ld bound degree
                          unloaded0 segments' resisted' None None (S number)
                   else segments_fail two_sided dim rows0 ld bound degree
                          unloaded0 segments' resisted to1 None (S number)))))

(** val order_fails :
    q option -> bool -> (q * q option) list -> nat -> nat option **)

let rec order_fails least first resisted number =
  match resisted with
  | [] -> None
  | p :: resisted' ->
    let (lo, hi) = p in
    let starts =
      match least with
      | Some q0 -> if first then qle_bool q0 lo else qlt_bool q0 lo
      | None -> false
    in
    let ends0 = match hi with
                | Some h -> qle_bool lo h
                | None -> true in
    if (&&) starts ends0
    then order_fails hi false resisted' (S number)
    else Some number

(** val gaps_from :
    q -> bool -> (q * q option) list -> range list -> range list **)

let rec gaps_from from0 open0 resisted before =
  match resisted with
  | [] ->
    rev_append ({ range_low = from0; range_high = None; open_low = open0;
      open_high = true } :: before) []
  | p :: resisted' ->
    let (lo, hi) = p in
    let now =
      if qlt_bool from0 lo
      then { range_low = from0; range_high = (Some lo); open_low = open0;
             open_high = true } :: before
      else before
    in
    (match hi with
     | Some h -> gaps_from h true resisted' now
     | None -> rev_append now [])

(** val gaps : (q * q option) list -> range list **)

let gaps resisted =
  gaps_from { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
    false resisted []

(** val opposite : vector -> vector **)

let opposite a =
  map qopp a

(** val walls_of : bool -> matrix -> matrix **)

let walls_of simplex e =
  if simplex then e else flat_map (fun a -> a :: ((opposite a) :: [])) e

(** val transpose : nat -> matrix -> matrix **)

let transpose columns0 m =
  map (fun j ->
    map (fun a ->
      nth j a { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
      m) (seq O columns0)

(** val all_positive : vector -> bool **)

let all_positive c =
  forallb (fun q0 ->
    negb
      (qle_bool q0 { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int })) c

(** val zeros0 : nat -> vector **)

let zeros0 n0 =
  repeat { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } n0

(** val balances : nat -> matrix -> vector -> bool **)

let balances n0 e c =
  (&&) ((&&) (all_positive c) (Nat.eqb (length c) (length e)))
    (same_vectors (of_rows c e) (zeros0 n0))

(** val is_simplex : nat -> matrix -> bool **)

let is_simplex n0 e =
  match kernel (length e) (transpose n0 e) with
  | [] -> false
  | c :: l ->
    (match l with
     | [] -> (||) (balances n0 e c) (balances n0 e (opposite c))
     | _ :: _ -> false)

(** val frame : bool -> matrix -> matrix -> matrix **)

let frame simplex e free =
  app (if simplex then removelast e else e) free

(** val free_motions : nat -> bool -> matrix -> matrix option **)

let free_motions n0 simplex e =
  let free = kernel n0 e in
  let all = frame simplex e free in
  if (&&)
       ((&&) ((&&) (all_of_length n0 e) (all_of_length n0 free))
         (is_inverse n0 (inverse_of n0 all) all))
       ((||) (negb simplex) (is_simplex n0 e))
  then Some free
  else None

(** val plus_square : vector -> matrix -> matrix **)

let plus_square z0 m =
  map (fun p -> plus_times (snd p) (fst p) z0) (combine z0 m)

(** val inverted : nat -> matrix -> matrix -> (matrix * matrix) option **)

let inverted n0 free a =
  let m = fold_right plus_square a free in
  let inverse = inverse_of n0 m in
  if (&&)
       ((&&)
         ((&&) ((&&) (all_of_length n0 a) (Nat.eqb (length a) n0))
           (forallb (fun z0 ->
             (&&) (forallb (fun r -> is_zero (inner r z0)) a)
               (same_vectors (of_rows z0 a) (zeros0 n0))) free))
         (is_inverse n0 inverse m)) (is_inverse n0 m inverse)
  then Some (m, inverse)
  else None

(** val wall_numbers : nat -> bool -> matrix -> vector -> vector **)

let wall_numbers n0 simplex e y =
  if simplex
  then let c =
         match kernel (length e) (transpose n0 e) with
         | [] -> []
         | c :: l ->
           (match l with
            | [] -> if all_positive c then c else opposite c
            | _ :: _ -> [])
       in
       let them =
         combine
           (app y ({ qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: [])) c
       in
       let least =
         fold_right (fun p m -> qmin (qdiv (fst p) (snd p)) m) { qnum =
           Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } them
       in
       map (fun p -> reduced (qminus (fst p) (qmult least (snd p)))) them
  else flat_map (fun q0 ->
         if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } q0
         then q0 :: ({ qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int } :: [])
         else { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int } :: ((qopp q0) :: [])) y

(** val most_in_K :
    nat -> bool -> matrix -> matrix -> vector -> vector -> q option **)

let most_in_K n0 simplex e free target y =
  let rank = if simplex then pred (length e) else length e in
  let m = wall_numbers n0 simplex e (firstn rank y) in
  let walls0 = walls_of simplex e in
  if (&&)
       ((&&)
         (forallb
           (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int }) m)
         (Nat.eqb (length m) (length walls0)))
       (same_vectors (of_rows (app m (skipn rank y)) (app walls0 free))
         target)
  then Some
         (fold_right (fun q0 s -> reduced (qplus q0 s)) { qnum =
           Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } m)
  else None

(** val k_within :
    nat -> bool -> matrix -> matrix -> vector -> matrix -> bool **)

let k_within n0 simplex e free most ds =
  let inverse = inverse_of n0 (frame simplex e free) in
  forallb (fun j ->
    let unit1 = unit_vector n0 j in
    let y = nth j inverse [] in
    let b =
      nth j most { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }
    in
    (match most_in_K n0 simplex e free unit1 y with
     | Some up0 ->
       (match most_in_K n0 simplex e free (opposite unit1) (opposite y) with
        | Some down ->
          forallb (fun d ->
            (&&)
              (qle_bool
                (qplus
                  (nth j d { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int }) up0) b)
              (qle_bool
                (qminus down
                  (nth j d { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int })) b)) ds
        | None -> false)
     | None -> false)) (seq O n0)

type degree_proof = { low_multiple : q; high_multiple : q option;
                      first_twist : vector; last_twist : vector;
                      is_a_simplex : bool; wall_rows : matrix;
                      direction_rows : matrix }

(** val one_multiple : degree_proof -> bool **)

let one_multiple g =
  match g.high_multiple with
  | Some b -> qeq_bool g.low_multiple b
  | None -> false

(** val s_and_t : degree_proof -> vector * vector **)

let s_and_t g =
  let a = g.low_multiple in
  if one_multiple g
  then (({ qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } :: [])), ({ qnum = Big_int_Z.zero_big_int;
         qden = Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
         qden = Big_int_Z.unit_big_int } :: [])))
  else (match g.high_multiple with
        | Some b ->
          (((qdiv b (qminus b a)) :: ((qopp (qinv (qminus b a))) :: [])),
            ((qdiv (qopp a) (qminus b a)) :: ((qinv (qminus b a)) :: [])))
        | None ->
          (({ qnum = Big_int_Z.unit_big_int; qden =
            Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
            qden = Big_int_Z.unit_big_int } :: [])), ({ qnum =
            (Big_int_Z.minus_big_int Big_int_Z.unit_big_int); qden =
            Big_int_Z.unit_big_int } :: ((qinv a) :: []))))

(** val relative : degree_proof -> vector -> vector **)

let relative g f =
  app
    (plus_times
      (plus_times [] (qopp (inner f g.first_twist)) (fst (s_and_t g)))
      (qopp (inner f g.last_twist)) (snd (s_and_t g))) f

(** val room : degree_proof -> vector -> vector **)

let room g f =
  plus_times
    (plus_times (fst (s_and_t g)) { qnum = Big_int_Z.unit_big_int; qden =
      Big_int_Z.unit_big_int } (snd (s_and_t g))) { qnum =
    (Big_int_Z.minus_big_int Big_int_Z.unit_big_int); qden =
    Big_int_Z.unit_big_int } (relative g f)

(** val to_form : vector -> form **)

let to_form a =
  map (to_integer (scaling_of a)) a

(** val base_conditions : degree_proof -> (form * bool) list **)

let base_conditions g =
  ((to_form (fst (s_and_t g))), false) :: (((to_form (snd (s_and_t g))),
    false) :: (if one_multiple g
               then ((to_form ((qopp g.low_multiple) :: ({ qnum =
                       Big_int_Z.unit_big_int; qden =
                       Big_int_Z.unit_big_int } :: []))), true) :: []
               else []))

(** val walls : degree_proof -> matrix **)

let walls g =
  walls_of g.is_a_simplex g.wall_rows

(** val in_K_conditions : degree_proof -> (form * bool) list **)

let in_K_conditions g =
  map (fun f -> ((to_form (room g f)), false)) (walls g)

(** val strict_form : degree_proof -> form **)

let strict_form g =
  to_form
    (plus_times (fst (s_and_t g)) { qnum = Big_int_Z.unit_big_int; qden =
      Big_int_Z.unit_big_int } (snd (s_and_t g)))

(** val middle_setting : degree_proof -> setting -> setting **)

let middle_setting g s =
  make_setting s.dimension_of
    (map_all (fun r -> make_row (middle_box r.box)) s.rows)
    (middle_load s.the_load) { a_multiple =
    (map (relative g) g.direction_rows); known_push = [] } None

(** val middle_conditions : degree_proof -> (form * bool) list **)

let middle_conditions g =
  if one_multiple g
  then []
  else ((to_form
          (plus_times (fst (s_and_t g)) { qnum = (Big_int_Z.minus_big_int
            Big_int_Z.unit_big_int); qden = Big_int_Z.unit_big_int }
            (snd (s_and_t g)))), true) :: []

(** val point_box : cbox -> bool **)

let point_box b =
  (&&)
    ((&&)
      ((&&) ((&&) (forallb certain b.box_geometry) (certain b.box_friction))
        (certain b.box_preload)) (certain b.box_growth))
    (certain b.box_stiffness)

(** val is_point : setting -> bool **)

let is_point s =
  (&&) (forallb (fun r -> point_box r.box) s.rows) (one_load s.the_load)

(** val row_free : vector -> cbox -> bool **)

let row_free z0 b =
  forallb (fun fs ->
    (&&) (is_zero (inner (n_of fs) z0))
      ((||)
        (qle_bool b.box_friction.high { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int })
        (forallb (fun f -> is_zero (inner f z0)) (tl fs))))
    (tips (geometry_tree b))

(** val load_free : vector -> load -> bool **)

let load_free z0 ld =
  (&&) ((&&) (is_zero (work_of ld z0).low) (is_zero (work_of ld z0).high))
    (is_zero (inner ld.load_growth z0))

(** val all_free : matrix -> setting -> bool **)

let all_free free s =
  (&&) (forallb (fun r -> friction_sound r.box) s.rows)
    (forallb (fun z0 ->
      (&&) (forallb (fun r -> row_free z0 r.box) s.rows)
        (load_free z0 s.the_load)) free)

(** val bound_holds : degree_proof -> matrix -> setting -> bool **)

let bound_holds g free s =
  match s.the_bound with
  | Some most ->
    (match g.high_multiple with
     | Some _ ->
       k_within s.dimension_of g.is_a_simplex g.wall_rows free most
         (g.first_twist :: (g.last_twist :: []))
     | None -> false)
  | None -> true

(** val range_sound : degree_proof -> setting -> bool **)

let range_sound g s =
  let n0 = s.dimension_of in
  (&&)
    ((&&)
      ((&&) (Nat.eqb (length g.first_twist) n0)
        (Nat.eqb (length g.last_twist) n0))
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } g.low_multiple))
    (match g.high_multiple with
     | Some b -> qle_bool g.low_multiple b
     | None ->
       negb
         (qle_bool g.low_multiple { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int }))

(** val k_region :
    oracle -> degree_proof -> setting -> (form * bool) list -> setting region **)

let k_region advisor g s more =
  root advisor (add (S (S O)) s.dimension_of) { conditions =
    (app (base_conditions g) (app more (in_K_conditions g))); new_strict =
    []; new_moving = []; branch_setting = s }

(** val wall_regions :
    oracle -> degree_proof -> setting -> (form * bool) list -> setting region
    list **)

let wall_regions advisor g s more =
  let k = k_region advisor g s more in
  map (fun f ->
    child advisor k { conditions = (((to_form (room g f)), true) :: []);
      new_strict = ((strict_form g) :: []); new_moving = []; branch_setting =
      s }) (walls g)

(** val root_regions :
    oracle -> degree_proof -> setting -> setting region list **)

let root_regions advisor g s =
  app
    (if (&&) (is_point s) (one_multiple g)
     then []
     else wall_regions advisor g (without_bound s) [])
    (wall_regions advisor g (middle_setting g s) (middle_conditions g))

(** val law_holds : oracle -> degree_proof -> setting -> bool **)

let law_holds advisor g s =
  let r = k_region advisor g s [] in
  forallb (fun row0 ->
    (||) row0.box.box_spring
      (forallb (nowhere_negative r.rays) (pull_tips row0))) s.rows

(** val degree_fails :
    oracle -> bool -> Big_int_Z.big_int -> setting -> degree_proof -> node
    list -> (string * nat option) option **)

let degree_fails advisor two_sided most_depth0 s g nodes =
  let n0 = s.dimension_of in
  (match free_motions n0 g.is_a_simplex g.wall_rows with
   | Some free ->
     if negb ((&&) (range_sound g s) (all_free free s))
     then Some ("degree-free", None)
     else (match inverted n0 free g.direction_rows with
           | Some _ ->
             if negb (bound_holds g free s)
             then Some ("degree-bound", None)
             else if (&&) two_sided (negb (law_holds advisor g s))
                  then Some ("degree-law", None)
                  else (match walk advisor split (end_fails no_pieces)
                                most_depth0 nodes (root_regions advisor g s) O with
                        | Some p ->
                          let (rule, number) = p in Some (rule, (Some number))
                        | None -> None)
           | None -> Some ("degree-direction", None))
   | None -> Some ("degree-walls", None))

(** val is_open : Big_int_Z.big_int list -> nat -> bool **)

let is_open open0 number =
  existsb (Z.eqb (Z.of_nat number)) open0

(** val others : Big_int_Z.big_int list -> nat -> 'a1 list -> 'a1 list **)

let rec others open0 number = function
| [] -> []
| it :: rest ->
  if is_open open0 number
  then others open0 (S number) rest
  else it :: (others open0 (S number) rest)

(** val without_open : Big_int_Z.big_int list -> setting -> setting **)

let without_open open0 s =
  make_setting s.dimension_of (others open0 O s.rows) s.the_load s.pushes
    s.the_bound

(** val places_before :
    Big_int_Z.big_int list -> Big_int_Z.big_int -> Big_int_Z.big_int **)

let rec places_before open0 i =
  match open0 with
  | [] -> Big_int_Z.zero_big_int
  | k :: rest ->
    if Z.ltb k i
    then Z.add Big_int_Z.unit_big_int (places_before rest i)
    else Big_int_Z.zero_big_int

(** val number_of :
    Big_int_Z.big_int -> Big_int_Z.big_int list -> Big_int_Z.big_int ->
    Big_int_Z.big_int **)

let number_of count0 open0 i =
  if existsb (Z.eqb i) open0 then count0 else Z.sub i (places_before open0 i)

(** val renumbered :
    Big_int_Z.big_int -> Big_int_Z.big_int list -> node -> node **)

let renumbered count0 open0 it = match it with
| Slip i -> Slip (number_of count0 open0 i)
| Separation i -> Separation (number_of count0 open0 i)
| Cut (name, i, c) ->
  (match name with
   | PWrench -> it
   | _ -> Cut (name, (number_of count0 open0 i), c))
| Moving (y, c, brakes) ->
  Moving (y, c,
    (map (fun b -> ((number_of count0 open0 (fst b)), (snd b))) brakes))
| _ -> it

(** val numbers_of1 :
    Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int list -> bool **)

let rec numbers_of1 count0 last = function
| [] -> true
| i :: rest ->
  (&&) ((&&) (Z.ltb last i) (Z.ltb i count0)) (numbers_of1 count0 i rest)

(** val open_on :
    ray list -> Big_int_Z.big_int list -> nat -> row list -> bool **)

let rec open_on rays0 open0 number = function
| [] -> true
| it :: rest ->
  (&&)
    ((||) (negb (is_open open0 number))
      ((&&) (negb it.box.box_spring)
        (forallb (nowhere_positive rays0) (pull_tips it))))
    (open_on rays0 open0 (S number) rest)

(** val across : degree_proof -> matrix -> (form * bool) list **)

let across g free =
  map (fun z0 -> ((to_form (relative g z0)), true)) free

(** val open_holds :
    oracle -> bool -> Big_int_Z.big_int list -> setting -> degree_proof ->
    bool **)

let open_holds advisor two_sided open0 s g =
  match free_motions s.dimension_of g.is_a_simplex g.wall_rows with
  | Some free ->
    (&&)
      ((&&) (negb two_sided)
        (numbers_of1 (Z.of_nat (length s.rows)) (Big_int_Z.minus_big_int
          Big_int_Z.unit_big_int) open0))
      (open_on (k_region advisor g s (across g free)).rays open0 O s.rows)
  | None -> true

(** val degree_with_open_fails :
    oracle -> bool -> Big_int_Z.big_int -> Big_int_Z.big_int list -> setting
    -> degree_proof -> node list -> (string * nat option) option **)

let degree_with_open_fails advisor two_sided most_depth0 open0 s g nodes =
  match open0 with
  | [] -> degree_fails advisor two_sided most_depth0 s g nodes
  | _ :: _ ->
    let less = without_open open0 s in
    let count0 = Z.of_nat (length less.rows) in
    if open_holds advisor two_sided open0 s g
    then degree_fails advisor two_sided
           (Z.sub most_depth0
             (Z.mul (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
               (Z.of_nat (length open0)))) less g
           (map (renumbered count0 open0) nodes)
    else Some ("degree-open", None)

type rest_proof = { rest_forces : (Big_int_Z.big_int * vector) list;
                    rest_answers : (Big_int_Z.big_int * matrix) list;
                    rest_reach : vector }

type resting = { resting_box : cbox; force_at_rest : vector; answers : matrix }

(** val good_force : cbox -> vector -> bool **)

let good_force b f =
  (&&) ((&&) (has_friction b) (Nat.eqb (length f) (length b.box_weights)))
    ((||) b.box_signed (is_zero (inner f b.box_normal)))

(** val taken :
    'a1 -> Big_int_Z.big_int -> (Big_int_Z.big_int * 'a1) list ->
    'a1 * (Big_int_Z.big_int * 'a1) list **)

let taken none i them = match them with
| [] -> (none, [])
| p :: others0 ->
  let (j, a) = p in if Z.eqb j i then (a, others0) else (none, them)

(** val resting_contacts :
    nat -> row list -> Big_int_Z.big_int -> (Big_int_Z.big_int * vector) list
    -> (Big_int_Z.big_int * matrix) list -> resting list -> resting list
    option **)

let rec resting_contacts n0 rows0 i forces all_answers before =
  match rows0 with
  | [] ->
    (match forces with
     | [] ->
       (match all_answers with
        | [] -> Some (rev_append before [])
        | _ :: _ -> None)
     | _ :: _ -> None)
  | row0 :: rows' ->
    let b = row0.box in
    let (f, forces') = taken [] i forces in
    let (g, answers') = taken [] i all_answers in
    let fine = fun f0 -> match f0 with
                         | [] -> true
                         | _ :: _ -> good_force b f0
    in
    if (&&) (fine f)
         (match g with
          | [] -> true
          | _ :: _ -> (&&) (Nat.eqb (length g) n0) (forallb (good_force b) g))
    then resting_contacts n0 rows' (Z.add i Big_int_Z.unit_big_int) forces'
           answers' ({ resting_box = b; force_at_rest = f; answers =
           g } :: before)
    else None

(** val range_of : vector -> interval **)

let range_of = function
| [] ->
  exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
| q0 :: qs' ->
  fold_left (fun i q1 -> { low = (qmin i.low q1); high = (qmax i.high q1) })
    qs' (exactly q0)

(** val plus_interval : interval -> interval -> interval **)

let plus_interval a b =
  { low = (reduced (qplus a.low b.low)); high =
    (reduced (qplus a.high b.high)) }

(** val shifted0 : interval -> q -> interval **)

let shifted0 a c =
  { low = (reduced (qplus a.low c)); high = (reduced (qplus a.high c)) }

(** val plus_intervals : interval list -> interval list -> interval list **)

let rec plus_intervals a b =
  match a with
  | [] -> []
  | x :: a' ->
    (match b with
     | [] -> []
     | y :: b' -> (plus_interval x y) :: (plus_intervals a' b'))

(** val most_of : interval -> q **)

let most_of a =
  qmax a.high (qopp a.low)

(** val ranges : nat -> cbox -> vector list -> interval list **)

let ranges n0 b sums =
  let vs = flat_map (fun c -> map (of_rows c) (tips (geometry_tree b))) sums
  in
  map (fun k ->
    range_of
      (map (fun v ->
        nth k v { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int }) vs)) (seq O n0)

(** val pressures : cbox -> q -> q list **)

let pressures b lambda =
  (qplus b.box_preload.low (qmult lambda b.box_growth.low)) :: ((qplus
                                                                  b.box_preload.high
                                                                  (qmult
                                                                    lambda
                                                                    b.box_growth.high)) :: [])

(** val loads_at : setting -> q -> interval list **)

let loads_at s lambda =
  let n0 = s.dimension_of in
  map (fun k ->
    shifted0 (work_of s.the_load (unit_vector n0 k))
      (qmult lambda
        (nth k s.the_load.load_growth { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int }))) (seq O n0)

(** val left_over : nat -> setting -> resting list -> q -> interval list **)

let left_over n0 s them lambda =
  fold_left (fun sum0 r ->
    plus_intervals sum0
      (ranges n0 r.resting_box
        (map (fun p -> p :: r.force_at_rest) (pressures r.resting_box lambda))))
    them (loads_at s lambda)

(** val column : nat -> resting list -> nat -> interval list **)

let column n0 them l =
  fold_left (fun sum0 r ->
    match r.answers with
    | [] -> sum0
    | v :: l0 ->
      plus_intervals sum0
        (ranges n0 r.resting_box (({ qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } :: (nth l (v :: l0) [])) :: []))) them
    (repeat
      (exactly { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }) n0)

(** val reach_holds :
    nat -> interval list -> interval list list -> vector -> bool **)

let reach_holds n0 left columns0 reach =
  (&&) (Nat.eqb (length reach) n0)
    (forallb (fun k ->
      let z0 =
        nth k reach { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int }
      in
      (&&)
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } z0)
        (qle_bool
          (fold_left (fun sum0 l ->
            let d =
              nth k (nth l columns0 [])
                (exactly { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int })
            in
            reduced
              (qplus sum0
                (qmult
                  (most_of
                    (shifted0 d
                      (if Nat.eqb k l
                       then qopp { qnum = Big_int_Z.unit_big_int; qden =
                              Big_int_Z.unit_big_int }
                       else { qnum = Big_int_Z.zero_big_int; qden =
                              Big_int_Z.unit_big_int })))
                  (nth l reach { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int })))) (seq O n0)
            (most_of
              (nth k left
                (exactly { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int })))) z0)) (seq O n0))

(** val square_of0 : vector -> vector -> q **)

let rec square_of0 weights f =
  match weights with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | w :: ws ->
    (match f with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | x :: f' -> reduced (qplus (qdiv (qmult x x) w) (square_of0 ws f')))

(** val length_bound : cbox -> vector -> q **)

let length_bound b f =
  root_above (square_of0 b.box_weights f)

(** val least_pressure : cbox -> q -> q **)

let least_pressure b lambda =
  match pressures b lambda with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | p :: l ->
    (match l with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | q0 :: l0 ->
       (match l0 with
        | [] -> qmin p q0
        | _ :: _ ->
          { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val answers_bound : cbox -> matrix -> vector -> q **)

let rec answers_bound b g reach =
  match g with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | f :: g' ->
    (match reach with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | z0 :: reach' ->
       reduced
         (qplus (qmult (length_bound b f) z0) (answers_bound b g' reach')))

(** val cone_holds : vector -> q -> resting -> bool **)

let cone_holds reach lambda r =
  let b = r.resting_box in
  (match r.force_at_rest with
   | [] ->
     (match r.answers with
      | [] -> true
      | v :: l ->
        qle_bool (qplus (length_bound b []) (answers_bound b (v :: l) reach))
          (qmult (qmult b.box_friction.low (root_below b.box_square))
            (least_pressure b lambda)))
   | q0 :: l ->
     qle_bool
       (qplus (length_bound b (q0 :: l)) (answers_bound b r.answers reach))
       (qmult (qmult b.box_friction.low (root_below b.box_square))
         (least_pressure b lambda)))

(** val resting_sound : q -> resting -> bool **)

let resting_sound lambda r =
  let b = r.resting_box in
  (&&)
    ((&&)
      ((&&) (friction_sound b)
        (forallb (fun w ->
          negb
            (qle_bool w { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int })) b.box_weights))
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } b.box_square))
    ((||) b.box_spring
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } (least_pressure b lambda)))

(** val rest_fails_at :
    nat -> setting -> resting list -> interval list list -> vector -> q ->
    string option **)

let rest_fails_at n0 s them columns0 reach lambda =
  if negb (reach_holds n0 (left_over n0 s them lambda) columns0 reach)
  then Some "rest-reach"
  else if negb
            ((&&) (forallb (cone_holds reach lambda) them)
              (forallb (resting_sound lambda) them))
       then Some "rest-cone"
       else None

(** val rest_fails : setting -> q -> q -> rest_proof -> string option **)

let rest_fails s alpha0 beta p =
  let n0 = s.dimension_of in
  (match resting_contacts n0 s.rows Big_int_Z.zero_big_int p.rest_forces
           p.rest_answers [] with
   | Some them ->
     let holds =
       rest_fails_at n0 s them (map (column n0 them) (seq O n0)) p.rest_reach
     in
     (match holds alpha0 with
      | Some rule -> Some rule
      | None -> if qeq_bool alpha0 beta then None else holds beta)
   | None -> Some "rest-share")

type sticking_proof = { stuck_twist : vector;
                        stuck_friction : (Big_int_Z.big_int * vector) list;
                        stuck_presses : (Big_int_Z.big_int * vector) list;
                        stuck_answers : (Big_int_Z.big_int * matrix) list;
                        stuck_reach : vector; stuck_energy : q }

type sticker = { as_resting : resting; presses1 : vector }

(** val sticker_box : sticker -> cbox **)

let sticker_box t =
  t.as_resting.resting_box

(** val is_nothing : 'a1 list -> bool **)

let is_nothing = function
| [] -> true
| _ :: _ -> false

(** val does_rub : sticker -> bool **)

let does_rub t =
  negb
    ((&&) (is_nothing t.as_resting.force_at_rest)
      (is_nothing t.as_resting.answers))

(** val on_list : sticker -> bool **)

let on_list t =
  (||) (does_rub t) (negb (is_nothing t.presses1))

(** val with_presses :
    resting list -> Big_int_Z.big_int -> (Big_int_Z.big_int * vector) list ->
    sticker list -> sticker list option **)

let rec with_presses them i all_presses before =
  match them with
  | [] ->
    (match all_presses with
     | [] -> Some (rev_append before [])
     | _ :: _ -> None)
  | r :: them' ->
    let (h, others0) = taken [] i all_presses in
    if (||) (is_nothing h)
         (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } r.resting_box.box_stiffness.low)
    then with_presses them' (Z.add i Big_int_Z.unit_big_int) others0
           ({ as_resting = r; presses1 = h } :: before)
    else None

(** val stickers :
    nat -> row list -> sticking_proof -> sticker list option **)

let stickers n0 rows0 p =
  if (&&)
       ((&&)
         ((&&) (Nat.eqb (length p.stuck_twist) n0)
           (Nat.eqb (length p.stuck_reach) n0))
         (forallb
           (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int }) p.stuck_reach))
       (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } p.stuck_energy)
  then (match resting_contacts n0 rows0 Big_int_Z.zero_big_int
                p.stuck_friction p.stuck_answers [] with
        | Some them ->
          with_presses them Big_int_Z.zero_big_int p.stuck_presses []
        | None -> None)
  else None

(** val no_motion : vector -> bool **)

let no_motion d =
  forallb is_zero d

(** val motion_holds : bool -> bool -> vector -> sticker list -> bool **)

let motion_holds two_sided one_multiple0 d them =
  (&&)
    ((||) (no_motion d)
      ((&&) one_multiple0
        (forallb (fun t -> negb (sticker_box t).box_turns) them)))
    ((||) (negb two_sided)
      (forallb (fun t -> (||) (sticker_box t).box_spring (on_list t)) them))

(** val n_range : cbox -> vector -> interval **)

let n_range b d =
  range_of (map (fun c -> inner (n_of c) d) (tips (geometry_tree b)))

(** val minus_products : interval -> interval -> interval **)

let minus_products a b =
  range_of
    ((qopp (qmult a.low b.low)) :: ((qopp (qmult a.low b.high)) :: ((qopp
                                                                    (qmult
                                                                    a.high
                                                                    b.low)) :: (
    (qopp (qmult a.high b.high)) :: []))))

(** val pull_range : cbox -> vector -> q -> interval **)

let pull_range b d lambda =
  plus_interval (range_of (pressures b lambda))
    (if no_motion d
     then exactly { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int }
     else minus_products b.box_stiffness (n_range b d))

(** val push_range : cbox -> vector -> q -> interval **)

let push_range b d lambda =
  let v = pull_range b d lambda in
  if b.box_spring
  then v
  else { low =
         (qmax { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } v.low); high =
         (qmax { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } v.high) }

(** val slip_bound : cbox -> vector -> q **)

let slip_bound b d =
  if no_motion d
  then { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  else fold_left qmax
         (map (fun c ->
           root_above
             (sum_of_squares b.box_weights (map (fun f -> inner f d) (tl c))))
           (tips (geometry_tree b))) { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int }

(** val absolute : q -> q **)

let absolute q0 =
  most_of (exactly q0)

(** val stuck_left :
    nat -> setting -> vector -> sticker list -> q -> interval list **)

let stuck_left n0 s d them lambda =
  fold_left (fun sum0 t ->
    let a = push_range (sticker_box t) d lambda in
    plus_intervals sum0
      (ranges n0 (sticker_box t)
        ((a.low :: t.as_resting.force_at_rest) :: ((a.high :: t.as_resting.force_at_rest) :: []))))
    them (loads_at s lambda)

(** val off_most : interval list list -> nat -> nat -> q **)

let off_most columns0 k l =
  most_of
    (shifted0
      (nth k (nth l columns0 [])
        (exactly { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int }))
      (if Nat.eqb k l
       then qopp { qnum = Big_int_Z.unit_big_int; qden =
              Big_int_Z.unit_big_int }
       else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val stuck_reach_holds :
    nat -> vector -> interval list list -> interval list -> bool **)

let stuck_reach_holds n0 reach columns0 left =
  forallb (fun k ->
    qlt_bool
      (fold_left (fun sum0 l ->
        reduced
          (qplus sum0
            (qmult (off_most columns0 k l)
              (nth l reach { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int })))) (seq O n0)
        (most_of
          (nth k left
            (exactly { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int }))))
      (nth k reach { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int })) (seq O n0)

(** val more_bound : nat -> vector -> sticker -> q **)

let more_bound n0 reach t =
  fold_left (fun sum0 l ->
    reduced
      (qplus sum0
        (qmult
          (absolute
            (nth l t.presses1 { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int }))
          (nth l reach { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int })))) (seq O n0) { qnum =
    Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

(** val friction_bound : vector -> sticker -> q **)

let friction_bound reach t =
  reduced
    (qplus (length_bound (sticker_box t) t.as_resting.force_at_rest)
      (answers_bound (sticker_box t) t.as_resting.answers reach))

(** val swing_bound : q -> sticker -> q **)

let swing_bound c t =
  root_above
    (qmult
      (qmult { qnum = (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int);
        qden = Big_int_Z.unit_big_int } c) (sticker_box t).box_stiffness.high)

(** val least_rho : cbox -> q **)

let least_rho b =
  qmult b.box_friction.low (root_below b.box_square)

(** val most_rho : cbox -> q **)

let most_rho b =
  qmult b.box_friction.high (root_above b.box_square)

(** val spare_least : vector -> vector -> q -> q -> sticker -> q **)

let spare_least d reach c lambda t =
  reduced
    (qminus
      (qmult (least_rho (sticker_box t))
        (qminus (pull_range (sticker_box t) d lambda).low (swing_bound c t)))
      (friction_bound reach t))

(** val sticker_sound : q -> sticker -> bool **)

let sticker_sound lambda t =
  let b = sticker_box t in
  (&&)
    ((&&) (resting_sound lambda t.as_resting)
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } b.box_stiffness.low))
    ((||) b.box_spring
      (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } b.box_stiffness.low))

(** val press_holds : vector -> vector -> q -> q -> sticker -> bool **)

let press_holds d reach c lambda t =
  (&&)
    ((&&) (sticker_sound lambda t)
      ((||) ((||) (negb (on_list t)) (sticker_box t).box_spring)
        (qle_bool (swing_bound c t) (pull_range (sticker_box t) d lambda).low)))
    ((||) (negb (does_rub t))
      ((&&) (negb (sticker_box t).box_spring)
        (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } (spare_least d reach c lambda t))))

(** val share_at : nat -> vector -> vector -> q -> sticker -> q -> q **)

let share_at n0 d reach lambda t k =
  if qle_bool k { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int }
  then { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  else let b = sticker_box t in
       let sigma = slip_bound b d in
       let both0 =
         reduced
           (qplus (more_bound n0 reach t)
             (qmult (qmult (most_rho b) k) sigma))
       in
       reduced
         (qplus
           (qdiv (qmult both0 both0)
             (qmult { qnum = (Big_int_Z.mult_int_big_int 2
               Big_int_Z.unit_big_int); qden = Big_int_Z.unit_big_int } k))
           (qmult
             (qplus (qmult (most_rho b) (push_range b d lambda).high)
               (friction_bound reach t)) sigma))

(** val share_most : nat -> vector -> vector -> q -> sticker -> q **)

let share_most n0 d reach lambda t =
  if (&&) (is_nothing t.presses1) (no_motion d)
  then { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  else let k = (sticker_box t).box_stiffness in
       qmax { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
         (qmax (share_at n0 d reach lambda t k.low)
           (share_at n0 d reach lambda t k.high))

(** val energy_holds :
    nat -> vector -> vector -> q -> sticker list -> q -> bool **)

let energy_holds n0 d reach c them lambda =
  qlt_bool
    (fold_left (fun sum0 t ->
      reduced (qplus sum0 (share_most n0 d reach lambda t))) them { qnum =
      Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }) c

(** val far_most : vector -> vector -> q -> q -> sticker -> nat -> q **)

let far_most d reach c lambda t l =
  reduced
    (qplus
      (qmult
        (absolute
          (nth l t.presses1 { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int }))
        (root_above
          (qdiv
            (qmult { qnum = (Big_int_Z.mult_int_big_int 2
              Big_int_Z.unit_big_int); qden = Big_int_Z.unit_big_int } c)
            (sticker_box t).box_stiffness.low)))
      (if does_rub t
       then qmult
              (length_bound (sticker_box t) (nth l t.as_resting.answers []))
              (qplus (qdiv c (spare_least d reach c lambda t))
                (slip_bound (sticker_box t) d))
       else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val room0 : vector -> vector -> nat -> q **)

let room0 d most l =
  qminus
    (nth l most { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int })
    (absolute
      (nth l d { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }))

(** val stuck_bound_holds :
    nat -> vector -> vector -> q -> sticker list -> interval list list -> q
    -> q list option -> bool **)

let stuck_bound_holds n0 d reach c them columns0 lambda = function
| Some most ->
  forallb (fun l ->
    (&&)
      (qlt_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } (room0 d most l))
      (qle_bool
        (fold_left (fun sum0 k ->
          reduced
            (qplus sum0 (qmult (off_most columns0 k l) (room0 d most k))))
          (seq O n0)
          (fold_left (fun sum0 t ->
            reduced (qplus sum0 (far_most d reach c lambda t l))) them
            { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))
        (room0 d most l))) (seq O n0)
| None -> true

(** val sticking_fails_at :
    nat -> setting -> vector -> vector -> q -> sticker list -> interval list
    list -> q -> string option **)

let sticking_fails_at n0 s d reach c them columns0 lambda =
  if negb
       (stuck_reach_holds n0 reach columns0 (stuck_left n0 s d them lambda))
  then Some "sticking-reach"
  else if negb (forallb (press_holds d reach c lambda) them)
       then Some "sticking-press"
       else if negb (energy_holds n0 d reach c them lambda)
            then Some "sticking-energy"
            else if negb
                      (stuck_bound_holds n0 d reach c them columns0 lambda
                        s.the_bound)
                 then Some "sticking-bound"
                 else None

(** val stuck_column : nat -> sticker list -> nat -> interval list **)

let stuck_column n0 them l =
  fold_left (fun sum0 t ->
    if on_list t
    then plus_intervals sum0
           (ranges n0 (sticker_box t)
             (((nth l t.presses1 { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int }) :: (nth l t.as_resting.answers [])) :: []))
    else sum0) them
    (repeat
      (exactly { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }) n0)

(** val sticking_fails :
    bool -> setting -> q -> q -> sticking_proof -> string option **)

let sticking_fails two_sided s alpha0 beta p =
  let n0 = s.dimension_of in
  (match stickers n0 s.rows p with
   | Some them ->
     if negb
          (motion_holds two_sided (qeq_bool alpha0 beta) p.stuck_twist them)
     then Some "sticking-motion"
     else let holds =
            sticking_fails_at n0 s p.stuck_twist p.stuck_reach p.stuck_energy
              them (map (stuck_column n0 them) (seq O n0))
          in
          (match holds alpha0 with
           | Some rule -> Some rule
           | None -> if qeq_bool alpha0 beta then None else holds beta)
   | None -> Some "sticking-share")

(** val part_fails :
    oracle -> bool -> Big_int_Z.big_int -> q -> q -> setting -> part ->
    (string * nat option) option **)

let part_fails advisor two_sided most_depth0 alpha0 beta s = function
| PartCut (_, _, _) -> Some ("part-inside", None)
| PartProof (d0, open0, simplex, walls0, direction0, tree) ->
  degree_with_open_fails advisor two_sided most_depth0 open0 s
    { low_multiple = alpha0; high_multiple = (Some beta); first_twist = d0;
    last_twist = d0; is_a_simplex = simplex; wall_rows = walls0;
    direction_rows = direction0 } tree
| PartAtRest (forces, answers0, reach) ->
  (match rest_fails s alpha0 beta { rest_forces = forces; rest_answers =
           answers0; rest_reach = reach } with
   | Some rule -> Some (rule, None)
   | None -> None)
| PartSticking (d0, friction0, presses2, answers0, reach, energy) ->
  (match sticking_fails two_sided s alpha0 beta { stuck_twist = d0;
           stuck_friction = friction0; stuck_presses = presses2;
           stuck_answers = answers0; stuck_reach = reach; stuck_energy =
           energy } with
   | Some rule -> Some (rule, None)
   | None -> None)

(** val unloaded : setting -> bool **)

let unloaded s =
  (&&)
    ((&&) (one_load s.the_load)
      (forallb is_zero (map (fun i -> i.low) s.the_load.load_box)))
    (forallb (fun r ->
      (&&) (is_zero r.box.box_preload.low) (is_zero r.box.box_preload.high))
      s.rows)

(** val segment_by_degree_fails :
    oracle -> bool -> Big_int_Z.big_int -> setting -> q -> q option -> q list
    -> q list -> q list list -> q list list -> node list -> (string * nat
    option) option **)

let segment_by_degree_fails advisor two_sided most_depth0 s alpha0 beta d1 d2 walls0 direction0 tree =
  let alpha1 =
    match beta with
    | Some _ -> alpha0
    | None ->
      if is_zero alpha0
      then { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
      else alpha0
  in
  degree_fails advisor two_sided most_depth0 s { low_multiple = alpha1;
    high_multiple = beta; first_twist = d1; last_twist = d2; is_a_simplex =
    false; wall_rows = walls0; direction_rows = direction0 } tree

(** val parts_fail :
    oracle -> bool -> Big_int_Z.big_int -> part list ->
    (setting * Big_int_Z.big_int) list -> nat -> (string * place) option **)

let rec parts_fail advisor two_sided most_depth0 parts todo number =
  match parts with
  | [] ->
    (match todo with
     | [] -> None
     | _ :: _ -> Some ("tree-short", (AtPart (number, None))))
  | p :: parts' ->
    (match todo with
     | [] -> Some ("tree-long", (AtPart (number, None)))
     | p0 :: todo' ->
       let (s, depth0) = p0 in
       if Z.ltb most_depth0 depth0
       then Some ("node-depth", (AtPart (number, None)))
       else (match p with
             | PartCut (name, i, c) ->
               (match halves s name i c with
                | Inl p1 ->
                  let (lo, hi) = p1 in
                  parts_fail advisor two_sided most_depth0 parts' ((lo,
                    (Z.add depth0 Big_int_Z.unit_big_int)) :: ((hi,
                    (Z.add depth0 Big_int_Z.unit_big_int)) :: todo')) (S
                    number)
                | Inr rule -> Some (rule, (AtPart (number, None))))
             | _ ->
               (match part_fails advisor two_sided most_depth0 { qnum =
                        Big_int_Z.zero_big_int; qden =
                        Big_int_Z.unit_big_int } { qnum =
                        Big_int_Z.zero_big_int; qden =
                        Big_int_Z.unit_big_int } s p with
                | Some p1 ->
                  let (rule, node0) = p1 in
                  Some (rule, (AtPart (number, node0)))
                | None ->
                  parts_fail advisor two_sided most_depth0 parts' todo' (S
                    number))))

type rigid = { r_N : vector; r_slips : matrix; r_friction : q; r_square : 
               q; r_normal : vector }

type knowledge = { touches : bool option; sides0 : matrix option }

(** val slip_of : rigid -> vector -> vector **)

let slip_of x y =
  map (fun f -> inner f y) x.r_slips

(** val cross : vector -> vector -> vector **)

let cross a b =
  match a with
  | [] -> []
  | a1 :: l ->
    (match l with
     | [] -> []
     | a2 :: l0 ->
       (match l0 with
        | [] -> []
        | a3 :: l1 ->
          (match l1 with
           | [] ->
             (match b with
              | [] -> []
              | b1 :: l2 ->
                (match l2 with
                 | [] -> []
                 | b2 :: l3 ->
                   (match l3 with
                    | [] -> []
                    | b3 :: l4 ->
                      (match l4 with
                       | [] ->
                         (qminus (qmult a2 b3) (qmult a3 b2)) :: ((qminus
                                                                    (qmult a3
                                                                    b1)
                                                                    (qmult a1
                                                                    b3)) :: (
                           (qminus (qmult a1 b2) (qmult a2 b1)) :: []))
                       | _ :: _ -> []))))
           | _ :: _ -> [])))

(** val root_at_least : q -> q -> q -> q -> bool **)

let root_at_least a b c d =
  if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int } a
  then (||)
         (qle_bool c { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int })
         (qle_bool (qmult (qmult c c) d) (qmult (qmult a a) b))
  else (&&)
         (negb
           (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } c))
         (qle_bool (qmult (qmult a a) b) (qmult (qmult c c) d))

(** val resists_all : rigid -> vector -> bool **)

let resists_all x y =
  root_at_least (inner x.r_N y) { qnum = Big_int_Z.unit_big_int; qden =
    Big_int_Z.unit_big_int } x.r_friction
    (qmult x.r_square (inner (slip_of x y) (slip_of x y)))

(** val resists : rigid -> vector -> vector -> bool **)

let resists x y side =
  root_at_least (inner x.r_N y) (inner side side)
    (qmult x.r_friction (inner side (slip_of x y))) x.r_square

(** val good_sides : rigid -> vector -> vector -> bool **)

let good_sides x u v =
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&) (Nat.eqb (length x.r_normal) (S (S (S O))))
              (Nat.eqb (length x.r_slips) (S (S (S O)))))
            (forallb is_zero (of_rows x.r_normal x.r_slips)))
          (is_zero (inner x.r_normal u))) (is_zero (inner x.r_normal v)))
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } (inner u v)))
    (negb
      (qle_bool (inner x.r_normal (cross u v)) { qnum =
        Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val resists_against : rigid -> vector -> matrix option -> bool **)

let resists_against x y = function
| Some m ->
  (match m with
   | [] -> resists_all x y
   | u :: l ->
     (match l with
      | [] -> resists x y u
      | v :: l0 ->
        (match l0 with
         | [] ->
           let z0 = slip_of x y in
           if (&&)
                (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int } (inner x.r_normal (cross u z0)))
                (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int } (inner x.r_normal (cross z0 v)))
           then resists_all x y
           else (&&) ((&&) (good_sides x u v) (resists x y u)) (resists x y v)
         | _ :: _ -> false)))
| None -> resists_all x y

(** val factor : vector -> vector -> q option **)

let factor u v =
  let c = qdiv (inner u v) (inner u u) in
  if (&&) (negb (is_zero c)) (same_vectors v (map (qmult c) u))
  then Some c
  else None

(** val is_positive_multiple : vector -> vector -> bool **)

let is_positive_multiple u v =
  match factor u v with
  | Some c ->
    qle_bool { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
      c
  | None -> false

(** val slip_factor : rigid -> rigid -> q option **)

let slip_factor x y =
  match x.r_slips with
  | [] ->
    if (&&) (same_matrices x.r_slips y.r_slips)
         (is_positive_multiple x.r_normal y.r_normal)
    then Some { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
    else None
  | s :: l ->
    (match l with
     | [] ->
       (match y.r_slips with
        | [] ->
          if (&&) (same_matrices x.r_slips y.r_slips)
               (is_positive_multiple x.r_normal y.r_normal)
          then Some { qnum = Big_int_Z.unit_big_int; qden =
                 Big_int_Z.unit_big_int }
          else None
        | t :: l0 ->
          (match l0 with
           | [] -> factor s t
           | _ :: _ ->
             if (&&) (same_matrices x.r_slips y.r_slips)
                  (is_positive_multiple x.r_normal y.r_normal)
             then Some { qnum = Big_int_Z.unit_big_int; qden =
                    Big_int_Z.unit_big_int }
             else None))
     | _ :: _ ->
       if (&&) (same_matrices x.r_slips y.r_slips)
            (is_positive_multiple x.r_normal y.r_normal)
       then Some { qnum = Big_int_Z.unit_big_int; qden =
              Big_int_Z.unit_big_int }
       else None)

(** val turned : q -> matrix -> matrix **)

let turned c ss =
  if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
       Big_int_Z.unit_big_int } c
  then ss
  else map opposite ss

type cell = (rigid * knowledge) list

(** val with_touch :
    rigid -> bool -> (rigid * knowledge) -> rigid * knowledge **)

let with_touch x it p =
  if is_positive_multiple x.r_N (fst p).r_N
  then ((fst p), { touches = (Some it); sides0 = (snd p).sides0 })
  else p

(** val with_sides :
    rigid -> matrix -> (rigid * knowledge) -> rigid * knowledge **)

let with_sides x ss p =
  match slip_factor x (fst p) with
  | Some c ->
    ((fst p), { touches = (snd p).touches; sides0 = (Some (turned c ss)) })
  | None -> p

(** val slip_children :
    rigid -> matrix option -> vector -> (matrix list, string) sum **)

let slip_children x known d =
  match x.r_slips with
  | [] ->
    let n0 = x.r_normal in
    if (||) ((||) (forallb is_zero d) (negb (is_zero (inner n0 d))))
         (negb (good_sides x d (cross n0 d)))
    then Inr "class-slip"
    else (match known with
          | Some m ->
            (match m with
             | [] ->
               let e = cross n0 d in
               Inl
               ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
               (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: [])))))
             | u :: l ->
               (match l with
                | [] ->
                  let e = cross n0 d in
                  Inl
                  ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
                  (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: [])))))
                | v :: l0 ->
                  (match l0 with
                   | [] ->
                     if (&&)
                          ((&&)
                            (negb
                              (qle_bool (inner n0 (cross u d)) { qnum =
                                Big_int_Z.zero_big_int; qden =
                                Big_int_Z.unit_big_int }))
                            (negb
                              (qle_bool (inner n0 (cross d v)) { qnum =
                                Big_int_Z.zero_big_int; qden =
                                Big_int_Z.unit_big_int }))) (good_sides x u v)
                     then Inl ((u :: (d :: [])) :: ((d :: (v :: [])) :: []))
                     else Inr "class-slip"
                   | _ :: _ ->
                     let e = cross n0 d in
                     Inl
                     ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
                     (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: []))))))))
          | None ->
            let e = cross n0 d in
            Inl
            ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
            (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: []))))))
  | _ :: l ->
    (match l with
     | [] ->
       Inl ((({ qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } :: []) :: []) :: ([] :: ((((qopp { qnum =
                                                               Big_int_Z.unit_big_int;
                                                               qden =
                                                               Big_int_Z.unit_big_int }) :: []) :: []) :: [])))
     | _ :: _ ->
       let n0 = x.r_normal in
       if (||) ((||) (forallb is_zero d) (negb (is_zero (inner n0 d))))
            (negb (good_sides x d (cross n0 d)))
       then Inr "class-slip"
       else (match known with
             | Some m ->
               (match m with
                | [] ->
                  let e = cross n0 d in
                  Inl
                  ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
                  (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: [])))))
                | u :: l0 ->
                  (match l0 with
                   | [] ->
                     let e = cross n0 d in
                     Inl
                     ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
                     (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: [])))))
                   | v :: l1 ->
                     (match l1 with
                      | [] ->
                        if (&&)
                             ((&&)
                               (negb
                                 (qle_bool (inner n0 (cross u d)) { qnum =
                                   Big_int_Z.zero_big_int; qden =
                                   Big_int_Z.unit_big_int }))
                               (negb
                                 (qle_bool (inner n0 (cross d v)) { qnum =
                                   Big_int_Z.zero_big_int; qden =
                                   Big_int_Z.unit_big_int })))
                             (good_sides x u v)
                        then Inl
                               ((u :: (d :: [])) :: ((d :: (v :: [])) :: []))
                        else Inr "class-slip"
                      | _ :: _ ->
                        let e = cross n0 d in
                        Inl
                        ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
                        (opposite d) :: ((opposite e) :: [])) :: (((opposite
                                                                    e) :: (d :: [])) :: []))))))))
             | None ->
               let e = cross n0 d in
               Inl
               ([] :: ((d :: (e :: [])) :: ((e :: ((opposite d) :: [])) :: ((
               (opposite d) :: ((opposite e) :: [])) :: (((opposite e) :: (d :: [])) :: [])))))))

(** val ascending :
    Big_int_Z.big_int -> Big_int_Z.big_int -> (Big_int_Z.big_int * 'a1) list
    -> bool **)

let rec ascending count0 last = function
| [] -> true
| p :: rest ->
  let (i, _) = p in
  (&&) ((&&) (Z.ltb last i) (Z.ltb i count0)) (ascending count0 i rest)

(** val count_of : 'a1 list -> Big_int_Z.big_int **)

let count_of l =
  fold_left (fun n0 _ -> Z.add n0 Big_int_Z.unit_big_int) l
    Big_int_Z.zero_big_int

(** val normal_sum : cell -> (Big_int_Z.big_int * q) list -> vector **)

let normal_sum c gs =
  fold_left (fun sum0 ig ->
    match numbered c (fst ig) with
    | Some p -> let (x, _) = p in plus_times sum0 (snd ig) x.r_N
    | None -> sum0) gs []

(** val normal_right : cell -> (Big_int_Z.big_int * q) -> bool **)

let normal_right c ig =
  match numbered c (fst ig) with
  | Some p ->
    let (_, k) = p in
    let { touches = touches0; sides0 = _ } = k in
    (match touches0 with
     | Some b ->
       if b
       then true
       else qle_bool { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } (snd ig)
     | None ->
       qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } (snd ig))
  | None -> false

(** val slip_sum : cell -> (Big_int_Z.big_int * vector) list -> vector **)

let slip_sum c hs =
  fold_left (fun sum0 ih ->
    match numbered c (fst ih) with
    | Some p ->
      let (x, _) = p in
      plus_times sum0 { qnum = Big_int_Z.unit_big_int; qden =
        Big_int_Z.unit_big_int } (of_rows (snd ih) x.r_slips)
    | None -> sum0) hs []

(** val slip_right : cell -> (Big_int_Z.big_int * vector) -> bool **)

let slip_right c ih =
  match numbered c (fst ih) with
  | Some p ->
    let (x, k) = p in
    let { touches = _; sides0 = sides1 } = k in
    (match sides1 with
     | Some ss ->
       (&&)
         (match x.r_slips with
          | [] -> is_zero (inner (snd ih) x.r_normal)
          | _ :: l ->
            (match l with
             | [] -> true
             | _ :: _ -> is_zero (inner (snd ih) x.r_normal)))
         (forallb (fun s ->
           qle_bool { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } (inner (snd ih) s)) ss)
     | None -> false)
  | None -> false

(** val rigid_leaf :
    matrix -> vector -> cell -> q -> vector -> (Big_int_Z.big_int * q) list
    -> (Big_int_Z.big_int * vector) list -> bool **)

let rigid_leaf mass w c t y gs hs =
  let yw = inner y w in
  (&&)
    ((&&)
      ((&&)
        ((&&)
          ((&&)
            ((&&)
              ((&&)
                ((&&)
                  (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int } t)
                  (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int } yw))
                (negb ((&&) (is_zero t) (is_zero yw))))
              (ascending (count_of c) (Big_int_Z.minus_big_int
                Big_int_Z.unit_big_int) gs))
            (ascending (count_of c) (Big_int_Z.minus_big_int
              Big_int_Z.unit_big_int) hs)) (forallb (normal_right c) gs))
        (forallb (slip_right c) hs))
      (forallb (fun p ->
        match (snd p).touches with
        | Some b ->
          if b then resists_against (fst p) y (snd p).sides0 else true
        | None -> resists_against (fst p) y (snd p).sides0) c))
    (forallb is_zero
      (plus_times
        (plus_times
          (plus_times (plus_times [] t w) { qnum = Big_int_Z.unit_big_int;
            qden = Big_int_Z.unit_big_int } (map (fun r -> inner r y) mass))
          { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
          (normal_sum c gs)) { qnum = Big_int_Z.unit_big_int; qden =
        Big_int_Z.unit_big_int } (slip_sum c hs)))

(** val rigid_split :
    matrix -> vector -> cell -> rigid_node -> (cell list, string) sum **)

let rigid_split mass w c = function
| RTouch i ->
  (match numbered c i with
   | Some p ->
     let (x, _) = p in
     Inl
     ((map_all (with_touch x true) c) :: ((map_all (with_touch x false) c) :: []))
   | None -> Inr "node-contact")
| RSlip (i, d) ->
  (match numbered c i with
   | Some p ->
     let (x, k) = p in
     (match slip_children x k.sides0 d with
      | Inl them -> Inl (map (fun ss -> map_all (with_sides x ss) c) them)
      | Inr rule -> Inr rule)
   | None -> Inr "node-contact")
| RLeaf (t, y, gs, hs) ->
  if rigid_leaf mass w c t y gs hs then Inl [] else Inr "class-leaf"

(** val rigid_walk :
    Big_int_Z.big_int -> matrix -> vector -> rigid_node list ->
    (cell * Big_int_Z.big_int) list -> nat -> (string * nat) option **)

let rec rigid_walk most_depth0 mass w nodes todo number =
  match nodes with
  | [] -> (match todo with
           | [] -> None
           | _ :: _ -> Some ("tree-short", number))
  | n0 :: nodes' ->
    (match todo with
     | [] -> Some ("tree-long", number)
     | p :: todo' ->
       let (c, depth0) = p in
       if Z.ltb most_depth0 depth0
       then Some ("node-depth", number)
       else (match rigid_split mass w c n0 with
             | Inl children ->
               rigid_walk most_depth0 mass w nodes'
                 (app
                   (map (fun c0 -> (c0,
                     (Z.add depth0 Big_int_Z.unit_big_int))) children) todo')
                 (S number)
             | Inr rule -> Some (rule, number)))

(** val is_positive : q -> bool **)

let is_positive q0 =
  negb
    (qle_bool q0 { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int })

(** val masses : q list -> matrix option **)

let masses = function
| [] -> None
| p :: l ->
  (match l with
   | [] -> None
   | q0 :: l0 ->
     (match l0 with
      | [] -> None
      | r :: l1 ->
        (match l1 with
         | [] ->
           if is_positive r
           then Some (({ qnum = Big_int_Z.unit_big_int; qden =
                  Big_int_Z.unit_big_int } :: ({ qnum =
                  Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int } :: ((qopp q0) :: []))) :: (({ qnum =
                  Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int } :: ({ qnum =
                  Big_int_Z.unit_big_int; qden =
                  Big_int_Z.unit_big_int } :: (p :: []))) :: (((qopp q0) :: (p :: (
                  (qplus (qplus (qmult p p) (qmult q0 q0)) r) :: []))) :: [])))
           else None
         | xx :: l2 ->
           (match l2 with
            | [] -> None
            | yy :: l3 ->
              (match l3 with
               | [] -> None
               | zz :: l4 ->
                 (match l4 with
                  | [] -> None
                  | xy :: l5 ->
                    (match l5 with
                     | [] -> None
                     | xz :: l6 ->
                       (match l6 with
                        | [] -> None
                        | yz :: l7 ->
                          (match l7 with
                           | [] ->
                             if (&&)
                                  ((&&) (is_positive xx)
                                    (is_positive
                                      (qminus (qmult xx yy) (qmult xy xy))))
                                  (is_positive
                                    (qplus
                                      (qminus
                                        (qminus
                                          (qmult zz
                                            (qminus (qmult xx yy)
                                              (qmult xy xy)))
                                          (qmult xx (qmult yz yz)))
                                        (qmult yy (qmult xz xz)))
                                      (qmult
                                        (qmult
                                          (qmult { qnum =
                                            (Big_int_Z.mult_int_big_int 2
                                            Big_int_Z.unit_big_int); qden =
                                            Big_int_Z.unit_big_int } xy) xz)
                                        yz)))
                             then Some (({ qnum = Big_int_Z.unit_big_int;
                                    qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: (r :: (
                                    (qopp q0) :: [])))))) :: (({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.unit_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ((qopp r) :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: (p :: [])))))) :: (({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ({ qnum =
                                    Big_int_Z.unit_big_int; qden =
                                    Big_int_Z.unit_big_int } :: (q0 :: (
                                    (qopp p) :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: [])))))) :: (({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ((qopp r) :: (q0 :: (
                                    (qplus (qplus (qmult q0 q0) (qmult r r))
                                      xx) :: ((qplus (qopp (qmult p q0)) xy) :: (
                                    (qplus (qopp (qmult p r)) xz) :: [])))))) :: ((r :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ((qopp p) :: (
                                    (qplus (qopp (qmult p q0)) xy) :: (
                                    (qplus (qplus (qmult p p) (qmult r r)) yy) :: (
                                    (qplus (qopp (qmult q0 r)) yz) :: [])))))) :: ((
                                    (qopp q0) :: (p :: ({ qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int } :: ((qplus
                                                                   (qopp
                                                                    (qmult p
                                                                    r)) xz) :: (
                                    (qplus (qopp (qmult q0 r)) yz) :: (
                                    (qplus (qplus (qmult p p) (qmult q0 q0))
                                      zz) :: [])))))) :: []))))))
                             else None
                           | _ :: _ -> None)))))))))

(** val rigid_of : row -> rigid option **)

let rigid_of row0 =
  let b = row0.box in
  (match b.box_forms (map (fun i -> i.low) b.box_geometry) with
   | [] -> None
   | n0 :: ss ->
     if (&&)
          ((&&)
            ((&&)
              ((&&) (forallb certain b.box_geometry) (certain b.box_friction))
              (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int } b.box_friction.low))
            (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } b.box_square))
          (same_vectors b.box_weights
            (map (fun _ -> { qnum = Big_int_Z.unit_big_int; qden =
              Big_int_Z.unit_big_int }) ss))
     then Some { r_N = n0; r_slips = ss; r_friction = b.box_friction.low;
            r_square = b.box_square; r_normal = b.box_normal }
     else None)

(** val force_right : rigid -> q -> vector -> bool **)

let force_right x n0 f =
  (&&)
    ((&&)
      ((&&)
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } n0)
        (Nat.eqb (length f) (length x.r_slips)))
      (match x.r_slips with
       | [] -> is_zero (inner f x.r_normal)
       | _ :: l ->
         (match l with
          | [] -> true
          | _ :: _ -> is_zero (inner f x.r_normal))))
    (qle_bool (inner f f)
      (qmult (qmult (qmult x.r_friction x.r_friction) x.r_square)
        (qmult n0 n0)))

type pressing0 = rigid * (q * vector)

(** val pressing_contacts :
    rigid list -> Big_int_Z.big_int -> stated_forces -> pressing0 list ->
    pressing0 list option **)

let rec pressing_contacts xs i them before =
  match xs with
  | [] -> (match them with
           | [] -> Some (rev_append before [])
           | _ :: _ -> None)
  | x :: xs' ->
    (match them with
     | [] ->
       pressing_contacts xs' (Z.add i Big_int_Z.unit_big_int) [] ((x,
         ({ qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int },
         [])) :: before)
     | p :: rest ->
       let (j, p0) = p in
       let (n0, f) = p0 in
       if Z.eqb i j
       then if force_right x n0 f
            then pressing_contacts xs' (Z.add i Big_int_Z.unit_big_int) rest
                   ((x, (n0, f)) :: before)
            else None
       else pressing_contacts xs' (Z.add i Big_int_Z.unit_big_int) them ((x,
              ({ qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int }, [])) :: before))

(** val force_total : vector -> pressing0 list -> vector **)

let force_total w ps =
  fold_left (fun sum0 p ->
    let (x, y) = p in
    let (n0, f) = y in
    plus_times (plus_times sum0 n0 x.r_N) { qnum = Big_int_Z.unit_big_int;
      qden = Big_int_Z.unit_big_int } (of_rows f x.r_slips)) ps w

(** val balanced : matrix -> vector -> vector -> pressing0 list -> bool **)

let balanced mass w a ps =
  forallb is_zero
    (plus_times (force_total w ps)
      (qopp { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int })
      (map (fun r -> inner r a) mass))

(** val moves_right : vector -> pressing0 -> bool **)

let moves_right a = function
| (x, p0) ->
  let (n0, f) = p0 in
  let slip = slip_of x a in
  let power0 = inner f slip in
  (&&)
    ((&&)
      ((&&)
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } (inner x.r_N a))
        (is_zero (qmult n0 (inner x.r_N a))))
      (qle_bool power0 { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int }))
    (qeq_bool (qmult power0 power0)
      (qmult
        (qmult (qmult (qmult x.r_friction x.r_friction) x.r_square)
          (qmult n0 n0)) (inner slip slip)))

(** val forces_fail :
    matrix -> vector -> vector -> rigid list -> stated_forces -> (pressing0
    list, string) sum **)

let forces_fail mass w a xs them =
  match pressing_contacts xs Big_int_Z.zero_big_int them [] with
  | Some ps -> if balanced mass w a ps then Inl ps else Inr "class-balance"
  | None -> Inr "class-force"

(** val class_fails :
    Big_int_Z.big_int -> matrix -> vector -> rigid list -> class_proof ->
    (string * nat option) option **)

let class_fails most_depth0 mass w xs p =
  let still =
    map (fun _ -> { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int }) mass
  in
  (match p with
   | ByTwist y ->
     if (&&) (is_positive (inner y w)) (forallb (fun x -> resists_all x y) xs)
     then None
     else Some ("class-twist", None)
   | ByTree (rest, nodes) ->
     (match forces_fail mass w still xs rest with
      | Inl _ ->
        (match rigid_walk most_depth0 mass w nodes
                 (((map_all (fun x -> (x, { touches = None; sides0 = None }))
                     xs), Big_int_Z.zero_big_int) :: []) O with
         | Some p0 -> let (rule, number) = p0 in Some (rule, (Some number))
         | None -> None)
      | Inr rule -> Some (rule, None))
   | ByMotion (rest, a, forces) ->
     (match forces_fail mass w still xs rest with
      | Inl _ ->
        (match forces_fail mass w a xs forces with
         | Inl ps ->
           if (&&)
                ((&&) (negb (forallb is_zero a))
                  (Nat.eqb (length a) (length mass)))
                (forallb (moves_right a) ps)
           then None
           else Some ("class-motion", None)
         | Inr rule -> Some (rule, None))
      | Inr rule -> Some (rule, None)))

(** val cross_product : form -> form -> form **)

let cross_product a b =
  match a with
  | [] -> []
  | x :: l ->
    (match l with
     | [] -> []
     | y :: l0 ->
       (match l0 with
        | [] -> []
        | z0 :: l1 ->
          (match l1 with
           | [] ->
             (match b with
              | [] -> []
              | x' :: l2 ->
                (match l2 with
                 | [] -> []
                 | y' :: l3 ->
                   (match l3 with
                    | [] -> []
                    | z' :: l4 ->
                      (match l4 with
                       | [] ->
                         (Z.sub (Z.mul y z') (Z.mul z0 y')) :: ((Z.sub
                                                                  (Z.mul z0
                                                                    x')
                                                                  (Z.mul x z')) :: (
                           (Z.sub (Z.mul x y') (Z.mul y x')) :: []))
                       | _ :: _ -> []))))
           | _ :: _ -> [])))

(** val det : form -> form -> form -> Big_int_Z.big_int **)

let det a b c =
  dot a (cross_product b c)

(** val first_some : ('a1 -> 'a2 option) -> 'a1 list -> 'a2 option **)

let rec first_some f = function
| [] -> None
| a :: l' -> (match f a with
              | Some b -> Some b
              | None -> first_some f l')

(** val if_positive :
    Big_int_Z.big_int -> (nat * Big_int_Z.big_int) list ->
    (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option **)

let if_positive factor0 terms =
  if (&&) (Z.ltb Big_int_Z.zero_big_int factor0)
       (forallb (fun t -> Z.leb Big_int_Z.zero_big_int (snd t)) terms)
  then Some (factor0, terms)
  else None

(** val by_three :
    form -> (nat * form) -> (nat * form) -> (nat * form) ->
    (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option **)

let by_three q0 a b c =
  let d = det (snd a) (snd b) (snd c) in
  let s = Z.sgn d in
  if_positive (Z.mul s d) (((fst a),
    (Z.mul s (det q0 (snd b) (snd c)))) :: (((fst b),
    (Z.mul s (det (snd a) q0 (snd c)))) :: (((fst c),
    (Z.mul s (det (snd a) (snd b) q0))) :: [])))

(** val by_two :
    form -> (nat * form) -> (nat * form) ->
    (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option **)

let by_two q0 a b =
  let n0 = cross_product (snd a) (snd b) in
  if Z.eqb (dot q0 n0) Big_int_Z.zero_big_int
  then if_positive (dot n0 n0) (((fst a), (det n0 q0 (snd b))) :: (((fst b),
         (det n0 (snd a) q0)) :: []))
  else None

(** val by_one :
    form -> (nat * form) -> (Big_int_Z.big_int * (nat * Big_int_Z.big_int)
    list) option **)

let by_one q0 a =
  if all_zero (cross_product (snd a) q0)
  then if_positive (dot (snd a) (snd a)) (((fst a), (dot q0 (snd a))) :: [])
  else None

(** val or_else : 'a1 option -> (unit -> 'a1 option) -> 'a1 option **)

let or_else a b =
  match a with
  | Some _ -> a
  | None -> b ()

(** val sum_found :
    ray list -> form -> (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list)
    option **)

let sum_found rays0 q0 =
  let them =
    combine (seq O (length rays0)) (map (fun r -> r.coordinates) rays0)
  in
  let all_of = fun f -> first_some f them in
  if all_zero q0
  then Some (Big_int_Z.unit_big_int, [])
  else or_else
         (match find (fun a ->
                  match snd a with
                  | [] -> false
                  | h :: _ -> Z.ltb Big_int_Z.zero_big_int h) them with
          | Some a -> all_of (fun b -> all_of (by_three q0 a b))
          | None -> None) (fun _ ->
         or_else (all_of (fun a -> all_of (by_two q0 a))) (fun _ ->
           all_of (by_one q0)))

(** val sum_of_rays : ray list -> (nat * Big_int_Z.big_int) list -> form **)

let sum_of_rays rays0 terms =
  fold_right (fun t s ->
    match nth_error rays0 (fst t) with
    | Some r -> combine0 (snd t) r.coordinates Big_int_Z.unit_big_int s
    | None -> s) [] terms

(** val reason_holds :
    ray list -> form -> Big_int_Z.big_int -> (nat * Big_int_Z.big_int) list
    -> bool **)

let reason_holds rays0 x factor0 terms =
  (&&)
    ((&&) (Z.ltb Big_int_Z.zero_big_int factor0)
      (forallb (fun t -> Z.leb Big_int_Z.zero_big_int (snd t)) terms))
    (all_zero
      (combine0 factor0 x (Big_int_Z.minus_big_int Big_int_Z.unit_big_int)
        (sum_of_rays rays0 terms)))

(** val is_sum_of : ray list -> form -> bool **)

let is_sum_of rays0 q0 =
  match sum_found rays0 q0 with
  | Some p -> let (factor0, terms) = p in reason_holds rays0 q0 factor0 terms
  | None -> false

type homogeneous = (q * q) * q

(** val load_part : load_point -> homogeneous **)

let load_part p =
  (((if p.is_at
     then { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
     else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }),
    p.along_u), p.along_v)

(** val part_list : homogeneous -> q list **)

let part_list = function
| (p, t) -> let (h, s) = p in h :: (s :: (t :: []))

(** val ray_of_part : homogeneous -> ray **)

let ray_of_part a =
  { coordinates =
    (map (to_integer (scaling_of (part_list a))) (part_list a)); zeros = [];
    tight = Big_int_Z.zero_big_int }

(** val part_of_ray : nat -> form -> form **)

let part_of_ray n0 x =
  (nth O x Big_int_Z.zero_big_int) :: ((nth (add (S (S O)) n0) x
                                         Big_int_Z.zero_big_int) :: (
    (nth (add (S (S (S O))) n0) x Big_int_Z.zero_big_int) :: []))

(** val held_by :
    nat -> ray list list -> Big_int_Z.big_int -> ray list -> string option **)

let held_by n0 pieces k rays0 =
  match numbered pieces k with
  | Some piece ->
    if forallb (fun r -> is_sum_of piece (part_of_ray n0 r.coordinates)) rays0
    then None
    else Some "held-inside"
  | None -> Some "held-piece"

(** val does_not_grow : cbox -> bool **)

let does_not_grow b =
  (&&) (is_zero b.box_growth.low) (is_zero b.box_growth.high)

(** val load_in_plane : vector -> vector -> q -> q -> vector **)

let load_in_plane u v s t =
  plus_times (plus_times [] s u) t v

(** val point_of_plane : load_point -> q list **)

let point_of_plane p =
  (if p.is_at
   then { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
   else { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }) :: ({ qnum =
    Big_int_Z.unit_big_int; qden =
    Big_int_Z.unit_big_int } :: p.load_witness.twist)

(** val check_load_point :
    bool -> nat -> row list -> interval list -> vector -> vector ->
    load_point -> (state list, string) sum **)

let check_load_point two_sided n0 rows0 w u v p =
  let x = point_of_plane p in
  check_point two_sided n0 rows0 { load_box = w; load_growth =
    (load_in_plane u v p.along_u p.along_v); load_added = nothing_added }
    (map (to_integer (scaling_of x)) x) p.load_witness.shares

(** val point_states :
    bool -> nat -> row list -> interval list -> vector -> vector ->
    load_point list -> nat -> (state list list, string * nat) sum **)

let rec point_states two_sided n0 rows0 w u v points number =
  match points with
  | [] -> Inl []
  | p :: points' ->
    (match check_load_point two_sided n0 rows0 w u v p with
     | Inl ss ->
       (match point_states two_sided n0 rows0 w u v points' (S number) with
        | Inl others0 -> Inl ((rev_append ss []) :: others0)
        | Inr failure -> Inr failure)
     | Inr rule -> Inr (rule, number))

(** val share_one_mode : row list -> state list list -> bool **)

let rec share_one_mode rows0 states0 =
  match rows0 with
  | [] -> true
  | _ :: rows' ->
    (&&)
      (contact_mode
        (flat_map (fun ss -> match ss with
                             | [] -> []
                             | s :: _ -> s :: []) states0))
      (share_one_mode rows' (map tl states0))

(** val pieces_fail :
    bool -> nat -> row list -> interval list -> vector -> vector ->
    load_point list list -> nat -> (string * place) option **)

let rec pieces_fail two_sided n0 rows0 w u v pieces number =
  match pieces with
  | [] -> None
  | points :: pieces' ->
    (match point_states two_sided n0 rows0 w u v points O with
     | Inl states0 ->
       if share_one_mode rows0 states0
       then pieces_fail two_sided n0 rows0 w u v pieces' (S number)
       else Some ("piece-mode", (AtPiece (number, None)))
     | Inr p -> let (rule, k) = p in Some (rule, (AtPiece (number, (Some k)))))

(** val plane_node : nat -> node -> node **)

let plane_node n0 a = match a with
| Plane q0 ->
  Plane
    (app (firstn n0 q0)
      (app (skipn (S n0) q0)
        ((nth n0 q0 { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int }) :: [])))
| _ -> a

(** val plane_setting :
    nat -> row list -> interval list -> vector -> vector -> setting **)

let plane_setting n0 rows0 w u v =
  make_setting (add (S (S O)) n0) rows0 { load_box = w; load_growth =
    (map (fun _ -> { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int }) u); load_added = nothing_added }
    { a_multiple = []; known_push =
    (map (fun p ->
      app
        (repeat { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } (add (S (S O)) n0))
        ((fst p) :: ((snd p) :: []))) (combine u v)) } None

(** val at_zero : range **)

let at_zero =
  { range_low = { qnum = Big_int_Z.zero_big_int; qden =
    Big_int_Z.unit_big_int }; range_high = (Some { qnum =
    Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }); open_low =
    false; open_high = false }

(** val plane_fails :
    oracle -> Big_int_Z.big_int -> bool -> nat -> row list -> interval list
    -> vector -> vector -> homogeneous list list -> node list ->
    (string * nat) option **)

let plane_fails advisor most two_sided n0 rows0 w u v pieces nodes =
  walk_ranges advisor (held_by n0 (map (map ray_of_part) pieces)) most
    two_sided (plane_setting n0 rows0 w u v) (at_zero :: [])
    (map (plane_node n0) nodes)

type held = { h_point : q list; h_normal : q list; h_friction : q;
              h_torsion : q; h_of0 : nat option; h_by : nat option }

(** val at_q : q list -> nat -> q **)

let at_q d j =
  nth j d { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

(** val held_of : bool -> q -> contact -> held option **)

let held_of alone factor0 c =
  if (&&)
       ((&&)
         ((&&)
           ((&&) ((&&) (forallb certain c.position) (certain c.friction))
             (is_zero c.slope))
           (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } factor0))
         (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } c.friction.low))
       (negb (forallb is_zero c.normal))
  then Some { h_point = (map (fun i -> i.low) c.position); h_normal =
         c.normal; h_friction = (qmult factor0 c.friction.low); h_torsion =
         (if alone
          then { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int }
          else c.torsion); h_of0 = (if alone then Some O else c.of_body);
         h_by = (if alone then None else c.by_body) }
  else None

(** val square_of_normal : held -> q **)

let square_of_normal c =
  inner c.h_normal c.h_normal

(** val press_and_rub : held -> q list -> q * q **)

let press_and_rub c d =
  match c.h_point with
  | [] ->
    ((qopp { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }),
      { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
  | px :: l ->
    (match l with
     | [] ->
       ((qopp { qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int }), { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int })
     | py :: l0 ->
       (match l0 with
        | [] ->
          (match c.h_normal with
           | [] ->
             ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                Big_int_Z.unit_big_int }), { qnum = Big_int_Z.zero_big_int;
               qden = Big_int_Z.unit_big_int })
           | nx :: l1 ->
             (match l1 with
              | [] ->
                ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                   Big_int_Z.unit_big_int }), { qnum =
                  Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
              | ny :: l2 ->
                (match l2 with
                 | [] ->
                   let ux =
                     reduced (qminus (at_q d O) (qmult (at_q d (S (S O))) py))
                   in
                   let uy =
                     reduced
                       (qplus (at_q d (S O)) (qmult (at_q d (S (S O))) px))
                   in
                   let slip = reduced (qminus (qmult nx uy) (qmult ny ux)) in
                   ((reduced (qplus (qmult nx ux) (qmult ny uy))),
                   (qmult slip slip))
                 | _ :: _ ->
                   ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                      Big_int_Z.unit_big_int }), { qnum =
                     Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))))
        | pz :: l1 ->
          (match l1 with
           | [] ->
             (match c.h_normal with
              | [] ->
                ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                   Big_int_Z.unit_big_int }), { qnum =
                  Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
              | nx :: l2 ->
                (match l2 with
                 | [] ->
                   ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                      Big_int_Z.unit_big_int }), { qnum =
                     Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
                 | ny :: l3 ->
                   (match l3 with
                    | [] ->
                      ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                         Big_int_Z.unit_big_int }), { qnum =
                        Big_int_Z.zero_big_int; qden =
                        Big_int_Z.unit_big_int })
                    | nz :: l4 ->
                      (match l4 with
                       | [] ->
                         let rx = at_q d (S (S (S O))) in
                         let ry = at_q d (S (S (S (S O)))) in
                         let rz = at_q d (S (S (S (S (S O))))) in
                         let ux =
                           reduced
                             (qplus (at_q d O)
                               (qminus (qmult ry pz) (qmult rz py)))
                         in
                         let uy =
                           reduced
                             (qplus (at_q d (S O))
                               (qminus (qmult rz px) (qmult rx pz)))
                         in
                         let uz =
                           reduced
                             (qplus (at_q d (S (S O)))
                               (qminus (qmult rx py) (qmult ry px)))
                         in
                         let press0 =
                           reduced
                             (qplus (qplus (qmult nx ux) (qmult ny uy))
                               (qmult nz uz))
                         in
                         let turn =
                           qmult c.h_torsion
                             (reduced
                               (qplus (qplus (qmult nx rx) (qmult ny ry))
                                 (qmult nz rz)))
                         in
                         (press0,
                         (qplus
                           (qminus
                             (qmult (square_of_normal c)
                               (reduced
                                 (qplus (qplus (qmult ux ux) (qmult uy uy))
                                   (qmult uz uz)))) (qmult press0 press0))
                           (qmult turn turn)))
                       | _ :: _ ->
                         ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                            Big_int_Z.unit_big_int }), { qnum =
                           Big_int_Z.zero_big_int; qden =
                           Big_int_Z.unit_big_int })))))
           | _ :: _ ->
             ((qopp { qnum = Big_int_Z.unit_big_int; qden =
                Big_int_Z.unit_big_int }), { qnum = Big_int_Z.zero_big_int;
               qden = Big_int_Z.unit_big_int }))))

(** val unopposed_by : held -> q list -> bool **)

let unopposed_by c d =
  let (press0, rub) = press_and_rub c d in
  (&&)
    (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int } press0)
    (qle_bool (qmult (qmult c.h_friction c.h_friction) rub)
      (qmult press0 press0))

(** val is_loose : element -> bool **)

let is_loose e =
  (&&) e.element_spring (is_zero e.element_stiffness.low)

(** val unopposed_by_element : q list -> element -> bool **)

let unopposed_by_element y e =
  let work = inner e.lever y in
  if e.element_spring
  then (||) (is_loose e) (is_zero work)
  else qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } work

(** val relative_q : q list list -> held -> q list **)

let relative_q all c =
  match c.h_by with
  | Some n0 ->
    map reduced
      (add_multiple (of_number_q all c.h_of0)
        (qopp { qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int }) (of_number_q all (Some n0)))
  | None -> of_number_q all c.h_of0

type standing = { s_numbers : nat; s_dimension : nat;
                  s_bodies : rigid_body list; s_contacts : held list;
                  s_elements : element list; s_loads : q list list }

(** val unopposed : standing -> q list -> bool **)

let unopposed s y =
  let all = motions_q s.s_numbers y s.s_bodies [] in
  (&&)
    ((&&) (Nat.eqb (length y) s.s_dimension)
      (forallb (fun c -> unopposed_by c (relative_q all c)) s.s_contacts))
    (forallb (unopposed_by_element y) s.s_elements)

(** val is_lawful : held -> (q * q list) -> bool **)

let is_lawful c = function
| (a, f) ->
  let most = qmult (qmult c.h_friction c.h_friction) (qmult a a) in
  (&&)
    (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int } a)
    (match c.h_normal with
     | [] -> false
     | nx :: l ->
       (match l with
        | [] -> false
        | ny :: l0 ->
          (match l0 with
           | [] ->
             (match f with
              | [] -> false
              | b :: l1 ->
                (match l1 with
                 | [] -> qle_bool (qmult b b) most
                 | _ :: _ -> false))
           | nz :: l1 ->
             (match l1 with
              | [] ->
                (match f with
                 | [] -> false
                 | x :: l2 ->
                   (match l2 with
                    | [] -> false
                    | y :: l3 ->
                      (match l3 with
                       | [] -> false
                       | z0 :: moment ->
                         let square = square_of_normal c in
                         let e2 = qmult c.h_torsion c.h_torsion in
                         let size1 =
                           qplus (qplus (qmult x x) (qmult y y)) (qmult z0 z0)
                         in
                         (&&)
                           ((&&)
                             (is_zero
                               (qplus (qplus (qmult nx x) (qmult ny y))
                                 (qmult nz z0)))
                             (qle_bool size1 (qmult square most)))
                           (match moment with
                            | [] -> is_zero c.h_torsion
                            | m :: l4 ->
                              (match l4 with
                               | [] ->
                                 (&&) (negb (is_zero c.h_torsion))
                                   (qle_bool
                                     (qplus (qmult e2 size1)
                                       (qmult square (qmult m m)))
                                     (qmult e2 (qmult square most)))
                               | _ :: _ -> false)))))
              | _ :: _ -> false))))

(** val is_lawful_pull : element -> (q * q list) -> bool **)

let is_lawful_pull e = function
| (a, f) ->
  (&&) (forallb is_zero f)
    (if e.element_spring
     then negb (is_loose e)
     else qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } a)

(** val take :
    ('a1 -> (q * q list) -> bool) -> 'a1 list -> Big_int_Z.big_int ->
    stated_forces -> ('a1 * (q * q list) option) list -> ((('a1 * (q * q
    list) option) list * Big_int_Z.big_int) * stated_forces) option **)

let rec take good xs i them before =
  match xs with
  | [] -> Some (((rev_append before []), i), them)
  | x :: xs' ->
    (match them with
     | [] ->
       take good xs' (Z.add i Big_int_Z.unit_big_int) [] ((x, None) :: before)
     | p :: rest ->
       let (j, force) = p in
       if Z.eqb i j
       then if good x force
            then take good xs' (Z.add i Big_int_Z.unit_big_int) rest ((x,
                   (Some force)) :: before)
            else None
       else take good xs' (Z.add i Big_int_Z.unit_big_int) them ((x,
              None) :: before))

(** val wrench_of0 : held -> (q * q list) -> q list **)

let wrench_of0 c = function
| (a, f) ->
  (match c.h_point with
   | [] -> []
   | px :: l ->
     (match l with
      | [] -> []
      | py :: l0 ->
        (match l0 with
         | [] ->
           (match c.h_normal with
            | [] -> []
            | nx :: l1 ->
              (match l1 with
               | [] -> []
               | ny :: l2 ->
                 (match l2 with
                  | [] ->
                    let b = at_q f O in
                    let fx = reduced (qminus (qmult a nx) (qmult b ny)) in
                    let fy = reduced (qplus (qmult a ny) (qmult b nx)) in
                    fx :: (fy :: ((reduced
                                    (qminus (qmult px fy) (qmult py fx))) :: []))
                  | _ :: _ -> [])))
         | pz :: l1 ->
           (match l1 with
            | [] ->
              (match c.h_normal with
               | [] -> []
               | nx :: l2 ->
                 (match l2 with
                  | [] -> []
                  | ny :: l3 ->
                    (match l3 with
                     | [] -> []
                     | nz :: l4 ->
                       (match l4 with
                        | [] ->
                          let m = at_q f (S (S (S O))) in
                          let fx = reduced (qplus (qmult a nx) (at_q f O)) in
                          let fy = reduced (qplus (qmult a ny) (at_q f (S O)))
                          in
                          let fz =
                            reduced (qplus (qmult a nz) (at_q f (S (S O))))
                          in
                          fx :: (fy :: (fz :: ((reduced
                                                 (qplus
                                                   (qminus (qmult py fz)
                                                     (qmult pz fy))
                                                   (qmult m nx))) :: (
                          (reduced
                            (qplus (qminus (qmult pz fx) (qmult px fz))
                              (qmult m ny))) :: ((reduced
                                                   (qplus
                                                     (qminus (qmult px fy)
                                                       (qmult py fx))
                                                     (qmult m nz))) :: [])))))
                        | _ :: _ -> []))))
            | _ :: _ -> []))))

(** val add_on : nat -> q -> q list -> q list list -> q list list **)

let rec add_on number s w = function
| [] -> []
| v :: ws' ->
  (match number with
   | O -> (plus_times v s w) :: ws'
   | S number' -> v :: (add_on number' s w ws'))

(** val add_on_body :
    nat option -> q -> q list -> q list list -> q list list **)

let add_on_body b s w ws =
  match b with
  | Some number -> add_on number s w ws
  | None -> ws

(** val add_contact :
    q list list -> (held * (q * q list) option) -> q list list **)

let add_contact ws = function
| (c, o) ->
  (match o with
   | Some force ->
     let w = wrench_of0 c force in
     add_on_body c.h_by
       (qopp { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int })
       w
       (add_on_body c.h_of0 { qnum = Big_int_Z.unit_big_int; qden =
         Big_int_Z.unit_big_int } w ws)
   | None -> ws)

(** val add_element : q list -> (element * (q * q list) option) -> q list **)

let add_element total = function
| (e, o) ->
  (match o with
   | Some p0 -> let (a, _) = p0 in plus_times total a e.lever
   | None -> total)

(** val add_from : nat -> q list -> q list -> q list **)

let rec add_from first w total =
  match first with
  | O ->
    plus_times total { qnum = Big_int_Z.unit_big_int; qden =
      Big_int_Z.unit_big_int } w
  | S first' ->
    (match total with
     | [] ->
       { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } :: (add_from first' w [])
     | x :: total' -> x :: (add_from first' w total'))

(** val pull_back :
    nat -> rigid_body list -> q list list -> q list -> q list **)

let rec pull_back n0 last_first ws total =
  match last_first with
  | [] -> total
  | b :: rest ->
    let w = nth (length rest) ws [] in
    (match b with
     | Free first -> pull_back n0 rest ws (add_from first (firstn n0 w) total)
     | Link (on, eta, turns) ->
       pull_back n0 rest
         (add_on_body on { qnum = Big_int_Z.unit_big_int; qden =
           Big_int_Z.unit_big_int } w ws)
         (plus_times total (inner w eta) turns))

(** val load_of_point : q list -> q list list -> q list **)

let load_of_point x loads =
  fold_left (fun sum0 p -> plus_times sum0 (fst p) (snd p)) (combine x loads)
    []

(** val point_fails : standing -> q list -> stated_forces -> string option **)

let point_fails s x them =
  if negb
       (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } (at_q x O))
  then Some "static-point"
  else (match take is_lawful s.s_contacts Big_int_Z.zero_big_int them [] with
        | Some p ->
          let (p0, them0) = p in
          let (contacts0, i) = p0 in
          (match take is_lawful_pull s.s_elements i them0 [] with
           | Some p1 ->
             let (p2, s0) = p1 in
             let (pulls0, _) = p2 in
             (match s0 with
              | [] ->
                let total =
                  fold_left add_element pulls0 (load_of_point x s.s_loads)
                in
                let ws =
                  fold_left add_contact contacts0
                    (map (fun _ -> []) s.s_bodies)
                in
                if forallb is_zero
                     (pull_back s.s_numbers (rev_append s.s_bodies []) ws
                       total)
                then None
                else Some "static-balance"
              | _ :: _ -> Some "static-force")
           | None -> Some "static-force")
        | None -> Some "static-force")

type hull = { some : (q * q) option; goes_down : bool; goes_up : bool }

(** val more_of_hull : hull -> q list -> hull **)

let more_of_hull it = function
| [] -> it
| h :: l0 ->
  (match l0 with
   | [] -> it
   | l :: l1 ->
     (match l1 with
      | [] ->
        if is_zero h
        then { some = it.some; goes_down =
               ((||) it.goes_down
                 (negb
                   (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                     Big_int_Z.unit_big_int } l))); goes_up =
               ((||) it.goes_up
                 (negb
                   (qle_bool l { qnum = Big_int_Z.zero_big_int; qden =
                     Big_int_Z.unit_big_int }))) }
        else let at_ = reduced (qdiv l h) in
             { some = (Some
             (match it.some with
              | Some p ->
                let (a, b) = p in
                ((if qle_bool a at_ then a else at_),
                (if qle_bool at_ b then b else at_))
              | None -> (at_, at_))); goes_down = it.goes_down; goes_up =
             it.goes_up }
      | _ :: _ -> it))

(** val multiples_of : q list list -> (q option * q option) option **)

let multiples_of points =
  let it =
    fold_left more_of_hull points { some = None; goes_down = false; goes_up =
      false }
  in
  (match it.some with
   | Some p ->
     let (a, b) = p in
     Some ((if it.goes_down then None else Some a),
     (if it.goes_up then None else Some b))
   | None -> None)

(** val more_of_moves :
    ((q option * q option) * bool) -> q list -> (q option * q option) * bool **)

let more_of_moves it form0 =
  let (p, all) = it in
  let (below, above0) = p in
  (match form0 with
   | [] -> it
   | work :: l ->
     (match l with
      | [] -> it
      | growth0 :: l0 ->
        (match l0 with
         | [] ->
           if is_zero growth0
           then ((below, above0),
                  ((||) all
                    (negb
                      (qle_bool work { qnum = Big_int_Z.zero_big_int; qden =
                        Big_int_Z.unit_big_int }))))
           else let border = reduced (qdiv (qopp work) growth0) in
                if qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                     Big_int_Z.unit_big_int } growth0
                then ((below, (Some
                       (match above0 with
                        | Some a -> if qle_bool a border then a else border
                        | None -> border))), all)
                else (((Some
                       (match below with
                        | Some b -> if qle_bool border b then b else border
                        | None -> border)), above0), all)
         | _ :: _ -> it)))

(** val moves_of : q list list -> (q option * q option) * bool **)

let moves_of forms0 =
  fold_left more_of_moves forms0 ((None, None), false)

(** val standing_of : question -> q -> standing option **)

let standing_of q0 factor0 =
  let alone = match q0.several with
              | Some _ -> false
              | None -> true in
  let its =
    match q0.several with
    | Some its -> its
    | None ->
      { bodies_in_space = (Nat.eqb q0.dimension (S (S (S (S (S (S O)))))));
        bodies = ((Free O) :: []); elements = [] }
  in
  let es = its.elements in
  (match all_some (held_of alone factor0) q0.contacts with
   | Some cs ->
     (match q0.load_ball with
      | Some _ -> None
      | None ->
        if (&&) (forallb certain q0.wrench)
             (forallb (fun e ->
               (&&) (certain e.element_stiffness) (certain e.element_preload))
               es)
        then let w =
               fold_left (fun w e ->
                 if is_loose e
                 then plus_times w e.element_preload.low e.lever
                 else w) es (map (fun i -> i.low) q0.wrench)
             in
             Some { s_numbers = (numbers_of its); s_dimension = q0.dimension;
             s_bodies = its.bodies; s_contacts = cs; s_elements = es;
             s_loads =
             (w :: (match q0.load_plane with
                    | Some p -> let (u, v) = p in u :: (v :: [])
                    | None -> if q0.is_margin then q0.direction :: [] else [])) }
        else None)
   | None -> None)

(** val stands_fail :
    standing -> (q list * stated_forces) list -> nat -> (string * nat) option **)

let rec stands_fail s stand number =
  match stand with
  | [] -> None
  | p :: rest ->
    let (x, them) = p in
    (match point_fails s x them with
     | Some rule -> Some (rule, number)
     | None -> stands_fail s rest (S number))

(** val moves_fail : standing -> q list list -> nat -> nat option **)

let rec moves_fail s move number =
  match move with
  | [] -> None
  | y :: rest ->
    if unopposed s y then moves_fail s rest (S number) else Some number

(** val triple : q list -> (q * q) * q **)

let triple x =
  (((at_q x O), (at_q x (S O))), (at_q x (S (S O))))

(** val form_of : standing -> q list -> q list **)

let form_of s y =
  map_all (inner y) s.s_loads

(** val check_statics : question -> statics_proof -> answer **)

let check_statics q0 p =
  match q0.statics with
  | Some factor0 ->
    (match standing_of q0 factor0 with
     | Some s ->
       (match p with
        | ByForces them ->
          (match point_fails s ({ qnum = Big_int_Z.unit_big_int; qden =
                   Big_int_Z.unit_big_int } :: []) them with
           | Some rule -> Rejected (rule, (AtMember "forces"))
           | None -> MayStand)
        | ByMove y ->
          if (&&) (unopposed s y)
               (negb
                 (qle_bool (at_q (form_of s y) O) { qnum =
                   Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))
          then CannotStand
          else Rejected ("static-motion", (AtMember "twist"))
        | ByPoints (stand, move) ->
          (match stands_fail s stand O with
           | Some p0 ->
             let (rule, number) = p0 in Rejected (rule, (AtStand number))
           | None ->
             (match moves_fail s move O with
              | Some number -> Rejected ("static-motion", (AtMove number))
              | None ->
                let points = map_all fst stand in
                let forms0 = map_all (form_of s) move in
                (match s.s_loads with
                 | [] ->
                   NotProvedHere "a proof of something else than was asked"
                 | _ :: l0 ->
                   (match l0 with
                    | [] ->
                      NotProvedHere "a proof of something else than was asked"
                    | _ :: l2 ->
                      (match l2 with
                       | [] ->
                         StandsAmong ((multiples_of points),
                           (moves_of forms0))
                       | _ :: l4 ->
                         (match l4 with
                          | [] ->
                            StandsWithin ((map_all triple points),
                              (map_all triple forms0))
                          | _ :: _ ->
                            NotProvedHere
                              "a proof of something else than was asked")))))))
     | None -> NotProvedHere "statics that are uncertain")
  | None -> NotProvedHere "a proof of something else than was asked"

(** val enlarge_all : Big_int_Z.big_int -> contact list -> row list option **)

let enlarge_all bits0 qs =
  all_some (fun q0 ->
    match enlarge bits0 q0 with
    | Some b -> Some (make_row b)
    | None -> None) qs

(** val most_depth : 'a1 list -> Big_int_Z.big_int **)

let most_depth rows0 =
  fold_left (fun n0 _ ->
    Z.add n0 (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)) rows0
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))))

(** val rows_of : Big_int_Z.big_int -> question -> row list option **)

let rows_of bits0 q0 =
  match q0.several with
  | Some its ->
    (match mechanism_boxes bits0 q0.dimension its q0.contacts with
     | Some boxes -> Some (map_all make_row boxes)
     | None -> None)
  | None -> enlarge_all bits0 q0.contacts

(** val unit_loads : q list -> matrix option **)

let unit_loads = function
| [] -> None
| x :: l ->
  (match l with
   | [] -> None
   | y :: l0 ->
     (match l0 with
      | [] ->
        Some (({ qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
          qden = Big_int_Z.unit_big_int } :: ((qopp y) :: []))) :: (({ qnum =
          Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.unit_big_int;
          qden = Big_int_Z.unit_big_int } :: (x :: []))) :: (({ qnum =
          Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
          qden = Big_int_Z.unit_big_int } :: ({ qnum =
          Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int } :: []))) :: [])))
      | z0 :: l1 ->
        (match l1 with
         | [] ->
           Some (({ qnum = Big_int_Z.unit_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden =
             Big_int_Z.unit_big_int } :: (z0 :: ((qopp y) :: [])))))) :: (({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.unit_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ((qopp z0) :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: (x :: [])))))) :: (({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.unit_big_int; qden =
             Big_int_Z.unit_big_int } :: (y :: ((qopp x) :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: [])))))) :: (({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.unit_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: [])))))) :: (({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.unit_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: [])))))) :: (({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
             qden = Big_int_Z.unit_big_int } :: ({ qnum =
             Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.unit_big_int;
             qden = Big_int_Z.unit_big_int } :: [])))))) :: []))))))
         | _ :: _ -> None)))

(** val addition_of : ball -> addition option **)

let addition_of b =
  let forces = length b.about in
  (match unit_loads b.about with
   | Some ways ->
     if (||)
          (qle_bool b.radius { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int })
          (qle_bool b.torque_length { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int })
     then None
     else let most =
            app (repeat b.radius forces)
              (repeat (qmult b.radius b.torque_length)
                (sub (length ways) forces))
          in
          Some { ball_numbers =
          (map (fun m -> { low = (qopp m); high = m }) most); ball_ways =
          ways; ball_squares = (map (fun m -> qmult m m) most) }
   | None -> None)

(** val addition_on : q list list -> addition -> addition **)

let addition_on motions it =
  { ball_numbers = it.ball_numbers; ball_ways =
    (map (fun way0 -> map (inner way0) motions) it.ball_ways); ball_squares =
    it.ball_squares }

(** val load_of : question -> load option **)

let load_of q0 =
  match q0.load_ball with
  | Some b ->
    (match addition_of b with
     | Some it ->
       Some { load_box = q0.wrench; load_growth = q0.direction; load_added =
         (match q0.several with
          | Some its ->
            addition_on
              (map (fun ms -> of_number_q ms b.on_body)
                (unit_motions q0.dimension its)) it
          | None -> it) }
     | None -> None)
  | None ->
    Some { load_box = q0.wrench; load_growth = q0.direction; load_added =
      nothing_added }

(** val setting_of : Big_int_Z.big_int -> question -> setting option **)

let setting_of bits0 q0 =
  match rows_of bits0 q0 with
  | Some rows0 ->
    (match load_of q0 with
     | Some ld ->
       if good_bound q0.dimension q0.max_motion
       then Some (make_setting q0.dimension rows0 ld no_push q0.max_motion)
       else None
     | None -> None)
  | None -> None

(** val is_one_grasp : setting -> bool **)

let is_one_grasp s =
  (&&) (exact_rows s.rows) (one_load s.the_load)

(** val straight : setting -> bool **)

let straight s =
  forallb (fun r -> negb r.box.box_turns) s.rows

(** val refute :
    oracle -> question -> setting -> range list -> node list ->
    (string * nat) option **)

let refute advisor q0 s ranges0 nodes =
  walk_ranges advisor no_pieces (most_depth s.rows) q0.bilateral s ranges0
    nodes

(** val check_witness : question -> setting -> witness -> answer **)

let check_witness q0 s w =
  if is_one_grasp s
  then (match check_at q0.bilateral q0.dimension s.rows s.the_load
                s.the_bound { multiple = (Some { qnum =
                Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int });
                point_witness = w } with
        | Inl _ -> Stable
        | Inr rule -> Rejected (rule, Nowhere))
  else Rejected ("witness-box", Nowhere)

(** val check_tree : oracle -> question -> setting -> node list -> answer **)

let check_tree advisor q0 s nodes =
  match refute advisor q0 s (at_zero :: []) nodes with
  | Some p -> let (rule, number) = p in Rejected (rule, (AtNode number))
  | None -> Unstable

(** val check_parts : oracle -> question -> setting -> part list -> answer **)

let check_parts advisor q0 s parts =
  match parts_fail advisor q0.bilateral (most_depth s.rows) parts ((s,
          Big_int_Z.zero_big_int) :: []) O with
  | Some p -> let (rule, found_at) = p in Rejected (rule, found_at)
  | None -> Stable

(** val check_margin :
    oracle -> question -> setting -> (q * q option) list -> segment list ->
    node list -> answer **)

let check_margin advisor q0 s resisted segments nodes =
  if is_one_grasp s
  then (match order_fails (Some { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int }) true resisted O with
        | Some number -> Rejected ("resisted-order", (AtInterval number))
        | None ->
          (match segments_fail q0.bilateral q0.dimension s.rows s.the_load
                   s.the_bound
                   (segment_by_degree_fails advisor q0.bilateral
                     (most_depth s.rows) s) (unloaded s) segments resisted
                   None None O with
           | Some p -> let (rule, found_at) = p in Rejected (rule, found_at)
           | None ->
             (match refute advisor q0 s (gaps resisted) nodes with
              | Some p ->
                let (rule, number) = p in Rejected (rule, (AtNode number))
              | None -> Margin resisted)))
  else NotProvedHere "a margin of a box"

(** val is_bounded : setting -> bool **)

let is_bounded s =
  match s.the_bound with
  | Some _ -> true
  | None -> false

(** val in_order : bool -> q option -> q -> q option -> bool **)

let in_order stable before lo hi =
  match before with
  | Some b ->
    (&&) (qle_bool b lo)
      (match hi with
       | Some h -> if stable then qle_bool lo h else qlt_bool lo h
       | None -> true)
  | None -> false

(** val holding_fails :
    oracle -> question -> setting -> nat -> q -> q option -> (part, witness
    list) sum -> answer option **)

let holding_fails advisor q0 s number lo hi evidence =
  let at_ = fun l w ->
    check_at q0.bilateral q0.dimension s.rows s.the_load s.the_bound
      { multiple = (Some l); point_witness = w }
  in
  let low0 =
    match hi with
    | Some _ -> lo
    | None -> { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
  in
  let high0 =
    match hi with
    | Some h -> h
    | None -> { qnum = Big_int_Z.unit_big_int; qden = Big_int_Z.unit_big_int }
  in
  let failing = fun rule second -> Some (Rejected (rule, (AtPointOf (number,
    second))))
  in
  (match evidence with
   | Inl p ->
     (match part_fails advisor q0.bilateral (most_depth s.rows) low0 high0 s p with
      | Some p0 ->
        let (rule, node0) = p0 in
        Some (Rejected (rule, (AtProofOf (number, node0))))
      | None -> None)
   | Inr points ->
     if negb (is_one_grasp s)
     then failing "witness-box" false
     else (match points with
           | [] -> Some (NotProvedHere "no points")
           | w :: more ->
             (match at_ low0 w with
              | Inl ss ->
                (match more with
                 | [] ->
                   if qeq_bool low0 high0
                   then None
                   else Some (NotProvedHere "one point of two")
                 | w' :: _ ->
                   (match at_ high0 w' with
                    | Inl ss' ->
                      if same_mode ss ss'
                      then None
                      else Some (Rejected ("segment-mode", (AtInterval
                             number)))
                    | Inr rule -> failing rule true))
              | Inr rule -> failing rule false)))

(** val joined :
    (q * q option) list -> q -> q option -> (q * q option) list **)

let joined resisted lo hi =
  match resisted with
  | [] -> (lo, hi) :: resisted
  | p :: rest ->
    let (lo', o) = p in
    (match o with
     | Some hi' ->
       if qeq_bool hi' lo then (lo', hi) :: rest else (lo, hi) :: resisted
     | None -> (lo, hi) :: resisted)

(** val check_claims :
    oracle -> question -> setting -> claim list -> q option -> nat -> (q * q
    option) list -> ((q * q option) * bool) list -> answer **)

let rec check_claims advisor q0 s claims before number resisted refuted =
  match claims with
  | [] -> Claims ((rev_append resisted []), (rev_append refuted []))
  | c :: rest ->
    (match c with
     | ClaimStable (lo, hi, evidence) ->
       if negb (in_order true before lo hi)
       then Rejected ("interval-order", (AtInterval number))
       else if match hi with
               | Some _ -> false
               | None ->
                 negb
                   ((&&)
                     ((&&)
                       (qeq_bool lo { qnum = Big_int_Z.zero_big_int; qden =
                         Big_int_Z.unit_big_int }) (unloaded s))
                     (negb (is_bounded s)))
            then Rejected ("interval-whole", (AtInterval number))
            else (match holding_fails advisor q0 s number lo hi evidence with
                  | Some failure -> failure
                  | None ->
                    check_claims advisor q0 s rest hi (S number)
                      (joined resisted lo hi) refuted)
     | ClaimUnstable (lo, hi, nodes) ->
       if negb (in_order false before lo hi)
       then Rejected ("interval-order", (AtInterval number))
       else let with_low =
              match number with
              | O ->
                (&&)
                  (qeq_bool lo { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int }) (negb (unloaded s))
              | S _ -> false
            in
            (match refute advisor q0 s ({ range_low = lo; range_high = hi;
                     open_low = (negb with_low); open_high = true } :: [])
                     nodes with
             | Some p ->
               let (rule, node0) = p in
               Rejected (rule, (AtProofOf (number, (Some node0))))
             | None ->
               check_claims advisor q0 s rest hi (S number) resisted (((lo,
                 hi), with_low) :: refuted)))

(** val check_class : question -> setting -> class_proof -> answer **)

let check_class q0 s p =
  match masses q0.inertia with
  | Some mass ->
    (match all_some rigid_of s.rows with
     | Some xs ->
       if (&&) ((&&) (Nat.eqb (length mass) q0.dimension) (straight s))
            (one_load s.the_load)
       then (match class_fails (most_depth s.rows) mass
                     (map (fun i -> i.low) s.the_load.load_box) xs p with
             | Some p0 ->
               let (rule, o) = p0 in
               (match o with
                | Some number -> Rejected (rule, (AtNode number))
                | None -> Rejected (rule, Nowhere))
             | None -> Class (class_of p))
       else NotProvedHere "rigid contacts that are uncertain"
     | None -> NotProvedHere "rigid contacts that are uncertain")
  | None -> NotProvedHere "rigid contacts that are uncertain"

(** val check_region :
    oracle -> question -> setting -> load_point list list -> node list ->
    answer **)

let check_region advisor q0 s pieces nodes =
  match q0.load_plane with
  | Some p ->
    let (u, v) = p in
    let n0 = q0.dimension in
    let w = s.the_load.load_box in
    if (&&)
         ((&&)
           ((&&)
             ((&&)
               ((&&) ((&&) (Nat.eqb n0 (S (S (S O)))) (is_one_grasp s))
                 (negb (is_bounded s))) (Nat.eqb (length w) n0))
             (Nat.eqb (length u) n0)) (Nat.eqb (length v) n0))
         (forallb (fun r -> does_not_grow r.box) s.rows)
    then (match pieces_fail q0.bilateral n0 s.rows w u v pieces O with
          | Some p0 -> let (rule, found_at) = p0 in Rejected (rule, found_at)
          | None ->
            let parts = map (map load_part) pieces in
            (match plane_fails advisor (most_depth s.rows) q0.bilateral n0
                     s.rows w u v parts nodes with
             | Some p0 ->
               let (rule, number) = p0 in Rejected (rule, (AtNode number))
             | None -> Region parts))
    else NotProvedHere "a plane of loads of a box"
  | None -> NotProvedHere "a proof of something else than was asked"

(** val check_motions : oracle -> question -> certificate -> answer **)

let check_motions advisor q0 c =
  match setting_of c.bits q0 with
  | Some s ->
    (match c.body with
     | StableByWitness w ->
       if q0.is_margin
       then NotProvedHere "a proof of something else than was asked"
       else check_witness q0 s w
     | StableByParts parts ->
       if q0.is_margin
       then NotProvedHere "a proof of something else than was asked"
       else check_parts advisor q0 s parts
     | UnstableByTree nodes ->
       if q0.is_margin
       then NotProvedHere "a proof of something else than was asked"
       else check_tree advisor q0 s nodes
     | MarginBy (resisted, segments, nodes) ->
       if q0.is_margin
       then check_margin advisor q0 s resisted segments nodes
       else NotProvedHere "a proof of something else than was asked"
     | MarginInSpace claims ->
       if q0.is_margin
       then check_claims advisor q0 s claims (Some { qnum =
              Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }) O [] []
       else NotProvedHere "a proof of something else than was asked"
     | OfClass p ->
       (match q0.inertia with
        | [] -> NotProvedHere "a proof of something else than was asked"
        | _ :: _ -> check_class q0 s p)
     | OfStatics _ -> NotProvedHere "a proof of something else than was asked"
     | RegionBy (pieces, nodes) -> check_region advisor q0 s pieces nodes)
  | None -> NotProvedHere "numbers of the question"

(** val check : oracle -> question -> certificate -> answer **)

let check advisor q0 c =
  match c.body with
  | OfStatics p -> check_statics q0 p
  | _ -> check_motions advisor q0 c

(** val largest_exponent : Big_int_Z.big_int **)

let largest_exponent =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))))))))

(** val longest_number : Big_int_Z.big_int **)

let longest_number =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))))))))))

(** val too_large : Big_int_Z.big_int **)

let too_large =
  let square = fun x -> Z.mul x x in
  let power0 =
    Nat.iter (S (S (S (S (S (S (S (S (S (S (S (S (S (S O)))))))))))))) square
      (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
  in
  Z.sub power0
    (Z.div power0
      (Z.pow (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
        (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))))))))

(** val is_not_too_large : q -> bool **)

let is_not_too_large x =
  Z.ltb (Z.abs x.qnum) (Z.mul too_large x.qden)

(** val digit : char -> Big_int_Z.big_int option **)

let digit c =
  if (=) c '0'
  then Some Big_int_Z.zero_big_int
  else if (=) c '1'
       then Some Big_int_Z.unit_big_int
       else if (=) c '2'
            then Some (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
            else if (=) c '3'
                 then Some
                        ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                        Big_int_Z.unit_big_int)
                 else if (=) c '4'
                      then Some (Big_int_Z.mult_int_big_int 2
                             (Big_int_Z.mult_int_big_int 2
                             Big_int_Z.unit_big_int))
                      else if (=) c '5'
                           then Some
                                  ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                  (Big_int_Z.mult_int_big_int 2
                                  Big_int_Z.unit_big_int))
                           else if (=) c '6'
                                then Some (Big_int_Z.mult_int_big_int 2
                                       ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                       Big_int_Z.unit_big_int))
                                else if (=) c '7'
                                     then Some
                                            ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                            ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                            Big_int_Z.unit_big_int))
                                     else if (=) c '8'
                                          then Some
                                                 (Big_int_Z.mult_int_big_int 2
                                                 (Big_int_Z.mult_int_big_int 2
                                                 (Big_int_Z.mult_int_big_int 2
                                                 Big_int_Z.unit_big_int)))
                                          else if (=) c '9'
                                               then Some
                                                      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                                      (Big_int_Z.mult_int_big_int 2
                                                      (Big_int_Z.mult_int_big_int 2
                                                      Big_int_Z.unit_big_int)))
                                               else None

(** val digits_after :
    Big_int_Z.big_int -> Big_int_Z.big_int -> char list ->
    (Big_int_Z.big_int * Big_int_Z.big_int) * char list **)

let rec digits_after value0 count0 text = match text with
| [] -> ((value0, count0), text)
| c :: rest ->
  (match digit c with
   | Some d ->
     digits_after
       (Z.add
         (Z.mul (Big_int_Z.mult_int_big_int 2
           ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
           (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))) value0) d)
       (Z.add count0 Big_int_Z.unit_big_int) rest
   | None -> ((value0, count0), text))

(** val digits :
    char list -> (Big_int_Z.big_int * Big_int_Z.big_int) * char list **)

let digits =
  digits_after Big_int_Z.zero_big_int Big_int_Z.zero_big_int

(** val take0 : char -> char list -> bool * char list **)

let take0 c text = match text with
| [] -> (false, text)
| first :: rest -> if (=) first c then (true, rest) else (false, text)

(** val take_sign : char list -> bool * char list **)

let take_sign text =
  let (negative0, text0) = take0 '-' text in
  let (_, text1) = if negative0 then (true, text0) else take0 '+' text0 in
  (negative0, text1)

(** val is_longer_than : Big_int_Z.big_int -> 'a1 list -> bool **)

let rec is_longer_than limit = function
| [] -> false
| _ :: rest ->
  (||) (Z.leb limit Big_int_Z.zero_big_int)
    (is_longer_than (Z.sub limit Big_int_Z.unit_big_int) rest)

(** val fraction :
    bool -> Big_int_Z.big_int -> Big_int_Z.big_int -> q option **)

let fraction negative0 num den =
  (fun fO fp fn z -> let s = Big_int_Z.sign_big_int z in
  if s = 0 then fO () else if s > 0 then fp z
  else fn (Big_int_Z.minus_big_int z))
    (fun _ -> None)
    (fun p -> Some { qnum = (if negative0 then Z.opp num else num); qden =
    p })
    (fun _ -> None)
    den

(** val fraction_of_digits : bool -> char list -> q option **)

let fraction_of_digits negative0 text =
  let (p, rest) = digits text in
  let (num, count0) = p in
  let (slash, rest0) = take0 '/' rest in
  let (p0, rest1) =
    if slash
    then digits rest0
    else ((Big_int_Z.unit_big_int, Big_int_Z.unit_big_int), rest0)
  in
  let (den, den_count) = p0 in
  (match rest1 with
   | [] ->
     if (||) (Z.eqb count0 Big_int_Z.zero_big_int)
          (Z.eqb den_count Big_int_Z.zero_big_int)
     then None
     else fraction negative0 num den
   | _ :: _ -> None)

(** val parse_fraction : Big_int_Z.big_int -> string -> q option **)

let parse_fraction limit spelled =
  let text =
    (fun s ->
      Array.to_list (Array.init (String.length s) (fun i -> s.[i])))
      spelled
  in
  if is_longer_than limit text
  then None
  else let (negative0, text0) = take0 '-' text in
       fraction_of_digits negative0 text0

(** val exponent : char list -> (Big_int_Z.big_int * char list) option **)

let exponent text =
  let (small, text0) = take0 'e' text in
  let (large, text1) = if small then (true, text0) else take0 'E' text0 in
  if negb large
  then Some (Big_int_Z.zero_big_int, text1)
  else let (down, text2) = take_sign text1 in
       let (p, text3) = digits text2 in
       let (size1, count0) = p in
       if (||) (Z.eqb count0 Big_int_Z.zero_big_int)
            (Z.ltb largest_exponent size1)
       then None
       else Some ((if down then Z.opp size1 else size1), text3)

(** val parse_decimal : string -> q option **)

let parse_decimal spelled =
  let text =
    (fun s ->
      Array.to_list (Array.init (String.length s) (fun i -> s.[i])))
      spelled
  in
  if is_longer_than longest_number text
  then None
  else let (negative0, text0) = take_sign text in
       let (p, rest) = digits text0 in
       let (value0, count0) = p in
       if Z.eqb count0 Big_int_Z.zero_big_int
       then None
       else if fst (take0 '/' rest)
            then fraction_of_digits negative0 text0
            else let (point0, rest0) = take0 '.' rest in
                 let (p0, rest1) =
                   if point0
                   then digits_after value0 Big_int_Z.zero_big_int rest0
                   else ((value0, Big_int_Z.zero_big_int), rest0)
                 in
                 let (value1, decimals) = p0 in
                 if (&&) point0 (Z.eqb decimals Big_int_Z.zero_big_int)
                 then None
                 else (match exponent rest1 with
                       | Some p1 ->
                         let (power0, l) = p1 in
                         (match l with
                          | [] ->
                            let shift = Z.sub power0 decimals in
                            if Z.leb Big_int_Z.zero_big_int shift
                            then fraction negative0
                                   (Z.mul value1
                                     (Z.pow (Big_int_Z.mult_int_big_int 2
                                       ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                       (Big_int_Z.mult_int_big_int 2
                                       Big_int_Z.unit_big_int))) shift))
                                   Big_int_Z.unit_big_int
                            else fraction negative0 value1
                                   (Z.pow (Big_int_Z.mult_int_big_int 2
                                     ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                     (Big_int_Z.mult_int_big_int 2
                                     Big_int_Z.unit_big_int))) (Z.opp shift))
                          | _ :: _ -> None)
                       | None -> None)

(** val read_decimal : path -> json -> q result **)

let read_decimal at_path value0 =
  let what = "a number such as 0.25 or 1e-3, or a string as \"3/5\"" in
  let checked = fun spelled good ->
    match parse_decimal spelled with
    | Some x ->
      if good x
      then Fine x
      else refuse at_path
             "a number below 2^16384 is expected; a string spells larger ones"
    | None -> expected what at_path value0
  in
  (match value0 with
   | Number characters -> checked characters is_not_too_large
   | Text content0 -> checked content0 (fun _ -> true)
   | _ -> expected what at_path value0)

(** val longest_fraction : Big_int_Z.big_int **)

let longest_fraction =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))))))))))))

(** val longest_json_integer : Big_int_Z.big_int **)

let longest_json_integer =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    Big_int_Z.unit_big_int)))))))))))

(** val read_fraction : path -> json -> q result **)

let read_fraction at_path value0 =
  let read =
    match value0 with
    | Null -> None
    | Boolean _ -> None
    | Number characters -> parse_fraction longest_json_integer characters
    | Text content0 -> parse_fraction longest_fraction content0
    | _ -> None
  in
  (match read with
   | Some x -> Fine x
   | None ->
     expected "an integer, or a string such as \"-3/5\"" at_path value0)

(** val read_index : path -> json -> Big_int_Z.big_int result **)

let read_index at_path value0 =
  let what = "an integer of 0 or more" in
  (match value0 with
   | Number characters ->
     (match parse_fraction longest_json_integer characters with
      | Some x ->
        if Z.leb Big_int_Z.zero_big_int x.qnum
        then Fine x.qnum
        else expected what at_path value0
      | None -> expected what at_path value0)
   | _ -> expected what at_path value0)

(** val add_intervals : interval -> interval -> interval **)

let add_intervals a b =
  { low = (qplus a.low b.low); high = (qplus a.high b.high) }

type grasp = { in_space : bool; coordinates_read : nat;
               bodies_read : mechanism option; body_names : string list;
               names_of_bodies : string list;
               names_of_joints : string option list;
               all_contacts : contact list; common_wrench : interval list;
               has_loads : bool; bound_read : q list option;
               cases : (string * interval list) list }

(** val most_contacts : Big_int_Z.big_int **)

let most_contacts =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    (Big_int_Z.mult_int_big_int 2
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
    Big_int_Z.unit_big_int)))))))))))))))))))

type version = { is_second : bool; is_in_space : bool }

(** val coordinates0 : version -> Big_int_Z.big_int **)

let coordinates0 v =
  if v.is_in_space
  then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         Big_int_Z.unit_big_int)
  else (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)

(** val components : version -> Big_int_Z.big_int **)

let components v =
  if v.is_in_space
  then (Big_int_Z.mult_int_big_int 2
         ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         Big_int_Z.unit_big_int))
  else ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         Big_int_Z.unit_big_int)

(** val needs_second : string **)

let needs_second =
  "it needs \"format\": \"stickslip-grasp/2\""

(** val has_length : Big_int_Z.big_int -> 'a1 list -> bool **)

let rec has_length size1 = function
| [] -> Z.eqb size1 Big_int_Z.zero_big_int
| _ :: rest ->
  (&&) (Z.ltb Big_int_Z.zero_big_int size1)
    (has_length (Z.sub size1 Big_int_Z.unit_big_int) rest)

(** val read_sized :
    Big_int_Z.big_int -> string -> (path -> json -> 'a1 result) -> path ->
    json -> 'a1 list result **)

let read_sized size1 what read at_path value0 = match value0 with
| Array items ->
  if has_length size1 items
  then each read at_path items
  else expected what at_path value0
| _ -> expected what at_path value0

(** val read_point : version -> path -> json -> q list result **)

let read_point v =
  read_sized (coordinates0 v)
    (if v.is_in_space
     then "3 coordinates [x, y, z]"
     else "2 coordinates [x, y]") read_decimal

(** val is_0 : q -> bool **)

let is_0 x =
  Z.eqb x.qnum Big_int_Z.zero_big_int

(** val is_below : q -> q -> bool **)

let is_below x y =
  negb (qle_bool y x)

(** val sum_of_squares0 : q list -> q **)

let sum_of_squares0 v =
  fold_right (fun x sum0 -> qplus (qmult x x) sum0) { qnum =
    Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } v

(** val read_interval : version -> path -> json -> interval result **)

let read_interval v at_path value0 = match value0 with
| Object _ ->
  bind (check_that v.is_second at_path needs_second) (fun _ ->
    bind (members_of ("min" :: ("max" :: [])) at_path value0) (fun members ->
      bind (member "min" read_decimal at_path members) (fun least ->
        bind (member "max" read_decimal at_path members) (fun most ->
          bind
            (check_that (qle_bool least most) at_path "expected min <= max")
            (fun _ -> Fine { low = least; high = most })))))
| _ -> bind (read_decimal at_path value0) (fun x -> Fine (exactly x))

(** val read_wrench : version -> path -> json -> interval list result **)

let read_wrench v =
  read_sized (components v)
    (if v.is_in_space
     then "an array [force x, force y, force z, torque x, torque y, torque z]"
     else "an array [force x, force y, torque]") (read_interval v)

type properties = { own_friction : interval option;
                    own_stiffness : interval option;
                    own_preload : interval option }

(** val read_property : version -> bool -> path -> json -> interval result **)

let read_property v positive0 at_path value0 =
  bind (read_interval v at_path value0) (fun it ->
    if if positive0
       then is_below { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } it.low
       else qle_bool { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } it.low
    then Fine it
    else expected
           (if positive0 then "a number above 0" else "a number of 0 or more")
           at_path value0)

(** val read_properties :
    version -> path -> (string * json) list -> properties result **)

let read_properties v at_path members =
  bind (optional_member "friction" (read_property v false) at_path members)
    (fun mu ->
    bind (optional_member "stiffness" (read_property v true) at_path members)
      (fun k ->
      bind
        (optional_member "preload" (read_property v false) at_path members)
        (fun p -> Fine { own_friction = mu; own_stiffness = k; own_preload =
        p })))

(** val read_defaults : version -> path -> json -> properties result **)

let read_defaults v at_path value0 =
  bind
    (members_of ("friction" :: ("stiffness" :: ("preload" :: []))) at_path
      value0) (fun members -> read_properties v at_path members)

type edge = { from : q list; to0 : q list; inwards : q list }

(** val depth_of : json -> Big_int_Z.big_int **)

let rec depth_of = function
| Array items ->
  (match items with
   | [] -> Big_int_Z.unit_big_int
   | first :: _ -> Z.add Big_int_Z.unit_big_int (depth_of first))
| _ -> Big_int_Z.zero_big_int

(** val same : q list -> q list -> bool **)

let same a b =
  forallb (fun pat -> let (x, y) = pat in qeq_bool x y) (combine a b)

(** val pairs_to : 'a1 -> 'a1 list -> ('a1 * 'a1) list -> ('a1 * 'a1) list **)

let rec pairs_to last items done0 =
  match items with
  | [] -> rev_append done0 []
  | item :: rest ->
    (match rest with
     | [] -> rev_append ((item, last) :: done0) []
     | next0 :: _ -> pairs_to last rest ((item, next0) :: done0))

(** val pairs : 'a1 list -> ('a1 * 'a1) list **)

let pairs items = match items with
| [] -> []
| first :: _ -> pairs_to first items []

(** val cross0 : q list -> q list -> q **)

let cross0 a b =
  match a with
  | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  | ax :: l ->
    (match l with
     | [] -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
     | ay :: l0 ->
       (match l0 with
        | [] ->
          (match b with
           | [] ->
             { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
           | bx :: l1 ->
             (match l1 with
              | [] ->
                { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int }
              | by_0 :: l2 ->
                (match l2 with
                 | [] -> qminus (qmult ax by_0) (qmult ay bx)
                 | _ :: _ ->
                   { qnum = Big_int_Z.zero_big_int; qden =
                     Big_int_Z.unit_big_int })))
        | _ :: _ ->
          { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }))

(** val with_length_1 : q list -> q list **)

let with_length_1 n0 =
  match exact_root (sum_of_squares0 n0) with
  | Some length0 -> map (fun x -> qdiv x length0) n0
  | None -> n0

(** val make_edge : q -> (q list * q list) -> edge **)

let make_edge side ends0 =
  let n0 =
    let (l, l0) = ends0 in
    (match l with
     | [] -> []
     | ax :: l1 ->
       (match l1 with
        | [] -> []
        | ay :: l2 ->
          (match l2 with
           | [] ->
             (match l0 with
              | [] -> []
              | bx :: l3 ->
                (match l3 with
                 | [] -> []
                 | by_0 :: l4 ->
                   (match l4 with
                    | [] ->
                      (qmult side (qminus ay by_0)) :: ((qmult side
                                                          (qminus bx ax)) :: [])
                    | _ :: _ -> [])))
           | _ :: _ -> [])))
  in
  { from = (fst ends0); to0 = (snd ends0); inwards = (with_length_1 n0) }

(** val read_ring : version -> bool -> path -> json -> edge list result **)

let read_ring v hole at_path value0 =
  let what = "a ring of three vertices [x, y] or more" in
  bind (read_array what (read_point v) at_path value0) (fun ring ->
    bind
      (match ring with
       | [] -> expected what at_path value0
       | _ :: l0 ->
         (match l0 with
          | [] -> expected what at_path value0
          | _ :: l2 ->
            (match l2 with
             | [] -> expected what at_path value0
             | _ :: _ -> Fine ()))) (fun _ ->
      let sides1 = pairs ring in
      bind
        (check_that
          (negb (existsb (fun pat -> let (a, b) = pat in same a b) sides1))
          at_path "a vertex is the same as the next") (fun _ ->
        let area =
          fold_left (fun sum0 pat ->
            let (a, b) = pat in qplus sum0 (cross0 a b)) sides1 { qnum =
            Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
        in
        bind (check_that (negb (is_0 area)) at_path "the ring has no area")
          (fun _ ->
          let side =
            inject_Z
              (if hole then Z.opp (Z.sgn area.qnum) else Z.sgn area.qnum)
          in
          Fine (map (make_edge side) sides1)))))

(** val read_polygon : version -> path -> json -> edge list result **)

let read_polygon v at_path value0 =
  let what = "a list of rings, of one or more" in
  (match value0 with
   | Array items ->
     (match items with
      | [] -> expected what at_path value0
      | outer :: holes ->
        bind
          (read_ring v false ((Element Big_int_Z.zero_big_int) :: at_path)
            outer) (fun first ->
          bind
            (each_from (read_ring v true) Big_int_Z.unit_big_int at_path
              holes []) (fun others0 -> Fine (app first (concat others0)))))
   | _ -> expected what at_path value0)

(** val read_outline : version -> path -> json -> edge list list result **)

let read_outline v at_path value0 =
  bind
    (check_that (negb v.is_in_space) at_path
      "expected none, as the grasp is in space") (fun _ ->
    let what = "a list of polygons [[[[x, y], ...]]]" in
    let depth0 = depth_of value0 in
    if Z.leb depth0 Big_int_Z.unit_big_int
    then expected what at_path value0
    else read_array what (read_polygon v) at_path
           (if Z.eqb depth0 (Big_int_Z.mult_int_big_int 2
                 Big_int_Z.unit_big_int)
            then Array ((Array (value0 :: [])) :: [])
            else if Z.eqb depth0
                      ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                      Big_int_Z.unit_big_int)
                 then Array (value0 :: [])
                 else value0))

(** val read_vertex_number :
    Big_int_Z.big_int -> path -> json -> unit result **)

let read_vertex_number count0 at_path value0 =
  bind (read_decimal at_path value0) (fun index ->
    let whole = Z.div index.qnum index.qden in
    check_that
      ((&&)
        ((&&) (qeq_bool index (inject_Z whole))
          (Z.leb Big_int_Z.zero_big_int whole)) (Z.ltb whole count0)) at_path
      "there is no such vertex")

(** val read_face : Big_int_Z.big_int -> path -> json -> unit result **)

let read_face count0 at_path value0 =
  let what = "a face of three vertices or more" in
  bind (read_array what (read_vertex_number count0) at_path value0)
    (fun face ->
    match face with
    | [] -> expected what at_path value0
    | _ :: l ->
      (match l with
       | [] -> expected what at_path value0
       | _ :: l0 ->
         (match l0 with
          | [] -> expected what at_path value0
          | _ :: _ -> Fine ())))

(** val read_body : version -> path -> json -> unit result **)

let read_body v at_path value0 =
  bind
    (check_that v.is_in_space at_path
      "expected none, as the grasp is in the plane") (fun _ ->
    bind (members_of ("vertices" :: ("faces" :: [])) at_path value0)
      (fun members ->
      bind
        (member "vertices" (read_array "a list of vertices" (read_point v))
          at_path members) (fun vertices ->
        let count0 =
          fold_left (fun sum0 _ -> Z.add sum0 Big_int_Z.unit_big_int)
            vertices Big_int_Z.zero_big_int
        in
        let what = "a list of faces, of one or more" in
        bind
          (member "faces" (read_array what (read_face count0)) at_path
            members) (fun faces ->
          match faces with
          | [] -> expected what ((Member "faces") :: at_path) value0
          | _ :: _ -> Fine ()))))

(** val at_point0 : q list -> q list -> q list **)

let at_point0 p f =
  match p with
  | [] -> []
  | x :: l ->
    (match l with
     | [] -> []
     | y :: l0 ->
       (match l0 with
        | [] ->
          (match f with
           | [] -> []
           | fx :: l1 ->
             (match l1 with
              | [] -> []
              | fy :: l2 ->
                (match l2 with
                 | [] ->
                   fx :: (fy :: ((qminus (qmult x fy) (qmult y fx)) :: []))
                 | _ :: _ -> [])))
        | z0 :: l1 ->
          (match l1 with
           | [] ->
             (match f with
              | [] -> []
              | fx :: l2 ->
                (match l2 with
                 | [] -> []
                 | fy :: l3 ->
                   (match l3 with
                    | [] -> []
                    | fz :: l4 ->
                      (match l4 with
                       | [] ->
                         fx :: (fy :: (fz :: ((qminus (qmult y fz)
                                                (qmult z0 fy)) :: ((qminus
                                                                    (qmult z0
                                                                    fx)
                                                                    (qmult x
                                                                    fz)) :: (
                           (qminus (qmult x fy) (qmult y fx)) :: [])))))
                       | _ :: _ -> []))))
           | _ :: _ -> [])))

(** val read_pull :
    version -> path -> (string * json) list -> q list result **)

let read_pull v at_path members =
  bind (member "weight" read_decimal at_path members) (fun size1 ->
    bind
      (check_that
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } size1) ((Member "weight") :: at_path)
        "expected a number of 0 or more") (fun _ ->
      bind (optional_member "direction" (read_point v) at_path members)
        (fun direction0 ->
        match direction0 with
        | Some d ->
          (match exact_root (sum_of_squares0 d) with
           | Some length0 ->
             bind
               (check_that (negb (is_0 length0)) ((Member
                 "direction") :: at_path) "expected a vector other than 0")
               (fun _ -> Fine (map (fun x -> qdiv (qmult size1 x) length0) d))
           | None ->
             refuse ((Member "direction") :: at_path)
               "expected a vector of rational length, such as [3, -4]")
        | None ->
          Fine
            (if v.is_in_space
             then { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int } :: ({ qnum =
                    Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int } :: ((qopp size1) :: []))
             else { qnum = Big_int_Z.zero_big_int; qden =
                    Big_int_Z.unit_big_int } :: ((qopp size1) :: [])))))

(** val read_torque : version -> path -> json -> q list result **)

let read_torque v at_path value0 =
  if v.is_in_space
  then bind (read_point v at_path value0) (fun t -> Fine
         (app ({ qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
           qden = Big_int_Z.unit_big_int } :: ({ qnum =
           Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } :: []))) t))
  else bind (read_decimal at_path value0) (fun t -> Fine ({ qnum =
         Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } :: ({ qnum =
         Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } :: (t :: []))))

(** val read_load : version -> path -> json -> q list result **)

let read_load v at_path value0 =
  let has = fun name ->
    match value0 with
    | Object members -> has_member name members
    | _ -> false
  in
  if has "torque"
  then bind (members_of ("torque" :: []) at_path value0) (fun members ->
         member "torque" (read_torque v) at_path members)
  else bind
         (members_of
           (if has "weight"
            then "weight" :: ("at" :: ("direction" :: []))
            else "force" :: ("at" :: [])) at_path value0) (fun members ->
         bind
           (if has "weight"
            then read_pull v at_path members
            else member "force" (read_point v) at_path members) (fun force ->
           bind (member "at" (read_point v) at_path members) (fun p -> Fine
             (at_point0 p force))))

(** val no_wrench : version -> interval list **)

let no_wrench v =
  repeat
    (exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
    (if v.is_in_space then S (S (S (S (S (S O))))) else S (S (S O)))

(** val add_wrench : interval list -> interval list -> interval list **)

let add_wrench a b =
  map (fun pat -> let (x, y) = pat in add_intervals x y) (combine a b)

(** val read_loads : version -> path -> json -> interval list result **)

let read_loads v at_path value0 =
  bind (read_array "an array of loads" (read_load v) at_path value0)
    (fun loads -> Fine
    (fold_left (fun sum0 load0 -> add_wrench sum0 (map exactly load0)) loads
      (no_wrench v)))

(** val read_name : path -> json -> string result **)

let read_name at_path value0 = match value0 with
| Text name ->
  ((* If this appears, you're using String internals. Please don't *)
 (fun f0 f1 s ->
    let l = String.length s in
    if l = 0 then f0 () else f1 (String.get s 0) (String.sub s 1 (l-1)))

     (fun _ ->
     expected "a string that is not empty" at_path value0)
     (fun _ _ -> Fine name)
     name)
| _ -> expected "a string that is not empty" at_path value0

(** val read_case :
    version -> path -> json -> (string * interval list) result **)

let read_case v at_path value0 =
  bind (members_of ("name" :: ("wrench" :: ("loads" :: []))) at_path value0)
    (fun members ->
    bind (member "name" read_name at_path members) (fun name ->
      bind (optional_member "wrench" (read_wrench v) at_path members)
        (fun own ->
        bind (optional_member "loads" (read_loads v) at_path members)
          (fun loads ->
          match own with
          | Some w ->
            (match loads with
             | Some _ ->
               refuse at_path
                 "expected one of the members \"wrench\" and \"loads\""
             | None -> Fine (name, w))
          | None ->
            (match loads with
             | Some w -> Fine (name, w)
             | None ->
               refuse at_path
                 "expected one of the members \"wrench\" and \"loads\"")))))

(** val check_names : path -> string list -> unit result **)

let rec check_names at_path = function
| [] -> Fine ()
| name :: rest ->
  bind
    (check_that (negb (is_among name rest)) at_path
      ((^) "the name \"" ((^) name "\" appears twice"))) (fun _ ->
    check_names at_path rest)

(** val read_list_of_cases :
    (path -> json -> (string * interval list) result) -> path -> json ->
    (string * interval list) list result **)

let read_list_of_cases read at_path value0 =
  let what = "an array of one case or more" in
  bind (read_array what read at_path value0) (fun them ->
    bind
      (match them with
       | [] -> expected what at_path value0
       | _ :: _ -> Fine ()) (fun _ ->
      bind (check_names at_path (map fst them)) (fun _ -> Fine them)))

(** val bound_of0 : bool -> nat -> q -> q -> q list **)

let bound_of0 in_space0 count0 length0 angle =
  if in_space0
  then let size1 = S (S (S (S (S (S O))))) in
       let lengths = S (S (S O)) in
       map (fun j ->
         if Nat.ltb (Nat.modulo j size1) lengths then length0 else angle)
         (seq O count0)
  else let size1 = S (S (S O)) in
       let lengths = S (S O) in
       map (fun j ->
         if Nat.ltb (Nat.modulo j size1) lengths then length0 else angle)
         (seq O count0)

(** val read_above_0 : path -> json -> q result **)

let read_above_0 at_path value0 =
  bind (read_decimal at_path value0) (fun x ->
    bind
      (check_that
        (is_below { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } x) at_path "expected a number above 0")
      (fun _ -> Fine x))

(** val read_bound : bool -> bool -> nat -> path -> json -> q list result **)

let read_bound in_space0 joints count0 at_path value0 = match value0 with
| Object _ ->
  bind
    (check_that (negb joints) at_path
      "expected an array of a number for each coordinate, as there are joints")
    (fun _ ->
    bind (members_of ("length" :: ("angle" :: [])) at_path value0)
      (fun members ->
      bind (member "length" read_above_0 at_path members) (fun length0 ->
        bind (member "angle" read_above_0 at_path members) (fun angle -> Fine
          (bound_of0 in_space0 count0 length0 angle)))))
| _ ->
  read_sized (Z.of_nat count0)
    "an array of a number for each coordinate, or an object of length and angle"
    read_above_0 at_path value0

(** val nth_from : Big_int_Z.big_int -> 'a1 list -> 'a1 option **)

let rec nth_from index = function
| [] -> None
| item :: rest ->
  if Z.eqb index Big_int_Z.zero_big_int
  then Some item
  else nth_from (Z.sub index Big_int_Z.unit_big_int) rest

(** val choose : q -> 'a1 list -> 'a1 option **)

let choose index items =
  let whole = Z.div index.qnum index.qden in
  if (&&)
       (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
         Big_int_Z.unit_big_int } index) (qeq_bool index (inject_Z whole))
  then nth_from whole items
  else None

(** val read_on :
    edge list list -> path -> json -> (interval list * q list) result **)

let read_on outline at_path value0 =
  bind
    (match value0 with
     | Null ->
       bind
         (members_of ("polygon" :: ("edge" :: ("share" :: []))) at_path
           value0) (fun members ->
         bind (optional_member "polygon" read_decimal at_path members)
           (fun polygon ->
           bind (member "edge" read_decimal at_path members) (fun number ->
             bind (member "share" read_decimal at_path members) (fun share ->
               Fine
               (((match polygon with
                  | Some it -> it
                  | None ->
                    { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }), number), share)))))
     | Boolean _ ->
       bind
         (members_of ("polygon" :: ("edge" :: ("share" :: []))) at_path
           value0) (fun members ->
         bind (optional_member "polygon" read_decimal at_path members)
           (fun polygon ->
           bind (member "edge" read_decimal at_path members) (fun number ->
             bind (member "share" read_decimal at_path members) (fun share ->
               Fine
               (((match polygon with
                  | Some it -> it
                  | None ->
                    { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }), number), share)))))
     | Number _ ->
       bind
         (members_of ("polygon" :: ("edge" :: ("share" :: []))) at_path
           value0) (fun members ->
         bind (optional_member "polygon" read_decimal at_path members)
           (fun polygon ->
           bind (member "edge" read_decimal at_path members) (fun number ->
             bind (member "share" read_decimal at_path members) (fun share ->
               Fine
               (((match polygon with
                  | Some it -> it
                  | None ->
                    { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }), number), share)))))
     | Text _ ->
       bind
         (members_of ("polygon" :: ("edge" :: ("share" :: []))) at_path
           value0) (fun members ->
         bind (optional_member "polygon" read_decimal at_path members)
           (fun polygon ->
           bind (member "edge" read_decimal at_path members) (fun number ->
             bind (member "share" read_decimal at_path members) (fun share ->
               Fine
               (((match polygon with
                  | Some it -> it
                  | None ->
                    { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }), number), share)))))
     | Array items ->
       (match items with
        | [] -> expected "[edge, share], or an object" at_path value0
        | number :: l ->
          (match l with
           | [] -> expected "[edge, share], or an object" at_path value0
           | share :: l0 ->
             (match l0 with
              | [] ->
                bind
                  (read_decimal ((Element Big_int_Z.zero_big_int) :: at_path)
                    number) (fun number0 ->
                  bind
                    (read_decimal ((Element
                      Big_int_Z.unit_big_int) :: at_path) share)
                    (fun share0 -> Fine (({ qnum = Big_int_Z.zero_big_int;
                    qden = Big_int_Z.unit_big_int }, number0), share0)))
              | _ :: _ ->
                expected "[edge, share], or an object" at_path value0)))
     | Object _ ->
       bind
         (members_of ("polygon" :: ("edge" :: ("share" :: []))) at_path
           value0) (fun members ->
         bind (optional_member "polygon" read_decimal at_path members)
           (fun polygon ->
           bind (member "edge" read_decimal at_path members) (fun number ->
             bind (member "share" read_decimal at_path members) (fun share ->
               Fine
               (((match polygon with
                  | Some it -> it
                  | None ->
                    { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int }), number), share))))))
    (fun pat ->
    let (p, share) = pat in
    let (polygon, number) = p in
    bind
      (check_that
        ((&&)
          (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } share)
          (qle_bool share { qnum = Big_int_Z.unit_big_int; qden =
            Big_int_Z.unit_big_int })) at_path "expected a share from 0 to 1")
      (fun _ ->
      match choose polygon outline with
      | Some edges0 ->
        (match choose number edges0 with
         | Some it ->
           let p0 =
             map (fun pat0 ->
               let (a, b) = pat0 in
               exactly (qplus a (qmult share (qminus b a))))
               (combine it.from it.to0)
           in
           Fine (p0, it.inwards)
         | None -> refuse at_path "there is no such edge")
      | None -> refuse at_path "there is no such polygon"))

(** val read_normal : version -> path -> json -> (q list * q) result **)

let read_normal v at_path value0 =
  bind
    (match value0 with
     | Object _ ->
       bind (check_that v.is_second at_path needs_second) (fun _ ->
         bind (members_of ("direction" :: ("slope" :: [])) at_path value0)
           (fun members ->
           bind (member "direction" (read_point v) at_path members)
             (fun n0 ->
             bind (member "slope" read_decimal at_path members)
               (fun slope0 ->
               bind
                 (check_that
                   ((&&)
                     (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                       Big_int_Z.unit_big_int } slope0)
                     (is_below slope0 { qnum = Big_int_Z.unit_big_int; qden =
                       Big_int_Z.unit_big_int })) ((Member
                   "slope") :: at_path)
                   "expected a number of 0 or more and below 1") (fun _ ->
                 Fine (n0, slope0))))))
     | _ ->
       bind (read_point v at_path value0) (fun n0 -> Fine (n0, { qnum =
         Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })))
    (fun pat ->
    let (n0, slope0) = pat in
    bind
      (check_that (negb (forallb is_0 n0)) at_path
        "the normal is 0; give a vector into the object") (fun _ -> Fine (n0,
      slope0)))

(** val read_contact :
    version -> edge list list -> properties -> path -> json -> contact result **)

let read_contact v outline defaults at_path value0 =
  bind
    (members_of
      ("position" :: ("normal" :: ("on" :: ("friction" :: ("stiffness" :: ("preload" :: []))))))
      at_path value0) (fun members ->
    bind
      (match find_member "on" members with
       | Some on ->
         let here = (Member "on") :: at_path in
         bind (check_that v.is_second here needs_second) (fun _ ->
           bind
             (check_that (negb v.is_in_space) here
               "expected a position and a normal, as the grasp is in space")
             (fun _ ->
             bind
               (check_that
                 (negb
                   ((||) (has_member "position" members)
                     (has_member "normal" members))) here
                 "it stands in place of \"position\" and \"normal\"")
               (fun _ ->
               bind (read_on outline here on) (fun pat ->
                 let (p, n0) = pat in
                 Fine ((p, n0), { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int })))))
       | None ->
         bind
           (member "position"
             (read_sized (coordinates0 v)
               (if v.is_in_space
                then "3 coordinates [x, y, z], as the first contact has"
                else "2 coordinates [x, y], as the first contact has")
               (read_interval v)) at_path members) (fun p ->
           bind (member "normal" (read_normal v) at_path members) (fun pat ->
             let (n0, e) = pat in Fine ((p, n0), e)))) (fun pat ->
      let (p0, e) = pat in
      let (p, n0) = p0 in
      bind (read_properties v at_path members) (fun own ->
        let or0 = fun mine default ->
          match mine with
          | Some _ -> mine
          | None -> default
        in
        let or_number = fun mine number ->
          match mine with
          | Some it -> it
          | None -> exactly number
        in
        (match or0 own.own_friction defaults.own_friction with
         | Some mu ->
           Fine { position = p; normal = n0; slope = e; friction = mu;
             stiffness =
             (or_number (or0 own.own_stiffness defaults.own_stiffness)
               { qnum = Big_int_Z.unit_big_int; qden =
               Big_int_Z.unit_big_int }); preload =
             (or_number (or0 own.own_preload defaults.own_preload) { qnum =
               Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int });
             preload_growth = { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int }; of_body = None; by_body = None;
             torsion = { qnum = Big_int_Z.zero_big_int; qden =
             Big_int_Z.unit_big_int } }
         | None ->
           refuse at_path
             "the member \"friction\" is missing, and \"defaults\" has none"))))

(** val read_format : path -> json -> bool result **)

let read_format at_path value0 =
  if is_text "stickslip-grasp/2" value0
  then Fine true
  else if is_text "stickslip-grasp/1" value0
       then Fine false
       else expected
              "\"stickslip-grasp/1\", \"stickslip-grasp/2\" or \"stickslip-grasp/3\""
              at_path value0

(** val read_any_text : path -> json -> unit result **)

let read_any_text at_path value0 = match value0 with
| Text _ -> Fine ()
| _ -> expected "a string" at_path value0

(** val is_unit : string -> bool **)

let is_unit name =
  (* If this appears, you're using String internals. Please don't *)
 (fun f0 f1 s ->
    let l = String.length s in
    if l = 0 then f0 () else f1 (String.get s 0) (String.sub s 1 (l-1)))

    (fun _ -> false)
    (fun _ _ ->
    negb
      (is_longer_than (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
        (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))))
        ((fun s ->
      Array.to_list (Array.init (String.length s) (fun i -> s.[i])))
          name)))
    name

(** val read_unit : path -> json -> unit result **)

let read_unit at_path value0 = match value0 with
| Text name ->
  if is_unit name
  then Fine ()
  else expected "a string of 1 to 16 bytes" at_path value0
| _ -> expected "a string of 1 to 16 bytes" at_path value0

(** val read_units : path -> json -> unit result **)

let read_units at_path value0 =
  bind (members_of ("length" :: ("force" :: [])) at_path value0)
    (fun members ->
    bind (member "length" read_unit at_path members) (fun _ ->
      member "force" read_unit at_path members))

(** val is_array : Big_int_Z.big_int -> json option -> bool **)

let is_array size1 = function
| Some j -> (match j with
             | Array items -> has_length size1 items
             | _ -> false)
| None -> false

(** val begins_in_space : (string * json) list -> bool **)

let begins_in_space members =
  match find_member "contacts" members with
  | Some j ->
    (match j with
     | Array items ->
       (match items with
        | [] ->
          is_array (Big_int_Z.mult_int_big_int 2
            ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
            Big_int_Z.unit_big_int)) (find_member "wrench" members)
        | j0 :: _ ->
          (match j0 with
           | Object first ->
             is_array
               ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
               Big_int_Z.unit_big_int) (find_member "position" first)
           | _ -> false))
     | _ -> false)
  | None -> false

(** val version_of : (string * json) list -> version result **)

let version_of members =
  bind (member "format" read_format [] members) (fun second ->
    let only_second = fun name ->
      check_that ((||) second (negb (has_member name members))) ((Member
        name) :: []) needs_second
    in
    bind (only_second "units") (fun _ ->
      bind (only_second "outline") (fun _ ->
        bind (only_second "body") (fun _ ->
          bind (only_second "loads") (fun _ ->
            bind (only_second "cases") (fun _ ->
              bind (only_second "max_motion") (fun _ -> Fine { is_second =
                second; is_in_space =
                ((&&) second (begins_in_space members)) })))))))

(** val read_grasp : json -> grasp result **)

let read_grasp value0 =
  bind
    (members_of
      ("format" :: ("name" :: ("units" :: ("outline" :: ("body" :: ("defaults" :: ("contacts" :: ("wrench" :: ("loads" :: ("cases" :: ("max_motion" :: [])))))))))))
      [] value0) (fun members ->
    bind (version_of members) (fun v ->
      bind (optional_member "name" read_any_text [] members) (fun _ ->
        bind (optional_member "units" read_units [] members) (fun _ ->
          bind (optional_member "outline" (read_outline v) [] members)
            (fun outline ->
            bind (optional_member "body" (read_body v) [] members) (fun _ ->
              bind (optional_member "defaults" (read_defaults v) [] members)
                (fun defaults ->
                let outline0 = match outline with
                               | Some it -> it
                               | None -> []
                in
                let defaults0 =
                  match defaults with
                  | Some it -> it
                  | None ->
                    { own_friction = None; own_stiffness = None;
                      own_preload = None }
                in
                let read_contacts = fun at_path value1 ->
                  match value1 with
                  | Array items ->
                    bind
                      (check_that (negb (is_longer_than most_contacts items))
                        at_path "too many contacts") (fun _ ->
                      each (read_contact v outline0 defaults0) at_path items)
                  | _ -> expected "an array of contacts" at_path value1
                in
                bind (member "contacts" read_contacts [] members)
                  (fun them ->
                  bind (optional_member "wrench" (read_wrench v) [] members)
                    (fun own ->
                    bind (optional_member "loads" (read_loads v) [] members)
                      (fun loads ->
                      bind
                        (optional_member "cases"
                          (read_list_of_cases (read_case v)) [] members)
                        (fun named ->
                        let count0 =
                          if v.is_in_space
                          then S (S (S (S (S (S O)))))
                          else S (S (S O))
                        in
                        bind
                          (optional_member "max_motion"
                            (read_bound v.is_in_space false count0) []
                            members) (fun bound ->
                          bind
                            (check_that
                              (negb
                                ((&&) (has_member "wrench" members)
                                  (has_member "loads" members))) []
                              "both \"wrench\" and \"loads\"; give one of them")
                            (fun _ ->
                            bind
                              (check_that
                                ((||)
                                  ((||) (has_member "wrench" members)
                                    (has_member "loads" members))
                                  (has_member "cases" members)) []
                                "the member \"wrench\" is missing") (fun _ ->
                              let common =
                                match own with
                                | Some w -> w
                                | None ->
                                  (match loads with
                                   | Some w -> w
                                   | None -> no_wrench v)
                              in
                              let named0 =
                                match named with
                                | Some it -> it
                                | None -> []
                              in
                              Fine { in_space = v.is_in_space;
                              coordinates_read = count0; bodies_read = None;
                              body_names = []; names_of_bodies = [];
                              names_of_joints = []; all_contacts = them;
                              common_wrench = common; has_loads = false;
                              bound_read = bound; cases =
                              (map (fun pat ->
                                let (name, w) = pat in
                                (name, (add_wrench w common))) named0) }))))))))))))))

type named_body = { name_of : string; link : (nat option * q list) option }

(** val ground : string **)

let ground =
  "ground"

(** val number_from : string -> string list -> nat -> nat option **)

let rec number_from name names number =
  match names with
  | [] -> None
  | other :: rest ->
    if (=) other name then Some number else number_from name rest (S number)

(** val number_of0 : string -> named_body list -> nat option **)

let number_of0 name bodies0 =
  number_from name (map (fun n0 -> n0.name_of) bodies0) O

(** val without : string list -> (string * json) list -> json **)

let without names members =
  Object
    (filter (fun pat -> let (name, _) = pat in negb (is_among name names))
      members)

(** val read_axis : version -> path -> json -> q list result **)

let read_axis v at_path value0 =
  bind (read_point v at_path value0) (fun g ->
    bind
      (check_that (negb (forallb is_0 g)) at_path
        "expected a vector other than 0") (fun _ -> Fine g))

(** val read_slide : version -> path -> json -> q list result **)

let read_slide v at_path value0 =
  bind (read_axis v at_path value0) (fun g -> Fine
    (app g
      (if v.is_in_space
       then { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } :: ({ qnum = Big_int_Z.zero_big_int;
              qden = Big_int_Z.unit_big_int } :: ({ qnum =
              Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int } :: []))
       else { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } :: [])))

(** val read_hinge : version -> path -> json -> q list result **)

let read_hinge v at_path value0 =
  if v.is_in_space
  then bind (members_of ("at" :: ("axis" :: [])) at_path value0)
         (fun members ->
         bind (member "at" (read_point v) at_path members) (fun c ->
           bind (member "axis" (read_axis v) at_path members) (fun g ->
             match c with
             | [] -> expected "a hinge" at_path value0
             | cx :: l ->
               (match l with
                | [] -> expected "a hinge" at_path value0
                | cy :: l0 ->
                  (match l0 with
                   | [] -> expected "a hinge" at_path value0
                   | cz :: l1 ->
                     (match l1 with
                      | [] ->
                        (match g with
                         | [] -> expected "a hinge" at_path value0
                         | gx :: l2 ->
                           (match l2 with
                            | [] -> expected "a hinge" at_path value0
                            | gy :: l3 ->
                              (match l3 with
                               | [] -> expected "a hinge" at_path value0
                               | gz :: l4 ->
                                 (match l4 with
                                  | [] ->
                                    Fine
                                      ((qminus (qmult cy gz) (qmult cz gy)) :: (
                                      (qminus (qmult cz gx) (qmult cx gz)) :: (
                                      (qminus (qmult cx gy) (qmult cy gx)) :: (gx :: (gy :: (gz :: []))))))
                                  | _ :: _ ->
                                    expected "a hinge" at_path value0))))
                      | _ :: _ -> expected "a hinge" at_path value0))))))
  else bind (read_point v at_path value0) (fun c ->
         match c with
         | [] -> expected "a hinge" at_path value0
         | x :: l ->
           (match l with
            | [] -> expected "a hinge" at_path value0
            | y :: l0 ->
              (match l0 with
               | [] ->
                 Fine (y :: ((qopp x) :: ({ qnum = Big_int_Z.unit_big_int;
                   qden = Big_int_Z.unit_big_int } :: [])))
               | _ :: _ -> expected "a hinge" at_path value0)))

(** val read_on_body :
    named_body list -> path -> json -> nat option result **)

let read_on_body before at_path value0 =
  let what = "the name of a body that stands before this one, or \"ground\""
  in
  (match value0 with
   | Text name ->
     (match number_of0 name before with
      | Some number -> Fine (Some number)
      | None ->
        if (=) name ground then Fine None else expected what at_path value0)
   | _ -> expected what at_path value0)

(** val read_named_body :
    version -> named_body list -> path -> json -> named_body result **)

let read_named_body v before at_path value0 =
  bind
    (members_of
      ("name" :: ("hinge" :: ("slide" :: ("on" :: ("outline" :: ("mesh" :: []))))))
      at_path value0) (fun members ->
    bind (member "name" read_name at_path members) (fun name ->
      bind
        (check_that (negb ((=) name ground)) ((Member "name") :: at_path)
          "expected another name than \"ground\"") (fun _ ->
        bind (optional_member "hinge" (read_hinge v) at_path members)
          (fun hinge ->
          bind (optional_member "slide" (read_slide v) at_path members)
            (fun slide ->
            bind (optional_member "on" (read_on_body before) at_path members)
              (fun on ->
              bind
                (optional_member "outline" (read_outline v) at_path members)
                (fun _ ->
                bind (optional_member "mesh" (read_body v) at_path members)
                  (fun _ ->
                  bind
                    (check_that
                      (match number_of0 name before with
                       | Some _ -> false
                       | None -> true) at_path
                      ((^) "the name \"" ((^) name "\" appears twice")))
                    (fun _ ->
                    let linked = fun eta -> Fine { name_of = name; link =
                      (Some ((match on with
                              | Some it -> it
                              | None -> None), eta)) }
                    in
                    (match hinge with
                     | Some eta ->
                       (match slide with
                        | Some _ ->
                          refuse at_path
                            "both \"hinge\" and \"slide\"; give one of them"
                        | None -> linked eta)
                     | None ->
                       (match slide with
                        | Some eta -> linked eta
                        | None ->
                          bind
                            (check_that
                              (match on with
                               | Some _ -> false
                               | None -> true) ((Member "on") :: at_path)
                              "expected none, as there is neither a \"hinge\" nor a \"slide\"")
                            (fun _ -> Fine { name_of = name; link = None }))))))))))))

(** val read_bodies_after :
    version -> Big_int_Z.big_int -> path -> json list -> named_body list ->
    named_body list result **)

let rec read_bodies_after v index at_path items before =
  match items with
  | [] -> Fine before
  | item :: rest ->
    (match read_named_body v before ((Element index) :: at_path) item with
     | Fine it ->
       read_bodies_after v (Z.add index Big_int_Z.unit_big_int) at_path rest
         (app before (it :: []))
     | Malformed (where_, found, problem) ->
       Malformed (where_, found, problem))

(** val read_bodies : version -> path -> json -> named_body list result **)

let read_bodies v at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "a list of bodies, of one or more" at_path value0
   | _ :: _ -> read_bodies_after v Big_int_Z.zero_big_int at_path items [])
| _ -> expected "a list of bodies, of one or more" at_path value0

type turns_of_links = (string * q) list

(** val read_all_turns :
    named_body list -> path -> (string * json) list -> turns_of_links result **)

let rec read_all_turns bodies0 at_path = function
| [] -> Fine []
| p :: rest ->
  let (name, value0) = p in
  let here = (Member name) :: at_path in
  bind
    (check_that
      (existsb (fun b ->
        (&&) ((=) b.name_of name)
          (match b.link with
           | Some _ -> true
           | None -> false)) bodies0) here
      "expected a link, which is a body with a \"hinge\" or a \"slide\"")
    (fun _ ->
    bind
      (check_that (negb (has_member name rest)) here
        "the member appears twice; keep one of them") (fun _ ->
      bind (read_decimal here value0) (fun c ->
        bind
          (check_that (negb (is_0 c)) here "expected a number other than 0")
          (fun _ ->
          bind (read_all_turns bodies0 at_path rest) (fun others0 -> Fine
            ((name, c) :: others0))))))

(** val read_turns :
    named_body list -> path -> json -> turns_of_links result **)

let read_turns bodies0 at_path value0 = match value0 with
| Object members ->
  (match members with
   | [] ->
     expected "an object of one number or more, each by the name of a link"
       at_path value0
   | _ :: _ -> read_all_turns bodies0 at_path members)
| _ ->
  expected "an object of one number or more, each by the name of a link"
    at_path value0

(** val find_turn : string -> turns_of_links -> q **)

let find_turn name turns =
  match find (fun pat -> let (other, _) = pat in (=) other name) turns with
  | Some p -> let (_, c) = p in c
  | None -> { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }

(** val read_element :
    version -> bool -> string -> q list -> path -> (string * json) list ->
    element result **)

let read_element v spring preload_name row0 at_path members =
  let or_0 = fun it ->
    match it with
    | Some i -> i
    | None ->
      exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
  in
  bind
    (if spring
     then optional_member "stiffness" (read_property v false) at_path members
     else bind (member "stiffness" (read_property v true) at_path members)
            (fun k -> Fine (Some k))) (fun k ->
    bind
      (optional_member preload_name
        (if spring then read_interval v else read_property v false) at_path
        members) (fun p -> Fine { lever = row0; element_spring = spring;
      element_stiffness = (or_0 k); element_preload = (or_0 p);
      element_growth = { qnum = Big_int_Z.zero_big_int; qden =
      Big_int_Z.unit_big_int } }))

(** val read_text : path -> json -> string result **)

let read_text at_path value0 = match value0 with
| Text it -> Fine it
| _ -> expected "a string" at_path value0

(** val read_joint :
    version -> named_body list -> path -> json -> ((turns_of_links * string
    option) * (q list -> element result) option) result **)

let read_joint v bodies0 at_path value0 =
  bind
    (members_of ("turns" :: ("name" :: ("stiffness" :: ("torque" :: []))))
      at_path value0) (fun members ->
    bind (optional_member "name" read_text at_path members) (fun name ->
      bind (member "turns" (read_turns bodies0) at_path members)
        (fun turns -> Fine ((turns, name),
        (if (||) (has_member "stiffness" members)
              (has_member "torque" members)
         then Some (fun row0 ->
                read_element v true "torque" row0 at_path members)
         else None)))))

(** val sum_of : q list list -> nat -> q list **)

let sum_of rows0 count0 =
  fold_left (fun sum0 row0 ->
    map (fun pat -> let (a, b) = pat in qplus a b) (combine sum0 row0)) rows0
    (repeat { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int }
      count0)

(** val read_over :
    version -> named_body list -> (string -> q list) -> nat -> bool -> string
    -> path -> json -> element result **)

let read_over v bodies0 turned0 count0 spring preload_name at_path value0 =
  bind
    (members_of ("over" :: ("name" :: ("stiffness" :: (preload_name :: []))))
      at_path value0) (fun members ->
    bind (optional_member "name" read_any_text at_path members) (fun _ ->
      bind (member "over" (read_turns bodies0) at_path members) (fun over0 ->
        let row0 =
          sum_of
            (map (fun pat ->
              let (name, r) = pat in map (qmult r) (turned0 name)) over0)
            count0
        in
        bind
          (check_that
            (negb
              (forallb (fun x ->
                qeq_bool x { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int }) row0)) ((Member
            "over") :: at_path)
            "expected links that some joint turns, so that its length changes")
          (fun _ -> read_element v spring preload_name row0 at_path members))))

(** val read_load_on_body :
    version -> named_body list -> path -> json -> (nat * interval list) result **)

let read_load_on_body v bodies0 at_path value0 = match value0 with
| Object members ->
  bind
    (check_members
      ("body" :: ("wrench" :: ("force" :: ("at" :: ("weight" :: ("direction" :: ("torque" :: [])))))))
      at_path members) (fun _ ->
    let read_known = fun at_path0 value1 ->
      match value1 with
      | Text name ->
        (match number_of0 name bodies0 with
         | Some number -> Fine number
         | None -> expected "the name of one of \"bodies\"" at_path0 value1)
      | _ -> expected "the name of one of \"bodies\"" at_path0 value1
    in
    bind (member "body" read_known at_path members) (fun b ->
      if has_member "wrench" members
      then bind (members_of ("body" :: ("wrench" :: [])) at_path value0)
             (fun members0 ->
             let is_link =
               match nth_error bodies0 b with
               | Some it ->
                 (match it.link with
                  | Some _ -> true
                  | None -> false)
               | None -> true
             in
             bind
               (check_that (negb is_link) at_path
                 "the body is a link, which takes a force, a weight or a torque, but no wrench")
               (fun _ ->
               bind (member "wrench" (read_wrench v) at_path members0)
                 (fun w -> Fine (b, w))))
      else bind (read_load v at_path (without ("body" :: []) members))
             (fun w -> Fine (b, (map exactly w)))))
| _ -> expected "an object {...}" at_path value0

(** val work_of_loads :
    mechanism -> nat -> (nat * interval list) list -> interval list **)

let work_of_loads its count0 loads =
  let work = fun end_of ->
    let ws =
      fold_left (fun ws pat ->
        let (b, w) = pat in
        add_on b { qnum = Big_int_Z.unit_big_int; qden =
          Big_int_Z.unit_big_int } (map end_of w) ws) loads
        (map (fun _ -> []) its.bodies)
    in
    pull_back (numbers_of its) (rev_append its.bodies []) ws
      (repeat { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } count0)
  in
  map (fun pat -> let (a, b) = pat in { low = a; high = b })
    (combine (work (fun i -> i.low)) (work (fun i -> i.high)))

(** val no_load : nat -> interval list **)

let no_load count0 =
  repeat
    (exactly { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })
    count0

(** val read_state_wrench :
    version -> nat -> path -> json -> interval list result **)

let read_state_wrench v count0 at_path value0 =
  read_sized (Z.of_nat count0) "an array of a number for each coordinate"
    (read_interval v) at_path value0

(** val read_loads_on_bodies :
    mechanism -> nat -> (path -> json -> (nat * interval list) result) ->
    path -> json -> interval list result **)

let read_loads_on_bodies its count0 read_one at_path value0 =
  bind (read_array "an array of loads" read_one at_path value0) (fun loads ->
    Fine (work_of_loads its count0 loads))

(** val read_case_of_bodies :
    (path -> json -> interval list result) -> (path -> json -> interval list
    result) -> path -> json -> (string * interval list) result **)

let read_case_of_bodies read_w read_l at_path value0 =
  bind (members_of ("name" :: ("wrench" :: ("loads" :: []))) at_path value0)
    (fun members ->
    bind (member "name" read_name at_path members) (fun name ->
      bind (optional_member "wrench" read_w at_path members) (fun own ->
        bind (optional_member "loads" read_l at_path members) (fun loads ->
          match own with
          | Some w ->
            (match loads with
             | Some _ ->
               refuse at_path
                 "expected one of the members \"wrench\" and \"loads\""
             | None -> Fine (name, w))
          | None ->
            (match loads with
             | Some w -> Fine (name, w)
             | None ->
               refuse at_path
                 "expected one of the members \"wrench\" and \"loads\"")))))

(** val read_torsion : version -> path -> json -> q result **)

let read_torsion v at_path value0 =
  bind
    (check_that v.is_in_space at_path
      "expected none, as the grasp is in the plane") (fun _ ->
    bind (read_decimal at_path value0) (fun e ->
      bind
        (check_that
          (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } e) at_path
          "expected a number of 0 or more") (fun _ -> Fine e)))

(** val read_contact_of_bodies :
    version -> named_body list -> properties -> q -> path -> json -> contact
    result **)

let read_contact_of_bodies v bodies0 defaults soft0 at_path value0 =
  bind
    (members_of
      ("of" :: ("by" :: ("torsion" :: ("position" :: ("normal" :: ("friction" :: ("stiffness" :: ("preload" :: []))))))))
      at_path value0) (fun members ->
    let known = fun at_path0 value1 ->
      match value1 with
      | Text name ->
        (match number_of0 name bodies0 with
         | Some number -> Fine (Some number)
         | None -> expected "the name of one of \"bodies\"" at_path0 value1)
      | _ -> expected "the name of one of \"bodies\"" at_path0 value1
    in
    let other = fun at_path0 value1 ->
      match value1 with
      | Text name ->
        if (=) name ground then Fine None else known at_path0 value1
      | _ -> known at_path0 value1
    in
    bind (member "of" known at_path members) (fun of_ ->
      bind (optional_member "by" other at_path members) (fun by_0 ->
        let by_1 = match by_0 with
                   | Some it -> it
                   | None -> None in
        bind
          (check_that
            (match of_ with
             | Some a ->
               (match by_1 with
                | Some b -> negb (Nat.eqb a b)
                | None -> true)
             | None -> true) ((Member "by") :: at_path)
            "expected another body than \"of\"") (fun _ ->
          bind (optional_member "torsion" (read_torsion v) at_path members)
            (fun e ->
            bind
              (read_contact v [] defaults at_path
                (without ("of" :: ("by" :: ("torsion" :: []))) members))
              (fun it -> Fine { position = it.position; normal = it.normal;
              slope = it.slope; friction = it.friction; stiffness =
              it.stiffness; preload = it.preload; preload_growth =
              it.preload_growth; of_body = of_; by_body = by_1; torsion =
              (match e with
               | Some e0 -> e0
               | None -> soft0) }))))))

(** val read_defaults_of_bodies :
    version -> path -> json -> (properties * q) result **)

let read_defaults_of_bodies v at_path value0 =
  bind
    (members_of
      ("friction" :: ("stiffness" :: ("preload" :: ("torsion" :: []))))
      at_path value0) (fun members ->
    bind (optional_member "torsion" (read_torsion v) at_path members)
      (fun e ->
      bind (read_properties v at_path members) (fun them -> Fine (them,
        (match e with
         | Some e0 -> e0
         | None ->
           { qnum = Big_int_Z.zero_big_int; qden = Big_int_Z.unit_big_int })))))

(** val number_bodies :
    nat -> nat -> named_body list -> (string -> q list) -> rigid_body list **)

let rec number_bodies size1 next0 bodies0 turned0 =
  match bodies0 with
  | [] -> []
  | b :: rest ->
    (match b.link with
     | Some p ->
       let (on, eta) = p in
       (Link (on, eta,
       (turned0 b.name_of))) :: (number_bodies size1 next0 rest turned0)
     | None ->
       (Free next0) :: (number_bodies size1 (add next0 size1) rest turned0))

(** val names_of_body : version -> named_body -> string list **)

let names_of_body v b =
  match b.link with
  | Some _ -> []
  | None ->
    map (fun way0 -> (^) b.name_of way0)
      (if v.is_in_space
       then " x" :: (" y" :: (" z" :: (" turn x" :: (" turn y" :: (" turn z" :: [])))))
       else " x" :: (" y" :: (" turn" :: [])))

(** val most_coordinates : Big_int_Z.big_int **)

let most_coordinates =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    Big_int_Z.unit_big_int))))))))))))))))

(** val listed_member :
    string -> (path -> json -> 'a1 result) -> (string * json) list -> 'a1
    list result **)

let listed_member name read members =
  bind (optional_member name (read_array "an array" read) [] members)
    (fun them -> Fine (match them with
                       | Some it -> it
                       | None -> []))

(** val read_springs :
    q list list -> (q list -> element result) option list -> element list
    result **)

let rec read_springs levers joints =
  match levers with
  | [] -> Fine []
  | row0 :: levers0 ->
    (match joints with
     | [] -> Fine []
     | o :: joints0 ->
       (match o with
        | Some read ->
          bind (read row0) (fun it ->
            bind (read_springs levers0 joints0) (fun others0 -> Fine
              (it :: others0)))
        | None -> read_springs levers0 joints0))

(** val read_grasp_of_bodies : json -> grasp result **)

let read_grasp_of_bodies value0 =
  bind
    (members_of
      ("format" :: ("bodies" :: ("contacts" :: ("name" :: ("units" :: ("defaults" :: ("joints" :: ("tendons" :: ("ratchets" :: ("wrench" :: ("loads" :: ("cases" :: ("max_motion" :: [])))))))))))))
      [] value0) (fun members ->
    let v = { is_second = true; is_in_space =
      (match find_member "contacts" members with
       | Some j ->
         (match j with
          | Array items ->
            (match items with
             | [] -> false
             | j0 :: _ ->
               (match j0 with
                | Object first ->
                  is_array
                    ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                    Big_int_Z.unit_big_int) (find_member "position" first)
                | _ -> false))
          | _ -> false)
       | None -> false) }
    in
    let size1 = if v.is_in_space then S (S (S (S (S (S O))))) else S (S (S O))
    in
    bind (optional_member "name" read_any_text [] members) (fun _ ->
      bind (optional_member "units" read_units [] members) (fun _ ->
        bind (member "bodies" (read_bodies v) [] members) (fun bodies0 ->
          bind (listed_member "joints" (read_joint v bodies0) members)
            (fun joints ->
            bind
              (check_that
                (forallb (fun b ->
                  match b.link with
                  | Some _ ->
                    existsb (fun pat ->
                      let (y, _) = pat in
                      let (turns, _) = y in
                      existsb (fun pat0 ->
                        let (name, _) = pat0 in (=) name b.name_of) turns)
                      joints
                  | None -> true) bodies0) ((Member "bodies") :: [])
                "a link that no joint turns; expected its name in \"turns\" of one of \"joints\"")
              (fun _ ->
              let own =
                mul size1
                  (length
                    (filter (fun b ->
                      match b.link with
                      | Some _ -> false
                      | None -> true) bodies0))
              in
              let count0 = add own (length joints) in
              bind
                (check_that (Z.leb (Z.of_nat count0) most_coordinates)
                  ((Member "bodies") :: []) "more than 65536 coordinates")
                (fun _ ->
                let turned0 = fun name ->
                  app
                    (repeat { qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int } own)
                    (map (fun pat ->
                      let (y, _) = pat in
                      let (turns, _) = y in find_turn name turns) joints)
                in
                let levers =
                  map (fun q0 ->
                    app
                      (repeat { qnum = Big_int_Z.zero_big_int; qden =
                        Big_int_Z.unit_big_int } (add own q0)) ({ qnum =
                      Big_int_Z.unit_big_int; qden =
                      Big_int_Z.unit_big_int } :: (repeat { qnum =
                                                    Big_int_Z.zero_big_int;
                                                    qden =
                                                    Big_int_Z.unit_big_int }
                                                    (sub
                                                      (sub (sub count0 own)
                                                        q0) (S O)))))
                    (seq O (length joints))
                in
                bind
                  (listed_member "ratchets"
                    (read_over v bodies0 turned0 count0 false "preload")
                    members) (fun ratchets ->
                  bind
                    (read_springs levers
                      (map (fun pat -> let (_, spring) = pat in spring)
                        joints)) (fun springs ->
                    bind
                      (listed_member "tendons"
                        (read_over v bodies0 turned0 count0 true "tension")
                        members) (fun tendons ->
                      let its = { bodies_in_space = v.is_in_space; bodies =
                        (number_bodies size1 O bodies0 turned0); elements =
                        (app ratchets (app springs tendons)) }
                      in
                      bind
                        (optional_member "defaults"
                          (read_defaults_of_bodies v) [] members)
                        (fun defaults ->
                        let (defaults0, soft0) =
                          match defaults with
                          | Some it -> it
                          | None ->
                            ({ own_friction = None; own_stiffness = None;
                              own_preload = None }, { qnum =
                              Big_int_Z.zero_big_int; qden =
                              Big_int_Z.unit_big_int })
                        in
                        let read_contacts = fun at_path value1 ->
                          match value1 with
                          | Array items ->
                            bind
                              (check_that
                                (negb (is_longer_than most_contacts items))
                                at_path "too many contacts") (fun _ ->
                              each
                                (read_contact_of_bodies v bodies0 defaults0
                                  soft0) at_path items)
                          | _ ->
                            expected "an array of contacts" at_path value1
                        in
                        bind (member "contacts" read_contacts [] members)
                          (fun them ->
                          let read_w = read_state_wrench v count0 in
                          let read_l =
                            read_loads_on_bodies its count0
                              (read_load_on_body v bodies0)
                          in
                          bind (optional_member "wrench" read_w [] members)
                            (fun own_wrench ->
                            bind (optional_member "loads" read_l [] members)
                              (fun loads ->
                              bind
                                (check_that
                                  (negb
                                    ((&&) (has_member "wrench" members)
                                      (has_member "loads" members))) []
                                  "both \"wrench\" and \"loads\"; give one of them")
                                (fun _ ->
                                let common =
                                  match own_wrench with
                                  | Some w -> w
                                  | None ->
                                    (match loads with
                                     | Some w -> w
                                     | None -> no_load count0)
                                in
                                bind
                                  (optional_member "cases"
                                    (read_list_of_cases
                                      (read_case_of_bodies read_w read_l)) []
                                    members) (fun named ->
                                  let named0 =
                                    match named with
                                    | Some it -> it
                                    | None -> []
                                  in
                                  bind
                                    (optional_member "max_motion"
                                      (read_bound v.is_in_space
                                        (match joints with
                                         | [] -> false
                                         | _ :: _ -> true) count0) [] members)
                                    (fun bound -> Fine { in_space =
                                    v.is_in_space; coordinates_read = count0;
                                    bodies_read = (Some its); body_names =
                                    (map (fun n0 -> n0.name_of) bodies0);
                                    names_of_bodies =
                                    (concat (map (names_of_body v) bodies0));
                                    names_of_joints =
                                    (map (fun pat ->
                                      let (y, _) = pat in
                                      let (_, name) = y in name) joints);
                                    all_contacts = them; common_wrench =
                                    common; has_loads =
                                    ((||) (has_member "wrench" members)
                                      (has_member "loads" members));
                                    bound_read = bound; cases =
                                    (map (fun pat ->
                                      let (name, w) = pat in
                                      (name, (add_wrench w common))) named0) })))))))))))))))))

(** val read_file : json -> grasp result **)

let read_file value0 = match value0 with
| Object members ->
  (match find_member "format" members with
   | Some format ->
     if is_text "stickslip-grasp/3" format
     then read_grasp_of_bodies value0
     else read_grasp value0
   | None -> read_grasp value0)
| _ -> read_grasp value0

type tolerance = { amount : q; percent : bool }

type growth =
| Scale
| By of q list

type stated_ball = { stated_radius : q; stated_length : q;
                     stated_point : q list; stated_body : string option }

type bound_option =
| Unbounded
| Bounded of q list

type options = { asked_wrench : q list option; asked_case : string option;
                 asked_preload : q option; asked_bilateral : bool;
                 asked_direction : q list option;
                 asked_growth : growth option;
                 asked_plane : (q list * q list) option;
                 asked_inertia : q list option; asked_statics : q option;
                 asked_uncertain : (string * tolerance) list;
                 asked_ball : stated_ball option;
                 asked_bound : bound_option option }

(** val uncertain_kinds : string list **)

let uncertain_kinds =
  "friction" :: ("stiffness" :: ("preload" :: ("position" :: ("normal" :: ("wrench" :: [])))))

(** val asks_margin : options -> bool **)

let asks_margin asked =
  match asked.asked_direction with
  | Some _ -> true
  | None -> (match asked.asked_growth with
             | Some _ -> true
             | None -> false)

(** val asks_plane : options -> bool **)

let asks_plane asked =
  match asked.asked_plane with
  | Some _ -> true
  | None -> false

(** val asks_class : options -> bool **)

let asks_class asked =
  match asked.asked_inertia with
  | Some _ -> true
  | None -> false

(** val asks_statics : options -> bool **)

let asks_statics asked =
  match asked.asked_statics with
  | Some _ -> true
  | None -> false

(** val asks_one : options -> bool **)

let asks_one asked =
  (||)
    ((||) ((||) (asks_margin asked) (asks_class asked)) (asks_plane asked))
    (asks_statics asked)

(** val in_full : q list -> q list **)

let in_full numbers0 = match numbers0 with
| [] -> numbers0
| _ :: l ->
  (match l with
   | [] -> numbers0
   | _ :: l0 ->
     (match l0 with
      | [] -> numbers0
      | _ :: l1 ->
        (match l1 with
         | [] -> numbers0
         | _ :: l2 ->
           (match l2 with
            | [] -> numbers0
            | _ :: l3 ->
              (match l3 with
               | [] -> numbers0
               | _ :: l4 ->
                 (match l4 with
                  | [] ->
                    app numbers0 ({ qnum = Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int } :: ({ qnum =
                      Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int } :: ({ qnum =
                      Big_int_Z.zero_big_int; qden =
                      Big_int_Z.unit_big_int } :: [])))
                  | _ :: _ -> numbers0))))))

type posed = { the_question : question; free_coordinates : string list;
               joint_coordinates : string option list;
               stated_wrench : interval list; the_options : options;
               is_box : bool }

(** val of_question : string -> path **)

let of_question part0 =
  (Member part0) :: ((Member "the question") :: [])

(** val find_tolerance : string -> options -> tolerance option **)

let find_tolerance kind asked =
  match find (fun pat -> let (name, _) = pat in (=) name kind)
          asked.asked_uncertain with
  | Some p -> let (_, it) = p in Some it
  | None -> None

(** val check_dimension : grasp -> string -> q list option -> unit result **)

let check_dimension file part0 = function
| Some v ->
  check_that (Nat.eqb (length v) file.coordinates_read) (of_question part0)
    (match file.bodies_read with
     | Some _ ->
       "expected a number for each coordinate of the bodies and joints"
     | None ->
       if file.in_space
       then "expected 6 numbers, as the grasp is in space"
       else "expected 3 numbers, as the grasp is planar")
| None -> Fine ()

(** val wrench_asked : grasp -> options -> interval list result **)

let wrench_asked file asked =
  let here = of_question "case" in
  (match asked.asked_wrench with
   | Some w ->
     (match asked.asked_case with
      | Some _ ->
        refuse here "a wrench is given as well; expected one of them"
      | None -> Fine (map exactly w))
   | None ->
     (match asked.asked_case with
      | Some name ->
        (match find (fun pat -> let (other, _) = pat in (=) other name)
                 file.cases with
         | Some p -> let (_, w) = p in Fine w
         | None ->
           refuse here ((^) "the grasp has no case \"" ((^) name "\"")))
      | None ->
        (match asked.asked_direction with
         | Some d ->
           Fine
             (map (fun _ ->
               exactly { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int }) d)
         | None ->
           (match asked.asked_plane with
            | Some p ->
              let (d, _) = p in
              Fine
              (map (fun _ ->
                exactly { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int }) d)
            | None ->
              if file.has_loads
              then Fine file.common_wrench
              else (match file.cases with
                    | [] -> Fine file.common_wrench
                    | p :: _ ->
                      let (name, _) = p in
                      refuse here
                        ((^)
                          "the grasp has cases, and none is chosen; expected the name of one, such as \""
                          ((^) name "\"")))))))

(** val widen : tolerance option -> interval -> interval **)

let widen by_0 it =
  match by_0 with
  | Some t ->
    let off = fun x ->
      if t.percent
      then qdiv (qmult t.amount (qabs x)) { qnum =
             (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
             ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
             (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
             ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
             Big_int_Z.unit_big_int)))))); qden = Big_int_Z.unit_big_int }
      else t.amount
    in
    { low = (qminus it.low (off it.low)); high =
    (qplus it.high (off it.high)) }
  | None -> it

(** val asked_contact : options -> contact -> contact **)

let asked_contact asked it =
  let by_0 = fun kind -> find_tolerance kind asked in
  let given =
    match asked.asked_preload with
    | Some p -> exactly p
    | None -> it.preload
  in
  { position = (map (widen (by_0 "position")) it.position); normal =
  it.normal; slope =
  (match by_0 "normal" with
   | Some t -> qplus it.slope t.amount
   | None -> it.slope); friction = (widen (by_0 "friction") it.friction);
  stiffness = (widen (by_0 "stiffness") it.stiffness); preload =
  (widen (by_0 "preload") given); preload_growth = it.preload_growth;
  of_body = it.of_body; by_body = it.by_body; torsion = it.torsion }

(** val asked_element : options -> element -> element **)

let asked_element asked it =
  { lever = it.lever; element_spring = it.element_spring; element_stiffness =
    (widen (find_tolerance "stiffness" asked) it.element_stiffness);
    element_preload =
    (widen (find_tolerance "preload" asked) it.element_preload);
    element_growth = it.element_growth }

(** val ball_asked :
    grasp -> options -> interval list -> (stated_ball * ball) option result **)

let ball_asked file asked stated0 =
  match asked.asked_ball with
  | Some b ->
    let here = of_question "uncertain" in
    let point0 =
      match b.stated_point with
      | [] ->
        repeat { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int }
          (if file.in_space then S (S (S O)) else S (S O))
      | q0 :: l -> q0 :: l
    in
    bind
      (check_that (negb (asks_one asked)) here
        "a margin, a region, a class or statics is about one grasp; expected no uncertainty")
      (fun _ ->
      bind
        (check_that
          (is_below { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } b.stated_radius) here
          "expected a radius above 0") (fun _ ->
        bind
          (check_that
            (is_below { qnum = Big_int_Z.zero_big_int; qden =
              Big_int_Z.unit_big_int } b.stated_length) here
            "expected a length above 0") (fun _ ->
          bind
            (check_that
              (has_length
                (if file.in_space
                 then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                        Big_int_Z.unit_big_int)
                 else (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))
                point0) here
              (if file.in_space
               then "expected a point of three coordinates, as the grasp is in space"
               else "expected a point of two coordinates, as the grasp is planar"))
            (fun _ ->
            bind
              (check_that
                (forallb (fun it -> qeq_bool it.low it.high) stated0) here
                "expected a load without intervals") (fun _ ->
              bind
                (match file.bodies_read with
                 | Some _ ->
                   (match b.stated_body with
                    | Some name ->
                      (match number_from name file.body_names O with
                       | Some number -> Fine (Some number)
                       | None ->
                         refuse here "expected the name of one of \"bodies\"")
                    | None ->
                      refuse here "expected the name of one of \"bodies\"")
                 | None ->
                   (match b.stated_body with
                    | Some _ ->
                      refuse here
                        "expected no body, as the grasp has one only"
                    | None -> Fine None)) (fun body0 -> Fine (Some
                ({ stated_radius = b.stated_radius; stated_length =
                b.stated_length; stated_point = point0; stated_body =
                b.stated_body }, { radius = b.stated_radius; torque_length =
                b.stated_length; about = point0; on_body = body0 }))))))))
  | None -> Fine None

(** val bound_asked : grasp -> options -> q list option result **)

let bound_asked file asked =
  let here = of_question "max motion" in
  bind
    (match asked.asked_bound with
     | Some b ->
       (match b with
        | Unbounded -> Fine None
        | Bounded numbers0 ->
          bind
            (check_that
              (forallb
                (is_below { qnum = Big_int_Z.zero_big_int; qden =
                  Big_int_Z.unit_big_int }) numbers0) here
              "expected numbers above 0") (fun _ ->
            if Nat.eqb (length numbers0) file.coordinates_read
            then Fine (Some numbers0)
            else (match numbers0 with
                  | [] ->
                    (match file.names_of_joints with
                     | [] ->
                       refuse here
                         "expected a number for each coordinate of motions, or a length and an angle"
                     | _ :: _ ->
                       refuse here
                         "expected a number for each coordinate of the bodies and joints")
                  | length0 :: l ->
                    (match l with
                     | [] ->
                       (match file.names_of_joints with
                        | [] ->
                          refuse here
                            "expected a number for each coordinate of motions, or a length and an angle"
                        | _ :: _ ->
                          refuse here
                            "expected a number for each coordinate of the bodies and joints")
                     | angle :: l0 ->
                       (match l0 with
                        | [] ->
                          (match file.names_of_joints with
                           | [] ->
                             Fine (Some
                               (bound_of0 file.in_space file.coordinates_read
                                 length0 angle))
                           | _ :: _ ->
                             refuse here
                               "expected a number for each coordinate of the bodies and joints")
                        | _ :: _ ->
                          (match file.names_of_joints with
                           | [] ->
                             refuse here
                               "expected a number for each coordinate of motions, or a length and an angle"
                           | _ :: _ ->
                             refuse here
                               "expected a number for each coordinate of the bodies and joints"))))))
     | None -> Fine (if asks_statics asked then None else file.bound_read))
    (fun bound ->
    bind
      (check_that
        (match bound with
         | Some _ ->
           negb
             ((||) ((||) (asks_plane asked) (asks_class asked))
               (asks_statics asked))
         | None -> true) here
        "motions are bounded, and a plane, an inertia or statics is given as well; expected one of them")
      (fun _ -> Fine bound))

(** val check_tolerances :
    options -> (string * tolerance) list -> unit result **)

let rec check_tolerances asked = function
| [] -> Fine ()
| p :: rest ->
  let (kind, t) = p in
  let here = of_question "uncertain" in
  bind
    (check_that (negb (asks_one asked)) here
      "a margin, a region, a class or statics is about one grasp; expected no uncertainty")
    (fun _ ->
    bind
      (check_that
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } t.amount) here
        "expected tolerances of 0 or more") (fun _ ->
      bind
        (check_that (negb ((&&) ((=) kind "normal") t.percent)) here
          "of normals a slope is expected, such as 0.01") (fun _ ->
        check_tolerances asked rest)))

(** val is_exact : interval -> bool **)

let is_exact it =
  qeq_bool it.low it.high

(** val is_one_point : contact -> bool **)

let is_one_point it =
  (&&)
    ((&&)
      ((&&) ((&&) (forallb is_exact it.position) (is_0 it.slope))
        (is_exact it.friction)) (is_exact it.stiffness)) (is_exact it.preload)

(** val has_irrational_preload : contact -> bool **)

let has_irrational_preload it =
  (&&) ((||) (negb (is_0 it.preload.high)) (negb (is_0 it.preload_growth)))
    (match exact_root (sum_of_squares0 it.normal) with
     | Some _ -> false
     | None -> true)

(** val check_contact :
    bool -> bool -> bool -> path -> contact -> bool result **)

let check_contact margin exact0 statics0 at_path it =
  let here = fun name -> (Member name) :: at_path in
  bind
    (check_that
      (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
        Big_int_Z.unit_big_int } it.friction.low) (here "friction")
      "it may be below 0; expected 0 or more") (fun _ ->
    bind
      (check_that
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } it.preload.low) (here "preload")
        "it may be below 0; expected 0 or more") (fun _ ->
      bind
        (check_that
          (is_below { qnum = Big_int_Z.zero_big_int; qden =
            Big_int_Z.unit_big_int } it.stiffness.low) (here "stiffness")
          "it may be 0 or less; expected above 0") (fun _ ->
        bind
          (check_that
            (is_below it.slope { qnum = Big_int_Z.unit_big_int; qden =
              Big_int_Z.unit_big_int }) (here "normal")
            "expected a slope below 1") (fun _ ->
          bind
            (check_that ((||) (is_0 it.slope) (is_0 it.torsion))
              (here "normal") "expected no slope, as the contact has torsion")
            (fun _ ->
            bind
              (check_that ((||) (negb margin) (is_one_point it)) at_path
                "found an interval, but the question is about one grasp; expected numbers")
              (fun _ ->
              let irrational =
                (&&) (negb statics0) (has_irrational_preload it)
              in
              bind
                (check_that (negb ((&&) irrational exact0)) (here "normal")
                  ((^)
                    "the contact has a preload and a normal of irrational length, so there is no exact "
                    "question; run stickslip snap GRASP -o FILE, and ask about FILE"))
                (fun _ -> Fine ((||) irrational (negb (is_one_point it))))))))))

(** val check_element : bool -> path -> element -> bool result **)

let check_element margin at_path it =
  let spring = it.element_spring in
  let k = it.element_stiffness.low in
  bind
    (check_that
      ((||) spring
        (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
          Big_int_Z.unit_big_int } it.element_preload.low)) at_path
      "the preload may be below 0; expected 0 or more") (fun _ ->
    bind
      (check_that
        (if spring
         then qle_bool { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int } k
         else is_below { qnum = Big_int_Z.zero_big_int; qden =
                Big_int_Z.unit_big_int } k) at_path
        "the stiffness may be too small; expected above 0, of a spring 0 or more")
      (fun _ ->
      let certain0 =
        (&&) (is_exact it.element_stiffness) (is_exact it.element_preload)
      in
      bind
        (check_that ((||) (negb margin) certain0) at_path
          "found an interval, but the question is about one grasp; expected numbers")
        (fun _ -> Fine (negb certain0))))

(** val with_growth : interval -> q -> contact -> contact **)

let with_growth p u it =
  { position = it.position; normal = it.normal; slope = it.slope; friction =
    it.friction; stiffness = it.stiffness; preload = p; preload_growth = u;
    of_body = it.of_body; by_body = it.by_body; torsion = it.torsion }

(** val element_with_growth : interval -> q -> element -> element **)

let element_with_growth p u it =
  { lever = it.lever; element_spring = it.element_spring; element_stiffness =
    it.element_stiffness; element_preload = p; element_growth = u }

(** val with_growths :
    ('a1 -> q -> 'a1) -> 'a1 list -> q list -> 'a1 list -> ('a1 list * q
    list) option **)

let rec with_growths grown items numbers0 done0 =
  match items with
  | [] -> Some ((rev_append done0 []), numbers0)
  | it :: others0 ->
    (match numbers0 with
     | [] -> None
     | p :: rest -> with_growths grown others0 rest ((grown it p) :: done0))

(** val are_multiples : q list -> q list -> bool **)

let are_multiples u v =
  match find (fun pat -> let (a, _) = pat in negb (is_0 a)) (combine u v) with
  | Some p ->
    let (a, b) = p in
    forallb (fun pat ->
      let (x, y) = pat in is_0 (qminus (qmult a y) (qmult x b))) (combine u v)
  | None -> true

(** val check_plane : grasp -> options -> unit result **)

let check_plane file asked =
  let here = of_question "plane" in
  (match asked.asked_plane with
   | Some p ->
     let (u, v) = p in
     bind (check_dimension file "plane" (Some u)) (fun _ ->
       bind (check_dimension file "plane" (Some v)) (fun _ ->
         bind
           (check_that
             ((||) (asks_statics asked)
               (match file.bodies_read with
                | Some _ -> false
                | None -> true)) here
             "the grasp is of several bodies; expected a question about a wrench or a direction")
           (fun _ ->
           bind
             (check_that ((||) (asks_statics asked) (negb file.in_space))
               here "the grasp is in space; a region is about a planar grasp")
             (fun _ ->
             bind
               (check_that (negb (asks_margin asked)) here
                 "a direction is given as well; expected one of them")
               (fun _ ->
               check_that (negb (are_multiples u v)) here
                 "its directions are multiples of one another; expected a plane")))))
   | None -> Fine ())

(** val check_statics0 : grasp -> options -> unit result **)

let check_statics0 file asked =
  let here = of_question "statics" in
  (match asked.asked_statics with
   | Some factor0 ->
     bind
       (check_that
         (qle_bool { qnum = Big_int_Z.zero_big_int; qden =
           Big_int_Z.unit_big_int } factor0) here
         "expected a factor of 0 or more") (fun _ ->
       bind
         (check_that (negb (asks_class asked)) here
           "an inertia is given as well; expected one of them") (fun _ ->
         check_that
           (match asked.asked_growth with
            | Some _ -> false
            | None -> true) here
           "a preload direction is given as well, but preloads play no part"))
   | None ->
     check_that
       (Z.leb (Z.of_nat file.coordinates_read) (Big_int_Z.mult_int_big_int 2
         ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
         Big_int_Z.unit_big_int))))) (of_question "bodies")
       "more than 30 coordinates of bodies and joints; expected as many at most, but in a question of statics")

(** val pose : grasp -> options -> posed result **)

let pose file asked =
  bind (check_dimension file "wrench" asked.asked_wrench) (fun _ ->
    bind (check_dimension file "direction" asked.asked_direction) (fun _ ->
      bind
        (check_that
          (match asked.asked_preload with
           | Some p ->
             qle_bool { qnum = Big_int_Z.zero_big_int; qden =
               Big_int_Z.unit_big_int } p
           | None -> true) (of_question "preload") "expected 0 or more")
        (fun _ ->
        bind (check_plane file asked) (fun _ ->
          bind (check_statics0 file asked) (fun _ ->
            bind (wrench_asked file asked) (fun stated0 ->
              bind (check_tolerances asked asked.asked_uncertain) (fun _ ->
                bind (ball_asked file asked stated0) (fun ball0 ->
                  bind (bound_asked file asked) (fun bound ->
                    let them = map_all (asked_contact asked) file.all_contacts
                    in
                    let others0 =
                      match file.bodies_read with
                      | Some its -> map_all (asked_element asked) its.elements
                      | None -> []
                    in
                    bind
                      (match asked.asked_growth with
                       | Some g ->
                         (match g with
                          | Scale -> Fine (them, others0)
                          | By numbers0 ->
                            let problem =
                              "expected numbers of 0 or more, one for each contact, then ratchet, then spring, of which any"
                            in
                            let wrong =
                              refuse (of_question "preload direction") problem
                            in
                            (match with_growths (fun it p ->
                                     with_growth it.preload p it) them
                                     numbers0 [] with
                             | Some p ->
                               let (them0, rest) = p in
                               (match with_growths (fun it p0 ->
                                        element_with_growth
                                          it.element_preload p0 it) others0
                                        rest [] with
                                | Some p0 ->
                                  let (others1, l) = p0 in
                                  (match l with
                                   | [] ->
                                     bind
                                       (check_that
                                         ((&&)
                                           (forallb (fun it ->
                                             qle_bool { qnum =
                                               Big_int_Z.zero_big_int; qden =
                                               Big_int_Z.unit_big_int }
                                               it.preload_growth) them0)
                                           (forallb (fun it ->
                                             (||) it.element_spring
                                               (qle_bool { qnum =
                                                 Big_int_Z.zero_big_int;
                                                 qden =
                                                 Big_int_Z.unit_big_int }
                                                 it.element_growth)) others1))
                                         (of_question "preload direction")
                                         problem) (fun _ -> Fine (them0,
                                       others1))
                                   | _ :: _ -> wrong)
                                | None -> wrong)
                             | None -> wrong))
                       | None -> Fine (them, others0)) (fun pat ->
                      let (them0, others1) = pat in
                      bind
                        (match asked.asked_inertia with
                         | Some numbers0 ->
                           let here = of_question "inertia" in
                           bind
                             (check_that
                               (match file.bodies_read with
                                | Some _ -> false
                                | None -> true) here
                               "the grasp is of several bodies; expected a question about a wrench or a direction")
                             (fun _ ->
                             bind
                               (check_that
                                 (negb
                                   ((||) (asks_margin asked)
                                     (asks_plane asked))) here
                                 "a direction or a plane is given as well; expected one of them")
                               (fun _ ->
                               bind
                                 (check_that
                                   (has_length
                                     (if file.in_space
                                      then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                             (Big_int_Z.mult_int_big_int 2
                                             (Big_int_Z.mult_int_big_int 2
                                             Big_int_Z.unit_big_int)))
                                      else ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                             Big_int_Z.unit_big_int))
                                     numbers0) here
                                   (if file.in_space
                                    then "expected 6 or 9 numbers"
                                    else "expected 3 numbers")) (fun _ ->
                                 check_that
                                   (match masses numbers0 with
                                    | Some _ -> true
                                    | None -> false) here
                                   (if file.in_space
                                    then "the tensor is not positive definite"
                                    else "the squared radius of gyration must be > 0"))))
                         | None -> Fine ()) (fun _ ->
                        let margin = asks_one asked in
                        let statics0 = asks_statics asked in
                        let exact0 =
                          (&&) (negb file.in_space)
                            ((||) (asks_class asked) (asks_plane asked))
                        in
                        bind
                          (each (check_contact margin exact0 statics0)
                            ((Member "contacts") :: []) them0) (fun boxes ->
                          bind
                            (each (check_element margin) ((Member
                              "ratchets and springs") :: []) others1)
                            (fun other_boxes ->
                            let widened =
                              map (widen (find_tolerance "wrench" asked))
                                stated0
                            in
                            let certain0 = forallb is_exact widened in
                            bind
                              (check_that ((||) (negb margin) certain0)
                                ((Member "wrench") :: [])
                                "found an interval, but the question is about one grasp; expected numbers")
                              (fun _ ->
                              let scales =
                                match asked.asked_growth with
                                | Some g ->
                                  (match g with
                                   | Scale -> true
                                   | By _ -> false)
                                | None -> false
                              in
                              let them1 =
                                if scales
                                then map_all (fun it ->
                                       with_growth
                                         (exactly { qnum =
                                           Big_int_Z.zero_big_int; qden =
                                           Big_int_Z.unit_big_int })
                                         it.preload.low it) them0
                                else them0
                              in
                              let others2 =
                                if scales
                                then map_all (fun it ->
                                       element_with_growth
                                         (exactly { qnum =
                                           Big_int_Z.zero_big_int; qden =
                                           Big_int_Z.unit_big_int })
                                         it.element_preload.low it) others1
                                else others1
                              in
                              let u =
                                match asked.asked_direction with
                                | Some u -> u
                                | None ->
                                  map (fun _ -> { qnum =
                                    Big_int_Z.zero_big_int; qden =
                                    Big_int_Z.unit_big_int }) stated0
                              in
                              bind
                                (check_that
                                  ((||)
                                    ((||)
                                      ((||) (negb (asks_margin asked))
                                        (negb (forallb is_0 u)))
                                      (existsb (fun it ->
                                        negb (is_0 it.preload_growth)) them1))
                                    (existsb (fun it ->
                                      negb (is_0 it.element_growth)) others2))
                                  (of_question "direction")
                                  ((^)
                                    "neither the wrench nor a preload changes; expected a direction other than 0, or to "
                                    "scale preloads some of which are not 0"))
                                (fun _ -> Fine { the_question = { dimension =
                                file.coordinates_read; bilateral =
                                asked.asked_bilateral; is_margin =
                                (asks_margin asked); contacts = them1;
                                wrench = widened; load_ball =
                                (match ball0 with
                                 | Some p -> let (_, b) = p in Some b
                                 | None -> None); direction = u; load_plane =
                                asked.asked_plane; inertia =
                                (match asked.asked_inertia with
                                 | Some numbers0 -> numbers0
                                 | None -> []); statics =
                                asked.asked_statics; several =
                                (match file.bodies_read with
                                 | Some its ->
                                   Some { bodies_in_space =
                                     its.bodies_in_space; bodies =
                                     its.bodies; elements = others2 }
                                 | None -> None); max_motion = bound };
                                free_coordinates = file.names_of_bodies;
                                joint_coordinates = file.names_of_joints;
                                stated_wrench = stated0; the_options =
                                { asked_wrench = asked.asked_wrench;
                                asked_case = asked.asked_case;
                                asked_preload = asked.asked_preload;
                                asked_bilateral = asked.asked_bilateral;
                                asked_direction = asked.asked_direction;
                                asked_growth = asked.asked_growth;
                                asked_plane = asked.asked_plane;
                                asked_inertia = asked.asked_inertia;
                                asked_statics = asked.asked_statics;
                                asked_uncertain = asked.asked_uncertain;
                                asked_ball =
                                (match ball0 with
                                 | Some p -> let (b, _) = p in Some b
                                 | None -> None); asked_bound =
                                (match bound with
                                 | Some numbers0 -> Some (Bounded numbers0)
                                 | None -> None) }; is_box =
                                ((||)
                                  ((||) (negb certain0)
                                    (match ball0 with
                                     | Some _ -> true
                                     | None -> false))
                                  (existsb (fun box0 -> box0)
                                    (app boxes other_boxes))) })))))))))))))))

type statement = { stated_contacts : Big_int_Z.big_int;
                   wrench_stated : interval list; options_stated : options }

type shape = { spatial : bool; of_bodies : bool;
               size_of_twist : Big_int_Z.big_int; soft : bool list;
               of_claims : bool; of_margin : bool; of_plane : bool;
               of_class : bool; of_statics : bool }

(** val has_claims : question -> bool **)

let has_claims q0 =
  (||)
    ((||)
      (match q0.several with
       | Some _ -> true
       | None -> Nat.eqb q0.dimension (S (S (S (S (S (S O)))))))
      (match q0.max_motion with
       | Some _ -> true
       | None -> false)) (existsb has_irrational_preload q0.contacts)

(** val read_numbers : Big_int_Z.big_int -> path -> json -> q list result **)

let read_numbers count0 =
  read_sized count0
    (if Z.eqb count0 (Big_int_Z.mult_int_big_int 2
          ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
          Big_int_Z.unit_big_int))
     then "an array of 6 numbers"
     else if Z.eqb count0
               ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
               Big_int_Z.unit_big_int)
          then "an array of 3 numbers"
          else "an array of so many numbers as the dimension asks for")
    read_fraction

(** val read_twist : shape -> path -> json -> q list result **)

let read_twist s =
  read_numbers s.size_of_twist

(** val read_or_null : path -> json -> q option result **)

let read_or_null at_path value0 = match value0 with
| Null -> Fine None
| _ -> bind (read_fraction at_path value0) (fun x -> Fine (Some x))

(** val read_stated_component : path -> json -> interval result **)

let read_stated_component at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "a number, or [min, max]" at_path value0
   | least :: l ->
     (match l with
      | [] -> expected "a number, or [min, max]" at_path value0
      | most :: l0 ->
        (match l0 with
         | [] ->
           bind (read_fraction at_path least) (fun a ->
             bind (read_fraction at_path most) (fun b -> Fine { low = a;
               high = b }))
         | _ :: _ -> expected "a number, or [min, max]" at_path value0)))
| _ -> bind (read_fraction at_path value0) (fun x -> Fine (exactly x))

(** val read_law : path -> json -> bool result **)

let read_law at_path value0 =
  if is_text "bilateral" value0
  then Fine true
  else if is_text "unilateral" value0
       then Fine false
       else expected "\"unilateral\" or \"bilateral\"" at_path value0

(** val read_growth : path -> json -> growth result **)

let read_growth at_path value0 =
  if is_text "scale" value0
  then Fine Scale
  else bind
         (read_array "\"scale\" or an array of numbers" read_fraction at_path
           value0) (fun numbers0 -> Fine (By numbers0))

(** val before_percent : string -> string option **)

let before_percent content0 =
  match rev_append
          ((fun s ->
      Array.to_list (Array.init (String.length s) (fun i -> s.[i])))
            content0) [] with
  | [] -> None
  | last :: others0 ->
    if (=) last '%'
    then Some
           ((fun l ->
      let a = Array.of_list l in
      String.init (Array.length a) (fun i -> a.(i)))
             (rev_append others0 []))
    else None

(** val read_tolerance : path -> json -> tolerance result **)

let read_tolerance at_path value0 =
  let percentage =
    match value0 with
    | Null -> None
    | Boolean _ -> None
    | Number _ -> None
    | Text content0 -> before_percent content0
    | _ -> None
  in
  (match percentage with
   | Some spelled ->
     bind (read_fraction at_path (Text spelled)) (fun x -> Fine { amount = x;
       percent = true })
   | None ->
     bind (read_fraction at_path value0) (fun x -> Fine { amount = x;
       percent = false }))

(** val read_ball : shape -> path -> json -> stated_ball result **)

let read_ball s at_path value0 =
  let coordinates1 =
    if s.spatial
    then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
           Big_int_Z.unit_big_int)
    else (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
  in
  bind
    (members_in_order
      (app ("ball" :: ("length" :: ("about" :: [])))
        (if s.of_bodies then "body" :: [] else [])) at_path value0)
    (fun members ->
    bind (member "ball" read_fraction at_path members) (fun r ->
      bind (member "length" read_fraction at_path members) (fun l ->
        bind
          (optional_member "about"
            (read_sized coordinates1 "an array of the coordinates of a point"
              read_fraction) at_path members) (fun c ->
          bind
            (if s.of_bodies
             then bind (member "body" read_text at_path members) (fun name ->
                    Fine (Some name))
             else Fine None) (fun b -> Fine { stated_radius = r;
            stated_length = l; stated_point =
            (match c with
             | Some c0 -> c0
             | None ->
               repeat { qnum = Big_int_Z.zero_big_int; qden =
                 Big_int_Z.unit_big_int } (Z.to_nat coordinates1));
            stated_body = b })))))

(** val read_all_tolerances :
    shape -> path -> (string * json) list -> ((string * tolerance)
    list * stated_ball option) result **)

let rec read_all_tolerances s at_path = function
| [] -> Fine ([], None)
| p :: rest ->
  let (kind, value0) = p in
  if (&&) ((=) kind "wrench")
       (match value0 with
        | Object _ -> true
        | _ -> false)
  then bind (read_ball s ((Member kind) :: at_path) value0) (fun b ->
         bind (read_all_tolerances s at_path rest) (fun pat ->
           let (others0, _) = pat in Fine (others0, (Some b))))
  else bind (read_tolerance ((Member kind) :: at_path) value0) (fun t ->
         bind (read_all_tolerances s at_path rest) (fun pat ->
           let (others0, b) = pat in Fine (((kind, t) :: others0), b)))

(** val read_tolerances :
    shape -> path -> json -> ((string * tolerance) list * stated_ball option)
    result **)

let read_tolerances s at_path value0 =
  bind (members_in_order uncertain_kinds at_path value0) (fun members ->
    match members with
    | [] -> expected "an object of one tolerance or more" at_path value0
    | _ :: _ -> read_all_tolerances s at_path members)

(** val read_inertia : bool -> path -> json -> q list result **)

let read_inertia in_space0 at_path value0 =
  bind
    (read_array "an array of numbers, as --inertia has them" read_fraction
      at_path value0) (fun numbers0 ->
    bind
      (check_that
        (if in_space0
         then (||)
                (has_length (Big_int_Z.mult_int_big_int 2
                  ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                  Big_int_Z.unit_big_int)) numbers0)
                (has_length
                  ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
                  Big_int_Z.unit_big_int))) numbers0)
         else has_length
                ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                Big_int_Z.unit_big_int) numbers0) at_path
        (if in_space0 then "expected 6 or 9 numbers" else "expected 3 numbers"))
      (fun _ -> Fine (in_full numbers0)))

(** val read_plane :
    Big_int_Z.big_int -> path -> json -> (q list * q list) result **)

let read_plane count0 at_path value0 =
  bind
    (read_sized (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
      "two directions" (read_numbers count0) at_path value0) (fun them ->
    Fine ((nth O them []), (nth (S O) them [])))

(** val names_member : string -> json -> bool **)

let names_member name = function
| Object members -> has_member name members
| _ -> false

(** val read_statement : shape -> path -> json -> statement result **)

let read_statement s at_path value0 =
  bind
    (members_in_order
      (app
        ("contacts" :: ("wrench" :: ("preload" :: ("normal_law" :: ("direction" :: ("preload_direction" :: []))))))
        (app
          (if (&&) ((||) s.spatial s.of_bodies)
                (negb (names_member "statics" value0))
           then []
           else "plane" :: [])
          (app (if s.of_bodies then [] else "inertia" :: [])
            ("statics" :: ("uncertain" :: ("max_motion" :: [])))))) at_path
      value0) (fun members ->
    let count0 = s.size_of_twist in
    bind (member "contacts" read_index at_path members) (fun m ->
      bind
        (member "wrench"
          (read_sized count0 "an array of the components"
            read_stated_component) at_path members) (fun w ->
        bind (optional_member "preload" read_fraction at_path members)
          (fun p ->
          bind (member "normal_law" read_law at_path members) (fun law ->
            bind
              (optional_member "direction" (read_numbers count0) at_path
                members) (fun u ->
              bind
                (optional_member "preload_direction" read_growth at_path
                  members) (fun growing ->
                bind
                  (optional_member "plane" (read_plane count0) at_path
                    members) (fun plane ->
                  bind
                    (optional_member "inertia" (read_inertia s.spatial)
                      at_path members) (fun i ->
                    bind
                      (optional_member "statics" read_fraction at_path
                        members) (fun factor0 ->
                      bind
                        (optional_member "uncertain" (read_tolerances s)
                          at_path members) (fun uncertain ->
                        bind
                          (optional_member "max_motion" (read_numbers count0)
                            at_path members) (fun bound -> Fine
                          { stated_contacts = m; wrench_stated = w;
                          options_stated = { asked_wrench = None;
                          asked_case = None; asked_preload = p;
                          asked_bilateral = law; asked_direction = u;
                          asked_growth = growing; asked_plane = plane;
                          asked_inertia = i; asked_statics = factor0;
                          asked_uncertain =
                          (match uncertain with
                           | Some p0 -> let (it, _) = p0 in it
                           | None -> []); asked_ball =
                          (match uncertain with
                           | Some p0 -> let (_, b) = p0 in b
                           | None -> None); asked_bound =
                          (match bound with
                           | Some numbers0 -> Some (Bounded numbers0)
                           | None -> None) } }))))))))))))

(** val read_friction :
    shape -> Big_int_Z.big_int -> path -> json -> q list result **)

let read_friction s contact0 at_path value0 =
  if s.spatial
  then read_numbers
         (match numbered s.soft contact0 with
          | Some b ->
            if b
            then (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
                   Big_int_Z.unit_big_int))
            else ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                   Big_int_Z.unit_big_int)
          | None ->
            ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
              Big_int_Z.unit_big_int)) at_path value0
  else bind (read_fraction at_path value0) (fun x -> Fine (x :: []))

(** val read_force :
    shape -> path -> json -> (Big_int_Z.big_int * (q * q list)) result **)

let read_force s at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[contact, number, force or slip]" at_path value0
   | contact0 :: l ->
     (match l with
      | [] -> expected "[contact, number, force or slip]" at_path value0
      | along :: l0 ->
        (match l0 with
         | [] -> expected "[contact, number, force or slip]" at_path value0
         | across0 :: l1 ->
           (match l1 with
            | [] ->
              bind (read_index at_path contact0) (fun i ->
                bind (read_fraction at_path along) (fun a ->
                  bind (read_friction s i at_path across0) (fun f -> Fine (i,
                    (a, f)))))
            | _ :: _ ->
              expected "[contact, number, force or slip]" at_path value0))))
| _ -> expected "[contact, number, force or slip]" at_path value0

(** val read_forces : shape -> path -> json -> stated_forces result **)

let read_forces s =
  read_array "an array [[contact, number, force or slip], ...]" (read_force s)

(** val read_parameter : shape -> path -> json -> parameter result **)

let read_parameter s at_path value0 =
  let is = fun name -> is_text name value0 in
  if is "x"
  then Fine PX
  else if is "y"
       then Fine PY
       else if (&&) s.spatial (is "z")
            then Fine PZ
            else if (&&) (negb s.spatial) (is "turn")
                 then Fine PTurn
                 else if (&&) s.spatial (is "turn_u")
                      then Fine PTurn
                      else if (&&) s.spatial (is "turn_v")
                           then Fine PTurnV
                           else if is "friction"
                                then Fine PFriction
                                else if is "preload"
                                     then Fine PPreload
                                     else if is "stiffness"
                                          then Fine PStiffness
                                          else if is "wrench"
                                               then Fine PWrench
                                               else expected
                                                      (if s.spatial
                                                       then "x, y, z, turn_u, turn_v, friction, preload, stiffness or wrench"
                                                       else "x, y, turn, friction, preload, stiffness or wrench")
                                                      at_path value0

(** val read_cut :
    shape -> path -> json list -> json ->
    ((parameter * Big_int_Z.big_int) * q) result **)

let read_cut s at_path items whole =
  match items with
  | [] -> expected "part, a name, an index and a number" at_path whole
  | name :: l ->
    (match l with
     | [] -> expected "part, a name, an index and a number" at_path whole
     | index :: l0 ->
       (match l0 with
        | [] -> expected "part, a name, an index and a number" at_path whole
        | at_number :: l1 ->
          (match l1 with
           | [] ->
             bind (read_parameter s at_path name) (fun p ->
               bind (read_index at_path index) (fun i ->
                 bind (read_fraction at_path at_number) (fun c -> Fine ((p,
                   i), c))))
           | _ :: _ ->
             expected "part, a name, an index and a number" at_path whole)))

(** val read_node : shape -> path -> json -> node result **)

let read_node s at_path value0 =
  let contact_of = fun items ->
    match items with
    | [] -> expected "a kind and a contact" at_path value0
    | index :: l ->
      (match l with
       | [] -> read_index at_path index
       | _ :: _ -> expected "a kind and a contact" at_path value0)
  in
  let twist0 = s.size_of_twist in
  (match value0 with
   | Array items0 ->
     (match items0 with
      | [] ->
        expected "an array that begins with the kind of the node" at_path
          value0
      | j :: items ->
        (match j with
         | Text kind ->
           if (=) kind "leaf"
           then if has_length twist0 items
                then bind (each read_fraction at_path items) (fun y -> Fine
                       (Leaf y))
                else expected
                       "leaf, and a number for each component of a twist"
                       at_path value0
           else if (=) kind "slip"
                then bind (contact_of items) (fun i -> Fine (Slip i))
                else if (=) kind "separation"
                     then bind (contact_of items) (fun i -> Fine (Separation
                            i))
                     else if (=) kind "plane"
                          then if has_length
                                    (Z.add twist0
                                      (if s.of_plane
                                       then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                                              Big_int_Z.unit_big_int)
                                       else if s.of_margin
                                            then (Big_int_Z.mult_int_big_int 2
                                                   Big_int_Z.unit_big_int)
                                            else Big_int_Z.unit_big_int))
                                    items
                               then bind (each read_fraction at_path items)
                                      (fun a -> Fine (Plane a))
                               else expected
                                      "plane, and a number for each coordinate of a point"
                                      at_path value0
                          else if (&&) ((=) kind "moving")
                                    (negb ((||) s.of_margin s.of_plane))
                               then if has_length
                                         (Z.add twist0
                                           (Big_int_Z.mult_int_big_int 2
                                           Big_int_Z.unit_big_int)) items
                                    then let n0 = Z.to_nat twist0 in
                                         bind
                                           (each read_fraction at_path
                                             (firstn n0 items)) (fun y ->
                                           bind
                                             (read_fraction at_path
                                               (nth n0 items Null)) (fun c ->
                                             bind
                                               (read_forces s at_path
                                                 (nth (S n0) items Null))
                                               (fun them -> Fine (Moving (y,
                                               c, them)))))
                                    else expected
                                           "moving, a number for each component of a twist, one more, and an array"
                                           at_path value0
                               else if (&&) ((=) kind "held") s.of_plane
                                    then bind (contact_of items) (fun k ->
                                           Fine (Held k))
                                    else if (&&) ((=) kind "part")
                                              (negb
                                                ((||) s.of_margin s.of_plane))
                                         then bind
                                                (read_cut s at_path items
                                                  value0) (fun pat ->
                                                let (p0, c) = pat in
                                                let (p, i) = p0 in
                                                Fine (Cut (p, i, c)))
                                         else expected
                                                "slip, separation, plane, leaf or, without a direction, moving or part"
                                                at_path value0
         | _ ->
           expected "an array that begins with the kind of the node" at_path
             value0))
   | _ ->
     expected "an array that begins with the kind of the node" at_path value0)

(** val read_nodes : shape -> path -> json -> node list result **)

let read_nodes s =
  read_array "an array of nodes" (read_node s)

(** val read_share :
    shape -> path -> json -> (Big_int_Z.big_int * q list) result **)

let read_share s at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[contact, share]" at_path value0
   | index :: l ->
     (match l with
      | [] -> expected "[contact, share]" at_path value0
      | share :: l0 ->
        (match l0 with
         | [] ->
           bind (read_index at_path index) (fun i ->
             bind (read_friction s i at_path share) (fun numbers0 -> Fine (i,
               numbers0)))
         | _ :: _ -> expected "[contact, share]" at_path value0)))
| _ -> expected "[contact, share]" at_path value0

(** val read_shares :
    shape -> path -> json -> (Big_int_Z.big_int * q list) list result **)

let read_shares s =
  read_array "an array [[contact, share], ...]" (read_share s)

(** val read_point0 : shape -> bool -> path -> json -> point result **)

let read_point0 s may_be_ray at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "a point [lambda, twist, shares]" at_path value0
   | lambda :: l ->
     (match l with
      | [] -> expected "a point [lambda, twist, shares]" at_path value0
      | motion :: l0 ->
        (match l0 with
         | [] -> expected "a point [lambda, twist, shares]" at_path value0
         | list0 :: l1 ->
           (match l1 with
            | [] ->
              bind
                (if may_be_ray
                 then read_or_null at_path lambda
                 else bind (read_fraction at_path lambda) (fun x -> Fine
                        (Some x))) (fun lambda0 ->
                bind (read_twist s at_path motion) (fun d ->
                  bind (read_shares s at_path list0) (fun them -> Fine
                    { multiple = lambda0; point_witness = { twist = d;
                    shares = them } })))
            | _ :: _ ->
              expected "a point [lambda, twist, shares]" at_path value0))))
| _ -> expected "a point [lambda, twist, shares]" at_path value0

(** val read_segment : shape -> bool -> path -> json -> segment result **)

let read_segment s goes_on at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] ->
     expected
       "two points, or one where the segment before ended with a number"
       at_path value0
   | last :: l ->
     (match l with
      | [] ->
        if goes_on
        then bind (read_point0 s true at_path last) (fun b -> Fine (Segment
               (None, b)))
        else expected "two points, as no segment before ended with a number"
               at_path value0
      | last0 :: l0 ->
        (match l0 with
         | [] ->
           bind (read_point0 s false at_path last) (fun a ->
             bind (read_point0 s true at_path last0) (fun b -> Fine (Segment
               ((Some a), b))))
         | _ :: _ ->
           expected
             "two points, or one where the segment before ended with a number"
             at_path value0)))
| _ ->
  expected "two points, or one where the segment before ended with a number"
    at_path value0

(** val read_resisted : path -> json -> (q * q option) result **)

let read_resisted at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[low, high] or [low, null]" at_path value0
   | a :: l ->
     (match l with
      | [] -> expected "[low, high] or [low, null]" at_path value0
      | b :: l0 ->
        (match l0 with
         | [] ->
           bind (read_fraction at_path a) (fun a0 ->
             bind (read_or_null at_path b) (fun b0 -> Fine (a0, b0)))
         | _ :: _ -> expected "[low, high] or [low, null]" at_path value0)))
| _ -> expected "[low, high] or [low, null]" at_path value0

(** val read_matrix : shape -> path -> json -> q list list result **)

let read_matrix s =
  read_sized s.size_of_twist
    "a matrix with a row for each component of a twist" (read_twist s)

(** val has_at_most : Big_int_Z.big_int -> 'a1 list -> bool **)

let rec has_at_most size1 = function
| [] -> true
| _ :: rest ->
  (&&) (Z.ltb Big_int_Z.zero_big_int size1)
    (has_at_most (Z.sub size1 Big_int_Z.unit_big_int) rest)

(** val read_walls :
    shape -> Big_int_Z.big_int -> path -> json -> q list list result **)

let read_walls s more at_path value0 =
  let what = "rows, of a simplex two or more, and no more than it can have" in
  (match value0 with
   | Array items ->
     if (&&) (has_at_most (Z.add s.size_of_twist more) items)
          ((||) (Z.eqb more Big_int_Z.zero_big_int)
            (negb (has_at_most more items)))
     then each (read_twist s) at_path items
     else expected what at_path value0
   | _ -> expected what at_path value0)

(** val read_answers :
    shape -> path -> json -> (Big_int_Z.big_int * q list list) result **)

let read_answers s at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[contact, forces]" at_path value0
   | contact0 :: l ->
     (match l with
      | [] -> expected "[contact, forces]" at_path value0
      | forces :: l0 ->
        (match l0 with
         | [] ->
           bind (read_index at_path contact0) (fun i ->
             bind
               (read_sized s.size_of_twist
                 "a force for each component of a wrench" (read_friction s i)
                 at_path forces) (fun them -> Fine (i, them)))
         | _ :: _ -> expected "[contact, forces]" at_path value0)))
| _ -> expected "[contact, forces]" at_path value0

(** val read_at_rest : shape -> path -> json -> part result **)

let read_at_rest s at_path value0 =
  bind
    (members_in_order ("rest" :: ("answers" :: ("reach" :: []))) at_path
      value0) (fun members ->
    bind (member "rest" (read_shares s) at_path members) (fun f ->
      bind
        (member "answers"
          (read_array "an array [[contact, forces], ...]" (read_answers s))
          at_path members) (fun g ->
        bind (member "reach" (read_twist s) at_path members) (fun z0 -> Fine
          (PartAtRest (f, g, z0))))))

(** val read_presses :
    shape -> path -> json -> (Big_int_Z.big_int * q list) result **)

let read_presses s at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[contact, numbers]" at_path value0
   | contact0 :: l ->
     (match l with
      | [] -> expected "[contact, numbers]" at_path value0
      | numbers0 :: l0 ->
        (match l0 with
         | [] ->
           bind (read_index at_path contact0) (fun i ->
             bind (read_twist s at_path numbers0) (fun them -> Fine (i, them)))
         | _ :: _ -> expected "[contact, numbers]" at_path value0)))
| _ -> expected "[contact, numbers]" at_path value0

(** val read_sticking : shape -> path -> json -> part result **)

let read_sticking s at_path value0 =
  bind
    (members_in_order
      ("sticking" :: ("friction" :: ("presses" :: ("answers" :: ("reach" :: ("energy" :: []))))))
      at_path value0) (fun members ->
    bind (member "sticking" (read_twist s) at_path members) (fun d ->
      bind (member "friction" (read_shares s) at_path members) (fun f ->
        bind
          (member "presses"
            (read_array "an array [[contact, numbers], ...]" (read_presses s))
            at_path members) (fun h ->
          bind
            (member "answers"
              (read_array "an array [[contact, forces], ...]"
                (read_answers s)) at_path members) (fun g ->
            bind (member "reach" (read_twist s) at_path members) (fun z0 ->
              bind (member "energy" read_fraction at_path members) (fun c ->
                Fine (PartSticking (d, f, h, g, z0, c)))))))))

(** val read_part : shape -> path -> json -> part result **)

let read_part s at_path value0 =
  if names_member "rest" value0
  then read_at_rest s at_path value0
  else if names_member "sticking" value0
       then read_sticking s at_path value0
       else (match value0 with
             | Array _ ->
               bind (read_node s at_path value0) (fun it ->
                 match it with
                 | Cut (p, i, c) -> Fine (PartCut (p, i, c))
                 | _ -> expected "a part" at_path value0)
             | _ ->
               let has = fun name ->
                 match value0 with
                 | Object members -> has_member name members
                 | _ -> false
               in
               let simplex = has "simplex" in
               let walls0 = if simplex then "simplex" else "walls" in
               let opens0 = has "open" in
               bind
                 (members_in_order
                   ("twist" :: (app (if opens0 then "open" :: [] else [])
                                 (walls0 :: ("direction" :: ("tree" :: [])))))
                   at_path value0) (fun members ->
                 bind (member "twist" (read_twist s) at_path members)
                   (fun d ->
                   bind
                     (if opens0
                      then member "open"
                             (read_array "an array of contacts" read_index)
                             at_path members
                      else Fine []) (fun o ->
                     bind
                       (member walls0
                         (read_walls s
                           (if simplex
                            then Big_int_Z.unit_big_int
                            else Big_int_Z.zero_big_int)) at_path members)
                       (fun e ->
                       bind
                         (member "direction" (read_matrix s) at_path members)
                         (fun a ->
                         bind (member "tree" (read_nodes s) at_path members)
                           (fun tree -> Fine (PartProof (d, o, simplex, e, a,
                           tree)))))))))

(** val read_segment_by_degree : shape -> path -> json -> segment result **)

let read_segment_by_degree s at_path value0 =
  bind
    (members_in_order
      ("to" :: ("twists" :: ("walls" :: ("direction" :: ("tree" :: [])))))
      at_path value0) (fun members ->
    bind (member "to" read_or_null at_path members) (fun b ->
      bind
        (member "twists"
          (read_sized (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)
            "two twists" (read_twist s)) at_path members) (fun twists ->
        bind (member "walls" (read_matrix s) at_path members) (fun e ->
          bind (member "direction" (read_matrix s) at_path members) (fun a ->
            bind (member "tree" (read_nodes s) at_path members) (fun tree ->
              Fine (SegmentByDegree (b, (nth O twists []),
              (nth (S O) twists []), e, a, tree))))))))

(** val read_segments_from :
    shape -> bool -> Big_int_Z.big_int -> path -> json list -> segment list
    -> segment list result **)

let rec read_segments_from s goes_on index at_path items done0 =
  match items with
  | [] -> Fine (rev_append done0 [])
  | item :: rest ->
    (match item with
     | Object members ->
       (match read_segment_by_degree s ((Element index) :: at_path) (Object
                members) with
        | Fine it ->
          read_segments_from s false (Z.add index Big_int_Z.unit_big_int)
            at_path rest (it :: done0)
        | Malformed (where_, found, problem) ->
          Malformed (where_, found, problem))
     | _ ->
       (match read_segment s goes_on ((Element index) :: at_path) item with
        | Fine it ->
          let ends0 =
            match it with
            | Segment (_, second) ->
              let { multiple = multiple0; point_witness = _ } = second in
              (match multiple0 with
               | Some _ -> true
               | None -> false)
            | SegmentByDegree (_, _, _, _, _, _) -> false
          in
          read_segments_from s ends0 (Z.add index Big_int_Z.unit_big_int)
            at_path rest (it :: done0)
        | Malformed (where_, found, problem) ->
          Malformed (where_, found, problem)))

(** val read_segments : shape -> path -> json -> segment list result **)

let read_segments s at_path value0 = match value0 with
| Array items ->
  read_segments_from s false Big_int_Z.zero_big_int at_path items []
| _ -> expected "an array of segments" at_path value0

(** val read_spatial_point : shape -> path -> json -> witness result **)

let read_spatial_point s at_path value0 =
  bind (members_in_order ("twist" :: ("shares" :: [])) at_path value0)
    (fun members ->
    bind (member "twist" (read_twist s) at_path members) (fun d ->
      bind (member "shares" (read_shares s) at_path members) (fun them ->
        Fine { twist = d; shares = them })))

(** val is_point0 : json -> bool **)

let is_point0 = function
| Object members -> has_member "shares" members
| _ -> false

(** val read_claim : shape -> path -> json -> claim result **)

let read_claim s at_path value0 =
  let what =
    (^)
      "[\"stable\", low, high, part], [\"stable\", low, high, point, point] or "
      "[\"unstable\", low, high, tree]"
  in
  let one_or_two = "one point where low = high or high is null, else two" in
  (match value0 with
   | Array items ->
     (match items with
      | [] -> expected what at_path value0
      | kind :: l ->
        (match l with
         | [] -> expected what at_path value0
         | a :: l0 ->
           (match l0 with
            | [] -> expected what at_path value0
            | b :: evidence ->
              bind (read_fraction at_path a) (fun a0 ->
                bind (read_or_null at_path b) (fun b0 ->
                  let two =
                    match b0 with
                    | Some b1 -> negb (qeq_bool a0 b1)
                    | None -> false
                  in
                  if is_text "stable" kind
                  then (match evidence with
                        | [] -> expected what at_path value0
                        | only :: l1 ->
                          (match l1 with
                           | [] ->
                             if is_point0 only
                             then bind
                                    (check_that (negb two) at_path one_or_two)
                                    (fun _ ->
                                    bind (read_spatial_point s at_path only)
                                      (fun p -> Fine (ClaimStable (a0, b0,
                                      (Inr (p :: []))))))
                             else bind (read_part s at_path only) (fun it ->
                                    Fine (ClaimStable (a0, b0, (Inl it))))
                           | second :: l2 ->
                             (match l2 with
                              | [] ->
                                bind (check_that two at_path one_or_two)
                                  (fun _ ->
                                  bind (read_spatial_point s at_path only)
                                    (fun p ->
                                    bind
                                      (read_spatial_point s at_path second)
                                      (fun q0 -> Fine (ClaimStable (a0, b0,
                                      (Inr (p :: (q0 :: []))))))))
                              | _ :: _ -> expected what at_path value0)))
                  else if is_text "unstable" kind
                       then (match evidence with
                             | [] -> expected what at_path value0
                             | tree :: l1 ->
                               (match l1 with
                                | [] ->
                                  bind (read_nodes s at_path tree) (fun it ->
                                    Fine (ClaimUnstable (a0, b0, it)))
                                | _ :: _ -> expected what at_path value0))
                       else expected what at_path value0)))))
   | _ -> expected what at_path value0)

(** val read_multiplier : path -> json -> (Big_int_Z.big_int * q) result **)

let read_multiplier at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[contact, number]" at_path value0
   | contact0 :: l ->
     (match l with
      | [] -> expected "[contact, number]" at_path value0
      | number :: l0 ->
        (match l0 with
         | [] ->
           bind (read_index at_path contact0) (fun i ->
             bind (read_fraction at_path number) (fun x -> Fine (i, x)))
         | _ :: _ -> expected "[contact, number]" at_path value0)))
| _ -> expected "[contact, number]" at_path value0

(** val read_rigid_node : shape -> path -> json -> rigid_node result **)

let read_rigid_node s at_path value0 =
  let problem =
    if s.spatial
    then "touch and a contact, slip, a contact and a vector, or leaf, t, y and two lists"
    else "touch or slip and a contact, or leaf, t, y and two lists"
  in
  (match value0 with
   | Array items ->
     (match items with
      | [] -> expected problem at_path value0
      | j :: l ->
        (match j with
         | Text kind ->
           (match l with
            | [] -> expected problem at_path value0
            | t :: l0 ->
              (match l0 with
               | [] ->
                 if (=) kind "touch"
                 then bind (read_index at_path t) (fun i -> Fine (RTouch i))
                 else if (&&) ((=) kind "slip") (negb s.spatial)
                      then bind (read_index at_path t) (fun i -> Fine (RSlip
                             (i, [])))
                      else expected problem at_path value0
               | y :: l1 ->
                 (match l1 with
                  | [] ->
                    if (&&) ((=) kind "slip") s.spatial
                    then bind (read_index at_path t) (fun i ->
                           bind
                             (read_numbers
                               ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                               Big_int_Z.unit_big_int) at_path y) (fun d ->
                             Fine (RSlip (i, d))))
                    else expected problem at_path value0
                  | along :: l2 ->
                    (match l2 with
                     | [] -> expected problem at_path value0
                     | across0 :: l3 ->
                       (match l3 with
                        | [] ->
                          if (=) kind "leaf"
                          then bind (read_fraction at_path t) (fun t0 ->
                                 bind (read_twist s at_path y) (fun y0 ->
                                   bind
                                     (read_array
                                       "an array [[contact, number], ...]"
                                       read_multiplier at_path along)
                                     (fun g ->
                                     bind (read_shares s at_path across0)
                                       (fun h -> Fine (RLeaf (t0, y0, g, h))))))
                          else expected problem at_path value0
                        | _ :: _ -> expected problem at_path value0)))))
         | _ -> expected problem at_path value0))
   | _ -> expected problem at_path value0)

(** val next :
    string -> (string * json) list -> (json * (string * json) list) result **)

let next name = function
| [] -> refuse [] ((^) "the object ends, expected \"" ((^) name "\""))
| p :: rest ->
  let (key, value0) = p in
  if (=) key name
  then Fine (value0, rest)
  else refuse ((Member key) :: [])
         ((^) "expected the member \"" ((^) name "\" here"))

(** val next_read :
    string -> (path -> json -> 'a1 result) -> (string * json) list ->
    ('a1 * (string * json) list) result **)

let next_read name read members =
  bind (next name members) (fun pat ->
    let (value0, rest) = pat in
    bind (read ((Member name) :: []) value0) (fun it -> Fine (it, rest)))

(** val begins_with : string -> (string * json) list -> bool **)

let begins_with name = function
| [] -> false
| p :: _ -> let (key, _) = p in (=) key name

(** val finish : ('a1 * (string * json) list) -> 'a1 result **)

let finish = function
| (value0, l) ->
  (match l with
   | [] -> Fine value0
   | p :: _ ->
     let (key, _) = p in refuse ((Member key) :: []) "a member too many")

(** val default_bits : Big_int_Z.big_int **)

let default_bits =
  (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
    (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int)))))))

(** val read_bits : path -> json -> Big_int_Z.big_int result **)

let read_bits at_path value0 =
  bind (read_index at_path value0) (fun b ->
    if (&&)
         (Z.leb (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           Big_int_Z.unit_big_int)))))) b)
         (Z.leb b (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           (Big_int_Z.mult_int_big_int 2 (Big_int_Z.mult_int_big_int 2
           Big_int_Z.unit_big_int)))))))))))))
    then Fine b
    else expected "an integer from 64 to 4096" at_path value0)

(** val read_verdict : shape -> path -> json -> bool result **)

let read_verdict s at_path value0 =
  if s.of_margin
  then if is_text "margin" value0
       then Fine true
       else expected "\"margin\", as the question has a direction" at_path
              value0
  else if is_text "stable" value0
       then Fine true
       else if is_text "unstable" value0
            then Fine false
            else expected
                   "\"stable\" or \"unstable\", as the question has no direction"
                   at_path value0

(** val read_body0 : shape -> bool -> (string * json) list -> proof result **)

let read_body0 s good members =
  if s.of_margin
  then if s.of_claims
       then bind
              (next_read "intervals"
                (read_array "an array of claims" (read_claim s)) members)
              (fun it ->
              bind (finish it) (fun claims -> Fine (MarginInSpace claims)))
       else bind
              (next_read "resisted"
                (read_array "an array of intervals" read_resisted) members)
              (fun pat ->
              let (resisted, rest) = pat in
              bind (next_read "segments" (read_segments s) rest) (fun pat0 ->
                let (segments, rest0) = pat0 in
                bind (next_read "tree" (read_nodes s) rest0) (fun it ->
                  bind (finish it) (fun tree -> Fine (MarginBy (resisted,
                    segments, tree))))))
  else if good
       then if begins_with "parts" members
            then bind
                   (next_read "parts"
                     (read_array "an array of parts" (read_part s)) members)
                   (fun it ->
                   bind (finish it) (fun parts -> Fine (StableByParts parts)))
            else bind (next_read "twist" (read_twist s) members) (fun pat ->
                   let (d, rest) = pat in
                   bind (next_read "shares" (read_shares s) rest) (fun it ->
                     bind (finish it) (fun them -> Fine (StableByWitness
                       { twist = d; shares = them }))))
       else bind (next_read "tree" (read_nodes s) members) (fun it ->
              bind (finish it) (fun tree -> Fine (UnstableByTree tree)))

(** val read_load_point : shape -> path -> json -> load_point result **)

let read_load_point s at_path value0 =
  let what =
    "[\"at\", s, t, twist, shares] or [\"towards\", s, t, twist, shares]"
  in
  (match value0 with
   | Array items ->
     (match items with
      | [] -> expected what at_path value0
      | kind :: l ->
        (match l with
         | [] -> expected what at_path value0
         | a :: l0 ->
           (match l0 with
            | [] -> expected what at_path value0
            | b :: l1 ->
              (match l1 with
               | [] -> expected what at_path value0
               | motion :: l2 ->
                 (match l2 with
                  | [] -> expected what at_path value0
                  | list0 :: l3 ->
                    (match l3 with
                     | [] ->
                       if (||) (is_text "at" kind) (is_text "towards" kind)
                       then bind (read_fraction at_path a) (fun a0 ->
                              bind (read_fraction at_path b) (fun b0 ->
                                bind (read_twist s at_path motion) (fun d ->
                                  bind (read_shares s at_path list0)
                                    (fun them -> Fine { is_at =
                                    (is_text "at" kind); along_u = a0;
                                    along_v = b0; load_witness = { twist = d;
                                    shares = them } }))))
                       else expected what at_path value0
                     | _ :: _ -> expected what at_path value0))))))
   | _ -> expected what at_path value0)

(** val read_region : shape -> (string * json) list -> proof result **)

let read_region s members =
  bind (next "verdict" members) (fun pat ->
    let (verdict, rest) = pat in
    if is_text "region" verdict
    then bind
           (next_read "pieces"
             (read_array "an array of pieces"
               (read_array "an array of points" (read_load_point s))) rest)
           (fun pat0 ->
           let (pieces, rest0) = pat0 in
           bind (next_read "tree" (read_nodes s) rest0) (fun it ->
             bind (finish it) (fun tree -> Fine (RegionBy (pieces, tree)))))
    else expected "\"region\", as the question has a plane" ((Member
           "verdict") :: []) verdict)

(** val read_class : shape -> (string * json) list -> proof result **)

let read_class s members =
  bind (next "verdict" members) (fun pat ->
    let (verdict, rest) = pat in
    if is_text "must move" verdict
    then bind (next_read "twist" (read_twist s) rest) (fun it ->
           bind (finish it) (fun y -> Fine (OfClass (ByTwist y))))
    else if is_text "must hold" verdict
         then bind (next_read "rest" (read_forces s) rest) (fun pat0 ->
                let (f, rest0) = pat0 in
                bind
                  (next_read "tree"
                    (read_array "an array of nodes" (read_rigid_node s))
                    rest0) (fun it ->
                  bind (finish it) (fun tree -> Fine (OfClass (ByTree (f,
                    tree))))))
         else if is_text "open" verdict
              then bind (next_read "rest" (read_forces s) rest) (fun pat0 ->
                     let (f, rest0) = pat0 in
                     bind (next_read "acceleration" (read_twist s) rest0)
                       (fun pat1 ->
                       let (a, rest1) = pat1 in
                       bind (next_read "forces" (read_forces s) rest1)
                         (fun it ->
                         bind (finish it) (fun g -> Fine (OfClass (ByMotion
                           (f, a, g)))))))
              else expected
                     "must move, must hold or open, as the question has an inertia"
                     ((Member "verdict") :: []) verdict)

(** val read_stand :
    shape -> path -> json -> (q list * stated_forces) result **)

let read_stand s at_path value0 = match value0 with
| Array items ->
  (match items with
   | [] -> expected "[load point, forces]" at_path value0
   | point0 :: l ->
     (match l with
      | [] -> expected "[load point, forces]" at_path value0
      | forces :: l0 ->
        (match l0 with
         | [] ->
           bind
             (read_sized
               (if s.of_plane
                then ((fun x -> Big_int_Z.succ_big_int (Big_int_Z.mult_int_big_int 2 x))
                       Big_int_Z.unit_big_int)
                else (Big_int_Z.mult_int_big_int 2 Big_int_Z.unit_big_int))
               "an array of the numbers of a load point" read_fraction
               at_path point0) (fun x ->
             bind (read_forces s at_path forces) (fun f -> Fine (x, f)))
         | _ :: _ -> expected "[load point, forces]" at_path value0)))
| _ -> expected "[load point, forces]" at_path value0

(** val read_statics : shape -> (string * json) list -> proof result **)

let read_statics s members =
  bind (next "verdict" members) (fun pat ->
    let (verdict, rest) = pat in
    if (||) s.of_plane s.of_margin
    then if is_text (if s.of_plane then "region" else "margin") verdict
         then bind
                (next_read "stand"
                  (read_array "an array of load points with forces"
                    (read_stand s)) rest) (fun pat0 ->
                let (stand, rest0) = pat0 in
                bind
                  (next_read "move"
                    (read_array "an array of twists" (read_twist s)) rest0)
                  (fun it ->
                  bind (finish it) (fun move -> Fine (OfStatics (ByPoints
                    (stand, move))))))
         else expected
                (if s.of_plane
                 then "\"region\", as the question has a plane"
                 else "\"margin\", as the question has a direction") ((Member
                "verdict") :: []) verdict
    else if is_text "may stand" verdict
         then bind (next_read "forces" (read_forces s) rest) (fun it ->
                bind (finish it) (fun f -> Fine (OfStatics (ByForces f))))
         else if is_text "must move" verdict
              then bind (next_read "twist" (read_twist s) rest) (fun it ->
                     bind (finish it) (fun y -> Fine (OfStatics (ByMove y))))
              else expected
                     "\"may stand\" or \"must move\", as the question is of statics"
                     ((Member "verdict") :: []) verdict)

(** val read_known_format : path -> json -> unit result **)

let read_known_format at_path value0 =
  if is_text "stickslip-certificate/2" value0
  then Fine ()
  else expected
         "\"stickslip-certificate/2\", the only one that this program knows"
         at_path value0

(** val read_certificate :
    question -> json -> (statement * certificate) result **)

let read_certificate q0 value0 =
  let asked = fun margin plane class1 statics0 -> { spatial =
    (match q0.several with
     | Some its -> its.bodies_in_space
     | None -> Nat.eqb q0.dimension (S (S (S (S (S (S O))))))); of_bodies =
    (match q0.several with
     | Some _ -> true
     | None -> false); size_of_twist = (Z.of_nat q0.dimension); soft =
    (map_all (fun it -> negb (is_0 it.torsion)) q0.contacts); of_claims =
    (has_claims q0); of_margin = margin; of_plane = plane; of_class = class1;
    of_statics = statics0 }
  in
  (match value0 with
   | Object members ->
     bind (next_read "format" read_known_format members) (fun pat ->
       let (_, rest) = pat in
       bind
         (if begins_with "producer" rest
          then bind (next_read "producer" read_any_text rest) (fun pat0 ->
                 let (_, rest0) = pat0 in Fine rest0)
          else Fine rest) (fun rest0 ->
         bind
           (next_read "question"
             (read_statement (asked false false false false)) rest0)
           (fun pat0 ->
           let (stated0, rest1) = pat0 in
           let o = stated0.options_stated in
           let s =
             asked (asks_margin o) (asks_plane o)
               ((&&) (asks_class o)
                 (negb
                   ((||) ((||) (asks_margin o) (asks_plane o))
                     (asks_statics o)))) (asks_statics o)
           in
           bind
             (if (&&)
                   ((&&) (begins_with "bits" rest1)
                     ((||) (negb s.of_margin) s.of_claims))
                   (negb ((||) ((||) s.of_class s.of_plane) s.of_statics))
              then next_read "bits" read_bits rest1
              else Fine (default_bits, rest1)) (fun pat1 ->
             let (b, rest2) = pat1 in
             if s.of_statics
             then bind (read_statics s rest2) (fun it -> Fine (stated0,
                    { bits = b; body = it }))
             else if s.of_plane
                  then bind (read_region s rest2) (fun it -> Fine (stated0,
                         { bits = b; body = it }))
                  else if s.of_class
                       then bind (read_class s rest2) (fun it -> Fine
                              (stated0, { bits = b; body = it }))
                       else bind (next_read "verdict" (read_verdict s) rest2)
                              (fun pat2 ->
                              let (good, rest3) = pat2 in
                              bind (read_body0 s good rest3) (fun it -> Fine
                                (stated0, { bits = b; body = it })))))))
   | _ -> expected "an object {...}" [] value0)

(** val same_list : ('a1 -> 'a1 -> bool) -> 'a1 list -> 'a1 list -> bool **)

let rec same_list same0 a b =
  match a with
  | [] -> (match b with
           | [] -> true
           | _ :: _ -> false)
  | x :: others0 ->
    (match b with
     | [] -> false
     | y :: rest -> (&&) (same0 x y) (same_list same0 others0 rest))

(** val same_option :
    ('a1 -> 'a1 -> bool) -> 'a1 option -> 'a1 option -> bool **)

let same_option same0 a b =
  match a with
  | Some x -> (match b with
               | Some y -> same0 x y
               | None -> false)
  | None -> (match b with
             | Some _ -> false
             | None -> true)

(** val same_interval : interval -> interval -> bool **)

let same_interval a b =
  (&&) (qeq_bool a.low b.low) (qeq_bool a.high b.high)

(** val same_growth : growth -> growth -> bool **)

let same_growth a b =
  match a with
  | Scale -> (match b with
              | Scale -> true
              | By _ -> false)
  | By x -> (match b with
             | Scale -> false
             | By y -> same_list qeq_bool x y)

(** val same_tolerance : tolerance -> tolerance -> bool **)

let same_tolerance a b =
  (&&) (qeq_bool a.amount b.amount) (eqb a.percent b.percent)

(** val same_ball : stated_ball -> stated_ball -> bool **)

let same_ball a b =
  (&&)
    ((&&)
      ((&&) (qeq_bool a.stated_radius b.stated_radius)
        (qeq_bool a.stated_length b.stated_length))
      (same_list qeq_bool a.stated_point b.stated_point))
    (same_option (=) a.stated_body b.stated_body)

(** val same_bound : bound_option -> bound_option -> bool **)

let same_bound a b =
  match a with
  | Unbounded -> (match b with
                  | Unbounded -> true
                  | Bounded _ -> false)
  | Bounded x ->
    (match b with
     | Unbounded -> false
     | Bounded y -> same_list qeq_bool x y)

(** val broken_question_rule : statement -> posed -> string option **)

let broken_question_rule stated0 asked =
  let said = stated0.options_stated in
  let options0 = asked.the_options in
  let count0 = fun items ->
    fold_left (fun count0 _ -> Z.add count0 Big_int_Z.unit_big_int) items
      Big_int_Z.zero_big_int
  in
  let q0 = asked.the_question in
  let m =
    Z.add (count0 q0.contacts)
      (match q0.several with
       | Some its -> count0 its.elements
       | None -> Big_int_Z.zero_big_int)
  in
  if negb (Z.eqb stated0.stated_contacts m)
  then Some "question-contacts"
  else if negb
            (same_list same_interval stated0.wrench_stated
              asked.stated_wrench)
       then Some "question-wrench"
       else if negb
                 (same_option qeq_bool said.asked_preload
                   options0.asked_preload)
            then Some "question-preload"
            else if negb (eqb said.asked_bilateral options0.asked_bilateral)
                 then Some "question-law"
                 else if negb
                           (same_option (same_list qeq_bool)
                             said.asked_direction options0.asked_direction)
                      then Some "question-direction"
                      else if negb
                                (same_option same_growth said.asked_growth
                                  options0.asked_growth)
                           then Some "question-preload-direction"
                           else if negb
                                     (same_option (fun a b ->
                                       (&&)
                                         (same_list qeq_bool (fst a) (fst b))
                                         (same_list qeq_bool (snd a) (snd b)))
                                       said.asked_plane options0.asked_plane)
                                then Some "question-plane"
                                else if negb
                                          (same_option (same_list qeq_bool)
                                            said.asked_inertia
                                            options0.asked_inertia)
                                     then Some "question-inertia"
                                     else if negb
                                               (same_option qeq_bool
                                                 said.asked_statics
                                                 options0.asked_statics)
                                          then Some "question-statics"
                                          else if negb
                                                    ((&&)
                                                      (forallb (fun kind ->
                                                        same_option
                                                          same_tolerance
                                                          (find_tolerance
                                                            kind said)
                                                          (find_tolerance
                                                            kind options0))
                                                        uncertain_kinds)
                                                      (same_option same_ball
                                                        said.asked_ball
                                                        options0.asked_ball))
                                               then Some "question-uncertain"
                                               else if negb
                                                         (same_option
                                                           same_bound
                                                           said.asked_bound
                                                           options0.asked_bound)
                                                    then Some
                                                           "question-max-motion"
                                                    else None

(** val ask : options -> json -> posed result **)

let ask asked file =
  bind (read_file file) (fun it -> pose it asked)

(** val judge : oracle -> posed -> json -> (answer * certificate) result **)

let judge advisor asked text =
  let q0 = asked.the_question in
  bind (read_certificate q0 text) (fun pat ->
    let (stated0, it) = pat in
    (match broken_question_rule stated0 asked with
     | Some rule -> Fine ((Rejected (rule, Nowhere)), it)
     | None -> Fine ((check advisor q0 it), it)))
