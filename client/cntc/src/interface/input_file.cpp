// Reads an input file of the CONTACT program into the contact problems of a result element.
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>

#include "contactd/read_contact_file.hpp"
#include "given/file_values.hpp"
#include "interface/entry.hpp"

using namespace contactd::cntc;

namespace {

using FileCase = contactd::ContactCase;

std::string text_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    std::string text;
    constexpr std::size_t piece = 1 << 16;
    while (file && text.size() <= contactd::most_contact_file_bytes) {  // the reader refuses longer files
        const std::size_t size = text.size();
        text.resize(size + piece);
        file.read(text.data() + size, piece);
        text.resize(size + static_cast<std::size_t>(file.gcount()));
    }
    if (!file.eof() && text.size() <= contactd::most_contact_file_bytes)
        throw Refused(error_code::input, "The file \"" + name + "\" cannot be read.");
    return text;
}

void check(const FileCase& read, bool on_rails, const std::string& where) {
    if (!read.errors.empty()) throw Refused(error_code::input, where + read.errors.front() + ".");
    const int module = on_rails ? module_number::wheel_rail : module_number::basic_contact;
    if (read.module_number != module)
        throw Refused(error_code::input, where + "The case in line " + std::to_string(read.line) + " is of module " +
                                             std::to_string(read.module_number) +
                                             ", but the result element was initialized for module " +
                                             std::to_string(module) + ".");
}

/// Returns the cases of this result element, or those that name no result element: one for each problem, or one for a
/// wheel on a rail.
std::map<int, FileCase> cases_of(const std::string& name, int ire, bool on_rails) {
    const std::string text = text_of(name), where = "In the file \"" + name + "\": ";
    contactd::ContactFileReader reader(text, name);
    std::map<int, FileCase> cases;
    while (const auto read = reader.next()) {
        if (read->reid.value_or(ire) != ire) continue;
        check(*read, on_rails, where);
        if (!cases.emplace(on_rails ? 1 : read->cpid.value_or(1), *read).second)
            throw Refused(error_code::input,
                          where + "A second case begins in line " + std::to_string(read->line) +
                              ", but a contact problem takes one case at a time. Write each case to a separate file.");
    }
    if (!reader.errors().empty()) throw Refused(error_code::input, where + reader.errors().front() + ".");
    if (cases.empty())
        throw Refused(error_code::input, where + "There is no case for result element " + std::to_string(ire) + ".");
    return cases;
}

/// Returns whether files cannot contain the setting, which is identified by its name in refusals.
bool outside_files(const std::string& part) {
    for (const int code : {flag::units, flag::result, flag::sensitivities})
        if (part == "flag " + std::to_string(code)) return true;
    return false;
}

/// Applies a case by `set(settings)`. If that throws, nothing changes, and nothing is solved until a file is read
/// successfully.
template <class Given, class Set>
void set_whole(Given& settings, const Set& set) {
    set_part(settings, "input file", [&](Given& all) {
        Given changed = all;
        set(changed);
        std::erase_if(changed.refused, [](const auto& refused) { return !outside_files(refused.first); });
        all = std::move(changed);
    });
}

void take_blocks(Settings& settings, const FileCase& read) {
    if (read.digits.at("S") == 0) return;
    settings.blocks.clear();
    for (GivenBlock& block : blocks_of(read)) settings.blocks.emplace(settings.blocks.size() + 1, std::move(block));
}

void set_basic(int ire, int icp, const FileCase& read, const NamedFiles& files) {
    for_each_settings(&ire, &icp, [&](Settings& settings) {
        set_whole(settings, [&](Settings& all) {
            set_basic_case(all, read, files);
            take_blocks(all, read);
        });
    });
}

void set_on_rails(int ire, const FileCase& read, const NamedFiles& files) {
    const auto [rail, common] = Registry::of_process().rail(ire);
    {
        const std::scoped_lock lock(rail->mutex, common->mutex);
        set_whole(common->settings, [&](Settings& all) {
            set_whole(rail->settings, [&](RailSettings& own) { set_rail_case(all, own, read, files); });
        });
    }
    int all = all_problems;
    for_each_settings(&ire, &all, [&](Settings& settings) { take_blocks(settings, read); });
}

}  // namespace

/// All kinds of files (`itype`) are read as input files.
extern "C" void cntc_readinpfile(int* ire, int*, const char* name, int* len_name, int* ierror) {
    const int code = answer("cntc_readinpfile", [&] {
        require(ierror, "ierror");
        require(name, "name");
        const int length = integer(len_name, "len_name"), element = number_of(ire);
        if (length < 1) throw Refused(error_code::input, "The name of the file is empty.");
        const std::string file(name, static_cast<std::size_t>(length));
        const FilesInFolder files(std::filesystem::path(file).parent_path());
        const bool on_rails = of_rail(ire);
        for (const auto& [icp, read] : cases_of(file, element, on_rails)) {
            if (on_rails)
                set_on_rails(element, read, files);
            else
                set_basic(element, icp, read, files);
            for (const std::string& sentence : read.warnings) warn("In the file \"" + file + "\": " + sentence + ".");
        }
    });
    if (ierror != nullptr) *ierror = code;
}
CONTACTD_FORTRAN_NAME(cntc_readinpfile)
