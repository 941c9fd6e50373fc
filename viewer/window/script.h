#pragma once
// A recording on its way to be replayed: which events are due in which frame.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "viewer/window/event.h"

namespace eikonal::window {

class Script {
public:
    explicit Script(std::vector<Event> events) : events_(std::move(events)) {}

    /// The events of the next frame. `settled`: picture and light are refined, which `wait` waits for; frames do not count
    /// meanwhile.
    std::vector<Event> next(bool settled);
    bool isDone() const { return at_ == events_.size() && !waiting_; }

private:
    std::vector<Event> events_;
    std::size_t at_ = 0;
    std::uint64_t frame_ = 0;
    bool waiting_ = false;
};

} // namespace eikonal::window
