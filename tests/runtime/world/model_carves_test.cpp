// A thousand random carves of real models, each compared with a slow and simple reference.
#include <gtest/gtest.h>

#include <filesystem>
#include <glm/mat3x3.hpp>

#include "runtime/assets/assets.h"
#include "runtime/destruction/carve.h"
#include "runtime/world/edits/resolve_brush.h"
#include "tests/runtime/world/worlds.h"
#include "tests/support/models.h"

namespace rubble {
namespace {

using Vector = glm::dvec3;
using CellSets = std::vector<std::vector<size_t>>;
constexpr int kCarves = 1000;

struct Momentum {
    double mass = 0.0, scale = 0.0;
    Vector linear{0.0}, angular{0.0};

    void add(const Pose& pose, const MassProperties& part, Vector velocity, Vector angularVelocity) {
        const std::array<double, 6>& t = part.inertia;
        const glm::dmat3 rotation = glm::mat3_cast(pose.rotation);
        const glm::dmat3 inertia =
            rotation * glm::dmat3(t[0], t[3], t[5], t[3], t[1], t[4], t[5], t[4], t[2]) * glm::transpose(rotation);
        const Vector center = pose.transformPoint(part.center);
        mass += part.mass;
        linear += part.mass * velocity;
        angular += part.mass * glm::cross(center, velocity) + inertia * angularVelocity;
        scale += part.mass * (glm::length(velocity) + glm::length(angularVelocity) * (1.0 + glm::length(center)));
    }
};

/// The components that come off, in the order of their first cell.
CellSets expectedPieces(const test::PlainGrid& grid, const Shape& shape, bool isStatic) {
    CellSets sets = test::floodFill(grid);
    const auto isHeld = [&](const std::vector<size_t>& set) {
        return std::any_of(set.begin(), set.end(), [&](size_t i) {
            return std::any_of(shape.anchors.begin(), shape.anchors.end(), [&](const CellBox& box) {
                return glm::all(glm::greaterThanEqual(grid.cell(i), box.low)) &&
                       glm::all(glm::lessThan(grid.cell(i), box.high));
            });
        });
    };
    const size_t all = sets.size();
    if (isStatic) std::erase_if(sets, isHeld);
    if (!sets.empty() && (!isStatic || sets.size() == all))
        sets.erase(std::max_element(sets.begin(), sets.end(),
                                    [](const auto& a, const auto& b) { return a.size() < b.size(); }));
    return sets;
}

class ModelCarves {
public:
    explicit ModelCarves(const std::filesystem::path& file, uint64_t seed) : m_random(seed) {
        Result<Level> level = importVox(file, {});
        EXPECT_TRUE(level) << (level ? "" : level.error());
        if (!level) return;
        for (size_t i = seed % 2; i < level->bodies.size(); i += 2) {  // every other body is free and spins
            LevelBody& body = level->bodies[i];
            const float x = m_random.unit(), y = m_random.unit(), z = m_random.unit();
            body.isStatic = false;
            body.velocity = {5.0f * x, -3.0f * y, z};
            body.angularVelocity = {-2.0f * y, 3.0f * z, 4.0f * x};
            body.pose.rotation = glm::normalize(glm::dquat(1.0, x, y, z) * body.pose.rotation);
        }
        WorldSettings settings = m_world.settings();
        settings.debris.awakeBodies = 1'000'000;  // nothing despawns
        m_world.setSettings(settings);
        m_world.load(*level);
        m_world.applyEdits({});
        m_isLoaded = true;
    }

    void carveOnce() {
        if (!m_isLoaded || m_world.shapes().size() == 0) return;
        const CarveEdit edit = randomCarve();
        const World before = m_world;
        const FrameChanges changes = m_world.applyEdits({edit});
        ASSERT_TRUE(voxelAccounting(m_world).balances());
        std::vector<ShapeHandle> cut = changes.carved;
        cut.insert(cut.end(), changes.shapesDestroyed.begin(), changes.shapesDestroyed.end());
        for (const ShapeHandle handle : cut) ASSERT_NO_FATAL_FAILURE(checkShape(before, edit, handle, changes));
        m_cuts += cut.size();
        m_pieces += changes.shapesCreated.size();
        checkMomentum(before, edit, changes);
    }

    size_t cuts() const { return m_cuts; }
    size_t pieces() const { return m_pieces; }

private:
    CarveEdit randomCarve() {
        std::vector<ShapeHandle> handles;
        m_world.shapes().forEach([&](ShapeHandle handle, const Shape&) { handles.push_back(handle); });
        // The largest of three shapes: pieces are cut too, but seldom small ones.
        ShapeHandle target = handles[m_random.below(uint32_t(handles.size()))];
        for (int i = 0; i < 2; ++i) {
            const ShapeHandle other = handles[m_random.below(uint32_t(handles.size()))];
            if (m_world.shapes().at(other).grid.voxelCount() > m_world.shapes().at(target).grid.voxelCount())
                target = other;
        }
        const Shape& shape = m_world.shapes().at(target);
        std::vector<glm::ivec3> bricks;
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
        const glm::ivec3 brick = bricks[m_random.below(uint32_t(bricks.size()))];
        const int x = m_random.between(0, 7), y = m_random.between(0, 7), z = m_random.between(0, 7);
        const Vector middle =
            shapeToWorld(m_world, target)
                .transformPoint((Vector(brick * 8 + glm::ivec3(x, y, z)) + 0.3) * double(shape.voxelSize));
        const double radius = shape.voxelSize * (1.0 + 9.0 * m_random.unit());
        CarveEdit edit = test::sphereCarve(middle, radius);
        edit.radii = {radius, 0.8 * radius, 0.6 * radius};
        const uint32_t kind = m_random.below(4);
        if (kind == 1) {
            edit.kind = BrushKind::Capsule;
            edit.end = middle + Vector(x - 4, y - 4, z - 4) * 0.3;
        } else if (kind == 2) {
            edit.kind = BrushKind::Box;
            edit.halfSize = Vector(8.0, 0.15, 8.0);
            edit.rotation = glm::normalize(glm::dquat(1.0, 0.1 * x, 0.1 * y, 0.1 * z));
        }
        return edit;
    }

    static CarveResult carvedCopy(const World& before, const CarveEdit& edit, ShapeHandle handle, VoxelGrid& grid) {
        const Shape& shape = before.shapes().at(handle);
        grid = shape.grid;
        CarveResult carved;
        carve(grid, resolveBrush(edit, shapeToWorld(before, handle), shape.voxelSize), *shape.palette,
              before.materials(), carved);
        return carved;
    }

    void checkShape(const World& before, const CarveEdit& edit, ShapeHandle handle, const FrameChanges& changes) {
        const Shape& was = before.shapes().at(handle);
        VoxelGrid grid;
        const CarveResult carved = carvedCopy(before, edit, handle, grid);
        ASSERT_GT(carved.voxels, 0u);
        const test::PlainGrid plain(grid);
        const CellSets expected = expectedPieces(plain, was, before.bodies().at(was.body).isStatic);
        MassMoments sum = carved.moments;
        uint64_t voxels = carved.voxels;
        size_t found = 0;
        for (const ShapeSplit& split : changes.splits) {
            if (split.parent != handle) continue;
            ASSERT_EQ(split.children.size(), expected.size());
            for (size_t i = 0; i < split.children.size(); ++i, ++found) {
                const Shape& child = m_world.shapes().at(split.children[i]);
                ASSERT_EQ(cellsOf(child.grid, split.parentOffset[i], plain), expected[i]);
                sum += child.moments.shifted(split.parentOffset[i]);
                voxels += child.grid.voxelCount();
            }
        }
        ASSERT_EQ(found, expected.size());
        if (const Shape* is = m_world.shapes().find(handle)) {
            sum += is->moments;
            voxels += is->grid.voxelCount();
            ASSERT_EQ(is->moments, gridMoments(is->grid, *is->palette, m_world.materials()));
        }
        ASSERT_EQ(sum, was.moments);
        ASSERT_EQ(voxels, was.grid.voxelCount());
    }

    static std::vector<size_t> cellsOf(const VoxelGrid& grid, glm::ivec3 offset, const test::PlainGrid& plain) {
        std::vector<size_t> cells;
        grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
            forEachVoxel(content->occupancy,
                         [&](int i) { cells.push_back(plain.index(offset + brick * 8 + voxelInBrick(i))); });
        });
        std::sort(cells.begin(), cells.end());
        return cells;
    }

    /// Sums over all free bodies: the carved bodies move as before, however a split divides them.
    void checkMomentum(const World& before, const CarveEdit& edit, const FrameChanges& changes) {
        Momentum expected, actual;
        before.bodies().forEach([&](BodyHandle handle, const Body& body) {
            if (body.isStatic) return;
            const Vector center = body.pose.transformPoint(bodyMass(before, handle).center);
            for (const ShapeHandle shapeHandle : body.shapes) {
                const Shape& shape = before.shapes().at(shapeHandle);
                const bool isCut =
                    std::find(changes.carved.begin(), changes.carved.end(), shapeHandle) != changes.carved.end() ||
                    std::find(changes.shapesDestroyed.begin(), changes.shapesDestroyed.end(), shapeHandle) !=
                        changes.shapesDestroyed.end();
                MassMoments moments = shape.moments;
                VoxelGrid grid;
                if (isCut) moments -= carvedCopy(before, edit, shapeHandle, grid).moments;
                const MassProperties part = massProperties(moments, shape.voxelSize);
                const Pose pose = shapeToWorld(before, shapeHandle);
                expected.add(
                    pose, part,
                    body.velocity + glm::cross(body.angularVelocity, pose.transformPoint(part.center) - center),
                    body.angularVelocity);
            }
        });
        m_world.bodies().forEach([&](BodyHandle handle, const Body& body) {
            const bool wasStatic = body.velocity == Vector(0.0) && body.angularVelocity == Vector(0.0);
            if (!body.isStatic && !wasStatic)
                actual.add(body.pose, bodyMass(m_world, handle), body.velocity, body.angularVelocity);
        });
        EXPECT_LE(glm::length(actual.linear - expected.linear), 1e-6 * expected.scale);
        EXPECT_LE(glm::length(actual.angular - expected.angular), 1e-6 * expected.scale);
    }

    World m_world;
    Random m_random;
    bool m_isLoaded = false;
    size_t m_cuts = 0, m_pieces = 0;
};

TEST(ModelCarves, AThousandCarvesMatchAFloodFill) {
    RUBBLE_REQUIRE_MODELS(modelPath(""));
    const auto files = modelPaths();
    size_t cuts = 0, pieces = 0;
    for (size_t i = 0; i < files.size() && !HasFatalFailure(); ++i) {
        SCOPED_TRACE(files[i].filename().string());
        ModelCarves model(files[i], i + 1);
        const int carves = kCarves / int(files.size()) + (i < kCarves % files.size());
        for (int carve = 0; carve < carves && !HasFatalFailure(); ++carve) {
            SCOPED_TRACE(testing::Message() << "carve " << carve);
            model.carveOnce();
        }
        cuts += model.cuts();
        pieces += model.pieces();
    }
    EXPECT_GT(cuts, size_t(kCarves / 2));
    EXPECT_GT(pieces, size_t(kCarves));
    RecordProperty("shapes_cut", int(cuts));
    RecordProperty("pieces", int(pieces));
    std::printf("%d carves cut %zu shapes; %zu pieces came off\n", kCarves, cuts, pieces);
}

}  // namespace
}  // namespace rubble
