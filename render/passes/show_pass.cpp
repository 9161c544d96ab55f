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

ShowPass::ShowPass(ShaderLibrary& shaders)
    : m_image(shaders.load("passes/show.frag")), m_data(shaders.load("passes/show_data.frag")) {}

void ShowPass::draw(const FrameContext& frame, const TargetView& chosen, const View& view, const Texture& depth,
                    glm::vec4 statusDot) const {
    const TargetView& shown = view.isLinear && &chosen == &kViews[0] ? kExposed : chosen;
    const Program& program = shown.mode == Mode::Color || shown.mode == Mode::Exposed ? m_image : m_data;
    if (!program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    const Texture* target = frame.targets.find(shown.target);
    if (view.composesDepth()) {
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(view.projection->isReversed() ? GL_GEQUAL : GL_LEQUAL);
    }
    program.use();
    setHostDepth(program, view);
    program.set("uDepth", depth);
    program.set("uFlipped", view.isFlipped);
    program.set("uIsExposed", int(shown.mode == Mode::Exposed));
    program.set("uExposure", frame.targets.at(Target::Exposure));
    program.set("uTarget", target ? *target : frame.blueNoise);
    program.set("uMode", int(shown.mode));
    program.set("uStatusDot", statusDot);
    frame.drawTriangle();
    if (view.composesDepth()) {
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
    }
}

}  // namespace rubble
