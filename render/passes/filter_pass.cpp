#include "render/passes/filter_pass.h"

#include <algorithm>

#include "render/passes/depth_limit.h"

namespace rubble {

FilterPass::FilterPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/filter.frag", kFarVertexShader)) {}

void FilterPass::draw(const FrameContext& frame) const {
    if (!m_program) return;
    const DepthLimit limit(DepthLimit::To::Surfaces);
    m_program.use();
    m_program.set("uSurface", frame.targets.at("surface"));
    m_program.set("uSunRays", float(frame.settings.sunRays));
    const Texture* source = &frame.targets.at("accumulated");
    const int steps = std::max(frame.settings.filterPasses, 1);
    for (int step = 0; step < steps; ++step) {
        // The last step ends in "lighting", whatever their number.
        const Texture& target = frame.targets.target((steps - step) % 2 ? "lighting" : "lightingOther", GL_RGBA16F);
        frame.targets.framebuffer({&target}, &frame.targets.at("depthBuffer")).begin();
        const float none[4] = {0, 0, 0, 0};
        glClearBufferfv(GL_COLOR, 0, none);
        m_program.set("uLight", *source);
        // Without filter passes the one step looks at the pixel alone.
        m_program.set("uStride", frame.settings.filterPasses ? 1 << step : 0);
        m_program.set("uDiagonal", step % 2);
        frame.drawFullscreen();
        source = &target;
    }
}

}  // namespace rubble
