#pragma once
#include "runtime/core/result.h"
#include "tests/reference/path_tracer.h"

namespace rubble::reference {

/// OpenEXR: R, G, B and variance.R, .G, .B in floats, rows from the top as the format wants them.
Result<Done> writeExr(const std::string& path, const Estimate& estimate);
Result<Estimate> readExr(const std::string& path);

/// render(), or the file of an earlier run with the same scene, view and settings under `folder`.
Estimate cachedRender(const Scene& scene, const View& view, const Settings& settings, const std::string& folder,
                      const std::string& what);

}  // namespace rubble::reference
