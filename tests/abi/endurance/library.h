#pragma once
#include <rubble/rubble.h>

#include <string>

namespace rubble {

/// The library, loaded by its path until this is destroyed.
class Library {
public:
    /// Ends the program, with the reason, if it cannot be loaded.
    explicit Library(const std::string& path);
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;
    /// Its table.
    const rubble_api* operator->() const { return m_api; }

private:
    void* m_library;
    const rubble_api* m_api = nullptr;
};

/// Ends the program, with the reason, unless a call was accepted.
void require(const Library& library, rubble_result result);
/// A struct of the interface with its struct_size and zeros.
template <class T>
T sized() {
    T value = {};
    value.struct_size = sizeof(T);
    return value;
}

}  // namespace rubble
