// What contactd-ic says: one JSON object a line on standard output, flushed.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::ic {

/// {"error": {"field", "message", "kind"}}; `kind` is "out_of_memory" or, for all else, left out.
nlohmann::json error_line(const std::string& field, const std::string& message, const std::string& kind = "");

class Lines {
   public:
    void write(const nlohmann::json& line);
    /// The last word of a failing run: an error_line, and the sentence on standard error.
    void write_error(const std::string& field, const std::string& message, const std::string& kind = "");
    /// A table that could not be written: {"table_bytes": n, "problem"}, and then n bytes.
    void write_table(const std::vector<unsigned char>& bytes, const std::string& problem);
    /// A line from another thread, left out when a reader that does not read would make it wait.
    void write_unless_stuck(const nlohmann::json& line);

   private:
    std::timed_mutex mutex_;
};

}  // namespace contactd::ic
