// A host without a robot: senses answer and acts do what a person or a test sets.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/posh/host.h"

namespace usar::posh {

/// Knows every name; a sense that was not set answers nil (or as the built-in of its name), an act RunningOnce. Senses
/// with arguments answer by name.
class StubHost : public Host {
public:
    void setSense(const std::string& name, Value answer) { answers_[name] = std::move(answer); }
    void setResult(const std::string& name, ActResult result) { results_[name] = result; }
    /// What is not set as a result, from here on.
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
