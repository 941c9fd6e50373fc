#include "tests/stability/random_scene.h"

#include <array>
#include <cmath>
#include <random>

#include <fmt/format.h>

namespace eikonal::test {

namespace {

/// Numbers that are the same on every platform, which the distributions of the standard library are not.
class Chance {
public:
    explicit Chance(std::uint64_t seed) : random_(seed) {}

    double from(double low, double high) { return low + (high - low) * double(random_() >> 11) * 0x1p-53; }
    int below(int count) { return int(from(0.0, count)); }
    bool once(int in) { return below(in) == 0; }
    /// Over orders of magnitude.
    double around(double low, double high) { return low * std::pow(high / low, from(0.0, 1.0)); }
    std::string vector(double low, double high) {
        return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", from(low, high), from(low, high), from(low, high));
    }
    template <std::size_t kCount>
    const char* of(const std::array<const char*, kCount>& names) {
        return names[std::size_t(below(int(kCount)))];
    }

private:
    std::mt19937_64 random_;
};

std::string bumps(Chance& chance) {
    std::string sum = "1";
    const int count = 1 + chance.below(3);
    for (int i = 0; i < count; ++i) {
        const double width = chance.from(0.2, 0.6);
        sum += fmt::format(" + {:.4f}*exp(-((x - {:.4f})^2 + (y - {:.4f})^2 + (z - {:.4f})^2)/{:.4f})", chance.from(0.05, 0.5),
                           chance.from(-0.5, 0.5), chance.from(-0.5, 0.5), chance.from(-0.5, 0.5), 2.0 * width * width);
    }
    return sum;
}

std::string object(Chance& chance) {
    constexpr std::array kShapes{"sphere", "box", "rounded_box", "cylinder", "torus", "prism", "wine_glass"};
    std::string text = fmt::format("[[object]]\nshape = '{}'\nior = {:.4f}\nscale = {:.4f}\ntranslate = {}\nrotate = {}\n",
                                   chance.of(kShapes), chance.from(0.7, 2.4), chance.from(0.3, 1.2),
                                   chance.vector(-0.4, 0.4), chance.vector(-180.0, 180.0));
    text += fmt::format("scattering = {:.4f}\nabsorption = {}\n", chance.from(0.0, 0.5), chance.vector(0.0, 1.0));
    if (chance.once(4)) text += "opaque = true\n";
    if (chance.once(4)) text += fmt::format("emission = {:.4f}\n", chance.from(0.0, 1.0));
    if (chance.once(3)) text += fmt::format("smooth = {:.4f}\n", chance.from(0.0, 3.0));
    return text;
}

std::string light(Chance& chance) {
    const std::string power = fmt::format("[{0:.4e}, {0:.4e}, {0:.4e}]", chance.around(1e-3, 1e3));
    switch (chance.below(4)) {
        case 0: return fmt::format("[[light]]\ndirection = {}\nirradiance = {}\n", chance.vector(-1.0, 1.0), power);
        case 1: return fmt::format("[[light]]\ntype = 'point'\nposition = {}\npower = {}\n", chance.vector(-2.0, 2.0), power);
        case 2:
            return fmt::format("[[light]]\ntype = 'spot'\nposition = {}\ndirection = {}\npower = {}\nangle = {:.3f}\n",
                               chance.vector(-2.0, 2.0), chance.vector(-1.0, 1.0), power, chance.around(1.0, 300.0));
        default: break;
    }
    return fmt::format("[[light]]\ntype = 'rectangle'\nposition = {}\ndirection = {}\npower = {}\nsamples = 2\n",
                       chance.vector(-2.0, 2.0), chance.vector(-1.0, 1.0), power);
}

} // namespace

std::string randomIndex(std::uint64_t seed) {
    Chance chance(seed);
    return bumps(chance);
}

std::string randomScene(std::uint64_t seed) {
    Chance chance(seed);
    std::string text = fmt::format("[domain]\nresolution = {}\nmax = {}\n[medium]\nscattering = {:.4f}\nanisotropy = {:.4f}\n",
                                   8 + chance.below(7), chance.vector(0.4, 1.2), chance.from(0.01, 1.0),
                                   chance.from(-0.95, 0.95));
    text += fmt::format("[camera]\nposition = {}\nfov = {:.3f}\n", chance.vector(-3.0, 3.0), chance.around(1.0, 170.0));
    text += "[render]\nsize = [12, 8]\ntone_map = 'none'\n";
    if (chance.once(3)) {
        text += "[[object]]\nshape = 'field'\nsize = [4, 4, 4]\nior = \"" + bumps(chance) + "\"\nscattering = 0.2\n";
    }
    for (int i = chance.below(3); i >= 0; --i) text += object(chance);
    for (int i = chance.below(2); i >= 0; --i) text += light(chance);
    return text;
}

} // namespace eikonal::test
