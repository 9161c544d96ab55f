#include "runtime/assets/vox_export.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <map>
#include <set>
#include <span>

#include "runtime/assets/file_bytes.h"
#include "runtime/assets/vox_export_palette.h"
#include "runtime/assets/vox_import.h"
#include "runtime/core/counted.h"

namespace rubble {
namespace {

constexpr int kModelSize = 256;  // cells a side of one model

using Bytes = std::vector<uint8_t>;

void addWord(Bytes& out, uint32_t value) {
    for (int i = 0; i < 4; ++i) out.push_back(uint8_t(value >> (8 * i)));
}

void addText(Bytes& out, std::string_view text) {
    addWord(out, uint32_t(text.size()));
    out.insert(out.end(), text.begin(), text.end());
}

void addAttributes(Bytes& out, const VoxAttributes& attributes) {
    addWord(out, uint32_t(attributes.size()));
    for (const auto& [key, value] : attributes) addText(out, key), addText(out, value);
}

void addChunk(Bytes& out, std::string_view kind, std::span<const uint8_t> content,
              std::span<const uint8_t> children = {}) {
    for (const char c : kind) out.push_back(uint8_t(c));
    addWord(out, uint32_t(content.size()));
    addWord(out, uint32_t(children.size()));
    out.insert(out.end(), content.begin(), content.end());
    out.insert(out.end(), children.begin(), children.end());
}

/// Voxels of one model, in the file's axes.
struct Model {
    glm::ivec3 low{INT32_MAX}, high{INT32_MIN};  ///< of its voxels
    std::vector<std::pair<glm::ivec3, uint8_t>> voxels;
};

/// A shape's cells in the cells of the world: the nearest turn by right angles, and whole cells.
struct Placement {
    glm::ivec3 columns[3];  ///< where its axes point
    glm::ivec3 offset{0};   ///< of its grid's corner
    bool isExact = true;

    Placement(const Pose& pose, double voxelSize) {
        const glm::dmat3 turn = glm::mat3_cast(pose.rotation);
        bool used[3] = {};
        for (int axis = 0; axis < 3; ++axis) {
            int best = -1;
            for (int to = 0; to < 3; ++to)
                if (!used[to] && (best < 0 || std::abs(turn[axis][to]) > std::abs(turn[axis][best]))) best = to;
            used[best] = true;
            columns[axis] = glm::ivec3(0);
            columns[axis][best] = turn[axis][best] < 0.0 ? -1 : 1;
            isExact = isExact && std::abs(turn[axis][best]) > 0.99999;
        }
        const glm::dvec3 corner = pose.position / voxelSize, whole = glm::floor(corner + 0.5);
        isExact = isExact && glm::length(corner - whole) < 0.01;
        for (int a = 0; a < 3; ++a) offset[a] = int(std::clamp(whole[a], -9e6, 9e6));
    }
    /// The cell of the file that holds a cell of the shape: x right, y away, z up.
    glm::ivec3 cell(glm::ivec3 from) const {
        glm::ivec3 world = offset;
        for (int axis = 0; axis < 3; ++axis)
            for (int to = 0; to < 3; ++to) {
                if (columns[axis][to] > 0) world[to] += from[axis];
                if (columns[axis][to] < 0) world[to] -= from[axis] + 1;
            }
        return {world.x, -world.z - 1, world.y};
    }
};

/// Takes a level apart into models and nodes.
class Exporter {
public:
    Exporter(const Level& level, std::vector<std::string>& lost) : m_level(level), m_lost(lost) {}
    /// The whole file.
    Bytes run() {
        gather();
        const VoxExportPalette palette = voxExportPalette(m_shapes, m_level.materials);
        m_lost.insert(m_lost.end(), palette.lost.begin(), palette.lost.end());
        for (size_t i = 0; i < m_shapes.size(); ++i) addShape(i, palette.slots[i]);
        reportLost();
        addNodes();
        addPalette(palette);
        Bytes out;
        for (const char c : std::string_view("VOX ")) out.push_back(uint8_t(c));
        addWord(out, 150);
        addChunk(out, "MAIN", {}, m_chunks);
        return out;
    }

private:
    struct Object {
        std::string name;
        bool isHidden;
        glm::ivec3 place;  ///< of the model's pivot
    };

    /// All shapes with voxels; the size of most voxels becomes that of all.
    void gather() {
        std::map<float, uint64_t> sizes;
        for (const LevelBody& body : m_level.bodies) {
            m_tagged += !body.tags.empty();
            for (const LevelShape& shape : body.shapes) {
                if (shape.grid.empty()) continue;
                m_shapes.push_back(&shape);
                m_bodies.push_back(&body);
                sizes[shape.voxelSize] += shape.grid.voxelCount();
            }
        }
        uint64_t most = 0;
        for (const auto& [size, voxels] : sizes)
            if (voxels > most) most = voxels, m_voxelSize = size;
        if (sizes.size() > 1)
            m_lost.push_back(fmt::format("voxels of {} sizes: all become cells of {} m", sizes.size(), m_voxelSize));
    }

    void addShape(size_t number, const std::array<uint8_t, 256>& slots) {
        const LevelShape& shape = *m_shapes[number];
        const LevelBody& body = *m_bodies[number];
        const Placement placement(body.pose * shape.local, double(m_voxelSize));
        m_inexact += !placement.isExact;
        m_painted += bool(shape.paintColors);
        m_changed += !(shape.strength == 1.0f && shape.density == 1.0f && shape.emission == 1.0f && shape.loadBearing &&
                       shape.collisionLayer == 1 && shape.collisionMask == 255 &&
                       shape.collisionShape == CollisionShape::Voxels);
        m_tagged += !shape.tags.empty();
        glm::ivec3 low(INT32_MAX);
        forEachVoxelOf(shape.grid, [&](glm::ivec3 cell, uint8_t) { low = glm::min(low, placement.cell(cell)); });
        const auto before = [](glm::ivec3 a, glm::ivec3 b) {
            return a.z != b.z ? a.z < b.z : a.y != b.y ? a.y < b.y : a.x < b.x;
        };
        std::map<glm::ivec3, Model, decltype(before)> models(before);
        forEachVoxelOf(shape.grid, [&](glm::ivec3 cell, uint8_t entry) {
            const glm::ivec3 at = placement.cell(cell);
            Model& model = models[(at - low) / kModelSize];
            model.low = glm::min(model.low, at), model.high = glm::max(model.high, at);
            model.voxels.emplace_back(at, slots[entry]);
        });
        for (const auto& [block, model] : models) {
            const glm::ivec3 size = model.high - model.low + 1;
            m_objects.push_back({shape.name.empty() ? body.name : shape.name, shape.hidden, model.low + size / 2});
            addModel(model, size);
        }
    }

    template <class F>
    static void forEachVoxelOf(const VoxelGrid& grid, F&& f) {
        grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) { f(position * kBrickSize + voxelInBrick(i), brick->at(i)); });
        });
    }

    void addModel(const Model& model, glm::ivec3 size) {
        Bytes content;
        for (int a = 0; a < 3; ++a) addWord(content, uint32_t(size[a]));
        addChunk(m_chunks, "SIZE", content);
        content.clear();
        addWord(content, uint32_t(model.voxels.size()));
        for (const auto& [cell, slot] : model.voxels) {
            for (int a = 0; a < 3; ++a) content.push_back(uint8_t(cell[a] - model.low[a]));
            content.push_back(slot);
        }
        addChunk(m_chunks, "XYZI", content);
    }

    void addTransform(uint32_t id, uint32_t child, const VoxAttributes& attributes, const VoxAttributes& frame) {
        Bytes content;
        addWord(content, id);
        addAttributes(content, attributes);
        addWord(content, child);
        addWord(content, ~0u);  // reserved
        addWord(content, ~0u);  // of no layer
        addWord(content, 1);    // frames
        addAttributes(content, frame);
        addChunk(m_chunks, "nTRN", content);
    }

    /// A transform over a group over a transform and a shape for each object.
    void addNodes() {
        addTransform(0, 1, {}, {});
        Bytes group;
        addWord(group, 1);
        addAttributes(group, {});
        addWord(group, uint32_t(m_objects.size()));
        for (uint32_t i = 0; i < m_objects.size(); ++i) addWord(group, 2 + 2 * i);
        addChunk(m_chunks, "nGRP", group);
        for (uint32_t i = 0; i < m_objects.size(); ++i) {
            const Object& object = m_objects[i];
            VoxAttributes attributes{{"_name", object.name}};
            if (object.isHidden) attributes["_hidden"] = "1";
            const glm::ivec3 t = object.place;
            addTransform(2 + 2 * i, 3 + 2 * i, attributes, {{"_t", fmt::format("{} {} {}", t.x, t.y, t.z)}});
            Bytes shape;
            addWord(shape, 3 + 2 * i);
            addAttributes(shape, {});
            addWord(shape, 1);
            addWord(shape, i);
            addAttributes(shape, {});
            addChunk(m_chunks, "nSHP", shape);
        }
    }

    void addPalette(const VoxExportPalette& palette) {
        Bytes colors;
        for (size_t i = 1; i <= 256; ++i) {
            const PaletteEntry& entry = palette.entries[i % 256];
            colors.insert(colors.end(), {entry.red, entry.green, entry.blue, uint8_t(i < 256 ? 255 : 0)});
        }
        addChunk(m_chunks, "RGBA", colors);
        for (const auto& [index, attributes] : palette.materials) {
            Bytes content;
            addWord(content, uint32_t(index));
            addAttributes(content, attributes);
            addChunk(m_chunks, "MATL", content);
        }
    }

    /// The import makes a light for each shape that glows in a light group: only such come back.
    size_t lostLights() const {
        std::set<std::string> glowing;
        for (const LevelShape* shape : m_shapes)
            if (shape->palette &&
                std::any_of(shape->palette->begin(), shape->palette->end(),
                            [](const PaletteEntry& e) { return e.emission > 0.0f && e.lightGroup > 0; }))
                glowing.insert(shape->name);
        size_t lost = 0;
        for (const LevelLight& light : m_level.lights)
            lost += light.groupName.empty() || glowing.erase(light.shapeName) == 0;
        return lost;
    }

    void reportLost() {
        const auto tell = [&](size_t count, const char* noun, const char* why = "", const char* plural = "") {
            if (count) m_lost.push_back(counted(count, noun, plural) + why);
        };
        tell(m_inexact, "shape", ": the nearest whole cells and right angles stand for their places");
        tell(m_painted, "shape", ": their paint");
        tell(lostLights(), "light");
        tell(m_tagged, "object", ": their tags");
        tell(m_changed, "shape", ": their strength, density, glow or what they collide with");
        tell(m_level.joints.size(), "joint");
        tell(m_level.waters.size(), "body of water", "", "bodies of water");
        tell(m_level.triggers.size(), "trigger");
        tell(m_level.scripts.size(), "script");
    }

    const Level& m_level;
    std::vector<std::string>& m_lost;
    std::vector<const LevelShape*> m_shapes;
    std::vector<const LevelBody*> m_bodies;  ///< of the shapes
    std::vector<Object> m_objects;           ///< one for each model
    Bytes m_chunks;
    float m_voxelSize = 0.1f;
    size_t m_inexact = 0, m_painted = 0, m_tagged = 0, m_changed = 0;
};

}  // namespace

Result<Done> writeVox(const std::string& path, const Level& level, std::vector<std::string>& lost) {
    const auto hasVoxels = [](const LevelBody& body) {
        return std::any_of(body.shapes.begin(), body.shapes.end(),
                           [](const LevelShape& shape) { return !shape.grid.empty(); });
    };
    if (std::none_of(level.bodies.begin(), level.bodies.end(), hasVoxels))
        return Error{path + ": expected a shape with voxels, found none: a .vox file holds one at least"};
    return writeFileAtomically(path, Exporter(level, lost).run(), kMaxVoxFileBytes);
}

}  // namespace rubble
