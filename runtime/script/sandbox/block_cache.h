#pragma once
#include <array>
#include <cstddef>

namespace rubble::script {

/// Memory in blocks. Small ones that are given back are kept for the next of their size: a script makes and drops
/// thousands of vectors and texts in a frame.
class BlockCache {
public:
    static constexpr size_t kMaxKept = 1 << 20;  ///< bytes that it keeps

    BlockCache() = default;
    ~BlockCache();
    BlockCache(const BlockCache&) = delete;
    BlockCache& operator=(const BlockCache&) = delete;

    /// A block; null if there is no memory.
    void* take(size_t size);
    /// Gives a block of that size back.
    void give(void* block, size_t size);
    /// A block with what the old one held, which is gone; null if there is no memory: then the old one stays.
    void* resize(void* block, size_t oldSize, size_t size);
    /// Bytes that it keeps.
    size_t kept() const { return m_kept; }

private:
    static constexpr size_t kUnit = 16,
                            kLargest = 512;  ///< bytes: sizes are rounded to units; larger ones are not kept

    struct Free {
        Free* next;
    };
    static size_t rounded(size_t size) { return (size + kUnit - 1) / kUnit * kUnit; }

    std::array<Free*, kLargest / kUnit + 1> m_free{};  ///< by size in units
    size_t m_kept = 0;
};

}  // namespace rubble::script
