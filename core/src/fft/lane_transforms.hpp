// Implements LaneFft by one-dimensional passes. It requires Lanes, Column and Passes.
#pragma once

namespace contactd {
namespace {

class Transforms final : public LaneFft {
   public:
    Transforms(std::size_t nx, std::size_t ny)
        : nx_(nx),
          ny_(ny),
          groups_((nx / 2 + lane_count) / lane_count),
          passes_(nx, ny),
          skip_x_(skip(nx)),
          skip_y_(skip(ny)) {}

    std::size_t lanes() const override { return lane_count; }
    std::size_t work_size() const override {
        const std::size_t row = 2 * skip_x_ + passes_.of_row(), column = 2 * skip_y_ + passes_.of_column();
        return lane_count * std::max(row, 2 * column);
    }

    void rows_forward(const double* rows, std::size_t count, std::size_t length, LaneSpectrum spectrum,
                      double* work) const override {
        Lanes *in = row_in(work), *other = in + skip_x_, *third = other + skip_x_ - margin;
        for (std::size_t first = 0; first < count; first += lane_count) {
            const double* from[lane_count];  // Rows beyond the last one repeat it, and their results are not used.
            for (std::size_t r = 0; r < lane_count; ++r) from[r] = rows + std::min(first + r, count - 1) * length;
            const std::size_t numbers = std::min(lane_count, count - first) * length;
            if (std::all_of(from[0], from[0] + numbers, [](double value) { return value == 0; })) {
                for (std::size_t g = 0; g < groups_; ++g)
                    std::fill_n(row_of(spectrum, g, first), 2 * lane_count * lane_count, 0.0);
                continue;
            }
            std::size_t k = 0;
            for (; k + lane_count <= length; k += lane_count) {
                Lanes block[lane_count];
                for (std::size_t r = 0; r < lane_count; ++r) block[r] = load(from[r] + k);
                transpose(block);
                for (std::size_t r = 0; r < lane_count; ++r) in[k + r] = block[r];
            }
            for (; k < length; ++k)
                for (std::size_t r = 0; r < lane_count; ++r) in[k][r] = from[r][k];
            for (; k < nx_; ++k) in[k] = 0.0;
            const Lanes* out = passes_.row(in, other, third, true);
            for_groups([&](std::size_t g, auto within) {
                Lanes re[lane_count], im[lane_count];
                for (std::size_t c = 0; c < lane_count; ++c) {
                    const std::size_t wave = g * lane_count + c;
                    re[c] = within || has_real(wave) ? out[place(wave)] : Lanes(0.0);
                    im[c] = within || has_imaginary(wave) ? out[2 * wave] : Lanes(0.0);
                }
                transpose(re);
                transpose(im);
                double* to = row_of(spectrum, g, first);
                for (std::size_t r = 0; r < lane_count; ++r, to += 2 * lane_count) {
                    store(re[r], to);
                    store(im[r], to + lane_count);
                }
            });
        }
    }

    void rows_inverse(LaneSpectrum spectrum, std::size_t count, std::size_t length, double* rows,
                      double* work) const override {
        Lanes *in = row_in(work), *other = in + skip_x_, *third = other + skip_x_ - margin;
        for (std::size_t first = 0; first < count; first += lane_count) {
            for_groups([&](std::size_t g, auto within) {
                Lanes re[lane_count], im[lane_count];
                const double* from = row_of(spectrum, g, first);
                for (std::size_t r = 0; r < lane_count; ++r, from += 2 * lane_count) {
                    re[r] = load(from);
                    im[r] = load(from + lane_count);
                }
                transpose(re);
                transpose(im);
                for (std::size_t c = 0; c < lane_count; ++c) {
                    const std::size_t wave = g * lane_count + c;
                    if (within || has_real(wave)) in[place(wave)] = re[c];
                    if (within || has_imaginary(wave)) in[2 * wave] = im[c];
                }
            });
            const Lanes* out = passes_.row(in, other, third, false);
            const std::size_t there = std::min(lane_count, count - first);
            double* to = rows + first * length;
            std::size_t k = 0;
            for (; k + lane_count <= length; k += lane_count) {
                Lanes block[lane_count];
                for (std::size_t r = 0; r < lane_count; ++r) block[r] = out[k + r];
                transpose(block);
                for (std::size_t r = 0; r < there; ++r) store(block[r], to + r * length + k);
            }
            for (; k < length; ++k)
                for (std::size_t r = 0; r < there; ++r) to[r * length + k] = out[k][r];
        }
    }

    double* columns_forward(const double* group, std::size_t count, double* work) const override {
        Column *in = column_in(work), *other = in + skip_y_;
        const Column* from = reinterpret_cast<const Column*>(group);
        for (std::size_t l = 0; l < count; ++l) in[l] = from[l];
        for (std::size_t l = count; l < ny_; ++l) in[l] = Column(0.0, 0.0);
        return reinterpret_cast<double*>(passes_.column(in, other, other + skip_y_ - margin, true));
    }

    double* columns_of(double* work) const override { return reinterpret_cast<double*>(column_in(work)); }

    void columns_inverse(double* transformed, double* work, std::size_t count, double* group) const override {
        Column *in = column_in(work), *other = in + skip_y_, *third = other + skip_y_ - margin;
        Column *from = reinterpret_cast<Column*>(transformed), *to = reinterpret_cast<Column*>(group);
        const Column* result = passes_.column(from, from == in ? other : in, third, false);
        for (std::size_t l = 0; l < count; ++l) to[l] = result[l];
    }

    void multiply(double* x, const double* s) const override {
        for_columns(x, [=](Column& a, std::size_t at) {
            const Lanes factor = load(s + at);
            a.r *= factor;
            a.i *= factor;
        });
    }
    void multiply(double* x, const ComplexFactor& s) const override {
        for_columns(x, [=](Column& a, std::size_t at) { a = product(a, s, at); });
    }
    void multiply(double* x, double* y, const double* xx, const double* xy, const double* yx,
                  const double* yy) const override {
        for_columns(x, y, [=](Column& a, Column& b, std::size_t at) {
            const Lanes of_xx = load(xx + at), of_xy = load(xy + at), of_yx = load(yx + at), of_yy = load(yy + at);
            const Column was = a;
            a = Column(of_xx * was.r + of_xy * b.r, of_xx * was.i + of_xy * b.i);
            b = Column(of_yx * was.r + of_yy * b.r, of_yx * was.i + of_yy * b.i);
        });
    }
    void multiply(double* x, double* y, const ComplexFactor& xx, const ComplexFactor& xy, const ComplexFactor& yx,
                  const ComplexFactor& yy) const override {
        for_columns(x, y, [=](Column& a, Column& b, std::size_t at) {
            const Column was = a;
            a = product(was, xx, at) + product(b, xy, at);
            b = product(was, yx, at) + product(b, yy, at);
        });
    }
    void gather(double* x, const double* y, const double* of_x, const double* of_y) const override {
        const Column* ys = reinterpret_cast<const Column*>(y);
        for_columns(x, [=](Column& a, std::size_t at) {
            const Column& b = ys[at / lane_count];
            const Lanes s = load(of_x + at), t = load(of_y + at);
            a = Column(-(s * a.i + t * b.i), s * a.r + t * b.r);
        });
    }
    void gather(double* x, const double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const override {
        const Column* ys = reinterpret_cast<const Column*>(y);
        for_columns(
            x, [=](Column& a, std::size_t at) { a = product(a, of_x, at) + product(ys[at / lane_count], of_y, at); });
    }
    void spread(double* x, double* y, const double* of_x, const double* of_y) const override {
        for_columns(x, y, [=](Column& a, Column& b, std::size_t at) {
            const Column rotated(-a.i, a.r);
            const Lanes s = load(of_x + at), t = load(of_y + at);
            a = Column(s * rotated.r, s * rotated.i);
            b = Column(t * rotated.r, t * rotated.i);
        });
    }
    void spread(double* x, double* y, const ComplexFactor& of_x, const ComplexFactor& of_y) const override {
        for_columns(x, y, [=](Column& a, Column& b, std::size_t at) {
            const Column was = a;
            a = product(was, of_x, at);
            b = product(was, of_y, at);
        });
    }

   private:
    // A transform may use `margin` numbers before and behind each array. `apart` separates arrays that would otherwise
    // map to the same cache lines.
    static constexpr std::size_t margin = 2, apart = 8;
    static std::size_t skip(std::size_t n) { return n + 2 * margin + (n % 64 == 0 ? apart : 0); }

    static Lanes* row_in(double* work) { return reinterpret_cast<Lanes*>(work) + margin; }
    static Column* column_in(double* work) { return reinterpret_cast<Column*>(work) + margin; }

    double* row_of(const LaneSpectrum& spectrum, std::size_t g, std::size_t row) const {
        return spectrum.values + (g * spectrum.height + row) * 2 * lane_count;
    }
    bool has_real(std::size_t wave) const { return 2 * wave <= nx_; }
    bool has_imaginary(std::size_t wave) const { return wave > 0 && 2 * wave < nx_; }
    static std::size_t place(std::size_t wave) { return wave == 0 ? 0 : 2 * wave - 1; }

    // Calls each(group, std::true_type) where all waves of the group have real and imaginary parts, and
    // each(group, std::false_type) for the others.
    template <class Each>
    void for_groups(const Each& each) const {
        // From the second group to this one, all waves have both parts.
        const std::size_t whole = (nx_ + 1) / 2 / lane_count;
        each(0, std::false_type());
        for (std::size_t g = 1; g < whole; ++g) each(g, std::true_type());
        for (std::size_t g = std::max<std::size_t>(whole, 1); g < groups_; ++g) each(g, std::false_type());
    }

    template <class Each>
    void for_columns(double* x, const Each& each) const {
        Column* a = reinterpret_cast<Column*>(x);
        for (std::size_t l = 0; l < ny_; ++l) each(a[l], l * lane_count);
    }
    template <class Each>
    void for_columns(double* x, double* y, const Each& each) const {
        Column *a = reinterpret_cast<Column*>(x), *b = reinterpret_cast<Column*>(y);
        for (std::size_t l = 0; l < ny_; ++l) each(a[l], b[l], l * lane_count);
    }
    static Column product(const Column& a, const ComplexFactor& s, std::size_t at) {
        const Lanes re = load(s.real + at), im = load(s.imag + at);
        return Column(re * a.r - im * a.i, re * a.i + im * a.r);
    }

    const std::size_t nx_, ny_, groups_;
    const Passes passes_;
    const std::size_t skip_x_, skip_y_;
};

}  // namespace
}  // namespace contactd
