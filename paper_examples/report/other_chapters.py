# SPDX-License-Identifier: GPL-3.0-or-later
"""Figs. 5, 6 and 7, and Tables I-III."""

import itertools
from fractions import Fraction

import drawings
import tables
from grasp_chapters import FIG1, FIG4, draw_grasp
from model import dot, fractions, read_contacts, solve3, torque_free_forces


def figures_5_and_6(report):
    chapter = report.chapter("Figs. 5 and 6: slip states on the sphere of motions")
    programs = chapter.programs
    chapter.say("""Contact i sticks under a motion d = (x, y, r) where T_i·d = 0: a plane through the origin, a great
        circle on the sphere of directions. The circles cut the sphere into regions, facets and lines: the slip states
        that a rigid body can have.""")
    programs.run("stickslip", "plot", "states", FIG1, "-o", "fig5.svg")
    chapter.picture("fig5.svg", "Fig. 5 for the grasp of Fig. 1, the sphere seen from both sides.")
    found = programs.json("states", FIG1, "--list")
    paper = programs.json("states", FIG1, "--list", "--engine", "paper")
    states = set(found["states"])
    slips = [contact.row(contact.tangent) for contact in read_contacts(programs.path(FIG1))]
    motions = {}
    for signs in itertools.product("+-0", repeat=3):
        motion = solve3(slips, [drawings.SIGNS[sign] for sign in signs])
        motions["".join(signs)] = motion
    chapter.claim("when does contact 1 stick?", "y counteracts an equal r", str(slips[0] in ((0, 1, -1), (0, -1, 1))),
                  "True", shown="y = r")
    chapter.claim("when does contact 2 stick?", "y = 0", str(slips[1] in ((-1, 0, -1), (1, 0, 1))), "True",
                  because="the text on contact 2 does not fit the grasp of Fig. 1: Fig. 5 shows another, or misprints x = −r as y = 0",
                  shown="x = −r")
    chapter.claim("states of the grasp of Fig. 1, all-stick included", "3 planes, at most 3³ = 27",
                  str(states == set(motions)), "True", shown="27, each with a motion")
    chapter.claim("the paper's own Steps 1-3", "the same but all-stick", str(set(paper["states"]) == states - {"000"}), "True",
                  shown="26, the same")
    counts = [found[name] for name in ("faces", "edges", "vertices")]
    chapter.claim("regions, facets, lines", "V, E, F of the dual", str([sum(s.count("0") == k for s in states) for k in range(3)]),
                  str(counts), shown=", ".join(map(str, counts)))
    lines = [s for s in states if s.count("0") == 2]
    edges = [s for s in states if s.count("0") == 1]
    sides = [[e for e in edges if all(s in ("0", t) for s, t in zip(line, e))] for line in lines]
    twice = all(sum(e in side for side in sides) == 2 for e in edges)
    chapter.claim("Step 3: E − V + 1 cycles and their symmetric sum are the dual's faces", "F = E − V + 2",
                  str(twice and len(lines) == len(edges) - 8 + 2), "True", shown="6 = 12 − 8 + 2, each edge in two faces")
    chapter.show_claims()
    drawings.draw_dual(programs.path("fig6.svg"), programs.path("fig5.svg"),
                       {s: d for s, d in motions.items() if "0" not in s})
    chapter.picture("fig6.svg", "Fig. 6: one corner for each region. Three planes in general position have a cube as their dual.")
    chapter.say("""The corners are the motions with T_i·d = ±1, so this polyhedron is exact: its edges cross one
        plane each, its faces surround one line each.""")
    programs.run("stickslip", "plot", "states", FIG4, "-o", "fig4_states.svg")
    chapter.say("""The grasp of Fig. 4 is degenerate: its four contacts lie on two lines, so two circles remain, and 9 states.
        The dual is then no polyhedron, and Step 3 does not apply.""")
    chapter.picture("fig4_states.svg", "The slip states of the grasp of Fig. 4.")
    chapter.commands()


def table_1(report, lines, total):
    chapter = report.chapter("Table I: the grasp of Fig. 1")
    chapter.say("""Forces f = (f_n, f_t) as the paper prints them. Motions are not unique where a contact is open, so the
        question is not whether ours are equal, but whether the printed motion and forces satisfy every condition.""")
    tables.show_force_table(chapter, lines, 3, 7)
    made = total.split()[2]
    chapter.claim("all comparisons of Tables I-III in [paper_tables.txt](paper_tables.txt)", "", total,
                  f"{made} of {made} comparisons agree")
    chapter.show_claims()
    chapter.say("""**Signs.** The tables have w as the load on the object, opposite to Eq. 1; and Eq. 4 needs the preload added.
        [paper_tables.txt](paper_tables.txt) also shows motions and forces of our own, and loads 10⁻¹⁸ beyond each threshold.""")
    chapter.say("`paper_tables grasps`")


def table_2(report, lines):
    chapter = report.chapter("Table II: how many slip states")
    chapter.say("""The paper's #(S) are the cells V + E + F of the arrangement, 4 m (m − 1) + 2 for m circles in general
        position. It calls them slip states, which is close: two contacts have 10 cells but only 3² = 9 sign vectors, as
        opposite vertices share one; and all-stick, d = 0, is on no sphere, though rows of the tables need it.""")
    tables.show_counts(chapter, lines)
    chapter.say("""The paper's times, 0.006 s at m = 2 to 35.7 s at m = 9, depend on the machine; `bench/README.md` measures
        the paper's method and faster ones side by side.""", "`paper_tables grasps`")


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
    chapter.say("""**Misprints.** Row w = (0, 0, 3), P = 0: f₁ and f₃ are (1, 0.5); as printed, (0, 0.5) is friction without a
        normal force. Last row: d = (0, 0.025, −0.25) was surely meant to be (0, 0.25, −0.25); both are solutions,
        as any (0, y, −0.25) with |y| ≤ 0.25 is.""")
    draw_grasp(chapter, "table3_torque.svg", "w = (0, 0, 3) without preload: two contacts open, two hold.",
               FIG4, "0,0,3", "0")
    chapter.commands()


def outline(*vertices):
    """One area below an outline that comes along (1, 0) and leaves along (-1, 0)."""
    return [{"outlines": [{"closed": False, "from": ["1", "0"], "vertices": [list(v) for v in vertices],
                           "to": ["-1", "0"]}]}]


def limit(direction, preload):
    """The last resisted multiple if exactly w_y <= max(0, preload - |w_x|/2) is; None if there is none."""
    x, y = direction
    return None if y <= 0 else Fraction(preload) / (y + Fraction(abs(x), 2))


def figure_7(report):
    chapter = report.chapter("Fig. 7: which forces are resisted")
    programs = chapter.programs
    chapter.say("Forces in the plane, at zero torque, on the grasp of Fig. 1. Three answers to one question.")
    chapter.say("""**(a) The grasp wrench space** (L1: the normal forces add up to at most 1) asks only whether forces in the cones
        exist. It holds the origin inside, so scaled up it claims every force, preloaded or not.""")
    space = programs.method("grasp wrench space, L1", FIG1, "0,0,0", "0")
    # The program gives the forces of the contacts; the load that they balance is opposite.
    slice_ = [tuple(-c for c in fractions(vertex)) for vertex in space["evidence"]["zero_torque_slice"]]
    possible = {tuple(-c for c in force) for force in torque_free_forces(read_contacts(programs.path(FIG1)))}
    sides = list(zip(slice_, slice_[1:] + slice_[:1]))
    exact = set(slice_) <= possible and all(dot((a[1] - b[1], b[0] - a[0]), (p[0] - a[0], p[1] - a[1])) >= 0
                                            for a, b in sides for p in possible)
    inside = all(a[0] * b[1] - a[1] * b[0] > 0 for a, b in sides)
    chapter.claim("(a) the slice is the hull of all torque-free combinations of two cone edges", "Fig. 7(a)", str(exact), "True",
                  shown="so it is")
    chapter.claim("(a) the origin is inside: some lawful forces balance any force", "arbitrary forces", str(inside), "True", shown="inside")
    chapter.say("""**(b), (c) The passive model** says which forces are resisted, of any magnitude. Without preload: exactly
        those with w_y ≤ 0. With preload 1: exactly w_y ≤ max(0, 1 − |w_x|/2). The paper bisects along sampled directions;
        these outlines are exact, borders included.""")
    directions = [d for d in itertools.product((-2, -1, 0, 1, 2), repeat=2) if d in
                  {(1, 0), (-1, 0), (0, 1), (0, -1)} or 0 not in d and abs(d[0] * d[1]) < 4]
    for part, preload, vertices in (("b", "0", [("0", "0")]), ("c", "1", [("2", "0"), ("0", "1"), ("-2", "0")])):
        region = programs.json("region", FIG1, "--preload", preload)
        whole = {key: region[key] for key in ("areas", "curves", "points", "empty", "whole_plane")}
        chapter.claim(f"({part}) the resisted forces, P = {preload}", f"Fig. 7({part})", str(whole),
                      str({"areas": outline(*vertices), "curves": [], "points": [], "empty": False, "whole_plane": False}),
                      shown="w_y ≤ 0" if preload == "0" else "w_y ≤ max(0, 1 − \\|w_x\\|/2)")
        shown = programs.take_commands()
        margins = [programs.margin(FIG1, f"{x},{y},0", preload) for x, y in directions]
        expected = [f"[0, {'oo)' if limit(d, preload) is None else f'{limit(d, preload)}]'}" for d in directions]
        programs.keep_commands(shown)
        chapter.claim(f"({part}) exact margins along {len(directions)} directions", "bisection", str(margins), str(expected),
                      shown="all end on that border")
    chapter.show_claims()
    for part, preload in (("b", "0"), ("c", "1")):
        programs.run("stickslip", "plot", "region", FIG1, "--preload", preload, "-o", f"fig7{part}.svg")
    drawings.draw_slice(programs.path("fig7a.svg"), programs.path("fig7b.svg"), slice_)
    chapter.picture("fig7a.svg", "Fig. 7(a): the L1 grasp wrench space at torque 0, as applied forces.")
    chapter.picture("fig7b.svg", "Fig. 7(b): resisted without preload.")
    chapter.picture("fig7c.svg", "Fig. 7(c): resisted with preload 1.")
    chapter.commands()
