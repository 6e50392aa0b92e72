#include "spectrum_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>

#include "contactd/error.hpp"
#include "contactd/uniform_elements.hpp"
#include "influence/strips/spectrum_errors.hpp"
#include "influence/strips/wavenumber_rule.hpp"

namespace contactd::fem {
namespace {

using std::numbers::pi;

constexpr int finest_order = 6, most_refinements = 2, most_nodes = 129;
/// Each kind of error may use this share of the requested accuracy.
constexpr double mesh_share = 0.4, wavenumber_share = 0.35, end_share = 0.25;
/// These are the expected times of a mesh and of its matrices (s).
constexpr double mesh_seconds = 2;
constexpr std::size_t nodes_in_reserve = 10;
constexpr double last_wavenumber = 6, farthest_wavenumber = 50;
/// These limit changes of the transform, relative to its largest value, up to the second wavenumber and up to an eighth
/// of xi0. Beyond these limits it may decrease at smaller wavenumbers than those of the body's size.
constexpr double doubtful_change = 0.8, probe = 1.0 / 8, most_change = 0.2;

/// Errors are checked at these lengths of elements, divided by ds, from the shortest to the longest length served.
constexpr std::array lengths{shortest_uniform_element, 1.0, 2.0, 8.0};
using ByLength = std::array<double, lengths.size()>;
/// Errors of a table are checked at these offsets, for elements as long as they are wide and for others.
constexpr int offsets_looked_at = 64, offsets_of_others = 16;

/// Returns the share of the transform of an element dx long that each of these wavenumbers represents, if the transform
/// is linear in asinh(xi/xi0) between them and decreases as 1/xi^2 beyond the last.
std::vector<double> shares(const std::vector<double>& wavenumbers, double xi0, double dx) {
    std::vector<double> result(wavenumbers.size(), 0);
    constexpr int steps = 200;
    constexpr double end_of_tail = 12;  // over the last wavenumber
    const auto element = [&](double xi) { return std::abs(std::sin(xi * dx / 2)) * 2 / (xi * pi); };
    const auto add = [&](double from, double to, const auto& part) {
        const double begin = std::asinh(from / xi0), width = std::asinh(to / xi0) - begin;
        for (int step = 0; step < steps; ++step) {
            const double share = (step + 0.5) / steps, tau = begin + share * width, xi = xi0 * std::sinh(tau);
            part(share, xi, element(xi) * xi0 * std::cosh(tau) * width / steps);
        }
    };
    for (std::size_t i = 0; i + 1 < wavenumbers.size(); ++i)
        add(wavenumbers[i], wavenumbers[i + 1], [&](double share, double, double part) {
            result[i] += (1 - share) * part;
            result[i + 1] += share * part;
        });
    const double last = wavenumbers.back();
    add(last, end_of_tail * last,
        [&](double, double xi, double part) { result.back() += part * last * last / (xi * xi); });
    return result;
}

class Builder {
   public:
    Builder(MPI_Comm comm, const SectionOutline& outline, double nu, double accuracy, Observer& observer,
            std::uint64_t max_memory_bytes)
        : comm_(comm),
          outline_(outline),
          nu_(nu),
          accuracy_(accuracy),
          observer_(comm, observer),
          max_memory_bytes_(max_memory_bytes),
          level_(first_level(accuracy, nu)),
          density_(density_for(accuracy, nu)) {
        MPI_Comm_rank(comm, &rank_);
        MPI_Comm_size(comm, &processes_);
    }

    SpectrumBuild build() {
        for (;;) {
            attempt();
            state_errors();
            if (is_small(mesh_error_, mesh_share)) break;
            // Elements of the next order reduce the error most; otherwise, corners and ends of supports need smaller
            // elements.
            if (level_.order < finest_order)
                ++level_.order;
            else if (missed() > accuracy_ && refinements_ < most_refinements)
                refine_mesh();
            else
                break;
        }
        require_accuracy();
        return std::move(result_);
    }

   private:
    void attempt() {
        const double start = MPI_Wtime();
        report("mesh", 0, mesh_seconds);
        const DividedOutline divided = divide(outline_, density_);
        const SectionMesh mesh = make_section_mesh(outline_, divided, triangulate(divided, density_), level_.order);
        const double meshed = MPI_Wtime();
        report("assembly", 0.02, mesh_seconds);
        SectionModel model(outline_, mesh, level_.order, nu_);
        require_room(model);
        result_ = {};
        defects_.clear();
        result_.order = level_.order;
        result_.triangles = mesh.mesh->GetNE();
        result_.unknowns = model.unknowns();
        result_.mesh_seconds = meshed - start;
        result_.setup_seconds = MPI_Wtime() - meshed;
        const double solving = MPI_Wtime();
        // Returns a length of the body, beyond which changes with the wavenumber are small.
        constexpr double share_of_body = 0.4;
        const double xi0 = share_of_body / divided.extent;
        sample(model, xi0);
        const std::size_t size = result_.spectrum.component_size();
        if (slowness_ == 1 && change(result_.spectrum.values.data(), size) > doubtful_change) {
            slowness_ = find_slowness(model, xi0);
            if (slowness_ < 1) sample(model, xi0);
        }
        extend(model);
        reciprocity_defect_ = reciprocity();
        estimate_mesh_error(mesh);
        if (is_small(mesh_error_, mesh_share) || level_.order == finest_order) {
            wavenumber_error_ = wavenumber_error();
            refine_wavenumbers(model);
        }
        result_.solve_seconds = MPI_Wtime() - solving;
    }

    /// Computes the transform at the wavenumbers of the first level, for a body whose transform changes little below
    /// xi0.
    void sample(SectionModel& model, double xi0) {
        defects_.clear();
        StripSpectrum& spectrum = result_.spectrum;
        spectrum.strips = outline_.strips;
        spectrum.nu = nu_;
        spectrum.frames = strip_frames(outline_);
        spectrum.xi0 = slowness_ * xi0;
        const auto range = [](double from) { return std::asinh(last_wavenumber / from); };
        const int steps = (level_.nodes - 1) / 2,
                  more = static_cast<int>(std::ceil(steps * (range(spectrum.xi0) / range(xi0) - 1)));
        spectrum.nodes = wavenumber_nodes(spectrum.xi0, last_wavenumber, level_.nodes + 2 * more);
        // Reserves room for refinement, so that values need not move; unused room takes no memory.
        spectrum.values.clear();
        spectrum.values.reserve((2 * spectrum.nodes.size() + nodes_in_reserve) * spectrum.component_size());
        spectrum.values.resize(spectrum.nodes.size() * spectrum.component_size());
        respond(model, spectrum.nodes, spectrum.values.data(), 1, 0.1, 0.55);
    }

    /// Returns the largest change from one set of responses to the next, divided by the largest value of the first.
    static double change(const double* values, std::size_t size) {
        double largest = 0, changed = 0;
        for (std::size_t at = 0; at < size; ++at) {
            largest = std::max(largest, std::abs(values[at]));
            changed = std::max(changed, std::abs(values[size + at] - values[at]));
        }
        return changed / largest;
    }

    /// Returns the share of xi0 below which changes are small. Bodies change at wavenumbers of their own size, except
    /// weakly held ones: a disc turns about its core like a long shaft.
    double find_slowness(SectionModel& model, double xi0) {
        constexpr int most_steps = 8;
        constexpr double nearly_all = 0.99;
        const std::size_t size = result_.spectrum.component_size();
        std::vector<double> values(2 * size);
        double share = 1;
        for (int step = 0; step < most_steps; ++step) {
            respond(model, {0, probe * share * xi0}, values.data(), 1, 0.05, 0.1);
            const double changed = std::min(change(values.data(), size), nearly_all);
            if (changed <= most_change) break;
            share *= probe * std::sqrt((1 - changed) / changed);  // where 1/(1 + (xi/xi0)^2), as of shafts, equals 1/2
        }
        return share;
    }

    void refine_mesh() {
        ++refinements_;
        ++density_.edges_a_strip;
        density_.corner_share /= 10;
    }

    void require_room(const SectionModel& model) const {
        if (max_memory_bytes_ == 0) return;
        constexpr double program = 110e6, of_matrices = 8;
        const double a_process = program + model.factor().entries() * 8 * 2 +
                                 1e3 * of_matrices * static_cast<double>(model.unknowns()),
                     bytes = a_process * processes_;
        if (bytes <= static_cast<double>(max_memory_bytes_)) return;
        std::array<char, 240> text{};
        std::snprintf(text.data(), text.size(),
                      "The build would take about %.2g GB of memory for %lld unknowns, but may use %llu bytes "
                      "(builds.max_memory_bytes). Use a coarser accuracy.",
                      bytes / 1e9, model.unknowns(), static_cast<unsigned long long>(max_memory_bytes_));
        throw OutOfMemory("ics.accuracy", text.data());
    }

    void report(std::string_view stage, double fraction, double step_seconds) {
        observer_.report(
            {.stage = stage, .fraction = fraction, .step_seconds = step_seconds, .step_fraction = fraction});
    }

    /// Writes the responses at successive wavenumbers to every `stride`-th place from `values` on; the processes take
    /// turns.
    void respond(SectionModel& model, const std::vector<double>& wavenumbers, double* values, std::size_t stride,
                 double from, double to) {
        const std::size_t size = result_.spectrum.component_size();
        // Estimates factorisation and forward solves at the rate of a slow machine.
        constexpr double rate = 1e9, solves_a_factor = 100;
        const double step_seconds = (model.factor().operations() + solves_a_factor * model.factor().entries()) / rate;
        const auto processes = static_cast<std::size_t>(processes_);
        for (std::size_t first = 0; first < wavenumbers.size(); first += processes) {
            if (const std::size_t mine = first + static_cast<std::size_t>(rank_); mine < wavenumbers.size())
                together([&] {
                    WaveResponse response = model.at(wavenumbers[mine]);
                    std::ranges::copy(response.values, values + mine * stride * size);
                    defects_.push_back({wavenumbers[mine], response.reciprocity_defect});
                });
            else
                together([] {});
            const double done = static_cast<double>(std::min(first + processes, wavenumbers.size())) /
                                static_cast<double>(wavenumbers.size());
            report("wavenumbers", from + done * (to - from), step_seconds);
        }
        for (std::size_t i = 0; i < wavenumbers.size(); ++i)
            MPI_Bcast(values + i * stride * size, static_cast<int>(size), MPI_DOUBLE, static_cast<int>(i % processes),
                      comm_);
    }

    /// A failure to converge on one process ends all of them.
    void together(const std::function<void()>& work) const {
        std::string problem;
        try {
            work();
        } catch (const NotConverged& error) {
            problem = error.what();
        }
        int failed = !problem.empty(), any = 0;
        MPI_Allreduce(&failed, &any, 1, MPI_INT, MPI_MAX, comm_);
        if (any == 0) return;
        throw NotConverged(failed != 0 ? problem : "The stiffness matrix of the section could not be factorised.");
    }

    bool is_small(const ByLength& errors, double share) const { return std::ranges::max(errors) <= share * accuracy_; }

    ByLength scales() const {
        ByLength result;
        std::ranges::transform(lengths, result.begin(), [&](double dx) { return error_scale(result_.spectrum, dx); });
        return result;
    }

    /// Returns the largest of all lengths.
    void state_errors() {
        SpectrumErrors& errors = result_.errors;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            const SpectrumErrors here{mesh_error_[i], wavenumber_error_[i], end_error_[i], reciprocity_defect_[i]};
            if (here.total() > errors.total()) errors = here;
        }
    }

    /// Returns the error that must be within the accuracy. Strips beside an edge are not reciprocal on any mesh. If
    /// only this error exceeds the accuracy, a warning reports it.
    double missed() const { return result_.errors.numerical(); }

    void require_accuracy() const {
        if (missed() <= accuracy_) return;
        const SpectrumErrors& errors = result_.errors;
        std::array<char, 400> text{};
        std::snprintf(text.data(), text.size(),
                      "The accuracy of %g was not reached: coefficients may have an error of %.2g, of which the mesh "
                      "of order %d contributes %.2g, and the %zu wavenumbers %.2g. Request a coarser accuracy, or use "
                      "narrower strips farther from an edge.",
                      accuracy_, errors.numerical(), result_.order, errors.mesh, result_.spectrum.nodes.size(),
                      errors.wavenumbers + errors.end);
        throw NotConverged(text.data());
    }

    /// Adds wavenumbers if the part beyond the last one matters, as for strips at an edge.
    void extend(SectionModel& model) {
        StripSpectrum& spectrum = result_.spectrum;
        for (;;) {
            std::ranges::transform(lengths, end_error_.begin(),
                                   [&](double dx) { return beyond_the_end(spectrum, dx); });
            if (is_small(end_error_, end_share) || spectrum.nodes.back() >= farthest_wavenumber) return;
            const double step = std::asinh(spectrum.nodes[1] / spectrum.xi0);
            std::vector<double> more;
            for (std::size_t i = 0; i < 2; ++i)
                more.push_back(spectrum.xi0 * std::sinh(step * static_cast<double>(spectrum.nodes.size() + i)));
            const std::size_t known = spectrum.values.size();
            spectrum.values.resize(known + more.size() * spectrum.component_size());
            respond(model, more, spectrum.values.data() + known, 1, 0.55, 0.6);
            spectrum.nodes.insert(spectrum.nodes.end(), more.begin(), more.end());
        }
    }

    ByLength wavenumber_error() const {
        constexpr double gain = 8;  // sixteen for cubic splines with small steps; the first steps are large
        ByLength result;
        for (std::size_t i = 0; i < lengths.size(); ++i) {
            const int offsets = lengths[i] == 1 ? offsets_looked_at : offsets_of_others;
            result[i] = nested_change(result_.spectrum, lengths[i], offsets) / gain;
        }
        return result;
    }

    void refine_wavenumbers(SectionModel& model) {
        StripSpectrum& spectrum = result_.spectrum;
        const std::size_t size = spectrum.component_size();
        while (!is_small(wavenumber_error_, wavenumber_share) && 2 * spectrum.nodes.size() - 1 <= most_nodes) {
            const double step = std::asinh(spectrum.nodes[1] / spectrum.xi0) / 2;
            std::vector<double> between, nodes{0};
            for (std::size_t i = 0; i + 1 < spectrum.nodes.size(); ++i) {
                between.push_back(spectrum.xi0 * std::sinh(step * static_cast<double>(2 * i + 1)));
                nodes.push_back(between.back());
                nodes.push_back(spectrum.nodes[i + 1]);
            }
            spectrum.values.resize(nodes.size() * size);
            for (std::size_t i = between.size(); i > 0; --i)
                std::copy_n(spectrum.values.data() + i * size, size, spectrum.values.data() + 2 * i * size);
            respond(model, between, spectrum.values.data() + size, 2, 0.8, 0.99);
            spectrum.nodes = std::move(nodes);
            wavenumber_error_ = wavenumber_error();
        }
    }

    /// Compares with elements of the next higher order at a few wavenumbers.
    void estimate_mesh_error(const SectionMesh& mesh) {
        const StripSpectrum& spectrum = result_.spectrum;
        const std::size_t last = spectrum.nodes.size() - 1, size = spectrum.component_size();
        const std::array<std::size_t, 4> looked_at{0, last / 2, 3 * last / 4, last};
        std::vector<double> wavenumbers;
        for (const std::size_t node : looked_at) wavenumbers.push_back(spectrum.nodes[node]);
        SectionModel finer(outline_, mesh, level_.order + 1, nu_);
        std::vector<double> values(wavenumbers.size() * size);
        respond(finer, wavenumbers, values.data(), 1, 0.6, 0.75);
        // Part of the error remains at the higher order, mostly at corners.
        constexpr double left = 1.5;
        const ByLength scale = scales();
        for (std::size_t length = 0; length < lengths.size(); ++length) {
            const std::vector<double> weights = shares(wavenumbers, spectrum.xi0, lengths[length]);
            double largest = 0;
            for (std::size_t at = 0; at < size; ++at) {
                double sum = 0;
                for (std::size_t i = 0; i < looked_at.size(); ++i)
                    sum += weights[i] * std::abs(values[i * size + at] - spectrum.values[looked_at[i] * size + at]);
                largest = std::max(largest, sum);
            }
            mesh_error_[length] = left * largest / scale[length];
        }
    }

    ByLength reciprocity() const {
        const std::vector<double>& nodes = result_.spectrum.nodes;
        ByLength sums{}, result;
        for (std::size_t length = 0; length < lengths.size(); ++length) {
            const std::vector<double> weights = shares(nodes, result_.spectrum.xi0, lengths[length]);
            for (const auto& [xi, defect] : defects_)
                for (std::size_t i = 0; i < nodes.size(); ++i)
                    if (nodes[i] == xi) sums[length] += weights[i] * defect;
        }
        MPI_Allreduce(sums.data(), result.data(), static_cast<int>(sums.size()), MPI_DOUBLE, MPI_SUM, comm_);
        std::ranges::transform(result, scales(), result.begin(), std::divides{});
        return result;
    }

    struct Defect {
        double xi, value;
    };
    MPI_Comm comm_;
    int rank_ = 0, processes_ = 1;
    const SectionOutline& outline_;
    double nu_, accuracy_;
    CollectiveObserver observer_;
    std::uint64_t max_memory_bytes_;
    SpectrumLevel level_;
    MeshDensity density_;
    int refinements_ = 0;
    double slowness_ = 1;
    SpectrumBuild result_;
    std::vector<Defect> defects_;
    ByLength mesh_error_{}, wavenumber_error_{}, end_error_{}, reciprocity_defect_{};
};

}  // namespace

SpectrumBuild build_spectrum(MPI_Comm comm, const SectionOutline& outline, double nu, double accuracy,
                             Observer& observer, std::uint64_t max_memory_bytes) {
    return Builder(comm, outline, nu, accuracy, observer, max_memory_bytes).build();
}

std::vector<StripFrame> strip_frames(const SectionOutline& outline) {
    std::vector<StripFrame> frames;
    for (int strip = 0; strip < outline.strips; ++strip) {
        const OutlinePosition middle = position_at(outline, outline.carrier, outline.first_strip + strip + 0.5);
        const PlanePoint at = point_at(outline, middle), normal = normal_at(outline, middle);
        double angle = std::atan2(normal.y, normal.z);
        if (strip > 0) angle += 2 * pi * std::round((frames.back().angle - angle) / (2 * pi));
        frames.push_back({at.y, at.z, angle});
    }
    return frames;
}

}  // namespace contactd::fem
