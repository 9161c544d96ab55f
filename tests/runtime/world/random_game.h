#pragma once
#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/core/random.h"
#include "runtime/world/world.h"
#include "tests/support/grids.h"

/// A small level with something of everything, and random edits of every kind, valid and invalid.
namespace rubble::test {

/// Entries by default materials; entries 4 and 5 have none, and voxels of 5 exist.
inline PaletteRef gamePalette(uint8_t red) {
    auto palette = std::make_shared<Palette>();
    const MaterialTable table = defaultMaterials();
    (*palette)[1] = {.red = red, .green = 110, .blue = 60, .material = table.find("wood")};
    (*palette)[2] = {.red = 170, .green = red, .blue = 60, .material = table.find("brick")};
    (*palette)[3] = {.red = 200, .green = 230, .blue = red, .opacity = 80, .material = table.find("glass")};
    (*palette)[6] = {.red = 255, .material = table.find("brick"), .emission = 3.0f, .lightGroup = 1};
    return palette;
}

/// A body of touching blocks, each a shape of its own with holes and loose parts.
inline LevelBody blockBody(Random& random, std::string name, glm::ivec3 blocks, const Pose& pose, bool isStatic) {
    LevelBody body{.name = name, .pose = pose, .isStatic = isStatic};
    constexpr int kSide = 12;
    for (int i = 0; i < blocks.x * blocks.y * blocks.z; ++i) {
        const glm::ivec3 at(i % blocks.x, i / blocks.x % blocks.y, i / blocks.x / blocks.y);
        const uint32_t kind = random.below(4), seed = random.next();
        const auto content = [=](glm::ivec3 c) {
            if (kind == 0) return uint8_t(1);
            if (kind == 1) return uint8_t(c.y < 3 || c.x % 5 == 0 ? 2 : 0);
            if (kind == 2) return uint8_t(c.x == 3 && c.y == 3 ? 5 : c.x < 6 ? 1 : 3);
            return uint8_t(hashCell(c.x / 3, c.y / 3, c.z / 3, seed) % 3 ? 1 + (c.y > 9 ? 5 : 0) : 0);
        };
        LevelShape shape{.name = name + std::to_string(i), .grid = gridOf(glm::ivec3(kSide), content)};
        shape.local.position = glm::dvec3(at * kSide) * 0.1;
        shape.palette = gamePalette(uint8_t(60 * (i % 3)));
        body.shapes.push_back(std::move(shape));
    }
    return body;
}

/// The level of a random game.
inline Level gameLevel(uint64_t seed) {
    Random random(seed, 1);
    Level level;
    level.lightGroups.push_back({"light", 0.3f});
    level.bodies.push_back(blockBody(random, "crate", {2, 2, 1}, {{1.0, 3.5, 1.0}}, false));
    level.bodies.push_back(blockBody(random, "house", {3, 2, 2}, {{0.0, 0.8, 0.0}}, true));
    LevelBody ground{.name = "ground", .pose = {{-4.0, -0.8, -4.0}}};
    ground.shapes.push_back({.name = "ground", .grid = solidGrid({96, 16, 96}, 2), .palette = gamePalette(9)});
    level.bodies.push_back(std::move(ground));
    level.bodies.push_back(
        blockBody(random, "table", {2, 1, 1}, {{-3.0, 0.85, -2.0}, {0.924, 0.0, 0.383, 0.0}}, false));
    level.lights.push_back({Light{.name = "bulb", .local = {{0.2, 0.2, 0.2}}}, "house0", "light"});
    LevelJoint rope{{.name = "rope", .kind = JointKind::Rope}, {"crate0", "house1"}};
    rope.joint.ends[0].radius = rope.joint.ends[1].radius = 2.0;
    level.joints.push_back(rope);
    return level;
}

/// Draws edits for a world. Handles are taken from those that it ever saw, so some are stale.
class RandomEdits {
public:
    /// The same seed gives the same edits for the same worlds.
    explicit RandomEdits(uint64_t seed) : m_random(seed, 2) {}

    /// The edits of one step. `history`: marks, undo and redo too.
    Edits next(const World& world, bool history) {
        remember(world);
        Edits out;
        if (history && m_random.below(4) == 0) out.push_back(HistoryEdit{HistoryAction(m_random.below(3))});
        for (uint32_t i = m_random.below(4); i-- > 0;) add(world, out);
        return out;
    }
    /// The generator, for other choices of a test.
    Random& random() { return m_random; }

private:
    void remember(const World& world) {
        const auto add = [](auto& list, auto handle) {
            if (std::find(list.begin(), list.end(), handle) == list.end()) list.push_back(handle);
        };
        forEachKind([&](auto& list, const auto& map) { map.forEach([&](auto h, const auto&) { add(list, h); }); },
                    m_seen, world.data());
    }
    /// A live object in most cases, else any of the past; empty if there was none.
    template <class Handle>
    Handle any(const std::vector<Handle>& seen, const auto& map) {
        if (seen.empty()) return {};
        Handle handle;
        for (int i = 0; i < 6; ++i)
            if (map.find(handle = seen[m_random.below(uint32_t(seen.size()))])) return handle;
        return handle;
    }
    ShapeHandle shape(const World& world) { return any(m_seen.shapes, world.shapes()); }
    BodyHandle body(const World& world) { return any(m_seen.bodies, world.bodies()); }
    double unit() { return double(m_random.unit()); }
    glm::dvec3 around(double size) { return (glm::dvec3(unit(), unit(), unit()) - 0.5) * size; }
    glm::ivec3 cell(glm::ivec3 size) {
        return {m_random.between(0, size.x), m_random.between(0, size.y), m_random.between(0, size.z)};
    }
    /// A place in the grid of a shape, world.
    glm::dvec3 place(const World& world) {
        const ShapeHandle handle = shape(world);
        const Shape* at = world.shapes().find(handle);
        if (!at) return around(6.0);
        return shapeToWorld(world, handle).transformPoint(glm::dvec3(cell(at->grid.size())) * 0.1);
    }
    ShapeHandle sometimes(ShapeHandle handle) { return m_random.below(3) ? ShapeHandle{} : handle; }
    CarveEdit carve(const World& world) {
        CarveEdit edit{
            .kind = BrushKind(m_random.below(3)), .position = place(world), .shape = sometimes(shape(world))};
        edit.radii.fill(0.1 + 0.5 * unit());
        edit.halfSize = m_random.below(3) ? glm::dvec3(0.1 + unit(), 0.06, 0.1 + unit()) : glm::dvec3(0.06, 1.0, 1.0);
        edit.end = edit.position + around(2.0);
        return edit;
    }
    Joint joint(const World& world) {
        const std::array kinds = {JointKind::Rope, JointKind::Ball, JointKind::Hinge, JointKind::Fixed};
        Joint out = jointAt(world, kinds[m_random.below(4)], sometimes(shape(world)), shape(world), {place(world)});
        if (m_random.below(2)) std::swap(out.ends[0], out.ends[1]);
        for (JointEnd& end : out.ends) end.radius = 1.5;
        if (out.kind == JointKind::Rope) out.ends[m_random.below(2)].isFree = m_random.below(3) == 0;
        if (m_random.below(6) == 0) out.hand = 1 + m_random.below(3);
        out.rope.slack = 0.3;
        return out;
    }
    WorldSettings settings(const World& world) {
        WorldSettings out = world.settings();
        out.undoMarks = 6;
        out.minPieceVoxels = 1 + m_random.below(2) * 8;
        out.debris.bodies = m_random.below(2) ? 10'000 : 3 + m_random.below(8);
        out.debris.voxels = m_random.below(3) ? 4'000'000 : 900;
        out.debris.settleSteps = m_random.below(2) ? 120 : 3;
        out.split.partsPerStep = m_random.below(2) ? 0 : 1 + m_random.below(3);
        out.stress.on = m_random.below(3) == 0;
        out.fire.enabled = m_random.below(5) != 0;
        out.paint.mode = m_random.below(2) ? PaintMode::Blend : PaintMode::Layer;
        return out;
    }
    void add(const World& world, Edits& out) {
        switch (m_random.below(7)) {
            case 6:
                return addPropertyEdit(world, out);
            case 0:
                return addShapeEdit(world, out);
            case 1:
                return addJointEdit(world, out);
            case 2:
                return addRegionEdit(world, out);
            case 3:
                return addPaintOrFire(world, out);
            default:
                return addDamage(world, out);
        }
    }
    void addDamage(const World& world, Edits& out) {
        switch (m_random.below(6)) {
            case 0:
                return out.push_back(BreakEdit{.position = place(world),
                                               .radii = {0.5, 0.4, 0.3},
                                               .tool = Tool(m_random.below(5)),
                                               .seed = m_random.next(),
                                               .shape = sometimes(shape(world))});
            case 1:
                return out.push_back(ExplodeEdit{.position = place(world), .size = 0.3 + 0.6 * unit()});
            case 2:
                return out.push_back(ImpulseEdit{body(world), place(world), around(400.0)});
            case 3:
                return out.push_back(ImpactLoadEdit{shape(world), place(world), around(4000.0)});
            default:
                return out.push_back(carve(world));
        }
    }
    void addShapeEdit(const World& world, Edits& out) {
        const ShapeHandle target = shape(world);
        const Shape* at = world.shapes().find(target);
        const glm::ivec3 low = cell(glm::ivec3(12)) - 6, size = at ? at->grid.size() : glm::ivec3(9);
        switch (m_random.below(7)) {
            case 0:
                return out.push_back(SplitShapeEdit{target, m_random.below(2) == 0, m_random.below(40)});
            case 1:
                return out.push_back(TrimShapeEdit{target});
            case 2:
                return out.push_back(ResizeShapeEdit{target, {low, low + size - 2 + cell(glm::ivec3(6))}});
            case 3:
                return out.push_back(SetCollisionFilterEdit{target, 1, uint8_t(m_random.below(2) ? 255 : 2)});
            case 4:
                return out.push_back(SetCollisionShapeEdit{target, CollisionShape(m_random.below(5))});
            default: {
                ShapeHandle into;
                if (const Body* owner = at && m_random.below(2) ? world.bodies().find(at->body) : nullptr)
                    into = owner->shapes[m_random.below(uint32_t(owner->shapes.size()))];
                return out.push_back(MergeShapeEdit{target, into});
            }
        }
    }
    void addPropertyEdit(const World& world, Edits& out) {
        const ShapeHandle target = shape(world);
        const auto rows = uint32_t(world.materials().materials.size());
        switch (m_random.below(6)) {
            case 0: {
                const PaletteRef palette = gamePalette(uint8_t(m_random.below(256)));
                SetPaletteEdit edit{target, m_random.below(2) == 0, uint8_t(1 + m_random.below(6)), {}};
                edit.entries = {(*palette)[1 + m_random.below(6)], (*palette)[1 + m_random.below(6)]};
                edit.entries[0].lightGroup = m_random.below(3);
                return out.push_back(edit);
            }
            case 1: {
                Material row = defaultMaterials()[uint8_t(1 + m_random.below(19))];
                if (m_random.below(2)) row.name = "own";
                return out.push_back(SetMaterialsEdit{uint8_t(1 + m_random.below(rows)), {row}});
            }
            case 2:
                return out.push_back(CreateLightGroupEdit{{.name = "made", .threshold = 0.2f}});
            case 3:
                return out.push_back(SetLightGroupEdit{.group = any(m_seen.groups, world.lightGroups()),
                                                       .switches = true,
                                                       .on = m_random.below(2) == 0,
                                                       .setsSupply = m_random.below(3) == 0,
                                                       .supply = sometimes(target)});
            case 4:
                return out.push_back(SetBodyEdit{.body = body(world),
                                                 .setsGravityScale = true,
                                                 .gravityScale = 2.0 * unit() - 1.0,
                                                 .setsDamping = m_random.below(2) == 0,
                                                 .linearDamping = unit()});
            default: {
                SetShapeEdit edit{.shape = target, .setsStrength = m_random.below(2) == 0, .strength = 0.5f};
                edit.setsDensity = m_random.below(2), edit.density = 0.5f + m_random.unit();
                edit.setsEmission = m_random.below(2), edit.emission = m_random.unit();
                edit.setsLoad = m_random.below(2), edit.loadBearing = m_random.below(2);
                edit.anchorChange = AnchorChange(m_random.below(3));
                if (m_random.below(2)) edit.anchors = {{glm::ivec3(0), glm::ivec3(1) + cell(glm::ivec3(12))}};
                return out.push_back(edit);
            }
        }
    }
    void addJointEdit(const World& world, Edits& out) {
        const JointHandle handle = any(m_seen.joints, world.joints());
        const Joint* known = world.joints().find(handle);
        switch (m_random.below(8)) {
            case 0:
                return out.push_back(RemoveJointEdit{handle, JointBreak(m_random.below(4)), place(world)});
            case 1: {
                const ShapeHandle from = known ? known->ends[m_random.below(2)].shape : shape(world);
                return out.push_back(DetachJointEdit{handle, from});
            }
            case 2:
                return out.push_back(GrabEdit{
                    .body = body(world), .point = place(world), .target = place(world), .hand = m_random.below(3)});
            case 3:
                return out.push_back(ReleaseEdit{around(90.0), m_random.below(3)});
            case 4:
                return out.push_back(
                    SetJointMotorEdit{handle, {MotorMode(m_random.below(3)), unit(), 100.0 * unit()}, unit()});
            default:
                return out.push_back(AddJointEdit{joint(world)});
        }
    }
    void addRegionEdit(const World& world, Edits& out) {
        const GroundPolygon square = {{-2.0, -2.0}, {3.0, -2.0}, {3.0, 3.0}, {-2.0, 3.0}};
        switch (m_random.below(13)) {
            case 0:
                return out.push_back(AddWaterEdit{{.outline = square, .surface = 2.0 * unit()}});
            case 1:
                return out.push_back(RemoveWaterEdit{any(m_seen.waters, world.waters())});
            case 2:
                return out.push_back(AddTriggerEdit{{.pose = {place(world)}, .halfSize = glm::dvec3(unit() + 0.1)}});
            case 3:
                return out.push_back(RemoveTriggerEdit{any(m_seen.triggers, world.triggers())});
            case 4:
                return out.push_back(AddCharacterEdit{{.position = place(world) + glm::dvec3(0, 2, 0)}});
            case 5:
                return out.push_back(RemoveCharacterEdit{any(m_seen.characters, world.characters())});
            case 6:
                return out.push_back(MoveCharacterEdit{any(m_seen.characters, world.characters()), around(6.0), true});
            case 7:
                return out.push_back(TeleportCharacterEdit{any(m_seen.characters, world.characters()), place(world)});
            case 8:
                return out.push_back(AddLightEdit{{.shape = sometimes(shape(world)), .local = {around(2.0)}}});
            case 9:
                return out.push_back(RemoveLightEdit{any(m_seen.lights, world.lights())});
            case 10: {
                Environment weather = world.environment();
                weather.wetness = m_random.unit();
                weather.gravity.y = m_random.below(2) ? -9.81f : -3.0f;
                return out.push_back(SetEnvironmentEdit{weather});
            }
            case 11: {
                const glm::dvec3 middle = place(world);
                const double reach = 4.0 * unit();  // metres: some bodies are outside
                return out.push_back(SetBoundsEdit{{BoundsRule(m_random.below(3)), middle - reach, middle + reach}});
            }
            default:
                return out.push_back(SettingsEdit{settings(world)});
        }
    }
    void addPaintOrFire(const World& world, Edits& out) {
        switch (m_random.below(5)) {
            case 0:
                return out.push_back(ExtinguishEdit{place(world), 0.6, 2.0 * double(m_random.below(2))});
            case 1:
                return out.push_back(HeatEdit{.position = place(world),
                                              .radius = 0.4,
                                              .joules = 1e6 * unit(),
                                              .ignite = m_random.below(2) == 0,
                                              .shape = sometimes(shape(world))});
            default:
                return out.push_back(PaintEdit{.position = place(world),
                                               .radius = 0.3 + unit(),
                                               .color = {uint8_t(m_random.below(256)), 0, uint8_t(m_random.below(256))},
                                               .strength = uint8_t(m_random.between(20, 255)),
                                               .seed = m_random.next(),
                                               .mode = PaintMode(m_random.below(3)),
                                               .shape = sometimes(shape(world))});
        }
    }

    template <class Handle, class T>
    using HandleList = std::vector<Handle>;
    Random m_random;
    ObjectKinds<HandleList> m_seen;
};

}  // namespace rubble::test
