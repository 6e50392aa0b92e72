// Computes one-dimensional transforms by the passes of ducc0, whose number type is Lanes. It requires lane_headers.hpp
// and DUCC0_NAMESPACE, a namespace of this source alone.
#pragma once

#include "lanes.hpp"

// The vectors of ducc0 follow the options of the compiler; Lanes follow CONTACTD_LANES.
#define DUCC0_SIMD_H
namespace DUCC0_NAMESPACE {

template <class T>
using native_simd = ::contactd::Lanes;
template <class T, std::size_t length>
constexpr bool simd_exists = std::is_same_v<T, double> && length == ::contactd::lane_count;
template <class T, int length>
struct simd_select {
    using type = ::contactd::Lanes;
};

}  // namespace DUCC0_NAMESPACE

#define DUCC0_NO_LOWLEVEL_THREADING
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include "ducc0/fft/fft1d_impl.h"
#pragma GCC diagnostic pop

namespace DUCC0_NAMESPACE::detail_threading {

// Transforms of more than 10000 numbers use this scheduler, which runs all work in the calling thread.
class OnePiece final : public Scheduler {
   public:
    explicit OnePiece(std::size_t size) : left_(0, size) {}
    std::size_t num_threads() const override { return 1; }
    std::size_t thread_num() const override { return 0; }
    Range getNext() override { return std::exchange(left_, Range()); }

   private:
    Range left_;
};

void execStatic(std::size_t size, std::size_t, std::size_t, std::function<void(Scheduler&)> work) {
    OnePiece all(size);
    work(all);
}

}  // namespace DUCC0_NAMESPACE::detail_threading

namespace contactd {
namespace {

using Column = DUCC0_NAMESPACE::Cmplx<Lanes>;

/// Each transform overwrites both arrays and returns the one that contains the result. Transforms of real numbers are
/// (r0, r1, i1, r2, i2, ...), n numbers.
class Passes {
   public:
    Passes(std::size_t nx, std::size_t ny)
        : row_(DUCC0_NAMESPACE::detail_fft::rfftpass<double>::make_pass(nx)),
          column_(DUCC0_NAMESPACE::detail_fft::cfftpass<double>::make_pass(ny)) {}

    /// Return the number of values in a third array.
    std::size_t of_row() const { return row_->bufsize(); }
    std::size_t of_column() const { return column_->bufsize(); }

    Lanes* row(Lanes* in, Lanes* other, Lanes* third, bool forward) const {
        static const std::type_index type(typeid(Lanes*));
        return static_cast<Lanes*>(row_->exec(type, in, other, third, forward));
    }
    Column* column(Column* in, Column* other, Column* third, bool forward) const {
        static const std::type_index type(typeid(Column*));
        return static_cast<Column*>(column_->exec(type, in, other, third, forward));
    }

   private:
    const DUCC0_NAMESPACE::detail_fft::Trpass<double> row_;
    const DUCC0_NAMESPACE::detail_fft::Tcpass<double> column_;
};

}  // namespace
}  // namespace contactd
