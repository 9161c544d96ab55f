#include "samples/stress/results.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

namespace stress {
namespace {

namespace fs = std::filesystem;

bool isDigit(char each) {
    return std::isdigit(static_cast<unsigned char>(each));
}

/// The scenario's file that results are of; none: they do not say it.
std::optional<std::string> originOf(const std::string& path) {
    const auto file = nlohmann::json::parse(std::ifstream(path), nullptr, false);
    if (!file.is_object() || !file.contains("file") || !file["file"].is_string()) return {};
    return file["file"].get<std::string>();
}

/// Whether a file's name is that of an image of the run.
bool isImage(const std::string& name, std::string_view begin) {
    constexpr std::string_view kEnd = ".png";
    if (name.size() <= begin.size() + kEnd.size() || !name.starts_with(begin) || !name.ends_with(kEnd)) return false;
    return std::all_of(name.begin() + std::ptrdiff_t(begin.size()), name.end() - std::ptrdiff_t(kEnd.size()), isDigit);
}

/// Locks an open file; false: another process has locked it.
bool lockFile(int file) {
    return flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

/// Whether the results are of a run that goes on: its figures are written, its images not yet.
bool isDrawn(const std::string& path) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool isHeld = file >= 0 && !lockFile(file);
    if (file >= 0) close(file);
    return isHeld;
}

/// Whether an open file is the one at a path: it may have been renamed after it was opened.
bool isAt(int file, const std::string& path) {
    struct stat opened = {}, found = {};
    return fstat(file, &opened) == 0 && stat(path.c_str(), &found) == 0 && opened.st_dev == found.st_dev &&
           opened.st_ino == found.st_ino;
}

}  // namespace

std::string resultPath(const RunSettings& settings, const std::string& ending) {
    return fmt::format("{}/{}_{}{}", settings.folder, settings.name, settings.seed, ending);
}

ResultFiles::~ResultFiles() {
    if (m_begun >= 0) close(m_begun);
}

std::string ResultFiles::begin(const RunSettings& settings, const std::string& build) {
    for (const char* ending : {".json", ".json.part"})
        if (const auto origin = originOf(resultPath(settings, ending)); origin && *origin != settings.file)
            return fmt::format("{} is of another scenario, {}: expected another --out, or that it is removed",
                               resultPath(settings, ending), origin->empty() ? "that --list shows" : *origin);
    const std::string path = resultPath(settings, ".json.part"), figures = resultPath(settings, ".json");
    m_begun = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (m_begun < 0) return "cannot write " + path;
    const bool isOurs = lockFile(m_begun) && isAt(m_begun, path), isFree = isOurs && !isDrawn(figures);
    std::error_code error;
    if (isOurs && !isFree) fs::remove(path, error);
    if (!isFree) return fmt::format("{} is of a run that goes on: expected another --out, or that it ends", path);
    for (const char* ending : {".json", ".rubblelog", ".rubblelog.part", "_failure.lua"})
        fs::remove(resultPath(settings, ending), error);
    const std::string images = fmt::format("{}_{}_", settings.name, settings.seed);
    for (const auto& entry : fs::directory_iterator(settings.folder, error))
        if (isImage(entry.path().filename().string(), images)) fs::remove(entry.path(), error);
    std::ofstream out(path);
    const nlohmann::json begun = {
        {"scenario", settings.name}, {"seed", settings.seed}, {"file", settings.file}, {"build", build}};
    out << begun.dump(1, ' ', false, nlohmann::json::error_handler_t::replace) << "\n";
    return out.flush() ? "" : "cannot write " + path;
}

std::string shellWord(const std::string& text) {
    const auto isPlain = [](char each) {
        return std::isalnum(static_cast<unsigned char>(each)) ||
               std::string_view("/._-+,:=@%").find(each) != std::string_view::npos;
    };
    if (!text.empty() && std::all_of(text.begin(), text.end(), isPlain)) return text;
    const bool hasControls = std::any_of(text.begin(), text.end(), [](char each) { return each >= 0 && each < 32; });
    std::string word = hasControls ? "$'" : "'";
    for (const char each : text)
        if (hasControls && each >= 0 && each < 32)
            word += fmt::format("\\{:03o}", int(each));
        else if (hasControls && (each == '\'' || each == '\\'))
            word += {'\\', each};
        else
            word += each == '\'' ? "'\\''" : std::string(1, each);
    return word + "'";
}

}  // namespace stress
