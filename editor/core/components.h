#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <rubble/rubble.hpp>
#include <vector>

#include "editor/core/cells.h"

namespace editor {

/// A part of a shape whose voxels are joined by faces.
struct Component {
    glm::ivec3 low{0}, size{0};
    uint64_t voxels = 0, anchored = 0;  ///< all of them, and those in anchors of the shape
    /// Whether anchors hold it.
    bool isAnchored() const { return anchored > 0; }
};

/// All components of a shape.
class Components {
public:
    /// Of none.
    Components() = default;
    /// Of a shape as the last edit left it; none of one of more than 2^24 cells.
    Components(const rubble::World& world, rubble_shape shape);

    /// The largest first.
    const std::vector<Component>& all() const { return m_all; }
    /// Which of them a cell is of; -1: none.
    int at(glm::ivec3 cell) const;
    /// Whether a voxel of one is in an anchor.
    bool isAnchored(glm::ivec3 cell) const;

private:
    size_t indexOf(glm::ivec3 cell) const;
    void gather(const std::vector<uint8_t>& voxels, glm::ivec3 start);
    void sortBySize();
    void markAnchor(const Cells& anchor);

    static constexpr uint32_t kAnchored = 1u << 31;
    Cells m_grid;
    std::vector<uint32_t> m_of;  ///< by cell: the place of its component, and 1; 0: none; with kAnchored in anchors
    std::vector<Component> m_all;
};

}  // namespace editor
