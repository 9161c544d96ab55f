#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "runtime/core/result.h"

namespace rubble {

/// A shader file with its #includes expanded, and where each line came from. Error messages are translated by this
/// table, because Mesa ignores the source number of #line.
struct ShaderSource {
    struct Line {
        int file;  ///< index into files
        int line;  ///< from 1
    };
    std::string text;
    std::vector<Line> lines;         ///< of text, in order
    std::vector<std::string> files;  ///< relative to the shader folder; the first is the shader itself

    /// The GL's log with its line numbers replaced by file:line.
    std::string explain(const std::string& log) const;
};

/// Reads `file` under `folder`, or of the library where `folder` is empty, behind `#version 330 core` and `defines`
/// (whole lines). `#include "x"` is looked for there too; each file is included once. An error names the file that is
/// missing and the line that asks for it.
Result<ShaderSource> readShader(const std::filesystem::path& folder, const std::string& file,
                                const std::string& defines = {});

}  // namespace rubble
