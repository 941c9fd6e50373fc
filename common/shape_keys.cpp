// Objects of the scene file: the kind first, then the keys that it has.

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "common/key_builders.h"
#include "common/spelling.h"

namespace eikonal {
namespace {

/// In the order of the variant's alternatives; meshes and volumes are named by their file instead.
constexpr std::array<std::string_view, std::variant_size_v<Shape>> kShapeNames{
    "sphere", "box", "rounded_box", "cylinder", "torus", "prism", "plane", "wine_glass", "wine", "field", "", ""};

template <std::size_t... kIndices>
Shape defaultShape(std::size_t index, std::index_sequence<kIndices...>) {
    Shape shape;
    ((kIndices == index ? void(shape.emplace<kIndices>()) : void()), ...);
    return shape;
}

/// From an object to a member of the shape that it has.
template <class Kind, class Member>
auto inShape(Member Kind::* member) {
    return [member](auto& object) -> auto& { return std::get<Kind>(object.shape).*member; };
}

Key<Object> checkerKey() {
    return {"checker",
            [](Object& object, const toml::node& node, const std::string& key) {
                const toml::array* parts = node.as_array();
                if (!parts || parts->size() != 3)
                    throw wrongValue(node, key, "[[r, g, b], [r, g, b], cell size]");
                constexpr Limits kReflectance{.low = 0.0, .high = 1.0};
                std::get<PlaneShape>(object.shape).checker =
                    Checker{readVector3((*parts)[0], key + "[0]", kReflectance),
                            readVector3((*parts)[1], key + "[1]", kReflectance),
                            readNumber((*parts)[2], key + "[2]", kPositive)};
            },
            [](const Object& object) -> std::optional<std::string> {
                const auto& checker = std::get<PlaneShape>(object.shape).checker;
                if (!checker)
                    return std::nullopt;
                return fmt::format("[{}, {}, {}]", writeVector(checker->a), writeVector(checker->b), checker->cell);
            }};
}

Key<Object> gridsKey() {
    return {"grids",
            [](Object& object, const toml::node& node, const std::string& path) {
                if (!node.is_table())
                    throw wrongValue(node, path, "a table of grid names");
                const std::vector<std::string_view> known(kVolumeGridNames.begin(), kVolumeGridNames.end());
                for (const auto& [key, value] : *node.as_table()) {
                    if (std::find(known.begin(), known.end(), key.str()) == known.end())
                        throw badInput(fmt::format("{}: unknown grid '{}' in {}, expected {}{}",
                                                   describe(positionOf(value)), key.str(), path, listNames(known),
                                                   didYouMean(key.str(), known)));
                    std::get<VolumeShape>(object.shape).grids[std::string(key.str())] =
                        readString(value, fmt::format("{}.{}", path, key.str()));
                }
            },
            [](const Object& object) -> std::optional<std::string> {
                std::string entries;
                for (const auto& [ours, theirs] : std::get<VolumeShape>(object.shape).grids)
                    entries += fmt::format("{}{} = {}", entries.empty() ? "" : ", ", ours, writeString(theirs));
                return entries.empty() ? std::nullopt : std::optional("{ " + entries + " }");
            }};
}

/// true: the domain's width (a given `ior` grid stays as it is), false: by area, a number: that many voxels.
Key<Object> smoothKey() {
    return {"smooth",
            [](Object& object, const toml::node& node, const std::string& key) {
                object.smoothVoxels.reset();
                if (node.is_boolean())
                    object.smoothVoxels = readBool(node, key) ? std::nullopt : std::optional(0.0);
                else if (node.is_number())
                    object.smoothVoxels = readNumber(node, key, kNotNegative);
                else
                    throw wrongValue(node, key, "true, false or voxels, a number >= 0");
            },
            [](const Object& object) -> std::optional<std::string> {
                if (object.smoothVoxels)
                    return *object.smoothVoxels == 0.0 ? "false" : writeNumber(*object.smoothVoxels);
                return std::holds_alternative<VolumeShape>(object.shape) ? std::nullopt : std::optional("true");
            }};
}

constexpr std::pair<std::string_view, Surface> kSurfaces[] = {{"smooth", Surface::kSmooth}, {"rough", Surface::kRough}};

/// Left unwritten while `isDefault` says so.
template <class IsDefault>
Key<Object> unlessDefault(Key<Object> key, IsDefault isDefault) {
    key.write = [write = key.write, isDefault](const Object& object) {
        return isDefault(object) ? std::nullopt : write(object);
    };
    return key;
}

Key<Object> surfaceKey() {
    return unlessDefault(keys::choice<Object>("surface", &Object::surface, Choices<Surface>(kSurfaces)),
                         [](const Object& object) { return object.surface == Surface::kSmooth; });
}

Key<Object> roughnessKey() {
    return unlessDefault(
        keys::number<Object>("roughness", &Object::roughness, {.low = 0.0, .high = 1.0, .lowOpen = true}),
        [](const Object& object) { return object.surface == Surface::kSmooth; });
}

Key<Object> reflectionTintKey() {
    return unlessDefault(
        keys::vector3<Object>("reflection_tint", &Object::reflectionTint, {.low = 0.0, .high = 1.0}),
        [](const Object& object) { return object.reflectionTint == Object{}.reflectionTint; });
}

Key<Object> resolutionKey() {
    return {"resolution",
            [](Object& object, const toml::node& node, const std::string& key) {
                object.resolution = readInteger(node, key, {.low = 1.0, .high = 4096.0});
                object.whereResolution = positionOf(node);
            },
            [](const Object& object) {
                return object.resolution ? std::optional(std::to_string(*object.resolution)) : std::nullopt;
            }};
}

/// Like any quantity, but left unwritten where nobody gave it and that means something: a volume's grids then stand
/// alone, a field then leaves the index as it is.
Key<Object> constant(std::string_view name, Quantity Object::* member, Limits limits, Bands bands) {
    Key<Object> key = keys::quantity<Object>(name, member, limits, bands);
    key.write = [=](const Object& object) -> std::optional<std::string> {
        const bool unsetMatters =
            std::holds_alternative<VolumeShape>(object.shape) || std::holds_alternative<FieldShape>(object.shape);
        if (unsetMatters && !(object.*member).given)
            return std::nullopt;
        return writeQuantity(object.*member, bands);
    };
    return key;
}

} // namespace

std::string_view shapeName(const Shape& shape) { return kShapeNames[shape.index()]; }

Shape readShapeKind(const toml::table& table, const std::string& path) {
    const toml::node* shape = table.get("shape");
    const toml::node* mesh = table.get("mesh");
    const toml::node* volume = table.get("volume");
    if ((shape ? 1 : 0) + (mesh ? 1 : 0) + (volume ? 1 : 0) > 1)
        throw badInput(fmt::format("{}: {}: expected one of 'shape', 'mesh' and 'volume', found several",
                                   describe(positionOf(mesh ? *mesh : *volume)), path));
    if (mesh)
        return MeshShape{};
    if (volume)
        return VolumeShape{};
    std::vector<std::pair<std::string_view, std::size_t>> names;
    for (std::size_t i = 0; i < kShapeNames.size(); ++i)
        if (!kShapeNames[i].empty())
            names.emplace_back(kShapeNames[i], i);
    const std::size_t index = shape ? readChoice(*shape, path + ".shape", Choices<std::size_t>(names)) : 0;
    return defaultShape(index, std::make_index_sequence<std::variant_size_v<Shape>>{});
}

Keys<Object> shapeKeys(const Shape& shape) {
    using keys::number;
    if (std::holds_alternative<SphereShape>(shape))
        return {number<Object>("radius", inShape(&SphereShape::radius), kPositive)};
    if (std::holds_alternative<BoxShape>(shape))
        return {keys::vector3<Object>("size", inShape(&BoxShape::size), kPositive)};
    if (std::holds_alternative<RoundedBoxShape>(shape))
        return {keys::vector3<Object>("size", inShape(&RoundedBoxShape::size), kPositive),
                number<Object>("radius", inShape(&RoundedBoxShape::radius), kNotNegative)};
    if (std::holds_alternative<CylinderShape>(shape))
        return {number<Object>("radius", inShape(&CylinderShape::radius), kPositive),
                number<Object>("height", inShape(&CylinderShape::height), kPositive)};
    if (std::holds_alternative<TorusShape>(shape))
        return {number<Object>("radius", inShape(&TorusShape::radius), kPositive),
                number<Object>("tube", inShape(&TorusShape::tube), kPositive)};
    if (std::holds_alternative<PrismShape>(shape))
        return {number<Object>("side", inShape(&PrismShape::side), kPositive),
                number<Object>("height", inShape(&PrismShape::height), kPositive)};
    if (std::holds_alternative<PlaneShape>(shape))
        return {keys::vector2<Object>("size", inShape(&PlaneShape::size), kPositive), checkerKey()};
    if (std::holds_alternative<WineGlassShape>(shape))
        return {number<Object>("height", inShape(&WineGlassShape::height), kPositive)};
    if (std::holds_alternative<WineShape>(shape))
        return {number<Object>("height", inShape(&WineShape::height), kPositive),
                number<Object>("fill", inShape(&WineShape::fill), {.low = 0.0, .high = 1.0, .lowOpen = true})};
    if (std::holds_alternative<FieldShape>(shape))
        return {keys::vector3<Object>("size", inShape(&FieldShape::size), kPositive)};
    if (std::holds_alternative<MeshShape>(shape))
        return {keys::file<Object>("mesh", inShape(&MeshShape::file))};
    return {keys::file<Object>("volume", inShape(&VolumeShape::file)), gridsKey()};
}

const Keys<Object>& objectKeys() {
    static const Keys<Object> table{
        keys::text<Object>("name", &Object::name),
        constant("ior", &Object::ior, kPositive, Bands::kOne),
        keys::number<Object>("cauchy_b", &Object::cauchyB, kNotNegative),
        constant("absorption", &Object::absorption, kNotNegative, Bands::kThree),
        constant("scattering", &Object::scattering, kNotNegative, Bands::kThree),
        constant("anisotropy", &Object::anisotropy, kAnisotropyRange, Bands::kThree),
        constant("emission", &Object::emission, kNotNegative, Bands::kThree),
        keys::flag<Object>("opaque", &Object::opaque),
        keys::vector3<Object>("albedo", &Object::albedo, {.low = 0.0, .high = 1.0}),
        surfaceKey(),
        roughnessKey(),
        reflectionTintKey(),
        smoothKey(),
        resolutionKey(),
        keys::vector3<Object>("translate", &Object::translate, kAnyNumber),
        keys::vector3<Object>("rotate", &Object::rotate, kAnyNumber),
        keys::number<Object>("scale", &Object::scale, kPositive),
    };
    return table;
}

} // namespace eikonal
