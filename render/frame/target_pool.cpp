#include "render/frame/target_pool.h"

#include <glm/common.hpp>

#include "render/gl/state_guard.h"
#include "runtime/core/assertion.h"

namespace rubble {
namespace {

constexpr Resolution kResolutions[] = {Resolution::Render, Resolution::Display};

const TargetDeclaration& declarationOf(Target id) {
    return kTargets[size_t(id)];
}

/// Of a target, in a frame of this size.
glm::ivec2 sizeOf(const TargetDeclaration& target, glm::ivec2 frameSize) {
    return glm::max((frameSize + target.divisor - 1) / target.divisor, glm::ivec2(1));
}

}  // namespace

void TargetPool::beginFrame(glm::ivec2 renderSize, glm::ivec2 displaySize, bool cut) {
    ++m_frame;
    setSize(Resolution::Render, renderSize, cut);
    setSize(Resolution::Display, displaySize, cut);
    for (const TargetDeclaration& target : kTargets)
        if (target.hasHistory) m_slots[size_t(target.id)].current ^= 1;
}

void TargetPool::setSize(Resolution resolution, glm::ivec2 size, bool cut) {
    Group& group = m_groups[size_t(resolution)];
    if (size != group.size) {
        clear(resolution);
        group.size = size;
        for (const TargetDeclaration& target : kTargets)
            if (target.resolution == resolution)
                m_none[size_t(target.id)] = Texture::none(target.format, sizeOf(target, size), target.filter);
        cut = true;
    }
    if (cut) group.cutFrame = m_frame;
}

void TargetPool::beginPass(TargetSet reads, TargetSet writes) {
    m_reads = reads;
    m_writes = writes;
    m_isInPass = true;
}

void TargetPool::clear(Resolution resolution) {
    // All framebuffers: the GL may give the names of freed textures to new ones.
    m_framebuffers.clear();
    m_framebufferFailed = false;
    for (const TargetDeclaration& target : kTargets)
        if (target.resolution == resolution) m_slots[size_t(target.id)] = Slot();
    m_groups[size_t(resolution)].allocationFailed = false;
}

void TargetPool::clear() {
    for (const Resolution resolution : kResolutions) clear(resolution);
}

TargetPool::Slot& TargetPool::slot(Target id) {
    const TargetDeclaration& declared = declarationOf(id);
    Slot& slot = m_slots[size_t(id)];
    if (!slot.textures[0]) {
        Group& group = m_groups[size_t(declared.resolution)];
        const glm::ivec2 size = sizeOf(declared, group.size);
        for (int i = 0; i <= int(declared.hasHistory); ++i) {
            slot.textures[i] = Texture(declared.format, size, declared.filter);
            group.allocationFailed |= !slot.textures[i].isAllocated();
        }
    }
    slot.drawn[slot.current] = m_frame;
    return slot;
}

const Texture& TargetPool::target(Target id) {
    RUBBLE_ASSERT(mayWrite(id) &&
                  "a pass draws into a target that it has not declared: see Renderer::Impl::drawPasses()");
    RUBBLE_ASSERT(!declarationOf(id).hasHistory && "a target with history is asked for by history()");
    return slot(id).textures[0];
}

History TargetPool::history(Target id) {
    RUBBLE_ASSERT((mayRead(id) || mayReadPrevious(id)) &&
                  "a pass uses a target that it has not declared: see Renderer::Impl::drawPasses()");
    RUBBLE_ASSERT(declarationOf(id).hasHistory && "a target without history is asked for by target()");
    const Slot& found = slot(id);
    const int previous = found.current ^ 1;
    const bool isCut = m_groups[size_t(declarationOf(id).resolution)].cutFrame == m_frame;
    return {found.textures[found.current], found.textures[previous], found.drawn[previous] + 1 == m_frame && !isCut};
}

const Texture& TargetPool::copy(Target source, Target into) {
    return copy(source, into, {glm::ivec2(0), at(source).size()});
}

const Texture& TargetPool::copy(Target source, Target into, const PixelRect& part) {
    RUBBLE_ASSERT(declarationOf(source).format == declarationOf(into).format && "a copy has the format of its source");
    const Texture& original = at(source);
    const Texture& made = target(into);
    const Framebuffer& from = framebuffer({&original});
    const Framebuffer& to = framebuffer({&made});
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from.name());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to.name());
    glBlitFramebuffer(part.low.x, part.low.y, part.high.x, part.high.y, part.low.x, part.low.y, part.high.x,
                      part.high.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return made;
}

const Texture* TargetPool::find(Target id) const {
    RUBBLE_ASSERT(mayRead(id) && "a pass reads a target that it has not declared: see Renderer::Impl::drawPasses()");
    const Slot& slot = m_slots[size_t(id)];
    return slot.drawn[slot.current] == m_frame ? &slot.textures[slot.current] : nullptr;
}

const Texture& TargetPool::previousOrNone(Target id) const {
    RUBBLE_ASSERT(mayReadPrevious(id) && declarationOf(id).hasHistory &&
                  "a pass reads a history that it has not declared: see Renderer::Impl::drawPasses()");
    const Slot& slot = m_slots[size_t(id)];
    const int previous = slot.current ^ 1;
    const bool isCut = m_groups[size_t(declarationOf(id).resolution)].cutFrame == m_frame;
    const bool isValid = slot.textures[previous] && slot.drawn[previous] + 1 == m_frame && !isCut;
    return isValid ? slot.textures[previous] : m_none[size_t(id)];
}

const Texture& TargetPool::orNone(Target id) const {
    const Texture* found = find(id);
    return found ? *found : m_none[size_t(id)];
}

const Texture& TargetPool::at(Target id) const {
    const Texture* found = find(id);
    RUBBLE_ASSERT(found && "a pass reads a target that no earlier pass has drawn");
    return *found;
}

const Framebuffer& TargetPool::framebuffer(const std::vector<const Texture*>& colors, const Texture* depth) {
    std::vector<GLuint> key{depth ? depth->name() : 0};
    for (const Texture* color : colors) key.push_back(color->name());
    const auto found = m_framebuffers.find(key);
    if (found != m_framebuffers.end()) return found->second;
    const Framebuffer& made = m_framebuffers.emplace(std::move(key), Framebuffer(colors, depth)).first->second;
    m_framebufferFailed |= !made.isComplete();
    return made;
}

bool TargetPool::read(const Texture& texture, std::vector<glm::vec4>& out) {
    if (pixelFormat(texture.internalFormat()).format == GL_DEPTH_COMPONENT) return false;
    const glm::ivec2 size = texture.size();
    const PixelPackGuard packing;
    out.resize(size_t(size.x) * size_t(size.y));
    framebuffer({&texture}).begin();
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, out.data());
    return true;
}

uint64_t TargetPool::bytes() const {
    uint64_t sum = 0;
    for (const Slot& slot : m_slots)
        for (const Texture& texture : slot.textures)
            if (texture) sum += texture.bytes();
    return sum;
}

bool TargetPool::allocationFailed() const {
    bool failed = m_framebufferFailed;
    for (const Group& group : m_groups) failed |= group.allocationFailed;
    return failed;
}

}  // namespace rubble
