#include "samples/hosts/godot/brick_meshes.h"

#include <cstring>

#include "samples/hosts/godot/spatial_math.h"
#include "samples/hosts/godot/voxel_world.h"

namespace rubble_godot {
namespace {

const Method kGetWorld{"Spatial", "get_world"}, kGetScenario{"World", "get_scenario"},
    kShaderCreate{"VisualServer", "shader_create"}, kShaderSetCode{"VisualServer", "shader_set_code"},
    kMaterialCreate{"VisualServer", "material_create"}, kMaterialSetShader{"VisualServer", "material_set_shader"},
    kMeshCreate{"VisualServer", "mesh_create"}, kMeshClear{"VisualServer", "mesh_clear"},
    kMeshAddSurface{"VisualServer", "mesh_add_surface_from_arrays"},
    kMeshSetMaterial{"VisualServer", "mesh_surface_set_material"}, kInstanceCreate{"VisualServer", "instance_create2"},
    kInstanceSetTransform{"VisualServer", "instance_set_transform"}, kFree{"VisualServer", "free_rid"};
constexpr int32_t kTriangles = 4;

const char* const kCode[2] = {
    "shader_type spatial;\n"
    "void fragment() { ALBEDO = pow(COLOR.rgb, vec3(2.2)); ROUGHNESS = 0.9; }\n",
    "shader_type spatial;\n"
    "void fragment() { ALBEDO = pow(COLOR.rgb, vec3(2.2)); ALPHA = COLOR.a; ROUGHNESS = 0.1; }\n"};

/// What a surface of a mesh is made of.
struct Surface {
    std::vector<Vec3> positions, normals;
    std::vector<Color> colors;
    std::vector<int32_t> indices;

    /// Four vertices, counter-clockwise; Godot's front faces are clockwise.
    void addRectangle(const rubble_mesh_vertex* corners) {
        const auto first = int32_t(positions.size());
        for (int i = 0; i < 4; ++i) {
            const rubble_mesh_vertex& v = corners[i];
            positions.push_back({v.position[0], v.position[1], v.position[2]});
            normals.push_back({v.normal[0], v.normal[1], v.normal[2]});
            colors.push_back({v.color[0] / 255.0f, v.color[1] / 255.0f, v.color[2] / 255.0f, v.color[3] / 255.0f});
        }
        for (const int32_t corner : {0, 2, 1, 0, 3, 2}) indices.push_back(first + corner);
    }
    Variant arrays() const {
        std::vector<Variant> all(9);  // Mesh.ARRAY_MAX
        all[0] = Variant::pool(positions), all[1] = Variant::pool(normals);
        all[3] = Variant::pool(colors), all[8] = Variant::pool(indices);
        return Variant::array(all);
    }
};

}  // namespace

BrickMeshes::BrickMeshes(const VoxelWorld& owner) : m_owner(owner), m_vertices(RUBBLE_MAX_BRICK_VERTICES) {
    gd::Object* const server = singleton("VisualServer");
    for (size_t i = 0; i < 2; ++i) {
        m_shaders[i] = kShaderCreate(server), m_materials[i] = kMaterialCreate(server);
        kShaderSetCode(server, m_shaders[i], kCode[i]);
        kMaterialSetShader(server, m_materials[i], m_shaders[i]);
    }
}

BrickMeshes::~BrickMeshes() {
    for (auto& [handle, shape] : m_shapes) drop(shape);
    for (size_t i = 0; i < 2; ++i)
        kFree(singleton("VisualServer"), m_materials[i]), kFree(singleton("VisualServer"), m_shaders[i]);
}

void BrickMeshes::drop(Shape& shape) {
    for (auto& [position, brick] : shape.bricks)
        kFree(singleton("VisualServer"), brick.instance), kFree(singleton("VisualServer"), brick.mesh);
    shape.bricks.clear();
    shape.version = 0;
}

void BrickMeshes::update(rubble_shape handle) {
    Shape& shape = m_shapes[handle];
    rubble_brick_changes changes = {
        .struct_size = sizeof changes, .what = RUBBLE_BRICKS_MESHES, .shape = handle, .since = shape.version};
    uint32_t count = 0;
    const rubble_api& api = m_owner.api();
    rubble_result result = api.get_changed_bricks(m_owner.world(), &changes, &shape.version, nullptr, 0, &count);
    if (result == RUBBLE_ERROR_STALE) {  // another grid: all of it again
        drop(shape);
        changes.since = 0;
        result = api.get_changed_bricks(m_owner.world(), &changes, &shape.version, nullptr, 0, &count);
    }
    if (!m_owner.check(result, "get_changed_bricks") || count == 0) return;
    std::vector<rubble_brick> bricks(count);
    if (!m_owner.check(api.get_changed_bricks(m_owner.world(), &changes, &shape.version, bricks.data(), count, &count),
                       "get_changed_bricks"))
        return;
    for (const rubble_brick& brick : bricks) updateBrick(handle, shape, brick);
}

void BrickMeshes::updateBrick(rubble_shape handle, Shape& shape, const rubble_brick& brick) {
    const std::array<int32_t, 3> position{brick.x, brick.y, brick.z};
    gd::Object* const server = singleton("VisualServer");
    uint32_t count = 0;
    if (!m_owner.check(m_owner.api().mesh_brick(m_owner.world(), handle, position.data(), m_vertices.data(),
                                                RUBBLE_MAX_BRICK_VERTICES, &count),
                       "mesh_brick"))
        return;
    auto found = shape.bricks.find(position);
    if (count == 0) {
        if (found == shape.bricks.end()) return;
        kFree(server, found->second.instance), kFree(server, found->second.mesh);
        shape.bricks.erase(found);
        return;
    }
    if (found == shape.bricks.end()) {
        const Variant mesh = kMeshCreate(server);
        const Variant world = kGetWorld(m_owner.node());
        const Variant instance = kInstanceCreate(server, mesh, kGetScenario(world.as<gd::Object*>()));
        kInstanceSetTransform(server, instance, shape.place);
        found = shape.bricks.emplace(position, Brick{mesh, instance}).first;
    }
    Surface surfaces[2];
    for (uint32_t i = 0; i < count; i += 4) surfaces[m_vertices[i].color[3] < 255].addRectangle(&m_vertices[i]);
    kMeshClear(server, found->second.mesh);
    int32_t index = 0;
    for (size_t i = 0; i < 2; ++i) {
        if (surfaces[i].indices.empty()) continue;
        kMeshAddSurface(server, found->second.mesh, kTriangles, surfaces[i].arrays());
        kMeshSetMaterial(server, found->second.mesh, index++, m_materials[i]);
    }
}

void BrickMeshes::updateAll() {
    uint32_t count = 0;
    const rubble_api& api = m_owner.api();
    if (!m_owner.check(api.get_shape_states(m_owner.world(), 0, nullptr, 0, &count), "get_shape_states")) return;
    m_states.resize(count);
    if (!m_owner.check(api.get_shape_states(m_owner.world(), 0, m_states.data(), count, &count), "get_shape_states"))
        return;
    for (const rubble_shape_state& state : m_states) {
        update(state.shape);
        Shape& shape = m_shapes[state.shape];
        const Transform place = toTransform(state.position, state.rotation);
        if (std::memcmp(&place, &shape.place, sizeof place) == 0) continue;
        shape.place = place;
        for (const auto& [position, brick] : shape.bricks)
            kInstanceSetTransform(singleton("VisualServer"), brick.instance, place);
    }
}

void BrickMeshes::follow() {
    rubble_events events = {.struct_size = sizeof events};
    if (!m_owner.check(m_owner.api().get_events(m_owner.world(), &events), "get_events")) return;
    if (events.level_loaded) {
        for (auto& [handle, shape] : m_shapes) drop(shape);
        m_shapes.clear();
    }
    for (uint32_t i = 0; i < events.shapes_destroyed_count; ++i)
        if (const auto found = m_shapes.find(events.shapes_destroyed[i]); found != m_shapes.end()) {
            drop(found->second);
            m_shapes.erase(found);
        }
    updateAll();
}

}  // namespace rubble_godot
