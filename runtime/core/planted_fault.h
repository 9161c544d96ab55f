#pragma once
#ifdef RUBBLE_PLANTS_FAULTS
#include <cstdlib>
#include <cstring>
#endif

namespace rubble {

#ifdef RUBBLE_PLANTS_FAULTS
/// Whether a fault is planted. Tests of the stress scenarios build a library in which the environment's
/// RUBBLE_PLANTED_FAULT names one, and see whether it is found. In all other builds this is false, and costs nothing.
static inline bool isPlanted(const char* fault) {
    static const char* const planted = std::getenv("RUBBLE_PLANTED_FAULT");
    return planted && !std::strcmp(planted, fault);
}
#else
/// Whether a fault is planted. Tests of the stress scenarios build a library in which the environment's
/// RUBBLE_PLANTED_FAULT names one, and see whether it is found. In all other builds this is false, and costs nothing.
constexpr bool isPlanted(const char*) {
    return false;
}
#endif

}  // namespace rubble
