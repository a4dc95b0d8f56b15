// SPDX-License-Identifier: GPL-3.0-or-later
//
// One object holds all of the page. Its parts are classic scripts, included one after the other.
"use strict";

const StickslipPage = {
  answer: null, // what the page shows; see docs/page.md
  fragile: null, // while one grasp of a fragile box, or a load that is lost, is shown: the answer about all, and which: {whole, name}
  views: [], // of each part of the page: a function that draws it again
  // What is looked at: a kind of motion, one of "equilibrium", "cell" and "twist"; the cell that is chosen, and the one
  // that is pointed at; the leaf of the refutation; and whether numbers are printed with all digits.
  shown: { motion: "equilibrium", cell: null, pointed: null, leaf: null, exact: false },
};

(function (page) {
  const kSvg = "http://www.w3.org/2000/svg";

  page.find = (id) => document.getElementById(id);

  function fill(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes || {})) {
      if (value === null || value === undefined || value === false) continue;
      if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
      else element.setAttribute(name, value === true ? "" : value);
    }
    // Text is never parsed as HTML: names come from files.
    element.append(...children.flat(9).filter((child) => child !== null && child !== undefined));
    return element;
  }
  page.html = (tag, attributes, ...children) => fill(document.createElement(tag), attributes, children);
  page.svg = (tag, attributes, ...children) => fill(document.createElementNS(kSvg, tag), attributes, children);

  /** Shows the element with these children, or hides it if there are none. */
  page.put = function (id, ...children) {
    const element = page.find(id);
    const present = children.flat(9).filter((child) => child !== null && child !== undefined);
    element.replaceChildren(...present);
    element.hidden = present.length === 0;
    return element;
  };

  page.draw = function () {
    for (const view of page.views) view();
  };

  /** Changes what is looked at, and draws again. */
  page.show = function (change) {
    Object.assign(page.shown, change);
    page.draw();
  };

  /** The value of a colour of the present theme, for what is not styled by CSS. */
  page.colour = (name) =>
    getComputedStyle(document.documentElement)
      .getPropertyValue("--" + name)
      .trim();

  /** Answers that an answer holds, by name, which can be shown in its place. */
  page.examplesOf = ({ examples, lost }) => examples || (lost ? { lost } : null);

  page.isSpatial = () => page.answer.dimension === 6;

  /** A word in the singular or the plural: "1 case", "3 cases". */
  page.count = (n, one, many) => n + " " + (n === 1 ? one : many || one + "s");
  /** "contact 0", "contacts 0, 1 and 2". */
  page.contacts = function (list) {
    if (list.length > 12) return list.length + " contacts";
    const last = list.length > 1 ? " and " + list[list.length - 1] : "";
    return (list.length === 1 ? "contact " : "contacts ") + (last ? list.slice(0, -1) : list).join(", ") + last;
  };
})(StickslipPage);
