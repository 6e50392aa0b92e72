#include "handle_guard.hpp"

#include <pthread.h>

namespace contactd::c {
namespace {

std::atomic<int> forks = 1;
[[maybe_unused]] const int counted = ::pthread_atfork(nullptr, nullptr, [] { ++forks; });

}  // namespace

int generation() noexcept {
    return forks.load(std::memory_order_relaxed);
}

}  // namespace contactd::c
