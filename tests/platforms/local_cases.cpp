// Solves contacts and wheels in process, and prints lines of numbers to compare platforms:
//
//     local-cases prints everything that needs no store. local-cases store uses a table by finite elements, which the
//     store of CONTACTD_STORE must contain.
//
// A line is a name, and its numbers with all digits. Lines that begin with "text" are sentences.
#include <contactd.h>

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <initializer_list>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using Inputs = std::vector<std::pair<std::string, double>>;

[[noreturn]] void fail(const std::string& what, const void* handle) {
    std::printf("text FAILED %s: %s\n", what.c_str(), contactd_last_error(handle));
    std::exit(1);
}

void check(std::int32_t code, const std::string& what, const void* handle) {
    if (code != CONTACTD_OK) fail(what, handle);
}

/// Holds a contact after some steps.
class Contact {
   public:
    Contact(contactd_connection* connection, const Inputs& inputs, const std::string& model = "") {
        check(contactd_new(connection, &handle_), "new", connection);
        if (!model.empty()) check(contactd_set_word(handle_, "model", model.c_str()), model, handle_);
        set(inputs);
    }
    ~Contact() { contactd_free(handle_); }
    Contact(const Contact&) = delete;
    Contact& operator=(const Contact&) = delete;

    void set(const Inputs& inputs) {
        for (const auto& [path, value] : inputs) check(contactd_set(handle_, path.c_str(), value), path, handle_);
    }
    void word(const char* path, const char* keyword) {
        check(contactd_set_word(handle_, path, keyword), path, handle_);
    }
    void start() {
        check(contactd_want(handle_, "pressure", 1), "want", handle_);
        check(contactd_want(handle_, "traction_x", 1), "want", handle_);
        check(contactd_start(handle_), "start", handle_);
    }
    std::vector<double> step() {
        check(contactd_step(handle_), "step", handle_);
        std::vector<double> numbers(4);
        check(contactd_get_array(handle_, "forces", numbers.data(), 4), "forces", handle_);
        for (const char* path : {"approach", "pmax", "area.contact", "elements.slip"}) add(numbers, path);
        for (const char* array : {"pressure", "traction_x"}) {
            std::int32_t length = 0;
            check(contactd_length(handle_, array, &length), array, handle_);
            std::vector<double> values(static_cast<std::size_t>(length));
            check(contactd_get_array(handle_, array, values.data(), length), array, handle_);
            double sum = 0, moment = 0;
            for (std::size_t i = 0; i < values.size(); ++i)
                sum += values[i], moment += values[i] * static_cast<double>(i % 17);
            numbers.insert(numbers.end(), {sum, moment});
        }
        return numbers;
    }
    void add(std::vector<double>& numbers, const char* path) {
        double value = 0;
        check(contactd_get(handle_, path, &value), path, handle_);
        numbers.push_back(value);
    }
    contactd_contact* handle() const { return handle_; }

   private:
    contactd_contact* handle_ = nullptr;
};

void print(const std::string& name, const std::vector<double>& numbers) {
    std::printf("%s", name.c_str());
    for (const double number : numbers) std::printf(" %.17g", number);
    std::printf("\n");
}

Inputs with(Inputs inputs, const Inputs& more) {
    inputs.insert(inputs.end(), more.begin(), more.end());
    return inputs;
}

const Inputs steel{{"bodies.upper.G", 82000}, {"bodies.upper.nu", 0.28}};
const Inputs ball{{"gap.paraboloid.Rx", 460}, {"gap.paraboloid.Ry", 300}};

Inputs grid(int n) {
    return {{"grid.nx", n}, {"grid.ny", n}, {"grid.dx", 16.0 / n}, {"grid.dy", 12.0 / n}};
}

/// Solves steady rolling over many creepages, spins and loads, on grids of several sizes.
void steady(contactd_connection* connection) {
    for (const int n : {11, 20, 25}) {
        Contact contact(connection, with(with(with(steel, ball), grid(n)), {{"Fn", 80e3}, {"friction.mu", 0.3}}));
        contact.set({{"friction.rolling.xi", 1e-3}, {"derivatives", 1}});
        contact.start();
        for (const double Fn : {2e4, 8e4})
            for (const double xi : {0.0, 5e-4, 2e-3})
                for (const double eta : {0.0, 1e-3})
                    for (const double phi : {0.0, 3e-4}) {
                        contact.set({{"Fn", Fn}, {"friction.rolling.xi", xi}, {"friction.rolling.eta", eta}});
                        contact.set({{"friction.rolling.phi", phi}});
                        std::vector<double> numbers = contact.step();
                        for (const char* path : {"derivatives.Fx.xi", "derivatives.Fy.eta", "derivatives.approach.Fn"})
                            contact.add(numbers, path);
                        print("steady " + std::to_string(n), numbers);
                    }
    }
}

void other_contacts(contactd_connection* connection) {
    const Inputs rolling{{"Fn", 50e3}, {"friction.mu", 0.3}, {"friction.rolling.xi", 1e-3}};
    for (const char* model : {"hertz", "fastsim", "fastrip", "polach"}) {
        Contact contact(connection, with(with(with(steel, ball), grid(20)), rolling), model);
        if (std::string(model) == "fastsim")
            contact.set({{"friction.rolling.phi", 2e-4}});  // the others need not have spin
        check(contactd_start(contact.handle()), model, contact.handle());
        check(contactd_step(contact.handle()), model, contact.handle());
        std::vector<double> forces(4);
        check(contactd_get_array(contact.handle(), "forces", forces.data(), 4), model, contact.handle());
        print(model, forces);
    }
    {
        Contact contact(connection, with(ball, with(grid(16), {{"approach", 0.03}})));
        contact.word("bodies.upper.ics.source", "analytic");
        contact.word("bodies.upper.ics.body", "layered");
        contact.set({{"bodies.upper.ics.layers[0].thickness", 3}, {"bodies.upper.ics.layers[0].G", 40}});
        contact.set({{"bodies.upper.ics.layers[0].nu", 0.48}, {"bodies.upper.ics.layers[1].thickness", 1}});
        contact.set({{"bodies.upper.ics.layers[1].G", 900}, {"bodies.upper.ics.layers[1].nu", 0.3}});
        contact.set({{"bodies.upper.ics.base.G", 82000}, {"bodies.upper.ics.base.nu", 0.28}});
        contact.set({{"bodies.lower.rigid", 1}});
        contact.start();
        print("layered", contact.step());
    }
    {
        Contact contact(connection, with(with(with(steel, ball), grid(16)), {{"Fn", 4e4}, {"friction.mu", 0.3}}));
        contact.word("ics.load_shape", "bilinear");
        contact.set({{"friction.rolling.xi", 1e-3}});
        contact.start();
        print("bilinear", contact.step());
    }
    {
        Contact contact(connection, with(with(with(steel, ball), grid(20)), {{"Fn", 4e4}, {"friction.mu", 0.4}}));
        contact.set({{"friction.rigid_shift.x", 0.004}, {"friction.rigid_shift.y", -0.002}});
        contact.start();
        for (int step = 0; step < 4; ++step) print("shift", contact.step());
    }
    {
        Contact contact(connection, with(with(with(steel, ball), grid(20)), {{"Fn", 6e4}, {"friction.mu", 0.3}}));
        contact.word("friction.rolling.kind", "transient");
        contact.set({{"friction.rolling.xi", 2e-3}, {"friction.rolling.dq", 0.8}});
        contact.start();
        for (int step = 0; step < 8; ++step) print("transient", contact.step());
    }
}

void wheels(contactd_connection* connection) {
    for (const char* side : {"left", "right"}) {
        contactd_wheel* wheel = nullptr;
        check(contactd_wheel_new(connection, &wheel), side, connection);
        check(contactd_set_word(wheel, "setup.side", side), side, wheel);
        for (const auto& [path, value] : Inputs{{"setup.dx", 0.5},
                                                {"setup.dy", 0.5},
                                                {"state.velocity.x", 20e3},
                                                {"state.velocity.pitch", -20e3 / 460},
                                                {"state.Fz", 80e3}})
            check(contactd_set(wheel, path.c_str(), value), path, wheel);
        for (int y = 0; y <= 6; ++y) {
            check(contactd_set(wheel, "state.position.y", y), side, wheel);
            check(contactd_set(wheel, "state.position.yaw", 2.4e-3 * y), side, wheel);
            check(contactd_wheel_solve(wheel), side, wheel);
            std::vector<double> numbers(6);
            double z = 0, patches = 0;
            check(contactd_get_array(wheel, "forces.track", numbers.data(), 6), side, wheel);
            check(contactd_get(wheel, "z", &z), side, wheel);
            check(contactd_get(wheel, "patches", &patches), side, wheel);
            numbers.insert(numbers.end(), {z, patches});
            print(std::string("wheel ") + side, numbers);
        }
        contactd_wheel_free(wheel);
    }
}

/// Four simultaneous threads, each with its own contact, must have the same bits as a single one.
void threads(contactd_connection* connection) {
    const auto solve = [connection](std::vector<double>& numbers) {
        Contact contact(connection, with(with(with(steel, ball), grid(20)), {{"Fn", 6e4}, {"friction.mu", 0.3}}));
        contact.set({{"friction.rolling.xi", 1e-3}});
        contact.start();
        for (int step = 0; step < 3; ++step) numbers = contact.step();
    };
    std::vector<double> alone;
    solve(alone);
    std::vector<std::vector<double>> found(4);
    {
        std::vector<std::jthread> running;
        for (auto& numbers : found) running.emplace_back([&] { solve(numbers); });
    }
    for (const auto& numbers : found) std::printf("text threads %s\n", numbers == alone ? "agree" : "DIFFER");
}

void refusals(contactd_connection* connection) {
    Contact contact(connection, grid(8));
    std::printf("text %d", contactd_set(contact.handle(), "bodies.upper.nu", 0.3));
    std::printf(" %d", contactd_set(contact.handle(), "Fn", -1));
    std::printf(" %s", contactd_last_error(contact.handle()));
    std::printf(" %d", contactd_set(contact.handle(), "grid.nz", 1));
    std::printf(" %s\n", contactd_last_field(contact.handle()));
}

/// Solves a contact with coefficients by finite elements: 10 x 10 offsets of a paper's block, from the store.
void from_store(contactd_connection* connection) {
    Contact contact(connection, with(steel, {{"grid.nx", 8}, {"grid.ny", 8}, {"grid.dx", 0.8}, {"grid.dy", 0.8}}));
    contact.set({{"gap.paraboloid.Rx", 50}, {"gap.paraboloid.Ry", 50}, {"approach", 0.05}});
    contact.word("ics.source", "fem");
    contact.set({{"ics.accuracy", 0.01}});
    contact.start();
    print("finite elements", contact.step());
    char origin[32];
    check(contactd_get_word(contact.handle(), "ics.upper.origin", origin, sizeof origin), "origin", contact.handle());
    std::printf("text origin %s\n", origin);
}

}  // namespace

int main(int count, char** arguments) {
    contactd_connection* connection = nullptr;
    check(contactd_open("local", &connection), "open", nullptr);
    if (count > 1 && std::string(arguments[1]) == "store") {
        from_store(connection);
    } else {
        steady(connection);
        other_contacts(connection);
        wheels(connection);
        threads(connection);
        refusals(connection);
    }
    contactd_close(connection);
    return 0;
}
