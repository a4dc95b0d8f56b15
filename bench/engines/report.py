#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes what engines did as one page that loads nothing.

    report.py RESULTS PAGE.html
"""

from __future__ import annotations

import html
import json
import sys
from statistics import median
from pathlib import Path
from typing import Dict, List, NamedTuple

from engines import DIRECT, ENGINES, HERE, ITERATIONS, ITERATIONS_OF, SOLID_ENGINES, UNRANKED, Engine
from forces import Found, judge_forces, summary
from judge import HELD, MOVED, Judged, count, read_results
from pictures import played
from run import read_cases, result_file
from solid_forces import judge_solid_forces
from truth import evidence_of, inertia_of

GAPS = (10, 3, 1)
SHOWN = 6  # failures of an engine that stand open
FORCES_OF = 4  # forces are judged of every fourth case: exact answers to doubles take their time


def cell(by_gap) -> str:
    return "<td>" + " / ".join(str(by_gap[g]) for g in GAPS) + "</td>"


def motion_row(engine: Engine, rate: int, of: List[Judged]) -> str:
    found = count(of)
    verdicts = found["by verdict"]
    cells = "".join(cell(verdicts[v]) for v in ("false hold", "stops", "false slip", "creeps"))
    return (f"<tr><th>{html.escape(engine.name)} {engine.version}</th><td>{rate}</td>{cells}"
            f"<td>{found['creep']:.0e}</td><td>{len(of)}</td></tr>")


def histogram(of: List[Judged]) -> str:
    """Right answers by side and gap: what must hold, from far to near, then what must move."""
    bars = []
    for i, (kind, gap) in enumerate([("must hold", g) for g in GAPS] + [("must move", g) for g in GAPS[::-1]]):
        cases = [j for j in of if (j.case["class"], j.case["gap"]) == (kind, gap)]
        shares = [("right", "ok"), ("creeps", "mid"), ("stops", "mid"), ("false slip", "bad"), ("false hold", "bad")]
        y = 60.0
        for verdict, colour in shares:
            height = 60 * sum(j.verdict == verdict for j in cases) / max(1, len(cases))
            y -= height
            bars.append(f'<rect x="{i * 26 + 2}" y="{y:.1f}" width="22" height="{height:.1f}" class="{colour}"/>')
        bars.append(f'<text x="{i * 26 + 13}" y="72">{"−" if kind == "must hold" else "+"}{gap} %</text>')
    return f'<svg class="histogram" viewBox="0 0 160 76">{"".join(bars)}<path d="M79 0V62"/></svg>'


def forces_row(engine: Engine, found: List[Found]) -> str:
    cells = ""
    table = summary(found)
    for name in ("cone", "balance", "dissipation"):
        at = table.get(name)
        cells += (f"<td>{at['broken']} of {at['of']}</td><td>{at['median']:.0e}</td><td>{at['most']:.0e}</td>"
                  if at else "<td>–</td><td></td><td></td>")
    return f"<tr><th>{html.escape(engine.name)}</th>{cells}</tr>"


def failure(engine: Engine, rate: int, judged: Judged) -> str:
    """A picture that plays, its proof, and how to ask again."""
    case = judged.case
    grasp = case["grasp"]
    return f"""<section class="failure"><h4>{html.escape(grasp["name"])}: {judged.verdict}</h4>
<div class="play" data-run='{played(judged)}'></div>
<p>{html.escape(engine.name)} {engine.version} at {rate} steps a second moved it by {judged.most:.1e} of its size.
It <b>{case["class"]}</b>, {case["gap"]} % from the border. {html.escape(evidence_of(json.dumps(case)))}</p>
<details><summary>Ask again</summary><pre>{html.escape(json.dumps(grasp))}</pre>
<pre>stickslip compare FILE --inertia {inertia_of(case)} --methods weakly-stable-load,strongly-stable-load</pre>
</details></section>"""


def engine_part(engine: Engine, runs: Dict[int, List[Judged]]) -> str:
    out = [f"<h3>{html.escape(engine.name)}</h3>"]
    for rate, of in runs.items():
        out.append(f"<figure>{histogram(of)}<figcaption>{rate} steps a second</figcaption></figure>")
    rate, of = next(iter(runs.items()))
    wrong = [j for j in of if j.verdict.startswith("false")]
    step = max(1, len(wrong) // SHOWN)
    shown = wrong[::step][:SHOWN]
    out.append(f"<p>{len(wrong)} failures at {rate} steps a second" + (":</p>" if wrong else ".</p>"))
    out += [failure(engine, rate, j) for j in shown]
    others = [failure(engine, rate, j) for j in wrong if j not in shown]
    if others:
        out += [f"<details><summary>{len(others)} more</summary>", *others, "</details>"]
    return "\n".join(out)


class Part(NamedTuple):
    """Of the page: rows of two tables, and of each engine histograms and failures."""

    cases: int
    motion: str
    forces: str
    engines: str


def iterations_row(results: Path, engine: Engine, cases: Dict[str, Dict[str, object]]) -> str:
    """Of some cases, by iterations: false holds, false slips, and how far what must hold went, median and most."""
    rate, cells = engine.rates[0], ""
    for times in ITERATIONS:
        folder = results if times == 1 else results / f"iterations-{times}"
        if not result_file(folder, engine, rate).exists():
            return ""
        of = read_results(folder, engine, rate, cases)
        went = [j.most for j in of if j.case["class"] == "must hold"]
        wrong = [sum(j.verdict == v for j in of) for v in ("false hold", "false slip")]
        cells += f"<td>{wrong[0]} / {wrong[1]}</td><td>{median(went):.0e}</td><td>{max(went):.0e}</td>"
    return f"<tr><th>{html.escape(engine.name)}</th>{cells}</tr>"


def part(results: Path, engines: List[Engine], folder: Path, judge) -> Part:
    cases = {c["grasp"]["name"]: c for c in read_cases(folder)}
    motion, forces, parts = [], [], []
    for engine in engines:
        runs = {rate: read_results(results, engine, rate, cases) for rate in engine.rates
                if result_file(results, engine, rate).exists()}
        if not runs:
            motion.append(f'<tr><th>{html.escape(engine.name)}</th>'
                          f'<td colspan="7">not run: {engine.missing()}</td></tr>')
            continue
        motion += [motion_row(engine, rate, of) for rate, of in runs.items()]
        forces.append(forces_row(engine, judge(next(iter(runs.values())))))
        parts.append(engine_part(engine, runs))
        print(f"{engine.name} is judged", flush=True)
    return Part(len(cases), "\n".join(motion), "\n".join(forces), "\n".join(parts))


def main(results: str, page: str) -> None:
    plane = part(Path(results), ENGINES, HERE / "cases", lambda of: judge_forces(of[::FORCES_OF]))
    space = part(Path(results) / "space", SOLID_ENGINES, HERE / "cases/space", judge_solid_forces)
    unranked = "".join(f"<li><b>{html.escape(name)}</b>: {html.escape(why)}</li>" for name, why in UNRANKED.items())
    text = (HERE / "page.html").read_text(encoding="utf-8")
    places = {"HELD": f"{HELD:.0e}", "MOVED": f"{MOVED:.0e}", "FORCES_OF": str(FORCES_OF), "UNRANKED": unranked}
    some = {c["grasp"]["name"]: c for c in list(read_cases())[::ITERATIONS_OF]}
    rows = [iterations_row(Path(results), e, some) for e in ENGINES if e.name != DIRECT]
    places.update(ITERATIONS="\n".join(rows), ITERATED=str(len(some)))
    for name, of in (("", plane), ("SOLID_", space)):
        places.update({f"{name}CASES": str(of.cases), f"{name}MOTION": of.motion, f"{name}FORCES": of.forces,
                       f"{name}ENGINES": of.engines})
    for place, value in places.items():
        text = text.replace(f"<!--{place}-->", value)
    Path(page).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
