#include <fmt/format.h>

#include <array>
#include <map>

#include "samples/stress/checks/check.h"

namespace stress {
namespace {

using rubble::script::sized;

using Key = std::array<int32_t, 3>;
using Bricks = std::map<Key, rubble_shadow_brick>;

/// Brings a copy of the shadow volume up to date.
rubble_result update(const rubble_api& api, rubble_world world, uint64_t& version, Bricks& bricks) {
    std::vector<rubble_shadow_brick> changed(64);
    uint32_t count = 0;
    uint64_t next = 0;
    rubble_result result =
        api.get_shadow_bricks(world, version, &next, changed.data(), uint32_t(changed.size()), &count);
    if (result == RUBBLE_ERROR_CAPACITY) {
        changed.resize(count);
        result = api.get_shadow_bricks(world, version, &next, changed.data(), count, &count);
    }
    if (result != RUBBLE_OK) return result;
    version = next;
    for (uint32_t i = 0; i < count; ++i) {
        const Key key{changed[i].x, changed[i].y, changed[i].z};
        if (changed[i].is_empty)
            bricks.erase(key);
        else
            bricks[key] = changed[i];
    }
    return result;
}

class ShadowCheck final : public Check {
public:
    const char* name() const override { return "shadow"; }
    void restart() override { m_version = 0, m_bricks.clear(); }

    std::string atBorder(const StepView&) override {
        m_rebuilt.clear();
        return {};
    }

    std::string afterStep(const StepView& view) override {
        rubble_result result = update(view.api, view.world, m_version, m_bricks);
        if (result == RUBBLE_ERROR_STALE) {
            restart();
            result = update(view.api, view.world, m_version, m_bricks);
        }
        return result == RUBBLE_OK ? "" : view.api.get_last_error();
    }

    /// The copy builds its shadow volume in each step. The one of the world is that of this step, or of one of the
    /// steps before it if a thread makes it: it is compared where the copy has done them all.
    std::string besideCopy(const StepView& view, rubble_world copy) override {
        uint64_t version = 0;
        if (update(view.api, copy, version, m_rebuilt.emplace_back()) != RUBBLE_OK) return view.api.get_last_error();
        auto stats = sized<rubble_step_stats>();
        view.api.get_step_stats(view.world, &stats);
        if (stats.shadow_lag >= m_rebuilt.size()) return {};
        std::string wrong;
        for (size_t lag = 0; lag <= stats.shadow_lag; ++lag)
            if (wrong = compare(m_rebuilt[m_rebuilt.size() - 1 - lag]); wrong.empty()) return {};
        return wrong;
    }

private:
    std::string compare(const Bricks& rebuilt) const {
        for (const auto& [key, brick] : rebuilt) {
            const auto mine = m_bricks.find(key);
            if (mine == m_bricks.end()) return fmt::format("brick ({}, {}, {}) is missing", key[0], key[1], key[2]);
            for (size_t word = 0; word < 64; ++word)
                if (brick.occupied >> word & 1 && brick.texels[word] != mine->second.texels[word])
                    return fmt::format("brick ({}, {}, {}) has other cells than a rebuilt one", key[0], key[1], key[2]);
            if (brick.occupied != mine->second.occupied)
                return fmt::format("brick ({}, {}, {}) has cells that a rebuilt one has not", key[0], key[1], key[2]);
        }
        if (m_bricks.size() == rebuilt.size()) return {};
        return fmt::format("{} bricks have cells, rebuilt {}", m_bricks.size(), rebuilt.size());
    }

    uint64_t m_version = 0;
    Bricks m_bricks;                ///< as the changes of all steps have made them
    std::vector<Bricks> m_rebuilt;  ///< those of the copy after each of its steps
};

}  // namespace

std::unique_ptr<Check> makeShadowCheck() {
    return std::make_unique<ShadowCheck>();
}

}  // namespace stress
