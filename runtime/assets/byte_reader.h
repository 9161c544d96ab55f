#pragma once
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <string>
#include <type_traits>

#include "runtime/assets/memory_budget.h"

namespace rubble {

/// Reads little-endian values from a file's bytes and never past their end. The first failure is kept, with its offset;
/// after it everything reads as zero, so a parser checks failed() in its loops and once at its end.
/// Offsets count from the start of the file, also in a reader of a part of it.
class ByteReader {
public:
    /// `context` names what the bytes are, in messages. fileOffset: where they begin in the file. The bytes must
    /// outlive the reader.
    ByteReader(std::span<const uint8_t> bytes, std::string context, size_t fileOffset = 0)
        : m_bytes(bytes),
          m_context(std::move(context)),
          m_fileOffset(fileOffset),
          m_budget(std::make_shared<MemoryBudget>(bytes.size())) {}
    /// The same for bytes that were unpacked from those of `packed`: with its budget of memory.
    ByteReader(std::span<const uint8_t> bytes, std::string context, const ByteReader& packed)
        : m_bytes(bytes), m_context(std::move(context)), m_fileOffset(0), m_budget(packed.m_budget) {}

    /// The next value, or zero.
    template <class T>
    T read() {
        static_assert(std::is_trivially_copyable_v<T>);
        T value{};
        if (need(sizeof(T), "a value"))
            std::memcpy(&value, m_bytes.data() + m_position, sizeof(T)), m_position += sizeof(T);
        return value;
    }
    /// A count of 32 bits. Fails if the remaining bytes cannot hold that many elements of `bytesEach` bytes at least,
    /// so a damaged count cannot make the caller allocate more than a small multiple of the file.
    uint32_t readCount(size_t bytesEach, const char* what) {
        const size_t start = m_position;
        const uint32_t count = read<uint32_t>();
        if (failed() || count <= remaining() / bytesEach) return failed() ? 0 : count;
        m_position = start;
        fail(fmt::format("{} {} ({} bytes each)", count, what, bytesEach),
             fmt::format("{} bytes", m_bytes.size() - start - 4));
        return 0;
    }
    /// A count of 32 bits and as many bytes of text.
    std::string readString() {
        const uint32_t length = readCount(1, "characters");
        std::string text(reinterpret_cast<const char*>(m_bytes.data()) + m_position, length);
        m_position += length;
        return text;
    }
    /// The next `count` bytes, in place; empty if there are fewer.
    std::span<const uint8_t> readBytes(size_t count) {
        if (!need(count, "a block")) return {};
        m_position += count;
        return m_bytes.subspan(m_position - count, count);
    }
    /// The next `count` bytes as a reader of their own.
    ByteReader part(size_t count, std::string context) {
        const size_t start = offset();
        ByteReader out(readBytes(count), std::move(context), *this);
        out.m_fileOffset = start;
        return out;
    }
    /// Takes memory that what is read will need from the budget of the whole file. False, and a failure, if too little
    /// is left.
    bool takeMemory(uint64_t bytes) {
        if (failed()) return false;
        if (m_budget->take(bytes)) return true;
        fail(fmt::format("what takes at most {} MiB and {} times the file's size of memory", MemoryBudget::kFree >> 20,
                         MemoryBudget::kPerByte),
             "more");
        return false;
    }

    /// Bytes to the end; 0 after a failure.
    size_t remaining() const { return failed() ? 0 : m_bytes.size() - m_position; }
    /// Where the next byte lies in the file.
    size_t offset() const { return m_fileOffset + m_position; }
    /// Whether anything has failed so far.
    bool failed() const { return !m_error.empty(); }
    /// The first failure as "byte N, context: expected ..., found ..."; empty if there is none.
    const std::string& error() const { return m_error; }
    /// Records a failure, unless one is recorded. `offset`: where it is in the file; SIZE_MAX: at offset().
    void fail(const std::string& expected, const std::string& found, size_t offset = SIZE_MAX) {
        if (failed()) return;
        m_error = fmt::format("byte {}, {}: expected {}, found {}", offset == SIZE_MAX ? this->offset() : offset,
                              m_context, expected, found);
    }
    /// Fails if bytes are left. `what`: of which the end is expected.
    void expectEnd(const char* what) {
        if (remaining() > 0) fail(fmt::format("the end of the {}", what), fmt::format("{} more bytes", remaining()));
    }
    /// Takes over the failure of a reader of a part, if it has one.
    void takeErrorOf(const ByteReader& part) {
        if (!failed()) m_error = part.m_error;
    }

private:
    bool need(size_t count, const char* what) {
        if (failed()) return false;
        if (count <= m_bytes.size() - m_position) return true;
        fail(fmt::format("{} of {} bytes", what, count),
             fmt::format("{} bytes before the end", m_bytes.size() - m_position));
        return false;
    }
    std::span<const uint8_t> m_bytes;
    std::string m_context;
    std::string m_error;
    size_t m_fileOffset;
    std::shared_ptr<MemoryBudget> m_budget;
    size_t m_position = 0;
};

}  // namespace rubble
