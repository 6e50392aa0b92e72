// Defines arrays for transforms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace contactd {

/// Holds numbers that are initially zero, aligned for all vector registers.
class LaneBuffer {
   public:
    LaneBuffer() = default;
    explicit LaneBuffer(std::size_t size)
        : values_(static_cast<double*>(operator new(size * sizeof(double), alignment))) {
        std::fill_n(values_.get(), size, 0.0);
    }
    double* get() const { return values_.get(); }

   private:
    static constexpr std::align_val_t alignment{64};
    struct Free {
        void operator()(double* values) const { operator delete(values, alignment); }
    };
    std::unique_ptr<double[], Free> values_;
};

}  // namespace contactd
