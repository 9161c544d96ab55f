#pragma once
#include <optional>
#include <string_view>

namespace rubble {

/// The text of a file of shaders/, as "lib/tonemap.glsl", as it was when the library was built; none if there is no
/// such file. Its text outlives the program. [any thread]
std::optional<std::string_view> embeddedShader(std::string_view file);

}  // namespace rubble
