// Images against the reference in double precision: at the kernels' step, where rounding alone is between them, and at a
// much finer one.
#include <algorithm>
#include <cmath>
#include <set>

#include "common/accuracy.h"
#include "common/physics.h"
#include "common/reference/image_reference.h"
#include "common/spectrum.h"
#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

using reference::ImageRay;

constexpr int kSize = 24;           // of the images [pixels]
constexpr int kVoxels = 48;         // of the fields, along an edge
constexpr double kDistance = 4.0;   // of the camera from the middle
constexpr double kFov = 30.0;       // the domain fills it nearly

struct Setting {
    Fields fields;
    Scene scene = test::plainScene(glm::dvec3(1.0), kDistance, kFov, kSize);  ///< its camera looks along -z
    BakedLight light;
};

/// Irradiance and direction that vary smoothly, on a lattice of their own: half as fine as the fields'.
BakedLight smoothLight() {
    const Lattice lattice = test::cube(kVoxels / 2, 1.0);
    BakedLight light{lattice, {lattice.size, glm::vec3(0.0f)}, {lattice.size, glm::vec3(0.0f)}};
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        light.irradiance.at(v) =
            glm::vec3(2.0 + x.x, 1.5 + std::sin(2.0 * x.y), 1.0 + 0.5 * std::cos(3.0 * x.z + x.x));
        const double directed = 0.6 + 0.3 * x.y;  // several arrivals in places: |F| < E
        light.lightDirection.at(v) = glm::vec3(directed * glm::normalize(glm::dvec3(0.3 + x.z, -1.0, 0.4 * x.x)));
    });
    return light;
}

/// Coloured, glowing glass in smoke that scatters forwards: every effect but opaque matter.
Setting glassInSmoke() {
    const Lattice lattice = test::cube(kVoxels, 1.0);
    Setting setting{.fields = test::sphereFields(lattice, 0.6, 1.5, 1.5 * lattice.voxel), .light = smoothLight()};
    Fields& fields = setting.fields;
    fields.sigmaA = fields.sigmaS = fields.emission = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f));
    fields.anisotropy = DenseGrid<float>(lattice.size, 0.0f);
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const float inside = float(test::sphereCoverage(lattice, v, 0.6));
        const double height = lattice.worldFromIndex(v).y;
        fields.sigmaA.at(v) = inside * glm::vec3(0.1f, 0.8f, 1.6f);
        fields.sigmaS.at(v) = (1.0f - inside) * glm::vec3(0.5f, 0.4f, 0.3f) * float(1.0 + 0.5 * height);
        fields.anisotropy.at(v) = float(0.5 + 0.2 * height);
        fields.emission.at(v) = float(test::sphereCoverage(lattice, v, 0.3)) * glm::vec3(0.8f, 0.5f, 0.1f);
    });
    setting.scene.environment.gradient = {glm::dvec3(0.9, 0.6, 0.3), glm::dvec3(0.1, 0.3, 0.8)};
    setting.scene.environment.intensity = 1.2;
    return setting;
}

/// A box of opaque matter, its edges along no axis of the voxels, in smoke.
Setting boxInSmoke() {
    Setting setting = glassInSmoke();
    Fields& fields = setting.fields;
    const Lattice lattice = fields.lattice;
    fields.ior = {};
    fields.iorGradient = {};
    fields.interface = {};
    fields.emission = {};
    fields.opaque = DenseGrid<float>(lattice.size, 0.0f);
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f));
    const glm::dmat3 axes(glm::normalize(glm::dvec3(3.0, 1.0, 1.0)), glm::normalize(glm::dvec3(-1.0, 3.0, 0.0)),
                          glm::normalize(glm::cross(glm::dvec3(3.0, 1.0, 1.0), glm::dvec3(-1.0, 3.0, 0.0))));
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        const glm::dvec3 x = lattice.worldFromIndex(v);
        const glm::dvec3 beyond = glm::abs(x * axes) - glm::dvec3(0.5, 0.4, 0.3);
        const double distance = std::max({beyond.x, beyond.y, beyond.z});
        fields.opaque.at(v) = float(glm::clamp(0.5 - distance / lattice.voxel, 0.0, 1.0));
        fields.albedo.at(v) = glm::vec3(0.8, 0.5 + 0.3 * x.x, 0.3);
    });
    return setting;
}

/// The setting with the grids of these effects alone.
Setting only(Setting setting, const std::set<Effect>& effects) {
    Fields& fields = setting.fields;
    if (!effects.contains(Effect::kRefraction)) fields.ior = {}, fields.iorGradient = {};
    if (!effects.contains(Effect::kReflection)) fields.interface = {};
    if (!effects.contains(Effect::kAbsorption)) fields.sigmaA = {};
    if (!effects.contains(Effect::kScattering)) fields.sigmaS = {}, fields.anisotropy = {};
    if (!effects.contains(Effect::kEmission)) fields.emission = {};
    if (!effects.contains(Effect::kOpaque)) fields.opaque = {}, fields.albedo = {};
    return setting;
}

/// The setting with glass that disperses.
Setting dispersing(Setting setting, int bands) {
    setting.fields = test::dispersing(setting.fields, 0.04, 1.5);
    setting.scene.accuracy.bands = bands;
    return setting;
}

/// The setting with smoke that scatters red forwards and blue back.
Setting scatteringByBand(Setting setting) {
    Fields& fields = setting.fields;
    fields.anisotropyByBand = DenseGrid<glm::vec3>(fields.lattice.size, glm::vec3(0.0f));
    for (std::size_t i = 0; i < fields.anisotropy.values.size(); ++i) {
        fields.anisotropyByBand.values[i] = fields.anisotropy.values[i] * glm::vec3(1.0f, 0.3f, -0.8f);
    }
    return setting;
}

/// The setting with reflections followed.
Setting reflecting(Setting setting, int generations) {
    setting.scene.accuracy.reflections = generations;
    return setting;
}

/// The same with a B in no proportion to n - 1, which takes a texture of its own; three bands.
Setting unevenlyDispersing(Setting setting) {
    Setting uneven = dispersing(std::move(setting), 3);
    test::forEachVoxel(uneven.fields.lattice, [&](const glm::ivec3& v) {
        uneven.fields.cauchyB.at(v) *= float(1.0 + 0.5 * uneven.fields.lattice.worldFromIndex(v).x);
    });
    uneven.fields.cauchyGradient = gradientOf(uneven.fields.cauchyB, uneven.fields.lattice.voxel);
    return uneven;
}

/// The light with irradiance that differs from band to band.
BakedLight byBand(BakedLight light, int bands) {
    for (const SpectralBand& band : spectralBands(bands)) {
        DenseGrid<float> irradiance(light.irradiance.size, 0.0f);
        for (std::size_t i = 0; i < irradiance.values.size(); ++i) {
            irradiance.values[i] = light.irradiance.values[i].g * float(band.wavelengthMicrons);
        }
        light.bands.push_back({band.wavelengthNm(), std::move(irradiance)});
    }
    return light;
}

std::vector<glm::dvec3> rendered(const Setting& setting) {
    const RenderResult image = renderScene(test::sharedContext(), setting.scene, setting.fields,
                                           test::effectsOf(setting.scene, setting.fields), &setting.light,
                                           {.straightFlights = false});  // as the reference
    std::vector<glm::dvec3> radiance;
    for (int i = 0; i < kSize * kSize; ++i) radiance.emplace_back(image.radiance(i % kSize, i / kSize));
    return radiance;
}

/// The light of one band, the same in all channels.
BakedLight lightOfBand(const BakedLight& light, std::size_t band) {
    BakedLight result = light;
    for (std::size_t i = 0; i < result.irradiance.values.size() && !light.bands.empty(); ++i) {
        result.irradiance.values[i] = glm::vec3(light.bands[band].irradiance.values[i]);
    }
    return result;
}

/// A ray by the reference: its radiance the sum over bands where something disperses, all else at the reference wavelength.
ImageRay followed(const Setting& setting, const reference::ImageScene& scene, const glm::dvec3& origin,
                  const glm::dvec3& direction, const reference::ImageOptions& options) {
    ImageRay ray = reference::followRay(scene, origin, direction, options);
    if (setting.fields.cauchyB.empty()) return ray;
    ray.radiance = glm::dvec3(0.0);
    const auto bands = spectralBands(setting.scene.accuracy.bands);
    for (std::size_t band = 0; band < bands.size(); ++band) {
        const BakedLight light = lightOfBand(setting.light, band);
        reference::ImageScene ofBand = scene;
        ofBand.light = &light;
        reference::ImageOptions atWavelength = options;
        atWavelength.wavelengthMicrons = bands[band].wavelengthMicrons;
        ray.radiance += bands[band].toRgb *
                        reference::followRay(ofBand, origin, direction, atWavelength).radiance[bands[band].channel];
    }
    return ray;
}

/// The image by the reference, of every `stride`-th pixel each way, every ray's origin shifted.
std::vector<ImageRay> truth(const Setting& setting, double stepVoxels, int stride = 1,
                            const glm::dvec3& shift = glm::dvec3(0.0)) {
    const Environment& around = setting.scene.environment;
    const auto background = [&](const glm::dvec3& direction) {
        return f64::gradientRadiance(direction, around.gradient[0], around.gradient[1]) * around.intensity;
    };
    const reference::GridField field(setting.fields, interpolationOfImages(setting.scene.accuracy));
    const reference::ImageScene scene{field, &setting.light, background,
                                      setting.fields.opaque.empty() ? background : reference::ambientOf(background)};
    const double half = std::tan(glm::radians(setting.scene.camera.fov) / 2.0);
    std::vector<ImageRay> image;
    for (int y = 0; y < kSize; y += stride) {
        for (int x = 0; x < kSize; x += stride) {
            const glm::dvec2 screen = 2.0 * (glm::dvec2(x, y) + 0.5) / double(kSize) - 1.0;
            image.push_back(followed(setting, scene, setting.scene.camera.position + shift,
                                     {screen.x * half, -screen.y * half, -1.0},
                                     {.stepVoxels = stepVoxels, .reflections = setting.scene.accuracy.reflections}));
        }
    }
    return image;
}

/// Every pixel within a tolerance of the reference at the same step, but for rays that the reference itself sees
/// differently by more than that when they start a millionth aside: single precision cannot tell those apart. They are few.
void expectAgreement(Setting setting, double tolerance) {
    setting.scene.accuracy.stepVoxels = 1.0;
    const auto image = rendered(setting);
    const auto exact = truth(setting, 1.0);
    const auto right = truth(setting, 1.0, 1, {1e-6, 0.0, 0.0});
    const auto above = truth(setting, 1.0, 1, {0.0, 1e-6, 0.0});
    int unsteady = 0;
    for (std::size_t i = 0; i < image.size(); ++i) {
        const glm::dvec3 radiance = exact[i].radiance;
        if (std::max(glm::length(right[i].radiance - radiance), glm::length(above[i].radiance - radiance)) > tolerance) {
            ++unsteady;
            continue;
        }
        EXPECT_LE(glm::length(image[i] - radiance), tolerance) << "pixel " << i % kSize << ", " << i / kSize;
    }
    EXPECT_LE(unsteady, kSize * kSize / 50);
}

// Radiances are of the order of 1 and their roundings, of 6e-8, add up along some hundred steps.
constexpr double kRounding = 2e-5;
// The kernel finds a surface to 2^-12 of a step; over that way light, normal and albedo change by as much as this.
constexpr double kRoundingAtSurfaces = 1e-4;

TEST(ImageReference, AgreesOnGlassInSmokeWithEveryEffect) { expectAgreement(glassInSmoke(), kRounding); }

TEST(ImageReference, AgreesOnEachEffectAlone) {
    using enum Effect;
    for (const std::set<Effect>& effects : {std::set{kRefraction}, std::set{kRefraction, kReflection},
                                            std::set{kAbsorption}, std::set{kScattering}, std::set{kEmission}}) {
        SCOPED_TRACE(effectName(*effects.rbegin()));
        expectAgreement(only(glassInSmoke(), effects), kRounding);
    }
}

TEST(ImageReference, AgreesOnDispersingGlassInSmoke) {
    expectAgreement(dispersing(glassInSmoke(), 3), kRounding);
    expectAgreement(unevenlyDispersing(glassInSmoke()), kRounding);
    Setting byBands = dispersing(glassInSmoke(), 4);
    byBands.light = byBand(byBands.light, 4);
    expectAgreement(byBands, kRounding);
}

TEST(ImageReference, AgreesOnAnIndexInterpolatedByCubics) {
    Setting setting = glassInSmoke();
    setting.scene.accuracy.interpolation = Interpolation::kCubic;
    expectAgreement(setting, kRounding);
    setting = unevenlyDispersing(setting);
    expectAgreement(setting, kRounding);
}

TEST(ImageReference, AgreesOnOpaqueMatterInSmokeAndAlone) {
    expectAgreement(boxInSmoke(), kRoundingAtSurfaces);
    expectAgreement(only(boxInSmoke(), {Effect::kOpaque}), kRoundingAtSurfaces);
}

/// In every other layer of voxels the light comes as two or three lobes, about as bright as without.
void giveLobes(BakedLight& light) {
    for (std::uint32_t voxel = 0; voxel < light.irradiance.values.size(); ++voxel) {
        const glm::vec3 whole = light.irradiance.values[voxel], direction = light.lightDirection.values[voxel];
        if (voxel / std::uint32_t(light.lattice.size.x) % 4 < 2) {
            light.lobes.voxels.push_back(voxel);
            const LightLobe third{voxel % 2 == 0 ? 0.1f * whole : glm::vec3(0.0f), glm::vec3(0.0f, 0.5f, 0.5f)};
            light.lobes.rows.push_back(
                {LightLobe{0.6f * whole, direction}, LightLobe{0.3f * whole, glm::vec3(0.9f, 0.1f, 0.0f)}, third});
        }
    }
}

TEST(ImageReference, AgreesOnLightOfSeveralLobes) {
    Setting setting = glassInSmoke();
    giveLobes(setting.light);
    expectAgreement(setting, kRounding);
    expectAgreement(scatteringByBand(setting), kRounding);
}

TEST(ImageReference, AgreesOnSmokeThatScattersBandsOtherwise) {
    expectAgreement(scatteringByBand(glassInSmoke()), kRounding);
    expectAgreement(scatteringByBand(boxInSmoke()), kRoundingAtSurfaces);
    expectAgreement(scatteringByBand(dispersing(glassInSmoke(), 3)), kRounding);
}

TEST(ImageReference, AgreesOnReflectionsThatAreFollowed) {
    expectAgreement(reflecting(glassInSmoke(), 1), kRounding);
    expectAgreement(reflecting(glassInSmoke(), 3), kRounding);
    expectAgreement(reflecting(dispersing(glassInSmoke(), 3), 2), kRounding);
    Setting aboutABox = glassInSmoke();
    aboutABox.fields.opaque = boxInSmoke().fields.opaque;
    aboutABox.fields.albedo = boxInSmoke().fields.albedo;
    expectAgreement(reflecting(aboutABox, 2), kRoundingAtSurfaces);
}

TEST(ImageReference, AgreesWithACameraInsideGlass) {
    Setting setting = glassInSmoke();
    setting.scene.camera.position = {0.1, 0.05, 0.3};
    setting.scene.camera.lookAt = {0.1, 0.05, 0.0};
    expectAgreement(setting, kRounding);
}

/// Differences of the radiance from the truth as shares of its mean, in ascending order.
std::vector<double> relativeErrors(const std::vector<glm::dvec3>& image, const std::vector<ImageRay>& exact) {
    double mean = 0.0;
    for (const ImageRay& ray : exact) mean += glm::length(ray.radiance) / double(exact.size());
    std::vector<double> errors;
    for (std::size_t i = 0; i < image.size(); ++i) errors.push_back(glm::length(image[i] - exact[i].radiance) / mean);
    std::sort(errors.begin(), errors.end());
    return errors;
}

double rms(const std::vector<double>& errors) {
    double sum = 0.0;
    for (const double error : errors) sum += error * error;
    return std::sqrt(sum / double(errors.size()));
}

TEST(ImageReference, TheViewersOwnStepIsEnough) {
    const Setting glass = glassInSmoke(), box = boxInSmoke();
    const auto ofGlass = relativeErrors(rendered(glass), truth(glass, 0.1));
    // Steps of nearly a voxel sample a band of a few: near the sphere's rim, where reflectance rises steeply with the
    // angle, its normal is some degrees off.
    EXPECT_LE(rms(ofGlass), glass.scene.accuracy.tolerance);
    EXPECT_LE(ofGlass[ofGlass.size() * 19 / 20], 0.01);
    // Straight rays: the midpoint rule for smooth matter, and a surface that is found whatever the step.
    EXPECT_LE(rms(relativeErrors(rendered(box), truth(box, 0.1))), 3e-4);
    RecordProperty("rms", std::to_string(rms(ofGlass)));
}

struct StepErrors {
    double radiance = 0.0, direction = 0.0;  ///< mean and root mean square over the image
};

/// Errors of the reference by its step, for steps of 1, 1/2, ..., 1/16 voxel, against one of 1/64.
std::vector<StepErrors> errorsByStep(const Setting& setting) {
    const int stride = 2;
    const auto exact = truth(setting, 1.0 / 64.0, stride);
    std::vector<StepErrors> rows;
    for (int halvings = 0; halvings <= 4; ++halvings) {
        const auto image = truth(setting, std::exp2(-halvings), stride);
        StepErrors sum;
        for (std::size_t i = 0; i < image.size(); ++i) {
            const glm::dvec3 turned = image[i].direction - exact[i].direction;
            sum.radiance += glm::length(image[i].radiance - exact[i].radiance) / double(image.size());
            sum.direction += glm::dot(turned, turned) / double(image.size());
        }
        rows.push_back({sum.radiance, std::sqrt(sum.direction)});
    }
    return rows;
}

/// Mean order of convergence over so many halvings.
double orderOf(double atFirst, double atLast, int halvings = 4) { return std::log2(atFirst / atLast) / halvings; }

TEST(ImageReference, ConvergesAsItsStepsDo) {
    // Rays that reach no farther out than three quarters of the radius: those at the rim graze the boundary at one step and
    // cross it at the next, and have no order.
    Setting middle = glassInSmoke();
    middle.scene.camera.fov = glm::degrees(2.0 * std::atan(0.32 / kDistance));
    const auto glass = errorsByStep(middle);
    // Leapfrog and the midpoint rule are of second order, but for the first halvings: trilinear fields have a kink at every
    // voxel. A Fresnel term falls on a sample: first order, from a quarter of a voxel on; at longer steps errors of either sign
    // happen to cancel.
    EXPECT_GE(orderOf(glass.front().direction, glass.back().direction), 1.5);
    EXPECT_GE(orderOf(glass[2].radiance, glass.back().radiance, 2), 0.9);
    const auto smoke = errorsByStep(only(glassInSmoke(), {Effect::kAbsorption, Effect::kScattering, Effect::kEmission}));
    EXPECT_GE(orderOf(smoke.front().radiance, smoke.back().radiance), 1.5);
}

} // namespace
} // namespace eikonal
