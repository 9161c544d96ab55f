// Shapes that remember the file that they came from: see reloadModel().
#include "editor/core/models.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iterator>
#include <map>
#include <optional>
#include <set>

#include "editor/core/child_process.h"
#include "editor/core/joints.h"
#include "editor/core/model_links.h"
#include "editor/core/palette.h"
#include "editor/core/rotation.h"
#include "editor/core/round_shapes.h"
#include "editor/core/vdb_tool.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

/// Where a cell's corner is, in metres of the world.
glm::dvec3 cornerOf(const rubble_shape_state& shape, glm::ivec3 cell) {
    return vectorOf(shape.position) + quaternionOf(shape.rotation) * (glm::dvec3(cell) * shape.voxel_size);
}
/// The cell that has its corner at a place.
glm::ivec3 cellAt(const rubble_shape_state& shape, glm::dvec3 corner) {
    const glm::dvec3 local = glm::inverse(quaternionOf(shape.rotation)) * (corner - vectorOf(shape.position));
    return glm::ivec3(glm::round(local / shape.voxel_size));
}
/// The same place in the frame of the shape's body, and back.
glm::dvec3 toBody(const rubble_body_state& body, glm::dvec3 place) {
    return glm::inverse(quaternionOf(body.rotation)) * (place - vectorOf(body.position));
}
glm::dvec3 fromBody(const rubble_body_state& body, glm::dvec3 place) {
    return vectorOf(body.position) + quaternionOf(body.rotation) * place;
}

/// What a file holds now, in a world of its own with the materials of the level.
class ModelFile {
public:
    struct Part {
        rubble_shape shape;
        std::string name;
    };

    ModelFile(const rubble::World& level, const ModelSource& source, const std::string& vdbTool)
        : m_world(rubble_world_settings{.flags = RUBBLE_WORLD_NO_RENDERER}) {
        std::vector<rubble_material> materials;
        for (uint32_t i = 1; i < level.get_material_count(); ++i) materials.push_back(level.get_material(i));
        m_world.set_materials(1, materials);
        m_world.apply_edits();
        std::vector<std::string> report;
        std::vector<rubble_prefab_row> rows;
        try {
            rows = placeModel(m_world, source, vdbTool, {}, report);
        } catch (const std::exception& error) {
            throw UnreadableModel(error.what());
        }
        m_world.apply_edits();
        for (const rubble_prefab_row& row : rows)
            if (row.kind == RUBBLE_PREFAB_SHAPE) m_parts.push_back({row.handle, nameOf(m_world, row.handle)});
    }

    const rubble::World& world() const { return m_world; }
    /// The shape that a link means: that of its name, of several the one of its number. 0: it is gone.
    rubble_shape find(const ModelLink& link) const {
        if (link.number < m_parts.size() && m_parts[link.number].name == link.name) return m_parts[link.number].shape;
        const auto found = std::ranges::find(m_parts, link.name, &Part::name);
        return link.name.empty() || found == m_parts.end() ? 0 : found->shape;
    }
    const Content& content(rubble_shape shape) {
        const auto [at, isNew] = m_contents.try_emplace(shape);
        if (isNew) at->second = contentOf(m_world, shape);
        return at->second;
    }

private:
    rubble::World m_world;
    std::vector<Part> m_parts;
    std::map<rubble_shape, Content> m_contents;
};

/// Brings one shape up to date.
class ShapeUpdate {
public:
    ShapeUpdate(Editor& editor, ModelFile& file, rubble_shape shape, const ModelLink& link, rubble_shape part)
        : m_editor(editor), m_file(file), m_shape(shape), m_link(link), m_part(part) {
        const rubble_shape_state there = file.world().get_shape_state(part);
        m_content = file.content(part);
        m_next = link;
        m_next.hash = m_content.hash;
        m_next.place = cornerOf(there, m_content.solid.low), m_next.turn = quaternionOf(there.rotation);
        if (std::abs(glm::dot(m_next.turn, link.turn)) > 1.0 - 1e-9) {
            m_moved = glm::ivec3(glm::round(glm::inverse(link.turn) * (m_next.place - link.place) / there.voxel_size));
            // the place that it gets: what is less than a cell counts in the next update
            m_next.place = link.place + link.turn * (glm::dvec3(m_moved) * there.voxel_size);
        }
        m_hasOtherVoxels =
            std::abs(there.voxel_size - editor.world().get_shape_state(shape).voxel_size) > 1e-6 * there.voxel_size;
    }

    bool hasOtherVoxels() const { return m_hasOtherVoxels; }
    /// Whether the file says something else than came in.
    bool isNeeded() const { return m_content.hash != m_link.hash || m_moved != glm::ivec3(0); }
    /// Whether the shape is no longer what came in.
    bool isEdited() {
        const Content present = contentOf(m_editor.world(), m_shape);
        m_solid = present.solid;
        return m_editor.world().get_shape_properties(m_shape).is_piece || present.hash != m_link.hash;
    }

    /// After isEdited().
    void apply() {
        rubble::World& world = m_editor.world();
        const bool wasHeld = world.get_shape_properties(m_shape).anchor_count > 0;
        const rubble_shape_state before = world.get_shape_state(m_shape);
        const rubble_body_state body = world.get_body_state(before.body);
        const glm::ivec3 first = cellAt(before, fromBody(body, m_link.corner)) + m_moved;
        m_next.corner = toBody(body, cornerOf(before, first));
        const Cells grid = gridOf(world, m_shape);
        const Cells target{first - m_content.solid.low, gridOf(m_file.world(), m_part).size};
        const glm::dvec3 middle = middleOf(before, m_solid);
        const std::vector<KeptJoint> joints = jointsOf(middle);
        setPalette();
        write(grid, target);
        m_editor.document().applyNow();
        rubble_resize resize{};
        resize.shape = m_shape;
        const Cells grown = joined(grid, target);
        for (int a = 0; a < 3; ++a) resize.low[a] = target.low[a] - grown.low[a], resize.size[a] = target.size[a];
        world.resize_shape(resize);
        m_editor.document().applyNow();
        if (wasHeld && world.get_shape_properties(m_shape).anchor_count == 0) {
            rubble_shape_change change{};
            change.shape = m_shape, change.fields = RUBBLE_SHAPE_DEFAULT_ANCHORS;
            world.set_shape(change);
        }
        setLink(world, m_shape, m_next);
        m_editor.document().applyNow();
        const glm::dvec3 shift = middleOf(before, {first, m_content.solid.size}) - middle;
        for (const KeptJoint& each : joints) keep(each, each.isAxle ? shift : glm::dvec3(0.0));
    }

    std::vector<std::string> lostJoints;  ///< by apply()

private:
    struct KeptJoint {
        rubble_joint handle;
        std::string name;
        std::optional<JointCopy> copy;  ///< none: it cannot be made again
        bool isAxle = false;            ///< of a wheel, through the middle of this shape
    };

    /// Where the middle of cells is, in metres of the world.
    static glm::dvec3 middleOf(const rubble_shape_state& shape, const Cells& cells) {
        return (cornerOf(shape, cells.low) + cornerOf(shape, cells.low + cells.size)) * 0.5;
    }
    bool isAxle(const rubble_joint_settings& joint, glm::dvec3 middle) const {
        const glm::dvec3 axis = quaternionOf(joint.rotation) * glm::dvec3(1.0, 0.0, 0.0);
        const double off = glm::length(glm::cross(axis, vectorOf(joint.position) - middle));
        return joint.kind == RUBBLE_JOINT_WHEEL && joint.shapes[1] == m_shape &&
               off < 0.5 * m_editor.world().get_shape_state(m_shape).voxel_size;
    }
    std::vector<KeptJoint> jointsOf(glm::dvec3 middle) const {
        const rubble::World& world = m_editor.world();
        std::vector<KeptJoint> joints;
        for (const rubble_joint each : world.get_objects_of(m_shape, RUBBLE_KIND_JOINT)) {
            KeptJoint& joint = joints.emplace_back(each, shownName(world, each));
            if (!hasFrame(world, each)) continue;
            joint.copy = copyOf(world, each);
            joint.isAxle = isAxle(joint.copy->settings, middle) && !isLocked(world, each);
        }
        return joints;
    }
    /// A joint whose voxel is gone holds on to another one in its reach, if there is one; an axle moves by so much.
    void keep(const KeptJoint& joint, glm::dvec3 shift) {
        rubble::World& world = m_editor.world();
        const bool isMoved = glm::length(shift) > 1e-6, isAlive = kindOf(world, joint.handle) >= 0;
        if (isAlive && !isMoved) return;
        if (isAlive) world.remove_joint(joint.handle);
        if (!makeAgain(joint, shift, 0.0) && !(isMoved && makeAgain(joint, shift, glm::length(shift))))
            lostJoints.push_back(joint.name);
    }
    /// wider: metres by which it looks farther for its voxels. False: there are none.
    bool makeAgain(const KeptJoint& joint, glm::dvec3 shift, double wider) {
        if (!joint.copy) return false;
        rubble_joint_settings settings = joint.copy->settings;
        put(settings.position, vectorOf(settings.position) + shift);
        settings.anchor_radius += wider;
        const rubble_joint made = m_editor.world().create_joint(settings);
        if (!m_editor.document().applyNow(true)) return false;
        nameJoint(m_editor.world(), made, *joint.copy);
        std::ranges::replace(m_editor.selection().objects, joint.handle, made);
        return true;
    }

    void setPalette() {
        std::vector<rubble_palette_entry> entries = m_file.world().get_palette(paletteRange(m_part, 1, 255));
        m_editor.world().set_palette(paletteRange(m_shape, 1, 255), entries.data());
    }

    void write(const Cells& grid, const Cells& target) {
        const Cells all = gridOf(m_file.world(), m_part);
        const std::vector<uint8_t> voxels = readCells(m_file.world(), m_part, all);
        const CellSet places{m_part, all.low, all.size, {}};
        CellWriter writer(m_editor.world(), m_shape);
        writer.makeRoom(target);
        writer.write(joined(grid, target), [&](glm::ivec3 cell, uint8_t) {
            return target.contains(cell) ? voxels[places.at(cell - target.low)] : uint8_t(0);
        });
    }

    Editor& m_editor;
    ModelFile& m_file;
    rubble_shape m_shape;
    ModelLink m_link, m_next;
    rubble_shape m_part;    ///< in the file's world
    Content m_content;      ///< of that
    Cells m_solid;          ///< of m_shape, as isEdited() has found it
    glm::ivec3 m_moved{0};  ///< cells by which the file's shape begins elsewhere
    bool m_hasOtherVoxels = false;
};

}  // namespace

std::vector<rubble_prefab_row> placeModel(rubble::World& world, const ModelSource& source, const std::string& vdbTool,
                                          const Place& place, std::vector<std::string>& report) {
    requireVdbTool(source.path, vdbTool);
    std::optional<ScratchFolder> folder;
    std::string path = source.path;
    if (isMeshFile(source.path)) {
        path = folder.emplace() / "mesh.rubble";
        report = bakeMesh(source.path, path, vdbTool, source.mesh);
    }
    rubble_prefab prefab{};
    prefab.path = path.c_str();
    prefab.vdb_tool = vdbTool.c_str();
    put(prefab.position, place.position);
    put(prefab.rotation, place.rotation);
    return world.create_prefab(prefab);
}

void linkModels(Editor& editor, const ModelSource& source, const Place& place,
                const std::vector<rubble_prefab_row>& rows) {
    editor.document().applyNow();
    rubble::World& world = editor.world();
    const glm::dquat back = glm::inverse(place.rotation);
    ModelLink link{.file = relativeTo(folderOfLinks(editor.document().path()), source.path), .mesh = source.mesh};
    link.fileHash = hashOfFile(source.path);
    for (const rubble_prefab_row& row : rows) {
        if (row.kind != RUBBLE_PREFAB_SHAPE) continue;
        if (const int64_t cells = gridOf(world, row.handle).count(); cells <= kMaxCells) {
            const rubble_shape_state shape = world.get_shape_state(row.handle);
            const Content content = contentOf(world, row.handle);
            const glm::dvec3 corner = cornerOf(shape, content.solid.low);
            link.name = nameOf(world, row.handle);
            link.hash = content.hash;
            link.place = back * (corner - place.position), link.turn = back * quaternionOf(shape.rotation);
            link.corner = toBody(world.get_body_state(shape.body), corner);
            setLink(world, row.handle, link);
        } else {
            editor.say(fmt::format("{}: its grid of {} cells is too large to stay linked to the file",
                                   shownName(world, row.handle), cells));
        }
        ++link.number;
    }
}

size_t unlinkModels(rubble::World& world, const std::vector<rubble_shape>& shapes) {
    size_t count = 0;
    for (const rubble_shape shape : shapes) {
        count += isLinked(world, shape);
        removeLink(world, shape);
    }
    return count;
}

bool isLinked(const rubble::World& world, rubble_shape shape) {
    return linkOf(world, shape).has_value();
}

std::vector<std::string> linkedFiles(const rubble::World& world) {
    std::set<std::string> files;
    for (const rubble_shape shape : world.find_by_tag(RUBBLE_KIND_SHAPE, kModelTag, nullptr))
        if (const std::optional<ModelLink> link = linkOf(world, shape)) files.insert(link->file);
    return {files.begin(), files.end()};
}

std::string listOf(const std::vector<std::string>& names) {
    constexpr size_t kMaxListed = 8;
    std::string all;
    for (size_t i = 0; i < std::min(names.size(), kMaxListed); ++i) all += (i ? ", " : "") + names[i];
    return all + (names.size() > kMaxListed ? ", ..." : "");
}

ChangedFiles changedFiles(const Document& document) {
    const rubble::World& world = document.world();
    std::map<std::string, uint64_t> hashes;
    for (const std::string& file : linkedFiles(world)) hashes[file] = hashOfFile(modelPath(document, file));
    std::set<std::string> changed;
    for (const rubble_shape shape : world.find_by_tag(RUBBLE_KIND_SHAPE, kModelTag, nullptr)) {
        const std::optional<ModelLink> link = linkOf(world, shape);
        if (!link || !link->fileHash || isLocked(world, shape)) continue;
        const uint64_t now = hashes[link->file];
        if (now && now != link->fileHash) changed.insert(link->file);
    }
    ChangedFiles files{.changed = {changed.begin(), changed.end()}};
    for (const auto& [file, hash] : hashes)
        if (!hash) files.unreadable.push_back(file);
    return files;
}

std::string modelPath(const Document& document, const std::string& file) {
    return (folderOfLinks(document.path()) / file).lexically_normal().string();
}

bool moveLinks(Document& document, const std::string& levelPath) {
    const fs::path from = folderOfLinks(document.path()), to = folderOfLinks(levelPath);
    rubble::World& world = document.world();
    if (from == to || linkedFiles(world).empty()) return false;
    const size_t steps = document.done().size();
    document.edit("paths of models from " + levelPath, [&] {
        for (const rubble_shape shape : world.find_by_tag(RUBBLE_KIND_SHAPE, kModelTag, nullptr))
            if (std::optional<ModelLink> link = linkOf(world, shape)) {
                link->file = relativeTo(to, modelPath(document, link->file));
                setLink(world, shape, *link);
            }
    });
    return document.done().size() > steps;
}

std::vector<LinkedShapes> linkedShapes(const Document& document, const std::vector<rubble_shape>& shapes) {
    const rubble::World& world = document.world();
    std::map<std::string, LinkedShapes> groups;  // by file and how it was read
    for (const rubble_shape shape : shapes) {
        const std::optional<ModelLink> link = linkOf(world, shape);
        if (!link) continue;
        const MeshOptions& mesh = link->mesh;
        LinkedShapes& group = groups[fmt::format("{}\n{} {} {} {} {}", link->file, mesh.voxels, mesh.voxel, mesh.shell,
                                                 mesh.isZUp, mesh.isSmooth)];
        group.file = link->file;
        group.source = {modelPath(document, link->file), mesh};
        group.shapes.push_back(shape);
    }
    std::vector<LinkedShapes> all;
    for (auto& [key, group] : groups) all.push_back(std::move(group));
    return all;
}

ModelReport reloadModel(Editor& editor, const LinkedShapes& linked, bool reverts) {
    rubble::World& world = editor.world();
    ModelFile file(world, linked.source, editor.settings().vdbTool);
    ModelReport report;
    std::vector<rubble_shape> updated;
    const uint64_t hash = hashOfFile(linked.source.path);
    for (const rubble_shape shape : linked.shapes) {
        const std::string name = shownName(world, shape);
        ModelLink link = *linkOf(world, shape);
        if (hash != link.fileHash && !isLocked(world, shape)) {
            link.fileHash = hash;
            setLink(world, shape, link);
        }
        const rubble_shape part = file.find(link);
        if (!part) {
            report.gone.push_back(name);
            continue;
        }
        ShapeUpdate update(editor, file, shape, link, part);
        const bool isEdited = (reverts || update.isNeeded()) && update.isEdited();
        if (isLocked(world, shape) && (isEdited || update.isNeeded()))
            report.locked.push_back(name);
        else if (update.hasOtherVoxels())
            report.otherVoxels.push_back(name);
        else if (isEdited && (!reverts || world.get_shape_properties(shape).is_piece))
            report.kept.push_back(name);
        else if (isEdited || update.isNeeded())
            update.apply(), updated.push_back(shape);
        else
            ++report.equal;
        std::ranges::move(update.lostJoints, std::back_inserter(report.lostJoints));
    }
    for (const rubble_shape shape : updated)
        if (!isTouchedAs(world, shape, world.get_shape_properties(shape).collision_shape))
            report.notRound.push_back(shownName(world, shape));
    report.updated = updated.size();
    return report;
}

}  // namespace editor
