#pragma once
// Makes rows of the tables in scene_keys.cpp and shape_keys.cpp. `access` is a pointer to member, or a callable from
// section to member that takes const and non-const sections.

#include <functional>
#include <string>
#include <utility>

#include "common/scene_keys.h"
#include "common/scene_values.h"

namespace eikonal::keys {

template <class Section, class Access>
Key<Section> number(std::string_view name, Access access, Limits limits) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readNumber(node, key, limits);
            },
            [=](const Section& section) { return writeNumber(std::invoke(access, section)); }};
}

/// A number that a scene may leave to the program: `access` leads to an optional, unset where the file says "auto".
/// `expected`: what is, for messages.
template <class Section, class Access>
Key<Section> numberOrAuto(std::string_view name, Access access, Limits limits, std::string_view expected) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                const bool isAuto = node.value<std::string_view>() == "auto";
                if (!isAuto && !node.is_number())
                    throw wrongValue(node, key, std::string(expected));
                std::invoke(access, section).reset();
                if (!isAuto)
                    std::invoke(access, section) = readNumber(node, key, limits);
            },
            [=](const Section& section) {
                const auto& value = std::invoke(access, section);
                return value ? writeNumber(*value) : writeString("auto");
            }};
}

template <class Section, class Access>
Key<Section> integer(std::string_view name, Access access, Limits limits) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readInteger(node, key, limits);
            },
            [=](const Section& section) { return std::to_string(std::invoke(access, section)); },
            {.isInteger = true, .choices = {}}};
}

template <class Section, class Access>
Key<Section> flag(std::string_view name, Access access) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readBool(node, key);
            },
            [=](const Section& section) { return std::string(std::invoke(access, section) ? "true" : "false"); }};
}

template <class Section, class Access>
Key<Section> text(std::string_view name, Access access) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readString(node, key);
            },
            [=](const Section& section) { return writeString(std::invoke(access, section)); }};
}

/// A path, kept as it stands in the file.
template <class Section, class Access>
Key<Section> file(std::string_view name, Access access) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readString(node, key);
            },
            [=](const Section& section) { return writeString(std::invoke(access, section).generic_string()); }};
}

template <class Section, class Access>
Key<Section> vector2(std::string_view name, Access access, Limits limits) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readVector2(node, key, limits);
            },
            [=](const Section& section) { return writeVector(std::invoke(access, section)); }};
}

template <class Section, class Access>
Key<Section> vector3(std::string_view name, Access access, Limits limits) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readVector3(node, key, limits);
            },
            [=](const Section& section) { return writeVector(std::invoke(access, section)); }};
}

template <class Section, class Access>
Key<Section> quantity(std::string_view name, Access access, Limits limits, Bands bands) {
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readQuantity(node, key, limits, bands);
            },
            [=](const Section& section) { return writeQuantity(std::invoke(access, section), bands); }};
}

template <class Section, class Access, class Choice>
Key<Section> choice(std::string_view name, Access access, Choices<Choice> choices) {
    ValueForm form;
    for (const auto& [choiceName, value] : choices) form.choices.push_back(choiceName);
    return {name,
            [=](Section& section, const toml::node& node, const std::string& key) {
                std::invoke(access, section) = readChoice(node, key, choices);
            },
            [=](const Section& section) { return writeChoice(std::invoke(access, section), choices); }, form};
}

} // namespace eikonal::keys
