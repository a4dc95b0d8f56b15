// SPDX-License-Identifier: GPL-3.0-or-later
//
// A grasp in space, drawn by three.js: bodies, contacts, cones, forces, load, and the motion as a screw. It is turned by the mouse
// or by arrow keys. Lengths are in sizes of the grasp, as in the plane.
(function (page) {
  const { html, vector } = page;
  const kLongestForce = 0.6;
  const kLongestCone = 0.6;
  const kTurn = Math.PI / 24;
  const kAroundHinge = 0.06;
  const kCrease = 18; // degrees between faces from which on their edge is drawn

  let renderer = null;
  let scene = null;
  let camera = null;
  let moving = []; // what the animation moves, by body; null where there is nothing
  let look = { azimuth: -0.9, height: 0.45, distance: 5.2 };
  const kHome = { ...look };
  /** Where the load's arrow begins; about it is the torque that is drawn. */
  page.loadPoint = () => page.actsAt(page.load(), page.frame());
  let target = [0, 0, 0]; // what is looked at: the middle of the body
  let reach = 1; // its size

  const V = (v) => new THREE.Vector3(...v);
  const colour = (name) => new THREE.Color(page.colour(name));

  /** A texture with a text, always turned to the reader. */
  function sprite(text, at, size = 0.2) {
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    const font = "bold 74px Helvetica, Arial, sans-serif";
    context.font = font;
    canvas.width = Math.max(128, Math.ceil(context.measureText(text).width) + 32);
    canvas.height = 128;
    context.font = font;
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineJoin = "round";
    context.lineWidth = 16;
    context.strokeStyle = page.colour("paper");
    context.strokeText(text, canvas.width / 2, 68);
    context.fillStyle = page.colour("ink");
    context.fillText(text, canvas.width / 2, 68);
    const made = new THREE.Sprite(new THREE.SpriteMaterial({ map: new THREE.CanvasTexture(canvas), depthTest: false }));
    made.position.copy(V(at));
    made.scale.set((size * canvas.width) / canvas.height, size, 1);
    made.renderOrder = 10;
    return made;
  }

  const solid = (name, opacity = 1) =>
    new THREE.MeshLambertMaterial({
      color: colour(name),
      transparent: opacity < 1,
      opacity,
      side: THREE.DoubleSide,
      depthWrite: opacity === 1,
    });

  /** A solid of revolution along +y from the origin, turned to point from tail along a direction. */
  function placed(object, tail, direction) {
    object.position.copy(V(tail));
    object.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), V(vector.unit(direction)));
    return object;
  }

  function arrow(tail, along, name, width = 0.022) {
    const length = Math.hypot(...along);
    if (length < 0.01) return null;
    const head = Math.min(0.16, 0.6 * length);
    const group = new THREE.Group();
    const shaft = new THREE.Mesh(new THREE.CylinderGeometry(width, width, length - head, 16), solid(name));
    shaft.position.y = (length - head) / 2;
    const tip = new THREE.Mesh(new THREE.ConeGeometry(3 * width, head, 24), solid(name));
    tip.position.y = length - head / 2;
    group.add(shaft, tip);
    return placed(group, tail, along);
  }

  /** The part of a ball around the contact that lies in the friction cone. */
  function cone(contact, length) {
    const half = Math.atan(contact.friction);
    const profile = [new THREE.Vector2(0, 0)];
    for (let k = 12; k >= 0; --k) {
      const angle = (half * k) / 12;
      profile.push(new THREE.Vector2(Math.max(1e-6, length * Math.sin(angle)), length * Math.cos(angle)));
    }
    const group = new THREE.Group();
    group.add(new THREE.Mesh(new THREE.LatheGeometry(profile, 48), solid("cone", 0.26)));
    const rim = [];
    for (let k = 0; k <= 64; ++k) {
      const turn = (2 * Math.PI * k) / 64;
      rim.push(
        V([
          length * Math.sin(half) * Math.cos(turn),
          length * Math.cos(half),
          length * Math.sin(half) * Math.sin(turn),
        ]),
      );
    }
    group.add(line(rim, "cone-line"), line([V([0, 0, 0]), V([0, length, 0])], "thin"));
    return placed(group, contact.at, contact.normal);
  }

  function line(points, name, dashed = false) {
    const Material = dashed ? THREE.LineDashedMaterial : THREE.LineBasicMaterial;
    const made = new THREE.Line(
      new THREE.BufferGeometry().setFromPoints(points),
      new Material({ color: colour(name), ...(dashed ? { dashSize: 0.06, gapSize: 0.05 } : {}) }),
    );
    if (dashed) made.computeLineDistances();
    return made;
  }

  /**
   * The triangles of the convex hull of points: a tetrahedron, to which one point after the other is added. For drawing:
   * points are moved a little, so that no four lie in a plane.
   */
  function hull(given) {
    const points = given.map((p, i) =>
      p.map((x, j) => x + 1e-5 * Math.sin(12.9898 * (i + 1) + 78.233 * (j + 1) * (i + 3))),
    );
    if (points.length < 4) return [];
    const above = ([a, b, c], p) => {
      const normal = vector.cross(vector.add(points[b], -1, points[a]), vector.add(points[c], -1, points[a]));
      return vector.dot(normal, vector.add(p, -1, points[a])) > 0;
    };
    let faces = [
      [0, 1, 2],
      [0, 2, 1],
    ];
    for (let i = 3; i < points.length; ++i) {
      const seen = faces.filter((face) => above(face, points[i]));
      if (seen.length === 0) continue;
      const edges = new Map();
      for (const [a, b, c] of seen)
        for (const [p, q] of [
          [a, b],
          [b, c],
          [c, a],
        ])
          edges.set(p + "," + q, [p, q]);
      faces = faces.filter((face) => !seen.includes(face));
      for (const [p, q] of edges.values()) if (!edges.has(q + "," + p)) faces.push([p, q, i]);
    }
    return faces.map((face) => face.map((k) => given[k]));
  }

  /**
   * Points of which the hull stands for a body: the contacts, and points a little inside of them, as in pictures; of a link
   * what is around its contacts and hinges.
   */
  function bodyPoints(contacts, hinges) {
    if (hinges.length > 0) {
      const corners = (p, by = kAroundHinge) =>
        [-by, by].flatMap((x) => [-by, by].flatMap((y) => [-by, by].map((z) => vector.add(p, 1, [x, y, z]))));
      return [...contacts.map((c) => c.at), ...hinges].flatMap((p) => corners(p));
    }
    const points = contacts.map((c) => c.at);
    for (const c of contacts) {
      const axis = [0, 1, 2].map((j) =>
        j === c.normal.map(Math.abs).indexOf(Math.min(...c.normal.map(Math.abs))) ? 1 : 0,
      );
      const across = vector.unit(vector.cross(c.normal, axis));
      for (const tangent of [across, vector.cross(c.normal, across)]) {
        for (const side of [-0.3, 0.3, -0.4, 0.4]) {
          const p = vector.add(vector.add(c.at, Math.abs(side) < 0.35 ? 0.12 : 0.5, c.normal), side, tangent);
          if (contacts.every((o) => vector.dot(vector.add(p, -1, o.at), o.normal) >= 0)) points.push(p);
        }
      }
    }
    return points;
  }

  /** The triangles of body b, scaled: those of the page's, or of a hull around its contacts. */
  function trianglesOf(b, frame) {
    const solid = page.solids[b];
    if (!solid) {
      const contacts = page.contactsOf(b).map((c) => ({ normal: vector.unit(c.normal), at: inScene(c.position, frame) }));
      const { link } = page.bodies()[b];
      return hull(bodyPoints(contacts, link && !link.slides ? page.hingesOf(b).map((p) => inScene(p, frame)) : []));
    }
    const key = [solid.mark, frame.radius, ...frame.centre].join(" ");
    const scaled = (triangle) => triangle.map((p) => inScene(p, frame));
    if (!kept[b] || kept[b].key !== key) kept[b] = { key, triangles: solid.triangles.map(scaled) };
    return kept[b].triangles;
  }
  const kept = []; // of the page's bodies, from drawing to drawing, as a large one takes a while

  /** What is drawn of triangles: {faces, edges}. */
  function surface(triangles) {
    const large = kept.find((one) => one && one.triangles === triangles);
    if (large && large.surface) return large.surface;
    const faces = new THREE.BufferGeometry();
    faces.setAttribute("position", new THREE.Float32BufferAttribute(triangles.flat(2), 3));
    faces.computeVertexNormals();
    const found = { faces, edges: new THREE.EdgesGeometry(faces, kCrease) };
    if (large) {
      large.surface = found;
      for (const geometry of Object.values(found)) geometry.userData.kept = true;
    }
    return found;
  }

  function body({ faces, edges }, name, opacity, material) {
    const group = new THREE.Group();
    const outline = new THREE.LineSegments(edges, material);
    if (material.isLineDashedMaterial) outline.computeLineDistances();
    group.add(outline);
    if (opacity > 0) group.add(new THREE.Mesh(faces, solid(name, opacity)));
    return group;
  }

  function torque(centre, axis, name, radius = 0.34) {
    const group = new THREE.Group();
    const points = [];
    for (let k = 0; k <= 48; ++k) {
      const turn = (1.5 * Math.PI * k) / 48;
      points.push(V([radius * Math.cos(turn), 0, -radius * Math.sin(turn)]));
    }
    group.add(new THREE.Mesh(new THREE.TubeGeometry(new THREE.CatmullRomCurve3(points), 48, 0.014, 8), solid(name)));
    const head = new THREE.Mesh(new THREE.ConeGeometry(0.05, 0.14, 20), solid(name));
    head.position.copy(points[48]);
    const along = points[48].clone().sub(points[47]).normalize();
    head.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along);
    head.position.addScaledVector(along, 0.06);
    group.add(head);
    return placed(group, centre, axis);
  }

  /** The axis of a screw, with the helix that a point near it runs along. */
  function drawScrew(twist, frame, name) {
    const screw = page.screw(twist);
    if (!screw) return [];
    const at = vector.add(screw.point, -1, frame.centre).map((x) => x / frame.radius);
    if (Math.hypot(...at) > 4) return [];
    const pitch = screw.pitch / frame.radius;
    const middle = vector.add(at, -vector.dot(at, screw.direction), screw.direction);
    const group = new THREE.Group();
    group.add(line([V([0, -1.3, 0]), V([0, 1.3, 0])], name, true));
    const bounded = Math.max(-0.35, Math.min(0.35, pitch));
    const turns = Math.min(3 * Math.PI, 1.6 / Math.max(0.01, Math.abs(bounded)));
    const points = [];
    for (let k = 0; k <= 120; ++k) {
      const turn = (k / 120 - 0.5) * turns;
      points.push(V([0.16 * Math.cos(turn), bounded * turn, -0.16 * Math.sin(turn)]));
    }
    group.add(line(points, name));
    const along = points[120].clone().sub(points[119]).normalize();
    const head = new THREE.Mesh(new THREE.ConeGeometry(0.045, 0.12, 16), solid(name));
    head.position.copy(points[120]);
    head.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), along);
    group.add(head);
    return [placed(group, middle, screw.direction)];
  }

  function mark(contact, name) {
    const hollow = name === "open" || name === "idle";
    const geometry =
      name === "slip"
        ? new THREE.BoxGeometry(0.09, 0.09, 0.09)
        : name === "loses" || name === "idle"
          ? new THREE.OctahedronGeometry(0.08)
          : new THREE.SphereGeometry(0.055, 20, 14);
    const made = new THREE.Mesh(
      geometry,
      hollow
        ? new THREE.MeshBasicMaterial({ color: colour("ink"), wireframe: true })
        : new THREE.MeshBasicMaterial({ color: colour("ink") }),
    );
    return placed(made, contact.at, contact.normal);
  }

  /** What holds the contact: a small plate behind it. */
  function finger(contact) {
    const made = new THREE.Mesh(new THREE.CylinderGeometry(0.12, 0.12, 0.025, 28), solid("thin", 0.8));
    return placed(made, vector.add(contact.at, -0.05, contact.normal), contact.normal);
  }

  function build(view) {
    const { frame, contacts } = view;
    const parts = [];
    const motion = page.motion();
    const name = motion.kind === "twist" ? "virtual" : "motion";
    const factor = motion.twist ? page.enlargement(motion.twist, frame) : 0;
    const shapes = view.bodies.map((triangles) => (triangles.length > 0 ? surface(triangles) : null));
    const rest = { color: colour("body-line"), transparent: true, opacity: 0.55 };
    shapes.forEach((shape, b) => {
      if (!shape) return;
      const resting = body(shape, "body-line", 0.16, new THREE.LineBasicMaterial(rest));
      resting.userData.body = b;
      parts.push(resting);
    });
    if (page.mechanism()) parts.push(...drawNames(view));
    const coneLength = kLongestCone * Math.min(1, 2.2 / Math.sqrt(contacts.length || 1));
    const forces = motion.kind === "equilibrium" ? page.forces() : null;
    const loads = page.loads(page.load(), page.loadPoint(), view.bodies.map((triangles) => middleOf(triangles, frame)));
    const size = Math.max(...loads.flatMap(({ force }) => force.map(Math.abs)), 0);
    view.unit =
      view.unit ||
      Math.max(
        ...contacts.map((c) => c.preload),
        ...(forces || []).flatMap((f) => f.force.map(Math.abs)),
        size,
      ) ||
      1;
    const { unit } = view;
    const length = (v) => v.map((x) => (kLongestForce * x) / unit);
    contacts.forEach((c, i) => {
      parts.push(
        cone(c, coneLength),
        page.isGrounded(c) && finger(c),
        mark(c, motion.marks[i]),
        sprite(String(i), vector.add(c.at, -0.2, c.normal)),
      );
      if (forces) parts.push(arrow(c.at, length(forces[i].force), "force", 0.026));
      if (factor > 0) {
        const move = page.moveAt(c, motion.twist).map((x) => (x * factor) / frame.radius);
        parts.push(arrow(c.at, move, name, 0.014));
      }
    });
    view.loadFactor =
      view.loadFactor || (size > 0 && size < unit / 8 ? page.roundDown((0.6 * unit) / size) : 1);
    view.perLength = unit / (kLongestForce * view.loadFactor * frame.radius);
    view.load = null;
    for (const { at, force, torque: there } of loads) {
      const tail = inScene(at);
      const along = length(force.map((x) => x * view.loadFactor));
      parts.push(arrow(tail, along, "load", 0.022));
      if (there.some((x) => x !== 0)) parts.push(torque(tail, there, "load"));
      view.load = { tail: inFile(tail), tip: inFile(vector.add(tail, 1, along)), isForce: size > 0 };
    }
    moving = [];
    if (factor > 0) {
      page.bodies().forEach(({ link }, b) => {
        if (!link) parts.push(...drawScrew(page.twistOf(b, motion.twist), frame, name));
      });
      moving = shapes.map(function (shape) {
        if (!shape) return null;
        const dashed = { color: colour(name), dashSize: 0.06, gapSize: 0.045 };
        const ghost = body(shape, name, 0.08, new THREE.LineDashedMaterial(dashed));
        ghost.matrixAutoUpdate = false;
        parts.push(ghost);
        return ghost;
      });
    }
    return { parts: parts.filter(Boolean), motion, factor, forces, loads, unit, coneLength };
  }

  /** The middle of what triangles span, in the frame of the file, or null. */
  const middleOf = (triangles, frame) => {
    const middle = page.middleOf(boxAround(triangles.flat()));
    return triangles.length > 0 ? vector.add(frame.centre, frame.radius, middle) : null;
  };

  /** Names of several bodies, and how links are held: the axis of a hinge, a rail along a slide. */
  function drawNames({ frame, bodies }) {
    return page.bodies().flatMap(function ({ name, link }, b) {
      const middle = middleOf(bodies[b], frame) || (link && !link.slides ? link.at : null);
      if (!middle) return [];
      const label = sprite(name, vector.add(inScene(middle, frame), 0.12 * reach, [0, 0, 1]), 0.12 * reach);
      if (!link) return [label];
      const axis = vector.unit(link.axis);
      if (!link.slides) return [label, placed(pin(), vector.add(inScene(link.at, frame), -kPin / 2, axis), axis)];
      const ends = [-kRail, kRail].map((by) => V(vector.add(inScene(middle, frame), by, axis)));
      return [label, line(ends, "ink", true)];
    });
  }
  const kPin = 0.3;
  const kRail = 0.8;
  /** Along +y from the origin. */
  function pin() {
    const group = new THREE.Group();
    const made = new THREE.Mesh(new THREE.CylinderGeometry(0.03, 0.03, kPin, 20), solid("ink"));
    made.position.y = kPin / 2;
    group.add(made);
    return group;
  }

  /** How body b is moved by a share of the motion: a link is carried by what it is on, and then turned on its own hinge. */
  function moved(b, motion, share, frame) {
    const { link } = page.bodies()[b];
    if (!link || link.on === null) return move(page.twistOf(b, motion), share, frame);
    const own = vector.add(page.twistOf(b, motion), -1, page.twistOf(link.on, motion));
    return moved(link.on, motion, share, frame).multiply(move(own, share, frame));
  }

  /** By a share of the motion: a turn about the axis and a shift along it, or a shift. */
  function move(twist, share, frame) {
    const matrix = new THREE.Matrix4();
    const screw = page.screw(twist);
    if (!screw) {
      matrix.makeTranslation(...twist.slice(0, 3).map((x) => (x * share) / frame.radius));
    } else {
      const at = V(vector.add(screw.point, -1, frame.centre).map((x) => x / frame.radius));
      const angle = Math.hypot(...twist.slice(3)) * share;
      const shift = V(screw.direction).multiplyScalar((screw.pitch * angle) / frame.radius);
      matrix.makeRotationAxis(V(screw.direction), angle);
      matrix.setPosition(at.clone().sub(at.clone().applyMatrix4(matrix)).add(shift));
    }
    return matrix;
  }

  function render() {
    const { azimuth, height, distance } = look;
    const eye = vector.add(target, distance * reach, [
      Math.cos(height) * Math.cos(azimuth),
      Math.cos(height) * Math.sin(azimuth),
      Math.sin(height),
    ]);
    camera.position.set(...eye);
    camera.up.set(0, 0, 1);
    camera.lookAt(...target);
    const [wide, high] = view.size;
    renderer.setViewport(0, 0, wide, high);
    renderer.autoClear = true;
    renderer.render(scene, camera);
    // The axes lie over a corner, turned as the rest.
    const size = Math.min(kAxes, wide / 4);
    const towards = vector.unit(vector.add(eye, -1, target));
    axesCamera.position.set(...towards.map((x) => 4 * x));
    axesCamera.up.set(0, 0, 1);
    axesCamera.lookAt(0, 0, 0);
    renderer.autoClear = false;
    renderer.clearDepth();
    renderer.setViewport(0, 0, size, size);
    renderer.render(axes, axesCamera);
  }
  const kAxes = 110; // pixels
  let axes = null; // those of the file's frame
  const axesCamera = new THREE.OrthographicCamera(-0.72, 0.72, 0.72, -0.72, 0.1, 10);
  function makeAxes() {
    axes = new THREE.Scene();
    axes.add(new THREE.AmbientLight(0xffffff, 1));
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ].forEach((axis, j) =>
      axes.add(
        arrow(
          [0, 0, 0],
          axis.map((x) => 0.42 * x),
          "muted",
          0.012,
        ),
        sprite("xyz"[j], vector.add([0, 0, 0], 0.56, axis), 0.22),
      ),
    );
  }

  /** The corners of the box around points. */
  const boxAround = (points) =>
    [Math.min, Math.max].map((end) => [0, 1, 2].map((j) => points.reduce((x, p) => end(x, p[j]), points.length ? points[0][j] : 0)));

  let view = null;
  function makeView() {
    const frame = page.keepView ? page.keepView.frame : page.frame();
    const contacts = page.answer.contacts.map((c) => ({
      ...c,
      normal: vector.unit(c.normal),
      at: inScene(c.position, frame),
    }));
    // While something is dragged, the body stays, and so do the scales.
    if (page.keepView) return { ...page.keepView, contacts };
    const bodies = page.bodies().map((_, b) => trianglesOf(b, frame));
    const solids = page.solids.flatMap((solid) => (solid ? solid.ends : [])).map((p) => inScene(p, frame));
    const sketched = page.mechanism() ? bodies.flatMap((triangles, b) => (page.solids[b] ? [] : triangles.flat())) : [];
    const ends = boxAround([[0, 0, 0], ...contacts.map((c) => c.at), ...solids, ...sketched]);
    return { frame, contacts, bodies, ends, place, onBody, besides };
  }

  function draw() {
    if (!page.isSpatial()) return drawPlane();
    if (!renderer) return;
    view = makeView();
    const { frame } = view;
    if (view.contacts.length > 0 || page.solids.some(Boolean)) {
      const [low, high] = view.ends;
      target = low.map((x, j) => (x + high[j]) / 2);
      reach = Math.max(0.6, Math.hypot(...high.map((x, j) => x - low[j])) / 2.6);
    }
    const width = page.canvasWidth("space", 640);
    const height = Math.round(Math.min(520, width * 0.8));
    view.size = [width, height];
    page.find("space-frame").style.width = width + "px";
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(width, height);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    const before = [scene, axes];
    makeAxes();
    scene = new THREE.Scene();
    scene.background = colour("paper");
    scene.add(new THREE.AmbientLight(0xffffff, 0.75));
    const light = new THREE.DirectionalLight(0xffffff, 0.45);
    light.position.set(1, -2, 3);
    scene.add(light);
    const built = build(view);
    scene.add(...built.parts);
    page.animate(moving.some(Boolean) ? moving : null, (share) => {
      moving.forEach((ghost, b) => {
        if (ghost) ghost.matrix = moved(b, built.motion.twist, share * built.factor, frame);
      });
      render();
    });
    render();
    // The renderer drops a shader with the last material that uses it, and compiles it anew for the next.
    before.forEach(dispose);
    placeHandles();
    renderer.domElement.setAttribute(
      "aria-label",
      "The grasp in space: " +
        page.verdictWords() +
        " Arrow keys turn it, plus and minus bring it nearer and away, Home turns it back.",
    );
    page.put("body-legend", legend(built));
  }

  /** Frees what the renderer keeps of a scene; of none, nothing. */
  function dispose(old) {
    if (!old) return;
    old.traverse((o) => {
      if (o.geometry && !o.geometry.userData.kept) o.geometry.dispose();
      if (o.material && o.material.map) o.material.map.dispose();
      if (o.material) o.material.dispose();
    });
  }

  function legend({ motion, factor, forces, loads, unit }) {
    const { svg } = page;
    const arrowSign = (name) => page.sign(page.arrow([1, 9], [25, 9], name));
    const units = page.unitsOf();
    const twist = motion.kind === "twist";
    const marks = [...new Set(motion.marks)].filter((name) => page.marks[name]);
    const sketched = page.sketchWords(page.bodies().map((_, b) => page.solids[b]), "mesh");
    const screws = (motion) => page.bodies().some(({ link }, b) => !link && page.screw(page.twistOf(b, motion)));
    return [
      page.legend([
        { drawing: page.sign(svg("path", { class: "cone", d: "M1 9L25 16V2Z" })), text: "normal, friction cone" },
        forces && {
          drawing: arrowSign("force"),
          text:
            page.forceWords() +
            (page.answer.near ? ", near" : "") +
            ", longest part " +
            page.near(unit, 3) +
            (units ? " " + units.force : ""),
        },
        loads.some(({ force }) => Math.hypot(...force) > 0) && {
          drawing: arrowSign("load"),
          text: "load" + (view.loadFactor === 1 ? "" : ", " + page.factorText(view.loadFactor)),
        },
        ...loads
          .filter(({ torque: there }) => there.some((x) => x !== 0))
          .map(({ name, torque: there }) => ({
            drawing: page.sign(page.torqueArrow([13, 11], 7, true)),
            text: page.torqueWords(name) + page.nearTuple(there) + (units ? " " + units.force + " " + units.length : ""),
          })),
        factor > 0 && {
          drawing: arrowSign(twist ? "virtual" : "motion"),
          text:
            (twist ? "virtual twist, " : "motion, ") +
            page.factorText(factor) +
            (screws(motion.twist) ? ", with the axis of its screw" : ""),
        },
        ...page.linkLegend(),
        ...marks.map((name) => ({ drawing: page.markSign(name), text: page.marks[name] })),
      ]),
      html(
        "p",
        { class: "muted" },
        (sketched && sketched + " ") +
          "Turn it with the mouse or the arrow keys.",
      ),
    ];
  }

  function turn(azimuth, height) {
    look.azimuth += azimuth;
    look.height = Math.max(-1.5, Math.min(1.5, look.height + height));
    render();
    placeHandles();
  }

  // From the frame of the file to the canvas, and back.

  const inFile = (at) => vector.add(view.frame.centre, view.frame.radius, at);
  const inScene = (position, { centre, radius } = view.frame) => vector.add(position, -1, centre).map((x) => x / radius);

  /** Where a position is on the canvas, in pixels. */
  function place(position) {
    const [width, height] = view.size;
    const { x, y } = V(inScene(position)).project(camera);
    return [((1 + x) * width) / 2, ((1 - y) * height) / 2];
  }

  function rayThrough([x, y]) {
    const [width, height] = view.size;
    const caster = new THREE.Raycaster();
    caster.setFromCamera({ x: (2 * x) / width - 1, y: 1 - (2 * y) / height }, camera);
    return caster;
  }

  /**
   * The place of the body under a pixel, {position, normal}, or null: the one that is seen, or the nearest to a position.
   * Of what a ray goes through, it enters the body first, then leaves it, and so on.
   */
  function onBody(pixel, near = null) {
    const [triangles] = view.bodies;
    if (triangles.length === 0) return null;
    const caster = rayThrough(pixel);
    const mesh = new THREE.Mesh(surface(triangles).faces, new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }));
    const hits = caster.intersectObject(mesh);
    const passed = hits.filter((hit, k) => k === 0 || hit.distance - hits[k - 1].distance > 1e-6);
    if (passed.length === 0) return null;
    const away = ({ point }) => (near ? Math.hypot(...vector.add(inFile(point.toArray()), -1, near)) : 0);
    const best = passed.reduce((a, b) => (away(b) < away(a) ? b : a));
    const along = caster.ray.direction.dot(best.face.normal) * (passed.indexOf(best) % 2 === 0 ? 1 : -1);
    return {
      position: inFile(best.point.toArray()),
      normal: best.face.normal.toArray().map((x) => (along < 0 ? -x : x)),
    };
  }

  /** The position under a pixel that is as far away as another. */
  function besides(pixel, position) {
    const ahead = camera.getWorldDirection(new THREE.Vector3());
    const facing = new THREE.Plane().setFromNormalAndCoplanarPoint(ahead, V(inScene(position)));
    const found = rayThrough(pixel).ray.intersectPlane(facing, new THREE.Vector3());
    return found ? inFile(found.toArray()) : position;
  }

  /** On the canvas, what the live page has to be dragged. */
  function placeHandles() {
    if (!view || !page.handles) return;
    page.find("space-handles").replaceChildren(...(page.handles(view) || []));
    page.restoreFocus();
  }

  page.startSpace = function () {
    if (renderer) return;
    const where = page.find("space");
    try {
      renderer = new THREE.WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    } catch (error) {
      page.put(
        "space",
        html("p", {}, "This browser draws nothing in space (it has no WebGL). All numbers are in the table."),
      );
      return;
    }
    camera = new THREE.PerspectiveCamera(34, 1, 0.1, 50);
    const canvas = renderer.domElement;
    canvas.id = "space-canvas";
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application");
    canvas.style.touchAction = "none";
    canvas.style.cursor = "grab";
    const handles = page.svg("svg", { id: "space-handles", class: "stickslip" });
    where.append(html("div", { id: "space-frame" }, canvas, handles));
    let from = null;
    canvas.addEventListener("pointerdown", (event) => {
      from = [event.clientX, event.clientY];
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!from) return;
      turn((from[0] - event.clientX) / 160, (event.clientY - from[1]) / 160);
      from = [event.clientX, event.clientY];
    });
    for (const type of ["pointerup", "pointercancel"]) canvas.addEventListener(type, () => (from = null));
    canvas.addEventListener("keydown", (event) => {
      const zoom = (by) => () => {
        look.distance = Math.max(2.5, Math.min(14, look.distance * by));
        turn(0, 0);
      };
      const kKeys = {
        ArrowLeft: () => turn(-kTurn, 0),
        ArrowRight: () => turn(kTurn, 0),
        ArrowUp: () => turn(0, kTurn),
        ArrowDown: () => turn(0, -kTurn),
        "+": zoom(0.9),
        "-": zoom(1 / 0.9),
        Home: () => {
          look = { ...kHome };
          turn(0, 0);
        },
      };
      if (!kKeys[event.key]) return;
      kKeys[event.key]();
      event.preventDefault();
    });
  };

  /** From where it is looked at, for tests. */
  page.spaceState = () => ({
    ...look,
    drawn: scene ? scene.children.length : 0,
    bodies: scene ? scene.children.flatMap((part) => (part.userData.body === undefined ? [] : [part.userData.body])) : [],
    moved: moving.map((ghost) => ghost && ghost.matrix.elements.slice()),
  });

  const drawPlane = page.drawBody;
  const planeView = page.bodyView;
  page.drawBody = draw;
  page.bodyView = () => (page.isSpatial() ? view : planeView());
  page.views.push(() => page.isSpatial() && draw());
})(StickslipPage);
