#include "tests/benchmark/world_rays/demolition.h"

#include <time.h>

#include <algorithm>
#include <glm/gtc/quaternion.hpp>

namespace rubble::rays {
namespace {

double processorMs() {
    timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return double(time.tv_sec) * 1e3 + double(time.tv_nsec) * 1e-6;
}

LevelBody cube(int side, const LevelBody& like) {
    LevelBody body;
    LevelShape shape;
    shape.palette = like.shapes.front().palette;
    shape.grid = VoxelGrid(glm::ivec3(side));
    GridWriter writer(shape.grid);
    for (int i = 0; i < side * side * side; ++i) writer.set({i % side, i / side % side, i / side / side}, 1);
    writer.flush();
    body.shapes.push_back(std::move(shape));
    return body;
}

glm::dvec3 draw(Random& random, glm::dvec3 low, glm::dvec3 high) {
    glm::dvec3 out;
    for (int a = 0; a < 3; ++a) out[a] = low[a] + (high[a] - low[a]) * double(random.unit());
    return out;
}

}  // namespace

Demolition::Demolition(const RayScene& scene, int bodies) {
    m_low = glm::dvec3(scene.bits.low) * 0.1;
    m_high = glm::dvec3(scene.bits.low + scene.bits.cells()) * 0.1;
    m_high.y = std::min(m_high.y, m_low.y + 12.0);
    Level level = scene.level;
    const size_t before = level.bodies.size();
    for (int i = 0; i < bodies; ++i) {
        level.bodies.push_back(cube(m_random.between(8, 32), level.bodies.front()));
        level.bodies.back().pose.position = draw(m_random, m_low, m_high);
    }
    m_world.load(level);
    size_t index = 0;
    m_world.bodies().forEach([&](BodyHandle handle, const Body&) {
        if (index++ >= before) m_movers.push_back(handle);
    });
}

void Demolition::step(int carves, bool moving) {
    Edits edits;
    for (int i = 0; i < carves; ++i) {
        CarveEdit carve;
        carve.position = draw(m_random, m_low, m_high);
        const double radius = 0.2 + 0.6 * double(m_random.unit());
        carve.radii = {radius, radius, radius};
        edits.push_back(carve);
    }
    const FrameChanges changes = m_world.applyEdits(edits);
    std::vector<BodyPose> moved;
    for (const BodyHandle handle : m_movers) {
        const Body* body = moving ? m_world.bodies().find(handle) : nullptr;
        if (!body) continue;
        Pose pose = body->pose;
        pose.position = glm::clamp(pose.position + draw(m_random, glm::dvec3(-0.17), glm::dvec3(0.17)), m_low, m_high);
        const glm::dvec3 turn = draw(m_random, glm::dvec3(0.0), glm::dvec3(0.1));
        pose.rotation = glm::normalize(glm::dquat(1.0, turn.x, turn.y, turn.z) * pose.rotation);
        moved.push_back({handle, pose, {}, {}, false});
    }
    m_world.setPoses(moved);
    const double start = processorMs();
    m_worker.submit(changes, moved, m_world);
    m_times.push_back(processorMs() - start);
    for (const ShadowPatches& publication : m_worker.takePatches())
        for (const ShadowPatch& patch : publication.patches) {
            m_patches.push_back(patch);
            m_bricks[{patch.brick.x, patch.brick.y, patch.brick.z}] = patch.content;
        }
}

std::vector<ShadowPatch> Demolition::takePatches() {
    return std::exchange(m_patches, {});
}

std::vector<ShadowPatch> Demolition::patchesNow() const {
    std::vector<ShadowPatch> out;
    for (const auto& [key, content] : m_bricks) out.push_back({{key[0], key[1], key[2]}, content});
    return out;
}

std::vector<ShadowPatch> Demolition::patchesAtRest() const {
    std::vector<ShadowPatch> out = patchesNow();
    for (ShadowPatch& patch : out) {
        if (!patch.content) continue;
        ShadowWords cells;
        for (int i = 0; i < 64; ++i) cells[size_t(i)] = patch.content->cells(i);
        patch.content = makeShadowBrick(cells);
    }
    return out;
}

WorldBits Demolition::bits() const {
    return bitsOf(patchesNow());
}

double Demolition::workerMs(size_t steps) const {
    std::vector<double> last(m_times.end() - ptrdiff_t(std::min(m_times.size(), steps)), m_times.end());
    std::nth_element(last.begin(), last.begin() + ptrdiff_t(last.size() / 2), last.end());
    return last[last.size() / 2];
}

}  // namespace rubble::rays
