#pragma once
#include <string>
#include <vector>

#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {

// The light tables of the trade-off report. Each function returns its table and writes its plots to options.out.

Table shadowCellTradeoff(const Options& options);    ///< T6: voxels per bit of the shadow volume, against wrong rays
Table walkTradeoff(const Options& options);          ///< T7: exact and approximate walks, by length of the rays
Table rayTradeoff(const Options& options);           ///< T8: number, length and noise of sky rays, against FLIP
Table denoiserTradeoff(const Options& options);      ///< T9: history and filter, against bias, flicker and lag
Table gbufferTradeoff(const Options& options);       ///< T10-gbuffer: errors of texture formats
Table lightFeatureTradeoff(const Options& options);  ///< T12-light: each feature on and off
Table lightRuleTradeoff(const Options& options);     ///< T12-light-rules: features always on, by rule and off
Table sphereLightMap(const Options& options);        ///< T13-sphere-light: error by roughness and radius of the light
Table visibilityMap(const Options& options);         ///< T13-visibility: error by distance and angle of view
Table penumbraMap(const Options& options);           ///< T13-penumbra: error by height of the edge and size of the sun

/// The light's part of OPERATING_ENVELOPE.md, as Markdown. `before`: see operatingEnvelope().
std::string lightEnvelope(const std::vector<Table>& tables, const std::string& before);

}  // namespace rubble::tradeoff
