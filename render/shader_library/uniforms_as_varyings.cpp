#include "render/shader_library/uniforms_as_varyings.h"

#include <cctype>
#include <map>
#include <regex>
#include <sstream>
#include <string_view>

#include "render/gl/gl.h"

namespace rubble {
namespace {

constexpr std::string_view kBlockBegin = "layout(std140) uniform FrameBlock {", kBlockEnd = "} frame;";

using TypeByName = std::map<std::string, std::string, std::less<>>;

/// The types and names that a pattern with two groups finds.
TypeByName declarations(const std::string& text, const std::regex& declaration) {
    TypeByName found;
    for (std::sregex_iterator at(text.begin(), text.end(), declaration), end; at != end; ++at)
        found.emplace((*at)[2], (*at)[1]);
    return found;
}

/// The declaration of the block `frame`; empty if there is none.
std::string_view frameBlock(std::string_view text) {
    const size_t begin = text.find(kBlockBegin);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find(kBlockEnd, begin) + kBlockEnd.size() - begin);
}

bool isIdentifierChar(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}

/// Replaces each identifier by what visit(word, rest, taken) returns. `rest` is the text behind the word; visit may
/// raise `taken`, the number of characters that are replaced, which starts as the word's length.
template <class Visit>
std::string replaceWords(std::string_view text, Visit&& visit) {
    std::string out;
    out.reserve(text.size() + text.size() / 8);
    for (size_t i = 0; i < text.size();) {
        size_t end = i;
        while (end < text.size() && isIdentifierChar(text[end])) ++end;
        if (end == i) {
            out += text[i++];
            continue;
        }
        size_t taken = end - i;
        out += visit(text.substr(i, taken), text.substr(end), taken);
        i += taken;
    }
    return out;
}

std::string_view firstWord(std::string_view text) {
    size_t end = 0;
    while (end < text.size() && isIdentifierChar(text[end])) ++end;
    return text.substr(0, end);
}

}  // namespace

int varyingVectors() {
    constexpr int kOwn = 4;
    GLint components = 0;
    glGetIntegerv(GL_MAX_VARYING_COMPONENTS, &components);
    return components / 4 - kOwn;
}

void passUniformsAsVaryings(ShaderSource& vertex, ShaderSource& fragment, int vectors) {
    static const std::regex uniform(R"(\buniform\s+(float|u?int|[iu]?vec[234]|mat4)\s+(\w+)\s*;)"),
        member(R"(\b([iu]?vec4|mat4)\s+(\w+)\s*;)");
    const std::string block(frameBlock(fragment.text));
    const TypeByName uniforms = declarations(fragment.text, uniform), members = declarations(block, member);
    TypeByName flat;     // the flat inputs, by their names in the fragment program
    std::string copies;  // assignments that end the vertex program
    /// The expression for a uniform that was `from`: the input of its name, while there is room for one.
    const auto pass = [&](const std::string& name, const std::string& type, const std::string& from) {
        if (flat.contains(name)) return name;
        const int size = type == "mat4" ? 4 : 1;
        if (size > vectors) return from;
        vectors -= size;
        flat.emplace(name, type);
        copies += "    " + name + " = " + from + ";\n";
        return name;
    };
    fragment.text =
        replaceWords(fragment.text, [&](std::string_view word, std::string_view rest, size_t& taken) -> std::string {
            if (word == "frame" && rest.starts_with('.')) {
                const std::string_view name = firstWord(rest.substr(1));
                const auto found = members.find(name);
                if (found == members.end()) return std::string(word);
                taken += 1 + name.size();
                return pass("frame_" + found->first, found->second, "frame." + found->first);
            }
            if (const auto found = uniforms.find(word); found != uniforms.end())
                return pass("flat_" + found->first, found->second, found->first);
            return std::string(word);
        });
    // A uniform's declaration becomes that of its input; inputs for members of `frame` go before the block.
    std::string inputs, outputs;
    for (const auto& [name, type] : flat) {
        outputs += "flat out " + type + " " + name + ";\n";
        if (name.starts_with("frame_")) inputs += "flat in " + type + " " + name + "; ";
    }
    static const std::regex passed(R"(\buniform\s+(\w+)\s+(flat_\w+)\s*;)");
    fragment.text = std::regex_replace(fragment.text, passed, "flat in $1 $2;");
    if (const size_t at = fragment.text.find(kBlockBegin); at != std::string::npos) fragment.text.insert(at, inputs);

    // The vertex program declares what the fragment program read, calls its own main() and writes the outputs.
    const TypeByName already = declarations(vertex.text, uniform);
    std::string& text = vertex.text;
    text = std::regex_replace(text, std::regex(R"(\bvoid\s+main\s*\()"), "void place(");
    if (!block.empty() && frameBlock(text).empty()) text += block + "\n";
    for (const auto& [name, type] : uniforms)
        if (!already.contains(name)) text += "uniform " + type + " " + name + ";\n";
    text += outputs + "void main() {\n    place();\n" + copies + "}\n";
}

}  // namespace rubble
