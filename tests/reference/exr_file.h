#pragma once
#include <string>

#include "runtime/core/result.h"
#include "tests/reference/path_tracer.h"

namespace rubble::reference {

/// Writes an OpenEXR file with float channels R, G, B and variance.R, .G, .B. Rows are from the top, as in all such
/// files.
Result<Done> writeExr(const std::string& path, const Estimate& estimate);
/// Reads a file of writeExr(). An error names the path.
Result<Estimate> readExr(const std::string& path);

/// render(), or the file of an earlier run with the same scene, view and settings in `folder`. what: for the progress
/// bar.
Estimate cachedRender(const Scene& scene, const View& view, const Settings& settings, const std::string& folder,
                      const std::string& what);

}  // namespace rubble::reference
