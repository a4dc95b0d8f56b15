// SPDX-License-Identifier: GPL-3.0-or-later
#include <ode/ode.h>

#include <cstring>

#include "solid.hpp"

namespace {
using namespace conformance::solid;

bool quick = false;  // dWorldQuickStep, or else dWorldStep

class World {
 public:
  static constexpr double layer = 1e-3;  // the manual's example of a contact surface layer
  static constexpr double gap = -layer;

  World(const Case& c, double dt)
      : case_(c), dt_(dt), world_(dWorldCreate()), group_(dJointGroupCreate(0)) {
    dWorldSetContactSurfaceLayer(world_, layer);
    dWorldSetQuickStepNumIterations(
        world_, conformance::iterations() * dWorldGetQuickStepNumIterations(world_));
    body_ = dBodyCreate(world_);
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, c.inertia[0], c.inertia[1], c.inertia[2], 0, 0, 0);
    dBodySetMass(body_, &mass);
    dBodySetAutoDisableFlag(body_, 0);
  }
  ~World() {
    dJointGroupDestroy(group_);
    dWorldDestroy(world_);
  }

  /// Contact joints where a corner is within an obstacle, as users of the library may make
  /// them.
  void step(const Load& load) {
    dJointGroupEmpty(group_);
    found_.clear();
    for (const Vec& v : case_.vertices) {
      dVector3 p;
      dBodyGetRelPointPos(body_, v[0], v[1], v[2], p);
      for (const Obstacle& o : case_.obstacles) {
        const double depth = -dot(o.normal, Vec{p[0], p[1], p[2]} - o.point);
        if (depth >= 0) found_.push_back({{p[0], p[1], p[2]}, &o, depth, {}});
      }
    }
    for (Joint& joint : found_) {
      dContact contact;
      std::memset(&contact, 0, sizeof contact);
      // Coulomb's friction, as near as ODE has it: a limit of mu times the normal force along
      // each of two directions, which it chooses.
      contact.surface.mode = dContactApprox1;
      contact.surface.mu = joint.obstacle->friction;
      for (std::size_t k = 0; k < 3; ++k) {
        contact.geom.pos[k] = joint.point[k];
        contact.geom.normal[k] = joint.obstacle->normal[k];
      }
      contact.geom.depth = joint.depth;
      const dJointID id = dJointCreateContact(world_, group_, &contact);
      dJointAttach(id, body_, nullptr);
      dJointSetFeedback(id, &joint.feedback);
    }
    const Vec &f = load.force, &t = load.torque;
    dBodyAddForce(body_, f[0], f[1], f[2]);
    dBodyAddTorque(body_, t[0], t[1], t[2]);
    if (quick)
      dWorldQuickStep(world_, dt_);
    else
      dWorldStep(world_, dt_);
  }

  State state() const {
    const dReal *p = dBodyGetPosition(body_), *q = dBodyGetQuaternion(body_);
    return {{p[0], p[1], p[2]}, {q[1], q[2], q[3], q[0]}};
  }

  std::vector<ContactForce> contacts() const {
    std::vector<ContactForce> forces;
    for (const Joint& j : found_) {
      const dReal* f = j.feedback.f1;
      forces.push_back({j.point, j.obstacle->normal, {f[0], f[1], f[2]}, j.obstacle->friction});
    }
    return forces;
  }

 private:
  struct Joint {
    Vec point;
    const Obstacle* obstacle;
    double depth;
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
  const int status = conformance::solid::run<World>(argc, argv);
  dCloseODE();
  return status;
}
