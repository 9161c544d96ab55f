#pragma once
#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace editor {

/// What a command throws: which command and parameter, what was expected, what was found.
class Refused : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// What a parameter takes.
enum class Type : uint8_t {
    Number,
    Whole,  ///< a number without a fraction
    Flag,   ///< yes or no
    Text,
    Choice,   ///< one of Parameter::choices
    Point,    ///< three numbers: x,y,z
    Cell,     ///< three whole numbers
    Color,    ///< #rrggbb, sRGB
    Objects,  ///< names, #HANDLE, tag:NAME, selected, all; separated by commas
    Pairs     ///< NAME=VALUE with spaces between; also each name=value of the line whose name is no parameter's
};

/// One parameter of a command.
struct Parameter {
    std::string_view name;
    Type type;
    std::string_view help;       ///< one line, for tooltips
    std::string_view otherwise;  ///< what is taken where it is left out, as it is typed; kRequired, kOptional
    double low = -1e6, high = 1e6;
    std::string_view choices = {};  ///< of Type::Choice, separated by spaces; endings of a Type::Text that is a file
};

/// A parameter that must be given.
inline constexpr std::string_view kRequired = "!";
/// A parameter that may be left out, which Arguments::has() tells.
inline constexpr std::string_view kOptional = "?";

struct Command;

/// A parameter as it is given: its name is empty where its place says which it is.
struct Given {
    std::string name, value;
};

/// A line as it is typed: a command, then values by their place or as name=value. Values with spaces stand in double
/// quotes.
struct Line {
    std::string command;
    std::vector<Given> given;
};
/// Takes a line apart. In quotes "" stands for a quote. Throws Refused where a quote does not end.
Line readLine(std::string_view text);
/// A line that readLine() takes apart to the same.
std::string textOf(const Line& line);

/// The checked values of a call of a command.
class Arguments {
public:
    /// Throws Refused where something is missing, unknown, given twice or out of range.
    Arguments(const Command& command, const std::vector<Given>& given);

    /// Whether it is given, or has a value where it is not.
    bool has(std::string_view name) const;
    /// Of Type::Number.
    double number(std::string_view name) const;
    /// Of Type::Whole.
    int whole(std::string_view name) const;
    /// Of Type::Flag.
    bool flag(std::string_view name) const;
    /// Of Type::Text, Type::Choice and Type::Objects; of Type::Pairs a line for each.
    const std::string& text(std::string_view name) const;
    /// Of Type::Choice: which of its choices.
    int choice(std::string_view name) const;
    /// Of Type::Point.
    glm::dvec3 point(std::string_view name) const;
    /// Of Type::Cell.
    glm::ivec3 cell(std::string_view name) const;
    /// Of Type::Color: bytes of sRGB.
    std::array<uint8_t, 3> color(std::string_view name) const;

    /// Throws Refused of a parameter: "sphere: radius: expected a number, found 'x'".
    [[noreturn]] void refuse(std::string_view parameter, const std::string& expected) const;
    /// Refuses a parameter that leads to a place farther from the origin than commands take.
    void requireNear(std::string_view parameter, glm::dvec3 place) const;
    /// The command that is called.
    const Command& command() const { return m_command; }

private:
    struct Value {
        std::array<double, 3> numbers{};
        std::string text;
    };
    const Value& at(std::string_view name, Type type) const;
    size_t indexOf(const Given& given, size_t place) const;
    size_t pairsIndex() const;
    void addPairs(size_t index, const Given& given);
    Value read(const Parameter& parameter, const std::string& text) const;

    const Command& m_command;
    std::vector<std::optional<Value>> m_values;  ///< by the place of the parameter
};

}  // namespace editor
