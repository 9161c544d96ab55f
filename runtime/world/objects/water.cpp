#include "runtime/world/objects/water.h"

#include "runtime/world/objects/object_hash.h"

namespace rubble {

uint64_t Water::hash() const {
    uint64_t hash = 0;
    addToHash(hash, outline);
    for (const double value : {surface, depth, density, linearDrag, angularDrag}) addToHash(hash, value);
    addToHash(hash, flow);
    return hash;
}

}  // namespace rubble
