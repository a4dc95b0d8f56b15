// SPDX-License-Identifier: GPL-3.0-or-later
//
// Why a grasp is unstable: the leaves of the proof, read from the tree of the certificate (FORMAT.md, section 4), to be
// looked at. Whether the proof is right says the checker, not this.
(function (page) {
  let read = { text: null, leaves: [], part: null };

  const kSlips = ["+", "0", "-"];

  /** A contact, or what else has a force, by its number in the proof. */
  function elementName(i) {
    const contacts = page.answer.contacts.length;
    return i < contacts ? "contact " + i : page.springName(page.mechanism().springs[i - contacts]);
  }

  /** A plane through motions, as its numbers, or of several bodies by the coordinates that it is about. */
  function planeText(numbers) {
    if (!page.mechanism()) return page.tuple(numbers) + "\u00B7(d, 1)";
    const names = [...page.mechanism().coordinates, ""];
    const terms = numbers.map((x, j) => (page.Fraction.of(x).sign() === 0 ? "" : (page.text(x) + " " + names[j]).trim()));
    return terms.filter(Boolean).join(" + ").replace(/\+ \u2212/g, "\u2212 ");
  }

  /** What the children of a node have in common: [{text, slip, open}], none for a leaf. */
  function children(node) {
    const [kind, at, index, number] = node;
    if (kind === "slip") {
      // A slip has no sign in space: it is zero or not.
      if (page.isSpatial()) return [{ text: "contact " + at + " sticks" }, { text: "contact " + at + " slips" }];
      const texts = ["contact " + at + " slips +", "contact " + at + " sticks", "contact " + at + " slips \u2212"];
      return texts.map((text, k) => ({ text, slip: [at, kSlips[k]] }));
    }
    if (kind === "separation") {
      return [{ text: elementName(at) + " is closed" }, { text: elementName(at) + " is open", open: at }];
    }
    if (kind === "plane") {
      const plane = planeText(node.slice(1));
      return [{ text: plane + " \u2265 0" }, { text: plane + " \u2264 0" }];
    }
    if (kind === "part") {
      const what = at === "wrench" ? (page.hasBall() ? "the ball's z" : "wrench") + "[" + index + "]" : at + " of " + elementName(index);
      return [{ text: what + " at most " + page.text(number) }, { text: what + " at least " + page.text(number) }];
    }
    return [];
  }

  function leavesOf(tree) {
    const found = [];
    const path = []; // of inner nodes: {children, current}
    for (const node of tree) {
      const below = children(node);
      if (below.length > 0) {
        path.push({ children: below, current: 0 });
        continue;
      }
      const twist = node.slice(1);
      if (node[0] === "leaf" && twist.some((y) => page.Fraction.of(y).sign() !== 0)) {
        const conditions = path.map((level) => level.children[level.current]);
        found.push({
          conditions: conditions.map((c) => c.text),
          twist,
          slips: new Map(conditions.filter((c) => c.slip).map((c) => c.slip)),
          open: new Set(conditions.filter((c) => c.open !== undefined).map((c) => c.open)),
        });
      }
      while (path.length > 0 && ++path[path.length - 1].current === path[path.length - 1].children.length) path.pop();
    }
    return found;
  }

  /** The leaves of the proof, and which of them is the largest. */
  page.refutation = function () {
    const text = page.answer.certificate;
    if (read.text === text) return read;
    read = { text, leaves: [], largest: 0 };
    if (text) {
      const proof = JSON.parse(text);
      if (proof.verdict === "unstable" && proof.tree) read.leaves = leavesOf(proof.tree);
      let best = null;
      read.leaves.forEach((found, k) => {
        const alike = countAlike(found);
        const length = found.conditions.length;
        if (!best || length < best.length || (length === best.length && alike > best.alike)) {
          best = { length, alike };
          read.largest = k;
        }
      });
    }
    return read;
  };

  /** How many contacts slip or open as the leaf says when the body moves against its twist. */
  function countAlike(found) {
    if (page.isSpatial()) return 0;
    const twist = found.twist.map((y) => -page.Fraction.of(y).toNumber());
    let count = 0;
    for (const [i, slip] of found.slips) {
      const contact = page.answer.contacts[i];
      const along = page.vector.dot(page.tangent(contact), page.moveAt(contact, twist));
      if (slip === (along > 0 ? "+" : along < 0 ? "-" : "0")) ++count;
    }
    const { contacts } = page.answer;
    for (const i of found.open) if (i < contacts.length && page.parting(contacts[i], twist) > 0) ++count;
    return count;
  }

  page.leafShown = function () {
    const { leaves, largest } = page.refutation();
    const { leaf } = page.shown;
    return leaf !== null && leaf < leaves.length ? leaf : largest;
  };

  /**
   * A leaf's virtual twist as a motion: against y, as load and contacts together do negative work on y whatever the
   * contacts do. With the load's work on it, exactly, and which contacts can oppose it.
   */
  page.drift = function (found) {
    const exact = found.twist.map((y) => page.Fraction.of(y).negated());
    const twist = exact.map((y) => y.toNumber());
    const decide = page.decided();
    const isOne = decide && decide.wrench && !decide.wrench.some(Array.isArray) && !page.hasBall();
    const wrench = isOne ? decide.wrench : null;
    const work =
      wrench && exact.reduce((sum, y, j) => sum.plus(y.times(page.Fraction.of(wrench[j]))), page.Fraction.of(0));
    return { exact, twist, work, opposing: page.answer.contacts.map((_, i) => canOppose(i, twist, found)) };
  };

  /** Whether some force that the contact can have in the leaf does negative work on the motion. */
  function canOppose(i, twist, found) {
    if (found.open.has(i)) return false;
    const { vector } = page;
    const contact = page.answer.contacts[i];
    const move = page.moveAt(contact, twist);
    const normal = vector.unit(contact.normal);
    const along = vector.dot(normal, move);
    if (page.isSpatial()) {
      const across = Math.hypot(...vector.add(move, -along, normal), page.spinAt(contact, twist));
      return along - contact.friction * across < -1e-9 * Math.hypot(...move);
    }
    const friction = contact.friction * vector.dot(page.tangent(contact), move);
    const slip = found.slips.get(i) || "0";
    const least = slip === "0" ? along - Math.abs(friction) : slip === "+" ? along - friction : along + friction;
    return least < -1e-9 * Math.hypot(...move);
  }
})(StickslipPage);
