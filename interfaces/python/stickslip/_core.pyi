# SPDX-License-Identifier: GPL-3.0-or-later
# The compiled part. Its functions take checked arguments and return the fields of results.py.
from fractions import Fraction
from typing import Any, Dict, List, Optional, Tuple, Union

import numpy as np
from numpy.typing import NDArray

version: str

def exact(value: Any, place: str) -> Fraction: ...
def readable(value: Fraction) -> str: ...
def readable_root(square: Fraction) -> str: ...

class GraspData:
    def __init__(
        self,
        positions: List[List[Any]],
        normals: List[List[Any]],
        friction: Any,
        stiffness: Any,
        preload: Any,
        wrench: List[Any],
        name: str,
        assumed_stiffness: bool,
        cases: List[Tuple[str, List[Any]]],
        units: List[str],
        outline: List[List[List[Any]]],
    ) -> None: ...
    def text(self) -> str: ...
    def with_friction(self, friction: Any) -> GraspData: ...
    def size(self) -> int: ...
    def name(self) -> str: ...
    def positions(self) -> Tuple[Tuple[Fraction, Fraction], ...]: ...
    def normals(self) -> Tuple[Tuple[Fraction, Fraction], ...]: ...
    def friction(self) -> Tuple[Fraction, ...]: ...
    def stiffness(self) -> Tuple[Fraction, ...]: ...
    def preload(self) -> Tuple[Fraction, ...]: ...
    def wrench(self) -> Tuple[Fraction, Fraction, Fraction]: ...
    def outline(self) -> Tuple[Tuple[Tuple[Tuple[Fraction, Fraction], ...], ...], ...]: ...
    def units(self) -> Dict[str, str]: ...
    def cases(self) -> Dict[str, Tuple[Fraction, Fraction, Fraction]]: ...
    def snap(
        self, within: Any
    ) -> Tuple[GraspData, Tuple[Tuple[int, Tuple[Fraction, Fraction], str], ...]]: ...

class SpatialGraspData:
    def __init__(
        self,
        positions: List[List[Any]],
        normals: List[List[Any]],
        friction: Any,
        stiffness: Any,
        preload: Any,
        wrench: List[Any],
        name: str,
        assumed_stiffness: bool,
        cases: List[Tuple[str, List[Any]]],
        units: List[str],
        body: Optional[Tuple[List[List[Any]], List[List[int]]]],
    ) -> None: ...
    def text(self) -> str: ...
    def with_friction(self, friction: Any) -> SpatialGraspData: ...
    def size(self) -> int: ...
    def name(self) -> str: ...
    def positions(self) -> Tuple[Tuple[Fraction, ...], ...]: ...
    def normals(self) -> Tuple[Tuple[Fraction, ...], ...]: ...
    def friction(self) -> Tuple[Fraction, ...]: ...
    def stiffness(self) -> Tuple[Fraction, ...]: ...
    def preload(self) -> Tuple[Fraction, ...]: ...
    def wrench(self) -> Tuple[Fraction, ...]: ...
    def body(self) -> Optional[Tuple[Tuple[Tuple[Fraction, ...], ...], Tuple[Tuple[int, ...], ...]]]: ...
    def units(self) -> Dict[str, str]: ...
    def cases(self) -> Dict[str, Tuple[Fraction, ...]]: ...
    def snap(
        self, within: Any
    ) -> Tuple[SpatialGraspData, Tuple[Tuple[int, Tuple[Fraction, ...], str], ...]]: ...

class BodiesData(SpatialGraspData):
    def in_space(self) -> bool: ...
    def bodies(self) -> Tuple[str, ...]: ...
    def coordinates(self) -> Tuple[str, ...]: ...
    def springs(self) -> Tuple[str, ...]: ...
    def pairs(self) -> Tuple[Tuple[str, str], ...]: ...

def parse_grasp(text: bytes, name: bytes) -> Union[GraspData, SpatialGraspData]: ...

class DecisionsData:
    def size(self) -> int: ...
    def at(self, i: int) -> Tuple[Union[GraspData, SpatialGraspData], Dict[str, Any]]: ...
    def verdicts(self) -> List[str]: ...
    def engines(self) -> List[str]: ...
    def limits(self) -> List[str]: ...
    def wrenches(self) -> NDArray[np.float64]: ...
    def twists(self) -> NDArray[np.float64]: ...
    def forces(self) -> NDArray[np.float64]: ...

def decide(
    grasp: Union[GraspData, SpatialGraspData],
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    engine: str,
    node_limit: int,
    warnings: bool,
    max_motion: str,
) -> Dict[str, Any]: ...
def decide_box(
    grasp: Union[GraspData, SpatialGraspData],
    uncertain: str,
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    node_limit: int,
    max_motion: str,
) -> Dict[str, Any]: ...
def quality(
    grasp: Union[GraspData, SpatialGraspData],
    length: Any,
    about: Optional[List[Any]],
    body: str,
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    at_most: Any,
    accuracy: Any,
    node_limit: int,
    max_motion: str,
) -> Dict[str, Any]: ...
def radius(
    grasp: Union[GraspData, SpatialGraspData],
    uncertain: str,
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    accuracy: Any,
    node_limit: int,
    max_motion: str,
) -> Dict[str, Any]: ...
def best_preload(
    grasp: Union[GraspData, SpatialGraspData],
    loads: List[Optional[List[Any]]],
    budget: Any,
    uncertain: str,
    length: Any,
    about: List[Any],
    body: str,
    balanced: bool,
    bilateral: bool,
    accuracy: Any,
    boxes: int,
    node_limit: int,
    max_motion: str,
) -> Dict[str, Any]: ...
def stability_map(
    grasp: Union[GraspData, SpatialGraspData],
    x: str,
    y: str,
    uncertain: str,
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    depth: int,
    node_limit: int,
    proofs: bool,
    max_motion: str,
) -> Dict[str, Any]: ...
def decide_many(
    count: int,
    grasps: Union[List[GraspData], List[SpatialGraspData]],
    wrenches: List[List[Any]],
    frictions: List[Any],
    preloads: List[Any],
    bilateral: bool,
    engine: str,
    node_limit: int,
    threads: int,
) -> DecisionsData: ...
def region(
    grasp: GraspData,
    origin: List[Any],
    u: List[Any],
    v: List[Any],
    preload: Any,
    bilateral: bool,
    mode_limit: int,
    pieces: bool,
    certificate: bool,
    node_limit: int,
    picture: bool,
) -> Any: ...
def plot_grasp(
    grasp: Union[GraspData, SpatialGraspData, BodiesData],
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    engine: str,
    limit: Optional[str],
) -> str: ...
def compare(
    grasp: Union[GraspData, SpatialGraspData],
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    methods: List[str],
    length: Any,
    inertia: Optional[List[Any]],
    certificate: bool,
    max_motion: str,
) -> Dict[str, Any]: ...
def class_margin(
    grasp: GraspData,
    direction: List[Any],
    wrench: Optional[List[Any]],
    inertia: List[Any],
) -> Union[str, Tuple[Tuple[str, Fraction, Optional[Fraction], bool, bool], ...]]: ...
def friction_margin(
    grasp: GraspData,
    wrench: Optional[List[Any]],
    inertia: List[Any],
    accuracy: Any,
) -> Tuple[Tuple[Optional[str], Fraction, Optional[Fraction], bool, bool], ...]: ...
def plot_states(grasp: GraspData) -> str: ...
def page(
    grasp: Union[GraspData, SpatialGraspData, BodiesData],
    wrench: str,
    case: str,
    preload: str,
    bilateral: bool,
    uncertain: str,
    node_limit: int,
    time_limit: float,
) -> str: ...
def smtlib(
    grasp: Union[GraspData, SpatialGraspData],
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
) -> str: ...
def slip_states(grasp: GraspData, engine: str, list_states: bool, threads: int) -> Dict[str, Any]: ...
def margin(
    grasp: Union[GraspData, SpatialGraspData],
    direction: Optional[List[Any]],
    wrench: Optional[List[Any]],
    preload: Any,
    preload_direction: Union[str, List[Any], None],
    bilateral: bool,
    node_limit: int,
    warnings: bool,
    accuracy: Any,
    max_motion: str,
) -> Dict[str, Any]: ...
def crosscheck(
    grasp: Union[GraspData, SpatialGraspData],
    stable: bool,
    twist: Optional[List[Any]],
    forces: Optional[List[List[Any]]],
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    tie: Any,
    tolerance: Any,
    node_limit: int,
    distances: bool,
) -> Dict[str, Any]: ...
def check(
    grasp: bytes,
    certificate: bytes,
    wrench: Optional[List[Any]],
    preload: Any,
    bilateral: bool,
    direction: Optional[List[Any]],
    preload_direction: Union[str, List[Any], None],
    plane: Optional[List[List[Any]]],
    inertia: Optional[List[Any]],
    uncertain: str,
    max_motion: str,
    grasp_name: bytes,
    certificate_name: bytes,
) -> Dict[str, Any]: ...

class BatchTally:
    def __init__(self) -> None: ...
    @property
    def results(self) -> int: ...
    @property
    def undecided(self) -> int: ...
    @property
    def unreadable(self) -> int: ...
    def add(self, later: BatchTally) -> None: ...
    def count_unreadable(self, line: int) -> None: ...
    def complaint(self, name: str) -> str: ...

class LineDecider:
    def __init__(
        self,
        wrench: str,
        case: str,
        preload: str,
        bilateral: bool,
        node_limit: int,
        asks_class: bool,
        inertia: str,
        certificates: str,
        certificate_folder: str,
        quality: Optional[Tuple[str, str, str, str, str]],
    ) -> None: ...
    def decide(
        self, file: str, begin: int, end: int, lines_before: int
    ) -> Tuple[bytes, BatchTally]: ...
    def failed(
        self, file: str, begin: int, number: int, problem: str, remedy: str
    ) -> bytes: ...
    def skip(self, file: str, output: str) -> Tuple[BatchTally, int, int, int, str]: ...

def open_certificate_folder(folder: str, resume: bool) -> None: ...
