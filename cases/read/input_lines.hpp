// Lines and words of input files of CONTACT.
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
    bool is_open = false;  ///< whether the second quotation mark is missing, as of an apostrophe in a remark
};

/// As many words as CONTACT reads of a line, and of a line of an array.
inline constexpr std::size_t most_words = 20, most_words_of_array = 50;

/// The lines that have words, one after the other. A line ends after 256 characters; % begins a comment.
class InputLines {
   public:
    /// Throws InvalidArgument, which names the file, for a text that is too long, or none. The observer may be null.
    InputLines(std::string_view text, const std::string& name, const Observer* observer = nullptr);

    /// Goes to the next line that has words, and returns false at the end. Asks the observer now and then, and throws
    /// Cancelled.
    bool next();
    /// Goes to the next line, and throws InvalidArgument at the end: `what` should follow.
    void advance(const std::string& what);
    const std::vector<Word>& words() const { return words_; }
    std::size_t number() const { return number_; }
    /// Says why CONTACT does not see all words of this line; null if it does.
    const char* what_is_cut() const { return what_is_cut_; }

    bool is_at_end() const { return rest_.empty() && words_.empty(); }

    /// Throws InvalidArgument that names line and column of the word.
    [[noreturn]] void fail(const Word& word, const std::string& problem) const;
    /// Throws as fail does, and names the line.
    [[noreturn]] void fail_line(const std::string& problem) const;
    /// "line 7": how warnings and errors of a case begin.
    std::string where() const { return "line " + std::to_string(number_); }

   private:
    void split(std::string_view line);

    std::string_view rest_;
    const Observer* observer_;
    std::vector<Word> words_;
    std::size_t number_ = 0;
    const char* what_is_cut_ = nullptr;
};

/// What words stand for; nothing where one is none. An integer may have a point and zeros behind it. A real is written
/// as in Fortran, also with an exponent without its letter (.1-07), and has no repeat count. An angle is a real, in
/// degrees with a d directly behind it, in radians with an r or without a letter; 90d0 is 90 rad.
std::optional<int> integer_in(std::string_view word);
std::optional<double> real_in(std::string_view word);
std::optional<double> angle_in(std::string_view word);

}  // namespace contactd::contact_files
