#pragma once
#include <span>
#include <vector>

#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// The local lights in view as shaders read them (lib/local_lights.glsl), and for each tile of the view and slice of
/// depth the ones that reach it: a pixel looks at those alone. Made anew for each frame; costs nothing without lights.
/// [render-thread]
class LightGrid {
public:
    /// Sorts the lights for a camera. `origin`: world position that the GPU's coordinates are relative to. Returns the
    /// bytes sent.
    uint64_t update(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin);
    /// Sets the uniforms of lib/local_lights.glsl. The program must be in use.
    void bind(const Program& program) const;
    /// There is a light, seen or not.
    bool hasLights() const { return !m_previousLights.empty(); }
    /// No light reaches into the view.
    bool empty() const { return m_list.empty(); }
    /// Numbers, in what update() was given, of the lights listed for a pixel at a depth along the view axis.
    std::vector<int> lightsAt(glm::ivec2 pixel, float depth) const;
    int lights() const { return int(m_visible.size()); }
    /// Since one came or went out: what histories of all light may reach back to.
    int framesSinceChange() const { return m_framesSinceChange; }
    /// A light that came or went out, by where it reaches: what histories of places there may reach back to.
    struct Change {
        glm::dvec3 place;  ///< world
        float reach;       ///< metres
        int frames;        ///< since then
    };
    static constexpr size_t kMaxChanges = 16;    ///< passes/local_lights.frag; of more the last reaches everywhere
    static constexpr int kMaxChangeFrames = 32;  ///< frames until one is forgotten
    const std::vector<Change>& changes() const { return m_changes; }
    int tiles() const { return m_size.x * m_size.y; }
    uint64_t bytes() const {
        return m_lightsTexture.bytes() + m_cellsTexture.bytes() + m_listTexture.bytes() + m_imageTexture.bytes();
    }

private:
    /// A light's sphere in the camera's frame (right, up, forward), and the part of the grid around it: tiles and
    /// slices from low to high.
    struct VisibleLight {
        int light;
        glm::vec4 sphere;
        glm::ivec3 low, high;
    };
    void recordChanges(std::span<const SnapshotLight> lights);
    void listVisibleLights(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin);
    bool touches(const VisibleLight& reach, glm::ivec3 cell, const FrameBlock& block) const;
    void fillCells(const FrameBlock& block);
    void moveStrongestFirst(const FrameBlock& block);
    void fillTexels(std::span<const SnapshotLight> lights, glm::dvec3 origin);
    uint64_t upload();

    struct PreviousLight {
        LightHandle light;  ///< empty: of a fire
        glm::dvec3 place;
        float reach;
    };
    static std::vector<PreviousLight> removedFrom(const std::vector<PreviousLight>& before,
                                                  const std::vector<PreviousLight>& now);
    void addChange(const PreviousLight& changed);

    std::vector<PreviousLight> m_previousLights;  ///< that update() was given
    std::vector<Change> m_changes;
    int m_framesSinceChange = 0;
    glm::ivec3 m_size{0};                 ///< tiles across and up, slices
    std::vector<VisibleLight> m_visible;  ///< strongest light first
    std::vector<glm::uvec2> m_cells;  ///< first place in m_list, number; the slice after the last one is for all depths
    std::vector<uint32_t> m_list;
    std::vector<std::pair<uint32_t, uint32_t>> m_pairs;  ///< cell and light, while the list is made
    std::vector<glm::vec4> m_texels;
    std::vector<glm::vec4> m_imageTexels;
    BufferTexture m_lightsTexture{GL_RGBA32F}, m_cellsTexture{GL_RG32UI}, m_listTexture{GL_R32UI},
        m_imageTexture{GL_RGBA32F};
};

}  // namespace rubble
