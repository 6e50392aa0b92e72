// Fuzzes input files of the CONTACT program, and lists of slices if the first byte is an L.
#include <cmath>
#include <variant>

#include "contactd/error.hpp"
#include "contactd/read_contact_file.hpp"
#include "contactd/read_contact_slices.hpp"
#include "input.hpp"

namespace {

void check_sentence(const std::string& sentence) {
    for (const char c : sentence) fuzz::require(c >= ' ' && c <= '~', "sentences can be printed");
}

void check_numbers(const contactd::ByName<contactd::ContactValue>& values) {
    for (const auto& [name, value] : values) {
        if (const auto* number = std::get_if<double>(&value))
            fuzz::require(std::isfinite(*number), "values are finite");
        if (const auto* list = std::get_if<contactd::ContactNumbers>(&value))
            for (const double number : **list) fuzz::require(std::isfinite(number), "lists are finite");
    }
}

void read_cases(std::string_view text) {
    contactd::ContactFileReader reader(text, "a.inp");
    std::size_t line = 0;
    while (const auto read = reader.next()) {
        fuzz::require(read->line > line, "cases go on along the file");
        line = read->line;
        fuzz::require(read->digits.size() >= 23 || !read->errors.empty(), "a case without errors has all digits");
        check_numbers(read->values);
        for (const auto& sentence : read->warnings) check_sentence(sentence);
        for (const auto& sentence : read->errors) check_sentence(sentence);
    }
    for (const auto& sentence : reader.warnings()) check_sentence(sentence);
    for (const auto& sentence : reader.errors()) check_sentence(sentence);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text = fuzz::bytes_of(data, size);
    try {
        if (text.starts_with('L'))
            contactd::read_contact_slices(text.substr(1), "a.slcs");
        else
            read_cases(text);
    } catch (const contactd::InvalidArgument& refusal) {
        check_sentence(refusal.what());
    }
    return 0;
}
