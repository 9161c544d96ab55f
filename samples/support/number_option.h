#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

namespace rubble {

/// The check of an option of a command line that its text is a number within a range: CLI::Range lets NaN pass.
template <class T>
CLI::Validator numberBetween(const char* kind, T low, T high) {
    const std::string expected = fmt::format("{} from {} to {}", kind, low, high);
    return {[=](std::string& text) {
                T value = 0;
                const bool isNumber = !text.empty() && CLI::detail::lexical_cast(text, value);
                return isNumber && value >= low && value <= high
                           ? std::string()
                           : fmt::format("expected {}, found \"{}\"", expected, text);
            },
            expected, "NUMBER"};
}

/// Any number.
inline CLI::Validator numberFrom(double low, double high) {
    return numberBetween("a number", low, high);
}
/// A whole one.
inline CLI::Validator wholeFrom(int64_t low, int64_t high) {
    return numberBetween("a whole number", low, high);
}

}  // namespace rubble
