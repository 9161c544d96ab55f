#pragma once
#include "tests/tradeoff/report.h"

/// The destruction rows of the trade-off report. Each makes its tables, and writes its plots on the way.
namespace rubble::tradeoff {

/// Smallest piece kept, debris budget and freezing: step ms against mass and momentum dropped and what is seen of it.
Table debrisTradeoff(const Options& options);
/// Connectivity at once, in slices, and by a full flood fill: us a cut and how long a loose piece hangs.
Table connectivityTradeoff(const Options& options);
/// Each feature always on, by rule, and off.
Table featureTradeoff(const Options& options);
/// Pushed until they fail, in two dimensions.
Table piecesMap(const Options& options);
Table splitMap(const Options& options);
Table fragmentMap(const Options& options);
Table stressMap(const Options& options);

}  // namespace rubble::tradeoff
