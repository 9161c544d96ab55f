#include "render/passes/show_pass.h"

#include "render/gl/draw_state.h"

namespace rubble {
namespace {

constexpr auto kViews = [] {
    using enum ShowPass::Mode;
    return std::to_array<ShowPass::TargetView>({
        {"final", Target::Final, Color},
        {"albedo", Target::Albedo, Color},
        {"normal", Target::Normal, Signed},
        {"emission", Target::Normal, Alpha},
        {"material", Target::Material, Color},
        {"motion", Target::Motion, Motion},
        {"depth", Target::Depth, Distance},
        {"glassTint", Target::GlassTint, Color},
        {"glassSurface", Target::GlassSurface, Signed},
        {"noisySun", Target::NoisyLight, Alpha},
        {"noisySky", Target::NoisyLight, Linear},
        {"hitProximity", Target::HitProximity, Color},
        {"sun", Target::DenoisedLight, Alpha},
        {"denoisedLight", Target::DenoisedLight, Linear},
        {"history", Target::Surface, History},
        {"accumulatedReflection", Target::AccumulatedReflection, Linear},
        {"reflection", Target::Reflection, Linear},
        {"radiance", Target::Radiance, Linear},
        {"resolved", Target::Resolved, Linear},
        {"bloom", Target::Bloom0, Linear},
    });
}();

}  // namespace

std::span<const ShowPass::TargetView> ShowPass::views() {
    return kViews;
}

ShowPass::ShowPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/show.frag")) {}

void ShowPass::draw(const FrameContext& frame, const TargetView& shown, const View& view, glm::vec4 statusDot) const {
    if (!m_program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    const Texture* target = frame.targets.find(shown.target);
    m_program.use();
    m_program.set("uTarget", target ? *target : frame.blueNoise);
    m_program.set("uMode", int(shown.mode));
    m_program.set("uStatusDot", statusDot);
    frame.drawTriangle();
}

}  // namespace rubble
