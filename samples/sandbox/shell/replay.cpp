#include "samples/sandbox/shell/replay.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "runtime/script/binding/script_context.h"

namespace sandbox {
namespace {

using rubble::script::sized;
constexpr double kStepsOfSecond = 60.0;
constexpr size_t kMaxBytes = size_t(64) << 20;  ///< of all steps
constexpr size_t kStepsOfChain = 300;           ///< after which deltas begin again
constexpr size_t kMaxFlames = 24;               ///< of a step
constexpr size_t kMaxBursts = 256;              ///< of a step
constexpr uint32_t kDeltas = RUBBLE_DELTAS_ALL | RUBBLE_DELTAS_EVENTS;

Replay* s_noting = nullptr;
decltype(rubble_api::spawn_particles) s_spawn = nullptr;

}  // namespace

Replay::Replay(const rubble_api& api, uint32_t worldFlags, RendererMaker makeRenderer)
    : m_api(api), m_worldFlags(worldFlags), m_makeRenderer(std::move(makeRenderer)) {}

Replay::~Replay() {
    keep(0.0);
    s_noting = nullptr;
}

size_t Replay::Step::bytes() const {
    return delta.capacity() + bursts.capacity() * sizeof bursts[0] + flames.capacity() * sizeof flames[0] +
           sizeof *this;
}

void Replay::keep(double seconds) {
    const auto most = size_t(std::clamp(seconds, 0.0, 300.0) * kStepsOfSecond);
    if (m_most == most) return;
    m_most = most;
    forget();
}

void Replay::forget() {
    hide();
    if (m_game) m_api.keep_deltas(std::exchange(m_game, 0), RUBBLE_DELTAS_NONE);
    if (m_behind) m_api.destroy_world(std::exchange(m_behind, 0));
    m_steps = {};
    m_bursts = {};
    m_taken = {};
    m_bytes = m_sinceFirst = 0;
    m_isDue = m_most > 0;
}

rubble_api Replay::notingApi() {
    s_noting = this;
    s_spawn = m_api.spawn_particles;
    rubble_api api = m_api;
    api.spawn_particles = [](rubble_world world, const rubble_particle_burst* burst) {
        const rubble_result result = s_spawn(world, burst);
        if (Replay* replay = s_noting; replay && result == RUBBLE_OK && replay->m_behind)
            if (replay->m_bursts.size() < kMaxBursts) replay->m_bursts.push_back(*burst);
        return result;
    };
    return api;
}

std::string Replay::beforeStep(rubble_world game) {
    return !m_isDue || begin(game) ? "" : stop();
}

std::string Replay::afterStep(rubble_world game) {
    hide();
    return !m_behind || add(game) ? "" : stop();
}

std::string Replay::stop() {
    const std::string what = m_api.get_last_error();
    forget();
    m_isDue = false;
    return what;
}

bool Replay::saveInto(std::vector<uint8_t>& game, rubble_world world) const {
    uint64_t count = 0;
    if (m_api.save_game_data(world, nullptr, 0, &count) != RUBBLE_OK) return false;
    game.resize(count);
    return m_api.save_game_data(world, game.data(), count, &count) == RUBBLE_OK;
}

bool Replay::begin(rubble_world game) {
    m_isDue = false;
    m_game = game;
    std::vector<uint8_t> start;
    auto settings = sized<rubble_world_settings>();
    settings.flags = RUBBLE_WORLD_NO_RENDERER;
    settings.physics_threads = 1;
    return saveInto(start, game) && m_api.create_world(&settings, &m_behind) == RUBBLE_OK &&
           m_api.load_game_data(m_behind, start.data(), start.size()) == RUBBLE_OK &&
           m_api.keep_deltas(game, kDeltas) == RUBBLE_OK;
}

bool Replay::add(rubble_world game) {
    uint64_t count = 0;
    m_taken.resize(std::max(m_taken.size(), size_t(4096)));
    rubble_result taken = m_api.take_deltas(game, m_taken.data(), m_taken.size(), &count);
    if (taken == RUBBLE_ERROR_CAPACITY) {
        m_taken.resize(count);
        taken = m_api.take_deltas(game, m_taken.data(), count, &count);
    }
    if (taken != RUBBLE_OK) return false;
    Step step{m_sinceFirst == 0, {m_taken.begin(), m_taken.begin() + ptrdiff_t(count)}, m_bursts, flamesOf(game)};
    m_bursts.clear();
    m_bytes += step.bytes();
    m_steps.push_back(std::move(step));
    while (m_steps.size() > m_most + kStepsOfChain || m_bytes > kMaxBytes)
        if (!dropFirst()) return false;
    if (++m_sinceFirst < kStepsOfChain) return true;
    m_sinceFirst = 0;
    return m_api.keep_deltas(game, kDeltas) == RUBBLE_OK;
}

bool Replay::dropFirst() {
    const std::vector<uint8_t>& delta = m_steps.front().delta;
    if (m_api.apply_deltas(m_behind, delta.data(), delta.size()) != RUBBLE_OK) return false;
    m_bytes -= m_steps.front().bytes();
    m_steps.pop_front();
    return true;
}

/// Some of the fires, in turns.
std::vector<Replay::Flame> Replay::flamesOf(rubble_world game) {
    uint32_t count = 0;
    std::vector<Flame> flames;
    if (m_api.get_fires(game, nullptr, 0, &count) != RUBBLE_OK || count == 0) return flames;
    std::vector<rubble_fire> fires(count);
    if (m_api.get_fires(game, fires.data(), count, &count) != RUBBLE_OK) return flames;
    flames.resize(std::min<size_t>(kMaxFlames, (count * 2 + 2) / 3));
    for (Flame& flame : flames) {
        const rubble_fire& fire = fires[m_turn++ % count];
        for (int i = 0; i < 3; ++i) flame.position[size_t(i)] = float(fire.position[i]);
        flame.radius = float(fire.radius), flame.intensity = float(fire.intensity);
    }
    return flames;
}

double Replay::length() const {
    return double(std::min(m_steps.size(), m_most)) / kStepsOfSecond;
}

/// The world behind goes on to a step with which another one may begin.
bool Replay::open() {
    while (!m_steps.empty() && !m_steps.front().isFirst)
        if (!dropFirst()) return false;
    auto settings = sized<rubble_world_settings>();
    settings.flags = m_worldFlags;
    settings.physics_threads = 1;
    m_place = SIZE_MAX;
    return saveInto(m_starts[0], m_behind) && m_api.create_world(&settings, &m_shown) == RUBBLE_OK;
}

std::string Replay::show(double ago, const std::string& unseenTag) {
    if (m_steps.empty()) return "a replay: expected steps that are kept, found none";
    const auto failed = [&] {
        const std::string what = m_api.get_last_error();
        hide();
        return what;
    };
    if (!m_shown && !open()) return failed();
    m_isWanted = true;
    const double steps = std::clamp(double(m_steps.size()) - ago * kStepsOfSecond, 0.0, double(m_steps.size()));
    const size_t place = std::max(size_t(std::ceil(steps)), size_t(1));
    if (!seek(place)) return failed();
    m_alpha = std::clamp(1.0 - (double(place) - steps), 0.0, 1.0);
    findUnseen(unseenTag);
    if (m_renderer) return "";
    std::string what = m_makeRenderer(m_shown, m_renderer);
    if (!what.empty()) hide();
    return what;
}

/// Who goes back leaves saved games on the way, from which the next such way is shorter.
bool Replay::seek(size_t place) {
    const bool isBack = place < m_place;
    if (isBack) {
        const auto& [step, start] = *std::prev(m_starts.lower_bound(place));
        if (m_api.load_game_data(m_shown, start.data(), start.size()) != RUBBLE_OK) return false;
        m_place = step;
    }
    m_isCut |= isBack || place > m_place + size_t(kStepsOfSecond) / 4;
    for (; m_place < place; ++m_place) {
        const Step& step = m_steps[m_place];
        if (isBack && step.isFirst && !m_starts.contains(m_place) && !saveInto(m_starts[m_place], m_shown))
            return false;
        if (m_api.apply_deltas(m_shown, step.delta.data(), step.delta.size()) != RUBBLE_OK) return false;
        throwParticles(step);
    }
    return true;
}

/// Those of scripts as they were; flames and smoke over what burned, as no delta has heat.
void Replay::throwParticles(const Step& step) {
    for (const rubble_particle_burst& burst : step.bursts) m_api.spawn_particles(m_shown, &burst);
    for (size_t i = 0; i < step.flames.size(); ++i) {
        const Flame& flame = step.flames[i];
        auto burst = sized<rubble_particle_burst>();
        const bool isSmoke = i % 8 == 7;
        burst.kind = isSmoke ? RUBBLE_PARTICLE_SMOKE : RUBBLE_PARTICLE_FLAME;
        for (int axis = 0; axis < 3; ++axis) burst.position[axis] = double(flame.position[size_t(axis)]);
        burst.position[1] += isSmoke ? 0.8 : 0.0;
        burst.radius = 0.8 * double(flame.radius);
        burst.velocity[1] = isSmoke ? 2.4 : 1.0;
        burst.spread = 0.3;
        for (double& each : burst.color) each = isSmoke ? 0.05 : 1.0;
        burst.size = std::clamp(0.8 * double(flame.radius), 0.02, 1.0);
        burst.growth = isSmoke ? 0.5 : 0.0;
        burst.opacity = isSmoke ? 0.5 : 0.5 + 0.5 * double(flame.intensity);
        burst.life = isSmoke ? 5.0 : 0.8;
        m_api.spawn_particles(m_shown, &burst);
    }
}

void Replay::findUnseen(const std::string& tag) {
    m_unseen.clear();
    rubble_body bodies[16] = {};
    uint32_t count = 0;
    if (m_api.find_by_tag(m_shown, RUBBLE_KIND_BODY, tag.c_str(), nullptr, bodies, 16, &count) != RUBBLE_OK) return;
    for (uint32_t i = 0; i < count; ++i) {
        rubble_shape shapes[64] = {};
        uint32_t found = 0;
        if (m_api.get_objects_of(m_shown, bodies[i], RUBBLE_KIND_SHAPE, shapes, 64, &found) != RUBBLE_OK) continue;
        m_unseen.insert(m_unseen.end(), shapes, shapes + found);
    }
}

void Replay::complete(rubble_view& view) {
    view.alpha = m_alpha;
    if (std::exchange(m_isCut, false)) view.flags |= RUBBLE_VIEW_CUT;
    view.hidden_shapes = m_unseen.data();
    view.hidden_shape_count = uint32_t(m_unseen.size());
}

bool Replay::endUnwanted() {
    if (std::exchange(m_isWanted, false) || !m_shown) return false;
    hide();
    return true;
}

void Replay::hide() {
    if (m_renderer) m_api.destroy_renderer(std::exchange(m_renderer, 0));
    if (m_shown) m_api.destroy_world(std::exchange(m_shown, 0));
    m_starts = {};
    m_unseen = {};
    m_isCut = true;
}

}  // namespace sandbox
