#include "contactd/wear.hpp"

#include <algorithm>
#include <set>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/wear.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_range(const WearRange& range, const std::string& field) {
    if (!(range.most > range.least))
        throw InvalidArgument(field, "is " + number_text(range.least) + " to " + number_text(range.most) +
                                         "; the upper end must be larger than the lower end");
}

void check_pieces(const std::vector<WearPiece>& pieces, const std::string& field) {
    if (pieces.empty()) throw InvalidArgument(field, "is empty; the function needs at least one piece");
    if (pieces.front().from != 0)
        throw InvalidArgument(field + "[0].from",
                              "is " + number_text(pieces.front().from) + "; the first piece must begin at 0");
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string entry = field + "[" + std::to_string(i) + "]";
        if (i > 0 && !(pieces[i].from > pieces[i - 1].from))
            throw InvalidArgument(entry + ".from", "is " + number_text(pieces[i].from) +
                                                       "; it must be larger than that of the previous piece, " +
                                                       number_text(pieces[i - 1].from));
        if (pieces[i].value < 0)
            throw InvalidArgument(entry + ".value", "is " + number_text(pieces[i].value) +
                                                        "; wear removes material, so it must be at least 0");
        const bool is_last = i + 1 == pieces.size();
        const double end = is_last ? 0 : pieces[i].value + pieces[i].slope * (pieces[i + 1].from - pieces[i].from);
        if (end < 0 || (is_last && pieces[i].slope < 0))
            throw InvalidArgument(
                entry + ".slope",
                "is " + number_text(pieces[i].slope) +
                    ", so the function becomes negative, but wear removes material; start the next piece earlier");
    }
}

void check_zones(const std::vector<WearZone>& zones, const std::string& field) {
    for (std::size_t i = 1; i < zones.size(); ++i)
        if (!(zones[i].angle > zones[i - 1].angle))
            throw InvalidArgument(field + "[" + std::to_string(i) + "].angle",
                                  "is " + number_text(zones[i].angle) + "; it must be larger than the previous one, " +
                                      number_text(zones[i - 1].angle));
}

void check_kind(const WearLaw& law, const std::string& field) {
    const int kinds = int{law.archard.has_value()} + int{law.energy.has_value()} + int{law.usfd.has_value()} +
                      int{law.br.has_value()} + int{law.zobory.has_value()};
    if (kinds == 1) return;
    throw InvalidArgument(field, "has " + std::to_string(kinds) +
                                     " of archard, energy, usfd, br and zobory; give exactly one of them, with all of "
                                     "its coefficients, which have no defaults");
}

void check(const WearLaw& law, const std::string& field) {
    if (law.name.empty()) throw InvalidArgument(field + ".name", "is empty; answers identify laws by their names");
    if (law.source.empty())
        throw InvalidArgument(field + ".source",
                              "is empty; give the source of the coefficients, such as a paper or a test");
    check_range(law.range, field + ".range");
    check_kind(law, field);
    if (law.archard && law.archard->severe)
        check_range(law.archard->severe->velocity, field + ".archard.severe.velocity");
    if (law.usfd) check_pieces(law.usfd->pieces, field + ".usfd.pieces");
    if (law.br) check_pieces(law.br->pieces, field + ".br.pieces");
    if (law.zobory) check_pieces(law.zobory->pieces, field + ".zobory.pieces");
    check_zones(law.zones, field + ".zones");
}

}  // namespace

void validate(const WearRequest& request, const std::string& field) {
    below(field, [&] { check_bounds(request); });
    std::set<std::string> names;
    for (std::size_t i = 0; i < request.laws.size(); ++i) {
        const std::string entry = field + ".laws[" + std::to_string(i) + "]";
        check(request.laws[i], entry);
        if (!names.insert(request.laws[i].name).second)
            throw InvalidArgument(entry + ".name",
                                  "is " + request.laws[i].name +
                                      ", which an earlier law already has; answers identify laws by their names");
    }
}

bool needs_velocity(const WearLaw& law) {
    return law.archard || law.zobory;
}

double factor_at(const std::vector<WearZone>& zones, double angle) {
    if (zones.empty()) return 1;
    const auto behind = std::ranges::find_if(zones, [&](const WearZone& zone) { return zone.angle > angle; });
    if (behind == zones.begin()) return zones.front().factor;
    const WearZone& before = *(behind - 1);
    if (behind == zones.end()) return before.factor;
    return before.factor + (angle - before.angle) / (behind->angle - before.angle) * (behind->factor - before.factor);
}

double value_at(const std::vector<WearPiece>& pieces, double argument) {
    const auto behind = std::ranges::find_if(pieces, [&](const WearPiece& piece) { return piece.from > argument; });
    const WearPiece& piece = behind == pieces.begin() ? pieces.front() : *(behind - 1);
    return piece.value + piece.slope * (argument - piece.from);
}

}  // namespace contactd
