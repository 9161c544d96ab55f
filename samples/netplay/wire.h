#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace netplay {

/// Writes numbers of any number of bits one behind the other, the lowest bit first, into bytes.
class BitWriter {
public:
    /// Appends the lowest `count` bits of a value: 0 to 64.
    void put(uint64_t value, int count);
    /// Appends a number in groups of seven bits, each behind a bit that says whether another group follows.
    void putVarint(uint64_t value);
    /// Fills the last byte with zeros and appends whole bytes.
    void putBytes(std::span<const uint8_t> bytes);
    /// Bytes so far; the last may be filled in part.
    size_t size() const { return m_bytes.size(); }
    /// All bytes; the writer is empty afterwards.
    std::vector<uint8_t> take();

private:
    std::vector<uint8_t> m_bytes;
    int m_free = 0;  ///< bits of the last byte
};

/// Reads what a BitWriter wrote, from bytes that may be anything: once too much is asked for, it has failed, and all
/// that it reads is 0. The bytes must outlive it.
class BitReader {
public:
    /// Begins at the first bit.
    explicit BitReader(std::span<const uint8_t> bytes) : m_bytes(bytes) {}
    /// The next `count` bits: 0 to 64.
    uint64_t get(int count);
    /// A number of putVarint(); of more than 64 bits it fails.
    uint64_t getVarint();
    /// Skips the rest of the byte; then so many bytes. Fails if there are fewer.
    std::span<const uint8_t> getBytes(uint64_t count);
    /// Skips the rest of the byte; then all bytes that are left.
    std::span<const uint8_t> getRest();
    /// Says that what was read makes no sense.
    void fail() { m_hasFailed = true; }
    /// Whether something could not be read.
    bool failed() const { return m_hasFailed; }
    /// Whether all has been read, but for bits that fill the last byte.
    bool isAtEnd() const { return !m_hasFailed && (m_at + 7) / 8 == m_bytes.size(); }

private:
    std::span<const uint8_t> m_bytes;
    size_t m_at = 0;  ///< in bits
    bool m_hasFailed = false;
};

/// Packs bytes with LZ4, behind their number.
std::vector<uint8_t> packed(std::span<const uint8_t> bytes);
/// Unpacks them. Fails in `in`, which it reads to its end, if they are damaged or more than `limit`.
std::vector<uint8_t> unpacked(BitReader& in, uint64_t limit);

}  // namespace netplay
