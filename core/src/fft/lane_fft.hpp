// Transforms in lanes: each lane of a vector register has a row or a column of its own.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace contactd {

/// What rows are transformed to: shape [groups, height, 2, lanes], real parts before imaginary ones. Columns that are
/// neighbours form a group; those beyond padded_nx/2, which fill up the last one, are zero.
struct LaneSpectrum {
    double* values;
    std::size_t height;  ///< a multiple of the lanes
};

/// A symbol without parity, of one group of columns: shape [padded_ny, lanes] each.
struct ComplexFactor {
    const double *real, *imag;
};

/// One-dimensional transforms of real rows of padded_nx numbers and complex columns of padded_ny numbers, as many at
/// once as there are lanes. Forward ones sum up with exp(-2 pi i j k/n), inverse ones with exp(2 pi i j k/n), and
/// neither divides by n. Work arrays are the caller's, aligned to 64 bytes: calls may come from several threads at
/// once.
class LaneFft {
   public:
    /// `lanes` is one of possible_lanes(). Any size works; products of 2, 3 and 5 are quick.
    static std::unique_ptr<const LaneFft> make(int padded_nx, int padded_ny, std::size_t lanes);

    virtual ~LaneFft() = default;

    virtual std::size_t lanes() const = 0;
    /// Numbers in a work array, of rows or of columns.
    virtual std::size_t work_size() const = 0;

    /// Transforms `count` rows of `length` <= padded_nx numbers each, zero beyond, to the first rows of `spectrum`.
    virtual void rows_forward(const double* rows, std::size_t count, std::size_t length, LaneSpectrum spectrum,
                              double* work) const = 0;
    /// And back: to the first `length` numbers of each row.
    virtual void rows_inverse(LaneSpectrum spectrum, std::size_t count, std::size_t length, double* rows,
                              double* work) const = 0;
    /// Transforms the columns of a group, which have `count` <= padded_ny numbers, zero beyond. Returns where in `work`
    /// the result is, of shape [padded_ny, 2, lanes].
    virtual double* columns_forward(const double* group, std::size_t count, double* work) const = 0;
    /// Returns a place in `work` for transformed columns that no transform has put there.
    virtual double* columns_of(double* work) const = 0;
    /// And back, from such a place in `work` to the first `count` numbers of each column.
    virtual void columns_inverse(double* transformed, double* work, std::size_t count, double* group) const = 0;

    /// Products of transformed columns x, y with symbols, in place: x = s x.
    virtual void multiply(double* x, const double* s) const = 0;
    virtual void multiply(double* x, const ComplexFactor& s) const = 0;
    /// (x, y) = [[xx, xy], [yx, yy]] (x, y)
    virtual void multiply(double* x, double* y, const double* xx, const double* xy, const double* yx,
                          const double* yy) const = 0;
    virtual void multiply(double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy,
                          const ComplexFactor& yx, const ComplexFactor& yy) const = 0;
    /// x = i (of_x x + of_y y)
    virtual void gather(double* x, const double* y, const double* of_x, const double* of_y) const = 0;
    /// x = of_x x + of_y y
    virtual void gather(double* x, const double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const = 0;
    /// (x, y) = (i of_x x, i of_y x)
    virtual void spread(double* x, double* y, const double* of_x, const double* of_y) const = 0;
    /// (x, y) = (of_x x, of_y x)
    virtual void spread(double* x, double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const = 0;
};

/// Lanes that this program has transforms for and this processor registers, the fewest first.
std::vector<std::size_t> possible_lanes();
/// The one of them that is `asked` for, or the most where that is null or empty. Throws InvalidArgument for any other.
std::size_t lanes_by_name(const char* asked);
/// By the environment variable CONTACTD_LANES, once for the program.
std::size_t default_lanes();
/// Returns the name and the version of the library that transforms.
std::pair<const char*, const char*> fft_library();

}  // namespace contactd
