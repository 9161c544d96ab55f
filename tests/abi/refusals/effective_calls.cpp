#include "tests/abi/refusals/effective_calls.h"

#include <algorithm>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

constexpr double kInside[3] = {30.45, 50.15, 0.45};  ///< of the shape that hangs from a rope
constexpr uint8_t kWood = 5;                         ///< of the palette of a new shape

void require(rubble_result result) {
    EXPECT_EQ(result, RUBBLE_OK) << api()->get_last_error();
}
void goInside(double (&place)[3]) {
    std::copy_n(kInside, 3, place);
}
rubble_shape shapeOf(const HostCall& call) {
    return call.world().live().at("rubble_shape");
}
void step(const HostCall& call) {
    require(api()->step(call.world().world()));
}
/// A box of voxels on a body; `x`: in its frame.
rubble_shape makeBox(const HostCall& call, rubble_body body, double x, int32_t side) {
    auto shape = sized<rubble_shape_settings>();
    shape.source = RUBBLE_SHAPE_BOX, shape.body = body, shape.position[0] = x;
    std::fill_n(shape.size, 3, side);
    rubble_shape made = 0;
    require(api()->create_shape(call.world().world(), &shape, &made));
    return made;
}

/// Its second end is on the shape; of a rope, the first one hangs below.
void holdInside(rubble_joint_settings& joint) {
    goInside(joint.position), goInside(joint.rope_end);
    if (joint.kind == RUBBLE_JOINT_ROPE) joint.position[1] -= 2.0;
}
/// A fire in the shape.
void burn(HostCall& call) {
    const rubble_world world = call.world().world();
    auto box = sized<rubble_voxel_box>();
    box.shape = shapeOf(call);
    std::fill_n(box.size, 3, 9);
    const std::vector<uint8_t> wood(729, kWood);
    require(api()->write_voxels(world, &box, wood.data(), wood.size()));
    step(call);
    auto heat = sized<rubble_heat>();
    heat.flags = RUBBLE_HEAT_IGNITE, heat.shape = box.shape, heat.joules = 1.0, heat.radius = 2.0;
    goInside(heat.position);
    require(api()->heat(world, &heat));
    step(call);
}
/// A wheel under the body.
void addWheel(HostCall& call) {
    auto frame = sized<rubble_body_settings>();
    frame.position[0] = 30.0, frame.position[1] = 49.4;
    rubble_body wheel = 0;
    require(api()->create_body(call.world().world(), &frame, &wheel));
    auto joint = sized<rubble_joint_settings>();
    joint.kind = RUBBLE_JOINT_WHEEL, joint.anchor_radius = 1.0, joint.drive_torque = 100.0, joint.max_steer_angle = 0.5;
    joint.shapes[0] = shapeOf(call), joint.shapes[1] = makeBox(call, wheel, 0.0, 5);
    joint.position[0] = 30.25, joint.position[1] = 49.65, joint.position[2] = 0.25;
    rubble_joint made = 0;
    require(api()->create_joint(call.world().world(), &joint, &made));
    step(call);
}
void grab(HostCall& call) {
    auto grab = sized<rubble_grab>();
    grab.body = call.world().live().at("rubble_body");
    goInside(grab.point), goInside(grab.target);
    require(api()->grab_body(call.world().world(), &grab));
    step(call);
}

const std::map<std::string, Prepare> kEffectiveCalls = {
    {"carve",
     [](HostCall& c) {
         auto& carve = c.at<rubble_carve>("carve");
         goInside(carve.position), goInside(carve.end);
     }},
    {"break_voxels", [](HostCall& c) { goInside(c.at<rubble_break>("edit").position); }},
    {"paint", [](HostCall& c) { goInside(c.at<rubble_paint>("paint").position); }},
    {"heat",
     [](HostCall& c) {
         auto& heat = c.at<rubble_heat>("heat");
         goInside(heat.position), heat.joules = 1e6;
     }},
    {"remove_fires",
     [](HostCall& c) {
         burn(c);
         std::fill_n(&c.at<double>("low"), 3, -100.0), std::fill_n(&c.at<double>("high"), 3, 100.0);
     }},
    {"add_joint", [](HostCall& c) { holdInside(c.at<rubble_joint_settings>("settings")); }},
    {"create_joint", [](HostCall& c) { holdInside(c.at<rubble_joint_settings>("settings")); }},
    {"drive_wheels",
     [](HostCall& c) {
         addWheel(c);
         auto& drive = c.at<rubble_drive>("drive");
         drive.throttle = 1.0, drive.steer = 0.5;
     }},
    {"grab_body",
     [](HostCall& c) {
         auto& grab = c.at<rubble_grab>("grab");
         goInside(grab.point), goInside(grab.target), grab.target[1] += 1.0;
     }},
    {"release_body",
     [](HostCall& c) {
         grab(c);
         c.at<rubble_release>("release").impulse[1] = 50.0;
     }},
    {"split_shape",
     [](HostCall& c) {
         std::vector<uint8_t> cells(27, 6);
         std::fill_n(cells.begin() + 9, 9, uint8_t(0));  // two plates
         auto shape = sized<rubble_shape_settings>();
         shape.source = RUBBLE_SHAPE_INDICES, shape.body = c.world().live().at("rubble_body");
         shape.position[0] = 2.0, shape.indices = cells.data(), shape.count = cells.size();
         std::fill_n(shape.size, 3, 3);
         rubble_shape made = 0;
         require(api()->create_shape(c.world().world(), &shape, &made));
         step(c);
         c.set("shape", made);
     }},
    {"merge_shape",
     [](HostCall& c) {
         const rubble_shape made = makeBox(c, c.world().live().at("rubble_body"), 0.9, 9);
         step(c);
         c.set("shape", made), c.set("into", shapeOf(c));
     }},
    {"trim_shape",
     [](HostCall& c) {
         auto resize = sized<rubble_resize>();
         resize.shape = shapeOf(c);
         std::fill_n(resize.size, 3, 20);
         require(api()->resize_shape(c.world().world(), &resize));
         step(c);
     }},
    {"set_user_value", [](HostCall& c) { c.set("value", uint64_t(7)); }},
    {"report_impacts",
     [](HostCall& c) {
         auto& impact = c.at<rubble_impact>("impacts");
         goInside(impact.position), impact.impulse = 1e6, impact.speed = 50.0;
     }},
};

}  // namespace

const std::map<std::string, Prepare>& effectiveCalls() {
    return kEffectiveCalls;
}

}  // namespace rubble
