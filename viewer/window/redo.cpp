#include "viewer/window/redo.h"

#include <map>
#include <string>

#include "common/accuracy.h"
#include "common/scene_toml.h"

namespace eikonal::window {

namespace {

std::map<std::string, std::string> valuesOf(const Scene& scene) {
    std::map<std::string, std::string> values;
    for (const WrittenSection& section : writeSections(scene)) {
        for (const auto& [key, text] : section.values) values[section.path + "." + key] = text;
    }
    return values;
}

bool startsWith(const std::string& text, std::string_view start) { return text.rfind(start, 0) == 0; }

void note(const std::string& key, const Scene& after, Redo& redo) {
    const bool name = key.size() > 5 && key.compare(key.size() - 5, 5, ".name") == 0;
    if (name || key == "render.size") return;
    if (startsWith(key, "camera.")) {
        redo.camera = true;
    } else if (key == "render.exposure") {
        redo.exposure = true;
    } else if (startsWith(key, "light.")) {
        redo.light = true;
    } else if (startsWith(key, "environment.")) {
        redo.image = true;
        redo.light = redo.light || after.environment.bake || key == "environment.bake";
    } else if (startsWith(key, "render.") && key != "render.effects") {
        redo.image = true;
    } else if (startsWith(key, "domain.") || startsWith(key, "medium.") || startsWith(key, "object.")) {
        redo.fields = true;
    } else if (key == "render.effects") {
        redo.image = redo.light = true;
    } else {
        redo.image = redo.image || key == "accuracy.step" || key == "accuracy.integrator" || key == "accuracy.reflections";
        redo.light = redo.light || key != "accuracy.integrator";
    }
}

} // namespace

Redo redoFor(const Scene& before, const Scene& after) {
    const auto old = valuesOf(before), now = valuesOf(after);
    Redo redo;
    for (const auto& [key, text] : now) {
        const auto found = old.find(key);
        if (found == old.end() || found->second != text) note(key, after, redo);
    }
    for (const auto& [key, text] : old) {
        if (!now.contains(key)) note(key, after, redo);
    }
    redo.fields = redo.fields || interpolationOf(before.accuracy) != interpolationOf(after.accuracy);
    redo.image = redo.image || redo.fields;
    redo.light = redo.light || redo.fields;
    return redo;
}

} // namespace eikonal::window
