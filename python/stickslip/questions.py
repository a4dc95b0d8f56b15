# SPDX-License-Identifier: GPL-3.0-or-later
"""What can be asked about a grasp. Every answer is exact.

Long work runs without Python's global lock, so that other threads go on. Ctrl-C takes effect
when the call returns; ``node_limit`` bounds it.
"""

from __future__ import annotations

import os
from typing import Any, Union

from . import _core
from .arguments import (
    as_content,
    as_count,
    as_direction_or_none,
    as_json,
    as_list,
    as_number,
    as_number_or_none,
    as_preload_direction_or_none,
    as_wrench_or_none,
    found,
    is_bilateral,
    one_of,
)
from .errors import InputError, LimitReached
from .grasp import Grasp
from .results import (
    CheckResult,
    CrossCheck,
    Decision,
    Margin,
    ModelWarning,
    NearbyEquilibrium,
    Residual,
    SlipStates,
)


def decide(
    grasp: Grasp,
    wrench: Any = None,
    *,
    preload: Any = None,
    normal_law: str = "unilateral",
    engine: str = "auto",
    node_limit: int = 0,
    warnings: bool = False,
) -> Decision:
    """Will the grasp hold its load passively? A verdict, with evidence.

    Args:
        grasp: what is asked about.
        wrench: (3,), force x, force y and torque about the origin, applied to the body; the
            grasp's own if None.
        preload: of every contact; the grasp's own if None.
        normal_law: "unilateral", contacts may open, c_n = max(0, P - k N.d); or "bilateral", the
            paper's Eq. 4 literally, c_n = P - k N.d >= 0.
        engine: "states" solves the system of every slip state, "cone" is a branch and bound for
            many contacts, "auto" takes the one that suits. All are exact.
        node_limit: let the engine "cone" give up, undecided, after so many nodes; 0 is no limit.
        warnings: look for traps of the model as well, such as a large motion, or a preload that
            does not balance (docs/model.md). Takes longer than most verdicts.

    Raises:
        InputError: an argument is wrong, or a preloaded contact has a normal of irrational
            length (``Grasp.snap``).
    """
    result = _core.decide(
        _data(grasp),
        as_wrench_or_none(wrench),
        as_number_or_none(preload, "preload"),
        is_bilateral(normal_law),
        one_of("engine", engine, ("auto", "states", "cone")),
        as_count("node_limit", node_limit),
        bool(warnings),
    )
    result["warnings"] = tuple(ModelWarning(*w) for w in result["warnings"])
    return Decision(**result)


def slip_states(
    grasp: Grasp, *, engine: str = "auto", list_states: bool = True, threads: int = 0
) -> SlipStates:
    """The slip states consistent with rigid motion, and counts of cells.

    Args:
        grasp: its positions and normals matter, nothing else.
        engine: "cgal", CGAL's arrangement on the sphere, the reference; "sweep", for many
            contacts; "paper", the paper's own three steps, a baseline; "auto".
        list_states: list the states. There are O(m^2) of m characters each: beyond a few hundred
            contacts ask for counts alone.
        threads: of the counts of "sweep"; 0 is one a core.
    """
    engine = one_of("engine", engine, ("auto", "cgal", "sweep", "paper"))
    threads = as_count("threads", threads, 1024)
    return SlipStates(**_core.slip_states(_data(grasp), engine, bool(list_states), threads))


def margin(
    grasp: Grasp,
    direction: Any = None,
    wrench: Any = None,
    *,
    preload: Any = None,
    preload_direction: Any = None,
    normal_law: str = "unilateral",
    node_limit: int = 0,
    warnings: bool = False,
) -> Margin:
    """Which multiples l >= 0 of a load, or of preloads, are resisted?

    The set is a finite union of closed intervals with rational ends; the last may have no end.

    Args:
        grasp: what is asked about.
        direction: (3,), the load grows as wrench + l direction.
        wrench: what the load starts from. If None it is 0 with a ``direction``, whatever the
            grasp's own, and without one the grasp's own.
        preload: of every contact; the grasp's own if None.
        preload_direction: how preloads grow: "scale", all in proportion, l times what they are;
            or (m,), one number of 0 or more for each contact: by l times these, from what they
            are. ``least`` of the answer is then the least preload that holds the load.
        normal_law: as in ``decide``.
        node_limit: give up after so many nodes; 0 is no limit.
        warnings: look for traps of the model as well, as ``decide`` does.

    Raises:
        InputError: an argument is wrong; nothing grows.
        LimitReached: at ``node_limit``.
    """
    data = _data(grasp)
    if direction is None and preload_direction is None:
        raise InputError("", "direction", "nothing grows",
                         "give a direction such as (0, 1, 0), or a preload_direction")
    result = _core.margin(
        data,
        as_direction_or_none(direction),
        as_wrench_or_none(wrench),
        as_number_or_none(preload, "preload"),
        as_preload_direction_or_none(preload_direction),
        is_bilateral(normal_law),
        as_count("node_limit", node_limit),
        bool(warnings),
    )
    if "limit" in result:
        raise LimitReached(result["limit"])
    result["warnings"] = tuple(ModelWarning(*w) for w in result["warnings"])
    return Margin(**result)


def crosscheck(
    grasp: Grasp,
    verdict: str,
    *,
    twist: Any = None,
    forces: Any = None,
    wrench: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    tie: Any = "1e-9",
    tolerance: Any = "1e-6",
    node_limit: int = 0,
    distances: bool = False,
) -> CrossCheck:
    """Is another program's answer right, wrong, or a tie that only exact arithmetic can see?

    Args:
        grasp: what was asked about, as are ``wrench``, ``preload`` and ``normal_law``.
        verdict: the claim, "stable" or "unstable".
        twist: (3,), the claimed motion (x, y, r), if there is one.
        forces: (m, 2), the claimed forces of the contacts on the body, in its frame.
        tie: a wrong verdict is a tie if a relative change of the load by this much mends it.
        tolerance: residuals up to this fraction of the forces and motions at hand count as none.
        node_limit: for the verdict and for each margin; 0 is no limit.
        distances: find the distance to the threshold for right claims as well.
    """
    data = _data(grasp)
    fields = _core.crosscheck(
        data,
        one_of("verdict", verdict, ("stable", "unstable")) == "stable",
        None if twist is None else as_list(twist, "twist", (3,), "motion x, y and rotation r"),
        None if forces is None
        else as_list(forces, "forces", (data.size(), 2), "one vector for each contact"),
        as_wrench_or_none(wrench),
        as_number_or_none(preload, "preload"),
        is_bilateral(normal_law),
        as_number(tie, "tie"),
        as_number(tolerance, "tolerance"),
        as_count("node_limit", node_limit),
        distances,
    )
    fields["decision"] = Decision(**fields["decision"])
    for name in ("cone", "normal_law", "dissipation"):
        if fields[name] is not None:
            fields[name] = Residual(*fields[name])
    if "nearby" in fields:
        fields["nearby"] = NearbyEquilibrium(**fields["nearby"])
    return CrossCheck(**fields)


def check(
    grasp: Union[Grasp, os.PathLike[str]],
    certificate: Union[str, os.PathLike[str]],
    *,
    wrench: Any = None,
    preload: Any = None,
    normal_law: str = "unilateral",
    direction: Any = None,
    preload_direction: Any = None,
) -> CheckResult:
    """Does the certificate prove its verdict about this question?

    The checker shares no code with the engines; it believes nothing in the certificate
    (docs/prove.md). Give the same question as to ``decide``.

    Args:
        grasp: a grasp, or the path of its file, which the checker then reads itself.
        certificate: its text, or the path of a file, as a ``pathlib.Path``.
        direction: of a margin, whose certificate this then is; the wrench is then 0 unless given.
        preload_direction: of a margin, as for ``margin``.

    Raises:
        InputError: the grasp or the certificate cannot be read, or the question not be asked.
    """
    if isinstance(grasp, Grasp):
        grasp_bytes, grasp_name = grasp.to_text().encode(), b"<grasp>"
    else:
        grasp_bytes, grasp_name = as_content(
            grasp, "grasp", "give a stickslip.Grasp, or the path of its file")
    remedy = "give its text as a str, or the path of its file as a pathlib.Path"
    if isinstance(certificate, str):
        certificate_bytes, name = as_json(certificate, "certificate", remedy), b"<certificate>"
    else:
        certificate_bytes, name = as_content(certificate, "certificate", remedy)
    return CheckResult(**_core.check(
        grasp_bytes,
        certificate_bytes,
        as_wrench_or_none(wrench),
        as_number_or_none(preload, "preload"),
        is_bilateral(normal_law),
        as_direction_or_none(direction),
        as_preload_direction_or_none(preload_direction),
        grasp_name,
        name,
    ))


def _data(grasp: Grasp) -> _core.GraspData:
    if not isinstance(grasp, Grasp):
        raise InputError("", "grasp", f"this is {found(grasp)}",
                         "give a stickslip.Grasp; Grasp.from_file reads one")
    return grasp._data
