#include <fmt/format.h>

#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using namespace rubble::script;

constexpr double kStepSeconds = 1.0 / 60.0;
constexpr double kMaxVelocityError = 1e-6;  ///< m/s, and a share of the speed that a spin gives

/// The centre of mass in the world.
Vector centerOf(const BodyRow& body) {
    return toParent(placementOf(body.state.position, body.state.rotation), vectorOf(body.properties.center));
}

class MotionCheck final : public Check {
public:
    const char* name() const override { return "motion"; }

    std::string afterStep(const StepView& view) override {
        for (const BodyRow& body : view.bodies) {
            const rubble_body_state& state = body.state;
            double sum = 0.0;
            for (int i = 0; i < 3; ++i) sum += state.position[i] + state.velocity[i] + state.angular_velocity[i];
            for (const double value : state.rotation) sum += value;
            if (!std::isfinite(sum)) return fmt::format("body {:x}: a value that is not finite", state.body);
        }
        if (!view.requests.isFree) return {};
        for (uint32_t i = 0; i < view.events.split_count; ++i)
            if (std::string wrong = compare(view, view.events.splits[i]); !wrong.empty()) return wrong;
        return {};
    }

private:
    /// Whether a piece moves as the body moved that it came off.
    static std::string compare(const StepView& view, const rubble_shape_split& split) {
        rubble_shape_state piece = {}, parent = {};
        if (view.api.get_shape_state(view.world, split.piece, &piece) != RUBBLE_OK ||
            view.api.get_shape_state(view.world, split.parent, &parent) != RUBBLE_OK)
            return {};
        const BodyRow* now = StepView::find(view.bodies, piece.body);
        const BodyRow* old = StepView::find(view.before, parent.body);
        if (!now || !old || !old->isDynamic()) return {};
        const Vector began = centerOf(*now) - vectorOf(now->state.velocity) * kStepSeconds;
        const Vector arm = began - centerOf(*old), spin = vectorOf(old->state.angular_velocity);
        const Vector expected = vectorOf(old->state.velocity) + cross(spin, arm);
        const double error = length(vectorOf(now->state.velocity) - expected);
        const double turned = length(spin) * length(arm);
        if (error <= kMaxVelocityError * (1.0 + turned)) return {};
        return fmt::format("a piece of body {:x} moves {:.3g} m/s otherwise than it moved there", parent.body, error);
    }
};

}  // namespace

std::unique_ptr<Check> makeMotionCheck() {
    return std::make_unique<MotionCheck>();
}

}  // namespace stress
