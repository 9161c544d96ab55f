#pragma once
#include <map>
#include <vector>

#include "editor/ui/state/session.h"
#include "editor/ui/view/load_probe.h"
#include "editor/ui/view/wires.h"

namespace editor {

/// A part of a shape whose voxels are joined by faces.
struct Component {
    glm::ivec3 low{0}, size{0};
    uint64_t voxels = 0;
    bool isAnchored = false;  ///< one of the shape's anchors reaches it
};

/// The components of a shape, the largest first.
std::vector<Component> componentsOf(const rubble::World& world, rubble_shape shape);

/// What the overlays mark: boxes, points and labels at their places.
class OverlayMarks {
public:
    /// Draws what session.overlays asks for.
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
    void drawComponents(Session& session, Wires& wires);
    void drawContacts(Session& session, Wires& wires);
    void drawLoad(Session& session, Wires& wires);

    std::vector<Component> m_components;
    rubble_shape m_shape = 0;
    uint64_t m_version = 0, m_contactVersion = 0;
    std::vector<Contact> m_contacts;
    std::vector<ChangedBrick> m_bricks;
    std::map<rubble_shape, uint64_t> m_brickVersions;
    uint64_t m_brickStep = 0;
    LoadProbe m_load;
    uint64_t m_loadVersion = 0;
    bool m_asksForContacts = false;
};

}  // namespace editor
