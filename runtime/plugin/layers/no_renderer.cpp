#include "runtime/plugin/layers.h"

namespace rubble {

bool hasRenderer() {
    return false;
}

}  // namespace rubble
