#pragma once
// What a scene file says (docs/scene.md), with its defaults. Plain data: parsed by scene_toml, composed by fields.
// Lengths in scene units, angles in degrees, colours linear Rec.709.

#include <array>
#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <glm/glm.hpp>

namespace eikonal {

/// Where a value stands in a scene file; line 0: a default, or given on the command line.
struct SourcePosition {
    std::string file;
    int line = 0;
    int column = 0;
};

/// "file:line:column", or the file alone where there is no line.
std::string describe(const SourcePosition& position);
/// Whether `--set` said it.
bool isOnCommandLine(const SourcePosition& position);

/// A number or an expression in x, y, z, r, one per band: `0.4`, `[0.1, 0.8, 0.9]`, `"1 + 0.1*exp(-y)"`.
struct Quantity {
    glm::dvec3 constant{0.0};
    std::optional<std::string> expression;  ///< when set, `constant` is unused; the same value for all bands
    SourcePosition where;
    bool given = false;  ///< false: nobody said; a volume's grid of that name then stands alone

    bool isConstant() const { return !expression; }
    bool isZero() const { return isConstant() && constant == glm::dvec3(0.0); }
};

struct Domain {
    glm::dvec3 min{-1.0};
    glm::dvec3 max{1.0};
    int resolution = 128;         ///< voxels along the longest side
    double smoothVoxels = 1.5;    ///< width b of objects' boundaries
    Quantity ior{.constant = glm::dvec3(1.0), .expression = std::nullopt, .where = {}};
};

struct Medium {
    Quantity scattering, absorption;  ///< per scene unit
    Quantity anisotropy;              ///< Henyey-Greenstein g
};

/// Where the shape of an object comes from.
struct SphereShape { double radius = 0.5; };
struct BoxShape { glm::dvec3 size{1.0}; };
struct RoundedBoxShape { glm::dvec3 size{1.0}; double radius = 0.1; };
struct CylinderShape { double radius = 0.5, height = 1.0; };   ///< axis y
struct TorusShape { double radius = 0.5, tube = 0.15; };       ///< axis y
struct PrismShape { double side = 1.0, height = 1.0; };        ///< equilateral triangle in xy, extruded along z
struct Checker { glm::dvec3 a{0.8}, b{0.2}; double cell = 0.25; };
struct PlaneShape { glm::dvec2 size{2.0}; std::optional<Checker> checker; };  ///< horizontal, solid below y = 0
struct WineGlassShape { double height = 1.5; };                ///< centred; wall 3 % of the height
struct WineShape { double height = 1.5, fill = 0.4; };         ///< liquid in the glass of that height; fill of its depth
struct FieldShape { glm::dvec3 size{2.0}; };                   ///< no boundary: constants are expressions over its box
struct MeshShape { std::filesystem::path file; };
/// What a volume file may hold, by our names; a level set counts as `density`.
inline constexpr std::array<std::string_view, 8> kVolumeGridNames{"ior",      "absorption", "scattering", "anisotropy",
                                                                 "emission", "opaque",     "albedo",     "density"};
struct VolumeShape {
    std::filesystem::path file;
    std::map<std::string, std::string> grids;  ///< our name -> name in the file; kVolumeGridNames
};
using Shape = std::variant<SphereShape, BoxShape, RoundedBoxShape, CylinderShape, TorusShape, PrismShape, PlaneShape,
                           WineGlassShape, WineShape, FieldShape, MeshShape, VolumeShape>;

/// What the boundary of an object looks like.
enum class Surface { kSmooth, kRough };

struct Object {
    std::string name;
    Shape shape;
    Quantity ior{.constant = glm::dvec3(1.5), .expression = std::nullopt, .where = {}};
    double cauchyB = 0.0;  ///< [µm²]
    Quantity absorption, scattering, anisotropy, emission;  ///< ignored where opaque, as is `ior`
    bool opaque = false;
    glm::dvec3 albedo{0.8};
    Surface surface = Surface::kSmooth;
    double roughness = 0.3;          ///< of a rough surface, 0 to 1: GGX with alpha = roughness²
    glm::dvec3 reflectionTint{1.0};  ///< factor on what the boundary reflects
    std::optional<double> smoothVoxels;  ///< boundary width; 0: by area; unset: the domain's (the grid's own for volumes)
    std::optional<int> resolution;
    SourcePosition whereResolution;
    glm::dvec3 translate{0.0}, rotate{0.0};
    double scale = 1.0;
    SourcePosition where;  ///< of its table, or of a file that the command line names in it

    glm::dmat4 worldFromLocal() const;  ///< translate · Rz Ry Rx · scale
};

/// Where a light is, or where it shines to, at a frame of a sequence. Between keyframes both are interpolated
/// (common/light_motion.h).
struct LightKeyframe {
    double frame = 0.0;
    std::optional<glm::dvec3> position, direction;  ///< unset: nothing is said about it at this frame
};

struct DirectionalLight {
    glm::dvec3 direction{1.0, 0.0, 0.0};  ///< of travel, unit
    glm::dvec3 irradiance{1.0};           ///< power per unit area across the beam
    std::vector<LightKeyframe> keyframes; ///< by ascending frame, here and below
};
struct PointLight {
    glm::dvec3 position{0.0, 2.0, 0.0};
    glm::dvec3 power{10.0};  ///< isotropic
    std::vector<LightKeyframe> keyframes;
};
struct SpotLight {
    glm::dvec3 position{0.0, 2.0, 0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0};  ///< of travel along the axis, unit
    glm::dvec3 power{10.0};                ///< all that it emits
    double angle = 40.0;                   ///< of the whole cone [degrees]
    double blend = 0.15;                   ///< share of half the angle over which it fades
    std::vector<LightKeyframe> keyframes;
};
struct RectangleLight {
    glm::dvec3 position{0.0, 2.0, 0.0};    ///< centre
    glm::dvec3 direction{0.0, -1.0, 0.0};  ///< normal of the side that emits, Lambertian; unit
    glm::dvec3 up{0.0, 1.0, 0.0};          ///< the height runs along its part across `direction`; unit
    glm::dvec2 size{1.0};                  ///< width, height
    glm::dvec3 power{10.0};                ///< all that it emits
    int samples = 16;                      ///< point-like sources that stand for it, at most
    std::vector<LightKeyframe> keyframes;
};
using Light = std::variant<DirectionalLight, PointLight, SpotLight, RectangleLight>;

struct Camera {
    glm::dvec3 position{0.0, 0.0, 4.0}, lookAt{0.0}, up{0.0, 1.0, 0.0};
    double fov = 35.0;            ///< vertical [degrees]
    double aperture = 0.0;        ///< diameter of the thin lens; 0: a pinhole, all is sharp
    std::optional<double> focus;  ///< distance of the plane in focus, along the view; unset: that of lookAt

    double focusDistance() const { return focus.value_or(glm::length(lookAt - position)); }
};

struct Environment {
    std::optional<std::filesystem::path> image;  ///< latitude-longitude, +Y up, centre +Z, +X at u = 0.25
    std::array<glm::dvec3, 2> gradient{glm::dvec3(0.85, 0.9, 1.0), glm::dvec3(0.25, 0.45, 0.85)};  ///< horizon, zenith
    bool isOneColour = false;  ///< said as `color`; both ends of the gradient are then that
    double rotate = 0.0;
    double intensity = 1.0;
    bool bake = false;
    int lights = 32;  ///< directional lights that stand for it in the bake, at most
};

enum class Integrator { kAuto, kEuler, kLeapfrog, kRk4, kSharma };
enum class Interpolation { kAuto, kLinear, kCubic };
enum class Deposit { kAuto, kSplat, kCells, kPeak };
enum class Directional { kAuto, kMean, kLobes };

struct Accuracy {
    double tolerance = 0.02;
    Integrator integrator = Integrator::kAuto;
    Interpolation interpolation = Interpolation::kAuto;
    std::optional<double> stepVoxels;  ///< unset: auto
    Deposit deposit = Deposit::kAuto;
    Directional directional = Directional::kAuto;
    int reflections = 0;
    int bands = 3;
};

enum class ToneMap { kAgx, kReinhard, kNone };
enum class PixelFilter { kBox, kTent, kGaussian, kBlackmanHarris };

struct RenderSettings {
    glm::ivec2 size{800, 600};
    int samples = 1;           ///< in each pixel, at most
    double noise = 0.0;        ///< relative standard error at which sampling ends; 0: all samples are taken
    PixelFilter filter = PixelFilter::kBox;
    std::optional<double> filterWidth;  ///< from edge to edge [pixels]; unset: the filter's own
    double exposureEv = 0.0;
    ToneMap toneMap = ToneMap::kAgx;
    std::optional<std::vector<std::string>> effects;  ///< unset: auto; else the names allowed
};

struct Scene {
    std::string source;              ///< the file as the user named it
    std::filesystem::path folder;    ///< relative paths start here

    /// Where a file named in the scene is.
    std::filesystem::path resolve(const std::filesystem::path& file) const { return folder / file; }

    Domain domain;
    Medium medium;
    std::vector<Object> objects;
    std::vector<Light> lights;
    Camera camera;
    Environment environment;
    Accuracy accuracy;
    RenderSettings render;

    /// Of values that are not their defaults by what the file or the command line says: "accuracy.step". Not of objects and lights.
    std::map<std::string, SourcePosition> places;
    /// Of the first of several such values that the command line gives, else of the first; where nobody said that, the file.
    SourcePosition placeOf(std::initializer_list<std::string> keys) const;
};

} // namespace eikonal
