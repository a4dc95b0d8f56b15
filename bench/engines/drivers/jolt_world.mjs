// SPDX-License-Identifier: GPL-3.0-or-later
// What jolt.mjs and jolt_solid.mjs share: one world, in which each case puts its bodies.
import load from "jolt-physics";
import { iterations } from "./protocol.mjs";

export const Jolt = await load();
export const slop = 1e-3; // 0.02 m is the default; as the manual says, a part of what is visible
export const [still, moving] = [0, 1];

const settings = new Jolt.JoltSettings();
const pairs = new Jolt.ObjectLayerPairFilterTable(2);
pairs.EnableCollision(still, moving);
const layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
layers.MapObjectToBroadPhaseLayer(still, new Jolt.BroadPhaseLayer(0));
layers.MapObjectToBroadPhaseLayer(moving, new Jolt.BroadPhaseLayer(1));
settings.mObjectLayerPairFilter = pairs;
settings.mBroadPhaseLayerInterface = layers;
settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
export const jolt = new Jolt.JoltInterface(settings);
const system = jolt.GetPhysicsSystem();
export const bodies = system.GetBodyInterface();
system.SetGravity(new Jolt.Vec3(0, 0, 0));
const physics = system.GetPhysicsSettings();
physics.mPenetrationSlop = slop;
physics.mNumVelocitySteps *= iterations;
physics.mNumPositionSteps *= iterations;
system.SetPhysicsSettings(physics);

// No rounding of its edges.
export function hull(vertices) {
  const made = new Jolt.ConvexHullShapeSettings();
  for (const v of vertices) made.mPoints.push_back(new Jolt.Vec3(...v));
  made.mMaxConvexRadius = 0;
  return made.Create().Get();
}

export function add(shape, kind, layer, friction, change = () => {}) {
  const made = new Jolt.BodyCreationSettings(shape, new Jolt.RVec3(0, 0, 0), new Jolt.Quat(0, 0, 0, 1), kind, layer);
  made.mFriction = friction; // of two bodies the root of the product
  made.mAllowSleeping = false;
  change(made);
  const body = bodies.CreateBody(made);
  bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
  return body;
}
