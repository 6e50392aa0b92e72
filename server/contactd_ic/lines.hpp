// Writes the output of contactd-ic: one JSON object per line on standard output, flushed.
#pragma once

#include <mutex>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace contactd::ic {

/// Holds the reason of a failed run.
struct Complaint {
    std::string field;      ///< field of the specification; empty for other errors
    std::string message;    ///< a whole sentence
    std::string kind{};     ///< "out_of_memory", "invalid_argument", or empty for all else
    std::string problem{};  ///< for an invalid argument: the message without the field
};

/// {"error": {"field", "message", "kind", "problem"}}; empty members are omitted, except for field and message.
nlohmann::json error_line(const Complaint& complaint);

class Lines {
   public:
    void write(const nlohmann::json& line);
    /// Writes the last message of a failing run: an error_line, and the sentence on standard error.
    void write_error(const Complaint& complaint);
    /// Writes a table whose file could not be written: {"table_bytes": n, "problem"}, and then n bytes.
    void write_table(const std::vector<unsigned char>& bytes, const std::string& problem);
    /// Writes a line from another thread, or drops it if it would have to wait for the reader.
    void write_unless_stuck(const nlohmann::json& line);

   private:
    std::timed_mutex mutex_;
};

}  // namespace contactd::ic
