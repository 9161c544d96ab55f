#pragma once
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <rubble/rubble.hpp>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

namespace editor {

/// What tells that a file was written.
struct FileState {
    uint64_t size = 0, device = 0, number = 0;
    int64_t seconds = 0, nanoseconds = 0;
    bool operator==(const FileState&) const = default;
};

/// That of a path; none: there is no file, or no path.
std::optional<FileState> fileStateOf(const std::string& path);

/// What a journal is of.
struct JournalLevel {
    std::string path;               ///< of the level's file; empty: it has none
    std::optional<FileState> file;  ///< as it was loaded or saved; none: there was none
};

/// What a journal holds of a level that was not closed.
struct Recovery {
    JournalLevel level;
    size_t changes = 0;       ///< that come back: those since it was opened or saved, a play that was kept as one
    bool isTailLost = false;  ///< a record is damaged, as by a power failure: it and what follows are left out
};

/// Keeps what is done to a level on the disk until it is closed, so that a crash loses nothing of it. A folder holds
/// the game at the beginning (base-N.rubble) and what each step came to since then (changes-N): deltas of the world,
/// which know all kinds of changes. A save begins the next N. Only one journal at a time has a folder.
class Journal {
public:
    /// Takes the folder, which is made. Throws Refused where another editor has it, or it cannot be written.
    explicit Journal(std::string folder);
    /// Closes it: what it holds is removed, unless it waits for recover() or discard(), or was recovered and not saved.
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// What is there of an editor that has crashed; none: nothing.
    const std::optional<Recovery>& found() const { return m_found; }
    /// Makes that level of the world, exactly as it was, but without a play that was not ended. Throws rubble::Error
    /// where it is damaged.
    void recover(rubble::World& world) const;
    /// Forgets what is there, so that closing it keeps nothing.
    void discard();

    /// Begins again: the world as it is now is the base, and it keeps deltas from now on. What was there is removed.
    /// recovered: how many changes of the base are not in the level's file, so that closing keeps the journal.
    void begin(rubble::World& world, const JournalLevel& level, size_t recovered = 0);
    /// Play begins: a crash before it ends comes back to here.
    void beginPlay();
    /// Play has ended; isKept: what became of the level is one change of it, else the level is as it was.
    void endPlay(bool isKept);
    /// Adds what the world's steps came to, as its deltas. When this returns, the system has it, so that it outlives
    /// this process; within a second a thread brings it to the disk.
    void add(const std::vector<uint8_t>& deltas);

private:
    enum class Kind : uint8_t { Change = 1, PlayBegins, PlayEnds, Recovered };
    struct Record {
        Kind kind;
        std::vector<uint8_t> bytes;
    };
    struct Content {
        JournalLevel level;
        std::vector<Record> records;
        bool isTailLost = false;
    };
    static std::vector<uint8_t> bytesOf(const JournalLevel& level);
    static JournalLevel levelOf(const std::vector<uint8_t>& bytes);
    std::string file(const char* name, uint64_t number) const;
    uint64_t last() const;
    Content read() const;
    std::optional<Recovery> look() const;
    void write(Kind kind, const std::vector<uint8_t>& bytes);
    void removeOthers(uint64_t number) const;
    void bringToDisk(const std::stop_token& stop);
    void closeChanges();

    std::string m_folder;
    int m_lock = -1, m_changes = -1;  ///< file descriptors
    uint64_t m_number = 0;
    std::optional<Recovery> m_found;
    bool m_isRecovered = false;  ///< what is kept was not saved before, nor since
    std::mutex m_mutex;          ///< of m_changes and m_isDirty
    std::condition_variable_any m_wake;
    bool m_isDirty = false;  ///< something is not on the disk yet
    std::jthread m_thread;   ///< bringToDisk()
};

/// Where the journal of a level lies in a folder of journals: a folder of its own, by the level's path.
std::string journalFolder(const std::string& journals, const std::string& level);
/// The folder of journals of this user: $XDG_STATE_HOME/rubble, else ~/.local/state/rubble; empty: there is no home.
std::string userJournals();

}  // namespace editor
