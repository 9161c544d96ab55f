#include <fmt/format.h>

#include <algorithm>

#include "editor/ui/panels/panels.h"
#include "editor/ui/panels/widgets.h"
#include "editor/ui/state/theme.h"

namespace editor {
namespace {

void show(Session& session, int step) {
    try {
        session.replay.seek(size_t(std::clamp(step, 1, int(session.replay.size()))));
        session.showsReplay = true;
    } catch (const rubble::Error& error) {
        session.showsReplay = false;
        session.say(Message::Kind::Error, std::string("replay: ") + error.what());
    }
}

}  // namespace

void drawReplay(Session& session) {
    static bool runs = false;
    Replay& replay = session.replay;
    const int size = int(replay.size());
    if (size == 0) {
        ImGui::TextDisabled("Nothing has been played yet.");
        return ImGui::TextUnformatted("Play, then drag here to any step of it, also after a stop.");
    }
    const bool plays = session.editor().document().isPlaying() && !session.isPaused;
    int step = session.showsReplay ? int(replay.place()) : size;
    ImGui::SetNextItemWidth(-1);
    const std::string shown = fmt::format("step %d of {}", size);
    if (ImGui::SliderInt("##step", &step, 1, size, shown.c_str())) runs = false, show(session, step);
    tooltip("Drags the view to any step of the last play");
    if (iconButton("run", runs ? Icon::Pause : Icon::Play, runs, "Runs the replay", !plays)) {
        runs = !runs;
        if (runs && step == size) show(session, 1);
    }
    ImGui::SameLine(0, 2);
    if (iconButton("back", Icon::Undo, false, "One step back", step > 1)) show(session, step - 1);
    ImGui::SameLine(0, 2);
    if (iconButton("on", Icon::Redo, false, "One step on", step < size)) show(session, step + 1);
    ImGui::SameLine(0, 8 * uiScale());
    if (iconButton("live", Icon::Stop, false, "Back to the level itself", session.showsReplay)) {
        session.showsReplay = runs = false;
    }
    const Document& document = session.editor().document();
    ImGui::SameLine(0, 2);
    if (iconButton("from here", Icon::Rewind, false,
                   "Play goes back to the half second that is shown, and on from there",
                   session.showsReplay && document.isPlaying())) {
        runs = false;
        session.isPaused = true;
        return void(session.run("rewind", {{"steps", std::to_string(document.playedSteps() - uint64_t(step))}}));
    }
    ImGui::SameLine(0, 12 * uiScale());
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%.2f s of %.2f s, %.1f MB", step / 60.0, size / 60.0, double(replay.bytes()) / 1e6);
    if (runs && session.showsReplay && step < size) show(session, step + 1);
    if (step >= size) runs = false;
}

}  // namespace editor
