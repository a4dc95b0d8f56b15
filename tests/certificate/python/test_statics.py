# SPDX-License-Identifier: MIT
"""Statics (FORMAT.md, section 16): check.py against the literal twin of naive_statics.py, on proofs of random small worlds and on these
with one number changed; and the work of large ones. Where STICKSLIP_CHECK names it, stickslip-check has to say the same, and so has
stickslip-proved where STICKSLIP_PROVED does."""

import collections
import copy
import json
import random
import tempfile
import unittest
from fractions import Fraction

import naive_statics as naive
from support import STICKSLIP_CHECK, STICKSLIP_PROVED, Case, check, in_batch, question_of

import batch  # noqa: E402


def some(rng, *more):
    return rng.choice([-2, -1, -1, 0, 0, 1, 1, 2, Fraction(1, 2), Fraction(-3, 2), *more])


def texts(values):
    return [str(value) if isinstance(value, Fraction) and value.denominator > 1 else int(value) for value in values]


def random_bodies(rng, space):
    """Of a file of version 3."""
    bodies, joints, links, length = [], [], [], 3 if space else 2
    for k in range(rng.randint(1, 4)):
        body = {"name": f"b{k}"}
        if rng.random() < 0.6:
            kind, way = rng.choice(["hinge", "slide"]), [0] * length
            while not any(way):
                way = [rng.randint(-1, 2) for _ in range(length)]
            at = [rng.randint(-1, 1) for _ in range(length)]
            body[kind] = way if kind == "slide" else {"at": at, "axis": way} if space else at
            if bodies and rng.random() < 0.7:
                body["on"] = rng.choice(bodies)["name"]
            links.append(body["name"])
        bodies.append(body)
    for link in links:
        joint = {"turns": {link: some(rng, 1) or 1}}
        if rng.random() < 0.3:
            joint["turns"][rng.choice(links)] = 2
        if rng.random() < 0.6:
            joint.update({"stiffness": rng.choice([0, 1])} if rng.random() < 0.7 else {}, **({"torque": some(rng)} if rng.random() < 0.6 else {}))
        joint["turns"] = dict(zip(joint["turns"], texts(joint["turns"].values())))
        if "torque" in joint:
            joint["torque"] = texts([joint["torque"]])[0]
        joints.append(joint)

    def over():
        return {rng.choice(links): rng.choice([1, 2, -1])}

    file = {"bodies": bodies, "joints": joints}
    if links:
        file["ratchets"] = [{"over": over(), "stiffness": 1} for _ in range(rng.randint(0, 1))]
        file["tendons"] = [{"over": over(), "tension": rng.choice([0, 1, -2]), **({"stiffness": 1} if rng.random() < 0.3 else {})}
                           for _ in range(rng.randint(0, 1))]
    return file


def random_world(rng):
    """A grasp file, its wrench 0."""
    space, several = rng.random() < 0.5, rng.random() < 0.7
    length = 3 if space else 2
    file = {"format": "stickslip-grasp/3" if several else "stickslip-grasp/2", **(random_bodies(rng, space) if several else {})}
    names, contacts = [body["name"] for body in file.get("bodies", [])], []
    for _ in range(rng.randint(1, 4)):
        normal = [0] * length
        while not any(normal):
            normal = [rng.randint(-1, 2) for _ in range(length)]
        contact = {"position": [rng.choice([-2, -1, 0, 1, 2, "1/2", "-2/3"]) for _ in range(length)], "normal": normal, "friction": rng.choice([0, "1/2", 1, "2/3"]),
                   "preload": rng.choice([0, 1])}
        if several:
            contact["of"] = rng.choice(names)
            if rng.random() < 0.5:
                contact["by"] = rng.choice([name for name in [*names, "ground"] if name != contact["of"]])
            if space and rng.random() < 0.4:
                contact["torsion"] = rng.choice([0, "1/2", 2])
        contacts.append(contact)
    file["contacts"] = contacts
    D = naive.World({**file, "wrench": []}).D
    return {**file, "wrench": [0] * D}


def random_forces(rng, world, phi):
    """Of H(φ), as certificates have them; some on the border where that is rational."""
    forces = []
    for i, element in enumerate(world.elements):
        if rng.random() < 0.2 or (element.kind == "spring" and element.stiffness == 0):
            continue
        a = abs(some(rng)) if element.kind != "spring" else some(rng)
        f = [Fraction(0)] * (4 if element.gamma else 3 if world.space else 1)
        most = phi * element.friction * a
        if element.kind == "contact":
            if not world.space:
                f = [most * rng.choice([-1, 1, 0, Fraction(1, 2)])]
            else:
                # Across n, and of a length that is certainly not too large; of the turn alone a border is rational.
                way = naive.cross(element.n, [rng.randint(-1, 1) for _ in range(3)])
                size = sum(map(abs, way))
                if element.gamma and rng.random() < 0.4:
                    f[3] = most * naive.number(world_torsion(element)) * rng.choice([1, -1])
                elif size:
                    f[:3] = [most * c / size * rng.choice([1, Fraction(1, 2)]) for c in way] if element.square >= 1 else f[:3]
        forces.append([i, a, f])
    return forces


def world_torsion(element):
    """e, as γ = e²/L²; f₄²/γ = φ²ρ²a² at f₄ = φ μ a e."""
    e = element.gamma * element.square
    return Fraction(check.math.isqrt(e.numerator), check.math.isqrt(e.denominator))


def wrench_of(world, forces, h):
    """What balances the forces with h times the springs'."""
    pulls = [[i, h * element.pull, []] for i, element in enumerate(world.elements) if element.kind == "spring" and element.stiffness == 0]
    total = [Fraction(0)] * world.D
    for i, a, f in [*forces, *pulls]:
        element = world.elements[i]
        total = [c - a * n for c, n in zip(total, element.N)]
        if element.S:
            total = [c - s for c, s in zip(total, naive.transposed_times(element.S, f))]
    return total


def as_json(world, forces):
    return [[i, *texts([a]), texts(f) if world.space else texts(f)[0]] for i, a, f in forces]


def forces_added(world, *weighted):
    """The sum of forces with weights >= 0."""
    total = {}
    for weight, forces in weighted:
        for i, a, f in forces:
            before = total.get(i, [0, [0] * len(f)])
            total[i] = [before[0] + weight * a, [x + weight * y for x, y in zip(before[1], f)]]
    return [[i, *total[i]] for i in sorted(total)]


def let_move(rng, file, phi, twists):
    """The file, changed so that no force opposes the twists."""
    file = copy.deepcopy(file)
    for _ in range(4):
        world = naive.World(file)
        opposed = {i for i, element in enumerate(world.elements) for y in twists if naive.opposes(element, phi, y)}
        contacts, ratchets = len(file["contacts"]), len(file.get("ratchets", []))
        springs = [joint for joint in file.get("joints", []) if "stiffness" in joint or "torque" in joint] + file.get("tendons", [])
        for i in opposed:
            if i < contacts:
                contact = file["contacts"][i]
                if rng.random() < 0.5:
                    contact["normal"] = [-c for c in contact["normal"]]
                else:
                    contact["friction"] = 0
            elif i < contacts + ratchets:
                over = file["ratchets"][i - contacts]["over"]
                file["ratchets"][i - contacts]["over"] = {link: -r for link, r in over.items()}
            else:
                springs[i - contacts - ratchets]["stiffness"] = 0
    return file


def random_proof(rng):
    """A world, a certificate that is accepted, mostly, and the options."""
    phi = rng.choice([Fraction(0), Fraction(1), Fraction(1), Fraction(1, 2), Fraction(2)])
    file = random_world(rng)
    world = naive.World(file)
    kind = rng.choice(["may stand", "must move", "margin", "margin", "region"])
    question = {"normal_law": "unilateral"}
    growths = {"margin": 1, "region": 2}.get(kind, 0)
    moves = [[Fraction(some(rng)) for _ in range(world.D)] for _ in range(rng.randint(0, 2) if growths else 1)]
    if kind != "may stand":
        file = let_move(rng, file, phi, moves)
        world = naive.World(file)
    if kind == "must move":
        w = [Fraction(some(rng)) for _ in range(world.D)]
        works = naive.dot(moves[0], w) - naive.dot(moves[0], wrench_of(world, [], 1))
        if works <= 0 and rng.random() < 0.9 and any(moves[0]):
            square = naive.dot(moves[0], moves[0])
            w = [c + (Fraction(1, 3) - works) / square * y for c, y in zip(w, moves[0])]
        evidence = {"twist": texts(moves[0])}
    else:
        ways = [random_forces(rng, world, phi) for _ in range(growths + 1)]
        multiples = [Fraction(some(rng)) for _ in range(growths)]
        directions = [wrench_of(world, forces, 0) for forces in ways[1:]]
        w = wrench_of(world, ways[0], 1)
        for multiple, u in zip(multiples, directions):
            w = [a - multiple * b for a, b in zip(w, u)]
        evidence = {"forces": as_json(world, ways[0])}
    if growths:
        stand = [[texts([1, *multiples]), as_json(world, ways[0])]]
        for k in range(growths):
            stand.append([texts([0, *(j == k for j in range(growths))]), as_json(world, ways[k + 1])])
        weights = [abs(some(rng)) for _ in ways]
        point = [weights[0]] + [weights[0] * multiple + weight for multiple, weight in zip(multiples, weights[1:])]
        stand.append([texts(point), as_json(world, forces_added(world, *zip(weights, ways)))])
        evidence = {"stand": rng.sample(stand, rng.randint(0, len(stand))), "move": list(map(texts, moves))}
        if growths == 1:
            question["direction"] = texts(directions[0])
        else:
            question["plane"] = list(map(texts, directions))
    file["wrench"] = texts(w)
    question = {"contacts": len(world.elements), "wrench": texts(w), **question, "statics": texts([phi])[0]}
    options = [f"--statics={phi}"]
    if growths:
        options += ["--wrench=" + ",".join(map(str, texts(w)))]
        options += ["--" + name + "=" + ",".join(map(str, value if name == "direction" else sum(value, [])))
                    for name, value in question.items() if name in ("direction", "plane")]
    return file, {"format": "stickslip-certificate/2", "question": question, "verdict": kind, **evidence}, options


def numbers_in(value, path=()):
    """The paths of the numbers of a proof."""
    if isinstance(value, dict):
        return [one for key, inside in value.items() for one in numbers_in(inside, path + (key,))]
    if isinstance(value, list):
        return [one for k, inside in enumerate(value) for one in numbers_in(inside, path + (k,))]
    return [path] if path and not isinstance(value, bool) else []


def changed(rng, value, path):
    """With another number there."""
    value = copy.deepcopy(value)
    inside = value
    for key in path[:-1]:
        inside = inside[key]
    old = naive.number(inside[path[-1]])
    is_index = len(path) >= 2 and path[-1] == 0 and path[0] in ("forces", "stand") and isinstance(inside, list) and len(inside) == 3
    new = rng.choice([-old, old + 1, old - 1, old + Fraction(1, 10 ** 9), old - Fraction(1, 10 ** 9), 0, 2 * old])
    if is_index:
        new = max(0, int(old) + rng.choice([-1, 1]))
    inside[path[-1]] = texts([Fraction(new)])[0]
    return value


def can_be_asked(question):
    """That a direction is not 0, and those of a plane are independent."""
    rows = [naive.vector(row) for row in question.get("plane", [question["direction"]] if "direction" in question else [])]
    if len(rows) == 2:
        return any(rows[0][j] * rows[1][k] != rows[0][k] * rows[1][j] for j in range(len(rows[0])) for k in range(j))
    return all(any(row) for row in rows)


class StaticsCase(Case):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.asker = batch.Asker(folder.name)

    def judged(self, file, certificate, options, large=False):
        report = self.asker.answer(question_of(file, certificate, options))
        if STICKSLIP_CHECK:
            self.compare(report, in_batch([STICKSLIP_CHECK], file, certificate, options))
        if STICKSLIP_PROVED and not large:  # its time grows with the square of the number of bodies
            proved = in_batch([STICKSLIP_PROVED], file, certificate, options)
            self.compare_proved(report, proved)
            if report["result"] == "rejected":
                self.assertEqual((proved["rule"], proved["path"]), (report["rule"], report["path"]))
        return report


class TwinTest(StaticsCase):
    def same(self, file, certificate, options):
        report = self.judged(file, certificate, options)
        rule, path = naive.judge(file, certificate)
        result = "accepted" if rule is None else "malformed" if rule == "malformed" else "rejected"
        self.assertEqual(report["result"], result, (report, file, certificate, options))
        if result != "malformed":
            self.assertEqual((report["rule"], report["path"]), (rule, path), (report, json.dumps(file), json.dumps(certificate), options))
        return report

    def test_proofs_of_random_worlds_and_with_a_number_changed(self):
        rng, tally = random.Random(21), collections.Counter()
        for _ in range(300):
            file, certificate, options = random_proof(rng)
            if not can_be_asked(certificate["question"]):
                continue
            verdict = certificate["verdict"]
            report = self.same(file, certificate, options)
            tally[verdict, report["rule"]] += 1
            if verdict == "margin" and report["rule"] is None:
                self.claims_are_those(file, certificate, report)
            evidence = {key: certificate[key] for key in ("forces", "twist", "stand", "move") if key in certificate}
            paths = numbers_in(evidence)
            for path in rng.sample(paths, min(6, len(paths))):
                report = self.same(file, {**certificate, **changed(rng, evidence, path)}, options)
                tally[verdict, "changed", report["rule"]] += 1
        for verdict in ("may stand", "must move", "margin", "region"):
            self.assertGreater(tally[verdict, None], 15, tally)
        for rule, least in (("static-point", 2), ("static-force", 30), ("static-balance", 30), ("static-motion", 30)):
            self.assertGreater(sum(count for key, count in tally.items() if key[-1] == rule), least, tally)
        self.assertGreater(sum(count for key, count in tally.items() if key[1:] == ("changed", None)), 30, tally)

    def claims_are_those(self, file, certificate, report):
        """What is printed of a margin."""
        (low, high), move = report["standing"]["stand"] or ("0", "0"), report["standing"]["move"]
        ends = {naive.number(end) for end in [low, high, *(move if move != "all" else [])] if end is not None} | {Fraction(0)}
        for multiple in {end + step for end in ends for step in (-10 ** 6, -1, Fraction(-1, 10 ** 6), 0, Fraction(1, 10 ** 6), 1, 10 ** 6)}:
            stands = report["standing"]["stand"] is not None and not (low is not None and multiple < naive.number(low)) and not (
                high is not None and multiple > naive.number(high))
            moves = move == "all" or (move[0] is not None and multiple < naive.number(move[0])) or (
                move[1] is not None and multiple > naive.number(move[1]))
            self.assertEqual(stands, naive.claimed_to_stand(certificate, multiple), (certificate, multiple))
            self.assertEqual(moves, naive.claimed_to_move(file, certificate, multiple), (certificate, multiple))
            self.assertFalse(stands and moves, (file, certificate, multiple))

    def test_changed_worlds(self):
        """A number of the grasp file is another than that of the proof."""
        rng, tally = random.Random(22), collections.Counter()
        for _ in range(150):
            file, certificate, options = random_proof(rng)
            if not can_be_asked(certificate["question"]) or naive.judge(file, certificate)[0]:
                continue
            for _ in range(4):
                contacts = copy.deepcopy(file["contacts"])
                contact = rng.choice(contacts)
                name = rng.choice(["position", "normal", "friction", "preload"])
                if name in ("position", "normal"):
                    j = rng.randrange(len(contact[name]))
                    contact[name][j] = texts([naive.number(contact[name][j]) + rng.choice([-1, 1])])[0]
                else:
                    contact[name] = rng.choice([0, "1/3", 1])
                if any(contact["normal"]):
                    tally[self.same({**file, "contacts": contacts}, certificate, options)["rule"]] += 1
        self.assertGreater(tally[None], 50, tally)
        self.assertGreater(tally["static-force"], 3, tally)
        self.assertGreater(tally["static-balance"], 30, tally)
        self.assertGreater(tally["static-motion"], 10, tally)


def tower(count):
    """Blocks one on another, each with three contacts below."""
    contacts = [{"of": f"b{k}", **({"by": f"b{k - 1}"} if k else {}), "position": [x, k], "normal": [0, 3], "friction": "1/2"}
                for k in range(count) for x in (-1, 0, 1)]
    return {"format": "stickslip-grasp/3", "bodies": [{"name": f"b{k}"} for k in range(count)], "contacts": contacts,
            "loads": [{"body": f"b{k}", "weight": 1, "at": [0, k]} for k in range(count)]}


def certificate_of(file, w, **evidence):
    elements = len(file["contacts"]) + len([joint for joint in file.get("joints", []) if "stiffness" in joint])
    return {"format": "stickslip-certificate/2", "question": {"contacts": elements, "wrench": w, "normal_law": "unilateral", "statics": 1},
            "verdict": "may stand" if "forces" in evidence else "must move", **evidence}


class LargeTest(StaticsCase):
    """What is large takes as many steps as the files are long."""

    def steps(self, file, certificate):
        report = self.asker.answer(question_of(file, certificate, ["--statics=1"]))
        self.assertEqual(report["result"], "accepted", report["found"])
        return check.Work.steps / (len(json.dumps(file)) + len(json.dumps(certificate)))

    def linear(self, make):
        few, many = (self.steps(*make(count)) for count in (40, 1000))
        self.assertLess(many, 1.2 * few)

    def test_many_bodies(self):
        def stands(count):
            return tower(count), certificate_of(tower(count), [0, -1, 0] * count, forces=[
                [3 * k + j, f"{count - k}/{12 if j != 1 else 6}", 0] for k in range(count) for j in range(3)])

        def moves(count):
            file = tower(count)
            file["loads"].append({"body": f"b{count // 2}", "force": [count, 0], "at": [0, 0]})
            w = [c for k in range(count) for c in (count if k == count // 2 else 0, -1, 0)]
            return file, certificate_of(file, w, twist=[c for k in range(count) for c in ((2, 1, 0) if k >= count // 2 else (0, 0, 0))])

        self.linear(stands)
        self.linear(moves)

    def test_a_long_chain_of_links(self):
        def chain(count):
            links = [{"name": f"l{k}", "hinge": [k, 0], **({"on": f"l{k - 1}"} if k else {})} for k in range(count)]
            return {"format": "stickslip-grasp/3", "bodies": links, "contacts": [],
                    "joints": [{"turns": {f"l{k}": 1}, "stiffness": 1} for k in range(count)],
                    "loads": [{"body": f"l{k}", "force": [0, -1], "at": [k + 1, 0]} for k in range(count)]}

        def hangs(count):
            moments = [(count - k) * (count - k + 1) // 2 for k in range(count)]
            return chain(count), certificate_of(chain(count), [-c for c in moments], forces=[[k, c, 0] for k, c in enumerate(moments)])

        def turns(count):
            file = chain(count)
            del file["joints"][-1]["stiffness"]
            w = [-(count - k) * (count - k + 1) // 2 for k in range(count)]
            return file, certificate_of(file, w, twist=[0] * (count - 1) + [-1])

        self.linear(hangs)
        self.linear(turns)

    def test_as_many_coordinates_as_there_may_be(self):
        """65,535, as bodies in the plane have three; and not 65,538."""
        def free(count):
            return {"format": "stickslip-grasp/3", "bodies": [{"name": str(k)} for k in range(count)], "contacts": []}

        most = check.MOST_DIMENSION // 3
        certificate = certificate_of(free(0), [0] * (3 * most), forces=[])
        self.assertEqual(self.judged(free(most), certificate, ["--statics=1"], large=True)["result"], "accepted")
        report = self.judged(free(most + 1), certificate, ["--statics=1"], large=True)
        self.assertEqual((report["result"], "65538" in report["found"]), ("malformed", True), report)
        self.assertEqual(self.judged(free(11), certificate, [])["result"], "malformed")

    def test_work_is_limited(self):
        """Of a small file with long numbers, each of which is multiplied with all others."""
        contacts = [{"position": [f"1e{4000 - k}", 1], "normal": [1, f"1e-{4000 - k}"], "friction": "1e4000"} for k in range(60)]
        file = {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": [0, 0, 0]}
        certificate = {**certificate_of(file, [0, 0, 0], twist=[]), "verdict": "margin", "stand": [], "move": [[0, 0, 0]] * 600}
        del certificate["twist"]
        certificate["question"]["direction"] = [1, 0, 0]
        certificate["question"] = {key: certificate["question"][key] for key in ("contacts", "wrench", "normal_law", "direction", "statics")}
        report = self.asker.answer(question_of(file, certificate, ["--statics=1", "--wrench=0,0,0", "--direction=1,0,0"]))
        self.assertEqual(report["result"], "not judged", report)


if __name__ == "__main__":
    unittest.main()
