#include "case_run.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "answers/printed.hpp"
#include "answers/rail_patch.hpp"
#include "answers/stress_blocks.hpp"
#include "given/file_values.hpp"
#include "given/given_friction.hpp"
#include "given/mistakes.hpp"
#include "given/not_covered.hpp"
#include "problem/case_models.hpp"
#include "problem/problem.hpp"
#include "problem/rail_setup.hpp"
#include "run/basic_history.hpp"
#include "run/names_in_files.hpp"

namespace contactd::cases {
namespace {

constexpr int on_rails = 1;

int digit(const ContactCase& read, const char* name) {
    const auto found = read.digits.find(name);
    return found == read.digits.end() ? 0 : found->second;
}

/// Returns whether a case starts from the end of an earlier one. A case without digits could not be read.
bool goes_on(const ContactCase& read) {
    constexpr int anew = 2, shift = 1, transient = 2;
    const int tangential = digit(read, "T");
    return digit(read, "P") != anew && (tangential == shift || tangential == transient);
}

std::string joined(const std::vector<std::string>& sentences, const char* end) {
    std::string all;
    for (const std::string& sentence : sentences) all += (all.empty() ? "" : "; ") + sentence;
    return all + end;
}

ContactFileOutcome outcome_of(const ContactCase& read) {
    ContactFileOutcome outcome;
    outcome.number = read.number;
    outcome.line = read.line;
    outcome.module_number = read.module_number;
    outcome.reid = read.reid;
    outcome.cpid = read.cpid;
    outcome.status = ContactFileStatus::read;
    return outcome;
}

/// Calls `work` and makes its exceptions the outcome of the case. Throws Cancelled.
template <class Work>
void take_errors(ContactFileOutcome& outcome, const Work& work) {
    const auto end = [&](ContactFileStatus status, std::string sentence) {
        outcome.status = status;
        outcome.sentence = std::move(sentence);
    };
    try {
        work();
    } catch (const Cancelled&) {
        throw;
    } catch (const NotCovered& error) {
        const bool is_of_file = error.subject() == Subject::file || error.subject() == Subject::coefficients;
        end(is_of_file ? ContactFileStatus::wrong : ContactFileStatus::refused, error.what());
    } catch (const InvalidArgument& error) {
        end(ContactFileStatus::refused, in_names_of_files(error, outcome.module_number));
    } catch (const Error& error) {
        end(ContactFileStatus::failed, error.what());
    }
}

void set_status(ContactFileOutcome& outcome, bool converged) {
    outcome.status = converged ? ContactFileStatus::solved : ContactFileStatus::not_converged;
    if (!converged) outcome.sentence = "A solver or a search missed its tolerance.";
}

bool converged(const ContactEvidence& evidence) {
    for (const auto& solver : {evidence.tangential, evidence.outer, evidence.force})
        if (solver && !solver->converged) return false;
    return evidence.normal.converged;
}

/// Returns a block of a file without the elements beyond the grid, which a patch or an earlier case may have had.
GivenBlock on_grid(GivenBlock block, const Grid& grid) {
    constexpr int listed_elements = 7;
    if (block.kind != listed_elements) return block;
    std::erase_if(block.x, [&](double ix) { return ix < 1 || ix > grid.nx; });
    std::erase_if(block.y, [&](double iy) { return iy < 1 || iy > grid.ny; });
    return block;
}

/// Returns the blocks below a contact. `left` is the number of points that the case may still have. Throws NotCovered.
std::vector<ContactFileBlock> blocks_below(const std::vector<GivenBlock>& given, const Solved& solved,
                                           std::size_t& left, Observer& observer) {
    std::vector<ContactFileBlock> blocks;
    for (const GivenBlock& one : given) {
        const GivenBlock on_it = on_grid(one, solved.problem.grid);
        const std::size_t points = block_points(on_it, solved.problem.grid).size();
        if (points > left)
            throw NotCovered(
                Subject::input,
                "A block has " + std::to_string(points) + " subsurface points, but " + std::to_string(left) +
                    " remain for the case. It may have ten times max_elements points, and 1000000 at most.");
        left -= points;
        SolvedBlock block = solve_block(on_it, solved, observer);
        blocks.push_back({std::move(block.points), std::move(block.displacement), std::move(block.stress)});
    }
    return blocks;
}

std::vector<GivenBlock> requested_blocks(const ContactCase& read) {
    return digit(read, "S") >= 1 ? blocks_of(read) : std::vector<GivenBlock>();
}

/// Lets the run ask an observer until the end of a call.
class WhileAsked {
   public:
    WhileAsked(const Observer*& now, const Observer& observer) : now_(now) { now_ = &observer; }
    ~WhileAsked() { now_ = nullptr; }
    WhileAsked(const WhileAsked&) = delete;
    WhileAsked& operator=(const WhileAsked&) = delete;

   private:
    const Observer*& now_;
};

void add_warning(ContactFileOutcome& outcome, std::string sentence) {
    if (!sentence.empty()) outcome.warnings.push_back(std::move(sentence));
}

}  // namespace

CaseRun::CaseRun(ContactFileInput input)
    : input_(std::move(input)), files_(input_.files), reader_(input_.text, input_.name, &asked_) {
    for (const NamedFile& file : input_.files) file_bytes_ += file.name.size() + file.text.size();
    input_.files.clear();
}

std::optional<ContactCase> CaseRun::read_next() {
    std::optional<ContactCase> read;
    while (input_.cases.empty() || wanted_ < input_.cases.size()) {
        read = reader_.next();
        if (!read) break;
        const bool is_wanted = input_.cases.empty() || input_.cases[wanted_] == at_;
        ++at_;
        if (is_wanted) {
            ++wanted_;
            break;
        }
        histories_[{read->module_number, read->reid, read->cpid}].broken =
            "It continues case " + std::to_string(read->number) + " in line " + std::to_string(read->line) +
            ", which was not requested.";
        read.reset();
    }
    return read;
}

void CaseRun::refuse_early(const ContactCase& read, const History& history, ContactFileOutcome& outcome) const {
    const auto end = [&](ContactFileStatus status, std::string sentence) {
        outcome.status = status;
        outcome.sentence = std::move(sentence);
    };
    if (!read.errors.empty()) return end(ContactFileStatus::wrong, joined(read.errors, ""));
    if (const auto found = mistakes(read); !found.empty()) return end(ContactFileStatus::wrong, joined(found, "."));
    if (read.module_number != on_rails) {
        const auto count =
            static_cast<double>(std::get<int>(read.values.at("MX"))) * std::get<int>(read.values.at("MY"));
        if (count > static_cast<double>(input_.max_elements))
            return end(ContactFileStatus::refused, "MX MY is " + std::to_string(static_cast<long long>(count)) +
                                                       " elements; at most " + std::to_string(input_.max_elements) +
                                                       " are accepted.");
    }
    if (goes_on(read) && !history.broken.empty()) return end(ContactFileStatus::follows, history.broken);
}

std::optional<ContactFileOutcome> CaseRun::next(ProblemSolver& solver, const Observer& observer) {
    const WhileAsked asks(asked_.now, observer);
    const std::optional<ContactCase> read = read_next();
    if (!read) return {};
    ContactFileOutcome outcome = outcome_of(*read);
    History& history = histories_[{read->module_number, read->reid, read->cpid}];
    if (!goes_on(*read)) history = {};  // so that its answer does not depend on other cases
    refuse_early(*read, history, outcome);
    constexpr int only_read = 2;
    if (outcome.status == ContactFileStatus::read) {
        if (digit(*read, "R") >= only_read) {
            outcome.sentence = "It is read but not computed (R = 2, 3).";
            return outcome;
        }
        const auto began = std::chrono::steady_clock::now();
        take_errors(outcome, [&] { solve(*read, history, solver, outcome); });
        outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    }
    if (!outcome.is_solved() && history.broken.empty())
        history.broken = "It continues case " + std::to_string(read->number) + " in line " +
                         std::to_string(read->line) + ", which is not computed.";
    return outcome;
}

void CaseRun::solve(const ContactCase& read, History& history, ProblemSolver& solver, ContactFileOutcome& outcome) {
    if (read.module_number == on_rails)
        solve_on_rails(read, history, solver, outcome);
    else
        solve_basic(read, history, solver, outcome);
}

ContactProblem CaseRun::basic_problem(const ContactCase& read, Given& given, const Solved* last,
                                      ProblemSolver& solver) const {
    set_basic_case(given, read, files_);
    std::optional<LastCase> before;
    if (last != nullptr) before.emplace(LastCase{last->problem, last->solution});
    return problem_of(given, before ? &*before : nullptr, [&](const ContactProblem& frictionless) {
        return solver.solve(frictionless).solution.forces.Fn;
    });
}

WheelRailProblem CaseRun::rail_problem(const ContactCase& read, Given& given) const {
    GivenRail rail;
    set_rail_case(given, rail, read, files_);
    WheelRailProblem problem{setup_of(given, rail), state_of(given, rail)};
    problem.setup.wheel_surface = input_.wheel_surface;
    int& most = problem.setup.patches.max_elements;
    most = static_cast<int>(std::min(static_cast<std::size_t>(most), input_.max_elements));
    return problem;
}

void CaseRun::solve_basic(const ContactCase& read, History& history, ProblemSolver& solver,
                          ContactFileOutcome& outcome) {
    Given given;
    const Solved* last = history.solved ? &*history.solved : nullptr;
    ContactProblem problem = basic_problem(read, given, last, solver);
    problem.displacements = problem.model == Model::full;
    add_warning(outcome, given.digits.tangential == 0 ? "" : warning_of_memory(given));
    add_warning(outcome, warning_of_direction(read));
    const std::vector<GivenBlock> blocks = requested_blocks(read);
    SolveReply reply = solver.solve(problem);
    const auto& warnings = reply.solution.warnings;
    outcome.warnings.insert(outcome.warnings.end(), warnings.begin(), warnings.end());
    Solved solved = solved_step(given, std::move(problem), reply.solution, last);
    ContactFilePatch contact = printed_contact(read, given, solved);
    std::size_t left = most_block_points(input_.max_elements);
    contact.blocks = blocks_below(blocks, solved, left, asked_);
    outcome.numbers = contact.numbers;
    outcome.patches.push_back(std::move(contact));
    set_status(outcome, converged(required_evidence(solved)));
    outcome.solution = std::move(reply);
    history.solved = std::move(solved);
}

void CaseRun::solve_on_rails(const ContactCase& read, History& history, ProblemSolver& solver,
                             ContactFileOutcome& outcome) {
    Given given;
    WheelRailProblem problem = rail_problem(read, given);
    auto& [setup, state] = problem;
    state.displacements = setup.model == Model::full;
    add_warning(outcome, given.digits.tangential == 0 ? "" : warning_of_memory(given));
    if (setup.friction) add_warning(outcome, warning_of_places(*given.friction, state.position.x));
    const std::vector<GivenBlock> blocks = requested_blocks(read);
    WheelRailSolution solution = history.rail.solve(given, setup.model, state, [&](WheelRailEstimates& estimates) {
        return solver.solve(setup, state, estimates);
    });
    outcome.warnings.insert(outcome.warnings.end(), solution.warnings.begin(), solution.warnings.end());
    outcome.numbers = printed_forces(state, solution);
    constexpr int again = 3;
    const bool continues = goes_on(read) && history.has_rows;
    const std::vector<Extent> before = digit(read, "P") == again ? history.rows_before : history.rows;
    std::vector<Extent> rows;
    Solved solved;
    std::size_t left = most_block_points(input_.max_elements);
    const auto take = [&](const WheelRailPatch& found) {
        show_patch(found, setup, state, solved);
        ContactFilePatch patch = printed_patch(found, setup, state, solution, solved);
        patch.blocks = blocks_below(blocks, solved, left, asked_);
        const double half = found.place.grid.dy / 2, across = found.place.on_rail.across;
        const Grid& grid = found.place.grid;
        rows.push_back({across + grid.y(0) - half, across + grid.y(grid.ny - 1) + half});
        if (continues) {
            patch.previous.emplace();
            for (std::size_t i = 0; i < before.size(); ++i)
                if (before[i].from < rows.back().to && before[i].to > rows.back().from)
                    patch.previous->push_back(static_cast<int>(i) + 1);
        }
        outcome.patches.push_back(std::move(patch));
    };
    if (setup.side == Side::right)
        std::ranges::for_each(solution.patches, take);
    else
        std::for_each(solution.patches.rbegin(), solution.patches.rend(), take);
    history.rows_before = before;
    history.rows = std::move(rows);
    history.has_rows = true;
    set_status(outcome, solution.converged());
    if (state.Fz && !solution.in_contact()) {
        outcome.status = ContactFileStatus::not_converged;
        outcome.sentence = solution.warnings.empty() ? "Wheel and rail do not touch, so there is no contact."
                                                     : solution.warnings.back();
    }
    outcome.solution = std::move(solution);
}

std::optional<ContactFileProblem> CaseRun::convert_next(ProblemSolver& solver, const Observer& observer) {
    const WhileAsked asks(asked_.now, observer);
    const std::optional<ContactCase> read = read_next();
    if (!read) return {};
    ContactFileProblem converted{outcome_of(*read), goes_on(*read), {}};
    refuse_early(*read, {}, converted.outcome);
    if (converted.outcome.status != ContactFileStatus::read) return converted;
    take_errors(converted.outcome, [&] {
        Given given;
        if (read->module_number == on_rails)
            converted.problem = rail_problem(*read, given);
        else
            converted.problem = basic_problem(*read, given, nullptr, solver);
    });
    return converted;
}

std::size_t CaseRun::bytes() const {
    constexpr std::size_t bytes_of_element = 500;  // for the last problem, its solution and the tractions of a step
    std::size_t sum = 3 * input_.text.size() + file_bytes_;
    for (const auto& [key, history] : histories_)
        sum += bytes_of_element * (history.solved ? history.solved->problem.grid.size() : history.rail.elements());
    return sum;
}

}  // namespace contactd::cases
