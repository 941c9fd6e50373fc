// Sections of the scene file other than objects and lights.

#include "common/scene_keys.h"

#include <algorithm>

#include <fmt/format.h>

#include "common/accuracy.h"
#include "common/effects.h"
#include "common/key_builders.h"
#include "common/spelling.h"

namespace eikonal {
namespace {

constexpr std::pair<std::string_view, Deposit> kDeposits[] = {
    {"auto", Deposit::kAuto}, {"splat", Deposit::kSplat}, {"cells", Deposit::kCells}, {"peak", Deposit::kPeak}};
constexpr std::pair<std::string_view, Directional> kDirectionals[] = {
    {"auto", Directional::kAuto}, {"mean", Directional::kMean}, {"lobes", Directional::kLobes}};
constexpr std::pair<std::string_view, PixelFilter> kPixelFilters[] = {{"box", PixelFilter::kBox},
                                                                     {"tent", PixelFilter::kTent},
                                                                     {"gaussian", PixelFilter::kGaussian},
                                                                     {"blackman-harris", PixelFilter::kBlackmanHarris}};
constexpr std::pair<std::string_view, ToneMap> kToneMaps[] = {
    {"agx", ToneMap::kAgx}, {"reinhard", ToneMap::kReinhard}, {"none", ToneMap::kNone}};

constexpr Limits kFilterWidths{.low = 0.0, .high = 16.0, .lowOpen = true};

std::optional<std::string> written(const std::string& value) { return value; }

Key<Accuracy> toleranceKey() {
    // Darkness is off by 1: no target.
    Key<Accuracy> key = keys::number<Accuracy>("tolerance", &Accuracy::tolerance,
                                               {.low = 0.0, .high = 1.0, .lowOpen = true, .highOpen = true});
    key.form.usual = {0.005, 0.5};
    return key;
}

Key<Environment> imageKey() {
    return {"image",
            [](Environment& environment, const toml::node& node, const std::string& key) {
                environment.image = readString(node, key);
            },
            [](const Environment& environment) {
                return environment.image ? written(writeString(environment.image->generic_string())) : std::nullopt;
            }};
}

/// Shorthand for a gradient of two equal colours.
Key<Environment> colorKey() {
    return {"color",
            [](Environment& environment, const toml::node& node, const std::string& key) {
                environment.gradient.fill(readVector3(node, key, kNotNegative));
                environment.isOneColour = true;
            },
            [](const Environment& environment) {
                const bool isSaid = environment.isOneColour && !environment.image;
                return isSaid ? written(writeVector(environment.gradient[0])) : std::nullopt;
            }};
}

Key<Environment> gradientKey() {
    return {"gradient",
            [](Environment& environment, const toml::node& node, const std::string& key) {
                const toml::array* colors = node.as_array();
                if (!colors || colors->size() != 2)
                    throw wrongValue(node, key, "[[horizon r, g, b], [zenith r, g, b]]");
                for (std::size_t i = 0; i < 2; ++i)
                    environment.gradient[i] =
                        readVector3((*colors)[i], fmt::format("{}[{}]", key, i), kNotNegative);
            },
            [](const Environment& environment) {
                const bool isSaid = !environment.isOneColour && !environment.image;
                return isSaid ? written(fmt::format("[{}, {}]", writeVector(environment.gradient[0]),
                                                    writeVector(environment.gradient[1])))
                              : std::nullopt;
            }};
}

Key<RenderSettings> sizeKey() {
    constexpr Limits kPixels{.low = 1.0, .high = 32768.0};
    return {"size",
            [=](RenderSettings& render, const toml::node& node, const std::string& key) {
                const toml::array* size = node.as_array();
                if (!size || size->size() != 2)
                    throw wrongValue(node, key, "[width, height] in pixels");
                for (int i = 0; i < 2; ++i)
                    render.size[i] = readInteger((*size)[std::size_t(i)], fmt::format("{}[{}]", key, i), kPixels);
            },
            [](const RenderSettings& render) { return fmt::format("[{}, {}]", render.size.x, render.size.y); }};
}

std::vector<std::string> readEffects(const toml::node& node, const std::string& key) {
    const toml::array* list = node.as_array();
    if (!list)
        throw wrongValue(node, key, "'auto' or a list of effects");
    std::vector<std::pair<std::string_view, Effect>> names;
    for (int i = 0; i <= int(Effect::kEnvironment); ++i)
        names.emplace_back(effectName(Effect(i)), Effect(i));
    std::vector<std::string> allowed;
    for (const toml::node& item : *list)
        allowed.emplace_back(effectName(readChoice(item, key, Choices<Effect>(names))));
    return allowed;
}

Key<RenderSettings> effectsKey() {
    return {"effects",
            [](RenderSettings& render, const toml::node& node, const std::string& key) {
                render.effects.reset();
                if (node.value<std::string_view>() != "auto")
                    render.effects = readEffects(node, key);
            },
            [](const RenderSettings& render) {
                if (!render.effects)
                    return writeString("auto");
                std::string list;
                for (const std::string& name : *render.effects)
                    list += (list.empty() ? "" : ", ") + writeString(name);
                return "[" + list + "]";
            }};
}

} // namespace

const Keys<Domain>& domainKeys() {
    static const Keys<Domain> table{
        keys::vector3<Domain>("min", &Domain::min, kAnyNumber),
        keys::vector3<Domain>("max", &Domain::max, kAnyNumber),
        keys::integer<Domain>("resolution", &Domain::resolution, {.low = 1.0, .high = 4096.0}),
        keys::number<Domain>("smooth", &Domain::smoothVoxels, kNotNegative),
        keys::quantity<Domain>("ior", &Domain::ior, kPositive, Bands::kOne),
    };
    return table;
}

const Keys<Medium>& mediumKeys() {
    static const Keys<Medium> table{
        keys::quantity<Medium>("scattering", &Medium::scattering, kNotNegative, Bands::kThree),
        keys::quantity<Medium>("absorption", &Medium::absorption, kNotNegative, Bands::kThree),
        keys::quantity<Medium>("anisotropy", &Medium::anisotropy, kAnisotropyRange, Bands::kThree),
    };
    return table;
}

const Keys<Camera>& cameraKeys() {
    static const Keys<Camera> table{
        keys::vector3<Camera>("position", &Camera::position, kAnyNumber),
        keys::vector3<Camera>("look_at", &Camera::lookAt, kAnyNumber),
        keys::vector3<Camera>("up", &Camera::up, kAnyNumber),
        keys::number<Camera>("fov", &Camera::fov, {.low = 0.0, .high = 180.0, .lowOpen = true, .highOpen = true}),
        keys::number<Camera>("aperture", &Camera::aperture, kNotNegative),
        keys::numberOrAuto<Camera>("focus", &Camera::focus, kPositive, "'auto' or a distance, a number > 0"),
    };
    return table;
}

const Keys<Environment>& environmentKeys() {
    static const Keys<Environment> table{
        imageKey(),
        colorKey(),
        gradientKey(),
        keys::number<Environment>("rotate", &Environment::rotate, kAnyNumber),
        keys::number<Environment>("intensity", &Environment::intensity, kNotNegative),
        keys::flag<Environment>("bake", &Environment::bake),
        keys::integer<Environment>("lights", &Environment::lights, {.low = 1.0, .high = 4096.0}),
    };
    return table;
}

const Keys<Accuracy>& accuracyKeys() {
    static const Keys<Accuracy> table{
        toleranceKey(),
        keys::choice<Accuracy>("integrator", &Accuracy::integrator, Choices<Integrator>(kIntegrators)),
        keys::choice<Accuracy>("interpolation", &Accuracy::interpolation, Choices<Interpolation>(kInterpolations)),
        keys::numberOrAuto<Accuracy>("step", &Accuracy::stepVoxels, kPositive, "'auto' or voxels, a number > 0"),
        keys::choice<Accuracy>("deposit", &Accuracy::deposit, Choices<Deposit>(kDeposits)),
        keys::choice<Accuracy>("directional", &Accuracy::directional, Choices<Directional>(kDirectionals)),
        keys::integer<Accuracy>("reflections", &Accuracy::reflections, {.low = 0.0, .high = 8.0}),
        keys::integer<Accuracy>("bands", &Accuracy::bands, {.low = 3.0, .high = 64.0}),
    };
    return table;
}

const Keys<RenderSettings>& renderKeys() {
    static const Keys<RenderSettings> table{
        sizeKey(),
        keys::integer<RenderSettings>("samples", &RenderSettings::samples, {.low = 1.0, .high = 1e6}),
        keys::number<RenderSettings>("noise", &RenderSettings::noise, {.low = 0.0, .high = 1.0}),
        keys::choice<RenderSettings>("filter", &RenderSettings::filter, Choices<PixelFilter>(kPixelFilters)),
        keys::numberOrAuto<RenderSettings>("filter_width", &RenderSettings::filterWidth, kFilterWidths,
                                           "'auto' or pixels, a number > 0 and at most 16"),
        keys::number<RenderSettings>("exposure", &RenderSettings::exposureEv, {.low = -100.0, .high = 100.0}),
        keys::choice<RenderSettings>("tone_map", &RenderSettings::toneMap, Choices<ToneMap>(kToneMaps)),
        effectsKey(),
    };
    return table;
}

} // namespace eikonal
