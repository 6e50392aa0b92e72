// What opens a session and what steps it, up to the problem to be solved: read, or refused with a status in words.
#include "contactd/proto/session.hpp"

#include "contactd/error.hpp"
#include "contactd/proto/schema.hpp"
#include "input.hpp"

using namespace contactd;
using namespace contactd::proto;

namespace {

constexpr double max_elements = 10'000;  // larger grids only cost time
constexpr Limits limits{1u << 16, 64, 1u << 18, 20'000};

void check_open(const Request& request) {
    const auto& grid = request.params["grid"];
    if (grid["nx"].get<double>() * grid["ny"].get<double>() > max_elements) return;
    const SessionSpec spec = decode_session_spec(request.params, request.frames);
    validate(spec.problem);
    ArrayWriter arrays(ArrayEncoding::frame);
    const nlohmann::json again = encode_session_spec(spec, arrays);
    fuzz::require(violations_of("session.open.params", again).empty(), "what was read can be written as a request");
    const SessionSpec second = decode_session_spec(again, arrays.take_frames());
    fuzz::require(second.has_gap == spec.has_gap && second.has_load == spec.has_load, "what is left out stays so");
}

ContactProblem problem_with(const std::optional<Friction>& friction) {
    ContactProblem problem;
    problem.grid = Grid::centred(3, 2, 0.1, 0.1);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    problem.friction = friction;
    return problem;
}

/// A step is laid over sessions that differ in what it may leave out.
std::vector<SessionSpec> sessions() {
    Friction shift, rolling;
    shift.mu = rolling.mu = {0.3};
    Rolling motion;
    motion.Fx = 0.01;
    rolling.motion = motion;
    return {{problem_with({})}, {problem_with(shift), false, false}, {problem_with(rolling), true, false}};
}

void check_step(const Request& request) {
    decode_fields(request.params);
    for (const SessionSpec& spec : sessions()) {
        std::optional<Motion> last;
        if (spec.problem.friction) last = spec.problem.friction->motion;
        try {
            ContactProblem problem = spec.problem;
            apply_step(request.params, request.frames, spec, last, problem);
            validate(problem);
            ArrayWriter arrays(ArrayEncoding::frame);
            const StepInput input{problem.approach, problem.Fn, problem.gap, problem.friction, {}};
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
        const Request request = parse_request(input.text, std::move(input.frames), limits, id);
        if (!request.method.starts_with("session.")) return 0;
        check_params(request.method, request.params);
        check_frames_used(request.params, request.frames);
        if (request.method == "session.open") check_open(request);
        if (request.method == "session.step") check_step(request);
    } catch (const StatusError& error) {
        fuzz::require(!error.status().ok() && !error.status().reason.empty(), "a refusal has a code and a reason");
    } catch (const InvalidArgument& error) {
        fuzz::require(!error.field().empty(), "what is out of range is named");
    }
    return 0;
}
