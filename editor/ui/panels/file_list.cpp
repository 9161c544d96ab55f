#include "editor/ui/panels/file_list.h"

#include <fmt/format.h>

#include <filesystem>

#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

std::string sizeText(uint64_t bytes) {
    if (bytes < 10'000) return fmt::format("{} B", bytes);
    return bytes < 10'000'000 ? fmt::format("{} KB", bytes / 1000) : fmt::format("{} MB", bytes / 1'000'000);
}

/// A folder's path that ends in a slash, without "..".
std::string cleanFolder(const std::string& folder) {
    std::error_code error;
    const auto full = std::filesystem::absolute(folder + "/", error).lexically_normal();
    return error ? folder : full.string();
}

}  // namespace

bool FileList::draw(std::string& path, std::string_view endings, const std::string& otherwise) {
    if (path != m_path) {
        m_path = path;
        m_folder = cleanFolder(folderOf(path, otherwise));
        m_entries = listFiles(m_folder, endings, path);
    }
    std::string chosen;
    bool isDone = false;
    ImGui::TextDisabled("%s", m_folder.c_str());
    ImGui::BeginChild("files");
    if (ImGui::Selectable("   ..")) chosen = cleanFolder(m_folder + "..");
    tooltip("The folder around this one");
    ImGuiListClipper clipper;
    clipper.Begin(int(m_entries.size()));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const FileEntry& entry = m_entries[size_t(i)];
            const ImVec2 at = ImGui::GetCursorScreenPos();
            ImGui::PushID(i);
            if (ImGui::Selectable("##entry", path == m_folder + entry.name, ImGuiSelectableFlags_AllowDoubleClick)) {
                chosen = m_folder + entry.name + (entry.isFolder ? "/" : "");
                isDone = !entry.isFolder && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left);
            }
            ImGui::PopID();
            ImDrawList& list = *ImGui::GetWindowDrawList();
            const float side = ImGui::GetTextLineHeight();
            if (entry.isFolder) drawIcon(list, Icon::Open, at, side, theme::kDim);
            list.AddText({at.x + 1.6f * side, at.y}, theme::kText, entry.name.c_str());
            if (entry.isFolder) continue;
            const std::string size = sizeText(entry.bytes);
            const float right = at.x + ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(size.c_str()).x;
            list.AddText({right - 6 * uiScale(), at.y}, theme::kDim, size.c_str());
        }
    if (m_entries.empty()) ImGui::TextDisabled("   no folder and no %s", std::string(endings).c_str());
    ImGui::EndChild();
    if (!chosen.empty()) path = chosen;
    return isDone;
}

}  // namespace editor
