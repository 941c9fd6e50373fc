// Baked light on opaque surfaces against Lambert's cosine law. The bakes are made by formula: each voxel holds the mean over
// its free volume of a beam that the surface itself shadows.
#include <cmath>
#include <numbers>

#include "tests/support/synthetic_fields.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

constexpr double kRadius = 0.4;

/// Share of a voxel's free volume that a beam along -y reaches behind a ball, from 6 x 6 x 6 points.
double litShare(const Lattice& lattice, const glm::ivec3& voxel) {
    int free = 0, lit = 0;
    test::forEachVoxel({glm::dvec3(0.0), 1.0, glm::ivec3(6)}, [&](const glm::ivec3& part) {
        const glm::dvec3 x = lattice.worldFromIndex(voxel) + ((glm::dvec3(part) + 0.5) / 6.0 - 0.5) * lattice.voxel;
        if (glm::length(x) < kRadius) return;
        ++free;
        lit += x.y > 0.0 || std::hypot(x.x, x.z) > kRadius ? 1 : 0;
    });
    return free > 0 ? double(lit) / free : 0.0;
}

struct LitBall {
    Fields fields;
    BakedLight bake;
};

LitBall litBall(int resolution) {
    LitBall ball{test::uniformFields(test::cube(resolution, 1.0)), {}};
    const Lattice& lattice = ball.fields.lattice;
    ball.fields.opaque = DenseGrid<float>(lattice.size, 0.0f);
    ball.fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(1.0f));
    ball.bake = {lattice, DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f)),
                 DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f, -1.0f, 0.0f))};
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        ball.fields.opaque.at(v) = float(test::sphereCoverage(lattice, v, kRadius));
        ball.bake.irradiance.at(v) = glm::vec3(float(litShare(lattice, v)));
    });
    return ball;
}

TEST(Receiver, BallInABeamFollowsTheCosine) {
    const LitBall ball = litBall(40);
    Scene scene = test::plainScene(glm::dvec3(0.0), 30.0, 1.8, 48);
    const glm::dvec3 eye(0.0, 12.0, 30.0);
    scene.camera.position = eye;
    scene.camera.lookAt = {0.0, 0.0, 0.0};
    const RenderResult image =
        renderScene(test::sharedContext(), scene, ball.fields, test::effectsOf(scene, ball.fields), &ball.bake);
    const glm::dvec3 forward = glm::normalize(-eye), right(1.0, 0.0, 0.0), up = glm::cross(right, forward);
    const double half = std::tan(glm::radians(0.9));
    double squares = 0.0, darkest = 1.0, atTerminator = 0.0;
    int count = 0;
    for (int y = 0; y < 48; ++y) {
        for (int x = 0; x < 48; ++x) {
            const glm::dvec3 towards = glm::normalize(forward + right * (half * ((x + 0.5) / 24.0 - 1.0)) -
                                                      up * (half * ((y + 0.5) / 24.0 - 1.0)));
            const double along = -glm::dot(eye, towards);
            const double inside = kRadius * kRadius - glm::dot(eye, eye) + along * along;
            if (inside < 0.15 * kRadius * kRadius) continue;  // not the rim, where voxels show
            const double cosine = (eye + towards * (along - std::sqrt(inside))).y / kRadius;
            const double found = image.radiance(x, y).g * std::numbers::pi;
            squares += std::pow(found - std::max(cosine, 0.0), 2.0);
            if (cosine > 0.25) darkest = std::min(darkest, found / cosine);
            if (std::abs(cosine) < 0.25) atTerminator = std::max(atTerminator, std::abs(found - std::max(cosine, 0.0)));
            ++count;
        }
    }
    ASSERT_GT(count, 500);
    RecordProperty("rms", std::to_string(std::sqrt(squares / count)));
    RecordProperty("darkest", std::to_string(darkest));
    RecordProperty("at terminator", std::to_string(atTerminator));
    // Normals come from coverage over two voxels, which on a radius of 8 voxels is good to 0.014, at worst 0.04; a lookup that
    // mixes in voxels of shade or of hardly any free volume would leave spots that are darker by half.
    EXPECT_LE(std::sqrt(squares / count), 0.02);
    EXPECT_GE(darkest, 0.85);
    // Where light grazes the ball all of a normal's error counts, and a voxel of 8 across the terminator is half in shade.
    EXPECT_LE(atTerminator, 0.07);
}

TEST(Receiver, CutVoxelsWeighByWhatIsFreeOfThem) {
    const Lattice lattice = test::cube(32, 1.0);
    Fields fields = test::uniformFields(lattice);
    fields.opaque = test::boxCoverage(lattice, {-1.0, -1.0, -1.0}, {1.0, 1.0, 0.01875});  // 0.3 of its last voxels
    fields.albedo = DenseGrid<glm::vec3>(lattice.size, glm::vec3(1.0f));
    BakedLight bake{lattice, DenseGrid<glm::vec3>(lattice.size, glm::vec3(2.0f)),
                    DenseGrid<glm::vec3>(lattice.size, glm::vec3(0.0f, 0.0f, -1.0f))};
    test::forEachVoxel(lattice, [&](const glm::ivec3& v) {
        if (v.z < 16) bake.irradiance.at(v) = glm::vec3(0.0f);          // inside: nothing
        if (v.z == 16) bake.irradiance.at(v) = glm::vec3(v.x % 2 ? 5.0f : 0.0f);  // cut: noise
    });
    Scene scene = test::plainScene(glm::dvec3(0.0), 30.0, 0.5, 1);
    const auto lit = [&](double x) {
        scene.camera.position.x = scene.camera.lookAt.x = x;
        return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), &bake).radiance(0, 0).g *
               std::numbers::pi;
    };
    // Coverage is one half 5/7 of the way to the cut voxels' centres, so that a voxel off the surface they get 2/7 of the
    // interpolation. Being 0.7 free they weigh that much of it.
    const double share = 2.0 / 7.0 * 0.7 / (2.0 / 7.0 * 0.7 + 5.0 / 7.0);
    EXPECT_NEAR(lit(0.03125), (1.0 - share) * 2.0, 0.01);  // the hit is found to 1/4000 of a step
    EXPECT_NEAR(lit(0.09375), (1.0 - share) * 2.0 + share * 5.0, 0.01);
}

} // namespace
} // namespace eikonal
