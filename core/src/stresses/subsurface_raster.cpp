#include "subsurface_raster.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "operators/fft/padded_fft.hpp"
#include "operators/fft/padded_size.hpp"

namespace contactd {
namespace {

// Describes offsets of points from elements along one axis: whole + fraction, first <= whole <= last. Without a
// fraction, negative offsets follow by parity.
struct Offsets {
    int first, last;
    double fraction;
    bool mirrored;

    Offsets(int elements, int points, double offset) {
        const double down = std::floor(offset);
        fraction = offset - down;
        first = static_cast<int>(down) - (elements - 1);
        last = static_cast<int>(down) + points - 1;
        mirrored = fraction == 0 && first < 0;
        if (!mirrored) return;
        const int lowest = first;
        first = last < 0 ? -last : 0;
        last = std::max(std::abs(lowest), std::abs(last));
    }
    std::size_t size() const { return static_cast<std::size_t>(last - first + 1); }
    std::size_t place(int whole) const {
        return static_cast<std::size_t>((mirrored ? std::abs(whole) : whole) - first);
    }
};

template <class Field>
using Arrays = std::array<std::vector<double>, components_of_field<Field>>;

// Returns the field under a unit traction on one element at all offsets; neighbours share their corners.
template <class Field>
Arrays<Field> element_field(const Field& field, Axis load, const TractionPatch& patch, const Offsets& along_x,
                            const Offsets& along_y, double d, const Observer& observer) {
    using Corners = std::vector<typename Field::Components>;
    Arrays<Field> kernels;
    for (auto& kernel : kernels) kernel.resize(along_x.size() * along_y.size());
    Corners lower(along_x.size() + 1), upper(lower);
    const auto fill = [&](Corners& corners, std::size_t line) {
        const double y = (along_y.first + static_cast<int>(line) + along_y.fraction - 0.5) * patch.dy;
        for (std::size_t i = 0; i < corners.size(); ++i)
            corners[i] =
                field.at_corner(load, (along_x.first + static_cast<int>(i) + along_x.fraction - 0.5) * patch.dx, y, d);
    };
    fill(upper, 0);
    for (std::size_t line = 0; line < along_y.size(); ++line) {
        observer.throw_if_cancelled();
        std::swap(lower, upper);
        fill(upper, line + 1);
        for (std::size_t i = 0; i < along_x.size(); ++i)
            for (std::size_t c = 0; c < kernels.size(); ++c)
                kernels[c][line * along_x.size() + i] =
                    (upper[i + 1][c] - upper[i][c]) - (lower[i + 1][c] - lower[i][c]);
    }
    return kernels;
}

template <class Field>
void add_parts(const Field& field, Axis load, const TractionPatch& patch, const Raster& raster, double d,
               Arrays<Field>& sum, const Observer& observer) {
    const int nx = std::max(patch.nx, raster.nx), ny = std::max(patch.ny, raster.ny);
    const PaddedFft fft(nx, ny, padded_size(nx), padded_size(ny));
    const Offsets along_x(patch.nx, raster.nx, raster.offset_x), along_y(patch.ny, raster.ny, raster.offset_y);
    const Arrays<Field> kernels = element_field(field, load, patch, along_x, along_y, d, observer);
    const int whole_x = static_cast<int>(std::floor(raster.offset_x)),
              whole_y = static_cast<int>(std::floor(raster.offset_y));
    const std::size_t columns = static_cast<std::size_t>(2 * nx - 1), size = columns * (2 * ny - 1);
    const auto symbol = [&](std::size_t component) {
        const auto [of_x, of_y] = Field::parity(load, component);
        std::vector<double> values(size);  // zero for offsets that do not occur
        for (int l = 1 - patch.ny; l < raster.ny; ++l)
            for (int k = 1 - patch.nx; k < raster.nx; ++k) {
                const int K = k + whole_x, L = l + whole_y;
                const double sign = (along_x.mirrored && K < 0 ? of_x : 1) * (along_y.mirrored && L < 0 ? of_y : 1);
                values[static_cast<std::size_t>(l + ny - 1) * columns + static_cast<std::size_t>(k + nx - 1)] =
                    sign * kernels[component][along_y.place(L) * along_x.size() + along_x.place(K)];
            }
        return fft.symbol(PaddedFft::SignedKernel{values.data(), nx, ny});
    };
    std::vector<double> in(static_cast<std::size_t>(nx) * ny), first(in.size()), second(in.size());
    const auto copy_rows = [](const std::vector<double>& from, int from_nx, int rows, std::vector<double>& to,
                              int to_nx, const auto& combine) {
        for (int l = 0; l < rows; ++l)
            for (int k = 0; k < std::min(from_nx, to_nx); ++k)
                combine(to[static_cast<std::size_t>(l) * to_nx + k], from[static_cast<std::size_t>(l) * from_nx + k]);
    };
    copy_rows(patch.values, patch.nx, patch.ny, in, nx, [](double& to, double from) { to = from; });
    const auto add_to = [&](const std::vector<double>& values, std::size_t component) {
        copy_rows(values, nx, raster.ny, sum[component], raster.nx, [](double& to, double from) { to += from; });
    };
    for (std::size_t component = 0; component < sum.size(); component += 2) {
        observer.throw_if_cancelled();
        // The last one of an odd number is paired with itself.
        const std::size_t next = std::min(component + 1, sum.size() - 1);
        fft.spread(symbol(component), symbol(next), in, first, second);
        add_to(first, component);
        if (next != component) add_to(second, next);
    }
}

}  // namespace

void add_field(const StressField& field, Axis load, const TractionPatch& patch, const Raster& raster, double d,
               Arrays<StressField>& sum, const Observer& observer) {
    add_parts(field, load, patch, raster, d, sum, observer);
}

void add_field(const DisplacementField& field, Axis load, const TractionPatch& patch, const Raster& raster, double d,
               Arrays<DisplacementField>& sum, const Observer& observer) {
    add_parts(field, load, patch, raster, d, sum, observer);
}

}  // namespace contactd
