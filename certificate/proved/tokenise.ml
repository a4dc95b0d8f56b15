(* SPDX-License-Identifier: MIT *)
(* The tokeniser: JSON (RFC 8259, UTF-8) within the limits of FORMAT.md section 2. Nothing is proved of
   it, and it knows nothing of grasps: what a text means is read in Json.v, Numeral.v and Read*.v. *)

open Checker

type limits = {
  bytes : int;
  depth : int;  (* of nested arrays and objects *)
  string : int;  (* bytes between the quotation marks; or of a number *)
  values : int;  (* in a member of the text's object, arrays and objects included *)
  byte_order_mark : bool;  (* whether the text may begin with one *)
  lists : string list;  (* members with so many values in each element, if they are arrays *)
}

let of_grasp =
  { bytes = 1 lsl 28; depth = 32; string = 1 lsl 28; values = 1 lsl 16; byte_order_mark = true;
    lists = [ "contacts" ] }

let of_certificate =
  { bytes = 1 lsl 30; depth = 8; string = 65536; values = 1 lsl 22; byte_order_mark = false;
    lists = [ "segments"; "tree"; "parts"; "intervals"; "pieces" ] }

exception Not_json of { line : int; column : int; problem : string }

type reader = { text : string; limits : limits; mutable at : int; mutable line : int;
                mutable line_begin : int; mutable depth : int; mutable values : int }

let fail r problem =
  raise (Not_json { line = r.line; column = r.at - r.line_begin + 1; problem })

let fail_with_number r before number after =
  fail r (before ^ string_of_int number ^ after)

(* The byte to come; '\000', which is nowhere allowed, at the end. *)
let peek r = if r.at < String.length r.text then String.unsafe_get r.text r.at else '\000'
let at_end r = r.at >= String.length r.text

let fail_here r problem = fail r (if at_end r then "the text ends here; is it complete?" else problem)

let take r =
  if at_end r then fail_here r "";
  let c = String.unsafe_get r.text r.at in
  r.at <- r.at + 1;
  c

let rec skip_blanks r =
  match peek r with
  | ' ' | '\t' | '\r' -> r.at <- r.at + 1; skip_blanks r
  | '\n' ->
    r.at <- r.at + 1;
    r.line <- r.line + 1;
    r.line_begin <- r.at;
    skip_blanks r
  | _ -> ()

let expect r c problem = if peek r = c && not (at_end r) then r.at <- r.at + 1 else fail_here r problem

let is_digit c = c >= '0' && c <= '9'

let number r =
  let first = r.at in
  let digits () =
    if not (is_digit (peek r)) then fail_here r "not a number; numbers look like 2, -0.25 or 1e-3";
    while is_digit (peek r) do r.at <- r.at + 1 done in
  if peek r = '-' then r.at <- r.at + 1;
  if peek r = '0' then begin
    r.at <- r.at + 1;
    if is_digit (peek r) then fail r "a number that begins with a zero too many"
  end else digits ();
  if peek r = '.' then begin r.at <- r.at + 1; digits () end;
  if peek r = 'e' || peek r = 'E' then begin
    r.at <- r.at + 1;
    if peek r = '+' || peek r = '-' then r.at <- r.at + 1;
    digits ()
  end;
  if r.at - first > r.limits.string then fail r "a number of far too many digits";
  String.sub r.text first (r.at - first)

let hexadecimal r =
  let code = ref 0 in
  for _ = 1 to 4 do
    let digit = match take r with
      | '0' .. '9' as c -> Char.code c - Char.code '0'
      | 'a' .. 'f' as c -> Char.code c - Char.code 'a' + 10
      | 'A' .. 'F' as c -> Char.code c - Char.code 'A' + 10
      | _ -> fail r "\\u must be followed by four hexadecimal digits" in
    code := 16 * !code + digit
  done;
  !code

let escape r text =
  match take r with
  | ('"' | '\\' | '/') as c -> Buffer.add_char text c
  | 'b' -> Buffer.add_char text '\b'
  | 'f' -> Buffer.add_char text '\012'
  | 'n' -> Buffer.add_char text '\n'
  | 'r' -> Buffer.add_char text '\r'
  | 't' -> Buffer.add_char text '\t'
  | 'u' ->
    let code = hexadecimal r in
    let code =
      if code < 0xD800 || code >= 0xE000 then code
      else begin
        let pair = code < 0xDC00 && take r = '\\' && take r = 'u' in
        let low = if pair then hexadecimal r else 0 in
        if low < 0xDC00 || low >= 0xE000 then fail r "a \\u escape that is half of a surrogate pair";
        0x10000 + ((code - 0xD800) * 0x400) + (low - 0xDC00)
      end in
    Buffer.add_utf_8_uchar text (Uchar.of_int code)
  | _ -> fail r "an unknown escape in a string"

(* The bytes of a character that begins with [lead], in the shortest form that UTF-8 asks for. *)
let character r lead text =
  let code = Char.code lead in
  let more = if code < 0x80 then 0 else if code < 0xE0 then 1 else if code < 0xF0 then 2 else 3 in
  if (code >= 0x80 && code < 0xC2) || code > 0xF4 then fail r "not UTF-8";
  Buffer.add_char text lead;
  for k = 1 to more do
    let c = take r in
    let low, high =
      if k > 1 then (0x80, 0xBF)
      else match code with
        | 0xE0 -> (0xA0, 0xBF)
        | 0xED -> (0x80, 0x9F)
        | 0xF0 -> (0x90, 0xBF)
        | 0xF4 -> (0x80, 0x8F)
        | _ -> (0x80, 0xBF) in
    if Char.code c < low || Char.code c > high then fail r "not UTF-8";
    Buffer.add_char text c
  done

let string r =
  expect r '"' "expected a string, in double quotes";
  let first = r.at in
  let text = Buffer.create 16 in
  let rec rest () =
    let c = take r in
    if c <> '"' then begin
      if r.at - first > r.limits.string then
        fail_with_number r "a string of more than " r.limits.string " bytes";
      if c < ' ' then fail r "a control character in a string; write it as an escape";
      if c = '\\' then escape r text else character r c text;
      rest ()
    end in
  rest ();
  Buffer.contents text

let word r =
  let is word =
    let size = String.length word in
    let next = r.at + size in
    next <= String.length r.text
    && String.sub r.text r.at size = word
    && (next = String.length r.text || not (r.text.[next] >= 'a' && r.text.[next] <= 'z'))
    && (r.at <- next; true) in
  if is "null" then Null
  else if is "true" then Boolean true
  else if is "false" then Boolean false
  else fail_here r "not JSON; strings take double quotes, numbers look like 2, -0.25 or 1e-3"

(* The items between two brackets, each read by [item]. *)
let items r bracket closing item =
  if r.depth = r.limits.depth then
    fail_with_number r "nested more than " r.limits.depth " deep";
  r.depth <- r.depth + 1;
  expect r bracket ("expected " ^ String.make 1 bracket);
  let rec rest read =
    skip_blanks r;
    if peek r = closing then List.rev read
    else begin
      if read <> [] then begin
        expect r ',' ("expected a comma or " ^ String.make 1 closing);
        skip_blanks r;
        if peek r = closing then fail r "a comma after the last element; remove it"
      end;
      rest (item () :: read)
    end in
  let all = rest [] in
  r.at <- r.at + 1;
  r.depth <- r.depth - 1;
  all

let key r =
  skip_blanks r;
  if peek r <> '"' then fail_here r "expected the name of a member, in double quotes";
  let name = string r in
  skip_blanks r;
  expect r ':' "expected a colon after the name of a member";
  name

let rec value r =
  r.values <- r.values + 1;
  if r.values > r.limits.values then
    fail_with_number r "more than " r.limits.values " values in one place";
  skip_blanks r;
  match peek r with
  | '{' -> Object (items r '{' '}' (fun () -> let name = key r in (name, value r)))
  | '[' -> Array (items r '[' ']' (fun () -> value r))
  | '"' -> Text (string r)
  | '-' | '0' .. '9' -> Number (number r)
  | _ -> word r

(* A value whose parts do not count towards what was read before. *)
let counted_anew r =
  r.values <- 0;
  value r

let read limits text =
  let r = { text; limits; at = 0; line = 1; line_begin = 0; depth = 0; values = 0 } in
  if String.length text > limits.bytes then
    fail_with_number r "more than " limits.bytes " bytes";
  if peek r = '\xEF' then begin
    if not limits.byte_order_mark then fail r "a byte order mark; use UTF-8 without one";
    if not (String.length text >= 3 && String.sub text 0 3 = "\xEF\xBB\xBF") then fail r "not UTF-8";
    r.at <- 3;
    r.line_begin <- 3
  end;
  skip_blanks r;
  if at_end r then fail r "the file is empty";
  if peek r <> '{' then fail r "expected an object {...}";
  let member () =
    let name = key r in
    skip_blanks r;
    (name,
     if List.mem name limits.lists && peek r = '[' then
       Array (items r '[' ']' (fun () -> counted_anew r))
     else counted_anew r) in
  let members = items r '{' '}' member in
  skip_blanks r;
  if not (at_end r) then fail r "text after the last brace";
  Object members
