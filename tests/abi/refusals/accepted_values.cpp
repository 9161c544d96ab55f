#include "tests/abi/refusals/accepted_values.h"

namespace rubble {
namespace {

const char* const kNeedsGl = "needs a context of OpenGL: tests/abi/renderer_test.cpp";

const std::map<std::string, std::string> kUncalled = {
    {"create_renderer", kNeedsGl},  {"draw", kNeedsGl}, {"set_debug_view", kNeedsGl}, {"get_draw_stats", kNeedsGl},
    {"destroy_renderer", kNeedsGl},
};

const char* const kNone = "0: none";
const char* const kWorld = "0: the world";
const char* const kAll = "0: all";
const char* const kNotRead = "the call does not read it";
const char* const kAny = "every number has a meaning";
const char* const kOptional = "it may be null";
const char* const kLength = "an array of the host is as long as it says: what is in it is refused";

const std::map<std::string, std::string> kAccepted = {
    {"add_joint settings.shapes: 0", "0 is the world: of both ends it is another error"},
    {"add_light light.group: 0", kNone},
    {"add_light light.light: 0", kNotRead},
    {"add_light light.light: nonsense", kNotRead},
    {"add_light light.light: of another kind", kNotRead},
    {"add_light light.light: of another world", kNotRead},
    {"add_light light.light: stale", kNotRead},
    {"add_light light.shape: 0", kWorld},
    {"break_voxels edit.seed: huge", kAny},
    {"break_voxels edit.shape: 0", kAll},
    {"carve carve.shape: 0", kAll},
    {"cast_rays filter.rejected_bodies: null", kOptional},
    {"cast_rays filter.rejected_body_count: huge", kLength},
    {"cast_rays filter.rejected_shape_count: huge", kLength},
    {"cast_rays filter.rejected_shapes: null", kOptional},
    {"cast_rays filter: null", kOptional},
    {"cast_shapes filter.rejected_bodies: null", kOptional},
    {"cast_shapes filter.rejected_body_count: huge", kLength},
    {"cast_shapes filter.rejected_shape_count: huge", kLength},
    {"cast_shapes filter.rejected_shapes: null", kOptional},
    {"cast_shapes filter: null", kOptional},
    {"create_joint settings.shapes: 0", "0 is the world: of both ends it is another error"},
    {"create_light settings.group: 0", kNone},
    {"create_light settings.light: 0", kNotRead},
    {"create_light settings.light: nonsense", kNotRead},
    {"create_light settings.light: of another kind", kNotRead},
    {"create_light settings.light: of another world", kNotRead},
    {"create_light settings.light: stale", kNotRead},
    {"create_light settings.shape: 0", kWorld},
    {"create_light_group settings.flicker_steps: huge", kAny},
    {"create_prefab prefab.path: null", "then its data are read"},
    {"create_prefab prefab.size: huge", kLength},
    {"create_prefab prefab.vdb_tool: null", kOptional},
    {"create_shape settings.count: huge", kLength},
    {"create_shape settings.palette_of: 0", kNone},
    {"create_world settings.user: null", kOptional},
    {"create_world settings: null", kOptional},
    {"find_by_tag value: null", kOptional},
    {"find_closest_point filter.query_size: huge", kNotRead},
    {"find_closest_point filter.rejected_bodies: null", kOptional},
    {"find_closest_point filter.rejected_body_count: huge", kLength},
    {"find_closest_point filter.rejected_shape_count: huge", kLength},
    {"find_closest_point filter.rejected_shapes: null", kOptional},
    {"find_closest_point filter: null", kOptional},
    {"get_shadow_bricks since: huge", "a version that is not there is stale"},
    {"get_changed_bricks changes.since: huge", "a version that is not there is stale"},
    {"get_pieces shape: stale", "the shape may be gone"},
    {"get_shape_states body: 0", kAll},
    {"heat heat.shape: 0", kAll},
    {"load_level vdb_tool: null", kOptional},
    {"merge_shape into: 0", kNone},
    {"overlap_bodies filter.hit_size: huge", kNotRead},
    {"overlap_bodies filter.query_size: huge", kNotRead},
    {"overlap_bodies filter.rejected_bodies: null", kOptional},
    {"overlap_bodies filter.rejected_body_count: huge", kLength},
    {"overlap_bodies filter.rejected_shape_count: huge", kLength},
    {"overlap_bodies filter.rejected_shapes: null", kOptional},
    {"overlap_bodies filter: null", kOptional},
    {"overlap_shapes filter.hit_size: huge", kNotRead},
    {"overlap_shapes filter.query_size: huge", kNotRead},
    {"overlap_shapes filter.rejected_bodies: null", kOptional},
    {"overlap_shapes filter.rejected_body_count: huge", kLength},
    {"overlap_shapes filter.rejected_shape_count: huge", kLength},
    {"overlap_shapes filter.rejected_shapes: null", kOptional},
    {"overlap_shapes filter: null", kOptional},
    {"paint paint.seed: huge", kAny},
    {"play_recording steps: null", kOptional},
    {"play_recording_data steps: null", kOptional},
    {"read_bricks bricks.is_empty: huge", kNotRead},
    {"read_bricks bricks.x: huge", "no brick is there: all are 0"},
    {"read_bricks bricks.x: negative", "no brick is there: all are 0"},
    {"read_bricks bricks.y: huge", "no brick is there: all are 0"},
    {"read_bricks bricks.y: negative", "no brick is there: all are 0"},
    {"read_bricks bricks.z: huge", "no brick is there: all are 0"},
    {"read_bricks bricks.z: negative", "no brick is there: all are 0"},
    {"read_rows list.body: 0", kAll},
    {"report_impacts impacts.other: 0", kNone},
    {"set_body_states states.shape_count: huge", kNotRead},
    {"set_host host.user: null", kOptional},
    {"set_host host: null", kOptional},
    {"set_light light.group: 0", kNone},
    {"set_light light.shape: 0", kWorld},
    {"set_light_group change.supply_shape: 0", kNone},
    {"set_palette entries.light_group: 0", kNone},
    {"set_settings settings.awake_debris_bodies: huge", kAny},
    {"set_settings settings.cracks_per_step: huge", kAny},
    {"set_settings settings.debris_bodies: huge", kAny},
    {"set_settings settings.debris_voxels: huge", kAny},
    {"set_settings settings.largest_debris: huge", kAny},
    {"set_settings settings.largest_stressed: huge", kAny},
    {"set_settings settings.max_fire_lights: huge", kAny},
    {"set_settings settings.max_fires: huge", kAny},
    {"set_settings settings.max_hot: huge", kAny},
    {"set_settings settings.min_piece_voxels: huge", kAny},
    {"set_settings settings.min_struck_voxels: huge", kAny},
    {"set_settings settings.settle_steps: huge", kAny},
    {"set_settings settings.split_parts: huge", kAny},
    {"set_tag value: null", kOptional},
    {"set_undo_limit marks: huge", kAny},
    {"set_user_value value: huge", kAny},
    {"start_loading vdb_tool: null", kOptional},
};

}  // namespace

const std::map<std::string, std::string>& acceptedValues() {
    return kAccepted;
}
const std::map<std::string, std::string>& uncalledFunctions() {
    return kUncalled;
}

}  // namespace rubble
