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

// Thresholds of the warnings, from the tables of docs/contact.md (bench/discretisation.py). At 8 elements across an
// ellipse, the error of the force is at most 0.7 %, and that of pmax at most 1.3 %.
constexpr int fewest_elements = 8;
constexpr double longest_step = 3;      // elements along the rolling direction
constexpr double longest_part = 0.1;    // fraction of the contact's length there
constexpr double rounding = 1e-9;       // relative, of lengths
constexpr double certain_error = 1;     // upper limit of the estimates
constexpr double force_factor = 0.4;    // divided by the square of the elements across minus one
constexpr double pmax_factor = 0.8;     // divided by the same square
constexpr double rolling_factor = 0.8;  // times dq and the element size, relative to the size of the contact

/// Holds the number of elements in the longest unbroken row and column: the size of one contact, even if there are
/// several.
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

// A contact that extends from border to border, such as a line contact, does not count in that direction.
int elements_across(const Grid& grid, const ContactSize& size) {
    const bool ends_x = size.along_x < grid.nx, ends_y = size.along_y < grid.ny;
    if (ends_x && ends_y) return std::min(size.along_x, size.along_y);
    if (ends_x) return size.along_x;
    if (ends_y) return size.along_y;
    return std::max(size.along_x, size.along_y);
}

/// Returns the lengths of the contact, with 0 for an unknown length where the contact fills the grid.
PatchSize lengths_of(const Grid& grid, const ContactSize& size) {
    return {size.along_x < grid.nx ? size.along_x * grid.dx : 0, size.along_y < grid.ny ? size.along_y * grid.dy : 0};
}

const Rolling* rolling_of(const ContactSolution& solution) {
    return solution.motion ? std::get_if<Rolling>(&*solution.motion) : nullptr;
}

/// Holds lengths along the rolling direction (mm).
struct RollingLengths {
    double step, element, contact;

    RollingLengths(const Rolling& rolling, const Grid& grid, const ContactSize& size)
        : step(step_length(rolling, grid)),
          element(size_along(rolling.chi, grid.dx, grid.dy)),
          contact(size_along(rolling.chi, size.along_x * grid.dx, size.along_y * grid.dy)) {}
};

// Returns the error of the force at a small creepage, where all elements adhere.
double rolling_error(const RollingLengths& along, int across) {
    return rolling_factor * (1.0 / across + along.step / along.contact);
}

bool are_half_spaces(const Bodies& bodies) {
    if (bodies.any_given()) return false;
    for (const Body* body : {&bodies.upper, &bodies.lower})
        if (const Ics* ics = body->computed(); ics != nullptr && ics->body != BodyShape::half_space) return false;
    return true;
}

/// Returns Hertz's contact at the approach of the solution, or nothing where Hertz's theory does not hold.
std::optional<HertzContact> hertz_of(const ContactProblem& problem, const ContactSolution& solution, bool coupled) {
    if (!are_half_spaces(problem.bodies) || problem.bodies.any_viscoelastic() || coupled ||
        solution.elements.border > 0 || !(solution.approach > 0))
        return {};
    const auto paraboloid = paraboloid_of(problem);
    const auto is_curved = [](double radius) { return radius > 0 && std::isfinite(radius); };
    if (!paraboloid || !is_curved(paraboloid->Rx) || !is_curved(paraboloid->Ry)) return {};
    const HertzContact hertz =
        hertz_of_approach(*paraboloid, problem.bodies.materials().normal_compliance(), solution.approach);
    if (!(hertz.Fn > 0 && hertz.pmax > 0)) return {};  // Both underflow for tiny approaches.
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
        (has_origin ? "the contact is narrower than the elements." : "it lies outside the potential contact area.") +
        " All forces of this solution are zero.");
}

/// Users choose the grid for the contact that they expect. If the contact is far smaller along both axes, a load, a
/// radius or a modulus is probably in another unit. Rough surfaces have many small contacts with more elements in
/// total.
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
                       ". The error of the normal force for the approach is " + about + percent(evidence.force_error) +
                       ", and that of the largest pressure is " + about + percent(evidence.pmax_error) +
                       ". Use smaller elements." +
                       (is_lost_on(problem.grid, solution)
                            ? " The contact is much smaller than the potential contact area along both axes. Check the "
                              "units of forces, lengths and moduli."
                            : ""));
}

/// Warns of a rough surface whose typical contact has too few elements, even if one contact is large.
void warn_of_small_contacts(const ContactProblem& problem, const ContactSolution& solution,
                            std::vector<std::string>& warnings) {
    constexpr std::size_t many = 10, fewest = 9;
    if (!problem.gap || !std::holds_alternative<std::vector<double>>(*problem.gap)) return;
    if (solution.evidence.discretisation->elements_across < fewest_elements) return;
    const SeparateContacts contacts = separate_contacts(problem.grid, solution.pressure);
    if (contacts.count < many || contacts.typical >= fewest) return;
    warnings.push_back("The gap produces " + std::to_string(contacts.count) +
                       " separate contacts, most of them with at most " + std::to_string(contacts.typical) +
                       (contacts.typical == 1 ? " element" : " elements") +
                       ". The pressure of a contact requires at least 3 by 3 elements. Give heights at shorter "
                       "distances, with smaller elements.");
}

void warn_of_long_step(const ContactProblem& problem, const ContactSolution& solution,
                       std::vector<std::string>& warnings) {
    const Rolling* rolling = rolling_of(solution);
    if (rolling == nullptr) return;
    const RollingLengths along(*rolling, problem.grid, contact_size(problem.grid, solution.pressure));
    const double step = along.step * (1 + rounding);
    // The default step is the size of an element, so the warning about few elements covers it.
    if (along.step <= along.element * (1 + rounding)) return;
    if (step < longest_step * along.element && step < longest_part * along.contact) return;
    const double error = *solution.evidence.discretisation->rolling_error;
    warnings.push_back(
        "friction.rolling.dq is " + number_text(along.step) + " mm, " + short_text(along.step / along.element) +
        " elements and " + short_text(along.step / along.contact) +
        " of the contact's length along the rolling direction. The error of the tangential force at small creepages "
        "is about " +
        percent(error) + ". Omit dq to use the size of an element, " + short_text(along.element) +
        " mm. Divide a longer time step into several steps of transient rolling.");
}

}  // namespace

std::optional<Discretisation> discretisation(const ContactProblem& problem, const ContactSolution& solution,
                                             bool coupled) {
    if (solution.elements.contact == 0) return {};
    const ContactSize size = contact_size(problem.grid, solution.pressure);
    Discretisation evidence;
    evidence.elements_across = elements_across(problem.grid, size);
    if (const auto hertz = hertz_of(problem, solution, coupled)) {
        // A prescribed force determines pmax, even though the solve found the approach.
        const double compliance = problem.bodies.materials().normal_compliance();
        const double pmax =
            problem.Fn ? hertz_of_force(*paraboloid_of(problem), compliance, *problem.Fn).pmax : hertz->pmax;
        evidence.source = ErrorSource::hertz;
        evidence.force_error = std::abs(solution.forces.Fn / hertz->Fn - 1);
        evidence.pmax_error = std::abs(solution.pmax / pmax - 1);
    } else {
        // One less, because a coarse grid cannot resolve one element more or less in contact.
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
