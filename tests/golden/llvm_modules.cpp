#include "tests/golden/llvm_modules.h"

#include <dlfcn.h>

#include <atomic>

namespace rubble {
namespace {

std::atomic<int> g_modules{0};

}  // namespace

int llvmModules() {
    return g_modules;
}

extern "C" {

/// The program's function stands before that of libLLVM, so that Mesa calls this one.
[[gnu::visibility("default")]] void* LLVMModuleCreateWithNameInContext(const char* name, void* context) {
    using Create = void* (*)(const char*, void*);
    static const auto real = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "LLVMModuleCreateWithNameInContext"));
    ++g_modules;
    return real(name, context);
}

}  // extern "C"

}  // namespace rubble
