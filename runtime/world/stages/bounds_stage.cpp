#include "runtime/world/stages/bounds_stage.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/world/stages/shape_lifecycle.h"

namespace rubble {

void enforceBounds(EditContext& context) {
    std::vector<BodyHandle> left = std::exchange(context.world.leftBounds, {});
    std::sort(left.begin(), left.end(), [](BodyHandle a, BodyHandle b) { return a.slot() < b.slot(); });
    for (const BodyHandle body : left)  // an edit or an undo may have brought it back, or removed it
        if (context.world.isOutside(body)) despawn(context, body);
}

}  // namespace rubble
