#pragma once
#include <cstdint>
#include <utility>
#include <vector>

namespace rubble {

/// What the last frame cost.
struct RenderStats {
    int drawCalls = 0;
    int bodyDraws = 0;          ///< of those, the ones that draw voxel bodies
    int waters = 0;             ///< of the draws, the ones that draw a water
    int imageCopies = 0;        ///< copies of the image, for what is seen through water
    uint64_t copiedPixels = 0;  ///< by them
    uint64_t waterPixels = 0;   ///< that waters were drawn over
    uint64_t uploadBytes = 0;   ///< sent to the GL for this frame
    uint64_t waitingBytes = 0;  ///< changed bricks over the upload budget: their changes are not drawn yet
    uint64_t textureBytes = 0;  ///< held now
    int shapes = 0;
    int bricks = 0;
    std::vector<const char*> passes;  ///< in the order drawn
    /// Milliseconds of each pass, in the order drawn, with RenderSettings::passTimes: on a GPU those of the newest
    /// frame that it has finished, on a software renderer of this one.
    std::vector<std::pair<const char*, double>> passMs;
    std::vector<const char*> computePasses;  ///< passes that drew full-screen programs by compute
    int computePrograms = 0;                 ///< held now

    /// Starts counting a frame's draws and passes.
    void beginFrame() {
        drawCalls = bodyDraws = waters = imageCopies = 0;
        copiedPixels = waterPixels = 0;
        computePasses.clear();
        passes.clear();
    }
};

}  // namespace rubble
