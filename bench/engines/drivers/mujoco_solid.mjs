// SPDX-License-Identifier: GPL-3.0-or-later
import load_mujoco from "@mujoco/mujoco";
import { iterations, runSolid } from "./protocol.mjs";

// elliptic cones with impratio 10, which the manual advises against slip; or the default, pyramidal
const option = process.argv[3] === "elliptic" ? 'cone="elliptic" impratio="10"' : "";
const mujoco = await load_mujoco();
const numbers = (v) => v.flat().join(" ");

runSolid((c, dt) => {
  // The friction of two geoms is the larger of theirs. Obstacles are slabs, as of the other engines.
  const mesh = (name, vertices) => `<mesh name="${name}" inertia="convex" vertex="${numbers(vertices)}"/>`;
  const fixed = c.obstacles.map((o, i) => `<geom type="mesh" mesh="o${i}" friction="${o.friction} 0 0"/>`);
  const model = mujoco.MjModel.from_xml_string(`<mujoco>
    <compiler angle="radian" inertiafromgeom="false" boundmass="0" boundinertia="0"/>
    <option timestep="${dt}" iterations="${100 * iterations}" gravity="0 0 0" ${option}><flag multiccd="enable"/></option>
    <asset>${mesh("body", c.vertices)}${c.obstacles.map((o, i) => mesh(`o${i}`, o.shape)).join("")}</asset>
    <worldbody>${fixed.join("")}
      <body><inertial pos="0 0 0" mass="1" diaginertia="${numbers(c.inertia)}"/>
        <freejoint/><geom type="mesh" mesh="body" friction="0 0 0"/></body>
    </worldbody></mujoco>`);
  const data = new mujoco.MjData(model), force = new mujoco.DoubleBuffer(6);
  return {
    step(load) {
      data.xfrc_applied.set(load, 6); // of body 1; 0 is the world
      mujoco.mj_step(model, data);
    },
    state() {
      const [x, y, z, w, i, j, k] = data.qpos;
      return [x, y, z, i, j, k, w];
    },
    contacts() {
      const found = [], all = data.contact;
      for (let i = 0; i < data.ncon; ++i) {
        const contact = all.get(i), f = contact.frame;
        mujoco.mj_contactForce(model, data, i, force);
        const [n, t, s] = force.GetView();
        // Rows of the frame: the normal from the first geom to the second, which is the body's; two tangents.
        found.push([...contact.pos, f[0], f[1], f[2], ...[0, 1, 2].map((k) => n * f[k] + t * f[3 + k] + s * f[6 + k]), contact.friction[0]]);
      }
      return found;
    },
    free() {
      data.delete();
      model.delete();
    },
  };
});
