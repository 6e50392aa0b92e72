#include "ic_pair.hpp"

#include <memory>
#include <utility>

namespace contactd::server {
namespace {

struct Pair {
    CallPtr call;
    std::array<std::optional<IcSpec>, 2> specs;
    IcAnswers answers;
    std::function<void(const IcAnswers&)> done;
    std::function<void(const proto::Status&)> failed;
};
using PairPtr = std::shared_ptr<Pair>;

/// Dimensionless tables know nothing of a material but nu, and families not even that.
bool same_table(const Pair& pair) {
    if (!pair.specs[0] || !pair.specs[1]) return false;
    if (static_cast<const Ics&>(*pair.specs[0]) != static_cast<const Ics&>(*pair.specs[1])) return false;
    return pair.specs[0]->material.nu == pair.specs[1]->material.nu || pair.answers[0].record->spec.any_nu;
}

void fetch(const PairPtr& pair, std::size_t body, IcService& ics) {
    if (body == 1 && same_table(*pair)) {
        pair->answers[1] = pair->answers[0];
        body = 2;
    }
    while (body < pair->specs.size() && !pair->specs[body]) ++body;
    if (body == pair->specs.size()) return pair->done(pair->answers);
    ics.request(*pair->specs[body],
                {[pair, body, &ics](const IcAnswer& answer) {
                     pair->answers[body] = answer;
                     try {
                         fetch(pair, body + 1, ics);
                     } catch (const std::exception& error) {
                         pair->failed(status_of(error));
                     }
                 },
                 pair->failed,
                 [pair](const Job& job, const JobProgress& progress) { pair->call->progress(to_json(job, progress)); },
                 turn_of(pair->call)});
}

}  // namespace

void fetch_pair(const CallPtr& call, IcService& ics, const std::array<std::optional<IcSpec>, 2>& specs,
                std::function<void(const IcAnswers&)> done, std::function<void(const proto::Status&)> failed) {
    fetch(std::make_shared<Pair>(Pair{call, specs, {}, std::move(done), std::move(failed)}), 0, ics);
}

}  // namespace contactd::server
