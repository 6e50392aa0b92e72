// Implements the client's calls for wheels on rails.
#include <algorithm>
#include <string>
#include <utility>

#include "client_impl.hpp"
#include "contactd/below.hpp"
#include "contactd/client/client.hpp"
#include "contactd/error.hpp"
#include "contactd/proto/wheel_rail.hpp"

namespace contactd::client {
namespace {

void validate_both(const WheelsetSetup& setup) {
    validate_below("setup", setup.setup);
    if (setup.left) validate_below("left", *setup.left);
}

const json& part_of(const json& result, const char* name) {
    if (!result.contains(name)) throw ProtocolError(std::string("The daemon's answer lacks the ") + name + ".");
    return result[name];
}

}  // namespace

// Refuses an answer without pressures. read_array checks that the others have the size of their grid.
void check_pressures(const WheelRailSolution& solution, const SolutionFields& fields) {
    if (std::find(fields.begin(), fields.end(), SolutionField::pressure) == fields.end()) return;
    for (const WheelRailPatch& patch : solution.patches)
        if (patch.solution.pressure.empty())
            throw ProtocolError("The daemon's answer lacks the requested pressures of a patch.");
}

WheelRailSolution Client::wheel_rail(const WheelRailSetup& setup, const WheelRailState& state,
                                     const CallOptions& options, const SolutionFields& fields, bool gap) {
    validate_below("setup", setup);
    below("state", [&] { validate(setup, state); });
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_wheel_rail_request(setup, state, {fields, gap}, arrays);
    const Answer reply =
        impl_->answer_to("wheelrail.solve", std::move(params), arrays.take_frames(), options, wait_of(setup));
    return decoded([&] {
        WheelRailSolution solution = proto::decode_wheel_rail_solution(reply.result, reply.frames);
        check_pressures(solution, fields);
        return solution;
    });
}

WheelsetSolution Client::wheelset(const WheelsetSetup& setup, const WheelsetState& state, const CallOptions& options,
                                  const SolutionFields& fields, bool gap) {
    validate_both(setup);
    validate_below("state", state);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_wheelset_request(setup, state, {fields, gap}, arrays);
    const Reply reply =
        impl_->call("wheelrail.wheelset", std::move(params), arrays.take_frames(), options, wait_of(setup));
    return decoded([&] {
        WheelsetSolution solution = proto::decode_wheelset_solution(reply.result, reply.frames);
        check_pressures(solution.left, fields);
        check_pressures(solution.right, fields);
        return solution;
    });
}

std::vector<WheelRailGeometry> Client::wheel_rail_geometry(const WheelRailSetup& setup,
                                                           std::span<const WheelRailState> states,
                                                           const CallOptions& options) {
    if (states.empty()) return {};
    validate_below("setup", setup);
    for (std::size_t i = 0; i < states.size(); ++i) validate_below("states[" + std::to_string(i) + "]", states[i]);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_geometry_request(setup, states, arrays);
    const Reply reply = impl_->call("wheelrail.geometry", std::move(params), arrays.take_frames(), options);
    return decoded([&] {
        std::vector<WheelRailGeometry> geometries = proto::decode_wheel_rail_geometries(reply.result);
        if (geometries.size() != states.size())
            throw ProtocolError("The daemon's answer has " + std::to_string(geometries.size()) + " geometries; " +
                                std::to_string(states.size()) + " states were sent.");
        return geometries;
    });
}

std::vector<EquivalentConicity> Client::equivalent_conicities(const WheelsetSetup& setup,
                                                              const ConicityRequest& request,
                                                              const CallOptions& options) {
    validate_both(setup);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_conicity_request(setup, request, arrays);
    const Reply reply = impl_->call("wheelrail.geometry", std::move(params), arrays.take_frames(), options);
    return decoded([&] { return proto::decode_conicities(part_of(reply.result, "conicities")); });
}

std::vector<WheelsetContacts> Client::wheelset_contacts(const WheelsetSetup& setup, const ContactsRequest& request,
                                                        const CallOptions& options) {
    validate_both(setup);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_contacts_request(setup, request, arrays);
    const Reply reply = impl_->call("wheelrail.geometry", std::move(params), arrays.take_frames(), options);
    return decoded([&] { return proto::decode_contacts(part_of(reply.result, "contacts")); });
}

ProfilesOfSides Client::placed_profiles(const WheelsetSetup& setup, const CallOptions& options) {
    validate_both(setup);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_profiles_request(setup, arrays);
    const Reply reply = impl_->call("wheelrail.geometry", std::move(params), arrays.take_frames(), options);
    return decoded([&] { return proto::decode_profiles(part_of(reply.result, "profiles"), reply.frames); });
}

}  // namespace contactd::client
