#include <cmath>
#include <glm/mat4x4.hpp>
#include <optional>
#include <vector>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/host.h"

namespace rubble::abi {
namespace {

constexpr uint32_t kMaxViewSize = 16384;  // pixels
constexpr uint32_t kMaxSlots = 16;
constexpr NumberRange kPerspectiveScale{1e-3, 1e4};             // of fields of view of 3.14 and 0.0002 radians
constexpr NumberRange kOrthographicScale{1e-4, 100.0};          // 1 / metres of half the view
constexpr double kMaxShift = 4.0, kMaxOrthographicShift = 1e5;  // in halves of the view
constexpr double kMaxStart = 1e5;                               // metres to the near plane of an orthographic view

std::string readPreset(const char* preset) {
    const std::string name = preset ? preset : "balanced";
    if (name != "draft" && name != "fast" && name != "balanced" && name != "accurate")
        refuse(RUBBLE_ERROR_ARGUMENT, "settings->preset is \"{}\", expected draft, fast, balanced or accurate", name);
    return isRefused() ? "balanced" : name;
}

RenderSettings readSettings(const rubble_renderer_settings& given) {
    const uint32_t flags =
        readFlags(given.flags, RUBBLE_RENDERER_RESET_STATE | RUBBLE_RENDERER_COMPILE_LATE, "settings->flags");
    RenderSettings settings = RenderSettings::preset(readPreset(given.preset));
    settings.hostState = flags & RUBBLE_RENDERER_RESET_STATE ? HostState::Reset : HostState::Restored;
    settings.compileAhead = !(flags & RUBBLE_RENDERER_COMPILE_LATE);
    if (given.program_cache) settings.programCache = given.program_cache;
    return settings;
}

rubble_result createRenderer(rubble_world world, const rubble_renderer_settings* settings, rubble_renderer* out) {
    return guarded("create_renderer", [&] {
        if (!isGiven(out, "out")) return;
        *out = 0;
        const auto hosted = Registry::instance().findWorld(world);
        const rubble_renderer_settings read = readStruct(settings, "settings");
        if (isRefused()) return;
        const RenderSettings wanted = readSettings(read);
        if (!host().gl_get_proc_address)
            refuse(RUBBLE_ERROR_GL, "the host has set no gl_get_proc_address: call set_host() with one first");
        if (!hosted->options.drawable)
            refuse(RUBBLE_ERROR_ARGUMENT, "the world was created with RUBBLE_WORLD_NO_RENDERER");
        if (!hosted->renderer.expired())
            refuse(RUBBLE_ERROR_ARGUMENT, "the world has a renderer; destroy that one first");
        if (isRefused()) return;
        Result<std::unique_ptr<Renderer>> renderer =
            Renderer::create(host().gl_get_proc_address, read.shader_folder ? read.shader_folder : "", wanted);
        if (!renderer) return refuse(RUBBLE_ERROR_GL, "{}", renderer.error());
        if (std::exchange(hosted->hadRenderer, true)) hosted->loop.restartDrawing();
        const auto made = std::make_shared<HostedRenderer>();
        made->world = hosted;
        made->renderer = RendererOwner(renderer->release(), [](Renderer* owned) { delete owned; });
        hosted->renderer = made;
        *out = Registry::instance().addRenderer(made).bits;
    });
}

/// Refuses what is no perspective with a field of view that vertical_fov may have, and no orthographic projection.
void checkProjection(const View::Projection& read) {
    const glm::dmat4& p = read.clipFromEye;
    const bool isOrthographic = read.isOrthographic();
    for (int i = 0; i < 16; ++i) {
        const double value = p[i / 4][i % 4], expected = i == (isOrthographic ? 15 : 11) ? (i == 15 ? 1.0 : -1.0) : 0.0;
        const bool isShift = isOrthographic ? i == 12 || i == 13 : i == 8 || i == 9;
        if (i == 0 || i == 5 || i == 10 || i == 14 || isShift || value == expected) continue;
        return refuse(RUBBLE_ERROR_ARGUMENT,
                      "view->projection[{}] is {}, expected {}: a perspective or orthographic projection, eyes looking "
                      "along -z",
                      i, value, expected);
    }
    const NumberRange scale = isOrthographic ? kOrthographicScale : kPerspectiveScale;
    const glm::dvec4& shift = p[isOrthographic ? 3 : 2];
    const double most = isOrthographic ? kMaxOrthographicShift : kMaxShift;
    for (int axis = 0; axis < 2; ++axis)
        if (!(p[axis][axis] >= scale.low && p[axis][axis] <= scale.high) || std::abs(shift[axis]) > most)
            return refuse(
                RUBBLE_ERROR_ARGUMENT,
                "view->projection has the scale {} and the shift {} along {}, expected {} to {} and -{} to {}: what "
                "rays of floats resolve",
                p[axis][axis], shift[axis], "xy"[axis], scale.low, scale.high, most, most);
    const int depth = isOrthographic ? 10 : 14;
    if (p[depth / 4][2] == 0.0)
        return refuse(RUBBLE_ERROR_ARGUMENT, "view->projection[{}] is 0, expected depths that differ", depth);
    if (isOrthographic && !(std::abs(read.startDepth()) <= kMaxStart))
        refuse(RUBBLE_ERROR_ARGUMENT, "view->projection has its near plane at {} m, expected -{} to {}",
               read.startDepth(), kMaxStart, kMaxStart);
}

/// The projection of a view that has one.
std::optional<View::Projection> readProjection(const rubble_view& given, uint32_t flags) {
    View::Projection read;
    bool isGiven = false;
    for (int i = 0; i < 16; ++i) {
        if (!std::isfinite(given.projection[i])) {
            refuse(RUBBLE_ERROR_ARGUMENT, "view->projection[{}] is {}, expected a finite number", i,
                   given.projection[i]);
            return {};
        }
        isGiven = isGiven || given.projection[i] != 0.0;
        read.clipFromEye[i / 4][i % 4] = given.projection[i];
    }
    read.isZeroToOne = flags & RUBBLE_VIEW_ZERO_TO_ONE;
    read.composesDepth = flags & RUBBLE_VIEW_DEPTH;
    if (!isGiven) {
        if (flags & (RUBBLE_VIEW_DEPTH | RUBBLE_VIEW_ZERO_TO_ONE))
            refuse(RUBBLE_ERROR_ARGUMENT, "view->projection is zero, expected the projection that depths are of");
        return {};
    }
    checkProjection(read);
    return read;
}

std::vector<ShapeHandle> readHidden(const rubble_view& given) {
    std::vector<ShapeHandle> hidden;
    readReserved(given.reserved, "view->reserved");
    if (given.hidden_shape_count) isGiven(given.hidden_shapes, "view->hidden_shapes");
    if (isRefused()) return hidden;
    for (uint32_t i = 0; i < given.hidden_shape_count; ++i)
        hidden.push_back(readHandle<HandleType::Shape>(given.hidden_shapes[i], "view->hidden_shapes"));
    return hidden;
}

View readView(const rubble_view& given) {
    for (const auto& [name, pixels] : {std::pair("width", given.width), std::pair("height", given.height)})
        if (pixels < 1 || pixels > kMaxViewSize)
            refuse(RUBBLE_ERROR_ARGUMENT, "view->{} is {}, expected 1 to {} pixels", name, pixels, kMaxViewSize);
    View view;
    view.position = readVector(given.position, "position");
    view.rotation = readRotation(given.rotation, "rotation");
    view.verticalFov = float(readOrDefault(given.vertical_fov, {0.01, 3.0}, view.verticalFov, "vertical_fov"));
    view.size = glm::ivec2(given.width, given.height);
    view.framebuffer = given.framebuffer;
    if (given.slot >= kMaxSlots)
        refuse(RUBBLE_ERROR_ARGUMENT, "view->slot is {}, expected 0 to {}", given.slot, kMaxSlots - 1);
    view.slot = int(given.slot);
    const uint32_t flags = readFlags(given.flags,
                                     RUBBLE_VIEW_CUT | RUBBLE_VIEW_DEPTH | RUBBLE_VIEW_ZERO_TO_ONE |
                                         RUBBLE_VIEW_LINEAR | RUBBLE_VIEW_FLIP_Y | RUBBLE_VIEW_FIXED_EXPOSURE,
                                     "view->flags");
    view.cut = flags & RUBBLE_VIEW_CUT;
    view.isLinear = flags & RUBBLE_VIEW_LINEAR;
    view.hasFixedExposure = flags & (RUBBLE_VIEW_LINEAR | RUBBLE_VIEW_FIXED_EXPOSURE);
    view.isFlipped = flags & RUBBLE_VIEW_FLIP_Y;
    view.projection = readProjection(given, flags);
    view.hidden = readHidden(given);
    return view;
}

rubble_result draw(rubble_renderer renderer, const rubble_view* view) {
    return inRenderer("draw", renderer, [&](HostedRenderer& hosted) {
        const auto world = hosted.world.lock();
        if (!world) return refuse(RUBBLE_ERROR_STALE, "the renderer's world is destroyed");
        const rubble_view given = readStruct(view, "view");
        if (isRefused()) return;
        const double alpha = readOrDefault(given.alpha, {0.0, 1.0}, 0.0, "alpha");
        const View read = readView(given);
        if (isRefused()) return;
        world->loop.draw(*hosted.renderer, read, float(alpha));
        if (const std::string& error = hosted.renderer->lastError(); !error.empty())
            return refuse(RUBBLE_ERROR_GL, "{}", error);
        hosted.applyMs = world->loop.times()[Stage::Apply];
        hosted.drawMs = world->loop.times()[Stage::Draw];
    });
}

rubble_result setDebugView(rubble_renderer renderer, const char* name) {
    return inRenderer("set_debug_view", renderer, [&](HostedRenderer& hosted) {
        if (hosted.renderer->showPass(name ? name : "final")) return;
        std::string text = "no view \"" + std::string(name ? name : "final") + "\", expected one of:";
        for (const std::string& pass : hosted.renderer->passNames()) text += " " + pass;
        refuse(RUBBLE_ERROR_ARGUMENT, "{}", text);
    });
}

rubble_result getDrawStats(rubble_renderer renderer, rubble_draw_stats* out) {
    return inRenderer("get_draw_stats", renderer, [&](const HostedRenderer& hosted) {
        const RenderStats& stats = hosted.renderer->stats();
        rubble_draw_stats row = {};
        row.draw_calls = uint32_t(stats.drawCalls);
        row.shapes = uint32_t(stats.shapes);
        row.bricks = uint32_t(stats.bricks);
        row.upload_bytes = stats.uploadBytes;
        row.texture_bytes = stats.textureBytes;
        row.apply_ms = hosted.applyMs;
        row.draw_ms = hosted.drawMs;
        writeStruct(out, row);
    });
}

rubble_result destroyRenderer(rubble_renderer renderer) {
    return guarded("destroy_renderer", [&] {
        const auto id = readHandle<HandleType::Renderer>(renderer, "renderer");
        if (isRefused() || !Registry::instance().renderer(renderer)) return;
        if (!Renderer::hasContext())
            return refuse(RUBBLE_ERROR_GL, "expected the renderer's GL context to be current, found none");
        Registry::instance().destroyRenderer(id);
    });
}

}  // namespace

void setRendererFunctions(rubble_api& api) {
    api.create_renderer = createRenderer;
    api.draw = draw;
    api.set_debug_view = setDebugView;
    api.get_draw_stats = getDrawStats;
    api.destroy_renderer = destroyRenderer;
}

}  // namespace rubble::abi
