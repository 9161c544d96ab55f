#include "tests/reference/path_tracer.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <thread>

#include "runtime/core/thread_pool.h"
#include "samples/support/progress.h"
#include "tests/reference/sampling.h"
#include "tests/reference/sky.h"

namespace rubble::reference {
namespace {

using glm::dvec3;
using glm::vec3;

constexpr double kSurfaceOffset = 1e-6;    // metres, enough in double precision
constexpr double kMirrorDistance = 1e5;    // passes/reflections.frag
constexpr double kPlaneHeight = -0.05;     // render/renderer.cpp
constexpr float kPaneReflectance = 0.05f;  // shaders/lib/brdf.glsl
constexpr double kLightClearance = 0.12;   // metres around a light where its own voxels do not block it
constexpr int kRouletteFrom = 4;           // bounces
constexpr double kFilterRadius = 1.5;      // pixels, with exp(-2.3 r^2): shaders/passes/taa.frag

float maxComponent(vec3 c) {
    return std::max(c.r, std::max(c.g, c.b));
}

float power5(float cosine) {
    const float m = 1.0f - std::clamp(cosine, 0.0f, 1.0f);
    return m * m * m * m * m;
}

vec3 fresnel(vec3 f0, float cosine) {
    return f0 + (1.0f - f0) * power5(cosine);
}

vec3 fresnelRough(vec3 f0, float cosine, float roughness) {
    const float smooth = 1.0f - roughness;
    return f0 + (glm::max(vec3(smooth * smooth), f0) - f0) * power5(cosine);
}

float ggxAlpha(float roughness) {
    return std::max(roughness * roughness, 0.003f);
}

/// D of the GGX distribution at the half vector (Walter et al. 2007).
float ggxDistribution(vec3 n, vec3 v, vec3 l, float a2) {
    const float nh = std::clamp(glm::dot(n, glm::normalize(v + l)), 0.0f, 1.0f);
    const float d = nh * nh * (a2 - 1.0f) + 1.0f;
    return a2 / (float(kPi) * d * d);
}

/// specularLobe() of shaders/lib/brdf.glsl.
float specularLobe(vec3 n, vec3 v, vec3 l, float roughness) {
    const float alpha = ggxAlpha(roughness), a2 = alpha * alpha;
    const float nl = std::clamp(glm::dot(n, l), 1e-4f, 1.0f), nv = std::clamp(glm::dot(n, v), 1e-4f, 1.0f);
    const float masking = nl * std::sqrt(nv * nv * (1.0f - a2) + a2) + nv * std::sqrt(nl * nl * (1.0f - a2) + a2);
    return ggxDistribution(n, v, l, a2) * 0.5f / std::max(masking, 1e-5f);
}

/// Density of directions reflected about sampleVisibleNormal(): D G1 / (4 n.v) (Heitz 2018), with Smith's G1.
float ggxVndfPdf(vec3 n, vec3 v, vec3 l, float roughness) {
    const float alpha = ggxAlpha(roughness), a2 = alpha * alpha;
    const float nv = std::clamp(glm::dot(n, v), 1e-4f, 1.0f);
    return ggxDistribution(n, v, l, a2) * 0.5f / (nv + std::sqrt(nv * nv * (1.0f - a2) + a2));
}

/// How a surface reflects each kind of light: surfaceRadiance() of shaders/passes/composite.frag.
struct Response {
    vec3 f0, share;
    vec3 diffuse;        ///< factor of the mean radiance from all around
    vec3 mirror;         ///< factor of a mirror ray's radiance
    vec3 diffuseAlbedo;  ///< factor of irradiance / pi of sun and lights, which have highlights of their own
    float lobe;          ///< share of a light's highlight that is analytic; mirror rays bring the rest
};

Response responseOf(const Surface& s, vec3 view) {
    Response r;
    r.f0 = glm::mix(vec3(s.reflectivity), s.albedo, s.metallic);
    r.share = fresnelRough(r.f0, glm::dot(vec3(s.normal), view), s.roughness);
    const float smoothness = 1.0f - glm::smoothstep(0.35f, 0.6f, s.roughness);
    r.diffuseAlbedo = s.albedo * (1.0f - s.metallic) * (1.0f - r.share);
    r.diffuse = r.diffuseAlbedo + r.share * (1.0f - smoothness);
    r.mirror = r.share * smoothness;
    r.lobe = glm::smoothstep(0.1f, 0.25f, s.roughness);
    return r;
}

class Tracer {
public:
    Tracer(const Scene& scene, const View& view, const Settings& settings)
        : m_scene(scene), m_air(scene.environment()), m_settings(settings), m_view(view) {
        m_sun = glm::normalize(dvec3(m_air.sunDirection));
    }

    /// One sample of a pixel.
    vec3 sample(glm::ivec2 pixel, Random& random) const {
        const Ray ray = cameraRay(pixel, random);
        const Surface s = m_scene.closest(ray);
        if (m_settings.term == Term::Full) return fullRadiance(ray, s, random);
        if (m_settings.term == Term::Reflection) return reflection(ray, s, random);
        if (!s.hit) return vec3(0.0f);
        if (m_settings.term == Term::LocalLights) return localLights(s, random);
        if (m_settings.term == Term::Sky)
            return incoming({{offsetOrigin(s), cosineDirection(s.normal, unitSquare(random))}, vec3(1.0f), true, 0.0f},
                            random);
        if (glm::dot(s.normal, m_sun) <= 0.0) return vec3(0.0f);
        return vec3(m_scene.transmittance({offsetOrigin(s), sunRay(random)}).x, 0.0f, 0.0f);
    }

private:
    Ray cameraRay(glm::ivec2 pixel, Random& random) const {
        glm::dvec2 place = glm::dvec2(pixel) + 0.5;
        while (m_settings.filterPixels) {
            const glm::dvec2 offset = (unitSquare(random) * 2.0 - 1.0) * kFilterRadius;
            if (random.unit() >= std::exp(-2.3 * glm::dot(offset, offset))) continue;
            place += offset;
            break;
        }
        const glm::dvec2 p = place / glm::dvec2(m_view.size) * 2.0 - 1.0;
        const double tanY = std::tan(double(m_view.verticalFov) * 0.5), tanX = tanY * m_view.size.x / m_view.size.y;
        return {m_view.position, glm::normalize(m_view.rotation * dvec3(p.x * tanX, p.y * tanY, -1.0))};
    }

    static dvec3 offsetOrigin(const Surface& s) { return s.position + s.normal * kSurfaceOffset; }
    dvec3 sunRay(Random& random) const {
        return coneDirection(m_sun, std::cos(double(m_air.sunAngle)), unitSquare(random));
    }

    /// One of the lights, and 1 / its probability.
    struct LightChoice {
        const SnapshotLight* light = nullptr;
        float weight = 0.0f;
        dvec3 toCentre;  ///< from the surface; of a capsule, to one of the spheres on its axis
    };
    /// In proportion to what each would give without occlusion.
    LightChoice chooseLight(const Surface& s, Random& random) const {
        const auto& lights = m_scene.lights();
        float sum = 0.0f;
        for (const SnapshotLight& light : lights) sum += unshadowedWeight(light, s);
        if (sum <= 0.0f) return {};
        float left = random.unit() * sum;
        size_t chosen = 0;
        for (size_t i = 0; i < lights.size(); ++i) {
            const float own = unshadowedWeight(lights[i], s);
            if (own <= 0.0f) continue;
            chosen = i;
            left -= own;
            if (left < 0.0f) break;
        }
        const SnapshotLight& light = lights[chosen];
        dvec3 toCentre = light.position - offsetOrigin(s);
        if (light.kind == LightKind::Capsule)
            toCentre += dvec3(light.right) * (light.width * (double(random.unit()) - 0.5));
        return {&light, sum / unshadowedWeight(light, s), toCentre};
    }

    /// Irradiance of one local light / pi, divided by its probability.
    vec3 localLights(const Surface& s, Random& random) const {
        const LightChoice chosen = chooseLight(s, random);
        if (!chosen.light) return vec3(0.0f);
        const dvec3 direction = sampleLightDirection(chosen, random);
        const LightSample lightSample = evaluateLight(chosen, s, direction);
        return lightSample.pdf > 0.0
                   ? lightSample.radiance * float(glm::dot(direction, s.normal) / (lightSample.pdf * kPi))
                   : vec3(0.0f);
    }

    /// Falls smoothly to 0 at a light's reach: lightWindow() of shaders/lib/local_lights.glsl.
    static float distanceWindow(const SnapshotLight& light, double distance) {
        const double ratio = distance / light.reach;
        const float window = float(std::clamp(1.0 - ratio * ratio * ratio * ratio, 0.0, 1.0));
        return window * window;
    }

    static float coneAttenuation(const SnapshotLight& light, dvec3 toCentre) {
        if (light.kind != LightKind::Cone) return 1.0f;
        const float outer = std::cos(light.coneOuter), inner = std::cos(light.coneInner);
        const float cosine = float(glm::dot(-glm::normalize(toCentre), dvec3(light.direction)));
        const float edge = std::clamp((cosine - outer) / std::max(inner - outer, 1e-3f), 0.0f, 1.0f);
        return edge * edge;
    }

    static bool isFlat(const SnapshotLight& light) {
        return light.kind == LightKind::Area || light.kind == LightKind::Screen;
    }

    /// Radius around a light's position that holds all of it.
    static double extentOf(const SnapshotLight& light) {
        if (isFlat(light)) return 0.5 * std::hypot(light.width, light.height);
        return light.radius + (light.kind == LightKind::Capsule ? 0.5 * light.width : 0.0);
    }

    /// Weight of a light in the choice: above 0 wherever it may send anything.
    static float unshadowedWeight(const SnapshotLight& light, const Surface& s) {
        const dvec3 toCentre = light.position - s.position;
        const double range = glm::length(toCentre), extent = extentOf(light);
        if (glm::dot(toCentre, s.normal) <= -extent) return 0.0f;
        const double facing =
            std::clamp((glm::dot(toCentre, s.normal) + (isFlat(light) ? extent : 0.0)) / range, 0.05, 1.0);
        const double square = std::max(range * range, light.kind == LightKind::Sphere ? 1e-4 : extent * extent);
        return float(facing / square) * maxComponent(light.color) *
               distanceWindow(light, std::max(range - extent, 0.0)) * coneAttenuation(light, toCentre);
    }

    /// Transmittance of a shadow ray that ends before a light's own voxels.
    vec3 visibility(const Surface& s, dvec3 direction, double clear) const {
        return clear > 0.0 ? m_scene.transmittance({offsetOrigin(s), direction, clear}) : vec3(1.0f);
    }

    /// A direction to a random point of a light: of a sphere uniform over its cone, of a rectangle uniform over its
    /// area.
    static dvec3 sampleLightDirection(const LightChoice& chosen, Random& random) {
        const SnapshotLight& light = *chosen.light;
        const glm::dvec2 u = unitSquare(random);
        if (!isFlat(light)) {
            const double range = glm::length(chosen.toCentre), sine = sineOf(light, range);
            return coneDirection(chosen.toCentre / range, std::sqrt(1.0 - sine * sine), u);
        }
        const dvec3 right(light.right), up = glm::cross(right, dvec3(light.direction));
        return glm::normalize(chosen.toCentre + right * ((u.x - 0.5) * light.width) +
                              up * ((u.y - 0.5) * light.height));
    }

    /// Sine of the half angle of a sphere's cone; the surface counts as outside the sphere.
    static double sineOf(const SnapshotLight& light, double range) {
        return std::min(light.radius / range, 1.0 / 1.001);
    }

    /// What a chosen light sends to a surface along a direction.
    struct LightSample {
        vec3 radiance{0.0f};  ///< divided by the light's probability
        double pdf = 0.0;     ///< of sampleLightDirection(), over solid angle; 0: the direction misses the light
    };
    LightSample evaluateLight(const LightChoice& chosen, const Surface& s, dvec3 direction) const {
        if (glm::dot(direction, s.normal) <= 0.0) return {};
        LightSample lightSample =
            isFlat(*chosen.light) ? evaluateRectangle(chosen, s, direction) : evaluateSphere(chosen, s, direction);
        lightSample.radiance *= chosen.weight;
        return lightSample;
    }

    /// A sphere of even radiance color / (pi radius^2).
    LightSample evaluateSphere(const LightChoice& chosen, const Surface& s, dvec3 direction) const {
        const SnapshotLight& light = *chosen.light;
        const double radius = light.radius, sine = sineOf(light, glm::length(chosen.toCentre)), range = radius / sine;
        const dvec3 axis = glm::normalize(chosen.toCentre), aside = glm::cross(direction, axis);
        const double off = glm::dot(aside, aside), cosine = glm::dot(direction, axis);
        if (cosine <= 0.0 || off > sine * sine) return {};
        const double near = std::max(range * cosine - std::sqrt(radius * radius - range * range * off), 0.0);
        // 1 - cos as sin^2 / (1 + cos), which loses no digits.
        const double solidAngle = 2.0 * kPi * sine * sine / (1.0 + std::sqrt(1.0 - sine * sine));
        return {visibility(s, direction, near - std::max(kLightClearance, radius)) * light.color *
                    float(1.0 / (kPi * radius * radius)) * distanceWindow(light, near) *
                    coneAttenuation(light, chosen.toCentre),
                1.0 / solidAngle};
    }

    /// A rectangle of radiance color / its area, times its image.
    LightSample evaluateRectangle(const LightChoice& chosen, const Surface& s, dvec3 direction) const {
        const SnapshotLight& light = *chosen.light;
        const dvec3 right(light.right), axis(light.direction), up = glm::cross(right, axis);
        const double turned = -glm::dot(direction, axis), cosine = light.twoSided ? std::abs(turned) : turned;
        const double range = -glm::dot(chosen.toCentre, axis) / turned;
        if (!(cosine > 0.0 && range > 0.0)) return {};
        const dvec3 onFace = direction * range - chosen.toCentre;
        const glm::dvec2 u =
            glm::dvec2(glm::dot(onFace, right) / light.width, glm::dot(onFace, up) / light.height) + 0.5;
        if (std::min(u.x, u.y) < 0.0 || std::max(u.x, u.y) >= 1.0) return {};
        const double area = double(light.width) * light.height;
        const vec3 through =
            visibility(s, direction, range - std::max(kLightClearance, double(light.radius)) / std::max(cosine, 0.1));
        return {through * light.color * screenImageAt(light, u) * float(1.0 / area) * distanceWindow(light, range),
                range * range / (cosine * area)};
    }

    /// u: along `right` and up. A viewer has the screen's right on the left.
    static vec3 screenImageAt(const SnapshotLight& light, glm::dvec2 u) {
        const LightImage& image = light.image;
        if (light.kind != LightKind::Screen || image.texels.empty()) return vec3(1.0f);
        const uint32_t column = std::min(uint32_t((1.0 - u.x) * image.width), image.width - 1);
        const uint32_t row = std::min(uint32_t((1.0 - u.y) * image.height()), image.height() - 1);
        const uint32_t texel = image.texels[column + row * image.width];
        return linear(vec3(float(texel >> 16 & 255), float(texel >> 8 & 255), float(texel & 255)) / 255.0f);
    }

    /// Direct light of sun and local lights, as the surface reflects it.
    vec3 direct(const Surface& s, const Response& r, vec3 view, Random& random) const {
        vec3 sum(0.0f);
        if (m_air.sunDirection.y > 0.0f) {
            const dvec3 l = sunRay(random);
            const float facing = float(glm::dot(s.normal, l));
            if (facing > 0.0f) {
                const vec3 sun = m_air.sunColor * facing * m_scene.transmittance({offsetOrigin(s), l});
                const vec3 toSun(m_sun), half = glm::normalize(view + toSun);
                sum += r.diffuseAlbedo * sun / float(kPi);
                sum += glm::min(
                    sun * fresnel(r.f0, glm::dot(view, half)) * specularLobe(vec3(s.normal), view, toSun, s.roughness),
                    vec3(30.0f));
            }
        }
        const LightChoice chosen = chooseLight(s, random);
        if (!chosen.light) return sum;
        // The highlight takes one sample of the light and one of the lobe, weighted by the balance heuristic (Veach
        // and Guibas 1995).
        const bool byLobe = r.lobe > 0.0f && m_settings.lobeSamples;
        const auto lobePdf = [&](vec3 l) { return byLobe ? ggxVndfPdf(vec3(s.normal), view, l, s.roughness) : 0.0f; };
        const auto highlight = [&](vec3 l) {
            return r.lobe * fresnel(r.f0, glm::dot(view, glm::normalize(view + l))) *
                   specularLobe(vec3(s.normal), view, l, s.roughness);
        };
        const dvec3 toLight = sampleLightDirection(chosen, random);
        if (const LightSample lightSample = evaluateLight(chosen, s, toLight); lightSample.pdf > 0.0) {
            const vec3 l(toLight), irradiance = lightSample.radiance * float(glm::dot(toLight, s.normal));
            sum += irradiance * (r.diffuseAlbedo / float(kPi * lightSample.pdf) +
                                 highlight(l) / (float(lightSample.pdf) + lobePdf(l)));
        }
        if (!byLobe) return sum;
        const glm::dmat3 basis = orthonormalBasis(s.normal);
        const dvec3 v(view), half = basis * sampleVisibleNormal(v * basis, ggxAlpha(s.roughness), unitSquare(random));
        const dvec3 mirrored = 2.0 * glm::dot(v, half) * half - v;
        if (const LightSample lightSample = evaluateLight(chosen, s, mirrored); lightSample.pdf > 0.0) {
            const vec3 l(mirrored), irradiance = lightSample.radiance * float(glm::dot(mirrored, s.normal));
            sum += irradiance * highlight(l) / (float(lightSample.pdf) + lobePdf(l));
        }
        return sum;
    }

    /// A direction reflected about a visible normal.
    dvec3 mirrorDirection(dvec3 normal, dvec3 view, float roughness, Random& random) const {
        dvec3 half = normal;
        if (roughness > 0.03f) {
            const glm::dmat3 basis = orthonormalBasis(normal);
            half = basis * sampleVisibleNormal(view * basis, double(roughness) * roughness, unitSquare(random));
        }
        dvec3 direction = 2.0 * glm::dot(view, half) * half - view;
        direction += normal * std::max(0.0, 0.02 - glm::dot(direction, normal));
        return glm::normalize(direction);
    }

    /// The next ray of a path.
    struct Next {
        Ray ray;
        vec3 weight;
        bool diffuse;
        float emissionWeight;  ///< factor for the emission of voxels that have a light of their own
    };
    Next next(const Surface& s, const Response& r, dvec3 view, Random& random) const {
        const float diffuse = maxComponent(r.diffuse), mirror = maxComponent(r.mirror), all = diffuse + mirror;
        if (all <= 0.0f) return {{}, vec3(0.0f), true, 0.0f};
        if (random.unit() * all < diffuse)
            return {{offsetOrigin(s), cosineDirection(s.normal, unitSquare(random))},
                    r.diffuse * (all / diffuse),
                    true,
                    0.0f};
        return {{offsetOrigin(s), mirrorDirection(s.normal, view, s.roughness, random)},
                r.mirror * (all / mirror),
                false,
                1.0f - r.lobe};
    }

    /// Radiance along a ray of a path. Only mirrors show haze: it would light closed rooms.
    vec3 incoming(const Next& first, Random& random) const {
        vec3 sum(0.0f), weight(1.0f);
        Ray ray = first.ray;
        bool diffuse = first.diffuse;
        float emissionWeight = first.emissionWeight;
        for (int bounce = 0;; ++bounce) {
            ray.tMax = diffuse ? m_settings.maxDistance : kMirrorDistance;
            const Surface s = m_scene.closest(ray);
            weight *= m_scene.panes({ray.origin, ray.direction, std::min(s.t, ray.tMax)}).tint;
            const vec3 origin(ray.origin), direction(ray.direction);
            if (!s.hit)
                return sum + weight * (diffuse ? skyRadiance(m_air, direction)
                                               : mirroredBackground(m_air, direction, origin,
                                                                    float(ray.origin.y - kPlaneHeight)));
            if (!diffuse) {
                const float haze = hazeAmount(m_air, float(s.t));
                sum += weight * haze * hazeRadiance(m_air, direction);
                weight *= 1.0f - haze;
            }
            if (bounce == m_settings.bounces) return sum;
            const dvec3 view = -ray.direction;
            const Response response = responseOf(s, vec3(view));
            sum += weight * s.albedo * s.emission * (s.hasLight ? emissionWeight : 1.0f);
            sum += weight * direct(s, response, vec3(view), random);
            const Next n = next(s, response, view, random);
            weight *= n.weight;
            if (bounce >= kRouletteFrom) {
                const float survival = std::min(maxComponent(weight), 0.95f);
                if (random.unit() >= survival) return sum;
                weight /= survival;
            }
            if (maxComponent(weight) <= 0.0f) return sum;
            ray = n.ray, diffuse = n.diffuse, emissionWeight = n.emissionWeight;
        }
    }

    /// As in shaders/lib/mirror.glsl and passes/reflections.frag.
    vec3 reflection(const Ray& ray, const Surface& s, Random& random) const {
        const Panes pane = m_scene.panes({ray.origin, ray.direction, s.t});
        if (!pane.any && !s.hit) return vec3(0.0f);
        Surface at = s;
        if (pane.any) at.position = pane.position, at.normal = pane.normal, at.roughness = 0.0f;
        const float emissionWeight = 1.0f - glm::smoothstep(0.1f, 0.25f, at.roughness);
        return incoming({{offsetOrigin(at), mirrorDirection(at.normal, -ray.direction, at.roughness, random)},
                         vec3(1.0f),
                         false,
                         emissionWeight},
                        random);
    }

    vec3 fullRadiance(const Ray& ray, const Surface& s, Random& random) const {
        const vec3 direction(ray.direction);
        const Panes pane = m_scene.panes({ray.origin, ray.direction, s.t});
        // The pane's reflection or what lies behind, drawn by Fresnel's share.
        if (pane.any) {
            const float share =
                fresnel(vec3(kPaneReflectance), std::abs(float(glm::dot(pane.normal, ray.direction)))).x;
            if (random.unit() < std::min(1.6f * share, 1.0f)) return reflection(ray, s, random);
        }
        if (!s.hit)
            return pane.tint *
                   backgroundRadiance(m_air, direction, vec3(ray.origin), float(ray.origin.y - kPlaneHeight));
        const Response response = responseOf(s, -direction);
        vec3 color = s.albedo * s.emission + direct(s, response, -direction, random);
        const Next n = next(s, response, -ray.direction, random);
        if (maxComponent(n.weight) > 0.0f) color += n.weight * incoming(n, random);
        return pane.tint * glm::mix(color, hazeRadiance(m_air, direction), hazeAmount(m_air, float(s.t)));
    }

    const Scene& m_scene;
    const Environment& m_air;
    Settings m_settings;
    View m_view;
    dvec3 m_sun;
};

}  // namespace

Estimate render(const Scene& scene, const View& view, const Settings& settings, const std::string& what) {
    const Tracer tracer(scene, view, settings);
    Estimate estimate{FloatImage(view.size), FloatImage(view.size), settings.samples};
    Progress progress(what, view.size.y);
    std::mutex mutex;
    int done = 0;
    ThreadPool pool(int(std::max(1u, std::thread::hardware_concurrency())));
    pool.run(size_t(view.size.y), [&](size_t row) {
        for (int x = 0; x < view.size.x; ++x) {
            Random random(settings.seed * 0x9e3779b97f4a7c15ull + row * 65536 + uint64_t(x), row * 65536 + uint64_t(x));
            glm::dvec3 sum(0.0), squares(0.0);
            for (int i = 0; i < settings.samples; ++i) {
                const glm::dvec3 value(tracer.sample({x, int(row)}, random));
                sum += value;
                squares += value * value;
            }
            const glm::dvec3 mean = sum / double(settings.samples);
            const glm::dvec3 variance = glm::max(squares / double(settings.samples) - mean * mean, 0.0);
            estimate.mean.at(x, int(row)) = glm::vec4(vec3(mean), 1.0f);
            estimate.variance.at(x, int(row)) =
                glm::vec4(vec3(variance * (settings.samples / std::max(settings.samples - 1.0, 1.0))), 0.0f);
        }
        const std::lock_guard lock(mutex);
        if (++done; !what.empty()) progress.advance(done);
    });
    return estimate;
}

}  // namespace rubble::reference
