#pragma once
#include <string>

namespace rubble::script {

/// The text of a script in plain Lua: mods of Teardown may have lines `#version 2`, which go, and
/// `#include "path.lua"`, which become require("path.lua"); a byte order mark and a first line `#!...` go too. Lines
/// keep their numbers.
std::string withoutDirectives(std::string text);

}  // namespace rubble::script
