#include "core/posh/run/stub_host.h"

namespace usar::posh {

void StubHost::sense(CallSite site, Value& answer) {
    if (const auto set = answers_.find(program_->sense_calls[site.call].name); set != answers_.end())
        answer = set->second;
}

ActResult StubHost::run(CallSite site) {
    const auto set = results_.find(program_->act_calls[site.call].name);
    return set == results_.end() ? ActResult::RunningOnce : set->second;
}

} // namespace usar::posh
