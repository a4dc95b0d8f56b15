// SPDX-License-Identifier: GPL-3.0-or-later
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "solid.hpp"

namespace {
using namespace conformance::solid;

btVector3 to_bt(const Vec& v) {
  return {btScalar(v[0]), btScalar(v[1]), btScalar(v[2])};
}
Vec from_bt(const btVector3& v) {
  return {v.x(), v.y(), v.z()};
}

class World {
 public:
  static constexpr double margin = 1e-3;
  // Between two hulls the contact points are those of the hulls without their margins.
  static constexpr double gap = 0;

  World(const Case& c, double dt)
      : dt_(static_cast<btScalar>(dt)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, 0});
    world_.getSolverInfo().m_numIterations *= conformance::iterations();
    // By default there is one direction of friction, which holds no torque about the normal.
    world_.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    // Friction is the product.
    body_ = add(1, c.vertices, c.inertia, 1);
    body_->setActivationState(DISABLE_DEACTIVATION);
    for (const Obstacle& o : c.obstacles) add(0, o.shape, {}, o.friction);
  }
  ~World() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  // As impulses, as in the plane: bullet.cpp says why.
  void step(const Load& load) {
    body_->applyCentralImpulse(dt_ * to_bt(load.force));
    body_->applyTorqueImpulse(dt_ * to_bt(load.torque));
    world_.stepSimulation(dt_, 0, dt_);
  }

  State state() const {
    const btQuaternion q = body_->getWorldTransform().getRotation();
    return {from_bt(body_->getWorldTransform().getOrigin()), {q.x(), q.y(), q.z(), q.w()}};
  }

  std::vector<ContactForce> contacts() {
    std::vector<ContactForce> found;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i) {
      const btPersistentManifold* manifold = dispatcher_.getManifoldByIndexInternal(i);
      // The normal points from 1 to 0, and the impulses are what 0 is given.
      const btScalar sign = manifold->getBody0() == body_ ? 1 : -1;
      for (int k = 0; k < manifold->getNumContacts(); ++k) {
        const btManifoldPoint& p = manifold->getContactPoint(k);
        const btVector3 impulse = p.m_appliedImpulse * p.m_normalWorldOnB +
                                  p.m_appliedImpulseLateral1 * p.m_lateralFrictionDir1 +
                                  p.m_appliedImpulseLateral2 * p.m_lateralFrictionDir2;
        found.push_back({from_bt(p.getPositionWorldOnA()), from_bt(sign * p.m_normalWorldOnB),
                         from_bt((sign / dt_) * impulse), p.m_combinedFriction});
      }
    }
    return found;
  }

 private:
  btRigidBody* add(double mass, const std::vector<Vec>& vertices, const Vec& inertia,
                   double friction) {
    auto* hull = new btConvexHullShape;
    shapes_.emplace_back(hull);
    for (const Vec& v : vertices) hull->addPoint(to_bt(v), false);
    hull->recalcLocalAabb();
    hull->setMargin(btScalar(margin));
    hull->initializePolyhedralFeatures();
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(mass), nullptr, hull,
                                                  to_bt(inertia));
    info.m_friction = static_cast<btScalar>(friction);
    bodies_.emplace_back(new btRigidBody(info));
    world_.addRigidBody(bodies_.back().get());
    return bodies_.back().get();
  }

  btScalar dt_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> bodies_;
  btRigidBody* body_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  return conformance::solid::run<World>(argc, argv);
}
