#pragma once
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <span>
#include <vector>

#include "runtime/core/result.h"
#include "runtime/world/level/level.h"

namespace rubble::abi {

/// Levels that were placed as prefabs: what has the bytes of one of them is not read again. Worlds share their bricks,
/// so that one which is placed costs little more. Beyond kMaxMemory those that were used longest ago are forgotten.
class PrefabCache {
public:
    static constexpr uint64_t kMaxMemory = uint64_t(64) << 20;  ///< bytes of files, and about what was read of them

    /// The level of a file's bytes; read() reads it where it is not known.
    Result<std::shared_ptr<const Level>> get(std::span<const uint8_t> bytes,
                                             const std::function<Result<Level>()>& read);
    /// How many it holds.
    size_t size() const { return m_known.size(); }

private:
    struct Known {
        std::vector<uint8_t> bytes;
        std::shared_ptr<const Level> level;
        uint64_t memory;
    };
    std::list<Known> m_known;  ///< the one that was used last first
    uint64_t m_memory = 0;
};

}  // namespace rubble::abi
