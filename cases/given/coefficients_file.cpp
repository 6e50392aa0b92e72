#include "coefficients_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "given/not_covered.hpp"
#include "read/input_lines.hpp"
#include "types/number_text.hpp"

namespace contactd::cases {
namespace {

constexpr std::size_t columns = 9;             ///< Czz Czx Czy Cxz Cxx Cxy Cyz Cyx Cyy
constexpr double largest_offsets = 4'000'000;  ///< largest number of offsets in a file
constexpr double rounding = 1e-6;              ///< tolerance of symmetries, relative to the largest coefficient

/// Returns the axes of the displacement and the load of a column.
std::pair<Axis, Axis> axes_of(std::size_t column) {
    constexpr std::array order{Axis::z, Axis::x, Axis::y};
    return {order[column / 3], order[column % 3]};
}

/// Returns -1 if a coefficient changes its sign with that of the offset along an axis, otherwise 1.
double parity(std::size_t column, Axis along) {
    const auto [of, by] = axes_of(column);
    return (of == along) != (by == along) ? -1 : 1;
}

class CoefficientLines {
   public:
    CoefficientLines(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

    [[noreturn]] void fail(const std::string& problem) const {
        throw NotCovered(Subject::coefficients,
                         "In the file \"" + name_ + "\", line " + std::to_string(number_) + " " + problem + ".");
    }
    /// Returns the words of the next line, without its comment.
    const std::vector<std::string>& next() {
        if (rest_.empty()) fail("is the last one, but more lines must follow");
        ++number_;
        const std::size_t end = rest_.find('\n');
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end == rest_.npos ? rest_.size() : end + 1);
        line = line.substr(0, line.find('%'));
        words_.clear();
        for (std::size_t at = 0; (at = line.find_first_not_of(" ,\t\r", at)) != line.npos;) {
            const std::size_t stop = std::min(line.find_first_of(" ,\t\r", at), line.size());
            words_.emplace_back(line.substr(at, stop - at));
            at = stop;
        }
        return words_;
    }
    /// Returns the words of the next line that is not empty.
    const std::vector<std::string>& header() {
        while (next().empty()) {
        }
        return words_;
    }
    double number(std::size_t word) const {
        const auto value = word < words_.size() ? contact_files::real_in(words_[word]) : std::nullopt;
        if (!value) fail("has too few numbers, or a word that is not a number");
        return *value;
    }
    bool has_numbers() const {
        return std::ranges::any_of(words_,
                                   [](const std::string& word) { return contact_files::real_in(word).has_value(); });
    }
    std::size_t words() const { return words_.size(); }

   private:
    std::string_view rest_;
    const std::string& name_;
    std::size_t number_ = 0;
    std::vector<std::string> words_;
};

/// Reads the first lines. They must describe one table for all rows, and for the supported columns and symmetries.
void read_kind(CoefficientLines& lines) {
    lines.header();
    if (lines.has_numbers() && lines.number(0) != 1)
        lines.fail("begins a file with a table for each row of elements; only one table for all rows is supported");
    for (const auto& [first, second, name] : {std::tuple(0, 312, "columns"), std::tuple(1, 0, "symmetries")}) {
        lines.header();
        if (lines.number(0) != first || lines.number(1) != second)
            lines.fail("must contain " + std::to_string(first) + " " + std::to_string(second) +
                       ", the only supported " + name);
    }
}

using Rows = std::vector<std::array<double, columns>>;

/// Reads a block of offsets along x.
Rows read_block(CoefficientLines& lines, int nx, double dx) {
    Rows rows(static_cast<std::size_t>(nx));
    for (int ix = 0; ix < nx; ++ix) {
        lines.next();
        if (lines.words() != columns + 2) lines.fail("must contain eleven numbers: ix, x and nine coefficients");
        constexpr double digits = 1e-3;  // tolerance of a printed x, relative to dx
        if (lines.number(0) != ix || std::abs(lines.number(1) - ix * dx) > digits * dx)
            lines.fail("must contain the offset ix = " + std::to_string(ix) + " and x = ix dx");
        for (std::size_t i = 0; i < columns; ++i) rows[static_cast<std::size_t>(ix)][i] = lines.number(i + 2);
    }
    return rows;
}

}  // namespace

GivenIcs read_coefficients(std::string_view text, const std::string& name, double G) {
    CoefficientLines lines(text, name);
    read_kind(lines);
    lines.header();
    const double columns_along = lines.number(0), rows_across = lines.number(1);
    if (!(columns_along >= 1 && rows_across >= 1 && columns_along * rows_across <= largest_offsets) ||
        columns_along != std::round(columns_along) || rows_across != std::round(rows_across))
        lines.fail("must begin with the numbers of offsets along x and y");
    const int nx = static_cast<int>(columns_along), ny = static_cast<int>(rows_across);
    GivenIcs found{IcTable(nx, ny), lines.number(2), lines.number(3)};
    if (!(found.dx > 0 && found.dy > 0))
        lines.fail("must contain positive element sizes dx and dy after the numbers of offsets");
    std::vector<Rows> blocks;
    for (int iy = 1 - ny; iy < ny; ++iy) {
        lines.next();
        lines.next();
        blocks.push_back(read_block(lines, nx, found.dx));
    }
    const auto& origin = blocks[static_cast<std::size_t>(ny) - 1].front();
    const double allowed = rounding * std::max({std::abs(origin[0]), std::abs(origin[4]), std::abs(origin[8])});
    for (int iy = 0; iy < ny; ++iy)
        for (int ix = 0; ix < nx; ++ix)
            for (std::size_t i = 0; i < columns; ++i) {
                const auto at = [&](int y) {
                    return blocks[static_cast<std::size_t>(ny - 1 + y)][static_cast<std::size_t>(ix)][i];
                };
                double part = 0.5 * (at(iy) + parity(i, Axis::y) * at(-iy));
                if (ix == 0 && parity(i, Axis::x) < 0) part = 0;
                if (!(std::abs(at(iy) - part) <= allowed))
                    throw NotCovered(Subject::coefficients,
                                     "The file \"" + name + "\" has the coefficient " + number_text(at(iy)) +
                                         " at the offset " + std::to_string(ix) + ", " + std::to_string(iy) +
                                         ". Only bodies that are symmetric in x and y are supported.");
                const auto [of, by] = axes_of(i);
                found.table(of, by, ix, iy) = part / G;
            }
    return found;
}

GivenIcs with_offsets(GivenIcs coefficients, const Grid& grid) {
    const IcTable& table = coefficients.table;
    const int nx = std::max(table.nx, grid.nx), ny = std::max(table.ny, grid.ny);
    if (nx == table.nx && ny == table.ny) return coefficients;
    IcTable padded(nx, ny);
    for (const Axis i : {Axis::x, Axis::y, Axis::z})
        for (const Axis j : {Axis::x, Axis::y, Axis::z})
            for (int l = 0; l < table.ny; ++l)
                for (int k = 0; k < table.nx; ++k) padded(i, j, k, l) = table(i, j, k, l);
    coefficients.table = std::move(padded);
    return coefficients;
}

}  // namespace contactd::cases
