# SPDX-License-Identifier: MIT
"""Proofs by sticking contacts (certificate/FORMAT.md, section 6): a producer in doubles, for small grasps."""

import math
from fractions import Fraction

from at_rest import short_above, solve, tangents
from support import check


def text(values):
    return [str(c) for c in values] if isinstance(values, (tuple, list)) else str(values)


def ways_of(i, c, term):
    """What contact i can add: (i, None or a direction of friction, the wrench)."""
    if c.bounds["stiffness"].low > 0:
        yield i, None, term.N[0]
    if not term.friction.low:
        return
    soft = len(term.rows[0]) == 4
    for t in [(*t, *[Fraction(0)] * soft) for t in tangents(c.normal)] + [tuple(map(Fraction, (0, 0, 0, 1)))] * soft:
        yield i, t, tuple(check.dot(t, column) for column in zip(*term.rows[0]))


def sticking_proof(question, twist=None, multiples=(0,), bits=20, rest=None, bearing=None):
    """A PART, which need not be good enough, in which all rub or press that can, or of these those that are bearing. By least
    squares f0, if it is not given by contact, is about what balances the load, and H and G are a right inverse, rounded to so
    many bits behind the point; Z is twice what sticking-reach asks, and the energy twice what sticking-energy asks."""
    box = check.enlarged(question, 128)
    middle, size = box.middle(), box.dimension
    twist = tuple(map(Fraction, twist or [0] * size))
    multiple = Fraction(sum(multiples)) / len(multiples)
    bare = check.StickingProof(twist, [], [], [], (Fraction(1),) * size, Fraction(1))
    load = check.plus(tuple(w.low for w in question.wrench), multiple, box.growths[0])
    ways = []
    for i, (c, term, preload) in enumerate(zip(middle.contacts, middle.terms, check.preloads(middle, multiple))):
        at = check.sticking_at(bare, c, term, preload, (), ())
        load = check.plus(load, at.a.low, term.N[0])
        if (at.v.low > 0 or c.spring) and (bearing is None or i in bearing):
            ways += ways_of(i, c, term)
    lengths = [math.hypot(*map(float, column)) or 1.0 for _, _, column in ways]
    columns = [[float(c) / length for c in column] for (_, _, column), length in zip(ways, lengths)]
    square = [[sum(c[k] * c[j] for c in columns) for j in range(size)] for k in range(size)]
    inverse = solve(square, [[float(j == k) for j in range(size)] for k in range(size)])

    def forces(wrench):
        """The least that adds up to it: pushes and friction, by contact."""
        by = [sum(inverse[k][j] * float(wrench[j]) for j in range(size)) for k in range(size)]
        pushes, friction = {}, {}
        for (i, t, _), column, length in zip(ways, columns, lengths):
            along = Fraction(round(sum(map(float.__mul__, column, by)) / length * 2 ** bits), 2 ** bits)
            if t is None:
                pushes[i] = along
            else:
                friction[i] = check.plus(friction.get(i, (Fraction(0),) * len(t)), along, t)
        return pushes, friction

    answers = [forces([int(j == k) for j in range(size)]) for k in range(size)]
    rubbing = answers[0][1]
    rest = forces([-c for c in load])[1] if rest is None else {i: rest[i] for i in rubbing}
    proof = bare._replace(
        friction=[(i, [f]) for i, f in rest.items()], answers=[(i, [answer[i] for _, answer in answers]) for i in rubbing],
        presses=[(i, tuple(answer[i] for answer, _ in answers)) for i in answers[0][0]])
    friction, presses = check.friction_of(proof, box, ""), dict(proof.presses)
    for _ in range(3):
        proof = proof._replace(reach=needed_reach(proof, box, multiples, friction, presses))
    energy = 2 * max(sum((one.gamma for one in found), Fraction(0)) for found in elements(proof, box, multiples, friction, presses))
    return stated(proof._replace(energy=short_above(energy + Fraction(1, 2 ** 60))))


def elements(proof, box, multiples, friction, presses):
    for multiple in multiples:
        yield [check.sticking_at(proof, c, term, preload, friction.get(i, ()), presses.get(i, ()))
               for i, (c, term, preload) in enumerate(zip(box.contacts, box.terms, check.preloads(box, multiple)))]


def needed_reach(proof, box, multiples, friction, presses):
    most = [Fraction(0)] * box.dimension
    for multiple, found in zip(multiples, elements(proof, box, multiples, friction, presses)):
        left = check.largest_left(box, Fraction(multiple), [one.a for one in found], friction, presses)
        most = [max(a, left[k] + check.dot(left[k + box.dimension::box.dimension], proof.reach)) for k, a in enumerate(most)]
    return tuple(short_above(2 * a + Fraction(1, 2 ** 60)) for a in most)


def stated(proof):
    """As a certificate has it."""
    def force(f):
        return text(f) if len(f) > 1 else text(f[0])

    return {"sticking": text(proof.twist), "friction": [[i, force(f)] for i, (f,) in proof.friction],
            "presses": [[i, text(h)] for i, h in proof.presses],
            "answers": [[i, [force(f) for f in fs]] for i, fs in proof.answers],
            "reach": text(proof.reach), "energy": str(proof.energy)}
