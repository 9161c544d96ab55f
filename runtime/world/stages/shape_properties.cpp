#include <utility>

#include "runtime/world/stages/palette_edits.h"
#include "runtime/world/stages/shape_edits.h"
#include "runtime/world/state/load_level.h"

namespace rubble {
namespace {

/// A standing shape is analysed again: its strength, weight or supports are others, or it bears no load any more.
void restartStressOf(EditContext& context, ShapeHandle handle) {
    if (!context.world.stress) return;
    context.world.stress->remove(handle);
    context.world.addStress(handle);
}

/// What no anchor holds any more comes off, as after a cut.
void setAnchors(EditContext& context, ShapeHandle handle, const SetShapeEdit& edit) {
    Shape& shape = context.world.shapes.at(handle);
    const Body& body = context.world.bodies.at(shape.body);
    shape.anchors.clear();
    if (edit.anchorChange == AnchorChange::Default)
        anchorByDefault(shape, body);
    else
        shape.anchors = translatedBoxes(edit.anchors, glm::ivec3(0), shape.grid.size());
    if (!body.isStatic) return;
    shape.knownConnected = false;
    context.editState(handle).lostVoxels = true;
}

}  // namespace

void apply(EditContext& context, const SetShapeEdit& edit) {
    Shape* shape = context.world.shapes.find(edit.shape);
    if (!shape)
        return context.warnStale(edit.shape, "set_shape: the handle of its shape is stale; nothing was changed");
    if (edit.setsEmission && std::exchange(shape->emission, edit.emission) != edit.emission)
        context.listPalette(edit.shape);
    const bool setsAnchors = edit.anchorChange != AnchorChange::None;
    if (!(edit.setsStrength || edit.setsDensity || edit.setsLoad || setsAnchors)) return;
    context.changes.filters.push_back(edit.shape);
    if (edit.setsStrength) shape->strength = edit.strength;
    if (edit.setsLoad) shape->loadBearing = edit.loadBearing;
    if (setsAnchors) setAnchors(context, edit.shape, edit);
    if (edit.setsDensity && shape->density != edit.density) {
        if (!context.isNew(shape->body)) context.recordMotion(shape->body);
        shape->density = edit.density;
        updateMatter(context, edit.shape);
    }
    restartStressOf(context, edit.shape);
}

}  // namespace rubble
