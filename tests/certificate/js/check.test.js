// SPDX-License-Identifier: MIT
'use strict';

const assert = require('node:assert');
const fs = require('node:fs');
const path = require('node:path');
const vm = require('node:vm');
const {test} = require('node:test');

const ROOT = path.join(__dirname, '..', '..', '..');
const SCRIPT = path.join(ROOT, 'certificate', 'js', 'check.js');
const {check, for_tests} = require(SCRIPT);
const {Fraction, Sum, gcd, integer_root, enclose_root, dot, Cone, Contact, pressures, plane_bound} = for_tests;

/** Whole numbers from low to high, the same in every run. */
class Random {
  constructor(seed) { this.state = BigInt(seed); }
  bits() {
    this.state = (this.state * 6364136223846793005n + 1442695040888963407n) & ((1n << 64n) - 1n);
    return this.state >> 32n;
  }
  from(low, high) { return low + Number(this.bits() % BigInt(high - low + 1)); }
  long(words) {
    let n = 0n;
    for (let k = 0; k < words; ++k) n = (n << 32n) | this.bits();
    return n;
  }
}

const fraction = (n, d = 1) => Fraction.of(BigInt(n), BigInt(d));
const big = (list) => list.map(BigInt);

// ---- Arithmetic

test('gcd is Euclid\'s, of numbers of any length', () => {
  const random = new Random(1), plain = (a, b) => (b === 0n ? (a < 0n ? -a : a) : plain(b, a % b));
  const slow = (a, b) => {
    while (b !== 0n) [a, b] = [b, a % b];
    return a;
  };
  assert.strictEqual(plain(-4n, 6n), 2n);
  for (let k = 0; k < 300; ++k) {
    const c = random.long(random.from(0, 60));
    const a = random.long(random.from(0, 400)) * c, b = random.long(random.from(0, 400)) * c;
    assert.strictEqual(gcd(a, b), slow(a, b));
    assert.strictEqual(gcd(-a, b), slow(a, b));
  }
  const huge = 1n << 20000n;
  assert.strictEqual(gcd(0n, huge), huge);
  assert.strictEqual(gcd(huge, huge), huge);
  assert.strictEqual(gcd(huge, 3n * huge), huge);
});

test('roots are the greatest below, with as many bits as asked for', () => {
  const random = new Random(2);
  for (let k = 0; k < 400; ++k) {
    const n = k < 50 ? BigInt(k) : random.long(random.from(1, 20)), root = integer_root(n);
    assert.ok(root * root <= n && n < (root + 1n) * (root + 1n));
    const q = Fraction.of(random.long(random.from(1, 8)) + 1n, random.long(random.from(1, 8)) + 1n);
    for (const bits of [64, 65, 128]) {
      const [low, high] = enclose_root(q, bits);
      assert.ok(low.times(low).compare(q) <= 0 && q.compare(high.times(high)) < 0);
      // low = j/2^s and high = (j + 1)/2^s with 2^(bits−1) ≤ j < 2^bits.
      const j = low.over(high.minus(low));
      assert.strictEqual(j.d, 1n);
      assert.strictEqual(j.n.toString(2).length, bits);
      const step = high.minus(low), power = step.n === 1n ? step.d : step.n;
      assert.ok(step.n === 1n || step.d === 1n);
      assert.strictEqual(power & (power - 1n), 0n);
    }
  }
});

test('a sum is that of its fractions', () => {
  const random = new Random(3);
  for (let k = 0; k < 100; ++k) {
    const sum = new Sum(2);
    const plain = [fraction(0), fraction(0)];
    for (let l = random.from(0, 20); l > 0; --l) {
      const d = random.from(1, 9), row = [random.from(-9, 9), random.from(-9, 9)];
      sum.add(big(row), BigInt(d));
      row.forEach((x, j) => { plain[j] = plain[j].plus(fraction(x, d)); });
    }
    const [row, d] = sum.total();
    assert.ok(d > 0n);
    row.forEach((x, j) => assert.ok(Fraction.of(x, d).equals(plain[j])));
  }
});

// ---- Cones

test('a region\'s generators satisfy its conditions, and nothing else is in it', () => {
  const random = new Random(5);
  for (let k = 0; k < 400; ++k) {
    const conditions = Array.from({length: random.from(1, 7)}, () => ({equation: random.from(0, 6) === 0,
      a: big(Array.from({length: 4}, () => random.from(-2, 2)))}));
    let cone = Cone.whole(4);
    for (const {a, equation} of conditions) cone = cone.cut(a, equation);
    const all = [...cone.rays.map(({x}) => x), ...cone.lines, ...cone.lines.map((x) => x.map((c) => -c))];
    for (const x of all) {
      for (const {a, equation} of conditions) assert.ok(equation ? dot(a, x) === 0n : dot(a, x) >= 0n);
    }
    const inequalities = conditions.filter(({equation}) => !equation);
    for (const {x, zero} of cone.rays) {
      inequalities.forEach(({a}, j) => assert.strictEqual(dot(a, x) === 0n, (zero >> BigInt(j) & 1n) === 1n));
    }
    // A linear function that is >= 0 on all generators is so at every point of the region, and small points are tried.
    for (let l = 0; l < 20; ++l) {
      const f = big(Array.from({length: 4}, () => random.from(-2, 2))), x = big(Array.from({length: 4}, () => random.from(-3, 3)));
      const in_region = conditions.every(({a, equation}) => (equation ? dot(a, x) === 0n : dot(a, x) >= 0n));
      if (in_region && all.every((g) => dot(f, g) >= 0n)) assert.ok(dot(f, x) >= 0n);
    }
  }
});

// ---- Bounds of boxes

test('the bound of a contact is not below what it bounds, anywhere in its box, and is that at a point', () => {
  const random = new Random(6);
  const interval = (low, high, wide) => {
    const a = random.from(low, high), b = wide ? random.from(a, high) : a;
    return [fraction(a, 4), fraction(b, 4)];
  };
  let tight = 0;
  for (let k = 0; k < 400; ++k) {
    const wide = () => k % 4 !== 0 && random.from(0, 1) === 0;
    const e = fraction(wide() ? random.from(0, 2) : 0, 8), push = interval(0, 8, wide());
    const contact = new Contact({motion: null, n: [fraction(random.from(1, 3)), fraction(random.from(-2, 2))],
      geometry: [interval(-8, 8, wide()), interval(-8, 8, wide()), [e.negated(), e]], mu: interval(0, 4, wide()),
      push: push.map((x) => [x, fraction(0)]), k: interval(1, 8, wide())});
    const y = big([random.from(-3, 3), random.from(-3, 3), random.from(-3, 3)]);
    const ray = {d: big([random.from(-3, 3), random.from(-3, 3), random.from(-3, 3)]), h: BigInt(random.from(0, 3)), l: 0n};
    const side = random.from(-1, 1), [low, high] = pressures(contact.rows, ray);
    if (high <= 0n) continue;
    const closed = low >= 0n, {alpha, d, term} = plane_bound(contact, y, side, closed);
    const value = term !== undefined ? term(ray) : alpha > 0n || closed ? alpha * high : 0n;
    const bound = Fraction.of(value, d);
    for (let l = 0; l < 12; ++l) {
      const within = ([a, b]) => a.plus(b.minus(a).times(fraction(random.from(0, 4), 4)));
      const at = contact.geometry.map(within), mu = within(contact.mu);
      const strength = side > 0 ? mu.negated() : side < 0 ? mu : mu.times(fraction(random.from(-4, 4), 4));
      const [normal, [tangent]] = contact.rowsAt(at);
      const product = (row, x) => row.reduce((sum, c, j) => sum.plus(c.times(fraction(x[j]))), fraction(0));
      const v = within(push).times(fraction(ray.h)).minus(within(contact.k).times(product(normal, ray.d)));
      const work = product(normal, y).plus(strength.times(product(tangent, y))).times(v.sign() > 0 ? v : fraction(0));
      assert.ok(work.compare(bound) <= 0, `${work} ${bound}`);
      if (work.equals(bound)) ++tight;
    }
  }
  assert.ok(tight > 200, `${tight}`);
});

// ---- Certificates

function asked(contacts, wrench, verdict, evidence) {
  return [JSON.stringify({format: 'stickslip-grasp/2', contacts, wrench}), JSON.stringify({format: 'stickslip-certificate/2',
    question: {contacts: contacts.length, wrench, normal_law: 'unilateral'}, verdict, ...evidence})];
}

test('numbers that a double would round are read as they are spelled', () => {
  const n = '9007199254740993', files = asked([], [0, 0, 0], 'stable', {twist: [0, 0, 0], shares: []});
  const [grasp, certificate] = files.map((text) => text.replace('"wrench":[0', `"wrench":[${n}`));
  const answer = check(grasp, certificate);
  assert.deepStrictEqual([answer.rule, answer.place], ['witness-balance', null]);
  assert.strictEqual(check(grasp, certificate.replace(n, '9007199254740992')).rule, 'question-wrench');
  assert.strictEqual(check(...files).answer, 'accepted');
});

test('balls of loads are read from the option, and what is wrong with them is said', () => {
  const [grasp, certificate] = asked([], [0, 0, 1], 'unstable', {tree: [['leaf', 0, 0, -1]]});
  const stated = (ball) => certificate.replace('"normal_law":"unilateral"', `$&,"uncertain":{"wrench":${JSON.stringify(ball)}}`);
  const ball = {ball: '1/4', length: 2, about: [3, 0]};
  const about = (wrench, certificate_text = stated(ball)) => check(grasp, certificate_text, {uncertain: {wrench}});
  const answer = about('ball:0.25:about=3:0:length=2');
  assert.deepStrictEqual([answer.answer, answer.question.uncertain],
      ['accepted', {wrench: {ball: '1/4', length: '2', about: ['3', '0']}}], answer.found);
  // The ball does √13/4 of work on the twist, and √25/4 with twice the length; the torque takes 1.
  assert.strictEqual(about('ball:1/4:length=4:about=3:0', stated({...ball, length: 4})).rule, 'leaf-bound');
  assert.strictEqual(about('ball:1/4:length=2').rule, 'question-uncertain');
  for (const [text, found] of [['ball:0', /radius 0 must be above 0/], ['ball:1:length=-1', /length -1 must be above 0/],
    ['ball:1:about=1', /1 coordinates, must have 2/], ['ball:1:about=1:2:3', /3 coordinates, must have 2/], ['ball:1:body=it', /of one alone/],
    ['ball:5%', /"5%" is not a number/], ['ball:1:2', /"2" is not length=L/], ['ball:1:length=1:length=1', /at most once/]]) {
    const {answer: said, file, place, found: why} = about(text);
    assert.deepStrictEqual([said, file, place], ['malformed', 'question', 'the question: uncertain wrench'], text);
    assert.match(why, found);
  }
});

test('bytes serve as well as text; what is not UTF-8 is malformed', () => {
  const [grasp, certificate] = asked([], [0, 0, 0], 'stable', {twist: [0, 0, 0], shares: []});
  const bytes = new TextEncoder().encode(grasp);
  assert.strictEqual(check(bytes, certificate).answer, 'accepted');
  bytes[3] = 255;
  const answer = check(bytes, certificate);
  assert.deepStrictEqual([answer.answer, answer.file], ['malformed', 'grasp']);
});

test('a plain script: in a browser it needs TextDecoder, and leaves one global', () => {
  const sandbox = {TextDecoder, TextEncoder};
  vm.runInNewContext(fs.readFileSync(SCRIPT, 'utf8'), sandbox);
  assert.deepStrictEqual(Object.keys(sandbox), ['TextDecoder', 'TextEncoder', 'StickslipCheck']);
  assert.deepStrictEqual(Object.keys(sandbox.StickslipCheck), ['check']);
  const [grasp, certificate] = asked([], [0, 0, 0], 'stable', {twist: [0, 0, 0], shares: []});
  assert.strictEqual(sandbox.StickslipCheck.check(grasp, certificate).answer, 'accepted');
});
