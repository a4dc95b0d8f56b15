# SPDX-License-Identifier: GPL-3.0-or-later
"""Figs. 1, 3 and 4: grasps, loads, and what other methods say of them."""

import json

from model import read_contacts, within_cones

FIG1, FIG3, FIG4 = (f"grasps/fig{n}.json" for n in (1, 3, 4))


def vector(words):
    return f"({words.replace(',', ', ').replace('-', '−')})"


def ask(chapter, grasp, wrench, preload, paper, expected, because=None):
    verdict, proof = chapter.programs.verdict(grasp, wrench, preload)
    chapter.claim(f"w = {vector(wrench)}, P = {preload}: does it hold?", paper, verdict, expected, because,
                  f"{verdict} ([proof]({proof}))")


def ask_margin(chapter, grasp, direction, preload, paper, expected):
    found, proof = chapter.programs.proved_margin(grasp, direction, preload)
    chapter.claim(f"λ {vector(direction)}, P = {preload}: for which λ ≥ 0?", paper, found, expected,
                  shown=f"λ ∈ {found.replace('oo', '∞')} ([proof]({proof}))")


def ask_method(chapter, method, grasp, wrench, preload, paper, expected):
    entry = chapter.programs.method(method, grasp, wrench, preload)
    chapter.claim(f"{method}: w = {vector(wrench)}, P = {preload}", paper, entry["verdict"], expected,
                  shown=f"{entry['verdict']}: {entry['why']}")


def draw_grasp(chapter, name, caption, grasp, wrench, preload):
    chapter.programs.run("stickslip", "plot", "grasp", grasp, "--wrench", wrench, "--preload", preload, "-o", name)
    chapter.picture(name, caption)


def figure_1(report):
    chapter = report.chapter("Fig. 1: what a preload is for")
    chapter.say("""Three contacts hold an object from the left, from below and from the right. The paper asks
        for two loads. **w₁** pushes the object up: only friction at contacts 1 and 3 can hold it, and friction
        needs a normal force, so it needs a preload. **w₂** pushes it down onto contact 2, which answers
        whatever the magnitude.""")
    ask(chapter, FIG1, "0,1,0", "0", "not resisted", "unstable")
    ask(chapter, FIG1, "0,1,0", "1", "resisted", "stable")
    ask_margin(chapter, FIG1, "0,1,0", "0", "none", "[0, 0]")
    ask_margin(chapter, FIG1, "0,1,0", "1", "1 holds, 1.1 does not", "[0, 1]")
    ask_margin(chapter, FIG1, "0,-1,0", "0", "all", "[0, oo)")
    ask_margin(chapter, FIG1, "0,-1,0", "1", "all", "[0, oo)")
    ask_method(chapter, "weakly stable load", FIG1, "0,1,0", "0", "lawful forces exist", "stable")
    ask_method(chapter, "weakly stable load", FIG1, "0,-1,0", "0", "lawful forces exist", "stable")
    ask_method(chapter, "frictionless stable load", FIG1, "0,1,0", "0", "unstable without friction", "unstable")
    chapter.show_claims()
    chapter.say("""Each verdict and each range carries a proof, which `stickslip-check`, a program that shares
        no code with the solver, accepted. The limit with preload 1 is exactly 1: each of contacts 1 and 3 gives
        at most μ·P = 1/2.""")
    draw_grasp(chapter, "fig1_up.svg", "Fig. 1, left: w₁ = (0, 1, 0) with preload 1 is at its limit, both forces on "
               "the edge of their cones.", FIG1, "0,1,0", "1")
    draw_grasp(chapter, "fig1_up_no_preload.svg", "The same load without preload: no motion makes forces that hold.",
               FIG1, "0,1,0", "0")
    draw_grasp(chapter, "fig1_down.svg", "Fig. 1, right: w₂ = (0, −1, 0) without preload is carried by the contact "
               "below.", FIG1, "0,-1,0", "0")
    chapter.commands()
    chapter.say("Fig. 2 of the paper explains notation; there is nothing to compute.")


def figure_3(report):
    chapter = report.chapter("Fig. 3: linear friction rejects too much")
    chapter.say("""The grasp of Fig. 1 under w₂, without preload. Springs along the tangents, as in linear
        compliance, put friction on contacts 1 and 3, which have no normal force to allow it. So a linear model
        calls the grasp unstable. Yet it clearly holds.""")
    ask(chapter, FIG3, "0,-1,0", "0", "holds", "stable")
    ask_method(chapter, "linear compliance", FIG3, "0,-1,0", "0", "wrongly unstable", "unstable")
    chapter.show_claims()
    draw_grasp(chapter, "fig3.svg", "Fig. 3: contact 2 alone carries the load; nothing rubs at 1 and 3.",
               FIG3, "0,-1,0", "0")
    chapter.commands()


def with_friction(chapter, friction):
    """The grasp of Fig. 4 with another coefficient, written beside the others."""
    name = f"grasps/fig4_mu_{friction.replace('/', '_')}.json"
    with open(chapter.programs.path(FIG4), encoding="utf-8") as file:
        grasp = json.load(file)
    grasp["defaults"]["friction"] = friction
    grasp["name"] = f"Fig. 4, mu = {friction}"
    with open(chapter.programs.path(name), "w", encoding="utf-8") as file:
        file.write(json.dumps(grasp) + "\n")
    return name


def ask_cones(chapter, grasp, friction, wrench, preload, expected, because=None, law="unilateral"):
    options = () if law == "unilateral" else ("--normal-law", law)
    entry = chapter.programs.method("friction cones alone", grasp, wrench, preload, *options)
    verdict = entry["verdict"]
    if verdict == "stable":
        contacts, evidence = read_contacts(chapter.programs.path(grasp)), entry["evidence"]
        if not within_cones(contacts, int(preload), wrench.split(","), evidence["twist"], evidence["forces"]):
            verdict = "stable, by forces that break a condition"
    chapter.claim(f"cones alone: μ = {friction}, w = {vector(wrench)}, P = {preload}"
                  + (", Eqs. 2 and 4 literally" if law == "bilateral" else ""),
                  "accept", verdict.replace("unstable", "reject").replace("stable", "accept"), expected, because)


def figure_4(report):
    chapter = report.chapter("Fig. 4: friction cones alone accept too much, but not at μ = 1/2")
    chapter.say("""Four contacts, two from the left and two from the right, and a load along y. Without preload
        nothing holds it. With preload 1 friction holds up to 4 μ P = 2.""")
    ask(chapter, FIG4, "0,2,0", "0", "unstable", "unstable")
    ask(chapter, FIG4, "0,2,0", "1", "stable", "stable")
    ask_margin(chapter, FIG4, "0,1,0", "0", "none", "[0, 0]")
    for direction in ("0,1,0", "0,-1,0"):
        ask_margin(chapter, FIG4, direction, "1", "up to 4 μ = 2", "[0, 2]")
    chapter.show_claims()
    draw_grasp(chapter, "fig4.svg", "Fig. 4: w = (0, 2, 0) without preload. The object slides out.",
               FIG4, "0,2,0", "0")
    draw_grasp(chapter, "fig4_preload.svg", "With preload 1 the same load is at its limit: all four contacts are on "
               "the edge of their cones.", FIG4, "0,2,0", "1")
    chapter.say("""**The paper's claim.** Friction cones without maximum dissipation (Eqs. 1-4) would accept the
        load, *irrespective of its magnitude or of the preload*: a rotation loads the contacts and so makes the
        friction that is needed.""",
        """**What exact arithmetic says.** That is so for μ > 1, and not for the μ = 1/2 of the paper's tables.""")
    spent = "while μ ≤ 1, the friction that a rotation makes possible is spent on the torque of that rotation"
    for friction, preload in (("1/2", "0"), ("1/2", "1"), ("1", "0")):
        grasp = FIG4 if friction == "1/2" else with_friction(chapter, friction)
        ask_cones(chapter, grasp, friction, "0,3,0", preload, "reject", spent)
    for friction, preload in (("1.000000000000000001", "0"), ("3/2", "0"), ("3/2", "1")):
        ask_cones(chapter, with_friction(chapter, friction), friction, "0,1000000,0", preload, "accept")
    rough = with_friction(chapter, "3/2")
    ask_cones(chapter, rough, "3/2", "0,3,0", "0", "reject", law="bilateral",
              because="contacts that may not open let this object move along y only, which loads none of them")
    chapter.show_claims()
    chapter.say("""*Why, without preload.* Let d = (x, y, r) with r ≥ 0; r < 0 is its mirror image. The springs
        push with (r − x)⁺, (−x − r)⁺, (x + r)⁺ and (x − r)⁺ at contacts 1 to 4. Whatever the signs, their sum
        along x is −2x, so balance needs x = 0. Then contacts 1 and 3 push with r each, and the others not at
        all. Both normal forces turn the object clockwise, with torque 2 r in all, and only friction at these
        two contacts can turn it back: with torque at most 2 μ r. For μ < 1 that is too little. For μ = 1 it
        takes all their friction, and that adds up to no force along y. For μ > 1 friction up to 2 (μ − 1) r is
        left to carry the load, and r may be as large as it takes.""",
        """Forces that the cones accept were substituted into Eqs. 1-4 by this report's own arithmetic. A test
        compares the method with Z3 (`tests/earlier/earlier_methods_z3_test.cpp`).""",
        """So the lesson of Fig. 4 stands, at larger friction: with μ = 3/2 the cones alone accept any load,
        while the passive model rejects all of them, because contacts that slip would have to push along.""")
    ask(chapter, rough, "0,1000000,0", "0", "unstable", "unstable")
    ask_margin(chapter, rough, "0,1,0", "0", "none", "[0, 0]")
    chapter.show_claims()
    draw_grasp(chapter, "fig4_rough.svg", "μ = 3/2, no preload: wide cones, and still no passive equilibrium.",
               rough, "0,3,0", "0")
    chapter.commands()


def three_states(report):
    chapter = report.chapter("Section VI: three-state compliance rejects too much")
    chapter.say("""Prattichizzo et al. let each contact stick with a linear spring, slip without any friction,
        or be detached, and try all 3^m combinations. The paper says what this repairs, and what not.""")
    method = "three-state compliance"
    for wrench in ("0,-1,0", "5,-1,0", "-3,-2,0"):
        ask_method(chapter, method, FIG1, wrench, "0", "now resisted, w_y ≤ 0", "stable")
    ask_method(chapter, method, FIG1, "0,1,0", "1", "wrongly unstable", "unstable")
    ask(chapter, FIG1, "0,1,0", "1", "stable", "stable")
    verdicts = [chapter.programs.method(method, FIG1, f"0,{load},0", "1")["verdict"]
                for load in ("1/2", "0.500000000000000001")]
    chapter.check(f"{method}: P = 1 and w_y = 1/2, or 10⁻¹⁸ more", "wrong where w_y ≥ 0",
                  verdicts == ["stable", "unstable"], "stable, unstable",
                  because="with P = 1 the springs stay in their cones up to w_y = 1/2")
    chapter.show_claims()
    chapter.say("""So the paper's example is right: at w_y = 1 the method rejects a load that holds. The failure
        begins just beyond w_y = 1/2, not at 0.""")
    chapter.commands()
