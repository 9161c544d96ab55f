#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Mixes "noisyLight" with what earlier pictures saw there, into the histories "accumulatedLight" and "surface".
class AccumulatePass {
public:
    explicit AccumulatePass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame) const;

private:
    /// Compares "noisyLight" with memory in tiles of 4x4 pixels: returns what of it may be trusted.
    const Texture& findChanges(const FrameContext& frame, const History& light, const History& surface) const;

    FullscreenProgram& m_change;
    FullscreenProgram& m_program;
};

}  // namespace rubble
