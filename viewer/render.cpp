#include "viewer/render.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

#include "viewer/portions.h"

namespace eikonal {

namespace {

using viewer::Tile;
using Clock = std::chrono::steady_clock;

constexpr std::array kChannelNames = {"R",       "G",       "B",       "exit.X",       "exit.Y",
                                      "exit.Z",  "depth.R", "depth.G", "depth.B",      "throughput.R",
                                      "throughput.G", "throughput.B", "steps", "Z",    "optical_length",
                                      "N.X",     "N.Y",     "N.Z"};

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

std::array<float, kChannelNames.size()> channelValues(const gpu::FilmPixel& p) {
    return {p.radiance.x,   p.radiance.y,   p.radiance.z,   p.exitDirection.x, p.exitDirection.y,
            p.exitDirection.z, p.depth.x,   p.depth.y,      p.depth.z,         p.throughput.x,
            p.throughput.y, p.throughput.z, p.steps,        p.entryDistance,   p.opticalLength,
            p.normal.x,     p.normal.y,     p.normal.z};
}

/// The region's pixels into the picture; their noise.
viewer::FilmNoise collectRegion(ProgressiveImage& image, RenderResult& result) {
    const Tile& tile = image.region();
    const auto targetOf = [&](std::size_t pixel) {
        const int x = tile.origin.x + int(pixel) % tile.size.x;
        const int y = tile.origin.y + int(pixel) / tile.size.x;
        return std::size_t(y) * std::size_t(result.size.x) + std::size_t(x);
    };
    const auto display = image.display();
    for (std::size_t i = 0; i < display.size(); ++i) result.display[targetOf(i)] = glm::vec3(display[i]);
    viewer::FilmNoise noise;
    image.visitFilm([&](std::size_t first, std::span<const gpu::FilmPixel> pixels) {
        noise += viewer::noiseOf(pixels, image.samples());
        if (result.channels.empty()) return;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const std::size_t target = targetOf(first + i);
            const auto values = channelValues(pixels[i]);
            for (std::size_t c = 0; c < values.size(); ++c) result.channels[c].values[target] = values[c];
        }
    });
    return noise;
}

/// Noise is met over all pixels of a region, so where it is asked for regions are as large as a film may be on every device.
std::size_t mostRegionPixels(const ProgressiveImage& image, const RenderSettings& settings) {
    constexpr std::size_t kEveryDevicesBlock = 128u << 20;  // bytes
    return settings.noise > 0.0 ? kEveryDevicesBlock / sizeof(gpu::FilmPixel) : image.mostRays();
}

RenderResult blankResult(const glm::ivec2& size, bool hasChannels) {
    RenderResult result;
    result.size = size;
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    if (hasChannels) {
        for (const char* name : kChannelNames) result.channels.push_back({name, std::vector<float>(pixels)});
    }
    result.display.resize(pixels);
    return result;
}

void count(ProgressiveImage& image, const gpu::Context& context, RenderStatistics& statistics) {
    const viewer::RayCounts counts = image.counts();
    statistics.reflectedRays = image.reflectedRays();
    statistics.fieldEvaluations = counts.evaluations;
    statistics.clearanceLookUps = counts.lookUps;
    statistics.matterSamples = counts.matterSamples;
    statistics.steps = counts.evaluations - counts.entered + counts.lookUps;
    statistics.textures = image.textures();
    statistics.marchInstructions = image.marchInstructions();
    statistics.device = context.rendererName();
    statistics.memoryBytes = image.bufferBytes();
    for (const auto& [name, bytes] : statistics.textures) statistics.memoryBytes += bytes;
}

} // namespace

const RenderChannel& RenderResult::channel(std::string_view name) const {
    const auto found = std::find_if(channels.begin(), channels.end(), [&](const auto& c) { return c.name == name; });
    if (found == channels.end()) throw std::logic_error("no channel is named '" + std::string(name) + "'");
    return *found;
}

glm::vec3 RenderResult::radiance(int x, int y) const {
    const std::size_t pixel = std::size_t(y) * std::size_t(size.x) + std::size_t(x);
    return {channels[0].values[pixel], channels[1].values[pixel], channels[2].values[pixel]};
}

RenderResult renderScene(const gpu::Context& context, const Scene& scene, const Fields& fields,
                         const EffectSet& effects, const BakedLight* bake, const RenderOptions& options) {
    const auto start = Clock::now();
    RenderOptions imageOptions = options;
    const auto regions = viewer::tilesOf(scene.render.size, viewer::raysAtATime(options.tileRays, context.limits()));
    if (!regions.empty()) imageOptions.tileRays = regions.front().pixels();
    ProgressiveImage image(context, scene, fields, effects, bake, imageOptions);
    const double setupSeconds = secondsSince(start);
    RenderResult result = renderFrame(image, scene.render, options.progress, options.channels);
    count(image, context, result.statistics);
    context.throwIfError();
    const double totalSeconds = secondsSince(start);
    result.statistics.seconds = {
        {"setup", setupSeconds}, {"image", totalSeconds - setupSeconds}, {"total", totalSeconds}};
    return result;
}

RenderResult renderFrame(ProgressiveImage& image, const RenderSettings& settings,
                         const std::function<void(double)>& progress, bool channels) {
    RenderResult result = blankResult(settings.size, channels);
    const double pixels = double(result.display.size());
    viewer::FilmNoise noise;
    double pixelsDone = 0.0;
    for (const Tile& region : viewer::tilesOf(settings.size, mostRegionPixels(image, settings))) {
        image.setFrame(settings.size, region);
        while (!image.isComplete()) {
            result.statistics.rays += image.addRays(region.pixels());
            const double ofRegion = (image.rounds() + image.roundProgress()) / image.mostRounds();
            if (progress) progress((pixelsDone + double(region.pixels()) * ofRegion) / pixels);
        }
        pixelsDone += double(region.pixels());
        result.statistics.samples += image.samples() * double(region.pixels()) / pixels;
        noise += collectRegion(image, result);
    }
    result.statistics.noise = noise.relative();
    return result;
}

RenderResult readImage(ProgressiveImage& image) {
    RenderResult result = blankResult(image.frameSize(), true);
    collectRegion(image, result);
    return result;
}

} // namespace eikonal
