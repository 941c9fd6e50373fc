#include "viewer/window/live_fronts.h"

#include <algorithm>
#include <utility>

#include "common/error.h"
#include "viewer/window/coarse_scene.h"

namespace eikonal::window {

namespace {

constexpr int kTimes = 32;  // of a front on its way through the domain

/// Ends the work from its progress callback; no failure.
struct GivenUp {};

/// Times until light has come through: a domain's diagonal through the densest matter takes longest, but for detours.
std::vector<double> timesFor(const Fields& fields) {
    float densest = 1.0f;
    for (const float n : fields.ior.values) densest = std::max(densest, n);
    const double longest = glm::length(fields.lattice.extent()) * double(densest);
    std::vector<double> times;
    for (int i = 1; i <= kTimes; ++i) times.push_back(longest * i / kTimes);
    return times;
}

/// By time; those at the end at which no light is left are not among them.
Fronts byTime(const std::vector<FrontPatch>& patches, const std::vector<double>& times) {
    Fronts fronts;
    auto next = patches.begin();
    for (const double time : times) {
        const auto end = std::find_if(next, patches.end(), [&](const FrontPatch& p) { return p.opticalTime > time; });
        fronts.emplace_back(next, end);
        next = end;
    }
    while (!fronts.empty() && fronts.back().empty()) fronts.pop_back();
    return fronts;
}

} // namespace

void LiveFronts::start(const Scene& scene) {
    stop();
    stop_ = false;
    busy_ = true;
    thread_ = std::thread([this, scene] { work(scene); });
}

void LiveFronts::stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
    const std::lock_guard lock(mutex_);
    fronts_.reset();
}

std::shared_ptr<const Fronts> LiveFronts::fronts() const {
    const std::lock_guard lock(mutex_);
    return fronts_;
}

void LiveFronts::work(Scene scene) {
    try {
        scene = coarse(std::move(scene));
        const gpu::Context context = gpu::Context::windowless(contextOptions_);
        const Fields fields = composeFields(scene);
        const std::vector<double> times = timesFor(fields);
        BakeOptions options;
        options.progress = [this](double) {
            if (stop_) throw GivenUp{};
        };
        Fronts fronts = byTime(frontsAt(context, scene, fields, decideEffects(scene, fields), times, options), times);
        const std::lock_guard lock(mutex_);
        if (!fronts.empty()) fronts_ = std::make_shared<const Fronts>(std::move(fronts));
    } catch (const GivenUp&) {
    } catch (const Error&) {  // the bake of the same scene says what is wrong
    }
    busy_ = false;
}

} // namespace eikonal::window
