#pragma once
// What a person does to the window, frame by frame, and its text: one event a line, to record and to replay.
//
//   12 cursor 640.5 360          pointer, in pixels from the upper left corner
//   12 button left down          left, middle or right; down or up
//   14 scroll 1                  notches of the wheel
//   15 key h down                a key by its name
//   15 text 0.5                  characters typed
//   20 size 1280 720             of the window [pixels]
//   21 minimise                  the window; restore: shows it again
//   30 drop scenes/ball.toml     a file dropped on the window
//   32 save lit.toml             the scene, or with .vdb its light once that is refined
//   40 set light.0.power=[9,9,9] a value of the scene, as --set has it
//   50 wait                      until picture and light are refined; frames do not count meanwhile
//   50 changed                   until a watched file was another one and was read again, or tried to; neither
//   51 screenshot shot.png       what the window shows
//   52 quit

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

namespace eikonal::window {

enum class EventKind { kCursor, kButton, kScroll, kKey, kText, kSize, kMinimise, kRestore, kDrop, kSave, kSet, kWait, kChanged, kScreenshot, kQuit };

struct Event {
    std::uint64_t frame = 0;
    EventKind kind = EventKind::kQuit;
    glm::dvec2 at{0.0};  ///< pixels of kCursor and kSize; x: notches of kScroll
    std::string name;    ///< button, key, text, file or override
    bool down = false;   ///< of kButton and kKey

    bool operator==(const Event&) const = default;
};

/// One line of a recording, without its end.
std::string eventText(const Event& event);

/// Events of a recording, in order; empty lines and lines that start with '#' are left out. Throws badInput with
/// source:line for what is no event and for frames that go backwards.
std::vector<Event> parseEvents(std::string_view text, const std::string& source);

/// The events of a file. Throws badInput as parseEvents, and where it cannot be read.
std::vector<Event> readEvents(const std::filesystem::path& file);

} // namespace eikonal::window
