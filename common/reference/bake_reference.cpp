#include "common/reference/bake_reference.h"

#include <array>
#include <thread>

#include "common/physics.h"

namespace eikonal::reference {

namespace {

/// A ray on its way, with what it has left.
struct LightRay {
    f64::Ray ray;
    glm::dvec3 power;
    f64::Polarised throughput{1.0, 1.0};
    f64::Crossing crossing;

    double fresnel() const { return 0.5 * (throughput.s + throughput.p); }
};

/// One step of arc length: drift, kick, drift; Beer-Lambert; a Fresnel term where an interface ends. Returns the mean power
/// over the step.
template <class Field>
glm::dvec3 advanceLight(const Field& field, LightRay& light, double ds) {
    const glm::dvec3 before = light.ray.w;
    light.ray = f64::driftByLength(light.ray, 0.5 * ds);
    const glm::dvec3 middle = light.ray.x;
    const Optics optics = field.optics(middle);
    light.ray = f64::driftByLength(f64::kickByLength(light.ray, optics.gradN, ds), 0.5 * ds);
    const glm::dvec3 tau = (field.sigmaA(middle) + field.sigmaS(middle)) * ds;
    const glm::dvec3 mean = light.power * light.fresnel() * f64::meanTransmittance3(tau);
    light.power *= glm::exp(-tau);
    const bool inBand = field.inBand(middle);
    const glm::dvec3 w = 0.5 * (before + light.ray.w);
    if (f64::crossingEnds(light.crossing, inBand, optics.gradN)) {
        const f64::Polarised t = f64::crossingTransmittance(
            light.crossing, w, f64::crossingEndIndex(light.crossing, inBand, optics.n));
        light.throughput.s *= t.s;
        light.throughput.p *= t.p;
    }
    light.crossing = f64::crossingAfter(light.crossing, inBand, w, optics.n, optics.gradN);
    return mean;
}

/// Follows one ray through the lattice from a point on its face or inside it. `deposit` gets, step by step, the voxel that
/// holds the step's middle, the unit direction there and power × length.
template <class Field, class Deposit>
void followLight(const Field& field, const Lattice& lattice, LightRay light, const BeamBakeOptions& options,
                 const Deposit& deposit) {
    const double ds = options.stepVoxels * lattice.voxel;
    const int maxSteps = int(options.maxPathDiagonals * glm::length(lattice.extent()) / ds);
    for (int i = 0; i < maxSteps; ++i) {
        const glm::dvec3 from = light.ray.x;
        const glm::dvec3 mean = advanceLight(field, light, ds);
        const glm::ivec3 voxel(glm::floor((0.5 * (from + light.ray.x) - lattice.min) / lattice.voxel));
        if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, lattice.size))) {
            return;
        }
        deposit(voxel, (light.ray.x - from) / glm::length(light.ray.x - from), mean * ds);
    }
}

/// Adds to each voxel what its mirror images about the beam's axis and diagonals hold.
DenseGrid<glm::dvec3> unfoldedEightfold(const DenseGrid<glm::dvec3>& wedge) {
    DenseGrid<glm::dvec3> whole(wedge.size, glm::dvec3(0.0));
    const int last = wedge.size.y - 1;
    for (int k = 0; k <= last; ++k) {
        for (int j = 0; j <= last; ++j) {
            for (int i = 0; i < wedge.size.x; ++i) {
                for (const auto& [y, z] : {std::array{j, k}, std::array{k, j}}) {
                    whole.at(i, j, k) += wedge.at(i, y, z) + wedge.at(i, last - y, z) + wedge.at(i, y, last - z) +
                                         wedge.at(i, last - y, last - z);
                }
            }
        }
    }
    return whole;
}

enum class BeamPart { kWhole, kEighth };

/// Follows the rays of a unit beam along +x, all or one eighth, by two threads; `deposit` also gets the thread's number.
template <class Field, class Deposit>
void followBeam(BeamPart beam, const Field& field, const Lattice& lattice, const BeamBakeOptions& options,
                const Deposit& deposit) {
    const int across = lattice.size.y * options.raysPerVoxelEdge;
    const double spacing = lattice.voxel / options.raysPerVoxelEdge;
    const bool isWedge = beam == BeamPart::kEighth;
    const int first = isWedge ? across / 2 : 0;
    const auto work = [&](std::size_t part) {
        for (int j = first + int(part); j < across; j += 2) {
            const int last = isWedge ? j : across - 1;
            for (int k = first; k <= last; ++k) {
                const glm::dvec3 start(lattice.min + spacing * glm::dvec3(0.0, j + 0.5, k + 0.5));
                const double share = isWedge && j == k ? 0.5 : 1.0;  // the diagonal is its own mirror image
                const double n = field.optics(start).n;
                followLight(field, lattice,
                            {{start, glm::dvec3(n, 0.0, 0.0)}, glm::dvec3(share * spacing * spacing), {1.0, 1.0},
                             f64::crossingNone(n)},
                            options, [&](const glm::ivec3& voxel, const glm::dvec3& direction, const glm::dvec3& powerLength) {
                                deposit(part, voxel, direction, powerLength);
                            });
            }
        }
    };
    std::thread other(work, 1);
    work(0);
    other.join();
}

/// A mirror image about the beam's axis and diagonals, of eight.
glm::dvec3 mirrored(const glm::dvec3& v, int image) {
    const glm::dvec3 turned = (image & 4) != 0 ? glm::dvec3(v.x, v.z, v.y) : v;
    return turned * glm::dvec3(1.0, (image & 1) != 0 ? -1.0 : 1.0, (image & 2) != 0 ? -1.0 : 1.0);
}

glm::ivec3 mirrored(const glm::ivec3& voxel, const glm::ivec3& size, int image) {
    const glm::ivec3 last = size - 1;
    const glm::ivec3 turned = (image & 4) != 0 ? glm::ivec3(voxel.x, voxel.z, voxel.y) : voxel;
    return {turned.x, (image & 1) != 0 ? last.y - turned.y : turned.y, (image & 2) != 0 ? last.z - turned.z : turned.z};
}

/// Cube means of what the rays leave.
template <class Field>
DenseGrid<glm::dvec3> meansOfPart(BeamPart beam, const Field& field, const Lattice& lattice, const BeamBakeOptions& options) {
    std::array<DenseGrid<glm::dvec3>, 2> parts{DenseGrid<glm::dvec3>(lattice.size, glm::dvec3(0.0)),
                                               DenseGrid<glm::dvec3>(lattice.size, glm::dvec3(0.0))};
    followBeam(beam, field, lattice, options,
               [&](std::size_t part, const glm::ivec3& voxel, const glm::dvec3&, const glm::dvec3& powerLength) {
                   parts[part].at(voxel) += powerLength;
               });
    const double volume = lattice.voxel * lattice.voxel * lattice.voxel;
    for (std::size_t i = 0; i < parts[0].values.size(); ++i) {
        parts[0].values[i] = (parts[0].values[i] + parts[1].values[i]) / volume;
    }
    return parts[0];
}

} // namespace

template <class Field>
std::vector<VoxelArrivals> symmetricBeamArrivals(const Field& field, const Lattice& lattice, const BeamBakeOptions& options,
                                                 const std::vector<glm::ivec3>& voxels,
                                                 const std::vector<glm::dvec3>& viewDirections, double g) {
    DenseGrid<int> rows(lattice.size, -1);
    for (std::size_t row = 0; row < voxels.size(); ++row) {
        rows.at(voxels[row]) = int(row);
    }
    const VoxelArrivals none{0.0, glm::dvec3(0.0), std::vector<double>(viewDirections.size(), 0.0)};
    std::array<std::vector<VoxelArrivals>, 2> parts;
    parts.fill(std::vector<VoxelArrivals>(voxels.size(), none));
    const double volume = lattice.voxel * lattice.voxel * lattice.voxel;
    followBeam(BeamPart::kEighth, field, lattice, options,
               [&](std::size_t part, const glm::ivec3& voxel, const glm::dvec3& direction, const glm::dvec3& powerLength) {
                   for (int image = 0; image < 8; ++image) {
                       const int row = rows.at(mirrored(voxel, lattice.size, image));
                       if (row >= 0) {
                           parts[part][std::size_t(row)].add(mirrored(direction, image), powerLength.x / volume,
                                                             viewDirections, g);
                       }
                   }
               });
    for (std::size_t row = 0; row < voxels.size(); ++row) {
        parts[0][row] += parts[1][row];
    }
    return parts[0];
}

void VoxelArrivals::add(const glm::dvec3& direction, double arriving, const std::vector<glm::dvec3>& viewDirections, double g) {
    irradiance += arriving;
    flux += arriving * direction;
    for (std::size_t i = 0; i < viewDirections.size(); ++i) {
        phased[i] += arriving * f64::henyeyGreenstein(-glm::dot(viewDirections[i], direction), g);
    }
}

VoxelArrivals& VoxelArrivals::operator+=(const VoxelArrivals& other) {
    irradiance += other.irradiance;
    flux += other.flux;
    for (std::size_t i = 0; i < phased.size(); ++i) {
        phased[i] += other.phased[i];
    }
    return *this;
}

template <class Field>
DenseGrid<glm::dvec3> bakeBeam(const Field& field, const Lattice& lattice, const BeamBakeOptions& options) {
    return meansOfPart(BeamPart::kWhole, field, lattice, options);
}

template <class Field>
DenseGrid<glm::dvec3> bakeSymmetricBeam(const Field& field, const Lattice& lattice, const BeamBakeOptions& options) {
    return unfoldedEightfold(meansOfPart(BeamPart::kEighth, field, lattice, options));
}

template std::vector<VoxelArrivals> symmetricBeamArrivals(const GridField&, const Lattice&, const BeamBakeOptions&,
                                                          const std::vector<glm::ivec3>&, const std::vector<glm::dvec3>&,
                                                          double);
template DenseGrid<glm::dvec3> bakeBeam(const ClosedForm&, const Lattice&, const BeamBakeOptions&);
template DenseGrid<glm::dvec3> bakeSymmetricBeam(const SmoothedSphere&, const Lattice&, const BeamBakeOptions&);
template DenseGrid<glm::dvec3> bakeSymmetricBeam(const GridField&, const Lattice&, const BeamBakeOptions&);

} // namespace eikonal::reference
