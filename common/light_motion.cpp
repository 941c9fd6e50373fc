#include "common/light_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eikonal {
namespace {

using Member = std::optional<glm::dvec3> LightKeyframe::*;

/// Between two unit vectors that are not opposite, at equal angles in equal times.
glm::dvec3 turned(const glm::dvec3& from, const glm::dvec3& to, double share) {
    const double angle = std::atan2(glm::length(glm::cross(from, to)), glm::dot(from, to));
    if (angle < 1e-6) {  // the sines below would cancel; the chord is the arc to 1e-13 of itself
        return glm::normalize(glm::mix(from, to, share));
    }
    return (std::sin((1.0 - share) * angle) * from + std::sin(share * angle) * to) / std::sin(angle);
}

/// The value of one member at a frame; nothing where no keyframe has one.
template <class Interpolate>
std::optional<glm::dvec3> valueAt(const std::vector<LightKeyframe>& keyframes, Member member, double frame,
                                  const Interpolate& interpolate) {
    const LightKeyframe* before = nullptr;
    const LightKeyframe* after = nullptr;
    for (const LightKeyframe& keyframe : keyframes) {
        if (!(keyframe.*member)) {
            continue;
        }
        if (keyframe.frame <= frame) {
            before = &keyframe;
        } else if (!after) {
            after = &keyframe;
        }
    }
    if (!before || !after) {
        return before ? before->*member : (after ? after->*member : std::nullopt);
    }
    const double share = (frame - before->frame) / (after->frame - before->frame);
    return interpolate(*(before->*member), *(after->*member), share);
}

template <class Kind>
constexpr bool kHasPosition = requires(Kind kind) { kind.position; };
template <class Kind>
constexpr bool kHasDirection = requires(Kind kind) { kind.direction; };

template <class Kind>
void place(Kind& light, double frame) {
    const std::vector<LightKeyframe> keyframes = std::exchange(light.keyframes, {});
    if constexpr (kHasPosition<Kind>) {
        const auto linear = [](const glm::dvec3& a, const glm::dvec3& b, double share) { return glm::mix(a, b, share); };
        light.position = valueAt(keyframes, &LightKeyframe::position, frame, linear).value_or(light.position);
    }
    if constexpr (kHasDirection<Kind>) {
        light.direction = valueAt(keyframes, &LightKeyframe::direction, frame, turned).value_or(light.direction);
    }
}

} // namespace

bool hasPosition(const Light& light) {
    return std::visit([]<class Kind>(const Kind&) { return kHasPosition<Kind>; }, light);
}

bool hasDirection(const Light& light) {
    return std::visit([]<class Kind>(const Kind&) { return kHasDirection<Kind>; }, light);
}

const std::vector<LightKeyframe>& keyframesOf(const Light& light) {
    return std::visit([](const auto& one) -> const std::vector<LightKeyframe>& { return one.keyframes; }, light);
}

std::vector<LightKeyframe>& keyframesOf(Light& light) {
    return std::visit([](auto& one) -> std::vector<LightKeyframe>& { return one.keyframes; }, light);
}

Light lightAt(const Light& light, double frame) {
    Light placed = light;
    std::visit([frame](auto& one) { place(one, frame); }, placed);
    return placed;
}

} // namespace eikonal
