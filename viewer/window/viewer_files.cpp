// Files that are read, watched and written.
#include <utility>

#include <fmt/core.h>

#include "common/error.h"
#include "common/file_kind.h"
#include "common/image_io.h"
#include "common/output_file.h"
#include "common/scene_toml.h"
#include "viewer/image_file.h"
#include "viewer/window/look_range.h"
#include "viewer/window/viewer_state.h"

namespace eikonal::window {

namespace {

constexpr double kSecondsBetweenLooks = 0.5;  // at the files

/// The first of `stem`_0001, `stem`_0002, ... that none of the extensions has a file for.
std::filesystem::path freeName(const std::filesystem::path& stem, std::initializer_list<const char*> extensions) {
    for (int number = 1;; ++number) {
        const std::string name = fmt::format("{}_{:04d}", stem.string(), number);
        bool taken = false;
        for (const char* extension : extensions) taken = taken || std::filesystem::exists(name + extension);
        if (!taken) return name;
    }
}

void append(const std::filesystem::path& folder, std::vector<std::filesystem::path>& files) {
    if (folder.empty()) return;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.is_regular_file()) files.push_back(entry.path());
    }
}

} // namespace

void Viewer::open(const std::string& file) {
    if (isEnvironmentMap(file)) return change("environment.image=" + std::filesystem::absolute(file).string());
    adopt(Document(file, {}), {.image = true, .fields = true}, OldLight::kGoes);
    viewer::LookSettings look;
    look.slicePosition = middleOf(domain(), look.sliceAxis);
    chooseLook(look);
    keyframe_ = 0.0;
    oldestRequest_ = startBake();
    window_.setTitle("Eikonal: " + std::filesystem::path(file).filename().string());
}

void Viewer::reload() {
    Document again = document_;
    again.reload();
    adopt(std::move(again), {.image = true, .fields = true, .light = true});
}

void Viewer::followFiles() {
    const auto now = Clock::now();
    if (now - lastLook_ < std::chrono::duration<double>(kSecondsBetweenLooks)) return;
    lastLook_ = now;
    if (!watch_.haveChanged()) return;
    ++readings_;
    attempt([&] { reload(); });
}

void Viewer::watchFiles() {
    std::vector<std::filesystem::path> files = document_.files();
    append(options_.shaders, files);
    watch_.watch(files);
}

void Viewer::saveWhenSettled() {
    if (!session_->isRefined() || bake_.isBusy()) return;
    if (std::exchange(stillIsWanted_, false)) attempt([&] { saveStill(); });
    if (const auto file = std::exchange(lightFileWanted_, std::nullopt); file && light_) {
        attempt([&] { saveLight(*file); });
    }
}

void Viewer::saveLight(const std::filesystem::path& file) {
    options_.saveLight(file, scene(), *document_.light().fields, {light_->light, light_->statistics, {}});
    options_.print(file.string());
    say("saved " + file.string(), false);
}

void Viewer::saveStill() {
    const std::filesystem::path name = freeName("eikonal", {".png", ".exr"});
    const RenderResult image = readImage(session_->image());
    writeRendered(name.string() + ".exr", image, attributesOf(image, scene(), options_.creator));
    writeRendered(name.string() + ".png", image, {});
    options_.print(fmt::format("{0}.png, {0}.exr", name.string()));
    say(fmt::format("saved {0}.png and {0}.exr", name.string()), false);
}

void Viewer::save(const std::filesystem::path& name) {
    const std::filesystem::path file = scene().folder / name;
    if (isVolumeFile(file)) {
        if (!document_.wantsLight()) throw badInput("save: expected a scene with matter that shows light, found none to save");
        lightFileWanted_ = file;
        return say(fmt::format("{} is written once the light is refined", file.string()), false);
    }
    if (extensionOf(file) != ".toml") {
        throw badInput(fmt::format("save: expected a name that ends in .toml, or .vdb for the light, found '{}'", name.string()));
    }
    writeFile(file, document_.textFor(file.parent_path()));
    options_.print(file.string());
    say("saved " + file.string(), false);
}

void Viewer::saveWished(const SaveWish& wish) {
    save(wish.file);
    if (wish.light) save(std::filesystem::path(wish.file).replace_extension(".vdb"));
}

void Viewer::saveNumberedScene() {
    save(freeName(scene().folder / document_.file().stem(), {".toml"}).filename().string() + ".toml");
}

void Viewer::takeScreenshots() {
    for (const std::string& file : screenshots_) writeDisplay(file, pixels_, window_.screenshot());
    screenshots_.clear();
}

} // namespace eikonal::window
