#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "render/frame/shader_constants.h"
#include "render/gl/program.h"
#include "render/scene/brick_atlas.h"
#include "render/scene/detail_maps.h"
#include "render/scene/layer_counts.h"
#include "render/scene/moving_bodies.h"
#include "render/scene/staged_buffer.h"
#include "runtime/core/bounds_tree.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// All shapes on the GPU: bricks in one atlas, and for each shape a two-level directory (nodes of 4x4x4 bricks, a table
/// of bricks each), a palette and a transform. Layout of the buffers: lib/bodies.glsl. [render-thread]
class Bodies {
public:
    /// One shape, as it is drawn.
    struct Instance {
        glm::ivec3 low{0}, high{0};  ///< box of the cells in use, rounded to bricks; high excluded
        glm::vec3 position{0};       ///< drawn now, from the render origin
        glm::quat rotation{1, 0, 0, 0};
        float voxelSize = 0.1f;
        bool glass = false;   ///< its palette has entries of opacity < 255
        bool mirror = false;  ///< its palette has entries smooth enough for reflection rays
        /// Whether it has no voxels, or the slot no shape.
        bool empty() const { return low.x >= high.x; }
        /// The box around it, from the render origin.
        WorldBox box() const;
    };

    /// Where the directory of a shape lies: its texels in lib/bodies.glsl.
    struct Layout {
        uint32_t node = 0, palette = 0, flags = 0, unused = 0;
        glm::ivec4 sizeInNodes{0}, low{0}, high{0};
    };

    /// Names of materials by index, for detail maps of palettes that come from now on. Empty: those of the default
    /// table.
    void setMaterials(std::span<const std::string> names) { m_detailMaps = DetailMaps::mapsOf(names); }
    /// Adds a shape with its bricks.
    void create(const SnapshotShape& shape);
    /// Removes a shape; one that is not there is ignored, here and below.
    void destroy(ShapeHandle shape);
    /// Removes all shapes.
    void clear();
    /// Replaces a brick of a shape.
    void setBrick(const BrickChange& change);
    /// Replaces palette and paint colours of a shape. Returns the palette that it had; null: there is no such shape.
    PaletteRef setPalette(const SnapshotPalette& given);
    /// Moves a shape.
    void setPose(const SnapshotPose& pose);

    /// Sends bricks in the order in which they came, at most budgetBytes of them. Returns the bytes sent.
    uint64_t sendBricks(uint64_t budgetBytes) { return m_atlas.upload(budgetBytes); }
    /// Interpolates the poses of what moves (alpha: 0 to 1) and sends what changed, except bricks. originWorld: the
    /// point that GPU coordinates are relative to. isSameMoment, hidden: see Scene::beginFrame(). Returns the bytes
    /// sent.
    uint64_t beginFrame(float alpha, glm::dvec3 originWorld, bool isSameMoment = false,
                        std::span<const ShapeHandle> hidden = {});

    /// Bytes of those bricks of a snapshot that the atlas does not have.
    uint64_t newBytes(const FrameSnapshot& snapshot) const;
    /// Queues the bricks of a snapshot that is applied later. They have been sent once bricksSent() is the number that
    /// this returns.
    uint64_t retainBricks(const FrameSnapshot& snapshot);
    /// Ends retainBricks(), after the snapshot was applied.
    void releaseBricks(const FrameSnapshot& snapshot);
    /// Number of bricks sent so far.
    uint64_t bricksSent() const { return m_atlas.sent(); }
    /// Bytes of bricks that are queued and not sent.
    uint64_t waitingBytes() const { return (m_atlas.queued() - m_atlas.sent()) * BrickAtlas::kBrickBytes; }
    /// Sets the samplers of lib/bodies.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// What the last beginFrame() did.
    struct Touched {
        std::vector<uint32_t> slots;  ///< of the instances that it moved or found changed or removed
        uint64_t frame = 0;           ///< number of calls so far
        bool hidesOthers = false;     ///< other shapes are left out than before
        MovingBodies moving;          ///< those that are drawn elsewhere than the shadow volume has them
    };
    /// Of the last beginFrame().
    const Touched& touched() const { return m_touched; }
    /// The boxes of all instances that are not empty(), by slot, from the render origin.
    const BoundsTree& bounds() const { return m_bounds; }
    /// By slot; slots without a shape are empty().
    const std::vector<Instance>& instances() const { return m_instances; }
    /// Of the shape in a slot.
    const Layout& layout(size_t slot) const { return m_layouts[slot]; }
    /// Whether any shape has glass.
    bool hasGlass() const { return m_glassShapes > 0; }
    /// Whether any shape has surfaces smooth enough for reflection rays.
    bool hasMirrors() const { return m_mirrorShapes > 0; }
    /// Whether any palette has a material with a detail map.
    bool hasDetail() const { return m_detailPalettes > 0; }
    /// Number of shapes.
    int shapes() const { return m_shapeCount; }
    /// Number of different bricks.
    int bricks() const { return m_atlas.bricks(); }
    /// GPU memory.
    uint64_t bytes() const;

private:
    // What lib/bodies.glsl reads as texels.
    struct Node {
        uint32_t mask[2] = {0, 0};  ///< which of its 4x4x4 bricks exist
        uint32_t table = 0;         ///< first entry in m_tables
        uint32_t unused = 0;
    };
    struct Table {
        uint32_t entry[64] = {};  ///< slot << 8 | occupied 4x4x4 words
    };
    struct InstanceTransform {
        glm::vec4 rotation{0, 0, 0, 1}, position{0}, lastRotation{0, 0, 0, 1}, lastPosition{0};
    };
    struct GpuPalette {
        uint32_t entry[256][4] = {};
    };
    struct Shape {
        ShapeHandle handle;
        glm::ivec3 size{0}, sizeInNodes{0};
        float voxelSize = 0.1f;
        uint32_t firstNode = 0;
        PaletteRef palette;
        std::vector<std::unique_ptr<std::array<BrickRef, 64>>> bricks;  ///< by node
        std::array<LayerCounts, 3> layers;                              ///< of bricks that exist, by axis
        Pose previous, current;
        bool hasTransform = false;  ///< its transform has been sent: the next frame can reproject from it
        bool moving = false;        ///< is in m_moving
    };
    Shape* find(ShapeHandle handle);
    void release(Shape& shape, uint32_t slot);
    void putBrick(Shape& shape, glm::ivec3 brick, const BrickRef& content);
    bool hide(std::span<const ShapeHandle> shapes);
    bool isHidden(ShapeHandle shape) const;
    void updateBounds(uint32_t slot);
    void updateTree();
    uint32_t acquireGpuPalette(const PaletteRef& palette);
    void releaseGpuPalette(const Palette* palette);
    void usePalette(Shape& shape, uint32_t slot, const PaletteRef& palette);
    /// Colours and flag of the shape's paint layer.
    void usePaint(uint32_t slot, const PaintColorsRef& colors);
    void updateTransforms(float alpha);
    void updateTransform(uint32_t slot, float alpha, glm::dvec3 originWorld);
    void listMovingBodies();
    bool hasRoom(uint32_t slot) const;
    void leaveOutWithoutRoom();
    void leaveOutBricks(const Shape& shape);

    struct PaletteUse {
        PaletteRef palette;
        uint32_t slot = 0, references = 0;
        bool detail = false;  ///< an entry has a detail map
    };
    BrickAtlas m_atlas;
    StagedBuffer<Node> m_nodes{GL_RGBA32UI, "brick directory"};
    StagedBuffer<Table> m_tables{GL_R32UI, "brick tables"};
    StagedBuffer<InstanceTransform> m_transforms{GL_RGBA32F, "instances"};
    StagedBuffer<Layout> m_layouts{GL_RGBA32UI, "shape layouts"};
    StagedBuffer<GpuPalette> m_palettes{GL_RGBA32UI, "palettes"};
    RangeAllocator m_nodeRanges;
    IndexAllocator m_tableSlots, m_paletteSlots;
    std::array<uint8_t, 256> m_detailMaps = DetailMaps::mapsOf({});  ///< of materials
    std::unordered_map<const Palette*, PaletteUse> m_paletteUses;
    std::vector<std::unique_ptr<Shape>> m_shapes;  ///< by the handle's slot
    std::vector<Instance> m_instances;
    std::vector<uint32_t> m_moving, m_changed;  ///< slots
    std::vector<ShapeHandle> m_hidden;          ///< in ascending order
    Touched m_touched;
    BoundsTree m_bounds;
    glm::dvec3 m_origin{0.0};
    uint32_t m_room = ~0u;  ///< of the atlas, in the last frame
    int m_shapeCount = 0, m_glassShapes = 0, m_mirrorShapes = 0, m_detailPalettes = 0;
};

}  // namespace rubble
