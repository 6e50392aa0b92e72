#include "contactd/column_spectrum.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "contactd/error.hpp"
#include "influence/columns/screened_half_space.hpp"
#include "influence/columns/wavenumber_rule.hpp"
#include "influence/half_space_model.hpp"

namespace contactd {
namespace {

using std::numbers::pi;
using Block = Eigen::Matrix3d;
using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
constexpr std::array axes{Axis::x, Axis::y, Axis::z};
/// Of how a difference falls where it is 1/xi^2 between the last two wavenumbers.
constexpr double least_doubt = 0.25;

/// Displacements of the half-space for G = 1 from its kernels. Of transforms, the symmetric form: there a load along x
/// turns the sign of what is odd in x, and displacements from tractions along x have it once more.
Block half_space(const KernelIntegrals& k, double nu, bool transform) {
    const double yx = nu * k.xy / (2 * pi), xz = (1 - 2 * nu) * k.x / (4 * pi), yz = (1 - 2 * nu) * k.y / (4 * pi);
    const double turned = transform ? -1 : 1;
    Block block;
    block << (k.xx + (1 - nu) * k.yy) / (2 * pi), yx, xz,      //
        turned * yx, (k.yy + (1 - nu) * k.xx) / (2 * pi), yz,  //
        -turned * xz, -yz, (1 - nu) * (k.xx + k.yy) / (2 * pi);
    return block;
}

/// The load turned from column J, and the displacement to column I, by half the angle each.
class Turn {
   public:
    explicit Turn(double angle) {
        const double c = std::cos(angle / 2), s = std::sin(angle / 2);
        half_ << 1, 0, 0, 0, c, -s, 0, s, c;
    }
    Block operator()(const Block& flat) const { return half_ * flat * half_; }

   private:
    Block half_;
};

/// At offsets of either sign across the section: the kernels x y and y are odd there.
KernelIntegrals across(KernelIntegrals k, int l) {
    if (l < 0) {
        k.xy = -k.xy;
        k.y = -k.y;
    }
    return k;
}

bool is_odd(Axis i, Axis j) {
    return (i == Axis::x) != (j == Axis::x);
}

class TableMaker {
   public:
    TableMaker(const ColumnSpectrum& spectrum, double dx, int nx, double shift)
        : spectrum_(spectrum), columns_(spectrum.columns), dx_(dx), nx_(nx), shift_(shift) {}

    ColumnTable make(double factor) const {
        ColumnTable table(nx_, columns_);
        add_interpolated(table, spectrum_.nodes, 1);
        add_half_space(table);
        for (double& value : table.values) value *= factor;
        return table;
    }

    /// What the interpolation between all wavenumbers is more than that between every other one.
    ColumnTable nested() const {
        ColumnTable table(nx_, columns_);
        add_interpolated(table, spectrum_.nodes, 1);
        for (double& value : table.values) value = -value;
        std::vector<double> coarse;
        for (std::size_t node = 0; node < spectrum_.nodes.size(); node += 2) coarse.push_back(spectrum_.nodes[node]);
        add_interpolated(table, coarse, 2);
        return table;
    }

    double beyond() const {
        const std::size_t last = spectrum_.nodes.size() - 1;
        std::vector<double> before;
        for_differences(last - 1, [&](int, int, int, int, double value) { before.push_back(std::abs(value)); });
        const double step = std::log(spectrum_.nodes[last] / spectrum_.nodes[last - 1]);
        double largest = 0;
        std::size_t at = 0;
        for_differences(last, [&](int, int, int, int, double value) {
            const double size = std::abs(value), power = std::log(before[at++] / std::max(size, 1e-300)) / step;
            largest = std::max(largest, size * std::clamp(std::abs(power - 2), least_doubt, 1.0));
        });
        // What the alternating half waves of sin(xi dx/2) leave of a difference that falls as 1/xi, not as 1/xi^2.
        return largest * 2 / (pi * dx_ * spectrum_.nodes.back());
    }

   private:
    double angle(int I, int J) const { return spectrum_.frames[I].angle - spectrum_.frames[J].angle; }

    /// Transforms at a node, less those of the screened half-space.
    template <class Visit>
    void for_differences(std::size_t node, const Visit& visit) const {
        std::vector<KernelIntegrals> reference;
        for (int l = 0; l < columns_; ++l)
            reference.push_back(screened_transforms(spectrum_.nodes[node], spectrum_.xi0, l));
        for (int I = 0; I < columns_; ++I)
            for (int J = 0; J < columns_; ++J) {
                const KernelIntegrals kernels = across(reference[static_cast<std::size_t>(std::abs(I - J))], I - J);
                const Block block = Turn(angle(I, J))(half_space(kernels, spectrum_.nu, true));
                for (int i = 0; i < 3; ++i)
                    for (int j = 0; j < 3; ++j)
                        visit(I, J, i, j, spectrum_.values[spectrum_.index(node, 3 * I + i, 3 * J + j)] - block(i, j));
            }
    }

    /// Of the difference to the screened half-space, at every `stride`-th node.
    void add_interpolated(ColumnTable& table, const std::vector<double>& nodes, std::size_t stride) const {
        const WavenumberRule rule = wavenumber_rule(nodes, spectrum_.xi0, dx_, nx_, shift_);
        const auto count = static_cast<Eigen::Index>(nodes.size()),
                   pairs = static_cast<Eigen::Index>(columns_) * columns_;
        std::array<RowMajor, 9> difference;
        difference.fill(RowMajor(pairs, count));
        for (Eigen::Index node = 0; node < count; ++node)
            for_differences(static_cast<std::size_t>(node) * stride, [&](int I, int J, int i, int j, double value) {
                difference[static_cast<std::size_t>(3 * i + j)](I * columns_ + J, node) = value;
            });
        for (const Axis i : axes)
            for (const Axis j : axes) {
                const auto& weights = is_odd(i, j) ? rule.odd : rule.even;
                // A load along cos(xi x) instead of sin: what it moves across turns its sign.
                const double sign = j == Axis::x && i != Axis::x ? -1 : 1;
                Eigen::Map<RowMajor>(&table(i, j, 0, 0, 0), pairs, nx_).noalias() +=
                    sign * difference[3 * static_cast<std::size_t>(i) + static_cast<std::size_t>(j)] *
                    Eigen::Map<const RowMajor>(weights.data(), count, nx_);
            }
    }

    void add_half_space(ColumnTable& table) const {
        std::vector<Block> ahead(static_cast<std::size_t>(nx_)), behind(ahead.size());
        for (int l = 0; l < columns_; ++l) {
            for (int k = 0; k < nx_; ++k) {
                const double x = k * dx_ + shift_;
                KernelIntegrals kernels = constant_load_integrals(x, l, dx_, 1);
                const KernelIntegrals change = screening(spectrum_.xi0, x, l, dx_);
                kernels = {kernels.xx + change.xx, kernels.yy + change.yy, kernels.xy + change.xy, kernels.x + change.x,
                           kernels.y + change.y};
                ahead[static_cast<std::size_t>(k)] = half_space(kernels, spectrum_.nu, false);
                behind[static_cast<std::size_t>(k)] = half_space(across(kernels, -l), spectrum_.nu, false);
            }
            for (int J = 0; J + l < columns_; ++J) {
                add(table, J + l, J, ahead);
                if (l > 0) add(table, J, J + l, behind);
            }
        }
    }
    void add(ColumnTable& table, int I, int J, const std::vector<Block>& flat) const {
        const Turn turn(angle(I, J));
        for (std::size_t k = 0; k < flat.size(); ++k) {
            const Block block = turn(flat[k]);
            for (const Axis i : axes)
                for (const Axis j : axes)
                    table(i, j, I, J, static_cast<int>(k)) += block(static_cast<int>(i), static_cast<int>(j));
        }
    }

    const ColumnSpectrum& spectrum_;
    int columns_;
    double dx_;
    int nx_;
    double shift_;
};

/// zz of the half-space under an element dx x 1.
double self_compliance(const ColumnSpectrum& spectrum, double dx) {
    const KernelIntegrals self = constant_load_integrals(0, 0, dx, 1);
    return (1 - spectrum.nu) * (self.xx + self.yy) / (2 * pi);
}

}  // namespace

ColumnTable column_table(const ColumnSpectrum& spectrum, double dx, int nx, double shift, double factor) {
    return TableMaker(spectrum, dx, nx, shift).make(factor);
}

double nested_change(const ColumnSpectrum& spectrum, double dx, int nx) {
    const ColumnTable change = TableMaker(spectrum, dx, nx, 0).nested();
    double largest = 0;
    for (const double value : change.values) largest = std::max(largest, std::abs(value));
    return largest / self_compliance(spectrum, dx);
}

double beyond_the_end(const ColumnSpectrum& spectrum) {
    constexpr double shortest = 0.5;  // the shorter elements are along x, the more they feel of it
    return TableMaker(spectrum, shortest, 1, 0).beyond() / self_compliance(spectrum, 1);
}

}  // namespace contactd
