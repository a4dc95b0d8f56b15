# SPDX-License-Identifier: GPL-3.0-or-later
"""The engines, and how each is started. To add one: a driver in drivers/, and a line here."""

from __future__ import annotations

import os
from pathlib import Path
from typing import List, NamedTuple, Tuple

HERE = Path(__file__).resolve().parent
BUILT = Path(os.environ.get("STICKSLIP_DRIVERS", HERE.parents[1] / "build/engines/drivers"))


class Engine(NamedTuple):
    name: str
    version: str
    program: str  # a driver in C++, or in JavaScript
    rates: Tuple[int, ...]  # steps a second: its default, and where it makes sense ten times that
    arguments: Tuple[str, ...] = ()
    package: str = ""  # of npm, for JavaScript

    def command(self, rate: int) -> List[str]:
        if self.program.endswith(".mjs"):
            return ["node", str(HERE / "drivers" / self.program), str(rate), *self.arguments]
        return [str(BUILT / self.program), str(rate), *self.arguments]

    def missing(self) -> str:
        """What is not installed, or nothing."""
        if self.program.endswith(".mjs"):
            return "" if (HERE / "node_modules" / self.package).is_dir() else f"{self.package} (install.sh)"
        return "" if (BUILT / self.program).exists() else f"{self.program} (install.sh)"


ENGINES = [
    Engine("Box2D", "2.4.1", "box2d", (60, 600)),
    Engine("Chipmunk", "7.0.3", "chipmunk", (60, 600)),
    Engine("planck", "1.5.0", "planck.mjs", (60, 600), package="planck"),
    Engine("rapier", "0.21.0", "rapier.mjs", (60, 600), package="@dimforge/rapier2d-compat"),
    Engine("Jolt", "1.1.0", "jolt.mjs", (60, 600), package="jolt-physics"),
    Engine("ODE dWorldQuickStep", "0.16.2", "ode", (60, 600), ("quick",)),
    Engine("ODE dWorldStep", "0.16.2", "ode", (60, 600)),
    Engine("Bullet", "3.24", "bullet", (60, 600)),
    Engine("MuJoCo elliptic", "3.14.0", "mujoco.mjs", (500,), ("elliptic",), "@mujoco/mujoco"),
    Engine("MuJoCo pyramidal", "3.14.0", "mujoco.mjs", (500,), package="@mujoco/mujoco"),
]

# Times their own number of iterations, at their own steps, on one in ITERATIONS_OF cases; dWorldStep makes none.
ITERATIONS = (1, 4, 16)
ITERATIONS_OF = 28
DIRECT = "ODE dWorldStep"

# In space.
SOLID_ENGINES = [
    Engine("Jolt", "1.1.0", "jolt_solid.mjs", (60, 600), package="jolt-physics"),
    Engine("rapier", "0.21.0", "rapier_solid.mjs", (60, 600), package="@dimforge/rapier3d-compat"),
    Engine("ODE dWorldQuickStep", "0.16.2", "ode_solid", (60, 600), ("quick",)),
    Engine("ODE dWorldStep", "0.16.2", "ode_solid", (60, 600)),
    Engine("Bullet", "3.24", "bullet_solid", (60, 600)),
    Engine("MuJoCo elliptic", "3.14.0", "mujoco_solid.mjs", (500,), ("elliptic",), "@mujoco/mujoco"),
    Engine("MuJoCo pyramidal", "3.14.0", "mujoco_solid.mjs", (500,), package="@mujoco/mujoco"),
]

# Those that test the set-up: where all of these agree with a border, it is not the driver that decides.
SOUND = ("Box2D", "Chipmunk", "planck", "rapier", "Jolt")

# Known, and not ranked: there is no border to hold them to.
UNRANKED = {
    "matter-js 0.20.0": "its friction acts on velocities and has another limit at rest (frictionStatic): "
                        "no coefficient of Coulomb's",
    "p2 0.7.1": "friction is limited by mu times mass times gravity, an estimate, and not by the normal force",
}
