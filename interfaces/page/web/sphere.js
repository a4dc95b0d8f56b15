// SPDX-License-Identifier: GPL-3.0-or-later
//
// The sphere of motions, cut by a great circle for each contact: on it the contact sticks. A point is the motion
// (x, y, r) as the middle of the drawing sees it, with lengths in sizes of the grasp; that is linear in the motion, so
// circles stay circles and states stay states. It is painted point by point: the state of a point is the signs of a
// few dot products, whatever shape its cell has.
(function (page) {
  const { html, vector } = page;
  const kHues = 8;
  const kShades = 9;
  const kTurn = Math.PI / 24; // of an arrow key
  const kNear = 7; // pixels: so near to an edge or a vertex one points at it

  // The axes of the page (right, up, towards the reader) as points of the sphere. Right is -y and up is x, so that a
  // motion that turns the body counterclockwise lies where its centre of rotation lies in the drawing of the body,
  // as in pictures; a little turned, so that it is seen as a ball.
  const kHome = () =>
    turnedBy(
      turnedBy(
        [
          [0, -1, 0],
          [1, 0, 0],
          [0, 0, 1],
        ],
        0,
        0.32,
      ),
      1,
      -0.26,
    );
  let axes = null;
  let circles = []; // {normal, contacts: [[i, sign]]}: coincident ones are one
  let byState = new Map(); // from states to the number of the cell
  let prepared = null;
  let disc = { middle: 0, radius: 1 };

  /** The page's axes after the sphere is turned about its right (0) or upward (1) axis, or that towards the reader. */
  function turnedBy(from, about, angle) {
    const [j, k] = [(about + 1) % 3, (about + 2) % 3];
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    const to = [...from];
    to[j] = vector.add(
      from[j].map((x) => c * x),
      s,
      from[k],
    );
    to[k] = vector.add(
      from[k].map((x) => c * x),
      -s,
      from[j],
    );
    return to;
  }

  function toSphere(motion) {
    const { centre, radius } = page.frame();
    const [x, y] = page.displacement(centre, motion);
    return vector.unit([x / radius, y / radius, motion[2]]);
  }

  function prepare() {
    if (prepared === page.answer.states && circles.from === page.answer.contacts) return;
    prepared = page.answer.states;
    const { centre, radius } = page.frame();
    circles = [];
    circles.from = page.answer.contacts;
    page.answer.contacts.forEach((contact, i) => {
      const t = page.tangent(contact);
      const p = vector.add(contact.position, -1, centre).map((x) => x / radius);
      const normal = vector.unit([t[0], t[1], p[0] * t[1] - p[1] * t[0]]);
      const same = circles.find((c) => Math.abs(vector.dot(c.normal, normal)) > 1 - 1e-12);
      if (same) same.contacts.push([i, vector.dot(same.normal, normal) > 0 ? 1 : -1]);
      else circles.push({ normal, contacts: [[i, 1]] });
    });
    byState = new Map();
    // Antipodal cells share their states where all circles meet; the first one stands for both.
    prepared.cells.forEach((cell, k) => {
      const key = cell.states;
      if (!byState.has(key)) byState.set(key, []);
      byState.get(key).push(k);
    });
    chooseFills();
  }

  // Few faces: a colour for each antipodal pair, hatched where contact 0 slips -. Many: shaded by how many
  // contacts slip +. As `stickslip plot states`.
  let fills = { hues: new Map(), hasHues: true };
  function chooseFills() {
    const faces = prepared.cells.filter((cell) => cell.kind === "face");
    fills = { hues: new Map(), hasHues: faces.length <= 2 * kHues };
    const opposite = (states) => states.replace(/[+-]/g, (c) => (c === "+" ? "-" : "+"));
    let hue = 0;
    for (const { states } of faces) {
      if (fills.hues.has(states)) continue;
      fills.hues.set(states, { hue, hatched: states[0] === "-" });
      fills.hues.set(opposite(states), { hue, hatched: opposite(states)[0] === "-" });
      ++hue;
    }
  }

  /** The states of all contacts from the signs of the circles, as a cell spells them. */
  function spell(signs) {
    const states = Array(page.answer.contacts.length).fill("0");
    circles.forEach((circle, k) => {
      for (const [i, side] of circle.contacts) states[i] = signs[k] === 0 ? "0" : signs[k] * side > 0 ? "+" : "-";
    });
    return states.join("");
  }

  /** The cell with these states that is nearest to a point. */
  function cellOf(signs, point) {
    const found = byState.get(spell(signs)) || [];
    let best = null;
    for (const k of found) {
      const near = vector.dot(toSphere(prepared.cells[k].motion), point);
      if (!best || near > best.near) best = { k, near };
    }
    return best ? best.k : null;
  }

  const rgb = function (name) {
    const text = page.colour(name);
    return [1, 3, 5].map((k) => parseInt(text.slice(k, k + 2), 16));
  };

  // The points of the disc, painted. The signs of all circles are bits of one number, or of two where there are many.
  function paint(context, pixels) {
    const size = pixels.size;
    const image = context.createImageData(size, size);
    const data = new Uint32Array(image.data.buffer);
    const paper = rgb("paper");
    const ink = rgb("ink");
    const accent = rgb("motion");
    const chosen =
      page.shown.motion === "cell" && page.shown.cell !== null ? prepared.cells[page.shown.cell].states : null;
    const pointed =
      page.shown.pointed !== null && prepared.cells[page.shown.pointed]
        ? prepared.cells[page.shown.pointed].states
        : null;
    const colours = new Map();
    const parts = new Map(); // where each face is seen, for its label
    // A face's colour, and whether it is hatched, chosen, or pointed at; made once for each face that is seen.
    const colourOf = function (signs) {
      const states = spell(signs);
      let base;
      let hatched = false;
      if (fills.hasHues) {
        const found = fills.hues.get(states) || { hue: 0 };
        base = rgb("hue" + (found.hue % kHues));
        hatched = found.hatched;
      } else {
        const plus = [...states].filter((c) => c === "+").length;
        base = rgb("shade" + Math.floor((plus * (kShades - 1)) / states.length));
      }
      const mix = (a, b, share) => a.map((x, j) => x + share * (b[j] - x));
      if (states === chosen) base = mix(base, accent, 0.4);
      else if (states === pointed) base = mix(base, accent, 0.2);
      return [base, hatched ? mix(base, ink, 0.55) : base].map((colour) => colour.map(Math.round));
    };
    const normals = circles.map(({ normal }) => axes.map((axis) => vector.dot(axis, normal)));
    const signs = new Int8Array(circles.length);
    const [half, radius] = [size / 2, pixels.radius];
    for (let row = 0; row < size; ++row) {
      const y = (half - row - 0.5) / radius;
      let last = null;
      let part = null;
      let lastKey = "";
      for (let column = 0; column < size; ++column) {
        const x = (column + 0.5 - half) / radius;
        const square = x * x + y * y;
        if (square > 1) continue;
        const z = Math.sqrt(1 - square);
        let [low, high] = [0, 0];
        for (let k = 0; k < normals.length; ++k) {
          const n = normals[k];
          const positive = n[0] * x + n[1] * y + n[2] * z > 0;
          signs[k] = positive ? 1 : -1;
          if (positive) {
            if (k < 30) low |= 1 << k;
            else high = (high * 31 + k) % 2147483647;
          }
        }
        const key = low + high * 1073741824;
        if (key !== lastKey || last === null) {
          last = colours.get(key);
          part = parts.get(key);
          if (!last) {
            colours.set(key, (last = colourOf(signs)));
            parts.set(key, (part = { states: spell(signs), x: 0, y: 0, count: 0 }));
          }
          lastKey = key;
        }
        part.x += x;
        part.y += y;
        ++part.count;
        const stripe = (column + row) % pixels.hatch < pixels.line;
        const colour = last[stripe ? 1 : 0];
        // A little darker towards the rim, so that it is seen as a ball.
        const light = 0.86 + 0.14 * z;
        data[row * size + column] =
          0xff000000 |
          ((colour[2] * light + paper[2] * (1 - light) * 0.2) << 16) |
          ((colour[1] * light + paper[1] * (1 - light) * 0.2) << 8) |
          (colour[0] * light + paper[0] * (1 - light) * 0.2);
      }
    }
    seenFaces = [...parts.values()].map(({ states, x, y, count }) => ({
      states,
      at: [x / count, y / count],
      area: count / (Math.PI * radius * radius),
    }));
    return image;
  }
  let seenFaces = [];

  const seen = (point) => axes.map((axis) => vector.dot(axis, point));
  const placed = ([x, y]) => [disc.middle + disc.radius * x, disc.middle - disc.radius * y];

  /** Two directions that span the plane of a circle. */
  function span(normal) {
    const least = normal.map(Math.abs).indexOf(Math.min(...normal.map(Math.abs)));
    const first = vector.unit(
      vector.cross(
        normal,
        [0, 1, 2].map((j) => (j === least ? 1 : 0)),
      ),
    );
    return [first, vector.cross(normal, first)];
  }

  /** Strokes the parts of a circle that are in front and that `is` wants; it is given points of the sphere. */
  function strokeCircle(context, normal, is = null) {
    const [first, second] = span(normal);
    context.beginPath();
    let open = false;
    for (let k = 0; k <= 360; ++k) {
      const angle = (Math.PI * k) / 180;
      const point = vector.add(
        first.map((x) => x * Math.cos(angle)),
        Math.sin(angle),
        second,
      );
      const s = seen(point);
      if (s[2] < 0 || (is && !is(point))) {
        open = false;
        continue;
      }
      const [x, y] = placed(s);
      if (open) context.lineTo(x, y);
      else context.moveTo(x, y);
      open = true;
    }
    context.stroke();
  }

  function label(context, text, [x, y], font = "13px Helvetica, Arial, sans-serif") {
    context.font = font;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = 3.5;
    context.strokeStyle = page.colour("paper");
    context.strokeText(text, x, y);
    context.fillStyle = page.colour("ink");
    context.fillText(text, x, y);
  }

  function dot(context, point, radius, fill, stroke) {
    const s = seen(point);
    if (s[2] < -0.001) return;
    const [x, y] = placed(s);
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = fill;
    context.fill();
    if (stroke) {
      context.lineWidth = 2;
      context.strokeStyle = stroke;
      context.stroke();
    }
  }

  function diamond(context, point, size, fill) {
    const s = seen(point);
    if (s[2] < -0.001) return;
    const [x, y] = placed(s);
    context.beginPath();
    for (const [dx, dy] of [
      [size, 0],
      [0, size],
      [-size, 0],
      [0, -size],
    ])
      context.lineTo(x + dx, y + dy);
    context.closePath();
    context.fillStyle = fill;
    context.fill();
    context.lineWidth = 2;
    context.strokeStyle = page.colour("paper");
    context.stroke();
  }

  function onCell(states, point) {
    return circles.every((circle) => {
      const [i, side] = circle.contacts[0];
      const sign = Math.sign(vector.dot(circle.normal, point)) * side;
      const wanted = states[i] === "+" ? 1 : states[i] === "-" ? -1 : 0;
      return wanted === 0 ? Math.abs(vector.dot(circle.normal, point)) < 1e-6 : sign === wanted;
    });
  }

  function drawSphere() {
    const section = page.find("sphere-panel");
    section.hidden = page.isSpatial() || !page.answer.states;
    if (section.hidden) return;
    if (!axes) axes = kHome();
    prepare();
    const canvas = page.find("sphere");
    const side = Math.min(420, canvas.parentElement.clientWidth || 420);
    const ratio = window.devicePixelRatio || 1;
    disc = { middle: side / 2, radius: side / 2 - 26 };
    if (canvas.width !== Math.round(side * ratio)) canvas.width = canvas.height = Math.round(side * ratio);
    canvas.style.width = canvas.style.height = side + "px";
    const context = canvas.getContext("2d");
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    // While it is turned, a coarser picture is enough.
    const fine = turning ? 1 : ratio;
    const size = Math.max(2, Math.round(2 * disc.radius * fine));
    const image = paint(context, {
      size,
      radius: disc.radius * fine,
      hatch: Math.round(9 * fine),
      line: Math.max(1, Math.round(1.2 * fine)),
    });
    const sheet = drawSphere.sheet || (drawSphere.sheet = document.createElement("canvas"));
    sheet.width = sheet.height = size;
    sheet.getContext("2d").putImageData(image, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.drawImage(sheet, disc.middle - disc.radius, disc.middle - disc.radius, 2 * disc.radius, 2 * disc.radius);
    drawLines(context);
    drawLabels(context);
    canvas.setAttribute(
      "aria-label",
      "Sphere of motions. " +
        cellWords(page.shown.cell) +
        " Arrow keys turn it, Page Up and Page Down go from cell to cell, Enter chooses the cell in the middle, Home turns it back.",
    );
  }

  function drawLines(context) {
    const { cells } = prepared;
    const few = fills.hasHues;
    context.lineCap = context.lineJoin = "round";
    context.strokeStyle = page.colour("ink");
    // Translations.
    context.lineWidth = 0.9;
    context.globalAlpha = 0.6;
    context.setLineDash([1.5, 4]);
    strokeCircle(context, [0, 0, 1]);
    context.setLineDash([]);
    context.globalAlpha = 1;
    context.lineWidth = few ? 1.5 : 0.8;
    for (const circle of circles) strokeCircle(context, circle.normal);
    context.lineWidth = 1.3;
    context.beginPath();
    context.arc(disc.middle, disc.middle, disc.radius, 0, 2 * Math.PI);
    context.stroke();
    for (const cell of cells)
      if (cell.kind === "vertex") dot(context, toSphere(cell.motion), few ? 3.2 : 1.6, page.colour("ink"));
    for (const k of [page.shown.pointed, page.shown.motion === "cell" ? page.shown.cell : null]) {
      const cell = k === null ? null : cells[k];
      if (!cell) continue;
      context.strokeStyle = page.colour("motion");
      context.lineWidth = k === page.shown.cell ? 4.5 : 3;
      if (cell.kind === "edge") {
        const circle = circles.find((c) => cell.states[c.contacts[0][0]] === "0");
        if (circle) strokeCircle(context, circle.normal, (point) => onCell(cell.states, point));
      } else if (cell.kind === "face") {
        context.lineWidth = k === page.shown.cell ? 3.5 : 2;
        for (const circle of circles) {
          strokeCircle(context, circle.normal, (point) => {
            const states = [...cell.states];
            for (const [i] of circle.contacts) states[i] = "0";
            return onCell(states, point);
          });
        }
      }
    }
    if (page.shown.motion === "cell" && cells[page.shown.cell]) {
      dot(context, toSphere(cells[page.shown.cell].motion), 6, page.colour("motion"), page.colour("paper"));
    }
    if (page.shown.pointed !== null && cells[page.shown.pointed] && cells[page.shown.pointed].kind === "vertex") {
      dot(context, toSphere(cells[page.shown.pointed].motion), 6, page.colour("motion"));
    }
    const motion = page.motion();
    if (motion.kind !== "cell" && motion.twist && motion.twist.some((x) => x !== 0)) {
      diamond(context, toSphere(motion.twist), 7.5, page.colour(motion.kind === "twist" ? "virtual" : "motion"));
    }
  }

  function drawLabels(context) {
    const kPoles = [
      [[0, 0, 1], "\u21BA"],
      [[0, 0, -1], "\u21BB"],
      [[1, 0, 0], "\u2192"],
      [[0, 1, 0], "\u2191"],
      [[-1, 0, 0], "\u2190"],
      [[0, -1, 0], "\u2193"],
    ];
    const few = fills.hasHues && page.answer.contacts.length <= 8;
    const taken = [];
    for (const [point, text] of kPoles) {
      const s = seen(point);
      if (s[2] < 0.12) continue;
      const at = placed(s);
      taken.push(at);
      label(context, text, at, "bold 17px 'DejaVu Sans', sans-serif");
    }
    for (const {
      states,
      at: [x, y],
      area,
    } of few ? seenFaces : []) {
      const point = [0, 1, 2].map(
        (j) => x * axes[0][j] + y * axes[1][j] + Math.sqrt(Math.max(0, 1 - x * x - y * y)) * axes[2][j],
      );
      if (area < 0.02 || spell(circles.map((circle) => Math.sign(vector.dot(circle.normal, point)))) !== states)
        continue;
      let at = placed([x, y]);
      const meets = (other) => Math.abs(other[0] - at[0]) < 34 && Math.abs(other[1] - at[1]) < 17;
      if (taken.some(meets)) at = [at[0], at[1] + 20];
      if (taken.some(meets)) continue;
      taken.push(at);
      label(context, page.typeset(states), at, "14px 'DejaVu Sans Mono', Menlo, Consolas, monospace");
    }
    // Circles are numbered at the rim, on the side where the contact slips +.
    if (circles.length > 14) return;
    const rim = [];
    for (const circle of circles) {
      const n = seen(circle.normal);
      const flat = Math.hypot(n[0], n[1]);
      if (flat < 0.05) continue;
      for (const end of [1, -1]) {
        const out = [(-end * n[1]) / flat, (end * n[0]) / flat];
        for (const side of [1, -1]) {
          const numbers = circle.contacts.filter(([, s]) => s === side).map(([i]) => i);
          if (numbers.length === 0) continue;
          const shift = vector.add(out, (side * 0.055) / flat, n.slice(0, 2));
          const at = placed(vector.unit(shift).map((x) => x * (1 + 14 / disc.radius)));
          if (rim.some((other) => Math.hypot(other[0] - at[0], other[1] - at[1]) < 13)) continue;
          rim.push(at);
          label(
            context,
            numbers.slice(0, 2).join(",") + (numbers.length > 2 ? "\u2026" : ""),
            at,
            "12px Helvetica, Arial, sans-serif",
          );
        }
      }
    }
  }

  function cellWords(k) {
    const cell = k === null ? null : prepared.cells[k];
    return cell ? "Chosen: " + cell.kind + " " + page.typeset(cell.states) + "." : "";
  }

  /** The cell at a place of the canvas: a vertex or an edge where one is near. */
  function cellAt(x, y) {
    const [sx, sy] = [(x - disc.middle) / disc.radius, (disc.middle - y) / disc.radius];
    if (sx * sx + sy * sy > 1) return null;
    const sz = Math.sqrt(1 - sx * sx - sy * sy);
    const point = [0, 1, 2].map((j) => sx * axes[0][j] + sy * axes[1][j] + sz * axes[2][j]);
    let best = null;
    prepared.cells.forEach((cell, k) => {
      if (cell.kind !== "vertex") return;
      const s = seen(toSphere(cell.motion));
      const [px, py] = placed(s);
      const away = Math.hypot(px - x, py - y);
      if (s[2] > -0.02 && away <= kNear && (!best || away < best.away)) best = { k, away };
    });
    if (best) return best.k;
    const values = circles.map((circle) => vector.dot(circle.normal, point));
    const least = values.reduce(
      (found, value, k) => (found === null || Math.abs(value) < Math.abs(values[found]) ? k : found),
      null,
    );
    const signs = values.map(Math.sign);
    if (least !== null && Math.abs(values[least]) * disc.radius <= 0.7 * kNear * Math.max(0.25, sz)) {
      const onEdge = signs.map((sign, k) => (k === least ? 0 : sign));
      const edge = cellOf(onEdge, point);
      if (edge !== null) return edge;
    }
    return cellOf(signs, point);
  }

  page.chooseCell = (k) => page.show(k === null ? { cell: null, motion: "equilibrium" } : { cell: k, motion: "cell" });

  let turning = false;
  function turn(about, angle) {
    axes = turnedBy(axes, about, angle);
    drawSphere();
  }

  /** Turns the sphere until a cell is in front, if it is behind. */
  function bringToFront(k) {
    const point = toSphere(prepared.cells[k].motion);
    const s = seen(point);
    if (s[2] > 0.25) return;
    axes = turnedBy(axes, 1, -Math.atan2(s[0], s[2]));
    const again = seen(point);
    axes = turnedBy(axes, 0, Math.atan2(again[1], again[2]) * 0.85);
  }

  function step(by) {
    const count = prepared.cells.length;
    const from = page.shown.cell === null ? (by > 0 ? -1 : 0) : page.shown.cell;
    const k = (from + by + count) % count;
    bringToFront(k);
    page.chooseCell(k);
  }

  page.listenToSphere = function () {
    const canvas = page.find("sphere");
    let from = null;
    let moved = 0;
    const place = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    const hover = function (k) {
      if (k === page.shown.pointed) return;
      page.shown.pointed = k;
      page.put(
        "sphere-hover",
        k === null
          ? null
          : html(
              "span",
              {},
              prepared.cells[k].kind + " ",
              html("code", { class: "state" }, page.typeset(prepared.cells[k].states)),
            ),
      );
      page.find("sphere-hover").hidden = false;
      drawSphere();
      // In one column what is drawn above would push the sphere away from under the pointer.
      if (!matchMedia("(max-width: 820px)").matches) {
        page.drawBody();
        page.drawMotionWords();
      }
    };
    canvas.addEventListener("pointerdown", (event) => {
      from = place(event);
      moved = 0;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      const at = place(event);
      if (!from) return hover(cellAt(...at));
      const [dx, dy] = [at[0] - from[0], at[1] - from[1]];
      moved += Math.hypot(dx, dy);
      from = at;
      if (moved < 4) return;
      turning = true;
      page.shown.pointed = null;
      axes = turnedBy(turnedBy(axes, 1, -dx / disc.radius), 0, -dy / disc.radius);
      drawSphere();
    });
    const end = function (event) {
      if (from && moved < 4 && event.type === "pointerup") {
        const k = cellAt(...place(event));
        if (k !== null) page.chooseCell(k === page.shown.cell && page.shown.motion === "cell" ? null : k);
      }
      from = null;
      if (turning) {
        turning = false;
        drawSphere();
      }
    };
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
    canvas.addEventListener("pointerleave", () => hover(null));
    canvas.addEventListener("keydown", (event) => {
      const kKeys = {
        ArrowLeft: () => turn(1, kTurn),
        ArrowRight: () => turn(1, -kTurn),
        ArrowUp: () => turn(0, kTurn),
        ArrowDown: () => turn(0, -kTurn),
        PageDown: () => step(1),
        PageUp: () => step(-1),
        Enter: () => page.chooseCell(cellAt(disc.middle, disc.middle)),
        " ": () => page.chooseCell(cellAt(disc.middle, disc.middle)),
        Escape: () => page.chooseCell(null),
        Home: () => {
          axes = kHome();
          drawSphere();
        },
      };
      if (!kKeys[event.key]) return;
      kKeys[event.key]();
      event.preventDefault();
    });
  };

  /** The way the sphere is turned, for tests: its axes, and where a motion is on the canvas, or null if behind. */
  page.sphereState = () => ({ axes, cell: page.shown.cell });
  page.sphereCell = (x, y) => cellAt(x, y);
  page.spherePlace = function (motion) {
    const s = seen(toSphere(motion));
    return s[2] < 0 ? null : placed(s);
  };

  // The list of cells: for the keyboard, for screen readers, and to find a state.
  let listed = null;
  function drawList() {
    const { answer, shown } = page;
    if (page.isSpatial() || !answer.states) return;
    const select = page.find("cell-list");
    if (listed !== answer.states) {
      listed = answer.states;
      const { cells } = listed;
      const group = (kind, name) =>
        html(
          "optgroup",
          { label: name },
          cells.map((cell, k) =>
            cell.kind === kind ? html("option", { value: String(k) }, page.typeset(cell.states)) : null,
          ),
        );
      select.replaceChildren(
        html("option", { value: "" }, "none"),
        group("face", "faces"),
        group("edge", "edges"),
        group("vertex", "vertices"),
      );
      const n = (kind) => cells.filter((cell) => cell.kind === kind).length;
      page.put(
        "sphere-count",
        page.count(answer.contacts.length, "contact") +
          " on " +
          page.count((listed.circles || circles).length, "circle") +
          ": " +
          page.count(n("face"), "face") +
          ", " +
          page.count(n("edge"), "edge") +
          ", " +
          page.count(n("vertex"), "vertex", "vertices") +
          ".",
      );
    }
    select.value = shown.motion === "cell" && shown.cell !== null ? String(shown.cell) : "";
    page.put("sphere-legend", legend());
  }

  function legend() {
    const { svg } = page;
    const motion = page.motion();
    const box = (name) => page.sign(svg("rect", { class: name, x: 2, y: 2, width: 22, height: 14 }));
    return page.legend([
      fills.hasHues
        ? {
            drawing: page.sign([
              svg("rect", { class: "hue0", x: 2, y: 2, width: 11, height: 14 }),
              svg("rect", { class: "hue1", x: 13, y: 2, width: 11, height: 14 }),
            ]),
            text: "face: all contacts slip; one colour for opposite states",
          }
        : { drawing: box("shade6"), text: "face: the darker, the more contacts slip +" },
      fills.hasHues &&
        page.answer.contacts.length > 0 && {
          drawing: page.sign([
            svg("rect", { class: "hue0", x: 2, y: 2, width: 22, height: 14 }),
            svg("path", { class: "hatching", d: "M6 16L20 2M2 11L11 2M15 16L24 7" }),
          ]),
          text: "contact 0 slips \u2212",
        },
      {
        drawing: page.sign(svg("path", { class: "edge", d: "M2 14Q12 2 24 6" })),
        text: "circle: its contact sticks; its number is where it slips +",
      },
      { drawing: page.sign(svg("path", { class: "ring", d: "M2 14Q12 2 24 6" })), text: "translations" },
      motion.kind !== "cell" &&
        motion.twist &&
        motion.twist.some((x) => x !== 0) && {
          drawing: page.sign(
            svg("path", { class: motion.kind === "twist" ? "virtual" : "motion", d: "M13 2L20 9L13 16L6 9Z" }),
          ),
          text: motion.kind === "twist" ? "virtual twist" : "motion of the equilibrium",
        },
    ]);
  }

  page.listenToCells = function () {
    page.find("cell-list").addEventListener("change", (event) => {
      const k = event.target.value === "" ? null : Number(event.target.value);
      if (k !== null) bringToFront(k);
      page.chooseCell(k);
    });
    page.find("cell-before").addEventListener("click", () => step(-1));
    page.find("cell-after").addEventListener("click", () => step(1));
  };

  page.views.push(drawSphere, drawList);
})(StickslipPage);
