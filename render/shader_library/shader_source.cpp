#include "render/shader_library/shader_source.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>
#include <regex>
#include <sstream>

#include "render/gl/gl.h"
#include "render/shader_library/embedded_shaders.h"

namespace rubble {
namespace {

constexpr const char* kDesktopHead = "#version 330 core\nprecision highp float;\nprecision highp int;\n";
/// OpenGL ES has default precisions of 2D samplers of floats alone, and lower ones.
constexpr const char* kEmbeddedHead =
    "#version 300 es\nprecision highp float;\nprecision highp int;\n"
    "precision highp sampler2D; precision highp isampler2D; precision highp usampler2D;\n"
    "precision highp usampler2DArray; precision highp usampler3D;\n";

std::optional<std::string> includedFile(const std::string& line) {
    static const std::regex pattern(R"(^\s*#\s*include\s*"([^"]+)\".*)");
    std::smatch match;
    if (!std::regex_match(line, match, pattern)) return {};
    return match[1].str();
}

std::optional<std::string> textOf(const std::filesystem::path& folder, const std::string& file) {
    if (folder.empty()) {
        const auto text = embeddedShader(file);
        return text ? std::optional<std::string>(*text) : std::nullopt;
    }
    std::ifstream stream(folder / file);
    if (!stream) return {};
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

/// Appends a file, with its includes, to the source. Returns an error or an empty text. from: where it is included.
std::string append(const std::filesystem::path& folder, const std::string& file, const std::string& from,
                   ShaderSource& source) {
    if (std::find(source.files.begin(), source.files.end(), file) != source.files.end()) return {};
    const auto text = textOf(folder, file);
    if (!text) return from + "expected a shader file " + (folder / file).string() + ", found none";
    std::istringstream stream(*text);
    const int index = int(source.files.size());
    source.files.push_back(file);
    std::string line;
    for (int number = 1; std::getline(stream, line); ++number) {
        if (const auto included = includedFile(line)) {
            const std::string here = file + ":" + std::to_string(number) + ": ";
            if (std::string error = append(folder, *included, here, source); !error.empty()) return error;
            continue;
        }
        source.text += line + "\n";
        source.lines.push_back({index, number});
    }
    return {};
}

}  // namespace

std::string ShaderSource::explain(const std::string& log) const {
    // Mesa writes "0:12(5): error", NVIDIA "0(12) : error", ANGLE "ERROR: 0:12: ...".
    static const std::regex pattern(R"(\b0(?::(\d+)(\(\d+\))?|\((\d+)\)))");
    std::istringstream in(log);
    std::string line, out;
    while (std::getline(in, line)) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) {
            const int number = std::stoi(match[1].matched ? match[1].str() : match[3].str());
            if (number >= 1 && number <= int(lines.size()) && lines[size_t(number - 1)].file >= 0) {
                const Line& where = lines[size_t(number - 1)];
                line = match.prefix().str() + files[size_t(where.file)] + ":" + std::to_string(where.line) +
                       match.suffix().str();
            }
        }
        out += line + "\n";
    }
    return out;
}

Result<ShaderSource> readShader(const std::filesystem::path& folder, const std::string& file,
                                const std::string& defines) {
    ShaderSource source;
    source.text = (isEmbedded() ? kEmbeddedHead : kDesktopHead) + defines;
    source.lines.assign(size_t(std::count(source.text.begin(), source.text.end(), '\n')), {-1, 0});
    if (std::string error = append(folder, file, "", source); !error.empty()) return Error{error};
    return source;
}

}  // namespace rubble
