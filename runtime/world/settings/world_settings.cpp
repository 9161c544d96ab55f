#include "runtime/world/settings/world_settings.h"

#include "runtime/core/field_hash.h"
#include "runtime/world/settings/settings_fields.h"

namespace rubble {

uint64_t WorldSettings::hash() const {
    WorldSettings hashed = *this;
    hashed.undoMarks = 0;
    FieldHash hash;
    fields(hash, hashed);
    return hash.value();
}

}  // namespace rubble
