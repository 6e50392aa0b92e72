#include "spectrum_build.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <numbers>
#include <string>

#include "contactd/error.hpp"
#include "influence/columns/wavenumber_rule.hpp"

namespace contactd::fem {
namespace {

using std::numbers::pi;

constexpr int finest_order = 6, most_nodes = 129;
/// Of the accuracy asked for, what each kind of error may take.
constexpr double mesh_share = 0.4, wavenumber_share = 0.35, end_share = 0.25;
/// Expected of a mesh, and of its matrices (s).
constexpr double mesh_seconds = 2;
constexpr double last_wavenumber = 6, farthest_wavenumber = 12;

/// Offsets, as long as they are wide, at which errors of a table are looked for.
constexpr int offsets_looked_at = 64;

/// zz of the half-space under an element 1 x 1, for G = 1.
double self_compliance(double nu) {
    return 2 * std::asinh(1.0) * (1 - nu) / pi;
}

/// The share of an element's transform that each of some wavenumbers stands for, when what is between them is linear in
/// asinh(xi/xi0).
std::vector<double> shares(const std::vector<double>& wavenumbers, double xi0) {
    std::vector<double> result(wavenumbers.size(), 0);
    constexpr int steps = 200;
    for (std::size_t i = 0; i + 1 < wavenumbers.size(); ++i) {
        const double from = std::asinh(wavenumbers[i] / xi0), to = std::asinh(wavenumbers[i + 1] / xi0);
        for (int step = 0; step < steps; ++step) {
            const double share = (step + 0.5) / steps, tau = from + share * (to - from), xi = xi0 * std::sinh(tau);
            const double part = std::abs(std::sin(xi / 2)) * 2 / xi * xi0 * std::cosh(tau) * (to - from) / steps / pi;
            result[i] += (1 - share) * part;
            result[i + 1] += share * part;
        }
    }
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
          level_(first_level(accuracy, nu)) {
        MPI_Comm_rank(comm, &rank_);
        MPI_Comm_size(comm, &processes_);
    }

    SpectrumBuild build() {
        for (;;) {
            attempt();
            // Elements of the next order gain the most.
            if (result_.errors.mesh <= mesh_share * accuracy_ || level_.order == finest_order) break;
            ++level_.order;
        }
        return std::move(result_);
    }

   private:
    void attempt() {
        const double start = MPI_Wtime();
        const MeshDensity density = density_for(accuracy_, nu_);
        report("mesh", 0, mesh_seconds);
        const DividedOutline divided = divide(outline_, density);
        const SectionMesh mesh = make_section_mesh(outline_, divided, triangulate(divided, density), level_.order);
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
        ColumnSpectrum& spectrum = result_.spectrum;
        spectrum.columns = outline_.columns;
        spectrum.nu = nu_;
        spectrum.frames = column_frames(outline_);
        // A length of the body, beyond which little changes with the wavenumber.
        constexpr double share_of_body = 0.4;
        spectrum.xi0 = share_of_body / divided.extent;
        spectrum.nodes = wavenumber_nodes(spectrum.xi0, last_wavenumber, level_.nodes);
        spectrum.values = responses(model, spectrum.nodes, 0.1, 0.6);
        result_.errors.reciprocity = reciprocity();
        estimate_mesh_error(mesh);
        if (result_.errors.mesh <= mesh_share * accuracy_ || level_.order == finest_order) {
            extend(model);
            result_.errors.wavenumbers = wavenumber_error();
            refine_wavenumbers(model);
        }
        result_.solve_seconds = MPI_Wtime() - solving;
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
                      "The build would take about %.2g GB of memory for %lld unknowns, and may use %llu bytes "
                      "(builds.max_memory_bytes): take a coarser accuracy.",
                      bytes / 1e9, model.unknowns(), static_cast<unsigned long long>(max_memory_bytes_));
        throw OutOfMemory("ics.accuracy", text.data());
    }

    void report(std::string_view stage, double fraction, double step_seconds) {
        observer_.report(
            {.stage = stage, .fraction = fraction, .step_seconds = step_seconds, .step_fraction = fraction});
    }

    /// Of wavenumbers in order, one behind the other; each process computes every so many of them.
    std::vector<double> responses(SectionModel& model, const std::vector<double>& wavenumbers, double from, double to) {
        const std::size_t size = result_.spectrum.component_size();
        std::vector<double> values(wavenumbers.size() * size, 0);
        // Factorisation and forward solves, at the rate of a slow machine.
        constexpr double rate = 1e9, solves_a_factor = 100;
        const double step_seconds = (model.factor().operations() + solves_a_factor * model.factor().entries()) / rate;
        const auto turns = static_cast<std::size_t>(processes_);
        for (std::size_t first = 0; first < wavenumbers.size(); first += turns) {
            if (const std::size_t mine = first + static_cast<std::size_t>(rank_); mine < wavenumbers.size())
                together([&] {
                    WaveResponse response = model.at(wavenumbers[mine]);
                    std::ranges::copy(response.values, values.begin() + static_cast<std::ptrdiff_t>(mine * size));
                    defects_.push_back({wavenumbers[mine], response.reciprocity_defect});
                });
            else
                together([] {});
            const double done = static_cast<double>(std::min(first + turns, wavenumbers.size())) /
                                static_cast<double>(wavenumbers.size());
            report("wavenumbers", from + done * (to - from), step_seconds);
        }
        for (std::size_t i = 0; i < wavenumbers.size(); ++i)
            MPI_Bcast(values.data() + i * size, static_cast<int>(size), MPI_DOUBLE, static_cast<int>(i % turns), comm_);
        return values;
    }

    /// What does not converge on one process ends all of them.
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

    /// Further wavenumbers where what lies beyond the last one matters: columns at an edge.
    void extend(SectionModel& model) {
        ColumnSpectrum& spectrum = result_.spectrum;
        for (;;) {
            result_.errors.end = beyond_the_end(spectrum);
            const double last = spectrum.nodes.back();
            if (result_.errors.end <= end_share * accuracy_ || last >= farthest_wavenumber) return;
            const double step = std::asinh(spectrum.nodes[1] / spectrum.xi0);
            std::vector<double> more;
            for (std::size_t i = 0; i < 2; ++i)
                more.push_back(spectrum.xi0 * std::sinh(step * static_cast<double>(spectrum.nodes.size() + i)));
            const std::vector<double> values = responses(model, more, 0.75, 0.8);
            spectrum.nodes.insert(spectrum.nodes.end(), more.begin(), more.end());
            spectrum.values.insert(spectrum.values.end(), values.begin(), values.end());
        }
    }

    double wavenumber_error() const {
        constexpr double gain = 8;  // sixteen for cubic splines where steps are small; the first ones are large
        return nested_change(result_.spectrum, 1, offsets_looked_at) / gain;
    }

    void refine_wavenumbers(SectionModel& model) {
        ColumnSpectrum& spectrum = result_.spectrum;
        const std::size_t size = spectrum.component_size();
        while (result_.errors.wavenumbers > wavenumber_share * accuracy_ &&
               2 * spectrum.nodes.size() - 1 <= most_nodes) {
            const double step = std::asinh(spectrum.nodes[1] / spectrum.xi0) / 2;
            std::vector<double> between, nodes, values;
            for (std::size_t i = 0; i + 1 < spectrum.nodes.size(); ++i)
                between.push_back(spectrum.xi0 * std::sinh(step * static_cast<double>(2 * i + 1)));
            const std::vector<double> found = responses(model, between, 0.8, 0.99);
            for (std::size_t i = 0; i < spectrum.nodes.size(); ++i) {
                const auto own = spectrum.values.begin() + static_cast<std::ptrdiff_t>(i * size);
                nodes.push_back(spectrum.nodes[i]);
                values.insert(values.end(), own, own + static_cast<std::ptrdiff_t>(size));
                if (i == between.size()) break;
                const auto next = found.begin() + static_cast<std::ptrdiff_t>(i * size);
                nodes.push_back(between[i]);
                values.insert(values.end(), next, next + static_cast<std::ptrdiff_t>(size));
            }
            spectrum.nodes = std::move(nodes);
            spectrum.values = std::move(values);
            result_.errors.wavenumbers = wavenumber_error();
        }
    }

    /// Of elements of the next higher order at a few wavenumbers.
    void estimate_mesh_error(const SectionMesh& mesh) {
        const ColumnSpectrum& spectrum = result_.spectrum;
        const std::size_t last = spectrum.nodes.size() - 1, size = spectrum.component_size();
        const std::array<std::size_t, 4> looked_at{0, last / 2, 3 * last / 4, last};
        std::vector<double> wavenumbers;
        for (const std::size_t node : looked_at) wavenumbers.push_back(spectrum.nodes[node]);
        SectionModel finer(outline_, mesh, level_.order + 1, nu_);
        const std::vector<double> values = responses(finer, wavenumbers, 0.6, 0.75);
        const std::vector<double> weights = shares(wavenumbers, spectrum.xi0);
        double largest = 0;
        for (std::size_t at = 0; at < size; ++at) {
            double sum = 0;
            for (std::size_t i = 0; i < looked_at.size(); ++i)
                sum += weights[i] * std::abs(values[i * size + at] - spectrum.values[looked_at[i] * size + at]);
            largest = std::max(largest, sum);
        }
        // Some of the error is left at the higher order, most of it at corners.
        constexpr double left = 1.5;
        result_.errors.mesh = left * largest / self_compliance(nu_);
    }

    double reciprocity() const {
        const std::vector<double>& nodes = result_.spectrum.nodes;
        const std::vector<double> weights = shares(nodes, result_.spectrum.xi0);
        double sum = 0;
        for (const auto& [xi, defect] : defects_)
            for (std::size_t i = 0; i < nodes.size(); ++i)
                if (nodes[i] == xi) sum += weights[i] * defect;
        double total = 0;
        MPI_Allreduce(&sum, &total, 1, MPI_DOUBLE, MPI_SUM, comm_);
        return total / self_compliance(nu_);
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
    SpectrumBuild result_;
    std::vector<Defect> defects_;
};

}  // namespace

SpectrumBuild build_spectrum(MPI_Comm comm, const SectionOutline& outline, double nu, double accuracy,
                             Observer& observer, std::uint64_t max_memory_bytes) {
    return Builder(comm, outline, nu, accuracy, observer, max_memory_bytes).build();
}

std::vector<ColumnFrame> column_frames(const SectionOutline& outline) {
    std::vector<ColumnFrame> frames;
    for (int column = 0; column < outline.columns; ++column) {
        const OutlinePosition middle = position_at(outline, outline.carrier, outline.first_column + column + 0.5);
        const PlanePoint at = point_at(outline, middle), normal = normal_at(outline, middle);
        double angle = std::atan2(normal.y, normal.z);
        if (column > 0) angle += 2 * pi * std::round((frames.back().angle - angle) / (2 * pi));
        frames.push_back({at.y, at.z, angle});
    }
    return frames;
}

}  // namespace contactd::fem
