#pragma once
#include <cstdint>
#include <filesystem>
#include <string_view>

#include "render/gl/gl.h"

namespace rubble {

/// Keeps what the driver made of programs in a folder, one file a program, so that later runs need not compile. A file
/// is used only by the driver and for the sources that it was made from. [render-thread]
class ProgramCache {
public:
    /// Makes the folder if it is missing. Without a folder, or where the GL gives no binaries, it keeps nothing.
    explicit ProgramCache(std::filesystem::path folder = {});

    /// Whether it keeps anything.
    bool isOn() const { return !m_folder.empty(); }
    /// The key of a program, from its sources one after the other. Start with 0.
    uint64_t keyOf(std::string_view source, uint64_t key) const;
    /// Fills a program from its file. False if there is none, it is damaged, or the driver does not take it: then the
    /// program is as before.
    bool load(uint64_t key, GLuint program) const;
    /// Writes a linked program's file. On an error there is none; the first one is logged.
    void store(uint64_t key, GLuint program);

private:
    std::filesystem::path fileOf(uint64_t key) const;
    std::filesystem::path m_folder;
    uint64_t m_driver = 0;  ///< a hash of its name and version
    bool m_failed = false;  ///< to write
};

}  // namespace rubble
