#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

// Sets of slots as ascending lists: small, and iterated in the same order on every machine.

namespace rubble {

/// Inserts a slot into an ascending list. False if it was in the list already.
inline bool insertSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at != list.end() && *at == slot) return false;
    list.insert(at, slot);
    return true;
}

/// Removes a slot from an ascending list. False if it was not in the list.
inline bool eraseSorted(std::vector<uint32_t>& list, uint32_t slot) {
    const auto at = std::lower_bound(list.begin(), list.end(), slot);
    if (at == list.end() || *at != slot) return false;
    list.erase(at);
    return true;
}

}  // namespace rubble
