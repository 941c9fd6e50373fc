#include "common/environment_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace eikonal {

namespace {

/// Cells min <= (x, y) < max of the map, and their power per unit area, all bands.
struct Region {
    glm::ivec2 min, max;
    double power;
};

/// Power per unit area of any rectangle of cells, from sums over those that begin at the map's corner.
class PowerTable {
public:
    explicit PowerTable(const EnvironmentCells& cells)
        : stride_(std::size_t(cells.size().x) + 1), sums_(stride_ * (std::size_t(cells.size().y) + 1), 0.0) {
        for (int y = 0; y < cells.size().y; ++y) {
            double row = 0.0;
            for (int x = 0; x < cells.size().x; ++x) {
                const glm::dvec3 radiance = cells.radiance(x, y);
                row += (radiance.x + radiance.y + radiance.z) * cells.solidAngle(y);
                sums_[index(x + 1, y + 1)] = sums_[index(x + 1, y)] + row;
            }
        }
    }

    Region region(const glm::ivec2& min, const glm::ivec2& max) const {
        const double power = sums_[index(max.x, max.y)] - sums_[index(min.x, max.y)] - sums_[index(max.x, min.y)] +
                             sums_[index(min.x, min.y)];
        return {min, max, std::max(power, 0.0)};  // differences of sums leave rounding where the map is black
    }

private:
    std::size_t index(int x, int y) const { return std::size_t(y) * stride_ + std::size_t(x); }

    std::size_t stride_;
    std::vector<double> sums_;
};

/// The axis of cells along which a region is longer on the sphere, if it can be cut there.
std::optional<int> longerAxis(const Region& region, const glm::ivec2& mapSize) {
    const glm::ivec2 cells = region.max - region.min;
    if (cells.x <= 1 && cells.y <= 1) {
        return std::nullopt;
    }
    if (cells.x <= 1 || cells.y <= 1) {
        return cells.x <= 1 ? 1 : 0;
    }
    const double polar = std::numbers::pi * 0.5 * (region.min.y + region.max.y) / mapSize.y;
    const double width = 2.0 * std::numbers::pi * cells.x / mapSize.x * std::sin(polar);
    return width >= std::numbers::pi * cells.y / mapSize.y ? 0 : 1;
}

std::pair<Region, Region> halves(const PowerTable& table, const Region& region, int axis) {
    std::pair<Region, Region> best;
    double leastDifference = std::numeric_limits<double>::infinity();
    for (int cut = region.min[axis] + 1; cut < region.max[axis]; ++cut) {
        glm::ivec2 firstMax = region.max, secondMin = region.min;
        firstMax[axis] = secondMin[axis] = cut;
        const std::pair parts{table.region(region.min, firstMax), table.region(secondMin, region.max)};
        const double difference = std::abs(parts.first.power - parts.second.power);
        if (difference < leastDifference) {
            leastDifference = difference;
            best = parts;
        }
    }
    return best;
}

std::vector<Region> medianCut(const EnvironmentCells& cells, int count) {
    const PowerTable table(cells);
    std::vector<Region> regions{table.region(glm::ivec2(0), cells.size())};
    std::vector<Region> whole;  // of one cell
    while (!regions.empty() && int(regions.size() + whole.size()) < count) {
        const auto brightest = std::max_element(regions.begin(), regions.end(), [](const Region& a, const Region& b) {
            return a.power < b.power;
        });
        const Region region = *brightest;
        regions.erase(brightest);
        if (const std::optional<int> axis = longerAxis(region, cells.size())) {
            const auto [first, second] = halves(table, region, *axis);
            regions.push_back(first);
            regions.push_back(second);
        } else {
            whole.push_back(region);
        }
    }
    regions.insert(regions.end(), whole.begin(), whole.end());
    return regions;
}

DirectionalLight lightOf(const EnvironmentCells& cells, const Region& region) {
    glm::dvec3 irradiance(0.0), flux(0.0);
    for (int y = region.min.y; y < region.max.y; ++y) {
        for (int x = region.min.x; x < region.max.x; ++x) {
            const glm::dvec3 power = cells.radiance(x, y) * cells.solidAngle(y);
            irradiance += power;
            flux -= cells.direction(x, y) * (power.x + power.y + power.z);
        }
    }
    // Where arrivals from all sides cancel, any direction is as good.
    const double length = glm::length(flux);
    const bool cancelled = length < 1e-9 * (irradiance.x + irradiance.y + irradiance.z);
    const glm::ivec2 middle = (region.min + region.max) / 2;
    return {cancelled ? -cells.direction(middle.x, middle.y) : flux / length, irradiance, {}};
}

} // namespace

std::vector<DirectionalLight> environmentLights(const EnvironmentCells& cells, int count) {
    std::vector<DirectionalLight> lights;
    for (const Region& region : medianCut(cells, count)) {
        if (const DirectionalLight light = lightOf(cells, region); light.irradiance != glm::dvec3(0.0)) {
            lights.push_back(light);
        }
    }
    return lights;
}

} // namespace eikonal
