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

bool endsWith(const std::string& text, std::string_view end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// Whether a key says where an object with a lattice of its own is, which does not change what is on the lattice.
bool movesInset(const std::string& key, const Scene& scene) {
    if (!endsWith(key, ".translate") && !endsWith(key, ".rotate") && !endsWith(key, ".scale")) return false;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].resolution && startsWith(key, "object." + std::to_string(i) + ".")) return true;
    }
    return false;
}

void note(const std::string& key, const Scene& after, Redo& redo) {
    if (endsWith(key, ".name") || key == "render.size") return;
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
    } else if (movesInset(key, after)) {
        redo.insets = true;
    } else if (startsWith(key, "domain.") || startsWith(key, "medium.") || startsWith(key, "object.")) {
        redo.fields = true;
    } else if (key == "render.effects") {
        redo.image = redo.light = true;
    } else {
        redo.image = redo.image || key == "accuracy.step" || key == "accuracy.integrator" ||
                     key == "accuracy.interpolation" || key == "accuracy.reflections";
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
    redo.image = redo.image || redo.fields || interpolationOfImages(before.accuracy) != interpolationOfImages(after.accuracy);
    redo.light = redo.light || redo.fields || redo.insets;
    return redo;
}

bool differInEffectsOnly(Scene before, const Scene& after) {
    before.render.effects = after.render.effects;
    const Redo redo = redoFor(before, after);
    return !redo.image && !redo.insets && !redo.camera;
}

} // namespace eikonal::window
