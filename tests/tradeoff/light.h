#pragma once
#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {

Table walkTradeoff(const Options& options);          ///< T7
Table rayTradeoff(const Options& options);           ///< T8
Table denoiserTradeoff(const Options& options);      ///< T9
Table gbufferTradeoff(const Options& options);       ///< T10-gbuffer
Table lightFeatureTradeoff(const Options& options);  ///< T12-light
Table lightRuleTradeoff(const Options& options);     ///< T12-light-rules
Table sphereLightMap(const Options& options);        ///< T13-sphere-light
Table visibilityMap(const Options& options);         ///< T13-visibility
Table penumbraMap(const Options& options);           ///< T13-penumbra
Table shadowCellTradeoff(const Options& options);    ///< T6

/// The light's part of OPERATING_ENVELOPE.md.
std::string lightEnvelope(const Options& options, const std::vector<Table>& tables);

}  // namespace rubble::tradeoff
