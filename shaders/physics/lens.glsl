// A thin lens: rays through all places of its opening meet where the one through its middle meets the plane in focus.

struct LensRay {
    real3 origin;
    real3 direction;  // unit
};

// Place in the unit disc of two numbers from 0 to 1; equal areas get equal shares.
real2 discPlace(real2 u) {
    real radius = sqrt(u.x);
    real angle = 6.283185307179586 * u.y;
    return real2(radius * cos(angle), radius * sin(angle));
}

// middle: of the lens; through: direction of the ray there, 1 long along the view; focus: distance of the plane in focus
// along the view; offset: from the middle, across the view.
LensRay thinLensRay(real3 middle, real3 through, real focus, real3 offset) {
    LensRay ray;
    ray.origin = middle + offset;
    ray.direction = normalize(through * focus - offset);
    return ray;
}
