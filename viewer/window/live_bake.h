#pragma once
// Light that follows the scene: baked on a thread with a context of its own, coarse at first, then as the scene asks.
// Bakes travel as grids, so that the two contexts share nothing.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "common/baked_light.h"
#include "common/effects.h"
#include "common/fields.h"
#include "common/gpu/context.h"
#include "common/scene.h"
#include "lightsim/bake.h"

namespace eikonal::window {

/// What is to be baked. `fields` are those of the scene at its own resolution, shared while matter stays as it is.
struct BakeRequest {
    Scene scene;
    std::shared_ptr<const Fields> fields;
    EffectSet effects;
    double frame = 0.0;  ///< of the lights' keyframes
    bool rough = false;  ///< only at twice the tolerance, to compare with
};

/// Coarse: at once. Scene: as the scene asks. Rough: at twice its tolerance.
enum class LightStage { kCoarse, kScene, kRough };

struct LiveLight {
    BakedLight light;
    LightStage stage = LightStage::kScene;
    BakeStatistics statistics;
    std::uint64_t request = 0;  ///< that it answers
};

class LiveBake {
public:
    /// `context`: of the device that it makes for itself.
    explicit LiveBake(const gpu::ContextOptions& context = {});
    LiveBake(const LiveBake&) = delete;
    LiveBake& operator=(const LiveBake&) = delete;
    ~LiveBake();

    /// Bakes for this scene from now on. A coarse bake under way is finished, so that a light that is dragged without a
    /// rest shows too; a fine one, which begins after a moment's rest, is given up. Returns the request's number; numbers ascend.
    std::uint64_t start(BakeRequest request);
    /// The newest light that is done and was not taken yet.
    std::optional<LiveLight> take();
    /// Why the latest bake failed, once.
    std::optional<std::string> takeError();

    bool isBusy() const;
    /// What the next light will be; nullopt: none is on its way.
    std::optional<LightStage> coming() const;
    /// Share of the bake under way that is done, 0 to 1.
    double progress() const { return progress_.load(); }

private:
    struct Worker;
    void work();

    gpu::ContextOptions contextOptions_;
    mutable std::mutex mutex_;
    std::condition_variable wake_;
    std::optional<BakeRequest> next_;
    std::uint64_t requests_ = 0;
    std::optional<LiveLight> done_;
    std::optional<std::string> error_;
    bool working_ = false;
    LightStage stage_ = LightStage::kScene;  ///< of the bake under way
    std::atomic<bool> newer_{false};  ///< a request waits
    std::atomic<bool> stop_{false};
    std::atomic<double> progress_{0.0};
    std::thread thread_;  // last: it uses all the others
};

} // namespace eikonal::window
