#include "common/scene_edit.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "common/error.h"
#include "common/scene_toml.h"

namespace eikonal {
namespace {

/// `text` in place of the bytes from `begin` to `end`.
struct Edit {
    std::size_t begin, end;
    std::string text;
};

/// Places of a text by line.
class Lines {
public:
    explicit Lines(const std::string& text) : text_(text), starts_{0} {
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') starts_.push_back(i + 1);
        }
    }

    std::size_t start(std::size_t line) const { return line <= starts_.size() ? starts_[line - 1] : text_.size(); }
    /// Of the line after it.
    std::size_t end(std::size_t line) const { return start(line + 1); }
    /// Columns count characters, of one or more bytes.
    std::size_t offset(const toml::source_position& at) const {
        std::size_t place = start(at.line);
        for (std::size_t column = 1; column < at.column && place < text_.size(); ++column) {
            do {
                ++place;
            } while (place < text_.size() && (static_cast<unsigned char>(text_[place]) & 0xC0u) == 0x80u);
        }
        return place;
    }

private:
    const std::string& text_;
    std::vector<std::size_t> starts_;
};

const toml::table* tableOf(const toml::table& root, const std::string& path) {
    const std::size_t dot = path.find('.');
    const toml::node* node = root.get(path.substr(0, dot));
    if (dot != std::string::npos && node && node->is_array()) {
        std::size_t index = 0;
        std::from_chars(path.data() + dot + 1, path.data() + path.size(), index);
        node = node->as_array()->get(index);
    }
    return node ? node->as_table() : nullptr;
}

/// The last line that a table's header and its own values take.
std::size_t lastLine(const toml::table& table) {
    std::size_t last = table.source().begin.line;
    for (const auto& [key, value] : table) {
        if (!value.is_table() && !value.is_array_of_tables()) last = std::max<std::size_t>(last, value.source().end.line);
    }
    return last;
}

const std::string* textOf(const WrittenSection& section, const std::string& key) {
    const auto found = std::find_if(section.values.begin(), section.values.end(), [&](const auto& v) { return v.first == key; });
    return found == section.values.end() ? nullptr : &found->second;
}

class Editor {
public:
    Editor(const std::string& text, const toml::table& root) : text_(text), lines_(text), root_(root) {}

    void changeSection(const WrittenSection& before, const WrittenSection& after) {
        const toml::table* table = tableOf(root_, after.path);
        std::string added;
        for (const auto& [key, value] : after.values) {
            const std::string* old = textOf(before, key);
            if (old && *old == value) continue;
            const toml::node* node = table ? table->get(key) : nullptr;
            if (node && !node->is_array_of_tables()) {
                edits_.push_back({lines_.offset(node->source().begin), lines_.offset(node->source().end), value});
            } else {
                added += fmt::format("{} = {}\n", key, value);
            }
        }
        for (const auto& [key, value] : before.values) {
            if (table && !textOf(after, key)) remove(table->get(key));
        }
        if (!added.empty()) add(table, after.header, added);
    }

    std::string result() {
        std::stable_sort(edits_.begin(), edits_.end(), [](const Edit& a, const Edit& b) { return a.begin > b.begin; });
        std::string edited = text_;
        for (const Edit& edit : edits_) edited.replace(edit.begin, edit.end - edit.begin, edit.text);
        const bool midLine = !newTables_.empty() && !edited.empty() && edited.back() != '\n';
        return edited + (midLine ? "\n" : "") + newTables_;
    }

private:
    void remove(const toml::node* node) {
        if (!node) return;
        if (node->is_array_of_tables()) {
            for (const toml::node& element : *node->as_array()) {
                removeLines(element.source().begin.line, lastLine(*element.as_table()));
            }
        } else {
            removeLines(node->source().begin.line, node->source().end.line);
        }
    }

    void removeLines(std::size_t first, std::size_t last) { edits_.push_back({lines_.start(first), lines_.end(last), ""}); }

    void add(const toml::table* table, const std::string& header, const std::string& values) {
        if (!table) {
            newTables_ += "\n" + header + "\n" + values;
            return;
        }
        const std::size_t place = lines_.end(lastLine(*table));
        const bool midLine = place > 0 && text_[place - 1] != '\n';
        edits_.push_back({place, place, (midLine ? "\n" : "") + values});
    }

    const std::string& text_;
    Lines lines_;
    const toml::table& root_;
    std::vector<Edit> edits_;
    std::string newTables_;  // behind all of the text
};

std::string edited(const std::string& text, const std::filesystem::path& folder, const Scene& scene) {
    const std::vector<WrittenSection> before = writeSections(parseScene(text, scene.source, folder));
    const std::vector<WrittenSection> after = writeSections(scene);
    const auto samePath = [](const WrittenSection& a, const WrittenSection& b) { return a.path == b.path; };
    if (!std::equal(before.begin(), before.end(), after.begin(), after.end(), samePath)) return {};
    const toml::table root = toml::parse(text);
    Editor editor(text, root);
    for (std::size_t i = 0; i < after.size(); ++i) editor.changeSection(before[i], after[i]);
    return editor.result();
}

bool says(const std::string& text, const Scene& scene) {
    return resolvedToml(parseScene(text, scene.source, scene.folder)) == resolvedToml(scene);
}

} // namespace

std::string editedToml(const std::string& text, const std::filesystem::path& folder, const Scene& scene) {
    try {
        if (std::string result = edited(text, folder, scene); !result.empty() && says(result, scene)) return result;
    } catch (const Error&) {  // the text, or what became of it, is no scene: it is written anew
    }
    return resolvedToml(scene);
}

} // namespace eikonal
