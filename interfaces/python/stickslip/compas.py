# SPDX-License-Identifier: GPL-3.0-or-later
"""Assemblies as compas_assembly writes them, in the forms that its files have had."""

from __future__ import annotations

import ast
import json
import os
from fractions import Fraction
from typing import Any, Dict, Iterator, List, Mapping, NamedTuple, Optional, Tuple

from . import _core
from .arguments import as_content, found
from .blocks import GROUND, Block, Interface, rounded
from .contacts import cross
from .errors import InputError


class Read(NamedTuple):
    """What a file says."""

    blocks: Dict[str, Block]
    interfaces: List[Interface]
    supports: List[str]
    densities: Dict[str, Any]
    name: str


class _File:
    """What it is called in messages."""

    def __init__(self, name: str) -> None:
        self.name = name

    def error(self, place: str, problem: str, remedy: str) -> InputError:
        return InputError(self.name, place, problem, remedy)

    def mapping(self, value: Any, place: str, remedy: str) -> Mapping[str, Any]:
        plain = _plain(value)
        if not isinstance(plain, Mapping):
            raise self.error(place, f"this is {found(plain)}", remedy)
        return plain

    def vector(self, value: Any, place: str, grid: Optional[Fraction] = None) -> Tuple[Fraction, ...]:
        plain = _plain(value)
        if isinstance(plain, Mapping) and all(axis in plain for axis in "xyz"):
            plain = [plain[axis] for axis in "xyz"]
        if not isinstance(plain, (list, tuple)) or len(plain) != 3:
            raise self.error(place, f"this is {found(plain)}", "give three numbers x, y, z")
        try:
            return tuple(rounded(_core.exact(x, f"{place}[{i}]"), grid) for i, x in enumerate(plain))
        except InputError as error:
            raise self.error(error.place, error.problem, error.remedy) from None


def _plain(value: Any) -> Any:
    """Without the envelopes of a type and its data, of which there have been three kinds."""
    while isinstance(value, Mapping):
        inner = next((key for key in ("data", "value") if key in value and ("dtype" in value or "datatype" in value)), None)
        if inner is None:
            return value
        value = value[inner]
    return value


def _key(text: Any) -> str:
    """A node is written as Python writes it, so that one that is a word may have quotes."""
    try:
        return str(ast.literal_eval(str(text)))
    except (ValueError, SyntaxError):
        return str(text)


def _first(mapping: Mapping[str, Any], *keys: str) -> Any:
    return next((mapping[key] for key in keys if mapping.get(key) is not None), None)


def load(source: Any, grid: Optional[Fraction]) -> Read:
    """From a path, or from what ``json.load`` gives."""
    if isinstance(source, Mapping):
        return _read(source, _File(""), grid)
    content, name = as_content(source, "source", "give the path of a file of compas_assembly, or its content as a dict")
    file = _File(os.fsdecode(name))
    try:
        data = json.loads(content)
    except (ValueError, RecursionError) as error:
        place = f"{error.lineno}:{error.colno}" if isinstance(error, json.JSONDecodeError) else ""
        raise file.error(place, "this is no JSON", "give a file that compas.json_dump wrote") from None
    return _read(data, file, grid)


def _read(source: Any, file: _File, grid: Optional[Fraction]) -> Read:
    form = "give an assembly of compas_assembly: a graph whose nodes have blocks"
    data = file.mapping(source, "", form)
    name = str(_first(_attributes(data), "name") or "")
    apart = None  # blocks beside the graph
    if "assembly" in data and "blocks" in data:
        apart = file.mapping(data["blocks"], "blocks", form)
        data = file.mapping(data["assembly"], "assembly", form)
        name = name or str(_first(_attributes(data), "name") or "")
    graph = file.mapping(data["graph"], "graph", form) if "graph" in data else data
    found_nodes = _first(graph, "node", "vertex")
    if not isinstance(found_nodes, Mapping):
        raise file.error("", "there is no graph with nodes", form)
    defaults = _plain(_first(graph, "default_node_attributes", "node_attributes", "dna", "dva") or {})
    blocks: Dict[str, Block] = {}
    supports, densities = [], {}
    for node, given in found_nodes.items():
        key, place = _key(node), f"node[{_key(node)!r}]"
        attributes = file.mapping(given if given is not None else {}, place, "give a node with its block")
        block = attributes.get("block") if apart is None else apart.get(node)
        if block is None:
            raise file.error(place, "there is no block", "give each node its block, a mesh")
        shape = file.mapping(block, f"{place}.block", "give a mesh, with vertices and faces")
        if key == GROUND:
            raise file.error(place, "no block has this name", "give it another one")
        blocks[key] = _block(shape, f"{place}.block", file, grid)
        if attributes.get("is_support", defaults.get("is_support", False)):
            supports.append(key)
        density = _attributes(shape).get("density")
        if density is not None:
            densities[key] = density
    interfaces = list(_interfaces(_plain(graph.get("edge") or {}), blocks, file, grid))
    return Read(blocks, interfaces, supports, densities, name)


def _attributes(data: Mapping[str, Any]) -> Mapping[str, Any]:
    attributes = data.get("attributes")
    return attributes if isinstance(attributes, Mapping) else {}


def _block(shape: Mapping[str, Any], place: str, file: _File, grid: Optional[Fraction]) -> Block:
    vertex, face = shape.get("vertex"), shape.get("face")
    if not isinstance(vertex, Mapping) or not isinstance(face, Mapping):
        raise file.error(place, f"the mesh has no {'face' if isinstance(vertex, Mapping) else 'vertex'}",
                         'give a mesh as compas has it, {"vertex": {...}, "face": {...}}')
    zero = {axis: 0.0 for axis in "xyz"}
    zero.update(_plain(_first(shape, "default_vertex_attributes", "dva") or {}))
    numbers = {_key(v): i for i, v in enumerate(vertex)}
    points = [file.vector({**zero, **(at or {})}, f"{place}.vertex[{_key(v)!r}]") for v, at in vertex.items()]
    faces = []
    for f, corners in face.items():
        if corners is None:
            continue
        own = []
        for v in corners:
            if _key(v) not in numbers:
                raise file.error(f"{place}.face[{_key(f)!r}]", f"there is no vertex {v!r}",
                                 "name vertices that the mesh has")
            own.append(numbers[_key(v)])
        faces.append(own)
    block = Block(points, faces, place, file.name, grid=grid, turn=True)
    block.floats = True
    return block


def _interfaces(edges: Any, blocks: Mapping[str, Block], file: _File, grid: Optional[Fraction]) -> Iterator[Interface]:
    for start, others in edges.items():
        for end, attributes in (others or {}).items():
            one, two = _key(start), _key(end)
            place = f"edge[{one!r}][{two!r}]"
            for key in (one, two):
                if key not in blocks:
                    raise file.error(place, f"there is no node {key!r}", "name nodes that the graph has")
            attributes = _plain(attributes) or {}
            several = attributes.get("interfaces")
            if several is None:
                several = [attributes["interface"]] if attributes.get("interface") is not None else []
            if attributes.get("interface_points") is not None:  # the oldest form
                several = [{"points": attributes["interface_points"], "frame": attributes.get("interface_uvw")}]
            for i, given in enumerate(several):
                at = f"{place}.interfaces[{i}]"
                interface = file.mapping(given, at, "give an interface, with points and a frame")
                yield _interface(one, two, interface, at, file, grid)


def _interface(one: str, two: str, interface: Mapping[str, Any], place: str, file: _File,
               grid: Optional[Fraction]) -> Interface:
    points = _plain(interface.get("points"))
    if not isinstance(points, (list, tuple)) or not points:
        raise file.error(f"{place}.points", f"this is {found(points)}", "give the corners of the interface")
    corners = [file.vector(p, f"{place}.points[{i}]", grid) for i, p in enumerate(points)]
    frame = _plain(interface.get("frame"))
    if isinstance(frame, Mapping) and "xaxis" in frame and "yaxis" in frame:
        axes = [frame["xaxis"], frame["yaxis"]]
    elif isinstance(frame, (list, tuple)) and len(frame) >= 2:
        axes = list(frame)
    else:
        raise file.error(f"{place}.frame", f"this is {found(frame)}", "give a frame with xaxis and yaxis, in the interface's plane")
    x, y = (file.vector(axis, f"{place}.frame.{name}") for axis, name in zip(axes, ("xaxis", "yaxis")))
    # The third axis leads out of the first block.
    normal = tuple(-c for c in cross(list(x), list(y)))
    if not any(normal):
        raise file.error(f"{place}.frame", "the axes are parallel", "give two axes that span the interface's plane")
    return Interface(one, two, normal, list(dict.fromkeys(corners)))
