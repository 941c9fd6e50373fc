// One Fresnel term per crossing of a smoothed interface (docs/physics.md, section 4).
// A piece of the interface band is followed from the index on one side to the index on the other. It ends where the band
// ends, where grad n turns round (the other wall of something thin), or on the plateau between two steps. A ray that
// leaves on the side it came from was totally reflected, by refraction alone: it loses nothing.

struct Crossing {
    real3 normal;       // unit, along grad n where |grad n| was largest
    real gradMax;       // largest |grad n| of the piece [1 / scene unit]; 0: not crossing
    real nStart;        // index where the piece began
    real nLast;         // index at the last sample
    real wTangential;   // |w| along the interface where |grad n| was largest
    real sideAtStart;   // +1: towards the denser side, -1: towards the thinner
};

// |grad n| below this share of the piece's largest is a plateau: an erfc step is flatter than that only beyond 2.8 b,
// where less than 0.3 % of the step is left.
const real kPlateau = 0.02;

Crossing crossingNone(real n) {
    Crossing none;
    none.normal = real3(0.0, 0.0, 0.0);
    none.gradMax = 0.0;
    none.nStart = n;
    none.nLast = n;
    none.wTangential = 0.0;
    none.sideAtStart = 0.0;
    return none;
}

bool crossingEnds(Crossing crossing, bool inBand, real3 gradN) {
    return crossing.gradMax > 0.0 &&
           (!inBand || dot(gradN, crossing.normal) < kPlateau * crossing.gradMax);
}

// Transmittance of the piece that ends with wave vector w at index n.
Polarised crossingTransmittance(Crossing crossing, real3 w, real n) {
    Polarised transmittance;
    transmittance.s = 1.0;
    transmittance.p = 1.0;
    // On a curved interface a ray can also graze the thin side of the band and be bent round it: where it is nearest,
    // |w| lies all along the interface and is more than either index, which no ray that crosses has.
    bool crosses = dot(w, crossing.normal) * crossing.sideAtStart > 0.0 &&
                   crossing.wTangential < min(crossing.nStart, n);
    if (crosses) {
        Polarised reflectance = fresnelReflectance(crossing.nStart, n, crossing.wTangential);
        transmittance.s = 1.0 - reflectance.s;
        transmittance.p = 1.0 - reflectance.p;
    }
    return transmittance;
}

// The crossing after a sample (w, n, grad n), which is inside the band or not.
Crossing crossingAfter(Crossing crossing, bool inBand, real3 w, real n, real3 gradN) {
    Crossing next = crossing;
    real magnitude = length(gradN);
    if (crossingEnds(crossing, inBand, gradN)) {
        next = crossingNone(crossing.nLast);
    }
    if (inBand && magnitude > next.gradMax) {
        if (next.gradMax == 0.0) {
            next.nStart = next.nLast;
        }
        // By the index where it is steepest: where the band begins differences of n are rounding, and point anywhere.
        next.sideAtStart = n >= next.nStart ? 1.0 : -1.0;
        next.normal = gradN / magnitude;
        next.gradMax = magnitude;
        real along = dot(w, next.normal);
        next.wTangential = sqrt(max(dot(w, w) - along * along, 0.0));
    }
    next.nLast = n;
    return next;
}

// Index on the far side of the piece that ends at a sample of index n: beyond the band the sample's own, else the last.
real crossingEndIndex(Crossing crossing, bool inBand, real n) {
    return inBand ? crossing.nLast : n;
}

// What becomes of light at an interface: where it goes, as wave vectors, and the shares of its radiance.
struct BoundarySplit {
    real3 away;    // of the reflected ray
    real3 onward;  // of the ray that goes on
    Polarised reflected;
    Polarised transmitted;
};

// Wave vector with which the ray of a crossing that ends with wave vector w met the interface: the tangential part is kept.
real3 crossingIncident(Crossing crossing, real3 w) {
    real3 tangential = w - crossing.normal * dot(w, crossing.normal);
    real normalPart =
        sqrt(max(crossing.nStart * crossing.nStart - crossing.wTangential * crossing.wTangential, 0.0));
    return tangential + crossing.normal * (crossing.sideAtStart * normalPart);
}

// Wave vector of the ray that the interface reflects, for a crossing that ends with wave vector w: the tangential part is
// kept, the normal part is the incident one turned round.
real3 crossingReflected(Crossing crossing, real3 w) {
    real3 incident = crossingIncident(crossing, w);
    real turned = 2.0 * dot(incident, crossing.normal);
    return incident - crossing.normal * turned;
}

// The split of a crossing that ends with wave vector w at index n.
BoundarySplit crossingSplit(Crossing crossing, real3 w, real n) {
    BoundarySplit split;
    split.away = crossingReflected(crossing, w);
    split.onward = w;
    split.transmitted = crossingTransmittance(crossing, w, n);
    split.reflected.s = 1.0 - split.transmitted.s;
    split.reflected.p = 1.0 - split.transmitted.p;
    return split;
}

// More than any index.
const real kBeyondIndices = 1.0e3;

// The crossing of a ray that stands on the mirror in the middle of an interface and leaves with wave vector w: half done, from the
// side that it goes back to. Of the index there only the side matters, and |w| along the interface is what no ray that crosses
// has: no Fresnel term awaits it.
Crossing crossingFromMirror(real3 w, real n, real3 gradN) {
    real nStart = 0.0;
    if (dot(w, gradN) > 0.0) {
        nStart = kBeyondIndices;
    }
    Crossing crossing = crossingAfter(crossingNone(nStart), true, w, n, gradN);
    crossing.wTangential = kBeyondIndices;
    return crossing;
}
