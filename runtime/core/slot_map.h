#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/core/assertion.h"
#include "runtime/core/handle.h"

namespace rubble {

/// Objects in numbered slots, named by generational handles: erasing an object makes its handle stale. Iteration is in
/// slot order, and freed slots are used again last in, first out, so the same calls give the same handles.
template <class Handle, class T>
class SlotMap {
public:
    struct Slot {
        std::optional<T> value;
        uint32_t generation = 1;      ///< of the value; of an empty slot: of its next value
        uint32_t lastGeneration = 1;  ///< the highest so far: a later value gets a higher one
        bool reserved = false;        ///< empty, and only fill() puts a value in
    };
    using HandleOf = Handle;
    static constexpr HandleType kType = Handle::make(0, 0, 0).type();  ///< of its handles

    /// `world` is stored in all handles: handles of another world find nothing here. `firstGeneration`: of new slots.
    explicit SlotMap(uint8_t world = 0, uint32_t firstGeneration = 1)
        : m_firstGeneration(firstGeneration), m_world(world) {}
    /// From slots() and freeSlots() of another map, as a saved game stores them.
    SlotMap(uint8_t world, std::vector<Slot> slots, std::vector<uint32_t> free)
        : m_slots(std::move(slots)), m_world(world) {
        for (const Slot& slot : m_slots) m_size += slot.value.has_value();
        std::erase_if(free, [&](uint32_t slot) { return slot >= m_slots.size(); });
        setFreeSlots(free);
    }

    /// Stores a value and returns its handle. Asserts that fewer than 16,777,215 slots are used.
    Handle insert(T value) {
        const Handle handle = reserve();
        RUBBLE_ASSERT(handle && "SlotMap is full: 16,777,215 slots");
        fill(handle, std::move(value));
        return handle;
    }

    /// The handle that insert() would give, kept for one call of fill(): until then it names nothing, and no other
    /// value gets its slot. Empty if all slots are used.
    Handle reserve() {
        if (m_free.empty() && m_slots.size() >= kMaxSlots) return {};
        const uint32_t slot = m_free.empty() ? uint32_t(m_slots.size()) : m_free.back();
        if (m_free.empty())
            m_slots.push_back({{}, m_firstGeneration, m_firstGeneration});
        else
            m_free.pop_back();
        m_slots[slot].reserved = true;
        return Handle::make(m_world, m_slots[slot].generation, slot);
    }
    /// Whether so many more can be reserved. If so, reserve() takes no memory for them.
    bool makeRoom(size_t count) {
        const size_t added = count - std::min(count, m_free.size()), needed = m_slots.size() + added;
        if (needed > kMaxSlots) return false;
        if (needed > m_slots.capacity()) m_slots.reserve(std::max(needed, 2 * m_slots.capacity()));
        return true;
    }
    /// Reserves what reserve() gave in another copy of this map, in the order of those calls. False if the slot has
    /// another use or generation here.
    bool claim(Handle handle) {
        if (isReserved(handle)) return true;
        const uint32_t slot = handle.slot();
        if (!handle || handle.world() != m_world || slot >= kMaxSlots || slot > m_slots.size()) return false;
        if (slot == m_slots.size() && m_firstGeneration != handle.generation()) return false;
        if (slot == m_slots.size()) {
            m_slots.push_back({{}, m_firstGeneration, m_firstGeneration});
        } else {
            if (m_slots[slot].value || m_slots[slot].reserved || !isGenerationOf(m_slots[slot], handle)) return false;
            m_free.erase(std::find(m_free.rbegin(), m_free.rend(), slot).base() - 1);
        }
        m_slots[slot].reserved = true;
        return true;
    }
    /// Whether a handle is reserved and names nothing yet.
    bool isReserved(Handle handle) const {
        if (!handle || handle.type() != kType || handle.world() != m_world || handle.slot() >= m_slots.size())
            return false;
        return m_slots[handle.slot()].reserved && isGenerationOf(m_slots[handle.slot()], handle);
    }
    /// Stores a value under a reserved handle; asserts that it is.
    T& fill(Handle handle, T value) {
        RUBBLE_ASSERT(isReserved(handle) && "filling a slot that is not reserved");
        Slot& slot = m_slots[handle.slot()];
        slot.reserved = false;
        slot.value = std::move(value);
        ++m_size;
        return *slot.value;
    }
    /// Makes a reserved handle stale for ever.
    void release(Handle handle) {
        if (!isReserved(handle)) return;
        Slot& slot = m_slots[handle.slot()];
        slot.reserved = false;
        slot.generation = ++slot.lastGeneration;
        m_free.push_back(handle.slot());
    }

    /// Destroys the object. Returns false if the handle is stale.
    bool erase(Handle handle) {
        if (!find(handle)) return false;
        Slot& slot = m_slots[handle.slot()];
        slot.value.reset();
        slot.generation = ++slot.lastGeneration;
        m_free.push_back(handle.slot());
        --m_size;
        return true;
    }

    /// Erases all objects. Handles from before, reserved ones too, are stale; slots are given out as by a new map.
    void clear() {
        m_free.clear();
        for (size_t i = m_slots.size(); i-- > 0;) {
            if (m_slots[i].value || m_slots[i].reserved) m_slots[i].generation = ++m_slots[i].lastGeneration;
            m_slots[i].value.reset();
            m_slots[i].reserved = false;
            m_free.push_back(uint32_t(i));
        }
        m_size = 0;
    }

    /// Puts a value back under the handle it had, for undo and replay. The slot must be empty; if it is reserved, that
    /// handle is stale from now on.
    T& restore(Handle handle, T value) {
        const uint32_t slot = handle.slot();
        if (m_slots.size() <= slot) {  // the new ones are used last, lowest first, like slots never used
            std::vector<uint32_t> added(slot + 1 - m_slots.size());
            for (size_t i = 0; i < added.size(); ++i) added[i] = slot - uint32_t(i);
            m_free.insert(m_free.begin(), added.begin(), added.end());
            m_slots.resize(slot + 1, {{}, m_firstGeneration, m_firstGeneration});
        }
        RUBBLE_ASSERT(!m_slots[slot].value && "restoring over a living object");
        if (!std::exchange(m_slots[slot].reserved, false))
            m_free.erase(std::find(m_free.rbegin(), m_free.rend(), slot).base() - 1);
        m_slots[slot].value = std::move(value);
        m_slots[slot].generation = handle.generation();
        m_slots[slot].lastGeneration = std::max(m_slots[slot].lastGeneration, handle.generation());
        ++m_size;
        return *m_slots[slot].value;
    }

    /// The object of a handle; nullptr if the handle is stale, empty or of another world.
    T* find(Handle handle) { return const_cast<T*>(std::as_const(*this).find(handle)); }
    /// The object of a handle; nullptr if the handle is stale, reserved, empty or of another world.
    const T* find(Handle handle) const {
        if (!handle || handle.world() != m_world || handle.slot() >= m_slots.size()) return nullptr;
        const Slot& slot = m_slots[handle.slot()];
        if (!slot.value || !isGenerationOf(slot, handle)) return nullptr;
        return &*slot.value;
    }
    /// The object of a handle that is known to be valid; asserts that.
    T& at(Handle handle) {
        T* value = find(handle);
        RUBBLE_ASSERT(value && "stale handle");
        return *value;
    }
    /// The object of a handle that is known to be valid; asserts that.
    const T& at(Handle handle) const { return const_cast<SlotMap*>(this)->at(handle); }

    /// The handle of the object in a slot; empty if the slot is.
    Handle handleAt(uint32_t slot) const {
        return slot < m_slots.size() && m_slots[slot].value ? Handle::make(m_world, m_slots[slot].generation, slot)
                                                            : Handle{};
    }

    /// Calls f(handle, value) for every object, in slot order.
    template <class F>
    void forEach(F&& f) {
        for (uint32_t i = 0; i < m_slots.size(); ++i)
            if (m_slots[i].value) f(Handle::make(m_world, m_slots[i].generation, i), *m_slots[i].value);
    }
    /// Calls f(handle, value) for every object, in slot order.
    template <class F>
    void forEach(F&& f) const {
        for (uint32_t i = 0; i < m_slots.size(); ++i)
            if (m_slots[i].value) f(Handle::make(m_world, m_slots[i].generation, i), *m_slots[i].value);
    }

    /// All slots, empty ones too, for saving.
    const std::vector<Slot>& slots() const { return m_slots; }
    /// Empty slots that are not reserved, in the order of their use: the last one is used next.
    const std::vector<uint32_t>& freeSlots() const { return m_free; }
    /// Makes these slots the next to be used, the last of them first; those that are not there are made. Other empty
    /// slots follow, lowest first.
    void setFreeSlots(const std::vector<uint32_t>& slots) {
        const size_t count = slots.empty() ? 0 : *std::max_element(slots.begin(), slots.end()) + size_t(1);
        if (count > m_slots.size()) m_slots.resize(count, {{}, m_firstGeneration, m_firstGeneration});
        std::vector<bool> isOther(m_slots.size());
        for (size_t i = 0; i < m_slots.size(); ++i) isOther[i] = !m_slots[i].value && !m_slots[i].reserved;
        std::vector<uint32_t> next;
        for (const uint32_t slot : slots)
            if (slot < isOther.size() && isOther[slot]) isOther[slot] = false, next.push_back(slot);
        m_free.clear();
        for (size_t i = m_slots.size(); i-- > 0;)
            if (isOther[i]) m_free.push_back(uint32_t(i));
        m_free.insert(m_free.end(), next.begin(), next.end());
    }

    /// The highest generation of all handles so far.
    uint32_t highestGeneration() const {
        uint32_t highest = 0;
        for (const Slot& slot : m_slots) highest = std::max(highest, slot.lastGeneration);
        return highest;
    }
    /// The generation of slots that were never used.
    uint32_t firstGeneration() const { return m_firstGeneration; }
    /// See firstGeneration().
    void setFirstGeneration(uint32_t generation) { m_firstGeneration = generation; }
    /// Objects in the map.
    size_t size() const { return m_size; }
    /// Slots ever used: the length of a side table indexed by Handle::slot().
    size_t slotCount() const { return m_slots.size(); }

private:
    static constexpr uint32_t kMaxSlots = 0xffffffu;

    static bool isGenerationOf(const Slot& slot, Handle handle) {
        return (slot.generation & 0xffffffu) == handle.generation();
    }

    std::vector<Slot> m_slots;
    std::vector<uint32_t> m_free;
    size_t m_size = 0;
    uint32_t m_firstGeneration = 1;
    uint8_t m_world = 0;
};

}  // namespace rubble
