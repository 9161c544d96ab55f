#pragma once
#include <atomic>
#include <new>
#include <optional>
#include <string>
#include <thread>
#include <utility>

#include "runtime/assets/assets.h"
#include "runtime/core/progress.h"

namespace rubble {

/// Reads a level on a thread of its own. Its destructor waits for the thread. [one thread]
class LevelLoading {
public:
    /// Begins; see readLevel().
    LevelLoading(std::string path, std::string vdbTool)
        : m_thread([this, path = std::move(path), vdbTool = std::move(vdbTool)] { read(path, vdbTool); }) {}

    /// 0 to 1, by the bytes that are read; 1: take() does not wait.
    double progress() const { return m_isDone ? 1.0 : 0.99 * m_progress; }
    /// The level; waits for it. Throws std::bad_alloc if there was no memory for it.
    Result<Level> take() {
        m_thread.join();
        if (!m_level) throw std::bad_alloc();
        return std::move(*m_level);
    }

private:
    /// Nothing is thrown out of a thread.
    void read(const std::string& path, const std::string& vdbTool) noexcept {
        try {
            const ProgressScope scope(m_progress);
            m_level = readOrFail(path, vdbTool);
        } catch (const std::bad_alloc&) {
            m_level.reset();
        }
        m_isDone = true;
    }
    static Result<Level> readOrFail(const std::string& path, const std::string& vdbTool) {
        try {
            return readLevel(path, vdbTool);
        } catch (const std::bad_alloc&) {
            throw;
        } catch (const std::exception& error) {
            return Error{path + ": " + error.what()};
        }
    }

    std::atomic<double> m_progress = 0.0;
    std::atomic<bool> m_isDone = false;
    std::optional<Result<Level>> m_level;  ///< none: there was no memory for it
    std::jthread m_thread;                 ///< declared last: it uses the others
};

}  // namespace rubble
