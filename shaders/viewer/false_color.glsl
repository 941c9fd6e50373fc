// Values as colours. Turbo, A. Mikhailov, "Turbo, An Improved Rainbow Colormap for Visualization" (2019), as a polynomial of
// the fifth degree.

vec3 turbo(float value) {
    float x = clamp(value, 0.0, 1.0);
    vec4 low = vec4(1.0, x, x * x, x * x * x);
    vec2 high = vec2(low.z, low.w) * low.z;
    return clamp(vec3(dot(low, vec4(0.13572138, 4.61539260, -42.66032258, 132.13108234)) +
                          dot(high, vec2(-152.94239396, 59.28637943)),
                      dot(low, vec4(0.09140261, 2.19418839, 4.84296658, -14.18503333)) +
                          dot(high, vec2(4.27729857, 2.82956604)),
                      dot(low, vec4(0.10667330, 12.64194608, -60.58204836, 110.36276771)) +
                          dot(high, vec2(-89.90310912, 27.34824973))),
                 0.0, 1.0);
}
