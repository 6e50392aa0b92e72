#include "warnings.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace contactd::client {
namespace {

struct Part {
    const char* name;   ///< in answers
    const char* shown;  ///< name of the part in the request; empty for the whole
};
/// Lists parts of answers that have their own warnings.
constexpr Part parts[] = {{"result", ""},
                          {"evidence", ""},
                          {"ics", ""},
                          {"upper", ""},
                          {"lower", ""},
                          {"pair", ""},
                          {"wheelrail", ""},
                          {"solution", ""},
                          {"solutions", "problems"},
                          {"steps", "steps"},
                          {"geometries", "states"},
                          {"left", "left"},
                          {"right", "right"},
                          {"patches", "patches"},
                          {"profiles", "profiles"},
                          {"wheel_evidence", "wheel"},
                          {"rail_evidence", "rail"}};

class Collected {
   public:
    void collect(const proto::AnswerValue& value, const std::string& part) {
        if (value.is_array()) {
            std::size_t place = 0;
            for (const auto element : value) collect(element, part + "[" + std::to_string(place++) + "]");
        } else if (value.is_object()) {
            if (const auto warnings = value.find("warnings"); warnings && warnings->is_array())
                for (const auto sentence : *warnings)
                    if (sentence.is_string()) add(std::string(sentence.text()), part);
            for (const auto& [name, shown] : parts)
                if (const auto at = value.find(name)) collect(*at, below(part, shown));
        }
    }
    std::vector<std::string> take() { return std::move(found_); }

   private:
    static std::string below(const std::string& part, const std::string& name) {
        return part.empty() || name.empty() ? part + name : part + "." + name;
    }
    void add(const std::string& sentence, const std::string& part) {
        const auto is_found = [&](const std::string& text) {
            return std::find(found_.begin(), found_.end(), text) != found_.end();
        };
        std::string text = part.empty() ? sentence : part + ": " + sentence;
        if (!is_found(sentence) && !is_found(text)) found_.push_back(std::move(text));  // the whole has it already
    }

    std::vector<std::string> found_;
};

}  // namespace

std::vector<std::string> warnings_in(const std::string& method, const proto::AnswerValue& answer) {
    // These methods list the store without using its tables.
    if (method == "ic.list" || method == "ic.import") return {};
    Collected collected;
    collected.collect(answer, "");
    return collected.take();
}

}  // namespace contactd::client
