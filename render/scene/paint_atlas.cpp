#include "render/scene/paint_atlas.h"

namespace rubble {

void PaintAtlas::growTo(uint32_t slots) {
    const size_t before = m_numbers.size();
    if (slots <= before) return;
    m_numbers.resize(slots);
    for (size_t i = before; i < slots; ++i) m_numbers.change(i) = 0;
}

void PaintAtlas::put(uint32_t slot, const Brick& brick) {
    if (!brick.paint) return;
    growTo(slot + 1);
    const uint32_t number = m_free.allocate();
    m_paint.resize(std::max<size_t>(m_paint.size(), m_free.end()));
    m_paint.change(number) = *brick.paint;
    m_numbers.change(slot) = number + 1;
}

void PaintAtlas::remove(uint32_t slot) {
    if (slot >= m_numbers.size() || m_numbers[slot] == 0) return;
    m_free.free(m_numbers[slot] - 1);
    m_numbers.change(slot) = 0;
}

void PaintAtlas::setColors(uint32_t shapeSlot, const PaintColors& colors) {
    m_colors.resize(std::max<size_t>(m_colors.size(), shapeSlot + 1));
    Table& table = m_colors.change(shapeSlot);
    for (size_t i = 0; i < colors.colors.size(); ++i) {
        const Srgb& color = colors.colors[i];
        table[i + 1] = uint32_t(color[0]) | uint32_t(color[1]) << 8 | uint32_t(color[2]) << 16;
    }
}

uint64_t PaintAtlas::upload(uint32_t slots) {
    growTo(slots);
    return m_numbers.upload() + m_paint.upload() + m_colors.upload();
}

void PaintAtlas::bind(const Program& program) const {
    program.set("uPaintSlots", m_numbers.texture());
    program.set("uPaint", m_paint.texture());
    program.set("uPaintColors", m_colors.texture());
}

}  // namespace rubble
