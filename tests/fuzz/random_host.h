#pragma once
#include <rubble/rubble.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "tests/fuzz/random_world.h"
#include "tests/fuzz/stages.h"
#include "tests/fuzz/world_model.h"

namespace rubble {

/// The world whose calls are being made by this thread; 0: others may be in a call too.
extern thread_local rubble_world worldInCall;

/// The function table, with a host whose log callback calls back.
const rubble_api& api();

/// A host that calls at random.
class RandomHost {
public:
    /// Makes its choices by `decisions`, which must outlive it.
    explicit RandomHost(Decisions& decisions) : m_decisions(decisions), m_wildness(1u << (1 + decisions.below(6))) {}
    ~RandomHost() {
        worldInCall = 0;
        api().destroy_world(m_world);
        api().destroy_world(m_other);
    }

    /// One input.
    void run();

private:
    double number(double usual) {
        return m_decisions.oneIn(m_wildness * 4) ? m_decisions.wild() : usual * m_decisions.unit();
    }
    uint32_t whole(uint32_t bound) {
        return m_decisions.oneIn(m_wildness * 4) ? uint32_t(m_decisions.bits()) : m_decisions.below(bound);
    }
    template <size_t kCount>
    void fill(double (&out)[kCount], double usual) {
        for (double& each : out) each = number(usual);
    }
    void place(double (&out)[3]) {
        const glm::dvec3 at = m_decisions.place();
        for (int i = 0; i < 3; ++i) out[i] = at[i];
    }
    void rotation(double (&out)[4]) {
        if (m_decisions.oneIn(4)) fill(out, 1.0);
    }
    /// A struct of a host that may know more fields than the plugin.
    template <class T>
    struct Newer : T {
        unsigned char more[256] = {};
    };
    template <class T>
    Newer<T> sized() {
        Newer<T> out;
        static_cast<T&>(out) = {};
        out.struct_size = uint32_t(sizeof(T));
        if (!m_decisions.oneIn(m_wildness * 16)) return out;
        out.struct_size = m_decisions.oneIn(2) ? whole(sizeof out) : 8192 + whole(8192);
        if (out.struct_size > sizeof out && out.struct_size <= 4096) out.struct_size = sizeof(T);
        if (m_decisions.oneIn(2)) out.more[m_decisions.below(sizeof out.more)] = 1;
        return out;
    }
    /// A handle of a list, now and then one that is stale or of another kind.
    uint64_t any(const std::vector<uint64_t>& handles) {
        if (handles.empty() || m_decisions.oneIn(m_wildness * 4)) {
            if (!m_foreign.empty() && m_decisions.oneIn(2))
                return m_foreign[m_decisions.below(uint32_t(m_foreign.size()))];
            return m_decisions.oneIn(2) ? 0 : m_decisions.bits();
        }
        const uint64_t handle = handles[m_decisions.below(uint32_t(handles.size()))];
        if (m_decisions.oneIn(8)) m_old = handle;
        return m_decisions.oneIn(m_wildness * 4) ? m_old : handle;
    }
    template <class List>
    std::vector<uint64_t> list(List function, rubble_world world = 0) {
        std::vector<uint64_t> out(256);
        uint32_t count = 0;
        function(world ? world : m_world, out.data(), uint32_t(out.size()), &count);
        out.resize(std::min<size_t>(count, out.size()));
        return out;
    }
    std::vector<uint64_t> bodies() {
        std::vector<rubble_body_state> states(256);
        uint32_t count = 0;
        api().get_body_states(m_world, states.data(), uint32_t(states.size()), &count);
        std::vector<uint64_t> out;
        for (uint32_t i = 0; i < std::min(count, 256u); ++i) out.push_back(states[i].body);
        return out;
    }
    std::vector<rubble_shape_state> shapeStates(rubble_world world) {
        std::vector<rubble_shape_state> states(256);
        uint32_t count = 0;
        api().get_shape_states(world, 0, states.data(), uint32_t(states.size()), &count);
        states.resize(std::min<size_t>(count, states.size()));
        return states;
    }
    std::vector<uint64_t> shapes() {
        std::vector<uint64_t> out;
        for (const rubble_shape_state& each : shapeStates(m_world)) out.push_back(each.shape);
        return out;
    }
    std::vector<uint64_t> joints() {
        std::vector<rubble_joint_state> states(256);
        uint32_t count = 0;
        api().get_joint_states(m_world, states.data(), uint32_t(states.size()), &count);
        std::vector<uint64_t> out;
        for (uint32_t i = 0; i < std::min(count, 256u); ++i) out.push_back(states[i].joint);
        return out;
    }
    std::vector<uint64_t> characters() {
        std::vector<rubble_character_state> states(64);
        uint32_t count = 0;
        api().get_character_states(m_world, states.data(), uint32_t(states.size()), &count);
        std::vector<uint64_t> out;
        for (uint32_t i = 0; i < std::min(count, 64u); ++i) out.push_back(states[i].character);
        return out;
    }

    void call();
    /// Bodies, shapes, voxels and fires as a whole.
    void callWhole();
    void callVoxels();
    void callFire();
    void callRows();
    /// Makes things, and edits them before they are there.
    void callCreate();
    void callEdit();
    void callJoint();
    void callRegion();
    void callCharacter();
    void callLight();
    void callQuery();
    void callState();
    void callObjects();
    void callPalette();
    void callMaterials();
    void callProperties();
    /// What only those get who ask.
    void callReports();
    /// Copies of bricks.
    void callBricks();
    void callParticles();
    void callUndo();
    /// What a host with physics of its own reads, and what it says in a world that it moves.
    void callHostPhysics();
    void callFile();
    void saveAndLoad();
    /// The world as a saved game in memory.
    std::vector<uint8_t> saved();
    /// A file with the level of the input.
    std::string levelPath() const;
    void loadData();
    /// Another world follows this one by deltas, some of which have other bytes.
    void followByDeltas();
    rubble_world makeWorld();
    void load(rubble_world world);
    /// Few pieces: a step is cheap, and an input has time for more calls.
    void limitDebris();
    void startRecording();
    /// A recording of all calls, played in another world, with threads or without, gives the same world.
    void playInOther();
    /// Another thread reads while this one calls: both are answered or refused as busy.
    void readInAnotherThread();
    [[noreturn]] void fail(const char* what) {
        std::fprintf(stderr, "%s: %s\n", what, api().get_last_error());
        std::abort();
    }

    Decisions& m_decisions;
    uint32_t m_wildness;
    uint64_t m_old = 0, m_brickVersion = 0, m_shadowVersion = 0;
    rubble_world m_world = 0, m_other = 0;  ///< the other: of the same level, or 0
    std::vector<uint64_t> m_foreign;        ///< handles of the other
    std::vector<uint8_t> m_level;           ///< of the input, as a file
    std::optional<WorldModel> m_model;
    bool m_isObserved = false;                       ///< each call is followed by a hash
    bool m_isHostMoved = false;                      ///< both worlds have no physics of their own
    bool m_isRecorded = false, m_hasLoaded = false;  ///< since the last call: loaded, saved, recorded or moved
    bool m_undoWaits = false;                        ///< for the next step: nothing can be saved before it
};

}  // namespace rubble
