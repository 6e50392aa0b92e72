// Computes transforms in lanes: each lane of a vector register has its own row or column.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace contactd {

/// Holds transformed rows: shape [groups, height, 2, lanes], real parts before imaginary ones. Neighbouring columns
/// form a group; those beyond padded_nx/2, which fill up the last one, are zero.
struct LaneSpectrum {
    double* values;
    std::size_t height;  ///< a multiple of the lanes
};

/// Holds a symbol without parity, of one group of columns: shape [padded_ny, lanes] each.
struct ComplexFactor {
    const double *real, *imag;
};

/// Computes one-dimensional transforms of real rows of padded_nx numbers and complex columns of padded_ny numbers, as
/// many at once as there are lanes. Forward transforms sum with exp(-2 pi i j k/n), inverse ones with exp(2 pi i j
/// k/n), and neither divides by n. The caller provides work arrays, aligned to 64 bytes, so that calls may come from
/// several threads at once.
class LaneFft {
   public:
    /// Creates transforms. `lanes` is one of possible_lanes(). Any size works; products of 2, 3 and 5 are fast.
    static std::unique_ptr<const LaneFft> make(int padded_nx, int padded_ny, std::size_t lanes);

    virtual ~LaneFft() = default;

    virtual std::size_t lanes() const = 0;
    /// Returns the size of a work array, of rows or of columns.
    virtual std::size_t work_size() const = 0;

    /// Transforms `count` rows of `length` <= padded_nx numbers each, with zeros beyond, to the first rows of
    /// `spectrum`.
    virtual void rows_forward(const double* rows, std::size_t count, std::size_t length, LaneSpectrum spectrum,
                              double* work) const = 0;
    /// Transforms them back to the first `length` numbers of each row.
    virtual void rows_inverse(LaneSpectrum spectrum, std::size_t count, std::size_t length, double* rows,
                              double* work) const = 0;
    /// Transforms the columns of a group, which have `count` <= padded_ny numbers, with zeros beyond. Returns the
    /// position of the result in `work`, of shape [padded_ny, 2, lanes].
    virtual double* columns_forward(const double* group, std::size_t count, double* work) const = 0;
    /// Returns a position in `work` for transformed columns that the caller fills.
    virtual double* columns_of(double* work) const = 0;
    /// Transforms columns back, from such a position in `work` to the first `count` numbers of each column.
    virtual void columns_inverse(double* transformed, double* work, std::size_t count, double* group) const = 0;

    /// Multiplies transformed columns by symbols, in place: x = s x.
    virtual void multiply(double* x, const double* s) const = 0;
    virtual void multiply(double* x, const ComplexFactor& s) const = 0;
    /// Computes (x, y) = [[xx, xy], [yx, yy]] (x, y).
    virtual void multiply(double* x, double* y, const double* xx, const double* xy, const double* yx,
                          const double* yy) const = 0;
    virtual void multiply(double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                          const ComplexFactor& yx, const ComplexFactor& yy) const = 0;
    /// Computes x = i (of_x x + of_y y).
    virtual void gather(double* x, const double* y, const double* of_x, const double* of_y) const = 0;
    /// Computes x = of_x x + of_y y.
    virtual void gather(double* x, const double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const = 0;
    /// Computes (x, y) = (i of_x x, i of_y x).
    virtual void spread(double* x, double* y, const double* of_x, const double* of_y) const = 0;
    /// Computes (x, y) = (of_x x, of_y x).
    virtual void spread(double* x, double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const = 0;
};

/// Returns the numbers of lanes that this program has transforms for and this processor supports, in ascending order.
std::vector<std::size_t> possible_lanes();
/// Returns the number that is `asked` for, or the largest possible one if that is null or empty. Throws InvalidArgument
/// for any other.
std::size_t lanes_by_name(const char* asked);
/// Returns the number of lanes by the environment variable CONTACTD_LANES, which is read once per program.
std::size_t default_lanes();
/// Returns the name and the version of the transform library.
std::pair<const char*, const char*> fft_library();

}  // namespace contactd
