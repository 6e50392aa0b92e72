#include "shared_check.hpp"

#include <utility>

namespace contactd::server {

SharedCheck::SharedCheck(CallPtr call, std::function<void()> conclude)
    : call_(std::move(call)),
      conclude_(std::move(conclude)),
      members_(call_->request.method, call_->request.params),
      violated_(!members_.conforms()),
      checked_(static_cast<std::ptrdiff_t>(members_.size())) {}

bool SharedCheck::passed() {
    check_members();
    checked_.wait();
    std::call_once(concluded_, [this] { conclude(); });
    return !refused_;
}

void SharedCheck::check_members() {
    for (std::size_t index = next_++; index < members_.size(); index = next_++) {
        try {
            if (!violated_ && !members_.member_conforms(index)) violated_ = true;
        } catch (const std::exception&) {  // It does not fit into memory; check_params reports it.
            violated_ = true;
        }
        checked_.count_down();
    }
}

void SharedCheck::conclude() {
    try {
        if (violated_) proto::check_params(call_->request.method, call_->request.params);
        conclude_();
    } catch (const std::exception& error) {
        refused_ = true;
        call_->fail(status_of(error));
    }
}

}  // namespace contactd::server
