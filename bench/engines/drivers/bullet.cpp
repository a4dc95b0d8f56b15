// SPDX-License-Identifier: GPL-3.0-or-later
#include <btBulletDynamicsCommon.h>

#include <memory>

#include "protocol.hpp"

namespace {
using namespace conformance;

class World {
 public:
  static constexpr double scale = 1;
  static constexpr double margin = 1e-3;
  // Between two hulls the contact points are those of the hulls without their margins.
  static double gap(bool is_disc) { return is_disc ? margin : 0; }

  World(const Case& c, double dt)
      : dt_(static_cast<btScalar>(dt)),
        dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    world_.setGravity({0, 0, 0});
    world_.getSolverInfo().m_numIterations *= iterations();
    // Friction is the product.
    btCollisionShape* shape = nullptr;
    if (c.vertices.empty())
      shape = keep(new btSphereShape(static_cast<btScalar>(c.radius)));
    else
      shape = polygon(c.vertices);
    const auto inertia = static_cast<btScalar>(c.inertia);
    body_ = add(1, shape, {inertia, inertia, inertia}, 1);
    // In the plane: the documented way is by factors.
    body_->setLinearFactor({1, 1, 0});
    body_->setAngularFactor({0, 0, 1});
    body_->setActivationState(DISABLE_DEACTIVATION);
    for (const Obstacle& o : c.obstacles) add(0, polygon(o.shape), {0, 0, 0}, o.friction);
  }
  ~World() {
    for (auto& body : bodies_) world_.removeRigidBody(body.get());
  }

  // As impulses: the friction of btSequentialImpulseConstraintSolver does not see the torque
  // that applyTorque leaves for the step (docs/engines.md).
  void step(const Load& load) {
    body_->applyCentralImpulse(dt_ *
                               btVector3(btScalar(load.force.x), btScalar(load.force.y), 0));
    body_->applyTorqueImpulse(dt_ * btVector3(0, 0, btScalar(load.torque)));
    world_.stepSimulation(dt_, 0, dt_);
  }

  State state() const {
    const btTransform& at = body_->getWorldTransform();
    const btVector3 right = at.getBasis().getColumn(0), v = body_->getLinearVelocity();
    return {{at.getOrigin().x(), at.getOrigin().y()},
            std::atan2(right.y(), right.x()),
            {v.x(), v.y()},
            body_->getAngularVelocity().z()};
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
        const btVector3 n = sign * p.m_normalWorldOnB, f = (sign / dt_) * impulse,
                        at = p.getPositionWorldOnA();
        found.push_back(
            {{at.x(), at.y()}, {n.x(), n.y()}, {f.x(), f.y()}, p.m_combinedFriction});
      }
    }
    return found;
  }

 private:
  template <class Shape>
  Shape* keep(Shape* shape) {
    shapes_.emplace_back(shape);
    return shape;
  }
  btCollisionShape* polygon(const std::vector<Vec>& vertices) {
    auto* hull = keep(new btConvexHullShape);
    for (Vec v : vertices)
      for (const double z : {-0.5, 0.5})
        hull->addPoint({btScalar(v.x), btScalar(v.y), btScalar(z)}, false);
    hull->recalcLocalAabb();
    hull->setMargin(btScalar(margin));
    hull->initializePolyhedralFeatures();
    return hull;
  }
  btRigidBody* add(double mass, btCollisionShape* shape, const btVector3& inertia,
                   double friction) {
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shape,
                                                  inertia);
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
  return conformance::run<World>(argc, argv);
}
