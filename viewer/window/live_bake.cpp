#include "viewer/window/live_bake.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <utility>

#include "common/scene_hash.h"
#include "viewer/window/coarse_scene.h"

namespace eikonal::window {

namespace {

constexpr std::uint32_t kRaysAtATime = 16384;  // of a fine bake: short batches, between which it can be given up

constexpr std::chrono::milliseconds kRest{150};

/// Ends a bake from its progress callback; no failure.
struct GivenUp {};

/// What a simulator is made for: all that the bake depends on but the lights.
std::string simulatorKey(const Scene& scene) {
    std::string key;
    for (const auto& [name, text] : bakeKeys(scene)) {
        if (name.rfind("light.", 0) != 0) key += name + "=" + text + "\n";
    }
    return key;
}

} // namespace

/// Simulators stay while matter stays: what they have on the device depends on it alone.
struct LiveBake::Worker {
    LiveBake& owner;
    gpu::Context context;
    std::shared_ptr<const Fields> fields;
    std::string key;
    EffectSet effects;
    std::optional<Fields> coarseFields;
    std::unique_ptr<LightSimulator> coarseSimulator, fineSimulator;
    std::uint64_t number = 0;  ///< of the request under way

    std::unique_ptr<LightSimulator> simulator(const Scene& scene, const Fields& on, bool mayGiveUp) {
        BakeOptions options;
        if (mayGiveUp) options.tubeVertices = kRaysAtATime;
        options.progress = [this, mayGiveUp](double fraction) {
            owner.progress_ = fraction;
            if (owner.stop_ || (mayGiveUp && owner.newer_)) throw GivenUp{};
        };
        return std::make_unique<LightSimulator>(context, scene, on, effects, options);
    }

    void prepare(const BakeRequest& request) {
        coarseSimulator.reset();
        fineSimulator.reset();
        fields = request.fields;
        key = simulatorKey(request.scene);
        effects = request.effects;
        if (!isCoarse(request.scene)) {
            const Scene scene = coarse(request.scene);
            coarseFields = composeFields(scene);
            coarseSimulator = simulator(scene, *coarseFields, false);
        }
        fineSimulator = simulator(request.scene, *fields, true);
    }

    void bake(const BakeRequest& request) {
        if (request.fields != fields || simulatorKey(request.scene) != key) prepare(request);
        const LightSet lights = lightsAt(lightsOf(request.scene, request.effects), request.frame);
        if (coarseSimulator) bakeWith(*coarseSimulator, lights, LightStage::kCoarse);
        if (!coarseSimulator || rests()) bakeWith(*fineSimulator, lights, LightStage::kScene);
    }

    /// Whether no other request comes for a while: a fine bake is not given up in an instant.
    bool rests() {
        std::unique_lock lock(owner.mutex_);
        return !owner.wake_.wait_for(lock, kRest, [this] { return owner.stop_ || owner.next_; });
    }

    void bakeRough(const BakeRequest& request) {
        Scene scene = request.scene;
        scene.accuracy.tolerance = std::min(2.0 * scene.accuracy.tolerance, 1.0);
        effects = request.effects;
        const auto rough = simulator(scene, *request.fields, true);
        bakeWith(*rough, lightsAt(lightsOf(scene, effects), request.frame), LightStage::kRough);
    }

    void bakeWith(LightSimulator& simulator, const LightSet& lights, LightStage stage) {
        owner.progress_ = 0.0;
        {
            const std::lock_guard lock(owner.mutex_);
            owner.stage_ = stage;
        }
        BakeResult result = simulator.bake(lights);
        const std::lock_guard lock(owner.mutex_);
        owner.done_ = LiveLight{std::move(result.light), stage, std::move(result.statistics), number};
    }
};

LiveBake::LiveBake(const gpu::ContextOptions& context) : contextOptions_(context), thread_([this] { work(); }) {}

LiveBake::~LiveBake() {
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
    }
    wake_.notify_one();
    thread_.join();
}

std::uint64_t LiveBake::start(BakeRequest request) {
    std::uint64_t number = 0;
    {
        const std::lock_guard lock(mutex_);
        next_ = std::move(request);
        number = ++requests_;
        newer_ = true;
        if (!working_) progress_ = 0.0;  // instead of the last one's
        working_ = true;
    }
    wake_.notify_one();
    return number;
}

std::optional<LiveLight> LiveBake::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(done_, std::nullopt);
}

std::optional<std::string> LiveBake::takeError() {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, std::nullopt);
}

bool LiveBake::isBusy() const {
    const std::lock_guard lock(mutex_);
    return working_ || done_.has_value();
}

std::optional<LightStage> LiveBake::coming() const {
    const std::lock_guard lock(mutex_);
    if (done_) return done_->stage;
    if (next_) return next_->rough ? LightStage::kRough : LightStage::kCoarse;
    return working_ ? std::optional(stage_) : std::nullopt;
}

void LiveBake::work() {
    std::optional<Worker> worker;
    std::unique_lock lock(mutex_);
    while (true) {
        wake_.wait(lock, [&] { return stop_ || next_; });
        if (stop_) return;
        const BakeRequest request = *std::exchange(next_, std::nullopt);
        const std::uint64_t number = requests_;
        newer_ = false;
        stage_ = request.rough ? LightStage::kRough : LightStage::kCoarse;
        lock.unlock();
        std::optional<std::string> error;
        try {
            if (!worker) worker.emplace(Worker{.owner = *this, .context = gpu::Context::windowless(contextOptions_)});
            worker->number = number;
            if (request.rough) {
                worker->bakeRough(request);
            } else {
                worker->bake(request);
            }
        } catch (const GivenUp&) {
        } catch (const std::exception& failed) {
            error = failed.what();
        }
        lock.lock();
        if (error) error_ = std::move(error);
        working_ = next_.has_value();
    }
}

} // namespace eikonal::window
