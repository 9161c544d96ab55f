#include <fmt/format.h>

#include <algorithm>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

class AccountingCheck final : public Check {
public:
    const char* name() const override { return "accounting"; }

    std::string afterStep(const StepView& view) override {
        const rubble_voxel_accounting accounting = read(view);
        if (accounting.imported == accounting.standing + accounting.in_pieces + accounting.removed) return {};
        return fmt::format("of {} voxels {} stand, {} are in pieces and {} were removed", accounting.imported,
                           accounting.standing, accounting.in_pieces, accounting.removed);
    }

    /// Counts all voxels that there are.
    std::string atBorder(const StepView& view) override {
        const rubble_voxel_accounting accounting = read(view);
        uint64_t counted = 0;
        for (const BodyRow& body : view.bodies)
            for (const rubble_shape_state& shape : shapesOf(view.api, view.world, body.state.body)) {
                const std::vector<uint8_t> voxels = voxelsOf(view.api, view.world, shape);
                counted += voxels.size() - uint64_t(std::count(voxels.begin(), voxels.end(), uint8_t(0)));
            }
        const uint64_t said = accounting.standing + accounting.in_pieces;
        return counted == said ? "" : fmt::format("{} voxels are said to be there, found {}", said, counted);
    }

private:
    static rubble_voxel_accounting read(const StepView& view) {
        auto accounting = rubble::script::sized<rubble_voxel_accounting>();
        view.api.get_voxel_accounting(view.world, &accounting);
        return accounting;
    }
};

}  // namespace

std::unique_ptr<Check> makeAccountingCheck() {
    return std::make_unique<AccountingCheck>();
}

}  // namespace stress
