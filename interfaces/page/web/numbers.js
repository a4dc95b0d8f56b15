// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact numbers: what a grasp file, an answer or a certificate spells, as fractions of BigInts.
(function (page) {
  const kRounded = "~";

  function gcd(a, b) {
    if (a < 0n) a = -a;
    while (b !== 0n) [a, b] = [b < 0n ? -b : b, a % (b < 0n ? -b : b)];
    return a;
  }

  class Fraction {
    constructor(numerator, denominator = 1n) {
      if (denominator < 0n) [numerator, denominator] = [-numerator, -denominator];
      const common = gcd(numerator, denominator) || 1n;
      this.n = numerator / common;
      this.d = denominator / common;
    }
    /** Of "3/5", "-0.25", "1e-3" or a number; throws a SyntaxError at anything else. */
    static of(value) {
      if (value instanceof Fraction) return value;
      const parts = /^([+-]?)(\d*)(?:\.(\d*))?(?:[eE]([+-]?\d{1,4}))?(?:\/(\d+))?$/.exec(String(value));
      if (!parts || parts[2] + (parts[3] || "") === "") {
        throw new SyntaxError(String(value) + " is not a number");
      }
      const [, sign, whole, decimals = "", exponent = "0", divisor = "1"] = parts;
      const power = Number(exponent) - decimals.length;
      const digits = BigInt(sign + (whole + decimals));
      const scale = 10n ** BigInt(Math.abs(power));
      return power >= 0 ? new Fraction(digits * scale, BigInt(divisor)) : new Fraction(digits, BigInt(divisor) * scale);
    }
    plus(other) {
      return new Fraction(this.n * other.d + other.n * this.d, this.d * other.d);
    }
    times(other) {
      return new Fraction(this.n * other.n, this.d * other.d);
    }
    minus(other) {
      return this.plus(other.negated());
    }
    negated() {
      return new Fraction(-this.n, this.d);
    }
    abs() {
      return this.n < 0n ? this.negated() : this;
    }
    sign() {
      return this.n > 0n ? 1 : this.n < 0n ? -1 : 0;
    }
    toString() {
      return this.d === 1n ? String(this.n) : this.n + "/" + this.d;
    }
    toNumber() {
      // Both ends may exceed the doubles, so what exceeds 2^1000 is cut off of both.
      const bits = (x) => x.toString(16).length * 4;
      const cut = BigInt(Math.max(0, Math.max(bits(this.n), bits(this.d)) - 1000));
      const whole = this.n / this.d;
      if (cut === 0n) return Number(this.n) / Number(this.d);
      return Number(this.d >> cut) === 0 ? Number(whole) : Number(this.n >> cut) / Number(this.d >> cut);
    }
  }
  page.Fraction = Fraction;

  /** A true minus sign, as in pictures. */
  page.typeset = (text) => String(text).replace(/-/g, "\u2212");

  /** A double, with so many significant digits, without trailing zeros. */
  page.near = (value, digits = 4) =>
    page.typeset(Object.is(value, -0) || Math.abs(value) < 1e-300 ? 0 : Number(value.toPrecision(digits)));

  /** As the program prints it: short fractions, else six digits, marked if rounded. */
  function shortText(value) {
    const exact = Fraction.of(value);
    const bound = exact.d === 1n ? 1000000000n : 100n;
    if (exact.abs().n < bound && exact.d < bound) return page.typeset(exact);
    const near = Number(exact.toNumber().toPrecision(6));
    let spelled = String(near);
    if (!spelled.includes("e")) {
      const same = Fraction.of(spelled);
      if (same.n === exact.n && same.d === exact.d) return page.typeset(spelled);
    }
    return page.typeset(kRounded + spelled);
  }
  /** So; with all digits where the reader asked for them. */
  page.text = (value) => (page.shown.exact ? page.typeset(Fraction.of(value)) : shortText(value));
  /** In drawings, where there is no room for all digits. */
  page.label = function (value) {
    const text = shortText(value);
    return text.startsWith(kRounded) ? kRounded + page.near(Fraction.of(value).toNumber()) : text;
  };
  /**
   * Points as labels of one drawing: all in short fractions, or all in decimals of at most four digits with one mark before
   * what is rounded, as in pictures.
   */
  page.pointLabels = function (points) {
    const inFractions = points.flat().every((x) => /^[\u2212\d/]+$/.test(shortText(x)));
    return points.map((point) => {
      const near = point.map((x) => Fraction.of(inFractions ? x : Fraction.of(x).toNumber().toPrecision(4)));
      const exact = near.every((x, j) => x.minus(Fraction.of(point[j])).sign() === 0);
      const texts = near.map((x) => (inFractions ? page.typeset(x) : page.near(x.toNumber())));
      return (exact ? "" : kRounded) + "(" + texts.join(", ") + ")";
    });
  };
  page.tuple = (values) => "(" + values.map(page.text).join(", ") + ")";
  page.nearTuple = (values) => "(" + values.map((value) => page.near(value)).join(", ") + ")";

  /** A number on the page: short, with all digits where one points at it. */
  page.number = function (value) {
    const short = page.text(value);
    const all = page.typeset(Fraction.of(value));
    return page.html("span", { class: "number", title: short === all ? null : all }, short);
  };
  /** In tables: four digits of what is not short, all where one points at it. */
  page.brief = function (value) {
    const element = page.number(value);
    const near = page.near(Fraction.of(value).toNumber());
    if (!page.shown.exact && near.length + 1 < element.textContent.length) element.textContent = kRounded + near;
    return element;
  };
  page.numbers = (values, number = page.number) =>
    page.html(
      "span",
      { class: "tuple" },
      "(",
      values.map((value, i) => [i ? ", " : "", number(value)]),
      ")",
    );

  /** A load or a motion: of several bodies what is not 0 of it, by the names of coordinates. */
  page.state = function (values, number = page.number) {
    const { mechanism } = page.answer;
    if (!mechanism) return page.numbers(values, number);
    const entries = values.flatMap((value, j) =>
      !Array.isArray(value) && page.Fraction.of(value).sign() === 0 ? [] : [[mechanism.coordinates[j].replace(/ /g, "\u00A0") + "\u00A0", number(value)]],
    );
    return page.html("span", { class: "tuple" }, entries.length === 0 ? "0" : entries.map((e, k) => [k ? ", " : "", e]));
  };

  /** The largest of 1, 2, 5 times a power of ten that is not above a positive number. */
  page.roundDown = function (value) {
    const ten = 10 ** Math.floor(Math.log10(value) + 1e-9);
    return (5 * ten <= value ? 5 : 2 * ten <= value ? 2 : 1) * ten;
  };
  /** "x 1000", "x 1/5": powers of ten with 1, 2 or 5. */
  page.factorText = (factor) => "×\u202F" + (factor >= 1 ? page.near(factor) : "1/" + page.near(1 / factor));

  /** The shortest decimal near a double that is a multiple of a round step. */
  page.decimal = function (value, step) {
    const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
    const text = (Math.round(value / step) * step).toFixed(decimals);
    return String(Number(text));
  };
})(StickslipPage);
