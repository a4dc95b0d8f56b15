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
from conftest import ROOT
from stickslip import Assembly, Grasp, InputError, decide

EXAMPLES = ROOT / "examples" / "grasps"


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
    lambda a: stickslip.class_margin(a, (0, 1, 0)),
    lambda a: stickslip.friction_margin(a),
    lambda a: a.snap(),
])
def test_what_is_for_one_body(ask):
    for assembly in (blocks(), Assembly.from_file(HAND)):
        with pytest.raises(InputError) as error:
            ask(assembly)
        assert error.value.problem == "the grasp has several bodies"


def test_a_box_is_drawn_in_the_middle():
    box = decide(blocks(), uncertain="friction=1%")
    assert "in the middle of a box" in box.plot()[:] and box._repr_svg_() == box.plot()


def test_a_page(tmp_path):
    page = Assembly.from_file(HAND).page(tmp_path / "hand.html", time_limit=0.5)
    found = re.search(r'id="answer">(.*?)</script>', (tmp_path / "hand.html").read_text(), re.DOTALL)
    answer = json.loads(found[1])
    assert answer["decide"]["verdict"] == "stable" and len(answer["mechanism"]["bodies"]) == 7
    assert page == (tmp_path / "hand.html").read_text()
