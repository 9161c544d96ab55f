#include "runtime/plugin/c_abi/event_rows.h"

#include <algorithm>

#include "runtime/plugin/c_abi/checks.h"

namespace rubble::abi {
namespace {

template <class Handles>
void copyBits(const Handles& handles, std::vector<uint64_t>& out) {
    out.clear();
    for (const auto handle : handles) out.push_back(handle.bits);
}

/// Those of a list but the relocated ones: to a host they are the same.
void copyShapes(const std::vector<ShapeHandle>& shapes, const FrameChanges& changes, std::vector<uint64_t>& out) {
    out.clear();
    for (const ShapeHandle shape : shapes)
        if (!changes.isRelocated(shape)) out.push_back(shape.bits);
}

rubble_dust_cloud dustRow(const DustCloud& cloud) {
    rubble_dust_cloud row = {.radius = cloud.radius, .count = cloud.count, .material = cloud.material};
    writeVector(row.position, cloud.position);
    writeVector(row.velocity, cloud.velocity);
    std::copy_n(cloud.color.begin(), 3, row.color);
    return row;
}

rubble_removed_voxels removedRow(const RemovedVoxels& removed) {
    rubble_removed_voxels row = {.shape = removed.shape.bits,
                                 .count = removed.count,
                                 .material = removed.material,
                                 .palette_index = removed.entry};
    std::copy_n(removed.color.begin(), 3, row.color);
    return row;
}

}  // namespace

void EventRows::fill(const FrameChanges& changes) {
    m_step = changes.step;
    m_painted = changes.paintedVoxels;
    m_levelLoaded = changes.levelReplaced;
    copyBits(changes.bodiesCreated, m_bodiesCreated);
    copyBits(changes.bodiesDestroyed, m_bodiesDestroyed);
    copyShapes(changes.shapesCreated, changes, m_shapesCreated);
    copyShapes(changes.shapesDestroyed, changes, m_shapesDestroyed);
    copyBits(changes.groupsOut, m_groupsOut);
    copyBits(changes.broken, m_broken);
    copyBits(changes.settled, m_settled);
    copyBits(changes.unsettled, m_unsettled);
    m_dust.clear();
    for (const DustCloud& cloud : changes.dust) m_dust.push_back(dustRow(cloud));
    m_removed.clear();
    for (const RemovedVoxels& removed : changes.removed) m_removed.push_back(removedRow(removed));
    m_splits.clear();
    for (const ShapeSplit& split : changes.splits)
        for (size_t i = 0; i < split.children.size(); ++i) {
            rubble_shape_split row = {split.parent.bits, split.children[i].bits, {}, 0};
            writeCell(row.parent_offset, split.parentOffset[i]);
            m_splits.push_back(row);
        }
}

rubble_events EventRows::view() const {
    rubble_events events = {};
    events.level_loaded = m_levelLoaded;
    events.step = m_step;
    events.painted_voxel_count = m_painted;
    const auto point = [](const auto& rows, auto& at, uint32_t& count) {
        at = rows.data();
        count = uint32_t(rows.size());
    };
    point(m_removed, events.removed, events.removed_count);
    point(m_splits, events.splits, events.split_count);
    point(m_dust, events.dust_clouds, events.dust_cloud_count);
    point(m_bodiesCreated, events.bodies_created, events.bodies_created_count);
    point(m_bodiesDestroyed, events.bodies_destroyed, events.bodies_destroyed_count);
    point(m_shapesCreated, events.shapes_created, events.shapes_created_count);
    point(m_shapesDestroyed, events.shapes_destroyed, events.shapes_destroyed_count);
    point(m_groupsOut, events.light_groups_out, events.light_groups_out_count);
    point(m_broken, events.bodies_broken, events.bodies_broken_count);
    point(m_settled, events.bodies_settled, events.bodies_settled_count);
    point(m_unsettled, events.bodies_unsettled, events.bodies_unsettled_count);
    return events;
}

}  // namespace rubble::abi
