// SPDX-License-Identifier: GPL-3.0-or-later
//
// The body in the plane, or several: outline, contacts, cones, forces, load, and the motion that is looked at, which moves it.
(function (page) {
  const { svg, vector, path } = page;
  const kLongestForce = 0.6; // these in sizes of the grasp, as pictures draw them
  const kLongestCone = 0.7;
  const kShortestLoad = 1 / 8;
  const kEnlargedLoad = 0.6;
  const kFarPivot = 2.6;

  let view = null; // where the scene is on the page: {place, unplace, scale, frame, size}
  page.bodyView = () => view;

  /** Where there is no outline: contacts, and points a little inside of them, of which the hull stands for the body. */
  function standIn(contacts, frame) {
    const points = contacts.map((c) => c.position);
    const normals = contacts.map((c) => vector.unit(c.normal));
    contacts.forEach((c, i) => {
      for (const [inwards, along] of [
        [0.12, 0.3],
        [0.12, -0.3],
        [0.5, 0.4],
        [0.5, -0.4],
      ]) {
        const p = vector.add(
          vector.add(c.position, inwards * frame.radius, normals[i]),
          along * frame.radius,
          page.tangent(c),
        );
        if (contacts.every((o, k) => vector.dot(vector.add(p, -1, o.position), normals[k]) >= 0)) points.push(p);
      }
    });
    return points;
  }

  const kAroundHinge = 0.06;
  const ringAround = (points) => (points.length > 0 ? [page.hull(points)] : []);
  /** The rings of body b; without an outline those of a hull, of a link from hinge to hinge. */
  function ringsOf(b, frame) {
    const { outline, link } = page.bodies()[b];
    if (outline && outline.length > 0) return outline;
    const contacts = page.contactsOf(b);
    if (!link || link.slides) return ringAround(standIn(contacts, frame));
    const by = kAroundHinge * frame.radius;
    const corners = ([x, y]) => [-by, by].flatMap((dx) => [-by, by].map((dy) => [x + dx, y + dy]));
    return ringAround([...contacts.map((c) => c.position), ...page.hingesOf(b)].flatMap(corners));
  }

  /** Shorter when there are many contacts, so that cones leave room for the rest. */
  const coneSize = () => kLongestCone * Math.min(1, 2.2 / Math.sqrt(page.answer.contacts.length || 1));

  function coneEnds(contact, length) {
    const [normal, tangent] = [vector.unit(contact.normal), page.tangent(contact)];
    const half = Math.atan(contact.friction);
    return [-half, 0, half].map((angle) =>
      vector.add(vector.add(contact.position, length * Math.cos(angle), normal), length * Math.sin(angle), tangent),
    );
  }

  function makeView() {
    const { answer } = page;
    const frame = page.frame();
    const width = page.canvasWidth("body", 640);
    const bodies = page.bodies().map((_, b) => ringsOf(b, frame)); // the rings of each
    const around = 0.2 * frame.radius;
    const body = [...bodies.flat(2), ...answer.contacts.map((c) => c.position), frame.centre];
    const drawn = answer.contacts.flatMap((c) => coneEnds(c, coneSize() * frame.radius));
    const low = [0, 1].map((j) => Math.min(...body.map((p) => p[j] - around), ...drawn.map((p) => p[j])));
    const high = [0, 1].map((j) => Math.max(...body.map((p) => p[j] + around), ...drawn.map((p) => p[j])));
    const margin = 40;
    const height = Math.max(
      260,
      Math.min(width * 0.9, 520, ((width - 2 * margin) * (high[1] - low[1])) / (high[0] - low[0]) + 2 * margin),
    );
    const scale = Math.min((width - 2 * margin) / (high[0] - low[0]), (height - 2 * margin) / (high[1] - low[1]));
    const middle = [0, 1].map((j) => (low[j] + high[j]) / 2);
    const place = (p) => [width / 2 + scale * (p[0] - middle[0]), height / 2 - scale * (p[1] - middle[1])];
    const unplace = (p) => [middle[0] + (p[0] - width / 2) / scale, middle[1] - (p[1] - height / 2) / scale];
    return { place, unplace, frame, bodies, scale: scale * frame.radius, size: [width, height], forceUnit: 1 };
  }

  const onPage = (v) => [v[0], -v[1]];

  function cone(contact, length) {
    const at = view.place(contact.position);
    const normal = onPage(vector.unit(contact.normal));
    const tangent = onPage(page.tangent(contact));
    const half = Math.atan(contact.friction);
    const points = [at];
    for (let k = -12; k <= 12; ++k) {
      const angle = (half * k) / 12;
      points.push(vector.add(vector.add(at, length * Math.cos(angle), normal), length * Math.sin(angle), tangent));
    }
    return svg("path", { class: "cone", d: path.ring(points) });
  }

  // While a drag goes on, so do the scales of the drawing (page.keepView).
  page.keepView = null;

  /** Pixels for a force. */
  const forceLength = (size) => (kLongestForce * view.scale * size) / view.forceUnit;

  function chooseForceUnit() {
    const { answer } = page;
    const forces = (page.forces() || []).map((c) => c.force);
    const size = Math.max(...loads().flatMap(({ force }) => force.map(Math.abs)), 0);
    const largest = Math.max(...answer.contacts.map((c) => c.preload), ...forces.flat().map(Math.abs), size);
    view.forceUnit = largest || 1;
    view.forcePerPixel = 1 / forceLength(1);
    view.loadFactor =
      size > 0 && size < kShortestLoad * view.forceUnit ? page.roundDown((kEnlargedLoad * view.forceUnit) / size) : 1;
  }

  /** The load in doubles, of intervals the middle. */
  page.load = function () {
    if (page.answer.wrench) return page.answer.wrench;
    const wrench = page.decided() && page.decided().wrench_float;
    return wrench && !wrench.some(Array.isArray) ? wrench : null;
  };
  const loads = () =>
    page.loads(
      page.load(),
      page.actsAt(page.load(), view.frame),
      view.bodies.map((rings) => page.middleOf(rings[0] || [])),
    );

  function drawLoad({ at: point, force, torque: [torque] }) {
    const at = view.place(point);
    view.loadTip = vector.add(at, 1, onPage(force.map((x) => forceLength(view.loadFactor * x))));
    return [
      svg("path", {
        class: "frame",
        d: "M" + path.at([at[0] - 6, at[1]]) + "h12M" + path.at([at[0], at[1] - 6]) + "v12",
      }),
      page.arrow(at, view.loadTip, "load", { "data-value": force.join(",") }),
      torque !== 0 ? page.torqueArrow(at, 26, torque > 0) : null,
    ];
  }

  /** Names of several bodies, and how links are held: a ring at a hinge, a rail along a slide. */
  function drawNames() {
    if (!page.mechanism()) return [];
    return page.bodies().map(({ name, link }, b) => {
      const middle = page.middleOf(view.bodies[b][0] || (link && !link.slides ? [link.at] : []));
      if (!middle) return null;
      const [x, y] = view.place(middle);
      const held = link && !link.slides ? view.place(link.at) : [x, y];
      const along = link && link.slides ? vector.unit(onPage(link.axis)) : null;
      return [
        link && !link.slides ? svg("circle", { class: "hinge", cx: held[0], cy: held[1], r: 5, "data-body": b }) : null,
        along
          ? svg("path", {
              class: "slide",
              "data-body": b,
              d: "M" + path.at(vector.add(held, -22, along)) + "L" + path.at(vector.add(held, 22, along)),
            })
          : null,
        svg("text", { class: "small halo middle", x, y: y - 9 }, name),
      ];
    });
  }

  /** Contact numbers stand behind the fingers; those of one place share a label. */
  function drawNumbers() {
    const labels = [];
    page.answer.contacts.forEach((contact, i) => {
      const at = view.place(contact.position);
      const behind = vector.add(at, -25, onPage(vector.unit(contact.normal)));
      const near = labels.find((label) => Math.hypot(label.at[0] - behind[0], label.at[1] - behind[1]) < 12);
      if (near) near.contacts.push(i);
      else labels.push({ at: behind, contacts: [i] });
    });
    return labels.map((label) =>
      svg(
        "text",
        { class: "number halo middle", x: label.at[0], y: label.at[1] + 4.5 },
        label.contacts.length > 3 ? label.contacts.slice(0, 3).join(", ") + ", \u2026" : label.contacts.join(", "),
      ),
    );
  }

  function drawForces() {
    const forces = page.forces();
    if (!forces) return [];
    return page.answer.contacts.map((contact, i) => {
      const at = view.place(contact.position);
      return page.arrow(at, vector.add(at, 1, onPage(forces[i].force.map(forceLength))), "force", {
        "data-contact": i,
        "data-value": forces[i].force.join(","),
      });
    });
  }

  /**
   * How body b is moved by a share of the motion, as a transformation of the page. A link is carried by what it is on, and
   * then turned on its own hinge: in the first order that is its twist.
   */
  function moved(b, motion, factor) {
    const { link } = page.bodies()[b];
    if (!link || link.on === null) return transformation(page.twistOf(b, motion), factor);
    const own = vector.add(page.twistOf(b, motion), -1, page.twistOf(link.on, motion));
    return moved(link.on, motion, factor) + " " + transformation(own, factor);
  }

  function transformation(twist, factor) {
    const [ox, oy] = view.place([0, 0]);
    const scale = view.scale / view.frame.radius;
    const angle = twist[2] * factor;
    // A turn about the pivot and not the linear model, in which a turned body swells.
    const [u, v] = angle === 0 ? [1, 0] : [Math.sin(angle) / angle, (1 - Math.cos(angle)) / angle];
    const shift = [u * twist[0] - v * twist[1], v * twist[0] + u * twist[1]].map((x) => x * factor * scale);
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return "matrix(" + [c, -s, s, c, ox - c * ox - s * oy + shift[0], oy + s * ox - c * oy - shift[1]].join(" ") + ")";
  }

  function drawMotion(motion, factor) {
    if (!motion.twist || factor === 0) return [];
    const name = motion.kind === "twist" ? "virtual" : "motion";
    const arrows = page.answer.contacts.map((contact, i) => {
      const move = page.moveAt(contact, motion.twist);
      const at = view.place(contact.position);
      const scale = (view.scale / view.frame.radius) * factor;
      return page.arrow(
        at,
        vector.add(at, scale, onPage(move)),
        name,
        { "data-contact": i, "data-value": move.join(",") },
        8,
      );
    });
    return [...arrows, pivots(motion.twist).map((pivot) => drawPivot(pivot, name))];
  }

  /** About which points bodies turn that are no links. */
  const pivots = (motion) =>
    page.bodies().flatMap(({ link }, b) => (link ? [] : [page.pivot(page.twistOf(b, motion))].filter(Boolean)));

  function drawPivot(pivot, name) {
    if (Math.max(...pivot.map((x, j) => Math.abs(x - view.frame.centre[j]))) > kFarPivot * view.frame.radius) return null;
    const [x, y] = view.place(pivot);
    const [width, height] = view.size;
    if (!(x > 4 && y > 4 && x < width - 4 && y < height - 4)) return null;
    return svg(
      "g",
      { class: name + "-pivot", "data-pivot": pivot.join(",") },
      svg("title", {}, "centre of rotation"),
      svg("circle", { cx: x, cy: y, r: 8 }),
      svg("path", { d: "M" + (x - 12) + " " + y + "h24M" + x + " " + (y - 12) + "v24" }),
    );
  }

  function draw() {
    if (page.isSpatial()) return;
    // While something is dragged, the drawing keeps its scale and its place.
    view = page.keepView ? { ...page.keepView, bodies: makeView().bodies } : makeView();
    if (!page.keepView) chooseForceUnit();
    const { answer } = page;
    const [width, height] = view.size;
    const motion = page.motion();
    const factor = motion.twist ? page.enlargement(motion.twist, view.frame) : 0;
    const moves = factor > 0;
    const coneLength = coneSize() * view.scale;
    // In one path each, as some rings are holes.
    const shapes = view.bodies.map((rings) => rings.map((ring) => path.ring(ring.map(view.place))).join(""));
    const ghosts = shapes.map((body, b) =>
      svg(
        "g",
        { class: moves ? "moving" : null, "data-body": b },
        svg("path", { class: motion.kind === "twist" ? "virtual-ghost" : "ghost", d: body }),
        page.contactsOf(b).map((c) => {
          const [x, y] = view.place(c.position);
          return svg("circle", { class: "trace", cx: x, cy: y, r: 2.4 });
        }),
      ),
    );
    const resting = shapes.map((body, b) => svg("path", { class: "body", d: body, "fill-rule": "evenodd", "data-body": b }));
    const picture = page.picture(
      width,
      height,
      { role: "group", "aria-label": "Drawing of the body: " + page.verdictWords() },
      resting,
      answer.contacts.map((c) => {
        const at = view.place(c.position);
        const inwards = onPage(vector.unit(c.normal));
        const tick = vector.add(at, forceLength(c.preload), inwards);
        const along = path.turned(inwards);
        return [
          cone(c, coneLength),
          svg("path", { class: "axis", d: "M" + path.at(at) + "L" + path.at(vector.add(at, coneLength - 8, inwards)) }),
          page.arrow(vector.add(at, coneLength - 8, inwards), vector.add(at, coneLength, inwards), "normal", {}, 6),
          c.preload > 0
            ? svg("path", {
                class: "preload",
                d: "M" + path.at(vector.add(tick, -8, along)) + "L" + path.at(vector.add(tick, 8, along)),
              })
            : null,
          page.isGrounded(c) ? page.finger(at, inwards) : null,
        ];
      }),
      moves ? ghosts : null,
      loads().map(drawLoad),
      drawMotion(motion, factor),
      motion.kind === "equilibrium" ? drawForces() : null,
      answer.contacts.map((c, i) =>
        page.mark(view.place(c.position), onPage(page.tangent(c)), motion.marks[i], {
          "data-contact": i,
          "data-contact-state": motion.marks[i],
        }),
      ),
      drawNumbers(),
      drawNames(),
      page.handles ? page.handles(view) : null,
    );
    page.put("body", picture);
    page.animate(moves ? ghosts : null, (share) =>
      ghosts.forEach((ghost, b) => ghost.setAttribute("transform", moved(b, motion.twist, share * factor))),
    );
    page.put("body-legend", legend(motion, factor));
  }

  function legend(motion, factor) {
    const arrow = (name) => page.sign(page.arrow([1, 9], [25, 9], name));
    const pulls = loads();
    const torques = pulls.filter(({ torque: [torque] }) => torque !== 0);
    const sketched = page.sketchWords(page.bodies().map(({ outline }) => outline && outline.length), "outline");
    const units = page.unitsOf();
    const twist = motion.kind === "twist";
    const marks = [...new Set(motion.marks)].filter((name) => page.marks[name]);
    const bar = page.roundDown(120 / forceLength(1)); // a force that is drawn at most 120 pixels long
    const barLength = forceLength(bar);
    return [
      page.legend([
        { drawing: page.sign(svg("path", { class: "cone", d: "M1 9L25 16V2Z" })), text: "normal, friction cone" },
        page.answer.contacts.some((c) => c.preload > 0) && {
          drawing: page.sign(svg("path", { class: "preload", d: "M13 1V17" })),
          text: "preload P",
        },
        motion.kind === "equilibrium" && page.forces() && { drawing: arrow("force"), text: page.forceWords() },
        pulls.some(({ force }) => force[0] || force[1]) && {
          drawing: arrow("load"),
          text: "load" + (view.loadFactor === 1 ? "" : ", " + page.factorText(view.loadFactor)),
        },
        ...torques.map(({ name, torque: [torque] }) => ({
          drawing: page.sign(page.torqueArrow([13, 11], 7, torque > 0)),
          text: page.torqueWords(name) + page.near(torque) + (units ? " " + units.force + " " + units.length : ""),
        })),
        factor > 0 && {
          drawing: arrow(twist ? "virtual" : "motion"),
          text: (twist ? "virtual twist, " : "motion, ") + page.factorText(factor),
        },
        factor > 0 &&
          pivots(motion.twist).length > 0 && {
            drawing: page.sign(
              svg(
                "g",
                { class: twist ? "virtual-pivot" : "motion-pivot" },
                svg("circle", { cx: 13, cy: 9, r: 5 }),
                svg("path", { d: "M5 9h16M13 1v16" }),
              ),
            ),
            text: "centre of rotation",
          },
        ...page.linkLegend(),
        ...marks.map((name) => ({ drawing: page.markSign(name), text: page.marks[name] })),
        {
          drawing: page.sign(
            svg("path", { class: "rule", d: "M1 5v8M1 9h" + barLength + "M" + (barLength + 1) + " 5v8" }),
            barLength + 2,
          ),
          text: "force " + page.near(bar) + (units ? " " + units.force : ""),
        },
      ]),
      sketched && page.html("p", { class: "muted" }, sketched),
    ];
  }
  page.views.push(draw);
  page.drawBody = draw;

  // The animation: there and back, or at rest at the end where the reader asked for no motion.
  let running = null;
  let start = 0;
  let animated = "";
  let paused = matchMedia("(prefers-reduced-motion: reduce)").matches;
  page.isPaused = () => paused;
  page.pause = function (yes) {
    paused = yes;
    page.draw();
  };
  page.animate = function (element, move) {
    cancelAnimationFrame(running);
    if (!element) return;
    move(1);
    if (paused) return;
    const kCycle = 2600;
    // What is drawn again, as while something is dragged, goes on where it was.
    const key = String(page.motion().twist);
    if (key !== animated) start = performance.now();
    animated = key;
    const step = function (now) {
      const phase = ((now - start) % kCycle) / kCycle;
      const rise = phase < 0.55 ? phase / 0.55 : phase < 0.75 ? 1 : 1 - (phase - 0.75) / 0.25;
      move(0.5 - 0.5 * Math.cos(Math.PI * Math.min(1, Math.max(0, rise))));
      running = requestAnimationFrame(step);
    };
    running = requestAnimationFrame(step);
  };
})(StickslipPage);
