#include "samples/sandbox/shell/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <utility>

namespace sandbox {
namespace {

namespace fs = std::filesystem;
constexpr size_t kSheetFrames = 9, kOverviewFrames = 3;  ///< of a shot
constexpr int kSheetColumns = 3;

std::string writeImage(const std::string& path, const rubble::Image& image) {
    const auto written = rubble::writePng(path, image);
    return written ? "" : written.error();
}

/// So many of the images, evenly, with the first and the last.
std::vector<rubble::Image> some(const std::vector<rubble::Image>& images, size_t count) {
    if (images.size() <= count) return images;
    std::vector<rubble::Image> out;
    for (size_t i = 0; i < count; ++i) out.push_back(images[i * (images.size() - 1) / (count - 1)]);
    return out;
}

bool isInstalled(const std::string& program) {
    return std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) == 0;
}

/// A path as a word of a shell's command line.
std::string inQuotes(const std::string& path) {
    std::string out = "'";
    for (const char c : path) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return out + "'";
}

}  // namespace

Film::Film(std::string folder, const FilmSettings& settings) : m_folder(std::move(folder)), m_fps(settings.fps) {
    std::error_code ignored;
    fs::remove_all(m_folder + "/frames", ignored);
    for (const auto& entry : fs::directory_iterator(m_folder, ignored))
        if (entry.path().filename().string().starts_with("shot_")) fs::remove(entry.path(), ignored);
    for (const char* name : {"film.mp4", "film.webp"}) fs::remove(m_folder + "/" + name, ignored);
    fs::create_directories(m_folder + "/frames", ignored);
}

std::string Film::beginShot(const std::string& name, int frames) {
    const std::string error = writeSheet();
    if (!m_progress) m_progress.emplace("film, frames", frames);
    m_shot = name;
    ++m_shots;
    m_figures.beginShot(name);
    return error;
}

std::string Film::add(rubble::Image frame, double milliseconds) {
    if (!m_shots) return "";
    const std::string error = writeImage(fmt::format("{}/frames/{:04d}.png", m_folder, m_count), frame);
    m_progress->advance(++m_count);
    m_figures.addFrame(milliseconds);
    m_frames.push_back(std::move(frame));
    return error;
}

std::string Film::writeSheet() {
    if (m_frames.empty()) return "";
    for (rubble::Image& image : some(m_frames, kOverviewFrames)) m_overview.push_back(std::move(image));
    const rubble::Image sheet = rubble::tile(some(m_frames, kSheetFrames), kSheetColumns);
    m_frames.clear();
    return writeImage(fmt::format("{}/shot_{}_{}.png", m_folder, m_shots, m_shot), sheet);
}

/// By ffmpeg, which also puts the sound in; else by img2webp as an animated image.
void Film::makeVideo() const {
    const std::string frames = m_folder + "/frames/";
    std::string video = m_folder + "/film.mp4", command;
    if (isInstalled("ffmpeg")) {
        const std::string sound = fs::exists(soundFile(m_folder))
                                      ? fmt::format("-i {} -c:a aac -af apad -shortest ", inQuotes(soundFile(m_folder)))
                                      : "";
        command = fmt::format("ffmpeg -loglevel error -y -framerate {} -i {} {}-pix_fmt yuv420p -crf 16 {}", m_fps,
                              inQuotes(frames + "%04d.png"), sound, inQuotes(video));
    } else if (isInstalled("img2webp")) {
        video = m_folder + "/film.webp";
        command = fmt::format("img2webp -loop 0 -lossy -q 60 -d {} {}*.png -o {} >/dev/null", 1000 / m_fps,
                              inQuotes(frames), inQuotes(video));
    } else {
        fmt::print("no video: neither ffmpeg (Debian package ffmpeg) nor img2webp (webp) is installed\n");
        return;
    }
    if (std::system(command.c_str()) != 0) fmt::print(stderr, "sandbox: {} was not made\n", video);
}

std::string Film::finish(uint64_t stateHash) {
    if (std::string error = writeSheet(); !error.empty()) return error;
    if (m_overview.empty()) return "the film has no frame";
    if (std::string error = writeImage(m_folder + "/contact_sheet.png", rubble::tile(m_overview, kSheetColumns));
        !error.empty())
        return error;
    makeVideo();
    const std::string table = m_figures.table() + fmt::format("state hash {:016x}\n", stateHash);
    std::ofstream file(m_folder + "/figures.txt");
    if (!(file << table).flush()) return m_folder + "/figures.txt: cannot write the figures";
    fmt::print("{}film, contact sheets and figures are in {}\n", table, fs::absolute(m_folder).string());
    return "";
}

}  // namespace sandbox
