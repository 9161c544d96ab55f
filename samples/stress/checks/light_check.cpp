#include <fmt/format.h>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using rubble::script::sized;

class LightCheck final : public Check {
public:
    const char* name() const override { return "lights"; }

    std::string afterStep(const StepView& view) override {
        if (view.events.shapes_destroyed_count || view.events.light_groups_out_count) return atBorder(view);
        return {};
    }

    std::string atBorder(const StepView& view) override {
        const auto lights = readRows<rubble_light>([&](rubble_light* out, uint32_t capacity, uint32_t* count) {
            return view.api.get_lights(view.world, out, capacity, count);
        });
        for (const rubble_light handle : lights) {
            auto light = sized<rubble_light_settings>();
            if (view.api.get_light_settings(view.world, handle, &light) != RUBBLE_OK)
                return fmt::format("light {:x} is listed: {}", handle, view.api.get_last_error());
            rubble_shape_state shape = {};
            if (light.shape && view.api.get_shape_state(view.world, light.shape, &shape) != RUBBLE_OK)
                return fmt::format("light {:x} is on shape {:x}, which is gone", handle, light.shape);
        }
        return {};
    }
};

}  // namespace

std::unique_ptr<Check> makeLightCheck() {
    return std::make_unique<LightCheck>();
}

}  // namespace stress
