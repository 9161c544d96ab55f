#pragma once
#include <array>
#include <cstdint>
#include <string_view>

#include "render/gl/texture.h"

namespace rubble {

/// The textures that passes draw into.
enum class Target {
    Albedo,
    Normal,
    Material,
    Motion,
    Depth,
    DepthBuffer,
    GlassMask,
    DryAlbedo,
    DryMaterial,
    GlassTint,
    GlassSurface,
    GlassDepth,
    NoisyLight,
    HitProximity,
    Specular,
    ChangedLight,
    HistoryLeft,
    NoisyLightOffset,
    LightOffset,
    FastHistory,
    HistoryConfidence,
    AccumulatedLight,
    Surface,
    DenoisedLight,
    DenoisedLightScratch,
    ReflectionMask,
    NoisyReflection,
    AccumulatedReflection,
    ReflectionMoments,
    Reflection,
    Radiance,
    DiffuseFraction,
    BehindWater,
    PaneLight,
    PaneLightBehind,
    BehindGlass,
    FogLight,
    Fog,
    Resolved,
    Bloom0,
    Bloom1,
    Bloom2,
    Bloom3,
    Bloom4,
    Exposure,
    Final,
    HostColor,
    HostDepth,
    kCount
};
inline constexpr size_t kTargetCount = size_t(Target::kCount);

/// The two sizes of a frame: of what is traced, lit and filtered, and of what is shown
/// (RenderSettings::resolutionScale).
enum class Resolution { Render, Display };

/// What a target is made of. Its size is a resolution divided by `divisor`, rounded up.
struct TargetDeclaration {
    Target id;
    const char* name;  ///< for Renderer::readTarget()
    GLenum format;
    Resolution resolution = Resolution::Render;
    int divisor = 1;
    Filter filter = Filter::Nearest;
    bool hasHistory = false;  ///< two textures that alternate, so that last frame's is kept
};

/// Every target of the renderer, in the order of the enum.
inline constexpr std::array<TargetDeclaration, kTargetCount> kTargets = [] {
    using enum Target;
    using enum Resolution;
    constexpr Filter kLinear = Filter::Linear, kNearest = Filter::Nearest;
    constexpr bool kHistory = true;
    constexpr int kOneTexel = 1 << 20;  // larger than any view
    return std::array<TargetDeclaration, kTargetCount>{{
        // The G-buffer: lib/gbuffer.glsl.
        {Albedo, "albedo", GL_RGBA8},
        {Normal, "normal", GL_RGBA16F},
        {Material, "material", GL_RGBA8},
        {Motion, "motion", GL_RG16F},
        {Depth, "depth", GL_R32F},
        {DepthBuffer, "depthBuffer", GL_DEPTH_COMPONENT32F},
        {GlassMask, "glassMask", GL_R8},
        {DryAlbedo, "dryAlbedo", GL_RGBA8},
        {DryMaterial, "dryMaterial", GL_RGBA8},
        {GlassTint, "glassTint", GL_RGBA8},
        {GlassSurface, "glassSurface", GL_RGBA16F},
        {GlassDepth, "glassDepth", GL_DEPTH_COMPONENT32F},

        // Light as it is sampled: rgb mean radiance of sky, indirect light and local lights, a visible share of the
        // sun.
        {NoisyLight, "noisyLight", GL_RGBA16F},
        {HitProximity, "hitProximity", GL_R8},  // how near the sky rays' hits are
        {Specular, "specular", GL_RGBA16F, Render, 1, kLinear, kHistory},

        // Denoising.
        {ChangedLight, "changedLight", GL_RGBA16F},  // passes/changed_lights.frag; after changes of lights
        {HistoryLeft, "historyLeft", GL_RGBA8},      // passes/history_left.frag; after changes
        {NoisyLightOffset, "noisyLightOffset", GL_RGBA16F, Render, 4},  // passes/light_offset.frag; the same
        {LightOffset, "lightOffset", GL_RGBA16F, Render, 4, kLinear},
        {FastHistory, "fastHistory", GL_RGBA16F, Render, 4, kLinear, kHistory},  // passes/light_change.frag
        {HistoryConfidence, "historyConfidence", GL_RGBA8, Render, 4, kLinear, kHistory},
        {AccumulatedLight, "accumulatedLight", GL_RGBA16F, Render, 1, kLinear, kHistory},
        {Surface, "surface", GL_RGBA32F, Render, 1, kLinear, kHistory},  // lib/surface_history.glsl
        {DenoisedLight, "denoisedLight", GL_RGBA16F},
        {DenoisedLightScratch, "denoisedLightScratch", GL_RGBA16F},

        // Composition.
        {ReflectionMask, "reflectionMask", GL_DEPTH_COMPONENT32F},
        {NoisyReflection, "noisyReflection", GL_RGBA16F},
        {AccumulatedReflection, "accumulatedReflection", GL_RGBA16F, Render, 1, kLinear, kHistory},
        {ReflectionMoments, "reflectionMoments", GL_RGBA16F, Render, 1, kLinear, kHistory},
        {Reflection, "reflection", GL_RGBA16F},
        {Radiance, "radiance", GL_RGBA16F, Render, 1, kLinear, kHistory},
        {DiffuseFraction, "diffuseFraction", GL_R8, Render, 1, kLinear, kHistory},
        {BehindWater, "behindWater", GL_RGBA16F},
        {PaneLight, "paneLight", GL_RGBA16F},  // lib/pane_light.glsl; where there are waters
        {PaneLightBehind, "paneLightBehind", GL_RGBA16F},
        {BehindGlass, "behindGlass", GL_RGBA16F},
        {FogLight, "fogLight", GL_RGBA16F, Render, 2, kLinear, kHistory},
        {Fog, "fog", GL_RGBA16F, Render, 2, kLinear},

        // What is shown.
        {Resolved, "resolved", GL_RGBA16F, Display, 1, kLinear, kHistory},
        {Bloom0, "bloom0", GL_RGBA16F, Display, 2, kLinear},
        {Bloom1, "bloom1", GL_RGBA16F, Display, 4, kLinear},
        {Bloom2, "bloom2", GL_RGBA16F, Display, 8, kLinear},
        {Bloom3, "bloom3", GL_RGBA16F, Display, 16, kLinear},
        {Bloom4, "bloom4", GL_RGBA16F, Display, 32, kLinear},
        {Exposure, "exposure", GL_R32F, Display, kOneTexel, kNearest, kHistory},
        {Final, "final", GL_RGBA8, Display},

        // Copies of what the host has drawn.
        {HostColor, "hostColor", GL_RGBA16F, Display},
        {HostDepth, "hostDepth", GL_DEPTH_COMPONENT32F, Display},
    }};
}();
static_assert([] {
    for (size_t i = 0; i < kTargetCount; ++i)
        if (size_t(kTargets[i].id) != i) return false;
    return true;
}());

/// A set of targets: what this frame has drawn into them and what the frame before left in them are told apart.
class TargetSet {
public:
    constexpr TargetSet() = default;
    /// This frame's texture of one target.
    constexpr TargetSet(Target target) : m_current(uint64_t(1) << int(target)) {}

    /// Whether this frame's texture is in the set.
    constexpr bool contains(Target target) const { return m_current >> int(target) & 1; }
    /// Whether last frame's texture is in the set.
    constexpr bool containsPrevious(Target target) const { return m_previous >> int(target) & 1; }

    friend constexpr TargetSet operator|(TargetSet a, TargetSet b);
    friend constexpr TargetSet previous(TargetSet set);

private:
    constexpr TargetSet(uint64_t current, uint64_t previous) : m_current(current), m_previous(previous) {}
    static_assert(kTargetCount <= 64);
    uint64_t m_current = 0, m_previous = 0;
};
constexpr TargetSet operator|(TargetSet a, TargetSet b) {
    return TargetSet(a.m_current | b.m_current, a.m_previous | b.m_previous);
}
constexpr TargetSet operator|(Target a, Target b) {
    return TargetSet(a) | TargetSet(b);
}
/// The textures that the frame before left in these targets.
constexpr TargetSet previous(TargetSet set) {
    return TargetSet(0, set.m_current);
}

/// The targets that the G-buffer pass fills and that lighting passes read.
inline constexpr TargetSet kGBuffer =
    Target::Albedo | Target::Normal | Target::Material | Target::Motion | Target::Depth | Target::DepthBuffer;
/// What is known of the panes of a pixel.
inline constexpr TargetSet kPanes =
    Target::Depth | Target::GlassTint | Target::GlassSurface | Target::GlassDepth | Target::Reflection;
/// What the passes of light look up of the frame before, and what of that still counts.
inline constexpr TargetSet kLightHistory =
    Target::HistoryLeft | previous(Target::AccumulatedLight | Target::Surface | Target::HistoryConfidence);
/// The same for indirect light (lib/bounce.glsl).
inline constexpr TargetSet kBounceHistory =
    Target::HistoryLeft | previous(Target::Radiance | Target::DiffuseFraction | Target::Surface);
/// What makes the history of light that of the lights of now.
inline constexpr TargetSet kRelighting = Target::ChangedLight | Target::LightOffset;
/// What tells anti-aliasing whether a pixel shows what it showed before.
inline constexpr TargetSet kSteadiness = Target::Motion | Target::Surface | Target::GlassSurface |
                                         Target::HistoryConfidence | Target::AccumulatedReflection | kLightHistory;

}  // namespace rubble
