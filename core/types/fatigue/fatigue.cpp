#include "contactd/fatigue.hpp"

#include <algorithm>
#include <set>

#include "contactd/below.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/fatigue.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

void check_named(const std::string& name, const std::string& source, const std::string& field) {
    if (name.empty())
        throw InvalidArgument(field + ".name", "is empty; answers and files identify the function by its name");
    if (source.empty())
        throw InvalidArgument(field + ".source", "is empty; give the source of the numbers, such as a paper or a test");
}

void check(const DamageFunction& function, const std::string& field) {
    check_named(function.name, function.source, field);
    if (!(function.range.most > function.range.least))
        throw InvalidArgument(field + ".range", "is " + number_text(function.range.least) + " to " +
                                                    number_text(function.range.most) +
                                                    "; the upper end must be larger than the lower end");
    if (function.pieces.empty())
        throw InvalidArgument(field + ".pieces", "is empty; the function needs at least one piece");
    if (function.pieces.front().from != 0)
        throw InvalidArgument(field + ".pieces[0].from",
                              "is " + number_text(function.pieces.front().from) + "; the first piece must begin at 0");
    for (std::size_t i = 1; i < function.pieces.size(); ++i)
        if (!(function.pieces[i].from > function.pieces[i - 1].from))
            throw InvalidArgument(field + ".pieces[" + std::to_string(i) + "].from",
                                  "is " + number_text(function.pieces[i].from) +
                                      "; it must be larger than that of the previous piece, " +
                                      number_text(function.pieces[i - 1].from));
}

void check(const Passage& passage, const std::string& field) {
    const auto refuse = [](const std::string& entry, double depth, double before) {
        throw InvalidArgument(
            entry, "is " + number_text(depth) + "; it must be larger than the previous one, " + number_text(before));
    };
    for (std::size_t i = 1; i < passage.depths.size(); ++i)
        if (!(passage.depths[i] > passage.depths[i - 1]))
            refuse(field + ".depths[" + std::to_string(i) + "]", passage.depths[i], passage.depths[i - 1]);
    for (std::size_t i = 0; i < passage.depths.size(); ++i)
        if (!(passage.depths[i] >= 0 && passage.depths[i] <= 1e6))
            throw InvalidArgument(field + ".depths[" + std::to_string(i) + "]",
                                  "is " + number_text(passage.depths[i]) + "; depths must lie in [0, 1e6] mm");
    for (std::size_t i = 1; i < passage.residual.size(); ++i)
        if (!(passage.residual[i].depth > passage.residual[i - 1].depth))
            refuse(field + ".residual[" + std::to_string(i) + "].depth", passage.residual[i].depth,
                   passage.residual[i - 1].depth);
}

}  // namespace

void validate(const FatigueRequest& request, const std::string& field) {
    below(field, [&] { check_bounds(request); });
    if (request.strength) {
        check_named(request.strength->name, request.strength->source, field + ".strength");
        if (request.strength->tau_e && !request.strength->a_DV)
            throw InvalidArgument(field + ".strength.tau_e", "is given without a_DV; Dang Van's limit requires both");
    }
    std::set<std::string> names;
    for (std::size_t i = 0; i < request.damages.size(); ++i) {
        const std::string entry = field + ".damages[" + std::to_string(i) + "]";
        check(request.damages[i], entry);
        if (!names.insert(request.damages[i].name).second)
            throw InvalidArgument(
                entry + ".name",
                "is " + request.damages[i].name +
                    ", which an earlier function already has; answers identify functions by their names");
    }
    if (request.passage) check(*request.passage, field + ".passage");
}

ResidualStress residual_at(const std::vector<ResidualStress>& table, double depth) {
    if (table.empty()) return {.depth = depth};
    const auto behind = std::ranges::find_if(table, [&](const ResidualStress& entry) { return entry.depth > depth; });
    if (behind == table.begin()) return {depth, table.front().xx, table.front().yy};
    const ResidualStress& before = *(behind - 1);
    if (behind == table.end()) return {depth, before.xx, before.yy};
    const double share = (depth - before.depth) / (behind->depth - before.depth);
    return {depth, before.xx + share * (behind->xx - before.xx), before.yy + share * (behind->yy - before.yy)};
}

}  // namespace contactd
