#pragma once
// The method of 2007: wavefront patches that are emitted, propagated, deposited, refined, in rounds without the CPU.

#include <optional>

#include "lightsim/deposit.h"
#include "lightsim/light_method.h"
#include "lightsim/wavefront.h"

namespace eikonal::bake {

class PatchMethod : public LightMethod {
public:
    PatchMethod(const gpu::Context& context, const MethodPlan& plan, const LaunchGrids& grids,
                const BakeSettings& settings);

    void setLights(const gpu::Context& context, const LaunchGrids& grids, const BakeSettings& settings) override;
    int layers() const override { return deposit_->layers(); }
    void propagate(int begin, int end, const std::function<void(double)>& progress) override;
    void propagateInto(const LobeBins& bins, const std::function<void(double)>& progress) override;
    void read(const DenseGrid<float>& opaque, BakedLight& light) const override;
    PatchCounts counts() const override;
    const gpu::Buffer& ledger() const override { return wavefront_.ledger(); }
    std::size_t bytes() const override { return wavefront_.bytes() + deposit_->bytes(); }

private:
    void run(int begin, int end, const std::function<void()>& deposit, const std::function<void(double)>& progress);

    const gpu::Context& context_;
    std::vector<std::string> defines_;
    BakeSettings settings_;
    Wavefront wavefront_;
    std::unique_ptr<Deposit> deposit_;
    std::optional<Splat> intoLobes_;  ///< compiled where it is first needed
};

} // namespace eikonal::bake
