// SPDX-License-Identifier: GPL-3.0-or-later
#include <chipmunk/chipmunk.h>
#include <chipmunk/chipmunk_structs.h>

#include "protocol.hpp"

namespace {
using namespace conformance;

Vec from_cp(cpVect v) {
  return {v.x, v.y};
}

class World {
 public:
  // The default slop, 0.1, is for pixels: the manual asks for one that is not visible.
  static constexpr double scale = 1;
  static constexpr double slop = 1e-3;
  static double gap(bool) { return -slop; }

  World(const Case& c, double dt)
      : dt_(dt), space_(cpSpaceNew()), body_(cpBodyNew(1, c.inertia)) {
    cpSpaceSetCollisionSlop(space_, slop);
    cpSpaceSetIterations(space_, iterations() * cpSpaceGetIterations(space_));
    cpSpaceAddBody(space_, body_);
    // Friction is the product.
    add(c.vertices.empty() ? cpCircleShapeNew(body_, c.radius, cpvzero)
                           : polygon(body_, c.vertices),
        1);
    for (const Obstacle& o : c.obstacles)
      add(polygon(cpSpaceGetStaticBody(space_), o.shape), o.friction);
  }
  ~World() {
    for (cpShape* shape : shapes_) {
      cpSpaceRemoveShape(space_, shape);
      cpShapeFree(shape);
    }
    cpSpaceRemoveBody(space_, body_);
    cpBodyFree(body_);
    cpSpaceFree(space_);
  }

  void step(const Load& load) {
    cpBodySetForce(body_, cpv(load.force.x, load.force.y));
    cpBodySetTorque(body_, load.torque);
    cpSpaceStep(space_, dt_);
  }

  State state() const {
    return {from_cp(cpBodyGetPosition(body_)), cpBodyGetAngle(body_),
            from_cp(cpBodyGetVelocity(body_)), cpBodyGetAngularVelocity(body_)};
  }

  std::vector<ContactForce> contacts() const {
    std::vector<ContactForce> found;
    const auto each = [](cpBody* body, cpArbiter* arbiter, void* data) {
      auto& [dt, forces] = *static_cast<std::pair<double, std::vector<ContactForce>*>*>(data);
      // The normal points from a to b, and the impulses are what b is given.
      const double sign = arbiter->body_b == body ? 1 : -1;
      for (int i = 0; i < arbiter->count; ++i) {
        const cpContact& contact = arbiter->contacts[i];
        const cpVect impulse = cpvrotate(arbiter->n, cpv(contact.jnAcc, contact.jtAcc));
        forces->push_back({from_cp(cpvadd(arbiter->body_a->p, contact.r1)),
                           sign * from_cp(arbiter->n), (sign / dt) * from_cp(impulse),
                           arbiter->u});
      }
    };
    std::pair<double, std::vector<ContactForce>*> data{dt_, &found};
    cpBodyEachArbiter(body_, each, &data);
    return found;
  }

 private:
  static cpShape* polygon(cpBody* body, const std::vector<Vec>& vertices) {
    std::vector<cpVect> points;
    for (Vec v : vertices) points.push_back(cpv(v.x, v.y));
    return cpPolyShapeNewRaw(body, static_cast<int>(points.size()), points.data(), 0);
  }
  void add(cpShape* shape, double friction) {
    cpShapeSetFriction(shape, friction);
    cpSpaceAddShape(space_, shape);
    shapes_.push_back(shape);
  }

  double dt_;
  cpSpace* space_;
  cpBody* body_;
  std::vector<cpShape*> shapes_;
};

}  // namespace

int main(int argc, char** argv) {
  return conformance::run<World>(argc, argv);
}
