#include "render/shader_library/shader_library.h"

#include <utility>

#include "render/gl/gl.h"
#include "render/shader_library/uniforms_as_varyings.h"
#include "runtime/core/log.h"

namespace rubble {

ShaderLibrary::ShaderLibrary(std::filesystem::path folder, Fullscreen fullscreen, std::string defines,
                             ProgramCache* cache)
    : m_folder(std::move(folder)),
      m_fullscreen(fullscreen),
      m_build{.defines = std::move(defines), .varyingVectors = isSoftwareGl() ? varyingVectors() : 0, .cache = cache} {}

const Program& ShaderLibrary::load(const std::string& fragmentFile, const std::string& vertexFile,
                                   const char* missing) {
    for (const auto& built : m_programs)
        if (built->isOf(fragmentFile, vertexFile)) return built->program();
    BuiltProgram& made = *m_programs.emplace_back(std::make_unique<BuiltProgram>(fragmentFile, vertexFile));
    made.start(m_folder, buildOf());
    finishOrQueue({.plain = &made, .missing = missing});
    return made.program();
}

FullscreenProgram& ShaderLibrary::loadFullscreen(const std::string& file, const FullscreenKind& kind,
                                                 const char* missing) {
    for (const auto& program : m_fullscreenPrograms)
        if (program->file() == file) return *program;
    FullscreenProgram& made = *m_fullscreenPrograms.emplace_back(std::make_unique<FullscreenProgram>(file, kind));
    if (m_fullscreen != Fullscreen::Compute) made.make(FullscreenMethod::Fragment).start(m_folder, buildOf());
    if (m_fullscreen != Fullscreen::Fragment) made.make(FullscreenMethod::Compute).start(m_folder, buildOf());
    finishOrQueue({.fullscreen = &made, .missing = missing});
    return made;
}

void ShaderLibrary::finishOrQueue(const Started& started) {
    m_isBatch ? m_started.push_back(started) : finish(started);
}

void ShaderLibrary::finish(const Started& started) const {
    const auto report = [&](const BuiltProgram& failed) {
        if (started.missing) logError(std::string(started.missing) + ": " + failed.error());
    };
    if (started.plain && !started.plain->finish()) report(*started.plain);
    if (!started.fullscreen) return;
    auto& fragment = started.fullscreen->built(FullscreenMethod::Fragment);
    auto& compute = started.fullscreen->built(FullscreenMethod::Compute);
    if (fragment && !fragment->finish()) report(*fragment);
    if (!compute || compute->finish()) return;
    if (m_fullscreen != Fullscreen::Both) return report(*compute);
    logWarning("a compute program does not build, so fragments draw it: " + compute->error());
    started.fullscreen->release(FullscreenMethod::Compute);
}

void ShaderLibrary::beginBatch() {
    m_isBatch = true;
    m_hostCompilerThreads = setCompilerThreads(kAnyCompilerThreads);
}

void ShaderLibrary::endBatch() {
    m_isBatch = false;
    for (const Started& started : std::exchange(m_started, {})) finish(started);
    setCompilerThreads(m_hostCompilerThreads);
}

template <class F>
void ShaderLibrary::forEach(F&& visit) const {
    for (const auto& built : m_programs) visit(*built);
    for (const auto& program : m_fullscreenPrograms)
        for (const FullscreenMethod method : {FullscreenMethod::Fragment, FullscreenMethod::Compute})
            if (auto& built = program->built(method)) visit(*built);
}

ShaderBuild ShaderLibrary::buildOf() const {
    ShaderBuild how = m_build;
    if (!m_hasRareFeatures) how.defines += "#define NO_PAGED_SHADOWS\n#define NO_AREA_LIGHTS\n";
    return how;
}

void ShaderLibrary::setRareFeatures(bool areWanted) {
    if (!isSoftwareGl() || m_hasRareFeatures == areWanted) return;
    m_hasRareFeatures = areWanted;
    forEach([&](BuiltProgram& built) {
        if (!built.includes("lib/shadow_trace.glsl") && !built.includes("lib/local_lights.glsl")) return;
        built.swapVariant();
        if (built.program()) return;
        built.start(m_folder, buildOf());
        if (!built.finish()) built.swapVariant();  // the error is in both
    });
}

bool ShaderLibrary::reloadChanged() {
    bool any = false;
    forEach([&](BuiltProgram& built) {
        if (!built.hasChanged(m_folder)) return;
        built.dropVariant();
        built.start(m_folder, buildOf());
        any |= built.finish();
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
