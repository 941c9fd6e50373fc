#pragma once
// Seconds that the device spends on named passes, by timestamp queries that are read when they are there: never a wait.

#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "common/gpu/context.h"

namespace eikonal::gpu {

class PassTimer {
public:
    explicit PassTimer(const Context& context);
    PassTimer(const PassTimer&) = delete;
    PassTimer& operator=(const PassTimer&) = delete;
    ~PassTimer();

    /// What follows on the device belongs to this pass, until the next mark; to none if the name is empty.
    void mark(std::string_view pass);
    /// Ends the frame, and takes in the frames before it that the device is done with.
    void endFrame();
    /// Pass and seconds of the latest known frame that had it, in the order of their first marks.
    const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

private:
    struct Mark {
        std::string pass;
        GLuint query;
    };
    using Frame = std::vector<Mark>;

    bool isDone(const Frame& frame) const;
    void takeIn(const Frame& frame);

    std::deque<Frame> frames_;  ///< oldest first; the last one is under way
    std::vector<GLuint> free_;
    std::vector<std::pair<std::string, double>> seconds_;
};

} // namespace eikonal::gpu
