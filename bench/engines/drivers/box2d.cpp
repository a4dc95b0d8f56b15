// SPDX-License-Identifier: GPL-3.0-or-later
#include <box2d/box2d.h>

#include "protocol.hpp"

namespace {
using namespace conformance;

b2Vec2 to_b2(Vec v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y)};
}
Vec from_b2(b2Vec2 v) {
  return {v.x, v.y};
}

class World {
 public:
  // The manual: bodies of 0.1 to 10 m. A polygon has a skin, and shapes overlap by the slop.
  static constexpr double scale = 4;
  static double gap(bool is_disc) {
    return (is_disc ? 1 : 2) * b2_polygonRadius - b2_linearSlop;
  }

  World(const Case& c, double dt) : world_({0, 0}), dt_(static_cast<float>(dt)) {
    world_.SetAllowSleeping(false);
    b2BodyDef moving;
    moving.type = b2_dynamicBody;
    body_ = world_.CreateBody(&moving);
    b2FixtureDef fixture;
    fixture.friction = 1;  // Box2D mixes to the root of the product.
    b2PolygonShape polygon;
    b2CircleShape circle;
    if (c.vertices.empty()) {
      circle.m_radius = static_cast<float>(c.radius);
      fixture.shape = &circle;
    } else {
      set(polygon, c.vertices);
      fixture.shape = &polygon;
    }
    body_->CreateFixture(&fixture);
    b2MassData mass;
    mass.mass = 1;
    mass.center = {0, 0};
    mass.I = static_cast<float>(c.inertia);
    body_->SetMassData(&mass);
    for (const Obstacle& o : c.obstacles) {
      b2BodyDef fixed;
      b2PolygonShape shape;
      set(shape, o.shape);
      b2FixtureDef f;
      f.shape = &shape;
      f.friction = static_cast<float>(o.friction * o.friction);
      world_.CreateBody(&fixed)->CreateFixture(&f);
    }
  }

  void step(const Load& load) {
    body_->ApplyForceToCenter(to_b2(load.force), true);
    body_->ApplyTorque(static_cast<float>(load.torque), true);
    world_.Step(dt_, 8 * iterations(), 3 * iterations());
  }

  State state() const {
    return {from_b2(body_->GetPosition()), body_->GetAngle(),
            from_b2(body_->GetLinearVelocity()), body_->GetAngularVelocity()};
  }

  std::vector<ContactForce> contacts() {
    std::vector<ContactForce> found;
    for (b2Contact* c = world_.GetContactList(); c; c = c->GetNext()) {
      if (!c->IsTouching()) continue;
      b2WorldManifold where;
      c->GetWorldManifold(&where);
      // The manifold's normal points from A to B.
      const double sign = c->GetFixtureB()->GetBody() == body_ ? 1 : -1;
      const Vec n = sign * from_b2(where.normal), t{n.y, -n.x};
      for (int i = 0; i < c->GetManifold()->pointCount; ++i) {
        const b2ManifoldPoint& p = c->GetManifold()->points[i];
        found.push_back({from_b2(where.points[i]), n,
                         (1 / dt_) * (p.normalImpulse * n + p.tangentImpulse * t),
                         c->GetFriction()});
      }
    }
    return found;
  }

 private:
  static void set(b2PolygonShape& shape, const std::vector<Vec>& vertices) {
    std::vector<b2Vec2> points;
    for (Vec v : vertices) points.push_back(to_b2(v));
    shape.Set(points.data(), static_cast<int32>(points.size()));
  }

  b2World world_;
  b2Body* body_ = nullptr;
  float dt_;
};

}  // namespace

int main(int argc, char** argv) {
  return conformance::run<World>(argc, argv);
}
