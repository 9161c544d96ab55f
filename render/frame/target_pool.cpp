#include "render/frame/target_pool.h"

#include <cassert>
#include <glm/common.hpp>

namespace rubble {

void TargetPool::beginFrame(glm::ivec2 size, bool cut) {
    if (size != m_size) {
        clear();
        m_size = size;
        cut = true;
    }
    ++m_frame;
    if (cut) m_cutFrame = m_frame;
    for (auto& [name, slot] : m_slots)
        if (slot.isHistory) slot.current ^= 1;
}

void TargetPool::clear() {
    m_framebuffers.clear();
    m_slots.clear();
    m_allocationFailed = false;
}

TargetPool::Slot& TargetPool::slot(std::string_view name, GLenum internalFormat, int divisor, Filter filter,
                                   bool isHistory) {
    auto found = m_slots.find(name);
    if (found == m_slots.end()) {
        const glm::ivec2 size = glm::max((m_size + divisor - 1) / divisor, glm::ivec2(1));
        found = m_slots.try_emplace(std::string(name)).first;
        found->second.isHistory = isHistory;
        while (glGetError() != GL_NO_ERROR) {  // whoever made these: they are not about what comes now
        }
        for (int i = 0; i <= int(isHistory); ++i) found->second.textures[i] = Texture(internalFormat, size, filter);
        m_allocationFailed |= glGetError() != GL_NO_ERROR;
    }
    Slot& slot = found->second;
    assert(slot.isHistory == isHistory && slot.textures[0].internalFormat() == internalFormat &&
           "one name, two kinds of target");
    slot.drawn[slot.current] = m_frame;
    return slot;
}

const Texture& TargetPool::target(std::string_view name, GLenum internalFormat, int divisor, Filter filter) {
    return slot(name, internalFormat, divisor, filter, false).textures[0];
}

History TargetPool::history(std::string_view name, GLenum internalFormat, int divisor, Filter filter) {
    const Slot& found = slot(name, internalFormat, divisor, filter, true);
    const int previous = found.current ^ 1;
    return {found.textures[found.current], found.textures[previous],
            found.drawn[previous] + 1 == m_frame && m_cutFrame != m_frame};
}

const Texture& TargetPool::copy(const Texture& source, std::string_view name) {
    const Texture& made = target(name, source.internalFormat());
    const Framebuffer& from = framebuffer({&source});
    const Framebuffer& to = framebuffer({&made});
    const glm::ivec2 size = source.size();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    glBlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return made;
}

const Texture* TargetPool::find(std::string_view name) const {
    const auto found = m_slots.find(name);
    return found == m_slots.end() ? nullptr : &found->second.textures[found->second.current];
}

const Texture& TargetPool::at(std::string_view name) const {
    const Texture* found = find(name);
    assert(found && "a pass reads a target that no earlier pass has drawn");
    return *found;
}

const Framebuffer& TargetPool::framebuffer(const std::vector<const Texture*>& colors, const Texture* depth) {
    std::vector<GLuint> key{depth ? depth->name() : 0};
    for (const Texture* color : colors) key.push_back(color->name());
    const auto found = m_framebuffers.find(key);
    if (found != m_framebuffers.end()) return found->second;
    const Framebuffer& made = m_framebuffers.emplace(std::move(key), Framebuffer(colors, depth)).first->second;
    m_allocationFailed |= !made.isComplete();
    return made;
}

uint64_t TargetPool::bytes() const {
    uint64_t sum = 0;
    for (const auto& [name, slot] : m_slots)
        for (const Texture& texture : slot.textures)
            if (texture) sum += texture.bytes();
    return sum;
}

}  // namespace rubble
