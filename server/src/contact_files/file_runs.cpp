#include "file_runs.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "contactd/proto/status.hpp"
#include "sessions/random_name.hpp"

namespace contactd::server {
namespace {

constexpr std::size_t most_runs = 256, most_bytes = std::size_t{1} << 29;
constexpr std::chrono::minutes longest_wait{10};

}  // namespace

std::string FileRuns::keep(RunPtr run, std::string name) {
    if (name.empty()) name = random_name();
    const std::scoped_lock lock(mutex_);
    runs_.push_back({name, std::move(run), Clock::now()});
    forget_old();
    return name;
}

FileRuns::RunPtr FileRuns::take(const std::string& name) {
    const std::scoped_lock lock(mutex_);
    forget_old();
    const auto found = std::ranges::find(runs_, name, &Kept::name);
    if (found == runs_.end())
        throw proto::StatusError(
            proto::StatusCode::not_found, proto::reason::run_unknown,
            "The run does not exist, is in use, or was not continued for ten minutes; begin again.");
    RunPtr run = std::move(found->run);
    runs_.erase(found);
    return run;
}

void FileRuns::forget_old() {
    const Clock::time_point oldest = Clock::now() - longest_wait;
    const auto bytes = [this] {
        std::size_t sum = 0;
        for (const Kept& kept : runs_) sum += kept.run->bytes();
        return sum;
    };
    while (!runs_.empty() &&
           (runs_.front().since < oldest || runs_.size() > most_runs || (runs_.size() > 1 && bytes() > most_bytes)))
        runs_.pop_front();
}

}  // namespace contactd::server
