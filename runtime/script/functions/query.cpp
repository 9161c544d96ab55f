#include <cmath>
#include <sstream>
#include <string>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

/// What the next query may find. Taking it puts the settings of the script back to none, as in Teardown.
class QueryFilter {
public:
    explicit QueryFilter(lua_State* L) : m_settings(ScriptContext::of(L).query) {
        m_filter.flags = m_settings.flags;
        m_filter.layer_mask = m_settings.layers;
        m_filter.rejected_bodies = m_settings.bodies.data();
        m_filter.rejected_body_count = uint32_t(m_settings.bodies.size());
        m_filter.rejected_shapes = m_settings.shapes.data();
        m_filter.rejected_shape_count = uint32_t(m_settings.shapes.size());
    }
    ~QueryFilter() {
        m_settings.flags = m_settings.layers = 0;
        m_settings.bodies.clear();
        m_settings.shapes.clear();
    }
    rubble_query_filter& get() { return m_filter; }

private:
    QuerySettings& m_settings;
    rubble_query_filter m_filter = sized<rubble_query_filter>();
};

constexpr size_t kMaxRejected = 10'000;

/// QueryRequire("physical dynamic large ...").
int queryRequire(lua_State* L) {
    std::istringstream words(textAt(L, 1, "layers"));
    uint32_t flags = 0;
    bool isKnown = true;
    for (std::string word; words >> word;) {
        if (word == "physical")
            flags |= RUBBLE_FILTER_REJECT_UNPHYSICAL;
        else if (word == "dynamic")
            flags |= RUBBLE_FILTER_REJECT_STATIC;
        else if (word == "static")
            flags |= RUBBLE_FILTER_REJECT_DYNAMIC;
        else
            isKnown = isKnown && (word == "large" || word == "small" || word == "visible" || word == "animated");
    }
    if (!isKnown) refuseArgument(L, 1, "layers", "words of \"physical\", \"dynamic\" and \"static\"");
    ScriptContext::of(L).query.flags |= flags;
    return 0;
}

int queryInclude(lua_State* L) {
    const double layers = numberAt(L, 1, "layers");
    if (!(layers >= 1.0 && layers <= 255.0) || layers != std::floor(layers))
        refuseArgument(L, 1, "layers", "bits of layers, 1 to 255");
    ScriptContext::of(L).query.layers |= uint32_t(layers);
    return 0;
}

int reject(lua_State* L, std::vector<uint64_t>& list, uint64_t handle) {
    if (list.size() >= kMaxRejected)
        return luaL_error(L, "%s: expected at most %d, found more", runningFunction(L).name().c_str(),
                          int(kMaxRejected));
    if (handle) list.push_back(handle);
    return 0;
}

/// What is gone is passed over. A handle of something else is an error here, not at the query.
uint64_t rejectedAt(lua_State* L, int index, const char* name, uint32_t kind) {
    const uint64_t handle = handleAt(L, index, name);
    rubble_body_state body = {};
    rubble_shape_state shape = {};
    if (!handle) return 0;
    const rubble_result result = kind == RUBBLE_KIND_BODY ? apiOf(L).get_body_state(worldOf(L), handle, &body)
                                                          : apiOf(L).get_shape_state(worldOf(L), handle, &shape);
    if (result == RUBBLE_OK || isMadeInThisStep(L, handle)) return handle;
    return isDone(L, result) ? handle : 0;
}

int queryRejectBody(lua_State* L) {
    return reject(L, ScriptContext::of(L).query.bodies, rejectedAt(L, 1, "body", RUBBLE_KIND_BODY));
}

int queryRejectShape(lua_State* L) {
    return reject(L, ScriptContext::of(L).query.shapes, rejectedAt(L, 1, "shape", RUBBLE_KIND_SHAPE));
}

int rejectAll(lua_State* L, std::vector<uint64_t>& list, uint32_t kind) {
    if (lua_type(L, 1) != LUA_TTABLE) refuseArgument(L, 1, "list", "a list of handles");
    for (lua_Integer i = 1; lua_rawgeti(L, 1, i) != LUA_TNIL; ++i) {
        reject(L, list, rejectedAt(L, -1, "list", kind));
        lua_pop(L, 1);
    }
    return 0;
}

int queryRejectBodies(lua_State* L) {
    return rejectAll(L, ScriptContext::of(L).query.bodies, RUBBLE_KIND_BODY);
}

int queryRejectShapes(lua_State* L) {
    return rejectAll(L, ScriptContext::of(L).query.shapes, RUBBLE_KIND_SHAPE);
}

int pushHit(lua_State* L, const rubble_hit& hit) {
    lua_pushboolean(L, hit.hit);
    lua_pushnumber(L, hit.distance);
    pushVector(L, hit.normal);
    pushHandle(L, hit.shape);
    return 4;
}

double distanceAt(lua_State* L, int index) {
    const double distance = numberAt(L, index, "maxDist");
    if (!(distance >= 0.0 && distance <= 1e6)) refuseArgument(L, index, "maxDist", "0 to 1e6 m");
    return distance;
}

int queryRaycast(lua_State* L) {
    rubble_ray ray = {};
    copy(ray.origin, vectorAt(L, 1, "origin"));
    copy(ray.direction, vectorAt(L, 2, "dir"));
    ray.max_distance = distanceAt(L, 3);
    ray.radius = numberOr(L, 4, "radius", 0.0);
    if (!(ray.radius >= 0.0 && ray.radius <= 1e4)) refuseArgument(L, 4, "radius", "0 to 1e4 m");
    QueryFilter filter(L);
    if (boolOr(L, 5, false)) filter.get().flags |= RUBBLE_FILTER_REJECT_TRANSPARENT;
    rubble_hit hit = {};
    isDone(L, apiOf(L).cast_rays(worldOf(L), &ray, 1, &filter.get(), &hit));
    return pushHit(L, hit);
}

int queryClosestPoint(lua_State* L) {
    const Vector origin = vectorAt(L, 1, "origin");
    const double distance = distanceAt(L, 2);
    QueryFilter filter(L);
    rubble_hit hit = {};
    isDone(L, apiOf(L).find_closest_point(worldOf(L), origin.data(), distance, &filter.get(), &hit));
    lua_pushboolean(L, hit.hit);
    pushVector(L, hit.position);
    pushVector(L, hit.normal);
    pushHandle(L, hit.shape);
    return 4;
}

rubble_query_shape boxAt(lua_State* L) {
    const auto [low, high] = cornersAt(L);
    rubble_query_shape box = {};
    box.kind = RUBBLE_QUERY_BOX;
    copy(box.position, (low + high) * 0.5);
    copy(box.half_size, (high - low) * 0.5);
    return box;
}

int queryAabbShapes(lua_State* L) {
    const rubble_query_shape box = boxAt(L);
    QueryFilter filter(L);
    const auto& found = readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        return apiOf(L).overlap_shapes(worldOf(L), &box, &filter.get(), out, capacity, count);
    });
    return pushHandles(L, found.data(), found.size());
}

int queryAabbBodies(lua_State* L) {
    const rubble_query_shape box = boxAt(L);
    QueryFilter filter(L);
    const auto& found = readHandles(L, [&](uint64_t* out, uint32_t capacity, uint32_t* count) {
        return apiOf(L).overlap_bodies(worldOf(L), &box, &filter.get(), out, capacity, count);
    });
    return pushHandles(L, found.data(), found.size());
}

/// Many rays at once, in lists of numbers: neither tables nor calls for each.
int queryRaycasts(lua_State* L) {
    if (lua_type(L, 1) != LUA_TTABLE) refuseArgument(L, 1, "rays", "a list of numbers");
    const double distance = distanceAt(L, 2);
    const lua_Integer count = lua_Integer(lua_rawlen(L, 1) / 6);
    if (count > 100'000 || lua_rawlen(L, 1) % 6 != 0)
        refuseArgument(L, 1, "rays", "a list of six numbers a ray, its origin and direction, of at most 100000 rays");
    Sandbox::of(L).charge(L, count * 100);
    std::vector<rubble_ray> rays(static_cast<size_t>(count));
    for (lua_Integer i = 0; i < count * 6; ++i) {
        if (lua_rawgeti(L, 1, i + 1) != LUA_TNUMBER) refuseArgument(L, -1, "rays", "numbers");
        rubble_ray& ray = rays[size_t(i / 6)];
        (i % 6 < 3 ? ray.origin[i % 6] : ray.direction[i % 6 - 3]) = lua_tonumber(L, -1);
        lua_pop(L, 1);
        ray.max_distance = distance;
    }
    std::vector<rubble_hit> hits(rays.size());
    QueryFilter filter(L);
    if (count) isDone(L, apiOf(L).cast_rays(worldOf(L), rays.data(), uint32_t(count), &filter.get(), hits.data()));
    lua_createtable(L, int(count), 0);
    lua_createtable(L, int(count), 0);
    for (size_t i = 0; i < hits.size(); ++i) {
        lua_pushnumber(L, hits[i].hit ? hits[i].distance : -1.0);
        lua_rawseti(L, -3, lua_Integer(i) + 1);
        pushHandle(L, hits[i].shape);
        lua_rawseti(L, -2, lua_Integer(i) + 1);
    }
    return 2;
}

constexpr ScriptFunction kFunctions[] = {
    {"QueryRequire(layers)",
     "The next query finds only what is \"physical\", \"dynamic\", \"static\": words with spaces between. \"large\", "
     "\"small\", \"visible\" and \"animated\" are passed over.",
     queryRequire},
    {"QueryInclude(layers)", "The next query finds only shapes of these collision layers, 8 bits.", queryInclude},
    {"QueryRejectBody(body)", "The next query does not find a body.", queryRejectBody},
    {"QueryRejectShape(shape)", "The next query does not find a shape.", queryRejectShape},
    {"QueryRejectBodies(list)", "The next query does not find these bodies.", queryRejectBodies},
    {"QueryRejectShapes(list)", "The next query does not find these shapes.", queryRejectShapes},
    {"QueryRaycast(origin, dir, maxDist, radius, rejectTransparent) -> hit, dist, normal, shape",
     "The first voxel that a ray meets, or a sphere of a radius that moves along it.", queryRaycast},
    {"QueryRaycasts(rays, maxDist) -> distances, shapes",
     "Many rays at once, at most 100,000: a list of six numbers each. -1 is the distance of one that meets nothing.",
     queryRaycasts},
    {"QueryClosestPoint(origin, maxDist) -> hit, pos, normal, shape", "The point of a voxel that is the closest.",
     queryClosestPoint},
    {"QueryAabbShapes(min, max) -> list", "The shapes with a voxel in a box along the world's axes.", queryAabbShapes},
    {"QueryAabbBodies(min, max) -> list", "The bodies with a voxel in such a box.", queryAabbBodies},
};

}  // namespace

std::span<const ScriptFunction> queryFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
