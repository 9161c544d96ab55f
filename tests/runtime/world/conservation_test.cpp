// What a split conserves (scenes P17 and P18 of the accuracy tests), over very many random cuts: a hundred thousand
// with RUBBLE_LONG=1.
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/mat3x3.hpp>

#include "runtime/destruction/carve.h"
#include "runtime/world/edits/resolve_brush.h"
#include "tests/runtime/world/worlds.h"

namespace rubble {
namespace {

using Vector = glm::dvec3;

struct Motion {
    double mass = 0.0, energy = 0.0, scale = 0.0;
    Vector linear{0.0}, angular{0.0};

    /// Adds a rigid body, with its angular momentum and the scale of rounding about `pivot`.
    void add(const MassProperties& part, const Pose& pose, Vector velocity, Vector spin, Vector pivot) {
        const std::array<double, 6>& t = part.inertia;
        const glm::dmat3 rotation = glm::mat3_cast(pose.rotation);
        const glm::dmat3 inertia =
            rotation * glm::dmat3(t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2]) * glm::transpose(rotation);
        const Vector arm = pose.transformPoint(part.center) - pivot;
        mass += part.mass;
        linear += part.mass * velocity;
        angular += glm::cross(arm, part.mass * velocity) + inertia * spin;
        energy += 0.5 * part.mass * glm::dot(velocity, velocity) + 0.5 * glm::dot(spin, inertia * spin);
        scale += part.mass * (glm::length(velocity) + glm::length(spin) * glm::length(arm));
    }
};

class RandomCuts {
public:
    explicit RandomCuts(uint64_t seed) : m_random(seed) {
        const glm::ivec3 size(8 + int(m_random.below(30)), 8 + int(m_random.below(30)), 8 + int(m_random.below(20)));
        const bool isNoise = seed % 3 == 0;
        const double w = m_random.unit(), x = m_random.unit(), y = m_random.unit(), z = m_random.unit();
        const Pose pose{{50.0 * x, -30.0 * y, 20.0 * z},
                        glm::normalize(glm::dquat(w + 0.1, x - 0.5, y - 0.5, z - 0.5))};
        Level level = test::oneShapeLevel(isNoise ? noiseGrid(size, 45, seed) : towerGrid(size, 2, 6), false, pose);
        level.bodies[0].velocity = {3.0 * x, -2.0, 5.0 * z};
        level.bodies[0].angularVelocity = {4.0 * z, 7.0 * w, -3.0 * y};
        m_world.load(level);
        WorldSettings settings = m_world.settings();
        settings.debris.awakeBodies = settings.debris.bodies = 1'000'000;  // nothing despawns
        m_world.setSettings(settings);
        m_world.applyEdits({});
    }

    bool isEmpty() const { return m_world.shapes().size() == 0; }
    size_t shapes() const { return m_world.shapes().size(); }
    size_t splits() const { return m_splits; }
    const World& world() const { return m_world; }

    void cut() {
        const ShapeHandle handle = pickShape();
        const Shape shape = m_world.shapes().at(handle);
        const Body body = m_world.bodies().at(shape.body);
        const CarveEdit edit = randomCut(handle, shape);
        const MassProperties whole = bodyMass(m_world, shape.body);
        VoxelGrid grid = shape.grid;
        CarveResult carved;
        carve(grid, resolveBrush(edit, shapeToWorld(m_world, handle), shape.voxelSize), *shape.palette,
              m_world.materials(), carved);
        const MassMoments expected = gridMoments(grid, *shape.palette, m_world.materials());
        const FrameChanges changes = m_world.applyEdits({edit});
        ASSERT_TRUE(voxelAccounting(m_world).balances());

        const MassProperties rest = massProperties(expected, shape.voxelSize);
        const Pose pose = body.pose * shape.local;
        const Vector pivot = pose.transformPoint(rest.center);
        const Vector velocity =
            body.velocity + glm::cross(body.angularVelocity, pivot - body.pose.transformPoint(whole.center));
        Motion before, after;
        before.add(rest, pose, velocity, body.angularVelocity, pivot);
        MassMoments sum;
        const auto count = [&](ShapeHandle part, glm::ivec3 offset) {
            const Shape* left = m_world.shapes().find(part);
            if (!left) return;
            ASSERT_EQ(left->moments, gridMoments(left->grid, *left->palette, m_world.materials()));
            sum += left->moments.shifted(offset);
            const Body& owner = m_world.bodies().at(left->body);
            after.add(massProperties(left->moments, left->voxelSize), shapeToWorld(m_world, part), owner.velocity,
                      owner.angularVelocity, pivot);
        };
        count(handle, glm::ivec3(0));
        for (const ShapeSplit& split : changes.splits)
            for (size_t i = 0; i < split.children.size(); ++i)
                count(split.children[i], split.parentOffset[i]), ++m_splits;
        ASSERT_EQ(sum, expected) << "voxels and integer moments";
        ASSERT_NEAR(after.mass, before.mass, 1e-9 * before.mass);
        ASSERT_LE(glm::length(after.linear - before.linear), 1e-6 * after.scale);
        ASSERT_LE(glm::length(after.angular - before.angular), 1e-6 * after.scale);
        ASSERT_NEAR(after.energy, before.energy, 1e-6 * before.energy);
    }

private:
    ShapeHandle pickShape() {
        std::vector<ShapeHandle> all;
        m_world.shapes().forEach([&](ShapeHandle handle, const Shape&) { all.push_back(handle); });
        const ShapeHandle a = all[m_random.below(uint32_t(all.size()))], b = all[m_random.below(uint32_t(all.size()))];
        return m_world.shapes().at(a).grid.voxelCount() >= m_world.shapes().at(b).grid.voxelCount() ? a : b;
    }
    CarveEdit randomCut(ShapeHandle handle, const Shape& shape) {
        const Pose pose = shapeToWorld(m_world, handle);
        const glm::dvec3 size = glm::dvec3(shape.grid.size()) * double(shape.voxelSize);
        const double x = m_random.unit(), y = m_random.unit(), z = m_random.unit(), kind = m_random.unit();
        const Vector position = pose.transformPoint(size * Vector(x, y, z));
        CarveEdit edit = test::sphereCarve(position, shape.voxelSize * (0.6 + 2.5 * kind));
        if (kind < 0.4) {  // an oblique slab across the whole shape
            edit.kind = BrushKind::Box;
            edit.halfSize = Vector(10.0, 0.8 * shape.voxelSize, 10.0);
            edit.rotation = glm::normalize(glm::dquat(1.0, x - 0.5, 3.0 * (y - 0.5), z - 0.5));
        }
        edit.shape = handle;
        return edit;
    }

    World m_world;
    Random m_random;
    size_t m_splits = 0;
};

TEST(Conservation, RandomCutsLoseOnlyCarvedVoxels) {
    const int cuts = std::getenv("RUBBLE_LONG") ? 100000 : 3000;
    size_t splits = 0;
    for (int done = 0, seed = 1; done < cuts; ++seed) {
        RandomCuts scene{uint64_t(seed)};
        for (int i = 0; i < 60 && done < cuts && !scene.isEmpty(); ++i, ++done) {
            scene.cut();
            if (HasFatalFailure()) FAIL() << "seed " << seed << ", cut " << i;
        }
        splits += scene.splits();
    }
    std::printf("%d cuts made %zu pieces\n", cuts, splits);
    EXPECT_GT(splits, size_t(cuts) / 4);
}

TEST(Conservation, AThousandCutsDownToSingleVoxels) {
    RandomCuts scene(7);
    int cuts = 0;
    for (; cuts < 1000 && !scene.isEmpty(); ++cuts) {
        scene.cut();
        if (HasFatalFailure()) FAIL() << "cut " << cuts;
    }
    size_t singles = 0;
    scene.world().shapes().forEach([&](ShapeHandle, const Shape& shape) { singles += shape.grid.voxelCount() == 1; });
    EXPECT_TRUE(scene.isEmpty() || cuts == 1000);
    EXPECT_TRUE(scene.isEmpty() || singles > 0);
}

}  // namespace
}  // namespace rubble
