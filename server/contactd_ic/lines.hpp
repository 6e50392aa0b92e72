// Output of contactd-ic: one JSON object a line on standard output, flushed.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::ic {

/// Why a run fails.
struct Complaint {
    std::string field;      ///< of the specification; empty when it is none
    std::string message;    ///< a whole sentence
    std::string kind{};     ///< "out_of_memory", "invalid_argument", or empty for all else
    std::string problem{};  ///< of an invalid argument: the message without the field
};

/// {"error": {"field", "message", "kind", "problem"}}; what is empty is left out, but for field and message.
nlohmann::json error_line(const Complaint& complaint);

class Lines {
   public:
    void write(const nlohmann::json& line);
    /// The last word of a failing run: an error_line, and the sentence on standard error.
    void write_error(const Complaint& complaint);
    /// A table that could not be written: {"table_bytes": n, "problem"}, and then n bytes.
    void write_table(const std::vector<unsigned char>& bytes, const std::string& problem);
    /// A line from another thread, left out when a reader that does not read would make it wait.
    void write_unless_stuck(const nlohmann::json& line);

   private:
    std::timed_mutex mutex_;
};

}  // namespace contactd::ic
