#pragma once
#include <optional>
#include <string>
#include <vector>

#include "editor/ui/host/stage.h"

namespace editor {

/// Makes a folder and tries to write there; "" names none. What is wrong, or "".
std::string folderError(const std::string& folder);

/// The window without a window: its images are drawn into memory, and its mouse is moved by lines of a script. Lines
/// that begin with `ui` drive the interface, see kVerbs in scripted_ui.cpp; all others are commands.
class ScriptedUi {
public:
    /// In pixels. Throws std::runtime_error where there is no GL.
    ScriptedUi(const StageSettings& settings, int width, int height);
    ScriptedUi(const ScriptedUi&) = delete;
    ScriptedUi& operator=(const ScriptedUi&) = delete;

    /// Runs a line. An error says what is wrong with it; empty: nothing.
    std::string run(const std::string& line);
    /// Runs lines, up to the first one that fails; its error has the line's number, and the file that they are of. $OUT
    /// in them is the folder of images.
    std::string runAll(const std::string& lines, const std::string& file = {});
    /// Makes frames of the interface without the image of the level.
    void frames(int count);
    /// Where images without a path of their own come.
    void setFolder(const std::string& folder) { m_folder = folder; }
    /// The editor with its interface.
    Stage& stage() { return *m_stage; }

private:
    struct Verb;
    static const Verb kVerbs[];
    using Words = std::vector<Given>;

    void frame(double share);
    void look(const Words& words);
    void setMode(const Words& words);
    void setBrush(const Words& words);
    void setBreaker(const Words& words);
    void hover(const Words& words);
    void moveTo(const Words& words);
    void moveBy(const Words& words);
    void leave(const Words& words);
    void click(const Words& words);
    void press(const Words& words);
    void release(const Words& words);
    void pressKeys(const Words& words);
    void showTab(const Words& words);
    void showOverlay(const Words& words);
    void showPass(const Words& words);
    void showCommands(const Words& words);
    void showForm(const Words& words);
    void showTour(const Words& words);
    void closeCommands(const Words& words);
    void frameSelection(const Words& words);
    void play(const Words& words);
    void replay(const Words& words);
    void live(const Words& words);
    void film(const Words& words);
    void writeImage(const Words& words);

    OffscreenGl m_gl;
    std::optional<Stage> m_stage;
    std::string m_folder;
    int m_width, m_height;
    bool m_isDown = false;
    float m_x = -1.0f, m_y = -1.0f;
};

/// The script of the images that show what the window can do, with a level of its own.
extern const char* const kShowcase;
/// The same with the level that is open, whatever is in it.
extern const char* const kLevelShowcase;

}  // namespace editor
