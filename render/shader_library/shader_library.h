#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "render/shader_library/fullscreen_program.h"

namespace rubble {

/// Every program of the renderer, built from the files of shaders/. A program that fails is empty (its pass is skipped)
/// and its error, with file and line, is in errors(). [render-thread]
class ShaderLibrary {
public:
    /// What shaders that cover their targets are built as.
    enum class Fullscreen {
        Fragment,
        Compute,
        Both,  ///< a compute program that does not build is none: the fragment program draws
    };
    /// textureUnits: that a program may use, 0: what the GL has. Below kTextureUnits shaders do without what asks for
    /// many (FEW_TEXTURE_UNITS).
    explicit ShaderLibrary(std::filesystem::path folder, Fullscreen fullscreen = Fullscreen::Fragment,
                           int textureUnits = 0);

    /// Files under the shader folder. The reference stays valid; a reload puts a new program into it.
    const Program& load(const std::string& fragmentFile, const std::string& vertexFile = "lib/fullscreen.vert");
    /// A shader that covers its targets. The reference stays valid.
    FullscreenProgram& loadFullscreen(const std::string& file, const FullscreenKind& kind = {});
    /// Rebuilds what uses a file that changed on disk; on an error the last good program stays. True if any was
    /// rebuilt.
    bool reloadChanged();
    /// Of the programs whose files do not build as they are now, with file and line.
    std::vector<std::string> errors() const;
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
