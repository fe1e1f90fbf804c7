// A host for plans without a robot, whose answers and results the test sets.
#pragma once

#include <map>
#include <string>

#include "core/posh/run/host.h"

namespace usar::test {

/// Accepts every name. A sense that was not set answers nil, or like the built-in sense of that name; an act that was
/// not set returns RunningOnce. Names ignore arguments: all calls of a sense get the same answer. Set built-in names
/// before the program is loaded into the engine.
class StubHost : public posh::Host {
public:
    /// Sets the answer of a sense from now on.
    void setSense(const std::string& name, posh::Value answer) { answers_[name] = std::move(answer); }
    /// Sets the result of an act from now on.
    void setResult(const std::string& name, posh::ActResult result) { results_[name] = result; }
    /// Returns all acts to RunningOnce.
    void clearResults() { results_.clear(); }

    bool hasSense(std::string_view name) const override { return answers_.contains(name); }
    bool hasAct(std::string_view name) const override { return results_.contains(name); }
    void bind(const posh::Program& program) override { program_ = &program; }
    void sense(posh::CallSite site, posh::Value& answer) override {
        if (const auto set = answers_.find(program_->sense_calls[site.call].name); set != answers_.end())
            answer = set->second;
    }
    void init(posh::CallSite) override {}
    posh::ActResult run(posh::CallSite site) override {
        const auto set = results_.find(program_->act_calls[site.call].name);
        return set == results_.end() ? posh::ActResult::RunningOnce : set->second;
    }
    void done(posh::CallSite, posh::DoneReason) override {}

protected:
    const posh::Program& program() const { return *program_; }

private:
    const posh::Program* program_ = nullptr;
    std::map<std::string, posh::Value, std::less<>> answers_;
    std::map<std::string, posh::ActResult, std::less<>> results_;
};

} // namespace usar::test
