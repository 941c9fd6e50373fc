#pragma once
// How much of the picture a frame can afford: pure bookkeeping of what rays have cost so far.

#include <cstddef>

#include <glm/glm.hpp>

namespace eikonal::window {

/// A picture to make: its size, and the step of its rays.
struct Detail {
    glm::ivec2 size{1};
    bool fine = false;  ///< the scene's own step; otherwise one that takes a fraction of its evaluations

    bool operator==(const Detail&) const = default;
};

class Governor {
public:
    /// `frameSeconds`: what a frame may take. `coarseCost`: what a coarse ray costs, as a share of a fine one.
    Governor(double frameSeconds, double coarseCost) : frameSeconds_(frameSeconds), coarseCost_(coarseCost) {}

    /// Rays of that detail took so long.
    void measured(std::size_t rays, bool fine, double seconds);

    /// The most detailed picture of a frame of `fullSize` pixels that is done within a frame while something moves. A third
    /// of the width is as coarse as it gets within a frame; below it a picture may take three, rather than show less.
    Detail moving(const glm::ivec2& fullSize) const;
    /// The next step from a picture towards one that has every pixel and fine rays.
    static Detail refined(const Detail& shown, const glm::ivec2& fullSize);

    /// Rays that `seconds` are enough for; at least a few, so that every frame gets on.
    std::size_t raysWithin(double seconds, bool fine) const;
    double frameSeconds() const { return frameSeconds_; }
    double secondsPerRay(bool fine) const { return secondsPerFineRay_ * (fine ? 1.0 : coarseCost_); }

private:
    double frameSeconds_;
    double coarseCost_;
    double secondsPerFineRay_ = 1e-5;  // a start on the slow side: the first frames are small ones
};

} // namespace eikonal::window
