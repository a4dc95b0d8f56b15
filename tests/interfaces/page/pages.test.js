// SPDX-License-Identifier: GPL-3.0-or-later
//
// Pages of every verdict are drawn, to the last of their parts. Answers are those of the program, or such with parts put in
// their place that it can give.
"use strict";

const assert = require("node:assert");
const { execFileSync } = require("node:child_process");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const { test } = require("node:test");
const { open } = require("./document.js");

const ROOT = path.join(__dirname, "..", "..", "..");
const FIG1 = path.join(ROOT, "paper_examples", "grasps", "fig1.json");
const example = (name) => path.join(ROOT, "examples", "grasps", name + ".json");

const pages = new Map();
/** The page of a grasp file, and its answer. Its verdict has all the time that it takes, other parts a second: of grasps in space
 *  and of several bodies they take many, and are looked at where pageWithin() asks for them. */
function pageOf(grasp, ...options) {
  return pageWithin("1", grasp, ...options);
}

/** Each part is given up after so many seconds. */
function pageWithin(seconds, grasp, ...options) {
  const words = ["page", grasp, "--time-limit", seconds, ...options];
  const key = words.join(" ");
  if (!pages.has(key)) {
    const text = execFileSync(process.env.STICKSLIP, words, { encoding: "utf-8", maxBuffer: 1e8 });
    pages.set(key, { text, answer: JSON.parse(/id="answer">(.*?)<\/script>/s.exec(text)[1]) });
  }
  return pages.get(key);
}

/** Opens it with these parts of the answer in the place of its own. */
function openWith({ text, answer }, parts = {}) {
  return open(text, { ...answer, ...parts });
}

const kPlanar = ["60", FIG1, "--wrench", "0,1/2,0"];
const kSpatial = ["5", example("space-cup")];
/** What else than stable may be said; without a proof but of the unstable. */
const kNoProof = { certificate: null, near: null };
function undecided({ answer }) {
  const { verdict, twist, twist_float, contacts, near, proof, ...rest } = answer.decide;
  const quality = { ...answer.quality, verdict: "undecided", proved: "0", refuted: null };
  delete quality.not_resisted;
  return { decide: { ...rest, verdict: "undecided", limit: "the node limit of 1" }, quality, lost: null, ...kNoProof };
}

/** Everything is drawn, and nothing but what there is. */
function isWhole(opened, answer, verdict) {
  const { find, text, page, root } = opened;
  assert.strictEqual(find("#verdict").dataset.verdict, verdict);
  assert.ok(find("#contacts table"), "the table of contacts");
  assert.strictEqual(find("#proof-panel").shown, Boolean(answer.certificate), "a proof is offered where there is one");
  assert.strictEqual(find("#check").shown, Boolean(answer.certificate));
  assert.strictEqual(find("#margin-panel").shown, Boolean(answer.margin));
  assert.strictEqual(find("#compare-panel").shown, Boolean(answer.compare));
  assert.strictEqual(find("#body-legend").shown, true);
  if (answer.dimension === 6) {
    assert.ok(page.spaceState().drawn > answer.contacts.length, "contacts are in the scene");
    assert.ok(opened.rendered() > 0, "the scene is drawn");
  } else assert.ok(find("#body path.body"));
  for (const element of root.querySelectorAll("[d]")) assert.doesNotMatch(element.getAttribute("d"), /NaN|undefined/);
  assert.doesNotMatch(text("main"), /undefined|NaN|\bnull\b|\[object/);
}

for (const [name, grasp] of Object.entries({ "in the plane": kPlanar, "in space": kSpatial })) {
  test("a stable grasp " + name, () => {
    const made = pageWithin(...grasp);
    isWhole(openWith(made), made.answer, "stable");
  });

  test("an undecided grasp " + name + ", of which nothing is known", () => {
    const made = pageWithin(...grasp);
    const parts = undecided(made);
    const margin = { ...made.answer.margin, resisted: [], refuted: [], least: null, unbounded: false };
    for (const float of ["resisted_float", "refuted_float", "least_float"]) delete margin[float];
    if (name === "in the plane") delete margin.refuted;
    for (const given of [margin, null]) {
      const opened = openWith(made, { ...parts, margin: given });
      isWhole(opened, { ...made.answer, ...parts, margin: given }, "undecided");
      assert.match(opened.text("#why"), /the node limit of 1/);
      assert.strictEqual(opened.find("#choice").shown, false);
    }
  });

  test("a fragile grasp " + name, () => {
    const made = pageWithin(...grasp, "--uncertain", "friction=95%");
    assert.strictEqual(made.answer.decide.verdict, "fragile");
    const opened = openWith(made);
    isWhole(opened, made.answer, "fragile");
    assert.match(opened.text("#why"), /stable at .*unstable at /);
    // Its two grasps, each with a proof that is accepted, and back.
    for (const verdict of ["stable", "unstable"]) {
      opened.find(`[data-choice="grasp-${verdict}"]`).click();
      isWhole(opened, opened.page.answer, verdict);
      assert.strictEqual(opened.page.checkProof().answer, "accepted");
      assert.match(opened.text("#verdict"), /one grasp of the box/);
      assert.strictEqual(opened.find(`[data-choice="grasp-${verdict}"]`).getAttribute("aria-pressed"), "true");
      assert.strictEqual(opened.page.grasp.text(), made.answer.examples[verdict].grasp);
    }
    opened.find('[data-choice="grasp-box"]').click();
    isWhole(opened, made.answer, "fragile");
    assert.doesNotMatch(opened.text("#verdict"), /one grasp of the box/);
  });
}

test("an unstable grasp in the plane", () => {
  const made = pageOf(FIG1, "--wrench", "0,11/10,0");
  isWhole(openWith(made), made.answer, "unstable");
});

test("a tower of more coordinates than the checker reads", () => {
  const names = Array.from({ length: 11 }, (_, k) => "b" + k);
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "page-")), "tower.json");
  const contacts = names.flatMap((of, k) =>
    [-1, 1].map((x) => ({ of, by: k ? names[k - 1] : "ground", position: [x, k], normal: [0, 1], friction: 1 })),
  );
  const loads = names.map((body, k) => ({ body, weight: 1, at: [0, k] }));
  fs.writeFileSync(file, JSON.stringify({ format: "stickslip-grasp/3", bodies: names.map((name) => ({ name })), contacts, loads }));
  const { page } = openWith(pageOf(file));
  assert.strictEqual(page.answer.decide.verdict, "stable");
  assert.deepStrictEqual([page.checkProof().answer, page.checkProof().rule], ["not judged", undefined]);
});

test("a ball of loads", () => {
  const made = pageOf(FIG1, "--wrench", "0,11/10,0");
  const proof = JSON.parse(made.answer.certificate);
  proof.question.uncertain = { wrench: { ball: "1/100", length: 2, about: [1, 0] } };
  proof.tree = [["part", "wrench", 2, "1/200"], ...proof.tree, ...proof.tree];
  const opened = openWith(made, {
    question: { ...made.answer.question, uncertain: "friction=0,wrench=ball:1/100:length=2:about=1:0" },
    certificate: JSON.stringify(proof),
  });
  const { answer } = opened.page;
  isWhole(opened, answer, "unstable");
  assert.strictEqual(opened.page.checkProof().rule, "question-uncertain");
  answer.question.uncertain = answer.question.uncertain.replace("friction=0,", "");
  assert.strictEqual(opened.page.checkProof().answer, "accepted");
  const { leaves } = opened.page.refutation();
  assert.match(leaves[0].conditions[0], /the ball's z\[2\] at most/);
  assert.strictEqual(opened.page.drift(leaves[0]).work, null);
});

test("an unstable grasp in space", () => {
  const made = pageOf(example("space-book"), "--case", "too heavy");
  const opened = openWith(made);
  isWhole(opened, made.answer, "unstable");
  assert.strictEqual(opened.page.checkProof().answer, "accepted");
});

// Several bodies.

const corpus = (name) => path.join(ROOT, "tests", "corpus", "bodies", name + ".grasp.json");
const kSeveral = {
  "stacked": [[example("bodies-stack"), "--case", "pushed above"], "stable"],
  "stacked, of which one slides": [[example("bodies-stack"), "--case", "the upper one slides"], "unstable"],
  "stacked, with uncertain friction": [[example("bodies-stack"), "--case", "pushed above", "--uncertain", "friction=80%"], "fragile"],
  "that are links": [[example("bodies-gripper")], "stable"],
  "that are links, in a box": [[example("bodies-gripper"), "--uncertain", "friction=5%"], "stable"],
  "in space": [[example("bodies-hand")], "stable"],
  "on a slide in space": [[corpus("link_in_space_unstable")], "unstable"],
  "between soft fingers": [[example("bodies-cap"), "--case", "turned"], "stable"],
  "between soft fingers that slip": [[example("bodies-cap"), "--case", "tilts"], "unstable"],
  "without a contact": [[corpus("uncertain_spring_stable")], "stable"],
};
for (const [name, [grasp, verdict]] of Object.entries(kSeveral)) {
  test("several bodies " + name, () => {
    const made = pageOf(...grasp);
    const opened = openWith(made);
    const { answer } = made;
    if (answer.contacts.length > 0) isWhole(opened, answer, verdict);
    else assert.strictEqual(opened.find("#verdict").dataset.verdict, verdict);
    if (answer.certificate) assert.strictEqual(opened.page.checkProof().answer, "accepted");
    assert.match(opened.text("#why"), /states, region: there are several bodies/);
    assert.doesNotMatch(opened.text("main"), /undefined|NaN|\bnull\b|\[object/);
    for (const element of opened.root.querySelectorAll("[transform]"))
      assert.doesNotMatch(element.getAttribute("transform"), /NaN|undefined/);
    if (verdict !== "fragile") return;
    for (const one of ["stable", "unstable"]) {
      opened.find(`[data-choice="grasp-${one}"]`).click();
      isWhole(opened, opened.page.answer, one);
      assert.strictEqual(opened.page.checkProof().answer, "accepted");
    }
  });
}

/** The place of a point of the page after transformations of the plane, the last of them first. */
function transformed(text, point) {
  const matrices = [...text.matchAll(/matrix\(([^)]*)\)/g)].map((found) => found[1].split(" ").map(Number));
  return matrices.reduceRight(([x, y], [a, b, c, d, e, f]) => [a * x + c * y + e, b * x + d * y + f], point);
}
const away = (p, q) => Math.hypot(...p.map((x, j) => x - q[j]));

test("a soft finger has a moment, and opposes what turns about its normal", () => {
  const { root, page } = openWith(pageOf(example("bodies-cap"), "--case", "off centre"));
  // 18/5 about x, one half of it each.
  const moments = root.querySelectorAll("td[data-column]").filter((e) => e.dataset.column === "moment");
  assert.deepStrictEqual(moments.map((e) => e.textContent), ["(~1.8, 0, 0)", "(~1.8, 0, 0)"]);
  // About the line through both, on which no point of contact moves.
  const turn = { twist: ["0", "-1/2", "0", "-1", "0", "0"], slips: new Map(), open: new Set() };
  assert.deepStrictEqual([...page.drift(turn).opposing], [true, true]);
  page.answer.contacts.forEach((contact) => delete contact.torsion);
  assert.deepStrictEqual([...page.drift(turn).opposing], [false, false]);
});

test("links stay on their hinges, and move by their coordinates", () => {
  const made = pageOf(example("bodies-gripper"));
  const { page, root } = openWith(made);
  const { place, scale, frame } = page.bodyView();
  const ghosts = root.querySelectorAll(".moving").map((e) => e.getAttribute("transform"));
  assert.strictEqual(ghosts.length, 5);
  const [disc, l1, l2, r1, r2] = ghosts;
  for (const [link, on, hinge] of [
    [l1, "", [-2, -2]],
    [l2, l1, [-1.2, 0]],
    [r1, "", [2, -2]],
    [r2, r1, [1.2, 0]],
  ])
    assert.ok(away(transformed(link, place(hinge)), transformed(on, place(hinge))) < 1e-6);
  // The disc sinks by its coordinate, and a link's turn is all that it has of its own joint and of that before it.
  const factor = page.enlargement(page.motion().twist, frame);
  const z = Object.fromEntries(made.answer.decide.coordinates.map((name, j) => [name, made.answer.decide.twist_float[j]]));
  const sunk = transformed(disc, [0, 0])[1];
  assert.ok(Math.abs(sunk - (-z["disc.y"] * factor * scale) / frame.radius) < 1e-6);
  const turn = (text) => {
    const [from, to] = [[0, 0], [1, 0]].map((point) => transformed(text, point));
    return Math.atan2(from[1] - to[1], to[0] - from[0]);
  };
  assert.ok(Math.abs(turn(r2) - factor * (z.r1 + z.r2)) < 1e-9);
  assert.ok(Math.abs(turn(l1) + factor * z.l1) < 1e-9);
});

test("links stay on their hinges in space", () => {
  const { page } = openWith(pageOf(example("bodies-hand")));
  const state = page.spaceState();
  assert.deepStrictEqual([...state.bodies], [0, 1, 2, 3, 4, 5, 6]);
  const { frame } = page.bodyView();
  const moved = (m, p) => [0, 1, 2].map((j) => m[j] * p[0] + m[4 + j] * p[1] + m[8 + j] * p[2] + m[12 + j]);
  page.bodies().forEach(({ link }, b) => {
    if (!link) return;
    for (const along of [0, 1]) {
      const p = link.at.map((x, j) => (x + along * link.axis[j] - frame.centre[j]) / frame.radius);
      assert.ok(away(moved(state.moved[b], p), link.on === null ? p : moved(state.moved[link.on], p)) < 1e-6);
    }
  });
  assert.ok(away(moved(state.moved[2], [0, 0, 0]), [0, 0, 0]) > 0.01, "they move");
});

test("a load of several bodies is drawn at each, with what it turns", () => {
  const { page, root, text } = openWith(pageOf(example("bodies-stack"), "--case", "pushed above"));
  const arrows = () => root.querySelectorAll("path.load").map((e) => e.getAttribute("data-value")).filter(Boolean);
  assert.deepStrictEqual(arrows(), ["0,-10", "4,-10"]);
  // 4 at the height 3/2, the middle of the upper box.
  assert.doesNotMatch(text("#body-legend"), /torque/);
  page.answer.wrench = [0, -10, 1, 4, -10, -2];
  page.draw();
  assert.match(text("#body-legend"), /torque on low 1 N m/);
  assert.match(text("#body-legend"), /torque on up 4 N m/);
});

test("a load is drawn where it acts, without a torque beside it", () => {
  const contacts = [
    { position: [-1, 0], normal: [1, 0], preload: 9, friction: 1 },
    { position: [1, 0], normal: [-1, 0], preload: 9, friction: 1 },
  ];
  const planar = { format: "stickslip-grasp/2", contacts, loads: [{ weight: 2, at: ["1/2", "-1/4"] }] };
  const inSpace = (load) => ({
    format: "stickslip-grasp/2",
    contacts: contacts.map((c) => ({ ...c, position: [...c.position, 3], normal: [...c.normal, 0] })),
    ...load,
  });
  const at = { weight: 2, at: ["1/2", "1/4", 7] };
  for (const [grasp, place] of [
    [planar, [0.5, 0]],
    [inSpace({ loads: [at] }), [0.5, 0.25]],
    // Far away, or with a torque about itself, it stays in the middle.
    [inSpace({ loads: [{ ...at, at: [40, 0, 0] }] }), null],
    [inSpace({ loads: [at, { torque: [0, 0, 1] }] }), null],
  ]) {
    const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "load-")), "g.json");
    fs.writeFileSync(file, JSON.stringify(grasp));
    const { page, text } = openWith(pageOf(file));
    const frame = page.frame();
    const point = page.actsAt(page.load(), frame);
    if (place) place.forEach((x, j) => assert.ok(Math.abs(point[j] - x) < 1e-9, String(point)));
    else assert.deepStrictEqual(point, frame.centre);
    if (grasp === planar) assert.doesNotMatch(text("#body-legend"), /torque/);
  }
});

test("what is not known of a region in space is said", () => {
  const { text } = openWith(pageOf(example("space-corner")), { messages: ["states: the grasp is in space, and this is found in the plane only.", "region: not known within 1 second."] });
  assert.match(text("#why"), /region: not known within 1 second/);
  assert.doesNotMatch(text("#why"), /in the plane only/);
});

test("a length that is irrational makes no box", () => {
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "page-")), "cup.json");
  const contact = (position, normal) => ({ position, normal });
  fs.writeFileSync(
    file,
    JSON.stringify({
      format: "stickslip-grasp/1",
      defaults: { friction: "1/2", preload: 1 },
      contacts: [contact([-1, -1], [1, 1]), contact([1, -1], [-1, 1]), contact([0, 1], [0, -1])],
      wrench: [0, "-3/10", 0],
    }),
  );
  const opened = openWith(pageWithin("5", file));
  const words = opened.text("main");
  assert.match(opened.text("#verdict"), /Stable: the grasp holds this load/);
  assert.match(words, /normals of contacts 0 and 1 have irrational lengths \|n\|: P\/\|n\| was enclosed to 128 bits/);
  assert.match(words, /The body moves by nearly d =/);
  assert.match(opened.text("#margin-note"), /Resisted multiples λ of the load: \[0, .*found nearly here/s);
  assert.match(words, /region, map, compare: a preloaded contact has a normal of irrational length; `stickslip snap` writes/);
  assert.doesNotMatch(words, /box|all of them at once|more than one grasp/);
});

test("regions of every shape are drawn", () => {
  const contact = { position: [0, 0], normal: [0, 1], friction: 0 };
  const grasps = {
    "a point": [],
    "a ray": [contact],
    "a line": [contact, { ...contact, normal: [0, -1] }],
    "a cone": [{ ...contact, friction: 1 }],
    "all": [contact, { ...contact, normal: [0, -1] }].flatMap((c) =>
      [-1, 1].map((x) => ({ ...c, position: [x, 0], friction: 1, preload: 1 })),
    ),
  };
  for (const [name, contacts] of Object.entries(grasps)) {
    const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "page-")), "grasp.json");
    fs.writeFileSync(file, JSON.stringify({ format: "stickslip-grasp/1", name, contacts, wrench: [0, -1, 0] }));
    const made = pageWithin("5", file);
    fs.rmSync(path.dirname(file), { recursive: true });
    const { find, root } = openWith(made);
    assert.ok(made.answer.region, name);
    assert.ok(find("#region svg"), name);
    for (const element of root.querySelectorAll("[d]")) assert.doesNotMatch(element.getAttribute("d"), /NaN|undefined/, name);
  }
});

test("labels of points are all fractions, or all decimals with one mark", () => {
  const { page } = openWith(pageWithin(...kPlanar));
  assert.deepStrictEqual([...page.pointLabels([["-8/3", "2"], ["1/2", "0"]])], ["(\u22128/3, 2)", "(1/2, 0)"]);
  assert.deepStrictEqual(
    [...page.pointLabels([["-8/3", "2"], ["1/2", "0"], ["100/17", "123456/1000"]])],
    ["~(\u22122.667, 2)", "(0.5, 0)", "~(5.882, 123.5)"],
  );
});

test("what other methods say stands in a table, and where they disagree", () => {
  const made = pageWithin(...kPlanar);
  const { compare } = made.answer;
  const opened = openWith(made);
  const rows = opened.root.querySelectorAll("tr[data-method]");
  assert.deepStrictEqual(rows.map((row) => row.dataset.method), compare.methods.map(({ method }) => method));
  compare.methods.forEach((row, i) => {
    const cells = rows[i].querySelectorAll("td").map((cell) => cell.textContent.replace(/\u2212/g, "-"));
    assert.deepStrictEqual(cells, [row.verdict + (row.agrees === false ? ", unlike the passive model" : ""), row.why]);
  });
  assert.ok(compare.methods.some(({ agrees }) => agrees === false), "the example has methods that disagree");
  assert.match(opened.text("#compare"), /Torques are divided by 1; /);
  assert.match(opened.text("#compare"), /potential grasp robustness *0\.\d+ to 0\.\d+/);
});

// Margins.

const kMargin = { name: "", normal_law: "unilateral", least: null, unbounded: false, stats: {} };
/** What the page says and draws of a margin in space: the note, and bars as [kind, from, to] in multiples. */
function marginOf(resisted, refuted) {
  const made = pageWithin(...kSpatial);
  const opened = openWith(made, { margin: { ...kMargin, resisted, refuted } });
  const bars = opened.root.querySelectorAll("[data-multiples]").map((e) => {
    const [x, width] = ["x", "width"].map((name) => Number(e.getAttribute(name)));
    return [e.dataset.multiples, x, width];
  });
  return { note: opened.text("#margin-note").replace(/\s+/g, " "), bars };
}
const widths = (bars, kind) => bars.filter((bar) => bar[0] === kind).map((bar) => bar[2]);

test("slivers of multiples about which nothing is known are seen and said", () => {
  const { note, bars } = marginOf([["0", "8885/10000"]], [["889/1000", null]]);
  assert.match(note, /Nothing is known of multiples between 0.8885 and 0.889:/);
  assert.match(note, /not known/);
  assert.strictEqual(widths(bars, "unknown").length, 1);
  assert.ok(widths(bars, "unknown")[0] >= 4);
});

test("all multiples are known where none is left", () => {
  for (const [resisted, refuted] of [[[["0", null]], []], [[], [["0", null]]], [[["0", "1"]], [["1", null]]]]) {
    const { note, bars } = marginOf(resisted, refuted);
    assert.doesNotMatch(note, /known/, JSON.stringify(resisted));
    assert.deepStrictEqual(widths(bars, "unknown"), []);
  }
});

test("nothing known is not nothing resisted", () => {
  const { note, bars } = marginOf([], []);
  assert.match(note, /none is known/);
  assert.match(note, /Nothing is known of any multiple:/);
  assert.strictEqual(widths(bars, "unknown").length, 1);
  assert.doesNotMatch(marginOf([], [["0", null]]).note, /is known/);
});

test("how far the load may grow is a lower bound where nothing is known beyond", () => {
  assert.match(marginOf([["0", "2"]], [["3", null]]).note, /may grow to at least 2 times/);
  assert.match(marginOf([["0", "2"]], [["2", null]]).note, /may grow to 2 times/);
  assert.match(marginOf([["0", "1"]], [["1", null]]).note, /no more will do/);
  assert.doesNotMatch(marginOf([["0", "1"]], [["2", null]]).note, /no more will do/);
  assert.match(marginOf([["0", "2"], ["5", null]], [["3", "4"]]).note, /between 2 and 3, and between 4 and 5/);
  assert.match(marginOf([["0", "2"]], []).note, /above 2/);
});

// The quality.

/** The points of a path, and from its middle how far it goes to the right and up. */
function extent(element) {
  const points = element.getAttribute("d").match(/-?[\d.]+ -?[\d.]+/g).map((pair) => pair.split(" ").map(Number));
  const ends = [0, 1].map((j) => [Math.min(...points.map((p) => p[j])), Math.max(...points.map((p) => p[j]))]);
  return { middle: ends.map(([low, high]) => (low + high) / 2), half: ends.map(([low, high]) => (high - low) / 2), points };
}
const isNear = (a, b, within) => assert.ok(Math.abs(a - b) <= within, a + " and " + b);

test("balls of loads in the plane are where they are, also about another point", () => {
  for (const [grasp, squeezed] of [
    [kPlanar, 1],
    // At the same torque about 0 a force (x, y) has the torque x / 2 about (0, 1/2).
    [["60", example("jaw"), "--uncertain", "wrench=ball:1:about=0:1/2"], Math.sqrt(1.25)],
  ]) {
    const made = pageWithin(...grasp);
    const opened = openWith(made);
    const { answer, find, page, root } = opened;
    isWhole(opened, made.answer, "stable");
    const { quality, decide } = made.answer;
    const view = page.regionView();
    const centre = view.place(made.answer.wrench.slice(0, 2));
    const radii = { proved: quality.proved, refuted: quality.refuted, ...(decide.ball ? { asked: decide.ball.radius } : {}) };
    assert.strictEqual(root.querySelectorAll("#region path.ball").length, Object.keys(radii).length);
    for (const [name, radius] of Object.entries(radii)) {
      const ball = find("#region path.ball." + name);
      assert.strictEqual(ball.getAttribute("data-radius"), radius);
      const { middle, half } = extent(ball);
      const [top, bottom] = radius.split("/").map(Number);
      const pixels = (top / (bottom || 1)) * view.scale;
      for (const j of [0, 1]) isNear(middle[j], centre[j], 0.05);
      isNear(half[0], pixels / squeezed, 0.02 * pixels);
      isNear(half[1], pixels, 0.02 * pixels);
      // Larger, beside the load alone: all of the larger ball, as wide as high, in the middle.
      const near = extent(find("#quality-picture path.ball." + name));
      isNear(near.half[1] / near.half[0], squeezed, 0.02);
      assert.ok(near.half[1] > half[1] || name === "asked");
    }
    const words = opened.text("#quality");
    assert.match(words, /is resisted: one proof for all of them/);
    assert.strictEqual(/about \(0, 1\/2\)/.test(words), squeezed !== 1);
    assert.strictEqual(/The box: every load that differs from w by/.test(opened.text("#why")), squeezed !== 1);
    assert.doesNotMatch(opened.text("#why"), /wrench\[/);
  }
});

test("the load that is not resisted is shown on the body, with its proof", () => {
  // The quality is as large with no limit of nodes; cells on the border of the region take a minute then.
  const cup = ["60", example("space-cup"), "--uncertain", "wrench=ball:1/10:length=4", "--node-limit", "200"];
  for (const grasp of [kPlanar, cup]) {
    const made = pageWithin(...grasp);
    const opened = openWith(made);
    const { page, find } = opened;
    assert.ok(find("#region path.ball.proved"));
    find("#show-lost").click();
    isWhole(opened, made.answer.lost, "unstable");
    assert.deepStrictEqual([...page.load()], made.answer.quality.not_resisted_float);
    assert.match(opened.text("#verdict"), /near the load that was asked about/);
    assert.strictEqual(page.checkProof().answer, "accepted");
    page.showExample(null);
    isWhole(opened, made.answer, "stable");
    assert.strictEqual(page.checkProof().answer, "accepted");
  }
});

test("a quality of nothing, of everything, and none", () => {
  const made = pageWithin(...kPlanar);
  const { quality } = made.answer;
  const { not_resisted, not_resisted_float, ...without } = quality;
  for (const [parts, expected] of [
    [{ ...quality, verdict: "unstable", proved: "0", refuted: null }, /The load itself is not resisted/],
    [{ ...without, refuted: null }, /No load that is not resisted was found/],
    [{ ...without, proved: "0" }, /some load is not resisted/],
  ]) {
    const opened = openWith(made, { quality: parts, lost: null });
    assert.match(opened.text("#quality"), expected);
    assert.strictEqual(opened.find("#show-lost"), null);
    assert.strictEqual(Boolean(opened.find("#region path.ball.proved")), parts.verdict === "stable" && parts.proved !== "0");
  }
  assert.strictEqual(openWith(made, { quality: null, lost: null }).find("#quality-panel").shown, false);
});

test("several bodies have the quality of the body that is asked about", () => {
  const stack = [example("bodies-stack"), "--case", "pushed above"];
  const plain = pageOf(...stack);
  assert.strictEqual(plain.answer.quality, null);
  assert.match(openWith(plain).text("#why"), /quality --body NAME/);
  const made = pageWithin("60", ...stack, "--uncertain", "wrench=ball:1/10:body=up");
  const opened = openWith(made);
  isWhole(opened, made.answer, "stable");
  assert.match(opened.text("#quality"), / on up with /);
  opened.find("#show-lost").click();
  assert.strictEqual(opened.find("#verdict").dataset.verdict, "unstable");
});
