#include "physics/shapes/box_surface.h"

namespace rubble {
namespace {

bool isFull(const SolidRows& rows) {
    const glm::ivec3 size = rows.box().high - rows.box().low;
    const uint64_t full = (~uint64_t(0) >> (64 - size.x)) << SolidRows::kPadding;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            if ((rows.row(y, z) & full) != full) return false;
    return true;
}

}  // namespace

std::optional<BoxSurface> findBoxSurface(const SolidRows& rows) {
    if (rows.box().empty() || !isFull(rows)) return std::nullopt;
    const glm::vec3 low(rows.box().low), high(rows.box().high);
    return BoxSurface{(low + high) * 0.5f, (high - low) * 0.5f};
}

}  // namespace rubble
