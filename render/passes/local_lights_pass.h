#pragma once
#include <vector>

#include "render/frame_context.h"

namespace rubble {

/// Adds sphere and cone lights to the colour of "light". Without lights it has no texture and draws nothing.
class LocalLightsPass {
public:
    explicit LocalLightsPass(ShaderLibrary& shaders);
    void draw(const FrameContext& frame);

private:
    void upload(const FrameContext& frame);

    const Program& m_program;
    std::vector<glm::vec4> m_texels;  ///< four a light, as passes/local_lights.frag reads them
    Texture m_lights;
};

}  // namespace rubble
