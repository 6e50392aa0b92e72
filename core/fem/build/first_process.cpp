#include "first_process.hpp"

#include <algorithm>
#include <chrono>
#include <thread>
#include <vector>

#include "contactd/error.hpp"
#include "contactd/ic_exchange.hpp"

namespace contactd::fem {
namespace {

constexpr auto nap = std::chrono::milliseconds(2);

void broadcast(MPI_Comm comm, char* data, int size) {
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibcast(data, size, MPI_CHAR, 0, comm, &request);
    int done = 0;
    for (;;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done) return;
        std::this_thread::sleep_for(nap);
    }
}

/// Encodes the result of the work as a text: its kind and, for an InvalidArgument, its field.
enum class Kind : char { record, invalid_argument, not_converged, cancelled };

struct Outcome {
    Kind kind = Kind::record;
    std::string field, text;
};

Outcome outcome_of(const std::function<IcRecord()>& build, IcRecord& record) {
    try {
        record = build();
        const std::vector<unsigned char> bytes = to_ic_file(record);
        return {Kind::record, "", std::string(bytes.begin(), bytes.end())};
    } catch (const InvalidArgument& error) {
        return {Kind::invalid_argument, error.field(), error.problem()};
    } catch (const NotConverged& error) {
        return {Kind::not_converged, "", error.what()};
    } catch (const Cancelled& error) {
        return {Kind::cancelled, "", error.what()};
    }
}

}  // namespace

std::string quiet_broadcast(MPI_Comm comm, std::string text) {
    unsigned long long size = text.size();
    broadcast(comm, reinterpret_cast<char*>(&size), sizeof size);
    text.resize(size);
    constexpr std::size_t most = std::size_t{1} << 30;  // MPI counts are ints.
    for (std::size_t at = 0; at < text.size(); at += most)
        broadcast(comm, text.data() + at, static_cast<int>(std::min(most, text.size() - at)));
    return text;
}

IcRecord on_first_process(MPI_Comm comm, const std::function<IcRecord()>& build) {
    int rank = 0;
    MPI_Comm_rank(comm, &rank);
    IcRecord record;
    Outcome outcome;
    if (rank == 0) outcome = outcome_of(build, record);
    const std::string kind = quiet_broadcast(comm, std::string(1, static_cast<char>(outcome.kind)));
    outcome.field = quiet_broadcast(comm, outcome.field);
    outcome.text = quiet_broadcast(comm, outcome.text);
    switch (static_cast<Kind>(kind.front())) {
        case Kind::invalid_argument:
            throw InvalidArgument(outcome.field, outcome.text);
        case Kind::not_converged:
            throw NotConverged(outcome.text);
        case Kind::cancelled:
            throw Cancelled(outcome.text);
        case Kind::record:
            break;
    }
    if (rank == 0) return record;
    return from_ic_file(std::vector<unsigned char>(outcome.text.begin(), outcome.text.end()), "of the first process");
}

}  // namespace contactd::fem
