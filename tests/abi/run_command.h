#pragma once
#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace rubble {

/// Runs a command and returns what it wrote to both outputs; exitCode -1 if it did not end by itself.
inline std::string runCommand(const std::string& command, int& exitCode) {
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::string text;
    char part[4096];
    while (const size_t size = std::fread(part, 1, sizeof part, pipe)) text.append(part, size);
    const int status = pclose(pipe);
    exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return text;
}

}  // namespace rubble
