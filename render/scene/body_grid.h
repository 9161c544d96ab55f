#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/frame/shader_constants.h"
#include "render/scene/bodies.h"

namespace rubble {

/// Which bodies may have a voxel at a point of the world (lib/voxel_at.glsl): a hierarchical hash grid (Ericson,
/// Real-Time Collision Detection, 7.2). A body is entered into the few cells that its box touches, at the level whose
/// cells are about as large as the body, so that a body of any size takes some tens of entries. Different cells may
/// share a bucket: the shader checks each body that it finds. [render-thread]
class BodyGrid {
public:
    static constexpr float kFinestCell = shared::kFinestBodyCell;
    static constexpr int kLevels = 6;

    /// Enters a body at its present position, or removes it if it is empty.
    void put(uint32_t slot, const Bodies::Instance& body);
    /// Sends what changed. Returns the bytes sent.
    uint64_t upload() { return m_bucketHeads.upload() + m_entries.upload(); }
    /// Sets the samplers of lib/voxel_at.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// Slots of the bodies listed for a point, in the shader's order.
    std::vector<uint32_t> bodiesAt(glm::vec3 point) const;
    /// Number of entries of all bodies.
    uint32_t entries() const { return m_slots.used(); }
    /// GPU memory.
    uint64_t bytes() const { return m_bucketHeads.texture().bytes() + m_entries.texture().bytes(); }

private:
    struct Cells {
        int level = 0;
        glm::ivec3 low{0}, high{0};  ///< high excluded
        bool operator==(const Cells&) const = default;
    };
    struct Entry {
        uint32_t body = 0, next = 0;  ///< next: index of the next entry plus one
    };
    static Cells cellsOf(const Bodies::Instance& body);
    template <class F>
    void forEachBucket(const Cells& cells, F&& f) const;
    uint32_t bucketOf(glm::ivec3 cell, int level) const;
    void link(uint32_t slot);
    void unlink(uint32_t slot);
    void grow();

    std::vector<Cells> m_cellsOfBody;  ///< by slot
    int m_levels = 0;                  ///< one more than the highest level ever used
    StagedBuffer<uint32_t> m_bucketHeads{GL_R32UI, "body grid"};
    StagedBuffer<Entry> m_entries{GL_RG32UI, "body grid entries"};
    IndexAllocator m_slots;  ///< of m_entries
};

}  // namespace rubble
