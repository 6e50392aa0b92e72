#include "last_error.hpp"

#include <atomic>
#include <cstdio>
#include <mutex>
#include <set>
#include <string>

#include "edge/codes.hpp"
#include "edge/exported.hpp"
#include "edge/refused.hpp"

namespace contactd::cntc {
namespace {

struct LastError {
    int code = 0;
    std::string sentence;
};

LastError& last_error() {
    thread_local LastError error;
    return error;
}

std::atomic<bool> prints{true};

/// Returns whether a sentence is new. The number of printed sentences is limited, because a program may produce new
/// ones for ever.
bool is_new(const std::string& sentence) {
    constexpr std::size_t most = 1000;
    static std::mutex mutex;
    static std::set<std::string> printed;
    const std::scoped_lock lock(mutex);
    return printed.size() < most && printed.insert(sentence).second;
}

}  // namespace

void begin_call() noexcept {
    last_error().code = 0;
    last_error().sentence.clear();
}

int report(const char* function) noexcept {
    LastError& error = last_error();
    error.code = error_code::other;
    try {
        const Refused refused = refused_of_exception();
        error.code = refused.code();
        error.sentence = std::string(function) + ": " + refused.what();
        if (prints && is_new(error.sentence)) std::fprintf(stderr, "contactd: %s\n", error.sentence.c_str());
    } catch (...) {  // no memory for the sentence; the code is returned
    }
    return error.code;
}

void warn(const std::string& sentence) noexcept {
    try {
        last_error().sentence = "Warning: " + sentence;
        if (prints && is_new(sentence)) std::fprintf(stderr, "contactd: warning: %s\n", sentence.c_str());
    } catch (...) {  // no memory for the sentence
    }
}

void print_errors(bool enabled) noexcept {
    prints = enabled;
}

}  // namespace contactd::cntc

extern "C" const char* contactd_cntc_last_error(int* code) {
    const auto& error = contactd::cntc::last_error();
    if (code != nullptr) *code = error.code;
    return error.sentence.c_str();
}
