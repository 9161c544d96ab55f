#pragma once
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <utility>

namespace rubble {

/// Memory for objects of one type that come and go all the time: what is given back is kept for the next of them.
/// [any-thread]
class BlockPool {
public:
    /// Keeps at most so many blocks.
    explicit BlockPool(size_t mostKept) : m_mostKept(mostKept) {}
    ~BlockPool() {
        while (m_free) ::operator delete(std::exchange(m_free, m_free->next));
    }
    BlockPool(const BlockPool&) = delete;
    BlockPool& operator=(const BlockPool&) = delete;

    /// A block of that many bytes, always the same number.
    void* take(size_t bytes) {
        const std::lock_guard lock(m_mutex);
        if (!m_free) return ::operator new(bytes);
        --m_kept;
        return std::exchange(m_free, m_free->next);
    }
    /// Gives one back.
    void give(void* block) {
        const std::lock_guard lock(m_mutex);
        if (m_kept == m_mostKept) return ::operator delete(block);
        ++m_kept;
        m_free = new (block) Free{m_free};
    }

private:
    struct Free {
        Free* next;
    };
    std::mutex m_mutex;
    Free* m_free = nullptr;
    size_t m_kept = 0, m_mostKept;
};

/// For std::allocate_shared(): the objects keep the pool alive.
template <class T>
struct PoolAllocator {
    using value_type = T;
    std::shared_ptr<BlockPool> pool;

    /// Of a pool for objects of this type alone.
    explicit PoolAllocator(std::shared_ptr<BlockPool> from) : pool(std::move(from)) {}
    /// The same pool for what std::allocate_shared() puts around an object.
    template <class U>
    PoolAllocator(const PoolAllocator<U>& other) : pool(other.pool) {}
    /// Memory for one object.
    T* allocate(size_t) { return static_cast<T*>(pool->take(sizeof(T))); }
    /// Gives it back.
    void deallocate(T* block, size_t) { pool->give(block); }
};
template <class T, class U>
bool operator==(const PoolAllocator<T>& a, const PoolAllocator<U>& b) {
    return a.pool == b.pool;
}

}  // namespace rubble
