#include "runtime/script/sandbox/block_cache.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

namespace rubble::script {

BlockCache::~BlockCache() {
    for (Free* block : m_free)
        while (block) std::free(std::exchange(block, block->next));
}

void* BlockCache::take(size_t size) {
    size = rounded(size);
    if (size > kLargest || !m_free[size / kUnit]) return std::malloc(size);
    m_kept -= size;
    return std::exchange(m_free[size / kUnit], m_free[size / kUnit]->next);
}

void BlockCache::give(void* block, size_t size) {
    size = rounded(size);
    if (size > kLargest || m_kept + size > kMaxKept) return std::free(block);
    m_kept += size;
    Free*& first = m_free[size / kUnit];
    first = new (block) Free{first};
}

void* BlockCache::resize(void* block, size_t oldSize, size_t size) {
    if (rounded(oldSize) == rounded(size)) return block;
    if (std::min(oldSize, size) > kLargest) return std::realloc(block, rounded(size));
    void* const moved = take(size);
    if (!moved) return nullptr;
    std::memcpy(moved, block, std::min(oldSize, size));
    give(block, oldSize);
    return moved;
}

}  // namespace rubble::script
