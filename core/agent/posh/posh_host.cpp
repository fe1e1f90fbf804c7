#include "core/agent/posh/posh_host.h"

#include <stdexcept>

namespace usar::agent {

bool PoshHost::hasSense(std::string_view name) const {
    const PoshPrimitive* const primitive = registry_.find(name);
    return primitive && primitive->sense;
}

bool PoshHost::hasAct(std::string_view name) const {
    const PoshPrimitive* const primitive = registry_.find(name);
    return primitive && primitive->make_act;
}

void PoshHost::bind(const posh::Program& program) {
    senses_.clear();
    acts_.clear();
    for (const posh::ProgramCall& call : program.sense_calls) {
        BoundCall& bound = senses_.emplace_back(boundTo(call));
        if (bound.refusal.empty() && !bound.primitive->sense)
            bound.refusal = call.name + " is no sense";
    }
    for (const posh::ProgramCall& call : program.act_calls) {
        BoundCall& bound = acts_.emplace_back(boundTo(call));
        if (bound.refusal.empty() && bound.primitive->make_act)
            bound.act = bound.primitive->make_act();
        else if (bound.refusal.empty())
            bound.refusal = call.name + " is no act";
    }
}

PoshHost::BoundCall PoshHost::boundTo(const posh::ProgramCall& call) const {
    BoundCall bound;
    bound.primitive = registry_.find(call.name);
    if (!bound.primitive) {
        bound.refusal = "the robot has no " + call.name;
        return bound;
    }
    auto arguments = PoshArguments::make(bound.primitive->description, call.arguments);
    if (arguments)
        bound.arguments = *std::move(arguments);
    else
        bound.refusal = arguments.error();
    return bound;
}

PoshHost::BoundCall& PoshHost::at(std::vector<BoundCall>& calls, posh::CallSite site) {
    body_.place_ = site.place;
    BoundCall& bound = calls[site.call];
    if (!bound.refusal.empty())
        throw std::runtime_error(bound.refusal);
    return bound;
}

void PoshHost::sense(posh::CallSite site, posh::Value& answer) {
    const BoundCall& bound = at(senses_, site);
    bound.primitive->sense(body_, bound.arguments, answer);
}

void PoshHost::init(posh::CallSite site) {
    BoundCall& bound = at(acts_, site);
    bound.act->init(body_, bound.arguments);
}

posh::ActResult PoshHost::run(posh::CallSite site) {
    BoundCall& bound = at(acts_, site);
    return bound.act->run(body_, bound.arguments);
}

void PoshHost::done(posh::CallSite site, posh::DoneReason reason) {
    BoundCall& bound = acts_[site.call];
    body_.place_ = site.place;
    if (bound.refusal.empty())
        bound.act->done(body_, bound.arguments, reason);
}

} // namespace usar::agent
