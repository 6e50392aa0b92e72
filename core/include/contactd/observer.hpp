// Reports progress and cancels a computation: the caller passes an observer, and the solver never prints.
#pragma once

#include <optional>
#include <string_view>

#include "contactd/error.hpp"

namespace contactd {

struct Progress {
    std::string_view stage;  ///< "normal", "tangential", "assembly", "amg_setup", "pcg", "sampling", ...
    double fraction = 0;     ///< estimated fraction of the whole computation, 0..1
    int iteration = 0;       ///< within the stage
    double residual = 0;     ///< the value of the stage's stopping criterion, 0 without one
    /// A step that begins now and does not report until its end (a factorisation) has this expected time (s), and this
    /// fraction at its end.
    double step_seconds = 0;
    double step_fraction = 0;
    std::optional<double> seconds_left = std::nullopt;  ///< time for the whole computation, if it can be predicted
};

/// Methods are called from the computing thread. The default observer ignores reports and never cancels.
class Observer {
   public:
    virtual ~Observer() = default;
    virtual void on_progress(const Progress&) {}
    /// Called between iterations; if it returns true, the solver throws Cancelled.
    virtual bool cancelled() const { return false; }
    /// Returns the user of the computation, for its requests such as tables; empty without users.
    virtual std::string_view user() const { return {}; }

    void throw_if_cancelled() const {
        if (cancelled()) throw Cancelled();
    }
};

}  // namespace contactd
