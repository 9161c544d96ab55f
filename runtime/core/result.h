#pragma once
#include <cassert>
#include <string>
#include <utility>
#include <variant>

namespace rubble {

/// Why data could not be used. The text says where, what was expected and what was found.
struct Error {
    std::string text;
};

/// A value, or the error that explains why there is none.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_value(std::move(value)) {}
    Result(Error error) : m_value(std::move(error)) {}

    explicit operator bool() const { return std::holds_alternative<T>(m_value); }
    T& value() & {
        assert(*this && "Result holds an error");
        return std::get<T>(m_value);
    }
    const T& value() const& { return const_cast<Result*>(this)->value(); }
    T&& value() && { return std::move(value()); }
    T& operator*() & { return value(); }
    const T& operator*() const& { return value(); }
    T* operator->() { return &value(); }
    const T* operator->() const { return &value(); }
    const std::string& error() const { return std::get<Error>(m_value).text; }

private:
    std::variant<T, Error> m_value;
};

/// Success without a value.
struct Done {};

}  // namespace rubble
