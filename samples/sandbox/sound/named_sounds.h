#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "samples/sandbox/sound/strike.h"

namespace sandbox::sound {

/// The names of sounds that scripts play once.
std::span<const std::string_view> soundNames();
/// The names of those that go on.
std::span<const std::string_view> loopNames();

/// What it is made of, at a place. Volume 1 is as it is; an explosion of volume 2 is twice as loud.
std::vector<Strike> soundStrikes(std::string_view name, glm::dvec3 position, double volume);

}  // namespace sandbox::sound
