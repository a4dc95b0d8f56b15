// SPDX-License-Identifier: GPL-3.0-or-later
//
// The proof: checked in this page by code that shares nothing with the program, and given away as a file.
(function (page) {
  const { html } = page;
  let result = null;

  /** The tolerances of a list such as "friction=5%,wrench=ball:1:length=2", by their kind. */
  page.tolerances = (text) =>
    Object.fromEntries(
      (text || "")
        .split(",")
        .filter(Boolean)
        .map((entry) => [entry.slice(0, entry.indexOf("=")), entry.slice(entry.indexOf("=") + 1)]),
    );
  /** Whether it is asked about a ball of loads. */
  page.hasBall = () => /^ball:/.test(page.tolerances((page.answer.question || {}).uncertain).wrench);

  /** The question as the checker wants it: what the answer says was asked, lists and tolerances taken apart. */
  function question() {
    const { wrench, uncertain, ...rest } = page.answer.question || {};
    const asked = Object.fromEntries(Object.entries(rest).filter(([, value]) => value !== null));
    if (wrench) asked.wrench = typeof wrench === "string" ? wrench.split(",") : wrench;
    if (uncertain) asked.uncertain = page.tolerances(uncertain);
    return asked;
  }

  page.checkProof = function () {
    const { certificate } = page.answer;
    const start = performance.now();
    let report;
    try {
      const most = 30; // coordinates that the checker reads
      report =
        JSON.parse(certificate).question.wrench.length > most
          ? { answer: "not judged", found: "of more than 30 coordinates stickslip-check and check.py judge the proof" }
          : StickslipCheck.check(page.answer.grasp, certificate, question());
    } catch (error) {
      report = { answer: "not checked", found: String(error) };
    }
    result = { certificate, report, milliseconds: performance.now() - start };
    drawProof();
    return report;
  };

  page.save = function (name, text) {
    const link = html("a", {
      download: name,
      href: URL.createObjectURL(new Blob([text], { type: "application/json" })),
    });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
  };
  page.fileName = (ending) =>
    (page.answer.name || "grasp")
      .replace(/[^A-Za-z0-9]+/g, "-")
      .replace(/^-|-$/g, "")
      .slice(0, 40) + ending;

  function details(report) {
    const text = [report.rule, report.place, report.found].filter(
      (part) => part !== undefined && part !== null && part !== "",
    );
    return text.length > 0 ? ": " + text.join(": ") : "";
  }

  const sizeText = (bytes) => (bytes < 1000 ? bytes + " bytes" : page.near(bytes / 1000, 3) + " kB");

  function drawProof() {
    const { certificate, decide } = page.answer;
    const has = Boolean(certificate);
    const checker = typeof StickslipCheck !== "undefined";
    page.find("check").hidden = !has || !checker;
    page.find("save-proof").hidden = !has;
    page.find("proof-panel").hidden = !has;
    if (!has) return;
    page.put(
      "proof-size",
      "The proof has " +
        sizeText(new Blob([certificate]).size) +
        (page.refutation().leaves.length ? " and " + page.count(page.refutation().leaves.length, "leaf", "leaves") : "") +
        ".",
    );
    if (!result || result.certificate !== certificate) return void page.put("proof-result");
    const { report, milliseconds } = result;
    const accepted = report.answer === "accepted";
    const place = page.put(
      "proof-result",
      html("strong", {}, (accepted ? "\u2713 " : "\u2715 ") + report.answer),
      accepted
        ? ": " + (decide ? decide.verdict : "") + ", checked here in " + page.near(milliseconds, 2) + " ms."
        : details(report),
    );
    place.dataset.answer = report.answer;
  }
  page.views.push(drawProof);
})(StickslipPage);
