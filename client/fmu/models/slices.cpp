#include "slices.hpp"

#include <array>
#include <fstream>
#include <optional>
#include <sstream>

#include "place.hpp"
#include "set_up.hpp"

namespace contactd::fmu {

void set_profile_file(contactd_wheel* w, const std::string& profile, const std::filesystem::path& path,
                      const FileReading& reading) {
    const std::string file = profile + ".file";
    check(contactd_read_profile(w, file.c_str(), path.string().c_str()), w);
    if (reading.unit != 0) set_field(w, file + ".unit", reading.unit);
    set_field(w, file + ".mirror_y", reading.mirror_y ? 1 : 0);
    if (reading.mirror_z != "by_shape") set_field(w, file + ".mirror_z", reading.mirror_z == "turned" ? 1 : 0);
    set_field(w, file + ".shift_y", reading.shift_y);
    set_field(w, file + ".shift_z", reading.shift_z);
    set_field(w, file + ".smoothing_length", reading.smoothing_length);
}

void set_slices(contactd_wheel* w, const Slices& slices, const std::string& variable, const std::string& name,
                const FileReading& reading, const std::filesystem::path& resources) {
    const auto list = file_named(name, resources);
    if (!list) throw Failure(variable + " is \"" + name + "\", which is not a file; it must name a list of slices.");
    std::ifstream file(*list);
    std::size_t count = 0, number = 0;
    std::array<char, 4096> text{};  // limit of one line, because a device may never end it
    while (file.getline(text.data(), text.size())) {
        ++number;
        const std::string line = text.data();
        if (lowercase_name(line).empty()) continue;
        std::istringstream entry(line);
        double place = 0;
        std::string profile;
        if (!(entry >> place) || !std::getline(entry, profile))
            throw Failure(variable + ": line " + std::to_string(number) + " of " + list->string() +
                          " must have a number and the file of a profile.");
        // A list in the FMU may name other files of the FMU, also outside its folder.
        const bool is_of_fmu = lies_within(*list, resources);
        std::optional<std::filesystem::path> found =
            file_named(profile, list->parent_path(), is_of_fmu ? resources : list->parent_path());
        if (!found) found = file_named(profile, resources);
        if (found && is_of_fmu && !lies_within(*found, resources))
            throw Failure(variable + ": line " + std::to_string(number) + " of " + list->string() +
                          " names a profile outside of the FMU's resources:" + profile);
        if (!found)
            throw Failure(variable + ": line " + std::to_string(number) + " of " + list->string() +
                          " names a profile that is not a file:" + profile);
        const std::string slice = slices.path + "[" + std::to_string(count++) + "].";
        set_field(w, slice + slices.column, place);
        set_profile_file(w, slice + "profile", *found, reading);
    }
    if (!file.eof())
        throw Failure(variable + ": line " + std::to_string(number + 1) + " of " + list->string() +
                      " cannot be read, or is longer than any.");
}

}  // namespace contactd::fmu
