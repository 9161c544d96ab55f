#pragma once
#include <rubble/rubble.h>

#include <array>
#include <optional>
#include <vector>

#include "samples/sandbox/sound/mixer.h"
#include "samples/sandbox/sound/strike.h"

namespace sandbox::sound {

/// What a world sounds like: its reports as strikes, its fires as loops.
class WorldSounds {
public:
    /// The world must outlive it.
    WorldSounds(const rubble_api& api, rubble_world world) : m_api(api), m_world(world) {}
    /// What the world has to report for that.
    static rubble_report_filter filter();
    /// Adds what the last step sounds like.
    void read(std::vector<Strike>& strikes);
    /// Adds what burns, in at most four places.
    void readFires(glm::dvec3 ear, std::vector<Loop>& loops);

private:
    struct Side {
        size_t material;
        std::array<double, 3> size;
    };
    void readContacts(const rubble_reports& reports, std::vector<Strike>& strikes);
    void readBreaks(const rubble_reports& reports, std::vector<Strike>& strikes);
    void readOthers(const rubble_reports& reports, std::vector<Strike>& strikes);
    size_t materialOf(uint32_t index);
    Side sideOf(const rubble_contact& contact, int i);

    const rubble_api& m_api;
    rubble_world m_world;
    std::vector<std::optional<size_t>> m_materials;  ///< acoustic rows by the world's
    Random m_random{3};
    std::vector<rubble_fire> m_fires;
    std::vector<Loop> m_burning;
    int m_untilFires = 0;  ///< steps until fires are read again
};

}  // namespace sandbox::sound
