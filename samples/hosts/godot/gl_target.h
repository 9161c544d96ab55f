#pragma once
#include <cstdint>

namespace rubble_godot {

/// A framebuffer whose colours and depths are two textures of Godot. Each call leaves the GL's state as it was.
/// [render-thread]
class GlTarget {
public:
    /// Without textures.
    GlTarget();
    ~GlTarget();
    GlTarget(const GlTarget&) = delete;
    GlTarget& operator=(const GlTarget&) = delete;
    /// Draws into two textures from now on. Both get a storage of this size here: Godot gives none to a texture before
    /// it has an image, and has no format for depths.
    void attach(uint32_t colors, uint32_t depths, int32_t width, int32_t height);
    /// Makes all of it black and far away.
    void clear() const;
    /// The framebuffer's GL name.
    uint32_t name() const { return m_name; }

private:
    uint32_t m_name = 0;
};

}  // namespace rubble_godot
