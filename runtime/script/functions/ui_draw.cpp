// What scripts draw over the image: rows for set_overlay().
#include <algorithm>
#include <cmath>

#include "runtime/script/binding/files.h"
#include "runtime/script/binding/image_file.h"
#include "runtime/script/binding/vector_math.h"
#include "runtime/script/functions/ui.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {
namespace {

constexpr size_t kMaxItems = 20'000, kMaxTextBytes = 4096, kMaxImages = 200;
constexpr size_t kMaxImageBytes = 256 << 20;  ///< of all images
constexpr double kMaxNumber = 1e6;            ///< that the interface takes

UiFrame& frameOf(lua_State* L) {
    return ScriptContext::of(L).shared.ui;
}

/// An item of a kind, with all that the script has set.
UiItem itemOf(lua_State* L, uint32_t kind) {
    const UiState& ui = uiOf(L);
    UiItem item{sized<rubble_overlay_item>(), "", ""};
    rubble_overlay_item& row = item.row;
    row.kind = kind;
    row.flags = (ui.isInWorld ? uint32_t(RUBBLE_OVERLAY_IN_WORLD) : 0u) |
                (ui.isOccluded ? uint32_t(RUBBLE_OVERLAY_OCCLUDED) : 0u);
    copy(row.transform, ui.transform);
    copy(row.align, ui.align);
    copy(row.clip, ui.clip);
    for (size_t i = 0; i < 4; ++i) row.color[i] = ui.color[i] * ui.filter[i];
    copy(row.position, ui.position);
    copy(row.rotation, ui.rotation);
    row.scale = ui.scale;
    return item;
}

void add(lua_State* L, UiItem item) {
    if (!frameOf(L).isOpen) return warnOnce(L, "expected a call in draw(dt), nothing is drawn by others");
    std::vector<UiItem>& items = frameOf(L).items;
    if (items.size() >= kMaxItems)
        luaL_error(L, "%s: expected at most %d things in a frame", runningFunction(L).name().c_str(), int(kMaxItems));
    double sum = 0.0;  // the renderer takes all things or none: one bad number would hide what others draw
    for (const double value : item.row.transform) sum += std::abs(value);
    for (const double value : item.row.size) sum += std::abs(value);
    for (const double value : item.row.color) sum += std::abs(value);
    if (!(sum < kMaxNumber))
        luaL_error(L, "%s: expected places and sizes below %d, found a number that is not",
                   runningFunction(L).name().c_str(), int(kMaxNumber));
    Sandbox::of(L).charge(L, 20 + int64_t(item.text.size()));
    items.push_back(std::move(item));
}

double sizeAt(lua_State* L, int index, const char* name) {
    return std::clamp(finiteAt(L, index, name), 0.0, kUiReach);
}

UiItem boxOf(lua_State* L, double width, double height, double radius, double stroke) {
    UiItem item = itemOf(L, RUBBLE_OVERLAY_BOX);
    item.row.size[0] = width, item.row.size[1] = height;
    item.row.radius = radius, item.row.stroke = stroke;
    return item;
}

int rect(lua_State* L) {
    add(L, boxOf(L, sizeAt(L, 1, "width"), sizeAt(L, 2, "height"), 0.0, 0.0));
    return 0;
}

int rectOutline(lua_State* L) {
    add(L, boxOf(L, sizeAt(L, 1, "width"), sizeAt(L, 2, "height"), 0.0, sizeAt(L, 3, "thickness")));
    return 0;
}

int roundedRect(lua_State* L) {
    add(L, boxOf(L, sizeAt(L, 1, "width"), sizeAt(L, 2, "height"), sizeAt(L, 3, "radius"), 0.0));
    return 0;
}

int circle(lua_State* L) {
    const double radius = sizeAt(L, 1, "radius");
    add(L, boxOf(L, 2.0 * radius, 2.0 * radius, radius, 0.0));
    return 0;
}

int circleOutline(lua_State* L) {
    const double radius = sizeAt(L, 1, "radius");
    add(L, boxOf(L, 2.0 * radius, 2.0 * radius, radius, sizeAt(L, 2, "thickness")));
    return 0;
}

int line(lua_State* L) {
    UiItem item = itemOf(L, RUBBLE_OVERLAY_LINE);
    item.row.size[0] = std::clamp(finiteAt(L, 1, "x"), -kUiReach, kUiReach);
    item.row.size[1] = std::clamp(finiteAt(L, 2, "y"), -kUiReach, kUiReach);
    item.row.stroke = std::clamp(finiteOr(L, 3, "width", 1.0), 0.0, kUiReach);
    add(L, std::move(item));
    return 0;
}

/// The item of a text, and its size.
UiItem textOf(lua_State* L, double (&size)[2]) {
    const UiState& ui = uiOf(L);
    UiItem item = itemOf(L, RUBBLE_OVERLAY_TEXT);
    item.text = lua_isnumber(L, 1) ? lua_tostring(L, 1) : textAt(L, 1, "text");
    if (item.text.size() > kMaxTextBytes) refuseArgument(L, 1, "text", "at most 4096 bytes");
    item.text = item.text.substr(0, item.text.find('\0'));
    item.font = ui.font;
    rubble_overlay_item& row = item.row;
    if (ui.isOnBaseline) row.flags |= RUBBLE_OVERLAY_BASELINE;
    row.font_size = ui.fontSize, row.size[0] = ui.wrap;
    row.outline = ui.outline, row.shadow_blur = ui.shadowBlur;
    copy(row.outline_color, ui.outlineColor);
    copy(row.shadow_color, ui.shadowColor);
    row.outline_color[3] *= ui.filter[3], row.shadow_color[3] *= ui.filter[3];
    row.shadow_offset[0] = row.shadow_offset[1] = ui.shadowDistance;
    row.text = item.text.c_str(), row.font = item.font.empty() ? nullptr : item.font.c_str();
    Sandbox::of(L).charge(L, 50 + 4 * int64_t(item.text.size()));
    rubble_overlay_item measured = row;  // its size is the same wherever it is
    copy(measured.transform, UiState().transform);
    isDone(L, apiOf(L).measure_text(&measured, size));
    row.text = row.font = nullptr;  // the item's texts move with it
    return item;
}

int pushSize(lua_State* L, double width, double height) {
    lua_pushnumber(L, width);
    lua_pushnumber(L, height);
    return 2;
}

int text(lua_State* L) {
    double size[2] = {};
    add(L, textOf(L, size));
    if (boolOr(L, 2, false)) {
        auto& t = uiOf(L).transform;
        t[4] = std::clamp(t[4] + t[2] * size[1], -kUiReach, kUiReach);
        t[5] = std::clamp(t[5] + t[3] * size[1], -kUiReach, kUiReach);
    }
    return pushSize(L, size[0], size[1]);
}

int getTextSize(lua_State* L) {
    double size[2] = {};
    textOf(L, size);
    return pushSize(L, size[0], size[1]);
}

/// The image of argument 1, which is read once.
const UiImage& imageAt(lua_State* L, std::string& name) {
    const std::string path = fileAt(L, 1, "path");
    name = textAt(L, 1, "path");
    auto& images = frameOf(L).images;
    const auto found = images.find(name);
    if (found != images.end()) return found->second;
    if (images.size() >= kMaxImages)
        luaL_error(L, "%s: expected at most %d different images", runningFunction(L).name().c_str(), int(kMaxImages));
    UiImage image;
    const std::string error = readPng(path, kMaxImageBytes - frameOf(L).imageBytes, image);
    if (!error.empty())
        luaL_error(L, "%s: path: expected a PNG file, found %s: %s", runningFunction(L).name().c_str(), name.c_str(),
                   error.c_str());
    Sandbox::of(L).charge(L, 10'000 + int64_t(image.width) * image.height / 64);
    frameOf(L).imageBytes += image.pixels.size();
    return images[name] = std::move(image);
}

int image(lua_State* L) {
    std::string name;
    const UiImage& read = imageAt(L, name);
    const double width = read.width, height = read.height;
    const double x0 = std::clamp(finiteOr(L, 2, "x0", 0.0), 0.0, width),
                 y0 = std::clamp(finiteOr(L, 3, "y0", 0.0), 0.0, height);
    const double x1 = std::clamp(finiteOr(L, 4, "x1", width), x0, width),
                 y1 = std::clamp(finiteOr(L, 5, "y1", height), y0, height);
    UiItem item = itemOf(L, RUBBLE_OVERLAY_IMAGE);
    item.text = name;
    item.row.size[0] = x1 - x0, item.row.size[1] = y1 - y0;
    copy(item.row.source, std::array<double, 4>{x0 / width, y0 / height, x1 / width, y1 / height});
    add(L, std::move(item));
    return pushSize(L, x1 - x0, y1 - y0);
}

int getImageSize(lua_State* L) {
    std::string name;
    const UiImage& read = imageAt(L, name);
    return pushSize(L, read.width, read.height);
}

/// An image of nine parts, of which those at the sides keep their width.
int imageBox(lua_State* L) {
    std::string name;
    const UiImage& read = imageAt(L, name);
    const double size[2] = {sizeAt(L, 2, "width"), sizeAt(L, 3, "height")};
    const double border[2] = {finiteOr(L, 4, "borderWidth", 0.0), finiteOr(L, 5, "borderHeight", 0.0)};
    const double pixels[2] = {double(read.width), double(read.height)};
    double to[2][4], from[2][4];
    for (int axis = 0; axis < 2; ++axis) {
        const double side = std::clamp(border[axis], 0.0, 0.5 * std::min(size[axis], pixels[axis]));
        const double places[4] = {0.0, side, size[axis] - side, size[axis]};
        const double shares[4] = {0.0, side / pixels[axis], 1.0 - side / pixels[axis], 1.0};
        std::copy_n(places, 4, to[axis]);
        std::copy_n(shares, 4, from[axis]);
    }
    UiItem item = itemOf(L, RUBBLE_OVERLAY_IMAGE);
    item.text = name;
    const auto t = uiOf(L).transform;
    const double left = size[0] * item.row.align[0], top = size[1] * item.row.align[1];
    item.row.align[0] = item.row.align[1] = 0.0;
    for (int part = 0; part < 9; ++part) {
        const int column = part % 3, row = part / 3;
        const double x = to[0][column] - left, y = to[1][row] - top;
        item.row.size[0] = to[0][column + 1] - to[0][column], item.row.size[1] = to[1][row + 1] - to[1][row];
        if (item.row.size[0] <= 0.0 || item.row.size[1] <= 0.0) continue;
        item.row.transform[4] = t[4] + t[0] * x + t[2] * y, item.row.transform[5] = t[5] + t[1] * x + t[3] * y;
        copy(item.row.source,
             std::array<double, 4>{from[0][column], from[1][row], from[0][column + 1], from[1][row + 1]});
        add(L, item);
    }
    return 0;
}

int getCameraTransform(lua_State* L) {
    pushPlacement(L, cameraOf(L));
    return 1;
}

int worldToPixel(lua_State* L) {
    const Vector local = toLocal(cameraOf(L), vectorAt(L, 1, "point"));
    const UiFrame& frame = frameOf(L);
    const double fov = frame.view.vertical_fov > 0.0 ? frame.view.vertical_fov : 1.05;
    const double depth = -local[2], scale = 0.5 * frame.height / (std::tan(0.5 * fov) * std::max(depth, 1e-6));
    lua_pushnumber(L, 0.5 * frame.width + local[0] * scale);
    lua_pushnumber(L, 0.5 * frame.height - local[1] * scale);
    lua_pushnumber(L, depth);
    return 3;
}

constexpr ScriptFunction kFunctions[] = {
    {"UiText(text, move) -> width, height", "A text; move: what follows is that much lower. A line feed begins a line.",
     text},
    {"UiGetTextSize(text) -> width, height", "The size of a text, without drawing it.", getTextSize},
    {"UiRect(width, height)", "A rectangle.", rect},
    {"UiRectOutline(width, height, thickness)", "Its border alone, within it.", rectOutline},
    {"UiRoundedRect(width, height, radius)", "A rectangle with round corners.", roundedRect},
    {"UiCircle(radius)", "A disc; aligned as the square around it.", circle},
    {"UiCircleOutline(radius, thickness)", "A ring, aligned as the square around it.", circleOutline},
    {"UiLine(x, y, width)", "A line from here to x, y.", line},
    {"UiImage(path, x0, y0, x1, y1) -> width, height",
     "A PNG file of the scripts' folder, or a part of it in pixels, in its size.", image},
    {"UiGetImageSize(path) -> width, height", "The size of such a file.", getImageSize},
    {"UiImageBox(path, width, height, borderWidth, borderHeight)",
     "An image over a rectangle; so many of its pixels at the sides keep their size.", imageBox},
    {"UiWorldToPixel(point) -> x, y, depth",
     "Where a place of the world is on the canvas; depth: metres before the camera, negative behind it.", worldToPixel},
    {"GetCameraTransform() -> transform", "The camera of the last frame, which looks along its -z.",
     getCameraTransform},
};

}  // namespace

std::span<const ScriptFunction> uiDrawFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
