#pragma once
#include "tests/tradeoff/report.h"

namespace rubble::tradeoff {

Table walkTradeoff(const Options& options);          ///< T7
Table rayTradeoff(const Options& options);           ///< T8
Table denoiserTradeoff(const Options& options);      ///< T9
Table gbufferTradeoff(const Options& options);       ///< T10-gbuffer
Table lightFeatureTradeoff(const Options& options);  ///< T12-light
Table shadowCellTradeoff(const Options& options);    ///< T6

}  // namespace rubble::tradeoff
