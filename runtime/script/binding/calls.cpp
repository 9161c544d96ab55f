#include "runtime/script/binding/calls.h"

#include "runtime/script/binding/vector_math.h"

namespace rubble::script {

int pushBounds(lua_State* L, const std::vector<uint64_t>& shapes) {
    Vector low{}, high{};
    bool isFirst = true;
    for (const rubble_shape shape : shapes) {
        rubble_shape_state state = {};
        if (!isDone(L, apiOf(L).get_shape_state(worldOf(L), shape, &state))) continue;
        const Placement frame = placementOf(state.position, state.rotation);
        for (int corner = 0; corner < 8; ++corner) {
            Vector point;
            for (size_t i = 0; i < 3; ++i) point[i] = corner >> i & 1 ? state.size[i] * state.voxel_size : 0.0;
            point = toParent(frame, point);
            for (size_t i = 0; i < 3; ++i) {
                low[i] = isFirst ? point[i] : std::min(low[i], point[i]);
                high[i] = isFirst ? point[i] : std::max(high[i], point[i]);
            }
            isFirst = false;
        }
    }
    pushVector(L, low.data());
    pushVector(L, high.data());
    return 2;
}

}  // namespace rubble::script
