// Fuzzes requests that open a session or step it, up to the problem to be solved: they are read, or refused with a
// status and a message.
#include "contactd/proto/session.hpp"

#include "contactd/error.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"
#include "input.hpp"

using namespace contactd;
using namespace contactd::proto;

namespace {

constexpr double max_elements = 10'000;  // larger grids only cost time
constexpr MessageLimits limits{1u << 16, 64, 1u << 18, 20'000};

void check_open(const Request& request) {
    const auto& grid = request.params["grid"];
    if (grid["nx"].get<double>() * grid["ny"].get<double>() > max_elements) return;
    const SessionSpec spec = decode_session_spec(request.params, request.frames);
    validate_opening({spec.setup, spec.load});
    ArrayWriter arrays(ArrayEncoding::frame);
    const nlohmann::json again = encode_session_spec(spec, arrays);
    fuzz::require(violations_of("session.open.params", again).empty(), "what was read can be written as a request");
    const SessionSpec second = decode_session_spec(again, arrays.take_frames());
    fuzz::require(second.load.gap.has_value() == spec.load.gap.has_value() &&
                      second.load.approach.has_value() == spec.load.approach.has_value() &&
                      second.load.Fn.has_value() == spec.load.Fn.has_value(),
                  "what is left out stays so");
}

void check_wheel_open(const Request& request) {
    const WheelRailSessionSpec spec = decode_wheel_rail_session_spec(request.params, request.frames);
    validate(spec.setup);
    ArrayWriter arrays(ArrayEncoding::frame);
    const nlohmann::json again = encode_session_spec(spec, arrays);
    fuzz::require(violations_of("session.open.params", again).empty(), "what was read can be written as a request");
    fuzz::require(decode_wheel_rail_session_spec(again, arrays.take_frames()).setup == spec.setup,
                  "a set-up arrives as it was");
}

void check_wheel_step(const Request& request) {
    const WheelRailStepInput input = decode_wheel_rail_step(request.params);
    validate(input.state);
    const nlohmann::json again = encode_step("0", 1, input);
    fuzz::require(violations_of("session.step.params", again).empty(), "what was read can be written as a step");
    fuzz::require(decode_wheel_rail_step(again).state == input.state, "a state arrives as it was");
    fuzz::require(decode_wheel_rail_step(again).patches == input.patches, "what is left out of the answer is, too");
}

/// A step is applied to sessions that differ in the fields that it may omit.
std::vector<ContactProblem> sessions() {
    ContactProblem shift;
    shift.grid = Grid::of_elements(3, 2, 0.1, 0.1);
    shift.bodies = {{200, 0.42}, {200, 0.42}};
    shift.friction = FrictionLaw{{0.3}};
    ContactProblem rolling = shift, whole = shift;
    rolling.gap = whole.gap = Paraboloid{50, 50};
    rolling.motion = Rolling{.force = {.Fx = 0.01}};
    whole.approach = 0.02;
    whole.friction.reset();
    return {whole, shift, rolling};
}

void check_step(const Request& request) {
    decode_fields(request.params, {});
    for (const ContactProblem& opened : sessions()) {
        std::optional<Motion> last;
        if (opened.friction) last = opened.motion;
        try {
            ContactProblem problem = opened;
            apply_step(request.params, request.frames, last, problem);
            validate(problem);
            ArrayWriter arrays(ArrayEncoding::frame);
            StepInput input{problem.approach, problem.Fn, problem.gap, problem.friction};
            if (problem.friction) {
                input.motion = problem.motion;
                input.rigid_slip = problem.rigid_slip;
            }
            fuzz::require(
                violations_of("session.step.params", encode_step("0", 1, input, problem.grid, arrays)).empty(),
                "what was read can be written as a step");
        } catch (const StatusError& error) {
            fuzz::require(!error.status().ok() && !error.status().message.empty(), "a refusal says why");
        } catch (const InvalidArgument& error) {
            fuzz::require(!error.field().empty(), "what is out of range is named");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input = fuzz::split(fuzz::bytes_of(data, size));
    std::string id;
    try {
        const Request request = parse_request(input.text, Frames(input.frames.begin(), input.frames.end()), limits, id);
        if (!request.method.starts_with("session.")) return 0;
        check_params(request.method, request.params);
        check_frames_used(request.params, request.frames);
        const bool wheel = is_of_wheel_rail(request.params);
        if (request.method == "session.open") wheel ? check_wheel_open(request) : check_open(request);
        if (request.method == "session.step") wheel ? check_wheel_step(request) : check_step(request);
    } catch (const StatusError& error) {
        fuzz::require(!error.status().ok() && !error.status().reason.empty(), "a refusal has a code and a reason");
    } catch (const InvalidArgument& error) {
        fuzz::require(!error.field().empty(), "what is out of range is named");
    }
    return 0;
}
