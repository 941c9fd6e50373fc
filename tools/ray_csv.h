#pragma once
// Rays as CSV text for `eikonal trace`.

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "viewer/trace.h"

namespace eikonal {

/// A row of the input: a start and a direction that need not be normalised, as they were written.
struct RayRow {
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};
    std::optional<double> wavelengthNm;
};

/// Reads columns x, y, z, dx, dy, dz and, optionally, wavelength_nm, in any order. Throws badInput with
/// file:line:column for a header with other names, a row with another number of fields, a field that is no finite
/// number, a direction of length zero.
std::vector<RayRow> readRayCsv(const std::filesystem::path& path);

/// The same from a stream; `name` stands in messages.
std::vector<RayRow> readRayCsv(std::istream& stream, const std::string& name);

/// Columns x, y, z, dx, dy, dz, optical_length, length, depth_r, depth_g, depth_b, steps, status; numbers so that they
/// read back the same.
std::string resultsCsv(const std::vector<TraceResult>& results);
/// The same with a column `ray` in front, the row of the input from 0.
std::string pointsCsv(const std::vector<TracePoint>& points);

} // namespace eikonal
