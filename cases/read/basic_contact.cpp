// Reads module 3: two bodies on a grid.
#include <array>
#include <string>

#include "steps.hpp"

namespace contactd::contact_files {
namespace {

std::string load(const Reading& reading) {
    const int force = reading.digit("F");
    return std::string(reading.digit("N") == 0 ? "PEN " : "FN ") + (force == 0 ? "CKSI " : "FX ") +
           (force == 2 ? "FY" : "CETA") + " CPHI {+SPINXO=0 SPINYO=0}";
}

void read_friction_of_all(Reading& reading) {
    if (reading.digit("V") == 0) read_friction(reading);
}

void read_friction_of_rows(Reading& reading) {
    if (reading.digit("V") == 3) read_friction(reading);
}

std::string rolling_step(const Reading& reading) {
    return reading.digit("C") >= 2 && reading.digit("T") >= 2 ? "CHI^ DQ VELOC {FACPHI=0.16666666666666666}" : "";
}

void read_angles(Reading& reading) {
    if (reading.digit("C") != 4) return;
    const ByName<ContactValue> head = read_values(reading, "IF_METH# VARIANT# NN#");
    const int rows = std::get<int>(head.at("NN"));
    if (rows < 1)
        reading.lines.fail(reading.lines.words().front(), "has NN = " + std::to_string(rows) +
                                                              "; the number of pairs of y and angle must be positive");
    for (const char* name : {"IF_METH", "VARIANT"}) reading.take(name, head.at(name));
    const auto pairs = read_array(reading, "y, angle", 2 * static_cast<std::size_t>(rows), " ^");
    reading.take("ANGLE_Y", shared(column_of(pairs, 0, 2)));
    reading.take("ANGLE", shared(column_of(pairs, 1, 2)));
}

std::string coefficients_file(const Reading& reading) {
    return reading.digit("C") == 9 ? "CFNAME'" : "";
}

void read_extra_slip(Reading& reading) {
    if (reading.digit("E") != 9) return;
    const auto elements = static_cast<std::size_t>(reading.integer("MX")) * reading.integer("MY");
    if (elements == 0)
        reading.lines.fail_line("requires MX and MY before the extra rigid slip of each element (E = 9)");
    const std::vector<double> pairs = read_array(reading, "the extra rigid slip x, y", 2 * elements);
    reading.take("SLIP_X", shared(column_of(pairs, 0, 2)));
    reading.take("SLIP_Y", shared(column_of(pairs, 1, 2)));
}

constexpr std::array steps_of_basic_contact{
    Step{.group = solver_bounds},
    Step{.group = solver_options, .replaces = solver_option_names},
    Step{.group = load, .replaces = "PEN FN CKSI FX CETA FY"},
    Step{.read = read_friction_of_all},
    Step{.group = rolling_step, .replaces = "FACPHI"},
    Step{.read = read_angles},
    Step{.group = coefficients_file},
    Step{.group = elastic_constants},
    Step{.group = thin_sheet},
    Step{.group = material_constants},
    Step{.group = damping},
    Step{.group = heat_of_first},
    Step{.group = heat_of_second},
    Step{.group = plastic_heat},
    Step{.read = read_grid},
    Step{.read = read_gap},
    Step{.read = read_friction_of_rows},
    Step{.read = read_extra_slip},
    Step{.read = read_subsurface},
};

}  // namespace

std::span<const Step> steps_alone() {
    return steps_of_basic_contact;
}

}  // namespace contactd::contact_files
