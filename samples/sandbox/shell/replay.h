#pragma once
#include <rubble/rubble.h>

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace sandbox {

/// The last seconds of the game. A second world follows the game that long behind it, by the deltas of its steps. What
/// is shown is a third one, which begins as the second one is and goes on to any step. The game's own world is only
/// read, but for the saved game with which keeping begins.
class Replay {
public:
    /// Makes a renderer of a world; what is wrong, or "".
    using RendererMaker = std::function<std::string(rubble_world world, rubble_renderer& renderer)>;

    /// `worldFlags`: of the world that is shown.
    Replay(const rubble_api& api, uint32_t worldFlags, RendererMaker makeRenderer);
    ~Replay();
    Replay(const Replay&) = delete;
    Replay& operator=(const Replay&) = delete;

    /// How many seconds are kept, 0 to 300; 0: none, which costs nothing.
    void keep(double seconds);
    /// Before each step of the game: begins to keep, if that is due. What is wrong, or "".
    std::string beforeStep(rubble_world game);
    /// After it: takes what it has changed, and shows nothing more. What is wrong, or ""; then nothing is kept until
    /// keep() or forget().
    std::string afterStep(rubble_world game);
    /// Forgets all, as the game has become another one, and begins again with the next step.
    void forget();
    /// The functions of the interface for scripts: particles, which no delta has, are noted as well. [one replay at a
    /// time]
    rubble_api notingApi();

    /// How many seconds there are.
    double length() const;
    /// Bytes of what is kept of the steps: 64 MiB at most, beside the second world.
    size_t bytes() const { return m_bytes; }
    /// Shows what was there so many seconds ago, without bodies of a tag. What is wrong, or "".
    std::string show(double ago, const std::string& unseenTag);
    /// Once a frame: ends that where nobody has called show() since the last time. Whether it did.
    bool endUnwanted();
    /// Ends that, and frees what it took.
    void hide();

    /// The renderer of what is shown; 0: nothing is.
    rubble_renderer renderer() const { return m_renderer; }
    /// Its world; 0: nothing is.
    rubble_world world() const { return m_shown; }
    /// Completes a view of it.
    void complete(rubble_view& view);

private:
    /// A place that burns.
    struct Flame {
        std::array<float, 3> position;
        float radius, intensity;
    };
    struct Step {
        bool isFirst;  ///< of a keep_deltas(): a world that is loaded from a saved game may begin with it
        std::vector<uint8_t> delta;
        std::vector<rubble_particle_burst> bursts;
        std::vector<Flame> flames;
        /// That it takes.
        size_t bytes() const;
    };
    bool begin(rubble_world game);
    bool add(rubble_world game);
    bool dropFirst();
    std::vector<Flame> flamesOf(rubble_world game);
    bool open();
    bool seek(size_t place);
    void throwParticles(const Step& step);
    void findUnseen(const std::string& tag);
    std::string stop();
    bool saveInto(std::vector<uint8_t>& game, rubble_world world) const;

    const rubble_api& m_api;
    uint32_t m_worldFlags;
    RendererMaker m_makeRenderer;
    std::deque<Step> m_steps;
    std::vector<uint8_t> m_taken;                 ///< room for the deltas of a step
    std::vector<rubble_particle_burst> m_bursts;  ///< since the last step
    size_t m_most = 0, m_bytes = 0;               ///< steps that are kept at most; of all steps
    size_t m_turn = 0;                            ///< of the fires
    size_t m_sinceFirst = 0;                      ///< steps since that of the last keep_deltas()
    rubble_world m_game = 0, m_behind = 0;        ///< that is kept, and what follows it
    bool m_isDue = false;

    rubble_world m_shown = 0;
    rubble_renderer m_renderer = 0;
    std::map<size_t, std::vector<uint8_t>> m_starts;  ///< saved games with which it may begin, by steps
    size_t m_place = 0;                               ///< steps that it has carried out
    double m_alpha = 1.0;
    bool m_isCut = true, m_isWanted = false;
    std::vector<rubble_shape> m_unseen;
};

}  // namespace sandbox
