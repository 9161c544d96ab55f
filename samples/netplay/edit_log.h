#pragma once
#include <deque>
#include <memory>
#include <rubble/rubble.hpp>
#include <vector>

#include "samples/netplay/body_table.h"
#include "samples/netplay/protocol.h"

namespace netplay {

/// A message that several clients get.
using SharedBytes = std::shared_ptr<const std::vector<uint8_t>>;

/// What the edits of the server's world came to, as messages, and a snapshot to begin with. Whoever joins gets the
/// snapshot and the messages behind it; whoever comes back the messages behind what he has. A new snapshot is made when
/// somebody joins and the messages behind the last one have become longer than it.
class EditLog {
public:
    /// Begins to keep what the world's steps change; both must outlive it.
    EditLog(rubble::World& world, BodyTable& bodies);

    /// After each step of the world: takes up what it changed.
    void follow();
    /// Closes a message with the steps since the last one; to be called before the next three functions. Null if there
    /// was none.
    SharedBytes closeMessage();
    /// The snapshot to join with. isNew: it was made now, so that no message is behind it.
    SharedBytes snapshot();
    /// The messages behind a snapshot() that was just given.
    std::vector<SharedBytes> sinceSnapshot() const { return since(m_snapshotStep); }
    /// Whether since() can be asked for a step: whether a message or a snapshot ended with it and nothing is missing.
    bool has(uint64_t step) const;
    /// The messages behind a step.
    std::vector<SharedBytes> since(uint64_t step) const;

private:
    struct Entry {
        uint64_t before = 0, last = 0;  ///< the step before the first, the last step
        SharedBytes message;
    };
    void makeSnapshot();
    void forgetOldest();

    rubble::World& m_world;
    BodyTable& m_bodies;
    EditSteps m_open;
    std::deque<Entry> m_entries;
    SharedBytes m_snapshot;
    uint64_t m_last = 0, m_snapshotStep = 0;
    size_t m_bytes = 0, m_bytesBehindSnapshot = 0;
};

}  // namespace netplay
