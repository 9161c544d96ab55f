#include "samples/sandbox/shell/still.h"

#include <utility>

namespace sandbox {
namespace {

constexpr int kDraws = 16;      ///< in which light settles
constexpr uint32_t kSlot = 15;  ///< of the renderer's views: that of no other

}  // namespace

rubble::Result<std::unique_ptr<Still>> Still::begin(rubble::Display& display, std::string path, glm::ivec2 size) {
    auto target = display.memoryBeside(size);
    if (!target) return rubble::Error{target.error()};
    return std::unique_ptr<Still>(new Still(std::move(*target), std::move(path)));
}

double Still::progress() const {
    return double(m_draws) / kDraws;
}

std::string Still::draw(const rubble_api& api, rubble_renderer renderer, rubble_view view) {
    view.framebuffer = m_target->framebuffer();
    view.width = uint32_t(m_target->size().x), view.height = uint32_t(m_target->size().y);
    view.slot = kSlot;
    view.flags &= ~uint32_t(RUBBLE_VIEW_CUT);
    if (m_draws == 0) view.flags |= RUBBLE_VIEW_CUT;
    if (api.set_overlay(renderer, nullptr, 0) != RUBBLE_OK || api.draw(renderer, &view) != RUBBLE_OK)
        return api.get_last_error();
    if (++m_draws < kDraws) return "";
    const auto written = rubble::writePng(m_path, m_target->read());
    return written ? "" : written.error();
}

}  // namespace sandbox
