#pragma once
#include <map>
#include <vector>

#include "runtime/core/world_box.h"
#include "runtime/destruction/components.h"
#include "runtime/frame/frame_snapshot.h"
#include "runtime/frame/shown_palettes.h"
#include "runtime/voxel/used_entries.h"
#include "runtime/world/world.h"

namespace rubble {

/// Lights of voxels that glow and belong to no light group: rays meet what is small by chance, a light reaches all that
/// is around it. They are the renderer's alone; the World has none of them. Each connected set of voxels of one palette
/// entry within a directory node (32 voxels on a side) has lights of its own, see glowingFaces(). Left out is what has
/// a light of the World within kOwnLight: its author has lit the surroundings. The cost follows the nodes that change,
/// and is none where nothing glows. [main-thread]
class GlowLights {
public:
    static constexpr size_t kMaxLights = 512;      ///< that list() adds: the brightest ones
    static constexpr double kOwnLight = 0.5;       ///< metres around the box around the voxels
    static constexpr float kMinIntensity = 0.03f;  ///< of the brightest channel; what is fainter is not seen to light

    /// Takes over a step; `palettes` are those that shapes are drawn with. Whether list() has something else to tell
    /// than before, but for the poses of shapes.
    bool update(const FrameChanges& changes, const World& world, ShownPalettes& palettes);
    /// Appends the lights where their shapes are now, and the bodies that these are on.
    void list(const World& world, std::vector<SnapshotLight>& lights, std::vector<BodyHandle>& bodies) const;

private:
    struct Glow {
        Light light;   ///< in the shape's frame
        WorldBox box;  ///< around its voxels in the shape's frame, metres
        uint8_t entry;
        uint32_t number;           ///< the same as long as it glows at its place
        bool hasOwnLight = false;  ///< one of the World
    };
    struct NodeBefore {
        bool operator()(glm::ivec3 a, glm::ivec3 b) const { return cellBefore(a, b); }
    };
    struct ShapeGlows {
        PaletteRef palette;                                         ///< that the shape is drawn with
        UsedEntries entries;                                        ///< of it that glow without a group
        std::map<glm::ivec3, std::vector<Glow>, NodeBefore> nodes;  ///< with at least one
    };

    void add(ShapeHandle handle, const World& world, ShownPalettes& palettes);
    bool fitChangedNodes(const FrameChanges& changes, const World& world);
    bool fitNode(ShapeGlows& shape, const Shape& source, glm::ivec3 node);
    static bool isSame(const Glow& a, const Glow& b);
    void findOwnLights(const World& world);

    std::map<ShapeHandle, ShapeGlows> m_shapes;  ///< whose palettes have such entries
    uint32_t m_lastNumber = 0;
};

}  // namespace rubble
