#include "runtime/assets/vox_import.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const auto level = rubble::importVoxBytes({data, size}, "fuzz.vox", {});
    if (!level && level.error().empty()) __builtin_trap();
    return 0;
}
