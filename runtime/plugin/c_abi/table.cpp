#include "runtime/core/log.h"
#include "runtime/plugin/c_abi/calls.h"
#include "runtime/plugin/c_abi/functions.h"

namespace rubble::abi {
namespace {

rubble_api makeTable() {
    rubble_api api = {};
    api.struct_size = sizeof api;
    api.version = RUBBLE_VERSION;
    setHostFunctions(api);
    setWorldFunctions(api);
    setEditFunctions(api);
    setJointFunctions(api);
    setRegionFunctions(api);
    setCharacterFunctions(api);
    setLightFunctions(api);
    setStateFunctions(api);
    setFireFunctions(api);
    setShapeFunctions(api);
    setCreateFunctions(api);
    setPrefabFunctions(api);
    setRowFunctions(api);
    setQueryFunctions(api);
    setSaveFunctions(api);
    setObjectFunctions(api);
    setSettingsFunctions(api);
    setPaletteFunctions(api);
    setHostPhysicsFunctions(api);
    setDataFileFunctions(api);
    setDeltaFunctions(api);
    setLoadingFunctions(api);
    setMaterialFunctions(api);
    setPropertyFunctions(api);
    setLightGroupFunctions(api);
    setRendererFunctions(api);
    setHostDataFunctions(api);
    setOverlayFunctions(api);
    setReportFunctions(api);
    setBrickFunctions(api);
    setParticleFunctions(api);
    return api;
}

}  // namespace
}  // namespace rubble::abi

extern "C" rubble_result rubble_get_api(uint32_t version, const rubble_api** table) {
    return rubble::abi::guarded("rubble_get_api", [&] {
        static const rubble_api api = rubble::abi::makeTable();
        if (!rubble::abi::isGiven(table, "table")) return;
        *table = nullptr;
        if (version != RUBBLE_VERSION) {
            const std::string text = "version " + std::to_string(version) +
                                     " asked for, this plugin implements version " + std::to_string(RUBBLE_VERSION) +
                                     ": use the rubble.h that belongs to it";
            rubble::logError("rubble_get_api: " + text);  // without a table the host cannot ask for the last error
            return rubble::abi::refuse(RUBBLE_ERROR_VERSION, "{}", text);
        }
        *table = &api;
    });
}
