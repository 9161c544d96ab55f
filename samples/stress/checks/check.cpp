#include "samples/stress/checks/check.h"

#include <algorithm>

namespace stress {

using rubble::script::sized;

const BodyRow* StepView::find(const std::vector<BodyRow>& rows, rubble_body body) {
    const auto row = std::lower_bound(rows.begin(), rows.end(), body,
                                      [](const BodyRow& each, rubble_body key) { return each.state.body < key; });
    return row != rows.end() && row->state.body == body ? &*row : nullptr;
}

std::vector<std::unique_ptr<Check>> makeChecks() {
    std::vector<std::unique_ptr<Check>> checks;
    for (const auto make : {makeAccountingCheck, makeBrushCheck, makeObjectCheck, makeMotionCheck, makeMassCheck,
                            makeEnergyCheck, makeShadowCheck, makeBudgetCheck, makeLightCheck, makeHashCheck})
        checks.push_back(make());
    return checks;
}

std::vector<uint8_t> savedGame(const rubble_api& api, rubble_world world) {
    uint64_t size = 0;
    api.save_game_data(world, nullptr, 0, &size);
    std::vector<uint8_t> bytes(size);
    if (size && api.save_game_data(world, bytes.data(), size, &size) != RUBBLE_OK) bytes.clear();
    return bytes;
}

LoadedCopy::LoadedCopy(const rubble_api& api, const std::vector<uint8_t>& game, uint32_t flags) : m_api(api) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = flags;
    settings.log = saysNothing;
    if (api.create_world(&settings, &m_world) != RUBBLE_OK ||
        api.load_game_data(m_world, game.data(), game.size()) != RUBBLE_OK)
        m_error = api.get_last_error();
}

LoadedCopy::~LoadedCopy() {
    if (m_world) m_api.destroy_world(m_world);
}

std::vector<rubble_shape_state> shapesOf(const rubble_api& api, rubble_world world, rubble_body body) {
    return readRows<rubble_shape_state>([&](rubble_shape_state* out, uint32_t capacity, uint32_t* count) {
        return api.get_shape_states(world, body, out, capacity, count);
    });
}

std::vector<uint8_t> voxelsOf(const rubble_api& api, rubble_world world, const rubble_shape_state& shape) {
    auto box = sized<rubble_voxel_box>();
    box.shape = shape.shape;
    std::copy_n(shape.size, 3, box.size);
    std::vector<uint8_t> voxels(size_t(box.size[0]) * size_t(box.size[1]) * size_t(box.size[2]));
    uint64_t count = 0;
    if (api.read_voxels(world, &box, voxels.data(), voxels.size(), &count) != RUBBLE_OK) voxels.clear();
    return voxels;
}

}  // namespace stress
