#pragma once
#include "tests/tradeoff/report.h"

/// The destruction tables of the trade-off report. Each function returns its table and writes its plots to options.out.
namespace rubble::tradeoff {

/// Smallest piece, debris budget and time to freeze: step ms against mass, momentum and image lost.
Table debrisTradeoff(const Options& options);
/// Splits at once, in slices and by a full flood fill: us per cut, and how long an unanchored piece stays attached.
Table connectivityTradeoff(const Options& options);
/// Each feature of destruction always on, by rule and off.
Table featureTradeoff(const Options& options);
/// Map: ms per step by number of loose pieces and debris budget.
Table piecesMap(const Options& options);
/// Map: ms of one cut and its split by radius and size of the object, with invalid radii too.
Table splitMap(const Options& options);
/// Map: fragments and ms of one explosion by size and hardness of the material.
Table fragmentMap(const Options& options);
/// Map: whether a cantilever stands, by strength and span, compared with beam theory.
Table stressMap(const Options& options);

}  // namespace rubble::tradeoff
