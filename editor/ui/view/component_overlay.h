#pragma once
#include <imgui.h>

#include <vector>

#include "editor/core/components.h"
#include "editor/ui/state/session.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// Shows the components of the selected shape, each in a colour of its own, so that one sees what would fall.
class ComponentOverlay {
public:
    /// Draws it.
    void draw(Session& session, Wires& wires);
    /// The colour of a component: green to violet if it is anchored, red to magenta if it is loose.
    static ImU32 colorOf(const Component& component, size_t place);

private:
    /// Pixels that show voxels of one component.
    struct Tile {
        ImVec2 low, high;
        ImU32 color;
    };
    void findTiles(Session& session, const rubble_shape_state& shape, const ViewFrame& frame);
    ImU32 tintOf(const rubble_hit& hit, rubble_shape shape) const;

    rubble_shape m_shape = 0;
    uint64_t m_version = 0;
    Components m_components;
    std::vector<Tile> m_tiles;
    ViewFrame m_frame;   ///< of which they are
    float m_pixels = 0;  ///< the side of one; 0: there are none yet
};

}  // namespace editor
