#include "render/overlay/overlay.h"

#include <mutex>

#include "render/overlay/text_layout.h"

namespace rubble {
namespace {

/// Of its pixels, also when OverlayPass has taken them.
size_t bytesOf(const OverlayImage& image) {
    return size_t(image.size.x) * size_t(image.size.y) * 4;
}

}  // namespace

Result<Done> Overlay::set(std::vector<OverlayItem> items) {
    for (size_t i = 0; i < items.size(); ++i) {
        const OverlayItem& item = items[i];
        const std::string place = "items[" + std::to_string(i) + "].";
        if (item.kind == OverlayItem::Kind::Text)
            if (const auto font = m_fonts.find(item.font); !font) return Error{place + "font: " + font.error()};
        if (item.kind == OverlayItem::Kind::Image && !m_images.count(item.text))
            return Error{place + "text: expected the name of an image, found \"" + item.text + "\""};
    }
    m_items = std::move(items);
    return Done{};
}

Result<Done> Overlay::setImage(const std::string& name, OverlayImage image) {
    const auto known = m_images.find(name);
    const size_t others = m_imageBytes - (known == m_images.end() ? 0 : bytesOf(known->second));
    if (image.pixels.empty()) {
        if (known != m_images.end()) m_images.erase(known);
        m_imageBytes = others;
        std::erase_if(m_items, [&](const OverlayItem& item) {
            return item.kind == OverlayItem::Kind::Image && item.text == name;
        });
        return Done{};
    }
    if (known == m_images.end() && m_images.size() == kMaxImages)
        return Error{"there are " + std::to_string(kMaxImages) + " images already; take one away first"};
    const size_t all = others + bytesOf(image);
    if (all > m_maxImageBytes)
        return Error{"the pixels of all images would take " + std::to_string(all) + " bytes, expected at most " +
                     std::to_string(m_maxImageBytes) + "; take other images away first"};
    m_images[name] = std::move(image);
    m_imageBytes = all;
    return Done{};
}

Result<glm::vec2> measureText(const std::string& font, float fontSize, float width, std::string_view text) {
    static std::mutex mutex;  // FreeType's fonts are of one thread at a time
    static Fonts fonts;
    const std::lock_guard lock(mutex);
    const auto found = fonts.find(font);
    if (!found) return Error{found.error()};
    return layOut(**found, text, {fontSize, width, 0.0f}).size;
}

}  // namespace rubble
