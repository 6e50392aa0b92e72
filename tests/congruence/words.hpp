// Words of the cases that the driver in C++ makes bodies and tables of.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "contactd/contact.hpp"

namespace contactd {

using Words = std::vector<std::string>;

inline double number(const std::string& word) {
    return std::stod(word);
}

/// xx, yy and zz that fall by four with each offset, and nothing else.
inline GivenIcs table(const Words& words) {
    const int nx = std::stoi(words[2]), ny = std::stoi(words[3]);
    GivenIcs given{IcTable(nx, ny), number(words[4]), number(words[5])};
    for (int axis = 0; axis < 3; ++axis)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x)
                given.table(static_cast<Axis>(axis), static_cast<Axis>(axis), x, y) =
                    std::ldexp(number(words[6]), -2 * (x + y));
    return given;
}

/// "body shape base_G base_nu", and "thickness G nu" of each layer.
inline Body layered(const Words& words) {
    Layers layers{{}, number(words[3]) == 0 ? Material::rigid() : Material{number(words[3]), number(words[4])}};
    for (std::size_t at = 5; at < words.size(); at += 3)
        layers.layers.push_back({number(words[at]), number(words[at + 1]), number(words[at + 2])});
    return Body::of(layers, words[2] == "bilinear" ? LoadShape::bilinear : LoadShape::constant);
}

}  // namespace contactd
