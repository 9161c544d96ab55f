#include <fmt/format.h>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

class BudgetCheck final : public Check {
public:
    const char* name() const override { return "budgets"; }

    std::string atBorder(const StepView& view) override {
        auto settings = rubble::script::sized<rubble_settings>();
        view.api.get_settings(view.world, &settings);
        uint64_t voxels = 0;
        uint32_t bodies = 0, awake = 0;
        for (const BodyRow& body : view.bodies) {
            if (!body.isDynamic()) continue;
            const uint64_t size = piecesOf(view, body.state.body);
            if (!size || size > settings.largest_debris) continue;
            voxels += size;
            ++bodies;
            awake += !(body.state.flags & RUBBLE_BODY_ASLEEP);
        }
        if (voxels > settings.debris_voxels)
            return fmt::format("expected at most {} voxels in pieces, found {}", settings.debris_voxels, voxels);
        if (bodies > settings.debris_bodies)
            return fmt::format("expected at most {} pieces, found {}", settings.debris_bodies, bodies);
        if (awake > settings.awake_debris_bodies)
            return fmt::format("expected at most {} awake pieces, found {}", settings.awake_debris_bodies, awake);
        return {};
    }

private:
    /// The voxels of a body if all of it came off other shapes; else 0.
    static uint64_t piecesOf(const StepView& view, rubble_body body) {
        uint64_t count = 0;
        for (const rubble_shape_state& shape : shapesOf(view.api, view.world, body)) {
            auto properties = rubble::script::sized<rubble_shape_properties>();
            view.api.get_shape_properties(view.world, shape.shape, &properties);
            if (!properties.is_piece) return 0;
            for (const uint8_t index : voxelsOf(view.api, view.world, shape)) count += index != 0;
        }
        return count;
    }
};

}  // namespace

std::unique_ptr<Check> makeBudgetCheck() {
    return std::make_unique<BudgetCheck>();
}

}  // namespace stress
