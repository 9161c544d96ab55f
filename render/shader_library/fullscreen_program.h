#pragma once
#include <array>
#include <optional>

#include "render/shader_library/built_program.h"

namespace rubble {

/// A shader that covers its targets, as a fragment program, a compute program, or both for as long as it is not known
/// which is faster. Drawn by drawFullscreen() of render/passes/fullscreen.h.
class FullscreenProgram {
public:
    FullscreenProgram(std::string file, FullscreenKind kind) : m_file(std::move(file)), m_kind(std::move(kind)) {}

    /// True if there is anything to draw with.
    explicit operator bool() const { return has(FullscreenMethod::Fragment) || has(FullscreenMethod::Compute); }
    bool has(FullscreenMethod by) const { return built(by) && built(by)->program(); }
    const Program& program(FullscreenMethod by) const { return built(by)->program(); }
    const FullscreenKind& kind() const { return m_kind; }
    const std::string& file() const { return m_file; }

    BuiltProgram& make(FullscreenMethod by) { return m_built[size_t(by)].emplace(m_file, m_kind, by); }
    void release(FullscreenMethod by) { m_built[size_t(by)].reset(); }
    std::optional<BuiltProgram>& built(FullscreenMethod by) { return m_built[size_t(by)]; }
    const std::optional<BuiltProgram>& built(FullscreenMethod by) const { return m_built[size_t(by)]; }

private:
    std::string m_file;
    FullscreenKind m_kind;
    std::array<std::optional<BuiltProgram>, 2> m_built;
};

}  // namespace rubble
