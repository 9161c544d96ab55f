#pragma once
#include <span>
#include <vector>

#include "render/frame/shader_constants.h"
#include "render/gl/program.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

struct FrameBlock;

/// Clustered shading (Olsson, Billeter and Assarsson 2012): the lights in view, as shaders read them, and for each cell
/// of the view frustum (a tile of the screen, a slice of depth) the list of those that reach it, so that a pixel weighs
/// only these. Rebuilt for each frame; free without lights. Read by lib/local_lights.glsl. [render-thread]
class LightGrid {
public:
    /// Rebuilds it for a camera. origin: the point of the world that GPU coordinates are relative to. isSameMoment: it
    /// is another view of the lights of the last update(). Returns the bytes sent.
    uint64_t update(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin,
                    bool isSameMoment = false);
    /// Sets the uniforms of lib/local_lights.glsl. grid: null if the scene has none. The program must be in use.
    static void bind(const Program& program, const LightGrid* grid);
    /// Whether there is a light, in view or not.
    bool hasLights() const { return !m_lastLights.empty(); }
    /// Whether no light reaches into the view.
    bool empty() const { return m_list.empty(); }
    /// The lights listed for a pixel at a linear depth, as indices into what update() was given.
    std::vector<int> lightsAt(glm::ivec2 pixel, float depth) const;
    /// Number of lights in view.
    int lights() const { return int(m_visible.size()); }
    /// Frames since any light changed: limits histories that mix the light of several places.
    int framesSinceChange() const { return m_framesSinceChange; }
    /// What a light sends to a place, as far as changes of it are concerned.
    struct Sent {
        SnapshotLight light;  ///< without an image: its colour is times the image's mean; 0: it is out
        float extent;         ///< radius around the position that holds all of it, metres
        glm::vec4 falloff;    ///< angular: see angularFalloff() in the source
    };
    /// A light that appeared, went out, moved or became another colour.
    struct Change {
        Sent before, after;
        int frames;    ///< since then
        bool isRelit;  ///< the light's differences were, or are, in differences()
        /// Metres around `after` that it reached or reaches; infinite: everywhere.
        float range() const;
    };
    /// All lights, each as it was when its last change counted.
    const std::vector<Sent>& sent() const { return m_lastLights; }
    /// If there are more changes, the last one counts as reaching everywhere.
    static constexpr size_t kMaxChanges = shared::kMaxLightChanges;
    /// Frames for which changes count for accumulation. In the first frame with a new light, indirect light still comes
    /// from the frame before: its history is not kept either.
    static constexpr int kOldestForAccumulation = 1;
    static constexpr int kMaxChangeFrames = 32;  ///< frames after which a change is dropped
    /// The changes of the last frames. After a cut there are none, as no history is left.
    std::span<const Change> changes() const { return m_isCut ? std::span<const Change>() : m_changes; }
    /// The most lights of differences().
    static constexpr size_t kMaxDifferences = 8;
    using Differences = std::span<const SnapshotLight>;
    /// How what lights send differs from the frame before, as lights whose colour is what is sent more or, below 0,
    /// less: a light of another colour is one, one that moved is two. Fires are none.
    Differences differences() const { return m_isCut ? Differences() : m_differences; }
    /// The number of the first of them among the lights that shaders read.
    int firstDifference() const { return int(m_visible.size()); }
    /// Number of tiles of the view.
    int tiles() const { return m_size.x * m_size.y; }
    /// GPU memory.
    uint64_t bytes() const {
        return m_lightsTexture.bytes() + m_cellsTexture.bytes() + m_listTexture.bytes() + m_imageTexture.bytes();
    }

private:
    /// A light's bounding sphere in view space (right, up, forward), and the cells around it from low to high,
    /// inclusive.
    struct VisibleLight {
        int light;
        glm::vec4 sphere;
        glm::ivec3 low, high;
    };
    void recordChanges(std::span<const SnapshotLight> lights);
    void findDifferences(std::vector<Sent> now);
    void addDifference(SnapshotLight light);
    void listVisibleLights(std::span<const SnapshotLight> lights, const FrameBlock& block, glm::dvec3 origin);
    bool reaches(const VisibleLight& light, glm::ivec3 cell, const FrameBlock& block) const;
    void fillCells(const FrameBlock& block);
    void moveStrongestFirst(const FrameBlock& block);
    void addTexels(const SnapshotLight& light, glm::dvec3 origin);
    uint64_t upload();

    void addChange(const Sent& before, const Sent& after);

    std::vector<Sent> m_lastLights;  ///< of the last update(): see sent()
    std::vector<Sent> m_drawn;       ///< of the last update(): all but fires, by handle, each as it was then
    std::vector<SnapshotLight> m_differences;
    std::vector<Change> m_changes;
    bool m_isCut = false;  ///< the last update() was for a view without history
    int m_framesSinceChange = 0;
    glm::ivec3 m_size{0};                 ///< tiles across and up, slices
    std::vector<VisibleLight> m_visible;  ///< strongest first
    /// First index in m_list and count, by cell. A last slice lists the lights of a tile at any depth.
    std::vector<glm::uvec2> m_cells;
    std::vector<uint32_t> m_list;                        ///< indices into m_visible
    std::vector<std::pair<uint32_t, uint32_t>> m_pairs;  ///< cell and light, while m_list is built
    std::vector<glm::vec4> m_texels;
    std::vector<glm::vec4> m_imageTexels;
    BufferTexture m_lightsTexture{GL_RGBA32F}, m_cellsTexture{GL_RG32UI}, m_listTexture{GL_R32UI},
        m_imageTexture{GL_RGBA32F};
    bool m_fullLogged = false;
};

}  // namespace rubble
