// Writes tables for other programs.
#include "contactd/ic_exchange.hpp"
#include "contactd/fields/axis.hpp"

#include <array>
#include <cstdio>
#include <cstring>

#include "sha256.hpp"

namespace contactd {
namespace {

/// CONTACT's text encodes the order of the coordinate directions as 3, 1, 2 for z (normal), x, y.
constexpr int order_zxy = 312;

struct Column {
    Axis displacement;
    Axis load;
};
constexpr std::array<Column, 9> columns{{{Axis::z, Axis::z},
                                         {Axis::z, Axis::x},
                                         {Axis::z, Axis::y},
                                         {Axis::x, Axis::z},
                                         {Axis::x, Axis::x},
                                         {Axis::x, Axis::y},
                                         {Axis::y, Axis::z},
                                         {Axis::y, Axis::x},
                                         {Axis::y, Axis::y}}};

template <class... Values>
void append(std::string& text, const char* format, Values... values) {
    char line[128];
    text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, values...)));
}

constexpr double characters_per_row = 247;  // an integer, ten numbers and the line end

}  // namespace

double combined_modulus(const MaterialPair& bodies) {
    if (bodies.upper.G == bodies.lower.G) return bodies.upper.G;  // This is exact to the last bit.
    return 2 / (1 / bodies.upper.G + 1 / bodies.lower.G);
}

double contact_text_size(int nx, int ny) {
    return (2.0 * ny - 1) * (nx + 2) * characters_per_row;
}

std::string to_contact_text(const GivenIcs& ics, double G) {
    const IcTable& table = ics.table;
    std::string text;
    text.reserve(static_cast<std::size_t>(contact_text_size(table.nx, table.ny)));
    append(text, "%d %d\n%d %d\n%d %d\n", 1, 1, 0, order_zxy, 1, 0);
    append(text, "%d %d %.17g %.17g\n", table.nx, table.ny, ics.dx, ics.dy);
    for (int l = 1 - table.ny; l < table.ny; ++l) {
        append(text, "%% offset iy = %d, y = %.9g; sums over both bodies, times G = %.17g\n", l, l * ics.dy, G);
        text += "%  ix                       x";
        for (const auto& [i, j] : columns) append(text, "%22s%c%c", "C", name_of(i).front(), name_of(j).front());
        text += '\n';
        for (int k = 0; k < table.nx; ++k) {
            append(text, "%5d %23.16e", k, k * ics.dx);
            for (const auto& [i, j] : columns) append(text, " %23.16e", G * table.at(i, j, k, l));
            text += '\n';
        }
    }
    return text;
}

std::string ic_key(const GivenIcs& ics) {
    const UnsetArray& values = ics.table.values;
    std::vector<unsigned char> bytes((values.size() + 2) * sizeof(double));
    const double sizes[2]{ics.dx, ics.dy};
    std::memcpy(bytes.data(), sizes, sizeof sizes);
    std::memcpy(bytes.data() + sizeof sizes, values.data(), values.size() * sizeof(double));
    const std::string extent = std::to_string(ics.table.nx) + "x" + std::to_string(ics.table.ny);
    bytes.insert(bytes.end(), extent.begin(), extent.end());
    return sha256_hex(bytes);
}

}  // namespace contactd
