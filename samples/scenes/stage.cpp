#include <algorithm>

#include "samples/scenes/car.h"
#include "samples/scenes/environment.h"
#include "samples/scenes/furniture.h"
#include "samples/scenes/neighbourhood.h"
#include "samples/scenes/street_light.h"
#include "samples/scenes/town.h"
#include "samples/scenes/tree.h"

namespace rubble {
namespace {

using namespace scenes;

constexpr glm::ivec3 kSquareLow{140, 0, 170}, kSquareHigh{500, 0, 446};  // of the square under the model, in cells

struct Bounds {
    glm::dvec3 low{1e30}, high{-1e30};
    void add(const LevelBody& body) {
        for (const LevelShape& shape : body.shapes) {
            const Pose pose = body.pose * shape.local;
            const glm::dvec3 size = glm::dvec3(shape.grid.size()) * double(shape.voxelSize);
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 point =
                    pose.transformPoint(size * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2));
                low = glm::min(low, point);
                high = glm::max(high, point);
            }
        }
    }
    bool meets(const Bounds& other, double margin) const {
        for (int i = 0; i < 3; ++i)
            if (low[i] > other.high[i] + margin || other.low[i] > high[i] + margin) return false;
        return true;
    }
};

/// Removes the bodies that would overlap the model, and the lights on their shapes.
void removeObstructions(Level& level, const Bounds& model) {
    std::vector<std::string> gone;
    std::erase_if(level.bodies, [&](const LevelBody& body) {
        Bounds bounds;
        bounds.add(body);
        if (body.name == "ground" || !bounds.meets(model, 1.0)) return false;
        for (const LevelShape& shape : body.shapes) gone.push_back(shape.name);
        return true;
    });
    std::erase_if(level.lights, [&](const LevelLight& light) {
        return std::find(gone.begin(), gone.end(), light.shapeName) != gone.end();
    });
}

/// Adds a square of paving slabs with strips of concrete.
void addSquare(GroundPlan& ground) {
    ground.areas.push_back({GroundPlan::Surface::Paving, {kSquareLow, kSquareHigh}});
    for (int x = kSquareLow.x; x < kSquareHigh.x; x += 60)
        ground.areas.push_back({GroundPlan::Surface::Concrete, {{x, 0, kSquareLow.z}, {x + 6, 0, kSquareHigh.z}}});
}

/// Cars, street lights, a hedge and trees round the square; they show how large the model is.
void addSquareProps(Level& level, uint64_t seed) {
    addStreetLight(level, "street light square left", {kSquareLow.x + 8, 0, kSquareHigh.z + 10}, false);
    addStreetLight(level, "street light square right", {kSquareHigh.x - 60, 0, kSquareHigh.z + 10}, false);
    addTree(level, "tree square left", {kSquareLow.x + 20, 0, kSquareLow.z + 50}, 78, kLeaves, seed + 2);
    addTree(level, "tree square right", {kSquareHigh.x - 30, 0, kSquareLow.z + 30}, 88, kLeavesAutumn, seed + 11);
    addStatic(level, makeHedge("hedge square", {150, 11, 9}), {kSquareLow.x + 110, -kHedgeRoot, kSquareLow.z + 6});
    addDynamic(level, makeCar("car red", kCarRed), {kSquareLow.x + 60, -kRoadDrop, 474});
    addDynamic(level, makeCar("car blue", kCarBlue), {kSquareLow.x + 200, -kRoadDrop, 528}, Turn::Half);
    addDynamic(level, makeBench("bench"), {kSquareHigh.x - 90, 0, kSquareLow.z + 60});
}

}  // namespace

Level makeStreetStage(const Level& model, uint64_t seed, glm::dvec3& modelLow, glm::dvec3& modelHigh) {
    Bounds bounds;
    for (const LevelBody& body : model.bodies) bounds.add(body);
    if (model.bodies.empty()) bounds = {glm::dvec3(0.0), glm::dvec3(0.0)};
    const glm::dvec3 size = bounds.high - bounds.low;
    const glm::dvec3 center = glm::dvec3(kSquareLow + kSquareHigh) * (0.5 * kVoxel);
    // The shift is a whole number of voxels, so that a model that is aligned to the grid stays aligned.
    const glm::dvec3 snapped = glm::floor((center - size * 0.5) / kVoxel + 0.5) * kVoxel;
    const glm::dvec3 shift = glm::dvec3(snapped.x, 0.0, snapped.z) - bounds.low;

    Level level;
    level.name = model.name;
    level.environment = lateAfternoon();
    level.materials = model.materials;
    level.lightGroups = model.lightGroups;  // first: palettes of the model refer to them by index
    const int extent = int(std::max(center.x + size.x, center.z + size.z) / kVoxel);
    const int side = std::clamp((extent + 15) / 16 * 16, 640, 2048);
    GroundPlan ground = crossingStreets({side, 0, side});
    addSquare(ground);
    addGround(level, ground);
    addNeighbourhood(level, seed);
    addSquareProps(level, seed);

    bounds.low += shift;
    bounds.high += shift;
    removeObstructions(level, bounds);
    for (LevelBody body : model.bodies) {
        body.pose.position += shift;
        level.bodies.push_back(std::move(body));
    }
    for (LevelLight light : model.lights) {
        if (light.shapeName.empty()) light.light.local.position += shift;
        level.lights.push_back(std::move(light));
    }
    modelLow = bounds.low;
    modelHigh = bounds.high;
    level.locations = {
        {"player", lookAt({bounds.low.x - 4.0, 1.7, bounds.high.z + 8.0}, (bounds.low + bounds.high) * 0.5)}};
    return level;
}

}  // namespace rubble
