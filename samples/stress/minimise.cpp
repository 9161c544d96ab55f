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
        m_settings.heldBytes = {};
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

    /// Commands without some of them and without those that need them.
    static std::vector<Command> without(const std::vector<Command>& commands, size_t from, size_t to) {
        std::vector<bool> isKept(commands.size(), true);
        std::fill(isKept.begin() + std::ptrdiff_t(from), isKept.begin() + std::ptrdiff_t(to), false);
        return keep(commands, std::move(isKept));
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
            m_failure.message = withoutPlace(result.failure->message);
        }
        return isSame;
    }

    /// A message without the place in the script, which is another one in each of the scripts that are tried.
    std::string withoutPlace(const std::string& message) const {
        const std::string place = m_settings.name + ".lua:";
        const size_t end = message.starts_with(place) ? message.find(": ", place.size()) : message.npos;
        return end == message.npos ? message : message.substr(end + 2);
    }

    /// Of a call that was refused its function and why, without the place in the script and without numbers, which
    /// other commands change; of other failures "", as what they say is all numbers.
    std::string reasonOf(const Failure& failure) const {
        if (failure.check != "script" && failure.check != "interface") return "";
        std::string reason;
        for (const char each : withoutPlace(failure.message)) {
            const bool isDigit = std::isdigit(static_cast<unsigned char>(each));
            if (!isDigit || !reason.ends_with('0')) reason += isDigit ? '0' : each;
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
