#include <fmt/format.h>

#include <optional>

#include "runtime/script/binding/calls.h"
#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using rubble::script::sized;

/// What a change is done to.
struct Target {
    const rubble_api& api;
    rubble_world world;
    const BodyRow* body;       ///< the first free one
    rubble_shape_state shape;  ///< its first shape
};

/// A change of one value of a world.
struct Change {
    const char* what;
    rubble_result (*apply)(const Target&);
    bool mayFade = false;  ///< whether a step may take it away, as a joint takes a spin
};

rubble_result changeBody(const Target& to, uint32_t fields, double rubble_body_change::*value, double number) {
    auto change = sized<rubble_body_change>();
    change.fields = fields;
    change.body = to.body->state.body;
    change.gravity_scale = to.body->properties.gravity_scale;
    change.linear_damping = to.body->properties.linear_damping;
    change.angular_damping = to.body->properties.angular_damping;
    change.*value = number;
    return to.api.set_body(to.world, &change);
}

rubble_result changeShape(const Target& to, uint32_t fields, double rubble_shape_change::*value, double number) {
    auto change = sized<rubble_shape_change>();
    change.fields = fields;
    change.shape = to.shape.shape;
    change.*value = number;
    return to.api.set_shape(to.world, &change);
}

rubble_result turn(const Target& to) {
    auto change = sized<rubble_body_change>();
    change.fields = RUBBLE_SET_VELOCITY;
    change.body = to.body->state.body;
    change.angular_velocity[1] = 0.25;
    return to.api.set_body(to.world, &change);
}
rubble_result tint(const Target& to) {
    auto range = sized<rubble_palette_range>();
    range.shape = to.shape.shape, range.first = 7, range.count = 1;
    rubble_palette_entry entry = {};
    entry.opacity = 255, entry.material = 7, entry.color[1] = 17;
    return to.api.set_palette(to.world, &range, &entry);
}
rubble_result addGroup(const Target& to) {
    auto settings = sized<rubble_light_group_settings>();
    rubble_light_group out = 0;
    return to.api.create_light_group(to.world, &settings, &out);
}
rubble_result turnGravity(const Target& to) {
    auto environment = sized<rubble_environment>();
    to.api.get_environment(to.world, &environment);
    environment.gravity[0] += 0.125;
    return to.api.set_environment(to.world, &environment);
}
rubble_result setThreshold(const Target& to) {
    auto settings = sized<rubble_settings>();
    to.api.get_settings(to.world, &settings);
    settings.impact_threshold = settings.impact_threshold == 77.0 ? 78.0 : 77.0;
    return to.api.set_settings(to.world, &settings);
}

constexpr Change kChanges[] = {
    {"gravity scale of a body",
     [](const Target& to) {
         return changeBody(to, RUBBLE_SET_GRAVITY_SCALE, &rubble_body_change::gravity_scale, 0.5);
     }},
    {"linear damping of a body",
     [](const Target& to) { return changeBody(to, RUBBLE_SET_DAMPING, &rubble_body_change::linear_damping, 0.75); }},
    {"angular damping of a body",
     [](const Target& to) { return changeBody(to, RUBBLE_SET_DAMPING, &rubble_body_change::angular_damping, 0.75); }},
    {"angular velocity of a body", turn, true},
    {"density of a shape",
     [](const Target& to) { return changeShape(to, RUBBLE_SHAPE_DENSITY, &rubble_shape_change::density, 1.5); }},
    {"strength of a shape",
     [](const Target& to) { return changeShape(to, RUBBLE_SHAPE_STRENGTH, &rubble_shape_change::strength, 1.5); }},
    {"emission of a shape",
     [](const Target& to) { return changeShape(to, RUBBLE_SHAPE_EMISSION, &rubble_shape_change::emission, 1.5); }},
    {"a palette", tint},
    {"a tag", [](const Target& to) { return to.api.set_tag(to.world, to.shape.shape, "changed", "yes"); }},
    {"a name", [](const Target& to) { return to.api.set_name(to.world, to.shape.shape, "changed"); }},
    {"a user value", [](const Target& to) { return to.api.set_user_value(to.world, to.shape.shape, 77); }},
    {"a light group", addGroup},
    {"gravity", turnGravity},
    {"a setting", setThreshold},
};

/// Both hashes of a world, and how the body in it spins.
struct Hashes {
    uint64_t state = 0, resolved = 0;
    rubble::script::Vector spin{};
};

/// The hashes of a copy after a step, with a change before it or without; none if what was changed is gone.
std::optional<Hashes> hashesAfter(const StepView& view, const BodyRow* body, const Change* change, std::string& error) {
    const LoadedCopy copy(view.api, view.game, RUBBLE_WORLD_NO_RENDERER);
    Hashes hashes;
    if (!copy.error().empty()) return {};  // the check of saves says so
    BodyRow moved = *body;
    rubble_shape_state shape = {};
    if (change) {
        view.api.translate_handle(copy.world(), body->state.body, &moved.state.body);
        const auto shapes = shapesOf(view.api, copy.world(), moved.state.body);
        if (shapes.empty()) return {};
        shape = shapes[0];
        if (change->apply({view.api, copy.world(), &moved, shape}) != RUBBLE_OK) error = view.api.get_last_error();
    }
    view.api.step(copy.world());
    if (change && view.api.get_shape_state(copy.world(), shape.shape, &shape) != RUBBLE_OK) return {};
    view.api.get_state_hash(copy.world(), &hashes.state);
    view.api.get_resolved_hash(copy.world(), &hashes.resolved);
    rubble_body_state state = {};
    view.api.translate_handle(copy.world(), body->state.body, &moved.state.body);
    view.api.get_body_state(copy.world(), moved.state.body, &state);
    hashes.spin = rubble::script::vectorOf(state.angular_velocity);
    return hashes;
}

class HashCheck final : public Check {
public:
    const char* name() const override { return "hash"; }

    /// One change at each border, so that a run looks at all of them.
    std::string atBorder(const StepView& view) override {
        const BodyRow* body = nullptr;
        for (const BodyRow& row : view.bodies)
            if (!body && row.isDynamic()) body = &row;
        if (!body) return {};
        std::string error;
        const auto same = hashesAfter(view, body, nullptr, error);
        for (size_t i = 0; i < kChangesAtBorder && error.empty(); ++i) {
            const Change& change = kChanges[m_next++ % std::size(kChanges)];
            const auto other = hashesAfter(view, body, &change, error);
            if (!same || !other || (change.mayFade && same->spin == other->spin)) continue;
            if (same->state == other->state || same->resolved == other->resolved)
                return fmt::format("worlds that differ in {} have the same hash", change.what);
        }
        return error;
    }

private:
    static constexpr size_t kChangesAtBorder = 5;
    size_t m_next = 0;
};

}  // namespace

std::unique_ptr<Check> makeHashCheck() {
    return std::make_unique<HashCheck>();
}

}  // namespace stress
