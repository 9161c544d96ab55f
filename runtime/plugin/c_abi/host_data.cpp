#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"
#include "runtime/world/edits/edit_error.h"

namespace rubble::abi {
namespace {

constexpr uint64_t kMaxBytes = 16 << 20;
constexpr size_t kMaxNameBytes = 4096, kMaxNames = 1000;

rubble_result getLocations(rubble_world world, rubble_location* out, uint32_t capacity, uint32_t* count) {
    return listRows<rubble_location>("get_locations", world, out, capacity, count,
                                     [](const HostedWorld& hosted, RowWriter<rubble_location>& rows) {
                                         for (const auto& place : hosted.loop.world().data().locations)
                                             rows.add([&] {
                                                 rubble_location row = {};
                                                 row.name = place.first.c_str();
                                                 writeVector(row.position, place.second.position);
                                                 writeRotation(row.rotation, place.second.rotation);
                                                 return row;
                                             });
                                     });
}

rubble_result getLevelScripts(rubble_world world, rubble_level_script* out, uint32_t capacity, uint32_t* count) {
    return listRows<rubble_level_script>(
        "get_level_scripts", world, out, capacity, count,
        [](const HostedWorld& hosted, RowWriter<rubble_level_script>& rows) {
            for (const LevelScript& script : hosted.loop.world().data().scripts)
                rows.add([&] { return rubble_level_script{script.path.c_str(), script.parameters.c_str()}; });
        });
}

/// Whether each line has a name before a "=".
bool areParameters(std::string_view lines) {
    for (size_t begin = 0; begin < lines.size();) {
        const std::string_view line = lines.substr(begin, lines.find('\n', begin) - begin);
        if (!line.empty() && (line.find('=') == line.npos || line.front() == '=')) return false;
        begin += line.size() + 1;
    }
    return true;
}

rubble_result setLevelScripts(rubble_world world, const rubble_level_script* scripts, uint32_t count) {
    return inWorld("set_level_scripts", world, [&](HostedWorld& hosted) {
        readInRange(double(count), ranges::kScripts, "count");
        if (!isRefused() && count) isGiven(scripts, "scripts");
        SetScriptsEdit edit;
        for (uint32_t i = 0; i < count && !isRefused(); ++i) {
            LevelScript& script = edit.scripts.emplace_back();
            script.path = readText(scripts[i].path, 1, size_t(ranges::kNameBytes.high), "path");
            if (scripts[i].parameters && !isRefused())
                script.parameters =
                    readText(scripts[i].parameters, 0, size_t(ranges::kParameterBytes.high), "parameters");
            if (!areParameters(script.parameters))
                refuse(RUBBLE_ERROR_ARGUMENT, "parameters are \"{:.100}\", expected lines of \"name=value\"",
                       script.parameters);
        }
        if (!isRefused()) requireNoError(editError(edit));
        push(hosted, std::move(edit));
    });
}

std::string readName(const char* name) {
    return readText(name, 1, kMaxNameBytes, "name");
}

std::vector<HostData>::const_iterator findData(const std::vector<HostData>& kept, const std::string& name) {
    return std::find_if(kept.begin(), kept.end(), [&](const HostData& each) { return each.name == name; });
}

rubble_result setHostData(rubble_world world, const char* name, const uint8_t* data, uint64_t size) {
    return inWorld("set_host_data", world, [&](HostedWorld& hosted) {
        const std::string key = readName(name);
        readInRange(double(size), {0.0, double(kMaxBytes)}, "size");
        if (!isRefused() && size) isGiven(data, "data");
        const auto& kept = hosted.loop.world().data().hostData;
        if (size && kept.size() >= kMaxNames && findData(kept, key) == kept.end())
            refuse(RUBBLE_ERROR_CAPACITY, "there are {} names already", kMaxNames);
        if (!isRefused()) rubble::setHostData(hosted.loop.world(), key, std::string(data, data + size));
    });
}

rubble_result getHostData(rubble_world world, const char* name, uint8_t* out, uint64_t capacity, uint64_t* count) {
    return inWorld("get_host_data", world, [&](const HostedWorld& hosted) {
        if (!isGiven(count, "count")) return;
        *count = 0;
        if (capacity) isGiven(out, "out");
        const std::string key = readName(name);
        if (isRefused()) return;
        const auto& kept = hosted.loop.world().data().hostData;
        const auto found = findData(kept, key);
        if (found != kept.end()) writeBytes(found->bytes.data(), uint64_t(found->bytes.size()), out, capacity, count);
    });
}

}  // namespace

void setHostDataFunctions(rubble_api& api) {
    api.get_locations = getLocations;
    api.get_level_scripts = getLevelScripts;
    api.set_level_scripts = setLevelScripts;
    api.set_host_data = setHostData;
    api.get_host_data = getHostData;
}

}  // namespace rubble::abi
