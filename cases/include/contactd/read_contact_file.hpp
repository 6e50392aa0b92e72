// Reads the cases of input files of the CONTACT program.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "contactd/by_name.hpp"
#include "contactd/observer.hpp"

namespace contactd {

/// Limits the size of an input file of CONTACT.
inline constexpr std::size_t most_contact_file_bytes = 16 << 20;

/// Largest number of cases read at once.
inline constexpr std::size_t most_contact_cases = 100'000;

/// Holds numbers that several cases may share.
using ContactNumbers = std::shared_ptr<const std::vector<double>>;
using ContactValue = std::variant<int, double, std::string, ContactNumbers>;
/// Holds the values of a friction law, preceded by ALPHVF, SVF or IY if friction varies.
using ContactFrictionSets = std::vector<ByName<double>>;
/// Holds blocks of points below the surface: ISUBS, and lists by the names of their axes.
using ContactBlocks = std::vector<ByName<ContactValue>>;

/// Holds one case as in CONTACT: its control digits, and all values in its memory. Names are those of CONTACT; other
/// names are defined in docs/contact-files.md. Units are CONTACT's: mm, N, s, rad, N/mm^2.
struct ContactCase {
    int number = 0;                 ///< number printed by CONTACT, counted from 1 in each result element
    std::size_t line = 0;           ///< line of its first control word, counted from 1
    int module_number = 0;          ///< 1, a wheel on its rail, or 3, basic contact
    std::optional<int> reid, cpid;  ///< result element and contact problem, if named in the file
    ByName<int> digits;             ///< C1 (module 1) P B T N F S, V L D C M Z E M2 W2, X H G I A O W R
    ByName<ContactValue> values;
    std::shared_ptr<const ContactFrictionSets> friction;  ///< null where none was ever read
    std::shared_ptr<const ContactBlocks> subsurface;      ///< null where none was ever read
    std::vector<std::string> read;      ///< values read in this case; the others are kept from earlier ones
    std::vector<std::string> warnings;  ///< probable mistakes
    std::vector<std::string> errors;    ///< reasons why it cannot be computed; it may be incomplete
};

/// Reads one case after the other, so that a long history need not fit in memory. After an invalid word it continues
/// at the next line that begins with a number and the word MODULE. Cases that keep data of the skipped case have an
/// error.
class ContactFileReader {
   public:
    /// `name` is that of the file, for messages. `text` and the observer, which may be null, must live as long as the
    /// reader. Throws InvalidArgument for a text longer than most_contact_file_bytes, and for binary data.
    ContactFileReader(std::string_view text, const std::string& name, const Observer* observer = nullptr);
    ~ContactFileReader();
    ContactFileReader(const ContactFileReader&) = delete;
    ContactFileReader& operator=(const ContactFileReader&) = delete;

    /// Returns the next case, or nothing at the end. Throws Cancelled.
    std::optional<ContactCase> next();
    /// Return the warnings and errors so far that do not belong to a case.
    const std::vector<std::string>& warnings() const;
    const std::vector<std::string>& errors() const;

   private:
    struct State;
    std::unique_ptr<State> state_;
};

struct ContactFile {
    std::vector<ContactCase> cases;
    std::vector<std::string> warnings, errors;
};

/// Returns all cases of a file at once. Throws the same errors as ContactFileReader, and InvalidArgument for more than
/// most_contact_cases.
ContactFile read_contact_file(std::string_view text, const std::string& name);

}  // namespace contactd
