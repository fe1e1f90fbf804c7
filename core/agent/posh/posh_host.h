// Provides the senses and acts of a registry, applied to one body, to a plan.
#pragma once

#include <memory>
#include <vector>

#include "core/agent/posh_registry.h"
#include "core/posh/run/host.h"

namespace usar::agent {

/// Creates all acts and converts all arguments when a program is bound. A call that does not fit (see checkBinding)
/// throws each time it is made, and the engine reports it with its place.
class PoshHost final : public posh::Host {
public:
    /// Both must outlive this object; the registry must not change.
    PoshHost(const PoshRegistry& registry, PoshBody& body) : registry_(registry), body_(body) {}

    /// See posh::Host. The place of each call is noted in the body first, for the causes of its commands.
    bool hasSense(std::string_view name) const override;
    bool hasAct(std::string_view name) const override;
    void bind(const posh::Program& program) override;
    void sense(posh::CallSite site, posh::Value& answer) override;
    void init(posh::CallSite site) override;
    posh::ActResult run(posh::CallSite site) override;
    void done(posh::CallSite site, posh::DoneReason reason) override;

private:
    /// A call in the plan with its converted arguments.
    struct BoundCall {
        const PoshPrimitive* primitive = nullptr;
        PoshArguments arguments;
        std::unique_ptr<PoshAct> act;
        std::string refusal; ///< the reason if the call does not fit, else empty
    };
    BoundCall boundTo(const posh::ProgramCall& call) const;
    /// Throws if the call does not fit.
    BoundCall& at(std::vector<BoundCall>& calls, posh::CallSite site);

    const PoshRegistry& registry_;
    PoshBody& body_;
    std::vector<BoundCall> senses_;
    std::vector<BoundCall> acts_;
};

} // namespace usar::agent
