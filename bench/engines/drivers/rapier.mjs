// SPDX-License-Identifier: GPL-3.0-or-later
import RAPIER from "@dimforge/rapier2d-compat";
import { iterations, run } from "./protocol.mjs";

await RAPIER.init();
const flat = (vertices) => new Float32Array(vertices.flat());

// Shapes overlap at rest by the allowed linear error, 0.001 of the length unit.
run((c, dt) => {
  const world = new RAPIER.World({ x: 0, y: 0 });
  world.timestep = dt;
  world.numSolverIterations *= iterations;
  const body = world.createRigidBody(RAPIER.RigidBodyDesc.dynamic().setCanSleep(false)
    .setAdditionalMassProperties(1, { x: 0, y: 0 }, c.inertia));
  const multiply = RAPIER.CoefficientCombineRule.Multiply;
  const add = (desc, friction, parent) => world.createCollider(
    desc.setDensity(0).setFriction(friction).setFrictionCombineRule(multiply), parent);
  const shape = add(c.vertices.length ? RAPIER.ColliderDesc.convexPolyline(flat(c.vertices))
    : RAPIER.ColliderDesc.ball(c.radius), 1, body);
  const obstacles = c.obstacles.map((o) => add(RAPIER.ColliderDesc.convexPolyline(flat(o.shape)), o.friction));
  return {
    step([x, y, torque]) {
      body.resetForces(true);
      body.resetTorques(true);
      body.addForce({ x, y }, true);
      body.addTorque(torque, true);
      world.step();
    },
    state() {
      const p = body.translation(), v = body.linvel();
      return [p.x, p.y, body.rotation(), v.x, v.y, body.angvel()];
    },
    contacts() {
      const found = [];
      obstacles.forEach((obstacle, k) => world.contactPair(shape, obstacle, (manifold, flipped) => {
        // The normal points out of the first of the two; the impulses are what the second is given.
        const sign = flipped ? 1 : -1, { x, y } = manifold.normal();
        for (let i = 0; i < manifold.numContacts(); ++i) {
          const own = flipped ? manifold.localContactPoint2(i) : manifold.localContactPoint1(i);
          const a = body.rotation(), at = body.translation();
          const n = manifold.contactImpulse(i) / dt, t = manifold.contactTangentImpulse(i) / dt;
          found.push([at.x + Math.cos(a) * own.x - Math.sin(a) * own.y, at.y + Math.sin(a) * own.x + Math.cos(a) * own.y,
            sign * x, sign * y, sign * (n * x - t * y), sign * (n * y + t * x), c.obstacles[k].friction]);
        }
      }));
      return found;
    },
    free() { world.free(); },
  };
}, { gap: () => -1e-3 });
