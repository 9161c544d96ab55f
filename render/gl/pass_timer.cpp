#include "render/gl/pass_timer.h"

#include <chrono>
#include <ctime>

namespace rubble {

double PassTimer::nowMs() const {
    if (m_processorTime) return double(std::clock()) * 1e3 / CLOCKS_PER_SEC;
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void PassTimer::beginFrame(Times& out) {
    out.clear();
    for (size_t i = 0; i < m_count; ++i) {
        GLuint64 nanoseconds = 0;
        glGetQueryObjectui64v(m_running[i].query.get(), GL_QUERY_RESULT, &nanoseconds);
        out.emplace_back(m_running[i].name, double(nanoseconds) * 1e-6);
    }
    m_count = 0;
}

void PassTimer::begin(const char* name) {
    if (m_software) {
        m_start = nowMs();
        m_running.resize(1);
        m_running[0].name = name;
        return;
    }
    if (m_count == m_running.size()) m_running.push_back({name, GlName<QueryKind>::make()});
    m_running[m_count].name = name;
    glBeginQuery(GL_TIME_ELAPSED, m_running[m_count].query.get());
}

void PassTimer::end(Times& out) {
    if (!m_software) {
        glEndQuery(GL_TIME_ELAPSED);
        ++m_count;
        return;
    }
    glFinish();
    out.emplace_back(m_running[0].name, nowMs() - m_start);
}

}  // namespace rubble
