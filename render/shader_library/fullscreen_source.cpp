#include "render/shader_library/fullscreen_source.h"

#include <algorithm>
#include <regex>
#include <sstream>
#include <string_view>

namespace rubble {
namespace {

/// A shader, taken apart for the main() that is put around it.
struct Parts {
    std::string body;                  ///< main() is renamed drawPixel(), `uv` is a variable
    std::vector<std::string> outputs;  ///< names by location
    bool readsUv = false, discards = false;
};

Parts partsOf(const ShaderSource& source, FullscreenMethod method) {
    static const std::regex main(R"(^\s*void\s+main\s*\(\s*\))"), uv(R"(^\s*in\s+vec2\s+uv\s*;)"),
        fragCoord(R"(\bgl_FragCoord\b)");
    static const std::regex output(R"(^\s*(?:layout\s*\(\s*location\s*=\s*(\d+)\s*\)\s*)?out\s+vec4\s+(\w+)\s*;)"),
        discard(R"(\bdiscard\s*;)");
    Parts parts;
    std::istringstream in(source.text);
    std::string line;
    while (std::getline(in, line)) {
        std::smatch match;
        line = std::regex_replace(line, main, "void drawPixel()");
        if (std::regex_search(line, uv)) {
            line = std::regex_replace(line, uv, "vec2 uv;");
            parts.readsUv = true;
        }
        if (method == FullscreenMethod::Compute) {
            if (std::regex_search(line, match, output)) {
                const size_t location = match[1].matched ? size_t(std::stoul(match[1].str())) : 0;
                parts.outputs.resize(std::max(parts.outputs.size(), location + 1));
                parts.outputs[location] = match[2].str();
                line = "vec4 " + match[2].str() + ";" + match.suffix().str();
            }
            parts.discards |= std::regex_search(line, discard);
            line = std::regex_replace(line, discard, "{ isDrawn = false; return; }");
            line = std::regex_replace(line, fragCoord, "pixelCentre");
        }
        parts.body += line + "\n";
    }
    return parts;
}

constexpr const char* kUv = "    uv = pixelCentre.xy * uTexelSize;\n";

std::string fragmentMain(const Parts& parts) {
    if (!parts.readsUv) return "void main() { drawPixel(); }\n";
    return std::string("uniform vec2 uTexelSize;\nvoid main() {\n    vec4 pixelCentre = gl_FragCoord;\n") + kUv +
           "    drawPixel();\n}\n";
}

/// The expression that is stored into an image, as blending would.
std::string merged(Merge merge, const std::string& now, const std::string& image) {
    const std::string old = "imageLoad(" + image + ", pixel)";
    switch (merge) {
        case Merge::Replace:
            return now;
        case Merge::Color:
            return "vec4(" + now + ".rgb, " + old + ".a)";
        case Merge::Alpha:
            return "vec4(" + old + ".rgb, " + now + ".a)";
        case Merge::Add:
            return old + " + " + now;
        case Merge::Over:
            return now + " + " + now + ".a * " + old;
    }
    return now;
}

std::string computeMain(const Parts& parts, const FullscreenKind& kind) {
    std::string images, stores;
    for (size_t i = 0; i < parts.outputs.size(); ++i) {
        const Merge merge = kind.mergeOf(i);
        const std::string number = std::to_string(i), image = "uTarget" + number;
        images += "layout(binding = " + number + (merge == Merge::Replace ? ") writeonly" : ", rgba16f)") +
                  " uniform image2D " + image + ";\n";
        stores += "    imageStore(" + image + ", pixel, " + merged(merge, parts.outputs[i], image) + ");\n";
    }
    std::string text =
        "layout(local_size_x = " + std::to_string(kGroupWidth) + ", local_size_y = " + std::to_string(kGroupHeight) +
        ") in;\n" + images +
        "uniform ivec2 uTargetLow, uTargetHigh;\nuniform vec2 uTexelSize;\nuniform sampler2D uDepthLimit;\n"
        "void main() {\n"
        "    ivec2 pixel = uTargetLow + ivec2(gl_GlobalInvocationID.xy);\n"
        "    if (any(greaterThanEqual(pixel, uTargetHigh))) return;\n";
    if (kind.surfacesOnly) text += "    if (texelFetch(uDepthLimit, pixel, 0).r >= 1.0) return;\n";
    text += "    pixelCentre = vec4(vec2(pixel) + 0.5, 0.0, 1.0);\n";
    if (parts.readsUv) text += kUv;
    text += "    drawPixel();\n";
    if (parts.discards) text += "    if (!isDrawn) return;\n";
    return text + stores + "}\n";
}

}  // namespace

ShaderSource asFullscreen(ShaderSource source, const FullscreenKind& kind, FullscreenMethod method) {
    const Parts parts = partsOf(source, method);
    source.text = parts.body;
    if (method == FullscreenMethod::Fragment) {
        source.text += fragmentMain(parts);
        return source;
    }
    const auto replace = [&](std::string_view old, std::string_view now) {
        source.text.replace(source.text.find(old), old.size(), now);
    };
    replace("#version 330 core\n", "#version 430 core\n");
    replace("precision highp int;\n", "precision highp int; vec4 pixelCentre; bool isDrawn = true;\n");
    source.text += computeMain(parts, kind);
    return source;
}

}  // namespace rubble
