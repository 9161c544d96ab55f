#include "editor/ui/state/theme.h"

#include <imgui_freetype.h>

#include <cmath>
#include <string>

namespace editor {
namespace {

constexpr float kFontSize = 14.0f;  ///< pixels of a plain display
float scaleOfUi = 1.0f;
ImFont* mono = nullptr;
ImFont* bold = nullptr;

ImFont* addFont(const char* file, float size) {
    static const ImWchar kRanges[] = {0x20, 0x17f, 0x2010, 0x2027, 0x2190, 0x2193, 0x00b0, 0x00b3, 0};
    const std::string path = std::string(RUBBLE_FONT_FOLDER) + "/" + file;
    return ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), std::round(size), nullptr, kRanges);
}

void setSizes(ImGuiStyle& style) {
    style.WindowPadding = {10, 8};
    style.FramePadding = {7, 4};
    style.ItemSpacing = {7, 6};
    style.ItemInnerSpacing = {6, 4};
    style.CellPadding = {5, 3};
    style.ScrollbarSize = 11;
    style.GrabMinSize = 9;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 1;
    style.FrameBorderSize = 0;
    style.WindowRounding = 0;
    style.ChildRounding = 0;
    style.FrameRounding = 4;
    style.PopupRounding = 6;
    style.GrabRounding = 4;
    style.TabRounding = 4;
    style.ScrollbarRounding = 6;
    style.IndentSpacing = 15;
    style.DisabledAlpha = 0.45f;
}

void setColors(ImGuiStyle& style) {
    const auto gray = [](float level, float alpha = 1.0f) { return ImVec4(level, level * 1.03f, level * 1.1f, alpha); };
    const auto accent = [](float alpha) { return ImVec4(0.95f, 0.64f, 0.23f, alpha); };
    ImVec4* const c = style.Colors;
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(theme::kText);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(theme::kDim);
    c[ImGuiCol_WindowBg] = c[ImGuiCol_ChildBg] = ImGui::ColorConvertU32ToFloat4(theme::kPanel);
    c[ImGuiCol_PopupBg] = gray(0.105f);
    c[ImGuiCol_Border] = gray(0.26f);
    c[ImGuiCol_FrameBg] = gray(0.19f);
    c[ImGuiCol_FrameBgHovered] = gray(0.235f);
    c[ImGuiCol_FrameBgActive] = gray(0.26f);
    c[ImGuiCol_Button] = gray(0.205f);
    c[ImGuiCol_ButtonHovered] = gray(0.27f);
    c[ImGuiCol_ButtonActive] = accent(0.55f);
    c[ImGuiCol_Header] = accent(0.26f);
    c[ImGuiCol_HeaderHovered] = gray(0.25f);
    c[ImGuiCol_HeaderActive] = accent(0.4f);
    c[ImGuiCol_CheckMark] = c[ImGuiCol_SliderGrab] = accent(0.95f);
    c[ImGuiCol_SliderGrabActive] = accent(1.0f);
    c[ImGuiCol_Separator] = c[ImGuiCol_TableBorderLight] = gray(0.19f);
    c[ImGuiCol_SeparatorHovered] = c[ImGuiCol_SeparatorActive] = accent(0.6f);
    c[ImGuiCol_Tab] = c[ImGuiCol_TabUnfocused] = gray(0.13f, 0.0f);
    c[ImGuiCol_TabHovered] = gray(0.25f);
    c[ImGuiCol_TabActive] = c[ImGuiCol_TabUnfocusedActive] = gray(0.215f);
    c[ImGuiCol_ScrollbarBg] = gray(0.0f, 0.0f);
    c[ImGuiCol_ScrollbarGrab] = gray(0.25f);
    c[ImGuiCol_ScrollbarGrabHovered] = gray(0.32f);
    c[ImGuiCol_ScrollbarGrabActive] = accent(0.7f);
    c[ImGuiCol_TextSelectedBg] = accent(0.32f);
    c[ImGuiCol_NavHighlight] = accent(0.7f);
    c[ImGuiCol_TableRowBgAlt] = gray(1.0f, 0.018f);
    c[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.45f};
}

}  // namespace

void applyTheme(float scale) {
    scaleOfUi = scale;
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.Fonts->Clear();
    io.Fonts->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
    io.Fonts->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    io.FontDefault = addFont("DejaVuSans.ttf", kFontSize * scale);
    bold = addFont("DejaVuSans-Bold.ttf", kFontSize * scale);
    mono = addFont("DejaVuSansMono.ttf", (kFontSize - 1.0f) * scale);
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    setSizes(style);
    setColors(style);
    style.ScaleAllSizes(scale);
}

ImFont* monoFont() {
    return mono;
}
ImFont* boldFont() {
    return bold;
}
float uiScale() {
    return scaleOfUi;
}

}  // namespace editor
