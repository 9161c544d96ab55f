#include "samples/stress/minimise.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <utility>

namespace stress {
namespace {

/// Commands of a script that a person reads.
constexpr size_t kReadable = 40;

class Minimiser {
public:
    Minimiser(const rubble_api& api, const RunSettings& settings, const Failure& failure, int maxRuns)
        : m_api(api), m_settings(settings), m_failure(failure), m_maxRuns(maxRuns) {
        m_settings.observer = nullptr;
        m_settings.onStep = {};
        m_settings.onFailure = {};
        m_settings.isQuiet = true;
        m_isInterrupted = std::exchange(m_settings.isInterrupted, {});  // a run that has begun ends by itself
        m_settings.images = 0;
        m_settings.replayEvery = failure.check == "replay";
    }

    Minimised run(std::vector<Command> commands) {
        // What fails at a border fails at the end of a shorter run too.
        m_settings.steps = m_failure.step + 1;
        if (!fails(commands)) return {"", whyNot(), 0, m_failure, m_runs};
        for (size_t parts = 2; commands.size() > 1 && goesOn();) {
            if (leaveOut(commands, parts))
                parts = std::max<size_t>(2, parts - 1);
            else if (parts >= commands.size())
                break;
            else
                parts = std::min(commands.size(), 2 * parts);
        }
        if (commands.size() <= kReadable && goesOn()) roundNumbers(commands);
        fails(commands);
        return {scriptOf(commands), "", m_settings.steps, m_failure, m_runs};
    }

private:
    bool goesOn() const { return m_runs < m_maxRuns && !(m_isInterrupted && m_isInterrupted()); }

    /// Tries to do without each of so many parts of equal length; the first that is not needed goes.
    bool leaveOut(std::vector<Command>& commands, size_t parts) {
        const size_t count = commands.size();
        // From the end: what came last is needed least by what stays.
        for (size_t part = parts; part-- > 0 && goesOn();) {
            const std::vector<Command> fewer = without(commands, part * count / parts, (part + 1) * count / parts);
            if (fewer.size() < count && fails(fewer)) return commands = fewer, true;
        }
        return false;
    }

    /// Commands without some of them and without those that need them, which are renumbered.
    static std::vector<Command> without(const std::vector<Command>& commands, size_t from, size_t to) {
        std::vector<Command> kept;
        std::vector<size_t> number(commands.size(), SIZE_MAX);
        for (size_t i = 0; i < commands.size(); ++i) {
            const auto isGone = [&](size_t needed) { return number[needed] == SIZE_MAX; };
            if ((i >= from && i < to) || std::any_of(commands[i].needed.begin(), commands[i].needed.end(), isGone))
                continue;
            number[i] = kept.size();
            kept.push_back(renumbered(commands[i], number));
        }
        return kept;
    }

    static Command renumbered(Command command, const std::vector<size_t>& number) {
        std::string text;
        const std::string& old = command.text;
        for (size_t at = 0; at < old.size();) {
            const size_t begin = old.find('@', at);
            text += old.substr(at, begin == std::string::npos ? begin : begin - at);
            if (begin == std::string::npos) break;
            const size_t end = old.find('@', begin + 1);
            text += fmt::format("@{}@", number[size_t(std::stoul(old.substr(begin + 1, end - begin - 1)))]);
            at = end + 1;
        }
        command.text = std::move(text);
        for (size_t& needed : command.needed) needed = number[needed];
        return command;
    }

    /// Lua with two digits behind the points of numbers. Texts in quotes stay.
    static std::string rounded(const std::string& lua) {
        std::string text;
        bool isQuoted = false;
        int digits = 0;  // of the number, from its point on
        for (size_t at = 0; at < lua.size(); ++at) {
            if (isQuoted && lua[at] == '\\')
                text += lua[at++];
            else if (lua[at] == '"')
                isQuoted = !isQuoted;
            const bool isDigit = std::isdigit(static_cast<unsigned char>(lua[at]));
            digits = isQuoted ? 0 : lua[at] == '.' ? 1 : digits && isDigit ? digits + 1 : 0;
            if (digits <= 3) text += lua[at];
        }
        return text;
    }

    /// Writes numbers with two digits after the point where that fails as well.
    void roundNumbers(std::vector<Command>& commands) {
        for (Command& command : commands) {
            std::string text = rounded(command.text);
            std::swap(command.text, text);
            if (command.text != text && !fails(commands)) command.text = text;
        }
    }

    bool fails(const std::vector<Command>& commands) {
        ++m_runs;
        m_settings.script = scriptOf(commands);
        const RunResult result = play(m_api, m_settings);
        m_found = result.failure;
        const bool isSame = m_found && m_found->check == m_failure.check && reasonOf(*m_found) == reasonOf(m_failure);
        if (isSame && result.failure->step <= m_settings.steps) {
            m_settings.steps = result.failure->step + 1;
            m_failure.message = result.failure->message;
        }
        return isSame;
    }

    /// Of a call that was refused its function and why, without the place in the script and without numbers, which
    /// other commands change; of other failures "", as what they say is all numbers.
    std::string reasonOf(const Failure& failure) const {
        if (failure.check != "script" && failure.check != "interface") return "";
        const std::string place = m_settings.name + ".lua:";
        size_t at = failure.message.starts_with(place) ? failure.message.find(':', place.size()) : 0;
        std::string reason;
        for (at = std::min(at, failure.message.size()); at < failure.message.size(); ++at) {
            const bool isDigit = std::isdigit(static_cast<unsigned char>(failure.message[at]));
            if (!isDigit || !reason.ends_with('0')) reason += isDigit ? '0' : failure.message[at];
        }
        return reason;
    }

    /// Why the commands of the run alone make no short script.
    std::string whyNot() const {
        if (m_failure.check == "expect") return "Expect() is part of the scenario, not of the world";
        if (!m_found) return "the calls with an effect alone do not fail";
        return fmt::format("the calls with an effect alone fail otherwise: {}: {}", m_found->check, m_found->message);
    }

    const rubble_api& m_api;
    RunSettings m_settings;
    Failure m_failure;
    std::optional<Failure> m_found;  ///< of the last run
    std::function<bool()> m_isInterrupted;
    int m_maxRuns, m_runs = 0;
};

}  // namespace

Minimised minimise(const rubble_api& api, const RunSettings& settings, const Failure& failure,
                   const std::vector<Command>& commands, int maxRuns) {
    return Minimiser(api, settings, failure, maxRuns).run(commands);
}

}  // namespace stress
