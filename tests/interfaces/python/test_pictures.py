# SPDX-License-Identifier: GPL-3.0-or-later
"""Regions, comparisons and pages as Python has them, and answers show themselves."""

import json
import os
import pickle
import re
import subprocess
import xml.etree.ElementTree as ElementTree
from fractions import Fraction

import numpy as np
import pytest
import stickslip
from stickslip import Grasp, InputError, LimitReached, Picture


def test_a_picture_is_a_text(tmp_path, fig1):
    picture = stickslip.plot_region(fig1)
    assert isinstance(picture, Picture)
    assert picture._repr_svg_() == picture[:] == f"{picture}" and type(picture[:]) is str
    assert repr(picture) == str(picture) == f"<Picture: SVG of {len(picture)} characters>"
    picture.save(tmp_path / "kept.svg")
    assert (tmp_path / "kept.svg").read_text(encoding="utf-8") == picture
    for protocol in range(pickle.HIGHEST_PROTOCOL + 1):
        again = pickle.loads(pickle.dumps(picture, protocol))
        assert again == picture and type(again) is Picture


def test_region_is_proved(tmp_path, fig1):
    region = stickslip.region(fig1, torque="1/2", certificate=True)
    answer = region.check()
    assert answer and answer.verdict == "region"
    assert region.areas[0][0].vertices_float.shape == (len(region.areas[0][0].vertices), 2)
    assert answer.wrench == (0, 0, Fraction(1, 2)) and answer.plane == ((1, 0, 0), (0, 1, 0))
    file = tmp_path / "grasp.json"
    file.write_text(fig1.to_text())
    for grasp in (fig1, file):
        assert stickslip.check(grasp, region.certificate, wrench=(0, 0, "1/2"),
                               plane=(region.u, region.v)) == answer
    other = stickslip.check(fig1, region.certificate, wrench=(0, 0, "1/2"),
                            plane=((1, 0, 0), (0, 0, 1)))
    assert (other.accepted, other.rule) == (False, "question-plane")
    with pytest.raises(InputError) as caught:
        stickslip.region(fig1).check()
    assert caught.value.place == "certificate"
    with pytest.raises(LimitReached):
        stickslip.region(fig1, certificate=True, node_limit=1)
    with pytest.raises(InputError) as caught:
        stickslip.check(fig1, region.certificate, plane=(1, 0, 0))
    assert caught.value.place == "plane[0]"


def test_region_errors(fig1):
    for options, place in (({"torque": 1, "origin": (1, 0, 0)}, "torque"),
                           ({"torque": "x"}, "origin[2]"), ({"u": (0, 1)}, "u"),
                           ({"u": (0, 2, 0)}, "plane"), ({"mode_limit": -1}, "mode_limit")):
        with pytest.raises(InputError) as caught:
            stickslip.region(fig1, **options)
        assert caught.value.place == place
    with pytest.raises(LimitReached):
        stickslip.region(fig1, mode_limit=1)
    with pytest.raises(LimitReached):
        stickslip.plot_region(fig1, mode_limit=1)


def test_a_comparison(fig1):
    comparison = stickslip.compare(fig1, (0, 0, 0))
    assert comparison["form closure"] in comparison.methods
    assert len(repr(comparison).splitlines()) == len(comparison.methods)
    ElementTree.fromstring(comparison._repr_html_())
    with pytest.raises(KeyError):
        comparison["best"]
    with pytest.raises(InputError, match="above 0"):
        stickslip.compare(fig1, (0, 0, 0), length=0)
    for wrong in ({"inertia": (0, 0)}, {"inertia": (0, 0, 0)}, {"methods": ["best"]}):
        with pytest.raises(InputError) as caught:
            stickslip.compare(fig1, (0, 0, 0), **wrong)
        assert caught.value.place in wrong


def test_answers_show_themselves(fig1):
    answers = [stickslip.decide(fig1, (0, 1, 0)), stickslip.decide(fig1, (0, 2, 0)),
               stickslip.slip_states(fig1), stickslip.region(fig1),
               stickslip.margin(fig1, (0, 1, 0)),
               stickslip.crosscheck(fig1, "stable", wrench=(0, 1, 0)),
               stickslip.decide(fig1, (0, 1, 0)).check()]
    for answer in answers:
        html = answer._repr_html_()
        page = ElementTree.fromstring(f"<div>{html}</div>")
        assert page.find("table") is not None
        svg = answer._repr_svg_()
        assert html.startswith(svg or "<table>") and "<Picture" not in html
        assert (svg is not None) == hasattr(answer, "plot")
        if svg is not None:
            assert svg == answer.plot()
    assert answers[0].plot() == stickslip.plot_grasp(fig1, (0, 1, 0))
    assert answers[3].plot() == stickslip.plot_region(fig1)


def test_what_cannot_be_drawn(fig1):
    undecided = stickslip.decide(fig1, (0, 2, 0), node_limit=1)
    assert undecided.verdict == "undecided" and "undecided" in undecided._repr_html_()
    with pytest.raises(LimitReached) as caught:
        undecided.check()
    assert str(caught.value) == "the answer is not known: the search reached the limit of 1 nodes"
    angles = np.linspace(0, 6, 101)
    many = np.round(1000 * np.column_stack([np.cos(angles), np.sin(angles)]))
    crowd = Grasp(many, -many, 1)
    assert stickslip.decide(crowd, (0, 0, 0))._repr_svg_() is None
    counts = stickslip.slip_states(crowd, list_states=False)
    assert counts._repr_svg_() is None and counts.states is None


def test_names_are_escaped():
    grasp = Grasp([[0, 0]], [[1, 0]], 1, name="<b> & \"c\"", wrench=(0, 0, 0))
    for answer in (stickslip.decide(grasp), stickslip.slip_states(grasp)):
        ElementTree.fromstring(f"<div>{answer._repr_html_()}</div>")


def answer_of(page):
    return json.loads(re.search(r'id="answer">(.*?)</script>', page, re.S)[1])


def test_pages_are_those_of_the_program(tmp_path, fig1):
    path = tmp_path / "page.html"
    page = fig1.page(path, wrench=(0, "1/2", 0), preload=2, time_limit=1000)
    assert isinstance(page, stickslip.Page) and path.read_text(encoding="utf-8") == page
    file = tmp_path / "grasp.json"
    file.write_text(fig1.to_text())
    expected = subprocess.run([os.environ["STICKSLIP"], "page", file, "--wrench", "0,1/2,0", "--preload", "2", "--time-limit", "1000"],
                              capture_output=True, text=True, check=True, timeout=300).stdout
    # A file of this grasp says every stiffness.
    found, expected = answer_of(page), answer_of(expected)
    for of_file, of_grasp in ((expected, found), (expected["lost"], found["lost"])):
        assert '"stiffness"' in of_file.pop("grasp") and '"stiffness"' not in of_grasp.pop("grasp")
    assert found == expected
    assert repr(page) == str(page) == f"<Page: HTML of {len(page)} characters>"
    assert 60 > len(repr(page)) and f"{page:.9}" == "<!DOCTYPE"
    assert page._repr_html_().count("<") == 2
    boxed = answer_of(fig1.page(wrench=(0, 0, 0), uncertain={"friction": "10%"}, normal_law="bilateral"))
    assert boxed["question"]["uncertain"] == "friction=10%" and boxed["decide"]["box"]
    for arguments, place in (({"wrench": (1, 2)}, "wrench"), ({"preload": -1}, "preload"), ({"case": "a"}, "case"),
                             ({"uncertain": "x=1"}, "uncertain"), ({"time_limit": -1}, "time_limit")):
        with pytest.raises(InputError) as error:
            fig1.page(**{"wrench": (0, 0, 0), **arguments})
        assert error.value.place == place
