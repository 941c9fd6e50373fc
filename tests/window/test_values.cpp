// Values of the panel and their TOML text, and the table of keys.
#include <gtest/gtest.h>

#include <set>

#include "common/scene_toml.h"
#include "viewer/window/bindings.h"
#include "viewer/window/key_names.h"
#include "viewer/window/value_edit.h"

namespace eikonal::window {
namespace {

TEST(Values, NumbersKeepTheirTextThereAndBack) {
    EXPECT_EQ(numbersIn("[1, -2.5, 3e-4]"), (std::vector<double>{1.0, -2.5, 3e-4}));
    for (const char* text : {"64", "0.25", "[1, 0.5]", "[0.1, 0.2, 0.3]"}) {
        EXPECT_EQ(textOfNumbers(*numbersIn(text), false), text);
    }
    EXPECT_EQ(textOfNumbers({63.6}, true), "64");
}

TEST(Values, WhatIsNoNumberIsText) {
    for (const char* text : {"\"1 + y\"", "true", "[]", "[[1, 2, 3], [4, 5, 6]]", "[1, 2, 3, 4, 5]"}) {
        EXPECT_FALSE(numbersIn(text)) << text;
    }
}

TEST(Values, EveryValueOfASceneHasAForm) {
    const Scene scene = parseScene("[[object]]\n[[light]]\ntype = \"spot\"\n", "a.toml", ".");
    bool choices = false, integers = false;
    for (const WrittenSection& section : writeSections(scene)) {
        ASSERT_EQ(section.forms.size(), section.values.size()) << section.path;
        for (std::size_t i = 0; i < section.forms.size(); ++i) {
            choices = choices || (section.values[i].first == "tone_map" && section.forms[i].choices.size() == 3);
            integers = integers || (section.values[i].first == "resolution" && section.forms[i].isInteger);
        }
    }
    EXPECT_TRUE(choices && integers);
}

TEST(Bindings, EveryKeyIsOneAndHasOneMeaning) {
    std::set<std::string_view> keys;
    for (const Binding& binding : bindings()) {
        EXPECT_TRUE(keys.insert(binding.key).second) << binding.key;
        EXPECT_GE(keyOf(std::string(binding.key)), 0) << binding.key;
        EXPECT_EQ(keyName(keyOf(std::string(binding.key))), binding.key);
        EXPECT_EQ(bindingOf(binding.key), &binding);
    }
    for (const char* flight : {"w", "a", "s", "d"}) EXPECT_EQ(bindingOf(flight), nullptr);
}

} // namespace
} // namespace eikonal::window
