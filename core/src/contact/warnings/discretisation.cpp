#include "discretisation.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#include "closed_forms/hertz.hpp"
#include "closed_forms/undeformed_distance.hpp"
#include "layer_resolution.hpp"
#include "separate_contacts.hpp"
#include "types/number_text.hpp"

namespace contactd {
namespace {

// Where warnings begin, by the tables of docs/contact.md (bench/discretisation.py). At 8 elements across the force of
// an ellipse is off by up to 0.7 % and pmax by up to 1.3 %.
constexpr int fewest_elements = 8;
constexpr double longest_step = 3;      // elements along the rolling direction
constexpr double longest_part = 0.1;    // of the contact's length there
constexpr double rounding = 1e-9;       // relative, of lengths
constexpr double certain_error = 1;     // where nothing is known any more
constexpr double force_factor = 0.4;    // over the square of the elements across, less one
constexpr double pmax_factor = 0.8;     // the same
constexpr double rolling_factor = 0.8;  // of dq and of an element over the size of the contact

/// Elements in the longest unbroken row and column of the contact: its own size, however many contacts there are.
struct ContactSize {
    int along_x = 0, along_y = 0;
};

int longest_run(std::span<const double> pressure, std::size_t lines, std::size_t line_step, std::size_t length,
                std::size_t step) {
    int longest = 0;
    for (std::size_t line = 0; line < lines; ++line) {
        int run = 0;
        for (std::size_t k = 0; k < length; ++k) {
            run = pressure[line * line_step + k * step] > 0 ? run + 1 : 0;
            longest = std::max(longest, run);
        }
    }
    return longest;
}

ContactSize contact_size(const Grid& grid, std::span<const double> pressure) {
    const auto nx = static_cast<std::size_t>(grid.nx), ny = static_cast<std::size_t>(grid.ny);
    return {longest_run(pressure, ny, nx, nx, 1), longest_run(pressure, nx, 1, ny, nx)};
}

// A contact that reaches from border to border, as line contacts do, says nothing of the elements in that direction.
int elements_across(const Grid& grid, const ContactSize& size) {
    const bool ends_x = size.along_x < grid.nx, ends_y = size.along_y < grid.ny;
    if (ends_x && ends_y) return std::min(size.along_x, size.along_y);
    if (ends_x) return size.along_x;
    if (ends_y) return size.along_y;
    return std::max(size.along_x, size.along_y);
}

/// A length is 0, for unknown, in a direction in which the contact fills the grid.
PatchSize lengths_of(const Grid& grid, const ContactSize& size) {
    return {size.along_x < grid.nx ? size.along_x * grid.dx : 0, size.along_y < grid.ny ? size.along_y * grid.dy : 0};
}

const Rolling* rolling_of(const ContactSolution& solution) {
    return solution.motion ? std::get_if<Rolling>(&*solution.motion) : nullptr;
}

/// Along the rolling direction (mm).
struct RollingLengths {
    double step, element, contact;

    RollingLengths(const Rolling& rolling, const Grid& grid, const ContactSize& size)
        : step(step_length(rolling, grid)),
          element(size_along(rolling.chi, grid.dx, grid.dy)),
          contact(size_along(rolling.chi, size.along_x * grid.dx, size.along_y * grid.dy)) {}
};

// Returns the error of the force under a small creepage, where everything adheres.
double rolling_error(const RollingLengths& along, int across) {
    return rolling_factor * (1.0 / across + along.step / along.contact);
}

bool are_half_spaces(const Bodies& bodies) {
    if (bodies.any_given()) return false;
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->body != BodyShape::half_space) return false;
    return true;
}

/// The whole ellipse under the approach of the solution, where Hertz's theory holds.
std::optional<HertzContact> hertz_of(const ContactProblem& problem, const ContactSolution& solution, bool coupled) {
    if (!are_half_spaces(problem.bodies) || problem.bodies.any_viscoelastic() || coupled ||
        solution.elements.border > 0 || !(solution.approach > 0))
        return {};
    const auto paraboloid = paraboloid_of(problem);
    const auto is_curved = [](double radius) { return radius > 0 && std::isfinite(radius); };
    if (!paraboloid || !is_curved(paraboloid->Rx) || !is_curved(paraboloid->Ry)) return {};
    const HertzContact hertz =
        hertz_of_approach(*paraboloid, problem.bodies.materials().normal_compliance(), solution.approach);
    if (!(hertz.Fn > 0 && hertz.pmax > 0)) return {};  // they underflow
    return hertz;
}

std::string percent(double part) {
    if (part > 10) return "more than 1000 %";
    char text[32];
    std::snprintf(text, sizeof text, part < 0.1 ? "%.2g %%" : "%.0f %%", 100 * part);
    return text;
}

void warn_of_missed_contact(const ContactProblem& problem, const ContactSolution& solution,
                            std::vector<std::string>& warnings) {
    if (solution.elements.contact > 0 || problem.Fn || !(solution.approach > 0) || !paraboloid_of(problem)) return;
    const Grid& grid = problem.grid;
    const bool has_origin =
        grid.x0 <= 0 && grid.y0 <= 0 && grid.x0 + grid.nx * grid.dx >= 0 && grid.y0 + grid.ny * grid.dy >= 0;
    warnings.push_back(
        "The bodies overlap by " + number_text(solution.approach) +
        " mm at the origin, but no element has its centre in the contact: " +
        (has_origin ? "the contact is narrower than the elements." : "it lies beyond the potential contact area.") +
        " This solution carries nothing.");
}

/// Grids are chosen for the contact that is expected: one that is far smaller on both sides has a load, a radius or a
/// modulus in another unit. Rough surfaces have many small contacts, and together more elements.
bool is_lost_on(const Grid& grid, const ContactSolution& solution) {
    constexpr int part = 8;
    const ContactSize size = contact_size(grid, solution.pressure);
    return size.along_x * part <= grid.nx && size.along_y * part <= grid.ny &&
           static_cast<double>(solution.elements.contact) * part * part <= static_cast<double>(grid.size());
}

void warn_of_few_elements(const ContactProblem& problem, const ContactSolution& solution,
                          std::vector<std::string>& warnings) {
    const Discretisation& evidence = *solution.evidence.discretisation;
    const int across = evidence.elements_across;
    if (across >= fewest_elements) return;
    const char* about = evidence.source == ErrorSource::hertz ? "" : "up to about ";
    warnings.push_back("The contact is " + std::to_string(across) + (across == 1 ? " element" : " elements") +
                       " across, fewer than " + std::to_string(fewest_elements) +
                       ": the normal force for the approach is off by " + about + percent(evidence.force_error) +
                       " and the largest pressure by " + percent(evidence.pmax_error) +
                       "; smaller elements are better." +
                       (is_lost_on(problem.grid, solution)
                            ? " The contact is a small part of the potential contact area on both sides: check the "
                              "units of forces, lengths and moduli."
                            : ""));
}

/// The heights of a rough surface are too thin where most of its contacts are an element or two, however large one is.
void warn_of_small_contacts(const ContactProblem& problem, const ContactSolution& solution,
                            std::vector<std::string>& warnings) {
    constexpr std::size_t many = 10, fewest = 9;
    if (!problem.gap || !std::holds_alternative<std::vector<double>>(*problem.gap)) return;
    if (solution.evidence.discretisation->elements_across < fewest_elements) return;
    const SeparateContacts contacts = separate_contacts(problem.grid, solution.pressure);
    if (contacts.count < many || contacts.typical >= fewest) return;
    warnings.push_back("The gap makes " + std::to_string(contacts.count) + " separate contacts, most of them of " +
                       std::to_string(contacts.typical) + (contacts.typical == 1 ? " element" : " elements") +
                       " or fewer, where 3 by 3 are the least that tells their pressures: give heights at shorter "
                       "distances, with smaller elements.");
}

void warn_of_long_step(const ContactProblem& problem, const ContactSolution& solution,
                       std::vector<std::string>& warnings) {
    const Rolling* rolling = rolling_of(solution);
    if (rolling == nullptr) return;
    const RollingLengths along(*rolling, problem.grid, contact_size(problem.grid, solution.pressure));
    const double step = along.step * (1 + rounding);
    // Not of the default, which the grid is to blame for.
    if (along.step <= along.element * (1 + rounding)) return;
    if (step < longest_step * along.element && step < longest_part * along.contact) return;
    const double error = *solution.evidence.discretisation->rolling_error;
    warnings.push_back(
        "friction.rolling.dq is " + number_text(along.step) + " mm, " + short_text(along.step / along.element) +
        " elements and " + short_text(along.step / along.contact) +
        " of the contact's length along the rolling direction: the tangential force under small "
        "creepages is off by about " +
        percent(error) + ". Leave it out, which takes the size of an element, " + short_text(along.element) +
        " mm; what a time step rolls takes several steps of transient rolling.");
}

}  // namespace

std::optional<Discretisation> discretisation(const ContactProblem& problem, const ContactSolution& solution,
                                             bool coupled) {
    if (solution.elements.contact == 0) return {};
    const ContactSize size = contact_size(problem.grid, solution.pressure);
    Discretisation evidence;
    evidence.elements_across = elements_across(problem.grid, size);
    if (const auto hertz = hertz_of(problem, solution, coupled)) {
        // Under the prescribed load, of which the approach may have been found.
        const double compliance = problem.bodies.materials().normal_compliance();
        const double pmax =
            problem.Fn ? hertz_of_force(*paraboloid_of(problem), compliance, *problem.Fn).pmax : hertz->pmax;
        evidence.source = ErrorSource::hertz;
        evidence.force_error = std::abs(solution.forces.Fn / hertz->Fn - 1);
        evidence.pmax_error = std::abs(solution.pmax / pmax - 1);
    } else {
        // One less, because an element more or less in contact is not felt by a coarse grid.
        const double intervals = std::max(evidence.elements_across - 1, 0);
        const auto error = [&](double factor) { return std::min(factor / (intervals * intervals), certain_error); };
        evidence.force_error = error(force_factor);
        evidence.pmax_error = error(pmax_factor);
    }
    const PatchSize contact = lengths_of(problem.grid, size);
    require_layers_resolved(problem, contact);
    if ((evidence.compliance_ratio = compliance_ratio(problem, contact))) {
        const double of_layers = compliance_error(*evidence.compliance_ratio);
        for (double* error : {&evidence.force_error, &evidence.pmax_error})
            *error = std::min(*error + of_layers, certain_error);
    }
    if (const Rolling* rolling = rolling_of(solution))
        evidence.rolling_error = rolling_error({*rolling, problem.grid, size}, evidence.elements_across);
    return evidence;
}

std::vector<std::string> discretisation_warnings(const ContactProblem& problem, const ContactSolution& solution) {
    std::vector<std::string> warnings;
    warn_of_missed_contact(problem, solution, warnings);
    if (!solution.evidence.discretisation) return warnings;
    warn_of_few_elements(problem, solution, warnings);
    warn_of_small_contacts(problem, solution, warnings);
    warn_of_long_step(problem, solution, warnings);
    const PatchSize contact = lengths_of(problem.grid, contact_size(problem.grid, solution.pressure));
    if (auto warning = layer_warning(problem, contact)) warnings.push_back(std::move(*warning));
    return warnings;
}

}  // namespace contactd
