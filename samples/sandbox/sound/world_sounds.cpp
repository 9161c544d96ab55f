#include "samples/sandbox/sound/world_sounds.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>

namespace sandbox::sound {
namespace {

constexpr double kLargest = 2.4;         ///< metres of a body that sounds: walls and floors are divided
constexpr double kFriction = 0.4;        ///< of what slides
constexpr double kImpactShare = 0.25;    ///< of an impact's energy that counts, beside that of tools
constexpr double kFrictionShare = 0.01;  ///< of what friction takes
constexpr double kRough = 0.01;          ///< metres from one bump to the next
constexpr double kBreakEnergy = 8.0;     ///< J for a voxel's face that parts
constexpr double kCrumbs = 16.0;         ///< voxels below which a break is softer: what burns away crumbles
constexpr int kFireSteps = 6;            ///< from one look at fires to the next
constexpr size_t kFirePlaces = 4;
constexpr double kFireCell = 4.0;  ///< metres of fires that sound as one

glm::dvec3 pointOf(const double (&v)[3]) {
    return {v[0], v[1], v[2]};
}

/// A piece of a material: of what is made in sheets, one of them.
std::array<double, 3> pieceSize(const AcousticMaterial& material, double side) {
    return {side, 0.8 * side, material.sheet > 0.0 ? std::min(material.sheet, 0.6 * side) : 0.6 * side};
}

}  // namespace

rubble_report_filter WorldSounds::filter() {
    rubble_report_filter filter = {};
    filter.struct_size = sizeof filter;
    filter.kinds = RUBBLE_REPORT_CONTACT_HIT | RUBBLE_REPORT_CONTACT_SLID | RUBBLE_REPORT_BREAK | RUBBLE_REPORT_JOINT |
                   RUBBLE_REPORT_WATER | RUBBLE_REPORT_FOOTSTEP;
    filter.min_impulse = 0.05;
    filter.min_hit_speed = 0.35;
    filter.min_slip_speed = 0.3;
    return filter;
}

size_t WorldSounds::materialOf(uint32_t index) {
    if (index == 0) return findAcousticMaterial("dirt");  // the ground around the level
    if (index >= m_materials.size()) m_materials.resize(index + 1);
    if (!m_materials[index]) {
        rubble_material material = {};
        material.struct_size = sizeof material;
        const bool isThere = m_api.get_material(m_world, index, &material) == RUBBLE_OK;
        m_materials[index] = isThere ? findAcousticMaterial(material.name) : 0;
    }
    return *m_materials[index];
}

WorldSounds::Side WorldSounds::sideOf(const rubble_contact& contact, int i) {
    const size_t row = materialOf(contact.materials[i]);
    rubble_shape_state shape = {};
    if (!contact.shapes[i] || m_api.get_shape_state(m_world, contact.shapes[i], &shape) != RUBBLE_OK)
        return {row, {1.0, 0.9, 0.8}};
    std::array<double, 3> sides;
    for (size_t k = 0; k < 3; ++k) sides[k] = std::min(std::max(1, shape.size[k]) * shape.voxel_size, kLargest);
    return {row, bodySize(acousticMaterials()[row], sides, shape.voxel_size)};
}

/// Both sides sound. An impact's energy is J v / 2, friction's mu J times the way that they slide.
void WorldSounds::readContacts(const rubble_reports& reports, std::vector<Strike>& strikes) {
    for (uint32_t i = 0; i < reports.contact_count; ++i) {
        const rubble_contact& contact = reports.contacts[i];
        const bool hits = contact.kinds & RUBBLE_REPORT_CONTACT_HIT;
        const double speed = hits ? contact.hit_speed : contact.slip_speed;
        if (!(contact.impulse > 0.0) || !(speed > 0.0)) continue;
        const Side sides[2] = {sideOf(contact, 0), sideOf(contact, 1)};
        const auto rows = acousticMaterials();
        const double mass = contact.impulse / speed;
        const double touch = contactTime(rows[sides[0].material], rows[sides[1].material], hits ? mass : 0.01, speed);
        const double joules = contact.impulse * speed * (hits ? 0.5 * kImpactShare : kFriction * kFrictionShare);
        for (const Side& side : sides) {
            Strike strike{pointOf(contact.position), side.material, side.size, 0.5 * joules, touch};
            strike.count = hits ? 1.0 : std::max(1.0, speed / 60.0 / kRough);
            strikes.push_back(strike);
        }
    }
}

/// A crack, and then the pieces that fall: some as large as the hole, many of the size of a voxel. No two are alike.
void WorldSounds::readBreaks(const rubble_reports& reports, std::vector<Strike>& strikes) {
    for (uint32_t i = 0; i < reports.break_count; ++i) {
        const rubble_break_report& row = reports.breaks[i];
        const size_t material = materialOf(row.material);
        const AcousticMaterial& acoustic = acousticMaterials()[material];
        const double faces = std::pow(double(row.voxels), 2.0 / 3.0), large = std::clamp(row.radius, 0.1, 1.5);
        const double joules = kBreakEnergy * faces * std::min(1.0, std::pow(double(row.voxels) / kCrumbs, 2.0));
        const auto add = [&](double size, double share, double contact, double count, double spread) {
            const auto sides = pieceSize(acoustic, size * std::exp2(0.8 * double(m_random.sign())));
            strikes.push_back({pointOf(row.position), material, sides, share * joules, contact, count, spread});
        };
        add(large, 1.0, 6e-5, std::min(3.0, faces), 0.02);
        if (double(row.voxels) < kCrumbs) continue;
        add(0.6 * large, 0.25, 2e-4, std::sqrt(faces), 0.5);
        add(0.12, 0.15, 6e-5, faces, 0.9);
    }
}

void WorldSounds::readOthers(const rubble_reports& reports, std::vector<Strike>& strikes) {
    for (uint32_t i = 0; i < reports.joint_count; ++i) {
        const rubble_joint_report& row = reports.joints[i];
        if (row.what != RUBBLE_REPORT_JOINT_OVERLOADED && row.what != RUBBLE_REPORT_JOINT_CUT) continue;
        strikes.push_back(
            {pointOf(row.position), findAcousticMaterial("wire"), {0.8, 0.02, 0.01}, 20.0, 1e-4, 2, 0.03});
    }
    for (uint32_t i = 0; i < reports.water_count; ++i) {
        const rubble_water_report& row = reports.waters[i];
        const double joules = 0.5 * row.mass * row.speed * row.speed;
        const glm::dvec3 at = pointOf(row.position);
        strikes.push_back({at, findAcousticMaterial("bubbles"), {1, 1, 1}, 2.0 * joules, 1e-3, 24, 0.6});
        strikes.push_back({at, findAcousticMaterial("burst"), {1, 1, 1}, 0.02 * joules, 3e-3, 2, 0.05});
    }
    for (uint32_t i = 0; i < reports.footstep_count; ++i) {
        const rubble_footstep& row = reports.footsteps[i];
        const size_t material = materialOf(row.material);
        const double joules = row.flags & RUBBLE_FOOTSTEP_LANDED ? 4.0 * row.speed * row.speed : 1.5;
        strikes.push_back(
            {pointOf(row.position), material, pieceSize(acousticMaterials()[material], 0.7), joules, 3e-3, 2, 0.06});
    }
}

void WorldSounds::read(std::vector<Strike>& strikes) {
    rubble_reports reports = {};
    reports.struct_size = sizeof reports;
    if (m_api.get_reports(m_world, &reports) != RUBBLE_OK) return;
    readContacts(reports, strikes);
    readBreaks(reports, strikes);
    readOthers(reports, strikes);
}

void WorldSounds::readFires(glm::dvec3 ear, std::vector<Loop>& loops) {
    if (--m_untilFires <= 0) {
        m_untilFires = kFireSteps;
        m_burning.clear();
        uint32_t count = 0;
        m_api.get_fires(m_world, nullptr, 0, &count);
        m_fires.resize(count);
        if (count && m_api.get_fires(m_world, m_fires.data(), count, &count) != RUBBLE_OK) m_fires.clear();
        struct Sum {
            glm::dvec3 position{0.0};
            double weight = 0.0;
        };
        std::map<std::tuple<int, int, int>, Sum> cells;
        for (const rubble_fire& fire : m_fires) {
            const glm::dvec3 cell = glm::floor(pointOf(fire.position) / kFireCell);
            Sum& sum = cells[{int(cell.x), int(cell.y), int(cell.z)}];
            sum.position += fire.intensity * pointOf(fire.position);
            sum.weight += fire.intensity;
        }
        for (const auto& [cell, sum] : cells) {
            if (sum.weight < 0.01) continue;
            const auto [x, y, z] = cell;
            const uint64_t id = uint64_t(uint16_t(x)) | uint64_t(uint16_t(y)) << 16 | uint64_t(uint16_t(z)) << 32;
            const double gain = std::min(0.12 * std::pow(sum.weight, 0.4), 0.8);
            m_burning.push_back({id | uint64_t(1) << 48, findLoopKind("fire"), sum.position / sum.weight, gain});
        }
        const auto heard = [&](const Loop& fire) { return fire.gain / (1.0 + glm::length(fire.position - ear)); };
        std::stable_sort(m_burning.begin(), m_burning.end(),
                         [&](const Loop& a, const Loop& b) { return heard(a) > heard(b); });
        if (m_burning.size() > kFirePlaces) m_burning.resize(kFirePlaces);
    }
    loops.insert(loops.end(), m_burning.begin(), m_burning.end());
}

}  // namespace sandbox::sound
