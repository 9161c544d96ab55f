#pragma once
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "render/scene/bodies.h"

namespace rubble {

/// Which bodies may hold a voxel at a point of the world, as shaders ask (lib/voxel_at.glsl): a hierarchical hash grid
/// (Ericson, Real-Time Collision Detection, 7.2). A body is entered in the few cells that its box touches, at the level
/// whose cells are about as large as it is: whatever its size it costs some tens of entries. Buckets are not told
/// apart: who asks looks into the body.
class BodyGrid {
public:
    static constexpr float kFinestCell =
        1.6f;  ///< metres: side of a cell at level 0; four times as large at each next one
    static constexpr int kLevels = 6;

    /// Enters a body where it is now, or takes it out if it is empty.
    void put(uint32_t slot, const Bodies::Instance& body);
    /// Returns the bytes sent.
    uint64_t upload() { return m_bucketHeads.upload() + m_entries.upload(); }
    /// Sets the samplers of lib/voxel_at.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// IndexAllocator of the bodies listed for a point, as the shader goes through them.
    std::vector<uint32_t> bodiesAt(glm::vec3 point) const;
    uint32_t entries() const { return m_slots.used(); }
    uint64_t bytes() const { return m_bucketHeads.texture().bytes() + m_entries.texture().bytes(); }

private:
    struct Cells {
        int level = 0;
        glm::ivec3 low{0}, high{0};  ///< the box from low up to high, high not included
        bool operator==(const Cells&) const = default;
    };
    struct Entry {
        uint32_t body = 0, next = 0;  ///< next: number of the entry plus one
    };
    static Cells cellsOf(const Bodies::Instance& body);
    template <class F>
    void forEachBucket(const Cells& cells, F&& f) const;
    uint32_t bucketOf(glm::ivec3 cell, int level) const;
    void link(uint32_t slot);
    void unlink(uint32_t slot);
    void grow();

    std::vector<Cells> m_cellsOfBody;  ///< by slot
    int m_levels = 0;                  ///< the lowest ones, that were ever used
    StagedBuffer<uint32_t> m_bucketHeads{GL_R32UI, "body grid"};
    StagedBuffer<Entry> m_entries{GL_RG32UI, "body grid's entries"};
    IndexAllocator m_slots;  ///< of m_entries
};

}  // namespace rubble
