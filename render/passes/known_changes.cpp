#include "render/passes/known_changes.h"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <vector>

#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

constexpr float kKeptChange = 0.04f;  ///< relative: the longest history survives it (lib/known_changes.glsl)

/// The share of a light's change that is not known where passes/changed_lights.frag has sampled its direct light and
/// passes/light_offset.frag has found the mean of what came by bounces. By the errors of
/// tests/reference/ghost_test.cpp.
constexpr float kUnknownShare = 0.04f;

glm::vec3 cornerMetres(glm::ivec3 word, const Scene& scene) {
    return glm::vec3(glm::dvec3(word) * DirtyRegions::kWordMetres - scene.origin());
}

void addTexels(std::vector<glm::vec4>& texels, const LightGrid::Sent& sent, const Scene& scene) {
    texels.emplace_back(glm::vec3(sent.light.position - scene.origin()), sent.light.reach);
    texels.emplace_back(sent.light.color, sent.extent);
    texels.push_back(sent.falloff);
}

/// The regions in which shadow casters have changed.
void setDirtyRegions(const Program& program, const Scene& scene) {
    std::vector<glm::vec4> corners;
    for (const DirtyRegions::Box& box : scene.dirtyRegions().boxes()) {
        corners.emplace_back(cornerMetres(box.low, scene), box.area);
        corners.emplace_back(cornerMetres(box.high, scene), 0.0f);
    }
    program.set("uDirtyCornerCount", int(corners.size()));
    if (!corners.empty()) program.set("uDirtyCorners[0]", std::span<const glm::vec4>(corners));
}

/// The lights that changed voxels may have shadowed or let through; of many those that are brightest there.
void setShadowedLights(const Program& program, const FrameContext& frame) {
    program.set("uShadowedLightTexels", 0);
    const auto& boxes = frame.scene.dirtyRegions().boxes();
    if (!frame.lightGrid || boxes.empty()) return;
    std::vector<std::pair<float, const LightGrid::Sent*>> reaching;
    for (const LightGrid::Sent& sent : frame.lightGrid->sent()) {
        const glm::vec3 position(sent.light.position - frame.scene.origin());
        float nearest = sent.light.reach;
        for (const DirtyRegions::Box& box : boxes)
            nearest = std::min(nearest, glm::distance(position, glm::clamp(position, cornerMetres(box.low, frame.scene),
                                                                           cornerMetres(box.high, frame.scene))));
        const float brightest = std::max({sent.light.color.r, sent.light.color.g, sent.light.color.b});
        if (nearest < sent.light.reach && brightest > 0.0f)
            reaching.emplace_back(brightest / std::max(nearest * nearest, 0.01f), &sent);
    }
    std::stable_sort(reaching.begin(), reaching.end(), [](auto& a, auto& b) { return a.first > b.first; });
    std::vector<glm::vec4> lights;
    for (size_t i = 0; i < std::min(reaching.size(), LightGrid::kMaxChanges); ++i)
        addTexels(lights, *reaching[i].second, frame.scene);
    program.set("uShadowedLightTexels", int(lights.size()));
    if (!lights.empty()) program.set("uShadowedLights[0]", std::span<const glm::vec4>(lights));
}

void setChangedLights(const Program& program, const FrameContext& frame, int oldest) {
    std::vector<glm::vec4> lights;
    int newTexels = 0;
    std::array<float, 2> unknown{kUnknownShare, kUnknownShare};
    for (int frames = 0; frame.lightGrid && frames <= oldest; ++frames) {
        for (const LightGrid::Change& change : frame.lightGrid->changes()) {
            if (change.frames != frames) continue;
            if (!change.isRelit) unknown[size_t(frames)] = 1.0f;
            addTexels(lights, change.before, frame.scene);
            addTexels(lights, change.after, frame.scene);
        }
        if (frames == 0) newTexels = int(lights.size());
    }
    program.set("uNewLightTexels", newTexels);
    program.set("uUnknownShare", glm::vec2(unknown[0], unknown[1]));
    program.set("uChangedLightTexels", int(lights.size()));
    if (!lights.empty()) program.set("uChangedLights[0]", std::span<const glm::vec4>(lights));
}

/// Where shapes look different, and the change of light from sun and sky.
void setLookChanges(const Program& program, const LookChanges& changes, int oldest) {
    std::vector<glm::vec4> boxes;
    for (const LookChanges::Box& each : changes.boxes()) {
        boxes.emplace_back(glm::vec3(each.box.low), each.newShare);
        boxes.emplace_back(glm::vec3(each.box.high), each.now > 0.0f ? each.now : oldest > 0 ? -each.lately : 0.0f);
    }
    program.set("uLookCornerCount", int(boxes.size()));
    if (!boxes.empty()) program.set("uLookCorners[0]", std::span<const glm::vec4>(boxes));
    program.set("uLookEverywhere", changes.newShare());
    program.set("uSkylightChange", changes.lightChange());
    program.set("uLateSkylightChange", changes.lightChange(oldest + 1));
}

/// Whether any history is shorter for them.
bool shortenHistory(const LookChanges& changes, int oldest) {
    return changes.lightChange(oldest + 1) > kKeptChange ||
           std::any_of(changes.boxes().begin(), changes.boxes().end(), [&](const LookChanges::Box& each) {
               return (oldest > 0 ? each.lately : each.now) > kKeptChange;
           });
}

}  // namespace

bool hasKnownChanges(const FrameContext& frame, int oldestLight) {
    const auto counts = [&](const LightGrid::Change& change) { return change.frames <= oldestLight; };
    return !frame.scene.dirtyRegions().boxes().empty() || shortenHistory(frame.scene.lookChanges(), oldestLight) ||
           (frame.lightGrid &&
            std::any_of(frame.lightGrid->changes().begin(), frame.lightGrid->changes().end(), counts));
}

void setKnownChanges(const Program& program, const FrameContext& frame, int oldestLight) {
    setDirtyRegions(program, frame.scene);
    setLookChanges(program, frame.scene.lookChanges(), oldestLight);
    setShadowedLights(program, frame);
    setChangedLights(program, frame, oldestLight);
    program.set("uMaxHistory", float(frame.settings.historyFrames));
}

void setLastConfidence(const Program& program, const FrameContext& frame) {
    const Texture& confidence = frame.targets.previousOrNone(Target::HistoryConfidence);
    program.set("uLastConfidence", confidence);
    program.set("uLastConfidenceValid", int(bool(confidence)));
}

}  // namespace rubble
