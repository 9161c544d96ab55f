#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// One shader file with its #includes put in place, and where each of its lines came from: Mesa ignores the source
/// number of #line, so error messages are translated with this table instead.
struct ShaderSource {
    struct Line {
        int file;  ///< index into files
        int line;  ///< from 1
    };
    std::string text;
    std::vector<Line> lines;         ///< of text, in order
    std::vector<std::string> files;  ///< relative to the shader folder; the first is the shader itself

    /// A GL's log with its line numbers replaced by file:line.
    std::string explain(const std::string& log) const;
};

/// Reads `file` under `folder`; `#include "x"` is looked for under folder too and put in once. Puts `#version 330 core`
/// first. defines: lines of preprocessor that come before the file.
Result<ShaderSource> readShader(const std::filesystem::path& folder, const std::string& file,
                                const std::string& defines = {});

}  // namespace rubble
