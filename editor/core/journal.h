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

/// What a journal holds of a level that was not closed.
struct Recovery {
    std::string level;        ///< the level's file; empty: it had none
    size_t changes = 0;       ///< records since it was opened or saved
    bool isTailLost = false;  ///< the last record is damaged, as by a power failure, and is left out
};

/// Keeps what is done to a level on the disk until it is closed, so that a crash loses nothing of it. A folder holds
/// the game at the beginning (base-N.rubble) and what each step came to since then (changes-N): deltas of the world,
/// which know all kinds of changes. A save begins the next N. Only one journal at a time has a folder.
class Journal {
public:
    /// Takes the folder, which is made. Throws Refused where another editor has it, or it cannot be written.
    explicit Journal(std::string folder);
    /// Closes it: what it holds is removed, unless it waits for recover() or discard().
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    /// What is there of an editor that has crashed; none: nothing.
    const std::optional<Recovery>& found() const { return m_found; }
    /// Makes that level of the world, exactly as it was, but without a play that was not ended; returns its file.
    /// Throws rubble::Error where it is damaged.
    std::string recover(rubble::World& world) const;
    /// Forgets what is there.
    void discard();

    /// Begins again: the world as it is now is the base, and it keeps deltas from now on. What was there is removed.
    void begin(rubble::World& world, const std::string& level);
    /// Play begins or has ended: a crash in between comes back to its beginning.
    void markPlay(bool begins);
    /// Adds what the world's steps came to since the last call. When this returns, the system has it, so that it
    /// outlives this process; within a second a thread brings it to the disk.
    void add(rubble::World& world);

private:
    enum class Kind : uint8_t { Change = 1, PlayBegins, PlayEnds };
    struct Record {
        Kind kind;
        std::vector<uint8_t> bytes;
    };
    struct Content {
        std::string level;
        std::vector<Record> records;
        bool isTailLost = false;
    };
    std::string file(const char* name, uint64_t number) const;
    uint64_t last() const;
    Content read() const;
    std::optional<Recovery> look() const;
    void write(Kind kind, const std::vector<uint8_t>& bytes);
    void removeOthers(uint64_t number) const;

    std::string m_folder;
    int m_lock = -1, m_changes = -1;  ///< file descriptors
    uint64_t m_number = 0;
    void bringToDisk(const std::stop_token& stop);
    void closeChanges();
    std::optional<Recovery> m_found;
    std::mutex m_mutex;  ///< of m_changes and m_isDirty
    std::condition_variable_any m_wake;
    bool m_isDirty = false;  ///< something is not on the disk yet
    std::jthread m_thread;   ///< bringToDisk()
};

/// Where the journal of a level lies in a folder of journals: a folder of its own, by the level's path.
std::string journalFolder(const std::string& journals, const std::string& level);
/// The folder of journals of this user: $XDG_STATE_HOME/rubble, else ~/.local/state/rubble; empty: there is no home.
std::string userJournals();

}  // namespace editor
