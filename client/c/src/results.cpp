#include "results.hpp"

#include <array>
#include <optional>

#include "contactd/fields/ic_reply.hpp"
#include "contactd/fields/wheel_rail_solution.hpp"
#include "field_types.hpp"

namespace contactd::c {
namespace {

using fields::field;

/// These are available from the start of a contact.
struct ContactFacts {
    const IcUses* ics;
    int step = 0;
};

const FieldType& type_of_facts() {
    static const std::array list = [] {
        Field ics{"ics", &type_of<IcUses>, {}, {}, {}};
        ics.find = [](const void* facts) -> const void* { return static_cast<const ContactFacts*>(facts)->ics; };
        return std::array{field<&ContactFacts::step>("step"), ics};
    }();
    static const FieldType type = fields::object_type(list);
    return type;
}

/// These follow from a solution, or from the search for the roll.
struct ContactTotals {
    bool converged = false;
};

const FieldType& type_of_contact_totals() {
    static const std::array list{field<&ContactTotals::converged>("converged")};
    static const FieldType type = fields::object_type(list);
    return type;
}

struct WheelTotals {
    bool converged = false;
    std::optional<double> frictional_power{};
    double roll = 0;
    std::optional<SolverEvidence> roll_search{};
};

const FieldType& type_of_wheel_totals() {
    static const std::array list{field<&WheelTotals::converged>("converged"),
                                 field<&WheelTotals::frictional_power>("frictional_power"),
                                 field<&WheelTotals::roll>("roll"), field<&WheelTotals::roll_search>("roll_search")};
    static const FieldType type = fields::object_type(list);
    return type;
}

}  // namespace

Roots results_of_contacts() {
    static const std::array roots{&type_of_facts(), &type_of_contact_totals(), &type_of_solution()};
    return roots;
}

Roots results_of_wheels() {
    static const std::array roots{&type_of_wheel_totals(), &type_of<WheelRailSolution>()};
    return roots;
}

void read_result(const Contact& contact, const RootedPath& path, const ReadResult& read) {
    if (path.root == &type_of_facts()) {
        const ContactFacts facts{&contact.ics(), contact.step_number()};
        return read(path.path, &facts);
    }
    const ContactSolution& solution = contact.result().reply.solution;
    const ContactTotals totals{solution.converged()};
    read(path.path, path.root == &type_of_contact_totals() ? static_cast<const void*>(&totals) : &solution);
}

void read_result(const Wheel& wheel, const RootedPath& path, const ReadResult& read) {
    const WheelRailSolution& solution = wheel.solution();
    if (path.root != &type_of_wheel_totals()) return read(path.path, &solution);
    const WheelTotals totals{wheel.converged(), solution.frictional_power(), wheel.roll(), wheel.roll_search()};
    read(path.path, &totals);
}

}  // namespace contactd::c
