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
constexpr ShowPass::TargetView kExposed{"final", Target::Resolved, ShowPass::Mode::Exposed};

/// Depth in the window, 0 to 1, of what lies `depth` metres away along the view axis.
double windowDepth(const View::Projection& projection, double depth) {
    const glm::dvec4 clip = projection.clipFromEye * glm::dvec4(0.0, 0.0, -depth, 1.0);
    return projection.isZeroToOne ? clip.z / clip.w : 0.5 * clip.z / clip.w + 0.5;
}

/// The uniforms of the host's depth; without a projection depth is not tested, so any do.
void setDepth(const Program& program, const FrameContext& frame, const View& view) {
    const View::Projection projection = view.projection.value_or(View::Projection{});
    const glm::dmat4& p = projection.clipFromEye;
    program.set("uDepth", frame.targets.at(Target::Depth));
    program.set("uClipOfDepth", glm::vec4(-p[2][2], p[3][2], -p[2][3], p[3][3]));
    program.set("uWindowOfClip", projection.isZeroToOne ? glm::vec2(1.0f, 0.0f) : glm::vec2(0.5f));
}

}  // namespace

std::span<const ShowPass::TargetView> ShowPass::views() {
    return kViews;
}

TargetSet ShowPass::reads(const TargetView& shown) {
    return shown.target | kExposed.target | Target::Depth | Target::Exposure;
}

ShowPass::ShowPass(ShaderLibrary& shaders)
    : m_image(shaders.load("passes/show.frag")), m_data(shaders.load("passes/show_data.frag")) {}

void ShowPass::draw(const FrameContext& frame, const TargetView& chosen, const View& view, glm::vec4 statusDot) const {
    const TargetView& shown = view.isLinear && &chosen == &kViews[0] ? kExposed : chosen;
    const Program& program = shown.mode == Mode::Color || shown.mode == Mode::Exposed ? m_image : m_data;
    if (!program) return;
    glBindFramebuffer(GL_FRAMEBUFFER, view.framebuffer);
    setViewport(view.size);
    const Texture* target = frame.targets.find(shown.target);
    const bool composes = view.projection && view.projection->composesDepth;
    if (composes) {
        glEnable(GL_DEPTH_TEST);
        const bool isReversed = windowDepth(*view.projection, 1.0) > windowDepth(*view.projection, 2.0);
        glDepthFunc(isReversed ? GL_GEQUAL : GL_LEQUAL);
    }
    program.use();
    setDepth(program, frame, view);
    program.set("uFlipped", view.isFlipped);
    program.set("uIsExposed", int(shown.mode == Mode::Exposed));
    program.set("uExposure", frame.targets.at(Target::Exposure));
    program.set("uTarget", target ? *target : frame.blueNoise);
    program.set("uMode", int(shown.mode));
    program.set("uStatusDot", statusDot);
    frame.drawTriangle();
    if (composes) {
        glDepthFunc(GL_LESS);
        glDisable(GL_DEPTH_TEST);
    }
}

}  // namespace rubble
