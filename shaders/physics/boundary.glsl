// One Fresnel term per crossing of a smoothed interface (docs/physics.md, section 4).
// A piece of the interface band is followed from the index on one side to the index on the other. It ends where the band
// ends, where grad n turns round (the other wall of something thin), or on the plateau between two steps. A ray that
// leaves on the side it came from was totally reflected, by refraction alone: it loses nothing.
// The interface is taken to be where the profile is steepest, as the mean over the samples of the piece, each weighted by
// |grad n| and by what the index changes there along the ray: a mean over depth, which does not jump when another sample becomes
// the steepest.

struct Crossing {
    real3 normal;       // sum of weight times unit vector along grad n
    real weight;        // sum of the weights
    real along;         // sum of weight times |w| along the interface
    real gradMax;       // largest |grad n| of the piece [1 / scene unit]; 0: not crossing
    real nStart;        // index where the piece began
    real nLast;         // index at the last sample
    real sideAtStart;   // +1: towards the denser side, -1: towards the thinner
};

// |grad n| below this share of the piece's largest is a plateau: an erfc step is flatter than that only beyond 2.8 b,
// where less than 0.3 % of the step is left.
const real kPlateau = 0.02;

Crossing crossingNone(real n) {
    Crossing none;
    none.normal = real3(0.0, 0.0, 0.0);
    none.weight = 0.0;
    none.along = 0.0;
    none.gradMax = 0.0;
    none.nStart = n;
    none.nLast = n;
    none.sideAtStart = 0.0;
    return none;
}

bool crossingEnds(Crossing crossing, bool inBand, real3 gradN) {
    return crossing.gradMax > 0.0 &&
           (!inBand || dot(gradN, crossing.normal) < kPlateau * crossing.gradMax * length(crossing.normal));
}

// Unit, towards the denser side.
real3 crossingNormal(Crossing crossing) {
    return crossing.normal / max(length(crossing.normal), 1.0e-30);
}

// |w| along the interface.
real crossingTangential(Crossing crossing) {
    return crossing.along / max(crossing.weight, 1.0e-30);
}

// Transmittance of the piece that ends with wave vector w at index n.
Polarised crossingTransmittance(Crossing crossing, real3 w, real n) {
    Polarised transmittance;
    transmittance.s = 1.0;
    transmittance.p = 1.0;
    // On a curved interface a ray can also graze the thin side of the band and be bent round it: where it is nearest,
    // |w| lies all along the interface and is more than either index, which no ray that crosses has.
    real tangential = crossingTangential(crossing);
    bool crosses = dot(w, crossing.normal) * crossing.sideAtStart > 0.0 && tangential < min(crossing.nStart, n);
    if (crosses) {
        Polarised reflectance = fresnelReflectance(crossing.nStart, n, tangential);
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
        next.gradMax = magnitude;
    }
    if (inBand && magnitude > 0.0) {
        real3 normal = gradN / magnitude;
        real across = dot(w, normal);
        real weight = magnitude * magnitude * abs(across);
        next.normal += normal * weight;
        next.weight += weight;
        next.along += weight * sqrt(max(dot(w, w) - across * across, 0.0));
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
    real awaySpread;    // solid angle of the directions that each stands for [sr]; 0: it goes no other way
    real onwardSpread;
};

// Wave vector with which the ray of a crossing that ends with wave vector w met the interface, in the plane of both.
real3 crossingIncident(Crossing crossing, real3 w) {
    real3 normal = crossingNormal(crossing);
    real3 along = w - normal * dot(w, normal);
    real tangential = crossingTangential(crossing);
    real normalPart = sqrt(max(crossing.nStart * crossing.nStart - tangential * tangential, 0.0));
    return along * (tangential / max(length(along), 1.0e-30)) + normal * (crossing.sideAtStart * normalPart);
}

// Wave vector of the ray that the interface reflects, for a crossing that ends with wave vector w: the tangential part is
// kept, the normal part is the incident one turned round.
real3 crossingReflected(Crossing crossing, real3 w) {
    real3 incident = crossingIncident(crossing, w);
    real3 normal = crossingNormal(crossing);
    real turned = 2.0 * dot(incident, normal);
    return incident - normal * turned;
}

// The split of a crossing that ends with wave vector w at index n.
BoundarySplit crossingSplit(Crossing crossing, real3 w, real n) {
    BoundarySplit split;
    split.away = crossingReflected(crossing, w);
    split.onward = w;
    split.transmitted = crossingTransmittance(crossing, w, n);
    split.reflected.s = 1.0 - split.transmitted.s;
    split.reflected.p = 1.0 - split.transmitted.p;
    split.awaySpread = 0.0;
    split.onwardSpread = 0.0;
    return split;
}

// The crossing of a ray that an interface has reflected, at a sample in what is left of its band, and that leaves with wave vector
// w: no Fresnel term awaits it. That is noted as an index of 0 on the side that it comes from, where no ray can have been.
Crossing crossingFromMirror(real3 w, real n, real3 gradN) {
    return crossingAfter(crossingNone(0.0), true, w, n, gradN);
}
