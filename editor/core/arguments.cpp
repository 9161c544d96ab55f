#include "editor/core/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "editor/core/command.h"

namespace editor {
namespace {

bool isSpace(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n';
}

/// A word of a line, which begins at `at`: up to a space that is in no quotes.
std::string takeWord(std::string_view text, size_t& at) {
    std::string word;
    for (bool isQuoted = false; at < text.size() && (isQuoted || !isSpace(text[at])); ++at) {
        const bool isDouble = isQuoted && text.substr(at, 2) == "\"\"";
        at += isDouble;
        if (text[at] == '"' && !isDouble)
            isQuoted = !isQuoted;
        else
            word += text[at];
        if (isQuoted && at + 1 == text.size()) throw Refused(fmt::format("expected a second '\"' in: {}", text));
    }
    return word;
}

/// In quotes where it would else be taken apart; needs: whether it is for another reason.
std::string quoted(const std::string& value, bool needs) {
    if (!needs && !value.empty() && value.find_first_of(" \t\r\n\"") == value.npos) return value;
    std::string text = "\"";
    for (const char c : value) text += c == '"' ? "\"\"" : std::string(1, c);
    return text + '"';
}

bool isNumber(std::string_view text, double& out) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    return error == std::errc() && end == text.data() + text.size() && std::isfinite(out);
}

/// The parts of a text between its commas.
std::vector<std::string_view> split(std::string_view text, char at) {
    std::vector<std::string_view> parts;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(at, begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return parts;
}

bool isColor(std::string_view text, std::array<double, 3>& out) {
    if (text.size() != 7 || text[0] != '#') return false;
    for (size_t i = 0; i < 3; ++i) {
        unsigned byte = 0;
        const char* begin = text.data() + 1 + 2 * i;
        const auto [end, error] = std::from_chars(begin, begin + 2, byte, 16);
        if (error != std::errc() || end != begin + 2) return false;
        out[i] = byte;
    }
    return true;
}

std::string rangeText(const Parameter& parameter, const char* kind) {
    return fmt::format("{} from {:g} to {:g}", kind, parameter.low, parameter.high);
}

/// What a parameter takes, in words.
std::string expectedText(const Parameter& parameter) {
    switch (parameter.type) {
        case Type::Number:
            return rangeText(parameter, "a number");
        case Type::Whole:
            return rangeText(parameter, "a whole number");
        case Type::Flag:
            return "yes or no";
        case Type::Text:
            return "a text";
        case Type::Choice:
            return fmt::format("one of: {}", parameter.choices);
        case Type::Point:
            return rangeText(parameter, "three numbers x,y,z, each");
        case Type::Cell:
            return rangeText(parameter, "three whole numbers x,y,z, each");
        case Type::Color:
            return "a colour #rrggbb";
        case Type::Pairs:
            return "NAME=VALUE, with spaces between several";
        case Type::Objects:
            return "names, #HANDLE, tag:NAME, selected or all, separated by commas";
    }
    return "";
}

}  // namespace

Line readLine(std::string_view text) {
    Line line;
    for (size_t at = 0; at < text.size();) {
        if (isSpace(text[at])) {
            ++at;
            continue;
        }
        const size_t begin = at;
        const std::string word = takeWord(text, at);
        const size_t equals = text[begin] == '"' ? word.npos : word.find('=');
        const bool isNamed = equals != word.npos && word.rfind("tag:", 0) != 0;
        if (line.command.empty())
            line.command = word;
        else if (isNamed)
            line.given.push_back({word.substr(0, equals), word.substr(equals + 1)});
        else
            line.given.push_back({"", word});
    }
    return line;
}

std::string textOf(const Line& line) {
    std::string text = quoted(line.command, false);
    for (const Given& each : line.given) {
        const bool hasName = !each.name.empty() || each.value.starts_with("tag:");
        text += " " + (each.name.empty() ? "" : each.name + "=");
        text += quoted(each.value, !hasName && each.value.find('=') != each.value.npos);
    }
    return text;
}

Arguments::Arguments(const Command& command, const std::vector<Given>& given)
    : m_command(command), m_values(command.parameters.size()) {
    size_t place = 0;
    for (const Given& each : given) {
        const size_t index = indexOf(each, place);
        const Parameter& parameter = command.parameters[index];
        if (each.name.empty()) place = index + 1;
        if (parameter.type == Type::Pairs) {
            addPairs(index, each);
            continue;
        }
        if (m_values[index]) refuse(parameter.name, fmt::format("one value, found another: '{}'", each.value));
        m_values[index] = read(parameter, each.value);
    }
    for (size_t i = 0; i < m_values.size(); ++i) {
        const Parameter& parameter = command.parameters[i];
        if (m_values[i] || parameter.otherwise == kOptional) continue;
        if (parameter.otherwise == kRequired) refuse(parameter.name, expectedText(parameter) + ", found none");
        m_values[i] = read(parameter, std::string(parameter.otherwise));
    }
}

size_t Arguments::indexOf(const Given& given, size_t place) const {
    if (given.name.empty()) {
        if (place < m_values.size()) return place;
        throw Refused(fmt::format("{}: expected at most {} values, found '{}' beyond them", m_command.name,
                                  m_values.size(), given.value));
    }
    std::string all;
    for (size_t i = 0; i < m_values.size(); ++i) {
        if (m_command.parameters[i].name == given.name) return i;
        if (i + 1 == m_values.size() && pairsIndex() < m_values.size()) return pairsIndex();
        all += fmt::format("{}{}", i ? " " : "", m_command.parameters[i].name);
    }
    throw Refused(fmt::format("{}: expected one of the parameters {}, found '{}'", m_command.name,
                              all.empty() ? "(none)" : all, given.name));
}

/// The parameter of Type::Pairs; past the last one: there is none.
size_t Arguments::pairsIndex() const {
    const auto& all = m_command.parameters;
    return size_t(std::find_if(all.begin(), all.end(), [](auto& each) { return each.type == Type::Pairs; }) -
                  all.begin());
}

/// Adds a pair under its own name, or those of the parameter's value.
void Arguments::addPairs(size_t index, const Given& given) {
    const Parameter& parameter = m_command.parameters[index];
    std::string& lines = (m_values[index] ? *m_values[index] : m_values[index].emplace()).text;
    if (given.value.find('\n') != given.value.npos) refuse(parameter.name, "values without a line break, found one");
    if (!given.name.empty() && given.name != parameter.name) {
        lines += given.name + "=" + given.value + "\n";
        return;
    }
    for (const std::string_view pair : split(given.value, ' ')) {
        if (pair.empty()) continue;
        if (pair.find('=') == pair.npos || pair.front() == '=')
            refuse(parameter.name, fmt::format("{}, found '{}'", expectedText(parameter), pair));
        lines += std::string(pair) + "\n";
    }
}

Arguments::Value Arguments::read(const Parameter& parameter, const std::string& text) const {
    Value value{.text = text};
    const auto isIn = [&](double number) { return number >= parameter.low && number <= parameter.high; };
    const bool isWhole = parameter.type == Type::Whole || parameter.type == Type::Cell;
    const auto isGood = [&](std::string_view part, double& out) {
        return isNumber(part, out) && isIn(out) && (!isWhole || out == std::floor(out));
    };
    bool good = true;
    switch (parameter.type) {
        case Type::Number:
        case Type::Whole:
            good = isGood(text, value.numbers[0]);
            break;
        case Type::Flag:
            good = text == "yes" || text == "no";
            value.numbers[0] = text == "yes";
            break;
        case Type::Choice: {
            const auto all = split(parameter.choices, ' ');
            const auto found = std::find(all.begin(), all.end(), text);
            good = found != all.end();
            value.numbers[0] = double(found - all.begin());
            break;
        }
        case Type::Point:
        case Type::Cell: {
            const auto parts = split(text, ',');
            good = parts.size() == 3;
            for (size_t i = 0; good && i < 3; ++i) good = isGood(parts[i], value.numbers[i]);
            break;
        }
        case Type::Color:
            good = isColor(text, value.numbers);
            break;
        case Type::Text:
        case Type::Objects:
        case Type::Pairs:
            good = !text.empty() || parameter.otherwise != kRequired;
            break;
    }
    if (!good) refuse(parameter.name, fmt::format("{}, found '{}'", expectedText(parameter), text));
    return value;
}

void Arguments::refuse(std::string_view parameter, const std::string& expected) const {
    throw Refused(fmt::format("{}: {}: expected {}", m_command.name, parameter, expected));
}

void Arguments::requireNear(std::string_view parameter, glm::dvec3 place) const {
    for (int a = 0; a < 3; ++a)
        if (!(std::abs(place[a]) <= 1e6))
            refuse(parameter, fmt::format("what stays within 1000000 m of the origin, found {:g},{:g},{:g}", place.x,
                                          place.y, place.z));
}

const Arguments::Value& Arguments::at(std::string_view name, Type type) const {
    for (size_t i = 0; i < m_values.size(); ++i)
        if (m_command.parameters[i].name == name && m_command.parameters[i].type == type && m_values[i])
            return *m_values[i];
    throw std::logic_error(
        fmt::format("{}: the command reads '{}', which is not in its table or was not given", m_command.name, name));
}

bool Arguments::has(std::string_view name) const {
    for (size_t i = 0; i < m_values.size(); ++i)
        if (m_command.parameters[i].name == name) return m_values[i].has_value();
    return false;
}

double Arguments::number(std::string_view name) const {
    return at(name, Type::Number).numbers[0];
}

int Arguments::whole(std::string_view name) const {
    return int(at(name, Type::Whole).numbers[0]);
}

bool Arguments::flag(std::string_view name) const {
    return at(name, Type::Flag).numbers[0] != 0.0;
}

const std::string& Arguments::text(std::string_view name) const {
    for (const Parameter& each : m_command.parameters)
        if (each.name == name) return at(name, each.type).text;
    return at(name, Type::Text).text;
}

int Arguments::choice(std::string_view name) const {
    return int(at(name, Type::Choice).numbers[0]);
}

glm::dvec3 Arguments::point(std::string_view name) const {
    const Value& value = at(name, Type::Point);
    return {value.numbers[0], value.numbers[1], value.numbers[2]};
}

glm::ivec3 Arguments::cell(std::string_view name) const {
    const Value& value = at(name, Type::Cell);
    return {int(value.numbers[0]), int(value.numbers[1]), int(value.numbers[2])};
}

std::array<uint8_t, 3> Arguments::color(std::string_view name) const {
    const Value& value = at(name, Type::Color);
    return {uint8_t(value.numbers[0]), uint8_t(value.numbers[1]), uint8_t(value.numbers[2])};
}

}  // namespace editor
