// Fuzzes a request as the daemon reads it, up to the problem to be solved: it is read, or refused with a status and a
// message.
#include "contactd/contact.hpp"
#include "contactd/error.hpp"
#include "contactd/fields/conicity.hpp"
#include "contactd/fields/wheel_rail_state.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/field_codec.hpp"
#include "contactd/proto/schema.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "input.hpp"

using namespace contactd;
using namespace contactd::proto;

namespace {

constexpr std::size_t max_elements = 10'000;  // larger grids only cost time
constexpr MessageLimits limits{1u << 16, 64, 1u << 18, 20'000};

void check_problem(const ContactProblem& problem) {
    validate(problem);
    ArrayWriter arrays(ArrayEncoding::frame);
    const nlohmann::json again = encode_problem(problem, arrays);
    fuzz::require(violations_of("contact.solve.params", again).empty(), "what was read can be written as a request");
}

bool is_large(const nlohmann::json& params) {
    const auto grid = params.find("grid");
    if (grid == params.end()) return false;
    return grid->at("nx").get<double>() * grid->at("ny").get<double>() > double(max_elements);
}

void decode(const Request& request) {
    const nlohmann::json& params = request.params;
    if (is_large(params)) return;
    if (request.method == "ic.get") {
        const IcSpec spec = decode_ic_spec(params);
        validate(spec);
        fuzz::require(violations_of("ic.get.params", encode_ic_spec(spec)).empty(), "a spec can be written again");
    } else if (request.method == "ic.export") {
        decode_ic_export(params);
    } else if (request.method == "contact.solve") {
        check_problem(decode_problem(params, request.frames));
    } else if (request.method == "contact.solve_many") {
        for (const auto& problem : params.at("problems"))
            if (is_large(problem)) return;
        check_referred_elements(params.at("problems"), limits);
        for (const auto& problem : params.at("problems")) check_problem(decode_problem(problem, request.frames));
    } else if (request.method == "contact.subsurface") {
        decode_subsurface_request(params, request.frames, limits);
    } else if (request.method == "contact.temperature") {
        decode_temperature_request(params, request.frames);
    } else if (request.method == "wheelrail.wheelset") {
        decode_wheelset_setup(params, request.frames);
        read_value<WheelsetState>(params["state"], "state");
    } else if (request.method.starts_with("wheelrail.")) {
        decode_wheelset_setup(params, request.frames);
        if (params.contains("state")) read_value<WheelRailState>(params["state"], "state");
        if (params.contains("conicity")) read_value<ConicityRequest>(params["conicity"], "conicity");
        if (params.contains("contacts")) read_value<ContactsRequest>(params["contacts"], "contacts");
    }
}

void check_status(const Status& status) {
    fuzz::require(!status.ok() && !status.reason.empty(), "a refusal has a code and a reason");
    fuzz::require(!status.message.empty() && status.message.size() < 20'000, "a refusal says why, and not at length");
    fuzz::require(
        violations_of("reply", {{"contactd", protocol_version}, {"id", "7f"}, {"status", to_json(status)}}).empty(),
        "a refusal conforms to its schema");
    (void)dump(to_json(status));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    std::string id;
    try {
        const Request request = parse_request(input.text, Frames(input.frames.begin(), input.frames.end()), limits, id);
        check_params(request.method, request.params);
        check_frames_used(request.params, request.frames);
        decode(request);
    } catch (const StatusError& error) {
        check_status(error.status());
    } catch (const InvalidArgument& error) {
        fuzz::require(!error.field().empty(), "what is out of range is named");
    }
    return 0;
}
