// Recordings: text and back, what is no recording, and when events are due.
#include <gtest/gtest.h>

#include "common/error.h"
#include "viewer/window/event.h"
#include "viewer/window/script.h"

namespace eikonal::window {
namespace {

constexpr std::string_view kRecording = R"(# one of each
0 size 1280 720
1 cursor 640.5 -3
1 button left down
2 button middle up
3 scroll -1.5
4 key f12 down
4 text 0
5 drop a folder/ball.toml
6 set light.0.direction=[0, 1, 0]

7 wait
7 changed
7 save lit.vdb
7 minimise
7 restore
8 screenshot shot.png
9 quit
)";

std::string messageFor(const std::string& text) {
    try {
        parseEvents(text, "a.rec");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::kBadInput);
        return error.what();
    }
    return "accepted";
}

TEST(Events, AreTheSameAfterTheirText) {
    const std::vector<Event> events = parseEvents(kRecording, "a.rec");
    ASSERT_EQ(events.size(), 16u);
    EXPECT_EQ(events[7].name, "a folder/ball.toml");
    EXPECT_EQ(events[8].name, "light.0.direction=[0, 1, 0]");
    EXPECT_DOUBLE_EQ(events[1].at.y, -3.0);
    std::string text;
    for (const Event& event : events) text += eventText(event) + "\n";
    EXPECT_EQ(parseEvents(text, "b.rec"), events);
}

TEST(Events, RefuseWhatIsNoneAndSayWhere) {
    EXPECT_NE(messageFor("0 quit\n1 jump 3\n").find("a.rec:2: unknown event 'jump'"), std::string::npos);
    EXPECT_NE(messageFor("5 quit\n4 quit\n").find("a.rec:2: expected frame 5 or later, found 4"), std::string::npos);
    for (const char* line : {"quit", "-1 quit", "0 cursor 1", "0 cursor 1 2 3", "0 button left", "0 button left sideways",
                             "0 scroll much", "0 drop", "0 quit now"}) {
        EXPECT_NE(messageFor(line).find("a.rec:1: "), std::string::npos) << line;
    }
}

TEST(Script, GivesEveryEventInItsFrame) {
    Script script(parseEvents("0 scroll 1\n2 scroll 2\n2 scroll 3\n5 quit\n", "a.rec"));
    std::vector<std::size_t> counts;
    while (!script.isDone()) counts.push_back(script.next({}).size());
    EXPECT_EQ(counts, (std::vector<std::size_t>{1, 0, 2, 0, 0, 1}));
}

TEST(Script, WaitsUntilAllIsSettledAndCountsNoFrames) {
    Script script(parseEvents("0 scroll 1\n1 wait\n1 scroll 2\n2 quit\n", "a.rec"));
    EXPECT_EQ(script.next({}).size(), 1u);
    EXPECT_TRUE(script.next({.settled = true}).empty()) << "what is settled now may not be what the events before asked for";
    for (int i = 0; i < 5; ++i) EXPECT_TRUE(script.next({}).empty());
    EXPECT_EQ(script.next({.settled = true}).size(), 1u);
    EXPECT_EQ(script.next({}).size(), 1u);
    EXPECT_TRUE(script.isDone());
}

TEST(Script, WaitsForAnotherReadingOfFiles) {
    Script script(parseEvents("0 scroll 1\n0 changed\n0 quit\n", "a.rec"));
    EXPECT_EQ(script.next({.settled = true, .readings = 3}).size(), 1u);
    EXPECT_TRUE(script.isWaiting());
    EXPECT_TRUE(script.next({.settled = true, .readings = 3}).empty());
    EXPECT_EQ(script.next({.settled = false, .readings = 4}).size(), 1u);
}

} // namespace
} // namespace eikonal::window
