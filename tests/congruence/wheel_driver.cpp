// Runs the cases of wheel_cases.py, in a file, through the C++ client; wheel_telling.py defines the contents of a line.
//
//     congruence-wheel-cpp ipc:///run/contactd.sock cases.txt
#include <cstdio>
#include <memory>
#include <span>

#include "contactd/client/session.hpp"
#include "contactd/error.hpp"
#include "wheel_teller.hpp"
#include "words.hpp"

namespace {

using namespace contactd;

/// Holds one wheel: its inputs so far, and its session.
class Wheel {
   public:
    Wheel(client::Client& client, std::string name) : client_(client), name_(std::move(name)) {}

    void say(const Words& words);
    void call(const Words& words);

   private:
    bool set_up(const Words& words);
    bool set_profile(const Words& words);
    bool set_track(const Words& words);
    bool set_friction(const Words& words);
    bool set_option(const Words& words);
    bool move(const Words& words);
    void make(const std::string& call);
    ProfileSpec& profile(const std::string& body) { return body == "rail" ? setup_.rail : setup_.wheel; }
    Body& body(const std::string& body) { return body == "rail" ? setup_.bodies.upper : setup_.bodies.lower; }

    client::Client& client_;
    const std::string name_;
    WheelRailSetup setup_;
    WheelRailState state_;
    std::unique_ptr<client::WheelRailSession> session_;
};

bool Wheel::set_profile(const Words& w) {
    if (w[0] == "rail_60e1") {
        setup_.rail.shape = Rail60E1{number(w[1])};
    } else if (w[0] == "arc") {
        profile(w[1]).shape = ArcProfile{number(w[2]), number(w[3]), number(w[4]), number(w[5])};
    } else if (w[0] == "cone") {
        profile(w[1]).shape = ConeProfile{number(w[2]), number(w[3]), number(w[4])};
    } else if (w[0] == "points") {
        ProfilePoints points;
        for (std::size_t i = 2; i + 1 < w.size(); i += 2) points.points.push_back({number(w[i]), number(w[i + 1])});
        profile(w[1]).shape = points;
    } else if (w[0] == "add_slice") {
        setup_.rail_slices.push_back({number(w[1]), setup_.rail});
    } else if (w[0] == "add_wheel_slice") {
        setup_.wheel_slices.push_back({number(w[1]), setup_.wheel});
    } else if (w[0] == "clear_wheel_slices") {
        setup_.wheel_slices.clear();
    } else {
        return false;
    }
    return true;
}

bool Wheel::set_track(const Words& w) {
    Track& track = setup_.track;
    if (w[0] == "track") {
        track.gauge = number(w[1]);
        track.gauge_height = number(w[2]);
        track.cant = number(w[3]);
        track.rail_origin.reset();
    } else if (w[0] == "rail_origin") {
        track.rail_origin = ProfilePoint{number(w[1]), number(w[2])};
    } else if (w[0] == "roller") {
        track.roller_radius = number(w[1]);
    } else if (w[0] == "springs") {
        const auto spring = [](double k) { return k == 0 ? std::nullopt : std::optional(k); };
        track.springs = RailSprings{spring(number(w[1])), spring(number(w[2]))};
        if (*track.springs == RailSprings{}) track.springs.reset();
    } else if (w[0] == "wheelset") {
        setup_.wheelset = {number(w[1]), number(w[2]), number(w[3])};
    } else {
        return false;
    }
    return true;
}

bool Wheel::set_friction(const Words& w) {
    const auto law = [&]() -> WheelRailFriction& {
        if (!setup_.friction) setup_.friction.emplace();
        return *setup_.friction;
    };
    if (w[0] == "mu") {
        law().mu = {{0, number(w[1])}};
        law().along_profile = false;
    } else if (w[0] == "mu_by_angle") {
        law().mu.clear();
        for (std::size_t i = 2; i + 1 < w.size(); i += 2) law().mu.push_back({number(w[i]), number(w[i + 1])});
        law().along_profile = w[1] == "1";
    } else if (w[0] == "kinetic") {
        law().kinetic =
            KineticFriction{w[1] == "linear" ? SlipLaw::linear : SlipLaw::exponential, number(w[2]), number(w[3])};
    } else if (w[0] == "frictionless") {
        setup_.friction.reset();
    } else {
        return false;
    }
    return true;
}

bool Wheel::set_option(const Words& w) {
    const bool on = w.size() > 1 && w[1] == "1";
    PatchRules& rules = setup_.patches;
    if (w[0] == "elements") {
        setup_.dx = number(w[1]);
        setup_.dy = number(w[2]);
        setup_.dq = number(w[3]);
    } else if (w[0] == "patch_rules") {
        rules = {number(w[1]), number(w[2]), number(w[3]), number(w[4]), number(w[5]), rules.search};
    } else if (w[0] == "bilinear") {
        setup_.wheel_surface = on ? WheelSurfaceKind::bilinear : WheelSurfaceKind::exact;
    } else if (w[0] == "slip_of_surfaces") {
        setup_.rigid_slip = on ? RigidSlipKind::surfaces : RigidSlipKind::plane;
    } else if (w[0] == "mesh_search") {
        rules.search = on ? ContactSearch::mesh : ContactSearch::locus;
    } else if (w[0] == "conformal") {
        setup_.conformal = w[1] == "rotated" ? Conformal::rotated : Conformal::off;
    } else if (w[0] == "tolerance") {
        auto& settings = setup_.settings;
        (w[1] == "force"        ? setup_.force
         : w[1] == "tangential" ? settings.tangential
         : w[1] == "outer"      ? settings.outer
                                : settings.normal) = SolverSettings{number(w[2]), std::stoi(w[3])};
    } else {
        return false;
    }
    return true;
}

bool Wheel::set_up(const Words& w) {
    if (w[0] == "side")
        setup_.side = w[1] == "left" ? Side::left : Side::right;
    else if (w[0] == "material")
        body(w[1]).material = {number(w[2]), number(w[3])};
    else if (w[0] == "rigid")
        body(w[1]).material = Material::rigid();
    else if (w[0] == "model")
        setup_.model = w[1] == "hertz" ? Model::hertz : w[1] == "fastsim" ? Model::fastsim : Model::full;
    else
        return false;
    return true;
}

bool Wheel::move(const Words& w) {
    if (w[0] == "position") {
        const WheelsetPosition& now = state_.position;
        state_.position = {number(w[1]), number(w[2]), number(w[3]), number(w[4]), now.x, now.pitch};
    } else if (w[0] == "x") {
        state_.position.x = number(w[1]);
    } else if (w[0] == "pitch_angle") {
        state_.position.pitch = number(w[1]);
    } else if (w[0] == "velocity") {
        state_.velocity = {number(w[1]), number(w[2]), number(w[3]), number(w[4]), number(w[5]), number(w[6])};
    } else if (w[0] == "deviation") {
        state_.rail.y = number(w[1]);
        state_.rail.z = number(w[2]);
        state_.rail.roll = number(w[3]);
    } else if (w[0] == "deviation_rate") {
        state_.rail.y_velocity = number(w[1]);
        state_.rail.z_velocity = number(w[2]);
        state_.rail.roll_velocity = number(w[3]);
    } else if (w[0] == "rail_forces") {
        state_.rail.Fy = number(w[1]);
        state_.rail.Fz = number(w[2]);
    } else if (w[0] == "roller_pitch") {
        state_.roller_pitch = number(w[1]);
    } else if (w[0] == "Fz") {
        state_.Fz = number(w[1]);
    } else if (w[0] == "Fx") {
        state_.Fx = number(w[1]);
    } else if (w[0] == "clear_forces") {
        state_.Fz.reset();
        state_.Fx.reset();
    } else if (w[0] == "derivatives") {
        state_.derivatives = w[1] == "1";
    } else {
        return false;
    }
    return true;
}

void Wheel::say(const Words& words) {
    if (set_up(words) || set_profile(words) || set_track(words) || set_friction(words) || set_option(words) ||
        move(words))
        return;
    throw std::runtime_error(name_ + ": there is no " + words[0]);
}

void Wheel::make(const std::string& call) {
    const WheelTeller teller;
    if (call == "solve") {
        teller.tell(client_.wheel_rail(setup_, state_, {}, all_solution_fields, true));
    } else if (call == "geometry") {
        teller.tell(client_.wheel_rail_geometry(setup_, std::span(&state_, 1)).at(0));
    } else if (call == "open") {
        session_ = std::make_unique<client::WheelRailSession>(client_, WheelRailSessionSpec{setup_, {}, true});
    } else {
        WheelRailStepInput input;
        input.state = state_;
        input.friction = setup_.friction;
        input.fields = all_solution_fields;
        input.gap = true;
        const WheelRailStepReply reply = session_->step(input);
        std::printf(" %lld", reply.step);
        teller.tell(reply.solution);
    }
}

void Wheel::call(const Words& words) {
    print_call(name_, words[0], [&] { make(words[0]); });
}

}  // namespace

int main(int arguments, char** argument) {
    return run_cases<Wheel>(arguments, argument, {"solve", "geometry", "open", "step"});
}
