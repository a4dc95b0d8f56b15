// SPDX-License-Identifier: GPL-3.0-or-later
import load_mujoco from "@mujoco/mujoco";
import { iterations, run } from "./protocol.mjs";

// elliptic cones with impratio 10, which the manual advises against slip; or the default, pyramidal
const option = process.argv[3] === "elliptic" ? 'cone="elliptic" impratio="10"' : "";
const mujoco = await load_mujoco();

const numbers = (v) => v.flat().join(" ");
// Extruded along z, counterclockwise in the plane.
const prism = (vertices) => numbers(vertices.flatMap(([x, y]) => [[x, y, -0.1], [x, y, 0.1]]));

run((c, dt) => {
  // The friction of two geoms is the larger of theirs.
  const mesh = (name, vertices) => `<mesh name="${name}" vertex="${prism(vertices)}"/>`;
  const meshes = c.vertices.length ? mesh("body", c.vertices) : "";
  const obstacles = c.obstacles.map((o, i) => {
    const [nx, ny] = o.normal;
    if (!o.tip)
      return `<geom type="plane" size="0 0 1" pos="${o.point[0]} ${o.point[1]} 0" zaxis="${nx} ${ny} 0" friction="${o.friction} 0 0"/>`;
    return `<geom type="mesh" mesh="o${i}" friction="${o.friction} 0 0" pos="0 0 0"/>`;
  });
  const shape = c.vertices.length ? `type="mesh" mesh="body"` : `type="sphere" size="${c.radius}"`;
  const model = mujoco.MjModel.from_xml_string(`<mujoco>
    <compiler angle="radian" inertiafromgeom="false" boundmass="0" boundinertia="0"/>
    <option timestep="${dt}" iterations="${100 * iterations}" gravity="0 0 0" ${option}><flag multiccd="enable"/></option>
    <asset>${meshes}${c.obstacles.map((o, i) => (o.tip ? mesh(`o${i}`, o.shape) : "")).join("")}</asset>
    <worldbody>${obstacles.join("")}
      <body><inertial pos="0 0 0" mass="1" diaginertia="${c.inertia} ${c.inertia} ${c.inertia}"/>
        <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="hinge" axis="0 0 1"/>
        <geom ${shape} friction="0 0 0"/></body>
    </worldbody></mujoco>`);
  const data = new mujoco.MjData(model);
  const force = new mujoco.DoubleBuffer(6);
  return {
    step(load) {
      data.qfrc_applied.set(load);
      mujoco.mj_step(model, data);
    },
    state() { return [...data.qpos, ...data.qvel]; },
    contacts() {
      const found = [], all = data.contact;
      for (let i = 0; i < data.ncon; ++i) {
        const contact = all.get(i), f = contact.frame;
        mujoco.mj_contactForce(model, data, i, force);
        const [n, t, s] = force.GetView();
        // Rows of the frame: the normal from the first geom to the second, which is the body's; two tangents.
        found.push([contact.pos[0], contact.pos[1], f[0], f[1],
          n * f[0] + t * f[3] + s * f[6], n * f[1] + t * f[4] + s * f[7], contact.friction[0]]);
      }
      return found;
    },
    free() {
      data.delete();
      model.delete();
    },
  };
});
