#include <fmt/format.h>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

class BrushCheck final : public Check {
public:
    const char* name() const override { return "brush"; }

    std::string afterStep(const StepView& view) override {
        for (const SceneRequests::Hole& hole : view.requests.holes) {
            if (hole.step != view.worldSteps()) continue;
            uint64_t removed = 0;
            for (uint32_t i = 0; i < view.events.removed_count; ++i)
                if (view.events.removed[i].shape == hole.shape) removed += view.events.removed[i].count;
            if (removed != hole.voxels)
                return fmt::format("a hole has {} voxels, {} were removed", hole.voxels, removed);
        }
        return {};
    }
};

}  // namespace

std::unique_ptr<Check> makeBrushCheck() {
    return std::make_unique<BrushCheck>();
}

}  // namespace stress
