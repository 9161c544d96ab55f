#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "render/frame/frame_context.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"
#include "tests/benchmark/world_rays/rays.h"

namespace rubble::rays {

/// What one walk says about a set of rays, and what that costs. Milliseconds of this thread's processor time, the GL's
/// included: llvmpipe is told to start no threads.
struct TraceResult {
    std::vector<uint8_t> stopped;
    double milliseconds = 0.0;
};

/// Walks of a world's shadow volume on the GL. The reference's are ours to write: 2x2x2 cells in a byte at full, half
/// and quarter resolution, in a 3D texture or in a buffer.
class Walks {
public:
    /// Needs a GL context. Copies of `patches` are made.
    Walks(const WorldBits& bits, const std::vector<ShadowPatch>& patches);
    ~Walks();
    Walks(const Walks&) = delete;
    Walks& operator=(const Walks&) = delete;

    static const std::vector<std::string>& names();  ///< the exact one first
    /// What no walk can do without: the exact one's way to its first step; the bench's own work.
    static const std::vector<std::string>& baselines();
    uint64_t bytes(const std::string& walk) const;
    /// Brings the exact walk's structure up to date; the others' stay as they were.
    void apply(std::vector<ShadowPatch> patches);
    TraceResult trace(const std::string& walk, const RaySet& set);

private:
    struct Volumes;
    void bind(const std::string& walk, const Program& program);
    std::unique_ptr<Volumes> m_volumes;
    Scene m_scene;
    glm::ivec3 m_low, m_cells;
    std::map<std::string, Program> m_programs;
};

/// Tells llvmpipe to work in the calling thread: before a context is made.
void disableGlThreads();

}  // namespace rubble::rays
