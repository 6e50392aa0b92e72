// Groups of values, which CONTACT reads at once from one or more lines.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/read_contact_file.hpp"
#include "input_lines.hpp"

namespace contactd::contact_files {

/// A case during reading.
struct Reading {
    InputLines& lines;
    ContactCase& result;

    int digit(std::string_view name) const;
    /// Return a value in memory, or 0 if there is none.
    int integer(std::string_view name) const;
    double real(std::string_view name) const;
    bool has(std::string_view name) const { return result.values.contains(name); }

    void set(std::string_view name, ContactValue value);
    /// Removes values from memory. `names` are separated by blanks.
    void forget(std::string_view names);
    /// Stores a value that was read in this case.
    void take(std::string_view name, ContactValue value);
    /// Add a warning, or an error that prevents computing the case. The current line is put in front.
    void warn(const std::string& sentence);
    void fail_case(const std::string& sentence);
};

/// Reads the values of a group, starting at the next line. The rest of the last line is ignored. `group` contains the
/// names, separated by blanks. They are reals, or
///     NAME#           an integer
///     NAME^           an angle
///     NAME'           a text in quotation marks
///     {NAME=1 ..}     optional values at the end of the last line, with their defaults, or absent without a default
///     {+NAME=1 ..}    the same, but they are only used if all are present
/// Throws InvalidArgument for an invalid word.
ByName<ContactValue> read_values(Reading& reading, std::string_view group);
/// Reads the values of a group and stores them in the memory of the case.
void read_group(Reading& reading, std::string_view group);

/// Reads `count` numbers in any layout of lines, and ignores the rest of the last line. `what` is their name in
/// messages. `kinds` contains their kinds, repeated: blanks for reals, # and ^ as in a group.
std::vector<double> read_array(Reading& reading, std::string_view what, std::size_t count,
                               std::string_view kinds = " ");

/// Returns one of several columns of an array that is stored by rows.
std::vector<double> column_of(const std::vector<double>& array, std::size_t column, std::size_t columns);
ContactNumbers shared(std::vector<double> numbers);

}  // namespace contactd::contact_files
