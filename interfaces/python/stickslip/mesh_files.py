# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of OBJ and STL files. Numbers that are written out are taken as they are spelled."""

from __future__ import annotations

import os
import struct
from typing import Any, Dict, List, Tuple, Union

from . import _core
from .arguments import as_content
from .errors import InputError

Shape = Tuple[List[Any], List[List[int]]]
"""Vertices, and of each face the vertices that it has."""
Path = Union[str, "os.PathLike[str]"]

ENDINGS = (".obj", ".stl")


def is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def read(path: Any, place: str) -> Tuple[Shape, bool]:
    """All of a file as one mesh, and whether its numbers are floats."""
    ending = os.path.splitext(os.fspath(path))[1].lower()
    if ending not in ENDINGS:
        raise InputError("", place, f"{os.fspath(path)!r} is no file of a mesh",
                         "give a file whose name ends in .obj or .stl")
    content, name = as_content(path, place, "name an OBJ or STL file")
    file = os.fsdecode(name)
    if ending == ".obj":
        vertices: List[Any] = []
        faces: List[List[int]] = []
        for vertices, own in _obj(content, file).values():
            faces += own
        return (vertices, faces), False
    return _stl(content, file)


def read_objects(path: Any, place: str) -> Dict[str, Shape]:
    """Of an OBJ file the objects, by the names on their lines that begin with "o"."""
    if os.path.splitext(os.fspath(path))[1].lower() != ".obj":
        raise InputError("", place, f"{os.fspath(path)!r} is no OBJ file",
                         'give a mapping of names to meshes, or one OBJ file with an "o" line for each block')
    content, name = as_content(path, place, "name an OBJ file")
    file = os.fsdecode(name)
    objects = {key: own for key, own in _obj(content, file).items() if own[1]}
    if "" in objects:
        raise InputError(file, "", "there are faces before the first object" if len(objects) > 1 else "the file has no objects",
                         'write an "o" line with its name before each block, or give a mapping of names to files')
    return objects


def _obj(content: bytes, file: str) -> Dict[str, Shape]:
    """By names of objects; what comes before the first is of the name "". All share their vertices."""
    vertices: List[Any] = []
    objects: Dict[str, Shape] = {"": (vertices, [])}
    now = ""
    text = content.decode("utf-8", "replace").replace("\\\n", " ").replace("\\\r\n", " ")
    for number, line in enumerate(text.splitlines(), 1):
        words = line.partition("#")[0].split()
        place = f"line {number}"
        if not words:
            continue
        if words[0] == "v":
            if len(words) not in (4, 5, 7, 8):  # a weight or a colour may follow
                raise InputError(file, place, f"a vertex has {len(words) - 1} numbers", "give x, y and z")
            vertices.append([_number(word, file, place) for word in words[1:4]])
        elif words[0] == "f":
            objects[now][1].append([_vertex(word, len(vertices), file, place) for word in words[1:]])
            if len(words) < 4:
                raise InputError(file, place, f"a face has {len(words) - 1} vertices", "give three or more")
        elif words[0] == "o":
            now = line.split(None, 1)[1].strip() if len(words) > 1 else ""
            objects.setdefault(now, (vertices, []))
    if not any(faces for _, faces in objects.values()):
        raise InputError(file, "", "there is no face", 'an OBJ file has lines "v x y z" and "f 1 2 3"')
    return objects


def _number(word: str, file: str, place: str) -> Any:
    try:
        return _core.exact(word, place)
    except InputError as error:
        raise InputError(file, place, f"{word!r}: {error.problem}", error.remedy) from None


def _vertex(word: str, count: int, file: str, place: str) -> int:
    """Vertices count from 1, or back from the last one; texture and normal may follow after slashes."""
    try:
        index = int(word.split("/")[0])
    except ValueError:
        index = 0
    if not (1 <= index <= count or -count <= index <= -1):
        raise InputError(file, place, f"{word!r} is no vertex",
                         f"there are {count} before this line, which count from 1" if count else
                         "vertices come before faces")
    return index - 1 if index > 0 else count + index


def _stl(content: bytes, file: str) -> Tuple[Shape, bool]:
    """Of triangles, each with vertices of its own."""
    count = struct.unpack_from("<I", content, 80)[0] if len(content) >= 84 else 0
    vertices: List[Any] = []
    binary = count > 0 and len(content) == 84 + 50 * count
    if binary:
        for t in range(count):
            numbers = struct.unpack_from("<9f", content, 84 + 50 * t + 12)
            vertices += [list(numbers[i:i + 3]) for i in (0, 3, 6)]
    elif content.lstrip()[:5].lower() == b"solid":
        for number, line in enumerate(content.decode("utf-8", "replace").splitlines(), 1):
            words = line.split()
            if words and words[0].lower() == "vertex":
                if len(words) != 4:
                    raise InputError(file, f"line {number}", f"a vertex has {len(words) - 1} numbers", "give x, y and z")
                vertices.append([_number(word, file, f"line {number}") for word in words[1:]])
    else:
        raise InputError(file, "", f"this is no STL file: {len(content)} bytes for {count} triangles" if count else
                         "this is no STL file",
                         'a binary one has 84 bytes and 50 for each triangle, and one of text begins with "solid"')
    if not vertices or len(vertices) % 3:
        raise InputError(file, "", f"there are {len(vertices)} vertices", "give three for each triangle")
    return (vertices, [[i, i + 1, i + 2] for i in range(0, len(vertices), 3)]), binary
