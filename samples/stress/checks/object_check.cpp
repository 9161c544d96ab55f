#include <fmt/format.h>

#include <set>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

class ObjectCheck final : public Check {
public:
    const char* name() const override { return "objects"; }
    void restart() override { m_isKnown = false, m_bodies.clear(); }

    std::string afterStep(const StepView& view) override {
        const rubble_events& events = view.events;
        // Undo destroys and makes what has changed, with the same handle.
        const std::set<rubble_shape> made(events.shapes_created, events.shapes_created + events.shapes_created_count);
        const std::set<rubble_body> bodies(events.bodies_created, events.bodies_created + events.bodies_created_count);
        for (uint32_t i = 0; i < events.shapes_destroyed_count; ++i) {
            rubble_shape_state state = {};
            if (made.contains(events.shapes_destroyed[i])) continue;
            if (view.api.get_shape_state(view.world, events.shapes_destroyed[i], &state) == RUBBLE_OK)
                return fmt::format("shape {:x} was destroyed, and its handle still answers",
                                   events.shapes_destroyed[i]);
        }
        for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i)
            if (!bodies.contains(events.bodies_destroyed[i]) && StepView::find(view.bodies, events.bodies_destroyed[i]))
                return fmt::format("body {:x} was destroyed, and is still listed", events.bodies_destroyed[i]);
        const std::set<rubble_body> gone(events.bodies_destroyed,
                                         events.bodies_destroyed + events.bodies_destroyed_count);
        for (uint32_t i = 0; i < events.bodies_created_count; ++i)
            if (!gone.contains(events.bodies_created[i]) && !StepView::find(view.bodies, events.bodies_created[i]))
                return fmt::format("body {:x} was made, and is not listed", events.bodies_created[i]);
        for (const BodyRow& body : view.bodies)
            if (body.state.shape_count == 0 && StepView::find(view.before, body.state.body))
                return fmt::format("body {:x} has no shape", body.state.body);
        return follow(view);
    }

private:
    /// Compares the list of bodies with what events have told since the beginning.
    std::string follow(const StepView& view) {
        const rubble_events& events = view.events;
        if (m_isKnown) {
            for (uint32_t i = 0; i < events.bodies_destroyed_count; ++i) m_bodies.erase(events.bodies_destroyed[i]);
            for (uint32_t i = 0; i < events.bodies_created_count; ++i)
                if (StepView::find(view.bodies, events.bodies_created[i])) m_bodies.insert(events.bodies_created[i]);
        } else
            for (const BodyRow& body : view.bodies) m_bodies.insert(body.state.body);
        m_isKnown = true;
        if (m_bodies.size() == view.bodies.size()) return {};
        return fmt::format("events tell of {} bodies, found {}", m_bodies.size(), view.bodies.size());
    }

    std::set<rubble_body> m_bodies;
    bool m_isKnown = false;
};

}  // namespace

std::unique_ptr<Check> makeObjectCheck() {
    return std::make_unique<ObjectCheck>();
}

}  // namespace stress
