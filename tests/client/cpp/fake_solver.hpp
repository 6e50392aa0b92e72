// Provides valid answers of a fake daemon.
#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "contactd/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "fake_daemon.hpp"

namespace fake {

using namespace contactd;

inline const nlohmann::json healthy{{"state", "serving"}};

inline ContactProblem problem() {
    ContactProblem problem;
    problem.grid = Grid::of_elements(3, 2, 0.1, 0.1);
    problem.bodies = {{200, 0.42}, {200, 0.42}};
    problem.gap = Paraboloid{50, 50};
    problem.approach = 0.02;
    return problem;
}

inline std::vector<double> gap_of(const ContactProblem& problem) {
    if (const auto* array = std::get_if<std::vector<double>>(&*problem.gap)) return *array;
    return sampled(std::get<Paraboloid>(*problem.gap), problem.grid);
}

/// Solves by returning the gap as the pressure.
inline SolveReply gap_as_pressure(const ContactProblem& read) {
    SolveReply reply;
    reply.solution.pressure = reply.solution.traction_x = reply.solution.traction_y = gap_of(read);
    reply.solution.element_division.assign(read.grid.size(), ElementState::slip);
    reply.ics.upper = {"closed_form", "", {}};
    reply.ics.upper->evidence.source = "analytic";
    reply.ics.lower = reply.ics.upper;
    return reply;
}

inline std::vector<Frames> message_of(const nlohmann::json& request, const nlohmann::json& result,
                                      proto::ArrayWriter& arrays) {
    Frames message{reply(request, result)};
    for (proto::Frame& frame : arrays.take_frames()) message.push_back(std::move(frame));
    return {message};
}

inline std::vector<Frames> echo_gap(const nlohmann::json& request, const Frames& frames) {
    const ContactProblem read = proto::decode_problem(request["params"], frames);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    return message_of(request, proto::encode_solve_reply(gap_as_pressure(read), read.grid, arrays), arrays);
}

/// Does the same for many problems; fails those without contact.
inline std::vector<Frames> echo_gaps(const nlohmann::json& request, const Frames& frames) {
    std::vector<proto::ResultOrStatus> results;
    for (const auto& problem : request["params"]["problems"]) {
        const ContactProblem read = proto::decode_problem(problem, frames);
        if (read.approach > 0)
            results.push_back(proto::encode_outcome(gap_as_pressure(read), read.grid, proto::ArrayEncoding::frame));
        else
            results.emplace_back(Status{StatusCode::internal, "No.", "UNEXPECTED", {}, 0});
    }
    Frames arrays;
    Frames message{
        reply(request, nlohmann::json::parse(proto::encode_results("solutions", std::move(results), arrays)))};
    message.insert(message.end(), arrays.begin(), arrays.end());
    return {message};
}

}  // namespace fake
