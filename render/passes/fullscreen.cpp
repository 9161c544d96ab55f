#include "render/passes/fullscreen.h"

#include <algorithm>
#include <glm/gtc/type_ptr.hpp>
#include <optional>

#include "render/gl/draw_state.h"
#include "render/gl/state_guard.h"
#include "render/passes/depth_limit.h"
#include "render/shader_library/fullscreen_choice.h"
#include "runtime/core/assertion.h"

namespace rubble {
namespace {

constexpr FullscreenMethod otherMethod(FullscreenMethod method) {
    return method == FullscreenMethod::Fragment ? FullscreenMethod::Compute : FullscreenMethod::Fragment;
}

/// The method that draws this program. Frees the other one once the pass has decided.
FullscreenMethod chooseFor(const FrameContext& frame, FullscreenProgram& program) {
    const FullscreenMethod wanted = frame.choice ? frame.choice->method() : FullscreenMethod::Fragment;
    if (!program.has(wanted)) return otherMethod(wanted);
    if (frame.choice && frame.choice->isDecided()) program.release(otherMethod(wanted));
    return wanted;
}

/// While it lives, blending and colour masks combine what fragments write with what the targets hold.
class MergeState {
public:
    explicit MergeState(const FullscreenKind& kind) : m_targets(GLuint(kind.merge.size())) {
        for (GLuint i = 0; i < m_targets; ++i) set(i, kind.merge[i]);
    }
    ~MergeState() {
        for (GLuint i = 0; i < m_targets; ++i) glColorMaski(i, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        disableBlend();
    }
    MergeState(const MergeState&) = delete;
    MergeState& operator=(const MergeState&) = delete;

private:
    static void set(GLuint target, Merge merge) {
        if (merge == Merge::Color) glColorMaski(target, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        if (merge == Merge::Alpha) glColorMaski(target, GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
        const bool isBlended = merge == Merge::Add || merge == Merge::Over;
        RUBBLE_ASSERT((target == 0 || !isBlended) && "only the first target is merged by blending");
        if (merge == Merge::Add) setBlend({GL_ONE, GL_ONE, GL_ONE, GL_ONE});
        if (merge == Merge::Over) setBlend({GL_ONE, GL_SRC_ALPHA, GL_ONE, GL_SRC_ALPHA});
    }
    GLuint m_targets;
};

}  // namespace

FullscreenDraw::FullscreenDraw(const FrameContext& frame, FullscreenProgram& program, const FullscreenTargets& into)
    : m_frame(frame), m_into(into), m_method(chooseFor(frame, program)), m_program(program) {
    RUBBLE_ASSERT(program.kind().surfacesOnly == (into.depth != nullptr) &&
                  "a program for surfaces only needs a depth buffer, the others have none");
    RUBBLE_ASSERT((!into.area || into.clear.empty()) && "a part of the targets is drawn, but all of them cleared");
    if (m_method == FullscreenMethod::Fragment || !into.clear.empty())
        frame.targets.framebuffer(into.colors, into.depth).begin();
    for (size_t i = 0; i < into.clear.size(); ++i) glClearBufferfv(GL_COLOR, GLint(i), glm::value_ptr(into.clear[i]));
    this->program().use();
    this->program().set("uTexelSize", 1.0f / glm::vec2(into.colors[0]->size()));
}

void FullscreenDraw::run() const {
    m_method == FullscreenMethod::Fragment ? rasterize() : dispatch();
    ++m_frame.stats.drawCalls;
    if (m_frame.choice) m_frame.choice->recordDraw(m_method);
}

void FullscreenDraw::rasterize() const {
    std::optional<DepthLimit> limit;
    if (m_into.depth) limit.emplace(DepthLimit::To::Surfaces);
    const MergeState merge(m_program.kind());
    if (m_into.area) {
        setScissorTest(true);
        setScissor(m_into.area->low, m_into.area->size());
    }
    glBindVertexArray(m_frame.emptyVertexArray.get());
    if (m_into.tiles > 0)
        glDrawArraysInstanced(GL_TRIANGLES, 0, 6, m_into.tiles);
    else
        glDrawArrays(GL_TRIANGLES, 0, 3 * std::max(m_into.corners - 2, 1));
    if (m_into.area) setScissorTest(false);
}

void FullscreenDraw::dispatch() const {
    const PixelRect area = m_into.area.value_or(PixelRect{glm::ivec2(0), m_into.colors[0]->size()});
    const glm::ivec2 size = area.size();
    if (m_into.depth) program().set("uDepthLimit", *m_into.depth);
    program().set("uTargetLow", area.low);
    program().set("uTargetHigh", area.high);
    for (size_t i = 0; i < m_into.colors.size(); ++i) {
        const Texture& target = *m_into.colors[i];
        const Merge merge = m_program.kind().mergeOf(i);
        RUBBLE_ASSERT((merge == Merge::Replace || target.internalFormat() == GL_RGBA16F) &&
                      "a merge of images in another format than RGBA16F: see Merge");
        glBindImageTexture(GLuint(i), target.name(), 0, GL_FALSE, 0,
                           merge == Merge::Replace ? GL_WRITE_ONLY : GL_READ_WRITE, target.internalFormat());
    }
    // A shader may have one more output than there are targets: what it stores there is ignored.
    if (const GLuint unused = GLuint(m_into.colors.size()); unused < GlState::kImages)
        glBindImageTexture(unused, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA16F);
    // The first barrier: no image is overwritten that an earlier pass still reads. The second: later passes see it.
    glMemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    glDispatchCompute(GLuint(size.x + kGroupWidth - 1) / kGroupWidth, GLuint(size.y + kGroupHeight - 1) / kGroupHeight,
                      1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT | GL_TEXTURE_UPDATE_BARRIER_BIT);
}

}  // namespace rubble
