// The ray walks in GLSL against exact slabs and against the C++ walk in double.
#include <cmath>

#include "render/gl/framebuffer.h"
#include "runtime/voxel/ray_walk.h"
#include "tests/render/gbuffer_fixture.h"
#include "tests/runtime/voxel/ray_classes.h"

namespace rubble {
namespace {

using namespace ray_classes;

constexpr int kRaysPerGrid = 5000;
int gridsPerClass() {
    return std::getenv("RUBBLE_LONG") ? 2000 : 20;
}

/// The ray as the shader gets it, in floats. The exact answer is for these floats.
CellRay inFloat(const CellRay& ray) {
    return {glm::dvec3(glm::vec3(ray.origin)), glm::dvec3(glm::vec3(ray.direction)), double(float(ray.tMax))};
}

/// The textures that rays are read from and hits are written to.
class RayTextures {
public:
    explicit RayTextures(int count)
        : m_size(count, 1), m_origins(GL_RGBA32F, m_size), m_directions(GL_RGBA32F, m_size) {}
    void upload(const std::vector<CellRay>& rays) {
        std::vector<glm::vec4> origins, directions;
        for (const CellRay& ray : rays) {
            origins.emplace_back(glm::vec3(ray.origin), float(ray.tMax));
            directions.emplace_back(glm::vec3(ray.direction), 0.0f);
        }
        m_origins.upload(origins.data());
        m_directions.upload(directions.data());
    }
    void bind(const Program& program) const {
        program.set("uOrigins", m_origins);
        program.set("uDirections", m_directions);
    }
    glm::ivec2 size() const { return m_size; }

private:
    glm::ivec2 m_size;
    Texture m_origins, m_directions;
};

struct ShaderHit {
    glm::ivec4 cell;
    glm::vec4 normalT;
};

class VoxelWalkTest : public GBufferTest {
protected:
    std::vector<ShaderHit> trace(const VoxelGrid& grid, const std::vector<CellRay>& list) {
        Scene scene;
        TestScene made;
        made.add(grid, {}, testPalette());
        scene.apply(made.take());
        scene.beginFrame(1.0f, {});
        const Program& program = shaders->load("../tests/render/shaders/rays.frag");
        EXPECT_TRUE(program) << shaders->errors().front();
        rays.upload(list);
        Framebuffer framebuffer({&cells, &normals});
        framebuffer.begin();
        program.use();
        scene.bodies().bind(program);
        rays.bind(program);
        context(scene).drawTriangle();
        std::vector<glm::ivec4> cell(list.size());
        glBindTexture(GL_TEXTURE_2D, cells.name());
        glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA_INTEGER, GL_INT, cell.data());
        const std::vector<glm::vec4> normal = read(normals);
        std::vector<ShaderHit> hits;
        for (size_t i = 0; i < list.size(); ++i) hits.push_back({cell[i], normal[i]});
        return hits;
    }
    RayTextures rays{kRaysPerGrid};
    Texture cells{GL_RGBA32I, rays.size()}, normals{GL_RGBA32F, rays.size()};
};

/// A float holds a position to 2^-24 of its distance; crossings and positions are rounded a few times.
void checkHit(const VoxelGrid& grid, const CellRay& ray, const ShaderHit& hit) {
    if (!isFinite(ray)) {
        ASSERT_EQ(hit.cell.w, 0) << "a hit from a NaN or an infinity";
        return;
    }
    const double extent = std::max({std::fabs(ray.origin.x), std::fabs(ray.origin.y), std::fabs(ray.origin.z), 16.0});
    const double slack = extent * 0x1p-20, length = glm::length(ray.direction);
    const Slabs slabs(ray);
    const long double pierced = firstPierced(grid, ray, slabs, std::max(1e-4, slack));
    if (!hit.cell.w) {
        ASSERT_EQ(pierced, HUGE_VALL) << "missed a pierced voxel";
        return;
    }
    const glm::ivec3 cell(hit.cell);
    ASSERT_TRUE(grid.at(cell));
    ASSERT_LE(hit.cell.w, 3 * kSize + 3) << "steps";
    const double t = hit.normalT.w;
    ASSERT_LE(t * length, double(pierced) * length + 2 * slack) << "an earlier voxel was pierced";
    for (int a = 0; a < 3; ++a) {
        const double p = ray.origin[a] + ray.direction[a] * t;
        ASSERT_GE(p, cell[a] - slack) << "axis " << a;
        ASSERT_LE(p, cell[a] + 1 + slack) << "axis " << a;
    }
    if (hit.normalT.x != 0 || hit.normalT.y != 0 || hit.normalT.z != 0) {
        ASSERT_LT(glm::dot(glm::dvec3(hit.normalT), ray.direction), 0.0) << "a face seen from behind";
    }
}

class VoxelWalkClasses : public VoxelWalkTest, public testing::WithParamInterface<int> {};

TEST_P(VoxelWalkClasses, AgreesWithExactSlabs) {
    const RayClass rayClass = RayClass(GetParam());
    Random random(11, uint64_t(GetParam()));
    int hits = 0;
    for (int g = 0; g < gridsPerClass(); ++g) {
        const VoxelGrid grid = randomGrid(random, 1 << random.between(1, 9));
        std::vector<CellRay> list;
        for (int i = 0; i < kRaysPerGrid; ++i) list.push_back(inFloat(drawRay(rayClass, random)));
        const std::vector<ShaderHit> found = trace(grid, list);
        for (size_t i = 0; i < list.size(); ++i) {
            checkHit(grid, list[i], found[i]);
            ASSERT_FALSE(HasFatalFailure())
                << text(list[i]) << " cell " << found[i].cell.x << ' ' << found[i].cell.y << ' ' << found[i].cell.z
                << " w " << found[i].cell.w << " t " << found[i].normalT.w;
            hits += found[i].cell.w > 0;
        }
    }
    if (rayClass == RayClass::NotANumber)
        EXPECT_EQ(hits, 0);
    else
        EXPECT_GT(hits, gridsPerClass() * kRaysPerGrid / 100);
}

INSTANTIATE_TEST_SUITE_P(Classes, VoxelWalkClasses, testing::Range(0, int(RayClass::kCount)),
                         [](const auto& tested) { return kClassNames[size_t(tested.param)]; });

class ShadowTraceTest : public VoxelWalkTest {
protected:
    /// The same cells as a volume of shadow bricks whose cell 0 is `low` bricks from the origin.
    static std::vector<ShadowPatch> patchesOf(const VoxelGrid& grid, glm::ivec3 low) {
        std::vector<ShadowPatch> patches;
        const glm::ivec3 count = (grid.size() + 15) / 16;
        for (int i = 0; i < count.x * count.y * count.z; ++i) {
            const glm::ivec3 brick(i % count.x, i / count.x % count.y, i / count.x / count.y);
            ShadowWords cells{};
            for (int c = 0; c < 4096; ++c) {
                const glm::ivec3 in(c & 15, c >> 4 & 15, c >> 8);
                if (!grid.at(brick * 16 + in)) continue;
                const glm::ivec3 word = in >> 2, bit = in & 3;
                cells[size_t(word.x + word.y * 4 + word.z * 16)] |= uint64_t(1) << (bit.x + bit.y * 4 + bit.z * 16);
            }
            if (ShadowBrickRef content = makeShadowBrick(cells)) patches.push_back({low + brick, std::move(content)});
        }
        return patches;
    }
    std::vector<glm::vec4> traceShadow(Scene& scene, const std::vector<CellRay>& list) {
        View view;
        view.size = {16, 16};
        draw(scene, view);
        const Program& program = shaders->load("../tests/render/shaders/shadow_rays.frag");
        EXPECT_TRUE(program) << shaders->errors().front();
        rays.upload(list);
        Framebuffer framebuffer({&normals});
        framebuffer.begin();
        program.use();
        scene.bindShadow(program);
        rays.bind(program);
        context(scene).drawTriangle();
        return read(normals);
    }
};

TEST_F(ShadowTraceTest, MatchesTheDoublePrecisionWalk) {
    Random random(5);
    VoxelGrid grid({150, 90, 130});
    {
        GridWriter writer(grid);
        for (int i = 0; i < 30000; ++i) {
            const glm::ivec3 at(random.below(150), random.below(90), random.below(130));
            if ((at.x >> 5) + (at.y >> 5) != 3) writer.set(at, 1);
        }
        fillBox(writer, {40, 3, 40}, {90, 4, 90}, 1);
    }
    const glm::ivec3 low(-5, 0, -3);
    Scene scene;
    FrameSnapshot snapshot;
    snapshot.shadow = patchesOf(grid, low);
    scene.apply(std::move(snapshot));
    std::vector<CellRay> list;
    for (int i = 0; i < kRaysPerGrid; ++i) {
        const glm::dvec3 start = drawPoint(random, -20.0, 160.0);
        const glm::dvec3 direction = i % 5 ? drawDirection(random) : glm::dvec3(i % 3 == 0, i % 3 == 1, i % 3 == 2);
        list.push_back(
            inFloat({(start + glm::dvec3(low * 16)) * 0.1, direction, ray_classes::draw(random, 1.0, 20.0)}));
    }
    const auto found = traceShadow(scene, list);
    int differ = 0, hits = 0;
    for (size_t i = 0; i < list.size(); ++i) {
        const CellHit expected =
            walkRay(grid, {list[i].origin * 10.0 - glm::dvec3(low * 16), list[i].direction, list[i].tMax * 10.0});
        hits += expected.hit;
        const bool same =
            bool(found[i].y) == expected.hit && (!expected.hit || std::abs(found[i].x * 10.0 - expected.t) < 1e-3);
        differ += !same;
    }
    EXPECT_GT(hits, kRaysPerGrid / 10);
    EXPECT_LE(differ, 5) << "of " << kRaysPerGrid << " rays, grazing ones";
}

TEST_F(ShadowTraceTest, PatchesChangeOnlyTheirBricks) {
    VoxelGrid grid({64, 64, 64});
    { GridWriter(grid).set({20, 20, 20}, 1); }
    Scene scene;
    FrameSnapshot first;
    first.shadow = patchesOf(grid, {0, 0, 0});
    scene.apply(std::move(first));
    const std::vector<CellRay> list(kRaysPerGrid, CellRay{{0.05, 2.05, 2.05}, {1, 0, 0}, 10.0});
    EXPECT_NEAR(traceShadow(scene, list)[0].x, 1.95, 1e-5);

    FrameSnapshot second;  // a far brick makes the directory grow, on both sides
    second.shadow = patchesOf(grid, {-40, -9, 30});
    scene.apply(std::move(second));
    EXPECT_NEAR(traceShadow(scene, list)[0].x, 1.95, 1e-5);
    EXPECT_LT(uploaded, 1'000'000u) << "the directory";

    FrameSnapshot third;
    third.shadow.push_back({{1, 1, 1}, nullptr});
    scene.apply(std::move(third));
    EXPECT_EQ(traceShadow(scene, list)[0].y, 0.0f);
    EXPECT_LT(uploaded, 29u * 29 * 29 * 16) << "one brick was removed: its neighbourhood";
}

}  // namespace
}  // namespace rubble
