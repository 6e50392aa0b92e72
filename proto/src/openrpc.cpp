// The OpenRPC document, made of the schemas so that the two cannot disagree.
#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>

#include "contactd/proto/schema.hpp"
#include "references.hpp"
#include "schema_texts.hpp"

namespace contactd::proto {
namespace {

using nlohmann::json;

constexpr const char* place = "#/components/schemas/";

struct Summary {
    const char* method;
    const char* text;
};
constexpr Summary summaries[]{
    {"server.info", "What the daemon is, what it allows and what it has done."},
    {"server.health", "Whether the daemon takes requests; never waits for other work."},
    {"server.describe", "This document."},
    {"server.metrics", "What is measured of the daemon: the same names and values as at /metrics."},
    {"health.watch",
     "The state of the daemon as progress, now and with each change, until the daemon ends, the deadline passes or the "
     "request is cancelled. A REQ socket, which gets no progress, is answered when the daemon ends."},
    {"ic.get", "The influence coefficients of one body; requests for the same table join one build."},
    {"ic.export",
     "The influence coefficients of one body, or of two, as a file: HDF5, or text for the CONTACT program."},
    {"ic.list", "The tables of the store, and builds in quarantine."},
    {"ic.delete", "Removes the tables of a key, and forgets that its builds failed."},
    {"contact.solve",
     "Normal contact with the approach or the force prescribed and, with friction, tangential contact: a shift or "
     "rolling."},
    {"contact.solve_many", "Many problems of contact.solve at once; one that fails does not fail the others."},
    {"contact.subsurface", "Stresses inside a body, a half-space, under the tractions of a contact."},
    {"session.open",
     "Opens a session: fixes what the steps of a simulation have in common, and waits until its tables lie ready."},
    {"session.step", "Solves the next step of a session, which starts where the last one ended."},
    {"session.info", "Tells where a session is, for a client that was handed its name."},
    {"session.save", "Keeps where a session is, for session.restore."},
    {"session.restore", "Takes a session back, or forward, to a saved state; as often as wanted."},
    {"session.forget", "Frees a saved state."},
    {"session.close", "Ends a session."},
    {"session.list", "Counts and ages of the open sessions."},
    {"job.list", "The work that waits and runs."},
    {"job.cancel", "Ends a job; everyone waiting for it gets CANCELLED."},
    {"request.cancel",
     "Ends a request that its client has sent before, whatever it is; the answer to that is CANCELLED."},
};

/// One error for each status code; `data` of a reply's status says more (components.schemas.status).
json error(StatusCode code) {
    return {{"code", static_cast<int>(code)}, {"message", name_of(code)}};
}

json errors_of(std::string_view method) {
    json errors{error(StatusCode::invalid_argument), error(StatusCode::unavailable), error(StatusCode::internal)};
    const auto add = [&](StatusCode code) { errors.push_back(error(code)); };
    const bool in_session = method.starts_with("session.") && method != "session.list";
    if (method.starts_with("contact.") || method.starts_with("ic.") || in_session || method == "health.watch") {
        add(StatusCode::cancelled);
        add(StatusCode::deadline_exceeded);
        add(StatusCode::resource_exhausted);
    }
    if (method == "job.cancel" || method == "request.cancel" || method == "ic.delete" ||
        (in_session && method != "session.open"))
        add(StatusCode::not_found);
    if (method == "session.step") {
        add(StatusCode::failed_precondition);
        add(StatusCode::aborted);
    }
    if (method == "ic.get" || method == "ic.export" || method == "contact.solve" || method == "session.open")
        add(StatusCode::failed_precondition);
    return errors;
}

/// A schema as it stands in the document: references redirected, without what belongs to a file only.
json embedded(const json& document) {
    json schema = redirected(document, place);
    schema.erase("$schema");
    return schema;
}

json params_of(const json& schema) {
    json params = json::array();
    const json required = schema.value("required", json::array());
    const json properties = schema.value("properties", json::object());
    // By-name parameters must list the required ones first.
    for (const bool wanted : {true, false})
        for (const auto& property : properties.items()) {
            const bool is_required = std::find(required.begin(), required.end(), property.key()) != required.end();
            if (is_required != wanted) continue;
            params.push_back({{"name", property.key()},
                              {"description", property.value().value("description", "")},
                              {"required", is_required},
                              {"schema", redirected(property.value(), place)}});
        }
    return params;
}

json method_of(const Summary& summary, const Documents& documents) {
    const std::string name = summary.method;
    const json& result = documents.at(name + ".result");
    return {{"name", name},
            {"summary", summary.text},
            {"paramStructure", "by-name"},
            {"params", params_of(documents.at(name + ".params"))},
            {"result",
             {{"name", name + ".result"},
              {"description", result["description"]},
              {"required", true},
              {"schema", {{"$ref", place + (name + ".result")}}}}},
            {"errors", errors_of(name)}};
}

json make_document() {
    Documents documents;
    for (const SchemaText& source : schema_texts()) documents.emplace(source.name, json::parse(source.text));
    json schemas = json::object();
    for (const auto& definition : documents.at("definitions")["definitions"].items())
        schemas[definition.key()] = redirected(definition.value(), place);
    for (const auto& [name, document] : documents)
        if (name != "definitions") schemas[name] = embedded(document);
    json methods = json::array();
    for (const Summary& summary : summaries) methods.push_back(method_of(summary, documents));
    return {{"openrpc", "1.3.2"},
            {"info",
             {{"title", "contactd"},
              {"version", CONTACTD_VERSION},
              {"description",
               "Elastic contact with computed influence coefficients. Requests and replies are ZeroMQ messages: one "
               "JSON envelope (components.schemas.envelope, progress, reply) and raw array frames behind it."}}},
            {"methods", std::move(methods)},
            {"components", {{"schemas", std::move(schemas)}}}};
}

}  // namespace

const json& openrpc() {
    static const json document = make_document();
    return document;
}

}  // namespace contactd::proto
