# SPDX-License-Identifier: MIT
"""A slow, literal twin of check.py for statics: matrices as wide as motions, for every body and every element.

Nothing here is taken from the checker, and grasp files and certificates are as JSON has them, without errors of syntax. References
"§" are to certificate/FORMAT.md.
"""

from fractions import Fraction
from itertools import combinations_with_replacement


def dot(a, b):
    return sum((x * y for x, y in zip(a, b)), Fraction(0))


def number(value):
    return Fraction(str(value))


def vector(values):
    return [number(value) for value in values]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def wrench_at(p, f):
    return f + (cross(p, f) if len(p) == 3 else [p[0] * f[1] - p[1] * f[0]])


def transposed_times(matrix, x):
    """Of a matrix by rows."""
    return [dot(column, x) for column in zip(*matrix)]


def times(matrix, x):
    return [dot(row, x) for row in matrix]


class Malformed(Exception):
    pass


class Element:
    """§1, §14, §15: N, and S by rows; of a contact its n, and L² and γ; of a spring κ and τ."""

    def __init__(self, kind, N, S=(), n=(), friction=Fraction(0), torsion=Fraction(0), stiffness=Fraction(0), pull=Fraction(0)):
        self.kind, self.N, self.S, self.n, self.friction, self.stiffness, self.pull = kind, N, list(S), list(n), friction, stiffness, pull
        self.square = dot(self.n, self.n)
        self.gamma = torsion ** 2 / self.square if torsion else Fraction(0)

    def length_of_slip(self, s):
        """Its square, ⟨s, s⟩."""
        return dot(s[:3], s[:3]) + sum(self.gamma * c * c for c in s[3:])

    def length_of_force(self, f):
        """Its square."""
        return dot(f[:3], f[:3]) + sum(c * c / self.gamma for c in f[3:])


class World:
    """A grasp file."""

    def __init__(self, grasp):
        first = grasp["contacts"][0]["position"] if grasp["contacts"] else [0, 0]
        self.space = len(first) == 3
        self.size = 6 if self.space else 3
        joints = grasp.get("joints", [])
        bodies = grasp.get("bodies", [{"name": ""}])
        free = [body for body in bodies if "hinge" not in body and "slide" not in body]
        self.D = self.size * len(free) + len(joints)
        self.J = {"ground": [[Fraction(0)] * self.D for _ in range(self.size)]}
        self.turn = {}  # Σ_q c_bq e_q of links
        for body in bodies:
            name = body["name"]
            if body in free:
                begin = self.size * free.index(body)
                self.J[name] = [[Fraction(q == begin + j) for q in range(self.D)] for j in range(self.size)]
                continue
            self.turn[name] = [Fraction(0)] * (self.D - len(joints)) + [number(joint["turns"].get(name, 0)) for joint in joints]
            self.J[name] = [[a + e * c for a, c in zip(row, self.turn[name])] for row, e in zip(self.J[body.get("on", "ground")], self.eta(body))]
        defaults = grasp.get("defaults", {})
        self.elements = [self.contact({**defaults, **contact}) for contact in grasp["contacts"]]
        self.elements += [Element("ratchet", self.over(ratchet["over"])) for ratchet in grasp.get("ratchets", [])]
        for q, joint in enumerate(joints):
            if "stiffness" in joint or "torque" in joint:
                row = [Fraction(k == self.D - len(joints) + q) for k in range(self.D)]
                self.elements.append(Element("spring", row, stiffness=number(joint.get("stiffness", 0)), pull=number(joint.get("torque", 0))))
        for tendon in grasp.get("tendons", []):
            self.elements.append(Element("spring", self.over(tendon["over"]), stiffness=number(tendon.get("stiffness", 0)),
                                         pull=number(tendon.get("tension", 0))))
        self.w = vector(grasp["wrench"])

    def eta(self, body):
        if "slide" in body:
            return vector(body["slide"]) + [Fraction(0)] * (3 if self.space else 1)
        if self.space:
            c, g = vector(body["hinge"]["at"]), vector(body["hinge"]["axis"])
            return cross(c, g) + g
        x, y = vector(body["hinge"])
        return [y, -x, Fraction(1)]

    def over(self, numbers):
        return [sum((number(r) * self.turn[link][q] for link, r in numbers.items()), Fraction(0)) for q in range(self.D)]

    def contact(self, contact):
        p, n = vector(contact["position"]), vector(contact["normal"])
        G = [[a - b for a, b in zip(*rows)] for rows in zip(self.J[contact.get("of", "")], self.J[contact.get("by", "ground")])]
        square, torsion = dot(n, n), number(contact.get("torsion", 0))
        if self.space:
            # u = (d₁, d₂, d₃) + ω × p, less its part along n: the rows of that matrix, by unit motions.
            units = [[Fraction(j == k) for k in range(6)] for j in range(6)]
            moved = [[a + b for a, b in zip(one[:3], cross(one[3:], p))] for one in units]
            slips = [[a - dot(n, u) / square * b for a, b in zip(u, n)] for u in moved]
            if torsion:
                slips = [slip + [dot(n, one[3:])] for slip, one in zip(slips, units)]
            S = [list(row) for row in zip(*slips)]
        else:
            S = [wrench_at(p, [-n[1], n[0]])]  # T
        return Element("contact", transposed_times(G, wrench_at(p, n)), [transposed_times(G, row) for row in S], n,
                       number(contact["friction"]), torsion)


def may_push(element, phi, a, f):
    """H(φ)."""
    if element.kind == "spring":
        return element.stiffness > 0 and not any(f)
    if element.kind == "ratchet":
        return a >= 0 and not any(f)
    most = phi * element.friction * a
    if len(f) == 1:
        return a >= 0 and -most <= f[0] <= most
    return a >= 0 and dot(f[:3], element.n) == 0 and element.length_of_force(f) <= most ** 2 * element.square


def opposes(element, phi, y):
    """Against `static-motion`."""
    along = dot(y, element.N)
    if element.kind == "spring":
        return element.stiffness > 0 and along != 0
    s = times(element.S, y)
    if len(s) == 1:  # τ: its slip is (τ / L²) t
        square = phi ** 2 * element.friction ** 2 * element.square * (s[0] ** 2 / element.square)
    else:
        square = phi ** 2 * element.friction ** 2 * element.square * element.length_of_slip(s) if s else 0
    return along < 0 or along ** 2 < square


def forces_rule(world, phi, loads, point, forces):
    """The rule that they fail, or None."""
    if point[0] < 0:
        return "static-point"
    last = -1
    for i, a, f in forces:
        if not last < i < len(world.elements) or not may_push(world.elements[i], phi, a, f):
            return "static-force"
        last = i
    total = [dot(point, column) for column in zip(*loads)]
    for element in world.elements:
        if element.kind == "spring" and element.stiffness == 0:
            total = [c + point[0] * element.pull * n for c, n in zip(total, element.N)]
    for i, a, f in forces:
        element = world.elements[i]
        total = [c + a * n for c, n in zip(total, element.N)]
        if element.S:
            total = [c + s for c, s in zip(total, transposed_times(element.S, f))]
    return "static-balance" if any(total) else None


def forces_of(world, listed):
    """With as many numbers of friction as §2 says."""
    forces = [(i, number(a), vector(f if isinstance(f, list) else [f])) for i, a, f in listed]
    for i, _, f in forces:
        soft = i < len(world.elements) and world.elements[i].gamma
        if len(f) != (1 if not world.space else 4 if soft else 3):
            raise Malformed
    return forces


def judge(grasp, certificate):
    """(rule, path), or (None, None) if it is accepted. The question that was asked is the certificate's."""
    try:
        return judge_read(grasp, certificate)
    except Malformed:
        return "malformed", None


def judge_read(grasp, certificate):
    world, question = World(grasp), certificate["question"]
    phi = number(question["statics"])
    w = vector(question["wrench"])
    growths = list(map(vector, question.get("plane", [question["direction"]] if "direction" in question else [])))
    if "forces" in certificate:
        return failed(forces_rule(world, phi, [w], [Fraction(1)], forces_of(world, certificate["forces"])), "forces")
    if "twist" in certificate:
        y = vector(certificate["twist"])
        works = dot(y, w) + sum(element.pull * dot(y, element.N) for element in world.elements
                                if element.kind == "spring" and element.stiffness == 0)
        return failed("static-motion" if works <= 0 or any(opposes(element, phi, y) for element in world.elements) else None, "twist")
    stand = [(vector(point), forces_of(world, forces)) for point, forces in certificate["stand"]]
    for k, (point, forces) in enumerate(stand):
        rule = forces_rule(world, phi, [w, *growths], point, forces)
        if rule:
            return rule, f"stand {k}"
    for k, y in enumerate(certificate["move"]):
        if any(opposes(element, phi, vector(y)) for element in world.elements):
            return "static-motion", f"move {k}"
    return None, None


def failed(rule, place):
    return (rule, place) if rule else (None, None)


def claimed_to_stand(certificate, multiple):
    """Whether (1, λ) is a sum of multiples ≥ 0 of load points; of a margin."""
    points = [vector(point) for point, _ in certificate["stand"]]
    for (h, x), (k, y) in combinations_with_replacement(points, 2):
        # s (h, x) + t (k, y) = (1, λ)
        determinant = h * y - k * x
        if determinant:
            s, t = (y - k * multiple) / determinant, (h * multiple - x) / determinant
            if s >= 0 and t >= 0:
                return True
        if (h and x == multiple * h) or (k and y == multiple * k):
            return True
    return False


def claimed_to_move(grasp, certificate, multiple):
    world, question = World(grasp), certificate["question"]
    load = [a + multiple * b for a, b in zip(vector(question["wrench"]), vector(question["direction"]))]
    for element in world.elements:
        if element.kind == "spring" and element.stiffness == 0:
            load = [c + element.pull * n for c, n in zip(load, element.N)]
    return any(dot(vector(y), load) > 0 for y in certificate["move"])
