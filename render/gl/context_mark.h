#pragma once
#include <array>
#include <cstdint>

#include "render/gl/name.h"

namespace rubble {

/// Recognises the GL context that it was made in, and those that share objects with it: names of objects mean other
/// objects in other contexts. It is a buffer whose content no other has; in OpenGL ES, which does not tell what a
/// buffer holds, one of a size that few have. [render-thread]
class ContextMark {
public:
    /// Marks the current context.
    ContextMark();
    /// Whether this context, or one that shares its objects, is current.
    bool isCurrent() const;

private:
    using Content = std::array<uint64_t, 3>;
    static constexpr uint64_t kSizes = 1024;  ///< of marks in OpenGL ES
    GlName<BufferKind> m_buffer;
    Content m_content;
    GLint m_size;  ///< bytes
};

}  // namespace rubble
