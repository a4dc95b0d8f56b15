
val negb : bool -> bool

type nat =
| O
| S of nat

type ('a, 'b) sum =
| Inl of 'a
| Inr of 'b

val fst : ('a1 * 'a2) -> 'a1

val snd : ('a1 * 'a2) -> 'a2

val length : 'a1 list -> nat

val app : 'a1 list -> 'a1 list -> 'a1 list

type comparison =
| Eq
| Lt
| Gt

val pred : nat -> nat

val add : nat -> nat -> nat

val mul : nat -> nat -> nat

val sub : nat -> nat -> nat

val eqb : bool -> bool -> bool

val gmax : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 -> 'a1

val gmin : ('a1 -> 'a1 -> comparison) -> 'a1 -> 'a1 -> 'a1

module Nat :
 sig
  val sub : nat -> nat -> nat

  val eqb : nat -> nat -> bool

  val leb : nat -> nat -> bool

  val ltb : nat -> nat -> bool

  val divmod : nat -> nat -> nat -> nat -> nat * nat

  val modulo : nat -> nat -> nat

  val iter : nat -> ('a1 -> 'a1) -> 'a1 -> 'a1
 end

module Pos :
 sig
  type mask =
  | IsNul
  | IsPos of Big_int_Z.big_int
  | IsNeg
 end

module Coq_Pos :
 sig
  val succ : Big_int_Z.big_int -> Big_int_Z.big_int

  val add : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val add_carry : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val pred_double : Big_int_Z.big_int -> Big_int_Z.big_int

  val pred_N : Big_int_Z.big_int -> Big_int_Z.big_int

  type mask = Pos.mask =
  | IsNul
  | IsPos of Big_int_Z.big_int
  | IsNeg

  val succ_double_mask : mask -> mask

  val double_mask : mask -> mask

  val double_pred_mask : Big_int_Z.big_int -> mask

  val sub_mask : Big_int_Z.big_int -> Big_int_Z.big_int -> mask

  val sub_mask_carry : Big_int_Z.big_int -> Big_int_Z.big_int -> mask

  val sub : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val mul : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val iter : ('a1 -> 'a1) -> 'a1 -> Big_int_Z.big_int -> 'a1

  val div2 : Big_int_Z.big_int -> Big_int_Z.big_int

  val div2_up : Big_int_Z.big_int -> Big_int_Z.big_int

  val size_nat : Big_int_Z.big_int -> nat

  val size : Big_int_Z.big_int -> Big_int_Z.big_int

  val compare_cont :
    comparison -> Big_int_Z.big_int -> Big_int_Z.big_int -> comparison

  val compare : Big_int_Z.big_int -> Big_int_Z.big_int -> comparison

  val eqb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

  val leb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

  val sqrtrem_step :
    (Big_int_Z.big_int -> Big_int_Z.big_int) -> (Big_int_Z.big_int ->
    Big_int_Z.big_int) -> (Big_int_Z.big_int * mask) ->
    Big_int_Z.big_int * mask

  val sqrtrem : Big_int_Z.big_int -> Big_int_Z.big_int * mask

  val sqrt : Big_int_Z.big_int -> Big_int_Z.big_int

  val gcdn :
    nat -> Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val gcd : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_Nsucc_double : Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_Ndouble : Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_lor : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_land : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val ldiff : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val iter_op : ('a1 -> 'a1 -> 'a1) -> Big_int_Z.big_int -> 'a1 -> 'a1

  val to_nat : Big_int_Z.big_int -> nat

  val of_succ_nat : nat -> Big_int_Z.big_int
 end

module N :
 sig
  val succ_pos : Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_lor : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_land : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val ldiff : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int
 end

val hd : 'a1 -> 'a1 list -> 'a1

val tl : 'a1 list -> 'a1 list

val nth : nat -> 'a1 list -> 'a1 -> 'a1

val nth_error : 'a1 list -> nat -> 'a1 option

val removelast : 'a1 list -> 'a1 list

val rev_append : 'a1 list -> 'a1 list -> 'a1 list

val concat : 'a1 list list -> 'a1 list

val map : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val flat_map : ('a1 -> 'a2 list) -> 'a1 list -> 'a2 list

val fold_left : ('a1 -> 'a2 -> 'a1) -> 'a2 list -> 'a1 -> 'a1

val fold_right : ('a2 -> 'a1 -> 'a1) -> 'a1 -> 'a2 list -> 'a1

val existsb : ('a1 -> bool) -> 'a1 list -> bool

val forallb : ('a1 -> bool) -> 'a1 list -> bool

val filter : ('a1 -> bool) -> 'a1 list -> 'a1 list

val find : ('a1 -> bool) -> 'a1 list -> 'a1 option

val combine : 'a1 list -> 'a2 list -> ('a1 * 'a2) list

val firstn : nat -> 'a1 list -> 'a1 list

val skipn : nat -> 'a1 list -> 'a1 list

val seq : nat -> nat -> nat list

val repeat : 'a1 -> nat -> 'a1 list

module Z :
 sig
  val double : Big_int_Z.big_int -> Big_int_Z.big_int

  val succ_double : Big_int_Z.big_int -> Big_int_Z.big_int

  val pred_double : Big_int_Z.big_int -> Big_int_Z.big_int

  val pos_sub : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val add : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val opp : Big_int_Z.big_int -> Big_int_Z.big_int

  val sub : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val mul : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val pow_pos : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val pow : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val compare : Big_int_Z.big_int -> Big_int_Z.big_int -> comparison

  val sgn : Big_int_Z.big_int -> Big_int_Z.big_int

  val leb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

  val ltb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

  val eqb : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

  val max : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val abs : Big_int_Z.big_int -> Big_int_Z.big_int

  val to_nat : Big_int_Z.big_int -> nat

  val of_nat : nat -> Big_int_Z.big_int

  val of_N : Big_int_Z.big_int -> Big_int_Z.big_int

  val to_pos : Big_int_Z.big_int -> Big_int_Z.big_int

  val pos_div_eucl :
    Big_int_Z.big_int -> Big_int_Z.big_int ->
    Big_int_Z.big_int * Big_int_Z.big_int

  val div_eucl :
    Big_int_Z.big_int -> Big_int_Z.big_int ->
    Big_int_Z.big_int * Big_int_Z.big_int

  val div : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val modulo : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val div2 : Big_int_Z.big_int -> Big_int_Z.big_int

  val log2 : Big_int_Z.big_int -> Big_int_Z.big_int

  val sqrt : Big_int_Z.big_int -> Big_int_Z.big_int

  val gcd : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val shiftl : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_lor : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val coq_land : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

  val lcm : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int
 end

val zeq_bool : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

type q = { qnum : Big_int_Z.big_int; qden : Big_int_Z.big_int }

val inject_Z : Big_int_Z.big_int -> q

val qcompare : q -> q -> comparison

val qeq_bool : q -> q -> bool

val qle_bool : q -> q -> bool

val qplus : q -> q -> q

val qmult : q -> q -> q

val qopp : q -> q

val qminus : q -> q -> q

val qinv : q -> q

val qdiv : q -> q -> q

val map_all : ('a1 -> 'a2) -> 'a1 list -> 'a2 list

val all_some_after :
  ('a1 -> 'a2 option) -> 'a1 list -> 'a2 list -> 'a2 list option

val all_some : ('a1 -> 'a2 option) -> 'a1 list -> 'a2 list option

val numbered : 'a1 list -> Big_int_Z.big_int -> 'a1 option

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

val bind : 'a1 result -> ('a1 -> 'a2 result) -> 'a2 result

val refuse : path -> string -> 'a1 result

val expected : string -> path -> json -> 'a1 result

val check_that : bool -> path -> string -> unit result

val is_text : string -> json -> bool

val each_from :
  (path -> 'a1 -> 'a2 result) -> Big_int_Z.big_int -> path -> 'a1 list -> 'a2
  list -> 'a2 list result

val each : (path -> 'a1 -> 'a2 result) -> path -> 'a1 list -> 'a2 list result

val read_array :
  string -> (path -> json -> 'a1 result) -> path -> json -> 'a1 list result

val find_member : string -> (string * json) list -> json option

val has_member : string -> (string * json) list -> bool

val is_among : string -> string list -> bool

val listed : string list -> string

val check_members : string list -> path -> (string * json) list -> unit result

val members_of : string list -> path -> json -> (string * json) list result

val after : string -> string list -> string list option

val check_order : string list -> path -> (string * json) list -> unit result

val members_in_order :
  string list -> path -> json -> (string * json) list result

val member :
  string -> (path -> json -> 'a1 result) -> path -> (string * json) list ->
  'a1 result

val optional_member :
  string -> (path -> json -> 'a1 result) -> path -> (string * json) list ->
  'a1 option result

type interval = { low : q; high : q }

val exactly : q -> interval

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

val class_of : class_proof -> class0

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

val qabs : q -> q

val qmax : q -> q -> q

val qmin : q -> q -> q

type form = Big_int_Z.big_int list

val dot : form -> form -> Big_int_Z.big_int

val combine0 : Big_int_Z.big_int -> form -> Big_int_Z.big_int -> form -> form

val all_zero : form -> bool

val content : form -> Big_int_Z.big_int

val primitive : form -> form

type ray = { coordinates : form; zeros : bool list; tight : Big_int_Z.big_int }

val both : bool list -> bool list -> bool list

val add_strict : form list -> ray -> ray

val common_zeros : form list list -> ray list -> bool list

val barred : form list list -> ray list -> bool

val common_denominator : q list -> Big_int_Z.big_int

type scaling = { over : Big_int_Z.big_int; times : Big_int_Z.big_int }

val numerator : Big_int_Z.big_int -> q -> Big_int_Z.big_int

val scaling_of : q list -> scaling

val to_integer : scaling -> q -> Big_int_Z.big_int

val up : Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int

val certain : interval -> bool

val ends : interval -> q list

type 'a multi =
| Tip of 'a
| Fork of 'a multi * 'a multi

val mmap : ('a1 -> 'a2) -> 'a1 multi -> 'a2 multi

val tips : 'a1 multi -> 'a1 list

val lows : 'a1 multi -> 'a1 multi

val highs : 'a1 multi -> 'a1 multi

val first_tip : 'a1 multi -> 'a1

val spread : interval -> (q -> 'a1 multi) -> 'a1 multi

val corners : interval list -> (q list -> 'a1) -> 'a1 multi

val product : (Big_int_Z.big_int multi * form multi) list -> form

val bernstein :
  nat -> (Big_int_Z.big_int multi * form multi) list -> form list

val power : nat -> Big_int_Z.big_int

val exact_root : q -> q option

val is_square : Big_int_Z.big_int -> bool

val reduced : q -> q

val root_between : Big_int_Z.big_int -> q -> interval

val root_above : q -> q

val root_below : q -> q

type cbox = { box_names : parameter list; box_geometry : interval list;
              box_forms : (q list -> q list list); box_friction : interval;
              box_preload : interval; box_growth : interval;
              box_stiffness : interval; box_square : q; box_normal : 
              q list; box_weights : q list; box_signed : bool;
              box_spring : bool; box_turns : bool;
              box_slack : (interval list -> q) }

val has_friction : cbox -> bool

type row = { box : cbox; forms : form list multi; forms_scale : scaling;
             metric : Big_int_Z.big_int list; metric_scale : scaling;
             slip_certain : bool; tau : form multi; minus_tau : form multi;
             edges_plus : form multi list; edges_minus : form multi list;
             edges_none : form multi list; pulls : form multi list;
             pull_scale : scaling; separates : form option; slack : q;
             parameters : nat; weight : Big_int_Z.big_int;
             over_weight : Big_int_Z.big_int }

val geometry_tree : cbox -> q list list multi

val add_multiple : q list -> q -> q list -> q list

val n_of : q list list -> q list

val edge_tree : cbox -> q -> q list multi

val pull_tree : cbox -> ((q * q) * q) -> q list multi

val scaling_of_trees : q list multi list -> scaling

val integer_tree : scaling -> q list multi -> form multi

val same_forms : form list -> bool

val negative : form -> form

val same_at_corners : q list multi -> bool

val vanishes : interval -> bool

val pull_certain : cbox -> bool

val count : interval list -> nat

val of_motion : form -> form

val minus_ends : interval -> q list

val full_range : interval -> q list

val preload_ends : cbox -> (q * q) list

val pull_ends : cbox -> ((q * q) * q) list

val forms_scaling : cbox -> scaling

val tau_tree : cbox -> q list multi

val pull_scaling : cbox -> scaling

val edge_scaling : cbox -> scaling

val corner_forms : cbox -> form list multi

val make_row : cbox -> row

val nowhere_negative : ray list -> form -> bool

val nowhere_positive : ray list -> form -> bool

val zeros_unless_negative :
  (form -> Big_int_Z.big_int) -> ray list -> ray list option

val positive_at_home :
  form list list -> ray list -> (form -> Big_int_Z.big_int) -> bool

val has_sign : form list list -> ray list -> form multi -> bool

val largest : Big_int_Z.big_int list -> Big_int_Z.big_int

type term =
| Nothing
| Line of Big_int_Z.big_int * form
| Bend of Big_int_Z.big_int * Big_int_Z.big_int * form list * bool

val value : term -> form -> Big_int_Z.big_int

val pull_tips : row -> form list

val collect :
  ('a1 -> term) -> 'a1 list -> form -> term list -> form * term list

val good_bound : nat -> q list option -> bool

val bound_forms :
  Big_int_Z.big_int -> Big_int_Z.big_int list -> form -> q list -> form list

val sum_form : q list -> form

val bound_conditions : q list option -> form list

val beyond_bound : q list option -> form list list -> ray list -> bool

val all_within : Big_int_Z.big_int -> q list -> form -> bool

val point_within : q list option -> form -> bool

val inner_of : form -> form -> form -> Big_int_Z.big_int

val slip_at : form list -> form -> form

val motion_of : ray -> form

val slips : form list multi -> ray list -> form list

val less_along : Big_int_Z.big_int list -> form -> form -> form -> bool

val nearest : Big_int_Z.big_int list -> form -> form list -> form option

type foot = { of_gens : form list; foot_m : Big_int_Z.big_int; foot_e : 
              form; foot_n : Big_int_Z.big_int; foot_d : Big_int_Z.big_int }

val foot_on : Big_int_Z.big_int list -> form -> form -> foot list

val foot_between : Big_int_Z.big_int list -> form -> form -> form -> foot list

val longer : foot -> foot -> foot

val foot_from :
  Big_int_Z.big_int list -> nat -> form -> form list -> foot -> foot option

val foot_of : Big_int_Z.big_int list -> form -> form list -> foot option

val nowhere_along : Big_int_Z.big_int list -> form list -> form -> bool

val separator : Big_int_Z.big_int list -> form list -> form -> form option

val outside :
  Big_int_Z.big_int list -> form list -> form list -> form -> form list option

val opposed_barred :
  Big_int_Z.big_int list -> form list -> form list -> bool list ->
  (form * ray) list -> bool

val must_move :
  Big_int_Z.big_int list -> form list list -> form list multi -> form list ->
  ray list -> bool

val most_along :
  Big_int_Z.big_int list -> form list -> form ->
  (bool * Big_int_Z.big_int) * Big_int_Z.big_int

val unit_of : scaling -> q

val largest_q : q list -> q

val friction_work :
  row -> q -> ((bool * Big_int_Z.big_int) * Big_int_Z.big_int) ->
  Big_int_Z.big_int -> q -> q

val corner_alpha : row -> q -> form -> form list -> bool -> form list -> q

val alpha : form list list -> ray list -> bool -> row -> q -> form -> q

val alpha_term : Big_int_Z.big_int -> q -> bool -> row -> term

val alpha_over : q -> row -> Big_int_Z.big_int

val ray_motion : form -> form

type vector = q list

type matrix = vector list

val inner : vector -> vector -> q

val plus_times : vector -> q -> vector -> vector

val is_zero : q -> bool

val unit_vector : nat -> nat -> vector

val identity : nat -> matrix

val of_rows : vector -> matrix -> vector

val pivot : nat -> matrix -> (vector * matrix) option

val eliminate :
  nat -> nat -> matrix -> (nat * vector) list -> (nat * vector) list

val kernel : nat -> matrix -> matrix

val inverse_of : nat -> matrix -> matrix

val same_vectors : vector -> vector -> bool

val same_matrices : matrix -> matrix -> bool

val is_inverse : nat -> matrix -> matrix -> bool

val all_of_length : nat -> 'a1 list list -> bool

val middle : interval -> q

val only_middle : interval -> interval

val middle_box : cbox -> cbox

val friction_sound : cbox -> bool

type addition = { ball_numbers : interval list; ball_ways : matrix;
                  ball_squares : q list }

val nothing_added : addition

type load = { load_box : interval list; load_growth : q list;
              load_added : addition }

val work_of_box : interval list -> vector -> interval

val sum_of_squares : vector -> vector -> q

val work_of_addition : addition -> vector -> interval

val work_of : load -> vector -> interval

val one_load : load -> bool

val nearest_to_zero : interval -> q

val middle_load : load -> load

val edges : form list list -> ray list -> row -> form multi list

val work_tree : form -> form multi -> Big_int_Z.big_int multi

val products_with : row -> Big_int_Z.big_int multi -> form list

val mixed_forms : row -> Big_int_Z.big_int multi -> form list

val bent : Big_int_Z.big_int -> row -> form list -> bool -> term

val edges_term :
  Big_int_Z.big_int -> form -> form multi list -> bool -> row -> term

val load_works : load -> q -> form -> q * q

val load_term : Big_int_Z.big_int -> (q * q) -> form

type way =
| Along of form multi list
| Most of q

type presser = { pressing : row; by_ : way; mixed : bool }

val way_of : form list list -> ray list -> bool -> q -> form -> row -> way

val pressers :
  form list list -> ray list -> Big_int_Z.big_int list -> q -> form -> row
  list -> Big_int_Z.big_int -> presser list -> presser list

val term_of : Big_int_Z.big_int -> form -> presser -> term

val with_all :
  Big_int_Z.big_int -> (q * q) -> q list -> presser list -> Big_int_Z.big_int

val leaf_holds_by :
  Big_int_Z.big_int -> presser list -> (q * q) -> q list -> form list list ->
  ray list -> form -> bool

val is_enclosure : interval -> q -> bool

val inverse_length : Big_int_Z.big_int -> bool -> q -> interval option

val is_loaded : contact -> bool

val plane_forms : q -> q -> q list -> q list list

val at_point : q -> q -> q -> q -> q -> q -> q list

val first_turn : q -> q -> q -> (q * q) * q

val cross_q : ((q * q) * q) -> ((q * q) * q) -> (q * q) * q

val square_of : ((q * q) * q) -> q

val space_forms :
  ((q * q) * q) -> ((q * q) * q) -> ((q * q) * q) -> q -> q list -> q list
  list

val greatest_square : interval -> q

val turned_slack : q -> q -> interval list -> q

val turn_within : q -> interval

val is_nonnegative : contact -> bool

val numbers :
  Big_int_Z.big_int -> contact -> q -> ((interval * interval) * interval)
  option

val enlarge : Big_int_Z.big_int -> contact -> cbox option

val with_turn : q list list -> q list list

val soften : q -> cbox -> cbox

val enlarge_finger : Big_int_Z.big_int -> contact -> cbox option

val dot_q : q list -> q list -> q

val lift_q : q list list -> q list -> q list

val lift_forms_q : q list list -> q list list -> q list list

val lift_box : q list list -> cbox -> cbox

val of_number_q : q list list -> nat option -> q list

val motion_of_body_q : nat -> q list -> q list list -> rigid_body -> q list

val motions_q : nat -> q list -> rigid_body list -> q list list -> q list list

val numbers_of : mechanism -> nat

val unit_q : nat -> q list

val unit_motions : nat -> mechanism -> q list list list

val columns : q list list list -> contact -> q list list

val element_box : element -> cbox

val mechanism_boxes :
  Big_int_Z.big_int -> nat -> mechanism -> contact list -> cbox list option

val h_of : form -> Big_int_Z.big_int

val twist_at : Big_int_Z.big_int -> form -> form -> form

type measure =
| Exactly of q * q * q * q
| Shortly of Big_int_Z.big_int * Big_int_Z.big_int * Big_int_Z.big_int

val exact_measure : row -> q -> measure

val shifted : Big_int_Z.big_int -> q -> Big_int_Z.big_int

val short_measure : row -> measure

val friction_within : measure -> Big_int_Z.big_int -> Big_int_Z.big_int -> q

type carrier = { carried : row; forms_scaled : scaling;
                 at_corners : form list list; measured : measure;
                 kappa : Big_int_Z.big_int; psi : form; may_open : bool }

val carrier_of :
  bool -> q -> row -> Big_int_Z.big_int -> form -> bool -> carrier

val psi_within : row -> Big_int_Z.big_int -> form -> bool

val stated :
  row -> Big_int_Z.big_int ->
  (Big_int_Z.big_int * (Big_int_Z.big_int * form)) list ->
  ((Big_int_Z.big_int * form) * (Big_int_Z.big_int * (Big_int_Z.big_int * form))
  list) * bool

val carriers :
  bool -> q -> ray list -> (Big_int_Z.big_int * (Big_int_Z.big_int * form))
  list -> row list -> Big_int_Z.big_int -> carrier list -> carrier list option

val corner_work : carrier -> form -> form -> form list -> q

val most_work : carrier -> q -> form -> form -> q

val scaled_work : Big_int_Z.big_int -> form -> q -> form -> carrier -> q

val load_work : load -> Big_int_Z.big_int -> form -> q -> form -> q

val all_works :
  load -> Big_int_Z.big_int -> form -> q -> carrier list -> form -> q list

type press = { opens : bool; least_pull : Big_int_Z.big_int;
               most_pull : Big_int_Z.big_int; effort : Big_int_Z.big_int }

val press_of : form -> carrier -> Big_int_Z.big_int -> press

val pressed : press -> press -> Big_int_Z.big_int

val presses_of : form -> carrier list -> Big_int_Z.big_int list -> press list

val pressed_all :
  press list -> press list -> Big_int_Z.big_int -> Big_int_Z.big_int

type at_ray = { the_ray : ray; at_h : Big_int_Z.big_int;
                load_effort : Big_int_Z.big_int; presses : press list }

val at_ray_of : carrier list -> ray -> Big_int_Z.big_int list -> at_ray

val work_between : at_ray -> at_ray -> Big_int_Z.big_int

val bound_of : at_ray -> at_ray -> Big_int_Z.big_int

val all_pairs : ('a1 -> 'a1 -> bool) -> 'a1 list -> bool

val moving_holds :
  form list list -> ray list -> load -> Big_int_Z.big_int -> form -> q ->
  carrier list -> bool

val direction_holds : ray list -> Big_int_Z.big_int -> form -> matrix -> bool

val contains : Big_int_Z.big_int -> Big_int_Z.big_int -> bool

type height = Big_int_Z.big_int * ray

val heights : form -> ray list -> height list

val join_form : form -> form -> Big_int_Z.big_int -> Big_int_Z.big_int -> form

val join : Big_int_Z.big_int -> height -> height -> ray

val parted : ray list -> ray -> ray -> bool

val distinct : height list -> bool

val stay : Big_int_Z.big_int -> height -> ray

val cut_line : Big_int_Z.big_int -> height -> height list -> ray list

val on_side : bool -> height list -> height list

val cut_rays : Big_int_Z.big_int -> ray list -> height list -> ray list

val most_combinations : height list -> Big_int_Z.big_int

val cut : nat -> height list -> ray list option

type 'setting region = { size0 : nat; sides : form list; rays : ray list;
                         strict : form list list; moving : form list list;
                         around : 'setting; depth : Big_int_Z.big_int }

type 'setting branch = { conditions : (form * bool) list;
                         new_strict : form list; new_moving : form list list;
                         branch_setting : 'setting }

val cut_above : oracle -> 'a1 region -> form -> 'a1 region

val cut_region : oracle -> 'a1 region -> (form * bool) -> 'a1 region

val strictly : 'a1 region -> form -> 'a1 region

val cut_foremost :
  oracle -> (form * bool) list -> 'a1 region -> (form * bool) list -> 'a1
  region

val cut_by : oracle -> 'a1 region -> (form * bool) list -> 'a1 region

val child : oracle -> 'a1 region -> 'a1 branch -> 'a1 region

val is_leaf : node -> bool

val at_leaf : 'a1 region -> form list list * ray list

val visit :
  oracle -> ('a1 -> node -> ('a1 branch list, string) sum) -> ('a1 -> form
  list list -> ray list -> node -> string option) -> Big_int_Z.big_int ->
  node -> 'a1 region -> ('a1 region list, string) sum

val walk :
  oracle -> ('a1 -> node -> ('a1 branch list, string) sum) -> ('a1 -> form
  list list -> ray list -> node -> string option) -> Big_int_Z.big_int ->
  node list -> 'a1 region list -> nat -> (string * nat) option

val basis : nat -> nat -> form list

val everywhere : nat -> 'a1 -> 'a1 region

val root : oracle -> nat -> 'a1 branch -> 'a1 region

val replace_after :
  'a1 list -> 'a1 list -> Big_int_Z.big_int -> 'a1 -> 'a1 list

val replace : 'a1 list -> Big_int_Z.big_int -> 'a1 -> 'a1 list

type range = { range_low : q; range_high : q option; open_low : bool;
               open_high : bool }

type pushing = { a_multiple : matrix; known_push : matrix }

val no_push : pushing

type setting = { dimension_of : nat; rows : row list; the_load : load;
                 pushes : pushing; slipping : Big_int_Z.big_int list;
                 short : Big_int_Z.big_int; exact : Big_int_Z.big_int;
                 the_bound : q list option }

val common_multiple : row list -> Big_int_Z.big_int

val short_multiple : row list -> Big_int_Z.big_int -> Big_int_Z.big_int

val make_setting :
  nat -> row list -> load -> pushing -> q list option -> setting

val without_bound : setting -> setting

val leaf_fails :
  setting -> form list list -> ray list -> q list -> string option

val moving_fails :
  setting -> form list list -> ray list -> q list -> q ->
  (Big_int_Z.big_int * (q * q list)) list -> string option

val end_fails :
  (Big_int_Z.big_int -> ray list -> string option) -> setting -> form list
  list -> ray list -> node -> string option

val no_pieces : Big_int_Z.big_int -> ray list -> string option

val is_inside : interval -> q -> bool

val low_half : interval -> q -> interval

val high_half : interval -> q -> interval

val same_parameter : parameter -> parameter -> bool

val get_named :
  parameter -> parameter list -> interval list -> interval option

val set_named :
  parameter -> interval -> parameter list -> interval list -> interval list

val get : cbox -> parameter -> interval option

val set : cbox -> parameter -> interval -> cbox

val set_row : setting -> Big_int_Z.big_int -> cbox -> setting

val set_load : setting -> load -> setting

val numbers_of0 : load -> interval list

val with_numbers : load -> interval list -> load

val halves :
  setting -> parameter -> Big_int_Z.big_int -> q -> (setting * setting,
  string) sum

val above : setting -> form -> setting branch

val not_below : setting -> form -> setting branch

val on_plane : setting -> form -> setting branch

val plane_numbers : nat -> q list -> q list

val slip_forms : row -> form list

val split : setting -> node -> (setting branch list, string) sum

val l_above : q -> form

val h_form : form

val range_conditions : range -> form list

val range_strict : range -> form list

val separating : row list -> form list -> form list

val root_branch : bool -> setting -> range -> setting branch

val walk_ranges :
  oracle -> (Big_int_Z.big_int -> ray list -> string option) ->
  Big_int_Z.big_int -> bool -> setting -> range list -> node list ->
  (string * nat) option

val exact_box : cbox -> bool

val exact_rows : row list -> bool

type state = { state_row : row; state_v : Big_int_Z.big_int;
               state_slip : form; state_share : q list; is_against : 
               bool }

val exact_pull : row -> form

val slip_of_row : row -> form -> form

val product_q : q list -> q list -> q list -> q

val mu_of : cbox -> q

val in_friction_cone : cbox -> q list -> bool

val against : cbox -> q list -> form -> bool

val share_of_force : cbox -> q list -> q list

val sum_of_products : q list -> q list -> q

val is_share_of : cbox -> q list -> bool

val presses0 : cbox -> Big_int_Z.big_int -> bool

val sliding : cbox -> form -> q list

val state_of : row -> form -> q list option -> state option

val states :
  row list -> form -> (Big_int_Z.big_int * q list) list -> Big_int_Z.big_int
  -> state list -> state list option

val exact_forms : cbox -> q list list

val add_friction : q -> q list -> q list -> q list list -> q list -> q list

val wrench_of : state -> q list

val load_at : load -> Big_int_Z.big_int -> Big_int_Z.big_int -> q list

val common_of : q list list -> Big_int_Z.big_int

val adds_up_to_zero : q list list -> bool

val check_point :
  bool -> nat -> row list -> load -> form -> (Big_int_Z.big_int * q list)
  list -> (state list, string) sum

val aligned : form -> form -> form -> bool

val first_slip : state list -> form

val contact_mode : state list -> bool

val same_mode : state list -> state list -> bool

val coordinates_of : point -> q list

val integer_point : point -> form

val check_at :
  bool -> nat -> row list -> load -> q list option -> point -> (state list,
  string) sum

val qlt_bool : q -> q -> bool

val beyond : q option -> q option -> bool

val reaches : q option -> q option -> bool

val segments_fail :
  bool -> nat -> row list -> load -> q list option -> (q -> q option -> q
  list -> q list -> q list list -> q list list -> node list -> (string * nat
  option) option) -> bool -> segment list -> (q * q option) list -> q option
  -> (point * state list) option -> nat -> (string * place) option

val order_fails : q option -> bool -> (q * q option) list -> nat -> nat option

val gaps_from : q -> bool -> (q * q option) list -> range list -> range list

val gaps : (q * q option) list -> range list

val opposite : vector -> vector

val walls_of : bool -> matrix -> matrix

val transpose : nat -> matrix -> matrix

val all_positive : vector -> bool

val zeros0 : nat -> vector

val balances : nat -> matrix -> vector -> bool

val is_simplex : nat -> matrix -> bool

val frame : bool -> matrix -> matrix -> matrix

val free_motions : nat -> bool -> matrix -> matrix option

val plus_square : vector -> matrix -> matrix

val inverted : nat -> matrix -> matrix -> (matrix * matrix) option

val wall_numbers : nat -> bool -> matrix -> vector -> vector

val most_in_K :
  nat -> bool -> matrix -> matrix -> vector -> vector -> q option

val k_within : nat -> bool -> matrix -> matrix -> vector -> matrix -> bool

type degree_proof = { low_multiple : q; high_multiple : q option;
                      first_twist : vector; last_twist : vector;
                      is_a_simplex : bool; wall_rows : matrix;
                      direction_rows : matrix }

val one_multiple : degree_proof -> bool

val s_and_t : degree_proof -> vector * vector

val relative : degree_proof -> vector -> vector

val room : degree_proof -> vector -> vector

val to_form : vector -> form

val base_conditions : degree_proof -> (form * bool) list

val walls : degree_proof -> matrix

val in_K_conditions : degree_proof -> (form * bool) list

val strict_form : degree_proof -> form

val middle_setting : degree_proof -> setting -> setting

val middle_conditions : degree_proof -> (form * bool) list

val point_box : cbox -> bool

val is_point : setting -> bool

val row_free : vector -> cbox -> bool

val load_free : vector -> load -> bool

val all_free : matrix -> setting -> bool

val bound_holds : degree_proof -> matrix -> setting -> bool

val range_sound : degree_proof -> setting -> bool

val k_region :
  oracle -> degree_proof -> setting -> (form * bool) list -> setting region

val wall_regions :
  oracle -> degree_proof -> setting -> (form * bool) list -> setting region
  list

val root_regions : oracle -> degree_proof -> setting -> setting region list

val law_holds : oracle -> degree_proof -> setting -> bool

val degree_fails :
  oracle -> bool -> Big_int_Z.big_int -> setting -> degree_proof -> node list
  -> (string * nat option) option

val is_open : Big_int_Z.big_int list -> nat -> bool

val others : Big_int_Z.big_int list -> nat -> 'a1 list -> 'a1 list

val without_open : Big_int_Z.big_int list -> setting -> setting

val places_before :
  Big_int_Z.big_int list -> Big_int_Z.big_int -> Big_int_Z.big_int

val number_of :
  Big_int_Z.big_int -> Big_int_Z.big_int list -> Big_int_Z.big_int ->
  Big_int_Z.big_int

val renumbered : Big_int_Z.big_int -> Big_int_Z.big_int list -> node -> node

val numbers_of1 :
  Big_int_Z.big_int -> Big_int_Z.big_int -> Big_int_Z.big_int list -> bool

val open_on : ray list -> Big_int_Z.big_int list -> nat -> row list -> bool

val across : degree_proof -> matrix -> (form * bool) list

val open_holds :
  oracle -> bool -> Big_int_Z.big_int list -> setting -> degree_proof -> bool

val degree_with_open_fails :
  oracle -> bool -> Big_int_Z.big_int -> Big_int_Z.big_int list -> setting ->
  degree_proof -> node list -> (string * nat option) option

type rest_proof = { rest_forces : (Big_int_Z.big_int * vector) list;
                    rest_answers : (Big_int_Z.big_int * matrix) list;
                    rest_reach : vector }

type resting = { resting_box : cbox; force_at_rest : vector; answers : matrix }

val good_force : cbox -> vector -> bool

val taken :
  'a1 -> Big_int_Z.big_int -> (Big_int_Z.big_int * 'a1) list ->
  'a1 * (Big_int_Z.big_int * 'a1) list

val resting_contacts :
  nat -> row list -> Big_int_Z.big_int -> (Big_int_Z.big_int * vector) list
  -> (Big_int_Z.big_int * matrix) list -> resting list -> resting list option

val range_of : vector -> interval

val plus_interval : interval -> interval -> interval

val shifted0 : interval -> q -> interval

val plus_intervals : interval list -> interval list -> interval list

val most_of : interval -> q

val ranges : nat -> cbox -> vector list -> interval list

val pressures : cbox -> q -> q list

val loads_at : setting -> q -> interval list

val left_over : nat -> setting -> resting list -> q -> interval list

val column : nat -> resting list -> nat -> interval list

val reach_holds : nat -> interval list -> interval list list -> vector -> bool

val square_of0 : vector -> vector -> q

val length_bound : cbox -> vector -> q

val least_pressure : cbox -> q -> q

val answers_bound : cbox -> matrix -> vector -> q

val cone_holds : vector -> q -> resting -> bool

val resting_sound : q -> resting -> bool

val rest_fails_at :
  nat -> setting -> resting list -> interval list list -> vector -> q ->
  string option

val rest_fails : setting -> q -> q -> rest_proof -> string option

type sticking_proof = { stuck_twist : vector;
                        stuck_friction : (Big_int_Z.big_int * vector) list;
                        stuck_presses : (Big_int_Z.big_int * vector) list;
                        stuck_answers : (Big_int_Z.big_int * matrix) list;
                        stuck_reach : vector; stuck_energy : q }

type sticker = { as_resting : resting; presses1 : vector }

val sticker_box : sticker -> cbox

val is_nothing : 'a1 list -> bool

val does_rub : sticker -> bool

val on_list : sticker -> bool

val with_presses :
  resting list -> Big_int_Z.big_int -> (Big_int_Z.big_int * vector) list ->
  sticker list -> sticker list option

val stickers : nat -> row list -> sticking_proof -> sticker list option

val no_motion : vector -> bool

val motion_holds : bool -> bool -> vector -> sticker list -> bool

val n_range : cbox -> vector -> interval

val minus_products : interval -> interval -> interval

val pull_range : cbox -> vector -> q -> interval

val push_range : cbox -> vector -> q -> interval

val slip_bound : cbox -> vector -> q

val absolute : q -> q

val stuck_left :
  nat -> setting -> vector -> sticker list -> q -> interval list

val off_most : interval list list -> nat -> nat -> q

val stuck_reach_holds :
  nat -> vector -> interval list list -> interval list -> bool

val more_bound : nat -> vector -> sticker -> q

val friction_bound : vector -> sticker -> q

val swing_bound : q -> sticker -> q

val least_rho : cbox -> q

val most_rho : cbox -> q

val spare_least : vector -> vector -> q -> q -> sticker -> q

val sticker_sound : q -> sticker -> bool

val press_holds : vector -> vector -> q -> q -> sticker -> bool

val share_at : nat -> vector -> vector -> q -> sticker -> q -> q

val share_most : nat -> vector -> vector -> q -> sticker -> q

val energy_holds : nat -> vector -> vector -> q -> sticker list -> q -> bool

val far_most : vector -> vector -> q -> q -> sticker -> nat -> q

val room0 : vector -> vector -> nat -> q

val stuck_bound_holds :
  nat -> vector -> vector -> q -> sticker list -> interval list list -> q ->
  q list option -> bool

val sticking_fails_at :
  nat -> setting -> vector -> vector -> q -> sticker list -> interval list
  list -> q -> string option

val stuck_column : nat -> sticker list -> nat -> interval list

val sticking_fails :
  bool -> setting -> q -> q -> sticking_proof -> string option

val part_fails :
  oracle -> bool -> Big_int_Z.big_int -> q -> q -> setting -> part ->
  (string * nat option) option

val unloaded : setting -> bool

val segment_by_degree_fails :
  oracle -> bool -> Big_int_Z.big_int -> setting -> q -> q option -> q list
  -> q list -> q list list -> q list list -> node list -> (string * nat
  option) option

val parts_fail :
  oracle -> bool -> Big_int_Z.big_int -> part list ->
  (setting * Big_int_Z.big_int) list -> nat -> (string * place) option

type rigid = { r_N : vector; r_slips : matrix; r_friction : q; r_square : 
               q; r_normal : vector }

type knowledge = { touches : bool option; sides0 : matrix option }

val slip_of : rigid -> vector -> vector

val cross : vector -> vector -> vector

val root_at_least : q -> q -> q -> q -> bool

val resists_all : rigid -> vector -> bool

val resists : rigid -> vector -> vector -> bool

val good_sides : rigid -> vector -> vector -> bool

val resists_against : rigid -> vector -> matrix option -> bool

val factor : vector -> vector -> q option

val is_positive_multiple : vector -> vector -> bool

val slip_factor : rigid -> rigid -> q option

val turned : q -> matrix -> matrix

type cell = (rigid * knowledge) list

val with_touch : rigid -> bool -> (rigid * knowledge) -> rigid * knowledge

val with_sides : rigid -> matrix -> (rigid * knowledge) -> rigid * knowledge

val slip_children :
  rigid -> matrix option -> vector -> (matrix list, string) sum

val ascending :
  Big_int_Z.big_int -> Big_int_Z.big_int -> (Big_int_Z.big_int * 'a1) list ->
  bool

val count_of : 'a1 list -> Big_int_Z.big_int

val normal_sum : cell -> (Big_int_Z.big_int * q) list -> vector

val normal_right : cell -> (Big_int_Z.big_int * q) -> bool

val slip_sum : cell -> (Big_int_Z.big_int * vector) list -> vector

val slip_right : cell -> (Big_int_Z.big_int * vector) -> bool

val rigid_leaf :
  matrix -> vector -> cell -> q -> vector -> (Big_int_Z.big_int * q) list ->
  (Big_int_Z.big_int * vector) list -> bool

val rigid_split :
  matrix -> vector -> cell -> rigid_node -> (cell list, string) sum

val rigid_walk :
  Big_int_Z.big_int -> matrix -> vector -> rigid_node list ->
  (cell * Big_int_Z.big_int) list -> nat -> (string * nat) option

val is_positive : q -> bool

val masses : q list -> matrix option

val rigid_of : row -> rigid option

val force_right : rigid -> q -> vector -> bool

type pressing0 = rigid * (q * vector)

val pressing_contacts :
  rigid list -> Big_int_Z.big_int -> stated_forces -> pressing0 list ->
  pressing0 list option

val force_total : vector -> pressing0 list -> vector

val balanced : matrix -> vector -> vector -> pressing0 list -> bool

val moves_right : vector -> pressing0 -> bool

val forces_fail :
  matrix -> vector -> vector -> rigid list -> stated_forces -> (pressing0
  list, string) sum

val class_fails :
  Big_int_Z.big_int -> matrix -> vector -> rigid list -> class_proof ->
  (string * nat option) option

val cross_product : form -> form -> form

val det : form -> form -> form -> Big_int_Z.big_int

val first_some : ('a1 -> 'a2 option) -> 'a1 list -> 'a2 option

val if_positive :
  Big_int_Z.big_int -> (nat * Big_int_Z.big_int) list ->
  (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option

val by_three :
  form -> (nat * form) -> (nat * form) -> (nat * form) ->
  (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option

val by_two :
  form -> (nat * form) -> (nat * form) ->
  (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list) option

val by_one :
  form -> (nat * form) -> (Big_int_Z.big_int * (nat * Big_int_Z.big_int)
  list) option

val or_else : 'a1 option -> (unit -> 'a1 option) -> 'a1 option

val sum_found :
  ray list -> form -> (Big_int_Z.big_int * (nat * Big_int_Z.big_int) list)
  option

val sum_of_rays : ray list -> (nat * Big_int_Z.big_int) list -> form

val reason_holds :
  ray list -> form -> Big_int_Z.big_int -> (nat * Big_int_Z.big_int) list ->
  bool

val is_sum_of : ray list -> form -> bool

type homogeneous = (q * q) * q

val load_part : load_point -> homogeneous

val part_list : homogeneous -> q list

val ray_of_part : homogeneous -> ray

val part_of_ray : nat -> form -> form

val held_by :
  nat -> ray list list -> Big_int_Z.big_int -> ray list -> string option

val does_not_grow : cbox -> bool

val load_in_plane : vector -> vector -> q -> q -> vector

val point_of_plane : load_point -> q list

val check_load_point :
  bool -> nat -> row list -> interval list -> vector -> vector -> load_point
  -> (state list, string) sum

val point_states :
  bool -> nat -> row list -> interval list -> vector -> vector -> load_point
  list -> nat -> (state list list, string * nat) sum

val share_one_mode : row list -> state list list -> bool

val pieces_fail :
  bool -> nat -> row list -> interval list -> vector -> vector -> load_point
  list list -> nat -> (string * place) option

val plane_node : nat -> node -> node

val plane_setting :
  nat -> row list -> interval list -> vector -> vector -> setting

val at_zero : range

val plane_fails :
  oracle -> Big_int_Z.big_int -> bool -> nat -> row list -> interval list ->
  vector -> vector -> homogeneous list list -> node list -> (string * nat)
  option

type held = { h_point : q list; h_normal : q list; h_friction : q;
              h_torsion : q; h_of0 : nat option; h_by : nat option }

val at_q : q list -> nat -> q

val held_of : bool -> q -> contact -> held option

val square_of_normal : held -> q

val press_and_rub : held -> q list -> q * q

val unopposed_by : held -> q list -> bool

val is_loose : element -> bool

val unopposed_by_element : q list -> element -> bool

val relative_q : q list list -> held -> q list

type standing = { s_numbers : nat; s_dimension : nat;
                  s_bodies : rigid_body list; s_contacts : held list;
                  s_elements : element list; s_loads : q list list }

val unopposed : standing -> q list -> bool

val is_lawful : held -> (q * q list) -> bool

val is_lawful_pull : element -> (q * q list) -> bool

val take :
  ('a1 -> (q * q list) -> bool) -> 'a1 list -> Big_int_Z.big_int ->
  stated_forces -> ('a1 * (q * q list) option) list -> ((('a1 * (q * q list)
  option) list * Big_int_Z.big_int) * stated_forces) option

val wrench_of0 : held -> (q * q list) -> q list

val add_on : nat -> q -> q list -> q list list -> q list list

val add_on_body : nat option -> q -> q list -> q list list -> q list list

val add_contact : q list list -> (held * (q * q list) option) -> q list list

val add_element : q list -> (element * (q * q list) option) -> q list

val add_from : nat -> q list -> q list -> q list

val pull_back : nat -> rigid_body list -> q list list -> q list -> q list

val load_of_point : q list -> q list list -> q list

val point_fails : standing -> q list -> stated_forces -> string option

type hull = { some : (q * q) option; goes_down : bool; goes_up : bool }

val more_of_hull : hull -> q list -> hull

val multiples_of : q list list -> (q option * q option) option

val more_of_moves :
  ((q option * q option) * bool) -> q list -> (q option * q option) * bool

val moves_of : q list list -> (q option * q option) * bool

val standing_of : question -> q -> standing option

val stands_fail :
  standing -> (q list * stated_forces) list -> nat -> (string * nat) option

val moves_fail : standing -> q list list -> nat -> nat option

val triple : q list -> (q * q) * q

val form_of : standing -> q list -> q list

val check_statics : question -> statics_proof -> answer

val enlarge_all : Big_int_Z.big_int -> contact list -> row list option

val most_depth : 'a1 list -> Big_int_Z.big_int

val rows_of : Big_int_Z.big_int -> question -> row list option

val unit_loads : q list -> matrix option

val addition_of : ball -> addition option

val addition_on : q list list -> addition -> addition

val load_of : question -> load option

val setting_of : Big_int_Z.big_int -> question -> setting option

val is_one_grasp : setting -> bool

val straight : setting -> bool

val refute :
  oracle -> question -> setting -> range list -> node list -> (string * nat)
  option

val check_witness : question -> setting -> witness -> answer

val check_tree : oracle -> question -> setting -> node list -> answer

val check_parts : oracle -> question -> setting -> part list -> answer

val check_margin :
  oracle -> question -> setting -> (q * q option) list -> segment list ->
  node list -> answer

val is_bounded : setting -> bool

val in_order : bool -> q option -> q -> q option -> bool

val holding_fails :
  oracle -> question -> setting -> nat -> q -> q option -> (part, witness
  list) sum -> answer option

val joined : (q * q option) list -> q -> q option -> (q * q option) list

val check_claims :
  oracle -> question -> setting -> claim list -> q option -> nat -> (q * q
  option) list -> ((q * q option) * bool) list -> answer

val check_class : question -> setting -> class_proof -> answer

val check_region :
  oracle -> question -> setting -> load_point list list -> node list -> answer

val check_motions : oracle -> question -> certificate -> answer

val check : oracle -> question -> certificate -> answer

val largest_exponent : Big_int_Z.big_int

val longest_number : Big_int_Z.big_int

val too_large : Big_int_Z.big_int

val is_not_too_large : q -> bool

val digit : char -> Big_int_Z.big_int option

val digits_after :
  Big_int_Z.big_int -> Big_int_Z.big_int -> char list ->
  (Big_int_Z.big_int * Big_int_Z.big_int) * char list

val digits : char list -> (Big_int_Z.big_int * Big_int_Z.big_int) * char list

val take0 : char -> char list -> bool * char list

val take_sign : char list -> bool * char list

val is_longer_than : Big_int_Z.big_int -> 'a1 list -> bool

val fraction : bool -> Big_int_Z.big_int -> Big_int_Z.big_int -> q option

val fraction_of_digits : bool -> char list -> q option

val parse_fraction : Big_int_Z.big_int -> string -> q option

val exponent : char list -> (Big_int_Z.big_int * char list) option

val parse_decimal : string -> q option

val read_decimal : path -> json -> q result

val longest_fraction : Big_int_Z.big_int

val longest_json_integer : Big_int_Z.big_int

val read_fraction : path -> json -> q result

val read_index : path -> json -> Big_int_Z.big_int result

val add_intervals : interval -> interval -> interval

type grasp = { in_space : bool; coordinates_read : nat;
               bodies_read : mechanism option; body_names : string list;
               names_of_bodies : string list;
               names_of_joints : string option list;
               all_contacts : contact list; common_wrench : interval list;
               has_loads : bool; bound_read : q list option;
               cases : (string * interval list) list }

val most_contacts : Big_int_Z.big_int

type version = { is_second : bool; is_in_space : bool }

val coordinates0 : version -> Big_int_Z.big_int

val components : version -> Big_int_Z.big_int

val needs_second : string

val has_length : Big_int_Z.big_int -> 'a1 list -> bool

val read_sized :
  Big_int_Z.big_int -> string -> (path -> json -> 'a1 result) -> path -> json
  -> 'a1 list result

val read_point : version -> path -> json -> q list result

val is_0 : q -> bool

val is_below : q -> q -> bool

val sum_of_squares0 : q list -> q

val read_interval : version -> path -> json -> interval result

val read_wrench : version -> path -> json -> interval list result

type properties = { own_friction : interval option;
                    own_stiffness : interval option;
                    own_preload : interval option }

val read_property : version -> bool -> path -> json -> interval result

val read_properties :
  version -> path -> (string * json) list -> properties result

val read_defaults : version -> path -> json -> properties result

type edge = { from : q list; to0 : q list; inwards : q list }

val depth_of : json -> Big_int_Z.big_int

val same : q list -> q list -> bool

val pairs_to : 'a1 -> 'a1 list -> ('a1 * 'a1) list -> ('a1 * 'a1) list

val pairs : 'a1 list -> ('a1 * 'a1) list

val cross0 : q list -> q list -> q

val with_length_1 : q list -> q list

val make_edge : q -> (q list * q list) -> edge

val read_ring : version -> bool -> path -> json -> edge list result

val read_polygon : version -> path -> json -> edge list result

val read_outline : version -> path -> json -> edge list list result

val read_vertex_number : Big_int_Z.big_int -> path -> json -> unit result

val read_face : Big_int_Z.big_int -> path -> json -> unit result

val read_body : version -> path -> json -> unit result

val at_point0 : q list -> q list -> q list

val read_pull : version -> path -> (string * json) list -> q list result

val read_torque : version -> path -> json -> q list result

val read_load : version -> path -> json -> q list result

val no_wrench : version -> interval list

val add_wrench : interval list -> interval list -> interval list

val read_loads : version -> path -> json -> interval list result

val read_name : path -> json -> string result

val read_case : version -> path -> json -> (string * interval list) result

val check_names : path -> string list -> unit result

val read_list_of_cases :
  (path -> json -> (string * interval list) result) -> path -> json ->
  (string * interval list) list result

val bound_of0 : bool -> nat -> q -> q -> q list

val read_above_0 : path -> json -> q result

val read_bound : bool -> bool -> nat -> path -> json -> q list result

val nth_from : Big_int_Z.big_int -> 'a1 list -> 'a1 option

val choose : q -> 'a1 list -> 'a1 option

val read_on :
  edge list list -> path -> json -> (interval list * q list) result

val read_normal : version -> path -> json -> (q list * q) result

val read_contact :
  version -> edge list list -> properties -> path -> json -> contact result

val read_format : path -> json -> bool result

val read_any_text : path -> json -> unit result

val is_unit : string -> bool

val read_unit : path -> json -> unit result

val read_units : path -> json -> unit result

val is_array : Big_int_Z.big_int -> json option -> bool

val begins_in_space : (string * json) list -> bool

val version_of : (string * json) list -> version result

val read_grasp : json -> grasp result

type named_body = { name_of : string; link : (nat option * q list) option }

val ground : string

val number_from : string -> string list -> nat -> nat option

val number_of0 : string -> named_body list -> nat option

val without : string list -> (string * json) list -> json

val read_axis : version -> path -> json -> q list result

val read_slide : version -> path -> json -> q list result

val read_hinge : version -> path -> json -> q list result

val read_on_body : named_body list -> path -> json -> nat option result

val read_named_body :
  version -> named_body list -> path -> json -> named_body result

val read_bodies_after :
  version -> Big_int_Z.big_int -> path -> json list -> named_body list ->
  named_body list result

val read_bodies : version -> path -> json -> named_body list result

type turns_of_links = (string * q) list

val read_all_turns :
  named_body list -> path -> (string * json) list -> turns_of_links result

val read_turns : named_body list -> path -> json -> turns_of_links result

val find_turn : string -> turns_of_links -> q

val read_element :
  version -> bool -> string -> q list -> path -> (string * json) list ->
  element result

val read_text : path -> json -> string result

val read_joint :
  version -> named_body list -> path -> json -> ((turns_of_links * string
  option) * (q list -> element result) option) result

val sum_of : q list list -> nat -> q list

val read_over :
  version -> named_body list -> (string -> q list) -> nat -> bool -> string
  -> path -> json -> element result

val read_load_on_body :
  version -> named_body list -> path -> json -> (nat * interval list) result

val work_of_loads :
  mechanism -> nat -> (nat * interval list) list -> interval list

val no_load : nat -> interval list

val read_state_wrench : version -> nat -> path -> json -> interval list result

val read_loads_on_bodies :
  mechanism -> nat -> (path -> json -> (nat * interval list) result) -> path
  -> json -> interval list result

val read_case_of_bodies :
  (path -> json -> interval list result) -> (path -> json -> interval list
  result) -> path -> json -> (string * interval list) result

val read_torsion : version -> path -> json -> q result

val read_contact_of_bodies :
  version -> named_body list -> properties -> q -> path -> json -> contact
  result

val read_defaults_of_bodies :
  version -> path -> json -> (properties * q) result

val number_bodies :
  nat -> nat -> named_body list -> (string -> q list) -> rigid_body list

val names_of_body : version -> named_body -> string list

val most_coordinates : Big_int_Z.big_int

val listed_member :
  string -> (path -> json -> 'a1 result) -> (string * json) list -> 'a1 list
  result

val read_springs :
  q list list -> (q list -> element result) option list -> element list result

val read_grasp_of_bodies : json -> grasp result

val read_file : json -> grasp result

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

val uncertain_kinds : string list

val asks_margin : options -> bool

val asks_plane : options -> bool

val asks_class : options -> bool

val asks_statics : options -> bool

val asks_one : options -> bool

val in_full : q list -> q list

type posed = { the_question : question; free_coordinates : string list;
               joint_coordinates : string option list;
               stated_wrench : interval list; the_options : options;
               is_box : bool }

val of_question : string -> path

val find_tolerance : string -> options -> tolerance option

val check_dimension : grasp -> string -> q list option -> unit result

val wrench_asked : grasp -> options -> interval list result

val widen : tolerance option -> interval -> interval

val asked_contact : options -> contact -> contact

val asked_element : options -> element -> element

val ball_asked :
  grasp -> options -> interval list -> (stated_ball * ball) option result

val bound_asked : grasp -> options -> q list option result

val check_tolerances : options -> (string * tolerance) list -> unit result

val is_exact : interval -> bool

val is_one_point : contact -> bool

val has_irrational_preload : contact -> bool

val check_contact : bool -> bool -> bool -> path -> contact -> bool result

val check_element : bool -> path -> element -> bool result

val with_growth : interval -> q -> contact -> contact

val element_with_growth : interval -> q -> element -> element

val with_growths :
  ('a1 -> q -> 'a1) -> 'a1 list -> q list -> 'a1 list -> ('a1 list * q list)
  option

val are_multiples : q list -> q list -> bool

val check_plane : grasp -> options -> unit result

val check_statics0 : grasp -> options -> unit result

val pose : grasp -> options -> posed result

type statement = { stated_contacts : Big_int_Z.big_int;
                   wrench_stated : interval list; options_stated : options }

type shape = { spatial : bool; of_bodies : bool;
               size_of_twist : Big_int_Z.big_int; soft : bool list;
               of_claims : bool; of_margin : bool; of_plane : bool;
               of_class : bool; of_statics : bool }

val has_claims : question -> bool

val read_numbers : Big_int_Z.big_int -> path -> json -> q list result

val read_twist : shape -> path -> json -> q list result

val read_or_null : path -> json -> q option result

val read_stated_component : path -> json -> interval result

val read_law : path -> json -> bool result

val read_growth : path -> json -> growth result

val before_percent : string -> string option

val read_tolerance : path -> json -> tolerance result

val read_ball : shape -> path -> json -> stated_ball result

val read_all_tolerances :
  shape -> path -> (string * json) list -> ((string * tolerance)
  list * stated_ball option) result

val read_tolerances :
  shape -> path -> json -> ((string * tolerance) list * stated_ball option)
  result

val read_inertia : bool -> path -> json -> q list result

val read_plane : Big_int_Z.big_int -> path -> json -> (q list * q list) result

val names_member : string -> json -> bool

val read_statement : shape -> path -> json -> statement result

val read_friction :
  shape -> Big_int_Z.big_int -> path -> json -> q list result

val read_force :
  shape -> path -> json -> (Big_int_Z.big_int * (q * q list)) result

val read_forces : shape -> path -> json -> stated_forces result

val read_parameter : shape -> path -> json -> parameter result

val read_cut :
  shape -> path -> json list -> json -> ((parameter * Big_int_Z.big_int) * q)
  result

val read_node : shape -> path -> json -> node result

val read_nodes : shape -> path -> json -> node list result

val read_share : shape -> path -> json -> (Big_int_Z.big_int * q list) result

val read_shares :
  shape -> path -> json -> (Big_int_Z.big_int * q list) list result

val read_point0 : shape -> bool -> path -> json -> point result

val read_segment : shape -> bool -> path -> json -> segment result

val read_resisted : path -> json -> (q * q option) result

val read_matrix : shape -> path -> json -> q list list result

val has_at_most : Big_int_Z.big_int -> 'a1 list -> bool

val read_walls :
  shape -> Big_int_Z.big_int -> path -> json -> q list list result

val read_answers :
  shape -> path -> json -> (Big_int_Z.big_int * q list list) result

val read_at_rest : shape -> path -> json -> part result

val read_presses :
  shape -> path -> json -> (Big_int_Z.big_int * q list) result

val read_sticking : shape -> path -> json -> part result

val read_part : shape -> path -> json -> part result

val read_segment_by_degree : shape -> path -> json -> segment result

val read_segments_from :
  shape -> bool -> Big_int_Z.big_int -> path -> json list -> segment list ->
  segment list result

val read_segments : shape -> path -> json -> segment list result

val read_spatial_point : shape -> path -> json -> witness result

val is_point0 : json -> bool

val read_claim : shape -> path -> json -> claim result

val read_multiplier : path -> json -> (Big_int_Z.big_int * q) result

val read_rigid_node : shape -> path -> json -> rigid_node result

val next :
  string -> (string * json) list -> (json * (string * json) list) result

val next_read :
  string -> (path -> json -> 'a1 result) -> (string * json) list ->
  ('a1 * (string * json) list) result

val begins_with : string -> (string * json) list -> bool

val finish : ('a1 * (string * json) list) -> 'a1 result

val default_bits : Big_int_Z.big_int

val read_bits : path -> json -> Big_int_Z.big_int result

val read_verdict : shape -> path -> json -> bool result

val read_body0 : shape -> bool -> (string * json) list -> proof result

val read_load_point : shape -> path -> json -> load_point result

val read_region : shape -> (string * json) list -> proof result

val read_class : shape -> (string * json) list -> proof result

val read_stand : shape -> path -> json -> (q list * stated_forces) result

val read_statics : shape -> (string * json) list -> proof result

val read_known_format : path -> json -> unit result

val read_certificate : question -> json -> (statement * certificate) result

val same_list : ('a1 -> 'a1 -> bool) -> 'a1 list -> 'a1 list -> bool

val same_option : ('a1 -> 'a1 -> bool) -> 'a1 option -> 'a1 option -> bool

val same_interval : interval -> interval -> bool

val same_growth : growth -> growth -> bool

val same_tolerance : tolerance -> tolerance -> bool

val same_ball : stated_ball -> stated_ball -> bool

val same_bound : bound_option -> bound_option -> bool

val broken_question_rule : statement -> posed -> string option

val ask : options -> json -> posed result

val judge : oracle -> posed -> json -> (answer * certificate) result
