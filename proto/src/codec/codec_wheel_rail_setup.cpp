// `setup` of wheelrail.*.
#include <span>
#include <utility>

#include "codec_conicity.hpp"
#include "codec_profile.hpp"
#include "contactd/proto/object.hpp"
#include "contactd/proto/wheel_rail.hpp"
#include "named_numbers.hpp"
#include "side_words.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr Words<ContactSearch, 2> searches{{{"locus", ContactSearch::locus}, {"mesh", ContactSearch::mesh}}};
constexpr Words<WheelSurfaceKind, 2> wheel_surfaces{
    {{"exact", WheelSurfaceKind::exact}, {"bilinear", WheelSurfaceKind::bilinear}}};

constexpr Words<Conformal, 5> conformals{{{"off", Conformal::off},
                                          {"half_space", Conformal::half_space},
                                          {"rotated", Conformal::rotated},
                                          {"fem", Conformal::fem},
                                          {"auto", Conformal::automatic}}};
constexpr Words<RigidSlipKind, 2> rigid_slips{{{"plane", RigidSlipKind::plane}, {"surfaces", RigidSlipKind::surfaces}}};
constexpr std::size_t most_points_of_slices = 10 * most_profile_points;

// Each of something that may be const.
template <class Part>
auto numbers_of_track(Part& track) {
    return named(std::pair("gauge", &track.gauge), std::pair("gauge_height", &track.gauge_height),
                 std::pair("cant", &track.cant));
}

template <class Part>
auto numbers_of_wheelset(Part& wheelset) {
    return named(std::pair("flange_back_distance", &wheelset.flange_back_distance),
                 std::pair("flange_back_position", &wheelset.flange_back_position),
                 std::pair("nominal_radius", &wheelset.nominal_radius));
}

template <class Part>
auto numbers_of_patches(Part& rules) {
    return named(std::pair("angle_separate", &rules.angle_separate),
                 std::pair("distance_separate", &rules.distance_separate),
                 std::pair("distance_combine", &rules.distance_combine),
                 std::pair("distance_turn", &rules.distance_turn), std::pair("locus_step", &rules.locus_step));
}

template <class Part>
auto numbers_of_elements(Part& setup) {
    return named(std::pair("dx", &setup.dx), std::pair("dy", &setup.dy), std::pair("dq", &setup.dq));
}

json encode_track(const Track& track) {
    json result = encode_numbers(numbers_of_track(track));
    if (track.rail_origin)
        result["rail_origin"] = object({{"y", finite(track.rail_origin->y, "rail_origin.y")},
                                        {"z", finite(track.rail_origin->z, "rail_origin.z")}});
    if (track.roller_radius) result["roller_radius"] = finite(*track.roller_radius, "roller_radius");
    if (track.springs) {
        json& springs = result["springs"] = json::object();
        if (track.springs->y) springs["y"] = finite(*track.springs->y, "springs.y");
        if (track.springs->z) springs["z"] = finite(*track.springs->z, "springs.z");
    }
    return result;
}

Track decode_track(const json& source) {
    Track track;
    decode_numbers(source, numbers_of_track(track));
    if (source.contains("rail_origin"))
        track.rail_origin =
            ProfilePoint{source["rail_origin"]["y"].get<double>(), source["rail_origin"]["z"].get<double>()};
    if (source.contains("roller_radius")) track.roller_radius = source["roller_radius"].get<double>();
    if (source.contains("springs")) {
        const json& springs = source["springs"];
        track.springs.emplace();
        if (springs.contains("y")) track.springs->y = springs["y"].get<double>();
        if (springs.contains("z")) track.springs->z = springs["z"].get<double>();
    }
    return track;
}

json encode_body(const Body& body, const char* field) {
    if (body.material.is_rigid()) return {{"rigid", true}};
    if (const Ics* ics = body.computed(); ics == nullptr || *ics != Ics{})
        throw InvalidArgument(std::string("setup.bodies.") + field + ".ics",
                              "is no half-space in closed form; the daemon knows wheels and rails as such only");
    return encode_material(body.material);
}

json encode_bodies(const Bodies& bodies) {
    if (bodies.pair)
        throw InvalidArgument(
            "setup.bodies.pair",
            "holds coefficients of a grid, and the grids of wheels on rails are found; give materials");
    return object({{"upper", encode_body(bodies.upper, "upper")}, {"lower", encode_body(bodies.lower, "lower")}});
}

Body decode_body(const json& source) {
    return {source.contains("rigid") ? Material::rigid() : decode_material(source)};
}

json encode_friction(const WheelRailFriction& friction) {
    json result = object({{"along_profile", friction.along_profile}});
    if (friction.mu.size() == 1 && friction.mu[0].angle == 0) {
        result["mu"] = finite(friction.mu[0].mu, "friction.mu");
    } else {
        result["mu"] = json::array();
        for (const auto& [angle, mu] : friction.mu)
            result["mu"].push_back(
                object({{"angle", finite(angle, "friction.mu.angle")}, {"mu", finite(mu, "friction.mu.mu")}}));
    }
    if (friction.kinetic) result["kinetic"] = encode_kinetic(*friction.kinetic);
    return result;
}

std::vector<FrictionAtAngle> decode_coefficients(const json& mu) {
    if (mu.is_number()) return {{0, mu.get<double>()}};
    std::vector<FrictionAtAngle> coefficients;
    for (const json& entry : mu) coefficients.push_back({entry["angle"].get<double>(), entry["mu"].get<double>()});
    return coefficients;
}

WheelRailFriction decode_friction(const json& source) {
    WheelRailFriction friction;
    if (source.contains("mu")) friction.mu = decode_coefficients(source["mu"]);
    friction.along_profile = source.value("along_profile", false);
    if (source.contains("kinetic")) friction.kinetic = decode_kinetic(source["kinetic"]);
    return friction;
}

/// Each slice is a place and the profile there.
template <class Slice>
json encode_slices(const std::vector<Slice>& slices, const char* place, const char* field, ArrayWriter& arrays) {
    json result = json::array();
    for (const auto& [at, profile] : slices)
        result.push_back(object({{place, finite(at, field)}, {"profile", encode_profile(profile, arrays)}}));
    return result;
}

/// One frame may be the points of many slices, each of which has its own.
template <class Slice>
std::vector<Slice> decode_slices(const json& source, const char* place, ProfileKind kind, const std::string& name,
                                 const Frames& frames) {
    std::vector<Slice> slices;
    std::size_t points = 0;
    for (const json& slice : source) {
        const std::string field = name + "[" + std::to_string(slices.size()) + "].profile";
        slices.push_back({slice[place].get<double>(), decode_profile(slice["profile"], kind, frames, field)});
        if (const auto* given = std::get_if<ProfilePoints>(&slices.back().profile.shape))
            points += given->points.size();
        if (points > most_points_of_slices)
            throw invalid_field(
                name,
                "have more than " + std::to_string(most_points_of_slices) + " points together; leave some of them out",
                reason::limit_exceeded);
    }
    return slices;
}

json encode_setup(const WheelRailSetup& setup, ArrayWriter& arrays) {
    json result = encode_numbers(numbers_of_elements(setup));
    result["side"] = word_for(side_words, setup.side);
    result["wheel"] = encode_profile(setup.wheel, arrays);
    result["rail"] = encode_profile(setup.rail, arrays);
    if (!setup.rail_slices.empty())
        result["rail_slices"] = encode_slices(setup.rail_slices, "x", "rail_slices.x", arrays);
    if (!setup.wheel_slices.empty())
        result["wheel_slices"] = encode_slices(setup.wheel_slices, "angle", "wheel_slices.angle", arrays);
    result["track"] = encode_track(setup.track);
    result["wheelset"] = encode_numbers(numbers_of_wheelset(setup.wheelset));
    result["bodies"] = encode_bodies(setup.bodies);
    result["model"] = word_for(model_words, setup.model);
    result["friction"] = setup.friction ? encode_friction(*setup.friction) : json();
    result["patches"] = encode_numbers(numbers_of_patches(setup.patches));
    result["patches"]["search"] = word_for(searches, setup.patches.search);
    result["wheel_surface"] = word_for(wheel_surfaces, setup.wheel_surface);
    result["rigid_slip"] = word_for(rigid_slips, setup.rigid_slip);
    result["conformal"] = word_for(conformals, setup.conformal);
    encode_settings(setup.settings, result);
    result["force"] = object({{"tolerance", finite(setup.force.tolerance, "force.tolerance")},
                              {"max_iterations", setup.force.max_iterations}});
    return result;
}

WheelRailSetup decode_setup(const json& params, const std::string& name, const Frames& frames) {
    WheelRailSetup setup;
    if (!params.contains(name)) return setup;
    const json& source = params[name];
    const auto has = [&](const char* field) { return source.contains(field); };
    decode_numbers(source, numbers_of_elements(setup));
    if (has("side")) setup.side = meaning_of(source["side"], side_words);
    if (has("wheel")) setup.wheel = decode_profile(source["wheel"], ProfileKind::wheel, frames, name + ".wheel");
    if (has("rail")) setup.rail = decode_profile(source["rail"], ProfileKind::rail, frames, name + ".rail");
    if (has("rail_slices"))
        setup.rail_slices =
            decode_slices<RailSlice>(source["rail_slices"], "x", ProfileKind::rail, name + ".rail_slices", frames);
    if (has("wheel_slices"))
        setup.wheel_slices = decode_slices<WheelSlice>(source["wheel_slices"], "angle", ProfileKind::wheel,
                                                       name + ".wheel_slices", frames);
    if (has("track")) setup.track = decode_track(source["track"]);
    if (has("wheelset")) decode_numbers(source["wheelset"], numbers_of_wheelset(setup.wheelset));
    if (has("bodies")) {
        const json& bodies = source["bodies"];
        setup.bodies.upper = decode_body(bodies["upper"]);
        setup.bodies.lower = bodies.contains("lower") ? decode_body(bodies["lower"]) : setup.bodies.upper;
    }
    if (has("model")) setup.model = meaning_of(source["model"], model_words);
    if (has("friction") && source["friction"].is_null())
        setup.friction.reset();
    else if (has("friction"))
        setup.friction = decode_friction(source["friction"]);
    if (has("patches")) {
        const json& patches = source["patches"];
        decode_numbers(patches, numbers_of_patches(setup.patches));
        if (patches.contains("search")) setup.patches.search = meaning_of(patches["search"], searches);
    }
    if (has("wheel_surface")) setup.wheel_surface = meaning_of(source["wheel_surface"], wheel_surfaces);
    if (has("rigid_slip")) setup.rigid_slip = meaning_of(source["rigid_slip"], rigid_slips);
    if (has("conformal")) setup.conformal = meaning_of(source["conformal"], conformals);
    setup.settings = decode_settings(source);
    if (has("force")) {
        setup.force.tolerance = source["force"].value("tolerance", setup.force.tolerance);
        setup.force.max_iterations = source["force"].value("max_iterations", setup.force.max_iterations);
    }
    return setup;
}

json encode_setups(const WheelsetSetup& wheelset, ArrayWriter& arrays) {
    json result = object({{"setup", encode_setup(wheelset.setup, arrays)}});
    if (wheelset.left) result["left"] = encode_setup(*wheelset.left, arrays);
    return result;
}

void add_fields(const PatchFields& fields, json& params) {
    if (fields.solution != all_solution_fields) params["fields"] = encode_fields(fields.solution);
    if (fields.gap) params["gap"] = true;
}

}  // namespace

json encode_wheel_rail_setup(const WheelRailSetup& setup, ArrayWriter& arrays) {
    return encode_setup(setup, arrays);
}

json encode_wheel_rail_friction(const WheelRailFriction& friction) {
    return encode_friction(friction);
}

WheelRailFriction decode_wheel_rail_friction(const json& friction) {
    return decode_friction(friction);
}

json encode_wheel_rail_request(const WheelRailSetup& setup, const WheelRailState& state, const PatchFields& fields,
                               ArrayWriter& arrays) {
    json params = object({{"setup", encode_setup(setup, arrays)}, {"state", encode_wheel_rail_state(state)}});
    add_fields(fields, params);
    return params;
}

json encode_wheelset_request(const WheelsetSetup& setup, const WheelsetState& state, const PatchFields& fields,
                             ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["state"] = encode_wheelset_state(state);
    add_fields(fields, params);
    return params;
}

json encode_geometry_request(const WheelRailSetup& setup, std::span<const WheelRailState> states, ArrayWriter& arrays) {
    json params = object({{"setup", encode_setup(setup, arrays)}, {"states", json::array()}});
    for (const WheelRailState& state : states) params["states"].push_back(encode_wheel_rail_state(state));
    return params;
}

json encode_conicity_request(const WheelsetSetup& setup, const ConicityRequest& wanted, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["conicity"] = encode_conicity(wanted);
    return params;
}

json encode_contacts_request(const WheelsetSetup& setup, const ContactsRequest& wanted, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["contacts"] = encode_contacts_request(wanted);
    return params;
}

json encode_profiles_request(const WheelsetSetup& setup, ArrayWriter& arrays) {
    json params = encode_setups(setup, arrays);
    params["profiles"] = true;
    return params;
}

PatchFields decode_patch_fields(const json& params) {
    return {decode_fields(params, all_solution_fields), params.value("gap", false)};
}

WheelRailSetup decode_wheel_rail_setup(const json& params, const Frames& frames) {
    return decode_setup(params, "setup", frames);
}

WheelsetSetup decode_wheelset_setup(const json& params, const Frames& frames) {
    WheelsetSetup setup{decode_setup(params, "setup", frames)};
    if (params.contains("left")) setup.left = decode_setup(params, "left", frames);
    return setup;
}

}  // namespace contactd::proto
