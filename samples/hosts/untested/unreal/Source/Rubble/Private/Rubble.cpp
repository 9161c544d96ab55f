// Untested. Rubble.uplugin names a module, which must be compiled; it has nothing of its own.
#include <Modules/ModuleManager.h>

IMPLEMENT_MODULE(FDefaultModuleImpl, Rubble)
