#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// Radii for soft, medium and hard materials, from an argument on; none is larger than the one before.
void readRadii(lua_State* L, int first, double (&radii)[3]) {
    constexpr const char* kNames[] = {"r0", "r1", "r2"};
    for (int i = 0; i < 3; ++i) {
        radii[i] = i ? numberOr(L, first + i, kNames[i], 0.0) : numberAt(L, first, kNames[0]);
        if (!(radii[i] >= 0.0)) refuseArgument(L, first + i, kNames[i], "a radius of 0 or more");
        if (i) radii[i] = std::min(radii[i], radii[i - 1]);
    }
}

/// What edits cost the step at most, by their size in metres: see chargeStep().
constexpr int64_t kMaxHoleWork = 200'000, kMaxCrackWork = 1'300'000;

int64_t workOf(double base, double factor, double size, int64_t most) {
    const double work = base + factor * size;
    return work < double(most) ? int64_t(work) : most;
}

int64_t holeWork(double radius, double length = 0.0) {
    return workOf(200.0, 1.0, 300.0 * radius * radius + 250.0 * radius * length, kMaxHoleWork);
}

int64_t explosionWork(double size) {
    return int64_t(38'000.0 * size * std::sqrt(size));
}

int makeHole(lua_State* L) {
    auto carve = sized<rubble_carve>();
    copy(carve.position, vectorAt(L, 1, "pos"));
    readRadii(L, 2, carve.radii);
    chargeStep(L, holeWork(carve.radii[0]));
    uint64_t count = 0;
    isDone(L, apiOf(L).count_carve(worldOf(L), &carve, &count));
    isDone(L, apiOf(L).carve(worldOf(L), &carve));
    lua_pushinteger(L, lua_Integer(count));
    return 1;
}

int makeHoleLine(lua_State* L) {
    auto carve = sized<rubble_carve>();
    carve.brush = RUBBLE_BRUSH_CAPSULE;
    copy(carve.position, vectorAt(L, 1, "p0"));
    const Vector end = vectorAt(L, 2, "p1");
    copy(carve.end, end);
    readRadii(L, 3, carve.radii);
    chargeStep(L, holeWork(carve.radii[0], length(end - vectorOf(carve.position))));
    isDone(L, apiOf(L).carve(worldOf(L), &carve));
    return 0;
}

int crack(lua_State* L) {
    auto edit = sized<rubble_break>();
    copy(edit.position, vectorAt(L, 1, "pos"));
    readRadii(L, 2, edit.radii);
    chargeStep(L, workOf(300.0, 17'000.0, edit.radii[0] * std::sqrt(edit.radii[0]), kMaxCrackWork));
    edit.seed = uint32_t(ScriptContext::of(L).shared.step);
    isDone(L, apiOf(L).break_voxels(worldOf(L), &edit));
    return 0;
}

int explosion(lua_State* L) {
    auto blast = sized<rubble_explosion>();
    copy(blast.position, vectorAt(L, 1, "pos"));
    blast.size = lua_isnoneornil(L, 2) ? 1.0 : limitedAt(L, 2, "size", 0.5, 4.0);
    chargeStep(L, explosionWork(blast.size));
    isDone(L, apiOf(L).explode(worldOf(L), &blast));
    return 0;
}

/// What a projectile of Shoot() does: radii of its hole for soft, medium and hard materials, in metres, and the impulse
/// that it gives, in N s, both at strength 1. A size above 0 explodes instead.
struct Projectile {
    const char* name;
    double radii[3];
    double impulse, explosion;
};
constexpr Projectile kProjectiles[] = {{"bullet", {0.3, 0.15, 0.0}, 40.0, 0.0},
                                       {"gun", {0.3, 0.15, 0.0}, 40.0, 0.0},
                                       {"shotgun", {0.6, 0.4, 0.0}, 160.0, 0.0},
                                       {"rocket", {0.0, 0.0, 0.0}, 0.0, 1.5}};

const Projectile& projectileAt(lua_State* L, int index) {
    const std::string name = textOr(L, index, "type", "bullet");
    for (const Projectile& projectile : kProjectiles)
        if (projectile.name == name) return projectile;
    refuseArgument(L, index, "type", "\"bullet\", \"gun\", \"shotgun\" or \"rocket\"");
}

void hit(lua_State* L, const rubble_hit& found, const Projectile& projectile, const Vector& along, double strength) {
    if (projectile.explosion > 0.0) {
        auto blast = sized<rubble_explosion>();
        std::copy_n(found.position, 3, blast.position);
        blast.size = std::clamp(projectile.explosion * strength, 0.5, 4.0);
        chargeStep(L, explosionWork(blast.size));
        isDone(L, apiOf(L).explode(worldOf(L), &blast));
        return;
    }
    auto carve = sized<rubble_carve>();
    carve.tool = RUBBLE_TOOL_GUN;
    std::copy_n(found.position, 3, carve.position);
    for (int i = 0; i < 3; ++i) carve.radii[i] = projectile.radii[i] * strength;
    chargeStep(L, holeWork(carve.radii[0]));
    isDone(L, apiOf(L).carve(worldOf(L), &carve));
    auto push = sized<rubble_impulse>();
    push.body = found.body;
    std::copy_n(found.position, 3, push.position);
    copy(push.impulse, along * (projectile.impulse * strength));
    if (found.body) isDone(L, apiOf(L).apply_impulse(worldOf(L), &push));
}

int shoot(lua_State* L) {
    const Vector origin = vectorAt(L, 1, "origin"), given = vectorAt(L, 2, "dir"), along = normalized(given);
    if (const double far = length(given); !(far > 0.0 && std::isfinite(far)))
        refuseArgument(L, 2, "dir", "a direction that has a length");
    const Projectile& projectile = projectileAt(L, 3);
    const double strength = numberOr(L, 4, "strength", 1.0);
    if (!(strength > 0.0 && strength <= 100.0)) refuseArgument(L, 4, "strength", "a number above 0, at most 100");
    rubble_hit found = {};
    if (!isDone(L,
                apiOf(L).cast_ray(worldOf(L), origin.data(), along.data(), numberOr(L, 5, "maxDist", 100.0), &found)))
        return 0;
    if (found.hit) hit(L, found, projectile, along, strength);
    return 0;
}

int addHeat(lua_State* L) {
    auto heat = sized<rubble_heat>();
    heat.shape = handleAt(L, 1, "shape");
    copy(heat.position, vectorAt(L, 2, "pos"));
    heat.joules = numberAt(L, 3, "amount") * 1e6;
    isDone(L, apiOf(L).heat(worldOf(L), &heat));
    return 0;
}

int spawnFire(lua_State* L) {
    auto heat = sized<rubble_heat>();
    heat.flags = RUBBLE_HEAT_IGNITE;
    copy(heat.position, vectorAt(L, 1, "pos"));
    heat.radius = 0.3;
    isDone(L, apiOf(L).heat(worldOf(L), &heat));
    return 0;
}

int extinguish(lua_State* L) {
    auto edit = sized<rubble_extinguish>();
    copy(edit.position, vectorAt(L, 1, "pos"));
    edit.radius = numberOr(L, 2, "radius", 1.0);
    edit.wet_seconds = numberOr(L, 3, "wetSeconds", 0.0);
    isDone(L, apiOf(L).extinguish(worldOf(L), &edit));
    return 0;
}

int getFireCount(lua_State* L) {
    uint32_t count = 0;
    isDone(L, apiOf(L).get_fires(worldOf(L), nullptr, 0, &count));
    lua_pushinteger(L, count);
    return 1;
}

int queryClosestFire(lua_State* L) {
    const Vector position = vectorAt(L, 1, "pos");
    rubble_fire fire = {};
    isDone(L, apiOf(L).find_closest_fire(worldOf(L), position.data(), numberAt(L, 2, "maxDist"), &fire));
    lua_pushboolean(L, fire.shape != 0);
    pushVector(L, fire.position);
    return 2;
}

int queryAabbFireCount(lua_State* L) {
    const auto [low, high] = cornersAt(L);
    uint32_t count = 0;
    isDone(L, apiOf(L).count_fires(worldOf(L), low.data(), high.data(), &count));
    lua_pushinteger(L, count);
    return 1;
}

int removeAabbFires(lua_State* L) {
    const auto [low, high] = cornersAt(L);
    isDone(L, apiOf(L).remove_fires(worldOf(L), low.data(), high.data()));
    return 0;
}

uint32_t partOf255(double share) {
    return uint32_t(std::clamp(share * 255.0 + 0.5, 1.0, 255.0));
}

void paintAt(lua_State* L, const Vector& position, double radius, rubble_paint paint) {
    ScriptContext& context = ScriptContext::of(L);
    copy(paint.position, position);
    paint.radius = radius;
    chargeStep(L, workOf(200.0, 600.0, radius * radius, kMaxHoleWork));
    paint.seed = uint32_t(context.shared.step);
    isDone(L, apiOf(L).paint(worldOf(L), &paint));
}

int paint(lua_State* L) {
    const Vector position = vectorAt(L, 1, "pos");
    const double radius = numberAt(L, 2, "radius");
    const std::string kind = textOr(L, 3, "type", "spraycan");
    auto edit = sized<rubble_paint>();
    if (kind == "spraycan")
        edit.color[0] = edit.color[1] = 220, edit.color[2] = 30;
    else if (kind == "explosion")
        edit.color[0] = 24, edit.color[1] = 21, edit.color[2] = 18;
    else
        refuseArgument(L, 3, "type", "\"spraycan\" or \"explosion\"");
    const double probability = finiteOr(L, 4, "probability", 1.0);
    if (probability <= 0.0) return 0;
    edit.strength = 190;
    edit.probability = partOf255(probability);
    paintAt(L, position, radius, edit);
    return 0;
}

int paintRgba(lua_State* L) {
    const Vector position = vectorAt(L, 1, "pos");
    const double radius = numberAt(L, 2, "radius");
    auto edit = sized<rubble_paint>();
    const char* const names[] = {"r", "g", "b"};
    for (int i = 0; i < 3; ++i)
        edit.color[i] = uint8_t(std::clamp(finiteOr(L, 3 + i, names[i], 1.0) * 255.0 + 0.5, 0.0, 255.0));
    const double opacity = finiteOr(L, 6, "a", 1.0), probability = finiteOr(L, 7, "probability", 1.0);
    if (probability <= 0.0 || opacity <= 0.0) return 0;
    edit.strength = partOf255(opacity);
    edit.probability = partOf255(probability);
    paintAt(L, position, radius, edit);
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"MakeHole(pos, r0, r1, r2, silent) -> voxels",
     "Removes voxels in the next step: soft materials within r0 metres, medium within r1, hard within r2, "
     "which is no larger than the one before. Gives how many that are; onBreak() tells what went.",
     makeHole},
    {"MakeHoleLine(p0, p1, r0, r1, r2)",
     "The same along a line from p0 to p1: a cut, or a long thin hole. Gives nothing.", makeHoleLine},
    {"Crack(pos, r0, r1, r2)", "Breaks what is within these radii into pieces, as its material does, in the next step.",
     crack},
    {"Explosion(pos, size)", "Breaks and pushes in the next step; size 0.5 to 4.", explosion},
    {"Shoot(origin, dir, type, strength, maxDist)",
     "A \"bullet\", \"shotgun\" or \"rocket\" hits the first voxel on its path.", shoot},
    {"AddHeat(shape, pos, amount)", "Heats a shape around a place, by amount megajoules. What gets hot enough burns.",
     addHeat, 100},
    {"SpawnFire(pos)", "Lights what can burn within 0.3 metres.", spawnFire, 100},
    {"Extinguish(pos, radius, wetSeconds)",
     "Puts out what burns around a place, and keeps it from burning for so long.", extinguish, 200},
    {"GetFireCount() -> count", "How many parts of shapes burn.", getFireCount},
    {"QueryClosestFire(pos, maxDist) -> hit, pos", "The nearest fire.", queryClosestFire},
    {"QueryAabbFireCount(min, max) -> count", "How many fires are in a box.", queryAabbFireCount},
    {"RemoveAabbFires(min, max)", "Puts out the fires in a box.", removeAabbFires, 50},
    {"Paint(pos, radius, type, probability)",
     "Paints surfaces as a \"spraycan\" or an \"explosion\" does, with some share of the voxels at the rim.", paint},
    {"PaintRGBA(pos, radius, r, g, b, a, probability)",
     "Paints surfaces in a colour of 0 to 1; a is how much of it stays.", paintRgba},
};

}  // namespace

std::span<const ScriptFunction> breakFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
