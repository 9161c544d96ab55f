#include "tests/abi/refusals/host_call.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "tests/abi/abi_fixture.h"

namespace rubble {
namespace {

constexpr size_t kMemory = 64 * 1024;  ///< bytes of what a pointer points at
constexpr uint64_t kRows = 16;         ///< of an array: the rows of all structs fit into the memory

std::string pointee(std::string type) {
    if (type.starts_with("const ")) type.erase(0, 6);
    if (type.ends_with("*")) type.pop_back();
    return type;
}

}  // namespace

const StructDescription* structOf(const std::string& type) {
    if (!type.ends_with("*")) return nullptr;
    const std::string name = pointee(type);
    const auto& all = describedStructs();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.name == name; });
    return found == all.end() ? nullptr : &*found;
}

bool isHandle(const std::string& type) {
    return type.starts_with("rubble_") && !type.ends_with("*");
}

bool isPointer(const ArgumentDescription& argument) {
    return argument.type.ends_with("*") || argument.rows > 0;
}

HostCall::HostCall(const FunctionDescription& function, const FullWorld& world) : m_function(function), m_world(world) {
    for (size_t i = 0; i < function.arguments.size(); ++i) {
        const ArgumentDescription& argument = function.arguments[i];
        if (isPointer(argument)) {
            m_memory.push_back(std::make_unique<unsigned char[]>(kMemory));
            unsigned char* bytes = m_memory.back().get();
            std::memcpy(&m_slots[i], &bytes, sizeof bytes);
            if (const StructDescription* type = structOf(argument.type)) fillIn(*type, bytes);
        } else if (isHandle(argument.type)) {
            const auto found = world.live().find(argument.type);
            m_slots[i] = found == world.live().end() ? 0 : found->second;
        } else if (argument.name == "capacity") {
            m_slots[i] = kRows;
        } else if (argument.name == "count") {
            m_slots[i] = 1;
        } else if (argument.name == "object" || argument.name == "handle" || argument.name == "owner") {
            m_slots[i] = world.live().at("rubble_body");
        }
    }
}

void HostCall::fillIn(const StructDescription& type, unsigned char* bytes) const {
    for (const FieldDescription& field : type.fields) {
        unsigned char* at = bytes + field.offset;
        if (field.name == "struct_size") {
            const auto size = uint32_t(type.size);
            std::memcpy(at, &size, sizeof size);
        } else if (const auto found = m_world.live().find(field.type); found != m_world.live().end()) {
            for (int row = 0; row < std::max(field.rows, 1); ++row)
                std::memcpy(at + 8 * row, &found->second, sizeof found->second);
        }
    }
}

rubble_result HostCall::call() const {
    return m_function.call(*api(), m_slots);
}

size_t HostCall::indexOf(const char* name) const {
    for (size_t i = 0; i < m_function.arguments.size(); ++i)
        if (m_function.arguments[i].name == name) return i;
    std::abort();
}

}  // namespace rubble
