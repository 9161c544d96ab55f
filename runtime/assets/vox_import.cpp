#include "runtime/assets/vox_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <set>
#include <tuple>

#include "runtime/assets/file_bytes.h"
#include "runtime/assets/grid_limits.h"
#include "runtime/assets/level_validation.h"
#include "runtime/assets/memory_budget.h"
#include "runtime/assets/names.h"
#include "runtime/assets/vox_palette.h"
#include "runtime/assets/vox_scene.h"
#include "runtime/core/constants.h"
#include "runtime/core/ranges.h"

namespace rubble {
namespace {

/// What an object takes beside its grid: a body, a shape, their names and tags, lines of the report.
constexpr uint64_t kObjectMemory = sizeof(LevelBody) + sizeof(LevelShape) + 2048;
// MagicaVoxel: z up, y away from the viewer. Rubble: y up, z towards the viewer.
constexpr VoxTransform kZUpToYUp{{0, 2, 1}, {1, 1, -1}, {}};

/// A model in the orientation of an instance, in the smallest grid that holds its voxels.
struct RotatedModel {
    VoxelGrid grid;
    std::array<int64_t, 3> low{};             ///< cell 0 of the grid, relative to the transform's offset
    std::array<uint64_t, 256> entryCounts{};  ///< voxels of each entry
};

/// The glowing voxels of a model.
struct Glow {
    uint64_t voxels = 0;
    glm::dvec3 center{0.0};    ///< centroid, cells of the grid
    glm::dvec3 radiance{0.0};  ///< mean, linear
};

/// `slots`: the palette index for each stored colour index; 0 for those that are empty.
RotatedModel rotateModel(const VoxModel& model, const VoxTransform& rotation, const std::array<uint8_t, 256>& slots) {
    const glm::ivec3 pivot = model.size / 2;
    // Cell v spans [v - pivot, v + 1 - pivot] along its axis; a negative sign mirrors that interval.
    const auto rotated = [&](glm::ivec3 voxel) {
        glm::ivec3 cell;
        for (int i = 0; i < 3; ++i) {
            const int from = rotation.axis[size_t(i)];
            const int corner = voxel[from] - pivot[from];
            cell[i] = rotation.sign[size_t(i)] > 0 ? corner : -corner - 1;
        }
        return cell;
    };
    const auto forEach = [&](auto&& f) {
        model.grid.forEachBrick([&](glm::ivec3 position, const BrickRef& brick) {
            forEachVoxel(brick->occupancy, [&](int i) {
                if (const uint8_t entry = slots[brick->at(i)])
                    f(rotated(position * kBrickSize + voxelInBrick(i)), entry);
            });
        });
    };
    RotatedModel out;
    glm::ivec3 low(INT32_MAX), high(INT32_MIN);
    forEach([&](glm::ivec3 cell, uint8_t entry) {
        low = glm::min(low, cell);
        high = glm::max(high, cell);
        ++out.entryCounts[entry];
    });
    if (low.x > high.x) return out;
    out.low = {low.x, low.y, low.z};
    out.grid = VoxelGrid(high - low + 1);
    GridWriter writer(out.grid);
    forEach([&](glm::ivec3 cell, uint8_t entry) { writer.set(cell - low, entry); });
    writer.flush();
    return out;
}

Glow findGlow(const VoxelGrid& grid, const Palette& palette) {
    Glow out;
    glm::dvec3 sum(0.0), radiance(0.0);
    grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
        forEachVoxel(content->occupancy, [&](int i) {
            const PaletteEntry& entry = palette[content->at(i)];
            if (entry.emission <= 0.0f) return;
            sum += glm::dvec3(brick * kBrickSize + voxelInBrick(i)) + 0.5;
            radiance += double(entry.emission) *
                        glm::dvec3(srgbToLinear(entry.red), srgbToLinear(entry.green), srgbToLinear(entry.blue));
            ++out.voxels;
        });
    });
    if (out.voxels == 0) return out;
    out.center = sum / double(out.voxels);
    out.radiance = radiance / double(out.voxels);
    return out;
}

/// Turns one parsed file into a level: an object of the scene becomes a shape, glowing voxels become light groups,
/// cameras become locations. Every decision is a line of the report.
class Importer {
public:
    Importer(const VoxFile& file, const std::string& stem, const VoxImportSettings& settings, MemoryBudget budget,
             ImportReport& report)
        : m_file(file),
          m_stem(stem),
          m_settings(settings),
          m_report(report),
          m_slots(voxPaletteSlots(file)),
          m_budget(budget) {}

    Result<Level> run(const std::vector<VoxInstance>& instances) {
        m_level.name = m_stem;
        m_report.models = int(m_file.models.size());
        for (const VoxInstance& instance : instances)
            if (m_error.empty()) addObject(instance);
        if (m_error.empty()) choosePalette();
        if (m_error.empty()) addLights();
        if (!m_error.empty()) return Error{m_error};
        addCameras();
        reportIgnored(instances);
        if (const Result<Done> checked = validateLevel(m_level); !checked) return Error{checked.error()};
        return std::move(m_level);
    }

private:
    void addLine(std::string line) { m_report.lines.push_back(std::move(line)); }

    /// Takes memory from the budget; false, and an error, if there is too little.
    bool takeMemory(uint64_t bytes) {
        if (m_budget.take(bytes)) return true;
        m_error =
            fmt::format("expected objects that take at most {} MiB and {} times the file's size of memory, found {}",
                        MemoryBudget::kFree >> 20, MemoryBudget::kPerByte, m_report.shapes + 1);
        return false;
    }
    /// The model in the orientation of an instance; made once for all instances of it.
    const RotatedModel& rotatedModel(int model, const VoxTransform& transform) {
        const auto key = std::tuple(model, transform.axis, transform.sign);
        const auto found = m_rotated.find(key);
        if (found != m_rotated.end()) return found->second;
        const RotatedModel& made =
            m_rotated.emplace(key, rotateModel(m_file.models[size_t(model)], transform, m_slots)).first->second;
        takeMemory(sizeof(RotatedModel) + made.grid.brickCount() * kBrickMemory);
        return made;
    }

    void addObject(const VoxInstance& instance) {
        const VoxTransform transform = kZUpToYUp * instance.transform;
        const RotatedModel& rotated = rotatedModel(instance.model, transform);
        if (rotated.grid.empty()) return addLine(fmt::format("model {}: no voxels, left out", instance.model));
        const uint64_t nodes = directoryNodes(rotated.grid.size());
        m_nodes += nodes;
        if (m_nodes > kMaxDirectoryNodes) m_error = "expected objects of 2^39 cells in all, found more";
        if (!m_error.empty() || !takeMemory(directoryMemory(nodes) + kObjectMemory)) return;
        m_shapeModels.push_back(&rotated);

        std::string name = printableName(instance.name.empty() ? m_stem : instance.name);
        if (instance.frame > 0) name += fmt::format(" frame {}", instance.frame);
        LevelShape shape;
        shape.name = m_names.unique(name);
        shape.voxelSize = float(m_settings.voxelSize);
        shape.grid = rotated.grid;
        shape.hidden = instance.hidden;
        if (!instance.layer.empty()) shape.tags.push_back("layer=" + printableName(instance.layer));
        if (instance.frame > 0) shape.tags.push_back(fmt::format("frame={}", instance.frame));
        glm::dvec3 corner;
        for (int i = 0; i < 3; ++i) corner[i] = double(rotated.low[size_t(i)] + transform.offset[size_t(i)]);
        reportObject(instance, shape, corner);
        addShape(std::move(shape), corner * m_settings.voxelSize);
    }

    void reportObject(const VoxInstance& instance, const LevelShape& shape, glm::dvec3 corner) {
        const glm::ivec3 size = shape.grid.size();
        std::string line =
            fmt::format("'{}': model {}, {} voxels, {}x{}x{} cells at ({}, {}, {})", shape.name, instance.model,
                        shape.grid.voxelCount(), size.x, size.y, size.z, corner.x, corner.y, corner.z);
        for (const std::string& tag : shape.tags) line += ", " + tag;
        if (shape.hidden) line += ", hidden";
        if (instance.frame > 0) line += " (kept as a hidden shape: the level shows the first frame)";
        if (instance.skippedPoses > 0)
            line += fmt::format(" ({} later poses of its animation left out)", instance.skippedPoses);
        addLine(std::move(line));
    }

    void addShape(LevelShape shape, glm::dvec3 corner) {
        ++m_report.shapes;
        m_report.voxels += shape.grid.voxelCount();
        if (m_settings.oneBody) {
            if (m_level.bodies.empty()) m_level.bodies.emplace_back().name = m_stem;
            shape.local.position = corner;
            m_level.bodies[0].shapes.push_back(std::move(shape));
            return;
        }
        LevelBody& body = m_level.bodies.emplace_back();
        body.name = shape.name;
        body.pose.position = corner;
        body.shapes.push_back(std::move(shape));
    }

    template <class F>
    void forEachShape(F&& f) {
        for (LevelBody& body : m_level.bodies)
            for (LevelShape& shape : body.shapes) f(shape);
    }

    /// Makes the one palette that all shapes share.
    void choosePalette() {
        std::array<uint64_t, 256> counts{};
        for (const RotatedModel* model : m_shapeModels)
            for (size_t i = 1; i < 256; ++i) counts[i] += model->entryCounts[i];
        std::array<bool, 256> used{};
        for (size_t i = 1; i < 256; ++i) used[i] = counts[i] > 0;
        m_palette = std::make_shared<Palette>(voxPalette(m_file, used, m_settings.teardownPalette));
        forEachShape([&](LevelShape& shape) { shape.palette = m_palette; });
        for (size_t i = 1; i < 256; ++i) {
            if (!used[i]) continue;
            const PaletteEntry& entry = (*m_palette)[i];
            std::string line = fmt::format("colour {} #{:02x}{:02x}{:02x} -> {}, {} voxels", i, entry.red, entry.green,
                                           entry.blue, m_level.materials[entry.material].name, counts[i]);
            if (entry.metallic) line += fmt::format(", metallic {}", entry.metallic);
            if (entry.opacity < 255) line += fmt::format(", opacity {}", entry.opacity);
            if (entry.emission > 0) line += fmt::format(", emission {}", entry.emission);
            addLine(std::move(line));
        }
    }

    /// Each shape with glowing voxels gets a light group and a sphere light at the centroid of those voxels.
    void addLights() {
        std::map<const RotatedModel*, Glow> glows;
        size_t number = 0;
        forEachShape([&](LevelShape& shape) {
            const RotatedModel* model = m_shapeModels[number++];
            auto glow = glows.find(model);
            if (glow == glows.end()) glow = glows.emplace(model, findGlow(model->grid, *m_palette)).first;
            if (glow->second.voxels > 0 && !shape.hidden && takeMemory(sizeof(Palette) + kObjectMemory))
                addLight(shape, glow->second);
        });
    }

    void addLight(LevelShape& shape, const Glow& glow) {
        LightGroup group;
        group.name = shape.name;
        group.initialVoxels = glow.voxels;
        m_level.lightGroups.push_back(group);
        auto palette = std::make_shared<Palette>(*m_palette);
        for (PaletteEntry& entry : *palette)
            if (entry.emission > 0.0f) entry.lightGroup = uint32_t(m_level.lightGroups.size());
        shape.palette = palette;

        LevelLight light;
        light.shapeName = shape.name;
        light.groupName = group.name;
        light.light.name = shape.name + " light";
        light.light.local.position = glow.center * m_settings.voxelSize;
        const double radius =
            std::min(0.5 * m_settings.voxelSize * std::sqrt(double(glow.voxels)), 5.0 * m_settings.voxelSize);
        light.light.radius = float(radius);
        light.light.color =
            glm::vec3(glow.radiance * (kPi * radius * radius));  // intensity = radiance * projected area
        clampToRanges(light.light);
        m_level.lights.push_back(light);
        addLine(fmt::format("'{}': {} glowing voxels -> light group '{}' with a sphere light", shape.name, glow.voxels,
                            group.name));
    }

    void addCameras() {
        for (const auto& [id, attributes] : m_file.cameras) {
            const auto focus = attributes.find("_focus");
            glm::dvec3 at(0.0);
            if (focus != attributes.end()) std::sscanf(focus->second.c_str(), "%lf %lf %lf", &at.x, &at.y, &at.z);
            if (!(std::abs(at.x) < 1e7 && std::abs(at.y) < 1e7 && std::abs(at.z) < 1e7)) continue;
            Pose pose;
            pose.position = glm::dvec3(at.x, at.z, -at.y) * m_settings.voxelSize;
            m_level.locations.emplace_back(fmt::format("camera {}", id), pose);
        }
        if (!m_file.cameras.empty())
            addLine(fmt::format("{} cameras -> locations at what they look at", m_file.cameras.size()));
    }

    void reportIgnored(const std::vector<VoxInstance>& instances) {
        std::set<int> placed;
        for (const VoxInstance& instance : instances) placed.insert(instance.model);
        for (int i = 0; i < int(m_file.models.size()); ++i)
            if (!placed.contains(i)) addLine(fmt::format("model {}: no object of the scene uses it, left out", i));
        if (m_file.defaultColors) addLine("no RGBA chunk: MagicaVoxel's default colours");
        if (m_file.indexMap) addLine("IMAP: entries are numbered as MagicaVoxel shows them");
        if (!m_file.renderSettings.empty())
            addLine(fmt::format("{} render settings (rOBJ): left out, the level has its own sun and sky",
                                m_file.renderSettings.size()));
        int named = 0;
        for (const std::string& note : m_file.colorNotes) named += note.empty() ? 0 : 1;
        if (named) addLine(fmt::format("{} names of colour rows (NOTE): left out", named));
        for (const auto& [kind, count] : m_file.skippedChunks)
            addLine(fmt::format("{} {} chunks: unknown kind, left out", count, kind));
        for (const std::string& warning : m_file.warnings) addLine(warning);
    }

    const VoxFile& m_file;
    const std::string m_stem;
    const VoxImportSettings& m_settings;
    ImportReport& m_report;
    const std::array<uint8_t, 256> m_slots;
    std::map<std::tuple<int, std::array<uint8_t, 3>, std::array<int8_t, 3>>, RotatedModel> m_rotated;
    std::vector<const RotatedModel*> m_shapeModels;  ///< of all shapes, in their order
    UniqueNames m_names;
    PaletteRef m_palette;
    MemoryBudget m_budget;
    uint64_t m_nodes = 0;  ///< of all grids' directories
    std::string m_error;
    Level m_level;
};

}  // namespace

Result<Level> importVoxBytes(std::span<const uint8_t> bytes, const std::string& name, const VoxImportSettings& settings,
                             ImportReport* report) {
    if (!isWithin(double(float(settings.voxelSize)), ranges::kVoxelSize))
        return Error{fmt::format("{}: expected a voxel size of {} to {} m, found {}", name, ranges::kVoxelSize.low,
                                 ranges::kVoxelSize.high, settings.voxelSize)};
    Result<VoxFile> file = parseVox(bytes, name);
    if (!file) return Error{file.error()};
    Result<std::vector<VoxInstance>> instances = voxInstances(*file, name);
    if (!instances) return Error{instances.error()};
    ImportReport unused;
    const std::string stem = printableName(std::filesystem::path(name).stem().string());
    Result<Level> level =
        Importer(*file, stem, settings, MemoryBudget(bytes.size()), report ? *report : unused).run(*instances);
    if (!level) return Error{name + ": " + level.error()};
    return level;
}

Result<Level> importVox(const std::string& path, const VoxImportSettings& settings, ImportReport* report) {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxVoxFileBytes);
    if (!bytes) return Error{bytes.error()};
    try {
        return importVoxBytes(*bytes, path, settings, report);
    } catch (const std::bad_alloc&) {
        return Error{path + ": not enough memory for what it describes"};
    }
}

}  // namespace rubble
