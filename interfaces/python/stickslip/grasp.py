# SPDX-License-Identifier: GPL-3.0-or-later
"""Grasps from arrays and files."""

from __future__ import annotations

import json
import os
from fractions import Fraction
from types import MappingProxyType
from typing import (
    Any,
    List,
    Mapping,
    NamedTuple,
    NoReturn,
    Optional,
    Sequence,
    Tuple,
    Type,
    TypeVar,
    Union,
    cast,
)

import numpy as np
from numpy.typing import ArrayLike

from . import _core, blocks, compas
from .arguments import (
    AXES,
    WRENCHES,
    as_case_name,
    as_content,
    as_count,
    as_file,
    as_json,
    as_list,
    as_number,
    as_numbers,
    as_outline,
    as_row_or_none,
    as_rows,
    as_text,
    as_uncertain,
    as_units,
    as_wrench,
    coordinates_of,
    found,
    is_bilateral,
)
from .contacts import Contacts, from_arrays, on_grid
from .errors import InputError
from .mesh import Mesh, as_body
from .outline import has_doubles, place, polygons_of, unit_if_rational
from .simulators import from_drake, from_mujoco, weight_of
from .views import FloatArray, FloatView, Page, call_of, nearest_root, shown

SNAPPED_WITHIN = blocks.SNAPPED_WITHIN

Rows = Union[ArrayLike, Sequence[Sequence[Any]]]
Pair = Tuple[Fraction, Fraction]
Triple = Tuple[Fraction, Fraction, Fraction]

Vector = Tuple[Fraction, ...]
"""Of 2 numbers in the plane and 3 in space; a wrench or a motion of 3 and 6, or of several bodies
one for each of ``Assembly.coordinates``."""

AnyGrasp = TypeVar("AnyGrasp", bound="Grasp")


class Grasp:
    """A body held by frictional point contacts, and the wrench applied to it. Immutable.

    It is planar, or in space if its positions have three coordinates (docs/space.md).

    Args:
        positions: (m, 2) or (m, 3), the contacts in the frame of the body.
        normals: of the same shape, not zero, pointing *into* the body, of any length.
        friction: coefficient of friction, >= 0; one number or (m,), as are the next two.
        stiffness: of the normal springs, force per length, > 0; 1 if None.
        preload: normal force before the wrench is applied, >= 0.
        wrench: (3,), force x, force y and torque about the origin, applied *to* the body; in
            space (6,), force x, y, z and torque x, y, z; ``wrench_of`` sums forces at points
            and weights. If None every question gives its own.
        name: for people.
        cases: named loads, each a question of its own: a mapping of names to wrenches, each
            the whole load. ``decide(grasp, grasp.cases[name])`` asks about one.
        outline: of a planar body, for pictures: a list of polygons, each a list of rings (the outer
            one, then holes), each (n, 2); or one polygon, or one ring.
        units: names for people, {"length": "mm", "force": "N"}. Nothing is converted.
        body: of a body in space, for pictures: a mesh, vertices (n, 3) and faces, each of three or more
            vertices; a pair, or an object with ``vertices`` and ``faces``.

    Numbers are taken exactly: a float as the dyadic rational that it is (0.1 is not 1/10), an
    int, a Fraction, a Decimal, and a string as it spells ("1/10", "0.1", "1e-3"). Arrays may mix
    them with dtype=object.

    Raises:
        InputError: a wrong shape, an entry that is no finite number, or a value out of range.

    >>> grasp = Grasp([[-1, 0], [0, -1], [1, 0]], [[1, 0], [0, 1], [-1, 0]], "1/2", preload=1)
    >>> grasp.friction[0]
    Fraction(1, 2)
    """

    __slots__ = ("_data", "_doubles", "_loaded")
    _data: Union[_core.GraspData, _core.SpatialGraspData]
    _doubles: bool  # whether there are floats among the normals
    _loaded: bool  # whether somebody gave a load, be it 0

    def __init__(
        self,
        positions: Rows,
        normals: Rows,
        friction: Any,
        stiffness: Any = None,
        preload: Any = 0,
        *,
        wrench: Any = None,
        name: str = "",
        cases: Mapping[str, Any] = MappingProxyType({}),
        outline: Any = (),
        units: Mapping[str, str] = MappingProxyType({}),
        body: Any = None,
    ) -> None:
        n = coordinates_of(positions, wrench)
        rows = as_rows(positions, n)
        m = len(rows)
        directions = as_list(normals, "normals", (m, n),
                             f"one row {AXES[n]} for each row of positions")
        polygons = as_outline(outline)
        if n == 3 and polygons:
            raise InputError("", "outline", "an outline, but the grasp is in space", "leave it out")
        if n == 2 and body is not None:
            raise InputError("", "body", "a body in space, but the grasp is in the plane",
                             "give its outline")
        arguments = (
            rows,
            directions,
            as_numbers(friction, "friction", m),
            as_numbers(1 if stiffness is None else stiffness, "stiffness", m),
            as_numbers(preload, "preload", m),
            as_wrench([0] * (3 * n - 3) if wrench is None else wrench, "wrench", n),
            as_text(name, "name"),
            stiffness is None,
            [(as_case_name(case), as_wrench(load, f"cases[{case!r}]", n))
             for case, load in cases.items()],
            as_units(units),
        )
        data = (_core.SpatialGraspData(*arguments, as_body(body)) if n == 3
                else _core.GraspData(*arguments, polygons))
        object.__setattr__(self, "_data", data)
        object.__setattr__(self, "_doubles", any(
            isinstance(entry, (float, np.floating)) for row in directions for entry in row))
        object.__setattr__(self, "_loaded", wrench is not None or len(cases) > 0)

    @classmethod
    def from_outline(
        cls,
        outline: Any,
        points: Rows,
        friction: Any,
        stiffness: Any = None,
        preload: Any = 0,
        *,
        tolerance: Any = None,
        wrench: Any = None,
        name: str = "",
    ) -> PlacedGrasp:
        """The body with this outline, held at these points of it; normals are those of the edges.

        Args:
            outline: the corners of a polygon, (n, 2), in either sense; a list of rings, the outer
                one first and then holes; a list of such lists; or a (multi)polygon of shapely.
            points: (m, 2), on the outline.
            tolerance: move points that are not on the outline to the nearest place on it, but
                none further than this.
            friction, stiffness, preload, wrench, name: as of a Grasp.

        Raises:
            InputError: as Grasp; a point that is off the outline, or nearest to a corner of it.

        >>> plate = [[0, 0], [4, 0], [4, 3], [0, 3]]
        >>> Grasp.from_outline(plate, [[0, 1], [4, 2]], "1/2").grasp.normals[1]
        (Fraction(-1, 1), Fraction(0, 1))
        """
        polygons = polygons_of(outline)
        placed = place(polygons, points, tolerance)
        contacts = [(one.position, unit_if_rational(one.normal)) for one in placed]
        grasp = cls([position for position, _ in contacts], [normal for _, normal in contacts],
                    friction, stiffness, preload, wrench=wrench, name=name, outline=polygons)
        object.__setattr__(grasp, "_doubles", has_doubles(outline))
        return PlacedGrasp(grasp, tuple(nearest_root(one.squared_distance) for one in placed))

    @classmethod
    def from_mesh(
        cls,
        mesh: Any,
        points: Rows,
        friction: Any,
        stiffness: Any = None,
        preload: Any = 0,
        *,
        tolerance: Any = None,
        wrench: Any = None,
        name: str = "",
    ) -> MeshGrasp:
        """The body with this surface, held at these points of it; normals are those of the triangles.

        Which triangle is nearest to a point, and where, is found exactly. Where several are equally
        near, as on an edge, the first of them in ``faces`` counts. The mesh is the grasp's ``body``
        in pictures, unless it is larger than a grasp file holds (about 10,000 faces).

        Args:
            mesh: a pair, vertices (n, 3) and faces (m, 3), or an object with ``vertices`` and
                ``faces``, as of trimesh. It must be closed, and seen from outside the vertices of
                each face run counterclockwise.
            points: (k, 3), on the surface.
            tolerance: move points that are not on the surface to the nearest place on it, but
                none further than this.
            friction, stiffness, preload, wrench, name: as of a Grasp.

        Raises:
            InputError: as Grasp; a point that is off the surface; a mesh that is open, or inside out,
                with the face and the edge where it is.

        >>> corner = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]]
        >>> on = Grasp.from_mesh(corner, [["1/4", "1/4", 0], [1, 1, 1]], "1/2", tolerance=2)
        >>> on.grasp.normals, on.faces, on.moved
        (((Fraction(0, 1), Fraction(0, 1), Fraction(1, 1)), (Fraction(-1, 1), Fraction(-1, 1), Fraction(-1, 1))), (0, 3), (0.0, 1.1547005383792515))
        """
        surface = Mesh(mesh)
        placed = surface.place(points, tolerance)
        found = Contacts([one.position for one in placed], [one.normal for one in placed], friction,
                         stiffness, preload)
        return MeshGrasp(cls._of_contacts(found, wrench, name, surface.body()),
                         tuple(nearest_root(one.squared_distance) for one in placed),
                         tuple(one.face for one in placed))

    @classmethod
    def from_contacts(
        cls,
        positions: Any,
        normals: Any = None,
        friction: Any = None,
        *,
        into: Any = None,
        frames: Any = None,
        forces: Any = None,
        distance: Any = None,
        stiffness: Any = None,
        preload: Any = None,
        grid: Any = None,
        wrench: Any = None,
        name: str = "",
        units: Mapping[str, str] = MappingProxyType({}),
    ) -> Grasp:
        """Contacts as another program has them, in arrays or records (docs/contacts.md).

        Args:
            positions: (m, 2) or (m, 3); or records (mappings, objects or rows of a structured
                array) with ``position`` and, in place of the argument, any of ``normal``, ``frame``,
                ``friction``, ``into``, ``force``, ``distance``, ``stiffness``, ``preload``.
            normals: of the same shape.
            friction: one number or (m,), as are the next but ``into`` and ``frames``.
            into: which body normals point into, "body", the one that is held, or "other"; one, or
                one for each contact. It has no default: programs differ.
            frames: in place of normals, matrices (m, n, n) or (m, n n) whose first rows they are.
            forces: normal forces, not negative; with frames also rows, of which it is the first.
            distance: of the two surfaces, negative where they penetrate.
            stiffness: if None, forces over penetrations where both are given, else as of a Grasp.
            preload: if None, the forces, which are stiffness times penetration where those two are
                given, or 0.
            grid: round positions to multiples of this length; simulators know them no better than
                their penetrations. If None they are taken as they are.
            wrench, name, units: as of a Grasp.

        >>> Grasp.from_contacts([[-1, 0], [1, 0]], [[-1, 0], [1, 0]], "1/2", into="other",
        ...                     forces=[3, 3], distance=["-0.001", "-0.002"]).stiffness
        (Fraction(3000, 1), Fraction(1500, 1))
        """
        found = from_arrays({
            "positions": positions, "normals": normals, "friction": friction, "into": into,
            "frames": frames, "forces": forces, "distance": distance, "stiffness": stiffness,
            "preload": preload}, wrench)
        return cls(*on_grid(found, grid), wrench=wrench, name=name, units=units)

    @classmethod
    def from_mujoco(
        cls,
        model: Any,
        data: Any,
        body: Union[str, int],
        *,
        friction: Any = None,
        stiffness: Any = None,
        forces: Any = None,
        preload: Any = None,
        fixed: Any = (),
        gravity: Any = None,
        grid: Any = None,
        wrench: Any = None,
        name: str = "",
    ) -> Grasp:
        """The contacts of a body in a scene of MuJoCo, in the world's frame (docs/contacts.md).

        They are in the order of ``data.contact``, without those of other bodies and those within a
        margin that do not touch. Of the objects the attributes are read, and nothing is imported.

        Args:
            model, data: an MjModel, and an MjData after a step or mj_forward.
            body: its name or number; what is welded to it is part of it.
            friction: if None, that of the contacts, where it is the same in all directions.
            stiffness: if None, normal force over penetration.
            forces: normal forces if not those of ``data.efc_force``: (ncon,), or rows of which it is
                the first, as mj_contactForce gives them.
            preload: if None, the normal forces; one number or one for each contact of the grasp.
            fixed: bodies that can move and are taken as fixed, by name or number; True for all.
            gravity: adds the weight of the body to ``wrench``; an acceleration (3,), or True for
                that of the model.
            grid: as of ``from_contacts``.
            wrench: about the world's origin, as of a Grasp.

        Raises:
            InputError: what the model here does not say, each with a remedy: adhesion, friction
                that is anisotropic or against spinning, gaps, joints of the body, and others that
                move and are not ``fixed``.
        """
        found = from_mujoco(model, data, body, friction, stiffness, forces, preload, fixed)
        load: Any = wrench
        if gravity is not None and gravity is not False:
            load = weight_of(model, data, body, gravity)
            if wrench is not None:
                load = [a + _core.exact(b, f"wrench[{i}]")
                        for i, (a, b) in enumerate(zip(load, as_wrench(wrench, "wrench", 3)))]
        return cls._of_contacts(on_grid(found, grid), load, name)

    @classmethod
    def from_drake(
        cls,
        contacts: Any,
        body: Any,
        friction: Any,
        *,
        stiffness: Any = None,
        forces: Any = None,
        preload: Any = None,
        grid: Any = None,
        wrench: Any = None,
        name: str = "",
    ) -> Grasp:
        """The contacts of a body in a scene of Drake, in the world's frame (docs/contacts.md).

        Of the objects the attributes and methods are read, and nothing is imported. All other bodies
        are taken as fixed.

        Args:
            contacts: ContactResults, or a list of PointPairContactInfo or PenetrationAsPointPair.
            body: the BodyIndex of the body, or several that are welded; of PenetrationAsPointPair
                the GeometryIds of it.
            friction: one number, one for each of ``contacts``, or a function of a
                PenetrationAsPointPair.
            stiffness: if None, normal force over depth.
            forces: normal forces, one for each of ``contacts``, if not those of PointPairContactInfo.
                Without any, they are stiffness times depth.
            preload: if None, the normal forces; one number or one for each contact of the grasp.
            grid: as of ``from_contacts``.
            wrench: about the world's origin, as of a Grasp.
        """
        found = from_drake(contacts, body, friction, stiffness, forces, preload)
        return cls._of_contacts(on_grid(found, grid), wrench, name)

    @classmethod
    def _of_contacts(cls, found: Contacts, wrench: Any, name: str, body: Any = None) -> Grasp:
        """In space, also without contacts."""
        load = [0] * 6 if wrench is None else as_wrench(wrench, "wrench", 3)
        grasp = cls(*found, wrench=load, name=name, body=body)
        object.__setattr__(grasp, "_loaded", wrench is not None)
        return grasp

    @classmethod
    def gripper(
        cls,
        width: Any,
        force: Any,
        friction: Any,
        *,
        pad: Any = 0,
        stiffness: Any = None,
        wrench: Any = None,
        name: str = "",
    ) -> Grasp:
        """A body of this width between two parallel jaws, which close along x about the origin.

        Args:
            width: from jaw to jaw.
            force: with which each jaw presses before the wrench is applied.
            pad: length of a jaw along y; it touches the body at both ends, or in one point if 0.
            friction, stiffness, wrench, name: as of a Grasp.

        >>> Grasp.gripper(width=2, force=10, friction="1/2", pad=1).preload
        (Fraction(5, 1), Fraction(5, 1), Fraction(5, 1), Fraction(5, 1))
        """
        x, y, press = (_core.exact(as_number(value, argument), argument) / 2
                       for value, argument in ((width, "width"), (pad, "pad"), (force, "force")))
        for value, argument, least in ((x, "width", "above 0"), (y, "pad", "0 or more"),
                                       (press, "force", "0 or more")):
            if value < 0 or (value == 0 and argument == "width"):
                raise InputError("", argument, f"the value is {_core.readable(2 * value)}",
                                 f"give a number {least}")
        ends = [y, -y] if y != 0 else [y]
        positions = [(side * x, end) for side in (-1, 1) for end in ends]
        normals = [(-side, 0) for side in (-1, 1) for _ in ends]
        return cls(positions, normals, friction, stiffness, 2 * press / len(ends), wrench=wrench,
                   name=name)

    @classmethod
    def from_file(cls: Type[AnyGrasp], path: Union[str, os.PathLike[str]]) -> AnyGrasp:
        """Reads a grasp file (docs/grasp_file.md); of several bodies it is an ``Assembly``."""
        content, name = as_content(
            path, "path", "give the path of a grasp file; Grasp.from_text reads its text")
        return cls._read(content, name)

    @classmethod
    def from_text(cls: Type[AnyGrasp], text: str, name: str = "") -> AnyGrasp:
        """Reads the text of a grasp file. ``name`` stands for its name in errors."""
        content = as_json(text, "text", "give the text of a grasp file; Grasp.from_file reads one")
        return cls._read(content, as_text(name, "name").encode())

    @classmethod
    def _read(cls: Type[AnyGrasp], content: bytes, name: bytes) -> AnyGrasp:
        data = _core.parse_grasp(content, name)
        if issubclass(cls, Assembly) and not isinstance(data, _core.BodiesData):
            raise InputError(os.fsdecode(name), "format", "this is a grasp of one body",
                             'read it with stickslip.Grasp; several have "stickslip-grasp/3"')
        return cls._of(data)

    @classmethod
    def _of(cls: Type[AnyGrasp], data: Union[_core.GraspData, _core.SpatialGraspData],
            loaded: bool = True, doubles: bool = False) -> AnyGrasp:
        kind: Type[Grasp] = cls
        if isinstance(data, _core.BodiesData) and not issubclass(kind, Assembly):
            kind = Assembly
        grasp = cast(AnyGrasp, object.__new__(kind))
        object.__setattr__(grasp, "_data", data)
        object.__setattr__(grasp, "_loaded", loaded)
        object.__setattr__(grasp, "_doubles", doubles)
        return grasp

    def _load(self, wrench: Any, needed: bool = True) -> Optional[List[Any]]:
        """That a question is about, by this argument of it; None is the grasp's own."""
        if wrench is None and needed and not self._loaded:
            n, _ = self._components
            raise InputError("", "wrench", "the grasp has no load, and none is given",
                             f"give a wrench of {n} numbers, here or to Grasp; no load is {(0,) * n}")
        return as_row_or_none(wrench, "wrench", self._components)

    def _asked(self, preload: Any = None) -> Tuple[Grasp, Tuple[SnappedNormal, ...]]:
        """The grasp that a question with this preload is about, and what moved for that.

        Unit vectors in doubles are rounded as it is, so that where a preloaded contact needs a
        normal of rational length they are rounded to one unasked. Exact normals never are, and in
        space any will do.
        """
        if self.in_space:
            return self, ()
        preloaded = any(self.preload) if preload is None else preload != 0
        return self.snap(SNAPPED_WITHIN) if self._doubles and preloaded else (self, ())

    @property
    def _coordinates(self) -> int:
        return 3 if self.in_space else 2

    @property
    def _components(self) -> Tuple[int, str]:
        """Of a wrench: how many there are, and what they are."""
        return WRENCHES[self._coordinates]

    def _one_body(self) -> Union[_core.GraspData, _core.SpatialGraspData]:
        """What the questions that are about one body take."""
        return self._data

    def _planar(self) -> _core.GraspData:
        """What the questions that are about the plane alone take."""
        if isinstance(self._data, _core.SpatialGraspData):
            raise InputError("", "grasp", "the grasp is in space",
                             "this is done in the plane only; stickslip decide answers in space")
        return self._data

    def to_text(self) -> str:
        """The text of a grasp file. Equal grasps give equal texts, and reading gives the grasp;
        one without a load is written with, and equals one with, a wrench of 0."""
        return self._data.text()

    def page(
        self,
        path: Union[str, os.PathLike[str], None] = None,
        *,
        wrench: Any = None,
        case: str = "",
        preload: Any = None,
        normal_law: str = "unilateral",
        uncertain: Union[str, Mapping[str, Any], None] = None,
        node_limit: int = 0,
        time_limit: float = 30,
    ) -> Page:
        """A page to look at and to turn, as HTML, with the verdict and its proof (docs/page.md).

        It is written to ``path``, if there is one, and a notebook shows it.

        Args:
            wrench, preload, normal_law, uncertain: as of ``decide``.
            case: the case whose load is applied; of a grasp with cases the first, by default.
            node_limit: of each search, as of ``decide``.
            time_limit: in seconds; regions, margins, maps and methods that take longer are left out. 0 is
                no limit.
        """
        def exactly(value: Any, name: str) -> str:
            return str(_core.exact(as_number(value, name), name))

        about, _ = self._asked(None if preload is None else _core.exact(preload, "preload"))
        load = (None if case else self._load(wrench)) or []
        if not 0 <= time_limit <= 86400:
            raise InputError("", "time_limit", f"found {time_limit!r}", "give 0 to 86400 seconds")
        page = Page(_core.ask(about._data, "page", {
            "load": ",".join(exactly(w, f"wrench[{i}]") for i, w in enumerate(load)),
            "case": as_text(case, "case"),
            "preloads": "" if preload is None else exactly(preload, "preload"),
            "bilateral": is_bilateral(normal_law),
            "tolerances": "" if uncertain is None else as_uncertain(uncertain),
            "node_limit": as_count("node_limit", node_limit), "time_limit": float(time_limit)}))
        if path is not None:
            page.save(path)
        return page

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"a Grasp is immutable; make another one to change {name}")

    @property
    def in_space(self) -> bool:
        """Whether positions have three coordinates, and wrenches six."""
        return isinstance(self._data, _core.SpatialGraspData)

    @property
    def positions(self) -> Tuple[Vector, ...]:
        """m rows; ``positions_float`` is an array again."""
        return self._data.positions()

    @property
    def normals(self) -> Tuple[Vector, ...]:
        return self._data.normals()

    @property
    def friction(self) -> Tuple[Fraction, ...]:
        return self._data.friction()

    @property
    def stiffness(self) -> Tuple[Fraction, ...]:
        return self._data.stiffness()

    @property
    def preload(self) -> Tuple[Fraction, ...]:
        return self._data.preload()

    @property
    def wrench(self) -> Optional[Vector]:
        """None if nobody gave a load; with ``cases``, what is common to them."""
        return self._data.wrench() if self._loaded else None

    positions_float = FloatView[FloatArray]("positions", -1, 2)
    normals_float = FloatView[FloatArray]("normals", -1, 2)
    friction_float = FloatView[FloatArray]("friction")
    stiffness_float = FloatView[FloatArray]("stiffness")
    preload_float = FloatView[FloatArray]("preload")
    wrench_float = FloatView[Optional[FloatArray]]("wrench")

    @property
    def outline(self) -> Tuple[Tuple[Tuple[Pair, ...], ...], ...]:
        """Polygons of the body: each its outer ring, then those of holes. Empty if not given."""
        return () if isinstance(self._data, _core.SpatialGraspData) else self._data.outline()

    @property
    def body(self) -> Optional[Body]:
        """In space: vertices, and of each face the vertices that it has. None if not given."""
        if not isinstance(self._data, _core.SpatialGraspData):
            return None
        found = self._data.body()
        return None if found is None else Body(*found)

    @property
    def units(self) -> Mapping[str, str]:
        """Of "length" and "force"; empty if not given."""
        return MappingProxyType(self._data.units())

    @property
    def cases(self) -> Mapping[str, Vector]:
        """The whole load of each case of a grasp file, by name; empty if it has none."""
        return MappingProxyType(self._data.cases())

    @property
    def name(self) -> str:
        return self._data.name()

    def snap(self, within: Any = "1e-9") -> SnapResult:
        """The same grasp with rational unit normals, and how far each normal moved for that.

        In the plane a preloaded contact needs a normal of rational length, and so do margins with
        preload; unit vectors in floating point seldom have one. Each normal of irrational length
        is replaced by a rational unit vector at a distance of at most ``within``, between 0 and 1;
        the others stay as they are.
        """
        data, moved = self._data.snap(as_number(within, "within"))
        return SnapResult(Grasp._of(data, self._loaded),
                          tuple(SnappedNormal(*normal) for normal in moved))

    def __len__(self) -> int:
        """The number of contacts."""
        return self._data.size()

    def __bool__(self) -> bool:
        return True  # also without contacts

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Grasp):
            return NotImplemented
        return self.to_text() == other.to_text()

    def __hash__(self) -> int:
        return hash(self.to_text())

    def __reduce__(self) -> Tuple[Any, ...]:
        return _restored, (self._data, self._loaded, self._doubles)

    def __repr__(self) -> str:
        return call_of("Grasp", [("name", self.name), ("contacts", len(self)),
                                 ("wrench", self.wrench)])


def _restored(data: Union[_core.GraspData, _core.SpatialGraspData], loaded: bool,
              doubles: bool) -> Grasp:
    return Grasp._of(data, loaded, doubles)


class Assembly(Grasp):
    """Several bodies, with contacts between them, links, joints and springs (docs/bodies.md).

    ``decide`` (also of many at once, and ``uncertain``), ``margin``, ``radius``, ``stability_map`` and
    ``check`` take it as they take a Grasp, and in the plane ``plot_grasp``; all else is for one body,
    and says so. A wrench, a direction and a motion have one number for each of ``coordinates``. ``positions`` and the like
    are those of the contacts, in the frame that all bodies share.

    Args:
        content: what a grasp file of version 3 holds (docs/grasp_file.md, "Several bodies"), as
            ``json.load`` gives it, or with numbers of any type that a Grasp takes; ``format`` may be
            left out.

    >>> blocks = Assembly({
    ...     "bodies": [{"name": "low"}, {"name": "up"}],
    ...     "contacts": [{"of": "low", "position": [0, 0], "normal": [0, 1], "friction": 1},
    ...                  {"of": "up", "by": "low", "position": [0, 1], "normal": [0, 1], "friction": 1}],
    ...     "loads": [{"body": "up", "weight": 10, "at": [0, 2]}]})
    >>> blocks.coordinates
    ('low.x', 'low.y', 'low.turn', 'up.x', 'up.y', 'up.turn')
    """

    __slots__ = ()
    _data: _core.BodiesData

    def __init__(self, content: Mapping[str, Any]) -> None:
        if not isinstance(content, Mapping):
            raise InputError("", "content", f"this is {found(content)}",
                             "give a mapping; Assembly.from_file and from_text read a file")
        text = json.dumps({"format": "stickslip-grasp/3", **as_file(content)})
        read = Assembly.from_text(text)
        for name in Grasp.__slots__:
            object.__setattr__(self, name, getattr(read, name))

    @classmethod
    def from_compas(
        cls,
        source: Any,
        friction: Any,
        stiffness: Any = None,
        *,
        density: Any = 1,
        gravity: Any = (0, 0, -1),
        supports: Any = None,
        tolerance: Any = None,
        grid: Any = None,
        name: Optional[str] = None,
        units: Mapping[str, str] = MappingProxyType({}),
    ) -> Assembly:
        """Blocks and interfaces as compas_assembly and compas_cra write them (docs/bodies.md).

        Every corner of an interface is a contact, along the third axis of its frame, which leads out of
        the first block of the edge. All numbers are the doubles of the file, but that a normal of irrational length
        moves by at most 1e-12 to a rational unit vector.

        Args:
            source: the path of a file, or its content as ``json.load`` gives it.
            friction: of all contacts.
            stiffness: of all contacts; 1 if None. Statics needs none.
            density: where the file says none; or of blocks by their names, whatever the file says, and of all
                others that of the file, or 1. With the default gravity it is the weight of a unit of volume.
            gravity: the acceleration, along which blocks weigh volume times density times its length.
            supports: names of nodes that are the ground; if None those of which the file says is_support.
            tolerance: if the file has no interfaces, they are where faces lie on each other, as in ``from_meshes``.
            grid: round vertices and corners to multiples of this length. If None they are taken as they are.
            name, units: as of a Grasp; the name is that of the file if None.

        Raises:
            InputError: no such assembly; a block whose mesh is open and which is no support; no support.
        """
        step = None if grid is None else blocks.as_length(grid, "grid", "above 0")
        read = compas.load(source, step)
        names = list(read.blocks)
        ground = read.supports if supports is None else blocks.as_supports(supports, names)
        if supports is None and not ground:
            raise InputError("", "supports", "no node of the file has is_support",
                             "name the blocks that are the ground: " + blocks.listed(names))
        interfaces: Sequence[blocks.Interface] = read.interfaces
        if not interfaces:
            if tolerance is None:
                raise InputError("", "tolerance", "the file has no interfaces",
                                 "give a tolerance within which faces of two blocks lie on each other, or find them there")
            interfaces = blocks.touching(read.blocks, blocks.as_length(tolerance, "tolerance"))
        elif tolerance is not None:
            raise InputError("", "tolerance", "the file has interfaces, which are taken", "leave it out")
        return cls(blocks.content_of(
            read.blocks, interfaces, ground, friction, stiffness, blocks.density_of(density, names, read.densities),
            gravity, read.name if name is None else as_text(name, "name"), units, True))

    @classmethod
    def from_meshes(
        cls,
        meshes: Any,
        friction: Any,
        stiffness: Any = None,
        *,
        tolerance: Any = 0,
        ground: Any = None,
        supports: Any = (),
        density: Any = 1,
        gravity: Any = (0, 0, -1),
        grid: Any = None,
        name: str = "",
        units: Mapping[str, str] = MappingProxyType({}),
    ) -> Assembly:
        """Blocks by their surfaces, with contacts where their faces lie on each other (docs/bodies.md).

        Triangles of a block that are in one plane are one face. Two faces of two blocks touch if they are
        opposed, within 1 degree, and where they overlap no farther apart than the tolerance; the contacts are the corners of the
        convex hull of what they have in common, on the face of the block that comes first. What is narrower than the tolerance
        does not count.

        Args:
            meshes: by the names of the blocks, each a pair, vertices (n, 3) and faces of three or more vertices, an object
                with ``vertices`` and ``faces``, or the path of an OBJ or STL file; or the path of one OBJ file, whose objects are
                the blocks.
            friction, stiffness: of all contacts.
            tolerance: a length, as above; 0 is for exact numbers.
            ground: the height z of a plane that is the ground, or None: faces that lie on it touch.
            supports: names of blocks that are the ground. Their surfaces may be open.
            density, gravity: as of ``from_compas``.
            grid: round vertices to multiples of this length. If None they are taken as they are.
            name, units: as of a Grasp.

        Raises:
            InputError: a file or a mesh that is wrong, with its place; a vertex that is under the ground; no faces that touch.

        >>> cube = [[x, y, z] for x in (0, 1) for y in (0, 1) for z in (0, 1)], [
        ...     [0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
        >>> one = Assembly.from_meshes({"cube": cube}, "1/2", ground=0)
        >>> one.wrench, len(one)
        ((Fraction(0, 1), Fraction(0, 1), Fraction(-1, 1), Fraction(-1, 2), Fraction(1, 2), Fraction(0, 1)), 4)
        """
        within = blocks.as_length(tolerance, "tolerance")
        step = None if grid is None else blocks.as_length(grid, "grid", "above 0")
        read = blocks.read_blocks(meshes, step)
        names = list(read)
        fixed = blocks.as_supports(supports, names)
        if ground is None and not fixed:
            raise InputError("", "ground", "nothing is the ground",
                             "give its height, as in ground=0, or name supports: " + blocks.listed(names))
        interfaces = blocks.touching(read, within)
        if ground is not None:
            height = _core.exact(as_number(ground, "ground"), "ground")
            free = {key: block for key, block in read.items() if key not in fixed}
            sunk = blocks.below(free, height, within)
            if sunk is not None:
                raise InputError("", f"meshes[{sunk!r}]", f"a vertex is under the ground at {_core.readable(height)}",
                                 "give the height of the ground, or a tolerance")
            interfaces += blocks.on_the_ground(free, height, within)
        if not interfaces:
            raise InputError("", "tolerance", "no faces touch",
                             "give a length within which faces lie on each other, in the units of the meshes")
        return cls(blocks.content_of(
            read, interfaces, fixed, friction, stiffness, blocks.density_of(density, names, {}), gravity,
            as_text(name, "name"), units, any(block.floats for block in read.values())))

    @property
    def bodies(self) -> Tuple[str, ...]:
        """Their names."""
        return self._data.bodies()

    @property
    def coordinates(self) -> Tuple[str, ...]:
        """The names of the numbers of a wrench and of a motion: three of each body that is no link,
        in space six, and one of each joint."""
        return self._data.coordinates()

    @property
    def contact_bodies(self) -> Tuple[Tuple[str, str], ...]:
        """Of each contact the body that is pressed, ``of``, and the one that presses, ``by``."""
        return self._data.pairs()

    @property
    def springs(self) -> Tuple[str, ...]:
        """Ratchets, then joints that have a spring, then tendons: their names, or places in the file."""
        return self._data.springs()

    @property
    def in_space(self) -> bool:
        return self._data.in_space()

    @property
    def _components(self) -> Tuple[int, str]:
        return len(self.coordinates), "a force or torque for each of " + ", ".join(self.coordinates)

    def _asked(self, preload: Any = None) -> Tuple[Grasp, Tuple[SnappedNormal, ...]]:
        return self, ()  # any lengths of normals will do

    def _one_body(self) -> NoReturn:
        raise InputError("", "grasp", "the grasp has several bodies",
                         "this is for one body only; decide, margin, radius, stability_map and page "
                         "answer for several")

    _planar = _one_body

    def snap(self, within: Any = "1e-9") -> NoReturn:
        """Not needed: normals of any length will do."""
        self._one_body()

    def __repr__(self) -> str:
        return call_of("Assembly", [("name", self.name), ("bodies", self.bodies),
                                    ("contacts", len(self)), ("springs", self.springs),
                                    ("wrench", self.wrench)])


class PlacedGrasp(NamedTuple):
    """A grasp on an outline, and how far each of its points moved onto it."""

    grasp: Grasp
    moved: Tuple[float, ...]


class Body(NamedTuple):
    """The surface of a body in space, which is drawn and part of no question."""

    vertices: Tuple[Vector, ...]
    faces: Tuple[Tuple[int, ...], ...]


class MeshGrasp(NamedTuple):
    """A grasp on a mesh, how far each of its points moved onto it, and on which face it is."""

    grasp: Grasp
    moved: Tuple[float, ...]
    faces: Tuple[int, ...]


class SnappedNormal(NamedTuple):
    """A contact whose normal was replaced by a rational unit vector."""

    contact: int
    normal: Vector
    moved_at_most: str  # a decimal, rounded up

    def __repr__(self) -> str:
        return f"SnappedNormal({self.contact}, {shown(self.normal)}, {self.moved_at_most!r})"


class SnapResult(NamedTuple):
    """A grasp with normals of rational length, and those that were replaced."""

    grasp: Grasp
    moved: Tuple[SnappedNormal, ...]
