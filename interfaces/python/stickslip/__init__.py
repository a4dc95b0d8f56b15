# SPDX-License-Identifier: GPL-3.0-or-later
"""Exact passive stability of frictional grasps, with proofs.

>>> import stickslip
>>> grasp = stickslip.Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2", preload=1)
>>> stickslip.decide(grasp, (0, 1, 0)).verdict
'stable'
>>> stickslip.margin(grasp, (0, 1, 0)).resisted
((Fraction(0, 1), Fraction(1, 1)),)

Arrays and numbers go in, ``fractions.Fraction`` comes out; no floating-point tolerance decides
anything. Normals point into the body, the tangent is the normal turned by +90 degrees, and the
wrench is the one applied to the body. See docs/python.md.
"""

from . import _core
from .errors import ContractError, InputError, LimitReached
from .grasp import Assembly, Body, Grasp, MeshGrasp, PlacedGrasp, SnappedNormal, SnapResult
from .loads import wrench_of
from .questions import (
    best_preload,
    check,
    class_margin,
    compare,
    crosscheck,
    decide,
    export,
    friction_margin,
    margin,
    plot_grasp,
    plot_region,
    plot_states,
    quality,
    radius,
    region,
    slip_states,
    stability_map,
    statics,
)
from .results import (
    BestPreload,
    BoxDecision,
    Cell,
    CheckResult,
    ClassRange,
    Comparison,
    CrossCheck,
    Decision,
    Decisions,
    MapCell,
    Margin,
    Method,
    ModelWarning,
    NearbyEquilibrium,
    Outline,
    Piece,
    Proof,
    Quality,
    Radius,
    Region,
    Residual,
    Samples,
    SlipStates,
    StabilityMap,
    StaticForce,
    StaticMultiples,
    Statics,
    Within,
)
from .states import NO_SIGN, StateCounts, States, StatesChunk, find_states
from .views import Page, Picture

__version__: str = _core.version

__all__ = [
    "Assembly",
    "BestPreload",
    "Body",
    "BoxDecision",
    "Cell",
    "CheckResult",
    "ClassRange",
    "Comparison",
    "ContractError",
    "CrossCheck",
    "Decision",
    "Decisions",
    "Grasp",
    "InputError",
    "LimitReached",
    "MapCell",
    "Margin",
    "MeshGrasp",
    "Method",
    "ModelWarning",
    "NO_SIGN",
    "NearbyEquilibrium",
    "Outline",
    "Page",
    "Picture",
    "Piece",
    "PlacedGrasp",
    "Proof",
    "Quality",
    "Radius",
    "Region",
    "Residual",
    "Samples",
    "SlipStates",
    "SnapResult",
    "SnappedNormal",
    "StabilityMap",
    "StateCounts",
    "States",
    "StatesChunk",
    "StaticForce",
    "StaticMultiples",
    "Statics",
    "Within",
    "best_preload",
    "check",
    "class_margin",
    "compare",
    "crosscheck",
    "decide",
    "export",
    "find_states",
    "friction_margin",
    "margin",
    "plot_grasp",
    "plot_region",
    "plot_states",
    "quality",
    "radius",
    "region",
    "slip_states",
    "stability_map",
    "statics",
    "wrench_of",
]
