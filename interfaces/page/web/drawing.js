// SPDX-License-Identifier: GPL-3.0-or-later
//
// The marks of all drawings, as `stickslip plot` makes them: pages and pictures speak one language.
(function (page) {
  const { svg, vector } = page;
  const kHead = 11;

  const at = (p) => p[0].toFixed(2) + " " + p[1].toFixed(2);
  const ring = (points) => "M" + points.map(at).join("L") + "Z";
  const turned = (v) => [-v[1], v[0]];
  page.path = { at, ring, turned };

  /** An arrow from tail to tip, in pixels; null if it has no length. */
  page.arrow = function (tail, tip, name, attributes, head = kHead) {
    const size = Math.hypot(tip[0] - tail[0], tip[1] - tail[1]);
    if (!(size >= 0.5)) return null;
    const along = vector.unit([tip[0] - tail[0], tip[1] - tail[1]]);
    const length = Math.min(head, 0.6 * size);
    const neck = vector.add(tip, -length, along);
    const side = turned(along).map((x) => 0.42 * length * x);
    return svg("path", {
      class: name,
      d: "M" + at(tail) + "L" + at(neck) + ring([tip, vector.add(neck, 1, side), vector.add(neck, -1, side)]),
      ...attributes,
    });
  };

  /** A round arrow about a centre. */
  page.torqueArrow = function (centre, radius, counterclockwise, name = "torque") {
    const place = (angle) => {
      const seen = counterclockwise ? angle : Math.PI - angle;
      return [centre[0] + radius * Math.cos(seen), centre[1] - radius * Math.sin(seen)];
    };
    const points = Array.from({ length: 25 }, (_, k) => place(-0.6 + (4.6 * k) / 24));
    const tip = place(4 + 6 / radius);
    const along = vector.unit(vector.add(tip, -1, points[24]));
    const side = turned(along).map((x) => 4.6 * x);
    const neck = vector.add(tip, -kHead, along);
    return svg(
      "g",
      { class: name },
      svg("path", { class: "arc", d: "M" + points.map(at).join("L") }),
      svg("path", { class: "head", d: ring([tip, vector.add(neck, 1, side), vector.add(neck, -1, side)]) }),
    );
  };

  /** What holds a contact: a short hatched line behind it. `inwards` has length 1, on the page. */
  page.finger = function (place, inwards) {
    const along = turned(inwards);
    const base = vector.add(place, -5, inwards);
    let d = "M" + at(vector.add(base, -13, along)) + "L" + at(vector.add(base, 13, along));
    for (let i = -2; i <= 2; ++i) {
      const from = vector.add(base, 5 * i + 2, along);
      d += "M" + at(from) + "L" + at(vector.add(vector.add(from, -6, inwards), -4, along));
    }
    return svg("path", { class: "finger", d });
  };

  /** The sign of what a contact does; `tangent` has length 1, on the page. */
  page.mark = function (place, tangent, name, attributes) {
    const [x, y] = place;
    const triangle = (forwards) => {
      const side = turned(forwards).map((c) => 6 * c);
      const back = vector.add(place, -4.5, forwards);
      return ring([vector.add(place, 8, forwards), vector.add(back, 1, side), vector.add(back, -1, side)]);
    };
    const circle = (r) =>
      "M" + at([x - r, y]) + "a" + r + " " + r + " 0 1 1 " + 2 * r + " 0a" + r + " " + r + " 0 1 1 " + -2 * r + " 0Z";
    const shapes = {
      none: () => circle(3.2),
      stick: () => circle(5),
      open: () => circle(4.6),
      plus: () => triangle(tangent),
      minus: () => triangle(tangent.map((c) => -c)),
      slip: () =>
        ring([
          [x + 5, y + 5],
          [x - 5, y + 5],
          [x - 5, y - 5],
          [x + 5, y - 5],
        ]),
      loses: () =>
        ring([
          [x + 7, y],
          [x, y + 7],
          [x - 7, y],
          [x, y - 7],
        ]),
    };
    shapes.idle = shapes.loses;
    const hollow = name === "minus" || name === "open" || name === "idle";
    return svg("path", { class: hollow ? "hollow" : "full", d: shapes[name](), ...attributes });
  };

  /** A drawing of its own, in pixels from the upper left corner. */
  page.picture = (width, height, attributes, ...content) =>
    svg("svg", { class: "stickslip", width, height, viewBox: "0 0 " + width + " " + height, ...attributes }, ...content);

  /** A small drawing of one sign, for tables and legends. */
  page.sign = (draw, width = 26, height = 18) =>
    page.picture(width, height, { class: "sign", "aria-hidden": "true" }, draw);
  page.markSign = (name) => page.sign(page.mark([13, 9], [1, 0], name));

  /** The convex hull of points of the plane: Andrew's monotone chain. */
  page.hull = function (points) {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const hull = [];
    for (let half = 0; half < 2; ++half, sorted.reverse()) {
      const start = hull.length;
      for (const p of sorted) {
        const left = () => {
          const [a, b] = hull.slice(-2);
          return (b[0] - a[0]) * (p[1] - b[1]) - (b[1] - a[1]) * (p[0] - b[0]) > 0;
        };
        while (hull.length >= start + 2 && !left()) hull.pop();
        hull.push(p);
      }
      hull.pop();
    }
    return hull;
  };

  /** Round values from low to high, at most so many. */
  page.ticks = function (low, high, most) {
    const least = (high - low) / Math.max(1, most);
    let step = page.roundDown(least);
    if (step < least * 0.999) step = page.roundDown(step * 2.5 * 1.0001);
    while ((high - low) / step > most) step *= 2;
    const values = [];
    for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
      values.push(page.clean(k * step, step));
    return values;
  };

  // Of several bodies, in words of legends.
  page.forceWords = () => (page.mechanism() ? "contact force, on the body that is pressed" : "contact force");
  page.torqueWords = (name) => (name === undefined ? "torque " : "torque on " + name + " ");
  page.linkLegend = function () {
    const links = page.bodies().flatMap(({ link }) => (link ? [link.slides] : []));
    return [
      links.includes(false) && { drawing: page.sign(svg("circle", { class: "hinge", cx: 13, cy: 9, r: 5 })), text: "hinge" },
      links.includes(true) && { drawing: page.sign(svg("path", { class: "slide", d: "M1 9h24" })), text: "slide" },
    ];
  };

  /** A drawing as wide as its place on the page, so that texts keep their size. */
  page.canvasWidth = (id, most) => Math.max(240, Math.min(most, page.find(id).clientWidth || most));

  /** Legend entries, as {drawing, text}, one after the other. */
  page.legend = (entries) =>
    page.html(
      "ul",
      { class: "legend" },
      entries.filter(Boolean).map((entry) => page.html("li", {}, entry.drawing, entry.text)),
    );
})(StickslipPage);
