#pragma once
#include <algorithm>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "render/gl/texture.h"
#include "runtime/core/log.h"

namespace rubble {

/// An array in main memory with a copy that shaders read. Writing marks a page; upload() sends only marked pages.
template <class T>
class StagedBuffer {
public:
    /// name: for messages; must outlive it.
    StagedBuffer(GLenum texelFormat, const char* name) : m_texture(texelFormat), m_name(name) {}

    /// Number of elements.
    size_t size() const { return m_data.size(); }
    /// New elements are sent only when they are changed, removed ones never. It has room for a sixteenth more, as the
    /// GL's copy.
    void resize(size_t count) {
        if (count > m_data.capacity()) m_data.reserve(count + count / 16);
        m_data.resize(count);
        m_pageDirty.resize((count + kPage - 1) / kPage, 0);
        std::erase_if(m_dirty, [&](size_t page) { return page >= m_pageDirty.size(); });
    }
    const T& operator[](size_t i) const { return m_data[i]; }
    /// Element i for writing; the next upload() sends it.
    T& change(size_t i) {
        const size_t page = i / kPage;
        if (!m_pageDirty[page]) m_dirty.push_back(page);
        m_pageDirty[page] = 1;
        return m_data[i];
    }

    /// Makes the GL's copy as long as this array. Where the GL has no room, the copy stays as it is, with an error in
    /// the log the first time.
    void reserve() {
        if (m_texture.reserve(m_data.size() * sizeof(T)) || std::exchange(m_fullLogged, true)) return;
        logError(std::string(m_name) + ": full at " + std::to_string(held()) + " elements of " +
                 std::to_string(m_data.size()) + ", as the GL has no room for more; what is beyond is not drawn");
    }
    /// How many elements the GL's copy has room for, at most size().
    size_t held() const { return std::min(m_data.size(), size_t(m_texture.bytes() / sizeof(T))); }
    /// Sends what has changed, as far as the GL has room. Returns the bytes sent.
    uint64_t upload() {
        if (m_dirty.empty()) return 0;
        reserve();
        const size_t held = this->held();
        std::sort(m_dirty.begin(), m_dirty.end());
        uint64_t sent = 0;
        for (size_t i = 0; i < m_dirty.size();) {
            size_t end = i + 1;
            while (end < m_dirty.size() && m_dirty[end] == m_dirty[end - 1] + 1) ++end;
            const size_t first = m_dirty[i] * kPage, last = std::min((m_dirty[end - 1] + 1) * kPage, held);
            if (first < last) {
                m_texture.upload(first * sizeof(T), std::as_bytes(std::span(m_data).subspan(first, last - first)));
                sent += (last - first) * sizeof(T);
            }
            i = end;
        }
        for (size_t page : m_dirty) m_pageDirty[page] = 0;
        m_dirty.clear();
        return sent;
    }
    /// The copy that shaders read.
    const BufferTexture& texture() const { return m_texture; }

private:
    static constexpr size_t kPage = sizeof(T) >= 256 ? 1 : 256 / sizeof(T);  ///< elements
    std::vector<T> m_data;
    std::vector<uint8_t> m_pageDirty;
    std::vector<size_t> m_dirty;
    BufferTexture m_texture;
    const char* m_name;
    bool m_fullLogged = false;
};

}  // namespace rubble
