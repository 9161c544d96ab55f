#include "samples/lua/reference.h"

#include "runtime/script/functions/vocabulary.h"
#include "samples/lua/examples.h"

namespace lua_sample {
namespace {

using rubble::script::ScriptFunction;
using rubble::script::Subject;

constexpr const char* kNote =
    "<!-- Made by ./rubble lua --reference from runtime/script/functions and samples/lua/examples.lua. -->\n";

/// An image of the pages whose subject begins so.
struct PageImage {
    std::string_view subject;
    const char* link;
};
constexpr PageImage kImages[] = {
    {"ui",
     "![What samples/lua/drawing.lua draws: texts, shapes and a clipped window, each beside its "
     "function](drawing.jpg)"},
    {"break", "![What samples/lua/breaking.lua does to a wall and a crate, each below its function](breaking.jpg)"},
    {"world", "![DebugProfile(): a table of a script, its callbacks and functions over the yard](profile.jpg)"},
};

std::string pageOf(const Subject& subject, const std::map<std::string, std::string>& examples) {
    std::string page = std::string(kNote) + "# " + std::string(subject.title) + "\n\n";
    page +=
        "All functions are in the [index](README.md). The examples run in the yard of `samples/lua/yard.h`; the files "
        "that they name are in `samples/lua/files`.\n";
    for (const PageImage& image : kImages)
        if (subject.name.starts_with(image.subject)) page += std::string("\n") + image.link + "\n";
    for (const ScriptFunction& function : subject.functions) {
        const std::string name = function.name();
        page += "\n## " + name + "\n\n`" + function.signature + "`\n\n" + function.meaning + "\n";
        const auto example = examples.find(name);
        if (example != examples.end()) page += "\n```lua\n" + example->second + "```\n";
    }
    return page;
}

std::string lower(std::string text) {
    for (char& byte : text) byte = char(std::tolower(static_cast<unsigned char>(byte)));
    return text;
}

}  // namespace

std::map<std::string, std::string> makeReference(const std::string& path) {
    std::map<std::string, std::string> examples, pages;
    for (const Example& example : readExamples(path)) examples[example.name] = example.text;
    std::string index =
        std::string(kNote) + "# Functions of scripts\n\n[Scripts](../scripting.md) says how they are used.\n";
    for (const Subject& subject : rubble::script::vocabulary()) {
        const std::string file = std::string(subject.name) + ".md";
        pages[file] = pageOf(subject, examples);
        index +=
            "\n## [" + std::string(subject.title) + "](" + file + ")\n\n| function | what it does |\n| --- | --- |\n";
        for (const ScriptFunction& function : subject.functions)
            index += "| [" + function.name() + "](" + file + "#" + lower(function.name()) + ") | " + function.meaning +
                     " |\n";
    }
    pages["README.md"] = index;
    return pages;
}

}  // namespace lua_sample
