#pragma once
// What a value of a scene file is like, beyond its text: for programs that offer it to be changed.

#include <array>
#include <string_view>
#include <vector>

namespace eikonal {

struct ValueForm {
    bool isInteger = false;
    std::vector<std::string_view> choices;  ///< the names that it can be; empty: any
    std::array<double, 2> usual{};          ///< between which it usually is, by factors; equal: anywhere
};

} // namespace eikonal
