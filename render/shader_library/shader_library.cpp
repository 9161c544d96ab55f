#include "render/shader_library/shader_library.h"

#include "render/gl/gl.h"
#include "runtime/core/log.h"

namespace rubble {

ShaderLibrary::ShaderLibrary(std::filesystem::path folder, Fullscreen fullscreen, int textureUnits)
    : m_folder(std::move(folder)), m_fullscreen(fullscreen), m_build{.uniformsAsVaryings = isSoftwareGl()} {
    if (!textureUnits) glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &textureUnits);
    if (textureUnits < kTextureUnits) m_build.defines = "#define FEW_TEXTURE_UNITS\n";
}

const Program& ShaderLibrary::load(const std::string& fragmentFile, const std::string& vertexFile) {
    for (const auto& built : m_programs)
        if (built->isOf(fragmentFile, vertexFile)) return built->program();
    m_programs.push_back(std::make_unique<BuiltProgram>(fragmentFile, vertexFile));
    m_programs.back()->build(m_folder, m_build);
    return m_programs.back()->program();
}

FullscreenProgram& ShaderLibrary::loadFullscreen(const std::string& file, const FullscreenKind& kind) {
    for (const auto& program : m_fullscreenPrograms)
        if (program->file() == file) return *program;
    auto program = std::make_unique<FullscreenProgram>(file, kind);
    if (m_fullscreen != Fullscreen::Compute) program->make(FullscreenMethod::Fragment).build(m_folder, m_build);
    if (m_fullscreen != Fullscreen::Fragment && !program->make(FullscreenMethod::Compute).build(m_folder, m_build) &&
        m_fullscreen == Fullscreen::Both) {
        logWarning("a compute program does not build, so fragments draw it: " +
                   program->built(FullscreenMethod::Compute)->error());
        program->release(FullscreenMethod::Compute);
    }
    m_fullscreenPrograms.push_back(std::move(program));
    return *m_fullscreenPrograms.back();
}

template <class F>
void ShaderLibrary::forEach(F&& visit) const {
    for (const auto& built : m_programs) visit(*built);
    for (const auto& program : m_fullscreenPrograms)
        for (const FullscreenMethod method : {FullscreenMethod::Fragment, FullscreenMethod::Compute})
            if (auto& built = program->built(method)) visit(*built);
}

bool ShaderLibrary::reloadChanged() {
    bool any = false;
    forEach([&](BuiltProgram& built) {
        if (built.hasChanged(m_folder)) any |= built.build(m_folder, m_build);
    });
    return any;
}

std::vector<std::string> ShaderLibrary::errors() const {
    std::vector<std::string> all;
    forEach([&](const BuiltProgram& built) {
        if (!built.error().empty()) all.push_back(built.error());
    });
    return all;
}

int ShaderLibrary::computePrograms() const {
    int count = 0;
    for (const auto& program : m_fullscreenPrograms) count += program->has(FullscreenMethod::Compute);
    return count;
}

}  // namespace rubble
