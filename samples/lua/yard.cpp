#include "samples/lua/yard.h"

#include <algorithm>
#include <array>

namespace lua_sample {
namespace {

using Place = std::array<double, 3>;

/// Makes things with tags, and remembers the first thing that goes wrong.
class Builder {
public:
    Builder(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) {}
    const std::string& error() const { return m_error; }

    struct Box {
        rubble_body body;
        rubble_shape shape;
    };
    Box box(const char* tag, uint32_t flags, const Place& corner, const std::array<int32_t, 3>& size, uint32_t entry) {
        Box made = {};
        rubble_body_settings body = {.struct_size = sizeof body, .flags = flags};
        std::copy(corner.begin(), corner.end(), body.position);
        check(m_api.create_body(m_world, &body, &made.body));
        rubble_shape_settings shape = {.struct_size = sizeof shape, .source = RUBBLE_SHAPE_BOX};
        shape.body = made.body;
        std::copy(size.begin(), size.end(), shape.size);
        shape.index = entry;
        check(m_api.create_shape(m_world, &shape, &made.shape));
        this->tag(made.body, tag);
        this->tag(made.shape, tag);
        return made;
    }
    void joint(const char* tag, rubble_joint_settings settings, const Box& first, const Box& second) {
        settings.struct_size = sizeof settings;
        settings.shapes[0] = first.shape;
        settings.shapes[1] = second.shape;
        rubble_joint made = 0;
        check(m_api.create_joint(m_world, &settings, &made));
        this->tag(made, tag);
    }
    void light(const char* tag, const Place& place) {
        rubble_light_settings light = {.struct_size = sizeof light, .kind = RUBBLE_LIGHT_SPHERE};
        light.flags = RUBBLE_LIGHT_ENABLED;
        std::copy(place.begin(), place.end(), light.position);
        std::fill_n(light.color, 3, 20.0);
        light.radius = 0.1;
        light.reach = 10.0;
        rubble_light made = 0;
        check(m_api.create_light(m_world, &light, &made));
        this->tag(made, tag);
    }
    void trigger(const char* tag, const Place& place, double radius) {
        rubble_trigger_settings trigger = {.struct_size = sizeof trigger, .kind = RUBBLE_TRIGGER_SPHERE};
        std::copy(place.begin(), place.end(), trigger.position);
        trigger.radius = radius;
        rubble_trigger made = 0;
        check(m_api.create_trigger(m_world, &trigger, &made));
        this->tag(made, tag);
    }
    void check(rubble_result result) {
        if (result != RUBBLE_OK && m_error.empty()) m_error = m_api.get_last_error();
    }

private:
    void tag(uint64_t object, const char* name) { check(m_api.set_tag(m_world, object, name, nullptr)); }

    const rubble_api& m_api;
    rubble_world m_world;
    std::string m_error;
};

constexpr uint32_t kConcrete = 6, kWood = 5, kBrick = 7;

}  // namespace

std::string buildYard(const rubble_api& api, rubble_world world) {
    Builder yard(api, world);
    yard.box("floor", RUBBLE_BODY_STATIC, {-10, -0.2, -10}, {200, 2, 200}, kConcrete);
    yard.box("wall", RUBBLE_BODY_STATIC, {-2, 0, 0}, {40, 25, 3}, kBrick);
    yard.box("crate", 0, {-0.4, 0, -2}, {8, 8, 8}, kWood);
    const auto post = yard.box("post", RUBBLE_BODY_STATIC, {4, 0, 0}, {2, 20, 2}, kConcrete);
    const auto door = yard.box("door", 0, {4.2, 0.1, 0}, {10, 18, 1}, kWood);
    rubble_joint_settings hinge = {.kind = RUBBLE_JOINT_HINGE, .position = {4.2, 1.0, 0.05}};
    hinge.rotation[2] = hinge.rotation[3] = 0.70710678118654752;  // its axis is y
    yard.joint("hinge", hinge, post, door);
    const auto gallows = yard.box("gallows", RUBBLE_BODY_STATIC, {-5.5, 0, 0}, {10, 40, 1}, kConcrete);
    const auto weight = yard.box("weight", 0, {-5.2, 1.0, -0.8}, {4, 4, 4}, kWood);
    rubble_joint_settings rope = {.kind = RUBBLE_JOINT_ROPE, .position = {-5.0, 3.9, 0.05}};
    rope.rope_end[0] = -5.0, rope.rope_end[1] = 1.35, rope.rope_end[2] = -0.6;
    yard.joint("rope", rope, gallows, weight);
    yard.light("bulb", {0, 3, -1.6});
    yard.trigger("gate", {0, 0.4, -1.6}, 1.5);
    yard.check(api.step(world));
    return yard.error();
}

}  // namespace lua_sample
