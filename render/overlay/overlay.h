#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "render/overlay/font.h"
#include "render/overlay/overlay_item.h"

namespace rubble {

/// What is drawn over the image: items in their order, and the images that they name.
class Overlay {
public:
    static constexpr size_t kMaxImages = 4096, kMaxImageBytes = size_t(1) << 30;

    /// maxImageBytes: of the pixels of all images.
    explicit Overlay(size_t maxImageBytes = kMaxImageBytes) : m_maxImageBytes(maxImageBytes) {}

    /// Replaces all items. An error says which one names a font that cannot be read or an image that is not there;
    /// then all is as before.
    Result<Done> set(std::vector<OverlayItem> items);
    /// Gives an image a name, or replaces it. Without pixels: takes it away, with the items that name it. An error says
    /// that there would be too many, or too many pixels; then all is as before.
    Result<Done> setImage(const std::string& name, OverlayImage image);

    /// Whether nothing is drawn.
    bool empty() const { return m_items.empty(); }
    /// All items.
    const std::vector<OverlayItem>& items() const { return m_items; }
    /// The images by their names; without pixels: OverlayPass has taken them.
    std::map<std::string, OverlayImage>& images() { return m_images; }
    /// The fonts that its items name.
    Fonts& fonts() { return m_fonts; }

private:
    std::vector<OverlayItem> m_items;
    std::map<std::string, OverlayImage> m_images;
    size_t m_imageBytes = 0, m_maxImageBytes;  ///< of the pixels of all images
    Fonts m_fonts;
};

/// Width and height of a text as Overlay draws it, without outline and shadow. [any-thread] The error is that of
/// Fonts::find().
Result<glm::vec2> measureText(const std::string& font, float fontSize, float width, std::string_view text);

}  // namespace rubble
