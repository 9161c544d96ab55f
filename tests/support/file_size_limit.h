#pragma once
#include <sys/resource.h>

#include <csignal>

namespace rubble {

/// Files of this process and of its children get no longer than some bytes while it lives, as on a disk that is full.
class FileSizeLimit {
public:
    /// Of the longest file.
    explicit FileSizeLimit(rlim_t bytes) {
        getrlimit(RLIMIT_FSIZE, &m_before);
        const rlimit small{bytes, m_before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &small);
    }
    ~FileSizeLimit() {
        setrlimit(RLIMIT_FSIZE, &m_before);
        std::signal(SIGXFSZ, m_oldHandler);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    void (*m_oldHandler)(int) = std::signal(SIGXFSZ, SIG_IGN);
    rlimit m_before{};
};

}  // namespace rubble
