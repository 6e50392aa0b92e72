// Reads a builder's output: JSON lines on standard output, messages on standard error, and a table if it could not
// store it.
#pragma once

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json.hpp>

#include "builder.hpp"
#include "engine/jobs/job.hpp"

namespace contactd::engine {

class BuilderListener {
   public:
    using Clock = std::chrono::steady_clock;
    using OnProgress = std::function<void(const JobProgress&)>;

    /// A builder started by a launcher may wait for machines, so its silence counts from its first message.
    BuilderListener(bool has_launcher, OnProgress on_progress)
        : has_begun_(!has_launcher), on_progress_(std::move(on_progress)) {}

    void hear_output(std::string_view bytes);
    void hear_error(std::string_view bytes);

    /// Returns the longest silence among the builder's processes.
    Clock::duration silence() const;
    /// Returns the builder's error message, or else the end of its standard error.
    std::string complaint() const;
    bool ran_out_of_memory() const { return kind_ == "out_of_memory"; }
    bool refused() const { return kind_ == "invalid_argument"; }
    /// Returns the field of the request that the builder refuses, or an empty text.
    const std::string& field() const { return field_; }
    /// Returns the problem of a refused field, without its name.
    const std::string& problem() const { return problem_; }
    /// Returns the table that the builder printed because it could not write it.
    BuiltTable take_table() { return awaited_ == 0 ? std::move(table_) : BuiltTable(); }

   private:
    void hear_line(std::string_view line);
    void hear_heartbeat(const nlohmann::json& line);
    void hear_progress(const nlohmann::json& line);

    bool has_begun_;
    const OnProgress on_progress_;
    std::string line_, messages_, complaint_, field_, problem_, kind_;
    std::size_t awaited_ = 0;  ///< bytes of the table that are still to come
    BuiltTable table_;
    std::map<int, Clock::time_point> heard_{{0, Clock::now()}};  ///< by process
};

}  // namespace contactd::engine
