#pragma once
#include <string>
#include <utility>
#include <variant>

#include "runtime/core/assertion.h"

namespace rubble {

/// Why an operation failed. The text says where, what was expected, what was found and what to do.
struct Error {
    std::string text;
};

/// A value, or the error that explains why there is none. Test it before value().
template <class T>
class [[nodiscard]] Result {
public:
    /// Success. Implicit, so that functions can return a T.
    Result(T value) : m_value(std::move(value)) {}
    /// Failure. Implicit, so that functions can return an Error.
    Result(Error error) : m_value(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(m_value); }
    /// The value. Asserts in debug builds if this is an error.
    T& value() & {
        RUBBLE_ASSERT(*this && "Result holds an error");
        return std::get<T>(m_value);
    }
    /// The value. Asserts in debug builds if this is an error.
    const T& value() const& { return const_cast<Result*>(this)->value(); }
    /// The value, to be moved from. Asserts in debug builds if this is an error.
    T&& value() && { return std::move(value()); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    /// The error's text. Only of a failure.
    const std::string& error() const { return std::get<Error>(m_value).text; }

private:
    std::variant<T, Error> m_value;
};

/// The value of a Result<Done>: an operation that succeeds without a value.
struct Done {};

}  // namespace rubble
