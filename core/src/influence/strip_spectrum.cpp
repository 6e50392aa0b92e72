#include "contactd/strip_spectrum.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <numbers>

#include "contactd/finite.hpp"
#include "influence/half_space_model.hpp"
#include "influence/strips/offset_rows.hpp"
#include "influence/strips/screened_half_space.hpp"
#include "influence/strips/spectrum_errors.hpp"
#include "influence/strips/wavenumber_rule.hpp"

namespace contactd {
namespace {

using std::numbers::pi;
using Block = Eigen::Matrix3d;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
/// These bound the deviation from a decay of 1/xi^2 of a difference beyond the last two wavenumbers.
constexpr double least_doubt = 0.25, most_doubt = 2;

struct Component {
    Axis i, j;
};
/// These are sorted by parity along x.
constexpr std::array even_components{Component{Axis::x, Axis::x}, Component{Axis::y, Axis::y},
                                     Component{Axis::y, Axis::z}, Component{Axis::z, Axis::y},
                                     Component{Axis::z, Axis::z}};
constexpr std::array odd_components{Component{Axis::x, Axis::y}, Component{Axis::x, Axis::z},
                                    Component{Axis::y, Axis::x}, Component{Axis::z, Axis::x}};

double of(const Block& block, const Component& component) {
    return block(static_cast<int>(component.i), static_cast<int>(component.j));
}

/// Returns displacements of the half-space for G = 1 from its kernels. Transforms have the symmetric form: a load along
/// x reverses the sign of odd functions of x, and displacements from tractions along x reverse it again.
Block half_space(const KernelIntegrals& k, double nu, bool transform) {
    const double yx = nu * k.xy / (2 * pi), xz = (1 - 2 * nu) * k.x / (4 * pi), yz = (1 - 2 * nu) * k.y / (4 * pi);
    const double sign = transform ? -1 : 1;
    Block block;
    block << (k.xx + (1 - nu) * k.yy) / (2 * pi), yx, xz,    //
        sign * yx, (k.yy + (1 - nu) * k.xx) / (2 * pi), yz,  //
        -sign * xz, -yz, (1 - nu) * (k.xx + k.yy) / (2 * pi);
    return block;
}

/// Rotates the load from strip J, and the displacement to strip I, by half the angle each.
class HalfAngleRotation {
   public:
    explicit HalfAngleRotation(double angle) {
        const double c = std::cos(angle / 2), s = std::sin(angle / 2);
        half_ << 1, 0, 0, 0, c, -s, 0, s, c;
    }
    Block operator()(const Block& flat) const { return half_ * flat * half_; }
    /// Returns the share of a flat component in a rotated one.
    double share(const Component& rotated, const Component& flat) const {
        return half_(static_cast<int>(rotated.i), static_cast<int>(flat.i)) *
               half_(static_cast<int>(flat.j), static_cast<int>(rotated.j));
    }

   private:
    Block half_;
};

/// Holds the functions of the offset, [function, k], that make up coefficients; those of the wavenumbers are first.
struct Functions {
    RowMajor even, odd;
};

/// Computes pairs of strips (I, J), I >= J; the others follow by reciprocity.
class TableMaker {
   public:
    TableMaker(const StripSpectrum& spectrum, double dx, int nx, double shift, const Observer& observer)
        : spectrum_(spectrum), observer_(observer), strips_(spectrum.strips), dx_(dx), nx_(nx), shift_(shift) {}

    StripTable make(double factor, int threads) const {
        Functions functions = interpolation(1);
        const Eigen::Index nodes = functions.even.rows();
        functions.even.conservativeResize(nodes + static_cast<Eigen::Index>(even_components.size()), nx_);
        functions.odd.conservativeResize(nodes + static_cast<Eigen::Index>(odd_components.size()), nx_);
        functions.even *= factor;
        functions.odd *= factor;
        StripTable table;
        table.nx = nx_;
        table.strips = strips_;
        table.values.resize(9 * table.component_size());
        std::atomic<int> next = 0;
        std::atomic<bool> finite = true;
        const auto work = [&] {
            Functions own = functions;
            for (int l = next++; l < strips_; l = next++) {
                observer_.throw_if_cancelled();
                if (!make_apart(l, factor, nodes, own, table)) finite = false;
            }
        };
        std::vector<std::future<void>> others;
        for (int thread = 1; thread < std::min(threads, strips_); ++thread)
            others.push_back(std::async(std::launch::async, work));
        work();
        for (std::future<void>& other : others) other.get();
        if (!finite) throw NotFinite("Coefficients of the table exceed the range of a double.");
        return table;
    }

    /// Returns the largest change if every other wavenumber is omitted.
    double nested() const {
        Functions functions = interpolation(2);
        const Functions all = interpolation(1);
        functions.even -= all.even;
        functions.odd -= all.odd;
        double largest = 0;
        for (int l = 0; l < strips_; ++l) {
            const auto nx = static_cast<std::size_t>(nx_), components = even_components.size() + odd_components.size();
            std::vector<double> changes(components * static_cast<std::size_t>(strips_ - l) * nx);
            std::size_t at = 0;
            fill(l, functions, [&](const Component&, int) { return OffsetRows{&changes[nx * at++], nullptr}; });
            for (const double change : changes) largest = std::max(largest, std::abs(change));
        }
        return largest;
    }

    /// Returns the largest difference at the last wavenumber, times the uncertainty of its decay as 1/xi^2.
    double doubtful_end() const {
        const std::size_t last = spectrum_.nodes.size() - 1;
        const double step = std::log(spectrum_.nodes[last] / spectrum_.nodes[last - 1]);
        double largest = 0;
        for (int l = 0; l < strips_; ++l) {
            const Block flat_before = reference(last - 1, l), flat = reference(last, l);
            for (int J = 0; J + l < strips_; ++J) {
                const HalfAngleRotation rotation(angle(J + l, J));
                const Eigen::Array33d before = difference(last - 1, J + l, J, rotation(flat_before)).array().abs(),
                                      size = difference(last, J + l, J, rotation(flat)).array().abs(),
                                      power = (before / size.max(1e-300)).log() / step;
                largest = std::max(largest, (size * (power - 2).abs().max(least_doubt).min(most_doubt)).maxCoeff());
            }
        }
        return largest;
    }

   private:
    /// Computes all coefficients of strips that are l apart. `functions` has space for those of the half-space behind
    /// those of the nodes. Returns false if one is not finite.
    bool make_apart(int l, double factor, Eigen::Index nodes, Functions& functions, StripTable& table) const {
        for (int k = 0; k < nx_; ++k) {
            const Block flat = factor * screened_half_space(k, l);
            for (Eigen::Index c = 0; c < functions.even.rows() - nodes; ++c)
                functions.even(nodes + c, k) = of(flat, even_components[static_cast<std::size_t>(c)]);
            for (Eigen::Index c = 0; c < functions.odd.rows() - nodes; ++c)
                functions.odd(nodes + c, k) = of(flat, odd_components[static_cast<std::size_t>(c)]);
        }
        return fill(l, functions, [&](const Component& component, int J) {
            const auto& [i, j] = component;
            return OffsetRows{&table(i, j, J + l, J, 0), l > 0 ? &table(j, i, J, J + l, 0) : nullptr};
        });
    }

    double angle(int I, int J) const { return spectrum_.frames[I].angle - spectrum_.frames[J].angle; }

    /// Returns the screened half-space at a node, for strips that are l apart.
    Block reference(std::size_t node, int l) const {
        return half_space(screened_transforms(spectrum_.nodes[node], spectrum_.xi0, l), spectrum_.nu, true);
    }
    /// Returns the transforms at a node, minus those of the screened half-space, rotated.
    Block difference(std::size_t node, int I, int J, const Block& rotated) const {
        Block block = -rotated;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) block(i, j) += spectrum_.values[spectrum_.index(node, 3 * I + i, 3 * J + j)];
        return block;
    }

    Block screened_half_space(int k, int l) const {
        const double x = k * dx_ + shift_;
        KernelIntegrals kernels = constant_load_integrals(x, l, dx_, 1);
        const KernelIntegrals change = screening(spectrum_.xi0, x, l, dx_);
        kernels = {kernels.xx + change.xx, kernels.yy + change.yy, kernels.xy + change.xy, kernels.x + change.x,
                   kernels.y + change.y};
        return half_space(kernels, spectrum_.nu, false);
    }

    /// Returns the interpolation between every `stride`-th node.
    Functions interpolation(std::size_t stride) const {
        std::vector<double> nodes;
        for (std::size_t node = 0; node < spectrum_.nodes.size(); node += stride)
            nodes.push_back(spectrum_.nodes[node]);
        const WavenumberRule rule = wavenumber_rule(nodes, spectrum_.xi0, dx_, nx_, shift_, observer_);
        const auto spread = [&](const std::vector<double>& weights) {
            RowMajor all = RowMajor::Zero(static_cast<Eigen::Index>(spectrum_.nodes.size()), nx_);
            for (std::size_t node = 0; node < nodes.size(); ++node)
                all.row(static_cast<Eigen::Index>(node * stride)) =
                    Eigen::Map<const Eigen::RowVectorXd>(weights.data() + node * static_cast<std::size_t>(nx_), nx_);
            return all;
        };
        return {spread(rule.even), spread(rule.odd)};
    }

    /// Computes strips that are l apart, each component of J + l and J to the position given by `rows`. Functions of
    /// the half-space may follow those of the nodes. Returns false if a coefficient is not finite.
    bool fill(int l, const Functions& functions, const auto& rows) const {
        RowMajor even = shares(l, even_components, functions.even), odd = shares(l, odd_components, functions.odd);
        std::vector<Block> references;
        for (std::size_t node = 0; node < spectrum_.nodes.size(); ++node) references.push_back(reference(node, l));
        for (int J = 0; J + l < strips_; ++J) {
            const HalfAngleRotation rotation(angle(J + l, J));
            for (std::size_t node = 0; node < references.size(); ++node) {
                const Block block = difference(node, J + l, J, rotation(references[node]));
                put_waves(even, J, node, block, even_components);
                put_waves(odd, J, node, block, odd_components);
            }
        }
        const bool finite = multiply(even, functions.even, rows_of(l, even_components, rows), 1);
        return multiply(odd, functions.odd, rows_of(l, odd_components, rows), -1) && finite;
    }

    /// Returns the weights of each function in the coefficients, [component + components J, function], including those
    /// of the half-space.
    template <std::size_t count>
    RowMajor shares(int l, const std::array<Component, count>& components, const RowMajor& functions) const {
        const auto nodes = static_cast<Eigen::Index>(spectrum_.nodes.size());
        RowMajor result(static_cast<Eigen::Index>(count) * (strips_ - l), functions.rows());
        for (int J = 0; J + l < strips_; ++J) {
            const HalfAngleRotation rotation(angle(J + l, J));
            for (std::size_t c = 0; c < count; ++c)
                for (Eigen::Index flat = 0; nodes + flat < functions.rows(); ++flat)
                    result(row_of<count>(J, c), nodes + flat) =
                        rotation.share(components[c], components[static_cast<std::size_t>(flat)]);
        }
        return result;
    }
    template <std::size_t count>
    static Eigen::Index row_of(int J, std::size_t component) {
        return static_cast<Eigen::Index>(count) * J + static_cast<Eigen::Index>(component);
    }
    template <std::size_t count>
    static void put_waves(RowMajor& shares, int J, std::size_t node, const Block& block,
                          const std::array<Component, count>& components) {
        for (std::size_t c = 0; c < count; ++c)
            shares(row_of<count>(J, c), static_cast<Eigen::Index>(node)) = of_wave(block, components[c]);
    }
    template <std::size_t count>
    std::vector<OffsetRows> rows_of(int l, const std::array<Component, count>& components, const auto& rows) const {
        std::vector<OffsetRows> result;
        for (int J = 0; J + l < strips_; ++J)
            for (const Component& component : components) result.push_back(rows(component, J));
        return result;
    }
    static bool multiply(const RowMajor& shares, const RowMajor& functions, const std::vector<OffsetRows>& rows,
                         double parity) {
        return add_up(rows, parity, shares.data(), functions.data(), static_cast<std::size_t>(functions.rows()),
                      static_cast<std::size_t>(functions.cols()));
    }
    /// For a load along cos(xi x) instead of sin, displacements across change their sign.
    static double of_wave(const Block& block, const Component& component) {
        const double value = of(block, component);
        return component.j == Axis::x && component.i != Axis::x ? -value : value;
    }

    const StripSpectrum& spectrum_;
    const Observer& observer_;
    int strips_;
    double dx_;
    int nx_;
    double shift_;
};

}  // namespace

StripTable strip_table(const StripSpectrum& spectrum, double dx, int nx, double shift, double factor, int threads,
                       const Observer& observer) {
    return TableMaker(spectrum, dx, nx, shift, observer).make(factor, threads);
}

double nested_change(const StripSpectrum& spectrum, double dx, int nx) {
    return TableMaker(spectrum, dx, nx, 0, Observer()).nested() / error_scale(spectrum, dx);
}

double beyond_the_end(const StripSpectrum& spectrum, double dx) {
    // This bounds 2/pi times the integral of (xi_last/xi) sin(xi dx/2)/xi beyond it, which decays as 1/xi.
    const double half_waves = spectrum.nodes.back() * dx / 2;
    return TableMaker(spectrum, dx, 1, 0, Observer()).doubtful_end() * 2 / (pi * std::hypot(1, half_waves)) /
           error_scale(spectrum, dx);
}

double error_scale(const StripSpectrum& spectrum, double dx) {
    const KernelIntegrals self = constant_load_integrals(0, 0, dx, 1);
    const double half_space = (1 - spectrum.nu) * (self.xx + self.yy) / (2 * pi);
    const StripTable table = strip_table(spectrum, dx, 1);
    double own = 0;
    for (int strip = 0; strip < spectrum.strips; ++strip) own = std::max(own, table(Axis::z, Axis::z, strip, strip, 0));
    return std::min(half_space, own);
}

}  // namespace contactd
