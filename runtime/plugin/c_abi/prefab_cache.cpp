#include "runtime/plugin/c_abi/prefab_cache.h"

#include <algorithm>

#include "runtime/assets/memory_budget.h"
#include "runtime/core/hash.h"

namespace rubble::abi {
namespace {

uint64_t memoryOf(const Level& level) {
    uint64_t memory = sizeof level;
    for (const LevelBody& body : level.bodies) {
        memory += sizeof body;
        for (const LevelShape& shape : body.shapes) memory += sizeof shape + shape.grid.brickCount() * kBrickMemory;
    }
    return memory;
}

}  // namespace

Result<std::shared_ptr<const Level>> PrefabCache::get(std::span<const uint8_t> bytes,
                                                      const std::function<Result<Level>()>& read) {
    const auto readNew = [&]() -> Result<std::shared_ptr<const Level>> {
        Result<Level> level = read();
        if (!level) return Error{level.error()};
        return std::make_shared<const Level>(std::move(*level));
    };
    if (bytes.size() > kMaxMemory) return readNew();  // also of a host's data that are shorter than it says
    const uint64_t hash = hashBytes(bytes.data(), bytes.size());
    const auto known = std::find_if(m_known.begin(), m_known.end(), [&](const Known& each) {
        return each.hash == hash && std::equal(bytes.begin(), bytes.end(), each.bytes.begin(), each.bytes.end());
    });
    if (known != m_known.end()) {
        m_known.splice(m_known.begin(), m_known, known);
        return known->level;
    }
    const auto level = readNew();
    const uint64_t memory = level ? bytes.size() + memoryOf(**level) : 0;
    if (!level || memory > kMaxMemory) return level;
    m_known.push_front({hash, {bytes.begin(), bytes.end()}, *level, memory});
    for (m_memory += memory; m_memory > kMaxMemory; m_known.pop_back()) m_memory -= m_known.back().memory;
    return level;
}

}  // namespace rubble::abi
