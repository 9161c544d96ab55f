#include "runtime/plugin/fire_reports.h"

#include <algorithm>
#include <iterator>

namespace rubble {
namespace {

/// The order of findFires(), and of two shapes that had one slot after each other.
bool isBefore(const Fire& a, const Fire& b) {
    if (a.shape.slot() != b.shape.slot()) return a.shape.slot() < b.shape.slot();
    return a.shape != b.shape ? a.shape < b.shape : cellBefore(a.brick, b.brick);
}

}  // namespace

void FireReports::restart(const WorldState& world) {
    m_burning = findFires(world);
    m_lit.clear(), m_out.clear();
}

void FireReports::step(const WorldState& world) {
    std::vector<Fire> now = findFires(world);
    m_lit.clear(), m_out.clear();
    std::set_difference(now.begin(), now.end(), m_burning.begin(), m_burning.end(), std::back_inserter(m_lit),
                        isBefore);
    std::set_difference(m_burning.begin(), m_burning.end(), now.begin(), now.end(), std::back_inserter(m_out),
                        isBefore);
    m_burning = std::move(now);
}

}  // namespace rubble
