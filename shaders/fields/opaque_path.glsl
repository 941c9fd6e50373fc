// Where a path of two straight pieces meets opaque matter: where its depth crosses one half.

const float kSolid = 0.5;
const int kBisections = 12;

bool isSolid(vec3 x) {
    return sampleOpaque(x).a >= kSolid;
}

// A point of the path, share 0 its start, 1/2 its middle, 1 its end.
vec3 pointOfPath(vec3 start, vec3 middle, vec3 end, float share) {
    return share < 0.5 ? mix(start, middle, 2.0 * share) : mix(middle, end, 2.0 * share - 1.0);
}

// The share of the path at which matter is met, from one at which it is solid.
float shareOfHit(vec3 start, vec3 middle, vec3 end, float solidShare) {
    float free = 0.0;
    float solid = solidShare;
    for (int i = 0; i < kBisections && solidShare > 0.0; ++i) {
        float between = 0.5 * (free + solid);
        if (isSolid(pointOfPath(start, middle, end, between))) {
            solid = between;
        } else {
            free = between;
        }
    }
    return solid;
}
