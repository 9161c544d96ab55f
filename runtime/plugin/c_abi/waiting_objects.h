#pragma once
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <optional>

#include "runtime/world/edits/edit.h"

namespace rubble::abi {

/// What the edits that wait for the next step make of grids and bodies, for checks of the calls after them. It reads
/// each edit once, and begins again after the step.
class WaitingObjects {
public:
    /// Reads what was queued since the last call.
    void follow(const EditQueue& queue);
    /// The cells of a shape's grid before an edit that is queued next; nothing: only the step can tell. `present`: its
    /// grid as the last step left it, nothing of a shape that the next one makes.
    std::optional<glm::ivec3> gridSize(ShapeHandle shape, std::optional<glm::ivec3> present) const;
    /// Whether a body is static then; nothing: only the step can tell.
    std::optional<bool> isStatic(BodyHandle body, std::optional<bool> present) const;

private:
    void read(const Edit& edit);

    size_t m_read = 0;                                         ///< edits of the queue
    bool m_isRestored = false;                                 ///< an undo or redo comes before all of them
    std::map<ShapeHandle, std::optional<glm::ivec3>> m_sizes;  ///< nothing: an unknown size
    std::map<BodyHandle, bool> m_kinds;                        ///< whether it is static
    bool m_mergesAnywhere = false;                             ///< into a shape that the step finds
};

}  // namespace rubble::abi
