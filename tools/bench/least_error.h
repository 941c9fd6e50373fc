#pragma once
// What tubes cost at the least error that the method of 2007 reaches.

#include <string>

#include "tools/bench/work_precision.h"

namespace eikonal::bench {

/// Names of methods in the family of irradiance.
inline constexpr const char* kPeakName = "peak (2007)";
inline constexpr const char* kAutoName = "auto";

/// Markdown: for each case and resolution the least error of `peak`, the field evaluations of the cheapest setting that reaches it
/// (but for a hundredth of it), those of the cheapest setting of `auto` whose error is not larger, and their ratio.
std::string comparedWithPeak(const Family& irradiance);

} // namespace eikonal::bench
