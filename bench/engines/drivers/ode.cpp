// SPDX-License-Identifier: GPL-3.0-or-later
#include <ode/ode.h>

#include <cstring>

#include "protocol.hpp"

namespace {
using namespace conformance;

bool quick = false;  // dWorldQuickStep, or else dWorldStep

/// Where the obstacle touches the body: as the user of the library would find it, who is free
/// to make contact joints without its collision detection.
struct Touch {
  Vec point, normal;
  double depth;
};

std::vector<Touch> touches(const std::vector<Vec>& vertices, Vec centre, double radius,
                           const Obstacle& o) {
  std::vector<Touch> found;
  const auto add = [&](Vec p, Vec n, double depth) {
    if (depth >= 0) found.push_back({p, n, depth});
  };
  if (vertices.empty()) {
    add(centre - radius * o.normal, o.normal, radius - dot(o.normal, centre - o.point));
  } else if (!o.tip) {
    for (Vec v : vertices) add(v, o.normal, -dot(o.normal, v - o.point));
  } else {
    Touch least{o.point, {}, HUGE_VAL};
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Vec a = vertices[i], way = vertices[(i + 1) % vertices.size()] - a;
      const Vec inward = (1 / std::sqrt(dot(way, way))) * Vec{-way.y, way.x};
      const double depth = dot(inward, o.point - a);
      if (depth < least.depth) least = {o.point, inward, depth};
    }
    add(least.point, least.normal, least.depth);
  }
  return found;
}

class World {
 public:
  static constexpr double scale = 1;
  static constexpr double layer = 1e-3;  // the manual's example of a contact surface layer
  static double gap(bool) { return -layer; }

  World(const Case& c, double dt)
      : case_(c), dt_(dt), world_(dWorldCreate()), group_(dJointGroupCreate(0)) {
    dWorldSetContactSurfaceLayer(world_, layer);
    dWorldSetQuickStepNumIterations(world_,
                                    iterations() * dWorldGetQuickStepNumIterations(world_));
    body_ = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, c.inertia, c.inertia, c.inertia, 0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetAutoDisableFlag(body_, 0);
    dJointAttach(dJointCreatePlane2D(world_, nullptr), body_, nullptr);
  }
  ~World() {
    dJointGroupDestroy(group_);
    dWorldDestroy(world_);
  }

  void step(const Load& load) {
    dJointGroupEmpty(group_);
    found_.clear();
    const State s = state();
    const double cosine = std::cos(s.angle), sine = std::sin(s.angle);
    std::vector<Vec> vertices;
    for (Vec v : case_.vertices)
      vertices.push_back(s.position +
                         Vec{cosine * v.x - sine * v.y, sine * v.x + cosine * v.y});
    for (const Obstacle& o : case_.obstacles)
      for (const Touch& t : touches(vertices, s.position, case_.radius, o))
        found_.push_back({t, o.friction, {}});
    for (Joint& joint : found_) {
      dContact contact;
      std::memset(&contact, 0, sizeof contact);
      // Coulomb's friction, as near as ODE has it: a limit of mu times the normal force.
      contact.surface.mode = dContactApprox1 | dContactFDir1;
      contact.surface.mu = joint.friction;
      const auto set = [](dVector3 to, Vec v) { to[0] = v.x, to[1] = v.y, to[2] = 0; };
      set(contact.fdir1, {-joint.touch.normal.y, joint.touch.normal.x});
      set(contact.geom.pos, joint.touch.point);
      set(contact.geom.normal, joint.touch.normal);
      contact.geom.depth = joint.touch.depth;
      const dJointID id = dJointCreateContact(world_, group_, &contact);
      dJointAttach(id, body_, nullptr);
      dJointSetFeedback(id, &joint.feedback);
    }
    dBodyAddForce(body_, load.force.x, load.force.y, 0);
    dBodyAddTorque(body_, 0, 0, load.torque);
    if (quick)
      dWorldQuickStep(world_, dt_);
    else
      dWorldStep(world_, dt_);
  }

  State state() const {
    const dReal *p = dBodyGetPosition(body_), *r = dBodyGetRotation(body_),
                *v = dBodyGetLinearVel(body_);
    return {{p[0], p[1]}, std::atan2(r[4], r[0]), {v[0], v[1]}, dBodyGetAngularVel(body_)[2]};
  }

  std::vector<ContactForce> contacts() const {
    std::vector<ContactForce> forces;
    for (const Joint& j : found_)
      forces.push_back(
          {j.touch.point, j.touch.normal, {j.feedback.f1[0], j.feedback.f1[1]}, j.friction});
    return forces;
  }

 private:
  struct Joint {
    Touch touch;
    double friction;
    dJointFeedback feedback;
  };

  Case case_;
  double dt_;
  dWorldID world_;
  dJointGroupID group_;
  dBodyID body_;
  std::vector<Joint> found_;
};

}  // namespace

int main(int argc, char** argv) {
  quick = argc > 2 && std::strcmp(argv[2], "quick") == 0;
  dInitODE2(0);
  dAllocateODEDataForThread(dAllocateMaskAll);
  const int status = conformance::run<World>(argc, argv);
  dCloseODE();
  return status;
}
