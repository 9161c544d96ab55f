#include "runtime/assets/vox_import.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <new>
#include <set>
#include <tuple>

#include "runtime/assets/file_bytes.h"
#include "runtime/assets/names.h"
#include "runtime/assets/vox_palette.h"
#include "runtime/assets/vox_scene.h"
#include "runtime/core/constants.h"

namespace rubble {
namespace {

constexpr uint64_t kMaxVoxFileBytes = uint64_t(1) << 30;  // larger files are refused
// MagicaVoxel: z up, y away from the viewer. Rubble: y up, z towards the viewer.
constexpr VoxTransform kZUpToYUp{{0, 2, 1}, {1, 1, -1}, {}};

/// A model in the orientation of an instance, in the smallest grid that holds its voxels.
struct RotatedModel {
    VoxelGrid grid;
    std::array<int64_t, 3> low{};  ///< cell 0 of the grid, relative to the transform's offset
};

/// `slots`: the palette index for each stored colour index; 0 for those that are empty.
RotatedModel rotateModel(const VoxModel& model, const VoxTransform& rotation, const std::array<uint8_t, 256>& slots) {
    const glm::ivec3 pivot = model.size / 2;
    // Cell v spans [v - pivot, v + 1 - pivot] along its axis; a negative sign mirrors that interval.
    const auto rotated = [&](const std::array<uint8_t, 4>& voxel) {
        glm::ivec3 cell;
        for (int i = 0; i < 3; ++i) {
            const int from = rotation.axis[size_t(i)];
            const int corner = int(voxel[size_t(from)]) - pivot[from];
            cell[i] = rotation.sign[size_t(i)] > 0 ? corner : -corner - 1;
        }
        return cell;
    };
    RotatedModel out;
    glm::ivec3 low(INT32_MAX), high(INT32_MIN);
    for (const auto& voxel : model.voxels) {
        if (slots[voxel[3]] == 0) continue;
        low = glm::min(low, rotated(voxel));
        high = glm::max(high, rotated(voxel));
    }
    if (low.x > high.x) return out;
    out.low = {low.x, low.y, low.z};
    out.grid = VoxelGrid(high - low + 1);
    GridWriter writer(out.grid);
    for (const auto& voxel : model.voxels)
        if (slots[voxel[3]] != 0) writer.set(rotated(voxel) - low, slots[voxel[3]]);
    writer.flush();
    return out;
}

std::array<uint64_t, 256> countEntries(const VoxelGrid& grid) {
    std::array<uint64_t, 256> counts{};
    grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) {
        forEachVoxel(brick->occupancy, [&](int i) { ++counts[brick->at(i)]; });
    });
    return counts;
}

/// Turns one parsed file into a level: an object of the scene becomes a shape, glowing voxels become light groups,
/// cameras become locations. Every decision is a line of the report.
class Importer {
public:
    Importer(const VoxFile& file, const std::string& stem, const VoxImportSettings& settings, ImportReport& report)
        : m_file(file), m_stem(stem), m_settings(settings), m_report(report), m_slots(voxPaletteSlots(file)) {}

    Level run(const std::vector<VoxInstance>& instances) {
        m_level.name = m_stem;
        m_report.models = int(m_file.models.size());
        for (const VoxInstance& instance : instances) addObject(instance);
        choosePalette();
        addLights();
        addCameras();
        reportIgnored(instances);
        return std::move(m_level);
    }

private:
    void addLine(std::string line) { m_report.lines.push_back(std::move(line)); }

    void addObject(const VoxInstance& instance) {
        const VoxTransform transform = kZUpToYUp * instance.transform;
        const auto key = std::tuple(instance.model, transform.axis, transform.sign);
        auto found = m_rotated.find(key);
        if (found == m_rotated.end())
            found =
                m_rotated.emplace(key, rotateModel(m_file.models[size_t(instance.model)], transform, m_slots)).first;
        const RotatedModel& rotated = found->second;
        if (rotated.grid.empty()) return addLine(fmt::format("model {}: no voxels, left out", instance.model));

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
        forEachShape([&](LevelShape& shape) {
            const auto own = countEntries(shape.grid);
            for (size_t i = 1; i < 256; ++i) counts[i] += own[i];
        });
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
        forEachShape([&](LevelShape& shape) {
            glm::dvec3 sum(0.0), radiance(0.0);
            uint64_t count = 0;
            shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef& content) {
                forEachVoxel(content->occupancy, [&](int i) {
                    const PaletteEntry& entry = (*m_palette)[content->at(i)];
                    if (entry.emission <= 0.0f) return;
                    sum += glm::dvec3(brick * kBrickSize + voxelInBrick(i)) + 0.5;
                    radiance += double(entry.emission) * glm::dvec3(srgbToLinear(entry.red), srgbToLinear(entry.green),
                                                                    srgbToLinear(entry.blue));
                    ++count;
                });
            });
            if (count == 0 || shape.hidden) return;
            addLight(shape, sum / double(count), radiance / double(count), count);
        });
    }

    /// centerCells: centroid in cells of the grid. radiance: mean of the glowing voxels, linear.
    void addLight(LevelShape& shape, glm::dvec3 centerCells, glm::dvec3 radiance, uint64_t count) {
        LightGroup group;
        group.name = shape.name;
        group.initialVoxels = count;
        m_level.lightGroups.push_back(group);
        auto palette = std::make_shared<Palette>(*m_palette);
        for (PaletteEntry& entry : *palette)
            if (entry.emission > 0.0f) entry.lightGroup = uint32_t(m_level.lightGroups.size());
        shape.palette = palette;

        LevelLight light;
        light.shapeName = shape.name;
        light.groupName = group.name;
        light.light.name = shape.name + " light";
        light.light.local.position = centerCells * m_settings.voxelSize;
        const double radius =
            std::min(0.5 * m_settings.voxelSize * std::sqrt(double(count)), 5.0 * m_settings.voxelSize);
        light.light.radius = float(radius);
        light.light.color = glm::vec3(radiance * (kPi * radius * radius));  // intensity = radiance * projected area
        m_level.lights.push_back(light);
        addLine(fmt::format("'{}': {} glowing voxels -> light group '{}' with a sphere light", shape.name, count,
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
    UniqueNames m_names;
    PaletteRef m_palette;
    Level m_level;
};

}  // namespace

Result<Level> importVoxBytes(std::span<const uint8_t> bytes, const std::string& name, const VoxImportSettings& settings,
                             ImportReport* report) {
    if (!(settings.voxelSize > 0.0 && settings.voxelSize < 1000.0))
        return Error{fmt::format("{}: expected a voxel size between 0 and 1000 m, found {}", name, settings.voxelSize)};
    Result<VoxFile> file = parseVox(bytes, name);
    if (!file) return Error{file.error()};
    Result<std::vector<VoxInstance>> instances = voxInstances(*file, name);
    if (!instances) return Error{instances.error()};
    ImportReport unused;
    const std::string stem = printableName(std::filesystem::path(name).stem().string());
    return Importer(*file, stem, settings, report ? *report : unused).run(*instances);
}

Result<Level> importVox(const std::string& path, const VoxImportSettings& settings, ImportReport* report) try {
    const Result<std::vector<uint8_t>> bytes = readFileBytes(path, kMaxVoxFileBytes);
    if (!bytes) return Error{bytes.error()};
    return importVoxBytes(*bytes, path, settings, report);
} catch (const std::bad_alloc&) {
    return Error{path + ": not enough memory for what it describes"};
}

}  // namespace rubble
