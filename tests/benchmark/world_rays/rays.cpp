#include "tests/benchmark/world_rays/rays.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/core/random.h"
#include "runtime/voxel/cell_walk.h"

namespace rubble::rays {
namespace {

struct Surface {
    bool seen = false;
    glm::dvec3 position{0.0}, normal{0.0};
};

bool walk(const WorldBits& bits, glm::dvec3 origin, glm::dvec3 direction, double maxDistance,
          Surface* surface = nullptr) {
    CellWalk w;
    for (bool inside = w.start({origin, direction, maxDistance}, bits.cells()); inside; inside = w.step()) {
        if (!bits.at(w.cell())) continue;
        if (surface && w.axis() >= 0) {
            surface->seen = true;
            surface->position = origin + direction * w.t();
            surface->normal[w.axis()] = w.sign();
        }
        return true;
    }
    return false;
}

std::vector<Surface> surfacesOf(const WorldBits& bits, const RayView& view) {
    const glm::dvec3 forward = glm::normalize(view.along),
                     right = glm::normalize(glm::cross(forward, glm::dvec3(0, 1, 0)));
    const glm::dvec3 up = glm::cross(right, forward);
    std::vector<Surface> out(size_t(kImageSize.x * kImageSize.y));
    for (size_t i = 0; i < out.size(); ++i) {
        const double x = (double(int(i) % kImageSize.x) + 0.5) / kImageSize.x * 2.0 - 1.0,
                     y = (double(int(i) / kImageSize.x) + 0.5) / kImageSize.y * 2.0 - 1.0;
        walk(bits, view.eye, glm::normalize(forward + right * (0.8 * x) + up * (0.45 * y)), 4000.0, &out[i]);
    }
    return out;
}

glm::dvec3 cosineDirection(glm::dvec3 normal, double u, double v) {
    const glm::dvec3 other = std::fabs(normal.y) > 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 a = glm::normalize(glm::cross(normal, other)), b = glm::cross(normal, a);
    return glm::normalize(a * (std::sqrt(v) * std::cos(6.283185307 * u)) +
                          b * (std::sqrt(v) * std::sin(6.283185307 * u)) + normal * std::sqrt(1.0 - v));
}

Ray makeRay(const Surface& from, RayKind kind, double maxDistance, double u, double v) {
    const glm::dvec3 origin = from.position + from.normal * 0.52;
    glm::dvec3 direction;
    if (kind == RayKind::Ambient) {
        direction = cosineDirection(from.normal, u, v);
    } else if (kind == RayKind::Sun) {
        direction = glm::normalize(glm::dvec3(-0.5, 0.7, 0.3)) + 0.01 * (glm::dvec3(u, v, u) - 0.5);
        maxDistance = 2000.0;
    } else {
        const glm::dvec3 lightPosition((std::floor(origin.x / 128.0) + 0.5) * 128.0, 35.0,
                                       (std::floor(origin.z / 128.0) + 0.5) * 128.0);
        direction = lightPosition + glm::dvec3(u, v, u) * 2.0 - origin;
        maxDistance = std::min(maxDistance, glm::length(direction) - 1.2);
    }
    if (glm::dot(direction, from.normal) <= 0.0) return {};
    return {glm::vec3(origin), float(maxDistance), glm::vec3(glm::normalize(direction))};
}

bool isStopped(const WorldBits& bits, const Ray& ray, glm::dvec3 moved) {
    return walk(bits, glm::dvec3(ray.origin) + moved, glm::dvec3(ray.direction), double(ray.maxDistance));
}

}  // namespace

RaySet makeRays(const WorldBits& bits, const RayView& view, RayKind kind, double maxDistance) {
    RaySet out{view.name + (kind == RayKind::Ambient ? " ambient"
                            : kind == RayKind::Sun   ? " sun"
                                                     : " local"),
               {},
               {},
               0};
    Random random(uint64_t(kind) + 5);
    for (const Surface& surface : surfacesOf(bits, view)) {
        const double u = double(random.unit()), v = double(random.unit());
        out.rays.push_back(surface.seen ? makeRay(surface, kind, maxDistance, u, v) : Ray());
        out.count += out.rays.back().maxDistance >= 0.0f;
    }
    findReference(bits, out);
    return out;
}

void findReference(const WorldBits& bits, RaySet& set, glm::ivec3 shift) {
    set.stopped.clear();
    for (const Ray& ray : set.rays)
        set.stopped.push_back(ray.maxDistance >= 0.0f && isStopped(bits, ray, glm::dvec3(shift)));
}

bool isGrazing(const WorldBits& bits, const Ray& ray, glm::ivec3 shift) {
    constexpr double kShift = 1e-3;
    const bool here = isStopped(bits, ray, glm::dvec3(shift));
    for (int i = 0; i < 8; ++i)
        if (isStopped(bits, ray, glm::dvec3(shift) + kShift * (2.0 * glm::dvec3(i & 1, i >> 1 & 1, i >> 2) - 1.0)) !=
            here)
            return true;
    return false;
}

}  // namespace rubble::rays
