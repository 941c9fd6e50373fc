// Depth of field of the thin lens.
#include "common/physics.h"
#include "tests/viewer/defocused_edge.h"
#include "viewer/render.h"

namespace eikonal {
namespace {

RenderResult rendered(const Scene& scene, const Fields& fields, const RenderOptions& options = {}) {
    return renderScene(test::sharedContext(), scene, fields, test::effectsOf(scene, fields), nullptr, options);
}

double meanOfColumn(const RenderResult& image, int column) {
    double sum = 0.0;
    for (int row = 0; row < image.size.y; ++row) sum += image.radiance(column, row).g / double(image.size.y);
    return sum;
}

TEST(Lens, PlacesFillTheDiscEvenly) {
    constexpr int kEdge = 64;
    double innerHalf = 0.0, square = 0.0;
    glm::dvec2 mean(0.0);
    for (int i = 0; i < kEdge * kEdge; ++i) {
        const glm::dvec2 place = f64::discPlace((glm::dvec2(i % kEdge, i / kEdge) + 0.5) / double(kEdge));
        ASSERT_LE(glm::length(place), 1.0);
        mean += place / double(kEdge * kEdge);
        square += glm::dot(place, place) / double(kEdge * kEdge);
        innerHalf += glm::dot(place, place) < 0.5 ? 1.0 / (kEdge * kEdge) : 0.0;
    }
    EXPECT_NEAR(glm::length(mean), 0.0, 1e-12);
    EXPECT_NEAR(square, 0.5, 1e-12);     // of a disc: half its radius squared
    EXPECT_NEAR(innerHalf, 0.5, 1e-12);  // the stratum that the circle would cut lies on one side of it
}

TEST(Lens, RaysMeetInThePlaneInFocus) {
    const glm::dvec3 middle(0.3, -0.2, 4.0), through(0.1, 0.2, -1.0);
    for (const glm::dvec2 place : {glm::dvec2(0.0), glm::dvec2(0.5, 0.0), glm::dvec2(-0.2, 0.4)}) {
        const f64::LensRay ray = f64::thinLensRay(middle, through, 2.5, glm::dvec3(place, 0.0));
        const glm::dvec3 met = ray.origin + ray.direction * (-2.5 / ray.direction.z);
        EXPECT_NEAR(glm::length(met - (middle + 2.5 * through)), 0.0, 1e-14);
    }
}

TEST(Lens, BlursAnEdgeByItsCircleOfConfusion) {
    const test::DefocusedEdge edge;
    const RenderResult image = rendered(edge.scene, edge.fields);
    const double plateau = meanOfColumn(image, 0);
    for (int column = 0; column < image.size.x; ++column) {
        // 256 places leave about 0.02 of noise in a pixel, 0.004 in the mean of a column's 33; voxel and pixel soften the edge
        // by 0.001, and oblique rays have a path through the sheet that is longer by 0.006 at the most.
        EXPECT_NEAR(meanOfColumn(image, column) / plateau, test::DefocusedEdge::shareOf(column), 0.012) << column;
    }
}

TEST(Lens, LeavesSharpWhatIsInFocus) {
    test::DefocusedEdge edge;
    edge.scene.camera.focus.reset();  // that of lookAt, which is in the sheet
    const RenderResult image = rendered(edge.scene, edge.fields);
    edge.scene.camera.focus = test::DefocusedEdge::kDistance;
    EXPECT_EQ(rendered(edge.scene, edge.fields).channels[0].values, image.channels[0].values);
    edge.scene.camera.aperture = 0.0;
    const RenderResult pinhole = rendered(edge.scene, edge.fields);
    for (int column = 0; column < image.size.x; ++column)
        EXPECT_NEAR(meanOfColumn(image, column), meanOfColumn(pinhole, column), 0.012) << column;  // as above
}

TEST(Lens, LeavesTheOtherChannelsToTheRayThroughItsMiddle) {
    test::DefocusedEdge edge;
    edge.scene.render.samples = 2;
    const RenderResult image = rendered(edge.scene, edge.fields);
    edge.scene.camera.aperture = 0.0;
    const RenderResult pinhole = rendered(edge.scene, edge.fields);
    for (std::size_t c = 3; c < image.channels.size(); ++c) {
        for (std::size_t i = 0; i < image.channels[c].values.size(); ++i) {
            const float value = pinhole.channels[c].values[i];
            // The same ray by another formula: some roundings of floats.
            ASSERT_NEAR(image.channels[c].values[i], value, 1e-6 * std::max(1.0f, std::abs(value)))
                << image.channels[c].name;
        }
    }
    EXPECT_NE(image.channels[0].values, pinhole.channels[0].values);
}

TEST(Lens, IsTheSameInAnyTiles) {
    test::DefocusedEdge edge;
    edge.scene.render.samples = 3;
    const RenderResult whole = rendered(edge.scene, edge.fields);
    EXPECT_EQ(rendered(edge.scene, edge.fields, {.tileRays = 77}).channels[0].values, whole.channels[0].values);
}

} // namespace
} // namespace eikonal
