#pragma once
// `--set key.path=value` edits the table of a scene file before it is read.

#include <string>

#include <toml++/toml.h>

namespace eikonal {

/// The value is TOML; what is no TOML is taken as a string, so that `accuracy.integrator=rk4` needs no quotes.
/// Throws Error with kUsage for text without '=', badInput for a path that leads nowhere.
void applyOverride(toml::table& scene, const std::string& override);

} // namespace eikonal
