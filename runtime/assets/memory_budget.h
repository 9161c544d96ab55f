#pragma once
#include <cstdint>

namespace rubble {

/// How many bytes of memory reading a file may take: kFree, and kPerByte for each byte of the file. What is read is
/// taken from it before it is allocated, so that a short file cannot ask for much. Writers pad a file that would need
/// more (ChunkWriter), so that all that is written can be read.
class MemoryBudget {
public:
    static constexpr uint64_t kFree = uint64_t(128) << 20;
    static constexpr uint64_t kPerByte = 64;

    /// The budget of a file of that many bytes.
    explicit MemoryBudget(uint64_t fileBytes) : m_left(kFree + kPerByte * fileBytes) {}
    /// Takes that many bytes; false, and nothing is left, if there are fewer.
    bool take(uint64_t bytes) {
        const bool isEnough = bytes <= m_left;
        m_left = isEnough ? m_left - bytes : 0;
        return isEnough;
    }

private:
    uint64_t m_left;
};

/// About what a stored brick takes: the brick with its indices, its paint apart, and its place in a node.
inline constexpr uint64_t kBrickMemory = 800;
/// What a directory of that many nodes takes. Reading copies it a few times.
constexpr uint64_t directoryMemory(uint64_t nodes) {
    return nodes * sizeof(void*) * 4;
}
/// What a list of that many elements takes, and a copy of it.
constexpr uint64_t listMemory(uint64_t elements, uint64_t bytesEach) {
    return elements * bytesEach * 2;
}
/// What a chunk of that many bytes takes, unpacked and as the texts in it.
constexpr uint64_t chunkMemory(uint64_t rawBytes) {
    return rawBytes * 2;
}

}  // namespace rubble
