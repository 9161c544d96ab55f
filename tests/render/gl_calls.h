#pragma once
#include <type_traits>

#include "render/gl/gl.h"

namespace rubble {

/// Counts the calls of a GL function while it lives, e.g. GlCalls<&glad_glLinkProgram>. One at a time for a function.
/// Renderer::create() loads all functions again: make it afterwards.
template <auto* kFunction>
class GlCalls {
    using Pointer = std::remove_reference_t<decltype(*kFunction)>;

public:
    /// Starts to count.
    GlCalls() {
        s_real = *kFunction;
        s_count = 0;
        *kFunction = counting(s_real);
    }
    ~GlCalls() { *kFunction = s_real; }
    GlCalls(const GlCalls&) = delete;
    GlCalls& operator=(const GlCalls&) = delete;
    /// Since it was made.
    int count() const { return s_count; }

private:
    template <class R, class... A>
    static Pointer counting(R (*)(A...)) {
        return [](A... arguments) -> R {
            ++s_count;
            return s_real(arguments...);
        };
    }
    static inline Pointer s_real = nullptr;
    static inline int s_count = 0;
};

/// Replaces a GL function while it lives.
template <class Pointer>
class GlReplaced {
public:
    /// place: the function's pointer, as glad_glFinish.
    GlReplaced(Pointer& place, Pointer replacement) : m_place(place), m_real(place) { place = replacement; }
    ~GlReplaced() { m_place = m_real; }
    GlReplaced(const GlReplaced&) = delete;
    GlReplaced& operator=(const GlReplaced&) = delete;

private:
    Pointer& m_place;
    Pointer m_real;
};

}  // namespace rubble
