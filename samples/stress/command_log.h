#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

#include "runtime/script/binding/script_context.h"

namespace stress {

/// A call with an effect, or one that has found what another one names.
struct Command {
    int step;                    ///< steps that were done before it
    std::string text;            ///< Lua; what another command has given stands as "@number@"
    std::vector<size_t> needed;  ///< those commands
    bool hasEffect = true;
    bool waits = false;  ///< for the step
};

/// Some of the commands, without those that need one that is not kept, or have no effect and are not needed.
std::vector<Command> keep(const std::vector<Command>& commands, std::vector<bool> isKept);

/// Writes down what scripts do, so that a text of these calls alone does the same.
class CommandLog final : public rubble::script::CallObserver {
public:
    void begin(lua_State* L, const rubble::script::ScriptFunction& function) override;
    void wait(lua_State* L, const rubble::script::ScriptFunction& function) override;
    void end(lua_State* L, const rubble::script::ScriptFunction& function, int results) override;

    /// The run has failed, with this message: what is called after that is not written down.
    void close(const std::string& message);

    /// All of them in their order: the log is empty afterwards.
    std::vector<Command> take();

    /// Bytes of the heap that it holds.
    uint64_t bytes() const;

private:
    static constexpr uint32_t kNone = UINT32_MAX;
    /// What stands before the text of a command in m_bytes.
    struct Head {
        int32_t step;
        uint32_t length;
        bool hasEffect, waits, isCaught;
    };
    /// A call that has begun.
    struct Call {
        const rubble::script::ScriptFunction* function = nullptr;
        std::string text;
        uint32_t command = kNone;  ///< its number, if it has an effect
        size_t at = 0;             ///< of its head
    };
    /// What gives a handle.
    struct Origin {
        uint32_t command;
        int32_t place;  ///< in the list that it gives, from 1 on; or one of these
        enum { Itself = 0, BodyOfIt = -1 };
    };

    std::string valueText(lua_State* L, int index, int depth);
    std::string tableText(lua_State* L, int index, int depth);

    /// Adds a command; gives where its head is.
    size_t add(lua_State* L, const std::string& text, bool hasEffect);
    Head headAt(size_t at) const;
    void setHead(size_t at, const Head& head);

    /// What gives a handle: for one that no call has given, as of an event, a list of all objects of its kind does.
    std::string expressionOf(lua_State* L, uint64_t handle);

    /// Names the handles at an index of the stack, one or a list, which a command gives. True: one was not known.
    bool name(lua_State* L, int index, uint32_t command);

    /// A command that has begun and not ended was refused. As the script goes on, it has caught the error.
    void catchOpenCall();

    std::string m_bytes;  ///< heads and texts, one behind the other: a run may have hundreds of thousands
    uint32_t m_count = 0;
    std::unordered_map<uint64_t, Origin> m_origins;  ///< by handle
    Call m_call;                                     ///< that is running
    std::map<lua_State*, Call> m_waiting;            ///< by the thread that waits in it
    bool m_isOpen = false;                           ///< the call has an effect, has begun and not ended
    bool m_isClosed = false;                         ///< the run has failed
};

/// A script that gives these commands, each at its step.
std::string scriptOf(const std::vector<Command>& commands);

}  // namespace stress
