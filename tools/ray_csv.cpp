#include "tools/ray_csv.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <istream>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "common/error.h"

namespace eikonal {

namespace {

constexpr std::array<std::string_view, 7> kColumns{"x", "y", "z", "dx", "dy", "dz", "wavelength_nm"};
constexpr std::size_t kRequiredColumns = 6;

struct Field {
    std::string_view text;
    std::size_t column = 1;  ///< of its first character in the line, from 1
};

std::string_view trimmed(std::string_view text) {
    const auto first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<Field> split(std::string_view line) {
    std::vector<Field> fields;
    for (std::size_t start = 0;;) {
        const std::size_t comma = line.find(',', start);
        const std::string_view field = trimmed(line.substr(start, comma - start));
        fields.push_back({field, field.empty() ? start + 1 : std::size_t(field.data() - line.data()) + 1});
        if (comma == std::string_view::npos) {
            return fields;
        }
        start = comma + 1;
    }
}

/// Where a message points: file:line:column.
struct Place {
    const std::string& name;
    std::size_t line;

    Error error(std::size_t column, const std::string& message) const {
        return badInput(fmt::format("{}:{}:{}: {}", name, line, column, message));
    }
};

/// For each of kColumns its place in the file's rows, kAbsent if it has none.
constexpr std::size_t kAbsent = std::size_t(-1);
using ColumnPlaces = std::array<std::size_t, kColumns.size()>;

ColumnPlaces parseHeader(std::string_view line, const Place& place) {
    ColumnPlaces places;
    places.fill(kAbsent);
    const std::vector<Field> fields = split(line);
    for (std::size_t i = 0; i < fields.size(); ++i) {
        const auto column = std::find(kColumns.begin(), kColumns.end(), fields[i].text);
        if (column == kColumns.end()) {
            throw place.error(fields[i].column,
                              fmt::format("expected a header of x,y,z,dx,dy,dz and optionally wavelength_nm; found '{}'",
                                          fields[i].text));
        }
        std::size_t& target = places[std::size_t(column - kColumns.begin())];
        if (target != kAbsent) {
            throw place.error(fields[i].column, fmt::format("column '{}' stands twice in the header", fields[i].text));
        }
        target = i;
    }
    for (std::size_t i = 0; i < kRequiredColumns; ++i) {
        if (places[i] == kAbsent) {
            throw place.error(1, fmt::format("expected a header of x,y,z,dx,dy,dz and optionally wavelength_nm; "
                                             "column '{}' is missing", kColumns[i]));
        }
    }
    return places;
}

double parseNumber(const Field& field, const Place& place) {
    double value = 0.0;
    const char* end = field.text.data() + field.text.size();
    const auto [stop, status] = std::from_chars(field.text.data(), end, value);
    if (status != std::errc() || stop != end || !std::isfinite(value)) {
        throw place.error(field.column, fmt::format("expected a finite number, found '{}'", field.text));
    }
    return value;
}

RayRow parseRow(std::string_view line, const ColumnPlaces& places, std::size_t columnCount, const Place& place) {
    const std::vector<Field> fields = split(line);
    if (fields.size() != columnCount) {
        throw place.error(1, fmt::format("expected {} fields as in the header, found {}", columnCount, fields.size()));
    }
    const auto number = [&](std::size_t column) { return parseNumber(fields[places[column]], place); };
    RayRow row;
    row.origin = {number(0), number(1), number(2)};
    row.direction = {number(3), number(4), number(5)};
    if (row.direction == glm::dvec3(0.0)) {
        throw place.error(fields[places[3]].column, "expected a direction (dx, dy, dz) other than zero");
    }
    if (places[6] != kAbsent) {
        row.wavelengthNm = number(6);
        if (*row.wavelengthNm <= 0.0) {
            throw place.error(fields[places[6]].column, fmt::format("expected a wavelength above 0 nm, found {}",
                                                                    fields[places[6]].text));
        }
    }
    return row;
}

constexpr std::string_view kResultHeader =
    "x,y,z,dx,dy,dz,optical_length,length,depth_r,depth_g,depth_b,steps,status\n";

void appendResult(std::string& text, const TraceResult& result) {
    const glm::dvec3& x = result.position;
    const glm::dvec3& d = result.direction;
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{},{}\n", x.x, x.y, x.z, d.x, d.y, d.z,
                   result.opticalLength, result.length, result.depth.r, result.depth.g, result.depth.b,
                   result.evaluations, traceStatusName(result.status));
}

} // namespace

std::string resultsCsv(const std::vector<TraceResult>& results) {
    std::string text(kResultHeader);
    for (const TraceResult& result : results) {
        appendResult(text, result);
    }
    return text;
}

std::string pointsCsv(const std::vector<TracePoint>& points) {
    std::string text = "ray," + std::string(kResultHeader);
    for (const TracePoint& point : points) {
        fmt::format_to(std::back_inserter(text), "{},", point.ray);
        appendResult(text, point.at);
    }
    return text;
}

std::vector<RayRow> readRayCsv(std::istream& stream, const std::string& name) {
    std::string line;
    if (!std::getline(stream, line)) {
        throw badInput(fmt::format("{}:1:1: expected a header of x,y,z,dx,dy,dz; the file is empty", name));
    }
    const ColumnPlaces places = parseHeader(line, Place{name, 1});
    const std::size_t columnCount = split(line).size();
    std::vector<RayRow> rows;
    for (std::size_t number = 2; std::getline(stream, line); ++number) {
        rows.push_back(parseRow(line, places, columnCount, Place{name, number}));
    }
    return rows;
}

std::vector<RayRow> readRayCsv(const std::filesystem::path& path) {
    std::ifstream stream(path);
    if (!stream || std::filesystem::is_directory(path)) {
        throw badInput(fmt::format("{}: expected a CSV file of rays; it cannot be read", path.string()));
    }
    return readRayCsv(stream, path.string());
}

} // namespace eikonal
