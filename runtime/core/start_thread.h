#pragma once
#include <system_error>
#include <thread>
#include <utility>

namespace rubble {

/// Starts a thread. An empty one where the system gives none, as in browsers: the caller then does its work itself.
template <class Work>
std::thread startThread(Work&& work) {
    try {
        return std::thread(std::forward<Work>(work));
    } catch (const std::system_error&) {
        return {};
    }
}

}  // namespace rubble
