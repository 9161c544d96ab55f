#pragma once
#include <glm/vec3.hpp>
#include <optional>
#include <rubble/rubble.hpp>

#include "editor/ui/state/camera.h"
#include "editor/ui/state/session.h"

namespace editor {

/// What the mouse points at.
struct Hover {
    rubble_hit hit{};
    glm::ivec3 cell{0};  ///< of the shape's grid
    int axis = 1;        ///< of the grid, out of the face that was hit
    int side = 1;        ///< along it, -1 or 1
};

/// The voxel that is seen under a point of the window; nothing: the ground or the sky.
std::optional<Hover> pick(Session& session, const ViewFrame& frame, ImVec2 at);
/// Lets queries find what the view shows. The session outlives it.
rubble_query_filter seenBy(const Session& session);
/// The ray of a point of the window.
rubble_ray rayAt(const ViewFrame& frame, ImVec2 at);

/// A stroke of a brush: from where the button went down to where the mouse is.
struct Stroke {
    rubble_shape shape = 0;
    glm::ivec3 from{0}, to{0};  ///< cells that the brush covers first and last
    int axis = 1, side = 1;     ///< of the face where it began
};

/// The stroke that begins at a voxel.
Stroke beginStroke(const Brush& brush, const Hover& hover);
/// Its end follows the mouse in the plane of the face where it began.
void followMouse(Stroke& stroke, const rubble::World& world, const ViewFrame& frame, ImVec2 at);
/// Cells around the line of a stroke that is drawn by `line`.
int strokeRadius(const Brush& brush);
/// The command that draws a stroke.
Line lineOf(const rubble::World& world, const Brush& brush, const Stroke& stroke);

}  // namespace editor
