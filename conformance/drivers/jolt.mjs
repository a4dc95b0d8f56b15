// SPDX-License-Identifier: GPL-3.0-or-later
import load from "jolt-physics";
import { run } from "./protocol.mjs";

const Jolt = await load();
const slop = 1e-3; // 0.02 m is the default; as the manual says, a part of what is visible
const [still, moving] = [0, 1];

const settings = new Jolt.JoltSettings();
const pairs = new Jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(still, moving);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
layers.MapObjectToBroadPhaseLayer(still, new Jolt.BroadPhaseLayer(0));
layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
const jolt = new Jolt.JoltInterface(settings);
const system = jolt.GetPhysicsSystem(), bodies = system.GetBodyInterface();
system.SetGravity(new Jolt.Vec3(0, 0, 0));
const physics = system.GetPhysicsSettings();
physics.mPenetrationSlop = slop;
system.SetPhysicsSettings(physics);

// Extruded along z; no rounding of its edges.
function prism(vertices) {
  const hull = new Jolt.ConvexHullShapeSettings();
  for (const [x, y] of vertices) for (const z of [-0.5, 0.5]) hull.mPoints.push_back(new Jolt.Vec3(x, y, z));
  hull.mMaxConvexRadius = 0;
  return hull.Create().Get();
}

function add(shape, kind, layer, friction, change = () => {}) {
  const made = new Jolt.BodyCreationSettings(shape, new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), kind, layer);
  made.mFriction = friction; // of two bodies the root of the product
  made.mAllowSleeping = false;
  change(made);
  const body = bodies.CreateBody(made);
  bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
  return body;
}

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
