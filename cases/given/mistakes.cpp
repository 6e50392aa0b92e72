#include "mistakes.hpp"

#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <map>
#include <utility>

#include "given/given_bodies.hpp"

namespace contactd::cases {
namespace {

constexpr double least = 1e-30, largest = 1e30;  // their cubes are finite
constexpr double most_slender = 1e6;             // ratio of semi-axes
constexpr double steepest = 1e10;                // ratio of curvatures, for slightly less slender semi-axes

std::string short_number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

class Check {
   public:
    explicit Check(const ContactCase& read) : read_(read) {}

    double value(const std::string& name) const {
        const ContactValue& found = read_.values.at(name);
        const int* whole = std::get_if<int>(&found);
        return whole != nullptr ? *whole : std::get<double>(found);
    }
    int integer(const std::string& name) const {
        const auto found = read_.values.find(name);
        return found == read_.values.end() ? 0 : std::get<int>(found->second);
    }
    bool has(const std::string& name) const { return read_.values.contains(name); }
    int digit(const std::string& name) const { return read_.digits.at(name); }

    /// Requires values to be positive, with finite cubes. Returns whether they are.
    bool positive(std::initializer_list<std::string> names) {
        const std::size_t before = sentences.size();
        for (const std::string& name : names)
            if (const double is = value(name); !(is >= least && is <= largest))
                add(name, is, "it must be positive, from " + short_number(least) + " to " + short_number(largest));
        return sentences.size() == before;
    }
    void add(const std::string& name, double is, const std::string& right) {
        sentences.push_back(name + " is " + short_number(is) + "; " + right);
    }

    void bodies() {
        positive({"GG1", "GG2", "EPS"});
        for (const char* name : {"POISS1", "POISS2"})
            if (const double nu = value(name); !(nu >= 0 && nu <= 0.5)) add(name, nu, "it must be from 0 to 0.5");
        if (digit("M") != material::layered) return;
        positive({"GG3"});
        // A layer without thickness only yields.
        if (const double thickness = value("LAYTHK"); !(thickness >= 0 && thickness <= largest))
            add("LAYTHK", thickness, "it must be zero or positive, up to " + short_number(largest));
    }

    void hertz() {
        static const std::map<int, std::vector<std::string>> names_of_kinds{
            {-1, {"A1", "B1"}}, {-2, {"A1", "AOB"}}, {-3, {"AA", "BB"}},
            {-4, {"A1", "BB"}}, {-5, {"AA", "BB"}},  {-6, {"AA", "BNEG", "BPOS"}}};
        const int kind = integer("IPOTCN");
        const auto names = names_of_kinds.find(kind);
        if (names == names_of_kinds.end()) return;
        bool is_right = positive({has("FN") ? "FN" : "PEN"});
        for (const std::string& name : names->second) is_right = positive({name}) && is_right;
        is_right = positive({"SCALE"}) && is_right;
        if (is_right && kind != -4 && kind != -5) not_too_slender(kind, names->second[0], names->second[1]);
    }
    void not_too_slender(int kind, const std::string& first, const std::string& second) {
        const bool by_ratio = kind == -2;
        const double ratio = by_ratio ? value("AOB") : value(first) / value(second);
        const double most = kind == -1 ? steepest : most_slender;
        if (ratio >= 1 / most && ratio <= most) return;
        add(by_ratio ? "AOB" : first + "/" + second, ratio,
            "it must be from " + short_number(1 / most) + " to " + short_number(most) +
                "; use a line contact (IPOTCN = -4, -5) for longer ones");
    }

    /// Requires lists of elements to match MX and MY, which may have changed since.
    void elements() {
        const auto check = [&](bool acts, const char* name, const char* meaning) {
            if (!acts) return;
            const std::size_t count = std::get<ContactNumbers>(read_.values.at(name))->size();
            const int columns = integer("MX"), rows = integer("MY");
            if (static_cast<double>(count) == static_cast<double>(columns) * rows) return;
            sentences.push_back(std::string(meaning) + " is kept for " + std::to_string(count) +
                                " elements, but MX, MY are " + std::to_string(columns) + ", " + std::to_string(rows) +
                                "; give it anew");
        };
        check(integer("IPOTCN") > 0 && integer("IBASE") == 9, "GAP", "the undeformed distance (IBASE = 9)");
        check(digit("E") != 0 && integer("EXRHS") == 9, "SLIP_X", "the extra rigid slip (E = 9)");
    }

    std::vector<std::string> sentences;

   private:
    const ContactCase& read_;
};

}  // namespace

std::vector<std::string> mistakes(const ContactCase& read) {
    Check check(read);
    check.bodies();
    if (read.module_number == 3) {
        check.hertz();
        check.elements();
    }
    return std::move(check.sentences);
}

}  // namespace contactd::cases
