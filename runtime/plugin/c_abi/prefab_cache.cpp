#include "runtime/plugin/c_abi/prefab_cache.h"

#include <algorithm>

#include "runtime/assets/memory_budget.h"

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
    // A hash would read bytes that are not there, of a host that gives a wrong size: read() refuses that by the header.
    const auto known = std::find_if(m_known.begin(), m_known.end(), [&](const Known& each) {
        return std::equal(bytes.begin(), bytes.end(), each.bytes.begin(), each.bytes.end());
    });
    if (known != m_known.end()) {
        m_known.splice(m_known.begin(), m_known, known);
        return known->level;
    }
    Result<Level> level = read();
    if (!level) return Error{level.error()};
    auto shared = std::make_shared<const Level>(std::move(*level));
    const uint64_t memory = bytes.size() + memoryOf(*shared);
    if (memory > kMaxMemory) return shared;
    m_known.push_front({{bytes.begin(), bytes.end()}, shared, memory});
    for (m_memory += memory; m_memory > kMaxMemory; m_known.pop_back()) m_memory -= m_known.back().memory;
    return shared;
}

}  // namespace rubble::abi
