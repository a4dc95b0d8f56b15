// SPDX-License-Identifier: GPL-3.0-or-later
//
// How much is resisted: the region of a plane of loads, the multiples of the present load, and the map over friction and load.
(function (page) {
  const { svg, html, path } = page;

  /** An SVG pattern for what does not hold; the id is one for each drawing. */
  const hatching = (id, name) =>
    svg(
      "defs",
      {},
      svg(
        "pattern",
        { id, width: 8, height: 8, patternUnits: "userSpaceOnUse" },
        svg("rect", { class: name, width: 8, height: 8 }),
        svg("path", { class: "hatching", d: "M-1 1L1 -1M0 8L8 0M7 9L9 7" }),
      ),
    );

  // The region.

  /** A load, the present one, in the coordinates of the plane; whether it is inside. */
  function loadInPlane(region, load = page.load()) {
    if (!load) return null;
    const { origin_float: o, u_float: u, v_float: v } = region.plane;
    const d = load.map((x, j) => x - o[j]);
    const dot = page.vector.dot;
    const [uu, uv, vv] = [dot(u, u), dot(u, v), dot(v, v)];
    const determinant = uu * vv - uv * uv;
    const s = (dot(d, u) * vv - dot(d, v) * uv) / determinant;
    const t = (dot(d, v) * uu - dot(d, u) * uv) / determinant;
    const off = Math.hypot(...d.map((x, j) => x - s * u[j] - t * v[j]));
    return { s, t, inside: off <= 1e-9 * Math.max(1, ...load.map(Math.abs)) };
  }

  const isAxis = (v, j) => v.every((x, k) => Number(x) === (k === j ? 1 : 0));
  function axisName(v, letter) {
    const units = page.unitsOf();
    const names =
      v.length === 3
        ? ["force along x", "force along y", "torque"]
        : ["x", "y", "z"].map((axis) => "force along " + axis).concat(["x", "y", "z"].map((axis) => "torque about " + axis));
    const j = names.findIndex((_, k) => isAxis(v, k));
    if (j < 0) return letter + " " + page.tuple(v);
    const unit = units && (names[j].startsWith("force") ? units.force : units.force + " " + units.length);
    return names[j] + (unit ? " /" + unit : "");
  }

  // Balls of loads around the present one, which planes cut in ellipses: discs about the origin.

  /** The norm of a load, squared: of its force, and of its torque at the ball's point over the ball's length. */
  function squaredNorm({ length, about }, load) {
    const number = (x) => page.Fraction.of(x).toNumber();
    const planar = load.length === 3;
    const c = (about || [0, 0, 0]).map(number);
    const [f, torque] = planar
      ? [[load[0], load[1], 0], [0, 0, load[2]]]
      : [load.slice(0, 3), load.slice(3)];
    const [x, y, z] = planar ? [c[0], c[1], 0] : c;
    const t = [torque[0] - y * f[2] + z * f[1], torque[1] - z * f[0] + x * f[2], torque[2] - x * f[1] + y * f[0]];
    return page.vector.dot(f, f) + page.vector.dot(t, t) / number(length) ** 2;
  }

  /** What there is of balls: radii and looks, first the one that is asked about. */
  function ballsShown() {
    const { quality, decide } = page.answer;
    const asked = decide && decide.ball;
    const balls = [];
    const add = (ball, radius, name, text) => {
      if (radius !== null && radius !== undefined && Number(page.Fraction.of(radius).toNumber()) > 0) balls.push({ ball, radius, name, text });
    };
    if (asked) add(asked, asked.radius, "ball asked", "the ball that is asked about");
    if (quality && quality.verdict === "stable") {
      add(quality.ball, quality.proved, "ball proved", "a ball of loads that are resisted, by one proof");
      add(quality.ball, quality.refuted, "ball refuted", "one in which some load is not");
    }
    return balls;
  }

  /** The ellipse in which the plane cuts the ball, as points (s, t). */
  function ballOutline({ ball, radius }, region, centre) {
    const { u_float: u, v_float: v } = region.plane;
    const r = page.Fraction.of(radius).toNumber();
    return Array.from({ length: 96 }, (_, k) => {
      const [a, b] = [Math.cos((k * Math.PI) / 48), Math.sin((k * Math.PI) / 48)];
      const far = r / Math.sqrt(squaredNorm(ball, u.map((x, j) => a * x + b * v[j])));
      return [centre.s + far * a, centre.t + far * b];
    });
  }

  /** Of balls and of the load that is not resisted, in a plane that has the present load. */
  function drawBalls(region, load, place, clip) {
    if (!load || !load.inside) return null;
    const { quality } = page.answer;
    const lost = quality && quality.not_resisted_float && loadInPlane(region, quality.not_resisted_float);
    const [x, y] = lost ? place([lost.s, lost.t]) : [0, 0];
    return svg(
      "g",
      { "clip-path": "url(#" + clip + ")" },
      ballsShown().map((shown) =>
        svg("path", { class: shown.name, "data-radius": shown.radius, d: path.ring(ballOutline(shown, region, load).map(place)) }),
      ),
      lost && lost.inside ? svg("circle", { class: "lost", cx: x, cy: y, r: 5 }) : null,
    );
  }

  /** The region around the present load, as near as balls of loads need: beside all that is resisted they may be small. */
  function drawNearLoad() {
    const { region } = page.answer;
    const load = region && region.areas && loadInPlane(region);
    const half = 2 * Math.max(0, ...ballsShown().map(({ radius }) => page.Fraction.of(radius).toNumber()));
    if (!load || !load.inside || half === 0) return void page.put("quality-picture");
    const width = page.canvasWidth("quality-picture", 320);
    const [left, right, top, bottom] = [58, 12, 12, 46];
    const side = width - left - right;
    const scale = side / 2 / half;
    const middle = [left + side / 2, top + side / 2];
    const place = ([s, t]) => [middle[0] + scale * (s - load.s), middle[1] - scale * (t - load.t)];
    const window_ = { x: left, y: top, width: side, height: side };
    const far = 8 * (half + Math.hypot(load.s, load.t));
    const most = Math.max(far, ...region.areas.flatMap((area) => area.outlines.flatMap((o) => o.vertices_float.flat().map(Math.abs))));
    const ticks = (at) => page.ticks(at - half, at + half, Math.max(4, Math.floor(side / 62)));
    page.put(
      "quality-picture",
      page.picture(
        width,
        side + top + bottom,
        { role: "img", "aria-label": "Balls of loads around the present one, and which loads near it are resisted" },
        svg("clipPath", { id: "near-window" }, svg("rect", window_)),
        svg("rect", { class: region.whole_plane ? "hue0" : "paper", ...window_ }),
        svg(
          "g",
          { "clip-path": "url(#near-window)" },
          region.areas.map((area) =>
            svg("path", { class: "area hue0", "fill-rule": "evenodd", d: areaPath(area.outlines, place, most) }),
          ),
        ),
        ticks(load.s).map((value) => [
          svg("path", { class: "grid-line", d: "M" + path.at([place([value, 0])[0], top]) + "v" + side }),
          svg("text", { class: "small middle", x: place([value, 0])[0], y: top + side + 16 }, page.near(value, 3)),
        ]),
        ticks(load.t).map((value) => [
          svg("path", { class: "grid-line", d: "M" + path.at([left, place([0, value])[1]]) + "h" + side }),
          svg("text", { class: "small end", x: left - 6, y: place([0, value])[1] + 4 }, page.near(value, 3)),
        ]),
        svg("rect", { class: "frame", ...window_ }),
        drawBalls(region, load, place, "near-window"),
        svg("circle", { class: "full", cx: middle[0], cy: middle[1], r: 2.5 }, svg("title", {}, "the present load")),
        svg("text", { class: "middle", x: middle[0], y: side + top + bottom - 10 }, axisName(region.plane.u, "s")),
        svg("text", { class: "middle", transform: "translate(14 " + middle[1] + ") rotate(-90)" }, axisName(region.plane.v, "t")),
      ),
    );
  }

  const ballLegend = (load) =>
    load && load.inside
      ? ballsShown().map(({ name, text, radius }) => ({
          drawing: page.sign(svg("circle", { class: name, cx: 13, cy: 9, r: 7 })),
          text: [text + ": radius ", page.number(radius)],
        }))
      : [];

  let regionView = null;
  page.regionView = () => regionView;

  function areaPath(outlines, place, far) {
    // What has no end goes on far outside of the window, and then around it, with the area to the left.
    const open = outlines.filter((outline) => !outline.closed);
    let d = outlines
      .filter((outline) => outline.closed)
      .map((outline) => path.ring(outline.vertices_float.map(place)))
      .join("");
    const angle = (v) => Math.atan2(v[1], v[0]);
    const left = new Set(open);
    while (left.size > 0) {
      const first = [...left][0];
      const points = [];
      for (let outline = first; left.delete(outline);) {
        const from = page.vector.unit(outline.from_float);
        const to = page.vector.unit(outline.to_float);
        const v = outline.vertices_float.length > 0 ? outline.vertices_float : [[0, 0]];
        points.push(page.vector.add(v[0], far, from), ...v, page.vector.add(v[v.length - 1], far, to));
        let next = null;
        for (const other of open) {
          const by =
            (((angle(other.from_float) - angle(outline.to_float)) % (2 * Math.PI)) + 2 * Math.PI) % (2 * Math.PI);
          if (!next || by < next.by) next = { outline: other, by };
        }
        for (let k = 1; k < 12; ++k) {
          const a = angle(outline.to_float) + (next.by * k) / 12;
          points.push([3 * far * Math.cos(a), 3 * far * Math.sin(a)]);
        }
        outline = next.outline;
      }
      d += path.ring(points.map(place));
    }
    return d;
  }

  function drawRegion() {
    const { region } = page.answer;
    regionView = null;
    page.find("region-panel").hidden = !region;
    if (!region) return;
    if (region.cells) return drawRegionInCells(region);
    if (region.limit) return void page.put("region", html("p", {}, "No region is known: " + region.limit + (region.remedy ? "; " + region.remedy : "") + "."));
    const load = loadInPlane(region);
    const corners = [
      ...region.areas.flatMap((area) => area.outlines.flatMap((o) => o.vertices_float)),
      ...region.curves.flatMap((curve) => curve.vertices_float),
      ...(region.points_float || []),
    ];
    let half = Math.max(
      ...corners.flat().map(Math.abs),
      load && load.inside ? Math.max(Math.abs(load.s), Math.abs(load.t)) / 1.25 : 0,
      0,
    );
    // While the load is dragged, the window stays.
    half = page.keepHalf || (half > 0 ? half * 1.6 : 2);
    const width = page.canvasWidth("region", 460);
    const [left, right, top, bottom] = [58, 12, 12, 46];
    const side = width - left - right;
    const height = side + top + bottom;
    const middle = [left + side / 2, top + side / 2];
    const scale = side / 2 / half;
    const place = ([s, t]) => [middle[0] + scale * s, middle[1] - scale * t];
    regionView = {
      place,
      scale,
      middle,
      half,
      plane: region.plane,
      unplace: ([x, y]) => [(x - middle[0]) / scale, (middle[1] - y) / scale],
    };
    const window_ = { x: left, y: top, width: side, height: side };
    const borders = []; // lists of points
    const far = 8 * half;
    for (const outline of region.areas.flatMap((area) => area.outlines)) {
      const v = outline.vertices_float;
      const points = outline.closed
        ? [...v, v[0]]
        : [
            page.vector.add(v[0], far, page.vector.unit(outline.from_float)),
            ...v,
            page.vector.add(v[v.length - 1], far, page.vector.unit(outline.to_float)),
          ];
      borders.push(points.map(place));
    }
    for (const curve of region.curves) {
      const rays = curve.rays_float || [];
      const v = curve.vertices_float;
      const ends = rays.map((ray, k) =>
        page.vector.add(v[k === 0 ? 0 : v.length - 1] || [0, 0], far, page.vector.unit(ray)),
      );
      const points = ends.length === 2 ? [ends[0], ...v, ends[1]] : [...v, ...ends];
      borders.push(points.map(place));
    }
    const values = page.ticks(-half, half, Math.max(4, Math.floor(side / 62)));
    const grid = values.map((value) => {
      const [x, y] = place([value, value]);
      const name = value === 0 ? "axis-line" : "grid-line";
      return [
        svg("path", { class: name, d: "M" + path.at([x, top]) + "v" + side }),
        svg("path", { class: name, d: "M" + path.at([left, y]) + "h" + side }),
        svg("text", { class: "small middle", x, y: top + side + 16 }, page.near(value, 3)),
        svg("text", { class: "small end", x: left - 6, y: y + 4 }, page.near(value, 3)),
      ];
    });
    const everything = region.whole_plane ? svg("rect", { class: "area hue0", ...window_ }) : null;
    const picture = page.picture(
      width,
      height,
      { role: "img", "aria-label": "Region of resistible loads. " + regionWords(region, load) },
      svg("clipPath", { id: "region-window" }, svg("rect", window_)),
      svg("rect", { class: "paper", ...window_ }),
      everything,
      svg(
        "g",
        { "clip-path": "url(#region-window)" },
        region.areas.map((area) =>
          svg("path", { class: "area hue0", "fill-rule": "evenodd", d: areaPath(area.outlines, place, far) }),
        ),
      ),
      grid,
      svg(
        "g",
        { "clip-path": "url(#region-window)" },
        svg("path", { class: "border", d: borders.map((line) => "M" + line.map(path.at).join("L")).join("") || "M0 0" }),
        (region.points_float || []).map((p) =>
          svg("circle", { class: "full", cx: place(p)[0], cy: place(p)[1], r: 4.5 }),
        ),
        corners.length <= 12
          ? corners.map((p) => svg("circle", { class: "full", cx: place(p)[0], cy: place(p)[1], r: 3 }))
          : null,
        corners.length <= 8 ? cornerLabels(region, place, window_, borders, load) : null,
      ),
      svg("rect", { class: "frame", ...window_ }),
      drawBalls(region, load, place, "region-window"),
      load ? loadMark(load, place) : null,
      load && page.regionHandle ? page.regionHandle(place([load.s, load.t]), region) : null,
      svg("text", { class: "middle", x: middle[0], y: height - 10 }, axisName(region.plane.u, "s")),
      svg(
        "text",
        { class: "middle", transform: "translate(14 " + middle[1] + ") rotate(-90)" },
        axisName(region.plane.v, "t"),
      ),
    );
    page.put("region", picture);
    page.put(
      "region-note",
      html("p", {}, regionWords(region, load)),
      ballLegend(load).length > 0 ? page.legend(ballLegend(load)) : null,
      region.plane.origin.some((x) => page.Fraction.of(x).sign() !== 0)
        ? html("p", { class: "muted" }, "Wrench at (0, 0): ", page.numbers(region.plane.origin), ".")
        : null,
    );
  }

  const kLetters = document.createElement("canvas").getContext("2d");
  function textWidth(text) {
    kLetters.font = "13px " + getComputedStyle(document.body).fontFamily;
    return kLetters.measureText(text).width;
  }

  /** Whether a line from a to b runs through a box {x, y, width, height}: the part of it within, along each axis. */
  function crosses(a, b, box) {
    let [begin, end] = [0, 1];
    for (const [from, step, low, size] of [
      [a[0], b[0] - a[0], box.x, box.width],
      [a[1], b[1] - a[1], box.y, box.height],
    ]) {
      if (step === 0) {
        if (from <= low || from >= low + size) return false;
        continue;
      }
      const cuts = [(low - from) / step, (low + size - from) / step];
      begin = Math.max(begin, Math.min(...cuts));
      end = Math.min(end, Math.max(...cuts));
    }
    return begin < end;
  }

  /** Labels of corners where they have room: they cover neither borders, corners and the load nor each other. */
  function cornerLabels(region, place, window_, borders, load) {
    const exact = [
      ...region.areas.flatMap((area) => area.outlines.flatMap((o) => o.vertices)),
      ...region.curves.flatMap((curve) => curve.vertices),
    ];
    const kHigh = 16;
    const texts = page.pointLabels(exact);
    const at = exact.map((corner) => place(corner.map((c) => page.Fraction.of(c).toNumber())));
    const around = ([x, y], size) => ({ x: x - size, y: y - size, width: 2 * size, height: 2 * size });
    const taken = [...at.map((p) => around(p, 4)), ...(load ? [around(place([load.s, load.t]), 8)] : [])];
    const lines = load && load.inside ? [...borders, [place([0, 0]), place([load.s, load.t])]] : borders;
    const meet = (a, b) =>
      a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    const isFree = (box) =>
      box.x >= window_.x &&
      box.y >= window_.y &&
      box.x + box.width <= window_.x + window_.width &&
      box.y + box.height <= window_.y + window_.height &&
      !taken.some((other) => meet(other, box)) &&
      !lines.some((line) => line.some((p, k) => k > 0 && crosses(line[k - 1], p, box)));
    return at.map(([x, y], k) => {
      const width = textWidth(texts[k]) + 4;
      const away = y > window_.y + window_.height / 2 + 4 ? 1 : -1; // from the middle
      const beside = width / 2 - 8;
      const places = [7, 12].flatMap((gap) =>
        [
          [0, away],
          [beside, away],
          [-beside, away],
          [gap + width / 2, 0],
          [-gap - width / 2, 0],
          [beside, -away],
          [-beside, -away],
          [width / 2 + 3, -away],
          [-width / 2 - 3, -away],
        ].map(([right, down]) => ({
          x: x + right - width / 2,
          y: y + down * (gap + kHigh / 2) - kHigh / 2,
          width,
          height: kHigh,
        })),
      );
      const box = places.find(isFree);
      if (!box) return null;
      taken.push(box);
      return svg("text", { class: "halo middle", x: box.x + width / 2, y: box.y + 12.5 }, texts[k]);
    });
  }

  function loadMark(load, place) {
    const [x, y] = place([load.s, load.t]);
    const [ox, oy] = place([0, 0]);
    return svg(
      "g",
      { class: "present", "data-load": load.s + "," + load.t },
      load.inside ? page.arrow([ox, oy], [x, y], "load") : null,
      svg(
        "path",
        {
          class: load.inside ? "here" : "here outside",
          d: path.ring([
            [x + 7, y],
            [x, y + 7],
            [x - 7, y],
            [x, y - 7],
          ]),
        },
        svg("title", {}, "the present load"),
      ),
    );
  }

  function regionWords(region, load) {
    const text = region.empty
      ? "No load of this plane is resisted."
      : region.whole_plane
        ? "Every load of this plane is resisted."
        : "Shaded: resisted, borders included; what reaches the frame may go on without end.";
    if (!load) return text;
    return (
      text +
      (load.inside ? " Diamond: the present load." : " The present load has another torque; the diamond is its force.")
    );
  }

  // The margin.

  /** "[0, 2] and [3, \u221E)", with all digits if asked for. */
  page.marginText = function (all = false) {
    const text = all ? page.typeset : page.text;
    const intervals = page.answer.margin.resisted.map(
      ([low, high]) => "[" + text(low) + ", " + (high === null ? "\u221E)" : text(high) + "]"),
    );
    return intervals.join(" and ") || "none";
  };

  /**
   * What is neither resisted nor refuted, [low, high] from low to high. An exact margin leaves nothing; else ends are known
   * nearly, and nothing is known very near them.
   */
  function unknownMultiples({ resisted, refuted }) {
    if (!refuted) return [];
    const number = page.Fraction.of;
    const above = (a, b) => number(a).minus(number(b)).sign() > 0;
    const beyond = (a, b) => (a === null ? b !== null : b !== null && above(a, b)); // null: without end
    // One multiple may be resisted alone, at which what is refuted begins.
    const known = [...resisted, ...refuted].sort((a, b) =>
      above(a[0], b[0]) || (a[0] === b[0] && beyond(a[1], b[1])) ? 1 : -1,
    );
    const unknown = [];
    let end = "0";
    for (const [low, high] of known) {
      if (above(low, end)) unknown.push([end, low]);
      end = high;
    }
    return end === null ? unknown : [...unknown, [end, null]];
  }

  function drawMargin() {
    const { margin } = page.answer;
    page.find("margin-panel").hidden = !margin;
    if (!margin) return;
    const doubles = (intervals) =>
      intervals.map((interval) => interval.map((end) => (end === null ? null : page.Fraction.of(end).toNumber())));
    const resisted = doubles(margin.resisted);
    const refuted = doubles(margin.refuted || []);
    const unknown = doubles(unknownMultiples(margin));
    const width = page.canvasWidth("margin", 460);
    const [left, right, height] = [14, 30, 96];
    const finite = [...resisted, ...refuted].flat().filter((x) => x !== null);
    const high = 1.25 * Math.max(1, ...finite.filter((x) => x < 1e6));
    const scale = (width - left - right) / high;
    const x = (value) => left + scale * (value === null ? high : Math.min(value, high));
    const kLeast = { resisted: 2, unresisted: 0, unknown: 4 }; // pixels: what is narrower is drawn so wide, about its middle
    const bar = ([low, top], kind, attributes) => {
      const [from, to] = [x(low), top === null ? x(null) + 10 : x(top)];
      const wide = Math.max(kLeast[kind], to - from);
      const begin = Math.max(left, Math.min((from + to - wide) / 2, x(null) + 10 - wide));
      return svg("rect", { "data-multiples": kind, x: begin, y: 30, height: 22, width: wide, ...attributes });
    };
    const hatched = { style: "fill: url(#margin-hatch)" };
    const labels = [];
    const kRow = 15;
    margin.resisted.forEach((interval, k) =>
      interval.forEach((end, j) => {
        if (end === null || (j === 1 && end === interval[0])) return;
        const at = x(resisted[k][j]);
        const text = page.label(end);
        const half = 3.6 * text.length + 3;
        let row = 0;
        while (labels.some((other) => other.row === row && Math.abs(other.at - at) < other.half + half)) ++row;
        if (row < 2) labels.push({ at, text, half, row });
      }),
    );
    const picture = page.picture(
      width,
      height,
      { role: "img", "aria-label": "Multiples of the load that are resisted: " + page.marginText() },
      hatching("margin-hatch", "hue5"),
      (margin.refuted ? refuted : [[0, null]]).map((interval) => bar(interval, "unresisted", hatched)),
      resisted.map((interval) => bar(interval, "resisted", { class: "hue0" })),
      unknown.map((interval) => bar(interval, "unknown", { class: "unknown" })),
      svg("path", { class: "frame", d: "M" + (width - right + 10) + " 30H" + left + "v22H" + (width - right + 10) }),
      svg("path", { class: "rule", d: "M" + (width - right + 13) + " 41h6m-4 -4l4 4l-4 4" }),
      labels.map(({ at, text, row }) => [
        svg("path", { class: "rule", d: "M" + at + " 48v9" }),
        svg("text", { class: "middle halo", x: Math.max(at, left + 3.4 * text.length), y: 70 + kRow * row }, text),
      ]),
      svg("path", {
        class: "here",
        d: path.ring([
          [x(1), 28],
          [x(1) - 6, 18],
          [x(1) + 6, 18],
        ]),
      }),
      svg("path", { class: "rule", d: "M" + x(1) + " 28v26" }),
      svg("text", { class: "middle", x: x(1), y: 13 }, "this load"),
    );
    page.put("margin", picture);
    page.put(
      "margin-note",
      marginWords(margin),
      page.legend([
        { drawing: page.sign(svg("rect", { class: "hue0", x: 2, y: 2, width: 22, height: 14 })), text: "resisted" },
        {
          drawing: page.sign([
            svg("rect", { class: "hue5", x: 2, y: 2, width: 22, height: 14 }),
            svg("path", { class: "hatching", d: "M6 16L20 2M2 11L11 2M15 16L24 7" }),
          ]),
          text: "not resisted",
        },
        unknown.length > 0 && {
          drawing: page.sign(svg("rect", { class: "unknown", x: 2, y: 2, width: 22, height: 14 })),
          text: "not known",
        },
      ]),
    );
  }

  /** What is resisted, what of it is this load, and what is not known. */
  function marginWords(margin) {
    const unknown = unknownMultiples(margin);
    const sign = (end, value) => page.Fraction.of(end).minus(page.Fraction.of(value)).sign();
    const holds = margin.resisted.find(([low, high]) => sign(low, 1) <= 0 && (high === null || sign(high, 1) >= 0));
    const below = margin.resisted.filter(([, high]) => high !== null && sign(high, 1) < 0).pop();
    // Where nothing is known from an end on, more may be resisted.
    const least = (end) => unknown.some(([low]) => sign(low, end) === 0);
    const lines = [
      html(
        "p",
        {},
        "Resisted multiples \u03BB of the load: ",
        html("strong", {}, margin.resisted.length === 0 && unknown.length > 0 ? "none is known" : page.marginText()),
        ". ",
        holds && holds[1] === null ? "It may grow without end. " : "",
        holds && holds[1] !== null && sign(holds[1], 1) > 0
          ? ["The load may grow to " + (least(holds[1]) ? "at least " : ""), page.number(holds[1]), " times. "]
          : "",
        holds && holds[1] !== null && sign(holds[1], 1) === 0 && !least(holds[1])
          ? "It is on the border: no more will do. "
          : "",
        !holds && below && sign(below[1], 0) > 0 ? ["Of this load, ", page.number(below[1]), " would be resisted. "] : "",
      ),
    ];
    if (unknown.length > 0) {
      const places = unknown.map(([low, high]) =>
        high === null ? "above " + page.text(low) : "between " + page.text(low) + " and " + page.text(high),
      );
      const all = margin.resisted.length === 0 && unknown.length === 1 && unknown[0][1] === null;
      lines.push(
        html(
          "p",
          {},
          "Nothing is known of " + (all ? "any multiple" : "multiples " + places.join(", and ")) + ": ",
          "no proof was found that they are resisted, and none that they are not. ",
          margin.resisted.length > 0
            ? (page.mechanism()
                ? "Of several bodies the ends of what is resisted are found nearly, and some near them are left; "
                : page.answer.dimension === 3
                  ? "The ends of what is resisted are found nearly here, and some near them are left; "
                  : "In space what is resisted mostly ends at an irrational multiple, so some near it are left; ") +
                "a part too narrow to be seen is drawn wider than it is."
            : "",
        ),
      );
    }
    return lines;
  }

  // The map.

  function drawMap() {
    const { map } = page.answer;
    page.find("map-panel").hidden = !map;
    if (!map) return;
    const factors = ["friction", "load", "stiffness", "preload"];
    const name = ({ name }) => (factors.includes(name) ? name + ", times that of the file" : name);
    drawCells("map", map, {
      label: "Map: where the grasp holds, over " + map.x.name + " and " + map.y.name,
      names: [name(map.x), name(map.y)],
      words: ["stable", "unstable"],
      here: factors.includes(map.x.name) && factors.includes(map.y.name) ? [1, 1] : null,
      hereIs: "this grasp",
    });
  }

  /** Of a plane of loads in space, or where motions are bounded. */
  function drawRegionInCells(region) {
    const load = loadInPlane(region);
    const { plane } = region;
    drawCells("region", region, {
      label: "Region of resistible loads, cell by cell.",
      names: [axisName(plane.u, "s"), axisName(plane.v, "t")],
      words: ["resisted", "not resisted"],
      here: load && [load.s, load.t],
      handle: (view) => {
        regionView = { ...view, plane };
        return load && page.regionHandle ? page.regionHandle(view.place([load.s, load.t]), region) : null;
      },
      hereIs: load && load.inside ? "the present load" : "of the present load, what is in this plane",
      over: (place, clip) => drawBalls(region, load, place, clip),
      more: ballLegend(load),
      note: plane.origin.some((x) => page.Fraction.of(x).sign() !== 0)
        ? html("p", { class: "muted" }, "Wrench at (0, 0): ", page.numbers(plane.origin), ".")
        : null,
    });
  }

  /** A window of a plane in cells, each with a verdict that holds throughout; `id` is its place. */
  function drawCells(id, { x, y, cells }, { label, names, words, here, hereIs, handle = () => null, over = () => null, more = [], note = null }) {
    const number = (text) => page.Fraction.of(text).toNumber();
    const width = page.canvasWidth(id, 460);
    const [left, right, top, bottom] = [58, 12, 12, 46];
    const side = width - left - right;
    const height = side + top + bottom;
    const axis = [x, y].map(({ range }) => range.map(number));
    const place = (at) => [
      left + (side * (at[0] - axis[0][0])) / (axis[0][1] - axis[0][0]),
      top + side - (side * (at[1] - axis[1][0])) / (axis[1][1] - axis[1][0]),
    ];
    const unplace = (at) => [
      axis[0][0] + ((at[0] - left) * (axis[0][1] - axis[0][0])) / side,
      axis[1][0] + ((top + side - at[1]) * (axis[1][1] - axis[1][0])) / side,
    ];
    const paths = { stable: "", unstable: "", undecided: "", fragile: "" };
    for (const cell of cells) {
      const [x0, y0] = place([number(cell.x[0]), number(cell.y[0])]);
      const [x1, y1] = place([number(cell.x[1]), number(cell.y[1])]);
      paths[cell.verdict] +=
        "M" + path.at([x0, y0]) + "H" + x1.toFixed(2) + "V" + y1.toFixed(2) + "H" + x0.toFixed(2) + "Z";
    }
    const ticks = [0, 1].map((j) => page.ticks(axis[j][0], axis[j][1], Math.max(4, Math.floor(side / 62))));
    const isSeen = here && axis.every(([low, high], j) => low <= here[j] && here[j] <= high);
    const frame = { x: left, y: top, width: side, height: side };
    const diamond = ([x, y], size) => path.ring([[x + size, y], [x, y + size], [x - size, y], [x, y - size]]);
    const hatch = id + "-hatch";
    page.put(
      id,
      page.picture(
        width,
        height,
        { role: "img", "aria-label": label },
        hatching(hatch, "hue5"),
        svg("clipPath", { id: id + "-window" }, svg("rect", frame)),
        svg("rect", { class: "paper", ...frame }),
        svg("path", { class: "hue0", d: paths.stable, "shape-rendering": "crispEdges" }),
        svg("path", { style: "fill: url(#" + hatch + ")", d: paths.unstable, "shape-rendering": "crispEdges" }),
        svg("rect", { class: "frame", ...frame }),
        ticks[0].map((value) => [
          svg("path", { class: "axis-line", d: "M" + path.at(place([value, axis[1][0]])) + "v5" }),
          svg("text", { class: "small middle", x: place([value, 0])[0], y: top + side + 17 }, page.near(value, 3)),
        ]),
        ticks[1].map((value) => [
          svg("path", { class: "axis-line", d: "M" + path.at(place([axis[0][0], value])) + "h-5" }),
          svg("text", { class: "small end", x: left - 8, y: place([0, value])[1] + 4 }, page.near(value, 3)),
        ]),
        over(place, id + "-window"),
        isSeen
          ? svg(
              "g",
              { class: "present" },
              svg("path", { class: "here", d: diamond(place(here), 7) }, svg("title", {}, hereIs)),
            )
          : null,
        handle({ place, unplace }),
        svg("text", { class: "middle", x: left + side / 2, y: height - 10 }, names[0]),
        svg("text", { class: "middle", transform: "translate(14 " + (top + side / 2) + ") rotate(-90)" }, names[1]),
      ),
    );
    page.put(
      id + "-note",
      page.legend([
        {
          drawing: page.sign(svg("rect", { class: "hue0", x: 2, y: 2, width: 22, height: 14 })),
          text: words[0] + ", proved throughout each cell",
        },
        {
          drawing: page.sign([
            svg("rect", { class: "hue5", x: 2, y: 2, width: 22, height: 14 }),
            svg("path", { class: "hatching", d: "M6 16L20 2M2 11L11 2M15 16L24 7" }),
          ]),
          text: words[1] + ", proved throughout each cell",
        },
        {
          drawing: page.sign(svg("rect", { class: "paper frame", x: 2, y: 2, width: 22, height: 14 })),
          text: "not decided in the finest cells",
        },
        isSeen && { drawing: page.sign(svg("path", { class: "here", d: diamond([13, 9], 7) })), text: hereIs },
        ...more,
      ]),
      note,
    );
  }

  page.views.push(drawRegion, drawNearLoad, drawMargin, drawMap);
})(StickslipPage);
