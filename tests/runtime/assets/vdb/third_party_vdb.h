#pragma once
#include <string>

namespace rubble {

/// Writes a file as other programs write them. `kind`: one of the names in third_party_vdb.cpp.
void writeThirdPartyVdb(const std::string& kind, const std::string& path);
/// Removes a number or boolean from the JSON metadata, as if an older program had written the file.
void removeField(const std::string& path, const std::string& field);

}  // namespace rubble
