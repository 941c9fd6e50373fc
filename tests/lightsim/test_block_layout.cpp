// Both languages lay out the structs that the kernels of the bake share alike.
#include "shaders/shared/tube_blocks.h"
#include "tests/support/block_layout.h"
#include "tests/support/synthetic_fields.h"

namespace eikonal {
namespace {

gpu::Kernel kernelOf(const std::string& name) { return gpu::Kernel(test::sharedContext(), name, {"BANDS 3"}); }

test::Members queueStateMembers() {
    return {
        EIKONAL_MEMBER(bake::QueueState, particleGroups), EIKONAL_MEMBER(bake::QueueState, liveCount),
        EIKONAL_MEMBER(bake::QueueState, patchGroups), EIKONAL_MEMBER(bake::QueueState, nextLiveCount),
        EIKONAL_MEMBER(bake::QueueState, emitGroups), EIKONAL_MEMBER(bake::QueueState, emitCount),
        EIKONAL_MEMBER(bake::QueueState, cornersGroups), EIKONAL_MEMBER(bake::QueueState, cornersCount),
        EIKONAL_MEMBER(bake::QueueState, retireGroups), EIKONAL_MEMBER(bake::QueueState, retireCount),
        EIKONAL_MEMBER(bake::QueueState, splitGroups), EIKONAL_MEMBER(bake::QueueState, splitCount),
        EIKONAL_MEMBER(bake::QueueState, recordCount), EIKONAL_MEMBER(bake::QueueState, recordTake),
        EIKONAL_MEMBER(bake::QueueState, nextCell), EIKONAL_MEMBER(bake::QueueState, parity),
        EIKONAL_MEMBER(bake::QueueState, freeHead), EIKONAL_MEMBER(bake::QueueState, freeTail),
        EIKONAL_MEMBER(bake::QueueState, freeTailAtStart), EIKONAL_MEMBER(bake::QueueState, recordOverflow),
        EIKONAL_MEMBER(bake::QueueState, stepsLow), EIKONAL_MEMBER(bake::QueueState, stepsHigh),
        EIKONAL_MEMBER(bake::QueueState, evaluationsLow), EIKONAL_MEMBER(bake::QueueState, evaluationsHigh),
        EIKONAL_MEMBER(bake::QueueState, splits), EIKONAL_MEMBER(bake::QueueState, folds),
        EIKONAL_MEMBER(bake::QueueState, peakLive), EIKONAL_MEMBER(bake::QueueState, unusedA)
    };
}

test::Members particleMembers() {
    return {
        EIKONAL_MEMBER(bake::Particle, x), EIKONAL_MEMBER(bake::Particle, enterPath), EIKONAL_MEMBER(bake::Particle, w),
        EIKONAL_MEMBER(bake::Particle, status), EIKONAL_MEMBER(bake::Particle, xPrevious),
        EIKONAL_MEMBER(bake::Particle, throughputS), EIKONAL_MEMBER(bake::Particle, transmittance),
        EIKONAL_MEMBER(bake::Particle, throughputP), EIKONAL_MEMBER(bake::Particle, meanShare),
        EIKONAL_MEMBER(bake::Particle, enteredShare), EIKONAL_MEMBER(bake::Particle, normal),
        EIKONAL_MEMBER(bake::Particle, gradMax), EIKONAL_MEMBER(bake::Particle, nStart),
        EIKONAL_MEMBER(bake::Particle, nLast), EIKONAL_MEMBER(bake::Particle, along),
        EIKONAL_MEMBER(bake::Particle, sideAtStart), EIKONAL_MEMBER(bake::Particle, absorbedShare),
        EIKONAL_MEMBER(bake::Particle, arcLength), EIKONAL_MEMBER(bake::Particle, scatteredShare),
        EIKONAL_MEMBER(bake::Particle, launchShare), EIKONAL_MEMBER(bake::Particle, reflectedShare),
        EIKONAL_MEMBER(bake::Particle, litPart), EIKONAL_MEMBER(bake::Particle, tint),
        EIKONAL_MEMBER(bake::Particle, weight), EIKONAL_MEMBER(bake::Particle, tintedShare),
        EIKONAL_MEMBER(bake::Particle, blockedAt)
    };
}

test::Members wavefrontPatchMembers() {
    test::Members members = {
        EIKONAL_MEMBER(bake::WavefrontPatch, launchMin), EIKONAL_MEMBER(bake::WavefrontPatch, launchMax),
        EIKONAL_MEMBER(bake::WavefrontPatch, power), EIKONAL_MEMBER(bake::WavefrontPatch, frameIndex),
        EIKONAL_MEMBER(bake::WavefrontPatch, stepCount), EIKONAL_MEMBER(bake::WavefrontPatch, orientation),
        EIKONAL_MEMBER(bake::WavefrontPatch, unusedA), EIKONAL_MEMBER(bake::WavefrontPatch, unusedB)
    };
    for (std::size_t i = 0; i < 4; ++i) {
        members.merge(test::prefixed("corners[" + std::to_string(i) + "].", particleMembers(),
                                     offsetof(bake::WavefrontPatch, corners) + i * sizeof(bake::Particle)));
    }
    return members;
}

test::Members launchFrameMembers() {
    return {
        EIKONAL_MEMBER(bake::LaunchFrame, origin), EIKONAL_MEMBER(bake::LaunchFrame, isPoint),
        EIKONAL_MEMBER(bake::LaunchFrame, centre), EIKONAL_MEMBER(bake::LaunchFrame, phase),
        EIKONAL_MEMBER(bake::LaunchFrame, a), EIKONAL_MEMBER(bake::LaunchFrame, cellsU),
        EIKONAL_MEMBER(bake::LaunchFrame, b), EIKONAL_MEMBER(bake::LaunchFrame, cellsV),
        EIKONAL_MEMBER(bake::LaunchFrame, strength), EIKONAL_MEMBER(bake::LaunchFrame, splitPower),
        EIKONAL_MEMBER(bake::LaunchFrame, axis), EIKONAL_MEMBER(bake::LaunchFrame, firstCell),
        EIKONAL_MEMBER(bake::LaunchFrame, profileAxis), EIKONAL_MEMBER(bake::LaunchFrame, profile),
        EIKONAL_MEMBER(bake::LaunchFrame, coneInner), EIKONAL_MEMBER(bake::LaunchFrame, coneOuter),
        EIKONAL_MEMBER(bake::LaunchFrame, pathBefore), EIKONAL_MEMBER(bake::LaunchFrame, unusedA)
    };
}

test::Members launchRecordMembers() {
    return {
        EIKONAL_MEMBER(bake::LaunchRecord, launchMin), EIKONAL_MEMBER(bake::LaunchRecord, launchMax),
        EIKONAL_MEMBER(bake::LaunchRecord, frameIndex), EIKONAL_MEMBER(bake::LaunchRecord, stepCount),
        EIKONAL_MEMBER(bake::LaunchRecord, orientation), EIKONAL_MEMBER(bake::LaunchRecord, unusedA)
    };
}

test::Members bakeSettingsMembers() {
    return {
        EIKONAL_MEMBER(bake::BakeSettings, opticalStep), EIKONAL_MEMBER(bake::BakeSettings, maxSide),
        EIKONAL_MEMBER(bake::BakeSettings, cullShare), EIKONAL_MEMBER(bake::BakeSettings, maxSteps),
        EIKONAL_MEMBER(bake::BakeSettings, depositScale), EIKONAL_MEMBER(bake::BakeSettings, ledgerScale),
        EIKONAL_MEMBER(bake::BakeSettings, cellCount), EIKONAL_MEMBER(bake::BakeSettings, capacity),
        EIKONAL_MEMBER(bake::BakeSettings, recordCapacity), EIKONAL_MEMBER(bake::BakeSettings, slabBegin),
        EIKONAL_MEMBER(bake::BakeSettings, slabEnd), EIKONAL_MEMBER(bake::BakeSettings, foldsEnd)
    };
}

TEST(BlockLayout, OfThePoolIsTheCompilers) {
    const gpu::Kernel refine = kernelOf("lightsim/refine.comp.glsl");
    const auto patches = test::storageBlockLayout(refine, "PatchBlock");
    EXPECT_EQ(patches.members, test::prefixed("patches[0].", wavefrontPatchMembers()));
    EXPECT_EQ(patches.stride, sizeof(bake::WavefrontPatch));
    auto queue = test::prefixed("queue.", queueStateMembers());
    queue["slotLists[0]"] = sizeof(bake::QueueState);
    EXPECT_EQ(test::storageBlockLayout(refine, "QueueBlock").members, queue);
    const auto records = test::storageBlockLayout(refine, "RecordBlock");
    EXPECT_EQ(records.members, test::prefixed("records[0].", launchRecordMembers()));
    EXPECT_EQ(records.stride, sizeof(bake::LaunchRecord));
}

TEST(BlockLayout, OfWhatIsLaunchedIsTheCompilers) {
    const gpu::Kernel emit = kernelOf("lightsim/emit.comp.glsl");
    const auto frames = test::storageBlockLayout(emit, "FrameBlock");
    EXPECT_EQ(frames.members, test::prefixed("frames[0].", launchFrameMembers()));
    EXPECT_EQ(frames.stride, sizeof(bake::LaunchFrame));
    const auto settings = test::uniformBlockLayout(emit, "SettingsBlock");
    EXPECT_EQ(settings.members, test::prefixed("settings.", bakeSettingsMembers()));
    EXPECT_EQ(settings.bytes, sizeof(bake::BakeSettings));
}

test::Members tubePresenceMembers() {
    return {
        EIKONAL_MEMBER(bake::TubePresence, near),
        EIKONAL_MEMBER(bake::TubePresence, bent),
        EIKONAL_MEMBER(bake::TubePresence, ended),
        EIKONAL_MEMBER(bake::TubePresence, remaining),
        EIKONAL_MEMBER(bake::TubePresence, unusedA),
        EIKONAL_MEMBER(bake::TubePresence, unusedB)
    };
}

test::Members tubeNodeMembers() {
    return {
        EIKONAL_MEMBER(bake::TubeNode, frameIndex),
        EIKONAL_MEMBER(bake::TubeNode, unusedA),
        EIKONAL_MEMBER(bake::TubeNode, unusedB),
        EIKONAL_MEMBER(bake::TubeNode, launchShare)
    };
}

test::Members tubeMeasureMembers() {
    return {
        EIKONAL_MEMBER(bake::TubeMeasure, strong),
        EIKONAL_MEMBER(bake::TubeMeasure, weak),
        EIKONAL_MEMBER(bake::TubeMeasure, launchShare)
    };
}

test::Members tubeConformityMembers() {
    return {
        EIKONAL_MEMBER(bake::TubeConformity, vertex),
        EIKONAL_MEMBER(bake::TubeConformity, first),
        EIKONAL_MEMBER(bake::TubeConformity, second),
        EIKONAL_MEMBER(bake::TubeConformity, unusedA),
        EIKONAL_MEMBER(bake::TubeConformity, live),
        EIKONAL_MEMBER(bake::TubeConformity, unusedB)
    };
}

test::Members tubeSettingsMembers() {
    return {
        EIKONAL_MEMBER(bake::TubeSettings, firstStep),
        EIKONAL_MEMBER(bake::TubeSettings, itemCount),
        EIKONAL_MEMBER(bake::TubeSettings, maxDeviation),
        EIKONAL_MEMBER(bake::TubeSettings, maxShareDeviation),
        EIKONAL_MEMBER(bake::TubeSettings, resolvedSide),
        EIKONAL_MEMBER(bake::TubeSettings, maxUnevenness),
        EIKONAL_MEMBER(bake::TubeSettings, samplesPerVoxel),
        EIKONAL_MEMBER(bake::TubeSettings, nearMargin),
        EIKONAL_MEMBER(bake::TubeSettings, maxUnevenSpread),
        EIKONAL_MEMBER(bake::TubeSettings, evenSide),
        EIKONAL_MEMBER(bake::TubeSettings, mirrorCount),
        EIKONAL_MEMBER(bake::TubeSettings, mirrors)
    };
}

TEST(BlockLayout, OfTubesIsTheCompilers) {
    const gpu::Kernel trace = kernelOf("lightsim/tubes/trace.comp.glsl");
    EXPECT_EQ(test::storageBlockLayout(trace, "VertexBlock").stride, sizeof(bake::TubeVertex));
    const auto presences = test::storageBlockLayout(trace, "ResultBlock");
    EXPECT_EQ(presences.stride, sizeof(bake::TubePresence));
    for (const auto& [name, offset] : test::prefixed("presences[0].", tubePresenceMembers(), 16)) {
        EXPECT_EQ(presences.members.at(name), offset) << name;
    }
    const gpu::Kernel follow(test::sharedContext(), "lightsim/tubes/trace.comp.glsl",
                             {"BANDS 3", "EFFECT_REFRACTION", "EFFECT_REFLECTION", "FOLLOW_REFLECTIONS"});
    const auto reflections = test::storageBlockLayout(follow, "ReflectionBlock");
    EXPECT_EQ(reflections.stride, sizeof(bake::TubeReflections));
    EXPECT_EQ(reflections.members.at("reflections[0].shares[0]"), offsetof(bake::TubeReflections, shares));
    EXPECT_EQ(reflections.members.at("reflections[0].crossings"), offsetof(bake::TubeReflections, crossings));
    const auto settings = test::uniformBlockLayout(trace, "TubeBlock");
    EXPECT_EQ(settings.members, test::prefixed("tube.", tubeSettingsMembers()));
    const gpu::Kernel measure = kernelOf("lightsim/tubes/measure_nodes.comp.glsl");
    const auto nodes = test::storageBlockLayout(measure, "NodeBlock");
    EXPECT_EQ(nodes.stride, sizeof(bake::TubeNode));
    for (const auto& [name, offset] : test::prefixed("nodes[0].", tubeNodeMembers())) {
        EXPECT_EQ(nodes.members.at(name), offset) << name;
    }
    EXPECT_EQ(test::storageBlockLayout(measure, "ResultBlock").members,
              test::prefixed("measures[0].", tubeMeasureMembers()));
    EXPECT_EQ(test::storageBlockLayout(kernelOf("lightsim/tubes/conform.comp.glsl"), "ItemBlock").members,
              test::prefixed("conformities[0].", tubeConformityMembers()));
    const gpu::Kernel gather = kernelOf("lightsim/tubes/deposit_gather.comp.glsl");
    const auto parts = test::storageBlockLayout(gather, "PartBlock");
    EXPECT_EQ(parts.members.at("parts[0]"), sizeof(bake::TubePartsHeader));
}

TEST(BlockLayout, OfThePeakPassIsTheCompilers) {
    const auto pass = test::uniformBlockLayout(kernelOf("lightsim/deposit_peak.comp.glsl"), "PeakPassBlock");
    EXPECT_EQ(pass.members.at("peak.pass"), offsetof(bake::PeakPass, pass));
    EXPECT_EQ(pass.bytes, sizeof(bake::PeakPass));
}

} // namespace
} // namespace eikonal
