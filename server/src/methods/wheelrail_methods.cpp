// Implements wheelrail.*: wheels on their rails.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "all_methods.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "engine/wheel_rail/wheelset_conicity.hpp"
#include "jobs/work_on_call.hpp"
#include "methods/costs/cost_parts.hpp"
#include "methods/costs/costs.hpp"

namespace contactd::server {
namespace {

WheelRailSetup setup_of(const CallPtr& call) {
    const proto::Request& request = call->request;
    WheelRailSetup setup = proto::decode_wheel_rail_setup(request.params, request.frames);
    proto::check_frames_used(request.params, request.frames);  // Comes after errors of missing fields.
    return setup;
}

WheelsetSetup wheelset_setup_of(const CallPtr& call) {
    const proto::Request& request = call->request;
    WheelsetSetup setup = proto::decode_wheelset_setup(request.params, request.frames);
    proto::check_frames_used(request.params, request.frames);
    return setup;
}

void solve_wheel(const CallPtr& call, const DaemonParts& parts) {
    const nlohmann::json& params = call->request.params;
    const WheelRailSetup setup = setup_of(call);
    const WheelRailState state = proto::read_value<WheelRailState>(params.at("state"), "state");
    ++parts.counters.solves;
    WorkOnCall work(call, parts.jobs);
    const auto begun = RecentSolves::Clock::now();
    const WheelRailSolution solution = parts.engine.solve(setup, state, work.observer());
    parts.recent_solves.add(*call, begun, solution);
    proto::ArrayWriter arrays(call->request.arrays);
    const std::string result = proto::write_wheel_rail_solution(solution, proto::decode_patch_fields(params), arrays);
    work.succeed_with(result, arrays.take_frames());
}

void solve_wheelset(const CallPtr& call, const DaemonParts& parts) {
    const proto::Request& request = call->request;
    const WheelsetSetup setup = wheelset_setup_of(call);
    const WheelsetState state = proto::read_value<WheelsetState>(request.params.at("state"), "state");
    ++parts.counters.solves;
    WorkOnCall work(call, parts.jobs);
    const auto begun = RecentSolves::Clock::now();
    const WheelsetSolution solution = parts.engine.solve(setup, state, work.observer());
    parts.recent_solves.add(*call, begun, solution);
    proto::ArrayWriter arrays(request.arrays);
    const nlohmann::json result =
        proto::encode_wheelset_solution(solution, proto::decode_patch_fields(request.params), arrays);
    work.succeed(result, arrays.take_frames());
}

constexpr double seconds_of_position = 1e-3, seconds_of_amplitude = 5e-3;

WorkCost cost_of_geometry(const nlohmann::json& params, const Config&) {
    const auto count = [](const nlohmann::json* object, const char* list) {
        const nlohmann::json* values = object != nullptr ? member(*object, list) : nullptr;
        return values != nullptr ? static_cast<double>(values->size()) : 0;
    };
    const double positions = count(&params, "states") + count(member(params, "contacts"), "shifts"),
                 amplitudes = count(member(params, "conicity"), "amplitudes");
    return {10 * bytes_beside + 1e4 * positions, seconds_of_position * positions + seconds_of_amplitude * amplitudes};
}

void locate(const CallPtr& call, const DaemonParts& parts) {
    const nlohmann::json& params = call->request.params;
    const WheelsetSetup wheelset = wheelset_setup_of(call);
    if (wheelset.left && !params.contains("contacts") && !params.contains("conicity") &&
        !params.value("profiles", false))
        throw InvalidArgument("left",
                              "is given, but states describe one wheel, whose set-up is setup; remove it, or request "
                              "contacts, conicity or profiles");
    std::vector<WheelRailState> states;
    for (const nlohmann::json& state : params.value("states", nlohmann::json::array()))
        states.push_back(proto::read_value<WheelRailState>(state, "state"));
    WorkOnCall work(call, parts.jobs);
    proto::ArrayWriter arrays(call->request.arrays);
    nlohmann::json result =
        proto::encode_wheel_rail_geometries(parts.engine.locate(wheelset.setup, states, work.observer()));
    std::optional<ContactsRequest> contacts;
    std::optional<ConicityRequest> conicity;
    if (params.contains("contacts")) {
        contacts = proto::read_value<ContactsRequest>(params["contacts"], "contacts");
        result["contacts"] = proto::encode_contacts(engine::wheelset_contacts(wheelset, *contacts, work.observer()));
    }
    if (params.contains("conicity")) {
        conicity = proto::read_value<ConicityRequest>(params["conicity"], "conicity");
        result["conicities"] =
            proto::encode_conicities(engine::wheelset_conicities(wheelset, *conicity, work.observer()));
    }
    if (contacts || conicity)
        if (const auto warnings = engine::wheelset_warnings(wheelset, contacts, conicity); !warnings.empty())
            result["warnings"] = warnings;
    if (params.value("profiles", false))
        result["profiles"] = proto::encode_profiles(engine::placed_profiles(wheelset), arrays);
    work.succeed(result, arrays.take_frames());
}

}  // namespace

void add_wheelrail_methods(MethodTable& methods) {
    methods.add({.name = "wheelrail.solve", .job = "solve", .cost = cost_of_wheel_rail, .handle = solve_wheel});
    methods.add({.name = "wheelrail.wheelset", .job = "solve", .cost = cost_of_wheel_rail, .handle = solve_wheelset});
    methods.add({.name = "wheelrail.geometry", .job = "solve", .cost = cost_of_geometry, .handle = locate});
}

}  // namespace contactd::server
