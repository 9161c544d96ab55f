#pragma once
#include <array>
#include <cstdint>
#include <cstring>

namespace rubble {

/// Four floats that are worked on at once, and four truths (-1 or 0).
using Four = float __attribute__((vector_size(16)));
using FourBools = int __attribute__((vector_size(16)));

inline Four load(const float* from) {
    Four four;
    std::memcpy(&four, from, sizeof four);
    return four;
}
inline Four four(float value) {
    return Four{value, value, value, value};
}
inline Four smaller(Four a, Four b) {
    return a < b ? a : b;
}
inline Four larger(Four a, Four b) {
    return a > b ? a : b;
}
inline bool any(FourBools bools) {
    std::array<uint64_t, 2> words;
    std::memcpy(words.data(), &bools, sizeof bools);
    return (words[0] | words[1]) != 0;
}

}  // namespace rubble
