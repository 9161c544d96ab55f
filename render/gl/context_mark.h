#pragma once
#include <array>
#include <cstdint>

#include "render/gl/name.h"

namespace rubble {

/// Recognises the GL context that it was made in, and those that share objects with it: names of objects mean other
/// objects in other contexts. It is a buffer whose content no other has. [render-thread]
class ContextMark {
public:
    /// Marks the current context.
    ContextMark();
    /// Whether this context, or one that shares its objects, is current.
    bool isCurrent() const;

private:
    using Content = std::array<uint64_t, 3>;
    GlName<BufferKind> m_buffer;
    Content m_content;
};

}  // namespace rubble
