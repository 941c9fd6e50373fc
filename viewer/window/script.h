#pragma once
// A recording on its way to be replayed: which events are due in which frame.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/window/event.h"

namespace eikonal::window {

class Script {
public:
    explicit Script(std::vector<Event> events) : events_(std::move(events)) {}

    /// What recordings wait for: `wait` until picture and light are refined, `changed` for another reading of files.
    struct State {
        bool settled = false;
        std::uint64_t readings = 0;  ///< so far
    };
    /// The events of the next frame; frames do not count while it waits.
    std::vector<Event> next(const State& state);
    bool isWaiting() const { return waitsFor_.has_value(); }
    bool isDone() const { return at_ == events_.size() && !isWaiting(); }

private:
    std::vector<Event> events_;
    std::size_t at_ = 0;
    std::uint64_t frame_ = 0;
    std::optional<EventKind> waitsFor_;
    std::uint64_t readingsBefore_ = 0;
};

} // namespace eikonal::window
