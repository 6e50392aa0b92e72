// `conicity` and `contacts` of wheelrail.geometry, of which the request holds the set-up, too.
#pragma once

#include <nlohmann/json.hpp>

#include "contactd/conicity.hpp"

namespace contactd::proto {

nlohmann::json encode_conicity(const ConicityRequest& wanted);
nlohmann::json encode_contacts_request(const ContactsRequest& wanted);

}  // namespace contactd::proto
