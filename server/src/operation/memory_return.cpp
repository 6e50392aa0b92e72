#include "memory_return.hpp"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace contactd::server {
namespace {

constexpr auto calm = std::chrono::milliseconds(300);
constexpr double worth_it = 16 << 20;  // bytes; smaller amounts may stay allocated
// After these times memory is returned once more, because the socket frees answers when a slow client has read them.
constexpr std::array<std::chrono::seconds, 3> again_after{std::chrono::seconds(2), std::chrono::seconds(10),
                                                          std::chrono::seconds(60)};

constexpr int smallest_end = 1 << 17, largest_end = 1 << 26, smallest_mapping = 1 << 25;  // bytes, those of glibc
constexpr std::size_t noticed = 96 << 10;  // bytes to free before the allocator checks the end of an arena

/// Returns the end of this thread's arena to the system, because malloc_trim does that for the first arena only.
void give_end_of_arena_back() {
    static std::mutex one_at_a_time;
    const std::scoped_lock lock(one_at_a_time);
    ::mallopt(M_TRIM_THRESHOLD, smallest_end);
    void* volatile const piece = std::malloc(noticed);
    std::free(piece);
    // The allocator learns these values by itself from large arrays, but not after mallopt has set one of them.
    ::mallopt(M_TRIM_THRESHOLD, largest_end);
    ::mallopt(M_MMAP_THRESHOLD, smallest_mapping);
}

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
    give_end_of_arena_back();
    workers_.each_when_idle(give_end_of_arena_back);
    if (others_ != nullptr) others_->each_when_idle(give_end_of_arena_back);
    workers_.post({.client = {}, .priority = proto::Priority::low}, [] { ::malloc_trim(0); });
}

}  // namespace contactd::server
