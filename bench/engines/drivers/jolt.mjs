// SPDX-License-Identifier: GPL-3.0-or-later
import { add, bodies, hull, Jolt, jolt, moving, slop, still } from "./jolt_world.mjs";
import { run } from "./protocol.mjs";

// Extruded along z.
const prism = (vertices) => hull(vertices.flatMap(([x, y]) => [[x, y, -0.5], [x, y, 0.5]]));

run((c, dt) => {
  const shape = c.vertices.length ? prism(c.vertices) : new Jolt.SphereShape(c.radius);
  // Jolt turns bodies about the centre of their shape's volume, which is where ours is.
  const body = add(shape, Jolt.EMotionType_Dynamic, moving, 1, (made) => {
    made.mAllowedDOFs = Jolt.EAllowedDOFs_Plane2D;
    made.mLinearDamping = made.mAngularDamping = 0;
    made.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    made.mMassPropertiesOverride.mMass = 1;
    made.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScale(c.inertia);
  });
  const all = [body, ...c.obstacles.map((o) => add(prism(o.shape), Jolt.EMotionType_Static, still, o.friction ** 2))];
  const force = new Jolt.Vec3(), torque = new Jolt.Vec3();
  return {
    step([x, y, t]) {
      force.Set(x, y, 0);
      torque.Set(0, 0, t);
      body.AddForce(force);
      body.AddTorque(torque);
      jolt.Step(dt, 1);
    },
    state() {
      const p = body.GetCenterOfMassPosition(), q = body.GetRotation(), v = body.GetLinearVelocity();
      return [p.GetX(), p.GetY(), 2 * Math.atan2(q.GetZ(), q.GetW()), v.GetX(), v.GetY(), body.GetAngularVelocity().GetZ()];
    },
    contacts: () => [], // Its JavaScript does not say them.
    free() {
      for (const b of all) {
        bodies.RemoveBody(b.GetID());
        bodies.DestroyBody(b.GetID());
      }
    },
  };
}, { gap: () => -slop });
