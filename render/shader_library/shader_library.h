#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/shader_library/fullscreen_program.h"

namespace rubble {

/// Owns every program of the renderer, built from the files of shaders/. A program that fails to build is empty, so its
/// pass is skipped, and errors() says why. [render-thread]
class ShaderLibrary {
public:
    /// As what full-screen shaders are built.
    enum class Fullscreen {
        Fragment,
        Compute,
        Both,  ///< the fragment program alone, where the compute program does not build
    };
    /// textureUnits: how many a program may use; 0: as many as the GL has. With fewer than kTextureUnits shaders leave
    /// out what needs many (FEW_TEXTURE_UNITS).
    explicit ShaderLibrary(std::filesystem::path folder, Fullscreen fullscreen = Fullscreen::Fragment,
                           int textureUnits = 0);

    /// The program of these files, relative to the shader folder, built at the first call. The reference stays valid; a
    /// reload puts a new program into it.
    const Program& load(const std::string& fragmentFile, const std::string& vertexFile = "lib/fullscreen.vert");
    /// A full-screen shader, built at the first call. The reference stays valid.
    FullscreenProgram& loadFullscreen(const std::string& file, const FullscreenKind& kind = {});
    /// Rebuilds the programs whose files changed on disk; on an error the last good program stays. True if any was
    /// rebuilt.
    bool reloadChanged();
    /// The errors of the programs that do not build as they are now, with file and line.
    std::vector<std::string> errors() const;
    /// Number of compute programs held.
    int computePrograms() const;

private:
    template <class F>
    void forEach(F&& visit) const;

    std::filesystem::path m_folder;
    Fullscreen m_fullscreen;
    ShaderBuild m_build;
    std::vector<std::unique_ptr<BuiltProgram>> m_programs;
    std::vector<std::unique_ptr<FullscreenProgram>> m_fullscreenPrograms;
};

}  // namespace rubble
