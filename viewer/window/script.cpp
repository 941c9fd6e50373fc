#include "viewer/window/script.h"

namespace eikonal::window {

std::vector<Event> Script::next(bool settled) {
    if (waiting_ && !settled) return {};
    waiting_ = false;
    std::vector<Event> due;
    while (at_ < events_.size() && events_[at_].frame <= frame_) {
        if (events_[at_].kind == EventKind::kWait) {
            ++at_;
            waiting_ = true;
            return due;
        }
        due.push_back(events_[at_++]);
    }
    ++frame_;
    return due;
}

} // namespace eikonal::window
