#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using rubble::script::sized;

constexpr size_t kBodiesPerStep = 8, kMaxCells = 1 << 20;
constexpr double kMaxError = 1e-4;  ///< a share

class MassCheck final : public Check {
public:
    const char* name() const override { return "mass"; }

    std::string afterStep(const StepView& view) override {
        size_t looked = 0;
        for (uint32_t i = 0; i < view.events.bodies_created_count && looked < kBodiesPerStep; ++i, ++looked)
            if (std::string wrong = compare(view, view.events.bodies_created[i]); !wrong.empty()) return wrong;
        for (uint32_t i = 0; i < view.events.removed_count && looked < kBodiesPerStep; ++i, ++looked) {
            rubble_shape_state shape = {};
            if (view.api.get_shape_state(view.world, view.events.removed[i].shape, &shape) != RUBBLE_OK) continue;
            if (std::string wrong = compare(view, shape.body); !wrong.empty()) return wrong;
        }
        return {};
    }

private:
    static std::string compare(const StepView& view, rubble_body body) {
        const BodyRow* row = StepView::find(view.bodies, body);
        if (!row || !row->isDynamic()) return {};
        double mass = 0.0;
        for (const rubble_shape_state& shape : shapesOf(view.api, view.world, body)) {
            if (size_t(shape.size[0]) * size_t(shape.size[1]) * size_t(shape.size[2]) > kMaxCells) return {};
            mass += massOf(view, shape);
        }
        const double found = row->properties.mass;
        if (mass == 0.0 || std::abs(found - mass) <= kMaxError * mass) return {};
        return fmt::format("body {:x} has a mass of {} kg, and voxels of {} kg", body, found, mass);
    }

    static double massOf(const StepView& view, const rubble_shape_state& shape) {
        uint64_t counts[256] = {};
        for (const uint8_t index : voxelsOf(view.api, view.world, shape)) ++counts[index];
        rubble_palette_entry palette[255] = {};
        auto range = sized<rubble_palette_range>();
        range.shape = shape.shape, range.first = 1, range.count = 255;
        auto properties = sized<rubble_shape_properties>();
        view.api.get_palette(view.world, &range, palette);
        view.api.get_shape_properties(view.world, shape.shape, &properties);
        double mass = 0.0;
        for (size_t index = 1; index < 256; ++index) {
            if (!counts[index]) continue;
            auto material = sized<rubble_material>();
            view.api.get_material(view.world, palette[index - 1].material, &material);
            if (palette[index - 1].material) mass += double(counts[index]) * double(material.density);
        }
        return mass * properties.density * std::pow(shape.voxel_size, 3.0);
    }
};

}  // namespace

std::unique_ptr<Check> makeMassCheck() {
    return std::make_unique<MassCheck>();
}

}  // namespace stress
