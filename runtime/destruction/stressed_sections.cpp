#include "runtime/destruction/stressed_sections.h"

#include <array>
#include <bit>
#include <glm/geometric.hpp>
#include <utility>

namespace rubble {
namespace {

uint64_t planeKey(glm::ivec3 brick, int axis, int plane) {
    return brickKey(brick) | uint64_t(axis) << 48 | uint64_t(plane) << 50;
}

/// Whether cells `a` of a plane touch cells `b` in the brick (u, v) bricks further on in the plane.
bool touches(uint64_t a, uint64_t b, int u, int v) {
    if (u * u + v * v > 1) return false;
    if (u) return u > 0 ? (a >> 7 & b & kFirstColumn) != 0 : (b >> 7 & a & kFirstColumn) != 0;
    if (v) return v > 0 ? (a >> 56 & b & 0xff) != 0 : (b >> 56 & a & 0xff) != 0;
    const uint64_t spread = (a << 1 & ~kFirstColumn) | (a >> 1 & ~kLastColumn) | a << 8 | a >> 8;
    return (spread & b) != 0;
}

}  // namespace

void StressedSections::clear() {
    m_sections.clear();
    m_previous.clear();
    m_inPlane.clear();
}

double StressedSections::add(const Section& section, const SectionShape& shape, const SectionForce& load,
                             const SectionStrength& strength, bool canBreak) {
    const glm::dvec3 arm = shape.centroid - glm::dvec3(section.brick * kBrickSize);
    uint32_t& last = m_inPlane[planeKey(section.brick, section.axis, section.plane)];
    m_previous.push_back(std::exchange(last, uint32_t(m_sections.size())));
    m_sections.push_back({section,
                          {load.force, load.moment + glm::cross(arm, load.force)},
                          strength,
                          canBreak,
                          sectionUtilization(section, shape, load, strength).utilization});
    return m_sections.back().ownUtilization;
}

SectionUtilization StressedSections::windowUtilization(size_t index) {
    const StressedSection& middle = m_sections[index];
    const int axis = middle.section.axis, axisU = kSectionU[size_t(axis)], axisV = kSectionV[size_t(axis)];
    m_members.clear();
    for (int v = -kWindowRadius; v <= kWindowRadius; ++v)
        for (int u = -kWindowRadius; u <= kWindowRadius; ++u) {
            glm::ivec3 brick = middle.section.brick;
            brick[axisU] += u, brick[axisV] += v;
            for (uint32_t i = m_inPlane.find(planeKey(brick, axis, middle.section.plane)); i != IndexMap::kNone;
                 i = m_previous[i])
                m_members.push_back({i, u, v, i == index});
        }
    for (bool hasGrown = true; hasGrown;) {  // flood fill from the section
        hasGrown = false;
        for (Member& next : m_members) {
            for (const Member& in : m_members)
                if (!next.isIn && in.isIn &&
                    touches(m_sections[in.index].section.cells, m_sections[next.index].section.cells, next.u - in.u,
                            next.v - in.v))
                    next.isIn = hasGrown = true;
        }
    }
    m_tiles.clear();
    SectionForce load;
    for (const Member& member : m_members) {
        if (!member.isIn) continue;
        const StressedSection& stressed = m_sections[member.index];
        m_tiles.push_back({stressed.section.cells, member.u, member.v});
        const glm::dvec3 arm((stressed.section.brick - middle.section.brick) * kBrickSize);
        load.force += stressed.load.force;
        load.moment += stressed.load.moment + glm::cross(arm, stressed.load.force);
    }
    const SectionShape shape = sectionShape(middle.section, m_tiles);
    load.moment -= glm::cross(shape.centroid - glm::dvec3(middle.section.brick * kBrickSize), load.force);
    return sectionUtilization(middle.section, shape, load, middle.strength);
}

}  // namespace rubble
