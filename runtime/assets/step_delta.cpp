#include "runtime/assets/step_delta.h"

#include <algorithm>
#include <glm/vector_relational.hpp>
#include <optional>
#include <set>
#include <type_traits>

#include "runtime/assets/binary_archive.h"
#include "runtime/assets/level_bytes.h"
#include "runtime/assets/level_validation.h"
#include "runtime/assets/state_fields.h"
#include "runtime/core/range_check.h"
#include "runtime/core/ranges.h"
#include "runtime/voxel/mass_properties.h"
#include "runtime/world/objects/joint_attachment.h"
#include "runtime/world/objects/object_errors.h"
#include "runtime/world/settings/settings_error.h"

namespace rubble {
namespace {

/// Removed; with a grid from here on; or the grid before with some bricks changed.
enum class ShapeKind : uint8_t { Gone, New, Changed };
/// Empty; the brick of the source; that brick masked to fewer voxels; or new content.
enum class BrickKind : uint8_t { Empty, Whole, Masked, Full };
constexpr uint32_t kNoSource = ~0u;

/// The grid that a shape's bricks are taken from: its own before the step, or that of the shape which it came off.
struct Source {
    uint32_t slot = kNoSource;
    glm::ivec3 offset{0};  ///< in bricks: a position in the source minus that in the shape
    const VoxelGrid* grid = nullptr;
    /// The source's brick for a position in the shape; null outside and where there is none.
    BrickRef brick(glm::ivec3 position) const {
        position += offset;
        const bool isInside = grid && glm::all(glm::greaterThanEqual(position, glm::ivec3(0))) &&
                              glm::all(glm::lessThan(position, grid->sizeInBricks()));
        return isInside ? grid->shareBrick(position) : nullptr;
    }
};

/// Where the bricks of a new shape come from, by the splits of the step; none if it came off nothing.
Source findSource(ShapeHandle shape, const WorldDelta& before, const FrameChanges& changes) {
    for (const ShapeSplit& split : changes.splits)
        for (size_t i = 0; i < split.children.size(); ++i) {
            const auto parent = before.shapes.find(split.parent.slot());
            if (split.children[i] != shape || parent == before.shapes.end() || parent->second.first != split.parent)
                continue;
            return {split.parent.slot(), split.parentOffset[i] / kBrickSize, &parent->second.second->grid};
        }
    return {};
}

/// Writes a brick in the fewest bytes: as its source, as a mask of it, or in full.
void putBrick(BinaryOutputArchive& out, std::vector<uint8_t>& bytes, glm::ivec3 position, const Brick* brick,
              const BrickRef& source) {
    if (brick && source) {
        const BrickRef masked = maskBrick(*source, brick->occupancy);
        if (masked && masked->occupancy == brick->occupancy && hashBrick(*masked) == hashBrick(*brick)) {
            const bool isWhole = source->occupancy == brick->occupancy;
            out.put(isWhole ? BrickKind::Whole : BrickKind::Masked);
            for (int i = 0; i < 3; ++i) out.put(uint16_t(position[i]));
            if (!isWhole) out.put(brick->occupancy);
            return;
        }
    }
    out.put(brick ? BrickKind::Full : BrickKind::Empty);
    if (brick) return appendBrick(bytes, position, *brick);
    for (int i = 0; i < 3; ++i) out.put(uint16_t(position[i]));
}

void putShape(BinaryOutputArchive& out, std::vector<uint8_t>& bytes, uint32_t slot, const WorldDelta& before,
              const FrameChanges& changes, const World& after) {
    const auto& [wasHandle, was] = before.shapes.at(slot);
    const ShapeHandle handle = after.shapes().handleAt(slot);
    out.put(slot);
    if (!handle) return out.put(ShapeKind::Gone);
    const Shape& shape = after.shapes().at(handle);
    const bool isChanged = handle == wasHandle && was->grid.size() == shape.grid.size();
    const Source source = isChanged ? Source{slot, {}, &was->grid} : findSource(handle, before, changes);
    out.put(isChanged ? ShapeKind::Changed : ShapeKind::New);
    out.put(handle);
    out.put(shape);
    out.put(source.slot);
    out.put(source.offset);
    std::vector<glm::ivec3> bricks;
    if (isChanged)
        shape.grid.forEachUnshared(was->grid, [&](glm::ivec3 brick) { bricks.push_back(brick); });
    else
        shape.grid.forEachBrick([&](glm::ivec3 brick, const BrickRef&) { bricks.push_back(brick); });
    out.put(uint32_t(bricks.size()));
    for (const glm::ivec3 brick : bricks) putBrick(out, bytes, brick, shape.grid.brickAt(brick), source.brick(brick));
}

template <class Map, class Handle, class T>
void putValues(BinaryOutputArchive& out, const SlotValues<Handle, T>& before, const Map& after) {
    out.put(uint32_t(before.size()));
    for (const auto& [slot, was] : before) {
        const Handle handle = after.handleAt(slot);
        out.put(slot);
        out.put(handle);
        if (handle) out.put(after.at(handle));
    }
}

/// Whether a container of SlotValues holds the objects that `Handle` names. One kind differs in forEachKind(): shapes
/// are written brick by brick.
template <class Handle, class Values>
constexpr bool kIsOf = std::is_same_v<typename std::decay_t<Values>::mapped_type::first_type, Handle>;

/// Reads a delta for the World that it starts from.
class StepReader {
public:
    StepReader(ByteReader& reader, const std::vector<PaletteRef>& palettes, const World& world)
        : m_reader(reader), m_in(reader, palettes, world.id()), m_world(world) {}

    WorldDelta read() {
        WorldDelta delta;
        m_in.get(delta.imported);
        m_in.get(delta.removed);
        m_in.get(delta.made);
        forEachKind(
            [&](auto& values) {
                if constexpr (!kIsOf<ShapeHandle, decltype(values)>) readValues(values);
            },
            delta);
        bool hasEnvironment = false;
        m_in.get(hasEnvironment);
        if (hasEnvironment) m_in.get(delta.environment.emplace());
        bool hasMaterials = false;
        m_in.get(hasMaterials);
        if (hasMaterials) m_in.get(delta.materials.emplace().materials);
        bool hasSettings = false;
        m_in.get(hasSettings);
        if (hasSettings) m_in.get(delta.settings.emplace());
        for (uint32_t i = m_reader.readCount(5, "shapes");
             i-- > 0 && m_reader.takeMemory(listMemory(1, sizeof(Shape)));)
            readShape(delta);
        forEachKind([&](auto&, auto& free) { m_in.get(free); }, delta, delta.freeSlots);
        if (m_reader.remaining()) m_in.get(delta.scripts.emplace());
        if (delta.scripts == m_world.data().scripts) delta.scripts.reset();
        delta.footprint = m_world.data().footprint;
        if (m_reader.remaining()) m_in.get(delta.footprint);
        return delta;
    }

private:
    uint32_t readSlot() {
        const auto slot = m_reader.read<uint32_t>();
        if (slot > 0xffffffu) m_reader.fail("a slot below 2^24", std::to_string(slot), m_reader.offset() - 4);
        return slot;
    }
    template <class Handle, class T>
    void readValues(SlotValues<Handle, T>& out) {
        for (uint32_t i = m_reader.readCount(12, "objects");
             i-- > 0 && m_reader.takeMemory(listMemory(1, sizeof(typename SlotValues<Handle, T>::value_type)));) {
            const uint32_t slot = readSlot();
            auto& value = out[slot];
            m_in.get(value.first);
            if (value.first && value.first.slot() != slot) m_reader.fail("a handle of its own slot", "another");
            if (value.first) m_in.get(value.second.emplace());
        }
    }
    void readShape(WorldDelta& delta) {
        const uint32_t slot = readSlot();
        const auto kind = m_reader.read<ShapeKind>();
        auto& [handle, value] = delta.shapes[slot];
        if (kind == ShapeKind::Gone) return;
        Shape shape;
        m_in.get(handle);
        m_in.get(shape);
        Source source;
        m_in.get(source.slot);
        m_in.get(source.offset);
        const Shape* from = m_world.shapes().find(m_world.shapes().handleAt(source.slot));
        if (from) source.grid = &from->grid;
        const bool isChanged = kind == ShapeKind::Changed;
        if (kind > ShapeKind::Changed || !handle || handle.slot() != slot || shape.grid.size() == glm::ivec3(0) ||
            (source.slot != kNoSource && !from) ||
            (isChanged &&
             (source.slot != slot || source.offset != glm::ivec3(0) || from->grid.size() != shape.grid.size())))
            return m_reader.fail("a shape that fits the world before the step", "another");
        if (isChanged) shape.grid = from->grid;
        if (!shape.palette) shape.palette = std::make_shared<const Palette>();
        if (from) keepEqual(shape.palette, from->palette), keepEqual(shape.paintColors, from->paintColors);
        const int colors = shape.paintColors ? shape.paintColors->count : 0;
        for (uint32_t i = m_reader.readCount(7, "bricks"); i-- > 0 && !m_reader.failed();)
            checkPaint(readBrickOf(shape.grid, source), colors);
        if (isChanged && from->paintColors && from->paintColors->count > colors)
            shape.grid.forEachBrick([&](glm::ivec3, const BrickRef& brick) { checkPaint(brick.get(), colors); });
        if (m_reader.failed()) return;
        const MaterialTable& materials = delta.materials ? *delta.materials : m_world.materials();
        shape.moments = gridMoments(shape.grid, *shape.palette, materials);
        shape.anchors = translatedBoxes(shape.anchors, glm::ivec3(0), shape.grid.size());
        value = std::move(shape);
    }
    /// Colours as they are are the same object: another one counts as a change of all voxels' looks.
    template <class T>
    static void keepEqual(std::shared_ptr<const T>& read, const std::shared_ptr<const T>& known) {
        if (read && known && *read == *known) read = known;
    }
    /// Fails if a brick has paint of another colour than the first so many.
    void checkPaint(const Brick* brick, int colors) {
        if (!brick || highestPaintColor(*brick) <= colors) return;
        m_reader.fail(fmt::format("paint of the {} colours that the shape has", colors),
                      fmt::format("colour {}", highestPaintColor(*brick)));
    }
    /// The brick that is there now; null if there is none.
    const Brick* readBrickOf(VoxelGrid& grid, const Source& source) {
        const auto kind = m_reader.read<BrickKind>();
        const auto position = kind == BrickKind::Full ? readFull(grid) : readBrickOfSource(grid, source, kind);
        return m_reader.failed() ? nullptr : grid.brickAt(position);
    }
    glm::ivec3 readBrickOfSource(VoxelGrid& grid, const Source& source, BrickKind kind) {
        const glm::ivec3 position = readPosition(m_reader);
        const glm::ivec3 bricks = grid.sizeInBricks();
        const BrickRef from = source.brick(position);
        const bool fits = position.x < bricks.x && position.y < bricks.y && position.z < bricks.z &&
                          (kind == BrickKind::Empty || from);
        if (kind > BrickKind::Full || !fits) m_reader.fail("a brick that the source has", "none there");
        if (m_reader.failed()) return position;
        BrickRef brick;
        if (kind != BrickKind::Empty)
            brick = kind == BrickKind::Whole ? from : maskBrick(*from, m_reader.read<BrickBits>());
        const glm::ivec3 remaining = grid.size() - position * kBrickSize;
        bool isInside = true;
        if (brick && glm::any(glm::lessThan(remaining, glm::ivec3(kBrickSize))))
            forEachVoxel(brick->occupancy,
                         [&](int i) { isInside = isInside && glm::all(glm::lessThan(voxelInBrick(i), remaining)); });
        if (!isInside) m_reader.fail("a brick inside the grid", "one with voxels outside");
        if (!m_reader.failed()) grid.setBrick(position, brick);
        return position;
    }
    /// New content replaces the brick that is there, which readBrick() alone refuses.
    glm::ivec3 readFull(VoxelGrid& grid) {
        ByteReader ahead = m_reader;
        const glm::ivec3 position = readPosition(ahead);
        if (grid.brickAt(position)) grid.setBrick(position, nullptr);
        readBrick(m_reader, grid);
        return position;
    }
    static glm::ivec3 readPosition(ByteReader& in) {
        glm::ivec3 position;
        for (int i = 0; i < 3; ++i) position[i] = in.read<uint16_t>();
        return position;
    }
    ByteReader& m_reader;
    BinaryInputArchive m_in;
    const World& m_world;
};

/// Checks what a World takes for granted of a delta from outside. Looks at objects as they will be after it: in the
/// delta if their slot changes, else in the World.
class DeltaCheck {
public:
    DeltaCheck(const WorldDelta& delta, const World& world) : m_delta(delta), m_world(world) {}

    /// Slots are given out without gaps: those below the highest are taken, or free and listed as such.
    bool namesKnownSlots() const {
        bool isKnown = true;
        forEachKind(
            [&](const auto& values, const auto& free, const auto& map) {
                isKnown = isKnown &&
                          (values.empty() || values.rbegin()->first < map.slotCount() + values.size() + free.size());
            },
            m_delta, m_delta.freeSlots, m_world.data());
        return isKnown;
    }
    bool isValid() const {
        return hasValidValues() && changesJointsOfRemovedShapes() && shapesAreOnTheirBodies() &&
               bodiesHaveTheirShapes() && notesHaveTheirObjects();
    }

private:
    const Shape* shapeAfter(ShapeHandle handle) const {
        if (!handle) return nullptr;
        const auto found = m_delta.shapes.find(handle.slot());
        if (found == m_delta.shapes.end()) return m_world.shapes().find(handle);
        return found->second.first == handle ? &*found->second.second : nullptr;
    }
    const Body* bodyAfter(BodyHandle handle) const {
        if (!handle) return nullptr;
        const auto found = m_delta.bodies.find(handle.slot());
        if (found == m_delta.bodies.end()) return m_world.bodies().find(handle);
        return found->second.first == handle ? &*found->second.second : nullptr;
    }
    /// Whether the shape's body lists it exactly once.
    bool isListed(ShapeHandle handle, const Shape& shape) const {
        const Body* body = bodyAfter(shape.body);
        return body && std::count(body->shapes.begin(), body->shapes.end(), handle) == 1;
    }
    bool isValidJoint(const Joint& joint) const {
        for (const JointEnd& end : joint.ends)
            if (end.shape && !shapeAfter(end.shape)) return false;
        const bool isRope = joint.kind == JointKind::Rope;
        return jointEndsError(joint).empty() &&
               jointBodiesError(joint.kind, shapeAfter(joint.ends[0].shape), shapeAfter(joint.ends[1].shape)).empty() &&
               joint.points.size() == (isRope ? joint.rope.points : 0) && (!isRope || !joint.points.empty());
    }
    bool hasValidValues() const {
        bool isValid = (!m_delta.environment || environmentError(*m_delta.environment).empty()) &&
                       (!m_delta.settings || settingsError(*m_delta.settings).empty()) &&
                       objectError(m_delta.made).empty() && objectError(m_delta.footprint).empty() &&
                       hasValidMaterials();
        forEachKind(
            [&](const auto& values) {
                for (const auto& [slot, value] : values)
                    isValid = isValid && (!value.first || objectError(*value.second).empty());
            },
            m_delta);
        for (const auto& [slot, value] : m_delta.joints)
            isValid = isValid && (!value.first || isValidJoint(*value.second));
        for (const auto& [slot, value] : m_delta.shapes)
            isValid = isValid && (!value.first || hasValidPalette(*value.second));
        return isValid;
    }
    static bool namesRowsOf(const Palette& palette, const std::vector<Material>& rows) {
        return std::all_of(palette.begin(), palette.end(),
                           [&](const PaletteEntry& entry) { return entry.material < rows.size(); });
    }
    /// Whether all rows are within their ranges, and none is gone that a palette names: an undo takes back rows that
    /// were added.
    bool hasValidMaterials() const {
        if (!m_delta.materials) return true;
        const std::vector<Material>& rows = m_delta.materials->materials;
        bool isNamed = true;
        if (rows.size() < m_world.materials().materials.size())
            m_world.shapes().forEach([&](ShapeHandle handle, const Shape& shape) {
                isNamed = isNamed && (m_delta.shapes.contains(handle.slot()) || namesRowsOf(*shape.palette, rows));
            });
        return isNamed && isWithin(double(rows.size()), ranges::kMaterials) &&
               std::all_of(rows.begin(), rows.end(), [](const Material& row) {
                   const std::string texts =
                       RangeCheck().text("name", row.name).text("fragments", row.fragments).error();
                   return texts.empty() && objectError(row).empty();
               });
    }
    /// Whether the entries are within their ranges and name materials and light groups that there are.
    bool hasValidPalette(const Shape& shape) const {
        const MaterialTable& materials = m_delta.materials ? *m_delta.materials : m_world.materials();
        const size_t made = m_delta.groups.empty() ? 0 : m_delta.groups.rbegin()->first + size_t(1);
        const size_t groups = std::max<size_t>(m_world.lightGroups().slotCount(), made);
        return std::all_of(shape.palette->begin(), shape.palette->end(), [&](const PaletteEntry& entry) {
            return objectError(entry).empty() && entry.material < materials.materials.size() &&
                   entry.lightGroup <= groups;
        });
    }
    bool changesJointsOfRemovedShapes() const {
        for (const auto& [slot, value] : m_delta.shapes) {
            const ShapeHandle was = m_world.shapes().handleAt(slot);
            if (!was || was == value.first) continue;
            for (const JointHandle joint : m_world.data().jointIndex.of(was))
                if (!m_delta.joints.contains(joint.slot())) return false;
        }
        return true;
    }
    /// Also that the body of a shape that goes, or moves to another one, is in the delta: it lists the shape no longer.
    bool shapesAreOnTheirBodies() const {
        for (const auto& [slot, value] : m_delta.shapes) {
            if (value.first && !isListed(value.first, *value.second)) return false;
            const ShapeHandle before = m_world.shapes().handleAt(slot);
            const Shape* was = m_world.shapes().find(before);
            const bool stays = was && value.first == before && value.second->body == was->body;
            if (was && !stays && !m_delta.bodies.contains(was->body.slot())) return false;
        }
        return true;
    }
    bool bodiesHaveTheirShapes() const {
        for (const auto& [slot, value] : m_delta.bodies) {
            if (value.first)
                for (const ShapeHandle shape : value.second->shapes) {
                    const Shape* after = shapeAfter(shape);
                    if (!after || after->body != value.first) return false;
                }
            if (const Body* was = m_world.bodies().find(m_world.bodies().handleAt(slot)))
                for (const ShapeHandle shape : was->shapes) {
                    const Shape* after = shapeAfter(shape);
                    if (after && !isListed(shape, *after)) return false;
                }
        }
        return true;
    }

    /// Whether an object of a handle is there after the delta.
    template <class Handle>
    bool isThereAfter(Handle handle) const {
        bool isThere = false;
        forEachKind(
            [&](const auto& values, const auto& map) {
                if constexpr (kIsOf<Handle, decltype(values)>) {
                    const auto found = values.find(handle.slot());
                    isThere =
                        handle && (found == values.end() ? map.find(handle) != nullptr : found->second.first == handle);
                }
            },
            m_delta, static_cast<const WorldObjects&>(m_world.data()));
        return isThere;
    }
    /// Whether notes are about objects that are there after the delta, no two about one, and whether those about
    /// objects that are gone are in the delta.
    bool notesHaveTheirObjects() const {
        const auto& known = m_world.data().noteOf;
        std::set<uint64_t> noted;
        for (const auto& [slot, value] : m_delta.notes) {
            if (!value.first) continue;
            const AnyObject& object = value.second->object;
            const auto old = known.find(bitsOf(object));
            if (!std::visit([&](auto handle) { return isThereAfter(handle); }, object) ||
                !noted.insert(bitsOf(object)).second ||
                (old != known.end() && !m_delta.notes.contains(old->second.slot())))
                return false;
        }
        bool isComplete = true;
        forEachKind(
            [&](const auto& values, const auto& map) {
                for (const auto& [slot, value] : values) {
                    const auto was = map.handleAt(slot);
                    const auto note = was && was != value.first ? known.find(was.bits) : known.end();
                    isComplete = isComplete && (note == known.end() || m_delta.notes.contains(note->second.slot()));
                }
            },
            m_delta, static_cast<const WorldObjects&>(m_world.data()));
        return isComplete;
    }

    const WorldDelta& m_delta;
    const World& m_world;
};

}  // namespace

std::vector<uint8_t> stepDeltaToBytes(const WorldDelta& before, const FrameChanges& changes, const World& after,
                                      PaletteList& palettes) {
    if (before.empty()) return {};
    const size_t known = palettes.palettes().size();
    std::vector<uint8_t> delta;
    BinaryOutputArchive out(delta, palettes);
    out.put(after.data().imported), out.put(after.data().removed), out.put(after.data().made);
    forEachKind(
        [&](const auto& was, const auto& now) {
            if constexpr (!kIsOf<ShapeHandle, decltype(was)>) putValues(out, was, now);
        },
        before, after.data());
    out.put(before.environment.has_value());
    if (before.environment) out.put(after.environment());
    out.put(before.materials.has_value());
    if (before.materials) out.put(after.materials().materials);
    out.put(before.settings.has_value());
    if (before.settings) out.put(after.settings());
    out.put(uint32_t(before.shapes.size()));
    for (const auto& [slot, was] : before.shapes) putShape(out, delta, slot, before, changes, after);
    forEachKind([&](const auto&, const auto& now) { out.put(now.freeSlots()); }, before, after.data());
    if (before.scripts || before.footprintChanged) out.put(after.data().scripts);  // only the last ones can be left out
    if (before.footprintChanged) out.put(after.data().footprint);
    std::vector<uint8_t> bytes =
        palettesToBytes({palettes.palettes().begin() + std::ptrdiff_t(known), palettes.palettes().end()});
    bytes.insert(bytes.end(), delta.begin(), delta.end());
    return bytes;
}

Result<FrameChanges> applyStepDelta(std::span<const uint8_t> bytes, const std::string& name, World& world,
                                    std::vector<PaletteRef>& palettes) {
    if (bytes.empty()) return world.applyDelta(std::nullopt);
    ByteReader in(bytes, "step");
    for (PaletteRef& palette : palettesFromBytes(in)) palettes.push_back(std::move(palette));
    WorldDelta delta = StepReader(in, palettes, world).read();
    in.expectEnd("step");
    if (!in.failed() && !DeltaCheck(delta, world).namesKnownSlots())
        in.fail("slots that follow those of the world", "one far above them");
    if (!in.failed() && !DeltaCheck(delta, world).isValid())
        in.fail("shapes and bodies that name each other, and joints, lights, weather and settings within their ranges",
                "others");
    if (in.failed()) return Error{name + ": " + in.error()};
    return world.applyDelta(std::move(delta));
}

}  // namespace rubble
