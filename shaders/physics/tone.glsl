// From linear scene radiance (Rec.709) to a display. All curves give linear display values from 0 to 1; the sRGB transfer
// function comes last.

// Middle grey goes to display value 0.18. Around it the curve is a sigmoid over stops, as film has it.
const real kMiddleGrey = 0.18;
const real kStopsBelow = 10.0;    // black
const real kStopsAbove = 6.5;     // white
const real kToneContrast = 2.0;   // slope at middle grey: encoded display value per share of the range of stops
const real kTonePower = 1.5;      // sharpness of toe and shoulder
const real kToneGamma = 2.2;      // the sigmoid's values are encoded with it
// Share of the mean that every colour is mixed with before the curve, so that bright saturated light runs to white, and
// the share that is taken out again behind it.
const real kToneInset = 0.14;
const real kToneOutset = 0.10;

// A rise from 0 with a slope that bends to reach `limit` at `span`: y = s x / (1 + ((s span/limit)^p - 1) (x/span)^p)^(1/p).
real boundedRise(real x, real slope, real span, real limit) {
    real excess = pow(slope * span / limit, kTonePower) - 1.0;
    return slope * x / pow(1.0 + excess * pow(x / span, kTonePower), 1.0 / kTonePower);
}

// Linear display value of a linear scene value of one band.
real filmCurve(real value) {
    real range = kStopsBelow + kStopsAbove;
    real pivot = kStopsBelow / range;
    real pivotValue = pow(kMiddleGrey, 1.0 / kToneGamma);
    real stops = log2(max(value, 1.0e-10) / kMiddleGrey);
    real x = clamp(stops / range, -pivot, 1.0 - pivot);
    real rise = x >= 0.0 ? boundedRise(x, kToneContrast, 1.0 - pivot, 1.0 - pivotValue)
                         : -boundedRise(-x, kToneContrast, pivot, pivotValue);
    return pow(clamp(pivotValue + rise, 0.0, 1.0), kToneGamma);
}

real3 mixedWithMean(real3 colour, real share) {
    real mean = (colour.x + colour.y + colour.z) / 3.0;
    return colour + (real3(mean, mean, mean) - colour) * share;
}

// In the manner of AgX: mix towards grey, a sigmoid over stops in each band, and part of the mixing undone.
real3 toneAgx(real3 radiance) {
    real3 mixed = mixedWithMean(radiance, kToneInset);
    real3 curved = real3(filmCurve(mixed.x), filmCurve(mixed.y), filmCurve(mixed.z));
    return mixedWithMean(curved, -kToneOutset / (1.0 - kToneOutset));
}

// Reinhard et al. 2002, in each band.
real3 toneReinhard(real3 radiance) {
    return real3(radiance.x / (1.0 + max(radiance.x, 0.0)), radiance.y / (1.0 + max(radiance.y, 0.0)),
                 radiance.z / (1.0 + max(radiance.z, 0.0)));
}

// IEC 61966-2-1 transfer function of values clamped to 0 to 1.
real srgbEncoded(real value) {
    real v = clamp(value, 0.0, 1.0);
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

real3 srgbEncoded3(real3 value) {
    return real3(srgbEncoded(value.x), srgbEncoded(value.y), srgbEncoded(value.z));
}
