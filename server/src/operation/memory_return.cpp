#include "memory_return.hpp"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <utility>

namespace contactd::server {
namespace {

constexpr auto calm = std::chrono::milliseconds(300);
constexpr double worth_it = 16 << 20;  // bytes: less is not missed
// After these times memory is given back once more: the socket frees answers when a slow client has read them.
constexpr std::array<std::chrono::seconds, 3> again_after{std::chrono::seconds(2), std::chrono::seconds(10),
                                                          std::chrono::seconds(60)};

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
    if (quiet_since_ == Clock::time_point::max()) quiet_since_ = now;
    const bool is_worth_it = freed_ >= worth_it;
    next_ = std::max(quiet_since_ + calm, is_worth_it ? quiet_since_ : again_);
    if (now < next_) return;
    if (is_worth_it) times_again_ = 0;
    freed_ = 0;
    again_ = times_again_ < again_after.size() ? now + again_after[times_again_++] : Clock::time_point::max();
    next_ = again_;
    workers_.post({.client = {}, .priority = proto::Priority::low}, [] { ::malloc_trim(0); });
}

}  // namespace contactd::server
