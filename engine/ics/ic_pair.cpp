#include "ic_pair.hpp"

#include <memory>
#include <utility>

namespace contactd::engine {
namespace {

struct Pair {
    std::array<std::optional<IcSpec>, 2> specs;
    IcPairCaller caller;
    IcAnswers answers{};
};
using PairPtr = std::shared_ptr<Pair>;

void fetch(const PairPtr& pair, std::size_t body, IcService& ics) {
    if (body == 1 && serves_both(pair->answers[0], pair->specs)) {
        pair->answers[1] = pair->answers[0];
        body = 2;
    }
    while (body < pair->specs.size() && !pair->specs[body]) ++body;
    if (body == pair->specs.size()) return pair->caller.done(pair->answers);
    ics.request(*pair->specs[body], {[pair, body, &ics](const IcAnswer& answer) {
                                         pair->answers[body] = answer;
                                         try {
                                             fetch(pair, body + 1, ics);
                                         } catch (const std::exception& error) {
                                             pair->caller.failed(status_of(error));
                                         }
                                     },
                                     pair->caller.failed, pair->caller.progress, pair->caller.ticket});
}

}  // namespace

bool serves_both(const IcAnswer& upper, const std::array<std::optional<IcSpec>, 2>& specs) {
    if (!specs[0] || !specs[1]) return false;
    if (static_cast<const Ics&>(*specs[0]) != static_cast<const Ics&>(*specs[1])) return false;
    return specs[0]->material.nu == specs[1]->material.nu || upper.record->spec.any_nu;
}

void fetch_pair(IcService& ics, const std::array<std::optional<IcSpec>, 2>& specs, IcPairCaller caller) {
    fetch(std::make_shared<Pair>(Pair{specs, std::move(caller)}), 0, ics);
}

}  // namespace contactd::engine
