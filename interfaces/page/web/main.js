// SPDX-License-Identifier: GPL-3.0-or-later
(function (page) {
  const kThemes = ["auto", "light", "dark"];
  const kNames = { auto: "Theme: as the system", light: "Theme: light", dark: "Theme: dark" };
  const kDark = "(prefers-color-scheme: dark)";
  /** When the colours are the dark ones. */
  const kMedia = { auto: kDark, light: "not all", dark: "all" };
  const dark = [...page.find("style.css").sheet.cssRules].find((rule) => rule.conditionText === kDark);

  function setTheme(theme) {
    document.documentElement.dataset.theme = theme;
    dark.media.mediaText = kMedia[theme];
    page.find("theme").textContent = kNames[theme];
    try {
      localStorage.setItem("stickslip-theme", theme);
    } catch (error) {
      // Pages from files may have no storage.
    }
    page.draw();
  }

  function savedTheme() {
    try {
      const theme = localStorage.getItem("stickslip-theme");
      return kThemes.includes(theme) ? theme : "auto";
    } catch (error) {
      return "auto";
    }
  }

  /** The plane or space: a live page may come from one to the other by a link. */
  function enter() {
    page.find("body").hidden = page.isSpatial();
    page.find("space").hidden = !page.isSpatial();
    page.find("body-title").textContent = page.mechanism() ? "The bodies" : "The body";
    if (page.isSpatial()) page.startSpace();
  }

  /** Shows an answer in place of what is shown. */
  page.setAnswer = function (answer) {
    page.answer = answer;
    page.grasp.load(answer.grasp);
    enter();
    const states = answer.states;
    page.shown.pointed = null;
    if (page.shown.cell !== null && !(states && states.cells[page.shown.cell])) page.shown.cell = null;
    page.draw();
  };

  /** Of a fragile verdict: shows its "stable" or its "unstable" grasp; of a quality the "lost" load; or all again (null). */
  page.showExample = function (name) {
    const whole = page.fragile ? page.fragile.whole : page.answer;
    page.fragile = name ? { whole, name } : null;
    page.setAnswer(name ? page.examplesOf(whole)[name] : whole);
  };

  function start() {
    const answer = JSON.parse(page.find("answer").textContent);
    page.find("theme").addEventListener("click", () => {
      const theme = document.documentElement.dataset.theme || "auto";
      setTheme(kThemes[(kThemes.indexOf(theme) + 1) % kThemes.length]);
    });
    page.find("exact-numbers").addEventListener("change", (event) => page.show({ exact: event.target.checked }));
    page.find("save-grasp").addEventListener("click", () => page.save(page.fileName(".json"), page.grasp.whole()));
    page
      .find("save-proof")
      .addEventListener("click", () => page.save(page.fileName(".certificate.json"), page.answer.certificate));
    page.find("check").addEventListener("click", page.checkProof);
    page.answer = answer;
    page.grasp.load(answer.grasp);
    page.listenToSphere();
    page.listenToCells();
    enter();
    if (answer.live) page.startLive();
    setTheme(savedTheme());
    let width = window.innerWidth;
    window.addEventListener("resize", () => {
      if (window.innerWidth !== width) page.draw();
      width = window.innerWidth;
    });
    matchMedia(kDark).addEventListener("change", page.draw);
    document.body.dataset.ready = "yes";
  }
  page.views.push(page.restoreFocus);
  start();
})(StickslipPage);
