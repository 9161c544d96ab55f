#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Temporal accumulation: blends the noisy light of this frame with the reprojected history. Derivation:
/// shaders/passes/accumulate.frag.
class AccumulatePass {
public:
    /// Builds its programs. If one fails, shaders.errors() says why and it is not drawn.
    explicit AccumulatePass(ShaderLibrary& shaders);
    /// Fills AccumulatedLight and Surface.
    void draw(const FrameContext& frame) const;

private:
    /// Compares the noisy light with the history in tiles of kConfidenceTile pixels. Fills HistoryConfidence.
    void findChanges(const FrameContext& frame, const History& light, const History& surface) const;

    FullscreenProgram& m_change;
    FullscreenProgram& m_program;
};

}  // namespace rubble
