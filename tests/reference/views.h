#pragma once
#include <string>
#include <vector>

#include "render/renderer.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble::reference {

/// A scene and where it is seen from.
struct SceneView {
    std::string name;
    FrameSnapshot snapshot;
    View view;  ///< without size and framebuffer
};

/// The sandbox town, all of it, as it stands before anything breaks.
FrameSnapshot townSnapshot();
/// What the denoiser is tuned with, and what it is judged by: chosen unseen, never to be looked at for a cause. Who
/// does moves them to the others and chooses new ones. withTown: the town takes a second to make.
std::vector<SceneView> tuningViews(bool withTown = true);
std::vector<SceneView> heldOutViews();
/// What is compared with the reference: no rounded edges and glare, which are a look and not an error, and no shafts of
/// light in the air.
RenderSettings comparedSettings();

}  // namespace rubble::reference
