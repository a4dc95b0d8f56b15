// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is said in words: the verdict, why, what each contact does, and all exact numbers.
(function (page) {
  const { html } = page;

  const kVerdicts = {
    stable: ["Stable", "the grasp holds this load."],
    unstable: ["Unstable", "the grasp does not hold this load."],
    fragile: ["Fragile", "some grasps in the box hold this load, and others do not."],
    undecided: ["Undecided", "nothing is known about the verdict."],
  };
  const kVerdictsOfSeveral = {
    ...kVerdicts,
    stable: ["Stable", "the bodies hold this load."],
    unstable: ["Unstable", "the bodies do not hold this load."],
  };
  const kBoxVerdicts = {
    stable: ["Stable throughout", "every grasp in the box of uncertain numbers holds its load."],
    unstable: ["Unstable throughout", "no grasp in the box of uncertain numbers holds its load."],
  };
  const kSymbols = { stable: "\u2713", unstable: "\u2715", fragile: "\u2248", undecided: "?" };

  /** Of one decision: [word, sentence]. */
  function wordsOf(decide) {
    const ofOne = page.mechanism() ? kVerdictsOfSeveral : kVerdicts;
    return (decide.box && kBoxVerdicts[decide.verdict]) || ofOne[decide.verdict] || [decide.verdict, ""];
  }

  page.verdictWords = function () {
    const { decide } = page.answer;
    if (!decide) return "No verdict was asked for.";
    if (decide.cases) return page.count(decide.cases.length, "case");
    return wordsOf(decide).join(": ");
  };

  function drawVerdict() {
    const { answer } = page;
    const { decide } = answer;
    const verdict = decide && !decide.cases ? decide.verdict : "none";
    document.title = (answer.name || "Grasp") + (verdict === "none" ? "" : ": " + verdict);
    page.put("name", (answer.name || "Grasp") + (decide && decide.case ? ", " + decide.case : ""));
    const place = page.find("verdict");
    place.dataset.verdict = verdict;
    if (!decide || decide.cases) {
      page.put("verdict", html("span", { class: "sentence" }, page.verdictWords()));
      return;
    }
    const [word, sentence] = wordsOf(decide);
    page.put(
      "verdict",
      html("span", { class: "symbol", "aria-hidden": "true" }, kSymbols[decide.verdict] || ""),
      html("span", {}, html("strong", { class: "word" }, word + ": "), html("span", { class: "sentence" }, sentence, ofTheBox())),
    );
  }

  const ofTheBox = () =>
    !page.fragile
      ? ""
      : page.fragile.name === "lost"
        ? " It is one that is near the load that was asked about."
        : " It is one grasp of the box of uncertain numbers, and others differ.";

  const is_decided = ({ verdict }) => verdict === "stable" || verdict === "unstable";

  function casesTable(cases) {
    return html(
      "table",
      { class: "cases" },
      html(
        "thead",
        {},
        html(
          "tr",
          {},
          ["case", "verdict", "load w"].map((text) => html("th", { scope: "col" }, text)),
        ),
      ),
      html(
        "tbody",
        {},
        cases.map((one) =>
          html(
            "tr",
            {},
            html("th", { scope: "row" }, one.case),
            html("td", {}, (kSymbols[one.verdict] || "") + " " + one.verdict),
            html("td", {}, page.state(one.wrench)),
          ),
        ),
      ),
    );
  }

  const wrenchText = (wrench) =>
    page.state(wrench, (w) => (Array.isArray(w) ? ["[", page.number(w[0]), ", ", page.number(w[1]), "]"] : page.number(w)));
  const hasSprings = () => page.mechanism() !== null && page.mechanism().springs.length > 0;

  /** Under the verdict: the load, and what makes it so. */
  function drawWhy() {
    const { decide } = page.answer;
    const lines = [];
    if (decide && decide.cases) lines.push(casesTable(decide.cases));
    if (decide && !decide.cases) {
      lines.push(html("p", {}, "Load w = ", wrenchText(decide.wrench), unitsText(), "."));
      if (decide.verdict === "stable" && decide.box) {
        lines.push(
          html(
            "p",
            {},
            "Proved for all of them at once." +
              (page.answer.near ? " What is drawn is the grasp in the middle of the box." : ""),
          ),
        );
      } else if (decide.verdict === "stable" && decide.twist) {
        lines.push(
          html(
            "p",
            {},
            page.mechanism() ? "The bodies move by z = " : "The body moves by d = ",
            page.state(decide.twist),
            ", and then ",
            contactsDo(page.equilibrium().marks) || "no contact is needed",
            ". These forces balance the load" +
              (hasSprings() ? " with those of the springs" : "") +
              ", lie in their friction cones and oppose slip; checked exactly.",
          ),
        );
      } else if (decide.verdict === "stable") {
        lines.push(
          html(
            "p",
            {},
            page.mechanism() ? "The bodies move by nearly z = " : "The body moves by nearly d = ",
            page.mechanism() && decide.near
              ? page.state(decide.near, page.brief)
              : page.nearTuple(decide.near_float || (page.answer.near || {}).twist_float || []),
            decide.proof && decide.proof.at_rest
              ? ". Proved: nothing moves, as friction answers whatever load is left. "
              : decide.proof && decide.proof.sticking
              ? ". Proved: contacts stick near this motion, and friction has more to spare than what is off takes away. "
              : decide.proof && decide.proof.untouched
              ? ". Proved: nothing touches it near this motion, and there is no load. "
              : ". Proved: the forces on the walls around motions near this one leave no way out but an equilibrium inside. ",
            "What is drawn is near it, in floating point.",
          ),
        );
      } else if (decide.verdict === "unstable") {
        const { leaves } = page.refutation();
        const many =
          leaves.length > 1
            ? "Proved by a tree of " + leaves.length + " leaves, which together cover all motions: in each, along"
            : "Along";
        lines.push(
          html(
            "p",
            {},
            "No motion and forces satisfy all conditions. " +
              many +
              " some virtual twist, the load does more work than the contacts " +
              (hasSprings() ? "and springs " : "") +
              "can take up.",
          ),
        );
      } else if (decide.verdict === "fragile" && decide.differences) {
        lines.push(
          html(
            "p",
            {},
            "Two of them differ in ",
            decide.differences.map((d, i) => [
              i ? "; " : "",
              d.place,
              ": stable at ",
              page.number(d.stable),
              ", unstable at ",
              page.number(d.unstable),
            ]),
            ".",
          ),
        );
      } else if (decide.limit) {
        lines.push(html("p", {}, "Not decided: " + decide.limit + (decide.remedy ? "; " + decide.remedy : "") + "."));
      }
      if (decide.max_motion) lines.push(html("p", {}, "Motions up to ", page.state(decide.max_motion), " are asked about."));
      if (decide.within)
        lines.push(
          html(
            "p",
            { class: "warning" },
            decide.within.max_motion
              ? "Within 1000 times what the load would press the softest contact: "
              : "Without a part of the load that rounding alone makes, and that no contact opposes: ",
            decide.within.verdict,
            is_decided(decide.within) ? " (proved)." : ".",
          ),
        );
      if (decide.ball)
        lines.push(html("p", {}, "The box: every load that differs from w by ", page.ballWords(decide.ball, decide.ball.radius), "."));
      const numbers = (decide.uncertain || []).filter(({ place }) => !decide.ball || !place.startsWith("wrench["));
      for (const uncertain of [groupUncertain(numbers)]) if (uncertain) lines.push(uncertain);
      if (decide.enclosed)
        lines.push(
          html(
            "p",
            {},
            (decide.enclosed.length === 1
              ? "The normal of " + page.contacts(decide.enclosed) + " has an irrational length"
              : "The normals of " + page.contacts(decide.enclosed) + " have irrational lengths") +
              " |n|: P/|n| was enclosed to " +
              decide.bits +
              " bits" +
              (decide.verdict === "undecided" ? "." : ", and the verdict is proved for all numbers in there."),
          ),
        );
      lines.push(
        html(
          "p",
          { class: "muted" },
          "Normal law: " +
            decide.normal_law +
            (decide.normal_law === "unilateral" ? " (contacts may open)" : " (no contact may open)") +
            ". Engine: " +
            decide.engine +
            ".",
        ),
      );
    }
    const statics = { "may stand": "some forces would balance the load", "must move": "no forces would balance the load" };
    if (statics[page.answer.statics])
      lines.push(html("p", {}, "For any stiffness and preloads: ", page.answer.statics, ", as ", statics[page.answer.statics], "."));
    for (const warning of (decide && decide.warnings) || [])
      lines.push(html("p", { class: "warning" }, "Warning: " + warning.text + "."));
    for (const message of messages()) lines.push(html("p", { class: "muted" }, message));
    page.put("why", lines);
  }

  /** What is said of the parts of the page; of several parts that cannot be had for one reason, once. */
  function messages() {
    const reasons = new Map();
    for (const message of page.answer.messages || []) {
      const [, part, reason] = /^(states|region|margin|map|quality|compare|statics|lost): (.*)$/.exec(message) || [null, "", message];
      // In space nobody expects of one body what is found in the plane only.
      if (page.isSpatial() && !page.mechanism() && reason.endsWith("in the plane only.")) continue;
      reasons.set(reason, [...(reasons.get(reason) || []), part]);
    }
    return [...reasons].map(([reason, parts]) => (parts[0] ? parts.join(", ") + ": " : "") + reason);
  }

  function unitsText() {
    const units = page.unitsOf();
    return units ? " in " + units.force + " and " + units.force + " " + units.length : "";
  }

  /** Which forces and torques are in a ball of loads of this radius. */
  page.ballWords = function (ball, radius) {
    const exact = (value) => (Number(value) === 1 ? "" : [" / ", page.number(value)]);
    return [
      "a force f and a torque t",
      ball.about ? [" about ", page.numbers(ball.about)] : "",
      ball.body ? " on " + ball.body : "",
      " with |f|\u00B2 + |t",
      exact(ball.length),
      "|\u00B2 \u2264 (",
      page.number(radius),
      ")\u00B2",
    ];
  };

  /** The quality: how large a ball of loads is resisted. */
  function drawQuality() {
    const { quality } = page.answer;
    page.find("quality-panel").hidden = !quality;
    if (!quality) return;
    const { ball, proved, refuted, scales } = quality;
    const lines = [];
    if (quality.verdict !== "stable") {
      lines.push(html("p", {}, quality.verdict === "unstable" ? "The load itself is not resisted." : "The load itself is not decided."));
    } else {
      if (Number(proved) !== 0)
        lines.push(
          html(
            "p",
            {},
            "Every load that differs from this one by ",
            page.ballWords(ball, proved),
            " is resisted: one proof for all of them",
            scales ? ", and as nothing else presses, for all loads there are." : ".",
          ),
        );
      lines.push(
        html(
          "p",
          {},
          refuted === null
            ? "No load that is not resisted was found."
            : ["In the ball of radius ", page.number(refuted), " some load is not resisted", quality.not_resisted ? [": w = ", page.numbers(quality.not_resisted)] : "", "."],
        ),
      );
      if (page.examplesOf(page.answer) && page.answer.lost && !page.answer.examples)
        lines.push(
          html("button", { type: "button", id: "show-lost", onclick: () => page.showExample("lost") }, "Show it on the body"),
        );
    }
    page.put("quality", lines);
  }

  /** What earlier methods and measures say of the same question, and why. */
  function drawCompare() {
    const { compare } = page.answer;
    page.find("compare-panel").hidden = !compare;
    if (!compare) return;
    const names = ["method", "says", "why"];
    const says = (row) => page.typeset(row.verdict) + (row.agrees === false ? ", unlike the passive model" : "");
    const place = page.put(
      "compare",
      html(
        "table",
        {},
        html("thead", {}, html("tr", {}, names.map((name) => html("th", { scope: "col" }, name)))),
        html(
          "tbody",
          {},
          compare.methods.map((row) =>
            html(
              "tr",
              { "data-method": row.method },
              html("th", { scope: "row", title: row.source }, row.method),
              html("td", { "data-column": names[1] }, says(row)),
              html("td", { "data-column": names[2], class: "muted" }, page.typeset(row.why)),
            ),
          ),
        ),
      ),
      html("p", { class: "muted" }, "Torques are divided by ", page.number(compare.length), "; forces of a hand are up to 1."),
    );
    page.stack(place, kSentences);
  }

  const kSentences = 480; // pixels that columns with sentences need

  /** Where the columns of a table have no room beside each other, their names stand in the rows. */
  page.stack = function (place, least = 0) {
    const table = place.querySelector("table");
    if (table && place.clientWidth < Math.max(place.scrollWidth, least)) table.classList.toggle("cards", true);
  };

  /** The uncertain numbers, those with one interval together. */
  function groupUncertain(list) {
    if (list.length === 0) return null;
    const groups = new Map();
    for (const { place, interval } of list) {
      const parts = /^contacts\[(\d+)\]\.(.*)$/.exec(place);
      const key = (parts ? parts[2] : place) + " " + interval;
      if (!groups.has(key)) groups.set(key, { what: parts ? parts[2] : place, interval, contacts: [] });
      if (parts) groups.get(key).contacts.push(parts[1]);
    }
    return html(
      "p",
      {},
      "Uncertain: ",
      [...groups.values()].map((group, k) => [
        k ? "; " : "",
        group.what,
        group.contacts.length ? " of " + page.contacts(group.contacts) : "",
        " from ",
        page.number(group.interval[0]),
        " to ",
        page.number(group.interval[1]),
      ]),
      ".",
    );
  }

  const kDoes = {
    plus: ["slips\u00A0+", "slip\u00A0+"],
    minus: ["slips\u00A0\u2212", "slip\u00A0\u2212"],
    slip: ["slips", "slip"],
    stick: ["sticks", "stick"],
    open: ["is open", "are open"],
  };
  /** "contact 0 slips +, contacts 1 and 2 stick". */
  function contactsDo(marks) {
    const parts = Object.entries(kDoes).map(([mark, words]) => {
      const list = marks.flatMap((other, i) => (other === mark ? [i] : []));
      return list.length === 0 ? "" : page.contacts(list) + " " + words[list.length === 1 ? 0 : 1];
    });
    return parts.filter(Boolean).join(", ");
  }

  // What is looked at: the equilibrium, a motion of the sphere, or the virtual twist of a leaf.
  function drawChoice() {
    const { answer, shown } = page;
    const motion = page.motion();
    const decide = page.decided();
    const choices = [];
    if (decide && (decide.twist || decide.near || page.answer.near)) choices.push(["equilibrium", "Equilibrium"]);
    if (page.refutation().leaves.length > 0) choices.push(["twist", "Virtual twist"]);
    if (answer.states && shown.cell !== null) choices.push(["cell", "Motion on the sphere"]);
    const moving = motion.twist && motion.twist.some((x) => x !== 0);
    const examples = page.examplesOf(page.fragile ? page.fragile.whole : answer);
    page.put(
      "choice",
      examples && !answer.live
        ? html(
            "div",
            { role: "group", "aria-label": "Which grasp is shown", class: "segments" },
            (examples.lost
              ? [
                  [null, "The load"],
                  ["lost", "One that is not resisted"],
                ]
              : [
                  [null, "The box"],
                  ["stable", "One that holds"],
                  ["unstable", "One that does not"],
                ]
            ).map(([name, text]) =>
              html(
                "button",
                {
                  type: "button",
                  "aria-pressed": String(name === (page.fragile ? page.fragile.name : null)),
                  "data-choice": "grasp-" + (name || "box"),
                  onclick: () => page.showExample(name),
                },
                text,
              ),
            ),
          )
        : null,
      choices.length === 0
        ? null
        : html(
            "div",
            { role: "group", "aria-label": "What is shown", class: "segments" },
            choices.map(([kind, text]) =>
              html(
                "button",
                {
                  type: "button",
                  "aria-pressed": String(motion.kind === kind),
                  "data-choice": kind,
                  onclick: () => page.show({ motion: kind }),
                },
                text,
              ),
            ),
          ),
      moving
        ? html(
            "button",
            { type: "button", id: "pause", onclick: () => page.pause(!page.isPaused()) },
            page.isPaused() ? "Play" : "Pause",
          )
        : null,
    );
  }

  // Buttons are made anew whenever they are drawn; the focus stays where it was.
  let focused = null;
  document.addEventListener("focusin", (event) => {
    focused = event.target.dataset.choice || event.target.id || null;
  });
  document.addEventListener("focusout", (event) => {
    if (event.relatedTarget) focused = null;
  });
  page.restoreFocus = function () {
    if (!focused || document.activeElement !== document.body) return;
    const element = document.querySelector('[data-choice="' + focused + '"]') || page.find(focused);
    if (element) element.focus({ preventScroll: true });
  };

  function drawMotionWords() {
    const motion = page.motion();
    const lines = [];
    if (motion.kind === "twist") lines.push(...leafLines());
    if (motion.kind === "cell") {
      const { cell } = motion;
      lines.push(
        html(
          "p",
          {},
          html("strong", {}, cell.kind[0].toUpperCase() + cell.kind.slice(1) + " "),
          html("code", { class: "state" }, page.typeset(cell.states)),
          ". ",
          page.motionWords(motion.twist),
          motion.marks.length > 0 ? " In it " + contactsDo(motion.marks) + "." : "",
        ),
      );
    }
    if (motion.kind === "equilibrium") lines.push(...page.motionLines(motion.twist).map((line) => html("p", {}, line)));
    page.put("motion-words", lines);
  }

  page.drawMotionWords = drawMotionWords;

  function leafLines() {
    const { leaves } = page.refutation();
    const k = page.leafShown();
    const found = leaves[k];
    const drift = page.drift(found);
    const whole = found.conditions.length === 0;
    const oppose = drift.opposing.flatMap((yes, i) => (yes ? [i] : []));
    const idle = drift.opposing.flatMap((yes, i) => (yes ? [] : [i]));
    const step = (by) => () => page.show({ motion: "twist", leaf: (k + by + leaves.length) % leaves.length });
    const load = !drift.work
      ? "Its load"
      : drift.work.sign() > 0
        ? "The load drives this motion"
        : drift.work.sign() < 0
          ? "The load works against this motion"
          : "The load does no work on this motion";
    return [
      leaves.length > 1
        ? html(
            "p",
            { class: "stepper" },
            html(
              "button",
              { type: "button", "data-choice": "leaf-before", "aria-label": "Leaf before", onclick: step(-1) },
              "\u2190",
            ),
            " Leaf " + (k + 1) + " of " + leaves.length + " ",
            html(
              "button",
              { type: "button", "data-choice": "leaf-after", "aria-label": "Next leaf", onclick: step(1) },
              "\u2192",
            ),
          )
        : null,
      whole ? null : html("p", {}, "All motions with: " + found.conditions.join(", ") + "."),
      html(
        "p",
        {},
        "Whatever forces the contacts " +
          (hasSprings() ? "and springs " : "") +
          "have" +
          (whole ? "" : " in it") +
          (hasSprings() ? ", load, contacts and springs" : ", load and contacts") +
          " together do positive work along the virtual twist ",
        page.state(drift.exact),
        ", so they never balance. ",
        load,
        drift.work && drift.work.sign() !== 0 ? [" (work ", page.number(drift.work), ")"] : null,
        oppose.length
          ? "; " + page.contacts(oppose) + (oppose.length === 1 ? " opposes it and loses" : " oppose it and lose")
          : "",
        idle.length ? "; " + page.contacts(idle) + " cannot oppose it" : "",
        ".",
      ),
      page.motionLines(drift.twist).map((line) => html("p", {}, line)),
    ];
  }

  function drawTable() {
    const { answer } = page;
    const motion = page.motion();
    const { kind } = motion;
    const exact = kind === "equilibrium" && page.decided().contacts;
    const near = kind === "equilibrium" && !exact && page.forces();
    const marked = motion.marks.some((mark) => mark !== "none");
    const columns = [["contact", (_, i) => String(i)]];
    if (page.mechanism()) {
      const name = (b) => (b === null ? "ground" : page.bodies()[b].name);
      columns.push(["of", (contact) => name(contact.of)], ["by", (contact) => name(contact.by)]);
    }
    if (marked) columns.push(["does", (_, i) => [page.markSign(motion.marks[i]), " ", page.marks[motion.marks[i]]]]);
    if (kind === "cell") columns.push(["normal", (contact) => partingWords(contact, motion.twist)]);
    const inParts = exact && exact.every((contact) => contact.normal !== undefined);
    if (inParts) {
      columns.push(
        ["normal", (_, i) => page.brief(exact[i].normal)],
        ["tangential", (_, i) => page.brief(exact[i].tangential)],
      );
    }
    if (exact) columns.push(["force", (_, i) => page.numbers(exact[i].force, page.brief)]);
    if (exact && !inParts) columns.push(["friction", (_, i) => page.numbers(exact[i].friction, page.brief)]);
    if (exact && exact.some(({ moment }) => moment !== undefined))
      columns.push(["moment", (_, i) => (exact[i].moment === undefined ? "" : page.numbers(exact[i].moment, page.brief))]);
    if (near)
      columns.push([
        page.decided().box ? "force, middle" : "force, near",
        (_, i) => page.nearTuple(near[i].force.map((x) => page.clean(x, Math.hypot(...near[i].force)))),
      ]);
    columns.push(
      ["\u03BC", (contact) => page.near(contact.friction)],
      ["preload", (contact) => page.near(contact.preload)],
    );
    const cell = ([name, show], contact, i) =>
      html(
        name === "contact" ? "th" : "td",
        {
          scope: name === "contact" ? "row" : null,
          "data-column": name,
          "data-contact-does": name === "does" ? motion.marks[i] : null,
        },
        show(contact, i),
      );
    const place = page.put(
      "contacts",
      answer.contacts.length === 0
        ? html("p", {}, "There are no contacts.")
        : html(
            "table",
            {},
            html("caption", {}, "Contacts"),
            html(
              "thead",
              {},
              html(
                "tr",
                {},
                columns.map(([name]) => html("th", { scope: "col" }, name)),
              ),
            ),
            html(
              "tbody",
              {},
              answer.contacts.map((contact, i) =>
                html(
                  "tr",
                  { "data-contact": i },
                  columns.map((column) => cell(column, contact, i)),
                ),
              ),
            ),
          ),
      springsTable(),
    );
    page.stack(place);
    const slips = page.isSpatial() ? "" : "Slip: + is along the normal turned by +90 degrees, \u2212 against it. ";
    page.put(
      "table-note",
      kind === "cell" || exact || near
        ? html("p", { class: "muted" }, slips + (kind === "cell" ? "" : "An open contact is detached."))
        : null,
    );
  }

  /** Of several bodies the forces of what holds their joints, if the equilibrium is known. */
  function springsTable() {
    const decide = page.decided();
    const forces = page.motion().kind === "equilibrium" && decide && decide.springs;
    if (!forces || forces.length === 0) return null;
    const heads = ["spring", "force"].map((name) => html("th", { scope: "col" }, name));
    return html(
      "table",
      { class: "springs" },
      html("caption", {}, "Springs"),
      html("thead", {}, html("tr", {}, heads)),
      html(
        "tbody",
        {},
        page
          .mechanism()
          .springs.map((spring, k) =>
            html(
              "tr",
              {},
              html("th", { scope: "row" }, page.springName(spring)),
              html("td", {}, page.brief(forces[k])),
            ),
          ),
      ),
    );
  }

  function partingWords(contact, twist) {
    const parting = page.parting(contact, twist);
    if (parting < 0) return "presses more";
    if (parting === 0) return "as before";
    return contact.preload > 0 ? "loosens, opens later" : "open at once";
  }

  function drawExact() {
    const { answer } = page;
    const decide = page.decided();
    const rows = [];
    const add = (name, value) => rows.push(html("tr", {}, html("th", { scope: "row" }, name), html("td", {}, value)));
    const all = (values) =>
      page.typeset("(" + values.map((v) => (Array.isArray(v) ? "[" + v.join(", ") + "]" : v)).join(", ") + ")");
    if (decide) {
      add("load w", all(decide.wrench));
      if (page.mechanism()) add("coordinates", page.mechanism().coordinates.join(", "));
      if (decide.twist) add(page.mechanism() ? "motion z" : "motion d", all(decide.twist));
      if (decide.near) add("near the motion", all(decide.near));
      (decide.contacts || []).forEach((contact, i) => add("force of contact " + i, all(contact.force)));
      (decide.springs || []).forEach((force, k) =>
        add("force of " + page.springName(page.mechanism().springs[k]), page.typeset(force)),
      );
    }
    if (answer.margin) add("multiples resisted", page.marginText(true));
    page.put(
      "exact",
      html("table", {}, html("tbody", {}, rows)),
      html("h3", {}, "The grasp file"),
      html("pre", { tabindex: "0", "aria-label": "The grasp file" }, page.grasp.text()),
      page.isSpatial() && page.solids.some(Boolean)
        ? html(
            "p",
            { class: "muted" },
            "The file to download has the " + (page.mechanism() ? "bodies' meshes" : "body") + ", too: ",
            page.solids.filter(Boolean).map((solid) => solid.size).join("; ") + ".",
          )
        : null,
    );
  }

  page.views.push(drawVerdict, drawWhy, drawChoice, drawMotionWords, drawQuality, drawCompare, drawTable, drawExact);
})(StickslipPage);
