// Lights of the scene file: the type first, then the keys that it has, and how it moves.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "common/key_builders.h"
#include "common/light_motion.h"
#include "common/read_table.h"

namespace eikonal {
namespace {

/// In the order of the variant's alternatives.
constexpr std::array<std::string_view, std::variant_size_v<Light>> kLightTypes{"directional", "point", "spot",
                                                                               "rectangle"};
constexpr Limits kSpotDegrees{.low = 0.0, .high = 360.0, .lowOpen = true};
constexpr Limits kShare{.low = 0.0, .high = 1.0};
constexpr Limits kSampleCount{.low = 1.0, .high = 4096.0};

template <std::size_t... kIndices>
Light defaultLight(std::size_t index, std::index_sequence<kIndices...>) {
    Light light;
    ((kIndices == index ? void(light.emplace<kIndices>()) : void()), ...);
    return light;
}

/// From a light to a member of the kind that it is.
template <class Kind, class Member>
auto inLight(Member Kind::* member) {
    return [member](auto& light) -> auto& { return std::get<Kind>(light).*member; };
}

glm::dvec3 readDirection(const toml::node& node, const std::string& key) {
    const glm::dvec3 direction = readVector3(node, key, kAnyNumber);
    const double length = glm::length(direction);
    if (!(length > 0.0) || !std::isfinite(length))
        throw wrongValue(node, key, "a direction, not of length 0");
    // A unit vector stays as it is, to the last bit: written scenes read back equal.
    const bool unit = std::abs(length - 1.0) < 1e-15;
    return unit ? direction : direction / length;
}

template <class Access>
Key<Light> directionKey(std::string_view name, Access access) {
    return {name,
            [=](Light& light, const toml::node& node, const std::string& key) { access(light) = readDirection(node, key); },
            [=](const Light& light) { return writeVector(access(light)); }};
}

/// A key that may be left out of a keyframe.
template <class Read>
Key<LightKeyframe> keyframeKey(std::string_view name, std::optional<glm::dvec3> LightKeyframe::* member, Read read) {
    return {name,
            [=](LightKeyframe& keyframe, const toml::node& node, const std::string& key) {
                keyframe.*member = read(node, key);
            },
            [=](const LightKeyframe& keyframe) {
                return keyframe.*member ? std::optional(writeVector(*(keyframe.*member))) : std::nullopt;
            }};
}

Keys<LightKeyframe> keyframeKeys(const Light& light) {
    Keys<LightKeyframe> keys{keys::number<LightKeyframe>("frame", &LightKeyframe::frame, kAnyNumber)};
    if (hasPosition(light))
        keys.push_back(keyframeKey("position", &LightKeyframe::position, [](const toml::node& node, const std::string& key) {
            return readVector3(node, key, kAnyNumber);
        }));
    if (hasDirection(light))
        keys.push_back(keyframeKey("direction", &LightKeyframe::direction, readDirection));
    return keys;
}

/// Throws badInput where the way from one direction to the next is not defined.
void checkTurns(const toml::node& node, const std::string& path, const std::vector<LightKeyframe>& keyframes) {
    std::optional<glm::dvec3> last;
    for (const LightKeyframe& keyframe : keyframes) {
        constexpr double kOpposite = -1.0 + 1e-9;
        if (keyframe.direction && last && glm::dot(*last, *keyframe.direction) < kOpposite)
            throw badInput(fmt::format("{}: {}: expected directions less than half a turn apart, found {} and then {}",
                                       describe(positionOf(node)), path, writeVector(*last),
                                       writeVector(*keyframe.direction)));
        last = keyframe.direction ? keyframe.direction : last;
    }
}

std::vector<LightKeyframe> readKeyframes(const Light& light, const toml::node& node, const std::string& path) {
    const toml::array* tables = node.as_array();
    if (!tables)
        throw wrongValue(node, path, "tables headed [[light.keyframe]]");
    std::vector<LightKeyframe> keyframes;
    for (const toml::node& element : *tables) {
        const std::string name = fmt::format("{}.{}", path, keyframes.size());
        const toml::table* table = element.as_table();
        if (!table || !table->contains("frame"))
            throw wrongValue(element, name, "a table with a key 'frame'");
        LightKeyframe keyframe;
        readTable(*table, name, keyframeKeys(light), keyframe);
        if (!keyframes.empty() && !(keyframe.frame > keyframes.back().frame))
            throw badInput(fmt::format("{}: {}.frame: expected frames in ascending order, found {} after {}",
                                       describe(positionOf(element)), name, keyframe.frame, keyframes.back().frame));
        keyframes.push_back(keyframe);
    }
    checkTurns(node, path, keyframes);
    return keyframes;
}

std::string writeKeyframe(const Light& light, const LightKeyframe& keyframe) {
    std::string entries;
    for (const Key<LightKeyframe>& key : keyframeKeys(light))
        if (const auto text = key.write(keyframe))
            entries += fmt::format("{}{} = {}", entries.empty() ? "" : ", ", key.name, *text);
    return "{ " + entries + " }";
}

Key<Light> keyframesKey() {
    return {"keyframe",
            [](Light& light, const toml::node& node, const std::string& key) {
                keyframesOf(light) = readKeyframes(light, node, key);
            },
            [](const Light& light) -> std::optional<std::string> {
                std::string list;
                for (const LightKeyframe& keyframe : keyframesOf(light))
                    list += (list.empty() ? "" : ", ") + writeKeyframe(light, keyframe);
                return list.empty() ? std::nullopt : std::optional("[" + list + "]");
            }};
}

template <class Kind>
Key<Light> positionKey() {
    return keys::vector3<Light>("position", inLight(&Kind::position), kAnyNumber);
}

template <class Kind>
Key<Light> powerKey() {
    return keys::vector3<Light>("power", inLight(&Kind::power), kNotNegative);
}

} // namespace

std::string_view lightTypeName(const Light& light) { return kLightTypes[light.index()]; }

Light readLightKind(const toml::table& table, const std::string& path) {
    std::vector<std::pair<std::string_view, std::size_t>> names;
    for (std::size_t i = 0; i < kLightTypes.size(); ++i)
        names.emplace_back(kLightTypes[i], i);
    const toml::node* type = table.get("type");
    const std::size_t index = type ? readChoice(*type, path + ".type", Choices<std::size_t>(names)) : 0;
    return defaultLight(index, std::make_index_sequence<std::variant_size_v<Light>>{});
}

Keys<Light> lightKeys(const Light& light) {
    if (std::holds_alternative<DirectionalLight>(light))
        return {directionKey("direction", inLight(&DirectionalLight::direction)),
                keys::vector3<Light>("irradiance", inLight(&DirectionalLight::irradiance), kNotNegative),
                keyframesKey()};
    if (std::holds_alternative<PointLight>(light))
        return {positionKey<PointLight>(), powerKey<PointLight>(), keyframesKey()};
    if (std::holds_alternative<SpotLight>(light))
        return {positionKey<SpotLight>(),
                directionKey("direction", inLight(&SpotLight::direction)),
                powerKey<SpotLight>(),
                keys::number<Light>("angle", inLight(&SpotLight::angle), kSpotDegrees),
                keys::number<Light>("blend", inLight(&SpotLight::blend), kShare),
                keyframesKey()};
    return {positionKey<RectangleLight>(),
            directionKey("direction", inLight(&RectangleLight::direction)),
            directionKey("up", inLight(&RectangleLight::up)),
            keys::vector2<Light>("size", inLight(&RectangleLight::size), kPositive),
            powerKey<RectangleLight>(),
            keys::integer<Light>("samples", inLight(&RectangleLight::samples), kSampleCount),
            keyframesKey()};
}

} // namespace eikonal
