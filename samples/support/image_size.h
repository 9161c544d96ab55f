#pragma once
#include <string>

namespace rubble {

/// Reads "WIDTHxHEIGHT" in pixels, 16 to 8192 each. Returns what is wrong; empty: nothing.
std::string readImageSize(const std::string& text, int& width, int& height);

}  // namespace rubble
