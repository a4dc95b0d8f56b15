// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what Grasp.from_mujoco reads of settled scenes, as JSON: tests/corpus/contacts/mujoco.json.
//
//     node mujoco_contacts.mjs > ../../../tests/corpus/contacts/mujoco.json
import load_mujoco from "@mujoco/mujoco";

const mujoco = await load_mujoco();

const scenes = {
  // A box of 2 kg, its centre of mass off its middle, on the floor.
  resting: [`<option gravity="0 0 -10" cone="elliptic"/>
    <worldbody><geom type="plane" size="1 1 1" friction="0.5 0 0"/>
      <body name="box" pos="0.3 0.1 0.1"><freejoint/><inertial pos="0.02 0 -0.05" mass="2" diaginertia="0.02 0.02 0.02"/>
        <geom type="box" size="0.1 0.15 0.1" friction="0 0 0"/></body></worldbody>`, 4000],
  // Two jaws that motors close on a box, without gravity.
  gripper: [`<option gravity="0 0 0"/><compiler boundmass="0.1"/>
    <worldbody>
      <body name="object" pos="0 0 0.5"><freejoint/>
        <geom type="box" size="0.035 0.05 0.05" mass="0.3" friction="0.4 0 0"/></body>
      <body name="left" pos="-0.06 0 0.5"><joint name="l" type="slide" axis="1 0 0" damping="20"/>
        <geom type="box" size="0.02 0.02 0.03" mass="0.1" friction="0.4 0 0"/></body>
      <body name="right" pos="0.06 0 0.5"><joint name="r" type="slide" axis="-1 0 0" damping="20"/>
        <geom type="box" size="0.02 0.02 0.03" mass="0.1" friction="0.4 0 0"/></body></worldbody>
    <actuator><motor joint="l" ctrlrange="0 100"/><motor joint="r" ctrlrange="0 100"/></actuator>`, 4000, 10],
};

const plain = (v) => (typeof v === "number" ? v : Array.from(v));
const fields = (thing, names) => Object.fromEntries(names.map((name) => [name, plain(thing[name])]));

function settled([xml, steps, control = 0]) {
  const model = mujoco.MjModel.from_xml_string(`<mujoco>${xml}</mujoco>`), data = new mujoco.MjData(model);
  data.ctrl.fill(control);
  for (let i = 0; i < steps; ++i) mujoco.mj_step(model, data);
  mujoco.mj_forward(model, data);  // contacts and forces of one moment
  const force = new mujoco.DoubleBuffer(6), contacts = [], forces = [], all = data.contact;
  for (let i = 0; i < data.ncon; ++i) {
    contacts.push(fields(all.get(i), ["pos", "frame", "dist", "includemargin", "friction", "dim", "geom", "exclude", "efc_address"]));
    mujoco.mj_contactForce(model, data, i, force);
    forces.push(Array.from(force.GetView()));
  }
  return {
    model: {
      ...fields(model, ["body_weldid", "body_rootid", "body_dofnum", "body_mass", "geom_bodyid", "actuator_trntype"]),
      opt: fields(model.opt, ["cone", "gravity"]),
      names: Array.from({ length: model.nbody }, (_, i) => model.body(i).name),
    },
    data: {
      ...fields(data, ["ncon", "efc_force", "actuator_force"]),
      xipos: Array.from({ length: model.nbody }, (_, i) => Array.from(data.xipos.slice(3 * i, 3 * i + 3))),
      contact: contacts,
    },
    forces,
    speed: Math.max(...Array.from(data.qvel, Math.abs)),
  };
}

const lines = Object.entries(scenes).map(([name, scene]) => `"${name}": ${JSON.stringify(settled(scene))}`);
process.stdout.write(`{${lines.join(",\n")}}\n`);
