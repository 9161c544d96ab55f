#include "physics/collision/cover.h"

#include <algorithm>

namespace rubble {

void Cover::add(const ColliderPart& solid, const CellTransform& solidCells, const CellTransform& partCells) {
    const glm::dmat3 toSolid = metresToCells(solidCells, solid.voxelSize());
    const Solid added{Occupancy(solid), glm::mat3(toSolid * partCells.axes),
                      glm::vec3(toSolid * (partCells.corner - solidCells.corner))};
    if (m_count < m_first.size())
        m_first[m_count].emplace(added);
    else
        m_more.push_back(added);
    ++m_count;
}

bool Cover::contains(const glm::vec3& point) {
    const auto holds = [&](Solid& solid) { return solid.occupancy.solid(cellOf(solid.corner + solid.axes * point)); };
    for (size_t i = 0; i < std::min(m_count, m_first.size()); ++i)
        if (holds(*m_first[i])) return true;
    return std::any_of(m_more.begin(), m_more.end(), holds);
}

bool Cover::covers(Cell cell, const glm::vec3& p, int axis, int sign) {
    glm::vec3 beyond = glm::clamp(p, glm::vec3(cell) + kSeam, glm::vec3(cell + 1) - kSeam);
    beyond[axis] = sign > 0 ? float(cell[axis] + 1) + kSeam : float(cell[axis]) - kSeam;
    return contains(beyond);
}

bool Occupancy::isCovered(Cell cell, const glm::vec3& p, int axis, int sign) {
    return m_cover->covers(cell, p, axis, sign);
}

bool Occupancy::isCovered(Cell cell) {
    return m_cover->contains(glm::vec3(cell) + 0.5f);
}

}  // namespace rubble
