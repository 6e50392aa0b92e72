// Encodes the messages of contact_file.* (docs/contact-files.md).
#pragma once

#include <cstddef>

#include <nlohmann/json.hpp>

#include "contactd/contact_file_run.hpp"
#include "contactd/proto/message.hpp"
#include "contactd/read_contact_file.hpp"
#include "contactd/read_contact_slices.hpp"

namespace contactd::proto {

nlohmann::json encode_contact_case(const ContactCase& read);
/// Returns the count of numbers in the message of a case.
std::size_t numbers_of(const ContactCase& read);

/// Returns the params of contact_file.run and contact_file.convert.
nlohmann::json encode_contact_file_input(const ContactFileInput& input);
/// `params` have passed their schema. Throws InvalidArgument ("cases") for indices that do not ascend.
ContactFileInput decode_contact_file_input(const nlohmann::json& params);

/// Returns a case as params of contact.solve or wheelrail.solve.
nlohmann::json encode_contact_problem(const ContactFileProblem& converted, ArrayWriter& arrays);
ContactFileProblem decode_contact_problem(const nlohmann::json& encoded, const Frames& frames);

/// Returns a case after a run, with these arrays of its solutions, and those of its patches if they are requested.
nlohmann::json encode_contact_outcome(const ContactFileOutcome& outcome, const SolutionFields& fields,
                                      bool patch_arrays, ArrayWriter& arrays);
ContactFileOutcome decode_contact_outcome(const nlohmann::json& encoded, const Frames& frames);

nlohmann::json encode_contact_slices(const ContactSlices& read);

}  // namespace contactd::proto
