#include "guard.hpp"

#include <poll.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>

#include "memory.hpp"

namespace contactd::ic {
namespace {

constexpr int signal_base = 128;  // A program ended by signal n exits with 128 + n, as in shells.
constexpr auto longest_wait = std::chrono::seconds(2);
constexpr auto heartbeat_interval = std::chrono::milliseconds(250);  // a daemon may expect a heartbeat each second
constexpr auto least_work = std::chrono::milliseconds(1);            // exceeds the time the guard needs for a heartbeat

sigset_t ending_signals() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) sigaddset(&set, signal);
    return set;
}

/// Reads the available input. Returns true at its end.
bool input_has_ended(short events) {
    if (events & POLLNVAL) return true;
    std::array<char, 256> ignored;
    const ssize_t size = ::read(STDIN_FILENO, ignored.data(), ignored.size());
    return size == 0 || (size < 0 && errno != EINTR && errno != EAGAIN);
}

}  // namespace

void hold_signals_back() {
    const sigset_t set = ending_signals();
    pthread_sigmask(SIG_BLOCK, &set, nullptr);
}

Guard::Guard(Lines& lines, bool silent) : lines_(lines), silent_(silent) {
    const sigset_t set = ending_signals();
    signals_ = ::signalfd(-1, &set, SFD_CLOEXEC);
    wake_ = ::eventfd(0, EFD_CLOEXEC);
    if (signals_ < 0 || wake_ < 0) throw Error("Cannot watch for signals: no file descriptor is available.");
    thread_ = std::thread([this] { watch(); });
}

Guard::~Guard() {
    stand_down();
    thread_.join();
    ::close(signals_);
    ::close(wake_);
}

void Guard::watch_standard_input() {
    watching_input_ = true;
    ::eventfd_write(wake_, 1);
}

void Guard::watch_memory(std::vector<pid_t> processes, std::uint64_t bytes) {
    watched_processes_ = std::move(processes);
    most_memory_ = bytes;
    ::eventfd_write(wake_, 1);
}

void Guard::beat(int rank, int processes, ProgressLines& progress) {
    progress_ = &progress;
    processes_ = processes;
    rank_ = rank;
    ::eventfd_write(wake_, 1);
}

/// Writes a heartbeat when it is due. Returns the time until the next one, or -1 if there will be none.
int Guard::milliseconds_to_beat() {
    if (rank_ < 0) return -1;
    const auto now = std::chrono::steady_clock::now();
    if (now >= next_beat_) {
        next_beat_ = now + heartbeat_interval;
        if (lives()) {
            lines_.write_unless_stuck({{"heartbeat", rank_.load()}, {"processes", processes_.load()}});
            progress_.load()->tick();
        }
    }
    return static_cast<int>(std::chrono::ceil<std::chrono::milliseconds>(next_beat_ - now).count());
}

bool Guard::lives() {
    timespec used{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
    const auto time = std::chrono::seconds(used.tv_sec) + std::chrono::nanoseconds(used.tv_nsec);
    const bool works = time - processor_time_ > least_work;
    processor_time_ = time;
    // The other processes report nothing; they wait for the first process, or it waits for them.
    const bool stuck = rank_ == 0 && progress_.load()->is_stuck();
    return (works || processes_ > 1) && !stuck;
}

/// Checks the memory. Returns the time until the next check, or -1 if there will be none.
int Guard::milliseconds_to_look_at_memory() {
    constexpr int interval = 20;  // A build fills some ten megabytes meanwhile.
    const std::uint64_t most = most_memory_;
    if (most == 0) return -1;
    if (const std::uint64_t used = resident_bytes(watched_processes_); used > most)
        end(out_of_memory,
            "The build ran out of memory: it uses " + std::to_string(used) + " bytes but may use " +
                std::to_string(most) + " bytes (builds.max_memory_bytes).",
            "out_of_memory");
    return interval;
}

void Guard::stand_down() {
    standing_down_ = true;
    ::eventfd_write(wake_, 1);
}

void Guard::watch() {
    while (!standing_down_) {
        // poll ignores a negative descriptor.
        std::array<pollfd, 3> watched{
            {{wake_, POLLIN, 0}, {signals_, POLLIN, 0}, {watching_input_ ? STDIN_FILENO : -1, POLLIN, 0}}};
        const int to_beat = milliseconds_to_beat(), to_look = milliseconds_to_look_at_memory();
        const int wait = to_beat < 0 || (to_look >= 0 && to_look < to_beat) ? to_look : to_beat;
        if (::poll(watched.data(), watched.size(), wait) < 0) continue;
        if (standing_down_) return;
        if (watched[0].revents != 0) {
            eventfd_t ignored;
            ::eventfd_read(wake_, &ignored);
        }
        if (watched[1].revents != 0) {
            signalfd_siginfo info{};
            if (::read(signals_, &info, sizeof info) == sizeof info) {
                const auto signal = static_cast<int>(info.ssi_signo);
                end(signal_base + signal, signal == SIGTERM  ? "The build was terminated by SIGTERM."
                                          : signal == SIGINT ? "The build was terminated by SIGINT."
                                                             : "The build was terminated by SIGHUP.");
            }
        }
        if (watched[2].revents != 0 && input_has_ended(watched[2].revents))
            end(signal_base + SIGHUP, "The build was terminated because its standard input was closed.");
    }
}

void Guard::end(int exit_code, const std::string& why, const std::string& kind) {
    // Lets a file in progress be finished, and prevents a new one: the lock is released only with the process.
    const std::unique_lock<std::timed_mutex> file(writing_, longest_wait);
    if (standing_down_) return;
    ::signal(SIGPIPE, SIG_IGN);
    if (!silent_ || !kind.empty()) lines_.write_unless_stuck(error_line({"", why, kind}));
    ::_exit(exit_code);
}

}  // namespace contactd::ic
