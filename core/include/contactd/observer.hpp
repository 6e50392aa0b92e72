// How a computation reports and is ended: the caller passes an observer, the solver never prints.
#pragma once

#include <optional>
#include <string_view>

#include "contactd/error.hpp"

namespace contactd {

struct Progress {
    std::string_view stage;  ///< "normal", "tangential", "assembly", "amg_setup", "pcg", "sampling", ...
    double fraction = 0;     ///< of the whole computation, 0..1, an estimate
    int iteration = 0;       ///< within the stage
    double residual = 0;     ///< the figure the stage's stopping criterion compares, 0 when it has none
    /// A step that begins now and reports nothing until it ends (a factorisation) has the time it is expected to take
    /// (s), and the fraction at its end.
    double step_seconds = 0;
    double step_fraction = 0;
    std::optional<double> seconds_left = std::nullopt;  ///< of the whole computation, where it can be predicted
};

/// Methods are called from the thread that computes. The default observer listens to nothing and never cancels.
class Observer {
   public:
    virtual ~Observer() = default;
    virtual void on_progress(const Progress&) {}
    /// Asked between iterations; when true the solver throws Cancelled.
    virtual bool cancelled() const { return false; }
    /// In whose name it computes, for what it has others make, such as tables; empty where there are no users.
    virtual std::string_view user() const { return {}; }

    void throw_if_cancelled() const {
        if (cancelled()) throw Cancelled();
    }
};

}  // namespace contactd
