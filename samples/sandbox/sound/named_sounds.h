#pragma once
#include <string_view>
#include <vector>

#include "samples/sandbox/sound/strike.h"

namespace sandbox::sound {

/// Whether there is a sound of that name that scripts play once: "explosion", "shot", "blast", "launch", "click",
/// "crack", "splash", "thud".
bool hasSound(std::string_view name);

/// What it is made of, at a place. Volume 1 is as it is; an explosion of volume 2 is twice as loud.
std::vector<Strike> soundStrikes(std::string_view name, glm::dvec3 position, double volume);

}  // namespace sandbox::sound
