#include "viewer/window/script.h"

namespace eikonal::window {

std::vector<Event> Script::next(const State& state) {
    const bool come = waitsFor_ == EventKind::kWait ? state.settled : state.readings > readingsBefore_;
    if (waitsFor_ && !come) return {};
    waitsFor_.reset();
    std::vector<Event> due;
    while (at_ < events_.size() && events_[at_].frame <= frame_) {
        const EventKind kind = events_[at_].kind;
        if (kind == EventKind::kWait || kind == EventKind::kChanged) {
            ++at_;
            waitsFor_ = kind;
            readingsBefore_ = state.readings;
            return due;
        }
        due.push_back(events_[at_++]);
    }
    ++frame_;
    return due;
}

} // namespace eikonal::window
