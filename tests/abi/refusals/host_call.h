#pragma once
#include <memory>
#include <string>
#include <vector>

#include "tests/abi/refusals/api_description.h"
#include "tests/abi/refusals/full_world.h"

namespace rubble {

/// A call of a function of the table with memory for its arguments. As it is made, handles name living objects,
/// structs have their size, arrays have room, and everything else is 0.
class HostCall {
public:
    /// Handles are those of `world`, which must outlive it.
    HostCall(const FunctionDescription& function, const FullWorld& world);
    HostCall(const HostCall&) = delete;
    HostCall& operator=(const HostCall&) = delete;

    /// Calls it.
    rubble_result call() const;
    /// The world that it is for.
    const FullWorld& world() const { return m_world; }

    /// An argument that is a number or a handle.
    template <class T>
    void set(const char* name, T value) {
        std::memcpy(&m_slots[indexOf(name)], &value, sizeof value);
    }
    /// An argument that is a pointer to host memory which outlives the call.
    void point(const char* name, const void* to) { set(name, to); }
    /// The memory of an argument that is a pointer: of its own, or what point() has given.
    template <class T>
    T& at(const char* name) {
        return *reinterpret_cast<T*>(m_slots[indexOf(name)]);
    }
    /// The bytes of an argument that is a number, or null for those of what it points at, and of its pointer.
    unsigned char* bytesOf(size_t argument) { return reinterpret_cast<unsigned char*>(&m_slots[argument]); }
    /// What a pointer argument points at.
    unsigned char* memoryOf(size_t argument) { return reinterpret_cast<unsigned char*>(m_slots[argument]); }

private:
    size_t indexOf(const char* name) const;
    void fillIn(const StructDescription& type, unsigned char* bytes) const;

    const FunctionDescription& m_function;
    const FullWorld& m_world;
    Slots m_slots{};
    std::vector<std::unique_ptr<unsigned char[]>> m_memory;
};

/// The struct that an argument's type points at; null: it points at something else, or is no pointer.
const StructDescription* structOf(const std::string& type);
/// Whether a type is that of a handle.
bool isHandle(const std::string& type);
/// Whether a type is that of a pointer.
bool isPointer(const ArgumentDescription& argument);

}  // namespace rubble
