#include "viewer/window/response.h"

#include <chrono>
#include <ctime>

namespace eikonal::window {

Instant instantNow() {
    timespec worked{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &worked);
    return {std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(),
            double(worked.tv_sec) + 1e-9 * double(worked.tv_nsec)};
}

void Response::frameEnded(const Instant& took, const glm::ivec2& size, bool cameraMoved) {
    if (cameraMoved) record_.moving.push_back({took, size});
    for (Asked& asked : asked_) ++asked.frames;
}

void Response::lightDragged(std::uint64_t request, const Instant& at) { asked_.push_back({request, at, 1}); }

void Response::lightShown(std::uint64_t request, const Instant& at) {
    for (; !asked_.empty() && asked_.front().request <= request; asked_.pop_front()) {
        record_.lights.push_back({at - asked_.front().at, asked_.front().frames});
    }
}

void Response::refined(const Instant& at) {
    if (restBegan_) record_.refinements.push_back(at - *restBegan_);
    restBegan_.reset();
}

} // namespace eikonal::window
