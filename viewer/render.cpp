#include "viewer/render.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "common/accuracy.h"
#include "common/environment_map.h"
#include "common/gpu_fields.h"
#include "common/image_io.h"
#include "viewer/accumulate.h"
#include "viewer/clearance.h"
#include "viewer/environment.h"
#include "viewer/generate.h"
#include "viewer/light.h"
#include "viewer/shade.h"
#include "viewer/tone_map.h"

namespace eikonal {

namespace {

using viewer::Tile;
using Clock = std::chrono::steady_clock;

constexpr std::array kChannelNames = {"R",       "G",       "B",       "exit.X",       "exit.Y",
                                      "exit.Z",  "depth.R", "depth.G", "depth.B",      "throughput.R",
                                      "throughput.G", "throughput.B", "steps", "Z",    "optical_length"};

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

template <class Row>
void append(std::vector<Row>& rows, const std::vector<Row>& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

std::optional<viewer::Clearance> clearanceOf(const gpu::Context& context, const Scene& scene, const Fields& fields,
                                             const EffectSet& effects, const BakedLight* bake,
                                             const RenderOptions& options) {
    if (!options.straightFlights) return std::nullopt;
    return viewer::Clearance(context, fields, effects,
                             {.tolerance = scene.accuracy.tolerance, .lit = bake != nullptr});
}

/// All that stays on the device while an image is made.
struct Pipeline {
    GpuFields fields;
    viewer::EnvironmentLight environment;
    viewer::Light light;
    std::optional<viewer::Clearance> clearance;
    std::vector<std::string> defines;
    viewer::RayBatch batch;
    viewer::Generate generate;
    viewer::March march;
    viewer::Shade shade;
    viewer::Accumulate accumulate;
    viewer::ToneMapper toneMap;

    Pipeline(const gpu::Context& context, const Scene& scene, const Fields& sceneFields, const EffectSet& effects,
             const BakedLight* bake, const Image* map, const RenderOptions& options, std::size_t capacity)
        : fields(context, sceneFields, effects),
          // An environment that lights the bake is in its irradiance already.
          environment(context, scene.environment, map,
                      effects.has(Effect::kOpaque) && effects.has(Effect::kEnvironment) &&
                          !(bake && scene.environment.bake)),
          light(context, bake),
          clearance(clearanceOf(context, scene, sceneFields, effects, bake, options)), defines(fields.defines()), batch(context, capacity),
          generate(context, fields.defines(), viewer::Generate::Source::kCamera),
          march(context, allDefines(),
                {stepVoxelsOf(scene.accuracy), options.maxEvaluations, options.stepsPerSlice},
                sceneFields.lattice),
          shade(context, defines), accumulate(context, capacity), toneMap(context, scene.render.toneMap, capacity) {}

    const std::vector<std::string>& allDefines() {
        append(defines, environment.defines());
        append(defines, light.defines());
        if (clearance) append(defines, clearance->defines());
        return defines;
    }
    std::vector<std::pair<std::string, std::size_t>> textures() const {
        auto rows = fields.textures();
        append(rows, light.textures());
        append(rows, environment.textures());
        if (clearance) append(rows, clearance->textures());
        return rows;
    }
};

void configure(Pipeline& pipeline, const Scene& scene, const Fields& fields, const RenderOptions& options) {
    gpu::ViewBlock& view = pipeline.batch.view;
    view.opaqueOffset = float(fields.lattice.voxel);
    view.minThroughput = float(options.minThroughput);
    view.exposureScale = float(std::exp2(scene.render.exposureEv));
    view.sampleWeight = 1.0f / float(scene.render.samples);
    viewer::configureCamera(view, scene.camera, scene.render.size);
    pipeline.environment.configure(view);
    pipeline.light.configure(view);
    pipeline.march.configure(view);
    pipeline.fields.bind();
    pipeline.light.bind();
    pipeline.environment.bind();
    if (pipeline.clearance) {
        pipeline.clearance->configure(view);
        pipeline.clearance->bind();
    }
}

void renderSample(Pipeline& pipeline, const Tile& tile, int sample, viewer::PixelFilter filter) {
    viewer::RayBatch& batch = pipeline.batch;
    viewer::configureTile(batch.view, tile);
    batch.view.sampleIndex = gpu::uint(sample);
    batch.view.subPixel = viewer::subPixelPosition(sample, filter);
    batch.bind();
    pipeline.generate.run(batch);
    pipeline.march.run(batch);
    pipeline.shade.run(batch);
    pipeline.accumulate.run(batch);
}

std::array<float, kChannelNames.size()> channelValues(const gpu::FilmPixel& p) {
    return {p.radiance.x,   p.radiance.y,   p.radiance.z,   p.exitDirection.x, p.exitDirection.y,
            p.exitDirection.z, p.depth.x,   p.depth.y,      p.depth.z,         p.throughput.x,
            p.throughput.y, p.throughput.z, p.steps,        p.entryDistance,   p.opticalLength};
}

void collectTile(const Pipeline& pipeline, const Tile& tile, RenderResult& result) {
    const auto film = pipeline.accumulate.film(tile.pixels());
    const auto display = pipeline.toneMap.display(tile.pixels());
    for (std::size_t i = 0; i < film.size(); ++i) {
        const int x = tile.origin.x + int(i) % tile.size.x;
        const int y = tile.origin.y + int(i) / tile.size.x;
        const std::size_t target = std::size_t(y) * std::size_t(result.size.x) + std::size_t(x);
        const auto values = channelValues(film[i]);
        for (std::size_t c = 0; c < values.size(); ++c) result.channels[c].values[target] = values[c];
        result.display[target] = glm::vec3(display[i]);
    }
}

RenderResult blankResult(const glm::ivec2& size) {
    RenderResult result;
    result.size = size;
    const std::size_t pixels = std::size_t(size.x) * std::size_t(size.y);
    for (const char* name : kChannelNames) result.channels.push_back({name, std::vector<float>(pixels)});
    result.display.resize(pixels);
    return result;
}

void count(const Pipeline& pipeline, const gpu::Context& context, std::size_t capacity, RenderResult& result) {
    const viewer::RayCounts counts = pipeline.accumulate.counts();
    RenderStatistics& statistics = result.statistics;
    statistics.fieldEvaluations = counts.evaluations;
    statistics.clearanceLookUps = counts.lookUps;
    statistics.steps = counts.evaluations - counts.entered + counts.lookUps;
    statistics.textures = pipeline.textures();
    statistics.device = context.rendererName();
    statistics.memoryBytes = capacity * (sizeof(gpu::RayState) + sizeof(gpu::FilmPixel) + sizeof(glm::vec4));
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
    const auto tiles = viewer::tilesOf(scene.render.size, options.tileRays);
    const std::size_t capacity = tiles.empty() ? 0 : tiles.front().pixels();
    const auto map = effects.has(Effect::kEnvironment) ? environmentImage(scene) : std::nullopt;
    Pipeline pipeline(context, scene, fields, effects, bake, map ? &*map : nullptr, options, capacity);
    configure(pipeline, scene, fields, options);
    RenderResult result = blankResult(scene.render.size);
    const double setupSeconds = secondsSince(start);

    std::size_t done = 0;
    for (const Tile& tile : tiles) {
        for (int sample = 0; sample < scene.render.samples; ++sample) {
            renderSample(pipeline, tile, sample, options.filter);
            result.statistics.rays += tile.pixels();
            done += tile.pixels();
            if (options.progress) {
                options.progress(double(done) / (double(result.display.size()) * scene.render.samples));
            }
        }
        pipeline.toneMap.run(pipeline.batch);
        collectTile(pipeline, tile, result);
    }
    count(pipeline, context, capacity, result);
    context.throwIfError();
    const double totalSeconds = secondsSince(start);
    result.statistics.seconds = {
        {"setup", setupSeconds}, {"image", totalSeconds - setupSeconds}, {"total", totalSeconds}};
    return result;
}

} // namespace eikonal
