// What applies to all that is drawn after it: places, colours, letters.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/script/binding/files.h"
#include "runtime/script/functions/ui.h"
#include "runtime/script/functions/vocabulary.h"

namespace rubble::script {

UiState& uiOf(lua_State* L) {
    std::vector<UiState>& stack = ScriptContext::of(L).ui;
    if (stack.empty()) stack.emplace_back();
    return stack.back();
}

namespace {

constexpr size_t kMaxDepth = 200;

double lengthAt(lua_State* L, int index, const char* name) {
    return std::clamp(finiteAt(L, index, name), -kUiReach, kUiReach);
}

std::array<double, 4> colorAt(lua_State* L, int first) {
    const char* const names[] = {"r", "g", "b", "a"};
    std::array<double, 4> color{};
    for (int i = 0; i < 4; ++i)
        color[size_t(i)] =
            std::clamp(i < 3 ? finiteAt(L, first + i, names[i]) : finiteOr(L, first + i, names[i], 1.0), 0.0, 1.0);
    return color;
}

/// Outside of draw(dt) there is nothing to keep: false, and the log says so.
bool isDrawing(lua_State* L) {
    const bool isOpen = ScriptContext::of(L).shared.ui.isOpen;
    if (!isOpen) warnOnce(L, "expected a call in draw(dt), nothing is drawn by others");
    return isOpen;
}

int push(lua_State* L) {
    if (!isDrawing(L)) return 0;
    std::vector<UiState>& stack = ScriptContext::of(L).ui;
    if (stack.size() >= kMaxDepth) return luaL_error(L, "UiPush: expected at most %d at once", int(kMaxDepth));
    stack.push_back(UiState(uiOf(L)));
    return 0;
}

int pop(lua_State* L) {
    if (!isDrawing(L)) return 0;
    std::vector<UiState>& stack = ScriptContext::of(L).ui;
    if (stack.size() < 2) return luaL_error(L, "UiPop: expected an UiPush() before it, found none");
    stack.pop_back();
    return 0;
}

int translate(lua_State* L) {
    auto& t = uiOf(L).transform;
    const double x = lengthAt(L, 1, "x"), y = lengthAt(L, 2, "y");
    t[4] = std::clamp(t[4] + t[0] * x + t[2] * y, -kUiReach, kUiReach);
    t[5] = std::clamp(t[5] + t[1] * x + t[3] * y, -kUiReach, kUiReach);
    return 0;
}

int rotate(lua_State* L) {
    const double angle = -finiteAt(L, 1, "angle") * std::numbers::pi / 180.0;  // y is down
    const double c = std::cos(angle), s = std::sin(angle);
    auto& t = uiOf(L).transform;
    t = {t[0] * c + t[2] * s, t[1] * c + t[3] * s, t[2] * c - t[0] * s, t[3] * c - t[1] * s, t[4], t[5]};
    return 0;
}

int scale(lua_State* L) {
    auto& t = uiOf(L).transform;
    const double x = finiteAt(L, 1, "x"), y = finiteOr(L, 2, "y", x);
    for (const size_t i : {0, 1}) t[i] = std::clamp(t[i] * x, -1e4, 1e4);
    for (const size_t i : {2, 3}) t[i] = std::clamp(t[i] * y, -1e4, 1e4);
    return 0;
}

/// The rectangle around the window, within the one around it.
std::array<double, 4> clipOf(const UiState& ui) {
    const auto& t = ui.transform;
    std::array<double, 4> box{kUiReach, kUiReach, -kUiReach, -kUiReach};
    for (int corner = 0; corner < 4; ++corner) {
        const double x = corner & 1 ? ui.width : 0.0, y = corner & 2 ? ui.height : 0.0;
        const double place[2] = {t[0] * x + t[2] * y + t[4], t[1] * x + t[3] * y + t[5]};
        for (size_t axis = 0; axis < 2; ++axis) {
            box[axis] = std::min(box[axis], place[axis]);
            box[axis + 2] = std::max(box[axis + 2], place[axis]);
        }
    }
    for (size_t axis = 0; axis < 2 && ui.clip != std::array<double, 4>{}; ++axis) {
        box[axis] = std::max(box[axis], ui.clip[axis]);
        box[axis + 2] = std::max(box[axis], std::min(box[axis + 2], ui.clip[axis + 2]));
    }
    return box;
}

int window(lua_State* L) {
    UiState& ui = uiOf(L);
    const double width = std::clamp(finiteAt(L, 1, "width"), 0.0, kUiReach);
    const double height = std::clamp(finiteAt(L, 2, "height"), 0.0, kUiReach);
    auto& t = ui.transform;
    const double x = width * ui.align[0], y = height * ui.align[1];
    t[4] = std::clamp(t[4] - t[0] * x - t[2] * y, -kUiReach, kUiReach);
    t[5] = std::clamp(t[5] - t[1] * x - t[3] * y, -kUiReach, kUiReach);
    ui.width = width, ui.height = height;
    ui.align = {0.0, 0.0}, ui.isOnBaseline = true;
    if (boolOr(L, 3, false)) ui.clip = clipOf(ui);
    return 0;
}

int align(lua_State* L) {
    const std::string words = textAt(L, 1, "alignment") + " ";
    struct Word {
        const char* name;
        size_t axis;
        double share;
    };
    static constexpr Word kWords[] = {{"left", 0, 0.0}, {"center", 0, 0.5}, {"right", 0, 1.0},
                                      {"top", 1, 0.0},  {"middle", 1, 0.5}, {"bottom", 1, 1.0}};
    std::array<double, 2> shares = {0.0, 0.0};
    bool isOnBaseline = true;
    for (size_t first = 0; first < words.size();) {
        const size_t end = words.find(' ', first);
        const std::string word = words.substr(first, end - first);
        first = end + 1;
        if (word.empty()) continue;
        const auto* known =
            std::find_if(std::begin(kWords), std::end(kWords), [&](auto& each) { return word == each.name; });
        if (known == std::end(kWords))
            refuseArgument(L, 1, "alignment", "words of left, center, right, top, middle, bottom");
        shares[known->axis] = known->share;
        isOnBaseline = isOnBaseline && known->axis == 0;
    }
    UiState& ui = uiOf(L);
    ui.align = {shares[0], shares[1]}, ui.isOnBaseline = isOnBaseline;
    return 0;
}

int color(lua_State* L) {
    uiOf(L).color = colorAt(L, 1);
    return 0;
}

int colorFilter(lua_State* L) {
    const auto by = colorAt(L, 1);
    for (size_t i = 0; i < 4; ++i) uiOf(L).filter[i] *= by[i];
    return 0;
}

int font(lua_State* L) {
    const std::string name = textAt(L, 1, "font");
    const double size = std::clamp(finiteAt(L, 2, "size"), 1.0, 5000.0);
    const size_t start = name.rfind('/') == name.npos ? 0 : name.rfind('/') + 1;
    const std::string stem = name.substr(start, name.rfind('.') == name.npos ? name.npos : name.rfind('.') - start);
    const bool isSans = stem == "regular" || stem == "sans", isOwn = isSans || stem == "bold" || stem == "mono";
    const std::string file = isOwn ? stem : fileAt(L, 1, "font");
    auto probe = sized<rubble_overlay_item>();
    double measured[2];
    probe.text = "", probe.font = isSans ? "sans" : file.c_str();
    isDone(L, apiOf(L).measure_text(&probe, measured));
    uiOf(L).font = probe.font, uiOf(L).fontSize = size;
    return 0;
}

int fontHeight(lua_State* L) {
    auto probe = sized<rubble_overlay_item>();
    double measured[2] = {};
    probe.text = "", probe.font = uiOf(L).font.c_str(), probe.font_size = uiOf(L).fontSize;
    if (uiOf(L).font.empty()) probe.font = nullptr;
    isDone(L, apiOf(L).measure_text(&probe, measured));
    lua_pushnumber(L, measured[1]);
    return 1;
}

int outline(lua_State* L) {
    uiOf(L).outlineColor = colorAt(L, 1);
    uiOf(L).outline = 20.0 * std::clamp(finiteOr(L, 5, "thickness", 0.1), 0.0, 1.0);
    return 0;
}

int shadow(lua_State* L) {
    UiState& ui = uiOf(L);
    ui.shadowColor = colorAt(L, 1);
    ui.shadowDistance = std::clamp(finiteOr(L, 5, "distance", 1.0), 0.0, 1e3);
    ui.shadowBlur = 20.0 * std::clamp(finiteOr(L, 6, "blur", 0.5), 0.0, 1.0);
    return 0;
}

int wordWrap(lua_State* L) {
    uiOf(L).wrap = std::clamp(finiteAt(L, 1, "width"), 0.0, kUiReach);
    return 0;
}

template <double UiState::*kMember>
int getLength(lua_State* L) {
    lua_pushnumber(L, uiOf(L).*kMember);
    return 1;
}
template <double UiState::*kMember>
int getHalf(lua_State* L) {
    lua_pushnumber(L, 0.5 * uiOf(L).*kMember);
    return 1;
}

int world(lua_State* L) {
    const Placement place = poseAt(L, 1, "transform");
    UiState& ui = uiOf(L);
    ui.isInWorld = true;
    ui.position = place.position, ui.rotation = place.rotation;
    ui.scale = std::clamp(finiteOr(L, 2, "scale", 0.01), 1e-6, 1e3);
    ui.isOccluded = boolOr(L, 3, true);
    ui.transform = {1, 0, 0, 1, 0, 0};
    ui.clip = {};
    return 0;
}

constexpr ScriptFunction kFunctions[] = {
    {"UiPush()", "Keeps all that has been set for drawing, until UiPop().", push},
    {"UiPop()", "Sets all as it was at the last UiPush().", pop},
    {"UiTranslate(x, y)", "Moves what follows to the right and down. The canvas is 1080 units high.", translate},
    {"UiRotate(angle)", "Turns what follows to the left, in degrees.", rotate},
    {"UiScale(x, y)", "Scales what follows; y: as x if it is left out.", scale},
    {"UiWindow(width, height, clip)",
     "Begins a window here, whose size UiWidth() and its like give; clip: nothing is drawn outside of the rectangle "
     "around it.",
     window},
    {"UiAlign(alignment)",
     "Which point of what follows is here: words of left, center, right, top, middle, bottom. Texts without a vertical "
     "one stand on their baseline.",
     align},
    {"UiColor(r, g, b, a)", "The colour of what follows, sRGB 0 to 1.", color},
    {"UiColorFilter(r, g, b, a)", "Multiplies the colours of all that follows.", colorFilter},
    {"UiFont(font, size)",
     "The font of texts: \"regular.ttf\", \"bold.ttf\", \"mono.ttf\" or a file of the scripts' folder.", font},
    {"UiFontHeight() -> height", "The height of a line.", fontHeight},
    {"UiTextOutline(r, g, b, a, thickness)", "The outline of letters; thickness 0 to 1, of 20 units.", outline},
    {"UiTextShadow(r, g, b, a, distance, blur)", "The shadow of letters; blur 0 to 1, of 20 units.", shadow},
    {"UiWordWrap(width)", "Breaks the lines of texts at a width; 0: no more.", wordWrap},
    {"UiWidth() -> width", "The width of the window, or of the canvas.", getLength<&UiState::width>},
    {"UiHeight() -> height", "Its height.", getLength<&UiState::height>},
    {"UiCenter() -> x", "Half its width.", getHalf<&UiState::width>},
    {"UiMiddle() -> y", "Half its height.", getHalf<&UiState::height>},
    {"UiWorld(transform, scale, occluded)",
     "Draws what follows on a plane in the world, x to the right and y down from the transform's place, in units of "
     "scale metres (0.01). Voxels hide it unless occluded is false.",
     world},
};

}  // namespace

std::span<const ScriptFunction> uiStateFunctions() {
    return kFunctions;
}

}  // namespace rubble::script
