#include "tests/fuzz/random_world.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "runtime/assets/save_file.h"
#include "tests/fuzz/mutator.h"

namespace rubble {
namespace {

PaletteRef randomPalette(Decisions& decisions) {
    auto palette = std::make_shared<Palette>();
    const char* names[] = {"concrete", "wood", "glass", "metal", "wire", "foliage"};
    for (size_t i = 1; i < 7; ++i) (*palette)[i].material = defaultMaterials().find(names[i - 1]);
    (*palette)[3].opacity = 90;
    if (decisions.oneIn(2)) (*palette)[1 + decisions.below(6)].emission = float(decisions.within({0.0, 1e6}));
    if (decisions.oneIn(2)) (*palette)[1 + decisions.below(6)].opacity = uint8_t(decisions.below(256));
    return palette;
}

VoxelGrid randomGrid(Decisions& decisions) {
    if (decisions.oneIn(24)) return {};
    // Mostly within a brick, some over several, a few over several nodes: small worlds are fast.
    const auto side = [&] { return 1 + int(decisions.below(decisions.oneIn(48) ? 40 : decisions.oneIn(4) ? 18 : 6)); };
    const int x = side(), y = side(), z = side();
    VoxelGrid grid({x, y, z});
    if (decisions.oneIn(16)) return grid;
    const uint32_t pattern = decisions.below(4), seed = decisions.below(1000);
    GridWriter writer(grid);
    for (int k = 0; k < z; ++k)
        for (int j = 0; j < y; ++j)
            for (int i = 0; i < x; ++i) {
                const uint32_t noise = hashCell(i, j, k, seed);
                const bool isSolid = pattern == 0 || (pattern == 1 && noise % 3) || (pattern == 2 && noise % 7 == 0) ||
                                     (pattern == 3 && (j % 6 < 2 || (i % 5 == 0 && k % 5 == 0)));
                if (isSolid) writer.set({i, j, k}, uint8_t(pattern == 0 ? 1 + seed % 6 : 1 + (noise >> 8) % 6));
            }
    writer.flush();
    return grid;
}

glm::dquat randomRotation(Decisions& decisions) {
    if (decisions.oneIn(2)) return {1, 0, 0, 0};
    const double x = decisions.unit() - 0.5, y = decisions.unit() - 0.5, z = decisions.unit() - 0.5;
    return glm::normalize(glm::dquat(0.6, x, y, z));
}

void addBodies(Decisions& decisions, Level& level) {
    const PaletteRef palette = randomPalette(decisions);
    for (uint32_t i = 0, count = 1 + decisions.below(3); i < count; ++i) {
        LevelBody& body = level.bodies.emplace_back();
        body.isStatic = i == 0 || decisions.oneIn(2);
        body.pose = {{0.4 * i, 0.1 * i, 0.1 * i}, randomRotation(decisions)};
        if (!body.isStatic && decisions.oneIn(2)) body.velocity.y = float(decisions.unit() * 10.0);
        for (uint32_t k = 0, shapes = 1 + decisions.below(2); k < shapes; ++k) {
            LevelShape& shape = body.shapes.emplace_back();
            shape.name = "shape " + std::to_string(i) + std::to_string(k);
            shape.grid = randomGrid(decisions);
            shape.palette = palette;
            shape.local.position.x = 0.3 * k;
            if (decisions.oneIn(4)) shape.voxelSize = float(decisions.within({0.02, 0.5}));
            shape.hidden = decisions.oneIn(16);
            if (decisions.oneIn(4)) shape.anchors = {{{0, 0, 0}, {3, 3, 3}}};
        }
    }
}

std::string randomShapeName(Decisions& decisions) {
    const uint32_t body = decisions.below(3), shape = decisions.below(2);
    return decisions.oneIn(3) ? "" : "shape " + std::to_string(body) + std::to_string(shape);
}

GroundPolygon square(double side) {
    return {{-side, -side}, {side, -side}, {side, side}, {-side, side}};
}

Joint randomJoint(Decisions& decisions) {
    Joint joint{.kind = JointKind(decisions.below(7))};
    for (JointEnd& end : joint.ends) {
        end.frame = {decisions.place(), randomRotation(decisions)};
        end.radius = decisions.within({0.0, 2.0});
    }
    joint.limits = {decisions.oneIn(2), -0.5, 0.5};
    joint.motor = {MotorMode(decisions.below(3)), decisions.within({-3.0, 3.0}), decisions.within({0.0, 1e4})};
    joint.spring.hertz = decisions.oneIn(2) ? decisions.within({0.0, 60.0}) : 0.0;
    joint.breakForce = decisions.oneIn(3) ? decisions.within({0.0, 1e4}) : 0.0;
    joint.collides = decisions.oneIn(2);
    return joint;
}

ShapeHandle anyShape(Decisions& decisions, const World& world) {
    return decisions.oneIn(3) ? ShapeHandle{}
                              : world.shapes().handleAt(decisions.below(uint32_t(world.shapes().slotCount())));
}
BodyHandle anyBody(Decisions& decisions, const World& world) {
    return world.bodies().handleAt(decisions.below(uint32_t(world.bodies().slotCount())));
}

std::array<double, 3> randomRadii(Decisions& decisions) {
    const double radius = decisions.within({0.0, 1.2});
    return {radius, radius * decisions.unit(), 0.0};
}

/// An edit with usual numbers.
Edit usualEdit(Decisions& decisions, const World& world) {
    const glm::dvec3 at = decisions.place();
    const ShapeHandle shape = anyShape(decisions, world);
    const BodyHandle body = anyBody(decisions, world);
    const auto joint = world.joints().handleAt(decisions.below(uint32_t(world.joints().slotCount())));
    const auto light = world.lights().handleAt(decisions.below(uint32_t(world.lights().slotCount())));
    const auto character = world.characters().handleAt(decisions.below(uint32_t(world.characters().slotCount())));
    const double size = decisions.within({0.0, 1.5});
    const uint32_t seed = decisions.below(1000);
    switch (decisions.below(57)) {
        case 0:
            return CarveEdit{.kind = BrushKind::Box, .position = at, .halfSize = {size, size, 0.3}, .shape = shape};
        case 1:
            return CarveEdit{
                .kind = BrushKind::Capsule, .position = at, .end = decisions.place(), .radii = randomRadii(decisions)};
        case 2:
            return ExplodeEdit{at, decisions.within({0.5, 4.0}), 0.0};
        case 3:
            return PaintEdit{
                .position = at, .radius = size, .seed = seed, .mode = PaintMode(decisions.below(3)), .shape = shape};
        case 4:
            return ImpulseEdit{body, at, {size * 100.0, 500.0, 0.0}};
        case 5: {
            WorldSettings settings = world.settings();
            settings.stress.on = decisions.oneIn(2);
            settings.physics = PhysicsPreset(decisions.below(4));
            settings.undoMarks = decisions.below(4);
            settings.split.partsPerStep = decisions.oneIn(2) ? 0 : decisions.below(40);
            settings.debris.bodies = decisions.oneIn(4) ? decisions.below(10) : 10'000;
            return SettingsEdit{settings};
        }
        case 6:
            return HistoryEdit{HistoryAction(decisions.below(3))};
        case 7:
            return HeatEdit{
                .position = at, .radius = size, .joules = decisions.within({0.0, 1e8}), .ignite = decisions.oneIn(2)};
        case 8:
            return ExtinguishEdit{at, size, decisions.within({0.0, 60.0})};
        case 9:
            return RemoveFiresEdit{at, at + size};
        case 10:
            return SplitShapeEdit{shape, decisions.oneIn(2), 8};
        case 11:
            return MergeShapeEdit{shape, anyShape(decisions, world)};
        case 12:
            return TrimShapeEdit{shape};
        case 13: {
            const glm::ivec3 low(int(decisions.below(20)) - 8, int(decisions.below(20)) - 8,
                                 int(decisions.below(20)) - 8);
            return ResizeShapeEdit{shape, {low, low + 1 + int(decisions.below(30))}};
        }
        case 14:
            return ImpactLoadEdit{shape, at, {0.0, -1e5 * size, 0.0}};
        case 15:
            return SetCollisionFilterEdit{shape, uint8_t(seed), uint8_t(seed >> 2)};
        case 16:
            return AddWaterEdit{{.outline = square(3.0), .surface = size, .depth = 2.0, .flow = {size, 0.0, 0.0}}};
        case 17:
            return RemoveWaterEdit{world.waters().handleAt(seed % 4)};
        case 18:
            return AddTriggerEdit{{.kind = TriggerKind(decisions.below(3)), .pose = {at}, .outline = square(1.0)}};
        case 19:
            return RemoveTriggerEdit{world.triggers().handleAt(seed % 4)};
        case 20:
            return AddCharacterEdit{{.position = at}};
        case 21:
            return RemoveCharacterEdit{character};
        case 22:
            return MoveCharacterEdit{character, {size * 3.0, 0.0, 1.0}, decisions.oneIn(2), decisions.oneIn(2)};
        case 23:
            return TeleportCharacterEdit{character, at, {0.0, size, 0.0}};
        case 24: {
            Joint wanted = randomJoint(decisions);
            for (JointEnd& end : wanted.ends) end.shape = anyShape(decisions, world);
            return AddJointEdit{wanted};
        }
        case 25:
            return RemoveJointEdit{joint, JointBreak(decisions.below(4)), at};
        case 26:
            return SetJointMotorEdit{joint, {MotorMode(decisions.below(3)), size, 1e3}, size, size};
        case 27:
            return DetachJointEdit{joint, shape};
        case 28:
            return GrabEdit{.body = body, .point = at, .target = at + 1.0, .hand = seed % 3, .turns = seed % 2 == 0};
        case 29:
            return ReleaseEdit{{size * 10.0, 0.0, 0.0}, seed % 3};
        case 30:
            return DriveEdit{body, 1.0 - size, size - 0.5, 0.0};
        case 31: {
            Environment weather = world.environment();
            weather.gravity.y = float(-20.0 * size);
            return SetEnvironmentEdit{weather};
        }
        case 32:
            return SetLightEdit{light, {.shape = shape, .local = {at}, .group = world.lightGroups().handleAt(0)}};
        case 33:
            return AddLightEdit{{.kind = LightKind(decisions.below(5)), .shape = shape, .local = {at}}};
        case 34:
            return RemoveLightEdit{light};
        case 35:
            return SetBoundsEdit{{BoundsRule(decisions.below(3)), at - 1.0, at - 1.0 + size * 2.0}};
        case 36:
            return SetCollisionShapeEdit{shape, CollisionShape(decisions.below(5))};
        case 37:
            return SetBodyEdit{.body = body,
                               .setsPose = decisions.oneIn(2),
                               .pose = {at},
                               .setsVelocity = decisions.oneIn(2),
                               .velocity = at,
                               .setsSleep = decisions.oneIn(3),
                               .setsKind = decisions.oneIn(4),
                               .isStatic = decisions.oneIn(2),
                               .asleep = decisions.oneIn(2)};
        case 38:
            return DestroyBodyEdit{body};
        case 39:
            return DestroyShapeEdit{shape};
        case 40:
            return WriteVoxelsEdit{shape,
                                   {{1, 0, 2}, {4, 3, 5}},
                                   std::vector<uint8_t>(27, uint8_t(seed % 3)),
                                   std::vector<uint8_t>(seed % 2 * 27, uint8_t(seed / 2 % 2))};
        case 41:
        case 42:
            return CreateBodyEdit{{.pose = {at, randomRotation(decisions)}, .isStatic = decisions.oneIn(3)}};
        case 43:
        case 44: {
            CreateShapeEdit edit{.body = body, .source = ShapeSource(decisions.below(4))};
            edit.size = glm::ivec3(1 + decisions.below(9), 1 + decisions.below(5), 1 + seed % 7);
            edit.entry = uint8_t(1 + seed % 6);
            edit.copied = shape;
            if (decisions.oneIn(2)) edit.paletteOf = anyShape(decisions, world);
            edit.shape.local = {at, randomRotation(decisions)};
            if (edit.source == ShapeSource::Grid) edit.shape.grid = randomGrid(decisions);
            if (decisions.oneIn(4)) edit.shape.palette = randomPalette(decisions);
            return edit;
        }
        case 45:
            return SetNameEdit{light, "night"};
        case 46:
            return SetTagEdit{shape, seed % 2 ? "door" : "key", seed % 3 ? "" : "red"};
        case 47:
            return RemoveTagEdit{shape, "door"};
        case 48:
            if (seed % 4 == 0) return SetScriptsEdit{{{"lift.lua", seed % 8 ? "speed=2" : ""}}, seed % 3 == 0};
            return SetUserValueEdit{body, seed};
        case 55:
            return ConstrainEdit{{.body = body,
                                  .other = anyBody(decisions, world),
                                  .position = at,
                                  .direction = {size, 1.0, decisions.within({-1.0, 1.0})},
                                  .speed = decisions.within({-9.0, 9.0}),
                                  .turns = decisions.oneIn(2),
                                  .maxForce = decisions.oneIn(2) ? 0.0 : decisions.within({0.0, 1e5})}};
        case 54:
            return CreateLightGroupEdit{{.name = "made", .threshold = float(seed % 3) * 0.5f}};
        case 51: {
            SetShapeEdit edit{.shape = shape, .setsStrength = decisions.oneIn(2), .strength = float(1 + seed % 3)};
            edit.setsDensity = decisions.oneIn(2), edit.density = 0.5f * float(1 + seed % 5);
            edit.setsEmission = decisions.oneIn(2), edit.emission = float(seed % 3);
            edit.setsLoad = decisions.oneIn(2), edit.loadBearing = seed % 2;
            edit.anchorChange = AnchorChange(decisions.below(3));
            if (seed % 3) edit.anchors = {{glm::ivec3(0), glm::ivec3(1 + seed % 4)}};
            return edit;
        }
        case 52:
            return SetLightGroupEdit{.group = world.lightGroups().handleAt(decisions.below(3)),
                                     .switches = decisions.oneIn(2),
                                     .on = seed % 2 == 0,
                                     .setsSupply = decisions.oneIn(3),
                                     .supply = shape};
        case 53:
            return SetBodyEdit{.body = body,
                               .setsGravityScale = decisions.oneIn(2),
                               .gravityScale = decisions.within({-2.0, 2.0}),
                               .setsDamping = decisions.oneIn(2),
                               .linearDamping = decisions.within({0.0, 9.0}),
                               .angularDamping = decisions.within({0.0, 9.0})};
        case 50: {
            const auto row = uint8_t(1 + decisions.below(uint32_t(world.materials().materials.size())));
            SetMaterialsEdit edit{row, {defaultMaterials()[uint8_t(1 + seed % 19)]}};
            if (decisions.oneIn(2)) edit.materials[0].name = seed % 2 ? "own" : "wire";
            return edit;
        }
        case 49: {
            SetPaletteEdit edit{shape, decisions.oneIn(2), uint8_t(1 + decisions.below(6)), {}};
            const PaletteRef palette = randomPalette(decisions);
            for (uint32_t i = 1 + decisions.below(4); i-- > 0;) edit.entries.push_back((*palette)[1 + i]);
            edit.entries[0].lightGroup = decisions.below(3);
            return edit;
        }
        default:
            return BreakEdit{.position = at, .radii = randomRadii(decisions), .seed = seed, .shape = shape};
    }
}

}  // namespace

Level randomLevel(Decisions& decisions) {
    Level level;
    addBodies(decisions, level);
    level.autoLightGroups = decisions.below(4);
    for (uint32_t i = decisions.below(3); i-- > 0;) level.lightGroups.push_back({.name = "group " + std::to_string(i)});
    for (uint32_t i = decisions.below(3); i-- > 0;)
        level.lights.push_back(
            {{.name = "light", .kind = LightKind(decisions.below(5))}, randomShapeName(decisions), "group 0"});
    for (uint32_t i = decisions.below(3); i-- > 0;)
        level.waters.push_back({.name = "water", .outline = square(4.0), .surface = decisions.unit(), .depth = 1.0});
    for (uint32_t i = decisions.below(3); i-- > 0;)
        level.triggers.push_back({.kind = TriggerKind(decisions.below(3)), .outline = square(1.0)});
    for (uint32_t i = decisions.below(2); i-- > 0;) level.characters.push_back({.position = {0.5, 1.0, 0.3}});
    for (uint32_t i = decisions.below(4); i-- > 0;)
        level.joints.push_back({randomJoint(decisions), {randomShapeName(decisions), randomShapeName(decisions)}});
    level.locations.emplace_back("spawn", Pose{});
    return level;
}

Edit randomEdit(Decisions& decisions, const World& world, uint32_t wildness) {
    Edit edit = usualEdit(decisions, world);
    if (wildness) Mutator(decisions, wildness).mutate(static_cast<AnyEdit&>(edit));
    return edit;
}

void requireReadableSave(const World& saved) {
    World world = saved;
    world.resetCaches();  // as saving does in the running game
    const std::vector<uint8_t> file = gameToBytes({world.state(), {}}, world.hash(), nullptr);
    const Result<SavedGame> game = gameFromBytes(file, "save", world.id());  // which compares the hashes
    if (game) return;
    std::fprintf(stderr, "the save of a world cannot be read: %s\n", game.error().c_str());
    std::abort();
}

}  // namespace rubble
