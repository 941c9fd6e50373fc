#include "viewer/window/error_estimate.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/accuracy.h"

namespace eikonal::window {

namespace {

/// Sums of differences and of values.
struct Sums {
    double differences = 0.0, values = 0.0;

    void add(const glm::vec3& value, const glm::vec3& other) {
        for (int band = 0; band < 3; ++band) {
            differences += std::abs(double(value[band]) - double(other[band]));
            values += std::abs(double(value[band]));
        }
    }
    double share() const { return values > 0.0 ? differences / values : 0.0; }
};

} // namespace

ErrorEstimate::ErrorEstimate(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                             const BakedLight* light, const glm::ivec2& size)
    : image_(context, scene, fields, effects, light, {}), samples_(std::max(scene.render.samples / 2, 1)) {
    image_.setStep(2.0 * stepVoxelsOf(scene.accuracy));
    image_.setFrame(size, {{0, 0}, size});
}

double ErrorEstimate::differenceFrom(const ProgressiveImage& picture) const {
    const auto film = picture.film(), other = image_.film();
    assert(film.size() == other.size());
    Sums sums;
    for (std::size_t i = 0; i < film.size(); ++i) sums.add(film[i].radiance, other[i].radiance);
    return sums.share();
}

double differenceOf(const BakedLight& light, const BakedLight& other) {
    assert(light.irradiance.values.size() == other.irradiance.values.size());
    Sums sums;
    for (std::size_t i = 0; i < light.irradiance.values.size(); ++i) {
        sums.add(light.irradiance.values[i], other.irradiance.values[i]);
    }
    return sums.share();
}

} // namespace eikonal::window
