#include "render/overlay/overlay.h"

#include <mutex>

#include "render/overlay/text_layout.h"

namespace rubble {

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

void Overlay::setImage(const std::string& name, OverlayImage image) {
    if (!image.pixels.empty()) {
        m_images[name] = std::move(image);
        return;
    }
    m_images.erase(name);
    std::erase_if(m_items,
                  [&](const OverlayItem& item) { return item.kind == OverlayItem::Kind::Image && item.text == name; });
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
