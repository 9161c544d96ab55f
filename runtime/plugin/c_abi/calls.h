#pragma once
#include <algorithm>
#include <cstring>
#include <exception>
#include <new>
#include <string>

#include "runtime/plugin/c_abi/checks.h"
#include "runtime/plugin/c_abi/registry.h"

// What the functions of the table share. A function is a call of guarded(): inside it a wrong argument throws ApiError,
// and no exception leaves the plugin.
namespace rubble::abi {

/// Keeps "function: text" for get_last_error() of this thread and returns the error's code.
rubble_result storeLastError(const char* function, const ApiError& error);

/// Runs the body of a table function and turns what it throws into a result.
template <class F>
rubble_result guarded(const char* function, F&& body) noexcept try {
    try {
        body();
        return RUBBLE_OK;
    } catch (const ApiError& error) {
        return storeLastError(function, error);
    } catch (const std::bad_alloc&) {
        return storeLastError(function, {RUBBLE_ERROR_MEMORY, "out of memory"});
    } catch (const std::exception& error) {
        return storeLastError(function, {RUBBLE_ERROR_INTERNAL, error.what()});
    }
} catch (...) {
    return RUBBLE_ERROR_MEMORY;  // there was no memory for the message
}

/// Fills a host's array: counts all rows and writes those that fit.
template <class Row>
class RowWriter {
public:
    /// `out` may be null if the capacity is 0. rowSize: see readRowSize(). Throws ApiError for other null pointers.
    RowWriter(void* out, uint32_t capacity, uint32_t* count, uint32_t rowSize = kFirstSize<Row>)
        : m_out(static_cast<char*>(out)),
          m_capacity(capacity),
          m_rowSize(rowSize),
          m_count(requireNotNull(count, "count")) {
        if (capacity) requireNotNull(m_out, "out");
        m_count = 0;
    }
    /// Calls make() for the row only if there is room for it.
    template <class Make>
    void add(Make&& make) {
        if (m_count < m_capacity) writeRow<Row>(m_out + size_t(m_count) * m_rowSize, make(), m_rowSize);
        ++m_count;
    }
    /// Throws RUBBLE_ERROR_CAPACITY if some rows did not fit.
    void finish() const {
        if (m_capacity && m_count > m_capacity)
            throw ApiError{RUBBLE_ERROR_CAPACITY, "there are " + std::to_string(m_count) + " rows, the array holds " +
                                                      std::to_string(m_capacity)};
    }

private:
    char* m_out;
    uint32_t m_capacity, m_rowSize;
    uint32_t& m_count;
};

/// Queues an edit for the next step. convert(world, struct) makes it from the host's struct and throws ApiError.
template <class HostEdit, class Convert>
rubble_result pushEdit(const char* function, rubble_world world, const HostEdit* edit, Convert&& convert) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        hosted->loop.edits().push(convert(hosted->loop.world(), readStruct(edit, function)));
    });
}

/// Queues an edit that removes the object of a handle. `all`: the World's map of such objects.
template <class EditType, HandleType kType, class Map>
rubble_result removeOne(const char* function, rubble_world world, uint64_t bits, const char* name,
                        const Map& (World::*all)() const) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        hosted->loop.edits().push(EditType{readLiveHandle<kType>((hosted->loop.world().*all)(), bits, name)});
    });
}

/// Lists the handles of a map of the World, in the order of their slots.
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
