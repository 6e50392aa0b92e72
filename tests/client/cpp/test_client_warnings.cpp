// Tests warnings in answers, and their receivers.
#include <catch2/catch_test_macros.hpp>

#include <iostream>
#include <sstream>

#include "contactd/client/client.hpp"
#include "fake_solver.hpp"

using namespace contactd;
using namespace contactd::client;
using fake::Frames;
using nlohmann::json;

namespace {

SolveReply warning_of(const ContactProblem& read, std::vector<std::string> of_solution,
                      std::vector<std::string> of_tables = {}) {
    SolveReply reply = fake::gap_as_pressure(read);
    reply.solution.warnings = std::move(of_solution);
    reply.ics.upper->evidence.warnings = reply.ics.lower->evidence.warnings = std::move(of_tables);
    return reply;
}

std::vector<Frames> warn(const json& request, const Frames& frames) {
    const ContactProblem read = proto::decode_problem(request["params"], frames);
    proto::ArrayWriter arrays(proto::ArrayEncoding::frame);
    const SolveReply reply =
        warning_of(read, {"It is wrong.", "It is far off."}, {"The mesh is coarse.", "It is wrong."});
    return fake::message_of(request, proto::encode_solve_reply(reply, read.grid, arrays), arrays);
}

/// The first and the last of these problems cause warnings.
std::vector<Frames> warn_of_some(const json& request, const Frames& frames) {
    std::vector<proto::ResultOrStatus> results;
    for (std::size_t i = 0; i < request["params"]["problems"].size(); ++i) {
        const ContactProblem read = proto::decode_problem(request["params"]["problems"][i], frames);
        const std::vector<std::string> warnings =
            i == 1 ? std::vector<std::string>{} : std::vector<std::string>{"It is wrong."};
        results.push_back(proto::encode_outcome(warning_of(read, warnings), read.grid, proto::ArrayEncoding::frame));
    }
    Frames arrays;
    Frames message{fake::reply(request, json::parse(proto::encode_results("solutions", std::move(results), arrays)))};
    message.insert(message.end(), arrays.begin(), arrays.end());
    return {message};
}

/// Captures standard error during its lifetime.
class Heard {
   public:
    Heard() : before_(std::cerr.rdbuf(text_.rdbuf())) {}
    ~Heard() { std::cerr.rdbuf(before_); }
    Heard(const Heard&) = delete;
    Heard& operator=(const Heard&) = delete;
    std::string text() const { return text_.str(); }

   private:
    std::ostringstream text_;
    std::streambuf* before_;
};

}  // namespace

TEST_CASE("A handler hears the warnings of an answer, once, each sentence once", "[client]") {
    fake::Daemon daemon(warn);
    std::vector<std::vector<std::string>> heard;
    ClientOptions options;
    options.on_warnings = [&](const std::vector<std::string>& sentences) { heard.push_back(sentences); };
    Client client(daemon.endpoint(), options);

    const SolveReply reply = client.solve(fake::problem());

    CHECK(heard == std::vector<std::vector<std::string>>{{"It is wrong.", "It is far off.", "The mesh is coarse."}});
    CHECK(reply.solution.warnings.size() == 2);
}

TEST_CASE("Of many problems warnings say of which they are", "[client]") {
    fake::Daemon daemon(warn_of_some);
    std::vector<std::vector<std::string>> heard;
    ClientOptions options;
    options.on_warnings = [&](const std::vector<std::string>& sentences) { heard.push_back(sentences); };
    Client client(daemon.endpoint(), options);

    client.solve_many(std::vector<ContactProblem>(3, fake::problem()));

    CHECK(heard == std::vector<std::vector<std::string>>{{"problems[0]: It is wrong.", "problems[2]: It is wrong."}});
}

TEST_CASE("Without a handler each sentence goes to standard error once", "[client]") {
    fake::Daemon daemon(warn);
    Client client(daemon.endpoint());
    const Heard heard;

    client.solve(fake::problem());
    client.solve(fake::problem());

    CHECK(
        heard.text() ==
        "contactd: warning: It is wrong.\ncontactd: warning: It is far off.\ncontactd: warning: The mesh is coarse.\n");
}

TEST_CASE("An answer without warnings says nothing", "[client]") {
    fake::Daemon daemon(fake::echo_gap);
    bool is_called = false;
    ClientOptions options;
    options.on_warnings = [&](const auto&) { is_called = true; };
    Client client(daemon.endpoint(), options), other(daemon.endpoint());
    const Heard heard;

    client.solve(fake::problem());
    other.solve(fake::problem());

    CHECK_FALSE(is_called);
    CHECK(heard.text().empty());
}
