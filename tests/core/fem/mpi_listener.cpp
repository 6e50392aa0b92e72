// Initialises MPI for the duration of the test run.
#include <catch2/reporters/catch_reporter_event_listener.hpp>
#include <catch2/reporters/catch_reporter_registrars.hpp>
#include <optional>

#include "contactd/fem/ic_builder.hpp"

namespace {

class MpiListener : public Catch::EventListenerBase {
   public:
    using Catch::EventListenerBase::EventListenerBase;
    void testRunStarting(const Catch::TestRunInfo&) override {
        int argc = 0;
        char** argv = nullptr;
        runtime_.emplace(argc, argv);
    }
    void testRunEnded(const Catch::TestRunStats&) override { runtime_.reset(); }

   private:
    std::optional<contactd::fem::Runtime> runtime_;
};

}  // namespace

CATCH_REGISTER_LISTENER(MpiListener)
