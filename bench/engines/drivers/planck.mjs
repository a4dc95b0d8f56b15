// SPDX-License-Identifier: GPL-3.0-or-later
import { Circle, Polygon, Settings, Vec2, World } from "planck";
import { iterations, run } from "./protocol.mjs";

// As Box2D, from which it comes: bodies of 0.1 to 10 m, a skin, an overlap by the slop, 8 and 3 iterations.
const scale = 4;
const gap = (isDisc) => (isDisc ? 1 : 2) * Settings.polygonRadius - Settings.linearSlop;
const polygon = (vertices) => new Polygon(vertices.map(([x, y]) => new Vec2(x, y)));

run((c, dt) => {
  const world = new World({ gravity: new Vec2(0, 0), allowSleep: false });
  const body = world.createDynamicBody();
  // Friction is mixed to the root of the product.
  body.createFixture({
    shape: c.vertices.length ? polygon(c.vertices) : new Circle(c.radius),
    friction: 1,
  });
  body.setMassData({ mass: 1, center: new Vec2(0, 0), I: c.inertia });
  for (const o of c.obstacles)
    world.createBody().createFixture({ shape: polygon(o.shape), friction: o.friction ** 2 });
  return {
    step([x, y, torque]) {
      body.applyForceToCenter(new Vec2(x, y), true);
      body.applyTorque(torque, true);
      world.step(dt, 8 * iterations, 3 * iterations);
    },
    state() {
      const p = body.getPosition(), v = body.getLinearVelocity();
      return [p.x, p.y, body.getAngle(), v.x, v.y, body.getAngularVelocity()];
    },
    contacts() {
      const found = [];
      for (let c = world.getContactList(); c; c = c.getNext()) {
        if (!c.isTouching()) continue;
        const where = c.getWorldManifold(null), manifold = c.getManifold();
        // The manifold's normal points from A to B.
        const sign = c.getFixtureB().getBody() === body ? 1 : -1;
        const [nx, ny] = [sign * where.normal.x, sign * where.normal.y];
        for (let i = 0; i < manifold.pointCount; ++i) {
          const { normalImpulse: n, tangentImpulse: t } = manifold.points[i];
          found.push([where.points[i].x, where.points[i].y, nx, ny,
            (n * nx + t * ny) / dt, (n * ny - t * nx) / dt, c.getFriction()]);
        }
      }
      return found;
    },
  };
}, { scale, gap });
