#include "tests/abi/endurance/demolition.h"

#include <algorithm>
#include <vector>

namespace rubble {
namespace {

constexpr int kTowerSteps = 120;  ///< from one tower to the next
constexpr double kEdge = 6.0;     ///< metres from the middle to where the world ends
constexpr double kThrow = 12.0;   ///< m/s

}  // namespace

Demolition::Demolition(const Library& api, uint32_t flags) : m_api(api) {
    auto settings = sized<rubble_world_settings>();
    settings.flags = flags;
    require(api, api->create_world(&settings, &m_world));
    auto bounds = sized<rubble_bounds>();
    bounds.rule = RUBBLE_BOUNDS_DUST;
    std::fill_n(bounds.low, 3, -kEdge), std::fill_n(bounds.high, 3, kEdge);
    require(api, api->set_bounds(m_world, &bounds));
    addBlock({-4.0, -0.2}, 80, 2, 4);  // rock
}

Demolition::~Demolition() {
    m_api->destroy_world(m_world);
}

void Demolition::step() {
    const int of = m_step++ % kTowerSteps;
    if (of == 0) build();
    if (of == 10) explode();
    if (of > 20) throwPieces();
    if (of == kTowerSteps - 1) clear();
    require(m_api, m_api->step(m_world));
}

uint32_t Demolition::bodies() const {
    uint32_t count = 0;
    require(m_api, m_api->get_body_states(m_world, nullptr, 0, &count));
    return count;
}

/// A static block of width x height x width voxels. corner: x and z, and y, metres; entry: of the palette.
rubble_body Demolition::addBlock(std::array<double, 2> corner, int32_t width, int32_t height, uint32_t entry) {
    auto frame = sized<rubble_body_settings>();
    frame.flags = RUBBLE_BODY_STATIC, frame.position[0] = frame.position[2] = corner[0], frame.position[1] = corner[1];
    rubble_body block = 0;
    require(m_api, m_api->create_body(m_world, &frame, &block));
    auto shape = sized<rubble_shape_settings>();
    shape.source = RUBBLE_SHAPE_BOX, shape.body = block, shape.index = entry;
    shape.size[0] = shape.size[2] = width, shape.size[1] = height;
    rubble_shape made = 0;
    require(m_api, m_api->create_shape(m_world, &shape, &made));
    return block;
}

void Demolition::build() {
    m_tower = addBlock({0.0, 0.0}, 10, 40, 6);  // concrete
}

void Demolition::clear() {
    rubble_body_state state = {};
    if (m_api->get_body_state(m_world, m_tower, &state) == RUBBLE_OK)  // else all of it is gone
        require(m_api, m_api->destroy_body(m_world, m_tower));
}

void Demolition::explode() {
    auto explosion = sized<rubble_explosion>();
    std::fill_n(explosion.position, 3, 0.5);
    for (explosion.position[1] = 0.3; explosion.position[1] < 4.0; explosion.position[1] += 0.9)
        require(m_api, m_api->explode(m_world, &explosion));
}

void Demolition::throwPieces() {
    uint32_t count = 0;
    std::vector<rubble_body_state> states(bodies());
    require(m_api, m_api->get_body_states(m_world, states.data(), uint32_t(states.size()), &count));
    for (const rubble_body_state& state : states) {
        if (state.flags & RUBBLE_BODY_STATIC) continue;
        auto change = sized<rubble_body_change>();
        change.fields = RUBBLE_SET_VELOCITY, change.body = state.body;
        change.velocity[0] = state.position[0] < 0.5 ? -kThrow : kThrow, change.velocity[1] = 3.0;
        require(m_api, m_api->set_body(m_world, &change));
    }
}

}  // namespace rubble
