// SPDX-License-Identifier: GPL-3.0-or-later
import RAPIER from "@dimforge/rapier3d-compat";
import { iterations, runSolid } from "./protocol.mjs";

await RAPIER.init();
const xyz = ([x, y, z]) => ({ x, y, z }), list = ({ x, y, z }) => [x, y, z];
const hull = (vertices) => RAPIER.ColliderDesc.convexHull(new Float32Array(vertices.flat()));
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const turned = (v, { x, y, z, w }) => {
  const q = [x, y, z], t = cross(q, v).map((c) => 2 * c), s = cross(q, t);
  return v.map((c, k) => c + w * t[k] + s[k]);
};

// Shapes overlap at rest by the allowed linear error, 0.001 of the length unit.
runSolid((c, dt) => {
  const world = new RAPIER.World({ x: 0, y: 0, z: 0 });
  world.timestep = dt;
  world.numSolverIterations *= iterations;
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false)
    .setAdditionalMassProperties(1, xyz([0, 0, 0]), xyz(c.inertia), { x: 0, y: 0, z: 0, w: 1 }));
  const add = (desc, friction, parent) => world.createCollider(desc.setDensity(0).setFriction(friction)
    .setFrictionCombineRule(RAPIER.CoefficientCombineRule.Multiply), parent);
  const shape = add(hull(c.vertices), 1, body);
  const obstacles = c.obstacles.map((o) => add(hull(o.shape), o.friction));
  return {
    step(load) {
      body.resetForces(true);
      body.resetTorques(true);
      body.addForce(xyz(load.slice(0, 3)), true);
      body.addTorque(xyz(load.slice(3)), true);
      world.step();
    },
    state() {
      const { x, y, z, w } = body.rotation();
      return [...list(body.translation()), x, y, z, w];
    },
    contacts: () => [],
    free() { world.free(); },
  };
}, { gap: -1e-3 });
