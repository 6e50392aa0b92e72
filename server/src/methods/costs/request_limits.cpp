#include "request_limits.hpp"

#include <algorithm>
#include <string>

#include "config/config.hpp"
#include "contactd/fields/contact.hpp"
#include "contactd/proto/codec.hpp"
#include "contactd/proto/schema.hpp"

namespace contactd::server {

using nlohmann::json;

namespace {

constexpr const char* grid_limit = " (limits.max_grid_elements)";

/// `field` is the path of `params`. Throws if one side alone exceeds the limit of elements.
long long elements_of(const json& params, std::size_t most, const std::string& field = "") {
    long long elements = 1;
    for (const char* side : {"nx", "ny"}) {
        const auto count = params.at("grid").at(side).get<long long>();
        if (count > static_cast<long long>(most))
            throw proto::invalid_field(
                field + "grid." + side,
                "is " + std::to_string(count) + "; nx times ny must not exceed " + std::to_string(most) + grid_limit,
                proto::reason::limit_exceeded);
        elements *= count;  // each at most 4e6
    }
    return elements;
}

using Pointers = std::vector<json::json_pointer>;

/// Returns, for each array, the fields of the request of which it requires one.
std::vector<Pointers> requirements_of_arrays() {
    const json& answer = proto::schema("contact.solve.result").at("properties");
    std::vector<Pointers> all;
    for (const SolutionField field : all_solution_fields) {
        Pointers& pointers = all.emplace_back();
        for (const json& text : answer.at(std::string(name_of(field))).value("x-only-with", json::array()))
            pointers.emplace_back(text.get<std::string>());
    }
    return all;
}

bool may_have(const json& params, SolutionField field) {
    static const std::vector<Pointers> requirements = requirements_of_arrays();
    const Pointers& one_of = requirements[static_cast<std::size_t>(field)];
    return one_of.empty() || std::ranges::any_of(one_of, [&](const json::json_pointer& pointer) {
               return params.contains(pointer) && params.at(pointer) != json(false);
           });
}

/// Returns the number of elements of params that have passed check_grid_limit.
std::size_t elements_in(const json& params) {
    return static_cast<std::size_t>(elements_of(params, max_grid_elements));
}

}  // namespace

void check_grid_limit(const json& params, std::size_t most) {
    const long long elements = elements_of(params, most);
    if (elements > static_cast<long long>(most))
        throw proto::invalid_field("grid.nx",
                                   "times ny is " + std::to_string(elements) + " elements, but at most " +
                                       std::to_string(most) + " are allowed" + grid_limit,
                                   proto::reason::limit_exceeded);
}

void check_grid_limits(const json& problems, std::size_t most) {
    long long elements = 0;  // at most 1000 times 1.6e13
    for (std::size_t n = 0; n < problems.size(); ++n)
        elements += elements_of(problems[n], most, "problems[" + std::to_string(n) + "].");
    if (elements > static_cast<long long>(most))
        throw proto::invalid_field("problems",
                                   "have " + std::to_string(elements) + " elements together, but at most " +
                                       std::to_string(most) + " are allowed" + grid_limit,
                                   proto::reason::limit_exceeded);
}

ArrayAnswer array_answer(const json& params) {
    SolutionFields fields = proto::decode_fields(params, all_solution_fields);
    std::erase_if(fields, [&](SolutionField field) { return !may_have(params, field); });
    return {std::move(fields), elements_in(params)};
}

void check_answer_fits(std::span<const ArrayAnswer> answers, proto::ArrayEncoding arrays, const MessageLimits& limits) {
    if (arrays == proto::ArrayEncoding::list) return;
    std::size_t total = 0, largest = 0;
    for (const auto& [fields, elements] : answers)
        for (const SolutionField field : fields) {
            const std::size_t bytes = elements * (field == SolutionField::element_division ? 1 : sizeof(double));
            total += bytes;
            largest = std::max(largest, bytes);
        }
    const auto refuse = [](std::size_t is, const char* what, std::size_t limit, const char* name) {
        throw proto::invalid_field("grid.nx",
                                   "and ny result in an answer with " + std::to_string(is) + " bytes " + what +
                                       ", but at most " + std::to_string(limit) + " are allowed (limits." + name +
                                       "): request fewer fields, larger elements, or fewer problems at once",
                                   proto::reason::answer_too_large);
    };
    if (largest > limits.max_frame_bytes) refuse(largest, "in one frame", limits.max_frame_bytes, "max_frame_bytes");
    if (total > limits.max_message_bytes) refuse(total, "of arrays", limits.max_message_bytes, "max_message_bytes");
}

}  // namespace contactd::server
