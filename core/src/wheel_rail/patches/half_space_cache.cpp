#include "half_space_cache.hpp"

#include <algorithm>
#include <utility>

#include "contactd/error.hpp"
#include "contactd/half_space.hpp"
#include "contactd/ic_record.hpp"

namespace contactd {
namespace {

constexpr std::size_t most_cached = 64;
constexpr std::size_t most_cached_elements = 400'000;  // limit for all together, about 100 MB
constexpr int spare = 16;                              // additional offsets of a table

/// Returns a dimensionless table with units, made as in the engine, so that both have the same rounding errors.
IcTable table_of(const Body& body, double dx, double dy, int nx, int ny, const Observer& observer) {
    if (body.material.is_rigid()) return IcTable(nx, ny);
    const IcSpec spec{std::get<Ics>(body.ics), body.material, dx, dy, nx, ny};
    IcRecord record;
    record.spec = dimensionless(spec);
    record.tables = half_space_table(record.spec, observer);
    return std::get<IcTable>(body_table(record, spec, 1, observer));
}

bool is_closed_form(const Body& body) {
    if (body.material.is_rigid()) return true;
    const Ics* ics = body.computed();
    return ics != nullptr && ics->source == IcSource::analytic && ics->body == BodyShape::half_space &&
           !ics->line_contact;
}

}  // namespace

HalfSpaceCache::HalfSpaceCache(Bodies bodies) : bodies_(std::move(bodies)) {
    if (bodies_.pair || !is_closed_form(bodies_.upper) || !is_closed_form(bodies_.lower))
        throw InvalidArgument("bodies",
                              "are not half-spaces in closed form; other bodies require a source of their operators");
}

ContactInfluence HalfSpaceCache::of(const ContactProblem& problem, const PatchStrips& strips,
                                    const Observer& observer) {
    if (strips.of_sections())
        throw InvalidArgument(
            "conformal", "is fem, whose tables require finite elements; give a source of operators that provides them");
    if (strips.along_loaded_row) return patch_influence(problem, strips, nullptr, nullptr, observer);
    const auto flat = [&] {
        const std::lock_guard lock(mutex_);
        return flat_influence(problem, observer);
    };
    return strips.flat() ? flat() : rotated_.of(problem, strips, observer, flat);
}

const ContactInfluence& HalfSpaceCache::flat_influence(const ContactProblem& problem, const Observer& observer) {
    const Grid& grid = problem.grid;
    const auto [step_x, step_y] = step_of(problem);
    const Key key{grid.nx, grid.ny, grid.dx, grid.dy, step_x, step_y};
    const auto found = std::find_if(cache_.begin(), cache_.end(), [&](const Entry& entry) { return entry.key == key; });
    if (found != cache_.end()) {
        cache_.splice(cache_.begin(), cache_, found);
        return found->influence;
    }
    cache_.push_front({key, make_influence(problem, table_for(grid, observer), observer)});
    std::size_t elements = 0, count = 0;
    for (auto entry = cache_.begin(); entry != cache_.end();) {
        elements +=
            static_cast<std::size_t>(std::get<0>(entry->key)) * static_cast<std::size_t>(std::get<1>(entry->key));
        const bool goes = ++count > 1 && (count > most_cached || elements > most_cached_elements);
        entry = goes ? cache_.erase(entry) : std::next(entry);
    }
    return cache_.front().influence;
}

IcTable HalfSpaceCache::table_for(const Grid& grid, const Observer& observer) {
    const bool same_elements = grid.dx == dx_ && grid.dy == dy_;
    if (!same_elements || table_.nx < grid.nx || table_.ny < grid.ny) {
        const int nx = std::max(same_elements ? table_.nx : 0, grid.nx + spare);
        const int ny = std::max(same_elements ? table_.ny : 0, grid.ny + spare);
        IcTable upper = table_of(bodies_.upper, grid.dx, grid.dy, nx, ny, observer);
        const bool alike = bodies_.upper == bodies_.lower;
        table_ = alike ? pair_of(upper, upper)
                       : pair_of(std::move(upper), table_of(bodies_.lower, grid.dx, grid.dy, nx, ny, observer));
        dx_ = grid.dx;
        dy_ = grid.dy;
    }
    return cropped(table_, grid.nx, grid.ny);
}

}  // namespace contactd
