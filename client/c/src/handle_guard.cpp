#include "handle_guard.hpp"

#ifndef _WIN32
#include <pthread.h>
#endif

namespace contactd::c {
namespace {

std::atomic<int> forks = 1;
#ifndef _WIN32  // which has no fork
[[maybe_unused]] const int counted = ::pthread_atfork(nullptr, nullptr, [] { ++forks; });
#endif

}  // namespace

int generation() noexcept {
    return forks.load(std::memory_order_relaxed);
}

}  // namespace contactd::c
