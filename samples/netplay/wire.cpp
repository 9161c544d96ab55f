#include "samples/netplay/wire.h"

#include <lz4.h>

#include <algorithm>
#include <utility>

namespace netplay {

void BitWriter::put(uint64_t value, int count) {
    while (count > 0) {
        if (m_free == 0) m_bytes.push_back(0), m_free = 8;
        const int taken = std::min(count, m_free);
        m_bytes.back() |= uint8_t((value & ((uint64_t(1) << taken) - 1)) << (8 - m_free));
        value >>= taken;
        m_free -= taken, count -= taken;
    }
}

void BitWriter::putVarint(uint64_t value) {
    do {
        put(value & 0x7f, 7);
        value >>= 7;
        put(value != 0, 1);
    } while (value != 0);
}

void BitWriter::putBytes(std::span<const uint8_t> bytes) {
    m_free = 0;
    m_bytes.insert(m_bytes.end(), bytes.begin(), bytes.end());
}

std::vector<uint8_t> BitWriter::take() {
    m_free = 0;
    return std::exchange(m_bytes, {});
}

uint64_t BitReader::get(int count) {
    if (m_hasFailed || m_bytes.size() * 8 - m_at < size_t(count)) {
        m_hasFailed = true;
        return 0;
    }
    uint64_t value = 0;
    for (int done = 0; done < count;) {
        const int inByte = int(m_at % 8), taken = std::min(count - done, 8 - inByte);
        const uint64_t bits = (m_bytes[m_at / 8] >> inByte) & ((1u << taken) - 1);
        value |= bits << done;
        done += taken, m_at += size_t(taken);
    }
    return value;
}

uint64_t BitReader::getVarint() {
    uint64_t value = 0;
    for (int shift = 0; shift < 64; shift += 7) {
        const uint64_t bits = get(7);
        if (shift == 63 && bits > 1) break;
        value |= bits << shift;
        if (!get(1)) return value;
    }
    m_hasFailed = true;
    return 0;
}

std::span<const uint8_t> BitReader::getBytes(uint64_t count) {
    m_at = (m_at + 7) / 8 * 8;
    if (m_hasFailed || m_bytes.size() - m_at / 8 < count) {
        m_hasFailed = true;
        return {};
    }
    const auto out = m_bytes.subspan(m_at / 8, size_t(count));
    m_at += 8 * size_t(count);
    return out;
}

std::span<const uint8_t> BitReader::getRest() {
    m_at = (m_at + 7) / 8 * 8;
    return getBytes(m_bytes.size() - m_at / 8);
}

std::vector<uint8_t> packed(std::span<const uint8_t> bytes) {
    BitWriter out;
    out.putVarint(bytes.size());
    std::vector<uint8_t> block(size_t(LZ4_compressBound(int(bytes.size()))));
    const int size = LZ4_compress_default(reinterpret_cast<const char*>(bytes.data()),
                                          reinterpret_cast<char*>(block.data()), int(bytes.size()), int(block.size()));
    out.putBytes(std::span(block).first(size_t(size)));
    return out.take();
}

std::vector<uint8_t> unpacked(BitReader& in, uint64_t limit) {
    const uint64_t size = in.getVarint();
    const std::span<const uint8_t> block = in.getRest();
    if (in.failed() || size > limit || size > block.size() * 255 + 64) {  // LZ4 packs no denser
        in.fail();
        return {};
    }
    std::vector<uint8_t> out(static_cast<size_t>(size));
    const int got = LZ4_decompress_safe(reinterpret_cast<const char*>(block.data()),
                                        reinterpret_cast<char*>(out.data()), int(block.size()), int(out.size()));
    if (got != int(size)) in.fail();
    return in.failed() ? std::vector<uint8_t>{} : out;
}

}  // namespace netplay
