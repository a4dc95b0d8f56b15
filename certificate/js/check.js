// SPDX-License-Identifier: MIT
//
// A checker of stickslip certificates for browsers and node, written from certificate/FORMAT.md alone.
// The section signs (§) are its sections; the names of rules are its names. Every number is a BigInt or
// a fraction of two; no floating point decides anything. A plain script without dependencies: it defines
// one object, StickslipCheck, and under node it is a module.
'use strict';

(function (scope) {

// ---------------------------------------------------------------------------- Work (§8)

/** Exit 3: the proof takes more work than this program does for files of their length. */
class NotJudged extends Error {}

/**
 * Steps of less than a microsecond, counted and not timed; products of words, as all checkers count them; and the length of what was
 * read. Limited while a question is answered.
 */
const work = {limited: false, bytes: 0, steps: 0, products: 0};

function spend(steps) {
  work.steps += steps;
  const most = 8000000 + Math.floor(work.bytes * work.bytes / 12);
  if (work.limited && work.steps > most) throw new NotJudged(`it takes more than ${most} steps, the most for ${work.bytes} bytes`);
}

/** What long numbers cost: the limit is that of all checkers. */
function spend_products(count) {
  work.products += count;
  const most = 5e8 + 5 * work.bytes * work.bytes;
  if (work.limited && work.products > most) throw new NotJudged(`it takes more than ${most} products of words, the most for ${work.bytes} bytes`);
}

/** Up to 256 bits numbers are short: what is done with them costs steps. */
const SHORT = 1n << 256n;
const is_long = (n) => n >= SHORT || n <= -SHORT;

const LENGTHS = [[1n << 64n, 1]];
for (let words = 2; words < 2 ** 20; words *= 2) {
  LENGTHS.push([1n << BigInt(64 * words), words], [1n << BigInt(96 * words), 1.5 * words]);
}

/** The words of a number, or up to half as many more. */
function words(n) {
  let low = 0, high = LENGTHS.length - 1;
  while (low < high) {
    const middle = (low + high) >> 1, [end] = LENGTHS[middle];
    if (n < end && n > -end) high = middle;
    else low = middle + 1;
  }
  return LENGTHS[low][1];
}

/** The products of words of numbers of so many words: long ones cost less than they have digits (Karatsuba and others). */
function products_of(n, m) {
  const least = Math.min(n, m);
  return least <= 64 ? n * m : Math.floor(8 * Math.max(n, m) * Math.sqrt(least));
}

const most_words = (row) => row.reduce((most, x) => Math.max(most, words(x)), 1);

// ---------------------------------------------------------------------------- Numbers

const absolute = (n) => (n < 0n ? -n : n);

function bit_length(n) {
  const hex = n.toString(16);
  return 4 * (hex.length - 1) + parseInt(hex[0], 16).toString(2).length;
}

/**
 * Four integers [p, q, r, s] with ps − qr = ±1, such that pa + qb and ra + sb are about half as long as a > b > 0: the
 * quotients of Euclid's algorithm, found from leading digits. Where these mislead, the integers are less short, but
 * have the same gcd.
 */
function halving(a, b) {
  const length = bit_length(a), least = 1n << BigInt(length >> 1);
  let [p, q, r, s] = [1n, 0n, 0n, 1n];
  const apply = ([e, f, g, h]) => {
    [a, b] = [e * a + f * b, g * a + h * b];
    [p, q, r, s] = [e * p + f * r, e * q + f * s, g * p + h * r, g * q + h * s];
    if (a < 0n) [a, p, q] = [-a, -p, -q];
    if (b < 0n) [b, r, s] = [-b, -r, -s];
    if (a < b) [a, b, p, q, r, s] = [b, a, r, s, p, q];
  };
  if (length > 256) {
    for (const shift of [length >> 1, length >> 2]) {
      const top = b >> BigInt(shift);
      if (b < least || top === 0n) break;
      apply(halving(a >> BigInt(shift), top));
      if (b >= least) apply([0n, 1n, 1n, -(a / b)]);
    }
  } else {
    while (b >= least) {
      const quotient = a / b;
      [a, b, p, q, r, s] = [b, a - quotient * b, r, s, p - quotient * r, q - quotient * s];
    }
  }
  return [p, q, r, s];
}

const LONG = 1n << 4096n;

function gcd(a, b) {
  a = absolute(a);
  b = absolute(b);
  if (is_long(a) && is_long(b)) spend_products(4 * products_of(words(a), words(b)));
  while (a > LONG && b > LONG) {
    [a, b] = a < b ? [a, b % a] : [b, a % b];
    if (b === 0n) return a;
    const [p, q, r, s] = halving(a, b);
    [a, b] = [absolute(p * a + q * b), absolute(r * a + s * b)];
  }
  let turns = 0;
  for (; b !== 0n; ++turns) [a, b] = [b, a % b];
  spend(turns >> 3);
  return a;
}

const lcm = (a, b) => (a === b || b === 1n ? a : a / gcd(a, b) * b);

/** A rational number n/d in lowest terms, d > 0. */
class Fraction {
  constructor(n, d) {
    this.n = n;
    this.d = d;
  }
  static of(n, d = 1n) {
    if (is_long(n) || is_long(d)) spend_products(products_of(words(n), words(n)) + products_of(words(d), words(d)));  // not less than what they were made of
    if (d === 1n) return new Fraction(n, d);
    const g = d < 0n ? -gcd(n, d) : gcd(n, d);
    return new Fraction(n / g, d / g);
  }
  plus(o) {
    if (this.d === o.d) return Fraction.of(this.n + o.n, this.d);
    return Fraction.of(this.n * o.d + o.n * this.d, this.d * o.d);
  }
  minus(o) { return this.plus(o.negated()); }
  times(o) { return Fraction.of(this.n * o.n, this.d * o.d); }
  over(o) { return Fraction.of(this.n * o.d, this.d * o.n); }
  negated() { return new Fraction(-this.n, this.d); }
  magnitude() { return this.n < 0n ? this.negated() : this; }
  half() { return Fraction.of(this.n, 2n * this.d); }
  sign() { return this.n > 0n ? 1 : this.n < 0n ? -1 : 0; }
  compare(o) {
    const difference = this.n * o.d - o.n * this.d;
    return difference > 0n ? 1 : difference < 0n ? -1 : 0;
  }
  equals(o) { return this.n === o.n && this.d === o.d; }
  isZero() { return this.n === 0n; }
  toString() { return this.d === 1n ? `${this.n}` : `${this.n}/${this.d}`; }
}

const ZERO = new Fraction(0n, 1n), ONE = new Fraction(1n, 1n);
const least = (values) => values.reduce((a, b) => (b.compare(a) < 0 ? b : a));
const largest = (values) => values.reduce((a, b) => (b.compare(a) > 0 ? b : a));
const dot_fractions = (a, b) => a.reduce((sum, x, j) => (x.isZero() ? sum : sum.plus(x.times(b[j]))), ZERO);
const same_list = (a, b) => a.length === b.length && a.every((x, j) => x.equals(b[j]));
const all_zero = (list) => list.every((x) => x.isZero());
const cross_product = (a, b) => [0, 1, 2].map((j) => {
  const k = (j + 1) % 3, l = (j + 2) % 3;
  return a[k].times(b[l]).minus(a[l].times(b[k]));
});

/** The greatest integer whose square is at most n, by Newton's method from above; of long numbers from the root of their first half. */
function integer_root(n) {
  if (n < 2n) return n;
  let x;
  if (is_long(n)) {
    spend_products(products_of(words(n), words(n)));
    const half = BigInt(bit_length(n) >> 2);
    x = (integer_root(n >> (2n * half)) + 1n) << half;
  } else {
    x = 1n << BigInt((bit_length(n) + 1) >> 1);
  }
  for (;;) {
    const next = (x + n / x) >> 1n;
    if (next >= x) return x;
    x = next;
  }
}

/** What squares leave modulo a few numbers: of a hundred others one is among them. */
const SQUARES = [64n, 63n, 65n, 11n].map((modulus) => {
  const squares = new Set();
  for (let x = 0n; x < modulus; ++x) squares.add(x * x % modulus);
  return [modulus, squares];
});

/** √q, or null if it is irrational. √(n/d) = √(nd)/d. */
function rational_root(q) {
  const product = q.n * q.d;
  if (SQUARES.some(([modulus, squares]) => !squares.has(product % modulus))) return null;
  const root = integer_root(product);
  return root * root === product ? Fraction.of(root, q.d) : null;
}

/** [ℓ⁻, ℓ⁺] for √q (§6): ℓ⁻ = j/2^s is the greatest such number ≤ √q with j of so many bits. */
function enclose_root(q, bits) {
  let s = bits - ((bit_length(q.n) - bit_length(q.d)) >> 1);
  for (;;) {
    const j = s >= 0 ? integer_root((q.n << BigInt(2 * s)) / q.d)
                     : integer_root(q.n / (q.d << BigInt(-2 * s)));
    const length = bit_length(j);
    if (length === bits) {
      const at = (i) => (s >= 0 ? Fraction.of(i, 1n << BigInt(s)) : Fraction.of(i << BigInt(-s)));
      return [at(j), at(j + 1n)];
    }
    s += length < bits ? 1 : -1;
  }
}

function dot(a, b) {
  let sum = 0n, long = false;
  for (let j = 0; j < a.length; ++j) {
    if (a[j] !== 0n && b[j] !== 0n) {
      const term = a[j] * b[j];
      if (is_long(term)) long = true;
      sum += term;
    }
  }
  spend(1);
  if (long) spend_products(a.length * products_of(most_words(a), most_words(b)));
  return sum;
}

/** The primitive vector in the direction of p a + q b. */
function combined(p, a, q, b) {
  const sum = a.map((x, j) => p * x + q * b[j]);
  if (sum.some(is_long)) spend_products(a.length * (products_of(words(p), most_words(a)) + products_of(words(q), most_words(b))));
  return primitive(sum);
}

const negative = (row) => row.map((x) => -x);

/** The vector of coprime integers in the direction of another vector of integers. */
function primitive(row) {
  let common = 0n;
  for (const x of row) {
    if (x !== 0n) {
      common = gcd(common, x);
      if (common === 1n) return row;
    }
  }
  if (is_long(common)) spend_products(row.length * products_of(words(common), most_words(row)));
  return common > 1n ? row.map((x) => x / common) : row;
}

const common_denominator = (fractions) => fractions.reduce((d, x) => lcm(d, x.d), 1n);
const over_denominator = (fractions, d) => fractions.map((x) => x.n * (d / x.d));
/** Fractions as coprime integers, times a positive number. */
const integral = (fractions) => primitive(over_denominator(fractions, common_denominator(fractions)));

/**
 * The sum of many vectors of integers, each over a denominator. Those with one denominator are added at
 * once; the others by halves at the end, so that few numbers are long.
 */
class Sum {
  constructor(size) {
    this.size = size;
    this.parts = new Map();
  }
  add(row, d) {
    const part = this.parts.get(d);
    if (part === undefined) this.parts.set(d, row.slice());
    else for (let j = 0; j < this.size; ++j) part[j] += row[j];
  }
  add_fractions(values) {
    const d = common_denominator(values);
    this.add(over_denominator(values, d), d);
  }
  /** [integers, their denominator > 0], not in lowest terms. */
  total() {
    let parts = [...this.parts].map(([d, row]) => [row, d]);
    if (parts.length === 0) return [Array(this.size).fill(0n), 1n];
    while (parts.length > 1) {
      const halved = [];
      for (let k = 0; k < parts.length; k += 2) {
        if (k + 1 === parts.length) {
          halved.push(parts[k]);
        } else {
          const [a, d] = parts[k], [b, e] = parts[k + 1];
          if (is_long(d) || is_long(e)) {
            spend_products(a.length * (products_of(most_words(a), words(e)) + products_of(most_words(b), words(d))));
          }
          halved.push([a.map((x, j) => x * e + b[j] * d), d * e]);
        }
      }
      parts = halved;
    }
    return parts[0];
  }
}

// ---------------------------------------------------------------------------- Answers (§8)

/** Exit 2: a file that cannot be read, or a question that cannot be asked. */
class Malformed extends Error {
  constructor(place, found) {
    super(found);
    this.place = place;
  }
}

/** Exit 1: a rule fails. */
class Rejected extends Error {
  constructor(rule, found, place = null, node = null) {
    super(found);
    this.rule = rule;
    this.place = place;
    this.node = node;
  }
}

/** Text of a file for a message: printable ASCII, and not long. */
function printable(value, most = 60) {
  let text = '';
  for (const unit of String(value)) {
    const code = unit.codePointAt(0);
    text += code >= 32 && code < 127 ? unit : `\\u{${code.toString(16)}}`;
    if (text.length > most) return text.slice(0, most) + '...';
  }
  return text;
}

const quoted = (text) => `"${printable(text)}"`;
const list_text = (values) => `(${values.map((x) => printable(x)).join(', ')})`;
const interval_text = ([low, high]) => (low.equals(high) ? `${low}` : `[${low}, ${high}]`);

// ---------------------------------------------------------------------------- JSON (§2)

/** A number as it is spelled: JSON.parse would round it. */
class Numeral {
  constructor(text) { this.text = text; }
}

const CERTIFICATE_LIMITS = {bytes: 2 ** 30, depth: 8, string: 65536, numeral: 4000, values: 2 ** 22,
  members: new Set(['segments', 'tree', 'parts', 'intervals', 'contacts'])};
const GRASP_LIMITS = {bytes: 2 ** 28, depth: 32, string: 2 ** 28, numeral: 16384, values: 2 ** 16,
  members: new Set(['segments', 'tree', 'parts', 'intervals', 'contacts'])};
const MOST_CONTACTS = 1000000, MOST_COORDINATES = 30, GROUND = 'ground', LONGEST_GRASP_NUMBER = 16384, MOST_EXPONENT = 4096;

const utf8_length = (text) => new TextEncoder().encode(text).length;

/** The text of a file given as bytes or, by those who have read it themselves, as a string. */
function text_of(file, limits, byte_order_mark) {
  let text = file;
  work.bytes += file.length;
  if (typeof file !== 'string') {
    if (file.length > limits.bytes) throw new Malformed('', `the file is longer than ${limits.bytes} bytes`);
    try {
      text = new TextDecoder('utf-8', {fatal: true, ignoreBOM: true}).decode(file);
    } catch (error) {
      throw new Malformed('', 'the file is not UTF-8, or longer than this machine reads');
    }
  } else if (utf8_length(file) > limits.bytes) {
    throw new Malformed('', `the file is longer than ${limits.bytes} bytes`);
  }
  if (text.startsWith('\ufeff')) {
    if (!byte_order_mark) throw new Malformed('line 1', 'a byte order mark; remove it');
    text = text.slice(1);
  }
  return text;
}

/** RFC 8259 to the letter: objects as Map, numbers as Numeral; no member twice; the limits of §2. */
class JsonReader {
  constructor(text, limits) {
    this.text = text;
    this.limits = limits;
    this.ascii = !/[^\x00-\x7f]/.test(text);
    this.at = 0;
    this.depth = 0;
    this.count = 0;
  }

  fail(problem) {
    const line = this.text.slice(0, this.at).split('\n').length;
    throw new Malformed(`line ${line}`, problem);
  }

  whole() {
    this.space();
    if (this.at === this.text.length) this.fail('the file is empty');
    const value = this.value('');
    this.space();
    if (this.at < this.text.length) this.fail('not JSON: something follows the end');
    return value;
  }

  space() {
    for (;;) {
      const c = this.text.charCodeAt(this.at);
      if (c !== 32 && c !== 10 && c !== 13 && c !== 9) return;
      ++this.at;
    }
  }

  value(member) {
    if (++this.count > this.limits.values && this.depth > 0) {
      this.fail(`more than ${this.limits.values} values in one place`);
    }
    const c = this.text[this.at];
    if (c === '{' || c === '[') {
      if (++this.depth > this.limits.depth) this.fail(`nesting deeper than ${this.limits.depth}`);
      const result = c === '{' ? this.object() : this.array(this.depth === 2 && this.limits.members.has(member));
      --this.depth;
      return result;
    }
    if (c === '"') return this.string();
    if (c === '-' || (c >= '0' && c <= '9')) return this.numeral();
    for (const [word, meaning] of [['true', true], ['false', false], ['null', null]]) {
      if (this.text.startsWith(word, this.at)) {
        this.at += word.length;
        return meaning;
      }
    }
    return this.fail(c === undefined ? 'not JSON: the file ends here' : `not JSON: found ${quoted(c)}`);
  }

  /** What a list has between and after its elements: true if another one follows. */
  another(end) {
    this.space();
    const c = this.text[this.at++];
    if (c === end) return false;
    if (c !== ',') {
      --this.at;
      this.fail(`not JSON: expected , or ${end}`);
    }
    this.space();
    if (this.text[this.at] === end) this.fail('not JSON: a comma after the last element; remove it');
    return true;
  }

  opens(end) {
    ++this.at;
    this.space();
    if (this.text[this.at] !== end) return true;
    ++this.at;
    return false;
  }

  array(each) {
    const result = [];
    if (!this.opens(']')) return result;
    do {
      if (each) this.count = 0;
      result.push(this.value(''));
    } while (this.another(']'));
    return result;
  }

  object() {
    const result = new Map();
    if (!this.opens('}')) return result;
    do {
      if (this.text[this.at] !== '"') this.fail('not JSON: expected a string, the name of a member');
      const key = this.string();
      if (result.has(key)) this.fail(`the member ${quoted(key)} is repeated`);
      this.space();
      if (this.text[this.at] !== ':') this.fail('not JSON: expected :');
      ++this.at;
      this.space();
      if (this.depth === 1) this.count = 0;
      result.set(key, this.value(key));
    } while (this.another('}'));
    return result;
  }

  numeral() {
    const form = /-?(?:0|[1-9][0-9]*)(?:\.[0-9]+)?(?:[eE][+-]?[0-9]+)?/y;
    form.lastIndex = this.at;
    const match = form.exec(this.text);
    if (match === null) this.fail('not JSON: not a number');
    if (match[0].length > this.limits.numeral) this.fail(`a number of more than ${this.limits.numeral} characters`);
    this.at += match[0].length;
    return new Numeral(match[0]);
  }

  string() {
    const text = this.text, start = ++this.at;
    let result = '', from = start, escaped = false;
    for (;; ++this.at) {
      if (this.at - start > this.limits.string) this.fail(`a string of more than ${this.limits.string} bytes`);
      const c = text.charCodeAt(this.at);
      if (c === 34) break;
      if (Number.isNaN(c)) this.fail('not JSON: the file ends in a string');
      if (c < 32) this.fail('not JSON: a control character in a string');
      if (c !== 92) continue;
      escaped = true;
      result += text.slice(from, this.at);
      const e = text[++this.at], k = 'bfnrt"\\/'.indexOf(e);
      if (e === 'u') {
        const digits = text.slice(this.at + 1, this.at + 5);
        if (!/^[0-9a-fA-F]{4}$/.test(digits)) this.fail('not JSON: \\u needs four hexadecimal digits');
        result += String.fromCharCode(parseInt(digits, 16));
        this.at += 4;
      } else if (e !== undefined && k >= 0) {
        result += '\b\f\n\r\t"\\/'[k];
      } else {
        this.fail('not JSON: an escape that is none');
      }
      from = this.at + 1;
    }
    const bytes = this.ascii ? this.at - start : utf8_length(text.slice(start, this.at));
    if (bytes > this.limits.string) this.fail(`a string of more than ${this.limits.string} bytes`);
    result += text.slice(from, this.at++);
    if (escaped && /[\ud800-\udfff]/.test(result) &&
        /[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/.test(result)) {
      this.fail('half of a surrogate pair');
    }
    return result;
  }
}

function described(value) {
  if (value === undefined) return 'nothing';
  if (value instanceof Map) return 'an object';
  if (Array.isArray(value)) return `an array of ${value.length}`;
  if (value instanceof Numeral) return printable(value.text);
  return typeof value === 'string' ? `the string ${quoted(value)}` : String(value);
}

function expected(what, value, place) {
  throw new Malformed(place, `found ${described(value)}, expected ${what}`);
}

function array_of(value, place, length) {
  if (!Array.isArray(value) || (length !== undefined && value.length !== length)) {
    expected(length === undefined ? 'an array' : `an array of ${length}`, value, place);
  }
  return value;
}

function object_at(value, place) {
  if (!(value instanceof Map)) expected('an object', value, place);
  return value;
}

const inside = (place, name) => (place === '' ? name : `${place}.${name}`);

// ---------------------------------------------------------------------------- The grasp file (§1, §6)

/** The exact value of a number's text in a grasp file or an option, or null. */
function exact_decimal(text) {
  if (text.length > LONGEST_GRASP_NUMBER) return null;
  let match = /^([+-]?[0-9]+)\/([0-9]+)$/.exec(text);
  if (match !== null) {
    const d = BigInt(match[2]);
    return d === 0n ? null : Fraction.of(BigInt(match[1].replace('+', '')), d);
  }
  match = /^([+-]?)([0-9]+)(?:\.([0-9]+))?(?:[eE]([+-]?)0*([0-9]*))?$/.exec(text);
  if (match === null || (match[4] !== undefined && !/[0-9]$/.test(text))) return null;
  const [, sign, whole, part = '', exponent_sign, exponent = ''] = match;
  if (exponent.length > 4 || Number(exponent) > MOST_EXPONENT) return null;
  const shift = (exponent_sign === '-' ? -1 : 1) * Number(exponent) - part.length;
  const digits = BigInt(whole + part) * (sign === '-' ? -1n : 1n);
  return shift >= 0 ? Fraction.of(digits * 10n ** BigInt(shift)) : Fraction.of(digits, 10n ** BigInt(-shift));
}

// docs/grasp_file.md: a JSON number, rounded to 64 bits, is below 2^16384.
const JSON_NUMBER_END = new Fraction((1n << 16384n) - (1n << 16319n), 1n);

function grasp_number(value, place) {
  if (!(value instanceof Numeral) && typeof value !== 'string') expected('a number', value, place);
  const number = exact_decimal(value instanceof Numeral ? value.text : value);
  if (number === null) expected('a decimal or a fraction of integers, such as 0.25 or "3/5"', value, place);
  if (value instanceof Numeral && number.magnitude().compare(JSON_NUMBER_END) >= 0) {
    throw new Malformed(place, 'a JSON number must be below 2^16384; write it as a string');
  }
  return number;
}

const grasp_numbers = (value, place, length) =>
    array_of(value, place, length).map((x, j) => grasp_number(x, `${place}[${j}]`));

/** An INTERVAL (§6) as [low, high], or a number as an interval of one. */
function grasp_interval(value, place, version) {
  if (!(value instanceof Map)) {
    const number = grasp_number(value, place);
    return [number, number];
  }
  if (version < 2) throw new Malformed(place, 'an interval needs "format": "stickslip-grasp/2"');
  known_members(value, place, ['min', 'max'], ['min', 'max']);
  const low = grasp_number(value.get('min'), `${place}.min`), high = grasp_number(value.get('max'), `${place}.max`);
  if (low.compare(high) > 0) throw new Malformed(place, 'min must not be above max');
  return [low, high];
}

const grasp_intervals = (value, place, length, version) =>
    array_of(value, place, length).map((x, j) => grasp_interval(x, `${place}[${j}]`, version));

function known_members(object, place, known, required = []) {
  for (const key of object_at(object, place).keys()) {
    if (!known.includes(key)) {
      throw new Malformed(place, `unknown member ${quoted(key)}; those allowed here are ${known.join(', ')}`);
    }
  }
  for (const key of required) {
    if (!object.has(key)) throw new Malformed(place, `the member "${key}" is missing`);
  }
}

function grasp_string(value, place) {
  if (typeof value !== 'string') expected('a string', value, place);
  return value;
}

const zeros = (count) => Array(count).fill(ZERO);

/** Rings with their edges: of each polygon a list of {a, b, inward}, where inward is the edge's normal. */
function read_outline(value, place) {
  const is_vertex = (v) => Array.isArray(v) && !Array.isArray(v[0]);
  const first = (v) => (Array.isArray(v) ? v[0] : undefined);
  let polygons = array_of(value, place);
  if (is_vertex(first(polygons))) polygons = [[polygons]];
  else if (is_vertex(first(first(polygons)))) polygons = [polygons];
  if (polygons.length === 0) throw new Malformed(place, 'no polygon');
  return polygons.map((rings, j) => {
    if (array_of(rings, `${place}, polygon ${j}`).length === 0) throw new Malformed(`${place}, polygon ${j}`, 'no ring');
    return rings.flatMap((ring, k) => {
      const where = `${place}, polygon ${j}, ring ${k}`;
      const vertices = array_of(ring, where).map((v, l) => grasp_numbers(v, `${where}, vertex ${l}`, 2));
      if (vertices.length < 3) throw new Malformed(where, 'fewer than three vertices');
      const ends = vertices.map((a, l) => [a, vertices[(l + 1) % vertices.length]]);
      let area = ZERO;
      for (const [a, b] of ends) {
        if (same_list(a, b)) throw new Malformed(where, 'a vertex is the same as the next');
        area = area.plus(a[0].times(b[1]).minus(a[1].times(b[0])));
      }
      if (area.isZero()) throw new Malformed(where, 'the ring has no area');
      const flip = (area.sign() < 0) !== (k > 0);
      return ends.map(([a, b]) => {
        let normal = [a[1].minus(b[1]), b[0].minus(a[0])];
        if (flip) normal = normal.map((x) => x.negated());
        const length = rational_root(dot_fractions(normal, normal));
        return {a, b, normal: length === null ? normal : normal.map((x) => x.over(length))};
      });
    });
  });
}

/** The element of a list that a whole number names. */
function named_by(number, list, place, what) {
  const k = grasp_number(number, `${place}, ${what}`);
  if (k.d !== 1n || k.n < 0n || k.n >= BigInt(list.length)) {
    throw new Malformed(`${place}, ${what}`, `there is no ${what} ${printable(k)}; they are 0 to ${list.length - 1}`);
  }
  return list[Number(k.n)];
}

/** FORMAT.md §1, §14: a mesh, which has no meaning here. */
function check_mesh(value, where) {
  known_members(value, where, ['vertices', 'faces'], ['vertices', 'faces']);
  const vertices = array_of(value.get('vertices'), `${where}.vertices`)
      .map((vertex, i) => grasp_numbers(vertex, `${where}.vertices[${i}]`, 3));
  const faces = array_of(value.get('faces'), `${where}.faces`);
  if (faces.length === 0) throw new Malformed(`${where}.faces`, 'no face');
  faces.forEach((face, j) => {
    const place = `${where}.faces[${j}]`;
    if (array_of(face, place).length < 3) throw new Malformed(place, 'fewer than three vertices');
    for (const number of face) named_by(number, vertices, place, 'vertex');
  });
}

function read_place(value, place, outline) {
  if (outline === null) throw new Malformed(place, 'the file has no outline');
  let [polygon, edge, share] = [new Numeral('0'), undefined, undefined];
  if (Array.isArray(value)) {
    [edge, share] = array_of(value, place, 2);
  } else {
    known_members(value, place, ['polygon', 'edge', 'share'], ['edge', 'share']);
    [edge, share] = [value.get('edge'), value.get('share')];
    if (value.has('polygon')) polygon = value.get('polygon');
  }
  const {a, b, normal} = named_by(edge, named_by(polygon, outline, place, 'polygon'), place, 'edge');
  const t = grasp_number(share, `${place}, share`);
  if (t.sign() < 0 || t.compare(ONE) > 0) throw new Malformed(`${place}, share`, `${printable(t)} is not from 0 to 1`);
  return [a.map((x, j) => x.plus(t.times(b[j].minus(x)))), normal];
}

/**
 * The wrench of a force f at p: plane (f, p × f), space likewise with three numbers each. What acts along a coordinate (§14)
 * has one number and no place.
 */
function wrench_at(f, p) {
  if (f.length === 1) return f;
  return f.length === 2 ? [...f, p[0].times(f[1]).minus(p[1].times(f[0]))] : [...f, ...cross_product(p, f)];
}

/** Gᵀ times a row (§14), G by its columns. One body has no G. */
const pulled = (motion, row) => (motion === null ? row : motion.map((column) => dot_fractions(column, row)));

/** A vector against the last axis, of this length. */
const downwards = (length, dimension) => [...zeros(dimension - 1), length.negated()];

/** The wrench of a load, as intervals. Of several bodies it is about its `body`, and in Q^D. `gravity` is null if the file has none. */
function read_load(value, place, size, gravity, bodies) {
  const dimension = size === 3 ? 2 : 3, body = bodies === null ? [] : ['body'];
  const known = (required, optional = []) => known_members(value, place, [...body, ...required, ...optional], [...body, ...required]);
  const vector = (name) => grasp_numbers(value.get(name), `${place}.${name}`, dimension);
  let wrench;
  if (object_at(value, place).has('force')) {
    known(['force', 'at']);
    wrench = wrench_at(vector('force'), vector('at'));
  } else if (value.has('torque')) {
    known(['torque']);
    const torque = dimension === 2 ? [grasp_number(value.get('torque'), `${place}.torque`)] : vector('torque');
    wrench = [...zeros(dimension), ...torque];
  } else if (value.has('wrench') && bodies !== null) {
    known(['wrench']);
    wrench = grasp_intervals(value.get('wrench'), `${place}.wrench`, size, 3);
    if (bodies.turns.has(value.get('body'))) {
      throw new Malformed(`${place}.wrench`, 'its body is a link; give a force at a point, a weight or a torque');
    }
  } else if (value.has('mass')) {
    known(['mass', 'at']);
    const mass = grasp_number(value.get('mass'), `${place}.mass`);
    if (mass.sign() < 0) throw new Malformed(`${place}.mass`, 'a mass must not be below 0');
    wrench = wrench_at((gravity ?? downwards(STANDARD_GRAVITY, dimension)).map((x) => mass.times(x)), vector('at'));
  } else {
    known(['weight', 'at'], ['direction']);
    const weight = grasp_number(value.get('weight'), `${place}.weight`);
    if (weight.sign() < 0) throw new Malformed(`${place}.weight`, 'a weight must not be below 0');
    let down = gravity ?? downwards(ONE, dimension);
    if (value.has('direction')) down = vector('direction');
    const length = rational_root(dot_fractions(down, down));
    if (length === null || length.isZero()) {
      throw new Malformed(`${place}.direction`, 'the length must be rational and not 0');
    }
    wrench = wrench_at(down.map((x) => weight.times(x).over(length)), vector('at'));
  }
  const ends = wrench.map((x) => (Array.isArray(x) ? x : [x, x]));
  if (bodies === null) return ends;
  // Where one end is not the other, J has ones and zeros alone.
  const motion = named_motion(bodies, value.get('body'), `${place}.body`, false);
  const [low, high] = [0, 1].map((end) => pulled(motion, ends.map((x) => x[end])));
  return low.map((x, j) => [x, high[j]]);
}

const add_intervals = (a, b) => a.map(([low, high], j) => [low.plus(b[j][0]), high.plus(b[j][1])]);

/** The wrench of a file or a case, as intervals; null if it has neither `wrench` nor `loads`. */
function read_wrench(object, place, size, version, gravity, bodies = null) {
  if (object.has('wrench') && object.has('loads')) throw new Malformed(place, 'both wrench and loads');
  if (object.has('wrench')) return grasp_intervals(object.get('wrench'), inside(place, 'wrench'), bodies === null ? size : bodies.dimension, version);
  if (!object.has('loads')) return null;
  return array_of(object.get('loads'), inside(place, 'loads'))
      .map((load, j) => read_load(load, `${inside(place, 'loads')}[${j}]`, size, gravity, bodies))
      .reduce(add_intervals, Array(bodies === null ? size : bodies.dimension).fill([ZERO, ZERO]));
}

/** The wrenches of `cases`, by name. */
function read_cases(value, common, size, version, gravity, bodies = null) {
  const cases = new Map();
  if (array_of(value, 'cases').length === 0) throw new Malformed('cases', 'the list is empty');
  value.forEach((one, j) => {
    const place = `cases[${j}]`;
    known_members(one, place, ['name', 'wrench', 'loads'], ['name']);
    const name = grasp_string(one.get('name'), `${place}.name`);
    if (name === '' || cases.has(name)) throw new Malformed(`${place}.name`, 'empty, or that of another case');
    const own = read_wrench(one, place, size, version, gravity, bodies);
    if (own === null) throw new Malformed(place, 'neither wrench nor loads');
    cases.set(name, add_intervals(own, common));
  });
  return cases;
}

const RANGES = {friction: (x) => x.sign() >= 0, stiffness: (x) => x.sign() > 0, preload: (x) => x.sign() >= 0};

/** Whether a text begins as numbers do, and names of frictions do not. */
const begins_as_number = (text) => text === '' || '+-.0123456789'.includes(text[0]);

/** The frictions of a file that have names, by them. */
function read_friction_names(file, version) {
  const names = new Map();
  if (!file.has('friction')) return names;
  const stated = object_at(file.get('friction'), 'friction');
  for (const name of stated.keys()) {
    if (begins_as_number(name)) throw new Malformed(`friction.${printable(name)}`, 'a name begins neither with a digit nor with +, - or .');
    const interval = grasp_interval(stated.get(name), `friction.${printable(name)}`, version);
    if (interval[0].sign() < 0) throw new Malformed(`friction.${printable(name)}`, `${printable(interval[0])} is out of range`);
    names.set(name, interval);
  }
  return names;
}

function read_range(object, name, place, version, frictions) {
  const stated = object.get(name);
  if (name === 'friction' && typeof stated === 'string' && !begins_as_number(stated)) {
    if (!frictions.has(stated)) expected('a number, or a name in "friction" of the file', stated, inside(place, name));
    return frictions.get(stated);
  }
  const interval = grasp_interval(object.get(name), inside(place, name), version);
  if (!RANGES[name](interval[0])) {
    throw new Malformed(inside(place, name), `${printable(interval[0])} is out of range`);
  }
  return interval;
}

/** e of §15, as an interval. */
function read_torsion(object, place, space) {
  const where = inside(place, 'torsion'), torsion = grasp_number(object.get('torsion'), where);
  if (!space) throw new Malformed(where, 'the grasp is in the plane, and has none');
  if (torsion.sign() < 0) throw new Malformed(where, `${printable(torsion)} is out of range`);
  return [torsion, torsion];
}

const STANDARD_GRAVITY = new Fraction(981n, 100n);
const PI = new Fraction(314159265358979323846264338328n, 10n ** 29n);

const floor_of = (x) => (x.n - ((x.n % x.d) + x.d) % x.d) / x.d;

/** FORMAT.md §1, angles: the vector that stands for this direction. */
function direction_at(degrees) {
  const whole = (n) => new Fraction(n, 1n), [bits32, bits64] = [whole(1n << 32n), whole(1n << 64n)];
  const quarter = floor_of(degrees.plus(whole(45n)).over(whole(90n))), rest = degrees.minus(whole(90n * quarter));
  let [x, y] = [ONE, ZERO];
  if (rest.equals(whole(-45n))) {
    y = ONE.negated();
  } else if (!rest.isZero()) {
    const half = whole(floor_of(rest.times(PI).over(whole(360n)).times(bits64))).over(bits64), square = half.times(half);
    let cosine = ONE, sine = ONE;  // sine over half
    for (let k = 4n; k >= 0n; --k) {
      cosine = ONE.minus(square.times(cosine).over(whole((2n * k + 1n) * (2n * k + 2n))));
      sine = ONE.minus(square.times(sine).over(whole((2n * k + 2n) * (2n * k + 3n))));
    }
    const t = whole(floor_of(half.times(sine).over(cosine).times(bits32).plus(new Fraction(1n, 2n)))).over(bits32);
    const over = ONE.plus(t.times(t));
    [x, y] = [ONE.minus(t.times(t)).over(over), t.plus(t).over(over)];
  }
  for (let turns = ((quarter % 4n) + 4n) % 4n; turns > 0n; --turns) [x, y] = [y.negated(), x];
  return [x, y];
}

/** A normal: [n⁰, slope]. */
function read_normal(value, place, dimension, version) {
  let slope = ZERO;
  if (value instanceof Map && version >= 2) {
    const by_angle = value.has('angle');
    if (by_angle && dimension === 3) throw new Malformed(`${place}.angle`, 'the grasp is in space; give [x, y, z]');
    known_members(value, place, [by_angle ? 'angle' : 'direction', 'slope'], by_angle ? ['angle'] : ['direction', 'slope']);
    const direction = by_angle ? direction_at(grasp_number(value.get('angle'), `${place}.angle`)) : null;
    if (by_angle && !value.has('slope')) return [direction, slope];
    slope = grasp_number(value.get('slope'), `${place}.slope`);
    if (slope.sign() < 0 || slope.compare(ONE) >= 0) throw new Malformed(`${place}.slope`, 'a slope is from 0 to below 1');
    if (by_angle) return [direction, slope];
    value = value.get('direction');
    place += '.direction';
  }
  const normal = grasp_numbers(value, place, dimension);
  if (all_zero(normal)) throw new Malformed(place, 'the normal is zero');
  return [normal, slope];
}

/**
 * What all versions have: {space, size, defaults, contacts, gravity, frictions}, where size is the dimension of one body's motions, and
 * gravity is null if there is none.
 */
function read_head(file, version) {
  if (file.has('name')) grasp_string(file.get('name'), 'name');
  const contacts = array_of(file.get('contacts'), 'contacts');
  if (contacts.length > MOST_CONTACTS) throw new Malformed('contacts', `more than ${MOST_CONTACTS}`);

  const length_in = (value, key) => {
    const list = value instanceof Map ? value.get(key) : undefined;
    return Array.isArray(list) ? list.length : 0;
  };
  const space = version >= 2 &&
      (contacts.length > 0 ? length_in(contacts[0], 'position') === 3 : version === 2 && length_in(file, 'wrench') === 6);

  if (file.has('units')) {
    known_members(file.get('units'), 'units', ['length', 'force'], ['length', 'force']);
    for (const [key, value] of file.get('units')) {
      const bytes = utf8_length(grasp_string(value, `units.${key}`));
      if (bytes < 1 || bytes > 16) throw new Malformed(`units.${key}`, 'must be of 1 to 16 bytes');
    }
  }
  const gravity = file.has('gravity') ? grasp_numbers(file.get('gravity'), 'gravity', space ? 3 : 2) : null;
  const frictions = read_friction_names(file, version);
  const defaults = new Map([['stiffness', [ONE, ONE]], ['preload', [ZERO, ZERO]], ['torsion', [ZERO, ZERO]]]);
  if (file.has('defaults')) {
    const stated = file.get('defaults');
    known_members(stated, 'defaults', ['friction', 'stiffness', 'preload', ...(version === 3 ? ['torsion'] : [])]);
    for (const name of stated.keys()) {
      defaults.set(name, name === 'torsion' ? read_torsion(stated, 'defaults', space) : read_range(stated, name, 'defaults', version, frictions));
    }
  }
  return {space, size: space ? 6 : 3, defaults, contacts, gravity, frictions};
}

/** B (§1, max motion) of a length and an angle, where there are no joints. */
const spread = (length, angle, size, space) =>
  Array.from({length: size}, (_, j) => (j % (space ? 6 : 3) < (space ? 3 : 2) ? length : angle));

/** B of a file, or null if it has none. */
function read_max_motion(file, size, space, has_joints) {
  const place = 'max_motion', value = file.get(place);
  if (value === undefined) return null;
  const above_zero = (b, where) => (b.sign() > 0 ? b : expected('a number above 0', `${b}`, where));
  if (!(value instanceof Map)) return grasp_numbers(value, place, size).map((b, j) => above_zero(b, `${place}[${j}]`));
  if (has_joints) throw new Malformed(place, `must be an array of ${size} numbers, one for each coordinate, as there are joints`);
  known_members(value, place, ['length', 'angle'], ['length', 'angle']);
  const [length, angle] = ['length', 'angle'].map((name) => above_zero(grasp_number(value.get(name), `${place}.${name}`), `${place}.${name}`));
  return spread(length, angle, size, space);
}

/** A contact, in version 3 without its bodies. */
function read_contact(value, place, {space, defaults, frictions}, version, outline = null) {
  object_at(value, place);
  const on = version === 2 && !space && value.has('on');
  const needed = [...(version === 3 ? ['of'] : []), ...(on ? ['on'] : ['position', 'normal'])];
  known_members(value, place, [...needed, ...(version === 3 ? ['by', 'torsion'] : []), 'friction', 'stiffness', 'preload'], needed);
  const range = (name) => {
    if (value.has(name)) return read_range(value, name, place, version, frictions);
    if (!defaults.has(name)) throw new Malformed(place, `the member "${name}" is missing`);
    return defaults.get(name);
  };
  let p, n, slope = ZERO;
  if (on) {
    [p, n] = read_place(value.get('on'), `${place}.on`, outline);
    p = p.map((x) => [x, x]);
  } else {
    p = grasp_intervals(value.get('position'), `${place}.position`, space ? 3 : 2, version);
    [n, slope] = read_normal(value.get('normal'), `${place}.normal`, space ? 3 : 2, version);
  }
  const [torsion] = value.has('torsion') ? read_torsion(value, place, space) : defaults.get('torsion');
  return {place, p, n, slope, mu: range('friction'), k: range('stiffness'), preload: range('preload'), torsion, motion: null, spring: false};
}

/**
 * {space, several, size, contacts, wrench, cases, motions, joints, max_motion}: each contact with p, mu, k, preload as intervals, n, slope, torsion, and of
 * several bodies motion (G by its columns) and spring; wrench as intervals, or null where only cases have one. size is D; motions has J
 * of each of several bodies and of the ground.
 */
function read_grasp(text) {
  const file = object_at(new JsonReader(text, GRASP_LIMITS).whole(), '');
  const version = {'stickslip-grasp/1': 1, 'stickslip-grasp/2': 2, 'stickslip-grasp/3': 3}[file.get('format')];
  if (version === undefined) {
    expected('"stickslip-grasp/1", "stickslip-grasp/2" or "stickslip-grasp/3"', file.get('format'), 'format');
  }
  if (version === 3) return read_several(file);
  if (file.has('bodies')) throw new Malformed('format', 'must be "stickslip-grasp/3", as the file has bodies');
  if (file.has('normals')) {
    throw new Malformed('normals', 'unknown; stickslip snap GRASP -o FILE writes normals of rational length');
  }
  const more = ['units', 'outline', 'body', 'loads', 'cases', 'max_motion', 'gravity', 'friction'];
  for (const key of more) {
    if (version === 1 && file.has(key)) throw new Malformed(key, 'needs "format": "stickslip-grasp/2"');
  }
  known_members(file, '', ['format', 'name', 'defaults', 'contacts', 'wrench', ...more],
      version === 1 ? ['contacts', 'wrench'] : ['contacts']);
  const head = read_head(file, version), {space, size, gravity} = head;
  if (space && file.has('outline')) throw new Malformed('outline', 'a grasp in space has none');
  const outline = file.has('outline') ? read_outline(file.get('outline'), 'outline') : null;
  if (file.has('body')) {
    if (!space) throw new Malformed('body', 'a grasp in the plane has none');
    check_mesh(file.get('body'), 'body');
  }
  const contacts = head.contacts.map((value, i) => read_contact(value, `contacts[${i}]`, head, version, outline));
  const wrench = read_wrench(file, '', size, version, gravity), bound = {joints: 0, max_motion: read_max_motion(file, size, space, false)};
  if (!file.has('cases')) {
    if (wrench === null) throw new Malformed('', 'neither wrench nor loads nor cases');
    return {space, several: false, size, contacts, wrench, cases: null, motions: new Map(), ...bound};
  }
  const cases = read_cases(file.get('cases'), wrench ?? Array(size).fill([ZERO, ZERO]), size, version, gravity);
  return {space, several: false, size, contacts, wrench: null, cases, motions: new Map(), ...bound};
}

// ---------------------------------------------------------------------------- Several bodies (§14)

/** A list of objects with these members, which may be left out; `name` in all of them is a string without meaning. */
function read_list(file, key, required, optional) {
  if (!file.has(key)) return [];
  return array_of(file.get(key), key).map((value, k) => {
    const place = `${key}[${k}]`;
    known_members(value, place, [...required, 'name', ...optional], required);
    if (value.has('name')) grasp_string(value.get('name'), `${place}.name`);
    return {place, value};
  });
}

/** A body: {name, on, turn}, where turn is η of a link, else null. */
function read_body(value, place, before, {space, size}) {
  known_members(value, place, ['name', 'hinge', 'slide', 'on', 'outline', 'mesh'], ['name']);
  const name = value.get('name'), dimension = space ? 3 : 2;
  if (typeof name !== 'string' || name === '' || name === GROUND || before.includes(name)) {
    expected(`a string that is not empty, not "${GROUND}", and not the name of another body`, name, `${place}.name`);
  }
  const [drawn, other] = space ? ['mesh', 'outline'] : ['outline', 'mesh'];
  if (value.has(other)) throw new Malformed(`${place}.${other}`, `the grasp is ${space ? 'in space' : 'in the plane'}; give ${drawn}`);
  if (value.has(drawn)) (space ? check_mesh : read_outline)(value.get(drawn), `${place}.${drawn}`);
  if (value.has('hinge') && value.has('slide')) throw new Malformed(place, 'both hinge and slide');
  if (!value.has('hinge') && !value.has('slide')) {
    if (value.has('on')) throw new Malformed(`${place}.on`, 'only a link, with hinge or slide, is on a body');
    return {name, on: null, turn: null};
  }
  const on = value.has('on') ? value.get('on') : GROUND;
  if (on !== GROUND && !before.includes(on)) {
    expected(`"${GROUND}" or a body that stands before this one, so that links are in no loop`, on, `${place}.on`);
  }
  const not_zero = (axis, where) => {
    if (all_zero(axis)) throw new Malformed(where, 'the direction is zero');
    return axis;
  };
  if (value.has('slide')) {
    const axis = not_zero(grasp_numbers(value.get('slide'), `${place}.slide`, dimension), `${place}.slide`);
    return {name, on, turn: [...axis, ...zeros(size - dimension)]};
  }
  const hinge = value.get('hinge'), where = `${place}.hinge`;
  if (!space) {
    const [x, y] = grasp_numbers(hinge, where, 2);
    return {name, on, turn: [y, x.negated(), ONE]};
  }
  known_members(hinge, where, ['at', 'axis'], ['at', 'axis']);
  const axis = not_zero(grasp_numbers(hinge.get('axis'), `${where}.axis`, 3), `${where}.axis`);
  return {name, on, turn: [...cross_product(grasp_numbers(hinge.get('at'), `${where}.at`, 3), axis), ...axis]};
}

/** An object of `turns` or `over`, as a Map from links to numbers. */
function read_over(value, place, links) {
  if (object_at(value, place).size === 0) throw new Malformed(place, 'no link');
  return new Map([...value].map(([link, number]) => {
    const where = `${place}.${printable(link)}`, c = links.includes(link) ? grasp_number(number, where) : null;
    if (c === null) throw new Malformed(where, `there is no such link; they are ${links.map(quoted).join(', ') || 'none'}`);
    if (c.isZero()) throw new Malformed(where, 'must not be 0');
    return [link, c];
  }));
}

/** {motions, turns, dimension}: J of each body by its columns, and of each link Σ c_bq e_q. */
function read_bodies(value, joints, head) {
  const bodies = [];
  array_of(value, 'bodies').forEach((one, k) => bodies.push(read_body(one, `bodies[${k}]`, bodies.map((b) => b.name), head)));
  if (bodies.length === 0) throw new Malformed('bodies', 'the list is empty');
  const {size} = head, links = bodies.filter((b) => b.turn !== null).map((b) => b.name);
  const by_joint = joints.map(({place, value: joint}) => read_over(joint.get('turns'), `${place}.turns`, links));
  const first = size * (bodies.length - links.length), dimension = first + joints.length;
  if (dimension > MOST_COORDINATES) throw new Malformed('bodies', `${dimension} coordinates, at most ${MOST_COORDINATES} may be`);
  const turns = new Map(links.map((link) => [link, [...zeros(first), ...by_joint.map((c) => c.get(link) ?? ZERO)]]));
  const motions = new Map([[GROUND, Array(dimension).fill(zeros(size))]]);
  let begin = 0;
  bodies.forEach(({name, on, turn}, k) => {
    if (turn === null) {
      const own = begin;
      motions.set(name, Array.from({length: dimension}, (_, q) => Array.from({length: size}, (__, j) => (q === own + j ? ONE : ZERO))));
      begin += size;
      return;
    }
    if (all_zero(turns.get(name))) throw new Malformed(`bodies[${k}]`, `no joint turns the link ${quoted(name)}`);
    motions.set(name, motions.get(on).map((column, q) => column.map((x, j) => x.plus(turns.get(name)[q].times(turn[j])))));
  });
  return {motions, turns, dimension};
}

/** J of a body, by its columns. */
function named_motion(bodies, name, place, ground) {
  if (!bodies.motions.has(name) || (name === GROUND && !ground)) expected(`the name of a body${ground ? `, or "${GROUND}"` : ''}`, name, place);
  return bodies.motions.get(name);
}

/** What acts along a row: a ratchet, or a spring. It has no place, and 1 as its normal. */
const along_row = (place, row, k, preload, spring) =>
  ({place, p: [], n: [ONE], slope: ZERO, mu: [ZERO, ZERO], k, preload, torsion: ZERO, motion: row.map((x) => [x]), spring});

function read_spring({place, value}, row, force) {
  const interval = (name) => (value.has(name) ? grasp_interval(value.get(name), `${place}.${name}`, 3) : [ZERO, ZERO]);
  const k = interval('stiffness');
  if (k[0].sign() < 0) throw new Malformed(`${place}.stiffness`, `${printable(k[0])} is out of range`);
  return along_row(place, row, k, interval(force), true);
}

function read_several(file) {
  known_members(file, '', ['format', 'name', 'units', 'bodies', 'defaults', 'joints', 'tendons', 'ratchets', 'contacts', 'wrench', 'loads', 'cases',
    'max_motion', 'gravity', 'friction'], ['bodies', 'contacts']);
  const head = read_head(file, 3), {space, size, gravity} = head;
  const joints = read_list(file, 'joints', ['turns'], ['stiffness', 'torque']);
  const tendons = read_list(file, 'tendons', ['over'], ['stiffness', 'tension']);
  const ratchets = read_list(file, 'ratchets', ['over', 'stiffness'], ['preload']);
  const bodies = read_bodies(file.get('bodies'), joints, head), {dimension} = bodies;
  const row_over = ({place, value}) => {
    const over = read_over(value.get('over'), `${place}.over`, [...bodies.turns.keys()]);
    const row = [...over].reduce((sum, [link, r]) => sum.map((x, q) => x.plus(r.times(bodies.turns.get(link)[q]))), zeros(dimension));
    if (all_zero(row)) throw new Malformed(`${place}.over`, 'its numbers cancel: no joint moves it');
    return row;
  };
  const contacts = head.contacts.map((value, i) => {
    const place = `contacts[${i}]`, contact = read_contact(value, place, head, 3);
    const of = named_motion(bodies, value.get('of'), `${place}.of`, false);
    const by = value.has('by') ? named_motion(bodies, value.get('by'), `${place}.by`, true) : bodies.motions.get(GROUND);
    if (of === by) throw new Malformed(`${place}.by`, 'a contact of a body with itself');
    return {...contact, motion: of.map((column, q) => column.map((x, j) => x.minus(by[q][j])))};
  });
  const elements = [...contacts,
    ...ratchets.map((one) => along_row(one.place, row_over(one), read_range(one.value, 'stiffness', one.place, 3),
        one.value.has('preload') ? read_range(one.value, 'preload', one.place, 3) : [ZERO, ZERO], false)),
    ...joints.map((one, q) => [one, [...zeros(dimension - joints.length), ...joints.map((_, j) => (j === q ? ONE : ZERO))]])
        .filter(([{value}]) => value.has('stiffness') || value.has('torque'))
        .map(([one, row]) => read_spring(one, row, 'torque')),
    ...tendons.map((one) => read_spring(one, row_over(one), 'tension'))];
  const wrench = read_wrench(file, '', size, 3, gravity, bodies), none = Array(dimension).fill([ZERO, ZERO]);
  const cases = file.has('cases') ? read_cases(file.get('cases'), wrench ?? none, size, 3, gravity, bodies) : null;
  return {space, several: true, size: dimension, contacts: elements, wrench: wrench ?? (cases === null ? none : null), cases, motions: bodies.motions,
    joints: joints.length, max_motion: read_max_motion(file, dimension, space, joints.length > 0)};
}

// ---------------------------------------------------------------------------- The question (§1, §6)

const KINDS = ['friction', 'stiffness', 'preload', 'position', 'normal', 'wrench'];

function option_number(text, name) {
  const number = exact_decimal(String(text));
  if (number === null) throw new Malformed(name, `${quoted(text)} is not a number such as -0.25, 1e-3 or 3/5`);
  return number;
}

/** "ball:R[:length=L][:about=X:Y[:Z]][:body=NAME]" as {radius, length, about, body}, of which the last two are null if left out. */
function option_ball(text, name) {
  const [, words, body] = /^ball:(.*?)(?::body=(.*))?$/s.exec(text), [radius, ...rest] = words.split(':'), found = {};
  let member = '';
  for (const word of rest) {
    const [, key, value] = /^(length|about)=(.*)$/s.exec(word) ?? [];
    if (key !== undefined && !(key in found)) {
      member = key;
      found[key] = [value];
    } else if (key === undefined && member === 'about' && !word.includes('=')) {
      found.about.push(word);
    } else {
      throw new Malformed(name, `${quoted(word)} is not length=L, about=X:Y, about=X:Y:Z or body=NAME, each at most once, and body the last`);
    }
  }
  const ball = {radius: option_number(radius, name), length: option_number(found.length ?? '1', name),
    about: found.about === undefined ? null : found.about.map((x) => option_number(x, name)), body: body ?? null};
  for (const key of ['radius', 'length']) {
    if (ball[key].sign() <= 0) throw new Malformed(name, `the ${key} ${printable(ball[key])} must be above 0`);
  }
  return ball;
}

const is_ball = (tolerance) => tolerance !== undefined && 'radius' in tolerance;

/** A tolerance as {value, percent}, or a ball of loads. */
function option_tolerance(kind, text, name) {
  if (kind === 'wrench' && String(text).startsWith('ball:')) return option_ball(text, name);
  const percent = String(text).endsWith('%');
  const value = option_number(percent ? String(text).slice(0, -1) : text, name);
  if (value.sign() < 0) throw new Malformed(name, 'a tolerance must not be below 0');
  return {value, percent};
}

function widened([low, high], tolerance) {
  if (tolerance === undefined) return [low, high];
  const by = (x) => (tolerance.percent ? tolerance.value.times(x.magnitude()).over(Fraction.of(100n)) : tolerance.value);
  return [low.minus(by(low)), high.plus(by(high))];
}

/** The ball of loads for these bodies, with the point that an option may leave out. */
function placed_ball(ball, {space, several, motions}, wrench, name) {
  const about = ball.about ?? zeros(space ? 3 : 2), bodies = [...motions.keys()].filter((body) => body !== GROUND);
  const bad = (found) => { throw new Malformed(name, found); };
  if (about.length !== (space ? 3 : 2)) bad(`about has ${about.length} coordinates, must have ${space ? 3 : 2}`);
  if (!several && ball.body !== null) bad('a body, but the grasp is of one alone; leave it out');
  if (several && !bodies.includes(ball.body)) {
    bad(`${ball.body === null ? 'no body' : quoted(ball.body)}, must be one of ${bodies.map(quoted).join(', ')}`);
  }
  if (!wrench.every(([low, high]) => low.equals(high))) bad(`the wrench is ${list_text(wrench.map(interval_text))}, must be numbers`);
  return {...ball, about};
}

/** The work of loads (§6): all w = base + B z with each z_j in its range and, of a ball, z in it. */
class Loads {
  /** moves is B by its columns, null for 1; radii, of a ball, how far each z_j goes in it. */
  constructor(base, moves, ranges, radii) {
    Object.assign(this, {base, moves, ranges, radii});
  }
  static within(wrench) { return new Loads(wrench.map(() => ZERO), null, wrench, null); }
  static inBall({radius, length, about, body}, wrench, motions) {
    const size = about.length, unit = (n, j) => Array.from({length: n}, (_, k) => (k === j ? ONE : ZERO));
    const all = size === 2 ? 3 : 6, every = Array.from({length: all}, (_, j) => j);
    const ways = every.map((j) => (j < size ? wrench_at(unit(size, j), about) : unit(all, j)));
    const radii = every.map((j) => (j < size ? radius : radius.times(length)));
    return new Loads(wrench.map(([w]) => w), ways.map((way) => pulled(body === null ? null : motions.get(body), way)),
        radii.map((r) => [r.negated(), r]), radii);
  }
  /** Λ(y) */
  most(y) {
    const moved = pulled(this.moves, y);
    let work = moved.reduce((sum, c, j) => sum.plus(c.times(this.ranges[j][c.sign() > 0 ? 1 : 0])), ZERO);
    if (this.radii !== null) {
      const reach = moved.map((c, j) => c.times(this.radii[j])), bound = root_above(dot_fractions(reach, reach), 1);
      if (bound.compare(work) < 0) work = bound;
    }
    return dot_fractions(this.base, y).plus(work);
  }
  isPoint() { return this.ranges.every(is_point); }
  /** Those of q⁰: of a ball each z_j is the nearest to 0. */
  middle() {
    return this.withRanges(this.ranges.map(([low, high]) => Array(2).fill(this.radii === null ? middle([low, high])
      : low.sign() > 0 ? low : high.sign() < 0 ? high : ZERO)));
  }
  withRanges(ranges) { return new Loads(this.base, this.moves, ranges, this.radii); }
}

/**
 * The question as it is asked: what the options say, and every contact with the intervals of its numbers.
 * growth is Pᵘ; length is |n⁰|, null if irrational; by_claims says whether a margin is a list of claims.
 */
function ask(grasp, options) {
  const {space, several, size} = grasp;
  const asked = 'the question';
  const vector = (value, name) => {
    const numbers = value.map((x) => option_number(x, `${asked}: ${name}`));
    if (numbers.length !== size) throw new Malformed(`${asked}: ${name}`, `${numbers.length} numbers, expected ${size}`);
    return numbers;
  };
  const given = (name) => options[name] !== undefined && options[name] !== null;
  const law = given('normal_law') ? options.normal_law : 'unilateral';
  if (law !== 'unilateral' && law !== 'bilateral') throw new Malformed(`${asked}: normal law`, quoted(law));
  const preload = given('preload') ? option_number(options.preload, `${asked}: preload`) : null;
  if (preload !== null && preload.sign() < 0) throw new Malformed(`${asked}: preload`, 'it must not be below 0');
  const direction = given('direction') ? vector(options.direction, 'direction') : null;
  const scale = options.preload_direction === 'scale';
  let growth = null;
  if (given('preload_direction') && !scale) {
    growth = options.preload_direction.map((x) => option_number(x, `${asked}: preload direction`));
    if (growth.length !== grasp.contacts.length || growth.some((x, i) => x.sign() < 0 && !grasp.contacts[i].spring)) {
      throw new Malformed(`${asked}: preload direction`, 'it must have one number for each contact, of all but springs >= 0');
    }
  }
  const margin = direction !== null || scale || growth !== null;

  // w, after the table of §1.
  let wrench;
  if (given('wrench') && given('case')) throw new Malformed(asked, 'both a wrench and a case');
  if (given('wrench')) {
    wrench = vector(options.wrench, 'wrench').map((x) => [x, x]);
  } else if (given('case')) {
    if (grasp.cases === null || !grasp.cases.has(options.case)) {
      throw new Malformed(`${asked}: case`, `the file has no case ${quoted(options.case)}`);
    }
    wrench = grasp.cases.get(options.case);
  } else if (direction !== null) {
    wrench = Array(size).fill([ZERO, ZERO]);
  } else if (grasp.wrench === null) {
    throw new Malformed(asked, `one of the cases must be named: ${[...grasp.cases.keys()].map(quoted).slice(0, 8).join(', ')}`);
  } else {
    wrench = grasp.wrench;
  }

  // B, null if motions are not bounded.
  let {max_motion} = grasp;
  if (given('max_motion')) {
    const where = `${asked}: max_motion`;
    max_motion = options.max_motion === 'none' ? null : options.max_motion.map((x) => option_number(x, where));
    if (max_motion !== null && max_motion.some((b) => b.sign() <= 0)) throw new Malformed(where, 'each number must be above 0');
    if (max_motion !== null && max_motion.length === 2 && grasp.joints === 0) max_motion = spread(...max_motion, size, space);
    if (max_motion !== null && max_motion.length !== size) {
      throw new Malformed(where, `${max_motion.length} numbers, expected ${size}${grasp.joints > 0 ? '' : ', or a length and an angle'}`);
    }
  }

  const uncertain = new Map();
  for (const kind of KINDS) {
    if (given('uncertain') && options.uncertain[kind] !== undefined) {
      uncertain.set(kind, option_tolerance(kind, options.uncertain[kind], `${asked}: uncertain ${kind}`));
    }
  }
  if (given('uncertain') && uncertain.size !== Object.keys(options.uncertain).length) {
    throw new Malformed(`${asked}: uncertain`, `the kinds are ${KINDS.join(', ')}`);
  }
  const slopes = uncertain.get('normal');
  if (slopes !== undefined && slopes.percent) throw new Malformed(`${asked}: uncertain normal`, 'it must not be a percentage');

  const contacts = grasp.contacts.map((contact, i) => {
    const {n, motion, spring} = contact, touches = n.length > 1;  // else a ratchet or a spring
    const own = preload === null || !touches ? contact.preload : [preload, preload];
    const one = {
      n, motion, spring,
      p: contact.p.map((x) => widened(x, uncertain.get('position'))),
      slope: slopes === undefined || !touches ? contact.slope : contact.slope.plus(slopes.value),
      mu: touches ? widened(contact.mu, uncertain.get('friction')) : contact.mu,
      k: widened(contact.k, uncertain.get('stiffness')),
      preload: widened(scale ? [ZERO, ZERO] : own, uncertain.get('preload')),
      growth: scale ? own[0] : growth === null ? ZERO : growth[i],
    };
    for (const [name, ok] of [['friction', one.mu[0].sign() >= 0], ['stiffness', one.k[0].sign() >= (spring ? 0 : 1)],
      ['preload', spring || one.preload[0].sign() >= 0], ['slope', one.slope.compare(contact.torsion.isZero() ? ONE : ZERO) < 0 || one.slope.isZero()]]) {
      if (!ok) throw new Malformed(contact.place, `the ${name} may be out of range within its tolerance`);
    }
    one.square = dot_fractions(one.n, one.n);
    one.gamma = contact.torsion.times(contact.torsion).over(one.square);
    one.length = rational_root(one.square);
    const file_interval = scale && !own[0].equals(own[1]);
    one.point = [...one.p, one.mu, one.k, one.preload].every(([a, b]) => a.equals(b)) && one.slope.isZero() && !file_interval;
    one.pressed = one.preload[1].sign() > 0 || one.growth.sign() > 0;
    return one;
  });
  let loads = null;
  if (is_ball(uncertain.get('wrench'))) {
    const ball = placed_ball(uncertain.get('wrench'), grasp, wrench, `${asked}: uncertain wrench`);
    uncertain.set('wrench', ball);
    loads = Loads.inBall(ball, wrench, grasp.motions);
  } else {
    loads = Loads.within(wrench.map((x) => widened(x, uncertain.get('wrench'))));
  }
  const point = contacts.every((c) => c.point) && loads.isPoint();
  if (margin) {
    // A number that *preload* or *wrench* replaced is not asked about.
    if (!point || uncertain.size > 0) throw new Malformed(asked, 'a margin is about one grasp, without intervals or tolerances');
    if ((direction === null || all_zero(direction)) && contacts.every((c) => c.growth.isZero())) {
      throw new Malformed(asked, 'the direction is 0');
    }
  }
  const enclosed = contacts.some((c) => c.pressed && c.length === null);
  return {space, several, size, m: contacts.length, touching: contacts.filter((c) => c.n.length > 1).length, law, bilateral: law === 'bilateral', preload, direction, scale, growth, margin, uncertain,
    wrench, loads, contacts, max_motion, box: !point || enclosed, by_claims: space || several || max_motion !== null || enclosed,
    u: direction ?? Array(size).fill(ZERO)};
}

// ---------------------------------------------------------------------------- The certificate (§2, §5, §6)

function read_number(value, place) {
  const text = value instanceof Numeral ? value.text : value;
  if (typeof text === 'string') {
    if (/^-?[0-9]+$/.test(text)) return new Fraction(BigInt(text), 1n);
    const match = typeof value === 'string' ? /^(-?[0-9]+)\/([0-9]+)$/.exec(text) : null;
    if (match !== null) {
      const d = BigInt(match[2]);
      if (d !== 0n) return Fraction.of(BigInt(match[1]), d);
    }
  }
  return expected('an integer, or a string such as "-2" or "3/5"', value, place);
}

const read_numbers = (value, place, length) => array_of(value, place, length).map((x) => read_number(x, place));

/** A CONTACT, an INDEX or m: beyond 2^53 all are alike. */
function read_index(value, place) {
  if (!(value instanceof Numeral) || !/^(-0|[0-9]+)$/.test(value.text)) expected('an integer >= 0', value, place);
  return Number(value.text);
}

/** Members in their order: names, those with ? optional. Returns an object of those that are there. */
function members_in_order(value, place, names) {
  const keys = [...object_at(value, place).keys()], found = {};
  let k = 0;
  for (const name of names) {
    const bare = name.replace('?', '');
    if (keys[k] === bare) found[bare] = value.get(keys[k++]);
    else if (bare === name) throw new Malformed(place, `expected the member "${name}" here, found ${k < keys.length ? quoted(keys[k]) : 'the end'}`);
  }
  if (k < keys.length) throw new Malformed(place, `the member ${quoted(keys[k])} is unknown, or not in its place`);
  return found;
}

class CertificateReader {
  constructor({space, several, size, contacts, by_claims}) {
    this.space = space;
    this.several = several;
    this.soft = contacts.map(({gamma}) => !gamma.isZero());
    this.size = size;
    this.by_claims = by_claims;
    this.names = [...parameter_names(space ? 3 : 2), 'wrench'];
  }

  read(text) {
    const file = object_at(new JsonReader(text, CERTIFICATE_LIMITS).whole(), '');
    if (file.get('format') !== 'stickslip-certificate/2') {
      throw new Malformed('format', `found ${described(file.get('format'))}, must be "stickslip-certificate/2"`);
    }
    if (file.has('producer')) grasp_string(file.get('producer'), 'producer');
    const question = this.question(file.get('question'));
    const margin = question.direction !== null || question.preload_direction !== null;
    const verdict = file.get('verdict');
    if (margin ? verdict !== 'margin' : verdict !== 'stable' && verdict !== 'unstable') {
      expected(margin ? '"margin"' : '"stable" or "unstable"', verdict, 'verdict');
    }
    const evidence = margin ? (this.by_claims ? ['intervals'] : ['resisted', 'segments', 'tree'])
      : verdict === 'unstable' ? ['tree'] : file.has('parts') ? ['parts'] : ['twist', 'shares'];
    const found = members_in_order(file, '', ['format', 'producer?', 'question',
      ...(margin && !this.by_claims ? [] : ['bits?']), 'verdict', ...evidence]);

    const result = {question, verdict, bits: 128};
    if ('bits' in found) {
      result.bits = read_index(found.bits, 'bits');
      if (result.bits < 64 || result.bits > 4096) expected('an integer from 64 to 4096', found.bits, 'bits');
    }
    this.coordinates = this.size + (margin ? 2 : 1);
    this.may_cut = !margin;
    if ('twist' in found) result.point = this.witness(found.twist, found.shares, '');
    if ('tree' in found) result.tree = this.tree(found.tree, 'tree');
    if ('parts' in found) result.parts = array_of(found.parts, 'parts').map((x, k) => this.part(x, `parts[${k}]`));
    if ('resisted' in found) {
      result.resisted = array_of(found.resisted, 'resisted').map((x, k) => this.range(x, `resisted[${k}]`));
      result.segments = this.segments(found.segments);
    }
    if ('intervals' in found) result.claims = array_of(found.intervals, 'intervals').map((x, k) => this.claim(x, `intervals[${k}]`));
    return result;
  }

  question(value) {
    const found = members_in_order(value, 'question',
        ['contacts', 'wrench', 'preload?', 'normal_law', 'direction?', 'preload_direction?', 'uncertain?', 'max_motion?']);
    const wrench = array_of(found.wrench, 'question.wrench', this.size).map((x) => {
      const ends = Array.isArray(x) ? read_numbers(x, 'question.wrench', 2) : [read_number(x, 'question.wrench')];
      return [ends[0], ends[ends.length - 1]];
    });
    if (found.normal_law !== 'unilateral' && found.normal_law !== 'bilateral') {
      expected('"unilateral" or "bilateral"', found.normal_law, 'question.normal_law');
    }
    const optional = (name, read) => (name in found ? read(found[name], `question.${name}`) : null);
    const tolerances = (object, place) => {
      const list = Object.entries(members_in_order(object, place, KINDS.map((kind) => `${kind}?`)));
      if (list.length === 0) throw new Malformed(place, 'no tolerance');
      return new Map(list.map(([kind, tolerance]) => {
        if (kind === 'wrench' && tolerance instanceof Map) return [kind, this.ball(tolerance, `${place}.wrench`)];
        const percent = typeof tolerance === 'string' && tolerance.endsWith('%');
        return [kind, {value: read_number(percent ? tolerance.slice(0, -1) : tolerance, `${place}.${kind}`), percent}];
      }));
    };
    return {
      contacts: read_index(found.contacts, 'question.contacts'),
      wrench,
      preload: optional('preload', read_number),
      law: found.normal_law,
      direction: optional('direction', (x, place) => read_numbers(x, place, this.size)),
      preload_direction: optional('preload_direction', (x, place) => (x === 'scale' ? x : read_numbers(x, place))),
      uncertain: optional('uncertain', tolerances),
      max_motion: optional('max_motion', (x, place) => read_numbers(x, place, this.size)),
    };
  }

  ball(value, place) {
    const dimension = this.space ? 3 : 2, {ball, length, about, body} =
      members_in_order(value, place, ['ball', 'length', 'about?', ...(this.several ? ['body'] : [])]);
    if (this.several && typeof body !== 'string') expected('the name of a body', body, `${place}.body`);
    return {radius: read_number(ball, `${place}.ball`), length: read_number(length, `${place}.length`),
      about: about === undefined ? zeros(dimension) : read_numbers(about, `${place}.about`, dimension), body: body ?? null};
  }

  /** A motion and shares; a share is a vector, in the plane of one number. */
  witness(twist, shares, place) {
    return {
      twist: read_numbers(twist, inside(place, 'twist'), this.size),
      shares: array_of(shares, inside(place, 'shares')).map((entry, k) => {
        const where = `${inside(place, 'shares')}[${k}]`;
        const [i, share] = array_of(entry, where, 2);
        const contact = read_index(i, where);
        return [contact, this.friction(share, where, contact)];
      }),
    };
  }

  /** A share, or F, that is listed for contact i: three numbers in space, with torsion four, in the plane one. */
  friction(value, place, i) {
    return this.space ? read_numbers(value, place, this.soft[i] === true ? 4 : 3) : [read_number(value, place)];
  }

  segments(value) {
    let last = null;
    return array_of(value, 'segments').map((segment, k) => {
      const place = `segments[${k}]`;
      if (segment instanceof Map) {
        last = null;
        return this.segment_by_degree(segment, place);
      }
      if (array_of(segment, place).length !== 1 && segment.length !== 2) expected('one POINT or two', segment, place);
      const points = segment.map((point) => {
        const [factor, twist, shares] = array_of(point, place, 3);
        return {factor: factor === null ? null : read_number(factor, place), ...this.witness(twist, shares, place)};
      });
      if (points.length === 1) points.unshift(last);
      if (points[0] === null || points[0].factor === null) {
        throw new Malformed(place, 'its first POINT is missing, or without a number');
      }
      last = points[1];
      return points;
    });
  }

  segment_by_degree(value, place) {
    const found = members_in_order(value, place, ['to', 'twists', 'walls', 'direction', 'tree']);
    const to = found.to === null ? null : read_number(found.to, `${place}.to`);
    const [twist, end_twist] = array_of(found.twists, `${place}.twists`, 2)
        .map((x) => read_numbers(x, `${place}.twists`, this.size));
    array_of(found.walls, `${place}.walls`, this.size);
    return {to, end_twist, ...this.degree({...found, twist}, place)};
  }

  range(value, place) {
    const [low, high] = array_of(value, place, 2);
    return [read_number(low, place), high === null ? null : read_number(high, place)];
  }

  tree(value, place) {
    return array_of(value, place).map((node, k) => this.node(node, `${place}[${k}]`));
  }

  node(value, place) {
    const kind = array_of(value, place)[0];
    if (kind === 'slip' || kind === 'separation') {
      return {kind, i: read_index(array_of(value, place, 2)[1], place)};
    }
    if (kind === 'plane' || kind === 'leaf') {
      const length = kind === 'leaf' ? this.size : this.coordinates;
      array_of(value, place, length + 1);
      return {kind, a: value.slice(1).map((x) => read_number(x, place))};
    }
    if (kind === 'moving' && this.may_cut) {
      array_of(value, place, this.size + 3);
      const numbers = value.slice(1, -1).map((x) => read_number(x, place));
      const slips = array_of(value[this.size + 2], place).map((entry) => {
        const [i, kappa, psi] = array_of(entry, place, 3);
        const contact = read_index(i, place);
        return {i: contact, kappa: read_number(kappa, place), psi: this.friction(psi, place, contact)};
      });
      return {kind, y: numbers.slice(0, this.size), c: numbers[this.size], slips};
    }
    if (kind === 'part' && this.may_cut) {
      const [, name, index, at] = array_of(value, place, 4);
      if (!this.names.includes(name)) expected(`one of ${this.names.join(', ')}`, name, place);
      return {kind, name, i: read_index(index, place), at: read_number(at, place)};
    }
    return expected(`slip, separation, plane, ${this.may_cut ? 'part, moving ' : ''}or leaf`, kind, place);
  }

  part(value, place) {
    if (Array.isArray(value)) {
      if (value[0] !== 'part') expected('part', value[0], place);
      return this.node(value, place);
    }
    if (object_at(value, place).has('rest')) return this.at_rest(value, place);
    if (value.has('sticking')) return this.sticking(value, place);
    const shape = value.has('simplex') ? 'simplex' : 'walls';
    const found = members_in_order(value, place, ['twist', 'open?', shape, 'direction', 'tree']);
    const open = array_of(found.open ?? [], `${place}.open`).map((i) => read_index(i, `${place}.open`));
    return {open, ...this.degree({...found, twist: read_numbers(found.twist, `${place}.twist`, this.size)}, place)};
  }

  at_rest(value, place) {
    const found = members_in_order(value, place, ['rest', 'answers', 'reach']);
    const listed = this.lists(found, place);
    return {kind: 'rest', rest: listed('rest', this.one_force), answers: listed('answers', this.forces),
      reach: read_numbers(found.reach, `${place}.reach`, this.size)};
  }

  sticking(value, place) {
    const found = members_in_order(value, place, ['sticking', 'friction', 'presses', 'answers', 'reach', 'energy']);
    const listed = this.lists(found, place), numbers = (name) => read_numbers(found[name], `${place}.${name}`, this.size);
    return {kind: 'sticking', twist: numbers('sticking'), friction: listed('friction', this.one_force),
      presses: listed('presses', (stated, where) => read_numbers(stated, where, this.size)), answers: listed('answers', this.forces),
      reach: numbers('reach'), energy: read_number(found.energy, `${place}.energy`)};
  }

  /** Reads [[CONTACT, what read.call(this, stated, where, contact) makes], ...]. */
  lists(found, place) {
    return (name, read) => array_of(found[name], `${place}.${name}`).map((entry, k) => {
      const where = `${place}.${name}[${k}]`, [i, stated] = array_of(entry, where, 2), contact = read_index(i, where);
      return [contact, read.call(this, stated, where, contact)];
    });
  }
  one_force(stated, where, contact) { return [this.friction(stated, where, contact)]; }
  forces(stated, where, contact) { return array_of(stated, where, this.size).map((force) => this.friction(force, where, contact)); }

  /** Of E there are `walls`, one to D, or those of a simplex, one more. */
  degree(found, place) {
    const simplex = 'simplex' in found, name = simplex ? 'simplex' : 'walls', more = simplex ? 1 : 0;
    const rows = (value, at) => value.map((row) => read_numbers(row, at, this.size));
    const walls = rows(array_of(found[name], `${place}.${name}`), `${place}.${name}`);
    if (walls.length < 2 * more || walls.length > this.size + more) {
      expected(`an array of ${2 * more} to ${this.size + more}`, found[name], `${place}.${name}`);
    }
    const direction = rows(array_of(found.direction, `${place}.direction`, this.size), `${place}.direction`);
    return {kind: 'degree', twist: found.twist, simplex, walls, direction, tree: this.tree(found.tree, `${place}.tree`)};
  }

  claim(value, place) {
    const [kind, ...rest] = array_of(value, place);
    if (rest.length < 3) expected('a claim', value, place);
    const [low, high] = this.range(rest.slice(0, 2), place);
    const evidence = rest.slice(2);
    if (kind === 'unstable' && evidence.length === 1) {
      return {kind, low, high, tree: this.tree(evidence[0], `${place}, tree`)};
    }
    if (kind !== 'stable') expected('"stable" or "unstable"', kind, place);
    if (evidence.length === 1 && evidence[0] instanceof Map && !evidence[0].has('shares')) {
      return {kind, low, high, part: this.part(evidence[0], place)};
    }
    if (evidence.length !== (high === null || low.equals(high) ? 1 : 2)) expected('a PART, or one POINT for each end', value, place);
    return {kind, low, high, points: evidence.map((point) => {
      const {twist, shares} = members_in_order(point, place, ['twist', 'shares']);
      return this.witness(twist, shares, place);
    })};
  }
}

// ---------------------------------------------------------------------------- The question agrees (§3)

function tolerances_text(uncertain) {
  if (uncertain === null || uncertain.size === 0) return 'no tolerances';
  return 'the tolerances ' + [...uncertain].map(([kind, t]) => `${kind}=${tolerance_text(t)}`).join(',');
}

const tolerance_text = (t) => (!is_ball(t) ? `${t.value}${t.percent ? '%' : ''}`
  : `ball:${t.radius}:length=${t.length}:about=${t.about.join(':')}${t.body === null ? '' : `:body=${t.body}`}`);

/** Two tolerances, or undefined, by their meaning. */
function same_tolerance(a, b) {
  if (a === undefined || b === undefined || is_ball(a) !== is_ball(b)) return a === b;
  return is_ball(a) ? a.radius.equals(b.radius) && a.length.equals(b.length) && same_list(a.about, b.about) && a.body === b.body
    : a.percent === b.percent && a.value.equals(b.value);
}

function agree(asked, stated) {
  const differ = (rule, theirs, ours) => {
    throw new Rejected(rule, `the certificate is about ${printable(theirs, 200)}, the question about ${printable(ours, 200)}`);
  };
  const both = (a, b, same) => (a === null) === (b === null) && (a === null || same(a, b));
  const preloads = (p) => (p === null ? "the file's own preloads" : `the preload ${p}`);
  const vector = (v) => (v === null ? 'no direction' : `the direction ${list_text(v)}`);
  const growth = (g) => (g === null ? 'no preload direction' : g === 'scale' ? 'scaled preloads' : `the preload direction ${list_text(g)}`);
  const own_growth = asked.scale ? 'scale' : asked.growth;

  if (stated.contacts !== asked.m) differ('question-contacts', `${stated.contacts} contacts`, `${asked.m}`);
  if (!stated.wrench.every(([low, high], j) => low.equals(asked.wrench[j][0]) && high.equals(asked.wrench[j][1]))) {
    differ('question-wrench', list_text(stated.wrench.map(interval_text)), list_text(asked.wrench.map(interval_text)));
  }
  if (!both(stated.preload, asked.preload, (a, b) => a.equals(b))) {
    differ('question-preload', preloads(stated.preload), preloads(asked.preload));
  }
  if (stated.law !== asked.law) differ('question-law', stated.law, asked.law);
  if (!both(stated.direction, asked.direction, same_list)) {
    differ('question-direction', vector(stated.direction), vector(asked.direction));
  }
  if (!both(stated.preload_direction, own_growth, (a, b) => (a === 'scale' || b === 'scale' ? a === b : same_list(a, b)))) {
    differ('question-preload-direction', growth(stated.preload_direction), growth(own_growth));
  }
  const theirs = stated.uncertain ?? new Map();
  if (!KINDS.every((kind) => same_tolerance(theirs.get(kind), asked.uncertain.get(kind)))) {
    differ('question-uncertain', tolerances_text(theirs), tolerances_text(asked.uncertain));
  }
  if (!both(stated.max_motion, asked.max_motion, same_list)) {
    const bound = (b) => (b === null ? 'motions without a bound' : `motions up to ${list_text(b)}`);
    differ('question-max-motion', bound(stated.max_motion), bound(asked.max_motion));
  }
}

// ---------------------------------------------------------------------------- Boxes (§6) and rows (§1)

const is_point = ([low, high]) => low.equals(high);
const middle = ([low, high]) => low.plus(high).half();
/**
 * The product of slips across n, in space, without one number, `dropped`, that follows from the others: ⟨s, t⟩ = s·(matrix t) / over.
 */
function slip_metric(n, gamma) {
  const dropped = n.findIndex((x) => !x.isZero()), square = n[dropped].times(n[dropped]);
  // It is −Σ n_j s_j of the two others, over its own n; the fourth number, if there is one, is not in it.
  const others = n.filter((_, j) => j !== dropped), weights = [ONE, ONE];
  if (!gamma.isZero()) {
    others.push(ZERO);
    weights.push(gamma);
  }
  const entries = others.map((a, j) => others.map((b, k) => a.times(b).over(square).plus(j === k ? weights[j] : ZERO)));
  const over = common_denominator(entries.flat());
  return {dropped, matrix: entries.map((row) => over_denominator(row, over)), over};
}

/** Every choice of one end of each interval, an interval of one number having one end only. */
const corners_of = (intervals) => intervals.reduce(
    (lists, interval) => lists.flatMap((list) => (is_point(interval) ? [interval[0]] : interval).map((x) => [...list, x])), [[]]);
const has_sign = (row, sign) => row.every((x) => (sign > 0 ? x >= 0n : x <= 0n));

/** By the numbers of a normal: of a ratchet or spring one, of contacts in the plane two, in space three. */
const geometry_names = (numbers) => [[], ['x', 'y', 'turn'], ['x', 'y', 'z', 'turn_u', 'turn_v']][numbers - 1];
const parameter_names = (numbers) => [...geometry_names(numbers), ...(numbers > 1 ? ['friction'] : []), 'preload', 'stiffness'];

/** The ways in which a normal n⁰ may turn: t⁰ = (−n_y, n_x) or U and V, of §6. */
function turns_of(n) {
  if (n.length === 1) return [];
  if (n.length === 2) return [[n[1].negated(), n[0]]];
  const cross = (a, b) => [[1, 2], [2, 0], [0, 1]].map(([j, k]) => a[j].times(b[k]).minus(a[k].times(b[j])));
  const sizes = n.map((x) => x.magnitude());
  const least = sizes.findIndex((x) => sizes.every((other) => x.compare(other) <= 0));
  const first = cross(n, n.map((_, j) => (j === least ? ONE : ZERO)));
  return [first, cross(n, first)];
}

/** By how much, each way: E in the plane, E_u and E_v in space. */
function most_turns({n, slope, square}) {
  if (n.length < 3) return Array(n.length - 1).fill(slope);
  return turns_of(n).map((way) => root_above(slope.times(slope).times(square).over(dot_fractions(way, way)), 1));
}

/** 1/L as an interval: of one number if L is rational or nothing presses, else by the enclosure of §6. */
function inverse_length(contact, bits) {
  if (contact.length !== null) return Array(2).fill(ONE.over(contact.length));
  return contact.pressed ? enclose_root(ONE.over(contact.square), bits) : [ZERO, ZERO];
}

/**
 * The parameters of one contact: geometry is (p_x, p_y, e) or, in space, (p, e_u, e_v); push is [P', Pᵘ'] at the low and
 * at the high end of one parameter: P', or in a margin c = 1/L. All that is computed from them is in integers.
 */
class Contact {
  static of(contact, question, bits) {
    const [low, high] = inverse_length(contact, bits);
    const e = contact.slope, square = e.times(e);
    const push = [[contact.preload[0].times(ONE.minus(square.half())).times(low), contact.growth.times(low)],
      [contact.preload[1].times(high), contact.growth.times(high)]];
    const k = [contact.k[0].times(ONE.minus(square)).over(contact.square), contact.k[1].over(contact.square)];
    return new Contact({n: contact.n, motion: contact.motion, spring: contact.spring, square: contact.square, gamma: contact.gamma,
      geometry: [...contact.p, ...most_turns(contact).map((most) => [most.negated(), most])], mu: contact.mu, push, k});
  }

  constructor(values) {
    Object.assign(this, values);
    this.forms = null;
    this.largest_tilt = undefined;
  }

  get certain_push() { return same_list(this.push[0], this.push[1]); }
  isPoint() { return this.geometry.every(is_point) && is_point(this.mu) && this.certain_push && is_point(this.k); }

  /** q⁰. */
  middle() {
    const at = (interval) => Array(2).fill(middle(interval));
    const push = this.push[0].map((x, j) => middle([x, this.push[1][j]]));
    return new Contact({...this, geometry: this.geometry.map(at), mu: at(this.mu), push: [push, push], k: at(this.k)});
  }

  parameter(name) {
    const j = geometry_names(this.n.length).indexOf(name);
    return j >= 0 ? this.geometry[j] : name === 'preload' ? this.push.map((x) => x[0]) : name === 'stiffness' ? this.k : this.mu;
  }

  /** The same contact with another interval of one parameter. */
  cut(name, interval) {
    const j = geometry_names(this.n.length).indexOf(name);
    if (j >= 0) return new Contact({...this, geometry: this.geometry.map((x, l) => (l === j ? interval : x))});
    if (name === 'preload') return new Contact({...this, push: interval.map((x) => [x, ZERO])});
    return new Contact({...this, [name === 'stiffness' ? 'k' : 'mu']: interval});
  }

  /** n at one corner of the geometry. */
  normalAt(corner) {
    return turns_of(this.n).reduce((n, way, l) => n.map((x, j) => x.plus(corner[this.n.length + l].times(way[j]))), this.n);
  }

  /** δ (§7). */
  get tilt() {
    if (this.largest_tilt === undefined) {
      this.largest_tilt = largest(corners_of(this.geometry).map((corner) => {
        const n = this.normalAt(corner);
        return dot_fractions(n, n).over(this.square).minus(ONE);
      }));
    }
    return this.largest_tilt;
  }

  /** N and the rows of T or S at one corner of the geometry, as fractions. */
  rowsAt(corner) {
    const [normal, slips] = this.ownRowsAt(corner);
    return [pulled(this.motion, normal), slips.map((row) => pulled(this.motion, row))];
  }

  /** N⁰ and those of T⁰ or S⁰, which are about one body. */
  ownRowsAt(corner) {
    const n = this.normalAt(corner);
    if (n.length < 3) {
      const p = corner.slice(0, 2);
      return [wrench_at(n, p), turns_of(n).map((t) => wrench_at(t, p))];
    }
    // u = (d₁, d₂, d₃) + (d₄, d₅, d₆) × p, and S d = u − (n⁰·u / L²) n.
    const [x, y, z] = corner, minus = (a) => a.negated();
    const u = [[ONE, ZERO, ZERO, ZERO, z, minus(y)], [ZERO, ONE, ZERO, minus(z), ZERO, x], [ZERO, ZERO, ONE, y, minus(x), ZERO]];
    const along = u[0].map((_, j) => dot_fractions(this.n, u.map((row) => row[j])));  // n⁰·u
    const slip = u.map((row, k) => row.map((a, j) => a.minus(along[j].times(n[k]).over(this.square))));
    if (!this.gamma.isZero()) slip.push([ZERO, ZERO, ZERO, ...n]);  // n·(d₄, d₅, d₆), where n is certain
    return [wrench_at(n, [x, y, z]), slip];
  }

  /**
   * In integers: normals[c] = d N and slips[c] = d T, or d S, at each corner c of the geometry; friction / b the ends of μ;
   * and v times scale is push·(h, ℓ) − pull (normals[c]·d), with an end of push and an end of pull. free[c] is slips[c], in
   * space without the number that slip_metric drops.
   */
  get rows() {
    if (this.forms !== null) return this.forms;
    const at = corners_of(this.geometry).map((corner) => this.rowsAt(corner));
    const d = common_denominator(at.flatMap(([normal, slip]) => [...normal, ...slip.flat()]));
    const normals = at.map(([normal]) => over_denominator(normal, d));
    const slips = at.map(([, slip]) => slip.map((row) => over_denominator(row, d)));
    const metric = this.n.length === 3 ? slip_metric(this.n, this.gamma) : null;
    const b = common_denominator(this.mu);
    const pull_scale = d * common_denominator(this.k);
    const scale = lcm(common_denominator(this.push.flat()), pull_scale);
    const same = (list) => list.every((x) => x.toString() === list[0].toString());
    const forms = {
      normals, slips, d, b, scale,
      friction: over_denominator(this.mu, b),
      push: this.push.map((x) => over_denominator(x, scale)),
      pull: over_denominator(this.k, scale / d),
      certain_slip: same(slips), certain_normal: same(normals),
      free: slips.map((slip) => slip.filter((_, j) => metric === null || j !== metric.dropped)), metric,
    };
    forms.one = at.length === 1 && this.certain_push && is_point(this.k);
    forms.weightless = forms.push.flat().every((x) => x === 0n);
    this.forms = forms;
    return forms;
  }

  /** Whether v_i is certain, up to a positive factor (§6). */
  get certain_pressure() {
    return this.rows.certain_normal && (this.rows.weightless || (is_point(this.k) && this.certain_push));
  }

  /** The row of v_i, times scale if it is certain; of a contact without preload a multiple. */
  pressureRow(coordinates) {
    const {normals, push, pull} = this.rows;
    return [...normals[0].map((x) => -pull[0] * x), ...push[0]].slice(0, coordinates);
  }
}

/** The contacts and the loads, each number in its interval; bits are those of enclosures. */
class Box {
  constructor(contacts, loads) {
    this.contacts = contacts;
    this.loads = loads;
  }
  static of(question, bits) {
    return new Box(question.contacts.map((c) => Contact.of(c, question, bits)), question.loads);
  }
  isPoint() { return this.loads.isPoint() && this.contacts.every((c) => c.isPoint()); }
  middle() {
    return new Box(this.contacts.map((c) => c.middle()), this.loads.middle());
  }
  /** The box of these contacts alone. */
  only(contacts) { return new Box(contacts.map((i) => this.contacts[i]), this.loads); }
  interval({name, i}) { return name === 'wrench' ? this.loads.ranges[i] : this.contacts[i].parameter(name); }
  cut({name, i}, interval) {
    const replace = (list, value) => list.map((x, j) => (j === i ? value : x));
    if (name === 'wrench') return new Box(this.contacts, this.loads.withRanges(replace(this.loads.ranges, interval)));
    return new Box(replace(this.contacts, this.contacts[i].cut(name, interval)), this.loads);
  }
}

// ---------------------------------------------------------------------------- Witnesses (§3)

/** s* of §1, times the denominator of γ: its product with t is ⟨s, t⟩. */
const starred = (s, gamma) => s.map((x, j) => x * (j < 3 ? gamma.d : gamma.n));
/** The square of the length of a friction force, or of a share. */
const friction_square = (f, gamma) => f.reduce((sum, x, j) => sum.plus(j < 3 ? x.times(x) : x.times(x).over(gamma)), ZERO);

/** b is the positive multiple of a, or one of them is 0. */
const same_direction = (a, b) => dot(a, b) > 0n
  ? a.every((x, j) => a.every((_, l) => x * b[l] === a[l] * b[j])) : a.every((x) => x === 0n) || b.every((x) => x === 0n);

/**
 * The rules of a witness at x = (d, h, ℓ). Returns of each contact, for segment-mode: v and the slip (in the plane a vector
 * of one), both times a positive number, and unit, the friction over μ a. All of x is times one denominator, which
 * is left out: no rule depends on it.
 */
function check_witness(question, box, {twist, shares}, h, factor, place) {
  const refuse = (rule, found) => { throw new Rejected(rule, found, place); };
  const {size} = question;
  if (question.box) refuse('witness-box', 'the question is a box, of which a witness proves nothing');
  (question.max_motion ?? []).forEach((b, j) => {
    if (twist[j].magnitude().compare(b.times(h)) > 0) refuse('witness-bound', `motion ${j + 1}, ${printable(twist[j])}, is beyond ${printable(b)} h`);
  });
  const x = integral([...twist, h, factor]), ray = {d: x.slice(0, size), h: x[size], l: x[size + 1]};
  const states = box.contacts.map((contact) => ({v: pressures(contact.rows, ray)[0],
    slip: contact.rows.slips[0].map((row) => dot(row, ray.d))}));
  const listed = new Map();
  let before = -1;
  for (const [i, share] of shares) {
    const wrong = (found) => refuse('witness-share', `contact ${printable(i)}: ${found}`);
    if (i <= before || i >= question.touching) wrong(`out of order, or not one of ${question.touching}`);
    const {n, square, gamma} = box.contacts[i], space = n.length === 3;
    if (states[i].slip.some((s) => s !== 0n)) wrong('it slips, and a share needs a slip of 0');
    if (friction_square(share, gamma).compare(space ? square : ONE) > 0) wrong('the share is too large');
    if (space && !dot_fractions(n, share).isZero()) wrong('the share has a part along n');
    listed.set(i, share);
    before = i;
  }
  if (question.bilateral) {
    const i = states.findIndex(({v}, j) => v < 0n && !box.contacts[j].spring);
    if (i >= 0) refuse('witness-normal', `v is below 0 at contact ${i}`);
  }
  const sum = new Sum(size);
  sum.add_fractions(question.wrench.map(([w], j) => Fraction.of(ray.h).times(w).plus(Fraction.of(ray.l).times(question.u[j]))));
  states.forEach((state, i) => {
    const {v, slip} = state, {rows, n, square, gamma, spring} = box.contacts[i], {normals: [normal], slips: [tangents], friction: [mu]} = rows;
    state.unit = listed.get(i) ?? slip.map(() => ZERO);
    if (v === 0n || (v < 0n && !spring)) return;
    if (mu !== 0n && slip.some((s) => s !== 0n)) {
      // −L s*/|s|, where L is 1 in the plane, as b goes with T. A positive multiple of s serves.
      const s = primitive(slip), star = starred(s, gamma);
      const root = n.length === 3 ? rational_root(square.over(Fraction.of(dot(star, s), gamma.d))) : ONE;
      if (root === null) refuse('witness-root', `contact ${i}: the slip's length over that of n is irrational`);
      state.unit = star.map((c) => root.times(Fraction.of(-c, gamma.d)));
    }
    // v N + μ v (unit · T); in space S stands for T, as unit·n = 0.
    const d = common_denominator(state.unit), unit = over_denominator(state.unit, d);
    sum.add(normal.map((c, j) => v * (rows.b * d * c + mu * dot(unit, tangents.map((row) => row[j])))), rows.scale * rows.b * rows.d * d);
  });
  const [rest, d] = sum.total();
  if (rest.some((c) => c !== 0n)) {
    const [first] = rest.map((c, j) => [c, j]).filter(([c]) => c !== 0n);
    refuse('witness-balance', `component ${first[1]} of load and forces adds up to ${first[0] > 0n ? 'more' : 'less'} than 0`);
  }
  return states;
}

/** segment-mode, of the plane and of space. */
function check_mode(box, first, second, place) {
  const refuse = (i, found) => { throw new Rejected('segment-mode', `contact ${i}: ${found}`, place); };
  box.contacts.forEach((contact, i) => {
    const points = [first[i], second[i]], [one, two] = points;
    if (contact.spring) return;
    if ((one.v > 0n && two.v < 0n) || (one.v < 0n && two.v > 0n)) refuse(i, 'v is of opposite signs');
    if (contact.mu[0].isZero() || (one.v <= 0n && two.v <= 0n)) return;
    // Both are multiples >= 0 of their sum.
    if (!same_direction(one.slip, two.slip)) refuse(i, 'the slips are of different directions');
    const slip = points.map((point) => point.slip).find((s) => s.some((c) => c !== 0n));
    if (slip === undefined) return;
    for (const {v, unit} of points) {
      if (v <= 0n) continue;
      const opposite = negative(integral(unit)), longest = contact.n.length === 3 ? contact.square : ONE;
      if (!friction_square(unit, contact.gamma).equals(longest) || !same_direction(opposite, starred(slip, contact.gamma))) {
        refuse(i, 'the friction is not that of the slip between');
      }
    }
  });
}

// ---------------------------------------------------------------------------- Regions (§4)

/**
 * A polyhedral cone by its generators, after Motzkin's double description method. Of each ray, zero has bit k if
 * the k-th inequality is an equation there. Cones do not change.
 */
class Cone {
  constructor(lines, rays, count) {
    this.lines = lines;
    this.rays = rays;
    this.count = count;
  }
  static whole(size) {
    return new Cone(Array.from({length: size}, (_, j) => Array.from({length: size}, (__, k) => (j === k ? 1n : 0n))), [], 0);
  }

  /** The part with a·x >= 0, or a·x = 0. */
  cut(a, equation) {
    const bit = equation ? 0n : 1n << BigInt(this.count), count = this.count + (equation ? 0 : 1);
    const k = this.lines.findIndex((line) => dot(a, line) !== 0n);
    if (k >= 0) {
      // Everything else moves along this line to where a is 0; the line becomes a ray.
      let line = this.lines[k], height = dot(a, line);
      if (height < 0n) [line, height] = [negative(line), -height];
      const moved = (x) => {
        const value = dot(a, x);
        return value === 0n ? x : combined(height, x, -value, line);
      };
      const rays = this.rays.map(({x, zero}) => ({x: moved(x), zero: zero | bit}));
      if (!equation) rays.push({x: line, zero: bit - 1n});
      return new Cone(this.lines.filter((_, j) => j !== k).map(moved), rays, count);
    }
    const above = [], below = [], rays = [];
    for (const ray of this.rays) {
      const value = dot(a, ray.x);
      if (value > 0n) above.push([ray, value]);
      else if (value < 0n) below.push([ray, value]);
      else rays.push(bit === 0n ? ray : {x: ray.x, zero: ray.zero | bit});
    }
    if (!equation) for (const [ray] of above) rays.push(ray);
    for (const [up, high] of above) {
      for (const [down, low] of below) {
        spend(1 + (this.rays.length >> 4));
        const common = up.zero & down.zero;
        // Two rays span a face unless a third lies in every face that both lie in.
        if (this.rays.some((ray) => ray !== up && ray !== down && (ray.zero & common) === common)) continue;
        rays.push({x: combined(-low, up.x, high, down.x), zero: common | bit});
      }
    }
    return new Cone(this.lines, rays, count);
  }
}

/** Of the cone of 0 in a plane, and in a space of three dimensions. */
const DUALS = {2: Cone.whole(2), 3: Cone.whole(3)};

/**
 * A cone of points of a plane: nothing but 0, a line, a half plane (left of the first side), all of it, or what is from the
 * first side counterclockwise to the second, which is below a half turn.
 */
class PlaneCone {
  constructor() {
    this.kind = 'zero';
    this.generators = [];  // its sides
  }
  /** Above 0 if b is to the left of a. */
  turn(a, b) {
    const first = a[0] * b[1], second = a[1] * b[0];
    if (is_long(first) || is_long(second)) spend_products(2 * products_of(most_words(a), most_words(b)));
    return first - second;
  }
  has(t) {
    const [first, last] = this.generators;
    switch (this.kind) {
      case 'zero': return t.every((x) => x === 0n);
      case 'line': return this.turn(first, t) === 0n;
      case 'half': return this.turn(first, t) >= 0n;
      case 'all': return true;
      case 'ray': return this.turn(first, t) === 0n && dot(first, t) >= 0n;
      default: return this.turn(first, t) >= 0n && this.turn(t, last) >= 0n;
    }
  }
  add(v) {
    if (this.has(v)) return;
    const set = (kind, ...sides) => { [this.kind, this.generators] = [kind, sides]; };
    const [first, last] = this.generators;
    const after = this.kind === 'zero' ? 0n : this.turn(first, v);
    if (this.kind === 'zero') return void set('ray', v, v);
    if (this.kind === 'half') return void set('all');
    if (this.kind === 'line') return void (after > 0n ? set('half', first, last) : set('half', last, first));
    if (this.kind === 'ray') return void (after === 0n ? set('line', first, v) : after > 0n ? set('sector', first, v) : set('sector', v, first));
    const before = this.turn(v, last);
    if (after < 0n && before < 0n) set('all');
    else if (before < 0n) set(after === 0n ? 'half' : 'sector', first, v);  // v is beyond the last side, or opposite to the first
    else set(before === 0n ? 'half' : 'sector', v, last);
  }
}

/** A cone of points of more dimensions, by its dual: all z with z·s >= 0 for those that were added. */
class DualCone {
  constructor(size) {
    this.dual = Cone.whole(size);
    this.generators = [];
  }
  has(s) {
    return this.dual.lines.every((z) => dot(z, s) === 0n) && this.dual.rays.every(({x}) => dot(x, s) >= 0n);
  }
  add(s) {
    if (this.has(s)) return;
    this.dual = this.dual.cut(s, false);
    this.generators.push(s);
  }
}

/** metric.over ⟨s, t⟩ is star·t. */
const star_of = (s, {matrix}) => matrix.map((row) => dot(row, s));
const slip_square = (s, metric) => new Fraction(dot(star_of(s, metric), s), metric.over);

/** C_i of §7, the cone of these slips, which are without what follows from their other numbers. */
class SlipCone {
  constructor(slips, metric) {
    const size = metric.matrix.length;
    this.metric = metric;
    this.cone = size === 2 ? new PlaneCone() : new DualCone(size);
    for (const s of slips) this.cone.add(s);
  }
  has(s) { return this.cone.has(s); }

  /** M², and its sign, of a contact that moves, where S_i y = t. */
  most(t) {
    const {metric} = this, q = negative(t);
    if (this.has(q)) return [slip_square(q, metric), 1];
    const slips = this.cone.generators.map((s) => {
      const star = star_of(s, metric);
      return {s, star, square: dot(star, s), height: dot(star, q)};  // products times metric.over
    });
    const found = slips.map(({square, height}) => [new Fraction(height * height, square), height > 0n ? 1 : height < 0n ? -1 : 0]);
    // The nearest point on the plane of two, if it is between them. Where all is in that plane, it is q.
    for (let j = 0; j < slips.length && q.length > 2; ++j) {
      for (let k = 0; k < j; ++k) {
        const a = slips[j], b = slips[k], product = dot(a.star, b.s);
        const x = a.height * b.square - b.height * product, y = b.height * a.square - a.height * product;
        if (x <= 0n || y <= 0n) continue;
        found.push([new Fraction(x * a.height + y * b.height, a.square * b.square - product * product), 1]);
      }
    }
    const [square, sign] = found.reduce((one, two) =>
      (one[1] > two[1] || (one[1] === two[1] && one[0].compare(two[0]) * one[1] > 0) ? one : two));
    return [new Fraction(square.n, square.d * metric.over), sign];
  }
}

const UNKNOWN = 0, CLOSED = 1, OPEN = 2, MIXED = 3;

/**
 * What a node stands for: a cone, strict functions and a box. Strict functions are inequalities of the cone, the bits
 * of `strict`, but for those of slips in space, which are in `slips`.
 */
class Region {
  constructor(question, box, cone, strict, slips, above = null) {
    this.question = question;
    this.box = box;
    this.cone = cone;
    this.strict = strict;
    this.slips = slips;
    this.above = above;
    this.found = null;
  }
  static whole(question, box, coordinates) {
    return new Region(question, box, Cone.whole(coordinates), 0n, []);
  }

  get coordinates() { return this.question.coordinates; }

  cut(row, {equation = false, strict = false} = {}) {
    const bit = strict ? 1n << BigInt(this.cone.count) : 0n;
    return new Region(this.question, this.box, this.cone.cut(row, equation), this.strict | bit, this.slips, this);
  }
  withSlip(i) {
    return new Region(this.question, this.box, this.cone, this.strict, [...this.slips, i], this);
  }
  withBox(box) { return new Region(this.question, box, this.cone, this.strict, this.slips, this); }

  padded(row) { return row.length === this.coordinates ? row : [...row, ...Array(this.coordinates - row.length).fill(0n)]; }

  /**
   * Rays, and each line as two, with the strict functions that are zero there as the bits of `barred`. An inequality is
   * zero on lines. `everyone` has a bit for each strict function.
   */
  get generators() {
    if (this.list !== undefined) return this.list;
    const size = this.question.size, shift = BigInt(this.cone.count);
    const rows = this.slips.map((i) => this.box.contacts[i].rows.slips[0]);
    const bits = (x) => rows.reduce((mask, slip, k) =>
      (slip.every((row) => dot(row, x) === 0n) ? mask | 1n << (shift + BigInt(k)) : mask), 0n);
    const make = (x, zero) => ({x, d: x.slice(0, size), h: x[size], l: x[size + 1] ?? 0n, barred: (zero & this.strict) | bits(x)});
    this.list = this.cone.rays.map(({x, zero}) => make(x, zero));
    for (const line of this.cone.lines) {
      for (const x of [line, negative(line)]) this.list.push(make(x, this.strict));
    }
    this.everyone = this.strict | ((1n << BigInt(rows.length)) - 1n) << shift;
    return this.list;
  }

  /** Rays are barred together if their masks have a bit in common: one strict function is zero on all of them. */
  get isBarred() { return this.generators.reduce((mask, {barred}) => mask & barred, this.everyone) !== 0n; }

  /**
   * Of each contact: whether it is closed, open or mixed, and its sign, in space 1 if it moves (§4, §7). What is
   * closed or open or has a sign here is so in every child, as its rays are in this region, and its box in this box.
   */
  get contacts() {
    if (this.found !== null) return this.found;
    const {m} = this.question;
    const known = this.above !== null && this.above.found !== null ? this.above.found : null;
    const found = known === null ? {press: new Uint8Array(m), side: new Int8Array(m)}
      : {press: known.press.slice(), side: known.side.slice()};
    for (let i = 0; i < m; ++i) {
      const {n, spring} = this.box.contacts[i];
      if (spring) found.press[i] = CLOSED;
      if (found.press[i] === UNKNOWN || found.press[i] === MIXED) found.press[i] = this.press(this.box.contacts[i].rows);
      if (found.press[i] === OPEN || found.side[i] !== 0) continue;
      const {slips, free, friction} = this.box.contacts[i].rows;
      if (friction[1] !== 0n) found.side[i] = n.length === 3 ? (this.moves(i, free) ? 1 : 0) : this.sign(slips);
    }
    this.found = found;
    return found;
  }

  press(rows) {
    let closed = true, open = true;
    for (const ray of this.generators) {
      const [low, high] = pressures(rows, ray);
      if (low < 0n) closed = false;
      if (high > 0n) open = false;
      if (!closed && !open) return MIXED;
    }
    return closed ? CLOSED : OPEN;
  }

  /** The sign of a contact in the plane. */
  sign(slips) {
    const has = (sign) => slips.every(([row]) => {
      let mask = this.everyone;
      for (const {d, barred} of this.generators) {
        const value = dot(row, d);
        if (sign > 0 ? value < 0n : value > 0n) return false;
        if (value === 0n) mask &= barred;
        if (mask === 0n) return false;
      }
      return true;
    });
    return has(1) ? 1 : has(-1) ? -1 : 0;
  }

  /** C_i, the cone of the slips of all rays at all corners. */
  slipCone(i) {
    if (this.cones === undefined) this.cones = new Map();
    if (!this.cones.has(i)) {
      const {free, metric} = this.box.contacts[i].rows;
      this.cones.set(i, new SlipCone(this.generators.flatMap(({d}) => free.map((slip) => slip.map((row) => dot(row, d)))), metric));
    }
    return this.cones.get(i);
  }

  moves(i, slips) {
    if (this.slips.includes(i)) return true;
    const cone = this.slipCone(i);
    return slips.every((slip) => {
      let mask = this.everyone;
      for (const {d, barred} of this.generators) {
        if ((mask & barred) !== mask && cone.has(slip.map((row) => -dot(row, d)))) mask &= barred;
        if (mask === 0n) return false;
      }
      return true;
    });
  }
}

/** min and max of v_i at a ray, over the box, times scale. */
function pressures({normals, push, pull, one}, {d, h, l}) {
  const pushed = (end) => push[end][0] * h + (l === 0n ? 0n : push[end][1] * l);
  if (is_long(h)) spend_products(4 * products_of(words(h), most_words(push[0])));
  if (one) {
    const v = pushed(0) - pull[0] * dot(normals[0], d);
    return [v, v];
  }
  let least_pull = null, most_pull = null;
  for (const normal of normals) {
    const height = dot(normal, d);
    for (const end of pull) {
      const value = end * height;
      if (is_long(value)) spend_products(products_of(words(end), words(height)));
      if (least_pull === null || value < least_pull) least_pull = value;
      if (most_pull === null || value > most_pull) most_pull = value;
    }
  }
  return [pushed(0) - most_pull, pushed(1) - least_pull];
}

// ---------------------------------------------------------------------------- Leaves (§4, §7)

/**
 * What refuses a leaf, or null. y is a vector of integers, the stated one times `scale`: any positive multiple serves, but that the
 * root in Λ is rounded as that of the stated one. Closed contacts of certain rows are summed into one linear form, `total`; the others
 * are `terms`, functions of a ray that give a number over `d`.
 */
function leaf_refusal(region, stated, y) {
  if (region.isBarred) return null;
  const {question, box} = region, {press, side} = region.contacts;
  const total = new Sum(region.coordinates), terms = [], first = y.findIndex((x) => x !== 0n);
  const scale = first < 0 ? ONE : new Fraction(y[first], 1n).over(stated[first]);
  total.add_fractions([...Array(question.size).fill(ZERO),
    box.loads.most(stated).times(scale),
    ...(question.margin ? [question.u.reduce((sum, x, j) => sum.plus(x.times(new Fraction(y[j], 1n))), ZERO)] : [])]);
  for (let i = 0; i < question.m; ++i) {
    if (press[i] === OPEN) continue;
    const contact = box.contacts[i], closed = press[i] === CLOSED;
    const {alpha, d, term} = contact.n.length === 2 ? plane_bound(contact, y, side[i], closed)
      : space_bound(region, contact, i, y, side[i], closed);
    if (term !== undefined) {
      terms.push({term, d});
    } else if (closed) {
      total.add(contact.pressureRow(region.coordinates).map((x) => x * alpha), d);
    } else if (alpha > 0n) {
      terms.push({d, term: (ray) => {
        const v = pressures(contact.rows, ray)[1];
        return v > 0n ? alpha * v : 0n;
      }});
    }
  }
  const [form, form_d] = total.total();
  let mask = region.everyone;
  for (const ray of region.generators) {
    let value = dot(form, ray.x);
    if (terms.length > 0) {
      const sum = new Sum(1);
      sum.add([value], form_d);
      for (const {term, d} of terms) {
        const one = term(ray);
        if (one !== 0n) sum.add([one], d);
      }
      value = sum.total()[0][0];
    }
    if (value > 0n) return 'g is above 0 on a ray';
    if (value === 0n) mask &= ray.barred;
  }
  return mask !== 0n ? null : 'g = 0 on rays that are not barred together';
}

/**
 * In the plane: alpha over d with b = α v or max(0, α) max(0, v), where rows are certain; else a term over d,
 * by the Bernstein coefficients of α v.
 */
function plane_bound(contact, y, side, closed) {
  const rows = contact.rows, [low, high] = rows.friction;
  const strengths = side > 0 ? [-low, -high] : side < 0 ? [low, high] : [-high, high];
  const alphas = strengths.map((s) => rows.normals.map((normal, c) => rows.b * dot(normal, y) + s * dot(rows.slips[c][0], y)));
  const d = rows.scale * rows.d * rows.b;
  if (rows.one) return {alpha: alphas[0][0] > alphas[1][0] ? alphas[0][0] : alphas[1][0], d};

  // Pairs of corners by their sum k, of which each coordinate of two ends counts; weights make every mean a sum over 2^free.
  const free = contact.geometry.filter((x) => !is_point(x)).length, pairs = new Map();
  for (let c = 0; c < 1 << free; ++c) {
    for (let e = 0; e < 1 << free; ++e) {
      const key = `${c & e},${c ^ e}`;  // both ends high, and ends that differ
      if (!pairs.has(key)) pairs.set(key, []);
      pairs.get(key).push([c, e]);
    }
  }
  const means = [...pairs.values()].map((list) => ({list, weight: BigInt((1 << free) / list.length)}));
  const whole = BigInt(1 << free);
  const coefficients = alphas.map((alpha) => means.map(({list, weight}) =>
    ({list, weight, a: weight * list.reduce((sum, [c]) => sum + alpha[c], 0n)})));

  const upper = (s, {h, l}, heights) => {  // U_s(r), times d · whole
    let most = null;
    for (const {list, weight, a} of coefficients[s]) {
      let pulled = 0n;
      for (const [c, e] of list) pulled += alphas[s][c] * heights[e];
      pulled *= weight;
      const push = rows.push[a > 0n ? 1 : 0];
      const value = (push[0] * h + push[1] * l) * a - rows.pull[pulled > 0n ? 0 : 1] * pulled;
      if (most === null || value > most) most = value;
    }
    return most;
  };
  const term = (ray) => {
    const heights = rows.normals.map((normal) => dot(normal, ray.d));
    let most = null;
    alphas.forEach((alpha, s) => {
      let value;
      if (closed) {
        value = upper(s, ray, heights);
      } else if (has_sign(alpha, -1)) {
        value = 0n;
      } else if (has_sign(alpha, 1)) {
        value = upper(s, ray, heights);
        if (value < 0n) value = 0n;
      } else {
        const v = pressures(rows, ray)[1];
        value = v > 0n ? v * alpha.reduce((a, b) => (b > a ? b : a)) * whole : 0n;
      }
      if (most === null || value > most) most = value;
    });
    return most;
  };
  return {term, d: d * whole};
}

/** A bound from above of √q, or with sign −1 of −√q (§6). q need not be in lowest terms. */
function root_above(q, sign) {
  if (q.isZero()) return ZERO;
  const root = rational_root(q);
  if (root !== null) return sign > 0 ? root : root.negated();
  const [low, high] = enclose_root(q, 64);
  return sign > 0 ? high : low.negated();
}

/** In space, and without friction: one α for all corners, over both ends of μ. Fractions are not in lowest terms: that would take most of the time. */
function space_bound(region, contact, i, y, moves, closed) {
  const rows = contact.rows;
  const product = (a, b) => new Fraction(a.n * b.n, a.d * b.d);
  const alpha = largest(rows.normals.flatMap((normal, c) => {
    const power = new Fraction(dot(normal, y), rows.d);
    if (contact.mu[1].isZero()) return [power];
    const slip = rows.free[c].map((row) => dot(row, y)), whole = slip_square(slip, rows.metric);  // times d²
    const [square, sign] = moves ? region.slipCone(i).most(slip) : [whole, 1];
    const length = product(contact.square, new Fraction(1n, rows.d * rows.d));
    return (is_point(contact.mu) ? [contact.mu[0]] : contact.mu).map((mu) => {
      const cone = product(length, product(mu, mu));
      const bound = root_above(product(square, cone), sign);
      const work = new Fraction(power.n * bound.d + bound.n * power.d, power.d * bound.d);
      if (contact.tilt.isZero()) return work;
      return work.plus(contact.tilt.times(new Fraction(3n, 2n)).times(root_above(product(whole, cone), 1)));
    });
  }));
  const d = alpha.d * rows.scale;
  if (rows.one) return {alpha: alpha.n, d};
  const term = (ray) => {
    const [low, high] = pressures(rows, ray);
    if (closed) return alpha.n * (alpha.n > 0n ? high : low);
    return alpha.n > 0n && high > 0n ? alpha.n * high : 0n;
  };
  return {term, d};
}

// ---------------------------------------------------------------------------- Leaves whose twist moves (§4)

/** `moving-list`: what is wrong, or null. */
function list_refusal({box}, slips) {
  let last = -1;
  for (const {i, kappa, psi} of slips) {
    if (i <= last || i >= box.contacts.length || box.contacts[i].n.length === 1) return `contact ${printable(i)} has no place in it`;
    const {gamma} = box.contacts[i], square = psi.reduce((sum, x, j) => sum.plus(j < 3 ? x.times(x) : x.times(x).times(gamma)), ZERO);
    if (kappa.sign() < 0 || square.compare(kappa.times(kappa)) > 0) return `psi of contact ${i} is longer than kappa`;
    last = i;
  }
  return null;
}

/** What is common to all contacts: y(x) is (c d + h y) / over in integers, the stated numbers being y / over and c / over. */
function moving_twist({y, c}) {
  const over = common_denominator([...y, c]);
  const [own, [along]] = [over_denominator(y, over), over_denominator([c], over)];
  return {over, c: along, y: own, at: ({d, h}) => d.map((x, j) => along * x + h * own[j])};
}

const ceiling = (n, d) => (n > 0n ? (n + d - 1n) / d : n / d);  // d > 0

/** Numbers of a moving leaf, exactly. */
const EXACTLY = {
  zero: ZERO,
  size: () => 1n,
  above: (n, d) => Fraction.of(n, d),
  root: (n, d, size, sign) => root_above(new Fraction(n, d), sign),
  multiple: (factor, x) => factor.times(x),
  minus: (x) => x.negated(),
  plus: (a, b) => a.plus(b),
  times: (a, b) => a.times(b),
  compare: (a, b) => a.compare(b),
};

/**
 * As whole multiples of 2^-96, each rounded to the side on which B is not smaller. A ray stands for the multiple of it that has a largest
 * number near 1, its own being over that size.
 */
const UPWARDS = {
  zero: 0n,
  size: ({x}) => 1n << BigInt(Math.max(...x.map((one) => bit_length(absolute(one))))),
  above: (n, d, size) => ceiling(n << 96n, d * size),
  // The bound of §6 differs from the root by less than a part in 2^62.
  root: (n, d, size, sign) => {
    const root = integer_root((n << 192n) / (d * size * size));
    return (sign > 0 ? root : -root) + (root >> 62n) + 2n;
  },
  multiple: (factor, x) => ceiling(factor.n * x, factor.d),
  minus: (x) => -x,
  plus: (a, b) => a + b,
  times: (a, b) => a * b,
  compare: (a, b) => (a > b ? 1 : a < b ? -1 : 0),
};

/**
 * A_i(r) at each ray. With s = slips[c] d and t = slips[c] (c d + h y), which are S d times rows.d and S y(r) times rows.d twist.over,
 * S y(r) − κ s is (κ_d t − twist.over κ_n s) over all three.
 */
function works_of(contact, generators, twist, kappa, psi, numbers) {
  const {rows, square, gamma} = contact, largest_of = (list) => list.reduce((a, b) => (numbers.compare(b, a) > 0 ? b : a));
  const plane = contact.n.length < 3, weights = [gamma.d, gamma.d, gamma.d, gamma.n];
  const weighted = (a, b) => a.reduce((sum, x, j) => sum + (plane ? 1n : weights[j]) * x * b[j], 0n);
  const length = plane ? ONE : square, gamma_d = plane ? 1n : gamma.d, over = rows.d * twist.over * kappa.d, own = twist.over * kappa.n;
  const psi_d = common_denominator(psi), psi_n = over_denominator(psi, psi_d), along_d = gamma_d * psi_d * rows.d;
  const stretch = plane ? ONE : contact.tilt.half().plus(ONE);
  const squares_d = length.d * over * over * gamma_d, along_squares_d = length.d * along_d * along_d;
  return generators.map((ray) => {
    const moved = twist.at(ray), size = numbers.size(ray);
    return largest_of(rows.normals.map((normal, c) => {
      const power = numbers.above(dot(normal, moved), rows.d * twist.over, size);
      if (contact.mu[1].isZero()) return power;
      const s = rows.slips[c].map((row) => dot(row, ray.d)), t = rows.slips[c].map((row) => dot(row, moved));
      const left = t.map((x, j) => kappa.d * x - own * s[j]), squares = weighted(left, left);
      if (is_long(squares)) spend_products(20 * products_of(words(squares), words(squares_d)));
      spend(20);
      let work = numbers.multiple(stretch, numbers.root(length.n * squares, squares_d, size, 1));
      if (psi.length > 0) {
        const along = weighted(psi_n, s);
        work = numbers.plus(work, numbers.root(length.n * along * along, along_squares_d, size, along < 0n ? -1 : 1));
      }
      return numbers.plus(power, largest_of(contact.mu.map((mu) => numbers.multiple(mu, work))));
    }));
  });
}

/** What refuses a moving leaf, or null. */
function moving_refusal(region, node, numbers) {
  const {box, generators} = region, twist = moving_twist(node), listed = new Map(node.slips.map((slip) => [slip.i, slip]));
  const sizes = generators.map(numbers.size), larger = (a, b) => (numbers.compare(a, b) > 0 ? a : b);
  const extents = (ends, d) => ends.map(([low, high], r) => [numbers.minus(numbers.above(-low, d, sizes[r])), numbers.above(high, d, sizes[r])]);
  const positive = (x) => larger(x, numbers.zero);
  // Of v and A, each with its least and its largest.
  const closed = (v, work) => v.flatMap((x) => work.map((y) => numbers.times(x, y))).reduce(larger);
  const mixed = (v, work) => numbers.times(positive(v[1]), positive(work[1]));
  const loads = generators.map((ray, r) => {
    const most = box.loads.most(twist.at(ray).map((x) => Fraction.of(x, twist.over)));
    return numbers.above(most.n, most.d, sizes[r]);
  });
  const both = (x) => [x, x];
  const terms = [{product: closed, v: extents(generators.map(({h}) => both(h)), 1n), works: loads.map(both)}];
  box.contacts.forEach((contact, i) => {
    const press = contact.spring ? CLOSED : region.press(contact.rows);
    if (press === OPEN) return;
    const {kappa, psi} = listed.get(i) ?? {kappa: ZERO, psi: []};
    // Where v of a spring is below 0, a larger A is no bound.
    const works = contact.spring
      ? extents(generators.map((ray) => both(dot(contact.rows.normals[0], twist.at(ray)))), contact.rows.d * twist.over)
      : works_of(contact, generators, twist, kappa, psi, numbers).map(both);
    terms.push({product: press === CLOSED ? closed : mixed, v: extents(generators.map((ray) => pressures(contact.rows, ray)), contact.rows.scale), works});
  });
  let mask = region.everyone;
  for (let r = 0; r < generators.length; ++r) {
    for (let s = 0; s <= r; ++s) {
      let twice = numbers.zero;
      spend(4 * terms.length);
      for (const {product, v, works} of terms) {
        twice = numbers.plus(twice, numbers.plus(product(v[r], works[s]), product(v[s], works[r])));
      }
      const sign = numbers.compare(twice, numbers.zero);
      if (sign > 0) return 'B is above 0 on two rays';
      if (r === s && sign === 0) mask &= generators[r].barred;
    }
  }
  return mask !== 0n ? null : 'B(r, r) = 0 on rays that are not barred together';
}

/** `leaf-direction` of one: whether y(r)·A e(r') + y(r')·A e(r) is nowhere below 0, with A e by rows, as of check_trees. */
function moves_along({generators}, node, pull) {
  const twist = moving_twist(node), all = generators.map((ray) => [twist.at(ray), pull.map((row) => dot(row, ray.x))]);
  return all.every(([y, pull], r) => all.slice(0, r + 1).every(([other_y, other_pull]) => dot(y, other_pull) + dot(other_y, pull) >= 0n));
}

// ---------------------------------------------------------------------------- Trees (§4)

/** The steps from a root; what a tree is part of is the first, if it has a name. */
class Path {
  constructor(above, step) {
    this.above = above;
    this.step = step;
    this.depth = above === null ? 0 : above.depth + 1;
  }
  to(step) { return new Path(this, step); }
  toString() {
    const steps = [];
    for (let path = this; path !== null; path = path.above) if (path.step !== '') steps.push(path.step);
    return steps.reverse().join(', ');
  }
}

/**
 * Visits the nodes of trees that follow each other in a list. roots: what each root is made by, with a Path.
 * visit(node, what was made, refuse, place) returns the children, as [step, function that makes it] each.
 * where(path, number) gives place and number as an answer has them; of `tree-long` the path is null.
 */
function walk(nodes, roots, m, where, visit) {
  const pending = [];
  let next = 0;
  const reject = (rule, found, path, number) => { throw new Rejected(rule, found, ...where(path, number)); };
  const top = () => {
    if (pending.length === 0 && next < roots.length) pending.push(roots[next++]);
    return pending.length > 0;
  };
  nodes.forEach((node, number) => {
    if (!top()) reject('tree-long', 'everything was complete before this', null, number);
    const {make, path} = pending.pop();
    const refuse = (rule, found) => reject(rule, found, path, number);
    if (path.depth > 2 * m + 256) refuse('node-depth', `more than ${2 * m + 256} nodes above it`);
    const children = visit(node, make(), refuse, () => where(path, number)[0]);
    for (const [step, child] of children.reverse()) pending.push({make: child, path: path.to(step)});
  });
  if (top()) reject('tree-short', 'the list ends before this', pending.pop().path, nodes.length);
}

const part_children = (node, box, refuse, m) => {
  if (node.name === 'wrench' ? node.i >= box.loads.ranges.length
    : node.i >= m || !parameter_names(box.contacts[node.i].n.length).includes(node.name)) refuse('part-contact', `there is no ${node.name} ${printable(node.i)}`);
  const [low, high] = box.interval(node);
  if (node.at.compare(low) <= 0 || node.at.compare(high) >= 0) {
    refuse('part-inside', `${printable(node.at)} is not inside ${printable(interval_text([low, high]))}`);
  }
  const step = `${node.name} ${node.i}`;
  return [[`${step} low`, () => box.cut(node, [low, node.at])], [`${step} high`, () => box.cut(node, [node.at, high])]];
};

/** "Beyond the bound" (§4): some σ d_j − B_j h is nowhere below 0, and where it is 0, the rays are barred together. */
function is_beyond({generators, everyone}, bound) {
  return bound.some((b, j) => [1n, -1n].some((sign) => {
    let mask = everyone;
    for (const {d, h, barred} of generators) {
      const value = sign * b.d * d[j] - b.n * h;
      if (value < 0n) return false;
      if (value === 0n) mask &= barred;
    }
    return mask !== 0n;
  }));
}

/**
 * Trees of regions. pull: of a tree of list 2, A (d − h d⁰) by rows, times one positive number. bound: B, null if motions are not bounded or it is a
 * tree of a wall. Adds to tally.
 */
function check_trees(question, nodes, roots, tree_place, tally) {
  const {m, size} = question;
  const where = (path, number) => [path === null ? tree_place : path.toString() || 'root', number];
  walk(nodes, roots, m, where, (node, {region, pull, bound}, refuse) => {
    ++tally.nodes;
    const child = (step, make) => [step, () => ({region: make(), pull, bound})];
    if (node.kind === 'slip' || node.kind === 'separation') {
      if (node.i >= m) refuse('node-contact', `there is no contact ${printable(node.i)}`);
      const contact = region.box.contacts[node.i], step = `${node.kind} ${node.i}`, space = contact.n.length === 3;
      if (node.kind === 'slip' ? contact.n.length === 1 : contact.spring) refuse('node-contact', `there is no ${step}`);
      if (!(node.kind === 'separation' ? contact.certain_pressure
        : space ? contact.geometry.every(is_point) : contact.rows.certain_slip)) {
        refuse('node-certain', `${node.kind === 'slip' ? (space ? 'the position' : 'T') : 'v'} of contact ${node.i} is uncertain`);
      }
      // Children share what is known of contacts. Where it would fill the memory, each leaf finds out for itself.
      if (!region.isBarred && m < 2 ** 16) region.contacts;
      if (node.kind === 'separation') {
        const v = contact.pressureRow(region.coordinates);
        return [child(`${step} closed`, () => region.cut(v)), child(`${step} open`, () => region.cut(negative(v), {strict: true}))];
      }
      if (space) {
        const still = () => contact.rows.slips[0].reduce((r, row) => r.cut(region.padded(row), {equation: true}), region);
        return [child(`${step} 0`, still), child(`${step} not 0`, () => region.withSlip(node.i))];
      }
      const slip = region.padded(contact.rows.slips[0][0]);
      return [child(`${step} +`, () => region.cut(slip, {strict: true})),
        child(`${step} 0`, () => region.cut(slip, {equation: true})),
        child(`${step} -`, () => region.cut(negative(slip), {strict: true}))];
    }
    if (node.kind === 'plane') {
      const row = integral(node.a);
      return [child('plane +', () => region.cut(row)), child('plane -', () => region.cut(negative(row), {strict: true}))];
    }
    if (node.kind === 'part') {
      return part_children(node, region.box, refuse, m)
          .map(([step, box]) => child(step, () => region.withBox(box())));
    }
    ++tally.leaves;
    const wrong = node.kind === 'moving' ? list_refusal(region, node.slips) : null;
    if (wrong !== null) refuse('moving-list', wrong);
    if (bound !== null && is_beyond(region, bound)) return [];
    if (node.kind === 'moving') {
      if (region.isBarred) return [];
      const found = moving_refusal(region, node, UPWARDS) === null ? null : moving_refusal(region, node, EXACTLY);
      if (found !== null) refuse('leaf-bound', found);
      if (pull !== null && !moves_along(region, node, pull)) refuse('leaf-direction', 'y(x)·A(d - h d0) is below 0 on two rays');
      return [];
    }
    const y = integral(node.a);
    const refusal = leaf_refusal(region, node.a, y);
    if (refusal !== null) refuse('leaf-bound', refusal);
    if (pull !== null && !region.isBarred) {
      const row = pull[0].map((_, k) => dot(y, pull.map((one) => one[k])));
      if (region.generators.some(({x}) => dot(row, x) < 0n)) {
        refuse('leaf-direction', 'y·A(d - h d0) is below 0 on a ray');
      }
    }
    return [];
  });
}

/** The root of a range {low, high, has_low, has_high}, high null for ∞; without a direction, of a verdict. */
function range_root(question, box, range) {
  const {size, coordinates} = question, unit = (j) => Array.from({length: coordinates}, (_, k) => (k === j ? 1n : 0n));
  let region = Region.whole(question, box, coordinates).cut(unit(size), {strict: true});
  if (range !== undefined) {
    const row = (x, sign) => {  // sign (ℓ − x h)
      const result = Array(coordinates).fill(0n);
      result[size] = -sign * x.n;
      result[size + 1] = sign * x.d;
      return result;
    };
    region = region.cut(row(range.low, 1n), {strict: !range.has_low});
    if (range.high !== null) region = region.cut(row(range.high, -1n), {strict: !range.has_high});
  }
  if (question.max_motion !== null) {
    // d_j >= −B_j h, and the sum of d_j / B_j at most D h.
    const bound = question.max_motion, padded = (row) => region.padded(integral(row));
    bound.forEach((b, j) => { region = region.cut(padded([...bound.map((_, k) => (k === j ? ONE : ZERO)), b])); });
    region = region.cut(padded([...bound.map((b) => ONE.negated().over(b)), Fraction.of(BigInt(size))]));
  }
  if (question.bilateral) {
    for (const contact of box.contacts) {
      if (contact.certain_pressure && !contact.spring) region = region.cut(contact.pressureRow(coordinates));
    }
  }
  return region;
}

// ---------------------------------------------------------------------------- Stable at rest (§6)

/** What is stated of contacts: in `friction` f⁰ and G_1, ..., G_D, in `presses` H_1, ..., H_D. */
class StatedForces {
  constructor(question, box, refuse) {
    Object.assign(this, {question, box, refuse, friction: new Map(), presses: new Map()});
  }

  /** Calls take(i, values) of a list; `end` is the first i that is too large. */
  each(list, end, take) {
    let before = -1;
    for (const [i, values] of list) {
      if (i <= before || i >= end) this.refuse(`contact ${printable(i)}: out of order, or not one of ${end}`);
      take(i, values);
      before = i;
    }
  }

  /** A list of which the first force is number `first` of 1 + D. */
  take_friction(list, first) {
    const {question: {space, size, touching}, box: {contacts}, friction} = this;
    this.each(list, touching, (i, forces) => {
      if (space && !forces.every((force) => dot_fractions(contacts[i].n, force).isZero())) this.refuse(`contact ${i}: a force has a part along n`);
      if (!friction.has(i)) friction.set(i, Array(1 + size).fill(zeros(contacts[i].rows.slips[0].length)));
      friction.get(i).splice(first, forces.length, ...forces);
    });
  }

  take_presses(list) {
    this.each(list, this.box.contacts.length, (i, numbers) => {
      if (this.box.contacts[i].k[0].isZero()) this.refuse(`contact ${i}: its stiffness may be 0`);
      this.presses.set(i, numbers);
    });
  }

  has(i) { return this.friction.has(i) || this.presses.has(i); }
  /** Those that are, in their order. */
  listed() { return [...new Set([...this.friction.keys(), ...this.presses.keys()])].sort((a, b) => a - b); }

  /** For each k the largest |W_k|, |M_k1 − δ_k1|, ..., where contact i presses from pushes[i][0] to pushes[i][1]. */
  largest_left(factor, pushes) {
    const {question: {size, u}, box} = this, minus = (row) => row.map((x) => x.negated());
    const units = zeros(size).map((_, k) => zeros(size).map((zero, j) => (j === k ? ONE : zero)));
    const loads = [minus(units.map((e) => box.loads.most(minus(e)))), units.map((e) => box.loads.most(e))];
    // The least and the largest entries of W, and of the columns of M less the unit matrix.
    const lows = new Sum(size * (size + 1)), highs = new Sum(size * (size + 1));
    [lows, highs].forEach((sum, end) => {
      sum.add_fractions([...loads[end].map((w, k) => w.plus(factor.times(u[k]))), ...units.flatMap(minus)]);
    });
    box.contacts.forEach((contact, i) => {
      if (pushes[i].every((push) => push.isZero()) && !this.has(i)) return;
      const forces = this.friction.get(i), presses = this.presses.get(i);
      const corners = corners_of(contact.geometry).flatMap((corner) => {
        const [normal, slips] = contact.rowsAt(corner);
        const columns = Array.from({length: 1 + size}, (_, l) => normal.map((n, k) => {
          const pressed = l > 0 && presses !== undefined ? presses[l - 1].times(n) : ZERO;
          return forces === undefined ? pressed : pressed.plus(dot_fractions(slips.map((row) => row[k]), forces[l]));
        }));
        return pushes[i].map((push) => [...columns[0].map((x, k) => x.plus(push.times(normal[k]))), ...columns.slice(1).flat()]);
      });
      lows.add_fractions(corners[0].map((_, k) => least(corners.map((values) => values[k]))));
      highs.add_fractions(corners[0].map((_, k) => largest(corners.map((values) => values[k]))));
    });
    const [low, high] = [lows, highs].map((sum) => {
      const [row, d] = sum.total();
      return row.map((x) => Fraction.of(x, d));
    });
    const entry = (at) => largest([low[at].negated(), high[at]]);
    return units.map((_, k) => Array.from({length: 1 + size}, (__, l) => entry(l * size + k)));
  }
}

const sum_of = (values) => values.reduce((sum, x) => sum.plus(x), ZERO);
/** values[0] + Σ values[l] Z_l. */
const reached = (values, reach) => sum_of(values.map((x, l) => (l === 0 ? x : x.times(reach[l - 1]))));
/** Of P' for this multiple. */
const preloads_of = ({push}, factor) => push.map(([p, growth]) => p.plus(growth.times(factor)));
/** L_i, a bound from below or above; 1 where friction is a number. */
const length_of = ({n, square}, sign) => (n.length < 3 ? ONE : root_above(square, sign).magnitude());
const length_above = (force, gamma) => (force.length === 1 ? force[0].magnitude() : root_above(friction_square(force, gamma), 1));

/** A part at rest, for the multiples from factors[0] to factors[1], or for the only one. */
function check_rest(question, box, {rest, answers, reach}, place, tally, factors) {
  const refuse = (rule, found) => { throw new Rejected(rule, found, place); };
  const stated = new StatedForces(question, box, (found) => refuse('rest-share', found));
  stated.take_friction(rest, 0);
  stated.take_friction(answers, 1);
  for (const factor of factors) {
    const pushes = box.contacts.map((contact) => preloads_of(contact, factor));
    stated.largest_left(factor, pushes).forEach((left, k) => {
      if (reach[k].sign() < 0) refuse('rest-reach', `Z_${k + 1} is below 0`);
      if (reached(left, reach).compare(reach[k]) > 0) refuse('rest-reach', `Z_${k + 1} = ${printable(reach[k])} is too small`);
    });
    for (const i of stated.listed()) {
      const contact = box.contacts[i], most = contact.mu[0].times(pushes[i][0]).times(length_of(contact, -1));
      const lengths = stated.friction.get(i).map((force) => length_above(force, contact.gamma));
      if (reached(lengths, reach).compare(most) > 0) refuse('rest-cone', `contact ${i}: friction may be more than its cone allows`);
    }
  }
  ++tally.rests;
}

// ---------------------------------------------------------------------------- Stable: sticking (§6)

/** What the rules say of contact i at d⁰, by the names of the text. */
function sticking_at(contact, {twist, reach, energy}, preload, forces = [], presses = []) {
  const {mu, k, gamma: torsion, spring} = contact, two = Fraction.of(2n);
  const at = corners_of(contact.geometry).map((corner) => contact.rowsAt(corner));
  const pulls = at.flatMap(([normal]) => k.map((stiffness) => stiffness.times(dot_fractions(normal, twist))));
  const v = [preload[0].minus(largest(pulls)), preload[1].minus(least(pulls))];
  const a = spring ? v : v.map((x) => largest([ZERO, x]));
  const sigma = largest(at.map(([, slips]) => {
    const s = slips.map((row) => dot_fractions(row, twist));
    return s.length < 2 ? sum_of(s).magnitude() : root_above(sum_of(s.map((x, j) => (j < 3 ? x.times(x) : torsion.times(x).times(x)))), 1);
  }));
  const r = root_above(two.times(energy).times(k[1]), 1);
  const phi = reached(forces.map((force) => length_above(force, torsion)), reach);
  const delta = sum_of(presses.map((h, l) => h.magnitude().times(reach[l])));
  const rho = mu[1].times(length_of(contact, 1)), most = rho.times(a[1]).plus(phi).times(sigma);
  const gamma = largest([ZERO, ...k.filter((x) => !x.isZero()).map((x) => {
    const both = delta.plus(rho.times(x).times(sigma));
    return both.times(both).over(two.times(x)).plus(most);
  })]);
  return {v, a, sigma, r, phi, s: mu[0].times(length_of(contact, -1)).times(v[0].minus(r)).minus(phi), gamma};
}

/** A part that is sticking, for the multiples from factors[0] to factors[1], or for the only one. */
function check_sticking(question, box, proof, place, tally, factors) {
  const {twist, reach, energy} = proof, bound = question.max_motion;
  const refuse = (rule, found) => { throw new Rejected(rule, found, place); };
  const stated = new StatedForces(question, box, (found) => refuse('sticking-share', found));
  stated.take_friction(proof.friction, 0);
  stated.take_presses(proof.presses);
  stated.take_friction(proof.answers, 1);
  if (![...reach, energy].every((x) => x.sign() > 0)) refuse('sticking-share', 'Z or c is not above 0');
  if (!twist.every((x) => x.isZero()) && (factors.length > 1 || box.contacts.some(({n, tilt}) => n.length === 3 && !tilt.isZero()))) {
    refuse('sticking-motion', 'd0 is not 0, for more than one multiple or with uncertain normals');
  }
  if (question.bilateral && box.contacts.some(({spring}, i) => !spring && !stated.has(i))) {
    refuse('sticking-motion', 'a contact is not listed, under the bilateral law');
  }
  const listed = stated.listed(), within = bound === null ? null : bound.map((b, l) => b.minus(twist[l].magnitude()));
  for (const factor of factors) {
    const at = box.contacts.map((contact, i) =>
      sticking_at(contact, proof, preloads_of(contact, factor), stated.friction.get(i), stated.presses.get(i)));
    const left = stated.largest_left(factor, at.map(({a}) => a));
    left.forEach((row, k) => {
      if (reached(row, reach).compare(reach[k]) >= 0) refuse('sticking-reach', `Z_${k + 1} = ${printable(reach[k])} is too small`);
    });
    for (const i of listed) {
      const {v, r, s} = at[i];
      if (!box.contacts[i].spring && v[0].compare(r) < 0) refuse('sticking-press', `contact ${i}: v may be below ${printable(r)}`);
      if (stated.friction.has(i) && s.sign() <= 0) refuse('sticking-press', `contact ${i}: friction may be as large as its cone`);
    }
    const sum = new Sum(1);
    for (const {gamma} of at) sum.add([gamma.n], gamma.d);
    const [[total], d] = sum.total();
    if (energy.compare(new Fraction(total, d)) <= 0) refuse('sticking-energy', `c = ${printable(energy)} is too small`);
    if (within === null) continue;
    const ways = listed.map((i) => {
      const {k, gamma} = box.contacts[i], {s, sigma} = at[i], forces = stated.friction.get(i), presses = stated.presses.get(i);
      const along = presses && root_above(Fraction.of(2n).times(energy).over(k[0]), 1), across = forces && energy.over(s).plus(sigma);
      return twist.map((_, l) => (presses ? presses[l].magnitude().times(along) : ZERO)
          .plus(forces ? length_above(forces[l + 1], gamma).times(across) : ZERO));
    });
    within.forEach((most, l) => {
      const needed = sum_of([...ways.map((way) => way[l]), ...left.map((row, k) => row[l + 1].times(within[k]))]);
      if (within.some((x) => x.sign() <= 0) || needed.compare(most) > 0) refuse('sticking-bound', `motion ${l + 1} may be beyond its bound`);
    });
  }
  ++tally.stickings;
}

// ---------------------------------------------------------------------------- Stable by degree (§6)

/** A basis of the vectors that are 0 by every row: elimination to rows that each have a column of their own. */
function kernel(rows) {
  const size = rows[0].length, own = new Map();  // row by its column
  const clear = (row, at, pivot) => (row[at].isZero() ? row : row.map((x, k) => x.minus(row[at].times(pivot[k]))));
  for (let row of rows) {
    for (const [at, pivot] of own) row = clear(row, at, pivot);
    const at = row.findIndex((x) => !x.isZero());
    if (at < 0) continue;
    row = row.map((x) => x.over(row[at]));
    for (const [other, pivot] of own) own.set(other, clear(pivot, at, row));
    own.set(at, row);
  }
  const columns = Array.from({length: size}, (_, j) => j);
  return columns.filter((j) => !own.has(j))
      .map((free) => columns.map((j) => (own.has(j) ? own.get(j)[free].negated() : j === free ? ONE : ZERO)));
}

/** `degree-free`: whether some contact, friction or load of the box does work on z. */
function sees(question, box, z) {
  const motion = integral(z);
  const works = (rows) => rows.some((row) => dot(row, motion) !== 0n);
  return box.contacts.some(({rows}) => works(rows.normals) || (rows.friction[1] !== 0n && rows.slips.some(works))) ||
    !box.loads.most(z).isZero() || !box.loads.most(z.map((x) => x.negated())).isZero() ||
    (question.margin && !dot_fractions(question.u, z).isZero());
}

const transposed = (rows) => rows[0].map((_, j) => rows.map((row) => row[j]));

/** A basis of Z. */
const free_motions = ({walls, twist}) => kernel(walls.length > 0 ? walls : [twist.map(() => ZERO)]);

/** `degree-walls`. */
function check_walls({walls, simplex}, refuse) {
  if (walls.length === 0) return;
  const dependent = kernel(transposed(walls));  // the c with Σ c_j E_j = 0
  if (dependent.length !== (simplex ? 1 : 0)) refuse('degree-walls', 'the rank of E is another');
  if (dependent.some((c) => c.some((x) => x.sign() * c[0].sign() <= 0))) refuse('degree-walls', 'E is not around 0');
}

/** `degree-free`, `degree-direction`. */
function check_free(question, box, part, refuse) {
  const {direction} = part, free = free_motions(part);
  if (free.some((z) => sees(question, box, z))) refuse('degree-free', 'a force or a load works on Z');
  for (const matrix of [direction, transposed(direction)]) {
    if (kernel(matrix).length !== free.length) refuse('degree-direction', 'the rank of A is another');
    if (matrix.some((row) => free.some((z) => !dot_fractions(row, z).isZero()))) refuse('degree-direction', 'A is not about R^D / Z');
  }
}

/** A node about a grasp of these contacts alone, by their numbers among them; of another the number is that of none. */
function renumbered(node, others) {
  const number = (i) => (others.includes(i) ? others.indexOf(i) : others.length + i);
  const moved = (one) => ({...one, i: number(one.i)});
  if (node.kind === 'moving') return {...node, slips: node.slips.map(moved)};
  return node.kind === 'slip' || node.kind === 'separation' || (node.kind === 'part' && node.name !== 'wrench') ? moved(node) : node;
}

/** For each motion the numbers that e has at vertices of K, across Z and with s + t = 1, or the two that are least and largest. */
function reach_of({walls, simplex, twist}) {
  if (walls.length === 0) return twist.map(() => [ZERO]);
  const size = walls[0].length, rows = simplex ? walls.slice(0, -1) : walls;
  // The columns c of (E; Z)⁻¹ that are for E: of (E, −1; Z, 0) the kernel is that of all (c, u) with u = E c.
  const columns = kernel([...rows, ...kernel(rows)].map((row, i) => [...row, ...rows.map((_, k) => (i === k ? ONE.negated() : ZERO))]));
  const motions = Array.from({length: size}, (_, j) => columns.map((c) => c[j]));
  const total = (list) => list.reduce((sum, x) => sum.plus(x), ZERO);
  if (!simplex) return motions.map((list) => total(list.map((x) => x.magnitude()))).map((most) => [most.negated(), most]);
  // All rows but one are 1 at a vertex; if that is row k, it is −(the other c) / c_k.
  const [c] = kernel(transposed(walls));
  const less = rows.map((_, k) => total(c).over(c[k]));
  return motions.map((list) => [total(list), ...list.map((x, k) => total(list).minus(x.times(less[k])))]);
}

/** `degree-bound`. */
function check_bound(part, bound, refuse) {
  const reach = reach_of(part);
  bound.forEach((b, j) => {
    if (reach[j].some((e) => part.twist[j].plus(e).magnitude().compare(b) > 0)) {
      refuse('degree-bound', `motion ${j + 1} of K goes beyond ${printable(b)}`);
    }
  });
}

/**
 * The multiples and the motions of K: e = d − s d' − t d" as functions of (h, ℓ). Of a part that is not about multiples s = h and
 * t = 0; of: {low, high}, high null without an end.
 */
function frame_of(part, of) {
  if (!part.end_twist) return {s: [ONE, ZERO], t: [ZERO, ZERO]};
  if (of.high === null) return {s: [ONE, ZERO], t: [ONE.negated(), ONE.over(of.low)]};
  const length = of.high.minus(of.low);
  return {s: [of.high.over(length), ONE.over(length).negated()], t: [of.low.over(length).negated(), ONE.over(length)]};
}

/**
 * A part that is not cut, or a segment by degree: walls, direction, law, and its trees. of: in a margin {low, high}, the
 * multiples of the claim.
 */
function check_degree(question, box, part, place, tally, of) {
  const {size, coordinates} = question;
  const refuse = (rule, found) => { throw new Rejected(rule, found, place); };
  check_walls(part, refuse);
  const {s, t} = frame_of(part, of);
  // Functions of (h, ℓ), and those of (e, h, ℓ), as rows of points.
  const function_of = (at, motion = Array(size).fill(ZERO)) => [...motion, ...at].slice(0, coordinates);
  const sum = (a, b, factor = ONE) => a.map((x, k) => x.plus(factor.times(b[k])));
  const other = part.end_twist ?? part.twist;
  const about = (row, by) => {  // row·e + by·(s + t)
    const begin = s.map((x) => x.times(by.minus(dot_fractions(row, part.twist))));
    return function_of(sum(begin, t, by.minus(dot_fractions(row, other))), row);
  };
  const minus = (row) => row.map((x) => x.negated());
  const walls = part.walls.flatMap((row, j) => (part.simplex ? [[`${j + 1}`, row]]
    : [[`${j + 1} +`, row], [`${j + 1} -`, minus(row)]]));
  // Over K, or over one of its walls.
  const region_on = (one, on, halfway) => {
    let region = Region.whole(question, one, coordinates).cut(integral(function_of(sum(s, t))), {strict: true});
    if (part.end_twist) {
      for (const at of [s, t]) region = region.cut(integral(function_of(at)));
      if (halfway) region = region.cut(integral(function_of(sum(s, t, ONE.negated()))), {equation: true});
    } else if (of !== undefined) {
      const multiple = (x) => [...Array(size).fill(0n), -x.n, x.d];
      if (halfway) {
        region = region.cut(multiple(middle([of.low, of.high])), {equation: true});
      } else {
        region = region.cut(multiple(of.low)).cut(negative(multiple(of.high)));
      }
    }
    for (const [name, row] of walls) region = region.cut(integral(about(minus(row), ONE)), {equation: name === on});
    return region;
  };
  let {tree} = part;
  const {open = []} = part;
  if (open.length > 0) {
    open.forEach((i, k) => {
      if (i >= question.m || (k > 0 && i <= open[k - 1])) refuse('degree-open', `contact ${printable(i)} is out of order`);
    });
    if (question.bilateral) refuse('degree-open', 'no contact opens under the bilateral law');
    const across = free_motions(part).reduce((region, z) => region.cut(integral(about(z, ZERO)), {equation: true}), region_on(box, null, false));
    for (const i of open) {
      const {rows, spring} = box.contacts[i];
      if (spring || across.generators.some((ray) => pressures(rows, ray)[1] > 0n)) refuse('degree-open', `contact ${i} is a spring, or v may be above 0`);
    }
    const others = box.contacts.map((_, i) => i).filter((i) => !open.includes(i));
    [question, box, tree] = [{...question, m: others.length}, box.only(others), tree.map((node) => renumbered(node, others))];
  }
  check_free(question, box, part, refuse);
  if (question.max_motion !== null) check_bound(part, question.max_motion, refuse);
  if (question.bilateral) {
    const whole = region_on(box, null, false);
    box.contacts.forEach(({rows, spring}, i) => {
      if (!spring && whole.generators.some((ray) => pressures(rows, ray)[0] < 0n)) refuse('degree-law', `v may be below 0 at contact ${i}`);
    });
  }
  const pull = part.direction.map((row) => about(row, ZERO));  // A e
  const roots = [];
  const list = (one, prefix, halfway, one_pull) => {
    for (const [name] of walls) {
      const path = new Path(null, `${place}, ${prefix}wall ${name}`);
      roots.push({path, make: () => ({region: region_on(one, name, halfway), pull: one_pull, bound: null})});
    }
  };
  const single = box.isPoint() && (of === undefined || (of.high !== null && of.low.equals(of.high)));
  if (!single) list(box, '', false, null);
  list(box.middle(), 'middle ', true, pull.map((row) => over_denominator(row, common_denominator(pull.flat()))));
  check_trees(question, tree, roots, place, tally);
  ++tally.degrees;
}

function check_parts(question, box, parts, tally) {
  const where = (path, number) => [[`part ${number}`, path === null ? '' : path.toString()].filter((x) => x !== '').join(', '), null];
  walk(parts, [{make: () => box, path: new Path(null, '')}], question.m, where, (part, own, refuse, place) => {
    if (part.kind === 'part') return part_children(part, own, refuse, question.m);
    if (part.kind === 'rest') check_rest(question, own, part, place(), tally, [ZERO]);
    else if (part.kind === 'sticking') check_sticking(question, own, part, place(), tally, [ZERO]);
    else check_degree(question, own, part, place(), tally);
    return [];
  });
}

// ---------------------------------------------------------------------------- Margins (§5)

/** Whether w and all P are 0. */
function is_unloaded(question) {
  return question.wrench.every(([w]) => w.isZero()) && question.contacts.every((c) => c.preload[0].isZero());
}

function check_segments(question, box, {resisted, segments, tree}, tally) {
  resisted.forEach(([low, high], k) => {
    const before = k > 0 ? resisted[k - 1][1] : undefined;
    if (low.sign() < 0 || (high !== null && low.compare(high) > 0) || before === null ||
        (before !== undefined && before.compare(low) >= 0)) {
      throw new Rejected('resisted-order', 'needed is 0 <= lo <= hi < the next lo, and null at the end only', `interval ${k}`);
    }
  });

  // The interval that segments are about, and how far they have come, null where it begins.
  let interval = 0, reached = null;
  segments.forEach((segment, k) => {
    const place = `segment ${k}`;
    const broken = (found) => { throw new Rejected('segment-chain', found, place); };
    if (interval === resisted.length) broken('a segment is left over');
    const [low, high] = resisted[interval];
    const start = reached ?? low;
    const by_degree = segment.kind === 'degree';
    const to = by_degree ? segment.to : segment[1].factor;
    if (!by_degree && !segment[0].factor.equals(start)) {
      broken(`begins at ${printable(segment[0].factor)}, not at ${printable(start)}`);
    }
    if (to === null) {
      if (high !== null) broken('a ray in an interval that ends');
    } else {
      if (to.compare(start) < 0 || (by_degree && to.equals(start))) broken('does not go up');
      if (high !== null && to.compare(high) > 0) broken('goes beyond the end of its interval');
    }
    const ends = to === null ? high === null : high !== null && to.equals(high);
    if (by_degree) {
      const all = to === null && start.isZero();
      if (all && !is_unloaded(question)) broken('from 0 without an end, but the wrench or a preload is not 0');
      check_degree(question, box, segment, place, tally, {low: all ? ONE : start, high: to});
    } else {
      const states = [[segment[0], 'first'], [segment[1], 'second']].map(([point, name]) => {
        const [h, factor] = point.factor === null ? [ZERO, ONE] : [ONE, point.factor];
        return check_witness(question, box, point, h, factor, `${place}, ${name} point`);
      });
      check_mode(box, ...states, place);
    }
    [interval, reached] = ends ? [interval + 1, null] : [interval, to];
  });
  if (interval < resisted.length) {
    throw new Rejected('segment-chain', `interval ${interval} is not proved to its end`, `segment ${segments.length}`);
  }

  const gaps = [];
  let low = ZERO, has_low = true;
  for (const [lo, hi] of resisted) {
    if (lo.compare(low) > 0) gaps.push({low, high: lo, has_low, has_high: false});
    [low, has_low] = [hi, false];
  }
  if (low !== null) gaps.push({low, high: null, has_low, has_high: false});
  check_trees(question, tree, gaps.map((gap) => ({path: new Path(null, ''),
    make: () => ({region: range_root(question, box, gap), pull: null, bound: question.max_motion})})), null, tally);
  tally.segments = segments.length;
  tally.trees = gaps.length;
}

function check_claims(question, box, claims, tally) {
  const unloaded = is_unloaded(question);
  const resisted = [], refuted = [];
  claims.forEach(({kind, low, high, part, points, tree}, k) => {
    const place = `interval ${k}`, before = k > 0 ? claims[k - 1].high : ZERO;
    if (low.sign() < 0 || before === null || before.compare(low) > 0 ||
        (high !== null && low.compare(high) > (kind === 'stable' ? 0 : -1))) {
      throw new Rejected('interval-order', 'needed is 0 <= LOW <= HIGH <= the next LOW, and LOW < HIGH if unstable', place);
    }
    if (kind === 'stable' && high === null && !(low.isZero() && unloaded)) {
      throw new Rejected('interval-whole', 'without end only if LOW, w and P are 0', place);
    }
    if (kind === 'stable' && high === null && question.max_motion !== null) {
      throw new Rejected('interval-whole', 'without end, but motions are bounded', place);
    }
    if (kind === 'unstable') {
      const range = {low, high, has_low: k === 0 && low.isZero() && !unloaded, has_high: false};
      check_trees(question, tree, [{path: new Path(null, place),
        make: () => ({region: range_root(question, box, range), pull: null, bound: question.max_motion})}], place, tally);
      refuted.push([low, high, range.has_low]);
      ++tally.trees;
      return;
    }
    if (part !== undefined && part.kind !== 'degree') {
      (part.kind === 'rest' ? check_rest : check_sticking)(question, box, part, place, tally,
          high === null ? [ONE] : low.equals(high) ? [low] : [low, high]);
    } else if (part !== undefined) {
      check_degree(question, box, part, place, tally, high === null ? {low: ONE, high: ONE} : {low, high});
    } else {
      const factors = high === null ? [ONE] : [low, high].slice(0, points.length);
      const states = points.map((point, j) =>
        check_witness(question, box, point, ONE, factors[j], `${place}, ${j === 0 ? 'first' : 'second'} point`));
      if (states.length === 2) check_mode(box, ...states, place);
    }
    const last = resisted[resisted.length - 1];
    if (last !== undefined && last[1].equals(low)) last[1] = high;
    else resisted.push([low, high]);
  });
  return {resisted, refuted};
}

// ---------------------------------------------------------------------------- The answer (§8)

/** The question as it was understood, its numbers as texts. */
function question_as_asked(question) {
  const texts = (list) => (list === null ? null : list.map(String));
  return {
    contacts: question.m,
    wrench: question.wrench.map(([low, high]) => (low.equals(high) ? `${low}` : [`${low}`, `${high}`])),
    preload: question.preload === null ? null : `${question.preload}`,
    normal_law: question.law,
    direction: texts(question.direction),
    preload_direction: question.scale ? 'scale' : texts(question.growth),
    uncertain: question.uncertain.size === 0 ? null
      : Object.fromEntries([...question.uncertain].map(([kind, t]) => [kind, !is_ball(t) ? tolerance_text(t)
        : {ball: `${t.radius}`, length: `${t.length}`, about: texts(t.about), ...(t.body === null ? {} : {body: t.body})}])),
    ...(question.max_motion === null ? {} : {max_motion: texts(question.max_motion)}),
  };
}

/**
 * Checks a certificate about a question. grasp and certificate are the files, as Uint8Array or as text. options may have
 * wrench and direction (arrays of numbers as texts, such as "-11/10"), case (a name), preload (a text), normal_law
 * ("unilateral" or "bilateral"), preload_direction ("scale" or an array of texts), uncertain (an object of
 * tolerances as texts, such as {friction: "10%"}; of wrench a ball, too, "ball:R[:length=L][:about=X:Y[:Z]][:body=NAME]"),
 * max_motion (an array of texts, or "none") and plane or inertia (which are not judged).
 *
 * answer is "accepted", "rejected", "malformed" or "not judged", which found explains. If rejected, rule, place, node
 * (the number of a node in its list) and found say why; if malformed, file ("grasp", "certificate" or "question"), place and found. If accepted, verdict is
 * "stable", "unstable" or "margin"; box says whether the question is a box; question is as it was understood; resisted and,
 * in space, refuted are the intervals of a margin, [low, high or null] as texts, of refuted with whether low belongs to
 * it; proof counts what was checked.
 */
function check(grasp, certificate, options = {}) {
  const answer = {answer: null, rule: null, node: null, place: null, found: null, file: null, verdict: null, box: null,
    nodes: null, leaves: null, resisted: null, refuted: null, question: null, proof: null};
  let file = 'grasp';
  Object.assign(work, {limited: true, bytes: 0, steps: 0, products: 0});
  try {
    if (options.plane !== undefined) throw new NotJudged('regions of a plane: stickslip-check judges them');
    if (options.inertia !== undefined) throw new NotJudged('classes of rigid contacts: stickslip-check judges them');
    const read = read_grasp(text_of(grasp, GRASP_LIMITS, true));
    file = 'question';
    const question = ask(read, options);
    question.coordinates = question.size + (question.margin ? 2 : 1);
    file = 'certificate';
    const proof = new CertificateReader(question).read(text_of(certificate, CERTIFICATE_LIMITS, false));
    agree(question, proof.question);

    const tally = {nodes: 0, leaves: 0, rests: 0, stickings: 0, degrees: 0, trees: 0, segments: 0};
    const box = Box.of(question, proof.bits);
    let intervals = null;
    if (proof.claims !== undefined) {
      intervals = check_claims(question, box, proof.claims, tally);
    } else if (proof.resisted !== undefined) {
      check_segments(question, box, proof, tally);
      intervals = {resisted: proof.resisted, refuted: null};
    } else if (proof.parts !== undefined) {
      check_parts(question, box, proof.parts, tally);
    } else if (proof.tree !== undefined) {
      check_trees(question, proof.tree, [{path: new Path(null, ''),
        make: () => ({region: range_root(question, box), pull: null, bound: question.max_motion})}], null, tally);
    } else {
      check_witness(question, box, proof.point, ONE, ZERO, null);
    }
    const texts = (list) => list.map((range) => range.map((x) => (x instanceof Fraction ? `${x}` : x)));
    Object.assign(answer, {answer: 'accepted', verdict: proof.verdict, box: question.box, proof: tally,
      question: question_as_asked(question)});
    if (proof.point === undefined) Object.assign(answer, {nodes: tally.nodes, leaves: tally.leaves});
    if (intervals !== null) {
      answer.resisted = texts(intervals.resisted);
      if (intervals.refuted !== null) answer.refuted = texts(intervals.refuted);
    }
  } catch (error) {
    if (error instanceof Malformed) {
      Object.assign(answer, {answer: 'malformed', file, place: error.place, found: error.message});
    } else if (error instanceof Rejected) {
      Object.assign(answer, {answer: 'rejected', rule: error.rule, place: error.place, node: error.node, found: error.message});
    } else if (error instanceof NotJudged) {
      Object.assign(answer, {answer: 'not judged', found: error.message});
    } else {
      throw error;  // an error of this program, or no memory: no answer
    }
  } finally {
    work.limited = false;
  }
  return answer;
}

scope.StickslipCheck = {check};
if (typeof module !== 'undefined') {
  module.exports = {check, for_tests: {Fraction, Sum, gcd, integer_root, enclose_root, dot, Cone, Contact, pressures, plane_bound}};
}

})(typeof globalThis !== 'undefined' ? globalThis : this);
