// Tests calls that one thread runs and another cancels.
#include <catch2/catch_test_macros.hpp>

#include "cancellable_handle.hpp"

namespace contactd::c {
namespace {

class Asked : public CancellableHandle {
   public:
    Asked() : CancellableHandle(Connection(nullptr), {}, {}) {}
    bool is_stopped() {
        return controlled([](const Control& control) { return control.stop.stop_requested(); });
    }
};

TEST_CASE("A call that has its turn is cancelled before what it asks runs", "[c]") {
    Asked asked;
    const HandleGuard turn(asked.user);
    asked.cancel();
    CHECK(asked.is_stopped());
    CHECK(asked.is_stopped());  // in addition to other checks of the call
}

TEST_CASE("A call is cancelled while what it asks runs", "[c]") {
    struct : Asked {
        bool is_stopped_within() {
            return controlled([this](const Control& control) {
                cancel();
                return control.stop.stop_requested();
            });
        }
    } asked;
    const HandleGuard turn(asked.user);
    CHECK(asked.is_stopped_within());
}

TEST_CASE("To cancel when nothing runs does nothing to later calls", "[c]") {
    Asked asked;
    asked.cancel();
    {
        const HandleGuard turn(asked.user);
        CHECK_FALSE(asked.is_stopped());
        asked.cancel();
    }
    const HandleGuard turn(asked.user);
    CHECK_FALSE(asked.is_stopped());
}

TEST_CASE("A call that is cancelled keeps its turn", "[c]") {
    Asked asked;
    const HandleGuard turn(asked.user);
    asked.cancel();
    CHECK_THROWS_AS(HandleGuard(asked.user), StatusError);
}

}  // namespace
}  // namespace contactd::c
