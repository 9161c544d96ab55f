#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>

// Reflection for files: each type that is stored has one table of its fields, kFields<T>, and every archive goes
// through that table. An archive is a class with operator()(name, field): the binary formats, the JSON of .vdb files,
// the hash of a level and its validation are archives. So no format can lack a field that another one has. The order of
// a table is the order of the bytes in a file, and the names are the JSON keys: neither may change.
namespace rubble {

/// A row of a table. `member`: a pointer to a member, or a function from the value to a reference.
template <class Member>
struct Field {
    const char* name;
    Member member;
    static constexpr bool kBinaryOnly = false;
};
/// Clang before version 17 needs this to deduce Member.
template <class Member>
Field(const char*, Member) -> Field<Member>;

/// A field that binary archives store and JSON does not: handles and what belongs to a running World.
template <class Member>
struct BinaryField {
    const char* name;
    Member member;
    static constexpr bool kBinaryOnly = true;
};
/// See Field.
template <class Member>
BinaryField(const char*, Member) -> BinaryField<Member>;

/// A row's `member` for one element of an array. Clang-format cannot lay out a lambda within a table.
template <size_t kIndex, class Member>
constexpr auto elementOf(Member member) {
    return [member](auto& value) -> auto& {
        return (value.*member)[kIndex];
    };
}

/// A row's `member` for a member of a member.
template <class Outer, class Inner>
constexpr auto memberOf(Outer outer, Inner inner) {
    return [=](auto& value) -> auto& {
        return value.*outer.*inner;
    };
}

/// The fields of a type in the order of its bytes; empty for types without a table.
template <class T>
inline constexpr std::tuple<> kFields{};

template <class T>
concept HasFields = (std::tuple_size_v<std::remove_const_t<decltype(kFields<std::remove_const_t<T>>)>> > 0);

/// Calls archive(name, field) for each field of the value. An archive is binary if it has a member kIsBinary.
template <class Archive, HasFields T>
void fields(Archive& archive, T& value) {
    const auto visit = [&](const auto& field) {
        if constexpr (!std::remove_cvref_t<decltype(field)>::kBinaryOnly || requires { Archive::kIsBinary; })
            archive(field.name, std::invoke(field.member, value));
    };
    std::apply([&](const auto&... field) { (visit(field), ...); }, kFields<std::remove_const_t<T>>);
}

/// The names of an enum's values in their order: JSON stores the name, binary formats the number.
template <class Enum>
inline constexpr std::array<const char*, 0> kEnumNames{};

/// kEnumNames of an enum that has them.
template <class Enum>
requires(!kEnumNames<Enum>.empty()) std::span<const char* const> enumNames(Enum) {
    return kEnumNames<Enum>;
}

}  // namespace rubble
