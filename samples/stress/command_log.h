#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "runtime/script/binding/script_context.h"

namespace stress {

/// A call with an effect.
struct Command {
    int step;                    ///< steps that were done before it
    std::string text;            ///< Lua; what another command has made stands as "@number@"
    std::vector<size_t> needed;  ///< those commands
};

/// Writes down what scripts do, so that a text of these calls alone does the same.
class CommandLog final : public rubble::script::CallObserver {
public:
    void begin(lua_State* L, const rubble::script::ScriptFunction& function) override;
    void end(lua_State* L, const rubble::script::ScriptFunction& function, int results) override;

    /// The run has failed, with this message: what is called after that is not written down.
    void close(const std::string& message);

    /// All of them in their order: the log is empty afterwards.
    std::vector<Command> take();

private:
    std::string valueText(lua_State* L, int index, int depth, std::vector<size_t>& needed) const;
    std::string tableText(lua_State* L, int index, int depth, std::vector<size_t>& needed) const;
    void name(lua_State* L, int index, const std::string& expression);

    /// A command that has begun and not ended was refused. As the script goes on, it has caught the error.
    void catchOpenCall();

    std::vector<Command> m_commands;
    std::map<uint64_t, std::string> m_expressions;  ///< what gives a handle
    std::string m_call;                             ///< that is running, as a text
    bool m_isCommand = false;
    bool m_isOpen = false;    ///< the last command has begun and not ended
    bool m_isClosed = false;  ///< the run has failed
};

/// A script that gives these commands, each at its step.
std::string scriptOf(const std::vector<Command>& commands);

}  // namespace stress
