#include "render/gl/context_mark.h"

#include <atomic>

namespace rubble {
namespace {

/// Binds a buffer where no draw looks, and the one that was bound there when the object is destroyed.
class BoundForCopy {
public:
    explicit BoundForCopy(GLuint buffer) {
        glGetIntegerv(GL_COPY_READ_BUFFER, &m_before);
        glBindBuffer(GL_COPY_READ_BUFFER, buffer);
    }
    ~BoundForCopy() { glBindBuffer(GL_COPY_READ_BUFFER, GLuint(m_before)); }
    BoundForCopy(const BoundForCopy&) = delete;
    BoundForCopy& operator=(const BoundForCopy&) = delete;

private:
    GLint m_before = 0;
};

}  // namespace

ContextMark::ContextMark() : m_buffer(GlName<BufferKind>::make()) {
    static std::atomic<uint64_t> marks{0};
    m_content = {0x656c62627552u, ++marks, reinterpret_cast<uintptr_t>(&marks)};  // "Rubble"
    m_size = GLint(sizeof m_content + (isEmbedded() ? 8 * (marks % kSizes) : 0));
    const BoundForCopy bound(m_buffer.get());
    glBufferData(GL_COPY_READ_BUFFER, m_size, nullptr, GL_STATIC_READ);
    glBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof m_content, m_content.data());
}

bool ContextMark::isCurrent() const {
    if (!glGetString(GL_VERSION) || !glIsBuffer(m_buffer.get())) return false;
    const BoundForCopy bound(m_buffer.get());
    GLint size = 0, isMapped = 0;
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &size);
    glGetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_MAPPED, &isMapped);
    if (size != m_size || isMapped) return false;
    if (isEmbedded()) return true;
    Content found{};
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, sizeof found, found.data());
    return found == m_content;
}

}  // namespace rubble
