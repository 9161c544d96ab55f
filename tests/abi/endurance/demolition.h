#pragma once
#include <array>

#include "tests/abi/endurance/library.h"

namespace rubble {

/// A place where towers are built, broken and thrown off the level's edge, one after the other, for as long as it is
/// stepped.
class Demolition {
public:
    /// flags: RUBBLE_WORLD_... of its world.
    Demolition(const Library& api, uint32_t flags);
    ~Demolition();
    Demolition(const Demolition&) = delete;
    Demolition& operator=(const Demolition&) = delete;
    /// One step: of each tower's 120 the first builds it, the tenth breaks it, all up to the last throw pieces out.
    void step();
    /// How many bodies there are.
    uint32_t bodies() const;

private:
    rubble_body addBlock(std::array<double, 2> corner, int32_t width, int32_t height, uint32_t entry);
    void build();
    void explode();
    void throwPieces();
    void clear();

    const Library& m_api;
    rubble_world m_world = 0;
    rubble_body m_tower = 0;
    int m_step = 0;
};

}  // namespace rubble
