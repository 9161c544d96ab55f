// The functions of renderers in a library that has none.
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

rubble_result refuseRenderers(const char* function) {
    return guarded(function, [] {
        refuse(RUBBLE_ERROR_UNSUPPORTED, "this library has no renderer: expected rubble::rubble, which has all layers");
    });
}

rubble_result createRenderer(rubble_world, const rubble_renderer_settings*, rubble_renderer* out) {
    if (out) *out = 0;
    return refuseRenderers("create_renderer");
}
rubble_result draw(rubble_renderer, const rubble_view*) {
    return refuseRenderers("draw");
}
rubble_result setDebugView(rubble_renderer, const char*) {
    return refuseRenderers("set_debug_view");
}
rubble_result getDrawStats(rubble_renderer, rubble_draw_stats*) {
    return refuseRenderers("get_draw_stats");
}
rubble_result destroyRenderer(rubble_renderer) {
    return refuseRenderers("destroy_renderer");
}

rubble_result setOverlay(rubble_renderer, const rubble_overlay_item*, uint32_t) {
    return refuseRenderers("set_overlay");
}
rubble_result setOverlayImage(rubble_renderer, const rubble_overlay_image*) {
    return refuseRenderers("set_overlay_image");
}
rubble_result measureText(const rubble_overlay_item*, double*) {
    return refuseRenderers("measure_text");
}

}  // namespace

void setOverlayFunctions(rubble_api& api) {
    api.set_overlay = setOverlay;
    api.set_overlay_image = setOverlayImage;
    api.measure_text = measureText;
}

void setRendererFunctions(rubble_api& api) {
    api.create_renderer = createRenderer;
    api.draw = draw;
    api.set_debug_view = setDebugView;
    api.get_draw_stats = getDrawStats;
    api.destroy_renderer = destroyRenderer;
}

}  // namespace rubble::abi
