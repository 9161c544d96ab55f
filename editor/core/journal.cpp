#include "editor/core/journal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <utility>

#include "editor/core/arguments.h"

namespace editor {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMagic = "rubble journal 1\n";
constexpr uint64_t kMaxRecord = uint64_t(1) << 32;
constexpr ptrdiff_t kFileStateBytes = 48;  ///< of a FileState, before the level's path

/// FNV-1a: against bytes that were never written.
uint64_t checksum(const uint8_t* bytes, size_t size, uint64_t hash = 0xcbf29ce484222325ull) {
    for (size_t i = 0; i < size; ++i) hash = (hash ^ bytes[i]) * 0x100000001b3ull;
    return hash;
}

[[noreturn]] void fail(const std::string& path, const char* what) {
    throw Refused(fmt::format("journal: {}: {}: {}", path, what, std::strerror(errno)));
}

void writeAll(int descriptor, const std::string& path, const uint8_t* bytes, size_t size) {
    while (size > 0) {
        const ssize_t done = ::write(descriptor, bytes, size);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) fail(path, "cannot write");
        bytes += done;
        size -= size_t(done);
    }
}

std::vector<uint8_t> readAll(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Eight bytes, the lowest first.
void addNumber(std::vector<uint8_t>& out, uint64_t value) {
    for (int i = 0; i < 8; ++i) out.push_back(uint8_t(value >> (8 * i)));
}

uint64_t numberAt(const uint8_t* bytes) {
    uint64_t value = 0;
    for (int i = 7; i >= 0; --i) value = value << 8 | bytes[i];
    return value;
}

}  // namespace

std::optional<FileState> fileStateOf(const std::string& path) {
    struct stat now {};
    if (path.empty() || ::stat(path.c_str(), &now) != 0) return std::nullopt;
    return FileState{uint64_t(now.st_size), uint64_t(now.st_dev), uint64_t(now.st_ino), now.st_mtim.tv_sec,
                     now.st_mtim.tv_nsec};
}

Journal::Journal(std::string folder) : m_folder(std::move(folder)) {
    std::error_code code;
    fs::create_directories(m_folder, code);
    if (code)
        throw Refused(fmt::format("journal: {}: expected a folder that can be made: {}", m_folder, code.message()));
    const std::string lock = m_folder + "/lock";
    m_lock = ::open(lock.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (m_lock < 0) fail(lock, "cannot open");
    if (::flock(m_lock, LOCK_EX | LOCK_NB) == 0) {
        m_found = look();
        return;
    }
    ::close(m_lock);
    throw Refused(fmt::format("journal: another editor has this level open, whose journal is in {}", m_folder));
}

Journal::~Journal() {
    closeChanges();
    std::error_code code;
    if (!m_found && !m_isRecovered) fs::remove_all(m_folder, code);  // with the lock, while it is held
    ::close(m_lock);
}

std::string Journal::file(const char* name, uint64_t number) const {
    return fmt::format("{}/{}-{}{}", m_folder, name, number, name[0] == 'b' ? ".rubble" : "");
}

/// The highest number of a whole base; 0: there is none.
uint64_t Journal::last() const {
    uint64_t last = 0;
    std::error_code code;
    for (const fs::directory_entry& each : fs::directory_iterator(m_folder, code)) {
        unsigned long long number = 0;
        int end = 0;
        const std::string name = each.path().filename().string();
        if (std::sscanf(name.c_str(), "base-%llu.rubble%n", &number, &end) == 1 && size_t(end) == name.size())
            last = std::max<uint64_t>(last, number);
    }
    return last;
}

std::vector<uint8_t> Journal::bytesOf(const JournalLevel& level) {
    std::vector<uint8_t> out;
    const FileState file = level.file.value_or(FileState{});
    addNumber(out, level.file.has_value());
    for (const uint64_t each :
         {file.size, file.device, file.number, uint64_t(file.seconds), uint64_t(file.nanoseconds)})
        addNumber(out, each);
    out.insert(out.end(), level.path.begin(), level.path.end());
    return out;
}

JournalLevel Journal::levelOf(const std::vector<uint8_t>& bytes) {
    JournalLevel out;
    if (bytes.size() < size_t(kFileStateBytes)) return out;
    const auto number = [&](size_t i) { return numberAt(bytes.data() + 8 * i); };
    if (number(0)) out.file = FileState{number(1), number(2), number(3), int64_t(number(4)), int64_t(number(5))};
    out.path.assign(bytes.begin() + kFileStateBytes, bytes.end());
    return out;
}

/// Records up to the first one that is not whole.
Journal::Content Journal::read() const {
    Content out;
    const std::vector<uint8_t> bytes = readAll(file("changes", last()));
    const uint8_t *at = bytes.data(), *end = at + bytes.size();
    out.isTailLost = at != end;
    if (bytes.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), at)) return out;
    at += kMagic.size();
    bool isFirst = true;
    while (end - at >= 17) {
        const uint64_t size = numberAt(at + 1), sum = numberAt(at + 9);
        if (size > kMaxRecord || uint64_t(end - at - 17) < size || checksum(at + 17, size, checksum(at, 9)) != sum)
            break;
        Record record{Kind(at[0]), {at + 17, at + 17 + size}};
        at += 17 + size;
        if (isFirst)
            out.level = levelOf(record.bytes);
        else
            out.records.push_back(std::move(record));
        isFirst = false;
    }
    out.isTailLost = at != end;
    return out;
}

std::optional<Recovery> Journal::look() const {
    if (last() == 0) return std::nullopt;
    const Content content = read();
    size_t changes = 0;
    bool isPlaying = false;
    for (const Record& each : content.records) {
        if (each.kind == Kind::PlayBegins) isPlaying = true;
        if (each.kind == Kind::PlayEnds) isPlaying = false;
        if (each.kind == Kind::Change && !isPlaying) ++changes;
        if (each.kind == Kind::PlayEnds && each.bytes != std::vector<uint8_t>{false}) ++changes;
        if (each.kind == Kind::Recovered && each.bytes.size() == 8) changes += numberAt(each.bytes.data());
    }
    if (changes == 0 && !content.isTailLost) return std::nullopt;
    return Recovery{content.level, changes, content.isTailLost};
}

void Journal::recover(rubble::World& world) const {
    const Content content = read();
    world.load_game(file("base", last()).c_str());
    auto end = content.records.end();
    for (auto each = content.records.begin(); each != content.records.end(); ++each) {
        if (each->kind == Kind::PlayBegins) end = each;
        if (each->kind == Kind::PlayEnds) end = content.records.end();
    }
    for (auto each = content.records.begin(); each != end; ++each)
        if (each->kind == Kind::Change) world.apply_deltas(each->bytes.data(), each->bytes.size());
}

void Journal::begin(rubble::World& world, const JournalLevel& level, size_t recovered) {
    const uint64_t number = last() + 1;
    world.save_game(file("base", number).c_str());
    closeChanges();
    m_number = number;
    const std::string path = file("changes", number);
    m_changes = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC, 0600);
    if (m_changes < 0) fail(path, "cannot open");
    writeAll(m_changes, path, reinterpret_cast<const uint8_t*>(kMagic.data()), kMagic.size());
    write(Kind::Change, bytesOf(level));
    if (recovered) {
        std::vector<uint8_t> count;
        addNumber(count, recovered);
        write(Kind::Recovered, count);
    }
    m_isRecovered = recovered > 0;
    m_thread = std::jthread([this](const std::stop_token& stop) { bringToDisk(stop); });
    m_found.reset();
    removeOthers(number);
}

void Journal::discard() {
    removeOthers(0);
    m_found.reset();
    m_isRecovered = false;
}

void Journal::beginPlay() {
    write(Kind::PlayBegins, {});
}

void Journal::endPlay(bool isKept) {
    write(Kind::PlayEnds, {isKept});
}

void Journal::add(const std::vector<uint8_t>& deltas) {
    write(Kind::Change, deltas);
}

void Journal::write(Kind kind, const std::vector<uint8_t>& bytes) {
    std::vector<uint8_t> record{uint8_t(kind)};
    record.reserve(17 + bytes.size());
    addNumber(record, bytes.size());
    addNumber(record, checksum(bytes.data(), bytes.size(), checksum(record.data(), 9)));
    record.insert(record.end(), bytes.begin(), bytes.end());
    writeAll(m_changes, file("changes", m_number), record.data(), record.size());
    const std::scoped_lock lock(m_mutex);
    m_isDirty = true;
}

/// Once a second at most; a second after the first change at the latest.
void Journal::bringToDisk(const std::stop_token& stop) {
    std::unique_lock lock(m_mutex);
    while (!stop.stop_requested()) {
        m_wake.wait_for(lock, stop, std::chrono::milliseconds(900), [] { return false; });
        if (!std::exchange(m_isDirty, false)) continue;
        const int changes = m_changes;
        lock.unlock();
        ::fdatasync(changes);
        lock.lock();
    }
}

void Journal::closeChanges() {
    m_thread = {};  // it ends first
    if (m_changes >= 0) ::close(m_changes);
    m_changes = -1;
}

/// Removes all but those of a number.
void Journal::removeOthers(uint64_t number) const {
    std::error_code code;
    const fs::path base = file("base", number), changes = file("changes", number), lock = m_folder + "/lock";
    std::vector<fs::path> all;
    for (const fs::directory_entry& each : fs::directory_iterator(m_folder, code)) all.push_back(each.path());
    for (const fs::path& each : all)
        if (each != base && each != changes && each != lock) fs::remove(each, code);
}

std::string journalFolder(const std::string& journals, const std::string& level) {
    if (level.empty()) return journals + "/untitled";
    const std::string path = fs::absolute(level).lexically_normal().string();
    const uint64_t hash = checksum(reinterpret_cast<const uint8_t*>(path.data()), path.size());
    return fmt::format("{}/{}-{:016x}", journals, fs::path(path).filename().string(), hash);
}

std::string userJournals() {
    const char *state = std::getenv("XDG_STATE_HOME"), *home = std::getenv("HOME");
    if (state && *state) return std::string(state) + "/rubble";
    return home && *home ? std::string(home) + "/.local/state/rubble" : "";
}

}  // namespace editor
