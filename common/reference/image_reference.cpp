#include "common/reference/image_reference.h"

#include <algorithm>
#include <array>

#include "common/physics.h"

namespace eikonal::f64 {

namespace {

/// shaders/physics/mirror.glsl over a field of the reference.
class MirrorIn {
public:
    using Optics = reference::Optics;

    explicit MirrorIn(const reference::GridField& field) : field_(field) {}

    Optics sampleOptics(const real3& x) const { return field_.optics(x); }
#include "shaders/physics/step_leapfrog.glsl"
#include "shaders/physics/mirror.glsl"

private:
    const reference::GridField& field_;
};

/// shaders/physics/surface_normal.glsl over a field of the reference.
class DepthIn {
public:
    explicit DepthIn(const reference::GridField& field) : field_(field) {}

    real depthAt(const real3& x) const { return field_.opaqueDepth(x); }
#include "shaders/physics/surface_normal.glsl"

private:
    const reference::GridField& field_;
};

} // namespace

} // namespace eikonal::f64

namespace eikonal::reference {

namespace {

constexpr double kSolid = 0.5;  // depth at which matter begins

/// One ray under way and all that it has met.
class Walk {
public:
    Walk(const ImageScene& scene, const ImageOptions& options)
        : scene_(scene), options_(options), field_(scene.field.at(options.wavelengthMicrons)),
          step_(options.stepVoxels * field_.lattice().voxel),
          maxLength_(options.maxPathVoxels * field_.lattice().voxel) {}

    ImageRay from(const glm::dvec3& origin, const glm::dvec3& direction);

private:
    bool enter(const glm::dvec3& origin, const glm::dvec3& direction);
    RayEnd toEnd();
    bool step();
    glm::dvec3 basicRadiance(RayEnd end) const;
    void meetBoundary(const f64::Ray& looked, const f64::Ray& start, const Optics& optics, bool inBand);
    bool isWorthFollowing(const f64::Polarised& reflected) const;
    Walk reflection(const f64::Polarised& reflected, double nEnd) const;
    void meetMatter(const glm::dvec3& x, const glm::dvec3& direction, double ds);
    glm::dvec3 firstSolid(glm::dvec3 free, glm::dvec3 inside) const;
    glm::dvec3 scattered(const glm::dvec3& x, const glm::dvec3& direction) const;
    glm::dvec3 fluxOnto(const glm::dvec3& x, const glm::dvec3& normal) const;
    glm::dvec3 surfaceRadiance(const glm::dvec3& x, const glm::dvec3& direction) const;

    bool solid(const glm::dvec3& x) const { return field_.opaqueDepth(x) >= kSolid; }
    glm::dvec3 direction() const { return glm::normalize(ray_.w); }
    double toFace() const {
        return f64::distanceToExit(ray_.x, direction(), field_.lattice().min, field_.lattice().max());
    }
    glm::dvec3 left() const { return transmittance_ * (0.5 * (fresnel_.s + fresnel_.p)); }

    const ImageScene& scene_;
    const ImageOptions& options_;
    GridField field_;
    double step_, maxLength_;
    f64::Ray ray_{};
    f64::Crossing crossing_{};
    f64::Ray start_{}, steepest_{};            // of that crossing
    glm::dvec3 transmittanceAtStart_{1.0}, transmittanceAtSteepest_{1.0};
    int generation_ = 0;
    f64::Polarised fresnel_{1.0, 1.0};
    glm::dvec3 transmittance_{1.0}, basic_{0.0}, depth_{0.0};  // basic: radiance over n² so far
    double n_ = 1.0, nCamera_ = 1.0, length_ = 0.0, opticalLength_ = 0.0;
};

/// Moves the ray to where it meets the domain; its faces do not refract. False if it misses.
bool Walk::enter(const glm::dvec3& origin, const glm::dvec3& direction) {
    const f64::BoxSpan span = f64::boxSpan(origin, direction, field_.lattice().min, field_.lattice().max());
    const double start = std::max(span.enter, 0.0);
    ray_ = {origin + direction * start, direction};
    if (span.leave <= start)
        return false;
    n_ = field_.optics(ray_.x).n;
    nCamera_ = span.enter <= 0.0 ? n_ : 1.0;
    ray_.w *= n_;
    crossing_ = f64::crossingNone(n_);
    return true;
}

/// A Fresnel term where a boundary ends, and what it mirrors. `looked`: at the step's evaluation; `start`: where the step began.
void Walk::meetBoundary(const f64::Ray& looked, const f64::Ray& start, const Optics& optics, bool inBand) {
    if (f64::crossingEnds(crossing_, inBand, optics.gradN)) {
        const double nEnd = f64::crossingEndIndex(crossing_, inBand, optics.n);
        const f64::Polarised t = f64::crossingTransmittance(crossing_, looked.w, nEnd);
        const f64::Polarised reflected{fresnel_.s * (1.0 - t.s), fresnel_.p * (1.0 - t.p)};
        fresnel_ = {fresnel_.s * t.s, fresnel_.p * t.p};
        const double mean = 0.5 * (reflected.s + reflected.p);
        if (isWorthFollowing(reflected)) {
            Walk away = reflection(reflected, nEnd);
            basic_ += away.basicRadiance(away.toEnd());
        } else if (mean > 0.0) {
            basic_ +=
                transmittance_ * mean * scene_.background(glm::normalize(f64::crossingReflected(crossing_, looked.w)));
        }
        crossing_ = f64::crossingNone(crossing_.nLast);
    }
    const f64::Crossing next = f64::crossingAfter(crossing_, inBand, looked.w, optics.n, optics.gradN);
    if (next.gradMax != crossing_.gradMax) {
        steepest_ = looked;
        transmittanceAtSteepest_ = transmittance_;
    }
    if (next.gradMax > 0.0 && crossing_.gradMax == 0.0) {
        start_ = start;
        transmittanceAtStart_ = transmittance_;
    }
    crossing_ = next;
}

bool Walk::isWorthFollowing(const f64::Polarised& reflected) const {
    const glm::dvec3 left = transmittanceAtSteepest_ * (0.5 * (reflected.s + reflected.p));
    return generation_ < options_.reflections && std::max({left.x, left.y, left.z}) >= options_.leastReflected;
}

/// The ray that a boundary reflects which has ended at index nEnd, before the boundary again.
Walk Walk::reflection(const f64::Polarised& reflected, double nEnd) const {
    f64::MirrorIn mirror(field_);
    const f64::Ray met = mirror.rayAtIndex(steepest_, 0.5 * (crossing_.nStart + nEnd), step_);
    Walk away(scene_, options_);
    away.ray_ = mirror.rayMirrored(start_, met.x, field_.optics(met.x).gradN);
    away.ray_.x = glm::clamp(away.ray_.x, field_.lattice().min, field_.lattice().max());
    const Optics there = field_.optics(away.ray_.x);
    away.n_ = there.n;
    away.crossing_ = f64::crossingFromMirror(away.ray_.w, there.n, there.gradN);
    away.fresnel_ = reflected;
    away.transmittance_ = transmittanceAtSteepest_ * transmittanceAtSteepest_ / transmittanceAtStart_;
    away.start_ = away.ray_;
    away.transmittanceAtStart_ = away.transmittance_;
    away.generation_ = generation_ + 1;
    return away;
}

/// Irradiance times phase function, summed over the lobes of a voxel.
glm::dvec3 phasedVoxel(const BakedLight& light, const glm::ivec3& voxel, const glm::dvec3& direction, const glm::dvec3& g) {
    const VoxelLobes* row = light.lobes.find(std::uint32_t(light.irradiance.offset(voxel.x, voxel.y, voxel.z)));
    const VoxelLobes whole{LightLobe{light.irradiance.at(voxel), light.lightDirection.at(voxel)}};
    glm::dvec3 sum(0.0);
    for (const LightLobe& lobe : row ? *row : whole) {
        sum += glm::dvec3(lobe.irradiance) * f64::phaseOfFlux(direction, glm::dvec3(lobe.direction), g);
    }
    return sum;
}

bool hasLobes(const BakedLight& light, const glm::dvec3& x) {
    bool found = false;
    forEachVoxelAbout(light.lattice, x, [&](const glm::ivec3& v, double weight) {
        found = found || (weight > 0.0 && light.lobes.find(std::uint32_t(light.irradiance.offset(v.x, v.y, v.z))) != nullptr);
    });
    return found;
}

/// The same at a place: of interpolated moments, or interpolated where lobes are near.
glm::dvec3 phasedLight(const BakedLight& light, const glm::dvec3& x, const glm::dvec3& direction, const glm::dvec3& g) {
    if (light.lobes.empty() || !hasLobes(light, x))
        return trilinear(light.irradiance, light.lattice, x) *
               f64::phaseOfFlux(direction, trilinear(light.lightDirection, light.lattice, x), g);
    glm::dvec3 sum(0.0);
    forEachVoxelAbout(light.lattice, x, [&](const glm::ivec3& voxel, double weight) {
        sum += weight * phasedVoxel(light, voxel, direction, g);
    });
    return sum;
}

/// Radiance per scene unit that the baked light sends into the ray.
glm::dvec3 Walk::scattered(const glm::dvec3& x, const glm::dvec3& direction) const {
    if (!scene_.light)
        return glm::dvec3(0.0);
    return field_.sigmaS(x) * phasedLight(*scene_.light, x, direction, field_.anisotropy(x));
}

/// A piece of length ds through constants taken at x.
void Walk::meetMatter(const glm::dvec3& x, const glm::dvec3& direction, double ds) {
    const glm::dvec3 tau = (field_.sigmaA(x) + field_.sigmaS(x)) * ds;
    const glm::dvec3 source = scattered(x, direction) + field_.emission(x);
    basic_ += left() * source * f64::meanTransmittance3(tau) * (ds / (n_ * n_));
    transmittance_ *= glm::exp(-tau);
    depth_ += tau;
    length_ += ds;
    opticalLength_ += n_ * ds;
}

/// Where a straight piece that ends in opaque matter meets it.
glm::dvec3 Walk::firstSolid(glm::dvec3 free, glm::dvec3 inside) const {
    for (int i = 0; i < 50; ++i) {
        const glm::dvec3 middle = 0.5 * (free + inside);
        (solid(middle) ? inside : free) = middle;
    }
    return inside;
}

/// Half a step straight on, the turn, half a step straight on; the last step ends at the face. False where the ray ends.
bool Walk::step() {
    const f64::Ray before = ray_;
    const glm::dvec3 start = before.x;
    const double ds = std::min(step_, toFace());
    ray_ = f64::driftByLength(ray_, 0.5 * ds);
    glm::dvec3 middle = ray_.x;
    const Optics optics = field_.optics(middle);
    const f64::Ray looked = f64::kickByLength(ray_, optics.gradN, 0.5 * ds);
    ray_ = f64::kickByLength(ray_, optics.gradN, ds);
    meetBoundary(looked, before, optics, field_.inBand(middle));
    n_ = optics.n;
    const double face = toFace();
    const bool leaves = face <= (ds < step_ ? ds : 0.5 * ds);
    ray_ = f64::driftByLength(ray_, leaves ? face : 0.5 * ds);
    const bool hit = solid(ray_.x);
    if (hit && solid(middle)) {
        ray_.x = firstSolid(start, middle);
        middle = 0.5 * (start + ray_.x);
    } else if (hit) {
        ray_.x = firstSolid(middle, ray_.x);
    }
    meetMatter(middle, glm::normalize(looked.w), glm::length(middle - start) + glm::length(ray_.x - middle));
    return !hit && !leaves;
}

glm::dvec3 normalOf(const GridField& field, const glm::dvec3& x, const glm::dvec3& direction) {
    return f64::DepthIn(field).outwardNormal(x, field.lattice().voxel, direction);
}

/// Power per unit area of a surface: the bake's flux about x, each voxel weighing by its free share, against the normal.
glm::dvec3 Walk::fluxOnto(const glm::dvec3& x, const glm::dvec3& normal) const {
    const BakedLight& light = *scene_.light;
    const glm::dvec3 position = (x - light.lattice.min) / light.lattice.voxel - 0.5;
    const glm::dvec3 base = glm::floor(position);
    glm::dvec3 irradiance(0.0), flux(0.0);
    double volume = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 upper(corner & 1, (corner >> 1) & 1, corner >> 2);
        const glm::dvec3 share = glm::mix(1.0 - (position - base), position - base, upper);
        const glm::ivec3 voxel = glm::clamp(glm::ivec3(base + upper), glm::ivec3(0), light.lattice.size - 1);
        const double free = 1.0 - f64::shareOfDepth(field_.opaqueDepth(light.lattice.worldFromIndex(voxel)));
        const double weight = share.x * share.y * share.z * free;
        const glm::dvec3 held = weight * glm::dvec3(light.irradiance.at(voxel));
        irradiance += held;
        flux += (held.x + held.y + held.z) * glm::dvec3(light.lightDirection.at(voxel));
        volume += weight;
    }
    const double total = irradiance.x + irradiance.y + irradiance.z;
    return total > 0.0 ? irradiance / volume * (std::max(-glm::dot(flux, normal), 0.0) / total) : glm::dvec3(0.0);
}

/// A diffuse surface under the baked light a voxel off it and under the environment.
glm::dvec3 Walk::surfaceRadiance(const glm::dvec3& x, const glm::dvec3& direction) const {
    const glm::dvec3 normal = normalOf(field_, x, direction);
    glm::dvec3 received = scene_.ambient(normal);
    if (scene_.light)
        received += fluxOnto(x + normal * scene_.light->lattice.voxel, normal) / std::numbers::pi;
    return field_.albedo(x - 0.5 * normal * field_.lattice().voxel) * received;
}

RayEnd Walk::toEnd() {
    bool goesOn = !solid(ray_.x);
    while (goesOn && length_ < maxLength_) {
        goesOn = step();
    }
    return solid(ray_.x) ? RayEnd::kHitOpaque : goesOn ? RayEnd::kTooLong : RayEnd::kExited;
}

/// Radiance over n² of all that the ray has met, and of what it ends at.
glm::dvec3 Walk::basicRadiance(RayEnd end) const {
    const glm::dvec3 behind = end == RayEnd::kHitOpaque ? surfaceRadiance(ray_.x, direction()) / (n_ * n_)
                                                        : scene_.background(direction());
    return basic_ + left() * behind;
}

ImageRay Walk::from(const glm::dvec3& origin, const glm::dvec3& towards) {
    if (!enter(origin, towards))
        return {.radiance = scene_.background(towards), .position = origin, .direction = towards};
    const RayEnd end = toEnd();
    return {nCamera_ * nCamera_ * basicRadiance(end), ray_.x, direction(), depth_, left(), opticalLength_, end};
}

} // namespace

ImageRay followRay(const ImageScene& scene, const glm::dvec3& origin, const glm::dvec3& direction,
                   const ImageOptions& options) {
    return Walk(scene, options).from(origin, glm::normalize(direction));
}

RadianceOf ambientOf(const RadianceOf& background) {
    constexpr int kRings = 256, kSectors = 512;
    std::array<glm::dvec3, 6> means{};
    for (std::size_t face = 0; face < 6; ++face) {
        const int axis = int(face) / 2;
        for (int ring = 0; ring < kRings; ++ring) {
            // rings of equal cosine-weighted solid angle
            const double sine = std::sqrt((ring + 0.5) / kRings);
            for (int sector = 0; sector < kSectors; ++sector) {
                const double angle = 2.0 * std::numbers::pi * (sector + 0.5) / kSectors;
                glm::dvec3 direction(0.0);
                direction[axis] = (face % 2 == 0 ? 1.0 : -1.0) * std::sqrt(1.0 - sine * sine);
                direction[(axis + 1) % 3] = sine * std::cos(angle);
                direction[(axis + 2) % 3] = sine * std::sin(angle);
                means[face] += background(direction) / double(kRings * kSectors);
            }
        }
    }
    return [means](const glm::dvec3& normal) {
        glm::dvec3 sum(0.0);
        for (int axis = 0; axis < 3; ++axis) {
            sum += normal[axis] * normal[axis] * means[std::size_t(2 * axis + (normal[axis] >= 0.0 ? 0 : 1))];
        }
        return sum;
    };
}

} // namespace eikonal::reference
