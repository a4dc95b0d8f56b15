# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies in the plane as a text of SMT-LIB in linear real arithmetic: sat if they hold.

Written from mechanics and not from rows: every body has velocities, a link those of the body that it is on and of its
joints beside it; the forces and torques on each free body balance, and on every joint the torques about its hinges of all
forces farther out, or the forces along its slides, and what its springs do."""

from fractions import Fraction as F


def number(x):
    x = F(x)
    text = str(abs(x.numerator)) if x.denominator == 1 else f"(/ {abs(x.numerator)} {x.denominator})"
    return text if x >= 0 else f"(- {text})"


def exact(x):
    return F(str(x)) if not isinstance(x, F) else x


def times(c, term):
    return f"(* {number(c)} {term})"


def plus(*terms):
    return f"(+ 0 {' '.join(terms)})"


class Model:
    def __init__(self, grasp):
        self.grasp = grasp
        self.bodies = {b["name"]: b for b in grasp["bodies"]}
        self.joints = grasp.get("joints", [])
        self.lines, self.asserts = [], []
        self.loads = []  # body, force x, y (terms), at

    def new(self, name):
        self.lines.append(f"(declare-const {name} Real)")
        return name

    def claim(self, text):
        self.asserts.append(f"(assert {text})")

    def rates(self, link):
        """What turns the link itself, and how fast."""
        return [(k, exact(joint["turns"][link])) for k, joint in enumerate(self.joints) if link in joint["turns"]]

    def outboard(self, name):
        """The links on the way from the ground to the body, itself included, and the free body that they are on."""
        chain = []
        while name is not None and name != "ground":
            body = self.bodies[name]
            if "hinge" not in body and "slide" not in body:
                return chain, name
            chain.append(name)
            name = body.get("on")
        return chain, None

    def speed(self, name, p):
        """Of the point p of a body: two terms."""
        if name in (None, "ground"):
            return "0", "0"
        chain, free = self.outboard(name)
        x, y = [], []
        if free is not None:
            i = list(self.bodies).index(free)
            x += [f"x{i}", times(-p[1], f"r{i}")]
            y += [f"y{i}", times(p[0], f"r{i}")]
        for link in chain:
            body = self.bodies[link]
            for k, rate in self.rates(link):
                if "slide" in body:
                    g = [exact(c) for c in body["slide"]]
                    x.append(times(rate * g[0], f"q{k}"))
                    y.append(times(rate * g[1], f"q{k}"))
                else:
                    c = [exact(t) for t in body["hinge"]]
                    x.append(times(-rate * (p[1] - c[1]), f"q{k}"))
                    y.append(times(rate * (p[0] - c[0]), f"q{k}"))
        return plus(*x), plus(*y)

    def turned(self, over):
        """By how much links turn, times the numbers of `over`."""
        return plus(*(times(exact(arm) * rate, f"q{k}") for link, arm in over.items() for k, rate in self.rates(link)))

    def text(self):
        free = [i for i, b in enumerate(self.grasp["bodies"]) if "hinge" not in b and "slide" not in b]
        for i in free:
            for c in "xyr":
                self.new(f"{c}{i}")
        for k in range(len(self.joints)):
            self.new(f"q{k}")
        for load in self.grasp.get("loads", []):
            if "weight" in load:
                force, at = (0, -exact(load["weight"])), load["at"]
            else:
                force, at = load["force"], load["at"]
            self.loads.append((load["body"], number(exact(force[0])), number(exact(force[1])), [exact(c) for c in at]))
        for i, contact in enumerate(self.grasp["contacts"]):
            self.contact(i, {**self.grasp.get("defaults", {}), **contact})
        pulls = {k: [] for k in range(len(self.joints))}  # of springs, on joints
        for k, joint in enumerate(self.joints):
            pulls[k].append(plus(number(exact(joint.get("torque", 0))),
                                 times(-exact(joint.get("stiffness", 0)), f"q{k}")))
        for kind, force, pushes in (("tendons", "tension", False), ("ratchets", "preload", True)):
            for spring in self.grasp.get(kind, []):
                tension = plus(number(exact(spring.get(force, 0))),
                               times(-exact(spring.get("stiffness", 0)), self.turned(spring["over"])))
                if pushes:
                    tension = f"(ite (> {tension} 0) {tension} 0)"
                for link, arm in spring["over"].items():
                    for k, rate in self.rates(link):
                        pulls[k].append(times(exact(arm) * rate, tension))
        for i in free:
            self.balance(i)
        for k in pulls:
            self.joint(k, pulls[k])
        return "\n".join(["(set-logic QF_LRA)", *self.lines, *self.asserts, "(check-sat)", ""])

    def contact(self, i, c):
        p, n = [exact(t) for t in c["position"]], [exact(t) for t in c["normal"]]
        square = n[0] * n[0] + n[1] * n[1]
        root = next((F(a, b) for b in range(1, 200) for a in [round(float(square) ** 0.5 * b)] if F(a, b) ** 2 == square), None)
        preload, k, mu = exact(c.get("preload", 0)), exact(c.get("stiffness", 1)), exact(c["friction"])
        assert preload == 0 or root is not None
        of, by = self.speed(c["of"], p), self.speed(c.get("by"), p)
        move = [f"(- {a} {b})" for a, b in zip(of, by)]
        rise = plus(times(n[0], move[0]), times(n[1], move[1]))
        slip = plus(times(-n[1], move[0]), times(n[0], move[1]))
        a, b = self.new(f"a{i}"), self.new(f"b{i}")
        v = plus(number(preload / root if preload else 0), times(-k / square, rise))
        self.claim(f"(= {a} (ite (> {v} 0) {v} 0))")
        most = times(mu, a)
        self.claim(f"(and (<= {b} {most}) (>= {b} (- {most})))")
        self.claim(f"(=> (> {slip} 0) (= {b} (- {most})))")
        self.claim(f"(=> (< {slip} 0) (= {b} {most}))")
        fx = plus(times(n[0], a), times(-n[1], b))
        fy = plus(times(n[1], a), times(n[0], b))
        self.loads.append((c["of"], fx, fy, p))
        if c.get("by", "ground") != "ground":
            self.loads.append((c["by"], f"(- {fx})", f"(- {fy})", p))

    def balance(self, i):
        name = self.grasp["bodies"][i]["name"]
        here = [l for l in self.loads if self.outboard(l[0])[1] == name]
        self.claim(f"(= 0 {plus(*(l[1] for l in here))})")
        self.claim(f"(= 0 {plus(*(l[2] for l in here))})")
        self.claim(f"(= 0 {plus(*(plus(times(l[3][0], l[2]), times(-l[3][1], l[1])) for l in here))})")

    def joint(self, k, pulls):
        terms = list(pulls)
        for link, rate in self.joints[k]["turns"].items():
            body, rate = self.bodies[link], exact(rate)
            for name, fx, fy, p in self.loads:
                if link not in self.outboard(name)[0]:
                    continue
                if "slide" in body:
                    g = [exact(c) for c in body["slide"]]
                    terms += [times(rate * g[0], fx), times(rate * g[1], fy)]
                else:
                    c = [exact(t) for t in body["hinge"]]
                    terms += [times(rate * (p[0] - c[0]), fy), times(-rate * (p[1] - c[1]), fx)]
        self.claim(f"(= 0 {plus(*terms)})")


def smt(grasp):
    return Model(grasp).text()


def statics(grasp):
    """Whether forces in the friction cones alone balance the weights of free bodies, whatever moves."""
    lines, sums = ["(set-logic QF_LRA)"], {b["name"]: ([], [], []) for b in grasp["bodies"]}
    for i, c in enumerate(grasp["contacts"]):
        a, t, edge = f"a{i}", f"t{i}", times(exact(c["friction"]), f"a{i}")
        lines.append(f"(declare-const {a} Real) (declare-const {t} Real) (assert (and (>= {a} 0) (<= {t} {edge}) (>= (+ {t} {edge}) 0)))")
        if "max_force" in c:  # a is the force over the length 1 of the normal
            lines.append(f"(assert (<= {a} {number(exact(c['max_force']))}))")
        (nx, ny), (px, py) = ([exact(x) for x in c[key]] for key in ("normal", "position"))
        for body, side in ((c["of"], 1), (c.get("by"), -1)):
            terms = ((nx, -ny), (ny, nx), (px * ny - py * nx, px * nx + py * ny))
            for k, (along, across) in enumerate(terms if body else ()):
                sums[body][k].extend((times(side * along, a), times(side * across, t)))
    for load in grasp["loads"]:
        w, x = exact(load["weight"]), exact(load["at"][0])
        sums[load["body"]][1].append(number(-w))
        sums[load["body"]][2].append(number(-w * x))
    lines += [f"(assert (= 0 {plus(*terms)}))" for three in sums.values() for terms in three]
    return "\n".join([*lines, "(check-sat)"])
