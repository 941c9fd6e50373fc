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

// What the corners of a patch did since their launch; each stands for a quarter of its power. What they still carry inside
// the domain is given up.
void enterPatch(WavefrontPatch wavefront) {
    vec3 rows[LEDGER_ROWS];
    for (int row = 0; row < LEDGER_ROWS; ++row) {
        rows[row] = vec3(0.0);
    }
    for (int i = 0; i < 4; ++i) {
        Particle corner = wavefront.corners[i];
        vec3 left = remainingShare(corner);
        rows[LEDGER_ENTERED] += vec3(corner.enteredShare);
        rows[LEDGER_ABSORBED] += corner.absorbedShare;
        rows[LEDGER_SCATTERED] += corner.scatteredShare;
        rows[LEDGER_REFLECTED] += corner.reflectedShare;
        rows[LEDGER_EXITED] += corner.status == PARTICLE_EXITED ? left : vec3(0.0);
        rows[LEDGER_OPAQUE] += corner.status == PARTICLE_BLOCKED ? left : vec3(0.0);
        rows[LEDGER_CULLED] += corner.status == PARTICLE_INSIDE ? left : vec3(0.0);
    }
    for (int row = 0; row < LEDGER_ROWS; ++row) {
        enterInLedger(row, 0.25 * wavefront.power * rows[row]);
    }
}
