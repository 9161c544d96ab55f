#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/shader_library/fullscreen_program.h"

namespace rubble {

/// Owns every program of the renderer, built from the files of shaders/ or their copies in the library. A program that
/// fails to build is empty, so its pass is skipped, and errors() says why. [render-thread]
class ShaderLibrary {
public:
    /// As what full-screen shaders are built.
    enum class Fullscreen {
        Fragment,
        Compute,
        Both,  ///< the fragment program alone, where the compute program does not build
    };
    /// folder: where shaders/ lies, for those who change it; empty: the copies in the library, which never change.
    /// defines: whole lines that precede all shaders. cache: null for none; must outlive it.
    explicit ShaderLibrary(std::filesystem::path folder, Fullscreen fullscreen = Fullscreen::Fragment,
                           std::string defines = {}, ProgramCache* cache = nullptr);

    /// The program of these files, relative to the shader folder, built at the first call. The reference stays valid; a
    /// reload puts a new program into it. missing: what to log if it does not build, as "ropes are not drawn"; null:
    /// nothing.
    const Program& load(const std::string& fragmentFile, const std::string& vertexFile = "lib/fullscreen.vert",
                        const char* missing = nullptr);
    /// A full-screen shader, built at the first call. The reference stays valid. missing: as of load().
    FullscreenProgram& loadFullscreen(const std::string& file, const FullscreenKind& kind = {},
                                      const char* missing = nullptr);
    /// From here to endBatch() programs are only started, so that drivers can compile many at once. Until then they
    /// are empty.
    void beginBatch();
    /// Waits for all programs that were started.
    void endBatch();
    /// Whether shaders have what most scenes do not need: the paged part of the shadow volume (lib/shadow_trace.glsl)
    /// and lights that are rectangles (lib/local_lights.glsl); at first they do. On a GPU these are branches, which
    /// this does not change. A software GL runs both sides of any branch: an eighth of a ray's time, a fifth of the
    /// pass of local lights. So there are programs without both there, each built when it is first wanted.
    void setRareFeatures(bool areWanted);
    /// Rebuilds the programs whose files changed on disk; on an error the last good program stays. True if any was
    /// rebuilt.
    bool reloadChanged();
    /// The errors of the programs that do not build as they are now, with file and line.
    std::vector<std::string> errors() const;
    /// Number of compute programs held.
    int computePrograms() const;

private:
    /// A program that is started, and what to log if it does not build.
    struct Started {
        BuiltProgram* plain = nullptr;
        FullscreenProgram* fullscreen = nullptr;
        const char* missing = nullptr;
    };
    template <class F>
    void forEach(F&& visit) const;
    ShaderBuild buildOf() const;
    void finishOrQueue(const Started& started);
    void finish(const Started& started) const;

    std::filesystem::path m_folder;
    Fullscreen m_fullscreen;
    ShaderBuild m_build;
    std::vector<std::unique_ptr<BuiltProgram>> m_programs;
    std::vector<std::unique_ptr<FullscreenProgram>> m_fullscreenPrograms;
    std::vector<Started> m_started;      ///< of the batch
    unsigned m_hostCompilerThreads = 0;  ///< while a batch is started
    bool m_isBatch = false, m_hasRareFeatures = true;
};

}  // namespace rubble
