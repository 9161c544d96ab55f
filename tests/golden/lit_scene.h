#pragma once
#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "runtime/frame/frame_snapshot.h"
#include "samples/support/camera.h"

namespace rubble {

/// Small scenes for tests of light, made without a World: bodies, lights, and a shadow volume filled by the simplest
/// rule: a cell is solid if its centre lies in a solid voxel.
class LitScene {
public:
    /// An empty scene whose shapes all use this palette.
    explicit LitScene(PaletteRef palette) : m_palette(std::move(palette)) {}

    /// Adds a shape of `size` voxels of 0.1 m; entryAt returns the palette index of each cell.
    ShapeHandle add(glm::ivec3 size, Pose pose, const std::function<uint8_t(glm::ivec3)>& entryAt);
    /// The next step() carries the new pose.
    void move(ShapeHandle shape, Pose pose);
    /// Replaces all voxels of a shape; the next step() carries the bricks that have changed.
    void edit(ShapeHandle shape, const std::function<uint8_t(glm::ivec3)>& entryAt);
    /// Every later snapshot() and step() carries the light.
    void addLight(SnapshotLight light) { m_lights.push_back(light); }
    Environment environment;

    /// The whole scene, as for a level that was just loaded.
    FrameSnapshot snapshot() const;
    /// What has changed since the last snapshot() or step(): poses, bricks, and bricks of the shadow volume.
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
    mutable std::map<std::array<int, 3>, ShadowWords> m_shadow;  ///< as in the last snapshot
    mutable uint64_t m_version = 1;
};

/// A street corner with the hard cases of lighting: a plaster room with a window and a hole, a glossy car, a street
/// light, a rotated cube, a tree.
LitScene streetScene();
/// Which: 0 the street, 1 close to the room, 2 inside the room, 3 from above.
Camera streetCamera(int which);
/// The palette of streetScene().
PaletteRef streetPalette();

}  // namespace rubble
