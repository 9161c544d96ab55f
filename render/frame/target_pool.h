#pragma once
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/gl/framebuffer.h"

namespace rubble {

/// This frame's target and last frame's, which keep changing places.
struct History {
    const Texture& current;
    const Texture& previous;
    bool valid;  ///< previous holds the frame before this one; false at the start, after a cut, a resize or a skipped
                 ///< frame
};

/// The textures that passes draw into, by name: made when first asked for, at the frame's size divided by `divisor`,
/// freed when that size changes. The pass viewer finds them here.
class TargetPool {
public:
    /// Starts a frame: histories change places. cut: what histories hold is not to be used.
    void beginFrame(glm::ivec2 size, bool cut);

    const Texture& target(std::string_view name, GLenum internalFormat, int divisor = 1,
                          Filter filter = Filter::Nearest);
    /// A target whose last frame is kept. Ask once a frame in each pass that draws it; others read it with find().
    History history(std::string_view name, GLenum internalFormat, int divisor = 1, Filter filter = Filter::Linear);
    /// What a target shows now, in another one of that name: for a pass that reads what it draws into.
    const Texture& copy(const Texture& source, std::string_view name);
    /// The current texture of that name, or nullptr if no pass has asked for it.
    const Texture* find(std::string_view name) const;
    /// Like find(), for a pass that needs what an earlier pass has drawn in this frame.
    const Texture& at(std::string_view name) const;

    /// Framebuffers are made once for each combination.
    const Framebuffer& framebuffer(const std::vector<const Texture*>& colors, const Texture* depth = nullptr);

    uint64_t bytes() const;
    /// The GL would not make a target or a combination of them since the last clear(): what was drawn is worth nothing.
    bool allocationFailed() const { return m_allocationFailed; }
    /// Frees everything.
    void clear();

private:
    struct Slot {
        Texture textures[2];
        int current = 0;
        uint64_t drawn[2] = {0, 0};  ///< number of the frame each was last asked for
        bool isHistory = false;
    };
    Slot& slot(std::string_view name, GLenum internalFormat, int divisor, Filter filter, bool isHistory);

    std::map<std::string, Slot, std::less<>> m_slots;
    std::map<std::vector<GLuint>, Framebuffer> m_framebuffers;
    glm::ivec2 m_size{0};
    uint64_t m_frame = 0;
    uint64_t m_cutFrame = 0;
    bool m_allocationFailed = false;
};

}  // namespace rubble
