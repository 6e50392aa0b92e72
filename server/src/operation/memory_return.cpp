#include "memory_return.hpp"

#include <malloc.h>

#include <utility>

namespace contactd::server {
namespace {

constexpr auto calm = std::chrono::milliseconds(300);
constexpr double worth_it = 16 << 20;  // bytes: less is not missed

}  // namespace

void MemoryReturn::look(Clock::time_point now, bool is_busy, std::size_t kept) {
    const WorkBudget::Use use = budget_.use();
    freed_ += use.so_far - std::exchange(seen_, use.so_far);
    const std::size_t before = std::exchange(kept_, kept);
    if (kept < before) freed_ += static_cast<double>(before - kept);
    if (is_busy || use.under_way > 0) {
        quiet_since_ = Clock::time_point::max();
        next_ = now + calm;
        return;
    }
    next_ = Clock::time_point::max();
    if (freed_ < worth_it) return;
    if (quiet_since_ == Clock::time_point::max()) quiet_since_ = now;
    next_ = quiet_since_ + calm;
    if (now < next_) return;
    freed_ = 0;
    quiet_since_ = next_ = Clock::time_point::max();
    workers_.post({.client = {}, .priority = proto::Priority::low}, [] { ::malloc_trim(0); });
}

}  // namespace contactd::server
