#pragma once
#include <cstdint>
#include <vector>

#include "tests/fuzz/decisions.h"

namespace rubble {

/// Changes some bytes: flips, copies, cuts and repeats.
inline void mutateBytes(Decisions& decisions, std::vector<uint8_t>& bytes, size_t from = 0) {
    for (uint32_t i = 1 + decisions.below(8); i-- > 0 && bytes.size() > from;) {
        const size_t at = from + decisions.below(uint32_t(bytes.size() - from));
        const uint32_t kind = decisions.below(16);
        if (kind == 0)
            bytes.resize(at);
        else if (kind == 1)
            bytes.insert(bytes.begin() + ptrdiff_t(at), uint8_t(decisions.below(256)));
        else if (kind < 5)
            bytes[at] = uint8_t(decisions.oneIn(2) ? 0xff : 0);
        else if (kind < 8)
            bytes[at] = uint8_t(bytes[at] + decisions.below(3) - 1);
        else
            bytes[at] = uint8_t(decisions.below(256));
    }
}

}  // namespace rubble
