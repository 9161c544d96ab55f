#include "samples/stress/minimise.h"

#include <fmt/format.h>

#include <algorithm>
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
        m_isInterrupted = std::exchange(m_settings.isInterrupted, {});  // a run that has begun ends by itself
        m_settings.images = 0;
        m_settings.replayEvery = failure.check == "replay";
    }

    Minimised run(std::vector<Command> commands) {
        // What fails at a border fails at the end of a shorter run too.
        m_settings.steps = m_failure.step + 1;
        if (!fails(commands)) return {"", m_failure, m_runs};
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
        return {scriptOf(commands), m_failure, m_runs};
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

    /// Writes numbers with two digits after the point where that fails as well.
    void roundNumbers(std::vector<Command>& commands) {
        for (Command& command : commands) {
            std::string text;
            for (size_t at = 0; at < command.text.size();) {
                const size_t point = command.text.find('.', at);
                text += command.text.substr(at, point == std::string::npos ? point : point - at);
                if (point == std::string::npos) break;
                const size_t end =
                    std::min(command.text.find_first_not_of("0123456789", point + 1), command.text.size());
                text += command.text.substr(point, std::min<size_t>(end - point, 3));
                at = end;
            }
            std::swap(command.text, text);
            if (command.text != text && !fails(commands)) command.text = text;
        }
    }

    bool fails(const std::vector<Command>& commands) {
        ++m_runs;
        m_settings.script = scriptOf(commands);
        const RunResult result = play(m_api, m_settings);
        const bool isSame = result.failure && result.failure->check == m_failure.check;
        if (isSame && result.failure->step <= m_settings.steps) {
            m_settings.steps = result.failure->step + 1;
            m_failure.message = result.failure->message;
        }
        return isSame;
    }

    const rubble_api& m_api;
    RunSettings m_settings;
    Failure m_failure;
    std::function<bool()> m_isInterrupted;
    int m_maxRuns, m_runs = 0;
};

}  // namespace

Minimised minimise(const rubble_api& api, const RunSettings& settings, const Failure& failure,
                   const std::vector<Command>& commands, int maxRuns) {
    return Minimiser(api, settings, failure, maxRuns).run(commands);
}

}  // namespace stress
