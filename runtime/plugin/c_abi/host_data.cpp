#include <algorithm>

#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

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
    api.set_host_data = setHostData;
    api.get_host_data = getHostData;
}

}  // namespace rubble::abi
