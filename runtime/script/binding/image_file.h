#pragma once
#include <string>

#include "runtime/script/binding/ui_state.h"

namespace rubble::script {

/// Reads a PNG file of at most 4096 x 4096 pixels, and of at most so many bytes when unpacked. What is wrong with it,
/// or
/// "".
std::string readPng(const std::string& path, size_t maxBytes, UiImage& out);

}  // namespace rubble::script
