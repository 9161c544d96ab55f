#include <algorithm>
#include <cstdlib>
#include <glm/common.hpp>
#include <limits>
#include <utility>

#include "runtime/core/log.h"
#include "runtime/core/random.h"
#include "runtime/world/stages/edit_step.h"

namespace rubble {
namespace {

/// Squared distance in cells from a point to the centre of the node's nearest voxel, if that is less than `best`.
double nearestInNodeSquared(glm::ivec3 position, const BrickNode& node, glm::dvec3 point, double best) {
    forEachChild(node.mask, [&](int child) {
        const glm::dvec3 low = glm::dvec3((position * kNodeBricks + childPosition(child)) * kBrickSize),
                         high = low + double(kBrickSize);
        const glm::dvec3 toBox = point - glm::clamp(point, low, high);
        if (glm::dot(toBox, toBox) >= best) return;
        forEachVoxel(node.bricks[size_t(child)]->occupancy, [&](int i) {
            const glm::dvec3 offset = point - (low + glm::dvec3(voxelInBrick(i)) + 0.5);
            best = std::min(best, glm::dot(offset, offset));
        });
    });
    return best;
}

/// The same for a grid: shells of nodes around the point, until none can hold a nearer voxel.
double nearestVoxelSquared(const VoxelGrid& grid, glm::dvec3 point) {
    double best = std::numeric_limits<double>::infinity();
    const glm::ivec3 size = grid.sizeInNodes();
    const glm::ivec3 middle = glm::ivec3(glm::clamp(point / double(kNodeSize), glm::dvec3(0.0), glm::dvec3(size - 1)));
    const int last = std::max({size.x, size.y, size.z});
    for (int r = 0; r < last; ++r) {
        const double minDistance = double(std::max(r - 1, 0)) * kNodeSize;
        if (minDistance * minDistance >= best) break;
        const glm::ivec3 low = glm::max(middle - r, 0), high = glm::min(middle + r, size - 1);
        for (int z = low.z; z <= high.z; ++z)
            for (int y = low.y; y <= high.y; ++y) {
                const bool isSide = std::abs(z - middle.z) == r || std::abs(y - middle.y) == r;
                for (int x = isSide ? low.x : middle.x - r; x <= high.x; x += isSide || r == 0 ? 1 : 2 * r)
                    if (const BrickNode* node = x < 0 ? nullptr : grid.nodeAt({x, y, z}))
                        best = nearestInNodeSquared({x, y, z}, *node, point, best);
            }
    }
    return best;
}

/// The palette with one group's entries dark; null if they already are.
PaletteRef darkened(const Palette& palette, uint32_t group) {
    const auto shines = [&](const PaletteEntry& entry) { return entry.lightGroup == group && entry.emission > 0.0f; };
    if (std::none_of(palette.begin(), palette.end(), shines)) return nullptr;
    auto out = std::make_shared<Palette>(palette);
    for (PaletteEntry& entry : *out)
        if (shines(entry)) entry.emission = 0.0f;
    return out;
}

}  // namespace

void EditStep::apply(const SetEnvironmentEdit& edit) {
    if (const std::string error = environmentError(edit.environment); !error.empty())
        return logWarning("SetEnvironmentEdit: " + error + "; nothing was changed");
    const Environment before = m_world.environment();
    m_world.setEnvironment(edit.environment);
    m_changes.environmentChanged |= before != m_world.environment();
}

void EditStep::apply(const AddLightEdit& edit) {
    LightHandle& added = m_changes.lightsAdded.emplace_back();
    const std::optional<Light> light = checkedLight(edit.light, "AddLightEdit");
    if (!light) return;
    if (m_world.m_lights.size() >= kMaxLights)
        return logWarning("AddLightEdit: expected less than " + std::to_string(kMaxLights) +
                          " lights (kMaxLights), found " + std::to_string(m_world.m_lights.size()) +
                          "; nothing was changed");
    added = m_world.m_lights.insert(*light);
    m_changes.lights.push_back(added);
}

void EditStep::apply(const SetLightEdit& edit) {
    Light* light = m_world.m_lights.find(edit.light);
    if (!light) return logWarning("SetLightEdit: the handle of its light is stale; nothing was changed");
    std::optional<Light> values = checkedLight(edit.values, "SetLightEdit");
    if (!values) return;
    *light = std::move(*values);
    m_changes.lights.push_back(edit.light);
}

void EditStep::apply(const RemoveLightEdit& edit) {
    if (!m_world.m_lights.erase(edit.light))
        return logWarning("RemoveLightEdit: the handle of its light is stale; nothing was removed");
    m_changes.lights.push_back(edit.light);
}

/// As it will be in the World; none, and a warning, if it cannot be there.
std::optional<Light> EditStep::checkedLight(const Light& wanted, const char* edit) const {
    const LightGroup* group = m_world.m_groups.find(wanted.group);
    std::string error = lightError(wanted);
    if (wanted.shape && !m_world.m_shapes.find(wanted.shape)) error = "the handle of its shape is stale";
    if (wanted.group && !group) error = "the handle of its light group is stale";
    if (!error.empty()) {
        logWarning(std::string(edit) + ": " + error + "; nothing was changed");
        return {};
    }
    Light light = wanted;
    light.enabled = wanted.enabled && !(group && group->out);
    return light;
}

/// A light goes with the piece that has the voxel nearest to it; the parent first, then the children in order.
void EditStep::moveLights(const ShapeSplit& split) {
    const Shape& parent = m_world.m_shapes.at(split.parent);
    m_world.m_lights.forEach([&](LightHandle handle, Light& light) {
        if (light.shape != split.parent) return;
        const glm::dvec3 pointCells = light.local.position / double(parent.voxelSize);
        double best = nearestVoxelSquared(parent.grid, pointCells);
        const size_t kParent = split.children.size();
        size_t host = kParent;
        for (size_t i = 0; i < split.children.size(); ++i) {
            const double distance = nearestVoxelSquared(m_world.m_shapes.at(split.children[i]).grid,
                                                        pointCells - glm::dvec3(split.parentOffset[i]));
            if (distance < best) best = distance, host = i;
        }
        if (host == kParent) return;
        light.shape = split.children[host];
        light.local.position -= glm::dvec3(split.parentOffset[host]) * double(parent.voxelSize);
        m_changes.lights.push_back(handle);
    });
}

/// Lights whose shape is gone hang where they were, dark.
void EditStep::turnOffLightsOf(ShapeHandle shape) {
    m_world.m_lights.forEach([&](LightHandle handle, Light& light) {
        if (light.shape != shape) return;
        light.local = m_world.lightToWorld(light);
        light.shape = {};
        light.enabled = false;
        m_changes.lights.push_back(handle);
    });
}

void EditStep::updateLightGroups() {
    m_world.m_groups.forEach([&](LightGroupHandle handle, LightGroup& group) {
        const uint64_t removed = handle.slot() < m_removedByGroup.size() ? m_removedByGroup[handle.slot()] : 0;
        group.removedVoxels += removed;
        if (removed) m_changes.groups.push_back(handle);
        if (group.out) return;
        const bool isBroken =
            removed && double(group.removedVoxels) >= double(group.threshold) * double(group.initialVoxels);
        if (!group.failingSince && (isBroken || lostPower(handle, group))) {
            group.failingSince = m_changes.step;
            ++m_world.m_flickeringGroups;
        }
        if (group.failingSince && m_changes.step >= group.failingSince + group.flickerSteps)
            turnOff(handle, group);
        else if (group.failingSince)
            updateFlicker(handle, group);
    });
}

/// Looks only if the supply's shape has lost wire or a piece in this step.
bool EditStep::lostPower(LightGroupHandle handle, const LightGroup& group) const {
    return group.supply && m_cutWires.contains(group.supply.slot()) && !m_world.isPowered(handle, group);
}

void EditStep::turnOff(LightGroupHandle handle, LightGroup& group) {
    --m_world.m_flickeringGroups;
    group.failingSince = 0;
    group.dark = false;
    group.out = true;
    m_changes.groups.push_back(handle);
    m_changes.groupsOut.push_back(handle);
    darkenGroup(handle);
}

void EditStep::updateFlicker(LightGroupHandle handle, LightGroup& group) {
    constexpr uint64_t kSteps = 3;  ///< that a state lasts
    const bool isDark = hashCell(int(handle.slot()), int(m_changes.step / kSteps), 0) & 1;
    m_changes.groups.push_back(handle);
    if (std::exchange(group.dark, isDark) == isDark) return;
    m_world.m_lights.forEach([&](LightHandle light, const Light& each) {
        if (each.group == handle) m_changes.lights.push_back(light);
    });
}

void EditStep::darkenGroup(LightGroupHandle group) {
    m_world.m_lights.forEach([&](LightHandle handle, Light& light) {
        if (light.group != group || !light.enabled) return;
        light.enabled = false;
        std::vector<LightHandle>& lights = m_changes.lights;
        if (std::find(lights.begin(), lights.end(), handle) == lights.end()) lights.push_back(handle);
    });
    std::vector<std::pair<PaletteRef, PaletteRef>> seen;  // shapes go on sharing what they shared
    m_world.m_shapes.forEach([&](ShapeHandle handle, Shape& shape) {
        auto known =
            std::find_if(seen.begin(), seen.end(), [&](const auto& pair) { return pair.first == shape.palette; });
        if (known == seen.end())
            known = seen.insert(seen.end(), {shape.palette, darkened(*shape.palette, group.slot() + 1)});
        if (!known->second) return;
        shape.palette = known->second;
        std::vector<ShapeHandle>& palettes = m_changes.palettes;
        if (std::find(palettes.begin(), palettes.end(), handle) == palettes.end()) palettes.push_back(handle);
    });
}

}  // namespace rubble
