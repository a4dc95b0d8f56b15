// SPDX-License-Identifier: GPL-3.0-or-later
//
// The grasp file as text that can be changed here and there: numbers that nobody touched stay as they are spelled.
(function (page) {
  /** A number as the file spells it. */
  class Spelled {
    constructor(text) {
      this.text = text;
    }
    toString() {
      return this.text;
    }
  }
  page.Spelled = Spelled;

  /** JSON.parse, but for numbers, which become Spelled. The text is known to be JSON. */
  function read(text) {
    let at = 0;
    const blank = /[ \t\r\n]*/y;
    const token = /"(?:[^"\\]|\\.)*"|-?\d+(?:\.\d+)?(?:[eE][+-]?\d+)?|true|false|null|[[\]{}:,]/y;
    const next = function () {
      blank.lastIndex = at;
      blank.exec(text);
      token.lastIndex = blank.lastIndex;
      const found = token.exec(text);
      if (!found) throw new SyntaxError("not JSON");
      at = token.lastIndex;
      return found[0];
    };
    const value = function (first) {
      if (first === "{") {
        const object = {};
        for (let key = next(); key !== "}"; key = next()) {
          if (key === ",") continue;
          next(); // the colon
          object[JSON.parse(key)] = value(next());
        }
        return object;
      }
      if (first === "[") {
        const array = [];
        for (let entry = next(); entry !== "]"; entry = next()) if (entry !== ",") array.push(value(entry));
        return array;
      }
      return /^[-\d]/.test(first) ? new Spelled(first) : JSON.parse(first);
    };
    return value(next());
  }

  function write(value) {
    if (value instanceof Spelled) return value.text;
    if (Array.isArray(value)) return "[" + value.map(write).join(", ") + "]";
    if (value !== null && typeof value === "object") {
      return (
        "{" +
        Object.entries(value)
          .map(([key, entry]) => JSON.stringify(key) + ": " + write(entry))
          .join(", ") +
        "}"
      );
    }
    return JSON.stringify(value);
  }

  /** One contact a line, as stickslip writes files. */
  function writeFile(file) {
    const lines = Object.entries(file).map(([key, value]) => {
      const list = key === "contacts" || key === "cases" ? value : null;
      return (
        JSON.stringify(key) +
        ": " +
        (list && list.length > 0 ? "[\n" + list.map((entry) => "  " + write(entry)).join(",\n") + "]" : write(value))
      );
    });
    return "{" + lines.join(",\n ") + "}\n";
  }

  let source = "";
  let file = null;
  const changed = function () {
    source = writeFile(file);
  };
  const spell = (number) => new Spelled(String(number));

  /** A number near what is spelled. */
  const double = function (spelled) {
    const [over, under = 1] = String(spelled).split("/");
    return Number(over) / Number(under);
  };

  /** For drawing: a body's triangles, each three points, and the corners of the box around it. */
  function solidOf(body) {
    const vertices = body.vertices.map((vertex) => vertex.map(double));
    const faces = body.faces.map((face) => face.map((v) => vertices[double(v)]));
    const ends = (choose) =>
      [0, 1, 2].map((j) => vertices.reduce((end, vertex) => choose(end, vertex[j]), vertices[0][j]));
    const written = new Spelled(write(body));
    return {
      triangles: faces.flatMap((face) => face.slice(2).map((point, k) => [face[0], face[k + 1], point])),
      ends: [ends(Math.min), ends(Math.max)],
      size: page.count(vertices.length, "vertex", "vertices") + " and " + page.count(faces.length, "face"),
      written,
      // That a link is to a grasp with this body.
      mark: [...written.text].reduce((sum, c) => (31 * sum + c.charCodeAt(0)) % 4294967291, 7),
    };
  }

  page.solids = []; // by body what a file gave of it in space; what is sketched is not there
  /** Which they are, in short; undefined without any. */
  page.solidsMark = () => (page.solids.some(Boolean) ? page.solids.map((solid) => solid && solid.mark).join() : undefined);
  page.grasp = {
    /** Bodies in the file become those of the page. A file without leaves them: what is asked and answered has none. */
    load(text) {
      source = text;
      try {
        file = read(text);
      } catch (error) {
        file = null;
      }
      if (!file) return;
      let found = false;
      const take = function (of, key, b) {
        if (!of[key]) return of;
        const { [key]: solid, ...rest } = of;
        page.solids[b] = solidOf(solid);
        found = true;
        return rest;
      };
      if (file.bodies) file = { ...file, bodies: file.bodies.map((body, b) => take(body, "mesh", b)) };
      else file = take(file, "body", 0);
      if (found) changed();
    },
    /** The file without the bodies in space. */
    text: () => source,
    /** The file with them. */
    whole() {
      if (!page.solids.some(Boolean) || !page.isSpatial()) return source;
      if (file.bodies) {
        const whole = (body, b) => (page.solids[b] ? { ...body, mesh: page.solids[b].written } : body);
        return writeFile({ ...file, bodies: file.bodies.map(whole) });
      }
      const entries = Object.entries(file);
      entries.splice(
        entries.findIndex(([key]) => key === "contacts"),
        0,
        ["body", page.solids[0].written],
      );
      return writeFile(Object.fromEntries(entries));
    },
    units: () => (file && file.units) || null,
    contacts: () => (file ? file.contacts : []),
    /** Of ring r, counted through the whole outline: its polygon, and whether it is a hole. */
    ringPlace(r) {
      const isPoint = (value) => Array.isArray(value) && !Array.isArray(value[0]);
      let polygons = file.outline;
      if (isPoint(polygons[0])) polygons = [[polygons]];
      else if (isPoint(polygons[0][0])) polygons = [polygons];
      for (let polygon = 0; ; ++polygon) {
        if (r < polygons[polygon].length) return [polygon, r > 0];
        r -= polygons[polygon].length;
      }
    },
    /** A coordinate of a contact as spelled, or null. */
    position(i, j) {
      const { position } = file.contacts[i];
      if (!position) return null;
      return position[j] instanceof Spelled
        ? position[j].text
        : typeof position[j] === "string"
          ? JSON.stringify(position[j])
          : null;
    },
    /** Of a contact, as the file spells it: a text, an interval, or null. */
    value(i, key) {
      const contact = file.contacts[i];
      const value = contact[key] !== undefined ? contact[key] : (file.defaults || {})[key];
      if (value === undefined) return { friction: null, stiffness: "1", preload: "0" }[key];
      return typeof value === "object" && !(value instanceof Spelled) ? value : String(value);
    },
    /** Sets a number of contact i, or of all contacts where i is null. */
    set(i, key, number) {
      if (i !== null) {
        file.contacts[i][key] = spell(number);
      } else {
        file.defaults = { ...(file.defaults || {}), [key]: spell(number) };
        for (const contact of file.contacts) delete contact[key];
        // What was not there stands before the contacts, where people look for it.
        const { contacts, ...rest } = file;
        file = Object.fromEntries(
          Object.entries(rest).flatMap(([k, v]) =>
            k === "defaults"
              ? [
                  [k, v],
                  ["contacts", contacts],
                ]
              : [[k, v]],
          ),
        );
      }
      changed();
    },
    place(i, position, normal = null) {
      const contact = file.contacts[i];
      const old = page.answer.contacts[i];
      const keeps = normal || (contact.normal === undefined ? page.unitNormal(old.normal) : null);
      const { on, position: before, normal: turned, ...rest } = contact;
      file.contacts[i] = { position: position.map(spell), normal: keeps ? keeps.map(spell) : turned, ...rest };
      changed();
    },
    placeOn(i, polygon, edge, share) {
      const { on, position, normal, ...rest } = file.contacts[i];
      const place =
        polygon === 0
          ? [spell(edge), spell(share)]
          : { polygon: spell(polygon), edge: spell(edge), share: spell(share) };
      file.contacts[i] = { on: place, ...rest };
      changed();
    },
    /** The load as one wrench, in place of loads and cases. */
    setWrench(wrench) {
      const { loads, cases, wrench: old, ...rest } = file;
      file = { ...rest, wrench: wrench.map(spell) };
      changed();
    },
  };

  /** A normal of rational length near a direction, in small integers: (n^2 - k^2, 2 k n) for a turn of half the angle. */
  page.unitNormal = function (normal) {
    if (normal.length === 3) return normal.map((x) => page.decimal(x, 0.001));
    const kSteps = 32;
    const angle = Math.atan2(normal[1], normal[0]);
    // Quarter turns are exact, so what is left is at most 45 degrees.
    const quarters = Math.round(angle / (Math.PI / 2));
    const k = Math.round(kSteps * Math.tan((angle - (quarters * Math.PI) / 2) / 2));
    let v = [kSteps * kSteps - k * k, 2 * k * kSteps];
    const gcd = (a, b) => (b === 0 ? Math.abs(a) : gcd(b, a % b));
    const common = gcd(v[0], v[1]);
    v = v.map((x) => x / common);
    for (let turn = 0; turn < ((quarters % 4) + 4) % 4; ++turn) v = [-v[1], v[0]];
    return v.map((x) => x + 0);
  };
})(StickslipPage);
