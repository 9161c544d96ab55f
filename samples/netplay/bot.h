#pragma once
#include <random>

#include "samples/netplay/client.h"

namespace netplay {

/// Plays in the yard by itself: flies around its houses and breaks them, the same for the same seed.
class Bot {
public:
    /// rows: as in buildYard(). stepsBetweenAsks: so often it uses a tool.
    Bot(uint32_t seed, int rows, int stepsBetweenAsks)
        : m_random(seed), m_rows(rows), m_stepsBetweenAsks(stepsBetweenAsks) {}
    /// To be called before each tick of the client that it plays with.
    void act(Client& client);
    /// What it has aimed at last, metres.
    const Vec3& target() const { return m_target; }

private:
    double between(double low, double high);

    std::mt19937 m_random;
    int m_rows, m_stepsBetweenAsks;
    int m_steps = 0;
    Vec3 m_target{0.0, 3.0, 0.0};
};

}  // namespace netplay
