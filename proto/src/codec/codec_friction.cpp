// `friction` of a request, and the motion that a result tells.
#include "codec_parts.hpp"
#include "contactd/fields/friction.hpp"
#include "contactd/proto/object.hpp"
#include "field_codec.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<RollingKind, 2> rolling_kinds{{{"steady", RollingKind::steady}, {"transient", RollingKind::transient}}};

json encode_component(const std::optional<double>& force) {
    return force ? json(finite_field(*force, "friction.force")) : json();
}

/// Adds `force` where a component is prescribed.
void encode_force(const Force& force, json& target) {
    if (!force.empty()) target["force"] = {encode_component(force.Fx), encode_component(force.Fy)};
}

void decode_force(const json& source, Force& force) {
    if (!source.contains("force")) return;
    const json& components = source["force"];
    const auto component = [&](std::size_t i) {
        return components[i].is_null() ? std::optional<double>() : std::optional(components[i].get<double>());
    };
    force = {component(0), component(1)};
}

json encode(const Shift& shift) {
    const auto& [x, y] = shift.rigid_shift;
    json result =
        object({{"rigid_shift", {finite_field(x, "friction.rigid_shift"), finite_field(y, "friction.rigid_shift")}},
                {"rotation", finite_field(shift.rotation, "friction.rotation")},
                {"duration", finite_field(shift.duration, "friction.duration")}});
    encode_force(shift.force, result);
    return result;
}

/// Fields that are not there are as in `shift`.
Shift decode_shift(const json& source, Shift shift = {}) {
    if (source.contains("rigid_shift"))
        shift.rigid_shift = {source["rigid_shift"][0].get<double>(), source["rigid_shift"][1].get<double>()};
    shift.rotation = source.value("rotation", shift.rotation);
    shift.duration = source.value("duration", shift.duration);
    decode_force(source, shift.force);
    return shift;
}

json encode(const Rolling& rolling) {
    json result = object({{"xi", finite_field(rolling.xi, "friction.rolling.xi")},
                          {"eta", finite_field(rolling.eta, "friction.rolling.eta")},
                          {"phi", finite_field(rolling.phi, "friction.rolling.phi")},
                          {"chi", finite_field(rolling.chi, "friction.rolling.chi")},
                          {"spin_offset", finite_field(rolling.spin_offset, "friction.rolling.spin_offset")},
                          {"kind", word_for(rolling_kinds, rolling.kind)},
                          {"steps", rolling.steps},
                          {"velocity", finite_field(rolling.velocity, "friction.rolling.velocity")}});
    if (rolling.dq != 0) result["dq"] = finite_field(rolling.dq, "friction.rolling.dq");
    encode_force(rolling.force, result);
    return result;
}

/// Fields that are not there are as in `rolling`.
Rolling decode_rolling(const json& source, Rolling rolling = {}) {
    rolling.xi = source.value("xi", rolling.xi);
    rolling.eta = source.value("eta", rolling.eta);
    rolling.phi = source.value("phi", rolling.phi);
    rolling.chi = source.value("chi", rolling.chi);
    rolling.dq = source.value("dq", rolling.dq);
    rolling.spin_offset = source.value("spin_offset", rolling.spin_offset);
    if (source.contains("kind")) rolling.kind = meaning_of(source["kind"], rolling_kinds);
    rolling.steps = source.value("steps", rolling.steps);
    rolling.velocity = source.value("velocity", rolling.velocity);
    decode_force(source, rolling.force);
    return rolling;
}

template <class Step>
Step known_or_new(const Motion& motion) {
    const auto* known = std::get_if<Step>(&motion);
    return known ? *known : Step{};
}

}  // namespace

json encode_kinetic(const KineticFriction& kinetic) {
    return write_fields(kinetic, MemberPath("friction.kinetic"));
}

KineticFriction decode_kinetic(const json& source) {
    KineticFriction kinetic;
    read_fields(source, kinetic, MemberPath("friction.kinetic"));
    return kinetic;
}

json encode_friction(const FrictionParts& parts, const Grid& grid, ArrayWriter& arrays) {
    json result = json::object();
    if (parts.motion) {
        const auto* rolling = std::get_if<Rolling>(&*parts.motion);
        result = rolling ? json{{"rolling", encode(*rolling)}} : encode(std::get<Shift>(*parts.motion));
    }
    const auto write = [&](const std::vector<double>& values) {
        return arrays.write(std::span<const double>(values), shape_of(grid));
    };
    if (parts.law) {
        const auto& [mu, kinetic] = *parts.law;
        result["mu"] = mu.size() == 1 ? json(finite_field(mu[0], "friction.mu")) : write(mu);
        if (kinetic) result["kinetic"] = encode_kinetic(*kinetic);
    }
    if (!parts.rigid_slip.empty())
        result["rigid_slip"] = object({{"x", write(parts.rigid_slip.x)}, {"y", write(parts.rigid_slip.y)}});
    return result;
}

void decode_friction(const json& source, const Frames& frames, ContactProblem& problem) {
    if (!problem.friction) problem.friction.emplace();
    const std::vector<std::size_t> shape = shape_of(problem.grid);
    if (source.contains("mu")) {
        if (source["mu"].is_number())
            problem.friction->mu = {source["mu"].get<double>()};
        else
            problem.friction->mu = read_array(source["mu"], frames, shape, "friction.mu");
    }
    if (source.contains("kinetic")) problem.friction->kinetic = decode_kinetic(source["kinetic"]);
    const auto has = [&](const char* field) { return source.contains(field); };
    if (has("rolling"))
        problem.motion = decode_rolling(source["rolling"], known_or_new<Rolling>(problem.motion));
    else if (has("rigid_shift") || has("rotation") || has("duration") || has("force"))
        problem.motion = decode_shift(source, known_or_new<Shift>(problem.motion));
    if (!has("rigid_slip")) return;
    const json& slip = source["rigid_slip"];
    problem.rigid_slip = {read_array(slip["x"], frames, shape, "friction.rigid_slip.x"),
                          read_array(slip["y"], frames, shape, "friction.rigid_slip.y")};
}

json encode_motion(const Motion& motion) {
    return std::visit([](const auto& step) { return encode(step); }, motion);
}

Motion decode_motion(const json& source) {
    if (source.contains("rigid_shift")) return decode_shift(source);
    return decode_rolling(source);
}

}  // namespace contactd::proto
