#pragma once
// The wavefronts of a scene's lights at times that follow each other, made on a thread with a context of its own: coarse
// patches, large enough to be seen apart.

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "common/gpu/context.h"
#include "common/scene.h"
#include "lightsim/front.h"

namespace eikonal::window {

/// One front a time, from a light's first meeting with the domain until no light is left.
using Fronts = std::vector<std::vector<FrontPatch>>;

class LiveFronts {
public:
    explicit LiveFronts(const gpu::ContextOptions& context = {}) : contextOptions_(context) {}
    LiveFronts(const LiveFronts&) = delete;
    LiveFronts& operator=(const LiveFronts&) = delete;
    ~LiveFronts() { stop(); }

    /// The fronts of this scene in place of others.
    void start(const Scene& scene);
    /// None any more.
    void stop();
    bool isBusy() const { return busy_; }
    /// nullptr while it is busy, and where there is nothing to show.
    std::shared_ptr<const Fronts> fronts() const;

private:
    void work(Scene scene);

    gpu::ContextOptions contextOptions_;
    mutable std::mutex mutex_;
    std::shared_ptr<const Fronts> fronts_;
    std::atomic<bool> busy_{false}, stop_{false};
    std::thread thread_;
};

} // namespace eikonal::window
