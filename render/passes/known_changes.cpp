#include "render/passes/known_changes.h"

#include <vector>

#include "render/scene/light_grid.h"
#include "render/scene/scene.h"

namespace rubble {
namespace {

/// The regions in which shadow casters have changed.
void setDirtyRegions(const Program& program, const Scene& scene) {
    std::vector<glm::vec4> corners;
    for (const DirtyRegions::Box& box : scene.dirtyRegions().boxes())
        for (const glm::ivec3& corner : {box.low, box.high})
            corners.emplace_back(glm::vec3(glm::dvec3(corner) * DirtyRegions::kBrickMetres - scene.origin()), 0.0f);
    program.set("uDirtyCornerCount", int(corners.size()));
    if (!corners.empty()) program.set("uDirtyCorners[0]", std::span<const glm::vec4>(corners));
}

void setChangedLights(const Program& program, const FrameContext& frame, int oldest) {
    std::vector<glm::vec4> lights;
    for (const LightGrid::Change& change :
         frame.lightGrid ? frame.lightGrid->changes() : std::vector<LightGrid::Change>()) {
        if (change.frames > oldest) continue;
        for (const LightGrid::Sent* sent : {&change.before, &change.after}) {
            lights.emplace_back(glm::vec3(sent->position - frame.scene.origin()), sent->reach);
            lights.emplace_back(sent->color, sent->extent);
            lights.push_back(sent->falloff);
        }
    }
    program.set("uChangedLightTexels", int(lights.size()));
    if (!lights.empty()) program.set("uChangedLights[0]", std::span<const glm::vec4>(lights));
}

}  // namespace

void setKnownChanges(const Program& program, const FrameContext& frame, int oldestLight) {
    setDirtyRegions(program, frame.scene);
    setChangedLights(program, frame, oldestLight);
    program.set("uMaxHistory", float(frame.settings.historyFrames));
}

}  // namespace rubble
