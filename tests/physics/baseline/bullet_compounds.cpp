#include "tests/physics/baseline/bullet_compounds.h"

#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "runtime/voxel/mass_properties.h"
#include "tests/physics/baseline/box_merge.h"

namespace rubble {
namespace {

btVector3 toBullet(glm::dvec3 v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}
btTransform toBullet(const Pose& pose) {
    const glm::dquat& q = pose.rotation;
    return btTransform(btQuaternion(btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)),
                       toBullet(pose.position));
}
Pose fromBullet(const btTransform& t) {
    const btQuaternion q = t.getRotation();
    const btVector3& p = t.getOrigin();
    return {{p.x(), p.y(), p.z()}, {q.w(), q.x(), q.y(), q.z()}};
}
Pose inverse(const Pose& pose) {
    const glm::dquat rotation = glm::conjugate(pose.rotation);
    return {-(rotation * pose.position), rotation};
}

}  // namespace

struct BulletCompounds::World {
    struct Item {
        btCompoundShape compound{true};
        std::vector<std::unique_ptr<btBoxShape>> boxes;
        std::unique_ptr<btRigidBody> body;
        Pose frameInCenter;
    };

    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld bullet{&dispatcher, &broadphase, &solver, &configuration};
    std::vector<std::unique_ptr<Item>> items;
    Settings settings;
    size_t boxes = 0;

    void add(const LevelBody& body, const MaterialTable& materials) {
        const LevelShape& shape = body.shapes.at(0);
        auto item = std::make_unique<Item>();
        const MassProperties mass = massProperties(gridMoments(shape.grid, *shape.palette, materials), shape.voxelSize);
        const Pose center = shape.local * Pose{mass.center, mass.principalAxes};
        item->frameInCenter = inverse(center);
        for (const CellBox& cells : boxesOf(body, solidEntries(*shape.palette, materials))) {
            const glm::dvec3 half = glm::dvec3(cells.high - cells.low) * (0.5 * double(shape.voxelSize));
            const Pose place{glm::dvec3(cells.low + cells.high) * (0.5 * double(shape.voxelSize)), {1, 0, 0, 0}};
            item->boxes.push_back(std::make_unique<btBoxShape>(toBullet(half)));
            item->compound.addChildShape(toBullet(item->frameInCenter * shape.local * place), item->boxes.back().get());
        }
        boxes += item->boxes.size();
        btRigidBody::btRigidBodyConstructionInfo info(
            body.isStatic ? btScalar(0) : btScalar(mass.mass), nullptr, &item->compound,
            body.isStatic ? btVector3(0, 0, 0) : toBullet(mass.principalInertia));
        info.m_startWorldTransform = toBullet(body.pose * center);
        const Material& material = materials[(*shape.palette)[shape.grid.at(firstCell(shape.grid))].material];
        info.m_friction = std::sqrt(material.friction);  // Bullet multiplies the two, which gives the geometric mean
        info.m_restitution = std::sqrt(material.restitution);
        item->body = std::make_unique<btRigidBody>(info);
        item->body->setLinearVelocity(toBullet(body.velocity));
        item->body->setAngularVelocity(toBullet(body.angularVelocity));
        item->body->setActivationState(DISABLE_DEACTIVATION);
        bullet.addRigidBody(item->body.get());
        items.push_back(std::move(item));
    }
    std::vector<CellBox> boxesOf(const LevelBody& body, const SolidEntries& solid) const {
        const VoxelGrid& grid = body.shapes.at(0).grid;
        std::vector<CellBox> merged = mergeGrid(grid, solid), cells;
        if (body.isStatic || settings.detail == Detail::MergedBoxes || merged.empty()) return merged;
        CellBox all = merged[0];
        for (const CellBox& box : merged) {
            all = {glm::min(all.low, box.low), glm::max(all.high, box.high)};
            for (int z = box.low.z; z < box.high.z; ++z)
                for (int y = box.low.y; y < box.high.y; ++y)
                    for (int x = box.low.x; x < box.high.x; ++x) cells.push_back({{x, y, z}, {x + 1, y + 1, z + 1}});
        }
        return settings.detail == Detail::OneBox ? std::vector<CellBox>{all} : cells;
    }
    static glm::ivec3 firstCell(const VoxelGrid& grid) {
        glm::ivec3 cell(0);
        bool found = false;
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            if (!found)
                forEachVoxel(brick->occupancy, [&](int i) {
                    if (!found) cell = position * kBrickSize + voxelInBrick(i);
                    found = true;
                });
        });
        return cell;
    }
    ~World() {
        for (const auto& item : items) bullet.removeRigidBody(item->body.get());
    }
};

BulletCompounds::BulletCompounds(const Level& level, const Settings& settings) : m_world(std::make_unique<World>()) {
    m_world->settings = settings;
    m_world->bullet.setGravity(toBullet(glm::dvec3(level.environment.gravity)));
    m_world->bullet.getSolverInfo().m_numIterations = settings.iterations;
    if (settings.frictionDirections == 2)
        m_world->bullet.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
    m_world->bullet.setForceUpdateAllAabbs(false);
    for (const LevelBody& body : level.bodies) m_world->add(body, level.materials);
}

BulletCompounds::~BulletCompounds() = default;

void BulletCompounds::step() {
    const btScalar seconds = btScalar(1.0 / 60.0 / m_world->settings.substeps);
    for (int i = 0; i < m_world->settings.substeps; ++i) m_world->bullet.stepSimulation(seconds, 0, seconds);
}

Pose BulletCompounds::pose(size_t body) const {
    const World::Item& item = *m_world->items.at(body);
    return fromBullet(item.body->getWorldTransform()) * item.frameInCenter;
}

int BulletCompounds::pairs() const {
    std::set<std::pair<const btCollisionObject*, const btCollisionObject*>>
        touching;  // Bullet has a manifold for each pair of boxes
    for (int i = 0; i < m_world->dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold* manifold = m_world->dispatcher.getManifoldByIndexInternal(i);
        if (manifold->getNumContacts() > 0) touching.emplace(std::minmax(manifold->getBody0(), manifold->getBody1()));
    }
    return int(touching.size());
}

size_t BulletCompounds::boxes() const {
    return m_world->boxes;
}

}  // namespace rubble
