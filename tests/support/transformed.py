# SPDX-License-Identifier: GPL-3.0-or-later
"""The same question of a grasp in another frame, in other units, and in another order, exactly or in doubles."""

from fractions import Fraction as F

QUARTER = ((0, -1), (1, 0))
THREE_FOUR_FIVE = ((F(3, 5), F(-4, 5)), (F(4, 5), F(3, 5)))
MIRROR = ((-1, 0), (0, 1))


def by_quaternion(w, x, y, z):
    """An exact rotation; a quaternion of doubles gives it in doubles."""
    n = w * w + x * x + y * y + z * z
    one = F(1) if isinstance(n, (int, F)) else 1.0
    return (((w * w + x * x - y * y - z * z) * one / n, 2 * (x * y - w * z) * one / n, 2 * (x * z + w * y) * one / n),
            (2 * (x * y + w * z) * one / n, (w * w - x * x + y * y - z * z) * one / n, 2 * (y * z - w * x) * one / n),
            (2 * (x * z - w * y) * one / n, 2 * (y * z + w * x) * one / n, (w * w - x * x - y * y + z * z) * one / n))


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def turn_about(force, at):
    return cross(at, force) if len(at) == 3 else [at[0] * force[1] - at[1] * force[0]]


def total(terms):
    return [sum(column) for column in zip(*terms)]


def force_of(load, dimension):
    """A force or a weight, exactly."""
    if "force" in load:
        return [F(x) if isinstance(x, str) else F(str(x)) for x in load["force"]]
    down = [exact(x) for x in load.get("direction", [0] * (dimension - 1) + [-1])]
    square = sum(x * x for x in down)
    length = F(square.numerator ** 0.5) / F(square.denominator ** 0.5)
    assert length * length == square, load
    return [exact(load["weight"]) * x / length for x in down]


def exact(x):
    return F(x if isinstance(x, str) else repr(x) if isinstance(x, float) else x)


def dimension_of(content):
    return len(content["contacts"][0]["position"])


def questions(content):
    """A file's cases, each as a file with one load: a wrench of one body, loads of several."""
    several, dimension = content["format"].endswith("/3"), dimension_of(content)
    size = 3 * dimension - 3

    def wrench(part):
        terms = [[exact(x) for x in part["wrench"]]] if "wrench" in part else [[F(0)] * size]
        for load in part.get("loads", []):
            if "torque" in load:
                torque = load["torque"] if isinstance(load["torque"], list) else [load["torque"]]
                terms.append([F(0)] * dimension + [exact(x) for x in torque])
            else:
                force = force_of(load, dimension)
                terms.append(force + turn_about(force, [exact(x) for x in load["at"]]))
        return total(terms)

    rest = {key: value for key, value in content.items() if key not in ("wrench", "loads", "cases", "name", "outline", "body")}
    for case in content.get("cases", [{}]):
        if several:
            yield {**rest, "loads": content.get("loads", []) + case.get("loads", [])}
        else:
            yield {**rest, "wrench": [str(w) for w in total([wrench(content), wrench(case)])]}


class Change:
    """Turned by `rows`, an orthogonal matrix, then moved by `offset`; lengths times `length`, forces times `force`, normals
    times `longer`. In doubles, if `number` is float, as someone has them who computes all of it in doubles."""

    def __init__(self, rows, offset=None, length=1, force=1, longer=1, number=F):
        self.number, size = number, len(rows)
        self.rows = [[number(x) for x in row] for row in rows]
        self.length, self.force, self.longer = number(length), number(force), number(longer)
        self.offset = [number(x) for x in offset or [0] * size]
        r = self.rows
        self.sign = (sum(a * b for a, b in zip(r[0], cross(r[1], r[2]))) if size == 3 else r[0][0] * r[1][1] - r[0][1] * r[1][0])
        self.sign = 1 if self.sign > 0 else -1

    def read(self, x):
        return self.number(exact(x))

    def write(self, x):
        return x if self.number is float else str(x)

    def scaled(self, x, factor):
        if isinstance(x, dict):
            return {key: self.scaled(end, factor) for key, end in x.items()}
        return self.write(self.read(x) * factor)

    def turned(self, vector):
        return [sum(a * self.read(x) for a, x in zip(row, vector)) for row in self.rows]

    def direction(self, vector, factor=1):
        return [self.write(x * factor) for x in self.turned(vector)]

    def point(self, at):
        return [self.write(x * self.length + o) for x, o in zip(self.turned(at), self.offset)]

    def torque(self, torque):
        """Of a couple: in the plane a number; in space a vector that a mirror turns round."""
        factor = self.sign * self.force * self.length
        return [x * factor for x in (self.turned(torque) if len(torque) == 3 else [self.read(torque[0])])]

    def wrench(self, wrench):
        size = len(self.rows)
        force = [x * self.force for x in self.turned(wrench[:size])]
        moved = turn_about(force, self.offset)
        return [self.write(x) for x in force + [a + b for a, b in zip(self.torque(wrench[size:]), moved)]]

    def laws(self, of):
        """What a contact says of its laws, in the new units; `of` has all of it."""
        result = {"friction": self.scaled(of["friction"], 1), "stiffness": self.scaled(of.get("stiffness", 1), self.force / self.length),
                  "preload": self.scaled(of.get("preload", 0), self.force)}
        return {**result, "torsion": self.scaled(of["torsion"], self.length)} if "torsion" in of else result

    def contact(self, given, defaults):
        who = {key: given[key] for key in ("of", "by") if key in given}
        return {**who, "position": self.point(given["position"]), "normal": self.direction(given["normal"], self.longer),
                **self.laws({**defaults, **given})}

    def load(self, load):
        body = {"body": load["body"]}
        if "wrench" in load:
            return {**body, "wrench": self.wrench(load["wrench"])}
        if "torque" in load:
            several = isinstance(load["torque"], list)
            torque = [self.write(x) for x in self.torque(load["torque"] if several else [load["torque"]])]
            return {**body, "torque": torque if several else torque[0]}
        return {**body, "force": self.direction(force_of(load, len(self.rows)), self.force), "at": self.point(load["at"])}

    def of_body(self, body):
        result, size = {"name": body["name"], **({"on": body["on"]} if "on" in body else {})}, len(self.rows)
        if "hinge" in body and size == 2:
            return {**result, "hinge": self.point(body["hinge"])}
        if "hinge" in body:
            return {**result, "hinge": {"at": self.point(body["hinge"]["at"]), "axis": self.direction(body["hinge"]["axis"], self.sign)}}
        return {**result, "slide": self.direction(body["slide"], self.length)} if "slide" in body else result

    def over(self, one, hinges, factor):
        """Of a joint or a tendon: in the plane a mirror turns angles round."""
        sign = self.sign if len(self.rows) == 2 else 1
        return {link: self.scaled(x, factor * (sign if link in hinges else 1)) for link, x in one.items()}

    def __call__(self, content, rng=None):
        """The changed file; with `rng`, its contacts, bodies and loads in another order, and contacts of two bodies given by
        the other one."""
        shuffled = (lambda x: rng.sample(x, len(x))) if rng else list
        defaults = content.get("defaults", {})
        contacts = [self.contact(c, defaults) for c in shuffled(content["contacts"])]
        if not content["format"].endswith("/3"):
            return {"format": "stickslip-grasp/2", "contacts": contacts, "wrench": self.wrench(content["wrench"])}
        names = {body["name"] for body in content["bodies"]}
        for c in contacts:
            if rng and c.get("by") in names and rng.random() < 0.5:
                c.update({"of": c["by"], "by": c["of"], "normal": [self.write(-self.read(x)) for x in c["normal"]]})
        bodies = [self.of_body(body) for body in content["bodies"]]
        hinges = {body["name"] for body in bodies if "hinge" in body}
        links = len(bodies) - sum("hinge" not in body and "slide" not in body for body in bodies)
        work = self.force * self.length
        result = {"format": content["format"], "bodies": bodies if links else shuffled(bodies), "contacts": contacts,
                  "loads": [self.load(load) for load in shuffled(content.get("loads", []))]}
        for joint in content.get("joints", []):
            result.setdefault("joints", []).append({"turns": self.over(joint["turns"], hinges, 1),
                                                    **{key: self.scaled(joint[key], work) for key in ("stiffness", "torque") if key in joint}})
        for kind in ("tendons", "ratchets"):
            for one in content.get(kind, []):
                laws = {"stiffness": self.force / self.length, "tension": self.force, "preload": self.force}
                result.setdefault(kind, []).append({"over": self.over(one["over"], hinges, self.length),
                                                    **{key: self.scaled(one[key], by) for key, by in laws.items() if key in one}})
        return result
