#pragma once
// Deposit: what patches leave on a slab of voxel layers, and the grids that are made of it.

#include <memory>

#include "lightsim/light_sums.h"
#include "lightsim/wavefront.h"

namespace eikonal::bake {

/// A way to put patches into the voxel layers [slabBegin, slabEnd) of a lattice, at most layers() of them at a time.
class Deposit {
public:
    explicit Deposit(int layers) : layers_(layers) {}
    virtual ~Deposit() = default;
    int layers() const { return layers_; }

    virtual void clear() = 0;
    /// Adds the last step of every live patch.
    virtual void add(const Wavefront& wavefront) const = 0;
    /// Writes the slab's layers of the grids. `opaque` is empty or the depth in opaque matter: light is in the rest of
    /// the voxel.
    virtual void read(const BakeSettings& settings, const DenseGrid<float>& opaque, BakedLight& light) const = 0;
    virtual std::size_t bytes() const = 0;

private:
    int layers_;
};

/// Splats the last step of every live patch.
class Splat {
public:
    Splat(const gpu::Context& context, const std::vector<std::string>& defines);

    void add(const Wavefront& wavefront, const VoxelSums& sums) const;

private:
    gpu::Kernel interpolated_, corners_;
};

/// Fixed-point sums of power × path length.
class SplatDeposit : public Deposit {
public:
    SplatDeposit(const gpu::Context& context, const std::vector<std::string>& defines, const Lattice& lattice, int layers,
                 int bands);

    void clear() override { sums_.clear(); }
    void add(const Wavefront& wavefront) const override { splat_.add(wavefront, sums_); }
    void read(const BakeSettings& settings, const DenseGrid<float>& opaque, BakedLight& light) const override {
        sums_.read(settings, opaque, light);
    }
    std::size_t bytes() const override { return sums_.bytes(); }

private:
    LightSums sums_;
    Splat splat_;
};

/// The deposit that a scene asks for, with as many layers as have their sums in storage blocks of `blockBytes`; at least 1.
std::unique_ptr<Deposit> makeDeposit(eikonal::Deposit method, const gpu::Context& context,
                                     const std::vector<std::string>& defines, const Lattice& lattice,
                                     std::size_t blockBytes, int bands);

} // namespace eikonal::bake
