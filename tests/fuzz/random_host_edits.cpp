// The edits among the calls of a random host.
#include "tests/fuzz/random_host.h"

namespace rubble {

void RandomHost::callWhole() {
    switch (m_decisions.below(10)) {
        case 0: {
            auto change = sized<rubble_body_change>();
            change.fields = m_decisions.oneIn(3) ? whole(256) : whole(16), change.body = any(bodies());
            change.gravity_scale = number(2.0), change.linear_damping = number(9.0);
            place(change.position), rotation(change.rotation);
            fill(change.velocity, 20.0), fill(change.angular_velocity, 20.0);
            return void(api().set_body(m_world, &change));
        }
        case 1:
            return void(m_decisions.oneIn(2) ? api().destroy_body(m_world, any(bodies()))
                                             : api().destroy_shape(m_world, any(shapes())));
        case 2:
        case 3:
            return callVoxels();
        case 4: {
            auto resize = sized<rubble_resize>();
            resize.shape = any(shapes());
            for (int i = 0; i < 3; ++i) {
                resize.low[i] = int32_t(whole(20)) - 8, resize.size[i] = int32_t(1 + whole(30));
            }
            return void(api().resize_shape(m_world, &resize));
        }
        case 5:
            return void(m_decisions.oneIn(2) ? api().split_shape(m_world, any(shapes()))
                                             : api().trim_shape(m_world, any(shapes())));
        case 6:
            return void(api().merge_shape(m_world, any(shapes()), m_decisions.oneIn(2) ? 0 : any(shapes())));
        case 7:
            return void(api().detach_joint(m_world, any(joints()), any(shapes())));
        case 8:
            return callFire();
        default:
            return callRows();
    }
}

void RandomHost::callVoxels() {
    const std::vector<rubble_shape_state> states = shapeStates(m_world);
    auto box = sized<rubble_voxel_box>();
    std::vector<uint8_t> cells;
    if (!states.empty() && m_decisions.oneIn(2)) {  // as the grid has it
        const rubble_shape_state& shape = states[m_decisions.below(uint32_t(states.size()))];
        if (shape.size[0] < 1 || shape.size[1] < 1 || shape.size[2] < 1) return;
        box.struct_size = sizeof(rubble_voxel_box), box.shape = shape.shape, cells.assign(1, 0);
        for (int i = 0; i < 3; ++i) {
            box.low[i] = int32_t(m_decisions.below(uint32_t(shape.size[i])));
            box.size[i] = int32_t(1 + m_decisions.below(uint32_t(shape.size[i] - box.low[i])));
            cells.resize(cells.size() * size_t(box.size[i]));
        }
        for (uint8_t& cell : cells) cell = uint8_t(m_decisions.oneIn(3) ? 0 : 1 + m_decisions.below(6));
        m_model->step();  // no edits wait
        for (const rubble_shape_state& now : shapeStates(m_world))
            if (now.shape == shape.shape && std::equal(now.size, now.size + 3, shape.size))
                return m_model->write(now, static_cast<rubble_voxel_box&>(box), cells);
        return;
    }
    box.what = whole(2), box.shape = any(shapes());
    for (int i = 0; i < 3; ++i) box.low[i] = int32_t(whole(12)) - 4, box.size[i] = int32_t(1 + whole(8));
    cells.resize(600);
    uint64_t count = 0;
    api().read_voxels(m_world, &box, cells.data(), whole(600), &count);
    const uint64_t size = uint64_t(box.size[0]) * uint64_t(box.size[1]) * uint64_t(box.size[2]);
    api().write_voxels(m_world, &box, cells.data(), std::min<uint64_t>(size, 600));
}

void RandomHost::callFire() {
    auto heat = sized<rubble_heat>();
    heat.flags = whole(2), place(heat.position);
    heat.radius = number(2.0), heat.joules = number(1e8), heat.shape = m_decisions.oneIn(2) ? 0 : any(shapes());
    api().heat(m_world, &heat);
    rubble_fire fires[4];
    uint32_t count = 0;
    api().get_fires(m_world, fires, 4, &count);
    double low[3], high[3];
    place(low), place(high);
    api().find_closest_fire(m_world, low, number(5.0), fires);
    api().count_fires(m_world, low, high, &count);
    if (count) reached("lists of fires");
    if (m_decisions.oneIn(3)) {
        auto water = sized<rubble_extinguish>();
        place(water.position), water.radius = number(2.0), water.wet_seconds = number(60.0);
        api().extinguish(m_world, &water);
    }
    if (m_decisions.oneIn(3)) api().remove_fires(m_world, low, high);
}

void RandomHost::callCreate() {
    auto frame = sized<rubble_body_settings>();
    frame.flags = whole(4), place(frame.position), rotation(frame.rotation);
    if (m_decisions.oneIn(4)) fill(frame.velocity, 10.0);
    rubble_body body = any(bodies());
    if (m_decisions.oneIn(2)) api().create_body(m_world, &frame, &body);
    const uint8_t cells[60] = {1, 2, 3, 0, 0, 6, 1, 1, 1};
    const rubble_voxel_run runs[3] = {{7, 1}, {whole(8), whole(7)}, {3, 2}};
    for (uint32_t i = m_decisions.below(3); i-- > 0;) {
        auto shape = sized<rubble_shape_settings>();
        shape.source = whole(6), shape.body = body, place(shape.position), rotation(shape.rotation);
        shape.size[0] = int32_t(1 + whole(5)), shape.size[1] = 4, shape.size[2] = 3;
        shape.index = whole(7), shape.indices = cells, shape.runs = runs;
        shape.count = shape.source == RUBBLE_SHAPE_RUNS ? m_decisions.below(4) : uint64_t(shape.size[0]) * 12;
        if (shape.source != RUBBLE_SHAPE_RUNS) shape.count = std::min<uint64_t>(shape.count, 60);
        shape.copied = any(shapes());
        if (m_decisions.oneIn(2)) shape.palette_of = any(shapes());
        rubble_shape made = 0;
        api().create_shape(m_world, &shape, &made);
        auto box = sized<rubble_voxel_box>();
        box.shape = made, box.size[0] = 2, box.size[1] = box.size[2] = 1, box.low[1] = int32_t(whole(4));
        if (m_decisions.oneIn(2)) api().write_voxels(m_world, &box, cells, 2);
        if (m_decisions.oneIn(8)) api().destroy_shape(m_world, made);
        auto joint = sized<rubble_joint_settings>();
        joint.kind = whole(7), joint.shapes[0] = made, joint.shapes[1] = any(shapes());
        place(joint.position), joint.anchor_radius = number(3.0);
        rubble_joint held = 0;
        if (m_decisions.oneIn(3)) api().create_joint(m_world, &joint, &held);
        auto light = sized<rubble_light_settings>();
        light.shape = made, light.reach = number(5.0);
        rubble_light heldLight = 0;
        if (m_decisions.oneIn(4)) api().create_light(m_world, &light, &heldLight);
    }
    auto change = sized<rubble_body_change>();
    change.fields = whole(64), change.body = body, place(change.position), fill(change.velocity, 5.0);
    api().set_body(m_world, &change);
    if (m_decisions.oneIn(8)) api().destroy_body(m_world, body);
    auto prefab = sized<rubble_prefab>();
    prefab.data = m_level.data(), prefab.size = m_level.size(), place(prefab.position), rotation(prefab.rotation);
    rubble_prefab_row rows[32];
    rubble_refusal refused[4];
    uint32_t count = 0;
    if (m_decisions.oneIn(8)) api().create_prefab(m_world, &prefab, rows, 32, &count);
    api().get_refusals(m_world, refused, 4, &count);
}

void RandomHost::callEdit() {
    switch (m_decisions.below(7)) {
        case 0: {
            auto carve = sized<rubble_carve>();
            carve.brush = whole(3), carve.max_hardness = whole(4), carve.tool = whole(5);
            place(carve.position), place(carve.end), rotation(carve.rotation);
            fill(carve.half_size, 1.0);
            carve.radii[0] = number(1.5), carve.radii[1] = carve.radii[0] * 0.7;
            if (m_decisions.oneIn(3)) carve.shape = any(shapes());
            return void(api().carve(m_world, &carve));
        }
        case 1: {
            auto edit = sized<rubble_break>();
            edit.tool = whole(5), edit.seed = whole(1000);
            place(edit.position);
            edit.radii[0] = number(1.5), edit.radii[1] = edit.radii[2] = edit.radii[0] * 0.5;
            return void(api().break_voxels(m_world, &edit));
        }
        case 2: {
            auto explosion = sized<rubble_explosion>();
            place(explosion.position);
            explosion.size = m_decisions.oneIn(2) ? 0.0 : number(4.0);
            explosion.impulse = m_decisions.oneIn(2) ? 0.0 : number(1e6);
            return void(api().explode(m_world, &explosion));
        }
        case 3: {
            auto paint = sized<rubble_paint>();
            place(paint.position);
            paint.radius = number(2.0), paint.strength = whole(256), paint.probability = whole(256);
            return void(api().paint(m_world, &paint));
        }
        case 4: {
            auto impulse = sized<rubble_impulse>();
            impulse.body = any(bodies());
            place(impulse.position), fill(impulse.impulse, 1e4);
            return void(api().apply_impulse(m_world, &impulse));
        }
        case 5: {
            auto round = sized<rubble_collision_shape>();
            round.kind = whole(6), round.shape = any(shapes());
            return void(api().set_collision_shape(m_world, &round));
        }
        default: {
            auto filter = sized<rubble_collision_filter>();
            filter.layer = whole(257), filter.mask = whole(257), filter.shape = any(shapes());
            return void(api().set_collision_filter(m_world, &filter));
        }
    }
}

void RandomHost::callJoint() {
    switch (m_decisions.below(6)) {
        case 0:
        case 1: {
            auto joint = sized<rubble_joint_settings>();
            joint.kind = whole(7), joint.flags = whole(4), joint.motor = whole(3);
            for (rubble_shape& shape : joint.shapes) shape = m_decisions.oneIn(3) ? 0 : any(shapes());
            place(joint.position), place(joint.rope_end), rotation(joint.rotation);
            joint.anchor_radius = number(2.0), joint.motor_target = number(3.0), joint.motor_max_force = number(1e4);
            joint.upper_limit = number(1.0), joint.spring_hertz = number(30.0), joint.friction = number(10.0);
            joint.break_force = number(1e5), joint.rope_length = number(4.0), joint.drive_torque = number(1e3);
            joint.max_steer_angle = number(1.0);
            return void(api().add_joint(m_world, &joint));
        }
        case 2: {
            auto motor = sized<rubble_joint_motor>();
            motor.joint = any(joints()), motor.motor = whole(3);
            motor.motor_target = number(3.0), motor.motor_max_force = number(1e4), motor.steer_angle = number(1.0);
            return void(api().set_joint_motor(m_world, &motor));
        }
        case 3: {
            auto drive = sized<rubble_drive>();
            drive.body = any(bodies());
            drive.throttle = number(1.0), drive.steer = number(-1.0), drive.brake = number(1.0);
            return void(api().drive_wheels(m_world, &drive));
        }
        case 4: {
            auto grab = sized<rubble_grab>();
            grab.hand = whole(3), grab.body = any(bodies());
            place(grab.point), place(grab.target);
            grab.max_force = number(1e4), grab.spring_hertz = number(10.0);
            fill(grab.velocity, 9.0), fill(grab.angular_velocity, 9.0);
            grab.flags = whole(4), rotation(grab.rotation), grab.max_torque = number(1e3);
            if (m_decisions.oneIn(2)) return void(api().grab_body(m_world, &grab));
            auto held = sized<rubble_body_constraint>();
            held.kind = whole(3), held.body = grab.body, held.other = m_decisions.oneIn(2) ? 0 : any(bodies());
            place(held.position), fill(held.direction, 1.0), held.speed = number(9.0);
            held.max_force = m_decisions.oneIn(2) ? 0.0 : number(1e5);
            return void(api().constrain_bodies(m_world, &held));
        }
        default: {
            auto release = sized<rubble_release>();
            release.hand = whole(3), fill(release.impulse, 100.0);
            api().release_body(m_world, &release);
            if (m_decisions.oneIn(3)) api().remove_joint(m_world, any(joints()));
            double points[30];
            uint32_t count = 0;
            api().get_rope_points(m_world, any(joints()), points, 30, &count);
            rubble_rope_point all[8];
            api().get_ropes(m_world, all, 8, &count);
        }
    }
}

void RandomHost::callRegion() {
    ObjectMirror& mirror = m_model->mirror();
    std::vector<double> outline;
    for (uint32_t i = 2 * (2 + m_decisions.below(5)); i-- > 0;) outline.push_back(number(4.0) - 1.0);
    if (m_decisions.oneIn(2)) {
        auto water = sized<rubble_water_settings>();
        water.outline = outline.data(), water.outline_count = uint32_t(outline.size() / 2);
        water.surface_height = number(2.0), water.depth = number(3.0), water.density = number(2000.0);
        water.linear_drag = number(5.0), fill(water.flow, 5.0);
        uint64_t made = 0;
        if (m_decisions.oneIn(2)) {
            if (api().create_water(m_world, &water, &made) == RUBBLE_OK) mirror.made(RUBBLE_KIND_WATER, made);
        } else if (api().add_water(m_world, &water) == RUBBLE_OK) {
            mirror.added(RUBBLE_KIND_WATER);
        }
    } else {
        auto trigger = sized<rubble_trigger_settings>();
        trigger.kind = whole(3), place(trigger.position), rotation(trigger.rotation);
        trigger.radius = number(2.0), fill(trigger.half_size, 2.0), trigger.height = number(3.0);
        trigger.outline = outline.data(), trigger.outline_count = uint32_t(outline.size() / 2);
        trigger.layer_mask = whole(257);
        uint64_t made = 0;
        if (m_decisions.oneIn(2)) {
            if (api().create_trigger(m_world, &trigger, &made) == RUBBLE_OK) mirror.made(RUBBLE_KIND_TRIGGER, made);
        } else if (api().add_trigger(m_world, &trigger) == RUBBLE_OK) {
            mirror.added(RUBBLE_KIND_TRIGGER);
        }
    }
    const uint64_t dry = m_decisions.oneIn(4) ? any(list(api().get_waters)) : 0;
    if (dry && api().remove_water(m_world, dry) == RUBBLE_OK) mirror.removed(RUBBLE_KIND_WATER, dry);
    const uint64_t left = m_decisions.oneIn(4) ? any(list(api().get_triggers)) : 0;
    if (left && api().remove_trigger(m_world, left) == RUBBLE_OK) mirror.removed(RUBBLE_KIND_TRIGGER, left);
    std::vector<rubble_trigger_event> events(8);
    uint32_t count = 0;
    api().get_trigger_events(m_world, events.data(), 8, &count);
}

void RandomHost::callCharacter() {
    ObjectMirror& mirror = m_model->mirror();
    if (m_decisions.oneIn(3)) {
        auto settings = sized<rubble_character_settings>();
        place(settings.position);
        settings.radius = m_decisions.oneIn(2) ? 0.0 : number(1.0);
        settings.height = m_decisions.oneIn(2) ? 0.0 : number(3.0);
        settings.walk_speed = number(10.0), settings.max_push_force = number(1e3);
        uint64_t made = 0;
        if (m_decisions.oneIn(2)) {
            if (api().create_character(m_world, &settings, &made) == RUBBLE_OK)
                mirror.made(RUBBLE_KIND_CHARACTER, made);
        } else if (api().add_character(m_world, &settings) == RUBBLE_OK) {
            mirror.added(RUBBLE_KIND_CHARACTER);
        }
    }
    auto move = sized<rubble_character_move>();
    move.flags = whole(4), move.character = any(characters()), fill(move.desired_velocity, 5.0);
    api().move_character(m_world, &move);
    auto teleport = sized<rubble_character_teleport>();
    teleport.character = any(characters()), place(teleport.position), fill(teleport.velocity, 20.0);
    if (m_decisions.oneIn(3)) api().teleport_character(m_world, &teleport);
    const uint64_t gone = m_decisions.oneIn(8) ? any(characters()) : 0;
    if (gone && api().remove_character(m_world, gone) == RUBBLE_OK) mirror.removed(RUBBLE_KIND_CHARACTER, gone);
}

void RandomHost::callLight() {
    auto weather = sized<rubble_environment>();
    api().get_environment(m_world, &weather);
    fill(weather.gravity, 20.0);
    weather.clouds = number(1.0), weather.fog_density = number(1.0);
    if (m_decisions.oneIn(2)) api().set_environment(m_world, &weather);
    auto light = sized<rubble_light_settings>();
    light.kind = whole(5), light.flags = whole(4), light.light = any(list(api().get_lights));
    light.shape = m_decisions.oneIn(2) ? 0 : any(shapes());
    place(light.position), rotation(light.rotation), fill(light.color, 100.0);
    light.radius = number(1.0), light.reach = number(20.0), light.width = number(2.0), light.height = number(2.0);
    m_decisions.oneIn(2) ? api().add_light(m_world, &light) : api().set_light(m_world, &light);
    if (m_decisions.oneIn(6)) api().remove_light(m_world, any(list(api().get_lights)));
}

void RandomHost::callObjects() {
    const char* texts[] = {"", "door", "key=1", "\xff", nullptr};
    const auto text = [&] { return texts[m_decisions.below(5)]; };
    const uint64_t object = m_decisions.oneIn(2) ? any(shapes()) : any(bodies());
    uint64_t found[4];
    char bytes[16];
    uint32_t count = 0;
    ObjectMirror& mirror = m_model->mirror();
    const char *name = text(), *tag = text(), *value = text(), *other = text();
    if (api().set_name(m_world, object, name) == RUBBLE_OK) mirror.setName(object, name);
    if (api().set_tag(m_world, object, tag, value) == RUBBLE_OK) mirror.setTag(object, tag, value);
    if (m_decisions.oneIn(3) && api().remove_tag(m_world, object, other) == RUBBLE_OK) mirror.removeTag(object, other);
    const uint64_t userValue = m_decisions.bits();
    if (api().set_user_value(m_world, object, userValue) == RUBBLE_OK) mirror.setUserValue(object, userValue);
    const rubble_level_script script = {name, value};
    if (userValue % 4 == 0) api().set_level_scripts(m_world, &script, uint32_t(userValue >> 2 & 1));
    api().get_name(m_world, object, bytes, m_decisions.below(17), &count);
    api().get_tag(m_world, object, text(), bytes, 16, &count);
    api().get_tags(m_world, object, bytes, 16, &count);
    api().get_user_value(m_world, object, found);
    api().get_objects(m_world, whole(8), found, 4, &count);
    api().get_objects_of(m_world, object, whole(8), found, 4, &count);
    api().find_by_name(m_world, whole(8), text(), found, 4, &count);
    api().find_by_tag(m_world, whole(8), text(), text(), found, 4, &count);
    api().get_origin(m_world, object, &found[0], &found[1]);
    api().get_pieces(m_world, object, found, 4, &count);
    auto settings = sized<rubble_settings>();
    api().get_settings(m_world, &settings);
    settings.flags = whole(16), settings.impact_radius = number(1.0), settings.split_parts = whole(5);
    settings.physics_preset = whole(4);
    if (m_decisions.oneIn(64)) api().set_physics_threads(m_world, m_decisions.oneIn(1024) ? 3 : whole(2));
    if (m_decisions.oneIn(2)) api().set_settings(m_world, &settings);
}

}  // namespace rubble
