#include <fmt/format.h>

#include <cmath>

#include "runtime/script/binding/calls.h"
#include "runtime/script/binding/vector_math.h"
#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using namespace rubble::script;

/// Joules gained, as a share of those lost: what a cut leaves overlapping parts, and gains a little.
constexpr double kMaxGainShare = 0.02;
constexpr double kMaxGain = 10.0;  ///< joules beside that

double energyOf(const BodyRow& body, const Vector& gravity) {
    const Placement frame = placementOf(body.state.position, body.state.rotation);
    const Vector center = toParent(frame, vectorOf(body.properties.center));
    const Vector velocity = vectorOf(body.state.velocity);
    const Vector w = rotated(inverse(frame.rotation), vectorOf(body.state.angular_velocity));
    const double* i = body.properties.inertia;
    const double spin = i[0] * w[0] * w[0] + i[1] * w[1] * w[1] + i[2] * w[2] * w[2] +
                        2.0 * (i[3] * w[0] * w[1] + i[4] * w[1] * w[2] + i[5] * w[0] * w[2]);
    const double mass = body.properties.mass;
    return 0.5 * mass * dot(velocity, velocity) + 0.5 * spin -
           mass * body.properties.gravity_scale * dot(gravity, center);
}

class EnergyCheck final : public Check {
public:
    const char* name() const override { return "energy"; }
    void restart() override { m_lost = m_gained = 0.0; }

    std::string afterStep(const StepView& view) override {
        if (!view.requests.isClosed) return restart(), "";
        auto environment = sized<rubble_environment>();
        view.api.get_environment(view.world, &environment);
        const Vector gravity = vectorOf(environment.gravity);
        double change = 0.0;
        for (const BodyRow& now : view.bodies) {
            const BodyRow* old = StepView::find(view.before, now.state.body);
            if (!now.isDynamic() || !old || !old->isDynamic() || old->properties.mass != now.properties.mass) continue;
            change += energyOf(now, gravity) - energyOf(*old, gravity);
        }
        (change > 0.0 ? m_gained : m_lost) += std::abs(change);
        if (m_gained <= kMaxGain + kMaxGainShare * m_lost) return {};
        return fmt::format("bodies gained {:.0f} J while they lost {:.0f} J", m_gained, m_lost);
    }

private:
    double m_lost = 0.0, m_gained = 0.0;  ///< joules
};

}  // namespace

std::unique_ptr<Check> makeEnergyCheck() {
    return std::make_unique<EnergyCheck>();
}

}  // namespace stress
