#pragma once
#include <exception>
#include <new>

#include "runtime/core/assertion.h"
#include "runtime/plugin/c_abi/checks.h"
#include "runtime/plugin/c_abi/registry.h"

// What the functions of the table share: each is a call of guarded(), or of one of those below that calls it. No
// exception leaves the plugin.
namespace rubble::abi {

/// Runs the body of a table function and returns what came of it to the host.
template <class F>
rubble_result guarded(const char* function, F&& body) noexcept {
    try {
        Call call(function);
        try {
            body();
        } catch (const std::bad_alloc&) {
            refuse(RUBBLE_ERROR_MEMORY, "out of memory");
        } catch (const std::exception& error) {
            refuse(RUBBLE_ERROR_INTERNAL, "{}", error.what());
        }
        return call.finish();
    } catch (...) {
        return RUBBLE_ERROR_MEMORY;  // there was no memory for the message
    }
}

/// Uses a world or a renderer in a call. One in which an assert has failed is in no defined state: it answers no later
/// call but the one that destroys it.
template <class Hosted, class F>
void useIntact(Hosted& hosted, const char* name, F&& body) {
    if (!hosted.damage.empty())
        return refuse(RUBBLE_ERROR_BROKEN, "the {} is broken, destroy it: {}", name, hosted.damage);
    try {
        body(hosted);
    } catch (const AssertionFailed& failure) {
        hosted.damage = failure.what();
        refuse(RUBBLE_ERROR_BROKEN, "{}", hosted.damage);
    }
}

/// A [main-thread] function of a world: body(HostedWorld&) runs if `world` is an intact one that is in no other call.
template <class F>
rubble_result inWorld(const char* function, rubble_world world, F&& body) {
    return guarded(function, [&] {
        const auto hosted = Registry::instance().world(world);
        if (!hosted) return;
        const ServiceScope services(hosted->options.services);
        useIntact(*hosted, "world", body);
    });
}

/// A [render-thread] function of a renderer: the same.
template <class F>
rubble_result inRenderer(const char* function, rubble_renderer renderer, F&& body) {
    return guarded(function, [&] {
        if (const auto hosted = Registry::instance().renderer(renderer)) useIntact(*hosted, "renderer", body);
    });
}

/// Changes a world by work(): what that throws leaves the world broken, because it was half done.
template <class F>
void change(HostedWorld& hosted, F&& work) {
    try {
        work();
    } catch (const std::exception& error) {
        hosted.damage = error.what();
        throw;
    }
}

/// Fills a host's array: counts all rows and writes those that fit.
template <class Row>
class RowWriter {
public:
    /// `out` may be null if the capacity is 0. rowSize: see readRowSize(). Other null pointers are refused.
    RowWriter(void* out, uint32_t capacity, uint32_t* count, uint32_t rowSize = kFirstSize<Row>)
        : m_out(static_cast<char*>(out)), m_capacity(capacity), m_rowSize(rowSize), m_count(count) {
        if (isGiven(count, "count")) *count = 0;
        if (capacity) isGiven(out, "out");
    }
    /// Calls make() for the row only if there is room for it.
    template <class Make>
    void add(Make&& make) {
        if (m_rows < m_capacity) writeRow<Row>(m_out + size_t(m_rows) * m_rowSize, make(), m_rowSize);
        ++m_rows;
    }
    /// Tells the host how many rows there are. Refuses the call if some did not fit.
    void finish() const {
        if (isRefused()) return;
        *m_count = m_rows;
        if (m_capacity && m_rows > m_capacity)
            refuse(RUBBLE_ERROR_CAPACITY, "there are {} rows, the array holds {}", m_rows, m_capacity);
    }

private:
    char* m_out;
    uint32_t m_capacity, m_rowSize, m_rows = 0;
    uint32_t* m_count;
};

/// A function that lists rows of a world: addRows(HostedWorld&, RowWriter<Row>&) adds them all.
template <class Row, class F>
rubble_result listRows(const char* function, rubble_world world, void* out, uint32_t capacity, uint32_t* count,
                       F&& addRows) {
    return inWorld(function, world, [&](const HostedWorld& hosted) {
        RowWriter<Row> rows(out, capacity, count);
        if (isRefused()) return;
        addRows(hosted, rows);
        rows.finish();
    });
}

/// Lists the handles of a map of the World, in the order of their slots.
template <class Map>
rubble_result listAll(const char* function, rubble_world world, uint64_t* out, uint32_t capacity, uint32_t* count,
                      const Map& (World::*all)() const) {
    return listRows<uint64_t>(function, world, out, capacity, count, [&](const HostedWorld& hosted, auto& rows) {
        (hosted.loop.world().*all)().forEach([&](auto handle, const auto&) { rows.add([&] { return handle.bits; }); });
    });
}

/// Queues an edit for the next step, unless reading the host's arguments has refused the call.
template <class EditType>
void push(HostedWorld& hosted, EditType&& edit) {
    if (!isRefused()) hosted.loop.edits().push(std::forward<EditType>(edit));
}

/// A function that queues an edit: convert(world, struct) makes it from the host's struct. `name`: of the argument.
template <class HostEdit, class Convert>
rubble_result pushEdit(const char* function, rubble_world world, const HostEdit* edit, const char* name,
                       Convert&& convert) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        const HostEdit given = readStruct(edit, name);
        if (!isRefused()) push(hosted, convert(hosted.loop.world(), given));
    });
}

/// Refuses what only a world's own physics does, where the host's moves the bodies.
inline void requirePhysics(const HostedWorld& hosted) {
    if (!hosted.loop.physics())
        refuse(RUBBLE_ERROR_UNSUPPORTED,
               "the world has RUBBLE_WORLD_HOST_PHYSICS: expected one with physics of its own");
}

/// A function that queues an edit which only a world's own physics carries out.
template <class HostEdit, class Convert>
rubble_result pushMotionEdit(const char* function, rubble_world world, const HostEdit* edit, const char* name,
                             Convert&& convert) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        requirePhysics(hosted);
        const HostEdit given = readStruct(edit, name);
        if (!isRefused()) push(hosted, convert(hosted.loop.world(), given));
    });
}

/// Queues an edit that makes something, unless reading the host's arguments has refused the call, and gives the host
/// the handle that is reserved for it. `map`: of such objects.
template <class EditType, class Map>
void pushMaker(HostedWorld& hosted, EditType&& edit, Map WorldObjects::*map, uint64_t* out) {
    if (isRefused()) return;
    Edit queued(std::forward<EditType>(edit));
    hosted.loop.edits().makeRoom(1);  // no handle is reserved without its edit
    queued.made = {reserveHandle(hosted.loop.world(), map).bits};
    if (!queued.made) return refuse(RUBBLE_ERROR_CAPACITY, "the world is full: 16,777,215 of these were made");
    *out = queued.made.bits;
    hosted.loop.edits().push(std::move(queued));
}

/// A function that queues an edit which makes something: convert(world, struct) makes the edit from the host's struct.
template <class HostEdit, class Map, class Convert>
rubble_result pushMaker(const char* function, rubble_world world, const HostEdit* edit, uint64_t* out,
                        Map WorldObjects::*map, Convert&& convert) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        if (!isGiven(out, "out")) return;
        *out = 0;
        const HostEdit given = readStruct(edit, "settings");
        if (!isRefused()) pushMaker(hosted, convert(hosted.loop.world(), given), map, out);
    });
}

/// A function that queues an edit which removes the object of a handle. `all`: the World's map of such objects.
template <class EditType, HandleType kType, class Map>
rubble_result removeOne(const char* function, rubble_world world, uint64_t bits, const char* name,
                        const Map& (World::*all)() const) {
    return inWorld(function, world, [&](HostedWorld& hosted) {
        push(hosted, EditType{readLiveHandle<kType>((hosted.loop.world().*all)(), bits, name)});
    });
}

}  // namespace rubble::abi
