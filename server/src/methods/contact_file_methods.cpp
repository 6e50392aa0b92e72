// Implements contact_file.*: files of the CONTACT program, whose text comes in a message.
#include <algorithm>
#include <string>
#include <utility>

#include "all_methods.hpp"
#include "contactd/proto/contact_file.hpp"
#include "contactd/read_contact_file.hpp"
#include "handlers.hpp"
#include "jobs/job_reports.hpp"
#include "methods/costs/cost_parts.hpp"
#include "run/case_run.hpp"

namespace contactd::server {
namespace {

using nlohmann::json;

// Counts bytes for each character: lists of numbers, and values that cases keep, of which an answer has a bounded
// number.
constexpr double bytes_of_text = 30, bytes_of_cases = 150, most_bytes_of_cases = 1e8;
constexpr double seconds_of_character = 1e-6;

WorkCost cost_of_text(const json& params) {
    const json* text = member(params, "text");
    const auto length = text != nullptr ? static_cast<double>(text->get_ref<const std::string&>().size()) : 0;
    return {bytes_beside + length * bytes_of_text + std::min(length * bytes_of_cases, most_bytes_of_cases),
            seconds_of_character * length};
}

WorkCost cost_of_contact_file(const json& params, const Config&) {
    return cost_of_text(params);
}

/// Returns the cost of reading, and of one case of the largest size, for which other cases wait.
WorkCost cost_of_cases(const json& params, const Config& config) {
    constexpr double bytes_of_element = 4000, seconds_of_element = 4e-5, bytes_of_point = 250, copies_of_files = 3;
    WorkCost cost = cost_of_text(params);
    if (const json* files = member(params, "files"))
        for (const json& file : *files)
            if (const json* text = member(file, "text"))
                cost.bytes += copies_of_files * static_cast<double>(text->get_ref<const std::string&>().size());
    const std::size_t most = max_elements_of(params, config);
    const auto elements = static_cast<double>(most);
    cost.bytes += bytes_of_element * elements + bytes_of_point * static_cast<double>(cases::most_block_points(most));
    cost.seconds += std::max(params.value("seconds", 10.0), seconds_of_element * elements);
    return cost;
}

constexpr std::size_t most_numbers = 500'000;  // for an answer with more than one case

/// Reads all cases, because each depends on earlier ones, and answers the requested ones, as many as fit into a message
/// of moderate size.
void read_file(const CallPtr& call, const DaemonParts&) {
    const json& params = call->request.params;
    proto::check_frames_used(params, call->request.frames);
    const auto first = params.value("first", std::size_t{0}), count = params.value("count", std::size_t{10000});
    const CallObserver observer(call);
    ContactFileReader reader(params.at("text").get_ref<const std::string&>(), params.value("name", "text"), &observer);
    json cases = json::array();
    std::size_t at = 0, numbers = 0;
    bool has_more = false;
    while (const auto read = reader.next()) {
        if (at++ < first) continue;
        numbers += proto::numbers_of(*read);
        if (cases.size() == count || (!cases.empty() && numbers > most_numbers)) {
            has_more = true;
            --at;
            break;
        }
        cases.push_back(proto::encode_contact_case(*read));
    }
    json result = {{"cases", std::move(cases)}, {"warnings", json::array()}, {"errors", json::array()}};
    if (has_more) {
        result["next"] = at;
    } else {
        result["warnings"] = reader.warnings();
        result["errors"] = reader.errors();
    }
    call->succeed(result);
}

void read_slices(const CallPtr& call, const DaemonParts&) {
    const json& params = call->request.params;
    proto::check_frames_used(params, call->request.frames);
    call->succeed(proto::encode_contact_slices(
        read_contact_slices(params.at("text").get_ref<const std::string&>(), params.value("name", "text"))));
}

}  // namespace

void add_contact_file_methods(MethodTable& methods) {
    methods.add({.name = "contact_file.read", .cost = cost_of_contact_file, .handle = read_file});
    methods.add({.name = "contact_file.run", .job = "solve", .cost = cost_of_cases, .handle = run_contact_file});
    methods.add(
        {.name = "contact_file.convert", .job = "solve", .cost = cost_of_cases, .handle = convert_contact_file});
    methods.add({.name = "contact_file.slices", .handle = read_slices});
}

}  // namespace contactd::server
