#include "render/gl/program_cache.h"

#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "runtime/core/hash.h"
#include "runtime/core/log.h"

namespace rubble {
namespace {

namespace fs = std::filesystem;

/// The head of a file; the binary follows.
struct Head {
    uint64_t magic = 0x3130474f52505252;  // "RRPROG01"
    uint64_t key = 0;
    uint64_t checksum = 0;  ///< of the binary: drivers trust what they are given
    uint32_t format = 0;
    uint32_t bytes = 0;
};

uint64_t driverHash() {
    uint64_t hash = 0;
    for (const GLenum name : {GL_VENDOR, GL_RENDERER, GL_VERSION}) {
        const auto* text = reinterpret_cast<const char*>(glGetString(name));
        if (text) hash = hashBytes(text, std::strlen(text), hash);
    }
    return hash;
}

bool hasBinaries() {
    GLint formats = 0;
    if (glGetProgramBinary && glProgramBinary && glProgramParameteri)
        glGetIntegerv(GL_NUM_PROGRAM_BINARY_FORMATS, &formats);
    return formats > 0;
}

}  // namespace

ProgramCache::ProgramCache(fs::path folder) {
    if (folder.empty() || !hasBinaries()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) {
        logWarning("program cache " + folder.string() + ": " + error.message() + "; it is not used");
        return;
    }
    m_folder = std::move(folder);
    m_driver = driverHash();
}

uint64_t ProgramCache::keyOf(std::string_view source, uint64_t key) const {
    return hashBytes(source.data(), source.size(), hashValue(m_driver, key));
}

fs::path ProgramCache::fileOf(uint64_t key) const {
    char name[32];
    std::snprintf(name, sizeof name, "%016llx.program", static_cast<unsigned long long>(key));
    return m_folder / name;
}

bool ProgramCache::load(uint64_t key, GLuint program) const {
    std::ifstream in(fileOf(key), std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    Head head, expected;
    if (bytes.size() < sizeof head) return false;
    std::memcpy(&head, bytes.data(), sizeof head);
    const char* binary = bytes.data() + sizeof head;
    if (head.magic != expected.magic || head.key != key || head.bytes != bytes.size() - sizeof head ||
        head.checksum != hashBytes(binary, head.bytes))
        return false;
    glProgramBinary(program, head.format, binary, GLsizei(head.bytes));
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) glGetError();  // a format that this driver does not know
    return done;
}

void ProgramCache::store(uint64_t key, GLuint program) {
    GLint length = 0;
    glGetProgramiv(program, GL_PROGRAM_BINARY_LENGTH, &length);
    if (length <= 0) return;
    std::vector<char> binary(static_cast<size_t>(length));
    GLenum format = 0;
    glGetProgramBinary(program, length, &length, &format, binary.data());
    Head head;
    head.key = key;
    head.bytes = uint32_t(length);
    head.checksum = hashBytes(binary.data(), size_t(length));
    head.format = format;
    const fs::path file = fileOf(key), part = fs::path(file).concat(".part");
    std::ofstream out(part, std::ios::binary);
    out.write(reinterpret_cast<const char*>(&head), sizeof head);
    out.write(binary.data(), length);
    out.close();
    std::error_code error;
    if (out) fs::rename(part, file, error);
    if (out && !error) return;
    if (!std::exchange(m_failed, true)) logWarning("program cache " + file.string() + ": expected a file to write");
    fs::remove(part, error);
}

}  // namespace rubble
