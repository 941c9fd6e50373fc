#include "lightsim/merge_lobes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eikonal::bake {

namespace {

/// What merging two loses of Σ|F|: of E - Σ|F|, the spread of directions within lobes, it is the growth.
double lossOf(const DirectedLight& a, const DirectedLight& b) {
    return glm::length(a.flux) + glm::length(b.flux) - glm::length(a.flux + b.flux);
}

/// Whom each is best merged with.
class Partners {
public:
    explicit Partners(const std::vector<DirectedLight>& light) : light_(light), best_(light.size()) {
        for (std::size_t i = 0; i < light.size(); ++i) {
            find(i);
        }
    }

    /// The one whose merger with its partner, a later one, loses least.
    std::size_t cheapest() const {
        return std::size_t(std::min_element(best_.begin(), best_.end(),
                                            [](const Best& a, const Best& b) { return a.loss < b.loss; }) -
                           best_.begin());
    }
    double loss(std::size_t i) const { return best_[i].loss; }
    std::size_t partner(std::size_t i) const { return best_[i].partner; }

    /// `kept` has taken up `gone`, whose place the last one has taken.
    void update(std::size_t kept, std::size_t gone) {
        const std::size_t last = best_.size() - 1;
        best_.pop_back();
        for (std::size_t i = 0; i < best_.size(); ++i) {
            const std::size_t partner = best_[i].partner;
            if (i == kept || i == gone || partner == kept || partner == gone || partner == last) {
                find(i);
            } else {
                offer(i, kept);
                offer(i, gone);
            }
        }
    }

private:
    struct Best {
        std::size_t partner = 0;
        double loss = std::numeric_limits<double>::infinity();
    };

    void offer(std::size_t i, std::size_t j) {
        if (j > i && j < best_.size()) {
            const double loss = lossOf(light_[i], light_[j]);
            if (loss < best_[i].loss) {
                best_[i] = {j, loss};
            }
        }
    }
    void find(std::size_t i) {
        best_[i] = {};
        for (std::size_t j = i + 1; j < best_.size(); ++j) {
            offer(i, j);
        }
    }

    const std::vector<DirectedLight>& light_;
    std::vector<Best> best_;
};

double powerOf(const std::vector<DirectedLight>& light) {
    double sum = 0.0;
    for (const DirectedLight& one : light) {
        sum += one.power();
    }
    return sum;
}

/// Irradiances scaled, band by band, so that they add up to the voxel's; what no lobe has of a band goes to the strongest.
void matchIrradiance(std::vector<DirectedLight>& lobes, const glm::dvec3& irradiance) {
    glm::dvec3 sum(0.0);
    for (const DirectedLight& lobe : lobes) {
        sum += lobe.irradiance;
    }
    for (int band = 0; band < 3; ++band) {
        for (DirectedLight& lobe : lobes) {
            lobe.irradiance[band] = sum[band] > 0.0 ? lobe.irradiance[band] * (irradiance[band] / sum[band]) : 0.0;
        }
        if (!(sum[band] > 0.0)) {
            lobes.front().irradiance[band] = irradiance[band];
        }
    }
}

/// What the lobes' fluxes miss of the voxel's, by their powers.
void matchFlux(std::vector<DirectedLight>& lobes, const glm::dvec3& flux) {
    glm::dvec3 missing = flux;
    for (const DirectedLight& lobe : lobes) {
        missing -= lobe.flux;
    }
    const double power = powerOf(lobes);
    for (DirectedLight& lobe : lobes) {
        lobe.flux += missing * (lobe.power() / power);
    }
}

} // namespace

DirectedLight& DirectedLight::operator+=(const DirectedLight& other) {
    irradiance += other.irradiance;
    flux += other.flux;
    return *this;
}

DirectedLight directedLight(const glm::vec3& irradiance, const glm::vec3& direction) {
    return {glm::dvec3(irradiance), glm::dvec3(direction) * overBands(irradiance)};
}

DirectedLight directedLight(const LightLobe& lobe) { return directedLight(lobe.irradiance, lobe.direction); }

std::vector<DirectedLight> mergedLobes(std::vector<DirectedLight> light, double tolerance) {
    const double lossAllowed = tolerance * powerOf(light);
    Partners partners(light);
    while (light.size() > 1) {
        const std::size_t kept = partners.cheapest();
        if (light.size() <= kMostLobes && partners.loss(kept) > lossAllowed) {
            break;
        }
        const std::size_t gone = partners.partner(kept);
        light[kept] += light[gone];
        light[gone] = light.back();
        light.pop_back();
        partners.update(kept, gone);
    }
    std::stable_sort(light.begin(), light.end(),
                     [](const DirectedLight& a, const DirectedLight& b) { return a.power() > b.power(); });
    return light;
}

VoxelLobes lobesOfVoxel(std::vector<DirectedLight> lobes, const glm::vec3& irradiance, const glm::vec3& direction) {
    if (lobes.empty()) {
        lobes.push_back(directedLight(irradiance, direction));
    }
    double scale = overBands(irradiance) / powerOf(lobes);
    for (DirectedLight& lobe : lobes) {
        lobe.flux *= scale;
    }
    matchIrradiance(lobes, glm::dvec3(irradiance));
    matchFlux(lobes, directedLight(irradiance, direction).flux);
    VoxelLobes voxel{};
    for (std::size_t i = 0; i < lobes.size(); ++i) {
        const double least = std::max(lobes[i].power(), glm::length(lobes[i].flux));
        voxel[i] = {glm::vec3(lobes[i].irradiance), glm::vec3(least > 0.0 ? lobes[i].flux / least : glm::dvec3(0.0))};
    }
    return voxel;
}

} // namespace eikonal::bake
