// Writing tables for others. Reading CONTACT's text is in contact_text_reader.cpp.
#include "contactd/ic_exchange.hpp"

#include <cstdio>
#include <cstring>

#include "contact_text.hpp"
#include "sha256.hpp"

namespace contactd {
namespace {

template <class... Values>
void append(std::string& text, const char* format, Values... values) {
    char line[128];
    text.append(line, static_cast<std::size_t>(std::snprintf(line, sizeof line, format, values...)));
}

constexpr double characters_per_row = 247;  // an integer, ten numbers and the end of the line

}  // namespace

double combined_modulus(const MaterialPair& bodies) {
    if (bodies.upper.G == bodies.lower.G) return bodies.upper.G;  // to the last bit
    return 2 / (1 / bodies.upper.G + 1 / bodies.lower.G);
}

double contact_text_size(int nx, int ny) {
    return (2.0 * ny - 1) * (nx + 2) * characters_per_row;
}

std::string to_contact_text(const GivenIcs& ics, double G) {
    const IcTable& table = ics.table;
    std::string text;
    text.reserve(static_cast<std::size_t>(contact_text_size(table.nx, table.ny)));
    append(text, "%d %d\n%d %d\n%d %d\n", 1, 1, 0, contact_text::order_zxy, 1, 0);
    append(text, "%d %d %.17g %.17g\n", table.nx, table.ny, ics.dx, ics.dy);
    for (int l = 1 - table.ny; l < table.ny; ++l) {
        append(text, "%% %s%d%s%.9g; sums over both bodies, %s%.17g\n", contact_text::offset_mark, l,
               contact_text::y_mark, l * ics.dy, contact_text::modulus_mark, G);
        text += "%  ix                       x";
        for (const auto& [i, j] : contact_text::columns)
            append(text, "%22s%c%c", "C", name_of(i).front(), name_of(j).front());
        text += '\n';
        for (int k = 0; k < table.nx; ++k) {
            append(text, "%5d %23.16e", k, k * ics.dx);
            for (const auto& [i, j] : contact_text::columns) append(text, " %23.16e", G * table.at(i, j, k, l));
            text += '\n';
        }
    }
    return text;
}

std::string ic_key(const GivenIcs& ics) {
    const std::vector<double>& values = ics.table.values;
    std::vector<unsigned char> bytes((values.size() + 2) * sizeof(double));
    const double sizes[2]{ics.dx, ics.dy};
    std::memcpy(bytes.data(), sizes, sizeof sizes);
    std::memcpy(bytes.data() + sizeof sizes, values.data(), values.size() * sizeof(double));
    const std::string extent = std::to_string(ics.table.nx) + "x" + std::to_string(ics.table.ny);
    bytes.insert(bytes.end(), extent.begin(), extent.end());
    return sha256_hex(bytes);
}

}  // namespace contactd
