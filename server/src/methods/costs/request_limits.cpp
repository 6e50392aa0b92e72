#include "request_limits.hpp"

#include <algorithm>
#include <string>

#include "config/config.hpp"
#include "contactd/proto/codec.hpp"

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
    if (!params.contains("friction"))
        std::erase_if(fields, [](SolutionField f) { return f == SolutionField::slip_x || f == SolutionField::slip_y; });
    if (!params.value("displacements", false))
        std::erase_if(fields, [](SolutionField f) {
            return f >= SolutionField::displacement_x && f <= SolutionField::displacement_z;
        });
    const json friction = params.value("friction", json::object());
    if (!friction.contains("layer"))
        std::erase_if(fields,
                      [](SolutionField f) { return f >= SolutionField::flow_x && f <= SolutionField::yield_stress; });
    if (!friction.contains("kinetic") && !friction.contains("temperature"))
        std::erase_if(fields, [](SolutionField f) { return f == SolutionField::friction_coefficient; });
    if (!params.contains("temperature"))
        std::erase_if(fields, [](SolutionField f) { return f >= SolutionField::upper_temperature; });
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
