#pragma once
#include <stdexcept>

// Asserts, in Release too: they guard memory. What happens when one fails is for the program to say.

/// Does nothing if the condition holds. `condition && "text"` says what it is about.
#define RUBBLE_ASSERT(condition) ((condition) ? void() : ::rubble::failAssertion(#condition, __FILE__, __LINE__))

namespace rubble {

/// A failed assert: a mistake in this code. What was being changed is in no defined state any more.
class AssertionFailed : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// What is called when an assert fails, on the thread that it fails on. It may throw or end the program; where it
/// returns, the program ends. `message`: "FILE:LINE: assertion failed: CONDITION".
using AssertionHandler = void (*)(const char* message);

/// [any-thread] Sets the handler of the process. Null, as in the beginning: the message goes to standard error and the
/// program ends.
void setAssertionHandler(AssertionHandler handler);

/// Calls the handler.
[[noreturn]] void failAssertion(const char* condition, const char* file, int line);

}  // namespace rubble
