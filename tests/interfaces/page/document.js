// SPDX-License-Identifier: GPL-3.0-or-later
//
// As much of a browser as a page needs to be drawn in node: elements with attributes and text, and no layout. What it looks
// like is for the tests in Chromium.
"use strict";

const vm = require("node:vm");

const kEmpty = new Set(["meta", "link", "input"]);
const kRaw = new Set(["script", "style"]);

class Element {
  constructor(tag) {
    this.tag = tag;
    this.attributes = new Map();
    this.children = []; // elements, and strings for text
    this.parent = null;
    this.style = {};
    this.listeners = {};
    const { attributes } = this;
    this.dataset = new Proxy(
      {},
      {
        get: (_, name) => attributes.get("data-" + name),
        set: (_, name, value) => (attributes.set("data-" + name, String(value)), true),
      },
    );
    this.classList = {
      contains: (name) => this.classes().includes(name),
      toggle: (name, yes) => {
        const others = this.classes().filter((other) => other !== name);
        this.setAttribute("class", (yes ? [...others, name] : others).join(" "));
      },
    };
  }
  classes() {
    return (this.attributes.get("class") || "").split(" ").filter(Boolean);
  }
  get id() {
    return this.attributes.get("id") || "";
  }
  set id(value) {
    this.attributes.set("id", value);
  }
  get hidden() {
    return this.attributes.has("hidden");
  }
  set hidden(yes) {
    if (yes) this.attributes.set("hidden", "");
    else this.attributes.delete("hidden");
  }
  get parentElement() {
    return this.parent;
  }
  get clientWidth() {
    return 460;
  }
  setAttribute(name, value) {
    this.attributes.set(name, String(value));
  }
  getAttribute(name) {
    return this.attributes.has(name) ? this.attributes.get(name) : null;
  }
  addEventListener(type, listener) {
    (this.listeners[type] ||= []).push(listener);
  }
  click() {
    for (const listener of this.listeners.click || []) listener({ target: this });
  }
  focus() {}
  append(...children) {
    for (const child of children) {
      if (child instanceof Element) child.parent = this;
      this.children.push(child instanceof Element ? child : String(child));
    }
  }
  replaceChildren(...children) {
    this.children = [];
    this.append(...children);
  }
  get textContent() {
    return this.children.map((child) => (child instanceof Element ? child.textContent : child)).join("");
  }
  set textContent(text) {
    this.children = [String(text)];
  }
  *all() {
    for (const child of this.children) {
      if (!(child instanceof Element)) continue;
      yield child;
      yield* child.all();
    }
  }
  /** Whether nothing hides it. */
  get shown() {
    return !this.hidden && (this.parent === null || this.parent.shown);
  }
  matches(selector) {
    const parts = selector.match(/^[\w-]+|#[\w-]+|\.[\w-]+|\[[^\]]+\]/g);
    return parts.every((part) => {
      if (part[0] === "#") return this.id === part.slice(1);
      if (part[0] === ".") return this.classes().includes(part.slice(1));
      if (part[0] !== "[") return this.tag === part;
      const [, name, value] = /^\[([\w-]+)(?:="([^"]*)")?\]$/.exec(part);
      return value === undefined ? this.attributes.has(name) : this.getAttribute(name) === value;
    });
  }
  querySelectorAll(selector) {
    const levels = selector.split(" ");
    return [...this.all()].filter((element) => {
      if (!element.matches(levels[levels.length - 1])) return false;
      let left = levels.length - 2;
      for (let above = element.parent; above && left >= 0; above = above.parent) if (above.matches(levels[left])) --left;
      return left < 0;
    });
  }
  querySelector(selector) {
    return this.querySelectorAll(selector)[0] || null;
  }
  getContext() {
    // Draws nothing: every property is a function that returns such a thing again.
    const nothing = new Proxy(function () {}, { get: (_, name) => (name === Symbol.toPrimitive ? () => 0 : nothing), apply: () => nothing });
    return nothing;
  }
}

/** The elements of HTML as the program writes it. */
function parse(text) {
  const root = new Element("root");
  let open = root;
  const tags = /<!--[^]*?-->|<!DOCTYPE html>|<(\/?)([a-z0-9]+)((?:\s+[\w-]+(?:="[^"]*")?)*)\s*>/g;
  let done = 0;
  for (let match = tags.exec(text); match; match = tags.exec(text)) {
    if (match.index > done) open.append(text.slice(done, match.index));
    done = tags.lastIndex;
    const [, closing, tag, attributes] = match;
    if (tag === undefined) continue;
    if (closing) {
      open = open.parent;
      continue;
    }
    const element = new Element(tag);
    for (const [, name, value] of attributes.matchAll(/([\w-]+)(?:="([^"]*)")?/g)) element.setAttribute(name, value || "");
    open.append(element);
    if (kEmpty.has(tag)) continue;
    if (kRaw.has(tag)) {
      const end = text.indexOf("</" + tag + ">", done);
      element.textContent = text.slice(done, end);
      tags.lastIndex = done = end + tag.length + 3;
      continue;
    }
    open = element;
  }
  return root;
}

/** What three.js draws on: it counts. */
class Renderer {
  constructor() {
    this.domElement = new Element("canvas");
    this.rendered = 0;
    Renderer.last = this;
  }
  setPixelRatio() {}
  setSize() {}
  setClearColor() {}
  setViewport() {}
  clearDepth() {}
  render() {
    ++this.rendered;
  }
}

/**
 * Opens a page: runs its scripts with this answer in place of its own, if one is given. Throws what they throw. Returns
 * {page, find, text, rendered}: StickslipPage, an element and its text by a selector, and how often space was drawn.
 */
function open(text, answer) {
  const root = parse(text);
  const find = (selector) => root.querySelector(selector);
  if (answer) find("#answer").textContent = JSON.stringify(answer);
  const html = find("html");
  const colours = { conditionText: "(prefers-color-scheme: dark)", media: {} };
  [...root.all()].find((element) => element.id === "style.css").sheet = { cssRules: [colours] };
  const document = {
    documentElement: html,
    body: find("body"),
    activeElement: find("body"),
    title: "",
    getElementById: (id) => [...root.all()].find((element) => element.id === id) || null,
    querySelector: find,
    querySelectorAll: (selector) => root.querySelectorAll(selector),
    createElement: (tag) => new Element(tag),
    createElementNS: (_, tag) => new Element(tag),
    addEventListener() {},
  };
  const scope = {
    document,
    console: { log() {}, warn() {}, error() {} },
    matchMedia: () => ({ matches: true, addEventListener() {} }),
    getComputedStyle: () => ({ getPropertyValue: () => "#808080" }),
    requestAnimationFrame: () => 0,
    cancelAnimationFrame() {},
    addEventListener() {},
    localStorage: { getItem: () => null, setItem() {} },
    innerWidth: 1280,
    performance,
    Blob,
    TextEncoder,
    URL,
  };
  scope.window = scope.self = scope;
  vm.createContext(scope);
  let rendered = () => 0;
  for (const script of root.querySelectorAll("script")) {
    if (script.getAttribute("type") === "application/json") continue;
    vm.runInContext(script.textContent, scope);
    if (vm.runInContext("typeof THREE !== 'undefined' && !THREE.forTests", scope)) {
      scope.THREE.WebGLRenderer = Renderer;
      scope.THREE.forTests = true;
      rendered = () => (Renderer.last ? Renderer.last.rendered : 0);
    }
  }
  return { page: vm.runInContext("StickslipPage", scope), find, text: (selector) => find(selector).textContent, rendered, root };
}

module.exports = { open };
