// Computes stresses below the surface.
#include <algorithm>
#include <cmath>

#include "handles/given_block.hpp"
#include "interface/entry.hpp"
#include "problem/area.hpp"

using namespace contactd;
using namespace contactd::cntc;

namespace {

const GivenBlock& block_of(const ProblemCase& problem, int number) {
    const auto found = problem.settings.blocks.find(number);
    if (found == problem.settings.blocks.end())
        throw Refused(error_code::input, "Block " + std::to_string(number) + " does not exist; call subs_addblock.");
    return found->second;
}

/// Returns the stresses of a block, if they belong to its current points.
const SolvedBlock& solved_block(const ProblemCase& problem, int number) {
    const GivenBlock& block = block_of(problem, number);
    const auto found = problem.blocks.find(number);
    if (found == problem.blocks.end() || found->second.given != block)
        throw Refused(error_code::input, "There are no stresses of block " + std::to_string(number) +
                                             "; call subs_calculate after cntc_calculate.");
    return found->second;
}

void calculate_blocks(ProblemCase& problem) {
    const Solved& solved = solution_of(problem);
    problem.blocks.clear();
    std::map<int, SolvedBlock> blocks;
    Observer observer;
    for (const auto& [number, block] : problem.settings.blocks) blocks[number] = solve_block(block, solved, observer);
    problem.blocks = std::move(blocks);
}

}  // namespace

extern "C" void subs_addblock(int* ire, int* icp, int* iblk, int* isubs, int* nx, int* ny, int* nz, double* x,
                              double* y, double* z) {
    answer("subs_addblock", [&] {
        const int number = integer(iblk, "iblk");
        if (number < 1) throw Refused(error_code::input, "Block numbers start at 1.");
        for_each_settings(ire, icp, [&](Settings& settings) {
            // This block and those with larger numbers are deleted, even if the new block is refused.
            settings.blocks.erase(settings.blocks.lower_bound(number), settings.blocks.end());
            settings.blocks[number] =
                read_block(integer(isubs, "isubs"), {x, nx}, {y, ny}, {z, nz}, settings.units.length);
        });
    });
}
CONTACTD_FORTRAN_NAME(subs_addblock)

extern "C" void subs_calculate(int* ire, int* icp, int* ierror) {
    const int code = answer("subs_calculate", [&] {
        const bool all_patches = of_rail(ire) && number_of(icp) == all_problems;
        for (const CasePtr& problem : Registry::of_process().existing(number_of(ire), number_of(icp))) {
            const std::scoped_lock lock(problem->mutex);
            if (all_patches && !problem->current) continue;  // left over from a solve with more patches
            calculate_blocks(*problem);
        }
        require(ierror, "ierror");
    });
    if (ierror != nullptr) *ierror = code;
}
CONTACTD_FORTRAN_NAME(subs_calculate)

extern "C" void subs_getblocksize(int* ire, int* icp, int* iblk, int* nx, int* ny, int* nz) {
    for (int* out : {nx, ny, nz})
        if (out != nullptr) *out = 0;
    get("subs_getblocksize", ire, icp, [&](const ProblemCase& problem) {
        for (const int* out : {nx, ny, nz}) require(out, "a number of points");
        const StressBlock points = block_points(block_of(problem, integer(iblk, "iblk")), grid_of(problem));
        *nx = static_cast<int>(points.x.size());
        *ny = static_cast<int>(points.y.size());
        *nz = static_cast<int>(points.z.size());
    });
}
CONTACTD_FORTRAN_NAME(subs_getblocksize)

extern "C" void subs_getresults(int* ire, int* icp, int* iblk, int* lenarr, int* ncol, int* icol, double* values) {
    if (lenarr != nullptr && ncol != nullptr && *lenarr > 0 && values != nullptr)
        for (int column = 0; column < *ncol; ++column)
            clear(values + static_cast<std::ptrdiff_t>(column) * *lenarr, lenarr);
    get("subs_getresults", ire, icp, [&](const ProblemCase& problem) {
        const int number = integer(iblk, "iblk"), length = integer(lenarr, "lenarr");
        const auto columns = integers(icol, ncol, 1, "icol");
        const SolvedBlock& block = solved_block(problem, number);
        require(values, "values");
        const std::size_t points = block.points.size();
        if (length < 0 || static_cast<std::size_t>(length) < points)
            throw Refused(error_code::input, "A column has " + std::to_string(length) + " values, but " +
                                                 std::to_string(points) + " are required.");
        std::exception_ptr failed;
        for (std::size_t c = 0; c < columns.size(); ++c) try {
                const auto column = block_column(block, columns[c], problem.settings.units);
                std::ranges::copy(column, values + static_cast<std::ptrdiff_t>(c) * length);
            } catch (...) {
                failed = std::current_exception();
            }
        if (failed) std::rethrow_exception(failed);
    });
}
CONTACTD_FORTRAN_NAME(subs_getresults)
