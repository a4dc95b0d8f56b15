# SPDX-License-Identifier: GPL-3.0-or-later
"""Several bodies as Python takes and gives them, and what is for one body alone."""

import json
import pickle
import re
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from conftest import ROOT, program
from stickslip import Assembly, Grasp, InputError, decide

EXAMPLES = ROOT / "examples" / "grasps"
HALF = Fraction(1, 2)


def blocks(mu="1/2", **members):
    """One block of weight 10 on another of weight 10 on a table; faces of half-width 1 and 4/5."""
    return Assembly({
        "name": "blocks",
        "bodies": [{"name": "low"}, {"name": "up"}],
        "defaults": {"friction": mu},
        "contacts": [
            {"of": "low", "position": [-1, 0], "normal": [0, 1]},
            {"of": "low", "position": [1, 0], "normal": [0, 1]},
            {"of": "up", "by": "low", "position": ["-4/5", 1], "normal": [0, 1]},
            {"of": "up", "by": "low", "position": ["4/5", 1], "normal": [0, 1]}],
        "loads": [{"body": "low", "weight": 10, "at": [0, "1/2"]},
                  {"body": "up", "weight": 10, "at": [0, "3/2"]}], **members})


def lever(stiffness=2, torque=0, load=3):
    """A link that turns about the origin, with a spring and a force at (1, 0)."""
    return Assembly({
        "bodies": [{"name": "arm", "hinge": [0, 0]}],
        "joints": [{"name": "hip", "turns": {"arm": 1}, "stiffness": stiffness, "torque": torque}],
        "contacts": [], "loads": [{"body": "arm", "force": [0, load], "at": [1, 0]}]})


def test_what_it_says():
    two = blocks()
    assert (two.name, two.bodies, len(two), two.in_space) == ("blocks", ("low", "up"), 4, False)
    assert two.coordinates == ("low.x", "low.y", "low.turn", "up.x", "up.y", "up.turn")
    assert two.contact_bodies == (("low", "ground"),) * 2 + (("up", "low"),) * 2
    assert two.wrench == (0, -10, 0, 0, -10, 0) and two.springs == ()
    assert two.positions[2] == (Fraction(-4, 5), 1) and two.friction == (Fraction(1, 2),) * 4
    assert two.outline == () and two.body is None and two.units == {}
    assert repr(two) == ("Assembly(name='blocks', bodies=('low', 'up'), contacts=4, "
                         "wrench=(0, -10, 0, 0, -10, 0))")
    arm = lever()
    assert (arm.bodies, arm.coordinates, arm.springs, arm.wrench) == (("arm",), ("hip",), ("hip",), (3,))
    hand = Grasp.from_file(EXAMPLES / "bodies-hand.json")
    assert isinstance(hand, Assembly) and hand.in_space and len(hand.positions[0]) == 3


def test_many():
    pushes = [3, 5, 6]
    loads = [(0, -10, 0, push, -10, -push) for push in pushes]
    many = decide(blocks(), loads)
    assert many.verdict.tolist() == ["stable", "stable", "unstable"]
    assert many.wrench_float.tolist() == [list(map(float, load)) for load in loads]
    assert many.twist_float.shape == (3, 6) and many.forces_float.shape == (3, 4, 2)
    one = decide(blocks(), loads[0])
    assert many[0].forces == one.forces and many[0].grasp == one.grasp and many[0].check()
    assert np.array_equal(many.forces_float[0], one.forces_float)
    assert np.isnan(many.forces_float[2]).all()
    assert pickle.loads(pickle.dumps(many)) == many
    assert decide(blocks(), loads[0], friction=["1/4", "1/2"]).verdict.tolist() == ["unstable", "stable"]
    columns = many.to_dataframe().columns
    assert "load_up.x" in columns and "motion_low.turn" in columns
    levers = decide([lever(1), lever(2)])
    assert levers.twist_float.tolist() == [[3], [1.5]]
    with pytest.raises(InputError, match="differ in their bodies or joints"):
        decide([blocks(), lever()])
    in_space = Assembly({  # of one coordinate, too
        "bodies": [{"name": "arm", "hinge": {"at": [0, 0, 0], "axis": [0, 0, 1]}}],
        "joints": [{"name": "hip", "turns": {"arm": 1}, "stiffness": 1}],
        "contacts": [{"of": "arm", "position": [0, 0, 9], "normal": [0, 0, 1], "friction": 0}]})
    assert in_space.in_space and in_space.coordinates == lever().coordinates
    with pytest.raises(InputError, match="differ in their bodies or joints"):
        decide([lever(), in_space])
    planar = Grasp([[0, 0]], [[0, 1]], 1, wrench=(0, -1, 0))
    with pytest.raises(InputError, match="differ in their bodies or joints"):
        decide([planar, lever()])


def test_round_trips():
    for path in sorted(EXAMPLES.glob("bodies-*.json")):
        read = Assembly.from_file(path)
        again = Assembly.from_text(read.to_text())
        assert again == read == Assembly(json.loads(path.read_text(), parse_float=Decimal))
        assert hash(again) == hash(read) and type(Grasp.from_text(read.to_text())) is Assembly
        thawed = pickle.loads(pickle.dumps(read))
        assert type(thawed) is Assembly and thawed == read and thawed.bodies == read.bodies
    assert lever(0.5) == lever("1/2") == lever(Fraction(1, 2)) != lever(0.1) != lever("0.1")
    assert lever(0.1).to_text() == lever(Fraction(0.1)).to_text()
    answer = decide(blocks())
    assert pickle.loads(pickle.dumps(answer)) == answer


@pytest.mark.parametrize("content, place", [
    ("{}", "content"),
    ({"bodies": [], "contacts": []}, "bodies"),
    ({"bodies": [{"name": "a", "hinge": [0, float("nan")]}], "contacts": []}, "bodies[0].hinge[1]"),
    ({"bodies": [{"name": "a"}], "contacts": [{"of": "b", "position": [0, 0], "normal": [0, 1],
                                               "friction": 1}]}, "contacts[0].of"),
    ({"bodies": [{"name": "a"}], "contacts": [], "wrench": [0, 0]}, "wrench"),
    ({"bodies": [{"name": "a"}], "contacts": [], 3: 4}, "a key of the file"),
    ({"format": "stickslip-grasp/2", "contacts": [], "wrench": [0, 0, 0]}, "format"),
])
def test_errors_of_content(content, place):
    with pytest.raises(InputError) as error:
        Assembly(content)
    assert error.value.place == place and error.value.remedy


def test_a_contact_that_is_turned_round():
    assert decide(blocks(), warnings=True).warnings == ()
    turned = blocks(contacts=[{"of": "low", "position": [-1, 0], "normal": [0, 1]},
                              {"of": "low", "position": [1, 0], "normal": [0, 1]},
                              {"of": "low", "by": "up", "position": [0, 1], "normal": [0, 1]}])
    for answer in (decide(turned, warnings=True), stickslip.margin(turned, (0, 0, 0, 1, 0, 0), warnings=True)):
        [warning] = answer.warnings
        assert warning.trap == "reversed-contact"
        assert warning.text.startswith('contacts[2] would pull "low" and "up" apart')
    assert decide(turned).warnings == ()


def test_errors_of_arguments():
    answer = decide(blocks())
    other = (1, *answer.wrench[1:])
    assert stickslip.check(answer.grasp, answer.certificate, wrench=other).rule == "question-wrench"
    with pytest.raises(InputError, match="the grasp has cases"):
        decide(Assembly.from_file(EXAMPLES / "bodies-stack.json"))
    with pytest.raises(InputError) as error:
        decide(blocks(), (0, -10, 0))
    assert error.value.place == "wrench" and "low.x, low.y" in error.value.remedy
    with pytest.raises(InputError) as error:
        stickslip.margin(blocks(), (0, -10, 0))
    assert error.value.place == "direction"
    with pytest.raises(InputError, match="several bodies"):
        decide(blocks(), engine="states")
    text = Grasp([[0, 0]], [[0, 1]], 1, wrench=(0, -1, 0)).to_text()
    assert type(Grasp.from_text(text)) is Grasp
    with pytest.raises(InputError, match="one body"):
        Assembly.from_text(text)
    with pytest.raises(AttributeError):
        blocks().name = "other"


HAND = EXAMPLES / "bodies-hand.json"


@pytest.mark.parametrize("ask", [
    lambda a: stickslip.region(a),
    lambda a: stickslip.plot_region(a),
    lambda a: stickslip.slip_states(a),
    lambda a: stickslip.export(a),
    lambda a: stickslip.crosscheck(a, "stable"),
    lambda a: a.snap(),
])
def test_what_is_for_one_body(ask):
    for assembly in (blocks(), Assembly.from_file(HAND)):
        with pytest.raises(InputError) as error:
            ask(assembly)
        assert error.value.problem == "the grasp has several bodies"


def pushed(names, in_space=False):
    """Blocks on each other, with friction 1/2; of weight 1, and the upper one is pushed by 1/4."""
    feet = [(x, y) for x in (-1, 1) for y in (-1, 1)] if in_space else [(-1,), (1,)]
    middle = [0] * (2 if in_space else 1)
    return Assembly.from_text(json.dumps({
        "format": "stickslip-grasp/3", "bodies": [{"name": name} for name in names], "defaults": {"friction": "1/2", "preload": 1},
        "contacts": [{"position": [*foot, k], "normal": [*middle, 1], "of": of, "by": names[k - 1] if k else "ground"}
                     for k, of in enumerate(names) for foot in feet],
        "loads": [{"body": name, "weight": 1, "at": [*middle, k]} for k, name in enumerate(names)]
        + [{"body": names[-1], "force": ["1/4", *middle], "at": [*middle, len(names) - 1]}]}))


@pytest.mark.parametrize("in_space", [False, True])
def test_one_body_is_a_grasp(in_space):
    assembly = pushed(["up"], in_space)
    grasp = Grasp(assembly.positions, assembly.normals, assembly.friction, preload=assembly.preload, wrench=assembly.wrench)
    methods = ["passive-equilibrium", "weakly-stable-load", "strongly-stable-load", "PGR", "least-normal-forces"]
    found, expected = (stickslip.compare(about, methods=methods, length=2, max_force=3) for about in (assembly, grasp))
    assert found.methods == expected.methods and len(found.methods) == 5
    assert found.load_class == expected.load_class == "must hold"
    load = (1, *assembly.wrench[1:])
    assert stickslip.compare(assembly, load, methods=methods[1:2]).load_class == "must move"
    assert stickslip.class_margin(assembly, load, assembly.wrench) == stickslip.class_margin(grasp, load, grasp.wrench)
    assert stickslip.friction_margin(assembly) == stickslip.friction_margin(grasp)
    assert stickslip.export(assembly) == stickslip.export(grasp)
    if not in_space:
        assert stickslip.region(assembly).areas == stickslip.region(grasp).areas != ()
        assert stickslip.plot_region(assembly) == stickslip.plot_region(grasp)
        with pytest.raises(InputError, match="several bodies"):  # the proof would be about the file
            stickslip.region(assembly, certificate=True)
    # The proof is about the file, whose checkers know it as one of several bodies.
    proved = stickslip.compare(assembly, certificate=True)
    assert (proved.methods, proved.load_class) == ((), "may stand")
    assert stickslip.check(assembly, proved.certificate, statics=1).verdict == "may stand"


def words(row):
    return ",".join(map(str, row))


def class_at(rows, at):
    [found] = [row.load_class for row in rows if (row.low < at or row.low == at and row.has_low)
               and (row.high is None or at < row.high or at == row.high and row.has_high)]
    return found


@pytest.mark.parametrize("assembly", [pushed(["low", "up"]), pushed(["low", "up"], True), pushed(["up"], True), Assembly.from_file(HAND)],
                         ids=["two", "two in space", "one in space", "a hand"])
def test_classes_of_statics_are_those_of_the_program(assembly, tmp_path):
    path = tmp_path / "g.json"
    path.write_text(assembly.to_text())
    zero = (0,) * len(assembly.wrench)
    for start in (zero, assembly.wrench):
        for direction in (assembly.wrench, tuple(-w for w in assembly.wrench)):
            rows = stickslip.class_margin(assembly, direction, start)
            said = program("margin", path, "--class", "--wrench", words(start), "--direction", words(direction))["multiples"]
            below, above, *stand = (None if x is None else Fraction(x) for x in (said["below"], said["above"], *(said["stand"] or ())))
            ends = {Fraction(0), *(x + d for x in (below, above, *stand) if x is not None for d in (-HALF / 50, 0, HALF / 50))}
            for at in sorted(x for x in ends if x >= 0):
                moves = said["always_moves"] or (below is not None and at < below) or (above is not None and at > above)
                stands = bool(stand) and (stand[0] is None or stand[0] <= at) and (stand[1] is None or at <= stand[1])
                assert class_at(rows, at) == ("must move" if moves else "may stand" if stands else None)
    rows = stickslip.friction_margin(assembly)
    said = program("margin", path, "--class", "--friction")["least_friction"]
    low, high = (Fraction(said[end]) for end in ("low", "high"))
    for at, kind in ((low, "must move" if low > 0 else None if high > 0 else "may stand"), (high, "may stand"), (high + 1, "may stand")):
        assert class_at(rows, at) == kind
    assert high <= low + Fraction(1, 1000000)


def test_classes_of_statics_have_closed_forms():
    for in_space in (False, True):
        assembly = pushed(["low", "up"], in_space)
        push = [0] * len(assembly.wrench)
        push[assembly.coordinates.index("up.x")] = 1
        load = [w if not p else 0 for w, p in zip(assembly.wrench, push)]
        found = stickslip.class_margin(assembly, push, load)
        assert [row.load_class for row in found if row.load_class] == ["may stand", "must move"]
        assert found[0].low == 0 and abs(found[0].high - HALF) < Fraction(1, 1000) and found[-1].high is None
        assert abs(stickslip.friction_margin(assembly)[-1].low - HALF) < Fraction(1, 1000000)
        [alone] = stickslip.friction_margin(assembly, [0] * len(push))
        assert (alone.load_class, alone.low, alone.high, alone.has_low) == ("may stand", 0, None, True)
        lifted = [1 if name.endswith(".z" if in_space else ".y") else 0 for name in assembly.coordinates]
        for rows in (stickslip.friction_margin(assembly, lifted), stickslip.class_margin(assembly, lifted, lifted)):
            assert [(row.load_class, row.low, row.high) for row in rows] == [("must move", 0, None)]


def test_a_box_is_drawn_in_the_middle():
    box = decide(blocks(), uncertain="friction=1%")
    assert "in the middle of a box" in box.plot()[:] and box._repr_svg_() == box.plot()


def test_a_page(tmp_path):
    page = Assembly.from_file(HAND).page(tmp_path / "hand.html", time_limit=0.5)
    found = re.search(r'id="answer">(.*?)</script>', (tmp_path / "hand.html").read_text(), re.DOTALL)
    answer = json.loads(found[1])
    assert answer["decide"]["verdict"] == "stable" and len(answer["mechanism"]["bodies"]) == 7
    assert page == (tmp_path / "hand.html").read_text()
