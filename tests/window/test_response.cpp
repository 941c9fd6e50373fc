// How quickly the window answered: what is counted, and from when to when.
#include <gtest/gtest.h>

#include "viewer/window/response.h"

namespace eikonal::window {
namespace {

TEST(Response, CountsTheFramesInWhichTheCameraMoves) {
    Response response;
    response.frameEnded({0.1, 0.2}, {320, 180}, true);
    response.frameEnded({9.0, 9.0}, {960, 540}, false);
    ASSERT_EQ(response.record().moving.size(), 1u);
    EXPECT_EQ(response.record().moving[0].size, glm::ivec2(320, 180));
    EXPECT_EQ(response.record().moving[0].took.processor, 0.2);
}

TEST(Response, ADragIsAnsweredByTheFirstLightThatIsNotOlder) {
    Response response;
    response.lightDragged(3, {1.0, 10.0});
    response.frameEnded({}, {}, false);
    response.lightDragged(4, {2.0, 11.0});
    response.lightShown(2, {2.5, 11.5});
    EXPECT_TRUE(response.record().lights.empty()) << "light from before the drag is no answer";
    response.frameEnded({}, {}, false);
    response.lightShown(4, {4.0, 15.0});
    ASSERT_EQ(response.record().lights.size(), 2u);
    EXPECT_EQ(response.record().lights[0].took.clock, 3.0);
    EXPECT_EQ(response.record().lights[0].frames, 3);
    EXPECT_EQ(response.record().lights[1].took.processor, 4.0);
    EXPECT_EQ(response.record().lights[1].frames, 2);
    response.lightShown(4, {5.0, 16.0});
    EXPECT_EQ(response.record().lights.size(), 2u) << "an answer counts once";
}

TEST(Response, RestBeginsWithTheLastChangeAndEndsOnce) {
    Response response;
    response.refined({1.0, 1.0});
    EXPECT_TRUE(response.record().refinements.empty()) << "nothing has changed";
    response.changed({2.0, 2.0});
    response.changed({3.0, 4.0});
    response.refined({8.0, 10.0});
    response.refined({9.0, 11.0});
    ASSERT_EQ(response.record().refinements.size(), 1u);
    EXPECT_EQ(response.record().refinements[0].clock, 5.0);
    EXPECT_EQ(response.record().refinements[0].processor, 6.0);
}

} // namespace
} // namespace eikonal::window
