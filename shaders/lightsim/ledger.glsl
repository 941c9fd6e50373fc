// The energy ledger: where the launched power went, by band (docs/physics.md, section 3).
#include "lightsim/fixed_point.glsl"
#include "lightsim/share.glsl"

layout(std430, binding = BAKE_LEDGER_BINDING) buffer LedgerBlock {
    uvec2 ledger[LEDGER_ROWS * 3];
};

void enterInLedger(int row, vec3 power) {
    for (int band = 0; band < 3; ++band) {
        if (power[band] != 0.0) {
            ADD_FIXED(ledger, row * 3 + band, largeFixedPoint(power[band] * settings.ledgerScale))
        }
    }
}

struct EnergyRows {
    vec3 share[LEDGER_ROWS];  // of the power launched along a ray
};

// What a ray did since its launch. What it still carries inside the domain is given up.
EnergyRows rowsOf(Particle ray) {
    vec3 left = remainingShare(ray);
    EnergyRows rows;
    rows.share[LEDGER_ENTERED] = vec3(ray.enteredShare);
    rows.share[LEDGER_ABSORBED] = ray.absorbedShare;
    rows.share[LEDGER_SCATTERED] = ray.scatteredShare;
    rows.share[LEDGER_REFLECTED] = ray.reflectedShare;
    rows.share[LEDGER_EXITED] = ray.status == PARTICLE_EXITED ? left : vec3(0.0);
    rows.share[LEDGER_OPAQUE] = ray.status == PARTICLE_BLOCKED ? left : vec3(0.0);
    rows.share[LEDGER_CULLED] = ray.status == PARTICLE_INSIDE ? left : vec3(0.0);
    rows.share[LEDGER_TINTED] = ray.tintedShare;
    rows.share[LEDGER_FOLLOWED] = vec3(0.0);
#ifdef FOLLOW_REFLECTIONS
    if (ray.enteredShare == 0.0) {  // it began at a mirror, with all that it did
        for (int row = LEDGER_ABSORBED; row < LEDGER_FOLLOWED; ++row) {
            rows.share[LEDGER_FOLLOWED] += rows.share[row];
        }
    }
#endif
    return rows;
}

// Each corner of a patch stands for a quarter of its power.
void enterPatch(WavefrontPatch wavefront) {
    for (int i = 0; i < 4; ++i) {
        EnergyRows rows = rowsOf(wavefront.corners[i]);
        for (int row = 0; row < LEDGER_ROWS; ++row) {
            enterInLedger(row, 0.25 * wavefront.power * rows.share[row]);
        }
    }
}
