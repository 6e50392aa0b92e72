// Paths to a value by its names on the wire, such as "setup.track.springs.y" or "patches[0].forces.track.Fz".
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "contactd/fields.hpp"

namespace contactd {

/// The path from a struct to a value below it. Making one reads its text; walking it does not.
class FieldPath {
   public:
    /// Throws InvalidArgument with the text for its field where it leads nowhere, and says what there is instead.
    FieldPath(const FieldType& root, std::string text);

    /// The value below `root`; null where an optional on the way, or an entry of a list, is not there.
    const void* find(const void* root) const;
    /// The value below `root`, to be written to. Optionals on the way get their defaults where they are absent, and a
    /// list gets its next entry where that is named. Throws InvalidArgument for entries beyond that.
    void* make(void* root) const;
    /// Makes the last field absent, or an empty list. Throws InvalidArgument where it is always there.
    void clear(void* root) const;

    const std::string& text() const { return text_; }
    const FieldType& type() const { return *type_; }             ///< of the value
    const Field& field() const { return *steps_.back().field; }  ///< the last one on the way

   private:
    struct Step {
        const Field* field;
        std::optional<std::size_t> index;  ///< of an entry, where the field is a list
    };

    std::string text_;
    std::vector<Step> steps_;
    const FieldType* type_;
};

/// Writes a number to what the path leads to: of a flag 0 or 1, of an integer a whole number. Throws InvalidArgument
/// for other kinds, and for numbers out of the field's bounds.
void set_number(const FieldPath& path, void* root, double value);
/// Writes a keyword or a text. Throws InvalidArgument naming the keywords that there are.
void set_text(const FieldPath& path, void* root, std::string_view text);
/// The number, integer, flag (0 or 1) or length of a list that the path leads to; absent where it is not there. Throws
/// InvalidArgument for other kinds.
std::optional<double> number_at(const FieldPath& path, const void* root);
/// The keyword or text.
std::optional<std::string> text_at(const FieldPath& path, const void* root);

}  // namespace contactd
