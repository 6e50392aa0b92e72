// Runs the cases of cases.py, in a file, through the C++ client; telling.py defines the contents of a line.
//
//     congruence-cpp ipc:///run/contactd.sock cases.txt
#include <functional>
#include <map>
#include <memory>

#include "contactd/client/session.hpp"
#include "contactd/error.hpp"
#include "sections.hpp"
#include "teller.hpp"
#include "words.hpp"

namespace {

using namespace contactd;
using Numbers = std::vector<double>;

/// Holds one contact: its inputs so far, and its session.
class Case {
   public:
    Case(client::Client& client, std::string name) : client_(client), name_(std::move(name)) {}

    /// Set-up or load.
    void say(const Words& words);
    void call(const Words& words);

   private:
    void load(const Words& words);
    void move(const Words& words);
    void change(bool& what) { what = session_ != nullptr; }
    void each_body(const std::string& which, const std::function<void(Body&)>& change);
    SolverSettings& settings_of(const std::string& solver);
    Numbers ramp(const Words& words, std::size_t at) const;
    Numbers bowl(double scale) const;
    Motion motion() const;
    SessionSpec opening();
    StepInput step() const;
    void make(const Words& words);

    client::Client& client_;
    const std::string name_;
    std::unique_ptr<client::Session> session_;
    SessionSpec spec_;
    bool rolls_ = false;
    Shift shift_;
    Rolling rolling_;
    Force force_;
    std::optional<FrictionLaw> law_;
    bool gap_ = false, friction_ = false, motion_ = false, slip_ = false;  // said since the start
    std::map<std::string, client::SavedState> saved_;
};

void Case::each_body(const std::string& which, const std::function<void(Body&)>& change) {
    if (which != "lower") change(spec_.setup.bodies.upper);
    if (which != "upper") change(spec_.setup.bodies.lower);
}

SolverSettings& Case::settings_of(const std::string& solver) {
    ContactSettings& settings = spec_.setup.settings;
    if (solver == "normal") return settings.normal;
    return solver == "tangential" ? settings.tangential : settings.outer;
}

Numbers Case::ramp(const Words& words, std::size_t at) const {
    Numbers made(spec_.setup.grid.size());
    const long step = std::stol(words[at + 2]), period = std::stol(words[at + 3]);
    for (std::size_t i = 0; i < made.size(); ++i)
        made[i] = number(words[at]) + number(words[at + 1]) * static_cast<double>(static_cast<long>(i) * step % period);
    return made;
}

Numbers Case::bowl(double scale) const {
    const Grid& grid = spec_.setup.grid;
    Numbers made;
    for (int y = 0; y < grid.ny; ++y)
        for (int x = 0; x < grid.nx; ++x) {
            const int across = 2 * x - grid.nx + 1, along = 2 * y - grid.ny + 1;
            made.push_back(scale * (across * across + along * along));
        }
    return made;
}

void Case::say(const Words& w) {
    ContactSetup& setup = spec_.setup;
    if (w[0] == "grid")
        setup.grid = {std::stoi(w[1]), std::stoi(w[2]), number(w[3]), number(w[4]), number(w[5]), number(w[6])};
    else if (w[0] == "material")
        each_body(w[1], [&](Body& body) { body.material = {number(w[2]), number(w[3])}; });
    else if (w[0] == "rigid")
        each_body(w[1], [](Body& body) { body.material = Material::rigid(); });
    else if (w[0] == "half_space")
        each_body(w[1], [&](Body& body) {
            Ics ics;
            ics.load_shape = w[2] == "bilinear" ? LoadShape::bilinear : LoadShape::constant;
            body.ics = ics;
        });
    else if (w[0] == "creep")
        each_body(w[1], [&](Body& body) { body.viscoelastic = Viscoelasticity{number(w[2]), number(w[3])}; });
    else if (w[0] == "layers")
        each_body(w[1], [&](Body& body) { body = layered(w); });
    else if (w[0] == "fem")
        each_body(w[1], [&](Body& body) {
            Ics ics;
            ics.source = IcSource::fem;
            ics.accuracy = number(w[2]);
            body.ics = ics;
        });
    else if (w[0] == "table" && w[1] == "pair")
        setup.bodies.pair = table(w);
    else if (w[0] == "table")
        each_body(w[1], [&](Body& body) { body.ics = table(w); });
    else if (w[0] == "line_contact")
        each_body("both", [&](Body& body) {
            Ics ics;
            ics.line_contact = LineContactSpec{number(w[1])};
            body.ics = ics;
        });
    else if (w[0] == "model")
        setup.model = w[1] == "hertz" ? Model::hertz : w[1] == "fastsim" ? Model::fastsim : Model::full;
    else if (w[0] == "tolerance")
        settings_of(w[1]) = SolverSettings{number(w[2]), std::stoi(w[3])};
    else if (w[0] == "accept_unconverged")
        spec_.accept_unconverged = true;
    else if (w[0] == "lease")
        spec_.lease_seconds = number(w[1]);
    else if (w[0] == "previous")
        spec_.load.previous = {ramp(w, 1), ramp(w, 5), ramp(w, 9)};
    else if (is_of_sections(w[0]))
        each_body(w[1], [&](Body& body) { change_section(body, w); });
    else if (w[0] == "columns" || w[0] == "flat_columns")
        setup.columns = columns(w, setup, client_);
    else
        load(w);
}

void Case::load(const Words& w) {
    ContactLoad& load = spec_.load;
    if (w[0] == "approach" || w[0] == "Fn") {
        load.approach.reset();
        load.Fn.reset();
        (w[0] == "Fn" ? load.Fn : load.approach) = number(w[1]);
    } else if (w[0] == "paraboloid" || w[0] == "semi_axes" || w[0] == "gap" || w[0] == "gap_of") {
        change(gap_);
        if (w[0] == "paraboloid") load.gap = Paraboloid{number(w[1]), number(w[2])};
        if (w[0] == "semi_axes") load.gap = SemiAxes{number(w[1]), number(w[2])};
        if (w[0] == "gap") load.gap = bowl(number(w[1]));
        if (w[0] == "gap_of") load.gap = Numbers(static_cast<std::size_t>(std::stoi(w[1])));
    } else if (w[0] == "mu" || w[0] == "mu_array" || w[0] == "kinetic") {
        change(friction_);
        if (!law_) law_.emplace();
        if (w[0] == "mu") law_->mu = {number(w[1])};
        if (w[0] == "mu_array") law_->mu = ramp(w, 1);
        if (w[0] == "kinetic")
            law_->kinetic =
                KineticFriction{w[1] == "linear" ? SlipLaw::linear : SlipLaw::exponential, number(w[2]), number(w[3])};
    } else if (w[0] == "rigid_slip") {
        change(slip_);
        load.rigid_slip = {ramp(w, 1), ramp(w, 5)};
    } else if (w[0] == "derivatives") {
        load.derivatives = w[1] == "1";
    } else {
        move(w);
    }
}

void Case::move(const Words& w) {
    change(motion_);
    if (w[0] == "shift") {
        rolls_ = false;
        shift_.rigid_shift = {number(w[1]), number(w[2])};
        shift_.rotation = number(w[3]);
    } else if (w[0] == "duration") {
        shift_.duration = number(w[1]);
    } else if (w[0] == "rolling") {
        rolls_ = true;
        rolling_.kind = w[1] == "steady" ? RollingKind::steady : RollingKind::transient;
        rolling_.xi = number(w[2]);
        rolling_.eta = number(w[3]);
        rolling_.phi = number(w[4]);
    } else if (w[0] == "direction") {
        rolling_.chi = number(w[1]);
        rolling_.dq = number(w[2]);
    } else if (w[0] == "spin_offset") {
        rolling_.spin_offset = number(w[1]);
    } else if (w[0] == "rolling_steps") {
        rolling_.steps = std::stoi(w[1]);
    } else if (w[0] == "velocity") {
        rolling_.velocity = number(w[1]);
    } else if (w[0] == "Fx") {
        force_.Fx = number(w[1]);
    } else if (w[0] == "Fy") {
        force_.Fy = number(w[1]);
    } else if (w[0] == "clear_forces") {
        force_ = {};
    } else {
        throw std::runtime_error(name_ + ": there is no " + w[0]);
    }
}

Motion Case::motion() const {
    if (rolls_) {
        Rolling rolling = rolling_;
        rolling.force = force_;
        return rolling;
    }
    Shift shift = shift_;
    shift.force = force_;
    return shift;
}

SessionSpec Case::opening() {
    SessionSpec spec = spec_;
    spec.setup.friction = law_;
    spec.load.motion = motion();
    return spec;
}

StepInput Case::step() const {
    StepInput input;
    input.approach = spec_.load.approach;
    input.Fn = spec_.load.Fn;
    if (gap_) input.gap = spec_.load.gap;
    if (friction_) input.friction = law_;
    if (motion_) input.motion = motion();
    if (slip_) input.rigid_slip = spec_.load.rigid_slip;
    input.derivatives = spec_.load.derivatives;
    input.fields = all_solution_fields;
    return input;
}

void Case::make(const Words& words) {
    if (words[0] == "start") session_ = std::make_unique<client::Session>(client_, opening());
    if (words[0] == "save") saved_[words[1]] = session_->save();
    if (words[0] == "restore") session_->restore(saved_.at(words[1]));
    if (words[0] == "forget") session_->forget(saved_.at(words[1]));
    if (words[0] != "step" && words[0] != "again") return;
    StepInput input = step();
    input.again = words[0] == "again";
    const StepReply reply = session_->step(input);
    Teller().tell(reply, spec_.setup.grid);
}

void Case::call(const Words& words) {
    print_call(name_, words[0], [&] { make(words); });
}

}  // namespace

int main(int arguments, char** argument) {
    return run_cases<Case>(arguments, argument, {"start", "step", "again", "save", "restore", "forget"});
}
