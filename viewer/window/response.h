#pragma once
// How quickly the window answers: pure bookkeeping of frames while the camera moves, of light that follows a drag, and of the
// way from rest to the refined picture.

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

namespace eikonal::window {

/// Seconds by the clock, and seconds that processors have worked for this process, all its threads together.
struct Instant {
    double clock = 0.0, processor = 0.0;

    Instant operator-(const Instant& earlier) const { return {clock - earlier.clock, processor - earlier.processor}; }
};

Instant instantNow();

/// A frame in which the camera moved.
struct MovingFrame {
    Instant took;
    glm::ivec2 size{0};  ///< of the picture that was followed by rays [pixels]
};

/// A drag of a light, until the first picture with light from there or from a later place was on the screen.
struct LightAnswer {
    Instant took;
    int frames = 0;  ///< the one of the drag included
};

struct ResponseRecord {
    std::vector<MovingFrame> moving;
    std::vector<LightAnswer> lights;
    std::vector<Instant> refinements;  ///< from the last frame that changed something to refined picture and light
};

class Response {
public:
    void frameEnded(const Instant& took, const glm::ivec2& size, bool cameraMoved);
    /// A bake was asked for that shows a drag; numbers ascend.
    void lightDragged(std::uint64_t request, const Instant& at);
    /// The screen shows the light of a request.
    void lightShown(std::uint64_t request, const Instant& at);
    /// Something changed that the refined picture depends on.
    void changed(const Instant& at) { restBegan_ = at; }
    /// Picture and light are refined.
    void refined(const Instant& at);

    const ResponseRecord& record() const { return record_; }

private:
    struct Asked {
        std::uint64_t request;
        Instant at;
        int frames;
    };
    std::deque<Asked> asked_;
    std::optional<Instant> restBegan_;
    ResponseRecord record_;
};

} // namespace eikonal::window
