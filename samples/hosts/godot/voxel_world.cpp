#include "samples/hosts/godot/voxel_world.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

#include "samples/hosts/godot/host_services.h"
#include "samples/hosts/godot/spatial_math.h"
#include "samples/hosts/godot/world_child.h"

namespace rubble_godot {
namespace {

/// The worlds by their nodes: Godot gives a child its parent, not the parent's object of this library.
std::map<gd::Object*, VoxelWorld*> g_worlds;

const Method kGetParent{"Node", "get_parent"}, kEmitSignal{"Object", "emit_signal"}, kConnect{"Object", "connect"},
    kDisconnect{"Object", "disconnect"}, kIsEditor{"_Engine", "is_editor_hint"}, kHasFeature{"_OS", "has_feature"};

}  // namespace

void VoxelWorld::registerClass(void* handle) {
    using gd::Type;
    NodeClass<VoxelWorld>(handle, "VoxelWorld", "Spatial")
        .method<&VoxelWorld::enterTree>("_enter_tree")
        .method<&VoxelWorld::exitTree>("_exit_tree")
        .method<&VoxelWorld::physicsProcess>("_physics_process")
        .method<&VoxelWorld::drawWorld>("_draw_world")
        .method<&VoxelWorld::breakAt>("break_at")
        .method<&VoxelWorld::explode>("explode")
        .method<&VoxelWorld::castRay>("cast_ray")
        .method<&VoxelWorld::pieceCount>("piece_count")
        .method<&VoxelWorld::removedVoxels>("removed_voxels")
        .method<&VoxelWorld::bodyCount>("body_count")
        .method<&VoxelWorld::changedState>("changed_gl_state")
        .method<&VoxelWorld::layers>("layers")
        .method<&VoxelWorld::reload>("reload")
        .property<&VoxelWorld::level>("level", {gd::kHintFile, "*.rubble,*.vox"})
        .property<&VoxelWorld::preset>("preset", {gd::kHintEnum, "draft,fast,balanced,accurate"})
        .property<&VoxelWorld::sky>("sky")
        .property<&VoxelWorld::godotLights>("godot_lights")
        .property<&VoxelWorld::brightness>("brightness", {gd::kHintRange, "0.01,4,0.01"})
        .property<&VoxelWorld::waitForShadow>("wait_for_shadow")
        .property<&VoxelWorld::checkState>("check_gl_state")
        .signal("piece_made", {{"body", Type::Int}, {"position", Type::Vector3}, {"voxels", Type::Int}})
        .signal("broken", {{"position", Type::Vector3}, {"radius", Type::Real}, {"voxels", Type::Int}})
        .signal("hit", {{"position", Type::Vector3}, {"impulse", Type::Real}, {"speed", Type::Real}});
}

VoxelWorld* VoxelWorld::above(gd::Object* node) {
    for (gd::Object* at = kGetParent(node).as<gd::Object*>(); at; at = kGetParent(at).as<gd::Object*>())
        if (const auto found = g_worlds.find(at); found != g_worlds.end())
            return found->second->m_world ? found->second : nullptr;
    return nullptr;
}

bool VoxelWorld::check(rubble_result result, const char* what) const {
    if (result == RUBBLE_OK) return true;
    printError(std::string(what) + ": " + (m_api ? m_api->get_last_error() : "librubble is of another version"));
    return false;
}

void VoxelWorld::open() {
    uint32_t layers = 0;
    if (!check(rubble_get_api(RUBBLE_VERSION, &m_api), "rubble_get_api")) return;
    const rubble_host host = hostServices();
    if (!check(m_api->set_host(&host), "set_host") || !check(m_api->get_layers(&layers), "get_layers")) return;
    rubble_world_settings settings = {.struct_size = sizeof settings};
    const bool moves = layers & RUBBLE_LAYER_PHYSICS, draws = !kHasFeature(singleton("OS"), "Server").as<bool>();
    const bool renders = draws && layers & RUBBLE_LAYER_RENDERER;
    settings.flags = (renders ? 0 : RUBBLE_WORLD_NO_RENDERER) | (moves ? 0 : RUBBLE_WORLD_HOST_PHYSICS) |
                     (waitForShadow ? RUBBLE_WORLD_WAIT_FOR_SHADOW : 0);
    if (!check(m_api->create_world(&settings, &m_world), "create_world")) return;
    if (moves) {
        rubble_report_filter filter = {.struct_size = sizeof filter, .kinds = RUBBLE_REPORT_CONTACT_HIT};
        filter.min_impulse = 5.0, filter.min_hit_speed = 1.0;
        check(m_api->set_report_filter(m_world, &filter), "set_report_filter");
    } else {
        m_bodies = std::make_unique<GodotBodies>(*this);
    }
    if (renders)
        m_view = std::make_unique<WorldView>(*this);
    else if (draws)
        m_meshes = std::make_unique<BrickMeshes>(*this);
    loadLevel();
}

void VoxelWorld::close() {
    m_meshes.reset();
    m_bodies.reset();
    m_view.reset();
    if (m_world) check(m_api->destroy_world(m_world), "destroy_world");
    m_world = 0;
    g_worlds.erase(m_node);
}

bool VoxelWorld::loadLevel() {
    std::vector<uint8_t> bytes;
    if (level.empty()) return true;
    if (!readFile(level, bytes)) {
        printError("VoxelWorld.level: expected a file that can be read, found \"" + level + "\"");
        return false;
    }
    return check(m_api->load_level_data(m_world, bytes.data(), bytes.size()), "load_level_data");
}

void VoxelWorld::add(WorldChild& child) {
    m_children.push_back(&child);
    child.spawn();
}

void VoxelWorld::remove(WorldChild& child) {
    m_children.erase(std::remove(m_children.begin(), m_children.end(), &child), m_children.end());
}

Variant VoxelWorld::enterTree(Arguments) {
    if (kIsEditor(singleton("Engine")).as<bool>()) return {};
    g_worlds[m_node] = this;
    open();
    if (m_view) kConnect(singleton("VisualServer"), "frame_pre_draw", m_node, "_draw_world");
    return {};
}

Variant VoxelWorld::exitTree(Arguments) {
    if (m_view) kDisconnect(singleton("VisualServer"), "frame_pre_draw", m_node, "_draw_world");
    close();
    return {};
}

/// What a world without a level begins with comes from its children alone.
bool VoxelWorld::destroyBodies() {
    uint32_t count = 0;
    if (!check(m_api->get_objects(m_world, RUBBLE_KIND_BODY, nullptr, 0, &count), "reload")) return false;
    std::vector<uint64_t> bodies(count);
    if (!check(m_api->get_objects(m_world, RUBBLE_KIND_BODY, bodies.data(), count, &count), "reload")) return false;
    return std::all_of(bodies.begin(), bodies.end(),
                       [&](uint64_t body) { return check(m_api->destroy_body(m_world, body), "reload"); });
}

Variant VoxelWorld::reload(Arguments) {
    if (!m_world || !(level.empty() ? destroyBodies() : loadLevel())) return {};
    if (m_bodies) m_bodies->clear();
    m_lights.forget();
    for (WorldChild* child : m_children) child->spawn();
    return {};
}

Variant VoxelWorld::physicsProcess(Arguments) {
    if (!m_world) return {};
    if (m_bodies) m_bodies->tell();
    if (!check(m_api->step(m_world), "step")) return {};
    if (m_bodies) m_bodies->follow();
    if (m_meshes) m_meshes->follow();
    if (m_view && godotLights) m_lights.follow();
    reportBreaks();
    reportHits();
    return {};
}

Variant VoxelWorld::drawWorld(Arguments) {
    if (m_view) m_view->draw();
    return {};
}

void VoxelWorld::reportBreaks() {
    rubble_events events = {.struct_size = sizeof events};
    if (!check(m_api->get_events(m_world, &events), "get_events")) return;
    for (uint32_t i = 0; i < events.removed_count; ++i) m_removed += int64_t(events.removed[i].count);
    m_pieces += events.split_count;
    // Copies: what listens to a signal may load a level, and with it the events are gone.
    const std::vector<rubble_shape_split> splits(events.splits, events.splits + events.split_count);
    const std::vector<rubble_dust_cloud> clouds(events.dust_clouds, events.dust_clouds + events.dust_cloud_count);
    for (const rubble_shape_split& split : splits) {
        rubble_shape_state piece = {};
        m_api->get_shape_state(m_world, split.piece, &piece);  // zeros of one that is gone already
        kEmitSignal(m_node, "piece_made", piece.body, toVec3(piece.position), piece.voxel_count);
    }
    for (const rubble_dust_cloud& cloud : clouds)
        kEmitSignal(m_node, "broken", toVec3(cloud.position), cloud.radius, cloud.count);
}

void VoxelWorld::reportHits() {
    if (m_bodies) {
        for (const rubble_impact& impact : m_bodies->impacts())
            kEmitSignal(m_node, "hit", toVec3(impact.position), impact.impulse, impact.speed);
        return;
    }
    rubble_reports reports = {.struct_size = sizeof reports};
    if (!check(m_api->get_reports(m_world, &reports), "get_reports")) return;
    const std::vector<rubble_contact> contacts(reports.contacts, reports.contacts + reports.contact_count);
    for (const rubble_contact& contact : contacts)
        kEmitSignal(m_node, "hit", toVec3(contact.position), contact.impulse, contact.hit_speed);
}

Variant VoxelWorld::breakAt(Arguments arguments) {
    if (!m_world) return {};
    const double radius = arguments.get<double>(1, 0.7);
    rubble_break edit = {.struct_size = sizeof edit, .radii = {radius, 0.8 * radius, 0.4 * radius}};
    copy(arguments.get<Vec3>(0), edit.position);
    check(m_api->break_voxels(m_world, &edit), "break_at");
    return {};
}

Variant VoxelWorld::explode(Arguments arguments) {
    if (!m_world) return {};
    rubble_explosion explosion = {.struct_size = sizeof explosion, .size = arguments.get<double>(1, 1.0)};
    copy(arguments.get<Vec3>(0), explosion.position);
    check(m_api->explode(m_world, &explosion), "explode");
    return {};
}

Variant VoxelWorld::castRay(Arguments arguments) {
    double from[3], to[3], direction[3], length = 0;
    rubble_hit hit = {};
    if (!m_world) return Variant::array({});
    copy(arguments.get<Vec3>(0), from), copy(arguments.get<Vec3>(1), to);
    for (int i = 0; i < 3; ++i) direction[i] = to[i] - from[i], length += direction[i] * direction[i];
    if (!check(m_api->cast_ray(m_world, from, direction, std::sqrt(length), &hit), "cast_ray") || !hit.hit)
        return Variant::array({});
    return Variant::array({toVec3(hit.position), toVec3(hit.normal), Variant(hit.body)});
}

Variant VoxelWorld::bodyCount(Arguments) {
    uint32_t count = 0;
    if (m_world) check(m_api->get_body_states(m_world, nullptr, 0, &count), "body_count");
    return count;
}

Variant VoxelWorld::layers(Arguments) {
    uint32_t layers = 0;
    if (m_api) check(m_api->get_layers(&layers), "layers");
    return layers;
}

}  // namespace rubble_godot
