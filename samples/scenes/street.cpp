#include "samples/scenes/street.h"

#include <algorithm>
#include <cstdlib>

#include "runtime/core/random.h"
#include "samples/scenes/surface_styles.h"

namespace rubble::scenes {
namespace {

using Surface = GroundPlan::Surface;
constexpr int kTile = 160;
constexpr int kSoil = 8;       // cells of dirt over the rock
constexpr int kTuftSpace = 4;  // cells over the ground

struct GroundSwatches {
    explicit GroundSwatches(Canvas& c)
        : rock(c.addSurface(kRock)),
          dirt(c.addSurface(kDirt)),
          grass(c.addSurface(kGrass)),
          grassDark(c.addSurface(kGrass, 82)),
          dry(c.addSurface(kGrassDry)),
          asphalt(c.addSurface(kAsphalt)),
          asphaltWorn(c.addSurface(kAsphalt, 112)),
          patch(c.addSurface(kAsphaltPatch)),
          crack(c.addSurface(kAsphaltCrack)),
          white(c.addSurface(kLaneWhite)),
          kerb(c.addSurface(kKerb)),
          kerbWorn(c.addSurface(kKerb, 115)),
          paving(c.addSurface(kPaving)),
          joint(c.addSurface(kPavingJoint)),
          moss(c.addSurface(kMoss)),
          concrete(c.addSurface(kConcrete, 95)),
          manhole(c.addSurface(kManhole)),
          litter(c.addSurface(kLeavesAutumn)),
          flowers(c.addSurface(kFlowers)) {}
    Swatch rock, dirt, grass, grassDark, dry, asphalt, asphaltWorn, patch, crack, white, kerb, kerbWorn, paving, joint,
        moss, concrete, manhole, litter, flowers;
};

bool inside(const CellBox& box, int x, int z) {
    return x >= box.low.x && x < box.high.x && z >= box.low.z && z < box.high.z;
}

Surface surfaceAt(const GroundPlan& plan, int x, int z) {
    Surface surface = Surface::Lawn;
    for (const GroundPlan::Area& area : plan.areas)
        if (inside(area.box, x, z)) surface = area.surface;
    return surface;
}

/// Value noise in [0, 255] on a grid of `step` cells, interpolated bilinearly.
int softNoise(int x, int z, int step, uint32_t seed) {
    const int cx = x / step, cz = z / step, fx = x % step, fz = z % step;
    const auto corner = [&](int dx, int dz) { return int(hashCell(cx + dx, 0, cz + dz, seed) >> 24); };
    const int near = corner(0, 0) * (step - fx) + corner(1, 0) * fx;
    const int far = corner(0, 1) * (step - fx) + corner(1, 1) * fx;
    return (near * (step - fz) + far * fz) / (step * step);
}

bool onLine(const std::vector<CellBox>& boxes, int x, int z) {
    return std::any_of(boxes.begin(), boxes.end(), [&](const CellBox& box) { return inside(box, x, z); });
}

/// Cracks follow the level set of a noise at its middle value; a second noise limits them to some areas.
bool cracked(int x, int z) {
    const int wave = softNoise(x, z, 37, 301) * 2 + softNoise(x, z, 11, 302) / 2;
    return std::abs(wave - 300) < 5 && softNoise(x, z, 60, 303) > 120;
}

uint8_t roadCell(const GroundPlan& plan, const GroundSwatches& s, ivec3 c) {
    for (const ivec3& hole : plan.manholes) {
        const int dx = c.x - hole.x, dz = c.z - hole.z, square = dx * dx + dz * dz;
        if (square <= 16)
            return square <= 9 && (dx + dz) % 2 == 0 ? PaletteBuilder::pickFor(s.manhole, 1)
                                                     : PaletteBuilder::pick(s.manhole, c);
        if (square <= 25) return PaletteBuilder::pick(s.crack, c);
    }
    if (cracked(c.x, c.z)) return PaletteBuilder::pick(s.crack, c);
    const bool worn = hashCell(c.x, 0, c.z, 304) % 100 < uint32_t(softNoise(c.x, c.z, 23, 305)) / 7;
    const bool dashX = onLine(plan.lanesAlongX, c.x, c.z) && c.x % 40 < 24,
               dashZ = onLine(plan.lanesAlongZ, c.x, c.z) && c.z % 40 < 24;
    if (!worn && (dashX || dashZ || onLine(plan.solidLines, c.x, c.z))) return PaletteBuilder::pick(s.white, c);
    const int repair = softNoise(c.x / 2, c.z / 2, 31, 306);
    if (repair > 196) return PaletteBuilder::pick(s.patch, c);
    return PaletteBuilder::pick(softNoise(c.x, c.z, 45, 307) > 150 ? s.asphaltWorn : s.asphalt, c);
}

uint8_t pavingCell(const GroundSwatches& s, ivec3 c) {
    const int row = c.z / 6, shift = row % 2 * 3;
    if (c.z % 6 == 0 || (c.x + shift) % 6 == 0) {
        return PaletteBuilder::pick(softNoise(c.x, c.z, 29, 311) > 190 ? s.moss : s.joint, c);
    }
    const uint32_t slab = hashCell((c.x + shift) / 6, 0, row, 312);
    return hashCell(c.x, 0, c.z, 313) % 5 ? PaletteBuilder::pickFor(s.paving, slab) : PaletteBuilder::pick(s.paving, c);
}

uint8_t lawnCell(const GroundSwatches& s, ivec3 c) {
    const int tone = softNoise(c.x, c.z, 27, 321);
    if (hashCell(c.x, 1, c.z, 322) % 90 == 0) return PaletteBuilder::pick(s.litter, c);
    if (softNoise(c.x, c.z, 17, 323) > 215) return PaletteBuilder::pick(s.dirt, c);
    return PaletteBuilder::pick(tone > 180 ? s.dry : tone < 90 ? s.grassDark : s.grass, c);
}

struct Column {
    int top;        ///< height of the ground in cells
    uint8_t entry;  ///< palette entry of the topmost cell
};

bool besideRoad(const GroundPlan& plan, int x, int z) {
    for (int d = 1; d <= 2; ++d)
        for (const glm::ivec2 offset : {glm::ivec2(d, 0), glm::ivec2(-d, 0), glm::ivec2(0, d), glm::ivec2(0, -d)})
            if (surfaceAt(plan, x + offset.x, z + offset.y) == Surface::Road) return true;
    return false;
}

Column columnAt(const GroundPlan& plan, const GroundSwatches& s, int x, int z) {
    const Surface surface = surfaceAt(plan, x, z);
    const ivec3 cell(x, 0, z);
    if (surface == Surface::Road) return {plan.depth - kRoadDrop, roadCell(plan, s, cell)};
    if (surface == Surface::Paving && besideRoad(plan, x, z)) {
        const bool seam = (x + z) % 10 == 0;
        return {plan.depth, PaletteBuilder::pick(seam                              ? s.joint
                                                 : hashCell(x, 2, z, 331) % 4 == 0 ? s.kerbWorn
                                                                                   : s.kerb,
                                                 cell)};
    }
    if (surface == Surface::Paving) return {plan.depth, pavingCell(s, cell)};
    if (surface == Surface::Concrete)
        return {plan.depth, PaletteBuilder::pick(x % 20 == 0 || z % 20 == 0 ? s.joint : s.concrete, cell)};
    if (surface == Surface::Earth) return {plan.depth, PaletteBuilder::pick(s.dirt, cell)};
    return {plan.depth, lawnCell(s, cell)};
}

void drawColumn(Canvas& canvas, const GroundPlan& plan, const GroundSwatches& s, ivec3 corner, int x, int z) {
    const int gx = corner.x + x, gz = corner.z + z;
    const Column column = columnAt(plan, s, gx, gz);
    const Surface surface = surfaceAt(plan, gx, gz);
    const bool stone = surface == Surface::Road || surface == Surface::Paving || surface == Surface::Concrete;
    for (int y = plan.depth - kSoil; y < column.top - 1; ++y)
        canvas.set({x, y, z}, stone && y == column.top - 2 ? s.asphalt : s.dirt);
    canvas.setEntry({x, column.top - 1, z}, column.entry);
    for (const CellBox& box : plan.foundations)
        if (inside(box, gx, gz)) canvas.clear({x, plan.depth + box.low.y, z}, {x + 1, plan.depth + kTuftSpace, z + 1});
}

/// Tufts of grass and flowers, in patches.
void drawTufts(Canvas& canvas, const GroundPlan& plan, const GroundSwatches& s, ivec3 corner, ivec3 size) {
    for (int z = 0; z < size.z; ++z)
        for (int x = 0; x < size.x; ++x) {
            const int gx = corner.x + x, gz = corner.z + z;
            if (surfaceAt(plan, gx, gz) != Surface::Lawn || !canvas.at({x, plan.depth - 1, z})) continue;
            const uint32_t dice = hashCell(gx, 5, gz, 341);
            if (int(dice % 1000) >= std::max(2, softNoise(gx, gz, 19, 342) - 150) / 2) continue;
            const bool flower = dice >> 20 & 1 && softNoise(gx, gz, 40, 343) > 185;
            const int height = 1 + int(dice >> 24 & 1);
            canvas.box({x, plan.depth, z}, {x + 1, plan.depth + height, z + 1}, s.grass);
            if (flower) canvas.set({x, plan.depth + height, z}, s.flowers);
        }
}

LevelShape groundTile(const GroundPlan& plan, ivec3 corner) {
    const ivec3 size(std::min(kTile, plan.size.x - corner.x), plan.depth + kTuftSpace,
                     std::min(kTile, plan.size.z - corner.z));
    Canvas canvas(size);
    const GroundSwatches swatches(canvas);
    // Rock has one entry, so that each of its bricks is uniform and stored as one byte.
    canvas.fill(ivec3(0), {size.x, plan.depth - kSoil, size.z}, [&](ivec3) { return swatches.rock.first; });
    for (int z = 0; z < size.z; ++z)
        for (int x = 0; x < size.x; ++x) drawColumn(canvas, plan, swatches, corner, x, z);
    drawTufts(canvas, plan, swatches, corner, size);
    LevelShape shape =
        canvas.finish("ground " + std::to_string(corner.x / kTile) + " " + std::to_string(corner.z / kTile));
    shape.local.position = glm::dvec3(corner) * kVoxel;
    return shape;
}

/// A slope beyond one edge of the ground: the box low..high of its cells, in which it falls to the ground's bottom over
/// `width` cells. Roads and pavements that meet the edge run on.
LevelShape slope(const GroundPlan& plan, std::string name, ivec3 low, ivec3 high, int width) {
    Canvas canvas({high.x - low.x, plan.depth + kTuftSpace, high.z - low.z});
    const GroundSwatches s(canvas);
    const GroundPlan unmarked;
    const auto mirrored = [](int at, int size) { return at < 0 ? -1 - at : at >= size ? 2 * size - 1 - at : at; };
    for (int z = low.z; z < high.z; ++z)
        for (int x = low.x; x < high.x; ++x) {
            const ivec3 edge(std::clamp(x, 0, plan.size.x - 1), 0, std::clamp(z, 0, plan.size.z - 1));
            const ivec3 cell(mirrored(x, plan.size.x), 0, mirrored(z, plan.size.z));
            const int out = std::max({std::abs(x - edge.x), std::abs(z - edge.z)});
            const Surface surface = surfaceAt(plan, edge.x, edge.z);
            const bool isRoad = surface == Surface::Road;
            const int share = 256 * out * out * (3 * width - 2 * out) / (width * width * width);  // of the fall
            const int dither = surface == Surface::Lawn ? int(hashCell(x + width, 6, z + width, 351) >> 24) : 128;
            const int top = std::max(1, plan.depth - (plan.depth * share + dither) / 256 - (isRoad ? kRoadDrop : 0));
            canvas.box({x - low.x, 0, z - low.z}, {x - low.x + 1, top - 1, z - low.z + 1}, s.dirt);
            canvas.setEntry({x - low.x, top - 1, z - low.z}, isRoad                       ? roadCell(unmarked, s, cell)
                                                             : surface == Surface::Paving ? pavingCell(s, cell)
                                                                                          : lawnCell(s, cell));
        }
    LevelShape shape = canvas.finish(std::move(name));
    shape.local.position = glm::dvec3(low) * kVoxel;
    return shape;
}

}  // namespace

void addSlopes(Level& level, const GroundPlan& plan, int width) {
    const ivec3 size = plan.size;
    LevelBody body;
    body.name = "slopes";
    body.pose.position.y = -plan.depth * kVoxel;
    const auto add = [&](const char* name, ivec3 low, ivec3 high) {
        body.shapes.push_back(slope(plan, name, low, high, width));
    };
    add("slope west", {-width, 0, -width}, {0, 0, size.z + width});
    add("slope east", {size.x, 0, -width}, {size.x + width, 0, size.z + width});
    add("slope north", {0, 0, -width}, {size.x, 0, 0});
    add("slope south", {0, 0, size.z}, {size.x, 0, size.z + width});
    level.bodies.push_back(std::move(body));
}

void addGround(Level& level, const GroundPlan& plan) {
    LevelBody body;
    body.name = "ground";
    body.pose.position.y = -plan.depth * kVoxel;
    for (int z = 0; z < plan.size.z; z += kTile)
        for (int x = 0; x < plan.size.x; x += kTile) body.shapes.push_back(groundTile(plan, {x, 0, z}));
    level.bodies.push_back(std::move(body));
}

}  // namespace rubble::scenes
