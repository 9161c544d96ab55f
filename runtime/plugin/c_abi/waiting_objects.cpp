#include "runtime/plugin/c_abi/waiting_objects.h"

namespace rubble::abi {

void WaitingObjects::follow(const EditQueue& queue) {
    const Edits& edits = queue.waiting();
    if (m_read > edits.size()) *this = {};
    for (; m_read < edits.size(); ++m_read) read(edits[m_read]);
}

void WaitingObjects::read(const Edit& edit) {
    if (const auto* resize = std::get_if<ResizeShapeEdit>(&edit)) {
        m_sizes[resize->shape] = resize->box.high - resize->box.low;
    } else if (const auto* trim = std::get_if<TrimShapeEdit>(&edit)) {
        m_sizes[trim->shape] = std::nullopt;
    } else if (const auto* merge = std::get_if<MergeShapeEdit>(&edit)) {
        if (merge->into) {
            m_sizes[merge->into] = std::nullopt;
        } else {
            m_sizes.clear();
            m_mergesAnywhere = true;
        }
    } else if (const auto* body = std::get_if<SetBodyEdit>(&edit)) {
        if (body->setsKind) m_kinds[body->body] = body->isStatic;
    } else if (const auto* history = std::get_if<HistoryEdit>(&edit)) {
        m_isRestored = m_isRestored || history->action != HistoryAction::Mark;
    }
}

std::optional<glm::ivec3> WaitingObjects::gridSize(ShapeHandle shape, std::optional<glm::ivec3> present) const {
    if (const auto set = m_sizes.find(shape); set != m_sizes.end()) return set->second;
    return m_isRestored || m_mergesAnywhere ? std::nullopt : present;
}

std::optional<bool> WaitingObjects::isStatic(BodyHandle body, std::optional<bool> present) const {
    if (const auto set = m_kinds.find(body); set != m_kinds.end()) return set->second;
    return m_isRestored ? std::nullopt : present;
}

}  // namespace rubble::abi
