#include "runtime/world/state/fire_state.h"

#include <algorithm>
#include <utility>

#include "runtime/core/hash.h"

namespace rubble {
namespace {

auto findField(std::vector<HeatField>& fields, ShapeHandle shape) {
    return std::lower_bound(fields.begin(), fields.end(), shape.slot(),
                            [](const HeatField& field, uint32_t slot) { return field.shape.slot() < slot; });
}
auto findBrick(std::vector<HotBrick>& bricks, glm::ivec3 brick) {
    return std::lower_bound(bricks.begin(), bricks.end(), brick,
                            [](const HotBrick& hot, glm::ivec3 at) { return cellBefore(hot.brick, at); });
}

}  // namespace

HotBrick* FireState::find(ShapeHandle shape, glm::ivec3 brick) {
    const auto field = findField(fields, shape);
    if (field == fields.end() || field->shape != shape) return nullptr;
    const auto place = findBrick(field->bricks, brick);
    return place != field->bricks.end() && place->brick == brick ? &*place : nullptr;
}
const HotBrick* FireState::find(ShapeHandle shape, glm::ivec3 brick) const {
    return const_cast<FireState*>(this)->find(shape, brick);
}

HotBrick* FireState::findOrAdd(ShapeHandle shape, glm::ivec3 brick, uint32_t limit) {
    if (HotBrick* found = find(shape, brick)) return found;
    if (hotBricks >= limit) return nullptr;
    auto field = findField(fields, shape);
    if (field == fields.end() || field->shape.slot() != shape.slot()) field = fields.insert(field, {shape, {}});
    if (field->shape != shape) *field = {shape, {}};  // the old field is of a shape that is gone
    ++hotBricks;
    return &*field->bricks.insert(findBrick(field->bricks, brick), HotBrick{.brick = brick});
}

std::vector<HotBrick> FireState::take(ShapeHandle shape) {
    const auto field = findField(fields, shape);
    if (field == fields.end() || field->shape != shape) return {};
    std::vector<HotBrick> out = std::move(field->bricks);
    fields.erase(field);
    hotBricks -= uint32_t(out.size());
    for (const HotBrick& hot : out) burning -= hot.burningFor > 0;
    return out;
}

void FireState::compact() {
    std::erase_if(fields, [](const HeatField& field) { return field.bricks.empty(); });
    hotBricks = burning = 0;
    for (const HeatField& field : fields) {
        hotBricks += uint32_t(field.bricks.size());
        for (const HotBrick& brick : field.bricks) burning += brick.burningFor > 0;
    }
}

uint64_t FireState::hash() const {
    uint64_t hash = 0;
    for (const HeatField& field : fields) {
        hash = hashValue(field.shape.slot(), hash);
        for (const HotBrick& hot : field.bricks) {
            const int64_t values[] = {hot.brick.x, hot.brick.y,    hot.brick.z, hot.heat,
                                      hot.burned,  hot.burningFor, hot.wet,     hot.charred};
            hash = hashBytes(values, sizeof values, hash);
        }
    }
    return hash;
}

}  // namespace rubble
