#include "tests/abi/refusals/usual_calls.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

constexpr double kSquare[8] = {-10, -10, 10, -10, 10, 10, -10, 10};
constexpr rubble_cell_box kAnchor = {{0, 0, 0}, {1, 1, 1}};
constexpr uint8_t kCells[64] = {1, 2, 3};
constexpr rubble_voxel_run kRuns[1] = {{7, 1}};

void fillSize(int32_t (&size)[3], int32_t cells) {
    std::fill_n(size, 3, cells);
}
template <size_t kCount>
void fillAll(double (&values)[kCount], double value) {
    std::fill_n(values, kCount, value);
}

void prepareEnvironment(HostCall& call) {
    api()->get_environment(call.world().world(), &call.at<rubble_environment>("environment"));
}
/// A joint of a kind between a shape and the world.
template <uint32_t kKind>
void prepareJoint(HostCall& call) {
    auto& joint = call.at<rubble_joint_settings>("settings");
    joint.kind = kKind, joint.shapes[0] = 0, joint.flags = RUBBLE_JOINT_LIMITED;
    joint.upper_limit = 1.0, joint.rope_end[1] = 2.0;
}
template <uint32_t kFlags>
void prepareGrab(HostCall& call) {
    call.at<rubble_grab>("grab").flags = kFlags;
}
/// `name`: of the argument that says where the shape comes from.
template <uint32_t kSource>
void prepareShape(HostCall& call) {
    auto& shape = call.at<rubble_shape_settings>("settings");
    shape.source = kSource, shape.indices = kCells, shape.runs = kRuns;
    shape.count = kSource == RUBBLE_SHAPE_RUNS ? 1 : 64;
    fillSize(shape.size, 4);
}
template <uint32_t kKind>
void prepareRegion(rubble_query_shape& region) {
    region.kind = kKind, region.radius = 1.0, fillAll(region.half_size, 1.0);
}
template <uint32_t kKind>
void prepareOverlap(HostCall& call) {
    prepareRegion<kKind>(call.at<rubble_query_shape>("region"));
}
template <uint32_t kKind>
void prepareCast(HostCall& call) {
    auto& cast = call.at<rubble_shape_cast>("casts");
    prepareRegion<kKind>(cast.shape), cast.direction[1] = cast.max_distance = 1.0;
}
template <uint32_t kBrush>
void prepareCarve(HostCall& call) {
    auto& carve = call.at<rubble_carve>("carve");
    carve.brush = kBrush, fillAll(carve.radii, 0.5), fillAll(carve.half_size, 0.5);
}
void prepareWater(rubble_water_settings& water) {
    water.outline = kSquare, water.outline_count = 4;
}
template <uint32_t kKind>
void prepareTrigger(rubble_trigger_settings& trigger) {
    trigger.kind = kKind, trigger.outline = kSquare, trigger.outline_count = 4;
}
template <uint32_t kKind>
void prepareLight(rubble_light_settings& light) {
    light.kind = kKind, light.reach = 1.0;
}
/// kProjection: column-major; none: a field of view.
template <const double* kProjection>
void prepareView(HostCall& call) {
    auto& view = call.at<rubble_view>("view");
    view.framebuffer = drawTarget();
    view.width = view.height = 16;
    if (kProjection) std::copy_n(kProjection, 16, view.projection);
}
constexpr double kPerspective[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -0.2, 0};
constexpr double kOrthographic[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.01, 0, 0, 0, -1, 1};
void prepareRenderer(HostCall& call) {
    auto& settings = call.at<rubble_renderer_settings>("settings");
    settings.preset = "fast", settings.flags = RUBBLE_RENDERER_COMPILE_LATE;
}
void startLoading(HostCall& call) {
    api()->start_loading(call.world().world(), callFiles().level.c_str(), nullptr);
}
void preparePalette(HostCall& call) {
    call.at<rubble_palette_range>("range").count = 1;
}
void prepareTag(HostCall& call) {
    call.point("tag", "t");
}

/// `name`: of the argument.
void prepareOverlay(HostCall& call, const char* name, uint32_t kind, uint32_t flags) {
    static const uint8_t kPixel[4] = {};
    auto& item = call.at<rubble_overlay_item>(name);
    item.kind = kind, item.flags = flags, item.text = kind == RUBBLE_OVERLAY_IMAGE ? "i" : "text";
    item.transform[0] = item.transform[3] = item.clip[2] = item.clip[3] = item.source[2] = item.source[3] = 1.0;
    fillAll(item.size, 1.0);
    if (kind != RUBBLE_OVERLAY_IMAGE) return;
    auto image = sized<rubble_overlay_image>();
    image.name = "i", image.pixels = kPixel, image.width = image.height = 1;
    api()->set_overlay_image(call.world().live().at("rubble_renderer"), &image);
}
template <uint32_t kKind, uint32_t kFlags>
void prepareItem(HostCall& call) {
    prepareOverlay(call, "items", kKind, kFlags);
}
void prepareOverlayImage(HostCall& call) {
    static const uint8_t kPixel[4] = {};
    auto& image = call.at<rubble_overlay_image>("image");
    image.name = "i", image.pixels = kPixel, image.width = image.height = 1;
}

const std::map<std::string, std::vector<Prepare>> kUsualCalls = {
    {"load_level", {[](HostCall& c) { c.point("path", callFiles().level.c_str()); }}},
    {"start_loading", {[](HostCall& c) { c.point("path", callFiles().level.c_str()); }}},
    {"save_game", {[](HostCall& c) { c.point("path", callFiles().scratch.c_str()); }}},
    {"save_level", {[](HostCall& c) {
         static const std::string scratch = callFiles().scratch + ".rubble";
         c.point("path", scratch.c_str());
     }}},
    {"start_recording", {[](HostCall& c) { c.point("path", callFiles().scratch.c_str()); }}},
    {"load_game", {[](HostCall& c) { c.point("path", callFiles().save.c_str()); }}},
    {"play_recording", {[](HostCall& c) { c.point("path", callFiles().recording.c_str()); }}},
    {"load_level_data", {[](HostCall& c) {
         c.point("data", callFiles().levelData.data()), c.set("size", uint64_t(callFiles().levelData.size()));
     }}},
    {"load_game_data", {[](HostCall& c) {
         c.point("data", callFiles().saveData.data()), c.set("size", uint64_t(callFiles().saveData.size()));
     }}},
    {"play_recording_data", {[](HostCall& c) {
         c.point("data", callFiles().recordingData.data()), c.set("size", uint64_t(callFiles().recordingData.size()));
     }}},
    {"apply_deltas", {[](HostCall& c) {
         const std::vector<uint8_t>& leader = callFiles().leader;  // whose deltas they are
         api()->load_game_data(c.world().world(), leader.data(), leader.size());
         c.point("data", callFiles().deltas.data()), c.set("size", uint64_t(callFiles().deltas.size()));
     }}},
    {"save_game_data", {[](HostCall& c) { c.set("capacity", uint64_t(60'000)); }}},
    {"take_deltas", {[](HostCall& c) { c.set("capacity", uint64_t(60'000)); }}},
    {"carve", {prepareCarve<RUBBLE_BRUSH_SPHERE>, prepareCarve<RUBBLE_BRUSH_BOX>, prepareCarve<RUBBLE_BRUSH_CAPSULE>}},
    {"count_carve",
     {prepareCarve<RUBBLE_BRUSH_SPHERE>, prepareCarve<RUBBLE_BRUSH_BOX>, prepareCarve<RUBBLE_BRUSH_CAPSULE>}},
    {"break_voxels", {[](HostCall& c) { fillAll(c.at<rubble_break>("edit").radii, 0.5); }}},
    {"add_joint", {prepareJoint<RUBBLE_JOINT_CONE>, prepareJoint<RUBBLE_JOINT_ROPE>, prepareJoint<RUBBLE_JOINT_WHEEL>}},
    {"create_joint",
     {prepareJoint<RUBBLE_JOINT_CONE>, prepareJoint<RUBBLE_JOINT_ROPE>, prepareJoint<RUBBLE_JOINT_WHEEL>}},
    {"grab_body", {prepareGrab<RUBBLE_GRAB_TURNS>, prepareGrab<RUBBLE_GRAB_TURNS | RUBBLE_GRAB_VELOCITY>}},
    {"constrain_bodies", {[](HostCall& c) {
         auto& constraint = c.at<rubble_body_constraint>("constraint");
         constraint.other = 0, constraint.direction[1] = 1.0;
     }}},
    {"add_water", {[](HostCall& c) { prepareWater(c.at<rubble_water_settings>("water")); }}},
    {"create_water", {[](HostCall& c) { prepareWater(c.at<rubble_water_settings>("settings")); }}},
    {"add_trigger",
     {[](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_SPHERE>(c.at<rubble_trigger_settings>("trigger")); },
      [](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_BOX>(c.at<rubble_trigger_settings>("trigger")); },
      [](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_POLYGON>(c.at<rubble_trigger_settings>("trigger")); }}},
    {"create_trigger",
     {[](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_SPHERE>(c.at<rubble_trigger_settings>("settings")); },
      [](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_BOX>(c.at<rubble_trigger_settings>("settings")); },
      [](HostCall& c) { prepareTrigger<RUBBLE_TRIGGER_POLYGON>(c.at<rubble_trigger_settings>("settings")); }}},
    {"set_environment", {prepareEnvironment}},
    {"apply_sky_model", {[](HostCall& c) { prepareEnvironment(c), (&c.at<double>("sun_direction"))[1] = 1.0; }}},
    {"add_light", {[](HostCall& c) { prepareLight<RUBBLE_LIGHT_CONE>(c.at<rubble_light_settings>("light")); }}},
    {"set_light", {[](HostCall& c) { prepareLight<RUBBLE_LIGHT_CONE>(c.at<rubble_light_settings>("light")); }}},
    {"create_light", {[](HostCall& c) { prepareLight<RUBBLE_LIGHT_CONE>(c.at<rubble_light_settings>("settings")); }}},
    {"get_rope_points", {[](HostCall& c) { c.set("capacity", 1000u); }}},
    {"cast_ray", {[](HostCall& c) { (&c.at<double>("direction"))[1] = 1.0, c.set("max_distance", 5.0); }}},
    {"cast_rays", {[](HostCall& c) {
         auto& ray = c.at<rubble_ray>("rays");
         ray.direction[1] = ray.max_distance = 1.0;
     }}},
    {"cast_shapes",
     {prepareCast<RUBBLE_QUERY_SPHERE>, prepareCast<RUBBLE_QUERY_BOX>, prepareCast<RUBBLE_QUERY_CAPSULE>}},
    {"overlap_bodies",
     {prepareOverlap<RUBBLE_QUERY_SPHERE>, prepareOverlap<RUBBLE_QUERY_BOX>, prepareOverlap<RUBBLE_QUERY_CAPSULE>}},
    {"overlap_shapes",
     {prepareOverlap<RUBBLE_QUERY_SPHERE>, prepareOverlap<RUBBLE_QUERY_BOX>, prepareOverlap<RUBBLE_QUERY_CAPSULE>}},
    {"merge_shape", {[](HostCall& c) { c.set("into", uint64_t(0)); }}},
    {"resize_shape", {[](HostCall& c) { fillSize(c.at<rubble_resize>("resize").size, 9); }}},
    {"read_voxels",
     {[](HostCall& c) { fillSize(c.at<rubble_voxel_box>("box").size, 4), c.set("capacity", uint64_t(1000)); }}},
    {"write_voxels",
     {[](HostCall& c) { fillSize(c.at<rubble_voxel_box>("box").size, 4), c.set("size", uint64_t(64)); }}},
    {"set_body", {[](HostCall& c) {
         c.at<rubble_body_change>("change").fields =
             RUBBLE_SET_POSE | RUBBLE_SET_VELOCITY | RUBBLE_SET_GRAVITY_SCALE | RUBBLE_SET_DAMPING;
     }}},
    {"create_shape",
     {prepareShape<RUBBLE_SHAPE_BOX>, prepareShape<RUBBLE_SHAPE_INDICES>, prepareShape<RUBBLE_SHAPE_RUNS>,
      prepareShape<RUBBLE_SHAPE_COPY>}},
    {"create_prefab",
     {[](HostCall& c) { c.at<rubble_prefab>("prefab").path = callFiles().level.c_str(); },
      [](HostCall& c) {
          auto& prefab = c.at<rubble_prefab>("prefab");
          prefab.data = callFiles().levelData.data(), prefab.size = callFiles().levelData.size();
      }}},
    {"set_tag", {prepareTag}},
    {"remove_tag", {prepareTag}},
    {"get_tag", {prepareTag}},
    {"read_rows",
     {[](HostCall& c) { c.at<rubble_row_list>("list").kind = RUBBLE_ROWS_BODIES; },
      [](HostCall& c) { c.at<rubble_row_list>("list").kind = RUBBLE_ROWS_SHAPES; },
      [](HostCall& c) { c.at<rubble_row_list>("list").kind = RUBBLE_ROWS_MOVED_BODIES; }}},
    {"find_by_tag", {prepareTag}},
    {"get_objects_of", {[](HostCall& c) { c.set("kind", uint32_t(RUBBLE_KIND_SHAPE)); }}},
    {"set_settings", {[](HostCall& c) { api()->get_settings(c.world().world(), &c.at<rubble_settings>("settings")); }}},
    {"set_palette", {preparePalette}},
    {"get_palette", {preparePalette}},
    {"report_impacts", {[](HostCall& c) {
         auto& impact = c.at<rubble_impact>("impacts");
         impact.normal[1] = 1.0, impact.other = 0;
     }}},
    {"keep_deltas", {[](HostCall& c) { c.set("on", 1u); }, [](HostCall& c) { c.set("on", 2u); }}},
    {"get_loading_progress", {startLoading}},
    {"finish_loading", {startLoading}},
    {"set_materials", {[](HostCall& c) {
         c.set("first", 1u);
         api()->get_material(c.world().world(), 1, &c.at<rubble_material>("materials"));
     }}},
    {"set_shape",
     {[](HostCall& c) {
          auto& change = c.at<rubble_shape_change>("change");
          change.fields = RUBBLE_SHAPE_STRENGTH | RUBBLE_SHAPE_DENSITY | RUBBLE_SHAPE_EMISSION | RUBBLE_SHAPE_LOAD;
          change.strength = change.density = change.emission = 1.0;
      },
      [](HostCall& c) {
          auto& change = c.at<rubble_shape_change>("change");
          change.fields = RUBBLE_SHAPE_ANCHORS, change.anchors = &kAnchor, change.anchor_count = 1;
      },
      [](HostCall& c) { c.at<rubble_shape_change>("change").fields = RUBBLE_SHAPE_DEFAULT_ANCHORS; }}},
    {"set_physics_threads", {[](HostCall& c) { c.set("threads", 1u); }}},
    {"set_light_group", {[](HostCall& c) {
         auto& change = c.at<rubble_light_group_change>("change");
         change.fields = RUBBLE_GROUP_SWITCH | RUBBLE_GROUP_THRESHOLD | RUBBLE_GROUP_SUPPLY, change.on = 1;
     }}},
    {"mesh_brick", {[](HostCall& c) { c.set("capacity", 1000u); }}},
    {"read_bricks", {[](HostCall& c) { c.set("brick_count", 1u), c.set("capacity", uint64_t(2000)); }}},
    {"get_shadow_bricks", {[](HostCall& c) { c.set("capacity", 100u); }}},
    {"create_renderer", {prepareRenderer}},
    {"draw", {prepareView<nullptr>, prepareView<kPerspective>, prepareView<kOrthographic>}},
    {"set_level_scripts", {[](HostCall& c) {
         c.at<rubble_level_script>("scripts") = {"lift.lua", "speed=2\nheight=6"}, c.set("count", 1u);
     }}},
    {"set_host_data", {[](HostCall& c) { c.point("name", "n"), c.set("size", uint64_t(1)); }}},
    {"get_host_data", {[](HostCall& c) { c.point("name", "n"), c.set("capacity", uint64_t(100)); }}},
    {"set_overlay", {prepareItem<RUBBLE_OVERLAY_TEXT, RUBBLE_OVERLAY_IN_WORLD>, prepareItem<RUBBLE_OVERLAY_IMAGE, 0>}},
    {"set_overlay_image", {prepareOverlayImage}},
    {"measure_text", {[](HostCall& c) { prepareOverlay(c, "item", RUBBLE_OVERLAY_TEXT, 0); }}},
    {"set_debug_view", {[](HostCall& c) { c.point("name", "albedo"); }}},
};

std::vector<uint8_t> bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

const std::map<std::string, std::vector<Prepare>>& usualCalls() {
    return kUsualCalls;
}

unsigned& drawTarget() {
    static unsigned framebuffer = 0;
    return framebuffer;
}

const CallFiles& callFiles(const std::string& folder) {
    static const CallFiles files = [&] {
        CallFiles out;
        out.level = folder + "/level.rubble", out.save = folder + "/save.rubble";
        out.recording = folder + "/game.rubblelog", out.scratch = folder + "/scratch";
        std::filesystem::rename(writeTestLevel(), out.level);
        FullWorld world(out.level);
        EXPECT_EQ(api()->save_game(world.world(), out.save.c_str()), RUBBLE_OK) << api()->get_last_error();
        EXPECT_EQ(api()->start_recording(world.world(), out.recording.c_str()), RUBBLE_OK) << api()->get_last_error();
        world.step();
        EXPECT_EQ(api()->stop_recording(world.world()), RUBBLE_OK) << api()->get_last_error();
        FullWorld leader(out.level);
        uint64_t size = 60'000;
        out.leader.resize(size);
        EXPECT_EQ(api()->save_game_data(leader.world(), out.leader.data(), size, &size), RUBBLE_OK)
            << api()->get_last_error();
        out.leader.resize(size);
        leader.step();
        out.deltas.resize(60'000);
        size = out.deltas.size();
        EXPECT_EQ(api()->take_deltas(leader.world(), out.deltas.data(), size, &size), RUBBLE_OK)
            << api()->get_last_error();
        out.deltas.resize(size);
        out.levelData = bytesOf(out.level), out.saveData = bytesOf(out.save);
        out.recordingData = bytesOf(out.recording);
        return out;
    }();
    return files;
}

}  // namespace rubble
