#include "samples/sandbox/sound/mixer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace sandbox::sound {
namespace {

constexpr float kInaudible = 3e-5f;  ///< level at which a body has died away: -90 dB
constexpr double kMaxHits = 24;      ///< of a strike: more of them sound the same
constexpr int kPart = 16;            ///< samples: no hit is further from its time

/// How different two bodies sound, in octaves.
double difference(size_t materialA, double sizeA, size_t materialB, double sizeB) {
    return (materialA == materialB ? 0.0 : 3.0) + std::abs(std::log2(sizeA / sizeB));
}

}  // namespace

size_t Mixer::bodies() const {
    return size_t(std::count_if(m_bodies.begin(), m_bodies.end(), [](const Body& body) { return body.isUsed; }));
}

/// The place of a strike: one that is heard from the same direction, a free one, or the closest.
size_t Mixer::emitterFor(const Strike& strike) {
    const double distance = glm::length(strike.position - m_ear);
    size_t best = 0, freeOne = kPlaces;
    double bestWay = 1e300;
    for (size_t i = 0; i < kPlaces; ++i) {
        if (!m_emitters[i].isActive) freeOne = std::min(freeOne, i);
        if (!m_emitters[i].isActive) continue;
        const double way = glm::length(m_emitters[i].position - strike.position);
        if (way < bestWay) bestWay = way, best = i;
    }
    if (bestWay < 0.5 + 0.1 * distance || freeOne == kPlaces) {
        m_emitters[best].openness += 0.5 * (strike.openness - m_emitters[best].openness);
        return best;
    }
    m_emitters[freeOne].isActive = true;
    m_emitters[freeOne].position = strike.position;
    m_emitters[freeOne].openness = strike.openness;
    return freeOne;
}

Mixer::Body* Mixer::quietest() {
    Body* found = nullptr;
    double least = 1e300;
    for (Body& body : m_bodies) {
        if (body.fades || !body.hits.empty()) continue;
        const double level = body.resonators.level() / (1.0 + glm::length(m_emitters[body.emitter].position - m_ear));
        if (level < least) least = level, found = &body;
    }
    return found;
}

/// The body that a strike excites: the one that sounds already, a free one, or one of its place that sounds much the
/// same. Null: the quietest one of all fades out for it, and the strike waits a block.
Mixer::Body* Mixer::bodyFor(const Strike& strike, size_t emitter) {
    Body *freeOne = nullptr, *similar = nullptr;
    double least = 1e300;
    for (Body& body : m_bodies) {
        if (!body.isUsed && !freeOne) freeOne = &body;
        if (!body.isUsed || body.fades || body.emitter != emitter) continue;
        const double other = difference(body.material, body.size[0], strike.material, strike.size[0]);
        if (other < least) least = other, similar = &body;
    }
    if (least < 0.5) return similar;
    if (freeOne) {
        freeOne->isUsed = true;
        freeOne->emitter = emitter;
        freeOne->material = strike.material;
        freeOne->size = strike.size;
        freeOne->resonators.set(acousticMaterials()[strike.material], strike.size);
        return freeOne;
    }
    if (Body* body = quietest(); body && least > 2.0) {
        body->fades = true;
        return nullptr;
    }
    return similar;
}

bool Mixer::begin(const Strike& strike) {
    Body* body = bodyFor(strike, emitterFor(strike));
    if (body) scatter(*body, strike);
    return body;
}

/// Its hits, at random times of the step and with random shares of its energy: what a step reports
/// happened within it, and all at its begin would be a tone of 60 Hz.
void Mixer::scatter(Body& body, const Strike& strike) {
    const double delay = std::min(glm::length(strike.position - m_ear) / 343.0, 1.0);
    const int count = int(std::clamp(strike.count, 1.0, kMaxHits));
    std::array<float, size_t(kMaxHits)> shares;
    float sum = 0.0f;
    for (int i = 0; i < count; ++i) sum += shares[size_t(i)] = m_random.exponential() + 0.05f;
    for (int i = 0; i < count; ++i) {
        const double early = double(m_random.unit()) * double(m_random.unit());
        const double seconds = delay + early * strike.spread + double(m_random.unit()) * kBlock / kSampleRate;
        const float amplitude = float(loudness(strike.joules)) * std::sqrt(shares[size_t(i)] / sum);
        body.hits.push_back({int(seconds * kSampleRate), amplitude, float(strike.contact)});
    }
}

void Mixer::renderBody(Body& body) {
    std::array<float, kBlock> block{};
    std::sort(body.hits.begin(), body.hits.end(), [](const Hit& a, const Hit& b) { return a.due < b.due; });
    size_t done = 0;
    for (int at = 0; at < kBlock;) {
        while (done < body.hits.size() && body.hits[done].due < at + kPart) {
            body.resonators.strike(body.hits[done].amplitude, double(body.hits[done].contact), m_random);
            ++done;
        }
        const int next = done < body.hits.size() ? std::min(body.hits[done].due / kPart * kPart, kBlock) : kBlock;
        body.resonators.render(block.data() + at, next - at, m_random);
        at = next;
    }
    body.hits.erase(body.hits.begin(), body.hits.begin() + ptrdiff_t(done));
    for (Hit& hit : body.hits) hit.due -= kBlock;
    float* out = m_emitters[body.emitter].block.data();
    for (int i = 0; i < kBlock; ++i)
        out[i] += body.fades ? block[size_t(i)] * (1.0f - float(i) / kBlock) : block[size_t(i)];
    if (body.fades || (body.hits.empty() && body.resonators.level() < kInaudible)) body.isUsed = body.fades = false;
}

void Mixer::followLoops() {
    for (auto& loop : m_loops)
        if (loop) loop->isWanted = false;
    for (const Loop& wanted : m_wanted) {
        const auto same = std::find_if(m_loops.begin(), m_loops.end(), [&](const auto& loop) {
            return loop && loop->state.id == wanted.id && loop->state.kind == wanted.kind;
        });
        const auto place = same != m_loops.end() ? same : std::find(m_loops.begin(), m_loops.end(), std::nullopt);
        if (place == m_loops.end()) continue;
        if (same == m_loops.end()) place->emplace(wanted, true, LoopVoice(*wanted.kind, m_random.bits()));
        (*place)->state = wanted;
        (*place)->isWanted = true;
    }
}

void Mixer::renderLoops() {
    followLoops();
    for (size_t i = 0; i < kLoops; ++i) {
        auto& loop = m_loops[i];
        Emitter& emitter = m_emitters[kPlaces + i];
        emitter.isActive = loop.has_value();
        if (!loop) continue;
        const float gain = loop->voice.gain(), goal = loop->isWanted ? float(loop->state.gain) : 0.0f;
        const float next = gain + std::clamp(goal - gain, -0.2f, 0.2f);  // five blocks from nothing to 1
        emitter.position = loop->state.position;
        emitter.openness = loop->state.openness;
        emitter.isAtEar = loop->state.isAtEar;
        loop->voice.render(emitter.block.data(), next, loop->state.pitch);
        if (!loop->isWanted && next <= 0.0f) loop.reset();
    }
}

void Mixer::render() {
    for (Emitter& emitter : m_emitters)
        if (emitter.isActive) emitter.block.fill(0.0f);
    std::erase_if(m_waiting, [&](const Strike& strike) { return begin(strike); });
    std::array<bool, kPlaces> sounds{};
    for (Body& body : m_bodies) {
        if (!body.isUsed) continue;
        sounds[body.emitter] = true;
        renderBody(body);
    }
    for (size_t i = 0; i < kPlaces; ++i) m_emitters[i].isActive = sounds[i];
    renderLoops();
}

}  // namespace sandbox::sound
