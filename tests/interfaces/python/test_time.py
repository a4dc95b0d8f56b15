# SPDX-License-Identifier: GPL-3.0-or-later
"""time_limit: what is answered when the time is over is true, and says so. No test asserts a time: a limit of a millionth of a
second ends work where it first asks for the time. What the answers are worth is tested with the command."""

import pytest
import stickslip
from conftest import ROOT
from stickslip import Grasp, InputError, LimitReached

AT_ONCE = "0.000001"
OVER = "the time limit of 1e-6 s"


@pytest.fixture(name="cup")
def a_cup():
    return Grasp.from_file(ROOT / "examples" / "grasps" / "space-cup.json")


def test_a_verdict_is_undecided_for_the_true_reason(cup):
    box = stickslip.decide(cup, uncertain="normal=1/30,friction=5%,position=1/60", time_limit=AT_ONCE)
    assert (box.verdict, box.reason) == ("undecided", "time")
    assert stickslip.decide(cup, time_limit=1000).verdict == stickslip.decide(cup).verdict


def test_what_is_known_is_kept(cup, fig1):
    assert stickslip.quality(cup, time_limit=AT_ONCE).ended_by == OVER
    assert stickslip.margin(cup, (0, 0, -1, 0, 0, 0), time_limit=AT_ONCE).ended_by == OVER
    assert stickslip.quality(fig1, (0, "-1/2", 0), accuracy="1/2").ended_by is None
    rows = stickslip.compare(cup, time_limit=AT_ONCE).methods
    assert all(row.verdict == "not computed" and row.why.startswith(OVER) for row in rows)


def test_what_has_no_answer_on_its_way(fig1):
    for ask in (lambda: stickslip.region(fig1, time_limit=AT_ONCE), lambda: stickslip.margin(fig1, (0, 1, 0), time_limit=AT_ONCE)):
        with pytest.raises(LimitReached, match=OVER):
            ask()


@pytest.mark.parametrize("limit", [-1, 86401, "soon"])
def test_limits_that_are_none(cup, limit):
    with pytest.raises(InputError) as error:
        stickslip.decide(cup, time_limit=limit)
    assert error.value.place == "time_limit"
    with pytest.raises(InputError):
        stickslip.decide([cup, cup], time_limit=1)
