#include "samples/support/image_size.h"

#include <algorithm>
#include <cstdio>

namespace rubble {

std::string readImageSize(const std::string& text, int& width, int& height) {
    char end = 0;
    const bool isSize = std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &end) == 2;
    return isSize && std::min(width, height) >= 16 && std::max(width, height) <= 8192
               ? ""
               : "expected WIDTHxHEIGHT from 16x16 to 8192x8192, found " + text;
}

}  // namespace rubble
