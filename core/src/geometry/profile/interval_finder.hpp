// Finds the interval between ascending values that contains a value, by buckets of equal width.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace contactd::geometry {

class IntervalFinder {
   public:
    IntervalFinder() = default;
    /// Takes at least two values that do not descend.
    explicit IntervalFinder(std::vector<double> values) : values_(std::move(values)) {
        const std::size_t buckets = 4 * values_.size();
        per_value_ = static_cast<double>(buckets) / (values_.back() - values_.front());
        first_.reserve(buckets + 1);
        for (std::size_t bucket = 0, interval = 0; bucket <= buckets; ++bucket) {
            while (interval + 2 < values_.size() && bucket_of(values_[interval + 1]) < bucket) ++interval;
            first_.push_back(interval);
        }
    }

    /// Returns the last i with values[i] <= value, at most the last interval; value must not be below the first value.
    std::size_t operator()(double value) const {
        std::size_t interval = first_[std::min(bucket_of(value), first_.size() - 1)];
        while (interval + 2 < values_.size() && values_[interval + 1] <= value) ++interval;
        return interval;
    }

    const std::vector<double>& values() const { return values_; }

   private:
    std::size_t bucket_of(double value) const {
        return static_cast<std::size_t>((value - values_.front()) * per_value_);
    }

    std::vector<double> values_;
    std::vector<std::size_t> first_;  // for each bucket: the last interval that begins in it or before
    double per_value_ = 0;
};

}  // namespace contactd::geometry
