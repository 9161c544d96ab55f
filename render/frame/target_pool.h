#pragma once
#include <array>
#include <glm/vec4.hpp>
#include <map>
#include <string_view>
#include <vector>

#include "render/frame/pixel_rect.h"
#include "render/frame/targets.h"
#include "render/gl/framebuffer.h"

namespace rubble {

/// A target with history: this frame's texture and last frame's.
struct History {
    const Texture& current;
    const Texture& previous;
    /// Whether `previous` holds the frame before this one: not at the start, after a cut, a resize or a skipped frame.
    bool valid;
};

/// Owns the textures of all targets. One is made when a pass first asks for it, and freed when its resolution changes.
/// While a pass runs, what it may use is what it has declared: anything else fails an assert. [render-thread]
class TargetPool {
public:
    /// Starts a frame: the two textures of each history change places. Sizes in pixels. cut: what the frame before left
    /// is not valid.
    void beginFrame(glm::ivec2 renderSize, glm::ivec2 displaySize, bool cut);
    /// From here to endPass() only these may be used.
    void beginPass(TargetSet reads, TargetSet writes);
    /// After it any target may be used: by tests, tools and what is drawn between passes.
    void endPass() { m_isInPass = false; }

    /// A target without history, to draw into.
    const Texture& target(Target id);
    /// A target with history, to draw into or to read last frame's.
    History history(Target id);
    /// Copies a target into another one of the same format, for a pass that reads what it draws over.
    const Texture& copy(Target source, Target into);
    /// The same of a part: what lies around it in the copy is not changed.
    const Texture& copy(Target source, Target into, const PixelRect& part);
    /// This frame's texture, or nullptr if nothing has drawn it yet.
    const Texture* find(Target id) const;
    /// This frame's texture, or what stands for it if nothing has drawn it yet: for a sampler that is then not read.
    const Texture& orNone(Target id) const;
    /// What the frame before left in a target with history, or what stands for it if that is not valid (see History).
    const Texture& previousOrNone(Target id) const;
    /// This frame's texture, which must have been drawn.
    const Texture& at(Target id) const;

    /// The framebuffer of these colour attachments and depth buffer. Made once for each combination.
    const Framebuffer& framebuffer(const std::vector<const Texture*>& colors, const Texture* depth = nullptr);

    /// The values of a target's texture, rows from the bottom. Waits for the GL. False: it is a depth buffer.
    bool read(const Texture& texture, std::vector<glm::vec4>& out);

    /// GPU memory of all targets.
    uint64_t bytes() const;
    /// Whether the GL failed to make a target or a framebuffer since the last clear(): what was drawn is not valid.
    bool allocationFailed() const;
    /// Frees everything.
    void clear();

private:
    struct Slot {
        Texture textures[2];
        int current = 0;
        uint64_t drawn[2] = {0, 0};  ///< the frame in which each was last asked for
    };
    struct Group {  ///< the targets of one resolution
        glm::ivec2 size{0};
        uint64_t cutFrame = 0;
        bool allocationFailed = false;
    };
    void setSize(Resolution resolution, glm::ivec2 size, bool cut);
    void clear(Resolution resolution);
    Slot& slot(Target id);
    bool mayRead(Target id) const { return !m_isInPass || m_reads.contains(id) || m_writes.contains(id); }
    bool mayReadPrevious(Target id) const { return !m_isInPass || m_reads.containsPrevious(id); }
    bool mayWrite(Target id) const { return !m_isInPass || m_writes.contains(id); }

    std::array<Slot, kTargetCount> m_slots;
    std::array<Texture, kTargetCount> m_none;  ///< what stands for each where nothing has drawn it
    std::array<Group, 2> m_groups;             ///< by Resolution
    std::map<std::vector<GLuint>, Framebuffer> m_framebuffers;
    bool m_framebufferFailed = false;
    uint64_t m_frame = 0;
    TargetSet m_reads, m_writes;  ///< of the pass that runs
    bool m_isInPass = false;
};

}  // namespace rubble
