# SPDX-License-Identifier: GPL-3.0-or-later
"""Two pictures that no command draws: the dual polyhedron (Fig. 6) and a grasp wrench space (Fig. 7(a)).

They wear the style of the pictures that `stickslip plot` draws. Ink is in doubles; what is drawn is exact.
"""

import itertools
import math
import re

from model import dot

SIGNS = {"+": 1, "-": -1, "0": 0}


class Drawing:
    def __init__(self, width, height, title, styled_like):
        with open(styled_like, encoding="utf-8") as file:
            style = re.search(r"<style>.*?</style>", file.read(), re.S).group()
        self._elements = [
            f'<svg xmlns="http://www.w3.org/2000/svg" class="stickslip" role="img" width="{width}" '
            f'height="{height}" viewBox="0 0 {width} {height}">', f"<title>{title}</title>", style,
            f'<rect class="paper" width="{width}" height="{height}"/>']
        self.text((24, 34), title, "title")

    def path(self, points, css, closed=False, more=""):
        data = "M" + "L".join(f"{x:.2f} {y:.2f}" for x, y in points) + ("Z" if closed else "")
        self._elements.append(f'<path class="{css}" d="{data}"{more}/>')

    def mark(self, point, css="vertex", more=""):
        self._elements.append(f'<circle class="{css}" cx="{point[0]:.2f}" cy="{point[1]:.2f}" r="4"{more}/>')

    def text(self, point, text, css):
        self._elements.append(f'<text class="{css}" x="{point[0]:.2f}" y="{point[1]:.2f}">'
                              f'{text.replace("-", "−")}</text>')

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join([*self._elements, "</svg>\n"]))


def middle(points):
    return tuple(sum(values) / len(points) for values in zip(*points))


def draw_dual(path, styled_like, corners):
    """The convex hull of one motion in each region of three planes: a parallelepiped.

    `corners`: the motion (x, y, r) of each region, "++-". Cells of the arrangement are faces of the
    polyhedron: a sign is 0 where the corners of the face differ.
    """
    drawing = Drawing(640, 560, "Fig. 6: the dual polyhedron", styled_like)
    turn, tilt = math.radians(-75), math.radians(60)
    right = (math.cos(turn), math.sin(turn), 0)
    back = (-math.sin(turn), math.cos(turn), 0)
    up = (*(math.sin(tilt) * b for b in back[:2]), math.cos(tilt))
    viewer = (*(-math.cos(tilt) * b for b in back[:2]), math.sin(tilt))
    flat = {state: (dot(right, d), -dot(up, d)) for state, d in corners.items()}
    scale = 200 / max(max(map(abs, point)) for point in flat.values())
    ink = {state: (320 + scale * x, 262 + scale * y) for state, (x, y) in flat.items()}

    def of(state):  # the corners of a cell, in order around it
        around = sorted(c for c in corners if all(s in ("0", t) for s, t in zip(state, c)))
        return around if len(around) < 4 else [around[i] for i in (0, 1, 3, 2)]

    states = ["".join(signs) for signs in itertools.product("+-0", repeat=3)]
    seen = set()  # faces towards the viewer; the polyhedron is centred at 0, so are its faces' middles
    for state in (s for s in states if s.count("0") == 2):
        a, b, c = (corners[corner] for corner in of(state)[:3])
        u, v = ([y - x for x, y in zip(a, b)], [y - x for x, y in zip(b, c)])
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        if dot(normal, viewer) * dot(normal, a) > 0:
            seen.add(state)
            drawing.path([ink[corner] for corner in of(state)], f"face hue{len(seen) - 1}", True,
                         f' data-state="{state}"')
    shown = {edge for edge in states if edge.count("0") == 1
             and any(set(of(edge)) <= set(of(face)) for face in seen)}
    for edge in (s for s in states if s.count("0") == 1):
        drawing.path([ink[corner] for corner in of(edge)], "edge" if edge in shown else "edge ring",
                     more=f' data-state="{edge}"')
    for corner, point in ink.items():
        drawing.mark(point, more=f' data-state="{corner}"')
    for cell in sorted(seen | shown):
        x, y = middle([ink[corner] for corner in of(cell)])
        drawing.text((x, y + 4), cell, "state middle halo")
    for corner, (x, y) in ink.items():
        away = (x - 320, y - 262)
        size = math.hypot(*away)
        drawing.text((x + 26 * away[0] / size, y + 18 * away[1] / size + 4), corner, "state middle halo")
    for line, text in enumerate((
            "Corner: a region, all contacts slip. Edge: a facet, one contact sticks (0). Face: a line, two stick.",
            "Labels: the signs of contacts 0, 1, 2. Dotted: edges behind.")):
        drawing.text((24, 512 + 20 * line), text, "small")
    drawing.write(path)


def draw_slice(path, styled_like, polygon):
    """A polygon of forces; the frame shows -1.5 .. 1.5."""
    drawing = Drawing(640, 640, "Fig. 1: L1 grasp wrench space, torque 0", styled_like)

    def place(x, y):
        return (330 + 165 * float(x), 310 - 165 * float(y))
    drawing.path([place(*vertex) for vertex in polygon], "face shade3", True)
    for step in range(-3, 4):
        value = step / 2
        css = "grid-line" if step else "axis-line"
        drawing.path([place(value, -1.5), place(value, 1.5)], css)
        drawing.path([place(-1.5, value), place(1.5, value)], css)
        drawing.text((place(value, 0)[0], place(0, -1.5)[1] + 20), f"{value:g}", "small muted middle")
        drawing.text((place(-1.5, 0)[0] - 8, place(0, value)[1] + 4), f"{value:g}", "small muted end")
    drawing.path([place(*vertex) for vertex in polygon], "edge", True)
    for x, y in polygon:
        at = place(x, y)
        drawing.mark(at, more=f' data-value="{x},{y}"')
        drawing.text((at[0], at[1] + (-10 if y > 0 or y == 0 else 20)), f"({x}, {y})", "small middle halo")
    drawing.text((330, 610), "applied force (w_x, w_y)", "middle")
    drawing.write(path)
