#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>
#include <vector>

#include "tests/abi/create_fixture.h"
#include "tests/support/temp_folder.h"

namespace rubble {
namespace {

using Vertices = std::vector<rubble_mesh_vertex>;
using Meshes = std::map<std::tuple<int32_t, int32_t, int32_t>, Vertices>;

class AbiBricks : public AbiCreate {
protected:
    Vertices mesh(rubble_shape shape, const rubble_brick& brick) {
        const int32_t place[3] = {brick.x, brick.y, brick.z};
        Vertices out(RUBBLE_MAX_BRICK_VERTICES);
        uint32_t count = 0;
        EXPECT_EQ(api()->mesh_brick(m_world, shape, place, out.data(), uint32_t(out.size()), &count), RUBBLE_OK)
            << api()->get_last_error();
        out.resize(count);
        return out;
    }
    rubble_result list(rubble_shape shape, uint32_t what, uint64_t& version, std::vector<rubble_brick>& out) {
        auto changes = sized<rubble_brick_changes>();
        changes.shape = shape, changes.what = what, changes.since = version;
        uint32_t count = 0;
        rubble_result result = api()->get_changed_bricks(m_world, &changes, &version, nullptr, 0, &count);
        if (result != RUBBLE_OK) return result;
        out.resize(count);
        return api()->get_changed_bricks(m_world, &changes, &version, out.data(), count, &count);
    }
    /// Brings a host's meshes of a shape up to date, as it would.
    void update(rubble_shape shape, uint64_t& version, Meshes& meshes) {
        std::vector<rubble_brick> bricks;
        if (list(shape, RUBBLE_BRICKS_MESHES, version, bricks) == RUBBLE_ERROR_STALE) {
            version = 0, meshes.clear(), ++m_reloads;
            ASSERT_EQ(list(shape, RUBBLE_BRICKS_MESHES, version, bricks), RUBBLE_OK);
        }
        for (const rubble_brick& brick : bricks) {
            ++m_meshed;
            const std::tuple place(brick.x, brick.y, brick.z);
            if (brick.is_empty)
                meshes.erase(place);
            else
                meshes[place] = mesh(shape, brick);
        }
    }
    static bool same(const Meshes& a, const Meshes& b) {
        const auto equal = [](const Vertices& x, const Vertices& y) {
            return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
        };
        return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin(), [&](const auto& x, const auto& y) {
                   return x.first == y.first && equal(x.second, y.second);
               });
    }
    rubble_shape makeWall() {
        auto settings = shapeOn(make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 40);
        settings.size[2] = 16;
        const rubble_shape wall = make(settings);
        step();
        return wall;
    }
    int m_reloads = 0, m_meshed = 0;
};

TEST_F(AbiBricks, MeshesThatFollowChangesEqualRebuiltOnes) {
    const rubble_shape wall = makeWall();
    uint64_t version = 0;
    Meshes meshes;
    update(wall, version, meshes);
    EXPECT_EQ(m_meshed, 5 * 5 * 2);
    for (int i = 0; i < 12; ++i) {
        auto carve = sized<rubble_carve>();
        carve.position[0] = 10.0 + 0.3 * i, carve.position[1] = 0.5 + 0.25 * i, carve.position[2] = 0.2 * (i % 8);
        carve.radii[0] = carve.radii[1] = carve.radii[2] = 0.35, carve.shape = wall;
        auto paint = sized<rubble_paint>();
        paint.position[0] = 10.0 + 0.2 * i, paint.position[1] = 3.0, paint.position[2] = 0.0;
        paint.color[0] = uint8_t(i % 2 * 255), paint.radius = 0.3;
        ASSERT_EQ(i % 3 ? api()->carve(m_world, &carve) : api()->paint(m_world, &paint), RUBBLE_OK);
        step();
        m_meshed = 0, m_reloads = 0;
        update(wall, version, meshes);
        EXPECT_GT(m_meshed, 0) << i;
        EXPECT_EQ(m_reloads, 0) << i;
        uint64_t from = 0;
        Meshes rebuilt;
        update(wall, from, rebuilt);
        EXPECT_TRUE(same(meshes, rebuilt)) << i;
        EXPECT_EQ(from, version);
    }
    std::vector<rubble_brick> none;
    step();
    uint64_t now = version;
    ASSERT_EQ(list(wall, RUBBLE_BRICKS_MESHES, now, none), RUBBLE_OK);
    EXPECT_TRUE(none.empty());
}

TEST_F(AbiBricks, SootOfAnExplosionLeavesTheMeshesThatHaveNone) {
    for (const bool isLayer : {false, true}) {
        auto options = sized<rubble_settings>();
        ASSERT_EQ(api()->get_settings(m_world, &options), RUBBLE_OK);
        options.flags |= isLayer ? RUBBLE_SETTING_PAINT_LAYER : 0;
        ASSERT_EQ(api()->set_settings(m_world, &options), RUBBLE_OK) << api()->get_last_error();
        auto settings = shapeOn(make(bodyAt(20.0, isLayer ? 30.0 : 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 256);
        settings.size[1] = 128, settings.size[2] = 8;
        const rubble_shape wall = make(settings);
        step();
        uint64_t version = 0;
        Meshes meshes;
        update(wall, version, meshes);
        EXPECT_EQ(m_meshed, 32 * 16);
        auto explosion = sized<rubble_explosion>();
        explosion.position[0] = 32.0, explosion.position[1] = isLayer ? 36.0 : 6.0, explosion.size = 0.5;
        ASSERT_EQ(api()->explode(m_world, &explosion), RUBBLE_OK);
        step();
        m_meshed = m_reloads = 0;
        update(wall, version, meshes);
        EXPECT_EQ(m_reloads, 0);
        EXPECT_GT(m_meshed, 8);
        EXPECT_LT(m_meshed, 32 * 16 / 4);
        RecordProperty(isLayer ? "layer" : "palette", m_meshed);
        uint64_t from = 0;
        Meshes rebuilt;
        update(wall, from, rebuilt);
        EXPECT_TRUE(same(meshes, rebuilt));
        m_meshed = 0;
    }
}

TEST_F(AbiBricks, ColoursThatChangeMakeTheMeshesStaleThatHaveThem) {
    const rubble_shape wall = makeWall();
    ASSERT_EQ(api()->set_undo_limit(m_world, 8), RUBBLE_OK);
    auto box = sized<rubble_voxel_box>();
    box.shape = wall, box.low[0] = 17, box.low[1] = 17, box.low[2] = 9;
    std::fill_n(box.size, 3, 2);
    const std::vector<uint8_t> ten(8, 10);
    ASSERT_EQ(api()->write_voxels(m_world, &box, ten.data(), ten.size()), RUBBLE_OK) << api()->get_last_error();
    step();
    uint64_t version = 0;
    Meshes meshes;
    update(wall, version, meshes);
    const auto expectStale = [&](const char* what, int stale) {
        step();
        m_meshed = m_reloads = 0;
        update(wall, version, meshes);
        EXPECT_EQ(m_reloads, 0) << what;
        EXPECT_EQ(m_meshed, stale) << what;
        uint64_t from = 0;
        Meshes rebuilt;
        update(wall, from, rebuilt);
        EXPECT_TRUE(same(meshes, rebuilt)) << what;
    };
    const auto setEntry = [&](uint32_t index, uint8_t opacity) {
        auto range = sized<rubble_palette_range>();
        range.shape = wall, range.first = index, range.count = 1;
        rubble_palette_entry entry = {};
        ASSERT_EQ(api()->get_palette(m_world, &range, &entry), RUBBLE_OK) << api()->get_last_error();
        entry.color[0] ^= 128, entry.opacity = opacity, entry.emission = 4.0;
        ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK);
        ASSERT_EQ(api()->set_palette(m_world, &range, &entry), RUBBLE_OK) << api()->get_last_error();
    };
    setEntry(200, 255);
    expectStale("an entry that no voxel has", 0);
    setEntry(10, 255);
    expectStale("one that one brick has, with those beside it", 6);
    setEntry(10, 100);
    expectStale("one that becomes transparent", 6);
    ASSERT_EQ(api()->undo(m_world), RUBBLE_OK);
    expectStale("an undo", 6);
    auto brighter = sized<rubble_shape_change>();
    brighter.shape = wall, brighter.fields = RUBBLE_SHAPE_EMISSION, brighter.emission = 2.0;
    ASSERT_EQ(api()->set_shape(m_world, &brighter), RUBBLE_OK);
    expectStale("light of the entries that glow", 6);
    setEntry(6, 255);
    expectStale("one that all have", 50);
}

/// A static wall that is cut and moved a metre at a time, and a host's meshes of it.
class AbiMovedWall : public AbiBricks {
protected:
    void SetUp() override {
        AbiBricks::SetUp();
        m_wall = makeWall();
        ASSERT_EQ(api()->set_undo_limit(m_world, 8), RUBBLE_OK);
        update(m_wall, m_version, m_meshes);
        m_change.body = state(m_wall).body, m_change.position[0] = 10.0, m_change.rotation[3] = 1.0;
        m_carve.radii[0] = m_carve.radii[1] = m_carve.radii[2] = 0.15;
    }
    void move(uint32_t fields = 0) {
        m_change.fields = RUBBLE_SET_POSE | fields, m_change.position[0] += 1.0;
        ASSERT_EQ(api()->set_body(m_world, &m_change), RUBBLE_OK) << api()->get_last_error();
    }
    void cut() {
        m_carve.position[0] = m_change.position[0] + 2.0, m_carve.position[1] += 0.5, m_carve.position[2] = 0.4;
        ASSERT_EQ(api()->carve(m_world, &m_carve), RUBBLE_OK) << api()->get_last_error();
    }
    void mark() { ASSERT_EQ(api()->add_undo_mark(m_world), RUBBLE_OK); }
    void undo() { ASSERT_EQ(api()->undo(m_world), RUBBLE_OK); }
    /// How many bricks are meshed after a step. All are dropped where the wall is told to be another shape, and only
    /// then.
    void expectMeshed(const char* what, int low, int high) {
        step();
        auto events = sized<rubble_events>();
        ASSERT_EQ(api()->get_events(m_world, &events), RUBBLE_OK);
        m_meshed = m_reloads = 0;
        update(m_wall, m_version, m_meshes);
        EXPECT_GE(m_meshed, low) << what;
        EXPECT_LE(m_meshed, high) << what;
        EXPECT_EQ(m_reloads, int(events.shapes_destroyed_count)) << what;
        EXPECT_EQ(m_reloads, int(events.shapes_created_count)) << what;
        uint64_t from = 0;
        Meshes rebuilt;
        update(m_wall, from, rebuilt);
        EXPECT_TRUE(same(m_meshes, rebuilt)) << what;
    }
    rubble_shape m_wall = 0;
    uint64_t m_version = 0;
    Meshes m_meshes;
    rubble_body_change m_change = sized<rubble_body_change>();
    rubble_carve m_carve = sized<rubble_carve>();
};

TEST_F(AbiMovedWall, KeepsItsMeshes) {
    move();
    expectMeshed("moved", 0, 0);
    move(RUBBLE_SET_DYNAMIC);
    expectMeshed("free", 0, 0);
    move(RUBBLE_SET_STATIC);
    expectMeshed("static", 0, 0);
    move(), cut();
    expectMeshed("cut where it is then", 1, 16);
    mark(), move();
    expectMeshed("moved again", 0, 0);
    undo();
    expectMeshed("and back", 0, 0);
}

TEST_F(AbiMovedWall, IsAnotherShapeToMeshesIfItWasCutBefore) {
    mark();
    cut(), move();
    expectMeshed("cut where it was", 1, 50);
    move(), cut(), move();
    expectMeshed("cut on its way", 1, 50);
    cut(), move(), move();
    expectMeshed("cut, then moved twice", 1, 50);
    undo();
    expectMeshed("undone", 1, 50);
    auto resize = sized<rubble_resize>();
    resize.shape = m_wall, resize.size[0] = 48, resize.size[1] = 40, resize.size[2] = 16;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK) << api()->get_last_error();
    move();
    expectMeshed("resized, then moved", 50, 50);
    mark(), cut();
    expectMeshed("cut", 1, 16);
    undo(), move();
    expectMeshed("undone, then moved", 1, 50);
}

TEST_F(AbiBricks, VerticesHavePlaceColourAndMaterial) {
    auto settings = shapeOn(make(bodyAt(10.0, 0.0, RUBBLE_BODY_STATIC)), RUBBLE_SHAPE_BOX, 3);
    settings.voxel_size = 0.5;
    const rubble_shape box = make(settings);
    step();
    const Vertices vertices = mesh(box, {0, 0, 0, 0});
    ASSERT_EQ(vertices.size(), 24u) << "a rectangle a side";
    double area = 0.0;
    for (size_t i = 0; i < 24; i += 4) {
        double edges[2][3], normal[3];
        for (int a = 0; a < 3; ++a) {
            edges[0][a] = double(vertices[i + 1].position[a] - vertices[i].position[a]);
            edges[1][a] = double(vertices[i + 3].position[a] - vertices[i].position[a]);
        }
        for (int a = 0; a < 3; ++a) {
            const int b = (a + 1) % 3, c = (a + 2) % 3;
            normal[a] = edges[0][b] * edges[1][c] - edges[0][c] * edges[1][b];
            area += normal[a] * double(vertices[i].normal[a]);
        }
        EXPECT_EQ(vertices[i].material, 6);
        EXPECT_EQ(vertices[i].palette_index, 6);
        EXPECT_EQ(vertices[i].color[3], 255);
        EXPECT_EQ(vertices[i].emission, 0.0f);
    }
    EXPECT_NEAR(area, 6 * 1.5 * 1.5, 1e-6) << "every normal looks outward";
}

TEST_F(AbiBricks, AVersionThatTheShapeNoLongerKnowsIsStale) {
    const rubble_shape wall = makeWall();
    std::vector<rubble_brick> bricks;
    uint64_t version = 7;
    EXPECT_EQ(list(wall, RUBBLE_BRICKS_VOXELS, version, bricks), RUBBLE_ERROR_STALE) << "nobody had asked";
    version = 0;
    ASSERT_EQ(list(wall, RUBBLE_BRICKS_VOXELS, version, bricks), RUBBLE_OK);
    EXPECT_EQ(bricks.size(), 50u);
    auto resize = sized<rubble_resize>();
    resize.shape = wall, resize.size[0] = 40, resize.size[1] = 48, resize.size[2] = 16;
    ASSERT_EQ(api()->resize_shape(m_world, &resize), RUBBLE_OK);
    step();
    expectRefused(list(wall, RUBBLE_BRICKS_VOXELS, version, bricks), RUBBLE_ERROR_STALE, "ask with 0");
    uint64_t again = 0;
    ASSERT_EQ(list(wall, RUBBLE_BRICKS_VOXELS, again, bricks), RUBBLE_OK);
    EXPECT_GT(again, 1u);
    again += 1;
    EXPECT_EQ(list(wall, RUBBLE_BRICKS_VOXELS, again, bricks), RUBBLE_ERROR_STALE) << "it is not yet";
    ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
    EXPECT_EQ(list(wall, RUBBLE_BRICKS_VOXELS, version, bricks), RUBBLE_ERROR_STALE);
    const rubble_shape table = shapes()[0].shape;
    EXPECT_EQ(list(table, RUBBLE_BRICKS_VOXELS, version, bricks), RUBBLE_ERROR_STALE) << "another world";
}

TEST_F(AbiBricks, AVersionThatIsAskedForBeforeTheFirstStepOfALevelHolds) {
    const TempFolder folder;
    const std::string game = folder.path() / "wall.rubblesave";
    makeWall();
    ASSERT_EQ(api()->save_game(m_world, game.c_str()), RUBBLE_OK) << api()->get_last_error();
    for (const bool isGame : {false, true}) {
        ASSERT_EQ(
            isGame ? api()->load_game(m_world, game.c_str()) : api()->load_level(m_world, s_level.c_str(), nullptr),
            RUBBLE_OK)
            << api()->get_last_error();
        const rubble_shape shape = shapes().back().shape;
        uint64_t version = 0;
        std::vector<rubble_brick> bricks;
        ASSERT_EQ(list(shape, RUBBLE_BRICKS_MESHES, version, bricks), RUBBLE_OK);
        EXPECT_FALSE(bricks.empty());
        step();
        EXPECT_EQ(list(shape, RUBBLE_BRICKS_MESHES, version, bricks), RUBBLE_OK) << api()->get_last_error();
        EXPECT_TRUE(bricks.empty()) << "nothing was edited";
        uint64_t before = version;
        ASSERT_EQ(api()->load_level(m_world, s_level.c_str(), nullptr), RUBBLE_OK);
        EXPECT_EQ(list(shapes().back().shape, RUBBLE_BRICKS_MESHES, before, bricks), RUBBLE_ERROR_STALE)
            << "it is of another world";
    }
}

TEST_F(AbiBricks, WrongArgumentsAreRefused) {
    const rubble_shape wall = makeWall();
    const int32_t far[3] = {-2147483647 - 1, 2147483647, 0};
    rubble_mesh_vertex vertex = {};
    uint32_t count = 9;
    EXPECT_EQ(api()->mesh_brick(m_world, wall, far, nullptr, 0, &count), RUBBLE_OK);
    EXPECT_EQ(count, 0u);
    const int32_t first[3] = {};
    expectRefused(api()->mesh_brick(m_world, wall, first, &vertex, 1, &count), RUBBLE_ERROR_CAPACITY, "rows");
    EXPECT_GT(count, 4u);
    expectRefused(api()->mesh_brick(m_world, wall, nullptr, nullptr, 0, &count), RUBBLE_ERROR_NULL, "brick");
    expectRefused(api()->mesh_brick(m_world, m_world, first, nullptr, 0, &count), RUBBLE_ERROR_STALE, "shape");
    auto changes = sized<rubble_brick_changes>();
    uint64_t version = 0;
    changes.shape = wall, changes.what = 2;
    expectRefused(api()->get_changed_bricks(m_world, &changes, &version, nullptr, 0, &count), RUBBLE_ERROR_ARGUMENT,
                  "changes->what is 2");
    changes.what = 0;
    expectRefused(api()->get_changed_bricks(m_world, &changes, nullptr, nullptr, 0, &count), RUBBLE_ERROR_NULL,
                  "version");
}

}  // namespace
}  // namespace rubble
