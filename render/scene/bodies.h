#pragma once
#include <memory>
#include <vector>

#include "render/gl/program.h"
#include "render/scene/brick_atlas.h"
#include "render/scene/detail_maps.h"
#include "render/scene/staged_buffer.h"
#include "runtime/frame/frame_snapshot.h"

namespace rubble {

/// All shapes on the GPU: bricks in one atlas, a two-level directory each, palettes, and an instance each. The layout
/// of the buffers is that of lib/bodies.glsl.
class Bodies {
public:
    /// What draws one shape.
    struct Instance {
        glm::ivec3 low{0}, high{0};  ///< cells that hold something, in bricks' steps
        glm::vec3 position{0};       ///< drawn now, from the render origin
        glm::quat rotation{1, 0, 0, 0};
        float voxelSize = 0.1f;
        bool glass = false;   ///< its palette has entries of opacity < 255
        bool mirror = false;  ///< its palette has entries smooth enough for reflection rays
        bool empty() const { return low.x >= high.x; }
    };

    /// How a shape's bricks are found: its texels in lib/bodies.glsl.
    struct Layout {
        uint32_t node = 0, palette = 0, flags = 0, unused = 0;
        glm::ivec4 sizeInNodes{0}, low{0}, high{0};
    };

    /// Names by index, of palettes that come from now on; none: of the default table.
    void setMaterials(std::span<const std::string> names) { m_detailMaps = DetailMaps::mapsOf(names); }
    void create(const SnapshotShape& shape);
    void destroy(ShapeHandle shape);
    void clear();
    void setBrick(const BrickChange& change);
    void setPalette(const SnapshotPalette& given);
    void setPose(const SnapshotPose& pose);

    /// Sends bricks, in the order they came, at most so many bytes. Returns the bytes sent.
    uint64_t sendBricks(uint64_t budgetBytes) { return m_atlas.upload(budgetBytes); }
    /// Places what moves between its last two poses and sends what changed, bricks aside. Returns the bytes sent.
    uint64_t beginFrame(float alpha, glm::dvec3 originWorld);

    /// Bytes of a snapshot's bricks that the atlas does not have.
    uint64_t newBytes(const FrameSnapshot& snapshot) const;
    /// Has a snapshot's bricks sent before the snapshot is applied. Returns what bricksSent() must have come to.
    uint64_t hold(const FrameSnapshot& snapshot);
    /// After the snapshot was applied.
    void releaseBricks(const FrameSnapshot& snapshot);
    uint64_t bricksSent() const { return m_atlas.sent(); }
    uint64_t waitingBytes() const { return (m_atlas.queued() - m_atlas.sent()) * BrickAtlas::kBrickBytes; }
    /// Sets the samplers of lib/bodies.glsl. The program must be in use.
    void bind(const Program& program) const;

    /// IndexAllocator of the instances that the last beginFrame() placed, gave other bounds, or found gone.
    const std::vector<uint32_t>& touched() const { return m_touched; }
    /// By slot; those with nothing in them are empty().
    const std::vector<Instance>& instances() const { return m_instances; }
    /// Of the shape in a slot of instances().
    const Layout& layout(size_t slot) const { return m_layouts[slot]; }
    bool hasGlass() const { return m_glassShapes > 0; }
    bool hasMirrors() const { return m_mirrorShapes > 0; }
    /// Any palette has an entry of a material with a detail map.
    bool hasDetail() const { return m_detailPalettes > 0; }
    int shapes() const { return m_shapeCount; }
    int bricks() const { return m_atlas.bricks(); }
    uint64_t bytes() const;

private:
    /// On the GPU, lib/bodies.glsl reads these as texels.
    struct Node {
        uint32_t mask[2] = {0, 0};  ///< which of its 4x4x4 bricks are there
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
        Pose previous, current;
        bool placed = false;  ///< has been drawn: its last placement is one to reproject from
        bool moving = false;  ///< is in m_moving
    };
    Shape* find(ShapeHandle handle);
    void release(Shape& shape, uint32_t slot);
    void putBrick(Shape& shape, glm::ivec3 brick, const BrickRef& content);
    void updateBounds(uint32_t slot);
    uint32_t acquireGpuPalette(const PaletteRef& palette);
    void releaseGpuPalette(const Palette* palette);
    void usePalette(Shape& shape, uint32_t slot, const PaletteRef& palette);
    /// Colours and flag of the shape's paint layer.
    void usePaint(uint32_t slot, const PaintColorsRef& colors);
    void place(uint32_t slot, float alpha, glm::dvec3 originWorld);

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
    std::vector<uint32_t> m_moving, m_boundsDirty, m_touched;  ///< slots
    glm::dvec3 m_origin{0.0};
    int m_shapeCount = 0, m_glassShapes = 0, m_mirrorShapes = 0, m_detailPalettes = 0;
};

}  // namespace rubble
