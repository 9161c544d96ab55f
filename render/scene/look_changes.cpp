#include "render/scene/look_changes.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "render/scene/bodies.h"

namespace rubble {
namespace {

constexpr float kGain = 8.0f;     ///< a change of 1 / kGain is large: no old colour is kept
constexpr int kMaxMoments = 10;   ///< for which a change is remembered: then a mean over frames takes a tenth of each
constexpr float kDark = 1e-3f;    ///< radiance below which a change is not seen
constexpr float kMinGlow = 0.1f;  ///< emission below which a change is not seen

float relativeChange(float a, float b, float least) {
    return std::min(std::abs(a - b) / std::max({a, b, least}), 1.0f);
}

float relativeChange(glm::vec3 a, glm::vec3 b) {
    const glm::vec3 difference = glm::abs(a - b);
    const auto most = [](glm::vec3 v) { return std::max({v.x, v.y, v.z}); };
    return std::min(most(difference) / std::max({most(a), most(b), kDark}), 1.0f);
}

float change(const PaletteEntry& a, const PaletteEntry& b) {
    const auto of = [&](uint8_t PaletteEntry::*byte) { return std::abs(int(a.*byte) - int(b.*byte)); };
    using E = PaletteEntry;
    const int bytes = std::max({of(&E::red), of(&E::green), of(&E::blue), of(&E::opacity), of(&E::roughness),
                                of(&E::metallic), of(&E::reflectivity)});
    return std::max(float(bytes) / 255.0f, relativeChange(a.emission, b.emission, kMinGlow));
}

/// Share of this frame, so many moments after a change, in a mean that began with it.
float newShareAfter(float change, int age) {
    return std::min(change, 1.0f) / float(age + 1);
}

}  // namespace

void LookChanges::addPalette(uint32_t slot, const Palette& before, const Palette& after) {
    float most = 0.0f;
    // No voxel has shown an entry that was unused.
    for (size_t i = 1; i < before.size(); ++i)
        if (before[i].material && before[i] != after[i]) most = std::max(most, change(before[i], after[i]));
    if (most > 0.0f) m_nextShapes.push_back({slot, most});
}

void LookChanges::addEnvironment(const Environment& before, const Environment& after) {
    if (before == after) return;
    const auto of = [&](auto Environment::*field) { return relativeChange(before.*field, after.*field); };
    const auto share = [&](float Environment::*field, float all) {
        return std::min(std::abs(before.*field - after.*field) / all, 1.0f);
    };
    using E = Environment;
    const float turn =
        glm::distance(glm::normalize(before.sunDirection), glm::normalize(after.sunDirection));  // nearly an angle
    const bool isSunUp = before.sunDirection.y > 0.0f || after.sunDirection.y > 0.0f;
    const float sun = isSunUp ? std::max(of(&E::sunColor), std::min(turn, 1.0f)) : 0.0f;
    const float light =
        std::max({sun, of(&E::skyColor), of(&E::horizonColor), of(&E::groundColor), share(&E::clouds, 1.0f)});
    const auto scalar = [&](float Environment::*field, float least) {
        return relativeChange(before.*field, after.*field, least);
    };
    const float air = std::max({of(&E::fogColor), scalar(&E::fogDistance, 1.0f), scalar(&E::fogDensity, 0.01f),
                                share(&E::fogBase, 10.0f), scalar(&E::fogHeight, 1.0f), of(&E::fogTint)});
    const float look = std::max({light, air, scalar(&E::stars, 0.1f), share(&E::wetness, 1.0f)});
    const float sunDiameter = 2.0f * std::max({before.sunAngle, after.sunAngle, 1e-3f});
    m_next.look = std::max(m_next.look, look);
    m_next.light = std::max(m_next.light, light);
    m_next.sun = std::max(m_next.sun, std::min(turn / sunDiameter, 1.0f));
}

void LookChanges::replaceAll() {
    const uint64_t replacements = m_replacements + 1;
    *this = {};
    m_replacements = replacements;
}

void LookChanges::beginMoment() {
    m_moments.insert(m_moments.begin(), m_next);
    if (m_moments.size() > size_t(kMaxMoments)) m_moments.pop_back();
    m_next = {};
    for (ShapeChange& shape : m_shapes) ++shape.age;
    std::erase_if(m_shapes, [](const ShapeChange& shape) { return shape.age >= kMaxMoments; });
    m_shapes.insert(m_shapes.end(), m_nextShapes.begin(), m_nextShapes.end());
    m_nextShapes.clear();
}

void LookChanges::findBoxes(const Bodies& bodies) {
    m_boxes.clear();
    for (const ShapeChange& shape : m_shapes) {
        if (shape.slot >= bodies.instances().size() || bodies.instances()[shape.slot].empty()) continue;
        addBox({bodies.instances()[shape.slot].box(), shape.age == 0 ? shape.change : 0.0f,
                shape.age <= 1 ? shape.change : 0.0f, newShareAfter(kGain * shape.change, shape.age)});
    }
}

/// At kMaxBoxes a box joins the one that grows least.
void LookChanges::addBox(const Box& added) {
    if (m_boxes.size() < kMaxBoxes) {
        m_boxes.push_back(added);
        return;
    }
    const auto growth = [&](const Box& box) { return box.box.merged(added.box).area() - box.box.area(); };
    Box& least = *std::min_element(m_boxes.begin(), m_boxes.end(),
                                   [&](const Box& a, const Box& b) { return growth(a) < growth(b); });
    least = {least.box.merged(added.box), std::max(least.now, added.now), std::max(least.lately, added.lately),
             std::max(least.newShare, added.newShare)};
}

float LookChanges::lightChange(int moments) const {
    float most = 0.0f;
    for (size_t i = 0; i < std::min(m_moments.size(), size_t(moments)); ++i) most = std::max(most, m_moments[i].light);
    return most;
}

float LookChanges::newShare() const {
    float share = 0.0f;
    for (size_t i = 0; i < m_moments.size(); ++i)
        share = std::max(share, newShareAfter(kGain * m_moments[i].look, int(i)));
    return share;
}

float LookChanges::newSunShare() const {
    float share = 0.0f;
    for (size_t i = 0; i < m_moments.size(); ++i) share = std::max(share, newShareAfter(m_moments[i].sun, int(i)));
    return share;
}

}  // namespace rubble
