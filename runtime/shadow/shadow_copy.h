#pragma once
#include <map>
#include <span>
#include <vector>

#include "runtime/core/change_log.h"
#include "runtime/shadow/shadow_volume.h"
#include "runtime/voxel/brick_place.h"

namespace rubble {

/// The shadow volume as the worker has published it, by reference, and which of its bricks changed since a version: for
/// hosts that keep a copy of their own. [main-thread]
class ShadowCopy {
public:
    /// Takes over publications, oldest first.
    void follow(std::span<const ShadowPatches> publications);
    /// The version of now, at least 1.
    uint64_t version() const { return m_version; }
    /// The bricks that changed after a version, ordered; after version 0 all that hold cells. Null if everything was
    /// replaced since, or the version is not yet: ask for 0. Valid until the next question.
    const std::vector<BrickPlace>* changed(uint64_t since);
    /// A brick; null: it holds no cells.
    const ShadowBrick* find(const BrickPlace& place) const;

private:
    uint64_t m_version = 1, m_first = 1;  ///< of now; the oldest that is known
    std::map<BrickPlace, ShadowBrickRef> m_bricks;
    ChangeLog<BrickPlace> m_changes;
    std::vector<BrickPlace> m_found;
};

}  // namespace rubble
