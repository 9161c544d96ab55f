#include "render/gl/pass_timer.h"

#include <chrono>
#include <ctime>
#include <utility>

namespace rubble {
namespace {

double nanosecondsOf(const GlName<QueryKind>& timestamp) {
    GLuint64 nanoseconds = 0;
    glGetQueryObjectui64v(timestamp.get(), GL_QUERY_RESULT, &nanoseconds);
    return double(nanoseconds);
}

}  // namespace

double PassTimer::nowMs() const {
    if (m_processorTime) return double(std::clock()) * 1e3 / CLOCKS_PER_SEC;
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

GlName<QueryKind> PassTimer::timestamp() {
    GlName<QueryKind> query;
    if (m_spare.empty()) {
        query = GlName<QueryKind>::make();
    } else {
        query = std::move(m_spare.back());
        m_spare.pop_back();
    }
    glQueryCounter(query.get(), GL_TIMESTAMP);
    return query;
}

/// The GPU reaches timestamps in their order, so a frame is known when its last one is.
void PassTimer::readWhatIsReady() {
    while (!m_frames.empty()) {
        GLint isReady = GL_TRUE;
        if (!m_frames.front().empty())
            glGetQueryObjectiv(m_frames.front().back().end.get(), GL_QUERY_RESULT_AVAILABLE, &isReady);
        if (!isReady) return;
        m_times.clear();
        for (Timed& timed : m_frames.front()) {
            m_times.push_back({timed.name, (nanosecondsOf(timed.end) - nanosecondsOf(timed.begin)) * 1e-6, timed.tag});
            m_spare.push_back(std::move(timed.begin));
            m_spare.push_back(std::move(timed.end));
        }
        m_frames.pop_front();
    }
}

void PassTimer::beginFrame(bool isOn) {
    m_isOn = isOn;
    if (m_software) {
        m_times.clear();
        return;
    }
    readWhatIsReady();
    m_isOn = isOn && m_frames.size() < kMaxFrames;
    if (m_isOn) m_frames.emplace_back();
}

void PassTimer::begin(const char* name, int tag) {
    if (!m_isOn) return;
    if (m_software) {
        m_start = nowMs();
        m_times.push_back({name, 0.0, tag});
        return;
    }
    m_frames.back().push_back({name, tag, timestamp(), {}});
}

void PassTimer::end() {
    if (!m_isOn) return;
    if (m_software) {
        glFinish();
        m_times.back().ms = nowMs() - m_start;
        return;
    }
    m_frames.back().back().end = timestamp();
}

PassTimer::Times PassTimer::take() {
    return std::exchange(m_times, {});
}

}  // namespace rubble
