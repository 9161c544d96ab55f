#pragma once
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace rubble {

/// Objects in numbered slots, named by handles that go stale when their object is erased.
/// Iteration is in slot order and a freed slot is reused last-in first-out, so that the same calls give the same
/// handles.
template <class Handle, class T>
class SlotMap {
public:
    struct Slot {
        std::optional<T> value;
        uint32_t generation = 1;  ///< of the value; of an empty slot: of its next one
        uint32_t lastGeneration =
            1;  ///< no later value gets a generation below: an old handle never names a new object
    };

    explicit SlotMap(uint8_t world = 0) : m_world(world) {}
    /// From what slots() and freeSlots() of another gave.
    SlotMap(uint8_t world, std::vector<Slot> slots, const std::vector<uint32_t>& free)
        : m_slots(std::move(slots)), m_world(world) {
        for (const Slot& slot : m_slots) m_size += slot.value.has_value();
        setFreeSlots(free);
    }

    Handle insert(T value) {
        uint32_t slot;
        if (m_free.empty()) {
            slot = uint32_t(m_slots.size());
            assert(slot < 0xffffffu && "SlotMap is full: 16,777,215 slots");
            m_slots.emplace_back();
        } else {
            slot = m_free.back();
            m_free.pop_back();
        }
        m_slots[slot].value = std::move(value);
        ++m_size;
        return Handle::make(m_world, m_slots[slot].generation, slot);
    }

    bool erase(Handle handle) {
        if (!find(handle)) return false;
        Slot& slot = m_slots[handle.slot()];
        slot.value.reset();
        slot.generation = ++slot.lastGeneration;
        m_free.push_back(handle.slot());
        --m_size;
        return true;
    }

    /// Erases everything, and gives out slots like a new map again; handles from before are stale.
    void clear() {
        m_free.clear();
        for (size_t i = m_slots.size(); i-- > 0;) {
            if (m_slots[i].value) m_slots[i].generation = ++m_slots[i].lastGeneration;
            m_slots[i].value.reset();
            m_free.push_back(uint32_t(i));
        }
        m_size = 0;
    }

    /// Puts a value back under a handle that was erased: undo, and replay of what others created. The slot must be
    /// empty.
    T& restore(Handle handle, T value) {
        const uint32_t slot = handle.slot();
        while (m_slots.size() <= slot) {
            m_free.insert(m_free.begin(), uint32_t(m_slots.size()));  // used last, as if it had never been
            m_slots.emplace_back();
        }
        assert(!m_slots[slot].value && "restoring over a living object");
        m_free.erase(std::find(m_free.rbegin(), m_free.rend(), slot).base() - 1);
        m_slots[slot].value = std::move(value);
        m_slots[slot].generation = handle.generation();
        m_slots[slot].lastGeneration = std::max(m_slots[slot].lastGeneration, handle.generation());
        ++m_size;
        return *m_slots[slot].value;
    }

    /// nullptr if the handle is stale, empty or of another world.
    T* find(Handle handle) { return const_cast<T*>(std::as_const(*this).find(handle)); }
    const T* find(Handle handle) const {
        if (!handle || handle.world() != m_world || handle.slot() >= m_slots.size()) return nullptr;
        const Slot& slot = m_slots[handle.slot()];
        if (!slot.value || (slot.generation & 0xffffffu) != handle.generation()) return nullptr;
        return &*slot.value;
    }
    T& at(Handle handle) {
        T* value = find(handle);
        assert(value && "stale handle");
        return *value;
    }
    const T& at(Handle handle) const { return const_cast<SlotMap*>(this)->at(handle); }

    /// The handle of what is in a slot now; empty if nothing is.
    Handle handleAt(uint32_t slot) const {
        return slot < m_slots.size() && m_slots[slot].value ? Handle::make(m_world, m_slots[slot].generation, slot)
                                                            : Handle{};
    }

    /// f(handle, value) for every object, in slot order.
    template <class F>
    void forEach(F&& f) {
        for (uint32_t i = 0; i < m_slots.size(); ++i)
            if (m_slots[i].value) f(Handle::make(m_world, m_slots[i].generation, i), *m_slots[i].value);
    }
    template <class F>
    void forEach(F&& f) const {
        for (uint32_t i = 0; i < m_slots.size(); ++i)
            if (m_slots[i].value) f(Handle::make(m_world, m_slots[i].generation, i), *m_slots[i].value);
    }

    const std::vector<Slot>& slots() const { return m_slots; }
    /// The order in which freed slots are used again, the last first.
    const std::vector<uint32_t>& freeSlots() const { return m_free; }
    /// Makes these slots the next to be used, the last of them first; the other empty ones follow from the lowest on.
    void setFreeSlots(const std::vector<uint32_t>& slots) {
        std::vector<bool> isOther(m_slots.size());
        for (size_t i = 0; i < m_slots.size(); ++i) isOther[i] = !m_slots[i].value;
        std::vector<uint32_t> next;
        for (const uint32_t slot : slots)
            if (slot < isOther.size() && isOther[slot]) isOther[slot] = false, next.push_back(slot);
        m_free.clear();
        for (size_t i = m_slots.size(); i-- > 0;)
            if (isOther[i]) m_free.push_back(uint32_t(i));
        m_free.insert(m_free.end(), next.begin(), next.end());
    }

    size_t size() const { return m_size; }
    /// Slots ever used: the length of a side table indexed by Handle::slot().
    size_t slotCount() const { return m_slots.size(); }

private:
    std::vector<Slot> m_slots;
    std::vector<uint32_t> m_free;
    size_t m_size = 0;
    uint8_t m_world = 0;
};

}  // namespace rubble
