// SPDX-License-Identifier: GPL-3.0-or-later
//
// Motions of the body and what contacts do in them, in doubles: for drawing. Verdicts, forces and slip
// states are the program's.
(function (page) {
  const kLongestMotion = 0.3; // in sizes of the grasp, as pictures draw it
  const kFar = 2;

  const unit = function (v) {
    const length = Math.hypot(...v) || 1;
    return v.map((x) => x / length);
  };
  const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const add = (a, factor, b) => a.map((x, i) => x + factor * b[i]);
  page.vector = { unit, dot, cross, add };

  // Bodies. A motion of several is a state z, of which a body's twist is a function (certificate/FORMAT.md, section 14).

  /** Of several bodies what is known of them, or null. */
  page.mechanism = () => page.answer.mechanism || null;
  /** All bodies: {name, outline, link, motion}; of one that is alone, {outline}. */
  page.bodies = () => (page.mechanism() ? page.mechanism().bodies : [{ outline: page.answer.outline, link: null }]);

  /** How body b moves, or the ground, which is null. */
  page.twistOf = function (b, motion) {
    if (!page.mechanism()) return motion;
    if (b === null) return Array(page.answer.dimension).fill(0);
    return page.bodies()[b].motion.map((row) => dot(row, motion));
  };

  /** How the body that a contact presses moves, seen from the other one. */
  page.twistAt = (contact, motion) =>
    page.mechanism() ? add(page.twistOf(contact.of, motion), -1, page.twistOf(contact.by, motion)) : motion;

  /** The contacts of body b, with normals into it. */
  page.contactsOf = function (b) {
    const { contacts } = page.answer;
    if (!page.mechanism()) return contacts;
    const pressed = (c) => (c.of === b ? c : { ...c, normal: c.normal.map((x) => -x) });
    return contacts.filter((c) => c.of === b || c.by === b).map(pressed);
  };
  /** Whether a contact is one with the ground. */
  page.isGrounded = (contact) => contact.by === undefined || contact.by === null;

  /** "joint wrist", "tendon tendon 2"; what has no name by its place in the file. */
  page.springName = ({ kind, name, place }) => (!name ? place : name === kind ? name : kind + " " + name);

  /** The points of a link's own hinge and of those of links on it. */
  page.hingesOf = (b) =>
    page
      .bodies()
      .filter(({ link }, other) => link && !link.slides && (other === b || link.on === b))
      .map(({ link }) => link.at);

  /** Of which bodies a drawing is a sketch; for each whether what it looks like is given. */
  page.sketchWords = function (given, what) {
    if (page.answer.contacts.length === 0 || given.every(Boolean)) return "";
    return page.mechanism()
      ? "Bodies whose " + what + " is not given are sketched around their contacts and hinges."
      : "No " + what + " is given: the body is sketched around the contacts.";
  };

  /** The mean of points, or null. */
  page.middleOf = (points) =>
    points.length === 0 ? null : points.reduce((sum, p) => add(sum, 1 / points.length, p), Array(points[0].length).fill(0));

  /**
   * The load as forces at points and torques about these, [{at, force, torque}]: at the point that is given of one body,
   * and of several at the middle of each that is no link. What pulls at joints beyond that is said in words.
   */
  page.loads = function (load, alone, middles) {
    const axes = page.isSpatial() ? 3 : 2;
    const at = function (point, wrench) {
      const force = wrench.slice(0, axes);
      const arm = axes === 3 ? cross(point, force) : [point[0] * force[1] - point[1] * force[0]];
      const dust = 1e-9 * (1e-3 + Math.hypot(...wrench) + Math.hypot(...arm));
      const torque = wrench.slice(axes).map((x, j) => (Math.abs(x - arm[j]) < dust ? 0 : x - arm[j]));
      return { at: point, force, torque };
    };
    if (!load) return [];
    if (!page.mechanism()) return [at(alone, load)];
    return page.bodies().flatMap(({ name, link, motion }, b) => {
      if (link || !middles[b]) return [];
      const first = motion[0].indexOf(1);
      const found = { ...at(middles[b], load.slice(first, first + motion.length)), name };
      return [...found.force, ...found.torque].some((x) => x !== 0) ? [found] : [];
    });
  };

  /**
   * Where the load of one body is drawn: the point of its line of action that is nearest to the middle of the drawing, so that a
   * weight has no torque beside it. The middle itself if there is no such line or it is far away, and where the load is dragged.
   */
  page.actsAt = function (load, { centre, radius }) {
    const kNear = 2; // sizes of the grasp
    if (!load || page.answer.live) return centre;
    const axes = centre.length;
    const force = axes === 3 ? load.slice(0, 3) : [...load.slice(0, 2), 0];
    const about = axes === 3 ? cross(centre, force) : [0, 0, centre[0] * force[1] - centre[1] * force[0]];
    const torque = (axes === 3 ? load.slice(3) : [0, 0, load[2]]).map((x, j) => x - about[j]);
    const square = dot(force, force);
    if (!(square > 0) || Math.abs(dot(torque, force)) > 1e-9 * Math.sqrt(square * dot(torque, torque))) return centre;
    const arm = cross(force, torque).map((x) => x / square);
    return Math.hypot(...arm) > kNear * radius ? centre : add(centre, 1, arm.slice(0, axes));
  };

  /**
   * The middle of the drawing and the size of the grasp: the origin, unless the grasp is far away
   * from it.
   */
  page.frame = function () {
    const axes = page.isSpatial() ? 3 : 2;
    const points = [
      ...page.answer.contacts.map((c) => c.position),
      ...page.bodies().flatMap(({ outline }) => (outline || []).flat()),
    ];
    if (page.isSpatial()) points.push(...page.solids.flatMap((solid) => (solid ? solid.ends : [])));
    const centre = Array(axes).fill(0);
    if (points.length === 0) return { centre, radius: 1 };
    const low = centre.map((_, j) => Math.min(...points.map((p) => p[j])));
    const high = centre.map((_, j) => Math.max(...points.map((p) => p[j])));
    const middle = low.map((x, j) => (x + high[j]) / 2);
    const size = Math.max(...high.map((x, j) => x - middle[j]));
    if (size > 0 && Math.max(...middle.map(Math.abs)) > kFar * size) centre.splice(0, axes, ...middle);
    const radius = Math.max(...points.map((p) => Math.max(...p.map((x, j) => Math.abs(x - centre[j])))));
    return { centre, radius: radius || 1 };
  };

  page.tangent = (contact) => [-unit(contact.normal)[1], unit(contact.normal)[0]];

  /** How a point moves. */
  page.displacement = function (point, twist) {
    if (twist.length === 3) return [twist[0] - twist[2] * point[1], twist[1] + twist[2] * point[0]];
    return add(twist.slice(0, 3), 1, cross(twist.slice(3), point));
  };

  /** How a contact's point moves with the body that it presses, seen from the other one. */
  page.moveAt = (contact, motion) => page.displacement(contact.position, page.twistAt(contact, motion));

  /** How fast a soft finger's patch rubs as it turns about the normal: its torsion times that turn. */
  page.spinAt = (contact, motion) =>
    contact.torsion ? contact.torsion * dot(unit(contact.normal), page.twistAt(contact, motion).slice(3)) : 0;

  /** By which round factor a motion is enlarged in drawings; 0 if nothing moves. */
  page.enlargement = function (twist, frame) {
    let largest = 0;
    page.bodies().forEach((_, b) => {
      const of = page.twistOf(b, twist);
      const turn = Math.max(...of.slice(of.length === 3 ? 2 : 3).map(Math.abs));
      largest = Math.max(largest, ...page.displacement(frame.centre, of).map(Math.abs), turn * frame.radius);
    });
    for (const contact of page.answer.contacts) largest = Math.max(largest, ...page.moveAt(contact, twist).map(Math.abs));
    return largest > 0 ? page.roundDown((kLongestMotion * frame.radius) / largest) : 0;
  };

  /** About which point a planar motion turns; null for a translation. */
  page.pivot = (twist) => (twist[2] === 0 ? null : [-twist[1] / twist[2], twist[0] / twist[2]]);

  /** The axis of a motion in space: a point of it, its direction, and the shift along it for each radian. */
  page.screw = function (twist) {
    const [shift, turn] = [twist.slice(0, 3), twist.slice(3)];
    const square = dot(turn, turn);
    if (square === 0) return null;
    return {
      point: cross(turn, shift).map((x) => x / square),
      direction: unit(turn),
      pitch: dot(turn, shift) / square,
    };
  };

  const unitName = () => (page.unitsOf() ? "\u00A0" + page.unitsOf().length : "");
  page.unitsOf = () => (page.answer.decide && page.answer.decide.units) || page.grasp.units() || null;

  /** A motion in words, of several bodies of each that moves. */
  page.motionLines = function (motion) {
    if (!page.mechanism()) return [page.motionWords(motion)];
    const twists = page.bodies().map(({ name }, b) => [name, page.twistOf(b, motion)]);
    const rests = (twist) => twist.every((x) => x === 0);
    const still = twists.filter(([, twist]) => rests(twist)).map(([name]) => name);
    const lines = twists.filter(([, twist]) => !rests(twist)).map(([name, twist]) => page.motionWords(twist, name));
    if (lines.length === 0) return ["Nothing moves."];
    return still.length === 0 ? lines : [...lines, "Not moved: " + still.join(", ") + "."];
  };

  page.motionWords = function (twist, who = "The body") {
    const size = Math.max(...twist.map(Math.abs));
    if (size === 0) return "Nothing moves.";
    if (twist.length === 6) {
      const screw = page.screw(twist);
      if (!screw) return who + " shifts along " + page.nearTuple(unit(twist.slice(0, 3))) + ", without turning.";
      const shift =
        Math.abs(screw.pitch) < 1e-9
          ? ""
          : ", and shifts by " + page.near(screw.pitch, 3) + unitName() + " along it with each radian";
      return (
        who +
        " turns about the axis through " +
        page.nearTuple(screw.point.map((x) => x + 0)) +
        " along " +
        page.nearTuple(screw.direction) +
        shift +
        "."
      );
    }
    const pivot = page.pivot(twist);
    if (!pivot || Math.max(...pivot.map(Math.abs)) > 1e9 * page.frame().radius) {
      return (
        who +
        " shifts along " +
        page.nearTuple(unit(twist.slice(0, 2)).map((x) => page.clean(x))) +
        ", without turning."
      );
    }
    return (
      who +
      " turns " +
      (twist[2] > 0 ? "counterclockwise \u21BA" : "clockwise \u21BB") +
      " about " +
      page.nearTuple(pivot.map((x) => page.clean(x, page.frame().radius))) +
      unitName() +
      "."
    );
  };

  /** Without the dust of rounding, for words only. */
  page.clean = (x, size = 1) => (Math.abs(x) < 1e-9 * size ? 0 : x);

  // What a mark means. Shapes as in pictures: a disc sticks, a triangle points where the contact slips.
  page.marks = {
    stick: "sticks",
    plus: "slips +",
    minus: "slips \u2212",
    slip: "slips",
    open: "open",
    loses: "opposes it and loses",
    idle: "cannot oppose it",
    none: "",
  };
  const kMarkOf = { 0: "stick", "+": "plus", "-": "minus" };

  /** Whether the motion presses contact i in (-1), leaves it (+1) or neither (0). */
  page.parting = function (contact, twist) {
    const move = page.moveAt(contact, twist);
    const along = dot(unit(contact.normal), move);
    return Math.abs(along) <= 1e-9 * (Math.hypot(...move) + Math.hypot(...twist) * 1e-6) ? 0 : Math.sign(along);
  };

  function decided() {
    const decide = page.answer.decide;
    return decide && decide.cases ? null : decide;
  }
  page.decided = decided;

  /** The motion that is looked at: {kind, twist, marks, exact}, where marks are one for each contact. */
  page.motion = function () {
    const { answer, shown } = page;
    const marksOf = (mark) => answer.contacts.map(mark);
    const decide = decided();
    const chosen = shown.pointed !== null ? shown.pointed : shown.motion === "cell" ? shown.cell : null;
    const cell = chosen !== null && answer.states && answer.states.cells[chosen];
    if (cell) {
      return { kind: "cell", cell, twist: cell.motion, marks: marksOf((_, i) => kMarkOf[cell.states[i]] || "none") };
    }
    if (shown.motion === "twist" || (decide && decide.verdict === "unstable" && shown.motion === "equilibrium")) {
      const found = page.refutation();
      const drift = found.leaves.length > 0 ? page.drift(found.leaves[page.leafShown()]) : null;
      if (drift) {
        return {
          kind: "twist",
          twist: drift.twist,
          exact: drift.exact,
          marks: marksOf((_, i) => (drift.opposing[i] ? "loses" : "idle")),
        };
      }
    }
    return page.equilibrium() || { kind: "none", twist: null, marks: marksOf(() => "none") };
  };

  /** That of a stable verdict, as page.motion; else null. */
  page.equilibrium = function () {
    const { answer } = page;
    const decide = decided();
    const twist = decide && ((answer.near && answer.near.twist_float) || decide.twist_float);
    if (!twist) return null;
    const forces = page.forces();
    return {
      kind: "equilibrium",
      twist,
      exact: decide.twist || null,
      marks: answer.contacts.map((contact, i) => (forces ? equilibriumMark(forces[i], contact, twist) : "none")),
    };
  };

  /**
   * The contacts in the equilibrium in doubles, {force, closed, slip}, or null. Where the proof says that there is one
   * but not which, those near it.
   */
  page.forces = function () {
    const found = [decided(), page.answer.near].find((part) => part && part.contacts);
    return found ? found.contacts.map((c) => ({ ...c, force: c.force_float })) : null;
  };

  function equilibriumMark(force, contact, twist) {
    if (!force.closed) return "open";
    if (force.slip) return kMarkOf[force.slip] || "none";
    const slip = slipOf(contact, twist);
    const spins = Math.abs(page.spinAt(contact, twist)) > 1e-9 * Math.hypot(...twist);
    if (slip.every((x) => x === 0) && !spins) return "stick";
    return page.isSpatial() ? "slip" : dot(page.tangent(contact), slip) > 0 ? "plus" : "minus";
  }

  function slipOf(contact, twist) {
    const move = page.moveAt(contact, twist);
    const normal = unit(contact.normal);
    const slip = add(move, -dot(move, normal), normal);
    return Math.hypot(...slip) > 1e-9 * Math.hypot(...twist, 1e-300) ? slip : slip.map(() => 0);
  }
})(StickslipPage);
