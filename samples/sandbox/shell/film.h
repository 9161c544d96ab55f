#pragma once
#include <optional>
#include <string>
#include <vector>

#include "samples/sandbox/shell/film_figures.h"
#include "samples/support/image.h"
#include "samples/support/progress.h"

namespace sandbox {

/// What a film is made with.
struct FilmSettings {
    std::string script;    ///< a file of the game's folder that directs it; "": no film
    std::string shot;      ///< the only one that is filmed; "": all
    double seconds = 0.0;  ///< of the whole film, whose shots are made so much shorter; 0: as long as they are
    int fps = 20;
};

/// The files of a film: frames, a contact sheet of each shot, a video, figures.
class Film {
public:
    /// `folder` is made, and an earlier film in it removed.
    Film(std::string folder, const FilmSettings& settings);

    /// The frames from here on are another shot. `frames`: how many frames the film has in all.
    std::string beginShot(const std::string& name, int frames);
    /// Whether there is a shot.
    bool hasBegun() const { return m_shots > 0; }
    /// The next frame, and the milliseconds of its drawing. What is wrong, or "".
    std::string add(rubble::Image frame, double milliseconds);
    /// Writes sheets, video and figures, and prints the figures. What is wrong, or "".
    std::string finish(uint64_t stateHash);

    /// What its steps and frames have cost.
    FilmFigures& figures() { return m_figures; }
    /// Of a folder of films: a WAV file that is the video's sound if it is there at the end.
    static std::string soundFile(const std::string& folder) { return folder + "/sound.wav"; }

private:
    std::string writeSheet();
    void makeVideo() const;

    std::string m_folder;
    int m_fps, m_count = 0;
    std::string m_shot;
    size_t m_shots = 0;
    std::vector<rubble::Image> m_frames, m_overview;  ///< of this shot; three of each shot
    FilmFigures m_figures;
    std::optional<rubble::Progress> m_progress;
};

}  // namespace sandbox
