// SPDX-License-Identifier: GPL-3.0-or-later
// What every engine from npm is put through: protocol.hpp says it, and the same is done here.
import { createInterface } from "node:readline";

// How many times its own number of iterations an engine is to make.
export const iterations = Number(process.env.STICKSLIP_ITERATIONS ?? 1);

const plus = (a, b, s = 1) => [a[0] + s * b[0], a[1] + s * b[1]];

function readCase(line, scale, gap) {
  const times = (v, s = scale) => v.map((x) => s * x);
  const load = ([x, y, torque]) => [scale * x, scale * y, scale * scale * torque];
  return {
    name: line.name,
    vertices: line.vertices.map((v) => times(v)),
    radius: scale * line.radius,
    inertia: scale * scale * line.inertia,
    obstacles: line.obstacles.map((o) => ({
      shape: o.shape.map((v) => plus(times(v), o.normal, -gap)),
      point: plus(times(o.point), o.normal, -gap),
      normal: o.normal,
      friction: o.friction,
      tip: o.tip,
    })),
    settle: load(line.settle),
    load: load(line.load),
  };
}

function putThrough(rate, step, sample) {
  const settling = 1, ramp = 0.25, end = 4.25, samples = [];
  for (let i = 1; i <= Math.round(end * rate); ++i) {
    step(Math.min(1, Math.max(0, (i / rate - settling) / ramp)));
    // Eight samples a second from the end of settling on.
    if (i < settling * rate || Math.floor((8 * i) / rate) === Math.floor((8 * (i - 1)) / rate)) continue;
    samples.push({ t: i / rate, ...sample() });
  }
  return samples;
}

async function eachCase(read, makeWorld, sample) {
  const rate = Number(process.argv[2] ?? 60);
  for await (const text of createInterface({ input: process.stdin })) {
    const c = read(JSON.parse(text)), world = makeWorld(c, 1 / rate);
    const samples = putThrough(rate, (share) => world.step(c.settle.map((s, k) => s + share * (c.load[k] - s))),
      () => sample(world));
    world.free?.();
    process.stdout.write(JSON.stringify({ name: c.name, samples }) + "\n");
  }
}

// makeWorld(case, dt) gives an object with step(load), state() -> [x, y, angle, vx, vy, spin],
// contacts() -> [[x, y, nx, ny, fx, fy, friction], ...] on the body, normals into it; and free(), if need be.
export const run = (makeWorld, { scale = 1, gap = () => 0 } = {}) =>
  eachCase((line) => readCase(line, scale, gap(line.vertices.length === 0)), makeWorld, (world) => {
    const [x, y, angle, vx, vy, spin] = world.state();
    return {
      pose: [x / scale, y / scale, angle],
      velocity: [vx / scale, vy / scale, spin],
      contacts: world.contacts().map(([px, py, nx, ny, fx, fy, mu]) =>
        [px / scale, py / scale, nx, ny, fx / scale, fy / scale, mu]),
    };
  });

// The same in space: state() -> [x, y, z and a quaternion x, y, z, w], contacts() with three coordinates each. A case is
// as solid.hpp has it.
export function runSolid(makeWorld, { gap = 0 } = {}) {
  const back = (v, o) => v.map((x, k) => x - gap * o.normal[k]);
  const read = (line) => ({ ...line, obstacles: line.obstacles.map((o) =>
    ({ ...o, shape: o.shape.map((v) => back(v, o)), point: back(o.point, o) })) });
  return eachCase(read, makeWorld, (world) => ({ pose: world.state(), contacts: world.contacts() }));
}
