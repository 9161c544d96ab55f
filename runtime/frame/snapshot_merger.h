#pragma once
#include <optional>
#include <vector>

#include "runtime/core/hash.h"
#include "runtime/frame/frame_snapshot.h"
#include "runtime/frame/keyed_list.h"

namespace rubble {

/// Snapshots merged into one, so that applying the result equals applying each in turn. Nothing is dropped. To add one
/// costs what it holds, however much has been added before; a single one is only handed on.
class SnapshotMerger {
public:
    /// Appends a snapshot that is later than all before.
    void add(FrameSnapshot&& later);
    /// Removes and returns what was added, merged; nothing if that was nothing.
    std::optional<FrameSnapshot> take();
    /// Nothing was added since the last take().
    bool empty() const { return !m_all; }

private:
    struct CellHash {
        size_t operator()(glm::ivec3 cell) const { return hashBytes(&cell, sizeof cell, 0); }
    };
    template <class T>
    static ShapeHandle shapeOf(const T& value) {
        return value.shape;
    }
    template <class T>
    static glm::ivec3 brickOf(const T& value) {
        return value.brick;
    }
    template <class T>
    using ByShape = KeyedList<T, ShapeHandle, std::hash<ShapeHandle>, shapeOf<T>>;
    template <class T>
    using ByBrick = KeyedList<T, glm::ivec3, CellHash, brickOf<T>>;
    struct Created {
        ShapeHandle shape;
        SnapshotShape content;  ///< its bricks are in `bricks`
        ByBrick<BrickChange> bricks;
    };
    struct ShapeBricks {
        ShapeHandle shape;
        ByBrick<BrickChange> bricks;
    };

    void sort();
    void destroy(ShapeHandle shape);
    void addBrick(BrickChange&& change);
    void addPalette(SnapshotPalette&& palette);
    void addShadow(ShadowPatch&& patch);
    void addLists(FrameSnapshot& later);

    std::optional<FrameSnapshot> m_all;
    bool m_isSorted = false;  ///< the lists below hold these lists of m_all
    ByShape<Created> m_created;
    ByShape<ShapeBricks> m_bricks;
    ByShape<SnapshotPalette> m_palettes;
    ByShape<SnapshotPose> m_poses;
    ByBrick<ShadowPatch> m_shadow;
};

/// Appends a later snapshot to an earlier one; see SnapshotMerger.
void merge(FrameSnapshot& into, FrameSnapshot&& later);

}  // namespace rubble
