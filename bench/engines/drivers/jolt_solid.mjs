// SPDX-License-Identifier: GPL-3.0-or-later
import { add, bodies, hull, Jolt, jolt, moving, slop, still } from "./jolt_world.mjs";
import { runSolid } from "./protocol.mjs";

runSolid((c, dt) => {
  // Jolt turns bodies about the centre of their shape's volume, which is where ours is.
  const body = add(hull(c.vertices), Jolt.EMotionType_Dynamic, moving, 1, (made) => {
    made.mLinearDamping = made.mAngularDamping = 0;
    made.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
    made.mMassPropertiesOverride.mMass = 1;
    made.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(new Jolt.Vec3(...c.inertia));
  });
  const all = [body, ...c.obstacles.map((o) => add(hull(o.shape), Jolt.EMotionType_Static, still, o.friction ** 2))];
  const force = new Jolt.Vec3(), torque = new Jolt.Vec3();
  return {
    step(load) {
      force.Set(...load.slice(0, 3));
      torque.Set(...load.slice(3));
      body.AddForce(force);
      body.AddTorque(torque);
      jolt.Step(dt, 1);
    },
    state() {
      const p = body.GetCenterOfMassPosition(), q = body.GetRotation();
      return [p.GetX(), p.GetY(), p.GetZ(), q.GetX(), q.GetY(), q.GetZ(), q.GetW()];
    },
    contacts: () => [], // Its JavaScript does not say them.
    free() {
      for (const b of all) {
        bodies.RemoveBody(b.GetID());
        bodies.DestroyBody(b.GetID());
      }
    },
  };
}, { gap: -slop });
