# SPDX-License-Identifier: GPL-3.0-or-later
"""Figs. 5, 6 and 7, and Tables I-III."""

import itertools
from fractions import Fraction
from math import gcd

import drawings
import tables
from grasp_chapters import FIG1, FIG4, draw_grasp
from model import cross, fractions, read_contacts, solve3, torque_free_forces

DIRECTIONS = [(x, y) for x in (-2, -1, 0, 1, 2) for y in (-2, -1, 0, 1, 2) if gcd(x, y) == 1]  # 16


def figures_5_and_6(report):
    chapter = report.chapter("Figs. 5 and 6: slip states on the sphere of motions")
    programs = chapter.programs
    chapter.say("""Contact i sticks under a motion d = (x, y, r) where T_i·d = 0: a plane through the origin, a
        great circle on the sphere of directions. The circles cut the sphere into regions, facets and lines: the
        slip states that a rigid body can have.""")
    programs.run("stickslip", "plot", "states", FIG1, "-o", "fig5.svg")
    chapter.picture("fig5.svg", "Fig. 5 for the grasp of Fig. 1, the sphere seen from both sides.")

    found = programs.json("states", FIG1, "--list")
    states = set(found["states"])
    by_steps = set(programs.json("states", FIG1, "--list", "--engine", "paper")["states"])
    slips = [contact.row(contact.tangent) for contact in read_contacts(programs.path(FIG1))]
    motions = {"".join(signs): solve3(slips, [drawings.SIGNS[sign] for sign in signs])
               for signs in itertools.product("+-0", repeat=3)}
    regions, facets, lines = ([s for s in sorted(states - {"000"}) if s.count("0") == k] for k in range(3))
    around = {line: [f for f in facets if all(s in ("0", t) for s, t in zip(line, f))] for line in lines}

    chapter.check("when does contact 1 stick?", "y counteracts an equal r", slips[0] == (0, 1, -1), "y = r")
    chapter.check("when does contact 2 stick?", "y = 0", slips[1] == (-1, 0, -1), "x = −r",
                  because="the text on contact 2 does not fit the grasp of Fig. 1: Fig. 5 shows another, or misprints "
                          "x = −r as y = 0")
    chapter.check("states of the grasp of Fig. 1, all-stick included", "3 planes, at most 3³ = 27",
                  states == set(motions), "27, each with a motion")
    chapter.check("the paper's own Steps 1-3", "the same but all-stick", by_steps == states - {"000"}, "26, the same")
    chapter.check("regions, facets, lines", "corners, edges, faces of the dual",
                  [len(cells) for cells in (regions, facets, lines)] == [8, 12, 6]
                  and [found[name] for name in ("faces", "edges", "vertices")] == [8, 12, 6], "8, 12, 6")
    chapter.check("Step 3: the dual's faces are E − V + 1 cycles and their symmetric sum", "F = E − V + 2",
                  all(sum(f in cycle for cycle in around.values()) == 2 for f in facets)
                  and len(lines) == len(facets) - len(regions) + 2, "6 = 12 − 8 + 2, each edge in two cycles")
    chapter.show_claims()

    drawings.draw_dual(programs.path("fig6.svg"), programs.path("fig5.svg"), {s: motions[s] for s in regions})
    chapter.picture("fig6.svg", "Fig. 6: one corner for each region. Three planes in general position have a cube, "
                                "here a slanted one, as their dual.")
    chapter.say("""The corners are the motions with T_i·d = ±1, so this polyhedron is exact: each edge crosses
        one plane, each face surrounds one line.""")
    programs.run("stickslip", "plot", "states", FIG4, "-o", "fig4_states.svg")
    chapter.say("""The grasp of Fig. 4 is degenerate: its four contacts lie on two lines, so two circles remain,
        and 9 states in 10 cells.""")
    chapter.picture("fig4_states.svg", "The slip states of the grasp of Fig. 4.")
    counts = [programs.json("states", FIG4, *engine)[name]
              for engine, name in (((), "cells"), ((), "distinct_states"), (("--engine", "paper"), "cells"))]
    chapter.check("cells and states of the grasp of Fig. 4; cells that Steps 1-3 find", "all of them",
                  counts == [10, 9, 4], "10, 9; 4",
                  because="two contacts on one line change their signs together, so on Fig. 4 Step 2 finds no two "
                          "regions that differ in one sign")
    chapter.show_claims()
    chapter.commands()


def table_1(report, lines, total):
    chapter = report.chapter("Table I: the grasp of Fig. 1")
    chapter.say("""Forces f = (f_n, f_t) as the paper prints them. Motions are not unique where a contact is
        open, so the question is not whether ours are equal, but whether the printed motion and forces satisfy
        every condition.""")
    tables.show_force_table(chapter, lines, 3, 7)
    made = total.split()[2]
    chapter.claim("all comparisons of Tables I-III in [paper_tables.txt](paper_tables.txt)", "", total,
                  f"{made} of {made} comparisons agree")
    chapter.show_claims()
    chapter.say("""**Signs.** The tables have w as the load on the object, opposite to Eq. 1; and Eq. 4 needs
        the preload added. [paper_tables.txt](paper_tables.txt) also shows motions and forces of our own, and
        loads 10⁻¹⁸ beyond each threshold.""")
    chapter.say("`paper_tables grasps`")


def table_2(report, lines):
    chapter = report.chapter("Table II: how many slip states")
    chapter.say("""The paper's #(S) are the cells V + E + F of the arrangement, 4 m (m − 1) + 2 for m circles in
        general position. It calls them slip states, which is close: two contacts have 10 cells but only 3² = 9
        sign vectors, as opposite vertices share one; and all-stick, d = 0, is on no sphere, though rows of the
        tables need it.""")
    tables.show_counts(chapter, lines)
    chapter.say("""The paper's times, 0.006 s at m = 2 to 35.7 s at m = 9, depend on the machine;
        `bench/README.md` measures the paper's method and faster ones side by side.""", "`paper_tables grasps`")


def table_3(report, lines):
    chapter = report.chapter("Table III: the grasp of Fig. 4")
    tables.show_force_table(chapter, lines, 4, 10)
    programs = chapter.programs
    for torque in ("3", "-3"):
        verdict = programs.json("decide", FIG4, "--wrench", f"0,0,{torque}", "--preload", "0",
                                "--normal-law", "bilateral")["verdict"]
        chapter.claim(f"w = (0, 0, {torque}), P = 0 by Eqs. 2 and 4 literally", "stable", verdict, "unstable",
                      because="these rows need contacts that open, c_n = max(0, P − k N·d)")
    intended = sum(line.strip() == "intended d and f solve it: agrees" for line in lines)
    chapter.claim("misprinted rows that are solutions as they were meant", "2", str(intended), "2")
    chapter.show_claims()
    chapter.say("""**Misprints.** Row w = (0, 0, 3), P = 0: f₁ and f₃ are (1, 0.5); as printed, (0, 0.5) is
        friction without a normal force. Last row: d = (0, 0.025, −0.25) was surely meant to be (0, 0.25,
        −0.25); both are solutions, as any (0, y, −0.25) with |y| ≤ 0.25 is.""")
    draw_grasp(chapter, "table3_torque.svg", "w = (0, 0, 3) without preload: two contacts open, two hold.",
               FIG4, "0,0,3", "0")
    chapter.commands()


def outline(*vertices):
    """One area below an outline that comes along (1, 0) and leaves along (-1, 0)."""
    return [{"outlines": [{"closed": False, "from": ["1", "0"], "vertices": [list(v) for v in vertices],
                           "to": ["-1", "0"]}]}]


def last_multiple(direction, preload):
    """The margin if exactly w_y <= max(0, preload - |w_x|/2) is resisted."""
    x, y = direction
    return "[0, oo)" if y <= 0 else f"[0, {Fraction(preload) / (y + Fraction(abs(x), 2))}]"


def wrench_space_slice(chapter):
    """Checks what `compare` says of the L1 grasp wrench space at torque 0, and returns it as applied forces."""
    programs = chapter.programs
    space = programs.method("grasp wrench space, L1", FIG1, "0,0,0", "0")

    def opposite(force):  # the program gives the forces of the contacts; the load that they balance is opposite
        return tuple(-c for c in force)
    polygon = [opposite(fractions(vertex)) for vertex in space["evidence"]["zero_torque_slice"]]
    possible = {opposite(force) for force in torque_free_forces(read_contacts(programs.path(FIG1)))}
    sides = list(zip(polygon, polygon[1:] + polygon[:1]))

    def left_of(side, point):
        (ax, ay), (bx, by) = side
        return cross((bx - ax, by - ay), (point[0] - ax, point[1] - ay))
    chapter.check("(a) the slice", "Fig. 7(a)",
                  set(polygon) <= possible and all(left_of(side, point) >= 0 for side in sides for point in possible),
                  "a hexagon: the hull of all torque-free combinations of two cone edges")
    chapter.check("(a) which forces have lawful contact forces?", "arbitrary ones",
                  all(left_of(side, (0, 0)) > 0 for side in sides), "any: the origin is inside")
    return polygon


def resisted_forces(chapter, part, preload, vertices, shown):
    programs = chapter.programs
    region = programs.json("region", FIG1, "--preload", preload)
    chapter.check(f"({part}) which forces are resisted, P = {preload}?", f"Fig. 7({part})",
                  region["areas"] == outline(*vertices) and not region["curves"] and not region["points"], shown)
    shown_commands = programs.take_commands()
    margins = {d: programs.margin(FIG1, f"{d[0]},{d[1]},0", preload) for d in DIRECTIONS}
    programs.keep_commands(shown_commands)
    chapter.check(f"({part}) `margin` along {len(DIRECTIONS)} directions, P = {preload}", "bisection",
                  all(margin == last_multiple(d, preload) for d, margin in margins.items()), "ends on that border")


def figure_7(report):
    chapter = report.chapter("Fig. 7: which forces are resisted")
    programs = chapter.programs
    chapter.say("""Forces in the plane, at zero torque, on the grasp of Fig. 1: three answers to one question.""",
        """**(a) The grasp wrench space** (L1: the normal forces add up to at most 1) asks only whether forces
        in the cones exist. It holds the origin inside, so scaled up it claims every force, preloaded or not.""",
        """**(b), (c) The passive model** says which forces are resisted, of any magnitude. Without preload:
        exactly those with w_y ≤ 0. With preload 1: exactly those with w_y ≤ max(0, 1 − |w_x|/2). The paper
        bisects along sampled directions; these outlines are exact, borders included.""")
    polygon = wrench_space_slice(chapter)
    resisted_forces(chapter, "b", "0", [("0", "0")], "w_y ≤ 0")
    resisted_forces(chapter, "c", "1", [("2", "0"), ("0", "1"), ("-2", "0")], "w_y ≤ max(0, 1 − \\|w_x\\|/2)")
    chapter.show_claims()
    for part, preload in (("b", "0"), ("c", "1")):
        programs.run("stickslip", "plot", "region", FIG1, "--preload", preload, "-o", f"fig7{part}.svg")
    drawings.draw_slice(programs.path("fig7a.svg"), programs.path("fig7b.svg"), polygon)
    chapter.picture("fig7a.svg", "Fig. 7(a): the L1 grasp wrench space at torque 0, as applied forces.")
    chapter.picture("fig7b.svg", "Fig. 7(b): resisted without preload.")
    chapter.picture("fig7c.svg", "Fig. 7(c): resisted with preload 1.")
    chapter.commands()
