#include "samples/sandbox/sound/strike.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace sandbox::sound {
namespace {

using Key = std::tuple<size_t, int, int, int, int, int>;  ///< material, octave of size, cell, octave of its side

Key keyOf(const Strike& strike, glm::dvec3 ear) {
    const double distance = glm::length(strike.position - ear);
    const int scale = int(std::floor(std::log2(std::max(0.15 * distance, 0.75))));
    const glm::dvec3 cell = glm::floor(strike.position / std::exp2(scale));
    return {strike.material, int(std::floor(std::log2(std::max(strike.size[0], 0.01)))),
            int(cell.x),     int(cell.y),
            int(cell.z),     scale};
}

double audibility(const Strike& strike, glm::dvec3 ear) {
    const glm::dvec3 way = strike.position - ear;
    return strike.joules / (4.0 + glm::dot(way, way));
}

/// Adds the energy of one to another, whose place and size become the mean of both by energy.
void join(Strike& into, const Strike& other) {
    const double sum = into.joules + other.joules;
    const double share = sum > 0.0 ? other.joules / sum : 0.0;
    into.position += (other.position - into.position) * share;
    for (size_t i = 0; i < 3; ++i) into.size[i] *= std::pow(other.size[i] / into.size[i], share);
    into.contact *= std::pow(other.contact / into.contact, share);
    into.spread = std::max(into.spread, other.spread);
    into.count += other.count;
    into.joules = sum;
}

Strike& closest(std::vector<Strike>& strikes, size_t limit, const Strike& to) {
    const auto far = [&](const Strike& one) {
        return glm::length(one.position - to.position) + (one.material == to.material ? 0.0 : 1e3);
    };
    return *std::min_element(strikes.begin(), strikes.begin() + ptrdiff_t(limit),
                             [&](const Strike& a, const Strike& b) { return far(a) < far(b); });
}

}  // namespace

double loudness(double joules) {
    return std::min(0.40 * std::pow(std::max(joules, 0.0), kLoudnessPower), 10.0);
}

std::vector<Strike> joinStrikes(std::span<const Strike> strikes, glm::dvec3 ear, size_t limit) {
    std::map<Key, Strike> groups;
    for (const Strike& strike : strikes) {
        if (!(strike.joules > 0.0)) continue;
        const auto [place, isNew] = groups.try_emplace(keyOf(strike, ear), strike);
        if (!isNew) join(place->second, strike);
    }
    std::vector<Strike> joined;
    for (const auto& [key, strike] : groups) joined.push_back(strike);
    if (joined.size() <= limit) return joined;
    std::stable_sort(joined.begin(), joined.end(),
                     [&](const Strike& a, const Strike& b) { return audibility(a, ear) > audibility(b, ear); });
    for (size_t i = limit; i < joined.size(); ++i) join(closest(joined, limit, joined[i]), joined[i]);
    joined.resize(limit);
    return joined;
}

}  // namespace sandbox::sound
