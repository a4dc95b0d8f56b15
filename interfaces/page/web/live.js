// SPDX-License-Identifier: GPL-3.0-or-later
//
// The live page: what is dragged or typed changes the grasp file, and the server answers about it. One request is under way at
// a time, and what was asked last comes next. Nothing here decides anything.
(function (page) {
  const { html, svg, vector } = page;
  const kParts = ["decide", "states", "region", "margin", "map"];
  const kSlow = 150; // milliseconds: if answers take longer, only the verdict follows a drag
  const kLate = 1000; // milliseconds after which a verdict is given up for that of a newer grasp
  const kRest = 250; // milliseconds without a change until what takes longer is asked for
  const kUncertain = ["0", "5%", "10%", "20%", "50%"];

  let options = {}; // of the question
  let version = 0; // of the grasp and the options
  const versions = Object.fromEntries(kParts.map((part) => [part, 0])); // what the parts that are shown are about
  let resting = true; // nothing moves: then warnings are looked for, which takes longer than the verdict
  let wanted = null; // the parts that are asked for next
  let underWay = null; // {parts, abort}
  let restTimer = null;
  let lateTimer = null;
  let slow = false;
  let dragging = null;

  // Asking.

  /** What can be asked for while something moves, and what takes longer. */
  const quick = () => (slow || page.isSpatial() || page.mechanism() ? ["decide"] : kParts.slice(0, 4));
  const kOfSeveral = ["decide", "margin"];
  const kInSpace = [...kOfSeveral, "region"];
  /** Which parts can be had at all. */
  const parts = () => (page.mechanism() ? kOfSeveral : page.isSpatial() ? kInSpace : kParts);
  const isLong = (parts) => !parts.includes("decide");
  /** The parts that are about another grasp than the present one. */
  const missing = () => parts().filter((part) => versions[part] !== version);

  function change() {
    ++version;
    resting = false;
    ask(quick());
  }

  function ask(parts) {
    wanted = parts;
    clearTimeout(restTimer);
    document.body.classList.add("busy");
    if (!underWay) send();
    else if (isLong(underWay.parts)) underWay.abort.abort(); // the verdict does not wait for a map
    else giveUpLate();
  }

  /** What is under way is not waited for beyond kLate if something newer is asked. */
  function giveUpLate() {
    const old = underWay;
    clearTimeout(lateTimer);
    lateTimer = setTimeout(() => wanted && underWay === old && old.abort.abort(), old.start + kLate - performance.now());
  }

  async function send() {
    while (wanted) {
      const start = performance.now();
      underWay = { parts: wanted, version, abort: new AbortController(), start };
      wanted = null;
      const { parts } = underWay;
      const decidingTimer = isLong(parts) ? null : setTimeout(() => (page.find("deciding").hidden = false), kSlow);
      try {
        const reply = await fetch("/answer", {
          method: "POST",
          headers: { "Content-Type": "application/json" },
          body: JSON.stringify({ grasp: page.grasp.text(), options: { ...options, snap: true, warnings: resting }, parts }),
          signal: underWay.abort.signal,
        });
        const answer = await reply.json();
        if (!resting) slow = performance.now() - start > kSlow;
        if (answer.error) {
          say(answer.error.place ? answer.error.place + ": " + answer.error.message : answer.error.message);
        } else take(answer);
      } catch (error) {
        if (error.name !== "AbortError") say("The server does not answer. Is `stickslip serve` still running?");
      }
      clearTimeout(decidingTimer);
      // As long as verdicts come late, the word stays.
      if (!wanted) page.find("deciding").hidden = true;
    }
    underWay = null;
    document.body.classList.remove("busy");
    remember();
    if (versions.decide === version && (!resting || missing().length > 0)) restTimer = setTimeout(rest, kRest);
  }

  function rest() {
    const parts = resting ? missing() : ["decide"];
    resting = true;
    ask(parts);
  }

  function say(message) {
    page.put("live-error", message ? html("span", {}, message) : null);
    for (const id of ["verdict", "why"]) page.find(id).classList.toggle("stale", Boolean(message));
  }

  /** Shows an answer; parts that were not asked for stay, marked if they are about another grasp. */
  function take(answer) {
    say("");
    for (const part of underWay.parts) versions[part] = underWay.version;
    const answered = { ...page.answer, ...answer };
    // What was said of parts that were not asked for now still holds.
    const others = kParts.filter((part) => !underWay.parts.includes(part));
    const said = page.answer.messages.filter((message) => others.some((part) => message.startsWith(part + ":")));
    answered.messages = [...said, ...answer.messages];
    // What was changed meanwhile is not undone.
    if (underWay.version !== version) {
      page.answer = { ...answered, contacts: answer.contacts, wrench: answer.wrench };
      if (dragging) dragging.preview();
      page.draw();
    } else {
      page.setAnswer(answered);
    }
    controls();
    for (const part of kParts) {
      const panel = page.find((part === "states" ? "sphere" : part === "decide" ? "why" : part) + "-panel");
      panel.classList.toggle("stale", missing().includes(part));
    }
  }

  /** The grasp in the link of the page. */
  function remember() {
    // The body may be long, and is here anyway.
    const body = page.isSpatial() ? page.solidsMark() : undefined;
    const bytes = new TextEncoder().encode(JSON.stringify({ grasp: page.grasp.text(), options, body }));
    const text = btoa(String.fromCharCode(...bytes))
      .replace(/\+/g, "-")
      .replace(/\//g, "_")
      .replace(/=+$/, "");
    history.replaceState(null, "", "#" + text);
  }

  function remembered() {
    if (location.hash.length < 2) return null;
    try {
      const text = atob(location.hash.slice(1).replace(/-/g, "+").replace(/_/g, "/"));
      const found = JSON.parse(new TextDecoder().decode(Uint8Array.from(text, (c) => c.charCodeAt(0))));
      return typeof found.grasp === "string" && found.options ? found : null;
    } catch (error) {
      return null;
    }
  }

  // Dragging in the drawing of the body.

  /** Steps that numbers are multiples of, so that what is sent is short. */
  const step = (size) => page.roundDown(size / 100);

  /** The nearest place of the outline: {polygon, edge, share, position, normal}, or null without an outline. */
  function onOutline(point) {
    const rings = page.answer.outline;
    if (!rings || rings.length === 0) return null;
    let best = null;
    const areas = rings.map((ring) =>
      ring.reduce((sum, p, k) => {
        const q = ring[(k + 1) % ring.length];
        return sum + p[0] * q[1] - p[1] * q[0];
      }, 0),
    );
    let first = 0; // edge of the ring in its polygon
    rings.forEach((ring, r) => {
      const [polygon, hole] = page.grasp.ringPlace(r);
      if (!hole) first = 0;
      ring.forEach((from, k) => {
        const to = ring[(k + 1) % ring.length];
        const along = vector.add(to, -1, from);
        const share = Math.min(
          1,
          Math.max(0, vector.dot(vector.add(point, -1, from), along) / vector.dot(along, along)),
        );
        const position = vector.add(from, share, along);
        const away = Math.hypot(...vector.add(point, -1, position));
        if (best && away >= best.away) return;
        const inwards = areas[r] < 0 !== hole ? -1 : 1;
        best = {
          away,
          polygon,
          edge: first + k,
          share: Number(share.toFixed(3)),
          position,
          normal: vector.unit([-along[1] * inwards, along[0] * inwards]),
        };
      });
      first += ring.length;
    });
    return best;
  }

  function moveContact(i, point) {
    const contact = page.answer.contacts[i];
    const place = onOutline(point);
    if (place) {
      page.grasp.placeOn(i, place.polygon, place.edge, place.share);
      Object.assign(contact, { position: place.position, normal: place.normal });
    } else {
      const by = step(page.frame().radius);
      const position = point.map((x) => page.decimal(x, by));
      page.grasp.place(i, position);
      contact.position = position.map(Number);
    }
  }

  function turnNormal(i, direction) {
    const normal = page.unitNormal(direction);
    const contact = page.answer.contacts[i];
    const position = contact.position.map((x, j) => page.grasp.position(i, j) || String(x));
    page.grasp.place(i, position, normal);
    contact.normal = vector.unit(normal);
  }

  // In space: contacts run over the body, and the load acts at a point that is dragged, too.

  let loadAt = null; // that point; null: the middle of the drawing
  page.loadPoint = () => loadAt || page.actsAt(page.load(), (page.keepView || { frame: page.frame() }).frame);
  const kFine = 1e-4; // of a size: of places on the body
  const kFineNormal = 1e-6;

  function placeInSpace(i, place) {
    if (!place) return;
    const by = page.roundDown(kFine * page.bodyView().frame.radius);
    const position = place.position.map((x) => page.decimal(x, by));
    const normal = place.normal.map((x) => page.decimal(x, kFineNormal));
    page.grasp.place(i, position, normal);
    Object.assign(page.answer.contacts[i], { position: position.map(Number), normal: normal.map(Number) });
  }

  const crossed = ([a, b, c], [x, y, z]) => [
    b.times(z).minus(c.times(y)),
    c.times(x).minus(a.times(z)),
    a.times(y).minus(b.times(x)),
  ];
  const fractions = (numbers) => numbers.map((x) => page.Fraction.of(x));
  const spelledExactly = (x) =>
    page.Fraction.of(x.toNumber()).minus(x).sign() === 0 ? String(x.toNumber()) : JSON.stringify(x.toString());

  /** The load as it is, of a force at a point and a torque about it: a drag begins there, whatever is answered meanwhile. */
  function presentLoad() {
    const [load, point] = [fractions(page.load()), fractions(page.loadPoint())];
    const [force, arm] = [load.slice(0, 3), crossed(point, load.slice(0, 3))];
    return { force, point, torque: load.slice(3).map((t, j) => t.minus(arm[j])) };
  }
  function setLoadInSpace({ force, point, torque }) {
    const arm = crossed(point, force);
    setLoad([...force, ...torque.map((t, j) => t.plus(arm[j]))].map(spelledExactly));
  }
  function setForceInSpace(start, force) {
    const most = Math.max(...[...force, ...start.force.map((x) => x.toNumber())].map(Math.abs), 1e-12);
    const near = (f, j) => (f === start.force[j].toNumber() ? start.force[j] : page.decimal(f, step(most)));
    setLoadInSpace({ ...start, force: fractions(force.map(near)) });
  }
  function moveLoad(start, place) {
    const point = fractions(place.map((x) => page.decimal(x, step(page.bodyView().frame.radius))));
    setLoadInSpace({ ...start, point });
    loadAt = point.map((x) => x.toNumber());
  }

  /** On the canvas; places are pixels there. */
  function handlesInSpace(view) {
    const make = (name, at, radius, label, drag) => {
      const [x, y] = at;
      const keys = (arrow) => drag([x + kPixels * arrow[0], y - kPixels * arrow[1]], true);
      return handle(name, at, radius, label, "space", (pixel) => pixel, drag, keys);
    };
    const circles = view.contacts.map((contact, i) =>
      make("contact-" + i, view.place(contact.position), 14, "Contact " + i + ": arrow keys move it", (pixel, byKey) =>
        placeInSpace(i, view.onBody(pixel, byKey ? contact.position : null)),
      ),
    );
    if (!view.load) return circles;
    const { tail, tip, isForce } = view.load;
    const start = presentLoad();
    if (isForce)
      circles.push(
        make("load-point", view.place(tail), 9, "Point where the load acts: arrow keys move it", (pixel) =>
          moveLoad(start, view.besides(pixel, tail)),
        ),
      );
    const setTip = (pixel) =>
      setForceInSpace(
        start,
        vector.add(view.besides(pixel, tip), -1, tail).map((x) => x * view.perLength),
      );
    circles.push(make("load", view.place(tip), 12, "Load: arrow keys change its force", setTip));
    return circles;
  }
  const kPixels = 8; // of an arrow key

  // In the plane.

  /** Sets the force, and keeps the torque about the middle of the drawing. */
  function setForce(force) {
    const load = page.load();
    const { centre } = page.frame();
    const size = Math.max(...force.map(Math.abs), ...load.slice(0, 2).map(Math.abs), 1e-12);
    const [x, y] = force.map((f) => page.decimal(f, step(size)));
    const torque = load[2] + centre[0] * (Number(y) - load[1]) - centre[1] * (Number(x) - load[0]);
    setLoad([
      x,
      y,
      torque === load[2]
        ? spelledTorque()
        : page.decimal(torque, step(Math.max(Math.abs(torque), size * page.frame().radius))),
    ]);
  }
  function spelledTorque() {
    const { decide, wrench } = page.answer;
    const exact = decide && decide.wrench && decide.wrench[2];
    return typeof exact !== "string" || page.Fraction.of(exact).toNumber() !== wrench[2]
      ? String(wrench[2])
      : /^-?\d+$/.test(exact)
        ? exact
        : JSON.stringify(exact);
  }
  function setLoad(wrench) {
    delete options.wrench;
    delete options.case;
    page.grasp.setWrench(wrench);
    page.answer.wrench = wrench.map((w) => page.Fraction.of(String(w).replace(/"/g, "")).toNumber());
  }

  /** A circle that is dragged, or moved by arrow keys; `drawing` is where it is, and `unplace` what its places mean. */
  function handle(name, at, radius, label, drawing, unplace, drag, keys) {
    const element = svg("circle", {
      class: "handle",
      cx: at[0],
      cy: at[1],
      r: radius,
      tabindex: "0",
      role: "button",
      "aria-label": label,
      "data-handle": name,
      "data-choice": "handle-" + name,
    });
    element.addEventListener("pointerdown", (event) => begin(event, name, drawing, unplace, drag));
    element.addEventListener("keydown", (event) => {
      const kArrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
      if (!kArrows[event.key]) return;
      event.preventDefault();
      keys(kArrows[event.key]);
      page.draw();
      change();
    });
    return element;
  }

  /** In the drawing of the body: contacts, tips of normals, the tip of the load. */
  page.handles = function (view) {
    if (!page.answer.live || page.mechanism()) return null;
    if (page.isSpatial()) return handlesInSpace(view);
    const { unplace } = view;
    const fine = step(page.frame().radius) * 2;
    const circles = [];
    page.answer.contacts.forEach((contact, i) => {
      const at = view.place(contact.position);
      const normal = vector.unit(contact.normal);
      const tip = vector.add(at, 46, [normal[0], -normal[1]]);
      circles.push(
        handle(
          "normal-" + i,
          tip,
          8,
          "Normal of contact " + i + ": arrow keys turn it",
          "body",
          unplace,
          (p) => turnNormal(i, vector.add(p, -1, page.answer.contacts[i].position)),
          ([x, y]) => {
            const angle = Math.atan2(normal[1], normal[0]) + ((y || -x) * Math.PI) / 45;
            turnNormal(i, [Math.cos(angle), Math.sin(angle)]);
          },
        ),
      );
      circles.push(
        handle(
          "contact-" + i,
          at,
          14,
          "Contact " + i + ": arrow keys move it",
          "body",
          unplace,
          (p) => moveContact(i, p),
          (arrow) => moveContact(i, vector.add(contact.position, fine, arrow)),
        ),
      );
    });
    if (page.load() && view.loadTip) {
      const perPixel = view.forcePerPixel / view.loadFactor;
      const origin = view.place(view.frame.centre);
      circles.push(
        handle(
          "load",
          view.loadTip,
          12,
          "Load: arrow keys change its force",
          "body",
          unplace,
          (p) => {
            const at = view.place(p);
            setForce([(at[0] - origin[0]) * perPixel, (origin[1] - at[1]) * perPixel]);
          },
          nudgeForce,
        ),
      );
    }
    return circles;
  };

  function nudgeForce(arrow) {
    const force = page.load().slice(0, 2);
    setForce(vector.add(force, 5 * step(Math.max(...force.map(Math.abs)) || 1), arrow));
  }

  /** The present load in the region, where that is one of forces. */
  page.regionHandle = function (at, { plane }) {
    const axes = [plane.u, plane.v].map((v) => v.findIndex((x) => String(x) === "1"));
    const isForces = [plane.u, plane.v].every(
      (v, k) => axes[k] < v.length / 2 && v.every((x, j) => String(x) === (j === axes[k] ? "1" : "0")),
    );
    if (!page.answer.live || !isForces || (!page.isSpatial() && axes[0] > axes[1])) return null;
    const inSpace = () => {
      const start = presentLoad();
      const set = ([s, t]) => {
        const force = start.force.map((x) => x.toNumber());
        [force[axes[0]], force[axes[1]]] = [s, t];
        setForceInSpace(start, force);
      };
      const now = axes.map((j) => page.load()[j]);
      return [set, (arrow) => set(vector.add(now, 5 * step(Math.max(...page.load().slice(0, 3).map(Math.abs)) || 1), arrow))];
    };
    const [drag, keys] = page.isSpatial() ? inSpace() : [setForce, nudgeForce];
    const { unplace } = page.regionView();
    return handle("region-load", at, 12, "Load in the region: arrow keys change its force", "region", unplace, drag, keys);
  };

  function begin(event, name, drawing, unplace, drag) {
    event.preventDefault();
    const root = page.find(drawing);
    // Until it ends, a drag is measured in the drawing as it was when it began.
    const place = (e) => {
      const box = root.querySelector("svg").getBoundingClientRect();
      return unplace([e.clientX - box.left, e.clientY - box.top]);
    };
    let last = null;
    dragging = { preview: () => last && drag(last) };
    const move = function (e) {
      last = place(e);
      drag(last);
      page.drawBody(); // the rest follows with the answer
      change();
    };
    const end = function () {
      removeEventListener("pointermove", move);
      removeEventListener("pointerup", end);
      removeEventListener("pointercancel", end);
      dragging = page.keepView = page.keepHalf = null;
      page.draw();
    };
    page.keepView = page.bodyView();
    page.keepHalf = page.regionView() && page.regionView().half;
    addEventListener("pointermove", move);
    addEventListener("pointerup", end);
    addEventListener("pointercancel", end);
    const focusable = document.querySelector('[data-handle="' + name + '"]');
    if (focusable) focusable.focus({ preventScroll: true });
  }

  // Controls.

  let chosen = "all"; // the contact that friction and preload are set of
  let made = ""; // for what the controls were made

  function spelled(key) {
    const { contacts } = page.answer;
    const list = chosen === "all" ? contacts.map((_, i) => i) : [Number(chosen)];
    const values = [
      ...new Set(
        list
          .map((i) => page.grasp.value(i, key))
          .map((v) => (v && typeof v === "object" ? v.min + " to " + v.max : String(v))),
      ),
    ];
    return { near: list.length ? contacts[list[0]][key] : 0, text: values.length === 1 ? values[0] : "", values };
  }

  function field(key, name, most) {
    const id = "live-" + key;
    const set = (value) => {
      if (!/^\d+(\.\d+)?$/.test(value)) return;
      page.grasp.set(chosen === "all" ? null : Number(chosen), key, value);
      const near = Number(value);
      page.answer.contacts.forEach((contact, i) => {
        if (chosen === "all" || Number(chosen) === i) contact[key] = near;
      });
      for (const element of [page.find(id), page.find(id + "-range")])
        if (element !== document.activeElement) element.value = value;
      page.draw();
      change();
    };
    return html(
      "div",
      { class: "field" },
      html("label", { for: id }, name),
      html("input", {
        type: "range",
        id: id + "-range",
        min: "0",
        max: String(most),
        step: String(step(most)),
        "aria-label": name,
        oninput: (event) => set(page.decimal(Number(event.target.value), step(most))),
      }),
      html("input", {
        type: "number",
        id,
        min: "0",
        step: String(step(most)),
        oninput: (event) => set(event.target.value),
      }),
    );
  }

  function uncertainField(key, name) {
    return html(
      "div",
      { class: "field" },
      html("label", { for: "live-uncertain-" + key }, name + " \u00B1"),
      html(
        "select",
        {
          id: "live-uncertain-" + key,
          onchange: () => {
            const tolerances = ["friction", "preload"]
              .map((k) => [k, page.find("live-uncertain-" + k).value])
              .filter(([, t]) => t !== "0");
            if (tolerances.length > 0) options.uncertain = tolerances.map((pair) => pair.join("=")).join(",");
            else delete options.uncertain;
            change();
          },
        },
        kUncertain.map((t) => html("option", { value: t }, t === "0" ? "known exactly" : t)),
      ),
    );
  }

  function make() {
    const { answer } = page;
    const most = { friction: Math.max(1.5, ...answer.contacts.map((c) => 2 * c.friction)), preload: 0 };
    const size = Math.max(
      ...answer.contacts.map((c) => c.preload),
      ...(page.load() || [0]).filter((_, j) => page.mechanism() || j < (answer.dimension === 3 ? 2 : 3)).map(Math.abs),
      0.5,
    );
    most.preload = page.roundDown(2 * size * 1.6);
    const names = page.mechanism()
      ? page.mechanism().coordinates
      : answer.dimension === 3
        ? ["force x", "force y", "torque"]
        : ["force x", "force y", "force z", "torque x", "torque y", "torque z"];
    page.put(
      "live",
      html(
        "p",
        { class: "muted" },
        page.mechanism()
          ? "Of several bodies nothing is dragged: friction, preloads and the load of each coordinate are set here."
          : answer.dimension === 3
          ? "Drag a contact, the ring on its normal, or the tip of the load, also that in the region below; " +
              "or go to them with Tab, and use the arrow keys."
          : "Drag a contact over the body, the tip of the load, also that in the region below, or the point where it acts; " +
              "or go to them with Tab, and use the arrow keys. Beside them the mouse turns the body.",
      ),
      html(
        "div",
        { class: "controls" },
        html(
          "fieldset",
          {},
          html("legend", {}, "Contacts"),
          html(
            "div",
            { class: "field" },
            html("label", { for: "live-contact" }, "of"),
            html(
              "select",
              {
                id: "live-contact",
                onchange: (event) => {
                  chosen = event.target.value;
                  controls();
                },
              },
              html("option", { value: "all" }, "all contacts"),
              answer.contacts.map((_, i) => html("option", { value: String(i) }, "contact " + i)),
            ),
          ),
          field("friction", "friction \u03BC", page.decimal(most.friction, 0.5)),
          field("preload", "preload", most.preload),
        ),
        html(
          "fieldset",
          {},
          html("legend", {}, "Uncertain by"),
          uncertainField("friction", "friction"),
          uncertainField("preload", "preload"),
        ),
        html(
          "fieldset",
          {},
          html("legend", {}, "Load"),
          html(
            "div",
            { class: "triple" },
            names.map((name, j) =>
              html(
                "label",
                {},
                name,
                html("input", {
                  type: "text",
                  inputmode: "decimal",
                  id: "live-load-" + j,
                  onchange: () => {
                    const texts = names.map((_, k) =>
                      page
                        .find("live-load-" + k)
                        .value.trim()
                        .replace(/\u2212/g, "-"),
                    );
                    try {
                      const wrench = texts.map((text) => page.Fraction.of(text));
                      page.grasp.setWrench(
                        texts.map((text, k) =>
                          /^-?\d+(\.\d+)?$/.test(text) ? text : JSON.stringify(wrench[k].toString()),
                        ),
                      );
                      page.answer.wrench = wrench.map((w) => w.toNumber());
                      delete options.wrench;
                      delete options.case;
                      change();
                    } catch (error) {
                      say(String(error.message));
                    }
                  },
                }),
              ),
            ),
          ),
        ),
        casesField(answer),
        html(
          "div",
          { class: "row" },
          html("button", { type: "button", id: "live-link", onclick: copyLink }, "Copy a link to this grasp"),
          html("span", { id: "live-linked", role: "status" }),
        ),
      ),
    );
  }

  function casesField(answer) {
    if (!answer.cases || answer.cases.length === 0) return null;
    return html(
      "div",
      { class: "field" },
      html("label", { for: "live-case" }, "case"),
      html(
        "select",
        {
          id: "live-case",
          onchange: (event) => {
            options.case = event.target.value;
            delete options.wrench;
            change();
          },
        },
        answer.cases.map((name) => html("option", { value: name }, name)),
      ),
    );
  }

  async function copyLink() {
    remember();
    try {
      await navigator.clipboard.writeText(location.href);
      page.find("live-linked").textContent = "copied";
    } catch (error) {
      page.find("live-linked").textContent = "the link is in the address bar";
    }
  }

  /** The controls say what is: all but what is being typed. */
  function controls() {
    const { dimension, contacts, mechanism } = page.answer;
    const wanted = [mechanism ? mechanism.coordinates : dimension, contacts.length].join(" ");
    if (made !== wanted) make();
    made = wanted;
    const put = (id, value) => {
      const element = page.find(id);
      if (element && element !== document.activeElement) element.value = value;
    };
    for (const key of ["friction", "preload"]) {
      const { near, text, values } = spelled(key);
      const number = /^\d+(\.\d+)?$/.test(text) ? text : values.length === 1 ? page.decimal(near, 0.0001) : "";
      put("live-" + key, number);
      page.find("live-" + key).placeholder = values.length > 1 ? "differ" : text;
      put("live-" + key + "-range", String(near));
    }
    const wrench = page.answer.decide && page.answer.decide.wrench;
    (page.load() || []).forEach((w, j) =>
      put("live-load-" + j, wrench && typeof wrench[j] === "string" && !options.uncertain ? wrench[j] : String(w)),
    );
    if (page.answer.decide && page.answer.decide.case) put("live-case", page.answer.decide.case);
  }

  page.startLive = function () {
    page.find("live-panel").hidden = false;
    // The controls make the second column longer.
    page.find("exact-panel").before(page.find("map-panel"));
    const asked = page.answer.question || {};
    options = Object.fromEntries(
      ["wrench", "case", "preload", "normal_law", "uncertain"]
        .filter((key) => asked[key])
        .map((key) => [key, asked[key]]),
    );
    if (options.preload !== undefined) {
      // From now on the file says it.
      page.grasp.set(
        null,
        "preload",
        /^\d+(\.\d+)?$/.test(options.preload) ? options.preload : JSON.stringify(options.preload),
      );
      delete options.preload;
    }
    controls();
    for (const kind of (options.uncertain || "").split(",").filter(Boolean)) {
      const [key, tolerance] = kind.split("=");
      if (page.find("live-uncertain-" + key)) page.find("live-uncertain-" + key).value = tolerance;
    }
    const found = remembered();
    if (found) {
      page.grasp.load(found.grasp);
      options = found.options;
      if (page.solidsMark() !== found.body) page.solids = [];
      change();
    } else {
      // The server begins with the verdict.
      for (const part of kParts) if (page.answer[part] === undefined) versions[part] = -1;
      if (missing().length > 0) ask(missing());
    }
  };
})(StickslipPage);
