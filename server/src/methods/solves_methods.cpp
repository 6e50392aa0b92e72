// Implements solves.*: the last solves, each reported to its user only.
#include <chrono>

#include "all_methods.hpp"
#include "contactd/proto/grid.hpp"
#include "contactd/proto/message.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

json to_json(const RecentSolve& solve) {
    json entry = {{"number", solve.number},
                  {"method", solve.method},
                  {"id", solve.id},
                  {"at", std::chrono::duration<double>(solve.at.time_since_epoch()).count()},
                  {"seconds", solve.seconds},
                  {"elements", solve.elements},
                  {"patches", solve.patches},
                  {"converged", solve.converged},
                  {"iterations", solve.iterations},
                  {"residual", solve.residual},
                  {"forces", solve.forces},
                  {"pmax", solve.pmax},
                  {"has_pressures", solve.pressures != nullptr}};
    if (solve.grid) entry["grid"] = proto::encode_grid(*solve.grid);
    return entry;
}

void recent(const CallPtr& call, const DaemonParts& parts) {
    json solves = json::array();
    for (const RecentSolve& solve : parts.recent_solves.of(call->user())) solves.push_back(to_json(solve));
    call->succeed({{"solves", std::move(solves)}});
}

void pressures(const CallPtr& call, const DaemonParts& parts) {
    proto::check_frames_used(call->request.params, call->request.frames);
    const auto number = call->request.params["number"].get<std::uint64_t>();
    proto::ArrayWriter arrays(call->request.arrays);
    json patches = json::array();
    for (const RecentPatch& patch : *parts.recent_solves.pressures(call->user(), number)) {
        const std::vector<double> values(patch.pressure.begin(), patch.pressure.end());
        const auto* division = reinterpret_cast<const unsigned char*>(patch.element_division.data());
        const std::vector<std::size_t> shape{static_cast<std::size_t>(patch.grid.ny),
                                             static_cast<std::size_t>(patch.grid.nx)};
        patches.push_back({{"grid", proto::encode_grid(patch.grid)},
                           {"pressure", arrays.write(values, shape)},
                           {"element_division", arrays.write({division, patch.element_division.size()}, shape)}});
    }
    call->succeed({{"number", number}, {"patches", std::move(patches)}}, arrays.take_frames());
}

}  // namespace

void add_solves_methods(MethodTable& methods) {
    methods.add({.name = "solves.recent", .is_immediate = true, .handle = recent});
    methods.add({.name = "solves.pressures", .priority = proto::Priority::high, .handle = pressures});
}

}  // namespace contactd::server
