#pragma once
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "render/frame/frame_context.h"
#include "render/gl/program.h"
#include "render/scene/scene.h"
#include "tests/benchmark/world_rays/rays.h"

namespace rubble::rays {

/// The answers of one walk to a set of rays, and their processor time in this thread. It includes the GL's, as llvmpipe
/// is told to start no threads.
struct TraceResult {
    std::vector<uint8_t> stopped;
    double milliseconds = 0.0;
};

/// Walks through a world's shadow volume on the GL: the renderer's, and our versions of Teardown's, which store 2x2x2
/// cells in a byte at full, half and quarter resolution, in a 3D texture or in a buffer.
class Walks {
public:
    /// Needs a current GL context.
    Walks(const WorldBits& bits, const std::vector<ShadowPatch>& patches);
    ~Walks();
    Walks(const Walks&) = delete;
    Walks& operator=(const Walks&) = delete;

    /// All walks, the exact one first.
    static const std::vector<std::string>& names();
    /// Lower bounds: the exact walk with only one step, and the benchmark without any walk.
    static const std::vector<std::string>& baselines();
    /// GPU memory of a walk's data.
    uint64_t bytes(const std::string& walk) const;
    /// Updates the data of the exact walk; that of the others stays.
    void apply(std::vector<ShadowPatch> patches);
    /// Traces all rays of a set once.
    TraceResult trace(const std::string& walk, const RaySet& set);

private:
    struct Volumes;
    void bind(const std::string& walk, const Program& program);
    std::unique_ptr<Volumes> m_volumes;
    Scene m_scene;
    glm::ivec3 m_low, m_cells;
    std::map<std::string, Program> m_programs;
};

/// Makes llvmpipe work in the calling thread. Call it before a context is made.
void disableGlThreads();

}  // namespace rubble::rays
