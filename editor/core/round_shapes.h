#pragma once
#include <rubble/rubble.hpp>

namespace editor {

/// Whether a shape is touched as what rubble_collision_shape says of it. False: it says a sphere or a cylinder, but the
/// voxels are not that round, so that it is touched as voxels. Costs a small world of its own, and all cells.
bool isTouchedAs(const rubble::World& world, rubble_shape shape, uint32_t kind);

}  // namespace editor
