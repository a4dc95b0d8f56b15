# SPDX-License-Identifier: GPL-3.0-or-later
"""The largest ball of loads that a grasp resists: closed forms between the two radii, loads of proved balls one by one, every proof
through the checkers."""

import json
import math
import os
import random
import tempfile
import unittest
from fractions import Fraction as F

from test_cli import BAD_INPUT, CORPUS, DONE, FIG1, Case, checkers, read, run, stickslip

HAND = os.path.join(CORPUS, "..", "bodies", "hand.json")


def text(values):
    return [str(F(x)) for x in values]


def grasp(contacts, wrench, **others):
    return json.dumps({"format": "stickslip-grasp/2", "contacts": contacts, "wrench": text(wrench), **others})


def contact(position, normal, **others):
    return {"position": text(position), "normal": text(normal), **{k: str(F(v)) for k, v in others.items()}}


def pinch(mu, preload):
    return grasp([contact((s, 0), (-s, 0), friction=mu, preload=preload) for s in (-1, 1)], (0, 0, 0))


def block(mu, weight, half):
    """On the ground, with two feet."""
    return grasp([contact((s * half, 0), (0, 1), friction=mu) for s in (-1, 1)], (0, -F(weight), 0))


def stool(weight):
    """Three feet that never slip, at a distance of 5 from the middle."""
    return grasp([contact(p, (0, 0, 1), friction=50) for p in ((5, 0, 0), (-3, 4, 0), (-3, -4, 0))], (0, 0, -F(weight), 0, 0, 0))


def sled(mu, weight):
    """Three feet that slip."""
    return grasp([contact(p, (0, 0, 1), friction=mu) for p in ((5, 0, 0), (-3, 4, 0), (-3, -4, 0))], (0, 0, -F(weight), 0, 0, 0))


def pocket(mu):
    """A square without load that walls meet from all sides, and turned both ways."""
    return grasp([contact(p, n, friction=mu) for p, n in (
        ((1, F(1, 2)), (-1, 0)), ((-1, F(1, 2)), (1, 0)), ((1, -F(1, 2)), (-1, 0)), ((-1, -F(1, 2)), (1, 0)), ((0, 1), (0, -1)), ((0, -1), (0, 1)))],
        (0, 0, 0))


def hand():
    """A disc between two fingers of two links, around which a tendon pulls."""
    links = [("l1", -2, "-2", None), ("l2", F(-6, 5), "0", "l1"), ("r1", 2, "-2", None), ("r2", F(6, 5), "0", "r1")]
    touches = [("l2", -1, F(1, 2), (1, 0), 20), ("r2", 1, F(1, 2), (-1, 0), 10), ("l1", -1, F(-1, 2), (2, 1), 14), ("r1", 1, F(-1, 2), (-2, 1), 15)]
    return json.dumps({
        "format": "stickslip-grasp/3",
        "bodies": [{"name": "disc"}, *({"name": name, "hinge": [str(x), y], **({"on": on} if on else {})} for name, x, y, on in links)],
        "contacts": [{"of": "disc", "by": link, **contact((x, y), normal, friction=F(1, 2), stiffness=k)} for link, x, y, normal, k in touches],
        "joints": [{"turns": {name: 1 if name[0] == "r" else -1}, "stiffness": stiffness} for (name, _, _, _), stiffness
                   in zip(links, ("4/25", "19/100", "2/25", "7/25"))],
        "tendons": [{"over": {"l1": "-9/10", "l2": "-3/5", "r1": "23/20", "r2": "1/2"}, "stiffness": 2, "tension": 2}],
        "loads": [{"body": "disc", "force": ["3/100", "2/25"], "at": ["1/10", 0]}]})


class Quality(Case):
    def quality(self, file, *words):
        """The answer, whose proofs the checkers accept."""
        folder = tempfile.mkdtemp(dir=self.folder)
        answer = self.json("quality", file, *words, "--certificates", folder)
        names = {name.split(".")[0] for name in os.listdir(folder)}
        ball = ["ball", answer["proved"], "length=" + answer["ball"]["length"]]
        if "about" in answer["ball"]:
            ball.append("about=" + ":".join(answer["ball"]["about"]))
        if "body" in answer["ball"]:
            ball.append("body=" + answer["ball"]["body"])
        if answer["proved"] != "0":
            self.judge(folder, "proved", "stable", "--uncertain", "wrench=" + ":".join(ball))
        if "not_resisted" in answer:
            self.judge(folder, "refuted", "unstable")
            file = json.loads(read(os.path.join(folder, "refuted.json")))
            self.assertEqual([F(str(x)) for x in file["wrench"]], [F(x) for x in answer["not_resisted"]])
        self.assertEqual("refuted" in names, answer["verdict"] == "unstable" or "not_resisted" in answer)
        return answer

    def judge(self, folder, name, verdict, *options):
        file, proof = (os.path.join(folder, name + end) for end in (".json", ".certificate.json"))
        self.accepted(file, proof, *options, verdict=rf"{verdict}\b")
        for checker in checkers(proof) if options else ():  # a larger ball is another question
            code, out, err = run(*checker, file, proof, *(word.replace("ball:", "ball:1") for word in options))
            self.assertNotEqual(code, DONE, out + err)

    def assert_quality(self, file, square, *words, most=F(102, 100)):
        """The square of the quality is between those of the two radii, which are near each other."""
        answer = self.quality(self.write("g.json", file), *words)
        proved, refuted = F(answer["proved"]), F(answer["refuted"])
        self.assertLessEqual(proved ** 2, square)
        self.assertGreaterEqual(refuted ** 2, square)
        self.assertLess(refuted, most * proved)
        self.assert_lies_on(answer, refuted)

    def assert_lies_on(self, answer, radius):
        """The load that is not resisted is in the ball of the larger radius."""
        z = [F(a) - F(b) for a, b in zip(answer["not_resisted"], answer["wrench"])]
        length, about = F(answer["ball"]["length"]), [F(x) for x in answer["ball"].get("about", ["0"] * (2 if len(z) == 3 else 3))]
        if len(z) == 3:
            force, torque = z[:2], [z[2] - (about[0] * z[1] - about[1] * z[0])]
        else:
            force = z[:3]
            torque = [z[3 + k] - (about[(k + 1) % 3] * z[(k + 2) % 3] - about[(k + 2) % 3] * z[(k + 1) % 3]) for k in range(3)]
        self.assertLessEqual(sum(x * x for x in force) + sum(x * x for x in torque) / length ** 2, radius ** 2)

    def test_a_pinch(self):
        # A finger slips at (force y +- torque) / 2 = mu (P - force x / 2).
        for mu, preload, length in ((F(1, 2), 1, 1), (F(3, 10), 7, F(5, 2)), (1, F(1, 9), F(1, 4))):
            self.assert_quality(pinch(mu, preload), (2 * mu * preload) ** 2 / (1 + length ** 2 + mu ** 2), "--length", length)

    def test_a_pinch_seen_from_elsewhere(self):
        # About the point (0, c) the torque of a force along x at the origin is -c force x.
        mu, preload, c = F(1, 2), 3, F(2, 3)
        self.assert_quality(pinch(mu, preload), (2 * mu * preload) ** 2 / ((mu + c) ** 2 + 1 + 1), "--about", f"0,{c}")

    def test_a_block_slides_or_tips(self):
        # |force x| = mu (W - force y); or the weight on one foot is gone.
        for mu, weight, half, length in ((F(1, 3), 2, 1, F(1, 2)), (F(9, 10), 5, 1, 3), (F(1, 5), F(1, 7), 4, 1)):
            slides = (mu * weight) ** 2 / (1 + mu ** 2)
            tips = weight ** 2 / (1 + F(length) ** 2 / half ** 2)
            self.assert_quality(block(mu, weight, half), min(slides, tips), "--length", length)

    def test_a_stool_tips(self):
        # Its feet carry a_i >= 0, linear in vertical force and torques: the nearest load lifts one of them.
        for weight, length in ((6, 1), (1, 4)):
            feet = ((5, 0), (-3, 4), (-3, -4))
            least = None
            for k in range(3):
                (x1, y1), (x2, y2) = feet[k - 1], feet[k - 2]
                # The moment about the line through the other two, at the foot k and at the origin.
                a, b = y2 - y1, x1 - x2
                at = a * (feet[k][0] - x1) + b * (feet[k][1] - y1)
                here = a * -x1 + b * -y1
                # a_k at = -(fz here + torque (x, y) . (b, -a)), with fz = -weight + z.
                carried = F(weight * here) ** 2 / (here ** 2 + F(length) ** 2 * (a * a + b * b))
                self.assertGreater(F(weight * here, at), 0)
                least = carried if least is None else min(least, carried)
            self.assert_quality(stool(weight), least, "--length", length, most=F(115, 100))

    def test_a_sled_slides_any_way(self):
        # |horizontal force| = mu (W - force z): all around, the nearest load is there; torques, over so small a length, are farther.
        for mu, weight in ((F(1, 5), 6), (F(2, 5), 1)):
            self.assert_quality(sled(mu, weight), (mu * weight) ** 2 / (1 + mu ** 2), "--length", F(1, 4), most=F(115, 100))

    def test_a_hand_holds_a_ball_of_loads(self):
        # A proof whose list 2 has walls where forces balance only beside what A does at other motions: these are cut apart.
        self.holds(self.write("hand.json", hand()), "1/20:length=1:body=disc")

    def test_a_hand_holds_loads_that_move_it_far(self):
        # No simplex encloses the equilibria: fingers of joints that yield slip along the disc. A load at 0.0932 is too much.
        self.holds(HAND, "3/50:length=1:body=disc")
        lost = "--wrench=0.0109456,0.153535,0.0618938,0,0,0,0"
        self.assertEqual(self.json("decide", HAND, lost)["verdict"], "unstable")

    def test_fingers_hold_a_ball_of_loads_by_friction_that_sticks(self):
        # Beside that equilibrium there is one that slips more; the two meet at loads that are not much farther.
        file = os.path.join(CORPUS, "..", "tolerances", "four_fingers.json")
        self.holds(file, "0.049:length=5")
        lost = "--wrench=0.0145079,0.170717,-0.267103"  # at 0.0508
        self.assertEqual(self.json("decide", file, lost)["verdict"], "unstable")

    def holds(self, file, ball):
        ball, proof = ("--uncertain", f"wrench=ball:{ball}"), self.path("ball.certificate.json")
        self.assertEqual(self.json("decide", file, *ball, "--certificate", proof)["verdict"], "stable")
        self.accepted(file, proof, *ball)

    def test_pads_in_space_have_both_radii(self):
        # Newton's method loses the equilibrium at loads that are held by others, and the border is between all axes.
        pads = [((F(99, 100), F(1, 2), F(2, 5)), (-1, F(1, 20), F(-1, 20))), ((F(-19, 20), F(-3, 5), F(1, 2)), (1, 0, F(1, 20))),
                ((F(21, 20), F(-1, 2), F(-7, 10)), (-1, F(-1, 20), 0)), ((-1, F(3, 5), F(-3, 5)), (1, F(1, 20), F(1, 20)))]
        answer = self.quality(self.write("g.json", grasp([contact(p, n, friction=F(3, 5), preload=1) for p, n in pads], [0] * 6)),
                              "--length", 1, "--accuracy", "20%")
        self.assertLess(F(answer["refuted"]), F(3, 2) * F(answer["proved"]))

    def test_pads_that_press_unequally_are_held_where_they_come_to_rest(self):
        # They lie loose far away as well, where no ball of loads is held. Where they rest most contacts slip a little, which
        # the other loads turn round.
        pads = [((F(-19, 20), F(-1, 5), F(1, 20)), (20, 1, -1), F(7, 10), F(11, 20), F(4, 5)),
                ((F(11, 10), F(-7, 10), F(-1, 5)), (-20, 2, -1), F(7, 10), F(29, 20), F(19, 20)),
                ((F(-19, 20), F(-4, 5), F(3, 5)), (20, 1, 1), F(7, 10), F(6, 5), F(11, 10)),
                ((1, F(3, 5), F(4, 5)), (-20, 1, -1), F(7, 10), F(39, 20), F(23, 20))]
        file = self.write("g.json", grasp([contact(p, n, friction=mu, stiffness=k, preload=preload)
                                           for p, n, mu, k, preload in pads], [0] * 6))
        self.assertLess(max(abs(F(x)) for x in self.json("decide", file)["near"]), F(1, 20))
        answer = self.quality(file, "--length", 1, "--at-most", "1/2")
        self.assertEqual(F(answer["proved"]), F(1, 2))

    def test_loads_of_a_proved_ball_are_resisted(self):
        rng = random.Random(7)
        for _ in range(3):
            file = self.write("g.json", grasp(
                [contact((s, F(rng.randint(-5, 5), 10)), (-s, F(rng.randint(-2, 2), 20)), friction=F(rng.randint(3, 8), 10),
                         stiffness=F(rng.randint(5, 20), 10)) for s in (-1, 1, -1, 1)],
                (0, 0, 0), units={"length": "m", "force": "N"}))
            answer = self.json("quality", file, "--preload", "1", "--length", "2", "--accuracy", "10%")
            if answer["verdict"] != "stable" or answer["proved"] == "0":
                continue
            radius = F(answer["proved"])
            for _ in range(40):
                z = [rng.gauss(0, 1) for _ in range(3)]
                size = math.sqrt(sum(x * x for x in z)) * 1.000001
                load = [radius * F(x / size) * (2 if k == 2 else 1) for k, x in enumerate(z)]
                self.assertLess(load[0] ** 2 + load[1] ** 2 + load[2] ** 2 / 4, radius ** 2)
                verdict = self.json("decide", file, "--preload", "1", "--wrench=" + ",".join(map(str, load)), "--no-warnings")["verdict"]
                self.assertEqual(verdict, "stable")

    def test_what_has_no_measure(self):
        # One foot without load: no load that pulls is resisted, however small.
        one = self.quality(self.write("g.json", grasp([contact((0, 0), (0, 1), friction=1)], (0, 0, 0))))
        self.assertEqual((one["verdict"], one["proved"], one["scales"]), ("stable", "0", True))
        # Four walls that meet a square from all sides, and turns both ways: all loads are resisted.
        for mu in (F(1, 10), F(1, 2)):  # the first takes long
            answer = self.quality(self.write("g.json", pocket(mu)))
            self.assertEqual((answer["verdict"], answer["refuted"], answer["scales"]), ("stable", None, True))
        self.assertIn("without end: every load is resisted", stickslip("quality", self.path("g.json"))[1])
        # With a load that it does not hold there is no ball.
        falls = self.quality(FIG1, "--wrench", "0,11/10,0")
        self.assertEqual((falls["verdict"], falls["proved"]), ("unstable", "0"))
        self.assertIn("has no quality", stickslip("quality", FIG1, "--wrench", "0,11/10,0")[1])

    def test_at_most(self):
        file = self.write("g.json", pinch(F(1, 2), 1))
        answer = self.quality(file, "--at-most", "1/4")
        self.assertEqual((answer["proved"], answer["refuted"], answer["limit"]), ("1/4", None, "1/4"))
        self.assertIn("none farther than 1/4 sought", stickslip("quality", file, "--at-most", "1/4")[1])

    def test_several_bodies(self):
        # A block on a block: the upper one slides as a single one does, in friction with the lower.
        file = json.dumps({
            "format": "stickslip-grasp/3", "bodies": [{"name": "lower"}, {"name": "upper"}],
            "contacts": [{**contact((s * 4, 0), (0, 1), friction=9), "of": "lower"} for s in (-1, 1)] +
                        [{**contact((s, 1), (0, 1), friction=F(1, 3)), "of": "upper", "by": "lower"} for s in (-1, 1)],
            "loads": [{"body": "lower", "weight": 100, "at": [0, 0]}, {"body": "upper", "weight": 2, "at": [0, 1]}]})
        slides = F(2, 3) ** 2 / (1 + F(1, 9))
        answer = self.quality(self.write("g.json", file), "--body", "upper", "--about", "0,1", "--length", "1/2")
        self.assertLessEqual(F(answer["proved"]) ** 2, slides)
        self.assertGreaterEqual(F(answer["refuted"]) ** 2, slides)
        self.assertLess(F(answer["refuted"]), F(102, 100) * F(answer["proved"]))

    def test_errors_say_what_would_be_right(self):
        file = self.write("g.json", pinch(F(1, 2), 1))
        for words, said in ((("--length", "0"), "--length: the value is 0; torques are divided by it"),
                            (("--about", "1,2,3"), "--about: there are 3 coordinates; give 2"), (("--about", "0"), "--about: there are 1"),
                            (("--body", "cup"), "--body: the grasp has one body; leave the option out"),
                            (("--at-most", "0"), "--at-most"), (("--accuracy", "2"), "--accuracy")):
            code, _, err = stickslip("quality", file, *words)
            self.assertEqual(code, BAD_INPUT)
            self.assertIn(said, err)
        wide = self.write("w.json", pinch(F(1, 2), 1).replace('"wrench": ["0"', '"wrench": [{"min": 0, "max": 1}'))
        code, _, err = stickslip("quality", wide)
        self.assertEqual(code, BAD_INPUT)
        self.assertIn("a quality is that of one grasp", err)


if __name__ == "__main__":
    unittest.main()
