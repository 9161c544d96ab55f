#pragma once
#include <array>

#include "render/gl/program.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/index_allocator.h"
#include "runtime/voxel/brick.h"
#include "runtime/voxel/paint_colors.h"

namespace rubble {

/// The paint layer on the GPU: paint bytes of painted bricks, found by the brick's slot in the BrickAtlas, and paint
/// colours by the shape's slot. Exists only while a shape has paint. Layouts: lib/paint.glsl.
class PaintAtlas {
public:
    /// A new brick in a slot of the BrickAtlas; ignored if it has no paint.
    void put(uint32_t slot, const Brick& brick);
    /// The slot of the BrickAtlas is free.
    void remove(uint32_t slot);
    /// The colours of a shape's paint.
    void setColors(uint32_t shapeSlot, const PaintColors& colors);

    /// Sends what changed. slots: how many the BrickAtlas has. Returns the bytes sent.
    uint64_t upload(uint32_t slots);
    /// Sets the samplers of lib/paint.glsl. The program must be in use.
    void bind(const Program& program) const;
    /// GPU memory.
    uint64_t bytes() const {
        return m_numbers.texture().bytes() + m_paint.texture().bytes() + m_colors.texture().bytes();
    }

private:
    using Table = std::array<uint32_t, 16>;
    void growTo(uint32_t slots);

    StagedBuffer<uint32_t> m_numbers{GL_R32UI, "paint of bricks"};
    StagedBuffer<BrickIndices> m_paint{GL_R32UI, "paint"};
    StagedBuffer<Table> m_colors{GL_R32UI, "colours of paint"};
    IndexAllocator m_free;
};

}  // namespace rubble
