#pragma once
#include <array>
#include <functional>
#include <map>
#include <string>

#include "runtime/frame/frame_snapshot.h"
#include "samples/support/camera.h"

namespace rubble {

/// Small scenes for the tests of light, made without a World: bodies, and a shadow volume filled by the plainest
/// possible rule (a cell is solid if its centre lies in a solid voxel).
class LitScene {
public:
    explicit LitScene(PaletteRef palette) : m_palette(std::move(palette)) {}

    /// A shape of this size in voxels; entryAt gives the palette index of each cell.
    ShapeHandle add(glm::ivec3 size, Pose pose, const std::function<uint8_t(glm::ivec3)>& entryAt);
    void move(ShapeHandle shape, Pose pose);
    /// Sets voxels of a shape again.
    void edit(ShapeHandle shape, const std::function<uint8_t(glm::ivec3)>& entryAt);
    void addLight(SnapshotLight light) { m_lights.push_back(light); }
    Environment environment;

    /// Everything, as for a level that was just loaded.
    FrameSnapshot snapshot() const;
    /// Poses that changed since the last call of either, and the bricks of the shadow volume that differ.
    FrameSnapshot step();

private:
    struct Shape {
        ShapeHandle handle;
        VoxelGrid grid;
        Pose previous, pose;
        std::vector<BrickChange> changed;
    };
    void fillShadow(FrameSnapshot& snapshot) const;

    PaletteRef m_palette;
    std::vector<Shape> m_shapes;
    std::vector<SnapshotLight> m_lights;
    mutable std::map<std::array<int, 3>, ShadowWords> m_shadow;  ///< as it was last given away
    mutable uint64_t m_version = 1;
};

/// Street corner with what makes light hard: a plaster room with a window and a hole, a shiny car, a lamp, a tilted
/// cube, a tree.
LitScene streetScene();
Camera streetCamera(int which);
/// Palette indices of streetScene.
PaletteRef streetPalette();

}  // namespace rubble
