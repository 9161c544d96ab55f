#pragma once
#include <optional>
#include <vector>

#include "runtime/core/change_log.h"
#include "runtime/voxel/brick_place.h"
#include "runtime/world/history/frame_changes.h"
#include "runtime/world/state/world_data.h"

namespace rubble {

/// Which bricks of which shapes changed since a version, for those who keep a copy of their own. It follows the
/// journal from the first question on; until then it costs nothing. [main-thread]
class BrickVersions {
public:
    /// What counts as a change: of the voxels and the paint of a brick; or of how it looks as a mesh, to which the
    /// bricks beside it belong too, and the palette entries, paint colours and light groups of its voxels.
    enum class What { Voxels, Mesh };

    /// Takes over what a step has changed; the World is as the step left it. Does nothing until the first question.
    /// The first step of another world changes what its edits change: forget() says that it is another one.
    void follow(const FrameChanges& changes, const WorldData& world);
    /// The world is another one: nothing that was known of it holds.
    void forget();
    /// The version of now.
    uint64_t version() const { return m_version; }
    /// The bricks of a live shape that changed after a version, ordered; after version 0 all that hold voxels. Nothing
    /// if that version is older than what is known: the shape has another grid since, or nobody had asked; ask for 0.
    /// Valid until the next question.
    const std::vector<BrickPlace>* changed(const WorldData& world, ShapeHandle shape, uint64_t since, What what);

private:
    /// Where the colours of a shape come from.
    struct Colors {
        PaletteRef palette;
        PaintColorsRef paint;
        float emission = 1.0f;
    };
    struct Known {
        ShapeHandle shape;
        uint64_t made = 0;  ///< the version in which it got its present grid; 0: before all that is known
        Colors colors;      ///< as the last step left them
        ChangeLog<BrickPlace> bricks;
        ChangeLog<uint16_t> looks;  ///< palette entries whose voxels look otherwise; from 256 on, paint colours
    };
    static Colors colorsOf(const Shape& shape) { return {shape.palette, shape.paintColors, shape.emission}; }
    Known& known(ShapeHandle shape);
    void begin(const WorldData& world);
    void followColors(Known& known, const Shape& shape);
    void followGroups(const FrameChanges& changes, const WorldData& world);
    void addRecolored(const VoxelGrid& grid, const Known& known, uint64_t since);
    void addNeighbours(glm::ivec3 sizeInBricks);

    bool m_isAsked = false;
    uint64_t m_version = 1, m_first = 1;  ///< of now; the oldest that is known
    std::vector<Known> m_known;           ///< by shape slot: what has changed
    std::vector<bool> m_isDark;           ///< by slot of a light group
    std::vector<BrickPlace> m_found;
    std::vector<uint16_t> m_looks;
};

}  // namespace rubble
