#include "render/shader_library/shader_library.h"

#include <algorithm>

#include "render/shader_library/shader_source.h"

namespace rubble {

const Program& ShaderLibrary::load(const std::string& fragmentFile, const std::string& vertexFile) {
    for (const auto& entry : m_entries)
        if (entry->fragmentFile == fragmentFile && entry->vertexFile == vertexFile) return entry->program;
    auto entry = std::make_unique<Entry>(Entry{vertexFile, fragmentFile, {vertexFile, fragmentFile}, {}, {}});
    build(*entry);
    m_entries.push_back(std::move(entry));
    return m_entries.back()->program;
}

bool ShaderLibrary::build(Entry& entry) {
    entry.newest = newestOf(entry.files);
    const auto vertex = readShader(m_folder, entry.vertexFile);
    const auto fragment = readShader(m_folder, entry.fragmentFile);
    if (!vertex || !fragment) {
        entry.error = vertex ? fragment.error() : vertex.error();
        return false;
    }
    entry.files = vertex->files;
    entry.files.insert(entry.files.end(), fragment->files.begin(), fragment->files.end());
    entry.newest = newestOf(entry.files);
    std::string log;
    bool vertexFailed = false;
    Program program(vertex->text, fragment->text, log, vertexFailed);
    if (!program) {
        entry.error = (vertexFailed ? *vertex : *fragment).explain(log);
        return false;
    }
    entry.error.clear();
    entry.program = std::move(program);
    return true;
}

bool ShaderLibrary::reloadChanged() {
    bool any = false;
    for (const auto& entry : m_entries) {
        if (newestOf(entry->files) <= entry->newest) continue;
        any |= build(*entry);
    }
    return any;
}

std::vector<std::string> ShaderLibrary::errors() const {
    std::vector<std::string> all;
    for (const auto& entry : m_entries)
        if (!entry->error.empty()) all.push_back(entry->error);
    return all;
}

std::filesystem::file_time_type ShaderLibrary::newestOf(const std::vector<std::string>& files) const {
    auto newest = std::filesystem::file_time_type::min();
    for (const std::string& file : files) {
        std::error_code missing;
        const auto time = std::filesystem::last_write_time(m_folder / file, missing);
        if (!missing) newest = std::max(newest, time);
    }
    return newest;
}

}  // namespace rubble
