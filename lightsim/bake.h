#pragma once
// The light simulator: wavefronts of a scene's lights are propagated through its index field, as ray tubes or as patches, and
// leave irradiance and light direction on the domain's lattice.
// Method: A. Tevs, Realistic Real-time Rendering of Refractive Objects (2007), chapters 4 and 6, with the corrections of
// docs/physics.md: every arrival is kept and added, folded or not, unless the scene asks for the method of 2007.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"
#include "common/scene.h"
#include "lightsim/light_set.h"

namespace eikonal {

namespace bake {
struct BakeSettings;
struct LaunchGrids;
class LobeCriterion;
} // namespace bake

struct BakeOptions {
    std::uint32_t poolPatches = 16384;  ///< patches alive at a time; any number >= 8 gives the same grids
    std::uint32_t tubeVertices = 0;      ///< most rays in memory at a time; any number that one launch cell needs gives the same
                                         ///< grids. 0: as suits the device
    std::size_t maxBlockBytes = 0;      ///< largest storage block; 0: the device's limit. Smaller ones take more passes
    bool eikonal = false;               ///< the bake holds the eikonal too; deposits `auto` and `cells` only
    double meshScale = 1.0;  ///< steps, patches and launch cells are as many times longer than the tolerance makes them
    std::function<void(double fraction)> progress;  ///< called now and then with the share of the light launched
};

/// Where the launched power went, by band [power].
struct EnergyLedger {
    glm::dvec3 emitted{0.0};    ///< power; of a beam irradiance × projected area of the domain
    glm::dvec3 entered{0.0};
    glm::dvec3 absorbed{0.0};   ///< by the medium, by opaque matter and by boundaries with a tint
    glm::dvec3 absorbedOpaque{0.0};  ///< of it, by opaque matter
    glm::dvec3 absorbedByTint{0.0};  ///< of it, what boundaries would reflect without their tint
    glm::dvec3 scattered{0.0};
    glm::dvec3 exited{0.0};
    glm::dvec3 reflected{0.0};  ///< at boundaries, and not followed
    glm::dvec3 followed{0.0};   ///< at boundaries, and followed: it is part of what was absorbed, scattered, exited or reflected
    glm::dvec3 culled{0.0};     ///< below the energy threshold, at the step limit, or (2007 method) folded
    glm::dvec3 depositedAbsorbed{0.0};   ///< Σ σ_a E V of the written grid: should equal absorbedByMedium()
    glm::dvec3 depositedScattered{0.0};  ///< Σ σ_s E V of the written grid: should equal scattered

    /// 1 - (absorbed + scattered + exited + reflected + culled)/entered; 0 where nothing entered.
    glm::dvec3 balance() const;
    glm::dvec3 absorbedByMedium() const { return absorbed - absorbedOpaque - absorbedByTint; }
    EnergyLedger& operator+=(const EnergyLedger& other);
    /// Of a ledger of grey light, the linear Rec.709 when it is that of a spectral band.
    EnergyLedger ofBand(const glm::dvec3& toRgb) const;
};

/// The ledger of a spectral band, in units of white.
struct BandLedger {
    double wavelengthNm = 0.0;
    EnergyLedger energy;
};

struct PatchCounts {
    std::uint64_t peak = 0;              ///< most alive at a time
    std::uint64_t steps = 0;             ///< every patch advanced one step
    std::uint64_t fieldEvaluations = 0;  ///< of corners, relaunched ones included
    std::uint64_t splits = 0;
    std::uint64_t folds = 0;             ///< changes of orientation; with the 2007 method patches that they ended
    std::uint64_t refusedSplits = 0;     ///< for want of memory; the patch lived on unsplit
};

struct BakeSeconds {
    double upload = 0.0;     ///< textures, buffers and kernels, where they are not there from an earlier bake
    double propagate = 0.0;  ///< emit, propagate, deposit and refine
    double lobes = 0.0;      ///< the second propagation, where light is sorted by direction, and merging
    double read = 0.0;       ///< fixed point to grids, ledger
    double total = 0.0;
};

struct BakeStatistics {
    BakeSeconds seconds;
    PatchCounts patches;
    EnergyLedger energy;            ///< where something disperses, the linear Rec.709 of all bands
    std::vector<BandLedger> bands;  ///< where something disperses; else empty
    std::string device;
    Interpolation interpolation = Interpolation::kLinear;  ///< of the index
    std::size_t memoryBytes = 0;  ///< of buffers and textures that stay
    std::size_t lobeVoxels = 0;   ///< that have several lobes

    /// Adds another run's; `peak` and `memoryBytes` become the largest.
    void addRun(const BakeStatistics& run);
};

/// What one light of several leaves.
struct NamedLight {
    std::string name;  ///< "light0", ..., "environment"
    BakedLight light;
};

struct BakeResult {
    BakedLight light;
    BakeStatistics statistics;
    std::vector<NamedLight> parts;  ///< only where asked for (lightsim/per_light.h); `light` is their sum
};

/// Bakes any number of sets of lights through one scene: what depends on matter alone is on the device once.
class LightSimulator {
public:
    /// `effects` decides what acts on the light. Keeps references to the context and the fields.
    LightSimulator(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                   const BakeOptions& options);
    ~LightSimulator();

    /// Lights as they stand, whatever their keyframes say. Without power the grids are zero.
    /// Throws Error(kFailure) when interrupted, badInput for a lattice beyond the device.
    BakeResult bake(const LightSet& lights);
    /// Which voxels get lobes, and how close lobes are merged.
    const bake::LobeCriterion& lobeCriterion() const { return *lobeCriterion_; }

private:
    struct Device;
    std::size_t blockBytes() const;
    BakeResult bakeIn(const Fields& fields, const LightSet& lights, const BakeOptions& options);
    Device& deviceFor(int bands, const Fields& fields, const bake::LaunchGrids& grids, const bake::BakeSettings& settings);

    const gpu::Context& context_;
    Accuracy accuracy_;
    const Fields& fields_;
    EffectSet effects_;
    BakeOptions options_;
    Interpolation interpolation_;  ///< of the index
    std::unique_ptr<bake::LobeCriterion> lobeCriterion_;
    std::unique_ptr<Device> device_;
};

/// Bakes the light of a scene at frame 0. Throws as LightSimulator::bake and lightsOf.
BakeResult bakeScene(const gpu::Context& context, const Scene& scene, const Fields& fields, const EffectSet& effects,
                     const BakeOptions& options);

} // namespace eikonal
