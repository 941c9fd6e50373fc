#include "viewer/window/event.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/core.h>

#include "common/error.h"

namespace eikonal::window {

namespace {

/// What follows the event's word on its line.
enum class Form { kNothing, kNumber, kPoint, kSwitch, kRest };

struct Word {
    std::string_view name;
    EventKind kind;
    Form form;
    std::string_view expected;
};

constexpr std::array<Word, 15> kWords{{
    {"cursor", EventKind::kCursor, Form::kPoint, "x and y in pixels"},
    {"button", EventKind::kButton, Form::kSwitch, "a button and 'down' or 'up'"},
    {"scroll", EventKind::kScroll, Form::kNumber, "notches"},
    {"key", EventKind::kKey, Form::kSwitch, "a key and 'down' or 'up'"},
    {"text", EventKind::kText, Form::kRest, "characters"},
    {"size", EventKind::kSize, Form::kPoint, "width and height in pixels"},
    {"minimise", EventKind::kMinimise, Form::kNothing, "nothing"},
    {"restore", EventKind::kRestore, Form::kNothing, "nothing"},
    {"drop", EventKind::kDrop, Form::kRest, "a file"},
    {"save", EventKind::kSave, Form::kRest, "a file"},
    {"set", EventKind::kSet, Form::kRest, "key.path=value"},
    {"wait", EventKind::kWait, Form::kNothing, "nothing"},
    {"changed", EventKind::kChanged, Form::kNothing, "nothing"},
    {"screenshot", EventKind::kScreenshot, Form::kRest, "a file"},
    {"quit", EventKind::kQuit, Form::kNothing, "nothing"},
}};

const Word& wordOf(EventKind kind) { return kWords[std::size_t(kind)]; }

/// The rest of a line without the blanks around it.
std::string restOf(std::istringstream& line) {
    std::string rest;
    std::getline(line >> std::ws, rest);
    rest.erase(std::find_if(rest.rbegin(), rest.rend(), [](char c) { return c != ' ' && c != '\r'; }).base(), rest.end());
    return rest;
}

bool readArguments(std::istringstream& line, Form form, Event& event) {
    std::string position;
    switch (form) {
        case Form::kNothing: break;
        case Form::kNumber: line >> event.at.x; break;
        case Form::kPoint: line >> event.at.x >> event.at.y; break;
        case Form::kSwitch:
            line >> event.name >> position;
            event.down = position == "down";
            if (position != "down" && position != "up") return false;
            break;
        case Form::kRest:
            event.name = restOf(line);
            return !event.name.empty();
    }
    return !line.fail() && restOf(line).empty();
}

Event parseLine(const std::string& text, const std::string& where) {
    std::istringstream line(text);
    Event event;
    long long frame = 0;
    std::string name;
    if (!(line >> frame >> name) || frame < 0) {
        throw badInput(fmt::format("{}: expected a frame and an event, found '{}'", where, text));
    }
    event.frame = std::uint64_t(frame);
    const auto word = std::find_if(kWords.begin(), kWords.end(), [&](const Word& w) { return w.name == name; });
    if (word == kWords.end()) throw badInput(fmt::format("{}: unknown event '{}'", where, name));
    event.kind = word->kind;
    if (!readArguments(line, word->form, event)) {
        throw badInput(fmt::format("{}: {}: expected {}, found '{}'", where, name, word->expected, text));
    }
    return event;
}

} // namespace

std::string eventText(const Event& event) {
    const Word& word = wordOf(event.kind);
    const std::string start = fmt::format("{} {}", event.frame, word.name);
    switch (word.form) {
        case Form::kNothing: break;
        case Form::kNumber: return fmt::format("{} {}", start, event.at.x);
        case Form::kPoint: return fmt::format("{} {} {}", start, event.at.x, event.at.y);
        case Form::kSwitch: return fmt::format("{} {} {}", start, event.name, event.down ? "down" : "up");
        case Form::kRest: return fmt::format("{} {}", start, event.name);
    }
    return start;
}

std::vector<Event> parseEvents(std::string_view text, const std::string& source) {
    std::vector<Event> events;
    std::istringstream lines{std::string(text)};
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
        if (line.empty() || line == "\r" || line.front() == '#') continue;
        const std::string where = fmt::format("{}:{}", source, number);
        events.push_back(parseLine(line, where));
        if (events.size() > 1 && events.back().frame < events[events.size() - 2].frame) {
            throw badInput(fmt::format("{}: expected frame {} or later, found {}", where, events[events.size() - 2].frame,
                                       events.back().frame));
        }
    }
    return events;
}

std::vector<Event> readEvents(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream) throw badInput(fmt::format("{}: expected a recording, found no file that can be read", file.string()));
    return parseEvents(text, file.string());
}

} // namespace eikonal::window
