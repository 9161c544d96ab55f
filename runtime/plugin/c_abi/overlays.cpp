#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/plugin/c_abi/host.h"

namespace rubble::abi {
namespace {

constexpr uint32_t kMaxItems = 65536, kMaxImageSide = 8192;
constexpr size_t kMaxTextBytes = 65536, kMaxNameBytes = 4096;
constexpr NumberRange kLength{0.0, 1e6}, kPlace{-1e6, 1e6}, kFactor{-1e6, 1e6}, kOutline{0.0, 1e4};
constexpr NumberRange kShare{0.0, 1.0}, kFontSize{1e-3, 1e4}, kScale{1e-6, 1e3}, kAlign{-10.0, 10.0};

/// Numbers in a range.
template <class Vector, size_t N>
Vector readNumbers(const double (&values)[N], NumberRange range, const char* name) {
    Vector read(0.0f);
    for (int i = 0; i < int(N); ++i)
        read[i] = float(readInRange(values[i], range, (name + fmt::format("[{}]", i)).c_str()));
    return read;
}

/// Numbers that have a default where all are 0.
template <size_t N>
bool areZero(const double (&values)[N]) {
    return std::all_of(values, values + N, [](double value) { return value == 0.0; });
}

void readLetters(const rubble_overlay_item& given, OverlayItem& item) {
    if (given.font) item.font = readText(given.font, 0, kMaxNameBytes, "font");
    item.fontSize = float(readOrDefault(given.font_size, kFontSize, item.fontSize, "font_size"));
    item.outline = float(readInRange(given.outline, kOutline, "outline"));
    item.outlineColor = readNumbers<glm::vec4>(given.outline_color, kShare, "outline_color");
    item.shadowOffset = readNumbers<glm::vec2>(given.shadow_offset, kPlace, "shadow_offset");
    item.shadowBlur = float(readInRange(given.shadow_blur, kOutline, "shadow_blur"));
    item.shadowColor = readNumbers<glm::vec4>(given.shadow_color, kShare, "shadow_color");
}

void readPlane(const rubble_overlay_item& given, uint32_t flags, OverlayItem& item) {
    OverlayItem::Plane plane;
    plane.position = readVector(given.position, "position");
    plane.facesCamera = flags & RUBBLE_OVERLAY_FACING;
    plane.isOccluded = flags & RUBBLE_OVERLAY_OCCLUDED;
    plane.rotation = readRotation(given.rotation, "rotation");
    plane.scale = readOrDefault(given.scale, kScale, plane.scale, "scale");
    item.end = readVector(given.end, "end");
    if (flags & RUBBLE_OVERLAY_IN_WORLD || item.kind == OverlayItem::Kind::WorldLine) item.plane = plane;
}

void readSurface(const rubble_overlay_item& given, OverlayItem& item) {
    if (!areZero(given.transform))
        for (int i = 0; i < 6; ++i)
            item.transform[i / 2][i % 2] =
                float(readInRange(given.transform[i], kFactor, fmt::format("transform[{}]", i).c_str()));
    item.align = readNumbers<glm::vec2>(given.align, kAlign, "align");
    if (!areZero(given.clip)) item.clip = readNumbers<glm::vec4>(given.clip, kPlace, "clip");
    if (!areZero(given.source)) item.source = readNumbers<glm::vec4>(given.source, kShare, "source");
    const bool isLine = item.kind == OverlayItem::Kind::Line;
    item.size = readNumbers<glm::vec2>(given.size, isLine ? kPlace : kLength, "size");
    item.radius = float(readInRange(given.radius, kLength, "radius"));
    item.stroke = float(readInRange(given.stroke, kLength, "stroke"));
}

/// All numbers are checked, also those that this kind of item has no use for.
OverlayItem readItem(const rubble_overlay_item& given) {
    OverlayItem item;
    const uint32_t known =
        RUBBLE_OVERLAY_IN_WORLD | RUBBLE_OVERLAY_FACING | RUBBLE_OVERLAY_OCCLUDED | RUBBLE_OVERLAY_BASELINE;
    const uint32_t kind = readEnum(given.kind, RUBBLE_OVERLAY_WORLD_LINE, "kind");
    const uint32_t flags = readFlags(given.flags, known, "flags");
    item.kind = OverlayItem::Kind(kind);
    item.isOnBaseline = flags & RUBBLE_OVERLAY_BASELINE;
    item.color = readNumbers<glm::vec4>(given.color, kShare, "color");
    if (kind == RUBBLE_OVERLAY_TEXT) item.text = readText(given.text, 0, kMaxTextBytes, "text");
    if (kind == RUBBLE_OVERLAY_IMAGE) item.text = readText(given.text, 1, kMaxNameBytes, "text");
    readLetters(given, item);
    readPlane(given, flags, item);
    readSurface(given, item);
    return item;
}

rubble_result setOverlay(rubble_renderer renderer, const rubble_overlay_item* items, uint32_t count) {
    return inRenderer("set_overlay", renderer, [&](HostedRenderer& hosted) {
        readInRange(count, {0.0, double(kMaxItems)}, "count");
        if (isRefused() || (count && !isGiven(items, "items"))) return;
        std::vector<OverlayItem> read;
        const size_t stride = count ? items->struct_size : 0;  // all are of one size
        const auto* row = reinterpret_cast<const char*>(items);
        for (uint32_t i = 0; i < count; ++i, row += stride) {
            const std::string name = fmt::format("items[{}]", i);
            const auto given = readStruct(reinterpret_cast<const rubble_overlay_item*>(row), name.c_str());
            if (isRefused()) return;
            read.push_back(readItem(given));
            if (isRefused()) return Call::current().locate(name + ".");
        }
        const auto set = hosted.renderer->overlay().set(std::move(read));
        if (set) return;
        const bool isFont = set.error().find("].font: ") != std::string::npos;
        refuse(isFont ? RUBBLE_ERROR_FILE : RUBBLE_ERROR_ARGUMENT, "{}", set.error());
    });
}

rubble_result setOverlayImage(rubble_renderer renderer, const rubble_overlay_image* image) {
    return inRenderer("set_overlay_image", renderer, [&](HostedRenderer& hosted) {
        const rubble_overlay_image given = readStruct(image, "image");
        if (isRefused()) return;
        const std::string name = readText(given.name, 1, kMaxNameBytes, "image->name");
        OverlayImage read;
        if (given.pixels) {
            const NumberRange side{1.0, double(kMaxImageSide)};
            read.size = {readInRange(given.width, side, "image->width"),
                         readInRange(given.height, side, "image->height")};
            if (isRefused()) return;
            read.pixels.assign(given.pixels, given.pixels + size_t(given.width) * given.height * 4);
        }
        if (isRefused()) return;
        const auto set = hosted.renderer->overlay().setImage(name, std::move(read));
        if (!set) refuse(RUBBLE_ERROR_CAPACITY, "{}", set.error());
    });
}

rubble_result measureText(const rubble_overlay_item* item, double* out) {
    return guarded("measure_text", [&] {
        if (!isGiven(out, "out")) return;
        out[0] = out[1] = 0.0;
        const rubble_overlay_item given = readStruct(item, "item");
        if (!isRefused() && given.kind != RUBBLE_OVERLAY_TEXT)
            refuse(RUBBLE_ERROR_ARGUMENT, "item->kind is {}, expected RUBBLE_OVERLAY_TEXT", given.kind);
        if (isRefused()) return;
        const OverlayItem read = readItem(given);
        if (isRefused()) return Call::current().locate("item->");
        const auto size = rubble::measureText(read.font, read.fontSize, read.size.x, read.text);
        if (!size) return refuse(RUBBLE_ERROR_FILE, "{}", size.error());
        out[0] = size->x, out[1] = size->y;
    });
}

}  // namespace

void setOverlayFunctions(rubble_api& api) {
    api.set_overlay = setOverlay;
    api.set_overlay_image = setOverlayImage;
    api.measure_text = measureText;
}

}  // namespace rubble::abi
