#include "render/renderer.h"

#include <optional>
#include <utility>

#include "runtime/plugin/frame_loop.h"
#include "runtime/plugin/layers.h"

namespace rubble {

bool hasRenderer() {
    return true;
}

void FrameLoop::draw(Renderer& renderer, const View& view, float alpha) {
    try {
        m_times[Stage::Apply] = 0.0;
        const ScopedTimer timer(m_times[Stage::Apply]);
        releaseFinished();
        std::optional<FrameSnapshot> snapshot = m_snapshots.take();
        if (snapshot && snapshot->replacesAll) m_awaitsAll = false;
        if (snapshot && !m_awaitsAll) renderer.apply(std::move(*snapshot));
    } catch (...) {
        restartDrawing();  // what was handed over is lost
        throw;
    }
    m_times[Stage::Draw] = 0.0;
    const ScopedTimer timer(m_times[Stage::Draw]);
    renderer.draw(view, alpha);
}

}  // namespace rubble
