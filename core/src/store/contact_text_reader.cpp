#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <vector>

#include "../../types/number_text.hpp"
#include "contact_text.hpp"
#include "contactd/error.hpp"
#include "contactd/ic_exchange.hpp"

namespace contactd {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::size_t numbers_per_row = 2 + contact_text::columns.size();

[[noreturn]] void fail(std::size_t line, const std::string& problem) {
    throw InvalidArgument("line " + std::to_string(line), problem);
}

std::vector<std::string_view> lines_of(std::string_view text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view line = text.substr(0, end);
        if (line.ends_with('\r')) line.remove_suffix(1);
        lines.push_back(line);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return lines;
}

/// What stands between blanks and commas, before the comment.
Words words_of(std::string_view line) {
    line = line.substr(0, line.find('%'));
    Words words;
    constexpr std::string_view blanks = " \t,";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        words.push_back(line.substr(at, end - at));
        at = line.find_first_not_of(blanks, end);
    }
    return words;
}

std::string quoted(std::string_view word) {
    constexpr std::size_t most = 30;
    return '"' + std::string(word.substr(0, most)) + (word.size() > most ? "...\"" : "\"");
}

/// The finite number that `word` is, as C++ or Fortran writes it.
std::optional<double> number_in(std::string_view word) {
    std::string text(word);
    if (text.starts_with('+')) text.erase(0, 1);
    std::replace_if(text.begin(), text.end(), [](char c) { return c == 'D' || c == 'd'; }, 'e');
    // Fortran leaves out the letter before an exponent of three digits.
    if (const std::size_t sign = text.find_last_of("+-");
        sign != std::string::npos && sign > 0 && text.find('e') == std::string::npos)
        text.insert(sign, 1, 'e');
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // Too small for a double is zero enough.
    if (error == std::errc::result_out_of_range && end == text.data() + text.size() &&
        text.find("e-") != std::string::npos)
        return 0.0;
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

/// What rounding may leave between `word` and `exact`: half its last digit, and the digits of the element size.
double off_by(std::string_view word, double exact) {
    const double relative = element_size_tolerance * std::abs(exact);
    if (std::abs(number_in(word).value_or(0) - exact) <= relative) return relative;
    const std::size_t end = std::min(word.find_first_of("eEdD"), word.size());
    const std::size_t point = std::min(word.find('.'), end);
    const double decimals = point < end ? static_cast<double>(end - point - 1) : 0;
    const double exponent = end < word.size() ? number_in(word.substr(end + 1)).value_or(0) : 0;
    return 0.5000001 * std::pow(10, exponent - decimals) + relative;
}

class Reader {
   public:
    Reader(std::string_view text, std::optional<double> G, double tolerance)
        : lines_(lines_of(text)), modulus_(G), tolerance_(tolerance) {
        if (G && !(std::isfinite(*G) && *G > 0))
            throw InvalidArgument("G", "is " + number_text(*G) + "; it must be positive");
    }

    GivenIcs read() {
        read_kind();
        read_header("column definition (0 312)", {0, contact_text::order_zxy});
        read_header("symmetry (1 0)", {1, 0});
        GivenIcs ics = read_extent();
        rows_.resize(numbers_of(ics.table));
        for (int l = 1 - ics.table.ny; l < ics.table.ny; ++l) read_block(ics, l);
        expect_end();
        if (!modulus_)
            throw InvalidArgument("G", "is missing; the text does not tell by which modulus its values are multiplied");
        keep_symmetric_part(ics.table);
        for (double& value : ics.table.values) value /= *modulus_;
        return ics;
    }

   private:
    std::size_t line_number() const { return at_; }  ///< of the line read last, counting from 1

    std::string_view next(const std::string& wanted) {
        if (at_ == lines_.size()) fail(at_ + 1, "is missing; it must hold " + wanted);
        return lines_[at_++];
    }

    /// The words of the next line that is not empty and no comment.
    Words header(const std::string& wanted) {
        Words words;
        while (words.empty()) words = words_of(next(wanted));
        return words;
    }

    int whole(const Words& words, std::size_t n, const std::string& wanted) const {
        const std::optional<double> value = n < words.size() ? number_in(words[n]) : std::nullopt;
        if (!value || *value != std::floor(*value) || std::abs(*value) > std::numeric_limits<int>::max())
            fail(line_number(),
                 "holds " + (n < words.size() ? quoted(words[n]) : "too few numbers") + "; it must hold the " + wanted);
        return static_cast<int>(*value);
    }

    void read_kind() {
        const std::string wanted = "number of tables, 1, and that of the convex body, 1 or 2";
        const Words words = header("the " + wanted);
        if (std::none_of(words.begin(), words.end(), [](std::string_view word) { return number_in(word); })) return;
        const int tables = whole(words, 0, wanted), convex = whole(words, 1, wanted);
        if (tables != 1)
            fail(line_number(), "announces " + std::to_string(tables) +
                                    " tables, one for each row of elements; only one that serves every row can be "
                                    "read");
        if (convex < 0 || convex > 2)
            fail(line_number(), "names the convex body " + std::to_string(convex) + "; it must be 1 or 2");
    }

    void read_header(const std::string& name, const std::array<int, 2>& expected) {
        const Words words = header("the " + name);
        for (std::size_t n = 0; n < expected.size(); ++n)
            if (const int value = whole(words, n, name); value != expected[n])
                fail(line_number(), "holds " + std::to_string(value) + " where the " + name + " must have " +
                                        std::to_string(expected[n]) + "; no other kind of file can be read");
    }

    GivenIcs read_extent() {
        const std::string wanted = "extent and element sizes, mx my dx dy";
        const Words words = header("the " + wanted);
        const int nx = whole(words, 0, wanted), ny = whole(words, 1, wanted);
        if (nx < 1 || ny < 1 || static_cast<std::size_t>(nx) > max_grid_elements / static_cast<std::size_t>(ny))
            fail(line_number(), "announces " + std::to_string(nx) + " x " + std::to_string(ny) +
                                    " offsets; there must be at least one and at most " +
                                    std::to_string(max_grid_elements));
        GivenIcs ics;
        for (const auto& [n, size] : {std::pair{2u, &ics.dx}, {3u, &ics.dy}}) {
            const std::optional<double> value = n < words.size() ? number_in(words[n]) : std::nullopt;
            if (!value || *value <= 0)
                fail(line_number(), "holds " + (n < words.size() ? quoted(words[n]) : "too few numbers") +
                                        "; it must hold the " + wanted + ", the sizes positive");
            *size = *value;
        }
        // Before anything of that size is allocated.
        const std::size_t needed = (2 * static_cast<std::size_t>(ny) - 1) * (static_cast<std::size_t>(nx) + 2);
        if (lines_.size() - at_ < needed)
            fail(line_number(), "announces " + std::to_string(nx) + " x " + std::to_string(ny) +
                                    " offsets, for which " + std::to_string(needed) + " lines must follow; there are " +
                                    std::to_string(lines_.size() - at_));
        ics.table = IcTable(nx, ny);
        return ics;
    }

    static std::size_t numbers_of(const IcTable& table) {
        return (2 * static_cast<std::size_t>(table.ny) - 1) * static_cast<std::size_t>(table.nx);
    }

    void skip_comment(int l, double dy) {
        const std::string_view line = next("a comment");
        if (words_of(line).size() >= numbers_per_row)
            fail(line_number(), "holds numbers; it must be one of the two comment lines before each y offset");
        if (const auto modulus = number_behind(line, contact_text::modulus_mark)) take_modulus(*modulus);
        const auto offset = number_behind(line, contact_text::offset_mark),
                   y = number_behind(line, contact_text::y_mark);
        if (offset && y) check_offset(*offset, *y, l, dy);
    }

    static constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

    /// In one of our own comments: nothing where `mark` does not stand, not a number where no number follows it.
    static std::optional<double> number_behind(std::string_view line, std::string_view mark) {
        const std::size_t found = line.find(mark);
        if (found == std::string_view::npos) return std::nullopt;
        line.remove_prefix(found + mark.size());
        const Words words = words_of(line.substr(0, line.find(';')));
        return words.empty() ? no_number : number_in(words[0]).value_or(no_number);
    }

    /// The same in every comment; that of the caller wins over it.
    void take_modulus(double told) {
        if (!(told > 0)) fail(line_number(), "does not tell the modulus behind \"times G =\"");
        if (told_ && told != *told_)
            fail(line_number(),
                 "tells the modulus " + number_text(told) + "; the comments before tell " + number_text(*told_));
        told_ = told;
        if (!modulus_) modulus_ = told;
    }

    /// A header that was changed contradicts the comments that were not.
    void check_offset(double offset, double y, int l, double dy) const {
        if (offset != l)
            fail(line_number(), "announces the y offset " + number_text(offset) +
                                    "; by the extent in the header it must be " + std::to_string(l));
        if (!(std::abs(y - l * dy) <= element_size_tolerance * std::abs(l) * dy))
            fail(line_number(),
                 "has y " + number_text(y) + "; by the element size in the header it must be " + number_text(l * dy));
    }

    void read_block(const GivenIcs& ics, int l) {
        skip_comment(l, ics.dy);
        skip_comment(l, ics.dy);
        for (int k = 0; k < ics.table.nx; ++k) rows_[row_of(ics.table, k, l)] = read_row(ics, k, l);
    }

    struct Row {
        std::size_t line = 0;
        std::array<double, contact_text::columns.size()> values{};
    };

    Row read_row(const GivenIcs& ics, int k, int l) {
        const std::string offset = "the offset (" + std::to_string(k) + ", " + std::to_string(l) + ")";
        const Words words = words_of(next("the coefficients of " + offset));
        if (words.size() != numbers_per_row)
            fail(line_number(), "holds " + std::to_string(words.size()) +
                                    " numbers; it must hold eleven, ix x Czz Czx Czy Cxz Cxx Cxy Cyz Cyx Cyy of " +
                                    offset);
        std::array<double, numbers_per_row> numbers{};
        for (std::size_t n = 0; n < words.size(); ++n) {
            const std::optional<double> value = number_in(words[n]);
            if (!value) fail(line_number(), "holds " + quoted(words[n]) + "; it must be a finite number");
            numbers[n] = *value;
        }
        if (numbers[0] != k)
            fail(line_number(), "has ix " + number_text(numbers[0]) + "; it must be that of " + offset);
        if (std::abs(numbers[1] - k * ics.dx) > off_by(words[1], k * ics.dx))
            fail(line_number(), "has x " + number_text(numbers[1]) + "; it must be ix dx, " + number_text(k * ics.dx));
        Row row{line_number(), {}};
        std::copy(numbers.begin() + 2, numbers.end(), row.values.begin());
        return row;
    }

    static std::size_t row_of(const IcTable& table, int k, int l) {
        return static_cast<std::size_t>(l + table.ny - 1) * static_cast<std::size_t>(table.nx) +
               static_cast<std::size_t>(k);
    }

    void expect_end() {
        for (; at_ < lines_.size(); ++at_)
            if (!words_of(lines_[at_]).empty())
                fail(at_ + 1, "stands behind the last y offset; the fourth line of the header says where that is");
    }

    /// Fills the table with the part of each component that has its parities in both offsets.
    void keep_symmetric_part(IcTable& table) const {
        const Row& origin = rows_[row_of(table, 0, 0)];
        double scale = 0;
        for (std::size_t n = 0; n < origin.values.size(); ++n)
            if (contact_text::columns[n].displacement == contact_text::columns[n].load)
                scale = std::max(scale, std::abs(origin.values[n]));
        for (int l = 0; l < table.ny; ++l)
            for (int k = 0; k < table.nx; ++k)
                for (std::size_t n = 0; n < contact_text::columns.size(); ++n) {
                    const auto& [i, j] = contact_text::columns[n];
                    table(i, j, k, l) = symmetric_part(table, n, k, l, tolerance_ * scale);
                }
    }

    double symmetric_part(const IcTable& table, std::size_t n, int k, int l, double allowed) const {
        const auto [along_x, along_y] = parity(contact_text::columns[n].displacement, contact_text::columns[n].load);
        const Row &plus = rows_[row_of(table, k, l)], &minus = rows_[row_of(table, k, -l)];
        const double value = plus.values[n];
        const double part = k == 0 && along_x < 0 ? 0 : 0.5 * (value + along_y * minus.values[n]);
        if (std::abs(value - part) <= allowed) return part;
        const std::string has = "has " + number_text(value) + " for C" +
                                std::string(name_of(contact_text::columns[n].displacement)) +
                                std::string(name_of(contact_text::columns[n].load)) + "; ";
        const std::string why = ", as contactd's tables are of bodies symmetric in x and y";
        if (k == 0 && along_x < 0) fail(plus.line, has + "it must vanish at ix = 0" + why);
        if (l == 0) fail(plus.line, has + "it must vanish at the y offset 0" + why);
        fail(plus.line, has + "it must be " + (along_y < 0 ? "minus " : "") + "what line " +
                            std::to_string(minus.line) + " has for the opposite y offset, " +
                            number_text(minus.values[n]) + why);
    }

    const std::vector<std::string_view> lines_;
    std::size_t at_ = 0;
    std::optional<double> modulus_, told_;
    const double tolerance_;
    std::vector<Row> rows_;
};

}  // namespace

GivenIcs from_contact_text(std::string_view text, std::optional<double> G, double tolerance) {
    return Reader(text, G, tolerance).read();
}

}  // namespace contactd
