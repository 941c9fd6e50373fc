// The primary rainbow by viewing rays: out of a sphere of water after one reflection inside, against Bouguer's integral through
// the same smoothed profile, and by extrapolation against the sharp sphere.
#include <cmath>
#include <numbers>

#include "tests/support/synthetic_fields.h"
#include "viewer/trace.h"

namespace eikonal {
namespace {

constexpr double kWater = 1.333;    // index at 589 nm
constexpr double kWidth = 1.5;      // b of the boundary [voxels]; voxels are the unit of length here
constexpr double kWindow = 0.04;    // of impact parameters about the bow's [radii]

/// The smoothed sphere's index by distance from its centre.
class WaterSphere {
public:
    explicit WaterSphere(double radius) : radius_(radius) {}

    double radius() const { return radius_; }
    double index(double r) const {
        return 1.0 + (kWater - 1.0) * 0.5 * std::erfc((r - radius_) / (std::sqrt(2.0) * kWidth));
    }
    /// Angle from the direction back to the light at which a ray of impact parameter p leaves after one reflection at the
    /// mirror r = radius, where the index is the mean of both sides' [degrees].
    double bowAngle(double p) const {
        const double far = radius_ + 9.0 * kWidth;
        const double outside = sweptAngle(p, radius_, far) + std::asin(p / far);
        const double inside = sweptAngle(p, turningPoint(p), radius_);
        return 180.0 - glm::degrees(2.0 * outside + 4.0 * inside - std::numbers::pi);
    }

private:
    /// Where n r = p: as far in as the ray goes.
    double turningPoint(double p) const {
        double low = 0.0, high = radius_;
        for (int i = 0; i < 60; ++i) {
            const double middle = 0.5 * (low + high);
            (index(middle) * middle > p ? high : low) = middle;
        }
        return high;
    }
    /// Bouguer: n r sin(angle to the radius) = p, so that the ray sweeps the integral of p dr/(r sqrt(n²r² - p²)). Over the
    /// root of r - low the integrand has no pole; midpoints of 2000 cells are good to 1e-7.
    double sweptAngle(double p, double low, double high) const {
        constexpr int kCells = 2000;
        const double width = std::sqrt(high - low) / kCells;
        double sum = 0.0;
        for (int i = 0; i < kCells; ++i) {
            const double u = (i + 0.5) * width;
            const double r = low + u * u;
            const double nr = index(r) * r;
            sum += 2.0 * u * p / (r * std::sqrt(nr * nr - p * p));
        }
        return sum * width;
    }

    double radius_;
};

struct Bow {
    double impact = 0.0;  ///< impact parameter of its ray [voxels]
    double angle = 0.0;   ///< from the antisolar point [degrees]
};

/// The greatest angle, by golden section.
Bow bowOf(const WaterSphere& sphere) {
    double low = 0.7 * sphere.radius(), high = 0.98 * sphere.radius();
    const double share = 0.5 * (std::sqrt(5.0) - 1.0);
    for (int i = 0; i < 40; ++i) {
        const double left = high - share * (high - low), right = low + share * (high - low);
        if (sphere.bowAngle(left) > sphere.bowAngle(right)) {
            high = right;
        } else {
            low = left;
        }
    }
    return {0.5 * (low + high), sphere.bowAngle(0.5 * (low + high))};
}

/// Eight voxels about the middle of the sphere: rays in that plane stay there, by symmetry.
Fields discOf(const WaterSphere& sphere) {
    const int across = 2 * int(sphere.radius() + 8.0 * kWidth);
    const glm::ivec3 size(across, across, 8);
    return test::sphereFields({-0.5 * glm::dvec3(size), 1.0, size}, sphere.radius(), kWater, kWidth);
}

/// Rays in that plane from all round, impact parameters evenly over the window, offsets -1 to 1 within it.
struct Fan {
    std::vector<TraceRay> rays;
    std::vector<double> offsets;
};

Fan fanAbout(double impact, double radius) {
    constexpr int kDirections = 24, kImpacts = 17;
    Fan fan;
    for (int d = 0; d < kDirections; ++d) {
        const double turn = 2.0 * std::numbers::pi * (d + 0.3) / kDirections;  // along no axis of the voxels
        const glm::dvec3 along(std::cos(turn), std::sin(turn), 0.0), across(-along.y, along.x, 0.0);
        for (int i = 0; i < kImpacts; ++i) {
            const double offset = 2.0 * (i + 0.5) / kImpacts - 1.0;
            fan.rays.push_back({across * (impact + offset * kWindow * radius) - along * (2.0 * radius), along});
            fan.offsets.push_back(offset);
        }
    }
    return fan;
}

/// Top of the parabola that fits values at offsets, evenly spread about 0, best.
double topOfParabola(const std::vector<double>& offsets, const std::vector<double>& values) {
    const double count = double(offsets.size());
    double meanSquare = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        meanSquare += offsets[i] * offsets[i] / count;
        mean += values[i] / count;
    }
    double slope = 0.0, bend = 0.0, bendWeight = 0.0;
    for (std::size_t i = 0; i < offsets.size(); ++i) {
        const double square = offsets[i] * offsets[i] - meanSquare;
        slope += offsets[i] * values[i] / (count * meanSquare);
        bend += square * values[i];
        bendWeight += square * square;
    }
    bend /= bendWeight;
    return mean - bend * meanSquare - slope * slope / (4.0 * bend);
}

/// The bow by the viewer's own rays: the reflection at each one's second crossing.
double tracedBow(const WaterSphere& sphere) {
    Scene scene;
    scene.accuracy.reflections = 1;
    const Fields fields = discOf(sphere);
    const Fan fan = fanAbout(bowOf(sphere).impact, sphere.radius());
    const auto reflections =
        traceReflections(test::sharedContext(), fields, test::effectsOf(scene, fields), scene.accuracy, fan.rays);
    std::vector<double> offsets, angles;
    for (const TraceReflection& reflection : reflections) {
        const double forwards = glm::dot(reflection.at.direction, fan.rays[reflection.ray].direction);
        if (forwards > 0.0) continue;  // mirrored by the outside
        EXPECT_EQ(reflection.generation, 1);
        offsets.push_back(fan.offsets[reflection.ray]);
        angles.push_back(180.0 - glm::degrees(std::acos(forwards)));
    }
    EXPECT_EQ(angles.size(), fan.rays.size()) << "each ray is reflected inside once";
    return topOfParabola(offsets, angles);
}

TEST(Rainbow, OfASmoothedSphereIsItsOwnAndExtrapolatesToWaters) {
    const WaterSphere small(150.0), large(300.0);
    const double ofSmall = tracedBow(small), ofLarge = tracedBow(large);
    // rays are good to 3e-4 rad at a boundary (docs/performance.md) and pass three: 0.03 degrees
    EXPECT_NEAR(ofSmall, bowOf(small).angle, 0.1);
    EXPECT_NEAR(ofLarge, bowOf(large).angle, 0.1);
    // linear in b/R; the next order leaves 0.02 degrees of these two radii by Bouguer's integral
    EXPECT_NEAR(2.0 * ofLarge - ofSmall, 42.08, 0.1);
    RecordProperty("bow of 150 voxels", std::to_string(ofSmall));
    RecordProperty("bow of 300 voxels", std::to_string(ofLarge));
}

} // namespace
} // namespace eikonal
