#pragma once
#include "render/frame/frame_context.h"

namespace rubble {

/// Makes surfaces that lie open to the sky wet by changing albedo and material, so that light and reflections need to
/// know nothing of it. For levels with Environment::wetness > 0.
class WetnessPass {
public:
    /// Builds its program. If that fails, shaders.errors() says why and draw() does nothing.
    explicit WetnessPass(ShaderLibrary& shaders);
    /// Changes Albedo and Material.
    void draw(const FrameContext& frame) const;

private:
    FullscreenProgram& m_program;
};

}  // namespace rubble
