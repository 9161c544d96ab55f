#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/objects/body_mass.h"

namespace rubble::abi {
namespace {

rubble_result getBodyProperties(rubble_world world, rubble_body body, rubble_body_properties* out) {
    return inWorld("get_body_properties", world, [&](const HostedWorld& hosted) {
        const World& from = hosted.loop.world();
        const Body* found = findLive<HandleType::Body>(from.bodies(), body, "body");
        if (!found) return;
        const MassProperties mass = bodyMass(from.data(), BodyHandle{body});
        rubble_body_properties values = {};
        values.is_broken = found->broken;
        values.mass = mass.mass;
        writeVector(values.center, mass.center);
        std::copy(mass.inertia.begin(), mass.inertia.end(), values.inertia);
        values.gravity_scale = found->gravityScale;
        values.linear_damping = found->linearDamping;
        values.angular_damping = found->angularDamping;
        writeStruct(out, values);
    });
}

CellBox readAnchor(const rubble_cell_box& given) {
    CellBox box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = int(readInRange(given.low[a], {-kMaxGridSize, kMaxGridSize}, "low"));
        box.high[a] = box.low[a] + int(readInRange(given.size[a], {1, kMaxGridSize}, "size"));
    }
    return box;
}

SetShapeEdit readShapeChange(const World& world, const rubble_shape_change& given) {
    constexpr uint32_t kAnchors = RUBBLE_SHAPE_ANCHORS | RUBBLE_SHAPE_DEFAULT_ANCHORS;
    constexpr uint32_t kAll =
        RUBBLE_SHAPE_STRENGTH | RUBBLE_SHAPE_DENSITY | RUBBLE_SHAPE_EMISSION | RUBBLE_SHAPE_LOAD | kAnchors;
    const uint32_t fields = readFlags(given.fields, kAll, "fields");
    if (fields == 0) refuse(RUBBLE_ERROR_ARGUMENT, "fields is 0, expected RUBBLE_SHAPE_...: nothing would change");
    SetShapeEdit edit{.shape = readLiveHandle<HandleType::Shape>(world.shapes(), given.shape, "shape")};
    edit.setsStrength = fields & RUBBLE_SHAPE_STRENGTH;
    if (edit.setsStrength) edit.strength = float(readInRange(given.strength, ranges::kStrength, "strength"));
    edit.setsDensity = fields & RUBBLE_SHAPE_DENSITY;
    if (edit.setsDensity) edit.density = float(readInRange(given.density, ranges::kDensityFactor, "density"));
    edit.setsEmission = fields & RUBBLE_SHAPE_EMISSION;
    if (edit.setsEmission) edit.emission = float(readInRange(given.emission, ranges::kEmissionFactor, "emission"));
    edit.setsLoad = fields & RUBBLE_SHAPE_LOAD;
    if (edit.setsLoad) edit.loadBearing = readEnum(given.bears_load, 1, "bears_load") == 1;
    if ((fields & kAnchors) == kAnchors)
        refuse(RUBBLE_ERROR_ARGUMENT, "fields has RUBBLE_SHAPE_ANCHORS and _DEFAULT_ANCHORS, expected one of them");
    if (fields & RUBBLE_SHAPE_DEFAULT_ANCHORS) edit.anchorChange = AnchorChange::Default;
    if (!(fields & RUBBLE_SHAPE_ANCHORS)) return edit;
    edit.anchorChange = AnchorChange::Boxes;
    readInRange(given.anchor_count, ranges::kAnchors, "anchor_count");
    if (given.anchor_count) isGiven(given.anchors, "anchors");
    for (uint32_t i = 0; i < given.anchor_count && !isRefused(); ++i) {
        edit.anchors.push_back(readAnchor(given.anchors[i]));
        if (isRefused()) Call::current().locate(fmt::format("anchors[{}].", i));
    }
    return edit;
}

rubble_result setShape(rubble_world world, const rubble_shape_change* change) {
    return pushEdit("set_shape", world, change, "change", readShapeChange);
}

rubble_result getShapeProperties(rubble_world world, rubble_shape shape, rubble_shape_properties* out) {
    return inWorld("get_shape_properties", world, [&](const HostedWorld& hosted) {
        const Shape* found = findLive<HandleType::Shape>(hosted.loop.world().shapes(), shape, "shape");
        if (!found) return;
        rubble_shape_properties values = {};
        values.bears_load = found->loadBearing;
        values.strength = double(found->strength);
        values.density = double(found->density);
        values.emission = double(found->emission);
        values.collision_layer = found->collisionLayer;
        values.collision_mask = found->collisionMask;
        values.collision_shape = uint32_t(found->collisionShape);
        values.is_piece = found->isPiece;
        values.is_broken = found->broken;
        values.anchor_count = uint32_t(found->anchors.size());
        writeStruct(out, values);
    });
}

rubble_result getAnchors(rubble_world world, rubble_shape shape, rubble_cell_box* out, uint32_t capacity,
                         uint32_t* count) {
    return listRows<rubble_cell_box>(
        "get_anchors", world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
            const Shape* found = findLive<HandleType::Shape>(hosted.loop.world().shapes(), shape, "shape");
            if (!found) return;
            for (const CellBox& anchor : found->anchors)
                rows.add([&] {
                    rubble_cell_box row = {};
                    writeCell(row.low, anchor.low);
                    writeCell(row.size, anchor.high - anchor.low);
                    return row;
                });
        });
}

}  // namespace

void setPropertyFunctions(rubble_api& api) {
    api.get_body_properties = getBodyProperties;
    api.set_shape = setShape;
    api.get_shape_properties = getShapeProperties;
    api.get_anchors = getAnchors;
}

}  // namespace rubble::abi
