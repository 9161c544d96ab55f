#pragma once
#include <map>
#include <vector>

#include "editor/ui/state/session.h"
#include "editor/ui/view/component_overlay.h"
#include "editor/ui/view/load_probe.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// What the overlays mark: boxes, points and labels at their places.
class OverlayMarks {
public:
    /// Draws what the overlays of the editor ask for.
    void draw(Session& session, Wires& wires);

private:
    struct Contact {
        glm::dvec3 at, normal;
        double impulse;
        uint64_t step;
    };
    struct ChangedBrick {
        rubble_shape shape;
        glm::ivec3 brick;
        uint64_t step;
    };
    void gatherBricks(Session& session, uint64_t now);
    void drawBricks(Session& session, Wires& wires);
    void drawContacts(Session& session, Wires& wires);
    void drawLoad(Session& session, Wires& wires);

    ComponentOverlay m_components;
    uint64_t m_contactVersion = 0;
    std::vector<Contact> m_contacts;
    std::vector<ChangedBrick> m_bricks;
    std::map<rubble_shape, uint64_t> m_brickVersions;
    uint64_t m_brickStep = 0;
    LoadProbe m_load;
    uint64_t m_loadVersion = 0;
    bool m_asksForContacts = false;
};

}  // namespace editor
