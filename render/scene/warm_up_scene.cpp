#include "render/scene/warm_up_scene.h"

#include "runtime/voxel/brick.h"
#include "runtime/voxel/material.h"

namespace rubble {
namespace {

constexpr uint8_t kBrickEntry = 1, kMirrorEntry = 2, kGlassEntry = 3, kLampEntry = 4;
constexpr uint8_t kClear = 60, kOpaque = 255;  ///< opacity of glass
const ShapeHandle kShape = ShapeHandle::make(1, 1, 0);

PaletteRef makePalette(uint8_t glassOpacity) {
    auto palette = std::make_shared<Palette>();
    const auto entry = [&](uint8_t index, const char* material) -> PaletteEntry& {
        (*palette)[index].material = uint8_t(defaultMaterials().find(material));
        return (*palette)[index];
    };
    entry(kBrickEntry, "brick");
    entry(kMirrorEntry, "metal").roughness = 20;
    entry(kGlassEntry, "glass").opacity = glassOpacity;
    entry(kLampEntry, "metal").emission = 4.0f;
    return palette;
}

/// A row of bricks, each of one palette entry; the first one is painted.
SnapshotShape makeShape() {
    SnapshotShape shape{kShape, {4 * kBrickSize, kBrickSize, kBrickSize}, 0.1f, makePalette(kClear), {}, {}};
    shape.paintColors = std::make_shared<PaintColors>();
    for (const uint8_t entry : {kBrickEntry, kMirrorEntry, kGlassEntry, kLampEntry}) {
        auto brick = std::make_shared<Brick>();
        brick->occupancy.fill(~uint64_t(0));
        brick->uniform = entry;
        if (entry == kBrickEntry) {
            brick->paint = std::make_unique<BrickIndices>();
            brick->paint->fill(0x1f);
        }
        shape.bricks.push_back({kShape, {entry - kBrickEntry, 0, 0}, brick});
    }
    return shape;
}

SnapshotLight makeLight() {
    SnapshotLight light{LightKind::Sphere, {0.5, 1.5, 0.5}, {0, -1, 0}, glm::vec3(4.0f), 0.05f, 20.0f, 0.3f, 0.5f};
    light.light = LightHandle::make(1, 1, 0);
    return light;
}

SnapshotLight makeScreen() {
    SnapshotLight screen = makeLight();
    screen.kind = LightKind::Screen;
    screen.width = screen.height = 0.5f;
    screen.image.width = 1;
    screen.image.texels = {0xffffffu};
    screen.light = LightHandle::make(1, 1, 1);
    return screen;
}

std::vector<SnapshotParticle> makeParticles() {
    std::vector<SnapshotParticle> particles;
    for (const ParticleKind kind : {ParticleKind::Dust, ParticleKind::Smoke, ParticleKind::Flame, ParticleKind::Spark,
                                    ParticleKind::Crumb, ParticleKind::Glint, ParticleKind::Ember})
        particles.push_back({kind, {0.4, 1.0, 1.0}, glm::vec3(0.1f), glm::vec3(0.5f), 0.3f, 0.5f, 0.5f, 1});
    return particles;
}

/// Everything but rare features.
FrameSnapshot makeScene() {
    FrameSnapshot scene;
    scene.version = scene.newestStep = 1;
    scene.replacesAll = scene.shadowReplacesAll = true;
    scene.lightsChanged = scene.particlesChanged = scene.ropesChanged = true;
    scene.watersChanged = scene.ripplesChanged = scene.environmentChanged = true;
    scene.created.push_back(makeShape());
    const Pose pose{{-1.0, 0.6, 0.0}, {1, 0, 0, 0}};
    scene.poses.push_back({kShape, pose, pose});
    scene.lights = {makeLight()};
    scene.particles = makeParticles();
    scene.ropes.push_back(
        {JointHandle::make(1, 1, 0), {{-1, 1, 0}, {1, 1, 0}}, {{-1, 1, 0}, {1, 1, 0}}, 0.02f, glm::vec3(0.5f)});
    Water water;
    water.outline = {{-5.0, -5.0}, {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}};
    water.surface = 0.2;
    scene.waters.push_back(water);
    scene.ripples.push_back({{0.0, 0.0}, water.surface, 0.1f, 0.01f, 0.5f});
    scene.environment.sunDirection = {-0.6f, 0.5f, 0.5f};
    scene.environment.fogDensity = 0.02f;
    scene.environment.wetness = 0.7f;
    ShadowWords cells{};
    cells.fill(1);
    for (int x = -1; x <= 0; ++x) scene.shadow.push_back({{x, 0, 0}, makeShadowBrick(cells)});
    return scene;
}

FrameSnapshot makeGlass(uint8_t opacity) {
    FrameSnapshot step;
    step.palettes.push_back({kShape, makePalette(opacity), nullptr});
    return step;
}

/// Adds what ShaderLibrary::setRareFeatures() is for: a light that is a rectangle, and a brick far away, for the paged
/// part of the shadow volume.
void addRareFeatures(FrameSnapshot& step) {
    step.lights = {makeLight(), makeScreen()};
    step.lightsChanged = true;
    ShadowWords cells{};
    cells.fill(1);
    step.shadow = {{{4000, 0, 0}, makeShadowBrick(cells)}};
}

}  // namespace

std::vector<FrameSnapshot> warmUpSteps() {
    std::vector<FrameSnapshot> steps;
    steps.push_back(makeScene());
    steps.push_back(makeGlass(kOpaque));
    steps.push_back(makeGlass(kClear));
    addRareFeatures(steps.back());
    for (size_t i = 0; i < steps.size(); ++i) steps[i].version = steps[i].newestStep = i + 1;
    return steps;
}

}  // namespace rubble
