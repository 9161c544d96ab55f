#include "runtime/script/binding/messages.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <iterator>
#include <sstream>
#include <string_view>
#include <vector>

#include "runtime/script/binding/script_context.h"

namespace rubble::script {
namespace {

/// Parameters that stand for a field whose name they do not have. Of those that a function has, the numbers of a field
/// are one each; if it has fewer, the first one has them all.
constexpr struct {
    std::string_view field;
    const char* parameters;
} kNames[] = {
    {"angular_velocity", "velocity"},
    {"body", "list"},
    {"color", "r g b intensity"},
    {"direction", "dir"},
    {"emission", "scale"},
    {"end", "p1"},
    {"high", "max"},
    {"joules", "amount"},
    {"low", "min pos xmin ymin zmin"},
    {"max_distance", "maxDist"},
    {"motor_max_force", "strength"},
    {"motor_target", "velocity target"},
    {"object", "handle"},
    {"origin", "point"},
    {"other", "bodyB"},
    {"owner", "body shape"},
    {"position", "pos point origin transform p0 pointA"},
    {"radii", "r0 r1 r2"},
    {"rotation", "transform rot"},
    {"shape", "refShape list"},
    {"size", "xmax ymax zmax"},
    {"speed", "pointA quatA"},
};

/// "wet_seconds" as "wetSeconds".
std::string asParameter(const std::string& field) {
    std::string name;
    for (size_t i = 0; i < field.size(); ++i) {
        const bool begins = i > 0 && field[i - 1] == '_';
        if (field[i] != '_') name += begins ? char(std::toupper(static_cast<unsigned char>(field[i]))) : field[i];
    }
    return name;
}

/// What the options of a function call a field; "": it has none.
std::string optionOf(const ScriptFunction& function, const std::string& field) {
    if (!function.fields) return "";
    std::istringstream pairs(function.fields);
    for (std::string pair; std::getline(pairs >> std::ws, pair, ',');)
        if (pair.starts_with(field + " ")) return pair.substr(field.size() + 1);
    return asParameter(field);
}

/// The parameter that a field as "rays[0].origin[1]" was made from; "": none that is known.
std::string parameterOf(lua_State* L, std::string field) {
    const std::vector<std::string> all = runningFunction(L).parameters();
    const auto isParameter = [&](const std::string& name) {
        return std::find(all.begin(), all.end(), name) != all.end();
    };
    size_t number = 0;
    if (field.starts_with("its ")) field.erase(0, 4);
    const std::string list = field.substr(0, field.find('['));
    const int rowNumber = std::atoi(field.c_str() + std::min(list.size() + 1, field.size())) + 1;
    if (field.ends_with(']')) {
        number = size_t(std::atoi(field.c_str() + field.rfind('[') + 1));
        field.resize(field.rfind('['));
    }
    const size_t last = field.find_last_of(".>") + 1;
    field.erase(0, last);
    if (last > 0 && isParameter(list)) return list + ", row " + std::to_string(rowNumber) + ", " + field;
    if (const std::string name = asParameter(field); isParameter(name)) return name;
    std::vector<std::string> names;
    for (const auto& row : kNames) {
        std::istringstream words(row.field == field ? row.parameters : "");
        for (std::string name; words >> name;)
            if (isParameter(name)) names.push_back(name);
    }
    if (names.empty()) return optionOf(runningFunction(L), field);
    return names[number < names.size() ? number : 0];
}

std::string withoutFunction(const std::string& message) {
    const size_t end = message.find(": ");
    const auto isOfName = [](char letter) { return (letter >= 'a' && letter <= 'z') || letter == '_'; };
    const bool isName =
        end != message.npos && std::all_of(message.begin(), message.begin() + std::ptrdiff_t(end), isOfName);
    return isName ? message.substr(end + 2) : message;
}

}  // namespace

std::vector<std::string> ScriptFunction::parameters() const {
    const std::string text = signature;
    const size_t begin = text.find('(') + 1;
    std::string list = text.substr(begin, text.find(')') - begin);
    std::replace(list.begin(), list.end(), ',', ' ');
    std::istringstream words(list);
    return {std::istream_iterator<std::string>(words), {}};
}

std::string parameterAt(lua_State* L, int index) {
    return runningFunction(L).parameters().at(size_t(index) - 1);
}

std::string messageOf(lua_State* L, std::string message) {
    constexpr std::string_view kIs = " is ", kHas = " has ", kNaming = " names ", kExpected = ", expected ";
    const std::string folder = ScriptContext::of(L).folder + "/";
    for (size_t at = 0; folder.size() > 1 && (at = message.find(folder, at)) != message.npos;)
        message.erase(at, folder.size());
    message = withoutFunction(message);
    const size_t is = message.find(kIs), has = message.find(kHas), end = std::min({is, has, message.find(kNaming)});
    const size_t expected = message.find(kExpected), why = message.find(": ", expected);
    const std::string field = message.substr(0, end);
    const bool isField = end != message.npos && field.find(' ', field.starts_with("its ") ? 4 : 0) == field.npos;
    const std::string parameter = isField ? parameterOf(L, field) : "";
    if (parameter.empty()) return message;
    if (expected == message.npos) return parameter + message.substr(end);
    const size_t value = end + (has < is ? kHas : kIs).size(), wanted = expected + kExpected.size();
    return parameter + ": expected " + message.substr(wanted, why == message.npos ? why : why - wanted) + ", found " +
           message.substr(value, expected - value) + (why == message.npos ? "" : message.substr(why));
}

}  // namespace rubble::script
