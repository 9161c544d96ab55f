#pragma once
#include <array>
#include <optional>
#include <string>

#include "render/shader_library/built_program.h"

namespace rubble {

/// A shader that covers its targets, as a fragment program, a compute program, or both until it is known which is
/// faster. Drawn by drawFullscreen() of render/passes/fullscreen.h.
class FullscreenProgram {
public:
    /// file: relative to the shader folder. Nothing is built yet.
    FullscreenProgram(std::string file, FullscreenKind kind) : m_file(std::move(file)), m_kind(std::move(kind)) {}

    explicit operator bool() const { return has(FullscreenMethod::Fragment) || has(FullscreenMethod::Compute); }
    /// Whether it can be drawn by this method.
    bool has(FullscreenMethod method) const { return built(method) && built(method)->program(); }
    /// The program of a method that it has.
    const Program& program(FullscreenMethod method) const { return built(method)->program(); }
    /// As given to the constructor.
    const FullscreenKind& kind() const { return m_kind; }
    /// As given to the constructor.
    const std::string& file() const { return m_file; }

    /// A program of this method to build, in place of an earlier one.
    BuiltProgram& make(FullscreenMethod method) { return m_built[size_t(method)].emplace(m_file, m_kind, method); }
    /// Frees the program of a method.
    void release(FullscreenMethod method) { m_built[size_t(method)].reset(); }
    /// The program of a method, if it has been made and not released; it may have failed to build.
    std::optional<BuiltProgram>& built(FullscreenMethod method) { return m_built[size_t(method)]; }
    /// The same.
    const std::optional<BuiltProgram>& built(FullscreenMethod method) const { return m_built[size_t(method)]; }

private:
    std::string m_file;
    FullscreenKind m_kind;
    std::array<std::optional<BuiltProgram>, 2> m_built;
};

}  // namespace rubble
