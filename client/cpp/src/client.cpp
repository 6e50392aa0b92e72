#include "contactd/client/client.hpp"

#include <algorithm>
#include <utility>

#include "answers.hpp"
#include "client_impl.hpp"
#include "contactd/below.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/contact_file.hpp"
#include "contactd/proto/ic_part.hpp"
#include "contactd/proto/import_codec.hpp"

namespace contactd::client {

namespace {

/// Returns a table that is too large for one message, assembled from parts.
template <class Ask>
IcReply in_pieces(const IcSpec& spec, const json& params, const MessageLimits& limits, const Ask& ask) {
    IcReply whole;
    whole.table = IcTable(spec.nx, table_rows(spec));
    for (const proto::IcPart& part : proto::parts_within(limits, spec.nx, table_rows(spec))) {
        json asked = params;
        asked.update(proto::encode_ic_part(part));
        const Reply reply = ask(std::move(asked));
        decoded([&] { return proto::read_part(reply.result, reply.frames, part, whole); });
    }
    return whole;
}

}  // namespace

Client::Client(const std::string& endpoint, ClientOptions options)
    : impl_(std::make_unique<Impl>(endpoint, std::move(options))) {}
Client::~Client() = default;
Client::Client(Client&&) noexcept = default;
Client& Client::operator=(Client&&) noexcept = default;

ServerInfo Client::info(const CallOptions& options) {
    return impl_->result_of("server.info", options).get<ServerInfo>();
}

std::string Client::health(const CallOptions& options) {
    return impl_->result_of("server.health", options)["state"].get<std::string>();
}

std::string Client::watch_health(const std::function<void(const std::string&)>& on_state, CallOptions options) {
    std::string last;
    const auto report = [&](const std::string& state) {
        if (std::exchange(last, state) != state) on_state(state);
    };
    options.on_progress = [&](const Progress& progress) { report(progress.state); };
    report(impl_->result_of("health.watch", options)["state"].get<std::string>());
    return last;
}

std::string Client::describe(const CallOptions& options) {
    return impl_->result_of("server.describe", options).dump();
}

std::vector<Metric> Client::metrics(const CallOptions& options) {
    return impl_->result_of("server.metrics", options)["metrics"].get<std::vector<Metric>>();
}

std::string Client::config(const CallOptions& options) {
    return impl_->result_of("server.config", options)["config"].dump();
}

IcReply Client::get_ic(const IcSpec& spec, const CallOptions& options) {
    validate(spec);
    const json params = proto::encode_ic_spec(spec);
    const auto ask = [&](json asked) { return impl_->call("ic.get", std::move(asked), {}, options, wait_of(spec)); };
    try {
        const Reply reply = ask(params);
        return decoded([&] { return proto::decode_ic_reply(reply.result, reply.frames); });
    } catch (const StatusError& error) {
        if (error.status().reason != reason::answer_too_large) throw;
    }
    return in_pieces(spec, params, info(options).limits, ask);
}

std::string Client::export_ic(const IcSpec& spec, FileFormat format, const std::optional<Material>& lower,
                              const CallOptions& options) {
    validate(spec);
    const Reply reply =
        impl_->call("ic.export", proto::encode_ic_export({spec, lower, format}), {}, options, wait_of(spec));
    return decoded([&] { return proto::decode_ic_file(reply.result, reply.frames); });
}

FileContents Client::export_contents(const IcSpec& spec, const CallOptions& options) {
    validate(spec);
    const json params = proto::encode_ic_export({spec, {}, FileFormat::contents});
    const Reply reply = impl_->call("ic.export", params, {}, options, wait_of(spec));
    return decoded([&] { return proto::decode_file_contents(reply.result, reply.frames); });
}

IcImport Client::import_ic(const FileContents& contents, const CallOptions& options) {
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_file_contents(contents, arrays);
    const Reply reply = impl_->call("ic.import", std::move(params), arrays.take_frames(), options);
    return decoded([&] { return proto::decode_import_reply(reply.result); });
}

std::vector<StoredIc> Client::stored_ics(const CallOptions& options, bool evidence) {
    std::vector<StoredIc> tables;
    json page, params = json::object();
    if (evidence) params = {{"evidence", true}, {"limit", 100}};
    do {
        page = impl_->result_of("ic.list", options, params);
        for (const json& table : page["tables"]) tables.push_back(table.get<StoredIc>());
        params["after"] = page.value("next", "");
    } while (page.contains("next"));
    return tables;
}

std::vector<QuarantinedIc> Client::quarantined_ics(const CallOptions& options) {
    return impl_->result_of("ic.list", options, {{"limit", 1}})["quarantined"].get<std::vector<QuarantinedIc>>();
}

int Client::delete_ic(const std::string& key, const CallOptions& options) {
    return impl_->result_of("ic.delete", options, {{"key", key}})["tables"].get<int>();
}

namespace {

/// All arrays of an answer have the size of the grid; only slip, and arrays of requested results, may be missing.
void check_size(const SolveReply& reply, const ContactProblem& problem, const SolutionFields& fields) {
    const ContactSolution& solution = reply.solution;
    const auto check = [&](SolutionField field, const char* what, std::size_t size) {
        if (size == problem.grid.size() || std::find(fields.begin(), fields.end(), field) == fields.end()) return;
        throw ProtocolError("The daemon's answer has " + std::to_string(size) + " " + what + "; the grid has " +
                            std::to_string(problem.grid.size()) + " elements.");
    };
    check(SolutionField::pressure, "pressures", solution.pressure.size());
    check(SolutionField::traction_x, "tractions along x", solution.traction_x.size());
    check(SolutionField::traction_y, "tractions along y", solution.traction_y.size());
    check(SolutionField::element_division, "elements in its division", solution.element_division.size());
    if (problem.displacements) {
        check(SolutionField::displacement_x, "displacements along x", solution.displacement_x.size());
        check(SolutionField::displacement_y, "displacements along y", solution.displacement_y.size());
        check(SolutionField::displacement_z, "displacements along z", solution.displacement_z.size());
    }
    if (problem.temperature) {
        check(SolutionField::upper_temperature, "temperatures of the upper surface", solution.upper_temperature.size());
        check(SolutionField::lower_temperature, "temperatures of the lower surface", solution.lower_temperature.size());
    }
    if (solution.derivatives && problem.model == Model::full)
        check(SolutionField::pressure_by_approach, "derivatives of pressures", solution.pressure_by_approach.size());
    if (!problem.friction) return;
    check(SolutionField::slip_x, "slips along x", solution.slip_x.size());
    check(SolutionField::slip_y, "slips along y", solution.slip_y.size());
}

void validate_each(std::span<const ContactProblem> problems) {
    for (std::size_t i = 0; i < problems.size(); ++i)
        validate_below("problems[" + std::to_string(i) + "]", problems[i]);
}

}  // namespace

SolveReply Client::solve(const ContactProblem& problem, const CallOptions& options, const SolutionFields& fields) {
    validate(problem);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_problem(problem, arrays, fields);
    const Answer reply =
        impl_->answer_to("contact.solve", std::move(params), arrays.take_frames(), options, wait_of(problem));
    return decoded([&] {
        SolveReply result = proto::decode_solve_reply(reply.result, reply.frames);
        check_size(result, problem, fields);
        return result;
    });
}

std::vector<ReplyOrStatus> Client::solve_many(std::span<const ContactProblem> problems, const CallOptions& options,
                                              const SolutionFields& fields) {
    validate_each(problems);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame, proto::EqualArrays::shared);
    json params = proto::encode_problems(problems, arrays, fields);
    const bool builds = std::any_of(problems.begin(), problems.end(),
                                    [](const auto& problem) { return wait_of(problem) == Wait::for_build; });
    const Reply reply = impl_->call("contact.solve_many", std::move(params), arrays.take_frames(), options,
                                    builds ? Wait::for_build : Wait::for_answer);
    return decoded([&] {
        std::vector<ReplyOrStatus> results = proto::decode_solve_replies(reply.result, reply.frames);
        if (results.size() != problems.size())
            throw ProtocolError("The daemon's answer has " + std::to_string(results.size()) + " solutions; " +
                                std::to_string(problems.size()) + " problems were sent.");
        for (std::size_t i = 0; i < results.size(); ++i)
            if (const auto* solved = std::get_if<SolveReply>(&results[i])) check_size(*solved, problems[i], fields);
        return results;
    });
}

std::vector<ContactFileOutcome> Client::run_contact_file(const ContactFileInput& input, const CallOptions& options,
                                                         const SolutionFields& fields) {
    const json requested = proto::encode_fields(fields);
    json params = proto::encode_contact_file_input(input);
    params["fields"] = requested;
    std::vector<ContactFileOutcome> outcomes;
    while (true) {
        const Reply reply = impl_->call("contact_file.run", std::move(params), {}, options);
        decoded([&] {
            for (const json& one : reply.result.at("cases"))
                outcomes.push_back(proto::decode_contact_outcome(one, reply.frames));
            return 0;
        });
        if (!reply.result.contains("run")) return outcomes;
        params = {{"run", reply.result["run"]}, {"max_elements", input.max_elements}, {"fields", requested}};
    }
}

std::vector<ContactFileProblem> Client::convert_contact_file(const ContactFileInput& input,
                                                             const CallOptions& options) {
    const Reply reply = impl_->call("contact_file.convert", proto::encode_contact_file_input(input), {}, options);
    return decoded([&] {
        std::vector<ContactFileProblem> problems;
        for (const json& one : reply.result.at("cases"))
            problems.push_back(proto::decode_contact_problem(one, reply.frames));
        return problems;
    });
}

namespace {

void check_array(const Grid& grid, const std::vector<double>& values, const char* field) {
    if (values.size() != grid.size())
        throw InvalidArgument(field, "has " + std::to_string(values.size()) + " values; the grid has " +
                                         std::to_string(grid.size()) + " elements");
}

void check_arrays(const SubsurfaceRequest& request) {
    check_array(request.grid, request.pressure, "pressure");
    if (!request.traction_x.empty()) check_array(request.grid, request.traction_x, "traction_x");
    if (!request.traction_y.empty()) check_array(request.grid, request.traction_y, "traction_y");
}

void check_arrays(const TemperatureRequest& request) {
    check_array(request.grid, request.pressure, "pressure");
    check_array(request.grid, request.traction_x, "traction_x");
    check_array(request.grid, request.traction_y, "traction_y");
    check_array(request.grid, request.slip_x, "slip_x");
    check_array(request.grid, request.slip_y, "slip_y");
    if (!request.flow_x.empty()) check_array(request.grid, request.flow_x, "flow_x");
    if (!request.flow_y.empty()) check_array(request.grid, request.flow_y, "flow_y");
}

}  // namespace

SubsurfaceReply Client::subsurface(const SubsurfaceRequest& request, const CallOptions& options) {
    validate(request.grid, "grid");
    check_arrays(request);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_subsurface_request(request, arrays);
    const Reply reply = impl_->call("contact.subsurface", std::move(params), arrays.take_frames(), options);
    return decoded([&] {
        SubsurfaceReply result = proto::decode_subsurface_reply(reply.result, reply.frames);
        if (result.shape != request.shape())
            throw ProtocolError("The daemon's answer has the shape " + json(result.shape).dump() + ", but " +
                                json(request.shape()).dump() + " was requested.");
        return result;
    });
}

SurfaceTemperatures Client::temperature(const TemperatureRequest& request, const CallOptions& options) {
    validate(request.grid, "grid");
    check_arrays(request);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    json params = proto::encode_temperature_request(request, arrays);
    const Reply reply = impl_->call("contact.temperature", std::move(params), arrays.take_frames(), options);
    return decoded([&] { return proto::decode_temperature_reply(reply.result, request.grid, reply.frames); });
}

std::vector<SessionSummary> Client::sessions(const CallOptions& options) {
    return impl_->result_of("session.list", options)["sessions"].get<std::vector<SessionSummary>>();
}

std::vector<RecentSolve> Client::recent_solves(const CallOptions& options) {
    return impl_->result_of("solves.recent", options)["solves"].get<std::vector<RecentSolve>>();
}

std::vector<RecentPatch> Client::recent_pressures(std::int64_t number, const CallOptions& options) {
    const Reply reply = impl_->call("solves.pressures", {{"number", number}}, {}, options);
    return decoded([&] { return read_patches(reply.result["patches"], reply.frames); });
}

std::vector<Job> Client::jobs(const CallOptions& options) {
    return impl_->result_of("job.list", options)["jobs"].get<std::vector<Job>>();
}

void Client::cancel_job(const std::string& job, const CallOptions& options) {
    impl_->result_of("job.cancel", options, {{"job", job}});
}

}  // namespace contactd::client
