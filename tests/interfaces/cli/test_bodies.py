# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies, links and springs: thresholds in closed form from both sides, every verdict through all checkers that
judge it, and Newton's method, written from mechanics, against all that are unstable."""

import glob
import json
import math
import os
import re
import unittest
from fractions import Fraction as F

import numpy as np
from bodies_newton import equilibria
from bodies_smt import statics
from test_cli import HERE, SANITIZED, quick_checker, run, stickslip
from test_space import Z3, Space

ROOT = os.path.join(HERE, "..", "..", "..")


def text(x):
    return [text(e) for e in x] if isinstance(x, (list, tuple)) else str(F(x))


def contact(of, position, normal, by=None, **laws):
    result = {"of": of, "position": text(position), "normal": text(normal), **{k: text(v) for k, v in laws.items()}}
    return {**result, "by": by} if by else result


def weight(body, w, at):
    return {"body": body, "weight": str(F(w)), "at": text(at)}


def force(body, f, at):
    return {"body": body, "force": text(f), "at": text(at)}


def grasp(bodies, contacts, loads, **others):
    return {"format": "stickslip-grasp/3",
            "bodies": [b if isinstance(b, dict) else {"name": b} for b in bodies],
            "contacts": contacts, "loads": loads, **others}


def stack(widths, heights, frictions, weights, push, height):
    """Blocks one on the other, pushed at the uppermost; and the least push that moves them, by statics."""
    names = [f"b{k}" for k in range(len(widths))]
    contacts, loads, bottom, least = [], [], F(0), None
    for k, name in enumerate(names):
        contacts += [contact(name, (s * widths[k], bottom), (0, 1), by=names[k - 1] if k else None,
                             friction=frictions[k]) for s in (-1, 1)]
        loads.append(weight(name, weights[k], (0, bottom + heights[k] / 2)))
        above = sum(weights[k:])
        limit = min(frictions[k] * above, above * widths[k] / (height - bottom))
        least = limit if least is None else min(least, limit)
        bottom += heights[k]
    return least, grasp(names, contacts, [*loads, force(names[-1], (push, 0), (0, height))])


def random_assembly(rng, dim):
    """Two or three bodies, free or on hinges and slides, and whatever joins them."""
    def number(a, b):
        return F(rng.randint(a, b), rng.choice((1, 2, 3)))

    def point(b):
        return [number(-b, b) for _ in range(dim)]

    def unit():
        n = [F(0)] * dim
        n[:] = rng.choice(([1], [3, 4]) if dim == 2 else ([1], [3, 4], [1, 2, 2])) + n
        n = [rng.choice((1, -1)) * x for x in n[:dim]]
        rng.shuffle(n)
        return n

    bodies, joints = ["body"], []
    for j in range(rng.randint(1, 2)):
        kind = rng.choice(("free", "hinge", "slide"))
        name = f"n{j}"
        if kind == "free":
            bodies.append(name)
            continue
        if kind == "hinge":
            place = text(point(3)) if dim == 2 else {"at": text(point(3)), "axis": text(unit())}
        else:
            place = text([1, *point(2)[1:]])
        link = {"name": name, kind: place}
        if rng.random() < 0.4 and j:
            link["on"] = "n0"
        bodies.append(link)
        joints.append({"turns": {name: str(F(rng.choice((1, -1, 2))))},
                       **({"stiffness": str(number(1, 4))} if rng.random() < 0.7 else {}),
                       **({"torque": str(number(-2, 2))} if rng.random() < 0.5 else {})})
    names = [b if isinstance(b, str) else b["name"] for b in bodies]
    links = [b["name"] for b in bodies if not isinstance(b, str)]
    contacts = []
    for _ in range(rng.randint(3, 5) + 2 * (dim - 2)):
        of, by = rng.sample([*names, None], 2)
        if of is None:
            of, by = by, None
        contacts.append(contact(of, point(2), unit(), by=by, friction=rng.choice((0, F(1, 3), F(1, 2), 1)),
                                preload=rng.choice((0, 1, 2)), stiffness=number(1, 4)))
    others = {}
    if links and rng.random() < 0.6:
        others["tendons"] = [{"over": {l: str(rng.choice((1, F(1, 2), -1))) for l in links},
                              "stiffness": str(number(0, 2)), "tension": str(number(-2, 2))}]
    if links and rng.random() < 0.4:
        others["ratchets"] = [{"over": {links[0]: str(rng.choice((1, -1)))}, "stiffness": 2,
                               "preload": str(rng.choice((0, 1)))}]
    at = [number(-1, 1), *[0] * (dim - 1)]
    content = grasp(bodies, contacts, [force(rng.choice(names), point(2), at)], joints=joints, **others)
    if "tendons" in others:
        arms = others["tendons"][0]["over"]
        if not any(sum(F(a) * F(j["turns"].get(l, 0)) for l, a in arms.items()) for j in joints):
            return random_assembly(rng, dim)  # nothing moves the tendon
    return content


def mirrored_assembly(rng):
    """Two bodies, the one the other's mirror image, and one between them that is its own."""
    def number():
        return F(rng.randint(-3, 3), rng.choice((1, 2)))

    def mirror(name):
        return {"l": "r", "r": "l"}.get(name, name)

    contacts = []
    for _ in range(rng.randint(4, 7)):
        of, by = rng.choice((("l", None), ("l", None), ("c", None), ("c", "l"), ("c", "l"), ("l", "c")))
        x, y, n = number(), number(), rng.choice(((0, 1), (1, 0), (-1, 0), (3, 4), (-3, 4), (4, 3), (-4, 3)))
        laws = {"friction": rng.choice((0, F(1, 3), F(1, 2), 1)), "preload": rng.choice((0, 0, 1))}
        pair = [contact(of, (x, y), n, by=by, **laws), contact(mirror(of), (-x, y), (-n[0], n[1]), by=mirror(by), **laws)]
        contacts += pair if pair[0] != pair[1] else pair[:1]
    f, at = (number(), -abs(number())), (number(), number())
    return grasp("lcr", contacts, [force("l", f, at), force("r", (-f[0], f[1]), (-at[0], at[1])),
                                   weight("c", rng.choice((0, 1, 2)), (0, 1))])


def arch(stones, thickness, mu):
    """Half a circle of equal stones, each of the weight 1."""
    def on_circle(part):
        u = F(round(math.tan(math.pi / 2 * part) * 256), 256) if part < 1 else None
        return (F(-1), F(0)) if u is None else ((1 - u * u) / (1 + u * u), 2 * u / (1 + u * u))

    names, contacts = [f"b{k}" for k in range(stones)], []
    for k in range(stones + 1):
        x, y = on_circle(1 - F(k, stones))
        of, by, side = (names[k], names[k - 1] if k else None, 1) if k < stones else (names[-1], None, -1)
        contacts += [contact(of, (r * x, r * y), (side * y, -side * x), by=by, friction=mu, stiffness=100)
                     for r in (1 - thickness / 2, 1 + thickness / 2)]
    return grasp(names, contacts, [weight(name, 1, on_circle(1 - F(2 * k + 1, 2 * stones))) for k, name in enumerate(names)])


class Bodies(Space):
    engine = "bodies"

    def decide(self, content, *words):
        """Where it is unstable, Newton's method from some starts finds nothing."""
        answer = super().decide(content, *words)
        if answer["verdict"] == "unstable" and not words and '"min"' not in json.dumps(content):
            found = equilibria(content, 16, np.random.default_rng(1))
            self.assertEqual(found[0], 0, (found, json.dumps(content)))
        return answer


class ClosedForms(Bodies):
    def test_blocks_slide_or_tip(self):
        half = F(1, 2)
        for frictions, height in (((half, F(1, 5)), F(3, 2)), ((F(1, 5), half), F(3, 2)), ((2, 2), F(3, 2)),
                                  ((2, 2), F(2))):
            shape = ((1, F(3, 5)), (1, 1), frictions, (1, 2))
            least = stack(*shape, 0, height)[0]
            self.assert_threshold(lambda f, shape=shape, height=height: stack(*shape, f, height)[1], least)
        for blocks in (3, 4):
            shape = ([1] * blocks, [half] * blocks, [F(1, 3 + k) for k in range(blocks)], [1 + k for k in range(blocks)])
            least = stack(*shape, 0, half * blocks)[0]
            self.assert_threshold(lambda f, shape=shape, n=blocks: stack(*shape, f, half * n)[1], least)

    def test_a_book_is_pulled_from_a_row_that_is_squeezed(self):
        # Three books between two walls, pressed by 4 at every face; the middle one is pulled out where both its faces slip.
        def row(pull):
            contacts = []
            for k, (of, by) in enumerate((("a", None), ("b", "a"), ("c", "b"), ("c", None))):
                side = -1 if k == 3 else 1
                contacts += [contact(of, (k, y), (side, 0), by=by, friction=F(1, 4), preload=2) for y in (-1, 1)]
            return grasp("abc", contacts, [force("b", (0, pull), (F(3, 2), 0))])
        self.assert_threshold(row, 2 * F(1, 4) * 4)

    def test_rows_of_blocks_just_beyond_their_load(self):
        # Motions are far on the way, and planes around near ones would give regions thousands of corners, which checkers do not take.
        # Eight blocks take thousands of nodes where the splits are not chosen by what they leave.
        for name, most in (("row.json", 400), ("row_of_eight.json", 600)):
            with open(os.path.join(ROOT, "tests", "corpus", "bodies", name), encoding="utf-8") as file:
                answer = self.decide(json.load(file))
            self.assertEqual(answer["verdict"], "unstable", name)
            self.assertLess(answer["stats"]["nodes"], most, name)

    @unittest.skipIf(SANITIZED, "for its answers")
    def test_two_boxes_squeezed_in_space_beyond_what_sticks(self):
        # Four contacts slip, with irrational friction, so that the proof is by degree: walls of a simplex in twelve coordinates, of which
        # some take more than a hundred nodes.
        stiffnesses = iter((F(1, 2), 1, F(3, 2), 2, 1, F(3, 4), F(5, 4), F(1, 2), 2, F(3, 2), F(3, 4), 1))
        contacts = [contact(of, (x, F(3 * y, 4), F(3 * z, 4)), (side, 0, 0), by=by, friction=mu, stiffness=next(stiffnesses), preload=1)
                    for of, by, x, side, mu in (("a", None, 0, 1, F(1, 2)), ("b", "a", F(1, 2), 1, F(3, 5)), ("b", None, F(5, 4), -1, F(1, 2)))
                    for y in (-1, 1) for z in (-1, 1)]
        loads = [force("a", (0, 0, F(-17, 10)), (F(1, 4), F(1, 20), 0)), force("b", (0, 0, F(-17, 8)), (F(7, 8), F(1, 20), 0))]
        self.judges = quick_checker  # others take half a minute
        self.assertEqual(self.verdict(grasp("ab", contacts, loads)), "stable")

    def test_an_arch_has_a_least_friction_and_a_least_thickness(self):
        # By statics alone, which Z3 decides: below these no forces are in balance. For three stones that is where the friction of
        # the keystone lets it down as far as that at the foot holds: 3 t (t + tan 30) = 1 - t tan 30 with t = mu.
        def least(at, low, high):
            while high - low > high / 2000:
                middle = F(round((low + high) * 2**15), 2**16)
                stands = run(Z3, "-in", stdin=statics(at(middle)))[1].strip()
                self.assertIn(stands, ("sat", "unsat"))
                low, high = (low, middle) if stands == "sat" else (middle, high)
            return high
        for stones in (3, 5, 7):
            frictions = lambda mu, n=stones: arch(n, F(2, 5), mu)
            mu = least(frictions, F(1, 20), F(2))
            self.assertEqual([self.verdict(frictions(mu * part)) for part in (F(199, 200), F(201, 200))], ["unstable", "stable"])
            if stones == 3:
                self.assertAlmostEqual(float(mu), (-2 / 3**.5 + (4 / 3 + 3)**.5) / 3, delta=0.002)
                continue  # three are not thinner than their line of thrust
            shapes = lambda t, n=stones: arch(n, t, F(4, 5))
            thickness = least(shapes, F(1, 50), F(1))
            self.assertEqual([self.verdict(shapes(thickness * part)) for part in (F(199, 200), F(201, 200))], ["unstable", "stable"])

    def test_what_is_drawn_with_symmetry(self):
        # Equilibria lie side by side there, so that there is no proof by degree; a linear program in contact modes finds one. The arch stands
        # from the friction 0.396418 on, by statics; a wall whose bricks lie on halves of those below stands with any.
        def of(name, friction):
            with open(os.path.join(ROOT, "tests", "corpus", "bodies", name), encoding="utf-8") as file:
                content = json.load(file)
            return {**content, "defaults": {"friction": friction}}
        self.assertEqual([self.verdict(of("arch.json", mu)) for mu in ("0.396", "0.3965", "0.397", "0.4", "0.429", "0.5")],
                         ["unstable"] + ["stable"] * 5)
        self.assertEqual([self.verdict(of("wall.json", mu)) for mu in ("0", "1/100", "1/10", "3/4")], ["stable"] * 4)

    def test_springs_that_differ_by_twelve_powers_of_ten(self):
        with open(os.path.join(ROOT, "tests", "corpus", "bodies", "stiffness_apart.json"), encoding="utf-8") as file:
            self.assertEqual(self.verdict(json.load(file)), "stable")

    def test_a_ladder_on_a_cart(self):
        # On a smooth wall and a cart that a spring holds back; the cart is let go where the ladder's foot slips: with the
        # weight 1 in the middle of a ladder of width w and height 2 the foot needs the friction w/4.
        def ladder(w, stiffness=1):
            return grasp(["ladder", {"name": "cart", "slide": [1, 0]}],
                         [contact("ladder", (0, 0), (0, 1), by="cart", friction=F(1, 2)),
                          contact("ladder", (w, 2), (-1, 0), friction=0, stiffness=5)],
                         [weight("ladder", 1, (w / 2, 1))],
                         joints=[{"turns": {"cart": 1}, "stiffness": str(F(stiffness))}])
        self.assert_threshold(ladder, F(2))
        self.assertEqual(self.verdict(ladder(F(1), F(1, 1000))), "stable")  # however weak the spring
        loose = ladder(F(1))
        del loose["joints"][0]["stiffness"]
        self.assertEqual(self.verdict(loose), "unstable")

    def test_a_link_on_a_hinge_is_held_by_its_spring_or_a_stop(self):
        # A load of f at the arm 2 turns it by 2f/k and no spring fails; a stop at the arm 1 holds it from one side only.
        def arm(f, **joint):
            return grasp([{"name": "arm", "hinge": [0, 0]}], [contact("arm", (1, 0), (0, 1), friction=0)],
                         [force("arm", (0, f), (2, 0))], joints=[{"turns": {"arm": 1}, **joint}])
        for f in (-3, 3, F(1, 10**9)):
            self.assertEqual(self.verdict(arm(f, stiffness="1/7")), "stable")
        self.assertEqual(self.verdict(arm(-3)), "stable")
        self.assertEqual(self.verdict(arm(F(1, 10**9))), "unstable")
        self.assert_threshold(lambda f: arm(f, torque="-4"), F(2))

    def test_a_tendon_shares_its_pull_over_two_joints(self):
        # Arms 1 and r of the tendon hold torques in this ratio alone, as nothing else acts on the joints.
        def finger(outer, r=F(1, 2), extra=0):
            f = F(1)  # at the arm 2 of the first hinge and 1 of the second: torques 2f and f
            return grasp([{"name": "in", "hinge": [0, 0]}, {"name": "out", "on": "in", "hinge": [1, 0]}], [],
                         [force("out", (0, -f), (2, 0)), force("in", (0, extra), (1, 0))],
                         joints=[{"turns": {"in": 1}}, {"turns": {"out": 1}}],
                         tendons=[{"over": {"in": 1, "out": str(outer)}, "tension": "3/10", "stiffness": 2}])
        self.assertEqual(self.verdict(finger(F(1, 2))), "stable")
        self.assertEqual(self.verdict(finger(F(501, 1000))), "unstable")
        self.assertEqual(self.verdict(finger(F(1, 3), extra=-1)), "stable")  # 3 and 1

    def test_a_wrench_of_all_coordinates_is_as_the_loads(self):
        least, by_loads = stack((1, 1), (1, 1), (F(1, 2), F(1, 2)), (1, 1), F(1, 4), F(3, 2))
        by_wrench = {k: v for k, v in by_loads.items() if k != "loads"}
        by_wrench["wrench"] = text((0, -1, 0, F(1, 4), -1, -F(3, 8)))
        self.assertLess(F(1, 4), least)
        self.assertEqual(self.decide(by_wrench)["wrench"], self.decide(by_loads)["wrench"])
        by_wrench["wrench"][3] = {"min": "0", "max": "1/4"}
        self.assertEqual(self.verdict(by_wrench), "stable")
        cases = {**by_wrench, "wrench": text((0, -1, 0, 0, -1, 0)),
                 "cases": [{"name": "c", "wrench": text((0, 0, 0, F(1, 4), 0, -F(3, 8)))}]}
        self.assertEqual(self.verdict(cases, "--case", "c"), "stable")

    def test_a_fragile_box_has_two_examples_that_are_files(self):
        content = stack((1, 1), (1, 1), (F(1, 2), F(1, 2)), (1, 1), F(1, 2), F(3, 2))[1]
        file, folder = self.write("g.json", content), self.path("examples")
        answer = self.json("decide", file, "--uncertain", "friction=10%,wrench=0.001", "--examples", folder)
        self.assertEqual(answer["verdict"], "fragile")
        for verdict in ("stable", "unstable"):
            with open(os.path.join(folder, verdict + ".json"), encoding="utf-8") as example:
                self.assertEqual(self.verdict(json.load(example)), verdict)

    def test_margins(self):
        least, content = stack((1, 1), (1, 1), (F(1, 2), F(1, 3)), (1, 2), 0, F(3, 2))
        file, proof = self.write("g.json", content), self.path("m.json")
        words = ("--direction", "0,0,0,1,0,-3/2", "--wrench", "0,-1,0,0,-2,0")
        answer = self.json("margin", file, *words, "--certificate", proof, "--accuracy", "1/1000")
        low, high = answer["resisted"][0]
        self.assertEqual(F(low), 0)
        self.assertLess(F(high), least)
        self.assertGreater(F(high), least * F(99, 100))
        self.assertGreater(F(answer["refuted"][0][0]), least)
        self.accepted(file, proof, *words)

    def test_how_hard_must_the_tendon_pull(self):
        # As below: T >= 2 w/(2 mu) - w/2 with w = 1, mu = 1/3: 5/2; scaled from 5 by 1/2.
        links = [{"name": n, "hinge": [s * 2, -2]} for n, s in (("l", -1), ("r", 1))]
        content = grasp(["disc", *links],
                        [contact("disc", (-1, 0), (1, 0), by="l", friction=F(1, 3), stiffness=1000),
                         contact("disc", (1, 0), (-1, 0), by="r", friction=F(1, 3), stiffness=1000)],
                        [weight("disc", 1, (0, 0))], joints=[{"turns": {"l": -1, "r": 1}}],
                        tendons=[{"over": {"l": -1, "r": 1}, "tension": 5}])
        file, proof = self.write("g.json", content), self.path("m.json")
        words = ("--preload-direction", "scale")
        answer = self.json("margin", file, *words, "--certificate", proof, "--accuracy", "1/1000")
        low = F(answer["resisted"][0][0])
        self.assertGreaterEqual(low, F(1, 2))
        self.assertLess(low, F(51, 100))
        self.accepted(file, proof, *words)

    def test_a_picture_has_all_bodies_and_the_forces_between_them(self):
        file = self.write("g.json", stack((1, 1), (1, 1), (1, 1), (1, 1), F(1, 8), F(3, 2))[1])
        code, out, err = stickslip("plot", "grasp", file)
        self.assertEqual((code, err), (0, ""))
        self.assertIn('data-verdict="stable"', out)
        forces = [F(c["force"][1]) for c in self.json("decide", file)["contacts"]]
        self.assertEqual((sum(forces[:2]), sum(forces[2:])), (2, 1))
        for k, f in enumerate(self.json("decide", file)["contacts"]):
            self.assertIn(f'data-contact="{k}" data-value="{f["force"][0]},{f["force"][1]}"', out)

    def test_what_is_for_one_body_says_so(self):
        file = self.write("g.json", stack((1, 1), (1, 1), (1, 1), (1, 1), 0, F(3, 2))[1])
        for words in (("region",), ("export", "--smt2", "-o", "-"), ("compare", "--methods", "form-closure")):
            words = [words] if isinstance(words, str) else words
            code, out, err = stickslip(words[0], file, *words[1:])
            self.assertEqual((code, out), (2, ""), words)
            self.assertIn("several bodies", err)

    def test_a_ratchet_pushes_and_does_not_pull(self):
        def link(f):
            return grasp([{"name": "l", "slide": [0, 1]}], [], [force("l", (0, f), (0, 0))],
                         joints=[{"turns": {"l": 1}}], ratchets=[{"over": {"l": 1}, "stiffness": 3}])
        self.assertEqual([self.verdict(link(f)) for f in (-10**6, 0, F(1, 10**6))], ["stable", "stable", "unstable"])

    def test_a_two_finger_gripper_lifts_as_its_tendon_pulls(self):
        # Both links press the disc with N, 2 above their hinges, where the tendon of arm 1
        # pulls with T; the disc hangs by friction alone, mu N on either side.
        def gripper(tension, mu=F(1, 3), w=1):
            links = [{"name": n, "hinge": [s * 2, -2]} for n, s in (("l", -1), ("r", 1))]
            return grasp(["disc", *links],
                         [contact("disc", (-1, 0), (1, 0), by="l", friction=mu, stiffness=1000),
                          contact("disc", (1, 0), (-1, 0), by="r", friction=mu, stiffness=1000)],
                         [weight("disc", w, (0, 0))],
                         joints=[{"turns": {"l": -1, "r": 1}}],
                         tendons=[{"over": {"l": -1, "r": 1}, "tension": str(F(tension))}])
        # Friction helps the tendon turn the links, by the arm 1: T = 2N - w/2.
        least = 2 * F(3, 2) - F(1, 2)
        for t in (least * F(99, 100), least * F(101, 100)):
            expected = "stable" if t > least else "unstable"
            self.assertEqual(self.verdict(gripper(t)), expected, t)

    def test_a_hand_of_three_fingers_holds_a_ball_in_space(self):
        # Each finger has two hinges below the point where it presses the ball's equator, so that friction does not turn it,
        # and motors that press with P. The P balance, and friction holds a weight of mu (P + P + P).
        fingers = ((1, 0, F(12, 5)), (F(-3, 5), F(4, 5), 2), (F(-3, 5), F(-4, 5), 2))

        def hand(w):
            bodies, joints, contacts = ["ball"], [], []
            for k, (x, y, preload) in enumerate(fingers):
                on = None
                for name, depth in ((f"low{k}", 4), (f"up{k}", 2)):
                    bodies.append({"name": name, "hinge": {"at": text((x, y, -depth)), "axis": text((-y, x, 0))},
                                   **({"on": on} if on else {})})
                    joints.append({"turns": {name: -1}, "stiffness": 10, "torque": str(preload * depth)})
                    on = name
                contacts.append(contact("ball", (x, y, 0), (-x, -y, 0), by=on, friction=F(1, 2), preload=preload))
            return grasp(bodies, contacts, [weight("ball", w, (0, 0, 0))], joints=joints)
        self.assert_threshold(hand, F(16, 5))


class ReversedContacts(Bodies):
    """What is warned of, and what is as near to it as can be and right."""

    def warnings(self, content, *words):
        out = stickslip("decide", self.write("g.json", content), "--json", *words)[1]  # decided or not
        return [w["text"] for w in json.loads(out)["warnings"]]

    def said(self, content, *words):
        """The contacts that are said to be reversed."""
        for text in self.warnings(content, *words):
            return [int(i) for i in re.findall(r"contacts\[(\d+)\]", text)]
        return []

    def test_examples_are_right(self):
        for file in sorted(glob.glob(os.path.join(ROOT, "examples", "grasps", "bodies-*.json"))):
            answer = self.json("decide", file)
            for one in answer.get("cases", [answer]):
                self.assertEqual(one["warnings"], [], file)

    def test_of_and_by_exchanged(self):
        content = stack((1, F(1, 2)), (1, 1), (F(1, 2), F(1, 2)), (1, 1), 0, 2)[1]
        self.assertEqual(self.warnings(content), [])
        for k in (2, 3):
            exchanged = json.loads(json.dumps(content))
            exchanged["contacts"][k].update({"of": "b0", "by": "b1"})
            self.assertEqual(self.warnings(exchanged), [
                f'contacts[{k}] would pull "b0" and "b1" apart: its normal points away from "b0", which it presses, '
                'to "b1"; swap "of" and "by", or turn the normal round'])
        for words in ((), ("--uncertain", "position=1/100,friction=10%", "--node-limit", "1")):
            self.assertEqual(self.said(exchanged, *words), [3])
        file = self.write("g.json", exchanged)
        self.assertIn('\nWarning: contacts[3] would pull "b0"', stickslip("decide", file)[1])
        self.assertNotIn("warnings", self.json("decide", file, "--no-warnings"))
        margin = self.json("margin", file, "--direction", "0,-1,0,0,-1,0", "--accuracy", "1/10")
        self.assertEqual([w["trap"] for w in margin["warnings"]], ["reversed-contact"])
        for contact_of_both in exchanged["contacts"][2:]:
            contact_of_both["normal"] = ["0", "-1"]
        self.assertEqual(self.said(exchanged), [2])  # contact 3 is exchanged and turned round

    def test_a_box_on_the_ground_and_one_that_hangs(self):
        # Of a hook, too, all is below the contacts, and they push it up.
        def box(height, *signs):
            return grasp(["box"], [contact("box", (x, 0), (0, s), friction=1) for x, s in zip((-1, 1), signs)],
                         [weight("box", 1, (0, height))])
        self.assertEqual(self.warnings(box(1, -1, -1)), [
            'contacts[0] would pull "box" and the ground apart: its normal points away from "box", which it presses, '
            "to the ground; turn the normal round; the same of contacts[1]"])
        self.assertEqual([self.said(box(*how)) for how in ((1, 1, -1), (1, 1, 1), (-1, 1, 1), (0, -1, -1))],
                         [[1], [], [], []])

    def test_a_ring_that_jaws_open_in(self):
        # On all jaws it is on the other side, but on the one below alone the load pulls it where this one pushes.
        def ring(*signs):
            return grasp(["ring"], [contact("ring", p, [s * x for x in p], friction=1, preload=1)
                                    for s, p in zip(signs, ((0, -1), (F(4, 5), F(3, 5)), (-F(4, 5), F(3, 5))))],
                         [weight("ring", 1, (0, 0))])
        self.assertEqual(self.said(ring(1, 1, 1)), [])
        self.assertEqual(self.said(ring(1, -1, -1)), [0])

    def test_an_outline_tells_where_points_do_not(self):
        # A channel that stands on a peg inside it, or has a jaw in a corner; hung up, and pressed by the peg from above.
        channel = [[0, 0], [4, 0], [4, 3], [3, 3], [3, 1], [1, 1], [1, 3], [0, 3]]

        def held(position, normal, outline=True):
            return grasp([{"name": "c", **({"outline": text(channel)} if outline else {})}, "peg"],
                         [contact("c", position, normal, by="peg", friction=1), contact("peg", (2, 9), (0, 1), friction=1),
                          contact("c", (0, 3), (1, 0), friction=1), contact("c", (4, 0), (-1, 0), friction=1)],
                         [weight("c", 1, (2, 0))])
        for position, normal in (((2, 1), (0, -1)), ((2, 0), (0, 1)), ((3, 2), (1, 0)),  # on edges
                                 ((0, 0), (1, 1)), ((0, 0), (0, 1)), ((4, 0), (-3, 1)),  # at corners
                                 ((1, 1), (-1, -2)), ((3, 1), (1, 0))):  # inside, and along its edges
            back = tuple(-x for x in normal)
            self.assertEqual((self.said(held(position, normal)), self.said(held(position, back))), ([], [0]), position)
        for position, normal in (((2, F(1, 2)), (0, -1)), ((3, 1), (1, 1)), ((2, 2), (0, 1))):  # off it, or askew
            self.assertEqual(self.said(held(position, normal)), [])
        self.assertEqual(self.said(held((2, 1), (0, 1), outline=False)), [])  # its weight is below, its corner above
        hole = [[[0, 0], [4, 0], [4, 4], [0, 4]], [[1, 1], [3, 1], [3, 3], [1, 3]]]
        for s in (1, -1):
            ring = grasp([{"name": "ring", "outline": text(hole)}], [contact("ring", (2, 3), (0, s), friction=1)],
                         [weight("ring", 1, (2, 0))])
            self.assertEqual(self.said(ring), [] if s == 1 else [0])

    def test_rounded_numbers_of_a_face_that_is_inclined(self):
        def wedge(sign, off):
            # Along (4, 3); the normal is (-3, 4).
            place = (4 - 3 * off, 3 + 4 * off)
            return grasp(["a", "b"], [contact("b", (0, 0), (-3 * sign, 4 * sign), by="a", friction=1),
                                      contact("b", place, (-3 * sign, 4 * sign), by="a", friction=1)],
                         [weight("a", 1, (2, 0)), weight("b", 1, (2, 3))])
        for off in (0, F(1, 10**9), -F(1, 10**9)):
            self.assertEqual((self.said(wedge(1, off)), self.said(wedge(-1, off))), ([], [0, 1]))
        self.assertEqual(self.said(wedge(-1, F(1, 999))), [])  # of either contact the other is on both sides
        self.assertEqual(self.said(wedge(-1, F(1, 1001))), [0, 1])

    def test_in_space_by_meshes_and_by_hinges(self):
        def boxes(sign, mesh):
            bodies = []
            for name, z in (("low", 0), ("up", 1)):
                corners = [[x, y, z + h] for h in (0, 1) for x in (0, 1) for y in (0, 1)]
                faces = [[0, 1, 3, 2], [4, 5, 7, 6], [0, 1, 5, 4], [2, 3, 7, 6], [0, 2, 6, 4], [1, 3, 7, 5]]
                bodies.append({"name": name, **({"mesh": {"vertices": corners, "faces": faces}} if mesh else {})})
            return grasp(bodies, [contact("up", (x, y, 1), (0, 0, sign), by="low", friction=1)
                                  for x, y in ((0, 0), (1, 0), (0, 1), (1, 1))], [])
        self.assertEqual([self.said(boxes(s, True), "--node-limit", "1") for s in (1, -1)], [[], [0, 1, 2, 3]])
        self.assertEqual(self.said(boxes(-1, False), "--node-limit", "1"), [])  # nothing tells

        def finger(sign, hinge):
            return grasp(["ball", {"name": "f", "hinge": {"at": text(hinge), "axis": [0, 1, 0]}}],
                         [contact("ball", (-1, 0, 0), (sign, 0, 0), by="f", friction=1)],
                         [weight("ball", 1, (0, 0, 0))], joints=[{"turns": {"f": 1}}])
        self.assertEqual([self.said(finger(s, (-2, 0, -3))) for s in (1, -1)], [[], [0]])
        self.assertEqual(self.said(finger(-1, (0, 0, -3))), [])  # it may open in a ring


if __name__ == "__main__":
    unittest.main()
