#include "runtime/assets/vdb/vdb_file.h"

// This file and mesh_voxels.cpp include OpenVDB, which takes long and half a gigabyte of memory to compile.
#include <fmt/format.h>
#include <openvdb/openvdb.h>
#include <tbb/global_control.h>

#include <filesystem>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>

#include "runtime/assets/assets.h"
#include "runtime/assets/file_bytes.h"
#include "runtime/assets/level_validation.h"
#include "runtime/assets/names.h"
#include "runtime/assets/vdb/fallback_palette.h"
#include "runtime/assets/vdb/level_json.h"
#include "runtime/assets/vdb/vdb_header.h"

namespace rubble {
namespace {

constexpr int kProfileVersion = 1;
constexpr uint64_t kMaxFileBytes = uint64_t(2) << 30;
constexpr uint64_t kMaxVoxels = uint64_t(1) << 28;  // in one file, tiles expanded
const std::string kPrefix = "rubble.";

openvdb::Vec3d toVdb(glm::dvec3 v) {
    return {v.x, v.y, v.z};
}
glm::dvec3 fromVdb(const openvdb::Vec3d& v) {
    return {v.x(), v.y(), v.z()};
}
openvdb::Coord toCoord(glm::ivec3 c) {
    return {c.x, c.y, c.z};
}
glm::ivec3 fromCoord(const openvdb::Coord& c) {
    return {c.x(), c.y(), c.z()};
}

/// The index-to-world transform of cell centres, for cells of which i covers [i, i + 1] voxels from the corner.
openvdb::math::Transform::Ptr gridTransform(const Pose& corner, double voxelSize) {
    const glm::dvec3 origin = corner.transformPoint(glm::dvec3(0.5 * voxelSize));
    if (corner.rotation == glm::dquat(1, 0, 0, 0)) {
        auto transform = openvdb::math::Transform::createLinearTransform(voxelSize);
        transform->postTranslate(toVdb(origin));
        return transform;
    }
    openvdb::Mat4d matrix = openvdb::Mat4d::identity();  // OpenVDB multiplies row vectors: row i is the image of axis i
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0.0);
        axis[i] = voxelSize;
        const glm::dvec3 image = corner.rotation * axis;
        for (int j = 0; j < 3; ++j) matrix(i, j) = image[j];
    }
    matrix.setTranslation(toVdb(origin));
    return openvdb::math::Transform::createLinearTransform(matrix);
}

/// A grid with a value for each voxel of which valueOf(brick, index in the brick) has one.
template <class Grid, class ValueOf>
typename Grid::Ptr makeGrid(const LevelShape& shape, const Pose& world, const std::string& name, ValueOf valueOf) {
    using Leaf = typename Grid::TreeType::LeafNodeType;
    auto grid = Grid::create(typename Grid::ValueType(0));
    shape.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
        auto leaf = std::make_unique<Leaf>(toCoord(position * kBrickSize), grid->background(), false);
        forEachVoxel(brick->occupancy, [&](int i) {
            if (const auto value = valueOf(*brick, i))
                leaf->setValueOn(Leaf::coordToOffset(toCoord(voxelInBrick(i))), *value);
        });
        if (!leaf->isEmpty()) grid->tree().addLeaf(leaf.release());
    });
    grid->pruneGrid();
    grid->setName(name);
    grid->setTransform(gridTransform(world, double(shape.voxelSize)));
    return grid;
}

/// Adds the grids of one shape; see writeVdbFile().
void addShapeGrids(const LevelShape& shape, const Pose& world, const std::string& prefix, openvdb::GridPtrVec& out) {
    static const Palette kNoPalette{};
    const Palette& palette = shape.palette ? *shape.palette : kNoPalette;
    out.push_back(makeGrid<openvdb::Int32Grid>(shape, world, prefix + ".palette_index", [](const Brick& brick, int i) {
        return std::optional<int32_t>(brick.at(i));
    }));
    auto density = makeGrid<openvdb::FloatGrid>(shape, world, prefix + ".density",
                                                [](const Brick&, int) { return std::optional<float>(1.0f); });
    density->setGridClass(openvdb::GRID_FOG_VOLUME);
    out.push_back(density);
    auto color = makeGrid<openvdb::Vec3SGrid>(shape, world, prefix + ".color", [&](const Brick& brick, int i) {
        const PaletteEntry& entry = palette[brick.at(i)];
        return std::optional<openvdb::Vec3f>(
            {srgbToLinear(entry.red), srgbToLinear(entry.green), srgbToLinear(entry.blue)});
    });
    color->setSaveFloatAsHalf(true);
    out.push_back(color);
    auto emission = makeGrid<openvdb::FloatGrid>(shape, world, prefix + ".emission", [&](const Brick& brick, int i) {
        const float emitted = palette[brick.at(i)].emission;
        return emitted > 0.0f ? std::optional<float>(emitted) : std::nullopt;
    });
    if (!emission->empty()) out.push_back(emission);
    auto group = makeGrid<openvdb::Int32Grid>(shape, world, prefix + ".light_group", [&](const Brick& brick, int i) {
        const uint32_t number = palette[brick.at(i)].lightGroup;
        return number ? std::optional<int32_t>(int32_t(number)) : std::nullopt;
    });
    if (!group->empty()) out.push_back(group);
    if (!shape.paintColors) return;
    out.push_back(makeGrid<openvdb::Int32Grid>(shape, world, prefix + ".paint", [](const Brick& brick, int i) {
        return brick.paintAt(i) ? std::optional<int32_t>(brick.paintAt(i)) : std::nullopt;
    }));
}

/// The name with an underscore for everything but letters, digits and hyphens, so that viewers and scripts can type it.
std::string gridName(const std::string& name) {
    std::string out;
    for (char c : name)
        out += (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' ? c : '_';
    return out.empty() ? "shape" : out;
}

/// A name for the grids of a shape that no shape before has; UniqueNames numbers by " 2".
std::string uniqueGridName(UniqueNames& names, std::set<std::string>& taken, const std::string& shape) {
    std::string name = names.unique(gridName(shape));
    std::replace(name.begin(), name.end(), ' ', '_');
    return taken.insert(name).second ? name : uniqueGridName(names, taken, shape);
}

/// The solid cells of one grid of the file.
struct SolidCells {
    openvdb::CoordBBox box;
    VoxelGrid grid;  ///< whose cell 0 is box.min()
};

/// Expands the values and tiles of grids to voxels, and counts them over all grids of a file.
class VoxelExpander {
public:
    /// indexOf(value, active): the palette index of a value, 0 for empty. Inactive values inside level sets count too.
    /// `atLeast`: a box that the result covers at least.
    template <class Grid, class IndexOf>
    Result<SolidCells> expand(const Grid& grid, const openvdb::CoordBBox& atLeast, IndexOf indexOf) {
        SolidCells solid;
        solid.box = grid.evalActiveVoxelBoundingBox();
        if (!atLeast.empty()) solid.box.expand(atLeast);
        if (solid.box.empty()) return solid;
        for (int i = 0; i < 3; ++i) {
            const int64_t length = int64_t(solid.box.max()[i]) - solid.box.min()[i] + 1;
            if (length > kMaxGridSize)
                return Error{fmt::format("grid '{}': expected at most {} cells on a side, found {}", grid.getName(),
                                         kMaxGridSize, length)};
        }
        solid.grid = VoxelGrid(fromCoord(solid.box.dim()));
        GridWriter writer(solid.grid);
        std::string error;
        const auto visit = [&](auto value, bool active, const openvdb::CoordBBox& cells) {
            const int index = indexOf(value, active);
            if (index == 0) return true;
            if (index < 0 || index > 255)
                return error = fmt::format("grid '{}': expected values of 0 to 255, found {} at cell ({}, {}, {})",
                                           grid.getName(), index, cells.min().x(), cells.min().y(), cells.min().z()),
                       false;
            openvdb::CoordBBox part = cells;
            part.intersect(solid.box);
            if (part.empty()) return true;
            if ((m_voxels += part.volume()) > kMaxVoxels)
                return error = fmt::format("grid '{}': expected at most {} voxels in a file, found more",
                                           grid.getName(), kMaxVoxels),
                       false;
            for (auto cell = part.begin(); cell; ++cell) writer.set(fromCoord(*cell - solid.box.min()), uint8_t(index));
            return true;
        };
        for (auto it = grid.tree().cbeginValueAll(); it; ++it) {
            openvdb::CoordBBox cells;
            it.getBoundingBox(cells);
            if (!visit(*it, it.isValueOn(), cells)) return Error{error};
        }
        writer.flush();
        return solid;
    }

private:
    uint64_t m_voxels = 0;
};

/// The minimum corner of a cell as a pose in the world, and the size of cells in metres. An error if cells are not
/// cubes.
Result<std::pair<Pose, double>> cornerPose(const openvdb::GridBase& grid, const openvdb::Coord& cell) {
    const auto refuse = [&](const std::string& found) {
        return Error{fmt::format("grid '{}': expected a transform with cubic cells, found {}", grid.getName(), found)};
    };
    if (!grid.transform().isLinear()) return refuse("a frustum transform");
    const openvdb::Mat4d matrix = grid.transform().baseMap()->getAffineMap()->getMat4();
    for (int i = 0; i < 16; ++i)
        if (!(std::abs(matrix.asPointer()[i]) <= 1e9)) return refuse(fmt::format("{}", matrix.asPointer()[i]));
    glm::dmat3 axes;
    for (int i = 0; i < 3; ++i) axes[i] = {matrix(i, 0), matrix(i, 1), matrix(i, 2)};
    const double size = glm::length(axes[0]);
    if (!(size > 1e-6 && size <= 1000.0)) return refuse(fmt::format("cells of {} m", size));
    const glm::dmat3 rotation = axes * (1.0 / size);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(glm::dot(rotation[i], rotation[j]) - (i == j ? 1.0 : 0.0)) > 1e-3)
                return refuse("stretched or sheared cells");
    if (glm::dot(glm::cross(rotation[0], rotation[1]), rotation[2]) < 0.0) return refuse("mirrored cells");
    Pose pose;
    pose.rotation = glm::normalize(glm::quat_cast(rotation));
    if (rotation == glm::dmat3(1.0)) pose.rotation = glm::dquat(1, 0, 0, 0);
    pose.position = fromVdb(grid.transform().indexToWorld(toVdb(glm::dvec3(fromCoord(cell)) - 0.5)));
    return std::pair(pose, size);
}

/// Gives access to the library's registration of grid types, which is protected.
struct GridTypes : openvdb::GridBase {
    using openvdb::GridBase::registerGrid;
};

/// Reads one file.
class VdbReader {
public:
    VdbReader(const std::string& path, std::vector<std::string>& notes) : m_path(path), m_notes(notes), m_file(path) {}

    /// The library refuses a whole file for one grid type that it does not know. Registers an empty grid for such
    /// types, so that it reads the others.
    void skipUnknownTypes(const std::vector<VdbGridEntry>& entries) {
        for (const VdbGridEntry& entry : entries) {
            const std::string type = entry.type.substr(0, entry.type.find("_HalfFloat"));
            const bool known = openvdb::GridBase::isRegistered(type) && !m_unknownTypes.contains(type);
            if (known) continue;
            if (m_unknownTypes.insert(type).second)
                GridTypes::registerGrid(type, [] { return openvdb::GridBase::Ptr(openvdb::BoolGrid::create()); });
            const std::string name = openvdb::io::GridDescriptor::nameAsString(entry.name);
            m_unknown.insert(name);
            m_notes.push_back(fmt::format("grid '{}': type {} is unknown, skipped", name, type));
        }
    }

    Result<Level> read() {
        m_file.open(false);
        const openvdb::MetaMap::ConstPtr metadata = m_file.getMetadata();
        for (auto name = m_file.beginName(); name != m_file.endName(); ++name)
            if (!m_unknown.contains(name.gridName())) m_names.push_back(name.gridName());
        const auto version = metadata->getMetadata<openvdb::Int32Metadata>(kPrefix + "version");
        if (!version) return readWithoutProfile();
        if (version->value() != kProfileVersion)
            return Error{
                fmt::format("metadata rubble.version: expected {}, found {}", kProfileVersion, version->value())};
        return readProfile(*metadata);
    }

private:
    /// A file that writeVdbFile() has written, perhaps changed by other programs.
    Result<Level> readProfile(const openvdb::MetaMap& metadata) {
        std::map<std::string, std::string> topics;
        for (auto item = metadata.beginMeta(); item != metadata.endMeta(); ++item)
            if (item->first.starts_with(kPrefix) && item->second->typeName() == "string" &&
                item->first != kPrefix + "content_hash")
                topics[item->first.substr(kPrefix.size())] = item->second->str();
        Result<JsonLevel> parsed = levelFromJson(topics);
        if (!parsed) return Error{parsed.error()};
        size_t number = 0;
        for (LevelBody& body : parsed->level.bodies)
            for (LevelShape& shape : body.shapes)
                if (const Result<Done> done = readShape(body, shape, parsed->gridNames[number++]); !done)
                    return Error{done.error()};
        noteUnusedGrids(parsed->gridNames);
        const auto hash = metadata.getMetadata<openvdb::StringMetadata>(kPrefix + "content_hash");
        if (!hash || hash->value() != fmt::format("{:016x}", hashLevel(parsed->level)))
            m_notes.push_back(
                "the content does not have the recorded hash: another program or another version of Rubble wrote it, "
                "or it is damaged");
        return std::move(parsed->level);
    }

    /// Fills the voxels of a shape. If another program moved or extended its grid, the shape follows.
    Result<Done> readShape(const LevelBody& body, LevelShape& shape, const std::string& prefix) {
        const std::string name = prefix + ".palette_index";
        if (!hasGrid(name))
            return Error{fmt::format("expected a grid '{}' for shape '{}', found none", name, shape.name)};
        const auto grid = openvdb::gridPtrCast<openvdb::Int32Grid>(m_file.readGrid(name));
        if (!grid) return Error{fmt::format("grid '{}': expected type Int32, found another", name)};
        openvdb::CoordBBox declared;
        if (shape.grid.size().x > 0) declared = openvdb::CoordBBox(openvdb::Coord(0), toCoord(shape.grid.size() - 1));
        Result<SolidCells> solid =
            m_expander.expand(*grid, declared, [](int32_t value, bool active) { return active ? value : 0; });
        if (!solid) return Error{solid.error()};
        shape.grid = std::move(solid->grid);
        const openvdb::Coord corner = solid->box.empty() ? openvdb::Coord(0) : solid->box.min();
        if (shape.paintColors)
            if (const Result<Done> done = readPaint(shape, prefix + ".paint", corner); !done) return done;
        const auto expected = gridTransform(body.pose * shape.local, double(shape.voxelSize));
        const bool moved = !(*expected == grid->transform());
        if (!moved && corner == openvdb::Coord(0)) return Done{};
        const auto pose = cornerPose(*grid, corner);
        if (!pose) return Error{pose.error()};
        m_notes.push_back(fmt::format("'{}': {} by another program", shape.name, moved ? "moved" : "extended"));
        const Pose toBody{glm::conjugate(body.pose.rotation) * -body.pose.position, glm::conjugate(body.pose.rotation)};
        shape.local = toBody * pose->first;
        shape.voxelSize = float(pose->second);
        return Done{};
    }

    /// Reads the paint bytes (runtime/voxel/paint_colors.h) of solid cells. Values that are no colour of the shape are
    /// ignored.
    Result<Done> readPaint(LevelShape& shape, const std::string& name, const openvdb::Coord& corner) {
        if (!hasGrid(name)) return Done{};
        const auto grid = openvdb::gridPtrCast<openvdb::Int32Grid>(m_file.readGrid(name));
        if (!grid) return Error{fmt::format("grid '{}': expected type Int32, found another", name)};
        const auto values = grid->getConstAccessor();
        std::vector<std::pair<glm::ivec3, BrickRef>> painted;
        shape.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            BrickIndices indices, paint{};
            bool isPainted = false;
            forEachVoxel(brick->occupancy, [&](int i) {
                const int32_t value = values.getValue(toCoord(position * kBrickSize + voxelInBrick(i)) + corner);
                if (value < 16 || paintColor(uint8_t(value)) > shape.paintColors->count || value > 255) return;
                paint[size_t(i)] = uint8_t(value);
                isPainted = true;
            });
            if (!isPainted) return;
            expandBrick(brick.get(), indices);
            painted.emplace_back(position, makeBrick(indices, &paint));
        });
        for (auto& [position, brick] : painted) shape.grid.setBrick(position, std::move(brick));
        return Done{};
    }

    void noteUnusedGrids(const std::vector<std::string>& prefixes) {
        for (const std::string& name : m_names) {
            const std::string prefix = name.substr(0, name.rfind('.'));
            if (std::find(prefixes.begin(), prefixes.end(), prefix) == prefixes.end())
                m_notes.push_back(fmt::format("grid '{}': belongs to no shape, skipped", name));
        }
    }

    /// A file of another program: every grid that gives occupancy becomes a shape on a static body.
    Result<Level> readWithoutProfile() {
        Level level;
        level.name = printableName(std::filesystem::path(m_path).stem().string());
        UniqueNames names;
        const bool hasDensity = std::any_of(m_names.begin(), m_names.end(), isOccupancy);
        for (const std::string& name : m_names) {
            if (isAttribute(name) || (suffix(name) == "density" && hasGrid(prefixOf(name) + "palette_index"))) continue;
            const openvdb::GridBase::Ptr grid = m_file.readGrid(name);
            const Result<std::pair<Pose, double>> cubes = cornerPose(*grid, openvdb::Coord(0));
            Result<SolidCells> solid = cubes ? solidOf(*grid, name, hasDensity) : Error{cubes.error()};
            if (!solid || solid->grid.empty()) {
                m_notes.push_back(solid ? fmt::format("grid '{}': no solid voxels, skipped", name)
                                        : solid.error() + ", skipped");
                continue;
            }
            const std::string prefix = name.substr(0, prefixOf(name).size() - (prefixOf(name).empty() ? 0 : 1));
            const std::string own = !prefix.empty() ? prefix : isOccupancy(name) ? level.name : name;
            addGridAsShape(level, names.unique(printableName(own)), *grid, name, std::move(*solid));
        }
        if (level.bodies.empty()) {
            std::string why = m_notes.empty() ? "the file has no grids" : m_notes.front();
            return Error{"expected at least one grid of voxels, found none: " + why};
        }
        return level;
    }

    /// Palette indices as they are; 1 for Bool and Mask that are on, the inside of level sets, and density of at least
    /// half the maximum, or at least 0.5. hasDensity: other Float grids are channels of other meaning.
    Result<SolidCells> solidOf(const openvdb::GridBase& grid, const std::string& name, bool hasDensity) {
        const openvdb::CoordBBox none;
        if (const auto* whole = dynamic_cast<const openvdb::Int32Grid*>(&grid);
            whole && suffix(name) == "palette_index")
            return m_expander.expand(*whole, none, [](int32_t value, bool active) { return active ? value : 0; });
        if (const auto* flags = dynamic_cast<const openvdb::BoolGrid*>(&grid))
            return m_expander.expand(*flags, none, [](bool value, bool active) { return active && value ? 1 : 0; });
        if (const auto* mask = dynamic_cast<const openvdb::MaskGrid*>(&grid))
            return m_expander.expand(*mask, none, [](bool, bool active) { return active ? 1 : 0; });
        const auto* number = dynamic_cast<const openvdb::FloatGrid*>(&grid);
        if (!number)
            return Error{fmt::format("grid '{}': expected Float, Bool or Mask, or Int32 palette_index, found {}", name,
                                     grid.type())};
        if (number->getGridClass() == openvdb::GRID_LEVEL_SET)
            return m_expander.expand(*number, none, [](float value, bool) { return value < 0.0f ? 1 : 0; });
        if (hasDensity && suffix(name) != "density")
            return Error{fmt::format("grid '{}': expected density, found another channel", name)};
        float maximum = 0.0f;
        for (auto it = number->cbeginValueOn(); it; ++it) maximum = std::max(maximum, *it);
        const float threshold = std::min(0.5f, maximum * 0.5f);
        return m_expander.expand(*number, none, [threshold](float value, bool active) {
            return active && value > 0.0f && value >= threshold ? 1 : 0;
        });
    }

    void addGridAsShape(Level& level, const std::string& shapeName, const openvdb::GridBase& grid,
                        const std::string& name, SolidCells solid) {
        const auto pose = cornerPose(grid, solid.box.min());
        if (!pose) return m_notes.push_back(pose.error() + ", skipped");
        LevelBody& body = level.bodies.emplace_back();
        body.name = shapeName;
        body.pose = pose->first;
        LevelShape& shape = body.shapes.emplace_back();
        shape.name = shapeName;
        shape.voxelSize = float(pose->second);
        shape.grid = std::move(solid.grid);
        openvdb::Vec3SGrid::Ptr color;
        const std::string colorName = prefixOf(name) + "color";
        if (hasGrid(colorName)) color = openvdb::gridPtrCast<openvdb::Vec3SGrid>(m_file.readGrid(colorName));
        if (suffix(name) == "palette_index") {
            shape.palette = voxFallbackPalette(shape.grid);
        } else if (color) {
            const auto values = color->getConstAccessor();
            shape.palette = quantiseColors(shape.grid, [&](glm::ivec3 cell) {
                const openvdb::Vec3f value = values.getValue(toCoord(cell) + solid.box.min());
                return packSrgb({value.x(), value.y(), value.z()});
            });
        } else {
            shape.palette = grayFallbackPalette();
        }
        m_notes.push_back(fmt::format("grid '{}' -> shape '{}', {} voxels of {} m{}", name, shapeName,
                                      shape.grid.voxelCount(), shape.voxelSize,
                                      color ? ", colours from '" + colorName + "'" : ""));
    }

    bool hasGrid(const std::string& name) const {
        return std::find(m_names.begin(), m_names.end(), name) != m_names.end();
    }
    static bool isOccupancy(const std::string& name) {
        return suffix(name) == "density" || suffix(name) == "palette_index";
    }
    /// Whether the grid gives a property of voxels that another grid makes solid.
    static bool isAttribute(const std::string& name) {
        return suffix(name) == "color" || suffix(name) == "emission" || suffix(name) == "light_group" ||
               suffix(name) == "paint";
    }
    static std::string suffix(const std::string& name) { return name.substr(name.rfind('.') + 1); }
    /// Everything before the suffix with its dot; "" if there is none.
    static std::string prefixOf(const std::string& name) { return name.substr(0, name.rfind('.') + 1); }

    const std::string& m_path;
    std::vector<std::string>& m_notes;
    openvdb::io::File m_file;
    std::vector<std::string> m_names;
    std::set<std::string> m_unknown, m_unknownTypes;
    VoxelExpander m_expander;
};

/// Makes the bytes of a file. OpenVDB's own File does not notice a disk that is full.
struct SeekableArchive : openvdb::io::Archive {
    static std::vector<uint8_t> bytes(const openvdb::GridPtrVec& grids, const openvdb::MetaMap& metadata) {
        std::ostringstream out(std::ios::binary);
        SeekableArchive().Archive::write(out, grids, true, metadata);
        const std::string_view text = out.view();
        return {text.begin(), text.end()};
    }
};

Result<std::vector<VdbGridEntry>> scanFile(const std::string& path) {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxFileBytes);
    if (!bytes) return Error{bytes.error()};
    return scanVdbHeader(*bytes, path);
}

}  // namespace

Result<Done> writeVdbFile(const std::string& path, const Level& level) try {
    if (const Result<Done> checked = validateLevel(level); !checked) return Error{path + ": " + checked.error()};
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
    openvdb::initialize();
    openvdb::GridPtrVec grids;
    UniqueNames names;
    std::set<std::string> taken;
    std::vector<std::string> prefixes;
    for (const LevelBody& body : level.bodies)
        for (const LevelShape& shape : body.shapes)
            addShapeGrids(shape, body.pose * shape.local,
                          prefixes.emplace_back(uniqueGridName(names, taken, shape.name)), grids);
    openvdb::MetaMap metadata;
    metadata.insertMeta(kPrefix + "version", openvdb::Int32Metadata(kProfileVersion));
    metadata.insertMeta(kPrefix + "content_hash", openvdb::StringMetadata(fmt::format("{:016x}", hashLevel(level))));
    for (const auto& [topic, text] : levelToJson(level, prefixes))
        metadata.insertMeta(kPrefix + topic, openvdb::StringMetadata(text));
    return writeFileAtomically(path, SeekableArchive::bytes(grids, metadata), kMaxFileBytes);
} catch (const std::exception& error) {
    return Error{path + ": " + error.what()};
}

Result<Level> readVdbFile(const std::string& path, std::vector<std::string>& notes) try {
    const Result<std::vector<VdbGridEntry>> entries = scanFile(path);
    if (!entries) return Error{entries.error()};
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 2);
    openvdb::initialize();
    VdbReader reader(path, notes);
    reader.skipUnknownTypes(*entries);
    Result<Level> level = reader.read();
    if (!level) return Error{path + ": " + level.error()};
    if (const Result<Done> checked = validateLevel(*level); !checked) return Error{path + ": " + checked.error()};
    return level;
} catch (const std::bad_alloc&) {
    return Error{path + ": not enough memory for what it describes (RUBBLE_VDB_MEMORY_MIB raises the limit)"};
} catch (const std::exception& error) {
    return Error{path + ": " + error.what()};
}

}  // namespace rubble
