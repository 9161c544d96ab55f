#include "render/passes/show_pass.h"

#include "render/gl/draw_state.h"
#include "render/passes/host_depth.h"

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
constexpr ShowPass::TargetView kExposed{"final", Target::Resolved, ShowPass::Mode::Exposed};

}  // namespace

std::span<const ShowPass::TargetView> ShowPass::views() {
    return kViews;
}

TargetSet ShowPass::reads(const TargetView& shown) {
    return shown.target | kExposed.target | Target::Depth | Target::Exposure;
}

ShowPass::ShowPass(ShaderLibrary& shaders) : m_program(shaders.load("passes/show.frag")) {}

void ShowPass::draw(const FrameContext& frame, const TargetView& chosen, const View& view, const Texture& depth,
                    glm::vec4 statusDot) const {
    if (!m_program) return;
    const TargetView& shown = view.isLinear && &chosen == &kViews[0] ? kExposed : chosen;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    const Texture* target = frame.targets.find(shown.target);
    if (view.composesDepth()) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(view.projection->isReversed() ? GL_GEQUAL : GL_LEQUAL);
    }
    m_program.use();
    setHostDepth(m_program, view);
    m_program.set("uDepth", depth);
    m_program.set("uFlipped", view.isFlipped);
    m_program.set("uExposure", frame.targets.at(Target::Exposure));
    m_program.set("uTarget", target ? *target : frame.blueNoise);
    m_program.set("uMode", int(shown.mode));
    m_program.set("uStatusDot", statusDot);
    frame.drawTriangle();
    if (view.composesDepth()) {
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
    }
}

}  // namespace rubble
