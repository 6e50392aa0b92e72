// Reads lines and words of input files of CONTACT.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/observer.hpp"

namespace contactd::contact_files {

struct Word {
    std::string text{};      ///< without its quotes
    std::size_t column = 0;  ///< counted from 1
    bool is_quoted = false;
    bool is_open = false;  ///< whether the second quotation mark is missing, as after an apostrophe in a remark
};

/// Limits the number of words that CONTACT reads from a line, and from a line of an array.
inline constexpr std::size_t most_words = 20, most_words_of_array = 50;

/// Iterates over the lines that contain words. A line ends after 256 characters, and % begins a comment.
class InputLines {
   public:
    /// Throws InvalidArgument, with the name of the file, for binary data and for a text that is too long. The observer
    /// may be null.
    InputLines(std::string_view text, const std::string& name, const Observer* observer = nullptr);

    /// Goes to the next line with words, and returns false at the end. Throws Cancelled if the observer requests it.
    bool next();
    /// Goes to the next line. Throws InvalidArgument at the end, where `what` is missing.
    void advance(const std::string& what);
    const std::vector<Word>& words() const { return words_; }
    std::size_t number() const { return number_; }
    /// Returns the reason why CONTACT does not read all words of this line, or null if it does.
    const char* what_is_cut() const { return what_is_cut_; }

    bool is_at_end() const { return rest_.empty() && words_.empty(); }

    /// Throws InvalidArgument with the line and column of the word.
    [[noreturn]] void fail(const Word& word, const std::string& problem) const;
    /// Throws InvalidArgument with the line.
    [[noreturn]] void fail_line(const std::string& problem) const;
    /// Returns the beginning of warnings and errors of a case, such as "line 7".
    std::string where() const { return "line " + std::to_string(number_); }

   private:
    void split(std::string_view line);

    std::string_view rest_;
    const Observer* observer_;
    std::vector<Word> words_;
    std::size_t number_ = 0;
    const char* what_is_cut_ = nullptr;
};

/// Return the value of a word, or nothing if it is invalid. An integer may end with a point and zeros. A real is
/// written as in Fortran, including exponents without their letter (.1-07), but without a repeat count. An angle is a
/// real in degrees if a d follows directly, and in radians if an r or no letter follows; 90d0 is 90 rad.
std::optional<int> integer_in(std::string_view word);
std::optional<double> real_in(std::string_view word);
std::optional<double> angle_in(std::string_view word);

}  // namespace contactd::contact_files
