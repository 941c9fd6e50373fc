#include "viewer/window/ray_overlay.h"

#include <cmath>
#include <variant>

#include <imgui.h>

#include "viewer/window/orbit.h"

namespace eikonal::window {

namespace {

constexpr int kRings = 2, kRaysPerRing = 6;  // and one in the middle
constexpr double kSpread = 0.22;             // of the domain's diagonal: the outer ring's radius in the middle
constexpr double kGoesOn = 0.3;              // of the domain's diagonal, beyond its faces

double diagonal(const Lattice& domain) { return glm::length(domain.extent()); }

/// Points of rings in the plane through `center` across `direction`.
std::vector<glm::dvec3> ringPoints(const glm::dvec3& center, const glm::dvec3& direction, double radius) {
    const glm::dvec3 other = std::abs(direction.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    const glm::dvec3 u = glm::normalize(glm::cross(direction, other)), v = glm::cross(direction, u);
    std::vector<glm::dvec3> points{center};
    for (int ring = 1; ring <= kRings; ++ring) {
        for (int i = 0; i < kRaysPerRing; ++i) {
            const double angle = 2.0 * 3.14159265358979323846 * (i + 0.5 * ring) / kRaysPerRing;
            points.push_back(center + (u * std::cos(angle) + v * std::sin(angle)) * (radius * ring / kRings));
        }
    }
    return points;
}

} // namespace

std::vector<TraceRay> raysOfLight(const Light& light, const Lattice& domain) {
    const glm::dvec3 center = 0.5 * (domain.min + domain.max());
    std::vector<TraceRay> rays;
    std::visit(
        [&](const auto& kind) {
            if constexpr (requires { kind.position; }) {
                const glm::dvec3 way = center - kind.position;
                const glm::dvec3 towards = glm::length(way) > 1e-9 ? glm::normalize(way) : glm::dvec3(1.0, 0.0, 0.0);
                const glm::dvec3 aim = kind.position + towards * diagonal(domain);
                for (const glm::dvec3& point : ringPoints(aim, towards, 2.0 * kSpread * diagonal(domain))) {
                    rays.push_back({kind.position, point - kind.position});
                }
            } else {
                const glm::dvec3 start = center - kind.direction * (0.6 * diagonal(domain));
                for (const glm::dvec3& point : ringPoints(start, kind.direction, kSpread * diagonal(domain))) {
                    rays.push_back({point, kind.direction});
                }
            }
        },
        light);
    return rays;
}

std::vector<RayPath> followedRays(const gpu::Context& context, const Document& document,
                                  const std::optional<glm::dvec2>& pointer, double aspect) {
    const Lattice& domain = document.domain();
    std::vector<TraceRay> rays;
    for (const Light& light : document.scene().lights) {
        for (const TraceRay& ray : raysOfLight(light, domain)) rays.push_back(ray);
    }
    const std::size_t ofLights = rays.size();
    const Camera& camera = document.scene().camera;
    if (pointer) rays.push_back({camera.position, rayThrough(camera, *pointer, aspect)});
    std::vector<RayPath> paths(rays.size());
    for (std::size_t i = 0; i < rays.size(); ++i) {
        paths[i].ofLight = i < ofLights;
        if (paths[i].ofLight) paths[i].points.push_back(rays[i].origin);
    }
    std::vector<TraceResult> ends(rays.size());
    for (const TracePoint& point :
         tracePaths(context, *document.image().fields, document.image().effects, document.scene().accuracy, rays)) {
        paths[point.ray].points.push_back(point.at.position);
        ends[point.ray] = point.at;
    }
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (ends[i].status != TraceStatus::kExited) continue;
        paths[i].points.push_back(ends[i].position + ends[i].direction * (kGoesOn * diagonal(domain)));
    }
    return paths;
}

void drawRays(const std::vector<RayPath>& paths, const Camera& camera) {
    ImDrawList* canvas = ImGui::GetBackgroundDrawList();
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const double aspect = double(screen.x) / double(screen.y);
    for (const RayPath& path : paths) {
        const ImU32 color = path.ofLight ? IM_COL32(255, 200, 60, 200) : IM_COL32(90, 220, 255, 230);
        for (std::size_t i = 1; i < path.points.size(); ++i) {
            const Projected from = projected(camera, path.points[i - 1], aspect);
            const Projected to = projected(camera, path.points[i], aspect);
            if (from.depth <= 0.0 || to.depth <= 0.0) continue;
            canvas->AddLine(ImVec2(float(from.at.x) * screen.x, float(from.at.y) * screen.y),
                            ImVec2(float(to.at.x) * screen.x, float(to.at.y) * screen.y), color, 1.5f);
        }
    }
}

} // namespace eikonal::window
