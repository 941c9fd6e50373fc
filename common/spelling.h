#pragma once
// 'Did you mean': the nearest of the names that would have been right.

#include <string>
#include <string_view>
#include <vector>

namespace eikonal {

/// ", did you mean 'resolution'?" for the candidate that is few edits away; empty if none is near.
std::string didYouMean(std::string_view word, const std::vector<std::string_view>& candidates);

/// "'a', 'b' or 'c'"
std::string listNames(const std::vector<std::string_view>& names);

} // namespace eikonal
