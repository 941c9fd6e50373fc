// A scene back to TOML, through the tables that read it.

#include <fmt/format.h>

#include "common/scene_keys.h"
#include "common/scene_toml.h"
#include "common/scene_values.h"

namespace eikonal {
namespace {

template <class Section>
void writeKeys(const Keys<Section>& keys, const Section& section, WrittenSection& written) {
    for (const Key<Section>& key : keys) {
        if (const auto text = key.write(section)) {
            written.values.emplace_back(key.name, *text);
            written.forms.push_back(key.form);
        }
    }
}

/// The kind of an object or a light, which its other keys depend on.
void writeKind(std::string_view key, std::string_view name, WrittenSection& written) {
    written.values.emplace_back(key, writeString(std::string(name)));
    written.forms.emplace_back();
}

template <class Section>
WrittenSection writeSection(const std::string& name, const Keys<Section>& keys, const Section& section) {
    WrittenSection written{"[" + name + "]", name, {}, {}};
    writeKeys(keys, section, written);
    return written;
}

WrittenSection writeObject(const Object& object, std::size_t index) {
    WrittenSection written{"[[object]]", fmt::format("object.{}", index), {}, {}};
    if (const std::string_view shape = shapeName(object.shape); !shape.empty())
        writeKind("shape", shape, written);
    writeKeys(shapeKeys(object.shape), object, written);
    writeKeys(objectKeys(), object, written);
    return written;
}

WrittenSection writeLight(const Light& light, std::size_t index) {
    WrittenSection written{"[[light]]", fmt::format("light.{}", index), {}, {}};
    writeKind("type", lightTypeName(light), written);
    writeKeys(lightKeys(light), light, written);
    return written;
}

} // namespace

std::vector<WrittenSection> writeSections(const Scene& scene) {
    std::vector<WrittenSection> sections;
    sections.push_back(writeSection("domain", domainKeys(), scene.domain));
    sections.push_back(writeSection("medium", mediumKeys(), scene.medium));
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        sections.push_back(writeObject(scene.objects[i], i));
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        sections.push_back(writeLight(scene.lights[i], i));
    sections.push_back(writeSection("camera", cameraKeys(), scene.camera));
    sections.push_back(writeSection("environment", environmentKeys(), scene.environment));
    sections.push_back(writeSection("accuracy", accuracyKeys(), scene.accuracy));
    sections.push_back(writeSection("render", renderKeys(), scene.render));
    return sections;
}

std::string resolvedToml(const Scene& scene) {
    std::string text;
    for (const WrittenSection& section : writeSections(scene)) {
        text += (text.empty() ? "" : "\n") + section.header + "\n";
        for (const auto& [key, value] : section.values)
            text += fmt::format("{} = {}\n", key, value);
    }
    return text;
}

} // namespace eikonal
