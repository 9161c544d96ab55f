#pragma once
#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "runtime/frame/frame_snapshot.h"

namespace rubble::reference {

/// A ray in world metres; the direction has unit length.
struct Ray {
    glm::dvec3 origin, direction;
    double tMax = 1e30;
};

/// What a ray hits, with the material as shaders/lib/gbuffer.glsl reads it.
struct Surface {
    bool hit = false;
    double t = 1e30;
    glm::dvec3 position{0.0}, normal{0.0};
    glm::vec3 albedo{0.0f};  ///< linear
    float emission = 0.0f, roughness = 1.0f, metallic = 0.0f, reflectivity = 0.0f;
    bool hasLight = false;  ///< its light group has a light, which does the lighting instead of these voxels
};

/// The nearest pane on a ray, and the transmittance of all of them.
struct Panes {
    bool any = false;
    double t = 0.0;
    glm::dvec3 position{0.0}, normal{0.0};
    glm::vec3 tint{1.0f};
};

/// sRGB to linear, channels in [0, 1].
glm::vec3 linear(glm::vec3 srgb);

/// A FrameSnapshot for rays on the CPU, which go through the voxels of each shape in its exact pose, not through the
/// shadow volume. Bodies and lights only: no ropes, water or particles. Many threads may read it at once.
class Scene {
public:
    /// The snapshot must be complete (replacesAll).
    explicit Scene(const FrameSnapshot& snapshot);

    /// The nearest opaque voxel.
    Surface closest(const Ray& ray) const;
    /// Transmittance of the ray up to tMax: 0 if anything opaque is on it, tinted by glass.
    glm::vec3 transmittance(const Ray& ray) const;
    /// The glass up to tMax.
    Panes panes(const Ray& ray) const;

    /// Sun, sky and haze of the snapshot.
    const Environment& environment() const { return m_environment; }
    /// The local lights of the snapshot.
    const std::vector<SnapshotLight>& lights() const { return m_lights; }
    /// Hash of everything visible: the key of cached estimates.
    uint64_t hash() const { return m_hash; }

private:
    struct Entry {
        glm::vec3 albedo, glassTint;
        float emission, roughness, metallic, reflectivity;
        bool hasLight;
    };
    struct Shape {
        VoxelGrid grid;
        Pose pose;
        double voxelSize;
        PaintColorsRef paint;
        size_t palette;  ///< in m_palettes
        glm::dvec3 low, high;
    };
    struct PaletteTable {
        PaletteRef key;
        std::array<Entry, 256> entries;
        std::array<bool, 256> opaque, glass;
        bool hasGlass;
    };
    struct Node {
        glm::dvec3 low, high;
        int first, count;  ///< shapes of a leaf; else the first of two nodes, and 0
    };
    size_t paletteIndex(const PaletteRef& palette);
    void build(int node, int first, int count);
    template <class F>
    void forEachShapeOnRay(const Ray& ray, const double& tMax, F&& f) const;
    glm::vec3 colorAt(const Shape& shape, const PaletteTable& table, glm::ivec3 cell) const;
    void addPanes(const Shape& shape, const Ray& ray, Panes& panes) const;

    std::vector<Shape> m_shapes;
    std::vector<PaletteTable> m_palettes;
    std::vector<Node> m_nodes;
    std::vector<SnapshotLight> m_lights;
    Environment m_environment;
    bool m_hasGlass = false;
    uint64_t m_hash = 0;
};

}  // namespace rubble::reference
