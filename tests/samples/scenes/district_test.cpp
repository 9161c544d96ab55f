#include "samples/scenes/district.h"

#include <gtest/gtest.h>

#include <set>

#include "physics/physics_world.h"
#include "runtime/world/objects/transforms.h"
#include "runtime/world/world.h"
#include "samples/scenes/canvas.h"
#include "tests/samples/scenes/level_shapes.h"

namespace rubble {
namespace {

const Level& district() {
    static const Level level = makeDistrict(1);
    return level;
}

TEST(District, HasFiftyMillionVoxelsNoneLooseAndNamesOfItsOwn) {
    uint64_t voxels = 0;
    std::set<std::string> names;
    forEachShape(district(), [&](const LevelBody&, const LevelShape& shape) {
        EXPECT_GT(shape.grid.voxelCount(), 0u) << shape.name;
        EXPECT_TRUE(names.insert(shape.name).second) << shape.name << " is not unique";
        voxels += shape.grid.voxelCount();
    });
    EXPECT_GE(voxels, 50'000'000u);
    for (const LevelLight& light : district().lights)
        EXPECT_EQ(names.count(light.shapeName), 1u) << light.light.name << " hangs on " << light.shapeName;
    for (const LevelJoint& joint : district().joints)
        for (const std::string& shape : joint.shapeNames) EXPECT_EQ(names.count(shape), 1u) << shape;
    forEachShape(district(), [](const LevelBody& body, const LevelShape& shape) {
        if (!body.isStatic || body.name == "ground") return;
        const std::vector<bool> anchored = scenes::anchoredCells(shape.grid);
        const uint64_t held = uint64_t(std::count(anchored.begin(), anchored.end(), true));
        EXPECT_EQ(shape.grid.voxelCount() - held, 0u) << shape.name << " has loose voxels";
    });
}

/// The district in a world with physics and the stress analysis.
class DistrictWorld : public testing::Test {
protected:
    DistrictWorld() {
        WorldSettings settings;
        settings.stress.on = true;
        m_world.setSettings(settings);
        m_world.load(district());
        m_physics.load(m_world);
    }
    void step(int count, Edits edits = {}) {
        for (int i = 0; i < count; ++i) {
            const FrameChanges& changes = m_world.applyEdits(i == 0 ? edits : Edits());
            for (const ShapeSplit& split : changes.splits) m_pieces += split.children.size();
            m_physics.apply(changes, m_world);
            m_physics.step();
            copyMotion(m_physics, m_world);
        }
    }
    ShapeHandle shape(std::string_view name) const {
        ShapeHandle found;
        m_world.shapes().forEach([&](ShapeHandle handle, const Shape& each) {
            if (each.name == name) found = handle;
        });
        return found;
    }
    BodyHandle body(std::string_view name) const { return m_world.shapes().at(shape(name)).body; }
    /// Groups whose names begin so, and that are out.
    int groupsOut(std::string_view name) const {
        int out = 0;
        m_world.lightGroups().forEach(
            [&](LightGroupHandle, const LightGroup& group) { out += group.name.starts_with(name) && group.out; });
        return out;
    }
    static CarveEdit cut(glm::dvec3 low, glm::dvec3 high) {
        CarveEdit edit;
        edit.kind = BrushKind::Box;
        edit.position = 0.5 * (low + high);
        edit.halfSize = 0.5 * (high - low);
        return edit;
    }
    World m_world;
    PhysicsWorld m_physics;
    size_t m_pieces = 0;
};

/// A voxel of each building is taken away, so that all are analysed.
TEST_F(DistrictWorld, StandsUnderItsOwnWeight) {
    Edits edits;
    for (const char* name : {"museum", "barn", "petrol station", "steel bridge", "tower", "shell of a building",
                             "quay house 1", "quay house 4", "shop", "house", "skeleton"}) {
        const Shape& each = m_world.shapes().at(shape(name));
        glm::ivec3 top(-1);
        each.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int cell) {
                const glm::ivec3 at = position * kBrickSize + voxelInBrick(cell);
                if (at.y > top.y) top = at;
            });
        });
        const glm::dvec3 middle = shapeToWorld(m_world, shape(name)).transformPoint((glm::dvec3(top) + 0.5) * 0.1);
        edits.push_back(cut(middle - 0.04, middle + 0.04));
    }
    m_world.bodies().forEach([&](BodyHandle handle, const Body& each) {
        if (!each.isStatic) edits.push_back(ImpulseEdit{handle, each.pose.position, {0.0, -1e-3, 0.0}});
    });
    step(240, edits);
    EXPECT_LE(m_pieces, 2u) << "only what hung on a voxel that was taken away";
    for (const char* name : {"petrol pump 1", "barn door left", "house door", "quay house 3 door", "bale 7", "lift",
                             "jib", "amphora", "pedestal 3", "bridge car", "stack of boards"}) {
        const LevelBody* before = nullptr;
        for (const LevelBody& each : district().bodies)
            if (!each.shapes.empty() && each.shapes[0].name == name) before = &each;
        ASSERT_TRUE(before) << name;
        EXPECT_LT(glm::distance(m_world.bodies().at(body(name)).pose.position, before->pose.position), 0.06) << name;
    }
}

TEST_F(DistrictWorld, BridgeCablesAndLiftFailWhereTheyAreCut) {
    EXPECT_EQ(groupsOut("power line"), 0);
    step(1, {cut({84.0 + 19.0, 4.0, 55.0}, {84.0 + 19.4, 7.0, 56.2}),  // a cable between the second pole and the third
             cut({68.0, -1.3, 96.4}, {80.0, 8.0, 96.9}), cut({68.0, -1.3, 111.4}, {80.0, 8.0, 111.9})});
    step(240);
    double lowest = 0.0;
    uint64_t most = 0;
    m_world.shapes().forEach([&](ShapeHandle, const Shape& each) {
        if (m_world.bodies().at(each.body).isStatic || each.grid.voxelCount() < most) return;
        const glm::dvec3 at = m_world.bodies().at(each.body).pose.position;
        if (at.x > 65.0 && at.x < 82.0 && at.z > 90.0 && at.z < 113.0) most = each.grid.voxelCount(), lowest = at.y;
    });
    EXPECT_GT(most, 20'000u);
    EXPECT_LT(lowest, -2.2 - 0.3) << "it lies in the canal";
    EXPECT_EQ(groupsOut("power line"), 3);

    JointHandle guide;
    m_world.joints().forEach([&](JointHandle handle, const Joint& joint) {
        if (joint.name == "lift guide") guide = handle;
    });
    const double low = m_world.bodies().at(body("lift")).pose.position.y;
    step(180, {SetJointMotorEdit{guide, {MotorMode::Speed, 1.6, 3.0e4}}});
    EXPECT_NEAR(m_world.bodies().at(body("lift")).pose.position.y - low, 4.8, 0.2);
    const double high = m_world.bodies().at(body("lift")).pose.position.y;
    step(120, {SetJointMotorEdit{guide, {MotorMode::Speed, 0.0, 3.0e4}}});
    EXPECT_NEAR(m_world.bodies().at(body("lift")).pose.position.y, high, 0.1);
    EXPECT_EQ(groupsOut("lift power"), 0);
    step(30, {cut({90.4, 0.4, 28.7}, {90.65, 0.8, 29.1})});  // the wire at its lower end
    EXPECT_EQ(groupsOut("lift power"), 1);
}

}  // namespace
}  // namespace rubble
