#pragma once
#include <string>
#include <vector>

#include "render/renderer.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble::reference {

/// A scene and a camera.
struct SceneView {
    std::string name;
    FrameSnapshot snapshot;
    View view;  ///< without size and framebuffer
};

/// The whole sandbox town, undamaged.
FrameSnapshot townSnapshot();
/// The views that the denoiser is tuned with. withTown: the town takes a second to make.
std::vector<SceneView> tuningViews(bool withTown = true);
/// The views that the denoiser is evaluated with, as a test set is in machine learning: chosen unseen, and never looked
/// at to find the cause of an error. A view that was used so moves to tuningViews(), and a new one is chosen.
std::vector<SceneView> heldOutViews();
/// Settings for comparisons with the reference: without rounded edges, glare, fog, refraction and detail, which the
/// reference does not have.
RenderSettings comparedSettings();

}  // namespace rubble::reference
