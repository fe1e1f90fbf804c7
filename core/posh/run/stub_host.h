// A host without a robot, whose answers and results the user or a test sets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/posh/run/host.h"

namespace usar::posh {

/// Accepts every name. A sense that was not set answers nil, or like the built-in sense of that name; an act that was
/// not set returns RunningOnce. Names ignore arguments: all calls of a sense get the same answer. Set built-in names
/// before the program is loaded into the engine.
class StubHost : public Host {
public:
    /// Sets the answer of a sense from now on.
    void setSense(const std::string& name, Value answer) { answers_[name] = std::move(answer); }
    /// Sets the result of an act from now on.
    void setResult(const std::string& name, ActResult result) { results_[name] = result; }
    /// Returns all acts to RunningOnce.
    void clearResults() { results_.clear(); }

    bool hasSense(std::string_view name) const override { return answers_.contains(name); }
    bool hasAct(std::string_view name) const override { return results_.contains(name); }
    void bind(const Program& program) override { program_ = &program; }
    void sense(CallSite site, Value& answer) override;
    void init(CallSite) override {}
    ActResult run(CallSite site) override;
    void done(CallSite, DoneReason) override {}

protected:
    const Program& program() const { return *program_; }

private:
    const Program* program_ = nullptr;
    std::map<std::string, Value, std::less<>> answers_;
    std::map<std::string, ActResult, std::less<>> results_;
};

} // namespace usar::posh
