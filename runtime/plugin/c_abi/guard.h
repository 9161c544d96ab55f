#pragma once
#include <exception>
#include <new>
#include <string>

#include "runtime/plugin/c_abi/checks.h"
#include "runtime/plugin/c_abi/registry.h"

// What every function of the table is wrapped in.
namespace rubble::abi {

/// Keeps the reason for get_last_error().
rubble_result storeLastError(const char* function, const ApiError& refusal);

/// Makes a result of whatever is thrown inside: nothing gets out of the plugin.
template <class F>
rubble_result guarded(const char* function, F&& body) noexcept try {
    try {
        body();
        return RUBBLE_OK;
    } catch (const ApiError& refusal) {
        return storeLastError(function, refusal);
    } catch (const std::bad_alloc&) {
        return storeLastError(function, {RUBBLE_ERROR_MEMORY, "out of memory"});
    } catch (const std::exception& error) {
        return storeLastError(function, {RUBBLE_ERROR_INTERNAL, error.what()});
    }
} catch (...) {
    return RUBBLE_ERROR_MEMORY;  // even the message found no memory
}

/// Rows for a host's array: counts all, writes those that fit.
template <class Row>
class RowWriter {
public:
    RowWriter(Row* out, uint32_t capacity, uint32_t* count)
        : m_out(out), m_capacity(capacity), m_count(requireNotNull(count, "count")) {
        if (capacity) requireNotNull(out, "out");
        m_count = 0;
    }
    template <class Make>
    void add(Make&& make) {
        if (m_count < m_capacity) m_out[m_count] = make();
        ++m_count;
    }
    void finish() const {
        if (m_capacity && m_count > m_capacity)
            throw ApiError{RUBBLE_ERROR_CAPACITY, "there are " + std::to_string(m_count) + " rows, the array holds " +
                                                      std::to_string(m_capacity)};
    }

private:
    Row* m_out;
    uint32_t m_capacity;
    uint32_t& m_count;
};

/// A command for the next step; convert(world, edit) checks it.
template <class HostEdit, class Convert>
rubble_result pushEdit(const char* function, rubble_world world, const HostEdit* edit, Convert&& convert) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        hosted->loop.edits().push(convert(hosted->loop.world(), readStruct(edit, function)));
    });
}

/// Refuses a handle that names nothing in a SlotMap of a World.
template <class Map, class Handle>
void requireAlive(const Map& map, Handle handle, const char* name) {
    if (!map.find(handle)) throw ApiError{RUBBLE_ERROR_STALE, std::string(name) + (handle ? " is stale" : " is 0")};
}

/// A command for the next step that removes what a handle names in a SlotMap of a World.
template <class EditType, HandleType kType, class Map>
rubble_result removeOne(const char* function, rubble_world world, uint64_t bits, const char* name,
                        const Map& (World::*all)() const) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        const auto handle = readHandle<kType>(bits, name);
        requireAlive((hosted->loop.world().*all)(), handle, name);
        hosted->loop.edits().push(EditType{handle});
    });
}

/// The handles in a SlotMap of a World, in the order of their slots.
template <class Map>
rubble_result listAll(const char* function, rubble_world world, uint64_t* out, uint32_t capacity, uint32_t* count,
                      const Map& (World::*all)() const) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        RowWriter<uint64_t> rows(out, capacity, count);
        (hosted->loop.world().*all)().forEach([&](auto handle, const auto&) { rows.add([&] { return handle.bits; }); });
        rows.finish();
    });
}

}  // namespace rubble::abi
