#pragma once
#include <string>
#include <vector>

#include "render/gl/program.h"
#include "render/gl/program_cache.h"

namespace rubble {

/// A program that the GL compiles. Many drivers do that on threads of their own, until somebody asks for the result: so
/// start all programs before the first is finished. [render-thread]
class ProgramBuild {
public:
    /// A shader of a program.
    struct Stage {
        GLenum kind;  ///< GL_VERTEX_SHADER, ...
        std::string source;
    };
    ProgramBuild() = default;
    /// Starts to compile and link, or takes the program from the cache. cache: null for none; must outlive it.
    ProgramBuild(const std::vector<Stage>& stages, ProgramCache* cache);
    /// Whether there is one to finish.
    explicit operator bool() const { return bool(m_program); }

    /// What failed.
    struct Failure {
        size_t stage = 0;  ///< its index; the last one for the linker
        std::string log;   ///< the GL's message
    };
    /// Waits for the result, which is empty on a failure.
    Program finish(Failure& failure);

private:
    GlName<ProgramKind> m_program;
    std::vector<GlName<ShaderKind>> m_shaders;
    ProgramCache* m_cache = nullptr;
    uint64_t m_key = 0;
    bool m_isCached = false;
};

}  // namespace rubble
